//! The Cauchy transform of the pressure on one panel, by Stenger's sinc formula.
//!
//! With `s(t) = l + (r-l)/(1 + e^-t)` and the nodes `t_j = jh` (or `(j + 1/2)h`), the sinc interpolant of `p s' (t - tau)/(z - s)` has the Cauchy transform
//!
//! `F(z) = sum_j h s'_j p_j/(z - s_j) [1 - e^(i pi (tau - t_j)/h)]`, `tau = ln((z - l)/(r - z))`,
//!
//! for `z` in the upper half-plane and on the panel itself. The other preimages of `z` are `2 pi i` apart whatever the place of `z`, unlike those of a
//! double-exponential map, which crowd to the real axis for `z` near an end: so one step is right for all `z`. Half of the accuracy is
//! lost for `z` at a node, where the bracket is a difference of equal numbers: there the other set of nodes is taken, half a step away.

use std::f64::consts::PI;

use super::complex::Complex;
use super::nodes::{Nodes, Sums, combined};
use crate::Error;

/// The smallest bracket that counts, and the node where the panel is thought to end: `s' p`, relative to the largest, and distances, relative to the length.
const NEGLIGIBLE_BRACKET: f64 = 1e-19;
const NEGLIGIBLE_STRENGTH: f64 = 1e-20;
const SMALL_DISTANCE: f64 = 1e-19;
const LEAST_DISTANCE: f64 = 1e-33;
/// A base that leaves open no more of its period than this leaves nothing: edges are computed (rounding).
pub(super) const SEAM: f64 = 1e-12;

/// `F`, `F'`, `F''`.
pub(super) type Potential = [Complex; 3];

/// A place in the closed half-plane as a panel sees it; both distances keep their digits near their end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Seen {
    /// `x - l`.
    pub(super) from_left: f64,
    /// `r - x`.
    pub(super) to_right: f64,
    /// `x` less the nearest repetition of either end: of a base without gaps both are the same place.
    nearest: [f64; 2],
    /// Depth.
    pub(super) depth: f64,
}

/// Nodes `t_j = (j + shift) h`, by the end they are measured from and the parity of `j`.
#[derive(Debug, Clone, Default)]
struct Grid {
    nodes: [[Nodes; 2]; 2],
}

/// A panel with a pressure that is smooth inside.
#[derive(Debug, Clone)]
pub(super) struct Panel {
    pub(super) left: f64,
    pub(super) right: f64,
    /// Pressures at the ends, perhaps infinite.
    pub(super) ends: [f64; 2],
    step: f64,
    grids: [Grid; 2],
    /// The period of a pressure that is repeated, and either end with its repetitions on both sides.
    period: Option<f64>,
    images: [[f64; 3]; 2],
}

impl Panel {
    /// Samples `pressure(distance from the left end, distance from the right end)`.
    pub(super) fn new(
        [left, right]: [f64; 2],
        step: f64,
        period: Option<f64>,
        pressure: &dyn Fn(f64, f64) -> f64,
    ) -> Result<Self, Error> {
        let length = right - left;
        let ends = [pressure(0.0, length), pressure(length, 0.0)];
        if let Some(value) = ends.into_iter().find(|value| value.is_nan()) {
            return Err(Error::Overflow { quantity: "pressure", value });
        }
        let images =
            [left, right].map(|end| [-1.0, 0.0, 1.0].map(|by| end + by * period.unwrap_or(0.0)));
        let mut panel = Self { left, right, ends, step, grids: Default::default(), period, images };
        for (grid, shift) in [(0, 0.0), (1, 0.5)] {
            panel.grids[grid] = sampled(length, step, shift, period, pressure)?;
        }
        Ok(panel)
    }

    pub(super) fn length(&self) -> f64 {
        self.right - self.left
    }

    pub(super) fn step(&self) -> f64 {
        self.step
    }

    /// Number of nodes of one grid.
    pub(super) fn nodes(&self) -> usize {
        self.strengths().count()
    }

    /// `int |p| ds`.
    pub(super) fn absolute_force(&self) -> f64 {
        self.strengths().map(f64::abs).sum()
    }

    /// `int p ds`.
    pub(super) fn force(&self) -> f64 {
        self.strengths().sum()
    }

    fn strengths(&self) -> impl Iterator<Item = f64> {
        let nodes = self.grids[0].nodes.as_flattened();
        nodes.iter().flat_map(|nodes| nodes.strengths().iter().copied())
    }

    /// The nodes of both grids from left to right, each with the size of the pressure there; but for the outermost ones, which stand for what lies beyond them, too.
    pub(super) fn samples(&self) -> Vec<(f64, f64)> {
        let (length, mut samples) = (self.length(), Vec::new());
        for grid in &self.grids {
            for ([_, end, _], nodes) in self.images.iter().zip(&grid.nodes) {
                for (offset, strength) in nodes.iter().flat_map(Nodes::inner) {
                    let [near, far] = [offset.abs(), length - offset.abs()];
                    let size = (strength / (self.step * (near * (far / length)))).abs();
                    samples.push((end + offset, size));
                }
            }
        }
        crate::order::sort_by_number(&mut samples, |(x, _)| *x);
        samples
    }

    /// Lets the first and the last panel of a base without gaps meet at one place, as seen from either: else rounding parts them, and a place beside the seam is near to one of two ends only.
    pub(super) fn close(panels: &mut [Self]) {
        if let [first, ..] = panels {
            let left = first.left;
            let last = panels.len() - 1;
            let right = panels[last].right;
            panels[last].images[1][0] = left;
            panels[0].images[0][2] = right;
        }
    }

    /// How the panel, or that of its repetitions which is nearest, sees a place no farther away than a period.
    pub(super) fn seen(&self, x: f64, depth: f64) -> Seen {
        let is_inside = (self.left..=self.right).contains(&x);
        let turn = self.period.filter(|_| !is_inside).map_or(0.0, |period| {
            ((x - 0.5 * (self.left + self.right)) / period).round().clamp(-1.0, 1.0)
        });
        let [left, right] = self.images.map(|images| images[(1.0 + turn) as usize]);
        let nearest = self.images.map(|images| {
            let distances = images.map(|image| x - image);
            distances.into_iter().fold(f64::INFINITY, |a, b| if b.abs() < a.abs() { b } else { a })
        });
        Seen { from_left: x - left, to_right: right - x, nearest, depth }
    }

    /// The place `tau` of the strip.
    pub(super) fn place(&self, tau: Complex) -> Seen {
        let fraction = |sign: f64| {
            let size = (-sign * tau.re).exp();
            let below =
                Complex::new(1.0 + size * tau.im.cos(), -sign * size * tau.im.sin()).inverse();
            below.scaled(self.length())
        };
        let (left, right) = (fraction(1.0), fraction(-1.0));
        let (from_left, to_right) = (left.re, right.re);
        // Beyond half a period the other repetition is nearer, which the other end is so far away from.
        let nearest = match self.period {
            Some(period) => {
                let gap = period - self.length();
                let gap = if gap <= SEAM * period { 0.0 } else { gap };
                let is_far = |distance: f64| distance > 0.5 * period;
                [
                    if is_far(from_left) { -(to_right + gap) } else { from_left },
                    if is_far(to_right) { from_left + gap } else { -to_right },
                ]
            }
            None => [from_left, -to_right],
        };
        Seen { from_left, to_right, nearest, depth: left.im.max(0.0) }
    }

    /// `F`, `F'` and, where `CUBES`, `F''` at a place that is no end of the panel.
    pub(super) fn potential<const CUBES: bool>(&self, seen: Seen) -> Potential {
        let tau = self.preimage(seen);
        let place = tau.re / self.step;
        let fraction = place - place.floor();
        let grid = usize::from(!(0.25..=0.75).contains(&fraction));
        self.potential_by::<CUBES>(grid, tau, seen)
    }

    /// `tau = ln((z - l)/(r - z))`, in the strip `0 <= Im tau <= pi`.
    fn preimage(&self, Seen { from_left, to_right, depth, .. }: Seen) -> Complex {
        let ratio = from_left.hypot(depth) / to_right.hypot(depth);
        Complex::new(ratio.ln(), depth.atan2(from_left) + depth.atan2(to_right))
    }

    /// Largest difference of both grids at the place `tau`, which is as far from either's nodes, relative to the stresses there and to `scale`.
    pub(super) fn grid_difference(&self, tau: Complex, scale: f64) -> f64 {
        let seen = self.place(tau);
        let [one, two] = [0, 1].map(|grid| self.potential_by::<false>(grid, tau, seen));
        let size = |value: Complex, factor: f64| factor * value.size() / PI;
        let pairs = [
            (size(one[0] - two[0], 1.0), size(one[0], 1.0)),
            (size(one[1] - two[1], seen.depth), size(one[1], seen.depth)),
        ];
        pairs.into_iter().map(|(error, value)| error / (scale + value)).fold(0.0, f64::max)
    }

    fn potential_by<const CUBES: bool>(&self, grid: usize, tau: Complex, seen: Seen) -> Potential {
        let Seen { from_left, to_right, depth, .. } = seen;
        let [even, odd] = [0, 1].map(|parity| {
            let [left, right]: [Sums; 2] = [0, 1].map(|end| {
                let x = seen.nearest[end];
                self.grids[grid].nodes[end][parity].sums::<CUBES>(x, depth, self.period)
            });
            [0, 1, 2].map(|i| left[i] + right[i])
        });
        let (plain, alternating) = combined(&even, &odd);
        let decay = (-PI * tau.im / self.step).exp();
        if decay < NEGLIGIBLE_BRACKET {
            return [plain[0], Complex::ZERO - plain[1], plain[2].scaled(2.0)];
        }
        let bracket = self.bracket(grid, tau.re / self.step, decay);
        let alternating = alternating.map(|sum| sum * bracket);
        let part = [0, 1, 2].map(|i| plain[i] - alternating[i]);
        // tau' = 1/s'(tau), s'(tau) = (z - l)(r - z)/(r - l).
        let slope = (Complex::new(from_left, depth) * Complex::new(to_right, -depth))
            .scaled(1.0 / self.length());
        let rate = Complex::new(0.0, PI / self.step) * slope.inverse();
        let first = Complex::ZERO - part[1] - rate * alternating[0];
        if !CUBES {
            return [part[0], first, Complex::ZERO];
        }
        let bend = Complex::new(to_right - from_left, -2.0 * depth).scaled(1.0 / self.length());
        let change = rate * rate - rate * bend * slope.inverse();
        let second =
            part[2].scaled(2.0) + (rate * alternating[1]).scaled(2.0) - change * alternating[0];
        [part[0], first, second]
    }

    /// `e^(i pi (tau - t_0)/h)`.
    fn bracket(&self, grid: usize, place: f64, decay: f64) -> Complex {
        let whole = place.floor();
        let sign = if whole.rem_euclid(2.0) == 0.0 { decay } else { -decay };
        let (sine, cosine) = (PI * (place - whole)).sin_cos();
        // Half a step turns by -i.
        let turned = if grid == 0 { [cosine, sine] } else { [sine, -cosine] };
        Complex::new(sign * turned[0], sign * turned[1])
    }
}

/// The nodes from the middle outwards, to where they no longer count.
fn sampled(
    length: f64,
    step: f64,
    shift: f64,
    period: Option<f64>,
    pressure: &dyn Fn(f64, f64) -> f64,
) -> Result<Grid, Error> {
    let mut grid = Grid::default();
    let mut largest = 0.0f64;
    let mut add = |index: i64| -> Result<bool, Error> {
        let t = (index as f64 + shift) * step;
        let (left, right) = (length / (1.0 + (-t).exp()), length / (1.0 + t.exp()));
        let value = pressure(left, right);
        if !value.is_finite() {
            return Err(Error::Overflow { quantity: "pressure", value });
        }
        let strength = step * (left * (right / length)) * value;
        let (end, offset) = if t <= 0.0 { (0, left) } else { (1, -right) };
        grid.nodes[end][index.rem_euclid(2) as usize].push(offset, strength);
        largest = largest.max(strength.abs());
        let distance = left.min(right) / length;
        let faint = strength.abs() <= NEGLIGIBLE_STRENGTH * largest;
        Ok(distance > LEAST_DISTANCE && !(faint && distance < SMALL_DISTANCE))
    };
    let mut index = 0;
    while add(index)? {
        index += 1;
    }
    index = -1;
    while add(index)? {
        index -= 1;
    }
    grid.nodes.as_flattened_mut().iter_mut().for_each(|nodes| {
        nodes.close();
        nodes.finish(period);
    });
    Ok(grid)
}
