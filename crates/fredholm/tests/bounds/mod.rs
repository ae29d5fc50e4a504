//! Guaranteed bounds against sinc collocation, on seeded random problems and in the corners.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

mod corners;
mod long_interval;
mod orders;
mod survey;

use shtaerman_random::Random;
use survey::{Observation, Problem, Reference, SLACK, observe, operator, points};

/// Observations of seeded problems with the degree `max(64, resolution * theta)`.
fn survey(seed: u64, count: usize, resolution: f64) -> Vec<Observation> {
    let operator = operator();
    let mut random = Random::new(seed);
    let mut found = Vec::new();
    for _ in 0..count {
        let problem = Problem::random(&mut random, resolution);
        let (responses, influence) = problem.responses(problem.degree);
        let reference = Reference::new(&operator, &problem);
        let points = points(&mut random, problem.degree);
        let combination = responses.combine(problem.given);
        let observations = observe(&problem, &combination, &influence, &reference, &points);
        for observation in &observations {
            let theta = observation.theta;
            assert!(!observation.is_broken(), "theta {theta}: {observation:?} of {problem:?}");
        }
        found.extend(observations);
    }
    found
}

/// Median and 99 % of bound over error, where the error is the approximation's and not the reference's.
fn ratios(observations: &[Observation], quantity: &str) -> [f64; 2] {
    let mut ratios: Vec<f64> = (observations.iter())
        .filter(|o| o.quantity == quantity && o.counts())
        .map(|o| o.bound / o.error)
        .collect();
    ratios.sort_by(f64::total_cmp);
    assert!(ratios.len() >= 20, "{quantity}: only {} to judge by", ratios.len());
    [0.5, 0.99].map(|share| ratios[(share * (ratios.len() - 1) as f64).round() as usize])
}

#[test]
fn bounds_hold_and_are_sharp_on_random_problems() {
    let observations = survey(2, 200, 4.0);
    let sharp =
        ["pressure", "coefficient", "coefficient, plain", "projection", "projection, plain"];
    for quantity in sharp {
        let [median, most] = ratios(&observations, quantity);
        println!("{quantity}: median {median:.3}, 99 % {most:.2}");
        assert!(median <= 3.0 && most <= 50.0, "{quantity}: {median} {most}");
    }
}

#[test]
fn bounds_hold_where_the_layers_are_not_resolved() {
    let observations = survey(3, 100, 0.25);
    for quantity in ["pressure", "coefficient", "projection"] {
        let [median, most] = ratios(&observations, quantity);
        println!("{quantity}: median {median:.3}, 99 % {most:.2}");
        assert!(median <= 6.0, "{quantity}: {median}");
    }
}

#[test]
fn comparison_with_a_finer_solution_is_sharp_where_the_layers_are_not_resolved() {
    let operator = operator();
    let mut random = Random::new(4);
    let mut ratios = Vec::new();
    while ratios.len() < 12 {
        let problem = Problem::random(&mut random, 0.25);
        if problem.theta < 200.0 || problem.theta > 3000.0 {
            continue;
        }
        let (coarse, fine) =
            (problem.responses(problem.degree), problem.responses((6.0 * problem.theta) as usize));
        let (coarse, fine) = (coarse.0.combine(problem.given), fine.0.combine(problem.given));
        let refinement = coarse.refined_by(&fine);
        let reference = Reference::new(&operator, &problem);
        let size = reference.sizes.2;
        let (mut worst, mut iterated) = (0.0f64, [0.0f64; 2]);
        for x in points(&mut random, problem.degree) {
            let exact = reference.value(&problem, x);
            let approximation = coarse.approximation();
            let error = (approximation.evaluate(x) - exact).abs();
            assert!(error <= refinement.error_at(x) + SLACK * size);
            worst = worst.max(error);
            let g = approximation.right_hand_side().evaluate(x);
            let error = (approximation.iterated().evaluate(x, g) - exact).abs();
            let bound = refinement.iterated_error_at(x);
            assert!(error <= bound + SLACK * size);
            iterated = [iterated[0].max(error), iterated[1].max(bound)];
        }
        assert!(worst <= refinement.error_supremum() + SLACK * size);
        assert!(refinement.error_supremum() <= coarse.error_supremum());
        assert!(iterated[1] < 3.0 * iterated[0], "{iterated:?}");
        ratios.push(refinement.error_supremum() / worst);
    }
    ratios.sort_by(f64::total_cmp);
    println!("finer solution: {ratios:.3?}");
    assert!(ratios[6] < 1.5 && ratios[11] < 3.0, "{ratios:?}");
}
