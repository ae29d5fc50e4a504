//! Verdicts, first regular rows and the report.

use fredholm::degenerate::regularity::{
    LARGEST_RATIO, MOST_ROWS, Parity, RegularityError, RegularityReport, Row, Verdict,
    first_regular_row,
};
use proptest::prelude::*;

use crate::regularity::direct::{Part, direct};

const BOTH: [Parity; 2] = [Parity::Even, Parity::Odd];
/// Parameters with the first rows below 1 of the even and the odd system, computed with 40 digits.
const KNOWN: [(f64, u64, u64); 9] = [
    (1e-3, 0, 1),
    (0.3, 0, 1),
    (0.34, 0, 1),
    (0.4632, 0, 1),
    (0.5, 1, 1),
    (1.0, 3, 3),
    (60.0, 122, 122),
    (1e4, 20_003, 20_004),
    (1e8, 200_000_005, 200_000_006),
];

fn first_row(parity: Parity, theta0: f64, q0: f64) -> u64 {
    first_regular_row(parity, theta0, q0).unwrap().index()
}

#[test]
fn first_rows_agree_with_bisection_in_40_digits() {
    for (theta0, even, odd) in KNOWN {
        assert_eq!(first_row(Parity::Even, theta0, 1.0), even, "theta0 = {theta0}");
        assert_eq!(first_row(Parity::Odd, theta0, 1.0), odd, "theta0 = {theta0}");
    }
    assert_eq!(first_row(Parity::Even, 1e12, 1.0), 2_000_000_000_008);
    assert_eq!(first_row(Parity::Odd, 1e12, 1.0), 2_000_000_000_008);
    for (theta0, even, odd) in
        [(0.34, 2, 3), (0.6, 3, 4), (60.0, 242, 243), (1e8, 400_000_006, 400_000_006)]
    {
        assert_eq!(first_row(Parity::Even, theta0, 0.5), even, "theta0 = {theta0}");
        assert_eq!(first_row(Parity::Odd, theta0, 0.5), odd, "theta0 = {theta0}");
    }
}

#[test]
fn direct_sums_cross_one_at_the_first_row() {
    for (theta0, even, odd) in KNOWN.into_iter().filter(|known| known.0 <= 1e4) {
        for (parity, index) in [(Parity::Even, even), (Parity::Odd, odd)] {
            let last = 1_000_000;
            assert!(theta0 * direct(Part::True, parity, index, last).upper < 1.0 - 1e-12);
            if index > parity.first_index() {
                let before = direct(Part::True, parity, index - 1, last);
                assert!(theta0 * before.lower > 1.0 + 1e-12, "theta0 = {theta0}, row {index}");
            }
        }
    }
}

#[test]
fn every_direct_sum_is_on_its_side_of_the_first_row() {
    for parity in BOTH {
        let sums: Vec<_> = (parity.first_index()..400)
            .map(|index| (index, direct(Part::True, parity, index, 40_000)))
            .collect();
        for theta0 in [1e-3, 0.3, 0.34, 0.4632, 0.5, 1.0, 7.0, 60.0] {
            let first = first_row(parity, theta0, 1.0);
            for &(index, sum) in &sums {
                let fine = if index < first {
                    theta0 * sum.lower >= 1.0
                } else {
                    theta0 * sum.upper < 1.0
                };
                assert!(fine, "theta0 = {theta0}, row {index}, first {first}: {sum:?}");
            }
        }
    }
}

#[test]
fn a_scan_of_100000_rows_finds_no_later_row_above() {
    for parity in BOTH {
        let sums: Vec<f64> = (parity.first_index()..=100_000)
            .map(|index| Row::new(parity, index).unwrap().sum())
            .collect();
        for theta0 in [1e-3, 0.3, 0.34, 0.4632, 0.5, 0.61, 1.0, 60.0, 1234.5, 1e4, 4e4] {
            let above = sums.iter().rposition(|sum| theta0 * sum >= 1.0);
            let expected = parity.first_index() + above.map_or(0, |last| last as u64 + 1);
            assert_eq!(first_row(parity, theta0, 1.0), expected, "theta0 = {theta0}");
        }
    }
}

#[test]
fn verdicts_change_at_the_sharp_conditions() {
    let complete = |report: &RegularityReport| {
        [report.even.verdict, report.odd.verdict, report.verdict]
            .map(|verdict| matches!(verdict, Verdict::CompletelyRegular { .. }))
    };
    for (theta0, expected) in [
        (0.0, [true, true, true]),
        (0.463_2, [true, true, true]),
        (0.463_203, [false, true, false]),
        (0.599_999, [false, true, false]),
        (0.6, [false, false, false]),
        (60.0, [false, false, false]),
    ] {
        let report = RegularityReport::new(theta0, 0).unwrap();
        assert_eq!(complete(&report), expected, "theta0 = {theta0}");
    }
}

#[test]
fn the_verdict_carries_the_largest_sum_or_the_first_degree() {
    let small = RegularityReport::new(0.3, 0).unwrap();
    for (verdict, supremum) in [
        (small.even.verdict, 6.0 * 2.0_f64.ln() - 2.0),
        (small.odd.verdict, 5.0 / 3.0),
        (small.verdict, 6.0 * 2.0_f64.ln() - 2.0),
    ] {
        let Verdict::CompletelyRegular { constant } = verdict else { panic!("{verdict:?}") };
        assert!((constant - 0.3 * supremum).abs() < 1e-15);
    }
    let large = RegularityReport::with_constant(1e4, 0.5, 0).unwrap();
    assert_eq!(large.even.verdict, Verdict::QuasiCompletelyRegular { from_degree: 40_006 });
    assert_eq!(large.odd.verdict, Verdict::QuasiCompletelyRegular { from_degree: 40_007 });
    assert_eq!(large.verdict, Verdict::QuasiCompletelyRegular { from_degree: 40_006 });
    assert_eq!((large.even.first_row, large.even.first_degree), (40_003, 80_006));
    assert_eq!((large.odd.first_row, large.odd.first_degree), (40_004, 80_007));
}

#[test]
fn the_joint_degree_follows_the_last_row_above_in_either_system() {
    for theta0 in [0.0, 0.3, 0.47, 0.6, 0.7, 1.0, 1.5, 3.0, 9.0, 60.0] {
        let sum = |degree: u64| {
            let parity = if degree.is_multiple_of(2) { Parity::Even } else { Parity::Odd };
            Row::new(parity, degree.div_ceil(2)).unwrap().sum()
        };
        // By a margin as documented: 0.6 * 5/3 counts as 1.
        let expected =
            (0..2000).rev().find(|&k| theta0 * sum(k) > 1.0 - 1e-14).map_or(0, |k| k + 1);
        assert_eq!(RegularityReport::new(theta0, 0).unwrap().first_degree, expected, "{theta0}");
    }
}

#[test]
fn a_level_met_exactly_counts_as_not_below() {
    assert_eq!(first_row(Parity::Odd, 0.6, 1.0), 2);
    assert_eq!(first_row(Parity::Odd, 0.3, 0.5), 2);
    assert_eq!(first_row(Parity::Odd, 0.6 - 1e-14, 1.0), 1);
}

#[test]
fn conditions_are_met_below_their_critical_values() {
    for q0 in [1.0, 0.5] {
        for theta0 in [0.1, 0.15, 0.17, 0.2, 0.3, 0.31, 0.32, 0.34, 0.35, 0.4, 0.5, 0.61] {
            let report = RegularityReport::with_constant(theta0, q0, 0).unwrap();
            for system in [&report.even, &report.odd] {
                let c = system.conditions;
                for condition in [c.printed, Some(c.corrected), Some(c.majorant), Some(c.sharp)]
                    .into_iter()
                    .flatten()
                {
                    assert_eq!(condition.met, theta0 < condition.critical_theta0, "{condition:?}");
                    assert!((condition.supremum * condition.critical_theta0 - q0).abs() < 1e-15);
                }
                assert!(c.sharp.critical_theta0 >= c.majorant.critical_theta0);
                assert!(c.majorant.critical_theta0 > c.corrected.critical_theta0);
                assert_eq!(c.sharp.met, system.first_row == system.parity.first_index());
            }
        }
    }
    let report = RegularityReport::new(0.33, 0).unwrap();
    assert!((report.even.conditions.sharp.critical_theta0 - 0.463_202).abs() < 1e-6);
    assert!((report.odd.conditions.sharp.critical_theta0 - 0.6).abs() < 1e-15);
    assert!((report.odd.conditions.majorant.critical_theta0 - 1.0 / 3.0).abs() < 1e-15);
    assert!(report.odd.conditions.printed.is_none());
}

#[test]
fn the_table_holds_theta0_times_the_sums() {
    let report = RegularityReport::new(2.5, 5).unwrap();
    let degrees = |rows: &[fredholm::degenerate::regularity::RowSums]| {
        rows.iter().map(|row| (row.row, row.degree)).collect::<Vec<_>>()
    };
    assert_eq!(degrees(&report.even.rows), [(0, 0), (1, 2), (2, 4), (3, 6), (4, 8)]);
    assert_eq!(degrees(&report.odd.rows), [(1, 1), (2, 3), (3, 5), (4, 7), (5, 9)]);
    for system in [&report.even, &report.odd] {
        for row in &system.rows {
            let bracket = direct(Part::True, system.parity, row.row, 200_000);
            assert!(bracket.contains(row.sum / 2.5, 3e-15), "{row:?}");
            let parts = row.constant_share + row.first_sum + row.second_sum;
            assert!((parts - row.majorant).abs() < 1e-14 && row.majorant >= row.sum, "{row:?}");
        }
    }
}

#[test]
fn values_without_meaning_are_refused_by_name() {
    for theta0 in [-1.0, -0.1, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = RegularityReport::new(theta0, 3).unwrap_err();
        assert!(matches!(error, RegularityError::Parameter { .. }), "{error:?}");
        assert!(error.to_string().contains(&theta0.to_string()), "{error}");
    }
    for q0 in [0.0, -0.5, 1.000_001, f64::NAN, f64::INFINITY] {
        let error = RegularityReport::with_constant(0.3, q0, 3).unwrap_err();
        assert!(matches!(error, RegularityError::Constant { .. }), "{error:?}");
    }
    for (theta0, q0) in
        [(f64::MAX, 1.0), (1.0, f64::MIN_POSITIVE), (f64::MAX, 1e-300), (1.1e12, 1.0)]
    {
        let error = RegularityReport::with_constant(theta0, q0, 3).unwrap_err();
        assert_eq!(error, RegularityError::RowTooFar { theta0, constant: q0 });
    }
    let error = RegularityReport::new(0.3, MOST_ROWS + 1).unwrap_err();
    assert_eq!(error, RegularityError::TooManyRows { rows: MOST_ROWS + 1 });
}

#[test]
fn the_smallest_parameters_are_regular_trivially() {
    for theta0 in [0.0, -0.0, f64::from_bits(1), f64::MIN_POSITIVE] {
        let report = RegularityReport::with_constant(theta0, 1e-3, 2).unwrap();
        assert_eq!((report.even.first_row, report.odd.first_row, report.first_degree), (0, 1, 0));
        assert!(
            matches!(report.verdict, Verdict::CompletelyRegular { constant } if constant < 1e-300)
        );
    }
}

proptest! {
    #[test]
    fn the_first_row_is_below_and_the_row_before_it_is_not(
        exponent in -3.0..11.0_f64,
        q0 in 0.1..=1.0_f64,
        odd: bool,
    ) {
        let (parity, theta0) = (BOTH[usize::from(odd)], 10.0_f64.powf(exponent));
        prop_assume!(theta0 / q0 <= LARGEST_RATIO);
        let first = first_regular_row(parity, theta0, q0).unwrap();
        prop_assert!(theta0 * first.sum() < q0);
        if first != Row::first(parity) {
            let before = Row::new(parity, first.index() - 1).unwrap();
            prop_assert!(theta0 * before.sum() > q0 * (1.0 - 1e-14));
        }
    }
}
