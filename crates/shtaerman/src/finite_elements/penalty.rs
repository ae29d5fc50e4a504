//! The penalty stiffness that a share of the settlement allows.

use std::f64::consts::PI;

use super::conditions::{check_problem, check_share, held, settlement, standing, under};
use super::lift_off::lift_off;
use crate::answer::datum::integral;
use crate::error::require;
use crate::{Contact, Datum, Error, Roughness, Scaling};

/// Relative step of the force: the difference is off by its square, and rounding of the answers by their `1e-12` over it.
const STEP: f64 = 1e-3;

/// The penalty stiffness of a contact in series with the rough layer.
///
/// A penalty stiffness `k` (Pa/m) lets the bodies overlap by `p/k` beside what the layer gives, and raises the settlement. To first order by `w/k`,
///
/// `w = int p dp/dP dx`,
///
/// a mean of the pressure weighted with what each place takes of more force: `int p^2 dx` is twice the energy of that series per compliance `1/k`, and the derivative of the
/// energy by the force is the settlement. So `k >= w/(share (delta - delta_0))` keeps the settlement, counted from that of lift-off, within the share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Penalty {
    /// The least penalty stiffness (Pa/m).
    pub stiffness: f64,
    /// `w` (Pa), by a difference of two solves: estimated, to about `1e-6`.
    pub mean_pressure: f64,
    /// The settlement since lift-off (m).
    pub settlement: f64,
    /// The share of it that the penalty may take.
    pub share: f64,
}

impl Penalty {
    /// The penalty stiffness for a share of the settlement, which is that against a datum where there is one.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a share outside of [`SHARES`](super::SHARES), and for a settlement since lift-off that is not positive in the gauge of the problem;
    /// [`Error::NoTable`] for a dimensionless and for a bilateral contact, and for a smooth surface, whose energy a penalty does not change to first order;
    /// those of [`Problem::solve`](crate::Problem::solve) and of [`Contact::relative_settlement`].
    pub fn new(contact: &Contact, share: f64, datum: Option<Datum>) -> Result<Self, Error> {
        check_share(share)?;
        let problem = contact.problem();
        check_problem(problem)?;
        if problem.foundation().roughness() == Roughness::Smooth {
            let reason = "on a smooth surface the pressure is infinite at corners, and a penalty changes the settlement by more than its inverse";
            return Err(Error::NoTable { reason });
        }
        let (force, rotational) = (contact.force(), held(contact));
        let energy = |force: f64| -> Result<f64, Error> {
            Ok(0.5 * squared(&under(problem, force, rotational)?))
        };
        let [less, more] = [energy(force * (1.0 - STEP))?, energy(force * (1.0 + STEP))?];
        let mean_pressure = (more - less) / (2.0 * STEP * force);
        let settlement = settlement(contact, datum)? - lift_off(problem, standing(contact));
        let requirement =
            "greater than zero since lift-off, for a share of it to be a length: name a datum";
        require(settlement > 0.0, "settlement", settlement, requirement)?;
        let stiffness = mean_pressure / (share * settlement);
        Ok(Self { stiffness, mean_pressure, settlement, share })
    }
}

/// `int p^2 dm` over all zones (Pa^2 m, Pa^2 m^2 of a disk).
fn squared(contact: &Contact) -> f64 {
    let problem = contact.problem();
    let half_width = problem.punch().half_width();
    // A zone of a wave may pass the end of the base: the next period is the same.
    let shifts: &[f64] = if problem.is_wave() { &[-2.0, 0.0, 2.0] } else { &[0.0] };
    let kinks = problem.profile().breakpoints(half_width);
    let shifted = |shift: f64| kinks.iter().map(move |xi| (xi + shift) * half_width);
    let mut cuts: Vec<f64> = shifts.iter().copied().flat_map(shifted).collect();
    cuts.push(0.0);
    cuts.sort_by(f64::total_cmp);
    let scale = problem.bodies().unit(Scaling::pressure);
    let at = |x: f64| {
        let xi = x / half_width;
        let on_base = if problem.is_wave() { xi - 2.0 * (0.5 * xi).round() } else { xi };
        scale * contact.pressure_at(on_base)
    };
    let density: &dyn Fn(f64) -> f64 = if problem.is_circular() {
        // p = p0 + p1 cos phi: half of the circle on either side of the axis.
        &|x| {
            let (here, there) = (at(x), at(-x));
            let [even, odd] = [0.5 * (here + there), 0.5 * (here - there)];
            PI * x.abs() * (even * even + 0.5 * odd * odd)
        }
    } else {
        &|x| at(x).powi(2)
    };
    let mut sum = 0.0;
    for [left, right] in contact.zones() {
        let mut from = left;
        let inside = cuts.iter().copied().filter(|cut| *cut > left && *cut < right);
        for to in inside.chain([right]) {
            sum += integral(from, to, density);
            from = to;
        }
    }
    sum
}
