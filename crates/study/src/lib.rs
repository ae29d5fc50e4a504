//! Studies: one problem file with some of its values varied.
//!
//! A study file is a problem file with a table `[study]`. Each case of the study is the problem with one value for every varied key; its row has these values, the outputs with the errors that
//! are stated for them, and the reason where there is no answer. A case follows from the file and its number alone, so that any part of a study can be computed anywhere, in any order.
//!
//! ```
//! use std::path::Path;
//! use shtaerman_study::Study;
//!
//! let text = r#"
//! [dimensionless]
//! theta0 = 1.0
//! profile = "xi^2"
//! force = 1.0
//! moment = 0
//!
//! [study]
//! vary."dimensionless.theta0" = { from = 1.0, to = 3.0, count = 3 }
//! outputs = ["settlement"]
//! "#;
//! let study = Study::from_bytes(text.as_bytes(), "study.toml", Path::new(""), &[])?;
//! assert_eq!(study.cases(), 3);
//! let row = &study.solve(1..2)[0];
//! assert_eq!(row.inputs[0].to_string(), "2.0");
//! assert!(row.outputs[0].is_finite() && row.errors[0].is_some_and(|error| error < 1e-9));
//! # Ok::<(), shtaerman::Error>(())
//! ```

mod answered;
mod columns;
mod design;
mod distribution;
mod find;
mod indices;
mod output;
mod parts;
mod quantity;
mod read;
mod row;
mod sense;
mod solving;
mod study;
mod summary;
mod variable;
mod way;

pub use columns::Column;
pub use design::Design;
pub use distribution::Distribution;
pub use indices::{Index, Indices};
pub use output::Output;
pub use parts::{Manifest, Part, PartFault};
pub use row::{Input, Row};
pub use sense::Doubt;
pub use study::Study;
pub use summary::{Extreme, Summary};
pub use variable::{Variable, Variation};
