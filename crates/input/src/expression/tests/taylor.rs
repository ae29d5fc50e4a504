//! Enclosures of Taylor coefficients.

use proptest::prelude::*;

use super::super::{Expression, Interval, Line, Taylor};
use super::trees::tree;
use super::{parsed, tied};

const SLACK: f64 = 8.0 * f64::EPSILON;

fn interval(lower: f64, upper: f64) -> Interval {
    Interval::new(lower, upper).unwrap()
}

fn expansion(text: &str, [lower, upper]: [f64; 2], order: usize) -> Taylor {
    parsed(text).taylor_along(&tied(), interval(lower, upper), order, SLACK)
}

fn size(range: Interval) -> f64 {
    range.lower().abs().max(range.upper().abs())
}

/// Expressions with their coefficients `f^(k)/k!` at a place.
type Row = (&'static str, f64, [f64; 7]);

const ORDERS: [usize; 7] = [0, 1, 2, 3, 8, 17, 32];

/// By mpmath 1.3 with 80 digits: Cauchy's integral over a circle by the trapezoidal rule with 256 points.
#[rustfmt::skip]
const ROWS: &[Row] = &[
        ("exp(-((xi-0.3)/0.01)^2)", 0.305, [0.77880078307140453, -77.880078307140519, -3894.0039153570157, 649000.65255950407, -172873685726416.03, -1.3739334719245048e+28, -2.6665454871775057e+50]),
        ("exp(-((xi-0.3)/0.01)^2)", 0.36, [2.319522830243579e-16, -2.7834273962922946e-13, 1.6468612094729409e-10, -6.4018830114722766e-8, 16090.692792265154, -1.1140321432729907e+21, 7.6379987211795202e+42]),
        ("1/(1+25*xi^2)", 0.1, [0.79999999999999998, -3.2, -3.1999999999999987, 76.799999999999995, -73523.199999999968, -90270020403.199963, -5.38151405987051e+20]),
            ("sqrt(xi+1.5)*sin(7*xi)", -0.4, [-0.35133853591566425, -7.0771772293652769, 5.499781299204412, 61.103487456637032, 12.477014563308771, -1.0419937972147422, -7.3945353318166406e-5]),
        ("(xi+2)^-2.5", 0.5, [0.10119288512538814, -0.10119288512538814, 0.070835019587771697, -0.042501011752663018, 0.0014021994513169658, -1.0193564275403829e-6, 2.6920944092362489e-12]),
        ("cbrt(xi-3)", 0.5, [-1.3572088082974533, 0.18096117443966044, 0.024128156591954725, 0.0053618125759899389, 1.4083988567231295e-5, 1.3306428170103197e-9, 6.1089186350941912e-16]),
        ("ln(xi+2)+log10(xi+3)-log2(5-xi)+log1p(xi)", 0.25, [-0.7019703849341726, 1.6817987875653887, -0.40735266953020526, 0.20863475870549685, -0.021165490388164961, 0.0013246487733013719, -2.4758800953592223e-5]),
        ("tan(xi)*tanh(5*xi)", 0.5, [0.53898984759561025, 1.353702792130943, 0.51416883408581188, 1.2143340181505726, 13.755228630360144, -994.79703812538423, 1427005.756994247]),
        ("asin(xi/2)+acos(xi/3)*atan(4*xi)", 0.5, [1.8063954680635533, 1.2647917977701292, -2.0430024449131318, 3.0793452052044747, 10.184098044219945, 1831.5285918024494, -4764974.6782079991]),
        ("asinh(3*xi)+acosh(xi+2)*atanh(xi/2)", 0.5, [1.5949438160583644, 2.6111981382910059, -0.83442783740846756, 0.90592696067986617, 2.5755555654032699, -77.450632438554514, -31152.717669769766]),
        ("sinh(2*xi)/cosh(3*xi)+expm1(xi)", -0.25, [-0.62368784998746227, 1.7538133851634917, 3.2534566725324462, 1.2104582777643437, 59.084619784610755, -1699.5161532489162, -30909004.903724361]),
        ("(xi+2)^(xi+1)", 0.5, [3.9528470752104742, 5.9936653846575031, 5.6508668174144901, 3.7851998729595627, 0.040378851358359001, -1.1110033821797034e-8, 6.7102396665583146e-14]),
        ("hypot(xi,0.25)+atan2(xi,0.5-xi)", 0.75, [2.6831162962336336, 1.7486832980505138, -1.2167544467966324, 1.8014386694892922, 7.1609446365232942, 1156.8131438981209, -2890570.9272964834]),
        ("(xi^3-0.5*xi)^7", 0.0, [0.0, 0.0, 0.0, 0.0, 0.0, 5.25, 0.0]),
        ("(xi^3-0.5*xi)^7", 0.5, [-4.76837158203125e-7, 6.67572021484375e-6, 0.0, -0.0003204345703125, -0.066650390625, 229.6875, 0.0]),
        ("2^(4*xi)*cos(xi^2)", 0.5, [3.8756496868425791, 9.7559667760737831, 9.2253021939715815, -1.8636872143719133, -0.3056509744495769, -0.0076108030022719587, -1.4371664086772796e-9]),
];

#[test]
fn coefficients_at_a_place_and_around_it() {
    for &(text, place, coefficients) in ROWS {
        let at = expansion(text, [place, place], 32);
        let width = 1e-9 * if text.contains("0.01)") { 0.01 } else { 1.0 };
        let around = expansion(text, [place - width, place + width], 32);
        for (k, exact) in ORDERS.into_iter().zip(coefficients) {
            let slack = 1e-16 * exact.abs();
            for found in [at.coefficient(k), around.coefficient(k)] {
                let is_inside = found.lower() - slack <= exact && exact <= found.upper() + slack;
                assert!(is_inside, "{text} at {place}, order {k}: {found:?}, not {exact:e}");
            }
            // Recurrences lose digits to cancellation, at high orders more than those of a short interval leave.
            let found = at.coefficient(k);
            assert!(
                found.upper() - found.lower() <= 0.01 * exact.abs().max(1e-3),
                "{text} at {place}, order {k}: {found:?}"
            );
            let found = size(around.coefficient(k));
            assert!(
                k > 8 || found <= 1.03 * exact.abs() + 1e-3,
                "{text} around {place}, order {k}: {found:e}, not {exact:e}"
            );
        }
    }
}

/// Divided differences of values are means of `f^(k)/k!` wherever the derivative of order `k - 1` is Lipschitz continuous.
fn check_divided_differences(expression: &Expression, range: Interval) {
    const MOST: usize = 7;
    let found = expression.taylor_along(&tied(), range, MOST, SLACK);
    for count in 1..=MOST + 1 {
        let bound = found.coefficient(count - 1);
        if !bound.is_bounded() {
            break;
        }
        let place = |i: usize| {
            let share = 0.5 - 0.5 * ((i as f64 + 0.5) / count as f64 * std::f64::consts::PI).cos();
            range.lower() + share * (range.upper() - range.lower())
        };
        let places: Vec<f64> = (0..count).map(place).collect();
        let (mut lower, mut upper) = (0.0, 0.0);
        for &x in &places {
            let others = places.iter().filter(|&&other| other != x);
            let weight: f64 = others.map(|other| 1.0 / (x - other)).product();
            let value = expression.enclose_along(&tied(), interval(x, x)).interval;
            let ends = [weight * value.lower(), weight * value.upper()];
            let rounding = 1e-14 * ends[0].abs().max(ends[1].abs());
            lower += ends[0].min(ends[1]) - rounding;
            upper += ends[0].max(ends[1]) + rounding;
        }
        let is_met = upper >= bound.lower() && lower <= bound.upper();
        assert!(
            is_met || !(lower.is_finite() && upper.is_finite()),
            "{expression} on {range:?}, order {}: [{lower:e}, {upper:e}] outside {bound:?}",
            count - 1
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn divided_differences_are_enclosed(
        tree in tree(), left in -1.0..1.0_f64, width in prop_oneof![1e-3..1.0_f64, 1e-3..0.05_f64],
    ) {
        check_divided_differences(&parsed(&tree.text()), interval(left, left + width));
    }

    #[test]
    fn every_function_is_enclosed(left in -3.0..3.0_f64, width in 1e-2..1.0_f64) {
        for text in [
            "sqrt(x)", "cbrt(x)", "exp(x)", "expm1(x)", "ln(x)", "log10(x)", "log2(x)", "log1p(x)",
            "sin(x)", "cos(x)", "tan(x)", "asin(x)", "acos(x)", "atan(x)", "sinh(x)", "cosh(x)",
            "tanh(x)", "asinh(x)", "acosh(x)", "atanh(x)", "abs(x)", "x*sign(xi)", "floor(x)*x",
            "x*ceil(x)", "step(x)+x", "(x+1)*(xi-2)", "xi/(x+1)", "x^xi", "x^3", "(x^2-1)^4",
            "x^-1", "x^-2", "x^0.5", "x^-1.5", "abs(x)^2.5", "2^x", "min(x,xi^2)", "max(x,1,xi)",
            "hypot(x,xi-1)", "atan2(x,xi-1)", "where(x<0.5,x,sqrt(xi))", "(x*xi-xi)^6",
            "clamp(x,xi,1)", "exp(-1/x^2)", "atan2(1-xi, exp(xi))", "sqrt((xi-0.1)^2)", "x^1e3",
        ] {
            check_divided_differences(&parsed(text), interval(left, left + width));
        }
    }
}

#[test]
fn bounds_on_short_intervals_are_about_the_derivatives() {
    // The largest values of |f^(n)|/n! are at the ends, in closed form.
    let binomial =
        |p: f64, k: usize| (0..k).map(|i| (p - i as f64) / (i + 1) as f64).product::<f64>();
    for n in [1_usize, 2, 5, 16, 32] {
        let power = n as i32;
        let factorial: f64 = (1..=n).map(|i| i as f64).product();
        let table = [
            ("1/xi", [0.5, 0.51], 0.5_f64.powi(-power - 1)),
            ("exp(3*xi)", [0.4, 0.41], 1.23_f64.exp() * 3.0_f64.powi(power) / factorial),
            ("sqrt(xi)", [0.5, 0.51], binomial(0.5, n).abs() * 0.5_f64.powf(0.5 - n as f64)),
            ("ln(xi)", [0.5, 0.51], 0.5_f64.powi(-power) / n as f64),
        ];
        for (text, range, exact) in table {
            let found = size(expansion(text, range, n).coefficient(n));
            assert!(found >= exact * (1.0 - 1e-13), "{text}, order {n}: {found:e} below {exact:e}");
            assert!(found <= exact * 1.05, "{text}, order {n}: {found:e} above {exact:e}");
        }
    }
}

#[test]
fn a_narrow_gaussian_vanishes_far_from_its_middle() {
    for width in [1e-3, 1e-5, 1e-7] {
        let text = format!("exp(-((xi-0.3)/{width:e})^2)");
        for range in [[0.35, 1.0], [-1.0, 0.25], [0.3 + 60.0 * width, 0.3 + 100.0 * width]] {
            let found = expansion(&text, range, 32);
            for n in [0, 1, 8, 32] {
                let bound =
                    size(found.coefficient(n)) * (0.5 * (range[1] - range[0])).powi(n as i32);
                assert!(bound < 1e-200, "width {width:e} on {range:?}, order {n}: {bound:e}");
            }
        }
        // In its middle it is as smooth as it is wide.
        let found = expansion(&text, [0.3 - 0.1 * width, 0.3 + 0.1 * width], 8);
        let bound = size(found.coefficient(8)) * width.powi(8);
        assert!((1.0 / 24.0..0.1).contains(&bound), "width {width:e}: {bound:e}");
    }
}

#[test]
fn switches_at_an_end_are_followed_inside() {
    let table = [
        ("abs(xi-0.25)", [0.25, 0.5], 1, 1.0),
        ("abs(xi-0.25)", [0.0, 0.25], 1, -1.0),
        ("sign(xi-0.3)", [0.3, 0.5], 0, 1.0),
        ("sign(xi-0.3)", [0.1, 0.3], 0, -1.0),
        ("step(0.3-xi)", [0.3, 0.5], 0, 0.0),
        ("where(xi<0.3, xi^2, 2)", [0.3, 0.5], 0, 2.0),
        ("where(xi<0.3, xi^2, 2)", [0.1, 0.3], 2, 1.0),
        ("where(xi<=0.3, xi^2, 2)", [0.1, 0.3], 2, 1.0),
        ("where(xi<=0.3, xi^2, 2)", [0.3, 0.5], 0, 2.0),
        ("where(xi>=0.3, xi^2, 2)", [0.1, 0.3], 0, 2.0),
        ("where(xi-0.3, xi^2, 2)", [0.1, 0.3], 2, 1.0),
        ("floor(4*xi)", [0.25, 0.5], 0, 1.0),
        ("ceil(4*xi)", [0.25, 0.5], 0, 2.0),
        ("floor(-4*xi)", [0.25, 0.5], 0, -2.0),
        ("max(0, xi-0.25)^2", [0.25, 0.5], 2, 1.0),
        ("min(xi, 0.25)", [0.25, 0.5], 1, 0.0),
        ("max(xi^2, xi^4)", [-1.0, -0.8], 2, 1.0),
        // Places that are rounded: 1/3 and 0.2/2 lie beside the numbers given.
        ("abs(3*xi-1)", [1.0 / 3.0, 0.5], 1, 3.0),
        ("abs(3*xi-1)", [0.2, 1.0 / 3.0], 1, -3.0),
        ("abs(x-0.2)", [0.1, 0.2], 1, 2.0),
        ("where(x<0.6, 1, x)", [0.3, 0.4], 1, 2.0),
    ];
    for (text, range, order, exact) in table {
        let found = expansion(text, range, 3).coefficient(order);
        let near = found.contains(exact) && found.upper() - found.lower() < 1e-14;
        assert!(near, "{text} on {range:?}, order {order}: {found:?}, not {exact}");
    }
}

#[test]
fn what_is_not_smooth_is_not_bounded() {
    // The first order without a bound.
    let table = [
        ("abs(xi-0.3)", [0.2, 0.4], 2),
        ("max(xi, 0.3)", [0.2, 0.4], 2),
        ("sign(xi-0.3)", [0.2, 0.4], 1),
        ("where(xi<0.3, 0, xi)", [0.2, 0.4], 1),
        ("floor(10*xi)", [0.25, 0.35], 1),
        ("sqrt(xi)", [0.0, 0.5], 1),
        ("xi^1.5", [0.0, 0.5], 2),
        ("abs(xi)^1.5", [0.0, 0.5], 2),
        ("abs(xi)^1.5", [-0.5, 0.5], 2),
        ("(xi+1)^3.5", [-1.0, 0.5], 4),
        ("cbrt(xi)", [-0.5, 0.5], 1),
        ("hypot(xi, x)", [-0.5, 0.5], 2),
        ("sqrt((xi+0.0802)^2)", [-0.5, 0.5], 1),
        ("1/xi", [-0.5, 0.5], 0),
        ("1/xi", [0.0, 0.5], 0),
        ("tan(2*xi)", [0.5, 1.0], 0),
        ("ln(xi)", [0.0, 1.0], 0),
    ];
    for (text, range, order) in table {
        let found = expansion(text, range, 6);
        for k in 0..=6 {
            let is_bounded = found.coefficient(k).is_bounded();
            assert_eq!(is_bounded, k < order, "{text} on {range:?}, order {k}");
        }
    }
    // A zero of a polynomial is no kink, whatever power it is raised to.
    for text in ["xi^5", "(xi^2-0.01)^3", "abs(xi)^2", "(xi-x)^2"] {
        assert!(expansion(text, [-0.5, 0.5], 6).coefficient(6).is_bounded(), "{text}");
    }
}

#[test]
fn odd_intervals_are_answered() {
    for end in [f64::MAX, f64::INFINITY, 1e-310, 0.0] {
        for text in
            ["exp(xi)", "xi^3/(1+xi^2)", "abs(xi)", "1/xi", "hypot(xi,1)^-0.3", "7", "xi^xi"]
        {
            let found = parsed(text).taylor_along(&tied(), interval(-end, end), 12, SLACK);
            assert!(found.coefficient(12).lower() <= found.coefficient(12).upper());
        }
    }
    let missing = parsed("a").taylor_along(&Line::identity(), interval(0.0, 1.0), 3, 0.0);
    assert_eq!(missing.range(), None);
}

/// Of `w xi + c` the coefficients are `w^k/k!` times the wave and its companion by turns: over an interval they hold those at all its places, at one place they are no wider than rounding.
#[test]
fn waves_of_linear_arguments() {
    let mut case = 0;
    for (function, is_circular, is_odd) in
        [("sin", true, true), ("cos", true, false), ("sinh", false, true), ("cosh", false, false)]
    {
        for w in [1e-3, 0.7, 3.0, 40.0, 900.0] {
            for sign in [1.0, -1.0] {
                case += 1;
                let (w, c) = (sign * w, (1.7 * f64::from(case)).sin());
                let text = format!("{function}({w}*xi + {c})");
                let lower = 0.01 * (2.3 * f64::from(case)).cos();
                for width in [0.0, 1e-4, 0.02] {
                    let found = expansion(&text, [lower, lower + width], 24);
                    let mut factor = 1.0;
                    for k in 0..=24 {
                        let range = found.coefficient(k);
                        for share in [0.0, 0.31, 1.0] {
                            let u = w * (lower + share * width) + c;
                            let is_own = (k % 2 == 0) == is_odd;
                            let value = match (is_circular, is_own) {
                                (true, true) => u.sin(),
                                (true, false) => u.cos(),
                                (false, true) => u.sinh(),
                                (false, false) => u.cosh(),
                            };
                            // sin, cos, -sin, -cos and cos, -sin, -cos, sin.
                            let turns = if is_odd { k } else { k + 1 };
                            let exact =
                                factor * if is_circular && turns % 4 > 1 { -value } else { value };
                            let slack = 1e-12 * exact.abs() + 1e-14 * factor.abs();
                            assert!(
                                range.lower() <= exact + slack && exact - slack <= range.upper(),
                                "{text} {k}: {exact:e} {range:?}"
                            );
                        }
                        if width == 0.0 {
                            let size = range.size().max(factor.abs());
                            assert!(range.length() <= 1e-11 * size, "{text} {k}: {range:?}");
                        }
                        factor *= w / (k + 1) as f64;
                    }
                }
            }
        }
    }
}
