//! A solution of collocation, which can be evaluated anywhere.

use std::f64::consts::PI;
use std::sync::Arc;

use super::grid::AT_ONCE;
use super::mesh::Mesh;
use super::{Place, SincGrid};
use crate::linear::{dot, vectorised};

/// Independent partial sums of the interpolation.
const LANES: usize = 8;
/// A point this close to a node, in steps, is that node.
const AT_NODE: f64 = 1e-13;

/// A solution of collocation: values at the nodes and what evaluation elsewhere needs.
///
/// Between the nodes `U = K phi` is interpolated and `phi = f - lambda U`: with the straight line `l` through the values of
/// `U` at the ends of the panel, `v_j = U_j - l_j` and `tau = t(x)/h`,
///
/// `U(x) = l(x) + (sin(pi tau)/pi) sum_j (-1)^j v_j / (tau - j)`.
#[derive(Debug, Clone)]
pub struct SincSolution {
    mesh: Arc<Mesh>,
    parameter: f64,
    values: Vec<f64>,
    /// `m_j phi_j` with the masses of the nodes.
    masses: Vec<f64>,
    potential: Vec<f64>,
    /// `U` at the boundaries of the panels.
    boundaries: Vec<f64>,
    bubble: Bubble,
}

/// A function by its values `v_j` at the nodes of panels of `count = 2 half_count + 1`: `(sin(pi tau)/pi) sum_j (-1)^j v_j / (tau - j)`.
#[derive(Debug, Clone)]
pub(super) struct Bubble {
    half_count: usize,
    values: Vec<f64>,
    panels: Vec<Pairs>,
}

/// `v_j / (tau - j)` and `v_-j / (tau + j)` added over their common denominator `tau^2 - j^2`, with the sign `(-1)^j`.
#[derive(Debug, Clone)]
struct Pairs {
    sums: Vec<f64>,
    differences: Vec<f64>,
}

impl SincSolution {
    pub(super) fn new(
        mesh: Arc<Mesh>,
        parameter: f64,
        values: Vec<f64>,
        masses: Vec<f64>,
        potential: Vec<f64>,
        boundaries: Vec<f64>,
    ) -> Self {
        let bubble = (mesh.places().zip(&potential))
            .map(|(place, u)| u - line(&boundaries, mesh.left_end(place.panel), place))
            .collect();
        let bubble = Bubble::new(mesh.grid(), bubble);
        Self { mesh, parameter, values, masses, potential, boundaries, bubble }
    }

    /// `lambda`.
    #[must_use]
    pub fn parameter(&self) -> f64 {
        self.parameter
    }

    /// `phi` at the nodes.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// `(K phi)` at the nodes.
    #[must_use]
    pub fn potential(&self) -> &[f64] {
        &self.potential
    }

    /// `w_j m_j phi_j` at the nodes: what the integral adds up.
    #[must_use]
    pub fn node_masses(&self) -> &[f64] {
        &self.masses
    }

    /// `int_L u phi dm` with the measure of the kernel.
    #[must_use]
    pub fn integral(&self, u: impl Fn(f64) -> f64) -> f64 {
        (self.mesh.places().zip(&self.masses)).map(|(place, mass)| u(place.position) * mass).sum()
    }

    /// [`integral`](Self::integral) for a function that is known sooner at many points at once: `u` fills in its values at the points of a list.
    #[must_use]
    pub fn integral_of(&self, u: impl FnOnce(&[f64], &mut [f64])) -> f64 {
        let mut values = vec![0.0; self.masses.len()];
        u(self.mesh.positions(), &mut values);
        vectorised(
            #[inline(always)]
            || dot(&values, &self.masses),
        )
    }

    /// `phi(x)` for `x` in the closed interval, given `f(x)`; points outside, and those in a gap between panels, count as the nearer end.
    ///
    /// At a breakpoint `f(x)` decides which one-sided value it is: `K phi` is continuous.
    #[must_use]
    pub fn evaluate(&self, x: f64, right_hand_side: f64) -> f64 {
        right_hand_side - self.parameter * self.potential_at(self.mesh.locate(x))
    }

    /// `phi` at a place given by its distances to the ends of its panel, to all their digits; the position is not used. A
    /// panel that does not exist counts as the last.
    #[must_use]
    pub fn evaluate_place(&self, place: Place, right_hand_side: f64) -> f64 {
        let panel = place.panel.min(self.mesh.panels() - 1);
        right_hand_side - self.parameter * self.potential_at(Place { panel, ..place })
    }

    /// `phi` at several points, given `f` there, without allocation; as many as the shortest of the three lists has.
    pub fn evaluate_into(&self, points: &[f64], right_hand_side: &[f64], values: &mut [f64]) {
        let lists = points.chunks(AT_ONCE).zip(right_hand_side.chunks(AT_ONCE));
        for ((points, right), values) in lists.zip(values.chunks_mut(AT_ONCE)) {
            let places = self.mesh.locate_all(points);
            let steps = self.mesh.grid().steps(&places);
            let at_places = places.into_iter().zip(steps);
            for (((place, tau), f), value) in at_places.zip(right).zip(values) {
                *value = f - self.parameter * self.potential_of(place, || tau);
            }
        }
    }

    /// `phi` times the density of the measure at a place between the ends of a panel, from the solution of the system alone, without `f - lambda K phi`.
    ///
    /// Of that small difference [`evaluate_place`](Self::evaluate_place) keeps an error of about `eps lambda`, everywhere; here it is about `eps/d` at the distance
    /// `d` from the nearer end: less where `lambda d > 1`, more closer to the end. With `g = dx/dt m phi`, which vanishes at both ends,
    /// `g(t) = (sin(pi tau)/pi) sum_j (-1)^j g_j/(tau - j)`, `tau = t/h`.
    ///
    /// ```
    /// use fredholm::SincOperator;
    /// use fredholm::collocation::Place;
    /// use fredholm::kernel::Logarithm;
    ///
    /// let operator = SincOperator::new(&Logarithm::unit(), 60)?;
    /// let solution = &operator.solve(20.0, &[operator.sample(f64::cos)?])?[0];
    /// let place = Place { position: 0.3, from_left: 1.3, from_right: 0.7, panel: 0 };
    /// assert!((solution.density_at(place) - solution.evaluate(0.3, 0.3f64.cos())).abs() < 1e-12);
    /// # Ok::<(), fredholm::Error>(())
    /// ```
    #[must_use]
    pub fn density_at(&self, place: Place) -> f64 {
        let count = self.mesh.panel_count();
        let start = place.panel.min(self.mesh.panels() - 1) * count;
        let masses = &self.masses[start..start + count];
        let grid = self.mesh.grid();
        let half_count = grid.half_count() as f64;
        let tau = grid.inverse(place) / grid.step();
        let nearest = tau.round();
        let mass = if (tau - nearest).abs() < AT_NODE && nearest.abs() <= half_count {
            masses[(nearest + half_count) as usize]
        } else {
            let mut sign = if grid.half_count().is_multiple_of(2) { 1.0 } else { -1.0 };
            let mut sum = 0.0;
            for (j, mass) in masses.iter().enumerate() {
                sum += sign * mass / (tau - (j as f64 - half_count));
                sign = -sign;
            }
            sum * sine_of_turns(tau, nearest)
        };
        mass / (grid.step() * grid.derivative(place))
    }

    /// `(K phi)(x)` for `x` in the closed interval.
    #[must_use]
    pub fn evaluate_potential(&self, x: f64) -> f64 {
        self.potential_at(self.mesh.locate(x))
    }

    /// `(K phi)` at a place.
    pub(super) fn potential_at(&self, place: Place) -> f64 {
        let grid = self.mesh.grid();
        self.potential_of(place, || grid.inverse(place) / grid.step())
    }

    /// `(K phi)` at a place of which `tau = t/h` is known where it is not an end.
    fn potential_of(&self, place: Place, tau: impl FnOnce() -> f64) -> f64 {
        let end = self.mesh.left_end(place.panel);
        if place.from_left <= 0.0 {
            return self.boundaries[end];
        }
        if place.from_right <= 0.0 {
            return self.boundaries[end + 1];
        }
        line(&self.boundaries, end, place) + self.bubble.at(place.panel, tau())
    }

    /// The interpolated part of `K phi` at `t` in a panel, beside the straight line.
    pub(super) fn interpolate(&self, panel: usize, t: f64) -> f64 {
        self.bubble.at(panel, t / self.mesh.grid().step())
    }

    /// `(K phi)` at the places of all panels that are halfway, in `t`, between neighbouring nodes.
    pub(super) fn potential_halfway(&self, places: impl Iterator<Item = Place>) -> Vec<f64> {
        let at_places = places.zip(self.bubble.halfway());
        at_places
            .map(|(place, v)| line(&self.boundaries, self.mesh.left_end(place.panel), place) + v)
            .collect()
    }

    pub(super) fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    pub(super) fn boundaries(&self) -> &[f64] {
        &self.boundaries
    }

    /// `v_j`.
    pub(super) fn bubble(&self) -> &[f64] {
        &self.bubble.values
    }

    /// `m_j phi_j` at the nodes.
    pub(super) fn masses(&self) -> &[f64] {
        &self.masses
    }
}

/// `sin(pi tau)/pi`, reduced by hand: `tau` itself may be large. `nearest` is the integer nearest to `tau`.
pub(super) fn sine_of_turns(tau: f64, nearest: f64) -> f64 {
    // As a whole number: a remainder takes longer than the sine.
    let sign = if nearest as i64 % 2 == 0 { 1.0 } else { -1.0 };
    sign * (PI * (tau - nearest)).sin() / PI
}

/// The straight line through the values at the ends of the panel, the left of which is the boundary `end`.
pub(super) fn line(boundaries: &[f64], end: usize, place: Place) -> f64 {
    let Place { from_left, from_right, .. } = place;
    (boundaries[end] * from_right + boundaries[end + 1] * from_left) / (from_left + from_right)
}

impl Bubble {
    /// From the values at the nodes of all panels.
    pub(super) fn new(grid: &SincGrid, values: Vec<f64>) -> Self {
        let panels = values.chunks_exact(grid.count()).map(Pairs::new).collect();
        Self { half_count: grid.half_count(), values, panels }
    }

    /// The value at `tau = t/h` in a panel.
    pub(super) fn at(&self, panel: usize, tau: f64) -> f64 {
        let half_count = self.half_count as f64;
        let nearest = tau.round();
        let values = &self.values[panel * (2 * self.half_count + 1)..];
        if (tau - nearest).abs() < AT_NODE && nearest.abs() <= half_count {
            return values[(nearest + half_count) as usize];
        }
        (values[self.half_count] / tau + self.panels[panel].sum(tau)) * sine_of_turns(tau, nearest)
    }

    /// The values at `tau = k + 1/2`, between neighbouring nodes `k` and `k + 1`, of all panels: `(1/pi) sum_j (-1)^m v_j / (1/2 - m)`, `m = j - k`.
    fn halfway(&self) -> Vec<f64> {
        let count = 2 * self.half_count + 1;
        let weight = |index: usize| {
            let m = index as f64 - (count - 1) as f64;
            let sign = if (count - 1 + index).is_multiple_of(2) { 1.0 } else { -1.0 };
            sign / (PI * (0.5 - m))
        };
        // For every `m`, from `1 - count` to `count - 1`.
        let weights: Vec<f64> = (0..2 * count - 1).map(weight).collect();
        let mut found = Vec::with_capacity(self.panels.len() * (count - 1));
        vectorised(
            #[inline(always)]
            || {
                for values in self.values.chunks_exact(count) {
                    for k in 0..count - 1 {
                        found.push(dot(&weights[count - 1 - k..][..count], values));
                    }
                }
            },
        );
        found
    }
}

impl Pairs {
    fn new(bubble: &[f64]) -> Self {
        let middle = bubble.len() / 2;
        let (mut sums, mut differences) = (Vec::with_capacity(middle), Vec::with_capacity(middle));
        let mut sign = -1.0;
        for j in 1..=middle {
            let (right, left) = (bubble[middle + j], bubble[middle - j]);
            sums.push(sign * (right + left));
            differences.push(sign * (right - left) * j as f64);
            sign = -sign;
        }
        Self { sums, differences }
    }

    fn sum(&self, tau: f64) -> f64 {
        vectorised(
            #[inline(always)]
            || self.sum_of_lanes(tau),
        )
    }

    #[inline(always)]
    fn sum_of_lanes(&self, tau: f64) -> f64 {
        let mut totals = [0.0; LANES];
        let mut index: [f64; LANES] = std::array::from_fn(|lane| (lane + 1) as f64);
        let (sums, rest_of_sums) = self.sums.as_chunks::<LANES>();
        let (differences, rest) = self.differences.as_chunks::<LANES>();
        for (s, d) in sums.iter().zip(differences) {
            for lane in 0..LANES {
                // As a product: next to a node the difference of squares would lose what the sine has.
                let denominator = (tau - index[lane]) * (tau + index[lane]);
                totals[lane] += (s[lane] * tau + d[lane]) / denominator;
                index[lane] += LANES as f64;
            }
        }
        let mut total: f64 = totals.iter().sum();
        for ((s, d), j) in rest_of_sums.iter().zip(rest).zip(index) {
            total += (s * tau + d) / ((tau - j) * (tau + j));
        }
        total
    }
}
