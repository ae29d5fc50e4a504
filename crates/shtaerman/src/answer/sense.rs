//! Whether an answer is one of mechanics as the model has it, or of a slip in the input.

use crate::contact::{Warning, WarningCode};
use crate::quantity::{Measure, OutputUnits};
use crate::{
    Contact, Foundation, Geometry, LayerBase, Layering, Load, Problem, Rotational, Vertical,
};

/// Slopes and angles above this are not small: `tan x` and `x` differ by 0.3 %.
const SMALL_SLOPE: f64 = 0.1;
/// Share of the contact modulus that no solid bears elastically: ideal crystals yield at about a tenth of their modulus (A. Kelly, N. H. Macmillan, Strong Solids, 1986).
const ELASTIC_SHARE: f64 = 0.1;
/// Half-widths above this (m) are rare, and those in millimetres that were read as metres.
const WIDE: f64 = 1.0;
/// Angles from here on (rad) are told by their power of ten.
const LARGE_ANGLE: f64 = 1e3;
/// Places in each zone of contact between which slopes are taken, and at most in an interval of tension.
const PLACES: usize = 400;
/// In all intervals of tension together so many, but so many in each at least: of a half-wave these miss `1 - cos(pi/80)` at most.
const TOGETHER: usize = 4_000;
const FEWEST: usize = 40;

impl Contact {
    /// What an engineer would doubt about a physical answer, with the number and the likely slip: slopes, angles, pressures, displacements and sizes beyond those for which the model is made.
    ///
    /// ```
    /// use shtaerman::{Elastic, Foundation, Load, Problem, Punch, WarningCode};
    ///
    /// let steel = Foundation::new(Elastic::new(200e9, 0.3)?).with_roughness(1.2e-14)?;
    /// let bar = Problem::new(steel, Punch::new(5e-3)?, Load::force(0.8e6)?)?;
    /// assert!(bar.solve()?.sense_checks().is_empty());
    /// // The force meant was per millimetre.
    /// let heavy = bar.with_force(0.8e9)?.solve()?;
    /// assert_eq!(heavy.sense_checks()[0].code, WarningCode::HighPressure);
    /// # Ok::<(), shtaerman::Error>(())
    /// ```
    #[must_use]
    pub fn sense_checks(&self) -> Vec<Warning> {
        self.sense_checks_in(&OutputUnits::default())
    }

    /// The same with numbers in these units.
    pub(crate) fn sense_checks_in(&self, units: &OutputUnits) -> Vec<Warning> {
        let Some(scaling) = self.problem().scaling() else { return Vec::new() };
        let half_width = scaling.half_width();
        let modulus = resisting_modulus(self.problem().foundation(), scaling.contact_modulus());
        let length = |value| units.shown(value, Measure::Length);
        let stress = |value| units.shown(value, Measure::Pressure);
        let is_circular = self.problem().punch().geometry() == Geometry::Circular;
        let slips = Slips::of(self.problem().load(), is_circular);
        let mut found = Vec::new();
        found.extend(wide_base(self.problem(), units));
        let mut doubt = |is_doubtful: bool, code, message: String| {
            if is_doubtful {
                found.push(Warning { code, message });
            }
        };
        if let Some((slope, x)) = steepest(self.problem(), self.zones()) {
            doubt(
                slope > SMALL_SLOPE,
                WarningCode::SteepBase,
                format!(
                    "the base has the slope {slope:.2} at x = {}, and small slopes are assumed: a profile takes metres and gives metres",
                    length(x)
                ),
            );
        }
        doubt(
            self.tilt().abs() > SMALL_SLOPE,
            WarningCode::LargeTilt,
            format!(
                "the tilt is {} rad, and small angles are assumed: {}",
                angle(self.tilt()),
                slips.tilt
            ),
        );
        let (name, pressure) = self.telling_pressure();
        doubt(
            pressure > ELASTIC_SHARE * modulus,
            WarningCode::HighPressure,
            format!(
                "the {name}, {}, is above a tenth of the modulus that resists it, {}: no solid bears that elastically; {}",
                stress(pressure),
                stress(modulus),
                slips.pressure
            ),
        );
        let settlement = self.settlement();
        doubt(
            settlement.abs() > half_width,
            WarningCode::LargeDisplacement,
            format!(
                "the settlement, {}, is more than the {}, {}, and small displacements are assumed: {}",
                units.shown(settlement, Measure::Displacement),
                half_width_name(is_circular),
                length(half_width),
                slips.settlement
            ),
        );
        found
    }
}

impl Contact {
    /// The largest pressure or tension, whichever is more, or, where a corner or a kink of a smooth surface makes that infinite, the mean one in contact (Pa), with its name.
    pub(crate) fn telling_pressure(&self) -> (&'static str, f64) {
        let (peak, tension) = (self.peak_pressure(), self.largest_tension());
        match self.mean_contact_pressure() {
            mean if !(peak.is_finite() && tension.is_finite()) => {
                (if mean < 0.0 { "mean tension" } else { "mean pressure" }, mean.abs())
            }
            _ if tension > peak => ("largest tension", tension),
            _ => ("largest pressure", peak),
        }
    }

    /// The largest tension at some places where the pressure of a bilateral contact is negative (Pa), a thousandth of it too small at most for half-waves, more for peaks narrower than the places are apart; 0 where it is so nowhere.
    fn largest_tension(&self) -> f64 {
        let intervals = self.tension();
        let count = (TOGETHER / intervals.len().max(1)).clamp(FEWEST, PLACES);
        let places: Vec<f64> = (intervals.into_iter())
            .flat_map(|[left, right]| {
                // A rounding beyond the edge would be no place of the base.
                (0..=count).map(move |k| {
                    (left + (right - left) * k as f64 / count as f64).clamp(left, right)
                })
            })
            .collect();
        let pressures = self.pressures(&places).unwrap_or_default();
        pressures.into_iter().fold(0.0, |most, pressure| f64::max(most, -pressure))
    }
}

/// The likely slips behind what is doubted, by what the load prescribes.
struct Slips {
    tilt: &'static str,
    pressure: &'static str,
    settlement: &'static str,
}

impl Slips {
    fn of(load: &Load, is_circular: bool) -> Self {
        let is_by_settlement = matches!(load.vertical(), Vertical::Settlement(_));
        Self {
            tilt: match load.rotational() {
                Rotational::Tilt(_) => "is the tilt in rad, or were mrad or degrees meant?",
                Rotational::Moment(_) | Rotational::Eccentricity(_) if is_circular => {
                    "is the moment in N m, and the roughness in m/Pa?"
                }
                Rotational::Moment(_) | Rotational::Eccentricity(_) => {
                    "is the moment in N m per m, and the roughness in m/Pa?"
                }
            },
            pressure: match (is_by_settlement, is_circular) {
                (true, _) => "is the settlement in m, and the modulus in GPa?",
                (false, true) => "is the load in N, and the modulus in GPa?",
                (false, false) => "is the load per metre of length, and the modulus in GPa?",
            },
            settlement: match is_by_settlement {
                true => "were mm or um meant?",
                false => "is the modulus in Pa, and the roughness in m/Pa?",
            },
        }
    }
}

/// What the half-width of a base is called.
fn half_width_name(is_circular: bool) -> &'static str {
    if is_circular { "radius" } else { "half-width" }
}

/// An angle to three decimals, large ones by their power of ten.
fn angle(value: f64) -> String {
    if value.abs() < LARGE_ANGLE { format!("{value:.3}") } else { format!("{value:.1e}") }
}

/// That the base is wider than machines have, with its half-width in these units.
pub(crate) fn wide_base(problem: &Problem, units: &OutputUnits) -> Option<Warning> {
    let half_width = problem.scaling()?.half_width();
    let shown = units.shown(half_width, Measure::Length);
    let name = half_width_name(problem.punch().geometry() == Geometry::Circular);
    (half_width > WIDE).then(|| Warning {
        code: WarningCode::WideBase,
        message: format!("the {name} is {shown}: are millimetres meant?"),
    })
}

/// `E*`; of a layer bonded to a rigid base, which cannot evade to the sides, `E (1 - nu)/((1 + nu)(1 - 2 nu))` where that is larger.
fn resisting_modulus(foundation: &Foundation, contact_modulus: f64) -> f64 {
    let is_confined = matches!(
        foundation.layering(),
        Some(Layering::Layer { base: LayerBase::Bonded { .. }, .. })
    );
    match foundation.material() {
        Some(material) if is_confined => {
            let (e, nu) = (material.young_modulus(), material.poisson_ratio());
            contact_modulus.max(e * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)))
        }
        _ => contact_modulus,
    }
}

/// The steepest slope of the base in the zones of contact, and its place (m); steps are none.
fn steepest(problem: &Problem, zones: Vec<[f64; 2]>) -> Option<(f64, f64)> {
    let half_width = problem.punch().half_width();
    let profile = problem.profile();
    let breaks = profile.breakpoints(half_width);
    let mut steepest: Option<(f64, f64)> = None;
    for [left, right] in zones {
        let place = |k: usize| (left + (right - left) * k as f64 / PLACES as f64) / half_width;
        let places: Vec<f64> = (0..=PLACES).map(place).collect();
        let heights = profile.heights(&places, half_width);
        for (ends, heights) in places.windows(2).zip(heights.windows(2)) {
            let ([from, to], [before, after]) = ([ends[0], ends[1]], [heights[0], heights[1]]);
            let is_broken = breaks.iter().any(|at| from <= *at && *at <= to);
            let slope = ((after - before) / ((to - from) * half_width)).abs();
            if !is_broken && slope.is_finite() && steepest.is_none_or(|(most, _)| slope > most) {
                steepest = Some((slope, 0.5 * (from + to) * half_width));
            }
        }
    }
    steepest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Elastic, Load, Profile, Punch};

    fn codes(half_width: f64, profile: &str, force: f64, modulus: f64) -> Vec<WarningCode> {
        let foundation = Foundation::new(Elastic::new(modulus, 0.3).unwrap());
        let foundation = foundation.with_roughness(0.1 * half_width / modulus).unwrap();
        let punch = Punch::new(half_width).unwrap();
        let punch = punch.with_profile(Profile::expression(profile).unwrap());
        let load = Load::force(force).unwrap();
        let contact = Problem::new(foundation, punch, load).unwrap().solve().unwrap();
        contact.sense_checks().into_iter().map(|warning| warning.code).collect()
    }

    #[test]
    fn each_slip_is_found_and_plain_work_raises_none() {
        assert_eq!(codes(5e-3, "x^2 / 40", 0.8e6, 200e9), []);
        // Millimetres read as metres, with a load to match.
        assert_eq!(codes(5.0, "x^2 / 40000", 0.8e9, 200e9), [WarningCode::WideBase]);
        // A radius in millimetres.
        assert!(codes(5e-3, "x^2 / (2*0.02)", 0.8e9, 200e9).contains(&WarningCode::SteepBase));
        // Gigapascals left out.
        let soft = codes(5e-3, "0", 0.8e6, 200e6);
        assert!(soft.contains(&WarningCode::HighPressure), "{soft:?}");
        let softer = codes(5e-3, "0", 0.8e6, 2e6);
        assert!(softer.contains(&WarningCode::LargeDisplacement), "{softer:?}");
    }

    /// A smooth flat punch has an infinite pressure at its corners, whatever the load.
    #[test]
    fn the_mean_pressure_tells_where_the_largest_is_infinite() {
        let codes = |force: f64| -> Vec<WarningCode> {
            let foundation = Foundation::new(Elastic::new(200e9, 0.3).unwrap());
            let punch = Punch::new(5e-3).unwrap();
            let problem = Problem::new(foundation, punch, Load::force(force).unwrap()).unwrap();
            let found = problem.solve().unwrap().sense_checks();
            found.into_iter().map(|warning| warning.code).collect()
        };
        // E*/10 is 22 GPa.
        assert_eq!(codes(0.2e9), []);
        assert_eq!(codes(0.3e9), [WarningCode::HighPressure]);
    }

    #[test]
    fn a_step_is_no_slope() {
        assert_eq!(codes(5e-3, "1e-7*step(x - 0.001)", 0.8e6, 200e9), []);
    }
}
