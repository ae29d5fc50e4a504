//! Raw traces: every option does what it says, and nothing is done in silence.

use std::f64::consts::PI;

use crate::cli::support::{Folder, UNILATERAL, assert_valid, number, schema};

const STEEL: &str = "[foundation]\nyoung_modulus = \"200 GPa\"\npoisson_ratio = 0.3\nroughness = \"1.2e-14 m/Pa\"\n\n[load]\nforce = \"0.8 MN/m\"\nmoment = 0\n\n[punch]\nhalf_width = \"5 mm\"\n";

/// Heights of a crown with a slope, over these positions (mm, um).
fn height(x: f64) -> f64 {
    0.02 * x * x + 0.05 * x
}

fn rows(places: impl Iterator<Item = f64>, row: impl Fn(f64, f64) -> String) -> String {
    places.map(|x| row(x, height(x))).collect()
}

fn even(from: f64, to: f64) -> impl Iterator<Item = f64> {
    (0..=120).map(move |i| from + (to - from) * f64::from(i) / 120.0)
}

/// Settlement, tilt and edge pressures with a profile.
fn answer(folder: &Folder, profile: &str) -> [f64; 4] {
    folder.write("punch.toml", format!("{STEEL}profile = {{ {profile} }}\n"));
    let json = folder.run(&["solve", "punch.toml", "--format", "json", "--no-audit"]).json();
    ["settlement", "tilt", "pressure_left", "pressure_right"]
        .map(|key| number(&json, &format!("/physical/{key}")))
}

#[track_caller]
fn assert_same(found: [f64; 4], expected: [f64; 4], what: &str) {
    for (one, other) in found.iter().zip(expected) {
        assert!(
            (one - other).abs() <= 1e-9 * other.abs() + 1e-15,
            "{what}: {found:?} for {expected:?}"
        );
    }
}

#[test]
fn every_way_of_writing_a_trace_is_read() {
    let folder = Folder::new();
    let plain = rows(even(-6.0, 6.0), |x, f| format!("{x},{f}\n"));
    folder.write("plain.csv", &plain);
    let units = "x_unit = \"mm\", f_unit = \"um\"";
    let expected = answer(&folder, &format!("csv = \"plain.csv\", {units}"));
    let german = |x: f64| format!("{x}").replace('.', ",");
    let table = "Perthometer\nProfil 7\nNr;Weg [mm];Zeit;Höhe [µm]\n".to_owned()
        + &rows(even(-6.0, 6.0), |x, f| format!("1;{};0;{}\n", german(x), german(f)));
    let tabs = rows(even(-6.0, 6.0), |x, f| format!("{}\t{}\n", german(x), german(f)));
    let utf_16: Vec<u8> = plain.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let latin: Vec<u8> = table.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect();
    let named = "skip = 2, x_column = \"Weg\", f_column = \"Höhe [µm]\"";
    let backward: String = plain.lines().rev().map(|line| format!("{line}\n")).collect();
    let reversed = rows(even(-6.0, 6.0), |x, f| format!("{},{f}\n", -x));
    let flipped = rows(even(-6.0, 6.0), |x, f| format!("{x},{}\n", -f));
    let from_zero = rows(even(-6.0, 6.0), |x, f| format!("{},{f}\n", x + 6.0));
    for (content, options) in [
        (table.clone().into_bytes(), named.to_owned()),
        (table.into_bytes(), "skip = 2, x_column = 2, f_column = 4".to_owned()),
        (latin.clone(), named.to_owned()),
        (latin, format!("{named}, encoding = \"latin1\"")),
        (tabs.into_bytes(), String::new()),
        (utf_16, String::new()),
        (backward.into_bytes(), String::new()),
        (reversed.into_bytes(), "reverse = true".to_owned()),
        (flipped.into_bytes(), "flip = true".to_owned()),
        (from_zero.clone().into_bytes(), "x_shift = \"-6 mm\"".to_owned()),
        (from_zero.into_bytes(), "centre = true".to_owned()),
    ] {
        folder.write("raw.csv", content);
        let comma = if options.is_empty() { "" } else { ", " };
        let profile = format!("csv = \"raw.csv\", {units}{comma}{options}");
        assert_same(answer(&folder, &profile), expected, &options);
    }
}

#[test]
fn the_mean_line_is_taken_off_over_the_base() {
    let folder = Folder::new();
    folder.write("raw.csv", rows(even(-6.0, 6.0), |x, f| format!("{x},{f}\n")));
    let raw = "csv = \"raw.csv\", x_unit = \"mm\", f_unit = \"um\"";
    let plain = answer(&folder, raw);
    let levelled = answer(&folder, &format!("{raw}, level = \"mean-line\""));
    // The line is 0.05 um/mm x plus the mean 0.02 a^2/3 of the crown: the tilt grows by the slope, the settlement by the mean.
    assert!((levelled[1] - plain[1] - 0.05e-3).abs() < 1e-9, "{plain:?} {levelled:?}");
    assert!(
        (levelled[0] - plain[0] + 0.02e-6 * 25.0 / 3.0).abs() < 1e-10,
        "{plain:?} {levelled:?}"
    );
    assert!((levelled[2] / plain[2] - 1.0).abs() < 1e-8, "{plain:?} {levelled:?}");
}

#[test]
fn the_filter_halves_a_wave_of_its_cutoff() {
    let folder = Folder::new();
    let wave = |x: f64| (2.0 * PI * x / 0.8).cos() + (2.0 * PI * x / 0.08).sin();
    let places = (0..=8000).map(|i| f64::from(i) / 8000.0 * 12.0 - 6.0);
    folder.write("raw.csv", places.map(|x| format!("{x},{}\n", wave(x))).collect::<String>());
    let trace = ["trace", "raw.csv", "--x-unit", "mm", "--f-unit", "um", "--cutoff", "0.8 mm"];
    let csv = folder.run(&[&trace[..], &["--format", "csv", "--units", "mm"]].concat()).answer();
    assert!(csv.starts_with("x [mm],f [µm]\n"), "{}", &csv[..40]);
    let mut looked_at = 0;
    for line in csv.lines().skip(1) {
        let (x, f) = line.split_once(',').unwrap();
        let (x, f): (f64, f64) = (x.parse().unwrap(), f.parse().unwrap());
        if x.abs() < 4.5 {
            looked_at += 1;
            let exact = 0.5 * (2.0 * PI * x / 0.8).cos();
            assert!((f - exact).abs() < 1e-6, "{x}: {f} for {exact}");
        }
    }
    assert!(looked_at > 100);
    // The problem file does the same: a crest under the middle.
    let with =
        |options: &str| format!("csv = \"raw.csv\", x_unit = \"mm\", f_unit = \"um\"{options}");
    let filter = ", filter = { kind = \"gauss\", cutoff = \"0.8 mm\" }";
    folder.write("filtered.csv", &csv);
    let treated = "csv = \"filtered.csv\", x_unit = \"mm\", f_unit = \"um\"";
    assert_same(answer(&folder, &with(filter)), answer(&folder, treated), "filter");
}

#[test]
fn a_trace_from_zero_is_refused_with_the_line_that_mends_it() {
    let folder = Folder::new();
    folder.write("raw.csv", rows(even(0.0, 12.0), |x, f| format!("{x},{f}\n")));
    let profile = "csv = \"raw.csv\", x_unit = \"mm\", f_unit = \"um\", flip = false";
    folder.write("punch.toml", format!("{STEEL}profile = {{ {profile} }}\n"));
    let run = folder.run(&["solve", "punch.toml"]);
    assert!(
        run.refusal().contains("does not cover the punch") && run.stderr.contains("lies elsewhere"),
        "{}",
        run.stderr
    );
    let line = run.stderr.lines().last().unwrap().trim();
    assert!(line.starts_with("profile = {") && line.contains("centre = true"), "{line}");
    folder.write("punch.toml", format!("{STEEL}{line}\n"));
    folder.run(&["solve", "punch.toml", "--no-audit"]).answer();
    // Too short is too short.
    folder.write("raw.csv", rows(even(0.0, 7.0), |x, f| format!("{x},{f}\n")));
    let short = folder.run(&["solve", "punch.toml"]);
    assert!(
        !short.stderr.contains("help:") && short.refusal().contains("does not cover"),
        "{}",
        short.stderr
    );
}

#[test]
fn a_trace_is_shown_before_and_after() {
    let folder = Folder::new();
    folder.write(
        "raw.csv",
        "x [mm];f [um]\n".to_owned() + &rows(even(0.0, 12.0), |x, f| format!("{x};{f}\n")),
    );
    let plain = folder.run(&["trace", "raw.csv"]);
    assert!(plain.stderr.contains("warning: the positions begin at 0"), "{}", plain.stderr);
    let plain = plain.answer();
    assert!(plain.contains("121 rows, UTF-8, separated by semicolons"), "{plain}");
    assert!(
        plain.contains("set: profile = { csv = \"raw.csv\", x_unit = \"mm\", f_unit = \"um\" }"),
        "{plain}"
    );
    let options =
        ["--centre", "--level", "mean-line", "--cutoff", "0.8 mm", "--half-width", "5 mm"];
    let trace = [&["trace", "raw.csv"][..], &options].concat();
    let table = folder.run(&[&trace[..], &["--plot", "t.svg"]].concat()).answer();
    let line = table.lines().find(|line| line.starts_with("set: ")).unwrap();
    folder.write("punch.toml", format!("{STEEL}{}\n", line.trim_start_matches("set: ")));
    folder.run(&["solve", "punch.toml", "--no-audit"]).answer();
    let svg = folder.read("t.svg");
    assert!(
        ["as read", "as used", "before the filter", "ends of the base"]
            .iter()
            .all(|name| svg.contains(name))
    );
    let json = folder.run(&[&trace[..], &["--format", "json"]].concat()).json();
    assert_valid(&schema("trace"), &json, "trace");
    assert_eq!(number(&json, "/before/x/0"), 0.0);
    assert_eq!(number(&json, "/after/x/0"), -6e-3);
    let refused = folder.run(&["trace", "raw.csv", "--half-width", "5 mm"]);
    assert!(refused.stderr.contains("--centre puts its middle"), "{}", refused.stderr);
}

#[test]
fn options_of_a_trace_that_make_no_sense_are_refused() {
    let folder = Folder::new();
    folder.write(
        "raw.csv",
        "a,b,c\n".to_owned() + &rows(even(-6.0, 6.0), |x, f| format!("{x},{f},0\n")),
    );
    for (options, said) in [
        ("", "got 3: x_column and f_column say which are meant"),
        ("x_column = 9, f_column = 2", "has 3 columns, and column 9 is asked for"),
        ("x_column = \"q\", f_column = 2", "has no column `q`, but a, b, c"),
        ("x_column = 1.5, f_column = 2", "is the number of a column, from 1, or its name"),
        ("x_column = 1, f_column = 2, centre = true, x_shift = \"1 mm\"", "x_shift"),
        ("x_column = 1, f_column = 2, level = \"plane\"", "is one of \"none\", \"mean-line\""),
        (
            "x_column = 1, f_column = 2, filter = { kind = \"spline\", cutoff = \"1 mm\" }",
            "is one of \"gauss\"",
        ),
        (
            "x_column = 1, f_column = 2, filter = { kind = \"gauss\", cutoff = \"0 mm\" }",
            "greater than zero",
        ),
        (
            "x_column = 1, f_column = 2, filter = { kind = \"gauss\", cutoff = \"1 um\" }",
            "less than 4 times the distance",
        ),
        ("x_column = 1, f_column = 2, encoding = \"ebcdic\"", "has no encoding `ebcdic`"),
        ("x_column = 1, f_column = 2, skip = -1", "skip"),
    ] {
        let comma = if options.is_empty() { "" } else { ", " };
        folder.write(
            "punch.toml",
            format!("{STEEL}profile = {{ csv = \"raw.csv\", x_unit = \"mm\", f_unit = \"um\"{comma}{options} }}\n"),
        );
        let run = folder.run(&["solve", "punch.toml"]);
        assert!(run.refusal().contains(said), "{options}: {}", run.stderr);
    }
}

#[test]
fn messages_have_the_units_and_the_option_of_the_user() {
    let folder = Folder::new();
    folder.write("mm.csv", "-6,1\n-1,0.2\n0,0.1\n1,0.2\n6,1\n");
    folder.write("two.csv", "x,f\nmm,um\n-6,1\n6,1\n");
    let trace = |file: &str, more: &[&str]| {
        let run =
            folder.run(&[&["trace", file, "--x-unit", "mm", "--f-unit", "um"], more].concat());
        run.refusal().to_owned()
    };
    for (cutoff, said) in [
        ("80 mm", "the cutoff of the filter, 80 mm, is longer than the trace, 12 mm"),
        (
            "8 um",
            "the cutoff of the filter, 0.008 mm, is less than 4 times the distance of neighbouring points, 5 mm",
        ),
    ] {
        let told = trace("mm.csv", &["--cutoff", cutoff]);
        assert!(told.contains(said), "{told}");
    }
    let told = trace("mm.csv", &["--half-width", "8 mm"]);
    assert!(told.contains("rows reach from -6 mm to 6 mm, the punch from -8 mm to 8 mm"), "{told}");
    let told = trace("two.csv", &[]);
    assert!(
        told.contains(
            "line 2: the position is not a number: `mm`; --skip 1 makes this line the header"
        ),
        "{told}"
    );
    // What is meant by it is read.
    folder.run(&["trace", "two.csv", "--skip", "1"]).answer();
}

/// Millimetres that are read in metres leave one row over the base.
#[test]
fn a_trace_without_units_and_with_one_row_over_the_base_is_doubted() {
    let rows: String = (-30..=30).map(|i| format!("{},0.0000001\n", f64::from(i) / 5.0)).collect();
    let folder = Folder::with(&UNILATERAL.replace("\"x^2 / (2*20)\"", "{ csv = \"t.csv\" }"));
    let said = "the trace has one row over the base, and no unit";
    let solve = ["solve", "punch.toml", "--no-audit"];
    for (header, is_doubted) in [("", true), ("x,f\n", true), ("x [m],f [m]\n", false)] {
        folder.write("t.csv", format!("{header}{rows}"));
        let table = folder.run(&solve).answer().split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(table.contains(said), is_doubted, "{header}: {table}");
        let strict = folder.run(&[&solve[..], &["--strict"]].concat());
        assert!(!is_doubted || strict.refusal().contains(said), "{header}: {}", strict.stderr);
        let run = folder.run(&["trace", "t.csv", "--half-width", "5 mm"]);
        assert_eq!(run.stderr.contains(said), is_doubted, "{header}: {}", run.stderr);
        let run = folder.run(&["trace", "t.csv"]);
        let is_long = run.stderr.contains("12 m in all: are millimetres meant? --x-unit mm");
        assert_eq!(is_long, is_doubted, "{header}: {}", run.stderr);
    }
    folder.write("t.csv", &rows);
    let stated = ["--set", "punch.profile={ csv = \"t.csv\", x_unit = \"mm\" }"];
    let table = folder.run(&[&solve[..], &stated].concat()).answer();
    assert!(!table.contains("over the base, and"), "{table}");
}

/// Separators of thousands are no decimal commas, in quotes or beside semicolons, and are told as they are written.
#[test]
fn a_cell_that_is_no_number_is_told_as_it_is_written() {
    let folder = Folder::new();
    for text in ["x,f\n\"-6,000.00\",1\n0,0\n", "x;f\n-6,000.00;1\n0;0\n"] {
        folder.write("t.csv", text);
        let refusal = folder.run(&["trace", "t.csv", "--x-unit", "mm"]);
        assert!(refusal.refusal().contains("line 2: the position is not a number: `-6,000.00`"));
    }
    folder.write("t.csv", "x,f\n\"-6\",\"1\"\n\"0\",\"0\"\n");
    folder.run(&["trace", "t.csv", "--x-unit", "mm", "--f-unit", "um"]).answer();
    let run = folder.run(&["trace", "t.csv", "--x-unit", "mm", "--cutoff", "-0.25 mm"]);
    assert!(run.refusal().contains("--cutoff `-0.25 mm`: must be greater than zero"));
}

#[test]
fn an_empty_file_has_the_lines_to_add() {
    let folder = Folder::with("\n");
    let run = folder.run(&["solve", "punch.toml"]);
    assert!(run.refusal().contains("the file is empty"));
    for line in ["[foundation]", "[punch]", "half_width = \"5 mm\"", "[load]"] {
        assert!(run.stderr.contains(line), "{}", run.stderr);
    }
}

/// Lines that are skipped may have been the header; heights in metres beside positions in millimetres are doubted.
#[test]
fn heights_without_a_unit_beside_positions_with_one_are_doubted() {
    let rows: String = (-30..=30).map(|i| format!("{},0.0000001\n", f64::from(i) / 5.0)).collect();
    let said = "a unit for its positions and none for its heights, which are read in metres";
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    for (content, options, is_doubted) in [
        (format!("x [mm],f [um]\n{rows}"), "skip = 1, x_unit = \"mm\"", true),
        (format!("x [mm],f [um]\n{rows}"), "skip = 1, x_unit = \"mm\", f_unit = \"um\"", false),
        (format!("x,f\nmm,\n{rows}"), "skip = 1, x_unit = \"mm\"", true),
        (format!("x,f [m]\n{rows}"), "x_unit = \"mm\"", false),
    ] {
        let profile = format!("{{ csv = \"t.csv\", {options} }}");
        let folder = Folder::with(&UNILATERAL.replace("\"x^2 / (2*20)\"", &profile));
        folder.write("t.csv", content);
        let table = words(&folder.run(&["solve", "punch.toml", "--no-audit"]).answer());
        assert_eq!(table.contains(said), is_doubted, "{options}: {table}");
    }
    let folder = Folder::new();
    folder.write("t.csv", &rows);
    let run = folder.run(&["trace", "t.csv", "--x-unit", "mm"]);
    assert!(run.stderr.contains(said) && run.stderr.contains("--f-unit"), "{run:?}");
}

/// A unit that the header does not have is told with the line that has it.
#[test]
fn a_unit_against_the_header_is_told_with_that_of_the_header() {
    let profile = "{ csv = \"t.csv\", x_unit = \"um\", f_unit = \"um\" }";
    let folder = Folder::with(&UNILATERAL.replace("\"x^2 / (2*20)\"", profile));
    folder.write("t.csv", "x [mm],f [um]\n-6,1\n0,0\n6,1\n");
    let run = folder.run(&["solve", "punch.toml"]);
    assert!(run.refusal().contains("the header has the position in mm"), "{}", run.stderr);
    let mended = "profile = { csv = \"t.csv\", f_unit = \"um\", x_unit = \"mm\" }";
    assert!(run.stderr.contains(mended), "{}", run.stderr);
}
