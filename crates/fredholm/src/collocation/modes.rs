//! Sums of partial fractions `sum_k c_k / (1 + lambda nu_k)` for very many `lambda`.

/// Modes with `lambda |nu|` below this share three terms of their geometric series: the fourth is 1e-15 of the first.
const GEOMETRIC: f64 = 1e-5;
/// A mode whose products are below this share of the sums at every `lambda` is dropped.
const NEGLIGIBLE: f64 = 1e-18;

/// `Q` sums over the same modes.
#[derive(Debug, Clone)]
pub(super) struct ModeSums<const Q: usize> {
    eigenvalues: Vec<f64>,
    products: Vec<[f64; Q]>,
    /// Coefficients of `1, lambda, lambda^2` from the merged modes.
    merged: [[f64; Q]; 3],
}

impl<const Q: usize> ModeSums<Q> {
    /// For `lambda` up to `largest`, given each eigenvalue with its products.
    pub(super) fn new(modes: impl Iterator<Item = (f64, [f64; Q])>, largest: f64) -> Self {
        let modes: Vec<(f64, [f64; Q])> = modes.collect();
        let scales: [f64; Q] = std::array::from_fn(|q| {
            modes.iter().map(|(nu, c)| c[q].abs() / (1.0 + largest * nu.abs())).sum()
        });
        let mut sums =
            Self { eigenvalues: Vec::new(), products: Vec::new(), merged: [[0.0; Q]; 3] };
        for (nu, products) in modes {
            let negligible = (0..Q).all(|q| products[q].abs() <= NEGLIGIBLE * scales[q]);
            if negligible {
                continue;
            }
            if largest * nu.abs() < GEOMETRIC {
                for (power, factor) in [1.0, -nu, nu * nu].into_iter().enumerate() {
                    let merged = sums.merged[power].iter_mut().zip(products);
                    merged.for_each(|(sum, product)| *sum += factor * product);
                }
            } else {
                sums.eigenvalues.push(nu);
                sums.products.push(products);
            }
        }
        sums
    }

    /// Number of modes that are summed one by one.
    pub(super) fn count(&self) -> usize {
        self.eigenvalues.len()
    }

    /// The sums at `L` parameters at once, which the compiler turns into vector instructions.
    #[inline(always)]
    pub(super) fn at<const L: usize>(&self, parameters: &[f64; L]) -> [[f64; L]; Q] {
        let mut sums = [[0.0; L]; Q];
        let [constant, linear, square] = &self.merged;
        for (q, sums) in sums.iter_mut().enumerate() {
            for (sum, parameter) in sums.iter_mut().zip(parameters) {
                *sum = constant[q] + parameter * (linear[q] + parameter * square[q]);
            }
        }
        for (nu, products) in self.eigenvalues.iter().zip(&self.products) {
            let mut fractions = [0.0; L];
            for lane in 0..L {
                fractions[lane] = 1.0 / (1.0 + parameters[lane] * nu);
            }
            for q in 0..Q {
                for lane in 0..L {
                    sums[q][lane] += products[q] * fractions[lane];
                }
            }
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn merged_and_dropped_modes_do_not_show() {
        let modes: Vec<(f64, [f64; 2])> = (0..40)
            .map(|k| {
                let decay = 10f64.powi(-k / 2);
                (decay, [decay, 1e-9 + decay * decay])
            })
            .collect();
        let sums = ModeSums::new(modes.iter().copied(), 1e4);
        assert!(sums.count() < modes.len());
        let parameters = [0.0, 1e-3, 1.0, 1e4];
        let found = sums.at(&parameters);
        for q in 0..2 {
            for (lane, parameter) in parameters.iter().enumerate() {
                let exact: f64 = modes.iter().map(|(nu, c)| c[q] / (1.0 + parameter * nu)).sum();
                assert!((found[q][lane] - exact).abs() < 1e-14 * exact, "{q} {parameter}");
            }
        }
    }
}
