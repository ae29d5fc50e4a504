//! The crown radius that keeps the peak pressure under a limit.

use super::bracket::Bracket;
use super::{Goal, InverseError};
use crate::error::positive;
use crate::golden::GOLDEN;
use crate::{Contact, Error, Problem, Profile, Scaling, Vertical};

/// Curvatures tried first, as powers of ten of that which lifts the edges by what the load presses in: two a decade.
const DECADES: std::ops::RangeInclusive<i32> = -12..=12;
/// Largest curvature, as a power of ten of the same, at which the peak is looked for above the limit.
const SHARPEST: f64 = 24.0;
/// A crown whose peak is not lower than that of the flat base by this share is none.
const BETTER: f64 = 1e-10;
/// Steps of the golden section: the last is far below what shows in the pressure.
const GOLDEN_STEPS: usize = 64;
/// Rounding of a peak pressure.
const ROUNDING: f64 = 1e-13;

/// A crown `x^2/(2 R)` and its contact.
#[derive(Debug, Clone)]
pub struct Crowned {
    /// `R` in the units of the problem; `None` for the flat base.
    pub radius: Option<f64>,
    /// The contact with this base.
    pub contact: Contact,
}

impl Crowned {
    /// The profile as a formula.
    #[must_use]
    pub fn formula(&self) -> String {
        self.radius.map_or("0".to_owned(), |radius| format!("x^2/(2*{radius:e})"))
    }

    fn peak(&self) -> f64 {
        self.contact.peak_pressure()
    }
}

/// The crowns under a limit of the peak pressure.
#[derive(Debug, Clone)]
pub struct Crown {
    /// The limit, where there is one.
    pub limit: Option<f64>,
    /// The crown of the lowest peak.
    pub best: Crowned,
    /// The sharpest crown within the limit.
    pub least: Option<Crowned>,
    /// The flattest crown within the limit, perhaps the flat base.
    pub largest: Option<Crowned>,
    /// Number of solves that it took.
    pub evaluations: usize,
}

/// The crown `x^2/(2 R)` of the lowest peak pressure, in place of the profile of the problem, and with a limit all radii that keep it: from
/// `least` to `largest`.
///
/// A flat punch peaks at its edges, a sharply crowned one in the middle: between them the peak has one minimum, sought over 24 decades of the
/// curvature, and the radii within a limit are an interval around it.
///
/// # Errors
/// [`Error::InvalidValue`] unless the limit is finite and positive; [`Error::Inverse`] when no crown keeps the limit, with the lowest peak, where the
/// lowest peak or the end of the radii lies at crowns that cannot be solved, with the last that can, and where the load prescribes no force; what
/// [`Problem::solve`] says of the problem with a flat base.
pub fn crown(problem: &Problem, limit: Option<f64>) -> Result<Crown, Error> {
    if let Some(limit) = limit {
        positive("peak pressure", limit)?;
    }
    let trials = Trials { problem, unit: curvature(problem)?, count: std::cell::Cell::new(0) };
    let flat = trials.flat()?;
    let best = trials.best(flat.clone())?;
    let (least, largest) = match limit {
        None => (None, None),
        Some(limit) if best.peak() > limit => {
            return Err(InverseError::LimitTooLow {
                limit,
                least: best.peak(),
                radius: best.radius,
                dimension: Goal::PeakPressure(limit).dimension_in(problem),
            }
            .into());
        }
        Some(limit) => {
            let largest =
                if flat.peak() <= limit { flat } else { trials.edge(&best, limit, -1.0)? };
            (Some(trials.edge(&best, limit, 1.0)?), Some(largest))
        }
    };
    Ok(Crown { limit, best, least, largest, evaluations: trials.count.get() })
}

/// The curvature that lifts the edges by what the load presses in, in the units of the problem: `2/a^2` of the elastic displacement and that of the
/// layer under the mean pressure.
fn curvature(problem: &Problem) -> Result<f64, Error> {
    let Vertical::Force(force) = problem.dimensionless_load().vertical else {
        let words = "a crown needs the force in [load]: under a prescribed settlement a sharper crown carries less";
        return Err(InverseError::Unsuited(words).into());
    };
    positive("force", force)?;
    let bodies = problem.bodies();
    let given = bodies.theta0() * force + bodies.law().displacement(0.5 * force);
    Ok(2.0 * given * bodies.unit(Scaling::displacement) / bodies.half_width().powi(2))
}

/// Solves at curvatures `unit e^t`.
struct Trials<'p> {
    problem: &'p Problem,
    unit: f64,
    count: std::cell::Cell<usize>,
}

impl Trials<'_> {
    fn flat(&self) -> Result<Crowned, Error> {
        self.solved(None)
    }

    fn at(&self, t: f64) -> Result<Crowned, Error> {
        self.solved(Some(1.0 / (self.unit * t.exp())))
    }

    fn solved(&self, radius: Option<f64>) -> Result<Crowned, Error> {
        self.count.set(self.count.get() + 1);
        let profile = match radius {
            None => Profile::flat(),
            Some(radius) => Profile::expression(&format!("x^2/(2*{radius:e})")).map_err(|_| {
                InverseError::Unsuited("the crown radius leaves the range of double precision")
            })?,
        };
        let contact = self.problem.with_profile(profile)?.solve()?;
        Ok(Crowned { radius, contact })
    }

    /// `t` of a crown.
    fn place(&self, crown: &Crowned) -> f64 {
        crown.radius.map_or(f64::NEG_INFINITY, |radius| -(radius * self.unit).ln())
    }

    /// One trial, with the reason where it was refused.
    fn trial(&self, t: f64) -> Trial {
        Trial { t, outcome: self.at(t) }
    }

    /// The crown of the lowest peak, by golden section around the best of the first trials.
    ///
    /// A crown that is refused counts as higher than all others, so that the search stays among those that can be solved, on whichever side they end.
    fn best(&self, flat: Crowned) -> Result<Crowned, Error> {
        let first: Vec<Trial> =
            DECADES.map(|k| self.trial(f64::from(k) * 0.5 * std::f64::consts::LN_10)).collect();
        let peaks: Vec<f64> = first.iter().map(Trial::peak).collect();
        let last = first.len() - 1;
        let lowest = (0..=last).min_by(|&one, &two| peaks[one].total_cmp(&peaks[two]));
        let lowest = lowest.unwrap_or(0);
        let mut best = first[lowest].clone();
        let mut ends =
            [first[lowest.saturating_sub(1)].clone(), first[(lowest + 1).min(last)].clone()];
        for _ in 0..GOLDEN_STEPS {
            let rise = ends[0].peak().max(ends[1].peak()) - best.peak();
            // All were refused, or the peak is level.
            if rise.is_nan() || rise <= ROUNDING * best.peak() {
                break;
            }
            // The longer side is divided.
            let side = usize::from(ends[1].t - best.t > best.t - ends[0].t);
            let trial = self.trial(best.t + (1.0 - GOLDEN) * (ends[side].t - best.t));
            if trial.peak() < best.peak() {
                ends[1 - side] = std::mem::replace(&mut best, trial);
            } else {
                ends[side] = trial;
            }
        }
        let best = best.outcome?;
        if best.peak() >= flat.peak() * (1.0 - BETTER) {
            return Ok(flat);
        }
        // Where the bracket ends at a crown that is refused the peak falls as far as can be solved: lower ones may be beyond.
        match ends.into_iter().find_map(|end| end.outcome.err()) {
            Some(refusal) => Err(self.unsolved(&best, &refusal)),
            None => Ok(best),
        }
    }

    /// Refuses what ends at the last crown that can be solved.
    fn unsolved(&self, last: &Crowned, refusal: &Error) -> Error {
        let peak = last.peak();
        let dimension = Goal::PeakPressure(peak).dimension_in(self.problem);
        let reason = refusal.to_string();
        InverseError::Unsolved { peak, radius: last.radius, dimension, reason }.into()
    }

    /// The last crown within the limit from the best one on, to flatter (`sign = -1`) or sharper ones.
    fn edge(&self, best: &Crowned, limit: f64, sign: f64) -> Result<Crowned, Error> {
        let farthest = SHARPEST * std::f64::consts::LN_10;
        let mut inside = self.place(best).max(-farthest);
        let mut value = best.peak() - limit;
        loop {
            let next = inside + sign * std::f64::consts::LN_10;
            let trial = self.trial(next);
            let beyond = trial.peak() - limit;
            if beyond > 0.0 {
                return self.narrowed([inside, next], [value, beyond], limit);
            }
            // As good as a point, or as flat.
            if next.abs() > farthest {
                return trial.outcome;
            }
            (inside, value) = (next, beyond);
        }
    }

    /// The crown at the limit.
    fn narrowed(&self, at: [f64; 2], values: [f64; 2], limit: f64) -> Result<Crowned, Error> {
        // Signs are turned, so that a peak at the limit counts as within it.
        let Some(bracket) = Bracket::new(at, values.map(|value| -value)) else {
            return self.at(at[0]);
        };
        let narrowed =
            bracket.narrowed(ROUNDING * limit, &mut |t| Ok(limit - self.trial(t).peak()))?;
        // Beyond the limit by no more than rounding.
        let nearer = usize::from(narrowed.values[1].abs() < narrowed.values[0].abs());
        let crown = self.at(narrowed.at[nearer])?;
        match self.at(narrowed.at[1 - nearer]) {
            Err(refusal) if narrowed.values[1 - nearer].is_infinite() => {
                Err(self.unsolved(&crown, &refusal))
            }
            _ => Ok(crown),
        }
    }
}

/// A crown that was tried.
#[derive(Debug, Clone)]
struct Trial {
    /// Logarithm of the curvature over its unit.
    t: f64,
    outcome: Result<Crowned, Error>,
}

impl Trial {
    /// The peak pressure; infinite where the crown was refused.
    fn peak(&self) -> f64 {
        self.outcome.as_ref().map_or(f64::INFINITY, Crowned::peak)
    }
}
