//! What rings do to themselves and to one another.
//!
//! On a ring `ln r = m + l cos phi` the pressure is `p0 = G(phi)/(theta0 l r^(3/2) sin phi)`, and the displacement times `sqrt(r)` is `int (Q - H) G dphi` over all rings, `Q` the kernel of rings and `H`
//! what a disk inside them takes away.

use std::borrow::Cow;
use std::f64::consts::{LN_2, LN_10, PI};

use fredholm::inversion::RingKernel;

use super::super::modes::{self, Modes, Nodes};
use super::ring::{Ring, Spot, along, distance};
use crate::Error;

/// The Chebyshev nodes of a ring.
#[derive(Debug, Clone)]
pub(super) struct RingNodes {
    pub(super) ring: Ring,
    pub(super) nodes: Nodes,
    pub(super) spots: Vec<Spot>,
}

impl RingNodes {
    pub(super) fn new(ring: Ring, count: usize) -> Self {
        let nodes = Nodes::new(count);
        let spots = nodes.angles.iter().map(|angle| ring.spot(*angle)).collect();
        Self { ring, nodes, spots }
    }

    /// A node by its radius and its distance from a disk of radius `c`.
    pub(super) fn beside(&self, q: usize, c: f64) -> [f64; 2] {
        let spot = &self.spots[q];
        [spot.radius, self.ring.inner() - c + spot.from_inner]
    }

    /// The modes of a function of radius and distance from a disk of radius `c`, times `sqrt(r)`.
    pub(super) fn modes_of(&self, c: f64, f: impl Fn([f64; 2]) -> f64) -> Vec<f64> {
        let value = |q: usize| {
            let place = self.beside(q, c);
            place[0].sqrt() * f(place)
        };
        self.nodes.modes(&(0..self.nodes.count()).map(value).collect::<Vec<f64>>())
    }
}

/// Number of modes for each ring: kernels end at `y = i pi`, and the field of what lies nearest is a series that falls as `rho^-k`, `rho` set by the distance.
///
/// # Errors
/// [`Error::ZonesTooClose`].
pub(super) fn counts(c: f64, rings: &[Ring], digits: f64) -> Result<Vec<usize>, Error> {
    let nearest = |ring: &Ring| {
        let others = rings.iter().filter(|other| other.inner() != ring.inner());
        others.map(|other| apart(ring, other)).fold(from_disk(c, ring), f64::min)
    };
    let counts: Option<_> = rings.iter().map(|ring| count(ring, nearest(ring), digits)).collect();
    counts.ok_or_else(|| Error::ZonesTooClose { gap: narrowest(c, rings), roughness: None })
}

/// The same of one ring for what is so far away in the logarithm of the radius; none where that is too close.
fn count(ring: &Ring, gap: f64, digits: f64) -> Option<usize> {
    let e = gap / ring.half;
    let beside = if e.is_infinite() { e } else { (e + (e * (2.0 + e)).sqrt()).ln_1p() };
    let own = (PI / ring.half).asinh();
    modes::count(LN_10 / beside.min(own), digits)
}

/// The narrowest gap between rings, or from a disk of radius `c` to the first of them.
pub(super) fn narrowest(c: f64, rings: &[Ring]) -> f64 {
    let inner = rings.first().filter(|_| c > 0.0).map(|ring| ring.inner() - c);
    let between = rings.windows(2).map(|pair| pair[1].inner() - pair[0].outer());
    between.chain(inner).fold(f64::INFINITY, f64::min).max(0.0)
}

/// Densities whose displacements times `sqrt(r)` have given modes, ring by ring; beside a disk of radius `c` that does not move. Modes are coupled to these digits.
pub(super) fn coupled(
    kernel: RingKernel,
    (c, digits): (f64, f64),
    rings: &[&RingNodes],
    rights: &[Modes],
) -> Result<Vec<Modes>, Error> {
    let counts: Vec<usize> = rings.iter().map(|ring| ring.nodes.count()).collect();
    let block = |target: usize, source: usize| {
        let (both, is_own) = ([rings[target], rings[source]], target == source);
        let gap = apart(&both[0].ring, &both[1].ring);
        // As many nodes as what is so far away takes: more tell no more of it.
        let few = both.map(|ring| {
            let few = count(&ring.ring, gap.min(from_disk(c, &ring.ring)), digits);
            let few = few.filter(|few| !is_own && *few < ring.nodes.count());
            few.map_or(Cow::Borrowed(ring), |few| Cow::Owned(RingNodes::new(ring.ring, few)))
        });
        // Its other modes are nothing.
        let mut all = vec![0.0; counts[target] * counts[source]];
        let known = block(kernel, c, &few[0], &few[1], is_own);
        let rows = known.chunks_exact(few[1].nodes.count());
        for (row, known) in all.chunks_exact_mut(counts[source]).zip(rows) {
            row[..known.len()].copy_from_slice(known);
        }
        Ok(all)
    };
    modes::coupled(&counts, block, rights)
}

/// The gap between two rings, as logarithm of the radius; of a ring to itself none.
fn apart(one: &Ring, other: &Ring) -> f64 {
    let gap = |from: &Ring, to: &Ring| distance(from.outer(), to.inner() - from.outer());
    gap(one, other).max(gap(other, one)).max(0.0)
}

/// The gap to a disk of radius `c` inside.
fn from_disk(c: f64, ring: &Ring) -> f64 {
    if c > 0.0 { distance(c, ring.inner() - c) } else { f64::INFINITY }
}

/// Modes on the target of the displacement by each mode of the source.
fn block(
    kernel: RingKernel,
    c: f64,
    target: &RingNodes,
    source: &RingNodes,
    is_own: bool,
) -> Vec<f64> {
    let (rows, columns, weight) =
        (target.nodes.count(), source.nodes.count(), source.nodes.weight());
    let logarithms = if is_own { own_logarithms(&source.nodes) } else { Vec::new() };
    let influence = |q: usize, r: usize| {
        let taken = kernel.taken(c, target.beside(q, c), source.beside(r, c));
        if !is_own {
            return weight * (kernel.whole(between(target, q, source, r)) - taken);
        }
        let half = source.ring.half;
        let y = along(half, target.nodes.angles[q], source.nodes.angles[r]);
        let [factor, rest] = kernel.parts(y);
        let rest = rest - factor * half.ln() - taken;
        factor * (logarithms[q.abs_diff(r)] + logarithms[q + r + 1]) + weight * rest
    };
    let mut influences = vec![0.0; rows * columns];
    for q in 0..rows {
        // What a node of a ring does to another that does to it.
        let known = if is_own { q } else { 0 };
        for r in 0..known {
            influences[q * columns + r] = influences[r * columns + q];
        }
        for r in known..columns {
            influences[q * columns + r] = influence(q, r);
        }
    }
    let rows = influences.chunks_exact(columns);
    let values: Vec<f64> = rows.flat_map(|row| source.nodes.transposed(row)).collect();
    target.nodes.projected(&values)
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
fn between(target: &RingNodes, q: usize, source: &RingNodes, r: usize) -> f64 {
    let (one, two) = (&target.spots[q], &source.spots[r]);
    if target.ring.inner() > source.ring.inner() {
        let gap = target.ring.inner() - source.ring.outer();
        distance(two.radius, gap + one.from_inner + two.from_outer)
    } else {
        let gap = source.ring.inner() - target.ring.outer();
        -distance(one.radius, gap + two.from_inner + one.from_outer)
    }
}
