//! Norms of `K(x, .)` near `x` and far from it.

use crate::kernel::Kernel;

/// Shares of the interval at which norms are taken, the ends nearly so.
const PLACES: [f64; 9] = [1e-6, 0.03, 0.125, 0.25, 0.5, 0.75, 0.875, 0.97, 1.0 - 1e-6];
/// Shells about a place: each has half the width of the one before.
const SHELLS: usize = 44;
/// Nodes and weights of Gauss and Legendre on `(0, 1)`.
const NODES: [(f64, f64); 4] = [
    (0.069_431_844_202_973_7, 0.173_927_422_568_727),
    (0.330_009_478_207_571_9, 0.326_072_577_431_273),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273),
    (0.930_568_155_797_026_3, 0.173_927_422_568_727),
];
/// Largest share that the near part of the kernel may have: there `1/(1 - share)` is 2.
const NEAR: f64 = 0.5;

/// Distances of two points whose kernels are compared, over the inverse of `parameter ||K||`.
const APART: [f64; 3] = [1.0, 0.2, 0.04];
/// Below this strength the plain bound serves.
const STRONG: f64 = 10.0;

/// For each place and each shell: `int |K| dm` within it, and the root of `int K^2 dm` beyond it.
pub(super) struct Norms {
    /// The largest `int |K| dm`.
    whole: f64,
    near: Vec<[f64; SHELLS]>,
    far: Vec<[f64; SHELLS]>,
}

impl Norms {
    pub(super) fn new(kernel: &dyn Kernel) -> Self {
        let interval = kernel.interval();
        let length = interval.right() - interval.left();
        let (mut near, mut far, mut whole) = (Vec::new(), Vec::new(), 0.0f64);
        for place in PLACES {
            let x = interval.left() + place * length;
            let shells = shells(kernel, x, length);
            let (mut inside, mut outside) = ([0.0; SHELLS], [0.0; SHELLS]);
            let mut square = 0.0;
            for (index, [_, square_of_shell]) in shells.iter().enumerate() {
                square += square_of_shell;
                outside[index] = square.sqrt();
            }
            // Beyond the last shell they continue as a geometric sequence.
            let [last, before] = [shells[SHELLS - 1][0], shells[SHELLS - 2][0]];
            let rate = if before > 0.0 { (last / before).min(0.97) } else { 0.0 };
            let mut sum = last * rate / (1.0 - rate);
            for index in (0..SHELLS).rev() {
                inside[index] = sum;
                sum += shells[index][0];
            }
            whole = whole.max(sum);
            near.push(inside);
            far.push(outside);
        }
        Self { whole, near, far }
    }

    /// The largest error has to be so large for a residual of this size: `|r| <= |phi - q| (1 + lambda ||K||_1)`, less what resampling may have changed of it.
    pub(super) fn least_error(&self, parameter: f64, residual: f64, misfit: f64) -> f64 {
        let strength = parameter * self.whole;
        ((residual - strength * misfit) / (1.0 + strength)).max(0.0)
    }

    /// The factor of `||r||` in a bound of `parameter |K e|`. As `parameter K` and its sum with 1 have one spectrum apart from that 1, `||parameter K e|| <= ||r||`, so that its mean within `h` of a point is at most
    /// `||r||/sqrt(m)` with the measure `m` of that neighbourhood, and from there to the point it changes by `parameter ||K(x, .) - K(y, .)|| ||r||` at most. None where the plain bound serves.
    pub(super) fn continuity(&self, kernel: &dyn Kernel, parameter: f64) -> Option<f64> {
        let interval = kernel.interval();
        let length = interval.right() - interval.left();
        let size = self.far.iter().map(|norms| norms[SHELLS / 4]).fold(0.0, f64::max);
        let strength = parameter * size * length.sqrt();
        if strength <= STRONG {
            return None;
        }
        let at = |place: f64, share: f64| {
            let x = interval.left() + place * length;
            let h = share * length / strength;
            let y = if place < 0.5 { x + h } else { x - h };
            let mass: f64 =
                NODES.iter().map(|(t, w)| w * h * kernel.measure(x + t * (y - x))).sum();
            let change = square_difference(kernel, x, y, length).sqrt();
            1.0 / mass.sqrt() + parameter * change
        };
        let least = |place: &f64| {
            APART.iter().map(|share| at(*place, *share)).fold(f64::INFINITY, f64::min)
        };
        Some(PLACES.iter().map(least).fold(0.0, f64::max))
    }

    /// The least of the bounds of the largest error over all distances: `(r + lambda N m + lambda F e)/(1 - lambda N)` with the norms `N` near and `F` far, the largest residual `r`, the misfit `m` of the
    /// resampled solution and its error `e` in the mean square.
    pub(super) fn largest_error(
        &self,
        parameter: f64,
        residual: f64,
        misfit: f64,
        mean_square: f64,
    ) -> f64 {
        let most = |norms: &[[f64; SHELLS]], index: usize| {
            norms.iter().map(|norms| norms[index]).fold(0.0, f64::max)
        };
        (0..SHELLS)
            .filter_map(|index| {
                let near = parameter * most(&self.near, index);
                let far = parameter * most(&self.far, index);
                let bound = (residual + near * misfit + far * mean_square) / (1.0 - near);
                (near <= NEAR).then_some(bound)
            })
            .fold(f64::INFINITY, f64::min)
    }
}

/// `int (K(x, s) - K(y, s))^2 dm`, by shells about the nearer of the two.
fn square_difference(kernel: &dyn Kernel, x: f64, y: f64, length: f64) -> f64 {
    let interval = kernel.interval();
    let middle = x.midpoint(y);
    let mut sum = 0.0;
    for (anchor, other) in [(x, y), (y, x)] {
        for side in [-1.0, 1.0] {
            let end = if side < 0.0 { interval.left() } else { interval.right() };
            let is_inner = (other - anchor) * side > 0.0;
            let reach = (if is_inner { middle - anchor } else { end - anchor }).abs();
            for index in 0..SHELLS {
                let outer = length * 0.5f64.powi(index as i32);
                let (from, to) = (0.5 * outer, outer.min(reach));
                if to <= from {
                    continue;
                }
                for (t, weight) in NODES {
                    let distance = from + t * (to - from);
                    let s = anchor + side * distance;
                    let here = kernel.pair(anchor, s, distance).value;
                    let there = kernel.pair(other, s, (other - s).abs()).value;
                    sum += weight * (to - from) * kernel.measure(s) * (here - there).powi(2);
                }
            }
        }
    }
    sum
}

/// `int |K| dm` and `int K^2 dm` over the shells, from the outermost inwards.
fn shells(kernel: &dyn Kernel, x: f64, length: f64) -> [[f64; 2]; SHELLS] {
    let interval = kernel.interval();
    std::array::from_fn(|index| {
        let outer = length * 0.5f64.powi(index as i32);
        let mut sums = [0.0; 2];
        for (side, end) in [(-1.0, x - interval.left()), (1.0, interval.right() - x)] {
            let (from, to) = (0.5 * outer, outer.min(end));
            if to <= from {
                continue;
            }
            for (t, weight) in NODES {
                let distance = from + t * (to - from);
                let s = x + side * distance;
                let value = kernel.pair(x, s, distance).value;
                let mass = weight * (to - from) * kernel.measure(s);
                sums[0] += mass * value.abs();
                sums[1] += mass * value * value;
            }
        }
        sums
    })
}
