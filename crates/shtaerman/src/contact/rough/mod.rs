//! Unilateral contact: the pressure never pulls, the base never penetrates, and where it touches is part of the answer.
//!
//! The topology is found on [cells](coarse); the edges of the zones by Newton's method on collocated pressures; the
//! [check](check) of the answer between its nodes corrects the topology where that was too coarse.

mod anchor;
mod answer;
mod base;
mod between;
mod check;
mod coarse;
mod effort;
mod ends;
mod equation;
mod extent;
mod harmonic;
mod layer;
mod linearised;
mod mirror;
mod panels;
mod power;
mod refinement;
mod solved;
mod system;

use answer::UnilateralContact;

use std::sync::Arc;

use super::edges::settle;
use super::parts::{Parts, require_few};
use super::search::{ALLOWED, Equation, complementary, unknown};
use super::setting::Setting;
use super::solution::Solution;
use super::steps::BESIDE;
use crate::solver::AIM;
use crate::{ContactKind, Error};
use base::Base;
use check::check;
use effort::Effort;
use refinement::{RATIO, refined};

/// Relative error aimed at for large `theta0`, over `theta0` and what is aimed at without a layer. Half and twice change none of 20 answers (survey).
const ROUNDED: f64 = 0.1;

impl Setting {
    /// The solution with the pressure nowhere negative: the zones of contact are part of the answer.
    ///
    /// `p0 + theta0 int ln(1/|xi - eta|) p0 deta = delta0 - alpha0 xi - f0(xi)` and `p0 >= 0` on the zones, `p0 = 0` at their free edges, and outside
    /// them on the base a gap that is not negative.
    pub(super) fn lifting(&self) -> Result<Arc<dyn Solution>, Error> {
        lifted(&Base::new(self, ContactKind::Unilateral)?)
    }

    /// The whole base in contact, where the pressure may pull, on panels; none where they do not serve.
    pub(super) fn whole_base_on_panels(&self) -> Result<Option<Arc<dyn Solution>>, Error> {
        let base = Base::new(self, ContactKind::Bilateral)?;
        Ok(panels::solve_whole(&base)?.map(|contact| Arc::new(contact) as Arc<dyn Solution>))
    }

    /// The same by the equations of the zones, in every geometry and for every layer but a smooth one.
    pub(super) fn whole_base(&self) -> Result<Arc<dyn Solution>, Error> {
        let base = Base::new(self, ContactKind::Bilateral)?;
        if (base.is_for_panels() || base.ground.is_closed())
            && let Some(contact) = panels::solve_whole(&base)?
        {
            base.require_no_tension(contact.pulls_most())?;
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

/// The answer on the whole base.
fn full(base: &Base<'_>) -> Result<UnilateralContact, Error> {
    let zones = base.whole();
    let resolution = base.effort(&zones, None)?;
    let solved = refined(base, &settle(base, &zones, &resolution)?, resolution.strength * RATIO)?;
    let left = check(base, &solved, ALLOWED);
    base.require_no_tension(left.pulling.first().map(|[from, to]| 0.5 * (from + to)))?;
    harmonic::answer(base, solved, &left)
}

impl Base<'_> {
    /// Refuses tension of a layer that bends, which has none.
    fn require_no_tension(&self, at: Option<f64>) -> Result<(), Error> {
        match at.filter(|_| !self.layer.is_linear()) {
            None => Ok(()),
            Some(at) => {
                let frame = self.problem.frame();
                let (variable, at) = (frame.coordinate(), at * frame.half_width());
                Err(Error::Pulls { variable, at })
            }
        }
    }
}

/// The answer where the base may lift off.
fn lifted(base: &Base<'_>) -> Result<Arc<dyn Solution>, Error> {
    if base.ground.is_closed() {
        return wave(base);
    }
    open(base).map_err(|error| match error {
        // That of cells, where heights are known to rounding alone; and 1 + theta0 K is positive, whatever rounding makes of it.
        Error::Equation(_) if error.is_numerical() => unknown(),
        other => other,
    })
}

/// The answer for a wave without gaps: seen from the middle of a gap it is one more base with ends, and so it is from where full contact pulls most.
fn wave(base: &Base<'_>) -> Result<Arc<dyn Solution>, Error> {
    // Cells that find nothing show no gap.
    if let Some(middle) = base.coarse().unwrap_or_default().gap()
        && let Ok(answer) = open(&base.clone().shifted(middle))
        && !touches_about(answer.as_ref(), middle)
    {
        return Ok(answer);
    }
    let full = panels::solve_whole(&base.kept())?.ok_or_else(unknown)?;
    match full.pulls_most() {
        None => Ok(Arc::new(full.lifting())),
        Some(least) => open(&base.clone().shifted(least)),
    }
}

/// Whether a wave that was cut here touches beside the cut.
fn touches_about(solution: &dyn Solution, cut: f64) -> bool {
    let sides = [-2.0 * BESIDE, 2.0 * BESIDE].into_iter();
    let mut beside = sides.flat_map(|step| [cut + step, cut + 2.0 + step]);
    beside.any(|xi| xi.abs() <= 1.0 && solution.touches(xi))
}

/// A way to solve the equation of a base with ends.
#[derive(Debug, Clone, Copy)]
enum Way {
    Panels,
    /// Sinc collocation, so far.
    Collocation(Effort),
}

/// The ways that suit a base, in the order in which they are tried: until one has all digits that are aimed at; the best of them counts.
fn ways(base: &Base<'_>) -> Vec<Way> {
    let most = Way::Collocation(Effort::MOST);
    let little = Way::Collocation(Effort::LITTLE);
    if !base.has_panels() {
        vec![most]
    } else if base.is_for_panels() {
        vec![Way::Panels, most]
    } else if takes_many_steps(base) {
        vec![Way::Panels, little, most]
    } else {
        vec![little, Way::Panels, most]
    }
}

/// Whether edges of several zones begin many lengths of the layer away, as cells are longer than it is: steps then take them nearer by a half each, which dense equations make long.
fn takes_many_steps(base: &Base<'_>) -> bool {
    base.valleys() > 1 && 2.0 * base.steepness() > base.cells() as f64
}

/// The answer for a base with ends.
fn open(base: &Base<'_>) -> Result<Arc<dyn Solution>, Error> {
    // Rounding of the pressure grows with theta0.
    let usual = AIM * (ROUNDED * base.theta).max(1.0);
    let aim = base.problem.solver().tolerance.unwrap_or(usual);
    let enough = if base.is_for_panels() { f64::INFINITY } else { aim };
    let mut best: Option<Arc<dyn Solution>> = None;
    let mut refusal = unknown();
    let mut is_lost = false;
    for way in ways(base) {
        // More nodes find no zones that few did not.
        if is_lost && best.is_some() {
            break;
        }
        let found: Result<Arc<dyn Solution>, Error> = match way {
            Way::Panels => panels::solve(base)
                .and_then(|contact| Ok(Arc::new(contact.ok_or_else(unknown)?) as _)),
            Way::Collocation(effort) => collocated(&base.with_effort(effort)),
        };
        is_lost |= found.is_err() && matches!(way, Way::Collocation(_));
        match found {
            Err(error) => refusal = error,
            Ok(found) => {
                let error = found.relative_error();
                if best.as_ref().is_none_or(|best| error < best.relative_error()) {
                    best = Some(found);
                }
                if error <= enough {
                    break;
                }
            }
        }
        if base.problem.deadline().is_past() {
            break;
        }
    }
    best.ok_or(match refusal {
        // Not for their number, of which panels take many.
        Error::TooManyZones { .. } if base.has_panels() => unknown(),
        other => other,
    })
}

/// The answer by collocation.
fn collocated(base: &Base<'_>) -> Result<Arc<dyn Solution>, Error> {
    require_few(&base.breaks)?;
    let anchored = base.anchored();
    Ok(Arc::new(searched(anchored.as_ref().unwrap_or(base))?))
}

/// The answer with the zones that were searched for.
fn searched(base: &Base<'_>) -> Result<UnilateralContact, Error> {
    let (solved, left) = complementary(base)?;
    harmonic::answer(base, solved, &left)
}
