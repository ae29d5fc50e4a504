//! A wave of few harmonics: known from few samples, and turned without others.

use std::f64::consts::PI;

use fredholm::inversion::{Angular, Conjugate, Harmonics};

use super::problem::{Sample, SmoothProblem, SmoothProfile};
use crate::contact::accuracy::SAFETY;

/// Samples for each harmonic, and at least. At half or twice 5 of 24 answers change, within what they state (survey).
const A_HARMONIC: usize = 16;
const FEWEST: usize = 256;

/// The profile of a wave over the angle `pi xi`.
pub(super) struct Turn<'p>(pub(super) &'p SmoothProfile);

impl Angular for Turn<'_> {
    fn height(&self, angle: f64) -> f64 {
        (self.0.height)(angle / PI)
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        self.0.slope.as_ref().map(|slope| slope(angle / PI) / PI)
    }
}

/// A place moved by whole periods into `-1 .. 1`.
pub(super) fn wrapped(xi: f64) -> f64 {
    match xi.abs() {
        size if size < 1.0 => xi,
        size if size < 3.0 => xi - 2f64.copysign(xi),
        _ => xi - 2.0 * (0.5 * xi).round(),
    }
}

/// The slope of a wave as a short series that its heights confirm.
pub(super) struct Band {
    pub(super) slopes: Conjugate,
    /// `(xi, f0)` from `-1` to `1`, equally spaced by a power of one half.
    pub(super) samples: Vec<Sample>,
}

impl Band {
    /// The series of the profile, if it has one.
    pub(super) fn of(problem: &SmoothProblem) -> Option<Self> {
        let profile = &problem.profile;
        if problem.pieces != [[-1.0, 1.0]] || !profile.breaks.is_empty() {
            return None;
        }
        let slopes = Conjugate::sampled(&Turn(profile), false)?;
        let series = slopes.series()?.heights();
        let count = (A_HARMONIC * series.highest()).max(FEWEST).next_power_of_two();
        let allowed = SAFETY * slopes.mode_error();
        let mut samples = Vec::with_capacity(count + 1);
        for i in 0..=count {
            let xi = 2.0 * i as f64 / count as f64 - 1.0;
            let height = (profile.height)(xi);
            let error = (slopes.mean() + series.conjugate(PI * xi) - height).abs();
            // A feature that the series does not know is left to panels.
            if error.is_nan() || error > allowed {
                return None;
            }
            samples.push((xi, height));
        }
        Some(Self { slopes, samples })
    }

    /// Samples of the profile seen from a place, which becomes `-1` and `1`.
    pub(super) fn turned(&self, place: f64) -> Vec<Sample> {
        let series = self.slopes.series().map(Harmonics::heights);
        let height = |xi: f64| match &series {
            Some(series) => self.slopes.mean() + series.conjugate(PI * (xi - 1.0 + place)),
            None => f64::NAN,
        };
        self.samples.iter().map(|(xi, _)| (*xi, height(*xi))).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::contact::smooth::{SmoothKernel, SmoothProfile};
    use crate::deadline::Deadline;
    use crate::{Load, Rotational, Vertical};

    fn wave(height: fn(f64) -> f64, slope: fn(f64) -> f64) -> SmoothProblem {
        let profile = SmoothProfile {
            height: Arc::new(height),
            slope: Some(Arc::new(slope)),
            breaks: Vec::new(),
            joints: Vec::new(),
            tolerance: 0.0,
        };
        SmoothProblem {
            pieces: vec![[-1.0, 1.0]],
            kernel: SmoothKernel::Periodic { period: 2.0 },
            theta0: 1.0,
            load: Load::new(Vertical::Force(1.0), Rotational::Tilt(0.0)).unwrap(),
            profile,
            is_unilateral: true,
            deadline: Deadline::default(),
        }
    }

    #[test]
    fn a_sum_of_cosines_is_a_band() {
        let problem = wave(
            |x| 0.2 + (PI * x + 0.3).cos() - 0.1 * (6.0 * PI * x).sin(),
            |x| -PI * (PI * x + 0.3).sin() - 0.6 * PI * (6.0 * PI * x).cos(),
        );
        let band = Band::of(&problem).unwrap();
        assert!((band.slopes.mean() - 0.2).abs() < 1e-15);
        for (xi, height) in band.turned(0.2345) {
            let exact = (problem.profile.height)(xi + 1.2345);
            assert!((height - exact).abs() < 1e-14, "{xi}");
        }
    }

    #[test]
    fn a_bump_between_the_samples_of_the_slope_is_none() {
        // Of the width 0.002: the slope is sampled at steps of 1/32 and at a few places between.
        let problem = wave(
            |x| (PI * x).cos() + 1e-3 * (-((x - 0.25) / 0.002).powi(2)).exp(),
            |x| {
                let u = (x - 0.25) / 0.002;
                -PI * (PI * x).sin() - u * (-u * u).exp()
            },
        );
        assert!(Conjugate::sampled(&Turn(&problem.profile), false).is_some());
        assert!(Band::of(&problem).is_none());
    }
}
