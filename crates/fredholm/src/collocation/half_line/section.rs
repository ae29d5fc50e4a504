//! The equation collocated on a finite section of the half-line.

use super::map::Map;
use crate::collocation::weights::SincWeights;
use crate::kernel::MacdonaldProfile;
use crate::linear::{Skyline, SkylineFactor};
use crate::quadrature::gauss_jacobi;
use crate::{Error, memory};

/// Distance, in decay lengths, from which on the kernel counts as zero: it is below 1e-19 of its size there.
const REACH: f64 = 44.0;
/// Length over which the section ends, in decay lengths: a sharp end would ring far into the section.
const TAPER: f64 = 18.0;
/// Sharpness of the taper.
const SHARPNESS: f64 = 5.0;
/// `e^-700` is the smallest distance to 0 in use, and this is `ln 700`.
const FARTHEST: f64 = 6.55;
/// What the corner below the first node may leave out: `ln 1e18`.
const DECADES: f64 = 41.4;
/// Most nodes of a section.
const MOST_NODES: f64 = 30_000.0;
/// Nodes of the Gauss rule between neighbours.
const BETWEEN: usize = 12;

/// How a section is laid out; lengths in decay lengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Layout {
    /// End of the section.
    pub(super) length: f64,
    /// Step of `t`.
    pub(super) step: f64,
    /// Nodes in a unit of `t` over nodes in a decay length, far from 0.
    pub(super) stretch: f64,
}

impl Layout {
    /// Nodes right of `t = 0`.
    fn right(self) -> f64 {
        (self.length * self.stretch / self.step).ceil()
    }

    /// How many nodes it needs.
    fn nodes(self) -> f64 {
        self.right() + (FARTHEST / self.step).floor()
    }

    /// Whether it does not need too many nodes.
    pub(super) fn fits(self) -> bool {
        self.nodes() <= MOST_NODES
    }
}

/// `phi + lambda int_0^inf K phi chi ds = f` at the nodes, with a taper `chi` that is 1 up to 18 decay lengths before the end of the section
/// and 0 beyond it.
#[derive(Debug)]
pub(super) struct Section {
    pub(super) map: Map,
    pub(super) step: f64,
    /// Nodes left of `t = 0`.
    pub(super) left: usize,
    /// `x_j`.
    pub(super) positions: Vec<f64>,
    /// Square roots of `h x'(t_j) chi(x_j)`.
    roots: Vec<f64>,
    matrix: Skyline,
    /// `K(0, x_j)` times those roots.
    origin: Vec<f64>,
}

/// A solution at the nodes of a section.
#[derive(Debug, Clone)]
pub(super) struct Nodal {
    /// `K phi` at the nodes.
    pub(super) potential: Vec<f64>,
    /// `K phi` at 0.
    pub(super) at_origin: f64,
    /// `m_j phi_j`.
    pub(super) masses: Vec<f64>,
}

impl Section {
    pub(super) fn new(
        kernel: &MacdonaldProfile,
        end_exponent: f64,
        layout: Layout,
    ) -> Result<Self, Error> {
        let Layout { length, step, stretch } = layout;
        let map = Map::new(stretch);
        let left = nodes_to_the_left(end_exponent, step);
        let right = layout.right();
        if !layout.fits() {
            return Err(too_long(layout));
        }
        let (left, count) = (left as usize, (left + right) as usize + 1);
        let band = (REACH * stretch / step + left as f64).min(count as f64);
        memory::admit(count, 32.0 * count as f64 * band)?;
        let images = (0..count).map(|j| map.at((j as f64 - left as f64) * step));
        let (mut positions, mut weights) = (Vec::with_capacity(count), Vec::with_capacity(count));
        let mut roots = Vec::with_capacity(count);
        for image in images {
            positions.push(image.position);
            let weight = step * image.derivative;
            weights.push(weight);
            roots.push((weight * taper(image.position, length)).sqrt());
        }
        let matrix = assemble(kernel, &positions, &weights, &roots);
        let origin = positions.iter().zip(&roots).map(|(&x, root)| root * kernel.pair(x).value);
        let origin = origin.collect();
        Ok(Self { map, step, left, positions, roots, matrix, origin })
    }

    pub(super) fn factor(&self, parameter: f64) -> Result<SkylineFactor, Error> {
        self.matrix.factor_shifted(parameter)
    }

    /// The solution for the values of `f` at the nodes.
    pub(super) fn solve(&self, factor: &SkylineFactor, f: &[f64]) -> Nodal {
        let mut z: Vec<f64> = f.iter().zip(&self.roots).map(|(f, root)| f * root).collect();
        factor.solve(&mut z);
        let mut potential = self.matrix.multiply(&z);
        potential.iter_mut().zip(&self.roots).for_each(|(u, root)| *u /= root);
        let at_origin = self.origin.iter().zip(&z).map(|(k, z)| k * z).sum();
        let masses = z.iter().zip(&self.roots).map(|(z, root)| z * root).collect();
        Nodal { potential, at_origin, masses }
    }

    /// `int f chi dx` for the values of `f` at the nodes.
    pub(super) fn integral(&self, f: &[f64]) -> f64 {
        self.roots.iter().zip(f).map(|(root, f)| root * root * f).sum()
    }

    /// `int_x^inf K(u) du` of the kernel as a function of the distance, at the nodes.
    pub(super) fn tails(&self, kernel: &MacdonaldProfile) -> Result<Vec<f64>, Error> {
        let rule = gauss_jacobi(BETWEEN, 0.0, 0.0)?;
        let mut tails = vec![0.0; self.positions.len()];
        for j in (1..tails.len()).rev() {
            let middle = (j as f64 - 0.5 - self.left as f64) * self.step;
            let cell: f64 = (rule.nodes.iter().zip(&rule.weights))
                .map(|(node, weight)| {
                    let image = self.map.at(middle + 0.5 * self.step * node);
                    weight * image.derivative * kernel.pair(image.position).value
                })
                .sum();
            tails[j - 1] = tails[j] + 0.5 * self.step * cell;
        }
        Ok(tails)
    }
}

/// How many nodes lie left of `t = 0`: the first so close to 0 that a solution has its end value there, but no nearer than the smallest distance in use.
fn nodes_to_the_left(end_exponent: f64, step: f64) -> f64 {
    let wanted = (DECADES / end_exponent).ln();
    (wanted / step).ceil().min((FARTHEST / step).floor())
}

/// The smooth end of a section, 1 to rounding until `TAPER` before it.
pub(super) fn taper(x: f64, length: f64) -> f64 {
    0.5 * libm::erfc(SHARPNESS * (2.0 * (x - length) / TAPER + 1.0))
}

fn assemble(
    kernel: &MacdonaldProfile,
    positions: &[f64],
    weights: &[f64],
    roots: &[f64],
) -> Skyline {
    let mut first = 0;
    let firsts = positions.iter().map(|x| {
        while x - positions[first] > REACH {
            first += 1;
        }
        first
    });
    let mut matrix = Skyline::zeros(firsts.collect());
    let sinc = SincWeights::new(kernel.singularity(), positions.len());
    for i in 0..positions.len() {
        let x = positions[i];
        let (first, row) = matrix.row_mut(i);
        let (below, diagonal) = row.split_at_mut(i - first);
        for (j, entry) in (first..i).zip(below) {
            let distance = x - positions[j];
            let pair = kernel.pair(distance);
            let entire =
                if pair.factor == 0.0 { pair.value } else { sinc.apart(pair, distance, i - j) };
            *entry = (roots[i] * entire) * roots[j];
        }
        diagonal[0] = sinc.at_node(kernel.split(0.0), weights[i]) * roots[i] * roots[i];
    }
    matrix
}

fn too_long(layout: Layout) -> Error {
    Error::BeyondMethod {
        what: "number of nodes on the section of the half-line that matters",
        value: layout.nodes(),
        limit: "at most 30000: places less far from the end, a coarser tolerance, or a parameter farther from the spectrum need fewer",
    }
}
