//! Runs cases, and counts.

mod system;

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use crate::check::Outcome;
use crate::targets::Target;
use crate::{Random, check};

pub use system::{forget_memory, memory};

/// Longest time of a case before it counts as a hang.
const HANG: Duration = Duration::from_secs(5);

/// A case that failed.
#[derive(Debug, Clone)]
pub struct Fault {
    /// Its number.
    pub case: u64,
    /// What was wrong.
    pub what: String,
}

/// What became of many cases.
#[derive(Debug, Clone, Default)]
pub struct Report {
    /// How many were run.
    pub cases: u64,
    /// How many inputs were taken; the others were refused with a message, or failed.
    pub accepted: u64,
    /// How many inputs were refused with a message.
    pub refused: u64,
    /// The cases that failed.
    pub faults: Vec<Fault>,
    /// The cases that took too long.
    pub hangs: Vec<(Duration, u64)>,
    /// The longest time of a case, and its number: of the processor where the system tells it, so that a busy machine does not count; of the clock on the wall for what other processes do.
    pub slowest: (Duration, u64),
}

/// Runs these cases of a seed.
#[must_use]
pub fn run(target: Target, seed: u64, cases: Range<u64>) -> Report {
    let mut report = Report::default();
    let subject = target.subject();
    for case in cases {
        let (began, spent) = (Instant::now(), system::processor_time());
        let mut random = Random::of_case(seed, case);
        let result = catch_unwind(AssertUnwindSafe(|| subject(&mut random)));
        let spent = system::processor_time().zip(spent).map(|(after, before)| after - before);
        let took = spent.filter(|_| target.is_alone()).unwrap_or_else(|| began.elapsed());
        report.cases += 1;
        match result {
            Ok(Ok(Outcome::Accepted)) => report.accepted += 1,
            Ok(Ok(Outcome::Refused)) => report.refused += 1,
            Ok(Err(what)) => report.faults.push(Fault { case, what }),
            Err(panic) => report.faults.push(Fault { case, what: check::panicked(&*panic) }),
        }
        if took > HANG {
            report.hangs.push((took, case));
        }
        if took > report.slowest.0 {
            report.slowest = (took, case);
        }
    }
    report
}
