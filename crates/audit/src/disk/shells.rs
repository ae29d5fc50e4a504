//! Potentials of tests, slow and simple: Gauss and Legendre's rule on shells that shrink to the place, with no singularity taken out.

use super::kernel::Harmonic;
use crate::legendre::{RULE, evaluate};
use crate::panel::Panel;

/// Each shell about a place ends at this share of its distance: the nodes integrate what is singular there to `3^-48`.
const SHRINK: f64 = 0.25;
/// What is nearer to the place is taken by the leading term of the kernel, which is off by this times the change of the pressure on its way from 0 to the radius.
const ROUNDING: f64 = 1e-34;
/// Beside the axis shells end at this share of the kernel, and here, so that powers stay in range.
const SHALLOW: f64 = 1e-17;
const SMALLEST: f64 = 1e-150;

/// `int K_m(r, s) q(s) s ds` of some panels.
pub(super) fn potential(kernel: &Harmonic, mu: f64, panels: &[Panel], r: f64) -> f64 {
    let mut sum = 0.0;
    for panel in panels {
        let distance = (panel.left - r).max(r - panel.right);
        if distance < 0.0 {
            sum += shells(kernel, mu, panel, (r, -1.0), [0.0, r - panel.left]);
            sum += shells(kernel, mu, panel, (r, 1.0), [0.0, panel.right - r]);
        } else {
            let side = if panel.left >= r { 1.0 } else { -1.0 };
            let far = distance + 2.0 * panel.half();
            sum += shells(kernel, mu, panel, (r, side), [distance, far]);
        }
    }
    sum
}

/// The part of a panel on one side of the place, between these distances.
fn shells(
    kernel: &Harmonic,
    mu: f64,
    panel: &Panel,
    (r, side): (f64, f64),
    [near, far]: [f64; 2],
) -> f64 {
    let least =
        (r * ROUNDING.powf(1.0 / (2.0 - mu))).max(SHALLOW.powf(1.0 / (1.0 - mu)).max(SMALLEST));
    let [nearer, first] = if side > 0.0 { [panel.left, -1.0] } else { [panel.right, 1.0] };
    let start = if near > 0.0 { first - (nearer - r) / panel.half() } else { panel.own(r) };
    let at = |d: f64| {
        // At the axis rounding may step beyond it.
        let s = (r + side * d).max(0.0);
        // The place on the panel from that of r, as s itself is rounded.
        let own = (start + side * d / panel.half()).clamp(-1.0, 1.0);
        s * evaluate(&panel.coefficients, own) * kernel.value(r, s, d)
    };
    let (mut sum, mut outer) = (0.0, far);
    while outer > near {
        if near == 0.0 && outer <= least {
            // int_0^h d^-mu = h^(1-mu)/(1-mu), int_0^h -ln d = h (1 - ln h), the logarithm over r.
            let rest = if mu == 0.0 { panel.evaluate(r) } else { 0.0 };
            return sum + outer * (at(outer) / (1.0 - mu) + rest);
        }
        let inner = (SHRINK * outer).max(near);
        let (middle, half) = (0.5 * (inner + outer), 0.5 * (outer - inner));
        for (t, weight) in RULE.nodes.iter().zip(&RULE.weights) {
            sum += half * weight * at(middle + half * t);
        }
        outer = inner;
    }
    sum
}
