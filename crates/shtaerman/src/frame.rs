//! In which units a problem is stated, and on what the punch stands.

use crate::error::{positive, require};
use crate::layering::require_thickness;
use crate::quantity::{Dimension, DisplayUnit, engineering};
use crate::roughness::Law;
use crate::{Elastic, Error, Geometry, Grading, Layering, Roughness, Scaling};

/// Why a surface on layered ground has to be rough.
pub(crate) const ROUGH_ONLY: &str = "greater than zero on a layer of finite thickness and under a coating: smooth contact is not solved there";

/// In which units a problem is stated.
#[derive(Debug, Clone, PartialEq)]
pub enum Frame {
    /// SI units, (2.3).
    Physical {
        /// Material of the foundation; of a graded one at the depth `a`.
        foundation: Elastic,
        /// How the modulus grows with depth; `None` for a homogeneous foundation.
        grading: Option<Grading>,
        /// A layer of finite thickness or a coating; `None` for a foundation of one piece.
        layering: Option<Layering>,
        /// Material of an elastic punch; `None` for a rigid one.
        body: Option<Elastic>,
        /// What the rough layer gives.
        roughness: Roughness,
        /// One strip, a pair, a row, a disk; lengths in metres.
        geometry: Geometry,
        /// Scales that follow.
        scaling: Scaling,
    },
    /// Numbers without dimension, (2.5); `theta0 = 0` is the pure layer.
    Dimensionless {
        /// `theta0 = 2 a/(pi E* chi)`.
        theta0: f64,
        /// `p0` or `p0^kappa`.
        law: Law,
        /// One strip, a pair, a row, a disk; lengths in half-widths.
        geometry: Geometry,
        /// A layer of finite thickness, in half-widths.
        layering: Option<Layering>,
    },
}

impl Frame {
    /// A foundation with roughness compliance `chi` (m/Pa, 0 for a smooth surface) or another [`Roughness`] under one plane punch of
    /// half-width `a` (m), rigid or elastic.
    ///
    /// # Errors
    /// Those of [`Scaling::new`].
    pub fn physical(
        foundation: Elastic,
        roughness: impl Into<Roughness>,
        half_width: f64,
        body: Option<Elastic>,
    ) -> Result<Self, Error> {
        Self::physical_in(Geometry::Plane, foundation, roughness, half_width, body)
    }

    /// The same in another geometry; `half_width` is the outer half-width of a pair, the radius of a circular punch.
    ///
    /// # Errors
    /// Those of [`Scaling::new`]; [`Error::InvalidValue`] for lengths that do not fit together.
    pub fn physical_in(
        geometry: Geometry,
        foundation: Elastic,
        roughness: impl Into<Roughness>,
        half_width: f64,
        body: Option<Elastic>,
    ) -> Result<Self, Error> {
        let roughness = roughness.into();
        let scaling =
            Scaling::in_geometry(&foundation, roughness, half_width, body.as_ref(), geometry)?;
        Ok(Self::Physical {
            foundation,
            grading: None,
            layering: None,
            body,
            roughness,
            geometry,
            scaling,
        })
    }

    /// A foundation whose modulus grows with depth under a rigid punch, plane, pair or circular. Pressures are scaled by the modulus at the
    /// depth `a`; [`Grading::response`] gives `theta0`, `response a E(a)` over the scale of displacements. The settlement is zero at infinity.
    ///
    /// With the exponent 0 this is the homogeneous problem of [`Frame::physical_in`], in a plane with its gauge `ln(a/|x-s|)`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a Poisson's ratio that is none, a periodic geometry, where settlements of a graded body add up to infinity, and
    /// what [`Frame::physical_in`] refuses.
    pub fn physical_graded(
        geometry: Geometry,
        grading: Grading,
        poisson_ratio: f64,
        roughness: impl Into<Roughness>,
        half_width: f64,
    ) -> Result<Self, Error> {
        if grading.is_homogeneous() {
            let foundation = Elastic::new(grading.modulus(), poisson_ratio)?;
            return Self::physical_in(geometry, foundation, roughness, half_width, None);
        }
        require(
            !matches!(geometry, Geometry::Periodic { .. }),
            "grading_exponent",
            grading.exponent(),
            "0 (homogeneous) for a periodic row: the settlements that its punches give each other add up to infinity",
        )?;
        positive("half_width", half_width)?;
        let roughness = roughness.into();
        let foundation = Elastic::new(grading.modulus_at(half_width), poisson_ratio)?;
        let response = grading.response(poisson_ratio, half_width, geometry == Geometry::Circular);
        let moduli = [foundation.young_modulus(), foundation.plane_strain_modulus()];
        let scaling = Scaling::with_response(response, moduli, roughness, half_width, geometry)?;
        let grading = Some(grading);
        Ok(Self::Physical {
            foundation,
            grading,
            layering: None,
            body: None,
            roughness,
            geometry,
            scaling,
        })
    }

    /// The dimensionless problem at `theta0`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `theta0` is finite and not negative.
    pub fn dimensionless(theta0: f64) -> Result<Self, Error> {
        Self::dimensionless_in(Geometry::Plane, theta0, 1.0)
    }

    /// The same in another geometry, lengths in half-widths, with the law `p0^exponent` of the layer.
    ///
    /// # Errors
    /// [`Error::InvalidValue`].
    pub fn dimensionless_in(geometry: Geometry, theta0: f64, exponent: f64) -> Result<Self, Error> {
        require(theta0.is_finite() && theta0 >= 0.0, "theta0", theta0, "finite and not negative")?;
        geometry.check(1.0)?;
        let law = Roughness::power(1.0, exponent)?.law();
        Ok(Self::Dimensionless { theta0, law, geometry, layering: None })
    }

    /// The same with a foundation in two pieces: a [`Layering`], lengths in the units of the problem. Material and `theta0` of the frame are those of the layer, or of what lies below a coating.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a thickness below 0.002 half-widths (0.05 radii), and for what is not solved on such ground: a smooth surface, a periodic row, a coating under a circular
    /// punch, an elastic punch, grading.
    pub fn layered(mut self, on: Layering) -> Result<Self, Error> {
        let geometry = self.geometry();
        let (is_circular, is_coated) = (self.is_circular(), matches!(on, Layering::Coating { .. }));
        require_thickness(&on, self.half_width(), is_circular)?;
        let refuse = |refused: bool, requirement: &'static str| {
            require(!refused, "thickness", on.thickness(), requirement).map(|_| ())
        };
        refuse(
            matches!(geometry, Geometry::Periodic { .. }),
            "left out for a periodic row: layers and coatings are solved under one punch and a pair",
        )?;
        refuse(
            is_coated && is_circular,
            "left out under a circular punch: coatings are solved under one plane punch and a pair",
        )?;
        require(self.law() != Law::Smooth, "roughness", 0.0, ROUGH_ONLY)?;
        refuse(self.grading().is_some(), "left out of a graded foundation")?;
        match &mut self {
            Self::Physical { body: Some(_), .. } => {
                refuse(
                    true,
                    "left out under an elastic punch, which has no composite modulus with it",
                )?;
            }
            Self::Physical { layering, .. } | Self::Dimensionless { layering, .. } => {
                *layering = Some(on);
            }
        }
        Ok(self)
    }

    /// A layer of finite thickness or a coating; `None` for a foundation of one piece.
    #[must_use]
    pub fn layering(&self) -> Option<Layering> {
        match self {
            Self::Physical { layering, .. } | Self::Dimensionless { layering, .. } => *layering,
        }
    }

    /// Whether the foundation is a half-space of one material.
    #[must_use]
    pub fn is_homogeneous(&self) -> bool {
        self.grading().is_none() && self.layering().is_none()
    }

    /// `theta0`; of a smooth surface, where its scale is undefined, a number of internal use.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        match self {
            Self::Physical { scaling, .. } => scaling.theta0(),
            Self::Dimensionless { theta0, .. } => *theta0,
        }
    }

    /// The scales of a physical problem.
    #[must_use]
    pub fn scaling(&self) -> Option<&Scaling> {
        match self {
            Self::Physical { scaling, .. } => Some(scaling),
            Self::Dimensionless { .. } => None,
        }
    }

    /// The geometry, lengths in the units of the problem.
    #[must_use]
    pub fn geometry(&self) -> Geometry {
        match self {
            Self::Physical { geometry, .. } | Self::Dimensionless { geometry, .. } => *geometry,
        }
    }

    /// How the modulus of the foundation grows with depth; `None` for a homogeneous one.
    #[must_use]
    pub fn grading(&self) -> Option<Grading> {
        match self {
            Self::Physical { grading, .. } => *grading,
            Self::Dimensionless { .. } => None,
        }
    }

    /// The law of the rough layer without dimensions.
    #[must_use]
    pub fn law(&self) -> Law {
        match self {
            Self::Physical { roughness, .. } => roughness.law(),
            Self::Dimensionless { law, .. } => *law,
        }
    }

    /// What the settlement is measured against.
    #[must_use]
    pub fn gauge(&self) -> &'static str {
        match self.layering() {
            Some(layering) => layering.gauge(),
            None if self.grading().is_some() => "zero at infinity",
            None => self.geometry().gauge(),
        }
    }

    /// `beta` of the pressure `K/(sqrt(2 pi) d^beta)` at the distance `d` from a corner of a smooth surface: 1/2, on graded ground `(1-mu)/2`.
    #[must_use]
    pub fn corner_exponent(&self) -> f64 {
        0.5 * (1.0 - self.grading().map_or(0.0, |grading| grading.exponent()))
    }

    /// The unit of that `K`, `Pa sqrt(m)` or `Pa m^beta`.
    #[must_use]
    pub fn corner_unit(&self) -> DisplayUnit {
        if self.grading().is_none() {
            return DisplayUnit::prefixed("Pa sqrt(m)");
        }
        let beta = engineering(self.corner_exponent(), Dimension::NONE);
        DisplayUnit::prefixed(&format!("Pa m^{beta}"))
    }

    /// Whether force and moment are those of a disk (N, N m), not per unit length.
    #[must_use]
    pub fn is_circular(&self) -> bool {
        self.geometry() == Geometry::Circular
    }

    /// The pieces of the base as `xi`.
    #[must_use]
    pub fn pieces(&self) -> Vec<[f64; 2]> {
        self.geometry().pieces(self.half_width())
    }

    /// Half-width in the units of the problem: metres, or 1.
    #[must_use]
    pub fn half_width(&self) -> f64 {
        self.scaling().map_or(1.0, Scaling::half_width)
    }

    /// Name of the coordinate in the units of the problem: `x` or `xi`.
    #[must_use]
    pub fn coordinate(&self) -> &'static str {
        if self.scaling().is_some() { "x" } else { "xi" }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn a_graded_foundation_is_scaled_by_its_response() {
        let (mu, nu, chi, a) = (0.3, 0.25, 2e-10, 0.4);
        let grading = Grading::new(mu, 50e6).unwrap();
        let plane = Frame::physical_graded(Geometry::Plane, grading, nu, chi, a).unwrap();
        // u = theta_g P |x|^-mu: what p = E(a) p0 on the strip of xi gives, over chi E(a)
        let expected = grading.line_response(nu) * a.powf(1.0 - mu) / chi;
        assert!((plane.theta0() / expected - 1.0).abs() < 1e-14);
        assert_eq!(plane.grading(), Some(grading));
        let scaling = plane.scaling().unwrap();
        assert!((scaling.pressure() / (50e6 * 0.4f64.powf(0.3)) - 1.0).abs() < 1e-15);

        // Far from a disk of radius a under p0 = 1 the settlement is that of a point load: J_0(xi t) alone counts, int t^mu J_0(xi t) dt =
        // 2^mu Gamma((1+mu)/2)/Gamma((1-mu)/2) xi^-(1+mu).
        let disk = Frame::physical_graded(Geometry::Circular, grading, nu, chi, a).unwrap();
        let xi = 7.0f64;
        let kernel = 2f64.powf(mu) * libm::tgamma(0.5 + 0.5 * mu) / libm::tgamma(0.5 - 0.5 * mu)
            * xi.powf(-1.0 - mu);
        let (far, pressure) = (disk.theta0() * PI * kernel * 0.5, scaling.pressure());
        let point = grading.point_response(nu) * PI * a * a * pressure * (xi * a).powf(-1.0 - mu);
        assert!((far * chi * pressure / point - 1.0).abs() < 1e-14);
    }

    #[test]
    fn grading_of_exponent_zero_is_homogeneous() {
        let grading = Grading::new(0.0, 2e9).unwrap();
        for geometry in [Geometry::Plane, Geometry::Circular, Geometry::Periodic { period: 3.0 }] {
            let graded = Frame::physical_graded(geometry, grading, 0.3, 1e-12, 0.5).unwrap();
            let material = Elastic::new(2e9, 0.3).unwrap();
            let plain = Frame::physical_in(geometry, material, 1e-12, 0.5, None).unwrap();
            assert_eq!(graded, plain);
        }
        let graded = Grading::new(0.4, 2e9).unwrap();
        let row = Geometry::Periodic { period: 3.0 };
        assert!(Frame::physical_graded(row, graded, 0.3, 1e-12, 0.5).is_err());
        assert!(Frame::physical_graded(Geometry::Plane, graded, 0.7, 1e-12, 0.5).is_err());
        assert!(Frame::physical_graded(Geometry::Plane, graded, 0.3, 1e-12, -0.5).is_err());
    }
}
