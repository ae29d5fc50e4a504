//! Random problems.

use crate::random::{Ending, Random, judge, problem};

#[test]
fn random_problems_are_solved_or_refused_with_reason() {
    let mut random = Random::new(20);
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
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(solved > 150 && several > 10, "{solved} {several}");
}
