//! What rings do to themselves and to one another: the coupled modes.
//!
//! On a ring `ln r = m + l cos phi` the pressure is `p0 = G(phi)/(theta0 l r^(3/2) sin phi)`, `G = sum gamma_k cos(k phi)`, and the displacement times `sqrt(r)`
//! is `int (Q - H) G dphi` over all rings.

use std::f64::consts::{FRAC_PI_2, LN_2, PI};

use fredholm::inversion::RingKernel;

use super::ring::{Ring, Spot, along, distance};
use crate::Error;
use crate::contact::smooth::coupling::{MOST_MODES, add, share};

/// The Chebyshev nodes of a ring.
#[derive(Debug, Clone)]
pub(super) struct Nodes {
    pub(super) ring: Ring,
    pub(super) angles: Vec<f64>,
    pub(super) spots: Vec<Spot>,
    /// `cos(k phi_q)`, node by node.
    cosines: Vec<f64>,
}

impl Nodes {
    pub(super) fn new(ring: Ring, count: usize) -> Self {
        let turn = |q: usize| PI * (q as f64 + 0.5) / count as f64;
        let angles: Vec<f64> = (0..count).map(turn).collect();
        let spots = angles.iter().map(|angle| ring.spot(*angle)).collect();
        let cosines =
            angles.iter().flat_map(|a| (0..count).map(move |k| (k as f64 * a).cos())).collect();
        Self { ring, angles, spots, cosines }
    }

    pub(super) fn count(&self) -> usize {
        self.angles.len()
    }

    /// `pi/n`.
    pub(super) fn weight(&self) -> f64 {
        PI / self.count() as f64
    }

    /// Coefficients of `cos(k phi)` of the polynomial through values at the nodes.
    pub(super) fn modes(&self, values: &[f64]) -> Vec<f64> {
        let count = self.count();
        let mut modes = vec![0.0; count];
        for (q, value) in values.iter().enumerate() {
            let cosines = &self.cosines[q * count..(q + 1) * count];
            modes.iter_mut().zip(cosines).for_each(|(mode, c)| *mode += value * c);
        }
        for (k, mode) in modes.iter_mut().enumerate() {
            *mode *= self.weight() / norm(k);
        }
        modes
    }

    /// The values at the nodes.
    pub(super) fn values(&self, modes: &[f64]) -> Vec<f64> {
        let rows = self.cosines.chunks_exact(self.count());
        rows.map(|row| row.iter().zip(modes).map(|(c, mode)| c * mode).sum()).collect()
    }

    /// A place of the ring with its distance from a disk of radius `c`.
    pub(super) fn beside(&self, q: usize, c: f64) -> [f64; 2] {
        let spot = &self.spots[q];
        [spot.radius, self.ring.inner() - c + spot.from_inner]
    }
}

/// Number of modes for each ring: kernels end at `y = i pi`, and the field of what lies nearest is a series that falls as `rho^-k`, `rho` set by the distance. Where rings are close all
/// digits take more modes than can be had, and every detail gets the same share of its own, as in plane contact.
pub(super) fn modes(c: f64, rings: &[Ring], digits: f64) -> Result<Vec<usize>, Error> {
    let mut counts = Vec::with_capacity(rings.len());
    for (j, ring) in rings.iter().enumerate() {
        let from = if j == 0 { c } else { rings[j - 1].outer() };
        let before = if from > 0.0 { distance(from, ring.inner() - from) } else { f64::INFINITY };
        let after = rings
            .get(j + 1)
            .map_or(f64::INFINITY, |next| distance(ring.outer(), next.inner() - ring.outer()));
        let e = before.min(after) / ring.half;
        let beside = if e.is_infinite() { e } else { (e + (e * (2.0 + e)).sqrt()).ln_1p() };
        let own = (PI / ring.half).asinh();
        let each = std::f64::consts::LN_10 / beside.min(own);
        let Some(share) = share(each) else {
            return Err(Error::ZonesTooClose { gap: narrowest(c, rings) });
        };
        counts.push((share * digits * each).ceil() as usize + 3);
    }
    Ok(counts)
}

/// Refuses more modes than can be coupled.
pub(super) fn require_few(c: f64, rings: &[Ring], counts: &[usize]) -> Result<(), Error> {
    if counts.iter().sum::<usize>() <= MOST_MODES {
        return Ok(());
    }
    Err(Error::ZonesTooClose { gap: narrowest(c, rings) })
}

/// The narrowest gap between rings, or from a disk of radius `c` to the first of them.
fn narrowest(c: f64, rings: &[Ring]) -> f64 {
    let inner = rings.first().filter(|_| c > 0.0).map(|ring| ring.inner() - c);
    let between = rings.windows(2).map(|pair| pair[1].inner() - pair[0].outer());
    between.chain(inner).fold(f64::INFINITY, f64::min).max(0.0)
}

/// Solves for densities whose displacements times `sqrt(r)` have given modes, ring by ring; beside a disk of radius `c` that does not move.
pub(super) fn solve(
    harmonic: RingKernel,
    c: f64,
    rings: &[Nodes],
    rights: &[Vec<Vec<f64>>],
) -> Result<Vec<Vec<Vec<f64>>>, Error> {
    let mut offsets = vec![0];
    for nodes in rings {
        offsets.push(offsets[offsets.len() - 1] + nodes.count());
    }
    let order = offsets[rings.len()];
    let mut matrix = vec![0.0; order * order];
    for (j, target) in rings.iter().enumerate() {
        for (i, source) in rings.iter().enumerate().skip(j) {
            let block = block(harmonic, c, target, source, i == j);
            for m in 0..target.count() {
                let first = if i == j { m } else { 0 };
                for n in first..source.count() {
                    let value = scale(m) * norm(m) * block[m * source.count() + n] * scale(n);
                    add(&mut matrix, order, [offsets[i] + n, offsets[j] + m], value);
                }
            }
        }
    }
    let scaled = |right: &Vec<Vec<f64>>| -> Vec<f64> {
        let of = |modes: &Vec<f64>| -> Vec<f64> {
            modes.iter().enumerate().map(|(k, f)| scale(k) * norm(k) * f).collect()
        };
        right.iter().flat_map(of).collect()
    };
    let mut found: Vec<Vec<f64>> = rights.iter().map(scaled).collect();
    fredholm::eliminate_positive(&matrix, &mut found)?;
    let split = |all: Vec<f64>| -> Vec<Vec<f64>> {
        offsets
            .windows(2)
            .map(|w| all[w[0]..w[1]].iter().enumerate().map(|(k, z)| z * scale(k)).collect())
            .collect()
    };
    Ok(found.into_iter().map(split).collect())
}

/// `int cos^2(k phi) dphi` over a half turn.
pub(super) fn norm(k: usize) -> f64 {
    if k == 0 { PI } else { FRAC_PI_2 }
}

/// With this scale of the modes the diagonal is about 1.
fn scale(k: usize) -> f64 {
    if k == 0 { 1.0 / PI } else { (2.0 * k as f64).sqrt() / PI }
}

/// Coefficients on the target of the displacement by each mode of the source.
fn block(harmonic: RingKernel, c: f64, target: &Nodes, source: &Nodes, is_own: bool) -> Vec<f64> {
    let (rows, columns) = (target.count(), source.count());
    let logarithms = if is_own { own_logarithms(source) } else { Vec::new() };
    let mut block = vec![0.0; rows * columns];
    for q in 0..rows {
        let influences: Vec<f64> = (0..columns)
            .map(|r| {
                let taken = harmonic.taken(c, target.beside(q, c), source.beside(r, c));
                if is_own {
                    let half = source.ring.half;
                    let y = along(half, target.angles[q], source.angles[r]);
                    let factor = harmonic.factor(y);
                    let rest = harmonic.rest(y) - factor * half.ln() - taken;
                    factor * logarithms[q.abs_diff(r)]
                        + factor * logarithms[q + r + 1]
                        + source.weight() * rest
                } else {
                    source.weight() * (harmonic.whole(between(target, q, source, r)) - taken)
                }
            })
            .collect();
        let row = source.transposed(&influences);
        for m in 0..rows {
            let weight = target.cosines[q * rows + m] * target.weight() / norm(m);
            let sums = &mut block[m * columns..(m + 1) * columns];
            sums.iter_mut().zip(&row).for_each(|(sum, value)| *sum += weight * value);
        }
    }
    block
}

impl Nodes {
    /// `sum_r v_r cos(k phi_r)`.
    fn transposed(&self, values: &[f64]) -> Vec<f64> {
        let count = self.count();
        let mut sums = vec![0.0; count];
        for (r, value) in values.iter().enumerate() {
            let cosines = &self.cosines[r * count..(r + 1) * count];
            sums.iter_mut().zip(cosines).for_each(|(sum, c)| *sum += value * c);
        }
        sums
    }
}

/// Weights of `int ln(1/|cos phi_q - cos t|) G(t) dt` at the nodes, exact for as many modes: `w(q - r) + w(q + r + 1)`,
/// `w(j) = (pi/n) [ln 2/2 + sum cos(pi k j/n)/k]`.
fn own_logarithms(nodes: &Nodes) -> Vec<f64> {
    let count = nodes.count();
    let cosines: Vec<f64> = (0..2 * count).map(|j| (PI * j as f64 / count as f64).cos()).collect();
    (0..2 * count)
        .map(|j| {
            let sum: f64 = (1..count).map(|k| cosines[k * j % (2 * count)] / k as f64).sum();
            nodes.weight() * (0.5 * LN_2 + sum)
        })
        .collect()
}

/// `ln(r/s)` of places on two rings.
fn between(target: &Nodes, q: usize, source: &Nodes, r: usize) -> f64 {
    let (one, two) = (&target.spots[q], &source.spots[r]);
    if target.ring.inner() > source.ring.inner() {
        let gap = target.ring.inner() - source.ring.outer();
        distance(two.radius, gap + one.from_inner + two.from_outer)
    } else {
        let gap = source.ring.inner() - target.ring.outer();
        -distance(one.radius, gap + two.from_inner + one.from_outer)
    }
}
