//! In which units a problem is stated, and on what the punch stands.

use crate::error::require;
use crate::roughness::Law;
use crate::{Elastic, Error, Geometry, Grading, Roughness, Scaling};

/// In which units a problem is stated.
#[derive(Debug, Clone, PartialEq)]
pub enum Frame {
    /// SI units, (2.3).
    Physical {
        /// Material of the foundation; of a graded one at the depth `a`.
        foundation: Elastic,
        /// How the modulus grows with depth; `None` for a homogeneous foundation.
        grading: Option<Grading>,
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
        Ok(Self::Physical { foundation, grading: None, body, roughness, geometry, scaling })
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
        Ok(Self::Dimensionless { theta0, law, geometry })
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
        if self.grading().is_some() { "zero at infinity" } else { self.geometry().gauge() }
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
