//! The eigenvalues, from the matrix of the integral operator in Legendre functions.

use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

use super::waves::inner_quotients;
use crate::Error;
use crate::basis::legendre::strengths;
use crate::basis::spheroidal::Spheroidal;
use crate::linear::vectorised;
use crate::quadrature::gauss_legendre;

/// Nodes of Gauss's rule on a panel, and the far end of one over that of the panel before. The integrand has no singularities, but away from the axis it goes as `1/sqrt(nu^2 + q^2)`: as if there were
/// some at 0, which for these panels leave `(3 + sqrt 8)^-20`.
const NODES: usize = 20;
const GROWTH: f64 = 4.0;
/// The first panel reaches to this `q`, where the integrand goes as `exp(-2q)`.
const FIRST: f64 = 2.0;
/// Functions whose sums run along together, in registers.
const LANES: usize = 24;
/// So many `j` at a time, for which the tables of all nodes stay near the processor.
const STRIP: usize = 256;
/// Coefficients of functions of unit length below this do not count.
const NEGLIGIBLE: f64 = 1e-20;

/// `lambda_n = d^T A d` with the coefficients `d` of `S_n` in the basis `e_j` and
///
/// `A_ij = 4 C_i C_j (-1)^(i-j) int_0^(pi/2) I_(nu_max)(q) K_(nu_min)(q) d theta`, `q = kappa sin theta`, `nu_j = m + 2j + 1/2`:
///
/// the transform of `1/sqrt(t^2 + kappa^2)` with Bessel functions, turned to the imaginary axis. The error is of second order in that of `d`. The matrix itself is not needed: the sums over `i < j` run along with
/// the quotients `I_(nu+1)/I_nu`, which neither overflow nor underflow. It takes `nodes count order` steps, of some functions and nodes at once.
pub(super) fn eigenvalues(
    harmonic: u32,
    kappa: f64,
    functions: &Spheroidal,
) -> Result<Vec<f64>, Error> {
    let (count, order) = (functions.count(), functions.order());
    let nodes = nodes(kappa)?;
    let tables: Vec<Vec<Step>> = nodes.iter().map(|[q, _]| steps(harmonic, order, *q)).collect();
    let factors = factors(harmonic, order);
    let ends = ends(functions);
    let mut running = vec![Running::default(); count.div_ceil(LANES) * tables.len()];
    let mut rows = Vec::with_capacity(STRIP);
    for start in (0..order).step_by(STRIP) {
        let strip = start..order.min(start + STRIP);
        for (block, running) in running.chunks_exact_mut(tables.len()).enumerate() {
            let members = LANES * block..count.min(LANES * (block + 1));
            if ends[members.end - 1] <= start {
                continue;
            }
            fill(&mut rows, functions, members, &factors[strip.clone()], start);
            for (running, table) in running.iter_mut().zip(&tables) {
                let steps = &table[strip.clone()];
                vectorised(
                    #[inline(always)]
                    || running.add(steps, &rows),
                );
            }
        }
    }
    let sum = |n: usize| {
        let running = running.chunks_exact(nodes.len()).nth(n / LANES).unwrap_or_default();
        let terms = running.iter().zip(&nodes).map(|(at, [_, weight])| weight * at.sums[n % LANES]);
        terms.sum()
    };
    Ok((0..count).map(sum).collect())
}

/// `q` and the weights, with the factor 4, of the rule for the integral over `theta`.
fn nodes(kappa: f64) -> Result<Vec<[f64; 2]>, Error> {
    let rule = gauss_legendre(NODES)?;
    let mut nodes = Vec::new();
    let (mut left, mut right) = (0.0, FIRST / kappa.max(FIRST));
    while left < FRAC_PI_2 {
        // Not a short last one.
        right = if 2.0 * right < FRAC_PI_2 { right } else { FRAC_PI_2 };
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let node =
            |(t, weight): (&f64, &f64)| [kappa * (middle + half * t).sin(), 4.0 * half * weight];
        nodes.extend(rule.nodes.iter().zip(&rule.weights).map(node));
        (left, right) = (right, GROWTH * right);
    }
    Ok(nodes)
}

/// `(-1)^j C_j`.
fn factors(harmonic: u32, order: usize) -> Vec<f64> {
    let strengths = strengths(harmonic, order).into_iter().enumerate();
    strengths.map(|(j, c)| if j.is_multiple_of(2) { c } else { -c }).collect()
}

/// Where the coefficients of each function have become negligible, and those of all before it.
fn ends(functions: &Spheroidal) -> Vec<usize> {
    let mut most = 0;
    let end = |n: usize| {
        let coefficients = functions.coefficients(n);
        let last = coefficients.iter().rposition(|entry| entry.abs() > NEGLIGIBLE);
        most = most.max(last.map_or(0, |last| last + 1));
        most
    };
    (0..functions.count()).map(end).collect()
}

/// `(-1)^j C_j d_j^{(n)}` for the `j` from `start` on, and some functions; zeros where there are fewer.
fn fill(
    rows: &mut Vec<[f64; LANES]>,
    functions: &Spheroidal,
    members: Range<usize>,
    factors: &[f64],
    start: usize,
) {
    rows.clear();
    rows.resize(factors.len(), [0.0; LANES]);
    for (lane, n) in members.enumerate() {
        let coefficients = &functions.coefficients(n)[start..];
        for ((row, entry), factor) in rows.iter_mut().zip(coefficients).zip(factors) {
            row[lane] = entry * factor;
        }
    }
}

/// `I_nu(q) K_nu(q)` at `j`, and what takes `I_nu` from there to the next `j` and `K_nu` along.
struct Step {
    product: f64,
    ratio: f64,
}

/// The steps along `j` at a node.
fn steps(harmonic: u32, order: usize, q: f64) -> Vec<Step> {
    let square = q * q;
    let l = |j: usize| harmonic as usize + 2 * j;
    let mut quotients = vec![0.0; l(order) + 1];
    inner_quotients(square, &mut quotients);
    let mut diagonal = Diagonal::new(q, harmonic, &quotients);
    let step = |j: usize| Step {
        product: diagonal.at(l(j)),
        ratio: square * quotients[l(j)] * quotients[l(j) + 1],
    };
    (0..order).map(step).collect()
}

/// The sums of some functions at a node, along `j`.
#[derive(Debug, Clone, Copy, Default)]
struct Running {
    sums: [f64; LANES],
    /// The sums over `i < j`.
    carried: [f64; LANES],
}

impl Running {
    #[inline(always)]
    fn add(&mut self, steps: &[Step], rows: &[[f64; LANES]]) {
        let Self { mut sums, mut carried } = *self;
        for (Step { product, ratio }, row) in steps.iter().zip(rows) {
            for lane in 0..LANES {
                let before = carried[lane];
                let after = before + product * row[lane];
                sums[lane] += row[lane] * (after + before);
                carried[lane] = ratio * after;
            }
        }
        *self = Self { sums, carried };
    }
}

/// The products `I_nu(q) K_nu(q) = 1/(q k + q i)`, `nu = l + 1/2`, with the quotients `k = K_(nu+1)/K_nu` upwards and `i = I_(nu+1)/I_nu`; `1/(2 nu)` at `q = 0`.
struct Diagonal<'q> {
    square: f64,
    inner: &'q [f64],
    /// `q K_(nu+1)/K_nu` at `l`.
    outer: f64,
    l: usize,
}

impl<'q> Diagonal<'q> {
    fn new(argument: f64, harmonic: u32, inner: &'q [f64]) -> Self {
        let mut diagonal = Self { square: argument * argument, inner, outer: argument + 1.0, l: 0 };
        diagonal.rise(harmonic as usize);
        diagonal
    }

    fn rise(&mut self, l: usize) {
        while self.l < l {
            self.l += 1;
            self.outer = (2 * self.l + 1) as f64 + self.square / self.outer;
        }
    }

    fn at(&mut self, l: usize) -> f64 {
        self.rise(l);
        1.0 / (self.outer + self.square * self.inner[l])
    }
}
