//! What is put through.

mod arguments;
mod calls;
mod columns;
mod equations;
mod expressions;
mod problems;
mod readers;
mod threads;
mod units;

use std::path::PathBuf;

use crate::check::Outcome;
use crate::{Random, surroundings};

/// One case: made, run and checked. The error says what failed, with the input.
pub(crate) type Subject = fn(&mut Random) -> Result<Outcome, String>;

/// What is put through.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// Problem and equation files, read and not solved.
    Readers,
    /// Formulas: parsed, evaluated, enclosed, searched for breaks.
    Expressions,
    /// Quantities with units: parsed, shown, parsed again.
    Units,
    /// Columns of numbers.
    Columns,
    /// Command lines, parsed and not run.
    Arguments,
    /// Calls of the library, with odd numbers among the arguments.
    Calls,
    /// Problem files, solved with their audit.
    Problems,
    /// Equation files, solved with their audit.
    Equations,
    /// Problem files, solved on many threads at once.
    Threads,
    /// Problem files, solved here and by another program, which the variable `SHTAERMAN_OTHER` names.
    Builds,
    /// The program, ended by signals.
    Signals,
    /// The program in surroundings in which nothing goes well.
    Faults,
}

impl Target {
    /// All of them.
    pub const ALL: [Self; 12] = [
        Self::Readers,
        Self::Expressions,
        Self::Units,
        Self::Columns,
        Self::Arguments,
        Self::Calls,
        Self::Problems,
        Self::Equations,
        Self::Threads,
        Self::Builds,
        Self::Signals,
        Self::Faults,
    ];

    /// Its name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Readers => "readers",
            Self::Expressions => "expressions",
            Self::Units => "units",
            Self::Columns => "columns",
            Self::Arguments => "arguments",
            Self::Calls => "calls",
            Self::Problems => "problems",
            Self::Equations => "equations",
            Self::Threads => "threads",
            Self::Builds => "builds",
            Self::Signals => "signals",
            Self::Faults => "faults",
        }
    }

    /// The target of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|target| target.name() == name)
    }

    /// The program with which [`Builds`](Self::Builds) compares; none where the variable is not set.
    #[must_use]
    pub fn other() -> Option<PathBuf> {
        threads::other()
    }

    /// Whether all is done by the thread that runs a case.
    pub(crate) const fn is_alone(self) -> bool {
        !matches!(self, Self::Threads | Self::Builds | Self::Signals | Self::Faults)
    }

    pub(crate) const fn subject(self) -> Subject {
        match self {
            Self::Readers => readers::case,
            Self::Expressions => expressions::case,
            Self::Units => units::case,
            Self::Columns => columns::case,
            Self::Arguments => arguments::case,
            Self::Calls => calls::case,
            Self::Problems => problems::case,
            Self::Equations => equations::case,
            Self::Threads => threads::threads,
            Self::Builds => threads::builds,
            Self::Signals => surroundings::signal,
            Self::Faults => surroundings::fault,
        }
    }
}
