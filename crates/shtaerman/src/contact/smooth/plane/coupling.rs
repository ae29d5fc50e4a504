//! What zones of a half-plane do to one another.

use std::f64::consts::{FRAC_PI_2, LN_2, LN_10, PI};

use super::super::modes::{self, Modes, Nodes};
use super::kernel::{Kernel, Remainder};
use crate::Error;
use crate::contact::zones::Zone;

/// Gaps before and after each zone, and those across the ends of a period.
fn gaps(kernel: Kernel, zones: &[Zone]) -> Vec<[f64; 2]> {
    let (first, last) = (zones[0], zones[zones.len() - 1]);
    let around = kernel.period.map_or(f64::INFINITY, |p| first.left() + p - last.right());
    let mut gaps = vec![[around; 2]; zones.len()];
    for (j, pair) in zones.windows(2).enumerate() {
        let gap = pair[1].left() - pair[0].right();
        (gaps[j][1], gaps[j + 1][0]) = (gap, gap);
    }
    gaps
}

/// Number of modes for each zone: the field of what lies nearest is a series that falls as `rho^-k`, `rho` set by the distance. One zone alone has the mode of its force and that of its moment.
///
/// # Errors
/// [`Error::ZonesTooClose`].
pub(super) fn counts(kernel: Kernel, zones: &[Zone], digits: f64) -> Result<Vec<usize>, Error> {
    // The remainder of the periodic kernel ends two periods away.
    let reach = kernel.period.map_or(f64::INFINITY, |period| 2.0 * period - 2.0);
    let gaps = gaps(kernel, zones);
    let count = |(zone, [before, after]): (&Zone, &[f64; 2])| {
        let gap = before.min(*after);
        let e = gap.min(reach) / (0.5 * zone.length());
        if e.is_infinite() {
            return Ok(2);
        }
        let each = LN_10 / (e + (e * (2.0 + e)).sqrt()).ln_1p();
        modes::count(each, digits)
            .ok_or(Error::ZonesTooClose { gap: gap.max(0.0), roughness: None })
    };
    let counts = zones.iter().zip(&gaps).map(count).collect::<Result<Vec<usize>, Error>>()?;
    let narrowest = || gaps.as_flattened().iter().copied().fold(f64::INFINITY, f64::min);
    modes::require_few(&counts, narrowest)?;
    Ok(counts)
}

/// `theta0 gamma_k` of the densities whose displacements are `1`, `xi - middle` and that of these modes `f_k` of each zone.
///
/// # Errors
/// [`Error::Equation`] unless the system is positive, [`Error::ZonesTooClose`].
pub(super) fn coupled(
    kernel: Kernel,
    zones: &[Zone],
    counts: &[usize],
    middle: f64,
    heights: Modes,
) -> Result<[Modes; 3], Error> {
    let nodes: Vec<Nodes> = counts.iter().map(|count| Nodes::new(*count)).collect();
    let line = |of: &dyn Fn(&Zone) -> [f64; 2]| -> Modes {
        let modes = |(zone, count): (&Zone, &usize)| {
            let mut modes = vec![0.0; *count];
            modes[..2].copy_from_slice(&of(zone));
            modes
        };
        zones.iter().zip(counts).map(modes).collect()
    };
    let level = line(&|_| [1.0, 0.0]);
    let tilted = line(&|zone| [zone.middle() - middle, 0.5 * zone.length()]);
    let block = |target: usize, source: usize| {
        block(kernel, [&zones[target], &zones[source]], [&nodes[target], &nodes[source]])
    };
    let found = modes::coupled(counts, block, &[level, tilted, heights])?;
    let mut found = found.into_iter();
    Ok([(); 3].map(|()| found.next().unwrap_or_default()))
}

/// Modes on the target of the displacement by each mode of the source.
fn block(
    kernel: Kernel,
    [target, source]: [&Zone; 2],
    [rows, columns]: [&Nodes; 2],
) -> Result<Vec<f64>, Error> {
    let is_own = std::ptr::eq(target, source);
    let count = columns.count();
    let mut values = vec![0.0; rows.count() * count];
    for shift in kernel.shifts().filter(|shift| !is_own || *shift != 0.0) {
        add_image(&mut values, (target, rows), (source, count), shift)?;
    }
    if let Some(remainder) = kernel.remainder() {
        add_remainder(&mut values, remainder, (target, rows), (source, columns));
    }
    let mut block = rows.projected(&values);
    if is_own {
        block[0] += PI * (LN_2 - (0.5 * source.length()).ln());
        (1..count).for_each(|k| block[k * count + k] += PI / k as f64);
    }
    Ok(block)
}

/// The logarithm of a source that is moved by a shift.
fn add_image(
    values: &mut [f64],
    (target, rows): (&Zone, &Nodes),
    (source, count): (&Zone, usize),
    shift: f64,
) -> Result<(), Error> {
    let is_right = target.middle() > source.middle() + shift;
    let gap = if is_right {
        target.left() - (source.right() + shift)
    } else {
        source.left() + shift - target.right()
    };
    if gap.is_nan() || gap <= 0.0 {
        return Err(Error::ZonesTooClose { gap: gap.max(0.0), roughness: None });
    }
    let half = 0.5 * source.length();
    for (row, angle) in values.chunks_exact_mut(count).zip(&rows.angles) {
        let (sine, cosine) = (0.5 * angle).sin_cos();
        let inside = if is_right { cosine * cosine } else { sine * sine };
        let e = (gap + target.length() * inside) / half;
        let excess = e + (e * (2.0 + e)).sqrt();
        let ratio = if is_right { 1.0 } else { -1.0 } / (1.0 + excess);
        row[0] += PI * (LN_2 - half.ln() - excess.ln_1p());
        let mut power = 1.0;
        for (n, value) in row.iter_mut().enumerate().skip(1) {
            power *= ratio;
            *value += PI / n as f64 * power;
        }
    }
    Ok(())
}

fn add_remainder(
    values: &mut [f64],
    remainder: Remainder,
    (target, rows): (&Zone, &Nodes),
    (source, columns): (&Zone, &Nodes),
) {
    let place = |zone: &Zone, angle: &f64| zone.middle() + 0.5 * zone.length() * angle.cos();
    let sources: Vec<f64> = columns.angles.iter().map(|angle| place(source, angle)).collect();
    for (row, angle) in values.chunks_exact_mut(columns.count()).zip(&rows.angles) {
        let x = place(target, angle);
        let field: Vec<f64> =
            sources.iter().map(|s| columns.weight() * remainder.at(x - s)).collect();
        row.iter_mut().zip(columns.transposed(&field)).for_each(|(value, own)| *value += own);
    }
}

/// `theta0` times force and moment about a middle.
pub(super) fn carried(zones: &[Zone], middle: f64, modes: &[Vec<f64>]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for (zone, modes) in zones.iter().zip(modes) {
        sums[0] += PI * modes[0];
        sums[1] +=
            PI * (zone.middle() - middle) * modes[0] + FRAC_PI_2 * 0.5 * zone.length() * modes[1];
    }
    sums
}
