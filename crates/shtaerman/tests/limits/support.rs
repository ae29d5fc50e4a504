//! Contacts with any roughness, in units in which the smooth problem stays the same.

use std::f64::consts::PI;

use shtaerman::{
    Contact, Elastic, Foundation, Geometry, Load, Problem, Profile, Punch, Rotational, Vertical,
};

/// A punch of half-width 1 on a body with `E* = 1`, under the force 1.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) profile: &'static str,
    pub(crate) moment: f64,
    pub(crate) gap: Option<f64>,
}

pub(crate) const PARABOLA: Case =
    Case { name: "parabola", profile: "8*x^2", moment: 0.0, gap: None };
pub(crate) const FLAT: Case = Case { name: "flat", profile: "0", moment: 0.2, gap: None };

pub(crate) const CASES: [Case; 5] = [
    PARABOLA,
    Case { name: "wedge", profile: "2*abs(x)", moment: 0.0, gap: None },
    FLAT,
    Case { name: "beyond the tilting limit", profile: "0", moment: 0.7, gap: None },
    Case { name: "pair", profile: "0.1*x^2", moment: 0.05, gap: Some(0.3) },
];

impl Case {
    /// The contact with the roughness `chi E*/a`; 0 is smooth.
    pub(crate) fn solve(&self, roughness: f64) -> Contact {
        let geometry =
            self.gap.map_or(Geometry::Plane, |inner_half_gap| Geometry::Pair { inner_half_gap });
        let body = Elastic::new(1.0, 0.0).unwrap();
        let (foundation, punch) = (
            Foundation::new(body).with_roughness(roughness).unwrap(),
            Punch::in_geometry(geometry, 1.0).unwrap(),
        );
        let load = Load::new(Vertical::Force(1.0), Rotational::Moment(self.moment)).unwrap();
        let profile = Profile::expression(self.profile).unwrap();
        Problem::new(foundation, punch.with_profile(profile), load).unwrap().solve().unwrap()
    }
}

/// `chi E*/a` at a `theta0`.
pub(crate) fn roughness(theta0: f64) -> f64 {
    2.0 / (PI * theta0)
}
