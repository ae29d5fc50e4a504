//! Sense checks: slips of the input are doubted, plain work is not.

use crate::cli::support::{Folder, assert_valid, repository, schema};

const STEEL: &str = r#"
[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"
yield_stress = "350 MPa"

[punch]
half_width = "5 mm"
profile = "x^2 / 40"

[load]
force = "0.8 MN/m"
moment = 0
"#;

#[test]
fn no_example_is_doubted() {
    let mut count = 0;
    for entry in std::fs::read_dir(repository().join("examples")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if !name.ends_with(".toml") || name.starts_with("equation_") {
            continue;
        }
        count += 1;
        let folder = Folder::new();
        let run = folder.run(&["solve", path.to_str().unwrap(), "--strict", "--no-audit"]);
        assert_eq!(run.code, Some(0), "{name}: {}", run.stderr);
    }
    assert!(count >= 8, "{count} examples");
}

#[test]
fn slips_are_doubted_with_their_number_and_refused_when_asked() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    assert_eq!(folder.run(&["solve", "steel.toml", "--strict"]).code, Some(0));
    for (slip, code, said) in [
        ("load.force=62 GN/m", "high_pressure", "is above a tenth of the modulus that resists it"),
        ("foundation.young_modulus=200", "soft_modulus", "is \"200 GPa\" meant?"),
        ("foundation.young_modulus='200'", "soft_modulus", "is \"200 GPa\" meant?"),
        ("foundation.yield_stress='350'", "low_yield_stress", "is \"350 MPa\" meant?"),
        ("punch.half_width=5", "wide_base", "the half-width is 5 m: are millimetres meant?"),
        ("load.force=4 MN/m", "above_yield", "is above the yield stress, 350 MPa"),
        ("punch.profile=x^2/(2*0.0001)", "steep_base", "small slopes are assumed"),
    ] {
        let run =
            folder.run(&["solve", "steel.toml", "--set", slip, "--format", "json", "--no-audit"]);
        let stderr = run.stderr.clone();
        let json = run.json();
        let codes: Vec<&str> = json["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|warning| warning["code"].as_str().unwrap())
            .collect();
        assert!(codes.contains(&code), "{slip}: {codes:?}");
        assert!(stderr.contains(said), "{slip}: {stderr}");
        let strict = folder.run(&[
            "solve",
            "steel.toml",
            "--set",
            slip,
            "--no-audit",
            "--strict",
            "-o",
            "out.txt",
        ]);
        assert_eq!(strict.code, Some(2), "{slip}");
        assert!(
            strict.stderr.starts_with("error: --strict: ") && strict.stderr.contains(said),
            "{}",
            strict.stderr
        );
        assert!(!folder.path("out.txt").exists());
    }
    // With its unit a soft modulus is meant.
    let gel = folder.run(&[
        "solve",
        "steel.toml",
        "--set",
        "foundation.young_modulus=50 kPa",
        "--set",
        "load.force=1 N/m",
    ]);
    assert!(!gel.stdout.contains("softer than rubber"), "{}", gel.stdout);
}

/// What pulls is no less than what presses, and what is wanted without a unit is doubted as what is stated.
#[test]
fn tension_and_goals_without_a_unit_are_doubted() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    let pulled = ["--set", "solver.contact=bilateral", "--set", "load.force=-62 GN/m"];
    let run = folder.run(&[&["solve", "steel.toml", "--strict"][..], &pulled].concat());
    assert!(run.refusal().contains("the largest tension, "), "{}", run.stderr);
    assert!(run.stderr.contains("is above the yield stress"), "{}", run.stderr);
    let weak = ["--set", "solver.contact=bilateral", "--set", "load.force=-0.1 MN/m"];
    folder.run(&[&["solve", "steel.toml", "--strict"][..], &weak].concat()).answer();

    for find in ["force", "crown"] {
        let find = |more: &[&str]| {
            let find = ["find", find, "steel.toml", "--set", "load.force=1 N/m", "--no-audit"];
            folder.run(&[&find[..], more].concat())
        };
        let strict = find(&["--peak-pressure", "350", "--strict"]);
        assert!(strict.refusal().contains("is \"350 MPa\" meant?"), "{}", strict.stderr);
    }
    let find = ["find", "force", "steel.toml", "--no-audit", "--peak-pressure"];
    let json = folder.run(&[&find[..], &["1e5", "--format", "json"]].concat());
    assert_eq!(json.stderr.matches("has no unit").count(), 1, "{}", json.stderr);
    assert_eq!(json.json()["warnings"][0]["code"], "unknown_unit");
    folder.run(&[&find[..], &["300 MPa", "--strict"]].concat()).answer();
}

/// A disk has a radius and a force in newtons.
#[test]
fn slips_of_disks_are_named_in_their_own_words() {
    let folder = Folder::new();
    let disk = repository().join("examples/rough_ball.toml");
    let solve = |sets: &[&str]| {
        let sets = sets.iter().flat_map(|set| ["--set", set]);
        let solve = ["solve", disk.to_str().unwrap(), "--no-audit", "--strict"];
        folder.run(&solve.into_iter().chain(sets).collect::<Vec<_>>())
    };
    let heavy = solve(&["load.force=500000000"]);
    assert!(heavy.refusal().contains("is the load in N, and"), "{}", heavy.stderr);
    assert!(!heavy.stderr.contains("per metre") && !heavy.stderr.contains("half-width"));
    let wide = solve(&["punch.radius=5", "punch.profile=0"]);
    assert!(wide.refusal().contains("the radius is 5 m: are"), "{}", wide.stderr);
}

/// Two punches on a foundation whose gigapascals were left out: no zones are found, and the likely cause stands beside the error.
#[test]
fn what_the_file_alone_tells_is_told_before_anything_is_solved() {
    let folder = Folder::new();
    let punches = repository().join("examples/two_punches.toml");
    let slip = ["solve", punches.to_str().unwrap(), "--set", "foundation.young_modulus=200"];
    let said = "warning: foundation.young_modulus = 200 has no unit and is taken in Pa";
    for format in ["table", "json"] {
        // Rounding of numbers so large allows no such tolerance.
        let failing = ["--format", format, "--no-audit", "--set", "solver.tolerance=1e-15"];
        let run = folder.run(&[&slip[..], &failing].concat());
        assert!(run.failure(3).contains("the tolerance 1e-15 was not met"), "{}", run.stderr);
        let [doubt, error] = [said, "error: "].map(|part| run.stderr.find(part).unwrap());
        assert!(doubt < error && run.stderr.matches(said).count() == 1, "{}", run.stderr);
    }
    let strict = folder.run(&[&slip[..], &["--strict"]].concat());
    assert!(strict.refusal().contains("--strict: foundation.young_modulus = 200"), "{strict:?}");
    // An answer that shows its warnings is not preceded by them, and others tell them once.
    folder.write("steel.toml", STEEL);
    let wide = ["solve", "steel.toml", "--set", "punch.half_width=5", "--no-audit"];
    let table = folder.run(&wide);
    assert!(table.stderr.is_empty() && table.stdout.contains("are millimetres meant?"));
    let csv = folder.run(&[&wide[..], &["--format", "csv"]].concat());
    assert_eq!(csv.stderr.matches("are millimetres meant?").count(), 1, "{}", csv.stderr);
    for command in [
        &["stress", "steel.toml"][..],
        &["find", "force", "steel.toml", "--peak-pressure", "100 MPa"],
        &["export", "abaqus", "steel.toml"],
        &["validate", "steel.toml"],
    ] {
        let slip = ["--set", "foundation.young_modulus=200", "--strict"];
        let strict = folder.run(&[command, &slip].concat());
        assert!(strict.refusal().contains("is \"200 GPa\" meant?"), "{command:?}: {strict:?}");
        let quiet = folder.run(&[command, &slip[..2], &["-q"]].concat());
        assert!(!quiet.stderr.contains("warning:"), "{command:?}: {quiet:?}");
    }
    let validated = folder.run(&["validate", "steel.toml", "--set", "punch.half_width=5"]);
    assert!(validated.stderr.contains("are millimetres meant?"), "{}", validated.stderr);
    assert!(validated.answer().contains("valid"));
}

/// A coating that is too stiff for its ground is none where the ground has lost its gigapascals.
#[test]
fn a_modulus_refused_beside_another_has_the_likely_slip_as_its_help() {
    let folder = Folder::new();
    let shaft = repository().join("examples/coated_shaft.toml");
    let set = ["--set", "foundation.young_modulus=210"];
    let run = folder.run(&[&["solve", shaft.to_str().unwrap()][..], &set].concat());
    assert!(run.refusal().contains("foundation.coating.young_modulus"), "{}", run.stderr);
    assert!(run.stderr.contains("is \"210 GPa\" meant?"), "{}", run.stderr);
    for set in [
        "foundation.coating.young_modulus=400",
        "foundation.coating.young_modulus='400'",
        "foundation.young_modulus='210'",
    ] {
        let run = folder.run(&["solve", shaft.to_str().unwrap(), "--set", set]);
        assert!(run.refusal().contains("must be between 1e-4 and 1e4"), "{}", run.stderr);
        assert!(run.stderr.contains("has no unit and is taken in Pa"), "{}", run.stderr);
    }
}

#[test]
fn a_yield_stress_without_its_unit_is_doubted() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    let run =
        |yield_stress: &str| folder.run(&["stress", "steel.toml", "--yield-stress", yield_stress]);
    let doubted = run("350").answer();
    assert!(doubted.contains("is \"350 MPa\" meant?"), "{doubted}");
    let plain = run("350 MPa").answer();
    assert!(!plain.contains("meant?"), "{plain}");
}

/// What yields is told by the stress in the body, in the units that are shown: the pressure on it may be larger.
#[test]
fn a_body_that_yields_is_told_by_its_von_mises_stress() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    let largest = {
        let json = folder.run(&["stress", "steel.toml", "--format", "json", "--no-audit"]).json();
        json["maximum"]["von_mises"]["value"].as_f64().unwrap() / 1e6
    };
    for (share, is_said) in [(0.99, true), (1.01, false)] {
        let set = format!("foundation.yield_stress={} MPa", share * largest);
        let stress = ["stress", "steel.toml", "--no-audit", "--set", &set];
        let said = "the largest von Mises stress";
        let table = folder.run(&[&stress[..], &["--units", "inch"]].concat()).answer();
        assert_eq!(table.matches(said).count(), usize::from(is_said), "{table}");
        let strict = folder.run(&[&stress[..], &["--strict"]].concat());
        assert_eq!(strict.code, Some(if is_said { 2 } else { 0 }), "{}", strict.stderr);
        assert!(!is_said || (table.contains("psi") && strict.refusal().contains(said)), "{table}");
        let json = folder.run(&[&stress[..], &["--format", "json"]].concat()).json();
        let told = json["warnings"].as_array().unwrap().iter();
        let told = told.filter(|warning| warning["code"] == "above_yield");
        assert_eq!(told.count(), usize::from(is_said), "{json}");
    }
    let asked = format!("{} MPa", 0.99 * largest);
    let run = folder.run(&["stress", "steel.toml", "--yield-stress", &asked, "--strict"]);
    assert!(run.refusal().contains("is above the yield stress"), "{}", run.stderr);
}

#[test]
fn a_header_with_another_unit_is_refused() {
    let folder = Folder::new();
    folder.write("trace.csv", "x [mm],height [um]\n-6,1\n-2,0.2\n2,0.1\n6,1.2\n");
    let set = |units: &str| format!("punch.profile={{ csv = \"trace.csv\"{units} }}");
    folder.write("steel.toml", STEEL);
    let refused = folder.run(&["solve", "steel.toml", "--set", &set("")]);
    assert!(
        refused.refusal().contains("trace.csv: line 1: the header has the position in mm"),
        "{}",
        refused.stderr
    );
    let help = refused.stderr.lines().last().unwrap().trim();
    assert!(help.ends_with("x_unit = \"mm\", f_unit = \"um\" }"), "{help}");
    let right = set(", x_unit = \"mm\", f_unit = \"um\"");
    folder.run(&["solve", "steel.toml", "--set", &right, "--no-audit"]).answer();
}

/// Words, capitals, a solidus, an underscore: what instruments write is understood, and guards the unit that is stated.
#[test]
fn units_of_headers_are_understood_however_they_are_written() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    let rows = "-6,1\n-2,0.2\n2,0.1\n6,1.2\n";
    for (header, between, x, f) in [
        ("x [mm] f [um]", " ", "mm", "um"),
        ("x / mm   f / um", "   ", "mm", "um"),
        ("x in mm f in um", "\t", "mm", "um"),
        ("# x [mm], f [um]", ",", "mm", "um"),
        ("x [inch],f [micron]", ",", "in", "µm"),
        ("Pos. (Zoll);Höhe (Mikrometer)", ";", "in", "µm"),
        ("x_mm,z_nm", ",", "mm", "nm"),
        ("\"x, mm\",\"f, mil\"", ",", "mm", "mil"),
        ("X [MM],Z [UM]", ",", "mm", "um"),
    ] {
        folder.write("trace.csv", format!("{header}\n{}", rows.replace(',', between)));
        let trace = folder.run(&["trace", "trace.csv", "-q"]).answer();
        let units = format!("x_unit = \"{x}\", f_unit = \"{f}\" }}");
        assert!(trace.contains(&units), "{header}: {trace}");
        // Metres, which nobody meant, are refused, and so is another unit.
        for stated in ["", ", x_unit = \"cm\", f_unit = \"cm\""] {
            let profile = format!("punch.profile={{ csv = \"trace.csv\"{stated} }}");
            let run = folder.run(&["solve", "steel.toml", "--set", &profile]);
            assert!(run.refusal().contains("the header has the position in"), "{header}: {run:?}");
        }
    }
    folder.write("trace.csv", format!("t [s],f [um]\n{rows}"));
    let run = folder.run(&["trace", "trace.csv"]);
    assert!(run.refusal().contains("in s, a time (s), and it is a length"), "{}", run.stderr);
}

/// The unit of the positions may be that of the header: the line that is handed out is doubted by a solve, too.
#[test]
fn heights_without_a_unit_beside_positions_with_one_are_doubted() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    folder.write("trace.csv", "x [mm],z\n-6,1e-6\n-2,2e-7\n2,1e-7\n6,1.2e-6\n");
    let said = "none for its heights, which are read in metres";
    let trace = folder.run(&["trace", "trace.csv", "--half-width", "5mm"]);
    assert_eq!(trace.stderr.matches(said).count(), 1, "{}", trace.stderr);
    let stated = folder.run(&["trace", "trace.csv", "--half-width", "5mm", "--f-unit", "m"]);
    assert!(stated.stderr.is_empty(), "{}", stated.stderr);
    let profile = "punch.profile={ csv = \"trace.csv\", x_unit = \"mm\" }";
    let solve = folder.run(&["solve", "steel.toml", "--no-audit", "--strict", "--set", profile]);
    assert!(solve.refusal().contains(said), "{}", solve.stderr);
}

#[test]
fn what_stands_in_place_of_a_unit_and_is_none_is_doubted_where_none_is_stated() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    let rows = "-6e-3,1e-6\n-2e-3,2e-7\n2e-3,1e-7\n6e-3,1.2e-6\n";
    let solve = |more: &[&str], stated: &str| {
        let profile = format!("punch.profile={{ csv = \"trace.csv\"{stated} }}");
        let solve = ["solve", "steel.toml", "--no-audit", "--set", &profile];
        folder.run(&[&solve[..], more].concat())
    };
    for (header, said) in [
        (
            "x [px],f [a.u.]",
            ["`px` for the unit of the positions", "`a.u.` for the unit of the heights"],
        ),
        ("x (Linien),f", ["`Linien` for the unit of the positions", ""]),
        (
            "x / ell;f / ell",
            ["`ell` for the unit of the positions", "`ell` for the unit of the heights"],
        ),
        ("x_in,f_in", ["`in` for the unit of the positions", "`in` for the unit of the heights"]),
    ] {
        let separator = if header.contains(';') { ";" } else { "," };
        folder.write("trace.csv", format!("{header}\n{}", rows.replace(',', separator)));
        let trace = folder.run(&["trace", "trace.csv"]);
        let json = solve(&["--format", "json"], "");
        for said in said {
            assert!(trace.stderr.contains(said), "{header}: {}", trace.stderr);
            assert!(json.stderr.contains(said), "{header}: {}", json.stderr);
        }
        assert!(
            trace.stderr.contains("--x-unit mm or the like, in a file x_unit = \"mm\""),
            "{header}"
        );
        assert_eq!(json.json()["warnings"][0]["code"], "unknown_unit", "{header}");
        assert_eq!(solve(&["--strict"], "").code, Some(2), "{header}");
        let stated = solve(&["--strict"], ", x_unit = \"m\", f_unit = \"m\"");
        assert_eq!(stated.code, Some(0), "{header}: {}", stated.stderr);
        let options = ["--x-unit", "m", "--f-unit", "m"];
        let trace = folder.run(&[&["trace", "trace.csv"][..], &options].concat());
        assert!(trace.stderr.is_empty(), "{header}: {}", trace.stderr);
    }
    for header in ["x (measured),f [1]", "x,f [-]", "x,height of the base (levelled along x)"] {
        folder.write("trace.csv", format!("{header}\n{rows}"));
        let plain = solve(&["--strict"], "");
        assert_eq!(plain.code, Some(0), "{header}: {}", plain.stderr);
    }
}

/// Units that were left out of `shtaerman roughness`: plain values are not doubted, and each slip is, before any law is found.
#[test]
fn slips_of_a_rough_surface_are_doubted() {
    let folder = Folder::new();
    let gw = |name: &str, value: &str, more: &[&str]| {
        let usual = [
            ("deviation", "0.5 um"),
            ("density", "1e10"),
            ("radius", "10 um"),
            ("modulus", "110 GPa"),
            ("hardness", "4 GPa"),
            ("pressure", "80 MPa"),
        ];
        let options = usual.map(|(option, text)| {
            format!("--{option}={}", if option == name { value } else { text })
        });
        let options: Vec<&str> = options.iter().map(String::as_str).collect();
        folder.run(&[&["roughness", "gw"][..], &options, more].concat())
    };
    assert_eq!(gw("", "", &["--strict"]).code, Some(0));
    for (name, value, said) in [
        ("deviation", "1.2", "is \"1.2 um\" meant?"),
        ("deviation", "1.2 mm", "--deviation 1.2 mm: no machined face is as coarse"),
        ("radius", "10", "is \"10 um\" meant?"),
        ("modulus", "110", "is \"110 GPa\" meant?"),
        ("hardness", "4", "is \"4 GPa\" meant?"),
    ] {
        let run = gw(name, value, &[]);
        let (all, code) = (format!("{}{}", run.stdout, run.stderr), run.code);
        assert!(all.replace("\n    ", " ").contains(said), "{name} {value}: {all}");
        assert_eq!(all.matches("warning: --").count(), 1, "{all}");
        let strict = gw(name, value, &["--strict"]);
        assert!(strict.refusal().starts_with("error: --strict: "), "{strict:?}");
        assert!(!strict.stderr.contains("warning:"), "{strict:?}");
        if code == Some(0) {
            let run = gw(name, value, &["--format", "json"]);
            assert!(run.stderr.contains(said), "{name} {value}: {}", run.stderr);
            let json = run.json();
            assert_valid(&schema("roughness"), &json, name);
            assert!(json["warnings"][0].as_str().unwrap().contains(said), "{json}");
        }
    }
    let bearing = ["roughness", "bearing", "--b=2", "--nu=2", "--height=6", "--hardness=2"];
    let table = folder.run(&bearing).answer();
    assert_eq!(table.matches("meant?").count(), 2, "{table}");
    assert_eq!(folder.run(&[&bearing[..], &["--strict"]].concat()).code, Some(2));
}

/// What is doubted about a file is doubted in each of its cases, as far as they have it.
#[test]
fn cases_have_the_doubts_about_their_file() {
    let folder = Folder::new();
    folder.write("steel.toml", STEEL);
    let codes = |arguments: &[&str]| -> Vec<String> {
        let all = [&["solve", "steel.toml", "--format", "csv"], arguments].concat();
        let table = folder.run(&all).answer();
        let mut lines = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let heads = lines.next().unwrap();
        let column = heads.iter().position(|head| *head == "warnings").unwrap();
        lines.map(|line| line[column].to_owned()).collect()
    };
    let forces = ["--vary", "load.force=0.2 MN/m,0.4 MN/m"];
    assert_eq!(codes(&forces), ["", ""]);
    let bare = codes(&[&forces[..], &["--set", "foundation.young_modulus=2e5"]].concat());
    assert!(bare.iter().all(|codes| codes.contains("soft_modulus")), "{bare:?}");
    let moduli = codes(&["--vary", "foundation.young_modulus=2e5,2e11", "--set", "load.force=2e5"]);
    assert!(moduli[0].contains("soft_modulus") && moduli[1].is_empty(), "{moduli:?}");
}

/// A slip shows in the cases with the extremes, with the number of the case; a study without one is not doubted.
#[test]
fn cases_of_a_study_are_doubted_by_their_number() {
    let folder = Folder::new();
    let vary = |to: &str| {
        format!(
            "{STEEL}\n[study]\nvary.\"load.force\" = {{ from = \"0.4 MN/m\", to = \"{to}\", count = 5, scale = \"log\" }}\noutputs = [\"settlement\", \"peak_pressure\"]\n"
        )
    };
    folder.write("plain.toml", vary("0.8 MN/m"));
    folder.write("slip.toml", vary("800 MN/m"));
    let plain = folder.run(&["sweep", "plain.toml", "-o", "plain", "--strict"]).answer();
    // As the lines are broken.
    let words = |text: &str| text.split_whitespace().collect::<Vec<&str>>().join(" ");
    assert!(words(&plain).contains("nothing to doubt there"), "{plain}");
    let doubted = folder.run(&["sweep", "slip.toml", "-o", "slip"]).answer();
    // The first that has it, which is none with the least or the largest of anything.
    assert!(doubted.contains("\nwarned 4 times, first case 1: above_yield\n"), "{doubted}");
    assert!(doubted.contains("\nwarned 2 times, first case 3: high_pressure\n"), "{doubted}");
    assert!(doubted.contains("\nwarning: case 3 (load.force = "), "{doubted}");
    assert!(words(&doubted).contains("of 4 of 5 cases, the first with each warning"), "{doubted}");
    let part = std::fs::read_to_string(folder.path("slip/part-00000000.csv")).unwrap();
    let lines: Vec<&str> = part.lines().collect();
    assert!(lines[0].ends_with(",warnings,reason") && lines[1].ends_with(",,"), "{part}");
    assert!(lines[3].ends_with(",above_yield,"), "{part}");
    assert!(lines[4].ends_with(",high_pressure above_yield,"), "{part}");
    let strict = folder.run(&["sweep", "slip.toml", "-o", "slip", "--strict"]);
    assert_eq!(strict.code, Some(2), "{strict:?}");
    assert!(strict.stderr.starts_with("error: --strict: case 1 (load.force = "), "{strict:?}");
    let summary = ["sweep", "slip.toml", "-o", "slip", "--summary"];
    assert!(!folder.run(&summary).answer().contains("sense checks"));
    let strict = folder.run(&[&summary[..], &["--strict"]].concat());
    assert!(strict.refusal().contains("--strict: case 1"), "{strict:?}");
    // What the file alone shows is refused before anything is solved.
    let soft = ["--set", "foundation.young_modulus=200", "--strict"];
    let soft = folder.run(&[&["sweep", "plain.toml", "-o", "soft"][..], &soft].concat());
    assert!(soft.refusal().contains("is \"200 GPa\" meant?"), "{soft:?}");
    assert!(!folder.path("soft").exists());

    folder.write("steel.toml", STEEL);
    let few = ["solve", "steel.toml", "--no-audit", "--vary"];
    folder.run(&[&few[..], &["load.force=0.4,0.8 MN/m", "--strict"]].concat()).answer();
    let slip = folder.run(&[&few[..], &["load.force=0.4,800 MN/m"]].concat());
    assert_eq!(slip.code, Some(0), "{slip:?}");
    assert!(slip.stdout.contains("warning: case 1 (load.force = 800 MN/m): the"), "{slip:?}");
    let strict = folder.run(&[&few[..], &["load.force=0.4,800 MN/m", "--strict"]].concat());
    assert!(strict.refusal().starts_with("error: --strict: case 1 (load.force = "), "{strict:?}");

    // Where the outputs do not tell, the varied values do; a case that is refused has its likely cause.
    let wide = ["--vary", "punch.half_width=2 mm,2 m,3 mm", "--outputs", "tilt", "--strict"];
    let wide = folder.run(&[&["solve", "steel.toml", "--no-audit"][..], &wide].concat());
    assert!(wide.refusal().contains("the half-width is 2 m"), "{wide:?}");
    let soft = ["--vary", "foundation.young_modulus=210,220", "--outputs", "settlement"];
    let soft = folder.run(&[&["solve", "steel.toml", "--no-audit"][..], &soft].concat());
    assert!(words(&soft.stdout).contains("is \"210 GPa\" meant?"), "{soft:?}");
}
