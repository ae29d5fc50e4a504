//! Where stresses are asked for.

use shtaerman::quantity::Dimension;
use shtaerman::{Problem, StressField};

use super::super::places;
use crate::Failure;
use crate::arguments::StressArguments;
use crate::report::Stresses;

/// Points of a grid, if none are asked for, and the most there may be.
const GRID: [usize; 2] = [161, 81];
const MOST_POINTS: usize = 4_000_000;
/// Most places one `--at` may name.
const MOST_PLACES: usize = 100_000;
/// Half the width and the depth of a section, in half-widths of what touches.
const REACH: f64 = 2.0;

/// The dimension of lengths on the command line.
#[derive(Debug, Clone, Copy)]
pub(in crate::commands) struct Units {
    pub(super) is_physical: bool,
}

impl Units {
    pub(in crate::commands) fn of(problem: &Problem) -> Self {
        Self { is_physical: problem.scaling().is_some() }
    }

    fn length(self) -> Dimension {
        if self.is_physical { Dimension::LENGTH } else { Dimension::NONE }
    }
}

/// A rectangle below the surface with a grid.
#[derive(Debug)]
pub(in crate::commands) struct Section {
    points: [usize; 2],
    range: Option<[f64; 2]>,
    depth: Option<f64>,
}

impl Section {
    pub(super) fn parse(arguments: &StressArguments, units: Units) -> Result<Self, Failure> {
        let points = arguments.grid.as_deref().map_or(Ok(GRID), parse_grid)?;
        let range = (arguments.x_range.as_deref())
            .map(|text| places::range("--x-range", text, units.length()))
            .transpose()?;
        let depth = match arguments.depth.as_deref() {
            None => None,
            Some(text) => {
                let depth = quantity("--depth", text, units.length())?;
                if !(depth > 0.0 && depth.is_finite()) {
                    return Err(Failure::Usage(format!(
                        "--depth {text}: must be finite and greater than zero, into the body"
                    )));
                }
                Some(depth)
            }
        };
        Ok(Self { points, range, depth })
    }

    /// The usual rectangle with this number of points.
    pub(in crate::commands) fn usual(points: [usize; 2]) -> Self {
        Self { points, range: None, depth: None }
    }

    /// The stresses on the grid, from the surface down.
    pub(in crate::commands) fn stresses(&self, field: &StressField) -> Result<Stresses, Failure> {
        let zones = field.zones();
        let left = zones.first().map_or(-1.0, |zone| zone[0]);
        let right = zones.last().map_or(1.0, |zone| zone[1]);
        let (middle, half) = (left.midpoint(right), 0.5 * (right - left));
        let reach = field.period().map_or(REACH * half, |period| 0.5 * period);
        let [from, to] = self.range.unwrap_or([middle - reach, middle + reach]);
        let x = even(from, to, self.points[0]);
        let y = even(0.0, self.depth.unwrap_or(REACH * half), self.points[1]);
        let mut stresses = Vec::with_capacity(x.len() * y.len());
        for depth in &y {
            for place in &x {
                stresses.push(field.stress(*place, *depth)?);
            }
        }
        Ok(Stresses { x, y, is_grid: true, stresses })
    }
}

/// Even points, both ends exact.
fn even(from: f64, to: f64, count: usize) -> Vec<f64> {
    let last = (count - 1) as f64;
    (0..count)
        .map(|index| {
            let part = index as f64 / last;
            if index + 1 == count { to } else { from + part * (to - from) }
        })
        .collect()
}

fn parse_grid(text: &str) -> Result<[usize; 2], Failure> {
    let refused = |why: &str| Failure::Usage(format!("--grid {text}: {why}"));
    let parts: Vec<&str> = text.split(['x', 'X', '×']).map(str::trim).collect();
    let [across, down] = parts.as_slice() else {
        return Err(refused("must be two numbers of points, such as 161x81"));
    };
    let count = |part: &str| {
        part.parse::<usize>()
            .ok()
            .filter(|count| *count >= 2)
            .ok_or_else(|| refused("must be two whole numbers from 2 on, such as 161x81"))
    };
    let points = [count(across)?, count(down)?];
    match points[0].checked_mul(points[1]) {
        Some(product) if product <= MOST_POINTS => Ok(points),
        _ => Err(refused(&format!("has too many points: at most {MOST_POINTS} together"))),
    }
}

/// The places `x,y; x,y`.
pub(super) fn parse_places(text: &str, units: Units) -> Result<Vec<[f64; 2]>, Failure> {
    let pairs: Vec<&str> = text.split(';').filter(|pair| !pair.trim().is_empty()).collect();
    if pairs.is_empty() || pairs.len() > MOST_PLACES {
        let count = pairs.len();
        return Err(Failure::Usage(format!(
            "--at names {count} places: from 1 to {MOST_PLACES}, such as \"0,1 mm; 2 mm,1 mm\""
        )));
    }
    let parsed = |pair: &str| {
        let pair = pair.trim();
        let Some((x, y)) = pair.split_once(',') else {
            return Err(Failure::Usage(format!("--at `{pair}`: must be x,y with y the depth")));
        };
        let place = [quantity("--at", x, units.length())?, quantity("--at", y, units.length())?];
        if place.iter().all(|value| value.is_finite()) && place[1] >= 0.0 {
            return Ok(place);
        }
        Err(Failure::Usage(format!(
            "--at `{pair}`: the depth must not be negative: y points into the body"
        )))
    };
    pairs.into_iter().map(parsed).collect()
}

/// A quantity of an option.
pub(super) fn quantity(option: &str, text: &str, dimension: Dimension) -> Result<f64, Failure> {
    let text = text.trim();
    shtaerman::quantity::parse(text)
        .and_then(|quantity| quantity.of(dimension, text))
        .map_err(|error| Failure::Usage(format!("{option} `{text}`: {error}")))
}
