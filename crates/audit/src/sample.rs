//! The density on single panels.

use crate::legendre::{ORDER, RULE, evaluate_at};
use crate::panel::Panel;
use crate::residual::blur;

/// Panels are not cut below this many units of the machine, and below `COARSE` times that where the density changes as much from number to number.
pub(crate) const FINEST: f64 = 64.0 * f64::EPSILON;
pub(crate) const COARSE: f64 = 1e6;
/// Panels shorter than this share of their distance from the origin have nodes that are rounded noticeably; so many corrections take that away.
const ROUNDED: f64 = 1e-6;
const CORRECTIONS: usize = 3;

/// A panel and its tail.
pub(crate) type Sampled = (Panel, f64);

pub(crate) fn sampled(density: &dyn Fn(f64) -> f64, left: f64, right: f64) -> Sampled {
    sampled_at(&|places: &[f64; ORDER]| places.map(density), left, right)
}

/// The same of what gives its values at all nodes together.
fn sampled_at(density: &dyn Fn(&[f64; ORDER]) -> [f64; ORDER], left: f64, right: f64) -> Sampled {
    let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
    let nodes = RULE.nodes.map(|t| (middle + half * t).clamp(left, right));
    let values = density(&nodes);
    let places = nodes.map(|x| ((x - left) - (right - x)) / (right - left));
    let mut coefficients = RULE.expand(&values);
    // Places are rounded: on short panels that matters where the density is steep. The polynomial is to have the values where they were taken.
    if half < ROUNDED * middle.abs() {
        for _ in 0..CORRECTIONS {
            let mut missed = values;
            for (value, given) in missed.iter_mut().zip(evaluate_at(&coefficients, &places)) {
                *value -= given;
            }
            let change = RULE.expand(&missed);
            coefficients.iter_mut().zip(change).for_each(|(c, change)| *c += change);
        }
    }
    let panel = Panel::new(left, right, coefficients);
    let tail = panel.tail();
    (panel, tail)
}

/// A panel as two, sampled anew; the panel itself where it is too short for that.
pub(crate) fn halves(density: &dyn Fn(f64) -> f64, panel: &Panel) -> Vec<Panel> {
    let middle = panel.middle();
    if panel.right - panel.left <= FINEST * middle.abs() {
        return vec![panel.clone()];
    }
    [[panel.left, middle], [middle, panel.right]]
        .map(|[left, right]| sampled(density, left, right).0)
        .to_vec()
}

/// What the density changes from one number of the machine to the next beside that end of a panel where it is less steep: it cannot be told better. At the other end it may have a corner.
pub(crate) fn graininess(density: &dyn Fn(f64) -> f64, panel: &Panel) -> f64 {
    let after = panel.left.next_up();
    let before = panel.right.next_down();
    let first = (density(after.next_up()) - density(after)).abs();
    let last = (density(before) - density(before.next_down())).abs();
    first.min(last)
}

/// Whether a panel may be left unresolved: beside a corner it is not cut further.
pub(crate) fn is_short(panel: &Panel) -> bool {
    let size = panel.left.abs().max(panel.right.abs());
    panel.right - panel.left <= COARSE * FINEST * size
}

/// A part of a panel on which the mean is at least this share of the largest negative value is as good as negative; what is less deep than this share of what was found is not looked into.
const MOSTLY: f64 = 0.25;
const SHALLOW: f64 = 0.125;

/// Places of a panel where an answer is compared with its resampled pressure, between the nodes of both, and towards its ends, where an answer may have a layer of its own that no node
/// of a panel sees.
const COMPARED: [f64; 9] =
    [1e-6, 1e-4, 1e-2, 0.071_828, 0.371_828, 0.914_159, 1.0 - 1e-2, 1.0 - 1e-4, 1.0 - 1e-6];

/// Places at which an answer is compared with a panel, its pressure and how far it is from the panel there. They keep off the ends by what the place of a jump may be off by: there the
/// pressure may be that beyond it.
pub(crate) fn compared(
    panel: &Panel,
    pressure: &dyn Fn(f64) -> f64,
) -> [(f64, f64, f64); COMPARED.len()] {
    let blur = blur(panel.left.abs().max(panel.right.abs()));
    let [first, last] = [panel.left + blur, panel.right - blur];
    let places = COMPARED.map(|t| panel.left + t * (panel.right - panel.left));
    let places = places.map(|x| if first < last { x.clamp(first, last) } else { panel.middle() });
    let own = evaluate_at(&panel.coefficients, &places.map(|x| panel.own(x)));
    std::array::from_fn(|i| {
        let given = pressure(places[i]);
        (places[i], given, (own[i] - given).abs())
    })
}

/// The panel with its polynomial multiplied by `a + b x` plus `c + d x`, resampled at its nodes.
pub(crate) fn adjusted(panel: &Panel, [a, b]: [f64; 2], [c, d]: [f64; 2]) -> Panel {
    let (middle, half) = (panel.middle(), panel.half());
    let nodes = RULE.nodes.map(|t| middle + half * t);
    let mut values = evaluate_at(&panel.coefficients, &nodes.map(|x| panel.own(x)));
    for (value, x) in values.iter_mut().zip(nodes) {
        *value = *value * (a + b * x) + c + d * x;
    }
    Panel::new(panel.left, panel.right, RULE.expand(&values))
}

/// A lower bound of a panel's polynomial on a part of it, and its mean there.
pub(crate) fn range_on(panel: &Panel, left: f64, right: f64) -> [f64; 2] {
    let own = |nodes: &[f64; ORDER]| nodes.map(|x| panel.own(x));
    let values = |nodes: &[f64; ORDER]| evaluate_at(&panel.coefficients, &own(nodes));
    let (part, _) = sampled_at(&values, left, right);
    let mean = part.coefficients[0];
    [mean - part.swing - 32.0 * f64::EPSILON * panel.largest, mean]
}

/// Bounds of `||min(q, 0)||` squared, of its integral and of its size on a panel, each within some times what it is.
pub(crate) fn negative_part(panel: &Panel) -> [f64; 3] {
    let mut sums = [0.0f64; 3];
    if panel.coefficients[0] >= panel.swing {
        return sums;
    }
    let mut stack = vec![(panel.left, panel.right)];
    let width = panel.right - panel.left;
    // What is left when halves are below rounding of the panel is counted in full.
    let rounding = 64.0 * f64::EPSILON * panel.largest;
    while let Some((left, right)) = stack.pop() {
        let [least, mean] = range_on(panel, left, right);
        let middle = 0.5 * (left + right);
        let depth = (-least).max(0.0);
        if least >= 0.0 {
            continue;
        }
        // So is what is negative on most of it, and what is no deeper than a part of what was found.
        let is_small = depth <= rounding.max(SHALLOW * sums[2]);
        if is_small
            || mean <= -MOSTLY * depth
            || right - left <= 1e-9 * width
            || middle <= left
            || middle >= right
            || stack.len() > 60
        {
            sums[0] += depth * depth * (right - left);
            sums[1] += depth * (right - left);
            sums[2] = sums[2].max(depth);
        } else {
            stack.push((left, middle));
            stack.push((middle, right));
        }
    }
    sums
}
