//! `--report`: one file with all that is needed to check and to repeat an answer.

use std::path::Path;
use std::process::Command;

use crate::cli::support::{DIMENSIONLESS, Folder, PROGRAM, UNILATERAL, repository};

/// The report of a command in the folder.
fn report(folder: &Folder, arguments: &[&str]) -> String {
    let all = [arguments, &["--report", "report.html"]].concat();
    let printed = folder.run(&all).answer();
    let plain = folder.run(arguments).answer();
    assert_eq!(printed, format!("{plain}report: report.html\n"));
    std::fs::read_to_string(folder.path("report.html")).unwrap()
}

/// Nothing is loaded from elsewhere, and nothing runs.
fn assert_self_contained(html: &str) {
    assert!(html.starts_with("<!doctype html>"));
    for word in
        ["<script", "<link", "src=\"http", "@import", "javascript:", "<iframe", "href=\"http"]
    {
        assert!(!html.contains(word), "{word}");
    }
    assert!(html.contains("Content-Security-Policy\" content=\"default-src 'none'"));
    // Pictures and formulas are XML of their own.
    for (tag, least) in [("svg", 0), ("math", 0)] {
        let mut rest = html;
        let mut count = 0;
        while let Some(start) = rest.find(&format!("<{tag} ")) {
            let end = start + rest[start..].find(&format!("</{tag}>")).unwrap() + tag.len() + 3;
            let parsed = roxmltree::Document::parse(&rest[start..end]);
            assert!(parsed.is_ok(), "{tag}: {:?}", parsed.err());
            rest = &rest[end..];
            count += 1;
        }
        assert!(count >= least);
    }
}

#[test]
fn a_report_has_inputs_model_answer_picture_error_checks_and_the_command() {
    let inch = UNILATERAL.replace("\"5 mm\"", "\"0.2 in\"");
    let folder = Folder::with(&inch);
    let arguments = ["solve", "punch.toml", "--set", "load.force=1 MN/m", "--at", "0, 1 mm"];
    let html = report(&folder, &arguments);
    assert_self_contained(&html);
    let row = |key: &str, given: &str, si: &str, place: &str| {
        format!(
            "<tr><th scope=\"row\">{key}</th><td>{given}</td><td>{si}</td><td class=\"note\">{place}</td></tr>"
        )
    };
    for expected in [
        // 0.2 in are 5.08 mm exactly.
        row("punch.half_width", "0.2 in", "0.00508 m", "line 7"),
        row("load.force", "1 MN/m", "1000000 N/m", "--set"),
        row("load.moment", "100 N", "100 N m/m", "line 12"),
        row("solver.contact", "", "unilateral", "as usual"),
        row("--at", "0, 1 mm", "", "command line"),
    ] {
        assert!(html.contains(&expected), "{expected}\n{html}");
    }
    // The command repeats it, as a shell reads it.
    let command = "<pre>shtaerman solve punch.toml --set 'load.force=1 MN/m' --at '0, 1 mm' --report report.html</pre>";
    assert!(html.contains(command));
    assert!(html.contains(&format!("Shtaerman {}", env!("CARGO_PKG_VERSION"))));
    // The sum of check is that of the file, by another program.
    if let Ok(told) = Command::new("sha256sum").arg(folder.path("punch.toml")).output() {
        let sum = String::from_utf8(told.stdout).unwrap();
        assert!(html.contains(sum.split(' ').next().unwrap()), "{sum}");
    }
    // Each value of the table is in it.
    let table = folder.run(&["solve", "punch.toml", "--set", "load.force=1 MN/m"]).answer();
    for name in ["settlement", "tilt", "pressure, largest"] {
        let line = table.lines().find(|line| line.starts_with(&format!(" {name} "))).unwrap();
        let value = line[name.len() + 1..].trim().split("  ").next().unwrap();
        assert!(html.contains(&format!("<b>{value}</b>")), "{value}");
    }
    assert!(html.contains("<math display=\"block\">") && html.contains("<svg "));
    assert!(
        html.contains("<dt>audit (bound)</dt>") && html.contains("<dt>error (bound), at most</dt>")
    );
    assert!(html.contains("Nothing was found that an engineer would doubt."));
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let folder = Folder::with(UNILATERAL);
    let first = report(&folder, &["solve", "punch.toml"]);
    assert_eq!(first, report(&folder, &["solve", "punch.toml"]));
}

#[test]
fn doubts_are_told_in_the_report() {
    // A modulus in GPa without its unit.
    let folder = Folder::with(&UNILATERAL.replace("\"200 GPa\"", "200000"));
    folder.run(&["solve", "punch.toml", "--report", "report.html"]).answer();
    let html = std::fs::read_to_string(folder.path("report.html")).unwrap();
    assert!(
        html.contains("<ul class=\"warnings\"><li>") && html.contains("foundation.young_modulus"),
        "{html}"
    );
    assert!(!html.contains("Nothing was found"));
}

#[test]
fn every_command_that_has_a_result_has_a_report() {
    let folder = Folder::with(UNILATERAL);
    std::fs::write(folder.path("bare.toml"), DIMENSIONLESS).unwrap();
    let study = format!(
        "{UNILATERAL}\n[study]\nvary.\"load.force\" = {{ from = 1e5, to = 1e6, count = 3 }}\n"
    );
    std::fs::write(folder.path("study.toml"), study).unwrap();
    let equation = "[equation]\nkind = \"second\"\nlambda = 1.5\nrhs = \"exp(x)\"\n[kernel]\nname = \"log\"\na = 1.0\n";
    std::fs::write(folder.path("equation.toml"), equation).unwrap();
    for (arguments, pictures, words) in [
        (&["solve", "bare.toml"][..], 1, "dimensionless.theta0"),
        (&["stress", "punch.toml", "--yield-stress", "350 MPa"], 2, "first yield at 350 MPa"),
        (&["find", "force", "punch.toml", "--peak-pressure", "350 MPa"], 1, "--peak-pressure"),
        (&["find", "roughness", "punch.toml", "--settlement", "5 um"], 1, "--settlement"),
        (&["find", "crown", "punch.toml", "--peak-pressure", "150 MPa"], 1, "lowest peak"),
        (
            &["find", "profile", "punch.toml", "--pressure", "1", "--set", "load.moment=0"],
            1,
            "--pressure",
        ),
        (&["equation", "equation.toml"], 1, "equation.lambda"),
        (&["sweep", "study.toml", "--output", "parts"], 1, "study.vary.load.force.count"),
    ] {
        folder.run(&[arguments, &["--report", "report.html"]].concat()).answer();
        let html = std::fs::read_to_string(folder.path("report.html")).unwrap();
        assert_self_contained(&html);
        assert_eq!(html.matches("<figure>").count(), pictures, "{arguments:?}");
        assert!(html.contains(words), "{arguments:?}: {words}");
        assert!(html.contains("<math display=\"block\">"), "{arguments:?}");
        assert!(
            html.contains("<h2>Sense checks</h2>") && html.contains("SHA-256"),
            "{arguments:?}"
        );
        assert!(
            html.contains(&format!("<pre>shtaerman {}", arguments[..2].join(" "))),
            "{arguments:?}"
        );
        assert_eq!(html.contains("sense checks of "), arguments[0] == "sweep");
        std::fs::remove_file(folder.path("report.html")).unwrap();
    }
}

#[test]
fn an_error_above_what_was_aimed_at_is_no_doubt_of_an_engineer() {
    for example in ["two_punches.toml", "rough_ball.toml", "crowned_punch.toml"] {
        let folder = Folder::with(UNILATERAL);
        std::fs::copy(repository().join("examples").join(example), folder.path(example)).unwrap();
        let html = report(&folder, &["solve", example]);
        assert!(html.contains("Nothing was found that an engineer would doubt"), "{example}");
        let json = folder.run(&["solve", example, "--format", "json"]).json();
        for warning in json["warnings"].as_array().unwrap() {
            assert_eq!(warning["code"], "tolerance_not_met", "{example}");
            let said = warning["message"].as_str().unwrap();
            assert!(html.contains(&format!("<dt>accuracy</dt><dd>{said}</dd>")), "{said}");
        }
    }
}

#[test]
fn markup_in_a_file_stays_text() {
    let text = UNILATERAL
        .replace("\"x^2 / (2*20)\"", "\"where(x < 0, x^2, x^2)\"  # <script>alert(1)</script>");
    let folder = Folder::with(&text);
    let html = report(&folder, &["solve", "punch.toml"]);
    assert_self_contained(&html);
    assert!(html.contains("where(x &lt; 0, x^2, x^2)") && html.contains("&lt;script&gt;alert(1)"));
}

#[test]
fn a_report_that_cannot_be_is_told_before_anything_is_computed() {
    let folder = Folder::with(UNILATERAL);
    for (path, says) in [
        ("report.doc", "must end in .html or .pdf"),
        ("report", "must end in .html or .pdf"),
        ("missing/report.html", "cannot be written"),
        ("punch.toml", "must end in .html or .pdf"),
    ] {
        let run = folder.run(&["solve", "punch.toml", "--report", path]);
        let said = run.refusal();
        assert!(said.contains(says), "{path}: {said}");
    }
    let run = folder.run(&["solve", "punch.toml", "--plot", "a.svg", "--report", "./a.svg"]);
    let said = run.refusal();
    assert!(said.contains(".html"), "{said}");
    assert_eq!(folder.files(), ["punch.toml"]);
}

#[test]
fn without_a_browser_there_is_no_pdf_and_with_one_there_is() {
    let folder = Folder::with(UNILATERAL);
    let run = |variables: &[(&str, &str)]| {
        let mut command = Command::new(PROGRAM);
        command
            .args(["solve", "punch.toml", "--report", "report.pdf", "-q"])
            .current_dir(folder.path(""));
        command.envs(variables.iter().copied()).output().unwrap()
    };
    let told = run(&[("PATH", ""), ("SHTAERMAN_CHROMIUM", "")]);
    let said = String::from_utf8(told.stderr).unwrap();
    // On a system that keeps browsers in places of its own there may be one all the same.
    if told.status.code() == Some(2) {
        assert!(
            said.contains("printed by Chromium") && said.contains("--report FILE.html"),
            "{said}"
        );
    }
    let told = run(&[("SHTAERMAN_CHROMIUM", "no-such-program")]);
    let said = String::from_utf8(told.stderr).unwrap();
    assert_eq!(told.status.code(), Some(2), "{said}");
    assert!(said.contains("no-such-program, which is no program"), "{said}");
    // A program that prints nothing.
    if Path::new("/bin/true").exists() {
        let told = run(&[("SHTAERMAN_CHROMIUM", "/bin/true")]);
        assert_eq!(told.status.code(), Some(1));
        assert!(!folder.path("report.pdf").exists());
    }
    let told = run(&[]);
    if told.status.code() == Some(0) {
        let pdf = std::fs::read(folder.path("report.pdf")).unwrap();
        assert!(pdf.starts_with(b"%PDF-"));
        std::fs::remove_file(folder.path("report.pdf")).unwrap();
        run(&[]);
        assert!(std::fs::read(folder.path("report.pdf")).unwrap() == pdf, "the same bytes");
    } else {
        eprintln!("no Chromium here: what it prints is not tested");
    }
}

#[test]
fn the_model_of_a_report_is_that_of_what_was_found() {
    let folder = Folder::with(UNILATERAL);
    let find = ["find", "roughness", "punch.toml", "--settlement", "5 um", "--no-audit"];
    let html = report(&folder, &find);
    let found = folder.run(&[&find[..], &["--format", "json"]].concat()).answer();
    let found: serde_json::Value = serde_json::from_str(&found).unwrap();
    let roughness = found["value"].as_f64().unwrap();
    let problem = shtaerman::file::ProblemFile::open(&folder.path("punch.toml"), &[]).unwrap();
    let before = problem.problem().theta0();
    // theta0 is inversely proportional to the roughness.
    let after = before * 1.2e-14 / roughness;
    let says = |value: f64| {
        let numbers = html.split("= ").filter_map(|rest| {
            let end = rest.find(|c: char| c != '.' && !c.is_ascii_digit())?;
            rest[..end].trim_end_matches('.').parse::<f64>().ok()
        });
        numbers.into_iter().any(|number| (number / value - 1.0).abs() < 1e-6)
    };
    assert!(says(after) && !says(before), "{after} {before}");
}

#[test]
fn of_a_disk_the_share_that_touches_is_one_of_area() {
    let folder = Folder::new();
    folder.run(&["init", "--geometry", "circular"]).answer();
    let ring = "punch.profile=1e-6*(1-r/0.0005)";
    let html = report(&folder, &["solve", "punch.toml", "--no-audit", "--set", ring]);
    let said = html.split("It touches at radii from ").nth(1).unwrap();
    let (inner, rest) = said.split_once(" µm to 500 µm: ").unwrap();
    let share: f64 = rest.split_once(" % of the area").unwrap().0.parse().unwrap();
    let inner: f64 = inner.parse().unwrap();
    assert!((share - 100.0 * (1.0 - (inner / 500.0).powi(2))).abs() < 0.06, "{share} {inner}");
}

/// A smooth punch has two corners, and an error near none of them.
#[test]
fn both_edges_of_a_smooth_punch_are_named() {
    let folder = Folder::with(UNILATERAL);
    let smooth = ["--set", "foundation.roughness=0", "--set", "punch.profile=0"];
    let html = report(&folder, &[&["solve", "punch.toml"][..], &smooth].concat());
    assert!(html.contains("the pressure is infinite at both edges."), "{html}");
    assert!(html.contains("of the truth in the middle of the contact"), "{html}");
    let html = report(&folder, &["solve", "punch.toml"]);
    assert!(html.contains("of the truth everywhere"), "{html}");
}
