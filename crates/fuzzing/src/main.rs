//! `cargo run --release -p fuzzing -- WHAT SEED COUNT [FIRST]`: puts random input through, and tells what failed.
//!
//! `... -- page READ SOLVED PROGRAM "made on .."`: puts shares of what is read, of what is solved and of what needs the whole program through, and writes the page of the book to standard output.

use std::process::ExitCode;

use fuzzing::{RUN_AS_PROGRAM, Target, memory, page, run};

/// Failures that are shown in full.
const SHOWN: usize = 20;

fn main() -> ExitCode {
    if std::env::var_os(RUN_AS_PROGRAM).is_some() {
        return shtaerman_cli::run();
    }
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [what, numbers @ ..] = arguments.as_slice() else { return usage() };
    if let ("page", [shares @ .., made]) = (what.as_str(), numbers) {
        let shares: Option<Vec<f64>> = shares.iter().map(|share| share.parse().ok()).collect();
        let shares = shares.and_then(|shares| <[f64; 3]>::try_from(shares).ok());
        return shares.map_or_else(usage, |shares| write_page(shares, made));
    }
    let numbers: Option<Vec<u64>> = numbers.iter().map(|text| text.parse().ok()).collect();
    let (Some(target), Some(numbers)) = (Target::named(what), numbers) else { return usage() };
    let (seed, count, first) = match numbers.as_slice() {
        [seed, count] => (*seed, *count, 0),
        [seed, count, first] => (*seed, *count, *first),
        _ => return usage(),
    };
    tell_panics_with_their_cases();
    let report = run(target, seed, first..first.saturating_add(count));
    for fault in report.faults.iter().take(SHOWN) {
        println!("case {}: {}", fault.case, fault.what);
    }
    for (took, case) in report.hangs.iter().take(SHOWN) {
        println!("case {case}: took {:.1} s", took.as_secs_f64());
    }
    let (slowest, case) = report.slowest;
    println!(
        "{what}, seed {seed}: {} cases, {} accepted, {} refused, {} failed, {} took too long; slowest {:.4} s, case {case}; {} MB at most",
        report.cases,
        report.accepted,
        report.refused,
        report.faults.len(),
        report.hangs.len(),
        slowest.as_secs_f64(),
        memory().map_or_else(|| "?".to_owned(), |size| size.div_ceil(1_000_000).to_string())
    );
    if report.faults.is_empty() && report.hangs.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

fn tell_panics_with_their_cases() {
    std::panic::set_hook(Box::new(|_| ()));
}

fn write_page(shares: [f64; 3], made: &str) -> ExitCode {
    tell_panics_with_their_cases();
    let (page, faults) = page(shares, made);
    print!("{page}");
    for fault in &faults {
        eprintln!("{fault}");
    }
    if faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

fn usage() -> ExitCode {
    let names: Vec<&str> = Target::ALL.iter().map(|target| target.name()).collect();
    eprintln!(
        "usage: fuzzing {} SEED COUNT [FIRST]\n       fuzzing page READ SOLVED PROGRAM MADE",
        names.join("|")
    );
    ExitCode::from(2)
}
