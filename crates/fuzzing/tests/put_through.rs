//! Half a minute of every kind of input, with other seeds than those that the generators were tuned on (1 to 99).

#![expect(clippy::expect_used, reason = "a test may fail by panicking")]

use fuzzing::{Report, Target, run, set_program};

/// Seed of the tests.
const SEED: u64 = 20_261_123;

/// So many cases without a fault. How long each takes is told and not tested: the machine may be busy.
fn without_fault(name: &str, count: u64) -> Report {
    let target = Target::named(name).expect("a target");
    let report = run(target, SEED, 0..count);
    println!("{name}: {} cases, slowest {:?}", report.cases, report.slowest);
    assert!(report.faults.is_empty(), "{name}, seed {SEED}: {:#?}", report.faults);
    report
}

/// So many cases, some of which are taken and some refused.
fn put_through(name: &str, count: u64) {
    let report = without_fault(name, count);
    assert!(report.accepted > 0 && report.refused > 0, "{report:?}");
}

#[test]
fn texts_are_read_or_refused_with_a_message() {
    for (name, count) in
        [("units", 20_000), ("columns", 10_000), ("arguments", 5_000), ("expressions", 4_000)]
    {
        put_through(name, count);
    }
}

#[test]
fn files_are_read_or_refused_with_a_message() {
    put_through("readers", 1_000);
}

#[test]
fn calls_with_odd_numbers_are_answered_or_refused() {
    put_through("calls", 6);
}

#[test]
fn problems_are_solved_or_refused_and_answers_keep_the_schema() {
    put_through("problems", 12);
}

#[test]
fn equations_are_solved_or_refused_and_answers_keep_the_schema() {
    put_through("equations", 16);
}

/// What is computed or written when a signal comes leaves nothing, and nothing half.
#[cfg(unix)]
#[test]
fn signals_at_any_moment_leave_nothing() {
    set_program(env!("CARGO_BIN_EXE_fuzzing"));
    // That runs come to their end is seen by the ones that are left alone; which of the others do hangs on the clock.
    let report = without_fault("signals", 20);
    assert!(report.refused > 0, "{report:?}");
}

#[cfg(target_os = "linux")]
#[test]
fn surroundings_change_no_answer_and_leave_nothing() {
    set_program(env!("CARGO_BIN_EXE_fuzzing"));
    put_through("faults", 40);
}
