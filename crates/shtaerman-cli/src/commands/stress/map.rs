//! The map of a component.

use shtaerman::quantity::Measure;
use shtaerman::{Contact, Criterion, Peak, StressField};

use crate::arguments::StressComponent;
use crate::plot::MapPlot;
use crate::report::{Shown, Stresses, heading, infinite_at, said_load, significant};

/// Values beyond this multiple of what all but a hundredth reach are a peak at a corner, which would leave no colours for the rest.
const PEAK: f64 = 1.6;
const SHARE: f64 = 0.01;
/// A place this near to the middle, in depths, is the middle, with the rounding of the search.
pub(in crate::commands) const MIDDLE: f64 = 1e-9;

/// The map of a component over the grid; `peaks` are those of von Mises and Tresca.
pub(in crate::commands) fn plot(
    problem: &str,
    component: StressComponent,
    (contact, field): (&Contact, &StressField),
    grid: &Stresses,
    peaks: &[Peak; 2],
    shown: &Shown,
) -> MapPlot {
    let peaks = &peaks.map(|peak| within(peak, field, grid));
    let values = grid.values(component);
    let largest = |along: &[f64]| along.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let limits = limits(&values);
    let highest = limits.map_or(0.0, |(low, high)| low.abs().max(high.abs()));
    let factor = |largest: f64, measure: Measure| {
        if shown.is_physical { shown.units.axis(largest, measure).factor } else { 1.0 }
    };
    let label = |name: &str, largest: f64, measure: Measure, plain: &str| {
        if shown.is_physical {
            format!("{name} [{}]", shown.units.axis(largest, measure).label)
        } else {
            plain.to_owned()
        }
    };
    let across = largest(&grid.x);
    let (length, stress) = (factor(across, Measure::Length), factor(highest, Measure::Pressure));
    let title = name(component);
    let crosses = crosses(component, field, grid, peaks);
    let is_infinite = !field.infinite_corners().is_empty();
    MapPlot {
        title: titled(problem, &said_load(contact, &shown.units), title),
        notes: notes(component, field, peaks, shown),
        x: grid.x.iter().map(|x| x * length).collect(),
        depth: grid.y.iter().map(|y| y * length).collect(),
        values: values.iter().map(|value| value * stress).collect(),
        limits: limits.map(|(low, high)| (low * stress, high * stress)),
        largest: peak(component, peaks)
            .map(|(peak, share)| share * peak.value * stress)
            .filter(|value| !value.is_nan()),
        zones: zones(field, grid).into_iter().map(|zone| zone.map(|x| x * length)).collect(),
        crosses: crosses.iter().map(|(x, y)| (x * length, y * length)).collect(),
        cross_name: if is_infinite { "infinite" } else { "largest in the body" }.to_owned(),
        position_label: label("x", across, Measure::Length, "ξ = x/a"),
        depth_label: label("depth", across, Measure::Length, "depth / a"),
        value_label: label(title, highest, Measure::Pressure, &format!("{title} / E")),
    }
}

/// What a component is called.
pub(in crate::commands) fn name(component: StressComponent) -> &'static str {
    match component {
        StressComponent::SigmaX => "stress σx",
        StressComponent::SigmaY => "stress σy",
        StressComponent::SigmaZ => "stress σz",
        StressComponent::TauXy => "shear stress τxy",
        StressComponent::Sigma1 => "principal stress σ₁",
        StressComponent::Sigma2 => "principal stress σ₂",
        StressComponent::Sigma3 => "principal stress σ₃",
        StressComponent::MaxShear => "largest shear stress",
        StressComponent::Tresca => "Tresca stress",
        StressComponent::VonMises => "von Mises stress",
    }
}

/// The name of the file, the load and what is drawn.
fn titled(problem: &str, load: &str, what: &str) -> String {
    let what = format!("{what} below the contact");
    match heading(problem) {
        Some(name) => format!("{name}: {load}, {what}"),
        None => format!("{}, {load}", capitalised(&what)),
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    match letters.next() {
        // Mises was a von.
        Some(first) if !text.starts_with("von ") => first.to_uppercase().chain(letters).collect(),
        _ => text.replacen("von", "Von", 1),
    }
}

/// A peak of a periodic pressure, in the period that is shown.
fn within(peak: Peak, field: &StressField, grid: &Stresses) -> Peak {
    let (Some(period), Some(first), Some(last)) = (field.period(), grid.x.first(), grid.x.last())
    else {
        return peak;
    };
    let middle = first.midpoint(*last);
    let periods = ((middle - peak.x) / period).round();
    Peak { x: peak.x + periods * period, ..peak }
}

/// The peak that belongs to a component, with its share of the equivalent stress.
fn peak(component: StressComponent, peaks: &[Peak; 2]) -> Option<(Peak, f64)> {
    match component {
        StressComponent::VonMises => Some((peaks[0], 1.0)),
        StressComponent::Tresca => Some((peaks[1], 1.0)),
        StressComponent::MaxShear => Some((peaks[1], 0.5)),
        _ => None,
    }
}

/// The place of the largest value, where the grid has it; where that is infinite, all places where it is.
fn crosses(
    component: StressComponent,
    field: &StressField,
    grid: &Stresses,
    peaks: &[Peak; 2],
) -> Vec<(f64, f64)> {
    let corners = field.infinite_corners();
    let places = if !corners.is_empty() {
        let (Some(left), Some(right)) = (grid.x.first(), grid.x.last()) else { return Vec::new() };
        let shifts = shifts(field, [*left, *right]);
        let shifted = shifts.iter().flat_map(|shift| corners.iter().map(move |x| x + shift));
        shifted.map(|x| (x, 0.0)).collect()
    } else {
        let Some((peak, _)) = peak(component, peaks) else { return Vec::new() };
        places(component, field, &peak).into_iter().map(|x| (x, peak.depth)).collect::<Vec<_>>()
    };
    let within = |value: f64, along: &[f64]| {
        along.first().is_some_and(|first| *first <= value)
            && along.last().is_some_and(|last| value <= *last)
    };
    places.into_iter().filter(|(x, y)| within(*x, &grid.x) && within(*y, &grid.y)).collect()
}

/// Where the largest value is: at two places below a symmetric pressure that has it beside the middle.
fn places(component: StressComponent, field: &StressField, peak: &Peak) -> Vec<f64> {
    let criterion = match component {
        StressComponent::VonMises => Criterion::VonMises,
        _ => Criterion::Tresca,
    };
    let is_same = |one: f64, other: f64| (one - other).abs() <= field.error();
    let is_near_middle = peak.x.abs() <= MIDDLE * peak.depth;
    let has_twin = if peak.is_corner {
        // The limit at a corner is in proportion to the pressure there.
        is_same(field.pressure(peak.x), field.pressure(-peak.x))
    } else {
        let mirrored = field.stress(-peak.x, peak.depth).map(|stress| criterion.of(&stress));
        mirrored.is_ok_and(|value| is_same(value, peak.value))
    };
    if is_near_middle || !has_twin { vec![peak.x] } else { vec![peak.x, -peak.x] }
}

fn notes(
    component: StressComponent,
    field: &StressField,
    peaks: &[Peak; 2],
    units: &Shown,
) -> Vec<String> {
    let shown = |value: f64, measure: Measure| {
        if value.is_finite() { units.with_digits(value, measure, 4) } else { "infinite".to_owned() }
    };
    let mut note =
        format!("plane strain, tension positive, ν = {}", significant(field.poisson_ratio(), 4));
    let corners = field.infinite_corners();
    if !corners.is_empty() {
        let place = infinite_at(&corners, &|x| shown(x, Measure::Length));
        note.push_str(&format!("; infinite {place}"));
    } else if let Some((peak, share)) = peak(component, peaks) {
        let value = shown(share * peak.value, Measure::Pressure);
        let at: Vec<String> =
            places(component, field, &peak).iter().map(|x| shown(*x, Measure::Length)).collect();
        let x = at.join(" and ");
        let place = if peak.is_corner {
            let edges = if at.len() > 1 { "edges" } else { "edge" };
            format!("at the {edges} x = {x}, as a limit")
        } else {
            format!("at x = {x}, depth {}", shown(peak.depth, Measure::Length))
        };
        note.push_str(&format!("; largest {value} {place}"));
    }
    vec![note]
}

/// The zones within the grid; those of a periodic pressure with their repetitions.
pub(in crate::commands) fn zones(field: &StressField, grid: &Stresses) -> Vec<[f64; 2]> {
    let (Some(left), Some(right)) = (grid.x.first(), grid.x.last()) else { return Vec::new() };
    let (zones, shifts) = (field.zones(), shifts(field, [*left, *right]));
    let repeated =
        shifts.iter().flat_map(|shift| zones.iter().map(move |zone| zone.map(|x| x + shift)));
    repeated.filter(|zone| zone[1] > *left && zone[0] < *right).collect()
}

/// By how much the panels of a periodic pressure are shifted to have all of their repetitions in a range.
fn shifts(field: &StressField, [left, right]: [f64; 2]) -> Vec<f64> {
    const MOST_REPETITIONS: f64 = 200.0;
    let zones = field.zones();
    match field.period() {
        Some(period) if (right - left) / period < MOST_REPETITIONS => {
            let first = ((left - zones.last().map_or(0.0, |zone| zone[1])) / period).floor() as i64;
            let last = ((right - zones.first().map_or(0.0, |zone| zone[0])) / period).ceil() as i64;
            (first..=last).map(|index| index as f64 * period).collect()
        }
        _ => vec![0.0],
    }
}

/// The values to tell apart, without peaks at corners.
pub(in crate::commands) fn limits(values: &[f64]) -> Option<(f64, f64)> {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let (first, last) = (*sorted.first()?, *sorted.last()?);
    let few = (SHARE * sorted.len() as f64) as usize;
    let (low, high) =
        (sorted[few.min(sorted.len() - 1)], sorted[sorted.len() - 1 - few.min(sorted.len() - 1)]);
    let span = high - low;
    let capped = |value: f64, usual: f64| {
        if (value - usual).abs() > (PEAK - 1.0) * span {
            usual + (value - usual).signum() * 0.3 * span
        } else {
            value
        }
    };
    let (low, high) = (capped(first, low), capped(last, high));
    (low < high).then_some((low, high))
}
