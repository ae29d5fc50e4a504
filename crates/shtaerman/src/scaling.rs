//! Between a physical problem and the dimensionless one, (2.5) and (2.6).

use std::f64::consts::PI;

use crate::error::{positive, require};
use crate::{Elastic, Error, Geometry, Load, Rotational, Roughness};

/// The units in which a problem becomes dimensionless: `a` for lengths along the base, `E` for pressures, `chi E` for displacements (`B E^kappa`
/// with the law `B p^kappa` of the layer; for a smooth surface, which has no such scale, that which makes `theta0 = 1`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scaling {
    half_width: f64,
    young_modulus: f64,
    displacement: f64,
    theta0: f64,
    contact_modulus: f64,
    roughness: Roughness,
    is_circular: bool,
}

impl Scaling {
    /// Scales of a foundation with roughness compliance `chi` (m/Pa) or another law under a plane punch of half-width `a` (m), rigid or
    /// (`body`) elastic.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless half-width and roughness are finite and positive and `theta0` is finite.
    pub fn new(
        foundation: &Elastic,
        roughness: impl Into<Roughness>,
        half_width: f64,
        body: Option<&Elastic>,
    ) -> Result<Self, Error> {
        Self::in_geometry(foundation, roughness.into(), half_width, body, Geometry::Plane)
    }

    pub(crate) fn in_geometry(
        foundation: &Elastic,
        roughness: Roughness,
        half_width: f64,
        body: Option<&Elastic>,
        geometry: Geometry,
    ) -> Result<Self, Error> {
        let contact_modulus = body
            .map_or(foundation.plane_strain_modulus(), |body| foundation.composite_modulus(body));
        let response = 2.0 / (PI * contact_modulus);
        let modulus = foundation.young_modulus();
        Self::with_response(response, [modulus, contact_modulus], roughness, half_width, geometry)
    }

    /// Scales of a foundation that gives by `response a int K p0 dxi` under the pressure `p0` (Pa), `xi` in half-widths, `response` in 1/Pa; moduli
    /// are that which scales pressures, and `E*`.
    pub(crate) fn with_response(
        response: f64,
        [young_modulus, contact_modulus]: [f64; 2],
        roughness: Roughness,
        half_width: f64,
        geometry: Geometry,
    ) -> Result<Self, Error> {
        positive("half_width", half_width)?;
        roughness.check()?;
        geometry.check(half_width)?;
        let elastic = response * half_width * young_modulus;
        let displacement = match roughness {
            Roughness::Smooth => elastic,
            layer => layer.displacement(young_modulus),
        };
        let scaling = Self {
            half_width,
            young_modulus,
            displacement,
            theta0: elastic / displacement,
            contact_modulus,
            roughness,
            is_circular: geometry == Geometry::Circular,
        };
        let scales = [
            scaling.theta0(),
            scaling.displacement(),
            scaling.force(),
            scaling.moment(),
            scaling.displacement() / half_width,
        ];
        let usable = scales.into_iter().all(|scale| scale.is_finite() && scale > f64::MIN_POSITIVE);
        require(
            usable,
            "theta0",
            scaling.theta0(),
            "representable: moduli, half_width and roughness together leave the range of double precision",
        )?;
        Ok(scaling)
    }

    /// `theta0 = 2 a/(pi E* chi)`, with `E* = E/(1-nu^2)` for a rigid punch the paper's `a theta/chi`.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        self.theta0
    }

    /// `E*` (Pa).
    #[must_use]
    pub fn contact_modulus(&self) -> f64 {
        self.contact_modulus
    }

    /// `a` (m): `x = a xi`.
    #[must_use]
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// `E` (Pa): `p = E p0`.
    #[must_use]
    pub fn pressure(&self) -> f64 {
        self.young_modulus
    }

    /// What the rough layer gives.
    #[must_use]
    pub fn roughness(&self) -> Roughness {
        self.roughness
    }

    /// `chi E` or `B E^kappa` (m): `delta = chi E delta0`, `f = chi E f0`.
    #[must_use]
    pub fn displacement(&self) -> f64 {
        self.displacement
    }

    /// `chi E/a` (rad): `alpha = (chi E/a) alpha0`.
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.displacement() / self.half_width
    }

    /// `a E` (N/m): `P = a E P0`; `a^2 E` (N) for a circular punch.
    #[must_use]
    pub fn force(&self) -> f64 {
        let width = if self.is_circular { self.half_width } else { 1.0 };
        width * self.half_width * self.young_modulus
    }

    /// `a^2 E` (N m/m): `M = a^2 E M0`; `a^3 E` (N m) for a circular punch.
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.half_width * self.force()
    }

    /// The load without dimensions.
    #[must_use]
    pub fn load(&self, load: &Load) -> Load {
        let vertical = load
            .vertical
            .mapped(|force| force / self.force(), |length| length / self.displacement());
        let rotational = match load.rotational {
            Rotational::Moment(moment) => Rotational::Moment(moment / self.moment()),
            Rotational::Eccentricity(length) => Rotational::Eccentricity(length / self.half_width),
            Rotational::Tilt(angle) => Rotational::Tilt(angle / self.angle()),
        };
        Load { vertical, rotational }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_papers_parameter() {
        // nu = 0.25: theta0 = 15/(8 pi) lambda0, lambda0 = a/(E chi), sec. 5
        let (modulus, roughness, half_width) = (70e9, 3e-13, 0.004);
        let scaling =
            Scaling::new(&Elastic::new(modulus, 0.25).unwrap(), roughness, half_width, None)
                .unwrap();
        let lambda0 = half_width / (modulus * roughness);
        assert!((scaling.theta0() / (15.0 / (8.0 * PI) * lambda0) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn refuses_scales_that_overflow() {
        let stiff = Elastic::new(1e300, 0.3).unwrap();
        assert!(Scaling::new(&stiff, 1e300, 1.0, None).is_err());
        assert!(Scaling::new(&stiff, -1.0, 1.0, None).is_err());
        assert!(Scaling::new(&stiff, 1e-300, -1.0, None).is_err());
    }
}
