//! Nodes of the double-exponential map on the unit interval, shared by all operators that use them.

use std::f64::consts::{FRAC_PI_2, LN_2, PI};

use super::Place;
use crate::kernel::Kernel;
use crate::quadrature::map::Node;
use crate::special::logarithms;
use crate::{Error, Interval};

/// Fewest and most nodes on either side of the middle.
const HALF_COUNTS: std::ops::RangeInclusive<usize> = 4..=4000;
/// End of the range of `t`: what lies beyond, `d ln d` with `d = 1e-20`, leaves 14 digits of the end values of a solution with the logarithm up to `lambda = 1e5`.
const RANGE: f64 = 3.4;
/// `B` over the decay lengths in half the interval. *Measured* for the Macdonald kernel of order 0 between 3 and 120 of them: from 0.04 to 0.09 nodes are about as few; 12 digits take 181 in place
/// of 561 where they are 40.
const EVENNESS: f64 = 0.065;
/// By what the power of a kernel at the centre of a disk counts against `A`. *Measured* for the Weber-Sonine kernel of order 3.9 with `beta = 0.16` and 1.7 with 0.14, 11 digits: 317 and 339 nodes on either side in
/// place of 765 and 564 with 0; 308 and 339 with half of it, whose errors at 220 nodes are ten and a hundred times larger.
const FALLING: f64 = 2.0;
/// Places that are carried back at once.
pub(super) const AT_ONCE: usize = 32;
/// Most steps of Newton's method and of bisection for a node.
const MOST_STEPS: usize = 200;
/// Up to here the distances to the ends do not underflow: they are `2 exp(-2 A sinh T)` of the half-length, and `pi sinh 6 = 634`.
const LARGEST_RANGE: f64 = 6.0;
/// What the tails beyond the range may leave out of the solution of a power kernel.
const TAIL: f64 = 1e-18;

/// The nodes `t_j = j h`, `|t_j| <= T`, and their images under a double-exponential map ([`SincGrid::new`]).
///
/// A grid depends on no parameter, and on an interval only where the kernel decays within it: build it once, share it by reference counting among operators.
#[derive(Debug, Clone, PartialEq)]
pub struct SincGrid {
    half_count: usize,
    step: f64,
    map: Map,
    nodes: Vec<Node>,
}

/// The map of `t` to `(-1, 1)`: `x = tanh(u)`, `t = asinh(u/A) + B x`.
///
/// Near the ends it is `tanh(A sinh t)`. `A = pi/2` where solutions leave their end values as the distance or faster. Where they do as its power `beta < 1`, nodes must reach so much deeper
/// into the corners, and `A = pi/(2 beta)`, for which `d^beta` is at the nodes what `d` is for `beta = 1`: with `pi/2` they would lie so far apart there that the kernel is not resolved.
/// *Measured*, power kernel with `mu = 0.9`, 12 digits: 1400 nodes with `pi/2`. Kernels that fall from the diagonal as a power `(s/x)^mu` need nodes apart by less than `1/mu` in `ln x`, which a large `A` does not give:
/// there it is less, and the range longer, so that nodes reach as deep.
///
/// `B` is there for kernels that decay within the interval: it spreads nodes evenly, where `tanh(A sinh t)` alone would crowd them all at the ends.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Map {
    /// `A`.
    crowding: f64,
    /// `B`.
    evenness: f64,
}

impl SincGrid {
    /// The grid with `2 half_count + 1` nodes and the map that suits a kernel: `x = tanh(u)`, `t = asinh(u/A) + B x`, with `A = pi/(2 beta)` for the
    /// [end exponent](Kernel::end_exponent) `beta`, at most 1, or less for a [power at the centre](Kernel::centre_exponent), and `B` in proportion to the [decay lengths](Kernel::decay_length) in the interval.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `4 <= half_count <= 4000`.
    pub fn new(kernel: &dyn Kernel, half_count: usize) -> Result<Self, Error> {
        let lengths = kernel.interval().half_length() / kernel.decay_length();
        let deepest = FRAC_PI_2 / kernel.end_exponent().min(1.0);
        let falling = 1.0 + FALLING * kernel.centre_exponent();
        let map = Map {
            crowding: (deepest / falling).max(FRAC_PI_2),
            evenness: if lengths.is_finite() { EVENNESS * lengths } else { 0.0 },
        };
        // For beta < 0.07 nodes end where distances underflow, and accuracy is lost.
        let last = (deepest * RANGE.sinh()).min(FRAC_PI_2 * LARGEST_RANGE.sinh());
        Self::mapped(half_count, map.inverse(last, 1.0), map)
    }

    /// The grid with `2 half_count + 1` nodes and the map `tanh(pi/2 sinh t)`, as far into the corners as a solution differs from its end values by more than rounding, whatever the kernel: slopes beside ends need nodes that crowd
    /// there.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `4 <= half_count <= 4000`.
    pub fn crowded(kernel: &dyn Kernel, half_count: usize) -> Result<Self, Error> {
        let exponent = kernel.end_exponent();
        // A point is `2 exp(-pi sinh T)` of the half-length from its end. For beta < 0.05 distances underflow, and accuracy is lost.
        let decades = (LN_2 - TAIL.ln() / exponent) / PI;
        let range =
            if exponent >= 1.0 { RANGE } else { decades.asinh().clamp(RANGE, LARGEST_RANGE) };
        Self::with_range(half_count, range)
    }

    /// The grid with `2 half_count + 1` nodes on `[-T, T]`, `T` being `range`, and the map `tanh(pi/2 sinh t)`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `4 <= half_count <= 4000` and `1 <= range <= 6` (beyond 6 distances to the
    /// ends underflow).
    pub fn with_range(half_count: usize, range: f64) -> Result<Self, Error> {
        if !(1.0..=LARGEST_RANGE).contains(&range) {
            return Err(Error::InvalidParameter {
                name: "range",
                value: range,
                requirement: "between 1 and 6",
            });
        }
        Self::mapped(half_count, range, Map { crowding: FRAC_PI_2, evenness: 0.0 })
    }

    fn mapped(half_count: usize, range: f64, map: Map) -> Result<Self, Error> {
        if !HALF_COUNTS.contains(&half_count) {
            return Err(Error::InvalidParameter {
                name: "half_count",
                value: half_count as f64,
                requirement: "between 4 and 4000",
            });
        }
        let step = range / half_count as f64;
        let unit = Interval::unit();
        let node = |j: usize| {
            let (argument, slope) = map.at(j as f64 * step);
            Node::with_argument(unit, argument, slope)
        };
        let right: Vec<Node> = (0..=half_count).map(node).collect();
        let nodes = right.iter().skip(1).rev().map(Node::mirrored).chain(right.iter().copied());
        Ok(Self { half_count, step, map, nodes: nodes.collect() })
    }

    /// Every other node, from the first to the last; of an even number on either side.
    pub(super) fn coarser(&self) -> Self {
        let nodes = self.nodes.iter().copied().step_by(2).collect();
        Self { half_count: self.half_count / 2, step: 2.0 * self.step, nodes, ..*self }
    }

    /// Nodes on either side of the middle.
    #[must_use]
    pub fn half_count(&self) -> usize {
        self.half_count
    }

    /// Number of nodes, `2 half_count + 1`.
    #[must_use]
    pub fn count(&self) -> usize {
        self.nodes.len()
    }

    /// `h`.
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
    }

    /// `t` of a place of a panel; infinite at its ends.
    pub(super) fn inverse(&self, place: Place) -> f64 {
        let (argument, position) = local(place);
        self.map.inverse(argument, position)
    }

    /// `t/h` of some places of panels, sooner than one by one.
    pub(super) fn steps(&self, places: &[Place; AT_ONCE]) -> [f64; AT_ONCE] {
        let (mut sines, mut positions, mut sizes) =
            ([0.0; AT_ONCE], [0.0; AT_ONCE], [0.0; AT_ONCE]);
        for ((sine, position), place) in sines.iter_mut().zip(&mut positions).zip(places) {
            *sine = place.from_left / place.from_right;
            *position = (place.from_left - place.from_right) / (place.from_left + place.from_right);
        }
        logarithms(&mut sines);
        for (size, sine) in sizes.iter_mut().zip(&mut sines) {
            *sine = 0.5 * *sine / self.map.crowding;
            *size = sine.abs() + (*sine * *sine + 1.0).sqrt();
        }
        logarithms(&mut sizes);
        for ((sine, size), position) in sines.iter_mut().zip(&sizes).zip(&positions) {
            *sine = (size.copysign(*sine) + self.map.evenness * position) / self.step;
        }
        sines
    }

    /// `dx/dt` at a place of a panel.
    pub(super) fn derivative(&self, place: Place) -> f64 {
        let (argument, _) = local(place);
        let half = 0.5 * (place.from_left + place.from_right);
        let (left, right) = (place.from_left / half, place.from_right);
        left * right * self.map.slope(argument, left * (right / half))
    }

    /// The images on `[-1, 1]`, from left to right.
    pub(super) fn nodes(&self) -> &[Node] {
        &self.nodes
    }
}

/// `u` and `tanh(u)` of a place of a panel.
fn local(place: Place) -> (f64, f64) {
    let Place { from_left, from_right, .. } = place;
    let position = (from_left - from_right) / (from_left + from_right);
    (0.5 * (from_left / from_right).ln(), position)
}

impl Map {
    /// `t` of `u` and `x = tanh(u)`, to rounding of 1 or of `t`.
    fn inverse(self, argument: f64, position: f64) -> f64 {
        let sine = argument / self.crowding;
        // asinh; its digits next to 0 are not needed.
        let size = (sine.abs() + (sine * sine + 1.0).sqrt()).ln();
        size.copysign(sine) + self.evenness * position
    }

    /// `du/dt` at `u`, where `1 - tanh(u)^2` is known.
    fn slope(self, argument: f64, square: f64) -> f64 {
        let crowded = (self.crowding * self.crowding + argument * argument).sqrt();
        1.0 / (1.0 / crowded + self.evenness * square)
    }

    /// `u` and `du/dt` at `t >= 0`.
    fn at(self, t: f64) -> (f64, f64) {
        let mut argument = self.crowding * t.sinh();
        if self.evenness == 0.0 {
            return (argument, self.crowding * t.cosh());
        }
        // t is a concave function of u, so that Newton's method from below stays there.
        let ends = [(t - self.evenness).max(0.0), t];
        let [mut low, mut high] = ends.map(|t| self.crowding * t.sinh());
        argument = low;
        for _ in 0..MOST_STEPS {
            let position = argument.tanh();
            let slope = self.slope(argument, (1.0 - position) * (1.0 + position));
            let excess = self.inverse(argument, position) - t;
            *(if excess < 0.0 { &mut low } else { &mut high }) = argument;
            let next = argument - excess * slope;
            let next = if low < next && next < high { next } else { low.midpoint(high) };
            let is_last = (next - argument).abs() <= 4.0 * f64::EPSILON * next;
            argument = next;
            if is_last {
                break;
            }
        }
        let position = argument.tanh();
        (argument, self.slope(argument, (1.0 - position) * (1.0 + position)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_invert_themselves() {
        for crowding in [FRAC_PI_2, 7.0, 20.0] {
            for evenness in [0.0, 0.01, 2.5, 60.0] {
                let map = Map { crowding, evenness };
                for i in 0..=200 {
                    let t = (3.4 + evenness) * f64::from(i) / 200.0;
                    let (argument, slope) = map.at(t);
                    let found = map.inverse(argument, argument.tanh());
                    assert!(
                        (found - t).abs() < 4e-15 * (1.0 + t),
                        "{crowding} {evenness} {t} {found}"
                    );
                    let step = 1e-6 * (1.0 + argument);
                    let [below, above] = [-step, step].map(|step| {
                        let moved = argument + step;
                        map.inverse(moved, moved.tanh())
                    });
                    let exact = 2.0 * step / (above - below);
                    assert!((slope / exact - 1.0).abs() < 1e-7, "{crowding} {evenness} {t}");
                }
            }
        }
    }
}
