//! Pressure and displacement between the centres of the cells.

use fredholm::complementarity::EqualCells;

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
    /// Pressures next to the edges of the punch, times `theta0`.
    corners: [f64; 2],
    /// `theta0 K p0` without the part of the straight line between these two: means over the cells.
    potential: Vec<f64>,
}

impl Fine {
    pub(super) fn new(
        cells: &EqualCells,
        values: Vec<f64>,
        state: State,
        stiffness: Stiffness,
    ) -> Self {
        let theta = cells.parameter();
        let last = values.len() - 1;
        let corners = [[0, 1], [last, last - 1]].map(|[outer, inner]| {
            let beyond = 1.5 * values[outer] - 0.5 * values[inner];
            if values[outer] > 0.0 { theta * beyond } else { 0.0 }
        });
        let width = 2.0 / values.len() as f64;
        let line = |i: usize| along(corners, (i as f64 + 0.5) * width - 1.0);
        let bent: Vec<f64> = values.iter().enumerate().map(|(i, p)| theta * p - line(i)).collect();
        let potential = cells.potential(&bent);
        Self { zones: Vec::new(), state, stiffness, theta, values, corners, potential }
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

    /// The cubic through the four nearest centres, at the ends of the base the outermost, and what a straight line adds: that has
    /// the `d ln d` of a corner.
    fn interpolated(&self, xi: f64) -> f64 {
        let place = (xi + 1.0) / self.width() - 0.5;
        let first = (place.floor() - 1.0).clamp(0.0, (self.count() - 4) as f64);
        let t = place - first;
        let u = &self.potential[first as usize..first as usize + 4];
        let (a, b, c, d) = (t, t - 1.0, t - 2.0, t - 3.0);
        let cubic = a * (b * (c * u[3] - 3.0 * d * u[2])) + d * (3.0 * a * c * u[1] - b * c * u[0]);
        cubic / 6.0 + straight_potential(self.corners, xi)
    }
}

/// The straight line through its values at -1 and 1.
fn along([left, right]: [f64; 2], xi: f64) -> f64 {
    0.5 * (left * (1.0 - xi) + right * (1.0 + xi))
}

/// `int_{-1}^{1} ln(1/|xi - eta|) l(eta) deta` of that line.
fn straight_potential([left, right]: [f64; 2], xi: f64) -> f64 {
    let ends = [1.0 + xi, 1.0 - xi].map(|distance| distance.max(0.0));
    // int_0^u -ln v dv and int_0^u -v ln v dv
    let [level_left, level_right] = ends.map(|u| if u > 0.0 { u * (1.0 - u.ln()) } else { 0.0 });
    let [arm_left, arm_right] =
        ends.map(|u| if u > 0.0 { u * u * (0.25 - 0.5 * u.ln()) } else { 0.0 });
    along([left, right], xi) * (level_left + level_right)
        + 0.5 * (right - left) * (arm_right - arm_left)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_potential_of_a_smooth_pressure_is_met_between_the_centres() {
        // p = 1 + x/2: the line itself; p = 1 - x^2: by the double-exponential rule.
        let state = State { settlement: 0.0, tilt: 0.0, force: 0.0, moment: 0.0 };
        let stiffness = Stiffness { force_settlement: 0.0, coupling: 0.0, moment_tilt: 0.0 };
        let cells = EqualCells::new(512, 2.0).unwrap();
        let centres = (0..512).map(|i| (f64::from(i) + 0.5) / 256.0 - 1.0);
        let exact = |p: &dyn Fn(f64) -> f64, x: f64| -> f64 {
            let part = |from: f64, to: f64| -> f64 {
                fredholm::quadrature::double_exponential(80)
                    .map(|node| {
                        let distance = 0.5 * (to - from).abs() * node.from_left;
                        let s = from + 0.5 * (to - from) * node.from_left;
                        -0.5 * (to - from).abs() * node.weight * distance.ln() * p(s)
                    })
                    .sum()
            };
            part(x, -1.0) + part(x, 1.0)
        };
        let tests: [(&dyn Fn(f64) -> f64, f64); 2] =
            [(&|x| 1.0 + 0.5 * x, 1e-8), (&|x| 1.0 - x * x, 5e-5)];
        for (p, tolerance) in tests {
            let fine = Fine::new(&cells, centres.clone().map(p).collect(), state, stiffness);
            for i in -20..=20 {
                let x = f64::from(i) / 20.1;
                let found = fine.displacement(x);
                let off = found - 2.0 * exact(p, x);
                assert!(off.abs() < tolerance, "{x}: {found}, off by {off:e}");
                assert!((fine.pressure_at(x, 1.0) + 1.0 + found).abs() < 1e-13, "{x}");
            }
        }
    }
}
