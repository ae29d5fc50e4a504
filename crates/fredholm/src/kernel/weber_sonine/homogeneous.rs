//! The kernel as a function of one variable: of `d = |x - s|/(x + s)` alone but for a power of `x + s`.

use super::WeberSonine;
use super::dyadic::{polynomial, polynomials, powers};
use crate::kernel::{Kernel, Pair, Split};
use crate::special;

/// Places that are taken at once.
const CHUNK: usize = 64;
/// Up to this `d^2` the singularity is taken by itself; beyond, where it is far away, all is one polynomial. Both are smooth on twice their length, so that coefficients fall as `5.8^-n` (theory).
const NEAR: f64 = 0.5;

type Polynomial = [[f64; 4]; 6];

/// `(x + s)^(1+q) W(x, s) = strength/q h(d)`, `q = 2 gamma > 0`, with `h = a(d^2) d^-q + b(d^2)` next to the diagonal. Next to it the kernel is `strength/q |x - s|^-q/s`.
#[derive(Debug, Clone)]
pub(crate) struct Homogeneous {
    exponent: f64,
    singular: Polynomial,
    rest: Polynomial,
    far: Polynomial,
}

impl Homogeneous {
    /// Of a kernel with `gamma > 0`.
    pub(crate) fn new(kernel: &WeberSonine) -> Self {
        let exponent = 2.0 * kernel.exponent();
        let factor = exponent / kernel.split(1.0, 1.0, 0.0).factor;
        // Of points that add up to 1.
        let pair = |d: f64| kernel.uncut(0.5 * (1.0 + d), 0.5 * (1.0 - d), d);
        // From W = A (d^-q - 1)/q + B.
        let parts = |square: f64| {
            let d = square.sqrt();
            if d == 0.0 {
                let Split { factor: own, rest } = kernel.split(0.5, 0.5, 0.0);
                return [factor / exponent * own, factor * (rest - own / exponent)];
            }
            let Pair { value, factor: own } = pair(d);
            let singular = factor / exponent * own;
            [singular, factor * value - singular * d.powf(-exponent)]
        };
        let near = |u: f64| 0.5 * NEAR * (1.0 + u);
        let far = |u: f64| NEAR + 0.5 * (1.0 - NEAR) * (1.0 + u);
        Self {
            exponent,
            singular: powers(|u| parts(near(u))[0]),
            rest: powers(|u| parts(near(u))[1]),
            far: powers(|u| factor * pair(far(u).sqrt()).value),
        }
    }

    /// What goes with `d^-q`, and what is left; none where the singularity is far away.
    pub(crate) fn parts(&self, d: f64) -> Option<[f64; 2]> {
        let square = d * d;
        let u = 2.0 / NEAR * square - 1.0;
        let parts = || [polynomial(&self.singular, u), polynomial(&self.rest, u)];
        (square <= NEAR).then(parts)
    }

    /// `h`.
    pub(crate) fn value(&self, d: f64) -> f64 {
        match self.parts(d) {
            Some([singular, rest]) => singular * d.powf(-self.exponent) + rest,
            None => polynomial(&self.far, 2.0 / (1.0 - NEAR) * (d * d - NEAR) - 1.0),
        }
    }

    /// Replaces values of `d` by `h`.
    pub(crate) fn values(&self, distances: &mut [f64]) {
        for part in distances.chunks_mut(CHUNK) {
            let nothing = [0.0; CHUNK];
            let (mut singular, mut rest, mut far) = (nothing, nothing, nothing);
            let mut is_near = [false; CHUNK];
            for (k, d) in part.iter().enumerate() {
                let square = d * d;
                is_near[k] = square <= NEAR;
                singular[k] = 2.0 / NEAR * square.min(NEAR) - 1.0;
                rest[k] = singular[k];
                far[k] = 2.0 / (1.0 - NEAR) * (square.max(NEAR) - NEAR) - 1.0;
            }
            let count = part.len();
            polynomials(&self.singular, &mut singular[..count]);
            polynomials(&self.rest, &mut rest[..count]);
            if is_near[..count].contains(&false) {
                polynomials(&self.far, &mut far[..count]);
            }
            special::powers(part, -self.exponent);
            for (k, value) in part.iter_mut().enumerate() {
                *value = if is_near[k] { singular[k] * *value + rest[k] } else { far[k] };
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_and_parts_are_those_of_the_kernel() {
        for (order, gamma) in [(0.0, 0.05), (0.0, 0.3), (1.0, 0.2), (0.0, 0.45), (1.0, 0.45)] {
            let kernel = WeberSonine::new(1.0, order, gamma).unwrap();
            let found = Homogeneous::new(&kernel);
            let factor = 2.0 * gamma / kernel.split(1.0, 1.0, 0.0).factor;
            for k in 0..=300 {
                let d = 10f64.powf(-f64::from(k) / 25.0);
                let (x, s) = (0.5 * (1.0 + d), 0.5 * (1.0 - d));
                let exact = factor * kernel.pair(x, s, d).value;
                let mut value = [d];
                found.values(&mut value);
                let size = exact.max(1.0 / (1.0 - 2.0 * gamma));
                assert!(
                    (value[0] - exact).abs() < 1e-14 * size,
                    "{order} {gamma} {d:e}: {value:?} {exact}"
                );
                let alone = found.value(d);
                assert!((alone - exact).abs() < 1e-14 * size, "{order} {gamma} {d:e}: {alone}");
                if let Some([singular, rest]) = found.parts(d) {
                    let sum = singular * d.powf(-2.0 * gamma) + rest;
                    assert!(
                        (sum - exact).abs() < 1e-14 * size,
                        "{order} {gamma} {d:e}: {sum} {exact}"
                    );
                } else {
                    assert!(d * d > NEAR);
                }
            }
        }
    }
}
