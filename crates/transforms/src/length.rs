//! Lengths that transform fast.

/// The smallest `2^i 3^j 5^k` that is at least `least` (and at least 1); `least` below `2^62`.
#[must_use]
pub fn fast_length(least: usize) -> usize {
    let least = least.max(1);
    let mut best = least.next_power_of_two();
    let mut fives = 1;
    while fives < best {
        let mut odd = fives;
        while odd < best {
            best = best.min(least.div_ceil(odd).next_power_of_two() * odd);
            odd *= 3;
        }
        fives *= 5;
    }
    best
}
