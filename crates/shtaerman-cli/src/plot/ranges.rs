//! What the axes of panels reach over.

use super::axis::{Axis, Range};
use super::figure::{Arrangement, Figure, Layer, Panel};

/// Horizontal and vertical range of every panel, made equal along the arrangement.
pub(super) fn shared_ranges(figure: &Figure) -> Vec<(Range, Range)> {
    let mut ranges: Vec<_> = figure.panels.iter().map(panel_ranges).collect();
    let all = ranges.iter().copied().reduce(|a, b| (a.0.union(b.0), a.1.union(b.1)));
    let Some(all) = all else { return ranges };
    // Ends that differ on purpose are kept.
    if figure.panels.windows(2).any(|pair| pair[0].horizontal.limits != pair[1].horizontal.limits) {
        return ranges;
    }
    let same = |scale: fn(&Panel) -> super::axis::Scale| {
        figure.panels.windows(2).all(|pair| scale(&pair[0]) == scale(&pair[1]))
    };
    match figure.arrangement {
        Arrangement::Stacked if same(|panel| panel.horizontal.scale) => {
            ranges.iter_mut().for_each(|range| range.0 = all.0);
        }
        Arrangement::SideBySide if same(|panel| panel.vertical.scale) => {
            ranges.iter_mut().for_each(|range| range.1 = all.1);
        }
        _ => {}
    }
    ranges
}

pub(super) fn panel_ranges(panel: &Panel) -> (Range, Range) {
    let (mut x, mut y) = (Vec::new(), Vec::new());
    let window = panel.horizontal.limited();
    let is_seen =
        |across: f64| window.is_none_or(|range| (0.0..=1.0).contains(&range.part(across)));
    for layer in &panel.layers {
        for point in layer_points(layer) {
            let place =
                (panel.horizontal.scale.place(point.0), panel.vertical.scale.place(point.1));
            if let (Some(across), Some(up)) = place
                && is_seen(across)
            {
                x.push(across);
                y.push(up);
            }
        }
    }
    let with = |axis: &Axis, places: Vec<f64>, padding: f64| {
        if let Some(range) = axis.limited() {
            return range;
        }
        let included = axis.include.iter().filter_map(|&value| axis.scale.place(value));
        axis.scale.range(places.into_iter().chain(included), padding)
    };
    // A map fills its frame.
    let is_map = panel.layers.iter().any(|layer| matches!(layer, Layer::Contours(_)));
    let (beside, above) = if is_map { (0.0, 0.0) } else { (0.025, 0.06) };
    (with(&panel.horizontal, x, beside), with(&panel.vertical, y, above))
}

/// The vertical range of a panel made longer, so that heights are drawn by a round factor larger than lengths, and that factor; none where that is no question.
pub(super) fn exaggerated(
    panel: &Panel,
    [horizontal, vertical]: [Range; 2],
    [width, height]: [f64; 2],
) -> Option<(Range, f64)> {
    let is_linear = |axis: &Axis| axis.scale == super::axis::Scale::Linear;
    if !(is_linear(&panel.horizontal) && is_linear(&panel.vertical)) {
        return None;
    }
    let unit = panel.length_of_height.filter(|unit| unit.is_finite() && *unit > 0.0)?;
    // Drawn lengths of one unit of the vertical axis, put upright and laid down.
    let (upright, level) = (
        height / (vertical.high - vertical.low),
        width / (horizontal.high - horizontal.low) * unit,
    );
    let factor = rounded_down(upright / level)?;
    let more = 0.5 * (height / (factor * level) - (vertical.high - vertical.low));
    let range = Range { low: vertical.low - more, high: vertical.high + more };
    (range.low < range.high).then_some((range, factor))
}

/// The largest round number up to a value.
fn rounded_down(value: f64) -> Option<f64> {
    const ROUND: [f64; 10] = [8.0, 6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.5, 1.2, 1.0];
    if !(value.is_finite() && value > 1e-300) {
        return None;
    }
    let decade = value.log10().floor() as i32;
    let candidates = [decade, decade - 1].into_iter().flat_map(|power| {
        ROUND.map(
            |part| if power < 0 { part / 10f64.powi(-power) } else { part * 10f64.powi(power) },
        )
    });
    candidates.into_iter().find(|round| *round <= value * (1.0 + 1e-12) && *round > 0.0)
}

/// The points that the axes must hold.
fn layer_points(layer: &Layer) -> Vec<(f64, f64)> {
    match layer {
        Layer::Line(line) if line.sets_range => line.points.clone(),
        Layer::Band(band) => {
            band.points.iter().flat_map(|&(x, low, high)| [(x, low), (x, high)]).collect()
        }
        Layer::Area(area) => area.points.clone(),
        Layer::Contours(contours) => match (contours.x.as_slice(), contours.y.as_slice()) {
            ([left, .., right], [top, .., bottom]) => vec![(*left, *top), (*right, *bottom)],
            _ => Vec::new(),
        },
        Layer::Line(_)
        | Layer::Mark(_)
        | Layer::ColourBar(_)
        | Layer::Cross(_)
        | Layer::Pole(_) => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_drawn_by_a_round_factor_larger() {
        let mut panel = Panel::new(Axis::linear("x [mm]"), Axis::linear("depth [um]"), Vec::new());
        panel.length_of_height = Some(1e-3);
        let ranges = [Range { low: -5.0, high: 5.0 }, Range { low: 0.0, high: 3.0 }];
        // 70 units for a millimetre; 100 for a micrometre would be 1428.6 times as much.
        let (range, factor) = exaggerated(&panel, ranges, [700.0, 300.0]).unwrap();
        assert_eq!(factor, 1200.0);
        let drawn = 300.0 / (range.high - range.low) / (70.0 * 1e-3);
        assert!((drawn - 1200.0).abs() < 1e-9);
        assert!(range.low <= 0.0 && range.high >= 3.0);
        panel.vertical = Axis::logarithmic("");
        assert_eq!(exaggerated(&panel, ranges, [700.0, 300.0]), None);
        for (value, round) in [(0.037, Some(0.03)), (1.0, Some(1.0)), (f64::NAN, None)] {
            assert_eq!(rounded_down(value), round);
        }
    }
}
