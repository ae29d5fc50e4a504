//! Free edges, and by how much they move for what the layer answers beside them.

use fredholm::quadrature::gauss_graded;

use super::linearised::Known;
use super::nodes::Field;
use super::solved::{BESIDE, Solved};
use super::surface::Surface;
use crate::contact::accuracy::{ROUNDING, SAFETY};
use crate::contact::zones::Zone;

/// By how much a free edge moves outwards for what the layer answers there.
pub(super) struct Edge {
    /// What the layer answers, over `-dv/dxi` outwards.
    moved: [f64; 3],
    /// What that changed by when it was looked at from nearer.
    change: [f64; 3],
    /// `-dv/dxi` outwards.
    slope: f64,
    /// What `moved` is not known to beside that, relative to it.
    noise: f64,
}

impl Edge {
    /// By how much it moves outwards, and what that is off by where what the layer answers is by `noise`.
    pub(super) fn moved_by(&self, of: &impl Fn(&[f64; 3]) -> f64, noise: f64) -> [f64; 2] {
        let moved = of(&self.moved);
        let off = noise / self.slope.abs() + of(&self.change).abs() / SAFETY;
        [moved, off + moved.abs() * self.noise]
    }

    /// What it is not known to when the punch settles, relative to that.
    fn doubt(&self) -> f64 {
        self.noise + (self.change[1] / self.moved[1]).abs() / SAFETY
    }
}

/// Nodes of means beside an edge, where what the layer answers goes on as powers of the distance from -1/2 to 0: they leave less than `NODES^-4`.
const NODES: usize = 20;

/// The length of a zone and of its panel at an end, the side, where it ends there and where its panels do.
struct FreeEnd {
    length: f64,
    panel: f64,
    side: usize,
    at: f64,
    end: f64,
}

impl<F: Field> Known<'_, F> {
    /// The free edges with `dv/dxi = -alpha0 - f0' - theta0 k int dK/dxi p0 dm`, as the pressure vanishes there.
    pub(super) fn edges(&self, solved: &Solved<F>, surface: &Surface) -> Vec<Edge> {
        let zones = &solved.nodes.zones;
        let (layer, off) = (solved.at_ends.layer, solved.ends_off());
        let (exponent, rounding) = (solved.ground.exponent(), solved.rounding());
        // Where the layer is thin the slope changes within a length 1/theta0: beside an end that is off as the logarithm of the distance, on graded ground as a power of it, and so does what the layer answers.
        let left = |slope: f64| {
            if exponent == 0.0 {
                return rounding - 2.0 * f64::EPSILON.ln() * layer;
            }
            let off = off.max(rounding / slope.abs()).max(f64::EPSILON);
            off.powf(-exponent) * (rounding + SAFETY * SAFETY * layer)
        };
        let of_layer = solved.strength * solved.layer.slope(solved.deepest());
        // On graded ground a sum over nodes leaves out what presses nearer to the edge than places are rounded, up to some of them.
        let is_graded = exponent > 0.0 && F::RATIO.is_some();
        let unseen = SAFETY * of_layer * f64::EPSILON.powf(1.0 - exponent) / (1.0 - exponent);
        let beyond = if is_graded { unseen } else { 0.0 };
        let edge = |(free, [body, added]): (FreeEnd, [f64; 2])| {
            let FreeEnd { length, side, at, end, .. } = free;
            let (tilt, profile) = (solved.state.tilt, surface.slope(at));
            let size = tilt.abs() + profile.abs() + added;
            let slope = -tilt - profile - body;
            let slope = if side == 0 { -slope } else { slope };
            // In a short zone it changes with the place itself.
            let bent = SAFETY * off / length * slope.abs();
            let noise = (ROUNDING * size + of_layer * left(slope) + bent) / slope.abs();
            let moved = self.layer(end).map(|layer| -layer / slope);
            let near = Edge { moved, change: [0.0; 3], slope: -slope, noise: noise + beyond };
            let afar = is_graded.then(|| self.seen_from_afar(solved, surface, &free)).flatten();
            afar.filter(|afar| afar.doubt() < near.doubt()).unwrap_or(near)
        };
        // What the layer answers ends with its panels, beside which it changes as a power of the distance.
        let of_zone = |zone: &Zone| {
            let (length, ends) = (zone.length(), zone.ends);
            let own = solved.nodes.panels_of(zone);
            let panels = [own.start, own.end.saturating_sub(1)].map(|k| solved.nodes.panels.get(k));
            zone.free_ends().map(move |(side, at)| {
                let [left, right] = *panels[side].unwrap_or(&ends);
                let end = if panels[side].is_none() { at } else { [left, right][side] };
                FreeEnd { length, panel: right - left, side, at, end }
            })
        };
        let ends: Vec<FreeEnd> = zones.iter().flat_map(of_zone).collect();
        let slopes = solved.slopes(&ends.iter().map(|free| free.at).collect::<Vec<_>>());
        ends.into_iter().zip(slopes).map(edge).collect()
    }

    /// A free edge of a zone on graded ground, looked at from a distance.
    ///
    /// `dv/dxi` solves the same equation as what the layer answers, `g + theta0 K(p'(v) g) = -alpha0 - f0'`, so that beside the edge both are multiples of one function of the distance, but for their product with the distance
    /// over the length of the panel. Where the layer is thin that function changes down to distances far below the rounding of places, where no nodes are: nothing is known of either at the edge itself. Up to a distance `D` the
    /// integral of the one over that of the other, `v(D)`, is by how much the edge moves, and what goes with `D` is taken away by that up to `2 D`. On a disk `dv/dr` has the kernel of the next harmonic, which is as singular.
    fn seen_from_afar(&self, solved: &Solved<F>, surface: &Surface, end: &FreeEnd) -> Option<Edge> {
        let &FreeEnd { panel, side, at, .. } = end;
        let inwards = if side == 0 { 1.0 } else { -1.0 };
        let near_axis = if solved.ground.is_disk() { at.abs() } else { f64::INFINITY };
        let length = panel.min(near_axis);
        let layer_at = |d: f64| {
            let xi = at + inwards * d;
            solved.layer_at(xi, surface.height(xi))
        };
        let (rounding, beside) = (solved.rounding(), BESIDE * length);
        let off = solved.ends_off().max(rounding * beside / layer_at(beside)).max(f64::EPSILON);
        // There as little is left by it as by the square of the distance.
        let distance = (off * length * length).cbrt().min(beside);
        let rule = gauss_graded(NODES).ok()?;
        let moved = |distance: f64| {
            let mut sums = [0.0; 3];
            for node in &rule {
                let layer = self.layer(at + inwards * distance * node.from_left);
                sums = [0, 1, 2].map(|k| sums[k] + distance * node.weight * layer[k]);
            }
            sums.map(|sum| sum / layer_at(distance))
        };
        let [near, far] = [moved(distance), moved(2.0 * distance)];
        let share = distance / length;
        Some(Edge {
            moved: [0, 1, 2].map(|k| 2.0 * near[k] - far[k]),
            change: [0, 1, 2].map(|k| near[k] - far[k]),
            slope: layer_at(distance) / distance,
            noise: SAFETY * (share * share + off / distance)
                + (NODES as f64).powi(-4)
                + rounding / layer_at(distance).abs(),
        })
    }
}
