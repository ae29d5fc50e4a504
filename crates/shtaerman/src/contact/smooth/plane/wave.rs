//! A wave over the whole period: in full contact, or in partial contact between the crests.

use std::f64::consts::PI;
use std::sync::Arc;

use fredholm::inversion::integral;

use super::super::answer::{SmoothContact, contact};
use super::super::base::{Base, wrapped};
use super::super::check::check;
use super::super::equation::FINE;
use super::super::pressure::place;
use super::super::topology;
use super::Plane;
use super::full::{FullWave, PANELS};
use super::solved::Solved;
use crate::contact::accuracy::ROUNDING;
use crate::contact::edges::settle;
use crate::contact::search::ALLOWED;
use crate::contact::solution::Solution;
use crate::contact::steps::BESIDE;
use crate::contact::valleys::CELLS;
use crate::error::require;
use crate::extremes::NEGLIGIBLE;
use crate::intervals::longest_gap;
use crate::line_search::STEPS;
use crate::{Error, Scaling, Vertical};

/// A step at the seam, as a share of the range of the heights, that is rounding.
const SEAM: f64 = 1e-6;

/// The contact of a base that repeats without gaps.
pub(in super::super) fn solve(base: &Arc<Base>) -> Result<Arc<dyn Solution>, Error> {
    let step = (base.height(1.0 - BESIDE) - base.height(BESIDE - 1.0)).abs();
    let requirement = "the same at both ends of a period: a smooth surface bears no step";
    let unit = base.setting.problem().bodies().unit(Scaling::displacement);
    require(step <= SEAM * base.range(), "profile", unit * base.height(1.0), requirement)?;
    let [force, _] = base.load.forces();
    let full = FullWave::new(base, force);
    let along = full.along((4 * base.cells()).min(CELLS));
    let size = along.iter().fold(0.0f64, |most, (_, p)| most.max(p.abs()));
    let (bottom, least) = full.lowest(&along, &base.marks);
    // The seam is best left where it is as deep in the valley.
    let is_seam = full.at(-1.0) <= least + NEGLIGIBLE * size;
    let first = |force: f64| full.first_zone(&along, (bottom, least), force);
    let place = if is_seam { 1.0 } else { bottom };
    let partial = || Partial::new(base, place, !full.is_smooth());
    if let Vertical::Settlement(settlement) = base.load.vertical {
        let requirement = "less than the mean height of the profile: in full contact it is that mean, whatever the force";
        let is_partial = base.setting.is_unilateral() && settlement < full.settlement();
        require(is_partial, "settlement", unit * settlement, requirement)?;
        // Without force the least pressure is minus that which closes all gaps.
        return sunk(partial()?, first, settlement, -2.0 * least);
    }
    if !base.setting.is_unilateral() || least >= -ALLOWED * size {
        return Ok(Arc::new(full.answer(&base.breaks)));
    }
    Ok(Arc::new(partial()?.under(force, first(force))?))
}

/// The contact under the force for a settlement, by Newton's method between bounds: a constant pressure moves nothing, so the equation for a given settlement is badly posed
/// near full contact.
fn sunk(
    mut partial: Partial,
    first: impl Fn(f64) -> Option<[f64; 2]>,
    settlement: f64,
    limit: f64,
) -> Result<Arc<dyn Solution>, Error> {
    let (mut low, mut high) = (0.0, limit);
    let mut force = 0.3 * limit;
    let mut last = None;
    for _ in 0..STEPS {
        let contact = partial.under(force, first(force))?;
        let excess = contact.state().settlement - settlement;
        *(if excess > 0.0 { &mut high } else { &mut low }) = force;
        let newton = force - excess * contact.stiffness().force_settlement;
        last = Some(contact.settled(settlement, ROUNDING * force));
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        if (next - force).abs() <= ROUNDING * force {
            break;
        }
        force = next;
    }
    last.map_or(Err(Error::NoContact), |contact| Ok(Arc::new(contact)))
}

/// Partial contact of a wave, seen from a place that became `+-1`: where full contact pulls most.
struct Partial {
    whole: Arc<Base>,
    turned: Base,
    /// Whether the wave bends at its seam.
    has_seam: bool,
}

impl Partial {
    fn new(whole: &Arc<Base>, place: f64, has_seam: bool) -> Result<Self, Error> {
        Ok(Self { whole: Arc::clone(whole), turned: whole.turned(place, has_seam)?, has_seam })
    }

    /// The contact under a force; a zone to try first is one of the wave as it is.
    fn under(
        &mut self,
        force: f64,
        first: Option<[f64; 2]>,
    ) -> Result<SmoothContact<Solved>, Error> {
        match self.attempt(force, first) {
            Ok(contact) => Ok(contact),
            Err(error) => {
                // Where full contact pulls most partial contact may touch.
                let Some(gap) = self.gap(force) else { return Err(error) };
                self.turned = self.whole.turned(gap, self.has_seam)?;
                self.attempt(force, first)
            }
        }
    }

    fn attempt(&self, force: f64, first: Option<[f64; 2]>) -> Result<SmoothContact<Solved>, Error> {
        let plane = Plane::new(Arc::new(self.turned.under(force)));
        let tried = first.and_then(|zone| tried(&plane, zone));
        let found = tried.map_or_else(|| contact(&plane), Ok)?;
        let moment = found.state().moment;
        let before = before_seam(&plane.base, found.solved());
        Ok(found.with_moment(moment + plane.base.shift * force + 2.0 * before))
    }

    /// The middle of the longest gap on cells where these show contact on both sides of the seam, as a place of the wave as it is.
    fn gap(&self, force: f64) -> Option<f64> {
        let base = self.turned.under(force);
        let intervals = topology::find(&base, base.cells()).ok()?;
        let ([first, ..], [.., last]) = (&intervals[..], &intervals[..]) else { return None };
        let touches = first[0] <= -1.0 && last[1] >= 1.0;
        let middle = longest_gap(&intervals, BESIDE).filter(|_| touches)?;
        Some(wrapped(middle + base.shift))
    }
}

/// The answer if a zone of the wave as it is leads there: the pressure without tension and penetration is but one.
fn tried(plane: &Plane, [left, right]: [f64; 2]) -> Option<SmoothContact<Solved>> {
    let middle = wrapped(0.5 * (left + right) - plane.base.shift);
    let half = 0.5 * (right - left);
    let [left, right] = [middle - half, middle + half];
    let is_inside = -1.0 < left && left < right && right < 1.0;
    let zone = is_inside.then(|| plane.base.walls.zone([left, right]))?;
    let solved = settle(plane, &[zone], &FINE, None).ok()?;
    let left = check(&plane.base, &solved, ALLOWED);
    let found = left.is_clean().then(|| SmoothContact::new(plane, solved, &left))?;
    found.ok()
}

/// Force on what the turn took below `-1`.
fn before_seam(base: &Base, solved: &Solved) -> f64 {
    let seam = -1.0 - base.shift;
    let of = |(part, zone): (&super::part::Part, &crate::contact::zones::Zone)| {
        if zone.right() <= seam {
            return part.force();
        }
        if zone.left() >= seam {
            return 0.0;
        }
        let start = place(zone, seam).angle();
        let width = (PI - start) / PANELS as f64;
        let panel = |i: usize| {
            let from = start + width * i as f64;
            integral(from, from + width, |angle| part.density(angle))
        };
        (0..PANELS).map(panel).sum()
    };
    solved.parts.iter().zip(&solved.zones).map(of).sum::<f64>() / solved.theta0
}
