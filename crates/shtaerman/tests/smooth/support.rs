//! Problems in which `theta0`, heights and loads are the numbers of the closed forms, and a quadrature of their own for the equation.

use std::f64::consts::PI;
use std::sync::Arc;

use shtaerman::{
    Complementarity, Contact, Elastic, Error, Errors, Foundation, Geometry, Load, Problem, Profile,
    Punch, Scaling, Solver, Stiffness,
};

/// `force` and `moment` prescribed.
pub(crate) fn balanced(force: f64, moment: f64) -> Load {
    Load::force(force).unwrap().with_moment(moment).unwrap()
}

/// Force and tilt prescribed.
pub(crate) fn level(force: f64) -> Load {
    Load::force(force).unwrap().with_tilt(0.0).unwrap()
}

/// A smooth punch of half-width 1 on a body whose `2/(pi E*)` is `theta0`.
#[derive(Clone)]
pub(crate) struct Smooth {
    pub(crate) theta0: f64,
    pub(crate) height: Arc<dyn Fn(f64) -> f64 + Send + Sync>,
    pub(crate) formula: Option<String>,
    pub(crate) breaks: Vec<f64>,
    pub(crate) geometry: Geometry,
    pub(crate) load: Load,
    pub(crate) is_unilateral: bool,
}

/// A unilateral punch on `[-1, 1]`, whose base is a closure.
pub(crate) fn punch(
    theta0: f64,
    height: impl Fn(f64) -> f64 + Send + Sync + 'static,
    load: Load,
) -> Smooth {
    let (height, geometry) = (Arc::new(height), Geometry::Plane);
    let (formula, breaks) = (None, Vec::new());
    Smooth { theta0, height, formula, breaks, geometry, load, is_unilateral: true }
}

impl Smooth {
    pub(crate) fn breaks(self, breaks: &[f64]) -> Self {
        Self { breaks: breaks.to_vec(), ..self }
    }

    /// The same base as a formula, whose slope is known.
    pub(crate) fn formula(self, text: &str) -> Self {
        Self { formula: Some(text.to_owned()), ..self }
    }

    pub(crate) fn bilateral(self) -> Self {
        Self { is_unilateral: false, ..self }
    }

    pub(crate) fn period(self, period: f64) -> Self {
        Self { geometry: Geometry::Periodic { period }, ..self }
    }

    pub(crate) fn gap(self, inner_half_gap: f64) -> Self {
        Self { geometry: Geometry::Pair { inner_half_gap }, ..self }
    }

    pub(crate) fn solve(&self) -> Result<Solved, Error> {
        let body = Elastic::new(2.0 / (PI * self.theta0), 0.0)?;
        let profile = match &self.formula {
            Some(text) => Profile::expression(text).unwrap(),
            None => {
                let height = Arc::clone(&self.height);
                Profile::from_fn(move |x| height(x)).with_breaks(self.breaks.clone())?
            }
        };
        let punch = Punch::in_geometry(self.geometry, 1.0)?.with_profile(profile);
        let solver = if self.is_unilateral { Solver::unilateral() } else { Solver::bilateral() };
        let problem = Problem::new(Foundation::new(body), punch, self.load)?.with_solver(solver);
        Ok(Solved { contact: problem.solve()?, problem: self.clone() })
    }

    pub(crate) fn solved(&self) -> Solved {
        self.solve().unwrap()
    }

    pub(crate) fn refused(&self) -> Error {
        self.solve().map(|_| ()).unwrap_err()
    }

    fn is_wave(&self) -> bool {
        matches!(self.geometry, Geometry::Periodic { period } if period <= 2.0)
    }
}

/// A contact with its problem.
pub(crate) struct Solved {
    pub(crate) contact: Contact,
    pub(crate) problem: Smooth,
}

/// A zone of contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Zone {
    pub(crate) ends: [f64; 2],
    pub(crate) intensity: [f64; 2],
}

impl Zone {
    /// Whether each end is free; else it rests at a wall.
    pub(crate) fn is_free(&self) -> [bool; 2] {
        self.intensity.map(|k| k == 0.0)
    }
}

/// Distance from a corner below which the pressure is its singularity.
const SINGULAR: f64 = 1e-8;

impl Solved {
    /// A quantity as the solution has it, where it is prescribed, too.
    fn found(&self, of: fn(&Contact) -> f64, unit: fn(&Scaling) -> f64) -> f64 {
        of(&self.contact.dimensionless()) * unit(self.contact.problem().scaling().unwrap())
    }

    pub(crate) fn force(&self) -> f64 {
        self.found(Contact::force, Scaling::force)
    }

    pub(crate) fn moment(&self) -> f64 {
        self.found(Contact::moment, Scaling::moment)
    }

    pub(crate) fn settlement(&self) -> f64 {
        self.found(Contact::settlement, Scaling::displacement)
    }

    pub(crate) fn tilt(&self) -> f64 {
        self.found(Contact::tilt, Scaling::angle)
    }

    /// The pressure; of a wave anywhere.
    pub(crate) fn pressure(&self, x: f64) -> f64 {
        self.contact.pressure(self.wrapped(x)).unwrap()
    }

    pub(crate) fn gap(&self, x: f64) -> f64 {
        self.contact.gap(self.wrapped(x)).unwrap()
    }

    fn wrapped(&self, x: f64) -> f64 {
        if x.abs() > 1.0 && self.problem.is_wave() { x - 2.0 * (0.5 * x).round() } else { x }
    }

    pub(crate) fn elastic_displacement(&self, x: f64) -> f64 {
        self.contact.elastic_displacement(x)
    }

    pub(crate) fn zones(&self) -> Vec<Zone> {
        let zones = self.contact.zones().into_iter().zip(self.contact.corner_intensity().unwrap());
        zones.map(|(ends, intensity)| Zone { ends, intensity }).collect()
    }

    pub(crate) fn error(&self) -> Errors {
        self.contact.error().unwrap()
    }

    /// The error of the free ends.
    pub(crate) fn zones_error(&self) -> f64 {
        self.error().zones.unwrap()
    }

    pub(crate) fn stiffness(&self) -> Stiffness {
        self.contact.stiffness()
    }

    pub(crate) fn complementarity(&self) -> Complementarity {
        self.contact.complementarity().unwrap()
    }

    /// The pressure in a zone at a place by its distances from the ends, so near to a corner by its singularity.
    fn pressure_beside(&self, zone: &Zone, [from_left, from_right]: [f64; 2]) -> f64 {
        for (distance, intensity) in [from_left, from_right].into_iter().zip(zone.intensity) {
            if intensity != 0.0 && distance < SINGULAR {
                return intensity / (2.0 * PI * distance).sqrt();
            }
        }
        let near = from_left < from_right;
        self.pressure(if near { zone.ends[0] + from_left } else { zone.ends[1] - from_right })
    }
}

pub(crate) fn close(found: f64, exact: f64, relative: f64, what: &str) {
    let error = (found - exact).abs();
    assert!(error <= relative * exact.abs(), "{what}: {found:e}, exact {exact:e}");
}

/// Double exponential quadrature of `f(distance from a, distance from b)` over `(a, b)` of this length.
pub(crate) fn integral(length: f64, f: impl Fn(f64, f64) -> f64) -> f64 {
    const STEP: f64 = 1.0 / 32.0;
    (-190..=190)
        .map(|i| {
            let t = f64::from(i) * STEP;
            let s = PI * t.sinh();
            let from_left = length / (1.0 + (-s).exp());
            let from_right = length / (1.0 + s.exp());
            let weight = STEP * PI * t.cosh() * from_left * from_right / length;
            if weight > 0.0 { weight * f(from_left, from_right) } else { 0.0 }
        })
        .sum()
}

/// `sum over zones int g(xi, p) dxi`, with intervals that end at cuts: `g` has `xi - cut` too.
pub(crate) fn over_zones(contact: &Solved, cuts: &[f64], g: impl Fn(f64, f64) -> f64) -> f64 {
    let mut sum = 0.0;
    for zone in &contact.zones() {
        let [left, right] = zone.ends;
        let mut places = vec![left];
        places.extend(cuts.iter().filter(|cut| left < **cut && **cut < right));
        places.push(right);
        places.sort_by(f64::total_cmp);
        for pair in places.windows(2) {
            sum += integral(pair[1] - pair[0], |from_left, from_right| {
                let beside = [pair[0] - left + from_left, right - pair[1] + from_right];
                let p = contact.pressure_beside(zone, beside);
                let near = from_left < from_right;
                let xi = if near { pair[0] + from_left } else { pair[1] - from_right };
                // A node that rounds onto a kink.
                g(xi, if p.is_finite() { p } else { 0.0 })
            });
        }
    }
    sum
}

/// `theta0 int K(x - s) p(s) ds` by quadrature.
pub(crate) fn displacement(contact: &Solved, x: f64) -> f64 {
    let problem = &contact.problem;
    let mut cuts = problem.breaks.clone();
    let mut others = vec![x];
    if let Geometry::Periodic { period } = problem.geometry {
        cuts.extend(problem.breaks.iter().flat_map(|at| [at - period, at + period]));
        others.extend([x - period, x + period]);
    }
    cuts.extend(others);
    let kernel = |d: f64| match problem.geometry {
        Geometry::Periodic { period } => -(2.0 * (PI * d / period).sin().abs()).ln(),
        _ => -d.abs().ln(),
    };
    let density = |s: f64, p: f64| if s == x { 0.0 } else { kernel(x - s) * p };
    problem.theta0 * over_zones(contact, &cuts, density)
}

/// The equation, the signs and the balance, by quadrature.
pub(crate) fn holds(contact: &Solved, tolerance: f64, what: &str) {
    let problem = &contact.problem;
    let scale = problem.theta0 * contact.force().abs() + contact.settlement().abs();
    let mut largest = 0.0f64;
    for [left, right] in contact.contact.problem().punch().pieces() {
        for i in 1..40 {
            let x = left + (right - left) * (f64::from(i) + 0.1234) / 40.2;
            let depth = contact.settlement() - contact.tilt() * x - (problem.height)(x);
            let gap = displacement(contact, x) - depth;
            let p = contact.pressure(x);
            largest = largest.max(p.abs());
            let known = contact.gap(x);
            assert!((gap - known).abs() < tolerance * scale, "{what}: {x}: {gap:e} {known:e}");
            if problem.is_unilateral {
                assert!(gap >= -tolerance * scale, "{what}: {x}: {gap:e}");
                assert!(p >= -tolerance * largest, "{what}: {x}: {p:e}");
            }
        }
    }
    let breaks = &problem.breaks;
    let force = over_zones(contact, breaks, |_, p| p);
    close(force, contact.force(), 10.0 * tolerance, what);
    // Of a wave whose zones lie over the seam the moment has its own test.
    let moment = if problem.is_wave() {
        contact.moment()
    } else {
        over_zones(contact, breaks, |x, p| x * p)
    };
    let error = (moment - contact.moment()).abs();
    assert!(error < 10.0 * tolerance * contact.force().abs(), "{what}: moment {moment}");
    if problem.is_unilateral {
        for zone in contact.zones() {
            for side in 0..2 {
                assert!(zone.intensity[side] >= 0.0, "{what}: {zone:?}");
            }
        }
        let left = contact.complementarity();
        assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{what}: {left:?}");
    }
}
