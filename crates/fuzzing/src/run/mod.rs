//! Runs cases, and counts.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use crate::check::Outcome;
use crate::targets::Target;
use crate::{Random, check};

/// Longest time of a case before it counts as a hang, by the clock on the wall: on a busy machine a case may fail by it alone.
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
    /// The longest time of a case by the clock on the wall, and its number.
    pub slowest: (Duration, u64),
}

/// Runs `count` cases of a seed, or fewer where `most` is over before.
#[must_use]
pub fn run(target: Target, seed: u64, count: u64, most: Option<Duration>) -> Report {
    let mut report = Report::default();
    let start = Instant::now();
    let subject = target.subject();
    for case in 0..count {
        if most.is_some_and(|most| start.elapsed() > most) {
            break;
        }
        let began = Instant::now();
        let mut random = Random::new(seed, case);
        let result = catch_unwind(AssertUnwindSafe(|| subject(&mut random)));
        let took = began.elapsed();
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
