//! Where free ends are known to be.

use super::edges::{EndState, FALLING};
use super::zones::Zone;
use crate::intervals::SLIVER;

/// A value below this share of the largest of all ends tells no place (survey).
const OTHERS: f64 = 0.1;

/// The share of the way to a place known to be too far that a step may go: steps that nearly get there from either side come to no end (survey).
const MOST: f64 = 0.75;

/// For each end of each zone the places, inwards and outwards of it, between which its value changed its sign in earlier steps.
///
/// Newton's method alone need not come to an end: beyond a bend of a smooth base, at the distance `d`, the value falls as `sqrt(d)`. From one side its step is far too long, and from the other
/// it leads back across the bend. With a bracket such a step is half the way to the place that is known to be too far, from where the method converges.
///
/// A place that other ends have left behind is no bracket any more: a value that hardly falls on the way there shows it.
#[derive(Debug, Default)]
pub(super) struct Brackets(Vec<[Bracket; 2]>);

#[derive(Debug, Clone, Copy, Default)]
struct Bracket {
    inner: Option<f64>,
    outer: Option<f64>,
    /// The last value.
    value: f64,
}

impl Brackets {
    /// Learns the signs at these ends. What contradicts what is known, as other ends have moved meanwhile, takes its place.
    pub(super) fn learn(&mut self, zones: &[Zone], ends: &[[EndState; 2]]) {
        if self.0.len() != zones.len() {
            self.0 = vec![[Bracket::default(); 2]; zones.len()];
        }
        let share = |end: &EndState| end.value.abs() / end.scale;
        let free = |(zone, ends): (&Zone, &[EndState; 2])| {
            zone.free_ends().map(|(side, _)| share(&ends[side])).fold(0.0, f64::max)
        };
        let worst = zones.iter().zip(ends).map(free).fold(0.0, f64::max);
        for ((zone, ends), known) in zones.iter().zip(ends).zip(&mut self.0) {
            for (side, at) in zone.free_ends() {
                let outwards = if side == 0 { -1.0 } else { 1.0 };
                let value = ends[side].value;
                let is_outside = value < 0.0;
                let Bracket { inner, outer, value: before } = &mut known[side];
                let (same, other) = if is_outside { (outer, inner) } else { (inner, outer) };
                // What the others still move by may be all there is to it.
                if share(&ends[side]) >= OTHERS * worst {
                    *same = Some(at);
                }
                let width = |place: f64| {
                    if is_outside { outwards * (at - place) } else { outwards * (place - at) }
                };
                let falls = value / *before < FALLING || *before == 0.0;
                *other = other.filter(|place| falls && width(*place) > SLIVER * zone.length());
                *before = value;
            }
        }
    }

    /// A step outwards from an end, no longer than half the way to where it is known to be too far.
    pub(super) fn within(&self, zone: usize, side: usize, at: f64, step: f64) -> f64 {
        let Some(known) = self.0.get(zone) else { return step };
        let Bracket { inner, outer, .. } = known[side];
        let limit = if step < 0.0 { inner } else { outer };
        match limit {
            Some(place) if step.abs() >= MOST * (place - at).abs() => {
                0.5 * (place - at).abs().copysign(step)
            }
            _ => step,
        }
    }
}
