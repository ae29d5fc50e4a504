//! A problem with one thing changed.

use crate::foundation::{GroundKind, stands_for_all};
use crate::{
    Elastic, Error, Foundation, Grading, Load, Problem, Profile, Punch, Roughness, Vertical,
};

impl Problem {
    /// The same problem on another foundation.
    ///
    /// # Errors
    /// Those of [`Problem::new`].
    pub fn with_foundation(&self, foundation: Foundation) -> Result<Self, Error> {
        self.stated(foundation, self.punch().clone(), *self.load())
    }

    /// The same problem under another punch.
    ///
    /// # Errors
    /// Those of [`Problem::new`].
    pub fn with_punch(&self, punch: Punch) -> Result<Self, Error> {
        self.stated(self.foundation().clone(), punch, *self.load())
    }

    /// The same problem under another load.
    ///
    /// # Errors
    /// Those of [`Problem::new`].
    pub fn with_load(&self, load: Load) -> Result<Self, Error> {
        self.stated(self.foundation().clone(), self.punch().clone(), load)
    }

    /// The same problem with another base.
    ///
    /// # Errors
    /// Those of [`Problem::new`].
    pub fn with_profile(&self, profile: Profile) -> Result<Self, Error> {
        self.with_punch(self.punch().clone().with_profile(profile))
    }

    /// The same problem with another rough layer: a compliance (m/Pa) or another [`Roughness`].
    ///
    /// # Errors
    /// Those of [`Foundation::with_roughness`] and [`Problem::new`].
    pub fn with_roughness(&self, roughness: impl Into<Roughness>) -> Result<Self, Error> {
        self.with_foundation(self.foundation().with_roughness(roughness)?)
    }

    /// The same problem on a foundation of another Young's modulus (Pa); of a graded one that at the depth of 1 m, its `grading_modulus`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the modulus is finite and positive; [`Error::NotDimensionless`] for a dimensionless problem; those of [`Problem::new`].
    pub fn with_young_modulus(&self, modulus: f64) -> Result<Self, Error> {
        let known = self.foundation();
        let changed = match known.ground() {
            GroundKind::Homogeneous(material) => {
                let material = Elastic::new(modulus, material.poisson_ratio())?;
                let foundation = Foundation::new(material);
                match known.layering() {
                    Some(layering) => foundation.with_layering(layering.clone().on(material)?),
                    None => foundation,
                }
            }
            GroundKind::Graded(grading, poisson_ratio) => {
                crate::error::positive("young_modulus", modulus)?;
                Foundation::graded(Grading::new(grading.exponent(), modulus)?, poisson_ratio)?
            }
            GroundKind::Dimensionless(_) => return Err(stands_for_all("young_modulus")),
        };
        self.with_foundation(changed.with_roughness(known.roughness())?)
    }

    /// The same dimensionless problem at another `theta0`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `theta0` is finite and not negative, and for a physical problem, where it follows.
    pub fn with_theta0(&self, theta0: f64) -> Result<Self, Error> {
        if !self.is_dimensionless() {
            let requirement =
                "left to the problem: it follows from material, roughness and half_width";
            return Err(Error::InvalidValue { field: "theta0", value: theta0, requirement });
        }
        let foundation = Foundation::dimensionless(theta0)?;
        let foundation = match self.foundation().roughness() {
            Roughness::Power { exponent, .. } => foundation.with_exponent(exponent)?,
            Roughness::Smooth | Roughness::Linear { .. } => foundation,
        };
        self.with_foundation(match self.foundation().layering() {
            Some(layering) => foundation.with_layering(layering.clone()),
            None => foundation,
        })
    }

    /// The same problem under another force, or settlement, that goes with the same moment, eccentricity or tilt.
    ///
    /// # Errors
    /// Those of [`Problem::new`]; [`Error::InvalidValue`] for a value that is not finite.
    pub fn with_vertical(&self, vertical: Vertical) -> Result<Self, Error> {
        self.with_load(Load::new(vertical, self.load().rotational)?)
    }

    /// The same problem under this force, in place of the force or settlement prescribed.
    ///
    /// # Errors
    /// Those of [`Problem::new`]; [`Error::InvalidValue`] for a value that is not finite.
    pub fn with_force(&self, force: f64) -> Result<Self, Error> {
        self.with_vertical(Vertical::Force(force))
    }

    /// The same problem at this settlement, in place of the force or settlement prescribed.
    ///
    /// # Errors
    /// Those of [`Problem::new`]; [`Error::InvalidValue`] for a value that is not finite.
    pub fn with_settlement(&self, settlement: f64) -> Result<Self, Error> {
        self.with_vertical(Vertical::Settlement(settlement))
    }

    /// The same problem under this moment, in place of the moment, eccentricity or tilt prescribed.
    ///
    /// # Errors
    /// Those of [`Problem::new`]; [`Error::InvalidValue`] for a value that is not finite.
    pub fn with_moment(&self, moment: f64) -> Result<Self, Error> {
        self.with_load(self.load().with_moment(moment)?)
    }

    /// The same problem at this eccentricity, in place of the moment, eccentricity or tilt prescribed.
    ///
    /// # Errors
    /// Those of [`Problem::new`]; [`Error::InvalidValue`] for a value that is not finite.
    pub fn with_eccentricity(&self, eccentricity: f64) -> Result<Self, Error> {
        self.with_load(self.load().with_eccentricity(eccentricity)?)
    }

    /// The same problem at this tilt, in place of the moment, eccentricity or tilt prescribed.
    ///
    /// # Errors
    /// Those of [`Problem::new`]; [`Error::InvalidValue`] for a value that is not finite.
    pub fn with_tilt(&self, tilt: f64) -> Result<Self, Error> {
        self.with_load(self.load().with_tilt(tilt)?)
    }

    /// The same problem with a [tolerance](crate::Solver::tolerance) that must be met.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless it is greater than 0 and less than 1.
    pub fn with_tolerance(&self, tolerance: f64) -> Result<Self, Error> {
        Ok(self.with_solver(self.solver().with_tolerance(tolerance)?))
    }

    /// The problem of these parts, solved as this one.
    fn stated(&self, foundation: Foundation, punch: Punch, load: Load) -> Result<Self, Error> {
        Ok(Self::new(foundation, punch, load)?.with_solver(*self.solver()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Rotational, Solver};

    fn problem(roughness: impl Into<Roughness>, modulus: f64, body: Option<Elastic>) -> Problem {
        let material = Elastic::new(modulus, 0.3).unwrap();
        let foundation = Foundation::new(material).with_roughness(roughness).unwrap();
        let punch = Punch::new(5e-3).unwrap();
        let punch = body.map_or(punch.clone(), |body| punch.with_body(body));
        let load = Load::force(1e6).unwrap().with_moment(10.0).unwrap();
        Problem::new(foundation, punch, load).unwrap()
    }

    #[test]
    fn a_changed_problem_is_the_one_built_afresh() {
        let steel = Elastic::new(210e9, 0.3).unwrap();
        let power = Roughness::power(1e-11, 0.5).unwrap();
        for body in [None, Some(steel)] {
            let start = problem(1e-14, 70e9, body);
            for (changed, afresh) in [
                (start.with_roughness(3e-13), problem(3e-13, 70e9, body)),
                (start.with_roughness(power), problem(power, 70e9, body)),
                (start.with_young_modulus(90e9), problem(1e-14, 90e9, body)),
            ] {
                assert_eq!(changed.unwrap(), afresh);
            }
            let load = start.with_settlement(1e-6).unwrap().with_tilt(1e-5).unwrap();
            let expected = Load::settlement(1e-6).unwrap().with_tilt(1e-5).unwrap();
            assert_eq!(*load.load(), expected);
            let bilateral = start.with_solver(Solver::bilateral());
            let kept = bilateral.with_force(2.0).unwrap().with_eccentricity(0.1).unwrap();
            assert_eq!(kept.solver(), &Solver::bilateral());
            assert_eq!(kept.load().rotational(), Rotational::Eccentricity(0.1));
            assert!(bilateral.with_tolerance(2.0).is_err());
        }
        let grading = Grading::new(0.3, 1e9).unwrap();
        let ground = Foundation::graded(grading, 0.2).unwrap().with_roughness(1e-12).unwrap();
        let load = Load::force(1.0).unwrap();
        let graded = Problem::new(ground, Punch::new(0.2).unwrap(), load).unwrap();
        let doubled = graded.with_young_modulus(2e9).unwrap();
        assert_eq!(doubled.foundation().grading(), Some(Grading::new(0.3, 2e9).unwrap()));
        assert_eq!(doubled.theta0(), graded.theta0() / 2.0);
    }

    #[test]
    fn a_dimensionless_problem_has_no_material() {
        let (unit, load) = (Punch::new(1.0).unwrap(), Load::force(1.0).unwrap());
        let bare = Problem::new(Foundation::dimensionless(3.0).unwrap(), unit, load).unwrap();
        assert!(bare.with_roughness(Roughness::Smooth).is_err());
        assert!(bare.with_young_modulus(1.0).is_err());
        assert_eq!(bare.with_theta0(4.0).unwrap().theta0(), 4.0);
        assert!(bare.with_theta0(-1.0).is_err());
        assert!(problem(1e-14, 70e9, None).with_theta0(1.0).is_err());
        assert!(bare.with_punch(Punch::new(2.0).unwrap()).is_err());
    }
}
