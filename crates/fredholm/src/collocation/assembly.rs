//! The scaled symmetric matrix of a kernel on a mesh, split by parity where that is possible.

use super::entries::{Entries, Scratch, with_mass};
use super::mesh::Mesh;
use crate::kernel::Kernel;
use crate::linear::{dot, multiply_rows, sum, vectorised};
use crate::{Error, memory};

/// Rows and columns of a square of a matrix that is copied at once.
const SQUARE: usize = 16;

/// The functions a block acts on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// All.
    Whole,
    /// `f(2c - x) = f(x)`, by its values at the nodes from the middle to the right.
    Even,
    /// `f(2c - x) = -f(x)`, by its values at the nodes right of the middle.
    Odd,
}

/// One symmetric problem: `(1 + lambda S) z = rho f`, `phi = f - lambda S z / rho`.
#[derive(Debug, Clone)]
pub(super) struct Block {
    pub(super) part: Part,
    /// First node of the block; the others follow to the right.
    first: usize,
    /// `rho`: square roots of the weights, the middle node of an even block having half the weight.
    pub(super) roots: Vec<f64>,
    /// `S`, all entries.
    pub(super) matrix: Vec<f64>,
    /// For each boundary of the panels the row that gives the share of `K phi` there from the scaled solution `z`.
    boundary_rows: Vec<Vec<f64>>,
}

impl Block {
    pub(super) fn order(&self) -> usize {
        self.roots.len()
    }

    /// A row of `S`, which is a column as well.
    pub(super) fn row(&self, i: usize) -> &[f64] {
        &self.matrix[i * self.order()..(i + 1) * self.order()]
    }

    /// The entries of a column from the diagonal on.
    pub(super) fn column(&self, j: usize, column: &mut [f64]) {
        column.copy_from_slice(&self.row(j)[j..]);
    }

    /// Values at the nodes of the block of the part of `f` it acts on; `f` is given at all nodes.
    pub(super) fn restrict(&self, f: &[f64]) -> Vec<f64> {
        let right = &f[self.first..];
        let mirrored = f.iter().rev().skip(self.first);
        match self.part {
            Part::Whole => f.to_vec(),
            Part::Even => right.iter().zip(mirrored).map(|(f, g)| 0.5 * (f + g)).collect(),
            Part::Odd => right.iter().zip(mirrored).map(|(f, g)| 0.5 * (f - g)).collect(),
        }
    }

    /// Adds the part of a function given at the nodes of the block to its values at all nodes.
    pub(super) fn extend(&self, part: &[f64], values: &mut [f64]) {
        let sign = match self.part {
            Part::Whole => return values.iter_mut().zip(part).for_each(|(v, p)| *v += p),
            Part::Even => 1.0,
            Part::Odd => -1.0,
        };
        let last = values.len() - 1;
        for (i, value) in (self.first..).zip(part) {
            values[i] += value;
            if i != last - i {
                values[last - i] += sign * value;
            }
        }
    }

    /// `rho f` for the part of `f`.
    pub(super) fn scaled(&self, f: &[f64]) -> Vec<f64> {
        let mut part = self.restrict(f);
        part.iter_mut().zip(&self.roots).for_each(|(f, root)| *f *= root);
        part
    }

    /// `phi = z / rho` at the nodes of the block; 0 where the weight vanishes.
    pub(super) fn unscaled(&self, z: &[f64]) -> Vec<f64> {
        let value = |(z, root): (&f64, &f64)| if *root > 0.0 { z / root } else { 0.0 };
        z.iter().zip(&self.roots).map(value).collect()
    }

    /// `(K phi)` at the nodes of the block from the scaled solution `z = rho phi`; NaN where the weight vanishes.
    pub(super) fn potential(&self, z: &[f64]) -> Vec<f64> {
        let mut potential = multiply_rows(&self.matrix, z);
        potential.iter_mut().zip(&self.roots).for_each(|(u, root)| *u /= root);
        potential
    }

    /// The share of `K phi` at the boundaries of the panels from the scaled solution `z`.
    pub(super) fn add_boundary_potential(&self, z: &[f64], boundaries: &mut [f64]) {
        for (potential, row) in boundaries.iter_mut().zip(&self.boundary_rows) {
            *potential += dot(row, z);
        }
    }

    /// The rows of the left and the right end of the interval.
    pub(super) fn end_rows(&self) -> [&[f64]; 2] {
        match (self.boundary_rows.first(), self.boundary_rows.last()) {
            (Some(left), Some(right)) => [left, right],
            _ => [&[], &[]],
        }
    }

    /// Turns a row that acts on values at all nodes into one that acts on the scaled solution.
    fn boundary_row(&self, row: &[f64]) -> Vec<f64> {
        let mut part = self.restrict(row);
        let count = self.multiplicity();
        let scale = |root: f64| if root > 0.0 { count / root } else { 0.0 };
        part.iter_mut().zip(&self.roots).for_each(|(value, root)| *value *= scale(*root));
        if self.part == Part::Even && row.len() % 2 == 1 {
            // The middle node is its own image: it counts once.
            part[0] *= 0.5;
        }
        part
    }

    /// The largest over the nodes `x_i` of `sum_j |m_j K_ij phi_j| (1 + r_ij/d_ij)`, from the scaled density `z = rho phi`: times the unit of the last place what rounding of the
    /// entries changes `K phi` by. The distance `d_ij` of two nodes of a panel is a difference of their distances from its end, of which `r_ij` is the smaller one, and `d K'(d)` is
    /// about as large as `K(d)`. The entries are taken with what stands in them beside the kernel, which may be much larger and cancel in the sum.
    pub(super) fn rounded_potential(&self, z: &[f64], mesh: &Mesh) -> f64 {
        // One of the two parts of an even or odd density.
        if z.iter().all(|z| *z == 0.0) {
            return 0.0;
        }
        let mut relative = vec![0.0; self.order()];
        let mut largest = 0.0f64;
        for (i, row) in self.matrix.chunks_exact(self.order()).enumerate() {
            let index = self.first + i;
            mesh.cancellations(index, self.first..self.first + self.order(), &mut relative);
            let sum = vectorised(
                #[inline(always)]
                || {
                    for ((relative, entry), z) in relative.iter_mut().zip(row).zip(z) {
                        *relative = (entry * z).abs() * (1.0 + *relative);
                    }
                    sum(&relative)
                },
            );
            if self.roots[i] > 0.0 {
                largest = largest.max(sum / self.roots[i]);
            }
        }
        largest
    }

    /// How many times the sum over the block makes the sum over all nodes.
    pub(super) fn multiplicity(&self) -> f64 {
        if self.part == Part::Whole { 1.0 } else { 2.0 }
    }
}

/// The blocks of a kernel on a mesh; `masses` are the weights of the nodes times the density of the measure. Nodes without mass have empty rows and columns: there the kernel may overflow.
pub(super) fn blocks(
    kernel: &dyn Kernel,
    mesh: &Mesh,
    masses: &[f64],
) -> Result<Vec<Block>, Error> {
    let entries = Entries::new(kernel, mesh, masses);
    let mut blocks = if kernel.is_even() && mesh.is_symmetric() {
        let half = mesh.count() / 2 + 1;
        memory::admit(half, 2.0 * with_factor(half))?;
        entries.by_parity()
    } else {
        memory::admit(mesh.count(), with_factor(mesh.count()))?;
        vec![entries.whole()]
    };
    for block in &blocks {
        require_finite(block, mesh)?;
    }
    let rows = boundary_rows(kernel, mesh, masses);
    for block in &mut blocks {
        block.boundary_rows =
            rows.chunks_exact(mesh.count()).map(|row| block.boundary_row(row)).collect();
    }
    Ok(blocks)
}

/// Bytes of a matrix and its factor.
fn with_factor(order: usize) -> f64 {
    16.0 * (order as f64).powi(2)
}

fn require_finite(block: &Block, mesh: &Mesh) -> Result<(), Error> {
    // One sum tells; the culprit is looked for only when there is one.
    if sum(&block.matrix).is_finite() {
        return Ok(());
    }
    let culprit = block.matrix.iter().position(|entry| !entry.is_finite());
    match culprit {
        Some(place) => Err(Error::NotFinite {
            what: "kernel",
            at: mesh.positions()[block.first + place % block.order()],
            value: block.matrix[place],
        }),
        None => Ok(()),
    }
}

impl Entries<'_> {
    fn whole(&self) -> Block {
        let roots: Vec<f64> = self.masses.iter().map(|mass| mass.sqrt()).collect();
        let order = roots.len();
        let mut matrix = vec![0.0; order * order];
        let mut scratch = Scratch::new(order);
        for i in 0..order {
            let row = &mut matrix[i * order..=i * order + i];
            self.row(i, 0..i, row, &mut scratch);
            row[i] = self.diagonal(i);
            vectorised(
                #[inline(always)]
                || scale(row, &roots, roots[i]),
            );
        }
        mirror(&mut matrix, order);
        Block { part: Part::Whole, first: 0, roots, matrix, boundary_rows: Vec::new() }
    }

    /// The even and the odd block: `S_ij +- S_ij'` with the mirror image `j'` of `j`.
    fn by_parity(&self) -> Vec<Block> {
        let count = self.mesh.count();
        let middle = count / 2;
        let has_middle = !count.is_multiple_of(2);
        let mut roots: Vec<f64> = self.masses[middle..].iter().map(|mass| mass.sqrt()).collect();
        if has_middle {
            roots[0] *= std::f64::consts::FRAC_1_SQRT_2;
        }
        let skipped = usize::from(has_middle);
        let (even_order, odd_order) = (roots.len(), roots.len() - skipped);
        let mut even = vec![0.0; even_order * even_order];
        let mut odd = vec![0.0; odd_order * odd_order];
        let (mut same, mut images) = (vec![0.0; even_order], vec![0.0; even_order]);
        let mut scratch = Scratch::new(even_order);
        for a in 0..even_order {
            let i = middle + a;
            let images = &mut images[..=a];
            self.row(i, middle..i, &mut same, &mut scratch);
            same[a] = self.diagonal(i);
            // The images of nodes `middle .. i` are `i' .. middle'` from left to right.
            if has_middle && a == 0 {
                images[0] = same[0];
            } else {
                self.row(i, count - 1 - i..count - middle, images, &mut scratch);
            }
            let (same, images) = (&same[..=a], &*images);
            let even = &mut even[a * even_order..=a * even_order + a];
            let odd = (a >= skipped).then(|| {
                let start = (a - skipped) * odd_order;
                &mut odd[start..=start + a - skipped]
            });
            vectorised(
                #[inline(always)]
                || {
                    for k in 0..=a {
                        even[k] = same[k] + images[a - k];
                    }
                    scale(even, &roots, roots[a]);
                    let Some(odd) = odd else { return };
                    for k in skipped..=a {
                        odd[k - skipped] = same[k] - images[a - k];
                    }
                    scale(odd, &roots[skipped..], roots[a]);
                },
            );
        }
        mirror(&mut even, even_order);
        mirror(&mut odd, odd_order);
        let odd_roots = roots[skipped..].to_vec();
        let block = |part, first, roots, matrix| Block {
            part,
            first,
            roots,
            matrix,
            boundary_rows: Vec::new(),
        };
        vec![
            block(Part::Even, middle, roots, even),
            block(Part::Odd, middle + skipped, odd_roots, odd),
        ]
    }
}

/// Multiplies by the roots of the weights of the columns and of the row.
#[inline(always)]
fn scale(row: &mut [f64], roots: &[f64], root: f64) {
    row.iter_mut().zip(roots).for_each(|(entry, column)| *entry = (root * *entry) * column);
}

/// Copies the lower triangle to the upper one, square by square: a column of a large matrix is spread over all its memory.
fn mirror(matrix: &mut [f64], order: usize) {
    for rows in (0..order).step_by(SQUARE) {
        for columns in (0..=rows).step_by(SQUARE) {
            for i in rows..order.min(rows + SQUARE) {
                for j in columns..i.min(columns + SQUARE) {
                    matrix[j * order + i] = matrix[i * order + j];
                }
            }
        }
    }
}

/// Share of the distance within which potentials are settled, to which they change still where the function has a tip: about `x^p` they leave the centre as `x^(1-q+p)`. Much deeper the nodes that the rim asks
/// for on strongly graded ground are too far from each other to resolve the kernel (survey of 36 tips and 100 disks: right to 1e-13 but for `p <= 0.2`; twenty powers of ten deeper flat disks are not).
pub(super) const TIP: f64 = 1e-26;

/// The distance from the left end within which potentials are settled: that of the kernel where the panels begin at the centre of a disk, less where the first one is short: potentials change over its length then.
pub(super) fn settled(kernel: &dyn Kernel, mesh: &Mesh) -> f64 {
    match mesh.boundaries() {
        [0.0, first, ..] => kernel.settled() * (first / kernel.interval().right()).min(1.0),
        _ => 0.0,
    }
}

/// Adds to the row of a boundary what its sum leaves out on both sides: with a kernel that is nearly as singular as `1/d` there is much before the first node that has a mass, and where potentials are settled. The density
/// does not change there, and masses times the kernel go as `g = w d^-q`, at the centre of a disk of order 0, too: all is added to that node.
///
/// Before the first node of all, at `d_0`, there is `d_0^(1-q)/(1-q)`, less the half of its `g_0` and the further end corrections of a sum with equal steps, by J. Gregory: `D g_0/12 - D^2 g_0/24`.
fn add_left_out(
    kernel: &dyn Kernel,
    mesh: &Mesh,
    masses: &[f64],
    boundary: usize,
    row: &mut [f64],
) {
    let q = kernel.singularity().exponent();
    let settled = if boundary == 0 { TIP * settled(kernel, mesh) } else { 0.0 };
    let count = mesh.panel_count();
    for panel in 0..mesh.panels() {
        let first = panel * count;
        let left = mesh.left_end(panel);
        let node = |k: usize| if boundary == left { first + k } else { first + count - 1 - k };
        if boundary != left && boundary != left + 1 {
            continue;
        }
        let distance = |k: usize| mesh.distance_to_boundary(boundary, node(k));
        let is_counted = |k: &usize| masses[node(*k)] > 0.0 && distance(*k) >= settled;
        let Some(counted) = (0..count).find(is_counted) else { continue };
        let part = |k: usize| mesh.weights()[node(k)] * distance(k).powf(-q);
        let [g, next, after] = [part(0), part(1), part(2)];
        let end = distance(0).powf(1.0 - q) / (1.0 - q) - 0.5 * g + (next - g) / 12.0
            - (after - 2.0 * next + g) / 24.0;
        let share = ((0..counted).map(part).sum::<f64>() + end) / part(counted);
        if share.is_finite() {
            (0..counted).for_each(|k| row[node(k)] = 0.0);
            row[node(counted)] *= 1.0 + share;
        }
    }
}

/// `m_j K(x_b, x_j)` for every boundary `x_b` of the panels: a row for each.
pub(super) fn boundary_rows(kernel: &dyn Kernel, mesh: &Mesh, masses: &[f64]) -> Vec<f64> {
    let boundaries = mesh.boundaries().len();
    let is_even = kernel.is_even() && mesh.is_symmetric();
    let half = if is_even { boundaries.div_ceil(2) } else { boundaries };
    let mut rows = vec![0.0; half * mesh.count()];
    let Some(inside) = with_mass(masses, 0..mesh.count()) else { return rows };
    let mut distances = vec![0.0; inside.len()];
    let mut room = distances.clone();
    for (boundary, row) in rows.chunks_exact_mut(mesh.count()).enumerate() {
        let x = mesh.boundaries()[boundary];
        for (distance, j) in distances.iter_mut().zip(inside.clone()) {
            *distance = mesh.distance_to_boundary(boundary, j);
        }
        let row = &mut row[inside.clone()];
        kernel.values(x, &mesh.positions()[inside.clone()], &distances, row, &mut room);
        for (entry, mass) in row.iter_mut().zip(&masses[inside.clone()]) {
            *entry = if *mass > 0.0 { mass * *entry } else { 0.0 };
        }
    }
    if kernel.singularity().exponent() > 0.0 {
        for (boundary, row) in rows.chunks_exact_mut(mesh.count()).enumerate() {
            add_left_out(kernel, mesh, masses, boundary, row);
        }
    }
    if is_even {
        let mirrored: Vec<f64> =
            rows[..boundaries / 2 * mesh.count()].iter().rev().copied().collect();
        rows.extend(mirrored);
    }
    rows
}
