//! Associated Legendre functions of even degree difference, orthonormal on `(0, 1)`.

use std::f64::consts::PI;

/// `e_j(eta) = sqrt(2) P^m_{m+2j}(eta)`, normalised and without the Condon-Shortley phase: `int_0^1 e_i e_j d eta = delta_ij`, even in `eta`, positive near `eta = 1`.
///
/// `eta^2 e_j = b_{j-1} e_{j-1} + a_j e_j + b_j e_{j+1}` with `a_j = c_l^2 + c_{l+1}^2`, `b_j = c_{l+1} c_{l+2}`, `c_l^2 = (l^2 - m^2)/(4 l^2 - 1)`, `l = m + 2j`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LegendreBasis {
    /// `m`.
    harmonic: u32,
    /// `e_0 / (1 - eta^2)^(m/2)`.
    first: f64,
    near_pole: Vec<Step>,
    near_equator: Vec<Step>,
}

/// One step of the recurrence in differences from a solution `W_j` for `zeta = 0` with `zeta = 1 - eta^2` or `eta^2`: `e_{j+1} = ratio e_j + D_{j+1}`, `D_{j+1} = carried D_j - drop zeta e_j`.
///
/// The plain recurrence loses `j^2` units in the last place at either end; this one about `j` (C. Reinsch's modification of Clenshaw's).
#[derive(Debug, Clone, Copy, PartialEq)]
struct Step {
    ratio: f64,
    carried: f64,
    drop: f64,
}

impl LegendreBasis {
    /// The functions `e_0 .. e_{order-1}`.
    pub(crate) fn new(harmonic: u32, order: usize) -> Self {
        let m = f64::from(harmonic);
        let outward: Vec<f64> = (0..order).map(|j| outward(m, j)).collect();
        // l + m over l - m, twice; at the pole e_j ~ sqrt((2l+1) (l+m)!/(l-m)!) (1 - eta^2)^(m/2).
        let pole = |j: usize| {
            let l = m + 2.0 * j as f64;
            let quotient = (l + m + 2.0) * (l + m + 1.0) / ((l - m + 2.0) * (l - m + 1.0));
            ((2.0 * l + 5.0) / (2.0 * l + 1.0) * quotient).sqrt()
        };
        let equator = |j: usize| -strength_quotient(m, j).sqrt();
        let near_pole = steps(&outward, 1.0, pole);
        let near_equator = steps(&outward, -1.0, equator);
        Self { harmonic, first: first(harmonic), near_pole, near_equator }
    }

    /// `e_0 / (1 - eta^2)^(m/2)`.
    pub(crate) fn first(&self) -> f64 {
        self.first
    }

    /// Number of functions.
    pub(crate) fn order(&self) -> usize {
        self.near_pole.len()
    }

    /// The functions at `eta = sqrt(1 - xi^2)`, `0 <= xi <= 1`, one after the other to `take`.
    pub(crate) fn at(&self, xi: f64, mut take: impl FnMut(usize, f64)) {
        let from_pole = xi * xi;
        let (steps, zeta) = if from_pole <= 0.5 {
            (&self.near_pole, from_pole)
        } else {
            (&self.near_equator, (1.0 - xi) * (1.0 + xi))
        };
        let mut value = self.first * xi.powi(self.harmonic as i32);
        let mut difference = 0.0;
        for (j, step) in steps.iter().enumerate() {
            take(j, value);
            difference = step.carried * difference - step.drop * zeta * value;
            value = step.ratio * value + difference;
        }
    }
}

/// The entries of `eta^2` in the basis: the diagonal `a_j` and `b_j` beside it.
pub(crate) fn square_of_height(harmonic: u32, j: usize) -> (f64, f64) {
    let m = f64::from(harmonic);
    let l = m + 2.0 * j as f64;
    (square(m, l) + square(m, l + 1.0), outward(m, j))
}

/// `c_l^2`; at `l = m` it vanishes, where for `m = 0` the formula has the same value.
fn square(m: f64, l: f64) -> f64 {
    (l - m) * (l + m) / ((2.0 * l - 1.0) * (2.0 * l + 1.0))
}

/// `b_j`.
fn outward(m: f64, j: usize) -> f64 {
    let l = m + 2.0 * j as f64;
    (square(m, l + 1.0) * square(m, l + 2.0)).sqrt()
}

/// `C_{j+1}^2/C_j^2` of [`strengths`].
fn strength_quotient(m: f64, j: usize) -> f64 {
    let j = j as f64;
    (2.0 * j + m + 2.5) * (j + 0.5) * (j + m + 0.5)
        / ((2.0 * j + m + 0.5) * (j + 1.0) * (j + m + 1.0))
}

/// `C_j`, `C_j^2 = (2j+m+1/2) Gamma(j+1/2) Gamma(j+m+1/2) / (j! (j+m)!)`; `e_j(0) = (-1)^j sqrt(2/pi) C_j`.
pub(crate) fn strengths(harmonic: u32, order: usize) -> Vec<f64> {
    let m = f64::from(harmonic);
    let mut strength = ((m + 0.5) * PI * central(harmonic)).sqrt();
    (0..order)
        .map(|j| {
            let current = strength;
            strength *= strength_quotient(m, j).sqrt();
            current
        })
        .collect()
}

/// `(1/2)_m / m!`.
fn central(harmonic: u32) -> f64 {
    (1..=harmonic).map(|k| (f64::from(k) - 0.5) / f64::from(k)).product()
}

/// `first^2 = (3/2)_m/m! = (2m+1) (1/2)_m/m!`, the inverse of `int_0^1 (1 - eta^2)^m d eta`.
fn first(harmonic: u32) -> f64 {
    ((2.0 * f64::from(harmonic) + 1.0) * central(harmonic)).sqrt()
}

fn steps(outward: &[f64], sign: f64, ratio: impl Fn(usize) -> f64) -> Vec<Step> {
    let step = |j: usize| {
        let carried = if j > 0 { outward[j - 1] / (outward[j] * ratio(j - 1)) } else { 0.0 };
        Step { ratio: ratio(j), carried, drop: sign / outward[j] }
    };
    (0..outward.len()).map(step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(basis: &LegendreBasis, xi: f64) -> Vec<f64> {
        let mut values = vec![0.0; basis.order()];
        basis.at(xi, |j, value| values[j] = value);
        values
    }

    #[test]
    fn legendre_polynomials() {
        // sqrt(4j+1) P_2j(eta), P_2 = (3 eta^2 - 1)/2, P_4 = (35 eta^4 - 30 eta^2 + 3)/8.
        let basis = LegendreBasis::new(0, 3);
        for xi in [0.0, 1e-9, 0.3, 0.8, 1.0] {
            let square = 1.0 - xi * xi;
            let found = values(&basis, xi);
            let second = 5f64.sqrt() * (1.5 * square - 0.5);
            let third = 3.0 * (4.375 * square * square - 3.75 * square + 0.375);
            assert!((found[0] - 1.0).abs() < 1e-15, "{xi} {found:?}");
            assert!((found[1] - second).abs() < 3e-15, "{xi} {found:?} {second}");
            assert!((found[2] - third).abs() < 3e-15, "{xi} {found:?} {third}");
        }
    }

    #[test]
    fn values_at_the_equator_are_the_strengths() {
        for harmonic in [0, 1, 2, 7, 50] {
            let basis = LegendreBasis::new(harmonic, 400);
            let found = values(&basis, 1.0);
            for (j, strength) in strengths(harmonic, 400).iter().enumerate() {
                let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
                let exact = sign * (2.0 / PI).sqrt() * strength;
                assert!((found[j] - exact).abs() < 1e-13 * exact.abs(), "{harmonic} {j}");
            }
        }
    }

    #[test]
    fn both_recurrences_meet_in_the_middle() {
        for harmonic in [0, 1, 5, 50] {
            let basis = LegendreBasis::new(harmonic, 300);
            let (below, above) = (0.5f64.sqrt().next_down(), 0.5f64.sqrt().next_up());
            let worst = (values(&basis, below).iter().zip(values(&basis, above)))
                .fold(0.0f64, |worst, (a, b)| worst.max((a - b).abs()));
            assert!(worst < 1e-12, "{harmonic}: {worst}");
        }
    }

    #[test]
    fn orthonormal_for_high_harmonics_and_degrees() {
        let (harmonic, order) = (50, 60);
        let basis = LegendreBasis::new(harmonic, order);
        let rule = crate::quadrature::double_exponential(400);
        let mut products = vec![0.0; order * order];
        for node in rule {
            // eta = (1 + t)/2, xi^2 = (1 - eta)(1 + eta).
            let eta = 0.5 * node.from_left;
            let xi = (0.5 * node.from_right * (1.0 + eta)).sqrt();
            let found = values(&basis, xi);
            for (k, row) in products.chunks_exact_mut(order).enumerate() {
                row.iter_mut()
                    .zip(&found)
                    .for_each(|(sum, value)| *sum += 0.5 * node.weight * found[k] * value);
            }
        }
        for (i, product) in products.iter().enumerate() {
            let exact = f64::from(u8::from(i / order == i % order));
            assert!((product - exact).abs() < 1e-12, "{} {}: {product}", i / order, i % order);
        }
    }
}
