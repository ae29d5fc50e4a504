//! Gauss-Legendre quadrature and the polynomials through its nodes.

use std::f64::consts::PI;

/// The rule with `n` nodes on `[-1, 1]`.
#[derive(Debug, Clone)]
pub(crate) struct Rule {
    pub(crate) nodes: Vec<f64>,
    pub(crate) weights: Vec<f64>,
    /// Barycentric weights of the nodes.
    barycentric: Vec<f64>,
    /// `(k + 1/2) P_k(t_i)`, one degree after the other: what the coefficient of degree `k` has of the value at node `i`, but for its weight.
    degrees: Vec<f64>,
}

impl Rule {
    pub(crate) fn new(n: usize) -> Self {
        let mut rule =
            Self { nodes: vec![], weights: vec![], barycentric: vec![], degrees: vec![] };
        let halves: Vec<[f64; 2]> = (0..n.div_ceil(2)).map(|i| node(n, i)).collect();
        for i in 0..n {
            let [y, weight] = halves[i.min(n - 1 - i)];
            let x = if 2 * i + 1 == n { 0.0 } else { 1.0 - y };
            rule.nodes.push(if 2 * i < n { -x } else { x });
            rule.weights.push(weight);
            let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
            rule.barycentric.push(sign * (y * (2.0 - y) * weight).sqrt());
        }
        // Roundings of the slopes are of one sign.
        let sum: f64 = rule.weights.iter().sum();
        rule.weights.iter_mut().for_each(|weight| *weight *= 2.0 / sum);
        let (mut before, mut p) = (vec![0.0; n], vec![1.0; n]);
        for k in 0..n {
            rule.degrees.extend(p.iter().map(|p| (k as f64 + 0.5) * p));
            let [rise, fall] = recurrence(k);
            for ((x, before), p) in rule.nodes.iter().zip(&mut before).zip(&mut p) {
                (*before, *p) = (*p, rise * x * *p - fall * *before);
            }
        }
        rule
    }

    /// The polynomials that are 1 at one node and 0 at the others, at `t`.
    pub(crate) fn cardinals(&self, t: f64, values: &mut [f64]) {
        let mut sum = 0.0;
        for (i, value) in values.iter_mut().enumerate() {
            let distance = t - self.nodes[i];
            if distance == 0.0 {
                values.fill(0.0);
                values[i] = 1.0;
                return;
            }
            *value = self.barycentric[i] / distance;
            sum += *value;
        }
        values.iter_mut().for_each(|value| *value /= sum);
    }

    /// The polynomial with these values at the nodes, at `t`; side by side, as kernels are asked for more often than all else.
    pub(crate) fn interpolate(&self, values: &[f64], t: f64) -> f64 {
        const LANES: usize = 4;
        let (mut sums, mut totals) = ([0.0; LANES], [0.0; LANES]);
        let parts: [&[[f64; LANES]]; 3] =
            [&self.nodes[..], &self.barycentric[..], values].map(|list| list.as_chunks().0);
        for ((nodes, weights), values) in parts[0].iter().zip(parts[1]).zip(parts[2]) {
            for lane in 0..LANES {
                let share = weights[lane] / (t - nodes[lane]);
                sums[lane] += share;
                totals[lane] += share * values[lane];
            }
        }
        let (mut sum, mut total) = (sums.iter().sum::<f64>(), totals.iter().sum::<f64>());
        for (i, value) in values.iter().enumerate().skip(LANES * parts[2].len()) {
            let share = self.barycentric[i] / (t - self.nodes[i]);
            (sum, total) = (sum + share, total + share * value);
        }
        if sum.is_finite() {
            return total / sum;
        }
        // At a node, or so near to it that the share overflows.
        let nearest = |one: &usize, other: &usize| {
            (t - self.nodes[*one]).abs().total_cmp(&(t - self.nodes[*other]).abs())
        };
        (0..values.len()).min_by(nearest).map_or(0.0, |i| values[i])
    }

    /// Legendre coefficients of the polynomial with these values at the nodes.
    pub(crate) fn expand(&self, values: &[f64]) -> Vec<f64> {
        let weighted: Vec<f64> = values.iter().zip(&self.weights).map(|(v, w)| v * w).collect();
        let of_degree =
            |degree: &[f64]| degree.iter().zip(&weighted).map(|(p, value)| p * value).sum();
        self.degrees.chunks(values.len()).map(of_degree).collect()
    }

    /// Integrals with the cardinals from those with the Legendre polynomials.
    pub(crate) fn collect(&self, integrals: &[f64], found: &mut [f64]) {
        found.fill(0.0);
        for (integral, degree) in integrals.iter().zip(self.degrees.chunks(found.len())) {
            found.iter_mut().zip(degree).for_each(|(entry, p)| *entry += integral * p);
        }
        found.iter_mut().zip(&self.weights).for_each(|(entry, weight)| *entry *= weight);
    }
}

/// Factors of `x P_k` and `P_(k-1)` in `P_(k+1)`.
pub(crate) fn recurrence(k: usize) -> [f64; 2] {
    let k = k as f64;
    [(2.0 * k + 1.0) / (k + 1.0), k / (k + 1.0)]
}

/// The distance `y = 1 - x` of the `i`-th largest root of `P_n` from 1, by Newton's method, and its weight: in `x` itself the digits of `1 - x^2` would be lost.
fn node(n: usize, i: usize) -> [f64; 2] {
    let mut y = 2.0 * (0.5 * PI * (i as f64 + 0.75) / (n as f64 + 0.5)).sin().powi(2);
    let mut slope = 1.0;
    for _ in 0..8 {
        // P_(k+1) - P_k from P_k - P_(k-1)
        let (mut p, mut rise) = (1.0, 0.0);
        for k in 0..n {
            let k = k as f64;
            rise = (k * rise - (2.0 * k + 1.0) * y * p) / (k + 1.0);
            p += rise;
        }
        slope = n as f64 * (y * p - rise) / (y * (2.0 - y));
        y += p / slope;
    }
    [y, 2.0 / (y * (2.0 - y) * slope * slope)]
}
