//! The free ends of zones, by Newton's method.
//!
//! At a free end the pressure vanishes. As it does, an end that moves by `e` changes the pressure elsewhere by `e^2` only: so each end has a step of its own, to where
//! the pressure beside it, carried on straight, would vanish.

use super::accuracy::{ROUNDING, SAFETY};
use super::brackets::Brackets;
use super::search::Equation;
use super::zones::{EndKind, Zone};
use crate::Error;
use crate::intervals::SLIVER;
use crate::line_search::{CUTS, STEPS};

/// What an end lacks, as a share of its scale, that is good enough while zones are looked for, and in an answer as good as nothing if it does not fall any more: to this share of the step before. Nor does a value on the way to a bracket that other ends have left behind (survey).
pub(super) const SMALL: f64 = 1e-8;
pub(super) const FALLING: f64 = 0.9;
/// So often: ends beside a narrow gap depend on each other, and a single step may lead astray (survey).
const STALLS: usize = 3;
/// Share of a zone, or of a gap, that an end may cross in one step; a zone that is left whole keeps a fifth of its length (survey).
pub(super) const STRIDE: f64 = 0.4;
/// Zones closer than this share of the shorter one are one, and those that are so nearly mirror images are (survey).
pub(super) const CLOSE: f64 = 1e-6;

/// What is known at an end of a zone.
#[derive(Debug, Clone, Copy)]
pub(super) struct EndState {
    /// What vanishes at a free end and has the sign of the pressure: of a rough surface what the layer gives, of a smooth one the density of its singular pressure.
    pub(super) value: f64,
    /// The rounding of that.
    pub(super) rounding: f64,
    /// What it is held against.
    pub(super) scale: f64,
    /// Up to this size it is no better known to vanish, or need not be.
    pub(super) none: f64,
    /// Up to this size one step more is enough.
    pub(super) enough: f64,
    /// Newton's step outwards, in `xi`; of no use unless it goes to where the value vanishes.
    pub(super) step: f64,
}

impl EndState {
    /// The step outwards. Where Newton's leads the wrong way, as beside an end that lies too far inside, where the pressure rises as at a corner, its length is still that over which the value changes; where
    /// it leads nowhere a stride.
    fn outwards(&self, length: f64) -> f64 {
        let stride = STRIDE * length;
        if !self.step.is_finite() {
            stride.copysign(self.value)
        } else if self.step * self.value >= 0.0 {
            self.step
        } else {
            self.step.abs().clamp(NEAR * length, stride).copysign(self.value)
        }
    }
}

/// The ends of all zones, as [`Equation::ends`] tells them.
type Ends = [[EndState; 2]];

/// Moves the free ends until the pressure vanishes there, perhaps from a solution on the same zones. Zones that carry nothing disappear, those that meet become one, ends that come to a wall stay there and leave it again if it pulls.
///
/// # Errors
/// Those of the solutions.
pub(super) fn settle<E: Equation>(
    equation: &E,
    start: &[Zone],
    effort: &E::Effort,
    near: Option<&E::Solved>,
) -> Result<E::Solved, Error> {
    let mut zones = equation.arranged(start.to_vec());
    if !equation.may_lift() {
        return equation.solve(&zones, effort, near);
    }
    let mut latest: Option<E::Solved> = None;
    let mut worst_before: Option<f64> = None;
    let mut step: Option<Step> = None;
    let mut brackets = Brackets::default();
    let mut strides = Strides::default();
    if let Some(near) = near {
        let mut ends = equation.ends(near, effort);
        // The slope beside what is rounding tells nothing.
        let known = ends.iter_mut().flatten().filter(|end| end.value.abs() <= end.rounding);
        known.for_each(|end| end.step = 0.0);
        zones = moved(equation, &zones, &ends, &brackets, &mut strides);
    }
    let mut stalls = 0;
    for _ in 0..STEPS {
        let solved = equation.solve(&zones, effort, latest.as_ref().or(near))?;
        if equation.deadline().is_past() {
            return Ok(solved);
        }
        if drop_idle(&mut zones, |zone| equation.force(&solved, zone)) {
            (latest, worst_before, step) = (None, None, None);
            continue;
        }
        let mut ends = equation.ends(&solved, effort);
        let lacking = lacking(&zones, &ends);
        if let Some(step) = &mut step
            && step.is_to_be_cut(lacking, &ends, &mut zones)
        {
            continue;
        }
        let falls = step.as_ref().map(|step| step.sharpen(&zones, &mut ends)).unwrap_or_default();
        let released = release(&mut zones, &ends);
        let free = Free::new(&zones, &ends);
        if free.are_none && !released {
            return Ok(solved);
        }
        let is_small = free.are_small && !released;
        let best_before = worst_before.filter(|_| is_small);
        let is_better = best_before.is_none_or(|before| free.worst < before);
        if let Some(before) = best_before {
            stalls = if free.worst >= FALLING * before { stalls + 1 } else { 0 };
            // Values within their rounding are noise at once, of which a later one is smaller by chance only.
            let is_noise = free.are_rounding || free.worst <= SAFETY * ROUNDING;
            let patience = if is_noise { 1 } else { STALLS };
            if stalls >= patience || free.are_enough {
                return Ok(latest.filter(|_| !is_better).unwrap_or(solved));
            }
        } else {
            stalls = 0;
        }
        brackets.learn(&zones, &ends);
        let next = moved(equation, &zones, &ends, &brackets, &mut strides);
        strides.count();
        if !released && is_still(&zones, &next) {
            return Ok(solved);
        }
        let from = std::mem::replace(&mut zones, next);
        step = equation.ends_are_apart().then_some(Step { from, ends, falls, lacking, cuts: 0 });
        worst_before = is_small.then(|| best_before.map_or(free.worst, |w| w.min(free.worst)));
        if is_better {
            latest = Some(solved);
        }
    }
    match latest.filter(|_| worst_before.is_some()) {
        Some(solved) => Ok(solved),
        None => equation.solve(&zones, effort, None),
    }
}

/// Steps in a row that were all as far inwards as they may be: under a force next to nothing a contact is smaller than its first guess by any number of digits.
#[derive(Debug, Default)]
struct Strides {
    in_a_row: i32,
    are_all: bool,
}

impl Strides {
    /// The share of its length that a zone keeps at least.
    fn kept(&self) -> f64 {
        (1.0 - 2.0 * STRIDE).powi(1 + self.in_a_row)
    }

    fn count(&mut self) {
        self.in_a_row = if self.are_all { self.in_a_row + 1 } else { 0 };
    }
}

/// A step that was taken, in case it must be cut.
struct Step {
    from: Vec<Zone>,
    ends: Vec<[EndState; 2]>,
    /// What the step before that left of each value.
    falls: Vec<[f64; 2]>,
    /// What the ends lacked before it.
    lacking: f64,
    cuts: usize,
}

impl Step {
    /// Cuts the step to these zones, if it made the ends twice as bad: beyond a bend of the base the slope at the end says nothing. An end whose value changed its sign goes back to where the secant has it vanish;
    /// at first one that is no worse stays.
    fn is_to_be_cut(&mut self, lacking: f64, ends: &Ends, zones: &mut [Zone]) -> bool {
        // Half the factor changes no answer and takes a quarter more time (survey).
        if lacking <= 2.0 * self.lacking || self.cuts >= CUTS || self.from.len() != zones.len() {
            return false;
        }
        self.cuts += 1;
        for (j, (zone, from)) in zones.iter_mut().zip(&self.from).enumerate() {
            for side in 0..2 {
                let [was, now] = [&self.ends, ends].map(|ends| ends[j][side].value);
                let kept = if was * now < 0.0 {
                    was / (was - now)
                } else if now.abs() <= was.abs() && self.cuts == 1 {
                    1.0
                } else {
                    0.5
                };
                zone.ends[side] = from.ends[side] + kept * (zone.ends[side] - from.ends[side]);
            }
            zone.kinds = from.kinds;
        }
        true
    }
}

/// A value below this share of its scale changes with its own end alone (survey).
const NEAR: f64 = 1e-2;

impl Step {
    /// Takes the secant over this step in the place of Newton's slope where the value changed its sign, or is small and the secant tells a shorter step: in thin layers slopes beside an end are
    /// not those at it. A longer one is taken where two steps left the same share: ends that depend on each other then do so in one way. Gives the shares that are left.
    fn sharpen(&self, zones: &[Zone], ends: &mut [[EndState; 2]]) -> Vec<[f64; 2]> {
        let mut falls = vec![[f64::NAN; 2]; zones.len()];
        if self.from.len() != zones.len() {
            return falls;
        }
        for (j, (zone, from)) in zones.iter().zip(&self.from).enumerate() {
            for (side, at) in zone.free_ends().filter(|(side, _)| from.is_free(*side)) {
                let sign = if side == 0 { -1.0 } else { 1.0 };
                let (now, was) = (ends[j][side], self.ends[j][side].value);
                let step = now.value * sign * (at - from.ends[side]) / (was - now.value);
                let is_known = (was - now.value).abs() > now.none;
                let is_crossed = (now.value > 0.0) != (was > 0.0);
                let fall = now.value / was;
                let before = self.falls.get(j).map_or(f64::NAN, |falls| falls[side]);
                // Ends that move together beside a narrow gap fall less than each by itself: at first their secants would be too long.
                let is_steady = (fall - before).abs() <= 0.5 * before.min(1.0 - fall);
                let is_near = now.value.abs() <= NEAR * now.scale
                    && (step.abs() <= now.step.abs() || is_steady);
                if is_known && (is_crossed || is_near) && step * now.value > 0.0 {
                    ends[j][side].step = step;
                }
                falls[j][side] = fall;
            }
        }
        falls
    }
}

/// Values at the free ends.
struct Free {
    /// The largest over its scale.
    worst: f64,
    are_none: bool,
    are_enough: bool,
    are_small: bool,
    are_rounding: bool,
}

impl Free {
    fn new(zones: &[Zone], ends: &Ends) -> Self {
        let mut free = Self {
            worst: 0.0,
            are_none: true,
            are_enough: true,
            are_small: true,
            are_rounding: true,
        };
        for (zone, ends) in zones.iter().zip(ends) {
            for (side, _) in zone.free_ends() {
                let EndState { value, rounding, scale, none, enough, .. } = ends[side];
                let size = value.abs();
                free.worst = free.worst.max(size / scale);
                free.are_none &= size <= none;
                free.are_enough &= size <= enough;
                free.are_small &= size <= SMALL * scale + enough;
                free.are_rounding &= size <= rounding;
            }
        }
        free
    }
}

/// The largest value at a free end, of either sign, or tension at a wall, over their scales.
fn lacking(zones: &[Zone], ends: &Ends) -> f64 {
    let mut lacking = 0.0f64;
    for (zone, ends) in zones.iter().zip(ends) {
        for (kind, EndState { value, scale, .. }) in zone.kinds.iter().zip(ends) {
            let size = match kind {
                EndKind::Free => value.abs(),
                EndKind::Wall => (-value).max(0.0),
                EndKind::Axis => 0.0,
            };
            lacking = lacking.max(size / scale);
        }
    }
    lacking
}

/// Drops zones without force, if there are others; whether there were any.
fn drop_idle(zones: &mut Vec<Zone>, force: impl Fn(usize) -> f64) -> bool {
    let carries: Vec<bool> = (0..zones.len()).map(|zone| force(zone) > 0.0).collect();
    let drops = carries.contains(&true) && carries.contains(&false);
    if drops {
        let mut carries = carries.into_iter();
        zones.retain(|_| carries.next().unwrap_or(true));
    }
    drops
}

/// Ends at walls that pull become free; whether there were any.
fn release(zones: &mut [Zone], ends: &Ends) -> bool {
    let mut released = false;
    for (zone, ends) in zones.iter_mut().zip(ends) {
        for (kind, end) in zone.kinds.iter_mut().zip(ends) {
            if *kind == EndKind::Wall && end.value < -end.rounding {
                *kind = EndKind::Free;
                released = true;
            }
        }
    }
    released
}

/// The zones after steps that neither empty a zone nor jump over a gap nor cross a wall.
fn moved<E: Equation>(
    equation: &E,
    zones: &[Zone],
    ends: &Ends,
    brackets: &Brackets,
    strides: &mut Strides,
) -> Vec<Zone> {
    strides.are_all = true;
    let mut next: Vec<Zone> = Vec::with_capacity(zones.len());
    for (j, zone) in zones.iter().enumerate() {
        let mut moved = *zone;
        let length = zone.length();
        for (side, at) in zone.free_ends() {
            let gap = match side {
                0 => j.checked_sub(1).map(|before| at - zones[before].right()),
                _ => zones.get(j + 1).map(|after| after.left() - at),
            };
            // Beside a narrow gap the pressure changes within it.
            let gap = gap.unwrap_or(f64::INFINITY);
            let step = brackets.within(j, side, at, ends[j][side].outwards(length));
            let shrinking = (1.0 - strides.kept()) * if zone.is_free(1 - side) { 0.5 } else { 1.0 };
            let most = (shrinking * length).min(STRIDE * gap);
            strides.are_all &= step <= -most;
            let step = step.clamp(-most, (0.5 * gap).min(length));
            let to = if side == 0 { at - step } else { at + step };
            let walls = equation.walls();
            let wall = if equation.spans_steps() {
                walls.crossed(side, [at, to])
            } else {
                let wall = walls.beyond(side, zone.middle());
                Some(wall).filter(|wall| if side == 0 { to <= *wall } else { to >= *wall })
            };
            // An end that goes back inwards to a wall, or a hole about the axis that closes, comes there by parts, as to a gap: what is there at once leaves nothing to tell that it was too much.
            let is_hole = |wall: f64| equation.zone([wall, zone.right()]).kinds[0] == EndKind::Axis;
            let by_parts = |wall: f64| {
                let is_far = (at - wall).abs() > CLOSE * length;
                is_far && (step < 0.0 || (side == 0 && is_hole(wall)))
            };
            if let Some(wall) = wall.filter(|wall| by_parts(*wall)) {
                moved.ends[side] = wall + STRIDE * STRIDE * (at - wall);
            } else if let Some(wall) = wall {
                (moved.ends[side], moved.kinds[side]) = (wall, EndKind::Wall);
            } else {
                moved.ends[side] = to;
            }
        }
        match next.last_mut() {
            Some(last) if is_one(equation, last, &moved) => {
                (last.ends[1], last.kinds[1]) = (moved.ends[1], moved.kinds[1]);
            }
            _ => next.push(moved),
        }
    }
    // A zone that goes on shrinking beside others is about to vanish.
    let longest = next.iter().fold(0.0f64, |most, zone| most.max(zone.length()));
    next.retain(|zone| zone.length() > SLIVER * longest);
    equation.arranged(next)
}

/// Whether two neighbours are one zone.
fn is_one<E: Equation>(equation: &E, left: &Zone, right: &Zone) -> bool {
    let free = [left.is_free(1), right.is_free(0)];
    let may_be = if equation.spans_steps() { free.contains(&true) } else { free == [true; 2] };
    may_be && right.left() - left.right() <= CLOSE * right.length().min(left.length())
}

/// Whether the ends stay where they are.
fn is_still(zones: &[Zone], next: &[Zone]) -> bool {
    zones.len() == next.len()
        && zones.iter().zip(next).all(|(zone, next)| {
            let least = 0.5 * f64::EPSILON * zone.length();
            zone.kinds == next.kinds
                && (0..2).all(|side| (next.ends[side] - zone.ends[side]).abs() <= least)
        })
}
