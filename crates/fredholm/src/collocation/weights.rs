//! Exact integrals of the sinc functions against the singular functions.

use std::f64::consts::PI;

use crate::special::cosine_integral_pi;

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;

/// The part of the weight of `ln|t - u|` that a plain trapezoidal rule lacks.
///
/// With nodes `jh`, `int sinc(u/h - j) ln|ih - u| du = h (ln h + c_{i-j})`, `c_0 = -(gamma + ln pi)`,
/// `c_j = ln j - Ci(pi j)`: beside the value `ln(h j)` of the integrand there remains `-Ci(pi j)`.
pub(super) fn logarithm_corrections(count: usize) -> Vec<f64> {
    (0..count).map(|j| if j == 0 { -(EULER + PI.ln()) } else { -cosine_integral_pi(j) }).collect()
}
