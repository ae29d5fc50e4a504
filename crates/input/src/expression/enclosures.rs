//! Enclosures side by side.

use super::compiled::Compiled;
use super::enclose::Enclosure;
use super::function::{Binary, Unary};
use super::interval::Interval;
use super::intervals::Intervals;
use super::line::Line;
use super::value::Value;

/// Enclosures, each as [`Enclosure`] has it by itself: the operations of most formulae on whole vectors, others one by one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Enclosures<const COUNT: usize> {
    intervals: Intervals<COUNT>,
    may_be_undefined: [bool; COUNT],
}

impl<const COUNT: usize> Enclosures<COUNT> {
    #[inline(always)]
    pub(super) fn of(ones: [Enclosure; COUNT]) -> Self {
        Self {
            intervals: Intervals::of(&ones.map(|one| one.interval)),
            may_be_undefined: ones.map(|one| one.may_be_undefined),
        }
    }

    #[inline(always)]
    pub(super) fn ones(&self) -> [Enclosure; COUNT] {
        std::array::from_fn(|k| self.one(k))
    }

    #[inline(always)]
    fn one(&self, k: usize) -> Enclosure {
        let may_be_undefined = self.may_be_undefined[k];
        Enclosure { interval: self.intervals.one(k), may_be_undefined }
    }

    #[inline(always)]
    fn same(one: Enclosure) -> Self {
        let may_be_undefined = [one.may_be_undefined; COUNT];
        Self { intervals: Intervals::same(one.interval), may_be_undefined }
    }

    /// A result that may be undefined where its arguments may, too.
    #[inline(always)]
    fn derived(
        (intervals, may_be_undefined): (Intervals<COUNT>, [bool; COUNT]),
        arguments: [bool; COUNT],
    ) -> Self {
        let may_be_undefined = std::array::from_fn(|k| may_be_undefined[k] | arguments[k]);
        Self { intervals, may_be_undefined }
    }
}

impl<const COUNT: usize> Value for Enclosures<COUNT> {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self::same(Enclosure::constant(value))
    }

    #[inline(always)]
    fn rounded(value: f64, error: f64) -> Self {
        Self::same(Enclosure::rounded(value, error))
    }

    #[inline(always)]
    fn unary(function: Unary, u: Self) -> Self {
        match function {
            Unary::Negate => Self { intervals: u.intervals.negated(), ..u },
            Unary::Sin => Self::derived(u.intervals.sine(), u.may_be_undefined),
            Unary::Cos => Self::derived(u.intervals.cosine(), u.may_be_undefined),
            _ => one_by_one(function, &u),
        }
    }

    #[inline(always)]
    fn binary(function: Binary, u: Self, v: Self) -> Self {
        let undefined = std::array::from_fn(|k| u.may_be_undefined[k] | v.may_be_undefined[k]);
        match function {
            Binary::Add => Self::derived(u.intervals.plus(v.intervals), undefined),
            Binary::Subtract => Self::derived(u.intervals.plus(v.intervals.negated()), undefined),
            Binary::Multiply => Self::derived(u.intervals.times(v.intervals), undefined),
            Binary::Divide => Self::derived(u.intervals.over(v.intervals), undefined),
            _ => pair_by_pair(function, &u, &v),
        }
    }

    fn choose(condition: Self, holds: Self, fails: Self) -> Self {
        Self::of(std::array::from_fn(|k| {
            Enclosure::choose(condition.one(k), holds.one(k), fails.one(k))
        }))
    }
}

#[inline(never)]
fn one_by_one<const COUNT: usize>(function: Unary, u: &Enclosures<COUNT>) -> Enclosures<COUNT> {
    Enclosures::of(std::array::from_fn(|k| Enclosure::unary(function, u.one(k))))
}

#[inline(never)]
fn pair_by_pair<const COUNT: usize>(
    function: Binary,
    u: &Enclosures<COUNT>,
    v: &Enclosures<COUNT>,
) -> Enclosures<COUNT> {
    Enclosures::of(std::array::from_fn(|k| Enclosure::binary(function, u.one(k), v.one(k))))
}

/// Encloses what a program gives on several intervals of the parameter of a line, as compiled for the widest vectors that the processor has.
pub(super) fn beside<const COUNT: usize>(
    program: &Compiled,
    line: &Line,
    parameters: &[Interval; COUNT],
) -> [Enclosure; COUNT] {
    pulp::Arch::new().dispatch(Run { program, line, parameters })
}

/// A type of its own: of a closure as long as this the compiler calls a copy that is not for these vectors.
struct Run<'a, const COUNT: usize> {
    program: &'a Compiled,
    line: &'a Line,
    parameters: &'a [Interval; COUNT],
}

impl<const COUNT: usize> pulp::NullaryFnOnce for Run<'_, COUNT> {
    type Output = [Enclosure; COUNT];

    #[inline(always)]
    fn call(self) -> Self::Output {
        let parameters = Intervals::of(self.parameters);
        let run = self.program.run(
            #[inline(always)]
            |index| match self.line.enclose_beside(index, parameters) {
                Some(intervals) => Enclosures { intervals, may_be_undefined: [false; COUNT] },
                None => Enclosures::same(Enclosure::UNKNOWN),
            },
        );
        run.ones()
    }
}

/// An enclosure of the value of a variable.
pub(super) fn known(interval: Option<Interval>) -> Enclosure {
    interval.map_or(Enclosure::UNKNOWN, Enclosure::defined)
}

#[cfg(test)]
mod tests {
    use super::super::duals::tests::FORMULAE;
    use super::super::{Expression, Interval, Line};

    /// Products of what is about zero, cosines that turn too often to be looked at, overflow and underflow.
    const MORE: [&str; 6] = [
        "x*sin(x)*x - (x - 0.1)*(x + 0.1)/(x - 3)",
        "sin(1e9*x) + cos(2000*x) + cos(1e13*x)",
        "x/0 + 1/x + cos(1/x)",
        "1e300*x*1e300 - 1e300*x*x*1e300",
        "1e-300*x*1e-20/7 - x/1e300/1e20",
        "0*x + 0/(x + 5) - (x - x)",
    ];

    #[test]
    fn enclosures_side_by_side_are_those_of_each() {
        let line = Line::new(&[(0.0, 0.5), (0.5, 0.0)]);
        let places = [-1.0, -0.37, -1e-12, 0.0, 1e-300, 0.2, 0.2f64.next_up(), 0.999];
        for formula in FORMULAE.into_iter().chain(MORE) {
            let expression = Expression::parse(formula, &["x", "a"]).unwrap();
            for length in [0.0, 1e-13, 0.3, 5.0] {
                let ranges = places.map(|place| Interval::ends(place, place + length));
                let found = expression.enclose_beside(&line, &ranges);
                for (range, found) in ranges.into_iter().zip(found) {
                    let x = Interval::point(0.5).unwrap().times(range).0;
                    let alone = expression.enclose(&[x, Interval::ends(0.5, 0.5)]);
                    let bits = |ends: Interval| [ends.lower(), ends.upper()].map(f64::to_bits);
                    assert_eq!(bits(found.interval), bits(alone.interval), "{formula} {range:?}");
                    assert_eq!(found.may_be_undefined, alone.may_be_undefined, "{formula}");
                }
            }
        }
    }
}
