//! The zones of contact: where the pressure of the last zones, continued by the equation, is positive.

use crate::grid::{Break, Fineness, Grid, panels};
use crate::problem::{Problem, Refusal};
use crate::rough::{Solved, solve};

/// Most unknowns.
const MOST_UNKNOWNS: usize = 4000;
/// Most changes of the zones at one fineness.
const MOST_CHANGES: usize = 40;
/// Zones and gaps narrower than that are none.
const NARROWEST: f64 = 1e-13;

/// Solves on zones, and again on those that come out, until they stay to the accuracy of the ends asked for.
pub(crate) fn settle(
    problem: &Problem<'_>,
    start: &[[f64; 2]],
    fineness: Fineness,
    settled: f64,
) -> Result<(Solved, Vec<[f64; 2]>), Refusal> {
    let mut zones = start.to_vec();
    let mut is_last = false;
    for _ in 0..MOST_CHANGES {
        let solved = solve_on(problem, &zones, fineness)?;
        if problem.is_bilateral {
            return Ok((solved, zones));
        }
        let next = positive(problem, &solved, &zones, settled)?;
        let moved = moved(&zones, &next);
        if is_last && moved <= settled.sqrt() || moved <= settled {
            return Ok((solved, zones));
        }
        // Newton's method: what is left is the square of the last change.
        is_last = moved <= settled.sqrt();
        zones = next;
    }
    Err(Refusal::ZonesNotFound)
}

/// The solution on zones.
fn solve_on(
    problem: &Problem<'_>,
    zones: &[[f64; 2]],
    fineness: Fineness,
) -> Result<Solved, Refusal> {
    let height = |x: f64| problem.height(x);
    let cut = panels(&problem.kernel, problem.theta, zones, problem.breaks, &height, fineness);
    let grid = Grid::new(cut, fineness.nodes);
    if grid.len() > MOST_UNKNOWNS {
        return Err(Refusal::TooLarge { unknowns: grid.len(), most: MOST_UNKNOWNS });
    }
    solve(problem, grid)
}

/// How far ends have moved; infinite where zones have come or gone.
fn moved(before: &[[f64; 2]], after: &[[f64; 2]]) -> f64 {
    if before.len() != after.len() {
        return f64::INFINITY;
    }
    let pairs = before.iter().flatten().zip(after.iter().flatten());
    pairs.fold(0.0f64, |most, (one, two)| most.max((one - two).abs()))
}

/// Places that are dense where anything changes: nodes of panels on the whole base, graded to the ends of zones as well.
pub(crate) fn places(problem: &Problem<'_>, zones: &[[f64; 2]], nodes: usize) -> Vec<f64> {
    let mut breaks = problem.breaks.to_vec();
    breaks.extend(zones.iter().flatten().map(|at| Break { at: *at, is_sharp: true }));
    breaks.sort_by(|one, two| one.at.total_cmp(&two.at));
    let height = |x: f64| problem.height(x);
    let fineness = Fineness { nodes, shortest: 1e-5, resolved: 1e-4 };
    let cut = panels(&problem.kernel, problem.theta, problem.pieces, &breaks, &height, fineness);
    let mut places: Vec<f64> =
        Grid::new(cut, nodes).nodes().iter().map(|(place, _)| place.x()).collect();
    places.extend(problem.pieces.iter().flatten());
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

/// Where the base is in contact by the equation: between roots of `delta - alpha x - f - theta K p`.
fn positive(
    problem: &Problem<'_>,
    solved: &Solved,
    zones: &[[f64; 2]],
    settled: f64,
) -> Result<Vec<[f64; 2]>, Refusal> {
    let places = places(problem, zones, 6);
    let mut found: Vec<[f64; 2]> = vec![];
    for piece in problem.pieces {
        let inside: Vec<(f64, f64)> = (places.iter())
            .filter(|x| piece[0] <= **x && **x <= piece[1])
            .map(|x| (*x, solved.layer(problem, *x)))
            .collect();
        let mut open = None;
        for (i, (x, v)) in inside.iter().enumerate() {
            let root = |other: (f64, f64)| {
                if i == 0 { *x } else { crossing(problem, solved, other, (*x, *v), settled) }
            };
            let before = inside[i.saturating_sub(1)];
            match (open, *v > 0.0) {
                (None, true) => open = Some(root(before)),
                (Some(left), false) => {
                    found.push([left, root(before)]);
                    open = None;
                }
                _ => {}
            }
        }
        if let Some(left) = open {
            found.push([left, piece[1]]);
        }
    }
    found.retain(|[left, right]| right - left > NARROWEST);
    let mut joined: Vec<[f64; 2]> = vec![];
    for zone in found {
        match joined.last_mut() {
            Some(last)
                if zone[0] - last[1] < NARROWEST
                    && !problem.pieces.iter().any(|piece| piece[0] == zone[0]) =>
            {
                last[1] = zone[1]
            }
            _ => joined.push(zone),
        }
    }
    if joined.is_empty() { Err(Refusal::NoContact) } else { Ok(joined) }
}

/// The place between two, on one of which it is positive, where `v` changes its sign: by bisection and secants in turn.
fn crossing(
    problem: &Problem<'_>,
    solved: &Solved,
    mut one: (f64, f64),
    mut two: (f64, f64),
    settled: f64,
) -> f64 {
    let least = (1e-3 * settled).max(2.0 * f64::EPSILON * one.0.abs().max(two.0.abs()));
    for step in 0..120 {
        if two.0 - one.0 <= least {
            break;
        }
        let secant = one.0 - one.1 * (two.0 - one.0) / (two.1 - one.1);
        // A step beyond the root by the accuracy asked for closes the bracket.
        let beyond = if step % 3 == 0 { -least } else { least };
        let middle = 0.5 * (one.0 + two.0);
        let tried =
            if step % 3 == 2 || !secant.is_finite() { middle } else { secant + 0.5 * beyond };
        let tried = if one.0 < tried && tried < two.0 { tried } else { middle };
        let v = solved.layer(problem, tried);
        if (v > 0.0) == (one.1 > 0.0) { one = (tried, v) } else { two = (tried, v) }
    }
    if one.1 > 0.0 { one.0 } else { two.0 }
}
