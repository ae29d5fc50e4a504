//! A function on an interval: the range of its values, its values at the two ends, its Taylor coefficients.

use std::cell::Cell;

use super::super::enclose::Enclosure;
use super::super::function::{Binary, Unary};
use super::super::interval::Interval;
use super::super::value::Value;
use super::nonlinear;
use super::series::Series;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Jet {
    pub(super) range: Enclosure,
    /// At the left and at the right end, approached from inside.
    ends: [Enclosure; 2],
    pub(super) series: Series,
}

impl Jet {
    pub(super) fn unknown() -> Self {
        Self { range: Enclosure::UNKNOWN, ends: [Enclosure::UNKNOWN; 2], series: Series::unknown() }
    }

    pub(super) fn constant(value: f64) -> Self {
        Self::same_everywhere(Enclosure::constant(value))
    }

    pub(super) fn rounded(value: f64, error: f64) -> Self {
        Self::same_everywhere(Enclosure::rounded(value, error))
    }

    fn same_everywhere(value: Enclosure) -> Self {
        let series =
            if value.is_finite() { Series::constant(value.interval) } else { Series::unknown() };
        Self { range: value, ends: [value; 2], series }
    }

    /// The number that it is everywhere.
    fn number(&self) -> Option<f64> {
        let is_number = self.series.is_constant() && self.range.interval.is_point();
        is_number.then_some(self.range.interval.lower())
    }
}

/// On which side of zero a function lies inside the interval.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Side {
    Below,
    Above,
}

/// Computes with jets of one interval.
#[derive(Debug, Clone)]
pub(super) struct Arithmetic {
    order: usize,
    /// Length of the interval and slack at its ends, in the scale of the coefficients.
    length: f64,
    slack: f64,
    scale: f64,
    /// Whether something switches at the left and at the right end.
    switches: Cell<[bool; 2]>,
}

impl Arithmetic {
    pub(super) fn new(order: usize, interval: Interval, scale: f64, slack: f64) -> Self {
        let length = (interval.length() / scale).next_up();
        // Between the slacks most of the interval is left.
        let slack = (slack / scale).min(length / 16.0);
        Self { order, length, slack, scale, switches: Cell::default() }
    }

    /// Whether something that was followed to the inside switches at the left and at the right end.
    pub(super) fn switches(&self) -> [bool; 2] {
        self.switches.get()
    }

    /// A variable that grows by `slope` with the parameter.
    pub(super) fn variable(&self, range: Interval, ends: [Interval; 2], slope: f64) -> Jet {
        let range = Enclosure::defined(range);
        if slope == 0.0 {
            return Jet::same_everywhere(range);
        }
        let (slope, _) = Interval::ends(slope, slope).times(Interval::ends(self.scale, self.scale));
        let series = Series::polynomial(vec![range.interval, slope]);
        Jet { range, ends: ends.map(Enclosure::defined), series }
    }

    pub(super) fn unary(&self, function: Unary, u: &Jet) -> Jet {
        let range = Enclosure::unary(function, u.range);
        let ends = u.ends.map(|end| Enclosure::unary(function, end));
        if u.series.is_constant() {
            return Jet::same_everywhere(range);
        }
        if !range.is_finite() {
            return Jet { range, ends, series: Series::unknown() };
        }
        let switched = match function {
            Unary::Abs => Some(self.magnitude(u, range.interval)),
            Unary::Sign | Unary::Step => {
                return self.stair(range, u, |side| function.value(side.sign()));
            }
            Unary::Floor | Unary::Ceil => return self.staircase(function, range, u),
            _ => None,
        };
        let series = switched.unwrap_or_else(|| {
            nonlinear::function(function, &u.series, range.interval, self.order)
        });
        self.tight(range, ends, series)
    }

    pub(super) fn binary(&self, function: Binary, u: &Jet, v: &Jet) -> Jet {
        let range = Enclosure::binary(function, u.range, v.range);
        let end = |index: usize| Enclosure::binary(function, u.ends[index], v.ends[index]);
        let ends = [end(0), end(1)];
        if u.series.is_constant() && v.series.is_constant() {
            return Jet::same_everywhere(range);
        }
        if !range.is_finite() {
            return Jet { range, ends, series: Series::unknown() };
        }
        let first = range.interval;
        let series = match function {
            Binary::Add => u.series.plus(&v.series),
            Binary::Subtract => u.series.minus(&v.series),
            Binary::Multiply => u.series.times(&v.series, self.order),
            Binary::Divide => u.series.over(&v.series, first, self.order),
            Binary::Power => self.power(u, v, first),
            Binary::Minimum | Binary::Maximum => self.extreme(function, u, v, first),
            Binary::Hypot => self.distance(&u.series, &v.series, first),
            Binary::Atan2 => self.angle(&u.series, &v.series, first),
            Binary::Less | Binary::LessEqual | Binary::Greater | Binary::GreaterEqual => {
                let difference = self.binary(Binary::Subtract, u, v);
                return self.stair(range, &difference, |side| function.value(side.sign(), 0.0));
            }
        };
        self.tight(range, ends, series)
    }

    pub(super) fn choose(&self, condition: &Jet, holds: &Jet, fails: &Jet) -> Jet {
        if condition.range.may_be_undefined {
            return Jet::unknown();
        }
        let is_fixed = |value: Enclosure| value.interval.is_zero();
        if is_fixed(condition.range) {
            return fails.clone();
        }
        if self.side(condition).is_some() {
            return holds.clone();
        }
        let range = Enclosure::choose(condition.range, holds.range, fails.range);
        let end = |index: usize| {
            Enclosure::choose(condition.ends[index], holds.ends[index], fails.ends[index])
        };
        Jet { range, ends: [end(0), end(1)], series: Series::cut(vec![range.interval]) }
    }

    /// Values and slopes improve each other: a function with a bounded slope does not leave the cone at either end.
    fn tight(&self, mut range: Enclosure, ends: [Enclosure; 2], series: Series) -> Jet {
        let slope = series.get(1);
        if slope.is_bounded() {
            let (forward, _) = slope.times(Interval::ends(0.0, self.length));
            for (end, change) in [(ends[0], forward), (ends[1], forward.negated())] {
                if !end.may_be_undefined {
                    range.interval = range.interval.common(end.interval.plus(change).0);
                }
            }
        }
        Jet { range, ends, series: series.with_first(range.interval) }
    }

    /// The side of zero on which a function lies but at single points and, at the ends, within the slack or the rounding of its zero.
    fn side(&self, u: &Jet) -> Option<Side> {
        let range = u.range.interval;
        if u.range.may_be_undefined || range.is_zero() {
            return None;
        }
        if range.lower() > 0.0 {
            return Some(Side::Above);
        }
        if range.upper() < 0.0 {
            return Some(Side::Below);
        }
        let slope = u.series.get(1);
        let is_rising = slope.lower() > 0.0;
        if !slope.is_bounded() || !(is_rising || slope.upper() < 0.0) {
            return None;
        }
        let [low, high] = if is_rising { u.ends } else { [u.ends[1], u.ends[0]] };
        let least = slope.magnitude().lower();
        // Where rounding of the argument hides its zero is no more known than the place of the switch.
        let gap = |end: Enclosure| {
            least * self.slack + end.interval.length().min(least * self.length / 16.0)
        };
        let side = match (low.interval.lower() >= -gap(low), high.interval.upper() <= gap(high)) {
            (true, false) => Side::Above,
            (false, true) => Side::Below,
            _ => return None,
        };
        self.note_switch(u);
        Some(side)
    }

    /// Notes the ends at which a function that decides may be zero.
    fn note_switch(&self, u: &Jet) {
        let range = u.range.interval;
        if range.lower() > 0.0 || range.upper() < 0.0 || u.series.is_constant() {
            return;
        }
        let reach = u.series.get(1).size() * self.slack;
        let is_zero = |end: Enclosure| {
            end.may_be_undefined || end.interval.lower() <= reach && end.interval.upper() >= -reach
        };
        let [left, right] = self.switches.get();
        self.switches.set([left || is_zero(u.ends[0]), right || is_zero(u.ends[1])]);
    }

    /// Steps at whole numbers.
    fn staircase(&self, function: Unary, range: Enclosure, u: &Jet) -> Jet {
        let values = u.range.interval;
        let below = values.lower().midpoint(values.upper()).floor();
        let [above_it, below_next] = [below, below + 1.0]
            .map(|whole| self.binary(Binary::Subtract, u, &Jet::constant(whole)));
        // The step that belongs to the whole number itself may be touched for long, the other one must not be.
        let is_between = if function == Unary::Floor {
            self.is_side(&above_it, Side::Above) && self.side(&below_next) == Some(Side::Below)
        } else {
            self.side(&above_it) == Some(Side::Above) && self.is_side(&below_next, Side::Below)
        };
        if is_between && !range.may_be_undefined {
            return Jet::constant(function.value(below + 0.5));
        }
        Self::jumping(range)
    }

    /// Something that is constant but for a jump where `u` changes its sign.
    fn stair(&self, range: Enclosure, u: &Jet, value: impl Fn(Side) -> f64) -> Jet {
        if range.may_be_undefined {
            return Jet { range, ..Jet::unknown() };
        }
        if range.interval.is_point() {
            self.note_switch(u);
            return Jet::same_everywhere(range);
        }
        self.side(u).map_or_else(|| Self::jumping(range), |side| Jet::constant(value(side)))
    }

    fn jumping(range: Enclosure) -> Jet {
        Jet { range, ends: [range; 2], series: Series::cut(vec![range.interval]) }
    }

    /// Whether a function lies on a side, or at most touches zero.
    fn is_side(&self, u: &Jet, side: Side) -> bool {
        let range = u.range.interval;
        let touches = match side {
            Side::Above => range.lower() >= 0.0,
            Side::Below => range.upper() <= 0.0,
        };
        if touches && !u.range.may_be_undefined {
            self.note_switch(u);
            return true;
        }
        self.side(u) == Some(side)
    }

    fn magnitude(&self, u: &Jet, first: Interval) -> Series {
        if self.is_side(u, Side::Above) {
            return u.series.clone().with_first(first);
        }
        if self.is_side(u, Side::Below) {
            return u.series.negated().with_first(first);
        }
        let slope = u.series.get(1);
        Series::cut(vec![first, slope.hull(slope.negated())])
    }

    fn extreme(&self, function: Binary, u: &Jet, v: &Jet, first: Interval) -> Series {
        let difference = self.binary(Binary::Subtract, u, v);
        let is_below = self.is_side(&difference, Side::Below);
        if is_below || self.is_side(&difference, Side::Above) {
            let chosen = if is_below == (function == Binary::Minimum) { u } else { v };
            return chosen.series.clone().with_first(first.common(chosen.range.interval));
        }
        Series::cut(vec![first, u.series.get(1).hull(v.series.get(1))])
    }

    fn power(&self, u: &Jet, v: &Jet, first: Interval) -> Series {
        if let Some(exponent) = v.number() {
            return u.series.power(exponent, first, self.order);
        }
        if u.range.interval.lower() <= 0.0 {
            return Series::cut(vec![first]);
        }
        let logarithm = self.unary(Unary::Ln, u);
        let exponent = self.binary(Binary::Multiply, v, &logarithm);
        self.unary(Unary::Exp, &exponent).series.with_first(first)
    }

    fn distance(&self, u: &Series, v: &Series, first: Interval) -> Series {
        let square = u.square(self.order).plus(&v.square(self.order));
        if !square.get(0).contains(0.0) {
            return square.root(1.0, 2.0, first, self.order);
        }
        let slopes = [u.get(1), v.get(1)].map(Enclosure::defined);
        let steepest = Enclosure::binary(Binary::Hypot, slopes[0], slopes[1]).interval.upper();
        Series::cut(vec![first, Interval::ends(-steepest, steepest)])
    }

    /// `(v u' - u v')/(u^2 + v^2)` is the slope of the angle of the point `(v, u)`, which jumps where `u = 0 > v`.
    fn angle(&self, u: &Series, v: &Series, first: Interval) -> Series {
        if v.get(0).lower() <= 0.0 && u.get(0).contains(0.0) {
            return Series::cut(vec![first]);
        }
        // About a fixed direction: the angle is that of a quotient, the tangent or its inverse.
        let [above, below] = if u.get(0).contains(0.0) { [u, v] } else { [v, u] };
        let values = above.get(0).over(below.get(0)).0;
        let quotient = above.over(below, values, self.order);
        let angle = nonlinear::function(Unary::Atan, &quotient, values, self.order);
        let angle = if u.get(0).contains(0.0) { angle } else { angle.negated() };
        angle.with_first(first)
    }
}

impl Side {
    fn sign(self) -> f64 {
        match self {
            Side::Below => -1.0,
            Side::Above => 1.0,
        }
    }
}
