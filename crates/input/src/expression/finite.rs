//! Is an expression finite on a whole range?
//!
//! Samples cannot tell: `1/(xi - 0.3)` has its pole between any of them. Enclosures can. The
//! range is halved until every piece has a finite enclosure, or two neighbouring floating-point
//! numbers are left, whose values then decide.

use super::Expression;
use super::float::between;
use super::interval::Interval;
use super::line::Line;

/// What is known about the values of an expression on a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// Every floating-point number of the range has a finite value, and no pole hides between two
    /// of them as far as the values beside it show.
    ProvedFinite,
    /// The expression is not finite somewhere.
    NotFinite {
        /// A value of the parameter where it is not finite, or the nearest number to the place.
        at: f64,
        /// What is wrong there.
        defect: Defect,
    },
    /// The work allowed did not suffice; no value among [`SAMPLES`] evenly spaced ones was found
    /// that is not finite.
    Undecided,
}

/// How a value fails to be finite.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Defect {
    /// The value is undefined there: `0/0`, or outside the domain of a function.
    Undefined,
    /// The value is infinite there: a quotient by zero, the logarithm of zero, an overflow.
    Infinite,
    /// Finite values grow beyond bounds towards a pole between two floating-point numbers, or cannot be told from such values for their rounding.
    Unbounded,
}

impl std::fmt::Display for Defect {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            Defect::Undefined => "is undefined",
            Defect::Infinite => "is infinite",
            Defect::Unbounded => "grows without bound",
        })
    }
}

/// Evenly spaced values that are looked at when a proof takes too much work.
pub const SAMPLES: u32 = 4097;

/// Pieces the range is first cut into: each gets a fair share of the work.
const PIECES: u32 = 64;
/// Enclosures computed at most.
const MOST_ENCLOSURES: usize = 100_000;
/// Operations executed at most (about a second of work), so that long programs end as well.
const MOST_OPERATIONS: usize = 20_000_000;
/// Enclosures with slopes computed at most, and the shortest part for which one is, over the largest parameter.
const MOST_TIGHT: usize = 20_000;
const SHORTEST: f64 = 64.0 * f64::EPSILON;
/// Halvings by the mean before halving by count.
const HALVINGS_BY_MEAN: u32 = 40;

impl Expression {
    /// Decides whether the expression is finite on a closed range of the parameter of `line`.
    ///
    /// The values meant are those of [`evaluate`](Self::evaluate): `exp(-1/xi^2)` and `atan(1/xi)`
    /// are finite at 0 (where the latter jumps), since `1/0` is `inf` there and `exp(-inf)` is 0;
    /// `sin(xi)/xi` is not, since `0/0` is undefined: write
    /// `where(abs(xi) < 1e-8, 1, sin(xi)/xi)`.
    ///
    /// At most 100,000 enclosures are computed (fewer for expressions of over 200 operations).
    /// An infinite end of the range is replaced by the largest finite number.
    ///
    /// ```
    /// use shtaerman_input::expression::{Defect, Expression, Interval, Line, Verdict};
    ///
    /// let range = Interval::new(-1.0, 1.0).unwrap();
    /// let verdict = |text: &str| {
    ///     Expression::parse(text, &["xi"]).unwrap().finiteness(&Line::identity(), range)
    /// };
    /// assert_eq!(verdict("1/(xi^2 + 1e-12)"), Verdict::ProvedFinite);
    /// assert_eq!(verdict("1/(xi - 0.3)"), Verdict::NotFinite { at: 0.3, defect: Defect::Infinite });
    /// ```
    pub fn finiteness(&self, line: &Line, range: Interval) -> Verdict {
        let range = range.with_finite_ends();
        let search = Search { expression: self, line };
        let most = (MOST_OPERATIONS / self.operations.len().max(1)).min(MOST_ENCLOSURES);
        let found = search.pieces(range, most);
        match found {
            Ok(true) => Verdict::ProvedFinite,
            Ok(false) => match search.samples(range) {
                Ok(()) => Verdict::Undecided,
                Err(found) => found.into(),
            },
            Err(found) => found.into(),
        }
    }

    /// A place of a bounded range at which the expression is not finite, and how, if there is one. Where [`finiteness`](Self::finiteness) leaves it
    /// undecided, what rounding cannot tell from a pole counts as one, such as the double root in `1/(xi^2 - 0.6*xi + 0.09)`.
    pub fn find_not_finite(&self, line: &Line, range: Interval) -> Option<(f64, Defect)> {
        match self.finiteness(line, range) {
            Verdict::ProvedFinite => None,
            Verdict::NotFinite { at, defect } => Some((at, defect)),
            Verdict::Undecided => {
                self.find_not_enclosed(line, range).map(|at| (at, Defect::Unbounded))
            }
        }
    }

    /// The middle of a part of a few roundings on which values are not bounded, if one is met: bounds of slopes make enclosures of short parts
    /// narrow in spite of cancellation.
    fn find_not_enclosed(&self, line: &Line, range: Interval) -> Option<f64> {
        let shortest = SHORTEST * range.size();
        let mut waiting = vec![range];
        for _ in 0..(MOST_OPERATIONS / self.operations.len().max(1)).min(MOST_TIGHT) {
            let part = waiting.pop()?;
            if self.taylor_along(line, part, 1, 0.0).range().is_some() {
                continue;
            }
            let middle = part.lower().midpoint(part.upper());
            if part.length() <= shortest {
                return Some(middle);
            }
            waiting.push(Interval::ends(middle, part.upper()));
            waiting.push(Interval::ends(part.lower(), middle));
        }
        None
    }
}

/// A place where the expression is not finite.
struct Found {
    at: f64,
    defect: Defect,
}

impl From<Found> for Verdict {
    fn from(Found { at, defect }: Found) -> Self {
        Verdict::NotFinite { at, defect }
    }
}

struct Search<'a> {
    expression: &'a Expression,
    line: &'a Line,
}

/// A point a fraction of the way along a range, without overflow and exact at both ends.
fn along(range: Interval, step: u32, steps: u32) -> f64 {
    let fraction = f64::from(step) / f64::from(steps);
    let place = (1.0 - fraction) * range.lower() + fraction * range.upper();
    place.clamp(range.lower(), range.upper())
}

impl Search<'_> {
    fn value(&self, t: f64) -> f64 {
        self.expression.evaluate_at(self.line, t)
    }

    fn check(&self, t: f64) -> Result<(), Found> {
        let value = self.value(t);
        if value.is_nan() {
            return Err(Found { at: t, defect: Defect::Undefined });
        }
        if value.is_infinite() {
            return Err(Found { at: t, defect: Defect::Infinite });
        }
        Ok(())
    }

    fn samples(&self, range: Interval) -> Result<(), Found> {
        (0..SAMPLES).try_for_each(|step| self.check(along(range, step, SAMPLES - 1)))
    }

    /// Whether the whole range is proved finite with so many enclosures at most.
    fn pieces(&self, range: Interval, most: usize) -> Result<bool, Found> {
        if self.expression.enclose_along(self.line, range).is_finite() {
            return Ok(true);
        }
        for step in 0..=PIECES {
            self.check(along(range, step, PIECES))?;
        }
        let cuts =
            |step| Interval::ends(along(range, step, PIECES), along(range, step + 1, PIECES));
        let all: Vec<Interval> = (0..PIECES).map(cuts).collect();
        let (hard, used) = self.round(&all, range, most / 2)?;
        let (unproved, _) = self.round(&hard, range, most.saturating_sub(used))?;
        Ok(unproved.is_empty())
    }

    /// Gives each piece a fair share of so many enclosures; returns the pieces for which it did not
    /// suffice, and the enclosures used.
    fn round(
        &self,
        pieces: &[Interval],
        range: Interval,
        most: usize,
    ) -> Result<(Vec<Interval>, usize), Found> {
        let mut unproved = Vec::new();
        let mut used = 0;
        for (index, &piece) in pieces.iter().enumerate() {
            let share = most.saturating_sub(used) / (pieces.len() - index);
            let took = self.piece(piece, range, share)?;
            used += took.unwrap_or(share);
            if took.is_none() {
                unproved.push(piece);
            }
        }
        Ok((unproved, used))
    }

    /// Enclosures used to prove one piece finite, whose ends have been checked; `None` if they
    /// were more than allowed.
    fn piece(&self, piece: Interval, range: Interval, most: usize) -> Result<Option<usize>, Found> {
        let mut waiting = vec![(piece, 0)];
        let mut used = 0;
        while let Some((part, halvings)) = waiting.pop() {
            if used >= most {
                return Ok(None);
            }
            used += 1;
            let enclosure = self.expression.enclose_along(self.line, part);
            if enclosure.is_finite() {
                continue;
            }
            match between(part.lower(), part.upper(), halvings > HALVINGS_BY_MEAN) {
                Some(middle) => {
                    self.check(middle)?;
                    waiting.push((Interval::ends(middle, part.upper()), halvings + 1));
                    waiting.push((Interval::ends(part.lower(), middle), halvings + 1));
                }
                None if enclosure.interval.is_bounded() => {}
                None => self.check_growth(part, range)?,
            }
        }
        Ok(Some(used))
    }

    /// Two neighbouring numbers with finite values and perhaps a pole between.
    fn check_growth(&self, part: Interval, range: Interval) -> Result<(), Found> {
        let at = self.highest_near(part, range);
        if self.grows_towards(at, -1.0, range) || self.grows_towards(at, 1.0, range) {
            return Err(Found { at, defect: Defect::Unbounded });
        }
        Ok(())
    }

    /// The number with the largest value among the neighbours of a part, to which the enclosures
    /// can have pointed with an error of a few roundings.
    fn highest_near(&self, part: Interval, range: Interval) -> f64 {
        const NEIGHBOURS: usize = 64;
        let below = std::iter::successors(Some(part.lower()), |at| Some(at.next_down()));
        let above = std::iter::successors(Some(part.upper()), |at| Some(at.next_up()));
        let near = below.take(NEIGHBOURS).chain(above.take(NEIGHBOURS));
        let size = |at: &f64| self.value(*at).abs();
        near.filter(|&at| range.contains(at))
            .max_by(|u, v| size(u).total_cmp(&size(v)))
            .unwrap_or(part.lower())
    }

    /// Whether the values from one side grow without bound towards a place.
    ///
    /// Between distances of `2^28`, `2^18` and `2^8` roundings a pole grows by ever larger steps
    /// and a logarithm by equal ones, while a function with a limit grows by smaller ones.
    fn grows_towards(&self, at: f64, side: f64, range: Interval) -> bool {
        let rounding = at.abs().next_up() - at.abs();
        let place = |power: i32| at + side * rounding * f64::from(power).exp2();
        if !range.contains(place(28)) {
            return false;
        }
        let [far, middle, near] = [28, 18, 8].map(|power| self.value(place(power)));
        let (first, second) = (middle - far, near - middle);
        let is_noise = first.abs() <= 1e-9 * far.abs().max(middle.abs());
        !is_noise && first * second > 0.0 && second.abs() > 0.5 * first.abs()
    }
}
