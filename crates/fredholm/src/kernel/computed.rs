//! Eigenpairs computed where no spectral relation is known.

use super::{
    EndExponents, Expansion, Gram, Kernel, Moments, Parity, SpectralRelation, forward_kernel,
};
use crate::collocation::{Eigenpairs, Place};
use crate::linear::dot;
use crate::{Error, SincOperator};

/// Default of the largest defect of the pairs, relative to the largest eigenvalue.
const TOLERANCE: f64 = 1e-12;
/// Eigenvalues below this share of the largest are rounding.
const NEGLIGIBLE: f64 = 100.0 * f64::EPSILON;
/// Most eigenpairs.
const MOST: usize = 1000;
/// Growth of the number of nodes.
const RATIO: f64 = std::f64::consts::SQRT_2;
/// Most nodes on either side of the middle of the grid that checks the pairs.
const LARGEST_HALF_COUNT: usize = 1200;
/// An expansion that is this close between the nodes, relative to the largest value, resolves the function.
const RESOLVED: f64 = 1e-12;
/// Points at which an expansion is compared with its function.
const CHECKS: usize = 257;

/// Any kernel on a finite interval with the eigenpairs of its operator in `L2(dm)`, computed by sinc collocation: the weight is 1 and the eigenfunctions are
/// orthonormal,
///
/// `int_L K(x, s) phi_n(s) dm(s) = nu_n phi_n(x)`, `int_L phi_k phi_m dm = delta_km`, `|nu_0| >= |nu_1| >= ...`,
///
/// so that the degenerate system (1.9) is diagonal, `(1 + lambda nu_k) X_k = f_k`. Eigenvalues may have either sign; each `phi_n` has the sign that makes its value at the right end
/// not negative.
///
/// Between the nodes `phi_n = (K phi_n)/nu_n` with the sinc interpolation of `K phi_n`, at any point of the closed interval. The pairs are checked on a grid of `sqrt 2` times as many nodes:
/// [`defect`](Self::defect) is the largest `||(K - K_N) phi_n||` there over `|nu_0|`, with the degenerate kernel `K_N = sum nu_n phi_n(x) phi_n(s)`, and the number of nodes grows until it
/// meets the tolerance. So `K_N` is as good as the defect says; `phi_n` alone has an error of about `2e-16 |nu_0/nu_n|` at a point.
///
/// The kernel `2 + cos(x - s)` on `(-pi, pi)` has three eigenpairs:
///
/// ```
/// use std::f64::consts::PI;
/// use fredholm::kernel::{ComputedRelation, Kernel, Singularity, SpectralRelation, Split};
/// use fredholm::{DegenerateSystem, Error, Interval};
///
/// struct Wave;
///
/// impl Kernel for Wave {
///     fn interval(&self) -> Interval {
///         Interval::symmetric(PI).unwrap()
///     }
///     fn singularity(&self) -> Singularity {
///         Singularity::None
///     }
///     fn split(&self, _x: f64, _s: f64, distance: f64) -> Split {
///         Split { factor: 0.0, rest: 2.0 + distance.cos() }
///     }
/// }
///
/// let relation = ComputedRelation::new(Wave, 3)?;
/// for (n, exact) in [4.0 * PI, PI, PI].into_iter().enumerate() {
///     assert!((relation.eigenvalue(n) - exact).abs() < 1e-13);
/// }
/// assert!(matches!(ComputedRelation::new(Wave, 4), Err(Error::TooFew { available: 3, .. })));
///
/// // phi + (1/pi) K phi = 5 + 2 cos x: phi = 1 + cos x.
/// let f = |x: f64| 5.0 + 2.0 * x.cos();
/// let system = DegenerateSystem::new(&relation, 1.0 / PI, 2)?;
/// let phi = system.solve(&relation.moments(&f, 3)?.values);
/// assert!((phi.evaluate(0.7, f(0.7)) - 1.0 - 0.7f64.cos()).abs() < 1e-13);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct ComputedRelation<K> {
    kernel: K,
    pairs: Eigenpairs,
    defect: f64,
    check: Check,
}

/// The eigenfunctions on the grid that checked them.
#[derive(Debug, Clone)]
struct Check {
    positions: Vec<f64>,
    /// `m_j phi_n(x_j)`, a row for each pair.
    masses: Vec<f64>,
}

impl<K: Kernel> ComputedRelation<K> {
    /// The `count` eigenpairs of largest magnitude, with a defect of at most `1e-12`.
    ///
    /// # Errors
    /// [`Error::TooFew`] when fewer than `count` eigenvalues exceed `2e-14` of the largest: those below are rounding;
    /// [`Error::InvalidParameter`] unless `1 <= count <= 1000`, and on an infinite interval; [`Error::NotConverged`] when 2401 nodes do not resolve the pairs;
    /// [`Error::NotFinite`], [`Error::TooLarge`] and [`Error::EigenvaluesNotFound`] as collocation.
    pub fn new(kernel: K, count: usize) -> Result<Self, Error> {
        Self::with_tolerance(kernel, count, TOLERANCE)
    }

    /// As [`new`](Self::new), with another largest defect.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::InvalidParameter`] for a tolerance below `1e-14`.
    pub fn with_tolerance(kernel: K, count: usize, tolerance: f64) -> Result<Self, Error> {
        let found = Self::compute(kernel, count, tolerance)?;
        if found.available() < count {
            return Err(Error::TooFew { needed: count, available: found.available() });
        }
        Ok(found)
    }

    /// The eigenpairs of largest magnitude, at most `most` and as many as exceed `2e-14` of the largest: [`available`](SpectralRelation::available) tells how many. A smooth kernel has few, and
    /// with all of them the degenerate kernel is the kernel to rounding.
    ///
    /// # Errors
    /// As [`new`](Self::new); [`Error::TooFew`] for the kernel 0 only.
    pub fn up_to(kernel: K, most: usize) -> Result<Self, Error> {
        let found = Self::compute(kernel, most, TOLERANCE)?;
        if found.available() == 0 {
            return Err(Error::TooFew { needed: 1, available: 0 });
        }
        Ok(found)
    }

    fn compute(kernel: K, count: usize, tolerance: f64) -> Result<Self, Error> {
        if !(1..=MOST).contains(&count) {
            return Err(Error::InvalidParameter {
                name: "count",
                value: count as f64,
                requirement: "between 1 and 1000",
            });
        }
        if !(tolerance >= 1e-14 && tolerance.is_finite()) {
            return Err(Error::InvalidParameter {
                name: "tolerance",
                value: tolerance,
                requirement: "finite and at least 1e-14: below is rounding",
            });
        }
        let mut half_counts = half_counts(count);
        let mut operator =
            SincOperator::new(&kernel, half_counts.next().unwrap_or(LARGEST_HALF_COUNT))?;
        let (mut iterations, mut residual) = (0, f64::INFINITY);
        for half_count in half_counts {
            let pairs = Eigenpairs::new(&operator, count, NEGLIGIBLE)?;
            let finer = SincOperator::new(&kernel, half_count)?;
            let mut rows = pairs.on_nodes_of(&finer);
            residual = pairs.defect(&rows, &finer);
            iterations += 1;
            if residual <= tolerance {
                for row in rows.chunks_exact_mut(finer.count()) {
                    row.iter_mut().zip(finer.node_masses()).for_each(|(phi, mass)| *phi *= mass);
                }
                let check = Check { positions: finer.positions().collect(), masses: rows };
                return Ok(Self { kernel, pairs, defect: residual, check });
            }
            operator = finer;
        }
        Err(Error::NotConverged { iterations, residual, tolerance })
    }

    /// The kernel.
    #[must_use]
    pub fn kernel(&self) -> &K {
        &self.kernel
    }

    /// The largest `||(K - K_N) phi_n||` on a finer grid, relative to the largest eigenvalue: an estimate.
    #[must_use]
    pub fn defect(&self) -> f64 {
        self.defect
    }

    /// Number of nodes from which the pairs were computed.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.pairs.nodes()
    }

    /// The moments with all eigenfunctions, and the largest difference from those on the finer grid, each weighted with `|nu_n/nu_0|` as in the solution, relative to the largest value of `f`.
    fn quadrature(&self, f: &dyn Fn(f64) -> f64) -> Result<(Vec<f64>, f64, f64), Error> {
        let values: Vec<f64> = (self.pairs.places())
            .map(|Place { position, .. }| finite(f, position))
            .collect::<Result<_, _>>()?;
        let checks: Vec<f64> =
            self.check.positions.iter().map(|&x| finite(f, x)).collect::<Result<_, _>>()?;
        let largest = values.iter().chain(&checks).fold(0.0, |most: f64, v| most.max(v.abs()));
        let moments = self.pairs.moments(&values);
        let finer = self.check.masses.chunks_exact(checks.len()).map(|row| dot(row, &checks));
        let eigenvalues = self.pairs.eigenvalues();
        let difference = (moments.iter().zip(finer).zip(eigenvalues))
            .map(|((coarse, fine), nu)| (nu / eigenvalues[0]).abs() * (coarse - fine).abs())
            .fold(0.0, f64::max);
        let error = if largest > 0.0 { difference / largest } else { 0.0 };
        Ok((moments, error, largest))
    }
}

/// Numbers of nodes on either side of the middle. An eigenfunction with `n` oscillations wants about `3 n`; but a smooth kernel has fewer eigenfunctions than may be asked for.
fn half_counts(count: usize) -> impl Iterator<Item = usize> {
    let start = 24.0 + 3.0 * count.min(16) as f64;
    (0..)
        .map(move |power| (start * RATIO.powi(power)).round() as usize)
        .take_while(|half_count| *half_count <= LARGEST_HALF_COUNT)
}

fn finite(f: &dyn Fn(f64) -> f64, x: f64) -> Result<f64, Error> {
    let value = f(x);
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { what: "function", at: x, value })
    }
}

impl<K: Kernel> Kernel for ComputedRelation<K> {
    forward_kernel!(self => self.kernel);
}

impl<K: Kernel> SpectralRelation for ComputedRelation<K> {
    fn available(&self) -> usize {
        self.pairs.count()
    }

    fn weight_exponents(&self) -> EndExponents {
        EndExponents { left: 0.0, right: 0.0 }
    }

    fn weight_rest(&self, _n: usize, _x: f64) -> f64 {
        1.0
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        self.pairs.eigenvalues().get(n).copied().unwrap_or(f64::NAN)
    }

    fn norm(&self, n: usize) -> f64 {
        if n < self.available() { 1.0 } else { f64::NAN }
    }

    fn parity(&self) -> Parity {
        if self.pairs.is_alternating() && self.interval().centre() == 0.0 {
            Parity::Alternating
        } else {
            Parity::None
        }
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        values.fill(f64::NAN);
        self.pairs.evaluate(x, values);
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        if coefficients.len() > self.available() {
            return f64::NAN;
        }
        self.pairs.sum(coefficients, x)
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        if count > self.available() {
            return Err(Error::TooFew { needed: count, available: self.available() });
        }
        Ok(Gram::Identity)
    }

    /// All coefficients; the error is that of their sum at 257 points. Only functions that the kernel produces have expansions that converge fast to the ends; the degenerate kernel needs no more
    /// than the [`moments`](SpectralRelation::moments).
    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        let (coefficients, _, largest) = self.quadrature(f)?;
        let interval = self.interval();
        let mut worst = 0.0f64;
        for i in 0..CHECKS {
            let share = 2.0 * i as f64 / (CHECKS - 1) as f64 - 1.0;
            let x = (interval.centre() + share * interval.half_length())
                .clamp(interval.left(), interval.right());
            worst = worst.max((finite(f, x)? - self.sum(&coefficients, x)).abs());
        }
        let error = if largest > 0.0 { worst / largest } else { 0.0 };
        Ok(Expansion { coefficients, error, resolved: error <= RESOLVED })
    }

    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        if count > self.available() {
            return Err(Error::TooFew { needed: count, available: self.available() });
        }
        let (mut values, error, _) = self.quadrature(f)?;
        values.truncate(count);
        Ok(Moments { values, error, resolved: error <= RESOLVED })
    }

    fn mass(&self, n: usize) -> f64 {
        self.pairs.integral(n, |x| self.kernel.mass_function(x))
    }
}
