//! Problems, and a quadrature of their own for the equation.

use std::f64::consts::PI;
use std::sync::Arc;

use shtaerman::{
    Error, Load, Rotational, SmoothContact, SmoothKernel, SmoothProblem, SmoothProfile, Vertical,
};

/// `force` and `moment` prescribed.
pub(crate) fn balanced(force: f64, moment: f64) -> Load {
    Load::new(Vertical::Force(force), Rotational::Moment(moment)).unwrap()
}

/// Force and tilt prescribed.
pub(crate) fn level(force: f64) -> Load {
    Load::new(Vertical::Force(force), Rotational::Tilt(0.0)).unwrap()
}

/// A unilateral punch on `[-1, 1]`.
pub(crate) fn punch(
    theta0: f64,
    height: impl Fn(f64) -> f64 + Send + Sync + 'static,
    load: Load,
) -> SmoothProblem {
    SmoothProblem {
        pieces: vec![[-1.0, 1.0]],
        kernel: SmoothKernel::Plane,
        theta0,
        load,
        profile: SmoothProfile {
            height: Arc::new(height),
            slope: None,
            breaks: Vec::new(),
            joints: Vec::new(),
            tolerance: 0.0,
        },
        is_unilateral: true,
    }
}

pub(crate) trait With: Sized {
    fn breaks(self, breaks: &[f64]) -> Self;
    fn slope(self, slope: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self;
    fn bilateral(self) -> Self;
    fn period(self, period: f64) -> Self;
    fn gap(self, half: f64) -> Self;
    fn solved(&self) -> SmoothContact;
    fn refused(&self) -> Error;
}

impl With for SmoothProblem {
    fn breaks(mut self, breaks: &[f64]) -> Self {
        self.profile.breaks = breaks.to_vec();
        self
    }

    fn slope(mut self, slope: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        self.profile.slope = Some(Arc::new(slope));
        self
    }

    fn bilateral(mut self) -> Self {
        self.is_unilateral = false;
        self
    }

    fn period(mut self, period: f64) -> Self {
        self.kernel = SmoothKernel::Periodic { period };
        self
    }

    fn gap(mut self, half: f64) -> Self {
        self.pieces = vec![[-1.0, -half], [half, 1.0]];
        self
    }

    fn solved(&self) -> SmoothContact {
        self.solve().unwrap()
    }

    fn refused(&self) -> Error {
        self.solve().map(|_| ()).unwrap_err()
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
pub(crate) fn over_zones(
    contact: &SmoothContact,
    cuts: &[f64],
    g: impl Fn(f64, f64) -> f64,
) -> f64 {
    let mut sum = 0.0;
    for (j, zone) in contact.zones().iter().enumerate() {
        let [left, right] = zone.ends;
        let mut places = vec![left];
        places.extend(cuts.iter().filter(|cut| left < **cut && **cut < right));
        places.push(right);
        places.sort_by(f64::total_cmp);
        for pair in places.windows(2) {
            sum += integral(pair[1] - pair[0], |from_left, from_right| {
                let beside = [pair[0] - left + from_left, right - pair[1] + from_right];
                let p = contact.pressure_beside0(j, beside[0], beside[1]);
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
pub(crate) fn displacement(contact: &SmoothContact, x: f64) -> f64 {
    let problem = contact.problem();
    let mut cuts = problem.profile.breaks.clone();
    let mut others = vec![x];
    if let SmoothKernel::Periodic { period } = problem.kernel {
        cuts.extend(problem.profile.breaks.iter().flat_map(|at| [at - period, at + period]));
        others.extend([x - period, x + period]);
    }
    cuts.extend(others);
    let kernel = |d: f64| match problem.kernel {
        SmoothKernel::Plane => -d.abs().ln(),
        SmoothKernel::Periodic { period } => -(2.0 * (PI * d / period).sin().abs()).ln(),
    };
    let density = |s: f64, p: f64| if s == x { 0.0 } else { kernel(x - s) * p };
    problem.theta0 * over_zones(contact, &cuts, density)
}

/// The equation, the signs and the balance, by quadrature.
pub(crate) fn holds(contact: &SmoothContact, tolerance: f64, what: &str) {
    let problem = contact.problem();
    let scale = problem.theta0 * contact.force0().abs() + contact.settlement0().abs();
    let mut largest = 0.0f64;
    for &[left, right] in &problem.pieces {
        for i in 1..40 {
            let x = left + (right - left) * (f64::from(i) + 0.1234) / 40.2;
            let depth = contact.settlement0() - contact.tilt0() * x - (problem.profile.height)(x);
            let gap = displacement(contact, x) - depth;
            let p = contact.pressure0(x);
            largest = largest.max(p.abs());
            let known = contact.gap0(x);
            assert!((gap - known).abs() < tolerance * scale, "{what}: {x}: {gap:e} {known:e}");
            if problem.is_unilateral {
                assert!(gap >= -tolerance * scale, "{what}: {x}: {gap:e}");
                assert!(p >= -tolerance * largest, "{what}: {x}: {p:e}");
            }
        }
    }
    let breaks = &problem.profile.breaks;
    let force = over_zones(contact, breaks, |_, p| p);
    close(force, contact.force0(), 10.0 * tolerance, what);
    // Of a wave whose zones lie over the seam the moment has its own test.
    let is_wave = matches!(problem.kernel, SmoothKernel::Periodic { period } if period <= 2.0);
    let moment =
        if is_wave { contact.moment0() } else { over_zones(contact, breaks, |x, p| x * p) };
    let error = (moment - contact.moment0()).abs();
    assert!(error < 10.0 * tolerance * contact.force0().abs(), "{what}: moment {moment}");
    if problem.is_unilateral {
        for zone in contact.zones() {
            for side in 0..2 {
                assert!(zone.intensity0[side] >= 0.0, "{what}: {zone:?}");
            }
        }
        let left = contact.complementarity();
        assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{what}: {left:?}");
    }
}
