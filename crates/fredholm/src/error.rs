//! What can go wrong, with the values that made it so.

/// Failure of a method or a parameter outside its range.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A parameter lies outside the range in which the formula holds.
    #[error("{name} = {} is out of range: it must be {requirement}", plain(*value))]
    InvalidParameter {
        /// Name of the parameter.
        name: &'static str,
        /// The value given.
        value: f64,
        /// What would be right.
        requirement: &'static str,
    },

    /// A function was asked for a value and gave NaN or an infinity.
    #[error("the {what} is {value} at x = {}: it must be finite on the whole interval", plain(*at))]
    NotFinite {
        /// Which function.
        what: &'static str,
        /// Where.
        at: f64,
        /// What it gave.
        value: f64,
    },

    /// A spectral relation has an eigenvalue that is not positive, so the symmetric positive form does not exist.
    #[error(
        "eigenvalue {index} of the kernel is {eigenvalue}: the symmetric positive form needs positive eigenvalues"
    )]
    NotPositive {
        /// Index of the eigenvalue.
        index: usize,
        /// Its value.
        eigenvalue: f64,
    },

    /// A Cholesky factorisation met a pivot that is not positive.
    #[error("the matrix of order {order} is not positive definite: pivot {pivot} is not positive")]
    NotPositiveDefinite {
        /// Order of the matrix.
        order: usize,
        /// Index of the pivot.
        pivot: usize,
    },

    /// The operator `1 + parameter K` is singular to rounding: the parameter is `-1/nu` for an eigenvalue `nu` of `K`.
    #[error(
        "1 + {} K has the eigenvalue {smallest:.1e}, zero to the rounding of its largest one: the equation has no unique solution", plain(*parameter)
    )]
    Singular {
        /// The parameter.
        parameter: f64,
        /// Estimate of the eigenvalue of smallest magnitude.
        smallest: f64,
    },

    /// An eigenvalue of the kernel is zero, so that the equation of the first kind has no unique solution.
    #[error(
        "eigenvalue {index} of the kernel is {eigenvalue:e}: the equation of the first kind has no unique solution"
    )]
    ZeroEigenvalue {
        /// Index of the eigenvalue.
        index: usize,
        /// Its value.
        eigenvalue: f64,
    },

    /// The parameter makes `-1/parameter` a point of the continuous spectrum of `K` on the half-line, or lies beyond it.
    #[error(
        "the parameter {} must be greater than -1/{top} = {}: the operator on the half-line has the continuous spectrum [0, {top}], and the equation has no bounded inverse there", plain(*parameter), plain(-1.0 / top)
    )]
    InSpectrum {
        /// The parameter.
        parameter: f64,
        /// Upper end of the spectrum.
        top: f64,
    },

    /// A list of values has the wrong length.
    #[error("the {what} has {found} values where {expected} are needed")]
    WrongLength {
        /// Which list.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The right length.
        expected: usize,
    },

    /// More eigenfunctions are asked for than were computed.
    #[error("{needed} eigenfunctions are needed, and this kernel was prepared for {available}")]
    TooFew {
        /// How many are needed.
        needed: usize,
        /// How many there are.
        available: usize,
    },

    /// A matrix library gave up.
    #[error("the eigenvalues of a matrix of order {order} were not found")]
    EigenvaluesNotFound {
        /// Order of the matrix.
        order: usize,
    },

    /// The system does not fit into memory.
    #[error(
        "a system of degree {degree} needs {} of memory, and {} can be had",
        crate::memory::display(*.needed), crate::memory::display(*.available)
    )]
    TooLarge {
        /// Highest degree asked for.
        degree: usize,
        /// Bytes needed.
        needed: u64,
        /// Bytes that can be had.
        available: u64,
    },

    /// A method would need more of something than it has room for: the equation is sound.
    #[error("the {what} comes out as {}, and the method takes {limit}", plain(*value))]
    BeyondMethod {
        /// What there would be more of.
        what: &'static str,
        /// How much.
        value: f64,
        /// How much the method takes, and what would need less.
        limit: &'static str,
    },

    /// The structured solve needs a Gram matrix that is the sum of a Toeplitz and a Hankel matrix.
    #[error(
        "the Gram matrix of this kernel is not the sum of a Toeplitz and a Hankel matrix: use the dense system"
    )]
    Unstructured,

    /// An iteration stopped short of its tolerance.
    #[error("not converged after {iterations} iterations{}", missed(*residual, *tolerance))]
    NotConverged {
        /// Iterations done.
        iterations: usize,
        /// Relative residual reached, recomputed from the solution.
        residual: f64,
        /// Relative residual asked for.
        tolerance: f64,
    },
}

/// A number as short as it can be read back: with an exponent where digits would only count zeros.
fn plain(value: f64) -> String {
    if value == 0.0 || !value.is_finite() || (1e-7..1e16).contains(&value.abs()) {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// How far an iteration was from its tolerance, if it came anywhere.
fn missed(residual: f64, tolerance: f64) -> String {
    if residual.is_finite() {
        format!(": the relative residual is {residual:e} and should be at most {tolerance:e}")
    } else {
        ": nothing came near a solution".to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_many_digits_are_told_with_an_exponent() {
        let singular = Error::Singular { parameter: -1e-170, smallest: 0.0 }.to_string();
        assert!(singular.starts_with("1 + -1e-170 K has the eigenvalue"), "{singular}");
        let large = Error::InvalidParameter { name: "h", value: 1e300, requirement: "at most 1e6" };
        assert_eq!(large.to_string(), "h = 1e300 is out of range: it must be at most 1e6");
        assert_eq!([plain(0.005), plain(-2.0), plain(f64::NAN)], ["0.005", "-2", "NaN"]);
    }
}
