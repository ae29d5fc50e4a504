//! Integrals of a kernel over one panel.

use crate::Error;
use crate::kernel::{Kernel, Singularity};
use crate::quadrature::gauss_legendre;

/// Nodes of a panel.
pub(super) const NODES: usize = 20;
/// A panel is far from a point at this share of its length: its rule then integrates the kernel as it is.
pub(super) const FAR: f64 = 0.4;
/// Most halvings towards a point beside a panel.
const HALVINGS: usize = 60;

/// The nodes of Gauss and Legendre with everything that is made of them.
pub(super) struct Rule {
    /// On `(-1, 1)`.
    pub(super) nodes: Vec<f64>,
    pub(super) weights: Vec<f64>,
    barycentric: Vec<f64>,
    singularity: Singularity,
    /// Weights of `int_0^1 g(u) sigma(u) du` at `u = (1 + node)/2`, exact for polynomials up to degree 19.
    singular: Vec<f64>,
}

impl Rule {
    pub(super) fn new(singularity: Singularity) -> Result<Self, Error> {
        let rule = gauss_legendre(NODES)?;
        // (H. Wang and S. Xiang, Math. Comp. 81 (2012) 861.)
        let barycentric = (rule.nodes.iter().zip(&rule.weights).enumerate())
            .map(|(k, (t, w))| {
                let size = ((1.0 - t * t) * w).sqrt();
                if k % 2 == 0 { size } else { -size }
            })
            .collect();
        let moments = moments(singularity);
        let singular = (rule.nodes.iter().zip(&rule.weights))
            .map(|(t, w)| {
                let sum = (moments.iter().zip(legendre(*t)).enumerate())
                    .map(|(k, (moment, p))| (2 * k + 1) as f64 * p * moment);
                0.5 * w * sum.sum::<f64>()
            })
            .collect();
        Ok(Self { nodes: rule.nodes, weights: rule.weights, barycentric, singularity, singular })
    }

    /// Shares of the values at the nodes in the value at `t`.
    pub(super) fn shares(&self, t: f64) -> [f64; NODES] {
        let mut shares = [0.0; NODES];
        let mut total = 0.0;
        for ((share, node), weight) in shares.iter_mut().zip(&self.nodes).zip(&self.barycentric) {
            if t == *node {
                shares = [0.0; NODES];
                let at = self.nodes.iter().position(|node| t == *node).unwrap_or(0);
                shares[at] = 1.0;
                return shares;
            }
            *share = weight / (t - node);
            total += *share;
        }
        shares.iter_mut().for_each(|share| *share /= total);
        shares
    }

    pub(super) fn interpolate(&self, values: &[f64], t: f64) -> f64 {
        self.shares(t).iter().zip(values).map(|(share, value)| share * value).sum()
    }

    /// `int K(x, s) g(s) ds` over a panel at or beside `x`.
    pub(super) fn near(
        &self,
        kernel: &dyn Kernel,
        x: f64,
        (left, right): (f64, f64),
        g: &dyn Fn(f64) -> f64,
    ) -> f64 {
        if left < x && x < right {
            return self.from(kernel, x, left, g) + self.from(kernel, x, right, g);
        }
        let (near, far) = if x <= left { (left, right) } else { (right, left) };
        if near == x {
            return self.from(kernel, x, far, g);
        }
        // Halved towards x until each part is far from it.
        let (mut sum, mut far) = (0.0, far);
        for _ in 0..HALVINGS {
            let middle = near.midpoint(far);
            if (near - x).abs() >= FAR * (far - near).abs() {
                break;
            }
            sum += self.plain(kernel, x, (middle, far), g);
            far = middle;
        }
        sum + self.plain(kernel, x, (near, far), g)
    }

    /// From `x` to an end, with the singularity at `x`.
    fn from(&self, kernel: &dyn Kernel, x: f64, end: f64, g: &dyn Fn(f64) -> f64) -> f64 {
        let length = (end - x).abs();
        let direction = (end - x).signum();
        // sigma(L u) = L^-q sigma(u) + sigma(L), the logarithm ln(L u) = ln u + ln L.
        let (scale, shift) = match self.singularity {
            Singularity::Power { exponent } => {
                (length.powf(-exponent), self.singularity.value(length))
            }
            Singularity::Logarithm => (1.0, length.ln()),
            Singularity::None => (0.0, 0.0),
        };
        let terms = self.nodes.iter().zip(&self.weights).zip(&self.singular);
        length
            * terms
                .map(|((t, weight), singular)| {
                    let distance = length * 0.5 * (1.0 + t);
                    let s = x + direction * distance;
                    let split = kernel.split(x, s, distance);
                    let plain = 0.5 * weight;
                    let sigma = scale * singular + shift * plain;
                    (split.factor * sigma + split.rest * plain) * g(s)
                })
                .sum::<f64>()
    }

    fn plain(
        &self,
        kernel: &dyn Kernel,
        x: f64,
        (one, other): (f64, f64),
        g: &dyn Fn(f64) -> f64,
    ) -> f64 {
        let (centre, half) = (one.midpoint(other), 0.5 * (other - one).abs());
        let terms = self.nodes.iter().zip(&self.weights).map(|(t, weight)| {
            let s = centre + half * t;
            weight * kernel.pair(x, s, (x - s).abs()).value * g(s)
        });
        half * terms.sum::<f64>()
    }
}

/// `P_k(t)`, `k < 20`.
pub(super) fn legendre(t: f64) -> [f64; NODES] {
    let mut values = [1.0; NODES];
    values[1] = t;
    for k in 2..NODES {
        let n = k as f64;
        values[k] = ((2.0 * n - 1.0) * t * values[k - 1] - (n - 1.0) * values[k - 2]) / n;
    }
    values
}

/// `int_0^1 P_k(2u - 1) sigma(u) du`: with `sigma = (u^-q - 1)/q` it is `1/(1 - q)` for `k = 0`, else `-prod_(i=1)^(k-1) (-q - i) / prod_(i=0)^k (1 - q + i)`; the logarithm is that of `q = 0`
/// with the other sign.
fn moments(singularity: Singularity) -> [f64; NODES] {
    let (q, sign) = match singularity {
        Singularity::None => return [0.0; NODES],
        Singularity::Logarithm => (0.0, -1.0),
        Singularity::Power { exponent } => (exponent, 1.0),
    };
    let mut moments = [sign / (1.0 - q); NODES];
    let mut product = -sign / (1.0 - q);
    for (k, moment) in moments.iter_mut().enumerate().skip(1) {
        let n = k as f64;
        if k > 1 {
            product *= -q - (n - 1.0);
        }
        product /= 1.0 - q + n;
        *moment = product;
    }
    moments
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Interval;
    use crate::kernel::{Logarithm, Power};

    /// Closed forms: `int_(-1)^1 ln(1/|x - s|) ds` and `int_(-1)^1 |x - s|^-mu ds`.
    #[test]
    fn potentials_of_constants() {
        let logarithm = Logarithm::unit();
        let rule = Rule::new(logarithm.singularity()).unwrap();
        for x in [-1.0, -0.3, 0.99, 1.0, 1.001, 1.2] {
            let term = |d: f64| if d == 0.0 { 0.0 } else { d - d * d.abs().ln() };
            let exact = term(1.0 - x) + term(1.0 + x);
            let found = rule.near(&logarithm, x, (-1.0, 1.0), &|_| 1.0);
            assert!((found - exact).abs() < 1e-14, "{x}: {found} {exact}");
        }
        for mu in [1e-9, 0.3, 0.9] {
            let power = Power::new(Interval::unit(), mu).unwrap();
            let rule = Rule::new(power.singularity()).unwrap();
            for x in [-1.0, -0.3, 0.99, 1.0] {
                let term = |d: f64| d.powf(1.0 - mu) / (1.0 - mu);
                let exact = term(1.0 - x) + term(1.0 + x);
                let found = rule.near(&power, x, (-1.0, 1.0), &|_| 1.0);
                assert!((found - exact).abs() < 1e-14 * exact, "{mu} {x}: {found} {exact}");
            }
        }
    }
}
