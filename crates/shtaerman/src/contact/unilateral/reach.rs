//! Whether a settlement is in reach of a force at an eccentricity: `delta(P)` by collocation, with its slope from the tangent stiffness.
//!
//! `d delta/dP = (c22 - e c12)/(c11 c22 - c12^2)` at the eccentricity `e`: free edges that move add nothing of first order. Cells have shown where `delta(P)` comes
//! close to the settlement; there the contact is solved until either the settlement is crossed or the slope changes its sign.

use super::base::Base;
use super::quickly;
use super::zones::Zone;
use crate::contact::solved::Stiffness;
use crate::{Error, Load, Rotational, Vertical};

/// Steps towards a largest or least settlement, and towards the force sought.
const STEPS: usize = 40;
/// Relative width of a bracket of forces that is as good as none.
const NARROW: f64 = 1e-9;
/// Step of the logarithm of the force along the curve, and how often it is taken.
const STRIDE: f64 = std::f64::consts::LN_2;
const STRIDES: usize = 48;

/// The zones under the least force found with this settlement. `samples` are forces with about `delta(P) - delta`.
///
/// # Errors
/// [`Error::NoContact`] where the base is clear and no force leads there, [`Error::SettlementOutOfReach`] where none does though it is not.
pub(super) fn zones(
    base: &Base<'_>,
    settlement: f64,
    e: f64,
    samples: &[[f64; 2]],
) -> Result<Vec<Zone>, Error> {
    let curve = Curve { base, settlement, e };
    let mut nearest: Option<f64> = None;
    let mut is_lost = false;
    for start in starts(samples) {
        match curve.search(start, samples) {
            Some(Search::Found(zones)) => return Ok(zones),
            Some(Search::Turns(excess))
                if nearest.is_none_or(|known| excess.abs() < known.abs()) =>
            {
                nearest = Some(excess);
            }
            Some(Search::Turns(_)) => {}
            Some(Search::Lost) | None => is_lost |= is_crossed(samples, start),
        }
    }
    if is_lost && !base.touches_nowhere() {
        // Cells show a force with this settlement, and the contacts there were not found.
        return Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN });
    }
    let by_cells =
        samples.iter().map(|sample| sample[1]).min_by(|a, b| a.abs().total_cmp(&b.abs()));
    Err(curve.out_of_reach(nearest.or(by_cells).unwrap_or(f64::NAN)))
}

/// Samples where the curve crosses or comes closest among its neighbours, from small forces to large.
fn starts(samples: &[[f64; 2]]) -> Vec<usize> {
    let size = |i: usize| samples[i][1].abs();
    let is_least = |i: usize| {
        (i == 0 || size(i) < size(i - 1)) && (i + 1 == samples.len() || size(i) <= size(i + 1))
    };
    (0..samples.len()).filter(|&i| is_crossed(samples, i) || is_least(i)).collect()
}

/// Whether the settlement lies between those of a sample and the one before.
fn is_crossed(samples: &[[f64; 2]], i: usize) -> bool {
    i > 0 && (samples[i][1] > 0.0) != (samples[i - 1][1] > 0.0)
}

/// What a search along the curve comes to.
enum Search {
    Found(Vec<Zone>),
    /// The least distance from the settlement, with its sign.
    Turns(f64),
    /// Contacts on the way were not found.
    Lost,
}

/// A point of the curve.
#[derive(Clone)]
struct Point {
    /// `ln P`.
    log: f64,
    /// `delta(P) - delta`.
    excess: f64,
    /// `d delta/d ln P`.
    slope: f64,
    zones: Vec<Zone>,
}

impl Point {
    fn is_beyond(&self, other: &Self) -> bool {
        (self.excess > 0.0) != (other.excess > 0.0)
    }

    /// Whether the distance falls with the force.
    fn falls(&self) -> bool {
        (self.excess > 0.0) != (self.slope > 0.0)
    }
}

/// `delta(P)` by collocation on few nodes.
struct Curve<'b, 'p> {
    base: &'b Base<'p>,
    settlement: f64,
    e: f64,
}

impl Curve<'_, '_> {
    /// The contact under a force, where it is found.
    fn at(&self, log: f64) -> Option<Point> {
        let force = log.exp();
        let rotational = Rotational::Eccentricity(self.e);
        let solved =
            quickly(&self.base.under(Load { vertical: Vertical::Force(force), rotational }))?;
        let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = solved.stiffness;
        let slope = force * (c22 - self.e * c12) / (c11 * c22 - c12 * c12);
        let excess = solved.state.settlement - self.settlement;
        (slope.is_finite() && excess.is_finite()).then_some(Point {
            log,
            excess,
            slope,
            zones: solved.zones,
        })
    }

    /// From a sample in the direction in which the settlement comes closer, until it is crossed or the slope turns.
    fn search(&self, start: usize, samples: &[[f64; 2]]) -> Option<Search> {
        // The smallest forces leave no digits of the heights.
        let mut here = samples[start..].iter().find_map(|sample| self.at(sample[0].ln()))?;
        let ends = [samples[0][0], samples[samples.len() - 1][0]].map(f64::ln);
        let step = if here.falls() { STRIDE } else { -STRIDE };
        for _ in 0..STRIDES {
            let log = here.log + step;
            if log < ends[0] || log > ends[1] {
                break;
            }
            let Some(next) = self.at(log) else { return Some(Search::Lost) };
            if next.is_beyond(&here) {
                return Some(self.between(&here, next));
            }
            if next.falls() != here.falls() {
                return Some(self.turning(here, next));
            }
            here = next;
        }
        Some(Search::Turns(here.excess))
    }

    /// The crossing between two points, by Newton's steps that stay between.
    fn between(&self, one: &Point, other: Point) -> Search {
        let (mut ends, mut best) = ([one.log, other.log], one.clone());
        if other.excess.abs() < best.excess.abs() {
            best = other;
        }
        let mut here = best.clone();
        for _ in 0..STEPS {
            let newton = here.log - here.excess / here.slope;
            let inside = newton > ends[0].min(ends[1]) && newton < ends[0].max(ends[1]);
            let log = if inside { newton } else { 0.5 * (ends[0] + ends[1]) };
            let Some(next) = self.at(log) else { break };
            ends[usize::from(next.is_beyond(one))] = log;
            if next.excess.abs() < best.excess.abs() {
                best = next.clone();
            }
            let change = (log - here.log).abs();
            here = next;
            if change < NARROW {
                break;
            }
        }
        Search::Found(best.zones)
    }

    /// The largest or least settlement between two points, by halving; or a crossing on the way.
    fn turning(&self, mut one: Point, mut other: Point) -> Search {
        let mut nearest = one.excess;
        for _ in 0..STEPS {
            let Some(middle) = self.at(0.5 * (one.log + other.log)) else { return Search::Lost };
            if middle.is_beyond(&one) {
                return self.between(&one, middle);
            }
            if middle.excess.abs() < nearest.abs() {
                nearest = middle.excess;
            }
            if middle.falls() == one.falls() {
                one = middle;
            } else {
                other = middle;
            }
            if (one.log - other.log).abs() < 1e-3 * NARROW.sqrt() {
                break;
            }
        }
        Search::Turns(nearest)
    }

    fn out_of_reach(&self, excess: f64) -> Error {
        if self.base.touches_nowhere() {
            return Error::NoContact;
        }
        let scaling = self.base.problem.frame().scaling();
        let unit = scaling.map_or(1.0, crate::Scaling::displacement);
        Error::SettlementOutOfReach {
            value: self.settlement * unit,
            eccentricity: self.e * self.base.problem.frame().half_width(),
            limit: (self.settlement + excess) * unit,
            bound: if excess > 0.0 { "less deep" } else { "deeper" },
        }
    }
}
