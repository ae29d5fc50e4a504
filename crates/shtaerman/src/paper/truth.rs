//! The true figures, by the method that shares nothing with the paper's.

use fredholm::SincOperator;
use fredholm::kernel::Logarithm;

use super::{Base, FORCE0, MOMENT0, theta0};
use crate::Error;

/// Half the number of collocation nodes: thirteen digits up to `lambda0 = 100`.
const HALF_COUNT: usize = 80;

/// Sinc collocation of the logarithmic kernel.
pub(super) struct Truth {
    operator: SincOperator,
}

/// The true solution for one row.
pub(super) struct Exact {
    responses: Vec<fredholm::SincSolution>,
    lambda0: f64,
    base: Base,
    settlement: f64,
    tilt: f64,
    level_moment: f64,
}

impl Truth {
    pub(super) fn new() -> Result<Self, Error> {
        Ok(Self { operator: SincOperator::new(&Logarithm::unit(), HALF_COUNT)? })
    }

    pub(super) fn solve(&self, lambda0: f64, base: Base) -> Result<Exact, Error> {
        let sample = |f: &dyn Fn(f64) -> f64| self.operator.positions().map(f).collect();
        let sides = [sample(&|_| 1.0), sample(&|xi| xi), sample(&|xi| lambda0 * base.at(xi))];
        let responses = self.operator.solve(theta0(lambda0), &sides)?;
        let [one, xi, f] = &responses[..] else {
            unreachable!("three right-hand sides give three solutions")
        };
        let settlement = (FORCE0 + f.integral(|_| 1.0)) / one.integral(|_| 1.0);
        let tilt = -(MOMENT0 + f.integral(|x| x)) / xi.integral(|x| x);
        let level_moment = -f.integral(|x| x);
        Ok(Exact { responses, lambda0, base, settlement, tilt, level_moment })
    }
}

impl Exact {
    /// `delta0` and `alpha0` under the force and moment of sec. 5.
    pub(super) fn displacements(&self) -> [f64; 2] {
        [self.settlement, self.tilt]
    }

    /// `delta0` and `M0` of the level punch.
    pub(super) fn level(&self) -> [f64; 2] {
        [self.settlement, self.level_moment]
    }

    /// `p0(xi)`.
    pub(super) fn pressure(&self, xi: f64) -> f64 {
        self.settlement * self.responses[0].evaluate(xi, 1.0)
            - self.tilt * self.responses[1].evaluate(xi, xi)
            - self.responses[2].evaluate(xi, self.lambda0 * self.base.at(xi))
    }
}
