//! Mean lines of traces.

/// `height + slope (x - middle)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct MeanLine {
    middle: f64,
    height: f64,
    slope: f64,
}

impl MeanLine {
    pub(super) fn at(self, x: f64) -> f64 {
        self.height + self.slope * (x - self.middle)
    }
}

/// The line of least squares over an interval of the polyline through points: the integrals are exact, so that uneven spacing weighs nothing.
pub(super) fn mean_line(x: &[f64], f: &[f64], over: [f64; 2]) -> MeanLine {
    let pieces = pieces(x, f, over);
    let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else {
        return MeanLine { middle: 0.0, height: 0.0, slope: 0.0 };
    };
    let (left, right) = (first.0[0], last.0[1]);
    let (middle, length) = (left.midpoint(right), right - left);
    let (mut mean, mut moment) = (0.0, 0.0);
    for ([from, to], [start, end]) in pieces {
        let width = to - from;
        let (u, v) = (from - middle, to - middle);
        mean += 0.5 * width * (start + end);
        // int u f du of a straight piece.
        moment += width / 6.0 * (start * (2.0 * u + v) + end * (u + 2.0 * v));
    }
    // int u^2 du over the interval is length^3/12.
    MeanLine { middle, height: mean / length, slope: 12.0 * moment / length.powi(3) }
}

/// Means of `|f - line|` and of its square over an interval, the latter as root.
pub(super) fn deviations(x: &[f64], f: &[f64], over: [f64; 2]) -> [f64; 2] {
    let line = mean_line(x, f, over);
    let (mut absolute, mut square, mut length) = (0.0, 0.0, 0.0);
    for ([from, to], [start, end]) in pieces(x, f, over) {
        let (width, a, b) = (to - from, start - line.at(from), end - line.at(to));
        length += width;
        square += width / 3.0 * (a * a + a * b + b * b);
        absolute += if a * b < 0.0 {
            0.5 * width * (a * a + b * b) / (a.abs() + b.abs())
        } else {
            0.5 * width * (a.abs() + b.abs())
        };
    }
    if length > 0.0 { [absolute / length, (square / length).sqrt()] } else { [0.0, 0.0] }
}

/// The height of the polyline; beyond its ends that of the end.
pub(super) fn between(x: &[f64], f: &[f64], at: f64) -> f64 {
    let after = x.partition_point(|position| *position <= at);
    match (after.checked_sub(1), after < x.len()) {
        (None, _) => f[0],
        (Some(before), false) => f[before],
        (Some(before), true) => {
            let part = (at - x[before]) / (x[after] - x[before]);
            f[before] + part * (f[after] - f[before])
        }
    }
}

/// Ends and heights of the straight pieces within an interval.
fn pieces(x: &[f64], f: &[f64], [left, right]: [f64; 2]) -> Vec<([f64; 2], [f64; 2])> {
    let pairs = x.windows(2).zip(f.windows(2));
    let cut = |(x, f): (&[f64], &[f64])| {
        let (from, to) = (x[0].max(left), x[1].min(right));
        let at = |place: f64| f[0] + (place - x[0]) / (x[1] - x[0]) * (f[1] - f[0]);
        (from < to).then(|| {
            let start = if from == x[0] { f[0] } else { at(from) };
            let end = if to == x[1] { f[1] } else { at(to) };
            ([from, to], [start, end])
        })
    };
    pairs.filter_map(cut).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_line_of_a_line_is_itself_whatever_the_spacing() {
        let x = [-3.0, -2.9, -1.0, 0.5, 0.50001, 2.0, 4.0];
        let f = x.map(|x| 3.0 - 0.25 * x);
        for over in [[-3.0, 4.0], [-2.0, 1.7]] {
            let line = mean_line(&x, &f, over);
            for at in [-3.0, 0.0, 4.0] {
                assert!((line.at(at) - (3.0 - 0.25 * at)).abs() < 1e-14);
            }
            assert!(deviations(&x, &f, over).iter().all(|deviation| *deviation < 1e-14));
        }
    }

    #[test]
    fn a_triangle_has_the_mean_line_and_the_deviations_of_its_integrals() {
        // f = |x| on [-1, 1]: mean 1/2, no slope; |f - 1/2| has the mean 1/4, its square 1/12.
        let (x, f) = ([-1.0, 0.0, 1.0], [1.0, 0.0, 1.0]);
        let line = mean_line(&x, &f, [-1.0, 1.0]);
        assert_eq!([line.at(-1.0), line.at(1.0)], [0.5, 0.5]);
        let [absolute, square] = deviations(&x, &f, [-1.0, 1.0]);
        assert!((absolute - 0.25).abs() < 1e-15 && (square - (1.0f64 / 12.0).sqrt()).abs() < 1e-15);
        assert_eq!([between(&x, &f, -2.0), between(&x, &f, 0.25)], [1.0, 0.25]);
    }
}
