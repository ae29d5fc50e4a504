//! Answers against solutions of the same equation by another method, in another language: `tests/data/make_references.py`.

use serde_json::Value;

use crate::cli::support::{Folder, assert_valid, number, schema};

const DEGREE: f64 = 400.0;
/// Digits of the references (they agree among themselves to 2e-13) and of rounding here.
const ROUNDING: f64 = 1e-12;

/// Errors of the degenerate kernel of degree `n`, without dimensions.
///
/// The part of the kernel that is cut off is `sum_{m>n} (2/m) T_m(x) T_m(s)`, and `X_m = int p T_m` is about `-2 p_end/m^2` an end and parity.
/// So the pressure is off by about `theta0 sum 2/m |X_m|`, at most `theta0 (|p-| + |p+|)/n^2` at an edge; in the middle the terms alternate, which gains an
/// order. Settlement and tilt are off by the double sum `theta0 sum (2/m) X_m Y_m`, with `Y_m` of the unit response, whose edge pressure at unit force is at
/// most `1 + sqrt(theta0)`. Close to the edges, within `1/n`, the edge bound holds.
struct Tolerance {
    edge: f64,
    inside: f64,
    displacement: f64,
}

impl Tolerance {
    fn new(theta0: f64, edges0: f64) -> Self {
        let first = theta0 * edges0;
        Self {
            edge: first / DEGREE.powi(2),
            inside: 2.5 * first / DEGREE.powi(3),
            displacement: first * (1.0 + theta0.sqrt()) / DEGREE.powi(4),
        }
    }
}

fn floats(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

#[track_caller]
fn assert_close(value: f64, exact: f64, tolerance: f64, scale: f64, what: &str) {
    let error = (value - exact).abs();
    let allowed = tolerance + ROUNDING * scale;
    assert!(
        error <= allowed,
        "{what}: {value} for {exact}, error {error:.2e}, allowed {allowed:.2e}"
    );
}

#[test]
fn answers_agree_with_independent_solutions_to_the_orders_of_the_paper() {
    let cases: Value = serde_json::from_str(include_str!("../data/references.json")).unwrap();
    let cases = cases["cases"].as_array().unwrap();
    assert!(cases.len() >= 12);
    let schema = schema("answer");
    for case in cases {
        let name = case["name"].as_str().unwrap();
        let problem = format!(
            "{}\n[solver]\ncontact = \"bilateral\"\nn = {DEGREE}\n",
            case["toml"].as_str().unwrap()
        );
        let folder = Folder::with(&problem);
        let places: Vec<String> = floats(&case["places"]).iter().map(f64::to_string).collect();
        let at = places.join(",");
        let json = folder.run(&["solve", "punch.toml", "--format", "json", "--at", &at]).json();
        assert_valid(&schema, &json, name);
        check(case, &json, name);
    }
}

fn check(case: &Value, json: &Value, name: &str) {
    let theta0 = number(case, "/theta0");
    let physical = !json["physical"].is_null();
    assert_close(number(json, "/dimensionless/theta0"), theta0, 0.0, theta0, name);
    let at = |key: &str| {
        let section = if physical { "physical" } else { "dimensionless" };
        number(json, &format!("/{section}/{key}"))
    };
    // Scales between the answer and its dimensionless part, (2.5).
    let half_width = number(case, "/half_width");
    let pressure = at("pressure_left") / number(json, "/dimensionless/pressure_left");
    let displacement = at("settlement") / number(json, "/dimensionless/settlement");
    let edges0 = number(json, "/dimensionless/pressure_left").abs()
        + number(json, "/dimensionless/pressure_right").abs();
    let tolerance = Tolerance::new(theta0, edges0);

    let exact = floats(&case["pressures"]);
    let largest = exact.iter().fold(0.0f64, |largest, p| largest.max(p.abs()));
    // A displacement of 1 is a pressure of 1 in the layer; rounding is that of the largest term of the equation.
    let scale0 = (number(json, "/dimensionless/settlement").abs()
        + number(json, "/dimensionless/tilt").abs())
    .max(largest / pressure);
    for (key, unit) in [("settlement", displacement), ("tilt", displacement / half_width)] {
        let exact = number(case, &format!("/{key}"));
        let allowed = tolerance.displacement * unit.abs();
        assert_close(at(key), exact, allowed, scale0 * unit.abs(), &format!("{name}: {key}"));
    }
    for (key, unit) in [("force", half_width), ("moment", half_width.powi(2))] {
        let exact = number(case, &format!("/{key}"));
        let allowed = tolerance.displacement * unit * pressure;
        let scale = scale0 * unit * pressure;
        assert_close(at(key), exact, allowed, scale, &format!("{name}: {key}"));
    }
    assert_eq!(floats(&json["pressure"]["x"]), floats(&case["places"]));
    let computed = floats(&json["pressure"]["pressure"]);
    for ((place, value), exact) in floats(&case["places"]).iter().zip(&computed).zip(&exact) {
        let near = (place / half_width).abs() > 0.9;
        let allowed = if near { tolerance.edge } else { tolerance.inside };
        let what = format!("{name}: p({place})");
        assert_close(*value, *exact, allowed * pressure, scale0 * pressure, &what);
    }
    for (i, key) in [(0, "pressure_left"), (3, "pressure_middle"), (6, "pressure_right")] {
        assert_close(computed[i], at(key), 0.0, scale0 * pressure, key);
    }
    let rounding = ROUNDING * scale0 * pressure;
    assert!(at("peak_pressure") + rounding >= computed.iter().copied().fold(f64::MIN, f64::max));
    check_stiffness(case, json, physical, theta0, name);
}

fn check_stiffness(case: &Value, json: &Value, physical: bool, theta0: f64, name: &str) {
    let section = if physical { "physical" } else { "dimensionless" };
    let rows = |value: &Value| -> Vec<Vec<f64>> {
        value["stiffness"].as_array().unwrap().iter().map(floats).collect()
    };
    let (k, exact) = (rows(&json[section]), rows(case));
    assert_eq!(k[0][1], k[1][0], "{name}: symmetric");
    assert!(k[0][0] > 0.0 && k[0][0] * k[1][1] > k[0][1] * k[1][0], "{name}: positive definite");
    for i in 0..2 {
        // Relative: edge pressures of the unit responses are below their mean times 1 + sqrt(theta0).
        let tolerance = Tolerance::new(theta0, 2.0 * (1.0 + theta0.sqrt())).displacement;
        let scale = exact[i][i];
        assert_close(
            k[i][i],
            exact[i][i],
            tolerance * scale,
            scale,
            &format!("{name}: stiffness {i}"),
        );
    }
    assert!(
        k[0][1].abs() <= ROUNDING * (k[0][0] * k[1][1]).sqrt(),
        "{name}: a lone even kernel couples nothing"
    );
}
