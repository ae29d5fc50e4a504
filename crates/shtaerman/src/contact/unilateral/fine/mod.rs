//! Contact in many zones, on equal cells: for measured profiles with thousands of points, and where collocation on the zones gives up.
//!
//! Cells carry mean pressures; the elastic displacement `theta0 K p0` of these is smooth, and where `g = delta0 - alpha0 xi - f0 - theta0 K p0` is positive, `g` is the
//! pressure: so edges do not keep to the cells, and there is neither tension nor penetration between them. The error falls with the square of the width of the cells; it is
//! estimated from half as many.

mod answer;
pub(super) mod edges;
mod surface;

pub(super) use answer::CellContact;
use surface::Fine;

use fredholm::complementarity::{CellCondition, CellSolution, EqualCells};

use super::answer::Complementarity;
use super::base::Base;
use super::zones::Zone;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::parts::{MOST_BREAKS, Smoothness};
use crate::contact::resolutions::UNKNOWN;
use crate::contact::solution::Solution;
use crate::contact::solved::Stiffness;
use crate::{Error, Rotational, Vertical};

/// Cells, at least and at most.
const FEWEST: usize = 16384;
const MOST: usize = 65536;
/// Numbers of cells on the way, as divisors of the last.
const LADDER: [usize; 5] = [64, 16, 4, 2, 1];
/// Largest `theta0 h`, as wanted and at most: beyond it a cell is wider than the layer in which the pressure changes at a corner.
const STIFF: f64 = 0.25;
const STIFFEST: f64 = 1.0;
/// Answers with larger relative errors are none.
const ROUGHEST: f64 = 0.05;

/// Whether the third derivative of the base jumps at measured points, where collocation loses its digits, or the base falls into more parts than it has panels for.
pub(super) fn suits(base: &Base<'_>) -> bool {
    let is_measured = base.problem.profile().measured_points().is_some();
    base.has_panels() && (is_measured || base.breaks.len() > MOST_BREAKS)
}

/// The answer on cells; `None` where cells do not serve: for a settlement with an eccentricity, a layer too thin for them, an error too large.
pub(super) fn solve(base: &Base<'_>) -> Result<Option<CellContact>, Error> {
    let Some([coarse, fine]) = levels(base)? else { return Ok(None) };
    let (accuracy, edge) = estimate(base, &fine, &coarse);
    let complementarity = checked(base, &fine);
    let contact = CellContact { fine, accuracy, edge_error: edge, complementarity };
    Ok((contact.relative_error() <= ROUGHEST).then_some(contact))
}

/// The zones alone, where cells serve.
pub(super) fn zones(base: &Base<'_>) -> Result<Option<Vec<Zone>>, Error> {
    Ok(levels(base)?.map(|[_, fine]| fine.zones))
}

/// The zones on half as many cells, to begin with.
pub(super) fn first_zones(base: &Base<'_>) -> Result<Option<Vec<Zone>>, Error> {
    Ok(first_level(base)?.map(|level| level.zones))
}

/// The contact on half as many cells.
pub(super) fn first_level(base: &Base<'_>) -> Result<Option<Fine>, Error> {
    let Some(count) = count(base) else { return Ok(None) };
    Ok(climbed(base, count, &LADDER[..LADDER.len() - 1], 1)?.pop())
}

/// The contact on half the cells and on all.
fn levels(base: &Base<'_>) -> Result<Option<[Fine; 2]>, Error> {
    let Some(count) = count(base) else { return Ok(None) };
    let levels = climbed(base, count, &LADDER, 2)?;
    let touching = levels.iter().all(|level| !level.zones.is_empty());
    Ok(<[Fine; 2]>::try_from(levels).ok().filter(|_| touching))
}

/// The number of cells that is wanted, where cells serve.
fn count(base: &Base<'_>) -> Option<usize> {
    let points = base.problem.profile().measured_points().unwrap_or(0);
    let stiff = (2.0 * base.theta / STIFF) as usize;
    let count = (2 * points).max(stiff.min(MOST)).next_power_of_two().clamp(FEWEST, MOST);
    let is_thin = base.theta * 2.0 / count as f64 > STIFFEST;
    (base.is_plain() && !is_eccentric(base) && !is_thin).then_some(count)
}

/// The contact on so many cells over the divisors of a ladder, that of the last `kept`; none, where exchanges do not end.
fn climbed(
    base: &Base<'_>,
    count: usize,
    ladder: &[usize],
    kept: usize,
) -> Result<Vec<Fine>, Error> {
    let mut levels: Vec<Fine> = Vec::new();
    let mut known: Option<CellSolution> = None;
    for (step, divisor) in ladder.iter().enumerate() {
        let level = Level::new(base, count / divisor)?;
        // Exchanges that do not end leave the problem to collocation.
        let Ok(solution) = level.solve(known.as_ref()) else { return Ok(Vec::new()) };
        if step + kept >= ladder.len() {
            levels.push(level.surface(&solution)?);
        }
        known = Some(solution);
    }
    Ok(levels)
}

/// A settlement with a force off the middle: no problem of least energy.
fn is_eccentric(base: &Base<'_>) -> bool {
    matches!(
        (base.load.vertical, base.load.rotational),
        (Vertical::Settlement(_), Rotational::Eccentricity(e)) if e != 0.0
    )
}

/// The problem on one number of cells.
struct Level<'b, 'p> {
    base: &'b Base<'p>,
    cells: EqualCells,
    centres: Vec<f64>,
    right: Vec<f64>,
    conditions: Vec<CellCondition>,
}

impl<'b, 'p> Level<'b, 'p> {
    fn new(base: &'b Base<'p>, count: usize) -> Result<Self, Error> {
        let width = 2.0 / count as f64;
        let centres: Vec<f64> = (0..count).map(|i| (i as f64 + 0.5) * width - 1.0).collect();
        let mut right: Vec<f64> =
            centres.iter().map(|x| -base.mean_height(*x, 0.5 * width)).collect();
        let mut add = |f: &dyn Fn(f64) -> f64| {
            right.iter_mut().zip(&centres).for_each(|(value, x)| *value += f(*x));
        };
        let condition = |f: &dyn Fn(f64) -> f64, value: f64| CellCondition {
            row: centres.iter().map(|x| width * f(*x)).collect(),
            value,
        };
        let mut conditions = Vec::new();
        let force = match base.load.vertical {
            Vertical::Force(force) => {
                conditions.push(condition(&|_| 1.0, force));
                force
            }
            Vertical::Settlement(settlement) => {
                add(&|_| settlement);
                0.0
            }
        };
        match base.load.rotational {
            Rotational::Moment(moment) => conditions.push(condition(&|x| x, moment)),
            Rotational::Eccentricity(e) => conditions.push(condition(&|x| x, e * force)),
            Rotational::Tilt(tilt) => add(&|x| -tilt * x),
        }
        let cells = EqualCells::new(count, base.theta)?;
        Ok(Self { base, cells, centres, right, conditions })
    }

    fn count(&self) -> usize {
        self.centres.len()
    }

    fn width(&self) -> f64 {
        2.0 / self.count() as f64
    }

    /// Begins with the solution on fewer cells, where there is one.
    fn solve(&self, known: Option<&CellSolution>) -> Result<CellSolution, Error> {
        let (start, carrying) = known.map_or_else(
            || (vec![0.0; self.count()], vec![true; self.count()]),
            |known| {
                let parts = self.count() / known.values.len();
                let repeated = |i: usize| i / parts;
                (
                    (0..self.count()).map(|i| known.values[repeated(i)]).collect(),
                    (0..self.count()).map(|i| known.carrying[repeated(i)]).collect(),
                )
            },
        );
        Ok(self.cells.complementary(&self.right, &self.conditions, &start, &carrying)?)
    }

    /// What the cells tell about the surface between their centres.
    fn surface(&self, solution: &CellSolution) -> Result<Fine, Error> {
        let mut multipliers = solution.multipliers.iter().map(|mu| mu * self.width());
        let total = |f: &dyn Fn(f64) -> f64, values: &[f64]| -> f64 {
            self.width() * self.centres.iter().zip(values).map(|(x, p)| f(*x) * p).sum::<f64>()
        };
        let (force, settlement) = match self.base.load.vertical {
            Vertical::Force(force) => (force, multipliers.next().unwrap_or(0.0)),
            Vertical::Settlement(settlement) => (total(&|_| 1.0, &solution.values), settlement),
        };
        let (moment, tilt) = match self.base.load.rotational {
            Rotational::Moment(moment) => (moment, -multipliers.next().unwrap_or(0.0)),
            Rotational::Eccentricity(e) => (e * force, -multipliers.next().unwrap_or(0.0)),
            Rotational::Tilt(tilt) => (total(&|x| x, &solution.values), tilt),
        };
        // Adding zero turns a negative zero into a plain one.
        let state = State {
            settlement: settlement + 0.0,
            tilt: tilt + 0.0,
            force: force + 0.0,
            moment: moment + 0.0,
        };
        let level = self.cells.restricted(&vec![1.0; self.count()], &solution.carrying)?;
        let tilted = self.cells.restricted(&self.centres, &solution.carrying)?;
        let stiffness = Stiffness {
            force_settlement: total(&|_| 1.0, &level),
            coupling: total(&|x| x, &level),
            moment_tilt: total(&|x| x, &tilted),
        };
        let mut fine = Fine::new(&self.cells, solution.values.clone(), state, stiffness);
        fine.zones = edges::zones(self.base, &fine);
        Ok(fine)
    }
}

/// Places in a cell where two numbers of cells are compared and signs are checked: none where edges were looked for.
const PLACES: [f64; 3] = [0.13, 0.41, 0.83];

fn places(fine: &Fine) -> impl Iterator<Item = f64> + '_ {
    (0..fine.count()).flat_map(move |i| {
        PLACES.into_iter().map(move |share| (i as f64 + share) * fine.width() - 1.0)
    })
}

/// The differences from half as many cells, and that of the edges.
fn estimate(base: &Base<'_>, fine: &Fine, coarse: &Fine) -> (Accuracy, f64) {
    let pressure = places(fine)
        .map(|xi| {
            let height = base.height(xi);
            let [one, other] = [fine, coarse].map(|level| level.pressure_at(xi, height).max(0.0));
            (one - other).abs()
        })
        .fold(0.0, f64::max);
    let edge = (fine.zones.iter())
        .flat_map(|zone| [zone.left(), zone.right()])
        .map(|at| coarse.distance_to_edge(at))
        .fold(0.0, f64::max);
    let (one, other) = (&fine.state, &coarse.state);
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure,
        settlement: (one.settlement - other.settlement).abs(),
        tilt: (one.tilt - other.tilt).abs(),
        force: (one.force - other.force).abs(),
        moment: (one.moment - other.moment).abs(),
    };
    let is_unknown = base.smoothness == Smoothness::Unknown;
    let sizes = one.sizes(fine.largest());
    (if is_unknown { accuracy.of_the_unknown(UNKNOWN, &sizes) } else { accuracy }, edge)
}

/// Tension in the zones and penetration beside them.
fn checked(base: &Base<'_>, fine: &Fine) -> Complementarity {
    let (mut tension, mut penetration) = (0.0f64, 0.0f64);
    for xi in places(fine) {
        let pressure = fine.pressure_at(xi, base.height(xi));
        if fine.touches(xi) {
            tension = tension.max(-pressure);
        } else {
            penetration = penetration.max(pressure);
        }
    }
    let largest = fine.largest().max(f64::MIN_POSITIVE);
    let size = largest + fine.state.settlement.abs() + fine.state.tilt.abs();
    Complementarity { tension: tension / largest, penetration: penetration / size }
}
