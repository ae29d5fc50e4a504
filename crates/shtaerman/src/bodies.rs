//! The two bodies in contact: units, material, layer and geometry of a problem together, which its equation needs besides profile and load.

use crate::error::require;
use crate::foundation::{GroundKind, corner_exponent, corner_unit, stands_for_all};
use crate::layering::require_thickness;
use crate::quantity::DisplayUnit;
use crate::roughness::Law;
use crate::{Elastic, Error, Foundation, Geometry, Grading, Layering, Punch, Roughness, Scaling};

/// Why a surface on layered ground has to be rough.
const ROUGH_ONLY: &str = "greater than zero on a layer of finite thickness, under a coating and on an influence function: smooth contact is not solved there";

/// `theta0` of a surface that is nearly smooth and can be solved: of nine circular problems that are refused as smooth ones (`benches/plausible/run.py`) all are solved with it, eight in up to 4 s, and settle by up to 8e-4 more than with a tenth of
/// that roughness; with a hundredth of it four are refused (survey).
const NEARLY_SMOOTH: f64 = 1e4;

/// The bodies in contact, in the units in which their problem is stated.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Bodies {
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

impl Bodies {
    /// A punch on a foundation, without its profile.
    ///
    /// On graded ground pressures are scaled by the modulus at the depth `a`; [`Grading::response`] gives `theta0`, `response a E(a)` over the scale of
    /// displacements, and the settlement is zero at infinity.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for scales beyond the range of double precision, and what does not go together: a graded foundation with an elastic punch or under a
    /// periodic row, where settlements add up to infinity; a dimensionless one with an elastic punch or with a half-width other than 1.
    pub(crate) fn new(foundation: &Foundation, punch: &Punch) -> Result<Self, Error> {
        let bodies = Self::in_one_piece(foundation, punch)?;
        match foundation.layering() {
            Some(layering) => bodies.layered(layering.clone()),
            None => Ok(bodies),
        }
    }

    fn in_one_piece(foundation: &Foundation, punch: &Punch) -> Result<Self, Error> {
        let (roughness, geometry) = (foundation.roughness(), punch.geometry());
        let (half_width, body) = (punch.half_width(), punch.body());
        let (foundation, grading, scaling) = match foundation.ground() {
            GroundKind::Homogeneous(material) => {
                let body = body.as_ref();
                let scaling =
                    Scaling::in_geometry(&material, roughness, half_width, body, geometry);
                (material, None, scaling?)
            }
            GroundKind::Graded(grading, poisson_ratio) => {
                require(
                    body.is_none(),
                    "grading_exponent",
                    grading.exponent(),
                    "0 (homogeneous) under an elastic punch: with a graded foundation it has no composite modulus",
                )?;
                require(
                    !matches!(geometry, Geometry::Periodic { .. }),
                    "grading_exponent",
                    grading.exponent(),
                    "0 (homogeneous) for a periodic row: the settlements that its punches give each other add up to infinity",
                )?;
                let material = Elastic::new(grading.modulus_at(half_width), poisson_ratio)?;
                let is_circular = geometry == Geometry::Circular;
                let response = grading.response(poisson_ratio, half_width, is_circular);
                let moduli = [material.young_modulus(), material.plane_strain_modulus()];
                let scaling =
                    Scaling::with_response(response, moduli, roughness, half_width, geometry)?;
                (material, Some(grading), scaling)
            }
            GroundKind::Dimensionless(theta0) => {
                let requirement = "1 in a dimensionless problem: its lengths are in half-widths";
                require(half_width == 1.0, "half_width", half_width, requirement)?;
                if body.is_some() {
                    return Err(stands_for_all("body"));
                }
                let law = foundation.law();
                return Ok(Self::Dimensionless { theta0, law, geometry, layering: None });
            }
        };
        let layering = None;
        Ok(Self::Physical { foundation, grading, layering, body, roughness, geometry, scaling })
    }

    /// The same with a foundation in two pieces: a [`Layering`], lengths in the units of the problem. Material and `theta0` are those of the layer, or of what lies below a coating.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a thickness below 0.01 half-widths (0.05 radii), for another material than that of the foundation, and for what is not solved on such ground: a smooth surface, a periodic row, a coating under a circular
    /// punch, an elastic punch, grading.
    fn layered(mut self, on: Layering) -> Result<Self, Error> {
        let geometry = self.geometry();
        let is_circular = self.is_circular();
        let is_plane_only = matches!(on, Layering::Coating { .. } | Layering::Own(_));
        require_thickness(&on, self.half_width(), is_circular)?;
        let refuse = |refused: bool, requirement: &'static str| {
            require(!refused, on.field(), on.thickness(), requirement).map(|_| ())
        };
        refuse(
            matches!(geometry, Geometry::Periodic { .. }),
            "left out for a periodic row: layers and coatings are solved under one punch and a pair",
        )?;
        refuse(
            is_plane_only && is_circular,
            "left out under a circular punch: coatings and influence functions are solved under one plane punch and a pair",
        )?;
        require(self.law() != Law::Smooth, "roughness", 0.0, ROUGH_ONLY)?;
        refuse(self.grading().is_some(), "left out of a graded foundation")?;
        if let Self::Physical { foundation, .. } = &self {
            on.require_material(foundation)?;
        }
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
    pub(crate) fn layering(&self) -> Option<&Layering> {
        match self {
            Self::Physical { layering, .. } | Self::Dimensionless { layering, .. } => {
                layering.as_ref()
            }
        }
    }

    /// Whether the foundation is a half-space of one material.
    #[must_use]
    pub(crate) fn is_homogeneous(&self) -> bool {
        self.grading().is_none() && self.layering().is_none()
    }

    /// What keeps the degenerate kernel from solving their contact: it is one of one plane punch on a linear layer and a half-plane.
    #[must_use]
    pub(crate) fn without_degenerate_kernel(&self) -> Option<&'static str> {
        match self.law() {
            _ if self.geometry() != Geometry::Plane => Some("the geometry is another"),
            _ if self.grading().is_some() => Some("the ground is graded"),
            _ if self.layering().is_some() => Some("the ground is layered"),
            Law::Smooth => Some("the surface is smooth"),
            Law::Linear => None,
            Law::Power { .. } => Some("the layer follows a power law"),
        }
    }

    /// `theta0`; of a smooth surface, where its scale is undefined, a number of internal use.
    #[must_use]
    pub(crate) fn theta0(&self) -> f64 {
        match self {
            Self::Physical { scaling, .. } => scaling.theta0(),
            Self::Dimensionless { theta0, .. } => *theta0,
        }
    }

    /// The roughness (m/Pa) in place of 0 that leaves a smooth surface nearly so.
    pub(crate) fn small_roughness(&self) -> Option<f64> {
        let scaling = self.scaling().filter(|_| self.law() == Law::Smooth)?;
        // The scale of displacements is that with which theta0 would be 1.
        let roughness = scaling.displacement() / (NEARLY_SMOOTH * scaling.pressure());
        format!("{roughness:.0e}").parse().ok().filter(|rounded: &f64| rounded.is_normal())
    }

    /// The scales of a physical problem.
    #[must_use]
    pub(crate) fn scaling(&self) -> Option<&Scaling> {
        match self {
            Self::Physical { scaling, .. } => Some(scaling),
            Self::Dimensionless { .. } => None,
        }
    }

    /// A scale of a physical problem; 1 of a dimensionless one.
    pub(crate) fn unit(&self, of: impl Fn(&Scaling) -> f64) -> f64 {
        self.scaling().map_or(1.0, of)
    }

    /// The geometry, lengths in the units of the problem.
    #[must_use]
    pub(crate) fn geometry(&self) -> Geometry {
        match self {
            Self::Physical { geometry, .. } | Self::Dimensionless { geometry, .. } => *geometry,
        }
    }

    /// How the modulus of the foundation grows with depth; `None` for a homogeneous one.
    #[must_use]
    pub(crate) fn grading(&self) -> Option<Grading> {
        match self {
            Self::Physical { grading, .. } => *grading,
            Self::Dimensionless { .. } => None,
        }
    }

    /// Young's modulus of the foundation as it is stated (Pa): of a graded one that at the depth of 1 m. 1 of a dimensionless one.
    #[must_use]
    pub(crate) fn stated_modulus(&self) -> f64 {
        match self {
            Self::Physical { foundation, grading, .. } => {
                grading.map_or(foundation.young_modulus(), |grading| grading.modulus())
            }
            Self::Dimensionless { .. } => 1.0,
        }
    }

    /// The law of the rough layer without dimensions.
    #[must_use]
    pub(crate) fn law(&self) -> Law {
        match self {
            Self::Physical { roughness, .. } => roughness.law(),
            Self::Dimensionless { law, .. } => *law,
        }
    }

    /// What the settlement is measured against.
    #[must_use]
    pub(crate) fn gauge(&self) -> &'static str {
        match self.layering() {
            Some(layering) => layering.gauge(),
            None if self.grading().is_some() => "zero at infinity",
            None => self.geometry().gauge(),
        }
    }

    /// `beta` of the pressure `K/(sqrt(2 pi) d^beta)` at the distance `d` from a corner of a smooth surface: 1/2, on graded ground `(1-mu)/2`.
    #[must_use]
    pub(crate) fn corner_exponent(&self) -> f64 {
        corner_exponent(self.grading())
    }

    /// The unit of that `K`, `Pa sqrt(m)` or `Pa m^beta`.
    #[must_use]
    pub(crate) fn corner_unit(&self) -> DisplayUnit {
        corner_unit(self.grading())
    }

    /// Whether force and moment are those of a disk (N, N m), not per unit length.
    #[must_use]
    pub(crate) fn is_circular(&self) -> bool {
        self.geometry() == Geometry::Circular
    }

    /// The pieces of the base as `xi`.
    #[must_use]
    pub(crate) fn pieces(&self) -> Vec<[f64; 2]> {
        self.geometry().pieces(self.half_width())
    }

    /// Half-width in the units of the problem: metres, or 1.
    #[must_use]
    pub(crate) fn half_width(&self) -> f64 {
        self.unit(Scaling::half_width)
    }

    /// Name of the coordinate in the units of the problem: `x` or `xi`.
    #[must_use]
    pub(crate) fn coordinate(&self) -> &'static str {
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
        let ground = Foundation::graded(grading, nu).unwrap().with_roughness(chi).unwrap();
        let plane = Bodies::new(&ground, &Punch::new(a).unwrap()).unwrap();
        // u = theta_g P |x|^-mu: what p = E(a) p0 on the strip of xi gives, over chi E(a)
        let expected = grading.line_response(nu) * a.powf(1.0 - mu) / chi;
        assert!((plane.theta0() / expected - 1.0).abs() < 1e-14);
        assert_eq!(plane.grading(), Some(grading));
        let scaling = plane.scaling().unwrap();
        assert!((scaling.pressure() / (50e6 * 0.4f64.powf(0.3)) - 1.0).abs() < 1e-15);

        // Far from a disk of radius a under p0 = 1 the settlement is that of a point load: J_0(xi t) alone counts, int t^mu J_0(xi t) dt =
        // 2^mu Gamma((1+mu)/2)/Gamma((1-mu)/2) xi^-(1+mu).
        let disk = Bodies::new(&ground, &Punch::circular(a).unwrap()).unwrap();
        let xi = 7.0f64;
        let kernel = 2f64.powf(mu) * libm::tgamma(0.5 + 0.5 * mu) / libm::tgamma(0.5 - 0.5 * mu)
            * xi.powf(-1.0 - mu);
        let (far, pressure) = (disk.theta0() * PI * kernel * 0.5, scaling.pressure());
        let point = grading.point_response(nu) * PI * a * a * pressure * (xi * a).powf(-1.0 - mu);
        assert!((far * chi * pressure / point - 1.0).abs() < 1e-14);
    }

    #[test]
    fn what_does_not_go_together_is_refused() {
        let graded = Foundation::graded(Grading::new(0.4, 2e9).unwrap(), 0.3).unwrap();
        assert!(Bodies::new(&graded, &Punch::periodic(0.5, 3.0).unwrap()).is_err());
        let elastic = Punch::new(0.5).unwrap().with_body(Elastic::new(2e9, 0.3).unwrap());
        assert!(Bodies::new(&graded, &elastic).is_err());
        let bare = Foundation::dimensionless(1.0).unwrap();
        let error = Bodies::new(&bare, &Punch::new(0.5).unwrap()).unwrap_err();
        assert!(error.to_string().contains("half_width"), "{error}");
        let unit = Punch::new(1.0).unwrap();
        assert!(Bodies::new(&bare, &unit).is_ok());
        assert!(Bodies::new(&bare, &unit.with_body(Elastic::new(1.0, 0.3).unwrap())).is_err());
    }
}
