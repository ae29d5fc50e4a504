//! Every example and both forms of `init`: they solve, and files and answers are what the schemas say.

use std::path::Path;

use crate::cli::support::{
    DIMENSIONLESS, Folder, PHYSICAL, assert_valid, number, repository, schema, toml_as_json,
};

/// The problem files of `examples/`.
fn examples() -> Vec<String> {
    all_examples().into_iter().filter(|name| !name.starts_with("equation_")).collect()
}

/// The equation files of `examples/`.
fn equations() -> Vec<String> {
    all_examples().into_iter().filter(|name| name.starts_with("equation_")).collect()
}

fn all_examples() -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(repository().join("examples"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".toml"))
        .collect();
    names.sort();
    names
}

/// A folder with a copy of `examples/`, so that the commands of the headings run as they are written.
pub(crate) fn copy() -> Folder {
    let folder = Folder::new();
    copy_folder(&repository().join("examples"), &folder.path("examples"));
    folder
}

fn copy_folder(from: &Path, to: &Path) {
    std::fs::create_dir(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let place = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy_folder(&entry.path(), &place);
        } else {
            std::fs::copy(entry.path(), place).unwrap();
        }
    }
}

#[test]
fn there_is_an_example_of_each_kind() {
    let names = examples();
    for name in ["flat_punch", "crowned_punch", "eccentric_load", "measured_profile"] {
        assert!(names.contains(&format!("{name}.toml")), "{names:?}");
    }
}

#[test]
fn equations_solve_and_their_answers_match_the_schema() {
    let schema = schema("equation");
    let folder = copy();
    let names = equations();
    assert!(names.len() >= 4, "{names:?}");
    for name in names {
        let path = format!("examples/{name}");
        let said = folder.run(&["validate", &path]).answer();
        assert!(said.contains("valid; equation of the"), "{said}");
        let json = folder.run(&["equation", &path, "--format", "json"]).json();
        assert_valid(&schema, &json, &name);
        assert_eq!(json["warnings"], serde_json::json!([]), "{name}");
    }
    // The settlement that the heading of the disk names makes the load 1/2.
    let path = "examples/equation_rough_disk.toml";
    let json = folder.run(&["equation", path, "--format", "json", "--at", "0,1"]).json();
    assert!((number(&json, "/integral") - 0.5).abs() < 1e-9);
    assert!((number(&json, "/solution/phi/0") - 0.808_772_459_8).abs() < 1e-9);
    assert!((number(&json, "/solution/phi/1") - 1.358_299_533).abs() < 1e-9);
}

#[test]
fn examples_solve_and_match_their_schemas() {
    let (problem, answer) = (schema("problem"), schema("answer"));
    let folder = copy();
    for name in examples() {
        let path = format!("examples/{name}");
        let text = folder.read(&path);
        assert_valid(&problem, &toml_as_json(&text), &name);
        let json = folder.run(&["solve", &path, "--format", "json"]).json();
        assert_valid(&answer, &json, &name);
        // Force and moment belong to the pressure curve: trapezoids on 201 points, dense at the edges.
        let mean = number(&json, "/dimensionless/mean_pressure");
        let (inner, is_circular) = (text.contains("inner_half_gap"), text.contains("circular"));
        // Half-gap 300 mm of a half-width of 400 mm.
        let base = if is_circular {
            std::f64::consts::PI
        } else if inner {
            0.5
        } else {
            2.0
        };
        let force = number(&json, "/dimensionless/force");
        assert!((mean - force / base).abs() <= 1e-15 * mean.abs());
        let list = |key: &str| -> Vec<f64> {
            json["pressure"][key].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
        };
        let (x, p) = (list("x"), list("pressure"));
        let force =
            if json["physical"].is_null() { "/dimensionless/force" } else { "/physical/force" };
        // Of a disk along its diameter: each ring is met twice.
        let ring = |x: f64| if is_circular { std::f64::consts::PI * x.abs() } else { 1.0 };
        let weighed: Vec<f64> = x.iter().zip(&p).map(|(x, p)| ring(*x) * p).collect();
        let integral: f64 =
            (1..x.len()).map(|i| 0.5 * (weighed[i] + weighed[i - 1]) * (x[i] - x[i - 1])).sum();
        let scale = weighed.iter().fold(0.0f64, |most, p| most.max(p.abs())) * (x[200] - x[0]);
        assert!((integral - number(&json, force)).abs() < 1e-3 * scale, "{name}: {integral}");
    }
}

#[test]
fn the_command_of_each_heading_runs() {
    for name in all_examples() {
        let folder = copy();
        let text = folder.read(&format!("examples/{name}"));
        let commands: Vec<&str> =
            text.lines().filter_map(|line| line.strip_prefix("#   shtaerman ")).collect();
        assert!(!commands.is_empty(), "{name} names no command");
        assert!(text.contains("# What one learns:"), "{name}");
        for command in commands {
            let arguments: Vec<String> =
                command.split(' ').map(|argument| argument.replace('"', "")).collect();
            let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
            let table = folder.run(&arguments).answer();
            let words = match arguments[0] {
                "solve" => ["settlement", "tilt"],
                "equation" => ["int phi", "phi("],
                "export" => ["** Units: N, mm, MPa", "0., 0."],
                _ => ["eigenvalue", "bilinear sum"],
            };
            assert!(words.iter().all(|word| table.contains(word)), "{command}: {table}");
            if let Some(at) = arguments.iter().position(|argument| *argument == "--plot") {
                let plot = arguments[at + 1];
                assert!(table.contains(&format!("plot: {plot}")), "{command}: {table}");
                assert!(folder.read(plot).contains("<svg"), "{command}");
            }
        }
    }
}

/// The blocks of the README between fences of this kind.
fn readme_blocks(kind: &str) -> Vec<String> {
    let readme = std::fs::read_to_string(repository().join("README.md")).unwrap();
    let fence = format!("```{kind}\n");
    readme.split(&fence).skip(1).map(|rest| rest.split("```").next().unwrap().to_owned()).collect()
}

/// The text without the sentence whose figures are rounding: an estimate of the error at rounding level differs between processors.
fn without_errors(text: &str) -> Vec<&str> {
    let mut is_error = false;
    let lines = text.lines().filter(|line| {
        // A long line goes on behind blanks.
        is_error = line.starts_with("error (") || (is_error && line.starts_with("    "));
        !is_error
    });
    lines.collect()
}

#[test]
fn the_readme_shows_what_its_command_prints() {
    let folder = copy();
    let blocks = readme_blocks("sh");
    let command = blocks
        .iter()
        .flat_map(|block| block.lines())
        .find_map(|line| line.strip_prefix("cargo run -- "))
        .unwrap();
    let command = command.split('#').next().unwrap();
    let arguments: Vec<&str> = command.split_whitespace().collect();
    let printed = folder.run(&arguments).answer();
    let shown = readme_blocks("text");
    assert!(
        shown.iter().any(|block| without_errors(block) == without_errors(&printed)),
        "the README shows another table than\n{printed}"
    );

    let problem = schema("problem");
    for block in readme_blocks("toml") {
        if block.contains("[equation]") {
            folder.write("equation.toml", &block);
            folder.run(&["equation", "equation.toml"]).answer();
            continue;
        }
        assert_valid(&problem, &toml_as_json(&block), "README");
        folder.write("punch.toml", &block);
        folder.run(&["solve", "punch.toml"]).answer();
    }
}

/// An SVG without the sentence whose figures are rounding.
fn without_error_note(svg: &str) -> String {
    let mut parts = svg.split("error of the pressure at most ");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + part.split_once('<').map_or("", |(_, rest)| rest))
}

#[test]
fn the_picture_of_the_readme_is_made_by_the_command_beside_it() {
    let root = repository();
    let readme = std::fs::read_to_string(root.join("README.md")).unwrap();
    let shown = readme.split("](").find_map(|part| {
        let path = part.split(')').next()?;
        path.ends_with(".svg").then_some(path)
    });
    let picture = std::fs::read_to_string(root.join(shown.unwrap())).unwrap();
    let command = readme.lines().find_map(|line| line.strip_prefix("cargo run -- ")).unwrap();
    let command = command.split('#').next().unwrap();
    let arguments: Vec<&str> = command.split_whitespace().collect();
    let folder = copy();
    folder.run(&arguments).answer();
    let drawn = folder.read(arguments.last().unwrap());
    assert_eq!(without_error_note(&drawn), without_error_note(&picture));
    assert!(drawn.contains("error of the pressure at most "));
}

#[test]
fn both_forms_of_init_are_valid_and_solve() {
    let (problem, answer) = (schema("problem"), schema("answer"));
    for form in [[].as_slice(), &["--dimensionless"]] {
        let folder = Folder::new();
        let said = folder.run(&[&["init"], form].concat()).answer();
        assert!(said.contains("wrote punch.toml"), "{said}");
        let text = folder.read("punch.toml");
        assert!(
            text.lines().filter(|line| line.contains('#')).count() > 5,
            "not commented: {text}"
        );
        assert_valid(&problem, &toml_as_json(&text), "init");
        let (first, rest) = text.split_once('\n').unwrap();
        assert_eq!(first, "#:schema ./problem.schema.json");
        assert_eq!(folder.run(&[&["init", "-"], form].concat()).answer(), rest);
        let said = folder.run(&["validate", "punch.toml"]).answer();
        assert!(said.starts_with("punch.toml: valid; "), "{said}");
        let json = folder.run(&["solve", "punch.toml", "--format", "json"]).json();
        assert_valid(&answer, &json, "init");
        assert_eq!(json["physical"].is_null(), !form.is_empty());

        folder.write("punch.toml", "mine");
        let refused = folder.run(&[&["init"], form].concat());
        assert!(refused.refusal().contains("punch.toml exists already"));
        assert_eq!(folder.read("punch.toml"), "mine");
        folder.run(&[&["init", "--force"], form].concat()).answer();
        assert_eq!(folder.read("punch.toml"), text);
    }
}

/// The schema of problem files is strict: what the program refuses for its keys, the schema refuses as well.
#[test]
fn the_schema_of_problems_refuses_what_the_program_refuses() {
    let schema = schema("problem");
    for text in [PHYSICAL, DIMENSIONLESS] {
        assert_valid(&schema, &toml_as_json(text), text);
    }
    for (problem, from, to) in [
        (PHYSICAL, "half_width", "half_witdh"),
        (PHYSICAL, "young_modulus = \"200 GPa\"\n", ""),
        (PHYSICAL, "poisson_ratio = 0.3", "poisson_ratio = 0.51"),
        (PHYSICAL, "\"5 mm\"", "0"),
        (PHYSICAL, "\"200 GPa\"", "\"-200 GPa\""),
        (PHYSICAL, "\"1.2e-14 m/Pa\"", "-1"),
        (PHYSICAL, "\"1.2e-14 m/Pa\"", "{ coefficient = 1e-9, exponent = 0 }"),
        (PHYSICAL, "\"1.2e-14 m/Pa\"", "{ displacement = 1e-6, exponent = 0.5 }"),
        (PHYSICAL, "half_width = ", "geometry = \"circular\"\nhalf_width = "),
        (PHYSICAL, "half_width = ", "geometry = \"pair\"\nouter_half_width = "),
        (DIMENSIONLESS, "theta0 = 13.0", "theta0 = 13.0\ngeometry = \"periodic\"\nperiod = 1.0"),
        (PHYSICAL, "roughness = \"1.2e-14 m/Pa\"\n", ""),
        (PHYSICAL, "force = \"0.8 MN/m\"\n", ""),
        (PHYSICAL, "force = ", "settlement = 1e-6\nforce = "),
        (PHYSICAL, "moment = ", "tilt = 0\nmoment = "),
        (PHYSICAL, "\"bilateral\"", "\"unilateral\""),
        (PHYSICAL, "\"bilateral\"", "\"full\""),
        (PHYSICAL, "n = 40", "n = 0"),
        (PHYSICAL, "n = 40", "n = \"many\""),
        (PHYSICAL, "[solver]", "[dimensionless]\ntheta0 = 1.0\n[solver]"),
        (PHYSICAL, "\"x^2 / (2*20)\"", "{ x_unit = \"mm\" }"),
        (DIMENSIONLESS, "theta0 = 13.0", "theta0 = -1.0"),
        (DIMENSIONLESS, "theta0 = 13.0", "theta0 = 1.0\nlambda0 = 1.0"),
        (DIMENSIONLESS, "theta0 = 13.0", "theta0 = 1.0\npoisson_ratio = 0.3"),
        (DIMENSIONLESS, "theta0 = 13.0", "lambda0 = 1.0"),
        (DIMENSIONLESS, "theta0 = 13.0\n", ""),
        (DIMENSIONLESS, "\"xi^4 - xi/2\"", "{ csv = \"p.csv\", x_unit = \"mm\" }"),
    ] {
        let text = problem.replace(from, to);
        assert_ne!(text, problem, "{from}");
        assert!(!schema.is_valid(&toml_as_json(&text)), "the schema takes {to:?} for {from:?}");
        let folder = Folder::with(&text);
        folder.write("p.csv", "-1,0\n1,0\n");
        folder.run(&["validate", "punch.toml"]).refusal();
    }
}
