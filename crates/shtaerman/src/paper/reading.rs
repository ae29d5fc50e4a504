//! The paper's own computation, its slips included.

use fredholm::kernel::{Logarithm, SpectralRelation};
use fredholm::{DegenerateSystem, basis::chebyshev};

use super::{Base, FORCE0, MOMENT0, theta0};
use crate::Error;

/// System (3.5) solved for one row of a table.
pub(super) struct Reading {
    degree: usize,
    theta0: f64,
    /// `a_m X_m^(j)`, `j = 1, 2, 3`.
    weighted: [Vec<f64>; 3],
    /// `int p_j`, `int xi p_j` of the three responses.
    forces: [f64; 3],
    moments: [f64; 3],
}

impl Reading {
    /// Solves (3.5) with `f0 = lambda0 base` and highest degree `degree`.
    pub(super) fn new(lambda0: f64, base: Base, degree: usize) -> Result<Self, Error> {
        let kernel = Logarithm::unit();
        let theta0 = theta0(lambda0);
        let system = DegenerateSystem::new(&kernel, theta0, degree)?;
        let respond = |f: &dyn Fn(f64) -> f64| -> Result<Vec<f64>, Error> {
            Ok(system.solve(&kernel.moments(f, degree + 1)?.values).projections().to_vec())
        };
        let responses =
            [respond(&|_| 1.0)?, respond(&|xi| xi)?, respond(&|xi| lambda0 * base.at(xi))?];
        let forces = [0, 1, 2].map(|j| responses[j][0]);
        let moments = [0, 1, 2].map(|j| responses[j][1]);
        let weighted = responses
            .map(|x| x.iter().enumerate().map(|(m, x)| kernel.expansion_factor(m) * x).collect());
        Ok(Self { degree, theta0, weighted, forces, moments })
    }

    /// `delta0` and `alpha0` from (3.7) with the force and moment of sec. 5.
    pub(super) fn displacements(&self) -> [f64; 2] {
        // The two parities decouple: force and level base are even, moment and tilt odd.
        let settlement = (FORCE0 + self.forces[2]) / self.forces[0];
        let tilt = -(MOMENT0 + self.moments[2]) / self.moments[1];
        [settlement, tilt]
    }

    /// `delta0` and `M0` of the level punch, (5.1).
    pub(super) fn level(&self) -> [f64; 2] {
        [(FORCE0 + self.forces[2]) / self.forces[0], -self.moments[2]]
    }

    /// (3.8) as printed: without `-f0`, and with `alpha0` in place of `theta0` in the second bracket.
    pub(super) fn pressure_as_printed(&self, xi: f64) -> f64 {
        let [settlement, tilt] = self.displacements();
        let [level, tilted, base] = [0, 1, 2].map(|j| chebyshev::sum(&self.weighted[j], xi));
        (1.0 - self.theta0 * level) * settlement - (xi - tilt * tilted) * tilt + self.theta0 * base
    }

    /// Highest degree kept.
    pub(super) fn degree(&self) -> usize {
        self.degree
    }
}
