//! Holds the stated errors of random problems against a reference that shares no code with the program:
//! `cargo run --release -p shtaerman --example audit_survey -- SEED COUNT [--reference N] [--only INDEX]`
//!
//! `--reference N` compares the first `N` problems only (all without it) and audits the others a second time on halved panels, `--only INDEX` prints and solves one.
//! Bilateral contacts are solved with a few degrees as well, so that the sharpness of bounds shows. Bases, geometries, loads and equations are drawn from the seed alone.

mod coarse;
mod draw;
mod judge;
mod report;

use std::path::PathBuf;
use std::sync::mpsc;
use std::time::{Duration, Instant};

use draw::Case;
use judge::{Against, Outcome, judge};
use report::Report;

/// A problem that takes longer has no answer; its thread is left behind.
const LONGEST: Duration = Duration::from_secs(20);
/// The reference may take longer.
const LONGEST_CHECK: Duration = Duration::from_secs(240);

/// A line of progress after so many problems.
const PROGRESS: u64 = 100;

struct Arguments {
    seed: u64,
    count: u64,
    checked: u64,
    only: Option<u64>,
}

fn arguments() -> Option<Arguments> {
    let mut words = std::env::args().skip(1);
    let mut number = || words.next()?.parse::<u64>().ok();
    let (seed, count) = (number()?, number()?);
    let mut found = Arguments { seed, count, checked: count, only: None };
    let mut words = std::env::args().skip(3);
    while let Some(word) = words.next() {
        let value = words.next()?.parse().ok()?;
        match word.as_str() {
            "--reference" => found.checked = value,
            "--only" => found.only = Some(value),
            _ => return None,
        }
    }
    Some(found)
}

fn main() {
    let Some(arguments) = arguments() else {
        eprintln!("audit_survey SEED COUNT [--reference N] [--only INDEX]");
        std::process::exit(2);
    };
    let folder = std::env::temp_dir().join(format!("audit_survey_{}", arguments.seed));
    if let Err(error) = std::fs::create_dir_all(&folder) {
        eprintln!("{}: {error}", folder.display());
        std::process::exit(2);
    }
    println!(
        "seed {}, {} problems; measured bases are in {}",
        arguments.seed,
        arguments.count,
        folder.display()
    );
    let mut report = Report::default();
    for index in 0..arguments.count {
        if arguments.only.is_some_and(|only| only != index) {
            continue;
        }
        let is_checked = index < arguments.checked || arguments.only.is_some();
        let case = draw::case(arguments.seed, index);
        if let Some(rows) = &case.csv {
            let written = std::fs::write(folder.join(format!("trace_{index}.csv")), rows);
            if let Err(error) = written {
                eprintln!("{}: {error}", folder.display());
                std::process::exit(2);
            }
        }
        if arguments.only.is_some() {
            println!("{}\n{}", case.class, case.toml);
        }
        let start = Instant::now();
        let outcome = guarded(&case, folder.clone(), is_checked);
        report.add(index, &case, outcome, start.elapsed().as_secs_f64());
        if (index + 1) % PROGRESS == 0 {
            eprintln!("{} of {}: {}", index + 1, arguments.count, report.counts());
        }
    }
    report.print();
    if report.has_violations() {
        std::process::exit(1);
    }
}

/// The outcome, or none when it takes too long.
fn guarded(case: &Case, folder: PathBuf, is_checked: bool) -> Option<Outcome> {
    let (sender, receiver) = mpsc::channel();
    let copy = Case {
        class: case.class.clone(),
        toml: case.toml.clone(),
        csv: None,
        bends: case.bends.clone(),
        ..*case
    };
    std::thread::spawn(move || {
        // The answer first, so that the guard is for it alone.
        let against = if is_checked { Against::Reference } else { Against::SecondAudit };
        let outcome = judge(&copy, &folder, against, |answered| {
            let _ = sender.send(Outcome::Answered(Box::new(answered)));
        });
        let _ = sender.send(outcome);
    });
    let first = receiver.recv_timeout(LONGEST).ok()?;
    match first {
        Outcome::Answered(_) => Some(receiver.recv_timeout(LONGEST_CHECK).unwrap_or(first)),
        other => Some(other),
    }
}
