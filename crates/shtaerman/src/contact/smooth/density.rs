//! The density of a zone as one short series, where the slope of the profile is one: no angles, and many places at once.

/// Points that are summed side by side.
const LANES: usize = 8;
/// Last terms that add up to less than this share of the largest are dropped. At half or twice 2 of 32 answers change, within what they state (survey).
const NEGLIGIBLE: f64 = 0.01 * f64::EPSILON;

/// `G = sum g_k T_k(y)`, `y = cos phi` along the zone.
#[derive(Debug, Clone)]
pub(super) struct Density {
    terms: Vec<f64>,
}

impl Density {
    /// The sum of the part that few modes make and of the terms of the slopes, from `k = 1`, over `-pi`.
    pub(super) fn new(smooth: &[f64], slopes: impl ExactSizeIterator<Item = f64>) -> Self {
        let mut terms = smooth.to_vec();
        terms.resize(smooth.len().max(slopes.len() + 1), 0.0);
        terms[1..].iter_mut().zip(slopes).for_each(|(g, f)| *g -= f / std::f64::consts::PI);
        let largest = terms.iter().fold(0.0f64, |most, g| most.max(g.abs()));
        let mut rest = 0.0;
        let dropped = terms.iter().skip(1).rev().take_while(|g| {
            rest += g.abs();
            rest <= NEGLIGIBLE * largest
        });
        terms.truncate(terms.len() - dropped.count());
        Self { terms }
    }

    /// `G(y)`.
    pub(super) fn at(&self, y: f64) -> f64 {
        self.side_by_side([y])[0]
    }

    /// Puts `G` in the place of each `y`.
    pub(super) fn replace(&self, places: &mut [f64]) {
        let (chunks, rest) = places.as_chunks_mut::<LANES>();
        chunks.iter_mut().for_each(|chunk| *chunk = self.side_by_side(*chunk));
        rest.iter_mut().for_each(|y| *y = self.at(*y));
    }

    /// Clenshaw's recurrence.
    fn side_by_side<const N: usize>(&self, y: [f64; N]) -> [f64; N] {
        let twice = y.map(|y| 2.0 * y);
        let (mut next, mut after) = ([0.0; N], [0.0; N]);
        let (first, others) = self.terms.split_first().unwrap_or((&0.0, &[]));
        for term in others.iter().rev() {
            let sum: [f64; N] =
                std::array::from_fn(|lane| twice[lane] * next[lane] + (term - after[lane]));
            (next, after) = (sum, next);
        }
        std::array::from_fn(|lane| y[lane] * next[lane] + (first - after[lane]))
    }

    /// `sum (pi/k) g_k ratio^k` from `k = 1`: what these terms displace beyond the zone.
    pub(super) fn beyond(&self, ratio: f64) -> f64 {
        let terms = self.terms.iter().enumerate().skip(1).rev();
        let sum = terms.fold(0.0, |sum, (k, term)| ratio * (term / k as f64 + sum));
        std::f64::consts::PI * sum
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn the_series_is_summed_alike_everywhere() {
        let slopes = [0.3, -0.2, 0.0, 0.7];
        let density = Density::new(&[1.5, -2.0], slopes.into_iter());
        let mut many: Vec<f64> = (0..=20).map(|i| f64::from(i) / 10.0 - 1.0).collect();
        let places = many.clone();
        density.replace(&mut many);
        for (y, found) in places.iter().zip(&many) {
            let angle = y.acos();
            let conjugate: f64 =
                slopes.iter().enumerate().map(|(k, f)| f * ((k + 1) as f64 * angle).cos()).sum();
            let exact = 1.5 - 2.0 * y - conjugate / PI;
            assert!((found - exact).abs() < 1e-14, "{y}: {found} {exact}");
            assert_eq!(*found, density.at(*y));
        }
        // Of g_k, pi/k ratio^k.
        let (w, terms) = (-0.4f64, [1.5, -2.0 - 0.3 / PI, 0.2 / PI, 0.0, -0.7 / PI]);
        let exact: f64 = (1..5).map(|k| PI / f64::from(k) * terms[k as usize] * w.powi(k)).sum();
        assert!((density.beyond(w) - exact).abs() < 1e-15);
    }

    #[test]
    fn terms_of_rounding_are_dropped() {
        let density = Density::new(&[1.0, 0.5, 1e-20, -1e-19], [].into_iter());
        assert_eq!(density.terms, [1.0, 0.5]);
    }
}
