//! The paper's Tables 1-3 and Fig. 2, reproduced: every printed figure as the paper computed it, slips included, and as it is.
//!
//! ```
//! let reproduction = shtaerman::paper::reproduce()?;
//! assert_eq!((reproduction.agreeing(), reproduction.figures.len()), (143, 144));
//! # Ok::<(), shtaerman::Error>(())
//! ```

mod printed;
mod reading;
mod reproduction;
mod truth;

pub use reproduction::{Figure, Quantity, Reason, Reproduction, reproduce};

use crate::Error;

/// Poisson's ratio of sec. 5.
pub const POISSON_RATIO: f64 = 0.25;
/// `P0` of sec. 5.
pub const FORCE0: f64 = 0.001;
/// `M0` that the printed tilts follow from; sec. 5 prints ten times less.
pub const MOMENT0: f64 = 0.0001;

/// `theta0 = 15/(8 pi) lambda0`, sec. 5.
#[must_use]
pub fn theta0(lambda0: f64) -> f64 {
    15.0 / (8.0 * std::f64::consts::PI) * lambda0
}

/// A polynomial base of degree two, over `lambda0`: `f(x)/a` in powers of `xi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Base {
    constant: f64,
    linear: f64,
    square: f64,
}

impl Base {
    fn at(self, xi: f64) -> f64 {
        self.constant + xi * (self.linear + xi * self.square)
    }
}

/// One curve of Fig. 2: the pressure under `f0 = lambda0 xi^2`.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// `lambda0`.
    pub lambda0: f64,
    /// `xi`.
    pub xi: Vec<f64>,
    /// `p0` by (3.8) as printed, `n = 45`.
    pub as_printed: Vec<f64>,
    /// The true `p0`.
    pub exact: Vec<f64>,
}

/// The curves of Fig. 2, one for each row of Table 1, at `count` points from edge to edge, denser at the edges.
///
/// # Errors
/// [`Error::Equation`] should a system fail to factor.
pub fn figure2(count: usize) -> Result<Vec<Curve>, Error> {
    let base = Base { constant: 0.0, linear: 0.0, square: 1.0 };
    let mut xi = fredholm::basis::chebyshev::points(count.max(2) - 1);
    xi.reverse();
    let truth = truth::Truth::new()?;
    printed::tables()
        .table1
        .rows
        .iter()
        .map(|row| {
            let lambda0 = printed::number(&row[0]);
            let reading = reading::Reading::new(lambda0, base, 45)?;
            let exact = truth.solve(lambda0, base)?;
            Ok(Curve {
                lambda0,
                as_printed: xi.iter().map(|&x| reading.pressure_as_printed(x)).collect(),
                exact: xi.iter().map(|&x| exact.pressure(x)).collect(),
                xi: xi.clone(),
            })
        })
        .collect()
}
