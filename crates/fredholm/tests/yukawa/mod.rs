//! Kernel 7, the Yukawa potential on a disk: values, spectral relation and solutions against mpmath and other methods.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail by panicking")]

mod relation;
mod solutions;
mod values;

use fredholm::kernel::Yukawa;
use serde_json::Value;

fn reference() -> Value {
    serde_json::from_str(include_str!("../data/yukawa_reference.json")).unwrap()
}

fn rows(value: &Value) -> &[Value] {
    value.as_array().unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| value.as_str().unwrap().parse().unwrap())
}

fn numbers(value: &Value) -> Vec<f64> {
    rows(value).iter().map(number).collect()
}

fn kernel(entry: &Value) -> Yukawa {
    Yukawa::new(number(&entry["a"]), number(&entry["chi0"]), number(&entry["m"]) as u32).unwrap()
}
