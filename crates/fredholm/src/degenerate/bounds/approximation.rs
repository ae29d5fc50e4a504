//! An approximate solution with its residual.

use super::enclosure::{Enclosure, Kind};
use super::iterated::{IteratedSolution, difference};
use super::tail::Tail;
use crate::basis::ChebyshevSeries;
use crate::linear::vector::{add, dot};

/// Rounding errors of the squared norm, in units of the machine precision times the sum of squares.
const ROUNDING: f64 = 64.0;

/// An approximation `q = g - s` of the solution of `p + theta K p = g` with all that bounds its error: the residual
/// `r = g - q - theta K q = sum r_m T_m`, `r_m = s_m - theta a_m <q, T_m>`. Made by
/// [`ResidualOperator::approximation`](super::ResidualOperator::approximation).
///
/// All statements hold for exact arithmetic and for a right-hand side that is its Chebyshev series ([`kind`](Self::kind)).
#[derive(Debug, Clone)]
pub struct Approximation {
    pub(super) parameter: f64,
    pub(super) amplification: f64,
    pub(super) kind: Kind,
    right: ChebyshevSeries,
    correction: ChebyshevSeries,
    density: ChebyshevSeries,
    iterated: IteratedSolution,
    /// `<q, T_m>`, `m <= M`.
    moments: Vec<f64>,
    /// `r_m`, `m <= M`, and its own moments `<r, T_m>` without the tail.
    pub(super) residual: ChebyshevSeries,
    pub(super) residual_moments: Vec<f64>,
    pub(super) tail: Tail,
    /// Norms of the even and the odd part of the residual: of the modes up to `M`, and of those beyond.
    pub(super) explicit_norms: [f64; 2],
    pub(super) tail_norms: [f64; 2],
}

/// What is linear in the approximation.
pub(super) struct Parts {
    pub(super) right: Vec<f64>,
    pub(super) correction: Vec<f64>,
    pub(super) moments: Vec<f64>,
    pub(super) residual: Vec<f64>,
    pub(super) residual_moments: Vec<f64>,
}

impl Approximation {
    pub(super) fn new(parameter: f64, amplification: f64, kind: Kind, parts: Parts) -> Self {
        let Parts { right, correction, moments, residual, residual_moments } = parts;
        let right = ChebyshevSeries::new(right);
        let density = ChebyshevSeries::new(difference(&right, &correction));
        let tail = Tail::new(density.coefficients(), residual.len() - 1);
        let explicit_norms = [0, 1].map(|parity| norm(&residual, &residual_moments, parity));
        Self {
            parameter,
            amplification,
            kind,
            right,
            correction: ChebyshevSeries::new(correction),
            iterated: IteratedSolution::of(parameter, &density),
            density,
            moments,
            residual: ChebyshevSeries::new(residual),
            residual_moments,
            tail_norms: [0, 1].map(|parity| tail.norm(parameter, parity)),
            tail,
            explicit_norms,
        }
    }

    /// `sum factor * approximation`, all of the same operator, at least one.
    pub(super) fn sum(first: (f64, &Self), others: &[(f64, &Self)]) -> Self {
        let terms = || std::iter::once(&first).chain(others);
        let total = |part: &dyn Fn(&Self) -> &[f64]| {
            let length = terms().map(|(_, term)| part(term).len()).max().unwrap_or(0);
            let mut sum = vec![0.0; length];
            terms().for_each(|(factor, term)| add(&mut sum, *factor, part(term)));
            sum
        };
        let parts = Parts {
            right: total(&|term| term.right.coefficients()),
            correction: total(&|term| term.correction.coefficients()),
            moments: total(&|term| &term.moments),
            residual: total(&|term| term.residual.coefficients()),
            residual_moments: total(&|term| &term.residual_moments),
        };
        let kind = terms().map(|(_, term)| term.kind).max().unwrap_or(Kind::Bound);
        Self::new(first.1.parameter, first.1.amplification, kind, parts)
    }

    /// `q` of the first less `q` of the second.
    pub(super) fn difference(left: &Self, right: &Self) -> ChebyshevSeries {
        ChebyshevSeries::new(difference(&left.density, right.density.coefficients()))
    }

    /// Whether the statements are bounds or estimates.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// `theta`.
    #[must_use]
    pub fn parameter(&self) -> f64 {
        self.parameter
    }

    /// `g`.
    #[must_use]
    pub fn right_hand_side(&self) -> &ChebyshevSeries {
        &self.right
    }

    /// `q` as a polynomial.
    #[must_use]
    pub fn density(&self) -> &ChebyshevSeries {
        &self.density
    }

    /// `<q, T_m> = int_{-1}^{1} q T_m dx` for `m` up to four times the degree of `q`.
    #[must_use]
    pub fn moments(&self) -> &[f64] {
        &self.moments
    }

    /// `q(x)`, `x` in `[-1, 1]`.
    #[must_use]
    pub fn evaluate(&self, x: f64) -> f64 {
        self.density.evaluate(x)
    }

    /// The iterated solution `q_1 = q + r`, whose error is at most [`iterated_error`](Self::iterated_error) everywhere.
    #[must_use]
    pub fn iterated(&self) -> &IteratedSolution {
        &self.iterated
    }

    /// `r(x)`, all modes, in closed form; `x` in `[-1, 1]`.
    #[must_use]
    pub fn residual(&self, x: f64) -> f64 {
        self.correction.evaluate(x) - self.iterated.correction(x)
    }

    /// An upper bound of the norms of the even and the odd part of `r` in `L2(-1, 1)`.
    #[must_use]
    pub fn residual_norms(&self) -> [f64; 2] {
        [0, 1].map(|parity| self.explicit_norms[parity] + self.tail_norms[parity])
    }

    /// An upper bound of `||p - q||` in `L2(-1, 1)`: `||r||`, because `1 + theta K >= 1`.
    #[must_use]
    pub fn error_norm(&self) -> f64 {
        let [even, odd] = self.residual_norms();
        even.hypot(odd)
    }

    /// An upper bound of `|p(x) - q_1(x)|` for all `x` in `[-1, 1]`: `C(theta) ||r||`.
    #[must_use]
    pub fn iterated_error(&self) -> f64 {
        self.amplification * self.error_norm()
    }

    /// An upper bound of `|p(x) - q(x)|`: `|r(x)| + C(theta) ||r||`; `x` in `[-1, 1]`.
    #[must_use]
    pub fn error_at(&self, x: f64) -> f64 {
        self.residual(x).abs() + self.iterated_error()
    }

    /// An upper bound of `max |r|` over `[-1, 1]`.
    #[must_use]
    pub fn residual_supremum(&self) -> f64 {
        let tail: f64 =
            [0, 1].map(|parity| self.tail.supremum(self.parameter, parity)).iter().sum();
        self.residual.supremum_bound() + tail
    }

    /// An upper bound of `max |p - q|` over `[-1, 1]`.
    #[must_use]
    pub fn error_supremum(&self) -> f64 {
        self.residual_supremum() + self.iterated_error()
    }

    /// `<g_u, A^{-1} g_v>` from the approximations `q_u` (`self`) and `q_v`, `A = 1 + theta K`:
    ///
    /// `<g_u, q_v> + <q_u, r_v> + <r_u, r_v>/2`, off by at most `||r_u|| ||r_v|| / 2`, for even and odd parts separately,
    ///
    /// because `A^{-1} - 1/2` has a norm of at most `1/2`. Converges as the square of the norm of the residual: `n^-6 ln n` for
    /// degenerate solutions, where `<g_u, q_v>` alone has `n^-4`. Both must be of the same operator: where the parameters or the degrees
    /// of the operators differ the radius is infinite.
    #[must_use]
    pub fn functional(&self, other: &Self) -> Enclosure {
        let plain = dot(self.right.coefficients(), prefix(&other.moments, &self.right));
        if !self.matches(other) {
            return Enclosure { value: plain, radius: f64::INFINITY };
        }
        let explicit = dot(&self.moments, other.residual.coefficients());
        let half = 0.5 * dot(self.residual.coefficients(), &other.residual_moments);
        let (beyond, unsure) = other.tail.product(self.parameter, &self.tail);
        let split = |term: &Self| [term.explicit_norms, term.tail_norms];
        let radius = unsure + half_product(split(self), split(other));
        Enclosure { value: plain + explicit + beyond + half, radius }
    }

    /// Whether both have the same parameter and know the same modes of their residuals.
    pub(super) fn matches(&self, other: &Self) -> bool {
        self.parameter == other.parameter && self.tail.last() == other.tail.last()
    }

    /// An upper bound of the norm of `p` of one parity in `L2(-1, 1)`.
    pub(super) fn solution_norm(&self, parity: usize) -> f64 {
        let density = self.density.coefficients();
        norm(density, &self.moments, parity) + self.residual_norms()[parity]
    }

    /// An upper bound of `max |p|`.
    pub(super) fn solution_supremum(&self) -> f64 {
        self.density.supremum_bound() + self.error_supremum()
    }

    /// A lower bound of `|<r, T_parity>|`.
    pub(super) fn residual_projection(&self, parity: usize) -> f64 {
        let beyond = self.tail.projection(self.parameter, parity);
        (self.residual_moments[parity].abs() - beyond).max(0.0)
    }
}

/// Half of the product of the norms of two residuals, and what their modes beyond leave uncertain in half of their scalar product; each given
/// as the norms of the known modes and of those beyond, even and odd.
pub(super) fn half_product(own: [[f64; 2]; 2], other: [[f64; 2]; 2]) -> f64 {
    let parity = |i: usize| {
        let ([known, beyond], [others, others_beyond]) =
            (own.map(|norms| norms[i]), other.map(|norms| norms[i]));
        let unknown = known * others_beyond + beyond * others + beyond * others_beyond;
        0.5 * ((known + beyond) * (others + others_beyond) + unknown)
    };
    parity(0) + parity(1)
}

/// The moments that meet the coefficients of a series; the operator admits no longer series.
fn prefix<'m>(moments: &'m [f64], series: &ChebyshevSeries) -> &'m [f64] {
    &moments[..moments.len().min(series.coefficients().len())]
}

/// The norm of one parity of a polynomial from its coefficients and moments, rounded up.
pub(super) fn norm(coefficients: &[f64], moments: &[f64], parity: usize) -> f64 {
    let (mut square, mut squares) = (0.0, 0.0);
    for (c, moment) in coefficients.iter().zip(moments).skip(parity).step_by(2) {
        square += c * moment;
        squares += c * c;
    }
    (square.max(0.0) + ROUNDING * f64::EPSILON * squares).sqrt()
}
