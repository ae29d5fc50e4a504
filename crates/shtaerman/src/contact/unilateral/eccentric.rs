//! A settlement prescribed together with an eccentricity: no problem of least energy, and not every pair has a solution.
//!
//! Under a force `P` at the eccentricity `e` there is one contact, with a settlement `delta(P)`. It begins where the base touches first and ends in proportion
//! to the force: upwards while the line of the force is not far from the middle, downwards beyond, since the punch then turns about a point on the other side of
//! it. Between these it need not be monotone. Of the forces with the settlement prescribed the least is taken.

use super::base::Base;
use super::cells::Cells;
use crate::{Error, Load, Rotational, Vertical};

/// Ratio of the forces that are tried, how often, and up to which multiple of the depth over the compliance.
const RATIO: f64 = 4.0;
const DOWN: usize = 18;
const UP: usize = 14;
/// Steps towards a largest settlement between forces, and towards the force sought.
const GOLDEN_STEPS: usize = 24;
const HALVINGS: usize = 30;
/// Rounds of refinement, and doublings of the bracket after each.
const ROUNDS: usize = 12;
const WIDENINGS: usize = 8;

/// Solves on the cells under the least force at `e` with this settlement, and refines them.
///
/// # Errors
/// [`Error::NoContact`] where the base is clear and no force leads there, [`Error::SettlementOutOfReach`] where none does though it is not.
pub(super) fn solve(
    base: &Base<'_>,
    cells: &mut Cells,
    settlement: f64,
    e: f64,
) -> Result<(), Error> {
    let mut curve = Curve { base, cells, e, settlement };
    let mut bracket = curve.bracket()?;
    for _ in 0..ROUNDS {
        let force = curve.force(bracket)?;
        curve.excess(force)?;
        if !curve.cells.refine() {
            break;
        }
        match curve.widened(force)? {
            Some(found) => bracket = found,
            None => break,
        }
    }
    Ok(())
}

/// `delta(P)` on cells.
struct Curve<'c, 'b, 'p> {
    base: &'b Base<'p>,
    cells: &'c mut Cells,
    e: f64,
    settlement: f64,
}

impl Curve<'_, '_, '_> {
    /// `delta(P) - delta`.
    fn excess(&mut self, force: f64) -> Result<f64, Error> {
        let (vertical, rotational) = (Vertical::Force(force), Rotational::Eccentricity(self.e));
        let solution = self.cells.solve(self.base, Load { vertical, rotational })?;
        Ok(solution.multipliers[0] - self.settlement)
    }

    /// The least forces between which the settlement is crossed.
    fn bracket(&mut self) -> Result<[f64; 2], Error> {
        let depth = (self.base.samples.iter())
            .fold(0.0f64, |most, (_, height)| most.max((self.settlement - height).abs()));
        let unit = depth.max(f64::MIN_POSITIVE) / (1.0 + self.base.theta);
        let mut known: Vec<[f64; 2]> = Vec::new();
        for power in 0..DOWN + UP {
            let force = unit * RATIO.powi(power as i32 - DOWN as i32);
            let excess = self.excess(force)?;
            if let Some(&[before, other]) = known.last()
                && (other > 0.0) != (excess > 0.0)
            {
                return Ok([before, force]);
            }
            known.push([force, excess]);
        }
        self.turning(&known)
    }

    /// Looks for a crossing between the forces tried, where the curve comes closest.
    fn turning(&mut self, known: &[[f64; 2]]) -> Result<[f64; 2], Error> {
        let closest = (0..known.len())
            .min_by(|&i, &j| known[i][1].abs().total_cmp(&known[j][1].abs()))
            .unwrap_or(0);
        let ends = [closest.saturating_sub(1), (closest + 1).min(known.len() - 1)];
        let mut logs = ends.map(|i| known[i][0].ln());
        let first = known[ends[0]][0];
        let mut limit = known[closest][1];
        for _ in 0..GOLDEN_STEPS {
            const SECTION: f64 = 0.381_966_011_250_105;
            let width = logs[1] - logs[0];
            let inner = [logs[0] + SECTION * width, logs[1] - SECTION * width];
            let mut values = [0.0; 2];
            for (value, log) in values.iter_mut().zip(inner) {
                *value = self.excess(log.exp())?;
                if (*value > 0.0) != (known[closest][1] > 0.0) {
                    return Ok([first, log.exp()]);
                }
                if value.abs() < limit.abs() {
                    limit = *value;
                }
            }
            if values[0].abs() < values[1].abs() { logs[1] = inner[1] } else { logs[0] = inner[0] }
        }
        Err(self.out_of_reach(limit))
    }

    fn out_of_reach(&self, excess: f64) -> Error {
        if excess > 0.0 || self.base.touches_nowhere() {
            return Error::NoContact;
        }
        let scaling = self.base.problem.frame().scaling();
        let unit = scaling.map_or(1.0, crate::Scaling::displacement);
        Error::SettlementOutOfReach {
            value: self.settlement * unit,
            eccentricity: self.e * self.base.problem.frame().half_width(),
            limit: (self.settlement + excess) * unit,
        }
    }

    /// The force between two by bisection of its logarithm.
    fn force(&mut self, [low, high]: [f64; 2]) -> Result<f64, Error> {
        let (mut low, mut high) = (low.ln(), high.ln());
        let is_above = self.excess(low.exp())? > 0.0;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if (self.excess(middle.exp())? > 0.0) == is_above {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok((0.5 * (low + high)).exp())
    }

    /// Forces around one between which the settlement is crossed on refined cells.
    fn widened(&mut self, force: f64) -> Result<Option<[f64; 2]>, Error> {
        let mut factor = 1.01f64;
        for _ in 0..WIDENINGS {
            let ends = [force / factor, force * factor];
            let signs = [self.excess(ends[0])? > 0.0, self.excess(ends[1])? > 0.0];
            if signs[0] != signs[1] {
                return Ok(Some(ends));
            }
            factor *= factor;
        }
        Ok(None)
    }
}
