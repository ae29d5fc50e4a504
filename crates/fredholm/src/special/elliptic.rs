//! Elliptic integrals, by means and duplications.

use std::f64::consts::FRAC_PI_2;

/// Steps after which every pair of positive doubles has one mean: each squares the ratio's distance from 1.
const MEAN_STEPS: usize = 64;
/// Duplications after which any three arguments agree: each divides their differences by four.
const DUPLICATIONS: usize = 600;

/// The complete integral `K(k) = pi/(2 AGM(1, k'))` by its complementary modulus `k' = sqrt(1 - k^2)`, `0 < k' <= 1`
/// (DLMF 19.8.5). From `k'` it keeps all digits as `k -> 1`, where `K ~ ln(4/k')`.
pub(crate) fn complete_first_kind(complementary_modulus: f64) -> f64 {
    FRAC_PI_2 / arithmetic_geometric_mean(1.0, complementary_modulus)
}

/// The arithmetic-geometric mean of two numbers that are not negative.
///
/// ```
/// let lemniscate = std::f64::consts::FRAC_PI_2 / fredholm::special::arithmetic_geometric_mean(1.0, 2f64.sqrt());
/// assert!((lemniscate - 1.311_028_777_146_059_9).abs() < 1e-15);
/// ```
#[must_use]
pub fn arithmetic_geometric_mean(mut a: f64, mut g: f64) -> f64 {
    for _ in 0..MEAN_STEPS {
        if (a - g).abs() <= 4.0 * f64::EPSILON * a {
            break;
        }
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    0.5 * (a + g)
}

/// Carlson's symmetric integral `R_F(x, y, z) = (1/2) int_0^inf dt / sqrt((t+x)(t+y)(t+z))`, arguments not negative and at most one
/// of them 0, by duplication (B. C. Carlson, Numer. Algorithms 10 (1995) 13; DLMF 19.36.1).
pub(crate) fn carlson_first_kind(x: f64, y: f64, z: f64) -> f64 {
    let [mut x, mut y, mut z] = [x, y, z];
    let mut mean = (x + y + z) / 3.0;
    for _ in 0..DUPLICATIONS {
        let spread = (mean - x).abs().max((mean - y).abs()).max((mean - z).abs());
        // The series below leaves out the 8th power of the spread.
        if spread < 5e-3 * mean {
            break;
        }
        let (p, q, r) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = p * q + p * r + q * r;
        (x, y, z) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift));
        mean = (x + y + z) / 3.0;
    }
    let (p, q) = (1.0 - x / mean, 1.0 - y / mean);
    let r = -p - q;
    let (e2, e3) = (p * q - r * r, p * q * r);
    let series = 1.0 - e2 / 10.0 + e3 / 14.0 + e2 * e2 / 24.0
        - 3.0 * e2 * e3 / 44.0
        - 5.0 * e2 * e2 * e2 / 208.0
        + 3.0 * e3 * e3 / 104.0
        + e2 * e2 * e3 / 16.0;
    series / mean.sqrt()
}

/// Carlson's symmetric integral `R_D(x, y, z) = (3/2) int_0^inf dt / ((t+z) sqrt((t+x)(t+y)(t+z)))`, `z` positive, the others not negative and at most one of them 0, by duplication (DLMF
/// 19.36.2).
pub(crate) fn carlson_second_kind(x: f64, y: f64, z: f64) -> f64 {
    let [mut x, mut y, mut z] = [x, y, z];
    let (mut sum, mut share) = (0.0, 1.0);
    let mut mean = (x + y + 3.0 * z) / 5.0;
    for _ in 0..DUPLICATIONS {
        let spread = (mean - x).abs().max((mean - y).abs()).max((mean - z).abs());
        // The series below leaves out the 6th power of the spread.
        if spread < 1e-3 * mean {
            break;
        }
        let (p, q, r) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = p * q + p * r + q * r;
        sum += 3.0 * share / (r * (z + shift));
        share *= 0.25;
        (x, y, z) = (0.25 * (x + shift), 0.25 * (y + shift), 0.25 * (z + shift));
        mean = (x + y + 3.0 * z) / 5.0;
    }
    let [dx, dy, dz] = [x, y, z].map(|part| 1.0 - part / mean);
    let (a, b) = (dx * dy, dz * dz);
    let (e2, e3) = (a - 6.0 * b, (3.0 * a - 8.0 * b) * dz);
    let (e4, e5) = (3.0 * (a - b) * b, a * b * dz);
    let series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0
        - 3.0 * e4 / 22.0
        - 9.0 * e2 * e3 / 52.0
        + 3.0 * e5 / 26.0;
    sum + share * series / (mean * mean.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_mpmath() {
        // mpmath 1.3, 30 digits: ellipk(1 - k'^2), and elliprf.
        for (complement, exact) in COMPLETE {
            let found = complete_first_kind(complement);
            assert!((found - exact).abs() < 4e-16 * exact, "{complement}: {found} {exact}");
        }
        for ([x, y, z], exact) in SYMMETRIC {
            for found in [carlson_first_kind(x, y, z), carlson_first_kind(z, x, y)] {
                assert!((found - exact).abs() < 1e-15 * exact, "{x} {y} {z}: {found} {exact}");
            }
        }
        assert!(carlson_first_kind(f64::NAN, 1.0, 1.0).is_nan());
        // R_D(0, y, 1) = 3 (K - E)/k^2 with k'^2 = y; ellipk and ellipe of mpmath.
        let exact = 3.0 * (2.156_515_647_499_643_4 - 1.211_056_027_568_459_5) / 0.75;
        assert!((carlson_second_kind(0.0, 0.25, 1.0) / exact - 1.0).abs() < 1e-15);
        assert!((carlson_second_kind(2.0, 2.0, 2.0) * 2f64.powf(1.5) - 1.0).abs() < 1e-15);
    }

    const COMPLETE: [(f64, f64); 7] = [
        (1.0, FRAC_PI_2),
        (0.999, 1.5715822161760173),
        (0.5, 2.1565156474996434),
        (0.25, 2.8012060846652043),
        (1e-6, 15.201804919087715),
        (1e-8, 19.806975105072258),
        (1e-150, 346.77405831022674),
    ];

    const SYMMETRIC: [([f64; 3], f64); 6] = [
        ([0.0, 1.0, 1.0], FRAC_PI_2),
        ([1.0, 2.0, 3.0], 0.7269459354689082),
        ([0.3, 1e-16, 1.0], 2.075363117035051),
        ([0.0, 1e-16, 1.0], 19.806975105072258),
        ([1e-300, 0.5, 1.0], 1.8540746773013719),
        ([0.999, 0.9991, 1.0], 1.000316847539749),
    ];
}
