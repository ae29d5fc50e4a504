//! Distributions of a varied value, by their quantiles.

use std::f64::consts::SQRT_2;

use statrs::function::erf::erfc_inv;

/// The distribution of a varied value, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distribution {
    /// Uniform between two ends.
    Uniform {
        /// The lower end.
        from: f64,
        /// The upper end.
        to: f64,
    },
    /// Its logarithm is uniform between those of two ends.
    LogUniform {
        /// The lower end, positive.
        from: f64,
        /// The upper end.
        to: f64,
    },
    /// Normal.
    Normal {
        /// The mean.
        mean: f64,
        /// The standard deviation.
        standard_deviation: f64,
    },
    /// Its logarithm is normal.
    Lognormal {
        /// The mean of the value itself, positive.
        mean: f64,
        /// The standard deviation of the value itself.
        standard_deviation: f64,
    },
}

impl Distribution {
    /// The value below which the share `u` of all values lies, `0 <= u <= 1`; at the ends themselves the two that have no end are infinite.
    #[must_use]
    pub fn quantile(&self, u: f64) -> f64 {
        match *self {
            Self::Uniform { from, to } => from + (to - from) * u,
            Self::LogUniform { from, to } => (from.ln() + (to / from).ln() * u).exp(),
            Self::Normal { mean, standard_deviation } => mean + standard_deviation * normal(u),
            Self::Lognormal { mean, standard_deviation } => {
                // Of the logarithm: variance s^2 = ln(1 + (sd/mean)^2), mean ln(mean) - s^2/2.
                let variance = (standard_deviation / mean).powi(2).ln_1p();
                mean * (variance.sqrt() * normal(u) - 0.5 * variance).exp()
            }
        }
    }
}

/// The quantile of the normal distribution with mean 0 and standard deviation 1.
fn normal(u: f64) -> f64 {
    -SQRT_2 * erfc_inv(2.0 * u)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_the_normal_distribution_agree_with_tables() {
        // mpmath, 16 digits.
        for (u, exact) in [
            (0.5, 0.0),
            (0.975, 1.959_963_984_540_054),
            (0.001, -3.090_232_306_167_813_5),
            (0.841_344_746_068_542_9, 1.0),
            (1e-9, -5.997_807_015_007_686),
        ] {
            let found = normal(u);
            assert!((found - exact).abs() < 1e-13 * (1.0 + exact.abs()), "{u}: {found} {exact}");
        }
    }

    #[test]
    fn a_lognormal_value_has_its_own_mean_and_deviation() {
        let found = Distribution::Lognormal { mean: 2.0, standard_deviation: 0.5 };
        let count = 200_000;
        let values: Vec<f64> =
            (0..count).map(|i| found.quantile((f64::from(i) + 0.5) / f64::from(count))).collect();
        let mean = values.iter().sum::<f64>() / f64::from(count);
        let variance =
            values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / f64::from(count);
        assert!((mean - 2.0).abs() < 1e-4 && (variance.sqrt() - 0.5).abs() < 1e-3);
    }
}
