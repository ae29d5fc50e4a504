//! A small survey of random problems; `examples/audit_survey` runs larger ones.

use crate::audit::draw::case;
use crate::audit::judge::{Against, Outcome, judge};

/// Another seed than examples and reports have.
const SEED: u64 = 5_150_927;
/// Of each half.
const COUNT: u64 = 20;
/// So many answers of each half are held against the reference, which takes seconds.
const CHECKED: usize = 3;
/// Longer traces take too long for a test.
const MOST_ROWS: usize = 100;

/// Two halves, which run beside each other.
#[test]
fn a_first_half_of_stated_errors_holds() {
    stated_errors_hold(SEED);
}

#[test]
fn a_second_half_of_stated_errors_holds() {
    stated_errors_hold(SEED + 1);
}

#[allow(clippy::panic, reason = "a part of tests")]
fn stated_errors_hold(seed: u64) {
    println!("seed {seed}");
    let name = format!("shtaerman_survey_{}_{seed}", std::process::id());
    let folder = std::env::temp_dir().join(name);
    std::fs::create_dir_all(&folder).unwrap();
    let (mut answered, mut referred, mut checked, mut refused) = (0, 0, 0, 0);
    for index in 0..COUNT {
        let case = case(seed, index);
        if let Some(rows) = &case.csv {
            if rows.lines().count() > MOST_ROWS {
                continue;
            }
            std::fs::write(folder.join(format!("trace_{index}.csv")), rows).unwrap();
        }
        let is_referred = referred < CHECKED;
        let against = if is_referred { Against::Reference } else { Against::SecondAudit };
        let outcome = judge(&case, &folder, against, |_| {});
        match outcome {
            Outcome::NoProblem(reason) => {
                panic!("{index} ({}): {reason}\n{}", case.class, case.toml)
            }
            Outcome::Limit(_) => {}
            Outcome::Refused(reason) => {
                println!("{index} ({}): {reason}\n{}", case.class, case.toml);
                refused += 1;
            }
            Outcome::Answered(found) => {
                answered += 1;
                let Some(check) = found.checked else { continue };
                checked += 1;
                referred += usize::from(is_referred);
                assert!(check.violation.is_none(), "{index}: {:?}\n{}", check.violation, case.toml);
            }
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
    println!(
        "{answered} answered, {referred} held against the reference and {} against a second audit, {refused} refused",
        checked - referred
    );
    assert!(
        referred >= CHECKED && checked > 2 * CHECKED && answered > COUNT / 2,
        "{answered} answered, {checked} checked"
    );
}
