//! Random unilateral problems from a seed.

use shtaerman::{Foundation, Load, Problem, Profile, Punch, Rotational, Vertical};

/// A xorshift generator (G. Marsaglia, J. Stat. Software 8 (2003) 14).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    /// Uniform in `[0, 1)`.
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    fn power(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.between(low, high))
    }
}

/// A problem: bases that are crowned, tilted, wavy, kinked or stepped; roughness over eight decades; every kind of load. Described in words, too.
pub(crate) fn problem(random: &mut Random) -> (String, Result<Problem, shtaerman::Error>) {
    let theta0 = random.power(-3.0, 5.0);
    let height = (1.0 + theta0) * random.power(-2.0, 2.0);
    let [a, b, c, d] = [0; 4].map(|_| random.between(-1.0, 1.0));
    let base = match (random.unit() * 6.0) as usize {
        0 => "0".to_owned(),
        1 => format!("xi^2 + {a}*xi + {b}*xi^3"),
        2 => format!("{a}*xi^2 + {b}*sin({}*xi + {c})", 9.0 * d),
        3 => format!("abs(xi - {a}) + {b}*xi^2"),
        4 => format!("exp({}*xi)", 3.0 * a),
        _ => format!("xi^4 + {a}*cos({}*xi + {b})", 20.0 * d),
    };
    let profile = format!("{height}*({base})");
    let vertical = if random.unit() < 0.75 {
        Vertical::Force(random.between(-0.05, 1.0))
    } else {
        Vertical::Settlement(height * random.between(-1.0, 2.0))
    };
    let force = match vertical {
        Vertical::Force(force) => force,
        Vertical::Settlement(_) => 1.0,
    };
    let rotational = match (random.unit() * 3.0) as usize {
        0 => Rotational::Moment(force * random.between(-1.05, 1.05)),
        1 => Rotational::Eccentricity(random.between(-1.05, 1.05)),
        _ => Rotational::Tilt(height * random.between(-1.0, 1.0)),
    };
    let words = format!("theta0 = {theta0:e}, f = {profile}, {vertical:?}, {rotational:?}");
    let build = || {
        let profile = Profile::expression(&profile).map_err(|_| shtaerman::Error::NoContact)?;
        let load = Load::new(vertical, rotational)?;
        Problem::new(
            Foundation::dimensionless(theta0)?,
            Punch::new(1.0)?.with_profile(profile),
            load,
        )
    };
    (words, build())
}

/// How an attempt ended.
#[derive(Debug, PartialEq)]
pub(crate) enum Ending {
    /// With residual tension and penetration.
    Solved { residual: f64, error: f64, zones: usize },
    /// For a reason that the load gives.
    Refused,
    /// For no good reason.
    Failed(String),
}

/// Solves a problem and judges the outcome: a refusal must be true of the load.
pub(crate) fn judge(problem: &Problem) -> Ending {
    let load = problem.dimensionless_load();
    let pulls = matches!(load.vertical(), Vertical::Force(force) if force <= 0.0);
    let tips = match (load.vertical(), load.rotational()) {
        (Vertical::Force(force), Rotational::Moment(moment)) => moment.abs() >= force,
        (_, Rotational::Eccentricity(e)) => e.abs() >= 1.0,
        _ => false,
    };
    match problem.solve() {
        Ok(contact) => {
            let Some(left) = contact.complementarity() else {
                return Ending::Failed("no statement of complementarity".to_owned());
            };
            Ending::Solved {
                residual: left.tension.max(left.penetration),
                error: contact.relative_error(),
                zones: contact.dimensionless().zones().len(),
            }
        }
        Err(shtaerman::Error::InvalidValue { field: "force", .. }) if pulls => Ending::Refused,
        Err(shtaerman::Error::TipsOver { .. }) if tips => Ending::Refused,
        Err(shtaerman::Error::NoContact) if clear(problem, &load) => Ending::Refused,
        Err(shtaerman::Error::SettlementOutOfReach { value, limit, .. })
            if out_of_reach(problem, value, limit) =>
        {
            Ending::Refused
        }
        Err(error) => Ending::Failed(error.to_string()),
    }
}

/// Whether no tilt at the settlement puts the force at the eccentricity: the tilt runs through all that touch. And whether settlements beyond the limit are solved.
fn out_of_reach(problem: &Problem, settlement: f64, limit: f64) -> bool {
    let Rotational::Eccentricity(e) = problem.dimensionless_load().rotational() else {
        return false;
    };
    let turned = Turned { problem, settlement, e };
    let size = (-20..=20)
        .map(|i| problem.dimensionless_profile(f64::from(i) / 20.0).abs())
        .fold(settlement.abs(), f64::max);
    let powers = (0..=24).map(|i| 1e-3 * size * 10f64.powf(f64::from(i) / 3.0));
    let mut tilts: Vec<f64> = powers.flat_map(|tilt| [-tilt, tilt]).collect();
    tilts.extend((-20..=20).map(|i| 0.15 * size * f64::from(i)));
    tilts.sort_by(f64::total_cmp);
    let Some(arms) = tilts.into_iter().map(|tilt| turned.arm(tilt)).collect::<Option<Vec<_>>>()
    else {
        return false;
    };
    let beyond = limit + 0.01 * (limit - settlement);
    let load = Load::new(Vertical::Settlement(beyond), Rotational::Eccentricity(e));
    load.and_then(|load| problem.with_load(load)?.solve()).is_ok()
        && arms.windows(2).all(|pair| turned.keeps_its_side(pair[0], pair[1], 12))
}

/// The contact at one settlement, as the base turns.
struct Turned<'p> {
    problem: &'p Problem,
    settlement: f64,
    e: f64,
}

/// How far the force lies from the eccentricity, and how fast that changes with the tilt; none where the base is clear.
#[derive(Clone, Copy)]
struct Arm {
    tilt: f64,
    distance: Option<[f64; 2]>,
}

impl Turned<'_> {
    /// `None` where there is no answer.
    fn arm(&self, tilt: f64) -> Option<Arm> {
        let load = Load::new(Vertical::Settlement(self.settlement), Rotational::Tilt(tilt)).ok()?;
        match self.problem.with_load(load).and_then(|problem| problem.solve()) {
            Ok(contact) => {
                let [[_, coupling], [_, moment_tilt]] =
                    contact.dimensionless().stiffness().matrix();
                let (force, moment) =
                    (contact.dimensionless().force(), contact.dimensionless().moment());
                let slope = (moment / force * coupling - moment_tilt) / force;
                Some(Arm { tilt, distance: Some([moment / force - self.e, slope]) })
            }
            Err(shtaerman::Error::NoContact) => Some(Arm { tilt, distance: None }),
            Err(_) => None,
        }
    }

    /// Whether the force stays on one side of the eccentricity between two tilts, as far as values and slopes at ever more of them show.
    fn keeps_its_side(&self, one: Arm, other: Arm, depth: usize) -> bool {
        let (Some([from, rises]), Some([to, falls])) = (one.distance, other.distance) else {
            // Where the base comes clear: the force ends at the last point that touches.
            return self.comes_clear(one, other, depth);
        };
        if (from > 0.0) != (to > 0.0) {
            return false;
        }
        // Straight on from both ends neither reaches the eccentricity before it meets the other.
        let width = other.tilt - one.tilt;
        let least = from.abs().min(to.abs());
        let sign = from.signum();
        let drop = (-sign * rises * width).max(sign * falls * width).max(0.0);
        if 0.5 * drop < least || depth == 0 {
            return depth > 0;
        }
        self.between(one, other).is_some_and(|middle| {
            self.keeps_its_side(one, middle, depth - 1)
                && self.keeps_its_side(middle, other, depth - 1)
        })
    }

    fn comes_clear(&self, one: Arm, other: Arm, depth: usize) -> bool {
        if depth == 0 || one.distance.is_none() && other.distance.is_none() {
            return true;
        }
        self.between(one, other).is_some_and(|middle| {
            self.keeps_its_side(one, middle, depth - 1)
                && self.keeps_its_side(middle, other, depth - 1)
        })
    }

    fn between(&self, one: Arm, other: Arm) -> Option<Arm> {
        self.arm(0.5 * (one.tilt + other.tilt))
    }
}

/// Whether some admissible tilt keeps the base clear: on a grid of its own.
fn clear(problem: &Problem, load: &Load) -> bool {
    let Vertical::Settlement(settlement) = load.vertical() else { return false };
    let depth = |tilt: f64| {
        (-1000..=1000)
            .map(|i| f64::from(i) / 1000.0)
            .map(|xi| settlement - tilt * xi - problem.dimensionless_profile(xi))
            .fold(f64::NEG_INFINITY, f64::max)
    };
    match load.rotational() {
        Rotational::Tilt(tilt) => depth(tilt) <= 0.0,
        Rotational::Moment(moment) if moment != 0.0 => false,
        // Convex in the tilt: golden section.
        _ => {
            let (mut low, mut high) = (-1e9, 1e9);
            for _ in 0..300 {
                let third = (high - low) / 3.0;
                if depth(low + third) < depth(high - third) {
                    high -= third;
                } else {
                    low += third;
                }
            }
            depth(0.5 * (low + high)) <= 1e-6 * (1.0 + settlement.abs())
        }
    }
}
