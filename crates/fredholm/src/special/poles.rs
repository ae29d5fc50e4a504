//! Sums over simple poles on a line.

use crate::linear::vectorised;

/// Numbers that are worked on side by side.
const LANES: usize = 4;

/// `sum c/a`, `sum c/a^2` and, where `CUBES`, `sum c/a^3` over poles `s` with strengths `c`, `a = x + i y - s`: real and imaginary part of each. As many poles as the shorter list has, up to the last
/// four that are whole; a place on a pole gives what `1/0` makes of it.
#[must_use]
pub fn pole_sums<const CUBES: bool>(
    poles: &[f64],
    strengths: &[f64],
    [x, y]: [f64; 2],
) -> [f64; 6] {
    vectorised(
        #[inline(always)]
        || {
            let mut sums = [[0.0; LANES]; 6];
            let height = y * y;
            let chunks = poles.chunks_exact(LANES).zip(strengths.chunks_exact(LANES));
            for (poles, strengths) in chunks {
                for lane in 0..LANES {
                    let distance = x - poles[lane];
                    let inverse = 1.0 / (distance * distance + height);
                    let (re, im) = (distance * inverse, -y * inverse);
                    let strength = strengths[lane];
                    let (square_re, square_im) = (re * re - im * im, 2.0 * re * im);
                    sums[0][lane] += strength * re;
                    sums[1][lane] += strength * im;
                    sums[2][lane] += strength * square_re;
                    sums[3][lane] += strength * square_im;
                    if CUBES {
                        sums[4][lane] += strength * (square_re * re - square_im * im);
                        sums[5][lane] += strength * (square_re * im + square_im * re);
                    }
                }
            }
            sums.map(|lanes| lanes.iter().sum())
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poles_at_whole_numbers_sum_to_the_cotangent() {
        // sum 1/(z - k) = pi cot(pi z), of squares pi^2/sin^2(pi z), of cubes pi^3 cot/sin^2; far poles add what an integral does.
        use std::f64::consts::PI;
        let count = 200_000;
        let poles: Vec<f64> = (-count..count).map(|k| f64::from(k) + 0.5).collect();
        let strengths = vec![1.0; poles.len()];
        let (x, y) = (0.3, 0.2);
        let found = pole_sums::<true>(&poles, &strengths, [x, y]);
        // tan of a complex number: poles lie between the whole numbers, -pi tan(pi z).
        let (sine, cosine) = (2.0 * PI * x).sin_cos();
        let below = cosine + (2.0 * PI * y).cosh();
        let tangent = [sine / below, (2.0 * PI * y).sinh() / below];
        let square = [1.0 + tangent[0].powi(2) - tangent[1].powi(2), 2.0 * tangent[0] * tangent[1]];
        let cube = [
            tangent[0] * square[0] - tangent[1] * square[1],
            tangent[0] * square[1] + tangent[1] * square[0],
        ];
        let exact = [
            -PI * tangent[0],
            -PI * tangent[1],
            PI.powi(2) * square[0],
            PI.powi(2) * square[1],
            -PI.powi(3) * cube[0],
            -PI.powi(3) * cube[1],
        ];
        for (found, exact) in found.into_iter().zip(exact) {
            assert!((found - exact).abs() < 2e-5, "{found} {exact}");
        }
        let plain = pole_sums::<false>(&poles, &strengths, [x, y]);
        assert_eq!((plain[..4].to_vec(), plain[4..].to_vec()), (found[..4].to_vec(), vec![0.0; 2]));
    }
}
