//! The behaviour of a kernel at `x = s`.

/// The function `sigma(d)` of the distance `d = |x - s|` that carries the singularity of a kernel.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Singularity {
    /// `sigma(d) = ln d`.
    Logarithm,
    /// `sigma(d) = (d^-q - 1)/q`, and its limit `-ln d` at `q = 0`: a family without a gap between powers of either sign and the
    /// logarithm.
    Power {
        /// `q`, between -1 and 1: a power that is infinite for `q > 0`, one that only bends for `q < 0`.
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
            Self::Power { exponent: 0.0 } => -distance.ln(),
            Self::Power { exponent } => (-exponent * distance.ln()).exp_m1() / exponent,
            Self::None => 0.0,
        }
    }

    /// The exponent `q` for which `|x - s|^-q` has the strength of the singularity: 0 for the logarithm, -1 where there is none.
    #[must_use]
    pub fn exponent(self) -> f64 {
        match self {
            Self::Logarithm => 0.0,
            Self::Power { exponent } => exponent,
            Self::None => -1.0,
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

/// A kernel at two points `x != s`: what collocation asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// `K(x, s)`.
    pub value: f64,
    /// `A(x, s)`, the factor of the singular function in the [`Split`].
    pub factor: f64,
}
