//! Reference data, and closed forms of potentials.

use std::f64::consts::PI;

use fredholm::kernel::{LogarithmRatio, LogarithmSine, LogarithmSquare, SpectralRelation};
use serde_json::Value;

/// Tolerance of everything that double precision can hold.
pub const EXACT: f64 = 1e-13;
/// Tolerance of solutions of the second kind, of their largest value.
pub const SOLUTION: f64 = 1e-11;

pub fn read(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// Relations, solutions and integrals of kernels 2 and 3; origin in the file.
pub fn kernels_2_3() -> Value {
    read(include_str!("../data/kernels_2_3.json"))
}

/// The companion of kernel 2, and Gram integrals of kernels 2 and 3 in long ranges; origin in the file.
pub fn more() -> Value {
    read(include_str!("../data/logarithmic_kernels.json"))
}

pub fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().unwrap(),
        value => value.as_f64().unwrap(),
    }
}

pub fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

/// Pairs of an index and a value.
pub fn indexed(value: &Value) -> Vec<(usize, f64)> {
    let pairs = value.as_object().unwrap().iter();
    pairs.map(|(key, value)| (key.parse().unwrap(), number(value))).collect()
}

/// Pairs of a place and a value.
pub fn placed(value: &Value) -> Vec<(f64, &Value)> {
    value.as_object().unwrap().iter().map(|(key, value)| (key.parse().unwrap(), value)).collect()
}

pub fn kernel(case: &Value) -> Box<dyn SpectralRelation> {
    let parameter = |name: &str| number(&case["params"][name]);
    match case["kernel"].as_i64().unwrap() {
        2 => Box::new(LogarithmRatio::new(parameter("b"), parameter("a")).unwrap()),
        3 => Box::new(LogarithmSine::new(parameter("alpha")).unwrap()),
        other => panic!("kernel {other}"),
    }
}

pub fn square(case: &Value) -> LogarithmSquare {
    let parameter = |name: &str| number(&case[name]);
    LogarithmSquare::with_gauge(parameter("inner"), parameter("outer"), parameter("gauge")).unwrap()
}

/// The largest of what it is given.
#[derive(Default)]
pub struct Worst(pub f64);

impl Worst {
    pub fn note(&mut self, error: f64) {
        assert!(!error.is_nan());
        self.0 = self.0.max(error);
    }

    pub fn require(self, what: &str, tolerance: f64) {
        println!("{what}: {:.1e}", self.0);
        assert!(self.0 < tolerance, "{what}: {:e}", self.0);
    }
}

/// `z ln z`, 0 at 0.
pub fn x_log(z: f64) -> f64 {
    if z > 0.0 { z * z.ln() } else { 0.0 }
}

/// Clausen's integral `Cl_2(t) = -int_0^t ln(2 sin(u/2)) du`, `0 <= t <= 2 pi`: `t - t ln t + t sum zeta(2k) (t/2 pi)^(2k)/(k (2k + 1))`.
pub fn clausen(t: f64) -> f64 {
    if t > PI {
        return -clausen(2.0 * PI - t);
    }
    let ratio = (t / (2.0 * PI)).powi(2);
    let mut sum = 0.0;
    for k in (1..40).rev() {
        let zeta: f64 = match k {
            1 => PI * PI / 6.0,
            2 => PI.powi(4) / 90.0,
            3 => PI.powi(6) / 945.0,
            _ => (1..60).rev().map(|n| f64::from(n).powi(-2 * k)).sum(),
        };
        sum += zeta * ratio.powi(k) / (f64::from(k) * (2.0 * f64::from(k) + 1.0));
    }
    t - x_log(t) + t * sum
}

/// `int_b^a K ds` of kernel 2, `b = 0` included.
pub fn ratio_of_one(b: f64, a: f64, x: f64) -> f64 {
    x_log(a + x) - x_log(b + x) - x_log(a - x) - x_log(x - b)
}

pub fn sine_of_one(alpha: f64, x: f64) -> f64 {
    clausen(alpha - x) + clausen(alpha + x)
}

pub fn square_of_one(b: f64, a: f64, gauge: f64, x: f64) -> f64 {
    2.0 * (a - b) * (1.0 + gauge.ln()) - x_log(a - x) - x_log(x - b) - x_log(a + x) + x_log(b + x)
}

/// `int_b^a K s ds` of the companion.
pub fn square_of_identity(b: f64, a: f64, gauge: f64, x: f64) -> f64 {
    let (outer, inner) = ((a - x) * (a + x), (x - b) * (x + b));
    (a - b) * (a + b) * (0.5 + gauge.ln()) - 0.5 * (x_log(outer) + x_log(inner))
}
