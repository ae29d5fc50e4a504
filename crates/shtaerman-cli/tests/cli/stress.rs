//! `stress`: maxima, places, grids, maps, and the load at first yield.

use serde_json::Value;

use crate::cli::support::{Folder, UNILATERAL, assert_valid, number, repository, schema};

/// A crown that touches in the middle, nearly smooth: Hertz.
const CROWN: &str = r#"[foundation]
young_modulus = "210 GPa"
poisson_ratio = 0.3
roughness = "1e-19 m/Pa"
yield_stress = "350 MPa"

[punch]
half_width = "5 mm"
profile = "x^2/(2*0.1)"

[load]
force = "0.3 MN/m"
moment = 0
"#;

const WAVY: &str = r#"[dimensionless]
theta0 = 60.0
profile = "cos(9*xi) + 2*xi^2"
force = 0.01
moment = 0.001
"#;

#[track_caller]
fn json(folder: &Folder, arguments: &[&str]) -> Value {
    let all = [&["stress", "punch.toml", "--format", "json"], arguments].concat();
    let json = folder.run(&all).json();
    assert_valid(&schema("stress"), &json, "stress");
    json
}

fn floats(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

#[test]
fn hertz_is_found_below_a_crown() {
    let json = json(&Folder::with(CROWN), &[]);
    let (modulus, force) = (210e9 / 0.91, 0.3e6);
    let width = (4.0 * force * 0.1 / (std::f64::consts::PI * modulus)).sqrt();
    let largest = 2.0 * force / (std::f64::consts::PI * width);
    for (name, value, depth) in
        [("max_shear", 0.300_283_106, 0.786_151_378), ("von_mises", 0.557_516_217, 0.704_291_685)]
    {
        let peak = &json["maximum"][name];
        assert!((number(peak, "/value") / (value * largest) - 1.0).abs() < 3e-4, "{peak}");
        assert!((number(peak, "/y") / (depth * width) - 1.0).abs() < 2e-3, "{peak}");
        assert_eq!(peak["is_corner"], false);
    }
    // Hertz: the load grows as the square of the stress.
    let loads = json["first_yield"].as_array().unwrap();
    for (load, name, share) in [(&loads[0], "von_mises", 1.0), (&loads[1], "max_shear", 2.0)] {
        let stress = share * number(&json, &format!("/maximum/{name}/value"));
        let factor = number(load, "/factor");
        assert!((factor * (stress / 350e6).powi(2) - 1.0).abs() < 1e-3, "{load}");
        assert!((number(load, "/force") / (0.3e6 * factor) - 1.0).abs() < 1e-12);
        assert!(number(load, "/error") < 1e-8 * number(load, "/force"));
    }
    assert_eq!((&json["points"], &json["grid"]), (&Value::Null, &Value::Null));
}

#[test]
fn places_and_grids_are_of_one_field() {
    let folder = Folder::with(CROWN);
    let grid = json(&folder, &["--grid", "5x3", "--x-range", "-1 mm..1 mm", "--depth", "0.8 mm"]);
    assert_eq!(floats(&grid["grid"]["x"]), [-1e-3, -5e-4, 0.0, 5e-4, 1e-3]);
    assert_eq!(floats(&grid["grid"]["y"]), [0.0, 4e-4, 8e-4]);
    let places = json(&folder, &["--at", "0.5 mm,0.4 mm; 0,0; -1e-3, 8e-4"]);
    let names = ["sigma_x", "sigma_y", "sigma_z", "tau_xy", "sigma_1", "sigma_2", "sigma_3"];
    for name in names.into_iter().chain(["max_shear", "tresca", "von_mises"]) {
        let at = floats(&places["points"][name]);
        for (value, pointer) in at.iter().zip(["1/3", "0/2", "2/0"]) {
            let of_grid = number(&grid, &format!("/grid/{name}/{pointer}"));
            assert!((value - of_grid).abs() <= 1e-9 * value.abs() + 1e-3, "{name}");
        }
    }
    // On the surface both stresses in the plane are the pressure.
    let solved = folder.run(&["solve", "punch.toml", "--at", "0", "--format", "json"]).json();
    let pressure = number(&solved, "/pressure/pressure/0");
    for name in ["sigma_x", "sigma_y"] {
        assert!((floats(&places["points"][name])[1] / -pressure - 1.0).abs() < 1e-9);
    }
}

#[test]
fn csv_and_arrays_hold_the_same() {
    let folder = Folder::with(CROWN);
    let grid = ["stress", "punch.toml", "--grid", "7x4"];
    let csv = folder.run(&[&grid[..], &["--format", "csv"]].concat()).answer();
    let header =
        "x,y,sigma_x,sigma_y,sigma_z,tau_xy,sigma_1,sigma_2,sigma_3,max_shear,tresca,von_mises";
    assert_eq!(csv.lines().next(), Some(header));
    assert_eq!(csv.lines().count(), 1 + 28);
    let last: Vec<f64> =
        csv.lines().map(|line| line.rsplit(',').next().unwrap().parse().unwrap_or(0.0)).collect();
    for _ in 0..2 {
        let arguments = [&grid[..], &["--format", "npz", "-o", "field.npz"]].concat();
        assert_eq!(folder.run(&arguments).answer(), "");
    }
    let bytes = std::fs::read(folder.path("field.npz")).unwrap();
    assert!(bytes.starts_with(b"PK\x03\x04"));
    // The array is stored as it is: its last numbers end where the directory of the archive begins.
    let directory = bytes.windows(4).position(|window| window == b"PK\x01\x02").unwrap();
    let numbers: Vec<f64> = bytes[directory - 8 * 28..directory]
        .chunks_exact(8)
        .map(|part| f64::from_le_bytes(part.try_into().unwrap()))
        .collect();
    assert_eq!(numbers, last[1..]);
    let text = String::from_utf8_lossy(&bytes);
    for said in ["von_mises.npy", "'descr': '<f8'", "'shape': (4, 7, )", "'shape': (7, )"] {
        assert!(text.contains(said), "{said}");
    }
}

#[test]
fn maps_are_drawn() {
    let folder = Folder::with(WAVY);
    for component in ["von-mises", "max-shear", "tau-xy", "sigma-y", "sigma-1"] {
        let arguments = ["stress", "punch.toml", "--poisson-ratio", "0.3", "--grid", "61x31"];
        let plot = ["--component", component, "--plot", "map.svg"];
        let table = folder.run(&[&arguments[..], &plot].concat()).answer();
        assert!(table.contains("von Mises, largest") && table.contains("plot: map.svg"), "{table}");
        let svg = folder.read("map.svg");
        let drawing = roxmltree::Document::parse(&svg).unwrap();
        let fills = drawing.descendants().filter(|node| node.attribute("d").is_some());
        assert!(fills.count() > 8, "{component}: bands");
        assert!(svg.contains("contact") && svg.contains("depth / a"));
    }
    let png = ["stress", "punch.toml", "--poisson-ratio", "0", "--plot", "map.png"];
    folder.run(&png).answer();
    assert!(std::fs::read(folder.path("map.png")).unwrap().starts_with(b"\x89PNG"));
}

/// A yield stress that no load meets is an error where it was asked for, and a warning where the file has it.
#[test]
fn no_load_at_yield_is_said() {
    let bilateral = CROWN.replace("350 MPa", "1 MPa") + "\n[solver]\ncontact = \"bilateral\"\n";
    let folder = Folder::with(&bilateral);
    let answer = json(&folder, &[]);
    assert_eq!(answer["first_yield"], Value::Null);
    let warnings = answer["warnings"].as_array().unwrap();
    let no_yield = warnings.iter().find(|one| one["code"] == "no_yield").unwrap();
    assert!(no_yield["message"].as_str().unwrap().contains("no load"), "{answer}");
    let run = folder.run(&["stress", "punch.toml", "--yield-stress", "1 MPa"]);
    assert!(run.refusal().contains("to the yield stress, 1 MPa: the nearest is "));
}

#[test]
fn bad_arguments() {
    for (arguments, said) in [
        (["--depth", "-1 mm"].as_slice(), "--depth -1 mm: must be finite and greater than zero"),
        (&["--depth", "0"], "--depth 0"),
        (&["--depth", "nan"], "--depth `nan`"),
        (&["--depth", "1 MPa"], "--depth `1 MPa`"),
        (&["--depth", "1e400 m"], "--depth"),
        (&["--grid", "1x5"], "--grid 1x5: must be two whole numbers from 2 on"),
        (&["--grid", ""], "--grid"),
        (&["--grid", "3000x3000"], "at most 4000000"),
        (&["--grid", "9999999999999x9999999999999"], "at most 4000000"),
        (&["--grid", "5"], "must be two numbers of points"),
        (&["--x-range", "1 mm"], "must be two places"),
        (&["--x-range", "1 mm..-1 mm"], "must go from left to right"),
        (&["--x-range", "0..nan"], "--x-range"),
        (&["--at", "1 mm"], "must be x,y"),
        (&["--at", ";"], "--at names 0 places"),
        (&["--at", "0,-1 mm"], "the depth must not be negative"),
        (&["--at", "0,nan"], "--at"),
        (&["--at", "0,1", "--grid", "5x5"], "cannot be used with"),
        (&["--component", "sigma"], "sigma"),
        (&["--yield-stress", "0"], "--yield-stress 0: must be finite and greater than zero"),
        (&["--yield-stress", "-3 MPa"], "--yield-stress -3 MPa"),
        (&["--yield-stress", "3 mm"], "--yield-stress `3 mm`"),
        (&["--poisson-ratio", "0.2"], "is for a dimensionless file"),
        (&["--format", "npz"], "give --output FILE.npz"),
        (&["--plot", "map.bmp"], "use .svg"),
        (&["--output", "nowhere/s.csv"], "there is no folder"),
        (&["--set", "foundation.yield_stress=\"-1 MPa\""], "yield_stress"),
        (&["--set", "foundation.yield_stress=\"1 mm\""], "yield_stress"),
    ] {
        let folder = Folder::with(CROWN);
        let run = folder.run(&[&["stress", "punch.toml"], arguments].concat());
        run.refusal();
        assert!(run.stderr.contains(said), "{arguments:?}: {}", run.stderr);
        assert_eq!(folder.files(), ["punch.toml"]);
    }
    let folder = Folder::with(WAVY);
    assert!(folder.run(&["stress", "punch.toml"]).refusal().contains("give --poisson-ratio"));
    let run = folder.run(&["stress", "punch.toml", "--poisson-ratio", "0.6"]);
    assert!(run.refusal().contains("at most 0.5"));
}

#[test]
fn a_circular_punch_is_refused() {
    let circular = CROWN
        .replace("half_width", "geometry = \"circular\"\nradius")
        .replace("force = \"0.3 MN/m\"\nmoment = 0", "settlement = \"1 um\"\ntilt = 0");
    let run = Folder::with(&circular).run(&["stress", "punch.toml"]);
    let known = "known for the plane, homogeneous half-space only";
    assert!(run.refusal().contains(known), "{}", run.stderr);
}

/// The crest of the wave is in the middle, and so is what lies below it.
#[test]
fn the_peak_below_a_wave_is_told_in_its_period() {
    let folder = Folder::new();
    let wave = repository().join("examples/wave.toml");
    let stress = ["stress", wave.to_str().unwrap(), "--no-audit", "--format", "json"];
    let found = folder.run(&stress).json();
    for name in ["von_mises", "max_shear"] {
        assert_eq!(found["maximum"][name]["x"], 0.0, "{found}");
    }
}

#[test]
fn zeros_of_a_column_have_no_sign() {
    let folder = Folder::with(UNILATERAL);
    let csv = ["stress", "punch.toml", "--no-audit", "--format", "csv", "--grid", "9x5"];
    let csv = folder.run(&csv).answer();
    assert!(csv.lines().skip(1).all(|line| line.split(',').all(|field| field != "-0")), "{csv}");
}
