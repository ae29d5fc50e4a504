//! Right-hand sides expanded in the eigenfunctions, and their moments.

use std::f64::consts::PI;

use fredholm::kernel::{
    LogarithmRatio, LogarithmRatioLimit, LogarithmSine, LogarithmSquare, SpectralRelation,
};
use fredholm::quadrature::double_exponential;

use crate::kernels_logarithmic::reference::{EXACT, Worst};

#[test]
fn first_kind_right_hand_sides_are_expanded() {
    let mut worst = Worst::default();
    let mut check =
        |relation: &dyn SpectralRelation, f: &dyn Fn(f64) -> f64, exact: &[f64], steep: f64| {
            let expansion = relation.expand(f).unwrap();
            assert!(expansion.resolved, "{:?}: {}", relation.interval(), expansion.error);
            for n in 0..exact.len().max(expansion.coefficients.len()) {
                let at = |list: &[f64]| list.get(n).copied().unwrap_or(0.0);
                let error = (at(&expansion.coefficients) - at(exact)).abs();
                worst.note((error - steep * f64::EPSILON).max(0.0));
            }
        };
    // phi_n is steep in x, which is a double, where the interval is a small part of x and near the circle: tau for kernel 3.
    let relations: [(Box<dyn SpectralRelation>, f64); 9] = [
        (Box::new(LogarithmRatio::new(0.25, 1.0).unwrap()), 1.0),
        (Box::new(LogarithmRatio::new(1e-8, 1.0).unwrap()), 1.0),
        (Box::new(LogarithmRatio::new(0.999, 1.0).unwrap()), 1e3),
        (Box::new(LogarithmRatioLimit::new(1.7).unwrap()), 1.0),
        (Box::new(LogarithmSine::new(1.5).unwrap()), 1.0),
        (Box::new(LogarithmSine::new(3.1).unwrap()), 48.0),
        (Box::new(LogarithmSine::new(3.14).unwrap()), 1256.0),
        (Box::new(LogarithmSquare::new(0.0, 1.2).unwrap()), 1.0),
        (Box::new(LogarithmSquare::with_gauge(0.3, 1.0, 2.0).unwrap()), 1.0),
    ];
    for (relation, steepness) in &relations {
        for n in [0, 1, 2, 5, 12] {
            let mut unit = vec![0.0; n + 1];
            unit[n] = 1.0;
            check(&**relation, &|x| relation.sum(&unit, x), &unit, steepness * (n * n) as f64);
        }
    }
    // x = a dn: the Fourier series of dn
    for (b, a) in [(0.25, 1.0), (1e-8, 2.0), (0.9, 1.0)] {
        let kernel = LogarithmRatio::new(b, a).unwrap();
        // pi K'/K and K/a from the relation, whose numbers are tested against mpmath.
        let (decay, complete) = (kernel.expansion_factor(0), kernel.norm(0) * a);
        let exact: Vec<f64> = (0..400)
            .map(|n| {
                let share = if n == 0 { 0.5 } else { 1.0 };
                share * PI * a / complete / (f64::from(n) * decay).cosh()
            })
            .collect();
        check(&kernel, &|x| x, &exact, 0.0);
    }
    let limit = LogarithmRatioLimit::new(2.0).unwrap();
    // x^3 = a^3 (3 T_1 + T_3)/4
    check(&limit, &|x| x.powi(3), &[6.0, 2.0], 0.0);
    let companion = LogarithmSquare::new(1.0, 2.0).unwrap();
    check(&companion, &|x| x * x, &[2.5, 1.5], 0.0);
    for alpha in [0.7f64, 2.0, 3.1] {
        let kernel = LogarithmSine::new(alpha).unwrap();
        let sigma = (0.5 * alpha).sin();
        // cos x = 1 - 2 sigma^2 xi^2
        check(&kernel, &f64::cos, &[1.0 - sigma * sigma, 0.0, -sigma * sigma], 0.0);
        let tangent = |x: f64| (0.5 * x).tan() / (0.5 * alpha).tan();
        check(&kernel, &|x| 2.0 + tangent(x), &[2.0, 1.0], 0.0);
    }
    worst.require("expansions", 1e-12);
}

#[test]
fn moments_agree_with_quadrature() {
    let mut worst = Worst::default();
    let relations: [Box<dyn SpectralRelation>; 8] = [
        Box::new(LogarithmRatio::new(0.25, 1.0).unwrap()),
        Box::new(LogarithmRatio::new(1e-4, 1.0).unwrap()),
        Box::new(LogarithmRatioLimit::new(1.7).unwrap()),
        Box::new(LogarithmSine::new(1.5).unwrap()),
        Box::new(LogarithmSine::new(3.1).unwrap()),
        Box::new(LogarithmSquare::new(0.0, 1.2).unwrap()),
        Box::new(LogarithmSquare::new(1e-6, 1.2).unwrap()),
        Box::new(LogarithmSquare::new(0.3, 1.0).unwrap()),
    ];
    for relation in relations {
        let (centre, half) = (relation.interval().centre(), relation.interval().half_length());
        for f in [|_: f64| 1.0, |x: f64| x, f64::exp] as [fn(f64) -> f64; 3] {
            let moments = relation.moments(&f, 24).unwrap();
            assert!(moments.resolved);
            let mut exact = vec![0.0; 24];
            let mut values = vec![0.0; 24];
            for node in double_exponential(400) {
                let x = if node.position < 0.0 {
                    relation.interval().left() + half * node.from_left
                } else {
                    centre + half * node.position
                };
                relation.eigenfunctions(x, &mut values);
                let weight = half * node.weight * f(x);
                exact.iter_mut().zip(&values).for_each(|(sum, phi)| *sum += weight * phi);
            }
            let scale = half * f(relation.interval().right());
            for (found, exact) in moments.values.iter().zip(&exact) {
                worst.note((found - exact).abs() / scale);
            }
        }
    }
    worst.require("moments", EXACT);
}
