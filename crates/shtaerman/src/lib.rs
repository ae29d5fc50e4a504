//! Contact of a rigid punch with a rough elastic body: Shtaerman's model.
//!
//! `chi p(x) + theta int_{-a}^{a} ln(a/|x-s|) p(s) ds = delta - alpha x - f(x)`, `theta = 2/(pi E*)`   (2.3)
//!
//! with `int p dx = P` and `int x p dx = M`, (2.4): plane strain, small slopes, no friction, adhesion or plasticity. Compression is positive; a
//! positive moment gives a negative tilt; the settlement is in the gauge `ln(a/|x-s|)`, `a` the half-width.
//!
//! A flat steel punch on a ground steel surface:
//!
//! ```
//! use shtaerman::{Elastic, Frame, Load, Problem, Profile, Rotational, Solver, Vertical};
//!
//! let steel = Elastic::new(200e9, 0.3)?;
//! let frame = Frame::physical(steel, 1.2e-14, 5e-3, None)?;      // chi (m/Pa), a (m), rigid punch
//! let load = Load::new(Vertical::Force(0.8e6), Rotational::Moment(0.0))?;
//! let problem = Problem::new(frame, Profile::flat(), load, Solver::default())?;
//! let contact = problem.solve()?;
//!
//! assert!((contact.mean_pressure() - 80e6).abs() < 1.0);
//! let (peak, place) = contact.peak_pressure();
//! assert!(peak > 1.2 * contact.mean_pressure() && place == -5e-3);   // at the edges, and finite
//! assert_eq!(contact.edges(), [[-5e-3, 5e-3]]);   // the full base touches
//! assert!(contact.tilt().abs() < 1e-18);
//! # Ok::<(), shtaerman::Error>(())
//! ```
//!
//! Equation numbers are those of S. M. Mkhitaryan, *On the solution to integral equations of one class of mixed and
//! contact problems by the degenerate kernel method*, Proceedings of NAS of Armenia, Mechanics.

mod answer;
pub mod asperities;
mod audit;
mod columns;
mod contact;
pub mod convergence;
mod datum;
pub mod document;
pub mod equation;
mod error;
pub mod expression;
pub mod file;
mod foundation;
mod frame;
mod geometry;
mod grading;
pub mod inverse;
mod load;
mod material;
mod nearest;
pub mod paper;
mod problem;
pub mod profile;
mod punch;
pub mod quantity;
mod roughness;
mod scaling;
mod sensitivity;
mod solver;
mod stress;
mod surface_curve;
mod variation;

pub use answer::{
    Answer, AuditFigures, AuditReport, ErrorReport, MethodReport, PhysicalOnly, PressureCurve,
    Quantities, SCHEMA,
};
pub use audit::{Audit, Unaudited};
pub use contact::{
    AIM, Complementarity, Contact, CrossCheck, ErrorKind, Errors, Method, ReferenceError,
    Stiffness, Warning, WarningCode,
};
pub use convergence::Convergence;
pub use datum::{Datum, RelativeSettlement};
pub use error::Error;
pub use foundation::Foundation;
pub use geometry::Geometry;
pub use grading::Grading;
pub use load::{Load, Rotational, Vertical};
pub use material::Elastic;
pub use problem::Problem;
pub use profile::Profile;
pub use punch::Punch;
pub use roughness::{Law, Roughness};
pub use scaling::Scaling;
pub use sensitivity::{Derivatives, Sensitivities};
pub use solver::{ContactKind, MethodChoice, Solver};
pub use stress::{Criterion, FirstYield, Peak, Stress, StressField};
pub use surface_curve::SurfaceCurve;
