//! An approximate inverse of the matrix of the symmetric form.

use super::operator::Part;
use crate::Error;
use crate::linear::{Cholesky, Tridiagonal};

/// Orders allowed for the leading block.
const LEADING: std::ops::RangeInclusive<usize> = 32..=2048;
/// Share of the entries beyond the neighbours that is moved to the diagonal of the tail.
const LUMPED: f64 = 0.8;
/// Smallest pivot of the tail, relative to its diagonal entry.
const MARGIN: f64 = 0.05;

/// The inverse of `M = [A_11, C; C^T, T]`: the leading block of `A = I + lambda sqrt(D) R sqrt(D)` exactly, the rest tridiagonal.
///
/// `T` keeps the diagonal and the nearest neighbours and moves most of the more distant (Toeplitz) entries to the diagonal: where `R` is
/// multiplication by a function that vanishes at an end of the interval of angles, as `|sin s|` does, this keeps the
/// smallness of `A` on slowly varying vectors, and the number of iterations grows with the fourth root of `lambda` over the
/// order of the block where the mere diagonal makes it the square root. The Hankel entries fade away from the leading
/// corner and are left out of the tail.
#[derive(Debug, Clone)]
pub(super) struct Preconditioner {
    leading: Cholesky,
    /// `M` between the last index of the block and the first of the tail.
    coupling: f64,
    tail: Tridiagonal,
}

impl Preconditioner {
    /// For the part of the operator at this parameter; with the mere diagonal as tail where the tridiagonal one is not safely positive.
    pub(super) fn new(part: &Part, parameter: f64) -> Result<Self, Error> {
        let order = leading_order(part, parameter);
        let tail = Band::tridiagonal(part, parameter, order);
        match Self::banded(part, parameter, order, &tail) {
            Ok(Some(found)) => return Ok(found),
            Ok(None) | Err(Error::NotPositiveDefinite { .. }) => {}
            Err(other) => return Err(other),
        }
        let tail = Band { neighbour: 0.0, diagonal: part.toeplitz(0), ..tail };
        Self::banded(part, parameter, order, &tail)?
            .ok_or(Error::NotPositiveDefinite { order: part.count(), pivot: order })
    }

    fn banded(
        part: &Part,
        parameter: f64,
        order: usize,
        band: &Band,
    ) -> Result<Option<Self>, Error> {
        let rows = part.count() - order;
        let tail = Tridiagonal::new(
            rows,
            MARGIN,
            |i| band.diagonal(order + i),
            |i| band.neighbour(order + i),
        );
        let Some(tail) = tail else {
            return Ok(None);
        };
        let coupling = if rows > 0 { band.neighbour(order - 1) } else { 0.0 };
        let last = order - 1;
        let leading = Cholesky::new(order, |i, j| {
            let identity = if i == j { 1.0 } else { 0.0 };
            let entry =
                identity + parameter * part.root(i) * part.leading_entry(i, j) * part.root(j);
            if i == last && j == last {
                entry - coupling * coupling * tail.first_inverse()
            } else {
                entry
            }
        })?;
        Ok(Some(Self { leading, coupling, tail }))
    }

    /// Overwrites `vector` with `M^{-1} vector`.
    pub(super) fn apply(&self, vector: &mut [f64]) {
        let (head, tail) = vector.split_at_mut(self.leading.order());
        self.tail.eliminate(tail);
        let last = head.len() - 1;
        if let Some(first) = tail.first() {
            head[last] -= self.coupling * self.tail.first_inverse() * first;
        }
        self.leading.solve(head);
        self.tail.substitute(tail, self.coupling * self.tail.first_inverse() * head[last]);
    }
}

/// The tail of `M`: `1 + lambda D_p diagonal` and `lambda sqrt(D_p D_{p+1}) neighbour`.
struct Band<'p> {
    part: &'p Part,
    parameter: f64,
    diagonal: f64,
    neighbour: f64,
}

impl<'p> Band<'p> {
    fn tridiagonal(part: &'p Part, parameter: f64, order: usize) -> Self {
        let far: f64 = (2..order).map(|j| part.toeplitz(j)).sum();
        let diagonal = part.toeplitz(0) + 2.0 * LUMPED * far;
        Self { part, parameter, diagonal, neighbour: part.toeplitz(1) }
    }

    fn diagonal(&self, p: usize) -> f64 {
        1.0 + self.parameter * self.part.root(p) * self.diagonal * self.part.root(p)
    }

    fn neighbour(&self, p: usize) -> f64 {
        self.parameter * self.part.root(p) * self.neighbour * self.part.root(p + 1)
    }
}

/// The order of the leading block: growing with the parameter, which sets how many eigenfunctions are coupled
/// strongly, but not beyond what the products of a few iterations cost (measured).
fn leading_order(part: &Part, parameter: f64) -> usize {
    let strength = (parameter * part.strength()).cbrt();
    let affordable = (part.count() as f64).cbrt();
    let order = (64.0 * strength).min(25.0 * affordable) as usize;
    order.clamp(*LEADING.start(), *LEADING.end()).min(part.leading())
}

/// The largest order that may be asked for.
pub(super) const fn largest_leading_order() -> usize {
    *LEADING.end()
}
