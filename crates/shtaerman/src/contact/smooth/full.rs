//! Full contact of a wave, by the conjugate of its slope.

use std::f64::consts::{PI, SQRT_2};
use std::sync::Arc;

use fredholm::inversion::{Conjugate, integral};

use super::answer::PANELS;
use super::band::{Band, Turn, wrapped};
use super::detail::{COMPARED, FINE};
use super::problem::SmoothProblem;
use super::told::compared;
use crate::contact::check::BETWEEN;
use crate::contact::extremes::RISE;
use crate::contact::iteration::{crossing, top};
use crate::contact::steps::INSIDE;

/// Full contact of a wave: `p0 = P0/2 - F/theta0` with `F = sum k f_k cos(k pi xi + ..)`, as `int K cos(k pi eta) deta = cos(k pi xi)/k` for `L = 2`.
#[derive(Debug, Clone)]
pub(super) struct FullWave {
    pub(super) slopes: Arc<Conjugate>,
    pub(super) theta0: f64,
    pub(super) force: f64,
    /// Estimated errors of `F` and of the mean of the profile, by other panels.
    pub(super) error: [f64; 2],
}

impl FullWave {
    pub(super) fn new(problem: &SmoothProblem, band: Option<&Band>, force: f64) -> Self {
        let SmoothProblem { profile, theta0, .. } = problem;
        let theta0 = *theta0;
        if let Some(Band { slopes, .. }) = band {
            let error = [slopes.error(), 0.0];
            return Self { slopes: Arc::new(slopes.clone()), theta0, force, error };
        }
        let angles = |places: &[f64]| -> Vec<f64> { places.iter().map(|at| at * PI).collect() };
        let [bends, joints] = [&profile.breaks, &profile.joints].map(|places| angles(places));
        let resolved = |panels: usize| {
            Conjugate::on_panels(&Turn(profile), [&bends, &joints], [panels, 2], profile.tolerance)
        };
        let (slopes, other) = (Arc::new(resolved(FINE.panels)), resolved(COMPARED.panels));
        // Over the whole turn.
        let along = |slopes: &Conjugate, angle: f64| slopes.conjugate(2.0 * angle - PI);
        let difference = compared(|angle| along(&slopes, angle), |angle| along(&other, angle));
        let error = [difference + slopes.error(), (slopes.mean() - other.mean()).abs()];
        Self { slopes, theta0, force, error }
    }

    /// `p0(xi)`.
    pub(super) fn pressure(&self, xi: f64) -> f64 {
        0.5 * self.force - self.slopes.conjugate(PI * xi) / self.theta0
    }

    /// The settlement: the mean of the profile.
    pub(super) fn settlement(&self) -> f64 {
        self.slopes.mean()
    }

    /// `int xi p0 dxi` over `-1 .. 1`, of panels by what they make of `xi`: `2/pi^2 int f' ln|2 cos(pi xi/2)| dxi` is the integral of `xi F`, as the logarithm is the conjugate of `xi`.
    pub(super) fn moment(&self, breaks: &[f64]) -> f64 {
        if let Some(turning) = self.slopes.turning() {
            return -2.0 / (PI * PI * self.theta0) * turning;
        }
        let mut cuts: Vec<f64> =
            (0..=PANELS).map(|i| 2.0 * i as f64 / PANELS as f64 - 1.0).collect();
        cuts.extend(breaks);
        cuts.sort_by(f64::total_cmp);
        cuts.windows(2).map(|pair| integral(pair[0], pair[1], |xi| xi * self.pressure(xi))).sum()
    }

    /// The pressure at equally spaced places.
    pub(super) fn along(&self, points: usize) -> Vec<(f64, f64)> {
        // An irrational share of the step keeps clear of symmetric places, where a kink may be.
        let points = (0..points).map(|i| 2.0 * (i as f64 + 0.5 / SQRT_2) / points as f64 - 1.0);
        points.map(|xi| (xi, self.pressure(xi))).collect()
    }

    /// The pressure right beside the kink where the base is most hollow, with the place of that kink: at the kink itself it is minus infinity,
    /// and where it pulls no farther from it than rounding there is nothing to open.
    pub(super) fn beside_kink(&self) -> Option<(f64, f64)> {
        let deepest = self.slopes.hollows().min_by(|one, two| one.1.total_cmp(&two.1))?;
        let kink = deepest.0 / PI;
        let beside = [-INSIDE, INSIDE].map(|offset| self.pressure(wrapped(kink + offset)));
        Some((kink, beside[0].min(beside[1])))
    }

    /// The least pressure in the valleys between equally spaced places that might reach below zero, with its place: a gap about to open is shorter than their distance.
    pub(super) fn lowest(&self, along: &[(f64, f64)]) -> Option<(f64, f64)> {
        let count = along.len();
        let step = 2.0 / count as f64;
        let at = |i: usize| along[i % count].1;
        let may_reach = |i: usize| {
            let (before, here, after) = (at(i + count - 1), at(i), at(i + 1));
            let bend = before + after - 2.0 * here;
            here <= before && here <= after && here < RISE * bend
        };
        (0..count)
            .filter(|&i| may_reach(i))
            .map(|i| self.bottom(along[i].0, step))
            .min_by(|one, two| one.1.total_cmp(&two.1))
    }

    /// The least pressure between cuts of the profile, which lie about narrow features that equally spaced places miss.
    pub(super) fn between(&self, cuts: &[f64]) -> Option<(f64, f64)> {
        let places = cuts.windows(2).flat_map(|pair| {
            let step = (pair[1] - pair[0]) / BETWEEN as f64;
            (1..BETWEEN).map(move |i| (pair[0] + step * i as f64, step))
        });
        let lowest = places
            .map(|(at, step)| (at, self.pressure(at), step))
            .min_by(|one, two| one.1.total_cmp(&two.1));
        lowest.map(|(at, _, step)| self.bottom(at, step))
    }

    /// The bottom of the valley within a step of a place.
    fn bottom(&self, at: f64, step: f64) -> (f64, f64) {
        let (place, height) = top(&|xi| -self.pressure(wrapped(xi)), at - step, at + step);
        (wrapped(place), -height)
    }

    /// A zone for a force: where the pressure of full contact is above its largest value less twice the mean. Of one cosine that is the zone itself,
    /// as Westergaard's half-width has `sin^2 = P0/(2 p*)`. On panels, where there may be a kink, it is where full contact does not pull: a gap that a kink opens is
    /// about as wide. None where it is in several parts.
    pub(super) fn first_zone(
        &self,
        along: &[(f64, f64)],
        (bottom, least): (f64, f64),
        force: f64,
    ) -> Option<[f64; 2]> {
        let count = along.len();
        let at = |i: usize| along[i % count].1;
        let step = 2.0 / count as f64;
        let level = if self.slopes.is_sampled() {
            self.top(along) - force
        } else {
            0.5 * (self.force - force)
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
    fn top(&self, along: &[(f64, f64)]) -> f64 {
        let count = along.len();
        let at = |i: usize| along[i % count].1;
        let top = (0..count).fold(0, |top, i| if at(i) > at(top) { i } else { top });
        let (before, peak, after) = (at(top + count - 1), at(top), at(top + 1));
        let bend = 2.0 * peak - before - after;
        let beside = if bend > 0.0 { (after - before) / (bend * count as f64) } else { 0.0 };
        peak.max(self.pressure(wrapped(along[top].0 + beside)))
    }

    /// Where the pressure rises to a value this far from the bottom of a valley at most.
    fn climbed(&self, bottom: f64, width: f64, level: f64) -> f64 {
        let above = |width: f64| self.pressure(wrapped(bottom + width)) - level;
        let ends = [0.0, width].map(|width| (width, above(width)));
        let meets = ends[0].1 <= 0.0 && ends[1].1 > 0.0;
        bottom + if meets { crossing(&above, ends[0], ends[1], 0.0) } else { width }
    }
}
