//! The spline through measured points, enclosed: points and slopes are exact numbers, the cubics between are meant in real arithmetic.

use super::spline::Spline;
use crate::expression::Interval;

/// Values, slopes, `f''/2` and `f'''/6` on an interval.
pub(super) type Coefficients = [Interval; 4];

/// The cubic after a point: `y + s d + b d^2 + c d^3` at the distance `d` from it.
struct Cubic {
    start: Interval,
    terms: Coefficients,
}

fn number(value: f64) -> Interval {
    Interval::ends(value, value)
}

fn sum(u: Interval, v: Interval) -> Interval {
    u.plus(v).0
}

fn difference(u: Interval, v: Interval) -> Interval {
    sum(u, v.negated())
}

fn product(u: Interval, v: Interval) -> Interval {
    u.times(v).0
}

impl Cubic {
    fn of(spline: &Spline, piece: usize) -> Self {
        let [x, y, slope] = spline.point(piece).map(number);
        let [next_x, next_y, next_slope] = spline.point(piece + 1).map(number);
        let width = difference(next_x, x);
        let chord = difference(next_y, y).over(width).0;
        let (left, right) = (difference(chord, slope), difference(next_slope, chord));
        let second = difference(product(number(2.0), left), right).over(width).0;
        let third = difference(right, left).over(width.square()).0;
        Self { start: x, terms: [y, slope, second, third] }
    }

    /// About a place.
    fn about(&self, place: f64) -> Coefficients {
        let d = difference(number(place), self.start);
        let [y, s, b, c] = self.terms;
        let times = |factor: f64, u| product(number(factor), u);
        let b_there = sum(b, times(3.0, product(c, d)));
        let slope = sum(s, product(d, sum(times(2.0, b), times(3.0, product(c, d)))));
        let value = sum(y, product(d, sum(s, product(d, sum(b, product(c, d))))));
        [value, slope, b_there, c]
    }

    /// The value alone on a short interval, by Horner's scheme.
    fn value_on(&self, interval: Interval) -> Interval {
        let d = difference(interval, self.start);
        let [y, s, b, c] = self.terms;
        sum(y, product(d, sum(s, product(d, sum(b, product(c, d))))))
    }

    /// On an interval.
    fn on(&self, interval: Interval) -> Coefficients {
        let middle = interval.lower().midpoint(interval.upper());
        let [value, slope, second, third] = self.about(middle);
        let d = difference(interval, number(middle));
        let [twice, thrice] = [2.0, 3.0].map(number);
        let bend = sum(second, product(product(thrice, third), d));
        let slopes = Interval::quadratic(product(twice, second), product(thrice, third), d);
        [sum(value, Interval::quadratic(slope, bend, d)), sum(slope, slopes), bend, third]
    }
}

impl Spline {
    /// Coefficients of the cubic or, across points, of the cubics on an interval of `x`, and whether it is a single one. A cubic that is
    /// met within the slack at an end only does not count.
    pub(super) fn enclose(&self, x: Interval, slack: f64) -> (Coefficients, bool) {
        let on = |piece: usize, part: Interval| Cubic::of(self, piece).on(part);
        let hull = |u: Coefficients, v: Coefficients| {
            [u[0].hull(v[0]), u[1].hull(v[1]), u[2].hull(v[2]), u[3].hull(v[3])]
        };
        self.over(x, slack, on, hull)
    }

    /// The value alone on a short interval.
    pub(super) fn enclose_value(&self, x: Interval, slack: f64) -> Interval {
        let on = |piece: usize, part: Interval| Cubic::of(self, piece).value_on(part);
        self.over(x, slack, on, Interval::hull).0
    }

    /// What is found on the parts of an interval together, and whether it is a single one.
    fn over<T>(
        &self,
        x: Interval,
        slack: f64,
        on: impl Fn(usize, Interval) -> T,
        hull: impl Fn(T, T) -> T,
    ) -> (T, bool) {
        let slack = slack.min(x.length() / 16.0);
        let last_piece = self.len() - 2;
        let before = |count: usize| count.saturating_sub(1).min(last_piece);
        let knots = self.abscissas();
        let first = before(knots.partition_point(|&knot| knot <= x.lower() + slack));
        let last = before(knots.partition_point(|&knot| knot < x.upper() - slack)).max(first);
        let part = |piece: usize| {
            let left = if piece == first { x.lower() } else { knots[piece] };
            let right = if piece == last { x.upper() } else { knots[piece + 1] };
            on(piece, Interval::ends(left, right))
        };
        ((first + 1..=last).map(part).fold(part(first), hull), first == last)
    }
}
