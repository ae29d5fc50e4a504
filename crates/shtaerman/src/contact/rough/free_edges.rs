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

    /// Whether another one agrees with it: what is said of an edge from nearby has to, as sums over nodes beside it may be anything where the pressure is off.
    fn holds(&self, other: &Self) -> bool {
        (0..self.moved.len()).all(|k| {
            let apart = (other.moved[k] - self.moved[k]).abs();
            apart <= SAFETY * (self.change[k].abs() + self.noise * self.moved[k].abs())
        })
    }

    /// What it is not known to when the punch settles, relative to that.
    fn doubt(&self) -> f64 {
        self.noise + (self.change[1] / self.moved[1]).abs() / SAFETY
    }
}

/// Nodes of means beside an edge, where what the layer answers goes on as powers of the distance from -1/2 to 0: they leave less than `NODES^-4`.
const NODES: usize = 20;

/// A free end of a zone, on this side of it.
struct FreeEnd {
    /// The length of the zone.
    length: f64,
    /// How far from the end the base does not bend.
    reach: f64,
    /// The distance of the nearest node.
    nearest: f64,
    side: usize,
    at: f64,
    /// Where its panels end.
    end: f64,
    /// What the pressure that is nearer than the nearest node changes of the slope of the layer, and of what it answers, on graded ground, as a share.
    unseen: f64,
}

/// By what, at most, the pressure adds to the slope of the layer, and what rounding leaves of that layer.
type Scales = [f64; 2];

impl FreeEnd {
    fn of_zone<F: Field>(solved: &Solved<F>, zone: &Zone, scales: Scales) -> Vec<Self> {
        let own = solved.nodes.panels_of(zone);
        let count = solved.nodes.a_panel();
        let nodes = &solved.nodes.places[own.start * count..own.end * count];
        let mut panels = solved.nodes.panels[own].to_vec();
        let length = zone.length();
        let of = |(side, at): (usize, f64)| {
            if side == 1 {
                panels.reverse();
            }
            let end = panels.first().map_or(at, |panel| panel[side]);
            let node = if side == 0 { nodes.first() } else { nodes.last() };
            let nearest = node.map_or(length, |node| (node - at).abs()).max(f64::EPSILON);
            // Panels of collocation are cut where the base bends, others get longer until it does.
            let mut lengths = panels.iter().map(|[left, right]| right - left).peekable();
            let mut last = lengths.next().unwrap_or(length);
            let mut reach = last;
            while F::RATIO.is_none()
                && let Some(next) = lengths.next_if(|next| *next >= last)
            {
                (reach, last) = (reach + next, next);
            }
            let power = 1.0 - solved.ground.exponent();
            let unseen = if power < 1.0 { scales[0] * nearest.powf(power) / power } else { 0.0 };
            Self { length, reach, nearest, side, at, end, unseen }
        };
        zone.free_ends().map(of).collect()
    }
}

impl<F: Field> Known<'_, F> {
    /// The free edges with `dv/dxi = -alpha0 - f0' - theta0 k int dK/dxi p0 dm`, as the pressure vanishes there.
    pub(super) fn edges(&self, solved: &Solved<F>, surface: &Surface) -> Vec<Edge> {
        let of_layer = solved.strength * solved.layer.slope(solved.deepest());
        let scales = [of_layer, solved.rounding()];
        let of_zone = |zone: &Zone| FreeEnd::of_zone(solved, zone, scales);
        let ends: Vec<FreeEnd> = solved.nodes.zones.iter().flat_map(of_zone).collect();
        let slopes = solved.slopes(&ends.iter().map(|end| end.at).collect::<Vec<_>>());
        let edge = |(end, slope): (&FreeEnd, [f64; 2])| {
            let near = self.seen_from_nearby(solved, surface, end, (slope, scales));
            if solved.ground.exponent() == 0.0 {
                return near;
            }
            let afar = self.seen_from_afar(solved, surface, end, scales);
            afar.filter(|afar| afar.doubt() < near.doubt() || !afar.holds(&near)).unwrap_or(near)
        };
        ends.iter().zip(slopes).map(edge).collect()
    }

    /// A free edge by the slope there, which the pressure adds to, and by what the layer answers where its panels end, beside which that changes as a power of the distance.
    fn seen_from_nearby(
        &self,
        solved: &Solved<F>,
        surface: &Surface,
        end: &FreeEnd,
        ([body, added], [of_layer, rounding]): ([f64; 2], Scales),
    ) -> Edge {
        let (layer, off) = (solved.at_ends.layer, solved.ends_off());
        let exponent = solved.ground.exponent();
        let (tilt, profile) = (solved.state.tilt, surface.slope(end.at));
        let size = tilt.abs() + profile.abs() + added;
        let slope = -tilt - profile - body;
        let slope = if end.side == 0 { -slope } else { slope };
        // Where the layer is thin the slope changes within a length 1/theta0: beside an end that is off as the logarithm of the distance, on graded ground as a power of it, and so does what the layer answers.
        let left = if exponent == 0.0 {
            rounding - 2.0 * f64::EPSILON.ln() * layer
        } else {
            let off = off.max(rounding / slope.abs()).max(f64::EPSILON);
            off.powf(-exponent) * (rounding + SAFETY * SAFETY * layer)
        };
        // In a short zone it changes with the place itself.
        let bent = SAFETY * off / end.length * slope.abs();
        let noise = (ROUNDING * size + of_layer * left + bent) / slope.abs();
        let moved = self.layer(end.end).map(|layer| -layer / slope);
        // Sums over nodes leave that out; polynomials on panels miss as much, which adds to potentials by as much again.
        let unseen = end.unseen.powi(if F::RATIO.is_none() { 2 } else { 1 });
        Edge { moved, change: [0.0; 3], slope: -slope, noise: noise + SAFETY * unseen }
    }

    /// A free edge of a zone on graded ground, looked at from a distance.
    ///
    /// `dv/dxi` solves the same equation as what the layer answers, `g + theta0 K(p'(v) g) = -alpha0 - f0'`, so that beside the edge both are multiples of one function of the distance, but for their product with the distance
    /// over that of the next bend. Where the layer is thin that function changes down to distances far below the rounding of places, where no nodes are: nothing is known of either at the edge itself. Up to a distance `D` the
    /// integral of the one over that of the other, `v(D)`, is by how much the edge moves, and what goes with `D` is taken away by that up to `2 D`. On a disk `dv/dr` has the kernel of the next harmonic, which is as singular.
    fn seen_from_afar(
        &self,
        solved: &Solved<F>,
        surface: &Surface,
        end: &FreeEnd,
        [_, rounding]: Scales,
    ) -> Option<Edge> {
        let &FreeEnd { reach, nearest, side, at, .. } = end;
        let inwards = if side == 0 { 1.0 } else { -1.0 };
        let near_axis = if solved.ground.is_disk() { at.abs() } else { f64::INFINITY };
        let length = reach.min(near_axis);
        let layer_at = |d: f64| {
            let xi = at + inwards * d;
            solved.layer_at(xi, surface.height(xi))
        };
        let beside = BESIDE * length;
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
        // What the layer answers goes on as -1/2 of the distance at most.
        let unseen = end.unseen.min(1.0) * (nearest / distance).sqrt();
        Some(Edge {
            moved: [0, 1, 2].map(|k| 2.0 * near[k] - far[k]),
            change: [0, 1, 2].map(|k| near[k] - far[k]),
            slope: layer_at(distance) / distance,
            noise: SAFETY * (share * share + off / distance + unseen)
                + (NODES as f64).powi(-4)
                + rounding / layer_at(distance).abs(),
        })
    }
}
