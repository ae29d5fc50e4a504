//! The profile that gives a prescribed pressure.
//!
//! `f0 = delta0 - alpha0 xi - law(p0) - theta0 int ln(1/|xi - eta|) p0(eta) deta`: the equation read from right to left, no system to solve.

use fredholm::basis::chebyshev;
use fredholm::kernel::Logarithm;
use fredholm::{SincOperator, SincSolution};

use super::InverseError;
use crate::expression::{Expression, Interval, Line};
use crate::profile::VARIABLES;
use crate::quantity::{Dimension, engineering};
use crate::{ContactKind, Error, Geometry, Problem, Rotational, Scaling, Vertical};

/// Nodes on either side of the middle of a panel, at first and at most.
const HALF_COUNTS: std::ops::RangeInclusive<usize> = 32..=1024;
/// Difference of two resolutions, relative to the size of the profile, that is as good as none.
const SETTLED: f64 = 1e-14;
/// Points of a panel at which pressures are looked at and resolutions compared.
const COMPARED: usize = 512;
/// A pull below this share of the largest pressure, and a moment off by this share of `P a`, count as none.
const PULL: f64 = 1e-12;
const OFF: f64 = 1e-9;
const NO_MOMENT: f64 = 1e-15;
/// Offset at which both sides of a breakpoint are compared, and the share of the largest pressure that makes a jump.
const BESIDE: f64 = 1e-9;
const JUMP: f64 = 1e-6;

/// Where a profile is zero: it is known up to a constant, which the settlement takes up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Normalisation {
    /// `f(0) = 0`.
    #[default]
    Centre,
    /// The lowest of its points is zero.
    Lowest,
}

/// The profile that gives a prescribed pressure, in the units of the problem.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaped {
    /// Places, from edge to edge and denser at the edges and at breakpoints of the pressure.
    pub places: Vec<f64>,
    /// Heights of the base there.
    pub heights: Vec<f64>,
    /// Pressures there.
    pub pressures: Vec<f64>,
    /// Settlement of the punch with this profile under the load.
    pub settlement: f64,
    /// Its tilt: that which the load prescribes, else zero.
    pub tilt: f64,
    /// Force.
    pub force: f64,
    /// Moment of the pressure.
    pub moment: f64,
    /// What the pressure as written was multiplied with to balance the force.
    pub factor: f64,
    /// Estimated error of the heights.
    pub error: f64,
}

/// The profile under which the pressure is `pressure`, an expression in `x`, `xi` and `a` that is scaled to the force of the load; in place of the profile of the
/// problem, at `count` points or somewhat more.
///
/// # Errors
/// [`Error::InvalidValue`] for fewer than three points; [`Error::Inverse`] for a pressure that is not finite, jumps, carries no force, pulls (in unilateral
/// contact) or has another moment than the load, for a load without force, and for another geometry than one plane punch on a homogeneous body.
pub fn prescribed_pressure(
    problem: &Problem,
    pressure: &str,
    normalisation: Normalisation,
    count: usize,
) -> Result<Shaped, Error> {
    crate::error::require(count >= 3, "points", count as f64, "at least 3")?;
    let prescription = Prescription::new(problem, pressure)?;
    let (solution, error) = prescription.resolved()?;
    prescription.shaped(&solution, error, normalisation, count)
}

struct Prescription<'p> {
    problem: &'p Problem,
    expression: Expression,
    line: Line,
    breaks: Vec<f64>,
    /// `P0`.
    force: f64,
}

impl<'p> Prescription<'p> {
    fn new(problem: &'p Problem, pressure: &str) -> Result<Self, Error> {
        let bodies = problem.bodies();
        if bodies.geometry() != Geometry::Plane || !bodies.is_homogeneous() {
            let words = "the profile for a prescribed pressure is that of one plane punch on a homogeneous foundation";
            return Err(InverseError::Unsuited(words).into());
        }
        let Vertical::Force(force) = problem.dimensionless_load().vertical else {
            let words =
                "a prescribed pressure is scaled to the force: prescribe the force in [load]";
            return Err(InverseError::Unsuited(words).into());
        };
        let expression = Expression::parse(pressure, &VARIABLES)
            .map_err(|error| fault(format!("`{pressure}`: {error}")))?;
        let half_width = bodies.half_width();
        let line = Line::new(&[(0.0, half_width), (0.0, 1.0), (half_width, 0.0)]);
        if let Some(base) = Interval::new(-1.0, 1.0)
            && let Some((at, defect)) = expression.find_not_finite(&line, base)
        {
            let place = Self::place(problem, at);
            return Err(fault(format!("{defect} at {place}: it must be finite")));
        }
        let breaks = match Interval::new(-1.0, 1.0) {
            Some(base) => expression.breakpoints(&line, base).places,
            None => Vec::new(),
        };
        let breaks = breaks.into_iter().filter(|xi| xi.abs() < 1.0 - 1e-9).collect();
        let this = Self { problem, expression, line, breaks, force };
        this.refuse_jumps()?;
        Ok(this)
    }

    fn place(problem: &Problem, xi: f64) -> String {
        let bodies = problem.bodies();
        let unit = if bodies.scaling().is_some() { Dimension::LENGTH } else { Dimension::NONE };
        let x = engineering(xi * bodies.half_width(), unit);
        format!("{} = {x}", bodies.coordinate())
    }

    /// The pressure as written.
    fn value(&self, xi: f64) -> f64 {
        self.expression.evaluate_at(&self.line, xi)
    }

    fn panels(&self) -> Vec<[f64; 2]> {
        crate::order::parts([-1.0, 1.0], self.breaks.iter().copied())
    }

    fn largest(&self) -> f64 {
        self.samples().map(|xi| self.value(xi).abs()).fold(0.0, f64::max)
    }

    fn samples(&self) -> impl Iterator<Item = f64> {
        self.panels().into_iter().flat_map(|panel| on_panel(panel, COMPARED))
    }

    fn refuse_jumps(&self) -> Result<(), Error> {
        let largest = self.largest();
        for &place in &self.breaks {
            let jump = (self.value(place + BESIDE) - self.value(place - BESIDE)).abs();
            if jump > JUMP * largest {
                let place = Self::place(self.problem, place);
                return Err(fault(format!(
                    "jumps at {place}: the profile would need a step there, which no trace holds"
                )));
            }
        }
        Ok(())
    }

    /// The potential of the pressure as written, on growing numbers of nodes, and its error.
    fn resolved(&self) -> Result<(SincSolution, f64), Error> {
        let samples: Vec<f64> = self.samples().collect();
        let mut half_count = *HALF_COUNTS.start();
        let mut coarse = self.potential(half_count)?;
        let mut best = f64::INFINITY;
        loop {
            half_count *= 2;
            let fine = self.potential(half_count)?;
            let (mut error, mut size) = (0.0f64, 0.0f64);
            for &xi in &samples {
                let value = fine.evaluate_potential(xi);
                error = error.max((value - coarse.evaluate_potential(xi)).abs());
                size = size.max(value.abs());
            }
            let stalls = error > 0.5 * best;
            if error <= SETTLED * size || stalls || 2 * half_count > *HALF_COUNTS.end() {
                return Ok((fine, error.min(best).max(f64::EPSILON * size)));
            }
            (coarse, best) = (fine, error);
        }
    }

    fn potential(&self, half_count: usize) -> Result<SincSolution, Error> {
        let half_count = half_count.min(4000 / (self.breaks.len() + 1)).max(8);
        let operator = SincOperator::with_breaks(&Logarithm::unit(), half_count, &self.breaks)?;
        let values = operator.sample(|xi| self.value(xi))?;
        // Without the kernel the solution is the right-hand side, and has its potential.
        Ok(operator.factor(0.0)?.solve(&values)?)
    }

    fn shaped(
        &self,
        solution: &SincSolution,
        error: f64,
        normalisation: Normalisation,
        count: usize,
    ) -> Result<Shaped, Error> {
        let factor = self.factor(solution)?;
        self.refuse_pull(factor)?;
        let moment = factor * solution.integral(|xi| xi);
        // Rounding of a symmetric pressure is no moment.
        let moment = if moment.abs() <= NO_MOMENT * self.force.abs() { 0.0 } else { moment };
        let tilt = self.balanced_tilt(moment)?;
        let bodies = self.problem.bodies();
        let theta0 = bodies.theta0();
        let law = bodies.law();
        let depth = |xi: f64| {
            law.displacement(factor * self.value(xi))
                + theta0 * factor * solution.evaluate_potential(xi)
                + tilt * xi
        };
        let places = self.places(count);
        let settlement = match normalisation {
            Normalisation::Centre => depth(0.0),
            Normalisation::Lowest => {
                places.iter().map(|&xi| depth(xi)).fold(f64::NEG_INFINITY, f64::max)
            }
        };
        let displacement = bodies.unit(Scaling::displacement);
        Ok(Shaped {
            heights: places
                .iter()
                .map(|&xi| (settlement - depth(xi)) * displacement + 0.0)
                .collect(),
            pressures: places
                .iter()
                .map(|&xi| factor * self.value(xi) * bodies.unit(Scaling::pressure))
                .collect(),
            places: places.iter().map(|xi| xi * bodies.half_width()).collect(),
            settlement: settlement * displacement,
            tilt: tilt * bodies.unit(Scaling::angle),
            force: self.force * bodies.unit(Scaling::force),
            moment: moment * bodies.unit(Scaling::moment),
            factor: factor * bodies.unit(Scaling::pressure),
            error: 2.0 * theta0 * factor.abs() * error * displacement,
        })
    }

    /// What turns the pressure as written into `p0` that carries the force.
    fn factor(&self, solution: &SincSolution) -> Result<f64, Error> {
        let carried = solution.integral(|_| 1.0);
        let size = self.largest();
        let factor = self.force / carried;
        if carried.abs() <= 1e-12 * size || !(factor.is_finite() && factor != 0.0) {
            return Err(fault(
                "carries no force: it cannot be scaled to that of the load".to_owned(),
            ));
        }
        Ok(factor)
    }

    fn refuse_pull(&self, factor: f64) -> Result<(), Error> {
        if self.problem.solver().contact == ContactKind::Bilateral {
            return Ok(());
        }
        let floor = -PULL * factor.abs() * self.largest();
        match self.samples().find(|&xi| factor * self.value(xi) < floor) {
            Some(xi) => {
                let place = Self::place(self.problem, xi);
                Err(fault(format!(
                    "pulls at {place} once it carries the force: it must not be negative, or contact = \"bilateral\""
                )))
            }
            None => Ok(()),
        }
    }

    /// The tilt that the load prescribes, else zero; then the moment must be that of the load.
    fn balanced_tilt(&self, moment: f64) -> Result<f64, Error> {
        let wanted = match self.problem.dimensionless_load().rotational {
            Rotational::Tilt(tilt) => return Ok(tilt),
            Rotational::Moment(wanted) => wanted,
            Rotational::Eccentricity(eccentricity) => eccentricity * self.force,
        };
        if (moment - wanted).abs() <= OFF * self.force.abs() {
            return Ok(0.0);
        }
        let unit = self.problem.bodies().half_width();
        let physical = self.problem.bodies().scaling().is_some();
        let dimension = if physical { Dimension::LENGTH } else { Dimension::NONE };
        let shown = |moment: f64| engineering(moment / self.force * unit, dimension);
        Err(fault(format!(
            "acts at an eccentricity of {}, the load at {}: they must agree (load.eccentricity), or the load prescribe the tilt",
            shown(moment),
            shown(wanted)
        )))
    }

    /// Points of each panel, denser at its ends, and the centre.
    fn places(&self, count: usize) -> Vec<f64> {
        let panels = self.panels();
        let degree = (count.saturating_sub(1)).div_ceil(panels.len()).max(2);
        let mut places: Vec<f64> =
            panels.into_iter().flat_map(|panel| on_panel(panel, degree)).collect();
        places.push(0.0);
        places.sort_by(f64::total_cmp);
        places.dedup_by(|one, two| (*one - *two).abs() <= 4.0 * f64::EPSILON);
        places
    }
}

/// `degree + 1` Chebyshev points of a panel, its ends exact.
fn on_panel([left, right]: [f64; 2], degree: usize) -> impl Iterator<Item = f64> {
    let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
    chebyshev::points(degree).into_iter().rev().map(move |y| {
        if y == 1.0 {
            right
        } else if y == -1.0 {
            left
        } else {
            (middle + half * y).clamp(left, right)
        }
    })
}

fn fault(fault: String) -> Error {
    InverseError::Pressure { fault }.into()
}
