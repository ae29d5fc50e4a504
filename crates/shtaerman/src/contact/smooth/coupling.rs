//! What zones do to one another: the coupled modes.

use std::f64::consts::{FRAC_PI_2, LN_2, LN_10, PI};

use super::detail::{COARSE, FINE};
use super::kernel::{Remainder, SmoothKernel};
use crate::Error;
use crate::contact::zones::Zone;

/// Most modes of a zone, and of all together. Half and twice change none of 32 answers (survey).
const MOST_OF_A_ZONE: f64 = 800.0;
pub(super) const MOST_MODES: usize = 4000;

/// The coefficients `theta0 gamma_k` of three densities, zone by zone: their displacements are `1`, `xi - middle` and `f0`.
pub(super) struct Coupled {
    pub(super) level: Vec<Vec<f64>>,
    pub(super) tilted: Vec<Vec<f64>>,
    pub(super) profile: Vec<Vec<f64>>,
}

/// Number of modes for each zone: the field of what lies nearest is a series that falls as `rho^-k`, `rho` set by the distance. Where zones are close all
/// digits take more modes than can be had, and every detail gets the same share of its own, so that comparing two of them still tells the error.
pub(super) fn modes(
    kernel: SmoothKernel,
    zones: &[Zone],
    digits: f64,
) -> Result<Vec<usize>, Error> {
    let mut counts = Vec::with_capacity(zones.len());
    let period = kernel.period();
    for (j, zone) in zones.iter().enumerate() {
        let before = match j {
            0 => period.map(|period| zone.left() - (zones[zones.len() - 1].right() - period)),
            _ => Some(zone.left() - zones[j - 1].right()),
        };
        let after = match zones.get(j + 1) {
            None => period.map(|period| zones[0].left() + period - zone.right()),
            Some(next) => Some(next.left() - zone.right()),
        };
        let gap = before.into_iter().chain(after).fold(f64::INFINITY, f64::min);
        // The remainder of the periodic kernel ends two periods away.
        let reach = period.map_or(f64::INFINITY, |period| 2.0 * period - 2.0);
        let e = gap.min(reach) / (0.5 * zone.length());
        let each = LN_10 / (e + (e * (2.0 + e)).sqrt()).ln_1p();
        let Some(share) = share(each) else {
            return Err(Error::ZonesTooClose { gap: gap.max(0.0) });
        };
        let wanted = if e.is_infinite() { 2.0 } else { (share * digits * each).ceil() + 3.0 };
        counts.push(wanted as usize);
    }
    if counts.iter().sum::<usize>() > MOST_MODES {
        return Err(Error::ZonesTooClose { gap: narrowest(kernel, zones) });
    }
    Ok(counts)
}

/// The share of all digits that are kept where each takes so many modes; none where these are fewer than zones are looked for with.
pub(super) fn share(each: f64) -> Option<f64> {
    let share = (MOST_OF_A_ZONE / (FINE.digits * each)).min(1.0);
    (share * FINE.digits >= COARSE.digits).then_some(share)
}

/// The narrowest gap beside a zone, also across the ends of a period.
fn narrowest(kernel: SmoothKernel, zones: &[Zone]) -> f64 {
    let between = zones.windows(2).map(|pair| pair[1].left() - pair[0].right());
    let around = match (kernel.period(), zones) {
        (Some(period), [first, .., last]) => Some(first.left() + period - last.right()),
        (Some(period), [only]) => Some(period - only.length()),
        _ => None,
    };
    between.chain(around).fold(f64::INFINITY, f64::min)
}

/// Solves for the three densities, about a middle; `heights` are the coefficients `f_k` of each zone.
pub(super) fn couple(
    kernel: SmoothKernel,
    zones: &[Zone],
    counts: &[usize],
    middle: f64,
    heights: &[Vec<f64>],
) -> Result<Coupled, Error> {
    let mut offsets = vec![0];
    for count in counts {
        offsets.push(offsets[offsets.len() - 1] + count);
    }
    let order = offsets[zones.len()];
    let mut matrix = vec![0.0; order * order];
    let nodes: Vec<Nodes> = zones.iter().zip(counts).map(|(z, n)| Nodes::new(*z, *n)).collect();
    for j in 0..zones.len() {
        add(&mut matrix, order, [offsets[j], offsets[j]], LN_2 - nodes[j].half.ln());
        for k in 1..counts[j] {
            add(&mut matrix, order, [offsets[j] + k, offsets[j] + k], 1.0);
        }
        for i in j..zones.len() {
            if i == j && kernel.period().is_none() {
                continue;
            }
            let block = block(kernel, &nodes[j], &nodes[i], i == j)?;
            let scales: Vec<f64> = (0..counts[i]).map(scale).collect();
            for m in 0..counts[j] {
                let first = if i == j { m } else { 0 };
                let (factor, row) = (scale(m) * norm(m), &block[m * counts[i]..][..counts[i]]);
                for n in first..counts[i] {
                    add(
                        &mut matrix,
                        order,
                        [offsets[i] + n, offsets[j] + m],
                        factor * row[n] * scales[n],
                    );
                }
            }
        }
    }
    let mut rights = vec![vec![0.0; order]; 3];
    for j in 0..zones.len() {
        let row = offsets[j];
        rights[0][row] = scale(0) * PI;
        rights[1][row] = scale(0) * PI * (nodes[j].centre - middle);
        rights[1][row + 1] = scale(1) * FRAC_PI_2 * nodes[j].half;
        for (k, f) in heights[j].iter().enumerate() {
            rights[2][row + k] = scale(k) * norm(k) * f;
        }
    }
    fredholm::eliminate_positive(&matrix, &mut rights)?;
    let mut found = rights.into_iter();
    let mut split = || -> Vec<Vec<f64>> {
        let all = found.next().unwrap_or_default();
        offsets
            .windows(2)
            .map(|w| all[w[0]..w[1]].iter().enumerate().map(|(k, z)| z * scale(k)).collect())
            .collect()
    };
    Ok(Coupled { level: split(), tilted: split(), profile: split() })
}

/// Adds to an entry of the lower triangle.
pub(super) fn add(matrix: &mut [f64], order: usize, [row, column]: [usize; 2], value: f64) {
    matrix[row * order + column] += value;
}

/// `int cos^2(k phi) dphi` over a half turn.
fn norm(k: usize) -> f64 {
    if k == 0 { PI } else { FRAC_PI_2 }
}

/// With this scale of the modes the diagonal is 1.
fn scale(k: usize) -> f64 {
    if k == 0 { 1.0 / PI } else { (2.0 * k as f64).sqrt() / PI }
}

/// The Chebyshev nodes of a zone.
struct Nodes {
    zone: Zone,
    centre: f64,
    half: f64,
    angles: Vec<f64>,
    /// `cos(k phi_q)`, node by node.
    cosines: Vec<f64>,
}

impl Nodes {
    fn new(zone: Zone, count: usize) -> Self {
        let (centre, half) = (0.5 * (zone.left() + zone.right()), 0.5 * zone.length());
        let turn = |q: usize| PI * (q as f64 + 0.5) / count as f64;
        let angles: Vec<f64> = (0..count).map(turn).collect();
        // All of them are cosines of multiples of a quarter turn over the count.
        let table: Vec<f64> =
            (0..4 * count).map(|m| (FRAC_PI_2 * m as f64 / count as f64).cos()).collect();
        let cosine = |q: usize, k: usize| table[(2 * q + 1) * k % (4 * count)];
        let cosines = (0..count).flat_map(|q| (0..count).map(move |k| (q, k)));
        let cosines = cosines.map(|(q, k)| cosine(q, k)).collect();
        Self { zone, centre, half, angles, cosines }
    }

    fn count(&self) -> usize {
        self.angles.len()
    }
}

/// Coefficients on the target of the displacement by each mode of the source, but for its own logarithm.
fn block(
    kernel: SmoothKernel,
    target: &Nodes,
    source: &Nodes,
    is_own: bool,
) -> Result<Vec<f64>, Error> {
    let (rows, columns) = (target.count(), source.count());
    let mut values = vec![0.0; rows * columns];
    for image in kernel.images() {
        if is_own && *image == 0.0 {
            continue;
        }
        let shift = image * kernel.period().unwrap_or(0.0);
        add_image(&mut values, target, source, shift)?;
    }
    if let Some(remainder) = kernel.remainder() {
        add_remainder(&mut values, remainder, target, source);
    }
    let mut block = vec![0.0; rows * columns];
    for q in 0..rows {
        for m in 0..rows {
            let weight = target.cosines[q * rows + m] / (rows as f64 * norm(m) / PI);
            let row = &mut block[m * columns..(m + 1) * columns];
            let values = &values[q * columns..(q + 1) * columns];
            row.iter_mut().zip(values).for_each(|(b, v)| *b += weight * v);
        }
    }
    Ok(block)
}

/// The logarithm of a source that is moved by a shift.
fn add_image(values: &mut [f64], target: &Nodes, source: &Nodes, shift: f64) -> Result<(), Error> {
    let columns = source.count();
    let is_right = target.centre > source.centre + shift;
    let gap = if is_right {
        target.zone.left() - (source.zone.right() + shift)
    } else {
        source.zone.left() + shift - target.zone.right()
    };
    if gap.is_nan() || gap <= 0.0 {
        return Err(Error::ZonesTooClose { gap: gap.max(0.0) });
    }
    let weights: Vec<f64> = (0..columns).map(|n| PI / n.max(1) as f64).collect();
    for (q, angle) in target.angles.iter().enumerate() {
        let (sine, cosine) = (0.5 * angle).sin_cos();
        let inside = if is_right { cosine * cosine } else { sine * sine };
        let e = (gap + target.zone.length() * inside) / source.half;
        let excess = e + (e * (2.0 + e)).sqrt();
        let ratio = if is_right { 1.0 } else { -1.0 } / (1.0 + excess);
        let row = &mut values[q * columns..(q + 1) * columns];
        row[0] += PI * (LN_2 - source.half.ln() - excess.ln_1p());
        let mut power = 1.0;
        for (value, weight) in row[1..].iter_mut().zip(&weights[1..]) {
            power *= ratio;
            *value += weight * power;
        }
    }
    Ok(())
}

fn add_remainder(values: &mut [f64], remainder: Remainder, target: &Nodes, source: &Nodes) {
    let columns = source.count();
    let sources: Vec<f64> =
        source.angles.iter().map(|angle| source.centre + source.half * angle.cos()).collect();
    for (q, angle) in target.angles.iter().enumerate() {
        let x = target.centre + target.half * angle.cos();
        let row = &mut values[q * columns..(q + 1) * columns];
        for (r, s) in sources.iter().enumerate() {
            let weight = PI / columns as f64 * remainder.at(x - s);
            let cosines = &source.cosines[r * columns..(r + 1) * columns];
            row.iter_mut().zip(cosines).for_each(|(v, c)| *v += weight * c);
        }
    }
}
