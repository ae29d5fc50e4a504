//! Where free ends are known to be.

use super::edges::EndState;
use super::intervals::SLIVER;
use super::zones::Zone;

/// For each end of each zone the places, inwards and outwards of it, between which its value changed its sign in earlier steps.
///
/// Newton's method alone need not come to an end: beyond a bend of a smooth base, at the distance `d`, the value falls as `sqrt(d)`. From one side its step is far too long, and from the other
/// it leads back across the bend. With a bracket such a step is half the way to the place that is known to be too far, from where the method converges.
#[derive(Debug, Default)]
pub(super) struct Brackets(Vec<[[Option<f64>; 2]; 2]>);

impl Brackets {
    /// Learns the signs at these ends. What contradicts what is known, as other ends have moved meanwhile, takes its place.
    pub(super) fn learn(&mut self, zones: &[Zone], ends: &[[EndState; 2]]) {
        if self.0.len() != zones.len() {
            self.0 = vec![[[None; 2]; 2]; zones.len()];
        }
        for ((zone, ends), known) in zones.iter().zip(ends).zip(&mut self.0) {
            for (side, at) in zone.free_ends() {
                let outwards = if side == 0 { -1.0 } else { 1.0 };
                let is_outside = ends[side].value < 0.0;
                let [inner, outer] = &mut known[side];
                let (same, other) = if is_outside { (outer, inner) } else { (inner, outer) };
                *same = Some(at);
                let width = |place: f64| {
                    if is_outside { outwards * (at - place) } else { outwards * (place - at) }
                };
                *other = other.filter(|place| width(*place) > SLIVER * zone.length());
            }
        }
    }

    /// A step outwards from an end, no longer than half the way to where it is known to be too far.
    pub(super) fn within(&self, zone: usize, side: usize, at: f64, step: f64) -> f64 {
        let Some(known) = self.0.get(zone) else { return step };
        let [inner, outer] = known[side];
        let limit = if step < 0.0 { inner } else { outer };
        match limit {
            Some(place) if step.abs() >= (place - at).abs() => {
                0.5 * (place - at).abs().copysign(step)
            }
            _ => step,
        }
    }
}
