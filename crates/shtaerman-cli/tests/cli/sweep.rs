//! `shtaerman sweep`: every case is what `solve` says, and whatever ends a run, the next one comes to the same bytes.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::cli::support::{Folder, PROGRAM, repository};

const STUDY: &str = r#"[foundation]
young_modulus = "200 GPa"
poisson_ratio = 0.3
roughness = "1.2e-14 m/Pa"

[punch]
half_width = "5 mm"
profile = "x^2 / (2*20)"

[load]
force = "0.8 MN/m"
moment = 0

[study]
vary."load.force" = { from = "0.2 MN/m", to = "1 MN/m", count = 5 }
vary."foundation.roughness" = ["1e-14 m/Pa", "1e-13 m/Pa"]
outputs = ["settlement", "peak_pressure"]
audited_sample = 2
part_size = 3
"#;

fn folder(study: &str) -> Folder {
    let folder = Folder::new();
    std::fs::write(folder.path("study.toml"), study).unwrap();
    folder
}

/// The files of a folder of results.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries
        .map(|path| {
            (path.file_name().unwrap().to_str().unwrap().to_owned(), std::fs::read(&path).unwrap())
        })
        .collect()
}

/// The lines of all parts but their heads, as fields.
fn rows(folder: &Path) -> Vec<Vec<String>> {
    let parts = files(folder).into_iter().filter(|(name, _)| name.ends_with(".csv"));
    parts
        .flat_map(|(_, bytes)| {
            let text = String::from_utf8(bytes).unwrap();
            let lines: Vec<Vec<String>> = text
                .lines()
                .skip(1)
                .map(|line| line.split(',').map(str::to_owned).collect())
                .collect();
            lines
        })
        .collect()
}

#[test]
fn every_case_is_what_solve_says_to_the_last_bit() {
    let folder = folder(STUDY);
    let text = folder.run(&["sweep", "study.toml", "-o", "out"]).answer();
    assert!(text.contains("10 cases answered, 0 refused"), "{text}");
    assert!(text.contains("audit of a sample of 2 cases: 0 not kept"), "{text}");
    let rows = rows(&folder.path("out"));
    assert_eq!(rows.len(), 10);
    let problem = STUDY.split("[study]").next().unwrap();
    std::fs::write(folder.path("punch.toml"), problem).unwrap();
    for (index, row) in rows.iter().enumerate() {
        assert_eq!(row[0], index.to_string());
        // Keys are in alphabetical order, and the last changes fastest.
        let [roughness, force] = [&row[1], &row[2]];
        assert_eq!(roughness.parse::<f64>().unwrap(), if index < 5 { 1e-14 } else { 1e-13 });
        assert!((force.parse::<f64>().unwrap() - (2e5 + 2e5 * (index % 5) as f64)).abs() < 1e-9);
        let answer = folder
            .run(&[
                "solve",
                "punch.toml",
                "--no-audit",
                "--format",
                "json",
                "--set",
                &format!("foundation.roughness={roughness}"),
                "--set",
                &format!("load.force={force}"),
            ])
            .json();
        for (name, column) in [("settlement", 3), ("peak_pressure", 5)] {
            let value = answer["physical"][name].as_f64().unwrap();
            assert_eq!(row[column].parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
        let error = answer["error"]["physical"]["settlement"].as_f64().unwrap();
        assert_eq!(row[4].parse::<f64>().unwrap().to_bits(), error.to_bits());
    }
}

#[test]
fn threads_shares_and_broken_parts_come_to_the_same_bytes() {
    let folder = folder(STUDY);
    folder.run(&["sweep", "study.toml", "-o", "one", "--threads", "1"]).answer();
    let whole = files(&folder.path("one"));
    assert_eq!(whole.len(), 5);
    folder.run(&["sweep", "study.toml", "-o", "three", "--threads", "3"]).answer();
    assert_eq!(files(&folder.path("three")), whole);
    for shard in ["2/3", "3/3", "1/3"] {
        folder.run(&["sweep", "study.toml", "-o", "shares", "--shard", shard]).answer();
    }
    assert_eq!(files(&folder.path("shares")), whole);

    std::fs::remove_file(folder.path("one/part-00000001.csv")).unwrap();
    let cut = &whole["part-00000002.csv"];
    std::fs::write(folder.path("one/part-00000002.csv"), &cut[..cut.len() - 9]).unwrap();
    std::fs::write(folder.path("one/part-00000003.csv"), &whole["part-00000000.csv"]).unwrap();
    let looked = folder.run(&["sweep", "study.toml", "-o", "one", "--summary"]);
    assert!(looked.stdout.contains("0 computed, 1 kept, 3 missing, of 4"), "{looked:?}");
    let again = folder.run(&["sweep", "study.toml", "-o", "one"]);
    assert_eq!(again.code, Some(0), "{again:?}");
    assert!(again.stderr.contains("part-00000002.csv: is cut short"), "{again:?}");
    assert!(again.stdout.contains("3 computed, 1 kept, 0 missing, of 4"), "{again:?}");
    assert_eq!(files(&folder.path("one")), whole);
}

#[test]
fn a_killed_run_goes_on_to_the_same_bytes() {
    let folder = folder(&STUDY.replace("part_size = 3", "part_size = 1"));
    folder.run(&["sweep", "study.toml", "-o", "whole"]).answer();
    let whole = files(&folder.path("whole"));
    for wait in [1, 4, 7, 11, 16, 25] {
        let out = format!("killed{wait}");
        let mut run = Command::new(PROGRAM)
            .current_dir(folder.path(""))
            .args(["sweep", "study.toml", "-o", &out])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(wait * 4));
        let _ = run.kill();
        run.wait().unwrap();
        let again = folder.run(&["sweep", "study.toml", "-o", &out]);
        assert_eq!(again.code, Some(0), "{again:?}");
        let mut found = files(&folder.path(&out));
        // What SIGKILL leaves of a file that was being written lies beside, under a name of its own.
        found.retain(|name, _| !name.starts_with('.'));
        assert_eq!(found, whole, "killed after {wait}");
    }
}

#[test]
fn cases_without_an_answer_say_why_and_the_others_go_on() {
    // Whether it is the last case or the first.
    for forces in ["[8e5, -1.0]", "[-1.0, 8e5]"] {
        let range = "{ from = \"0.2 MN/m\", to = \"1 MN/m\", count = 5 }";
        let folder = folder(&STUDY.replace(range, forces));
        let text = folder.run(&["sweep", "study.toml", "-o", "out"]).answer();
        assert!(text.contains("2 cases answered, 2 refused"), "{text}");
        let refused: Vec<_> =
            rows(&folder.path("out")).into_iter().filter(|row| row[3] == "NaN").collect();
        assert_eq!(refused.len(), 2);
        assert!(refused.iter().all(|row| row[1..].join(",").contains("force")), "{refused:?}");
    }
}

#[test]
fn drawn_cases_belong_to_their_seed() {
    let drawn = |design: &str, seed: u64| {
        let study = STUDY
            .replace("{ from = \"0.2 MN/m\", to = \"1 MN/m\", count = 5 }", "{ distribution = \"normal\", mean = \"0.5 MN/m\", standard_deviation = \"1 kN/m\" }")
            .replace("[study]\n", &format!("[study]\ndesign = \"{design}\"\ncount = 6\nseed = {seed}\n"));
        let folder = folder(&study);
        folder.run(&["sweep", "study.toml", "-o", "out"]).answer();
        rows(&folder.path("out")).into_iter().map(|row| row[2].clone()).collect::<Vec<_>>()
    };
    for design in ["latin-hypercube", "sobol", "random"] {
        let one = drawn(design, 1);
        assert_eq!(one, drawn(design, 1));
        assert_ne!(one, drawn(design, 2));
        let mean = one.iter().map(|force| force.parse::<f64>().unwrap()).sum::<f64>() / 6.0;
        assert!((mean - 5e5).abs() < 2e3, "{design}: {mean}");
    }
}

#[test]
fn what_is_wrong_with_a_study_is_told() {
    let force = "{ from = \"0.2 MN/m\", to = \"1 MN/m\", count = 5 }";
    for (old, new, words) in [
        (force, "{ from = \"0.2 MPa\", to = \"1 MN/m\", count = 5 }", "is refused"),
        (force, "{ from = 1, to = 2 }", "has no count, which a grid needs"),
        (
            force,
            "{ from = 0, to = 2, count = 3, scale = \"log\" }",
            "must be greater than 0 on a logarithmic scale",
        ),
        (force, "[]", "is empty"),
        ("\"peak_pressure\"", "\"peak\"", "peak_pressure"),
        ("\"peak_pressure\"", "\"settlement\"", "names settlement twice"),
        ("vary.\"load.force\"", "vary.force", "quote the dotted key"),
        ("vary.\"load.force\"", "vary.\"load.forse\"", "load.forse"),
        ("part_size = 3", "part_size = 0", "part_size"),
        ("part_size = 3", "parts = 3", "parts"),
        ("part_size = 3", "count = 3", "goes with design"),
        ("[study]", "[studies]", "study"),
        ("vary.\"load.force\"", "vary.\"study.part_size\"", "is no key of the problem"),
        (force, "{ from = 1, to = 2, count = 10000000000000000 }", "count"),
    ] {
        let folder = folder(&STUDY.replacen(old, new, 1));
        let run = folder.run(&["sweep", "study.toml", "-o", "out"]);
        run.refusal();
        assert!(run.stderr.contains(words), "{new}: {}", run.stderr);
        assert!(!folder.path("out").exists());
    }
    let folder = folder(STUDY);
    let huge = ["sweep", "study.toml", "-o", "out", "--set", "study.vary.load.force=1"];
    folder.run(&huge).refusal();
    for (arguments, words) in [
        (["-o", "out", "--shard", "3/2"], "must be I/N"),
        (["-o", "out", "--threads", "0"], "must be from 1"),
        (["-o", "study.toml", "--threads", "1"], "is a file"),
        (["-o", "none", "--summary", "--yes"], "there is no folder"),
        (["-o", "out", "--plot", "study.toml"], "use .svg"),
    ] {
        let run = folder.run(&[&["sweep", "study.toml"], arguments.as_slice()].concat());
        run.refusal();
        assert!(run.stderr.contains(words), "{arguments:?}: {}", run.stderr);
    }
}

#[test]
fn what_is_wrong_with_a_drawn_study_is_told_where_it_stands() {
    let drawn = STUDY.split("[study]").next().unwrap().to_owned()
        + r#"[study]
design = "sobol-indices"
count = 16
vary."load.force" = { distribution = "uniform", from = "0.2 MN/m", to = "1 MN/m" }
outputs = ["settlement"]
"#;
    for (old, new, words) in [
        // A standard error needs more than one group.
        ("count = 16", "count = 1", "study.count"),
        ("load.force\" =", "load.forse\" =", "study.toml:17: study.vary.load.forse"),
        ("load.force\" =", "load.moments\" =", "load.moments: is not a known key"),
    ] {
        let folder = folder(&drawn.replacen(old, new, 1));
        let run = folder.run(&["sweep", "study.toml", "-o", "out"]);
        assert!(run.refusal().contains(words), "{new}: {}", run.stderr);
        assert!(!run.stderr.contains("--set"), "{new}: {}", run.stderr);
    }
    folder(&drawn).run(&["sweep", "study.toml", "-o", "out"]).answer();
}

#[test]
fn a_huge_study_asks_first_and_a_folder_of_another_is_left_alone() {
    let huge = STUDY.replace("count = 5", "count = 1000000");
    let folder = folder(&huge);
    let run = folder.run(&["sweep", "study.toml", "-o", "out"]);
    assert!(run.refusal().contains("2000000 cases"), "{run:?}");
    assert!(run.stderr.contains("--yes") && !folder.path("out").exists());

    std::fs::write(folder.path("study.toml"), STUDY).unwrap();
    folder.run(&["sweep", "study.toml", "-o", "out"]).answer();
    let before = files(&folder.path("out"));
    let run = folder.run(&["sweep", "study.toml", "-o", "out", "--set", "load.moment=1"]);
    assert!(run.refusal().contains("another study"), "{run:?}");
    assert_eq!(files(&folder.path("out")), before);
    std::fs::create_dir(folder.path("full")).unwrap();
    std::fs::write(folder.path("full/notes.txt"), "mine").unwrap();
    let run = folder.run(&["sweep", "study.toml", "-o", "full"]);
    assert!(run.refusal().contains("no folder of results"), "{run:?}");
}

#[test]
fn the_studies_of_the_examples_run() {
    let folder = Folder::new();
    for (name, cases) in [("force_and_roughness", 36), ("tolerances", 64)] {
        let study = repository().join(format!("examples/studies/{name}.toml"));
        let plot = format!("{name}.svg");
        let text = folder
            .run(&["sweep", study.to_str().unwrap(), "-o", name, "--plot", &plot, "--strict"])
            .answer();
        assert!(text.contains(&format!("{cases} cases answered, 0 refused")), "{text}");
        let drawn = std::fs::read_to_string(folder.path(&plot)).unwrap();
        roxmltree::Document::parse(&drawn).unwrap();
    }
}

#[test]
fn sobols_indices_of_a_linear_answer_add_up() {
    // On the whole base the settlement is linear in the force for a flat punch: all of its variance is that of the force.
    let study = r#"[dimensionless]
theta0 = 2.0
profile = "0"
force = 1.0
moment = 0
[solver]
contact = "bilateral"
[study]
design = "sobol-indices"
count = 64
vary."dimensionless.force" = { from = 1.0, to = 2.0 }
vary."dimensionless.moment" = { from = -0.1, to = 0.1 }
outputs = ["settlement", "tilt"]
audited_sample = 0
"#;
    let folder = folder(study);
    let text = folder.run(&["sweep", "study.toml", "-o", "out"]).answer();
    let indices: Vec<Vec<&str>> = text
        .lines()
        .skip_while(|line| !line.starts_with("Sobol's"))
        .map(|line| line.split_whitespace().collect::<Vec<_>>())
        .filter(|words| words.get(1).is_some_and(|word| word.starts_with("dimensionless.")))
        .collect();
    assert_eq!(indices.len(), 4, "{text}");
    for words in indices {
        let matters = (words[0] == "settlement") == (words[1] == "dimensionless.force");
        for (place, room) in [(2, 0.35), (4, 0.05)] {
            let found: f64 = words[place].parse().unwrap();
            let exact = f64::from(u8::from(matters));
            assert!((found - exact).abs() < room, "{words:?}");
        }
    }
}

#[test]
fn parts_are_arrays_for_numpy_too_and_a_cut_one_is_done_again() {
    let folder = Folder::new();
    folder.write("study.toml", STUDY);
    folder.run(&["sweep", "study.toml", "-o", "text"]).answer();
    folder.run(&["sweep", "study.toml", "-o", "arrays", "--format", "npz"]).answer();
    let part = folder.path("arrays/part-00000000.npz");
    let whole = std::fs::read(&part).unwrap();
    let told = folder.run(&["sweep", "study.toml", "-o", "arrays", "--format", "npz"]).answer();
    assert!(told.contains(" 0 computed"), "{told}");
    std::fs::write(&part, &whole[..whole.len() - 40]).unwrap();
    let again = folder.run(&["sweep", "study.toml", "-o", "arrays", "--format", "npz"]);
    assert!(again.stderr.contains("is cut short: it is computed again"), "{}", again.stderr);
    assert!(std::fs::read(&part).unwrap() == whole);
    // One bit.
    let mut flipped = whole.clone();
    flipped[whole.len() / 2] ^= 1;
    std::fs::write(&part, &flipped).unwrap();
    folder.run(&["sweep", "study.toml", "-o", "arrays", "--format", "npz"]).answer();
    assert!(std::fs::read(&part).unwrap() == whole);
    let other = folder.run(&["sweep", "study.toml", "-o", "text", "--format", "npz"]);
    assert_eq!(other.code, Some(2));
    assert!(other.stderr.contains("has results of this study as csv, not npz"), "{}", other.stderr);
    if !cfg!(feature = "parquet") {
        let refused = folder.run(&["sweep", "study.toml", "-o", "p", "--format", "parquet"]);
        assert_eq!(refused.code, Some(2));
        assert!(refused.stderr.contains("--features parquet"), "{}", refused.stderr);
        assert!(!folder.path("p").exists());
    }
}

#[test]
fn a_few_cases_need_no_file() {
    let folder = Folder::new();
    folder.write("punch.toml", crate::cli::support::PHYSICAL);
    let csv = folder
        .run(&["solve", "punch.toml", "--vary", "load.force=0.2..1 MN/m:5", "--format", "csv"])
        .answer();
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines.len(), 6, "{csv}");
    let place = lines[0].split(',').position(|name| name == "settlement").unwrap();
    let alone =
        folder.run(&["solve", "punch.toml", "--set", "load.force=0.4 MN/m", "--format", "json"]);
    let settlement = alone.json()["physical"]["settlement"].as_f64().unwrap();
    let told: f64 = lines[2].split(',').nth(place).unwrap().parse().unwrap();
    assert_eq!(told, settlement);
    assert!(lines[2].contains("bound"), "each case is audited: {csv}");

    let grid = [
        "solve",
        "punch.toml",
        "--vary",
        "load.force=0.2..1 MN/m:3:log",
        "--vary",
        "foundation.roughness=1e-14,1e-13 m/Pa",
        "--outputs",
        "settlement,peak_pressure",
        "--no-audit",
    ];
    let json =
        folder.run(&[grid.as_slice(), &["--format", "json", "--plot", "map.svg"]].concat()).json();
    assert_eq!(json["settlement"].as_array().unwrap().len(), 6);
    assert_eq!(json["foundation.roughness"][3], 1e-13);
    // The middle of a logarithmic range is the geometric mean of its ends.
    assert!(
        (json["load.force"][1].as_f64().unwrap() / (0.2e6f64 * 1e6).sqrt() - 1.0).abs() < 1e-14
    );
    assert!(folder.read("map.svg").contains("settlement"));
    let table = folder.run(&grid).answer();
    assert!(table.contains("largest errors (") && table.contains("): settlement"), "{table}");

    for (vary, said) in [
        ("load.force", "write KEY=FROM..TO:COUNT"),
        ("load.force=1..2", "write KEY=FROM..TO:COUNT"),
        ("load.force=1,,2", "write KEY=FROM..TO:COUNT"),
        ("load.forse=1..2:3", "load.forse"),
        ("load.force=1..2 mm:3", "load.force"),
        ("load.force=1..2:100000", "at most 10000"),
        ("foundation.poisson_ratio=0.7,0.8", "poisson_ratio"),
    ] {
        let refused = folder.run(&["solve", "punch.toml", "--vary", vary]);
        assert_eq!(refused.code, Some(2), "{vary}: {}", refused.stderr);
        assert!(refused.stderr.contains(said), "{vary}: {}", refused.stderr);
    }
}

#[test]
fn other_commands_know_a_study_when_they_see_one() {
    let folder = folder(STUDY);
    let solved = folder.run(&["solve", "study.toml"]);
    assert_eq!(solved.code, Some(2));
    assert!(
        solved.stderr.contains("help: a study is computed by `shtaerman sweep"),
        "{}",
        solved.stderr
    );
    let valid = folder.run(&["validate", "study.toml"]).answer();
    assert!(
        valid.contains("valid; study of 10 cases over foundation.roughness, load.force"),
        "{valid}"
    );
    let broken = folder.run(&["validate", "study.toml", "--set", "study.design=sobel"]);
    assert_eq!(broken.code, Some(2), "{}", broken.stderr);
}

/// Parts as CSV are in the units of the file, and their heads say so; a run that goes on finds them, and what it tells is the same.
#[test]
fn parts_are_in_the_units_of_the_file() {
    let folder = folder(STUDY);
    let own = "\n[output]\nunits = { length = \"in\", displacement = \"mil\", pressure = \"ksi\", force = \"kip/ft\" }\n";
    std::fs::write(folder.path("own.toml"), format!("{STUDY}{own}")).unwrap();
    let sweep = |file: &str, output: &str, more: &[&str]| {
        folder.run(&[&["sweep", file, "--output", output], more].concat()).answer()
    };
    sweep("study.toml", "si", &[]);
    let told = sweep("own.toml", "own", &[]);
    let part = std::fs::read_to_string(folder.path("own/part-00000000.csv")).unwrap();
    let heads = "case,foundation.roughness [m/Pa],load.force [kip/ft],settlement [mil],settlement_error [mil],peak_pressure [ksi],peak_pressure_error [ksi],error_kind,warnings,reason";
    assert_eq!(part.lines().next(), Some(heads));
    // 1 kip/ft is 14593.9029.. N/m; 1 mil 25.4 um; 1 ksi 6.894757.. MPa.
    let units = [
        1.0,
        1.0,
        14_593.902_937_206_36,
        25.4e-6,
        25.4e-6,
        6_894_757.293_168_36,
        6_894_757.293_168_36,
    ];
    let (si, own) = (rows(&folder.path("si")), rows(&folder.path("own")));
    assert_eq!((si.len(), own.len()), (10, 10));
    for (si, own) in si.iter().zip(&own) {
        for ((si, own), unit) in si.iter().zip(own).zip(units) {
            let [Ok(si), Ok(own)] = [si, own].map(|text| text.parse::<f64>()) else {
                assert_eq!(si, own);
                continue;
            };
            assert!((own * unit - si).abs() <= 1e-14 * si.abs(), "{own} {unit} {si}");
        }
    }
    // What is there is kept, a part that was changed is done again, and what is told is the same.
    let before = files(&folder.path("own"));
    let again = sweep("own.toml", "own", &[]);
    assert!(again.contains("parts: 0 computed, 4 kept"), "{again}");
    let digits = |told: &str| {
        told.lines()
            .filter(|line| !line.starts_with("parts: "))
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(digits(&again), digits(&told));
    let changed = part.replacen("0,", "1,", 1);
    std::fs::write(folder.path("own/part-00000000.csv"), changed).unwrap();
    let run = folder.run(&["sweep", "own.toml", "--output", "own"]);
    assert!(run.stderr.contains("it is computed again"), "{}", run.stderr);
    assert_eq!(files(&folder.path("own")), before);
    // --units of one run is for what that run shows, and NPZ is SI.
    let option = sweep("study.toml", "si", &["--units", "mm", "--summary"]);
    assert!(option.contains("settlement [mm]") || option.contains("[µm]"), "{option}");
    sweep("own.toml", "npz", &["--format", "npz"]);
    let npz = std::fs::read(folder.path("npz/part-00000000.npz")).unwrap();
    let names = String::from_utf8_lossy(&npz).into_owned();
    assert!(names.contains("settlement.npy") && !names.contains("settlement [mil]"));
}
