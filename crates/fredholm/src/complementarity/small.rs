//! One or two conditions in the metric of a preconditioner.

use crate::linear::dot;

/// Rows `c_k`, their images `M^-1 c_k`, and the inverse of `c_k . M^-1 c_l`.
#[derive(Debug, Clone, Default)]
pub(super) struct Conditions {
    images: Vec<Vec<f64>>,
    /// Entries 11, 12, 22 of the inverse.
    inverse: [f64; 3],
}

impl Conditions {
    /// `None` where the conditions depend on each other, or are more than two.
    #[allow(clippy::needless_pass_by_value, reason = "rows and images belong together")]
    pub(super) fn new(rows: Vec<Vec<f64>>, images: Vec<Vec<f64>>) -> Option<Self> {
        let gram = |k: usize, l: usize| dot(&rows[k], &images[l]);
        let inverse = match rows.len() {
            0 => [0.0; 3],
            1 => [1.0 / gram(0, 0), 0.0, 0.0],
            2 => {
                let (a, b, c) = (gram(0, 0), gram(0, 1), gram(1, 1));
                let determinant = a * c - b * b;
                if determinant <= 1e-13 * a * c {
                    return None;
                }
                [c / determinant, -b / determinant, a / determinant]
            }
            _ => return None,
        };
        inverse.iter().all(|entry| entry.is_finite()).then_some(Self { images, inverse })
    }

    /// The combination of images that adds these values to the conditions.
    pub(super) fn solve(&self, values: &[f64]) -> Vec<f64> {
        let [a, b, c] = self.inverse;
        match values {
            [one] => vec![a * one],
            [one, two] => vec![a * one + b * two, b * one + c * two],
            _ => Vec::new(),
        }
    }

    pub(super) fn add_images(&self, shares: &[f64], target: &mut [f64]) {
        for (image, share) in self.images.iter().zip(shares) {
            target.iter_mut().zip(image).for_each(|(value, part)| *value += share * part);
        }
    }
}
