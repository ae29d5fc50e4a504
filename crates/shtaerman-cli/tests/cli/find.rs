//! `find`: inverse problems from the command line.

use serde_json::Value;

use crate::cli::support::{
    DIMENSIONLESS, Folder, PHYSICAL, UNILATERAL, assert_valid, number, schema,
};

fn find(folder: &Folder, arguments: &[&str]) -> Value {
    let all = [&["find"], arguments, &["--format", "json"]].concat();
    let json = folder.run(&all).json();
    assert_valid(&schema("find"), &json, &arguments.join(" "));
    json
}

/// `solve` with the keys that `find` gave.
fn solved(folder: &Folder, found: &Value) -> Value {
    let set = found["set"].as_object().unwrap();
    let toml = |value: &Value| match value.as_object() {
        Some(table) => {
            let pairs: Vec<String> =
                table.iter().map(|(key, value)| format!("{key} = {value}")).collect();
            format!("{{ {} }}", pairs.join(", "))
        }
        None => value.to_string(),
    };
    let pairs: Vec<String> =
        set.iter().map(|(key, value)| format!("{key}={}", toml(value))).collect();
    let mut arguments = vec!["solve", "punch.toml", "--format", "json"];
    for pair in &pairs {
        arguments.extend(["--set", pair]);
    }
    folder.run(&arguments).json()
}

#[track_caller]
fn close(found: f64, exact: f64, tolerance: f64) {
    assert!((found / exact - 1.0).abs() < tolerance, "{found} for {exact}");
}

#[test]
fn the_force_found_gives_what_was_wanted() {
    for problem in [UNILATERAL, PHYSICAL] {
        let folder = Folder::with(problem);
        let found = find(&folder, &["force", "punch.toml", "--peak-pressure", "350 MPa"]);
        assert_eq!(found["kept"], "eccentricity");
        assert!(number(&found, "/goal/relative_error") < 1e-11);
        let answer = solved(&folder, &found);
        close(number(&answer, "/physical/peak_pressure"), 350e6, 1e-10);
        close(number(&answer, "/physical/force"), number(&found, "/value"), 1e-15);
        let eccentricity = |json: &Value, table: &str| {
            number(json, &format!("/{table}/moment")) / number(json, &format!("/{table}/force"))
        };
        close(eccentricity(&answer, "physical"), 100.0 / 0.8e6, 1e-14);
    }
    let crowned = UNILATERAL.replace("(2*20)", "(2*0.5)");
    let folder = Folder::with(&crowned.replace("moment = \"100 N\"", "tilt = \"10 urad\""));
    let found = find(&folder, &["force", "punch.toml", "--contact-width", "4 mm"]);
    assert_eq!(found["kept"], "tilt");
    close(number(&solved(&folder, &found), "/physical/contact_width"), 4e-3, 1e-10);
    let table = folder.run(&["find", "force", "punch.toml", "--contact-width", "4 mm"]).answer();
    for said in
        ["a contact width of 4 mm, keeping the tilt", "set: load.force = ", "MPa", "reached: 4 mm"]
    {
        assert!(table.contains(said), "{said}: {table}");
    }
    let csv =
        folder.run(&["find", "force", "punch.toml", "--contact-width", "4 mm", "--format", "csv"]);
    let csv = csv.answer();
    assert!(
        csv.starts_with("unknown,value,quantity,wanted,reached,relative_error\nforce,"),
        "{csv}"
    );
}

#[test]
fn a_dimensionless_file_has_its_numbers() {
    let folder = Folder::with(DIMENSIONLESS);
    let found = find(&folder, &["force", "punch.toml", "--peak-pressure", "9.5"]);
    assert_eq!(found["units"], "dimensionless");
    close(number(&solved(&folder, &found), "/dimensionless/peak_pressure"), 9.5, 1e-10);
    let table = folder.run(&["find", "force", "punch.toml", "--peak-pressure", "9.5"]).answer();
    assert!(table.contains("set: dimensionless.force = "), "{table}");
    let crown = find(&folder, &["crown", "punch.toml"]);
    assert!(crown["set"]["dimensionless.profile"].is_string());
}

#[test]
fn the_roughness_found_gives_what_was_measured() {
    let crowned = UNILATERAL.replace("(2*20)", "(2*0.5)");
    let power = crowned.replace(
        "\"1.2e-14 m/Pa\"",
        "{ displacement = \"0.1 um\", pressure = \"100 MPa\", exponent = 0.5 }",
    );
    let subgrade =
        crowned.replace("roughness = \"1.2e-14 m/Pa\"", "subgrade_modulus = \"80 MPa/um\"");
    for (problem, options) in [
        (&crowned, ["--settlement", "9 um", "/physical/settlement"]),
        (&crowned, ["--contact-width", "5 mm", "/physical/contact_width"]),
        (&subgrade, ["--peak-pressure", "150 MPa", "/physical/peak_pressure"]),
        (&power, ["--contact-width", "5 mm", "/physical/contact_width"]),
    ] {
        let folder = Folder::with(problem);
        let arguments =
            ["find", "roughness", "punch.toml", options[0], options[1], "--format", "json"];
        let run = folder.run(&arguments);
        // A power law is found once it is solved.
        if problem == &power && run.code != Some(0) {
            continue;
        }
        let found = run.json();
        assert_valid(&schema("find"), &found, options[0]);
        let answer = solved(&folder, &found);
        close(number(&answer, options[2]), number(&found, "/goal/wanted"), 1e-9);
        let table = folder.run(&arguments[..5]).answer();
        assert!(table.contains("set: foundation.roughness = "), "{table}");
    }
}

#[test]
fn crowns_keep_the_limit() {
    let folder = Folder::with(UNILATERAL);
    let lowest = find(&folder, &["crown", "punch.toml"]);
    assert!(lowest["limit"].is_null() && lowest["least"].is_null());
    let peak = number(&lowest, "/best/contact/peak_pressure");
    close(number(&solved(&folder, &lowest), "/physical/peak_pressure"), peak, 1e-12);
    let limit = format!("{} MPa", 1.1 * peak / 1e6);
    let found = find(&folder, &["crown", "punch.toml", "--peak-pressure", &limit]);
    let radius = |name: &str| number(&found, &format!("/{name}/radius"));
    assert!(radius("least") < radius("best") && radius("best") < radius("largest"));
    for name in ["least", "largest"] {
        let set = format!("punch.profile={}", found[name]["profile"]);
        let answer = folder.run(&["solve", "punch.toml", "--format", "json", "--set", &set]).json();
        close(number(&answer, "/physical/peak_pressure"), 1.1 * peak, 1e-9);
    }
    let table = folder.run(&["find", "crown", "punch.toml", "--peak-pressure", "5 GPa"]).answer();
    assert!(
        table.contains("flat base") && table.contains("set: punch.profile = \"x^2/"),
        "{table}"
    );
    let csv = folder.run(&["find", "crown", "punch.toml", "--format", "csv"]).answer();
    assert_eq!(csv.lines().count(), 2, "{csv}");
}

#[test]
fn the_trace_gives_the_pressure_back() {
    let folder = Folder::with(&UNILATERAL.replace("100 N", "0 N"));
    let arguments = ["find", "profile", "punch.toml", "--pressure", "1", "--format", "csv"];
    let printed = folder.run(&arguments).answer();
    folder.run(&[arguments.as_slice(), &["--output", "f.csv"]].concat()).answer();
    assert_eq!(folder.read("f.csv"), printed);
    assert!(printed.starts_with("x,f\n-0.005,"), "{printed}");
    let set = "punch.profile={ csv = \"f.csv\" }";
    let answer = folder.run(&["solve", "punch.toml", "--set", set, "--format", "json"]).json();
    for p in answer["pressure"]["pressure"].as_array().unwrap() {
        close(p.as_f64().unwrap(), 80e6, 1e-4);
    }
    let json = find(&folder, &["profile", "punch.toml", "--pressure", "1", "--points", "33"]);
    assert_eq!(json["profile"]["x"].as_array().unwrap().len(), 33);
    close(number(&json, "/settlement"), number(&answer, "/physical/settlement"), 1e-6);
    let table = folder.run(&arguments[..5]).answer();
    assert!(table.contains("80 MPa") && table.contains("punch.profile = { csv = "), "{table}");
    let lowest =
        find(&folder, &["profile", "punch.toml", "--pressure", "2-cos(3*xi)", "--zero", "lowest"]);
    let heights = lowest["profile"]["f"].as_array().unwrap();
    assert!(heights.iter().all(|f| f.as_f64().unwrap() >= 0.0));
}

#[test]
fn bad_wishes_are_refused() {
    for (arguments, said) in [
        (["force", "--peak-pressure", "-350 MPa"].as_slice(), "must be greater than zero"),
        (&["force", "--peak-pressure", "0"], "must be greater than zero"),
        (&["force", "--peak-pressure", "nan"], "nan"),
        (&["force", "--peak-pressure", "350 mm"], "is a pressure"),
        (&["force", "--peak-pressure", "much"], "does not begin with a number"),
        (
            &["force", "--contact-width", "20 mm"],
            "no force gives a contact width of 20 mm: it can be from",
        ),
        (&["roughness", "--contact-width", "-1 mm"], "must be greater than zero"),
        (
            &["roughness", "--settlement", "1 nm"],
            "no roughness gives a settlement of 1 nm: it can be from",
        ),
        (&["roughness", "--settlement", "1 MPa"], "is a length"),
        (
            &["crown", "--peak-pressure", "79 MPa"],
            "no crown keeps the peak pressure at 79 MPa or below",
        ),
        (&["crown", "--peak-pressure", "0"], "must be greater than zero"),
        (&["profile", "--pressure", "1 - 2*xi^2"], "the prescribed pressure"),
        (&["profile", "--pressure", "1/xi"], "must be finite"),
        (&["profile", "--pressure", "0"], "carries no force"),
        (&["profile", "--pressure", "1 +"], "`1 +`"),
        (&["profile", "--pressure", "1"], "acts at an eccentricity of 0 m, the load at 125 µm"),
        (&["profile", "--pressure", "1", "--points", "1"], "--points 1"),
    ] {
        let folder = Folder::with(UNILATERAL);
        let all =
            [&["find", arguments[0], "punch.toml"], &arguments[1..], &["--output", "out.txt"]];
        let run = folder.run(&all.concat());
        let message = run.refusal();
        assert!(message.contains(said), "{arguments:?}: {message}");
        assert_eq!(folder.files(), ["punch.toml"]);
    }
    let folder = Folder::with(UNILATERAL);
    for arguments in [
        ["force", "punch.toml"].as_slice(),
        &["force", "punch.toml", "--peak-pressure", "1 MPa", "--contact-width", "1 mm"],
        &["profile", "punch.toml"],
        &["weight", "punch.toml"],
        &["crown", "nowhere.toml"],
    ] {
        assert_eq!(folder.run(&[&["find"], arguments].concat()).code, Some(2), "{arguments:?}");
    }
    let bare = Folder::with(DIMENSIONLESS);
    let run = bare.run(&["find", "roughness", "punch.toml", "--contact-width", "1"]);
    assert!(run.refusal().contains("a dimensionless problem has no roughness"));
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let folder = Folder::with(UNILATERAL);
    let arguments = ["find", "crown", "punch.toml", "--peak-pressure", "5 GPa", "--format", "json"];
    assert_eq!(folder.run(&arguments).answer(), folder.run(&arguments).answer());
}
