//! Random problems from a seed, as the files that state them.

use std::fmt::Write;

use shtaerman_random::Random;

/// A problem as its file, and what a second method should know of it.
pub(crate) struct Case {
    /// What kind of base, geometry, layer and contact.
    pub(crate) class: String,
    pub(crate) toml: String,
    /// The rows of a measured base.
    pub(crate) csv: Option<String>,
    /// Whether it is an equation.
    pub(crate) is_equation: bool,
    /// Where it bends, of equations.
    pub(crate) bends: Vec<(f64, bool)>,
}

/// Uniform between two numbers, with the digits that a file would have.
fn rounded(random: &mut Random, low: f64, high: f64) -> f64 {
    let value = random.between(low, high);
    format!("{value:.5}").parse().unwrap_or(value)
}

/// The problem with a number; each has a generator of its own, so that none depends on those before it.
pub(crate) fn case(seed: u64, index: u64) -> Case {
    let mut random = Random::new(seed ^ index.wrapping_mul(0xd134_2543_de82_ef95));
    if index % 8 == 7 { equation(&mut random) } else { contact(&mut random, index) }
}

/// A function in a variable, with the places where it bends and whether it does so sharply.
struct Drawn {
    kind: &'static str,
    text: String,
    bends: Vec<(f64, bool)>,
}

/// The shapes of bases of unit height; `v` is the variable, on `(low, 1)`.
fn shape(random: &mut Random, v: &str, low: f64) -> Drawn {
    let c = rounded(random, low + 0.03 * (1.0 - low), 0.97);
    let [a, b] = [0; 2].map(|_| rounded(random, -1.0, 1.0));
    match random.index(10) {
        0 | 1 => fourier(random, v),
        2 | 3 => {
            let width = random.power(-5.0, -0.3);
            let dent = random.power(-4.0, 0.0) * if random.chance(0.5) { 1.0 } else { -1.0 };
            let text = format!("{v}^2 + {dent:.4e}*exp(-(({v}-({c}))/{width:.4e})^2)");
            Drawn {
                kind: "narrow",
                text,
                bends: vec![(c - 6.0 * width, false), (c, false), (c + 6.0 * width, false)],
            }
        }
        4 => {
            let text = format!("abs({v}-({c})) + {a}*{v}^2");
            Drawn { kind: "kink", text, bends: vec![(c, true)] }
        }
        5 => {
            let text = format!("sqrt(({v}-({c}))^2) + {a}*{v}^2");
            Drawn { kind: "hidden kink", text, bends: vec![(c, true)] }
        }
        6 => {
            let text = format!("{:.5}*step({v}-({c})) + {v}^2", 0.3 * a);
            Drawn { kind: "step", text, bends: vec![(c, true)] }
        }
        7 => {
            let d = rounded(random, low + 0.03 * (1.0 - low), 0.97);
            let (from, to) = (c.min(d), c.max(d));
            let text = format!("where({v}<{from}, 0.4, where({v}<{to}, 0, {:.5}))", b.abs());
            Drawn { kind: "land", text, bends: vec![(from, true), (to, true)] }
        }
        8 => {
            let text = format!("max({v}^2, {}+{a}*{v})", b.abs());
            // The branches cross there.
            let root = (a * a + 4.0 * b.abs()).sqrt();
            let bends = vec![(0.5 * (a - root), true), (0.5 * (a + root), true)];
            Drawn { kind: "largest of two", text, bends }
        }
        _ => Drawn { kind: "flat", text: "0".to_owned(), bends: vec![] },
    }
}

fn fourier(random: &mut Random, v: &str) -> Drawn {
    let terms = 1 + random.index(30);
    let decay = random.between(0.0, 2.0);
    let mut text = format!("{}*{v}^2", rounded(random, 0.0, 1.0));
    for k in 1..=terms {
        let size = random.between(-1.0, 1.0) / (k as f64).powf(decay);
        let shift = rounded(random, 0.0, 6.0);
        let _ = write!(text, " + {size:.4e}*cos({k}*pi*{v}+{shift})");
    }
    Drawn { kind: "waves", text, bends: vec![] }
}

/// The same as an even function of the radius.
fn radial(random: &mut Random) -> Drawn {
    if random.chance(0.35) {
        let terms = 1 + random.index(12);
        let mut text = "rho^2".to_owned();
        for k in 1..=terms {
            let size = random.between(-1.0, 1.0) / k as f64;
            let _ = write!(text, " + {size:.4e}*cos({k}*pi*rho)");
        }
        return Drawn { kind: "waves", text, bends: vec![] };
    }
    loop {
        let drawn = shape(random, "rho", 0.0);
        if drawn.kind != "waves" {
            return drawn;
        }
    }
}

/// Rows of a measured base.
fn trace(random: &mut Random) -> String {
    let count = random.power(0.61, 3.0) as usize;
    let noise = random.power(-3.0, 0.0);
    let walk = random.chance(0.5);
    let crown = random.between(0.0, 1.0);
    let (mut rows, mut height) = (String::new(), 0.0);
    for i in 0..count {
        let x = -1.0 + 2.0 * i as f64 / (count - 1) as f64;
        let step = noise * random.between(-1.0, 1.0);
        height = if walk { height + step / (count as f64).sqrt() } else { step };
        let _ = writeln!(rows, "{x:.9}, {:.6}", crown * x * x + height);
    }
    rows
}

/// The setting of a contact.
struct Setting {
    name: &'static str,
    /// Keys of the file but for profile and load.
    keys: String,
    is_physical: bool,
    is_disk: bool,
    is_wave: bool,
    is_smooth: bool,
    can_tilt: bool,
    /// What heights of one displace the body by.
    height: f64,
}

fn setting(random: &mut Random) -> Setting {
    let theta: f64 = format!("{:.5e}", random.power(-1.3, 4.0)).parse().unwrap_or(1.0);
    let plain = Setting {
        name: "plane",
        keys: format!("[dimensionless]\ntheta0 = {theta:e}\n"),
        is_physical: false,
        is_disk: false,
        is_wave: false,
        is_smooth: false,
        can_tilt: true,
        height: 1.0 + theta,
    };
    let with =
        |name, line: String| Setting { name, keys: format!("{}{line}\n", plain.keys), ..plain };
    match random.index(16) {
        0..=4 => plain,
        5 => {
            let gap = rounded(random, 0.02, 0.95);
            with("pair", format!("geometry = \"pair\"\ninner_half_gap = {gap}"))
        }
        6 => {
            let period = rounded(random, 2.05, 6.0);
            with("row", format!("geometry = \"periodic\"\nperiod = {period}"))
        }
        7 => {
            let wave = with("wave", "geometry = \"periodic\"\nperiod = 2".to_owned());
            Setting { is_wave: true, can_tilt: false, ..wave }
        }
        8 | 9 => Setting { is_disk: true, ..with("disk", "geometry = \"circular\"".to_owned()) },
        10 | 11 => {
            let kappa = rounded(random, 0.3, 0.95);
            let is_disk = random.chance(0.3);
            let geometry = if is_disk { "circular" } else { "plane" };
            let theta = format!("{:.5e}", random.power(-1.3, 2.0)).parse().unwrap_or(1.0);
            Setting {
                is_disk,
                can_tilt: !is_disk,
                keys: format!(
                    "[dimensionless]\ntheta0 = {theta:e}\nexponent = {kappa}\ngeometry = \"{geometry}\"\n"
                ),
                height: 1.0 + theta,
                ..with("power law", String::new())
            }
        }
        12 | 13 => {
            let is_disk = random.chance(0.4);
            let mu = rounded(random, 0.05, 0.6);
            physical(
                if is_disk { "graded disk" } else { "graded plane" },
                is_disk,
                &format!("grading_exponent = {mu}\ngrading_modulus = 1"),
                1.0 / theta,
            )
        }
        14 => {
            let is_disk = random.chance(0.5);
            physical(
                if is_disk { "smooth disk" } else { "smooth plane" },
                is_disk,
                "young_modulus = 1",
                0.0,
            )
        }
        _ => {
            let period = rounded(random, 2.05, 6.0);
            let row = physical("smooth row", false, "young_modulus = 1", 0.0);
            let keys = row.keys.replace(
                "half_width = 1\n",
                &format!("half_width = 1\ngeometry = \"periodic\"\nperiod = {period}\n"),
            );
            Setting { keys, ..row }
        }
    }
}

/// Half-width and modulus are one.
fn physical(name: &'static str, is_disk: bool, ground: &str, roughness: f64) -> Setting {
    let punch = if is_disk { "geometry = \"circular\"\nradius = 1\n" } else { "half_width = 1\n" };
    Setting {
        name,
        keys: format!(
            "[foundation]\n{ground}\npoisson_ratio = 0.3\nroughness = {roughness:e}\n[punch]\n{punch}"
        ),
        is_physical: true,
        is_disk,
        is_wave: false,
        is_smooth: roughness == 0.0,
        can_tilt: true,
        height: 1.0 + roughness,
    }
}

/// A contact, as far as a file tells it; some have no answer.
fn contact(random: &mut Random, index: u64) -> Case {
    let setting = setting(random);
    let is_bilateral = !setting.is_smooth && random.chance(0.3);
    let height = setting.height * random.power(-2.0, 0.7);
    let is_measured =
        !setting.is_disk && !setting.is_smooth && !setting.is_wave && random.chance(0.15);
    let (kind, profile, csv) = if is_measured {
        let name = format!("trace_{index}.csv");
        let rows = trace(random);
        let scaled: String = rows.lines().filter_map(|row| row.split_once(", ")).fold(
            String::new(),
            |mut all, (x, h)| {
                let _ = writeln!(all, "{x}, {:.9e}", height * h.parse::<f64>().unwrap_or(0.0));
                all
            },
        );
        ("trace", format!("{{ csv = \"{name}\" }}"), Some(scaled))
    } else {
        let shift = rounded(random, -1.0, 1.0);
        let drawn = if setting.is_disk {
            radial(random)
        } else if setting.is_wave {
            // Periodic, as a wave should be.
            shape(random, &format!("cos(pi*(xi-({shift})))"), -1.0)
        } else {
            shape(random, "xi", -1.0)
        };
        let offset = if random.chance(0.1) {
            format!(" + {:.4e}", random.power(0.0, 6.0) * height)
        } else {
            String::new()
        };
        let kind = if offset.is_empty() { drawn.kind } else { "offset" };
        (kind, format!("\"{height:.5e}*({}){offset}\"", drawn.text), None)
    };
    let load = load(random, &setting, height, kind == "offset");
    let solver = if is_bilateral { "[solver]\ncontact = \"bilateral\"\n" } else { "" };
    let toml = if setting.is_physical {
        format!("{}profile = {profile}\n[load]\n{load}{solver}", setting.keys)
    } else {
        format!("{}profile = {profile}\n{load}{solver}", setting.keys)
    };
    let contact = if is_bilateral { ", bilateral" } else { "" };
    let class = format!("{}, {kind}{contact}", setting.name);
    Case { class, toml, csv, is_equation: false, bends: vec![] }
}

fn load(random: &mut Random, setting: &Setting, height: f64, is_high: bool) -> String {
    let force = random.power(-1.3, 0.5);
    let vertical = if is_high || setting.is_wave || random.chance(0.75) {
        format!("force = {force:.5e}")
    } else {
        format!(
            "settlement = {:.5e}",
            height * random.between(0.05, 2.0) + setting.height * force * random.between(0.0, 1.0)
        )
    };
    // A disk under a moment is solved in full contact only.
    let turn =
        if setting.is_disk && !random.chance(0.15) { 0.0 } else { random.between(-0.6, 0.6) };
    let rotational = match random.index(4) {
        _ if !setting.can_tilt => "moment = 0".to_owned(),
        0 => "moment = 0".to_owned(),
        1 if vertical.starts_with("force") => format!("moment = {:.5e}", force * turn),
        2 => format!("tilt = {:.5e}", height * turn),
        _ => format!("eccentricity = {turn:.5e}"),
    };
    format!("{vertical}\n{rotational}\n")
}

/// An equation of the second kind.
fn equation(random: &mut Random) -> Case {
    let lambda = random.power(-1.0, 2.0);
    let (name, keys, ends) = match random.index(10) {
        0 | 1 => ("log", "a = 1".to_owned(), [-1.0, 1.0]),
        2 => {
            let alpha = rounded(random, 0.2, 3.0);
            ("log-sine", format!("alpha = {alpha}"), [-alpha, alpha])
        }
        3 => ("power", format!("a = 1\nmu = {}", rounded(random, 0.05, 0.6)), [-1.0, 1.0]),
        4 | 5 => {
            let (mu, gamma) = (random.index(2), rounded(random, 0.0, 0.3));
            let gamma = if random.chance(0.5) { 0.0 } else { gamma };
            ("weber-sonine", format!("a = 1\nmu = {mu}\ngamma = {gamma}"), [0.0, 1.0])
        }
        6 => ("log-ratio", format!("a = 1\nb = {}", rounded(random, 0.05, 0.8)), [0.1, 1.0]),
        7 => ("log-square", format!("a = 1\nb = {}", rounded(random, 0.0, 0.8)), [0.1, 1.0]),
        8 => (
            "macdonald",
            format!(
                "a = 1\nmu = {}\nkappa = {}",
                rounded(random, -0.4, 0.4),
                rounded(random, 0.1, 5.0)
            ),
            [-1.0, 1.0],
        ),
        _ => (
            "yukawa",
            format!("a = 1\nchi0 = {}\nm = {}", rounded(random, 0.0, 3.0), random.index(3)),
            [0.0, 1.0],
        ),
    };
    // Shapes are drawn on (-1, 1) or (0, 1), and stretched over the interval.
    let (low, scale) = if ends[0] < 0.0 { (-1.0, ends[1]) } else { (0.0, 1.0) };
    let variable = if scale == 1.0 { "x".to_owned() } else { format!("(x/{scale})") };
    let variable = if ends[0] == 0.0 { "abs(x)".to_owned() } else { variable };
    let drawn = shape(random, &variable, low);
    let rhs = if drawn.text == "0" { "1".to_owned() } else { drawn.text };
    let toml = format!(
        "[equation]\nkind = \"second\"\nlambda = {lambda:.5e}\nrhs = \"{rhs}\"\n[kernel]\nname = \"{name}\"\n{keys}\n"
    );
    let bends = drawn.bends.into_iter().map(|(at, is_sharp)| (at * scale, is_sharp)).collect();
    Case {
        class: format!("equation {name}, {}", drawn.kind),
        toml,
        csv: None,
        is_equation: true,
        bends,
    }
}
