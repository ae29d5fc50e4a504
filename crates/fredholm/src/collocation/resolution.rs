//! Whether the nodes see a function: what it does between them.
//!
//! A solution of collocation knows its right-hand side at the nodes only, and a feature that lies between the nodes of *every* grid changes no difference of two
//! solutions. So the function is asked for its values at [`places`](crate::quadrature::places) that have nothing to do with any grid. Where all of these are values of polynomials, a few of them
//! on each panel and one between any two nodes tell what sinc interpolation makes of the function; elsewhere all are compared with it. What
//! is left, `delta`, the collocation has solved without: the solution lacks about `lambda K delta`.
//!
//! Nor can a function be asked for its values closer to an end than numbers lie: there nodes are moved by rounding, and what the function changes by between neighbouring numbers is unknown
//! ([`between_numbers`]). Where it leaves an end as `d^(1-mu)` and the kernel is `d^-mu`, that is some `eps^(2-2mu)` of the end value.

use super::grid::AT_ONCE;
use super::mesh::Mesh;
use super::solution::Bubble;
use crate::Error;
use crate::kernel::Kernel;
use crate::quadrature::places::{Sampled, dominant};

/// Changes of a function below this share of its largest value are rounding of the function itself.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// So many numbers from a breakpoint a function is looked at again, for its limit there: the value at the breakpoint itself may be that of the other side. What is left of a change as `d^k` is
/// covered for `k >= 0.05`, `4096^0.05 - 1 = 0.52` against `k/(k + k) = 1/2` of the kernel `d^(k-1)`.
const TOWARDS_LIMIT: f64 = 4096.0;

/// What a solution may lack at the ends of the panels because numbers have gaps there.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Unknown {
    /// The largest `int |K delta| dm`, `delta` what the function changes by between neighbouring numbers.
    pub(super) potential: f64,
    /// The largest `|delta|`.
    pub(super) largest: f64,
    /// The largest `int |K| dm` over what lies beyond the outermost nodes.
    pub(super) tail: f64,
}

/// What the values of a function at the nodes leave unknown at the ends of the panels; `largest` is its largest value.
pub(super) fn between_numbers(
    mesh: &Mesh,
    kernel: &dyn Kernel,
    f: &dyn Fn(f64) -> f64,
    largest: f64,
) -> Unknown {
    let boundaries = mesh.boundaries();
    let is_end = |x: f64| x == boundaries[0] || x == boundaries[boundaries.len() - 1];
    let smoothness = (1.0 - kernel.singularity().exponent()).min(1.0);
    let mut found = Unknown::default();
    // The panels on both sides of a breakpoint add up.
    let mut sums = vec![[0.0f64; 2]; boundaries.len()];
    for (index, place) in mesh.places().enumerate() {
        let end = mesh.left_end(place.panel);
        let [left, right] = [boundaries[end], boundaries[end + 1]];
        let (side, boundary, distance) = if place.from_left < place.from_right {
            (1.0, left, place.from_left)
        } else {
            (-1.0, right, place.from_right)
        };
        let mass = mesh.weights()[index] * kernel.measure(place.position);
        let value = f(place.position);
        let first = if side > 0.0 { left.next_up() } else { right.next_down() };
        let neighbours = if place.position == first && !is_end(boundary) {
            [boundary + TOWARDS_LIMIT * (first - boundary); 2]
        } else {
            [place.position.next_down(), place.position.next_up()]
        };
        let inside = neighbours.into_iter().filter(|x| {
            (left < *x || is_end(left) && *x == left)
                && (*x < right || is_end(right) && *x == right)
        });
        let change = inside.map(|x| (f(x) - value).abs()).fold(0.0, f64::max);
        let is_outermost = index % mesh.panel_count() == 0 || (index + 1) % mesh.panel_count() == 0;
        let changes = change > ROUNDING * largest;
        if mass == 0.0 || !(changes || is_outermost) {
            continue;
        }
        let of_kernel = kernel.pair(boundary, place.position, distance).value.abs();
        if !of_kernel.is_finite() {
            continue;
        }
        let sum = &mut sums[if side > 0.0 { end } else { end + 1 }];
        if changes {
            found.largest = found.largest.max(change);
            sum[0] += change * mass * of_kernel;
        }
        if is_outermost {
            sum[1] += of_kernel * kernel.measure(place.position) * distance / smoothness;
        }
    }
    // Where the function changes no more than by rounding grids tell what lies beyond their nodes.
    for [potential, tail] in sums.into_iter().filter(|[potential, _]| *potential > 0.0) {
        found.potential = found.potential.max(potential);
        found.tail = found.tail.max(tail);
    }
    found
}

/// A function less its sinc interpolation, at the places of a sample and between the nodes.
pub(super) struct Misfit<'m> {
    mesh: &'m Mesh,
    sampled: Sampled,
    differences: Vec<f64>,
}

/// What a solution may lack for a misfit.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Missed {
    /// The largest `|K delta|`, and the largest `|delta|`.
    pub(super) potential: f64,
    pub(super) largest: f64,
    /// `|int u delta dm|` with the mass function.
    pub(super) integral: f64,
    /// `|int (x - c) delta dx|`.
    pub(super) first_moment: f64,
}

impl<'m> Misfit<'m> {
    /// # Errors
    /// [`Error::NotFinite`] where the function is not finite at a node or between two.
    pub(super) fn new(
        mesh: &'m Mesh,
        f: &dyn Fn(f64) -> f64,
        sampled: &Sampled,
    ) -> Result<Self, Error> {
        let interpolant = Interpolant::new(mesh, f)?;
        let between = mesh.midway().map(|x| Ok((x, finite(f, x)?)));
        let mut pairs: Vec<(f64, f64)> = between.collect::<Result<_, Error>>()?;
        pairs.extend(sampled.places.iter().copied().zip(sampled.values.iter().copied()));
        let sampled = sampled.moved(pairs);
        let mut differences = interpolant.evaluate(&sampled.places);
        for (difference, value) in differences.iter_mut().zip(&sampled.values) {
            *difference = value - *difference;
        }
        Ok(Self { mesh, sampled, differences })
    }

    /// `int |delta| dx`.
    pub(super) fn mean(&self) -> f64 {
        let differences = self.differences.iter().enumerate();
        differences.map(|(index, delta)| delta.abs() * self.sampled.cell(index)).sum()
    }

    /// What solutions lack.
    pub(super) fn missed(&self, kernel: &dyn Kernel) -> Missed {
        let Some(density) = dominant(&self.differences, self.sampled.largest) else {
            return Missed::default();
        };
        let boundaries = self.mesh.boundaries();
        let (left, right) = (boundaries[0], boundaries[boundaries.len() - 1]);
        let centre = left.midpoint(right);
        let potential = self.sampled.potential(kernel, &density, &[left, right]);
        let integral = |u: &dyn Fn(f64) -> f64| self.sampled.integral(kernel, &density, u).abs();
        Missed {
            potential,
            largest: density.iter().fold(0.0, |most, (_, delta)| most.max(delta.abs())),
            integral: integral(&|x| kernel.mass_function(x)),
            first_moment: integral(&|x| x - centre),
        }
    }
}

/// A function through its values at the nodes: on each panel the straight line through the values at the outermost nodes, and sinc functions of `t` for the rest.
struct Interpolant<'m> {
    mesh: &'m Mesh,
    /// Values at the ends of each panel.
    ends: Vec<[f64; 2]>,
    bubble: Bubble,
}

impl<'m> Interpolant<'m> {
    fn new(mesh: &'m Mesh, f: &dyn Fn(f64) -> f64) -> Result<Self, Error> {
        let mut values: Vec<f64> =
            mesh.places().map(|place| finite(f, place.position)).collect::<Result<_, _>>()?;
        let count = mesh.panel_count();
        let ends: Vec<[f64; 2]> =
            values.chunks_exact(count).map(|values| [values[0], values[count - 1]]).collect();
        for (value, place) in values.iter_mut().zip(mesh.places()) {
            *value -= line(ends[place.panel], place.from_left, place.from_right);
        }
        Ok(Self { mesh, ends, bubble: Bubble::new(mesh.grid(), values) })
    }

    fn evaluate(&self, points: &[f64]) -> Vec<f64> {
        let mut values = Vec::with_capacity(points.len());
        for points in points.chunks(AT_ONCE) {
            let places = self.mesh.locate_all(points);
            let steps = self.mesh.grid().steps(&places);
            for ((_, place), tau) in points.iter().zip(places).zip(steps) {
                let line = line(self.ends[place.panel], place.from_left, place.from_right);
                let is_end = place.from_left <= 0.0 || place.from_right <= 0.0;
                values.push(if is_end { line } else { line + self.bubble.at(place.panel, tau) });
            }
        }
        values
    }
}

fn finite(f: &dyn Fn(f64) -> f64, x: f64) -> Result<f64, Error> {
    let value = f(x);
    let what = "right-hand side";
    if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { what, at: x, value }) }
}

fn line(ends: [f64; 2], from_left: f64, from_right: f64) -> f64 {
    (ends[0] * from_right + ends[1] * from_left) / (from_left + from_right)
}
