//! The answer: settlement, tilt, force, moment, pressure, with errors, audit and sensitivities.
//!
//! A [plan](crate::MethodChoice) picks the method, each method hands over a draft, and the draft becomes the [`Contact`].

mod accuracy;
mod balance;
mod cells;
mod check;
mod collocated;
mod companion;
mod cross_check;
mod damping;
mod draft;
mod eccentric;
mod edges;
mod extremes;
mod ground;
mod heights;
mod intensity;
mod intervals;
mod kinks;
mod linearised;
mod parts;
mod plan;
mod potential;
mod promise;
mod quantities;
mod resolutions;
mod revolution;
mod search;
mod smooth;
mod solution;
mod solved;
mod spectral;
mod steps;
mod surface;
mod unilateral;
mod valleys;
mod warning;
mod zones;

pub(crate) use accuracy::Accuracy;
pub use accuracy::ErrorKind;
pub use cross_check::{CrossCheck, ReferenceError};
pub(crate) use linearised::{Linearised, Rates};
pub use plan::AIM;
pub use quantities::Errors;
pub use solved::{Contact, Method, Stiffness};
pub use unilateral::Complementarity;
pub use warning::{Warning, WarningCode};

pub use crate::audit::{Audit, Unaudited};
pub use crate::datum::{Datum, RelativeSettlement};
pub use crate::scaling::Scaling;
pub use crate::sensitivity::{Derivatives, Sensitivities};

use draft::Draft;
use plan::Target;
