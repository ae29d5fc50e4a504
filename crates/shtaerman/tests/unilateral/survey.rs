//! Random problems.

use crate::unilateral::random::{Ending, Random, judge, problem};

/// Not that of the example: what was mended there is not all that there is.
const SEED: u64 = 1_207;

#[test]
fn random_problems_are_solved_or_refused_with_reason() {
    let mut random = Random::new(SEED);
    println!("seed {SEED}");
    let (mut solved, mut several) = (0, 0);
    let mut faults = Vec::new();
    for index in 0..200 {
        let (words, problem) = problem(&mut random);
        match judge(&problem.unwrap()) {
            Ending::Solved { residual, zones, .. } => {
                solved += 1;
                several += usize::from(zones > 1);
                if residual > 1e-9 {
                    faults.push(format!("{index}: residual {residual:e}: {words}"));
                }
            }
            Ending::Refused => {}
            Ending::Failed(reason) => faults.push(format!("{index}: {reason}: {words}")),
        }
    }
    assert!(faults.is_empty(), "seed {SEED}\n{}", faults.join("\n"));
    assert!(solved > 150 && several > 10, "seed {SEED}: {solved} {several}");
}
