//! How the degenerate kernel converges on a problem: the answer for `n = 8, 16, 32, ...` with observed orders.

use serde::Serialize;

use crate::solver::check_memory;
use crate::{Contact, ContactKind, Error, Law, Problem, Solver, Vertical};

/// The first degree.
pub const FIRST_DEGREE: usize = 8;
/// The last degree: beyond it rounding has long taken over.
const MOST_DEGREE: usize = 1 << 22;
/// A difference below this, relative to the value's scale, is rounding: no order is read off it.
const ROUNDING: f64 = 1e-13;

/// A quantity that is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Settlement, where the force is prescribed.
    Settlement,
    /// Force, where the settlement is prescribed.
    Force,
    /// Pressure at the right edge.
    PressureRight,
    /// Pressure in the middle.
    PressureMiddle,
    /// Pressure at the right edge by the iterated solution: one exact application of the kernel to the degenerate one.
    PressureRightIterated,
}

impl Quantity {
    /// The order of the error in `1/n` that the theory gives: the solution has `(1 -+ xi) ln(1 -+ xi)` at the edges, so its coefficients fall
    /// as `m^-3`.
    #[must_use]
    pub fn expected_order(self) -> f64 {
        match self {
            Self::Settlement | Self::Force | Self::PressureRightIterated => 4.0,
            Self::PressureRight => 2.0,
            Self::PressureMiddle => 3.0,
        }
    }
}

/// One quantity at one degree.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Entry {
    /// The value, in the units of the problem.
    pub value: f64,
    /// `|value(n) - value(n/2)|`.
    pub difference: Option<f64>,
    /// `log2` of the ratio of the last two differences.
    pub order: Option<f64>,
}

/// All quantities at one degree.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// Highest Chebyshev degree.
    pub n: usize,
    /// One entry a quantity, in the order of [`Convergence::quantities`].
    pub entries: Vec<Entry>,
}

/// The table.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Convergence {
    /// What is followed.
    pub quantities: Vec<Quantity>,
    /// One row a degree.
    pub rows: Vec<Row>,
}

impl Convergence {
    /// Solves the problem for `n = 8, 16, ..., ` up to `last`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `last >= 32` (three degrees, one order); [`Error::NoDegenerateKernel`] for what that does not solve: another geometry, a
    /// surface that is smooth or bends, graded ground, a punch that lifts off; whatever [`Problem::solve`] gives.
    pub fn study(problem: &Problem, last: usize) -> Result<Self, Error> {
        crate::error::require(
            last >= 4 * FIRST_DEGREE,
            "max_n",
            last as f64,
            "at least 32: an order takes three degrees",
        )?;
        crate::error::require(last <= MOST_DEGREE, "max_n", last as f64, "at most 4194304")?;
        require_degenerate_kernel(problem)?;
        check_memory(last)?;
        let unknown = match problem.load().vertical {
            Vertical::Force(_) => Quantity::Settlement,
            Vertical::Settlement(_) => Quantity::Force,
        };
        let quantities = vec![
            unknown,
            Quantity::PressureRight,
            Quantity::PressureMiddle,
            Quantity::PressureRightIterated,
        ];
        let degrees = std::iter::successors(Some(FIRST_DEGREE), |n| n.checked_mul(2))
            .take_while(|&n| n <= last);
        let mut rows: Vec<Row> = Vec::new();
        for n in degrees {
            let (contact, iterated) = problem.solve_iterated(n)?;
            let entry = |(i, quantity): (usize, &Quantity)| {
                let before = rows.last().map(|row| &row.entries[i]);
                Entry::after(before, value(*quantity, &contact, iterated))
            };
            let entries = quantities.iter().enumerate().map(entry).collect();
            rows.push(Row { n, entries });
        }
        Ok(Self { quantities, rows })
    }
}

/// Refuses what is not solved by the degenerate kernel.
fn require_degenerate_kernel(problem: &Problem) -> Result<(), Error> {
    let refused = if let Some(found) = problem.bodies().without_degenerate_kernel() {
        let remedy = match problem.bodies().law() {
            Law::Smooth => "give a roughness greater than zero",
            _ => "solve it instead, its error is part of every answer",
        };
        Some((found, remedy))
    } else if problem.solver().contact == ContactKind::Unilateral && lifts_off(problem)? {
        let keep = "contact = \"bilateral\" keeps the full base in contact, and more force may";
        Some(("the punch lifts off", keep))
    } else {
        None
    };
    refused.map_or(Ok(()), |(found, remedy)| Err(Error::NoDegenerateKernel { found, remedy }))
}

/// Whether a unilateral contact is less than the full base.
fn lifts_off(problem: &Problem) -> Result<bool, Error> {
    let solver = Solver { tolerance: None, ..Solver::default() };
    Ok(problem.with_solver(solver).solve()?.dimensionless().zones() != problem.punch().pieces())
}

impl Entry {
    fn after(previous: Option<&Self>, value: f64) -> Self {
        let difference = previous.map(|previous| (value - previous.value).abs());
        let order = previous.and_then(|previous| previous.difference).zip(difference).and_then(
            |(coarse, fine)| {
                let visible = fine > ROUNDING * value.abs();
                visible.then(|| (coarse / fine).log2()).filter(|order| order.is_finite())
            },
        );
        Self { value, difference, order }
    }
}

fn value(quantity: Quantity, contact: &Contact, iterated: f64) -> f64 {
    match quantity {
        Quantity::Settlement => contact.settlement(),
        Quantity::Force => contact.force(),
        Quantity::PressureRight => contact.pressure_right(),
        Quantity::PressureMiddle => contact.pressure_middle(),
        Quantity::PressureRightIterated => iterated,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Foundation, Load, Profile, Punch, Rotational, Solver};

    #[test]
    fn observes_the_orders_of_the_theory() {
        for vertical in [Vertical::Force(0.001), Vertical::Settlement(5.0)] {
            let load = Load::new(vertical, Rotational::Moment(1e-4)).unwrap();
            let profile = Profile::expression("10*xi^2").unwrap();
            let problem = Problem::new(
                Foundation::dimensionless(6.0).unwrap(),
                Punch::new(1.0).unwrap().with_profile(profile),
                load,
            )
            .unwrap()
            .with_solver(Solver::bilateral());
            let study = Convergence::study(&problem, 1024).unwrap();
            assert_eq!(
                study.rows.iter().map(|row| row.n).collect::<Vec<_>>(),
                [8, 16, 32, 64, 128, 256, 512, 1024]
            );
            let last = study.rows.last().unwrap();
            for (quantity, entry) in study.quantities.iter().zip(&last.entries) {
                let order = entry.order.unwrap();
                assert!((order - quantity.expected_order()).abs() < 0.25, "{quantity:?}: {order}");
            }
        }
    }
}
