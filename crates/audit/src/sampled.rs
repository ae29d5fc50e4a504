//! A residual looked at on windows: what samples could have missed of the profile is bounded, of the potential estimated by the last coefficients.

use crate::chebyshev::{lebesgue, nodes};
use crate::heights::Known;
use crate::problem::Refusal;
use crate::profile::Profile;
use crate::residual::blur;

/// Numbers of nodes on a window.
const COUNTS: [usize; 3] = [8, 12, 17];
/// Share of the residual that may be missed.
const SHARE: f64 = 0.15;
/// What a window may have missed beside zones, in roundings of the residual: of the profile and of the last coefficients two each, and the rounding itself.
const MISSED: f64 = 6.0;
/// Windows are at least this wide, relative to their distance from the origin, and beside it to that of this share of the whole.
const FINEST: f64 = 16.0 * f64::EPSILON;
pub(crate) const SMALLEST: f64 = 1e-3;

/// A residual that can be computed at places.
pub(crate) trait Field {
    /// `w(x)` and what its rounding may be.
    fn residual(&self, x: f64) -> (f64, f64);

    /// How often its density was looked at, and what else counts as such looks.
    fn looks(&self) -> u64;

    /// Counts what takes as long as so many looks.
    fn count(&self, looks: u64);

    /// What presses at most at any place of a short window.
    fn presses(&self, window: [f64; 2]) -> f64;

    /// The profile in it, where it has one.
    fn profile(&self) -> Option<&dyn Profile>;
}

/// What was seen on a window.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Seen {
    pub(crate) left: f64,
    pub(crate) right: f64,
    /// The largest `|w|` in a zone, `max(-w, 0)` beside zones, at numbers of the machine.
    pub(crate) largest: f64,
    /// `int` of the square of that.
    pub(crate) square: f64,
    /// The least `w`.
    pub(crate) least: f64,
    /// What presses at most at any place, where the window was not resolved.
    pub(crate) presses: f64,
}

/// Where the base bends, the pressure may be largest beside a number also where it is resolved at all of these: in the last units of the machine before a step. Places of less than this share of the largest are none of those (survey).
const HIGH: f64 = 0.5;

/// What presses at most about places where the base bends and the pressure is high.
pub(crate) fn presses_about(
    field: &impl Field,
    (cuts, high): (&[f64], f64),
    density: impl Fn(f64) -> f64,
) -> f64 {
    let windows = cuts.iter().map(|cut| {
        let blur = blur(cut.abs());
        [(cut - blur).max(-1.0), (cut + blur).min(1.0)]
    });
    let is_high = |window: &[f64; 2]| window.iter().any(|x| density(*x) >= HIGH * high);
    let presses = windows.filter(is_high).map(|window| field.presses(window));
    presses.fold(f64::NEG_INFINITY, f64::max)
}

/// Windows below this width can be taken out: there the density is what its own potential makes it.
const NARROW: f64 = 1e-9;

/// The largest `|w~|` that counts for potentials: on narrow windows the density is changed by `w~` times `dp/dv`, which changes the residual elsewhere by the potential of that only,
/// `potential(width)` of a density of size one.
pub(crate) fn largest(seen: &[Seen], softest: f64, potential: impl Fn(f64) -> f64) -> f64 {
    let (mut bulk, mut narrow, mut whole) = (0.0f64, 0.0f64, 0.0f64);
    for window in seen {
        let width = window.right - window.left;
        whole = whole.max(window.largest);
        if width <= NARROW {
            narrow += softest * window.largest * potential(width);
        } else {
            bulk = bulk.max(window.largest);
        }
    }
    whole.min(bulk + narrow)
}

/// Windows that cover an interval in a zone or beside zones, with so many looks at the density in all.
pub(crate) fn cover(
    field: &impl Field,
    whole: [f64; 2],
    is_zone: bool,
    most: u64,
    found: &mut Vec<Seen>,
) -> Result<(), Refusal> {
    let mut stack = vec![whole];
    let mut known = Known::default();
    while let Some([left, right]) = stack.pop() {
        let middle = 0.5 * (left + right);
        let size = left.abs().max(right.abs()).max(SMALLEST * (whole[1] - whole[0]));
        let is_finest = right - left <= FINEST * size || middle <= left || middle >= right;
        if is_finest {
            found.push(narrow(field, [left, right], is_zone));
        } else if let Some(seen) = window(field, [left, right], is_zone, &mut known) {
            found.push(seen);
        } else {
            stack.push([middle, right]);
            stack.push([left, middle]);
        }
        field.count(known.take_looks());
        if field.looks() > most {
            return Err(Refusal::TooManyWindows { at: middle });
        }
    }
    Ok(())
}

/// What is seen on a window; none where it has to be halved.
fn window(
    field: &impl Field,
    [left, right]: [f64; 2],
    is_zone: bool,
    known: &mut Known,
) -> Option<Seen> {
    let (c, r) = (0.5 * (left + right), 0.5 * (right - left));
    let (middle, noise) = field.residual(c);
    let budget = (SHARE * middle.abs()).max(2.0 * noise);
    let (count, of_profile) = match field.profile() {
        None => (COUNTS[0], 0.0),
        Some(profile) => {
            let mut heights = known.on(profile, [left, right]);
            let mut tried = COUNTS.into_iter().map(|count| (count, heights.missed(count, budget)));
            tried.find(|(_, missed)| *missed <= budget)?
        }
    };
    let at = nodes(count);
    let mut noise = 0.0f64;
    let values: Vec<f64> = (at.places.iter())
        .map(|t| {
            let (w, error) = field.residual(c + r * t);
            noise = noise.max(error);
            w
        })
        .collect();
    let series = at.coefficients(&values);
    let size = values.iter().fold(0.0f64, |most, w| most.max(w.abs()));
    let tail = series[count - 1].abs() + series[count - 2].abs();
    if tail > (SHARE * size).max(2.0 * noise) {
        return None;
    }
    let missed = of_profile + tail + noise;
    let swing: f64 = series[1..].iter().map(|c| c.abs()).sum();
    let largest = (lebesgue(count) * size).min(swing + series[0].abs()) + missed;
    if is_zone {
        let squares: f64 = values.iter().map(|w| (w.abs() + missed).powi(2)).sum();
        let square = std::f64::consts::PI * r * squares / count as f64;
        return Some(Seen {
            left,
            right,
            largest,
            square,
            least: -largest,
            presses: f64::NEG_INFINITY,
        });
    }
    let least = series[0] - swing - missed;
    let lowest = values.iter().copied().fold(f64::INFINITY, f64::min);
    // What was missed is no penetration: only what the samples show, or rounding, ends the halving.
    if least < -(MISSED * noise).max(-2.0 * lowest) {
        return None;
    }
    let largest = (-least).max(0.0);
    let square = largest * largest * 2.0 * r;
    Some(Seen { left, right, largest, square, least, presses: f64::NEG_INFINITY })
}

/// A window of some units of the machine: a jump of the profile, whose height there is that of either side.
fn narrow(field: &impl Field, [left, right]: [f64; 2], is_zone: bool) -> Seen {
    let blur = blur(left.abs().max(right.abs()));
    let range = |profile: &dyn Profile| profile.range([left - blur, right + blur]);
    let [low, high] = field.profile().map_or([0.0; 2], range);
    let size = |w: f64| if is_zone { w.abs() } else { (-w).max(0.0) };
    let (mut largest, mut least, mut anywhere) = (0.0f64, f64::INFINITY, 0.0f64);
    for x in [left, 0.5 * (left + right), right] {
        let (w, noise) = field.residual(x);
        let [f_low, f_high] = field.profile().map_or([0.0; 2], |profile| profile.height(x));
        let f = 0.5 * (f_low + f_high);
        let [lower, upper] = [w + (low - f).min(0.0), w + (high - f).max(0.0)];
        let nearest = if lower > 0.0 { lower } else { upper.min(0.0) };
        largest = largest.max(size(nearest) + (noise - 0.5 * (f_high - f_low)).max(0.0));
        anywhere = anywhere.max(size(lower).max(size(upper)) + noise);
        least = least.min(lower - noise);
    }
    let square = anywhere * anywhere * (right - left);
    let presses = field.presses([left, right]);
    Seen { left, right, largest, square, least, presses }
}
