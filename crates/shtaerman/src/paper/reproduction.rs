//! Each printed figure beside what it should be.

use serde::Serialize;

use super::printed::{self, Half, Table};
use super::reading::Reading;
use super::truth::{Exact, Truth};
use crate::Error;

/// How many printed figures agree: all but one misprint.
const EXPECTED_AGREEING: usize = 143;

/// What a printed figure is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Quantity {
    /// `delta0`.
    #[serde(rename = "delta0")]
    Settlement,
    /// `alpha0`.
    #[serde(rename = "alpha0")]
    Tilt,
    /// `p0(-1)`.
    #[serde(rename = "p0(-1)")]
    PressureLeft,
    /// `p0(1)`.
    #[serde(rename = "p0(1)")]
    PressureRight,
    /// `|M0|` of the level punch.
    #[serde(rename = "M0")]
    Moment,
}

impl Quantity {
    /// As the tables head it.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Settlement => "delta0",
            Self::Tilt => "alpha0",
            Self::PressureLeft => "p0(-1)",
            Self::PressureRight => "p0(1)",
            Self::Moment => "M0",
        }
    }
}

/// Why a printed figure differs from the true one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Reason {
    /// The truncation at `n = 45` or `25` costs the last digits.
    Truncation,
    /// (3.8) was evaluated without `-f0` and with `alpha0` for `theta0`.
    PressureFormula,
    /// The sign of (5.1) was dropped.
    Sign,
    /// A misprint: not even the paper's own computation gives it.
    Misprint,
}

impl Reason {
    /// One line for people.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Truncation => "truncated series",
            Self::PressureFormula => "(3.8) lacks -f0 and has alpha0 for theta0",
            Self::Sign => "(5.1) gives M0 < 0",
            Self::Misprint => "misprint",
        }
    }
}

/// One printed figure.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Figure {
    /// Number of the table.
    pub table: u8,
    /// `f0/lambda0` under which the figure follows (the captions of Tables 1 and 2 are swapped).
    pub profile: &'static str,
    /// `lambda0`, as printed.
    pub lambda0: &'static str,
    /// What it is.
    pub quantity: Quantity,
    /// The figure, as printed.
    pub printed: &'static str,
    /// Computed as the paper computed it.
    pub as_the_paper: f64,
    /// The true value.
    pub exact: f64,
    /// Highest degree of the paper's computation.
    pub n: usize,
    /// Whether the paper's computation gives the printed figure to its last digit.
    pub agrees: bool,
    /// Why the printed figure is not the true one, where it is not.
    pub reason: Option<Reason>,
}

impl Figure {
    /// Given table, profile, `lambda0` and degree, and the figure as the paper computed it and as it is.
    fn new(
        (table, profile, lambda0, n): (u8, &'static str, &'static str, usize),
        quantity: Quantity,
        printed: &'static str,
        [as_the_paper, exact]: [f64; 2],
        reason: Reason,
    ) -> Self {
        let agrees = rounds_to(as_the_paper, printed);
        let reason = (!rounds_to(exact, printed)).then_some(reason);
        Self { table, profile, lambda0, quantity, printed, as_the_paper, exact, n, agrees, reason }
    }
}

/// All printed figures.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reproduction {
    /// Table by table, row by row.
    pub figures: Vec<Figure>,
}

impl Reproduction {
    /// How many figures our run of the paper's computation gives to their last printed digit.
    #[must_use]
    pub fn agreeing(&self) -> usize {
        self.figures.iter().filter(|figure| figure.agrees).count()
    }

    /// Whether the outcome is the known one: 143 of 144, the other a misprint.
    #[must_use]
    pub fn is_as_expected(&self) -> bool {
        self.figures.len() == EXPECTED_AGREEING + 1
            && self.agreeing() == EXPECTED_AGREEING
            && self
                .figures
                .iter()
                .all(|figure| figure.agrees != (figure.reason == Some(Reason::Misprint)))
    }
}

/// Computes every printed figure, as the paper did and as it is.
///
/// # Errors
/// [`Error::Equation`] should a system fail to factor.
pub fn reproduce() -> Result<Reproduction, Error> {
    let tables = printed::tables();
    let truth = Truth::new()?;
    let mut figures = Vec::new();
    for (number, table) in [(1, &tables.table1), (2, &tables.table2)] {
        for row in &table.rows {
            figures.extend(loaded_row(number, table, row, &truth)?);
        }
    }
    for row in &tables.table3.rows {
        figures.extend(level_row(&tables.table3.left, &row[0], &row[1..3], &truth)?);
        figures.extend(level_row(&tables.table3.right, &row[0], &row[3..5], &truth)?);
    }
    Ok(Reproduction { figures })
}

/// A row of Table 1 or 2: the loaded punch.
fn loaded_row(
    number: u8,
    table: &'static Table,
    row: &'static [String],
    truth: &Truth,
) -> Result<Vec<Figure>, Error> {
    use Quantity::{PressureLeft, PressureRight, Settlement, Tilt};
    let (base, lambda0) = (printed::base(&table.profile_over_lambda0), printed::number(&row[0]));
    let reading = Reading::new(lambda0, base, table.n)?;
    let exact: Exact = truth.solve(lambda0, base)?;
    let [settlement, tilt] = reading.displacements();
    let [true_settlement, true_tilt] = exact.displacements();
    let pairs = [
        (Settlement, settlement, true_settlement),
        (Tilt, tilt, true_tilt),
        (PressureLeft, reading.pressure_as_printed(-1.0), exact.pressure(-1.0)),
        (PressureRight, reading.pressure_as_printed(1.0), exact.pressure(1.0)),
    ];
    let figures = pairs.into_iter().zip(&row[1..]).map(|((quantity, computed, exact), printed)| {
        let misprinted = table.misprint.as_ref().is_some_and(|misprint| {
            misprint.lambda0 == row[0] && misprint.column == quantity.symbol()
        });
        let reason = match quantity {
            _ if misprinted => Reason::Misprint,
            PressureLeft | PressureRight => Reason::PressureFormula,
            _ => Reason::Truncation,
        };
        let of = (number, &*table.profile_over_lambda0, &*row[0], reading.degree());
        Figure::new(of, quantity, printed, [computed, exact], reason)
    });
    Ok(figures.collect())
}

/// One half of a row of Table 3: the level punch.
fn level_row(
    half: &'static Half,
    lambda0: &'static str,
    printed: &'static [String],
    truth: &Truth,
) -> Result<Vec<Figure>, Error> {
    let base = printed::base(&half.profile_over_lambda0);
    let reading = Reading::new(printed::number(lambda0), base, half.n)?;
    let exact = truth.solve(printed::number(lambda0), base)?;
    let ([settlement, moment], [true_settlement, true_moment]) = (reading.level(), exact.level());
    // The table prints |M0|.
    let pairs = [
        (Quantity::Settlement, settlement, true_settlement, Reason::Truncation),
        (Quantity::Moment, moment.abs(), true_moment, Reason::Sign),
    ];
    let of = (3, &*half.profile_over_lambda0, lambda0, reading.degree());
    let figures =
        pairs.into_iter().zip(printed).map(|((quantity, computed, exact, reason), printed)| {
            Figure::new(of, quantity, printed, [computed, exact], reason)
        });
    Ok(figures.collect())
}

/// Whether `value`, rounded to the decimals of the printed figure, is that figure.
fn rounds_to(value: f64, printed: &str) -> bool {
    let decimals = printed.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    format!("{value:.decimals$}") == printed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_but_the_misprint_agree() {
        let reproduction = reproduce().unwrap();
        for figure in &reproduction.figures {
            assert!(
                figure.agrees || figure.reason == Some(Reason::Misprint),
                "table {} lambda0 {} {:?}: printed {}, computed {}",
                figure.table,
                figure.lambda0,
                figure.quantity,
                figure.printed,
                figure.as_the_paper
            );
        }
        assert!(reproduction.is_as_expected());
    }

    #[test]
    fn the_true_edge_pressures_pull() {
        // Independent references at lambda0 = 100: symmetric part of p0(1) and settlement.
        let reproduction = reproduce().unwrap();
        let at_100 = |quantity| {
            reproduction
                .figures
                .iter()
                .find(|f| f.table == 1 && f.lambda0 == "100" && f.quantity == quantity)
                .unwrap()
                .exact
        };
        let symmetric = 0.5 * (at_100(Quantity::PressureLeft) + at_100(Quantity::PressureRight));
        assert!((symmetric + 8.99524832047766).abs() < 1e-11, "{symmetric}");
        assert!((at_100(Quantity::Settlement) - 49.2156124973957).abs() < 1e-11);
    }

    #[test]
    fn compares_to_the_last_printed_digit() {
        assert!(rounds_to(7.41744, "7.4174") && !rounds_to(7.41746, "7.4174"));
        assert!(rounds_to(-0.000149, "-0.00015") && !rounds_to(0.000149, "-0.00015"));
    }
}
