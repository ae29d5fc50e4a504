//! Problem and equation files as people write them.

use std::fmt::Write;

use shtaerman::equation::Family;

use crate::{Random, written};

/// What the lengths of a file are measured in.
#[derive(Debug, Clone, Copy)]
struct Size {
    /// Half-width or radius (m).
    length: f64,
    /// Young's modulus (Pa).
    modulus: f64,
}

/// A problem file; one in eight holds a value that may be out of range.
pub(crate) fn problem(random: &mut Random) -> String {
    let size = Size { length: random.power(-6.0, 0.0), modulus: random.power(5.0, 12.0) };
    let mut text = if random.one_in(5) {
        dimensionless(random)
    } else {
        let is_circular = random.one_in(5);
        foundation(random, size)
            + &punch(random, size, is_circular)
            + &load(random, size, is_circular)
    };
    let solver = solver(random, has_degenerate_kernel(&text));
    text += &solver;
    if random.one_in(8) {
        text = with_odd_number(random, &text);
    }
    text
}

/// The text with one of its numbers replaced.
fn with_odd_number(random: &mut Random, text: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let at = random.below(lines.len());
    if let Some((key, _)) = lines[at].split_once(" = ") {
        lines[at] = format!("{key} = {}", written::number(random));
    }
    lines.join("\n")
}

fn foundation(random: &mut Random, size: Size) -> String {
    let Size { length, modulus } = size;
    let mut text = format!("[foundation]\npoisson_ratio = {:.2}\n", random.between(-0.5, 0.5));
    let is_graded = random.one_in(5);
    if is_graded {
        let exponent = random.between(0.0, 0.95);
        let _ = writeln!(text, "grading_exponent = {exponent:.3}");
        let _ = writeln!(text, "grading_modulus = {:e}", modulus * length.powf(-exponent));
    } else {
        let _ = writeln!(text, "young_modulus = {modulus:e}");
    }
    let roughness = random.power(-5.0, 2.0) * length / modulus;
    text += &match random.below(6) {
        0 | 1 => "roughness = 0\n".to_owned(),
        2 => format!(
            "roughness = {{ displacement = {:e}, pressure = {:e}, exponent = {:.2} }}\n",
            roughness * 0.01 * modulus,
            0.01 * modulus,
            random.between(0.2, 1.0)
        ),
        3 => format!("subgrade_modulus = {:e}\n", 1.0 / roughness),
        _ => format!("roughness = {roughness:e}\n"),
    };
    if !is_graded && random.one_in(5) {
        let _ = writeln!(text, "thickness = {:e}", length * random.power(-0.7, 1.0));
        let _ = writeln!(text, "base = \"{}\"", random.of(&["bonded", "frictionless"]));
    } else if !is_graded && random.one_in(6) {
        let _ = writeln!(text, "[foundation.coating]\npoisson_ratio = 0.25");
        let _ = writeln!(text, "thickness = {:e}", length * random.power(-1.5, 0.5));
        let _ = writeln!(text, "young_modulus = {:e}", modulus * random.power(-1.0, 1.0));
    } else if random.one_in(5) {
        let _ = writeln!(text, "[body]\nyoung_modulus = {:e}\npoisson_ratio = 0.3", modulus * 2.0);
    }
    text
}

fn punch(random: &mut Random, size: Size, is_circular: bool) -> String {
    let Size { length, .. } = size;
    let mut text = "[punch]\n".to_owned();
    let mut is_wave = false;
    text += &match random.below(6) {
        _ if is_circular => format!("geometry = \"circular\"\nradius = {length:e}\n"),
        0 => format!(
            "geometry = \"pair\"\nouter_half_width = {length:e}\ninner_half_gap = {:e}\n",
            length * random.between(0.02, 0.9)
        ),
        1 => format!(
            "geometry = \"periodic\"\nhalf_width = {length:e}\nperiod = {:e}\n",
            length * random.between(2.0, 9.0)
        ),
        2 => {
            is_wave = true;
            format!("geometry = \"periodic\"\nperiod = {:e}\n", 2.0 * length)
        }
        _ => format!("half_width = {length:e}\n"),
    };
    let height = length * random.power(-6.0, -1.0);
    let variable = if is_circular { "rho" } else { "xi" };
    let profile = profile(random, variable, is_circular, is_wave);
    let _ = writeln!(text, "profile = \"{height:e}*({profile})\"");
    text
}

fn profile(random: &mut Random, u: &str, is_even: bool, is_wave: bool) -> String {
    let shift = if is_even || is_wave { 0.0 } else { random.between(-0.5, 0.5) };
    match random.below(8) {
        _ if is_wave => {
            let count = 1 + random.below(4);
            let term = |k: usize, random: &mut Random| {
                format!(
                    "{:.3}*cos({k}*pi*{u} + {:.3})",
                    random.between(-1.0, 1.0),
                    random.between(0.0, 6.0)
                )
            };
            (1..=count).map(|k| term(k, random)).collect::<Vec<_>>().join(" + ")
        }
        0 => "0".to_owned(),
        1 | 2 => format!("({u} - {shift:.3})^2"),
        3 => format!("abs({u} - {shift:.3})"),
        4 => format!("{u}^2 + 0.1*cos({}*pi*{u})", 1 + random.below(8)),
        5 => format!("max(0, abs({u}) - {:.3})^2", random.between(0.1, 0.9)),
        6 => format!("abs({u} - {shift:.3})^{:.2}", random.between(1.0, 4.0)),
        _ => written::formula(random, &[u], 6).replace('"', ""),
    }
}

fn load(random: &mut Random, size: Size, is_circular: bool) -> String {
    let Size { length, modulus } = size;
    let span = if is_circular { length * length } else { length };
    let force = modulus * span * random.power(-6.0, -0.5);
    let mut text = "[load]\n".to_owned();
    text += &if random.one_in(5) {
        format!("settlement = {:e}\n", length * random.power(-5.0, -1.5))
    } else {
        format!("force = {force:e}\n")
    };
    text += &match random.below(5) {
        0 | 1 => "moment = 0\n".to_owned(),
        2 => format!("moment = {:e}\n", force * length * random.between(-0.8, 0.8)),
        3 => format!("eccentricity = {:e}\n", length * random.between(-0.8, 0.8)),
        _ => format!("tilt = {:e}\n", random.between(-1.0, 1.0) * random.power(-5.0, -2.0)),
    };
    text
}

fn dimensionless(random: &mut Random) -> String {
    let mut text = format!("[dimensionless]\ntheta0 = {:e}\n", random.power(-3.0, 4.0));
    text += random.of(&[
        "",
        "",
        "geometry = \"circular\"\n",
        "geometry = \"pair\"\ninner_half_gap = 0.2\n",
    ]);
    let is_circular = text.contains("circular");
    let profile = profile(random, if is_circular { "rho" } else { "xi" }, is_circular, false);
    let _ = writeln!(text, "profile = \"{:e}*({profile})\"", random.power(-3.0, 2.0));
    let _ = writeln!(text, "force = {:e}", random.power(-3.0, 2.0));
    text + random.of(&["moment = 0\n", "tilt = 0\n", "eccentricity = 0.1\n"])
}

/// Whether the text is that of one plane punch on a linear layer and a half-plane, which is what the degenerate kernel solves.
fn has_degenerate_kernel(text: &str) -> bool {
    let others = ["geometry", "grading", "thickness", "exponent", "roughness = 0\n"];
    !others.iter().any(|other| text.contains(other))
}

/// The degenerate kernel is asked for where there is none as well, now and then: that is refused.
fn solver(random: &mut Random, has_degenerate_kernel: bool) -> String {
    const REFUSED: usize = 10;
    match random.below(5) {
        0 => "[solver]\ncontact = \"bilateral\"\n".to_owned(),
        1 => match 1 + random.below(200) {
            n if has_degenerate_kernel || n <= REFUSED => {
                format!("[solver]\ncontact = \"bilateral\"\nmethod = \"spectral\"\nn = {n}\n")
            }
            _ => "[solver]\ncontact = \"bilateral\"\n".to_owned(),
        },
        2 => format!("[solver]\ntolerance = {:e}\n", random.power(-14.0, -1.0)),
        _ => String::new(),
    }
}

/// An equation file of any kernel.
pub(crate) fn equation(random: &mut Random) -> String {
    let all = Family::all();
    let family = &all[random.below(all.len())];
    let is_second = !random.one_in(3);
    let mut text = "[equation]\n".to_owned();
    text += &if is_second {
        format!("kind = \"second\"\nlambda = {:e}\n", random.power(-3.0, 3.0))
    } else {
        "kind = \"first\"\n".to_owned()
    };
    let rhs = match random.below(5) {
        0 => "1".to_owned(),
        1 => format!("exp(-x)*cos({}*x)", random.below(6)),
        2 => "1 - 0.5*abs(x)".to_owned(),
        3 => "exp(-x^2)".to_owned(),
        _ => written::formula(random, &["x"], 6).replace('"', ""),
    };
    let _ = writeln!(text, "rhs = \"{rhs}\"\n[kernel]\nname = \"{}\"", family.name);
    if family.is_half_line {
        text += "interval = \"half-line\"\n";
    }
    let a = random.power(-1.0, 1.0);
    for parameter in family.parameters {
        let value = match parameter.name {
            "a" => a,
            "b" => a * random.between(0.0, 0.95),
            "alpha" => random.between(0.05, 3.1),
            "mu" if family.name == "power" => random.between(0.02, 0.95),
            "mu" if family.name == "weber-sonine" => random.below(4) as f64,
            "mu" | "gamma" => random.between(-0.48, 0.48),
            "m" => random.below(4) as f64,
            _ => random.power(-2.0, 1.5),
        };
        let _ = writeln!(text, "{} = {value}", parameter.name);
    }
    text
}
