//! `--at`, `--points` and the pressure curve as CSV.

use crate::cli::support::{DIMENSIONLESS, Folder, PHYSICAL};

fn curve(folder: &Folder, options: &[&str]) -> (String, Vec<[f64; 2]>) {
    let csv = folder.run(&[&["solve", "punch.toml", "--format", "csv"], options].concat()).answer();
    let (header, rows) = csv.split_once('\n').unwrap();
    let rows = rows.lines().map(|line| {
        let (x, p) = line.split_once(',').unwrap();
        [x.parse().unwrap(), p.parse().unwrap()]
    });
    (header.to_owned(), rows.collect())
}

#[test]
fn places_are_metres_or_have_a_unit() {
    let folder = Folder::with(PHYSICAL);
    let (header, metres) = curve(&folder, &["--at", "-0.005,0,0.0025,-0.001"]);
    assert_eq!(header, "x,pressure");
    assert_eq!(metres.iter().map(|row| row[0]).collect::<Vec<_>>(), [-5e-3, 0.0, 2.5e-3, -1e-3]);
    for same in ["-5 mm, 0, 2.5mm, -1000 um", " -5e-3 m ,0 mm,0.25 cm,-1 mm "] {
        assert_eq!(curve(&folder, &["--at", same]).1, metres, "{same}");
    }
    // A positive moment loads the right edge.
    let (_, edges) = curve(&folder, &["--at", "-5mm,5mm"]);
    assert!(edges[1][1] > edges[0][1]);
}

#[test]
fn an_edge_is_an_edge_in_every_unit() {
    let folder = Folder::with(&PHYSICAL.replace("5 mm", "5.08 mm"));
    let (_, rows) = curve(&folder, &["--at", "5.08 mm,0.2 in,200 mil,5080 um,0.508 cm"]);
    assert!(rows.iter().all(|row| *row == rows[0]), "{rows:?}");
}

#[test]
fn places_of_a_dimensionless_file_are_xi() {
    let folder = Folder::with(DIMENSIONLESS);
    let (header, rows) = curve(&folder, &["--at", "-1,-0.5,0,1"]);
    assert_eq!(header, "x,pressure");
    assert_eq!(rows.iter().map(|row| row[0]).collect::<Vec<_>>(), [-1.0, -0.5, 0.0, 1.0]);
    // In a half-width of 1 m the places are the same numbers.
    let json = folder.run(&["solve", "punch.toml", "--format", "json", "--at", "-0.5"]).json();
    assert_eq!(json["pressure"]["pressure"][0].as_f64(), Some(rows[1][1]));
}

#[test]
fn the_curve_reaches_from_edge_to_edge() {
    let folder = Folder::with(PHYSICAL);
    for (options, count) in
        [([].as_slice(), 201), (&["--points", "2"], 2), (&["--points", "17"], 17)]
    {
        let (_, rows) = curve(&folder, options);
        assert_eq!(rows.len(), count);
        assert_eq!((rows[0][0], rows[count - 1][0]), (-5e-3, 5e-3));
        assert!(rows.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    }
}

#[test]
fn the_table_shows_the_places_asked_for() {
    let folder = Folder::with(PHYSICAL);
    let plain = folder.run(&["solve", "punch.toml"]).answer();
    let table = folder.run(&["solve", "punch.toml", "--at", "2.5 mm"]).answer();
    assert!(table.contains("2.5 mm") && !plain.contains("2.5 mm"), "{table}");
    for said in ["µm", "MPa", "kN/m", "theta0 = 1.2069", "n = 40", "ln(a/|x-s|)"] {
        assert!(table.contains(said), "{said}: {table}");
    }
}

#[test]
fn bad_places_are_refused() {
    for (problem, at, said) in [
        (PHYSICAL, "6 mm", "`6 mm`: is beyond the punch, which reaches from -5 mm to 5 mm"),
        (PHYSICAL, "0,-5.0001 mm", "beyond the punch"),
        (PHYSICAL, "1 Pa", "is a length (like \"5 mm\"), got Pa, a pressure"),
        (PHYSICAL, "", "is empty"),
        (PHYSICAL, "1 mm,,2 mm", "is empty"),
        (PHYSICAL, "here", "`here`: does not begin with a number"),
        (PHYSICAL, "nan", "is nan, a finite number was expected"),
        (PHYSICAL, "inf", "is inf"),
        (PHYSICAL, "1e999", "is too large"),
        (DIMENSIONLESS, "1.5", "`1.5`: is beyond the punch, which reaches from -1 to 1"),
        (DIMENSIONLESS, "1 mm", "got mm, a length"),
    ] {
        let folder = Folder::with(problem);
        let run = folder.run(&["solve", "punch.toml", "--at", at, "--output", "out.txt"]);
        let message = run.refusal();
        assert!(message.contains("--at") && message.contains(said), "{at}: {message}");
        assert_eq!(folder.files(), ["punch.toml"]);
    }
}
