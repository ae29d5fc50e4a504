//! How far from the diagonal the factor of the singular function is kept.

use super::dyadic::{polynomial, polynomials, powers};

/// Steepness: the cutoff is 1 to rounding at the diagonal.
const STEEPNESS: f64 = 6.0;
/// Pieces of the table.
const PIECES: usize = 12;
/// Depth, in powers of e below the radius, that counts at most.
const DEEPEST: f64 = 40.0;

/// `erfc(6 (r/r_c - 1))/2` with `r = |ln(x/s)|`, `r_c = c + theta L` and the depth `L = -ln(sqrt(x s)/a)`.
///
/// Collocation replaces trapezoidal sums by exact weights, and the difference is the factor times numbers that alternate and fall as the square of the number of
/// places. The sums cancel if the factor is smooth on the grid, which in the corner at 0 is one of `ln x` with steps proportional to the depth: so the width must
/// grow with the depth. The factor grows as `(x/s)^mu`: so the width must stop at `theta`, where the scaled matrix keeps its size
/// to the weights of the singularity, `x^(1-mu) s^(mu-2 gamma) < (x/s)^(1/4)`, and
/// rounding of potentials stays below their largest value, `x^-mu s^(2 mu+1-2 gamma) < 1`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cutoff {
    constant: f64,
    slope: f64,
    /// On equal pieces of `r/r_c` from 0 to 2: the error function itself takes longer than all the rest of the kernel.
    pieces: [[[f64; 4]; 4]; PIECES],
}

impl Cutoff {
    pub(super) fn new(order: f64, exponent: f64) -> Self {
        // With the exponent of what a corner contributes.
        let decay = 1.0 - 2.0 * exponent;
        let by_potential = order / (2.0 * order + decay);
        let by_matrix = (order - 0.75) / (order - 0.75 + decay).max(decay);
        let nearest = by_potential.max(by_matrix);
        // 1.6: there the cutoff has fallen to 1e-7.
        let slope = 2.0 / 1.6 * (1.0 - nearest) / (1.0 + nearest);
        let half = 1.0 / PIECES as f64;
        let pieces = std::array::from_fn(|j| {
            let centre = (2 * j + 1) as f64 * half;
            powers(|u| 0.5 * libm::erfc(STEEPNESS * (centre + half * u - 1.0)))
        });
        Self { constant: 4.0 / (order + 0.5), slope, pieces }
    }

    /// The cutoff at `r`, where `x s` is `a^2 e^(-2 depth)`.
    pub(super) fn value(&self, r: f64, depth: f64) -> f64 {
        let place = self.place(r, depth);
        match self.pieces.get(place as usize) {
            Some(piece) => polynomial(piece, local(place)),
            None => 0.0,
        }
    }

    /// `r/r_c` in pieces.
    #[inline(always)]
    pub(super) fn place(&self, r: f64, depth: f64) -> f64 {
        let depth = depth.max(0.0);
        let saturated = depth * DEEPEST / (DEEPEST + depth);
        0.5 * PIECES as f64 * r / (self.constant + self.slope * saturated)
    }

    /// Puts the cutoffs there, the same to the last bit for less: those of a piece that follow each other are taken side by side.
    #[inline(always)]
    pub(super) fn at_places(&self, mut places: &mut [f64]) {
        while let Some(first) = places.first() {
            let index = *first as usize;
            let count = places.iter().take_while(|place| **place as usize == index).count();
            let (own, others) = places.split_at_mut(count);
            match self.pieces.get(index) {
                Some(piece) => {
                    for place in own.iter_mut() {
                        *place = local(*place);
                    }
                    polynomials(piece, own);
                }
                None => own.fill(0.0),
            }
            places = others;
        }
    }

    /// From here on it vanishes.
    pub(super) fn reach(&self) -> f64 {
        2.0 * (self.constant + self.slope * DEEPEST)
    }
}

/// `u` of the piece of a place.
#[inline(always)]
fn local(place: f64) -> f64 {
    2.0 * (place - place.floor()) - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_the_error_function_and_one_at_the_diagonal() {
        let cutoff = Cutoff::new(1.0, 0.1);
        assert!((cutoff.value(0.0, 3.0) - 1.0).abs() < 1e-15);
        for i in 0..200 {
            let place = 0.01 * f64::from(i);
            let found = cutoff.value(place * cutoff.constant, 0.0);
            let exact = 0.5 * libm::erfc(STEEPNESS * (place - 1.0));
            assert!((found - exact).abs() < 3e-15, "{place}: {found} {exact}");
        }
        assert_eq!(cutoff.value(cutoff.reach() * 1.001, 1e300), 0.0);
        let ratios: Vec<f64> = (0..300).map(|i| 0.03 * f64::from(i % 170)).collect();
        let mut many: Vec<f64> = ratios.iter().map(|r| cutoff.place(*r, 1.5)).collect();
        cutoff.at_places(&mut many);
        let alone: Vec<f64> = ratios.iter().map(|r| cutoff.value(*r, 1.5)).collect();
        assert_eq!(many, alone);
    }
}
