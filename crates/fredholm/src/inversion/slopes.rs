//! The slope of a base by polynomials where it is one to rounding: Abel's transforms ask for it in thousands of places, and a formula costs more than all else there.

use std::f64::consts::FRAC_PI_2;
use std::sync::{LazyLock, OnceLock};

use super::accuracy::OF_A_VALUE;
use crate::basis::chebyshev;

/// Nodes of a piece.
const NODES: usize = 24;
/// Towards the axis, where the slope vanishes and its own digits count, pieces are halved so often; nearer to it the base itself is asked.
const HALVINGS: i32 = 48;
/// So often they are halved where the slope is no polynomial: what is none then is left to the base.
const DEEPEST: u32 = 7;
/// Where a polynomial is compared with the slope, between the nodes.
const BETWEEN: [f64; 3] = [-0.93, 0.17, 0.77];

/// The rounding of a formula of many terms over that of a value (survey).
const MANY: f64 = 4.0;

/// Cosines of multiples of a quarter turn over the number of nodes.
static COSINES: LazyLock<[f64; 4 * NODES]> =
    LazyLock::new(|| std::array::from_fn(|m| (FRAC_PI_2 * m as f64 / NODES as f64).cos()));

/// Between places where the base may bend.
#[derive(Debug, Clone)]
pub struct Slopes {
    ends: Vec<f64>,
    /// The pieces between two ends, once the slope is asked for there.
    pieces: Vec<OnceLock<Vec<Piece>>>,
}

#[derive(Debug, Clone)]
struct Piece {
    ends: [f64; 2],
    /// None where the slope is not known by a polynomial.
    coefficients: Option<Vec<f64>>,
}

impl Slopes {
    /// Of a base that is smooth between these places.
    #[must_use]
    pub fn new(mut ends: Vec<f64>) -> Self {
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        let pieces = ends.windows(2).map(|_| OnceLock::new()).collect();
        Self { ends, pieces }
    }

    /// Ends of pieces towards the axis of a disk of the radius 1.
    pub fn towards_axis() -> impl Iterator<Item = f64> {
        (0..HALVINGS).map(|halving| 0.5f64.powi(halving))
    }

    /// The slope inside of a piece, of a base that tells its own; none where it is no polynomial.
    pub fn at(&self, xi: f64, slope: impl Fn(f64) -> f64) -> Option<f64> {
        let between = self.ends.partition_point(|end| *end <= xi).checked_sub(1)?;
        let ends = [self.ends[between], *self.ends.get(between + 1)?];
        let pieces = self.pieces[between].get_or_init(|| pieces(ends, slope));
        let index = pieces.partition_point(|piece| piece.ends[1] <= xi);
        let Piece { ends: [from, to], coefficients } = pieces.get(index)?;
        let coefficients = coefficients.as_ref().filter(|_| *from < xi)?;
        Some(chebyshev::sum(coefficients, ((xi - from) - (to - xi)) / (to - from)))
    }
}

/// Between two places, halved where the slope is no polynomial.
fn pieces(ends: [f64; 2], slope: impl Fn(f64) -> f64) -> Vec<Piece> {
    let (mut stack, mut pieces) = (vec![(ends, 0)], Vec::new());
    while let Some(([from, to], depth)) = stack.pop() {
        let coefficients = resolved([from, to], &slope);
        let middle = 0.5 * (from + to);
        if coefficients.is_some() || depth == DEEPEST || middle <= from || middle >= to {
            pieces.push(Piece { ends: [from, to], coefficients });
        } else {
            stack.extend([([middle, to], depth + 1), ([from, middle], depth + 1)]);
        }
    }
    pieces
}

/// Chebyshev coefficients of a function, if it is their sum to rounding.
fn resolved([from, to]: [f64; 2], f: &impl Fn(f64) -> f64) -> Option<Vec<f64>> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let cosines = &*COSINES;
    let cosine = |m: usize| cosines[m % (4 * NODES)];
    let values: Vec<f64> = (0..NODES).map(|q| f(middle + half * cosine(2 * q + 1))).collect();
    let largest = values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let coefficient = |k: usize| {
        let terms = values.iter().enumerate().map(|(q, value)| value * cosine((2 * q + 1) * k));
        terms.sum::<f64>() * if k == 0 { 1.0 } else { 2.0 } / NODES as f64
    };
    // Most of what is no polynomial shows at once.
    let rounding = OF_A_VALUE * largest;
    if [1, 2].iter().any(|k| coefficient(NODES - k).abs() > rounding) || !largest.is_finite() {
        return None;
    }
    let mut coefficients: Vec<f64> = (0..NODES).map(coefficient).collect();
    // The last that add up to no more than rounding: of a simple formula all but a few.
    let mut dropped = 0.0;
    while let Some(last) = coefficients.last() {
        dropped += last.abs();
        if dropped > rounding {
            break;
        }
        coefficients.pop();
    }
    let is_met = |t: &f64| {
        let off = f(middle + half * t) - chebyshev::sum(&coefficients, *t);
        // A formula of many terms rounds as much.
        off.abs() <= MANY * rounding
    };
    BETWEEN.iter().all(is_met).then_some(coefficients)
}

/// Nodes that show whether a function is a polynomial of low degree, of whose Chebyshev coefficients the last vanish.
const LOW: usize = 12;
const LAST: usize = 3;
/// Pieces are halved no more once there are so many, a thousand waves, and so often, where a slope is infinite.
const MOST_PIECES: usize = 2048;
const MOST_HALVINGS: usize = 24;

/// The Chebyshev nodes, and the last Chebyshev polynomials there.
static LOW_NODES: LazyLock<[f64; LOW]> = LazyLock::new(|| low_cosines(1));
static LAST_COSINES: LazyLock<[[f64; LOW]; LAST]> =
    LazyLock::new(|| std::array::from_fn(|k| low_cosines(LOW - LAST + k)));

fn low_cosines(degree: usize) -> [f64; LOW] {
    std::array::from_fn(|q| (FRAC_PI_2 * ((2 * q + 1) * degree) as f64 / LOW as f64).cos())
}

/// Ends of pieces on each of which a function, given at many places at a time, is a polynomial of low degree but for a share of its largest value, between places where it may bend: it has two waves
/// there at most, and a few places show them, however small they are beside the rest of it.
#[must_use]
pub fn few_waves(ends: &[f64], f: impl Fn(&[f64]) -> Vec<f64>, share: f64) -> Vec<f64> {
    let of = |pieces: Vec<[f64; 2]>| -> Vec<([f64; 2], [f64; LOW])> {
        let nodes = pieces.iter().flat_map(|[from, to]| {
            let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
            LOW_NODES.iter().map(move |node| middle + half * node)
        });
        let values = f(&nodes.collect::<Vec<_>>());
        pieces.into_iter().zip(values.as_chunks().0.iter().copied()).collect()
    };
    let mut pieces = of(ends.windows(2).map(|pair| [pair[0], pair[1]]).collect());
    let mut known = ends.to_vec();
    let mut largest = 0.0f64;
    for _ in 0..MOST_HALVINGS {
        let sizes = pieces.iter().flat_map(|(_, values)| values).map(|value| value.abs());
        largest = sizes.filter(|size| size.is_finite()).fold(largest, f64::max);
        pieces.retain(|(_, values)| !is_low(values, share * largest));
        if pieces.is_empty() || known.len() + pieces.len() > MOST_PIECES {
            break;
        }
        let halves = pieces.iter().flat_map(|([from, to], _)| {
            let middle = from.midpoint(*to);
            [[*from, middle], [middle, *to]]
        });
        known.extend(pieces.iter().map(|([from, to], _)| from.midpoint(*to)));
        pieces = of(halves.collect());
    }
    known.sort_by(f64::total_cmp);
    known.dedup();
    known
}

/// Whether the last coefficients of the polynomial through values at Chebyshev nodes vanish.
fn is_low(values: &[f64; LOW], none: f64) -> bool {
    let last = LAST_COSINES.iter().map(|cosines| {
        let terms = values.iter().zip(cosines).map(|(value, cosine)| value * cosine);
        terms.sum::<f64>().abs() * 2.0 / LOW as f64
    });
    last.fold(0.0, f64::max) <= none
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn marked(ends: &[f64], f: impl Fn(f64) -> f64) -> Vec<f64> {
        few_waves(ends, |places| places.iter().map(|x| f(*x)).collect(), 1e-8)
    }

    #[test]
    fn small_waves_are_shown_wherever_they_are() {
        for (size, wave) in [(1.0, 3.0), (1e-3, 40.0), (1e-6, 271.3), (1e-5, 900.0)] {
            let ends = marked(&[-1.0, 0.2, 1.0], |x| x + size * (wave * x).cos());
            assert!(ends.contains(&0.2) && ends[0] == -1.0 && ends[ends.len() - 1] == 1.0);
            let longest = ends.windows(2).fold(0.0f64, |most, pair| most.max(pair[1] - pair[0]));
            assert!(longest * wave < 2.5 * 2.0 * PI, "{size} {wave}: {longest}");
            assert!(ends.len() < 40 + 2 * wave as usize, "{wave}: {}", ends.len());
        }
        // What is smooth is one piece, what is steep somewhere is halved there alone, and noise ends.
        assert_eq!(marked(&[0.0, 1.0], |x| x.powi(5)), [0.0, 1.0]);
        assert!(marked(&[0.0, 1.0], |x| x.sqrt().recip()).len() < 60);
        assert!(marked(&[0.0, 1.0], |x| (1e30 * x).sin()).len() <= MOST_PIECES);
    }

    #[test]
    fn slopes_are_those_of_the_base_to_rounding_and_kinks_are_not_passed() {
        let slope = |r: f64| {
            let wave: f64 = (1..18).map(|k| (f64::from(k) * PI * r).sin() / f64::from(k)).sum();
            wave + if r > 0.3 { 1.0 } else { 0.0 }
        };
        let ends = |bend: Option<f64>| Slopes::towards_axis().chain(bend).collect();
        let slopes = Slopes::new(ends(Some(0.3)));
        let mut known = 0;
        for i in 1..=5000 {
            let r = f64::from(i) / 5000.7;
            let Some(found) = slopes.at(r, slope) else { continue };
            known += 1;
            // Of the largest slope on a piece, which is about ten times as long as the wave.
            assert!((found - slope(r)).abs() < 8e-15, "{r}: {found} {}", slope(r));
        }
        assert!(known > 4900, "{known}");
        // A jump that is not told is left to the base.
        let hidden = Slopes::new(ends(None));
        for i in 1..=1000 {
            let r = 0.3 + 1e-4 * (f64::from(i) / 500.0 - 1.0);
            let found = hidden.at(r, slope).unwrap_or_else(|| slope(r));
            assert!((found - slope(r)).abs() < 8e-15, "{r}");
        }
    }
}
