//! The bilinear sum (1.5).

use super::verification::maximum;
use crate::kernel::SpectralRelation;

/// Terms, and more where they do not suffice.
const TERMS: [usize; 2] = [3000, 30_000];
/// A pair near the diagonal.
const NEAR: [f64; 2] = [0.5, 0.52];
/// An error that calls for more terms.
const LARGE: f64 = 1e-12;
/// Pairs of points far from each other, as shares of the extent.
const PAIRS: [[f64; 2]; 3] = [[0.12, 0.71], [0.35, 0.88], [0.2, 0.55]];

/// The worst error of the sum of as many terms as can be had and are needed, with the cutoff `erfc((m - 0.6 N)/(0.06 N))/2`: off the diagonal the plain sum converges conditionally
/// only. Relative to the largest of the values compared; and the number of terms.
pub(super) fn bilinear_error(relation: &dyn SpectralRelation) -> (f64, usize) {
    let [first, more] = TERMS.map(|terms| terms.min(relation.available()));
    let error = error_of_sum(relation, first);
    if error <= LARGE || more == first {
        return (error, first);
    }
    // Many terms bring rounding of their own.
    let finer = error_of_sum(relation, more);
    if finer < error || error.is_nan() { (finer, more) } else { (error, first) }
}

fn error_of_sum(relation: &dyn SpectralRelation, count: usize) -> f64 {
    let extent = relation.extent();
    let at = |share: f64| extent.left() + share * 2.0 * extent.half_length();
    let terms: Vec<f64> = (0..count)
        .map(|m| {
            let place = (m as f64 - 0.6 * count as f64) / (0.06 * count as f64);
            0.5 * libm::erfc(place) * relation.expansion_factor(m)
        })
        .collect();
    let (mut left, mut right) = (vec![0.0; count], vec![0.0; count]);
    let mut worst = 0.0f64;
    // A kernel that decays is held against its values near the diagonal.
    let mut largest = relation.value(at(NEAR[0]), at(NEAR[1])).abs();
    for [one, other] in PAIRS {
        let (x, s) = (at(one), at(other));
        relation.eigenfunctions(x, &mut left);
        relation.eigenfunctions(s, &mut right);
        let sum: f64 = terms.iter().zip(left.iter().zip(&right)).map(|(d, (p, q))| d * p * q).sum();
        let value = relation.value(x, s);
        worst = maximum(worst, (sum - value).abs());
        largest = largest.max(value.abs());
    }
    worst / largest
}
