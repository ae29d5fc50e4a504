//! Stress fields of solved contacts.

use super::StressField;
use super::sampling::Effort;
use crate::{Contact, Error, Geometry, Problem, Scaling};

/// Most breakpoints of the profile that get panels of their own.
const MOST_BREAKS: usize = 15;
/// Rounding of a place in a zone: of its distances from both ends and the angle that they make (rounding).
const BLUR: f64 = 16.0 * f64::EPSILON;
/// Error of the stresses aimed at, in errors of the pressure.
const SHARE: f64 = 0.1;
/// A pressure of more terms than these is costly (milliseconds each), and gets no more nodes than those.
const COSTLY: usize = 8192;
const MOST_COSTLY: usize = 1500;

impl Problem {
    /// Refuses what has no known stresses below the surface.
    ///
    /// # Errors
    /// [`Error::NoStresses`] for a circular punch and a graded foundation.
    pub fn check_stresses(&self) -> Result<(), Error> {
        let foundation = self.foundation();
        let is_layered = foundation.layering().is_some();
        if self.is_circular() || foundation.grading().is_some() || is_layered {
            Err(Error::NoStresses)
        } else {
            Ok(())
        }
    }
}

impl StressField {
    /// The stresses under a contact, in its units; `poisson_ratio` is that of the foundation where left out, a dimensionless problem needs it.
    ///
    /// # Errors
    /// [`Error::NoStresses`] for a circular punch and a graded foundation, [`Error::NoPoissonRatio`], [`Error::InvalidValue`] for a ratio beyond `(-1, 0.5]`.
    pub fn new(contact: &Contact, poisson_ratio: Option<f64>) -> Result<Self, Error> {
        Self::to_accuracy(contact, poisson_ratio, 0.0)
    }

    /// The same where errors up to `accuracy`, a share of the mean pressure of the contact, serve, such as for a picture: [`StressField::error`] says what was reached.
    ///
    /// # Errors
    /// Those of [`StressField::new`].
    pub fn to_accuracy(
        contact: &Contact,
        poisson_ratio: Option<f64>,
        accuracy: f64,
    ) -> Result<Self, Error> {
        let error = contact.accuracy().map_or(0.0, |accuracy| accuracy.pressure);
        let pressure0 = |zone: usize, from_left: f64, from_right: f64| {
            contact.pressure_beside(zone, from_left, from_right)
        };
        let costly = contact.method().n > COSTLY;
        let most = if costly { MOST_COSTLY } else { Effort::FULL.most };
        let effort = Effort { enough: SHARE * error, accuracy, most };
        let zones = contact.dimensionless().zones();
        let field = under(contact.problem(), &zones, poisson_ratio, effort, &pressure0)?;
        let units = (contact.half_width(), contact.scale(Scaling::pressure));
        Ok(field.with_pressure_error(error).in_units(units.0, units.1))
    }
}

/// The field of `p0`, by zone and the distances from its ends, on zones that the breakpoints of the profile cut.
fn under(
    problem: &Problem,
    zones: &[[f64; 2]],
    poisson_ratio: Option<f64>,
    effort: Effort,
    pressure0: &dyn Fn(usize, f64, f64) -> f64,
) -> Result<StressField, Error> {
    let bodies = problem.bodies();
    problem.check_stresses()?;
    let given =
        poisson_ratio.or(problem.foundation().poisson_ratio()).ok_or(Error::NoPoissonRatio)?;
    let period = match bodies.geometry().scaled(bodies.half_width()) {
        Geometry::Periodic { period } => Some(period),
        _ => None,
    };
    let breaks = breaks(problem, period);
    let (panels, owners): (Vec<[f64; 2]>, Vec<usize>) = (zones.iter().enumerate())
        .flat_map(|(owner, &zone)| {
            crate::order::panels(zone, &breaks).into_iter().map(move |panel| (panel, owner))
        })
        .unzip();
    let pressure = |panel: usize, from_left: f64, to_right: f64| {
        let ([left, right], zone) = (panels[panel], zones[owners[panel]]);
        // Beside a kink within a zone no place is nearer than its rounding, and at it the pressure may be infinite.
        let rounding = BLUR * zone[0].abs().max(zone[1].abs());
        let is_end = from_left == 0.0 || to_right == 0.0;
        let beside = |distance: f64, is_inside: [bool; 2]| {
            let [nearest, farthest] = [
                if is_inside[0] { rounding } else { 0.0 },
                if is_inside[1] { right - left - rounding } else { f64::INFINITY },
            ];
            if is_end { distance } else { distance.max(nearest).min(farthest) }
        };
        let is_inside = [left > zone[0], right < zone[1]];
        let from_left = beside(from_left, is_inside);
        let to_right = beside(to_right, [is_inside[1], is_inside[0]]);
        pressure0(owners[panel], left - zone[0] + from_left, zone[1] - right + to_right)
    };
    StressField::within(&panels, period, given, effort, &pressure)
}

/// Breakpoints of the profile, as `xi`, unless there are more than the solver gives panels: then none, and the error tells what that costs. What is repeated may bend at its seam as well, and a zone may lie across it.
fn breaks(problem: &Problem, period: Option<f64>) -> Vec<f64> {
    let mut breaks = problem.profile().breakpoints(problem.bodies().half_width());
    if let Some(period) = period {
        breaks.push(0.5 * period);
        breaks = [-period, 0.0, period]
            .iter()
            .flat_map(|by| breaks.iter().map(move |at| at + by))
            .collect();
    }
    if breaks.len() > MOST_BREAKS {
        return Vec::new();
    }
    breaks.sort_by(f64::total_cmp);
    breaks
}
