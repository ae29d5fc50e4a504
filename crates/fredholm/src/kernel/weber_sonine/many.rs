//! The kernel between one point and many others, with all logarithms at once.

use super::coefficients::Coefficients;
use super::dyadic::polynomials;
use super::value::Tables;
use crate::linear::vectorised;
use crate::special::logarithms;

/// Points that are taken at once.
const CHUNK: usize = 64;

/// Points beside one that is not 0, none of them 0 either: room that is filled again and again, as moving it takes as long as the kernel.
struct Chunk {
    count: usize,
    /// The larger of the two.
    larger: [f64; CHUNK],
    /// The smaller one as a share of it, and the root of that.
    shares: [f64; CHUNK],
    roots: [f64; CHUNK],
    /// The distance over the larger one, and `delta^2/4`.
    apart: [f64; CHUNK],
    quarters: [f64; CHUNK],
    /// `ln` of the larger one, and `|ln(x/s)|`; of no meaning where nobody asks for them.
    heights: [f64; CHUNK],
    ratios: [f64; CHUNK],
}

impl Chunk {
    fn empty() -> Self {
        const NOTHING: [f64; CHUNK] = [0.0; CHUNK];
        Self {
            count: 0,
            larger: NOTHING,
            shares: NOTHING,
            roots: NOTHING,
            apart: NOTHING,
            quarters: NOTHING,
            heights: NOTHING,
            ratios: NOTHING,
        }
    }

    fn fill(&mut self, x: f64, points: &[f64], distances: &[f64], has_logarithms: bool) {
        let count = points.len();
        self.count = count;
        vectorised(
            #[inline(always)]
            || {
                for (k, (s, distance)) in points.iter().zip(distances).enumerate() {
                    let (larger, smaller) = (x.max(*s), x.min(*s));
                    self.larger[k] = larger;
                    self.shares[k] = smaller / larger;
                    self.roots[k] = self.shares[k].sqrt();
                    self.apart[k] = distance / larger;
                    self.quarters[k] = 0.25 * self.apart[k] * (distance / smaller);
                }
            },
        );
        if has_logarithms {
            let (heights, ratios) = (&mut self.heights[..count], &mut self.ratios[..count]);
            heights.copy_from_slice(&self.larger[..count]);
            ratios.copy_from_slice(&self.shares[..count]);
            logarithms(heights);
            logarithms(ratios);
            ratios.iter_mut().for_each(|ratio| *ratio = -*ratio);
        }
    }
}

impl Tables {
    /// `W` between one point and many others, and the factors where those are wanted.
    pub(super) fn many(
        &self,
        x: f64,
        (points, distances): (&[f64], &[f64]),
        values: &mut [f64],
        mut factors: Option<&mut [f64]>,
    ) {
        let mut room = Chunk::empty();
        for (chunk, values) in values.chunks_mut(CHUNK).enumerate() {
            let part = chunk * CHUNK..chunk * CHUNK + values.len();
            let factors = factors.as_deref_mut().map(|all| &mut all[part.clone()]);
            let (points, distances) = (&points[part.clone()], &distances[part]);
            if x > 0.0 && points.iter().all(|s| *s > 0.0) {
                self.some(x, (points, distances), values, factors, &mut room);
                continue;
            }
            let mut unwanted = [0.0; CHUNK];
            let factors = factors.unwrap_or(&mut unwanted);
            let results = values.iter_mut().zip(factors);
            for ((s, distance), (value, factor)) in points.iter().zip(distances).zip(results) {
                let pair = self.pair(x, *s, *distance);
                (*value, *factor) = (pair.value, pair.factor);
            }
        }
    }

    fn some(
        &self,
        x: f64,
        (points, distances): (&[f64], &[f64]),
        values: &mut [f64],
        factors: Option<&mut [f64]>,
        chunk: &mut Chunk,
    ) {
        let Coefficients { order, exponent, .. } = self.coefficients;
        let is_scaled = order != 0.0 || exponent != 0.0;
        chunk.fill(x, points, distances, factors.is_some() || is_scaled);
        let chunk = &*chunk;
        let mut series = [0.0; CHUNK];
        self.near(chunk, &mut series, values);
        vectorised(
            #[inline(always)]
            || {
                let mut start = 0;
                while start < chunk.count {
                    let near = |k: &usize| self.is_near(chunk.quarters[*k]);
                    let end = (start..chunk.count).find(near).unwrap_or(chunk.count);
                    for (k, value) in (start..end).zip(&mut values[start..end]) {
                        *value = chunk.apart[k] * (1.0 + chunk.shares[k]);
                    }
                    self.far.evaluate_all(&mut values[start..end]);
                    for (k, value) in (start..end).zip(&mut values[start..end]) {
                        *value = self.far_strength * *value / chunk.larger[k];
                    }
                    start = end + 1;
                }
            },
        );
        if is_scaled {
            for (k, value) in values.iter_mut().enumerate() {
                if !self.is_near(chunk.quarters[k]) {
                    *value *= (-2.0 * exponent * chunk.heights[k] - order * chunk.ratios[k]).exp();
                }
            }
        }
        values.iter_mut().for_each(|value| *value = value.min(f64::MAX));
        if let Some(factors) = factors {
            self.factors(chunk, &series, factors);
        }
    }

    fn is_near(&self, quarter: f64) -> bool {
        quarter <= self.near_limit
    }

    /// The values next to the diagonal, and the series `F_1` there. Those points lie together, as points are in order.
    fn near(&self, chunk: &Chunk, series: &mut [f64; CHUNK], values: &mut [f64]) {
        let quarters = &chunk.quarters[..chunk.count];
        let Some(first) = quarters.iter().position(|quarter| self.is_near(*quarter)) else {
            return;
        };
        let last = quarters.iter().rposition(|quarter| self.is_near(*quarter)).unwrap_or(first);
        let near = first..last + 1;
        let mut sizes = [1.0; CHUNK];
        let mut differences = [0.0; CHUNK];
        vectorised(
            #[inline(always)]
            || {
                for k in near.clone() {
                    // |x - s|/sqrt(x s)
                    sizes[k] = chunk.apart[k] / chunk.roots[k];
                    (series[k], differences[k]) = (chunk.quarters[k], chunk.quarters[k]);
                }
                polynomials(&self.near, &mut series[near.clone()]);
                polynomials(&self.difference, &mut differences[near.clone()]);
            },
        );
        logarithms(&mut sizes[near.clone()]);
        let Coefficients { exponent, shift, .. } = self.coefficients;
        let q = 2.0 * exponent;
        for k in near {
            let logarithm = sizes[k] + shift;
            let (sigma, power) = if exponent == 0.0 {
                (-logarithm, 1.0)
            } else {
                let middle = chunk.heights[k] - 0.5 * chunk.ratios[k];
                ((-q * logarithm).exp_m1() / q, (-q * middle).exp())
            };
            let sum = series[k] * sigma + differences[k];
            values[k] = self.near_strength * power * sum / (chunk.larger[k] * chunk.roots[k]);
        }
    }

    /// The factors, and zero where the cutoff is.
    fn factors(&self, chunk: &Chunk, series: &[f64; CHUNK], factors: &mut [f64]) {
        let (mut cutoffs, mut functions) = ([0.0; CHUNK], [0.0; CHUNK]);
        let reach = self.cutoff.reach();
        vectorised(
            #[inline(always)]
            || {
                for k in 0..chunk.count {
                    let (height, ratio) = (chunk.heights[k], chunk.ratios[k]);
                    cutoffs[k] = self.cutoff.place(ratio, self.radius - height + 0.5 * ratio);
                    functions[k] = ratio / reach;
                }
                self.cutoff.at_places(&mut cutoffs[..chunk.count]);
                // Points beside the diagonal lie together, as points are in order.
                let is_kept = |cutoff: &f64| *cutoff != 0.0;
                let first = cutoffs.iter().position(is_kept).unwrap_or(0);
                let last = cutoffs.iter().rposition(is_kept).map_or(first, |last| last + 1);
                self.factor.evaluate_all(&mut functions[first..last]);
            },
        );
        let Coefficients { order, strength, .. } = self.coefficients;
        for (k, factor) in factors.iter_mut().enumerate() {
            if cutoffs[k] == 0.0 {
                *factor = 0.0;
                continue;
            }
            let function = if self.is_near(chunk.quarters[k]) {
                series[k] / chunk.roots[k]
            } else if order == 0.0 {
                functions[k]
            } else {
                functions[k] * (order * chunk.ratios[k]).exp()
            };
            let value = strength * cutoffs[k] * function / chunk.larger[k];
            *factor = value.clamp(-f64::MAX, f64::MAX);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_points_have_the_values_of_each() {
        for (order, exponent) in [(0.0, 0.0), (1.0, 0.0), (0.0, 0.2), (1.0, 0.4), (2.5, -0.3)] {
            let tables = Tables::new(1.0, order, exponent);
            let mut points = vec![0.0, 1e-200, 1e-9, 0.3 + 1e-12, 0.31];
            points.extend((1..200).map(|i| f64::from(i) / 160.0));
            points.sort_by(f64::total_cmp);
            for x in [0.0, 1e-220, 0.3, 0.312, 1.7] {
                let points: Vec<f64> = points.iter().copied().filter(|s| *s != x).collect();
                let distances: Vec<f64> = points.iter().map(|s| (x - s).abs()).collect();
                let [mut values, mut alone, mut factors] =
                    [(); 3].map(|()| vec![0.0; points.len()]);
                let given = (&points[..], &distances[..]);
                tables.many(x, given, &mut values, Some(&mut factors));
                tables.many(x, given, &mut alone, None);
                assert_eq!(values, alone);
                for (k, (s, distance)) in points.iter().zip(&distances).enumerate() {
                    let pair = tables.pair(x, *s, *distance);
                    let off =
                        (values[k] - pair.value).abs() / pair.value.abs().max(f64::MIN_POSITIVE);
                    // Powers with exponents of some hundreds lose as many units.
                    assert!(
                        off < 2e-15 * (1.0 + (x / s).ln().abs()),
                        "{order} {exponent} {x} {s}: {off:e}"
                    );
                    let off = (factors[k] - pair.factor).abs();
                    assert!(
                        off <= 2e-13 * pair.factor.abs(),
                        "{order} {exponent} {x} {s}: {off:e}"
                    );
                }
            }
        }
    }
}
