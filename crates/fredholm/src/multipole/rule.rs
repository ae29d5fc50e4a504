//! Gauss nodes of a panel and the moments of the logarithm over it.

use super::kernel::PanelKernel;
use super::on_panel::OnPanel;
use super::rings::Rings;
use crate::Error;
use crate::quadrature::{double_exponential, gauss_legendre};

/// Beyond this many half-lengths from the middle Legendre's functions are computed downwards.
const FORWARD: f64 = 1.05;
/// `ln(1/eps)` of the moments, and of the plain rule far away with many nodes and with the fewest.
const DIGITS: f64 = 37.0;
const FAR_DIGITS: f64 = 34.5;
const FEWEST_DIGITS: f64 = 8.0;

/// Nodes of the rule on either side of a place, or of the middle of the panel that begins at the axis, up and down from its middle: twice as many change nothing but rounding (test).
const NODES: usize = 60;

/// Gauss nodes on `(-1, 1)` with what interpolation between them needs.
#[derive(Debug, Clone)]
pub(super) struct PanelRule {
    pub(super) nodes: Vec<f64>,
    pub(super) weights: Vec<f64>,
    /// Legendre coefficients from values, row by row.
    analysis: Vec<f64>,
    barycentric: Vec<f64>,
    /// Derivatives at the nodes from values, row by row.
    slopes: Vec<f64>,
    /// Half-lengths from the middle beyond which the nodes alone integrate the logarithm.
    pub(super) far: f64,
}

impl PanelRule {
    pub(super) fn new(order: usize) -> Result<Self, Error> {
        let rule = gauss_legendre(order)?;
        let (nodes, weights) = (rule.nodes, rule.weights);
        let mut analysis = vec![0.0; order * order];
        for (j, (y, w)) in nodes.iter().zip(&weights).enumerate() {
            let (mut before, mut here) = (0.0, 1.0);
            for k in 0..order {
                analysis[k * order + j] = (k as f64 + 0.5) * w * here;
                let next = ((2 * k + 1) as f64 * y * here - k as f64 * before) / (k + 1) as f64;
                (before, here) = (here, next);
            }
        }
        let barycentric: Vec<f64> = (0..order)
            .map(|j| {
                let others = (0..order).filter(|i| *i != j);
                1.0 / others.map(|i| nodes[j] - nodes[i]).product::<f64>()
            })
            .collect();
        // Of few nodes less is expected.
        let digits = ((order * order) as f64).clamp(FEWEST_DIGITS, FAR_DIGITS);
        let rho = (digits / (2.0 * order as f64)).exp();
        let far = 0.5 * (rho + 1.0 / rho);
        let slopes = slopes(&nodes, &barycentric);
        Ok(Self { nodes, weights, analysis, barycentric, slopes, far })
    }

    pub(super) fn order(&self) -> usize {
        self.nodes.len()
    }

    /// The Legendre coefficients of the polynomial through values at the nodes.
    pub(super) fn coefficients(&self, values: &[f64], coefficients: &mut [f64]) {
        for (c, row) in coefficients.iter_mut().zip(self.analysis.chunks_exact(self.order())) {
            *c = row.iter().zip(values).map(|(a, v)| a * v).sum();
        }
    }

    /// `int K(y_i + 2 m - y) phi(y) dy` from values, row by row: for the nodes of a panel of the same length, `m` of them away.
    pub(super) fn beside(&self, kernel: &PanelKernel, m: i32) -> Vec<f64> {
        let mut rows = vec![0.0; self.order() * self.order()];
        for (row, y) in rows.chunks_exact_mut(self.order()).zip(&self.nodes) {
            self.weights_at(kernel, OnPanel::at(y + 2.0 * f64::from(m)), row);
        }
        rows
    }

    /// The weights of `int_{-1}^{1} K(z - y) phi(y) dy`, but for the remainder of the kernel, at a place for values of a polynomial at the nodes.
    pub(super) fn weights_at(&self, kernel: &PanelKernel, place: OnPanel, weights: &mut [f64]) {
        let order = self.order();
        let mut moments = [0.0; MOST + 1];
        let moments = &mut moments[..order];
        kernel.moments(place, moments);
        self.weights_of_moments(moments, weights);
    }

    /// The weights that give values the sum of their Legendre coefficients times these.
    pub(super) fn weights_of_moments(&self, moments: &[f64], weights: &mut [f64]) {
        weights.fill(0.0);
        for (moment, row) in moments.iter().zip(self.analysis.chunks_exact(self.order())) {
            weights.iter_mut().zip(row).for_each(|(w, a)| *w += moment * a);
        }
    }

    /// The weights of `int_0^1 G(x, s) phi(s) s ds` for values of a polynomial at the nodes, from a place in `[0, 1]` or beside it, given with its distance beyond 1.
    pub(super) fn weights_from_axis(
        &self,
        rings: &Rings,
        [x, beyond]: [f64; 2],
        weights: &mut [f64],
    ) {
        let order = self.order();
        let mut moments = [0.0; MOST];
        let cut = x.min(1.0);
        let power = 1.0 / (1.0 - rings.exponent());
        // From the place, or from the end before it, to both ends.
        for length in [-cut, (-beyond).max(0.0)] {
            if length == 0.0 {
                continue;
            }
            for node in double_exponential(NODES) {
                // u = d^(1 - mu) of the distance d takes the singularity of a power away.
                let u = 0.5 * node.from_left;
                let share = u.powf(power);
                let s = cut + length * share;
                let difference = beyond.max(0.0) - length * share;
                if difference == 0.0 || s <= 0.0 {
                    continue;
                }
                let value = rings.value(x, s, difference);
                // From the axis to where that overflows there is less than rounding.
                if value >= f64::MAX {
                    continue;
                }
                let weight = 0.5 * node.weight * power * share / u;
                let mass = length.abs() * weight * s * value;
                let y = 2.0 * s - 1.0;
                let (mut before, mut here) = (0.0, 1.0);
                for (k, moment) in moments[..order].iter_mut().enumerate() {
                    *moment += mass * here;
                    let k = k as f64;
                    (before, here) = (here, ((2.0 * k + 1.0) * y * here - k * before) / (k + 1.0));
                }
            }
        }
        self.weights_of_moments(&moments[..order], weights);
    }

    /// The derivatives at the nodes of the polynomial through values there.
    pub(super) fn derivatives(&self, values: &[f64], derivatives: &mut [f64]) {
        for (slope, row) in derivatives.iter_mut().zip(self.slopes.chunks_exact(self.order())) {
            *slope = row.iter().zip(values).map(|(d, v)| d * v).sum();
        }
    }

    /// The polynomial through values at the nodes.
    #[inline(always)]
    pub(super) fn interpolate(&self, values: &[f64], y: f64) -> f64 {
        let mut shares = [0.0; MOST];
        let of_nodes = self.nodes.iter().zip(&self.barycentric);
        for (share, (node, weight)) in shares.iter_mut().zip(of_nodes) {
            *share = weight / (y - node);
        }
        let (mut above, mut below) = (0.0, 0.0);
        for (share, value) in shares.iter().zip(values).take(self.order()) {
            above += share * value;
            below += share;
        }
        // At a node its share is infinite.
        if below.is_finite() {
            return above / below;
        }
        let node = self.nodes.iter().position(|node| *node == y);
        node.and_then(|node| values.get(node)).copied().unwrap_or(f64::NAN)
    }
}

/// `phi_j'(y_i)` of the cardinal polynomials, row by row; each row sums to zero.
fn slopes(nodes: &[f64], barycentric: &[f64]) -> Vec<f64> {
    let order = nodes.len();
    let mut slopes = vec![0.0; order * order];
    for (i, row) in slopes.chunks_exact_mut(order).enumerate() {
        for j in (0..order).filter(|j| *j != i) {
            row[j] = barycentric[j] / barycentric[i] / (nodes[i] - nodes[j]);
        }
        row[i] = -row.iter().sum::<f64>();
    }
    slopes
}

/// Most nodes of a panel.
pub(super) const MOST: usize = 32;

/// `I_k(z) = int_{-1}^{1} ln(1/|z - y|) P_k(y) dy = 2 (Q_(k-1)(z) - Q_(k+1)(z))/(2k+1)`, `k >= 1`, with Legendre's functions of the second kind (between -1 and 1 those
/// on the cut), for `k` below the length.
pub(super) fn logarithm_moments(place: OnPanel, moments: &mut [f64]) {
    let count = moments.len();
    let (z, [outer, inner]) = (place.z, place.to_ends());
    let x = z.abs();
    let term = |d: f64| if d == 0.0 { 0.0 } else { d * d.abs().ln() };
    moments[0] = 2.0 - term(outer) - term(inner);
    if inner == 0.0 {
        // Q_(k-1) - Q_(k+1) -> (2k+1)/(k(k+1))
        for (k, moment) in moments.iter_mut().enumerate().skip(1) {
            *moment = 2.0 / (k * (k + 1)) as f64;
        }
    } else {
        let mut functions = [0.0; MOST + 2];
        let functions = &mut functions[..=count];
        if x < FORWARD {
            upwards(x, outer / inner, functions);
        } else {
            downwards(x, functions);
        }
        for k in 1..count {
            moments[k] = 2.0 * (functions[k - 1] - functions[k + 1]) / (2 * k + 1) as f64;
        }
    }
    if z < 0.0 {
        moments.iter_mut().skip(1).step_by(2).for_each(|moment| *moment = -*moment);
    }
}

/// Most steps downwards: from `x = 1.05` on, [`DIGITS`] are left out by 59 steps beyond the last function.
const LONGEST: usize = MOST + 64;
/// `Q_(k+1) = (2k+1)/(k+1) x Q_k - k/(k+1) Q_(k-1)`, and the same solved for `Q_(k-1)`: divisions would take most of the time.
const UPWARDS: [[f64; 2]; MOST + 2] = coefficients(1);
const DOWNWARDS: [[f64; 2]; LONGEST + 1] = coefficients(0);

/// `(2k+1)/(k+shift)` and `(k+1-shift)/(k+shift)`.
const fn coefficients<const COUNT: usize>(shift: usize) -> [[f64; 2]; COUNT] {
    let mut found = [[0.0; 2]; COUNT];
    let mut k = 1;
    while k < COUNT {
        let divisor = (k + shift) as f64;
        found[k] = [(2 * k + 1) as f64 / divisor, (k + 1 - shift) as f64 / divisor];
        k += 1;
    }
    found
}

/// `Q_k(x)`, by the recurrence in its own direction, stable up to about 1, given `(1 + x)/(1 - x)`.
fn upwards(x: f64, ratio: f64, functions: &mut [f64]) {
    functions[0] = 0.5 * ratio.abs().ln();
    functions[1] = x * functions[0] - 1.0;
    for k in 1..functions.len() - 1 {
        let [here, before] = UPWARDS[k];
        functions[k + 1] = here * x * functions[k] - before * functions[k - 1];
    }
}

/// `Q_k(x)`, `x > 1`, by Miller's algorithm.
fn downwards(x: f64, functions: &mut [f64]) {
    let last = functions.len() - 1;
    let beyond = (0.5 * DIGITS / x.acosh()).ceil() as usize;
    let (mut after, mut here) = (0.0, f64::MIN_POSITIVE.sqrt());
    for k in (1..=(last + beyond).min(LONGEST)).rev() {
        if k <= last {
            functions[k] = here;
        }
        let [own, other] = DOWNWARDS[k];
        (after, here) = (here, own * x * here - other * after);
    }
    functions[0] = here;
    let scale = 0.5 * (2.0 / (x - 1.0)).ln_1p() / here;
    functions.iter_mut().for_each(|q| *q *= scale);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::multipole::rings::tests::{rings, uniform};

    #[test]
    fn the_panel_at_the_axis_has_integrals_in_closed_form() {
        for order in [4, 10, 13] {
            let rule = PanelRule::new(order).unwrap();
            let mut weights = vec![0.0; order];
            for x in [0.0, 1e-9, 0.02, 0.3, 0.77, 0.999, 1.0, 1.001, 1.3, 1.7] {
                rule.weights_from_axis(&rings(0, 0.0), [x, x - 1.0], &mut weights);
                let found: f64 = weights.iter().sum();
                let exact = uniform(x);
                assert!((found - exact).abs() < 4e-15, "{order} {x}: {found} {exact}");
            }
        }
    }

    #[test]
    fn moments_agree_with_quadrature() {
        for z in [0.0, 0.3, -0.7, 0.999, 1.0, -1.0, 1.0001, 1.04, 1.06, -1.3, 2.0, -9.0] {
            let mut found = [0.0; 13];
            logarithm_moments(OnPanel::at(z), &mut found);
            for (k, found) in found.iter().enumerate() {
                let legendre = |y: f64| {
                    let (mut before, mut here) = (0.0, 1.0);
                    for k in 0..k {
                        let k = k as f64;
                        (before, here) =
                            (here, ((2.0 * k + 1.0) * y * here - k * before) / (k + 1.0));
                    }
                    here
                };
                let cut = z.clamp(-1.0, 1.0);
                let part = |from: f64, to: f64| -> f64 {
                    // Beyond the ends the distance grows from the nearer one.
                    let half = 0.5 * (to - from);
                    if half == 0.0 {
                        return 0.0;
                    }
                    double_exponential(120)
                        .map(|node| {
                            let y = from + half * node.from_left;
                            let distance = (z - from).abs() + half.abs() * node.from_left;
                            -half.abs() * node.weight * distance.ln() * legendre(y)
                        })
                        .sum()
                };
                let exact = part(cut, -1.0) + part(cut, 1.0);
                assert!((found - exact).abs() < 2e-13, "{z} {k}: {found} {exact}");
            }
        }
    }
}
