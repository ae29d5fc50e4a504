//! Transforms against their sums.

use std::f64::consts::{PI, TAU};

use fredholm_transforms::{Complex, PackedTransform, Planner, cosine_sums, fast_length};

fn input(count: usize) -> Vec<f64> {
    (0..count).map(|j| (2.3 * j as f64 + 0.4).cos() + 0.1).collect()
}

#[test]
fn type_one_agrees_with_the_sum() {
    for n in [1usize, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 20, 45, 64, 100, 255, 256] {
        let x = input(n + 1);
        let mut found = x.clone();
        cosine_sums(&mut found);
        for (k, found) in found.into_iter().enumerate() {
            let exact: f64 = (0..=n)
                .map(|j| {
                    let share = if j == 0 || j == n { 0.5 } else { 1.0 };
                    share * x[j] * (PI * ((j * k) % (2 * n)) as f64 / n as f64).cos()
                })
                .sum();
            assert!((found - exact).abs() < 2e-15 * n as f64, "n = {n}, k = {k}");
        }
    }
    cosine_sums(&mut []);
    cosine_sums(&mut [1.0]);
}

#[test]
fn type_one_is_its_own_inverse_up_to_half_the_degree() {
    for n in [1usize << 17, 3 * 5 * 4096, 30_001] {
        let x = input(n + 1);
        let mut back = x.clone();
        cosine_sums(&mut back);
        cosine_sums(&mut back);
        for (x, back) in x.iter().zip(back) {
            assert!((back / (0.5 * n as f64) - x).abs() < 4e-15, "n = {n}");
        }
    }
}

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

fn sequence(length: usize) -> Vec<f64> {
    (0..length).map(|j| (1.7 * j as f64 + 0.3).sin() + 0.2).collect()
}

fn packed(sequence: &[f64]) -> Vec<Complex> {
    sequence.chunks(2).map(|pair| Complex::new(pair[0], pair[1])).collect()
}

#[test]
fn the_packed_transform_agrees_with_the_sum() {
    for half in [1, 2, 3, 4, 5, 9, 30, 64] {
        let transform = PackedTransform::new(&mut Planner::new(), half);
        let x = sequence(2 * half);
        let mut buffer = packed(&x);
        transform.forward(&mut buffer, &mut transform.scratch());
        let sum = |k: usize| -> Complex {
            let angle = |j: usize| -TAU * ((j * k) % (2 * half)) as f64 / (2 * half) as f64;
            x.iter().enumerate().map(|(j, x)| Complex::from_polar(*x, angle(j))).sum()
        };
        let mut visited = 0;
        transform.visit(&buffer, |k, low, high| {
            visited += 1;
            assert!((low - sum(k)).norm() < 1e-13 * half as f64);
            assert!((high - sum(half - k)).norm() < 1e-13 * half as f64);
        });
        assert_eq!(visited, half / 2 + 1);
    }
}

#[test]
fn what_is_filtered_by_nothing_comes_back() {
    for half in [1, 2, 3, 4, 5, 9, 30, 64, 1000] {
        let transform = PackedTransform::new(&mut Planner::new(), half);
        let x = sequence(2 * half);
        let mut buffer = packed(&x);
        let mut scratch = transform.scratch();
        transform.forward(&mut buffer, &mut scratch);
        transform.filter(&mut buffer, |_, low, high| (low, high));
        transform.backward(&mut buffer, &mut scratch);
        for (pair, back) in x.chunks(2).zip(buffer) {
            assert!((pair[0] - back.re / half as f64).abs() < 1e-14);
            assert!((pair[1] + back.im / half as f64).abs() < 1e-14);
        }
    }
}
