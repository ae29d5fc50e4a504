//! The deformed surface of the body.

use super::Contact;

impl Contact {
    /// Elastic displacement of the body's surface [m] (without the layer) at `x` beside or under the punch, positive into the body:
    /// `theta int ln(a/|x-s|) p(s) ds`, in the gauge of the settlement. In the units of the problem.
    ///
    /// Under the punch it is `delta - alpha x - f - chi p`; outside the integral is taken by a double-exponential rule, whose nodes
    /// crowd towards the near edge.
    #[must_use]
    pub fn elastic_displacement(&self, x: f64) -> f64 {
        let xi = x / self.problem.frame().half_width();
        let scale = self.problem.frame().scaling().map_or(1.0, crate::Scaling::displacement);
        if xi.abs() <= 1.0 {
            return self.correction.evaluate(xi) * scale;
        }
        let gap = xi.abs() - 1.0;
        let potential: f64 = fredholm::quadrature::double_exponential(SURFACE_NODES)
            .map(|node| {
                // Distances from the near edge keep their digits.
                let (near, position) = if xi > 0.0 {
                    (node.from_right, node.position)
                } else {
                    (node.from_left, node.position)
                };
                -node.weight * (gap + near).ln() * self.pressure0(position)
            })
            .sum();
        self.theta0() * potential * scale
    }

    /// Depth of the punch's base [m] at `x` under it: `delta - alpha x - f(x)`, positive into the body.
    #[must_use]
    pub fn base_depth(&self, x: f64) -> f64 {
        let xi = x / self.problem.frame().half_width();
        let scale = self.problem.frame().scaling().map_or(1.0, crate::Scaling::displacement);
        (self.settlement0 - self.tilt0 * xi - self.problem.dimensionless_profile(xi)) * scale
    }
}

/// Half the number of nodes of the rule outside the punch: ten digits, far beyond what a plot shows.
const SURFACE_NODES: usize = 60;
