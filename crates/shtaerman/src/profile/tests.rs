//! Enclosures of profiles on intervals of `xi`.

use super::Profile;
use crate::expression::Interval;
use crate::{Elastic, Foundation, Load, Problem, Punch, Rotational, Vertical};

/// Numbers between 0 and 1 from a linear congruential generator.
pub(super) struct Random(pub(super) u64);

impl Random {
    pub(super) fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.next()
    }
}

pub(super) fn profile(text: &str) -> Profile {
    Profile::expression(text).unwrap()
}

fn width(range: Interval) -> f64 {
    range.upper() - range.lower()
}

#[test]
fn ranges_on_short_intervals_are_about_those_of_the_samples() {
    for text in [
        "xi - xi^2",
        "exp(-(xi/0.1)^2) + x^2/3",
        "cos(30*xi) - xi",
        "sqrt(1.1 - xi)*x",
        "max(0, abs(xi)-0.3)^1.5",
        "xi*(1-xi)*(2-xi)*(3-xi)",
    ] {
        let profile = profile(text);
        let mut random = Random(7);
        for _ in 0..200 {
            let left = random.between(-1.0, 0.999);
            let right = left + 1e-3 * random.next();
            let range = profile.enclose([left, right], 2.0).unwrap();
            let sample = |i: i32| profile.height(left + (right - left) * f64::from(i) / 200.0, 2.0);
            let most = (0..=200).map(sample).fold(f64::NEG_INFINITY, f64::max);
            let least = (0..=200).map(sample).fold(f64::INFINITY, f64::min);
            let rounding = 1e-14;
            let place = format!("{text} on [{left}, {right}]: {range:?}, not [{least}, {most}]");
            assert!(
                range.lower() <= least + rounding && most - rounding <= range.upper(),
                "{place}"
            );
            assert!(width(range) <= 1.1 * (most - least) + 1e-13, "{place}");
        }
    }
}

#[test]
fn a_place_is_enclosed_to_rounding_with_the_computed_value() {
    let table = [
        // By mpmath 1.3 with 50 digits, at the exact values of the numbers.
        ("1e8 + x - 1e8", 0.1, 1.0, 0.1, 3e-8),
        ("cos(30*xi)", 0.7, 1.0, -0.547_729_260_224_268_1, 1e-14),
        ("sqrt(xi)", 0.0, 1.0, 0.0, 0.0),
        ("abs(x)/x", 0.5, 3.0, 1.0, 1e-15),
    ];
    for (text, xi, half_width, exact, rounding) in table {
        let profile = profile(text);
        let range = profile.enclose_at(xi, half_width).unwrap();
        let computed = profile.height(xi, half_width);
        assert!(range.contains(computed), "{text}: {range:?} without {computed}");
        assert!(range.contains(exact) || rounding > 0.0 && (range.lower() - exact).abs() < 1e-16);
        assert!(width(range) <= rounding, "{text}: {range:?}");
    }
    assert_eq!(profile("1/x").enclose_at(0.0, 1.0), None);
    assert_eq!(profile("1/x").enclose([-1.0, 1.0], 1.0), None);
    assert_eq!(profile("ln(x)").enclose([-1.0, 1.0], 1.0), None);
    assert_eq!(Profile::flat().enclose([-1.0, 1.0], 1.0), Some(Interval::ZERO));
}

/// The cubic of a piece by Hermite's basis, for its derivatives by differences.
fn hermite(points: &[f64], heights: &[f64], slopes: &[f64], x: f64) -> f64 {
    let piece = (points.partition_point(|&p| p <= x).max(1) - 1).min(points.len() - 2);
    let h = points[piece + 1] - points[piece];
    let t = (x - points[piece]) / h;
    heights[piece] * (1.0 + 2.0 * t) * (1.0 - t).powi(2)
        + heights[piece + 1] * t * t * (3.0 - 2.0 * t)
        + h * slopes[piece] * t * (1.0 - t).powi(2)
        - h * slopes[piece + 1] * t * t * (1.0 - t)
}

fn random_measured(random: &mut Random, count: usize, half_width: f64) -> [Vec<f64>; 2] {
    let mut points = vec![-half_width];
    let steps: Vec<f64> = (1..count).map(|_| random.between(0.1, 1.0)).collect();
    let total: f64 = steps.iter().sum();
    let mut sum = 0.0;
    for step in &steps[..count - 2] {
        sum += step;
        points.push(half_width * (2.0 * sum / total - 1.0));
    }
    points.push(half_width);
    let heights = points.iter().map(|_| random.between(-1e-6, 1e-6)).collect();
    [points, heights]
}

#[test]
fn measured_profiles_are_enclosed() {
    let mut random = Random(11);
    for count in [2, 3, 4, 9, 40] {
        let half_width = 0.02;
        let [points, heights] = random_measured(&mut random, count, half_width);
        let profile = Profile::from_points(points.clone(), heights.clone()).unwrap();
        let slope = |x: &f64| profile.slope(x / half_width, half_width).unwrap() / half_width;
        let slopes: Vec<f64> = points.iter().map(slope).collect();
        let value = |xi: f64| hermite(&points, &heights, &slopes, half_width * xi);
        for _ in 0..300 {
            let left = random.between(-1.0, 0.9);
            let right = left + random.between(1e-3, 0.1);
            let terms = profile.taylor([left, right], 4, half_width).unwrap();
            let inside: Vec<f64> = profile.joints(half_width);
            let is_single = !inside.iter().any(|&knot| left < knot && knot < right);
            assert!(terms[3].is_bounded());
            assert_eq!(terms[4].is_bounded(), is_single);
            let terms = profile.taylor([left, right], 7, half_width).unwrap();
            assert!(!is_single || terms[7].size() == 0.0);
            // Divided differences are means of the derivatives.
            let step = (right - left) / 3.0;
            let [a, b, c, d] = [0.0, 1.0, 2.0, 3.0].map(|i| value(left + i * step));
            let differences = [
                a,
                (b - a) / step,
                (c - 2.0 * b + a) / (2.0 * step * step),
                (d - 3.0 * c + 3.0 * b - a) / (6.0 * step.powi(3)),
            ];
            for (k, difference) in differences.into_iter().enumerate() {
                let rounding = 1e-20 / step.powi(k as i32);
                let (lower, upper) = (terms[k].lower() - rounding, terms[k].upper() + rounding);
                assert!(
                    lower <= difference && difference <= upper,
                    "{count}: {terms:?}, order {k}: {difference:e}"
                );
            }
            let at = profile.enclose_at(left, half_width).unwrap();
            assert!(at.contains(profile.height(left, half_width)) && width(at) < 1e-19, "{at:?}");
            // The range is met by samples.
            let samples = (0..=100).map(|i| value(left + (right - left) * f64::from(i) / 100.0));
            let (least, most) =
                samples.fold((f64::MAX, f64::MIN), |(u, v), w| (u.min(w), v.max(w)));
            let range = profile.enclose([left, right], half_width).unwrap();
            assert!(range.lower() <= least + 1e-20 && most - 1e-20 <= range.upper());
        }
    }
}

#[test]
fn a_cubic_is_enclosed_closely() {
    // f = x^3 - x on points of its own, whose spline is the cubic: f' = 3 x^2 - 1, f''/2 = 3 x.
    let points: Vec<f64> = (0..9).map(|i| f64::from(i) / 4.0 - 1.0).collect();
    let heights = points.iter().map(|x| x * x * x - x).collect();
    let profile = Profile::from_points(points, heights).unwrap();
    let terms = profile.taylor([0.3, 0.4], 3, 1.0).unwrap();
    let exact = [[-0.336, -0.273], [-0.73, -0.52], [0.9, 1.2], [1.0, 1.0]];
    for (found, [lower, upper]) in terms.into_iter().zip(exact) {
        assert!(
            (found.lower() - lower).abs() < 2e-3 && (found.upper() - upper).abs() < 2e-3,
            "{found:?}"
        );
    }
    // An interval between two points is a single cubic, whatever its ends round to.
    let fourth = |interval| profile.taylor(interval, 4, 1.0).unwrap()[4];
    assert_eq!(fourth([0.25, 0.5]).size(), 0.0);
    assert!(!fourth([0.25, 0.75]).is_bounded());
}

#[test]
fn what_cannot_be_told_from_a_pole_is_refused() {
    for (text, place) in [
        ("1/(xi-0.3)", 0.3),
        ("tan(2*xi)", -std::f64::consts::FRAC_PI_4),
        ("1e-9/((xi-0.3)^2)", 0.3),
        ("1e-30/((xi-0.3123456)^2)", 0.3123456),
        ("1e-20/(xi^3-0.1)^2", 0.1_f64.cbrt()),
        ("1e-9/(sin(3*xi)-0.5)^2", std::f64::consts::PI / 18.0),
        // Double roots that cancellation hides from the values themselves.
        ("1e-9/(xi^2-0.6*xi+0.09)", 0.3),
        ("1e-9/(cos(xi-0.3)-1)", 0.3),
        ("x^2 + 1e-12/(exp(xi-0.3)-1-(xi-0.3))", 0.3),
    ] {
        let found = profile(text).find_not_finite(1.0);
        assert!(found.is_some_and(|(at, _)| (at - place).abs() < 2e-7), "{text}: {found:?}");
    }
    // High and narrow, but finite.
    for text in [
        "1/(xi^2 - 0.6*xi + 0.09 + 1e-13)",
        "1e-9/((xi-0.3)^2+1e-20)",
        "1e-3/(1.000001-cos(xi-0.3))",
    ] {
        assert_eq!(profile(text).find_not_finite(1.0), None, "{text}");
    }
}

#[test]
fn heights_without_dimensions_are_those_over_their_scale() {
    let steel = Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) =
        (Foundation::new(steel).with_roughness(1.2e-14).unwrap(), Punch::new(5e-3).unwrap());
    let load = Load::new(Vertical::Force(0.8e6), Rotational::Moment(0.0)).unwrap();
    let problem =
        Problem::new(foundation, punch.with_profile(profile("x^2/(2*0.8)")), load).unwrap();
    // chi E = 2.4e-3 m; f0 = a^2 xi^2/(2 R chi E).
    let curvature = 25e-6 / (1.6 * 2.4e-3);
    let at = problem.dimensionless_enclosure_at(0.7).unwrap();
    assert!(at.contains(problem.dimensionless_profile(0.7)) && width(at) < 1e-17, "{at:?}");
    let near = |value: f64, exact: f64| (value - exact).abs() < 1e-14;
    let range = problem.dimensionless_enclosure([0.5, 1.0]).unwrap();
    assert!(near(range.lower(), 0.25 * curvature) && near(range.upper(), curvature), "{range:?}");
    let [_, slope, bend, third] = problem.dimensionless_taylor([0.5, 1.0], 3).unwrap()[..] else {
        panic!()
    };
    assert!(near(slope.lower(), curvature) && near(slope.upper(), 2.0 * curvature));
    assert!(near(bend.lower(), curvature) && near(bend.upper(), curvature));
    assert_eq!(third.size(), 0.0);
    assert_eq!(problem.resolution(64, 1e-12), super::Resolution::default());
}
