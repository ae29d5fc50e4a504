//! Closed forms of the row sums, and that they decrease.

use std::f64::consts::{LN_2, PI};

use fredholm::degenerate::regularity::{LAST_ROW, Parity, RegularityError, Row};

use crate::regularity::direct::{Part, direct};

const BOTH: [Parity; 2] = [Parity::Even, Parity::Odd];

fn row(parity: Parity, index: u64) -> Row {
    Row::new(parity, index).unwrap()
}

#[test]
fn sums_agree_with_direct_summation() {
    let far = [48, 49, 50, 100, 333, 1000, 4000];
    for parity in BOTH {
        for index in (parity.first_index()..20).chain(far) {
            let row = row(parity, index);
            let last = 1_000_000;
            for (part, value) in [
                (Part::True, row.sum()),
                (Part::Majorant, row.majorant()),
                (Part::First, row.first_sum()),
                (Part::Second, row.second_sum()),
            ] {
                let bracket = direct(part, parity, index, last);
                assert!(bracket.contains(value, 2e-15), "{row:?} {part:?}: {value} {bracket:?}");
                assert!(bracket.upper - bracket.lower < 1e-14, "{row:?} {part:?}: {bracket:?}");
            }
        }
    }
}

#[test]
fn sums_agree_with_direct_summation_at_row_100000() {
    for parity in BOTH {
        let bracket = direct(Part::True, parity, 100_000, 20_000_000);
        let value = row(parity, 100_000).sum();
        assert!(bracket.contains(value, 2e-15), "{parity:?}: {value} {bracket:?}");
        assert!(bracket.upper - bracket.lower < 1e-13 * value, "{parity:?}: {bracket:?}");
    }
}

#[test]
fn sums_agree_with_values_to_17_digits() {
    // Summed term by term with 40 digits, the tail by the Euler-Maclaurin formula.
    let even = [
        (0, 2.158_883_083_359_672),
        (1, 1.626_790_768_515_592),
        (2, 1.096_151_804_496_769_2),
        (3, 0.737_226_183_659_74),
        (40, 0.051_235_413_821_537_57),
        (500, 0.004_012_968_951_190_798),
        (20_000, 0.000_100_012_717_297_379),
    ];
    let odd = [
        (1, 5.0 / 3.0),
        (2, 1.628_571_428_571_428_6),
        (3, 0.947_474_747_474_747_5),
        (40, 0.052_117_984_769_905_67),
        (500, 0.004_018_386_001_579_124),
        (20_000, 0.000_100_016_084_441_817_68),
    ];
    for (index, expected) in even {
        assert!((row(Parity::Even, index).sum() / expected - 1.0).abs() < 1e-15, "even {index}");
    }
    for (index, expected) in odd {
        assert!((row(Parity::Odd, index).sum() / expected - 1.0).abs() < 1e-15, "odd {index}");
    }
}

#[test]
fn the_majorant_is_made_of_its_parts_and_exceeds_the_sum_by_the_diagonal_alone() {
    for parity in BOTH {
        for index in (parity.first_index()..2000).chain([1 << 20, 1 << 40]) {
            let row = row(parity, index);
            let parts = row.constant_share() + row.first_sum() + row.second_sum();
            assert!((parts / row.majorant() - 1.0).abs() < 4e-15, "{row:?}");
            let k = row.degree() as f64;
            // Twice the smaller of the two terms of the diagonal entry, times a_k.
            let excess = if index == 0 { 0.0 } else { 4.0 / (k * (4.0 * k * k - 1.0)) };
            let found = row.majorant() - row.sum();
            assert!((found - excess).abs() < 4e-15 * row.sum(), "{row:?}: {found} {excess}");
        }
    }
}

#[test]
fn sums_and_majorants_decrease_from_the_first_row_on() {
    for parity in BOTH {
        let mut last = Row::first(parity);
        for index in last.index() + 1..200_000 {
            let next = row(parity, index);
            assert!(next.sum() < last.sum(), "{next:?}");
            assert!(next.majorant() < last.majorant(), "{next:?}");
            last = next;
        }
    }
}

/// The numbers the proof of monotonicity rests on, from their definitions.
#[test]
fn the_steps_of_the_proof_hold() {
    let odd_harmonic = |p: u32| (1..=p).map(|j| 1.0 / f64::from(2 * j - 1)).sum::<f64>();
    let c = |p: u32| 4.0 * odd_harmonic(p) - 2.0 * LN_2;
    let a = |p: u32| {
        let p = f64::from(p);
        2.0 / p * (1.0 - 1.0 / (16.0 * p * p - 1.0))
    };
    let b = |n: u32| {
        let p = f64::from(n);
        c(n) / (4.0 * p * p - 1.0) - (2.0 * p - 1.0).powi(-2) - (2.0 * p + 1.0).powi(-2)
    };
    let d = |n: u32| odd_harmonic(n - 1) / f64::from(n - 1) - odd_harmonic(n) / f64::from(n);
    assert!(c(2) > 3.946 && c(2) - 1.0 - 50.0 / 21.0 > 0.56);
    assert!(a(1) - a(2) > 0.79 && b(1) - b(2) > -0.353);
    for n in 1..300 {
        let p = f64::from(n);
        assert!(a(n) - a(n + 1) >= 356.0 / 225.0 / (p * (p + 1.0)), "A at {n}");
        let u = 2.0 * p + 1.0;
        let bracket = c(n) - (u - 2.0) / u - 2.0 * u * u / (u * u - 4.0);
        let step = 4.0 / (u * (u * u - 4.0)) * bracket;
        assert!((b(n) - b(n + 1) - step).abs() < 1e-15, "B at {n}");
        if n >= 2 {
            let bracket = odd_harmonic(n - 1) / (p - 1.0) - (3.0 * p + 1.0) / (4.0 * p * p - 1.0);
            let step = 2.0 / (p * (p + 1.0)) * bracket;
            assert!(bracket > 0.0 && (d(n) - d(n + 1) - step).abs() < 1e-15, "D at {n}");
        }
    }
}

#[test]
fn first_rows_are_the_known_suprema() {
    assert!((Row::first(Parity::Even).sum() - 2.158_883).abs() < 1e-6);
    assert!((Row::first(Parity::Odd).sum() - 5.0 / 3.0).abs() < 1e-15);
    assert!((Row::first(Parity::Odd).majorant() - 3.0).abs() < 1e-15);
    assert!((Row::first(Parity::Odd).first_sum() - (PI * PI / 8.0 - 0.5)).abs() < 1e-15);
}

#[test]
fn rows_outside_the_systems_are_refused_with_their_index() {
    let refused = RegularityError::NoSuchRow { parity: Parity::Odd, index: 0 };
    assert_eq!(Row::new(Parity::Odd, 0), Err(refused));
    assert!(refused.to_string().contains("the odd system has no row p = 0; rows run from 1"));
    for parity in BOTH {
        assert!(Row::new(parity, LAST_ROW + 1).is_err() && Row::new(parity, u64::MAX).is_err());
        let last = row(parity, LAST_ROW);
        assert!(last.sum() > 0.0 && (last.sum() * LAST_ROW as f64 - 2.0).abs() < 1e-12);
    }
}
