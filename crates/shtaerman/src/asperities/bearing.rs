//! The bearing curve of a surface.

use std::f64::consts::PI;

use libm::tgamma;

use super::fit;
use crate::error::{positive, require};
use crate::{Error, Roughness};

/// Levels at which the bearing curve of a trace is taken.
const LEVELS: usize = 400;

/// The share of the surface above the level that lies `v` below its highest point, `eta = b (v/R)^nu`, `R` the height from the lowest to the highest point
/// (E. J. Abbott and F. A. Firestone, Mech. Eng. 55 (1933) 569; the power with the parameters `b` and `nu` is N. B. Demkin's).
///
/// A flat pressed in by `v` meets the share `eta(v)` of the surface: neither bulging nor the giving of the body below the asperities, which Shtaerman's
/// model has apart, is in it. What pressure that takes is [plastic](Self::plastic) or [elastic](Self::elastic).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingCurve {
    coefficient: f64,
    exponent: f64,
    height: f64,
}

/// A bearing curve fitted to a trace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BearingFit {
    /// The curve.
    pub curve: BearingCurve,
    /// The shares between which it was fitted.
    pub shares: [f64; 2],
    /// Share of the variance of `ln eta` that the curve explains.
    pub r_squared: f64,
    /// Largest difference of the two shares.
    pub largest_deviation: f64,
}

impl BearingCurve {
    /// `b`, `nu`, and `R` (m).
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless all are finite and positive.
    pub fn new(coefficient: f64, exponent: f64, height: f64) -> Result<Self, Error> {
        positive("b", coefficient)?;
        positive("nu", exponent)?;
        positive("height", height)?;
        Ok(Self { coefficient, exponent, height })
    }

    /// The curve of a trace of positions and heights (m), straight between its points, fitted by least squares of `ln eta` over `ln (v/R)` at the levels with
    /// shares between `shares`. The share of a trace stands for that of the surface where its direction is one like others.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for fewer than three points, positions that do not increase, heights that do not differ, shares that are not
    /// `0 < least < most <= 1` or with fewer than three levels between them.
    pub fn of_trace(trace: &[[f64; 2]], shares: [f64; 2]) -> Result<BearingFit, Error> {
        let [least, most] = shares;
        let range = "greater than 0 and at most 1, the first less than the second";
        require(least > 0.0 && least < 1.0, "share", least, range)?;
        require(most > least && most <= 1.0, "share", most, range)?;
        require(trace.len() > 2, "trace", trace.len() as f64, "of at least three points")?;
        let heights = || trace.iter().map(|point| point[1]);
        let broken = heights().find(|height| !height.is_finite());
        require(broken.is_none(), "trace", broken.unwrap_or(0.0), "finite everywhere")?;
        let top = heights().fold(f64::NEG_INFINITY, f64::max);
        let height = top - heights().fold(f64::INFINITY, f64::min);
        require(
            height.is_finite() && height > 0.0,
            "height",
            height,
            "finite and not the same all along the trace",
        )?;
        let curve = shares_above(trace, top, height)?;
        let chosen: Vec<[f64; 2]> =
            curve.into_iter().filter(|[_, share]| *share >= least && *share <= most).collect();
        require(
            chosen.len() > 2,
            "share",
            chosen.len() as f64,
            "such that at least three of 400 levels lie between them",
        )?;
        Self::fitted(&chosen, height, shares)
    }

    fn fitted(curve: &[[f64; 2]], height: f64, shares: [f64; 2]) -> Result<BearingFit, Error> {
        let logarithms: Vec<[f64; 2]> = curve.iter().map(|pair| pair.map(f64::ln)).collect();
        let [exponent, constant] = fit::line(&logarithms);
        let fitted = Self::new(constant.exp(), exponent, height)?;
        let mean = logarithms.iter().map(|pair| pair[1]).sum::<f64>() / logarithms.len() as f64;
        let (mut left, mut whole) = (0.0, 0.0);
        for [x, y] in &logarithms {
            left += (y - constant - exponent * x).powi(2);
            whole += (y - mean).powi(2);
        }
        let largest_deviation = (curve.iter())
            .map(|[level, share]| (fitted.share(level * height) - share).abs())
            .fold(0.0, f64::max);
        Ok(BearingFit { curve: fitted, shares, r_squared: 1.0 - left / whole, largest_deviation })
    }

    /// `b`.
    #[must_use]
    pub fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// `nu`.
    #[must_use]
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// `R` (m).
    #[must_use]
    pub fn height(&self) -> f64 {
        self.height
    }

    /// `eta` at the level `v` (m) below the highest point; more than 1 beyond the range of the power.
    #[must_use]
    pub fn share(&self, depth: f64) -> f64 {
        self.coefficient * (depth / self.height).powf(self.exponent)
    }

    /// The law of a layer whose asperities are crushed at the pressure `H` (Pa), the hardness: `p = H eta(v)`, so
    ///
    /// `v = R (p/(H b))^(1/nu)`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `H` is finite and positive and `nu >= 1`.
    pub fn plastic(&self, hardness: f64) -> Result<Roughness, Error> {
        positive("hardness", hardness)?;
        require(self.exponent >= 1.0, "nu", self.exponent, SOFTENS)?;
        let kappa = 1.0 / self.exponent;
        Roughness::power(self.height * (hardness * self.coefficient).powf(-kappa), kappa)
    }

    /// The law of a layer of elastic asperities with spherical tips of the radius `beta` (m), each giving by Hertz's law on its own with the composite plane-strain
    /// modulus `E*` (Pa).
    ///
    /// A flat at the depth `v` cuts a tip that begins at the depth `z` over the area `2 pi beta (v - z)`, so the bearing curve tells how many tips begin where:
    /// `n(z) = eta''(z)/(2 pi beta)`, and `p = int_0^v (4/3) E* sqrt(beta) (v - z)^(3/2) n(z) dz` is
    ///
    /// `p = E* b Gamma(nu+1)/(2 sqrt(pi beta) Gamma(nu+3/2)) R^-nu v^(nu+1/2)`, `kappa = 2/(2 nu + 1)`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `E*` and `beta` are finite and positive and `nu >= 1`: for less the number of tips were negative.
    pub fn elastic(&self, modulus: f64, radius: f64) -> Result<Roughness, Error> {
        positive("modulus", modulus)?;
        positive("radius", radius)?;
        let nu = self.exponent;
        require(nu >= 1.0, "nu", nu, SOFTENS)?;
        let kappa = 2.0 / (2.0 * nu + 1.0);
        // Gamma(nu+1)/Gamma(nu+3/2) overflows from nu = 170 on, where the power is none of a surface.
        let gammas = tgamma(nu + 1.0) / tgamma(nu + 1.5);
        let stiffness = modulus * self.coefficient * gammas / (2.0 * (PI * radius).sqrt());
        // v^(nu+1/2) = p R^nu/stiffness
        let coefficient = self.height.powf(nu * kappa) * stiffness.powf(-kappa);
        Roughness::power(coefficient, kappa)
    }
}

const SOFTENS: &str = "at least 1: a smaller exponent means a plateau at the top and a layer that softens under load; fit other shares of the curve";

/// Levels `(top - level)/height` and the shares of the trace above them.
fn shares_above(trace: &[[f64; 2]], top: f64, height: f64) -> Result<Vec<[f64; 2]>, Error> {
    // The length above a level is, from segment to segment, constant + slope * level, from one level to another: differences, then sums.
    let (mut constants, mut slopes) = (vec![0.0; LEVELS + 2], vec![0.0; LEVELS + 2]);
    let level = |i: usize| i as f64 / LEVELS as f64;
    let first_at = |x: f64| ((x * LEVELS as f64).ceil().max(0.0) as usize).min(LEVELS + 1);
    let mut whole = 0.0;
    for pair in trace.windows(2) {
        let length = pair[1][0] - pair[0][0];
        require(
            length > 0.0 && length.is_finite(),
            "position",
            pair[1][0],
            "greater than the one before it and finite",
        )?;
        let depths = [0, 1].map(|i| (top - pair[i][1]) / height);
        let [near, far] = [depths[0].min(depths[1]), depths[0].max(depths[1])];
        // Nothing above levels before `near`, a ramp to `far`, all of it beyond.
        let (begin, end) = (first_at(near), first_at(far));
        if end > begin {
            let slope = length / (far - near);
            constants[begin] -= slope * near;
            constants[end] += slope * near;
            slopes[begin] += slope;
            slopes[end] -= slope;
        }
        constants[end] += length;
        whole += length;
    }
    let (mut constant, mut slope) = (0.0, 0.0);
    let mut shares = Vec::with_capacity(LEVELS);
    for i in 0..=LEVELS {
        constant += constants[i];
        slope += slopes[i];
        if i > 0 {
            shares.push([level(i), (constant + slope * level(i)) / whole]);
        }
    }
    Ok(shares)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cusps `z = -(|x|)^(1/nu)`, whose bearing curve is `(v/R)^nu`.
    fn cusps(nu: f64) -> Vec<[f64; 2]> {
        (-4000..=4000)
            .map(|i| {
                let x = f64::from(i) / 4000.0;
                [1e-3 * x, -2e-6 * x.abs().powf(1.0 / nu)]
            })
            .collect()
    }

    #[test]
    fn traces_of_known_bearing_curve() {
        for nu in [1.0, 1.7, 2.5] {
            let BearingFit { curve, r_squared, largest_deviation, .. } =
                BearingCurve::of_trace(&cusps(nu), [0.02, 0.6]).unwrap();
            assert!((curve.exponent() / nu - 1.0).abs() < 1e-3, "{nu}: {}", curve.exponent());
            assert!((curve.coefficient() - 1.0).abs() < 1e-3);
            assert!((curve.height() / 2e-6 - 1.0).abs() < 1e-12);
            assert!(r_squared > 0.99999 && largest_deviation < 1e-3);
        }
    }

    #[test]
    fn shares_are_those_counted_on_a_fine_grid() {
        let z = |x: f64| (7.0 * x).sin() + 0.4 * (31.0 * x + 1.0).cos();
        let trace: Vec<[f64; 2]> =
            (0..=3000).map(|i| f64::from(i) / 500.0).map(|x| [x, z(x)]).collect();
        let top = trace.iter().map(|p| p[1]).fold(f64::MIN, f64::max);
        let height = top - trace.iter().map(|p| p[1]).fold(f64::MAX, f64::min);
        let shares = shares_above(&trace, top, height).unwrap();
        for &[level, share] in shares.iter().step_by(37) {
            let count = (0..600_000)
                .filter(|i| z((f64::from(*i) + 0.5) / 1e5) > top - level * height)
                .count();
            assert!((count as f64 / 6e5 - share).abs() < 2e-4, "{level}: {share}");
        }
        assert!((shares[LEVELS - 1][1] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn crushed_asperities_carry_their_hardness() {
        let curve = BearingCurve::new(1.8, 2.2, 6e-6).unwrap();
        let law = curve.plastic(2e9).unwrap();
        for v in [0.2e-6, 1e-6] {
            let pressure = 2e9 * curve.share(v);
            assert!((law.displacement(pressure) / v - 1.0).abs() < 1e-13);
        }
    }

    #[test]
    fn elastic_asperities_carry_the_sum_of_hertz_forces() {
        let (b, nu, height, modulus, radius) = (1.8, 2.2, 6e-6, 110e9, 40e-6);
        let law = BearingCurve::new(b, nu, height).unwrap().elastic(modulus, radius).unwrap();
        for v in [0.3e-6f64, 2e-6] {
            // p = int (4/3) E* sqrt(beta) (v-z)^(3/2) eta''(z)/(2 pi beta) dz by the double-exponential rule
            let pressure: f64 = fredholm::quadrature::double_exponential(60)
                .map(|node| {
                    let (z, left) = (0.5 * v * node.from_left, 0.5 * v * node.from_right);
                    let tips = b * nu * (nu - 1.0) * z.powf(nu - 2.0) * height.powf(-nu)
                        / (2.0 * PI * radius);
                    node.weight * 0.5 * v * 4.0 / 3.0
                        * modulus
                        * radius.sqrt()
                        * left.powf(1.5)
                        * tips
                })
                .sum();
            assert!((law.displacement(pressure) / v - 1.0).abs() < 1e-12);
        }
        // All tips at one height, nu = 1: n = b/(2 pi beta R) spheres per area.
        let law = BearingCurve::new(b, 1.0, height).unwrap().elastic(modulus, radius).unwrap();
        let (v, n) = (1e-6f64, b / (2.0 * PI * radius * height));
        let pressure = n * 4.0 / 3.0 * modulus * radius.sqrt() * v.powf(1.5);
        assert!((law.displacement(pressure) / v - 1.0).abs() < 1e-13);
    }

    #[test]
    fn refuses_what_is_no_curve() {
        assert!(
            BearingCurve::new(0.0, 2.0, 1.0).is_err()
                && BearingCurve::new(1.0, f64::NAN, 1.0).is_err()
        );
        let plateau = BearingCurve::new(1.0, 0.5, 1e-6).unwrap();
        for law in [plateau.plastic(1e9), plateau.elastic(1e11, 1e-5)] {
            assert!(law.unwrap_err().to_string().contains("softens"));
        }
        let steep = BearingCurve::new(1.0, 500.0, 1e-6).unwrap();
        assert!(steep.elastic(1e11, 1e-5).is_err());
        let curve = BearingCurve::new(1.0, 2.0, 1e-6).unwrap();
        assert!(curve.plastic(-1.0).is_err() && curve.elastic(1e11, 0.0).is_err());
        for (trace, shares) in [
            (cusps(2.0), [0.0, 0.5]),
            (cusps(2.0), [0.5, 0.5]),
            (cusps(2.0), [0.1, 1.5]),
            (cusps(2.0), [0.1, 0.1001]),
            (cusps(2.0)[..2].to_vec(), [0.1, 0.5]),
            (vec![[0.0, 1.0], [1.0, 1.0], [2.0, 1.0]], [0.1, 0.5]),
            (vec![[0.0, 1.0], [1.0, 2.0], [0.5, 1.0]], [0.1, 0.5]),
            (vec![[0.0, 1.0], [1.0, f64::INFINITY], [2.0, 1.0]], [0.1, 0.5]),
            (vec![[0.0, 1.0], [1.0, f64::NAN], [2.0, 0.0]], [0.1, 0.5]),
        ] {
            assert!(BearingCurve::of_trace(&trace, shares).is_err(), "{shares:?}");
        }
    }
}
