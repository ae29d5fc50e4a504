//! Bilateral contact by the degenerate kernel, sections 2 and 3.

use fredholm::basis::ChebyshevSeries;
use fredholm::kernel::Logarithm;
use fredholm::{DegenerateSolution, DegenerateSystem};

use super::contact::{Contact, Stiffness};
use super::warning::{Warning, WarningCode};
use crate::{Error, Load, Problem, Rotational, Vertical};

/// The answers of the equation to the right-hand sides `1`, `xi` and `f0`, (3.6).
struct Responses<'k> {
    level: DegenerateSolution<'k, Logarithm>,
    tilted: DegenerateSolution<'k, Logarithm>,
    profile: DegenerateSolution<'k, Logarithm>,
}

impl Problem {
    /// Solves the problem by the degenerate kernel: closed-form Gram matrix (3.4), even and odd systems (3.10) and (3.11), symmetric
    /// positive form, Cholesky.
    ///
    /// # Errors
    /// [`Error::ProfileNotFinite`] where the profile is not finite; [`Error::Equation`] when the system does not fit into memory.
    pub fn solve(&self) -> Result<Contact, Error> {
        let kernel = Logarithm::unit();
        let theta0 = self.frame().theta0();
        let degree = self.solver().degree;
        let function = self.resolved_profile()?;
        let system = DegenerateSystem::new(&kernel, theta0, degree)?;
        let power =
            |coefficients: &[f64]| ChebyshevSeries::new(coefficients.to_vec()).moments(degree + 1);
        let responses = Responses {
            level: system.solve(&power(&[1.0])),
            tilted: system.solve(&power(&[0.0, 1.0])),
            profile: system.solve(&function.series().moments(degree + 1)),
        };
        let mut contact = responses.contact(self);
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
        let stiffness0 = Stiffness {
            force_settlement: self.level.projections()[0],
            coupling: self.tilted.projections()[0],
            moment_tilt: self.tilted.projections()[1],
        };
        let free = [self.profile.projections()[0], self.profile.projections()[1]];
        let load = problem.dimensionless_load();
        let [settlement0, tilt0] = displacements(&load, &stiffness0, free);
        let [force0, moment0] = forces(&load, &stiffness0, free, [settlement0, tilt0]);
        let correction = (self.level.correction().iter())
            .zip(self.tilted.correction())
            .zip(self.profile.correction())
            .map(|((level, tilted), profile)| settlement0 * level - tilt0 * tilted - profile)
            .collect();
        Contact {
            problem: problem.clone(),
            force0,
            moment0,
            settlement0,
            tilt0,
            stiffness0,
            correction: ChebyshevSeries::new(correction),
            peak: (0.0, 0.0),
            tension: Vec::new(),
            warnings: Vec::new(),
        }
    }
}

/// Settlement and tilt from the two conditions of the load: `P = c11 delta - c12 alpha - F1`,
/// `M = c12 delta - c22 alpha - F2`, (3.7) with any one of each pair given.
fn displacements(load: &Load, stiffness: &Stiffness, [force, moment]: [f64; 2]) -> [f64; 2] {
    let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = *stiffness;
    let (row1, right1) = match load.vertical {
        Vertical::Force(prescribed) => ([c11, -c12], prescribed + force),
        Vertical::Settlement(prescribed) => ([1.0, 0.0], prescribed),
    };
    let (row2, right2) = match load.rotational {
        Rotational::Moment(prescribed) => ([c12, -c22], prescribed + moment),
        Rotational::Tilt(prescribed) => ([0.0, 1.0], prescribed),
        // M - e P = 0
        Rotational::Eccentricity(e) => ([c12 - e * c11, e * c12 - c22], moment - e * force),
    };
    let determinant = row1[0] * row2[1] - row1[1] * row2[0];
    [
        (right1 * row2[1] - row1[1] * right2) / determinant,
        (row1[0] * right2 - right1 * row2[0]) / determinant,
    ]
}

/// Force and moment; what is prescribed comes back as given.
fn forces(
    load: &Load,
    stiffness: &Stiffness,
    free: [f64; 2],
    [settlement, tilt]: [f64; 2],
) -> [f64; 2] {
    let Stiffness { force_settlement: c11, coupling: c12, moment_tilt: c22 } = *stiffness;
    let force = match load.vertical {
        Vertical::Force(prescribed) => prescribed,
        Vertical::Settlement(_) => c11 * settlement - c12 * tilt - free[0],
    };
    let moment = match load.rotational {
        Rotational::Moment(prescribed) => prescribed,
        Rotational::Eccentricity(e) => e * force,
        Rotational::Tilt(_) => c12 * settlement - c22 * tilt - free[1],
    };
    [force, moment]
}

impl Contact {
    fn describe_pressure(&mut self) {
        let (peak, tension) = {
            let sampled = self.sampled();
            (sampled.maximum(), sampled.negative())
        };
        self.peak = (peak.value, peak.place);
        self.tension = tension;
        if !self.tension.is_empty() {
            let variable = self.problem.frame().coordinate();
            let places: Vec<String> = (self.tension().iter())
                .map(|[left, right]| format!("{variable} = {} to {}", short(*left), short(*right)))
                .collect();
            let unit = if variable == "x" { " (m)" } else { "" };
            let message = format!(
                "the pressure is negative at {}{unit}: a bilateral answer that pulls there; a real punch would lift off",
                places.join(" and ")
            );
            self.warnings.push(Warning { code: WarningCode::NegativePressure, message });
        }
    }
}

fn short(value: f64) -> String {
    if value != 0.0 && !(1e-3..1e4).contains(&value.abs()) {
        format!("{value:.5e}")
    } else {
        format!("{value:.6}")
    }
}

fn unresolved(error: f64) -> Warning {
    let message = format!(
        "the profile has a kink, a jump or faster oscillation than degree 131072 resolves: its expansion is off by about {error:.1e} \
         of its largest value (estimate)"
    );
    Warning { code: WarningCode::ProfileNotResolved, message }
}

fn low_degree(degree: usize, theta0: f64) -> Warning {
    let message = format!(
        "n = {degree} is below theta0 = {theta0:.4}: the boundary layers at the edges are not resolved and edge pressures may have no \
         digit; take n of several times theta0"
    );
    Warning { code: WarningCode::LowDegree, message }
}
