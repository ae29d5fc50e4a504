//! Punches on `E = y^mu`, lengths in metres, and their potentials by quadrature.

use std::f64::consts::{FRAC_PI_2, PI};

use fredholm::kernel::{Kernel, WeberSonine};
use fredholm::quadrature::double_exponential;
use libm::tgamma;
use shtaerman::{
    Contact, Error, Foundation, Geometry, Grading, Load, Problem, Profile, Punch, Rotational,
    Roughness, Solver, Vertical,
};

pub(crate) const NU: f64 = 0.3;
pub(crate) const EXPONENTS: [f64; 5] = [0.02, 0.2, 0.5, 0.8, 0.95];

/// A punch on ground of this exponent.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Case {
    pub(crate) mu: f64,
    pub(crate) geometry: Geometry,
    pub(crate) half_width: f64,
    pub(crate) solver: Solver,
}

impl Case {
    pub(crate) fn plane(mu: f64) -> Self {
        let solver = Solver::default();
        Self { mu, geometry: Geometry::Plane, half_width: 1.0, solver }
    }

    pub(crate) fn disk(mu: f64) -> Self {
        Self { geometry: Geometry::Circular, ..Self::plane(mu) }
    }

    pub(crate) fn grading(&self) -> Grading {
        Grading::new(self.mu, 1.0).unwrap()
    }

    /// `theta_g`.
    pub(crate) fn line(&self) -> f64 {
        self.grading().line_response(NU)
    }

    /// `A/(pi E0)`: the settlement is this times `pi int W_0 p s ds`.
    pub(crate) fn rings(&self) -> f64 {
        self.grading().response(NU, 1.0, true)
    }

    pub(crate) fn problem(
        &self,
        profile: Profile,
        roughness: impl Into<Roughness>,
        vertical: Vertical,
        rotational: Rotational,
    ) -> Problem {
        let (grading, a) = (self.grading(), self.half_width);
        let (foundation, punch) = (
            Foundation::graded(grading, NU).unwrap().with_roughness(roughness).unwrap(),
            Punch::in_geometry(self.geometry, a).unwrap(),
        );
        Problem::new(
            foundation,
            punch.with_profile(profile),
            Load::new(vertical, rotational).unwrap(),
        )
        .unwrap()
        .with_solver(self.solver)
    }

    pub(crate) fn attempt(
        &self,
        profile: &str,
        vertical: Vertical,
        rotational: Rotational,
    ) -> Result<Contact, Error> {
        self.problem(Profile::expression(profile).unwrap(), 0.0, vertical, rotational).solve()
    }

    #[track_caller]
    pub(crate) fn solve(
        &self,
        profile: &str,
        vertical: Vertical,
        rotational: Rotational,
    ) -> Contact {
        self.attempt(profile, vertical, rotational).unwrap()
    }

    #[track_caller]
    pub(crate) fn press(&self, profile: &str, force: f64) -> Contact {
        self.solve(profile, Vertical::Force(force), Rotational::Moment(0.0))
    }
}

/// `cos(pi mu/2)`.
pub(crate) fn cosine(mu: f64) -> f64 {
    (FRAC_PI_2 * mu).cos()
}

/// `int_{-1}^{1} (1 - t^2)^e dt`.
pub(crate) fn beta_integral(e: f64) -> f64 {
    PI.sqrt() * tgamma(1.0 + e) / tgamma(1.5 + e)
}

#[track_caller]
pub(crate) fn close(found: f64, exact: f64, tolerance: f64, what: &str) {
    let error = ((found - exact) / exact).abs();
    assert!(error <= tolerance, "{what}: {found} instead of {exact}: {error:.1e}");
}

/// `int_from^to f(s, |s - x|) |s - x|^-mu ds` over a piece that lies on one side of `x`, `f` with powers at its ends.
pub(crate) fn piece(f: &dyn Fn(f64, f64) -> f64, [left, right]: [f64; 2], x: f64, mu: f64) -> f64 {
    // d^-mu dd = du/(1-mu) with the distance d and u = d^(1-mu)
    let power = 1.0 - mu;
    let sign = if left >= x { 1.0 } else { -1.0 };
    let [near, far] = if left >= x { [left - x, right - x] } else { [x - right, x - left] };
    let (first, last) = (near.powf(power), far.powf(power));
    let half = 0.5 * (last - first);
    double_exponential(300)
        .map(|node| {
            let distance = (first + half * node.from_left).powf(1.0 / power);
            let at = (x + sign * distance).clamp(left, right);
            let value = f(at, distance);
            // Corners: the share of a place that is rounded to the end is below rounding.
            if value.is_finite() { node.weight * half / power * value } else { 0.0 }
        })
        .sum()
}

/// The displacement at `x` by the kernel itself, integrated over the pressure between kinks.
pub(crate) fn potential(case: &Case, contact: &Contact, kinks: &[f64], x: f64) -> f64 {
    let zone = contact.zones()[0];
    let mut cuts = vec![zone[0], x.clamp(zone[0], zone[1]), zone[1]];
    cuts.extend(kinks.iter().filter(|at| zone[0] < **at && **at < zone[1]));
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let pressure = |s: f64, _: f64| contact.pressure(s).unwrap();
    let pairs = cuts.windows(2).map(|pair| [pair[0], pair[1]]);
    case.line() * pairs.map(|ends| piece(&pressure, ends, x, case.mu)).sum::<f64>()
}

/// The same of a disk, of its part without angle.
pub(crate) fn rings(case: &Case, contact: &Contact, kinks: &[f64], x: f64) -> f64 {
    let mu = case.mu;
    let edge = contact.zones()[0][1];
    let kernel = WeberSonine::new(1.0, 0.0, 0.5 * mu).unwrap();
    let mut cuts = vec![0.0, x, edge];
    cuts.extend(kinks);
    cuts.retain(|at| *at <= edge);
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let density = |s: f64, distance: f64| {
        let p = 0.5 * (contact.pressure(s).unwrap() + contact.pressure(-s).unwrap());
        p * s * kernel.pair(x, s, distance).value * distance.powf(mu)
    };
    let pairs = cuts.windows(2).map(|pair| [pair[0], pair[1]]);
    case.rings() * PI * pairs.map(|ends| piece(&density, ends, x, mu)).sum::<f64>()
}
