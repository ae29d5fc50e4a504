//! The part `A |s - k|` of a profile at a kink, whose pressure is known but for an integral without a scale.
//!
//! With `sin v = sqrt(x^2 - k^2)/x`, `cos v = |k|/x`, the halves of its slope about the middle of the zone have the transforms
//!
//! - `G_e = A x [sin^(1+mu) v - mu cos v S(v)]`, `G_o = -+ A [B - S(v)]` (minus where the kink lies on the right) beyond the kink, 0 and `-+ A B` within;
//! - `G_e' = A sin^(mu-1) v`, `G_o' = A k/x^2 sin^(mu-1) v`.
//!
//! Both together are `A int (x^2 + s k) x^(-1-mu) [(x^2 - k^2)(x^2 - s^2)]^-beta dx`, where what is singular at `s = -k` cancels. Close to the middle of the zone the two
//! parts alone change within `|k|`, which no panels of a zone can follow, their sum does not.

use std::f64::consts::FRAC_PI_2;

use super::place::Place;
use super::powers::{GROWTH, NEAREST, PLAIN, Powers, TURN};
use super::rule::ORDER;
use super::ultraspherical::inside;
use crate::linear::vectorised;
use crate::special::powers_within;

/// Panels towards the kink itself, each this share of the one before: what is left falls as its square. At half or twice 1 of 8 differ beyond what is stated (survey).
const INWARDS: i32 = 14;
const SHARE: f64 = 0.25;

/// A kink in a zone of the half-length `half`.
#[derive(Debug, Clone, Copy)]
pub struct Kink {
    /// `k`, from the middle.
    pub at: f64,
    /// Distances from the left and the right end.
    pub place: Place,
    /// `A`: half the jump of the slope.
    pub size: f64,
    /// `b`.
    pub half: f64,
}

impl Kink {
    /// Whether a slope that jumps by so much so near to a place, and so much twice as far away, jumps at it: it does not where it goes as a power of the distance.
    #[must_use]
    pub fn is_jump(near: f64, far: f64) -> bool {
        (far / near).log2().abs() < super::roots::CONSTANT
    }

    /// `b^2 - k^2` over `b^2`, root.
    fn sine(&self) -> f64 {
        (self.place.from_left.sqrt() * self.place.from_right.sqrt() / self.half).min(1.0)
    }

    fn cosine(&self) -> f64 {
        (self.at.abs() / self.half).min(1.0)
    }

    /// `-+ A`, of the odd part.
    fn odd_size(&self) -> f64 {
        if self.at > 0.0 { -self.size } else { self.size }
    }

    /// `G_e(b)`, `G_o(b)`.
    pub fn transforms(&self, powers: &Powers) -> [f64; 2] {
        let (sine, cosine, mu) = (self.sine(), self.cosine(), powers.exponent());
        let [near, rest] = powers.sines().both(sine, cosine);
        let even = powers.power(sine) * sine - mu * cosine * near;
        [self.size * self.half * even, self.odd_size() * rest]
    }

    /// `G_e'(b)`, `G_o'(b)`.
    pub fn rises(&self, powers: &Powers) -> [f64; 2] {
        let rise = self.size * powers.power(self.sine()) / self.sine();
        [rise, rise * self.at / (self.half * self.half)]
    }

    /// `mu int h_e sin t S dt`, `int h_o sin^(2+mu) t dt`.
    pub fn levers(&self, powers: &Powers) -> [f64; 2] {
        let (sine, cosine, mu) = (self.sine(), self.cosine(), powers.exponent());
        let [near, rest] = powers.sines().both(sine, cosine);
        let power = powers.power(sine) * sine;
        let even = mu * (power / (1.0 + mu) - cosine * near);
        [self.size * even, self.odd_size() * ((1.0 + mu) * rest + power * cosine) / (2.0 + mu)]
    }

    /// `a_n` of `A |s - k|`, the first two those of its force and moment about the height in the middle.
    pub fn heights(&self, powers: &Powers, norms: &[f64]) -> Vec<f64> {
        // (1-y^2)^(mu/2-1/2) c_n is a derivative twice, of (1-y^2)^(mu/2+3/2) c_(n-2) of the order mu/2 + 2.
        let mu = powers.exponent();
        let scale = 2.0 * self.size * self.half * self.sine().powf(3.0 + mu);
        let mut heights = vec![0.0; norms.len()];
        let place = (self.at / self.half).clamp(-1.0, 1.0);
        let polynomials = inside(0.5 * mu + 2.0, norms.len(), place);
        for (n, norm) in norms.iter().enumerate().skip(2) {
            heights[n] = scale * polynomials[n - 2] / ((1.0 + mu) * (3.0 + mu) * norm);
        }
        let levers = self.levers(powers).into_iter().zip([1.0 / mu, (2.0 + mu) / (1.0 + mu)]);
        for (height, (lever, share)) in heights.iter_mut().zip(levers) {
            *height = self.half * share * lever / powers.total();
        }
        heights
    }

    /// `int (G_e' + s G_o') (x^2 - s^2)^-beta dx` at a place as far from the kink, which is given because of its digits.
    pub fn pressure(&self, powers: &Powers, place: Place, from_kink: f64) -> f64 {
        // From the kink: the rounding of two distances from the ends would be felt close to it.
        let s = self.at + from_kink;
        let (apart, mirrored) = (from_kink.abs(), (s + self.at).abs());
        let outer = if s.abs() > self.at.abs() { place } else { self.place };
        let m = s.abs().max(self.at.abs());
        let end = outer.from_left.sqrt() * outer.from_right.sqrt();
        let scale = apart.sqrt() * mirrored.sqrt();
        if scale == 0.0 {
            return self.size * at_kink(powers, m, m * mirrored, end);
        }
        // `v^2` is `x^2` less the larger of `k^2` and `s^2`, `v^2 + scale^2` that less the smaller.
        let half_exponent = 0.5 * powers.exponent();
        let square = scale * scale;
        let f = |places: &[f64; ORDER]| {
            vectorised(
                #[inline(always)]
                || {
                    let squares = places.map(|v| v * v);
                    let mut values = squares.map(|v| v * (v + square) / (v + m * m));
                    powers_within(&mut values, half_exponent);
                    for (value, v) in values.iter_mut().zip(squares) {
                        *value *= (v + m * mirrored) / ((v + m * m) * (v + square).sqrt());
                    }
                    values
                },
            )
        };
        self.size * outwards(powers, [scale, end], f)
    }

    /// What the halves add to the displacement beside the zone by `(2/pi) cos(pi mu/2)`, at `|s| = r` and the sign of `s`.
    pub fn displacement(&self, powers: &Powers, r: f64, sign: f64) -> f64 {
        let (k, b, mu) = (self.at.abs(), self.half, powers.exponent());
        let scale = ((r - k) * (r + k)).sqrt();
        let end = self.place.from_left.sqrt() * self.place.from_right.sqrt();
        let beyond = ((r - b) * (r + b)).max(0.0).sqrt();
        let arm = sign * self.odd_size();
        let f = |y: f64, is_near: bool| {
            let (sine, cosine) = y.sin_cos();
            let v = scale * sine;
            let x = v.hypot(k);
            let [by_sine, by_cosine] = [v / x, k / x];
            let power = powers.power(by_sine);
            let [near, rest] = powers.sines().both_by(by_sine, by_cosine, power);
            let even = by_sine * by_sine - mu * by_cosine * by_sine * near / power;
            let odd = if is_near { -near } else { rest };
            powers.power(sine / cosine) * (r * self.size * even + arm * v * odd / power)
        };
        let (turn, total) = (end.atan2(beyond), powers.total());
        let first = (NEAREST * k / scale).min(TURN).min(turn);
        let mut sum = 0.0;
        if first > 0.0 {
            // B - S is plain at the kink but for S.
            sum += powers.integral(0, [0.0, first], |y| f(y, true));
            let plain = |y: f64| {
                let (sine, cosine) = y.sin_cos();
                let v = scale * sine;
                v * powers.power(v.hypot(k) / (scale * cosine))
            };
            sum += arm * total * powers.integral(PLAIN, [0.0, first], plain);
        }
        let shift = if first > 0.0 { PLAIN } else { 0 };
        sum += powers.graded(shift, [first, turn], [TURN, FRAC_PI_2], |y| f(y, false));
        if k > 0.0 {
            let within = |y: f64| powers.power(y.tan()) * y.sin();
            let turn = [0.0, (k / r).min(1.0).asin()];
            sum += arm * total * r * powers.graded(0, turn, [TURN, FRAC_PI_2], within);
        }
        -sum
    }
}

/// `int_0^end f` for a power at zero and other singular places at `scale` and beyond, as far from the axis.
fn outwards(
    powers: &Powers,
    [scale, end]: [f64; 2],
    f: impl Fn(&[f64; ORDER]) -> [f64; ORDER],
) -> f64 {
    let mut at = end.min(NEAREST * scale);
    let mut sum = powers.integral_at_nodes(0, [0.0, at], &f);
    while at < end {
        let next =
            if end <= (1.0 + GROWTH) * at * (1.0 + SHARE) { end } else { (1.0 + GROWTH) * at };
        sum += powers.integral_at_nodes(PLAIN, [at, next], &f);
        at = next;
    }
    sum
}

/// `int_0^end (v^2 + offset) v^(2 mu - 1) (m^2 + v^2)^(-1-mu/2) dv`.
fn at_kink(powers: &Powers, m: f64, offset: f64, end: f64) -> f64 {
    let mu = powers.exponent();
    if m == 0.0 {
        return end.powf(mu) / mu;
    }
    let regular = |v: f64| {
        let x = v * v + m * m;
        (v * v + offset) / x * x.powf(-0.5 * mu)
    };
    let power = |v: f64| v.powf(2.0 * mu - 1.0);
    let first = end.min(NEAREST * m);
    let middle = regular(0.0);
    let mut sum = middle * first.powf(2.0 * mu) / (2.0 * mu);
    for panel in 0..INWARDS {
        let to = first * SHARE.powi(panel);
        let f = |v: f64| (regular(v) - middle) * power(v);
        sum += powers.integral(PLAIN, [SHARE * to, to], f);
    }
    let mut at = first;
    while at < end {
        let next = end.min((1.0 + GROWTH) * at);
        sum += powers.integral(PLAIN, [at, next], |v| regular(v) * power(v));
        at = next;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::super::ultraspherical::{displaced, felt, norms};
    use super::super::{AbelTransform, Shape, Symmetry, Weight};
    use super::*;

    type Slope = Box<dyn Fn(f64) -> f64>;

    const HALF: f64 = 0.8;

    fn kink(at: f64) -> Kink {
        let place = Place { from_left: HALF + at, from_right: HALF - at };
        Kink { at, place, size: 0.7, half: HALF }
    }

    fn place(s: f64) -> Place {
        Place { from_left: HALF + s, from_right: HALF - s }
    }

    /// The halves of the slope on panels.
    fn shapes(slopes: &[Slope; 2], at: f64, mu: f64) -> [Shape<'_>; 2] {
        let of = |part: Symmetry| Shape {
            joints: Vec::new(),
            slope: &*slopes[usize::from(part == Symmetry::Odd)],
            breaks: vec![at.abs()],
            tolerance: 0.0,
            noise: 0.0,
            remote: 0.0,
            powers: Powers::new(mu).unwrap(),
            part,
            is_over: &|| false,
        };
        [Symmetry::Even, Symmetry::Odd].map(of)
    }

    fn slopes(at: f64) -> [Slope; 2] {
        let (k, odd) = (at.abs(), if at > 0.0 { -0.7 } else { 0.7 });
        [
            Box::new(move |r| if r > k { 0.7 } else { 0.0 }),
            Box::new(move |r| if r < k { odd } else { 0.0 }),
        ]
    }

    #[test]
    fn kinks_are_those_of_the_transforms_on_panels() {
        for (mu, at) in [(0.1, 0.3), (0.5, -0.05), (0.9, 0.7), (0.5, 1e-3)] {
            let (powers, kink, slopes) = (Powers::new(mu).unwrap(), kink(at), slopes(at));
            let shapes = shapes(&slopes, at, mu);
            let transforms = shapes.each_ref().map(|shape| AbelTransform::new(shape, HALF));
            let weights = [Weight::Lever, Weight::SineSquared];
            for part in 0..2 {
                let exact = shapes[part].transform(HALF);
                assert!((kink.transforms(&powers)[part] - exact).abs() < 4e-15, "{mu} {at}");
                let exact = shapes[part].integral(HALF, weights[part]);
                assert!((kink.levers(&powers)[part] - exact).abs() < 4e-15, "{mu} {at}");
                let exact = transforms[part].end_slope();
                assert!((kink.rises(&powers)[part] - exact).abs() < 1e-11, "{mu} {at}");
            }
            for s in [-0.79, -0.4, -0.06, 0.01, 0.29, 0.5, 0.799] {
                let [even, odd] = transforms.each_ref().map(|all| all.pressure(f64::abs(s)));
                let found = kink.pressure(&powers, place(s), s - at);
                let exact = even + s * odd;
                // It is the panels that lose digits.
                assert!((found - exact).abs() < 4e-9, "{mu} {at} {s}: {found} {exact}");
            }
            let heights = kink.heights(&powers, &norms(&powers, 400));
            for s in [0.8001, 0.806, 0.83, 1.0, -1.7, 30.0f64] {
                let [even, odd] = transforms.each_ref().map(|all| all.displacement(s.abs(), 0.0));
                let found = powers.beside() * kink.displacement(&powers, s.abs(), s.signum());
                let exact = even + s.signum() * odd;
                assert!((found - exact).abs() < 1e-11, "{mu} {at} {s}: {found} {exact}");
                let excess = s.abs() / HALF - 1.0;
                assert_eq!(felt(excess) < 400.0, s != 0.8001, "{mu} {at} {s}");
                let missed = displaced(&powers, &heights, excess, s.signum()) + found;
                assert!(missed.abs() < 4e-15 || s == 0.8001, "{mu} {at} {s}: {missed:e}");
            }
        }
    }

    #[test]
    fn heights_are_integrals_of_polynomials() {
        for (mu, at) in [(0.1, 0.3), (0.7, -0.79), (0.4, 0.0)] {
            let (powers, kink) = (Powers::new(mu).unwrap(), kink(at));
            let norms = norms(&powers, 12);
            let heights = kink.heights(&powers, &norms);
            let corner = (at / HALF).acos();
            for n in 2..12 {
                // From both ends, y = -+ cos t
                let part = |sign: f64, turn: f64| {
                    let f = |t: f64| {
                        let y = sign * t.cos();
                        let height = 0.7 * (HALF * y - at).abs();
                        height * inside(0.5 * mu, 12, y)[n] * t.sin().powf(mu)
                    };
                    powers.graded(0, [0.0, turn], [0.2, f64::INFINITY], f)
                };
                let sum = part(1.0, corner) + part(-1.0, std::f64::consts::PI - corner);
                assert!((heights[n] - sum / norms[n]).abs() < 1e-13, "{mu} {at} {n}: {sum}");
            }
        }
    }

    #[test]
    fn pressures_are_those_of_many_digits() {
        // By mpmath, 30 digits, of the integral in the head of this file.
        for (mu, at, s, exact) in [
            (0.1, 0.3, -0.06, 0.887_055_603_381_251_8),
            (0.5, -0.05, -0.050_001, 1.248_563_827_666_319_2),
            (0.5, 0.3, 0.3, 1.160_818_676_624_39),
            (0.9, 0.7, 0.1, 0.091_421_476_640_009_53),
            (0.02, 0.0, 2e-8, 10.622_153_339_117_082),
        ] {
            let found = kink(at).pressure(&Powers::new(mu).unwrap(), place(s), s - at);
            assert!((found / exact - 1.0).abs() < 1e-13, "{mu} {at} {s}: {found} {exact}");
        }
    }

    #[test]
    fn kinks_near_the_middle_are_nearly_in_the_middle() {
        // To first order in k the peak moves with the kink; d/dk of p is that of a displacement that steps, by differences from far off.
        for mu in [0.02, 0.5, 0.9] {
            let powers = Powers::new(mu).unwrap();
            let at = |k: f64, s: f64| kink(k).pressure(&powers, place(s), s - k);
            // The height in the middle, which depths are measured from, has a kink in k.
            let beside = |k: f64, s: f64| {
                let flat = powers.flat_beside((s * s / (HALF * HALF) - 1.0).sqrt());
                let own = kink(k).displacement(&powers, s.abs(), s.signum());
                powers.beside() * own - 0.7 * k.abs() * flat
            };
            for s in [0.5f64, -0.2, 0.79] {
                let rate = (at(1e-4, s) - at(-1e-4, s)) / 2e-4;
                for k in [1e-6, 1e-9, 1e-12, -1e-14] {
                    let change = at(k, s) - at(0.0, s);
                    let allowed = 4e-15 * at(0.0, s).abs() / mu + 1e-5 * (rate * k).abs();
                    assert!((change - rate * k).abs() < allowed, "{mu} {s} {k}: {change:e}");
                }
            }
            for s in [0.81, -1.3f64] {
                let rate = (beside(1e-4, s) - beside(-1e-4, s)) / 2e-4;
                for k in [1e-6, 1e-9, 1e-12, -1e-14] {
                    let change = beside(k, s) - beside(0.0, s);
                    let allowed = 1e-14 * beside(0.0, s).abs() / mu + 1e-5 * (rate * k).abs();
                    assert!((change - rate * k).abs() < allowed, "{mu} {s} {k}: {change:e}");
                }
            }
            // At the kink, and at its mirror image, whatever there is to a half alone.
            for k in [1e-3, 1e-8, 1e-12] {
                let peak = at(k, k);
                assert!((peak / at(0.0, 0.0) - 1.0).abs() < 4.0 * k, "{mu} {k}: {peak}");
                let (near, other) = (at(k, -k), at(0.0, 2.0 * k));
                assert!((near / other - 1.0).abs() < 4.0 * k + 1e-14, "{mu} {k}: {near} {other}");
                let (near, far) = (at(k, 1.1 * k), at(0.0, 0.1 * k));
                let allowed = 4.0 * k + 1e-13;
                assert!((near / far - 1.0).abs() < allowed, "{mu} {k}: {near} {far}");
            }
        }
    }
}
