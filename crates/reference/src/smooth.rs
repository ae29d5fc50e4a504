//! The equation of a smooth surface, of the first kind: densities in angles, free ends by Newton's method.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::grid::{Cutter, Fineness, Grid};
use crate::kernel::Kernel;
use crate::panel::{BESIDE, Chart, Panel};
use crate::problem::{Layer, Problem, Refusal, Rotational, Vertical};
use crate::rough::{Solved, solve_dense};
use crate::zones;

/// Most unknowns: free ends are searched by solving many times.
const MOST_UNKNOWNS: usize = 1600;
/// The rough layer that leads to the zones, against `theta`.
const COMPANION: f64 = 0.01;
const SEARCH: Fineness = Fineness { nodes: 6, shortest: 1e-1, resolved: 1e-3 };
/// Where free ends are found first; other grids start from there, with the slopes of this.
const QUICK: Fineness = Fineness { nodes: 10, shortest: 1e-2, resolved: 1e-8 };
/// Most steps of Newton's method, and most exchanges of free ends and walls.
const MOST_STEPS: usize = 24;
const MOST_EXCHANGES: usize = 6;
/// Steps of the ends relative to their zone, for differences.
const STEP: f64 = 1e-5;
/// Ends this close to one of the base or to a break are held there.
const AT_WALL: f64 = 1e-9;

/// A zone with what is known of its ends: the axis of a disk is no end.
#[derive(Debug, Clone, Copy)]
struct Zone {
    ends: [f64; 2],
    is_free: [bool; 2],
}

/// A solution with its zones.
type Settled = (Solved, Vec<[f64; 2]>);
/// A solution with the number of the first panel of each zone.
type Started = (Solved, Vec<usize>);

/// Two solutions with their zones, of the finenesses given.
pub(crate) fn settle(
    problem: &Problem<'_>,
    start: Option<&[[f64; 2]]>,
    [coarse, fine]: [Fineness; 2],
) -> Result<[Settled; 2], Refusal> {
    let start = match start {
        Some(zones) => zones.to_vec(),
        None if problem.is_bilateral => problem.pieces.to_vec(),
        None => companion(problem)?,
    };
    let mut zones: Vec<Zone> =
        joined(problem, &start).into_iter().map(|ends| zone(problem, ends)).collect();
    for _ in 0..MOST_EXCHANGES {
        let mut slopes = None;
        // On graded ground intensities need fine panels.
        let quick = if problem.kernel.exponent() > 0.0 { coarse } else { QUICK };
        let quick = newton(problem, &mut zones, quick, &mut slopes)?;
        if !exchange(problem, &mut zones, &quick) {
            let ends = |zones: &[Zone]| zones.iter().map(|zone| zone.ends).collect::<Vec<_>>();
            let first = newton(problem, &mut zones, coarse, &mut slopes)?;
            let before = ends(&zones);
            let second = newton(problem, &mut zones, fine, &mut slopes)?;
            return Ok([(first, before), (second, ends(&zones))]);
        }
    }
    Err(Refusal::ZonesNotFound)
}

/// A place of the base in the panels of a solution.
pub(crate) struct Found<'a> {
    /// The number of its panel.
    pub(crate) index: usize,
    solved: &'a Solved,
    /// The place in the panel, in `[-1, 1]`.
    t: f64,
    /// `ds/du` there.
    pub(crate) rate: f64,
}

impl Found<'_> {
    /// The pressure.
    pub(crate) fn pressure(&self) -> f64 {
        let n = self.solved.grid.rule.nodes.len();
        let values = &self.solved.pressures[n * self.index..n * (self.index + 1)];
        value(self.solved, values, self.t) / self.rate
    }
}

/// The pressure at a place, 0 outside of the zones.
pub(crate) fn pressure(problem: &Problem<'_>, solved: &Solved, x: f64) -> f64 {
    find(problem, solved, x).map_or(0.0, |found| found.pressure())
}

/// The panel of a place of the base.
pub(crate) fn find<'a>(problem: &Problem<'_>, solved: &'a Solved, x: f64) -> Option<Found<'a>> {
    for x in [x, x + shift(problem)] {
        let mut known = (Chart::Line, x);
        for (index, panel) in solved.grid.panels.iter().enumerate() {
            let is_there = match panel.chart {
                Chart::Line => true,
                Chart::Angle { centre, half } => (x - centre).abs() <= half,
            };
            if !is_there {
                continue;
            }
            if known.0 != panel.chart {
                known = (panel.chart, panel.chart.variable(x));
            }
            let u = known.1;
            let t = ((u - panel.anchor - panel.from) - (panel.to - (u - panel.anchor)))
                / (2.0 * panel.half());
            if t.abs() <= 1.0 {
                return Some(Found { index, solved, t, rate: panel.chart.rate(u) });
            }
        }
    }
    None
}

/// How far two solutions differ on each panel of the second, in the density with respect to its variable, at places all over the panel: at one they may meet by chance, at all of them not.
pub(crate) fn differences(problem: &Problem<'_>, first: &Solved, second: &Solved) -> Vec<f64> {
    let of_panel = |panel: &Panel| {
        BESIDE.iter().fold(0.0f64, |most, t| {
            let place = panel.at(*t);
            // Beside an end x has lost digits of the angle, for both alike.
            let [one, two] = [first, second].map(|solved| pressure(problem, solved, place.x()));
            let difference = (one - two).abs() * panel.chart.rate(place.u());
            if difference.is_finite() { most.max(difference) } else { most }
        })
    };
    second.grid.panels.iter().map(of_panel).collect()
}

fn value(solved: &Solved, values: &[f64], t: f64) -> f64 {
    let mut cardinals = vec![0.0; values.len()];
    solved.grid.rule.cardinals(t, &mut cardinals);
    cardinals.iter().zip(values).map(|(c, v)| c * v).sum()
}

/// The period of a wave, whose zone may reach over the seam; else 0.
fn shift(problem: &Problem<'_>) -> f64 {
    match problem.kernel {
        Kernel::Row { period } if period <= 2.0 => period,
        _ => 0.0,
    }
}

/// The zones of the same problem with a thin rough layer.
fn companion(problem: &Problem<'_>) -> Result<Vec<[f64; 2]>, Refusal> {
    let layer = COMPANION * problem.theta;
    let base = |x: f64| (problem.base)(x) / layer;
    let rough = Problem {
        theta: problem.theta / layer,
        layer: Layer::Linear,
        vertical: match problem.vertical {
            Vertical::Settlement(settlement) => Vertical::Settlement(settlement / layer),
            force @ Vertical::Force(_) => force,
        },
        rotational: match problem.rotational {
            Rotational::Tilt(tilt) => Rotational::Tilt(tilt / layer),
            moment => moment,
        },
        base: &base,
        ..*problem
    };
    Ok(zones::settle(&rough, problem.pieces, SEARCH, 1e-4)?.1)
}

/// The zones of a wave beside the seam are one.
fn joined(problem: &Problem<'_>, zones: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut zones = zones.to_vec();
    let period = shift(problem);
    if period > 0.0 && zones.len() > 1 && zones[0][0] == -1.0 && zones[zones.len() - 1][1] == 1.0 {
        let first = zones.remove(0);
        if let Some(last) = zones.last_mut() {
            last[1] = first[1] + period;
        }
    }
    zones
}

/// Ends at ends of the base or at its breaks are walls.
fn zone(problem: &Problem<'_>, ends: [f64; 2]) -> Zone {
    let is_wave = shift(problem) > 0.0;
    let pieces = problem.pieces.iter().flatten().filter(|_| !is_wave);
    let breaks = problem.breaks.iter().filter(|cut| cut.is_sharp).map(|cut| &cut.at);
    let walls: Vec<f64> = pieces.chain(breaks).copied().collect();
    let mut found = Zone { ends, is_free: [true; 2] };
    for (end, is_free) in found.ends.iter_mut().zip(&mut found.is_free) {
        if let Some(wall) = walls.iter().find(|wall| (**wall - *end).abs() < AT_WALL) {
            (*end, *is_free) = (*wall, false);
        }
    }
    found
}

impl Zone {
    /// A wave in full contact has no ends.
    fn is_round(&self, problem: &Problem<'_>) -> bool {
        let period = shift(problem);
        period > 0.0 && self.ends[1] - self.ends[0] >= period
    }

    fn is_on_axis(&self, problem: &Problem<'_>) -> bool {
        matches!(problem.kernel, Kernel::Disk { .. }) && self.ends[0] == 0.0
    }

    fn chart(&self, problem: &Problem<'_>) -> Chart {
        let [left, right] = self.ends;
        if self.is_round(problem) {
            Chart::Line
        } else if self.is_on_axis(problem) {
            Chart::Angle { centre: 0.0, half: right }
        } else {
            Chart::Angle { centre: 0.5 * (left + right), half: 0.5 * (right - left) }
        }
    }

    /// Whether an end is one, and free.
    fn moves(&self, problem: &Problem<'_>, side: usize) -> bool {
        self.is_free[side] && !self.is_round(problem) && !(side == 0 && self.is_on_axis(problem))
    }
}

/// The solution on given zones, with the number of the first panel of each.
fn solve_on(
    problem: &Problem<'_>,
    zones: &[Zone],
    fineness: Fineness,
) -> Result<(Solved, Vec<usize>), Refusal> {
    let period = shift(problem);
    let height = |x: f64| {
        if x > 1.0 && period > 0.0 { problem.height(x - period) } else { problem.height(x) }
    };
    let ends: Vec<[f64; 2]> = zones.iter().map(|zone| zone.ends).collect();
    let mut cutter = Cutter::new(&ends, &height, fineness);
    let mut starts = vec![];
    for zone in zones {
        starts.push(cutter.found.len());
        cutter.cut(zone.chart(problem), &zone.cuts(problem, fineness));
    }
    let grid = Grid::new(cutter.found, fineness.nodes);
    let n = grid.len();
    if n > MOST_UNKNOWNS {
        return Err(Refusal::TooLarge { unknowns: n, most: MOST_UNKNOWNS });
    }
    let nodes = grid.nodes();
    let rows: Vec<Vec<f64>> =
        nodes.iter().map(|(place, _)| grid.row(&problem.kernel, *place)).collect();
    let lifts: Vec<[f64; 2]> =
        nodes.iter().map(|(place, _)| problem.kernel.lifts(place.x())).collect();
    let balances = problem.balances(&nodes);
    let entry = |i: usize, j: usize| match (i < n, j < n) {
        (true, true) => problem.theta * rows[i][j],
        (true, false) if j == n => -lifts[i][0],
        (true, false) => lifts[i][1],
        (false, true) => balances[i - n].as_ref().map_or(0.0, |(weights, _)| weights[j]),
        (false, false) => f64::from(u8::from(i == j && balances[i - n].is_none())),
    };
    let mut right: Vec<f64> = nodes.iter().map(|(place, _)| -height(place.x())).collect();
    for (balance, given) in balances.iter().zip(problem.given()) {
        right.push(balance.as_ref().map_or(given, |(_, total)| *total));
    }
    let found = solve_dense(n + 2, entry, &right)?;
    let pressures = found[..n].to_vec();
    Ok((Solved { grid, pressures, settlement: found[n], tilt: found[n + 1] }, starts))
}

impl Zone {
    /// Where panels of the zone end, in the variable of its chart.
    fn cuts(&self, problem: &Problem<'_>, fineness: Fineness) -> Vec<(f64, Option<f64>)> {
        let chart = self.chart(problem);
        let [left, right] = self.ends;
        let range = if self.is_round(problem) {
            [left, right]
        } else if self.is_on_axis(problem) {
            [FRAC_PI_2, PI]
        } else {
            [0.0, PI]
        };
        // The density is smooth in the angle at ends, but for the power sin^mu of graded ground and what neighbours do.
        let at_ends = if problem.kernel.exponent() > 0.0 { 10.0 * fineness.shortest } else { 0.02 };
        let at_breaks = fineness.shortest;
        let mut places: Vec<(f64, bool)> =
            problem.breaks.iter().map(|cut| (cut.at, cut.is_sharp)).collect();
        let period = shift(problem);
        if period > 0.0 {
            let seam = (1.0, true);
            let beyond: Vec<(f64, bool)> =
                places.iter().map(|(at, is_sharp)| (at + period, *is_sharp)).collect();
            places.push(seam);
            places.extend(beyond);
        }
        places.retain(|(at, _)| left + AT_WALL < *at && *at < right - AT_WALL);
        places.sort_by(|one, two| one.0.total_cmp(&two.0));
        // The seam of a wave is no end.
        let last = (!self.is_round(problem)).then_some(at_ends);
        let first = if self.is_on_axis(problem) {
            // Next to the axis there is too little of the disk to tell its pressure.
            problem.breaks.iter().any(|cut| cut.at == 0.0).then_some(1e-4)
        } else {
            last
        };
        let mut cuts = vec![(range[0], first)];
        cuts.extend(
            places
                .into_iter()
                .map(|(at, is_sharp)| (chart.variable(at), is_sharp.then_some(at_breaks))),
        );
        cuts.push((range[1], last));
        cuts
    }
}

/// The intensities at the ends that are free or may become so, zone by zone.
fn intensities(problem: &Problem<'_>, solved: &Solved, starts: &[usize]) -> Vec<[f64; 2]> {
    let n = solved.grid.rule.nodes.len();
    let at = |panel: usize, t: f64| {
        let values = &solved.pressures[panel * n..(panel + 1) * n];
        let place = solved.grid.panels[panel].at(t);
        // sin^mu
        let taper = place.chart.rate(place.u()).abs().powf(problem.kernel.exponent());
        value(solved, values, t) / taper
    };
    let count = solved.grid.panels.len();
    let inset = if problem.kernel.exponent() > 0.0 { 3 } else { 0 };
    (0..starts.len())
        .map(|j| {
            let last = starts.get(j + 1).copied().unwrap_or(count) - 1;
            [
                at((starts[j] + inset).min(last), -1.0),
                at(last.saturating_sub(inset).max(starts[j]), 1.0),
            ]
        })
        .collect()
}

/// Moves free ends until the intensities there vanish; slopes that are known serve as long as they bring the ends nearer.
fn newton(
    problem: &Problem<'_>,
    zones: &mut [Zone],
    fineness: Fineness,
    slopes: &mut Option<Vec<Vec<f64>>>,
) -> Result<Solved, Refusal> {
    let mut last = f64::INFINITY;
    for step in 0..MOST_STEPS {
        let moving: Vec<(usize, usize)> = (0..zones.len())
            .flat_map(|j| [(j, 0), (j, 1)])
            .filter(|(j, side)| zones[*j].moves(problem, *side))
            .collect();
        let (solved, starts) = solve_on(problem, zones, fineness)?;
        if moving.is_empty() {
            return Ok(solved);
        }
        let values = |(solved, starts): &(Solved, Vec<usize>)| -> Vec<f64> {
            let all = intensities(problem, solved, starts);
            moving.iter().map(|(j, side)| all[*j][*side]).collect()
        };
        let left = values(&(solved, starts));
        let columns = match slopes.take().filter(|known| known.len() == moving.len()) {
            Some(known) if step == 0 || last < 1e-3 => known,
            _ => columns(problem, zones, fineness, &moving, &|other| {
                values(other).iter().zip(&left).map(|(a, b)| a - b).collect()
            })?,
        };
        let change = solve_dense(moving.len(), |i, k| columns[k][i], &left)?;
        *slopes = Some(columns);
        let widths = zones.iter().map(|zone| zone.ends[1] - zone.ends[0]);
        let width = widths.fold(f64::INFINITY, f64::min);
        let largest = change.iter().fold(0.0f64, |most, c| most.max(c.abs()));
        let damping = (0.25 * width / largest).min(1.0);
        for ((j, side), change) in moving.iter().zip(&change) {
            zones[*j].ends[*side] -= damping * change;
        }
        hold(problem, zones);
        let now = largest / width;
        let is_stuck = step > 2 && now < 1e-8 && now > 0.3 * last;
        if now < 1e-14 || is_stuck {
            return Ok(solve_on(problem, zones, fineness)?.0);
        }
        last = now;
    }
    Err(Refusal::ZonesNotFound)
}

/// What the intensities change by as each end moves.
fn columns(
    problem: &Problem<'_>,
    zones: &[Zone],
    fineness: Fineness,
    moving: &[(usize, usize)],
    change: &dyn Fn(&Started) -> Vec<f64>,
) -> Result<Vec<Vec<f64>>, Refusal> {
    let column = |(j, side): &(usize, usize)| {
        let mut tried = zones.to_vec();
        let [l, r] = tried[*j].ends;
        let by = STEP * (r - l) * if *side == 0 { 1.0 } else { -1.0 };
        tried[*j].ends[*side] += by;
        let moved = change(&solve_on(problem, &tried, fineness)?);
        Ok(moved.into_iter().map(|value| value / by).collect())
    };
    moving.iter().map(column).collect()
}

/// Ends that went beyond their piece are walls.
fn hold(problem: &Problem<'_>, zones: &mut [Zone]) {
    if shift(problem) > 0.0 {
        return;
    }
    for zone in zones {
        let middle = 0.5 * (zone.ends[0] + zone.ends[1]);
        let Some(piece) =
            problem.pieces.iter().find(|piece| piece[0] <= middle && middle <= piece[1])
        else {
            continue;
        };
        if zone.ends[0] < piece[0] {
            (zone.ends[0], zone.is_free[0]) = (piece[0], false);
        }
        if zone.ends[1] > piece[1] {
            (zone.ends[1], zone.is_free[1]) = (piece[1], false);
        }
    }
}

/// Sets walls free where the base would pull; whether there was one.
fn exchange(problem: &Problem<'_>, zones: &mut [Zone], solved: &Solved) -> bool {
    if problem.is_bilateral {
        return false;
    }
    let mut starts = vec![];
    for (i, panel) in solved.grid.panels.iter().enumerate() {
        if i == 0 || panel.chart != solved.grid.panels[i - 1].chart {
            starts.push(i);
        }
    }
    let all = intensities(problem, solved, &starts);
    let size = solved.pressures.iter().fold(0.0f64, |most, p| most.max(p.abs()));
    let mut is_changed = false;
    for (zone, values) in zones.iter_mut().zip(all) {
        let width = zone.ends[1] - zone.ends[0];
        for side in [0, 1] {
            let is_axis = side == 0 && zone.is_on_axis(problem);
            if !zone.is_free[side]
                && !is_axis
                && !zone.is_round(problem)
                && values[side] < -1e-9 * size
            {
                zone.is_free[side] = true;
                zone.ends[side] += 1e-2 * width * if side == 0 { 1.0 } else { -1.0 };
                is_changed = true;
            }
        }
    }
    is_changed
}
