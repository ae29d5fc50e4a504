//! The values of a solution at the ends of the interval as functionals.

use super::approximation::{Approximation, half_product, norm};
use super::enclosure::Enclosure;
use super::tail::{Tail, peaked_norm};
use crate::kernel::EndMoments;

/// Degree up to which products beyond the explicit modes are summed, over that of the modes.
const REACH: usize = 8;

/// An end of the interval `(-1, 1)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// `x = -1`.
    Left,
    /// `x = 1`.
    Right,
}

impl End {
    /// `x`.
    #[must_use]
    pub fn position(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }
}

/// An upper bound of `m^2 |e_m|` for `m > 64`, in which `ln m` is to be put in: `1.001 (2 ln m + 8)`.
fn end_size(logarithm: f64) -> f64 {
    1.001 * (2.0 * logarithm + 8.0)
}

/// An approximation `q_k = k - s` of `A^{-1} k`, `k(x) = ln(1/(1 - x))` the kernel at the right end, `A = 1 + theta K`. Made by
/// [`ResidualOperator::end_influence`](super::ResidualOperator::end_influence).
///
/// The end value of a solution is a functional of its right-hand side, `p(1) = g(1) - theta <k, A^{-1} g>`, and with approximations of both
///
/// `p(1) = q_1(1) - theta [<q_k, r> + <r_k, r>/2]`, off by at most `theta ||r_k|| ||r|| / 2`,
///
/// `q_1` the iterated solution. For degenerate solutions that converges nearly as `n^-6`. The left end is the mirror image.
#[derive(Debug, Clone)]
pub struct EndInfluence {
    parameter: f64,
    /// `<q_k, T_m>` and `(r_k)_m`, `m <= M`.
    moments: Vec<f64>,
    residual: Vec<f64>,
    /// Of `s`.
    tail: Tail,
    explicit_norms: [f64; 2],
    tail_norms: [f64; 2],
}

impl EndInfluence {
    pub(super) fn new(
        parameter: f64,
        correction: &[f64],
        moments: Vec<f64>,
        residual: Vec<f64>,
        residual_moments: &[f64],
    ) -> Self {
        let last = residual.len() - 1;
        let tail = Tail::new(correction, last);
        let explicit_norms = [0, 1].map(|parity| norm(&residual, residual_moments, parity));
        let tail_norms = [0, 1].map(|parity| tail_norm(parameter, &tail, parity));
        Self { parameter, moments, residual, tail, explicit_norms, tail_norms }
    }

    /// An upper bound of the norms of the even and the odd part of the residual of `q_k`.
    #[must_use]
    pub fn residual_norms(&self) -> [f64; 2] {
        [0, 1].map(|parity| self.explicit_norms[parity] + self.tail_norms[parity])
    }

    /// `p` at an end, from an approximation of the same operator; infinitely uncertain where parameter or degree of the operators differ.
    #[must_use]
    pub fn value(&self, approximation: &Approximation, end: End) -> Enclosure {
        let x = end.position();
        let g = approximation.right_hand_side().evaluate(x);
        let iterated = approximation.iterated().evaluate(x, g);
        let (own, other) = (self.tail.last(), approximation.tail.last());
        if self.parameter != approximation.parameter || own != other {
            return Enclosure { value: iterated, radius: f64::INFINITY };
        }
        let norms = [approximation.explicit_norms, approximation.tail_norms];
        let mut radius = half_product([self.explicit_norms, self.tail_norms], norms);
        let mut sum = 0.0;
        for (parity, sign) in [(0, 1.0), (1, x)] {
            let (beyond, unsure) = self.beyond(approximation, parity);
            sum += sign * (self.explicit(approximation, parity) + beyond);
            radius += unsure;
        }
        Enclosure { value: iterated - self.parameter * sum, radius: self.parameter * radius }
    }

    /// `<q_k, r> + <r_k, r>/2` over the modes up to `M`, one parity.
    fn explicit(&self, approximation: &Approximation, parity: usize) -> f64 {
        let product = |left: &[f64], right: &[f64]| -> f64 {
            left.iter().zip(right).skip(parity).step_by(2).map(|(l, r)| l * r).sum()
        };
        product(&self.moments, approximation.residual.coefficients())
            + 0.5 * product(&self.residual, &approximation.residual_moments)
    }

    /// `sum_{m>M} <q_k, T_m> r_m` of one parity, and how far it may be off.
    fn beyond(&self, approximation: &Approximation, parity: usize) -> (f64, f64) {
        let (own, other) = (&self.tail, &approximation.tail);
        let (from, to) = (own.last(), REACH * own.last());
        let theta = self.parameter;
        let sum: f64 = (EndMoments::default().enumerate().take(to + 1).skip(from + 1))
            .filter(|(m, _)| m % 2 == parity)
            .map(|(m, e)| -theta * 2.0 / m as f64 * other.moment(m) * (e - own.moment(m)))
            .sum();
        // sum_{m>L} (2 ln m + c) m^-5 <= (2 ln L + c + 1) / (8 L^4), one parity
        let left = |size: f64, last: usize, remainder: f64| {
            let last = last as f64;
            let influence = end_size(last.ln() + 0.5) + remainder;
            2.0 * theta * size * influence / (8.0 * last.powi(4))
        };
        let unsure = left(other.size(parity), to, own.size(parity))
            + left(other.remainder(parity), from, own.size(parity))
            + 2.0 * theta * other.size(parity) * own.remainder(parity)
                / (8.0 * (from as f64).powi(4));
        (sum, unsure)
    }
}

/// An upper bound of the norm of `sum_{m>M} (r_k)_m T_m`, one parity: `(r_k)_m = -theta (2/m) (e_m - <s, T_m>)`, both of coefficients that fall
/// monotonically.
fn tail_norm(theta: f64, tail: &Tail, parity: usize) -> f64 {
    let last = tail.last() as f64;
    // sum_{m>M} (2 ln m + c) m^-3 <= (2 ln M + c + 1) / (4 M^2), one parity
    let sum = end_size(last.ln() + 0.5) / (4.0 * last * last);
    let first = end_size((last + 1.0).ln()) / (last + 1.0).powi(3);
    2.0 * theta * peaked_norm(sum, first) + tail.norm(theta, parity)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::end_moments;

    #[test]
    fn moments_stay_below_their_bound_and_fall() {
        let e = end_moments(100_000);
        for m in 65..e.len() - 2 {
            assert!((m as f64).powi(2) * e[m].abs() <= end_size((m as f64).ln()), "{m}");
            assert!(e[m] < 0.0 && e[m + 2].abs() < e[m].abs());
        }
    }
}
