//! A settlement prescribed together with an eccentricity: no problem of least energy, and not every pair has a solution.
//!
//! Under a force `P` at the eccentricity `e` there is one contact, with a settlement `delta(P)`. It begins where the base touches first and ends in proportion
//! to the force: upwards while the line of the force is not far from the middle, downwards beyond, since the punch then turns about a point on the other side of
//! it. Between these it need not be monotone. Of the forces with the settlement prescribed the least is taken. Cells show where to look; where they show no such
//! force, [collocation](super::reach) decides.

use super::base::Base;
use super::zones::Zone;
use super::{reach, topology};
use crate::contact::cells::Cells;
use crate::{Error, Load, Rotational, Vertical};

/// Ratio of the forces that are tried, how often, and up to which multiple of the depth over the compliance.
const RATIO: f64 = 4.0;
const DOWN: usize = 18;
const UP: usize = 14;
/// Steps towards the force sought.
const HALVINGS: usize = 30;
/// Rounds of refinement, and doublings of the bracket after each.
const ROUNDS: usize = 12;
const WIDENINGS: usize = 8;
/// Cells that show about the force.
const FEW_CELLS: usize = 192;

/// The zones under the least force at `e` with this settlement.
///
/// # Errors
/// [`Error::NoContact`] where the base is clear and no force leads there, [`Error::SettlementOutOfReach`] where none does though it is not.
pub(super) fn zones(
    base: &Base<'_>,
    mut cells: Cells,
    settlement: f64,
    e: f64,
) -> Result<Vec<Zone>, Error> {
    let mut curve = Curve { base, cells: &mut cells, e, settlement };
    let samples = curve.samples(true)?;
    let bracket = match samples[..] {
        [.., before, last] if crosses(before, last) => [before[0], last[0]],
        _ => return reach::zones(base, settlement, e, &samples),
    };
    curve.refined(bracket)?;
    Ok(topology::zones(&cells))
}

/// About that force, on cells that are not refined; none where they show none.
pub(super) fn least_force(base: &Base<'_>, settlement: f64, e: f64) -> Result<Option<f64>, Error> {
    let mut cells = topology::cells(base, base.cells().min(FEW_CELLS));
    let mut curve = Curve { base, cells: &mut cells, e, settlement };
    match curve.samples(true)?[..] {
        [.., before, last] if crosses(before, last) => curve.force([before[0], last[0]]).map(Some),
        _ => Ok(None),
    }
}

/// The same without trust in the cells.
pub(super) fn exactly(base: &Base<'_>, settlement: f64, e: f64) -> Result<Vec<Zone>, Error> {
    let mut cells = topology::cells(base, base.cells());
    let samples = Curve { base, cells: &mut cells, e, settlement }.samples(false)?;
    reach::zones(base, settlement, e, &samples)
}

/// Whether the settlement lies between those of two samples.
fn crosses(one: [f64; 2], other: [f64; 2]) -> bool {
    (one[1] > 0.0) != (other[1] > 0.0)
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
        let solution = topology::solve(self.base, self.cells, Load { vertical, rotational })?;
        self.cells.mark(&solution.values);
        Ok(solution.multipliers[0] - self.settlement)
    }

    /// Forces, from small to large, with `delta(P) - delta`: all, or up to the first two between which the settlement lies.
    fn samples(&mut self, until_crossed: bool) -> Result<Vec<[f64; 2]>, Error> {
        let depth = (self.base.samples.iter())
            .fold(0.0f64, |most, (_, height)| most.max((self.settlement - height).abs()));
        let unit = depth.max(f64::MIN_POSITIVE) / (1.0 + self.base.theta);
        let mut samples: Vec<[f64; 2]> = Vec::new();
        for power in 0..DOWN + UP {
            let force = unit * RATIO.powi(power as i32 - DOWN as i32);
            let sample = [force, self.excess(force)?];
            let is_crossed = samples.last().is_some_and(|before| crosses(*before, sample));
            samples.push(sample);
            if until_crossed && is_crossed {
                break;
            }
        }
        Ok(samples)
    }

    /// Solves under the force between two, and refines the cells.
    fn refined(&mut self, mut bracket: [f64; 2]) -> Result<(), Error> {
        for _ in 0..ROUNDS {
            let force = self.force(bracket)?;
            self.excess(force)?;
            if !self.cells.refine() {
                break;
            }
            match self.widened(force)? {
                Some(found) => bracket = found,
                None => break,
            }
        }
        Ok(())
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
