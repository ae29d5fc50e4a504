//! The slope of the profile over the angle of a zone, and what the spectral relation makes of it.
//!
//! With `x = c + b cos t` and `f = sum f_k cos(k t)`, `g = df/dt = -sum k f_k sin(k t)`, the series `F = sum k f_k cos(k t)` is the conjugate
//!
//! `F(phi) = -(1/2 pi) p.v. int_{-pi}^{pi} g(t) cot((t - phi)/2) dt`,
//!
//! which converges slowly as a series where the profile has kinks, and not at all as fast as its panels do: `g` is a polynomial on each of
//! them, integrated against the pole by the Legendre functions of the second kind.

use std::f64::consts::{FRAC_2_PI, PI, TAU};
use std::sync::OnceLock;

use super::accuracy::{HARMLESS, RESOLVED, ROUNDING};
use super::angular::Angular;
use super::harmonics::{Harmonics, Resolved};
use super::panels::{Builder, Panel, follow_cusps, join};
use super::roots::{CONSTANT, Local, NEAREST};
use super::rule::{ORDER, RULE, integral};

/// From this `w - 1` on so many powers of `1/w` tell of a zone what is outside of it: the next is below rounding. At half or twice 3 of 32 answers change, within what they state (survey).
const REMOTE: f64 = 0.48;
const FIRST: usize = 96;
/// Harmonics that are tried of a slope on panels. At half or twice 5 of 20 answers change, within what they state (survey).
const COUNTS: [usize; 3] = [24, 48, 96];
/// Shorter panels than this show something that no short series has. Half and twice change none of 20 answers (survey).
const FINEST: f64 = 0.01;

/// `g` on panels, over the half turn of a zone (odd beyond it) or over the whole turn of a wave.
#[derive(Debug, Clone)]
pub struct Conjugate {
    panels: Vec<Panel>,
    is_odd: bool,
    /// Where `g` jumps, and how it does: there `F` is infinite.
    jumps: Vec<(f64, f64)>,
    /// Where the profile may bend.
    bends: Vec<f64>,
    /// Whether `g` goes as a power of the distance somewhere, which no panels resolve.
    is_cusped: bool,
    /// Mean of `f` over the angle.
    mean: f64,
    /// Estimated error of `F`.
    error: f64,
    /// The same at the ends of the zone, where no panels join.
    end_error: f64,
    /// Rounding of each of the first coefficients of `f`.
    mode_error: f64,
    /// Largest `|g|`.
    largest: f64,
    /// The Fourier series of `F` and `f`, where it is short.
    series: Option<Harmonics>,
    /// The first coefficients of `f`, once they are asked for.
    first: OnceLock<Vec<f64>>,
}

impl Conjugate {
    /// Resolves a profile over one half turn `0 .. pi`, or over two `-pi .. pi`, between given angles where it bends, and others where only higher derivatives jump, to a relative `tolerance`;
    /// with at first so many `[panels, half turns]`.
    pub fn resolve(
        profile: &dyn Angular,
        [bends, joints]: [&[f64]; 2],
        [panels, turns]: [usize; 2],
        tolerance: f64,
    ) -> Self {
        if bends.is_empty()
            && joints.is_empty()
            && let Some(sampled) = Self::sampled(profile, turns == 1)
        {
            return sampled;
        }
        Self::on_panels(profile, [bends, joints], [panels, turns], tolerance)
    }

    /// The slope as a short series by equally spaced samples, if it is one.
    pub fn sampled(profile: &dyn Angular, is_odd: bool) -> Option<Self> {
        let resolved = Harmonics::sampled(profile, is_odd)?;
        let rounding = profile.rounding(resolved.heights, resolved.largest);
        Some(Self::of_series(resolved, is_odd, rounding))
    }

    /// That of a flat base, which is nothing.
    #[must_use]
    pub fn flat() -> Self {
        Self::of_series(Resolved::default(), true, 0.0)
    }

    fn of_series(resolved: Resolved, is_odd: bool, rounding: f64) -> Self {
        let Resolved { series, mean, largest, .. } = resolved;
        let error = ROUNDING * largest;
        Self {
            panels: Vec::new(),
            is_odd,
            jumps: Vec::new(),
            bends: Vec::new(),
            is_cusped: false,
            mean,
            error,
            end_error: error,
            mode_error: error + rounding,
            largest,
            series: Some(series),
            first: OnceLock::new(),
        }
    }

    /// The slope on panels.
    pub fn on_panels(
        profile: &dyn Angular,
        [bends, joints]: [&[f64]; 2],
        [panels, turns]: [usize; 2],
        tolerance: f64,
    ) -> Self {
        let is_odd = turns == 1;
        let start = if is_odd { 0.0 } else { -PI };
        let count = panels * turns;
        let width = PI / panels as f64;
        let mut cuts: Vec<f64> = (0..=count).map(|i| start + width * i as f64).collect();
        cuts[count] = PI;
        let ends = [cuts[0], PI];
        let [bends, joints] = [bends, joints].map(ascending);
        let own = ascending(&[&bends[..], &joints[..]].concat());
        cuts.extend(own.iter().filter(|bend| **bend > start && **bend < PI));
        cuts.sort_by(f64::total_cmp);
        // A cut by a bend is where it bends, to the last bit: a panel between shows nothing.
        let is_apart = |cut: &f64| {
            let blur = profile.blur(*cut);
            let before = own.partition_point(|bend| bend < cut).checked_sub(1);
            let nearest = [before, Some(own.partition_point(|bend| bend <= cut))];
            let mut bends = nearest.into_iter().filter_map(|index| own.get(index?));
            bends.all(|bend| (bend - cut).abs() > NEAREST * blur)
        };
        cuts.retain(|cut| ends.contains(cut) || is_apart(cut));
        cuts.dedup();
        let tolerance = tolerance.max(RESOLVED);
        let (panels, scale) = (Vec::new(), [0.0; 2]);
        let mut builder = Builder {
            profile,
            panels,
            sum: 0.0,
            worst: 0.0,
            heights: 0.0,
            is_by_heights: false,
            scale,
            tolerance,
        };
        for (pair, sampled) in cuts.windows(2).zip(builder.first(&cuts)) {
            builder.add([pair[0], pair[1]], &sampled, 0, f64::INFINITY);
        }
        let Builder { mut panels, sum, mut worst, scale, heights, is_by_heights, .. } = builder;
        // A polynomial through heights has a slope that differs by ORDER^2 over half a panel times theirs.
        let rounding = profile.rounding(heights, scale[1]);
        let mut end_error = worst;
        if is_by_heights {
            let amplified = (ORDER * ORDER * panels.len()) as f64 / (0.5 * (PI - start));
            // What jumps from panel to panel is conjugated to logarithms of either, down to the nodes next to the ends.
            let conjugated = FRAC_2_PI * (1.0 + 2.0 * ((ORDER * ORDER * panels.len()) as f64).ln());
            end_error = worst + amplified * rounding;
            worst += amplified * conjugated * rounding;
        }
        // By parts the heights at the ends of the panels remain, extrapolated from the nodes, each with its own rounding.
        let mode_error = rounding * ORDER as f64 * (panels.len() as f64).sqrt();
        let local = Local { profile, is_odd };
        let is_bend = |at: f64| is_among(&bends, at) || !is_odd && at == PI;
        // By heights what is no jump is rounding, and spreads where it is made to meet.
        let may_jump = |at: f64| match local.power(at) {
            Some(power) => is_bend(at) && power < CONSTANT,
            None => is_by_heights || is_bend(at),
        };
        // A power above zero of the distance may stand where only higher derivatives are known to jump.
        let is_cusp = |at: f64| {
            (is_bend(at) || is_among(&joints, at)) && local.power(at).is_none_or(|p| p >= CONSTANT)
        };
        let cusped = follow_cusps(&mut panels, &local, ROUNDING * scale[1], is_cusp);
        let jumps = join(&mut panels, is_odd, HARMLESS * scale[1], may_jump);
        worst += cusped;
        let largest =
            panels.iter().flat_map(|p| p.values).fold(0.0f64, |most, v| most.max(v.abs()));
        let mean = sum / (PI - start);
        let mut slopes = Self {
            panels,
            is_odd,
            jumps,
            bends: bends.to_vec(),
            is_cusped: cusped > 0.0,
            mean,
            error: worst,
            end_error,
            mode_error,
            largest,
            series: None,
            first: OnceLock::new(),
        };
        if slopes.jumps.is_empty() && !slopes.is_cusped {
            slopes.series = slopes.short_series();
        }
        slopes
    }

    /// The series of the slope on panels, if it is short.
    fn short_series(&self) -> Option<Harmonics> {
        if self.finest() < FINEST {
            return None;
        }
        let allowed = ROUNDING * self.largest;
        COUNTS.into_iter().find_map(|count| {
            Harmonics::of_nodes(self.nodes(), self.is_odd, count).if_short(allowed)
        })
    }

    /// The angles at which `g` falls at once, and by how much: there `F` is plus infinity.
    pub fn hollows(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let is_bend = |at: f64| self.bends.contains(&at) || !self.is_odd && at == PI;
        self.jumps.iter().copied().filter(move |(at, jump)| *jump < 0.0 && is_bend(*at))
    }

    /// Nodes with their values of `g` and weights.
    fn nodes(&self) -> impl Iterator<Item = (f64, f64, f64)> + '_ {
        self.panels.iter().flat_map(|panel| {
            let (middle, half) = (panel.middle(), panel.half());
            (0..ORDER).map(move |i| {
                (middle + half * RULE.nodes[i], panel.values[i], half * RULE.weights[i])
            })
        })
    }

    /// Number of panels.
    pub fn panels(&self) -> usize {
        self.panels.len()
    }

    /// How many terms are summed for a value.
    #[must_use]
    pub fn terms(&self) -> usize {
        self.series.as_ref().map_or(ORDER * self.panels.len(), |series| series.cosines().len())
    }

    /// Whether it is the slope over a half turn, odd beyond it.
    #[must_use]
    pub fn is_odd(&self) -> bool {
        self.is_odd
    }

    /// Largest `|g|`.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// Shortest panel.
    fn finest(&self) -> f64 {
        self.panels.iter().fold(PI, |least, panel| least.min(2.0 * panel.half()))
    }

    /// How far from an end of a half turn, 0 or `pi`, `g` is one polynomial.
    #[must_use]
    pub fn reach(&self, end: f64) -> f64 {
        let panel = if end == 0.0 { self.panels.first() } else { self.panels.last() };
        panel.map_or(PI, |panel| 2.0 * panel.half())
    }

    /// Mean of `f` over the angle.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Estimated error of `F`.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.error + 4.0 * f64::EPSILON * self.largest
    }

    /// The same at the ends of the interval.
    #[must_use]
    pub fn end_error(&self) -> f64 {
        self.end_error + 4.0 * f64::EPSILON * self.largest
    }

    /// Rounding of each of the first coefficients of `f`.
    #[must_use]
    pub fn mode_error(&self) -> f64 {
        self.mode_error
    }

    /// Whether equally spaced samples gave all, whatever the panels.
    pub fn is_sampled(&self) -> bool {
        self.series.is_some() && self.panels.is_empty()
    }

    /// The short series of `F` and `f`, where there is one.
    pub fn series(&self) -> Option<&Harmonics> {
        self.series.as_ref()
    }

    /// `F(phi)`.
    pub fn conjugate(&self, angle: f64) -> f64 {
        let is_at = |at: f64| at == angle || !self.is_odd && at == angle + TAU;
        if let Some((_, jump)) = self.jumps.iter().find(|(at, _)| is_at(*at)) {
            return -jump * f64::INFINITY;
        }
        if let Some(series) = &self.series {
            return series.conjugate(angle);
        }
        let sum: f64 = if self.is_odd {
            // g(-t) cot((-t - phi)/2) = g(t) cot((t + phi)/2)
            self.panels.iter().map(|panel| panel.both_cotangents(angle)).sum()
        } else {
            self.panels.iter().map(|panel| panel.cotangent(angle)).sum()
        };
        -sum / TAU
    }

    /// `int g(t) ln|2 cos(t/2)| dt` over a whole turn; none where panels do not resolve `g`.
    ///
    /// Parts of panels are no longer than they are away from `pi`, where the logarithm has its pole.
    pub fn turning(&self) -> Option<f64> {
        if self.panels.is_empty() || self.is_cusped {
            return None;
        }
        let mut sum = 0.0;
        for panel in &self.panels {
            // Beside the pole of the logarithm what is shorter than rounding counts for its rounding only.
            let mut open = vec![[panel.start, panel.end]];
            while let Some([start, end]) = open.pop() {
                let middle = 0.5 * (start + end);
                let away = (PI - end).min(PI + start);
                if end - start <= away
                    || middle <= start
                    || middle >= end
                    || away + end - start < ROUNDING
                {
                    sum +=
                        integral(start, end, |t| panel.at(t) * (2.0 * (0.5 * t).cos().abs()).ln());
                } else {
                    open.extend([[start, middle], [middle, end]]);
                }
            }
        }
        Some(sum)
    }

    /// `f_0 .. f_degree` over a half turn.
    pub fn coefficients(&self, degree: usize) -> Vec<f64> {
        let mut coefficients = vec![0.0; degree + 1];
        coefficients[0] = self.mean;
        if let Some(series) = &self.series {
            coefficients[1..].iter_mut().zip(series.coefficients(degree)).for_each(|(c, f)| *c = f);
            return coefficients;
        }
        for panel in &self.panels {
            let parts = (degree as f64 * panel.half() / 6.0).ceil().max(1.0);
            let half = panel.half() / parts;
            for part in 0..parts as usize {
                let middle = panel.start + half * (2.0 * part as f64 + 1.0);
                for i in 0..ORDER {
                    let angle = middle + half * RULE.nodes[i];
                    let value = if parts > 1.0 { panel.at(angle) } else { panel.values[i] };
                    let mass = half * RULE.weights[i] * value;
                    let (sine, cosine) = angle.sin_cos();
                    let (mut below, mut sk) = (0.0, sine);
                    for coefficient in &mut coefficients[1..] {
                        *coefficient -= mass * sk;
                        (below, sk) = (sk, 2.0 * cosine * sk - below);
                    }
                }
            }
        }
        for (k, coefficient) in coefficients.iter_mut().enumerate().skip(1) {
            *coefficient *= 2.0 / (PI * k as f64);
        }
        coefficients
    }

    /// `sum_{k >= 1} f_k (side/w)^k` for `w > 1`, given `w - 1`, and `side = 1` beyond `t = 0` or `-1` beyond `t = pi`.
    pub fn outside(&self, excess: f64, side: f64) -> f64 {
        if let Some(series) = self.series.as_ref().filter(|_| self.is_odd) {
            return series.outside(side / (1.0 + excess));
        }
        if excess >= REMOTE && self.is_odd {
            let terms = self.first.get_or_init(|| self.coefficients(FIRST));
            let ratio = side / (1.0 + excess);
            return terms[1..].iter().rev().fold(0.0, |sum, f| ratio * (f + sum));
        }
        // sum (side/w)^k sin(k t)/k by parts: an angle that turns within w - 1 of the end
        let kernel = |angle: f64| {
            let s = (0.5 * angle).sin();
            let c = (0.5 * angle).cos();
            if side > 0.0 {
                angle.sin().atan2(excess + 2.0 * s * s)
            } else {
                -angle.sin().atan2(excess + 2.0 * c * c)
            }
        };
        let end = if side > 0.0 { 0.0 } else { PI };
        let depth = excess.ln_1p();
        let mut stack: Vec<(usize, f64, f64)> =
            self.panels.iter().enumerate().map(|(i, panel)| (i, panel.start, panel.end)).collect();
        let mut sum = 0.0;
        while let Some((i, start, finish)) = stack.pop() {
            let (middle, half) = (0.5 * (start + finish), 0.5 * (finish - start));
            let panel = &self.panels[i];
            if half > 0.4 * (middle - end).hypot(depth) && half > 1e-15 {
                stack.push((i, start, middle));
                stack.push((i, middle, finish));
                continue;
            }
            let is_whole = start == panel.start && finish == panel.end;
            if is_whole {
                sum += side * panel.turned(excess, side);
                continue;
            }
            for n in 0..ORDER {
                let angle = middle + half * RULE.nodes[n];
                sum += half * RULE.weights[n] * panel.at(angle) * kernel(angle);
            }
        }
        -2.0 / PI * sum
    }
}

/// From the least to the largest.
fn ascending(places: &[f64]) -> Vec<f64> {
    let mut places = places.to_vec();
    places.sort_by(f64::total_cmp);
    places
}

/// Whether a place is one of these, which ascend.
fn is_among(places: &[f64], at: f64) -> bool {
    places.get(places.partition_point(|place| *place < at)) == Some(&at)
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Series(Vec<f64>, bool);

    impl Angular for Series {
        fn height(&self, angle: f64) -> f64 {
            self.0.iter().enumerate().map(|(k, f)| f * (k as f64 * angle).cos()).sum()
        }

        fn slope(&self, angle: f64) -> Option<f64> {
            let terms = self.0.iter().enumerate().map(|(k, f)| (k as f64, f));
            self.1.then(|| terms.map(|(k, f)| -k * f * (k * angle).sin()).sum())
        }
    }

    #[test]
    fn a_series_gives_itself() {
        // Of heights alone the derivative loses digits on short panels.
        gives_itself(true, 5e-13);
        gives_itself(false, 1e-10);
    }

    fn gives_itself(has_slope: bool, tolerance: f64) {
        let series = Series(vec![0.3, -1.0, 0.5, 0.25, 0.0, 0.0, 0.0, 2.0], has_slope);
        let slopes = Conjugate::resolve(&series, [&[0.7], &[1.9]], [8, 1], 0.0);
        for angle in [0.0, 1e-9, 0.01, 0.391, 0.7, 1.5, 3.0, 3.139, PI] {
            let exact: f64 = (series.0.iter().enumerate())
                .map(|(k, f)| k as f64 * f * (k as f64 * angle).cos())
                .sum();
            let found = slopes.conjugate(angle);
            assert!((found - exact).abs() < tolerance, "{angle}: {found} {exact}");
        }
        for (found, exact) in slopes.coefficients(60).iter().zip(&series.0) {
            assert!((found - exact).abs() < tolerance.max(2e-14), "{found} {exact}");
        }
        for (excess, side) in [(1e-12, 1.0), (1e-6, -1.0), (0.01, -1.0), (0.3, 1.0), (5.0, -1.0)] {
            let exact: f64 = (series.0.iter().enumerate().skip(1))
                .map(|(k, f)| f * (side / (1.0f64 + excess)).powi(k as i32))
                .sum();
            let found = slopes.outside(excess, side);
            assert!(
                (found - exact).abs() < tolerance.max(1e-13),
                "{excess} {side}: {found} {exact}"
            );
        }
    }

    #[test]
    fn a_wave_gives_itself() {
        struct Wave;
        impl Angular for Wave {
            fn height(&self, t: f64) -> f64 {
                (3.0 * t).sin() + 0.5 * t.cos()
            }
            fn slope(&self, t: f64) -> Option<f64> {
                Some(3.0 * (3.0 * t).cos() - 0.5 * t.sin())
            }
        }
        let slopes = Conjugate::resolve(&Wave, [&[], &[]], [8, 2], 0.0);
        for t in [-PI, -1.0, 0.0, 0.2, 3.0] {
            let exact = 3.0 * (3.0 * t).sin() + 0.5 * t.cos();
            assert!((slopes.conjugate(t) - exact).abs() < 1e-13);
        }
    }
}
