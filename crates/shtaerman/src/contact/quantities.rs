//! The quantities of a contact, each in the units that the contact is told in.

use serde::Serialize;

use super::complementarity::Complementarity;
use super::solved::Contact;
use super::stiffness::Stiffness;
use super::{Accuracy, ErrorKind};
use crate::{Error, Rotational, Scaling, Vertical};

/// The errors of a contact; zero for what the load prescribes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Errors {
    /// Bound or estimate.
    #[serde(skip)]
    pub kind: ErrorKind,
    /// Largest error of the pressure on the closed base.
    pub pressure: f64,
    /// Error of the largest pressure, where an audit bounds it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_pressure: Option<f64>,
    /// Error of the settlement.
    pub settlement: f64,
    /// Error of the tilt.
    pub tilt: f64,
    /// Error of the force.
    pub force: f64,
    /// Error of the moment.
    pub moment: f64,
    /// Error of the free ends of the zones.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub zones: Option<f64>,
    /// Errors of the entries of the tangent stiffness, where the method tells them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<[[f64; 2]; 2]>,
}

impl Contact {
    /// `theta0 = 2 a/(pi E* chi)`.
    #[must_use]
    pub fn theta0(&self) -> f64 {
        self.problem().theta0()
    }

    /// Force per unit length `P` (N/m), under a circular punch the force (N); where it is prescribed, as given. Without dimensions `P/(a E)`.
    #[must_use]
    pub fn force(&self) -> f64 {
        match self.problem().load().vertical {
            Vertical::Force(prescribed) if self.is_as_stated() => prescribed,
            _ => self.state().force * self.scale(Scaling::force),
        }
    }

    /// Moment per unit length `M = int x p dx` (N m/m), under a circular punch the moment (N m); where it is prescribed, as given. Without dimensions `M/(a^2 E)`.
    ///
    /// Of a wave without gaps it is that over the period from `-a` to `a`, whatever the load says: a moment cannot turn it.
    #[must_use]
    pub fn moment(&self) -> f64 {
        let is_given = self.is_as_stated() && !self.problem().is_wave();
        match self.problem().load().rotational {
            Rotational::Moment(prescribed) if is_given => prescribed,
            Rotational::Eccentricity(eccentricity) if is_given => eccentricity * self.force(),
            _ => self.state().moment * self.scale(Scaling::moment),
        }
    }

    /// Settlement `delta` (m) in the [gauge](crate::Problem::gauge) of the problem; where it is prescribed, as given. Without dimensions `delta/(chi E)`.
    #[must_use]
    pub fn settlement(&self) -> f64 {
        match self.problem().load().vertical {
            Vertical::Settlement(prescribed) if self.is_as_stated() => prescribed,
            _ => self.state().settlement * self.scale(Scaling::displacement),
        }
    }

    /// Tilt `alpha` (rad); a positive moment gives a negative one; where it is prescribed, as given. Without dimensions `a alpha/(chi E)`.
    #[must_use]
    pub fn tilt(&self) -> f64 {
        match self.problem().load().rotational {
            Rotational::Tilt(prescribed) if self.is_as_stated() => prescribed,
            _ => self.state().tilt * self.scale(Scaling::angle),
        }
    }

    /// Pressure `p(x)` (Pa), 0 outside the zones of a unilateral contact and at their free edges; without dimensions `p/E` at `x/a`. On a smooth surface
    /// infinite at corners and under kinks of the base, negative where that is hollow.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] outside the closed base, also for NaN.
    pub fn pressure(&self, x: f64) -> Result<f64, Error> {
        Ok(self.pressure_at(self.on_base(x)?) * self.scale(Scaling::pressure))
    }

    /// Pressures `p(x)` (Pa) at many places; of a smooth surface they cost less than one by one.
    ///
    /// # Errors
    /// [`Error::BeyondPunch`] as soon as one lies outside the closed base or is NaN.
    pub fn pressures(&self, places: &[f64]) -> Result<Vec<f64>, Error> {
        let on_base: Vec<f64> =
            places.iter().map(|x| self.on_base(*x)).collect::<Result<_, _>>()?;
        let mut pressures = self.pressures_at(&on_base);
        let scale = self.scale(Scaling::pressure);
        pressures.iter_mut().for_each(|p| *p *= scale);
        Ok(pressures)
    }

    /// The `xi` of a point on the closed base.
    pub(super) fn on_base(&self, x: f64) -> Result<f64, Error> {
        let half_width = self.half_width();
        if x.abs() <= half_width {
            let xi = (x / half_width).clamp(-1.0, 1.0);
            // The reciprocal of a subnormal place overflows.
            return Ok(if xi.is_subnormal() { 0.0 } else { xi });
        }
        let variable = if self.is_as_stated() { self.problem().coordinate() } else { "xi" };
        Err(Error::BeyondPunch { variable, at: x, left: -half_width, right: half_width })
    }

    /// `a`, or 1.
    pub(crate) fn half_width(&self) -> f64 {
        self.scale(Scaling::half_width)
    }

    /// Pressure at the left edge of the punch (Pa); 0 where it lifted off.
    #[must_use]
    pub fn pressure_left(&self) -> f64 {
        self.pressure_at(-1.0) * self.scale(Scaling::pressure)
    }

    /// Pressure in the middle of the punch (Pa).
    #[must_use]
    pub fn pressure_middle(&self) -> f64 {
        self.pressure_at(0.0) * self.scale(Scaling::pressure)
    }

    /// Pressure at the right edge of the punch (Pa); 0 where it lifted off.
    #[must_use]
    pub fn pressure_right(&self) -> f64 {
        self.pressure_at(1.0) * self.scale(Scaling::pressure)
    }

    /// Mean pressure over the base (Pa): `P/(2a)`, or `P/(pi a^2)` under a circular punch.
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        let punch = self.problem().punch();
        let mean = self.state().force / punch.geometry().measure(punch.half_width());
        mean * self.scale(Scaling::pressure)
    }

    /// Mean pressure over the contact alone (Pa): the force over the width of the zones, or over the area of the disk and rings that zones of a diameter stand for.
    #[must_use]
    pub fn mean_contact_pressure(&self) -> f64 {
        let zones = self.solution().zones();
        let measure: f64 = if self.problem().is_circular() {
            // Half a disk or ring on either side of the axis.
            let half = |[left, right]: &[f64; 2]| right * right.abs() - left * left.abs();
            0.5 * std::f64::consts::PI * zones.iter().map(half).sum::<f64>()
        } else {
            zones.iter().map(|[left, right]| right - left).sum()
        };
        let mean = if measure > 0.0 { self.state().force / measure } else { 0.0 };
        mean * self.scale(Scaling::pressure)
    }

    /// The largest pressure (Pa).
    #[must_use]
    pub fn peak_pressure(&self) -> f64 {
        self.peak().0 * self.scale(Scaling::pressure)
    }

    /// Where the pressure is largest (m); of equal places the leftmost.
    #[must_use]
    pub fn peak_pressure_at(&self) -> f64 {
        self.peak().1 * self.half_width()
    }

    /// Intervals of the base where the pressure of a bilateral contact is negative (m).
    #[must_use]
    pub fn tension(&self) -> Vec<[f64; 2]> {
        let half_width = self.half_width();
        self.tension_at().iter().map(|interval| interval.map(|xi| xi * half_width)).collect()
    }

    /// The zones of contact from left to right, `[left, right]` (m); the full base of a bilateral contact.
    #[must_use]
    pub fn zones(&self) -> Vec<[f64; 2]> {
        let half_width = self.half_width();
        self.solution().zones().into_iter().map(|zone| zone.map(|xi| xi * half_width)).collect()
    }

    /// Width of all zones together (m).
    #[must_use]
    pub fn contact_width(&self) -> f64 {
        self.zones().iter().map(|[left, right]| right - left).sum()
    }

    /// What a unilateral answer leaves of tension and penetration, relative to their scales; none for a bilateral one.
    #[must_use]
    pub fn complementarity(&self) -> Option<Complementarity> {
        self.solution().complementarity()
    }

    /// The tangent stiffness. A wave cannot tilt: its stiffness against that is infinite. How its moment changes is found of a symmetric one alone, which has none; else it is not a number.
    #[must_use]
    pub fn stiffness(&self) -> Stiffness {
        self.in_units(self.stiffness_by(self.solution().stiffness(), f64::INFINITY))
    }

    fn in_units(&self, stiffness: Stiffness) -> Stiffness {
        match self.problem().scaling() {
            Some(scaling) if self.is_as_stated() => stiffness.scaled(scaling),
            _ => stiffness,
        }
    }

    /// The errors of the answer, where the method tells them: those of the [audit](Self::audited) once it was made.
    #[must_use]
    pub fn error(&self) -> Option<Errors> {
        let open = self.accuracy()?.under(self.problem().load());
        let Accuracy { kind, pressure, settlement, tilt, force, moment } = open;
        let scaled = |unit: fn(&Scaling) -> f64, error: f64| error * self.scale(unit);
        let stiffness = self.solution().stiffness_error();
        let stiffness =
            stiffness.map(|error| self.in_units(self.stiffness_by(error, f64::NAN)).matrix());
        Some(Errors {
            kind,
            pressure: scaled(Scaling::pressure, pressure),
            peak_pressure: self.peak_error().map(|error| scaled(Scaling::pressure, error)),
            settlement: scaled(Scaling::displacement, settlement),
            tilt: scaled(Scaling::angle, tilt),
            force: scaled(Scaling::force, force),
            moment: scaled(Scaling::moment, moment),
            zones: self.zones_error().map(|error| scaled(Scaling::half_width, error)),
            stiffness,
        })
    }
}
