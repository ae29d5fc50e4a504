//! The Gaussian filter of ISO 16610-21, with ends that keep moments (ISO 16610-28).

use std::f64::consts::{LN_2, PI};

/// How far the weights reach, in cutoffs: beyond they are below `exp(-pi (1.5/alpha)^2) = 1e-14` of the largest.
const REACH: f64 = 1.5;
/// The result is given at this many points for each cutoff at least, where the trace has them. Between them a spline is off by `(2 pi h/lambda)^4/384` of a wave of length `lambda`, of
/// which the filter lets pass `exp(-pi (alpha cutoff/lambda)^2)`: together at most 2e-5 of what the trace had of it.
const POINTS: f64 = 20.0;
/// The fewest points of the trace for a cutoff, everywhere: beside a hole of a quarter of the cutoff a wave twice as long as that is off by 4 % of its amplitude, of half of it by 21 %. A wave is seen through `n` points of each cutoff as one with `n` waves less for each cutoff, too, of which the weights let pass `2^-(n-1)^2` where of the wave as long as the
/// cutoff one half is due: with 4 points 0.002, with 3 already 0.06.
const FEWEST: f64 = 4.0;

/// Positions and heights.
type Points = (Vec<f64>, Vec<f64>);

/// The trace without waves much shorter than a cutoff (m), of which half the amplitude is left: the mean of the heights with weights `exp(-pi (d/(alpha cutoff))^2)`,
/// `alpha = sqrt(ln 2/pi)`, each for the length that its point stands for.
///
/// Near an end the weights are cut off; a mean would follow the trace away from its slope there. The filter keeps the first moment: it is the value of the weighted line of least squares, which in
/// the middle is the mean, and which leaves straight lines as they are up to their ends. A `period` goes on round its ends.
///
/// # Errors
/// A cutoff that is not positive, that the trace does not resolve, or that is longer than it.
pub(super) fn gaussian(
    x: &[f64],
    f: &[f64],
    cutoff: f64,
    is_periodic: bool,
    shown: &dyn Fn(f64) -> String,
) -> Result<Points, String> {
    let (first, last) = (x[0], x[x.len() - 1]);
    let length = last - first;
    if !(cutoff.is_finite() && cutoff > 0.0) {
        return Err(format!(
            "the cutoff of the filter is {}: must be greater than zero",
            shown(cutoff)
        ));
    }
    if cutoff > length {
        return Err(format!(
            "the cutoff of the filter, {}, is longer than the trace, {}: take off its mean line instead, by `level`",
            shown(cutoff),
            shown(length)
        ));
    }
    let (mut widest, mut from) = (0.0, first);
    for pair in x.windows(2) {
        if pair[1] - pair[0] > widest {
            (widest, from) = (pair[1] - pair[0], pair[0]);
        }
    }
    // To rounding, which distances have.
    if cutoff < FEWEST * widest * (1.0 - f64::EPSILON.sqrt()) {
        return Err(format!(
            "the cutoff of the filter, {}, is less than {FEWEST} times the distance of neighbouring points, {} from x = {} on: too few there for a filter of that cutoff; take a longer one, or none, \
             or fill in what is missing",
            shown(cutoff),
            shown(widest),
            shown(from)
        ));
    }
    let samples = Samples::new(x, f, cutoff, is_periodic);
    let most = (POINTS * length / cutoff).ceil() as usize + 1;
    let places: Vec<f64> = if x.len() <= most {
        x.to_vec()
    } else {
        let step = length / (most - 1) as f64;
        (0..most).map(|i| if i + 1 == most { last } else { first + step * i as f64 }).collect()
    };
    let mut heights: Vec<f64> = places.iter().map(|place| samples.line(*place)).collect();
    if is_periodic && let [start, .., end] = heights.as_mut_slice() {
        // The same place, and the same number.
        *end = *start;
    }
    Ok((places, heights))
}

/// Points with the lengths that they stand for; of a period with its neighbours.
struct Samples {
    x: Vec<f64>,
    f: Vec<f64>,
    length: Vec<f64>,
    /// `alpha cutoff`.
    width: f64,
    reach: f64,
}

impl Samples {
    fn new(x: &[f64], f: &[f64], cutoff: f64, is_periodic: bool) -> Self {
        let reach = REACH * cutoff;
        let (mut x, mut f) = (x.to_vec(), f.to_vec());
        if is_periodic {
            (x, f) = repeated(&x, &f, reach);
        }
        let last = x.len() - 1;
        let length =
            (0..=last).map(|i| 0.5 * (x[(i + 1).min(last)] - x[i.saturating_sub(1)])).collect();
        Self { x, f, length, width: (LN_2 / PI).sqrt() * cutoff, reach }
    }

    /// The value at a place of the line of least squares with the weights around it.
    fn line(&self, place: f64) -> f64 {
        let from = self.x.partition_point(|x| *x < place - self.reach);
        let to = self.x.partition_point(|x| *x <= place + self.reach);
        let [mut weight, mut first, mut second, mut mean, mut moment] = [0.0; 5];
        for i in from..to {
            let d = (self.x[i] - place) / self.width;
            let w = self.length[i] * (-PI * d * d).exp();
            weight += w;
            first += w * d;
            second += w * d * d;
            mean += w * self.f[i];
            moment += w * d * self.f[i];
        }
        let determinant = weight * second - first * first;
        // A single point within reach has no slope.
        if determinant > f64::EPSILON * weight * second {
            (second * mean - first * moment) / determinant
        } else if weight > 0.0 {
            mean / weight
        } else {
            super::level::between(&self.x, &self.f, place)
        }
    }
}

/// A period with as much of its neighbours as the weights reach; its last point is its first.
fn repeated(x: &[f64], f: &[f64], reach: f64) -> Points {
    let last = x.len() - 1;
    let (first, period) = (x[0], x[last] - x[0]);
    let mut points: Vec<(f64, f64)> = Vec::new();
    let copies = (reach / period).ceil().max(1.0) as i64;
    for copy in -copies..=copies {
        let shift = copy as f64 * period;
        points.extend((0..last).map(|i| (x[i] + shift, f[i])));
    }
    points.push((x[last] + copies as f64 * period, f[0]));
    points.retain(|(x, _)| *x >= first - reach && *x <= first + period + reach);
    points.into_iter().unzip()
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn shown(length: f64) -> String {
        format!("{length} m")
    }

    fn even(count: usize, length: f64) -> Vec<f64> {
        (0..count).map(|i| length * i as f64 / (count - 1) as f64).collect()
    }

    /// Amplitude that ISO 16610-21 lets pass: `exp(-pi (alpha cutoff/lambda)^2)`.
    fn passed(cutoff: f64, wave: f64) -> f64 {
        (-LN_2 * (cutoff / wave).powi(2)).exp()
    }

    #[test]
    fn waves_pass_as_the_standard_says() {
        let x = even(4001, 20.0);
        for wave in [0.5, 0.8, 1.0, 2.0, 8.0] {
            let f: Vec<f64> = x.iter().map(|x| (2.0 * PI * x / wave).cos()).collect();
            let (places, heights) = gaussian(&x, &f, 0.8, false, &shown).unwrap();
            let middle = places.iter().zip(&heights).filter(|(x, _)| (3.0..17.0).contains(*x));
            for (x, height) in middle {
                let exact = passed(0.8, wave) * (2.0 * PI * x / wave).cos();
                assert!((height - exact).abs() < 1e-9, "{wave} at {x}: {height} for {exact}");
            }
        }
        assert!((passed(0.8, 0.8) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn lines_are_kept_to_their_ends_whatever_the_spacing() {
        let mut x = even(300, 5.0);
        x.iter_mut().enumerate().for_each(|(i, x)| *x += 0.004 * (7.0 * i as f64).sin());
        let f: Vec<f64> = x.iter().map(|x| 2.0 - 3.0 * x).collect();
        let (places, heights) = gaussian(&x, &f, 0.8, false, &shown).unwrap();
        assert_eq!([places[0], places[places.len() - 1]], [x[0], x[299]]);
        for (x, height) in places.iter().zip(heights) {
            assert!((height - (2.0 - 3.0 * x)).abs() < 1e-11, "{x}");
        }
    }

    #[test]
    fn a_period_goes_on_round_its_ends() {
        let x = even(801, 4.0);
        let f: Vec<f64> = x.iter().map(|x| (PI * x + 1.0).sin()).collect();
        let (places, heights) = gaussian(&x, &f, 0.8, true, &shown).unwrap();
        assert_eq!(heights[0], heights[heights.len() - 1]);
        for (x, height) in places.iter().zip(&heights) {
            let exact = passed(0.8, 2.0) * (PI * x + 1.0).sin();
            assert!((height - exact).abs() < 1e-9, "{x}: {height} for {exact}");
        }
        // Ends that keep the first moment alone are off by the bend there.
        let (_, cut) = gaussian(&x, &f, 0.8, false, &shown).unwrap();
        assert!((cut[0] - heights[0]).abs() > 1e-3);
    }

    /// With the fewest points a wave as long as the cutoff is seen as one of a third of that, too, of which `2^-9` is let pass.
    #[test]
    fn the_fewest_points_make_the_filter_that_is_stated() {
        let x = even(401, 100.0);
        for phase in [0.0, 0.4, 1.1] {
            let f: Vec<f64> = x.iter().map(|x| (2.0 * PI * x + phase).cos()).collect();
            let (_, heights) = gaussian(&x, &f, 1.0, false, &shown).unwrap();
            for (f, height) in f.iter().zip(&heights).take(300).skip(100) {
                let bound = 0.5f64.powi(9) * (1.0 + 1e-3);
                assert!((height - 0.5 * f).abs() <= bound, "{height} for {}", 0.5 * f);
            }
        }
    }

    /// What is said of holes, and why they are refused: the line of least squares beside one follows one side, and then the other.
    #[test]
    fn beside_a_hole_the_line_leaves_the_filter() {
        let whole = even(4001, 20.0);
        for (hole, about) in [(0.25, 0.04), (0.5, 0.21)] {
            let x: Vec<f64> =
                whole.iter().copied().filter(|x| (x - 10.0).abs() >= 0.4 * hole).collect();
            let off = (0..13).map(|phase| {
                let wave = |x: &f64| (TAU * x / 1.6 + 0.5 * f64::from(phase)).cos();
                let [all, some] = [&whole, &x]
                    .map(|x| Samples::new(x, &x.iter().map(wave).collect::<Vec<_>>(), 0.8, false));
                let places = (0..400).map(|i| 9.0 + f64::from(i) / 200.0);
                places.map(|x| (all.line(x) - some.line(x)).abs()).fold(0.0, f64::max)
            });
            let worst = off.fold(0.0, f64::max);
            assert!((worst / about - 1.0).abs() < 0.15, "{hole}: {worst}");
        }
    }

    #[test]
    fn a_cutoff_must_suit_the_trace() {
        let x = even(11, 1.0);
        let said = |cutoff: f64| gaussian(&x, &x, cutoff, false, &shown).unwrap_err();
        assert!(said(0.39).contains("less than 4 times"), "{}", said(0.39));
        assert!(gaussian(&x, &x, 0.4, false, &shown).is_ok());
        assert!(said(2.0).contains("longer than the trace"));
        assert!(said(-1.0).contains("greater than zero") && said(f64::NAN).contains("NaN"));
        // A hole in a fine trace: the line of least squares beside it would follow one side alone, and jump.
        let holed: Vec<f64> =
            even(4001, 20.0).into_iter().filter(|x| !(9.0..=10.0).contains(x)).collect();
        let refused = gaussian(&holed, &holed, 3.9, false, &shown).unwrap_err();
        assert!(refused.contains("1.01") && refused.contains("x = 8.99"), "{refused}");
        assert!(gaussian(&holed, &holed, 4.1, false, &shown).is_ok());
    }
}
