//! Abel's transforms of polynomials, of powers beside the axis, and of parts.

use std::f64::consts::FRAC_PI_2;

use super::super::rule::{integral, series};
use super::segment::leg;
use super::steps::{STEP, stepwise, stepwise_at_nodes};
use super::*;

/// A base of revolution with bends, on ground of an exponent.
fn shape<'p>(slope: &'p dyn Fn(f64) -> f64, breaks: Vec<f64>, exponent: f64) -> Shape<'p> {
    Shape {
        slope,
        breaks,
        joints: Vec::new(),
        tolerance: 0.0,
        noise: 0.0,
        remote: 0.0,
        powers: Powers::new(exponent).unwrap(),
        part: Symmetry::Revolution,
        is_over: &|| false,
    }
}

#[test]
fn polynomials_are_integrated_however_close_to_the_axis() {
    // I_k = int_r^1 s^k ds/sqrt(s^2 - r^2): k I_k = sqrt(1 - r^2) + (k-1) r^2 I_(k-2)
    for r in [0.5f64, 1e-2, 1e-5, 1e-10, 1e-150] {
        let root = ((1.0 - r) * (1.0 + r)).sqrt();
        let turn = [0.0, (root / r).asinh()];
        let mut known = [(1.0 / r).acosh(), root];
        for k in 0..ORDER as i32 {
            let [exact, other] = known;
            let power = |y: f64| (r * y.cosh()).powi(k);
            // A place s of a logarithm is known to so much.
            let rounding = 1e-14 + 2e-16 * f64::from(k) * turn[1];
            let found = stepwise(turn, STEP, power);
            assert!((found / exact - 1.0).abs() < rounding, "{r} {k}: {found} {exact}");
            let at_nodes = stepwise_at_nodes(turn, STEP, |y| y.map(power));
            assert!((at_nodes / exact - 1.0).abs() < rounding, "{r} {k}: {at_nodes} {exact}");
            let next = (root + f64::from(k + 1) * r * r * exact) / f64::from(k + 2);
            known = [other, next];
        }
        // All degrees together, against short steps.
        let coefficients: [f64; ORDER] = std::array::from_fn(|n| 0.5f64.powi(n as i32));
        let f = |y: f64| series(&coefficients, 2.0 * (r * y.cosh()) - 1.0);
        let (found, exact) = (stepwise(turn, STEP, f), short(turn, f));
        assert!((found - exact).abs() < 1e-14 * turn[1], "{r}: {found} {exact}");
    }
}

#[test]
fn powers_beside_the_axis_are_integrated() {
    // int_0^Y sinh^mu y cosh y dy = sinh^(1+mu) Y/(1+mu)
    for mu in [0.1f64, 0.5, 0.9] {
        let powers = Powers::new(mu).unwrap();
        for end in [0.5f64, 5.0, 20.0, 200.0] {
            let scale = end.sinh();
            let f = |y: f64| (y.sinh() / scale).powf(mu) * y.cosh() / scale;
            let found = powers.graded(0, [0.0, end], [STEP, f64::INFINITY], f);
            let rounding = 1e-14 + 2e-16 * end;
            assert!((found * (1.0 + mu) - 1.0).abs() < rounding, "{mu} {end}: {found}");
        }
    }
}

#[test]
fn slopes_of_few_digits_are_not_halved_for() {
    // (r - b)^2 up to a distance d from b that is short: G = x int h/sqrt(x^2 - r^2) dr is (8/3) sqrt(b/2) d^(3/2).
    let bend = 0.851;
    for far in [1e-10, 1e-13] {
        let asked = std::cell::Cell::new(0u32);
        let slope = |r: f64| {
            asked.set(asked.get() + 1);
            2.0 * (r - bend).max(0.0)
        };
        let shape = shape(&slope, vec![bend], 0.0);
        let radius = bend + far;
        AbelTransform::new(&shape, radius);
        assert!(asked.get() < 40_000, "{far}: {}", asked.get());
        let [value, blur] = shape.transform_beyond(bend, leg(radius, bend));
        let known = radius - bend;
        let exact = 8.0 / 3.0 * (0.5 * bend).sqrt() * known * known.sqrt();
        assert!((value - exact).abs() < 2.0 * blur + 1e-9 * exact, "{far}: {value} {exact} {blur}");
        assert!(blur > f64::EPSILON * bend * value / far, "{far}: {blur}");
    }
}

#[test]
fn a_part_of_a_transform_is_the_transform_of_a_part() {
    let mut parts = 0;
    for (mu, breaks) in [(0.0, vec![]), (0.4, vec![]), (0.0, vec![0.3]), (0.4, vec![0.3])] {
        let kink = breaks.first().copied();
        let slope =
            |r: f64| (3.0 * r).sin() + if kink.is_some_and(|at| r > at) { 1.0 } else { 0.0 };
        let shape = shape(&slope, breaks, mu);
        let whole = AbelTransform::new(&shape, 1.0);
        for radius in [0.2, 0.3, 0.55, 1.0] {
            let own = AbelTransform::new(&shape, radius);
            let Some(part) = whole.within(radius) else { continue };
            parts += 1;
            let close = |what: &str, one: f64, two: f64| {
                assert!((one - two).abs() < 1e-11, "{mu} {kink:?} {radius} {what}: {one} {two}");
            };
            close("volume", part.volume(0.7), own.volume(0.7));
            close("pressure", part.pressure(0.13), own.pressure(0.13));
            close("beside", part.displacement(1.1, 0.7), own.displacement(1.1, 0.7));
            close("slope", part.end_slope(), own.end_slope());
        }
        assert!(whole.within(1e-60).is_none());
    }
    assert!(parts > 8, "{parts}");
}

#[test]
fn a_bend_beside_the_middle_has_no_cusp() {
    // Where the second derivative of the base jumps the pressure changes as d^(1+mu): within a millionth of the bend by nothing.
    let mut worst = 0.0f64;
    for mu in [0.02f64, 0.05, 0.103, 0.3, 0.6] {
        for bend in [1e-4, 3e-3, 0.01, 0.0437, 0.3] {
            for part in [Symmetry::Revolution, Symmetry::Even, Symmetry::Odd] {
                let slope = |r: f64| {
                    let bent = (3.0 * r).sin() + 3.0 * (r - bend).max(0.0);
                    if part == Symmetry::Odd { bent + 1.0 - r } else { bent }
                };
                let shape = Shape { part, ..shape(&slope, vec![bend], mu) };
                let found = AbelTransform::new(&shape, 1.0);
                // Both sides together, as the pressure may rise from one to the other.
                let both = |share: f64| {
                    let [left, right] = [-share, share].map(|d| found.pressure(bend * (1.0 + d)));
                    0.5 * (left + right)
                };
                let smooth = both(1e-8);
                for share in [0.0, 1e-9, 1e-10, 1e-12, 1e-14] {
                    let off = (both(share) - smooth).abs();
                    worst = worst.max(off / smooth.abs().max(1.0));
                }
            }
        }
    }
    // Short panels know the slope of the transform to so much, over the exponent.
    assert!(worst < 1e-8, "{worst:e}");
}

fn short([from, to]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    let count = (4.0 * (to - from)).ceil();
    let width = (to - from) / count;
    let part = |i: usize| integral(from + width * i as f64, from + width * (i + 1) as f64, &f);
    (0..count as usize).map(part).sum()
}

#[test]
fn beside_a_bend_it_is_as_exact_as_stated() {
    // int_r^1 G'(x) (x^2 - r^2)^-beta dx under max(0, r - b)^n by mpmath, b = 0.3 to the last bit: G by the hypergeometric function, and nodes that crowd towards b and r.
    let places = [0.2, 0.3 - 1e-10, 0.3, 0.3 + 1e-10, 0.5];
    for (mu, n, exact) in [
        (
            0.0,
            1.1,
            [
                2.542_622_158_940_113_2,
                6.397_868_670_326_475,
                6.957_021_081_636_043,
                6.425_235_538_293_1,
                2.230_999_882_837_028_5,
            ],
        ),
        (
            0.0,
            1.5,
            [
                2.096_856_534_457_265,
                2.689_290_456_642_607,
                2.689_314_018_488_173_6,
                2.689_314_018_387_866_3,
                2.358_076_230_517_412_8,
            ],
        ),
        (
            0.1,
            1.0,
            [
                2.251_708_505_625_667_4,
                5.488_583_327_048_889_5,
                5.958_823_145_200_663,
                5.488_583_327_835_371_5,
                1.759_698_335_236_585_8,
            ],
        ),
        (
            0.1,
            1.1,
            [
                2.133_054_532_645_444,
                3.747_944_976_697_258,
                3.774_751_137_241_266,
                3.750_568_950_720_939,
                1.825_846_142_069_262,
            ],
        ),
        (
            0.1,
            1.5,
            [
                1.775_830_136_023_993_4,
                2.148_915_889_380_182,
                2.148_918_051_807_051,
                2.148_918_394_180_776,
                1.912_215_595_495_119_2,
            ],
        ),
        (
            0.5,
            1.0,
            [
                1.235_918_295_868_033,
                1.445_573_005_145_852,
                1.445_581_477_229_050_7,
                1.445_573_005_049_852_5,
                0.922_274_722_435_362_9,
            ],
        ),
    ] {
        let slope = |r: f64| match r - 0.3 {
            beyond if beyond > 0.0 => n * beyond.powf(n - 1.0),
            _ => 0.0,
        };
        let shape = shape(&slope, vec![0.3], mu);
        let transform = AbelTransform::new(&shape, 1.0);
        let error = transform.bend_error();
        assert!(error < 1e-6, "{mu} {n}: {error:e}");
        for (r, exact) in places.into_iter().zip(exact) {
            let off = (transform.pressure(r) - exact).abs();
            println!("{mu} {n} {r}: off {off:.1e}, stated {error:.1e}");
            assert!(off <= error + 1e-13 * exact, "{mu} {n} {r}: {off:e} {error:e}");
            // What is known of a bend to a few digits is felt at it only.
            let is_far = (r - 0.3).abs() > 1e-3;
            assert!(!is_far || off <= 2e-13 * exact, "{mu} {n} {r}: {off:e}");
        }
    }
}

#[test]
fn beside_bends_of_many_powers_it_is_as_exact_as_stated() {
    // The same by the hypergeometric function, at 0.67 b, b (1 - 1e-9), b, b (1 + 1e-9) and 0.5.
    for (mu, n, b, exact) in [
        (
            0.5,
            1.1,
            0.126057046,
            [
                1.595_800_195_456_907_7,
                1.694_267_668_144_959_3,
                1.694_268_730_479_291_6,
                1.694_268_048_251_221_6,
                0.959_267_256_033_093_8,
            ],
        ),
        (
            0.3,
            1.3,
            0.062745178,
            [
                2.336_352_815_437_452_4,
                2.440_602_139_740_554_4,
                2.440_603_231_429_025_6,
                2.440_603_039_655_155,
                1.451_794_481_819_427,
            ],
        ),
        (
            0.5,
            1.3,
            0.126057046,
            [
                1.508_680_553_015_889_5,
                1.563_436_491_606_169_6,
                1.563_436_510_656_795_3,
                1.563_436_514_710_026,
                1.044_545_103_379_441_5,
            ],
        ),
        (
            0.5,
            1.4656,
            0.3,
            [
                1.025_706_646_136_086_4,
                1.098_491_432_458_376_5,
                1.098_491_435_549_915_1,
                1.098_491_437_976_899_7,
                0.959_972_873_512_500_5,
            ],
        ),
        (
            0.0,
            1.8426,
            0.3,
            [
                1.834_701_453_841_111,
                2.111_649_428_669_096_6,
                2.111_649_484_627_198_7,
                2.111_649_533_672_154,
                2.279_945_626_111_494_8,
            ],
        ),
        (
            0.049,
            1.7678,
            0.3,
            [
                1.738_624_753_992_486_6,
                2.000_032_347_837_394,
                2.000_032_425_283_016,
                2.000_032_486_729_857,
                2.074_390_801_289_754,
            ],
        ),
        (
            0.1,
            1.9,
            0.3,
            [
                1.527_415_836_992_719,
                1.700_443_239_178_614_6,
                1.700_443_244_445_736_7,
                1.700_443_249_592_826_3,
                1.826_545_835_266_585_5,
            ],
        ),
        (
            0.1,
            2.5,
            0.3,
            [
                1.250_902_647_953_988_9,
                1.336_772_255_000_764_6,
                1.336_772_255_452_577_8,
                1.336_772_255_904_393_3,
                1.578_485_077_103_343_2,
            ],
        ),
        (
            0.5,
            1.5,
            0.3,
            [
                1.012_670_367_965_983_4,
                1.081_413_065_525_891_6,
                1.081_413_067_605_379_5,
                1.081_413_069_385_437_4,
                0.957_797_272_530_666_6,
            ],
        ),
        (
            0.5,
            1.4656,
            0.0028,
            [
                1.901_351_265_793_329_8,
                1.902_381_687_225_671_8,
                1.902_381_687_260_413_1,
                1.902_381_687_287_869_8,
                1.189_084_806_890_024,
            ],
        ),
        (
            0.1,
            2.5,
            0.0028,
            [
                3.043_813_998_393_034,
                3.043_979_300_623_567,
                3.043_979_300_624_249,
                3.043_979_300_624_931,
                3.159_703_297_000_974,
            ],
        ),
    ] {
        let slope = |r: f64| match r - b {
            beyond if beyond > 0.0 => n * beyond.powf(n - 1.0),
            _ => 0.0,
        };
        let shape = shape(&slope, vec![b], mu);
        let transform = AbelTransform::new(&shape, 1.0);
        let error = transform.bend_error();
        // The lower the power the less is known of it.
        let most = if n < 1.4 { 1e-6 } else { 1e-9 };
        assert!(error < most, "{mu} {n} {b}: {error:e}");
        let places = [b * 0.67, b - b * 1e-9, b, b + b * 1e-9, 0.5];
        for (r, exact) in places.into_iter().zip(exact) {
            let off = (transform.pressure(r) - exact).abs();
            println!("{mu} {n} {b} {r}: off {off:.1e}, stated {error:.1e}");
            assert!(off <= error + 1e-13 * exact, "{mu} {n} {b} {r}: {off:e} {error:e}");
        }
    }
}

/// `f = r^q`, `q < 1`, has an infinite slope at the axis, and a finite pressure there where `S = q - 1 + mu` is above zero: with `G = K x^q` it is `int_0^1 G' x^(mu - 1) dx = K q/S`.
#[test]
fn a_tip_has_the_pressure_of_its_power() {
    for (q, mu) in [(0.5, 0.6), (0.8, 0.3), (0.3, 0.9), (0.5, 0.75), (0.9, 0.45)] {
        let slope = |r: f64| q * r.powf(q - 1.0);
        let transform = AbelTransform::new(&shape(&slope, Vec::new(), mu), 1.0);
        // int_0^1 K x^(q + mu) dx
        let factor = -(q + 1.0 + mu) * transform.volume(0.0);
        let exact = factor * q / (q - 1.0 + mu);
        let off = (transform.pressure(0.0) - exact).abs();
        let stated = transform.bend_error();
        assert!(off <= stated + 1e-12 * exact, "{q} {mu}: {off:e} {stated:e} of {exact:e}");
        assert!(stated < 1e-8 * exact, "{q} {mu}: {stated:e} of {exact:e}");
    }
}

#[test]
fn a_bend_that_is_felt_on_both_sides_is_as_exact_as_stated() {
    // Against panels that go on to rounding. Below the bend `G` is singular at the end of its segment.
    let bend = 0.126_057_046;
    for (mu, n) in [(0.5f64, 1.1f64), (0.3, 1.3), (0.0, 1.5), (0.1, 1.9)] {
        let slope = |r: f64| 0.2 * r + n * (r - bend).abs().powf(n - 1.0) * (r - bend).signum();
        let of = |tolerance: f64| {
            let shape = Shape { tolerance, ..shape(&slope, vec![bend], mu) };
            AbelTransform::new(&shape, 1.0)
        };
        let best = of(0.0);
        for tolerance in [1e-14, 1e-12] {
            let found = of(tolerance);
            let error = found.bend_error();
            for share in [-1e-1, -1e-3, -1.5e-4, -1e-6, -1e-8, -1e-10, 0.0, 1e-8, 1e-4] {
                let r = bend * (1.0 + share);
                let off = (found.pressure(r) - best.pressure(r)).abs();
                assert!(off <= error + 1e-14, "{mu} {n} {tolerance} {share}: {off:e} {error:e}");
            }
        }
    }
}

/// `max(0, r - b)^2` for each bend, up to the radius.
fn squares(bends: &[f64], radius: f64) -> AbelTransform {
    let slope = |r: f64| bends.iter().map(|bend| 2.0 * (r - bend).max(0.0)).sum();
    let shape = shape(&slope, bends.to_vec(), 0.0);
    AbelTransform::new(&shape, radius)
}

#[test]
fn a_bend_next_to_the_axis_is_seen() {
    // G' = 4 w - 2 b arccos(b/x), w = sqrt(x^2 - b^2); int_b^c arccos(b/x) dx/x = (pi/2) ln(c/(2 b)) + e + e^3/18 + 3 e^5/200 + .., e = b/c.
    for bend in [1e-7f64, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2] {
        let (c, e) = (0.4, bend / 0.4);
        let series = e + e.powi(3) / 18.0 + 3.0 * e.powi(5) / 200.0;
        let beyond = FRAC_PI_2 * (0.5 / e).ln() + series;
        let exact = 4.0 * (leg(c, bend) - bend * e.acos()) - 2.0 * bend * beyond;
        let found = squares(&[bend], c).pressure(0.0);
        assert!((found - exact).abs() < 2e-13 * exact, "{bend:e}: {found} {exact}");
    }
}

#[test]
fn two_bends_next_to_one_another_add_up() {
    for apart in [1e-9, 1e-7, 1e-4] {
        let bends = [0.2, 0.2 + apart];
        let both = squares(&bends, 1.0);
        let each = bends.map(|bend| squares(&[bend], 1.0));
        for r in [0.0, 0.1, 0.2 - apart, 0.2 + 0.5 * apart, 0.2 + 1.01 * apart, 0.3] {
            let sum: f64 = each.iter().map(|one| one.pressure(r)).sum();
            let found = both.pressure(r);
            let allowed = both.bend_error() + 1e-12 * sum;
            assert!((found - sum).abs() < allowed, "{apart:e} {r}: {found} {sum} {allowed:e}");
        }
    }
}
