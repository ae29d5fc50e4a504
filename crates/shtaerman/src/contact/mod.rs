//! The answer: settlement, tilt, force, moment, pressure.
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

pub use accuracy::{Accuracy, ErrorKind};
pub use cross_check::{CrossCheck, ReferenceError};
pub(crate) use linearised::{Linearised, Rates};
pub use plan::AIM;
pub use smooth::{
    Curve, SmoothContact, SmoothDisk, SmoothDiskContact, SmoothKernel, SmoothProblem,
    SmoothProfile, SmoothRingsContact, SmoothZone,
};
pub use solved::{Contact, Method, Stiffness};
pub use unilateral::Complementarity;
pub use warning::{Warning, WarningCode};

use draft::Draft;
use plan::Target;
