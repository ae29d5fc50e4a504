//! The companion of kernel 2: `ln 1/|x^2 - s^2|` on `(b, a)`.

use std::f64::consts::{FRAC_PI_2, PI};

use super::half_sums::half_sums;
use super::{
    EndExponents, Expansion, Gram, Kernel, Moments, Pair, Parity, Singularity, SpectralRelation,
    Split,
};
use crate::basis::harmonics::Harmonics;
use crate::basis::interval_moments::interval_moments;
use crate::basis::{ChebyshevSeries, Function};
use crate::quadrature::double_exponential;
use crate::special::exponential_sum::ExponentialSum;
use crate::special::logarithms;
use crate::{Error, Interval};

/// Nodes on either side of the middle of the rule for the integrals of the Gram matrix; 1e-16 up to `j = 1e6`.
const RULE: usize = 160;
/// Range of the ends and of the gauge: squares neither overflow nor vanish.
const LENGTHS: std::ops::RangeInclusive<f64> = 1e-150..=1e150;

/// `K(x, s) = ln l^2/|x^2 - s^2|` on `(b, a)`, `0 <= b < a`, with the gauge length `l`, 1 unless said: two equal punches on `(b, a)` and
/// `(-a, -b)` loaded alike. Any load of two punches is a sum of one for this kernel and one for [`LogarithmRatio`](super::LogarithmRatio). At `b = 0` it is the even
/// half of [`Logarithm`](super::Logarithm) on `(-a, a)`.
///
/// Spectral relation: `phi_n = T_n((2x^2 - a^2 - b^2)/(a^2 - b^2))`, `w = 2x/sqrt((a^2 - x^2)(x^2 - b^2))`,
/// `lambda_0 = pi ln(4 l^2/(a^2 - b^2))`, `lambda_n = pi/n`, `h_0 = pi`, `h_n = pi/2`. The kernel is positive for `a^2 - b^2 < 4 l^2`, when the
/// capacity of the two intervals is below the gauge.
///
/// Gram matrix: `R_km = (g_{k+m} + g_{|k-m|})/2`, `g_0 = a - b`, `g_j = -A_j - (-1)^j B_j` with
///
/// `A_j = int_a^inf exp(-2j asinh(sqrt((X^2 - a^2)/(a^2 - b^2)))) dX`, `B_j = int_0^b exp(-2j asinh(sqrt((b^2 - Y^2)/(a^2 - b^2)))) dY`,
///
/// which is `int_b^a phi_j dx` with the path moved to where `phi_j` decays; `g_j = -a/(4j^2 - 1)` for `b = 0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LogarithmSquare {
    interval: Interval,
    gauge: f64,
    /// `2 ln l`.
    offset: f64,
}

impl LogarithmSquare {
    /// The kernel on `(inner, outer)`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `0 <= inner < outer` and `outer` lies between `1e-150` and `1e150`.
    pub fn new(inner: f64, outer: f64) -> Result<Self, Error> {
        Self::with_gauge(inner, outer, 1.0)
    }

    /// `ln gauge^2/|x^2 - s^2|` on `(inner, outer)`.
    ///
    /// # Errors
    /// As [`LogarithmSquare::new`]; unless `gauge` lies between `1e-150` and `1e150`.
    pub fn with_gauge(inner: f64, outer: f64, gauge: f64) -> Result<Self, Error> {
        let requirement =
            "between 1e-150 and 1e150, so that its square neither overflows nor vanishes";
        if !LENGTHS.contains(&outer) {
            return Err(Error::InvalidParameter { name: "outer end", value: outer, requirement });
        }
        if !LENGTHS.contains(&gauge) {
            return Err(Error::InvalidParameter { name: "gauge", value: gauge, requirement });
        }
        if !(inner >= 0.0 && inner < outer) {
            return Err(Error::InvalidParameter {
                name: "inner end",
                value: inner,
                requirement: "at least 0 and below the outer end: x^2 must be increasing",
            });
        }
        let interval = Interval::new(inner, outer)?;
        Ok(Self { interval, gauge, offset: 2.0 * gauge.ln() })
    }

    /// `b`.
    #[must_use]
    pub fn inner(&self) -> f64 {
        self.interval.left()
    }

    /// `a`.
    #[must_use]
    pub fn outer(&self) -> f64 {
        self.interval.right()
    }

    /// The eigenfunctions at a point: `x^2 = a^2 cos^2(t/2) + b^2 sin^2(t/2)`.
    fn harmonics(&self, x: f64) -> Harmonics {
        let (a, b) = (self.outer(), self.inner());
        let x = x.clamp(b, a);
        // The squares of both are sin^2(t/2) and cos^2(t/2) times a^2 - b^2.
        let (from_outer, from_inner) =
            ((a - x).sqrt() * (a + x).sqrt(), (x - b).sqrt() * (x + b).sqrt());
        if from_outer < from_inner {
            Harmonics::cosines(2.0 * from_outer.atan2(from_inner), false)
        } else {
            Harmonics::cosines(2.0 * from_inner.atan2(from_outer), true)
        }
    }

    /// `x` for `cos t`.
    fn position(&self, cosine: f64) -> f64 {
        let (outer, inner) = ((0.5 + 0.5 * cosine).sqrt(), (0.5 - 0.5 * cosine).sqrt());
        (self.outer() * outer).hypot(self.inner() * inner).clamp(self.inner(), self.outer())
    }

    /// `g_0, g_1, ...`.
    fn integrals(&self, count: usize) -> Vec<f64> {
        let (a, b) = (self.outer(), self.inner());
        let mut integrals = vec![a - b];
        if b == 0.0 {
            integrals.extend((1..count).map(|j| {
                let j = 2.0 * j as f64;
                -a / ((j - 1.0) * (j + 1.0))
            }));
        } else {
            let beyond = self.beyond_outer().moments(count.saturating_sub(1));
            let within = self.within_inner().moments(count.saturating_sub(1));
            let signs = [1.0, -1.0].into_iter().cycle();
            integrals
                .extend(beyond.iter().zip(within).zip(signs).map(|((a, b), sign)| sign * b - a));
        }
        integrals.truncate(count);
        integrals
    }

    /// `A_j` over `y = e^(-t/2)` in `(0, 1)`, `X^2 = a^2 + (a^2 - b^2) sinh^2(t/2)`: `dX = (a^2 - b^2) sinh(t)/(4X) dt`, `rho = y^2`.
    fn beyond_outer(&self) -> ExponentialSum {
        let (a, ratio) = (self.outer(), self.inner() / self.outer());
        let share = (1.0 - ratio) * (1.0 + ratio);
        ExponentialSum::new(double_exponential(RULE).map(|node| {
            let (y, from_one) = (0.5 * node.from_left, 0.5 * node.from_right);
            let square = y * y;
            let gap = from_one * (1.0 + y);
            // y X/a
            let scaled = (square + 0.25 * share * gap * gap).sqrt();
            let density = 0.25 * share * gap * (1.0 + square) / (square * scaled);
            let logarithm = if from_one < 0.5 { (-from_one).ln_1p() } else { y.ln() };
            (0.5 * a * node.weight * density, -2.0 * logarithm)
        }))
    }

    /// `B_j` over `p` in `(0, ln(a/(a - b)))`, `Y = b - (a - b) (e^p - 1)`: it resolves the end `Y = b` at the scale of `a - b`, however
    /// small that is.
    fn within_inner(&self) -> ExponentialSum {
        let (a, b) = (self.outer(), self.inner());
        let half = 0.5 * (b / (a - b)).ln_1p();
        ExponentialSum::new(double_exponential(RULE).map(|node| {
            let gap = (half * node.from_left).exp_m1();
            let beside = ((2.0 * b - (a - b) * gap) / (a + b)).max(0.0);
            let rate = 2.0 * (gap * beside).sqrt().asinh();
            (half * node.weight * (a - b) * (1.0 + gap), rate)
        }))
    }
}

impl Kernel for LogarithmSquare {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        Singularity::Logarithm
    }

    fn split(&self, x: f64, s: f64, _distance: f64) -> Split {
        Split { factor: -1.0, rest: self.offset - (x + s).ln() }
    }

    fn pair(&self, x: f64, s: f64, distance: f64) -> Pair {
        Pair { value: self.offset - (x + s).ln() - distance.ln(), factor: -1.0 }
    }

    fn pairs(
        &self,
        x: f64,
        points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        factors: &mut [f64],
    ) {
        values.copy_from_slice(distances);
        logarithms(values);
        factors.iter_mut().zip(points).for_each(|(sum, s)| *sum = x + s);
        logarithms(factors);
        let logarithms = values.iter_mut().zip(&*factors);
        logarithms.for_each(|(value, sum)| *value = self.offset - sum - *value);
        factors.fill(-1.0);
    }
}

impl SpectralRelation for LogarithmSquare {
    fn weight_exponents(&self) -> EndExponents {
        // At b = 0 the factor x removes the singularity there.
        EndExponents { left: if self.inner() == 0.0 { 0.0 } else { -0.5 }, right: -0.5 }
    }

    fn weight_rest(&self, _n: usize, x: f64) -> f64 {
        let (a, b) = (self.outer(), self.inner());
        let at_inner = if b == 0.0 { 1.0 } else { x / (x + b).sqrt() };
        2.0 * at_inner / (a + x).sqrt()
    }

    fn eigenvalue(&self, n: usize) -> f64 {
        if n == 0 { PI * self.expansion_factor(0) } else { PI / n as f64 }
    }

    fn norm(&self, n: usize) -> f64 {
        if n == 0 { PI } else { FRAC_PI_2 }
    }

    fn expansion_factor(&self, n: usize) -> f64 {
        if n == 0 {
            let (p, q) = (
                2.0 * self.gauge / (self.outer() - self.inner()),
                2.0 * self.gauge / (self.outer() + self.inner()),
            );
            // Where the logarithm is small, the sum of two would lose digits; elsewhere the product may overflow.
            if (0.5..2.0).contains(&(p * q)) { (p * q).ln() } else { p.ln() + q.ln() }
        } else {
            2.0 / n as f64
        }
    }

    fn parity(&self) -> Parity {
        Parity::None
    }

    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        self.harmonics(x).fill(values.iter_mut());
    }

    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        self.harmonics(x).sum(coefficients.iter())
    }

    fn largest_sum(&self, coefficients: &[f64]) -> Option<f64> {
        Some(ChebyshevSeries::new(coefficients.to_vec()).largest_value())
    }

    fn gram(&self, count: usize) -> Result<Gram, Error> {
        half_sums(count, 0, |count| self.integrals(count))
    }

    /// Converges fast for functions of `x^2` that are smooth on `[b, a]`; for others slowly where `b` is far below `a`.
    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        let function = Function::resolve(&|cosine| f(self.position(cosine)))?;
        Ok(Expansion {
            coefficients: function.series().coefficients().to_vec(),
            error: function.error(),
            resolved: function.is_resolved(),
        })
    }

    /// By a rule on the interval: the functions need not be even for it.
    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        interval_moments(self, f, count, 2)
    }
}
