//! Bilateral contact for very many `theta0` and loads, by one eigendecomposition.

use fredholm::SincOperator;
use fredholm::collocation::{Sweep, SweepValue};
use fredholm::kernel::Logarithm;

use crate::{ContactKind, Error, Geometry, Law, Load, MethodChoice, Problem, Rotational, Vertical};

/// Numbers of nodes that are tried, on either side of the middle: each is 1.4 times the one before, as where a solve refines.
const HALF_COUNTS: [usize; 6] = [48, 68, 96, 136, 192, 272];
/// How many `theta0` of the range tell what two numbers of nodes differ by, besides its ends.
const PROBES: usize = 48;
/// Relative error of the sums over the modes up to `theta0 = 1e4`, twice what was measured there (`Sweep` of `fredholm`); beyond, it grows with `theta0`.
const ROUNDING: f64 = 2e-12;
const MEASURED_TO: f64 = 1e4;
/// Cases that are taken together.
const BLOCK: usize = 1024;
/// A sweep that states more than this is none: what its profile shows is not resolved.
const MOST: f64 = 1e-9;

/// The contacts of a dimensionless bilateral problem for all `theta0` up to a largest one, without their pressure between the edges: millions in a second.
///
/// ```
/// use shtaerman::{Foundation, Load, Problem, Profile, Punch, Solver, Swept};
///
/// let crowned = Punch::new(1.0)?.with_profile(Profile::expression("xi^2")?);
/// let problem = Problem::new(Foundation::dimensionless(1.0)?, crowned, Load::force(2.0)?)?;
/// let problem = problem.with_solver(Solver::bilateral());
/// let sweep = problem.theta0_sweep([0.5, 50.0])?.unwrap();
/// let mut swept = [Swept::default(); 2];
/// sweep.run(&[0.5, 50.0], &mut swept);
/// let single = problem.with_theta0(50.0)?.solve()?;
/// assert!((swept[1].settlement / single.settlement() - 1.0).abs() < 2.0 * sweep.relative_error() + 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Theta0Sweep {
    sweep: Sweep,
    load: Load,
    /// The height that was taken from the profile.
    level: f64,
    relative_error: f64,
}

/// What a sweep tells of one `theta0`, without dimensions; NaN beyond the range of the sweep.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Swept {
    /// `delta/(chi E)`.
    pub settlement: f64,
    /// `a alpha/(chi E)`.
    pub tilt: f64,
    /// `P/(a E)`.
    pub force: f64,
    /// `M/(a^2 E)`.
    pub moment: f64,
    /// `p/E` at the left edge.
    pub pressure_left: f64,
    /// `p/E` at the right edge.
    pub pressure_right: f64,
    /// `d(P, M)/d(delta, -alpha)`.
    pub stiffness: [[f64; 2]; 2],
}

/// A load on a share of the profile: contacts are linear in the values of the load and in this share.
#[derive(Debug, Clone, Copy)]
struct Case {
    load: Load,
    profile: f64,
}

/// The contacts of [`Theta0Sweep`] for loads of the same kinds with other values, by [`Problem::load_sweep`].
#[derive(Debug, Clone)]
pub struct LoadSweep {
    sweep: Theta0Sweep,
    kinds: Load,
}

/// Absolute errors of what a sweep tells; estimates.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SweptErrors {
    /// Of settlement and tilt.
    pub displacement: f64,
    /// Of the pressures.
    pub pressure: f64,
    /// Of force and moment, where they are not prescribed.
    pub force: f64,
}

/// A contact of a [`LoadSweep`] with its errors.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LoadSwept {
    /// The contact.
    pub contact: Swept,
    /// Its errors.
    pub errors: SweptErrors,
}

/// Three cases whose contacts add up to that of a load: the first value on a flat base, the second on a flat base, and the profile without a load.
fn parts(kinds: &Load, [first, second]: [f64; 2]) -> [Case; 3] {
    let load = |first: f64, second: f64| Load {
        vertical: kinds.vertical.mapped(|_| first, |_| first),
        rotational: match kinds.rotational() {
            Rotational::Tilt(_) => Rotational::Tilt(second),
            Rotational::Moment(_) | Rotational::Eccentricity(_) => Rotational::Moment(second),
        },
    };
    [
        Case { load: load(first, 0.0), profile: 0.0 },
        Case { load: load(0.0, second), profile: 0.0 },
        Case { load: load(0.0, 0.0), profile: 1.0 },
    ]
}

/// The two values of a load.
fn values(load: &Load) -> [f64; 2] {
    let (Vertical::Force(first) | Vertical::Settlement(first)) = load.vertical();
    [first, load.rotational().named().1]
}

impl LoadSweep {
    /// The error relative to the size of each of the parts that a contact is the sum of: the first value of the load, the second and the profile. An estimate.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        self.sweep.relative_error
    }

    /// The contact at a `theta0` of the range, with the values of a load of the kinds of the problem; NaN for other kinds and beyond the range.
    #[must_use]
    pub fn at(&self, theta0: f64, load: &Load) -> LoadSwept {
        self.told(&self.sweep.sweep.at(theta0), load)
    }

    /// The contacts at many `theta0`, each with its load, as many as the shortest of the lists has. Each depends on its own `theta0` and load alone.
    pub fn run(&self, theta0: &[f64], loads: &[Load], swept: &mut [LoadSwept]) {
        let mut values = [SweepValue::default(); BLOCK];
        let cases = theta0.chunks(BLOCK).zip(loads.chunks(BLOCK)).zip(swept.chunks_mut(BLOCK));
        for ((theta0, loads), swept) in cases {
            let values = &mut values[..theta0.len()];
            self.sweep.sweep.run(theta0, values);
            for ((value, load), place) in values.iter().zip(loads).zip(swept) {
                *place = self.told(value, load);
            }
        }
    }

    fn told(&self, value: &SweepValue, load: &Load) -> LoadSwept {
        let given = values(load);
        let [vertical, rotational, profile] = parts(&self.kinds, given);
        if vertical.load.vertical() != load.vertical()
            || rotational.load.rotational() != load.rotational()
        {
            let nothing = f64::NAN;
            let errors = SweptErrors { displacement: nothing, pressure: nothing, force: nothing };
            return LoadSwept { contact: Swept::NOTHING, errors };
        }
        let contact = self.sweep.contact(value, &Case { load: *load, profile: 1.0 });
        // The error of a sum is at most the sum of the errors of its parts, however much these cancel.
        let mut sizes = [0.0; 3];
        for part in [vertical, rotational, profile] {
            let of_part = self.sweep.contact(value, &part).sizes();
            sizes.iter_mut().zip(of_part).for_each(|(sum, size)| *sum += size);
        }
        let [displacement, pressure, force] = sizes.map(|size| self.sweep.relative_error * size);
        LoadSwept { contact, errors: SweptErrors { displacement, pressure, force } }
    }
}

impl Swept {
    /// Beyond what a sweep can tell.
    const NOTHING: Self = Self {
        settlement: f64::NAN,
        tilt: f64::NAN,
        force: f64::NAN,
        moment: f64::NAN,
        pressure_left: f64::NAN,
        pressure_right: f64::NAN,
        stiffness: [[f64::NAN; 2]; 2],
    };

    /// What errors of displacements, of pressures and of forces are relative to, for a load of its size.
    #[must_use]
    pub fn sizes(&self) -> [f64; 3] {
        let [settlement, tilt] = [self.settlement.abs(), self.tilt.abs()];
        let pressure = self.pressure_left.abs().max(self.pressure_right.abs());
        let pressure = pressure.max(0.5 * self.force.abs());
        [settlement.max(tilt).max(pressure), pressure, self.force.abs().max(self.moment.abs())]
    }

    /// The largest difference of two, relative to the sizes.
    fn apart(&self, other: &Self) -> f64 {
        let [displacement, pressure, force] = self.sizes();
        let pairs = [
            (self.settlement - other.settlement, displacement),
            (self.tilt - other.tilt, displacement),
            (self.pressure_left - other.pressure_left, pressure),
            (self.pressure_right - other.pressure_right, pressure),
            (self.force - other.force, force),
            (self.moment - other.moment, force),
        ];
        let apart = |(by, size): (f64, f64)| if by == 0.0 { 0.0 } else { (by / size).abs() };
        // NaN counts as infinitely far.
        pairs.into_iter().map(apart).fold(0.0, |most, by| if by <= most { most } else { by })
    }
}

impl Problem {
    /// A sweep over `theta0` from the least to the largest of a range; none where there is no such sweep, and single solves tell: other problems than dimensionless ones of one plane punch,
    /// in bilateral contact by the method that suits it, on a homogeneous body with a linear layer; profiles with kinks, points or features that are not resolved.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the range is finite and not negative; [`Error::ProfileNotFinite`]; [`Error::Equation`] where the kernel cannot be decomposed.
    pub fn theta0_sweep(&self, range: [f64; 2]) -> Result<Option<Theta0Sweep>, Error> {
        self.refined(range, &[Case { load: *self.load(), profile: 1.0 }])
    }

    /// A sweep over `theta0` from the least to the largest of a range in which the values of the load vary too; none where [`theta0_sweep`](Self::theta0_sweep) has none, and for a force with an
    /// eccentricity.
    ///
    /// # Errors
    /// As [`theta0_sweep`](Self::theta0_sweep).
    ///
    /// ```
    /// use shtaerman::{Foundation, Load, Problem, Profile, Punch, Solver, Swept};
    ///
    /// let crowned = Punch::new(1.0)?.with_profile(Profile::expression("xi^2")?);
    /// let problem = Problem::new(Foundation::dimensionless(1.0)?, crowned, Load::force(2.0)?)?;
    /// let problem = problem.with_solver(Solver::bilateral());
    /// let sweep = problem.load_sweep([0.5, 50.0])?.unwrap();
    /// let load = Load::force(3.0)?.with_moment(0.5)?;
    /// let swept = sweep.at(20.0, &load);
    /// let single = problem.with_theta0(20.0)?.with_force(3.0)?.with_moment(0.5)?.solve()?;
    /// assert!((swept.contact.tilt - single.tilt()).abs() < 2.0 * swept.errors.displacement);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn load_sweep(&self, range: [f64; 2]) -> Result<Option<LoadSweep>, Error> {
        if matches!(self.load().rotational(), Rotational::Eccentricity(_)) {
            return Ok(None);
        }
        let sweep = self.refined(range, &parts(self.load(), [1.0, 1.0]))?;
        Ok(sweep.map(|sweep| LoadSweep { sweep, kinds: *self.load() }))
    }

    /// The sweep on the first nodes on which all of these cases agree with those on fewer nodes, at all probes of the range.
    fn refined(&self, range: [f64; 2], cases: &[Case]) -> Result<Option<Theta0Sweep>, Error> {
        let [least, largest] = range;
        for theta0 in range {
            let requirement = "finite and not negative";
            crate::error::require(
                theta0.is_finite() && theta0 >= 0.0,
                "theta0",
                theta0,
                requirement,
            )?;
        }
        if !self.can_be_swept() {
            return Ok(None);
        }
        let mut before: Option<(Theta0Sweep, Vec<Swept>)> = None;
        let probes = probes(least, largest);
        for half_count in HALF_COUNTS {
            let mut sweep = self.swept_on(half_count, largest)?;
            let mut found = Vec::with_capacity(probes.len() * cases.len());
            for theta0 in &probes {
                let value = sweep.sweep.at(*theta0);
                found.extend(cases.iter().map(|case| sweep.contact(&value, case)));
            }
            if let Some((_, coarse)) = &before {
                let pairs = found.iter().zip(coarse);
                let apart = pairs.map(|(fine, coarse)| fine.apart(coarse)).fold(0.0, f64::max);
                let rounding = ROUNDING * (largest / MEASURED_TO).max(1.0);
                if apart <= rounding || half_count == HALF_COUNTS[HALF_COUNTS.len() - 1] {
                    sweep.relative_error = apart + rounding;
                    return Ok(Some(sweep).filter(|sweep| sweep.relative_error <= MOST));
                }
            }
            before = Some((sweep, found));
        }
        Ok(None)
    }

    fn can_be_swept(&self) -> bool {
        let (foundation, solver, profile) = (self.foundation(), self.solver(), self.profile());
        self.is_dimensionless()
            && self.punch().geometry() == Geometry::Plane
            && foundation.law() == Law::Linear
            && foundation.layering().is_none()
            && solver.contact() == ContactKind::Bilateral
            && solver.method() == MethodChoice::Auto
            && solver.degree().is_none()
            && solver.tolerance().is_none()
            && profile.measured_points().is_none()
            && profile.breakpoints(1.0).is_empty()
    }

    fn swept_on(&self, half_count: usize, largest: f64) -> Result<Theta0Sweep, Error> {
        let operator = SincOperator::new(&Logarithm::unit(), half_count)?;
        let level = self.finite_profile(0.0)?;
        let profile = operator.sample(|xi| self.dimensionless_profile(xi) - level)?;
        let ends = [self.finite_profile(-1.0)? - level, self.finite_profile(1.0)? - level];
        let sweep = operator.spectrum()?.sweep(&profile, ends, largest)?;
        Ok(Theta0Sweep { sweep, load: *self.load(), level, relative_error: f64::INFINITY })
    }
}

/// Places of the range, evenly in its logarithm over the decades in which contacts change, with its ends.
fn probes(least: f64, largest: f64) -> Vec<f64> {
    let from = least.max(1e-3 * largest.min(1.0)).max(f64::MIN_POSITIVE);
    let step = (largest / from).max(1.0).ln() / (PROBES + 1) as f64;
    let inside = (1..=PROBES).map(|k| (from * (step * k as f64).exp()).clamp(least, largest));
    [least, largest].into_iter().chain(inside).collect()
}

impl Theta0Sweep {
    /// The error of what it tells, relative to the [sizes](Swept::sizes): what two numbers of nodes differ by, and rounding. An estimate.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        self.relative_error
    }

    /// The contacts at many `theta0`, as many as the shorter of the two lists has. Each depends on its own `theta0` alone.
    pub fn run(&self, theta0: &[f64], swept: &mut [Swept]) {
        let mut values = [SweepValue::default(); BLOCK];
        for (theta0, swept) in theta0.chunks(BLOCK).zip(swept.chunks_mut(BLOCK)) {
            let values = &mut values[..theta0.len().min(swept.len())];
            self.sweep.run(theta0, values);
            for (value, place) in values.iter().zip(swept) {
                *place = self.contact(value, &Case { load: self.load, profile: 1.0 });
            }
        }
    }

    /// With `phi = delta phi_1 - alpha phi_x - phi_f`, force and moment are linear in settlement and tilt: two equations for what the load leaves unknown.
    fn contact(&self, value: &SweepValue, case: &Case) -> Swept {
        let Case { load, profile } = case;
        let (a, b, c) = (value.one_one, value.one_x, value.x_x);
        let (p, m, level) = (profile * value.one_f, profile * value.x_f, profile * self.level);
        // Coefficients of settlement and tilt, and the right-hand side.
        let vertical = match load.vertical() {
            Vertical::Force(force) => [a, -b, force + p],
            Vertical::Settlement(settlement) => [1.0, 0.0, settlement - level],
        };
        let rotational = match load.rotational() {
            Rotational::Moment(moment) => [b, -c, moment + m],
            Rotational::Eccentricity(e) => [b - e * a, e * b - c, m - e * p],
            Rotational::Tilt(tilt) => [0.0, 1.0, tilt],
        };
        let cross = |i: usize, j: usize| vertical[i] * rotational[j] - vertical[j] * rotational[i];
        let (settlement, tilt) = (cross(2, 1) / cross(0, 1), cross(0, 2) / cross(0, 1));
        let force = load.vertical.force().unwrap_or(a * settlement - b * tilt - p);
        let moment = match load.rotational() {
            Rotational::Moment(moment) => moment,
            Rotational::Eccentricity(e) => e * force,
            Rotational::Tilt(_) => b * settlement - c * tilt - m,
        };
        let [left, right] = [0, 1].map(|end| {
            settlement * value.ends_one[end]
                - tilt * value.ends_x[end]
                - profile * value.ends_f[end]
        });
        Swept {
            // What is prescribed is told as it was given.
            settlement: load.vertical.settlement().unwrap_or(settlement + level),
            tilt: load.rotational.tilt().unwrap_or(tilt),
            force,
            moment,
            pressure_left: left,
            pressure_right: right,
            stiffness: [[a, b], [b, c]],
        }
    }
}
