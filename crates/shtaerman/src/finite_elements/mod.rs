//! What a finite-element model takes over from a contact: the rough layer as a table of pressure against overclosure, the penalty stiffness that may stand beside
//! it, and the whole contact as a curve of force against settlement, or of moment against rotation.
//!
//! Finite-element programs join the points of such tables by straight lines, so each table comes with what these lines are off by.
//!
//! ```
//! use shtaerman::finite_elements::{Overclosure, Penalty, force_curve};
//! use shtaerman::{Elastic, Foundation, Load, Problem, Punch, Roughness};
//!
//! let layer = Roughness::power(1e-9, 0.4)?;                                       // v = 1e-9 p^0.4
//! let steel = Foundation::new(Elastic::new(200e9, 0.3)?).with_roughness(layer)?;
//! let problem = Problem::new(steel, Punch::new(5e-3)?, Load::force(0.8e6)?)?;
//! let contact = problem.solve()?;
//!
//! // From zero to ten times the largest pressure, straight lines within a thousandth of the law.
//! let pressures = [contact.mean_pressure(), 10.0 * contact.peak_pressure()];
//! let table = Overclosure::new(layer, pressures, 1e-3)?;
//! assert_eq!(table.points()[0], [0.0, 0.0]);
//! assert!(table.deviation() <= 1e-3);
//!
//! let penalty = Penalty::new(&contact, 1e-2, None)?;
//! assert!(penalty.stiffness > contact.mean_pressure() / (1e-2 * contact.settlement()));
//!
//! let curve = force_curve(&problem, 1.0, 1e-3, None)?;
//! assert_eq!(curve.points[0], [0.0, 0.0]);
//! # Ok::<(), shtaerman::Error>(())
//! ```

mod conditions;
mod curve;
mod input_file;
mod lift_off;
mod overclosure;
mod penalty;
mod units;

pub use conditions::{SHARES, check_problem};
pub use curve::{LoadCurve, force_curve, moment_curve};
pub use input_file::{is_input_file, read_input_file};
pub use overclosure::Overclosure;
pub use penalty::Penalty;
pub use units::Units;
