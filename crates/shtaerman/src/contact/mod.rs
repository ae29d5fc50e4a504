//! The answer: settlement, tilt, force, moment, pressure, with errors, audit and sensitivities.
//!
//! A [plan](crate::MethodChoice) picks the method. Where the base may lift off the search finds the zones, over equations of the second kind (rough surfaces) or the first (smooth
//! ones); each method hands over a solution, and the solution becomes the [`Contact`].
//!
//! Where the comment of a constant says *survey*, the constant by itself was halved and doubled, and up to 32 problems were solved again that reach it, of 580 drawn at random: every geometry and
//! ground, smooth and rough. An answer *changes* where any of its bits does, and is *lost* where it is refused.

mod accuracy;
mod audit;
mod balance;
mod brackets;
mod cells;
mod check;
mod companion;
mod complementarity;
mod eccentric;
mod edges;
mod ground;
mod heights;
mod intensity;
mod kinks;
mod linearised;
mod method;
pub(crate) mod parts;
mod posed;
mod promise;
mod quantities;
mod rates;
mod resolutions;
mod revolution;
mod rough;
mod route;
mod search;
mod setting;
mod smooth;
mod solution;
mod solve;
mod solved;
mod spectral;
pub(crate) mod steps;
mod stiffness;
mod surface;
mod unaudited;
mod valleys;
mod warning;
mod zones;

pub use crate::warning::{Warning, WarningCode};
pub(crate) use accuracy::Accuracy;
pub use accuracy::ErrorKind;
pub use audit::Audit;
pub use complementarity::Complementarity;
pub(crate) use ground::layered_plane;
pub use method::{Method, MethodName};
pub use quantities::Errors;
pub(crate) use rates::{Linearised, Rates};
pub use solved::Contact;
pub use stiffness::Stiffness;
pub use unaudited::Unaudited;

pub use crate::scaling::Scaling;
