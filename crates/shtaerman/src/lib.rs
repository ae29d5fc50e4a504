//! Contact of a rigid punch with a rough elastic body: Shtaerman's model.
//!
//! `chi p(x) + theta int_{-a}^{a} ln(a/|x-s|) p(s) ds = delta - alpha x - f(x)`, `theta = 2/(pi E*)`   (2.3)
//!
//! with `int p dx = P` and `int x p dx = M`, (2.4): plane strain, small slopes, no friction, adhesion or plasticity. Compression is positive; a
//! positive moment gives a negative tilt; the settlement is in the gauge `ln(a/|x-s|)`, `a` the half-width.
//!
//! Five types lead from a problem to its answer: a [`Foundation`] (material and roughness), a [`Punch`] (geometry, profile, elastic or rigid) and a [`Load`] make a
//! [`Problem`], and its [`solve`](Problem::solve) gives a [`Contact`]. A [`Solver`] beside them says how, where that matters. A flat steel punch on a ground steel surface:
//!
//! ```
//! use shtaerman::{Elastic, Foundation, Load, Problem, Punch};
//!
//! let steel = Foundation::new(Elastic::new(200e9, 0.3)?).with_roughness(1.2e-14)?;   // Pa, m/Pa
//! let flat = Punch::new(5e-3)?;                                                      // m
//! let contact = Problem::new(steel, flat, Load::force(0.8e6)?)?.solve()?;            // N/m
//!
//! assert!((contact.mean_pressure() - 80e6).abs() < 1.0);
//! assert!(contact.peak_pressure() > 1.2 * contact.mean_pressure());
//! assert_eq!(contact.peak_pressure_at(), -5e-3);   // at the edges, and finite
//! assert_eq!(contact.zones(), [[-5e-3, 5e-3]]);    // the full base touches
//! assert!(contact.tilt().abs() < 1e-18);
//! # Ok::<(), shtaerman::Error>(())
//! ```
//!
//! Names are those of the problem file ([`mod@file`] reads it) and of the JSON answer ([`answer`] writes it). The rest is in modules: [`profile`] and [`expression`] for bases,
//! [`material`] for what a foundation is made of, [`contact`] for what an answer is made of, [`stress`] below the surface, [`inverse`] for the way back from a wish to
//! a problem, [`asperities`] for measured roughness, [`finite_elements`] for tables that other programs read, [`equation`] for integral equations without mechanics.
//!
//! Equation numbers are those of S. M. Mkhitaryan, *On the solution to integral equations of one class of mixed and
//! contact problems by the degenerate kernel method*, Proceedings of NAS of Armenia, Mechanics.

pub mod answer;
pub mod asperities;
mod audited;
mod bodies;
pub mod contact;
mod deadline;
pub mod equation;
mod error;
mod extremes;
pub mod file;
pub mod finite_elements;
mod foundation;
mod geometry;
mod golden;
mod grading;
mod heap;
mod influence;
mod intervals;
pub mod inverse;
mod latest;
mod layering;
mod line_search;
pub mod load;
mod lower_hull;
pub mod material;
mod order;
pub mod paper;
mod problem;
pub mod profile;
pub mod punch;
mod roughness;
mod rounding;
mod scaling;
mod sensitivity;
pub mod solver;
pub mod stress;
mod sweep;
mod variation;
mod warning;

#[doc(inline)]
pub use contact::Contact;
pub use error::Error;
pub use foundation::Foundation;
pub use heap::keep_freed_blocks;
#[doc(inline)]
pub use load::Load;
pub use problem::Problem;
#[doc(inline)]
pub use punch::Punch;
#[doc(inline)]
pub use sensitivity::{Derivatives, Sensitivities};
#[doc(inline)]
pub use solver::Solver;

#[doc(inline)]
pub use sweep::{LoadSweep, LoadSwept, Swept, SweptErrors, Theta0Sweep};

#[doc(no_inline)]
pub use answer::convergence::{self, Convergence};
#[doc(no_inline)]
pub use answer::{
    Answer, AuditFigures, AuditReport, CrossCheck, Datum, ErrorReport, MethodReport, PhysicalOnly,
    PressureCurve, Quantities, ReferenceError, RelativeSettlement, SCHEMA, SurfaceCurve,
};
#[doc(no_inline)]
pub use contact::{
    Audit, Complementarity, ErrorKind, Errors, Method, MethodName, Scaling, Stiffness, Unaudited,
    Warning, WarningCode,
};
#[doc(no_inline)]
pub use load::{Rotational, Vertical};
#[doc(no_inline)]
pub use material::{Elastic, Grading, Influence, Law, LayerBase, Layering, Roughness};
#[doc(no_inline)]
pub use profile::Profile;
#[doc(no_inline)]
pub use punch::Geometry;
#[doc(no_inline)]
pub use shtaerman_input::{document, expression, legible, quantity};
#[doc(no_inline)]
pub use solver::{AIM, ContactKind, MethodChoice};
#[doc(no_inline)]
pub use stress::{Criterion, FirstYield, Peak, Stress, StressField};

/// The Rust of the chapter *Ten tasks* of the book, which runs with the tests of the documentation.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/src/ten-tasks.md")]
mod ten_tasks {}

/// The Rust of the chapter *Layers and coatings*.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/src/layered.md")]
mod layered {}
