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

/// `sum_i terms_i`.
#[inline(always)]
pub(crate) fn sum(terms: &[f64]) -> f64 {
    let (chunks, rest) = terms.as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for chunk in chunks {
        for lane in 0..LANES {
            sums[lane] += chunk[lane];
        }
    }
    sums.iter().sum::<f64>() + rest.iter().sum::<f64>()
}

/// Euclidean norm.
pub(crate) fn norm(vector: &[f64]) -> f64 {
    dot(vector, vector).sqrt()
}

/// Largest absolute value; NaN if there is one.
pub(crate) fn largest(vector: &[f64]) -> f64 {
    let (chunks, rest) = vector.as_chunks::<LANES>();
    let (mut most, mut sums) = ([0.0; LANES], [0.0; LANES]);
    for chunk in chunks {
        for lane in 0..LANES {
            let size = chunk[lane].abs();
            most[lane] = if size > most[lane] { size } else { most[lane] };
            // NaN, which comparisons pass over, stays in a sum.
            sums[lane] += size;
        }
    }
    let has_nan = rest.iter().chain(&sums).any(|value| value.is_nan());
    let most = rest.iter().chain(&most).fold(0.0f64, |most, value| most.max(value.abs()));
    if has_nan { f64::NAN } else { most }
}

/// `target += factor * vector`.
pub(crate) fn add(target: &mut [f64], factor: f64, vector: &[f64]) {
    for (target, value) in target.iter_mut().zip(vector) {
        *target += factor * value;
    }
}
