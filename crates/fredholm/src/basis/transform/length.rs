//! Lengths that transform fast.

/// The smallest `2^i 3^j 5^k` that is at least `least` (and at least 1); `least` below `2^62`.
pub(crate) fn fast_length(least: usize) -> usize {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_the_next_number_without_large_factors() {
        let smooth = |mut n: usize| {
            for prime in [2, 3, 5] {
                while n.is_multiple_of(prime) {
                    n /= prime;
                }
            }
            n == 1
        };
        for least in 0..3000 {
            let expected = (least.max(1)..).find(|&n| smooth(n));
            assert_eq!(Some(fast_length(least)), expected);
        }
        assert_eq!(fast_length((1 << 20) + 1), 1_049_760);
    }
}
