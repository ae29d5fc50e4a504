//! The largest pressure between all places.

use crate::panel::Panel;
use crate::sample::range_on;

/// Most halvings of a panel.
const HALVINGS: usize = 24;
/// Bounds on parts of a panel are no sharper than so many units of the machine, whatever is allowed.
const ROUNDED: f64 = 128.0;

/// An upper bound of the pressure on panels, at most about `allowed` above its largest value.
pub(crate) fn highest(panels: &[Panel], allowed: f64) -> f64 {
    let at_nodes = panels.iter().flat_map(Panel::at_nodes);
    let mut known = at_nodes.fold(f64::NEG_INFINITY, f64::max);
    let largest = panels.iter().fold(0.0f64, |most, panel| most.max(panel.largest));
    let allowed = allowed.max(ROUNDED * f64::EPSILON * largest);
    let mut bound = known;
    for panel in panels {
        if panel.coefficients[0] + panel.swing <= known {
            continue;
        }
        let negative = Panel::new(panel.left, panel.right, panel.coefficients.map(|c| -c));
        let mut stack = vec![(panel.left, panel.right, 0)];
        while let Some((left, right, depth)) = stack.pop() {
            let upper = -range_on(&negative, left, right)[0];
            let middle = 0.5 * (left + right);
            // The largest value may lie between the nodes, or at an end: what is found on the way tells what need not be looked at.
            known =
                [left, middle, right].iter().fold(known, |most, x| most.max(panel.evaluate(*x)));
            let is_done = upper <= known + allowed || depth == HALVINGS;
            if is_done || middle <= left || middle >= right {
                bound = bound.max(upper);
            } else {
                stack.push((left, middle, depth + 1));
                stack.push((middle, right, depth + 1));
            }
        }
    }
    bound.max(known)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::legendre::{ORDER, RULE};

    #[test]
    fn the_largest_value_lies_between_the_nodes() {
        // 2 - (x - c)^2 on panels that do not know c.
        for c in [-0.9, -0.31, 0.5, 0.777] {
            let panels: Vec<Panel> = [[-1.0, -0.4], [-0.4, 0.5], [0.5, 1.0]]
                .iter()
                .map(|[left, right]| {
                    let mut values = [0.0; ORDER];
                    for (value, t) in values.iter_mut().zip(&RULE.nodes) {
                        let x = 0.5 * (left + right) + 0.5 * (right - left) * t;
                        *value = 2.0 - (x - c) * (x - c);
                    }
                    Panel::new(*left, *right, RULE.expand(&values))
                })
                .collect();
            for allowed in [1e-3, 1e-9, 1e-13] {
                let found = highest(&panels, allowed);
                assert!((2.0..=2.0 + allowed + 2e-13).contains(&found), "{c}: {found}");
            }
        }
    }
}
