//! From what is known of a rough surface to the law of the rough layer, [`Roughness`](crate::Roughness).
//!
//! Three ways: asperities of Gaussian height ([`GreenwoodWilliamson`]), the bearing curve of a surface ([`BearingCurve`]), pressures measured or
//! computed elsewhere against approaches ([`Table`]). Each gives `v = chi p` or `v = B p^kappa` and says how far the law is from its data
//! ([`Fit`]).
//!
//! ```
//! use shtaerman::asperities::GreenwoodWilliamson;
//!
//! // Standard deviation 0.5 um, 1e10 asperities per m^2 of radius 20 um, E* = 110 GPa; the surface works at 50 MPa.
//! let surface = GreenwoodWilliamson::new(0.5e-6, 1e10, 20e-6, 110e9)?;
//! let chi = surface.compliance(50e6)?;
//! assert!(chi > 1e-15 && chi < 1e-14);
//! # Ok::<(), shtaerman::Error>(())
//! ```

mod bearing;
mod fit;
mod gaussian;
mod greenwood_williamson;
mod table;

pub use bearing::{BearingCurve, BearingFit};
pub use fit::Fit;
pub use greenwood_williamson::GreenwoodWilliamson;
pub use table::{Table, TableOrder, open_table, open_trace, read_table, read_trace};
