//! A foundation whose modulus grows with depth.

use std::f64::consts::{FRAC_PI_2, PI};

use libm::tgamma;
use serde::{Deserialize, Serialize};

use crate::Error;
use crate::error::{positive, require};

/// `E(y) = E0 (y / 1 m)^mu` at the depth `y`, `0 <= mu < 1`; Poisson's ratio is constant.
///
/// A pressure `p cos(q x)` or `p J_0(q r)` on the surface settles it by `A(mu, nu) q^(mu-1) p/E0` with
///
/// `A = 2 (1 - nu^2) beta sin(pi beta/2) Gamma((1-mu)/2) Gamma((3+mu+beta)/2) Gamma((3+mu-beta)/2) / (sqrt(pi) (1+mu) Gamma(1+mu/2) Gamma(2+mu))`,
/// `beta^2 = (1+mu) (1 - mu nu/(1-nu))`,
///
/// which is `2 (1 - nu^2)` for `mu = 0` and 3/2 in the limit of Gibson's incompressible soil, `mu = 1`, `nu = 1/2`, where a pressure settles its own
/// place only. This is the constant of V. L. Popov, M. Heß and E. Willert, *Handbook of Contact Mechanics* (Springer 2019), chapter 9, after J. R. Booker, N. P. Balaam
/// and E. H. Davis, Int. J. Numer. Anal. Methods Geomech. 9 (1985) 353, and A. E. Giannakopoulos and P. Pallot, J. Mech. Phys. Solids 48 (2000)
/// 1597, in other words; it is tested against a series solution of the transformed equations of elasticity that uses none of them
/// (`tests/data/graded.py`), with which it agrees in all of 30 digits.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Grading {
    exponent: f64,
    modulus: f64,
}

impl Grading {
    /// `mu`, and `E0`, Young's modulus at the depth of one metre (Pa).
    ///
    /// ```
    /// use shtaerman::Grading;
    /// let sand = Grading::new(0.5, 40e6)?;
    /// assert_eq!(sand.modulus_at(0.25), 20e6);
    /// assert!(Grading::new(1.0, 40e6).is_err() && Grading::new(-0.1, 40e6).is_err());
    /// # Ok::<(), shtaerman::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `0 <= mu < 1` and `E0` is finite and positive: for other exponents the settlement is not finite.
    pub fn new(exponent: f64, modulus: f64) -> Result<Self, Error> {
        require(
            (0.0..1.0).contains(&exponent),
            "grading_exponent",
            exponent,
            "at least 0 and less than 1: a body that softens with depth has no finite settlement under a line load, and from 1 on the surface has none under pressure",
        )?;
        positive("grading_modulus", modulus)?;
        Ok(Self { exponent, modulus })
    }

    /// `mu`.
    #[must_use]
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// `E0`, Young's modulus at the depth of one metre (Pa).
    #[must_use]
    pub fn modulus(&self) -> f64 {
        self.modulus
    }

    /// Whether the modulus is the same at every depth.
    #[must_use]
    pub fn is_homogeneous(&self) -> bool {
        self.exponent == 0.0
    }

    /// `E(y)` (Pa) at the depth `y` (m).
    #[must_use]
    pub fn modulus_at(&self, depth: f64) -> f64 {
        self.modulus * depth.powf(self.exponent)
    }

    /// `A(mu, nu)` for Poisson's ratio `-1 < nu <= 1/2`: the settlement under `p cos(q x)` is `A q^(mu-1) p/E0`.
    #[must_use]
    pub fn wave_response(&self, poisson_ratio: f64) -> f64 {
        let (mu, nu) = (self.exponent, poisson_ratio);
        let beta = ((1.0 + mu) * (1.0 - mu * nu / (1.0 - nu))).sqrt();
        let gammas = tgamma(0.5 * (1.0 - mu))
            * tgamma(0.5 * (3.0 + mu + beta))
            * tgamma(0.5 * (3.0 + mu - beta))
            / (tgamma(1.0 + 0.5 * mu) * tgamma(2.0 + mu));
        2.0 * (1.0 - nu * nu) * beta * (FRAC_PI_2 * beta).sin() * gammas / (PI.sqrt() * (1.0 + mu))
    }

    /// `theta_g` (m^mu/Pa) of the plane problem: under the line load `P` (N/m) the surface settles by `theta_g P |x|^-mu`, zero at infinity.
    ///
    /// `theta_g = A Gamma(mu) cos(pi mu/2)/(pi E0)`; infinite for `mu = 0`, where only differences of settlements are finite: `theta_g mu` tends to
    /// `2/(pi E*)`, and `theta_g (|x|^-mu - 1)` to `-(2/(pi E*)) ln |x|`.
    #[must_use]
    pub fn line_response(&self, poisson_ratio: f64) -> f64 {
        let mu = self.exponent;
        self.wave_response(poisson_ratio) * tgamma(mu) * (FRAC_PI_2 * mu).cos()
            / (PI * self.modulus)
    }

    /// `c` (m^(1+mu) m/N) of the axisymmetric problem: under the point load `P` (N) the surface settles by `c P r^-(1+mu)`.
    ///
    /// `c = A 2^mu Gamma((1+mu)/2) / (2 pi E0 Gamma((1-mu)/2))`, for `mu = 0` Boussinesq's `1/(pi E*)`.
    #[must_use]
    pub fn point_response(&self, poisson_ratio: f64) -> f64 {
        let mu = self.exponent;
        let gammas = tgamma(0.5 * (1.0 + mu)) / tgamma(0.5 * (1.0 - mu));
        self.wave_response(poisson_ratio) * mu.exp2() * gammas / (2.0 * PI * self.modulus)
    }

    /// What scales the kernel of a punch of half-width or radius `a` (1/Pa): with `p0` of `xi = x/a` the surface settles by `response a int K p0 dm`,
    ///
    /// - plane: `K = |xi - eta|^-mu`, `dm = deta`, `response = theta_g a^-mu`;
    /// - circular: `K = int_0^inf t^mu J_0(xi t) J_0(eta t) dt`, `dm = pi eta deta`, `response = A/(pi E(a))`, for `mu = 0` the `2/(pi E*)` of the
    ///   homogeneous disk.
    #[must_use]
    pub fn response(&self, poisson_ratio: f64, half_width: f64, is_circular: bool) -> f64 {
        if is_circular {
            self.wave_response(poisson_ratio) / (PI * self.modulus_at(half_width))
        } else {
            self.line_response(poisson_ratio) * half_width.powf(-self.exponent)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRANSFORM: &str = include_str!("../tests/data/graded.json");

    fn literal(row: &serde_json::Value, key: &str) -> Option<f64> {
        row[key].as_str().map(|text| text.parse().unwrap())
    }

    #[test]
    fn constants_are_those_of_the_transformed_equations() {
        let document: serde_json::Value = serde_json::from_str(TRANSFORM).unwrap();
        let rows = document["rows"].as_array().unwrap();
        assert_eq!(rows.len(), 54);
        for row in rows {
            let (mu, nu) = (row["mu"].as_f64().unwrap(), row["nu"].as_f64().unwrap());
            let grading = Grading::new(mu, 1.0).unwrap();
            // Near mu = 1 and nu = 1/2 the data of double precision are themselves rounded: (1 - mu) has 14 digits.
            let allowed = 4e-15 / (1.0 - mu);
            let close = |found: f64, key: &str| match literal(row, key) {
                Some(truth) => {
                    assert!((found / truth - 1.0).abs() < allowed, "{key} {mu} {nu}: {found}");
                }
                None => assert_eq!(mu, 0.0, "{key}"),
            };
            close(grading.wave_response(nu), "wave");
            close(grading.line_response(nu), "line");
            close(grading.point_response(nu), "point");
        }
    }

    #[test]
    fn a_homogeneous_body_is_the_limit() {
        for nu in [-0.5, 0.0, 0.3, 0.5] {
            let modulus = 3e9;
            let contact = modulus / (1.0 - nu * nu);
            let homogeneous = Grading::new(0.0, modulus).unwrap();
            let boussinesq = 1.0 / (PI * contact);
            assert!((homogeneous.point_response(nu) / boussinesq - 1.0).abs() < 2e-15);
            assert!((homogeneous.response(nu, 0.3, true) * PI * contact / 2.0 - 1.0).abs() < 2e-15);
            // Settlements at 0.1 m and 2 m: the difference is Flamant's.
            let flamant = 2.0 / (PI * contact) * 20f64.ln();
            let mut last = f64::INFINITY;
            for mu in [1e-2, 1e-3, 1e-4, 1e-5] {
                let near = Grading::new(mu, modulus).unwrap();
                let difference = near.line_response(nu) * (0.1f64.powf(-mu) - 2f64.powf(-mu));
                let error = (difference / flamant - 1.0).abs();
                assert!(error < 3.0 * mu && error < last, "{mu} {nu}: {error}");
                last = error;
            }
        }
    }

    #[test]
    fn gibsons_soil_is_a_bed_of_springs() {
        // Shear modulus G = m y, incompressible: p = 2 m u (R. E. Gibson, Geotechnique 17 (1967) 58), with E = 3 G u = (3/2) p/E0.
        for gap in [1e-4, 1e-6] {
            let grading = Grading::new(1.0 - gap, 1.0).unwrap();
            assert!((grading.wave_response(0.5) - 1.5).abs() < 6.0 * gap);
            // The kernel tends to a delta function with this mass: theta_g int_{-1}^{1} |x|^-mu dx
            assert!((grading.line_response(0.5) * 2.0 / gap - 1.5).abs() < 6.0 * gap);
        }
    }

    #[test]
    fn refuses_what_has_no_finite_settlement() {
        for exponent in [-0.3, -1e-9, 1.0, 2.5, f64::NAN, f64::INFINITY] {
            let error = Grading::new(exponent, 1e9).unwrap_err();
            assert!(matches!(error, Error::InvalidValue { field: "grading_exponent", .. }));
            assert!(error.to_string().contains("no finite settlement"), "{error}");
        }
        for modulus in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let error = Grading::new(0.3, modulus).unwrap_err();
            assert!(matches!(error, Error::InvalidValue { field: "grading_modulus", .. }));
        }
    }
}
