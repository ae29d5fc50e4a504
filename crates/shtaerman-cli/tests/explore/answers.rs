//! What the page is told is what the command line prints.

use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};

use crate::explore::client::{PROGRAM, PUNCH, Page};

fn examples() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples"))
}

fn run(arguments: &[&str]) -> String {
    let told = Command::new(PROGRAM).args(arguments).current_dir(examples()).output().unwrap();
    assert_eq!(told.status.code(), Some(0), "{}", String::from_utf8_lossy(&told.stderr));
    String::from_utf8(told.stdout).unwrap()
}

/// Every example that the page offers has the JSON of the command line, to the last digit.
#[test]
fn answers_are_those_of_the_command_line_to_the_last_digit() {
    let page = Page::open(&[]);
    let start = page.ask("start", &json!({}));
    let examples = start["examples"].as_array().unwrap();
    assert!(examples.len() >= 14);
    let mut solved = 0;
    for example in examples {
        let (name, toml) = (example["name"].as_str().unwrap(), example["toml"].as_str().unwrap());
        if toml.contains("[study]") || toml.contains("[equation]") {
            continue;
        }
        let question =
            json!({ "name": name, "toml": toml, "files": example["files"], "audit": true });
        let told = page.ask("solve", &question);
        let printed: Value =
            serde_json::from_str(&run(&["solve", name, "--format", "json", "-q"])).unwrap();
        assert_eq!(told["answer"], printed, "{name}");
        solved += 1;
        let table = run(&["solve", name, "-q"]);
        for row in told["table"].as_array().unwrap() {
            let value = row[1].as_str().unwrap();
            // What is long is set on several lines.
            assert!(value.len() > 24 || table.contains(value), "{name}: {value}");
        }
        // Cards show values of the table.
        for card in told["cards"].as_array().unwrap() {
            let (key, value) = (card["key"].as_str().unwrap(), card["value"].as_str().unwrap());
            let is_in_table =
                matches!(key, "settlement" | "tilt" | "force" | "moment" | "peak_pressure");
            assert!(
                !is_in_table || value == "infinite" || table.contains(value),
                "{name}: {key} {value}"
            );
        }
    }
    assert!(solved >= 10, "{solved}");
}

/// What stays is drawn as finely as it bends: the picture reaches the largest pressure that is told.
#[test]
fn the_picture_of_an_answer_that_stays_reaches_its_largest_pressure() {
    // Some seconds of a processor without optimisation, on a machine that may be busy.
    let page = Page::open(&["--time-limit", "1 min"]);
    let toml = PUNCH.replace("x^2 / (2*20)", "1e-6*cos(30*pi*xi)").replace("0.8 MN/m", "50 kN/m");
    assert_ne!(toml, PUNCH);
    let told =
        page.ask("solve", &json!({ "name": "p.toml", "toml": toml, "files": {}, "audit": true }));
    let drawn = told["picture"]["pressure"].as_array().unwrap();
    let largest = drawn.iter().filter_map(Value::as_f64).fold(0.0, f64::max);
    let peak = told["answer"]["physical"]["peak_pressure"].as_f64().unwrap();
    assert!(largest > 0.99 * peak && largest <= 1.001 * peak, "{largest:e} {peak:e}");
}

#[test]
fn spectra_tables_and_curves_are_those_of_the_command_line() {
    let page = Page::open(&[]);
    let question =
        json!({ "name": "power", "parameters": { "a": 1.0, "mu": 0.3 }, "count": 6, "drawn": 3 });
    let told = page.ask("kernel", &question);
    let printed =
        run(&["spectrum", "power", "--a", "1", "--mu", "0.3", "--count", "6", "--format", "json"]);
    let printed: Value = serde_json::from_str(&printed).unwrap();
    assert_eq!(told["spectrum"], printed);
    assert_eq!(told["functions"].as_array().unwrap().len(), 3);

    let told = page.ask("paper", &json!({}));
    let printed: Value = serde_json::from_str(&run(&["reproduce", "--format", "json"])).unwrap();
    assert_eq!((&told["agreeing"], &told["total"]), (&json!(143), &json!(144)));
    for (one, other) in
        told["figures"].as_array().unwrap().iter().zip(printed["figures"].as_array().unwrap())
    {
        assert_eq!((&one["exact"], &one["printed"]), (&other["exact"], &other["printed"]));
    }

    // For a lambda0 of the paper the curve is that of its figure.
    let told = page.ask("curve", &json!({ "lambda0": 10.0 }));
    let figure = shtaerman::paper::figure2(301).unwrap();
    let ten = figure.iter().find(|curve| curve.lambda0 == 10.0).unwrap();
    assert_eq!(told["exact"], json!(ten.exact));
    assert_eq!(told["as_printed"], json!(ten.as_printed));
}

#[test]
fn stresses_are_those_of_the_command_line() {
    let page = Page::open(&[]);
    let question = json!({ "name": "x.toml", "toml": PUNCH, "component": "von-mises", "points": [31, 21], "peaks": true });
    let told = page.ask("map", &question);
    let printed = run(&["stress", "crowned_punch.toml", "--grid", "31x21", "--format", "json"]);
    let printed: Value = serde_json::from_str(&printed).unwrap();
    assert_eq!(told["von_mises"]["si"], printed["maximum"]["von_mises"]["value"]);
    assert_eq!(told["max_shear"]["si"], printed["maximum"]["max_shear"]["value"]);
    let rows = printed["grid"]["von_mises"].as_array().unwrap().iter();
    let flat: Vec<&Value> = rows.flat_map(|row| row.as_array().unwrap()).collect();
    let shown: Vec<&Value> = told["values"].as_array().unwrap().iter().collect();
    assert_eq!(shown, flat);
}

#[test]
fn the_file_that_it_was_opened_with_comes_with_its_trace() {
    let path = examples().join("measured_profile.toml");
    let page = Page::open(&[path.to_str().unwrap()]);
    let start = page.ask("start", &json!({}));
    let file = &start["file"];
    assert_eq!(file["name"], "measured_profile.toml");
    let trace = file["files"]["measured_profile.csv"].as_str().unwrap();
    assert_eq!(trace, std::fs::read_to_string(examples().join("measured_profile.csv")).unwrap());
    let told = page.ask("solve", file);
    assert!(told["answer"].is_object(), "{told}");
}

#[test]
fn a_fault_is_told_with_its_place() {
    let page = Page::open(&[]);
    let toml = PUNCH.replace("x^2 / (2*20)", "x^^2");
    let told = page.ask("solve", &json!({ "name": "punch.toml", "toml": toml }));
    let fault = &told["fault"];
    assert_eq!(fault["field"], "punch.profile");
    assert_eq!(fault["exit_code"], 2);
    let line = 1 + toml.lines().position(|line| line.contains("x^^2")).unwrap();
    assert_eq!(fault["line"], line);
    assert!(fault["message"].as_str().unwrap().contains("punch.toml:13: punch.profile"), "{fault}");
    let read = page.ask("read", &json!({ "name": "punch.toml", "toml": toml }));
    assert_eq!(read["tree"]["punch"]["profile"], "x^^2");
    assert_eq!(read["fault"]["field"], "punch.profile");
    assert_eq!(read["inputs"]["punch.half_width"], 0.005);
}

/// What is doubtful about a file is told beside the fault of its solve, in the words of the command line.
#[test]
fn doubts_are_told_where_there_is_no_answer() {
    let doubtful =
        PUNCH.replace("\"200 GPa\"", "200").replace("[solver]", "[solver]\ntolerance = 1e-30");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.toml");
    std::fs::write(&path, &doubtful).unwrap();
    let told = Command::new(PROGRAM).arg("solve").arg(&path).output().unwrap();
    let printed = String::from_utf8(told.stderr).unwrap();
    let warning = printed.lines().find_map(|line| line.strip_prefix("warning: ")).unwrap();
    let page = Page::open(&[]);
    let told = page.ask("solve", &json!({ "name": "x.toml", "toml": doubtful }));
    assert!(told["fault"]["message"].is_string(), "{told}");
    let doubt = json!([{ "code": "soft_modulus", "message": warning }]);
    assert_eq!(told["warnings"], doubt);
    let sound = doubtful.replace("young_modulus = 200", "young_modulus = \"200 GPa\"");
    let told = page.ask("solve", &json!({ "name": "x.toml", "toml": sound }));
    assert_eq!(told["warnings"], json!([]), "{told}");
}
