//! Newton steps that go back and forth.

/// Steps that are left alone: several edges that depend on each other may well turn at first.
const UNDAMPED: usize = 12;
/// A step back of more than this share of the step before is no convergence.
const BACK: f64 = 0.3;

/// Shortens the steps of each edge while they turn: at a kink of the base the pressure at an edge has two slopes, and Newton's method may leap from side to side.
#[derive(Debug, Default)]
pub(super) struct Damping {
    before: Vec<f64>,
    factors: Vec<f64>,
    count: usize,
}

impl Damping {
    pub(super) fn damped(&mut self, mut steps: Vec<f64>) -> Vec<f64> {
        self.count += 1;
        if steps.len() != self.before.len() {
            self.before = vec![0.0; steps.len()];
            self.factors = vec![1.0; steps.len()];
        }
        for ((step, before), factor) in
            steps.iter_mut().zip(&mut self.before).zip(&mut self.factors)
        {
            let turns =
                self.count > UNDAMPED && *step * *before < 0.0 && step.abs() > BACK * before.abs();
            *factor = if turns { 0.5 * *factor } else { (2.0 * *factor).min(1.0) };
            *step *= *factor;
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
            plain += step(plain);
            damped += damping.damped(vec![step(damped)])[0];
        }
        assert!(plain.abs() > 0.09 && damped.abs() < 1e-9, "{plain} {damped}");
    }
}
