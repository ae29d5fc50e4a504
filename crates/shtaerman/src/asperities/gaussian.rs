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

    /// `h`, `F_(1/2)`, `F_1`, `F_(3/2)` by mpmath, 40 digits, as parabolic cylinder functions.
    const TRUTH: [(f64, f64, f64, f64); 10] = [
        (-4.0, 1.9832298897597235762, 4.0000071452584324057, 8.1899594267893631107),
        (-1.0, 0.90060293127031630458, 1.0833154705876862984, 1.4045974704739524227),
        (0.0, 0.41108947933122927617, 0.39894228040143267794, 0.43001999366225976769),
        (0.5, 0.22533558169731161331, 0.19779655740130602959, 0.19520360374379062989),
        (1.0, 0.10415367530785769392, 0.083315470587686298383, 0.075668177390975071438),
        (2.0, 0.012480040296439066797, 0.00849070261682963755, 0.0066481776235870931432),
        (3.0, 0.00064185043934855080302, 0.00038215431704772359565, 0.00026396755426946727776),
        (5.0, 1.1014563207789280641e-7, 5.3461655338328149539e-8, 3.033850561878484851e-8),
        (10.0, 2.1174792991416108821e-24, 7.4745602545893280366e-25, 3.1012065086731690564e-25),
        (30.0, 7.9314845871808665025e-199, 1.6319567340914011894e-199, 3.9547990870299807613e-200),
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
