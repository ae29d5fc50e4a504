//! Row sums term by term from the definition, with a bracket of what is left out.

use std::f64::consts::LN_2;

use fredholm::degenerate::regularity::Parity;

/// A number known to lie between two others.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bracket {
    pub(crate) lower: f64,
    pub(crate) upper: f64,
}

impl Bracket {
    /// Whether `value` lies inside, but for rounding of `relative` times its size.
    pub(crate) fn contains(self, value: f64, relative: f64) -> bool {
        let slack = relative * value.abs();
        self.lower - slack <= value && value <= self.upper + slack
    }
}

/// Which absolute values are added up.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Part {
    /// `|R_km|` as it is.
    True,
    /// The two terms of `R_km`, each by its absolute value.
    Majorant,
    /// The term in `k + m`, without `m = 0`.
    First,
    /// The term in `k - m`, without `m = 0`.
    Second,
}

/// Factor `a_m` of the kernel's expansion.
fn coefficient(m: u64) -> f64 {
    if m == 0 { LN_2 } else { 2.0 / m as f64 }
}

/// `1/(j^2-1)`.
fn term(j: f64) -> f64 {
    1.0 / ((j - 1.0) * (j + 1.0))
}

fn entry(part: Part, k: u64, m: u64) -> f64 {
    let (plus, minus) = (term((k + m) as f64), term(k.abs_diff(m) as f64));
    coefficient(m)
        * match part {
            Part::True => (plus + minus).abs(),
            Part::Majorant => plus.abs() + minus.abs(),
            Part::First => plus.abs(),
            Part::Second => minus.abs(),
        }
}

/// `R_km = int_0^pi cos(kt) cos(mt) sin(t) dt` by Simpson's rule.
fn gram_entry(k: u64, m: u64) -> f64 {
    let intervals = 4000;
    let step = std::f64::consts::PI / f64::from(intervals);
    let value = |i: i32| {
        let t = step * f64::from(i);
        (k as f64 * t).cos() * (m as f64 * t).cos() * t.sin()
    };
    let weight = |i: i32| {
        if i == 0 || i == intervals { 1.0 } else { f64::from(2 + 2 * (i % 2)) }
    };
    (0..=intervals).map(|i| weight(i) * value(i)).sum::<f64>() * step / 3.0
}

/// The sum of row `p` over all degrees up to about `last`, added with compensation, and a bracket of the rest.
///
/// Beyond the diagonal, `m^3` times a term is monotone in `m` and tends to a known limit, and
/// `sum_{j>=1} (M+2j)^-3` lies between its trapezoidal bound and its midpoint bound.
pub(crate) fn direct(part: Part, parity: Parity, row: u64, last: u64) -> Bracket {
    let parity_bit = u64::from(parity == Parity::Odd);
    let k = 2 * row - parity_bit;
    let constant = u64::from(parity == Parity::Even && matches!(part, Part::First | Part::Second));
    let start = parity_bit + 2 * constant;
    let end = last.max(k + 4) / 2 * 2 + parity_bit;
    let (mut sum, mut lost) = (0.0_f64, 0.0_f64);
    for m in (start..=end).rev().step_by(2) {
        let value = entry(part, k, m);
        let next = sum + value;
        lost += if sum >= value { (sum - next) + value } else { (value - next) + sum };
        sum = next;
    }
    let limit: f64 = match part {
        Part::True | Part::Majorant => 4.0,
        Part::First | Part::Second => 2.0,
    };
    let edge = end as f64;
    let at_end = entry(part, k, end) * edge.powi(3);
    let (shortest, longest) =
        (0.25 / (edge + 2.0).powi(2) + 0.5 / (edge + 2.0).powi(3), 0.25 / (edge + 1.0).powi(2));
    Bracket {
        lower: sum + (lost + shortest * limit.min(at_end)),
        upper: sum + (lost + longest * limit.max(at_end)),
    }
}

#[test]
fn the_terms_added_up_are_the_gram_entries() {
    for k in 0..14 {
        for m in (k % 2..14).step_by(2) {
            let closed = entry(Part::True, k, m) / coefficient(m);
            let integral = gram_entry(k, m).abs();
            assert!((closed - integral).abs() < 1e-8, "R at ({k}, {m}): {closed} {integral}");
        }
    }
}

#[test]
fn the_bracket_closes_as_more_terms_are_added() {
    let wide = direct(Part::True, Parity::Even, 3, 100);
    let narrow = direct(Part::True, Parity::Even, 3, 100_000);
    assert!(wide.lower < wide.upper && wide.upper - wide.lower < 1e-5);
    assert!(wide.lower < narrow.lower && narrow.upper < wide.upper);
}
