//! Regularity of the infinite systems (3.10) and (3.11) of the logarithmic kernel on `(-1,1)`.
//!
//! The degenerate system `X_k + theta0 sum_m a_m R_km X_m = g_k`, `a_0 = ln 2`, `a_m = 2/m`,
//! `R_km = int_{-1}^{1} T_k T_m`, splits into one of even and one of odd degrees. With the row sums
//! `S_k = theta0 sum_m a_m |R_km|`, an infinite system is
//!
//! - *regular* when every `S_k < 1`,
//! - *completely regular* when every `S_k <= q0` for one `q0 < 1`,
//! - *quasi-completely regular* when this holds for all rows from some row on.
//!
//! Here the row sums have closed forms ([`Row::sum`]) and decrease strictly (proof in the module that holds
//! them, `row.rs`), so their supremum is the sum of the first row: `6 ln 2 - 2` (even) and `5/3` (odd) times
//! `theta0`. Hence regular and completely regular mean the same, the sharp conditions are `theta0 < 0.463202`
//! and `theta0 < 3/5`, and the row where complete regularity begins is found exactly by bisection.
//!
//! Regularity is sufficient for successive approximations and for the method of reduction, not necessary for
//! solvability: the kernel is positive on `(-1,1)`, so every truncated system is solvable for every
//! `theta0 >= 0`.
//!
//! # Rounding
//! A row counts as below a level only when it stays below after its sum is raised by [`ROUNDING_MARGIN`]. A
//! statement of regularity is therefore never owed to rounding; at a level met exactly (`theta0 = 0.6` in the odd
//! system) the answer is "not below".

mod harmonic;
pub mod paper;
mod row;

pub use row::{LAST_ROW, Parity, Row};

/// Relative margin by which a row sum must stay below a level to count, 16 units of rounding.
pub const ROUNDING_MARGIN: f64 = 16.0 * f64::EPSILON;

/// The largest `theta0/q0` for which the first regular row is sought; it lies near `2 theta0/q0`.
///
/// Up to it, the sums of neighbouring rows there differ by more than a hundred times [`ROUNDING_MARGIN`].
pub const LARGEST_RATIO: f64 = 1e12;

/// The most rows a report tabulates.
pub const MOST_ROWS: usize = 1_000_000;

/// Why a question about regularity has no answer.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RegularityError {
    /// `theta0` is negative, infinite or not a number.
    #[error("theta0 must be a finite number, 0 or above, but is {theta0}")]
    Parameter {
        /// The value given.
        theta0: f64,
    },
    /// `q0` is outside `(0, 1]`.
    #[error(
        "the constant q0 of complete regularity must be above 0 and at most 1, but is {constant}"
    )]
    Constant {
        /// The value given.
        constant: f64,
    },
    /// `theta0/q0` is so large that the row cannot be told from its neighbours.
    #[error(
        "theta0/q0 = {theta0:e}/{constant} is too large to tell the first regular row; it may be at most {LARGEST_RATIO:e}"
    )]
    RowTooFar {
        /// The parameter given.
        theta0: f64,
        /// The constant given.
        constant: f64,
    },
    /// More rows were asked for than a table may hold.
    #[error("{rows} rows were asked for; a table holds at most {MOST_ROWS}")]
    TooManyRows {
        /// The number asked for.
        rows: usize,
    },
    /// The system has no row with this index, or none whose sums are offered.
    #[error(
        "the {} system has no row p = {index}; rows run from {} to {LAST_ROW}",
        parity.name(),
        parity.first_index()
    )]
    NoSuchRow {
        /// The system.
        parity: Parity,
        /// The index given.
        index: u64,
    },
}

/// How regular a system is.
///
/// There is no case "regular but not completely": the largest row sum is attained, at the first row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// All row sums are at most `constant < 1`, the sum of the first row.
    CompletelyRegular {
        /// The largest row sum.
        constant: f64,
    },
    /// Only the rows from some row on have sums below 1, and those are at most the first of them.
    QuasiCompletelyRegular {
        /// The Chebyshev degree from which on every row of the system has a sum below 1.
        from_degree: u64,
    },
}

/// A bound of all row sums of a system, and the condition of complete regularity it gives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Condition {
    /// The bound per unit `theta0`.
    pub supremum: f64,
    /// `q0/supremum`: the condition is `theta0 <=` this for `q0 < 1`, and `theta0 <` this for `q0 = 1`.
    pub critical_theta0: f64,
    /// Whether `theta0` meets it, by [`ROUNDING_MARGIN`].
    pub met: bool,
}

impl Condition {
    fn new(supremum: f64, level: Level) -> Self {
        let critical_theta0 = level.constant / supremum;
        Self { supremum, critical_theta0, met: level.holds(supremum) }
    }
}

/// The conditions of complete regularity of one system, from the paper's to the sharp one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conditions {
    /// (4.7) as printed, supremum 2.9074. The paper prints none for the odd system.
    pub printed: Option<Condition>,
    /// (4.7) with the constant of (4.2) corrected, supremum 3.1971; its like for the odd system, 3.2011.
    pub corrected: Condition,
    /// The exact supremum of the majorant (4.1): `6 ln 2 - 2`, and 3 in the odd system.
    pub majorant: Condition,
    /// The exact supremum of the true row sums: `6 ln 2 - 2`, and `5/3` in the odd system.
    pub sharp: Condition,
}

/// The sums of one row, with `theta0` in them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RowSums {
    /// The row's index `p`.
    pub row: u64,
    /// Its Chebyshev degree, `2p` or `2p-1`.
    pub degree: u64,
    /// `S`, the true row sum.
    pub sum: f64,
    /// The right side of (4.1), absolute values taken term by term.
    pub majorant: f64,
    /// `theta0 * 2 ln 2/|4p^2-1|`, 0 in the odd system.
    pub constant_share: f64,
    /// `theta0 S1` of (4.1).
    pub first_sum: f64,
    /// `theta0 S2` of (4.1).
    pub second_sum: f64,
}

impl RowSums {
    fn new(row: Row, theta0: f64) -> Self {
        Self {
            row: row.index(),
            degree: row.degree(),
            sum: theta0 * row.sum(),
            majorant: theta0 * row.majorant(),
            constant_share: theta0 * row.constant_share(),
            first_sum: theta0 * row.first_sum(),
            second_sum: theta0 * row.second_sum(),
        }
    }
}

/// The regularity of one of the two systems.
#[derive(Debug, Clone, PartialEq)]
pub struct SystemReport {
    /// Which system.
    pub parity: Parity,
    /// The sums of its first rows.
    pub rows: Vec<RowSums>,
    /// The conditions of complete regularity with the report's `q0`.
    pub conditions: Conditions,
    /// The least `p` such that every row from `p` on has `S <= q0` (`S < 1` for `q0 = 1`).
    pub first_row: u64,
    /// The Chebyshev degree of that row, `2p` or `2p-1`.
    pub first_degree: u64,
    /// How regular the system is, whatever `q0`.
    pub verdict: Verdict,
}

/// The regularity of the infinite systems (3.10) and (3.11) at one `theta0`.
#[derive(Debug, Clone, PartialEq)]
pub struct RegularityReport {
    /// The parameter `theta0 = a th/chi` of the equation, dimensionless.
    pub theta0: f64,
    /// The constant `q0` of complete regularity the rows and conditions refer to; 1 stands for "below 1".
    pub constant: f64,
    /// The even system (3.10).
    pub even: SystemReport,
    /// The odd system (3.11).
    pub odd: SystemReport,
    /// The least Chebyshev degree from which on the rows of both systems have `S <= q0` (`S < 1` for `q0 = 1`).
    pub first_degree: u64,
    /// How regular the two are together.
    pub verdict: Verdict,
}

impl RegularityReport {
    /// The report for `theta0 >= 0` with `S < 1` as the level, and a table of `rows` rows of each system.
    ///
    /// Costs a fixed number of operations per table row and about 80 row sums for the rest, at any `theta0`.
    ///
    /// # Errors
    /// [`RegularityError::Parameter`], [`RegularityError::RowTooFar`], [`RegularityError::TooManyRows`].
    pub fn new(theta0: f64, rows: usize) -> Result<Self, RegularityError> {
        Self::with_constant(theta0, 1.0, rows)
    }

    /// As [`RegularityReport::new`], with the level `S <= q0` for the first rows and the conditions.
    ///
    /// # Errors
    /// As there, and [`RegularityError::Constant`] for `q0` outside `(0, 1]`.
    pub fn with_constant(theta0: f64, q0: f64, rows: usize) -> Result<Self, RegularityError> {
        if rows > MOST_ROWS {
            return Err(RegularityError::TooManyRows { rows });
        }
        let level = Level::new(theta0, q0)?;
        let unit = Level::new(theta0, 1.0)?;
        let even = system_report(Parity::Even, unit, level, rows);
        let odd = system_report(Parity::Odd, unit, level, rows);
        let verdict = match largest_row_sum(unit) {
            Some(constant) => Verdict::CompletelyRegular { constant },
            None => Verdict::QuasiCompletelyRegular { from_degree: joint_degree(unit) },
        };
        let first_degree = joint_degree(level);
        Ok(Self { theta0, constant: q0, even, odd, first_degree, verdict })
    }
}

/// The first row of a system from which on every row has `theta0 sum_m a_m |R_km| <= q0`, and `< 1` for `q0 = 1`.
///
/// Valid for `0 < q0 <= 1` and `0 <= theta0 <= 1e12 q0`. Exact but for levels met within [`ROUNDING_MARGIN`]: the row
/// sums decrease, so bisection finds it in about 80 row sums. It lies near `2 theta0/q0`.
///
/// # Errors
/// [`RegularityError::Parameter`], [`RegularityError::Constant`], [`RegularityError::RowTooFar`].
pub fn first_regular_row(parity: Parity, theta0: f64, q0: f64) -> Result<Row, RegularityError> {
    Level::new(theta0, q0).map(|level| first_row_below(parity, level))
}

/// A level `q0` for `theta0` times the row sums.
#[derive(Debug, Clone, Copy)]
struct Level {
    theta0: f64,
    constant: f64,
}

impl Level {
    fn new(theta0: f64, constant: f64) -> Result<Self, RegularityError> {
        if !(theta0.is_finite() && theta0 >= 0.0) {
            return Err(RegularityError::Parameter { theta0 });
        }
        if !(constant > 0.0 && constant <= 1.0) {
            return Err(RegularityError::Constant { constant });
        }
        if theta0 / constant > LARGEST_RATIO {
            return Err(RegularityError::RowTooFar { theta0, constant });
        }
        Ok(Self { theta0, constant })
    }

    /// Whether `theta0` times `sum` stays below the level. Divides, so that no tiny product loses digits.
    fn holds(self, sum: f64) -> bool {
        self.theta0 == 0.0 || sum * (1.0 + ROUNDING_MARGIN) <= self.constant / self.theta0
    }
}

fn first_row_below(parity: Parity, level: Level) -> Row {
    let holds = |row: Row| level.holds(row.sum());
    let at = |index: u64| Row::new(parity, index).unwrap_or(Row::first(parity));
    let mut above = parity.first_index();
    if holds(at(above)) {
        return at(above);
    }
    let mut below = 2;
    while below < LAST_ROW && !holds(at(below)) {
        above = below;
        below *= 2;
    }
    while below - above > 1 {
        let middle = above + (below - above) / 2;
        if holds(at(middle)) {
            below = middle;
        } else {
            above = middle;
        }
    }
    at(below)
}

/// The largest row sum of both systems if it is below 1.
fn largest_row_sum(unit: Level) -> Option<f64> {
    let sum = Row::first(Parity::Even).sum().max(Row::first(Parity::Odd).sum());
    unit.holds(sum).then_some(unit.theta0 * sum)
}

/// The degree after the last row of either system above the level, 0 if there is none.
fn joint_degree(level: Level) -> u64 {
    let after_last = |parity: Parity| {
        let row = first_row_below(parity, level);
        if row == Row::first(parity) { 0 } else { row.degree() - 1 }
    };
    after_last(Parity::Even).max(after_last(Parity::Odd))
}

fn system_report(parity: Parity, unit: Level, level: Level, rows: usize) -> SystemReport {
    let first = first_row_below(parity, level);
    let largest = Row::first(parity).sum();
    let verdict = if unit.holds(largest) {
        Verdict::CompletelyRegular { constant: unit.theta0 * largest }
    } else {
        let from_degree = first_row_below(parity, unit).degree();
        Verdict::QuasiCompletelyRegular { from_degree }
    };
    SystemReport {
        parity,
        rows: (parity.first_index()..)
            .take(rows)
            .filter_map(|index| Row::new(parity, index).ok())
            .map(|row| RowSums::new(row, unit.theta0))
            .collect(),
        conditions: conditions(parity, level),
        first_row: first.index(),
        first_degree: first.degree(),
        verdict,
    }
}

fn conditions(parity: Parity, level: Level) -> Conditions {
    let condition = |supremum| Condition::new(supremum, level);
    Conditions {
        printed: match parity {
            Parity::Even => Some(condition(paper::supremum_bound_printed())),
            Parity::Odd => None,
        },
        corrected: condition(paper::supremum_bound(parity)),
        majorant: condition(Row::first(parity).majorant()),
        sharp: condition(Row::first(parity).sum()),
    }
}
