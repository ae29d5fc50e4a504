//! Stresses below the surface for the page.

use serde::Deserialize;
use serde_json::{Value, json};
use shtaerman::quantity::{Dimension, engineering};
use shtaerman::{Criterion, Error, Peak, StressField};

use super::asked::{self, Asked};
use super::contact::Solution;
use crate::Failure;
use crate::arguments::StressComponent;
use crate::commands::stress::{self, Section, Units};
use crate::output::Content;
use crate::plot::{Format, render};
use crate::report::{self, YieldReport, significant};

/// Points of a map that are asked for at most, in each direction.
const MOST: usize = 400;

/// A map, and how fine it is.
#[derive(Debug, Deserialize)]
pub(super) struct AskedMap {
    #[serde(flatten)]
    problem: Asked,
    component: StressComponent,
    /// Points along the surface and in depth.
    points: [usize; 2],
    /// Whether the load at first yield is wanted, too.
    #[serde(default)]
    first_yield: bool,
    /// Poisson's ratio, for a file without dimensions.
    poisson_ratio: Option<f64>,
}

/// The stresses of a contact on the grid of `stress`.
struct Stressed {
    solution: Solution,
    field: StressField,
    peaks: [Peak; 2],
    grid: report::Stresses,
    units: Units,
    ratio: f64,
}

impl Stressed {
    fn new(asked: &AskedMap) -> Result<Self, Failure> {
        let points = asked.points.map(|count| count.clamp(2, MOST));
        let solution = Solution::new(&asked.problem, false)?;
        let problem = solution.file.problem();
        problem.check_stresses().map_err(|error| solution.file.locate(error))?;
        let stated = problem.foundation().poisson_ratio();
        let ratio = stated.or(asked.poisson_ratio).ok_or(Error::NoPoissonRatio)?;
        let field = StressField::new(&solution.contact, Some(ratio))
            .map_err(|error| solution.file.locate(error))?;
        let peaks = [field.peak(Criterion::VonMises), field.peak(Criterion::Tresca)];
        let units = Units::of(problem);
        let grid = Section::usual(points).stresses(&field)?;
        Ok(Self { solution, field, peaks, grid, units, ratio })
    }
}

/// The map as numbers.
pub(super) fn told(asked: &AskedMap) -> Result<Value, Failure> {
    let stressed = Stressed::new(asked)?;
    let Stressed { solution, field, peaks, grid, ratio, .. } = &stressed;
    let problem = solution.file.problem();
    let is_physical = !problem.is_dimensionless();
    let values = grid.values(asked.component);
    let limits = stress::limits(&values);
    let shown = |value: f64, dimension: Dimension| match (value.is_finite(), is_physical) {
        (false, _) => "infinite".to_owned(),
        (true, true) => engineering(value, dimension),
        (true, false) => significant(value, 6),
    };
    let peak = |peak: &Peak, share: f64| {
        let x = shown(peak.x, Dimension::LENGTH);
        let place = match (peak.is_corner, peak.depth == 0.0) {
            (true, _) => format!("at the edge x = {x}, as a limit"),
            (false, true) => format!("at x = {x} on the surface"),
            (false, false) => format!("at x = {x}, {} deep", shown(peak.depth, Dimension::LENGTH)),
        };
        let value = share * peak.value;
        json!({
            "si": value.is_finite().then_some(value),
            "value": shown(value, Dimension::PRESSURE),
            "x": peak.x,
            "depth": peak.depth,
            "place": place,
        })
    };
    let first_yield = match solution.file.yield_stress()?.filter(|_| asked.first_yield) {
        None => Value::Null,
        Some(limit) => first_yield(solution, limit, *ratio)?,
    };
    Ok(json!({
        "name": stress::name(asked.component),
        "x": grid.x,
        "depth": grid.y,
        "values": values,
        "limits": limits.map(|(low, high)| [low, high]),
        "zones": stress::zones(field, grid),
        "von_mises": peak(&peaks[0], 1.0),
        "max_shear": peak(&peaks[1], 0.5),
        "error": field.error(),
        "poisson_ratio": ratio,
        "is_physical": is_physical,
        "first_yield": first_yield,
    }))
}

/// The loads at first yield, or why there are none.
fn first_yield(solution: &Solution, limit: f64, ratio: f64) -> Result<Value, Failure> {
    let mut loads = Vec::new();
    for criterion in [Criterion::VonMises, Criterion::Tresca] {
        match solution.file.problem().first_yield(criterion, limit, Some(ratio)) {
            Ok(load) => loads.push(YieldReport::from(load)),
            Err(error @ Error::NoYield { .. }) => return Ok(json!({ "none": error.to_string() })),
            Err(error) => return Err(solution.file.locate(error).into()),
        }
    }
    let loads = serde_json::to_value(&loads).map_err(asked::unwritable)?;
    Ok(json!({ "yield_stress": limit, "loads": loads }))
}

/// The map as `stress --plot` draws it.
pub(super) fn svg(asked: &AskedMap) -> Result<Value, Failure> {
    let Stressed { field, peaks, grid, units, .. } = Stressed::new(asked)?;
    let plot = stress::plot(asked.component, &field, &grid, &peaks, units);
    let bytes = render(&plot, Format::Svg, plot.size())?;
    Ok(json!({ "text": Content::from(bytes).text()? }))
}
