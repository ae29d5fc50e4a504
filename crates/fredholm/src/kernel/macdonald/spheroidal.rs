//! Generalised spheroidal functions, by their series of Gegenbauer polynomials.

use std::f64::consts::{FRAC_PI_2, PI};

use super::MacdonaldProfile;
use crate::Error;
use crate::basis::gegenbauer::{self, Orthonormal};
use crate::linear::{Lowest, dot, lowest};

/// Coefficients beyond the highest index, for small `c`.
const MARGIN: usize = 40;
/// The last coefficients of every function are below this.
const NEGLIGIBLE: f64 = 1e-17;
/// Most coefficients; the widest interval allowed needs a tenth of them.
const LARGEST: usize = 1 << 17;
/// End of the range of the quadrature: beyond it distances to the end underflow.
const RANGE: f64 = 6.0;
/// What the quadrature may leave out, as a logarithm.
const TAIL: f64 = 43.0;

/// The eigenfunctions on `(-1, 1)`: `phi_n = sum_j v_nj p_j` with the orthonormal Gegenbauer polynomials `p_j` of the parity of `n`.
#[derive(Debug, Clone)]
pub(super) struct Spheroidal {
    basis: Orthonormal,
    /// Polynomials of either parity.
    half: usize,
    /// `v_n`, one after the other, `half` coefficients each.
    vectors: Vec<f64>,
    pub(super) characteristic_values: Vec<f64>,
    /// `lambda_n` on `(-1, 1)`.
    pub(super) eigenvalues: Vec<f64>,
}

impl Spheroidal {
    /// The first `count` functions for the order `mu` and `c = kappa a`.
    pub(super) fn new(order: f64, c: f64, count: usize) -> Result<Self, Error> {
        // A function that lives in the 1/c next to the ends has a series that falls as exp(-j^2/2c).
        let mut half = (count + MARGIN + (2.0 * c).min(14.0 * c.sqrt()) as usize).div_ceil(2);
        loop {
            let basis = Orthonormal::new(order, 2 * half + 2);
            let parts = [0, 1].map(|parity| {
                let (diagonal, off) = differential_operator(&basis, order, c, half, parity);
                lowest(&diagonal, &off, (count + 1 - parity) / 2)
            });
            let [even, odd] = parts;
            let (even, odd) = (even?, odd?);
            let resolved = |part: &Lowest| {
                let ends = part.vectors.chunks_exact(half).map(|vector| vector[half - 1].abs());
                ends.fold(0.0, f64::max) < NEGLIGIBLE
            };
            if (resolved(&even) && resolved(&odd)) || 2 * half > LARGEST {
                return Ok(Self::assemble(order, c, basis, half, &[even, odd]));
            }
            half += half / 2;
        }
    }

    fn assemble(order: f64, c: f64, basis: Orthonormal, half: usize, parts: &[Lowest; 2]) -> Self {
        let count = parts[0].values.len() + parts[1].values.len();
        let mut found = Self {
            basis,
            half,
            vectors: Vec::with_capacity(count * half),
            characteristic_values: Vec::with_capacity(count),
            eigenvalues: Vec::with_capacity(count),
        };
        let at_end = found.polynomials(1.0);
        let integrals = end_integrals(order, c, count, &at_end);
        for n in 0..count {
            let part = &parts[n % 2];
            let vector = &part.vectors[n / 2 * half..(n / 2 + 1) * half];
            let value = dot(vector, &at_end[n % 2]);
            let sign = if value < 0.0 { -1.0 } else { 1.0 };
            found.vectors.extend(vector.iter().map(|v| sign * v));
            found.characteristic_values.push(part.values[n / 2]);
            found.eigenvalues.push(dot(vector, &integrals[n % 2]) / value);
        }
        found
    }

    pub(super) fn count(&self) -> usize {
        self.eigenvalues.len()
    }

    /// By how much the number of polynomials exceeds that of functions.
    pub(super) fn excess(&self) -> usize {
        2 * self.half - self.count()
    }

    fn vector(&self, n: usize) -> &[f64] {
        &self.vectors[n * self.half..(n + 1) * self.half]
    }

    /// The even and the odd polynomials at a point.
    fn polynomials(&self, t: f64) -> [Vec<f64>; 2] {
        let mut values = vec![0.0; 2 * self.half];
        self.basis.polynomials(t, &mut values);
        [0, 1].map(|parity| values.iter().skip(parity).step_by(2).copied().collect())
    }

    /// `phi_0(t), phi_1(t), ...`; NaN beyond what there is.
    pub(super) fn values(&self, t: f64, values: &mut [f64]) {
        let polynomials = self.polynomials(t);
        for (n, value) in values.iter_mut().enumerate() {
            let known = n < self.count();
            *value = if known { dot(self.vector(n), &polynomials[n % 2]) } else { f64::NAN };
        }
    }

    /// The coefficients in the polynomials of either parity of `sum c_n S_n`; NaN beyond the functions there are.
    pub(super) fn series(&self, coefficients: &[f64]) -> [Vec<f64>; 2] {
        let fill = if coefficients.len() > self.count() { f64::NAN } else { 0.0 };
        let mut series = [vec![fill; self.half], vec![fill; self.half]];
        for (n, c) in coefficients.iter().enumerate().take(self.count()) {
            series[n % 2].iter_mut().zip(self.vector(n)).for_each(|(sum, v)| *sum += c * v);
        }
        series
    }

    /// A series of both parities at `t`.
    pub(super) fn evaluate(&self, series: &[Vec<f64>; 2], t: f64) -> f64 {
        let polynomials = self.polynomials(t);
        dot(&series[0], &polynomials[0]) + dot(&series[1], &polynomials[1])
    }

    /// `sum_n coefficients[n] phi_n(t)`; NaN for more coefficients than functions.
    pub(super) fn sum(&self, coefficients: &[f64], t: f64) -> f64 {
        if coefficients.len() > self.count() {
            return f64::NAN;
        }
        let polynomials = self.polynomials(t);
        let term = |(n, c): (usize, &f64)| c * dot(self.vector(n), &polynomials[n % 2]);
        coefficients.iter().enumerate().map(term).sum()
    }

    /// `int phi_n (1 - t^2)^(mu - 1/2) dt`: the coefficient of the constant.
    pub(super) fn mass(&self, n: usize) -> f64 {
        match n {
            n if n >= self.count() => f64::NAN,
            n if n.is_multiple_of(2) => self.vector(n)[0] / self.basis.first(),
            _ => 0.0,
        }
    }

    /// `int_{-1}^{1} phi_k phi_m dt` for `k, m < count`, row by row: exact by the rule of Legendre, of which the nodes right of the middle suffice.
    pub(super) fn gram(&self, count: usize) -> Result<Vec<f64>, Error> {
        // An even number, so that none lies in the middle, that is exact up to the degree 4 half - 2.
        let nodes = 2 * self.half + 2;
        let rule = bilby::GaussLegendre::new(nodes).map_err(|_| Error::InvalidParameter {
            name: "number of nodes",
            value: nodes as f64,
            requirement: "positive",
        })?;
        let right = rule.nodes().iter().zip(rule.weights()).filter(|(t, _)| **t > 0.0);
        let length = nodes / 2;
        // phi_n at the nodes times the root of the weight, by functions.
        let mut samples = vec![0.0; count * length];
        let mut values = vec![0.0; count];
        for (j, (t, weight)) in right.enumerate().take(length) {
            self.values(*t, &mut values);
            let root = (2.0 * weight).sqrt();
            (values.iter().enumerate()).for_each(|(n, v)| samples[n * length + j] = root * v);
        }
        let mut entries = vec![0.0; count * count];
        let sample = |n: usize| &samples[n * length..(n + 1) * length];
        for k in 0..count {
            for m in (k..count).step_by(2) {
                let entry = dot(sample(k), sample(m));
                entries[k * count + m] = entry;
                entries[m * count + k] = entry;
            }
        }
        Ok(entries)
    }
}

/// Diagonal and off-diagonal of `-D`, `D y = (1 - t^2) y'' - (2 mu + 1) t y' + c^2 t^2 y`, on the polynomials of one parity.
fn differential_operator(
    basis: &Orthonormal,
    order: f64,
    c: f64,
    half: usize,
    parity: usize,
) -> (Vec<f64>, Vec<f64>) {
    let b = |j: usize| c * basis.coefficient(j);
    let index = |k: usize| 2 * k + parity;
    let diagonal = (0..half).map(index).map(|j| {
        let degree = j as f64;
        degree * (degree + 2.0 * order) - b(j).powi(2) - b(j + 1).powi(2)
    });
    let off = (0..half.saturating_sub(1)).map(index).map(|j| -b(j + 1) * b(j + 2));
    (diagonal.collect(), off.collect())
}

/// `int_0^2 u^-mu K_mu(c u) [u (2 - u)]^(mu - 1/2) p_j(1 - u) du` for the even and the odd `j`: the relation (1.2) of `p_j` at the end `t = 1`, where no
/// eigenfunction vanishes.
///
/// Double-exponential rule in `u = 2/(1 + exp(-pi sinh v))`, dense enough for the highest function, `count` of them. Where `u` or `2 - u` would underflow, its power is
/// continued by its logarithm: as `|mu| -> 1/2` most of the integral is there.
fn end_integrals(order: f64, c: f64, count: usize, at_end: &[Vec<f64>; 2]) -> [Vec<f64>; 2] {
    let half = at_end[0].len();
    let Ok(profile) = MacdonaldProfile::new(order, c, 2.0 * c) else {
        return [vec![f64::NAN; half], vec![f64::NAN; half]];
    };
    let density = |u: f64, v: f64| profile.pair(u).value * (u * v).powf(order - 0.5);
    let margin = 0.5 - order.abs();
    let range = (TAIL / (PI * margin)).asinh();
    let half_count = (range * (24.0 + count as f64 / 1.5)).ceil() as i32;
    let step = range / f64::from(half_count);
    let distances = |t: f64| {
        let argument = PI * t.sinh();
        [2.0 / (1.0 + (-argument).exp()), 2.0 / (1.0 + argument.exp())]
    };
    // density du = strength d^margin dv pi cosh v at a distance d from either end.
    let [near, far] = distances(-RANGE);
    let strengths = [[near, far], [far, near]]
        .map(|[u, v]| density(u, v) * near.powf(1.0 - margin) * 2f64.powf(margin));
    let mut sums = vec![0.0; 2 * half];
    let mut values = vec![0.0; 2 * half];
    for j in -half_count..=half_count {
        let t = step * f64::from(j);
        let at_right = t < 0.0;
        let (distance, weight) = if t.abs() <= RANGE {
            let [u, v] = distances(t);
            (u.min(v), density(u, v) * FRAC_PI_2 * t.cosh() * u * v)
        } else if at_right || order < 0.0 {
            let strength = strengths[usize::from(!at_right)];
            (0.0, strength * (-PI * margin * t.abs().sinh()).exp() * PI * t.cosh())
        } else {
            continue;
        };
        gegenbauer::polynomials_near_the_end(2.0 * order, distance, &mut values);
        for (j, (sum, value)) in sums.iter_mut().zip(&values).enumerate() {
            let sign = if at_right || j % 2 == 0 { 1.0 } else { -1.0 };
            *sum += step * weight * sign * value;
        }
    }
    [0, 1].map(|parity| {
        let parity_sums = sums.iter().skip(parity).step_by(2);
        parity_sums.zip(&at_end[parity]).map(|(sum, p)| sum * p).collect()
    })
}
