//! Densities as cosines of the angle of a zone, and the symmetric system that couples those of several zones.
//!
//! On a zone the pressure is `G(phi)` over `sin phi` and powers, `G = sum gamma_k cos(k phi)`; what comes from elsewhere is smooth there, so a few modes are coupled to those of the others.

use std::f64::consts::{FRAC_PI_2, PI};

use super::equation::{COARSE, FINE};
use crate::Error;
use crate::contact::search::COARSELY_ALLOWED;
use crate::contact::zones::Zone;

/// Most modes of a zone, and of all together. Half and twice change none of 32 answers (survey).
const MOST_OF_A_ZONE: f64 = 800.0;
const MOST_MODES: usize = 4000;
/// Angle at which the slope of a density over `cos phi` is taken at an end first; the others are twice to sixteen times that. At half or twice 23 of 32 answers change, within what they state (survey).
const BESIDE: f64 = 0.01;

/// Modes by zones.
pub(super) type Modes = Vec<Vec<f64>>;

/// The Chebyshev nodes of a zone.
#[derive(Debug, Clone)]
pub(super) struct Nodes {
    pub(super) angles: Vec<f64>,
    /// `cos(k phi_q)`, node by node.
    cosines: Vec<f64>,
}

impl Nodes {
    pub(super) fn new(count: usize) -> Self {
        let turn = |q: usize| PI * (q as f64 + 0.5) / count as f64;
        let angles: Vec<f64> = (0..count).map(turn).collect();
        // All of them are cosines of multiples of a quarter turn over the count.
        let table: Vec<f64> =
            (0..4 * count).map(|m| (FRAC_PI_2 * m as f64 / count as f64).cos()).collect();
        let cosine = |q: usize, k: usize| table[(2 * q + 1) * k % (4 * count)];
        let cosines = (0..count).flat_map(|q| (0..count).map(move |k| (q, k)));
        let cosines = cosines.map(|(q, k)| cosine(q, k)).collect();
        Self { angles, cosines }
    }

    pub(super) fn count(&self) -> usize {
        self.angles.len()
    }

    /// `pi/n`, the weight of a node in integrals over the angle.
    pub(super) fn weight(&self) -> f64 {
        PI / self.count() as f64
    }

    fn rows(&self) -> impl Iterator<Item = &[f64]> {
        self.cosines.chunks_exact(self.count().max(1))
    }

    /// The values of modes at the nodes.
    pub(super) fn values(&self, modes: &[f64]) -> Vec<f64> {
        self.rows().map(|row| row.iter().zip(modes).map(|(c, mode)| c * mode).sum()).collect()
    }

    /// `sum_q v_q cos(k phi_q)`.
    pub(super) fn transposed(&self, values: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.count()];
        for (row, value) in self.rows().zip(values) {
            sums.iter_mut().zip(row).for_each(|(sum, c)| *sum += value * c);
        }
        sums
    }

    /// The modes of the polynomial through values at the nodes.
    pub(super) fn modes(&self, values: &[f64]) -> Vec<f64> {
        let sums = self.transposed(values).into_iter().enumerate();
        sums.map(|(k, sum)| sum * self.weight() / norm(k)).collect()
    }

    /// The same of each column of values, row by row for the nodes; modes row by row.
    pub(super) fn projected(&self, values: &[f64]) -> Vec<f64> {
        let columns = values.len() / self.count().max(1);
        let mut modes = vec![0.0; values.len()];
        for (row, values) in self.rows().zip(values.chunks_exact(columns.max(1))) {
            for (m, sums) in modes.chunks_exact_mut(columns.max(1)).enumerate() {
                let weight = row[m] * self.weight() / norm(m);
                sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        modes
    }
}

/// Number of modes of a zone of which each digit takes so many: where zones are close all digits take more than can be had, and every detail gets the same share of its own, so that comparing two of
/// them still tells the error. None where these are fewer than zones are looked for with.
pub(super) fn count(each: f64, digits: f64) -> Option<usize> {
    let share = (MOST_OF_A_ZONE / (FINE.digits * each)).min(1.0);
    let is_enough = share * FINE.digits >= COARSE.digits;
    is_enough.then(|| (share * digits * each).ceil() as usize + 3)
}

/// Refuses more modes than can be coupled; `gap` is the narrowest between zones.
pub(super) fn require_few(counts: &[usize], gap: impl FnOnce() -> f64) -> Result<(), Error> {
    if counts.iter().sum::<usize>() > MOST_MODES {
        return Err(Error::ZonesTooClose { gap: gap().max(0.0), roughness: None });
    }
    Ok(())
}

/// `int cos^2(k phi) dphi` over a half turn.
pub(super) fn norm(k: usize) -> f64 {
    if k == 0 { PI } else { FRAC_PI_2 }
}

/// With this scale of the modes the diagonal is about 1.
fn scale(k: usize) -> f64 {
    if k == 0 { 1.0 / PI } else { (2.0 * k as f64).sqrt() / PI }
}

/// Densities whose displacements have given modes, zone by zone. `block` has the modes on a target of the displacement by each mode of a source that is the same zone or lies right of it, row by row.
///
/// # Errors
/// [`Error::Equation`] unless the system is positive; those of the blocks.
pub(super) fn coupled(
    counts: &[usize],
    block: impl Fn(usize, usize) -> Result<Vec<f64>, Error>,
    rights: &[Modes],
) -> Result<Vec<Modes>, Error> {
    let mut offsets = vec![0];
    counts.iter().for_each(|count| offsets.push(offsets[offsets.len() - 1] + count));
    let order = offsets[counts.len()];
    let mut matrix = vec![0.0; order * order];
    for target in 0..counts.len() {
        for source in target..counts.len() {
            let block = block(target, source)?;
            for (m, row) in block.chunks_exact(counts[source]).enumerate() {
                let factor = scale(m) * norm(m);
                for (n, value) in row.iter().enumerate() {
                    let place = (offsets[source] + n) * order + offsets[target] + m;
                    matrix[place] = factor * value * scale(n);
                }
            }
        }
    }
    let scaled = |right: &Modes| -> Vec<f64> {
        let zones = right.iter().zip(counts);
        let modes = zones.flat_map(|(modes, count)| modes.iter().take(*count).enumerate());
        modes.map(|(k, f)| scale(k) * norm(k) * f).collect()
    };
    let mut found: Vec<Vec<f64>> = rights.iter().map(scaled).collect();
    fredholm::eliminate_positive(&matrix, &mut found)?;
    let split = |all: &Vec<f64>| -> Modes {
        let zone = |pair: &[usize]| all[pair[0]..pair[1]].iter().enumerate();
        offsets.windows(2).map(|pair| zone(pair).map(|(k, z)| z * scale(k)).collect()).collect()
    };
    Ok(found.iter().map(split).collect())
}

/// `sum c_k cos(k phi)`.
pub(super) fn cosines(coefficients: &[f64], angle: f64) -> f64 {
    fredholm::basis::chebyshev::sum(coefficients, angle.cos())
}

/// What `d^2 G/dphi^2` is at the end `phi = 0` or `pi` of a density known to a `rounding`, with its error: the slope over `-cos phi` outwards. A bend of the base close by asks for small angles, the profile
/// being smooth as far as `reach`, modes that were left out and rounding for large ones: of series of three angles each that one is taken that is known best.
pub(super) fn bend(
    density: impl Fn(f64) -> f64,
    end: f64,
    [reach, rounding]: [f64; 2],
) -> [f64; 2] {
    let at_end = density(end);
    let at = |angle: f64| 2.0 * (density((end - angle).abs()) - at_end) / (angle * angle);
    let (farthest, mut values) = (16.0 * BESIDE, [f64::NAN; 3]);
    let (mut angle, nearest) = (farthest, BESIDE.min(reach * BESIDE / farthest));
    let mut best = [f64::NAN, f64::INFINITY];
    while angle >= nearest {
        values = [values[1], values[2], at(angle)];
        let [four, two, one] = values;
        let (fine, coarse) = ((4.0 * one - two) / 3.0, (4.0 * two - four) / 3.0);
        let bend = (16.0 * fine - coarse) / 15.0;
        let error = (bend - fine).abs() + 4.0 * rounding / (angle * angle);
        if error * best[0].abs() < best[1] * bend.abs() || best[0].is_nan() {
            best = [bend, error];
        }
        angle *= 0.5;
    }
    best
}

/// The same for Newton's method, of a series cut off after so many modes whose last ones are not small: from angles at which these say nothing.
pub(super) fn bend_of_cut(density: impl Fn(f64) -> f64, end: f64, count: usize) -> f64 {
    // One wave of the last mode.
    let beside = BESIDE.max(2.0 * PI / count as f64);
    let at = |offset: f64| 2.0 * (density((end - offset).abs()) - density(end)) / (offset * offset);
    (4.0 * at(beside) - at(2.0 * beside)) / 3.0
}

/// What is left of a density at free ends where it was made to vanish, given its size: more was not.
pub(super) fn left_over(zone: &Zone, density: impl Fn(usize) -> f64, size: f64) -> [f64; 2] {
    let left = |side: usize| if zone.is_free(side) { density(side) } else { 0.0 };
    [0, 1].map(left).map(|left| if left.abs() <= COARSELY_ALLOWED * size { left } else { 0.0 })
}
