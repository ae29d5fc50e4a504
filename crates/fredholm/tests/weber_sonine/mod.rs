//! Kernel 6: values, spectral relation and solutions against mpmath, closed forms and other methods.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

mod punch;
mod relation;
mod solutions;
mod values;

use fredholm::kernel::WeberSonine;
use serde_json::Value;

/// The kernel of a record of the data files.
fn kernel(case: &Value) -> WeberSonine {
    let number = |name: &str| case[name].as_f64().unwrap();
    WeberSonine::new(number("radius"), number("order"), number("exponent")).unwrap()
}

fn name(case: &Value) -> String {
    format!("mu = {}, gamma = {}, a = {}", case["order"], case["exponent"], case["radius"])
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(number).collect()
}

fn index(value: &Value) -> usize {
    usize::try_from(value.as_u64().unwrap()).unwrap()
}

fn list(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn read(text: &str) -> Value {
    serde_json::from_str(text).unwrap()
}

/// Origin: in the file.
fn reference() -> Value {
    read(include_str!("../data/weber_sonine.json"))
}

/// Origin: in the file.
fn solutions() -> Value {
    read(include_str!("../data/weber_sonine_solutions.json"))
}

/// The largest error met, printed when it goes.
struct Worst {
    what: &'static str,
    error: f64,
    at: String,
}

impl Worst {
    fn new(what: &'static str) -> Self {
        Self { what, error: 0.0, at: String::new() }
    }

    fn add(&mut self, error: f64, at: impl FnOnce() -> String) {
        if error > self.error || error.is_nan() {
            (self.error, self.at) = (error, at());
        }
    }

    fn require(&self, limit: f64) {
        println!("{}: {:.1e} at {}", self.what, self.error, self.at);
        assert!(self.error < limit, "{}: {:e} at {}", self.what, self.error, self.at);
    }
}
