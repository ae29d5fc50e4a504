//! What collocation of a kernel needs, whatever the parameter and the right-hand side.

use std::sync::Arc;

use super::assembly::{Block, TIP, blocks};
use super::estimate::{self, largest};
use super::mesh::Mesh;
use super::{Place, SincGrid, SincSolution};
use crate::kernel::Kernel;
use crate::{Error, Interval};

/// A kernel collocated on given nodes: built once, it serves every parameter and every right-hand side.
///
/// Cost, with `N` nodes: `N^2/2` values of the kernel and `8 N^2` bytes; half the bytes if the kernel is
/// [even](Kernel::is_even) and the breakpoints are symmetric.
///
/// ```
/// use fredholm::SincOperator;
/// use fredholm::kernel::Logarithm;
///
/// // |x| has a kink: a breakpoint there keeps all digits.
/// let operator = SincOperator::with_breaks(&Logarithm::unit(), 40, &[0.0])?;
/// let solution = &operator.solve(1.0, &[operator.sample(f64::abs)?])?[0];
/// let exact = 0.438_447_599_162_530_12; // mpmath, 40 digits
/// assert!((solution.integral(|_| 1.0) - exact).abs() < 1e-14);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct SincOperator {
    interval: Interval,
    mesh: Arc<Mesh>,
    /// Weights of the nodes in the measure of the kernel.
    masses: Vec<f64>,
    blocks: Vec<Block>,
    /// Within this distance from the left end potentials have its value.
    settled: f64,
    /// The same as a share of a panel, from where it meets another one.
    settled_beside: f64,
}

impl SincOperator {
    /// The operator with `2 half_count + 1` nodes, in the range that suits the kernel.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `4 <= half_count <= 4000`, [`Error::NotFinite`] when the kernel is not finite
    /// between two nodes, [`Error::TooLarge`] beyond memory.
    pub fn new(kernel: &dyn Kernel, half_count: usize) -> Result<Self, Error> {
        Self::with_breaks(kernel, half_count, &[])
    }

    /// The operator with `2 half_count + 1` nodes on each of the panels into which the breakpoints, in any order, cut
    /// the interval.
    ///
    /// # Errors
    /// As [`SincOperator::new`]; [`Error::InvalidParameter`] for a breakpoint that is not inside the interval and apart
    /// from the others, and for more than 8001 nodes altogether.
    pub fn with_breaks(
        kernel: &dyn Kernel,
        half_count: usize,
        breaks: &[f64],
    ) -> Result<Self, Error> {
        Self::on_grid(kernel, Arc::new(SincGrid::new(kernel, half_count)?), breaks)
    }

    /// The operator on the nodes of a shared grid.
    ///
    /// # Errors
    /// As [`SincOperator::with_breaks`].
    pub fn on_grid(
        kernel: &dyn Kernel,
        grid: Arc<SincGrid>,
        breaks: &[f64],
    ) -> Result<Self, Error> {
        let mesh = Mesh::new(grid, kernel.interval(), breaks)?;
        Self::on_mesh(kernel, mesh)
    }

    /// The operator on a union of panels `(left, right)` inside the interval of the kernel, from left to right, with or without
    /// gaps between them: `K phi = sum_k int_(l_k)^(r_k) K(x, s) phi(s) dm(s)`. Each panel has the nodes of the shared grid.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use fredholm::collocation::SincGrid;
    /// use fredholm::kernel::Logarithm;
    /// use fredholm::SincOperator;
    ///
    /// let kernel = Logarithm::unit();
    /// let grid = Arc::new(SincGrid::new(&kernel, 40)?);
    /// let operator = SincOperator::on_panels(&kernel, grid, &[(-1.0, -0.5), (0.25, 1.0)])?;
    /// let length = operator.solve(0.0, &[operator.sample(|_| 1.0)?])?[0].integral(|_| 1.0);
    /// assert!((length - 1.25).abs() < 1e-14);
    /// # Ok::<(), fredholm::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`SincOperator::with_breaks`]; [`Error::InvalidParameter`] for panels that overlap, are empty, are not in order or leave the
    /// interval, [`Error::WrongLength`] for no panel.
    pub fn on_panels(
        kernel: &dyn Kernel,
        grid: Arc<SincGrid>,
        panels: &[(f64, f64)],
    ) -> Result<Self, Error> {
        let mesh = Mesh::on_panels(grid, kernel.interval(), panels)?;
        Self::on_mesh(kernel, mesh)
    }

    pub(super) fn on_mesh(kernel: &dyn Kernel, mesh: Mesh) -> Result<Self, Error> {
        let masses = masses(kernel, &mesh)?;
        let blocks = blocks(kernel, &mesh, &masses)?;
        Ok(Self {
            interval: kernel.interval(),
            mesh: Arc::new(mesh),
            masses,
            blocks,
            settled: kernel.settled(),
            settled_beside: settled_beside(kernel.singularity().exponent()),
        })
    }

    /// `K phi` at the nodes for a density `phi` given at the nodes; zero on a panel leaves that panel out of the integral.
    ///
    /// Less accurate next to the ends of the panels than [`SincSolution::potential`], by `eps phi/sqrt(w)` with the weights `w` of the nodes.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless there is one value for each node, [`Error::NotFinite`] for NaN or an infinity.
    pub fn apply(&self, density: &[f64]) -> Result<Vec<f64>, Error> {
        self.require_values(density)?;
        let mut potential = vec![0.0; self.count()];
        let mut boundaries = vec![0.0; self.mesh.boundaries().len()];
        for block in &self.blocks {
            let z = block.scaled(density);
            block.extend(&block.potential(&z), &mut potential);
            block.add_boundary_potential(&z, &mut boundaries);
        }
        self.fill_corners(&mut potential, &boundaries, density);
        Ok(potential)
    }

    /// The interval of the kernel.
    #[must_use]
    pub fn interval(&self) -> Interval {
        self.interval
    }

    /// Number of nodes on all panels.
    #[must_use]
    pub fn count(&self) -> usize {
        self.mesh.count()
    }

    /// The nodes, from left to right; each lies strictly inside its panel.
    pub fn positions(&self) -> impl Iterator<Item = f64> + '_ {
        self.mesh.places().map(|place| place.position)
    }

    /// The nodes with their distances to the ends of their panels.
    pub fn places(&self) -> impl ExactSizeIterator<Item = Place> + '_ {
        self.mesh.places()
    }

    /// The values of a function at the nodes.
    ///
    /// # Errors
    /// [`Error::NotFinite`] with the place when a value is NaN or infinite.
    pub fn sample(&self, f: impl Fn(f64) -> f64) -> Result<Vec<f64>, Error> {
        self.sample_places(|place| f(place.position))
    }

    /// The values at the nodes of a function that wants more than the position: the panel where it jumps, or the
    /// distance to an end in all its digits.
    ///
    /// # Errors
    /// [`Error::NotFinite`] with the place when a value is NaN or infinite.
    pub fn sample_places(&self, f: impl Fn(Place) -> f64) -> Result<Vec<f64>, Error> {
        let values: Vec<f64> = self.places().map(f).collect();
        self.require_finite(&values)?;
        Ok(values)
    }

    /// Solves `phi + parameter K phi = f` for several right-hand sides, each given by its values at
    /// [`positions`](Self::positions).
    ///
    /// # Errors
    /// As [`SincOperator::factor`] and [`SincFactor::solve`](super::SincFactor::solve).
    pub fn solve(
        &self,
        parameter: f64,
        right_hand_sides: &[Vec<f64>],
    ) -> Result<Vec<SincSolution>, Error> {
        let factor = self.factor(parameter)?;
        right_hand_sides.iter().map(|f| factor.solve(f)).collect()
    }

    /// Rounding that a solution on these nodes carries, in `phi`: that of `f - lambda K phi`, and that of the entries of `K`. An estimate: of 480 random equations on all kernels with
    /// smooth, narrow and kinked right-hand sides the solutions on two numbers of nodes differed by at most 0.6 of what is stated with it. `N^2` multiplications.
    ///
    /// # Errors
    /// [`Error::WrongLength`] unless the solution has a value for each node.
    pub fn rounding(&self, solution: &SincSolution) -> Result<f64, Error> {
        self.require_values(solution.values())?;
        let entries: f64 = (self.blocks.iter())
            .map(|block| block.rounded_potential(&block.scaled(solution.values()), &self.mesh))
            .sum();
        Ok(estimate::ROUNDING * (largest(solution.values()) + solution.parameter().abs() * entries))
    }

    /// `int |u| dm`.
    pub(super) fn integral_of_size(&self, u: impl Fn(f64) -> f64) -> f64 {
        let terms = self.mesh.positions().iter().zip(&self.masses);
        terms.map(|(x, mass)| u(*x).abs() * mass).sum()
    }

    /// Weights of the nodes in the measure of the kernel.
    pub(crate) fn node_masses(&self) -> &[f64] {
        &self.masses
    }

    pub(super) fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    pub(super) fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Refuses a list of the wrong length or with values that are not finite.
    pub(super) fn require_values(&self, values: &[f64]) -> Result<(), Error> {
        if values.len() != self.count() {
            return Err(Error::WrongLength {
                what: "right-hand side",
                found: values.len(),
                expected: self.count(),
            });
        }
        self.require_finite(values)
    }

    fn require_finite(&self, values: &[f64]) -> Result<(), Error> {
        match values.iter().position(|value| !value.is_finite()) {
            Some(index) => Err(Error::NotFinite {
                what: "right-hand side",
                at: self.mesh.positions()[index],
                value: values[index],
            }),
            None => Ok(()),
        }
    }

    /// The solution `phi = f - parameter (K phi)` from the scaled solutions `z` of the blocks.
    pub(super) fn finish(&self, parameter: f64, f: &[f64], scaled: &[Vec<f64>]) -> SincSolution {
        let mut potential = vec![0.0; self.count()];
        let mut boundaries = vec![0.0; self.mesh.boundaries().len()];
        for (block, z) in self.blocks.iter().zip(scaled) {
            block.extend(&block.potential(z), &mut potential);
            block.add_boundary_potential(z, &mut boundaries);
        }
        self.fill_corners(&mut potential, &boundaries, f);
        // Division of z by the tiny weights near the ends would lose digits.
        let values: Vec<f64> = f.iter().zip(&potential).map(|(f, u)| f - parameter * u).collect();
        let masses = self.masses(scaled);
        SincSolution::new(Arc::clone(&self.mesh), parameter, values, masses, potential, boundaries)
    }

    /// `w_j phi_j` from the scaled solutions, for integrals: `f - parameter (K phi)` is a small difference where the parameter is large, `z` is not.
    pub(super) fn masses(&self, scaled: &[Vec<f64>]) -> Vec<f64> {
        let mut masses = vec![0.0; self.count()];
        for (block, z) in self.blocks.iter().zip(scaled) {
            block.extend(&block.unscaled(z), &mut masses);
        }
        masses.iter_mut().zip(&self.masses).for_each(|(mass, weight)| *mass *= weight);
        masses
    }

    /// Nodes in a corner have the potential of that end of their panel, and so have those where it is settled.
    fn fill_corners(&self, potential: &mut [f64], boundaries: &[f64], given: &[f64]) {
        let none = f64::EPSILON * largest(given);
        for (i, place) in self.mesh.places().enumerate() {
            if self.is_settled(i, place, given, none) || self.is_corner(self.masses[i], place) {
                let at_left = place.from_left < place.from_right;
                let end = self.mesh.left_end(place.panel) + usize::from(!at_left);
                potential[i] = boundaries[end];
            }
        }
    }

    /// Whether a node is so near to the centre, or to where panels meet, that potentials do not change there, if the function that is given changes by no more than `none`. It does at a tip or a step.
    fn is_settled(&self, i: usize, place: Place, given: &[f64], none: f64) -> bool {
        let count = self.mesh.panel_count();
        let at_left = place.from_left < place.from_right;
        let first = (place.panel + usize::from(!at_left)) * count;
        let is_inside = 0 < first && first < given.len() && {
            let panel = first / count;
            self.mesh.left_end(panel) == self.mesh.left_end(panel - 1) + 1
        };
        let (reach, deepest) = match is_inside {
            true => {
                let length = place.from_left + place.from_right;
                (self.settled_beside * length, [given[first - 1], given[first]])
            }
            false if first == 0 => (self.settled, [given[0]; 2]),
            false => return false,
        };
        let is_near = place.from_left.min(place.from_right) < reach;
        is_near && deepest.iter().all(|value| (given[i] - value).abs() <= none)
    }

    /// Whether a node is so deep in a corner that its mass vanishes, or that nothing changes any more.
    pub(super) fn is_corner(&self, mass: f64, place: Place) -> bool {
        mass == 0.0 || (place.panel == 0 && place.from_left < TIP * self.settled)
    }
}

/// A change of potentials, relative to them, that is rounding.
const UNCHANGED: f64 = 1e-16;

/// Within what share of a panel from where it meets the next potentials have their value there but for [`UNCHANGED`]: beside a kink they leave it as `d^(2-q)`. Nearer nodes on two panels are too far from each other to
/// resolve a kernel that is nearly as singular as `1/d`; one as the logarithm, or less singular, needs no such thing.
fn settled_beside(q: f64) -> f64 {
    if q > 0.0 { UNCHANGED.powf(1.0 / (2.0 - q)) } else { 0.0 }
}

/// Masses below this share of the largest count as zero: so deep in a corner a kernel may overflow.
const VANISHING: f64 = 1e-280;

/// `h x'(t_j) m(x_j)`.
pub(super) fn masses(kernel: &dyn Kernel, mesh: &Mesh) -> Result<Vec<f64>, Error> {
    let mass = |(weight, place): (&f64, Place)| {
        let density = kernel.measure(place.position);
        if density.is_finite() && density >= 0.0 {
            return Ok(weight * density);
        }
        Err(Error::NotFinite { what: "measure", at: place.position, value: density })
    };
    let mut masses: Vec<f64> =
        mesh.weights().iter().zip(mesh.places()).map(mass).collect::<Result<_, _>>()?;
    let largest = masses.iter().fold(0.0f64, |most, mass| most.max(*mass));
    masses.iter_mut().filter(|mass| **mass < VANISHING * largest).for_each(|mass| *mass = 0.0);
    Ok(masses)
}

pub(super) fn require_finite_parameter(parameter: f64) -> Result<(), Error> {
    if parameter.is_finite() {
        Ok(())
    } else {
        Err(Error::InvalidParameter { name: "parameter", value: parameter, requirement: "finite" })
    }
}
