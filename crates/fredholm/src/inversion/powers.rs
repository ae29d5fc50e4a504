//! What the exponent of grading brings into the transforms of smooth contact: powers, their rules, and the integral of a power of the sine.
//!
//! The kernels `W_k(r, s) = int_0^inf t^mu J_k(r t) J_k(s t) dt`, `k = -1/2, 1/2` for even and odd pressures in the plane, 0 and 1 for disks, split by Sonine's first
//! integral into two of Abel's, with `beta = (1-mu)/2`:
//!
//! `W_k(r, s) = 4^(1-beta)/Gamma(beta)^2 (r s)^-k int_0^min t^(2k+mu) (r^2 - t^2)^(beta-1) (s^2 - t^2)^(beta-1) dt`,
//!
//! which is Copson's way (E. T. Copson 1947, Proc. Edinburgh Math. Soc. 8; I. N. Sneddon, *Mixed Boundary Value Problems*, 1966).

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::{Arc, OnceLock};

use libm::tgamma;

use super::accuracy::STEPS;
use super::rule::{ORDER, RULE, integral, integral_at_nodes};
use crate::Error;

/// A start below this share of the end is none. Half and twice change none of 19 answers (survey).
const NOTHING: f64 = 1e-18;
/// Share of the way to a singular place that a step takes. Half and twice change none of 19 answers (survey).
const CLOSING: f64 = 0.75;
/// Share of the way from zero that the next step takes. At half or twice 14 of 20 answers change, within what they state (survey).
pub(crate) const GROWTH: f64 = 3.0;
/// A first step beside a singular place is so long, in distances from there. At half or twice 6 of 13 answers change, within what they state (survey).
pub(crate) const NEAREST: f64 = 1.5;
/// Length of a step in the angle within which polynomials are integrated exactly. At half or twice 1 of 22 answers change, within what they state (survey).
pub const TURN: f64 = 0.5;

/// In the place of the shift of an exponent: no power at zero.
pub const PLAIN: i32 = 2;

/// From here on below the end polynomials of `e^y` are so small that half of the way left is one step. Half and twice change none of 20 answers (survey).
const DISTANT: f64 = 8.0;

/// The length of a step of a logarithm, this far below the end, that may be longer than others.
pub(crate) fn distant(left: f64) -> Option<f64> {
    (left >= DISTANT).then_some(0.5 * left)
}

/// A Gauss rule for functions `x^e g(x)` on an interval from zero.
#[derive(Debug)]
pub(crate) struct PowerRule {
    /// Places in `(0, 1)`, and their weights over `u^e`.
    nodes: Vec<(f64, f64)>,
}

impl PowerRule {
    /// For an exponent above -1; of others integrals are no numbers.
    fn new(exponent: f64) -> Self {
        let plain = |u: f64, weight: f64| (u, weight * u.powf(-exponent));
        let nodes = match crate::quadrature::gauss_power(ORDER, exponent) {
            Ok(nodes) => nodes.iter().map(|node| plain(node.from_left, node.weight)).collect(),
            Err(_) => vec![(f64::NAN, f64::NAN)],
        };
        Self { nodes }
    }

    /// `int_0^end f`.
    pub(crate) fn integral(&self, end: f64, f: impl Fn(f64) -> f64) -> f64 {
        end * self.nodes.iter().map(|(u, weight)| weight * f(end * u)).sum::<f64>()
    }

    /// The same for a function of all nodes at once.
    fn integral_at_nodes(&self, end: f64, f: impl Fn(&[f64; ORDER]) -> [f64; ORDER]) -> f64 {
        let mut places = [f64::NAN; ORDER];
        for (place, (u, _)) in places.iter_mut().zip(&self.nodes) {
            *place = end * u;
        }
        let values = f(&places);
        end * self.nodes.iter().zip(values).map(|((_, weight), value)| weight * value).sum::<f64>()
    }
}

/// The exponent `mu` and what belongs to it.
#[derive(Debug, Clone)]
pub struct Powers {
    exponent: f64,
    /// For `x^(mu-1)`, `x^mu` and `x^(mu+1)`, once they are asked for; none on a homogeneous body, where all powers are plain.
    rules: Option<Arc<[OnceLock<PowerRule>; 3]>>,
    sines: Arc<SinePower>,
}

impl Powers {
    /// # Errors
    /// [`Error::InvalidValue`] unless `0 <= mu < 1`.
    pub fn new(exponent: f64) -> Result<Self, Error> {
        let requirement = "0, or more than a rounding of 1 and less than 1";
        if exponent != 0.0 && !(exponent < 1.0 && exponent - 1.0 > -1.0) {
            return Err(Error::InvalidParameter {
                name: "exponent of grading",
                value: exponent,
                requirement,
            });
        }
        let rules = (exponent > 0.0).then(Arc::default);
        Ok(Self { exponent, rules, sines: Arc::new(SinePower::new(exponent)) })
    }

    /// `mu`.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// `beta = (1-mu)/2`: at a corner the pressure is singular as `d^-beta`.
    pub fn corner_exponent(&self) -> f64 {
        0.5 * (1.0 - self.exponent)
    }

    /// `x^mu`.
    pub fn power(&self, x: f64) -> f64 {
        if self.exponent == 0.0 { 1.0 } else { x.powf(self.exponent) }
    }

    /// `(c^2 - r^2)^beta` from the root of `c^2 - r^2`.
    pub fn taper(&self, root: f64) -> f64 {
        if self.exponent == 0.0 { root } else { root.powf(1.0 - self.exponent) }
    }

    /// `sqrt(2 pi) (2c)^-beta`: of `(c^2 - r^2)^-beta` the factor of `d^-beta/sqrt(2 pi)` at the edge.
    pub fn corner(&self, half: f64) -> f64 {
        (2.0 * PI).sqrt() * (2.0 * half).powf(-self.corner_exponent())
    }

    /// `4^beta pi/(Lambda Gamma(1-beta)^2)`, the `E` of `p = (E/pi) [d(c) (c^2 - r^2)^-beta + ..]`, if `Lambda int W_k p s ds` is the displacement.
    pub fn modulus(&self, response: f64) -> f64 {
        let beta = self.corner_exponent();
        4f64.powf(beta) * PI / (response * tgamma(1.0 - beta).powi(2))
    }

    /// `(2/pi) cos(pi mu/2)`.
    pub fn beside(&self) -> f64 {
        2.0 / PI * (FRAC_PI_2 * self.exponent).cos()
    }

    /// `(2/pi) cos(pi mu/2) mu B int_0^{asin(1/y)} tan^mu t/sin t dt` by `sqrt(y^2 - 1)`: what a flat strip that settles by 1 makes of the surface beside it.
    pub fn flat_beside(&self, root: f64) -> f64 {
        let (mu, sines) = (self.exponent, &self.sines);
        let scale = self.beside() * mu * sines.total;
        let square = 1.0 + root * root;
        // p = 1/y^2 in int p^(mu/2-1) (1-p)^(-(1+mu)/2) dp/2, from either end
        let near = root * (root / square);
        if near < 0.5 {
            1.0 - scale * near.powf(0.5 * (1.0 - mu)) * sum(&sines.close, near)
        } else {
            scale * square.powf(-0.5 * mu) * sum(&sines.remote, 1.0 / square)
        }
    }

    pub(crate) fn sines(&self) -> &SinePower {
        &self.sines
    }

    /// `B = int_0^{pi/2} sin^mu t dt`.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.sines.total
    }

    /// The rule for `x^(mu + shift)`, `shift` -1, 0 or 1; none for others.
    fn rule(&self, shift: i32) -> Option<&PowerRule> {
        let index = usize::try_from(shift + 1).ok()?;
        let rule = self.rules.as_ref()?.get(index)?;
        Some(rule.get_or_init(|| PowerRule::new(self.exponent + f64::from(shift))))
    }

    /// `int_from^to f`, where `f` at zero is `x^(mu + shift)` times something smooth, or [`PLAIN`].
    pub fn integral(&self, shift: i32, [from, to]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
        match self.rule(shift) {
            Some(rule) if from == 0.0 => rule.integral(to, f),
            _ => integral(from, to, f),
        }
    }

    /// The same for a function of all nodes at once.
    pub(crate) fn integral_at_nodes(
        &self,
        shift: i32,
        [from, to]: [f64; 2],
        f: impl Fn(&[f64; ORDER]) -> [f64; ORDER],
    ) -> f64 {
        match self.rule(shift) {
            Some(rule) if from == 0.0 => rule.integral_at_nodes(to, f),
            _ => integral_at_nodes(from, to, f),
        }
    }

    /// Whether these are those of polynomials.
    pub(crate) fn is_plain(&self, [from, _]: [f64; 2]) -> bool {
        self.rules.is_none() || from > 0.0
    }

    /// Nodes and weights of that for `x^mu` at zero.
    pub fn nodes(&self, [from, to]: [f64; 2]) -> Vec<(f64, f64)> {
        match self.rule(0) {
            Some(rule) if from == 0.0 => {
                rule.nodes.iter().map(|(u, weight)| (to * u, to * weight)).collect()
            }
            _ => {
                let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
                let nodes = RULE.nodes.iter().zip(&RULE.weights);
                nodes.map(|(u, weight)| (middle + half * u, half * weight)).collect()
            }
        }
    }

    /// The same in steps no longer than `step` where `f` has a power at zero, and another at `end`.
    pub fn graded(
        &self,
        shift: i32,
        [from, to]: [f64; 2],
        [step, end]: [f64; 2],
        f: impl Fn(f64) -> f64,
    ) -> f64 {
        if to <= from {
            return 0.0;
        }
        if !(to - from).is_finite() {
            return f64::NAN;
        }
        let mut at = if from < NOTHING * to { 0.0 } else { from };
        let mut sum = 0.0;
        for _ in 0..STEPS {
            let room = CLOSING * (end - at);
            let longer = distant(to - at).map_or(step, |share| share.max(step));
            let longest = if at == 0.0 { step } else { longer.min(GROWTH * at) }.min(room);
            let next = if to - at <= longest { to } else { at + longest };
            sum += self.integral(shift, [at, next], &f);
            at = next;
            if at >= to {
                break;
            }
        }
        sum
    }
}

/// `S(psi) = int_0^psi sin^mu`.
#[derive(Debug)]
pub(crate) struct SinePower {
    /// `S(pi/2)`.
    total: f64,
    /// Of `S/sin^(1+mu)` by `sin^2`, and of `(S(pi/2) - S)/cos` by `cos^2`.
    near: Vec<f64>,
    far: Vec<f64>,
    /// Of the displacement beside a flat strip, near it and far away.
    close: Vec<f64>,
    remote: Vec<f64>,
    exponent: f64,
}

impl SinePower {
    fn new(exponent: f64) -> Self {
        let series = |rising: f64, first: f64| -> Vec<f64> {
            // Of a ratio of at most 1/2, so many terms are all digits.
            // (rising)_n/n! / (2n + first)
            let mut binomial = 1.0;
            (0..f64::MANTISSA_DIGITS)
                .map(|n| {
                    let n = f64::from(n);
                    let term = binomial / (2.0 * n + first);
                    binomial *= (rising + n) / (n + 1.0);
                    term
                })
                .collect()
        };
        let total = 0.5 * PI.sqrt() * tgamma(0.5 * (1.0 + exponent)) / tgamma(1.0 + 0.5 * exponent);
        let near = series(0.5, 1.0 + exponent);
        let far = series(0.5 * (1.0 - exponent), 1.0);
        let close = series(1.0 - 0.5 * exponent, 1.0 - exponent);
        let remote = series(0.5 * (1.0 + exponent), exponent);
        Self { total, near, far, close, remote, exponent }
    }

    /// `S(psi)` and `S(pi/2) - S(psi)` from sine and cosine.
    pub(crate) fn both(&self, sine: f64, cosine: f64) -> [f64; 2] {
        self.both_by(sine, cosine, sine.powf(self.exponent))
    }

    /// The same from `sin^mu` too.
    pub(crate) fn both_by(&self, sine: f64, cosine: f64, power: f64) -> [f64; 2] {
        if sine < cosine {
            let near = sine * power * sum(&self.near, sine * sine);
            [near, self.total - near]
        } else {
            let rest = cosine * sum(&self.far, cosine * cosine);
            [self.total - rest, rest]
        }
    }

    /// `S(psi)` for `0 <= psi <= pi/2`.
    pub(crate) fn at(&self, angle: f64) -> f64 {
        let (sine, cosine) = angle.sin_cos();
        self.both(sine, cosine)[0]
    }
}

/// As many terms as matter of a series with falling coefficients, for `0 <= square <= 1/2` or so.
fn sum(series: &[f64], square: f64) -> f64 {
    let count = 2 + (f64::EPSILON.ln() / square.min(0.9).ln()) as usize;
    series.iter().take(count).rev().fold(0.0, |sum, term| term + square * sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_integral_of_a_power_of_the_sine() {
        for mu in [0.0, 0.3, 0.9] {
            let ground = Powers::new(mu).unwrap();
            for angle in [1e-9, 0.2, 0.785, 0.786, 1.2, FRAC_PI_2] {
                let f = |x: f64| x.sin().powf(mu);
                let exact = ground.graded(0, [0.0, angle], [0.25, f64::INFINITY], f);
                let found = ground.sines().at(angle);
                assert!((found / exact - 1.0).abs() < 4e-15, "{mu} {angle}: {found} {exact}");
            }
        }
        // Of the power 0 it is the angle.
        assert!((Powers::new(0.0).unwrap().sines().at(1.1) - 1.1).abs() < 1e-15);
    }

    #[test]
    fn powers_at_both_ends() {
        // B(1/2 + mu/2, 1/2 - mu/2) = 2 int_0^{pi/2} tan^mu = pi/cos(pi mu/2)
        for mu in [0.2, 0.5, 0.7] {
            let ground = Powers::new(mu).unwrap();
            let to = FRAC_PI_2 - 1e-6;
            let found = ground.graded(0, [0.0, to], [0.5, FRAC_PI_2], |y| y.tan().powf(mu));
            let cut = (FRAC_PI_2 - to).powf(1.0 - mu) / (1.0 - mu);
            let exact = FRAC_PI_2 / (FRAC_PI_2 * mu).cos() - cut;
            assert!((found - exact).abs() < 1e-11, "{mu}: {found} {exact}");
        }
    }
}
