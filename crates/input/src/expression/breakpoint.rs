//! Places where an expression may have a kink or a jump.

use super::Expression;
use super::enclose::Enclosure;
use super::evaluate::run;
use super::float::between;
use super::function::Unary;
use super::interval::Interval;
use super::line::Line;
use super::program::{Operation, operand_start, stack_height};

/// Places where some part of an expression switches.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Breakpoints {
    /// Parameters strictly inside the range, rising, each to machine precision.
    pub places: Vec<f64>,
    /// Whether the search stopped early, so that there may be more: too many places, or too much
    /// work.
    pub is_cut_short: bool,
}

/// Most places that are returned.
pub const MOST_BREAKPOINTS: usize = 4096;

/// Parts into which the range is divided at the finest, as a power of two.
const FINEST: u32 = 16;
/// Operations executed at most (about a second of work).
const MOST_OPERATIONS: usize = 20_000_000;

impl Expression {
    /// Places inside a range of the parameter of `line` where an argument of `abs`, `sign`,
    /// `step` or `cbrt` changes sign, an argument of `floor` or `ceil` passes an integer, or
    /// the two sides of `min`, `max` or a comparison (the condition of `where`) pass each other.
    /// Integrals and interpolations are to be split there.
    ///
    /// Each place is the floating-point number at which the switch happens. Places closer than a
    /// few roundings of the largest parameter are given once.
    ///
    /// Best effort: parts of the range where a switch is excluded by an enclosure are left out,
    /// the others are divided down to `2^-16` of the range, so that of two switches of the same
    /// function that are closer than that and cancel (or touch without passing, as in
    /// `abs((xi - 0.3)^2)`) none may be found. A place where nothing visible happens may be among
    /// the results, as for `abs(xi)^2`.
    ///
    /// ```
    /// use shtaerman_input::expression::{Expression, Interval, Line};
    ///
    /// let base = Expression::parse("max(0, abs(xi) - 0.25)^2", &["xi"]).unwrap();
    /// let range = Interval::new(-1.0, 1.0).unwrap();
    /// let found = base.breakpoints(&Line::identity(), range);
    /// assert_eq!(found.places, [-0.25, 0.0, 0.25]);
    /// ```
    pub fn breakpoints(&self, line: &Line, range: Interval) -> Breakpoints {
        let range = range.with_finite_ends();
        let switches: Vec<Switch<'_>> = (0..self.operations.len())
            .filter_map(|index| Switch::of(&self.operations, index, line))
            .collect();
        let mut found = Breakpoints::default();
        let mut operations_left = MOST_OPERATIONS;
        for (index, switch) in switches.iter().enumerate() {
            let share = operations_left / (switches.len() - index);
            let used = switch.search(range, share / switch.operations.len().max(1), &mut found);
            operations_left = operations_left.saturating_sub(used * switch.operations.len());
        }
        found.tidy(range);
        found
    }
}

impl Breakpoints {
    fn tidy(&mut self, range: Interval) {
        let rounding = range.magnitude().upper() * f64::EPSILON;
        let near = 4.0 * rounding;
        self.places.retain(|&at| at - range.lower() > near && range.upper() - at > near);
        self.places.sort_by(f64::total_cmp);
        self.places.dedup_by(|later, earlier| *later - *earlier <= near);
        if self.places.len() > MOST_BREAKPOINTS {
            self.places.truncate(MOST_BREAKPOINTS);
            self.is_cut_short = true;
        }
    }
}

/// What a switching function looks at.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Rule {
    /// The sign of the argument.
    Sign,
    /// The sign of the difference of the two arguments.
    Difference,
    /// The step of a staircase.
    Stairs(Unary),
}

struct Switch<'a> {
    rule: Rule,
    /// Computes the one or two arguments.
    operations: &'a [Operation],
    height: usize,
    line: &'a Line,
}

impl<'a> Switch<'a> {
    /// The switch at an operation, if it is one and its arguments have variables.
    fn of(program: &'a [Operation], index: usize, line: &'a Line) -> Option<Self> {
        let rule = match program[index] {
            Operation::Unary(Unary::Abs | Unary::Sign | Unary::Step | Unary::Cbrt) => Rule::Sign,
            Operation::Unary(stairs @ (Unary::Floor | Unary::Ceil)) => Rule::Stairs(stairs),
            Operation::Binary(function) if function.is_switch() => Rule::Difference,
            _ => return None,
        };
        let mut start = operand_start(program, index);
        if rule == Rule::Difference {
            start = operand_start(program, start);
        }
        let operations = &program[start..index];
        let varies = |operation: &Operation| matches!(operation, Operation::Variable(index) if line.slope(*index) != 0.0);
        operations.iter().any(varies).then(|| Switch {
            rule,
            operations,
            height: stack_height(operations),
            line,
        })
    }

    /// The state at a parameter: the same number as long as nothing switches.
    fn state(&self, t: f64) -> f64 {
        let (last, first) = run(self.operations, self.height, |index| self.line.variable(index, t));
        match self.rule {
            Rule::Sign => Unary::Sign.value(last),
            Rule::Stairs(stairs) => stairs.value(last),
            Rule::Difference if last.is_nan() || first.is_nan() => f64::NAN,
            Rule::Difference => f64::from(first > last) - f64::from(first < last),
        }
    }

    /// Whether the state is proved to be the same on an interval.
    fn is_settled(&self, interval: Interval) -> bool {
        let (last, first) = run(self.operations, self.height, |index| {
            self.line.enclose(index, interval).map_or(Enclosure::UNKNOWN, Enclosure::defined)
        });
        if last.may_be_undefined {
            return false;
        }
        let (lower, upper) = (last.interval.lower(), last.interval.upper());
        match self.rule {
            Rule::Sign => Unary::Sign.value(lower) == Unary::Sign.value(upper),
            Rule::Stairs(stairs) => stairs.value(lower) == stairs.value(upper),
            Rule::Difference => {
                let other = first.interval;
                let is_tie = last.interval == other && other.is_point();
                let is_apart = other.upper() < lower || other.lower() > upper;
                !first.may_be_undefined && (is_tie || is_apart)
            }
        }
    }

    /// Adds the switches of a range, with so many evaluations at most; returns how many it took.
    fn search(&self, range: Interval, most: usize, found: &mut Breakpoints) -> usize {
        let mut waiting = vec![(range, 0)];
        let mut used = 0;
        while let Some((part, halvings)) = waiting.pop() {
            if used >= most || found.places.len() > 4 * MOST_BREAKPOINTS {
                found.is_cut_short = true;
                break;
            }
            used += 1;
            if self.is_settled(part) {
                continue;
            }
            let middle = part.lower().midpoint(part.upper());
            if halvings < FINEST && part.contains(middle) {
                waiting.push((Interval::ends(middle, part.upper()), halvings + 1));
                waiting.push((Interval::ends(part.lower(), middle), halvings + 1));
            } else {
                used += self.locate(part, found);
            }
        }
        used
    }

    /// Adds the place where the state at the left end of a part is left, if it is.
    fn locate(&self, part: Interval, found: &mut Breakpoints) -> usize {
        let (mut left, mut right) = (part.lower(), part.upper());
        let start = self.state(left);
        let mut end = self.state(right);
        if same(start, end) {
            return 2;
        }
        let mut halvings = 0;
        while let Some(middle) = between(left, right, halvings > 2 * FINEST) {
            halvings += 1;
            let state = self.state(middle);
            if same(state, start) {
                left = middle;
            } else {
                (right, end) = (middle, state);
            }
        }
        // The zero or the integer itself is the place, on whichever side it was found.
        let is_left = match self.rule {
            Rule::Sign | Rule::Difference => start == 0.0,
            Rule::Stairs(Unary::Ceil) => end > start,
            Rule::Stairs(_) => end < start,
        };
        let place = if is_left { left } else { right };
        // Products round to nothing there: `ceil(0.5 xi)` would step at the smallest number of all.
        found.places.push(if place.is_subnormal() { 0.0 } else { place });
        found.is_cut_short |= matches!(self.rule, Rule::Stairs(_)) && (end - start).abs() > 1.0;
        2 + halvings as usize
    }
}

fn same(u: f64, v: f64) -> bool {
    u == v || (u.is_nan() && v.is_nan())
}
