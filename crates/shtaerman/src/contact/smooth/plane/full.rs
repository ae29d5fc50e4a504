//! Full contact of a wave, by the conjugate of its slope.

use std::f64::consts::{PI, SQRT_2};

use fredholm::inversion::{Angular, Conjugate, integral};

use super::super::base::{Base, wrapped};
use super::super::equation::{COMPARED, FINE};
use super::super::stated::difference;
use crate::contact::accuracy::{Accuracy, ErrorKind, ROUNDING, Sizes};
use crate::contact::balance::State;
use crate::contact::check::between_breaks;
use crate::contact::complementarity::Complementarity;
use crate::contact::method::{Method, MethodName};
use crate::contact::rates::{Linearised, smooth_rates};
use crate::contact::solution::Solution;
use crate::contact::steps::INSIDE;
use crate::contact::stiffness::Stiffness;
use crate::contact::valleys::CELLS;
use crate::line_search::{crossing, top};
use crate::{Load, Vertical};

/// Panels of the moment where panels do not resolve the slope. At half or twice 3 of 5 answers change, within what they state (survey).
pub(super) const PANELS: usize = 64;

/// A place and the pressure there.
type Point = (f64, f64);

/// The profile of a wave over the angle `pi xi`.
struct Turn<'b>(&'b Base);

impl Angular for Turn<'_> {
    fn height(&self, angle: f64) -> f64 {
        self.0.height(angle / PI)
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        self.0.has_slope().then(|| self.0.slope(angle / PI) / PI)
    }

    fn tangents(&self, angles: &[f64]) -> Vec<(f64, Option<f64>)> {
        let places: Vec<f64> = angles.iter().map(|angle| angle / PI).collect();
        let tangents = self.0.tangents(&places).into_iter();
        tangents.map(|(height, slope)| (height, slope.map(|slope| slope / PI))).collect()
    }
}

/// Full contact of a wave: `p0 = P0/2 - F/theta0` with `F = sum k f_k cos(k pi xi + ..)`, as `int K cos(k pi eta) deta = cos(k pi xi)/k` for `L = 2`.
#[derive(Debug, Clone)]
pub(super) struct FullWave {
    slope: Conjugate,
    theta0: f64,
    state: State,
    accuracy: Accuracy,
    largest: f64,
    tension: f64,
    /// None where the whole base was kept in contact.
    is_unilateral: bool,
    setting: crate::contact::setting::Setting,
    range: f64,
}

impl FullWave {
    pub(super) fn new(base: &Base, force: f64) -> Self {
        let angles = |places: &[f64]| -> Vec<f64> { places.iter().map(|at| at * PI).collect() };
        let [bends, joints] = [&base.breaks, &base.joints].map(|places| angles(places));
        let resolved = |panels: usize| {
            Conjugate::resolve(&Turn(base), [&bends, &joints], [panels, 2], base.tolerance)
        };
        let (slope, other) = (resolved(FINE.panels), resolved(COMPARED.panels));
        // Over the whole turn.
        let along = |slope: &Conjugate, angle: f64| slope.conjugate(2.0 * angle - PI);
        let changed = difference(|angle| along(&slope, angle), |angle| along(&other, angle));
        let (conjugate_error, mean_error) =
            (changed + slope.error(), (slope.mean() - other.mean()).abs());
        let (settlement, theta0) = (slope.mean(), base.setting.theta0());
        let state = State { settlement, tilt: 0.0, force, moment: 0.0 };
        let accuracy = Accuracy {
            kind: ErrorKind::Estimate,
            pressure: conjugate_error / theta0,
            settlement: mean_error + ROUNDING * settlement.abs(),
            tilt: 0.0,
            force: 0.0,
            moment: 0.0,
        };
        let (setting, range) = (base.setting.clone(), base.range());
        let is_unilateral = setting.is_unilateral();
        let (largest, tension) = (0.0, 0.0);
        Self { slope, theta0, state, accuracy, largest, tension, is_unilateral, setting, range }
    }

    /// As an answer, with its extremes and its moment.
    pub(super) fn answer(mut self, breaks: &[f64]) -> Self {
        let places = (0..=CELLS).map(|i| 2.0 * i as f64 / CELLS as f64 - 1.0);
        let pressures = places.map(|xi| self.at(xi)).filter(|p| p.is_finite());
        let (largest, most) = pressures
            .fold((f64::MIN_POSITIVE, 0.0f64), |(size, most), p| (size.max(p.abs()), most.max(-p)));
        self.accuracy.pressure += ROUNDING * largest;
        self.accuracy.moment = self.accuracy.pressure;
        (self.largest, self.tension) = (largest, most / largest);
        self.state.moment = self.moment(breaks);
        self
    }

    /// The mean of the profile.
    pub(super) fn settlement(&self) -> f64 {
        self.state.settlement
    }

    /// Whether equally spaced samples of the profile tell all of it: it bends nowhere, its seam included.
    pub(super) fn is_smooth(&self) -> bool {
        self.slope.is_sampled()
    }

    /// `p0(xi)`.
    pub(super) fn at(&self, xi: f64) -> f64 {
        0.5 * self.state.force - self.slope.conjugate(PI * xi) / self.theta0
    }

    /// `int xi p0 dxi` over `-1 .. 1`, of panels by what they make of `xi`: `2/pi^2 int f' ln|2 cos(pi xi/2)| dxi` is the integral of `xi F`, as the logarithm is the conjugate of `xi`.
    fn moment(&self, breaks: &[f64]) -> f64 {
        if let Some(turning) = self.slope.turning() {
            return -2.0 / (PI * PI * self.theta0) * turning;
        }
        let mut cuts: Vec<f64> =
            (0..=PANELS).map(|i| 2.0 * i as f64 / PANELS as f64 - 1.0).collect();
        cuts.extend(breaks);
        cuts.sort_by(f64::total_cmp);
        let panels = cuts.windows(2);
        panels.map(|pair| integral(pair[0], pair[1], |xi| xi * self.at(xi))).sum()
    }

    /// The least pressure with its place, given those of equally spaced ones and places between which it has a wave or two: a gap about to open is shorter than their distance, and may lie beside a
    /// hollow kink.
    pub(super) fn lowest(&self, along: &[Point], marks: &[f64]) -> Point {
        let between = between_breaks(marks, [-1.0, 1.0]).into_iter().map(|xi| (xi, self.at(xi)));
        let mut places: Vec<Point> = along.iter().copied().chain(between).collect();
        crate::order::sort_by_number(&mut places, |one| one.0);
        // The first comes after the last again.
        let [first, second] = [places[0], places[1]];
        places.extend([(first.0 + 2.0, first.1), (second.0 + 2.0, second.1)]);
        let may_reach = |[before, here, after]: [f64; 3]| {
            here <= before && here <= after && here < 0.5 * (before + after - 2.0 * here)
        };
        let valleys = places.windows(3).filter(|w| may_reach([w[0].1, w[1].1, w[2].1]));
        let bottoms = valleys.map(|w| {
            let (place, height) = top(&|xi| -self.at(wrapped(xi)), w[0].0, w[2].0);
            (wrapped(place), -height)
        });
        let found = places.iter().copied().chain(bottoms).chain(self.beside_kink());
        found.fold((0.0, f64::INFINITY), |one, two| if two.1 < one.1 { two } else { one })
    }

    /// The pressure at equally spaced places.
    pub(super) fn along(&self, points: usize) -> Vec<Point> {
        // An irrational share of the step keeps clear of symmetric places, where a kink may be.
        let points = (0..points).map(|i| 2.0 * (i as f64 + 0.5 / SQRT_2) / points as f64 - 1.0);
        points.map(|xi| (xi, self.at(xi))).collect()
    }

    /// The pressure right beside the kink where the base is most hollow, with the place of that kink: at the kink itself it is minus infinity,
    /// and where it pulls no farther from it than rounding there is nothing to open.
    fn beside_kink(&self) -> Option<Point> {
        let deepest = self.slope.hollows().min_by(|one, two| one.1.total_cmp(&two.1))?;
        let kink = deepest.0 / PI;
        let beside = [-INSIDE, INSIDE].map(|offset| self.at(wrapped(kink + offset)));
        Some((kink, beside[0].min(beside[1])))
    }

    /// A zone for a force: where the pressure of full contact is above its largest value less twice the mean. Of one cosine that is the zone itself,
    /// as Westergaard's half-width has `sin^2 = P0/(2 p*)`. On panels, where there may be a kink, it is where full contact does not pull: a gap that a kink opens is
    /// about as wide. None where it is in several parts.
    pub(super) fn first_zone(
        &self,
        along: &[Point],
        (bottom, least): Point,
        force: f64,
    ) -> Option<[f64; 2]> {
        let count = along.len();
        let at = |i: usize| along[i % count].1;
        let step = 2.0 / count as f64;
        let level = if self.is_smooth() {
            self.top(along) - force
        } else {
            0.5 * (self.state.force - force)
        };
        let is_inside = |i: usize| at(i) > level;
        let rises = (0..count).filter(|&i| !is_inside(i) && is_inside(i + 1)).count();
        if rises > 1 || least >= level {
            return None;
        }
        let outside = (0..count).filter(|&i| !is_inside(i)).count();
        let width = step * (outside + 1) as f64;
        let [left, right] = [-width, width].map(|width| self.climbed(bottom, width, level));
        Some([right, left + 2.0])
    }

    /// The largest pressure, by a parabola through three places.
    fn top(&self, along: &[Point]) -> f64 {
        let count = along.len();
        let at = |i: usize| along[i % count].1;
        let top = (0..count).fold(0, |top, i| if at(i) > at(top) { i } else { top });
        let (before, peak, after) = (at(top + count - 1), at(top), at(top + 1));
        let bend = 2.0 * peak - before - after;
        let beside = if bend > 0.0 { (after - before) / (bend * count as f64) } else { 0.0 };
        peak.max(self.at(wrapped(along[top].0 + beside)))
    }

    /// Where the pressure rises to a value this far from the bottom of a valley at most.
    fn climbed(&self, bottom: f64, width: f64, level: f64) -> f64 {
        let above = |width: f64| self.at(wrapped(bottom + width)) - level;
        let ends = [0.0, width].map(|width| (width, above(width)));
        let meets = ends[0].1 <= 0.0 && ends[1].1 > 0.0;
        bottom + if meets { crossing(&above, ends[0], ends[1], 0.0) } else { width }
    }
}

impl Solution for FullWave {
    fn state(&self) -> State {
        self.state
    }

    /// Infinite, as the settlement does not depend on the force.
    fn stiffness(&self) -> Stiffness {
        let rigid = f64::INFINITY;
        Stiffness { force_settlement: rigid, coupling: 0.0, moment_tilt: rigid }
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        vec![[-1.0, 1.0]]
    }

    fn touches(&self, _xi: f64) -> bool {
        true
    }

    fn corner_intensity(&self) -> Option<Vec<[f64; 2]>> {
        Some(vec![[0.0; 2]])
    }

    fn pressure(&self, xi: f64) -> f64 {
        let pressure = self.at(wrapped(xi));
        // In a gap narrower than rounding that a hollow kink opens.
        let is_open = self.is_unilateral && pressure == f64::NEG_INFINITY;
        if is_open { 0.0 } else { pressure }
    }

    fn displacement(&self, xi: f64) -> f64 {
        self.state.settlement - self.setting.height(wrapped(xi))
    }

    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        let places = (0..=CELLS).map(|i| 2.0 * i as f64 / CELLS as f64 - 1.0);
        let sampled = places.map(|xi| (xi, self.pressure(xi)));
        sampled.filter(|(_, pressure)| pressure.is_finite()).unzip()
    }

    fn method(&self) -> Method {
        Method { name: MethodName::FirstKind, n: 0 }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    /// The settlement is the mean of the heights, which may be nothing.
    fn relative_error(&self) -> f64 {
        let sizes = self.state.sizes(self.largest);
        let displacement = sizes.displacement.max(self.range);
        self.accuracy.relative(&Sizes { displacement, ..sizes })
    }

    fn complementarity(&self) -> Option<Complementarity> {
        let found = Complementarity { tension: self.tension, penetration: 0.0 };
        self.is_unilateral.then_some(found)
    }

    /// More force is taken evenly.
    fn linearised(&self, load: Load, peak: f64) -> Option<Linearised> {
        let Vertical::Force(force) = load.vertical else { return None };
        let largest = Some(self.pressure(peak)).filter(|p| p.is_finite()).unwrap_or(0.0);
        let even = [0.0, 1.0, 0.0, 0.5, 0.0];
        let rates = smooth_rates(&load, [force, largest], [even, [0.0; 5]]);
        Some(Linearised { rates, errors: [[0.0; 5]; 3] })
    }

    fn size(&self) -> f64 {
        self.largest
    }
}
