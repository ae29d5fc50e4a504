//! The cubic spline through measured points.

use crate::expression::Reflection;

/// A twice continuously differentiable cubic spline, not-a-knot at both ends, through three points a parabola, through two a line; or one that repeats, twice continuously
/// differentiable across its ends too.
///
/// A piecewise linear curve would make every measured point a kink of the pressure; the spline has none. (C. de Boor, *A Practical Guide
/// to Splines*, ch. IV.)
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Spline {
    abscissas: Vec<f64>,
    ordinates: Vec<f64>,
    slopes: Vec<f64>,
    /// Whether it repeats.
    is_closed: bool,
}

impl Spline {
    /// Through the points, whose abscissas increase strictly; at least two.
    pub(super) fn through(abscissas: Vec<f64>, ordinates: Vec<f64>) -> Self {
        let slopes = match abscissas.len() {
            2 => vec![chord(&abscissas, &ordinates, 0); 2],
            3 => parabola_slopes(&abscissas, &ordinates),
            _ => not_a_knot_slopes(&abscissas, &ordinates),
        };
        Self { abscissas, ordinates, slopes, is_closed: false }
    }

    /// The same points repeated from end to end; none unless the last ordinate is the first.
    pub(super) fn closed(&self) -> Option<Self> {
        let (x, y) = (&self.abscissas, &self.ordinates);
        let slopes = (y[0] == y[y.len() - 1]).then(|| closed_slopes(x, y))?;
        Some(Self { slopes, is_closed: true, ..self.clone() })
    }

    /// The same spline less a constant.
    pub(super) fn lowered(&self, by: f64) -> Self {
        let ordinates = self.ordinates.iter().map(|y| y - by).collect();
        let lowered = Self::through(self.abscissas.clone(), ordinates);
        if self.is_closed { lowered.closed().unwrap_or(lowered) } else { lowered }
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

    /// Ordinates of the points.
    pub(super) fn ordinates(&self) -> &[f64] {
        &self.ordinates
    }

    /// Number of points.
    pub(super) fn len(&self) -> usize {
        self.abscissas.len()
    }

    /// Whether the points are mirror images of each other about zero.
    pub(super) fn reflection(&self) -> Reflection {
        let is_odd = |values: &[f64]| values.iter().zip(values.iter().rev()).all(|(a, b)| *a == -b);
        let is_even = |values: &[f64]| values.iter().zip(values.iter().rev()).all(|(a, b)| a == b);
        let is_mirrored = is_odd(&self.abscissas);
        Reflection {
            is_even: is_mirrored && is_even(&self.ordinates),
            is_odd: is_mirrored && is_odd(&self.ordinates),
        }
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

    /// The piece of a place. Points lie at nearly equal distances more often than not: where they do it is guessed.
    fn piece_at(&self, x: f64) -> usize {
        let (knots, last) = (&self.abscissas, self.abscissas.len() - 2);
        let share = (x - knots[0]) / (knots[last + 1] - knots[0]);
        let guess = ((share * (last + 1) as f64) as usize).min(last);
        if knots[guess] <= x && x < knots[guess + 1] {
            return guess;
        }
        knots.partition_point(|&knot| knot <= x).saturating_sub(1).min(last)
    }

    fn piece(&self, x: f64) -> Piece {
        let piece = self.piece_at(x);
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

/// Slopes from continuity of the second derivative at all points, the first and last of which are one: a tridiagonal system but for its corners, which are one product of two vectors (J. Sherman and
/// W. J. Morrison, Ann. Math. Statist. 21 (1950) 124).
fn closed_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len() - 1;
    let width = |i: usize| x[i + 1] - x[i];
    let rows = (0..n).map(|i| {
        let before = if i == 0 { n - 1 } else { i - 1 };
        let (h0, h1) = (width(before), width(i));
        let right = 3.0 * (h1 * chord(x, y, before) + h0 * chord(x, y, i));
        [h1, 2.0 * (h0 + h1), h0, right]
    });
    let mut rows: Vec<[f64; 4]> = rows.collect();
    let mut slopes = match n {
        1 => vec![0.0],
        2 => {
            // Both neighbours of either point are the other.
            let ([a, d, b, one], other) = (rows[0], rows[1][3]);
            let determinant = d * d - (a + b) * (a + b);
            [(one, other), (other, one)].map(|(u, v)| (d * u - (a + b) * v) / determinant).to_vec()
        }
        _ => {
            let [below, above] = [rows[0][0], rows[n - 1][2]];
            // With corners g v, g = (-d, 0, .., above), v = (1, 0, .., below/-d).
            let first = -rows[0][1];
            rows[0][1] -= first;
            rows[n - 1][1] -= above * below / first;
            let right: Vec<f64> = rows.iter().map(|row| row[3]).collect();
            let mut corner = vec![0.0; n];
            (corner[0], corner[n - 1]) = (first, above);
            let (plain, turned) = (tridiagonal(&rows, right), tridiagonal(&rows, corner));
            let ends = |z: &[f64]| z[0] + below / first * z[n - 1];
            let factor = ends(&plain) / (1.0 + ends(&turned));
            plain.iter().zip(&turned).map(|(one, other)| one - factor * other).collect()
        }
    };
    slopes.push(slopes[0]);
    slopes
}

/// Solves rows `[below, diagonal, above, _]` by elimination without pivoting: they are diagonally dominant.
fn tridiagonal(rows: &[[f64; 4]], mut right: Vec<f64>) -> Vec<f64> {
    let n = rows.len();
    let mut diagonal: Vec<f64> = rows.iter().map(|row| row[1]).collect();
    for i in 1..n {
        let factor = rows[i][0] / diagonal[i - 1];
        diagonal[i] -= factor * rows[i - 1][2];
        right[i] -= factor * right[i - 1];
    }
    for i in (0..n).rev() {
        let next = if i + 1 < n { rows[i][2] * right[i + 1] } else { 0.0 };
        right[i] = (right[i] - next) / diagonal[i];
    }
    right
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

    #[test]
    fn what_repeats_is_smooth_across_its_ends() {
        // Truth: the middle of many periods one after the other, of which the ends are far away.
        for count in [2, 3, 4, 5, 9] {
            let x = uneven(count);
            let mut y: Vec<f64> = x.iter().map(|x| (3.0 * x).sin() - 0.2 * x * x).collect();
            y[count - 1] = y[0];
            let length = x[count - 1] - x[0];
            let many = |values: &[f64], step: f64| -> Vec<f64> {
                let period = |k: i32| values[1..].iter().map(move |v| v + step * f64::from(k));
                [values[0] - step * 20.0].into_iter().chain((-20..=20).flat_map(period)).collect()
            };
            let long = Spline::through(many(&x, length), many(&y, 0.0));
            let closed = Spline::through(x.clone(), y).closed().unwrap().lowered(0.5);
            for i in 0..=50 {
                let at = x[0] + length * f64::from(i) / 50.0;
                assert!((closed.evaluate(at) + 0.5 - long.evaluate(at)).abs() < 1e-11, "{count}");
                assert!((closed.slope(at) - long.slope(at)).abs() < 1e-10, "{count} at {at}");
            }
        }
        assert_eq!(Spline::through(vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 0.1]).closed(), None);
    }
}
