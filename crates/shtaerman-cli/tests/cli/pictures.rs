//! Pictures as they are asked for on the command line.

use crate::support::{Folder, UNILATERAL};

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
        (&["--plot", "p.svg", "--dpi", "300"], "--dpi is for .png"),
        (&["--plot", "p.png", "--dpi", "9999"], "9999 dots per inch"),
        (&["--plot", "p.svg", "--x-range", "2 mm..1 mm"], "must go from left to right"),
        (&["--plot", "p.jpg"], ".jpg is not supported: use .svg, .png or .pdf"),
    ] {
        let (code, stderr) = refused(options);
        assert_eq!(code, Some(2), "{options:?}: {stderr}");
        assert!(stderr.contains(said), "{options:?}: {stderr}");
    }
    if cfg!(not(feature = "pdf")) {
        let (code, stderr) = refused(&["--plot", "p.pdf"]);
        assert!(code == Some(2) && stderr.contains("--features pdf"), "{stderr}");
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
