//! What the profile is made of on a zone: kinks, and a rest that is a series or, where it bends in other ways, two halves on panels.

use std::sync::{Arc, OnceLock};

use fredholm::inversion::ultraspherical::{gains, norms};
use fredholm::inversion::{AbelTransform, Kink, Powers, Series, Shape, Symmetry, Weight};

use super::super::base::Base;
use super::super::pressure::place;
use crate::contact::accuracy::ROUNDING;
use crate::contact::ground::STEP;
use crate::contact::zones::Zone;
use crate::rounding::OF_A_VALUE;

/// More breakpoints than these do not get panels of their own: what they cost grows with their square, five seconds for 200. Traces of 300 points are within. Half and twice change none of 32 answers (survey).
const MOST_BREAKS: usize = 320;
/// Places on either side of the middle that show the size of slopes. At half or twice 19 of 20 answers change, within what they state (survey).
const SAMPLES: usize = 8;

/// Polynomials by which the surface beside a zone feels its kinks: so many are felt a hundredth of the half-length from its ends; nearer integrals are as cheap (theory).
pub(super) const FELT: usize = 256;

/// A slope as a function of the place, or of the distance from the middle of a zone.
type Slope = Arc<dyn Fn(f64) -> f64 + Send + Sync>;

/// The profile on a zone.
#[derive(Debug)]
pub(super) struct OnZone {
    kinks: Vec<Kink>,
    /// `a_n` of all kinks, once the surface beside is looked at.
    felt: OnceLock<Vec<f64>>,
    rest: Rest,
    breaks: Vec<f64>,
    tolerance: f64,
    half: f64,
    /// Size of the slope of the profile.
    pub(super) steepest: f64,
}

/// The profile without its kinks.
#[derive(Debug)]
enum Rest {
    Smooth(Series),
    Bent(Halves),
}

/// The even and the odd part of a slope about the middle of a zone.
struct Halves {
    slopes: [Slope; 2],
    breaks: Vec<f64>,
    /// The same where between two of them slopes are one polynomial, else none.
    joints: Vec<f64>,
    tolerance: f64,
    /// Rounding of the slopes.
    noise: f64,
    /// How far the middle is from where places are counted from.
    remote: f64,
    is_over: Box<dyn Fn() -> bool + Send + Sync>,
}

impl std::fmt::Debug for Halves {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Halves").field("breaks", &self.breaks).finish_non_exhaustive()
    }
}

impl Halves {
    fn shape(&self, powers: &Powers, part: Symmetry) -> Shape<'_> {
        let index = usize::from(part == Symmetry::Odd);
        Shape {
            slope: &*self.slopes[index],
            breaks: self.breaks.clone(),
            joints: self.joints.clone(),
            tolerance: self.tolerance,
            noise: self.noise,
            remote: self.remote,
            powers: powers.clone(),
            part,
            is_over: &*self.is_over,
        }
    }

    fn shapes(&self, powers: &Powers) -> [Shape<'_>; 2] {
        [Symmetry::Even, Symmetry::Odd].map(|part| self.shape(powers, part))
    }
}

impl OnZone {
    pub(super) fn new(base: &Arc<Base>, powers: &Powers, zone: &Zone) -> Self {
        let [left, right] = zone.ends;
        let half = 0.5 * zone.length();
        let (own, inside_of) = (Arc::clone(base), *zone);
        let clamped: Slope = Arc::new(move |xi: f64| own.slope(inside_of.inside(xi)));
        let inside = |at: &f64| left < *at && *at < right;
        let bends: Vec<f64> = base.breaks.iter().copied().filter(inside).collect();
        let mut cuts = base.cuts();
        cuts.retain(inside);
        if cuts.len() > MOST_BREAKS {
            cuts.clone_from(&bends);
        }
        // With both ends: a base with rounded edges is flat elsewhere.
        let samples = (0..2 * SAMPLES).map(|i| (i as f64 + 0.5) / (2 * SAMPLES) as f64);
        let slopes = samples.chain([0.0, 1.0]).map(|share| clamped(left + (right - left) * share));
        let steepest = slopes
            .filter(|slope| slope.is_finite())
            .fold(0.0f64, |most, slope| most.max(slope.abs()));
        // The slope is rounded, and so is the place it is taken at.
        let remote = left.abs().max(right.abs()) / half;
        let noise = 2.0 * f64::EPSILON * (1.0 + remote);
        let known = cuts.len() <= MOST_BREAKS;
        let kinks = if known { kinks(&clamped, zone, &bends, steepest) } else { Vec::new() };
        // Between the nodes of a short series may be what the cuts are for.
        let is_short = known && cuts.len() == bends.len();
        let rest = without(&clamped, zone, &kinks);
        let by_place =
            |y: f64| rest(if y < 0.0 { left + half * (1.0 + y) } else { right - half * (1.0 - y) });
        let rest = match is_short.then(|| Series::new(powers, half, noise, &by_place)).flatten() {
            Some(series) => Rest::Smooth(series),
            None => {
                let (own, inside_of) = (Arc::clone(base), *zone);
                let slope: Slope = Arc::new(move |xi| own.quick_slope(inside_of.inside(xi)));
                let rest = Arc::new(without(&slope, zone, &kinks));
                // A spline is one polynomial between two of its points.
                let profile = base.setting.problem().profile();
                let is_told = known && profile.measured_points().is_some();
                Rest::Bent(halves(base, zone, (&cuts, is_told), rest, noise * steepest))
            }
        };
        let centre = middle(zone, &cuts);
        let mut breaks: Vec<f64> = cuts.iter().map(|at| (*at - centre).abs()).collect();
        tidy(&mut breaks, zone);
        let felt = OnceLock::new();
        Self { kinks, felt, rest, breaks, tolerance: base.tolerance, half, steepest }
    }

    /// Where the halves bend.
    pub(super) fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    pub(super) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    pub(super) fn kinks(&self) -> &[Kink] {
        &self.kinks
    }

    /// `a_n` of the profile above its height in the middle, of what has no halves.
    pub(super) fn heights(&self, powers: &Powers, count: usize) -> Option<Vec<f64>> {
        let (gains, series) = (gains(powers, count.max(2)), self.series()?);
        let mut heights = vec![0.0; count.max(2)];
        let kinks = self.heights_of_kinks(powers, count);
        heights.iter_mut().zip(kinks).for_each(|(sum, a)| *sum += a);
        let modes = series.modes.iter().zip(&gains).map(|(m, l)| m * l);
        heights.iter_mut().zip(modes).for_each(|(sum, a)| *sum += a);
        // Force and moment tell the first two.
        let [even, odd] = self.levers(powers);
        [heights[0], heights[1]] = [gains[0] * even, gains[1] * odd * self.half];
        heights.truncate(count);
        Some(heights)
    }

    fn heights_of_kinks(&self, powers: &Powers, count: usize) -> Vec<f64> {
        let (norms, mut heights) = (norms(powers, count), vec![0.0; count]);
        for kink in &self.kinks {
            let own = kink.heights(powers, &norms);
            heights.iter_mut().zip(own).for_each(|(sum, a)| *sum += a);
        }
        heights
    }

    /// The first [`FELT`] `a_n` of the kinks, if there are any.
    pub(super) fn felt(&self, powers: &Powers) -> &[f64] {
        let count = if self.kinks.is_empty() { 0 } else { FELT };
        self.felt.get_or_init(|| self.heights_of_kinks(powers, count))
    }

    /// What the kinks add to the displacement beside the zone, at `|y| = 1 + excess` on the side of a sign.
    pub(super) fn beside(&self, powers: &Powers, excess: f64, side: f64) -> f64 {
        let r = self.half * (1.0 + excess);
        let kinks = self.kinks.iter().map(|kink| kink.displacement(powers, r, side));
        powers.beside() * kinks.sum::<f64>()
    }

    /// What is taken away from the coefficients of the polynomials.
    pub(super) fn modes(&self) -> &[f64] {
        self.series().map_or(&[], |series| &series.modes)
    }

    /// What is taken away from the coefficients of the first two polynomials.
    pub(super) fn lowest(&self) -> [f64; 2] {
        self.series().map_or([0.0; 2], Series::lowest)
    }

    fn series(&self) -> Option<&Series> {
        match &self.rest {
            Rest::Smooth(series) => Some(series),
            Rest::Bent(_) => None,
        }
    }

    /// `G_e(b)`, `G_o(b)`, but for the polynomials from the third on.
    pub(super) fn transforms(&self, powers: &Powers) -> [f64; 2] {
        let rest = match &self.rest {
            Rest::Smooth(series) => series.transforms(self.half),
            Rest::Bent(halves) => halves.shapes(powers).map(|shape| shape.transform(self.half)),
        };
        self.with_kinks(rest, |kink| kink.transforms(powers))
    }

    /// `mu b int h_e sin t S dt` and `(2+mu)/(1+mu) int h_o sin^(2+mu) t dt`: an even and an odd density of the same force and moment.
    pub(super) fn levers(&self, powers: &Powers) -> [f64; 2] {
        let mu = powers.exponent();
        let scales = [self.half, (2.0 + mu) / (1.0 + mu)];
        let scaled = |[even, odd]: [f64; 2]| [scales[0] * even, scales[1] * odd];
        let rest = match &self.rest {
            Rest::Smooth(series) => series.transforms(self.half),
            Rest::Bent(halves) => {
                let [even, odd] = halves.shapes(powers);
                let even = even.integral(self.half, Weight::Lever);
                scaled([even, odd.integral(self.half, Weight::SineSquared)])
            }
        };
        self.with_kinks(rest, |kink| scaled(kink.levers(powers)))
    }

    fn with_kinks(&self, rest: [f64; 2], part: impl Fn(&Kink) -> [f64; 2]) -> [f64; 2] {
        let kinks = self.kinks.iter().map(part);
        kinks.fold(rest, |sums, [even, odd]| [sums[0] + even, sums[1] + odd])
    }

    /// `G_e'(b)`, `G_o'(b)` of what is no polynomial, from inside and the [transforms](Self::transforms) at the end.
    pub(super) fn rises(&self, powers: &Powers, ends: [f64; 2]) -> [f64; 2] {
        let Rest::Bent(halves) = &self.rest else { return self.kink_rises(powers) };
        let shapes = halves.shapes(powers);
        let at = |steps: f64| {
            let x = self.half * (1.0 - STEP * steps);
            shapes.each_ref().map(|shape| shape.transform(x))
        };
        let ends = self.with_kinks(ends, |kink| kink.transforms(powers).map(|own| -own));
        let [one, two] = [1.0, 2.0].map(at);
        let rises =
            [0, 1].map(|k| (3.0 * ends[k] - 4.0 * one[k] + two[k]) / (2.0 * STEP * self.half));
        self.with_kinks(rises, |kink| kink.rises(powers))
    }

    /// The same of the kinks.
    pub(super) fn kink_rises(&self, powers: &Powers) -> [f64; 2] {
        self.with_kinks([0.0; 2], |kink| kink.rises(powers))
    }

    /// The even and odd transforms of what is neither kink nor polynomial, if there is any.
    pub(super) fn on_panels(&self, powers: &Powers) -> Option<[AbelTransform; 2]> {
        let Rest::Bent(halves) = &self.rest else { return None };
        Some(halves.shapes(powers).map(|shape| AbelTransform::new(&shape, self.half)))
    }
}

/// The jumps of the slope at the cuts.
fn kinks(slope: &Slope, zone: &Zone, cuts: &[f64], steepest: f64) -> Vec<Kink> {
    let offset = OF_A_VALUE * zone.left().abs().max(zone.right().abs());
    let kink = |&at: &f64| {
        let jump = |offset: f64| slope(at + offset) - slope(at - offset);
        let size =
            0.5 * if Kink::is_jump(jump(offset), jump(2.0 * offset)) { jump(offset) } else { 0.0 };
        let place = place(zone, at);
        let from_middle = 0.5 * (place.from_left - place.from_right);
        Kink { at: from_middle, place, size, half: 0.5 * zone.length() }
    };
    cuts.iter().map(kink).filter(|kink| kink.size.abs() > ROUNDING * steepest).collect()
}

/// The slope by `xi` without that of kinks.
fn without(
    slope: &Slope,
    zone: &Zone,
    kinks: &[Kink],
) -> impl Fn(f64) -> f64 + Send + Sync + use<> {
    let (slope, left) = (Arc::clone(slope), zone.left());
    let offset = OF_A_VALUE * zone.left().abs().max(zone.right().abs());
    let kinks: Vec<(f64, f64)> =
        kinks.iter().map(|kink| (left + kink.place.from_left, kink.size)).collect();
    move |xi: f64| {
        // At a kink itself the slope is that of either side.
        let near = kinks.iter().find(|(at, _)| (xi - at).abs() < offset);
        let xi = near.map_or(xi, |(at, _)| at + offset);
        kinks.iter().fold(slope(xi), |sum, (at, size)| sum - size.copysign(xi - at) * size.signum())
    }
}

/// The halves of what is left.
fn halves(
    base: &Arc<Base>,
    zone: &Zone,
    (cuts, is_told): (&[f64], bool),
    rest: Arc<impl Fn(f64) -> f64 + Send + Sync + 'static>,
    noise: f64,
) -> Halves {
    let (centre, tolerance) = (middle(zone, cuts), base.tolerance);
    let other = Arc::clone(&rest);
    let even: Slope = Arc::new(move |r| 0.5 * (rest(centre + r) - rest(centre - r)));
    let odd: Slope = Arc::new(move |r| 0.5 * (other(centre + r) + other(centre - r)));
    let mut breaks: Vec<f64> = cuts.iter().map(|at| (*at - centre).abs()).collect();
    tidy(&mut breaks, zone);
    let joints = if is_told { breaks.clone() } else { Vec::new() };
    let deadline = base.deadline().clone();
    let is_over = Box::new(move || deadline.is_past());
    let (slopes, remote) = ([even, odd], centre.abs());
    Halves { slopes, breaks, joints, tolerance, noise, remote, is_over }
}

/// The middle of a zone: a bend that only rounding keeps from there is there, else the halves would bend next to it.
fn middle(zone: &Zone, bends: &[f64]) -> f64 {
    let middle = zone.middle();
    let near = bends.iter().find(|at| (*at - middle).abs() <= zone.rounding());
    near.copied().unwrap_or(middle)
}

/// Breaks in order, without those that are in the middle.
fn tidy(breaks: &mut Vec<f64>, zone: &Zone) {
    let rounding = zone.rounding();
    breaks.retain(|r| *r > rounding);
    breaks.sort_by(f64::total_cmp);
    // Of two that mirror each other but for rounding one will do: between them there is nothing to be resolved.
    breaks.dedup_by(|next, before| *next - *before <= rounding);
    if breaks.len() > MOST_BREAKS {
        breaks.clear();
    }
}
