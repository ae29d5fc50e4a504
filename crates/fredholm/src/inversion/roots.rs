//! Slopes that go as a power of the distance from a place, which is a jump if the power is zero.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::accuracy::ROUNDING;
use super::angular::Angular;
use super::rule::{ORDER, RULE, cauchy};

/// The nearest offset at which slopes beside a place are compared, in roundings of the angle, and how much farther each next one is. At half or twice stated errors grow up to 2 times (survey).
pub(super) const NEAREST: f64 = 1e4;
const FARTHER: f64 = 30.0;
/// Powers of the distance below this are none: the slope jumps. Half and twice change none of 30 answers (survey).
pub(super) const CONSTANT: f64 = 1.5e-3;
/// Powers from here on are resolved by panels. Half and twice change nothing in the one answer that asks for it (survey).
const SMOOTH: f64 = 0.999;
/// How far below what is seen the power may end, in changes of it from one offset to the next (survey).
const DRIFT: f64 = 30.0;
/// Terms of the power series of a cusp, whose argument is at most 1/2.
const TERMS: i32 = 56;

/// A profile near a place.
pub(super) struct Local<'p> {
    pub(super) profile: &'p dyn Angular,
    pub(super) is_odd: bool,
}

/// How the slope goes on one side of a place.
#[derive(Debug, Clone, Copy)]
pub(super) enum Beside {
    /// As a polynomial.
    Smooth,
    Power(Side),
    /// Neither: as a sum of several powers that nearly cancel, or too near to an end of the half turn to be seen.
    Unclear,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Side {
    /// What it tends to.
    pub(super) value: f64,
    pub(super) power: f64,
    /// What the integral of a rise of 1 over the distance may be off by.
    pub(super) error: f64,
    /// What a lower power that hides below adds to it, on both sides alike.
    pub(super) hidden: f64,
    /// What goes with the distance itself, over it.
    pub(super) lean: f64,
}

impl Local<'_> {
    fn slope(&self, angle: f64) -> Option<f64> {
        let turns = if self.is_odd { 0.0 } else { (angle / TAU).round() * TAU };
        self.profile.slope(angle - turns)
    }

    /// The power of the offset with which `g(at + offset) - g(at - offset)` goes, but for what goes with the offset itself; none where slopes are not known, or do not differ.
    pub(super) fn power(&self, at: f64) -> Option<f64> {
        let nearest = NEAREST * self.profile.blur(at);
        let jump = |offset: f64| Some(self.slope(at + offset)? - self.slope(at - offset)?);
        let bent = |offset: f64| Some(jump(FARTHER * offset)? - FARTHER * jump(offset)?);
        power(bent(nearest)?, bent(FARTHER * nearest)?)
    }

    /// How the slope goes to the right of a place, or to the left; `noise` is its rounding.
    pub(super) fn side(&self, at: f64, is_right: bool, noise: f64) -> Beside {
        let nearest = NEAREST * self.profile.blur(at);
        let mut slopes = [0.0; 5];
        for (k, slope) in (0..).zip(&mut slopes) {
            let offset = FARTHER.powi(k) * nearest;
            let end = if self.is_odd { FRAC_PI_2 - (at - FRAC_PI_2).abs() } else { PI };
            // Where only heights are known nothing tells a power.
            let known = self.slope(if is_right { at + offset } else { at - offset });
            let Some(known) = known else { return Beside::Smooth };
            if !known.is_finite() || 2.0 * offset > end {
                return Beside::Unclear;
            }
            *slope = known;
        }
        // What goes with the distance itself is the same part of each difference: without it only powers are left.
        let risen = |k: usize| slopes[k + 1] - slopes[k];
        let bent = [0, 1, 2].map(|k| risen(k + 1) - FARTHER * risen(k));
        if bent.iter().all(|b| b.abs() <= FARTHER * noise) {
            return Beside::Smooth;
        }
        let powers = power(bent[0], bent[1]).zip(power(bent[1], bent[2]));
        let Some((near, far)) = powers else { return Beside::Unclear };
        // What falls as quickly as the inverse of the distance is what a formula loses beside a crest.
        let is_lost = near < -0.5 && far < -0.5;
        if near >= SMOOTH && far >= SMOOTH || is_lost {
            return Beside::Smooth;
        }
        if near <= 0.0 || near >= SMOOTH || far <= 0.0 || far >= SMOOTH {
            return Beside::Unclear;
        }
        let first = bent[0] / (FARTHER.powf(near) - FARTHER);
        let value = slopes[0] - first / (FARTHER.powf(near) - 1.0);
        // Slopes at the nearest offset are rounded by that share of it, and so is the rise to the panel next to it.
        let rounding = 2.0 * ROUNDING / (f64::EPSILON * NEAREST);
        // Of a sum of powers the least is what remains in the end.
        let least = near - DRIFT * (near - far).abs();
        if least <= 0.0 {
            return Beside::Unclear;
        }
        let hidden = ((near / least).powi(2) - 1.0) / (PI * near);
        let error = ((1.0 / near - 1.0 / far).abs() + rounding) / PI;
        let last = FARTHER.powi(3);
        let lean = (risen(3) - first * last.powf(near)) / ((FARTHER - 1.0) * last * nearest);
        Beside::Power(Side { value, power: near, error, hidden, lean })
    }
}

/// The power of an offset by what goes with it at two.
fn power(near: f64, far: f64) -> Option<f64> {
    let power = (far / near).ln() / FARTHER.ln();
    power.is_finite().then_some(power)
}

/// The slope on a panel of the length `h` that begins or ends where it goes as a power of the distance `d`: `value + rise (d/h)^power`. No polynomial follows it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cusp {
    pub(super) is_right: bool,
    pub(super) value: f64,
    pub(super) rise: f64,
    pub(super) power: f64,
}

impl Cusp {
    /// Coefficients of the polynomial with the same moments: `int_0^1 P_k(2 t - 1) t^p dt = p (p - 1) .. (p - k + 1)/((p + 1) .. (p + k + 1))`.
    pub(super) fn coefficients(&self) -> [f64; ORDER] {
        let mut moment = self.rise / (self.power + 1.0);
        let mut coefficients = std::array::from_fn(|k| {
            let n = k as f64;
            let own = (2.0 * n + 1.0) * moment;
            moment *= (self.power - n) / (self.power + n + 2.0);
            if self.is_right || k % 2 == 0 { own } else { -own }
        });
        coefficients[0] += self.value;
        coefficients
    }

    /// `p.v. int g/(t - x) dt` over the panel, with the distances of `x` from its ends over its length; where one is below the closest, logarithms are of that.
    pub(super) fn cauchy(&self, from_left: f64, from_right: f64, closest: f64) -> f64 {
        let (z, rest) =
            if self.is_right { (from_left, from_right) } else { (-from_right, -from_left) };
        let apart = |d: f64| if d.abs() < closest { closest } else { d };
        let constant = match z.abs() {
            size if size > 2.0 => (-z.recip()).ln_1p(),
            _ => (apart(rest) / apart(z)).abs().ln(),
        };
        let whole = self.value * constant + self.rise * self.integral(z, apart(rest));
        if self.is_right { whole } else { -whole }
    }

    /// `p.v. int_0^1 t^p/(t - z) dt` from `z` and `z - 1`.
    fn integral(&self, z: f64, rest: f64) -> f64 {
        let p = self.power;
        if z.abs() <= 0.5 {
            // Over the half line it is -pi cot(pi p) z^p, or -pi/sin(pi p) |z|^p beside it.
            let series = (0..TERMS).rev().fold(0.0, |sum, k| z * sum + 1.0 / (p - f64::from(k)));
            let turned = if z > 0.0 { 1.0 / (PI * p).tan() } else { 1.0 / (PI * p).sin() };
            series - PI * turned * z.abs().powf(p)
        } else if z.abs() >= 2.0 || z.is_nan() {
            let inverse = z.recip();
            let series = (0..TERMS).rev();
            -inverse * series.fold(0.0, |sum, k| inverse * sum + 1.0 / (p + 1.0 + f64::from(k)))
        } else {
            let far = RULE.coefficients(&RULE.nodes.map(|u| (0.75 + 0.25 * u).powf(p)));
            let near = self.integral(2.0 * z, 2.0 * z - 1.0);
            0.5f64.powf(p) * near + cauchy(&far, 4.0 * z - 2.0, 4.0 * rest)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cusps_are_integrated() {
        // p.v. int_0^1 t^p/(t - z) dt by mpmath.
        for (power, z, exact) in [
            (0.1, 1e-09, 8.7827666729427),
            (0.1, 0.03, 3.157142296662138),
            (0.1, 0.4999, 0.22174278117353713),
            (0.1, 0.5001, 0.22095163505248527),
            (0.1, 0.7, -0.6315698370520375),
            (0.1, 0.97, -3.3094706743611875),
            (0.1, 1.03, -3.39561011981531),
            (0.1, 1.6, -0.9104704224363761),
            (0.1, 1.999, -0.64029240073643),
            (0.1, 2.5, -0.469752062094942),
            (0.1, 40.0, -0.023030029327593064),
            (0.1, -1e-09, 8.720125140794787),
            (0.1, -0.3, 1.280382833430863),
            (0.1, -0.51, 0.9587310890421531),
            (0.1, -1.0, 0.6190571296711518),
            (0.1, -1.9, 0.3803892279368073),
            (0.1, -7.0, 0.12100126662537825),
            (0.5, 1e-09, 1.999999998),
            (0.5, 0.03, 1.9393889630354286),
            (0.5, 0.4999, 0.7538741410027755),
            (0.5, 0.5001, 0.7532248509008064),
            (0.5, 0.7, -0.02460870144288462),
            (0.5, 0.97, -2.8039583019479686),
            (0.5, 1.03, -2.980757575661645),
            (0.5, 1.6, -0.7143683636623664),
            (0.5, 1.999, -0.49327803265876813),
            (0.5, 2.5, -0.3574721596638963),
            (0.5, 40.0, -0.01692121957189695),
            (0.5, -1e-09, 1.999900656117342),
            (0.5, -0.3, 0.8281987306837002),
            (0.5, -0.51, 0.642212422922726),
            (0.5, -1.0, 0.4292036732051034),
            (0.5, -1.9, 0.2697702681429044),
            (0.5, -7.0, 0.08782491629637493),
            (0.8, 1e-09, 1.2500002678279325),
            (0.8, 0.03, 1.3608062054524706),
            (0.8, 0.4999, 0.9363906778699639),
            (0.8, 0.5001, 0.9358902428234062),
            (0.8, 0.7, 0.26397013205577957),
            (0.8, 0.97, -2.5268580825097136),
            (0.8, 1.03, -2.7617867380743393),
            (0.8, 1.6, -0.6188726970599872),
            (0.8, 1.999, -0.4228083572201728),
            (0.8, 2.5, -0.3042350125389144),
            (0.8, 40.0, -0.014116298117348491),
            (0.8, -1e-09, 1.2499996677661291),
            (0.8, -0.3, 0.6452171960445332),
            (0.8, -0.51, 0.5094447672140988),
            (0.8, -1.0, 0.3467712026809676),
            (0.8, -1.9, 0.22066340565149703),
            (0.8, -7.0, 0.07276605108252068),
        ] {
            let cusp = Cusp { is_right: true, value: 0.0, rise: 1.0, power };
            let mirrored = Cusp { is_right: false, ..cusp };
            let found = cusp.cauchy(z, z - 1.0, 1e-30);
            assert!((found - exact).abs() < 1e-13 * (1.0 + exact.abs()), "{power} {z} {found}");
            assert_eq!(mirrored.cauchy(1.0 - z, -z, 1e-30), -found);
        }
    }

    #[test]
    fn polynomials_have_the_moments() {
        let (power, rise, value) = (0.3, 2.0, 0.7);
        for is_right in [true, false] {
            let c = Cusp { is_right, value, rise, power }.coefficients();
            // int_0^1 t^n g dt in the distance t from the cusp
            for n in 0..6 {
                let place = |u: f64| if is_right { 0.5 * (1.0 + u) } else { 0.5 * (1.0 - u) };
                let at = RULE.values(&c);
                let sum: f64 = (0..ORDER)
                    .map(|i| 0.5 * RULE.weights[i] * at[i] * place(RULE.nodes[i]).powi(n))
                    .sum();
                let n = f64::from(n);
                let exact = value / (n + 1.0) + rise / (n + 1.0 + power);
                assert!((sum - exact).abs() < 1e-13, "{is_right} {n} {sum} {exact}");
            }
        }
    }
}
