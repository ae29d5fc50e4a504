//! What is asked and what is answered: a contact problem, an answer to it, and the bounds of its errors or why there are none.

use crate::ground::Ground;
use crate::kernel::Kernel;
use crate::profile::Profile;

/// What the load prescribes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prescribed {
    /// The force `P`; else the settlement is as the answer has it.
    pub force: Option<f64>,
    /// The moment `M`; else the tilt is as the answer has it.
    pub moment: Option<f64>,
}

/// A contact problem without dimensions.
pub struct Problem<'a> {
    /// The kernel.
    pub kernel: Kernel,
    /// What the kernel was made of, if it is that of such ground.
    pub ground: Option<&'a Ground>,
    /// `theta >= 0`.
    pub theta: f64,
    /// What the numbers given for `theta`, the profile and the load may be off by, relative to their sizes: they were scaled.
    pub scaled: f64,
    /// The intervals of the base, from left to right, within `[-1, 1]`.
    pub pieces: &'a [[f64; 2]],
    /// Whether the pressure may pull, and the whole base is in contact.
    pub is_bilateral: bool,
    /// The load.
    pub prescribed: Prescribed,
    /// The base.
    pub profile: &'a dyn Profile,
    /// Places where the pressure bends: panels are cut there. None needs to be known.
    pub cuts: &'a [f64],
}

/// An answer.
pub struct Answer<'a> {
    /// The zones of contact, from left to right.
    pub zones: &'a [[f64; 2]],
    /// The pressure at places of the zones; several threads ask for it.
    pub pressure: &'a (dyn Fn(f64) -> f64 + Sync),
    /// `delta`.
    pub settlement: f64,
    /// `alpha`.
    pub tilt: f64,
    /// `P`.
    pub force: f64,
    /// `M`.
    pub moment: f64,
}

/// Guaranteed bounds of the errors of an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Of the pressure in the mean square, `||p - q||` in `L2` of the base.
    pub mean_square: f64,
    /// Of the pressure at any number of the machine on the base.
    pub pressure: f64,
    /// What the largest pressure is at most, between numbers of the machine as well; none where it is not known.
    pub highest: Option<f64>,
    /// Of the settlement; 0 where it is prescribed.
    pub settlement: f64,
    /// Of the tilt; 0 where it is prescribed.
    pub tilt: f64,
    /// Of the force; 0 where it is prescribed.
    pub force: f64,
    /// Of the moment; 0 where it is prescribed.
    pub moment: f64,
    /// Of the free ends of the zones; none where the contact may have other zones, or no end is free.
    pub ends: Option<f64>,
    /// The norm of the residual.
    pub residual: f64,
    /// Panels of the resampled pressure.
    pub panels: usize,
    /// Windows on which the residual was bounded.
    pub windows: usize,
}

/// Why there is no bound.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// The pressure has no zone, or is not finite.
    #[error("the pressure is not finite")]
    NoPressure,
    /// The pressure is zero everywhere.
    #[error("the pressure vanishes everywhere, so there is no size to hold a residual against")]
    Vanishes,
    /// The pressure needs more panels than are kept.
    #[error("the pressure bends at more places than the audit follows")]
    TooManyPanels,
    /// The residual needs more windows than are kept; it was last looked at here.
    #[error("the residual near xi = {at} changes faster than the audit follows")]
    TooManyWindows {
        /// The place.
        at: f64,
    },
    /// The answer is far from the force or moment that is prescribed.
    #[error("the pressure is far from the prescribed force or moment")]
    LoadNotMet,
    /// The base penetrates where the answer has no contact: the bound is no small one, and most of it comes from here.
    #[error("the base penetrates near xi = {at:.6}, where the answer has no contact")]
    Penetrates {
        /// The place.
        at: f64,
    },
}
