//! Pictures of every command in every size: no text lies on another, none beyond the rim.

use std::fmt;

use crate::cli::support::{Folder, repository};

/// Advance widths of `DejaVu` Sans in 1/2048 of its size, from its `hmtx` table: printable ASCII, and what else is written.
const ASCII: [u16; 95] = [
    651, 821, 942, 1716, 1303, 1946, 1597, 563, 799, 799, 1024, 1716, 651, 739, 651, 690, 1303,
    1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 690, 690, 1716, 1716, 1716, 1087, 2048,
    1401, 1405, 1430, 1577, 1294, 1178, 1587, 1540, 604, 604, 1343, 1141, 1767, 1532, 1612, 1235,
    1612, 1423, 1300, 1251, 1499, 1401, 2025, 1403, 1251, 1403, 799, 690, 799, 1716, 1024, 1024,
    1255, 1300, 1126, 1300, 1260, 721, 1300, 1298, 569, 569, 1186, 569, 1995, 1298, 1253, 1300,
    1300, 842, 1067, 803, 1298, 1212, 1675, 1212, 1212, 1075, 1303, 690, 1303, 1716,
];
const OTHERS: [(&str, u16); 7] = [
    ("µλ", 1303),
    ("·", 651),
    ("×−±→", 1716),
    ("¹²³⁰⁴⁵⁶⁷⁸⁹₀", 821),
    ("⁻", 1081),
    ("…", 2048),
    ("ξαδχτθ", 1350),
];

fn advance(letter: char) -> f64 {
    let ascii = (letter as usize).checked_sub(32).and_then(|index| ASCII.get(index));
    let other =
        || OTHERS.iter().find(|(letters, _)| letters.contains(letter)).map(|(_, width)| width);
    f64::from(*ascii.or_else(other).unwrap_or(&2048))
}

/// A text and the rectangle that it takes: left, upper, right and lower side.
struct Text {
    words: String,
    size: f64,
    sides: [f64; 4],
}

impl fmt::Debug for Text {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{:?} at {:.0?}", self.words, self.sides)
    }
}

impl Text {
    fn of(node: roxmltree::Node<'_, '_>) -> Self {
        let number = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
        let (x, y, size) = (number("x"), number("y"), number("font-size"));
        let words = node.text().unwrap_or_default().to_owned();
        let width = words.chars().map(advance).sum::<f64>() * size / 2048.0;
        let before = match node.attribute("text-anchor") {
            Some("middle") => 0.5 * width,
            Some("end") => width,
            _ => 0.0,
        };
        // From capital letters and brackets to what hangs below the line.
        let (above, below) = (0.74 * size, 0.14 * size);
        let sides = if node.attribute("transform").is_some_and(|turn| turn.contains("rotate(-90")) {
            [x - above, y - width + before, x + below, y + before]
        } else {
            [x - before, y - above, x - before + width, y + below]
        };
        Self { words, size, sides }
    }

    fn is_on(&self, other: &Self) -> bool {
        const TOUCH: f64 = 0.3;
        let ([a, b, c, d], [e, f, g, h]) = (self.sides, other.sides);
        a + TOUCH < g && e + TOUCH < c && b + TOUCH < h && f + TOUCH < d
    }
}

/// What is wrong with a picture.
fn faults(svg: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(svg).unwrap();
    let root = document.root_element();
    let side = |name: &str| root.attribute(name).unwrap().parse::<f64>().unwrap();
    let (width, height) = (side("width"), side("height"));
    let nodes = document.descendants().filter(|node| node.has_tag_name("text"));
    let texts: Vec<Text> = nodes.map(Text::of).collect();
    let mut faults = Vec::new();
    for (index, text) in texts.iter().enumerate() {
        let [left, top, right, bottom] = text.sides;
        if left < 0.0 || top < 0.0 || right > width || bottom > height {
            faults.push(format!("{text:?} is outside of {width} x {height}"));
        }
        if text.size < 9.0 {
            faults.push(format!("{text:?} is too small to be read"));
        }
        let others = &texts[index + 1..];
        faults.extend(
            others.iter().filter(|o| text.is_on(o)).map(|o| format!("{text:?} is on {o:?}")),
        );
    }
    faults
}

const COMMANDS: [&[&str]; 22] = [
    &["solve", "crowned_punch.toml", "--no-audit"],
    &["solve", "eccentric_load.toml", "--no-audit", "--units", "inch"],
    &["solve", "flat_punch.toml", "--no-audit", "--set", "foundation.roughness=0"],
    &["solve", "wave.toml", "--no-audit"],
    &["solve", "two_punches.toml", "--no-audit"],
    &["solve", "rough_ball.toml", "--no-audit"],
    &["solve", "coated_shaft.toml", "--no-audit"],
    &["solve", "measured_profile.toml", "--no-audit"],
    &["solve", "paper_row.toml", "--no-audit"],
    &["solve", "crowned_punch.toml", "--no-audit", "--vary", "load.force=0.1..0.8 MN/m:4"],
    &[
        "solve",
        "crowned_punch.toml",
        "--no-audit",
        "--vary",
        "load.force=0.1..0.8 MN/m:3",
        "--vary",
        "foundation.roughness=1e-15..1e-13 m/Pa:3:log",
    ],
    &["stress", "crowned_punch.toml", "--no-audit", "--grid", "15x11"],
    &["stress", "wave.toml", "--no-audit", "--grid", "15x11", "--component", "sigma-x"],
    &[
        "stress",
        "flat_punch.toml",
        "--no-audit",
        "--grid",
        "15x11",
        "--set",
        "foundation.roughness=0",
    ],
    &["convergence", "paper_row.toml", "--max-n", "32"],
    &["equation", "equation_log.toml", "--no-audit"],
    &["equation", "equation_two_punches.toml", "--no-audit"],
    &["spectrum", "log", "--a", "1"],
    &["reproduce"],
    &["trace", "measured_profile.csv", "--centre", "--level", "mean-line", "--cutoff", "0.8 mm"],
    &["sweep", "studies/force_and_roughness.toml", "--output", "finishes", "--yes"],
    &["sweep", "studies/tolerances.toml", "--output", "tolerances", "--yes"],
];

/// The size that a refusal asks for.
fn least(refusal: &str) -> &str {
    let at_least = refusal.split_once("at least ");
    assert!(at_least.is_some(), "{refusal}");
    at_least.unwrap().1.split_once(" (").unwrap().0
}

#[test]
fn no_text_lies_on_another_in_any_size() {
    let folder = Folder::new();
    let examples = repository().join("examples");
    let mut told = Vec::new();
    for command in COMMANDS {
        let arguments: Vec<String> = command
            .iter()
            .map(|word| match examples.join(word) {
                path if path.is_file() => path.display().to_string(),
                _ => (*word).to_owned(),
            })
            .collect();
        let draw = |look: &[&str]| {
            let mut all: Vec<&str> = arguments.iter().map(String::as_str).collect();
            all.extend(["--plot", "p.svg"]);
            all.extend(look);
            folder.run(&all)
        };
        let mut check = |look: &[&str]| {
            for fault in faults(&folder.read("p.svg")) {
                told.push(format!("{command:?} {look:?}: {fault}"));
            }
        };
        // Both themes write with the same letters.
        for (theme, sizes) in [
            (
                "screen",
                &[
                    "80 mm x 50 mm",
                    "60 mm x 120 mm",
                    "90 mm x 60 mm",
                    "120 mm x 90 mm",
                    "500 mm x 400 mm",
                ][..],
            ),
            ("print", &["90 mm x 60 mm"]),
        ] {
            for &size in sizes {
                let look = ["--size", size, "--theme", theme];
                let run = draw(&look);
                if run.code == Some(0) {
                    check(&look);
                    continue;
                }
                let refusal = run.refusal();
                let least = least(refusal).replace(' ', "");
                let sides = least.split_once('x').unwrap();
                let [width, height] = [sides.0, sides.1].map(|side| side.parse::<f64>().unwrap());
                // A column of a journal has room for it, unless there is a panel for each of many outputs.
                let has_many = command[0] == "sweep" || command.contains(&"--vary");
                let is_small = width <= 380.0 && height <= 240.0;
                assert!(has_many || size != "80 mm x 50 mm" || is_small, "{command:?}: {refusal}");
                let look = ["--size", &least, "--theme", theme];
                draw(&look).answer();
                check(&look);
            }
        }
        draw(&[]).answer();
        check(&[]);
    }
    assert!(told.is_empty(), "{} faults:\n{}", told.len(), told.join("\n"));
}
