//! Sequences of cosines or sines of multiples of an angle, right to the ends of the interval.

/// `y_m = cos m w` or `y_m = cos((2m + 1) w/2)`, `m = 0, 1, ...`, for `0 <= w <= 2 pi`.
///
/// The Chebyshev systems of the logarithmic kernels are of this form. Their argument is held as an angle that is small near either end: from
/// `cos w` alone a polynomial of degree `n` would lose a factor `n^2` in accuracy there, from the angle it loses `n`. (C. Reinsch's form of
/// Clenshaw's recurrence; R. Bulirsch and J. Stoer, Introduction to Numerical Analysis, section 1.3.)
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Harmonics {
    /// `z_0`.
    start: f64,
    /// `z_1 - z_0`.
    step: f64,
    /// `-4 sin^2(w/2)`: second differences of `z` are this multiple of its values.
    decrement: f64,
    /// Whether `y_m = (-1)^m z_m`, else `y_m = z_m`.
    alternating: bool,
}

impl Harmonics {
    /// `y_m = cos m w` with `w = angle`, or `w = pi - angle` where `mirrored`.
    pub(crate) fn cosines(angle: f64, mirrored: bool) -> Self {
        let sine = (0.5 * angle).sin();
        let decrement = -4.0 * sine * sine;
        Self { start: 1.0, step: 0.5 * decrement, decrement, alternating: mirrored }
    }

    /// `y_m = T_{2m}(xi)`, `0 <= xi <= 1`, `complement = 1 - xi` to all its digits.
    pub(crate) fn even_chebyshev(xi: f64, complement: f64) -> Self {
        match Argument::new(xi, complement) {
            Argument::FromEnd(angle) => Self::cosines(2.0 * angle, false),
            // T_2m(sin psi) = (-1)^m cos(2 m psi)
            Argument::FromMiddle(angle) => Self::cosines(2.0 * angle, true),
        }
    }

    /// `y_m = T_{2m+1}(xi)`, `0 <= xi <= 1`, `complement = 1 - xi` to all its digits.
    pub(crate) fn odd_chebyshev(xi: f64, complement: f64) -> Self {
        match Argument::new(xi, complement) {
            Argument::FromEnd(angle) => {
                let (sine, cosine) = angle.sin_cos();
                let decrement = -4.0 * sine * sine;
                Self { start: cosine, step: decrement * cosine, decrement, alternating: false }
            }
            // T_{2m+1}(sin psi) = (-1)^m sin((2m + 1) psi)
            Argument::FromMiddle(_) => {
                let decrement = -4.0 * xi * xi;
                let step = 2.0 * xi + decrement * xi;
                Self { start: xi, step, decrement, alternating: true }
            }
        }
    }

    /// All values with the other sign.
    pub(crate) fn negated(self) -> Self {
        Self { start: -self.start, step: -self.step, ..self }
    }

    /// Writes `y_0, y_1, ...`.
    pub(crate) fn fill<'v>(self, values: impl Iterator<Item = &'v mut f64>) {
        let (mut z, mut step, mut sign) = (self.start, self.step, 1.0);
        for value in values {
            *value = sign * z;
            z += step;
            step += self.decrement * z;
            if self.alternating {
                sign = -sign;
            }
        }
    }

    /// `sum_m c_m y_m`.
    pub(crate) fn sum<'c>(
        self,
        coefficients: impl DoubleEndedIterator<Item = &'c f64> + ExactSizeIterator,
    ) -> f64 {
        let even_count = coefficients.len().is_multiple_of(2);
        let mut sign = if self.alternating && even_count { -1.0 } else { 1.0 };
        // b_m = c_m + 2 cos(w) b_{m+1} - b_{m+2}, carried as b and its differences.
        let (mut b, mut above, mut difference) = (0.0, 0.0, 0.0);
        for c in coefficients.rev() {
            above = b;
            difference += sign * c + self.decrement * b;
            b += difference;
            if self.alternating {
                sign = -sign;
            }
        }
        self.start * (difference - self.decrement * above) + self.step * above
    }
}

/// The angle of `xi` from whichever is nearer of 1 and 0.
enum Argument {
    /// `acos xi`.
    FromEnd(f64),
    /// `asin xi`.
    FromMiddle(f64),
}

impl Argument {
    fn new(xi: f64, complement: f64) -> Self {
        // cos(pi/4) = 0.707...
        if complement < 0.29 {
            Self::FromEnd(2.0 * (0.5 * complement).sqrt().asin())
        } else {
            Self::FromMiddle(xi.asin())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn check(sequence: Harmonics, exact: impl Fn(f64) -> f64) {
        let mut values = [0.0; 60];
        sequence.fill(values.iter_mut());
        for (m, value) in values.iter().enumerate() {
            let exact = exact(m as f64);
            assert!((value - exact).abs() < 4e-14, "{sequence:?} {m}: {value} {exact}");
        }
        for count in [0, 1, 2, 3, 8, 60] {
            let coefficients: Vec<f64> =
                (0..count).map(|m| (0.7 * f64::from(m)).cos() / (1.0 + f64::from(m))).collect();
            let found = sequence.sum(coefficients.iter());
            let sum: f64 = coefficients.iter().zip(&values).map(|(c, y)| c * y).sum();
            assert!((found - sum).abs() < 4e-14, "{sequence:?} {count}: {found} {sum}");
        }
    }

    #[test]
    fn agrees_with_the_cosines() {
        for i in 0..=50 {
            let angle = PI * f64::from(i) / 100.0;
            check(Harmonics::cosines(angle, false), |m| (m * angle).cos());
            check(Harmonics::cosines(angle, true), |m| (m * (PI - angle)).cos());
            let (xi, complement) = (angle.cos(), 2.0 * (0.5 * angle).sin().powi(2));
            check(Harmonics::even_chebyshev(xi, complement), |m| (2.0 * m * angle).cos());
            let odd = Harmonics::odd_chebyshev(xi, complement);
            check(odd, |m| ((2.0 * m + 1.0) * angle).cos());
            check(odd.negated(), |m| -((2.0 * m + 1.0) * angle).cos());
        }
    }

    #[test]
    fn keeps_the_digits_at_the_ends_at_high_degree() {
        // T_n(1 - d) = cos(n acos(1 - d)), acos(1 - d) = sqrt(2 d) (1 + d/12 + ...)
        let (d, degree) = (1e-9, 20_000);
        let mut values = vec![0.0; degree / 2];
        Harmonics::even_chebyshev(1.0 - d, d).fill(values.iter_mut());
        let angle = (2.0 * d).sqrt() * (1.0 + d / 12.0);
        for (m, value) in values.iter().enumerate() {
            assert!((value - (2.0 * m as f64 * angle).cos()).abs() < 1e-12);
        }
        let mut values = [1.0; 9];
        Harmonics::odd_chebyshev(0.0, 1.0).fill(values.iter_mut());
        assert!(values.iter().all(|&value| value == 0.0));
    }
}
