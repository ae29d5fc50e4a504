//! The cubic spline through measured points.

/// A twice continuously differentiable cubic spline, not-a-knot at both ends; through three points a parabola, through two a line.
///
/// A piecewise linear curve would make every measured point a kink of the pressure; the spline has none. (C. de Boor, *A Practical Guide
/// to Splines*, ch. IV.)
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spline {
    abscissas: Vec<f64>,
    ordinates: Vec<f64>,
    slopes: Vec<f64>,
}

impl Spline {
    /// Through the points, whose abscissas increase strictly; at least two.
    pub(super) fn through(abscissas: Vec<f64>, ordinates: Vec<f64>) -> Self {
        let slopes = match abscissas.len() {
            2 => vec![chord(&abscissas, &ordinates, 0); 2],
            3 => parabola_slopes(&abscissas, &ordinates),
            _ => not_a_knot_slopes(&abscissas, &ordinates),
        };
        Self { abscissas, ordinates, slopes }
    }

    /// Abscissas of the first and last point.
    pub(super) fn range(&self) -> [f64; 2] {
        [self.abscissas[0], self.abscissas[self.abscissas.len() - 1]]
    }

    /// Abscissas of the points.
    pub(super) fn abscissas(&self) -> &[f64] {
        &self.abscissas
    }

    /// Abscissa, ordinate and slope at a point.
    pub(super) fn point(&self, index: usize) -> [f64; 3] {
        [self.abscissas[index], self.ordinates[index], self.slopes[index]]
    }

    /// Number of points.
    pub(super) fn len(&self) -> usize {
        self.abscissas.len()
    }

    /// The value at `x`; beyond the points the end pieces go on.
    pub(super) fn evaluate(&self, x: f64) -> f64 {
        let Piece { start, t, chord, left, right, .. } = self.piece(x);
        start + t * (chord + (1.0 - t) * (left * (1.0 - t) + right * t))
    }

    /// The slope at `x`.
    pub(super) fn slope(&self, x: f64) -> f64 {
        let Piece { width, t, chord, left, right, .. } = self.piece(x);
        let bent =
            (1.0 - 2.0 * t) * (left * (1.0 - t) + right * t) + t * (1.0 - t) * (right - left);
        (chord + bent) / width
    }

    fn piece(&self, x: f64) -> Piece {
        let last_piece = self.abscissas.len() - 2;
        let piece =
            self.abscissas.partition_point(|&knot| knot <= x).saturating_sub(1).min(last_piece);
        let width = self.abscissas[piece + 1] - self.abscissas[piece];
        let start = self.ordinates[piece];
        let chord = self.ordinates[piece + 1] - start;
        Piece {
            width,
            t: (x - self.abscissas[piece]) / width,
            start,
            chord,
            left: self.slopes[piece] * width - chord,
            right: chord - self.slopes[piece + 1] * width,
        }
    }
}

/// The cubic between two points, `start + t (chord + (1 - t) (left (1 - t) + right t))`.
struct Piece {
    width: f64,
    t: f64,
    start: f64,
    chord: f64,
    left: f64,
    right: f64,
}

fn chord(x: &[f64], y: &[f64], piece: usize) -> f64 {
    (y[piece + 1] - y[piece]) / (x[piece + 1] - x[piece])
}

fn parabola_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let (first, second) = (chord(x, y, 0), chord(x, y, 1));
    let curvature = (second - first) / (x[2] - x[0]);
    vec![
        first - curvature * (x[1] - x[0]),
        first + curvature * (x[1] - x[0]),
        second + curvature * (x[2] - x[1]),
    ]
}

/// Slopes from continuity of the second derivative inside and of the third at the last but one points: a tridiagonal
/// system, eliminated without pivoting (it is diagonally dominant but for the two end rows, which are safe).
fn not_a_knot_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    let width = |i: usize| x[i + 1] - x[i];
    let mut diagonal = vec![0.0; n];
    let mut upper = vec![0.0; n];
    let mut right = vec![0.0; n];
    let (h0, h1) = (width(0), width(1));
    diagonal[0] = h1;
    upper[0] = h0 + h1;
    right[0] = ((h0 + 2.0 * upper[0]) * h1 * chord(x, y, 0) + h0 * h0 * chord(x, y, 1)) / upper[0];
    for i in 1..n {
        let (below, row_diagonal, row_upper, row_right) = if i + 1 < n {
            let (before, after) = (width(i - 1), width(i));
            let value = 3.0 * (after * chord(x, y, i - 1) + before * chord(x, y, i));
            (after, 2.0 * (before + after), before, value)
        } else {
            let (h0, h1) = (width(n - 2), width(n - 3));
            let sum = h0 + h1;
            let value =
                (h0 * h0 * chord(x, y, n - 3) + (2.0 * sum + h0) * h1 * chord(x, y, n - 2)) / sum;
            (sum, h1, 0.0, value)
        };
        let factor = below / diagonal[i - 1];
        diagonal[i] = row_diagonal - factor * upper[i - 1];
        upper[i] = row_upper;
        right[i] = row_right - factor * right[i - 1];
    }
    let mut slopes = vec![0.0; n];
    for i in (0..n).rev() {
        let next = if i + 1 < n { upper[i] * slopes[i + 1] } else { 0.0 };
        slopes[i] = (right[i] - next) / diagonal[i];
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uneven(count: usize) -> Vec<f64> {
        (0..count).map(|i| i as f64 + 0.3 * (1.7 * i as f64).sin() - 2.0).collect()
    }

    #[test]
    fn reproduces_polynomials_of_its_degree() {
        for (count, degree) in [(2, 1), (3, 2), (4, 3), (5, 3), (12, 3)] {
            let f = |x: f64| {
                0.3 - x
                    + if degree > 1 { 0.7 * x * x } else { 0.0 }
                    + if degree > 2 { 0.1 * x.powi(3) } else { 0.0 }
            };
            let x = uneven(count);
            let spline = Spline::through(x.clone(), x.iter().map(|&x| f(x)).collect());
            for i in 0..=100 {
                let at = x[0] + (x[count - 1] - x[0]) * f64::from(i) / 100.0;
                assert!(
                    (spline.evaluate(at) - f(at)).abs() < 1e-12 * (1.0 + at.abs().powi(3)),
                    "{count} points at {at}"
                );
            }
        }
    }

    #[test]
    fn the_slope_is_that_of_a_cubic() {
        let x = uneven(9);
        let cubic = |x: f64| x * (x * (2.0 * x - 1.0) + 0.5);
        let spline = Spline::through(x.clone(), x.iter().map(|&x| cubic(x)).collect());
        for at in [-0.3, 0.2, 0.77, 1.4] {
            let exact = at * (6.0 * at - 2.0) + 0.5;
            assert!((spline.slope(at) - exact).abs() < 1e-11, "{at}");
        }
    }

    #[test]
    fn converges_with_order_four() {
        let error = |count: usize| {
            let x: Vec<f64> = (0..count).map(|i| 2.0 * i as f64 / (count - 1) as f64).collect();
            let spline = Spline::through(x.clone(), x.iter().map(|x| x.sin()).collect());
            (0..500)
                .map(|i| {
                    (spline.evaluate(f64::from(i) * 0.004) - (f64::from(i) * 0.004).sin()).abs()
                })
                .fold(0.0, f64::max)
        };
        let order = (error(41) / error(81)).log2();
        assert!(order > 3.7, "{order}");
    }
}
