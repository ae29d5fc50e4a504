//! Problems by chance, the same every time.

use shtaerman::{Geometry, Rotational, Solver, Vertical};

use crate::geometries::support::attempt;

/// Marsaglia's xorshift.
struct Chance(u64);

impl Chance {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn one_of<T: Copy>(&mut self, list: &[T]) -> T {
        list[(self.between(0.0, list.len() as f64) as usize).min(list.len() - 1)]
    }

    fn geometry(&mut self) -> Geometry {
        match self.one_of(&[0, 1, 2, 3, 4]) {
            0 => Geometry::Plane,
            1 => Geometry::Pair { inner_half_gap: self.between(0.01, 0.95) },
            2 => Geometry::Periodic { period: self.between(2.05, 6.0) },
            3 => Geometry::Periodic { period: 2.0 },
            _ => Geometry::Circular,
        }
    }

    fn profile(&mut self, geometry: Geometry, size: f64) -> String {
        match geometry {
            Geometry::Periodic { period: 2.0 } => format!(
                "{size}*(cos(pi*xi + {}) + {}*sin(2*pi*xi))",
                self.between(0.0, 6.0),
                self.between(0.0, 0.6)
            ),
            Geometry::Circular => match self.one_of(&[0, 1, 2]) {
                0 => format!("{size}*(abs(xi) - {})^2", self.between(0.0, 1.0)),
                1 => format!("{size}*cos({}*xi)", self.between(1.0, 12.0)),
                _ => format!("{size}*xi^2"),
            },
            _ => match self.one_of(&[0, 1, 2]) {
                0 => format!("{size}*(xi - {})^2", self.between(-1.0, 1.0)),
                1 => format!("{size}*sin({}*xi)", self.between(1.0, 12.0)),
                _ => format!("{size}*abs(xi - {})", self.between(-1.0, 1.0)),
            },
        }
    }

    fn rotational(&mut self, geometry: Geometry, size: f64) -> Rotational {
        match geometry {
            Geometry::Periodic { period: 2.0 } | Geometry::Circular => Rotational::Moment(0.0),
            _ => match self.one_of(&[0, 1, 2]) {
                0 => Rotational::Moment(0.0),
                1 => Rotational::Eccentricity(self.between(-0.98, 0.98)),
                _ => Rotational::Tilt(size * self.between(-1.0, 1.0)),
            },
        }
    }
}

#[test]
fn every_problem_is_solved() {
    let mut chance = Chance(88_172_645_463_325_252);
    for number in 0..120 {
        let exponent = chance.one_of(&[1.0, 1.0, 0.7, 0.5, 0.3]);
        let geometry = chance.geometry();
        let theta = 10f64.powf(chance.between(-4.0, 3.0));
        let size = 10f64.powf(chance.between(-2.0, 1.5)) * (1.0 + theta).sqrt();
        let profile = chance.profile(geometry, size);
        let force = Vertical::Force(10f64.powf(chance.between(-3.0, 2.0)));
        let rotational = chance.rotational(geometry, size);
        let body = (geometry, theta, exponent);
        let contact = attempt(body, &profile, (force, rotational), Solver::default())
            .unwrap_or_else(|error| {
                panic!("{number}: {body:?} {profile} {force:?} {rotational:?}: {error}")
            });
        let left = contact.complementarity().unwrap();
        assert!(
            contact.relative_error() < 1e-8 && left.tension < 1e-9 && left.penetration < 1e-9,
            "{number}: {body:?} {profile} {force:?} {rotational:?}: {left:?} {}",
            contact.relative_error()
        );
        // The equation itself, where it touches.
        let Vertical::Force(force) = force else { return };
        assert!((contact.dimensionless().force() - force).abs() <= 1e-15 * force);
        let top = contact.dimensionless().peak_pressure_at();
        let depth = contact.base_depth(top) - contact.dimensionless().elastic_displacement(top);
        let layer = contact.dimensionless().pressure(top).unwrap().powf(exponent);
        let scale = layer
            + contact.dimensionless().settlement().abs()
            + contact.dimensionless().tilt().abs()
            + size;
        assert!(
            (depth - layer).abs() < 1e-11 * scale,
            "{number}: {body:?} {profile}: {depth} {layer}"
        );
    }
}
