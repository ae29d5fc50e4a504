//! Equations on panels against closed forms and collocation.

use super::super::{PanelKernel, Panels};
use super::*;
use crate::SincOperator;
use crate::kernel::Logarithm;

#[test]
fn on_a_circle_the_inverse_of_groups_is_positive() {
    // A constant gives nothing over the whole circle, of which rounded means must not make less.
    let cuts: Vec<f64> = (0..=100).map(|i| f64::from(i) / 50.0 - 1.0).collect();
    let bounds = cuts.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let panels = Panels::new(bounds, 8).unwrap();
    for (theta, longest) in [(1.0, 0.5), (1e3, 0.1), (1e5, 0.02)] {
        let groups = Groups::new(&PanelKernel::Sine, &panels, theta, longest, None).unwrap();
        let ones = vec![1.0; panels.count()];
        for value in groups.roughly_inverted(&ones) {
            assert!((value - 1.0).abs() < 0.05, "{theta}: {value}");
        }
    }
}

#[test]
fn a_thin_layer_takes_no_more_products() {
    // cos(m pi s) leads to cos(m pi x)/m over the whole turn; panels that close in on one place, in groups of many layers.
    let mut cuts: Vec<f64> = (0..=100).map(|i| f64::from(i) / 50.0 - 1.0).collect();
    cuts.extend((1..20).flat_map(|i| [0.31, 0.29].map(|at| 0.3 + (at - 0.3) * 0.5f64.powi(i))));
    cuts.push(0.3);
    cuts.sort_by(f64::total_cmp);
    let bounds = cuts.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let panels = Panels::new(bounds, 10).unwrap();
    let operator = PanelOperator::new(PanelKernel::Sine, panels).unwrap();
    let pi = std::f64::consts::PI;
    let wave = |m: f64, x: f64| (m * pi * x + 0.3).cos();
    let nodes = operator.panels().nodes();
    for theta in [1e3, 1e5] {
        let groups = Groups::new(&PanelKernel::Sine, operator.panels(), theta, 0.1, None).unwrap();
        let equation =
            PanelEquation { operator: &operator, parameter: theta, groups: &groups, weight: None };
        let right: Vec<f64> = nodes.iter().map(|x| wave(3.0, *x) + wave(40.0, *x)).collect();
        let zero = vec![0.0; nodes.len()];
        let found = equation.solve(&right, &[], &zero, 1e-12).unwrap();
        assert!(found.products < 60, "{theta}: {}", found.products);
        for (x, value) in nodes.iter().zip(&found.values) {
            let exact = [3.0, 40.0].map(|m| wave(m, *x) / (1.0 + theta / m));
            let difference = (value - exact[0] - exact[1]).abs();
            assert!(difference < 1e-9, "{theta} {x}: {difference}");
        }
    }
}

/// A flat wave gives responses whose right-hand side is zero but for rounding; from those of coarser panels, all rounding, 407 products did not lead to nothing.
#[test]
fn of_nothing_the_answer_is_nothing_whatever_the_start() {
    let bounds = (0..40).map(|i| [0.05 * f64::from(i) - 1.0, 0.05 * f64::from(i + 1) - 1.0]);
    let panels = Panels::new(bounds.collect(), 10).unwrap();
    let operator = PanelOperator::new(PanelKernel::Sine, panels).unwrap();
    let groups = Groups::new(&PanelKernel::Sine, operator.panels(), 0.06, 0.1, None).unwrap();
    let equation =
        PanelEquation { operator: &operator, parameter: 0.06, weight: None, groups: &groups };
    let start: Vec<f64> = (0..400).map(|k| 1e-30 * (3.0 * f64::from(k)).sin()).collect();
    let found = equation.solve(&[0.0; 400], &[], &start, 0.0).unwrap();
    assert!(found.values.iter().all(|value| *value == 0.0) && found.products < 4);
}

#[test]
fn what_does_not_converge_is_an_error() {
    let left = |i: i32| f64::from(i) * 0.01 - 1.0;
    let bounds = (0..200).map(|i| [left(i), left(i) + 0.0099]).collect();
    let panels = Panels::new(bounds, 6).unwrap();
    let operator = PanelOperator::new(PanelKernel::Logarithm, panels).unwrap();
    let groups = Groups::new(&PanelKernel::Logarithm, operator.panels(), 1.0, 0.1, None).unwrap();
    let equation =
        PanelEquation { operator: &operator, parameter: 1.0, weight: None, groups: &groups };
    let nodes = operator.panels().nodes();
    let zero = vec![0.0; nodes.len()];
    let mut right: Vec<f64> = nodes.iter().map(|x| (7.0 * x).sin()).collect();
    // Below rounding there is nothing to ask for.
    assert!(equation.solve(&right, &[], &zero, 0.0).is_ok());
    right[17] = f64::NAN;
    let found = equation.solve(&right, &[], &zero, 1e-12);
    assert!(matches!(found, Err(Error::NotConverged { .. })), "{found:?}");
}

/// Panels that close in on both ends, where the solution has `d ln d`.
fn graded() -> PanelOperator {
    let mut cuts: Vec<f64> = (-19..=19).map(|i| f64::from(i) * 0.05).collect();
    for i in 1..28 {
        let at = 1.0 - 0.05 * 0.4f64.powi(i);
        cuts.extend([at, -at]);
    }
    cuts.extend([-1.0, 1.0]);
    cuts.sort_by(f64::total_cmp);
    let bounds = cuts.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    PanelOperator::new(PanelKernel::Logarithm, Panels::new(bounds, 16).unwrap()).unwrap()
}

#[test]
fn the_flat_punch_agrees_with_sinc_collocation() {
    let operator = graded();
    for theta in [0.5, 30.0] {
        let groups =
            Groups::new(&PanelKernel::Logarithm, operator.panels(), theta, 0.05, None).unwrap();
        let equation =
            PanelEquation { operator: &operator, parameter: theta, weight: None, groups: &groups };
        let nodes = operator.panels().nodes();
        let (ones, zero) = (vec![1.0; nodes.len()], vec![0.0; nodes.len()]);
        let found = equation.solve(&ones, &[], &zero, 1e-14).unwrap();
        let sinc = SincOperator::new(&Logarithm::unit(), 60).unwrap();
        let known = &sinc.solve(theta, &[vec![1.0; sinc.count()]]).unwrap()[0];
        for x in [-0.999, -0.3, 0.02, 0.77] {
            let value = operator.panels().interpolate(&found.values, x).unwrap();
            assert!((value - known.evaluate(x, 1.0)).abs() < 1e-12, "{theta} {x}: {value}");
        }
        // The same with its force and moment prescribed, from elsewhere.
        let force = operator.panels().integral(&found.values, |_| 1.0);
        let conditions = [
            PanelCondition::symmetric(ones.clone(), force),
            PanelCondition::symmetric(nodes.to_vec(), 0.0),
        ];
        let again = equation.solve(&zero, &conditions, &ones, 1e-14).unwrap();
        let [settlement, turn] = [again.multipliers[0], again.multipliers[1]];
        assert!((settlement - 1.0).abs() < 1e-12 && turn.abs() < 1e-12, "{settlement} {turn}");
        // With the force at an arm, which turns the punch: the moment is that of this tilt.
        let row = nodes.iter().map(|x| x - 0.1).collect();
        let lever = [PanelCondition { row, column: nodes.to_vec(), value: 0.0 }];
        let tilted = equation.solve(&ones, &lever, &zero, 1e-14).unwrap();
        let turned = equation.solve(nodes, &[], &zero, 1e-14).unwrap();
        let of = |values: &[f64], f: fn(f64) -> f64| operator.panels().integral(values, f);
        let turn = of(&turned.values, |x| x);
        let expected = 0.1 * of(&found.values, |_| 1.0) / turn;
        assert!((tilted.multipliers[0] - expected).abs() < 1e-12, "{:?}", tilted.multipliers);
        let arm = of(&tilted.values, |x| x) / of(&tilted.values, |_| 1.0);
        assert!((arm - 0.1).abs() < 1e-13, "{arm}");
    }
}

#[test]
fn a_weight_agrees_with_weighted_sinc_collocation() {
    let operator = graded();
    let nodes = operator.panels().nodes();
    // Nothing at one end, as beside a free edge.
    let weight_at = |x: f64| (1.0 + x) * (1.3 - x);
    let weight: Vec<f64> = nodes.iter().map(|x| weight_at(*x)).collect();
    for theta in [0.5, 30.0] {
        let groups =
            Groups::new(&PanelKernel::Logarithm, operator.panels(), theta, 0.05, Some(&weight))
                .unwrap();
        let equation = PanelEquation {
            operator: &operator,
            parameter: theta,
            weight: Some(&weight),
            groups: &groups,
        };
        let (ones, zero) = (vec![1.0; nodes.len()], vec![0.0; nodes.len()]);
        let found = equation.solve(&ones, &[], &zero, 1e-14).unwrap();
        let sinc = SincOperator::new(&Logarithm::unit(), 60).unwrap();
        let weights: Vec<f64> = sinc.positions().map(weight_at).collect();
        let factor = sinc.factor_weighted(theta, &weights).unwrap();
        let known = factor.solve(&vec![1.0; sinc.count()]).unwrap();
        for x in [-0.999, -0.3, 0.02, 0.77] {
            let value = operator.panels().interpolate(&found.values, x).unwrap();
            assert!((value - known.evaluate(x, 1.0)).abs() < 1e-11, "{theta} {x}: {value}");
        }
        // The force is that of the weighted values.
        let carried: Vec<f64> = weight.iter().zip(&found.values).map(|(w, v)| w * v).collect();
        let force = operator.panels().integral(&carried, |_| 1.0);
        let conditions = [PanelCondition::symmetric(ones.clone(), force)];
        let again = equation.solve(&zero, &conditions, &ones, 1e-14).unwrap();
        assert!((again.multipliers[0] - 1.0).abs() < 1e-11, "{:?}", again.multipliers);
    }
    let short = [1.0; 3];
    let panels = operator.panels();
    let groups = Groups::new(&PanelKernel::Logarithm, panels, 1.0, 0.05, Some(&short));
    assert!(matches!(groups, Err(Error::WrongLength { found: 3, .. })));
}

#[test]
fn right_hand_sides_together_have_the_answers_that_each_has_by_itself() {
    let bounds = (0..60).map(|i| f64::from(i) / 30.0 - 1.0).map(|x| [x, x + 0.03]).collect();
    let panels = Panels::new(bounds, 9).unwrap();
    let places = panels.nodes().to_vec();
    let operator = PanelOperator::new(PanelKernel::Logarithm, panels).unwrap();
    let weights: Vec<f64> = places.iter().map(|x| 1.5 + x).collect();
    for weight in [None, Some(&weights[..])] {
        let (parameter, panels) = (20.0, operator.panels());
        let groups = Groups::new(&PanelKernel::Logarithm, panels, parameter, 0.1, weight).unwrap();
        let equation = PanelEquation { operator: &operator, parameter, weight, groups: &groups };
        let waves = [0.0, 1.0, 7.0, 40.0];
        let rights = waves.map(|k| places.iter().map(|x| (k * x).cos()).collect::<Vec<f64>>());
        let nothing = vec![0.0; places.len()];
        // They end after different numbers of products.
        let task = |i: usize| (&rights[i][..], 10f64.powi(-4 - 2 * i as i32));
        let tasks = [0, 1, 2, 3].map(task);
        let tasks = tasks.map(|(right, tolerance)| PanelTask { right, start: &nothing, tolerance });
        let together = equation.solve_together(&tasks, &[]).unwrap();
        assert!(together.windows(2).any(|pair| pair[0].products != pair[1].products));
        for (task, found) in tasks.iter().zip(together) {
            let alone = equation.solve(task.right, &[], task.start, task.tolerance).unwrap();
            assert_eq!(alone.values, found.values);
            assert_eq!(alone.potential, found.potential);
            assert_eq!(alone.products, found.products);
            assert!(found.residual <= task.tolerance);
        }
    }
}
