//! When an answer is none: the one rule for the error that was reached, stated by a method or by an audit, and for tension and penetration.

use super::accuracy::STAGNANT;
use super::complementarity::Complementarity;
use super::method::{Method, MethodName};
use crate::{Error, Solver};

/// Answers with larger relative errors are none unless that is asked for, and bounds of larger ones say nothing (survey).
pub(super) const ROUGHEST: f64 = 1e-2;
/// Tension and penetration over the relative error that explains them (survey).
const EXPLAINED: f64 = 8.0;

/// An answer as it is judged.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reached {
    /// Its relative error; what is not a number is no error that could be kept.
    pub(super) error: f64,
    pub(super) method: Method,
    /// `delta0` and `alpha0`.
    pub(super) displacements: [f64; 2],
}

impl Reached {
    /// Refuses an error above an explicit tolerance, or above 1 % where neither a tolerance nor a degree was asked for.
    pub(super) fn require_kept(self, solver: &Solver) -> Result<(), Error> {
        let Self { error: reached, method: Method { name, n }, displacements } = self;
        let method = name.name();
        let is_kept = |most: f64| reached <= most;
        match solver.tolerance {
            _ if name == MethodName::FirstKind && reached == f64::INFINITY => {
                Err(Error::UnclearBend)
            }
            Some(tolerance) if is_kept(tolerance) => Ok(()),
            Some(tolerance) => {
                let [settlement0, tilt0] = displacements;
                Err(Error::ToleranceNotMet { tolerance, reached, method, n, settlement0, tilt0 })
            }
            None if solver.degree.is_some() || is_kept(ROUGHEST) => Ok(()),
            None => Err(Error::NotAccurate { reached, most: ROUGHEST, method, n, roughness: None }),
        }
    }
}

/// Refuses tension and penetration beyond what the relative error of the answer explains.
pub(super) fn require_explained(found: Option<Complementarity>, reached: f64) -> Result<(), Error> {
    let Some(Complementarity { tension, penetration }) = found else {
        return Ok(());
    };
    if tension.max(penetration) <= (EXPLAINED * reached).max(STAGNANT) {
        return Ok(());
    }
    Err(Error::NotComplementary { tension, penetration })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kept(error: f64, tolerance: Option<f64>, degree: Option<usize>) -> Result<(), Error> {
        let solver = Solver { tolerance, degree, ..Solver::default() };
        let method = Method { name: MethodName::Sinc, n: 7 };
        Reached { error, method, displacements: [0.5, 0.1] }.require_kept(&solver)
    }

    #[test]
    fn a_hundredth_is_the_most_unless_more_is_allowed() {
        assert!(kept(0.01, None, None).is_ok());
        for error in [0.010_000_1, 0.8, f64::INFINITY, f64::NAN] {
            let refused = kept(error, None, None).unwrap_err();
            assert!(matches!(refused, Error::NotAccurate { most, n: 7, .. } if most == 0.01));
            // Exit code 3: a numerical promise that was not kept.
            assert!(refused.is_numerical());
        }
        // A degree fixes the size of the method, whatever it reaches; a tolerance is what was asked for.
        assert!(kept(0.3, None, Some(16)).is_ok());
        assert!(kept(0.3, Some(0.5), None).is_ok());
    }

    #[test]
    fn a_tolerance_is_kept_or_the_answer_is_none() {
        assert!(kept(1e-10, Some(1e-10), None).is_ok());
        for (error, degree) in [(1.1e-10, None), (1.1e-10, Some(16)), (f64::NAN, None)] {
            let refused = kept(error, Some(1e-10), degree).unwrap_err();
            assert!(
                matches!(refused, Error::ToleranceNotMet { settlement0, .. } if settlement0 == 0.5)
            );
            assert!(refused.is_numerical());
        }
    }

    #[test]
    fn tension_and_penetration_need_an_error_that_explains_them() {
        let explained = |tension: f64, penetration: f64, reached: f64| {
            require_explained(Some(Complementarity { tension, penetration }), reached)
        };
        assert!(require_explained(None, 0.0).is_ok());
        assert!(explained(5e-10, 5e-10, 1e-15).is_ok());
        assert!(explained(7e-4, 1e-5, 1e-4).is_ok());
        // A white-noise trace on cells once said 0.80 and 0.25, and was an answer.
        for (tension, penetration, reached) in
            [(0.8, 0.25, 1e-3), (0.0, 2e-9, 1e-12), (9e-4, 0.0, 1e-4), (f64::NAN, 1.0, 1e-4)]
        {
            let refused = explained(tension, penetration, reached).unwrap_err();
            assert!(matches!(refused, Error::NotComplementary { .. }) && refused.is_numerical());
        }
        assert!(explained(f64::INFINITY, 0.0, 1.0).is_err());
    }
}
