//! Labels of a colour bar.

use super::axis::{Range, Scale};
use super::figure::ColourBar;
use super::ticks::Ticks;

/// The levels as on an axis, and their common factor.
pub(super) fn bar_labels(bar: &ColourBar) -> (Vec<String>, String) {
    let (Some(first), Some(last)) = (bar.levels.first(), bar.levels.last()) else {
        return (Vec::new(), String::new());
    };
    let step = if bar.levels.len() > 1 { bar.levels[1] - first } else { first.abs().max(1e-300) };
    let range = Range { low: first - 0.4 * step, high: last + 0.4 * step };
    let ticks = Ticks::new(Scale::Linear, range, bar.levels.len());
    let label = |level: &f64| {
        let near = |place: f64| (place - level).abs() < 1e-6 * step;
        let tick = ticks.labelled.iter().find(|tick| near(tick.place));
        tick.map_or(String::new(), |tick| tick.label.clone())
    };
    (bar.levels.iter().map(label).collect(), ticks.multiplier())
}
