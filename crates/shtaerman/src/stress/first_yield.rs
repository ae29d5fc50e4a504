//! The load at which yield begins.

use serde::Serialize;

use super::{Criterion, Peak, StressField};
use crate::error::positive;
use crate::{Error, Load, Problem, Rotational, Vertical};

/// Doublings or halvings of the load in search of a bracket.
const DOUBLINGS: usize = 60;
/// Steps of the root finder, and the relative width of the bracket that ends it.
const STEPS: usize = 80;
const SETTLED: f64 = 1e-11;
/// A stress that does not grow with the load any more, and whose error is more than this share of the yield stress, does not reach that.
const UNKNOWN: f64 = 1e-3;
/// A largest stress that is off by more than this share where the bracket ends jumps there.
const JUMP: f64 = 1e-6;
/// A load whose largest stress is certain is first looked for at this many times the share that the stress is off by, then at this many times as far, up to that share of the load.
const FARTHER: f64 = 4.0;
const FARTHEST: f64 = 0.5;

/// The load at first yield.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FirstYield {
    /// The criterion.
    pub criterion: Criterion,
    /// Force per unit length, in the units of the problem.
    pub force: f64,
    /// How far that force may be off at most, an estimate: with so much more the largest stress is above the yield stress, with so much less below it, by more than is
    /// stated of the stresses under these two loads ([`StressField::error`]).
    pub error: f64,
    /// Moment per unit length.
    pub moment: f64,
    /// That force over the force of the problem.
    pub factor: f64,
    /// Where yield begins.
    pub place: Peak,
}

impl Problem {
    /// The force at which the largest equivalent stress reaches `yield_stress`, by re-solving: stress is not proportional to the load where the contact is rough
    /// or its zones grow. Force and moment are scaled together, so the eccentricity stays; a prescribed tilt stays as it is; where a settlement is prescribed, the force
    /// that belongs to it is scaled.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `yield_stress` is positive; [`Error::NoYield`] when no load has that largest stress, or none is known to; those of [`Problem::solve`] and [`StressField::new`].
    pub fn first_yield(
        &self,
        criterion: Criterion,
        yield_stress: f64,
        poisson_ratio: Option<f64>,
    ) -> Result<FirstYield, Error> {
        positive("yield_stress", yield_stress)?;
        self.check_stresses()?;
        let contact = self.solve()?;
        let field = StressField::new(&contact, poisson_ratio)?;
        let (force, moment) = (contact.force(), contact.moment());
        let search =
            Search { problem: self, criterion, yield_stress, poisson_ratio, force, moment };
        search.run(field.peak(criterion), field.error())
    }
}

struct Search<'p> {
    problem: &'p Problem,
    criterion: Criterion,
    yield_stress: f64,
    poisson_ratio: Option<f64>,
    force: f64,
    moment: f64,
}

/// A factor of the load with its largest stress.
#[derive(Clone, Copy)]
struct Trial {
    factor: f64,
    peak: Peak,
    /// Of a stress.
    error: f64,
    load: [f64; 2],
}

impl Search<'_> {
    fn run(&self, peak: Peak, error: f64) -> Result<FirstYield, Error> {
        let given = Trial { factor: 1.0, peak, error, load: [self.force, self.moment] };
        if !peak.value.is_finite() || self.force == 0.0 {
            return Err(self.none(peak.value));
        }
        let above = self.excess(&given) > 0.0;
        let mut one = given;
        for _ in 0..DOUBLINGS {
            let next = self.trial(one.factor * if above { 0.5 } else { 2.0 })?;
            // Where more load is a uniform pressure, which a body without volume change does not feel, the stress stays as it is, and rounding of the pressure would yield at last.
            let stays = (next.peak.value - one.peak.value).abs() <= next.error;
            if !above && stays && next.error > UNKNOWN * self.yield_stress {
                break;
            }
            let two = std::mem::replace(&mut one, next);
            if (self.excess(&one) > 0.0) != above {
                return self.root(one, two);
            }
            // What is left without load is the profile's; more halvings change nothing.
            let change = (one.peak.value - two.peak.value).abs();
            if above && change <= 1e-9 * one.peak.value {
                break;
            }
        }
        Err(self.none(one.peak.value))
    }

    /// Between two trials on either side, by regula falsi in the logarithms with halved weights.
    fn root(&self, one: Trial, two: Trial) -> Result<FirstYield, Error> {
        let (mut one, mut two) = (one, two);
        let (mut first, mut second) = (self.excess(&one), self.excess(&two));
        let mut best = if first.abs() < second.abs() { one } else { two };
        for _ in 0..STEPS {
            let [left, right] = [one.factor.ln(), two.factor.ln()];
            if (left - right).abs() <= SETTLED || self.excess(&best).abs() <= 1e-13 {
                break;
            }
            let middle = (left * second - right * first) / (second - first);
            let inside = middle > left.min(right) && middle < left.max(right);
            let middle = if inside { middle } else { left.midpoint(right) };
            let trial = self.trial(middle.exp())?;
            let excess = self.excess(&trial);
            if excess.abs() < self.excess(&best).abs() {
                best = trial;
            }
            if (excess > 0.0) == (second > 0.0) {
                (two, second) = (trial, excess);
                first *= 0.5;
            } else {
                (one, first) = (two, second);
                (two, second) = (trial, excess);
            }
        }
        // Where the largest stress jumps, as where an edge reaches a corner, it is the load above the jump that has it.
        let above = if first > 0.0 { one } else { two };
        let best = if self.excess(&best).abs() > JUMP { above } else { best };
        let error = self.distance(&best, 1.0)?.max(self.distance(&best, -1.0)?);
        let Trial { factor, peak, load: [force, moment], .. } = best;
        Ok(FirstYield { criterion: self.criterion, force, error, moment, factor, place: peak })
    }

    /// How far from the force of a trial one is, more of it or less, whose largest stress is certainly on the same side of the yield stress.
    fn distance(&self, best: &Trial, side: f64) -> Result<f64, Error> {
        let mut share = FARTHER * (best.error / self.yield_stress).max(SETTLED);
        // What is not a number ends the search as well.
        while share <= FARTHEST {
            let beyond = self.trial(best.factor * (1.0 + side * share))?;
            if side * (beyond.peak.value - self.yield_stress) > beyond.error {
                return Ok((beyond.load[0] - best.load[0]).abs());
            }
            share *= FARTHER;
        }
        Err(self.none(best.peak.value))
    }

    fn trial(&self, factor: f64) -> Result<Trial, Error> {
        let rotational = match self.problem.load().rotational {
            Rotational::Moment(_) => Rotational::Moment(factor * self.moment),
            kept => kept,
        };
        let load = Load::new(Vertical::Force(factor * self.force), rotational)?;
        let contact = self.problem.with_load(load)?.solve()?;
        let field = StressField::new(&contact, self.poisson_ratio)?;
        let load = [contact.force(), contact.moment()];
        Ok(Trial { factor, peak: field.peak(self.criterion), error: field.error(), load })
    }

    /// `ln(stress/yield stress)`: close to a straight line over the logarithm of the load.
    fn excess(&self, trial: &Trial) -> f64 {
        (trial.peak.value / self.yield_stress).max(f64::MIN_POSITIVE).ln()
    }

    fn none(&self, nearest: f64) -> Error {
        Error::NoYield { yield_stress: self.yield_stress, nearest }
    }
}
