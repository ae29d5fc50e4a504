//! `shtaerman roughness`: laws from asperities, bearing curves and tables, and what it refuses.

use crate::cli::support::{Folder, assert_valid, number, schema};

const SURFACE: [&str; 9] = [
    "greenwood-williamson",
    "--deviation=0.5 um",
    "--density=1e4 1/mm^2",
    "--radius=10 um",
    "--modulus=110 GPa",
    "--hardness=4 GPa",
    "--format",
    "json",
    "--pressure=80 MPa",
];

fn arguments<'a>(more: &[&'a str]) -> Vec<&'a str> {
    [&["roughness"], more].concat()
}

#[test]
fn asperities_of_gaussian_height() {
    let folder = Folder::new();
    let json = folder.run(&arguments(&SURFACE)).json();
    assert_valid(&schema("roughness"), &json, "greenwood-williamson");
    // mpmath: F_(3/2)(h) = 80e6/((4/3) 1e10 110e9 sqrt(10e-6) (0.5e-6)^1.5) has this h, and chi = sigma/(1.5 scale F_(1/2)(h))
    let scale = 4.0 / 3.0 * 1e10 * 110e9 * 10e-6f64.sqrt() * 0.5e-6f64.powf(1.5);
    let truth = TRUTH;
    assert!((number(&json, "/state/separation") / (0.5e-6 * truth[0]) - 1.0).abs() < 1e-12);
    let chi = 0.5e-6 / (1.5 * scale * truth[1]);
    assert!((number(&json, "/state/compliance") / chi - 1.0).abs() < 1e-12);
    assert_eq!(number(&json, "/roughness"), number(&json, "/linear/coefficient"));
    assert!((number(&json, "/plasticity_index") - 110.0 / 4.0 * 0.05f64.sqrt()).abs() < 1e-12);

    let ranged =
        folder.run(&arguments(&[&SURFACE[..8], &["--range=20 MPa,200 MPa"]].concat())).json();
    assert_valid(&schema("roughness"), &ranged, "range");
    let exponent = number(&ranged, "/roughness/exponent");
    assert!(exponent > 0.0 && exponent < 0.5);
    assert!(number(&ranged, "/power/fit/relative_deviation") < 3e-3);
    assert!(number(&ranged, "/linear/fit/relative_deviation") > 0.02);
}

/// `h` and `F_(1/2)(h)` of the first test by mpmath.
const TRUTH: [f64; 2] = [1.2053596785942822, 0.07189691402179972];

#[test]
fn the_snippet_is_a_foundation_that_solves() {
    let folder = Folder::new();
    for more in [
        vec![
            "gw",
            "--deviation=0.5 um",
            "--density=1e10",
            "--radius=10 um",
            "--modulus=110 GPa",
            "--range=20 MPa,200 MPa",
        ],
        vec![
            "gw",
            "--deviation=0.5 um",
            "--density=1e10",
            "--radius=10 um",
            "--modulus=110 GPa",
            "--pressure=80 MPa",
        ],
        vec!["bearing", "--b=2", "--nu=2", "--height=6 um", "--hardness=2 GPa"],
    ] {
        let text = folder.run(&arguments(&more)).answer();
        let (_, snippet) = text.split_once("[foundation]\n").unwrap();
        folder.write(
            "punch.toml",
            format!(
                "[foundation]\nyoung_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n{snippet}\n[punch]\nhalf_width = \"5 mm\"\nprofile = \"0\"\n\n[load]\nforce = \"0.8 MN/m\"\nmoment = 0\n"
            ),
        );
        let json = folder.run(&["solve", "punch.toml", "--format=json"]).json();
        // 0.8 MN/m on 10 mm
        assert!((number(&json, "/physical/mean_pressure") / 80e6 - 1.0).abs() < 1e-9, "{text}");
    }
}

#[test]
fn bearing_curves_by_parameters_and_from_a_trace() {
    let folder = Folder::new();
    let given = [
        "bearing",
        "--b=1",
        "--nu=2",
        "--height=2 um",
        "--hardness=2 GPa",
        "--pressure=20 MPa",
        "--format=json",
    ];
    let json = folder.run(&arguments(&given)).json();
    assert_valid(&schema("roughness"), &json, "bearing");
    // p = H (v/R)^2: v = 2 um sqrt(0.01), dv/dp = v/(2p)
    assert!((number(&json, "/state/approach") / 0.2e-6 - 1.0).abs() < 1e-14);
    assert!((number(&json, "/state/compliance") / (0.2e-6 / 40e6) - 1.0).abs() < 1e-14);
    assert!((number(&json, "/state/bearing_share") - 0.01).abs() < 1e-15);

    // Cusps z = -sqrt|x| have the bearing curve (v/R)^2.
    let trace: String = (-2000..=2000)
        .map(|i| f64::from(i) / 2000.0)
        .map(|x| format!("{x};{}\n", -2.0 * x.abs().sqrt()))
        .collect();
    folder.write("trace.csv", trace);
    let traced = [
        "bearing",
        "--trace=trace.csv",
        "--position-unit=mm",
        "--height-unit=um",
        "--hardness=2 GPa",
        "--format=json",
    ];
    let json = folder.run(&arguments(&traced)).json();
    assert_valid(&schema("roughness"), &json, "trace");
    assert!((number(&json, "/curve/nu") - 2.0).abs() < 5e-3);
    assert!((number(&json, "/curve/height") / 2e-6 - 1.0).abs() < 1e-12);
    assert!((number(&json, "/power/exponent") - 0.5).abs() < 2e-3);

    let elastic = [
        "bearing",
        "--b=1",
        "--nu=1.5",
        "--height=2 um",
        "--modulus=110 GPa",
        "--radius=20 um",
        "--format=json",
    ];
    let json = folder.run(&arguments(&elastic)).json();
    assert!((number(&json, "/power/exponent") - 0.5).abs() < 1e-15);
}

#[test]
fn tables_in_both_orders() {
    let folder = Folder::new();
    // v = 0.4 um sqrt(p/10 MPa)
    let rows = |pressure_first: bool| -> String {
        (0..=20)
            .map(|i| f64::from(i) * 2.0)
            .map(|p| (0.4 * (p / 10.0f64).sqrt(), p))
            .map(|(v, p)| if pressure_first { format!("{p},{v}\n") } else { format!("{v},{p}\n") })
            .collect()
    };
    folder.write("a.csv", rows(false));
    folder.write("b.csv", rows(true));
    let units = ["--approach-unit=um", "--pressure-unit=MPa", "--format=json"];
    let one = folder.run(&arguments(&[&["table", "a.csv"], &units[..]].concat())).json();
    let two = folder
        .run(&arguments(&[&["table", "b.csv", "--columns=pressure-approach"], &units[..]].concat()))
        .json();
    assert_eq!(one, two);
    assert_valid(&schema("roughness"), &one, "table");
    assert!((number(&one, "/roughness/exponent") - 0.5).abs() < 1e-12);
    assert!((number(&one, "/roughness/coefficient") * 1e7f64.sqrt() / 0.4e-6 - 1.0).abs() < 1e-10);
    // chi of least squares: sum v p / sum p^2
    let (mut products, mut squares) = (0.0, 0.0);
    for i in 0..=20 {
        let p = 2e6 * f64::from(i);
        products += p * 0.4e-6 * (p / 1e7).sqrt();
        squares += p * p;
    }
    assert!((number(&one, "/linear/coefficient") / (products / squares) - 1.0).abs() < 1e-12);

    let csv = folder.run(&arguments(&["table", "a.csv", "--format=csv"])).answer();
    assert!(csv.starts_with("quantity,value,unit\n") && csv.contains("m/Pa^kappa"), "{csv}");
    folder.run(&arguments(&["table", "a.csv", "--output=law.txt"])).answer();
    assert!(folder.read("law.txt").contains("[foundation]\nroughness = {"));
}

#[test]
fn a_softening_table_has_a_linear_law_and_says_why() {
    let folder = Folder::new();
    folder.write("t.csv", "0,0\n1,1\n4,2\n9,3\n");
    let text = folder.run(&arguments(&["table", "t.csv", "--approach-unit=um"])).answer();
    assert!(text.contains("note: no power law") && text.contains("asperities stiffen"), "{text}");
    let run = folder.run(&arguments(&["table", "t.csv", "--approach-unit=um", "--law=power"]));
    assert!(run.refusal().contains("asperities stiffen"), "{}", run.stderr);
}

#[test]
fn more_than_the_whole_bearing_curve_is_doubted() {
    let folder = Folder::new();
    let curve = ["roughness", "bearing", "--b=2", "--nu=2", "--height=10 um", "--hardness=2 GPa"];
    let run = folder.run(&[&curve[..], &["--pressure=5 GPa"]].concat());
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(run.stdout.contains("2.50 times the bearing curve"), "{run:?}");
    let strict = folder.run(&[&curve[..], &["--pressure=5 GPa", "--strict"]].concat());
    assert_eq!(strict.code, Some(2), "{strict:?}");
    let half = folder.run(&[&curve[..], &["--pressure=1 GPa", "--strict"]].concat());
    assert_eq!(half.code, Some(0), "{half:?}");
}

#[test]
fn refusals() {
    let folder = Folder::new();
    folder.write("t.csv", "0,1\n1,1\n");
    folder.write("bad.csv", "0,0\n1,-1\n2,2\n");
    folder.write("flat.csv", "0,1\n1,1\n2,1\n");
    let gw = ["gw", "--deviation=0.5 um", "--density=1e10", "--radius=10 um", "--modulus=110 GPa"];
    let bearing = ["bearing", "--b=1", "--height=2 um"];
    let cases: [(Vec<&str>, &str); 18] = [
        ([&gw[..], &["--pressure=-1"]].concat(), "--pressure: -1 (in SI units) must be"),
        ([&gw[..], &["--pressure=1e20"]].concat(), "no asperities are left"),
        ([&gw[..], &["--pressure=5 mm"]].concat(), "--pressure `5 mm`: is a pressure"),
        ([&gw[..], &["--range=5 MPa"]].concat(), "needs two values"),
        ([&gw[..], &["--range=5 MPa,1 MPa"]].concat(), "--range: the pressure"),
        ([&gw[..], &["--pressure=1 MPa", "--law=power"]].concat(), "needs a --range"),
        ([&gw[..], &["--pressure=1 MPa", "--hardness=0"]].concat(), "--hardness: 0"),
        (
            vec![
                "gw",
                "--deviation=-1 um",
                "--density=1e10",
                "--radius=10 um",
                "--modulus=1 GPa",
                "--pressure=1",
            ],
            "--deviation: -0.000001",
        ),
        (
            vec![
                "gw",
                "--deviation=nan",
                "--density=1e10",
                "--radius=10 um",
                "--modulus=1 GPa",
                "--pressure=1",
            ],
            "--deviation `nan`",
        ),
        ([&bearing[..], &["--nu=0.5", "--hardness=1 GPa"]].concat(), "softens under load"),
        ([&bearing[..], &["--nu=2", "--hardness=-1 GPa"]].concat(), "--hardness: -1000000000"),
        (
            [&bearing[..], &["--nu=2", "--hardness=1 GPa", "--pressure=0"]].concat(),
            "--pressure 0: must be",
        ),
        (
            [&bearing[..], &["--nu=2", "--hardness=1 GPa", "--law=linear"]].concat(),
            "needs a working --pressure",
        ),
        (vec!["bearing", "--trace=flat.csv", "--hardness=1 GPa"], "not the same all along"),
        (vec!["bearing", "--trace=gone.csv", "--hardness=1 GPa"], "gone.csv: cannot be read"),
        (vec!["table", "t.csv"], "at least two rows"),
        (vec!["table", "bad.csv"], "bad.csv: line 2: approach 1 m, pressure -1 Pa"),
        (vec!["table", "t.csv", "--pressure-unit=mm"], "--pressure-unit"),
    ];
    for (more, said) in cases {
        let run = folder.run(&arguments(&more));
        assert!(run.refusal().contains(said), "{more:?}: {}", run.stderr);
    }
    // What clap refuses.
    for more in [vec![], vec!["gw"], [&bearing[..], &["--nu=2"]].concat(), vec!["table"]] {
        assert_eq!(folder.run(&arguments(&more)).code, Some(2), "{more:?}");
    }
}
