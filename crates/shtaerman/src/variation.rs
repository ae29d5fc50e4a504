//! A problem with one thing changed.

use crate::error::require;
use crate::frame::ROUGH_ONLY;
use crate::{Elastic, Error, Frame, Grading, Load, Problem, Profile, Roughness, Scaling, Vertical};

impl Frame {
    /// The same with another rough layer.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a roughness out of range, and for a dimensionless problem, whose scale it is.
    pub fn with_roughness(&self, roughness: Roughness) -> Result<Self, Error> {
        let Self::Physical { foundation, grading, layering, body, geometry, scaling, .. } = self
        else {
            return Err(has_no_material("roughness"));
        };
        let is_solved = layering.is_none() || roughness != Roughness::Smooth;
        require(is_solved, "roughness", 0.0, ROUGH_ONLY)?;
        let moduli = [scaling.pressure(), scaling.contact_modulus()];
        let (half_width, geometry) = (scaling.half_width(), *geometry);
        let scaling =
            Scaling::with_response(response(scaling), moduli, roughness, half_width, geometry)?;
        let (foundation, grading, layering, body) = (*foundation, *grading, *layering, *body);
        Ok(Self::Physical { foundation, grading, layering, body, roughness, geometry, scaling })
    }

    /// The same with another Young's modulus of the foundation (Pa).
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the modulus is finite and positive, and for a dimensionless problem.
    pub fn with_young_modulus(&self, modulus: f64) -> Result<Self, Error> {
        let Self::Physical { foundation, grading, layering, body, roughness, geometry, scaling } =
            self
        else {
            return Err(has_no_material("young_modulus"));
        };
        let material = Elastic::new(modulus, foundation.poisson_ratio())?;
        let (half_width, roughness, geometry) = (scaling.half_width(), *roughness, *geometry);
        let factor = modulus / foundation.young_modulus();
        let scaling = if body.is_some() {
            let body = body.as_ref();
            Scaling::in_geometry(&material, roughness, half_width, body, geometry)?
        } else {
            let moduli = [scaling.pressure(), scaling.contact_modulus()].map(|e| e * factor);
            let response = response(scaling) / factor;
            Scaling::with_response(response, moduli, roughness, half_width, geometry)?
        };
        let stiffened = |known: Grading| Grading::new(known.exponent(), known.modulus() * factor);
        let grading = grading.map(stiffened).transpose()?;
        Ok(Self::Physical {
            foundation: material,
            grading,
            layering: layering.map(|known| known.on(material)).transpose()?,
            body: *body,
            roughness,
            geometry,
            scaling,
        })
    }

    /// The same dimensionless problem at another `theta0`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless `theta0` is finite and not negative, and for a physical problem, where it follows.
    pub fn with_theta0(&self, theta0: f64) -> Result<Self, Error> {
        let Self::Dimensionless { law, geometry, layering, .. } = self else {
            let requirement =
                "left to the problem: it follows from material, roughness and half_width";
            return Err(Error::InvalidValue { field: "theta0", value: theta0, requirement });
        };
        Self::dimensionless(theta0)?;
        Ok(Self::Dimensionless { theta0, law: *law, geometry: *geometry, layering: *layering })
    }
}

impl Problem {
    /// The same problem in another frame.
    ///
    /// # Errors
    /// Those of [`Problem::new`].
    pub fn with_frame(&self, frame: Frame) -> Result<Self, Error> {
        Self::new(frame, self.profile().clone(), *self.load(), *self.solver())
    }

    /// The same problem under another load.
    ///
    /// # Errors
    /// Those of [`Problem::new`].
    pub fn with_load(&self, load: Load) -> Result<Self, Error> {
        Self::new(self.frame().clone(), self.profile().clone(), load, *self.solver())
    }

    /// The same problem under another force, or settlement, that goes with the same moment, eccentricity or tilt.
    ///
    /// # Errors
    /// Those of [`Problem::new`]; [`Error::InvalidValue`] for a value that is not finite.
    pub fn with_vertical(&self, vertical: Vertical) -> Result<Self, Error> {
        self.with_load(Load::new(vertical, self.load().rotational)?)
    }

    /// The same problem with another base.
    ///
    /// # Errors
    /// Those of [`Problem::new`].
    pub fn with_profile(&self, profile: Profile) -> Result<Self, Error> {
        Self::new(self.frame().clone(), profile, *self.load(), *self.solver())
    }

    /// The same problem with another rough layer.
    ///
    /// # Errors
    /// Those of [`Frame::with_roughness`] and [`Problem::new`].
    pub fn with_roughness(&self, roughness: impl Into<Roughness>) -> Result<Self, Error> {
        self.with_frame(self.frame().with_roughness(roughness.into())?)
    }

    /// The same problem on a foundation of another Young's modulus (Pa).
    ///
    /// # Errors
    /// Those of [`Frame::with_young_modulus`] and [`Problem::new`].
    pub fn with_young_modulus(&self, modulus: f64) -> Result<Self, Error> {
        self.with_frame(self.frame().with_young_modulus(modulus)?)
    }
}

/// What the foundation gives under a unit of pressure, 1/Pa.
fn response(scaling: &Scaling) -> f64 {
    scaling.theta0() * scaling.displacement() / (scaling.half_width() * scaling.pressure())
}

fn has_no_material(field: &'static str) -> Error {
    let requirement = "left out of a dimensionless problem: theta0 stands for all of its material";
    Error::InvalidValue { field, value: f64::NAN, requirement }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Rotational, Solver};

    fn problem(roughness: impl Into<Roughness>, modulus: f64, body: Option<Elastic>) -> Problem {
        let foundation = Elastic::new(modulus, 0.3).unwrap();
        let frame = Frame::physical(foundation, roughness, 5e-3, body).unwrap();
        let load = Load::new(Vertical::Force(1e6), Rotational::Moment(10.0)).unwrap();
        Problem::new(frame, Profile::flat(), load, Solver::default()).unwrap()
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
                let changed = changed.unwrap();
                let (one, two) =
                    (changed.frame().scaling().unwrap(), afresh.frame().scaling().unwrap());
                for (one, two) in [
                    (one.theta0(), two.theta0()),
                    (one.displacement(), two.displacement()),
                    (one.force(), two.force()),
                    (one.contact_modulus(), two.contact_modulus()),
                ] {
                    assert!((one / two - 1.0).abs() < 1e-15, "{one} {two}");
                }
                assert_eq!(changed.load(), afresh.load());
            }
        }
    }

    #[test]
    fn a_dimensionless_problem_has_no_material() {
        let bare = Frame::dimensionless(3.0).unwrap();
        assert!(bare.with_roughness(Roughness::Smooth).is_err());
        assert!(bare.with_young_modulus(1.0).is_err());
        assert_eq!(bare.with_theta0(4.0).unwrap().theta0(), 4.0);
        assert!(bare.with_theta0(-1.0).is_err());
        assert!(problem(1e-14, 70e9, None).frame().with_theta0(1.0).is_err());
    }
}
