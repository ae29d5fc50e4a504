//! Random problems from a seed.

use crate::smooth::support::{Smooth, holds, punch};
use shtaerman::{Error, Load, Rotational, Vertical};

/// A xorshift generator (G. Marsaglia, J. Stat. Software 8 (2003) 14).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

fn problem(random: &mut Random) -> (String, Smooth) {
    let theta0 = 10f64.powf(random.between(-3.0, 5.0));
    let height = theta0 * 10f64.powf(random.between(-2.0, 2.0));
    let [a, b, c, d] = [0; 4].map(|_| random.between(-1.0, 1.0));
    let kind = (random.unit() * 7.0) as usize;
    let vertical = if random.unit() < 0.75 {
        Vertical::Force(random.between(-0.05, 1.0))
    } else {
        Vertical::Settlement(height * random.between(-1.0, 2.0))
    };
    let force = match vertical {
        Vertical::Force(force) => force,
        Vertical::Settlement(_) => 1.0,
    };
    let rotational = match (random.unit() * 2.99) as usize {
        0 => Rotational::Moment(force * random.between(-1.05, 1.05)),
        1 if matches!(vertical, Vertical::Force(_)) => {
            Rotational::Eccentricity(random.between(-1.05, 1.05))
        }
        _ => Rotational::Tilt(height * random.between(-1.0, 1.0)),
    };
    let base = move |x: f64| {
        height
            * match kind {
                0 => 0.0,
                1 => x * x + a * x + b * x.powi(3),
                2 => a * x * x + b * (9.0 * d * x + c).sin(),
                3 => (x - a).abs() + b * x * x,
                4 => (3.0 * a * x).exp(),
                5 => x.powi(4) + a * (20.0 * d * x + b).cos(),
                _ => {
                    if x > a {
                        b
                    } else {
                        c * x * x
                    }
                }
            }
    };
    let load = Load::new(vertical, rotational).unwrap();
    let mut problem = punch(theta0, base, load);
    if kind == 3 || kind == 6 {
        problem = problem.breaks(&[a]);
    }
    problem = match (random.unit() * 4.0) as usize {
        0 => problem.gap(random.between(0.05, 0.7)),
        1 => problem.period(random.between(2.1, 6.0)),
        _ => problem,
    };
    let words = format!(
        "theta0 {theta0:e} height {height:e} kind {kind} {a} {b} {c} {d} {vertical:?} {rotational:?} {:?} {:?}",
        problem.geometry, problem.breaks
    );
    (words, problem)
}

/// Whether the refusal is true of the load.
fn is_true(error: &Error, load: &Load) -> bool {
    match error {
        Error::InvalidValue { field, .. } => {
            *field == "force" && matches!(load.vertical(), Vertical::Force(force) if force <= 0.0)
        }
        Error::TipsOver { .. } => match (load.vertical(), load.rotational()) {
            (Vertical::Force(force), Rotational::Moment(moment)) => moment.abs() >= force,
            (_, Rotational::Eccentricity(e)) => e.abs() >= 1.0,
            _ => false,
        },
        Error::NoContact => matches!(load.vertical(), Vertical::Settlement(_)),
        _ => false,
    }
}

#[test]
fn random_problems() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut failed = Vec::new();
    let mut solved = 0;
    let count = std::env::var("SMOOTH_SURVEY").ok().and_then(|n| n.parse().ok()).unwrap_or(200);
    for i in 0..count {
        let (words, problem) = problem(&mut random);
        match problem.solve() {
            Ok(contact) => {
                solved += 1;
                let left = contact.complementarity();
                // Slopes from heights: short zones of a steep base lose digits, and say so.
                if left.tension.max(left.penetration) > 1e-9
                    || contact.contact.relative_error() > 1e-4
                {
                    failed.push(format!(
                        "{i}: {left:?} {:e} {words}",
                        contact.contact.relative_error()
                    ));
                }
                if i % 10 == 0 {
                    holds(&contact, 1e-8, &words);
                }
            }
            Err(error) if is_true(&error, &problem.load) => {}
            Err(error) => failed.push(format!("{i}: {error} {words}")),
        }
    }
    assert!(failed.is_empty() && solved > count / 2, "{solved} solved\n{}", failed.join("\n"));
}
