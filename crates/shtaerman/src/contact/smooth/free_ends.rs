//! What free ends have in common, in plane contact and on rings: each moves by itself until the density there vanishes.

use std::cell::Cell;

use super::zones::Zone;
use crate::Error;
use crate::contact::unilateral::damping::{Damping, Edge};

/// Most Newton steps on the way to the edges.
const STEPS: usize = 120;
/// A density at a free end below this share of the largest is as good as none, if it does not fall any more.
const SMALL: f64 = 1e-8;
/// A density that keeps this share in a step does not fall: in a row that is nearly closed steps converge by a half only.
const FALLING: f64 = 0.9;
/// Share of a zone, or of a gap, that an edge may cross in one step.
pub(super) const STRIDE: f64 = 0.4;
/// Zones shorter than this share of the longest are none.
pub(super) const VANISHING: f64 = 1e-9;
/// Cubes of the numbers of modes, added up over all solutions of a problem, after which the search for zones ends: about fifteen seconds.
const MOST_WORK: f64 = 3e11;
/// What a panel costs in the same unit.
const A_PANEL: f64 = 6e4;
/// Zones closer than this share of the shorter one are one.
const CLOSE: f64 = 1e-5;

/// What the search for zones has cost so far.
#[derive(Debug, Clone, Default)]
pub(super) struct Work(Cell<f64>);

impl Work {
    /// Adds the solution of so many equations, on so many panels.
    ///
    /// # Errors
    /// [`Error::NotComplementary`] if that was too much.
    fn spend(&self, modes: usize, panels: usize) -> Result<(), Error> {
        self.0.set(self.0.get() + (modes as f64).powi(3) + A_PANEL * panels as f64);
        if self.0.get() <= MOST_WORK {
            return Ok(());
        }
        Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN })
    }
}

/// A solution on zones whose ends can be told from their densities.
pub(super) trait FreeEnds {
    /// Number of unknowns.
    fn modes(&self) -> usize;

    /// Number of panels of the slopes.
    fn panels(&self) -> usize {
        0
    }

    /// Force of a zone, or a multiple of it.
    fn carried(&self, zone: usize) -> f64;

    /// The density at an end, whose sign is that of the pressure.
    fn density_at(&self, zone: usize, side: usize) -> f64;

    /// Its rounding.
    fn floor(&self, zone: usize) -> f64;

    /// What densities are held against.
    fn scale(&self) -> f64;

    /// Below this share of the scale there is none.
    fn none(&self) -> f64;
}

/// Moves the free ends until the density vanishes there. Zones that carry nothing disappear, those that meet become one, ends that come to
/// a wall stay there and leave it again if it pulls.
///
/// # Errors
/// Those of the solutions, and [`Error::NotComplementary`] if they were too much work.
pub(super) fn settle<S: FreeEnds>(
    start: &[Zone],
    work: &Work,
    solve: impl Fn(&[Zone]) -> Result<S, Error>,
    moved: impl Fn(&S, &[Zone]) -> Vec<Zone>,
) -> Result<S, Error> {
    let mut zones = start.to_vec();
    let mut best: Option<(f64, S)> = None;
    let mut damping = Damping::default();
    for _ in 0..STEPS {
        let solved = solve(&zones)?;
        work.spend(solved.modes(), solved.panels())?;
        if drop_idle(&mut zones, &solved) {
            best = None;
            continue;
        }
        let released = release(&mut zones, &solved);
        let worst = worst_density(&solved, &zones);
        let none = solved.none();
        let is_small = worst <= SMALL && !released;
        if is_small && let Some((before, known)) = best.take() {
            if worst >= FALLING * before || worst <= none {
                return Ok(if before <= worst { known } else { solved });
            }
        } else if worst <= none && !released {
            return Ok(solved);
        }
        zones = damped(&mut damping, &solved, &zones, moved(&solved, &zones));
        best = is_small.then_some((worst, solved));
    }
    match best {
        Some((_, solved)) => Ok(solved),
        None => solve(&zones),
    }
}

/// The next zones with shorter steps of those ends that go back and forth about a kink of the base; all as they are where an end was freed or held, or a zone has gone.
fn damped(
    damping: &mut Damping,
    solved: &impl FreeEnds,
    zones: &[Zone],
    mut next: Vec<Zone>,
) -> Vec<Zone> {
    let is_same = zones.len() == next.len()
        && zones.iter().zip(&next).all(|(zone, next)| zone.is_free == next.is_free);
    if !is_same {
        *damping = Damping::default();
        return next;
    }
    let edge = |j: usize, side: usize| Edge {
        at: zones[j].ends[side],
        outwards: if side == 0 { -1.0 } else { 1.0 },
        layer: solved.density_at(j, side),
    };
    let edges: Vec<Edge> = (0..zones.len()).flat_map(|j| [edge(j, 0), edge(j, 1)]).collect();
    let pairs = zones.iter().zip(&next);
    let steps = pairs.flat_map(|(zone, next)| [0, 1].map(|side| next.ends[side] - zone.ends[side]));
    let wanted: Vec<f64> = steps.collect();
    let steps = damping.damped(wanted.clone(), &edges);
    for (end, (step, wanted)) in steps.into_iter().zip(wanted).enumerate() {
        if step != wanted {
            next[end / 2].ends[end % 2] = edges[end].at + step;
        }
    }
    next
}

/// Drops zones without force, if there are others; whether there were any.
fn drop_idle(zones: &mut Vec<Zone>, solved: &impl FreeEnds) -> bool {
    let carries: Vec<bool> = (0..zones.len()).map(|j| solved.carried(j) > 0.0).collect();
    let drops = carries.contains(&true) && carries.contains(&false);
    if drops {
        let mut carries = carries.into_iter();
        zones.retain(|_| carries.next().unwrap_or(true));
    }
    drops
}

/// Ends at walls that pull become free; whether there were any.
fn release(zones: &mut [Zone], solved: &impl FreeEnds) -> bool {
    let mut released = false;
    let least = f64::EPSILON * solved.scale();
    for (j, zone) in zones.iter_mut().enumerate() {
        let floor = solved.floor(j) + least;
        for side in 0..2 {
            if !zone.is_free[side] && solved.density_at(j, side) < -floor {
                zone.is_free[side] = true;
                released = true;
            }
        }
    }
    released
}

/// Largest density at a free end over the scale.
fn worst_density(solved: &impl FreeEnds, zones: &[Zone]) -> f64 {
    let scale = solved.scale();
    let mut worst = 0.0f64;
    for (j, zone) in zones.iter().enumerate() {
        for side in (0..2).filter(|&side| zone.is_free[side]) {
            worst = worst.max(solved.density_at(j, side).abs() / scale);
        }
    }
    worst
}

/// Newton's step outwards to where a density with this slope vanishes, in units of the slope; a stride where there is none.
pub(super) fn step(density: f64, slope: f64) -> f64 {
    let step = -density / slope;
    if slope < 0.0 && step.is_finite() { step } else { STRIDE.copysign(density) }
}

/// The slope over `cos(phi)` outwards at the end `phi = 0` of an even function, from its values there and at angles beside.
pub(super) fn slope(at: impl Fn(f64) -> f64, beside: f64) -> f64 {
    let end = at(0.0);
    let one = (at(beside) - end) / (beside * beside);
    let two = (at(2.0 * beside) - end) / (4.0 * beside * beside);
    // cos is 1 - phi^2/2
    -2.0 * (4.0 * one - two) / 3.0
}

/// The zones with their free ends at targets, given the gap beside them, but not beyond walls; `rounded` is what else becomes of each.
pub(super) fn moved(
    zones: &[Zone],
    wall: impl Fn(usize, f64) -> f64,
    target: impl Fn(usize, usize, Option<[f64; 2]>) -> f64,
    rounded: impl Fn(&mut Zone),
) -> Vec<Zone> {
    let mut next: Vec<Zone> = Vec::with_capacity(zones.len());
    for (j, zone) in zones.iter().enumerate() {
        let mut moved = *zone;
        for side in (0..2).filter(|&side| zone.is_free[side]) {
            let gap = match side {
                0 => j.checked_sub(1).map(|before| [zones[before].right(), zone.left()]),
                _ => zones.get(j + 1).map(|after| [zone.right(), after.left()]),
            };
            let to = target(j, side, gap);
            let wall = wall(side, 0.5 * (zone.left() + zone.right()));
            let beyond = if side == 0 { to <= wall } else { to >= wall };
            moved.ends[side] = if beyond { wall } else { to };
            moved.is_free[side] = !beyond;
        }
        rounded(&mut moved);
        match next.last_mut() {
            Some(last)
                if moved.left() - last.right() <= CLOSE * moved.length().min(last.length())
                    && (last.is_free[1] && moved.is_free[0]) =>
            {
                last.ends[1] = moved.ends[1];
                last.is_free[1] = moved.is_free[1];
            }
            _ => next.push(moved),
        }
    }
    // A zone that goes on shrinking beside others is about to vanish.
    let longest = next.iter().fold(0.0f64, |most, zone| most.max(zone.length()));
    next.retain(|zone| zone.length() > VANISHING * longest);
    next
}
