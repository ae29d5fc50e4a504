//! Seeded random problems, their guaranteed bounds, and their errors against sinc collocation.

use fredholm::basis::{ChebyshevSeries, Function};
use fredholm::bounds::{Combination, End, EndInfluence, Given, Kind, ResidualOperator, Responses};
use fredholm::kernel::{Logarithm, end_moments};
use fredholm::{SincOperator, SincSolution, StructuredSystem};
use shtaerman_random::Random;

/// Half the number of nodes of the reference.
const REFERENCE: usize = 100;

/// What the references of all problems share.
pub(crate) fn operator() -> SincOperator {
    SincOperator::new(&Logarithm::unit(), REFERENCE).unwrap()
}

/// A right-hand side `c_1 + c_2 x - f(x)` of which a pair is given.
#[derive(Debug)]
pub(crate) struct Problem {
    pub(crate) theta: f64,
    pub(crate) degree: usize,
    pub(crate) given: [Given; 2],
    /// `[kind, amplitude, ..]`
    profile: Vec<f64>,
}

impl Problem {
    /// `theta` log-uniform between 1e-3 and 1e4; `degree = max(64, resolution * theta)`.
    pub(crate) fn random(random: &mut Random, resolution: f64) -> Self {
        let theta = 10f64.powf(random.between(-3.0, 4.0));
        let size = 10f64.powf(random.between(-1.0, 1.0));
        let profile = match random.below(3) {
            0 => {
                let degree = random.below(9);
                let polynomial = (0..=degree).map(|_| size * random.between(-1.0, 1.0));
                std::iter::once(0.0).chain(polynomial).collect()
            }
            1 => vec![1.0, size, random.between(-4.0, 4.0)],
            _ => vec![2.0, size, random.between(0.1, 12.0), random.between(0.0, 6.3)],
        };
        let first = match random.below(2) {
            0 => Given::Coefficient(random.between(-2.0, 2.0)),
            _ => Given::Projection(random.between(-2.0, 2.0)),
        };
        let second = match random.below(3) {
            0 => Given::Coefficient(random.between(-2.0, 2.0)),
            1 => Given::Projection(random.between(-1.0, 1.0)),
            _ => Given::Quotient(random.between(-0.5, 0.5)),
        };
        let degree = (resolution * theta).ceil().max(64.0) as usize;
        Self { theta, degree, given: [first, second], profile }
    }

    pub(crate) fn profile(&self, x: f64) -> f64 {
        match (self.profile[0] as i32, &self.profile[1..]) {
            (0, polynomial) => polynomial.iter().rev().fold(0.0, |sum, c| sum * x + c),
            (1, &[size, rate]) => size * (rate * x).exp(),
            (_, &[size, frequency, phase]) => size * (frequency * x + phase).cos(),
            _ => unreachable!(),
        }
    }

    /// The responses of degenerate solutions of this degree.
    pub(crate) fn responses(&self, degree: usize) -> (Responses, EndInfluence) {
        let function = Function::resolve(&|x| self.profile(x)).unwrap();
        assert!(function.is_resolved());
        let kernel = Logarithm::unit();
        let system = StructuredSystem::new(&kernel, self.theta, degree).unwrap();
        let highest = degree.max(function.series().degree());
        let operator = ResidualOperator::new(&kernel, self.theta, highest).unwrap();
        let response = |right: &ChebyshevSeries| {
            let (solution, _) = system.solve(&right.moments(degree + 1), 1e-14).unwrap();
            operator.approximation(right, solution.correction(), Kind::Bound).unwrap()
        };
        let responses = Responses::new(
            response(&ChebyshevSeries::new(vec![1.0])),
            response(&ChebyshevSeries::new(vec![0.0, 1.0])),
            response(function.series()),
        );
        let (influence, _) = system.solve(&end_moments(degree + 1), 1e-14).unwrap();
        (responses.unwrap(), operator.end_influence(influence.correction()).unwrap())
    }
}

/// The answer by sinc collocation.
pub(crate) struct Reference {
    solutions: Vec<SincSolution>,
    pub(crate) coefficients: [f64; 2],
    pub(crate) projections: [f64; 2],
    /// Sizes of what is added up in coefficients, projections and the solution: their rounding errors go with them.
    pub(crate) sizes: ([f64; 2], [f64; 2], f64),
    /// Rounding of a pressure: `p = g - theta K p` is a small difference of terms of the size `G` of `g`, uncertain by `theta G` units of
    /// rounding. Integrals come from the scaled solution and have no such loss.
    pub(crate) rounding: f64,
}

impl Reference {
    pub(crate) fn new(operator: &SincOperator, problem: &Problem) -> Self {
        let positions: Vec<f64> = operator.positions().collect();
        let profile = positions.iter().map(|&x| problem.profile(x)).collect();
        let right = [vec![1.0; positions.len()], positions, profile];
        let solutions = operator.solve(problem.theta, &right).unwrap();
        let basis = [|_: f64| 1.0, |x: f64| x];
        let energy = [0, 1].map(|i| solutions[i].integral(basis[i]));
        let free = [0, 1].map(|i| solutions[2].integral(basis[i]));
        let mut found = Self {
            solutions,
            coefficients: [0.0; 2],
            projections: [0.0; 2],
            sizes: ([0.0; 2], [0.0; 2], 0.0),
            rounding: 0.0,
        };
        for i in 0..2 {
            let projection = match problem.given[i] {
                Given::Coefficient(c) => c * energy[i] - free[i],
                Given::Projection(value) => value,
                Given::Proportion(factor) => -free[i] / (1.0 - factor * energy[i]),
                Given::Quotient(e) => e * found.projections[0],
            };
            let c = match problem.given[i] {
                Given::Coefficient(c) => c,
                _ => (projection + free[i]) / energy[i],
            };
            found.coefficients[i] = c;
            found.projections[i] = projection;
            found.sizes.0[i] = c.abs().max(free[i].abs() / energy[i]);
            found.sizes.1[i] = projection.abs().max(free[i].abs()).max((c * energy[i]).abs());
        }
        let peak = |i: usize| {
            [-1.0, -0.5, 0.0, 0.5, 1.0]
                .map(|x| found.solutions[i].evaluate(x, [1.0, x, problem.profile(x)][i]).abs())
                .into_iter()
                .fold(0.0, f64::max)
        };
        let [c1, c2] = found.coefficients;
        let largest = (0..=64).map(|i| problem.profile(f64::from(i) / 32.0 - 1.0).abs());
        let given = c1.abs() + c2.abs() + largest.fold(0.0, f64::max);
        let unit = 4.0 * f64::EPSILON * given;
        found.rounding = unit * (1.0 + problem.theta);
        found.sizes.2 = c1.abs() * peak(0) + c2.abs() * peak(1) + peak(2);
        found
    }

    /// `p(x)`.
    pub(crate) fn value(&self, problem: &Problem, x: f64) -> f64 {
        let [one, linear, free] = &self.solutions[..] else { unreachable!() };
        self.coefficients[0] * one.evaluate(x, 1.0) + self.coefficients[1] * linear.evaluate(x, x)
            - free.evaluate(x, problem.profile(x))
    }
}

/// One quantity of one problem: error and bound, relative to its size.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Observation {
    pub(crate) quantity: &'static str,
    pub(crate) theta: f64,
    pub(crate) error: f64,
    pub(crate) bound: f64,
    /// Rounding of the reference.
    pub(crate) noise: f64,
}

impl Observation {
    /// Whether the error exceeds the bound by more than the reference's rounding: `1e-11` and what its own cancellation makes of it.
    pub(crate) fn is_broken(&self) -> bool {
        let room = self.bound + SLACK + self.noise - self.error;
        room.is_nan() || room < 0.0
    }

    /// Whether the error is that of the approximation rather than of the reference.
    pub(crate) fn counts(&self) -> bool {
        self.error > SLACK + self.noise
    }
}

/// Rounding allowed to the references, relative to the size of what is added up.
pub(crate) const SLACK: f64 = 1e-11;

/// Points where pressures are compared: the ends, the middle, within the layers at the ends, and at random.
pub(crate) fn points(random: &mut Random, degree: usize) -> Vec<f64> {
    let mut points = vec![-1.0, 0.0, 1.0];
    for _ in 0..10 {
        let angle = random.between(0.0, 6.0) / degree as f64;
        points.extend([angle.cos(), -angle.cos()]);
    }
    points.extend((0..20).map(|_| random.between(-1.0, 1.0)));
    points
}

/// Everything that is bounded for the combination, against the reference.
pub(crate) fn observe(
    problem: &Problem,
    combination: &Combination<'_>,
    influence: &EndInfluence,
    reference: &Reference,
    points: &[f64],
) -> Vec<Observation> {
    let mut found = Vec::new();
    let (sizes, rounding) = (&reference.sizes, reference.rounding);
    let approximation = combination.approximation();
    let mut add = |quantity, size: f64, rounding: f64, error: f64, bound: f64| {
        let (theta, noise) = (problem.theta, rounding / size);
        let (error, bound) = (error.abs() / size, bound / size);
        found.push(Observation { quantity, theta, error, bound, noise });
    };
    let mut worst = [0.0f64; 2];
    for &x in points {
        let (truth, g) = (reference.value(problem, x), approximation.right_hand_side().evaluate(x));
        let plain = approximation.evaluate(x) - truth;
        let iterated = approximation.iterated().evaluate(x, g) - truth;
        add("pressure at a point", sizes.2, rounding, plain, combination.error_at(x));
        worst = [worst[0].max(plain.abs()), worst[1].max(iterated.abs())];
    }
    add("pressure", sizes.2, rounding, worst[0], combination.error_supremum());
    add("iterated pressure", sizes.2, rounding, worst[1], combination.iterated_error());
    for end in [End::Left, End::Right] {
        let found = combination.end_value(influence, end);
        let error = found.value - reference.value(problem, end.position());
        add("end pressure, corrected", sizes.2, rounding, error, found.radius);
    }
    for i in 0..2 {
        if !matches!(problem.given[i], Given::Coefficient(_)) {
            let truth = reference.coefficients[i];
            let (best, plain) = (combination.coefficients()[i], combination.used_coefficients()[i]);
            add("coefficient", sizes.0[i], 0.0, best.value - truth, best.radius);
            let bound = best.error_of(plain);
            add("coefficient, plain", sizes.0[i], 0.0, plain - truth, bound);
        }
        if !matches!(problem.given[i], Given::Projection(_)) {
            let truth = reference.projections[i];
            let (best, plain) = (combination.projections()[i], approximation.moments()[i]);
            add("projection", sizes.1[i], 0.0, best.value - truth, best.radius);
            let bound = best.error_of(plain);
            add("projection, plain", sizes.1[i], 0.0, plain - truth, bound);
        }
    }
    found
}
