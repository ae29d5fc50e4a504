//! Bilateral contact by the degenerate kernel, sections 2 and 3.

use fredholm::basis::ChebyshevSeries;
use fredholm::kernel::Logarithm;
use fredholm::{DegenerateSolution, DegenerateSolver};

use super::balance::Balance;
use super::solved::{Contact, Stiffness};
use super::warning::{Warning, WarningCode};
use crate::quantity::{Dimension, engineering};
use crate::{Error, Problem};

/// The answers of the equation to the right-hand sides `1`, `xi` and `f0`, (3.6).
struct Responses<'k> {
    level: DegenerateSolution<'k, Logarithm>,
    tilted: DegenerateSolution<'k, Logarithm>,
    profile: DegenerateSolution<'k, Logarithm>,
}

impl Problem {
    /// Solves the problem by the degenerate kernel: closed-form Gram matrix (3.4), even and odd systems (3.10) and (3.11), symmetric
    /// positive form, Cholesky or, for many terms, conjugate gradients with fast products.
    ///
    /// # Errors
    /// [`Error::ProfileNotFinite`] where the profile is not finite; [`Error::Equation`] when the system does not fit into memory;
    /// [`Error::Overflow`] when the answer is not finite.
    pub fn solve(&self) -> Result<Contact, Error> {
        let kernel = Logarithm::unit();
        let theta0 = self.frame().theta0();
        let degree = self.solver().degree;
        let function = self.resolved_profile()?;
        let solver = DegenerateSolver::new(&kernel, theta0, degree)?;
        let power =
            |coefficients: &[f64]| ChebyshevSeries::new(coefficients.to_vec()).moments(degree + 1);
        let responses = Responses {
            level: solver.solve(&power(&[1.0]))?,
            tilted: solver.solve(&power(&[0.0, 1.0]))?,
            profile: solver.solve(&function.series().moments(degree + 1))?,
        };
        let mut contact = responses.contact(self);
        contact.require_finite()?;
        contact.describe_pressure();
        if !function.is_resolved() {
            contact.warnings.push(unresolved(function.error()));
        }
        if (degree as f64) < theta0 {
            contact.warnings.push(low_degree(degree, theta0));
        }
        Ok(contact)
    }
}

impl Responses<'_> {
    fn contact(&self, problem: &Problem) -> Contact {
        let balance = Balance {
            stiffness: Stiffness {
                force_settlement: self.level.projections()[0],
                coupling: self.tilted.projections()[0],
                moment_tilt: self.tilted.projections()[1],
            },
            free: [self.profile.projections()[0], self.profile.projections()[1]],
        };
        let state = balance.state(&problem.dimensionless_load());
        let correction = (self.level.correction().iter())
            .zip(self.tilted.correction())
            .zip(self.profile.correction())
            .map(|((level, tilted), profile)| {
                state.settlement * level - state.tilt * tilted - profile
            })
            .collect();
        Contact {
            problem: problem.clone(),
            force0: state.force,
            moment0: state.moment,
            settlement0: state.settlement,
            tilt0: state.tilt,
            stiffness0: balance.stiffness,
            correction: ChebyshevSeries::new(correction),
            peak: (0.0, 0.0),
            tension: Vec::new(),
            warnings: Vec::new(),
        }
    }
}

impl Contact {
    fn describe_pressure(&mut self) {
        let (peak, tension) = {
            let sampled = self.sampled();
            (sampled.maximum(), sampled.negative())
        };
        self.peak = (peak.value, peak.place);
        self.tension = tension;
        self.warnings.extend(Warning::negative_pressure(self.problem.frame(), &self.tension));
    }
}

fn unresolved(error: f64) -> Warning {
    let message = format!(
        "the profile is not resolved to rounding (a kink, a jump, fast oscillation, or a formula that loses digits): its expansion is \
         off by about {error:.1e} of its largest value (estimate)"
    );
    Warning { code: WarningCode::ProfileNotResolved, message }
}

fn low_degree(degree: usize, theta0: f64) -> Warning {
    let message = format!(
        "n = {degree} is below theta0 = {}: the boundary layers at the edges are not resolved and edge pressures may have no \
         digit; take n of several times theta0",
        engineering(theta0, Dimension::NONE)
    );
    Warning { code: WarningCode::LowDegree, message }
}
