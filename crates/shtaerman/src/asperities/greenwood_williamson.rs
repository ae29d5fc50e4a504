//! Asperities of Gaussian height, each a Hertzian sphere.

use super::fit::{self, Fit};
use super::gaussian;
use crate::Error;
use crate::error::{positive, require};

/// Separations over the standard deviation between which the model is evaluated: farther apart pressures underflow, nearer nothing is left of it.
const SEPARATIONS: [f64; 2] = [-3.0, 35.0];
/// Pressures of a range at which a law is fitted.
const SAMPLES: usize = 201;

/// The model of J. A. Greenwood and J. B. P. Williamson, Proc. R. Soc. Lond. A 295 (1966) 300: `eta` asperities per unit area with spherical tips of one radius
/// `beta`, their heights normally distributed with the standard deviation `sigma`, each giving by Hertz's law on its own.
///
/// At the separation `d` of the mean plane of the summits from the smooth flat the pressure is
///
/// `p(d) = (4/3) eta E* sqrt(beta) sigma^(3/2) F_(3/2)(d/sigma)`, `F_n(h) = int_h^inf (s - h)^n phi(s) ds`,
///
/// with `E*` the composite plane-strain modulus of the asperities and the flat. Where two surfaces are rough, `sigma`, `eta` and `beta` are those of the sum of
/// both. Neighbours do not interact: the share of real contact should be a few per cent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GreenwoodWilliamson {
    deviation: f64,
    density: f64,
    radius: f64,
    modulus: f64,
}

impl GreenwoodWilliamson {
    /// `sigma` (m) of the summits' heights, `eta` (1/m^2), `beta` (m), `E*` (Pa).
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless all are finite and positive and the scale of pressures is representable.
    pub fn new(deviation: f64, density: f64, radius: f64, modulus: f64) -> Result<Self, Error> {
        positive("deviation", deviation)?;
        positive("density", density)?;
        positive("radius", radius)?;
        positive("modulus", modulus)?;
        let model = Self { deviation, density, radius, modulus };
        let scale = model.pressure_scale();
        require(
            scale.is_finite() && scale > 1e-30,
            "modulus",
            modulus,
            "such that (4/3) eta E* sqrt(beta) sigma^(3/2) is a finite pressure above 1e-30 Pa",
        )?;
        Ok(model)
    }

    /// `p` (Pa) at the separation `d` (m) of the mean plane of the summits from the flat.
    #[must_use]
    pub fn pressure_at(&self, separation: f64) -> f64 {
        self.pressure_scale() * gaussian::three_halves(separation / self.deviation)
    }

    /// `d` (m) under the pressure `p` (Pa).
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a pressure that is not positive, underflows, or brings the flat three standard deviations below the mean plane.
    pub fn separation(&self, pressure: f64) -> Result<f64, Error> {
        Ok(self.deviation * self.relative_separation(pressure)?)
    }

    /// The local compliance `chi = -dd/dp` (m/Pa) of the layer at the pressure `p` (Pa).
    ///
    /// # Errors
    /// As [`Self::separation`].
    pub fn compliance(&self, pressure: f64) -> Result<f64, Error> {
        let h = self.relative_separation(pressure)?;
        // dF_(3/2)/dh = -(3/2) F_(1/2)
        Ok(self.deviation / (1.5 * self.pressure_scale() * gaussian::half(h)))
    }

    /// Share of the nominal area that is in contact under the pressure `p` (Pa), `pi eta beta sigma F_1`.
    ///
    /// # Errors
    /// As [`Self::separation`].
    pub fn contact_share(&self, pressure: f64) -> Result<f64, Error> {
        let h = self.relative_separation(pressure)?;
        let area = std::f64::consts::PI * self.density * self.radius * self.deviation;
        Ok(area * gaussian::one(h))
    }

    /// Asperities in contact per unit area (1/m^2) under the pressure `p` (Pa), `eta F_0`.
    ///
    /// # Errors
    /// As [`Self::separation`].
    pub fn contacts(&self, pressure: f64) -> Result<f64, Error> {
        Ok(self.density * gaussian::share(self.relative_separation(pressure)?))
    }

    /// The plasticity index `(E*/H) sqrt(sigma/beta)` for the hardness `H` (Pa): below about 0.6 contact is elastic at any ordinary pressure, above 1 plastic
    /// at most pressures (Greenwood and Williamson).
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the hardness is finite and positive.
    pub fn plasticity_index(&self, hardness: f64) -> Result<f64, Error> {
        positive("hardness", hardness)?;
        Ok(self.modulus / hardness * (self.deviation / self.radius).sqrt())
    }

    /// `v = B p^kappa` by least squares of the approach between two pressures (Pa). The approach is counted from the mean plane, `-d`; the law
    /// counts it from its own first touch, at the separation `-offset`: a Gaussian surface has no highest asperity.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `0 < first < last`, as [`Self::separation`], and where no power fits.
    pub fn fit_power(&self, pressures: [f64; 2]) -> Result<Fit, Error> {
        fit::power_with_offset(&self.samples(pressures)?)
    }

    /// `v = chi p` likewise.
    ///
    /// # Errors
    /// As [`Self::fit_power`].
    pub fn fit_linear(&self, pressures: [f64; 2]) -> Result<Fit, Error> {
        fit::linear_with_offset(&self.samples(pressures)?)
    }

    fn samples(&self, [first, last]: [f64; 2]) -> Result<Vec<[f64; 2]>, Error> {
        positive("pressure", first)?;
        positive("pressure", last)?;
        require(last > first, "pressure", last, "greater than the first pressure of the range")?;
        (0..SAMPLES)
            .map(|i| {
                let pressure = first + (last - first) * i as f64 / (SAMPLES - 1) as f64;
                Ok([pressure, -self.separation(pressure)?])
            })
            .collect()
    }

    /// `(4/3) eta E* sqrt(beta) sigma^(3/2)`.
    fn pressure_scale(&self) -> f64 {
        4.0 / 3.0 * self.density * self.modulus * self.radius.sqrt() * self.deviation.powf(1.5)
    }

    /// `h` with `F_(3/2)(h) = p/scale`, by Newton's method on the logarithm, which is concave and falls: from the right
    /// it converges from one side.
    fn relative_separation(&self, pressure: f64) -> Result<f64, Error> {
        positive("pressure", pressure)?;
        let target = pressure / self.pressure_scale();
        let [nearest, farthest] = SEPARATIONS;
        require(
            target <= gaussian::three_halves(nearest),
            "pressure",
            pressure,
            "lower: it brings the flat below the mean plane of the summits by three standard deviations, and no asperities are left",
        )?;
        require(
            target >= gaussian::three_halves(farthest),
            "pressure",
            pressure,
            "higher: next to no asperity touches under it",
        )?;
        const STEPS: usize = 200;
        let mut h = farthest;
        for _ in 0..STEPS {
            let value = gaussian::three_halves(h);
            let step = (value / target).ln() * value / (1.5 * gaussian::half(h));
            h = (h + step).clamp(nearest, farthest);
            if step.abs() <= 1e-15 * (1.0 + h.abs()) {
                break;
            }
        }
        Ok(h)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Roughness;

    fn surface() -> GreenwoodWilliamson {
        GreenwoodWilliamson::new(0.5e-6, 1e10, 20e-6, 110e9).unwrap()
    }

    #[test]
    fn pressure_is_that_of_the_sum_over_spheres() {
        // F_(3/2)(1) by mpmath.
        let p = 4.0 / 3.0
            * 1e10
            * 110e9
            * (20e-6f64).sqrt()
            * (0.5e-6f64).powf(1.5)
            * 0.07566817739097507;
        assert!((surface().pressure_at(0.5e-6) / p - 1.0).abs() < 1e-14);
        assert!((surface().separation(p).unwrap() / 0.5e-6 - 1.0).abs() < 1e-13);
        for pressure in [1e-3, 1.0, 1e6, 1e9, 1e10] {
            let d = surface().separation(pressure).unwrap();
            // The pressure's own condition: d ln p/d ln h is as large as h^2.
            assert!((surface().pressure_at(d) / pressure - 1.0).abs() < 1e-12, "{pressure}");
        }
    }

    #[test]
    fn compliance_is_the_slope() {
        for pressure in [1e3, 1e7, 1e9] {
            let step = 1e-4 * pressure;
            let d = |p: f64| surface().separation(p).unwrap();
            let slope = (d(pressure - step) - d(pressure + step)) / (2.0 * step);
            let chi = surface().compliance(pressure).unwrap();
            assert!((chi / slope - 1.0).abs() < 1e-7, "{pressure}: {chi} {slope}");
        }
    }

    #[test]
    fn few_contacts_are_exponential() {
        // Far out the heights are exponential: chi p -> sigma/h, area and load proportional, p/(area E*) -> sqrt(sigma/(pi beta h)).
        let pressure = 1e-250f64.max(surface().pressure_at(30.0 * 0.5e-6));
        let h = 30.0;
        let chi = surface().compliance(pressure).unwrap();
        assert!((chi * pressure * h / 0.5e-6 - 1.0).abs() < 3.0 / (h * h));
        let area = surface().contact_share(pressure).unwrap();
        let ratio =
            pressure / (area * 110e9) / (0.5e-6f64 / (20e-6 * std::f64::consts::PI * h)).sqrt();
        assert!((ratio - 1.0).abs() < 3.0 / (h * h), "{ratio}");
    }

    #[test]
    fn half_of_all_asperities_touch_at_the_mean_plane() {
        let pressure = surface().pressure_at(0.0);
        assert!((surface().contacts(pressure).unwrap() / 0.5e10 - 1.0).abs() < 1e-12);
        // F_1(0) = 1/sqrt(2 pi)
        let area =
            std::f64::consts::PI * 1e10 * 20e-6 * 0.5e-6 / (2.0 * std::f64::consts::PI).sqrt();
        assert!((surface().contact_share(pressure).unwrap() / area - 1.0).abs() < 1e-12);
        let index = surface().plasticity_index(2e9).unwrap();
        assert!((index - 55.0 * 0.025f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn a_power_fits_better_than_a_line_and_both_say_how_well() {
        let range = [20e6, 200e6];
        let (power, linear) =
            (surface().fit_power(range).unwrap(), surface().fit_linear(range).unwrap());
        let Roughness::Power { exponent, .. } = power.roughness else { panic!() };
        assert!(exponent > 0.02 && exponent < 0.3, "{exponent}");
        assert!(
            power.relative_deviation() < 2e-3
                && power.relative_deviation() < linear.relative_deviation()
        );
        // The law again by its own words: v(p) + offset = -d(p) within the deviation, and there somewhere.
        let mut most = 0.0f64;
        for i in 0..=40 {
            let p = range[0] + (range[1] - range[0]) * f64::from(i) / 40.0;
            let off =
                power.roughness.displacement(p) + power.offset + surface().separation(p).unwrap();
            most = most.max(off.abs());
        }
        assert!(most <= power.largest_deviation * 1.000001 && most > 0.9 * power.largest_deviation);
    }

    #[test]
    fn refuses_what_is_no_surface() {
        for values in [
            [0.0, 1.0, 1.0, 1.0],
            [1.0, -1.0, 1.0, 1.0],
            [1.0, 1.0, f64::NAN, 1.0],
            [1.0, 1.0, 1.0, f64::INFINITY],
            [1e300; 4],
            [1e-300; 4],
        ] {
            let [a, b, c, d] = values;
            assert!(GreenwoodWilliamson::new(a, b, c, d).is_err(), "{values:?}");
        }
        for pressure in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e30, 1e-320] {
            assert!(surface().separation(pressure).is_err(), "{pressure}");
        }
        for range in [[1e6, 1e6], [2e6, 1e6], [0.0, 1e6], [1e6, f64::NAN]] {
            assert!(surface().fit_power(range).is_err(), "{range:?}");
        }
        assert!(surface().plasticity_index(0.0).is_err());
    }
}
