//! Random contacts as their parts, so that what leaves the answer alone can be done to each of them.

use std::fmt::Write;

use shtaerman::{Contact, Error};
use shtaerman_random::Random;

/// What lies under the punch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Ground {
    Plain,
    /// The exponent.
    Graded(f64),
    /// Thickness over half-width, and whether it is bonded.
    Layer(f64, bool),
    /// Thickness over half-width, and modulus over that below.
    Coating(f64, f64),
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Geometry {
    Plane,
    /// Half the gap over the outer half-width.
    Pair(f64),
    /// Period over half-width.
    Row(f64),
    Wave,
    Circular,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Turn {
    Moment(f64),
    Tilt(f64),
}

/// A contact in the units of its half-width and modulus, which are one unless a [`Units`] says otherwise.
#[derive(Debug, Clone)]
pub(crate) struct Drawn {
    pub(crate) ground: Ground,
    pub(crate) geometry: Geometry,
    /// `chi E/a`, and the exponent of the law; 0 is smooth.
    pub(crate) roughness: f64,
    pub(crate) exponent: f64,
    /// Heights over the half-width, as a formula in `u`.
    pub(crate) profile: String,
    /// `P/(a E)`, under a disk `P/(a^2 E)`.
    pub(crate) force: f64,
    /// `M/(a^2 E)`, or the tilt.
    pub(crate) turn: Turn,
    pub(crate) is_bilateral: bool,
}

/// A length and a pressure by which everything is multiplied.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units {
    pub(crate) length: f64,
    pub(crate) pressure: f64,
}

impl Units {
    pub(crate) const ONE: Self = Self { length: 1.0, pressure: 1.0 };
}

/// The pressure at which the displacement of a power law is stated.
const LAW_PRESSURE: f64 = 0.01;

impl Drawn {
    /// Problem `index` of a seed; it depends on these two alone.
    pub(crate) fn new(seed: u64, index: u64) -> Self {
        let random = &mut Random::new(seed ^ index.wrapping_mul(0xd134_2543_de82_ef95));
        let geometry = match random.index(8) {
            0..=2 => Geometry::Plane,
            3 => Geometry::Pair(random.between(0.05, 0.8)),
            4 => Geometry::Row(random.between(2.1, 6.0)),
            5 => Geometry::Wave,
            _ => Geometry::Circular,
        };
        let ground = match (geometry, random.index(6)) {
            (Geometry::Plane | Geometry::Pair(_) | Geometry::Circular, 0) => {
                Ground::Graded(random.between(0.05, 0.5))
            }
            (Geometry::Plane | Geometry::Circular, 1) => {
                Ground::Layer(random.power(-0.5, 0.7), random.index(2) == 0)
            }
            (Geometry::Plane, 2) => {
                Ground::Coating(random.power(-0.7, 0.3), random.power(-0.5, 0.7))
            }
            _ => Ground::Plain,
        };
        let is_layered = matches!(ground, Ground::Layer(..) | Ground::Coating(..));
        let roughness = match random.index(3) {
            0 if !is_layered => 0.0,
            _ => random.power(-2.5, 0.5),
        };
        let is_bent = roughness > 0.0 && ground == Ground::Plain && random.index(6) == 0;
        let exponent = if is_bent { random.between(0.4, 0.9) } else { 1.0 };
        let height = random.power(-3.0, -1.5);
        let is_even = geometry == Geometry::Circular;
        let profile = profile(random, geometry, height);
        let turn = match geometry {
            _ if is_even => Turn::Moment(0.0),
            Geometry::Wave => Turn::Tilt(0.0),
            _ if random.index(2) == 0 => Turn::Tilt(height * random.between(-0.5, 0.5)),
            _ => Turn::Moment(random.between(-0.3, 0.3)),
        };
        let force = random.power(-2.5, -0.5);
        // A share of what tips over.
        let turn = if let Turn::Moment(share) = turn { Turn::Moment(share * force) } else { turn };
        Self { ground, geometry, roughness, exponent, profile, force, turn, is_bilateral: false }
    }

    /// The problem as a file.
    pub(crate) fn file(&self, units: Units) -> String {
        let Units { length, pressure } = units;
        let mut text = "[foundation]\npoisson_ratio = 0.3\n".to_owned();
        let modulus = |value: f64| format!("young_modulus = {:e}\n", value * pressure);
        text += &match self.ground {
            Ground::Graded(exponent) => format!(
                "grading_exponent = {exponent}\ngrading_modulus = {:e}\n",
                pressure * length.powf(-exponent)
            ),
            Ground::Layer(thickness, is_bonded) => format!(
                "{}thickness = {:e}\nbase = \"{}\"\n",
                modulus(1.0),
                thickness * length,
                if is_bonded { "bonded" } else { "frictionless" }
            ),
            Ground::Coating(..) | Ground::Plain => modulus(1.0),
        };
        text += &if self.exponent == 1.0 {
            format!("roughness = {:e}\n", self.roughness * length / pressure)
        } else {
            format!(
                "roughness = {{ displacement = {:e}, pressure = {:e}, exponent = {} }}\n",
                self.roughness * length * LAW_PRESSURE,
                LAW_PRESSURE * pressure,
                self.exponent
            )
        };
        if let Ground::Coating(thickness, ratio) = self.ground {
            let _ = writeln!(
                text,
                "[foundation.coating]\nthickness = {:e}\npoisson_ratio = 0.25\n{}",
                thickness * length,
                modulus(ratio)
            );
        }
        text += "[punch]\n";
        text += &match self.geometry {
            Geometry::Plane => format!("half_width = {length:e}\n"),
            Geometry::Pair(gap) => format!(
                "geometry = \"pair\"\nouter_half_width = {length:e}\ninner_half_gap = {:e}\n",
                gap * length
            ),
            Geometry::Row(period) => format!(
                "geometry = \"periodic\"\nhalf_width = {length:e}\nperiod = {:e}\n",
                period * length
            ),
            Geometry::Wave => format!("geometry = \"periodic\"\nperiod = {:e}\n", 2.0 * length),
            Geometry::Circular => format!("geometry = \"circular\"\nradius = {length:e}\n"),
        };
        let variable = if self.geometry == Geometry::Circular { "r" } else { "x" };
        let profile = self.profile.replace('u', &format!("({variable}/{length:e})"));
        let _ = writeln!(text, "profile = \"{length:e}*({profile})\"\n[load]");
        let span = if self.geometry == Geometry::Circular { length * length } else { length };
        let _ = writeln!(text, "force = {:e}", self.force * pressure * span);
        let _ = match self.turn {
            Turn::Moment(moment) => {
                writeln!(text, "moment = {:e}", moment * pressure * span * length)
            }
            Turn::Tilt(tilt) => writeln!(text, "tilt = {tilt:e}"),
        };
        if self.is_bilateral {
            text += "[solver]\ncontact = \"bilateral\"\n";
        }
        text
    }

    pub(crate) fn solve(&self) -> Result<Contact, Error> {
        self.solve_in(Units::ONE)
    }

    pub(crate) fn solve_in(&self, units: Units) -> Result<Contact, Error> {
        shtaerman::file::parse(&self.file(units), "drawn")?.solve()
    }

    pub(crate) fn is_even(&self) -> bool {
        self.geometry == Geometry::Circular
    }
}

fn profile(random: &mut Random, geometry: Geometry, height: f64) -> String {
    let shift = random.between(-0.4, 0.4);
    let waves = |random: &mut Random, phase: f64| {
        let mut text = String::new();
        for k in 1..=1 + random.index(6) {
            let size = height * random.between(-1.0, 1.0) / (k * k) as f64;
            let shift = phase * random.between(0.0, 6.0);
            let _ = write!(text, " + {size:.6}*cos({k}*pi*u + {shift:.4})");
        }
        text
    };
    match (geometry, random.index(4)) {
        (Geometry::Wave, _) => format!("0{}", waves(random, 1.0)),
        (Geometry::Circular, 0) => format!("{height:.6}*u^2{}", waves(random, 0.0)),
        (Geometry::Circular, 1) => format!("{height:.6}*u"),
        (Geometry::Circular, _) => format!("{height:.6}*u^{}", 2 + 2 * random.index(2)),
        (_, 0) => format!("{height:.6}*(u - {shift:.4})^2{}", waves(random, 1.0)),
        (_, 1) => format!("{height:.6}*abs(u - {shift:.4})"),
        (_, 2) => format!("{height:.6}*((u - {shift:.4})^2 + 0.3*u^3)"),
        _ => format!("{height:.6}*(u - {shift:.4})^2"),
    }
}
