//! Eigenvalues and norms of a kernel, and their verification.

use fredholm::conformance::{Verification, verify};
use fredholm::kernel::SpectralRelation;
use serde::Serialize;

use super::NamedKernel;
use crate::Error;
use crate::error::require;

/// Version of the layout of a [`Spectrum`]; the JSON Schema `schema/spectrum.schema.json` describes it.
pub const SPECTRUM_SCHEMA: &str = "shtaerman-spectrum/1";

/// Most eigenvalues that are listed.
pub(super) const MOST: usize = 10_000;
/// Most eigenfunctions that are verified or computed where they have no formulae.
const MOST_PREPARED: usize = 2000;
/// Eigenfunctions for the bilinear sum, which converges slowly.
const BILINEAR_TERMS: usize = 600;
/// Largest error of a check; of the bilinear sum, whose truncation counts, a thousand times as much.
const LIMIT: f64 = 1e-9;

/// The first eigenvalues of a kernel, `int K phi_n w dm = lambda_n phi_n`, with the norms `h_n = int phi_n^2 w dm` and the factors `lambda_n/h_n` of the bilinear
/// expansion.
#[derive(Serialize)]
pub struct Spectrum<'a> {
    /// [`SPECTRUM_SCHEMA`].
    pub schema: &'static str,
    /// The kernel.
    pub kernel: &'a NamedKernel,
    /// `K(x, s)` as a formula.
    pub formula: &'static str,
    /// The interval as a formula.
    pub interval: &'static str,
    /// The measure `dm`.
    pub measure: &'static str,
    /// The weight `w(x)` as a formula.
    pub weight: &'static str,
    /// `n`.
    pub index: Vec<usize>,
    /// `lambda_n`.
    pub eigenvalue: Vec<f64>,
    /// `h_n`.
    pub norm: Vec<f64>,
    /// `lambda_n/h_n`.
    pub expansion_factor: Vec<f64>,
    /// The checks, where asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verify: Option<SpectrumCheck>,
    #[serde(skip)]
    relation: Box<dyn SpectralRelation>,
}

/// The worst errors of a spectral relation against quadrature that knows nothing of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SpectrumCheck {
    /// Of (1.2), over the largest eigenvalue and the largest value of the eigenfunction.
    pub relation: f64,
    /// Of (1.3) for two different eigenfunctions, over the root of their norms.
    pub orthogonality: f64,
    /// Of the norms, relative.
    pub norms: f64,
    /// Of the Gram matrix `int phi_k phi_m dm`, over the root of its diagonal entries.
    pub gram: f64,
    /// Of the bilinear sum (1.5) at points far from the diagonal, over the largest of the values.
    pub bilinear_sum: f64,
    /// Terms of that sum.
    pub terms: usize,
    /// Whether every error is within its limit.
    pub passes: bool,
}

/// One check with its limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CheckReport {
    /// What was checked.
    pub name: &'static str,
    /// The worst error.
    pub error: f64,
    /// The largest that passes.
    pub limit: f64,
}

impl CheckReport {
    /// Whether the error is within its limit; NaN is not.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.error <= self.limit
    }
}

impl SpectrumCheck {
    fn new(found: &Verification) -> Self {
        let mut check = Self {
            relation: found.relation,
            orthogonality: found.orthogonality,
            norms: found.norms,
            gram: found.gram,
            bilinear_sum: found.bilinear_sum,
            terms: found.terms,
            passes: false,
        };
        check.passes = check.reports().iter().all(CheckReport::passes);
        check
    }

    /// The checks with their limits.
    #[must_use]
    pub fn reports(&self) -> [CheckReport; 5] {
        let report = |name, error, limit| CheckReport { name, error, limit };
        [
            report("relation", self.relation, LIMIT),
            report("orthogonality", self.orthogonality, LIMIT),
            report("norms", self.norms, LIMIT),
            report("gram", self.gram, LIMIT),
            report("bilinear_sum", self.bilinear_sum, 1e3 * LIMIT),
        ]
    }
}

impl std::fmt::Debug for Spectrum<'_> {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter
            .debug_struct("Spectrum")
            .field("kernel", &self.kernel)
            .field("eigenvalue", &self.eigenvalue)
            .finish_non_exhaustive()
    }
}

impl<'a> Spectrum<'a> {
    /// The first `count` eigenvalues; `verified` checks them, their norms and their functions by quadrature.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for no eigenvalues or more than 10000 (2000 where they are verified or the eigenfunctions have no formulae); those of the
    /// relation; [`Error::EquationOverflow`] should a value leave the range of double precision.
    pub fn new(kernel: &'a NamedKernel, count: usize, verified: bool) -> Result<Self, Error> {
        let is_prepared = kernel.operator().is_prepared;
        if verified || is_prepared {
            let sensible = (1..=MOST_PREPARED).contains(&count);
            let requirement = if is_prepared {
                "from 1 to 2000: the eigenfunctions of this kernel have no formulae"
            } else {
                "from 1 to 2000 with verification"
            };
            require(sensible, "count", count as f64, requirement)?;
        }
        require((1..=MOST).contains(&count), "count", count as f64, "from 1 to 10000")?;
        let needed = if verified { count.max(BILINEAR_TERMS) } else { count };
        let relation = kernel.relation(needed)?;
        let list = |value: &dyn Fn(usize) -> f64, quantity: &'static str| {
            let values: Vec<f64> = (0..count).map(value).collect();
            match values.iter().copied().find(|value| !value.is_finite()) {
                Some(value) => Err(Error::EquationOverflow { quantity, value }),
                None => Ok(values),
            }
        };
        let eigenvalue = list(&|n| relation.eigenvalue(n), "eigenvalue")?;
        let norm = list(&|n| relation.norm(n), "norm")?;
        let expansion_factor = list(&|n| relation.expansion_factor(n), "expansion factor")?;
        let verify =
            if verified { Some(SpectrumCheck::new(&verify(&*relation, count)?)) } else { None };
        let family = kernel.family();
        Ok(Self {
            schema: SPECTRUM_SCHEMA,
            kernel,
            formula: family.formula,
            interval: family.interval,
            measure: family.measure,
            weight: family.weight,
            index: (0..count).collect(),
            eigenvalue,
            norm,
            expansion_factor,
            verify,
            relation,
        })
    }

    /// `phi_0(x), phi_1(x), ...`, so many.
    #[must_use]
    pub fn eigenfunctions(&self, x: f64, count: usize) -> Vec<f64> {
        let mut values = vec![0.0; count.min(self.index.len())];
        self.relation.eigenfunctions(x, &mut values);
        values
    }

    /// The finite part of the interval that is shown.
    #[must_use]
    pub fn extent(&self) -> [f64; 2] {
        let extent = self.relation.extent();
        [extent.left(), extent.right()]
    }
}
