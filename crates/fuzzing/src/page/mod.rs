//! The page of the book that tells what was put through.

use std::fmt::Write;

use crate::{Report, Target, forget_memory, memory, run};

const TEMPLATE: &str = include_str!("page.md");

/// Seed of the page: neither one that the generators were tuned on (1 to 99) nor that of the tests.
const SEED: u64 = 103;

/// Cases of each kind of input that is read and not solved, at a share of 1.
const READ: [(Target, u64); 5] = [
    (Target::Units, 4_000_000),
    (Target::Columns, 2_000_000),
    (Target::Expressions, 2_500_000),
    (Target::Arguments, 1_000_000),
    (Target::Readers, 600_000),
];

/// Cases of what is solved.
const SOLVED: [(Target, u64); 3] =
    [(Target::Calls, 3_000), (Target::Problems, 2_000), (Target::Equations, 1_500)];

/// Cases of what needs the whole program, or many threads.
const PROGRAM: [(Target, u64); 3] =
    [(Target::Threads, 100), (Target::Signals, 500), (Target::Faults, 300)];

const BUILDS: u64 = 200;

/// The page, and all that failed, after these shares of the cases: of what is read, of what is solved, and of what needs the whole program. `made` says when and where.
#[must_use]
pub fn page([read, solved, program]: [f64; 3], made: &str) -> (String, Vec<String>) {
    let mut faults = Vec::new();
    let shares = READ.map(|(target, count)| (target, count, read)).into_iter();
    let shares = shares.chain(SOLVED.map(|(target, count)| (target, count, solved)));
    let input = table(shares, &mut faults);
    let program = PROGRAM.map(|(target, count)| (target, count, program));
    let program = table(program.into_iter(), &mut faults);
    let builds = builds(solved, &mut faults);
    let mut page = TEMPLATE.to_owned();
    for (place, text) in [
        ("{MADE}", made),
        ("{INPUT}", &input),
        ("{PROGRAM}", &program),
        ("{BUILDS}", &builds),
        ("{SEED}", &SEED.to_string()),
    ] {
        page = page.replace(place, text);
    }
    (page, faults)
}

fn table(targets: impl Iterator<Item = (Target, u64, f64)>, faults: &mut Vec<String>) -> String {
    let mut text = "| what | cases | taken | refused with a message, or ended | failed | over 5 s | slowest | memory |\n|---|---|---|---|---|---|---|---|\n".to_owned();
    let mut sum = 0;
    for (target, count, share) in targets {
        let report = put_through(target, count, share, faults);
        sum += report.cases;
        let memory =
            memory().map_or_else(|| "?".to_owned(), |size| size.div_ceil(1_000_000).to_string());
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| `{}` | {} | {} | {} | {} | {} | {:.3} s | {memory} MB |",
            target.name(),
            grouped(report.cases),
            grouped(report.accepted),
            grouped(report.refused),
            report.faults.len(),
            report.hangs.len(),
            report.slowest.0.as_secs_f64()
        );
    }
    let _ = write!(text, "\nTogether {} cases.", grouped(sum));
    text
}

fn put_through(target: Target, count: u64, share: f64, faults: &mut Vec<String>) -> Report {
    forget_memory();
    let count = (count as f64 * share).ceil() as u64;
    let report = run(target, SEED, 0..count);
    let name = target.name();
    faults
        .extend(report.faults.iter().map(|fault| format!("{name} {}: {}", fault.case, fault.what)));
    faults.extend(report.hangs.iter().map(|(took, case)| format!("{name} {case}: took {took:?}")));
    report
}

/// What a comparison with another program found, where one is named.
fn builds(share: f64, faults: &mut Vec<String>) -> String {
    let Some(other) = Target::other() else { return String::new() };
    let report = put_through(Target::Builds, BUILDS, share, faults);
    format!(
        "Of {} random problems {} had an answer, which a second build, `{}`, gave as well, within the errors of both; {} differed by more.",
        report.cases,
        report.accepted,
        other.display(),
        report.faults.len()
    )
}

/// A number with commas.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
