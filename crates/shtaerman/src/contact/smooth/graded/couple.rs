//! What several zones do to one another.
//!
//! Each zone has its own pressure under the profile without depth and tilt, and polynomials `c_n` besides. As displacements of others are analytic on a zone, few of them do, and
//! the equation at as many nodes of each zone, `sum u_n c_n + sum over others u_n d_n = ..`, `u_n = l_n m_n`, is a dense system. The own pressures displace other zones as the
//! profile's coefficients do, `f0 = sum a_n c_n` giving `sum a_n d_n`, of which no more are felt than those that are kept.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use fredholm::inversion::Powers;
use fredholm::inversion::ultraspherical::{gains, inside, norms, outside};

use super::super::base::Base;
use super::super::modes::Modes;
use super::on_zone::OnZone;
use crate::Error;
use crate::contact::accuracy::ROUNDING;
use crate::contact::zones::Zone;

/// Panels of the coefficients of a profile are doubled at most so often, until these change by no more than this share, or no less than before. At half or twice 1 of 3 answers change, within what they state (survey).
const DOUBLINGS: usize = 6;

/// Coefficients that change by no more than this share, relative to the largest, and no less than before, are noise.
const NOISE: f64 = 1e-11;

/// Zones with their nodes.
struct Nodes {
    centre: f64,
    half: f64,
    /// `y` with the distances from both ends.
    places: Vec<(f64, [f64; 2])>,
}

impl Nodes {
    fn new(zone: &Zone, count: usize) -> Self {
        let (centre, half) = (0.5 * (zone.left() + zone.right()), 0.5 * zone.length());
        let place = |q: usize| {
            let angle = PI * (q as f64 + 0.5) / count as f64;
            let (sine, cosine) = (0.5 * angle).sin_cos();
            let [left, right] = [cosine, sine].map(|side| zone.length() * side * side);
            (angle.cos(), [left, right])
        };
        Self { centre, half, places: (0..count).map(place).collect() }
    }
}

/// The coefficients `m_n` of three pressures, zone by zone: their displacements are 1, `xi - middle` and `f0` without what each zone's own pressure makes of it.
pub(super) fn couple(
    base: &Base,
    powers: &Powers,
    zones: &[Zone],
    counts: &[usize],
    parts: &[Arc<OnZone>],
    middle: f64,
) -> Result<[Modes; 3], Error> {
    let nodes: Vec<Nodes> = zones.iter().zip(counts).map(|(z, n)| Nodes::new(z, *n)).collect();
    let lambda = 0.5 * powers.exponent();
    let mut offsets = vec![0];
    counts.iter().for_each(|count| offsets.push(offsets[offsets.len() - 1] + count));
    let order = offsets[zones.len()];
    let heights: Vec<Vec<f64>> = (parts.iter().zip(&nodes).zip(counts))
        .map(|((parts, nodes), count)| coefficients(base, powers, parts, nodes, *count))
        .collect();
    let mut matrix = vec![0.0; order * order];
    let mut rights = [(); 3].map(|()| Vec::with_capacity(order));
    let mut rows = matrix.chunks_exact_mut(order.max(1));
    for (j, target) in nodes.iter().enumerate() {
        for (y, [from_left, from_right]) in &target.places {
            let Some(row) = rows.next() else { continue };
            let mut felt = base.height(target.centre);
            for (i, source) in nodes.iter().enumerate() {
                let slots = &mut row[offsets[i]..offsets[i + 1]];
                if i == j {
                    slots.copy_from_slice(&inside(lambda, counts[i], *y));
                    continue;
                }
                let (distance, sign) = if j > i {
                    (zones[j].left() - zones[i].right() + from_left, 1.0)
                } else {
                    (zones[i].left() - zones[j].right() + from_right, -1.0)
                };
                let values = outside(powers, counts[i], distance / source.half);
                let mut parity = 1.0;
                for ((slot, d), a) in slots.iter_mut().zip(values).zip(&heights[i]) {
                    *slot = parity * d;
                    felt -= a * parity * d;
                    parity *= sign;
                }
            }
            let xi = target.centre - middle + target.half * y;
            rights.iter_mut().zip([1.0, xi, felt]).for_each(|(right, value)| right.push(value));
        }
    }
    fredholm::eliminate(&matrix, &mut rights)?;
    let split = |all: &Vec<f64>| -> Modes {
        let zone = |(pair, count): (&[usize], &usize)| {
            let gains = gains(powers, *count);
            all[pair[0]..pair[1]].iter().zip(gains).map(|(u, l)| u / l).collect()
        };
        offsets.windows(2).zip(counts).map(zone).collect()
    };
    Ok(rights.each_ref().map(split))
}

/// `a_n` of the profile above its height in the middle of a zone.
fn coefficients(
    base: &Base,
    powers: &Powers,
    parts: &OnZone,
    nodes: &Nodes,
    count: usize,
) -> Vec<f64> {
    if let Some(known) = parts.heights(powers, count) {
        return known;
    }
    let mut cuts = vec![0.0];
    let inner = parts.breaks().iter().rev().filter(|r| **r < nodes.half);
    cuts.extend(inner.map(|r| (r / nodes.half).acos()));
    cuts.push(FRAC_PI_2);
    // On a quarter turn, one of a polynomial in each.
    let mut panels = 1 + count / 4;
    let mut found = summed(base, powers, nodes, &cuts, [count, panels]);
    let mut before = f64::INFINITY;
    for _ in 0..DOUBLINGS {
        panels *= 2;
        let finer = summed(base, powers, nodes, &cuts, [count, panels]);
        let size = finer.iter().fold(0.0f64, |most, a| most.max(a.abs()));
        let changed = finer.iter().zip(&found).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
        found = finer;
        let agreed = (0.01 * parts.tolerance()).max(ROUNDING) * size;
        if changed <= agreed || (changed <= NOISE * size && changed >= 0.5 * before) {
            break;
        }
        before = changed;
    }
    found
}

/// The same with about so many panels of the quarter turn, and at least one between cuts.
fn summed(
    base: &Base,
    powers: &Powers,
    nodes: &Nodes,
    cuts: &[f64],
    [count, panels]: [usize; 2],
) -> Vec<f64> {
    let (lambda, middle) = (0.5 * powers.exponent(), base.height(nodes.centre));
    let mut sums = vec![0.0; count];
    for pair in cuts.windows(2) {
        let parts = (panels as f64 * (pair[1] - pair[0]) / FRAC_PI_2).ceil() as usize;
        let at = |part: usize| pair[0] + (pair[1] - pair[0]) * part as f64 / parts as f64;
        for part in 0..parts {
            let to = if part + 1 == parts { pair[1] } else { at(part + 1) };
            for (angle, weight) in powers.nodes([at(part), to]) {
                let y = angle.cos();
                let s = nodes.half * y;
                let [right, left] = [s, -s].map(|s| base.height(nodes.centre + s) - middle);
                let power = weight * powers.power(angle.sin());
                let halves = [(right + left) * power, (right - left) * power];
                for (n, c) in inside(lambda, count, y).into_iter().enumerate() {
                    sums[n] += halves[n % 2] * c;
                }
            }
        }
    }
    sums.iter().zip(norms(powers, count)).map(|(sum, norm)| sum / norm).collect()
}
