//! The curves of Fig. 2.

use super::section5::Base;
use super::{printed, reading, truth};
use crate::Error;

/// The largest `lambda0` of the paper's tables.
pub const LARGEST_LAMBDA0: f64 = 100.0;

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
    let truth = truth::Truth::new()?;
    let rows = printed::tables().table1.rows.iter();
    rows.map(|row| curve(&truth, printed::number(&row[0]), count)).collect()
}

/// The curve that Fig. 2 would have for another `lambda0`, from 0 to [`LARGEST_LAMBDA0`].
///
/// # Errors
/// [`Error::InvalidValue`] for another `lambda0`; [`Error::Equation`] should a system fail to factor.
pub fn figure2_curve(lambda0: f64, count: usize) -> Result<Curve, Error> {
    let is_known = (0.0..=LARGEST_LAMBDA0).contains(&lambda0);
    crate::error::require(is_known, "lambda0", lambda0, "from 0 to 100, which the paper has")?;
    curve(&truth::Truth::new()?, lambda0, count)
}

fn curve(truth: &truth::Truth, lambda0: f64, count: usize) -> Result<Curve, Error> {
    let base = Base { constant: 0.0, linear: 0.0, square: 1.0 };
    let mut xi = fredholm::basis::chebyshev::points(count.max(2) - 1);
    xi.reverse();
    let reading = reading::Reading::new(lambda0, base, 45)?;
    let exact = truth.solve(lambda0, base)?;
    Ok(Curve {
        lambda0,
        as_printed: xi.iter().map(|&x| reading.pressure_as_printed(x)).collect(),
        exact: xi.iter().map(|&x| exact.pressure(x)).collect(),
        xi,
    })
}
