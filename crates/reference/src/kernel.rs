//! Values of the kernels.

use std::f64::consts::PI;

use libm::tgamma;

/// A kernel with the measure of its base, as a function of the place `x` and the distance `d = s - x`, which keeps its digits where `x` and `s` are close.
#[derive(Clone, Copy)]
pub enum Kernel<'a> {
    /// `ln(1/|d|)`, one punch or a pair.
    Logarithm,
    /// `ln(1/(2 sin(pi |d|/L)))`, a row.
    Row {
        /// `L`.
        period: f64,
    },
    /// `|d|^-mu`, `0 < mu < 1`, graded ground.
    Power {
        /// `mu`.
        exponent: f64,
    },
    /// `s pi int_0^inf t^mu J_m(x t) J_m(s t) dt`, a disk, `0 <= x, s`, `m` 0 or 1, `0 <= mu < 1`: `s` belongs to the measure.
    Disk {
        /// `mu`, 0 on homogeneous ground.
        exponent: f64,
        /// `m`.
        harmonic: u8,
    },
    /// Any function of `|d|` that is a multiple of `ln(1/|d|)` and a smooth function where points meet, and smooth elsewhere: one punch or a pair on ground that is the same all along its surface.
    Plane(&'a dyn Fn(f64) -> f64),
}

impl Kernel<'_> {
    /// The value, with what the measure adds.
    #[must_use]
    pub fn value(&self, x: f64, d: f64) -> f64 {
        self.value_with(&self.constants(), x, d)
    }

    /// What does not depend on the places.
    pub(crate) fn constants(&self) -> [f64; 3] {
        match *self {
            Self::Disk { exponent, harmonic } if exponent > 0.0 => constants(exponent, harmonic),
            _ => [1.0; 3],
        }
    }

    /// The value with the constants known.
    pub(crate) fn value_with(&self, constants: &[f64; 3], x: f64, d: f64) -> f64 {
        match *self {
            Self::Logarithm => -d.abs().ln(),
            Self::Plane(value) => value(d.abs()),
            Self::Row { period } => -(2.0 * (PI * d / period).sin().abs()).ln(),
            Self::Power { exponent } => d.abs().powf(-exponent),
            Self::Disk { exponent, harmonic } => {
                if exponent == 0.0 {
                    (x + d) * circle(x, d, harmonic)
                } else {
                    graded(constants, x, d, exponent, harmonic)
                }
            }
        }
    }

    /// `mu`, 0 of a logarithm.
    #[must_use]
    pub fn exponent(&self) -> f64 {
        match *self {
            Self::Logarithm | Self::Plane(_) | Self::Row { .. } => 0.0,
            Self::Power { exponent } | Self::Disk { exponent, .. } => exponent,
        }
    }

    /// Distances `d`, besides 0, at which the kernel is not smooth.
    pub(crate) fn images(&self, x: f64) -> [f64; 2] {
        match *self {
            Self::Logarithm | Self::Plane(_) | Self::Power { .. } => [f64::INFINITY; 2],
            Self::Row { period } => [-period, period],
            Self::Disk { .. } => [-2.0 * x, f64::INFINITY],
        }
    }

    /// What the pressure at `s` adds to force and moment.
    pub(crate) fn weights(&self, s: f64) -> [f64; 2] {
        match self {
            Self::Disk { harmonic: 0, .. } => [2.0 * PI * s, 0.0],
            Self::Disk { .. } => [0.0, PI * s * s],
            _ => [1.0, s],
        }
    }

    /// What settlement and tilt add to the depth at `x`.
    pub(crate) fn lifts(&self, x: f64) -> [f64; 2] {
        match self {
            Self::Disk { harmonic: 0, .. } => [1.0, 0.0],
            Self::Disk { .. } => [0.0, x],
            _ => [1.0, x],
        }
    }
}

/// `pi int_0^inf J_m(x t) J_m(s t) dt`, `s = x + d`: `2 K(k)/M` and `2 (K(k) - E(k))/l` with `k = l/M`, `l` the smaller and `M` the larger of both.
///
/// By the arithmetic-geometric mean: `K = pi/(2 agm(1, k'))`, `K - E = K sum 2^(n-1) c_n^2` (Abramowitz & Stegun 17.6), whose terms have one sign.
fn circle(x: f64, d: f64, harmonic: u8) -> f64 {
    let (small, large) = if d < 0.0 { (x + d, x) } else { (x, x + d) };
    let (mut a, mut b) = (large, (d.abs() * (small + large)).sqrt());
    let mut c = small;
    let (mut sum, mut power) = (0.5 * c * c, 0.5);
    for _ in 0..60 {
        if c <= 1e-17 * a {
            break;
        }
        let next = 0.5 * (a + b);
        c = c * c / (4.0 * next);
        b = (a * b).sqrt();
        a = next;
        power *= 2.0;
        sum += power * c * c;
    }
    match harmonic {
        0 => PI / a,
        _ if small > 0.0 => PI / a * (sum / (large * large)) * (large / small),
        _ => 0.0,
    }
}

/// `s pi int_0^inf t^mu J_m(x t) J_m(s t) dt`, `s = x + d`, the mean over the angle of `s C |x - s e^(i phi)|^-2a cos(m phi)`, `2a = 1 + mu`, by hypergeometric series: of `k^2` below 1/2, of `1 - k^2` above.
fn graded(constants: &[f64; 3], x: f64, d: f64, mu: f64, harmonic: u8) -> f64 {
    let [strength, near, far] = constants;
    let (small, large) = if d < 0.0 { (x + d, x) } else { (x, x + d) };
    let (half, m) = (0.5 * (1.0 + mu), f64::from(harmonic));
    let k = small / large;
    let lead = if harmonic == 0 { 1.0 } else { half * k };
    // The defect 1 - k^2 without a loss of digits.
    let defect = d.abs() / large * (1.0 + k);
    let (a, b, c) = (half, half + m, 1.0 + m);
    let value = if defect > 0.5 {
        series(a, b, c, k * k)
    } else {
        near * series(a, b, 1.0 + mu, defect)
            + far * defect.powf(-mu) * series(c - a, c - b, 1.0 - mu, defect)
    };
    // On the axis places are so near to it that the power of both together overflows.
    strength * lead * value * ((x + d) / large) * large.powf(-mu)
}

/// `pi C`, and the factors of both series in `1 - k^2`, where `c - a - b = -mu` (Abramowitz & Stegun 15.3.6).
fn constants(mu: f64, harmonic: u8) -> [f64; 3] {
    let (half, m) = (0.5 * (1.0 + mu), f64::from(harmonic));
    let (a, b, c) = (half, half + m, 1.0 + m);
    [
        PI * mu.exp2() * tgamma(half) / tgamma(0.5 * (1.0 - mu)),
        tgamma(c) * tgamma(-mu) / (tgamma(c - a) * tgamma(c - b)),
        tgamma(c) * tgamma(mu) / (tgamma(a) * tgamma(b)),
    ]
}

/// The hypergeometric series, `0 <= z <= 1/2`.
fn series(a: f64, b: f64, c: f64, z: f64) -> f64 {
    let (mut term, mut sum) = (1.0f64, 1.0f64);
    for n in 0..80 {
        let n = f64::from(n);
        term *= (a + n) * (b + n) / ((c + n) * (1.0 + n)) * z;
        sum += term;
        if term.abs() < 1e-18 * sum.abs() {
            break;
        }
    }
    sum
}
