//! Contact on rough surfaces: the equation of the second kind, on zones that are part of the answer where the base may lift off.
//!
//! Two discretisations solve it on given zones: [sinc] collocation, on few of them and on any ground, and polynomials on [panels]. Each finds its zones, from those that
//! [cells](coarse) show; [Newton's method](newton) for a layer that bends, the statement of [error](refinement), the [first-order change](linearised) and the
//! [answer] are the same for both.

mod answer;
mod base;
mod check;
mod coarse;
mod crests;
mod frame;
mod free_edges;
mod layer;
mod linearised;
mod newton;
mod nodes;
mod panels;
mod refinement;
mod sinc;
mod solved;
mod surface;
#[cfg(test)]
mod tests;
mod turned;

use std::sync::Arc;

use super::check::Check;
use super::parts::{Parts, require_few};
use super::promise::ROUGHEST;
use super::search::{complementary, unknown};
use super::setting::Setting;
use super::solution::Solution;
use super::steps::BESIDE;
use crate::intervals::longest_gap;
use crate::{ContactKind, Error};
use answer::RoughContact;
use base::Base;
use panels::{ManyPanels, OnPanels};
use sinc::{Collocation, Effort};

impl Setting {
    /// The solution with the pressure nowhere negative: the zones of contact are part of the answer.
    ///
    /// `p0 + theta0 int ln(1/|xi - eta|) p0 deta = delta0 - alpha0 xi - f0(xi)` and `p0 >= 0` on the zones, `p0 = 0` at their free edges, and outside
    /// them on the base a gap that is not negative.
    pub(super) fn lifting(&self) -> Result<Arc<dyn Solution>, Error> {
        let base = Base::new(self, ContactKind::Unilateral)?;
        if base.ground.is_closed() {
            return wave(&base);
        }
        open(&base).map_err(|error| match error {
            // That of cells, where heights are known to rounding alone; and 1 + theta0 K is positive, whatever rounding makes of it.
            Error::Equation(_) if error.is_numerical() => unknown(),
            other => other,
        })
    }

    /// The whole base in contact, where the pressure may pull, on panels; none where they do not serve.
    pub(super) fn whole_base_on_panels(&self) -> Result<Option<Arc<dyn Solution>>, Error> {
        let found = on_panels(&Base::new(self, ContactKind::Bilateral)?);
        found.ok().map(RoughContact::without_tension).transpose()
    }

    /// The same by the equations of the zones, in every geometry and for every layer but a smooth one.
    pub(super) fn whole_base(&self) -> Result<Arc<dyn Solution>, Error> {
        let base = Base::new(self, ContactKind::Bilateral)?;
        let serve = base.is_for_panels() || base.ground.is_closed();
        match serve.then(|| on_panels(&base)) {
            Some(Ok(found)) => found.without_tension(),
            // A wave without gaps has no ends for collocation.
            Some(Err(error)) if self.problem().is_wave() => Err(error),
            _ => collocated(&base),
        }
    }

    /// The same by collocation on these parts.
    pub(super) fn collocated(&self, parts: &Parts) -> Result<Arc<dyn Solution>, Error> {
        collocated(&Base::new(self, ContactKind::Bilateral)?.cut(parts))
    }
}

/// The answer on the whole base, collocated.
fn collocated(base: &Base) -> Result<Arc<dyn Solution>, Error> {
    require_few(&base.breaks)?;
    let solved = Collocation::new(base, Effort::MOST).whole()?;
    RoughContact::new(base, solved, &Check::none())?.without_tension()
}

/// The answer on panels.
fn on_panels(base: &Base) -> Result<RoughContact<OnPanels>, Error> {
    let mut panels = ManyPanels::new(base);
    let (solved, left) =
        if base.is_bilateral { (panels.whole()?, Check::none()) } else { panels.lifting()? };
    let found = RoughContact::new(base, solved, &left)?;
    let serves = found.relative_error() <= ROUGHEST || base.problem().deadline().is_past();
    if serves { Ok(found) } else { Err(unknown()) }
}

/// The answer for a wave without gaps: seen from the middle of a gap it is one more base with ends, and so it is from where full contact pulls most.
fn wave(base: &Base) -> Result<Arc<dyn Solution>, Error> {
    let seen_from = |cut: f64| open(&base.clone().shifted(cut));
    // Cells that find nothing show no gap.
    if let Some(middle) = longest_gap(base.coarse().unwrap_or_default(), BESIDE)
        && let Ok(answer) = seen_from(middle)
        && !touches_about(answer.as_ref(), middle)
    {
        return Ok(answer);
    }
    let full = on_panels(&base.kept())?;
    let Some(least) = full.pulls_most() else { return Ok(Arc::new(full.lifting())) };
    let answer = seen_from(least)?;
    // A slit beside a step, where contact ends, is a wall that the base has not.
    let gap =
        longest_gap(&answer.zones(), BESIDE).filter(|_| touches_about(answer.as_ref(), least));
    gap.map_or(Ok(answer), seen_from)
}

/// Whether a wave that was cut here touches beside the cut.
fn touches_about(solution: &dyn Solution, cut: f64) -> bool {
    let beside = [-2.0 * BESIDE, 2.0 * BESIDE].map(|step| [cut + step, cut + 2.0 + step]);
    beside.as_flattened().iter().any(|xi| xi.abs() <= 1.0 && solution.touches(*xi))
}

/// The relative error of an answer for which no other way is tried, unless a tolerance asks for less: that of another would take as long again (survey).
const PLENTY: f64 = 1e-9;

/// A way to solve the equation of a base with ends.
#[derive(Debug, Clone, Copy)]
enum Way {
    Panels,
    /// Sinc collocation, so far.
    Collocation(Effort),
}

impl Way {
    /// The ways that suit a base, in the order in which they are tried.
    fn of(base: &Base) -> Vec<Self> {
        // Rings of a power take longer on panels than a dense system of all nodes that there may be.
        let is_slow = base.ground.is_disk() && base.ground.exponent() > 0.0;
        if !base.has_panels() {
            vec![Self::Collocation(Effort::MOST)]
        } else if is_slow && !base.is_for_panels() {
            vec![Self::Collocation(Effort::MOST), Self::Panels]
        } else if base.is_for_panels() || !Collocation::new(base, Effort::LITTLE).is_quick() {
            // Waves on a disk have more digits by collocation, where that is to be had.
            let effort = if base.ground.is_disk() { Effort::MOST } else { Effort::LITTLE };
            vec![Self::Panels, Self::Collocation(effort)]
        } else {
            vec![Self::Collocation(Effort::LITTLE), Self::Panels]
        }
    }

    fn solve(self, base: &Base) -> Result<Arc<dyn Solution>, Error> {
        match self {
            Self::Panels => Ok(Arc::new(on_panels(base)?)),
            Self::Collocation(effort) => {
                require_few(&base.breaks)?;
                let on_tangent = base.on_tangent();
                let base = on_tangent.as_ref().unwrap_or(base);
                let (solved, left) = complementary(&Collocation::new(base, effort))?;
                Ok(Arc::new(RoughContact::new(base, solved, &left)?))
            }
        }
    }
}

/// The answer for a base with ends, by the way that has all digits that are aimed at, or comes nearest to them.
fn open(base: &Base) -> Result<Arc<dyn Solution>, Error> {
    let aim = base.problem().solver().tolerance.unwrap_or(base.problem().aim().max(PLENTY));
    let enough = if base.is_for_panels() { f64::INFINITY } else { aim };
    let mut best: Option<Arc<dyn Solution>> = None;
    let mut refusal = unknown();
    for way in Way::of(base) {
        match way.solve(base) {
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
        if base.problem().deadline().is_past() {
            break;
        }
    }
    best.ok_or(match refusal {
        // Not for their number, of which panels take many.
        Error::TooManyZones { .. } if base.has_panels() => unknown(),
        other => other,
    })
}
