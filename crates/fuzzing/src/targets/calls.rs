//! Calls of the library with what callers pass it: sound values, and NaN, infinite, tiny and huge ones among them.

use std::fmt::{Display, Write};
use std::time::Duration;

use shtaerman::contact::Unaudited;
use shtaerman::{
    Contact, Criterion, Datum, Elastic, Error, Foundation, Geometry, Grading, Influence, LayerBase,
    Layering, Load, MethodChoice, Problem, Profile, Punch, Roughness, Solver, StressField,
};

use crate::check::{self, Outcome};
use crate::{Random, written};

/// Numbers at which something ends.
const ODD: &[f64] = &[
    0.0,
    -0.0,
    -1.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    f64::EPSILON,
    1e300,
    1e-300,
    1e150,
    1e-150,
    1e18,
];

/// Time that a solve may take: it is then refused, or its best is shown.
const LIMIT: Duration = Duration::from_secs(1);

/// Random values with a record of what they were for.
struct Caller<'r> {
    random: &'r mut Random,
    said: String,
    /// One value in so many is odd.
    odd: usize,
}

impl Caller<'_> {
    fn note(&mut self, name: &str, value: impl Display) {
        // Writing to a string cannot fail.
        let _ = write!(self.said, "{name} = {value}; ");
    }

    fn odd(&mut self) -> f64 {
        match self.random.below(4) {
            0 => f64::from_bits(self.random.bits()),
            _ => ODD[self.random.below(ODD.len())],
        }
    }

    /// A power of ten with an exponent between two, or an odd number.
    fn size(&mut self, name: &str, low: f64, high: f64) -> f64 {
        let sound = self.random.power(low, high);
        self.chosen(name, sound)
    }

    fn between(&mut self, name: &str, low: f64, high: f64) -> f64 {
        let sound = self.random.between(low, high);
        self.chosen(name, sound)
    }

    /// One of so many ways.
    fn way(&mut self, name: &str, count: usize) -> usize {
        let way = self.random.below(count);
        self.note(name, way);
        way
    }

    fn chosen(&mut self, name: &str, sound: f64) -> f64 {
        let value = if self.random.one_in(self.odd) { self.odd() } else { sound };
        self.note(name, format!("{value:e}"));
        value
    }

    fn elastic(&mut self) -> Result<Elastic, Error> {
        Elastic::new(self.size("modulus", 5.0, 12.0), self.between("nu", -0.9, 0.5))
    }

    fn foundation(&mut self, length: f64) -> Result<Foundation, Error> {
        let foundation = match self.way("foundation", 6) {
            0 => {
                let foundation = Foundation::dimensionless(self.size("theta0", -3.0, 4.0))?;
                if self.random.one_in(3) {
                    let exponent = self.between("exponent", 0.1, 1.0);
                    return foundation.with_exponent(exponent);
                }
                return Ok(foundation);
            }
            1 => {
                let exponent = self.between("grading", 0.0, 0.95);
                let grading = Grading::new(exponent, self.size("graded modulus", 5.0, 12.0))?;
                Foundation::graded(grading, self.between("nu", -0.9, 0.5))?
            }
            _ => Foundation::new(self.elastic()?),
        };
        let roughness: Roughness = match self.way("roughness", 4) {
            0 => 0.0.into(),
            1 => {
                let coefficient = self.size("coefficient", -12.0, -4.0);
                Roughness::power(coefficient, self.between("power", 0.1, 1.0))?
            }
            _ => self.size("roughness", -18.0, -8.0).into(),
        };
        let foundation = foundation.with_roughness(roughness)?;
        Ok(match self.way("layering", 8) {
            0 => foundation.with_layering(self.layering(length)?),
            1 => foundation.with_influence(self.influence(length)?),
            _ => foundation,
        })
    }

    fn layering(&mut self, length: f64) -> Result<Layering, Error> {
        let thickness = length * self.size("thickness over half-width", -1.0, 1.0);
        if self.random.one_in(2) {
            return Layering::coating(thickness, self.elastic()?, self.elastic()?);
        }
        let poisson_ratio = self.between("nu of layer", 0.0, 0.45);
        let is_bonded = self.random.one_in(2);
        let base =
            if is_bonded { LayerBase::Bonded { poisson_ratio } } else { LayerBase::Frictionless };
        Layering::layer(thickness, base)
    }

    fn influence(&mut self, length: f64) -> Result<Influence, Error> {
        if self.random.one_in(2) {
            let height = self.between("remainder", -1.0, 1.0);
            return Ok(Influence::by_remainder(move |distance| height * (-distance).exp()));
        }
        let scale = self.size("scale", -1.0, 1.0);
        Influence::by_transfer(length * scale, self.between("far", 0.5, 2.0), f64::tanh)
    }

    fn punch(&mut self) -> Result<Punch, Error> {
        let length = self.size("half-width", -4.0, 0.0);
        let punch = match self.way("punch", 7) {
            0 => Punch::circular(length)?,
            1 => Punch::pair(length, length * self.between("gap", 0.02, 0.95))?,
            2 => Punch::periodic(length, length * self.between("period", 2.0, 9.0))?,
            3 => {
                let gap = self.between("gap", 0.0, 1.0) * length;
                Punch::in_geometry(Geometry::Pair { inner_half_gap: gap }, length)?
            }
            _ => Punch::new(length)?,
        };
        let punch = if self.random.one_in(5) { punch.with_body(self.elastic()?) } else { punch };
        let height = length * self.size("height", -6.0, -1.0);
        Ok(punch.with_profile(self.profile(height, length)?))
    }

    fn profile(&mut self, height: f64, length: f64) -> Result<Profile, Error> {
        let place = self.between("place", -0.5, 0.5);
        let odd = self.odd();
        match self.way("profile", 8) {
            0 => Ok(Profile::flat()),
            1 => Ok(Profile::from_fn(move |x| height * (x / length - place).powi(2))),
            2 => {
                self.note("profile", format!("odd {odd:e} beyond the place"));
                Ok(Profile::from_fn(move |x| if x / length > place { odd } else { 0.0 }))
            }
            3 => Profile::from_fn(move |x| height * (x / length - place).abs())
                .with_breaks(vec![self.between("break", -1.0, 1.0)]),
            4 => {
                let count = self.random.below(12);
                let step = |k: usize| -1.2 + 2.4 * k as f64 / 11.0;
                let positions = (0..count).map(|k| self.chosen("x", length * step(k))).collect();
                let heights = (0..count).map(|_| height * self.between("f", -1.0, 1.0)).collect();
                Profile::from_points(positions, heights)
            }
            5 => {
                let text = written::formula(self.random, &["x", "xi"], 5);
                self.note("profile", &text);
                Ok(Profile::expression(&text).unwrap_or_else(|_| Profile::flat()))
            }
            6 => {
                let text = format!("{height:e}*rho^2");
                Ok(Profile::radial(&text).unwrap_or_else(|_| Profile::flat()))
            }
            _ => Ok(Profile::from_fn(move |x| height * (5.0 * x / length).cos())),
        }
    }

    fn load(&mut self, length: f64) -> Result<Load, Error> {
        let load = if self.random.one_in(4) {
            Load::settlement(length * self.size("settlement", -5.0, -2.0))?
        } else {
            Load::force(self.size("force", 0.0, 8.0))?
        };
        let factor = self.between("rotation", -0.8, 0.8);
        match self.way("load", 5) {
            0 => load.with_moment(factor * length * 1e4),
            1 => load.with_eccentricity(factor * length),
            2 => load.with_tilt(factor * 1e-3),
            _ => Ok(load),
        }
    }

    fn solver(&mut self) -> Result<Solver, Error> {
        let solver = match self.way("solver", 4) {
            0 => Solver::bilateral(),
            1 => Solver::spectral(self.random.below(60))?,
            2 => Solver::unilateral().with_tolerance(self.size("tolerance", -13.0, -1.0))?,
            _ => Solver::unilateral(),
        };
        let solver =
            if self.random.one_in(8) { solver.with_method(MethodChoice::Sinc)? } else { solver };
        solver.with_time_limit(LIMIT)
    }

    /// The problem, and the same changed once.
    fn problem(&mut self) -> Result<Problem, Error> {
        let punch = self.punch()?;
        let length = punch.half_width();
        let foundation = self.foundation(length)?;
        let load = self.load(length)?;
        let problem = Problem::new(foundation, punch, load)?.with_solver(self.solver()?);
        match self.way("change", 14) {
            0 => problem.with_force(self.size("new force", 0.0, 8.0)),
            1 => problem.with_settlement(length * self.size("new settlement", -5.0, -2.0)),
            2 => problem.with_moment(self.between("new moment", -1.0, 1.0)),
            3 => problem.with_tilt(self.between("new tilt", -1e-3, 1e-3)),
            4 => problem.with_eccentricity(length * self.between("new eccentricity", -1.0, 1.0)),
            5 => problem.with_roughness(self.size("new roughness", -18.0, -8.0)),
            6 => problem.with_theta0(self.size("new theta0", -3.0, 4.0)),
            7 => problem.with_young_modulus(self.size("new modulus", 5.0, 12.0)),
            8 => problem.with_tolerance(self.size("new tolerance", -13.0, -1.0)),
            _ => Ok(problem),
        }
    }

    /// Asks the contact for everything, at places on the base, beside it, and nowhere.
    fn ask(&mut self, contact: &Contact) -> Result<(), String> {
        let half_width = contact.problem().punch().half_width();
        let all = [
            contact.settlement(),
            contact.tilt(),
            contact.force(),
            contact.moment(),
            contact.contact_width(),
            contact.mean_pressure(),
        ];
        self.holds(all.iter().all(|value| value.is_finite()), &format!("not finite: {all:?}"))?;
        let [peak, at] = [contact.peak_pressure(), contact.peak_pressure_at()];
        self.holds(!peak.is_nan() && !at.is_nan(), "the peak is not a number")?;
        for _ in 0..4 {
            let xi = self.between("at", -1.5, 1.5);
            let x = if self.random.one_in(6) { self.odd() } else { xi * half_width };
            self.note("x", format!("{x:e}"));
            let found = [contact.pressure(x), contact.gap(x)];
            for value in found.iter().flatten() {
                self.holds(!value.is_nan(), "a value is not a number")?;
            }
            self.holds(x.is_finite() || found[0].is_err(), "a pressure nowhere")?;
            for error in found.into_iter().filter_map(Result::err) {
                check::refusal(&error.to_string(), &self.said)?;
            }
            let _ = (contact.elastic_displacement(x), contact.base_depth(x));
        }
        let _ = (contact.stiffness(), contact.tension(), contact.warnings().len());
        let _ = (contact.implied_edge_pressures(), contact.corner_intensity());
        // Those by differences are eighteen more solves, each within the time that one has.
        let _ = contact.tangent_sensitivities();
        let far = self.size("datum", -3.0, 3.0);
        let datum = if self.random.one_in(2) { Datum::Depth(far) } else { Datum::Distance(far) };
        if let Ok(relative) = contact.relative_settlement(datum) {
            self.holds(!relative.settlement.is_nan(), "the settlement of a datum is not a number")?;
        }
        self.stresses(contact, half_width)
    }

    fn stresses(&mut self, contact: &Contact, half_width: f64) -> Result<(), String> {
        let poisson_ratio = self.between("nu", -0.5, 0.5);
        let Ok(field) = StressField::new(contact, Some(poisson_ratio)) else { return Ok(()) };
        let x = half_width * self.between("x", -2.0, 2.0);
        let depth = half_width * self.size("depth", -3.0, 1.0);
        if let Ok(stress) = field.stress(x, depth) {
            self.holds(!Criterion::VonMises.of(&stress).is_nan(), "a stress is not a number")?;
        }
        Ok(())
    }

    fn holds(&self, condition: bool, what: &str) -> Result<(), String> {
        check::holds(condition, what, &self.said)
    }
}

/// Makes a problem by calls, solves it, and asks the contact for everything; one call in ten or in a thousand has an odd number.
pub(super) fn case(random: &mut Random) -> Result<Outcome, String> {
    let odd = [10, 40, 1000][random.below(3)];
    let mut caller = Caller { random, said: String::new(), odd };
    let problem = match caller.problem() {
        Ok(problem) => problem,
        Err(error) => return check::refusal(&error.to_string(), &caller.said),
    };
    let contact = match problem.solve() {
        Ok(contact) => contact,
        Err(error) => return check::refusal(&error.to_string(), &caller.said),
    };
    caller.ask(&contact)?;
    caller.ask(&contact.dimensionless())?;
    let reason: Option<Unaudited> = contact.audit().err();
    if let Some(reason) = reason {
        check::refusal(&reason.to_string(), &caller.said)?;
    }
    Ok(Outcome::Accepted)
}
