//! Bilateral contact by the degenerate kernel, sections 2 and 3.

use std::sync::OnceLock;

use fredholm::basis::{ChebyshevSeries, ChebyshevTable, Function, chebyshev};
use fredholm::bounds::{Given, IteratedSolution, Kind, ResidualOperator, Responses};
use fredholm::kernel::Logarithm;
use fredholm::{DegenerateSolution, DegenerateSolver};

use super::accuracy::{Accuracy, ErrorKind, ROUNDING};
use super::balance::{Balance, State};
use super::method::{Method, MethodName};
use super::rates::Linearised;
use super::resolutions::UNKNOWN;
use super::setting::Setting;
use super::solution::Solution;
use super::stiffness::Stiffness;
use crate::solver::{AIM, UNRESOLVED};
use crate::{Error, Load, Rotational, Vertical};

/// First degree where none is given, and fewest samples of a pressure. From here on a series is tabulated: the table costs as much as some 50 sums, and an audit asks for thousands. Half and twice change none of 9 answers (survey).
const FIRST_DEGREE: usize = 1024;
/// Last degree where neither a degree nor a tolerance is given, and most samples.
const USUAL_DEGREE: usize = 1 << 17;
/// Last degree under an explicit tolerance.
const LAST_DEGREE: usize = 1 << 19;
/// Samples for each Chebyshev degree that the profile needs. Half and twice change none of 10 answers (survey).
const SAMPLES_PER_DEGREE: usize = 4;

/// The Chebyshev series of the profile.
pub(super) fn profile_series(setting: &Setting) -> Result<Function, Error> {
    setting.problem().resolved_profile()
}

/// The pressure on the full base of one punch by the degenerate kernel.
#[derive(Debug, Clone)]
pub(super) struct SpectralContact {
    setting: Setting,
    balance: Balance,
    state: State,
    /// `theta0 K p0 = sum c_m T_m(xi)` on the base.
    potential: ChebyshevSeries,
    /// The same as a table, once a value of a long series is asked for.
    table: OnceLock<ChebyshevTable>,
    degree: usize,
    accuracy: Option<Accuracy>,
    /// Sharper pressures at the left and right edge, by the iterated solution.
    edges: Option<[f64; 2]>,
    /// The degree that shows the features of the profile, and the error of its series where it was not resolved.
    profile_degree: usize,
    profile_error: Option<f64>,
}

impl SpectralContact {
    /// With the highest Chebyshev degree `degree`: closed-form Gram matrix (3.4), even and odd systems (3.10) and (3.11), symmetric positive form,
    /// Cholesky or, for many terms, conjugate gradients with fast products. No statement of the error.
    pub(super) fn new(setting: &Setting, profile: &Function, degree: usize) -> Result<Self, Error> {
        Ok(Truncated::new(&Logarithm::unit(), setting, profile, degree)?.contact())
    }

    /// The same with the guaranteed bounds of its error; an estimate where the profile is not resolved or `n` is far below `theta0`.
    pub(super) fn with_bounds(
        setting: &Setting,
        profile: &Function,
        degree: usize,
    ) -> Result<Self, Error> {
        let kernel = Logarithm::unit();
        let truncated = Truncated::new(&kernel, setting, profile, degree)?;
        let mut contact = truncated.contact();
        let bounds = truncated.accuracy(&contact.state)?;
        let mut accuracy = if bounds.is_finite() {
            bounds
        } else {
            // Far below n = theta0 the energies are not known to be positive, and there is no bound: twice the degree gives an estimate.
            contact.difference(&Self::new(setting, profile, degree.saturating_mul(2))?)
        };
        if setting.has_unknown_layer() {
            accuracy = accuracy.of_the_unknown(UNKNOWN, &contact.state.sizes(contact.largest()));
        }
        contact.accuracy = Some(accuracy);
        Ok(contact)
    }

    /// Doubles the degree until the tolerance is met, or the last degree is reached; once, where none leaves less than 1e-2 of the pressure.
    pub(super) fn adaptive(setting: &Setting, profile: &Function) -> Result<Self, Error> {
        let (theta0, tolerance) = (setting.theta0(), setting.problem().solver().tolerance);
        let last = if tolerance.is_some() { LAST_DEGREE } else { USUAL_DEGREE };
        let tolerance = tolerance.unwrap_or(AIM);
        let resolves = theta0 < UNRESOLVED * last as f64;
        let first = if resolves { (4.0 * theta0).min(last as f64) as usize } else { 0 };
        let mut degree = first.max(FIRST_DEGREE).next_power_of_two();
        loop {
            let mut contact = Self::with_bounds(setting, profile, degree)?;
            let is_over = !resolves || 2 * degree > last || setting.problem().deadline().is_past();
            if contact.relative_to_samples() <= tolerance || is_over {
                // Below n = 2 theta0 the exact application of the kernel amplifies the error.
                if degree as f64 >= 2.0 * theta0 {
                    contact.edges = Some(contact.iterated_edges(profile));
                }
                return Ok(contact);
            }
            degree *= 2;
        }
    }

    /// The error of the series that stood for the profile, where it was not resolved.
    pub(super) fn profile_error(&self) -> Option<f64> {
        self.profile_error
    }

    /// The pressures at the left and right edge by one exact application of the kernel to the degenerate solution: their error falls nearly as `n^-4`, that of
    /// the plain ones as `n^-2`.
    pub(super) fn iterated_edges(&self, profile: &Function) -> [f64; 2] {
        let State { settlement, tilt, .. } = self.state;
        let mut right: Vec<f64> = profile.series().coefficients().iter().map(|c| -c).collect();
        right.resize(right.len().max(2), 0.0);
        right[0] += settlement;
        right[1] -= tilt;
        let series = ChebyshevSeries::new(right);
        let correction = self.potential.coefficients();
        let iterated = IteratedSolution::new(self.setting.theta0(), &series, correction);
        [-1.0, 1.0]
            .map(|xi| iterated.evaluate(xi, settlement - tilt * xi - self.setting.height(xi)))
    }

    /// `theta0 K p0` on the base.
    fn potential(&self, xi: f64) -> f64 {
        if self.potential.degree() < FIRST_DEGREE {
            return self.potential.evaluate(xi);
        }
        self.table.get_or_init(|| ChebyshevTable::new(&self.potential)).evaluate(xi)
    }

    /// `p0(xi)`, given the potential there.
    fn plain_pressure(&self, xi: f64, potential: f64) -> f64 {
        let State { settlement, tilt, .. } = self.state;
        settlement - tilt * xi - self.setting.height(xi) - potential
    }

    /// Places from left to right with the pressures there, dense enough for a profile of this Chebyshev degree.
    fn samples(&self, profile_degree: usize) -> (Vec<f64>, Vec<f64>) {
        let wanted = (SAMPLES_PER_DEGREE * profile_degree).clamp(FIRST_DEGREE, USUAL_DEGREE);
        let potential = self.potential.values(wanted.next_power_of_two());
        let mut places = chebyshev::points(potential.len() - 1);
        let mut pressures: Vec<f64> =
            places.iter().zip(&potential).map(|(&xi, u)| self.plain_pressure(xi, *u)).collect();
        places.reverse();
        pressures.reverse();
        if let Some([left, right]) = self.edges {
            pressures[0] = left;
            pressures[potential.len() - 1] = right;
        }
        (places, pressures)
    }

    /// The largest `|p0|` of few samples.
    fn largest(&self) -> f64 {
        let (_, pressures) = self.samples(0);
        pressures.into_iter().fold(0.0f64, |most, p| most.max(p.abs()))
    }

    /// The error relative to its size, that of the pressure to the largest of few samples.
    fn relative_to_samples(&self) -> f64 {
        let sizes = self.state.sizes(self.largest());
        self.accuracy.map_or(f64::INFINITY, |accuracy| accuracy.relative(&sizes))
    }

    /// Differences from the solution of another degree, the pressure's by one transform.
    fn difference(&self, other: &Self) -> Accuracy {
        let settlement = self.state.settlement - other.state.settlement;
        let tilt = self.state.tilt - other.state.tilt;
        let (one, two) = (self.potential.coefficients(), other.potential.coefficients());
        let mut difference = vec![0.0; one.len().max(two.len()).max(2)];
        difference.iter_mut().zip(one).for_each(|(d, c)| *d -= c);
        difference.iter_mut().zip(two).for_each(|(d, c)| *d += c);
        difference[0] += settlement;
        difference[1] -= tilt;
        let degree = 2 * difference.len();
        let values = ChebyshevSeries::new(difference).values(degree);
        Accuracy {
            kind: ErrorKind::Estimate,
            pressure: values.into_iter().fold(0.0f64, |most, v| most.max(v.abs())),
            settlement: settlement.abs(),
            tilt: tilt.abs(),
            force: (self.state.force - other.state.force).abs(),
            moment: (self.state.moment - other.state.moment).abs(),
        }
    }

    /// `theta0 K p0` beside the base.
    ///
    /// With `xi = (z + 1/z)/2`, `|z| > 1`, the kernel is `-ln(|z|/2) + sum_{m>0} (2/m) z^-m T_m(eta)`, so the displacement is the series under the punch with the
    /// powers of `1/z` in place of `T_m(xi)`: continuous at the edges, and more accurate the farther away, as the terms beyond `n` fall as `z^-n`.
    fn beside(&self, xi: f64) -> f64 {
        let distance = xi.abs();
        let z = distance + (distance - 1.0).sqrt() * (distance + 1.0).sqrt();
        let inverse = xi.signum() / z;
        // Coefficient 0 is theta0 P0 ln 2; outside, ln 2 becomes ln 2 - ln z.
        let coefficients = self.potential.coefficients();
        let series = coefficients.iter().rev().fold(0.0, |sum, c| c + inverse * sum);
        series - self.setting.theta0() * self.state.force * z.ln()
    }
}

impl Solution for SpectralContact {
    fn state(&self) -> State {
        self.state
    }

    fn stiffness(&self) -> Stiffness {
        self.balance.stiffness
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        vec![[-1.0, 1.0]]
    }

    fn pressure(&self, xi: f64) -> f64 {
        match self.edges {
            Some([left, _]) if xi == -1.0 => left,
            Some([_, right]) if xi == 1.0 => right,
            _ => self.plain_pressure(xi, self.potential(xi)),
        }
    }

    fn displacement(&self, xi: f64) -> f64 {
        if xi.abs() <= 1.0 { self.potential(xi) } else { self.beside(xi) }
    }

    fn sample(&self) -> (Vec<f64>, Vec<f64>) {
        self.samples(self.profile_degree)
    }

    fn method(&self) -> Method {
        Method { name: MethodName::Spectral, n: self.degree }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        self.accuracy.as_ref()
    }

    fn relative_error(&self) -> f64 {
        self.relative_to_samples()
    }

    fn linearised(&self, load: Load, peak: f64) -> Option<Linearised> {
        let displacement = |xi: f64| self.displacement(xi);
        let found = self.setting.linearised_whole_base(&displacement, self.profile_degree, peak)?;
        Some(found.with_stiffness(&self.stiffness(), &load))
    }

    fn size(&self) -> f64 {
        let potential: f64 = self.potential.coefficients().iter().map(|c| c.abs()).sum();
        self.state.settlement.abs() + self.state.tilt.abs() + potential
    }
}

/// The answers of the degenerate equation to the right-hand sides `1`, `xi` and `f0`, (3.6).
struct Truncated<'s, 'k> {
    setting: &'s Setting,
    profile: &'s Function,
    kernel: &'k Logarithm,
    /// To `1`, `xi` and `f0`.
    level: DegenerateSolution<'k, Logarithm>,
    tilted: DegenerateSolution<'k, Logarithm>,
    bent: DegenerateSolution<'k, Logarithm>,
    degree: usize,
}

impl<'s, 'k> Truncated<'s, 'k> {
    fn new(
        kernel: &'k Logarithm,
        setting: &'s Setting,
        profile: &'s Function,
        degree: usize,
    ) -> Result<Self, Error> {
        let solver = DegenerateSolver::new(kernel, setting.theta0(), degree)?;
        let moments = |series: &ChebyshevSeries| series.moments(degree + 1);
        let (level, tilted) = (solver.solve(&moments(&one()))?, solver.solve(&moments(&linear()))?);
        let bent = solver.solve(&moments(profile.series()))?;
        Ok(Self { setting, profile, kernel, level, tilted, bent, degree })
    }

    fn contact(&self) -> SpectralContact {
        let balance = Balance {
            centre: 0.0,
            stiffness: Stiffness {
                force_settlement: self.level.projections()[0],
                coupling: self.tilted.projections()[0],
                moment_tilt: self.tilted.projections()[1],
            },
            free: [self.bent.projections()[0], self.bent.projections()[1]],
        };
        let state = balance.state(&self.setting.load());
        let potential = (self.level.correction().iter())
            .zip(self.tilted.correction())
            .zip(self.bent.correction())
            .map(|((level, tilted), bent)| state.settlement * level - state.tilt * tilted - bent)
            .collect();
        SpectralContact {
            setting: self.setting.clone(),
            balance,
            state,
            potential: ChebyshevSeries::new(potential),
            table: OnceLock::new(),
            degree: self.degree,
            accuracy: None,
            edges: None,
            profile_degree: self.profile.series().degree(),
            profile_error: (!self.profile.is_resolved()).then(|| self.profile.error()),
        }
    }

    /// Bounds from residual, energy and positivity; the profile counts as its Chebyshev series.
    fn accuracy(&self, state: &State) -> Result<Accuracy, Error> {
        let profile = self.profile;
        let degree = (self.level.correction().len() - 1).max(profile.series().degree());
        let operator = ResidualOperator::new(self.kernel, self.setting.theta0(), degree)?;
        let kind = if profile.is_resolved() { Kind::Bound } else { Kind::Estimate };
        let approximate = |right: &ChebyshevSeries,
                           solution: &DegenerateSolution<'_, Logarithm>| {
            operator.approximation(right, solution.correction(), kind)
        };
        let responses = Responses::new(
            approximate(&one(), &self.level)?,
            approximate(&linear(), &self.tilted)?,
            approximate(profile.series(), &self.bent)?,
        )?;
        // p = c_1 A^-1 1 + c_2 A^-1 xi - A^-1 f with c_1 = delta, c_2 = -alpha.
        let load = self.setting.load();
        let given = [
            match load.vertical {
                Vertical::Force(force) => Given::Projection(force),
                Vertical::Settlement(settlement) => Given::Coefficient(settlement),
            },
            match load.rotational {
                Rotational::Moment(moment) => Given::Projection(moment),
                Rotational::Tilt(tilt) => Given::Coefficient(-tilt),
                Rotational::Eccentricity(eccentricity) => Given::Quotient(eccentricity),
            },
        ];
        let combination = responses.combine_with(given, [state.settlement, -state.tilt]);
        let ([settlement, slope], [force, moment]) =
            (combination.coefficients(), combination.projections());
        let kind = match combination.kind() {
            Kind::Bound => ErrorKind::Bound,
            Kind::Estimate => ErrorKind::Estimate,
        };
        let exact = Accuracy {
            kind,
            pressure: combination.error_supremum(),
            settlement: settlement.error_of(state.settlement),
            tilt: slope.error_of(-state.tilt),
            force: force.error_of(state.force),
            moment: moment.error_of(state.moment),
        };
        // The bounds leave rounding aside.
        let sizes = state.sizes(profile.largest() + state.settlement.abs());
        let rounded = exact.at_least(ROUNDING, &sizes);
        if profile.is_resolved() {
            return Ok(rounded);
        }
        let stiffness = [self.level.projections()[0], self.tilted.projections()[1]];
        Ok(rounded.with_profile_error(profile.error() * profile.largest(), stiffness))
    }
}

fn one() -> ChebyshevSeries {
    ChebyshevSeries::new(vec![1.0])
}

fn linear() -> ChebyshevSeries {
    ChebyshevSeries::new(vec![0.0, 1.0])
}
