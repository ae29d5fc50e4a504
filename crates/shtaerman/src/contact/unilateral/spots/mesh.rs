//! Panels of the zones: cut where the profile bends, and ever shorter towards the ends of the zones.

use crate::contact::unilateral::base::Base;
use crate::contact::unilateral::zones::Zone;

/// Length of a panel over its distance from a free end of its zone, and from a corner.
const GROWTH: f64 = 2.0;
const CORNER_GROWTH: f64 = 1.0;
/// Longest panels: of the base, and in units of the length `1/theta0` of the layer.
const LONGEST: f64 = 1.0 / 32.0;
const LAYER: f64 = 0.1;
/// The panel at a free end, where the pressure goes on as `d^2 ln d`: the square of its length over that of the zone, in lengths of the layer. In longer zones than this the
/// slope of the pressure at the end has nothing to do with their length.
const FREE: f64 = 1e-4;
const LONG: f64 = 1.0 / 16.0;
/// The panel at a corner, where it goes on as `d ln d`, in lengths of the layer.
const CORNER: f64 = 1e-10;
/// Shortest panels, over the distance from the middle of the base.
const SHORTEST: f64 = 1e-14;
/// Rounding of lengths that are just right.
const SLACK: f64 = 1.0 + 1e-6;
/// Most halvings of a panel on which the profile is no polynomial, and the deviation relative to its size that is none.
const HALVINGS: u32 = 12;
const STRAIGHT: f64 = 1e-14;

/// How fine the panels are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fineness {
    /// Nodes of a panel.
    pub(super) order: usize,
    /// Factor of the lengths of the panels at the ends of zones.
    pub(super) ends: f64,
}

/// The panels of all zones from left to right; none where they are too many.
pub(super) fn panels(
    base: &Base<'_>,
    joints: &[f64],
    zones: &[Zone],
    fineness: Fineness,
    most: usize,
) -> Option<Vec<[f64; 2]>> {
    let mut panels = Vec::new();
    let is_measured = base.problem.profile().measured_points().is_some();
    for zone in zones {
        let inside = joints.partition_point(|at| *at <= zone.left())
            ..joints.partition_point(|at| *at < zone.right());
        let mut left = zone.left();
        for right in joints[inside].iter().copied().chain([zone.right()]) {
            // Beside a joint by rounding there is no panel.
            if right - left > SHORTEST || right == zone.right() {
                let mut pieces = vec![[left, right]];
                if !is_measured {
                    pieces = resolved(base, [left, right], fineness.order);
                }
                for piece in pieces {
                    graded(base, zone, piece, fineness, &mut panels);
                }
                left = right;
            }
        }
        if panels.len() * fineness.order > most {
            return None;
        }
    }
    Some(panels)
}

/// Cuts a piece so that its parts grow with their distances from the ends of the zone.
fn graded(
    base: &Base<'_>,
    zone: &Zone,
    piece: [f64; 2],
    fineness: Fineness,
    panels: &mut Vec<[f64; 2]>,
) {
    let layer = 1.0 / base.theta.max(1.0);
    let [shortest, growth] = [0, 1].map(|what| {
        zone.ends.map(|end| {
            let least = if end.is_free {
                (FREE * zone.length().min(LONG) * layer).sqrt()
            } else {
                CORNER * layer
            };
            let growth = if end.is_free { GROWTH } else { CORNER_GROWTH };
            if what == 0 { (fineness.ends * least).max(SHORTEST) } else { growth }
        })
    });
    let longest = LONGEST.min(LAYER * layer);
    let mut left_to_do = vec![piece];
    while let Some([left, right]) = left_to_do.pop() {
        let length = right - left;
        let allowed = |side: usize| {
            let distance = if side == 0 { left - zone.left() } else { zone.right() - right };
            (growth[side] * distance).max(shortest[side])
        };
        let cut = if length > SLACK * allowed(0) && allowed(0) <= allowed(1) {
            zone.left() + (right - zone.left()) / (1.0 + growth[0])
        } else if length > SLACK * allowed(1) {
            zone.right() - (zone.right() - left) / (1.0 + growth[1])
        } else if length > longest {
            0.5 * (left + right)
        } else {
            right
        };
        if cut > left && cut < right {
            left_to_do.extend([[cut, right], [left, cut]]);
        } else {
            panels.push([left, right]);
        }
    }
}

/// Halves of a piece until the profile is a polynomial on each.
fn resolved(base: &Base<'_>, piece: [f64; 2], order: usize) -> Vec<[f64; 2]> {
    let mut pieces = Vec::new();
    let mut left_to_do = vec![(piece, 0)];
    while let Some(([left, right], halvings)) = left_to_do.pop() {
        let middle = 0.5 * (left + right);
        let is_long = right - left > LONGEST;
        if halvings < HALVINGS && (is_long || !is_polynomial(base, [left, right], order)) {
            left_to_do.extend([([middle, right], halvings + 1), ([left, middle], halvings + 1)]);
        } else {
            pieces.push([left, right]);
        }
    }
    pieces
}

/// Whether the polynomial through so many Chebyshev points shows the profile between them.
fn is_polynomial(base: &Base<'_>, [left, right]: [f64; 2], order: usize) -> bool {
    let place = |y: f64| base.height(0.5 * (left + right) + 0.5 * (right - left) * y);
    let points: Vec<f64> = (0..order)
        .map(|k| (std::f64::consts::PI * (k as f64 + 0.5) / order as f64).cos())
        .collect();
    let heights: Vec<f64> = points.iter().map(|y| place(*y)).collect();
    let largest = heights.iter().fold(0.0f64, |most, f| most.max(f.abs()));
    [-0.97, -0.6, 0.13, 0.71, 0.99].into_iter().all(|y| {
        let (mut above, mut below) = (0.0, 0.0);
        for (k, (point, height)) in points.iter().zip(&heights).enumerate() {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let weight = sign * (1.0 - point * point).sqrt() / (y - point);
            above += weight * height;
            below += weight;
        }
        (above / below - place(y)).abs() <= STRAIGHT * largest * order as f64
    })
}
