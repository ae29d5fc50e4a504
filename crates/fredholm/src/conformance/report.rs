//! The outcome of the suite.

use std::fmt;

/// One thing that was checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Check {
    /// What.
    pub name: &'static str,
    /// The worst error found.
    pub error: f64,
    /// The largest that passes.
    pub limit: f64,
}

impl Check {
    /// Whether the error is within its limit; NaN never is.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.error <= self.limit
    }
}

/// What was checked, in order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// The checks.
    pub checks: Vec<Check>,
}

impl Report {
    /// Whether all checks pass.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.checks.iter().all(Check::passes)
    }

    /// Adds the checks of another report.
    pub fn extend(&mut self, other: Self) {
        self.checks.extend(other.checks);
    }

    pub(super) fn add(&mut self, name: &'static str, error: f64, limit: f64) {
        self.checks.push(Check { name, error, limit });
    }
}

impl fmt::Display for Report {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for check in &self.checks {
            let verdict = if check.passes() { "ok" } else { "FAILS" };
            let Check { name, error, limit } = check;
            writeln!(formatter, "{name}: {error:.1e} (at most {limit:.0e}) {verdict}")?;
        }
        Ok(())
    }
}
