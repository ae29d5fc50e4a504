//! Vectors: sums in a fixed order that vector units can follow.

/// Independent partial sums of a scalar product.
const LANES: usize = 8;

/// `sum_i left_i right_i`; the shorter of the two counts.
#[inline(always)]
pub(crate) fn dot(left: &[f64], right: &[f64]) -> f64 {
    let length = left.len().min(right.len());
    let (left, left_rest) = left[..length].as_chunks::<LANES>();
    let (right, right_rest) = right[..length].as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for (left, right) in left.iter().zip(right) {
        for lane in 0..LANES {
            sums[lane] += left[lane] * right[lane];
        }
    }
    let rest: f64 = left_rest.iter().zip(right_rest).map(|(left, right)| left * right).sum();
    sums.iter().sum::<f64>() + rest
}

/// Euclidean norm.
pub(crate) fn norm(vector: &[f64]) -> f64 {
    dot(vector, vector).sqrt()
}

/// Largest absolute value; NaN if there is one.
pub(crate) fn largest(vector: &[f64]) -> f64 {
    vector.iter().fold(
        0.0f64,
        |largest, value| {
            if value.is_nan() { f64::NAN } else { largest.max(value.abs()) }
        },
    )
}

/// `target += factor * vector`.
pub(crate) fn add(target: &mut [f64], factor: f64, vector: &[f64]) {
    for (target, value) in target.iter_mut().zip(vector) {
        *target += factor * value;
    }
}
