//! Cuts of bases with narrow features and without.

use super::super::base::{Profile, Shape};
use super::super::tests::{Random, profile};
use super::Resolution;
use super::search::Search;

const BASE: [[f64; 2]; 1] = [[-1.0, 1.0]];
const DEGREE: usize = 64;
const TOLERANCE: f64 = 1e-12;

fn resolve(text: &str) -> Resolution {
    profile(text).resolve(&BASE, 1.0, DEGREE, TOLERANCE)
}

/// Value of the interpolant at Chebyshev points of the first kind, by the barycentric formula (J.-P. Berrut, L. N. Trefethen, SIAM Review 46 (2004)).
fn interpolated(profile: &Profile, [left, right]: [f64; 2], nodes: usize, t: f64) -> f64 {
    let (mut above, mut below) = (0.0, 0.0);
    for i in 0..nodes {
        let angle = std::f64::consts::PI * (i as f64 + 0.5) / nodes as f64;
        let node = angle.cos();
        let value = profile.height(0.5 * (left + right) + 0.5 * (right - left) * node, 1.0);
        if node == t {
            return value;
        }
        let weight = if i % 2 == 0 { angle.sin() } else { -angle.sin() };
        above += weight / (t - node) * value;
        below += weight / (t - node);
    }
    above / below
}

/// Largest difference between profile and interpolant on a part, seen at many places.
fn difference(profile: &Profile, [left, right]: [f64; 2], nodes: usize) -> f64 {
    let mut random = Random(5);
    let mut most = 0.0_f64;
    for _ in 0..400 {
        let t = random.between(-1.0, 1.0);
        let xi = 0.5 * (left + right) + 0.5 * (right - left) * t;
        let value = interpolated(profile, [left, right], nodes, t);
        most = most.max((value - profile.height(xi, 1.0)).abs());
    }
    most
}

/// The parts between cuts that end at no singular place and hold nothing unresolved.
fn proved_parts(found: &Resolution) -> Vec<[f64; 2]> {
    let cuts: Vec<f64> =
        [-1.0].into_iter().chain(found.joints.iter().copied()).chain([1.0]).collect();
    let parts = cuts.windows(2).map(|ends| [ends[0], ends[1]]);
    let is_rough = |part: &[f64; 2]| {
        let is_singular = found.singular.iter().any(|place| part.contains(place));
        is_singular || found.unresolved.iter().any(|[from, to]| *from < part[1] && part[0] < *to)
    };
    parts.filter(|part| !is_rough(part)).collect()
}

#[test]
fn smooth_profiles_need_few_joints() {
    for (text, most) in [
        ("0", 0),
        ("xi", 0),
        ("x^2/(2*0.8)", 0),
        ("exp(xi)", 0),
        ("exp(xi)*cos(3*xi) + xi^7", 0),
        ("cos(30*xi)", 0),
        ("cos(100*xi)", 6),
        ("1/(1+xi^2)", 1),
        ("1/(1+25*xi^2)", 6),
        ("sqrt(1.01-xi^2)", 8),
        ("cosh(xi)^0.3 + atan(3*xi)", 4),
        ("1e6 + xi^2", 0),
        ("sin(xi)^2 + cos(xi)^2", 0),
        ("1/cosh(1e4*xi)", 40),
    ] {
        let found = resolve(text);
        let count = found.joints.len();
        assert!(count <= most, "{text}: {found:?}");
        assert!(found.is_complete() && found.singular.is_empty(), "{text}: {found:?}");
    }
}

#[test]
fn proved_parts_are_resolved() {
    for text in [
        "exp(xi)*cos(30*xi)",
        "1/(1+400*(xi-0.2)^2)",
        "xi^2 + 1e-3*exp(-((xi-0.3)/1e-4)^2)",
        "tanh(1e3*(xi+0.4)) + xi^2",
        "abs(xi-0.1) + cos(40*xi^2)",
        "max(0, abs(xi)-0.25)^3",
        "sqrt((xi+0.0802)^2)",
        "abs(xi-0.3)^1.5",
        "sqrt(1-xi^2)",
        "1/cosh(200*(xi-0.77))",
        "exp(-1/((xi-0.2)^2+1e-4))",
        "hypot(xi, 1e-3)",
        "log1p(xi^2/1e-4)",
    ] {
        let profile = profile(text);
        for (degree, tolerance) in [(DEGREE, TOLERANCE), (16, 1e-7)] {
            let found = profile.resolve(&BASE, 1.0, degree, tolerance);
            assert!(found.is_complete(), "{text}: {found:?}");
            let parts = proved_parts(&found);
            let is_rough = ["sqrt((", "^1.5", "1-xi^2"].iter().any(|sign| text.contains(sign));
            assert!(is_rough || !parts.is_empty(), "{text}: {found:?}");
            for part in parts {
                let seen = difference(&profile, part, degree);
                // Heights are at most of the order of one; interpolation rounds as well.
                assert!(seen <= 4.0 * tolerance, "{text} on {part:?}: {seen:e}");
            }
        }
    }
}

#[test]
fn narrow_features_are_bracketed_wherever_they_are() {
    let mut random = Random(2024);
    for round in 0..60 {
        let place = random.between(-0.95, 0.95);
        let width = 10.0_f64.powf(random.between(-6.0, -3.7));
        let text = match round % 4 {
            0 => format!("xi^2 + 1e-3*exp(-((xi-({place:e}))/{width:e})^2)"),
            1 => format!("1e-2/(1+((xi-({place:e}))/{width:e})^2) + cos(xi)"),
            2 => format!("xi^4 + tanh((xi-({place:e}))/{width:e})"),
            _ => format!("xi - 1e-4*exp(-((x-({place:e}))/{width:e})^4)"),
        };
        let found = resolve(&text);
        assert!(found.is_complete() && found.singular.is_empty(), "{text}: {found:?}");
        let nearest = |side: f64| {
            let distances = found.joints.iter().map(|xi| side * (xi - place));
            distances.filter(|&distance| distance >= 0.0).fold(f64::INFINITY, f64::min)
        };
        let (left, right) = (nearest(-1.0), nearest(1.0));
        assert!(
            left < 30.0 * width && right < 30.0 * width,
            "{text}: {left:e}, {right:e} of {found:?}"
        );
        assert!(found.joints.len() <= 40, "{text}: {found:?}");
    }
}

#[test]
fn switches_between_samples_are_cuts() {
    let mut random = Random(77);
    for round in 0..30 {
        let place = random.between(-0.95, 0.95);
        let width = 10.0_f64.powf(random.between(-6.0, -4.0));
        let text = match round % 3 {
            0 => format!("where((xi-({place:e}))^2 < {width:e}^2, xi^2 + 1e-3, xi^2)"),
            1 => format!("exp(xi) + max(0, {width:e}^2 - (xi-({place:e}))^2)/{width:e}^2"),
            _ => format!("xi + abs({width:e} - hypot(xi-({place:e}), {width:e}/2))"),
        };
        let found = resolve(&text);
        assert!(found.is_complete(), "{text}: {found:?}");
        let half = if round % 3 == 2 { 0.75_f64.sqrt() * width } else { width };
        for edge in [place - half, place + half] {
            let is_cut = found.joints.iter().any(|xi| (xi - edge).abs() < 1e-9 * width + 1e-13);
            assert!(is_cut, "{text}: {edge} not in {found:?}");
        }
    }
}

#[test]
fn a_switch_at_the_end_of_a_part_is_a_cut() {
    // Halving meets these places exactly, and the sides are constant or smooth.
    for text in [
        "where((xi-0.25)^2 < 2^-40, 1, 0)",
        "xi + where(abs(xi-0.25) <= 2^-20, 1e-3, 0)",
        "max(0, 2^-30 - (xi-0.125)^2)",
    ] {
        let found = resolve(text);
        let width = if text.contains("2^-30") { 15 } else { 20 };
        let middle = if text.contains("0.125") { 0.125 } else { 0.25 };
        let half = 0.5_f64.powi(width);
        for edge in [middle - half, middle + half] {
            assert!(found.joints.iter().any(|xi| (xi - edge).abs() < 1e-13), "{text}: {found:?}");
        }
    }
}

#[test]
fn the_work_is_bounded() {
    let long = format!("cos(1e7*xi){}", "*cos(xi)".repeat(300));
    for (text, most) in [("cos(1e7*xi)", 2001), ("floor(1e6*xi)", 2001 + 4096), (&long, 200)] {
        let profile = profile(text);
        let segments = super::segments(&BASE, &profile.breakpoints(1.0));
        let Shape::Expression(expression) = &profile.shape else { panic!() };
        let search = Search::new(&profile, 1.0, DEGREE, expression.length());
        let leaves = search.leaves(&segments, search.goal(&segments, TOLERANCE));
        // Each enclosure adds no more than one part.
        assert!(leaves.len() <= most, "{text}: {}", leaves.len());
        assert!(profile.resolve(&BASE, 1.0, DEGREE, TOLERANCE).joints.len() <= 512 + 4096);
    }
}

#[test]
fn a_dent_gives_a_handful_of_joints() {
    for width in [1e-3, 1e-4, 1e-5, 1e-6] {
        let found = resolve(&format!("xi^2 + 0.01*exp(-(xi/{width:e})^2)"));
        assert!(
            found.is_complete() && (2..=12).contains(&found.joints.len()),
            "{width:e}: {found:?}"
        );
        // A symmetric profile has symmetric joints.
        let mirrored: Vec<f64> = found.joints.iter().rev().map(|xi| -xi).collect();
        assert_eq!(found.joints, mirrored);
    }
}

#[test]
fn kinks_and_roots_are_single_places() {
    for (text, place) in [
        ("sqrt((xi+0.0802)^2)", -0.0802),
        ("sqrt((xi+0.0802)^2) + xi^2 - 0.5*cos(xi)", -0.0802),
        ("sqrt(xi^2)", 0.0),
        ("abs(xi-0.3)^1.5", 0.3),
        ("max(0, xi-0.3)^1.5", 0.3),
        ("abs(xi-0.3)^2.5", 0.3),
        ("((xi-0.3)^2)^0.75", 0.3),
        ("exp(xi)*cbrt(xi-0.3)", 0.3),
        ("sqrt(abs(xi - 1/7))", 1.0 / 7.0),
    ] {
        let found = resolve(text);
        assert!(found.is_complete(), "{text}: {found:?}");
        assert!(
            found.singular.len() == 1 && (found.singular[0] - place).abs() < 1e-13,
            "{text}: {found:?}"
        );
        assert_eq!(found.joints, found.singular, "{text}");
    }
    let found = resolve("sqrt(1-xi^2)");
    assert_eq!(found, Resolution { singular: vec![-1.0, 1.0], ..Resolution::default() });
    // Kinks at switches are joints between smooth parts.
    for (text, joints) in [
        ("abs(xi-0.25)", vec![0.25]),
        ("max(0, abs(xi)-0.25)^2", vec![-0.25, 0.0, 0.25]),
        ("where(xi<0.3, exp(xi), 2)", vec![0.3]),
        ("floor(2*xi)", vec![-0.5, 0.0, 0.5]),
        ("abs(3*xi-1) + 0.1*abs(x-0.6)", vec![1.0 / 3.0, 0.6]),
    ] {
        let found = resolve(text);
        let near = found.joints.iter().zip(&joints).all(|(u, v)| (u - v).abs() < 1e-15);
        assert!(near && found.joints.len() == joints.len(), "{text}: {found:?}");
        assert!(found.is_complete() && found.singular.is_empty(), "{text}: {found:?}");
    }
}

#[test]
fn what_cannot_be_resolved_is_said_to_be_so() {
    let length =
        |found: &Resolution| found.unresolved.iter().map(|[from, to]| to - from).sum::<f64>();
    for text in ["cos(1e7*xi)", "cos(1e7*xi) + exp(xi)", "cos(1/(1e-6+xi^2))*xi", "floor(1e6*xi)"] {
        let found = resolve(text);
        assert!(!found.is_complete(), "{text}");
        let least = if text.contains("xi^2") { 1e-3 } else { 1.0 };
        assert!(length(&found) > least, "{text}: {}", length(&found));
    }
    // A sum of many scales, each a power of three finer than the one before.
    let terms = (0..14).map(|k| format!("{}*abs(sin({}*xi))", 0.7_f64.powi(k), 3.0_f64.powi(k)));
    let found = resolve(&terms.collect::<Vec<_>>().join(" + "));
    assert!(!found.is_complete());
    // What is hopeless in one place is no hindrance in another.
    let found = resolve("where(xi<0, cos(1e7*xi), exp(-((xi-0.6)/1e-4)^2))");
    assert!(!found.is_complete() && found.unresolved.iter().all(|[_, to]| *to <= 0.0), "{found:?}");
}

#[test]
fn pieces_are_resolved_on_their_own() {
    let pair = [[-1.0, -0.5], [0.5, 1.0]];
    let text = "exp(-(xi/1e-4)^2) + exp(-((xi-0.7)/1e-3)^2) + abs(xi+0.75)";
    let found = profile(text).resolve(&pair, 1.0, DEGREE, TOLERANCE);
    assert!(found.is_complete() && found.joints.contains(&-0.75));
    assert!(found.joints.iter().all(|xi| *xi == -0.75 || (0.5..1.0).contains(xi)), "{found:?}");
    let measured =
        Profile::from_points(vec![-1.0, -0.6, 0.1, 0.7, 1.0], vec![0.0, 1.0, 0.0, 2.0, 0.0]);
    let found = measured.unwrap().resolve(&pair, 1.0, DEGREE, TOLERANCE);
    assert_eq!(found, Resolution { joints: vec![-0.6, 0.7], ..Resolution::default() });
    assert_eq!(Profile::flat().resolve(&pair, 1.0, DEGREE, TOLERANCE), Resolution::default());
}

#[test]
fn a_hidden_kink_is_one_cut_wherever_it_lies() {
    let mut random = Random(83);
    // Of the first a part that is short enough for any slope reaches beyond where the parts beside the kink begin.
    let places = [0.18109].into_iter();
    let places = places.chain((0..60).map(|_| (1e5 * random.between(-0.9, 0.9)).round() / 1e5));
    for at in places {
        let text = format!("10*(sqrt((xi-({at}))^2) - 0.00591*xi^2)");
        let found = profile(&text).resolve(&BASE, 1.0, 128, TOLERANCE);
        assert!(found.is_complete(), "{at}: {found:?}");
        assert!(matches!(found.joints[..], [cut] if (cut - at).abs() < 1e-13), "{at}: {found:?}");
    }
}
