//! Laws of the layer fitted to pairs of pressure and approach.

use crate::error::require;
use crate::{Error, Roughness};

/// A fitted law, and how far it is from what it was fitted to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fit {
    /// `v = chi p` or `v = B p^kappa`.
    pub roughness: Roughness,
    /// What the data's approach is ahead of the law's (m): `approach = v + offset`; zero where the approach is counted from first touch.
    pub offset: f64,
    /// Smallest and largest pressure of the data (Pa).
    pub pressures: [f64; 2],
    /// Smallest and largest approach of the data (m).
    pub approaches: [f64; 2],
    /// Share of the variance of the approach that the law explains, `1 - sum (v - v_fit)^2/sum (v - mean v)^2`; negative for a law worse than a constant.
    pub r_squared: f64,
    /// Largest distance of the law from an approach of the data (m).
    pub largest_deviation: f64,
    /// The pressure at which it is (Pa).
    pub deviates_at: f64,
}

impl Fit {
    /// The largest deviation over the range of the approaches.
    #[must_use]
    pub fn relative_deviation(&self) -> f64 {
        let [least, most] = self.approaches;
        self.largest_deviation / (most - least)
    }

    /// The law `roughness` with `offset`, compared with the data.
    fn of(roughness: Roughness, offset: f64, data: &[[f64; 2]]) -> Result<Self, Error> {
        let roughness = checked(roughness)?;
        let law = |pressure: f64| roughness.displacement(pressure) + offset;
        let mean = data.iter().map(|[_, v]| v).sum::<f64>() / data.len() as f64;
        let square = |value: f64| value * value;
        let left: f64 = data.iter().map(|[p, v]| square(v - law(*p))).sum();
        let whole: f64 = data.iter().map(|[_, v]| square(v - mean)).sum();
        let (deviates_at, largest_deviation) = (data.iter())
            .map(|[p, v]| (*p, (v - law(*p)).abs()))
            .fold((data[0][0], 0.0), |most, next| if next.1 > most.1 { next } else { most });
        let range = |index: usize| {
            let values = || data.iter().map(|pair| pair[index]);
            [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
        };
        Ok(Self {
            roughness,
            offset,
            pressures: range(0),
            approaches: range(1),
            r_squared: 1.0 - left / whole,
            largest_deviation,
            deviates_at,
        })
    }
}

/// `chi` of `v = chi p` through the origin by least squares of the approach; data are pairs of pressure (Pa) and approach (m).
pub(super) fn proportional(data: &[[f64; 2]]) -> Result<Fit, Error> {
    let scale = scale(data);
    let (mut products, mut squares) = (0.0, 0.0);
    for [p, v] in data.iter().map(|[p, v]| [p / scale[0], v / scale[1]]) {
        products += p * v;
        squares += p * p;
    }
    let compliance = products / squares * (scale[1] / scale[0]);
    Fit::of(Roughness::Linear { compliance }, 0.0, data)
}

/// `B` and `kappa` of `v = B p^kappa` by least squares of the logarithms; pressures and approaches are positive.
pub(super) fn power(data: &[[f64; 2]]) -> Result<Fit, Error> {
    let logarithms: Vec<[f64; 2]> = data.iter().map(|pair| pair.map(f64::ln)).collect();
    let [exponent, constant] = line(&logarithms);
    // An exponent that is one but for rounding is one.
    const ROUNDING: f64 = 1e-12;
    let exponent = if (exponent - 1.0).abs() < ROUNDING { 1.0 } else { exponent };
    Fit::of(Roughness::power(constant.exp(), exponent)?, 0.0, data)
}

/// `v = chi p + offset` by least squares.
pub(super) fn linear_with_offset(data: &[[f64; 2]]) -> Result<Fit, Error> {
    let [compliance, offset] = line_of_power(data, 1.0);
    Fit::of(Roughness::Linear { compliance }, offset, data)
}

/// `v = B p^kappa + offset` by least squares, `kappa` from [`LEAST_EXPONENT`] to 1.
pub(super) fn power_with_offset(data: &[[f64; 2]]) -> Result<Fit, Error> {
    let misfit = |exponent: f64| {
        let [coefficient, offset] = line_of_power(data, exponent);
        data.iter().map(|[p, v]| (coefficient * p.powf(exponent) + offset - v).powi(2)).sum::<f64>()
    };
    let exponent = minimum(misfit);
    require(
        exponent > LEAST_EXPONENT * 1.001,
        "exponent",
        exponent,
        "greater than 0.01: over this range the approach follows the logarithm of the pressure, and no power; take a narrower range or a linear law",
    )?;
    let [coefficient, offset] = line_of_power(data, exponent);
    Fit::of(Roughness::power(coefficient, exponent)?, offset, data)
}

/// The least exponent of a fit with an offset: below it a power cannot be told from a logarithm.
const LEAST_EXPONENT: f64 = 0.01;

/// The minimum on `[LEAST_EXPONENT, 1]`: the best of a scan, then golden section beside it.
fn minimum(f: impl Fn(f64) -> f64) -> f64 {
    const SCAN: usize = 100;
    const SECTIONS: usize = 60;
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    let at = |i: usize| LEAST_EXPONENT + (1.0 - LEAST_EXPONENT) * i as f64 / SCAN as f64;
    let best = (0..=SCAN).min_by(|i, j| f(at(*i)).total_cmp(&f(at(*j)))).unwrap_or(0);
    let [mut low, mut high] = [at(best.saturating_sub(1)), at((best + 1).min(SCAN))];
    for _ in 0..SECTIONS {
        let [left, right] = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        if f(left) <= f(right) {
            high = right;
        } else {
            low = left;
        }
    }
    // Where the end of the range is the best the section only comes near it.
    [low, 0.5 * (low + high), high]
        .into_iter()
        .min_by(|x, y| f(*x).total_cmp(&f(*y)))
        .unwrap_or(low)
}

/// Slope and intercept of `v` over `p^exponent`.
fn line_of_power(data: &[[f64; 2]], exponent: f64) -> [f64; 2] {
    let pairs: Vec<[f64; 2]> = data.iter().map(|[p, v]| [p.powf(exponent), *v]).collect();
    line(&pairs)
}

/// Slope and intercept of the straight line of least squares.
pub(super) fn line(pairs: &[[f64; 2]]) -> [f64; 2] {
    let count = pairs.len() as f64;
    let mean = |index: usize| pairs.iter().map(|pair| pair[index]).sum::<f64>() / count;
    let (x0, y0) = (mean(0), mean(1));
    let (scale_x, scale_y) = (extent(pairs, 0, x0), extent(pairs, 1, y0));
    let (mut products, mut squares) = (0.0, 0.0);
    for [x, y] in pairs {
        let (dx, dy) = ((x - x0) / scale_x, (y - y0) / scale_y);
        products += dx * dy;
        squares += dx * dx;
    }
    let slope = products / squares * (scale_y / scale_x);
    [slope, y0 - slope * x0]
}

/// Largest distance from the mean, 1 where that is none: squares of what it scales stay in range.
fn extent(pairs: &[[f64; 2]], index: usize, mean: f64) -> f64 {
    let most = pairs.iter().map(|pair| (pair[index] - mean).abs()).fold(0.0, f64::max);
    if most > 0.0 { most } else { 1.0 }
}

fn scale(data: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|index| extent(data, index, 0.0))
}

fn checked(roughness: Roughness) -> Result<Roughness, Error> {
    match roughness {
        Roughness::Linear { compliance } => {
            let requirement =
                "finite and greater than zero: the approach must grow with the pressure";
            let holds = compliance.is_finite() && compliance > 0.0;
            require(holds, "compliance", compliance, requirement)?;
            Ok(roughness)
        }
        other => Ok(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pressures() -> impl Iterator<Item = f64> {
        (1..=40).map(|i| 2e6 * f64::from(i))
    }

    #[test]
    fn laws_are_found_again() {
        let (chi, b, kappa, offset) = (3e-14, 2e-9, 0.37, -4e-6);
        let of = |law: &dyn Fn(f64) -> f64| -> Vec<[f64; 2]> {
            pressures().map(|p| [p, law(p)]).collect()
        };
        let linear = proportional(&of(&|p| chi * p)).unwrap();
        let Roughness::Linear { compliance } = linear.roughness else { panic!() };
        assert!((compliance / chi - 1.0).abs() < 1e-14 && linear.relative_deviation() < 1e-14);

        for fit in [
            power(&of(&|p| b * p.powf(kappa))).unwrap(),
            power_with_offset(&of(&|p| b * p.powf(kappa) + offset)).unwrap(),
        ] {
            let Roughness::Power { coefficient, exponent } = fit.roughness else { panic!() };
            // Of the sum of squares near its minimum half the digits are left.
            assert!((exponent / kappa - 1.0).abs() < 1e-6, "{exponent}");
            assert!((coefficient / b - 1.0).abs() < 1e-5, "{coefficient}");
            assert!(fit.relative_deviation() < 1e-7 && (fit.r_squared - 1.0).abs() < 1e-12);
        }
        let line = linear_with_offset(&of(&|p| chi * p + offset)).unwrap();
        assert!((line.offset / offset - 1.0).abs() < 1e-12);
    }

    #[test]
    fn deviations_are_those_of_the_worst_point() {
        // v = 0, 1, 5 at p = 0, 1, 2: chi = 11/5, residuals 0, -1.2, 0.6; mean 2, sum of squares 14.
        let fit = proportional(&[[0.0, 0.0], [1.0, 1.0], [2.0, 5.0]]).unwrap();
        assert_eq!(fit.roughness, Roughness::Linear { compliance: 2.2 });
        assert!((fit.largest_deviation - 1.2).abs() < 1e-15 && fit.deviates_at == 1.0);
        assert!((fit.r_squared - (1.0 - 1.8 / 14.0)).abs() < 1e-15);
    }

    #[test]
    fn refuses_what_is_no_layer() {
        // Softer and softer: kappa = 2.
        let softening: Vec<[f64; 2]> = pressures().map(|p| [p, 1e-20 * p * p]).collect();
        let error = power(&softening).unwrap_err();
        assert!(
            matches!(error, Error::InvalidValue { field: "exponent", value, .. } if (value - 2.0).abs() < 1e-9)
        );
        let logarithm: Vec<[f64; 2]> = pressures().map(|p| [p, 1e-6 * p.ln()]).collect();
        assert!(power_with_offset(&logarithm).unwrap_err().to_string().contains("logarithm"));
        let falling: Vec<[f64; 2]> = pressures().map(|p| [p, -1e-14 * p]).collect();
        assert!(proportional(&falling).is_err() && linear_with_offset(&falling).is_err());
    }
}
