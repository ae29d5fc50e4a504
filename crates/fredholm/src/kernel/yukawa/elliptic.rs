//! The distance on a circle as an elliptic function, by theta series.

use std::f64::consts::{FRAC_PI_2, PI};

/// The complementary modulus up to which the series in its own nome are taken: either nome stays below 0.1.
const TURNING: f64 = 0.9;
/// Points still closer to each other, whose period is infinite to rounding, are moved apart.
const SMALLEST: f64 = 1e-100;
/// Points still nearer to the centre, where the kernel overflows, are moved here.
const LEAST: f64 = 1e-300;
/// Coefficients below this do not count; the cosine they multiply is at most 1.
const NEGLIGIBLE: f64 = 1e-30;
/// Coefficients kept of the theta series as polynomials in the cosine: the first one left out is `nome^20`.
type Polynomial = [f64; 5];

/// Two different points as the integrals want them: nothing here underflows where `x s` does.
#[derive(Debug, Clone, Copy)]
pub(super) struct Points {
    /// The larger of both.
    pub(super) larger: f64,
    /// The smaller one over it.
    pub(super) ratio: f64,
    /// `|x - s|`.
    pub(super) distance: f64,
}

impl Points {
    pub(super) fn new(x: f64, s: f64, distance: f64) -> Self {
        let (smaller, larger) = if x < s { (x, s) } else { (s, x) };
        let ratio = if smaller > 0.0 { smaller / larger } else { 0.0 };
        if larger < LEAST {
            return Self { larger: LEAST, ratio, distance: LEAST * (1.0 - ratio) };
        }
        Self { larger, ratio, distance }
    }

    pub(super) fn sum(&self) -> f64 {
        self.larger * (1.0 + self.ratio)
    }

    /// `sinh(v/2) = d/(2 sqrt(x s))`, where `v = ln(larger/smaller)`.
    pub(super) fn half_sine(&self) -> f64 {
        0.5 * (self.distance / self.larger) / self.ratio.sqrt()
    }
}

/// The distance `R` from `x` to the points of the circle of radius `s` in the variable `w`, `dw = (x + s) du/(2 R)`: `R = d nd(w, k)` with the modulus
/// `k = 2 sqrt(x s)/(x + s)`, `k' = d/(x + s)`; the angle `u` goes from 0 to `pi` as `w` goes from 0 to `K`, and to `i ln(s/x)`, where `R = 0`, as `w` goes to `i K'`.
///
/// For close points (`k' <= 0.9`) with the nome `p = exp(-pi K/K')`:
/// `R/d = (theta_3/theta_2)(0) theta_2(i a)/theta_3(i a)`, `a = pi w/(2 K')`. For others with the nome `q = exp(-pi K'/K)`: `R/d = (theta_3/theta_4)(0) theta_4(b)/theta_3(b)`, `b = pi w/(2 K)`. All are series in
/// powers of the nome; with `c = 2 nome cosh 2a` or `2 nome cos 2b` they are polynomials (DLMF 20.2, 22.2).
#[derive(Debug, Clone)]
pub(super) struct Circle {
    close: bool,
    nome: f64,
    /// `ln(1/nome)`.
    logarithm: f64,
    /// `K` along the real axis.
    pub(super) along: f64,
    /// `K'` along the imaginary axis.
    pub(super) across: f64,
    numerator: Polynomial,
    denominator: Polynomial,
}

impl Circle {
    pub(super) fn new(points: Points) -> Self {
        let complement = (points.distance / points.sum()).max(SMALLEST);
        if complement <= TURNING {
            let modulus = 2.0 * points.ratio.sqrt() / (1.0 + points.ratio);
            Self::close(nome(complement * complement / (1.0 + modulus), modulus))
        } else {
            Self::apart(nome(2.0 * points.ratio / (1.0 + points.ratio), complement))
        }
    }

    fn close(p: f64) -> Self {
        let (p4, p6) = (p.powi(4), p.powi(6));
        // theta_2(i a)/(2 p^(1/4) cosh a)
        let numerator = [
            1.0 - p * p - p6 + p6 * p6,
            p * (1.0 - p4 - 2.0 * p4 * p6),
            p4 * (1.0 - p6),
            p4 * p4 * p,
            p4 * p6 * p6,
        ];
        let logarithm = -p.ln();
        let period = period(p);
        let other = period * logarithm / PI;
        Self {
            close: true,
            nome: p,
            logarithm,
            along: other,
            across: period,
            numerator,
            denominator: theta3(p),
        }
        .normalised()
    }

    fn apart(q: f64) -> Self {
        let denominator = theta3(q);
        let [c0, c1, c2, c3, c4] = denominator;
        let logarithm = -q.ln();
        let period = period(q);
        let other = period * logarithm / PI;
        // theta_4(b) = theta_3(b + pi/2)
        let numerator = [c0, -c1, c2, -c3, c4];
        Self {
            close: false,
            nome: q,
            logarithm,
            along: period,
            across: other,
            numerator,
            denominator,
        }
        .normalised()
    }

    fn normalised(mut self) -> Self {
        let scale = 1.0 / self.stretch(2.0);
        self.numerator.iter_mut().for_each(|coefficient| *coefficient *= scale);
        // Beside the leading 1 they do nothing but underflow, which is slow.
        for coefficient in self.numerator.iter_mut().chain(&mut self.denominator) {
            *coefficient = if coefficient.abs() < NEGLIGIBLE { 0.0 } else { *coefficient };
        }
        self
    }

    /// `R/d` from `2 cosh a`, `2 cos a`, `2 cosh b` or `2 cos b`.
    fn stretch(&self, twice_cosine: f64) -> f64 {
        let c = self.nome * (twice_cosine * twice_cosine - 2.0);
        let horner =
            |[c0, c1, c2, c3, c4]: &Polynomial| c0 + c * (c1 + c * (c2 + c * (c3 + c * c4)));
        let quotient = horner(&self.numerator) / horner(&self.denominator);
        if self.close { 0.5 * twice_cosine * quotient } else { quotient }
    }

    /// `R/d` at `w = K j/count`, `j = 1 .. count`: from 1 to `1/k'`.
    pub(super) fn along(&self, count: u32) -> impl Iterator<Item = f64> + '_ {
        Walk::new(self.close, self.logarithm, count).map(|cosine| self.stretch(cosine))
    }

    /// `R/d` at `w = i K' j/count`, `j = 1 .. count`: from 1 to 0.
    pub(super) fn across(&self, count: u32) -> impl Iterator<Item = f64> + '_ {
        Walk::new(!self.close, self.logarithm, count).map(|cosine| self.stretch(cosine))
    }
}

/// The nome of a modulus, from `1 - k'` and `k'`: with `l = (1 - sqrt k')/(2 (1 + sqrt k'))` it is `l + 2 l^5 + 15 l^9 + ...` (DLMF 19.5.5).
fn nome(difference: f64, complement: f64) -> f64 {
    let root = 1.0 + complement.sqrt();
    let l = 0.5 * difference / (root * root);
    let l4 = l.powi(4);
    l * (1.0 + l4 * (2.0 + l4 * (15.0 + l4 * (150.0 + l4 * (1707.0 + l4 * 20910.0)))))
}

/// The quarter period of the nome.
fn period(nome: f64) -> f64 {
    let p4 = nome.powi(4);
    let theta = 1.0 + 2.0 * (nome + p4 + p4 * p4 * nome + p4 * p4 * p4 * p4);
    FRAC_PI_2 * theta * theta
}

/// `theta_3` as a polynomial in `c`.
fn theta3(p: f64) -> Polynomial {
    let (p2, p4) = (p * p, p.powi(4));
    let (p8, p12) = (p4 * p4, p4 * p4 * p4);
    [1.0 - 2.0 * p4 + 2.0 * p8 * p8, 1.0 - 3.0 * p8, p2 * (1.0 - 4.0 * p12), p2 * p4, p12]
}

/// `2 cosh` or `2 cos` of equidistant arguments up to the quarter period.
struct Walk {
    hyperbolic: bool,
    left: u32,
    count: u32,
    factors: [f64; 2],
    powers: [f64; 2],
}

impl Walk {
    fn new(hyperbolic: bool, logarithm: f64, count: u32) -> Self {
        let step = if hyperbolic { (0.5 * logarithm / f64::from(count)).exp() } else { 1.0 };
        Self { hyperbolic, left: count, count, factors: [step, 1.0 / step], powers: [1.0; 2] }
    }
}

impl Iterator for Walk {
    type Item = f64;

    fn next(&mut self) -> Option<f64> {
        if self.left == 0 {
            return None;
        }
        self.left -= 1;
        if self.hyperbolic {
            self.powers[0] *= self.factors[0];
            self.powers[1] *= self.factors[1];
            Some(self.powers[0] + self.powers[1])
        } else {
            let share = f64::from(self.count - self.left) / f64::from(self.count);
            Some(2.0 * (FRAC_PI_2 * share).cos())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angles_of_the_nodes_satisfy_the_differential_equation() {
        // K(k) by the arithmetic-geometric mean, and dw = (x + s) du/(2 R) by the midpoint rule between neighbours.
        for (x, s) in [(0.3, 0.31), (0.3, 0.6), (0.04, 0.9), (0.06, 0.9), (1e-5, 2.0)] {
            let points = Points::new(x, s, s - x);
            let circle = Circle::new(points);
            let (mut a, mut b) = (1.0, (s - x) / (s + x));
            for _ in 0..8 {
                (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
            }
            assert!((circle.along - FRAC_PI_2 / a).abs() < 2e-15 * circle.along, "{x} {s}");
            let count = 4000;
            let angle = |stretch: f64| {
                2.0 * (points.half_sine() * ((stretch - 1.0) * (stretch + 1.0)).sqrt())
                    .min(1.0)
                    .asin()
            };
            let stretches: Vec<f64> = std::iter::once(1.0).chain(circle.along(count)).collect();
            assert!(
                (stretches[count as usize] - (x + s) / (s - x)).abs() < 1e-13 * (x + s) / (s - x)
            );
            let step = circle.along / f64::from(count);
            for pair in stretches[..count as usize / 2].windows(3) {
                let slope = (angle(pair[2]) - angle(pair[0])) / (2.0 * step);
                let exact = 2.0 * pair[1] * (s - x) / (x + s);
                // The angle of far points cancels in its square.
                let allowed = 1e-6 + 1e-9 * points.half_sine().powi(2);
                assert!((slope - exact).abs() < allowed * exact, "{x} {s}: {slope} {exact}");
            }
            let last = circle.across(7).last().unwrap();
            assert!(last.abs() < 1e-15, "{last}");
        }
    }
}
