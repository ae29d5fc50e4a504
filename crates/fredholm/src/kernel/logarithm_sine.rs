//! Kernel 3: `ln 1/(2 sin(|x - s|/2))` on `(-alpha, alpha)`.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{
    EndExponents, Expansion, Gram, Kernel, Moments, Pair, Parity, Singularity, SpectralRelation,
    Split,
};
use crate::basis::Function;
use crate::basis::harmonics::Harmonics;
use crate::quadrature::double_exponential;
use crate::special::exponential_sum::ExponentialSum;
use crate::special::{logarithms, sines};
use crate::{Error, Interval, memory};

/// `pi` less its nearest double.
const PI_REST: f64 = 1.224_646_799_147_353_2e-16;
/// Nodes on either side of the middle of the rule for the integrals of the Gram matrix; 1e-16 up to `j = 1e6`.
const RULE: usize = 160;
/// Coefficients below this share of the largest value of a function are rounding.
const ROUNDING: f64 = 4e-16;
/// A part with an error below this share of the largest value is resolved, whatever its own size.
const RESOLVED: f64 = 1e-12;

/// `K(x, s) = ln 1/(2 sin(|x - s|/2))` on `(-alpha, alpha)`, `0 < alpha < pi`: a punch of a periodic row (period `2 pi`, width `2 alpha`), a stamp on an
/// arc of a circle. Positive.
///
/// Spectral relation: with `sigma = sin(alpha/2)`, `tau = tan(alpha/2)`, `phi_n = T_n(sin(x/2)/sigma)` for even `n` and `T_n(tan(x/2)/tau)` for odd `n`,
/// each with the weight of its parity,
///
/// `w = cos(x/2)/(2 sqrt(sigma^2 - sin^2(x/2)))` for even `n`, times `cos(alpha/2)/cos^2(x/2)` for odd `n`,
///
/// `lambda_0 = pi ln(1/sigma)`, `lambda_n = pi/n`, `h_0 = pi`, `h_n = pi/2`. No explicit system has one weight for both parities; the expansion of
/// the kernel holds with this one, and functions are expanded with the weight of each of their parts.
///
/// Gram matrix: `R_{2k,2m} = (e_{k+m} + e_{|k-m|})/2`, `R_{2k+1,2m+1} = (o_{k+m+1} + o_{|k-m|})/2`, else 0, with `e_0 = o_0 = 2 alpha` and
///
/// `e_j = -2 int_alpha^pi exp(-2j acosh(sin(x/2)/sigma)) dx`,
/// `o_j = 2 pi (-1)^j tan^{2j}(alpha/4) - 2 int_alpha^pi exp(-2j acosh(tan(x/2)/tau)) dx`,
///
/// which are `int T_2j(sin(x/2)/sigma) dx` and `int T_2j(tan(x/2)/tau) dx` over `(-alpha, alpha)` with the path moved to where the polynomials decay.
///
/// As `alpha -> pi` the odd functions oscillate ever nearer to the ends: the spectral method needs many more than `tau` terms.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogarithmSine {
    interval: Interval,
}

impl LogarithmSine {
    /// The kernel on `(-alpha, alpha)`; angles in radians.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `1e-150 <= alpha < pi`.
    pub fn new(alpha: f64) -> Result<Self, Error> {
        if (1e-150..PI).contains(&alpha) {
            return Ok(Self { interval: Interval::symmetric(alpha)? });
        }
        Err(Error::InvalidParameter {
            name: "alpha",
            value: alpha,
            requirement: "at least 1e-150 and below pi: on the whole circle the kernel is no longer positive definite, constants go to 0",
        })
    }

    /// `alpha`.
    #[must_use]
    pub fn alpha(&self) -> f64 {
        self.interval.right()
    }

    fn sigma(&self) -> f64 {
        (0.5 * self.alpha()).sin()
    }

    fn tau(&self) -> f64 {
        (0.5 * self.alpha()).tan()
    }

    /// `T_{2m}(sin(x/2)/sigma)`.
    fn even_harmonics(&self, x: f64) -> Harmonics {
        let (alpha, sigma) = (self.alpha(), self.sigma());
        let x = x.abs().min(alpha);
        let complement = 2.0 * (0.25 * (alpha + x)).cos() * (0.25 * (alpha - x)).sin() / sigma;
        Harmonics::even_chebyshev((0.5 * x).sin() / sigma, complement)
    }

    /// `T_{2m+1}(tan(x/2)/tau)`.
    fn odd_harmonics(&self, x: f64) -> Harmonics {
        let (alpha, from_zero) = (self.alpha(), x.abs().min(self.alpha()));
        let half = 0.5 * from_zero;
        let complement = (0.5 * (alpha - from_zero)).sin() / (self.sigma() * half.cos());
        let harmonics = Harmonics::odd_chebyshev(half.tan() / self.tau(), complement);
        if x < 0.0 { harmonics.negated() } else { harmonics }
    }

    /// `sin(x/2) = sigma xi` solved for `x`.
    fn even_position(&self, xi: f64) -> f64 {
        let (sine, cosine) = (0.5 * self.alpha()).sin_cos();
        // cos^2(x/2), without cancellation where sigma is near 1
        let square = cosine * cosine + sine * sine * (1.0 - xi) * (1.0 + xi);
        self.inside(2.0 * (sine * xi).atan2(square.sqrt()))
    }

    /// `tan(x/2) = tau xi` solved for `x`.
    fn odd_position(&self, xi: f64) -> f64 {
        self.inside(2.0 * (self.tau() * xi).atan())
    }

    fn inside(&self, x: f64) -> f64 {
        x.clamp(-self.alpha(), self.alpha())
    }

    /// `pi - alpha`.
    fn gap(&self) -> f64 {
        PI - self.alpha() + PI_REST
    }

    /// A rule for the integrals over `(alpha, pi)`, by the rate at a point from its distances to both ends. In the variable `ln x` it
    /// resolves what happens at the scale of `alpha`, however small that is.
    fn beyond(&self, rate: impl Fn(f64, f64) -> f64) -> ExponentialSum {
        let alpha = self.alpha();
        let half = 0.5 * (self.gap() / alpha).ln_1p();
        ExponentialSum::new(double_exponential(RULE).map(|node| {
            let from_alpha = alpha * (half * node.from_left).exp_m1();
            let from_pi = -PI * (-half * node.from_right).exp_m1();
            (half * node.weight * (alpha + from_alpha), rate(from_alpha, from_pi))
        }))
    }

    /// `e_0, e_1, ...`, at least one.
    fn even_integrals(&self, count: usize) -> Vec<f64> {
        let (sigma, gap) = (self.sigma(), self.gap());
        // acosh c = 2 asinh sqrt((c - 1)/2), and sin(x/2) - sigma = 2 cos((x + alpha)/4) sin((x - alpha)/4)
        let moments = self.beyond(|from_alpha, from_pi| {
            let excess = (0.25 * (from_pi + gap)).sin() * (0.25 * from_alpha).sin() / sigma;
            4.0 * excess.sqrt().asinh()
        });
        let later = moments.moments(count.saturating_sub(1)).into_iter().map(|s| -2.0 * s);
        std::iter::once(2.0 * self.alpha()).chain(later).collect()
    }

    /// `o_0, o_1, ...`, at least one.
    fn odd_integrals(&self, count: usize) -> Vec<f64> {
        let sigma = self.sigma();
        // tan(x/2) - tau = sin((x - alpha)/2)/(cos(x/2) cos(alpha/2))
        let moments = self.beyond(|from_alpha, from_pi| {
            let excess = 0.5 * (0.5 * from_alpha).sin() / (sigma * (0.5 * from_pi).sin());
            4.0 * excess.sqrt().asinh()
        });
        // -ln tan^2(alpha/4), with 1/tau in all its digits: the pole of 1/(1 + tau^2 xi^2)
        let inverse = if self.alpha() < 2.0 { 1.0 / self.tau() } else { (0.5 * self.gap()).tan() };
        let rate = 2.0 * inverse.asinh();
        let later = moments.moments(count.saturating_sub(1)).into_iter().zip(1..).map(|(s, j)| {
            let pole = 2.0 * PI * (-rate * f64::from(j)).exp();
            if j % 2 == 0 { pole - 2.0 * s } else { -pole - 2.0 * s }
        });
        std::iter::once(2.0 * self.alpha()).chain(later).collect()
    }

    /// The even and the odd part of a function as series of Chebyshev polynomials in `sin(x/2)/sigma` and `tan(x/2)/tau`.
    fn parts(&self, f: &dyn Fn(f64) -> f64) -> Result<Parts, Error> {
        let even = Function::resolve(&|xi| {
            let x = self.even_position(xi);
            0.5 * f(x) + 0.5 * f(-x)
        })?;
        let odd = Function::resolve(&|xi| {
            let x = self.odd_position(xi);
            0.5 * f(x) - 0.5 * f(-x)
        })?;
        let largest = even.largest().max(odd.largest());
        let error = (even.error() * even.largest()).max(odd.error() * odd.largest());
        let error = if largest > 0.0 { error / largest } else { 0.0 };
        Ok(Parts {
            even: kept(even.series().coefficients().iter().step_by(2), largest),
            odd: kept(odd.series().coefficients().iter().skip(1).step_by(2), largest),
            error,
            // One part may be nothing but rounding of the other: its own series then never ends.
            resolved: (even.is_resolved() && odd.is_resolved()) || error <= RESOLVED,
        })
    }
}

/// A function in two series.
struct Parts {
    even: Vec<f64>,
    odd: Vec<f64>,
    error: f64,
    resolved: bool,
}

/// The coefficients without the last ones that are rounding.
fn kept<'c>(coefficients: impl Iterator<Item = &'c f64>, largest: f64) -> Vec<f64> {
    let mut coefficients: Vec<f64> = coefficients.copied().collect();
    let matters = |c: &f64| c.abs() > ROUNDING * largest;
    coefficients.truncate(coefficients.iter().rposition(matters).map_or(0, |last| last + 1));
    coefficients
}

/// `(1/2) sum_m c_m (integrals[k + m + shift] + integrals[|k - m|])`.
fn moment(coefficients: &[f64], integrals: &[f64], shift: usize, k: usize) -> f64 {
    let term = |(m, c): (usize, &f64)| c * (integrals[k + m + shift] + integrals[k.abs_diff(m)]);
    0.5 * coefficients.iter().enumerate().map(term).sum::<f64>()
}

impl Kernel for LogarithmSine {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        Singularity::Logarithm
    }

    fn split(&self, _x: f64, _s: f64, distance: f64) -> Split {
        let half = 0.5 * distance;
        let quotient = if distance == 0.0 { 1.0 } else { half.sin() / half };
        Split { factor: -1.0, rest: -quotient.ln() }
    }

    fn pair(&self, _x: f64, _s: f64, distance: f64) -> Pair {
        Pair { value: -(2.0 * (0.5 * distance).sin()).ln(), factor: -1.0 }
    }

    fn pairs(
        &self,
        _x: f64,
        _points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        factors: &mut [f64],
    ) {
        let halves = values.iter_mut().zip(distances);
        halves.for_each(|(half, distance)| *half = 0.5 * distance);
        sines(values);
        values.iter_mut().for_each(|value| *value *= 2.0);
        logarithms(values);
        values.iter_mut().for_each(|value| *value = -*value);
        factors.fill(-1.0);
    }

    fn is_even(&self) -> bool {
        true
    }
}

impl SpectralRelation for LogarithmSine {
    fn weight_exponents(&self) -> EndExponents {
        EndExponents { left: -0.5, right: -0.5 }
    }

    fn weight_rest(&self, n: usize, x: f64) -> f64 {
        // sigma^2 - sin^2(x/2) = sin((alpha - x)/2) sin((alpha + x)/2)
        let quotient = |d: f64| if d == 0.0 { 1.0 } else { 0.5 * d / (0.5 * d).sin() };
        let x = self.inside(x);
        let root = (quotient(self.alpha() - x) * quotient(self.alpha() + x)).sqrt();
        let cosine = (0.5 * x).cos();
        let factor = if n.is_multiple_of(2) { cosine } else { (0.5 * self.alpha()).cos() / cosine };
        factor * root
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        if n == 0 { PI * self.expansion_factor(0) } else { PI / n as f64 }
    }

    fn norm(&self, n: usize) -> f64 {
        if n == 0 { PI } else { FRAC_PI_2 }
    }

    fn expansion_factor(&self, n: usize) -> f64 {
        if n == 0 {
            let (sine, cosine) = (0.5 * self.alpha()).sin_cos();
            // Near pi the logarithm of the sine is the square of the small cosine.
            if cosine < 0.5 { -0.5 * (-cosine * cosine).ln_1p() } else { -sine.ln() }
        } else {
            2.0 / n as f64
        }
    }

    fn parity(&self) -> Parity {
        Parity::Alternating
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        self.even_harmonics(x).fill(values.iter_mut().step_by(2));
        self.odd_harmonics(x).fill(values.iter_mut().skip(1).step_by(2));
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        let even = self.even_harmonics(x).sum(coefficients.iter().step_by(2));
        even + self.odd_harmonics(x).sum(coefficients.iter().skip(1).step_by(2))
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        memory::admit(count.saturating_sub(1), 8.0 * (count as f64).powi(2))?;
        let (even, odd) = (self.even_integrals(count + 1), self.odd_integrals(count + 1));
        let entry = |index: usize| {
            let (row, column) = (index / count, index % count);
            if !(row + column).is_multiple_of(2) {
                return 0.0;
            }
            // Both formulae at once: k + m, and k + m + 1 for odd functions, are half the rounded-up sum of the indices.
            let integrals = if row.is_multiple_of(2) { &even } else { &odd };
            0.5 * (integrals[(row + column) / 2] + integrals[row.abs_diff(column) / 2])
        };
        Ok(Gram::Dense { order: count, entries: (0..count * count).map(entry).collect() })
    }

    /// The even and the odd part of `f` are expanded each with the weight of its parity.
    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        let Parts { even, odd, error, resolved } = self.parts(f)?;
        let count = (2 * even.len()).saturating_sub(1).max(2 * odd.len()).max(1);
        let mut coefficients = vec![0.0; count];
        coefficients.iter_mut().step_by(2).zip(&even).for_each(|(c, e)| *c = *e);
        coefficients.iter_mut().skip(1).step_by(2).zip(&odd).for_each(|(c, o)| *c = *o);
        Ok(Expansion { coefficients, error, resolved })
    }

    /// From both series by the sums of the Gram matrix, which need not be formed.
    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        memory::admit(count.saturating_sub(1), 24.0 * count as f64)?;
        let Parts { even, odd, error, resolved } = self.parts(f)?;
        let half = count.div_ceil(2);
        let even_integrals = self.even_integrals(half + even.len() + 1);
        let odd_integrals = self.odd_integrals(half + odd.len() + 2);
        let value = |n: usize| {
            if n.is_multiple_of(2) {
                moment(&even, &even_integrals, 0, n / 2)
            } else {
                moment(&odd, &odd_integrals, 1, n / 2)
            }
        };
        Ok(Moments { values: (0..count).map(value).collect(), error, resolved })
    }
}
