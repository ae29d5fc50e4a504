//! Kernels and pressures on cells.

use crate::{Error, special};

/// Beyond this many widths of the larger cell moments stand for the cells. Not a whole number: rounding must not decide for equal cells.
const FAR: f64 = 12.5;
/// As often an interval of slopes is halved: twice the digits of a number, as a slope may be no more than what rounding leaves of 1.
const HALVINGS: u32 = 2 * f64::MANTISSA_DIGITS;

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
    let cells: Vec<[f64; 2]> = boundaries.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let widths: Vec<f64> = cells.iter().map(|[left, right]| right - left).collect();
    Ok(galerkin(&widths, |i| mean_logarithms(&cells[..=i], cells[i])))
}

/// The Galerkin matrix `S_ij = (m_i m_j)^(1/2) mean_ij`, all entries, for the masses `m` of cells and the means of a symmetric kernel over each cell and those up to it.
pub fn galerkin(masses: &[f64], means: impl Fn(usize) -> Vec<f64>) -> Vec<f64> {
    let count = masses.len();
    let mut matrix = vec![0.0; count * count];
    for i in 0..count {
        for (j, mean) in means(i).into_iter().enumerate() {
            let entry = mean * (masses[i] * masses[j]).sqrt();
            matrix[i * count + j] = entry;
            matrix[j * count + i] = entry;
        }
    }
    matrix
}

/// Pressures on cells with these middles and masses that are positive and have their centre at a place between the first and the last middle: `e^(b (x - c))`, 1 at most.
#[must_use]
pub fn centred(middles: &[f64], masses: &[f64], centre: f64) -> Vec<f64> {
    let (Some(first), Some(last)) = (middles.first(), middles.last()) else { return Vec::new() };
    let density = |slope: f64| -> Vec<f64> {
        let highest = if slope < 0.0 { first } else { last };
        middles.iter().map(|x| (slope * (x - highest)).exp()).collect()
    };
    let excess = |slope: f64| -> f64 {
        let pressures = density(slope);
        let terms = pressures.iter().zip(masses).zip(middles);
        terms.map(|((p, mass), x)| p * mass * (x - centre)).sum()
    };
    let (mut low, mut high) = (-1.0, 1.0);
    // Beyond that all of it is in one cell.
    let steepest = 1.0 / f64::EPSILON;
    while excess(low) > 0.0 && low > -steepest {
        low *= 4.0;
    }
    while excess(high) < 0.0 && high < steepest {
        high *= 4.0;
    }
    for _ in 0..HALVINGS {
        let middle = low.midpoint(high);
        if excess(middle) < 0.0 { low = middle } else { high = middle }
    }
    density(low.midpoint(high))
}

/// The means of `ln 1/|x - s|` over `x` in one cell and `s` in each of others that are the same or lie left of it.
#[must_use]
pub fn mean_logarithms(lefts: &[[f64; 2]], right: [f64; 2]) -> Vec<f64> {
    let pairs: Vec<Pair> = lefts.iter().map(|left| Pair::new(*left, right)).collect();
    let mut logarithms = arguments(&pairs);
    special::logarithms(&mut logarithms);
    let mut logarithms = logarithms.iter().copied();
    pairs.iter().map(|pair| pair.mean_logarithm(&mut logarithms)).collect()
}

/// The means of `|x - s|^-mu` over `x` in one cell and `s` in each of others that are the same or lie left of it.
#[must_use]
pub fn mean_powers(lefts: &[[f64; 2]], right: [f64; 2], exponent: f64) -> Vec<f64> {
    let pairs: Vec<Pair> = lefts.iter().map(|left| Pair::new(*left, right)).collect();
    let mut powers = arguments(&pairs);
    special::powers(&mut powers, -exponent);
    let mut powers = powers.iter().copied();
    pairs.iter().map(|pair| pair.mean_power(exponent, &mut powers)).collect()
}

/// [`mean_logarithms`] of one pair.
pub(crate) fn mean_logarithm(left: [f64; 2], right: [f64; 2]) -> f64 {
    let pair = Pair::new(left, right);
    pair.mean_logarithm(&mut pair.arguments().map(f64::ln))
}

/// [`mean_powers`] of one pair.
pub(crate) fn mean_power(left: [f64; 2], right: [f64; 2], exponent: f64) -> f64 {
    let pair = Pair::new(left, right);
    pair.mean_power(exponent, &mut pair.arguments().map(|distance| distance.powf(-exponent)))
}

/// How two cells lie to each other.
enum Pair {
    /// They are the same, of this width.
    Same { width: f64 },
    /// Moments stand for them: the distance between the middles, and both widths over it.
    Far { distance: f64, widths: [f64; 2] },
    /// The same with the distances from the ends of one to those of the other over that, the farthest, the two between, the nearest.
    Near { distance: f64, widths: [f64; 2], ends: [f64; 4] },
}

impl Pair {
    fn new(left: [f64; 2], right: [f64; 2]) -> Self {
        let (h, k) = (left[1] - left[0], right[1] - right[0]);
        if left == right {
            return Self::Same { width: h };
        }
        // From the gap between the cells, which is exact for neighbours.
        let gap = (right[0] - left[1]).max(0.0);
        let distance = gap + 0.5 * (h + k);
        let widths = [h / distance, k / distance];
        if distance > FAR * h.max(k) {
            return Self::Far { distance, widths };
        }
        let ends = [gap + h + k, gap + h, gap + k, gap].map(|d| d / distance);
        Self::Near { distance, widths, ends }
    }

    /// Positive numbers whose logarithms or powers its mean consists of.
    fn arguments(&self) -> impl Iterator<Item = f64> + use<> {
        let (first, ends) = match *self {
            Self::Same { width } => (width, None),
            Self::Far { distance, .. } => (distance, None),
            Self::Near { distance, ends, .. } => (distance, Some(ends)),
        };
        let ends = ends.into_iter().flatten().map(|end: f64| end.max(f64::MIN_POSITIVE));
        std::iter::once(first).chain(ends)
    }

    /// From the logarithms of its arguments.
    fn mean_logarithm(&self, logarithms: &mut impl Iterator<Item = f64>) -> f64 {
        let mut next = || logarithms.next().unwrap_or(f64::NAN);
        let first = next();
        match self {
            Self::Same { .. } => 1.5 - first,
            Self::Far { widths, .. } => {
                // Moments of the difference of two places: without them the error of potentials would fall with the width of the cells only, not its square.
                let [h, k] = widths.map(|width| width * width);
                let (second, fourth) = ((h + k) / 12.0, (h * h + k * k) / 80.0 + h * k / 24.0);
                0.5 * second + 0.25 * fourth - first
            }
            Self::Near { widths: [h, k], ends, .. } => {
                // Second difference of G(d) = d^2/2 ln d - 3 d^2/4, G'' = ln d
                let [all, one, other, gap] = ends.map(|d| d * d * (0.5 * next() - 0.75));
                -((all - one - other + gap) / (h * k) + first)
            }
        }
    }

    /// From the powers `-mu` of its arguments.
    fn mean_power(&self, exponent: f64, powers: &mut impl Iterator<Item = f64>) -> f64 {
        let mut next = || powers.next().unwrap_or(f64::NAN);
        let first = next();
        let divisor = (1.0 - exponent) * (2.0 - exponent);
        match self {
            Self::Same { .. } => 2.0 * first / divisor,
            Self::Far { .. } => first,
            Self::Near { widths: [h, k], ends, .. } => {
                // Second difference of G(d) = d^(2-mu)/((1-mu)(2-mu)), G'' = d^-mu
                let [all, one, other, gap] = ends.map(|d| d * d * next());
                first * (all - one - other + gap) / (divisor * h * k)
            }
        }
    }
}

fn arguments(pairs: &[Pair]) -> Vec<f64> {
    pairs.iter().flat_map(Pair::arguments).collect()
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
    fn cells_side_by_side_have_the_means_of_each() {
        // Near and far ones, one of another width, the same.
        let ends = [-9.0, -3.0, -2.9, -0.4, -0.1, -0.09, 0.0, 0.3];
        let cells: Vec<[f64; 2]> = ends.windows(2).map(|pair| [pair[0], pair[1]]).collect();
        for right in [[0.0, 0.3], [0.4, 0.401]] {
            for (left, mean) in cells.iter().zip(mean_logarithms(&cells, right)) {
                let exact = mean_logarithm(*left, right);
                assert!((mean - exact).abs() < 1e-13, "{left:?}: {mean} {exact}");
            }
            for exponent in [0.1, 0.95] {
                for (left, mean) in cells.iter().zip(mean_powers(&cells, right, exponent)) {
                    let exact = mean_power(*left, right, exponent);
                    assert!((mean / exact - 1.0).abs() < 1e-12, "{left:?}: {mean} {exact}");
                }
            }
        }
        // In the middle of a cell the potential is that of its halves.
        let exact = 2.0 * 0.15f64.powf(0.5) / 0.5 / 0.3;
        let parts = (0..300).map(|i| [0.3 * f64::from(i) / 300.0, 0.3 * f64::from(i + 1) / 300.0]);
        let parts: Vec<[f64; 2]> = parts.collect();
        let left: f64 = mean_powers(&parts[..150], parts[149], 0.5).iter().sum();
        let own = mean_powers(&parts[149..150], parts[149], 0.5)[0];
        assert!(((2.0 * left - own) / 300.0 / exact - 1.0).abs() < 4e-3, "{left} {own} {exact}");
    }

    #[test]
    fn centred_pressures_have_their_centre() {
        let (middles, masses) = ([-0.9, -0.2, 0.1, 0.7], [0.1, 0.5, 0.2, 0.3]);
        for centre in [-0.89, -0.3, 0.13, 0.69] {
            let pressures = centred(&middles, &masses, centre);
            let sum = |power: i32| -> f64 {
                let cells = middles.iter().zip(&masses).zip(&pressures);
                cells.map(|((x, mass), p)| x.powi(power) * mass * p).sum()
            };
            assert!((sum(1) / sum(0) - centre).abs() < 1e-14, "{centre}: {pressures:?}");
            assert!(pressures.iter().all(|p| *p > 0.0 && *p <= 1.0), "{centre}: {pressures:?}");
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
