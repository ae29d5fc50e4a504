//! Looking for the value of one positive unknown.

use std::cell::Cell;

use super::bracket::Bracket;
use super::{Goal, InverseError};
use crate::golden::GOLDEN;
use crate::{Contact, ContactKind, Error, Law, PressureCurve, Problem};

/// Relative distance from the wanted value that counts as reached, and that which is rounding.
const REACHED: f64 = 1e-7;
const ROUNDING: f64 = 1e-13;
/// Halvings of a step of a decade whose end cannot be solved: a sixth more of the unknown is the least.
const SHORTENED: i32 = 4;
/// An extreme is known where it lies within this share of the unknown: its value is off by the square of that.
const EXTREME: f64 = 1e-4;
/// The least pressure, as a share of the mean, that is as good as none: some hundred roundings of a pressure.
const LEAST: f64 = 1e-11;
/// Share of the values at the ends of the first bracket that counts as their size.
const NEARBY: f64 = 1e-3;

/// Places at which the least pressure is looked for, those between the neighbours of the least of them, and how often these are looked at: each time they lie ten times as close.
const LOOKED_AT: usize = 401;
const CLOSER: usize = 21;
const ROUNDS: usize = 6;

/// The value found, with the contact that it gives.
#[derive(Debug, Clone)]
pub struct Found {
    /// The value of the unknown, in the units of the problem.
    pub value: f64,
    /// What was to be reached.
    pub goal: Goal,
    /// What was reached.
    pub reached: f64,
    /// The contact at this value.
    pub contact: Contact,
    /// Number of solves that it took.
    pub evaluations: usize,
}

impl Found {
    /// `|reached - wanted|` over the wanted value, or over what was reached where that is larger.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        let size = self.goal.wanted().abs().max(self.reached.abs());
        if size == 0.0 { 0.0 } else { (self.reached - self.goal.wanted()).abs() / size }
    }
}

/// Where to look for the unknown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    /// Where to begin.
    pub(super) start: f64,
    /// How far to go.
    pub(super) ends: [f64; 2],
}

/// The trials at the ends of a bracket.
type Ends = [Trial; 2];

/// One trial.
#[derive(Debug, Clone)]
struct Trial {
    /// Logarithm of the unknown.
    at: f64,
    value: f64,
    contact: Contact,
}

/// A search for the unknown that a goal asks for.
pub(super) struct Search<'s> {
    /// Name of the unknown.
    pub(super) unknown: &'static str,
    pub(super) goal: Goal,
    /// The problem with a value of the unknown.
    pub(super) posed: &'s dyn Fn(f64) -> Result<Problem, Error>,
}

impl Search<'_> {
    /// The value nearest to the start, decade by decade in both directions, then where an extreme between decades reaches it; the goal need not be monotone.
    pub(super) fn run(&self, range: Range) -> Result<Found, Error> {
        let mut trials = vec![self.trial(range.start.ln())?];
        let ends = range.ends.map(f64::ln);
        // Towards the lower end and towards the upper one, until there or until nothing more can be solved.
        let mut frontiers = [Some(trials[0].clone()), Some(trials[0].clone())];
        let mut unsolved = Vec::new();
        while frontiers.iter().any(Option::is_some) {
            for side in [0, 1] {
                let Some(before) = frontiers[side].take().filter(|one| one.at != ends[side]) else {
                    continue;
                };
                let trial = match self.next(&before, ends[side]) {
                    Ok(trial) => trial,
                    Err(error) => {
                        unsolved.extend(error.is_numerical().then_some((before, error)));
                        continue;
                    }
                };
                trials.push(trial.clone());
                if let Some(bracket) = self.bracket(&before, &trial) {
                    return self.narrow(bracket, &[before, trial], trials.len());
                }
                frontiers[side] = Some(trial);
            }
        }
        match self.at_extremes(&mut trials)? {
            Some(([one, two], bracket)) => self.narrow(bracket, &[one, two], trials.len()),
            None => Err(self.no_such_value(&trials, &unsolved).into()),
        }
    }

    /// A bracket beside an extreme between the decades, where all trials lie on one side of what is wanted; each such extreme is narrowed until there is one, and becomes a trial.
    fn at_extremes(&self, trials: &mut Vec<Trial>) -> Result<Option<(Ends, Bracket)>, Error> {
        let wanted = self.goal.wanted();
        let side = (trials[0].value - wanted).signum();
        let off = |trial: &Trial| side * (trial.value - wanted);
        trials.sort_by(|one, two| one.at.total_cmp(&two.at));
        let triples: Vec<[Trial; 3]> = (trials.windows(3))
            .filter(|three| off(&three[1]) < off(&three[0]).min(off(&three[2])))
            .map(|three| [three[0].clone(), three[1].clone(), three[2].clone()])
            .collect();
        for [mut left, mut nearest, mut right] in triples {
            while right.at - left.at > EXTREME {
                let is_left = nearest.at - left.at > right.at - nearest.at;
                let end = if is_left { left.at } else { right.at };
                let trial = match self.trial(nearest.at + (1.0 - GOLDEN) * (end - nearest.at)) {
                    Err(error) if error.is_numerical() => break,
                    trial => trial?,
                };
                trials.push(trial.clone());
                if let Some(bracket) = self.bracket(&nearest, &trial) {
                    return Ok(Some(([nearest, trial], bracket)));
                }
                let beyond = if off(&trial) < off(&nearest) {
                    std::mem::replace(&mut nearest, trial)
                } else {
                    trial
                };
                let is_left = beyond.at < nearest.at;
                *(if is_left { &mut left } else { &mut right }) = beyond;
            }
        }
        Ok(None)
    }

    /// A decade nearer to an end, or as much less as can be solved.
    fn next(&self, before: &Trial, end: f64) -> Result<Trial, Error> {
        let decade = std::f64::consts::LN_10.copysign(end - before.at);
        let step = |cut: i32| {
            let at = before.at + decade * 0.5f64.powi(cut);
            if (end - at) * decade < 0.0 { end } else { at }
        };
        let refused = match self.trial(step(0)) {
            Err(error) if error.is_numerical() => error,
            found => return found,
        };
        for cut in 1..=SHORTENED {
            match self.trial(step(cut)) {
                Err(error) if error.is_numerical() => {}
                found => return found,
            }
        }
        Err(refused)
    }

    fn trial(&self, at: f64) -> Result<Trial, Error> {
        let contact = (self.posed)(at.exp())?.solve()?;
        Ok(Trial { at, value: self.goal.of(&contact), contact })
    }

    /// The whole base kept in contact, if it pulls: as a width that much below the one wanted.
    fn kept(&self, at: f64) -> Option<Trial> {
        let contact = bilateral(&(self.posed)(at.exp()).ok()?).ok()?;
        let share = Some(least_share(&contact)).filter(|share| *share < 0.0)?;
        let value = self.goal.wanted() * (1.0 + share.clamp(-1.0, -LEAST));
        Some(Trial { at, value, contact })
    }

    fn bracket(&self, one: &Trial, two: &Trial) -> Option<Bracket> {
        let wanted = self.goal.wanted();
        Bracket::new([one.at, two.at], [one.value - wanted, two.value - wanted])
    }

    fn narrow(
        &self,
        bracket: Bracket,
        ends: &[Trial; 2],
        evaluations: usize,
    ) -> Result<Found, Error> {
        let wanted = self.goal.wanted();
        // The pressure is infinite where a smooth corner is reached: that is no size.
        let sizes = ends.iter().map(|end| end.value.abs()).filter(|size| size.is_finite());
        let ends_size = sizes.fold(0.0, f64::max);
        // A wish of zero is as close as what is nearby allows.
        let size = wanted.abs().max(NEARBY * ends_size);
        let small = ROUNDING * size;
        let mut trials = ends.to_vec();
        // Where the whole base touches, ever more force changes no width: there the least pressure tells how far it is to where that begins, and that of the base kept in contact on the other side.
        let is_level = ends.iter().any(|end| end.value == wanted && self.is_level(&end.contact));
        let kept = Cell::new(0);
        let value = |trial: &Trial| match trial.value - wanted {
            off if !is_level => off,
            0.0 => least_share(&trial.contact) * wanted,
            off => {
                kept.set(kept.get() + 1);
                let share = pulled_share(&trial.contact);
                share.map_or(off, |share| share.min(-2.0 * LEAST) * wanted)
            }
        };
        let small = if is_level { LEAST * wanted } else { small };
        let of = |at: f64| ends.iter().find(|trial| trial.at == at).map_or(0.0, value);
        let bracket = Bracket { values: bracket.at.map(of), ..bracket };
        let narrowed = bracket.narrowed(small, &mut |at| {
            let trial = match self.trial(at) {
                // Where a base is about to lift off a gap may be too narrow to be found.
                Err(error) if is_level && error.is_numerical() => self.kept(at).ok_or(error)?,
                trial => trial?,
            };
            let value = value(&trial);
            trials.push(trial);
            Ok(value)
        })?;
        let evaluations = evaluations + trials.len() - 2 + kept.get();
        let of = |side: usize| trials.iter().rev().find(|trial| trial.at == narrowed.at[side]);
        let (Some(one), Some(two)) = (of(0), of(1)) else {
            unreachable!("both ends of a bracket were tried")
        };
        let best = if two.value == wanted || distance(two, wanted) < distance(one, wanted) {
            two
        } else {
            one
        };
        if distance(best, wanted) > REACHED * size {
            let dimension = self.goal.dimension_in(best.contact.problem());
            return Err(InverseError::Jump {
                unknown: self.unknown,
                quantity: self.goal.name(),
                wanted,
                at: best.at.exp(),
                below: one.value.min(two.value),
                above: one.value.max(two.value),
                dimension,
            }
            .into());
        }
        Ok(Found {
            value: best.at.exp(),
            goal: self.goal,
            reached: best.value,
            contact: best.contact.clone(),
            evaluations,
        })
    }

    /// Whether the whole base touches where that is what is wanted, with a pressure that begins as a straight line of the force: under a power law it begins as a power, and such a base cannot be kept in contact.
    fn is_level(&self, contact: &Contact) -> bool {
        let is_power = matches!(contact.problem().foundation().law(), Law::Power(_));
        matches!(self.goal, Goal::ContactWidth(_)) && !is_power && least_share(contact) > 0.0
    }

    /// Why there is none: what is wanted lies beyond all that can be had, or beyond what can be solved, where the value that is nearest to it is the last of one side.
    fn no_such_value(&self, trials: &[Trial], unsolved: &[(Trial, Error)]) -> InverseError {
        let (unknown, quantity, wanted) = (self.unknown, self.goal.name(), self.goal.wanted());
        let dimension = self.goal.dimension_in(trials[0].contact.problem());
        let nearest =
            trials.iter().map(|trial| distance(trial, wanted)).fold(f64::INFINITY, f64::min);
        let last = unsolved.iter().find(|(last, _)| distance(last, wanted) <= nearest);
        if let Some((last, refused)) = last {
            let (at, value, reason) = (last.at.exp(), last.value, refused.to_string());
            return InverseError::NotSolved {
                unknown,
                quantity,
                wanted,
                at,
                value,
                dimension,
                reason,
            };
        }
        let values = || trials.iter().map(|trial| trial.value);
        let least = values().fold(f64::INFINITY, f64::min);
        let most = values().fold(f64::NEG_INFINITY, f64::max);
        InverseError::NoSuchValue { unknown, quantity, wanted, least, most, dimension }
    }
}

fn bilateral(problem: &Problem) -> Result<Contact, Error> {
    problem.with_solver(problem.solver().with_contact(ContactKind::Bilateral)).solve()
}

/// The same where the whole base is kept in contact, if it pulls then.
fn pulled_share(contact: &Contact) -> Option<f64> {
    let kept = bilateral(contact.problem()).ok();
    kept.map(|contact| least_share(&contact)).filter(|share| *share < 0.0)
}

/// The least pressure over the mean one; 0 where it is not finite.
fn least_share(contact: &Contact) -> f64 {
    let Ok(PressureCurve { mut x, mut pressure }) = PressureCurve::along(contact, LOOKED_AT) else {
        return 0.0;
    };
    let mut least = 0.0;
    for _ in 0..=ROUNDS {
        let lowest = (0..x.len()).min_by(|one, two| pressure[*one].total_cmp(&pressure[*two]));
        let Some(lowest) = lowest else { break };
        least = pressure[lowest];
        let [from, to] = [x[lowest.saturating_sub(1)], x[(lowest + 1).min(x.len() - 1)]];
        x = (0..CLOSER).map(|i| from + (to - from) * i as f64 / (CLOSER - 1) as f64).collect();
        let Ok(closer) = contact.pressures(&x) else { break };
        pressure = closer;
    }
    let share = least / contact.mean_pressure();
    if share.is_finite() { share } else { 0.0 }
}

fn distance(trial: &Trial, wanted: f64) -> f64 {
    (trial.value - wanted).abs()
}
