//! Problem files: TOML with the place of every value, and overrides of it.
//!
//! A [`Document`] is a TOML file read into a tree that remembers where each value was written, so
//! that a fault found much later can still point at its line. [`Document::set`] overrides values by
//! dotted keys (`--set load.force="1 MN/m"`). A [`TableReader`] takes values out by type, records
//! which keys were asked for and at the end reports those that nobody knows. All faults are one
//! type, [`FileError`].
//!
//! ```
//! use shtaerman_input::document::Document;
//! use shtaerman_input::quantity::Dimension;
//!
//! let text = r#"
//! [punch]
//! half_width = "5 mm"
//! profile = "flat"
//! [load]
//! force = "1 MN/m"
//! "#;
//! let mut document = Document::parse(text, "punch.toml")?;
//! document.set("load.force", "2 MN/m")?;
//!
//! let root = document.reader();
//! let punch = root.required("punch")?.table()?;
//! assert_eq!(punch.required("half_width")?.quantity(Dimension::LENGTH)?, 0.005);
//! assert_eq!(punch.required("profile")?.one_of(&["flat", "parabola"])?, "flat");
//! assert_eq!(punch.quantity("radius", Dimension::LENGTH)?, None);
//! let load = root.required("load")?.table()?;
//! assert_eq!(load.quantity("force", Dimension::FORCE_PER_LENGTH)?, Some(2e6));
//! root.finish()?;
//!
//! let wrong = Document::parse("[punch]\nhalf_width = \"5 Pa\"\n", "punch.toml")?;
//! let punch = wrong.reader().required("punch")?.table()?;
//! let error = punch.quantity("half_width", Dimension::LENGTH).unwrap_err();
//! assert_eq!(
//!     error.to_string(),
//!     "punch.toml:2: punch.half_width: is a length (like \"5 mm\"), got Pa, a pressure",
//! );
//! assert_eq!(error.source_text().unwrap().get(error.span().unwrap()), Some("Pa"));
//! # Ok::<(), shtaerman_input::document::FileError>(())
//! ```

mod attached;
mod bytes;
mod error;
mod field;
mod guard;
mod load;
mod overrides;
mod parsed;
mod reader;
mod source;
#[cfg(test)]
mod tests;
mod value;
mod vocabulary;

pub use attached::Attached;
pub use bytes::overridden;
pub use error::FileError;
pub use field::Field;
pub use guard::{MAXIMUM_KEY_PARTS, MAXIMUM_TOKENS};
pub use load::{MAXIMUM_BYTES, load_bytes, read_bytes};
pub use parsed::Document;
pub use reader::TableReader;
pub use source::Origin;
pub use value::{MAXIMUM_DEPTH, Table, Value, ValueKind};
