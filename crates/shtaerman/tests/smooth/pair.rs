//! Two punches: closed forms.

use std::f64::consts::PI;

use crate::smooth::support::{balanced, close, holds, level, punch};

/// Complete elliptic integral of the first kind by the arithmetic-geometric mean, of modulus `k`.
fn elliptic(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, ((1.0 - k) * (1.0 + k)).sqrt());
    for _ in 0..12 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    PI / (2.0 * a)
}

#[test]
fn two_punches_under_a_force() {
    // p = P |x|/(pi sqrt((1 - x^2)(x^2 - b^2))), delta = (theta0 P/2) ln(4/(1 - b^2))
    for b in [0.9f64, 0.5, 0.1, 0.01] {
        let (theta0, force) = (1.7, 0.6);
        let contact = punch(theta0, |_| 0.0, level(force)).gap(b).solved();
        let settlement = 0.5 * theta0 * force * (4.0 / (1.0 - b * b)).ln();
        close(contact.settlement(), settlement, 1e-12, &format!("settlement {b}"));
        for y in [0.03, 0.4, 0.99] {
            let x = b + (1.0 - b) * y;
            let exact = force * x / (PI * ((1.0 - x * x) * (x * x - b * b)).sqrt());
            close(contact.pressure(x), exact, 1e-11, &format!("pressure {b} {x}"));
            close(contact.pressure(-x), exact, 1e-11, &format!("pressure {b} {x}"));
        }
        // K = P sqrt(pi d) .. : at x = 1, p = P/(pi sqrt(2 d (1 - b^2)))
        let [outer, inner] = [1.0, b].map(|x| force * (x / (PI * (1.0 - b * b))).sqrt());
        close(contact.zones()[1].intensity[1], outer, 1e-11, "K outer");
        close(contact.zones()[1].intensity[0], inner, 1e-11, "K inner");
        assert_eq!(contact.pressure(0.0), 0.0);
        holds(&contact, 1e-11, &format!("{b}"));
    }
}

#[test]
fn two_punches_under_a_moment() {
    // Odd: p = (C/sqrt((1 - x^2)(x^2 - b^2))) sgn x makes int K p constant on a side, pi K(b) C: under a tilt the density is
    // -(alpha/(pi theta0)) (x^2 - m)/sqrt(..) sgn x with m such that the displacement is odd and linear
    for b in [0.8f64, 0.3, 0.05] {
        let contact = punch(1.0, |_| 0.0, balanced(1.0, 0.2)).gap(b).bilateral().solved();
        holds(&contact, 1e-11, &format!("{b}"));
        // (x^2 - m): the odd part times its root at two places gives m, at a third it must agree
        let odd = |x: f64| {
            let p = 0.5 * (contact.pressure(x) - contact.pressure(-x));
            p * ((1.0 - x * x) * (x * x - b * b)).sqrt()
        };
        let slope = -contact.tilt() / PI;
        let at = |y: f64| b + (1.0 - b) * y;
        let m = at(0.2).powi(2) - odd(at(0.2)) / slope;
        for y in [0.5, 0.7, 0.95] {
            let exact = slope * (at(y).powi(2) - m);
            close(odd(at(y)), exact, 1e-10, &format!("odd {b} {y}"));
        }
        // The displacement vanishes at x = 0, so its slope in the gap adds up to -alpha b: int_0^b (x^2 - m)/sqrt((1 - x^2)(b^2 - x^2)) = 0,
        // m = int x^2/.. / K(b) = 1 - E(b)/K(b).
        let exact = mean_square(b) / elliptic(b);
        close(m, exact, 1e-10, &format!("m {b}"));
    }
}

/// `int_0^b x^2/sqrt((1 - x^2)(b^2 - x^2)) dx` by the rule of Chebyshev.
fn mean_square(b: f64) -> f64 {
    let count = 400;
    let terms = (0..count).map(|i| {
        let s = b * (PI * (f64::from(i) + 0.5) / f64::from(count)).cos();
        s * s / (1.0 - s * s).sqrt()
    });
    0.5 * PI / f64::from(count) * terms.sum::<f64>()
}

#[test]
fn a_pair_stands_or_lifts() {
    // A moment that lifts one of two flat punches altogether leaves one under an eccentric force.
    let contact = punch(1.0, |_| 0.0, balanced(1.0, 0.9)).gap(0.5).solved();
    let zones = contact.zones();
    assert_eq!(zones.len(), 1);
    // On [0.5, 1] the force acts at 0.9: beyond half of its half-width 0.25, b = 2 (0.25 - 0.15)
    close(zones[0].ends[0], 0.6, 1e-11, "free edge");
    holds(&contact, 1e-10, "one foot");
    let contact = punch(1.0, |x: f64| 3.0 * x * x, balanced(1.0, 0.3)).gap(0.2).solved();
    holds(&contact, 1e-10, "crowned");
}
