//! The Fourier series of a smooth slope: a few harmonics instead of integrals over panels.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::LazyLock;

use super::accuracy::{GOLDEN, ROUNDING};
use super::angular::Angular;

/// `F = sum k (f_k cos(k t) + h_k sin(k t))`, the conjugate of the slope of `f = mean + sum f_k cos(k t) + h_k sin(k t)`.
#[derive(Debug, Clone, Default)]
pub struct Harmonics {
    /// `k f_k` from `k = 1`.
    cosines: Vec<f64>,
    /// `k h_k` from `k = 1`; empty for an even `f`.
    sines: Vec<f64>,
}

/// What equally spaced samples tell of a smooth profile.
#[derive(Default)]
pub(crate) struct Resolved {
    pub(super) series: Harmonics,
    /// Mean of `f` over the angle.
    pub(super) mean: f64,
    /// Largest `|g|` and `|f|`.
    pub(super) largest: f64,
    pub(super) heights: f64,
}

/// Numbers of samples over a half turn. At half or twice 19 of 32 answers change, within what they state (survey).
const SAMPLES: [usize; 2] = [32, 64];
/// Sines of a turn in four times so many parts.
static TABLES: LazyLock<[Vec<f64>; 2]> = LazyLock::new(|| {
    let sine = |m: usize, samples: usize| (FRAC_PI_2 * m as f64 / samples as f64).sin();
    SAMPLES.map(|samples| (0..4 * samples).map(|m| sine(m, samples)).collect())
});
/// Places at which the series is held against the slope: a feature between the samples must not be missed. At half or twice 2 of 32 answers change, within what they state (survey).
const CHECKED: usize = 7;

impl Harmonics {
    /// The series by equally spaced samples of the slope, where it is known and smooth; with `is_odd` over a half turn, else over a whole one.
    pub(super) fn sampled(profile: &dyn Angular, is_odd: bool) -> Option<Resolved> {
        profile.slope(1.0)?;
        SAMPLES.into_iter().find_map(|samples| Self::from_samples(profile, is_odd, samples))
    }

    fn from_samples(profile: &dyn Angular, is_odd: bool, samples: usize) -> Option<Resolved> {
        let (count, start) = if is_odd { (samples, 0.0) } else { (2 * samples, -PI) };
        let step = PI / samples as f64;
        let mut cosines = vec![0.0; samples - 1];
        let mut sines = vec![0.0; if is_odd { 0 } else { samples - 1 }];
        let (mut mean, mut largest, mut heights) = (0.0, 0.0f64, 0.0f64);
        let share = if is_odd { 2.0 } else { 1.0 } / samples as f64;
        let table = &TABLES[usize::from(samples != SAMPLES[0])];
        let angles: Vec<f64> = (0..count).map(|j| start + step * (j as f64 + 0.5)).collect();
        for (j, (height, slope)) in profile.tangents(&angles).into_iter().enumerate() {
            let value = slope?;
            mean += height / count as f64;
            heights = heights.max(height.abs());
            largest = largest.max(value.abs());
            let mass = share * value;
            let sign = if is_odd { 1.0 } else { -1.0 };
            // The harmonics at this sample are entries of one table: the angle counts from the start, half a turn off in a whole turn.
            let (quarter, turn) = (samples, 4 * samples);
            let (mut entry, mut mass) = (0, mass * sign);
            for (k, term) in cosines.iter_mut().enumerate() {
                entry = (entry + 2 * j + 1) % turn;
                *term -= mass * table[entry];
                if let Some(term) = sines.get_mut(k) {
                    *term += mass * table[(entry + quarter) % turn];
                }
                mass *= sign;
            }
        }
        let allowed = ROUNDING * largest;
        if !mean.is_finite() {
            return None;
        }
        let series = Self { cosines, sines }.if_short(allowed)?;
        let reach = PI - start;
        let meets = |i: usize| {
            let angle = start + reach * (i as f64 * GOLDEN).fract();
            let slope = profile.slope(angle).unwrap_or(f64::NAN);
            (series.slope(angle) - slope).abs() <= CHECKED as f64 * allowed
        };
        (1..=CHECKED).all(meets).then_some(Resolved { series, mean, largest, heights })
    }

    /// `g = -sum k f_k sin(k t) + sum k h_k cos(k t)`.
    fn slope(&self, angle: f64) -> f64 {
        let (sine, cosine) = angle.sin_cos();
        clenshaw(&self.sines, cosine)[0] - sine * clenshaw(&self.cosines, cosine)[1]
    }

    /// `f_1 .. f_degree`, zero from some degree on.
    pub fn coefficients(&self, degree: usize) -> impl Iterator<Item = f64> + '_ {
        let terms = self.cosines.iter().chain(std::iter::repeat(&0.0));
        terms.take(degree).enumerate().map(|(k, term)| term / (k + 1) as f64)
    }

    /// The highest harmonic.
    pub fn highest(&self) -> usize {
        self.cosines.len().max(self.sines.len())
    }

    /// The series of `f - mean`, the conjugate of which is that of the slope: its [conjugate](Self::conjugate) are the heights.
    pub fn heights(&self) -> Self {
        let divided = |terms: &[f64]| -> Vec<f64> {
            terms.iter().enumerate().map(|(k, term)| term / (k + 1) as f64).collect()
        };
        Self { cosines: divided(&self.cosines), sines: divided(&self.sines) }
    }

    /// `k f_k` from `k = 1`.
    pub fn cosines(&self) -> &[f64] {
        &self.cosines
    }

    /// Of the slope with these values and weights at angles, over one half turn or a whole one.
    pub(super) fn of_nodes(
        nodes: impl Iterator<Item = (f64, f64, f64)>,
        is_odd: bool,
        count: usize,
    ) -> Self {
        let turns = if is_odd { 2.0 } else { 1.0 };
        let mut cosines = vec![0.0; count];
        let mut sines = vec![0.0; if is_odd { 0 } else { count }];
        for (angle, value, weight) in nodes {
            add(&mut cosines, &mut sines, turns / PI * weight * value, angle);
        }
        Self { cosines, sines }
    }

    /// The same without what is rounding, if that are all harmonics of the last third; `allowed` is its size.
    pub(super) fn if_short(self, allowed: f64) -> Option<Self> {
        let is_rounding = |terms: &[f64]| {
            let tail = 2 * terms.len() / 3;
            terms.iter().skip(tail).all(|term| term.abs() <= allowed)
        };
        let is_short = is_rounding(&self.cosines) && is_rounding(&self.sines);
        is_short.then(|| self.without(0.1 * allowed))
    }

    /// Without the last terms below a threshold.
    fn without(mut self, threshold: f64) -> Self {
        for terms in [&mut self.cosines, &mut self.sines] {
            let kept = terms.iter().rposition(|t| t.abs() > threshold).map_or(0, |last| last + 1);
            terms.truncate(kept);
        }
        self
    }

    /// `F(t)`.
    pub fn conjugate(&self, angle: f64) -> f64 {
        let (sine, cosine) = angle.sin_cos();
        let [even, _] = clenshaw(&self.cosines, cosine);
        let [_, odd] = clenshaw(&self.sines, cosine);
        even + odd * sine
    }

    /// `sum f_k ratio^k`.
    pub fn outside(&self, ratio: f64) -> f64 {
        self.cosines
            .iter()
            .enumerate()
            .rev()
            .fold(0.0, |sum, (k, term)| ratio * (term / (k + 1) as f64 + sum))
    }
}

/// Adds what a slope `mass` at an angle has of each harmonic.
fn add(cosines: &mut [f64], sines: &mut [f64], mass: f64, angle: f64) {
    let (sine, cosine) = angle.sin_cos();
    let (mut s, mut c) = (sine, cosine);
    for (k, term) in cosines.iter_mut().enumerate() {
        *term -= mass * s;
        if let Some(term) = sines.get_mut(k) {
            *term += mass * c;
        }
        (s, c) = (s * cosine + c * sine, c * cosine - s * sine);
    }
}

/// `sum c_k cos(k t)` and `sum c_k sin(k t)/sin t`, `k >= 1`, by Clenshaw's recurrence.
fn clenshaw(terms: &[f64], cosine: f64) -> [f64; 2] {
    let (mut next, mut after) = (0.0, 0.0);
    for c in terms.iter().rev() {
        (next, after) = (c + 2.0 * cosine * next - after, next);
    }
    [cosine * next - after, next]
}

#[cfg(test)]
mod tests {
    use super::super::Conjugate;
    use super::*;

    struct Wave;

    impl Angular for Wave {
        fn height(&self, angle: f64) -> f64 {
            0.3 * (3.0 * angle + 0.4).cos() + 0.01 * (7.0 * angle).sin()
        }

        fn slope(&self, angle: f64) -> Option<f64> {
            Some(-0.9 * (3.0 * angle + 0.4).sin() + 0.07 * (7.0 * angle).cos())
        }
    }

    #[test]
    fn harmonics_have_their_own_conjugates() {
        // Of cos(k t + a) it is k cos(k t + a).
        // A bend that is none keeps the panels.
        let slopes = Conjugate::resolve(&Wave, [&[0.7], &[]], [8, 2], 0.0);
        let series = slopes.series().unwrap();
        let sampled = Harmonics::sampled(&Wave, false).unwrap();
        assert!(sampled.mean.abs() < 1e-15);
        for i in -20..=20 {
            let t = 0.15 * f64::from(i);
            let exact = 0.9 * (3.0 * t + 0.4).cos() + 0.07 * (7.0 * t).sin();
            for found in [series.conjugate(t), sampled.series.conjugate(t)] {
                assert!((found - exact).abs() < 1e-13, "{t}: {found} {exact}");
            }
        }
    }
}
