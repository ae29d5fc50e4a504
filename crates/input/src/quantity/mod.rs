//! Quantities with units: `5 mm`, `200GPa`, `0.1 µm/MPa`, `1 MN/m`.
//!
//! [`parse`] reads a number with a unit into SI, [`Quantity::expect`] checks what it measures, and
//! [`engineering`] writes SI values for people. A number without a unit is in SI units whatever is
//! expected.
//!
//! ```
//! use shtaerman_input::quantity::{Dimension, engineering, parse};
//!
//! let half_width = parse("5 mm")?.expect(Dimension::LENGTH, "half_width", "5 mm")?;
//! assert_eq!(half_width, 0.005);
//! assert_eq!(engineering(3.1234e-6, Dimension::LENGTH), "3.1234 µm");
//!
//! let wrong = parse("5 Pa")?.expect(Dimension::LENGTH, "half_width", "5 Pa");
//! assert_eq!(
//!     wrong.unwrap_err().to_string(),
//!     "half_width is a length (like \"5 mm\"), got Pa, a pressure",
//! );
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Units
//!
//! | what | units |
//! |---|---|
//! | length | `m`, `in`, `ft`, `yd`, `mil` = `thou`, `uin` |
//! | force | `N`, `dyn`, `kgf`, `lbf`, `ozf`, `kip` |
//! | pressure | `Pa`, `bar`, `atm`, `psi`, `ksi`, `Msi`, `psf` |
//! | mass, time, energy | `g`, `t` (1000 kg), `s`, `J` |
//! | angle | `rad`, `deg` = `°` |
//!
//! SI prefixes `p n u µ m c k M G T` go with `m`, `Pa`, `N`, `g`, `s`, `J` and `bar`, besides `dm`
//! and `hPa`; `rad` takes `n u µ m`.

mod dimension;
mod error;
mod format;
mod limits;
mod number;
mod parse;
mod system;
#[cfg(test)]
mod tests;
mod units;
mod value;

pub(crate) use units::spelled_out;

pub use dimension::Dimension;
pub use error::{QuantityError, QuantityErrorKind};
pub use format::{AxisUnit, DisplayUnit, axis_unit, engineering, engineering_with_digits, plain};
pub use limits::{MAXIMUM_LENGTH, MAXIMUM_POWER};
pub use parse::parse;
pub use system::{Measure, OutputUnits};
pub use value::{FieldError, Quantity};
