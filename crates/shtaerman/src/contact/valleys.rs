//! The ups and downs of a profile: how many samples show them, and how many cells.

use std::f64::consts::SQRT_2;

use super::accuracy::ROUNDING;
use crate::Error;
use crate::golden::GOLDEN;

/// Samples that show the ups and downs of a profile, at least (survey).
pub(super) const SAMPLES: usize = 512;
/// Most samples: sixteen for each of more valleys than cells can show.
pub(super) const MOST_SAMPLES: usize = 16384;
/// Cells of a base with few valleys: with three times as many none of 46 answers changes, and 195 zones take a third more time (survey).
pub(super) const CELLS: usize = 1024;
/// Most cells (survey).
pub(super) const MOST_CELLS: usize = 3072;
/// Places between samples where a profile is looked at (survey).
const PROBES: usize = 64;
/// A miss, as a share of the change of the profile between the samples beside; and the share of places that are missed where samples are too few (survey).
pub(super) const MISSED: f64 = 0.25;
/// Fewest cells that show a valley, of a zone, and of a piece of the base to begin with; twice as many are wanted (survey).
pub(super) const CELLS_A_ZONE: usize = 6;

/// Steps between samples that show the ups and downs of a profile on an interval: `least`, doubled while cubics through the samples miss it in many places, and at most `most`.
pub(super) fn steps(
    height: impl Fn(f64) -> f64,
    [left, right]: [f64; 2],
    least: usize,
    most: usize,
) -> usize {
    let mut count = least;
    while count < most && misses(&height, [left, right], count) as f64 >= MISSED * PROBES as f64 {
        count = (2 * count).min(most);
    }
    count
}

fn misses(height: &impl Fn(f64) -> f64, [left, right]: [f64; 2], count: usize) -> usize {
    let at = |step: f64| height(left + (right - left) * step / count as f64);
    let is_missed = |probe: &usize| {
        let share = (GOLDEN * *probe as f64).fract();
        let first = (share * (count - 3) as f64).floor();
        let values = [0.0, 1.0, 2.0, 3.0].map(|step| at(first + step));
        // Half-way between its samples alone a wave of two periods a step would be hit again.
        let u = 1.25 + 0.5 * (SQRT_2 * *probe as f64).fract();
        let between = at(first + u);
        let all = || values.iter().chain([&between]);
        let most = all().fold(f64::NEG_INFINITY, |most, value| most.max(*value));
        let least = all().fold(f64::INFINITY, |least, value| least.min(*value));
        let size = most.abs().max(least.abs());
        let missed = (cubic(values, u) - between).abs();
        missed > (MISSED * (most - least)).max(ROUNDING * size)
    };
    (1..=PROBES).filter(is_missed).count()
}

/// The cubic with these values at 0, 1, 2 and 3.
fn cubic([zero, one, two, three]: [f64; 4], u: f64) -> f64 {
    let outer = (u - 1.0) * (u - 2.0) * (three * u - zero * (u - 3.0)) / 6.0;
    outer + 0.5 * u * (u - 3.0) * (one * (u - 2.0) - two * (u - 1.0))
}

/// Where samples `(xi, f0)` at equal steps have their lowest places between higher ones, by parabolas.
pub(super) fn valleys(samples: &[(f64, f64)]) -> impl Iterator<Item = f64> + '_ {
    let lowest = samples.windows(3).filter(|w| w[1].1 <= w[0].1 && w[1].1 < w[2].1);
    lowest.map(|w| {
        let [before, after] = [w[0].1 - w[1].1, w[2].1 - w[1].1];
        w[1].0 + 0.25 * (w[2].0 - w[0].0) * ((before - after) / (before + after)).clamp(-1.0, 1.0)
    })
}

/// Where to cut an interval into about so many cells. If those are few for each valley, but enough to show it, they are centred on the valleys: at others the height of a cell would tell where it lies rather than
/// how deep the valley is.
pub(super) fn cuts(valleys: &[f64], [left, right]: [f64; 2], count: usize) -> Vec<f64> {
    let each = count / (valleys.len() + 1);
    let are_few = (CELLS_A_ZONE..2 * CELLS_A_ZONE).contains(&each);
    let (true, [first, .., last]) = (are_few, valleys) else {
        return (1..count).map(|i| left + (right - left) * i as f64 / count as f64).collect();
    };
    let between = |pair: &[f64]| {
        let [from, to] = [pair[0], pair[1]];
        (0..each).map(move |i| from + (to - from) * (i as f64 + 0.5) / each as f64)
    };
    let outer = [2.0 * left - first, *first, *last, 2.0 * right - last];
    valleys
        .windows(2)
        .flat_map(between)
        .chain(outer.chunks(2).flat_map(between))
        .filter(|at| *at > left && *at < right)
        .collect()
}

/// Number of cells that shows so many valleys, if possible twelve for each; those of more than can be had show none.
pub(super) fn cells(valleys: usize, most: usize) -> usize {
    const FEWEST: usize = 48;
    let count = (2 * CELLS_A_ZONE * (valleys + 1)).clamp(FEWEST, CELLS);
    count.max((CELLS_A_ZONE * (valleys + 1)).min(most))
}

/// Refuses intervals of contact among more valleys than zones can be solved, if there are too few cells to tell which of them touch.
pub(super) fn require_shown(
    found: &[[f64; 2]],
    valleys: &[f64],
    cells: usize,
    most: usize,
) -> Result<(), Error> {
    if let ([first, .., last], true) = (found, cells < CELLS_A_ZONE * valleys.len()) {
        let inside = |at: &&f64| first[0] <= **at && **at <= last[1];
        let zones = valleys.iter().filter(inside).count();
        if zones > most {
            return Err(Error::TooManyZones { zones, most });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counted(height: impl Fn(f64) -> f64, least: usize) -> usize {
        let count = steps(&height, [-1.0, 1.0], least, 65536);
        let at = |i: usize| 2.0 * i as f64 / count as f64 - 1.0;
        let samples: Vec<(f64, f64)> = (0..=count).map(|i| (at(i), height(at(i)))).collect();
        valleys(&samples).count()
    }

    #[test]
    fn waves_are_counted_also_where_they_fall_in_with_the_samples() {
        for crests in [3.0, 40.0, 255.5, 256.0, 512.0, 1000.0, 5000.0] {
            let wave = |x: f64| (std::f64::consts::PI * crests * x).cos() + x * x;
            let found = counted(wave, 512) as f64;
            assert!((found - crests).abs() <= 2.0, "{crests}: {found}");
        }
    }

    #[test]
    fn cubics_are_their_own() {
        let value = |u: f64| 2.0 - u + 0.5 * u * u - 0.25 * u * u * u;
        for u in [1.1, 1.5, 1.9] {
            assert!((cubic([0.0, 1.0, 2.0, 3.0].map(value), u) - value(u)).abs() < 1e-15);
        }
    }

    #[test]
    fn few_cells_are_centred_on_valleys() {
        let valleys = [0.1, 0.3, 0.5, 0.9];
        let cuts = cuts(&valleys, [0.0, 1.0], 30);
        let mut sorted = cuts.clone();
        sorted.sort_by(f64::total_cmp);
        for at in valleys {
            let after = sorted.partition_point(|cut| *cut < at);
            let [below, above] = [at - sorted[after - 1], sorted[after] - at];
            // A twelfth of the way to the next valley, or to the mirror image of an outer one.
            assert!(below > 0.0 && above > 0.0 && below.max(above) < 0.4 / 11.9, "{at}");
        }
        // Enough for each need not be.
        assert_eq!(super::cuts(&valleys[..1], [0.0, 1.0], 4), [0.25, 0.5, 0.75]);
    }

    #[test]
    fn what_is_smooth_bends_or_jumps_needs_no_more() {
        let profiles: [fn(f64) -> f64; 5] = [
            |x| x * x,
            |x| (x - 0.3).abs(),
            |_| 1e-3,
            |x| if x > 0.1 { 1.0 } else { 0.0 },
            |x| 1e3 + 1e-13 * x,
        ];
        for profile in profiles {
            assert_eq!(steps(profile, [-1.0, 1.0], 512, 8192), 512);
        }
    }

    #[test]
    fn valleys_that_no_cell_shows_are_too_many() {
        let valleys: Vec<f64> = (0..1000).map(|i| f64::from(i) / 1000.0).collect();
        let few = [[0.1, 0.2], [0.15, 0.3]];
        let refused = require_shown(&few, &valleys, 3072, 48);
        assert!(matches!(refused, Err(Error::TooManyZones { zones: 201, most: 48 })));
        // One zone over all of them is full contact, and enough cells tell.
        assert!(require_shown(&few[..1], &valleys, 3072, 48).is_ok());
        assert!(require_shown(&few, &valleys, 6000, 48).is_ok());
    }
}
