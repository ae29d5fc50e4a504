//! Discrete cosine transforms of types I and III.

use std::f64::consts::FRAC_PI_2;

use crate::{Complex, PackedTransform, Planner};

/// In place `y_k = x_0 / 2 + sum_{0<j<n} x_j cos(pi j k / n) + (-1)^k x_n / 2`, with `n + 1` values (type I).
///
/// Even `n`: the sums `x_j + x_{n-j}` give the even outputs by the same transform of half the length, the differences the odd ones
/// by one of type III. This halves the work of the mirrored sequence, and keeps its accuracy: no running sums.
pub fn cosine_sums(values: &mut [f64]) {
    let n = values.len().saturating_sub(1);
    if n == 0 {
        return;
    }
    if n % 2 == 1 {
        mirrored_sums(values);
        return;
    }
    let half = n / 2;
    for j in 0..half {
        let (left, right) = (values[j], values[n - j]);
        values[j] = left + right;
        values[n - j] = left - right;
    }
    values[half] *= 2.0;
    let mut odd: Vec<f64> = values[half + 1..].iter().rev().copied().collect();
    half_shifted_sums(&mut odd);
    cosine_sums(&mut values[..=half]);
    // From the back, so that each even output moves before its place is needed.
    values[n] = values[half];
    for (r, odd) in odd.into_iter().enumerate().rev() {
        values[2 * r + 1] = odd;
        values[2 * r] = values[r];
    }
}

/// In place `y_r = x_0 / 2 + sum_{0<j<n} x_j cos(pi j (r + 1/2) / n)` (type III), as the inverse of Makhoul's
/// type II: `y_2i = v_i`, `y_{2i+1} = v_{n-1-i}` with the real `v` of spectrum `exp(i pi k / 2n) (x_k - i x_{n-k})`.
fn half_shifted_sums(values: &mut [f64]) {
    let n = values.len();
    let spectrum = |k: usize| {
        let mirrored = if k == 0 { 0.0 } else { values[n - k] };
        let direct = if k == n { 0.0 } else { values[k] };
        let root = Complex::from_polar(1.0, FRAC_PI_2 * (k as f64 / n as f64));
        root * Complex::new(direct, -mirrored)
    };
    let sequence: Vec<f64> = if n.is_multiple_of(2) {
        let transform = PackedTransform::new(&mut Planner::new(), n / 2);
        let mut buffer = vec![Complex::default(); n / 2];
        transform.filter(&mut buffer, |k, _, _| (spectrum(k), spectrum(n / 2 - k)));
        transform.backward(&mut buffer, &mut transform.scratch());
        buffer.into_iter().flat_map(|pair| [pair.re, -pair.im]).collect()
    } else {
        let mut buffer: Vec<Complex> = (0..n).map(spectrum).collect();
        Planner::new().inverse(n).process(&mut buffer);
        buffer.into_iter().map(|value| 0.5 * value.re).collect()
    };
    for (i, pair) in values.chunks_mut(2).enumerate() {
        pair[0] = sequence[i];
        if let Some(second) = pair.get_mut(1) {
            *second = sequence[n - 1 - i];
        }
    }
}

/// Type I with odd `n`, from the sequence mirrored at both ends.
fn mirrored_sums(values: &mut [f64]) {
    let n = values.len() - 1;
    let mirrored = (0..2 * n).map(|j| values[if j <= n { j } else { 2 * n - j }]);
    let mut buffer: Vec<Complex> = mirrored.map(|value| Complex::new(0.5 * value, 0.0)).collect();
    Planner::new().forward(2 * n).process(&mut buffer);
    for (value, sum) in values.iter_mut().zip(buffer) {
        *value = sum.re;
    }
}
