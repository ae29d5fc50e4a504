//! Pressure and displacement between the centres of the cells.

use crate::contact::balance::State;
use crate::contact::solved::Stiffness;
use crate::contact::unilateral::zones::Zone;

/// A contact on equal cells.
#[derive(Debug, Clone)]
pub(in crate::contact::unilateral) struct Fine {
    pub(in crate::contact::unilateral) zones: Vec<Zone>,
    pub(in crate::contact::unilateral) state: State,
    pub(in crate::contact::unilateral) stiffness: Stiffness,
    theta: f64,
    /// Mean pressures.
    values: Vec<f64>,
    /// `theta0 K p0` of these, means over the cells.
    potential: Vec<f64>,
}

impl Fine {
    pub(super) fn new(
        theta: f64,
        values: Vec<f64>,
        potential: Vec<f64>,
        state: State,
        stiffness: Stiffness,
    ) -> Self {
        Self { zones: Vec::new(), state, stiffness, theta, values, potential }
    }

    pub(in crate::contact::unilateral) fn count(&self) -> usize {
        self.values.len()
    }

    pub(super) fn width(&self) -> f64 {
        2.0 / self.count() as f64
    }

    /// Largest mean pressure.
    pub(in crate::contact::unilateral) fn largest(&self) -> f64 {
        self.values.iter().fold(0.0, |most, p| most.max(*p))
    }

    /// `delta0 - alpha0 xi - f0 - theta0 K p0` on the base, given the height: the pressure in a zone, minus the gap beside.
    pub(in crate::contact::unilateral) fn pressure_at(&self, xi: f64, height: f64) -> f64 {
        self.state.settlement - self.state.tilt * xi - height - self.interpolated(xi)
    }

    /// `theta0 int ln(1/|xi - eta|) p0(eta) deta` at any place.
    pub(in crate::contact::unilateral) fn displacement(&self, xi: f64) -> f64 {
        if xi.abs() <= 1.0 {
            return self.interpolated(xi);
        }
        let width = self.width();
        let centre = |i: usize| (i as f64 + 0.5) * width - 1.0;
        let sum: f64 =
            self.values.iter().enumerate().map(|(i, p)| -(xi - centre(i)).abs().ln() * p).sum();
        self.theta * width * sum
    }

    /// Whether the place lies in a zone.
    pub(super) fn touches(&self, xi: f64) -> bool {
        let after = self.zones.partition_point(|zone| zone.right() < xi);
        self.zones.get(after).is_some_and(|zone| zone.left() <= xi)
    }

    /// Distance to the nearest edge of a zone.
    pub(super) fn distance_to_edge(&self, xi: f64) -> f64 {
        let after = self.zones.partition_point(|zone| zone.right() < xi);
        let near = after.saturating_sub(1)..(after + 2).min(self.zones.len());
        self.zones[near]
            .iter()
            .flat_map(|zone| [zone.left(), zone.right()])
            .fold(2.0, |least, at| least.min((at - xi).abs()))
    }

    /// The cubic through the four nearest centres; at the ends of the base the outermost.
    fn interpolated(&self, xi: f64) -> f64 {
        let place = (xi + 1.0) / self.width() - 0.5;
        let first = (place.floor() - 1.0).clamp(0.0, (self.count() - 4) as f64);
        let t = place - first;
        let u = &self.potential[first as usize..first as usize + 4];
        let (a, b, c, d) = (t, t - 1.0, t - 2.0, t - 3.0);
        (a * (b * (c * u[3] - 3.0 * d * u[2])) + d * (3.0 * a * c * u[1] - b * c * u[0])) / 6.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cubics_are_kept_between_the_centres() {
        let cubic = |x: f64| 1.0 + x * (2.0 - x * (0.5 + 3.0 * x));
        let potential: Vec<f64> =
            (0..16).map(|i| cubic((f64::from(i) + 0.5) / 8.0 - 1.0)).collect();
        let state = State { settlement: 0.0, tilt: 0.0, force: 0.0, moment: 0.0 };
        let stiffness = Stiffness { force_settlement: 0.0, coupling: 0.0, moment_tilt: 0.0 };
        let fine = Fine::new(1.0, vec![0.0; 16], potential, state, stiffness);
        for i in -20..=20 {
            let x = f64::from(i) / 20.0;
            assert!((fine.displacement(x) - cubic(x)).abs() < 1e-13, "{x}");
            assert!((fine.pressure_at(x, 1.0) + 1.0 + cubic(x)).abs() < 1e-13, "{x}");
        }
    }
}
