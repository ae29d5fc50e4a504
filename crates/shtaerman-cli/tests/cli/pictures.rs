//! Pictures as they are asked for on the command line.

use crate::cli::support::{Folder, UNILATERAL, repository};

#[test]
fn every_command_that_draws_takes_the_same_options() {
    let folder = Folder::with(UNILATERAL);
    folder.run(&["init", "--equation"]).answer();
    for command in [
        &["solve", "punch.toml", "--no-audit"][..],
        &["solve", "punch.toml", "--no-audit", "--vary", "load.force=0.1,0.8 MN/m"],
        &["stress", "punch.toml", "--no-audit", "--grid", "9x9"],
        &["convergence", "punch.toml", "--max-n", "32", "--set", "solver.contact=bilateral"],
        &["equation", "equation.toml", "--no-audit"],
        &["spectrum", "log", "--a", "1"],
        &["reproduce"],
    ] {
        let look = [
            "--plot",
            "p.svg",
            "--title",
            "A title of mine",
            "--size",
            "160 mm x 100 mm",
            "--theme",
            "print",
        ];
        folder.run(&[command, &look].concat()).answer();
        let svg = folder.read("p.svg");
        assert!(svg.contains("width=\"605\" height=\"378\""), "{command:?}");
        assert!(svg.contains(">A title of mine<"), "{command:?}");
        let none = [command, &["--plot", "p.svg", "--title", ""]].concat();
        folder.run(&none).answer();
        assert!(!folder.read("p.svg").contains("<title>"), "{command:?}");
    }
}

#[test]
fn options_of_a_picture_need_one_and_make_sense() {
    let folder = Folder::with(UNILATERAL);
    let refused = |options: &[&str]| {
        let run = folder.run(&[&["solve", "punch.toml", "--no-audit"], options].concat());
        assert!(!folder.path("p.png").exists() && !folder.path("p.svg").exists());
        (run.code, run.stderr)
    };
    for (options, said) in [
        (&["--title", "T"][..], "--plot"),
        (&["--theme", "print"], "--plot"),
        (&["--plot", "p.svg", "--size", "wide"], "--size `wide`: must be width x height"),
        (&["--plot", "p.svg", "--size", "10x10"], "10 x 10 is out of range"),
        (&["--plot", "p.svg", "--size", "9 px x 9 px"], "9 x 9 is out of range"),
        (&["--plot", "p.svg", "--dpi", "300"], "--dpi is for .png"),
        (&["--plot", "p.png", "--dpi", "9999"], "9999 dots per inch"),
        (&["--plot", "p.svg", "--x-range", "2 mm..1 mm"], "must go from left to right"),
        (
            &["--plot", "p.svg", "--x-range", "6..9 mm"],
            "lies beside the punch, which reaches from -5 mm to 5 mm",
        ),
        (
            &["--plot", "p.svg", "--x-range", "-9..-6 mm", "--units", "length=mil"],
            "lies beside the punch, which reaches from -196.85 mil to 196.85 mil",
        ),
        (&["--plot", "p.jpg"], ".jpg is not supported: use .svg, .png or .pdf"),
    ] {
        let (code, stderr) = refused(options);
        assert_eq!(code, Some(2), "{options:?}: {stderr}");
        assert!(stderr.contains(said), "{options:?}: {stderr}");
    }
}

/// A program that was built without PDF has it printed by a browser, on a page of the size of the picture.
#[test]
#[cfg(not(feature = "pdf"))]
fn a_pdf_is_printed_by_a_browser() {
    let folder = Folder::with(UNILATERAL);
    let run = |variables: &[(&str, &str)]| {
        let mut command = std::process::Command::new(crate::cli::support::PROGRAM);
        command
            .args(["solve", "punch.toml", "-q", "--plot", "p.pdf", "--size", "600x400"])
            .current_dir(folder.path(""));
        command.envs(variables.iter().copied()).output().unwrap()
    };
    let told = run(&[("PATH", ""), ("SHTAERMAN_CHROMIUM", "")]);
    let said = String::from_utf8(told.stderr).unwrap();
    // On a system that keeps browsers in places of its own there may be one all the same.
    if told.status.code() != Some(0) {
        assert_eq!(told.status.code(), Some(2), "{said}");
        assert!(said.contains("printed by Chromium") && said.contains("--features pdf"), "{said}");
    }
    if run(&[]).status.code() == Some(0) {
        let pdf = std::fs::read(folder.path("p.pdf")).unwrap();
        assert!(pdf.starts_with(b"%PDF-"));
        // 600 x 400 of 96 to the inch are 450 x 300 points.
        let is_sized = pdf.windows(13).any(|part| part == b"[0 0 450 300]");
        assert!(is_sized, "the size of the page");
    } else {
        eprintln!("no Chromium here: what it prints is not tested");
    }
}

#[test]
fn a_bar_whose_colours_are_cut_ends_in_an_arrow() {
    let folder = Folder::with(UNILATERAL);
    // A nearly smooth flat punch has peaks at its corners that leave no colours for the rest.
    let sharp = [
        "--set",
        "punch.profile=0",
        "--set",
        "load.moment=0",
        "--set",
        "foundation.roughness=1e-16",
    ];
    let stress = |more: &[&str]| {
        let run = ["stress", "punch.toml", "--no-audit", "--plot", "p.svg"];
        folder.run(&[&run[..], more].concat()).answer();
        let svg = folder.read("p.svg");
        // The outermost band is a pentagon.
        svg.split("<path d=\"")
            .filter(|path| {
                let data = path.split('"').next().unwrap_or_default();
                data.ends_with('Z')
                    && data.matches('L').count() == 4
                    && path.contains("fill=\"#fde725\"")
            })
            .count()
    };
    assert_eq!(stress(&sharp), 1);
    assert_eq!(stress(&["--set", "punch.profile=x^2/(2*0.5)", "--set", "load.moment=0"]), 0);
}

#[test]
fn a_range_without_any_of_what_is_known_is_refused() {
    let folder = Folder::new();
    for (command, example, range, said) in [
        (
            "solve",
            "two_punches",
            "-0.1..0.1 m",
            "from -400 mm to -300 mm and from 300 mm to 400 mm",
        ),
        ("solve", "two_punches", "0.35..3 m", ""),
        ("solve", "wave", "0..51 mm", "shows more than 100 periods of 500 µm"),
        ("solve", "wave", "49.8..51 mm", ""),
        (
            "equation",
            "equation_log",
            "1..2",
            "lies beside the interval, which reaches from -1 to 1",
        ),
        ("equation", "equation_log", "0.5..2", ""),
    ] {
        let file = repository().join(format!("examples/{example}.toml"));
        let drawn = [command, file.to_str().unwrap(), "--no-audit", "--plot", "p.svg"];
        let run = folder.run(&[&drawn[..], &["--x-range", range]].concat());
        if said.is_empty() {
            run.answer();
        } else {
            assert!(run.refusal().contains(said), "{example} {range}: {}", run.stderr);
        }
    }
    // Punches of 1 mm every 4 mm: between them there are none, ten periods from the middle, too.
    let row = UNILATERAL
        .replace(
            "half_width = \"5 mm\"",
            "half_width = \"1 mm\"\ngeometry = \"periodic\"\nperiod = \"4 mm\"",
        )
        .replace("moment = \"100 N\"", "tilt = 0")
        .replace("0.8 MN/m", "0.1 MN/m");
    folder.write("row.toml", row);
    for (range, is_met) in [
        ("1.5..2.5 mm", false),
        ("41.1..42.9 mm", false),
        ("-42.9..-41.1 mm", false),
        ("-42.9..-40.9 mm", true),
        ("41.1..43.1 mm", true),
    ] {
        let run =
            folder.run(&["solve", "row.toml", "--no-audit", "--plot", "p.svg", "--x-range", range]);
        assert_eq!(run.code, Some(if is_met { 0 } else { 2 }), "{range}: {}", run.stderr);
        assert!(is_met || run.refusal().contains("and again every 4 mm"), "{}", run.stderr);
    }
}

/// The upright strokes of the crosses of a map: the one in the legend first or last.
fn crosses(svg: &str) -> Vec<f64> {
    let picture = roxmltree::Document::parse(svg).unwrap();
    let strokes = picture.descendants().filter(|node| {
        let is = |name: &str, value: &str| node.attribute(name) == Some(value);
        let is_upright = node.attribute("x1") == node.attribute("x2");
        node.has_tag_name("line") && is("stroke-width", "2") && is_upright
    });
    strokes.map(|node| node.attribute("x1").unwrap().parse().unwrap()).collect()
}

#[test]
fn both_infinite_corners_of_a_smooth_punch_are_marked() {
    let folder = Folder::new();
    let file = repository().join("examples/flat_punch.toml");
    let stress = |more: &[&str]| {
        let run = ["stress", file.to_str().unwrap(), "--no-audit", "--plot", "p.svg"];
        let said = folder.run(&[&run[..], more].concat()).answer();
        (said, folder.read("p.svg"))
    };
    let (said, svg) = stress(&["--set", "foundation.roughness=0"]);
    assert!(said.contains("at the edges x = -5 mm and 5 mm"), "{said}");
    assert!(svg.contains("at the edges x = −5 mm and 5 mm") && svg.contains(">infinite<"), "{svg}");
    let marked = crosses(&svg);
    assert_eq!(marked.len(), 3, "two, and one in the legend: {marked:?}");
    // Both are as far from the middle of the frame, which is that between the ends of the contact.
    let middle = marked[0].midpoint(marked[1]);
    assert!(svg.contains(&format!("x=\"{middle}\"")), "{middle} has the label of 0");
    // So are all components.
    let (_, normal) = stress(&["--set", "foundation.roughness=0", "--component", "sigma-y"]);
    assert!(normal.contains("infinite at the edges x = −5 mm and 5 mm"), "{normal}");
    assert_eq!(crosses(&normal).len(), 3);
    // A stress that is finite is marked where it is largest: below both edges, or below the one on which the punch leans.
    let (_, rough) = stress(&[]);
    assert_eq!(crosses(&rough).len(), 3, "{rough}");
    let (_, leaning) = stress(&["--set", "load.moment=\"10 N\""]);
    assert_eq!(crosses(&leaning).len(), 2, "{leaning}");
}

#[test]
fn titles_of_maps_and_traces_say_what_is_shown() {
    let folder = Folder::with(UNILATERAL);
    let drawn = ["stress", "punch.toml", "--no-audit", "--grid", "9x9", "--plot", "p.svg"];
    folder.run(&drawn).answer();
    let title = "<title>Punch: 800 kN/m, moment 100 N m/m, von Mises stress below the contact<";
    assert!(folder.read("p.svg").contains(title), "{}", folder.read("p.svg"));
    std::fs::create_dir(folder.path("deep")).unwrap();
    folder.write("deep/ground_ring.csv", "x,f\n-1e-3,0\n0,1e-6\n1e-3,0\n");
    folder.run(&["trace", "deep/ground_ring.csv", "--plot", "t.svg"]).answer();
    let svg = folder.read("t.svg");
    assert!(svg.contains("<title>Ground ring: as read and as used<") && !svg.contains("deep/"));
}

/// Waves of the base that are finer than the usual points of a curve: every crest of the pressure is drawn as high as it is.
#[test]
fn a_picture_shows_what_is_finer_than_its_usual_points() {
    let folder = Folder::with(UNILATERAL);
    let overrides = ["punch.profile=1e-6*cos(30*pi*xi)", "load.force=50 kN/m", "load.moment=0"];
    let overrides = overrides.map(str::to_owned);
    let file = shtaerman::file::ProblemFile::open(&folder.path("punch.toml"), &overrides).unwrap();
    let contact = file.problem().solve().unwrap();
    let zones = contact.zones();
    assert_eq!(zones.len(), 30);
    let drawn = shtaerman_cli::contact_plot(&contact).unwrap().pressure;
    // The axes are in mm and MPa.
    for [left, right] in zones {
        let inside = drawn.iter().filter(|(x, _)| (1e3 * left..=1e3 * right).contains(x));
        let shown = inside.map(|point| point.1).fold(0.0, f64::max);
        let steps = (0..=1000).map(|step| left + (right - left) * f64::from(step) / 1000.0);
        let true_peak = steps.map(|x| contact.pressure(x).unwrap()).fold(0.0, f64::max);
        assert!((1e6 * shown / true_peak - 1.0).abs() < 0.01, "{shown} of {true_peak}");
    }
}

/// Panels of a study are told apart by the names of their axes alone.
#[test]
fn names_of_axes_of_a_study_are_whole_or_the_size_is_refused() {
    let folder = Folder::with(UNILATERAL);
    let names = ["settlement", "peak_pressure", "mean_contact_pressure", "contact_width"];
    let outputs = names.join(",");
    let vary = ["solve", "punch.toml", "--no-audit", "--vary", "load.force=0.4..0.8 MN/m:3"];
    let drawn = [&vary[..], &["--outputs", &outputs, "--plot", "p.svg"]].concat();
    folder.run(&drawn).answer();
    let svg = folder.read("p.svg");
    // Broken between words, and not cut.
    assert!(!svg.contains('…'), "{svg}");
    for word in names.iter().flat_map(|name| name.split('_')) {
        let is_in = |text: &str| text.split(' ').any(|part| part == word);
        let mut texts = svg.split("</text>").filter_map(|text| text.rsplit('>').next());
        assert!(texts.any(is_in), "{word}");
    }
    folder.run(&[&drawn[..], &["--size", "160 mm x 100 mm"]].concat()).answer();
    let small = folder.run(&[&drawn[..], &["--size", "400x300"]].concat());
    assert!(small.stderr.contains("400 x 300"), "{}", small.stderr);
    assert_eq!(small.code, Some(2), "{}", small.stderr);
}

#[test]
fn the_line_below_the_title_says_what_the_ground_is() {
    let folder = Folder::new();
    let examples = repository().join("examples");
    for (name, more, said) in [
        ("rubber_layer", "", " thick, "),
        ("coated_shaft", "", "coating "),
        ("crowned_punch", "graded", "graded as y^0.5"),
    ] {
        let file = std::fs::read_to_string(examples.join(format!("{name}.toml"))).unwrap();
        let graded = "grading_modulus = \"2000 GPa\"\ngrading_exponent = 0.5";
        let file = match more {
            "graded" => file.replace("young_modulus = \"200 GPa\"", graded),
            _ => file,
        };
        folder.write("punch.toml", file);
        folder.run(&["solve", "punch.toml", "--no-audit", "--plot", "p.svg"]).answer();
        let svg = folder.read("p.svg");
        assert!(svg.contains(said), "{name}");
    }
}

/// A wave of period 500 um that touches by a small part of itself.
#[test]
fn the_inset_of_what_repeats_says_what_it_shows() {
    let folder = Folder::new();
    let wave = repository().join("examples/wave.toml");
    let plot = ["solve", wave.to_str().unwrap(), "--no-audit", "--plot", "p.svg"];
    folder.run(&[&plot[..], &["--x-range", "-20 um..20 um"]].concat()).answer();
    let svg = folder.read("p.svg");
    assert!(svg.contains(">two periods, to ±") && !svg.contains("the whole base"), "{svg}");
}
