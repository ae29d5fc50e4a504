//! The lowest eigenvalues of a symmetric tridiagonal matrix with their eigenvectors.

use crate::Error;

/// Most steps of the iteration for one eigenvalue; it converges cubically.
const STEPS: usize = 12;
/// Corrections below this share of the terms of the quotient of Rayleigh are rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Most bisections for one eigenvalue: they exhaust the digits.
const BISECTIONS: usize = 120;

/// The lowest eigenvalues, ascending, and their eigenvectors of length 1, one after the other.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lowest {
    pub(crate) values: Vec<f64>,
    pub(crate) vectors: Vec<f64>,
}

/// The symmetric matrix `T_ii = diagonal[i]`, `T_{i,i+1} = off[i]`.
struct Matrix<'m> {
    diagonal: &'m [f64],
    off: &'m [f64],
    /// What replaces a pivot that vanishes.
    tiny: f64,
}

/// The `count` lowest eigenvalues of a matrix whose lowest eigenvalues are apart.
///
/// Each is enclosed by bisection with counts of negative pivots, then improved, together with its vector, by the quotient of Rayleigh from a factorisation twisted at the
/// row where the vector is large (I. S. Dhillon and B. N. Parlett, Linear Algebra Appl. 387 (2004) 1). Unlike a dense method it keeps the digits of small
/// eigenvalues, and of small components of vectors, where the diagonal grows towards its end. Cost: about `30 count order` divisions.
///
/// # Errors
/// [`Error::EigenvaluesNotFound`] when entries are not finite or `count` exceeds the order.
pub(crate) fn lowest(diagonal: &[f64], off: &[f64], count: usize) -> Result<Lowest, Error> {
    let order = diagonal.len();
    let failed = || Error::EigenvaluesNotFound { order };
    if count > order || off.len() + 1 < order {
        return Err(failed());
    }
    let bounds = gershgorin(diagonal, off).ok_or_else(failed)?;
    let size = bounds[0].abs().max(bounds[1].abs());
    let tiny = (size * f64::EPSILON * f64::EPSILON).max(f64::MIN_POSITIVE);
    let matrix = Matrix { diagonal, off, tiny };
    // One more than asked for: the last must be told from its neighbour too.
    let enclosed = order.min(count + 1);
    let (mut below, mut above) = (vec![bounds[0]; enclosed], vec![bounds[1]; enclosed]);
    let mut vectors = vec![0.0; count * order];
    let mut values = Vec::with_capacity(count);
    for (index, vector) in vectors.chunks_exact_mut(order.max(1)).enumerate() {
        values.push(matrix.eigenpair(index, &mut below, &mut above, vector).ok_or_else(failed)?);
    }
    Ok(Lowest { values, vectors })
}

/// Bounds of all eigenvalues, a little wide; `None` unless finite.
fn gershgorin(diagonal: &[f64], off: &[f64]) -> Option<[f64; 2]> {
    let mut bounds = [f64::INFINITY, f64::NEG_INFINITY];
    for (i, d) in diagonal.iter().enumerate() {
        let left = if i > 0 { off[i - 1].abs() } else { 0.0 };
        let right = off.get(i).map_or(0.0, |e| e.abs());
        let radius = left + right;
        if !(d.is_finite() && radius.is_finite()) {
            return None;
        }
        bounds = [bounds[0].min(d - radius), bounds[1].max(d + radius)];
    }
    let margin = 1e-12 * (bounds[0].abs() + bounds[1].abs()) + f64::MIN_POSITIVE;
    Some([bounds[0] - margin, bounds[1] + margin])
}

impl Matrix<'_> {
    /// Finds one eigenvalue inside its bounds, which every count sharpens for all that follow.
    fn eigenpair(
        &self,
        index: usize,
        below: &mut [f64],
        above: &mut [f64],
        vector: &mut [f64],
    ) -> Option<f64> {
        let mut alone = false;
        for _ in 0..BISECTIONS {
            let (low, high) = (below[index], above[index]);
            let middle = 0.5 * low + 0.5 * high;
            if middle <= low || middle >= high {
                break;
            }
            if alone {
                let found = self.iterate(middle, vector).filter(|v| *v >= low && *v <= high);
                if found.is_some() {
                    return found;
                }
            }
            let smaller = self.count_below(middle);
            for (k, (low, high)) in below.iter_mut().zip(above.iter_mut()).enumerate() {
                if k < smaller {
                    *high = high.min(middle);
                } else {
                    *low = low.max(middle);
                }
            }
            // A neighbour's bounds end where these begin: none but this eigenvalue is between them.
            let after = below.get(index + 1).is_none_or(|next| *next >= above[index]);
            let before = index == 0 || above[index - 1] <= below[index];
            alone = before && after;
        }
        // The bounds have met.
        let value = 0.5 * below[index] + 0.5 * above[index];
        Some(value + self.twisted(value, vector)).filter(|value| value.is_finite())
    }

    fn guarded(&self, pivot: f64) -> f64 {
        if pivot.abs() < self.tiny { self.tiny.copysign(pivot) } else { pivot }
    }

    /// How many eigenvalues are below `x`.
    fn count_below(&self, x: f64) -> usize {
        let mut count = 0;
        let (mut pivot, mut coupling) = (1.0, 0.0);
        for (i, d) in self.diagonal.iter().enumerate() {
            pivot = self.guarded(d - x - coupling * coupling / pivot);
            count += usize::from(pivot < 0.0);
            coupling = self.off.get(i).copied().unwrap_or(0.0);
        }
        count
    }

    /// The iteration with the quotient of Rayleigh from a shift; fills the vector. `None` where it does not settle.
    fn iterate(&self, shift: f64, vector: &mut [f64]) -> Option<f64> {
        let mut value = shift;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let correction = self.twisted(value, vector);
            value += correction;
            let size = correction.abs();
            if size <= f64::EPSILON * value.abs() {
                return Some(value);
            }
            // What the terms of the quotient carry in rounding.
            let terms = vector.iter().zip(self.diagonal).map(|(z, d)| z * z * d.abs());
            let rounding = ROUNDING * terms.sum::<f64>();
            if size <= rounding && size >= 0.5 * last {
                return Some(value);
            }
            last = size;
        }
        None
    }

    /// The vector of the twisted factorisation at the shift `x`, normalised, and the quotient of Rayleigh less the shift.
    fn twisted(&self, x: f64, vector: &mut [f64]) -> f64 {
        let order = self.diagonal.len();
        let (mut down, mut up) = (vec![0.0; order], vec![0.0; order]);
        for i in 0..order {
            let before = if i > 0 { self.off[i - 1] * self.off[i - 1] / down[i - 1] } else { 0.0 };
            down[i] = self.guarded(self.diagonal[i] - x - before);
        }
        for i in (0..order).rev() {
            let after = if i + 1 < order { self.off[i] * self.off[i] / up[i + 1] } else { 0.0 };
            up[i] = self.guarded(self.diagonal[i] - x - after);
        }
        let rest = |i: usize| down[i] + up[i] - (self.diagonal[i] - x);
        let twist = (0..order).min_by(|&i, &j| rest(i).abs().total_cmp(&rest(j).abs()));
        let twist = twist.unwrap_or(0);
        vector[twist] = 1.0;
        for i in (0..twist).rev() {
            vector[i] = -self.off[i] * vector[i + 1] / down[i];
        }
        for i in twist + 1..order {
            vector[i] = -self.off[i - 1] * vector[i - 1] / up[i];
        }
        let square: f64 = vector.iter().map(|z| z * z).sum();
        let scale = 1.0 / square.sqrt();
        vector.iter_mut().for_each(|z| *z *= scale);
        rest(twist) / square
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_sines_of_the_second_difference() {
        let order = 200;
        let (diagonal, off) = (vec![2.0; order], vec![-1.0; order - 1]);
        let found = lowest(&diagonal, &off, 60).unwrap();
        for (k, value) in found.values.iter().enumerate() {
            let angle = std::f64::consts::PI * (k as f64 + 1.0) / (order as f64 + 1.0);
            assert!((value - 2.0 * (1.0 - angle.cos())).abs() < 1e-14);
            let scale = (2.0 / (order as f64 + 1.0)).sqrt();
            let vector = &found.vectors[k * order..(k + 1) * order];
            let sign = vector[0].signum();
            for (i, z) in vector.iter().enumerate() {
                let exact = scale * (angle * (i as f64 + 1.0)).sin();
                // The gap of the lowest two is 7e-4.
                assert!((sign * z - exact).abs() < 2e-12, "{k} {i}: {z} {exact}");
            }
        }
    }

    #[test]
    fn small_eigenvalues_of_a_graded_matrix_keep_their_digits() {
        // The recessive solution of a three-term recurrence: the oscillator x^2 + p^2 in the basis of p^2 + w x^2 has the eigenvalues 1, 5, 9, ...
        // p^2 = (w/2)(2j + 1 - raising), x^2 = (1/(2w))(2j + 1 + raising), even states.
        let w = 3.0f64;
        let (p, x) = (0.5 * w, 0.5 / w);
        let entry = |k: usize| 2.0 * k as f64;
        let diagonal: Vec<f64> = (0..400).map(|k| (p + x) * (2.0 * entry(k) + 1.0)).collect();
        let off: Vec<f64> =
            (0..399).map(|k| (x - p) * ((entry(k) + 1.0) * (entry(k) + 2.0)).sqrt()).collect();
        let found = lowest(&diagonal, &off, 20).unwrap();
        for (k, value) in found.values.iter().enumerate() {
            let exact = 4.0 * k as f64 + 1.0;
            assert!((value / exact - 1.0).abs() < 1e-13, "{k}: {value}");
        }
    }

    #[test]
    fn diagonal_matrices_and_hostile_ones() {
        let found = lowest(&[3.0, 1.0, 2.0], &[0.0, 0.0], 2).unwrap();
        assert!((found.values[0] - 1.0).abs() < 1e-15 && (found.values[1] - 2.0).abs() < 1e-15);
        assert!((found.vectors[1].abs() - 1.0).abs() < 1e-15);
        assert!(lowest(&[1.0, f64::NAN], &[0.0], 1).is_err());
        assert!(lowest(&[1.0, 2.0], &[f64::INFINITY], 1).is_err());
        assert!(lowest(&[1.0], &[], 2).is_err());
        assert_eq!(lowest(&[], &[], 0).unwrap().values, Vec::<f64>::new());
    }
}
