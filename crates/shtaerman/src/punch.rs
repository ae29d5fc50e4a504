//! The body that is pressed on the foundation.

use crate::error::positive;
use crate::{Elastic, Error, Profile};

pub use crate::geometry::Geometry;

/// The punch: where it stands on the foundation, the shape of its base, and what it is made of.
///
/// ```
/// use shtaerman::{Elastic, Profile, Punch};
///
/// // A strip of half-width 5 mm with a crown of radius 0.8 m, rigid.
/// let crowned = Punch::new(5e-3)?.with_profile(Profile::expression("x^2 / (2*0.8)")?);
/// assert_eq!(crowned.half_width(), 5e-3);
///
/// // The same base from a closure, on an elastic punch.
/// let bronze = Elastic::new(110e9, 0.34)?;
/// let elastic = Punch::new(5e-3)?.with_profile(Profile::from_fn(|x| x * x / 1.6)).with_body(bronze);
///
/// // A ball of radius 1 m, a pair of rails, a row of them.
/// let ball = Punch::circular(4e-3)?.with_profile(Profile::radial("r^2 / 2")?);
/// let pair = Punch::pair(5e-3, 1e-3)?;        // outer half-width, inner half-gap
/// let row = Punch::periodic(5e-3, 20e-3)?;    // half-width, period
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Punch {
    geometry: Geometry,
    half_width: f64,
    body: Option<Elastic>,
    profile: Profile,
}

impl Punch {
    /// One strip `|x| <= a`, plane strain, rigid and flat; `half_width` is `a` (m), 1 in a dimensionless problem.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the half-width is finite and positive.
    pub fn new(half_width: f64) -> Result<Self, Error> {
        Self::in_geometry(Geometry::Plane, half_width)
    }

    /// A circular punch of this radius (m), rigid and flat.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the radius is finite and positive.
    pub fn circular(radius: f64) -> Result<Self, Error> {
        Self::in_geometry(Geometry::Circular, radius)
    }

    /// Two equal strips of one body, `inner_half_gap <= |x| <= outer_half_width` (m), rigid and flat.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless both are finite and `0 < inner_half_gap < outer_half_width`.
    pub fn pair(outer_half_width: f64, inner_half_gap: f64) -> Result<Self, Error> {
        Self::in_geometry(Geometry::Pair { inner_half_gap }, outer_half_width)
    }

    /// Strips of this half-width (m) that repeat with a period (m) and are loaded alike, rigid and flat. `period = 2 half_width` is a base without gaps.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless both are finite and positive and the strips do not overlap.
    pub fn periodic(half_width: f64, period: f64) -> Result<Self, Error> {
        Self::in_geometry(Geometry::Periodic { period }, half_width)
    }

    /// A rigid flat punch in any geometry; `half_width` is the outer half-width of a pair, the radius of a circular punch.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for lengths that do not fit together.
    pub fn in_geometry(geometry: Geometry, half_width: f64) -> Result<Self, Error> {
        positive("half_width", half_width)?;
        geometry.check(half_width)?;
        Ok(Self { geometry, half_width, body: None, profile: Profile::flat() })
    }

    /// The same with another base. Whether it is finite is checked by [`Problem::new`](crate::Problem::new).
    #[must_use]
    pub fn with_profile(self, profile: Profile) -> Self {
        Self { profile, ..self }
    }

    /// The same of an elastic material.
    #[must_use]
    pub fn with_body(self, body: Elastic) -> Self {
        Self { body: Some(body), ..self }
    }

    /// One strip, a pair, a row or a disk; lengths in the units of the problem.
    #[must_use]
    pub fn geometry(&self) -> Geometry {
        self.geometry
    }

    /// `a`: half-width, outer half-width of a pair, radius of a circular punch.
    #[must_use]
    pub fn half_width(&self) -> f64 {
        self.half_width
    }

    /// The material of an elastic punch; none of a rigid one.
    #[must_use]
    pub fn body(&self) -> Option<Elastic> {
        self.body
    }

    /// The base.
    #[must_use]
    pub fn profile(&self) -> &Profile {
        &self.profile
    }

    /// The pieces of the base from left to right, in half-widths; of a circular one the diameter.
    #[must_use]
    pub fn pieces(&self) -> Vec<[f64; 2]> {
        self.geometry.pieces(self.half_width)
    }
}
