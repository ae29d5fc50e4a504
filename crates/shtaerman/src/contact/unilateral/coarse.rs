//! Which parts of the base touch, for any medium and layer: complementarity on cells, a layer that bends by the linear ones that touch it.

use fredholm::complementarity::{Complementarity, Condition};

use super::base::Base;
use super::power::{Extent, reference_pressure};
use super::zones::Zone;
use crate::{Error, Rotational, Vertical};

/// Fewest cells of a zone, parts of a cell that is refined, most rounds of refinement and most cells.
const CELLS_A_ZONE: usize = 6;
const PARTS: usize = 4;
const ROUNDS: usize = 20;
const MOST_CELLS: usize = 1200;
/// Cells shorter than this share of the base are not refined.
const SHORTEST: f64 = 1e-9;
/// Linear layers that follow each other for one that bends, and the change of pressures at which they stop.
const SECANTS: usize = 12;
const CLOSE: f64 = 1e-3;
/// The smallest pressure, as a share of the mean one, at which a layer that bends is made linear.
const FAINT: f64 = 1e-3;
/// Pressures above this share of the largest are linearised by the tangent, others by the secant.
const TANGENT: f64 = 0.05;

/// The zones of contact to about a cell.
pub(super) fn find(base: &Base<'_>, count: usize) -> Result<Vec<Zone>, Error> {
    let mut cells = Cells::new(base, count);
    for _ in 0..ROUNDS {
        let pressures = cells.solve(base)?;
        cells.carrying = pressures.iter().map(|p| *p > 0.0).collect();
        if !cells.refine() {
            break;
        }
    }
    Ok(cells
        .runs()
        .map(|[first, last]| Zone::new(cells.cells[first][0], cells.cells[last][1]))
        .collect())
}

/// The middle of the longest gap of a wave that is one with its images; none where all cells touch.
pub(super) fn gap(base: &Base<'_>, count: usize) -> Result<Option<f64>, Error> {
    let zones = find(base, count)?;
    let (Some(first), Some(last)) = (zones.first(), zones.last()) else { return Ok(None) };
    let mut gaps: Vec<[f64; 2]> =
        zones.windows(2).map(|pair| [pair[0].right(), pair[1].left()]).collect();
    gaps.push([last.right(), first.left() + 2.0]);
    let longest =
        gaps.into_iter().max_by(|one, two| (one[1] - one[0]).total_cmp(&(two[1] - two[0])));
    Ok(longest.filter(|gap| gap[1] - gap[0] > SHORTEST).map(|gap| 0.5 * (gap[0] + gap[1])))
}

/// The mean pressure and the length of the whole base.
pub(super) fn extent(base: &Base<'_>) -> Extent {
    let length = base.pieces.iter().map(|[left, right]| right - left).sum();
    let area = if base.medium.is_disk() { std::f64::consts::PI } else { length };
    Extent { length, area }
}

struct Cells {
    cells: Vec<[f64; 2]>,
    carrying: Vec<bool>,
}

/// The equations on cells, for `z = sqrt(mass) p`.
struct Equations {
    matrix: Vec<f64>,
    roots: Vec<f64>,
    conditions: Vec<Condition>,
    right: Vec<f64>,
    feasible: Vec<f64>,
    theta: f64,
}

impl Cells {
    fn new(base: &Base<'_>, count: usize) -> Self {
        let length: f64 = base.pieces.iter().map(|[left, right]| right - left).sum();
        let mut cells = Vec::new();
        for &[left, right] in &base.pieces {
            let steps = ((count as f64 * (right - left) / length).ceil() as usize).max(8);
            let step = (right - left) / steps as f64;
            let mut cuts: Vec<f64> = (1..steps).map(|i| left + step * i as f64).collect();
            cuts.extend(base.breaks.iter().filter(|at| **at > left && **at < right));
            cuts.sort_by(f64::total_cmp);
            cuts.retain(|at| *at - left > SHORTEST && right - *at > SHORTEST);
            cuts.dedup_by(|one, other| *one - *other < SHORTEST);
            cuts.insert(0, left);
            cuts.push(right);
            cells.extend(cuts.windows(2).map(|pair| [pair[0], pair[1]]));
        }
        let carrying = vec![true; cells.len()];
        Self { cells, carrying }
    }

    fn width(&self, i: usize) -> f64 {
        self.cells[i][1] - self.cells[i][0]
    }

    /// Pressures of the cells.
    fn solve(&self, base: &Base<'_>) -> Result<Vec<f64>, Error> {
        let equations = self.equations(base)?;
        let count = self.cells.len();
        let reference = reference_pressure(base, &extent(base));
        let exponent = base.layer.exponent();
        let mut pressures = vec![reference; count];
        let mut carrying = self.carrying.clone();
        for round in 0..SECANTS {
            let largest = pressures.iter().fold(0.0f64, |most, p| most.max(*p));
            let tangent = |p: f64| round > 0 && p > TANGENT * largest;
            // v = c p + d
            let linearised: Vec<[f64; 2]> = (pressures.iter())
                .map(|&p| {
                    let p = p.max(FAINT * reference);
                    let v = base.layer.displacement(p);
                    if tangent(p) { [exponent * v / p, (1.0 - exponent) * v] } else { [v / p, 0.0] }
                })
                .collect();
            let next = equations.solve(&linearised, &carrying)?;
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

    fn equations(&self, base: &Base<'_>) -> Result<Equations, Error> {
        let (matrix, masses) = base.medium.cells(&self.cells);
        let roots: Vec<f64> = masses.iter().map(|mass| mass.sqrt()).collect();
        let centres: Vec<f64> = self.cells.iter().map(|cell| 0.5 * (cell[0] + cell[1])).collect();
        let weighted = |f: &dyn Fn(f64) -> f64| -> Vec<f64> {
            roots.iter().zip(&centres).map(|(root, x)| root * f(*x)).collect()
        };
        let (ones, lever) = (weighted(&|_| 1.0), weighted(&|x| x));
        let mut right: Vec<f64> =
            (0..roots.len()).map(|i| -roots[i] * self.mean_height(base, i)).collect();
        let mut add = |column: &[f64], by: f64| {
            right.iter_mut().zip(column).for_each(|(value, c)| *value += by * c);
        };
        let mut conditions = Vec::new();
        let area = base.medium.area();
        let force = match base.load.vertical {
            Vertical::Force(value) => {
                let value = value / area;
                conditions.push(Condition { row: ones.clone(), column: ones.clone(), value });
                Some(value)
            }
            Vertical::Settlement(settlement) => {
                add(&ones, settlement);
                None
            }
        };
        match (base.load.rotational, force) {
            (Rotational::Moment(value), _) => {
                conditions.push(Condition { row: lever.clone(), column: lever, value });
            }
            (Rotational::Eccentricity(e), Some(force)) => {
                conditions.push(Condition { row: lever.clone(), column: lever, value: e * force });
            }
            (Rotational::Eccentricity(e), None) => {
                conditions.push(Condition { row: weighted(&|x| x - e), column: lever, value: 0.0 });
            }
            (Rotational::Tilt(tilt), _) => add(&lever, -tilt),
        }
        let feasible = feasible(base, force, &roots, &centres);
        let theta = base.medium.strength() * base.theta;
        Ok(Equations { matrix, roots, conditions, right, feasible, theta })
    }

    /// Simpson's mean of the profile over a cell, from inside it.
    fn mean_height(&self, base: &Base<'_>, i: usize) -> f64 {
        let [left, right] = self.cells[i];
        let (middle, inside) = (0.5 * (left + right), 0.5 * (right - left) * (1.0 - 1e-6));
        let at = |side: f64| base.height(middle + side * inside);
        (at(-1.0) + 4.0 * at(0.0) + at(1.0)) / 6.0
    }

    /// Splits the cells of zones that have few, and their neighbours; whether there were any.
    fn refine(&mut self) -> bool {
        let mut split = vec![false; self.cells.len()];
        for [first, last] in self.runs() {
            if last + 1 - first < CELLS_A_ZONE {
                let from = first.saturating_sub(1);
                let to = (last + 2).min(self.cells.len());
                (from..to)
                    .filter(|&i| self.width(i) > PARTS as f64 * SHORTEST)
                    .for_each(|i| split[i] = true);
            }
        }
        let splits = split.iter().filter(|split| **split).count();
        if splits == 0 || self.cells.len() + (PARTS - 1) * splits > MOST_CELLS {
            return false;
        }
        let (mut cells, mut carrying) = (Vec::new(), Vec::new());
        for (i, is_split) in split.into_iter().enumerate() {
            let [left, right] = self.cells[i];
            let parts = if is_split { PARTS } else { 1 };
            let cut = |part: usize| {
                if part == parts {
                    right
                } else {
                    left + (right - left) * part as f64 / parts as f64
                }
            };
            cells.extend((0..parts).map(|part| [cut(part), cut(part + 1)]));
            carrying.extend(vec![self.carrying[i]; parts]);
        }
        (self.cells, self.carrying) = (cells, carrying);
        true
    }

    /// Runs of neighbours that carry, as first and last index.
    fn runs(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        let mut runs: Vec<[usize; 2]> = Vec::new();
        for i in (0..self.cells.len()).filter(|&i| self.carrying[i]) {
            match runs.last_mut() {
                Some(run) if run[1] + 1 == i && self.cells[run[1]][1] == self.cells[i][0] => {
                    run[1] = i;
                }
                _ => runs.push([i, i]),
            }
        }
        runs.into_iter()
    }
}

impl Equations {
    /// Pressures for the layer `v = c p + d` of each cell.
    fn solve(&self, layer: &[[f64; 2]], carrying: &[bool]) -> Result<Vec<f64>, Error> {
        let count = self.roots.len();
        // y = sqrt(c) z: the layer becomes the unit matrix.
        let scales: Vec<f64> = layer.iter().map(|[c, _]| c.sqrt()).collect();
        let mut matrix = self.matrix.clone();
        for (row, scale) in matrix.chunks_exact_mut(count).zip(&scales) {
            row.iter_mut().zip(&scales).for_each(|(entry, column)| *entry /= scale * column);
        }
        let divided = |values: &[f64]| -> Vec<f64> {
            values.iter().zip(&scales).map(|(value, scale)| value / scale).collect()
        };
        let conditions: Vec<Condition> = (self.conditions.iter())
            .map(|Condition { row, column, value }| Condition {
                row: divided(row),
                column: divided(column),
                value: *value,
            })
            .collect();
        let right: Vec<f64> =
            (0..count).map(|i| (self.right[i] - self.roots[i] * layer[i][1]) / scales[i]).collect();
        let feasible: Vec<f64> =
            self.feasible.iter().zip(&scales).map(|(value, scale)| value * scale).collect();
        let found = Complementarity::new(matrix, self.theta)?.solve(
            &right,
            &conditions,
            carrying,
            &feasible,
        )?;
        Ok((0..count).map(|i| found.values[i] / (scales[i] * self.roots[i])).collect())
    }
}

/// A pressure that is not negative and meets the conditions, times the roots of the masses.
fn feasible(base: &Base<'_>, force: Option<f64>, roots: &[f64], centres: &[f64]) -> Vec<f64> {
    let mut values = vec![0.0; roots.len()];
    match (force, base.load.rotational) {
        (None, Rotational::Moment(moment)) if moment != 0.0 => {
            let cell = if moment > 0.0 { roots.len() - 1 } else { 0 };
            values[cell] = moment / (centres[cell] * roots[cell]);
        }
        (None, _) => {}
        (Some(force), rotational) => {
            let arm = match rotational {
                Rotational::Moment(moment) => moment / force,
                Rotational::Eccentricity(e) => e,
                Rotational::Tilt(_) => {
                    let mass: f64 = roots.iter().map(|root| root * root).sum();
                    centres.iter().zip(roots).map(|(x, root)| x * root * root).sum::<f64>() / mass
                }
            };
            let density = super::cells::balanced(centres, roots, arm);
            let carried: f64 = density.iter().zip(roots).map(|(p, root)| p * root * root).sum();
            for (value, (p, root)) in values.iter_mut().zip(density.iter().zip(roots)) {
                *value = force * p / carried * root;
            }
        }
    }
    values
}
