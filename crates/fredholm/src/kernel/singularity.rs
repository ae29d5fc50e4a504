//! The behaviour of a kernel at `x = s`.

/// The function `sigma(d)` of the distance `d = |x - s|` that carries the singularity of a kernel.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Singularity {
    /// `sigma(d) = ln d`.
    Logarithm,
    /// `sigma(d) = d^-mu`.
    Power {
        /// `mu`, between 0 and 1.
        exponent: f64,
    },
    /// None: the kernel is smooth, `sigma = 0`.
    None,
}

impl Singularity {
    /// `sigma(d)`.
    #[must_use]
    pub fn value(self, distance: f64) -> f64 {
        match self {
            Self::Logarithm => distance.ln(),
            Self::Power { exponent } => distance.powf(-exponent),
            Self::None => 0.0,
        }
    }
}

/// The two smooth functions of the split `K = A sigma(|x - s|) + B`, at one pair `(x, s)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Split {
    /// `A(x, s)`, the factor of the singular function.
    pub factor: f64,
    /// `B(x, s)`, the smooth rest.
    pub rest: f64,
}

impl Split {
    /// `A sigma(d) + B`.
    #[must_use]
    pub fn value(self, singularity: Singularity, distance: f64) -> f64 {
        match singularity {
            Singularity::None => self.rest,
            Singularity::Logarithm | Singularity::Power { .. } => {
                self.factor * singularity.value(distance) + self.rest
            }
        }
    }
}
