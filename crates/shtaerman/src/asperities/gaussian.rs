//! Tails of the normal distribution, `F_n(h) = int_h^inf (s - h)^n phi(s) ds`, `phi(s) = exp(-s^2/2)/sqrt(2 pi)`.
//!
//! With `s = h + t^2` the integrand is entire in `t`; the double-exponential rule gives 14 digits for `-5 <= h <= 37`.

use std::f64::consts::{PI, SQRT_2};

use fredholm::quadrature::double_exponential;

/// Nodes on either side of the middle of the range.
const HALF_COUNT: usize = 100;
/// The integrand is cut where it has fallen by `exp(-CUT)`.
const CUT: f64 = 42.0;

/// `phi(h)`.
fn density(h: f64) -> f64 {
    (-0.5 * h * h).exp() / (2.0 * PI).sqrt()
}

/// `F_(1/2)(h)`.
pub(super) fn half(h: f64) -> f64 {
    integral(h, |t| t * t)
}

/// `F_1(h)`.
pub(super) fn one(h: f64) -> f64 {
    integral(h, |t| t * t * t)
}

/// `F_0(h)`, the share of the distribution above `h`.
pub(super) fn share(h: f64) -> f64 {
    0.5 * libm::erfc(h / SQRT_2)
}

/// `F_(3/2)(h)`.
pub(super) fn three_halves(h: f64) -> f64 {
    integral(h, |t| (t * t) * (t * t))
}

/// `int 2 t^(2n+1) phi(h + t^2) dt` over `t > 0`, `power` being `t^(2n+1)`.
fn integral(h: f64, power: impl Fn(f64) -> f64) -> f64 {
    // There (h + t^2)^2/2 = max(h, 0)^2/2 + CUT.
    let floor = h.max(0.0);
    let end = ((floor * floor + 2.0 * CUT).sqrt() - h).sqrt();
    let sum: f64 = double_exponential(HALF_COUNT)
        .map(|node| {
            let t = 0.5 * end * node.from_left;
            node.weight * power(t) * density(h + t * t)
        })
        .sum();
    end * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `h`, `F_(1/2)`, `F_1`, `F_(3/2)` by mpmath in 40 digits, as parabolic cylinder functions.
    const TRUTH: [(f64, f64, f64, f64); 10] = [
        (-4.0, 1.9832298897597236, 4.000007145258432, 8.189959426789363),
        (-1.0, 0.9006029312703163, 1.0833154705876864, 1.4045974704739523),
        (0.0, 0.4110894793312293, 0.3989422804014327, 0.4300199936622598),
        (0.5, 0.2253355816973116, 0.19779655740130603, 0.19520360374379064),
        (1.0, 0.1041536753078577, 0.0833154705876863, 0.07566817739097507),
        (2.0, 0.012480040296439067, 0.008490702616829637, 0.006648177623587093),
        (3.0, 0.0006418504393485508, 0.0003821543170477236, 0.0002639675542694673),
        (5.0, 1.1014563207789281e-7, 5.346165533832815e-8, 3.033850561878485e-8),
        (10.0, 2.117479299141611e-24, 7.474560254589328e-25, 3.101206508673169e-25),
        (30.0, 7.9314845871808665e-199, 1.631956734091401e-199, 3.9547990870299806e-200),
    ];

    #[test]
    fn tails_are_those_of_mpmath() {
        for (h, f_half, f_one, f_three_halves) in TRUTH {
            // phi(30) itself has no more than 13 digits.
            let allowed = 1e-14 + 2e-16 * h * h;
            let close = |found: f64, truth: f64, allowed: f64| {
                assert!((found / truth - 1.0).abs() < allowed, "{h}: {found} {truth}");
            };
            close(half(h), f_half, allowed);
            close(three_halves(h), f_three_halves, allowed);
            close(one(h), f_one, allowed);
        }
    }

    #[test]
    fn far_tails_are_exponential() {
        // F_n(h) -> phi(h) Gamma(n + 1) h^-(n+1)
        let h = 35.0f64;
        let limit = |n: f64| density(h) * libm::tgamma(n + 1.0) * h.powf(-n - 1.0);
        assert!((half(h) / limit(0.5) - 1.0).abs() < 3.0 / (h * h));
        assert!((three_halves(h) / limit(1.5) - 1.0).abs() < 6.0 / (h * h));
    }
}
