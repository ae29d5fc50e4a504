//! A combination of responses with uncertain coefficients.

use super::approximation::Approximation;
use super::enclosure::{Enclosure, Kind};
use super::ends::{End, EndInfluence};
use super::responses::{Given, Responses};
use crate::basis::ChebyshevSeries;

/// Rounding within which a projection counts as met, in units of the machine precision.
const MET: f64 = 256.0;

/// `p = c_1 A^{-1} 1 + c_2 A^{-1} x - A^{-1} f` and its approximation `q` with the coefficients `c'_1`, `c'_2`:
///
/// `p - q = (c_1 - c'_1) A^{-1} 1 + (c_2 - c'_2) A^{-1} x + A^{-1} r`, `r` the residual of `q`.
///
/// Made by [`Responses::combine`].
#[derive(Debug, Clone)]
pub struct Combination<'r> {
    responses: &'r Responses,
    approximation: Approximation,
    used: [f64; 2],
    coefficients: [Enclosure; 2],
    projections: [Enclosure; 2],
    /// Whether the projection of each parity is given and `q` has it.
    met: [bool; 2],
}

impl<'r> Combination<'r> {
    pub(super) fn new(responses: &'r Responses, given: [Given; 2], used: [f64; 2]) -> Self {
        let [constant, linear] = responses.bases();
        let free = responses.free();
        let approximation =
            Approximation::sum((used[0], constant), &[(used[1], linear), (-1.0, free)]);
        let mut combination = Self {
            responses,
            approximation,
            used,
            coefficients: [Enclosure::default(); 2],
            projections: [Enclosure::default(); 2],
            met: [false; 2],
        };
        for (index, given) in given.into_iter().enumerate() {
            combination.enclose(index, given);
        }
        combination
    }

    fn enclose(&mut self, index: usize, given: Given) {
        let projection = match given {
            Given::Coefficient(c) => {
                self.coefficients[index] = Enclosure::exact(c);
                self.projections[index] = self.projection_of(index, c);
                return;
            }
            Given::Proportion(factor) => {
                let projection = self.proportional_projection(index, factor);
                self.projections[index] = projection;
                self.coefficients[index] = Enclosure {
                    value: factor * projection.value,
                    radius: factor.abs() * projection.radius,
                };
                return;
            }
            Given::Projection(value) => Enclosure::exact(value),
            Given::Quotient(_) if index == 0 => Enclosure::default(),
            Given::Quotient(e) => {
                let force = self.projections[0];
                Enclosure { value: e * force.value, radius: e.abs() * force.radius }
            }
        };
        self.projections[index] = projection;
        self.coefficients[index] = self.coefficient_of(index, projection);
        let scale = projection.value.abs()
            + (self.used[index] * self.responses.bases()[index].moments()[index]).abs();
        let missed = projection.error_of(self.approximation.moments()[index]);
        self.met[index] = missed <= MET * f64::EPSILON * scale;
    }

    /// `<u, p>` when the coefficient is `c`.
    fn projection_of(&self, index: usize, c: f64) -> Enclosure {
        let found = self.responses.bases()[index].functional(&self.approximation);
        let (energy, shift) = (self.responses.energies()[index], c - self.used[index]);
        Enclosure {
            value: found.value + shift * energy.value,
            radius: found.radius + shift.abs() * energy.radius,
        }
    }

    /// `t = <u, p>` when the coefficient is `kappa t`: from `t = <u, A^{-1} g'> + (kappa t - c') <u, A^{-1} u>`. Without bound where the enclosure of
    /// `1 - kappa <u, A^{-1} u>` contains 0.
    fn proportional_projection(&self, index: usize, factor: f64) -> Enclosure {
        let found = self.responses.bases()[index].functional(&self.approximation);
        let (energy, used) = (self.responses.energies()[index], self.used[index]);
        let numerator = found.value - used * energy.value;
        let denominator = 1.0 - factor * energy.value;
        let value = numerator / denominator;
        let least = denominator.abs() - factor.abs() * energy.radius;
        let radius = if least > 0.0 {
            let spread = found.radius + used.abs() * energy.radius;
            (spread + value.abs() * factor.abs() * energy.radius) / least
        } else {
            f64::INFINITY
        };
        Enclosure { value, radius }
    }

    /// The coefficient when `<u, p>` is given: `c' + (<u, p> - <u, A^{-1} g'>) / <u, A^{-1} u>`, `g'` the right-hand side of `q`.
    fn coefficient_of(&self, index: usize, projection: Enclosure) -> Enclosure {
        let found = self.responses.bases()[index].functional(&self.approximation);
        let energy = self.responses.energies()[index];
        let missing = projection.value - found.value;
        let value = self.used[index] + missing / energy.value;
        let least = energy.lower();
        let radius = if least > 0.0 {
            (projection.radius + found.radius + missing.abs() * energy.radius / energy.value)
                / least
        } else {
            f64::INFINITY
        };
        Enclosure { value, radius }
    }

    /// The approximation `q`.
    #[must_use]
    pub fn approximation(&self) -> &Approximation {
        &self.approximation
    }

    /// Whether the statements are bounds or estimates.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.approximation.kind
    }

    /// The coefficients `c'_1`, `c'_2` of `q`.
    #[must_use]
    pub fn used_coefficients(&self) -> [f64; 2] {
        self.used
    }

    /// The coefficients `c_1`, `c_2` of `p`, corrected by the residual; a given one comes back exact.
    #[must_use]
    pub fn coefficients(&self) -> [Enclosure; 2] {
        self.coefficients
    }

    /// The projections `<1, p>`, `<x, p>`, corrected by the residual; a given one comes back exact.
    #[must_use]
    pub fn projections(&self) -> [Enclosure; 2] {
        self.projections
    }

    /// Upper bounds of `|c_i - c'_i|`.
    fn shifts(&self) -> [f64; 2] {
        [0, 1].map(|index| self.coefficients[index].error_of(self.used[index]))
    }

    /// An upper bound of `||p - q||` in `L2(-1, 1)`.
    ///
    /// For each parity the smaller of `||r|| + |c - c'| ||A^{-1} u||` and, where the projection is given and met, `||r - Pi r||`, `Pi` the
    /// projection on `u`: there `p - q` is orthogonal to `u`.
    #[must_use]
    pub fn error_norm(&self) -> f64 {
        let (norms, shifts) = (self.approximation.residual_norms(), self.shifts());
        let [even, odd] = [0, 1].map(|parity| {
            let base = &self.responses.bases()[parity];
            let shifted = norms[parity] + product(shifts[parity], base.solution_norm(parity));
            if self.met[parity] { shifted.min(self.projected_norm(parity)) } else { shifted }
        });
        even.hypot(odd)
    }

    /// `||r - Pi r||` of one parity.
    fn projected_norm(&self, parity: usize) -> f64 {
        let norm = self.approximation.residual_norms()[parity];
        let projection = self.approximation.residual_projection(parity);
        // ||1||^2 = 2, ||x||^2 = 2/3
        let square = if parity == 0 { 2.0 } else { 2.0 / 3.0 };
        (norm * norm - projection * projection / square).max(0.0).sqrt()
    }

    /// An upper bound of `|p(x) - q_1(x)|` for all `x` in `[-1, 1]`, `q_1` the iterated solution of `q`.
    #[must_use]
    pub fn iterated_error(&self) -> f64 {
        let shifts = self.shifts();
        let moved: f64 = (self.responses.bases().iter().zip(shifts))
            .map(|(base, shift)| product(shift, base.solution_supremum()))
            .sum();
        self.approximation.iterated_error() + moved
    }

    /// An upper bound of `|p(x) - q(x)|`, `x` in `[-1, 1]`.
    #[must_use]
    pub fn error_at(&self, x: f64) -> f64 {
        self.approximation.residual(x).abs() + self.iterated_error()
    }

    /// An upper bound of `max |p - q|` over `[-1, 1]`.
    #[must_use]
    pub fn error_supremum(&self) -> f64 {
        self.approximation.residual_supremum() + self.iterated_error()
    }

    /// `p` at an end, corrected with the influence function of the same parameter.
    #[must_use]
    pub fn end_value(&self, influence: &EndInfluence, end: End) -> Enclosure {
        let mut found = influence.value(&self.approximation, end);
        for index in 0..2 {
            let coefficient = self.coefficients[index];
            let shift = coefficient.value - self.used[index];
            if shift != 0.0 || coefficient.radius != 0.0 {
                let base = influence.value(&self.responses.bases()[index], end);
                found.value += shift * base.value;
                found.radius += shift.abs() * base.radius + coefficient.radius * base.magnitude();
            }
        }
        found
    }

    /// The errors of `q` by comparison with a finer combination of the same problem: sharper where `q` does not resolve the boundary layers
    /// (degree below `theta`).
    #[must_use]
    pub fn refined_by<'c>(&'c self, finer: &'c Combination<'c>) -> Refinement<'c> {
        let difference = Approximation::difference(&finer.approximation, &self.approximation);
        Refinement { coarse: self, finer, difference }
    }
}

/// Errors of an approximation `q` by way of a finer one: `|p - q| <= |q_f - q| + |p - q_f|`, and no worse than from its own residual.
#[derive(Debug, Clone)]
pub struct Refinement<'c> {
    coarse: &'c Combination<'c>,
    finer: &'c Combination<'c>,
    difference: ChebyshevSeries,
}

impl Refinement<'_> {
    /// Whether the statements are bounds or estimates.
    #[must_use]
    pub fn kind(&self) -> Kind {
        self.coarse.kind().max(self.finer.kind())
    }

    /// An upper bound of `||p - q||` in `L2(-1, 1)`.
    #[must_use]
    pub fn error_norm(&self) -> f64 {
        let moments = self.difference.moments(self.difference.coefficients().len());
        let square: f64 =
            self.difference.coefficients().iter().zip(&moments).map(|(c, m)| c * m).sum();
        (square.max(0.0).sqrt() + self.finer.error_norm()).min(self.coarse.error_norm())
    }

    /// An upper bound of `|p(x) - q(x)|`, `x` in `[-1, 1]`.
    #[must_use]
    pub fn error_at(&self, x: f64) -> f64 {
        // q_f + r_f is the iterated solution of the finer one.
        let distance = self.difference.evaluate(x) + self.finer.approximation.residual(x);
        (distance.abs() + self.finer.iterated_error()).min(self.coarse.error_at(x))
    }

    /// An upper bound of `max |p - q|` over `[-1, 1]`.
    #[must_use]
    pub fn error_supremum(&self) -> f64 {
        (self.difference.supremum_bound() + self.finer.error_supremum())
            .min(self.coarse.error_supremum())
    }

    /// An upper bound of `max |p - q_1|` over `[-1, 1]`, `q_1` the iterated solution of `q`.
    #[must_use]
    pub fn iterated_error_at(&self, x: f64) -> f64 {
        let distance = self.difference.evaluate(x) + self.finer.approximation.residual(x)
            - self.coarse.approximation.residual(x);
        (distance.abs() + self.finer.iterated_error()).min(self.coarse.iterated_error())
    }
}

/// `shift * size` with `0 * inf = 0`: what is known exactly moves nothing.
fn product(shift: f64, size: f64) -> f64 {
    if shift == 0.0 { 0.0 } else { shift * size }
}
