//! Collocation on a union of panels with gaps.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::sync::Arc;

use fredholm::collocation::SincGrid;
use fredholm::kernel::Logarithm;
use fredholm::{Error, SincOperator};

fn operator(panels: &[(f64, f64)]) -> Result<SincOperator, Error> {
    let kernel = Logarithm::unit();
    let grid = Arc::new(SincGrid::new(&kernel, 40)?);
    SincOperator::on_panels(&kernel, grid, panels)
}

/// `int_l^r ln(1/|x - s|) ds`.
fn potential(x: f64, (left, right): (f64, f64)) -> f64 {
    let part = |d: f64| if d == 0.0 { 0.0 } else { d * (1.0 - d.abs().ln()) };
    part(x - left) - part(x - right)
}

/// Symmetric about the middle or not, with and without gaps, short and long.
const UNIONS: [&[(f64, f64)]; 5] = [
    &[(-1.0, -0.4), (0.4, 1.0)],
    &[(-1.0, -0.4), (-0.4, 0.1), (0.1000001, 0.7)],
    &[(-0.9, -0.2), (0.3, 0.3001), (0.5, 1.0)],
    &[(-1.0, -0.5), (-0.5, 0.0), (0.5, 1.0)],
    &[(0.25, 0.75)],
];

#[test]
fn a_constant_density_is_found() {
    for panels in UNIONS {
        let operator = operator(panels).unwrap();
        // A panel at a distance of 1e-7 bends the potential there faster than 81 nodes follow.
        let is_close = |pair: &[(f64, f64)]| (1e-12..1e-3).contains(&(pair[1].0 - pair[0].1));
        let tolerance = if panels.windows(2).any(is_close) { 1e-11 } else { 1e-12 };
        for parameter in [0.5, 60.0] {
            let f = |x: f64| {
                1.0 + parameter * panels.iter().map(|&panel| potential(x, panel)).sum::<f64>()
            };
            let solution = &operator.solve(parameter, &[operator.sample(f).unwrap()]).unwrap()[0];
            let length: f64 = panels.iter().map(|(left, right)| right - left).sum();
            assert!((solution.integral(|_| 1.0) - length).abs() < 1e-13);
            for &(left, right) in panels {
                for i in 0..=20 {
                    let x = (left + (right - left) * f64::from(i) / 20.0).clamp(left, right);
                    let found = solution.evaluate(x, f(x));
                    assert!((found - 1.0).abs() < tolerance * (1.0 + parameter), "{x}: {found}");
                }
            }
        }
    }
}

#[test]
fn the_density_of_one_panel_acts_everywhere() {
    for panels in UNIONS {
        let operator = operator(panels).unwrap();
        for (chosen, &panel) in panels.iter().enumerate() {
            let density: Vec<f64> =
                operator.places().map(|place| f64::from(u8::from(place.panel == chosen))).collect();
            let found = operator.apply(&density).unwrap();
            for (found, x) in found.iter().zip(operator.positions()) {
                let exact = potential(x, panel);
                assert!((found - exact).abs() < 1e-6, "{x}: {found} {exact}");
            }
        }
    }
}

#[test]
fn panels_without_gaps_are_those_between_breakpoints() {
    let kernel = Logarithm::unit();
    let union = operator(&[(-1.0, -0.3), (-0.3, 0.6), (0.6, 1.0)]).unwrap();
    let broken = SincOperator::with_breaks(&kernel, 40, &[-0.3, 0.6]).unwrap();
    let solve = |operator: &SincOperator| {
        let f = operator.sample(|x| (x - 0.6).abs()).unwrap();
        operator.solve(3.0, &[f]).unwrap()[0].values().to_vec()
    };
    assert_eq!(solve(&union), solve(&broken));
}

#[test]
fn a_point_in_a_gap_counts_as_the_nearer_end() {
    let operator = operator(&[(-1.0, -0.4), (0.4, 1.0)]).unwrap();
    let solution = &operator.solve(1.0, &[operator.sample(|x| 2.0 + x).unwrap()]).unwrap()[0];
    assert_eq!(solution.evaluate_potential(-0.1), solution.evaluate_potential(-0.4));
    assert_eq!(solution.evaluate_potential(0.1), solution.evaluate_potential(0.4));
    assert!(solution.evaluate_potential(f64::NAN).is_nan());
}

#[test]
fn bad_panels_are_refused() {
    for panels in [
        [].as_slice(),
        &[(0.0, 0.0)],
        &[(0.5, 0.0)],
        &[(-1.5, 0.0)],
        &[(0.0, 1.5)],
        &[(f64::NAN, 0.0)],
        &[(0.0, f64::INFINITY)],
        &[(-1.0, 0.2), (0.1, 1.0)],
        &[(0.1, 1.0), (-1.0, 0.0)],
    ] {
        assert!(operator(panels).is_err(), "{panels:?}");
    }
}
