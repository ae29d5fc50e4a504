//! Newton steps that go back and forth.

/// Steps that are left alone: several edges that depend on each other may well turn at first.
const UNDAMPED: usize = 12;
/// A step back of more than this share of the step before is no convergence.
const BACK: f64 = 0.3;
/// So many steps cut at the same bound show that the bound does not hold any more, as other edges have moved.
const CUTS: usize = 4;

/// Where an edge is, and what the layer says there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Edge {
    pub(super) at: f64,
    /// 1 where the zone lies on the left, -1 where it lies on the right.
    pub(super) outwards: f64,
    /// Displacement of the layer, or the density of a smooth pressure: below zero where the edge lies too far out.
    pub(super) layer: f64,
}

/// Shortens the steps of each edge while they turn: at a kink of the base the pressure at an edge has two slopes, and Newton's method may leap from side to side, or
/// circle between the two.
#[derive(Debug, Default)]
pub(super) struct Damping {
    before: Vec<f64>,
    factors: Vec<f64>,
    bounds: Vec<Bounds>,
    count: usize,
}

/// The outermost place of an edge known to be too far in, and the innermost too far out, both measured outwards.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    inner: f64,
    outer: f64,
    cuts: usize,
}

impl Bounds {
    const NONE: Self = Self { inner: f64::NEG_INFINITY, outer: f64::INFINITY, cuts: 0 };

    /// Learns from an edge.
    fn learn(&mut self, edge: Edge) {
        let here = edge.outwards * edge.at;
        if edge.layer > 0.0 {
            self.inner = here;
            if self.outer <= here {
                self.outer = f64::INFINITY;
            }
        } else {
            self.outer = here;
            if self.inner >= here {
                self.inner = f64::NEG_INFINITY;
            }
        }
    }

    /// The step outwards from an edge just learnt from, or one that goes to where the layer points and stays between the bounds.
    fn kept(&mut self, edge: Edge, step: f64) -> f64 {
        let here = edge.outwards * edge.at;
        let ahead = if edge.layer > 0.0 { self.outer } else { self.inner };
        let room = ahead - here;
        if !ahead.is_finite() || (step * room > 0.0 && step.abs() < room.abs()) {
            self.cuts = 0;
            return step;
        }
        self.cuts += 1;
        if self.cuts > CUTS {
            *self = Self::NONE;
            return step;
        }
        0.5 * room
    }
}

impl Damping {
    /// Steps to the right of edges, each with its place.
    pub(super) fn damped(&mut self, mut steps: Vec<f64>, edges: &[Edge]) -> Vec<f64> {
        self.count += 1;
        if steps.len() != self.before.len() {
            self.before = vec![0.0; steps.len()];
            self.factors = vec![1.0; steps.len()];
            self.bounds = vec![Bounds::NONE; steps.len()];
        }
        let turning = self.count > UNDAMPED;
        for (((step, before), factor), (bounds, edge)) in (steps.iter_mut())
            .zip(&mut self.before)
            .zip(&mut self.factors)
            .zip(self.bounds.iter_mut().zip(edges))
        {
            let turns = turning && *step * *before < 0.0 && step.abs() > BACK * before.abs();
            *factor = if turns { 0.5 * *factor } else { (2.0 * *factor).min(1.0) };
            *step *= *factor;
            bounds.learn(*edge);
            if turning && *step != 0.0 {
                *step = edge.outwards * bounds.kept(*edge, edge.outwards * *step);
            }
            *before = *step;
        }
        steps
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn newton_steps_across_a_kink_converge() {
        // From either side the step to the root of the other side's slope is twice too long.
        let step = |x: f64| -2.0 * x;
        let (mut plain, mut damped, mut damping) = (0.1f64, 0.1f64, Damping::default());
        for _ in 0..80 {
            let edge = Edge { at: damped, outwards: 1.0, layer: -damped };
            plain += step(plain);
            damped += damping.damped(vec![step(damped)], &[edge])[0];
        }
        assert!(plain.abs() > 0.09 && damped.abs() < 1e-9, "{plain} {damped}");
    }

    #[test]
    fn newton_steps_that_circle_about_a_kink_converge() {
        // Inside the kink at 0 the layer is nearly level, beyond it falls: from beyond 0 concave steps fall back inside, from there they leap far out.
        for outwards in [1.0, -1.0] {
            let root = 0.01f64;
            let layer = |u: f64| {
                if u < 0.0 { 0.1 - 0.01 * u } else { 0.1 * (1.0 - (u / root).sqrt()) }
            };
            let slope = |u: f64| if u < 0.0 { -0.01 } else { -0.05 / (u * root).sqrt() };
            let newton = |u: f64| -layer(u) / slope(u);
            let (mut plain, mut damped, mut damping) = (0.5f64, 0.5f64, Damping::default());
            for _ in 0..60 {
                plain += newton(plain);
                let edge = Edge { at: outwards * damped, outwards, layer: layer(damped) };
                damped += outwards * damping.damped(vec![outwards * newton(damped)], &[edge])[0];
            }
            assert!((plain - root).abs() > 1e-3, "{plain}");
            assert!((damped - root).abs() < 1e-12, "{damped}");
        }
    }

    #[test]
    fn a_bound_that_moves_is_left() {
        // The root moves outwards after bounds were learnt.
        let (mut at, mut damping) = (0.0f64, Damping::default());
        for count in 0..60 {
            let root = if count < 20 { 0.5 } else { 2.0 };
            let edge = Edge { at, outwards: 1.0, layer: root - at };
            at += damping.damped(vec![1.7 * (root - at)], &[edge])[0];
        }
        assert!((at - 2.0).abs() < 1e-9, "{at}");
    }
}
