//! Bases under which the pressure is `sqrt(c^2 - x^2)`.

use crate::profile::Profile;

/// `-(c^2 - x^2)^(kappa/2) + b x^2`.
pub(crate) struct Base {
    pub(crate) c: f64,
    pub(crate) bend: f64,
    pub(crate) kappa: f64,
}

impl Base {
    fn layer(&self, r: f64) -> f64 {
        ((self.c - r) * (self.c + r)).max(0.0).powf(0.5 * self.kappa)
    }
}

impl Profile for Base {
    fn height(&self, r: f64) -> [f64; 2] {
        let f = self.bend * r * r - self.layer(r);
        let error = 4.0 * f64::EPSILON * (self.layer(r) + self.bend * r * r);
        [f - error, f + error]
    }

    fn range(&self, [left, right]: [f64; 2]) -> [f64; 2] {
        // It rises with the distance from the middle.
        let (one, two) = (left.abs().min(1.0), right.abs().min(1.0));
        let nearest = if left < 0.0 && right > 0.0 { 0.0 } else { one.min(two) };
        let ends = [nearest, one.max(two)];
        let [[low, _], [_, high]] = ends.map(|r| self.height(r));
        [low, high]
    }

    /// Cauchy's estimate in the circle that reaches half way to the edge.
    fn taylor_bounds(&self, [left, right]: [f64; 2], order: usize) -> Vec<f64> {
        let nearest = if left < 0.0 && right > 0.0 { 0.0 } else { left.abs().min(right.abs()) };
        let (left, right) = (nearest, left.abs().max(right.abs()));
        let distance = if left >= self.c { 1.0 } else { 0.5 * (self.c - right).max(0.0) };
        let largest =
            if left >= self.c { 0.0 } else { (3.0 * self.c * self.c).powf(0.5 * self.kappa) };
        (0..=order)
            .map(|n| {
                let own = if largest == 0.0 { 0.0 } else { largest / distance.powi(n as i32) };
                let parabola = [self.bend, 2.0 * self.bend, self.bend];
                own + parabola.get(n).copied().unwrap_or(0.0)
            })
            .collect()
    }

    fn looks(&self, _: [f64; 2]) -> u64 {
        0
    }
}
