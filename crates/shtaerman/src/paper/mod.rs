//! The paper's Tables 1-3 and Fig. 2, reproduced: every printed figure as the paper computed it, slips included, and as it is.
//!
//! ```
//! let reproduction = shtaerman::paper::reproduce()?;
//! assert_eq!((reproduction.agreeing(), reproduction.figures.len()), (143, 144));
//! # Ok::<(), shtaerman::Error>(())
//! ```

mod figure2;
mod printed;
mod reading;
mod reproduction;
mod section5;
mod truth;

pub use figure2::{Curve, LARGEST_LAMBDA0, figure2, figure2_curve};
pub use reproduction::{Figure, Quantity, Reason, Reproduction, reproduce};
pub(crate) use section5::Base;
pub use section5::{FORCE0, MOMENT0, POISSON_RATIO, theta0};
