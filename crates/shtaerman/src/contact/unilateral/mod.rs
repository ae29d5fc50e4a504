//! Unilateral contact: the pressure never pulls, the base never penetrates, and where it touches is part of the answer.
//!
//! The [topology](topology) is found on cells; the [edges](edges) of the zones by Newton's method on collocated pressures; the
//! [check](check) of the answer between its nodes corrects the topology where that was too coarse.

mod anchor;
mod answer;
mod base;
mod between;
mod check;
mod coarse;
mod effort;
mod elimination;
mod ends;
mod equation;
mod extent;
mod field;
mod first;
mod harmonic;
mod layer;
mod linearised;
mod mirror;
mod power;
mod refinement;
mod ring;
mod solved;
mod spots;
mod system;
mod topology;

use answer::UnilateralContact;

use std::sync::Arc;

use super::edges::settle;
use super::parts::{Parts, require_few};
use super::search::{ALLOWED, Equation, complementary};
use super::setting::Setting;
use super::solution::Solution;
use crate::solver::AIM;
use crate::{ContactKind, Error};
use base::Base;
use check::check;
use refinement::{ALL_NOISE, RATIO, refined};
use spots::SpotContact;

/// Relative error aimed at for large `theta0`, over `theta0` and what is aimed at without a layer.
const ROUNDED: f64 = 0.1;

/// How near a cut of a wave it must not touch.
const BESIDE: f64 = 1e-8;
/// Relative errors from which on heights are counted from a tangent, and the length of base within which all zones must lie for that.
const DIGITS_LOST: f64 = 1e-11;
const SMALL_ZONES: f64 = 0.1;

impl Setting {
    /// The solution with the pressure nowhere negative: the zones of contact are part of the answer.
    ///
    /// `p0 + theta0 int ln(1/|xi - eta|) p0 deta = delta0 - alpha0 xi - f0(xi)` and `p0 >= 0` on the zones, `p0 = 0` at their free edges, and outside
    /// them on the base a gap that is not negative.
    pub(super) fn lifting(&self) -> Result<Arc<dyn Solution>, Error> {
        Ok(lifted(Base::new(self, ContactKind::Unilateral)?)?.solution())
    }

    /// The whole base in contact, where the pressure may pull, on panels; none where they do not serve.
    pub(super) fn whole_base_on_panels(&self) -> Result<Option<Arc<dyn Solution>>, Error> {
        let base = Base::new(self, ContactKind::Bilateral)?;
        Ok(spots::solve_whole(&base)?.map(|contact| Arc::new(contact) as Arc<dyn Solution>))
    }

    /// The same by the equations of the zones, in every geometry and for every layer but a smooth one.
    pub(super) fn whole_base(&self) -> Result<Arc<dyn Solution>, Error> {
        let base = Base::new(self, ContactKind::Bilateral)?;
        let is_bent_wave = base.medium.is_closed() && !base.breaks.is_empty();
        if (base.is_for_panels() || is_bent_wave)
            && let Some(contact) = spots::solve_whole(&base)?
        {
            return Ok(Arc::new(contact));
        }
        require_few(&base.breaks)?;
        Ok(Arc::new(full(&base)?))
    }

    /// The same by collocation on these parts.
    pub(super) fn collocated(&self, parts: &Parts) -> Result<Arc<dyn Solution>, Error> {
        Ok(Arc::new(full(&Base::new(self, ContactKind::Bilateral)?.cut(parts))?))
    }
}

/// An answer on zones or on cells.
enum Answer {
    Zones(Box<UnilateralContact>),
    Spots(Box<SpotContact>),
}

impl Answer {
    fn zones(contact: UnilateralContact) -> Self {
        Self::Zones(Box::new(contact))
    }

    fn solution(self) -> Arc<dyn Solution> {
        match self {
            Self::Zones(contact) => Arc::new(*contact),
            Self::Spots(contact) => Arc::new(*contact),
        }
    }

    /// Whether a wave that was cut here touches beside the cut.
    fn touches_about(&self, cut: f64) -> bool {
        let solution: &dyn Solution = match self {
            Self::Zones(contact) => contact.as_ref(),
            Self::Spots(contact) => contact.as_ref(),
        };
        let beside = [-BESIDE, 0.0, 2.0 - BESIDE, BESIDE, 2.0 + BESIDE].map(|step| cut + step);
        let mut on_base = beside.into_iter().filter(|xi| xi.abs() <= 1.0);
        on_base.any(|xi| solution.touches(xi))
    }
}

/// The answer on the whole base.
fn full(base: &Base<'_>) -> Result<UnilateralContact, Error> {
    let solved = if base.medium.is_closed() {
        ring::solve(base)?
    } else {
        let zones = base.whole();
        let resolution = base.effort(&zones, None)?;
        refined(base, &settle(base, &zones, &resolution)?, resolution.strength * RATIO)?
    };
    let left = check(base, &solved, ALLOWED);
    if !base.layer.is_linear() && !left.pulling.is_empty() {
        let at = left.pulling[0].iter().sum::<f64>() * 0.5;
        let half_width = base.problem.frame().half_width();
        let variable = base.problem.frame().coordinate();
        return Err(Error::Pulls { variable, at: at * half_width });
    }
    harmonic::answer(base, solved, &left)
}

/// The answer where the base may lift off.
fn lifted(base: Base<'_>) -> Result<Answer, Error> {
    if !base.has_panels() {
        require_few(&base.breaks)?;
    }
    if !base.medium.is_closed() {
        return open(&base).map_err(|error| match error {
            // That of cells, where heights are known to rounding alone; and 1 + theta0 K is positive, whatever rounding makes of it.
            Error::Equation(_) if error.is_numerical() => {
                Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN }
            }
            other => other,
        });
    }
    if let Some(answer) = bent_wave(&base)? {
        return Ok(answer);
    }
    let solved = ring::solve(&base)?;
    let noise = solved.stated.accuracy.pressure / solved.largest().max(f64::MIN_POSITIVE);
    let left = check(&base, &solved, ALLOWED.max(2.0 * noise));
    let is_full = noise <= ALL_NOISE && left.pulling.is_empty();
    if is_full && !ring::lifts(&base, &solved) {
        return harmonic::answer(&base, solved, &left).map(Answer::zones);
    }
    // Seen from the middle of a gap the wave is one more base with ends.
    let cells = base.cells();
    let cut = match coarse::gap(&base, cells)? {
        Some(middle) => middle,
        None => ring::least(&solved),
    };
    open(&base.shifted(cut))
}

/// The answer for a wave without gaps whose profile bends, of which no Fourier series is short: in full contact or cut where that pulls most; none where panels do not serve.
fn bent_wave(base: &Base<'_>) -> Result<Option<Answer>, Error> {
    let is_measured = base.problem.profile().measured_points().is_some();
    if !base.has_panels() || !is_measured && base.breaks.is_empty() {
        return Ok(None);
    }
    // Seen from the middle of a gap the wave is one more base with ends, and full contact need not be solved.
    let gap = coarse::gap(base, base.cells()).ok().flatten();
    if let Some(middle) = gap
        && let Ok(answer) = open(&base.clone().shifted(middle))
        && !answer.touches_about(middle)
    {
        return Ok(Some(answer));
    }
    // Where panels do not serve series may.
    let Ok(Some(full)) = spots::solve_whole(&base.kept()) else { return Ok(None) };
    let Some(least) = full.pulls_most() else {
        return Ok(Some(Answer::Spots(Box::new(full.lifting()))));
    };
    if gap.is_some() {
        return Ok(None);
    }
    Ok(open(&base.clone().shifted(least)).ok())
}

/// The answer by the method that suits the profile, or by the other.
fn open(base: &Base<'_>) -> Result<Answer, Error> {
    let is_tried = base.is_for_panels();
    if is_tried && let Some(answer) = on_panels(base) {
        return Ok(answer);
    }
    require_few(&base.breaks)?;
    if !is_tried
        && base.has_panels()
        && let Some(answer) = quicker(base)
    {
        return Ok(answer);
    }
    match anchored(base, searched(base)) {
        Err(
            error @ (Error::NotComplementary { .. }
            | Error::Equation(_)
            | Error::TooManyZones { .. }),
        ) => {
            let answer = if is_tried { None } else { on_panels(base) };
            answer.ok_or(match error {
                // Not for their number.
                Error::TooManyZones { .. } if base.is_plain() => {
                    Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN }
                }
                other => other,
            })
        }
        ending => ending.map(Answer::zones),
    }
}

/// The answer on few nodes, or on panels; none where both miss what is aimed at, as more nodes may not.
fn quicker(base: &Base<'_>) -> Option<Answer> {
    // Rounding of the pressure grows with theta0.
    let usual = AIM * (ROUNDED * base.theta).max(1.0);
    let aim = base.problem.solver().tolerance.unwrap_or(usual);
    let on_panels = || spots::solve(base).ok().flatten();
    let error_of = |contact: &Option<SpotContact>| {
        contact.as_ref().map_or(f64::INFINITY, Solution::relative_error)
    };
    let is_first = takes_many_steps(base);
    let mut panels = if is_first { on_panels() } else { None };
    let mut collocated = None;
    let mut error = f64::INFINITY;
    if error_of(&panels) > aim {
        let little = base.with_little_effort();
        collocated = anchored(&little, searched(&little)).ok();
        error = collocated.as_ref().map_or(f64::INFINITY, Solution::relative_error);
        if error > aim && !is_first {
            panels = on_panels();
        }
    }
    let is_enough = error_of(&panels) <= aim || collocated.is_none();
    match panels.filter(|contact| is_enough && contact.relative_error() < error) {
        Some(contact) => Some(Answer::Spots(Box::new(contact))),
        None => collocated.filter(|_| error <= aim).map(Answer::zones),
    }
}

/// Whether edges of several zones begin many lengths of the layer away, as cells are longer than it is: steps then take them nearer by a half each, which dense equations make long.
fn takes_many_steps(base: &Base<'_>) -> bool {
    base.valleys() > 1 && 2.0 * base.steepness() > base.cells() as f64
}

/// The answer on panels, where these serve and are not too many for their equation.
fn on_panels(base: &Base<'_>) -> Option<Answer> {
    let contact = spots::solve(base).ok().flatten()?;
    Some(Answer::Spots(Box::new(contact)))
}

/// The same answer with heights from the tangent where the zones are, if that is better: beside small zones differences of heights have few digits.
fn anchored(
    base: &Base<'_>,
    known: Result<UnilateralContact, Error>,
) -> Result<UnilateralContact, Error> {
    if base.medium.is_disk() || base.medium.is_closed() {
        return known;
    }
    let span = match &known {
        Ok(contact) if contact.relative_error() <= DIGITS_LOST => return known,
        Ok(contact) => ends(contact.zones().iter().copied()),
        Err(Error::NotComplementary { .. } | Error::Equation(_)) => {
            let zones = base.first_zones(base.cells()).unwrap_or_default();
            // The line of the force passes between the ends of the contact.
            let line = base.line_of_force().filter(|_| zones.is_empty()).map(|arm| [arm; 2]);
            ends(zones.iter().map(|zone| [zone.left(), zone.right()]).chain(line))
        }
        Err(_) => return known,
    };
    let [left, right] = span;
    // No zones at all leave an infinite span.
    if right - left >= SMALL_ZONES || left > right {
        return known;
    }
    let again = base.anchored(0.5 * (left + right)).map(|base| searched(&base));
    match (known, again) {
        (Ok(known), Some(Ok(again))) if known.relative_error() <= again.relative_error() => {
            Ok(known)
        }
        (_, Some(Ok(again))) => Ok(again),
        (known, _) => known,
    }
}

/// From the first end of zones to the last.
fn ends(zones: impl Iterator<Item = [f64; 2]>) -> [f64; 2] {
    zones.fold([f64::INFINITY, f64::NEG_INFINITY], |[left, right], zone| {
        [left.min(zone[0]), right.max(zone[1])]
    })
}

/// The answer with the zones that were searched for.
fn searched(base: &Base<'_>) -> Result<UnilateralContact, Error> {
    let (solved, left) = complementary(base)?;
    harmonic::answer(base, solved, &left)
}
