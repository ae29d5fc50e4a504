//! The whole contact as one spring: force against settlement, moment against rotation.

use super::conditions::{check_problem, check_share, settlement, standing, under};
use super::lift_off::lift_off;
use crate::error::require;
use crate::{Datum, Error, Problem, Rotational, Vertical};

/// Most points of a curve: where so many do not suffice, it has a kink or a jump.
const MOST_POINTS: usize = 1000;
/// What a line is off by at least, as a share of the range: its ends are written with 14 digits.
const DIGITS: f64 = 1e-13;
/// Intervals to begin with.
const FIRST: usize = 4;

/// Solved points of a curve that a finite-element program joins by straight lines.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCurve {
    /// Displacement and load, both growing: settlement since lift-off (m) and force (N/m, N of a disk), or rotation `-alpha` (rad) and moment (N m/m, N m).
    pub points: Vec<[f64; 2]>,
    /// How far the displacement solved at the middle of a straight line, or of two of them together, is from it, at most, as a share of the range of the displacement: an estimate of what the lines are off
    /// by. Where other parts of the base come to touch between these places it may be more.
    pub deviation: f64,
    /// The largest relative error that an answer states of itself.
    pub relative_error: f64,
}

/// The force against the settlement since lift-off, from lift-off to the force of the problem times a factor, with the tilt of the load or its eccentricity `M/P`, which every force keeps.
/// The settlement is that in the gauge of the problem, or against a datum.
///
/// ```
/// use shtaerman::finite_elements::force_curve;
/// use shtaerman::{Elastic, Foundation, Load, Problem, Profile, Punch};
///
/// let steel = Foundation::new(Elastic::new(200e9, 0.3)?).with_roughness(1.2e-14)?;
/// let crowned = Punch::new(5e-3)?.with_profile(Profile::expression("x^2/(2*20)")?);
/// let problem = Problem::new(steel, crowned, Load::force(0.8e6)?)?;
/// let curve = force_curve(&problem, 2.0, 1e-3, None)?;
/// let [settlement, force] = curve.points[curve.points.len() - 1];
/// assert_eq!(force, 1.6e6);
/// assert!((settlement / problem.with_force(1.6e6)?.solve()?.settlement() - 1.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::NoTable`] for a dimensionless and for a bilateral problem, for a settlement that does not grow with the force, and where a thousand points do not suffice;
/// [`Error::InvalidValue`] for a share outside of [`SHARES`](super::SHARES) and a factor that is not positive; those of [`Problem::solve`] and of [`Contact::relative_settlement`].
pub fn force_curve(
    problem: &Problem,
    factor: f64,
    share: f64,
    datum: Option<Datum>,
) -> Result<LoadCurve, Error> {
    check_share(share)?;
    check_problem(problem)?;
    let requirement = "finite and greater than zero";
    require(factor.is_finite() && factor > 0.0, "factor", factor, requirement)?;
    let own = problem.solve()?;
    let rotational = standing(&own);
    let lift_off = lift_off(problem, rotational);
    let largest = factor * own.force();
    let mut tracer = Tracer::new(share, |force: f64| {
        if force == 0.0 {
            return Ok((0.0, 0.0));
        }
        let contact = under(problem, force, rotational)?;
        Ok((settlement(&contact, datum)? - lift_off, contact.relative_error()))
    });
    // Near lift-off a small force moves the punch most.
    let first = |index: usize| largest * (index as f64 / FIRST as f64).powi(2);
    let middle = |less: f64, more: f64| (0.5 * (less.sqrt() + more.sqrt())).powi(2);
    let reason = "the settlement of the middle does not grow with the force: the punch turns under its eccentric force faster than it settles, and a connector needs a growing curve; prescribe the tilt, or a smaller eccentricity";
    tracer.curve((0..=FIRST).map(first), &middle, reason)
}

/// The moment against the rotation `-alpha` under the force of the problem, between two moments of the same size: a share of `P a`, which no pressure on the base balances.
///
/// # Errors
/// Those of [`force_curve`]; [`Error::InvalidValue`] for a share of the tipping moment that is not between 0 and 1.
pub fn moment_curve(problem: &Problem, tipping_share: f64, share: f64) -> Result<LoadCurve, Error> {
    check_share(share)?;
    check_problem(problem)?;
    let requirement = "greater than 0 and less than 1: at P a the punch tips over";
    require(
        tipping_share > 0.0 && tipping_share < 1.0,
        "moment share",
        tipping_share,
        requirement,
    )?;
    if problem.is_wave() {
        let reason =
            "a base that fills its whole period cannot tilt: it has no curve of the moment";
        return Err(Error::NoTable { reason });
    }
    let force = match problem.load().vertical() {
        Vertical::Force(force) => force,
        Vertical::Settlement(_) => problem.solve()?.force(),
    };
    let largest = tipping_share * force * problem.punch().half_width();
    let mut tracer = Tracer::new(share, |moment: f64| {
        let contact = under(problem, force, Rotational::Moment(moment))?;
        Ok((-contact.tilt(), contact.relative_error()))
    });
    let first = |index: usize| largest * (2.0 * index as f64 / FIRST as f64 - 1.0);
    let middle = |less: f64, more: f64| 0.5 * (less + more);
    let reason = "the rotation does not grow with the moment";
    tracer.curve((0..=FIRST).map(first), &middle, reason)
}

/// Follows a curve from load to load.
struct Tracer<F> {
    share: f64,
    /// Displacement and relative error under a load.
    answer: F,
    relative_error: f64,
    /// Points that were solved.
    known: Vec<[f64; 2]>,
}

impl<F: FnMut(f64) -> Result<(f64, f64), Error>> Tracer<F> {
    fn new(share: f64, answer: F) -> Self {
        Self { share, answer, relative_error: 0.0, known: Vec::new() }
    }

    fn point(&mut self, load: f64) -> Result<[f64; 2], Error> {
        if let Some(known) = self.known.iter().rev().find(|known| known[1] == load) {
            return Ok(*known);
        }
        let (displacement, error) = (self.answer)(load)?;
        self.relative_error = self.relative_error.max(error);
        self.known.push([displacement, load]);
        Ok([displacement, load])
    }

    /// Adds the middles of intervals until they are on the straight lines within the share, and so are those of the halves that are left: one place alone may lie on the line by chance, where a new zone bends
    /// the curve one way and the others bend it the other way.
    fn curve(
        &mut self,
        first: impl Iterator<Item = f64>,
        middle: &dyn Fn(f64, f64) -> f64,
        turns: &'static str,
    ) -> Result<LoadCurve, Error> {
        let mut ahead = first.map(|load| self.point(load)).collect::<Result<Vec<_>, _>>()?;
        ahead.reverse();
        let range = ahead[0][0] - ahead[ahead.len() - 1][0];
        let mut points: Vec<[f64; 2]> = ahead.pop().into_iter().collect();
        let mut deviation = 0.0f64;
        while let (Some(&last), Some(&next)) = (points.last(), ahead.last()) {
            if next[0].is_nan() || next[0] <= last[0] {
                return Err(Error::NoTable { reason: turns });
            }
            if points.len() + ahead.len() > MOST_POINTS {
                let reason = "a thousand points do not make straight lines as close to the curve as was asked for: it has a jump, or the share is too small";
                return Err(Error::NoTable { reason });
            }
            let between = self.point(middle(last[1], next[1]))?;
            let mut off = off_line(last, between, next) / range;
            for [from, to] in [[last, between], [between, next]] {
                if off <= self.share {
                    let quarter = self.point(middle(from[1], to[1]))?;
                    off = off.max(off_line(from, quarter, to) / range);
                }
            }
            if off <= self.share {
                deviation = deviation.max(off);
                points.extend([between, next]);
                ahead.pop();
            } else {
                ahead.push(between);
            }
        }
        if points.windows(2).any(|pair| pair[1][0] <= pair[0][0]) {
            return Err(Error::NoTable { reason: turns });
        }
        Ok(LoadCurve {
            points,
            deviation: deviation.max(DIGITS),
            relative_error: self.relative_error,
        })
    }
}

/// How far a point is from the straight line between two others, in displacement.
fn off_line(from: [f64; 2], point: [f64; 2], to: [f64; 2]) -> f64 {
    let along = (point[1] - from[1]) / (to[1] - from[1]);
    (point[0] - from[0] - along * (to[0] - from[0])).abs()
}
