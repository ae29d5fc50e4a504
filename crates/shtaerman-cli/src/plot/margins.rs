//! Ticks that fit, and the room that their labels take beside a frame.

use super::axis::{Axis, Range};
use super::bar_labels::bar_labels;
use super::figure::{Layer, Panel};
use super::layout::{BAR_GAP, BAR_LABEL_GAP, BAR_WIDTH, NUMBER_GAP, TICK_MARK, line_height};
use super::text;
use super::theme::Sizes;
use super::ticks::Ticks;

/// Least room for the part of the last tick label that stands out beyond the frame.
const LAST_LABEL: f64 = 10.0;
/// Names of places take at most this share of the width.
const NAMES: f64 = 0.4;
/// Most ticks of an axis: more are a ruler.
const MOST_TICKS: usize = 9;
/// Room that a tick takes, in sizes of its label.
const ACROSS: f64 = 6.5;
const DOWN: f64 = 3.2;

/// Room for the last tick label, or for a colour bar, in a panel of a width.
pub(super) fn right_margin(panel: &Panel, range: Range, width: f64, sizes: Sizes) -> f64 {
    let along = ticks(&panel.horizontal, range, 0.75 * width, true, sizes);
    let last = along.labelled.last().map_or(0.0, |tick| text::width(&tick.label, sizes.tick));
    let last = (0.5 * last - 0.5 * sizes.rim).max(LAST_LABEL * sizes.scale);
    let bar = panel.layers.iter().find_map(|layer| match layer {
        Layer::ColourBar(bar) => Some(bar_labels(bar).0),
        _ => None,
    });
    bar.map_or(last, |labels| {
        let widest = labels.iter().map(|label| text::width(label, sizes.tick)).fold(12.0, f64::max);
        let gaps = BAR_GAP + BAR_WIDTH + BAR_LABEL_GAP;
        sizes.scale * gaps + NUMBER_GAP + widest + line_height(sizes.label)
    })
}

/// Ticks along a vertical axis in a panel of a width, whose names leave room for the frame.
pub(super) fn ticks_up(
    axis: &Axis,
    range: Range,
    [width, height]: [f64; 2],
    sizes: Sizes,
) -> Ticks {
    let mut ticks = ticks(axis, range, height, false, sizes);
    if !axis.names.is_empty() {
        for tick in &mut ticks.labelled {
            tick.label = text::fit(&text::clean(&tick.label), sizes.tick, NAMES * width);
        }
    }
    ticks
}

pub(super) fn left_margin(axis: &Axis, ticks: &Ticks, sizes: Sizes) -> f64 {
    let labels = ticks.labelled.iter().map(|tick| text::width(&tick.label, sizes.tick));
    let label = if axis.label.is_empty() { 0.0 } else { line_height(sizes.label) };
    label + labels.fold(12.0, f64::max) + sizes.scale * TICK_MARK + 8.0
}

/// As many ticks as fit along a length without their labels touching.
pub(super) fn ticks(
    axis: &Axis,
    range: Range,
    length: f64,
    horizontal: bool,
    sizes: Sizes,
) -> Ticks {
    if !axis.names.is_empty() {
        return Ticks::named(&axis.names);
    }
    let size = f64::from(sizes.tick);
    let spacing = size * if horizontal { ACROSS } else { DOWN };
    let most = ((length / spacing) as usize).clamp(2, MOST_TICKS);
    let extent = |label: &str| {
        if horizontal { text::width(label, sizes.tick) + 0.8 * size } else { 1.25 * size }
    };
    let reach = |index: usize, ticks: &Ticks| {
        let tick = &ticks.labelled[index];
        let (place, half) = (length * range.part(tick.place), 0.5 * extent(&tick.label));
        (place - half, place + half)
    };
    let fits = |ticks: &Ticks| {
        let count = ticks.labelled.len();
        count <= MOST_TICKS
            && (1..count).into_iter().all(|i| reach(i - 1, ticks).1 <= reach(i, ticks).0)
    };
    let mut ticks = Ticks::new(axis.scale, range, most);
    for wanted in (2..most).rev() {
        if fits(&ticks) {
            break;
        }
        ticks = Ticks::new(axis.scale, range, wanted);
    }
    let mut taken = f64::NEG_INFINITY;
    let mut keep = Vec::new();
    for index in 0..ticks.labelled.len() {
        let (from, to) = reach(index, &ticks);
        keep.push(from >= taken);
        taken = if from >= taken { to } else { taken };
    }
    let mut keep = keep.into_iter();
    ticks.labelled.retain(|_| keep.next().unwrap_or(true));
    ticks
}
