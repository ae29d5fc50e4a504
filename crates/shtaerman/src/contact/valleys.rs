//! The ups and downs of a profile: how many samples show them, and how many cells.

use crate::Error;

/// Places between samples where a profile is looked at, and so many of them missed that samples are too few.
const PROBES: usize = 64;
const MANY_MISSED: usize = 8;
/// A miss, as a share of the change of the profile between the samples beside; and of its size, below which it is rounding.
const MISSED: f64 = 0.25;
const ROUNDING: f64 = 1e-9;
/// The golden ratio: multiples of it never fall in with a wave.
const GOLDEN: f64 = 0.618_033_988_749_894_8;
/// Fewest cells that show a valley.
const CELLS_A_VALLEY: usize = 6;

/// Steps between samples that show the ups and downs of a profile on an interval: `least`, doubled while cubics through the samples miss it in many places, and at most `most`.
pub(super) fn steps(
    height: impl Fn(f64) -> f64,
    [left, right]: [f64; 2],
    least: usize,
    most: usize,
) -> usize {
    let mut count = least;
    while count < most && misses(&height, [left, right], count) >= MANY_MISSED {
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
        let between = at(first + 1.5);
        let cubic = (9.0 * (values[1] + values[2]) - values[0] - values[3]) / 16.0;
        let all = || values.iter().chain([&between]);
        let most = all().fold(f64::NEG_INFINITY, |most, value| most.max(*value));
        let least = all().fold(f64::INFINITY, |least, value| least.min(*value));
        let size = most.abs().max(least.abs());
        (cubic - between).abs() > (MISSED * (most - least)).max(ROUNDING * size)
    };
    (1..=PROBES).filter(is_missed).count()
}

/// Where samples `(xi, f0)` have their lowest places between higher ones.
pub(super) fn valleys(samples: &[(f64, f64)]) -> impl Iterator<Item = f64> + '_ {
    let lowest = samples.windows(3).filter(|w| w[1].1 <= w[0].1 && w[1].1 < w[2].1);
    lowest.map(|w| w[1].0)
}

/// Number of cells that shows so many valleys, if possible twelve for each; those of more than can be had show none.
pub(super) fn cells(valleys: usize, usual: usize, most: usize) -> usize {
    const FEWEST: usize = 48;
    const WANTED: usize = 12;
    let count = (WANTED * (valleys + 1)).clamp(FEWEST, usual);
    count.max((CELLS_A_VALLEY * (valleys + 1)).min(most))
}

/// Refuses intervals of contact among more valleys than zones can be solved, if there are too few cells to tell which of them touch.
pub(super) fn require_shown(
    found: &[[f64; 2]],
    valleys: &[f64],
    cells: usize,
    most: usize,
) -> Result<(), Error> {
    if let ([first, .., last], true) = (found, cells < CELLS_A_VALLEY * valleys.len()) {
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
