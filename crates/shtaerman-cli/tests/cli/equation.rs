//! `equation`: solutions of both kinds against solutions by other methods and closed forms.

use serde_json::Value;

use crate::cli::support::{Folder, assert_valid, number, schema};

/// An equation of the second kind on the logarithmic kernel; line numbers of tests count in it.
pub(crate) const SECOND: &str = r#"[equation]
kind = "second"
lambda = 1.0
rhs = "1 + x"

[kernel]
name = "log"
a = 1.0
"#;

/// An equation of the first kind.
pub(crate) const FIRST: &str = r#"[equation]
kind = "first"
rhs = "1"

[kernel]
name = "log"
a = 1.0
"#;

/// An equation file: `lambda` of the second kind, or none; the right-hand side; the lines of the kernel.
pub(crate) fn file(lambda: Option<f64>, rhs: &str, kernel: &str) -> String {
    let kind = match lambda {
        Some(lambda) => format!("kind = \"second\"\nlambda = {lambda:?}"),
        None => "kind = \"first\"".to_owned(),
    };
    format!("[equation]\n{kind}\nrhs = \"{rhs}\"\n[kernel]\n{kernel}\n")
}

/// The JSON answer at places, checked against the schema.
#[track_caller]
pub(crate) fn answer(text: &str, places: &[f64], more: &[&str]) -> Value {
    let folder = Folder::new();
    folder.write("e.toml", text);
    let at: Vec<String> = places.iter().map(f64::to_string).collect();
    let at = format!("--at={}", at.join(","));
    let arguments = [&["equation", "e.toml", "--format", "json", &at], more].concat();
    let json = folder.run(&arguments).json();
    assert_valid(&schema("equation"), &json, text);
    json
}

fn floats(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

/// The kernel of a reference as the lines of a file.
fn lines(kernel: &Value) -> String {
    let pairs = kernel.as_object().unwrap().iter();
    pairs.map(|(key, value)| format!("{key} = {value}\n")).collect()
}

#[test]
fn every_kernel_agrees_with_solutions_by_other_methods() {
    let data: Value = serde_json::from_str(include_str!("../data/equations.json")).unwrap();
    let cases = data["cases"].as_array().unwrap();
    let mut names: Vec<&str> = Vec::new();
    for case in cases {
        let kernel = &case["kernel"];
        names.push(kernel["name"].as_str().unwrap());
        let text = file(case["lam"].as_f64(), case["rhs"].as_str().unwrap(), &lines(kernel));
        let (x, exact) = (floats(&case["x"]), floats(&case["phi"]));
        let json = answer(&text, &x, &[]);
        assert_eq!(&json["kernel"], kernel);
        assert_eq!(floats(&json["solution"]["x"]), x);
        let largest = exact.iter().fold(0.0f64, |most, phi| most.max(phi.abs()));
        let digits = if kernel["interval"].is_null() { 1e-11 } else { 1e-9 };
        let stated = number(&json, "/error/solution_sup");
        for (x, (phi, exact)) in x.iter().zip(floats(&json["solution"]["phi"]).iter().zip(&exact)) {
            let error = (phi - exact).abs();
            assert!(error <= digits * largest, "{text}phi({x}) = {phi} for {exact}: {error:.1e}");
            // The references are good to 1e-12, by their own account.
            assert!(
                error <= stated + 2e-12 * largest,
                "{text}{error:.1e} at {x}, stated {stated:.1e}"
            );
        }
        match case["integral"].as_f64() {
            Some(exact) => {
                let error = (number(&json, "/integral") - exact).abs();
                assert!(error <= digits * exact.abs().max(largest), "{text}integral: {error:.1e}");
            }
            // f = 1 on a half-line: the solution does not decay.
            None => {
                assert!(json["integral"].is_null() && json["error"]["integral"].is_null());
                assert_eq!(json["warnings"][0]["code"], "no_integral");
            }
        }
    }
    names.sort_unstable();
    names.dedup();
    assert_eq!(names, ["log-ratio", "log-sine", "macdonald", "power", "weber-sonine", "yukawa"]);
}

/// `phi = 1` solves the equation with `f = 1 + lambda [2 - (1+x) ln(1+x) - (1-x) ln(1-x)]`.
#[test]
fn a_manufactured_solution_of_the_logarithm() {
    let plus = "where(x <= -1, 0, (1 + x)*ln(1 + x))";
    let minus = "where(x >= 1, 0, (1 - x)*ln(1 - x))";
    let rhs = format!("1 + 0.7*(2 - {plus} - {minus})");
    let json =
        answer(&file(Some(0.7), &rhs, "name = \"log\"\na = 1"), &[-1.0, -0.4, 0.0, 1.0], &[]);
    for phi in floats(&json["solution"]["phi"]) {
        assert!((phi - 1.0).abs() < 1e-11, "{phi}");
    }
    assert!((number(&json, "/integral") - 2.0).abs() < 1e-11);
}

/// Splitting the plain logarithm by parity gives the companion of kernel 2 and its limit on half of the interval.
#[test]
fn parities_of_the_logarithm_are_other_kernels() {
    for (name, rhs, parameters) in
        [("log-square", "cos(2*x)", "b = 0.0\n"), ("log-ratio-limit", "sin(2*x) + x", "")]
    {
        let x = [0.0, 0.2, 0.9, 1.3];
        let whole = answer(&file(Some(0.8), rhs, "name = \"log\"\na = 1.3"), &x, &[]);
        let kernel = format!("name = \"{name}\"\na = 1.3\n{parameters}");
        let half = answer(&file(Some(0.8), rhs, &kernel), &x, &[]);
        let pairs =
            floats(&whole["solution"]["phi"]).into_iter().zip(floats(&half["solution"]["phi"]));
        for ((one, other), x) in pairs.zip(x) {
            assert!((one - other).abs() < 1e-11, "{name}, phi({x}): {one} and {other}");
        }
        if name == "log-square" {
            let (one, other) = (number(&whole, "/integral"), number(&half, "/integral"));
            assert!((one - 2.0 * other).abs() < 1e-11);
        }
    }
}

const KERNELS: [&str; 10] = [
    "name = \"log\"\na = 0.8",
    "name = \"log-ratio\"\na = 2.0\nb = 0.5",
    "name = \"log-ratio-limit\"\na = 2.0",
    "name = \"log-square\"\na = 1.0\nb = 0.2",
    "name = \"log-sine\"\nalpha = \"120 deg\"",
    "name = \"power\"\na = 1.0\nmu = 0.4",
    "name = \"macdonald\"\na = 1.0\nmu = 0.1\nkappa = 2.0",
    "name = \"weber-sonine\"\na = 1.0\nmu = 1.0\ngamma = 0.1",
    "name = \"yukawa\"\na = 1.0\nchi0 = 2.0\nm = 1",
    "name = \"macdonald\"\ninterval = \"half-line\"\nmu = -0.2\nkappa = 1.0",
];

/// Both methods on every kernel, and on the logarithm as a guaranteed bound.
#[test]
fn both_methods_agree_within_their_errors() {
    for kernel in &KERNELS[..9] {
        // Of the disks the first harmonic: natural right-hand sides vanish at the centre.
        let text = file(Some(0.7), "x*(1 + x^2/3)", kernel);
        for method in ["sinc", "spectral"] {
            let set = format!("solver.method={method}");
            let json = answer(&text, &[0.6], &["--cross-check", "--set", &set]);
            assert_eq!(json["method"]["name"], method);
            assert_ne!(json["cross_check"]["method"], method);
            assert_eq!(json["cross_check"]["agrees"], true);
            let enclosed = ["\"log\"", "\"log-square\"", "\"log-sine\"", "\"power\""];
            let bound = enclosed.iter().any(|name| kernel.contains(name));
            assert_eq!(json["error"]["kind"], if bound { "bound" } else { "estimate" });
            let table = Folder::new();
            table.write("e.toml", &text);
            let table = table.run(&["equation", "e.toml", "--cross-check", "--set", &set]).answer();
            assert!(table.contains("cross-check by the"), "{table}");
        }
    }
    // No bound for a negative parameter, nor where a long interval spoils it.
    let set = "solver.method=spectral";
    let json = answer(&SECOND.replace("1.0\nrhs", "-0.4\nrhs"), &[0.0], &["--set", set]);
    assert_eq!(json["error"]["kind"], "estimate");
}

/// A kink or a jump of the right-hand side is a border of panels; with too many the degenerate kernel takes over.
#[test]
fn kinks_and_jumps() {
    for rhs in ["abs(x - 0.3)", "step(x + 0.2)"] {
        let text = file(Some(2.0), rhs, "name = \"power\"\na = 1.0\nmu = 0.3");
        let json = answer(&text, &[-1.0, -0.5, 0.9], &["--cross-check"]);
        assert!(json["method"]["reason"].as_str().unwrap().contains("1 breakpoint"), "{json}");
        // The bound holds at every number of the machine: within some units of a jump, as far as it may lie from where it is written, the potential of a power is off by their power 1 - mu.
        let jumps = rhs.starts_with("step");
        assert!(number(&json, "/error/solution_sup") < if jumps { 2e-9 } else { 1e-10 }, "{rhs}");
        let kinds: Vec<&str> = json["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|w| w["code"].as_str().unwrap())
            .collect();
        assert!(kinds.is_empty() || jumps && kinds == ["tolerance_not_met"], "{rhs}: {kinds:?}");
        let unaudited = answer(&text, &[-1.0, -0.5, 0.9], &["--no-audit"]);
        assert!(number(&unaudited, "/error/solution_sup") < 1e-11, "{rhs}");
    }
    let many = file(Some(1.0), "abs(sin(40*x))", "name = \"log\"\na = 1.0");
    let json = answer(&many, &[0.0], &["--no-audit"]);
    assert_eq!(json["method"]["name"], "spectral");
    assert!(json["method"]["reason"].as_str().unwrap().contains("breakpoints"), "{json}");
}

/// A solution is what its equation says, and so is a file with its overrides.
#[test]
fn solutions_scale_and_add() {
    let at = [-1.0, 0.3, 1.0];
    let one = answer(SECOND, &at, &[]);
    let twice = answer(SECOND, &at, &["--set", "equation.rhs=2*(1 + x)"]);
    let zero = answer(SECOND, &at, &["--set", "equation.rhs=0"]);
    let free = answer(SECOND, &at, &["--set", "equation.lambda=0"]);
    for i in 0..3 {
        let value = |json: &Value| json["solution"]["phi"][i].as_f64().unwrap();
        assert!((value(&twice) - 2.0 * value(&one)).abs() < 1e-12);
        assert_eq!(value(&zero), 0.0);
        assert!((value(&free) - (1.0 + at[i])).abs() < 1e-15);
    }
    let other = answer(SECOND, &[0.3], &["--set", "kernel.name=power", "--set", "kernel.mu=0.3"]);
    assert_eq!(other["kernel"]["name"], "power");
}

#[test]
fn outputs() {
    let folder = Folder::new();
    folder.write("e.toml", SECOND);
    let table = folder.run(&["equation", "e.toml", "--plot", "e.svg", "--at", "-1,0.5"]).answer();
    for said in [
        "e.toml: phi + lambda int K phi = f, lambda = 1, f = 1 + x",
        "int phi dx",
        "error (bound)",
        "audit (bound)",
        "plot: e.svg",
    ] {
        assert!(table.contains(said), "{table}");
    }
    let csv = folder.run(&["equation", "e.toml", "--format", "csv", "--points", "7"]).answer();
    let rows: Vec<&str> = csv.lines().collect();
    assert_eq!((rows[0], rows.len()), ("x,phi", 8));
    assert!(rows[1].starts_with("-1,") && rows[7].starts_with("1,"));
    let json = folder.run(&["equation", "e.toml", "--format", "json", "-o", "e.json"]);
    assert_eq!((json.code, json.stdout.as_str()), (Some(0), ""));
    let first = folder.read("e.json");
    folder.run(&["equation", "e.toml", "--format", "json", "-o", "e.json"]).answer();
    assert_eq!(folder.read("e.json"), first, "the same bytes");
    let piped = folder.run_with_input(&["equation", "-", "--format", "json"], SECOND).answer();
    assert_eq!(piped, first);

    folder.write("f.toml", FIRST);
    let csv =
        folder.run(&["equation", "f.toml", "--format", "csv", "--points", "3", "--plot", "f.png"]);
    let csv = csv.answer();
    let rows: Vec<&str> = csv.lines().collect();
    assert_eq!((rows[1], rows[3]), ("-1,", "1,"), "infinite values are empty fields");
    assert!(std::fs::read(folder.path("f.png")).unwrap().starts_with(b"\x89PNG"));
    let table = folder.run(&["equation", "f.toml"]).answer();
    assert!(table.contains("infinite") && table.contains("phi/w"), "{table}");
}

/// Every kernel has a curve, from end to end, and a picture of both kinds.
#[test]
fn curves_and_plots_of_every_kernel() {
    for kernel in KERNELS {
        for lambda in [Some(1.0), None] {
            let rhs = if kernel.contains("half-line") { "exp(-x)*x" } else { "x" };
            let folder = Folder::new();
            folder.write("e.toml", file(lambda, rhs, kernel));
            let arguments = ["equation", "e.toml", "--format", "json", "--plot", "e.svg"];
            let json = folder.run(&arguments).json();
            assert_valid(&schema("equation"), &json, kernel);
            let x = floats(&json["solution"]["x"]);
            assert_eq!(x.len(), 201);
            assert!(x.windows(2).all(|pair| pair[0] < pair[1]), "{kernel}");
            if kernel.contains("half-line") {
                assert_eq!((x[0], x[200]), (0.0, 12.0));
            }
            let svg = folder.read("e.svg");
            assert!(svg.contains("<svg") && !svg.contains("NaN") && !svg.contains("inf,"));
            roxmltree::Document::parse(&svg).unwrap();
        }
    }
}

#[test]
fn validate_init_and_the_other_command() {
    let folder = Folder::new();
    let said = folder.run(&["init", "--equation"]).answer();
    assert!(said.contains("wrote equation.toml") && said.contains("shtaerman equation"), "{said}");
    let text = folder.read("equation.toml");
    let (first, rest) = text.split_once('\n').unwrap();
    assert_eq!(first, "#:schema ./equation_file.schema.json");
    assert_eq!(folder.run(&["init", "--equation", "-"]).answer(), rest);
    folder.run(&["equation", "equation.toml"]).answer();
    let said = folder.run(&["validate", "equation.toml"]).answer();
    assert!(
        said.contains("valid; equation of the second kind, lambda = 1; power kernel"),
        "{said}"
    );
    assert!(folder.run(&["init", "--equation"]).refusal().contains("exists already"));
    folder.run(&["init", "--equation", "--dimensionless"]).refusal();
    let run = folder.run(&["solve", "equation.toml"]);
    run.refusal();
    assert!(run.stderr.contains("use `shtaerman equation`"), "{}", run.stderr);

    folder.run(&["init"]).answer();
    let run = folder.run(&["equation", "punch.toml"]);
    assert!(run.refusal().contains("has no [equation]"), "{}", run.stderr);
    assert!(run.stderr.contains("solved by `shtaerman solve`"), "{}", run.stderr);
    assert!(folder.run(&["validate", "punch.toml"]).answer().contains("physical problem"));
}

/// A dent a thousandth of the interval wide lies between the nodes of collocation and is solved; one a millionth wide between all samples, and is in the error.
#[test]
fn narrow_features_are_seen() {
    let dented = |height: f64, width: f64| {
        let rhs = format!("1+{height}*exp(-((x+0.6686)/{width:e})^2)");
        let json = answer(&file(Some(4.08), &rhs, "name = \"log\"\na = 1.0"), &[0.4], &[]);
        (number(&json, "/integral"), number(&json, "/error/integral"))
    };
    let ((plain, _), (narrow, error)) = (dented(0.0, 1.0), dented(0.3, 0.000_997));
    // The degenerate kernel of degree 400, with a guaranteed bound of 3.3e-11.
    assert!((narrow - 0.286_337_797_96).abs() < 4e-11 && error < 1e-12, "{narrow} {error:e}");
    // int phi = <A^-1 1, f>: to first order the value of a smooth function at the dent times its mass, a thousandth here.
    let (narrower, error) = dented(0.3, 0.997e-6);
    let exact = plain + 1e-3 * (narrow - plain);
    assert!((narrower - exact).abs() <= error, "{narrower} {exact} {error:e}");
}

/// Every kernel whose residual bounds the error is audited, the others say why not.
#[test]
fn audits_and_reasons() {
    for kernel in KERNELS {
        let is_half_line = kernel.contains("half-line");
        let rhs = if is_half_line { "x*exp(-x)" } else { "x*(1 + x^2/3)" };
        let text = file(Some(0.7), rhs, kernel);
        let json = answer(&text, &[0.6], &[]);
        assert_eq!(json["audit"]["kind"].is_null(), is_half_line, "{json}");
        assert_eq!(json["audit"]["reason"].is_null(), !is_half_line, "{json}");
        if !is_half_line {
            for key in ["solution_sup", "integral"] {
                let [stated, audited] =
                    ["error", "audit"].map(|part| number(&json, &format!("/{part}/{key}")));
                assert!(stated >= audited, "{json}");
            }
        }
        assert!(answer(&text, &[0.6], &["--no-audit"]).get("audit").is_none());
    }
    let log = |lambda: f64, a: f64| {
        let text = file(Some(lambda), "1", &format!("name = \"log\"\na = {a}"));
        answer(&text, &[0.1], &[])["audit"]["reason"].as_str().unwrap_or_default().to_owned()
    };
    assert!(log(-0.1, 1.0).contains("negative"));
    assert!(log(0.1, 3.0).contains("not positive"));
    assert_eq!(log(0.1, 1.9), "");
    let strong = file(Some(1.0), "1", "name = \"power\"\na = 1.0\nmu = 0.7");
    let json = answer(&strong, &[0.1], &[]);
    assert!(json["audit"]["solution_sup"].is_null() && number(&json, "/audit/integral") < 1e-9);
}

/// An answer with an error above 1 % is none unless its size or its tolerance was asked for, and it is nothing to compare with.
#[test]
fn less_than_two_digits_are_no_answer() {
    let half_line = "name = \"macdonald\"\ninterval = \"half-line\"\nmu = 0.0\nkappa = 1.0";
    let folder = Folder::new();
    folder.write("e.toml", file(Some(30.0), "cos(x)", half_line));
    folder.run(&["equation", "e.toml"]).answer();
    let run = folder.run(&["equation", "e.toml", "--cross-check"]);
    assert_eq!(run.code, Some(3), "{}", run.stdout);
    assert!(run.stderr.contains("nothing to compare with"), "{}", run.stderr);
    let spectral = ["equation", "e.toml", "--set", "solver.method=spectral"];
    assert_eq!(folder.run(&spectral).code, Some(3));
    let size = [&spectral[..], &["--set", "solver.n=100"]].concat();
    assert!(folder.run(&size).answer().contains("warning"));
}

/// On a disk `1 + x` is a cone: of the first kind its solution is infinite at the centre. `1 + x^2` is smooth, and the second kind takes both.
#[test]
fn cones_are_named() {
    let disk = "name = \"weber-sonine\"\na = 1.0\nmu = 0.0\ngamma = 0.0";
    let folder = Folder::new();
    folder.write("e.toml", file(None, "1 + x", disk));
    let run = folder.run(&["equation", "e.toml"]);
    assert_eq!(run.code, Some(2), "{}", run.stderr);
    assert!(run.stderr.contains("cone") && run.stderr.contains("equation.rhs"), "{}", run.stderr);
    folder.write("e.toml", file(None, "1 + x^2", disk));
    folder.run(&["equation", "e.toml"]).answer();
    folder.write("e.toml", file(Some(1.0), "1 + x", disk));
    folder.run(&["equation", "e.toml"]).answer();
}
