//! The density resampled: panels cut where it needs them.

use crate::legendre::{ORDER, RULE, evaluate_at};
use crate::panel::Panel;
use crate::residual::blur;

/// A panel at an end of a part is cut this far from the end, or nearer where that leaves a panel that is resolved: densities bend there as `d ln d`, with which short panels need to
/// be less exact.
const CUTS: [f64; 3] = [1.0 / 64.0, 1.0 / 16.0, 0.25];
/// Panels are at most this long: far parts of a row are integrated on their nodes.
const LONGEST: f64 = 0.5;
/// And this share of their zone: beside a free end the pressure is nowhere firmly positive on the whole panel.
const LONGEST_OF_ZONE: f64 = 0.25;
/// What is left of the tail after a cut, from which on it is noise, where it is below this share of the density: a kink leaves a half.
const STAGNANT: f64 = 0.75;
const NOISE: f64 = 1e-7;
/// The coefficients of noise do not fall either: its tail is at least this share of those before. Of `d^(1/2)` at an end it is less.
const FLAT: f64 = 0.6;
/// Panels are not cut below this many units of the machine, and below `COARSE` times that where the density changes as much from number to number.
const FINEST: f64 = 64.0 * f64::EPSILON;
const COARSE: f64 = 1e6;
/// On a panel beside a corner the density is so many times steeper at the near end than at the far one.
const STEEPER: f64 = 4.0;
/// What a panel beside a corner misses at its end, in last coefficients: those of `d ln d` fall as `4/n^3`, so that the rest of them adds up to half their number. Powers fall more slowly still, yet
/// beside a jump shorter panels only leave more of them to single numbers: there a bound of `cargo test -p shtaerman-cli kinks_and_jumps` is 1.2e-9 without it, 3.4e-9 with it.
const MISSED_AT_END: f64 = 0.5 * ORDER as f64;
/// Panels shorter than this share of their distance from the origin have nodes that are rounded noticeably; so many corrections take that away.
const ROUNDED: f64 = 1e-6;
const CORRECTIONS: usize = 3;

/// A part of a zone that is to be resolved.
struct Part {
    left: f64,
    right: f64,
    /// Whether it ends where the zone does.
    is_end: [bool; 2],
    /// The tail of the part that it was cut from.
    tail: f64,
    /// What was sampled of it when a place to cut was looked for.
    known: Option<Sampled>,
}

/// A panel and its tail.
type Sampled = (Panel, f64);

impl Part {
    /// Where to cut it: as near to an end as what is beyond is resolved; then with that.
    fn cut(&self, resolved: impl Fn(f64, f64) -> Option<Sampled>) -> (f64, Option<Sampled>) {
        let width = self.right - self.left;
        let place = |share: f64| match self.is_end {
            [true, false] => self.left + share * width,
            [false, true] => self.right - share * width,
            _ => self.left + 0.5 * width,
        };
        if self.is_end[0] == self.is_end[1] {
            return (place(0.5), None);
        }
        let beyond = |at: f64| if self.is_end[0] { [at, self.right] } else { [self.left, at] };
        let [nearest @ .., farthest] = CUTS;
        let mut tried = nearest.into_iter().map(place).map(|at| {
            let [left, right] = beyond(at);
            (at, resolved(left, right))
        });
        tried.find(|(_, sampled)| sampled.is_some()).unwrap_or_else(|| (place(farthest), None))
    }
}

/// How well a density is to be resolved.
pub(crate) struct Limits<'a> {
    /// What a polynomial may miss between two places.
    pub(crate) tolerance: &'a dyn Fn(f64, f64) -> f64,
    /// The size of the density.
    pub(crate) scale: f64,
    /// The exponent of a kernel that is a power, 0 of a logarithm.
    pub(crate) exponent: f64,
}

/// Panels of a zone from left to right on which the density is a polynomial to a tolerance for their ends; none where they would be more than `most`.
pub(crate) fn panels(
    density: &dyn Fn(f64) -> f64,
    zone: [f64; 2],
    cuts: &[f64],
    &Limits { tolerance, scale, exponent }: &Limits<'_>,
    most: usize,
    found: &mut Vec<Panel>,
) -> bool {
    let mut ends: Vec<f64> = vec![zone[0]];
    ends.extend(cuts.iter().copied().filter(|at| zone[0] < *at && *at < zone[1]));
    ends.push(zone[1]);
    let grain = if exponent == 0.0 { STEEPER / MISSED_AT_END } else { STEEPER };
    let longest = LONGEST.min(LONGEST_OF_ZONE * (zone[1] - zone[0]));
    let mut stack: Vec<Part> = (ends.windows(2).rev())
        .map(|pair| Part {
            left: pair[0],
            right: pair[1],
            is_end: [true; 2],
            tail: f64::INFINITY,
            known: None,
        })
        .collect();
    while let Some(part) = stack.pop() {
        let Part { left, right, is_end, tail: before, ref known } = part;
        let width = right - left;
        let mut tail = f64::INFINITY;
        // What is too long is not looked at.
        if width <= longest {
            let panel;
            (panel, tail) = known.clone().unwrap_or_else(|| sampled(density, left, right));
            let finest = FINEST * left.abs().max(right.abs());
            let is_noise = tail > STAGNANT * before
                && tail < NOISE * scale
                && tail > FLAT * panel.before_tail();
            let is_done = tail <= tolerance(left, right)
                || is_noise
                || width <= finest
                || (width <= COARSE * finest && tail <= grain * graininess(density, &panel));
            if is_done {
                found.push(panel);
                continue;
            }
        }
        let (cut, beyond) = part.cut(|left, right| {
            (right - left <= longest)
                .then(|| sampled(density, left, right))
                .filter(|(_, tail)| *tail <= tolerance(left, right))
        });
        let [first, last] = if is_end[0] { [None, beyond] } else { [beyond, None] };
        stack.push(Part { left: cut, right, is_end: [false, is_end[1]], tail, known: last });
        stack.push(Part { left, right: cut, is_end: [is_end[0], false], tail, known: first });
        if found.len() + stack.len() > most {
            return false;
        }
    }
    true
}

fn sampled(density: &dyn Fn(f64) -> f64, left: f64, right: f64) -> Sampled {
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
fn graininess(density: &dyn Fn(f64) -> f64, panel: &Panel) -> f64 {
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

/// A lower bound of a panel's polynomial on a part of it, and an upper bound of its size there.
pub(crate) fn range_on(panel: &Panel, left: f64, right: f64) -> (f64, f64) {
    let own = |nodes: &[f64; ORDER]| nodes.map(|x| panel.own(x));
    let values = |nodes: &[f64; ORDER]| evaluate_at(&panel.coefficients, &own(nodes));
    let (part, _) = sampled_at(&values, left, right);
    let rounding = 32.0 * f64::EPSILON * panel.largest;
    (part.coefficients[0] - part.swing - rounding, part.largest + rounding)
}

/// Bounds of `||min(q, 0)||` squared, of its integral and of its size on a panel.
pub(crate) fn negative_part(panel: &Panel) -> [f64; 3] {
    let mut sums = [0.0f64; 3];
    if panel.coefficients[0] >= panel.swing {
        return sums;
    }
    let mut stack = vec![(panel.left, panel.right)];
    let width = panel.right - panel.left;
    while let Some((left, right)) = stack.pop() {
        let (least, _) = range_on(panel, left, right);
        let middle = 0.5 * (left + right);
        let depth = (-least).max(0.0);
        // What is left when halves are below rounding of the panel is counted in full.
        let is_small = depth <= 64.0 * f64::EPSILON * panel.largest;
        if least >= 0.0 {
            continue;
        }
        if is_small
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
