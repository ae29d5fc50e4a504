//! Which parts of the base touch, on any ground and layer: complementarity on cells, a layer that bends by the linear ones that touch it.

use fredholm::complementarity::{Complementarity, Condition};

use super::base::Base;
use super::layer::{FAINT, reference_pressure};
use crate::contact::cells::{Cell, Cells, Loaded};
use crate::contact::iteration::STEPS;
use crate::contact::steps::BESIDE;
use crate::contact::zones::Zone;
use crate::{Error, Load, Vertical};

/// The change of pressures, as a share of the largest, at which linear layers that follow each other are the one that bends, and the smallest pressure, as a share of the mean one, at which it is made linear. At half or twice 1 of 32 answers change, within what they state (survey).
const CLOSE: f64 = 1e-3;

/// What cells tell.
#[derive(Debug, Clone, Default)]
pub(super) struct Coarse {
    intervals: Vec<[f64; 2]>,
    ends: Vec<[f64; 2]>,
    pressures: Vec<f64>,
}

impl Coarse {
    /// The intervals of contact to about a cell.
    pub(super) fn intervals(&self) -> &[[f64; 2]] {
        &self.intervals
    }

    /// The same as zones.
    pub(super) fn zones(&self, base: &Base) -> Vec<Zone> {
        self.intervals.iter().map(|ends| base.zone(*ends)).collect()
    }

    /// The middle of the longest gap of a wave that is one with its images; none where all cells touch.
    pub(super) fn gap(&self) -> Option<f64> {
        let [.., last] = self.intervals[..] else { return None };
        let mut before = last[1] - 2.0;
        let gaps = self
            .intervals
            .iter()
            .map(|[left, right]| [std::mem::replace(&mut before, *right), *left]);
        let longest = gaps.max_by(|one, two| (one[1] - one[0]).total_cmp(&(two[1] - two[0])))?;
        (longest[1] - longest[0] > BESIDE).then(|| 0.5 * (longest[0] + longest[1]))
    }

    /// The pressure of the cell of a place; none beside all cells.
    pub(super) fn pressure(&self, xi: f64) -> Option<f64> {
        let cell = self.ends.partition_point(|[_, right]| *right < xi);
        self.ends.get(cell).filter(|[left, _]| *left <= xi).map(|_| self.pressures[cell])
    }
}

/// Zones and pressures to about a cell.
pub(super) fn loaded(base: &Base, count: usize) -> Result<Coarse, Error> {
    let valleys: Vec<f64> = base.valleys().collect();
    let mut cells =
        Cells::of_base(&base.pieces, &valleys, base.load, count, |_| base.breaks.clone());
    let mut found = Coarse::default();
    cells.settle(|cells| {
        found.pressures = pressures(base, cells)?;
        found.ends = cells.cells().iter().map(Cell::ends).collect();
        Ok(found.pressures.clone())
    })?;
    found.intervals = cells.intervals();
    Ok(found)
}

/// Pressures of the cells.
fn pressures(base: &Base, cells: &Cells) -> Result<Vec<f64>, Error> {
    let equations = Equations::new(base, cells);
    let reference = reference_pressure(base, base.pieces.iter().copied());
    let exponent = base.layer.exponent();
    let mut pressures = vec![reference; cells.cells().len()];
    let mut carrying = cells.carrying();
    for round in 0..STEPS {
        let largest = pressures.iter().fold(0.0f64, |most, p| most.max(*p));
        // By the tangent where there is pressure, elsewhere by the secant.
        let tangent = |p: f64| round > 0 && p > FAINT * largest;
        // v = c p + d
        let linearised: Vec<[f64; 2]> = (pressures.iter())
            .map(|&p| {
                let p = p.max(CLOSE * reference);
                let v = base.layer.displacement(p);
                if tangent(p) { [exponent * v / p, (1.0 - exponent) * v] } else { [v / p, 0.0] }
            })
            .collect();
        let next = equations.solve(base, &linearised, &carrying)?;
        carrying = next.iter().map(|p| *p > 0.0).collect();
        let change = (next.iter().zip(&pressures))
            .fold(0.0f64, |most, (one, other)| most.max((one - other).abs()));
        pressures = next;
        if base.layer.is_linear() || change <= CLOSE * largest {
            break;
        }
    }
    Ok(pressures)
}

/// The equations on cells, for `z = sqrt(mass) p`.
struct Equations {
    matrix: Vec<f64>,
    loaded: Loaded,
    theta: f64,
}

impl Equations {
    fn new(base: &Base, cells: &Cells) -> Self {
        let places: Vec<[f64; 2]> = cells.cells().iter().map(Cell::ends).collect();
        let (matrix, masses) = base.ground.cells(&places);
        let roots: Vec<f64> = masses.iter().map(|mass| mass.sqrt()).collect();
        let vertical = match base.load.vertical {
            Vertical::Force(force) => Vertical::Force(force / base.ground.area()),
            Vertical::Settlement(settlement) => Vertical::Settlement(settlement),
        };
        let load = Load { vertical, ..base.load };
        let loaded = Loaded::new(cells, roots, load, 1.0, |xi| base.height(xi));
        Self { matrix, loaded, theta: base.strength() }
    }

    /// Pressures for the layer `v = c p + d` of each cell.
    fn solve(&self, base: &Base, layer: &[[f64; 2]], carrying: &[bool]) -> Result<Vec<f64>, Error> {
        let Loaded { roots, conditions, right, feasible } = &self.loaded;
        let count = roots.len();
        // y = sqrt(c) z: the layer becomes the unit matrix.
        let scales: Vec<f64> = layer.iter().map(|[c, _]| c.sqrt()).collect();
        let mut matrix = self.matrix.clone();
        for (row, scale) in matrix.chunks_exact_mut(count).zip(&scales) {
            row.iter_mut().zip(&scales).for_each(|(entry, column)| *entry /= scale * column);
        }
        let divided = |values: &[f64]| -> Vec<f64> {
            values.iter().zip(&scales).map(|(value, scale)| value / scale).collect()
        };
        let conditions: Vec<Condition> = (conditions.iter())
            .map(|Condition { row, column, value }| Condition {
                row: divided(row),
                column: divided(column),
                value: *value,
            })
            .collect();
        let right: Vec<f64> =
            (0..count).map(|i| (right[i] - roots[i] * layer[i][1]) / scales[i]).collect();
        let feasible: Vec<f64> =
            feasible.iter().zip(&scales).map(|(value, scale)| value * scale).collect();
        let found = Complementarity::new(matrix, self.theta)?.solve_until(
            &|| base.problem().deadline().is_past(),
            &right,
            &conditions,
            carrying,
            &feasible,
        )?;
        Ok((0..count).map(|i| found.values[i] / (scales[i] * roots[i])).collect())
    }
}
