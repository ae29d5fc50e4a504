//! What collocation of a kernel needs, whatever the parameter and the right-hand side.

use std::sync::Arc;

use super::assembly::{Block, TIP, blocks, settled};
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
    /// Exponent of the singularity of the kernel.
    exponent: f64,
    /// Within this distance from the left end potentials have its value.
    settled: f64,
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
        let (exponent, settled) = (kernel.singularity().exponent(), settled(kernel, &mesh));
        let (interval, mesh) = (kernel.interval(), Arc::new(mesh));
        Ok(Self { interval, mesh, masses, blocks, exponent, settled })
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
        self.fill_corners(&mut potential, &boundaries, density, 0.0);
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
        self.finish_like((f, parameter.abs()), parameter, f, scaled)
    }

    /// The same where the density has its kinks with a function that is given at the nodes, and its potential is multiplied by so much relative to that.
    pub(super) fn finish_like(
        &self,
        (given, strength): (&[f64], f64),
        parameter: f64,
        f: &[f64],
        scaled: &[Vec<f64>],
    ) -> SincSolution {
        let mut potential = vec![0.0; self.count()];
        let mut boundaries = vec![0.0; self.mesh.boundaries().len()];
        for (block, z) in self.blocks.iter().zip(scaled) {
            block.extend(&block.potential(z), &mut potential);
            block.add_boundary_potential(z, &mut boundaries);
        }
        self.fill_corners(&mut potential, &boundaries, given, strength);
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

    /// Nodes in a corner have the potential of that end of their panel, and so have those about the centre of a disk where it is settled; beside a kink it is straight.
    fn fill_corners(
        &self,
        potential: &mut [f64],
        boundaries: &[f64],
        given: &[f64],
        strength: f64,
    ) {
        let none = estimate::ROUNDING * largest(given);
        for (i, place) in self.mesh.places().enumerate() {
            // At a tip or a step the function that is given changes, and potentials with it.
            let is_settled = place.panel == 0
                && place.from_left < self.settled.min(place.from_right)
                && (given[i] - given[0]).abs() <= none;
            if is_settled || self.is_corner(self.masses[i], place) {
                let at_left = place.from_left < place.from_right;
                let end = self.mesh.left_end(place.panel) + usize::from(!at_left);
                potential[i] = boundaries[end];
            }
        }
        if self.exponent > 0.0 {
            for panel in 1..self.mesh.panels() {
                let at_end = boundaries[self.mesh.left_end(panel)];
                self.straighten(panel, potential, at_end, (given, none, strength));
            }
        }
    }

    /// Makes a potential straight on both sides of where a panel begins that touches the one before, as far as it is: the nodes there are too far from each other to resolve a kernel that is nearly as singular as `1/d`.
    ///
    /// Where the slope of a density bends by `b`, the potential leaves a straight line by `b d^(2-q)/((1-q)(2-q))`; where the function that is given is not straight itself, as at a tip, by more.
    fn straighten(
        &self,
        panel: usize,
        potential: &mut [f64],
        at_end: f64,
        (given, none, strength): (&[f64], f64, f64),
    ) {
        let Some(sides) = Sides::new(&self.mesh, panel) else { return };
        let measured = sides.beyond(MEASURED * sides.length);
        let slopes = [0, 1].map(|side| sides.slope(given, side, measured[side]));
        let off = none / sides.distance(0, measured[0]).min(sides.distance(1, measured[1]));
        let bend = (slopes[0] + slopes[1]).abs() + 2.0 * off;
        let q = self.exponent;
        let strength = strength.max(sides.length.powf(q - 1.0));
        let unchanged = UNCHANGED * largest(given) * (1.0 - q) * (2.0 - q);
        let reach = (unchanged / (strength * bend)).powf(1.0 / (2.0 - q));
        let last = sides.beyond(reach.min(SMOOTH * sides.length));
        let jump = given[sides.node(0, 0)] - given[sides.node(1, 0)];
        let is_straight = |side: usize| {
            let (deepest, slope) =
                (given[sides.node(side, 0)], sides.slope(given, side, last[side]));
            (0..last[side]).all(|k| {
                let line = deepest + slope * sides.distance(side, k);
                (given[sides.node(side, k)] - line).abs() <= none
            })
        };
        if jump.abs() > none || !is_straight(0) || !is_straight(1) {
            return;
        }
        for side in [0, 1] {
            let last = last[side];
            let slope = (potential[sides.node(side, last)] - at_end) / sides.distance(side, last);
            for k in 0..last {
                potential[sides.node(side, k)] = at_end + slope * sides.distance(side, k);
            }
        }
    }

    /// Whether a node is so deep in a corner that its mass vanishes, or that nothing changes any more.
    pub(super) fn is_corner(&self, mass: f64, place: Place) -> bool {
        mass == 0.0 || (place.panel == 0 && place.from_left < TIP * self.settled)
    }
}

/// A change of potentials, relative to them, that is rounding.
const UNCHANGED: f64 = 1e-16;
/// Share of the shorter of two panels within which what is smooth on both goes straight but for rounding: its curvature counts by the square.
const SMOOTH: f64 = 1e-8;
/// The same at which slopes are measured.
const MEASURED: f64 = 1e-9;

/// The nodes of two panels that touch, counted on both from there.
struct Sides<'m> {
    mesh: &'m Mesh,
    /// The panel on the right.
    panel: usize,
    /// Length of the shorter one.
    length: f64,
}

impl<'m> Sides<'m> {
    /// The panel with the one before it, if they touch.
    fn new(mesh: &'m Mesh, panel: usize) -> Option<Self> {
        let length = |panel: usize| {
            let place = mesh.place(panel * mesh.panel_count());
            place.from_left + place.from_right
        };
        let touch = mesh.left_end(panel) == mesh.left_end(panel.checked_sub(1)?) + 1;
        touch.then(|| Self { mesh, panel, length: length(panel - 1).min(length(panel)) })
    }

    fn node(&self, side: usize, k: usize) -> usize {
        let first = self.panel * self.mesh.panel_count();
        if side == 0 { first - 1 - k } else { first + k }
    }

    fn distance(&self, side: usize, k: usize) -> f64 {
        let place = self.mesh.place(self.node(side, k));
        if side == 0 { place.from_right } else { place.from_left }
    }

    /// The first node on either side that is not nearer than that, which is less than half a panel.
    fn beyond(&self, distance: f64) -> [usize; 2] {
        let middle = self.mesh.panel_count() / 2;
        [0, 1]
            .map(|side| (0..middle).find(|k| self.distance(side, *k) >= distance).unwrap_or(middle))
    }

    /// The slope outwards from the deepest node of a side to another; 0 for itself.
    fn slope(&self, values: &[f64], side: usize, k: usize) -> f64 {
        let rise = values[self.node(side, k)] - values[self.node(side, 0)];
        rise / self.distance(side, k)
    }
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
