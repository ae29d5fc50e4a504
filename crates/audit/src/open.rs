//! How far free ends of zones are off, by samples.

use crate::sampled::Seen;

/// Places at which the pressure is looked at from one distance of an end to half of it.
const LOOKED: usize = 9;
/// Halvings of the distance from an end.
const HALVINGS: usize = 60;

/// Inside of a free end the pressure exceeds what it is off by, beyond it the residual what it may be; none where a gap elsewhere may close, or no end is free. `ends` are the free ones,
/// each with the other end of its zone.
pub(crate) fn free_ends(
    ends: &[[f64; 2]],
    gaps: &[Seen],
    pressure_at: &dyn Fn(f64) -> f64,
    [pressure, margin]: [f64; 2],
) -> Option<f64> {
    let mut open: Vec<(&Seen, bool)> =
        gaps.iter().filter(|gap| gap.least <= margin).map(|gap| (gap, false)).collect();
    let mut worst: Option<f64> = None;
    for [end, other] in ends.iter().copied() {
        let inside = inside(pressure_at, [end, other], pressure)?;
        let is_right = other < end;
        let mut outside = end;
        loop {
            let touches =
                |gap: &Seen| if is_right { gap.left == outside } else { gap.right == outside };
            let Some((gap, used)) = open.iter_mut().find(|(gap, used)| !used && touches(gap))
            else {
                break;
            };
            *used = true;
            outside = if is_right { gap.right } else { gap.left };
        }
        worst = Some(worst.unwrap_or(0.0).max(inside).max((outside - end).abs()));
    }
    if open.iter().any(|(_, used)| !used) { None } else { worst }
}

/// The distance from an end from which on the pressure exceeds what it may be off by, as far as the middle of the zone.
fn inside(pressure_at: &dyn Fn(f64) -> f64, [end, other]: [f64; 2], pressure: f64) -> Option<f64> {
    let mut far = 0.5 * (other - end);
    let mut known = None;
    for _ in 0..HALVINGS {
        let near = 0.5 * far;
        let places = (0..LOOKED).map(|i| near + (far - near) * i as f64 / (LOOKED - 1) as f64);
        let least = places.map(|d| pressure_at(end + d)).fold(f64::INFINITY, f64::min);
        if least <= pressure {
            break;
        }
        known = Some(near.abs());
        far = near;
    }
    known
}
