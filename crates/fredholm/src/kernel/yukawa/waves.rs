//! The kernel far from the diagonal, as a sum over spherical waves in which every term is positive.

use std::f64::consts::TAU;

use super::elliptic::Points;

/// `-ln` of the relative size of the terms left out.
const DIGITS: f64 = 38.0;
/// Orders beyond this do not occur unless the distance contradicts the points.
const HIGHEST: f64 = 1e5;
/// Quotients kept without allocation.
const KEPT: usize = 96;

/// `exp(-chi R)/R = chi sum_l (2l+1) i_l(z) k_l(z') P_l(cos u)`, `z = chi x` of the smaller and `z' = chi s` of the larger point (DLMF 10.60.3), integrated over the angle:
///
/// `K = 2 pi chi sum (2l+1) g_{(l-m)/2} g_{(l+m)/2} i_l(z) k_l(z')`, `l = m, m+2, ...`, `g_j = (1/2)_j/j!`.
///
/// The products of the modified spherical Bessel functions follow from the first one, `exp(-chi d) (1 - exp(-2z))/(2 z z')`, by the quotients of neighbours: of `i_l` by their continued fraction, of
/// `k_l` upwards.
pub(super) fn sum(harmonic: u32, screening: f64, points: Points) -> f64 {
    let Points { larger, ratio, distance } = points;
    let (inner, outer) = (screening * larger * ratio, screening * larger);
    let last = last_order(harmonic, outer, -ratio.ln());
    let mut kept = [0.0; KEPT];
    let mut allocated = Vec::new();
    let quotients = if last < KEPT {
        &mut kept[..=last]
    } else {
        allocated.resize(last + 1, 0.0);
        &mut allocated[..]
    };
    inner_quotients(inner * inner, quotients);
    let m = f64::from(harmonic);
    let mut outer_quotient = outer + 1.0;
    // The next quotient of the products: i_{l+1} k_{l+1} / (i_l k_l).
    let mut next = |l: usize| {
        if l > 0 {
            outer_quotient = (2 * l + 1) as f64 + outer * outer / outer_quotient;
        }
        ratio * quotients[l] * outer_quotient
    };
    let mut term = 2.0 * m + 1.0;
    for l in 0..harmonic as usize {
        term *= next(l) * (2 * l + 1) as f64 / (2 * l + 2) as f64;
    }
    let mut sum = term;
    let mut l = harmonic as usize;
    while l + 2 <= last {
        let order = l as f64;
        let weights = (2.0 * order + 5.0) * (order - m + 1.0) * (order + m + 1.0)
            / ((2.0 * order + 1.0) * (order - m + 2.0) * (order + m + 2.0));
        term *= next(l) * next(l + 1) * weights;
        sum += term;
        if term < 1e-18 * sum {
            break;
        }
        l += 2;
    }
    TAU / larger * (-screening * distance).exp() * mean_decay(inner) * sum
}

/// `(1 - exp(-2z))/(2z)`.
fn mean_decay(z: f64) -> f64 {
    if z > 0.0 { (-2.0 * z).exp_m1() / (-2.0 * z) } else { 1.0 }
}

/// `i_{l+1}(z)/(z i_l(z))`, downwards from an estimate beyond the last, where the continued fraction forgets its start.
pub(super) fn inner_quotients(square: f64, quotients: &mut [f64]) {
    let beyond = quotients.len() as f64 + 0.5;
    let mut quotient = 1.0 / (beyond + beyond.hypot(square.sqrt()));
    for (l, place) in quotients.iter_mut().enumerate().rev() {
        quotient = 1.0 / ((2 * l + 3) as f64 + square * quotient);
        *place = quotient;
    }
}

/// The order at which the terms have come down: they fall at least as `exp(-v (sqrt(l^2 + z'^2) - sqrt(m^2 + z'^2)))`, `v = ln(s/x)`.
fn last_order(harmonic: u32, outer: f64, logarithm: f64) -> usize {
    let start = outer.hypot(f64::from(harmonic));
    let reach = DIGITS / logarithm;
    // sqrt((start + reach)^2 - outer^2) without its cancellation.
    let m = f64::from(harmonic);
    (reach * (reach + 2.0 * start) + m * m).sqrt().max(m).min(HIGHEST) as usize + 4
}
