//! What every kernel must pass: a suite that a kernel of one's own runs too.
//!
//! [`check_kernel`] proves value, split and symmetry; [`verify`] proves the spectral relation by quadrature that knows nothing of it; [`check_methods`] lets both methods solve
//! and compares their difference with the errors they report. [`run`] does all of it.
//!
//! ```
//! use fredholm::conformance;
//! use fredholm::kernel::Logarithm;
//!
//! let kernel = Logarithm::new(0.7)?;
//! let report = conformance::run(&kernel, &kernel, 50)?;
//! assert!(report.passes(), "{report}");
//! # Ok::<(), fredholm::Error>(())
//! ```

mod bilinear;
mod methods;
mod report;
mod value;
mod verification;

pub use methods::{Comparison, check_methods, compare};
pub use report::{Check, Report};
pub use value::check_kernel;
pub use verification::{Verification, verify};

use crate::Error;
use crate::kernel::{Kernel, SpectralRelation};

/// Largest error of a check of the relation, unless a kernel states why double precision cannot do better.
pub const LIMIT: f64 = 1e-12;

/// The whole suite: the kernel, its relation for `phi_0 .. phi_{count-1}`, both methods. `kernel` and `relation` may be one value.
///
/// # Errors
/// Whatever a method meets; a check that fails is no error but shows in the [`Report`].
pub fn run(
    kernel: &dyn Kernel,
    relation: &dyn SpectralRelation,
    count: usize,
) -> Result<Report, Error> {
    run_with(kernel, relation, count, LIMIT)
}

/// The same with another limit for the checks of the relation, where double precision cannot do better: on an interval that is short beside the distance from the origin, say, whose points are known to fewer digits.
///
/// # Errors
/// As [`run`].
pub fn run_with(
    kernel: &dyn Kernel,
    relation: &dyn SpectralRelation,
    count: usize,
    limit: f64,
) -> Result<Report, Error> {
    let mut report = check_kernel(kernel)?;
    report.extend(verify(relation, count)?.report(limit));
    if kernel.interval().is_finite() {
        report.extend(check_methods(kernel, relation)?);
    }
    Ok(report)
}
