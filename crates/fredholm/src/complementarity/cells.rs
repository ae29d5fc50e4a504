//! The logarithm on cells.

use crate::Error;

/// Beyond this many widths of the larger cell moments stand for the cells. Not a whole number: rounding must not decide for equal cells.
const FAR: f64 = 12.5;

/// The Galerkin matrix of `ln 1/|x - s|` for functions that are constant on cells, all entries:
/// `S_ij = (h_i h_j)^(-1/2) int_i int_j ln 1/|x - s| ds dx`.
///
/// Symmetric, and positive while all cells lie in an interval of length at most 4.
///
/// # Errors
/// [`Error::InvalidParameter`] unless the boundaries are finite and increase, [`Error::WrongLength`] for fewer than two.
pub fn logarithm_cells(boundaries: &[f64]) -> Result<Vec<f64>, Error> {
    if boundaries.len() < 2 {
        let found = boundaries.len();
        return Err(Error::WrongLength { what: "list of boundaries", found, expected: 2 });
    }
    for pair in boundaries.windows(2) {
        let increase = pair[1] - pair[0];
        if !(increase > 0.0 && increase.is_finite()) {
            return Err(Error::InvalidParameter {
                name: "boundary of a cell",
                value: pair[1],
                requirement: "finite and right of the one before",
            });
        }
    }
    let count = boundaries.len() - 1;
    let cell = |i: usize| [boundaries[i], boundaries[i + 1]];
    let mut matrix = vec![0.0; count * count];
    for i in 0..count {
        for j in 0..=i {
            let entry = mean_logarithm(cell(j), cell(i));
            let [hi, hj] = [i, j].map(|k| boundaries[k + 1] - boundaries[k]);
            let entry = entry * (hi * hj).sqrt();
            matrix[i * count + j] = entry;
            matrix[j * count + i] = entry;
        }
    }
    Ok(matrix)
}

/// The mean of `ln 1/|x - s|` over `x` in one cell and `s` in another that is the same or lies left of it.
#[must_use]
pub fn mean_logarithm(left: [f64; 2], right: [f64; 2]) -> f64 {
    let (h, k) = (left[1] - left[0], right[1] - right[0]);
    if left == right {
        return 1.5 - h.ln();
    }
    // From the gap between the cells, which is exact for neighbours.
    let gap = (right[0] - left[1]).max(0.0);
    let distance = gap + 0.5 * (h + k);
    if distance > FAR * h.max(k) {
        // Moments of the difference of two places: without them the error of potentials would fall with the width of the cells only, not its square.
        let [h, k] = [h, k].map(|width| (width / distance).powi(2));
        let (second, fourth) = ((h + k) / 12.0, (h * h + k * k) / 80.0 + h * k / 24.0);
        return 0.5 * second + 0.25 * fourth - distance.ln();
    }
    // Second difference of G(d) = d^2/2 ln d - 3 d^2/4, G'' = ln d
    let g = |d: f64| if d > 0.0 { d * d * (0.5 * (d / distance).ln() - 0.75) } else { 0.0 };
    let sum = g(gap + h + k) - g(gap + h) - g(gap + k) + g(gap);
    -(sum / (h * k) + distance.ln())
}

/// The mean of `|x - s|^-mu` over `x` in one cell and `s` in another that is the same or lies left of it.
#[must_use]
pub fn mean_power(left: [f64; 2], right: [f64; 2], exponent: f64) -> f64 {
    let (h, k) = (left[1] - left[0], right[1] - right[0]);
    let divisor = (1.0 - exponent) * (2.0 - exponent);
    if left == right {
        return 2.0 * h.powf(-exponent) / divisor;
    }
    let gap = (right[0] - left[1]).max(0.0);
    let distance = gap + 0.5 * (h + k);
    if distance > FAR * h.max(k) {
        return distance.powf(-exponent);
    }
    // Second difference of G(d) = d^(2-mu)/((1-mu)(2-mu)), G'' = d^-mu
    let g = |d: f64| d.powf(2.0 - exponent);
    (g(gap + h + k) - g(gap + h) - g(gap + k) + g(gap)) / (divisor * h * k)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::double_exponential;

    #[test]
    fn means_agree_with_quadrature() {
        // The inner integral in closed form, the outer by panels that close in on the ends.
        let inner = |x: f64, [a, b]: [f64; 2]| {
            let f = |d: f64| if d == 0.0 { 0.0 } else { d * (1.0 - d.abs().ln()) };
            (f(x - a) - f(x - b)) / (b - a)
        };
        for (left, right) in [
            ([0.0, 0.1], [0.1, 0.2]),
            ([0.0, 0.1], [0.1, 0.1003]),
            ([-1.0, -0.9], [0.3, 0.32]),
            ([0.2, 0.7], [0.2, 0.7]),
            ([0.2, 0.7], [0.8, 1.0]),
        ] {
            let (middle, half) = (0.5 * (right[0] + right[1]), 0.5 * (right[1] - right[0]));
            let exact: f64 = double_exponential(60)
                .map(|node| 0.5 * node.weight * inner(middle + half * node.position, left))
                .sum();
            let found = mean_logarithm(left, right);
            let tolerance = if right[0] - left[1] > 1.0 { 1e-9 } else { 1e-12 };
            assert!((found - exact).abs() < tolerance, "{left:?} {right:?}: {found} {exact}");
        }
    }

    #[test]
    fn refuses_cells_without_width() {
        assert!(logarithm_cells(&[0.0]).is_err());
        assert!(logarithm_cells(&[0.0, 0.0]).is_err());
        assert!(logarithm_cells(&[0.0, f64::NAN]).is_err());
        assert!(logarithm_cells(&[0.0, f64::INFINITY]).is_err());
    }
}
