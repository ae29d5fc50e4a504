//! The curves of Fig. 2.

use super::section5::Base;
use super::{printed, reading, truth};
use crate::Error;

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
