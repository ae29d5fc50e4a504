//! What is to be solved, and why it may not be.

use crate::grid::Break;
use crate::kernel::Kernel;

/// What the rough layer gives under the pressure `p`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Layer {
    /// `p`.
    Linear,
    /// `p^kappa`, `0 < kappa < 1`.
    Power {
        /// `kappa`.
        exponent: f64,
    },
    /// Nothing: a smooth surface, and an equation of the first kind.
    None,
}

/// The vertical half of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Vertical {
    /// `P`.
    Force(f64),
    /// `delta`.
    Settlement(f64),
}

/// The rotational half of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rotational {
    /// `M = int x p dx`.
    Moment(f64),
    /// `e`, `M = e P`.
    Eccentricity(f64),
    /// `alpha`.
    Tilt(f64),
}

/// A contact without dimensions: `v(p) + theta int K p dm = delta - alpha x - f` where `p > 0`.
pub struct Problem<'a> {
    /// The kernel with its measure. Disks are solved on the radius: harmonic 0 has force and settlement, harmonic 1 moment and tilt (and neither height nor settlement).
    pub kernel: Kernel<'a>,
    /// `theta >= 0`.
    pub theta: f64,
    /// The law of the layer.
    pub layer: Layer,
    /// The intervals of the base, from left to right.
    pub pieces: &'a [[f64; 2]],
    /// Whether the whole base is in contact and the pressure may pull.
    pub is_bilateral: bool,
    /// Force or settlement.
    pub vertical: Vertical,
    /// Moment, eccentricity or tilt.
    pub rotational: Rotational,
    /// The height of the base.
    pub base: &'a dyn Fn(f64) -> f64,
    /// Where the base bends, rising. A feature that lies between all nodes of the panels is missed unless a break is beside it.
    pub breaks: &'a [Break],
}

impl Problem<'_> {
    /// `f(x)`; 0 of a first harmonic.
    pub(crate) fn height(&self, x: f64) -> f64 {
        if matches!(self.kernel, Kernel::Disk { harmonic: 1, .. }) { 0.0 } else { (self.base)(x) }
    }

    /// `delta - alpha x - f(x)`.
    pub(crate) fn depth(&self, x: f64, settlement: f64, tilt: f64) -> f64 {
        let [level, arm] = self.kernel.lifts(x);
        settlement * level - tilt * arm - self.height(x)
    }
}

/// Why there is no reference.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Refusal {
    /// It would take more unknowns than are solved for.
    TooLarge {
        /// How many it would take.
        unknowns: usize,
        /// How many there may be.
        most: usize,
    },
    /// The zones did not settle.
    ZonesNotFound,
    /// The base keeps clear of the body.
    NoContact,
    /// Something is not finite.
    NotFinite,
    /// The kernel is nearly as singular as `1/d`: the shortest panels leave too much of its potential.
    TooSingular {
        /// Its exponent.
        exponent: f64,
        /// The largest that it may be.
        most: f64,
    },
    /// The method does not cover it.
    NotCovered(&'static str),
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::TooLarge { unknowns, most } => {
                write!(
                    formatter,
                    "it would take {unknowns} unknowns, and at most {most} are solved for: fewer zones, breaks or measured points would do"
                )
            }
            Self::ZonesNotFound => formatter.write_str("its zones of contact did not settle"),
            Self::NoContact => formatter.write_str("it found no contact"),
            Self::NotFinite => formatter.write_str("it found numbers that are not finite"),
            Self::TooSingular { exponent, most } => {
                write!(
                    formatter,
                    "ground graded by {exponent} asks for shorter panels at the ends of zones than it has: it knows ground graded by {most} at most"
                )
            }
            Self::NotCovered(reason) => formatter.write_str(reason),
        }
    }
}

impl std::error::Error for Refusal {}
