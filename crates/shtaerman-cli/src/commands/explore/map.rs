//! Stresses below the surface for the page.

use serde::Deserialize;
use serde_json::{Value, json};
use shtaerman::quantity::Measure;
use shtaerman::{Criterion, Error, Peak, StressField};

use super::asked::{self, Asked};
use super::contact::{self, Kept, Solution};
use crate::Failure;
use crate::arguments::StressComponent;
use crate::commands::stress::{self, Section, loads_at_yield};
use crate::report::{self, Shown};

/// The error of stresses that serves while something moves, as a share of the mean pressure.
const WHILE_MOVING: f64 = 1e-2;
/// Points of a map that are asked for at most, in each direction.
const MOST: usize = 400;

/// A map of a problem.
#[derive(Debug, Deserialize)]
pub(super) struct AskedMap {
    #[serde(flatten)]
    problem: Asked,
    #[serde(flatten)]
    view: View,
}

/// What a map shows, and how fine it is.
#[derive(Debug, Clone, Deserialize)]
pub(super) struct View {
    component: StressComponent,
    /// Points along the surface and in depth.
    points: [usize; 2],
    /// Whether the largest stresses and the load at first yield are wanted, too, which takes longer than a coarse map.
    #[serde(default)]
    peaks: bool,
    /// Poisson's ratio, for a file without dimensions.
    poisson_ratio: Option<f64>,
}

impl AskedMap {
    pub(super) fn new(problem: Asked, view: View) -> Self {
        Self { problem, view }
    }
}

impl View {
    /// What moves is drawn in bands of colour, of which there are fourteen; what is told in figures is as exact as may be.
    fn accuracy(&self) -> f64 {
        if self.peaks { 0.0 } else { WHILE_MOVING }
    }
}

/// The stresses of a contact, kept for the next question about the same one.
pub(super) struct Stressed {
    problem: Asked,
    ratio: f64,
    /// The error that serves, as a share of the mean pressure.
    accuracy: f64,
    solution: Solution,
    field: StressField,
    peaks: Option<[Peak; 2]>,
}

impl Stressed {
    fn new(solved: &mut Kept, asked: &AskedMap) -> Result<Self, Failure> {
        let file = asked.problem.problem()?;
        file.problem().check_stresses().map_err(|error| file.locate(error))?;
        // What was solved while something moved serves for that alone.
        let fits = |(known, _): &(Asked, Solution)| *known == asked.problem && !asked.view.peaks;
        let solution = match solved.take().filter(fits) {
            Some((_, solution)) => solution,
            None => Solution::of(file, false)?,
        };
        let problem = solution.file.problem();
        let stated = problem.foundation().poisson_ratio();
        let ratio = stated.or(asked.view.poisson_ratio).ok_or(Error::NoPoissonRatio)?;
        let accuracy = asked.view.accuracy();
        let field = StressField::to_accuracy(&solution.contact, Some(ratio), accuracy)
            .map_err(|error| solution.file.locate(error))?;
        Ok(Self { problem: asked.problem.clone(), ratio, accuracy, solution, field, peaks: None })
    }

    /// The one that is known, or a new one.
    fn of<'k>(
        (known, solved): (&'k mut Option<Self>, &mut Kept),
        asked: &AskedMap,
    ) -> Result<&'k mut Self, Failure> {
        let fits = |known: &Self| {
            known.problem == asked.problem
                && known.accuracy <= asked.view.accuracy()
                && asked.view.poisson_ratio.is_none_or(|ratio| ratio == known.ratio)
        };
        let stressed = match known.take().filter(fits) {
            Some(stressed) => stressed,
            None => Self::new(solved, asked)?,
        };
        Ok(known.insert(stressed))
    }

    fn peaks(&mut self) -> [Peak; 2] {
        let field = &self.field;
        let found = || [field.peak(Criterion::VonMises), field.peak(Criterion::Tresca)];
        *self.peaks.get_or_insert_with(found)
    }

    fn grid(&self, asked: &AskedMap) -> Result<report::Stresses, Failure> {
        Section::usual(asked.view.points.map(|count| count.clamp(2, MOST))).stresses(&self.field)
    }
}

/// The map as numbers.
pub(super) fn told(
    known: (&mut Option<Stressed>, &mut Kept),
    asked: &AskedMap,
) -> Result<Value, Failure> {
    let stressed = Stressed::of(known, asked)?;
    let peaks = asked.view.peaks.then(|| stressed.peaks());
    let grid = stressed.grid(asked)?;
    let Stressed { solution, field, ratio, .. } = &*stressed;
    let is_physical = !solution.file.problem().is_dimensionless();
    let values = grid.values(asked.view.component);
    let first_yield = match solution.file.yield_stress()?.filter(|_| asked.view.peaks) {
        None => Value::Null,
        Some(limit) => first_yield(solution, limit, *ratio)?,
    };
    let shown = Shown::of(solution.file.problem(), solution.file.units());
    let peak =
        |index: usize, share: f64| peaks.map(|peaks| peak(&peaks[index], share, field, &shown));
    let highest = stress::limits(&values).map_or(0.0, |(low, high)| low.abs().max(high.abs()));
    Ok(json!({
        "name": stress::name(asked.view.component),
        "x": grid.x,
        "depth": grid.y,
        "values": values,
        "limits": stress::limits(&values).map(|(low, high)| [low, high]),
        "zones": stress::zones(field, &grid),
        "von_mises": peak(0, 1.0),
        "max_shear": peak(1, 0.5),
        "error": field.error(),
        "poisson_ratio": ratio,
        "is_physical": is_physical,
        "units": contact::chosen_units(&shown.units, &grid.x, highest),
        "first_yield": first_yield,
    }))
}

/// A largest stress and its place; of the repetitions of a row the one in the middle.
fn peak(peak: &Peak, share: f64, field: &StressField, shown: &Shown) -> Value {
    let of = |value: f64, measure: Measure| {
        if value.is_finite() { shown.value(value, measure) } else { "infinite".to_owned() }
    };
    let corners = if peak.value.is_finite() { Vec::new() } else { field.infinite_corners() };
    let shift = field.period().map_or(0.0, |period| period * (peak.x / period).round());
    let at = peak.x - shift;
    let at = if at.abs() < stress::MIDDLE * peak.depth { 0.0 } else { at };
    let x = of(at, Measure::Length);
    let place = match (peak.is_corner, peak.depth == 0.0) {
        _ if !corners.is_empty() => report::infinite_at(&corners, &|x| of(x, Measure::Length)),
        (true, _) => format!("at the edge x = {x}, as a limit"),
        (false, true) => format!("at x = {x} on the surface"),
        (false, false) => format!("at x = {x}, {} deep", of(peak.depth, Measure::Length)),
    };
    let value = share * peak.value;
    json!({
        "si": value.is_finite().then_some(value),
        "value": of(value, Measure::Pressure),
        "x": at,
        "depth": peak.depth,
        "place": place,
        "infinite_at": corners,
    })
}

/// The loads at first yield, or why there are none.
fn first_yield(solution: &Solution, limit: f64, ratio: f64) -> Result<Value, Failure> {
    let loads = match loads_at_yield(&solution.file, limit, ratio)? {
        Ok(loads) => serde_json::to_value(&loads).map_err(asked::unwritable)?,
        Err(none) => return Ok(json!({ "none": none })),
    };
    Ok(json!({ "yield_stress": limit, "loads": loads }))
}

/// The map as `stress --plot` draws it.
pub(super) fn svg(
    known: (&mut Option<Stressed>, &mut Kept),
    asked: &AskedMap,
) -> Result<Value, Failure> {
    let stressed = Stressed::of(known, asked)?;
    let (peaks, grid) = (stressed.peaks(), stressed.grid(asked)?);
    let file = &stressed.solution.file;
    let shown = Shown::of(file.problem(), file.units());
    let name = asked.problem.stem();
    let solved = (&stressed.solution.contact, &stressed.field);
    let plot = stress::plot(name, asked.view.component, solved, &grid, &peaks, &shown);
    Ok(json!({ "text": contact::drawn(&plot)? }))
}
