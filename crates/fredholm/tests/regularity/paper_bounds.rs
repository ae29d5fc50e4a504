//! The paper's bounds (4.2)-(4.12): which hold as printed, and which are what they say they are.

use std::f64::consts::LN_2;

use fredholm::degenerate::regularity::paper::{
    FIRST_SUM_BOUND_PRINTED, SplitEstimates, first_sum_bound, first_sum_cauchy_bound,
    first_sum_integral_bound, second_sum_bound, supremum_bound, supremum_bound_printed,
};
use fredholm::degenerate::regularity::{Parity, Row};

const BOTH: [Parity; 2] = [Parity::Even, Parity::Odd];
const EULER_GAMMA: f64 = 0.577_215_664_901_532_9;

fn rows(parity: Parity, end: u64) -> impl Iterator<Item = Row> {
    (parity.first_index()..end).map(move |index| Row::new(parity, index).unwrap())
}

/// `int_lower^upper f` by the midpoint rule in `s`, with `x = lower + (upper - lower) s^2 (3 - 2s)`.
fn integral(f: impl Fn(f64) -> f64, lower: f64, upper: f64) -> f64 {
    let panels = 200_000;
    (0..panels)
        .map(|i| {
            let s = (f64::from(i) + 0.5) / f64::from(panels);
            let weight = 6.0 * s * (1.0 - s) / f64::from(panels);
            weight * f(lower + (upper - lower) * s * s * (3.0 - 2.0 * s))
        })
        .sum::<f64>()
        * (upper - lower)
}

/// `int_1^inf f(x) dx` by `x = 1/t`.
fn integral_to_infinity(f: impl Fn(f64) -> f64) -> f64 {
    integral(|t| f(1.0 / t) / (t * t), 0.0, 1.0)
}

#[test]
fn the_constant_of_4_2_is_four_times_the_printed_one() {
    let series: f64 =
        (1..=100_000).rev().map(f64::from).map(|q| 1.0 / (q * (4.0 * q * q - 1.0))).sum();
    assert!((series - (2.0 * LN_2 - 1.0)).abs() < 1e-10);
    assert!((FIRST_SUM_BOUND_PRINTED - 0.096_573_6).abs() < 5e-8);
    assert!((4.0 * FIRST_SUM_BOUND_PRINTED - first_sum_bound(Parity::Even)).abs() < 1e-15);
    assert!((Row::first(Parity::Even).first_sum() - series).abs() < 1e-10);
    assert!((Row::first(Parity::Even).second_sum() - series).abs() < 1e-10);
}

#[test]
fn the_printed_4_2_fails_at_the_first_row_alone() {
    let failing: Vec<u64> = rows(Parity::Even, 5000)
        .filter(|row| row.first_sum() > FIRST_SUM_BOUND_PRINTED)
        .map(Row::index)
        .collect();
    assert_eq!(failing, [0]);
}

#[test]
fn the_corrected_constants_bound_every_row() {
    for parity in BOTH {
        assert!(first_sum_bound(parity) < first_sum_cauchy_bound(parity), "the least of (4.4)");
        for row in rows(parity, 5000) {
            assert!(row.first_sum() <= first_sum_bound(parity) * (1.0 + 1e-15), "{row:?}");
            assert!(row.second_sum() <= second_sum_bound(parity), "{row:?}");
            assert!(row.majorant() <= supremum_bound(parity), "{row:?}");
        }
    }
}

#[test]
fn the_cauchy_bounds_are_the_products_of_their_series() {
    let series = |term: fn(f64) -> f64| (1..=1_000_000).rev().map(|q| term(f64::from(q))).sum();
    let fourth: f64 = series(|q| (4.0 * q * q - 1.0).powi(-2));
    // The tails of these two, 1/q^2 and 4/(2q-1)^2, are both 1/1e6 to the digits compared.
    let even: f64 = series(|q| q.powi(-2)) + 1e-6;
    let odd: f64 = series(|q| 4.0 * (2.0 * q - 1.0).powi(-2)) + 1e-6;
    for (parity, coefficients) in [(Parity::Even, even), (Parity::Odd, odd)] {
        let first = (coefficients * fourth).sqrt();
        let second = (coefficients * (1.0 + 2.0 * fourth)).sqrt();
        assert!((first_sum_cauchy_bound(parity) - first).abs() < 1e-10, "{parity:?}");
        assert!((second_sum_bound(parity) - second).abs() < 1e-10, "{parity:?}");
    }
}

#[test]
fn the_chains_give_the_figures_of_4_7() {
    assert!((supremum_bound_printed() - 2.9074).abs() < 5e-5);
    assert!((1.0 / supremum_bound_printed() - 0.34395).abs() < 5e-6);
    assert!((supremum_bound(Parity::Even) - 3.1971).abs() < 6e-5);
    assert!((1.0 / supremum_bound(Parity::Even) - 0.31278).abs() < 5e-6);
    assert!((supremum_bound(Parity::Odd) - 3.2011).abs() < 5e-5);
    assert!((1.0 / supremum_bound(Parity::Odd) - 0.31239).abs() < 5e-6);
    // Wrongly derived, the printed condition is still sufficient.
    assert!(supremum_bound_printed() > Row::first(Parity::Even).sum());
}

#[test]
fn the_bound_4_8_is_the_first_term_and_the_integral_and_holds() {
    for index in [1, 2, 5, 30, 300] {
        let p = index as f64;
        let f = |x: f64| 1.0 / (x * (4.0 * (x + p) * (x + p) - 1.0));
        let expected = f(1.0) + integral_to_infinity(f);
        let found = first_sum_integral_bound(index);
        assert!((found / expected - 1.0).abs() < 1e-8, "p = {index}: {found} {expected}");
        let printed = 1.0 / (4.0 * p * p + 8.0 * p + 3.0)
            + (2.0 * p * ((2.0 * p + 1.0) / (2.0 * p + 3.0)).ln() - 2.0 * LN_2
                + (4.0 * p * p + 8.0 * p + 3.0).ln())
                / (2.0 * (4.0 * p * p - 1.0));
        assert!((found / printed - 1.0).abs() < 1e-11, "p = {index}: {found} {printed}");
    }
    for row in rows(Parity::Even, 5000).skip(1) {
        assert!(row.first_sum() < first_sum_integral_bound(row.index()), "{row:?}");
    }
}

#[test]
fn the_first_sum_is_not_of_order_one_over_p_squared() {
    let scaled =
        |index: u64| Row::new(Parity::Even, index).unwrap().first_sum() * (index as f64).powi(2);
    assert!(scaled(1_000_000) > 6.0 * scaled(10));
    for index in [1000, 1_000_000, 1_000_000_000] {
        let expected = ((index as f64).ln() + EULER_GAMMA - 1.0) / 4.0;
        assert!((scaled(index) - expected).abs() < 1.0 / index as f64, "p = {index}");
    }
}

#[test]
fn the_least_point_of_4_10_lies_inside_from_row_4_on() {
    let least = |p: f64| (4.0 * p - (4.0 * p * p + 3.0).sqrt()) / 6.0;
    assert!((least(3.0) - 0.959).abs() < 1e-3, "not inside (1, 2), against the paper");
    for index in 4..5000 {
        let p = f64::from(index);
        let x = least(p);
        assert!(x > 1.0 && x < p - 1.0);
        let slope = 12.0 * x * x - 16.0 * p * x + 4.0 * p * p - 1.0;
        assert!(slope.abs() < 1e-12 * p * p, "p_* is where h_1 is least");
    }
}

#[test]
fn the_split_agrees_with_its_terms() {
    for index in [4, 5, 17, 48, 49, 200] {
        let split = SplitEstimates::new(index).unwrap();
        let p = index as f64;
        let term = |q: u64| {
            let gap = q.abs_diff(index) as f64;
            1.0 / (q as f64 * (4.0 * gap * gap - 1.0).abs())
        };
        let near: f64 = (1..=index).map(term).sum();
        let last = 300_000;
        // The tail of sum 1/(4q^3), raised by the factor its terms exceed it by at most.
        let tail = 1.0 / (8.0 * (last as f64 + 0.5).powi(2));
        let far: f64 = (index + 1..=last).rev().map(term).sum::<f64>() + tail;
        assert!((split.near_sum / near - 1.0).abs() < 2e-14, "U at {p}: {near}");
        assert!((split.far_sum / far - 1.0).abs() < 1e-12, "V at {p}: {} {far}", split.far_sum);
        let whole = Row::new(Parity::Even, index).unwrap().second_sum();
        assert!(((split.near_sum + split.far_sum) / whole - 1.0).abs() < 1e-14);
    }
}

#[test]
fn the_bounds_4_12_hold_as_printed_but_are_not_the_integrals() {
    for index in [4, 5, 10, 40] {
        let split = SplitEstimates::new(index).unwrap();
        let p = index as f64;
        let h1 = |x: f64| 1.0 / (x * (4.0 * (p - x) * (p - x) - 1.0));
        let near = 1.0 / p + h1(1.0) + h1(p - 1.0) + integral(h1, 1.0, p - 1.0);
        let h2 = |x: f64| 1.0 / ((p + x) * (4.0 * x * x - 1.0));
        let far = h2(1.0) + integral_to_infinity(h2);
        assert!((split.near_bound / near - 1.0).abs() < 1e-8, "U at {index}: {near} {split:?}");
        assert!((split.far_bound / far - 1.0).abs() < 1e-8, "V at {index}: {far} {split:?}");
        let (near_printed, far_printed) = printed_4_12(p);
        assert!((split.near_bound_printed / near_printed - 1.0).abs() < 1e-13);
        assert!((split.far_bound_printed / far_printed - 1.0).abs() < 1e-13);
        assert!(near_printed > near * 1.001 && far_printed > far * 1.2, "p = {index}");
    }
    for index in 4..5000 {
        let split = SplitEstimates::new(index).unwrap();
        assert!(split.near_sum <= split.near_bound, "{split:?}");
        assert!(split.near_bound < split.near_bound_printed, "{split:?}");
        assert!(split.far_sum <= split.far_bound, "{split:?}");
        assert!(split.far_bound < split.far_bound_printed, "{split:?}");
    }
}

/// The right sides of (4.12), letter by letter.
fn printed_4_12(p: f64) -> (f64, f64) {
    let four = 4.0 * p * p - 1.0;
    let near = 1.0 / p
        + 1.0 / (4.0 * p * p - 8.0 * p + 3.0)
        + 1.0 / (3.0 * (p - 1.0))
        + (((2.0 * p - 3.0) * (2.0 * p - 1.0) * (p - 1.0).powi(2)).ln() - 3.0_f64.ln())
            / (2.0 * four)
        - p / four * ((2.0 * p - 3.0) / (3.0 * (2.0 * p - 1.0))).ln();
    let far = 1.0 / (3.0 * (p + 1.0))
        + ((4.0 * p + 1.0) / 2.0 * 3.0_f64.ln() - LN_2 - (1.0 + p).ln()) / four;
    (near, far)
}

#[test]
fn splits_are_offered_where_the_paper_bounds_them() {
    assert!((0..4).chain([u64::MAX]).all(|index| SplitEstimates::new(index).is_none()));
    assert!(SplitEstimates::new(4).is_some());
}
