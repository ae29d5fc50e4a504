//! The slope of a profile on a zone as series on a few panels, which cost less than the profile itself.

use super::super::legendre::{ORDER, RULE, series};

/// Panels are halved at most this often.
const DEEPEST: u32 = 3;
/// Difference over the largest value that is none.
const AGREED: f64 = 8.0 * f64::EPSILON;

/// A function on panels.
pub(super) struct Resolved {
    panels: Vec<Panel>,
}

struct Panel {
    ends: [f64; 2],
    coefficients: Vec<f64>,
}

impl Panel {
    fn new(f: &impl Fn(f64) -> f64, [from, to]: [f64; 2]) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut coefficients: Vec<f64> =
            RULE.coefficients(&RULE.nodes.map(|u| f(middle + half * u))).to_vec();
        let size = coefficients.iter().fold(0.0f64, |most, c| most.max(c.abs()));
        // The rounding of a coefficient grows with its number.
        let rounding = |n: usize| f64::EPSILON * (n as f64 + 1.0) * size;
        while coefficients.last().is_some_and(|c| c.abs() <= rounding(coefficients.len())) {
            coefficients.pop();
        }
        Self { ends: [from, to], coefficients }
    }

    fn at(&self, x: f64) -> f64 {
        let [from, to] = self.ends;
        series(&self.coefficients, ((x - from - (to - x)) / (to - from)).clamp(-1.0, 1.0))
    }

    /// Whether the function is met at the nodes of both halves.
    fn meets(&self, f: &impl Fn(f64) -> f64) -> bool {
        let [from, to] = self.ends;
        let quarter = 0.25 * (to - from);
        let places = (0..2 * ORDER).map(|i| {
            let middle = if i < ORDER { from + quarter } else { to - quarter };
            middle + quarter * RULE.nodes[i % ORDER]
        });
        let (mut size, mut worst) = (0.0f64, 0.0f64);
        for x in places {
            let value = f(x);
            size = size.max(value.abs());
            let difference = (value - self.at(x)).abs();
            if difference.is_nan() {
                return false;
            }
            worst = worst.max(difference);
        }
        worst <= AGREED * size
    }
}

impl Resolved {
    /// Between increasing cuts; none if the function is not resolved by few panels.
    pub(super) fn new(f: &impl Fn(f64) -> f64, cuts: &[f64]) -> Option<Self> {
        let mut panels = Vec::new();
        for pair in cuts.windows(2) {
            add(f, [pair[0], pair[1]], DEEPEST, &mut panels)?;
        }
        Some(Self { panels })
    }

    pub(super) fn at(&self, x: f64) -> f64 {
        let next = self.panels.partition_point(|panel| panel.ends[1] < x);
        let panel = self.panels.get(next).or(self.panels.last());
        panel.map_or(f64::NAN, |panel| panel.at(x))
    }
}

fn add(
    f: &impl Fn(f64) -> f64,
    [from, to]: [f64; 2],
    depth: u32,
    panels: &mut Vec<Panel>,
) -> Option<()> {
    let panel = Panel::new(f, [from, to]);
    if panel.meets(f) {
        panels.push(panel);
        return Some(());
    }
    let (middle, depth) = (0.5 * (from + to), depth.checked_sub(1)?);
    add(f, [from, middle], depth, panels)?;
    add(f, [middle, to], depth, panels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_functions_are_met_and_others_refused() {
        let f = |x: f64| (3.0 * x).sin() + if x < 0.2 { 0.0 } else { 1.0 };
        let resolved = Resolved::new(&f, &[-1.0, 0.2, 1.0]).unwrap();
        for i in 0..200 {
            let x = -1.0 + 0.01 * f64::from(i);
            if (x - 0.2).abs() > 1e-9 {
                assert!((resolved.at(x) - f(x)).abs() < 4e-15, "{x}");
            }
        }
        assert!(Resolved::new(&f, &[-1.0, 1.0]).is_none());
        assert!(Resolved::new(&f64::sqrt, &[0.0, 1.0]).is_none());
        assert!(Resolved::new(&|_| f64::NAN, &[0.0, 1.0]).is_none());
        assert_eq!(Resolved::new(&|_| 0.0, &[0.0, 1.0]).unwrap().at(0.3), 0.0);
    }
}
