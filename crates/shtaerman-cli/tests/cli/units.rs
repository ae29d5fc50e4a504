//! Units of one's own: tables and columns follow, JSON stays SI.

use crate::cli::support::{Folder, UNILATERAL, number};

/// Metres, pascals and newtons per metre in an inch, a ksi and a pound-force per inch.
const INCH: f64 = 0.0254;
const KSI: f64 = 4448.2216152605 / (INCH * INCH);
const LBF_PER_INCH: f64 = 4.4482216152605 / INCH;

/// The number in a row of a table, and its unit.
fn row(table: &str, name: &str) -> (f64, String) {
    let line = table.lines().find(|line| line.trim_start().starts_with(name)).unwrap_or_default();
    let rest = line.trim_start().trim_start_matches(name).trim_start();
    let mut words = rest.split("  ").next().unwrap_or_default().splitn(2, ' ');
    let value = words.next().and_then(|word| word.parse().ok()).unwrap_or(f64::NAN);
    (value, words.next().unwrap_or_default().to_owned())
}

#[test]
fn a_table_in_inches_has_the_values_of_the_json() {
    let folder = Folder::with(UNILATERAL);
    let json = folder.run(&["solve", "punch.toml", "--format", "json", "--no-audit"]).json();
    let table = folder.run(&["solve", "punch.toml", "--units", "inch", "--no-audit"]).answer();
    for (name, pointer, size, unit) in [
        ("settlement", "/physical/settlement", 1e-6 * INCH, "µin"),
        ("force", "/physical/force", 1e3 * LBF_PER_INCH, "kip/in"),
        ("moment", "/physical/moment", 4.4482216152605, "lbf in/in"),
        ("pressure, left edge", "/physical/pressure_left", KSI, "ksi"),
        ("pressure, mean", "/physical/mean_pressure", KSI, "ksi"),
        ("contact modulus E*", "/physical/contact_modulus", 1e3 * KSI, "Msi"),
    ] {
        let (value, written) = row(&table, name);
        let exact = number(&json, pointer) / size;
        assert!((value / exact - 1.0).abs() < 1e-5, "{name}: {value} for {exact}\n{table}");
        assert_eq!(written, unit, "{table}");
    }
}

#[test]
fn the_file_says_the_same_as_the_option() {
    let folder = Folder::with(UNILATERAL);
    let own = "\n[output]\nunits = { system = \"mm\", length = \"in\", pressure = \"ksi\", force = \"kip/ft\" }\n";
    folder.write("own.toml", format!("{UNILATERAL}{own}"));
    let option = "system=mm, length=in, pressure=ksi, force=kip/ft";
    let by_file = folder.run(&["solve", "own.toml", "--no-audit"]).answer();
    let by_option = folder.run(&["solve", "punch.toml", "--units", option, "--no-audit"]).answer();
    assert_eq!(by_file.replace("own.toml", "punch.toml"), by_option);
    for (name, unit) in [
        ("settlement", "in"),
        ("force", "kip/ft"),
        ("moment", "N mm/mm"),
        ("pressure, centre", "ksi"),
    ] {
        assert_eq!(row(&by_file, name).1, unit, "{by_file}");
    }
    // The option takes the place of the file.
    let si = folder.run(&["solve", "own.toml", "--units", "si", "--no-audit"]).answer();
    assert_eq!(row(&si, "pressure, centre").1, "MPa");
}

#[test]
fn json_is_si_whatever_the_units() {
    let folder = Folder::with(UNILATERAL);
    for command in [
        vec!["solve", "punch.toml", "--no-audit"],
        vec!["find", "force", "punch.toml", "--peak-pressure", "150 MPa", "--no-audit"],
        vec!["stress", "punch.toml", "--no-audit"],
    ] {
        let run = |units: &[&str]| {
            folder.run(&[&command[..], &["--format", "json"], units].concat()).answer()
        };
        assert_eq!(run(&[]), run(&["--units", "inch"]), "{command:?}");
    }
}

#[test]
fn columns_are_in_units_that_were_chosen_and_say_so() {
    let folder = Folder::with(UNILATERAL);
    let read = |extra: &[&str]| {
        let start = ["solve", "punch.toml", "--format", "csv", "--points", "5", "--no-audit"];
        folder.run(&[&start, extra].concat()).answer()
    };
    let (si, own) = (read(&[]), read(&["--units", "length=mil, pressure=ksi"]));
    assert!(si.starts_with("x,pressure\n"), "{si}");
    assert!(own.starts_with("x [mil],pressure [ksi]\n"), "{own}");
    let numbers = |text: &str| -> Vec<f64> {
        text.lines().skip(1).flat_map(|line| line.split(',')).map(|n| n.parse().unwrap()).collect()
    };
    for (index, (si, own)) in numbers(&si).iter().zip(numbers(&own)).enumerate() {
        let size = if index % 2 == 0 { 1e-3 * INCH } else { KSI };
        assert!((own * size - si).abs() <= 1e-12 * si.abs(), "{index}: {own} {si}");
    }
    let surface = read(&["--surface", "3", "--units", "mm"]);
    let surface = surface.lines().next().unwrap_or_default().to_owned();
    // --points and --surface: the surface is what CSV holds then.
    assert_eq!(surface, "x [mm],pressure [MPa],displacement [µm],gap [µm]");
    let stress = ["stress", "punch.toml", "--format", "csv", "--grid", "2x2", "--units", "inch"];
    let stress = folder.run(&stress).answer();
    assert!(stress.starts_with("x [in],y [in],sigma_x [psi],sigma_y [psi]"), "{stress}");
    let vary = ["solve", "punch.toml", "--vary", "load.force=0.1,0.8 MN/m", "--units", "inch"];
    let vary = folder.run(&[&vary[..], &["--format", "csv", "--no-audit"]].concat()).answer();
    assert!(
        vary.starts_with("case,load.force [lbf/in],settlement [in],settlement_error [in]"),
        "{vary}"
    );
    let force: f64 = vary.lines().nth(2).unwrap().split(',').nth(1).unwrap().parse().unwrap();
    assert!((force * LBF_PER_INCH / 0.8e6 - 1.0).abs() < 1e-12, "{vary}");
}

#[test]
fn a_profile_found_in_inches_is_read_back_as_it_says() {
    let folder = Folder::with(&UNILATERAL.replace("moment = \"100 N\"", "moment = 0"));
    let find = ["find", "profile", "punch.toml", "--pressure", "1", "--units", "inch"];
    let table = folder.run(&find).answer();
    let line = table.lines().find(|line| line.starts_with("set: ")).unwrap();
    assert!(
        line.ends_with("{ csv = \"profile.csv\", x_unit = \"in\", f_unit = \"in\" }"),
        "{line}"
    );
    folder.run(&[&find[..], &["--format", "csv", "-o", "profile.csv"]].concat()).answer();
    let set = line.trim_start_matches("set: ").replacen(" = ", "=", 1);
    let answer =
        folder.run(&["solve", "punch.toml", "--set", &set, "--no-audit", "--format", "json"]);
    let json = answer.json();
    // The prescribed pressure is uniform.
    let peak = number(&json, "/physical/peak_pressure");
    let mean = number(&json, "/physical/mean_pressure");
    assert!((peak / mean - 1.0).abs() < 1e-3, "{peak} {mean}");
}

#[test]
fn plots_and_warnings_follow() {
    let folder = Folder::with(UNILATERAL);
    folder
        .run(&["solve", "punch.toml", "--units", "inch", "--plot", "p.svg", "--no-audit"])
        .answer();
    let svg = folder.read("p.svg");
    for label in ["x [in]", "pressure p [ksi]", "depth [µin]", "4.568 kip/in"] {
        assert!(svg.contains(label), "{label}");
    }
    let heavy =
        ["solve", "punch.toml", "--set", "load.force=200 MN/m", "--no-audit", "--units", "inch"];
    let said = folder.run(&heavy).answer();
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        said.contains("warning: the largest pressure, ") && said.contains(" Msi, is above"),
        "{said}"
    );
}

/// What is warned of an answer follows as well: where it pulls, and where its pressure is infinite.
#[test]
fn places_of_warnings_follow() {
    let folder = Folder::with(UNILATERAL);
    let pulls = ["--set", "load.moment=5 kN", "--set", "solver.contact=bilateral"];
    let corner = ["--set", "foundation.roughness=0", "--set", "punch.profile=0"];
    let kink = ["--set", "foundation.roughness=0", "--set", "punch.profile=0.001*abs(x - 0.001)"];
    for (slip, code, si, own) in [
        (pulls, "negative_pressure", "x = -5 mm to ", "x = -196.85 mil to "),
        (corner, "singular_edge", "corner x = -5 mm", "corner x = -196.85 mil"),
        (kink, "singular_kink", "at x = 1 mm", "at x = 39.3701 mil"),
    ] {
        for (units, said) in [("si", si), ("length=mil", own)] {
            let solve = ["solve", "punch.toml", "--no-audit", "--format", "json", "--units", units];
            let json = folder.run(&[&solve[..], &slip].concat()).json();
            let told = json["warnings"].as_array().unwrap().iter();
            let told: Vec<_> = told.filter(|warning| warning["code"] == code).collect();
            assert!(told[0]["message"].as_str().unwrap().contains(said), "{told:?}");
        }
    }
}

#[test]
fn units_that_are_none_are_refused() {
    let folder = Folder::with(UNILATERAL);
    folder.write("bare.toml", crate::cli::support::DIMENSIONLESS);
    let refused = |file: &str, units: &str| {
        let run = folder.run(&["solve", file, "--units", units]);
        run.refusal().to_owned()
    };
    assert!(
        refused("punch.toml", "imperial").contains("must be si, mm, inch, or units of your own")
    );
    assert!(refused("punch.toml", "length=Pa").contains("is a length (like \"5 mm\"), got Pa"));
    // As it was asked for, and not as the override that it is inside.
    for (units, said) in [
        ("lenght=in", "--units `lenght=in`: lenght: is not a known key, did you mean length?"),
        ("length=mm,length=in", "--units `length=mm,length=in`: states length twice"),
        ("length=foo", "--units `length=foo`: length: has the unknown unit foo"),
        ("force=kip", "--units `force=kip`: force: is a force per length"),
    ] {
        assert!(refused("punch.toml", units).contains(said), "{}", refused("punch.toml", units));
        let vary = ["solve", "punch.toml", "--vary", "load.force=0.1,0.8 MN/m", "--units", units];
        assert!(folder.run(&vary).refusal().contains(said), "{units}");
    }
    let bare = refused("bare.toml", "inch");
    assert!(bare.contains("--units `inch`: has no place in a dimensionless problem"), "{bare}");
    let set = folder.run(&["solve", "punch.toml", "--set", "output.units.lenght=in"]);
    assert!(set.refusal().contains("--set output.units.lenght=in: output.units.lenght"), "{set:?}");
    folder.write("file.toml", format!("{UNILATERAL}\n[output]\nunits = \"inches\"\n"));
    let run = folder.run(&["solve", "file.toml"]);
    assert!(run.refusal().contains("file.toml:15: output.units"), "{}", run.stderr);
}
