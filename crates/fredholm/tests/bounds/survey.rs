//! Seeded random problems, their guaranteed bounds, and their errors against sinc collocation.

use fredholm::basis::{ChebyshevSeries, Function};
use fredholm::bounds::{Approximation, Combination, Given, Kind, ResidualOperator, Responses};
use fredholm::kernel::Logarithm;
use fredholm::{SincOperator, SincSolution, StructuredSystem};

/// Half the number of nodes of the reference: 1e-12 at `theta = 1e4`.
pub const REFERENCE: usize = 100;

/// A generator of reproducible numbers (G. L. Steele et al., SplitMix, 2014).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform between `low` and `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }
}

/// A right-hand side `c_1 + c_2 x - f(x)` of which a pair is given.
#[derive(Debug)]
pub struct Problem {
    pub theta: f64,
    pub degree: usize,
    pub given: [Given; 2],
    /// `[kind, amplitude, ..]`
    profile: Vec<f64>,
}

impl Problem {
    /// `theta` log-uniform between 1e-3 and 1e4; `degree = max(64, resolution * theta)`.
    pub fn random(random: &mut Random, resolution: f64) -> Self {
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

    pub fn profile(&self, x: f64) -> f64 {
        match (self.profile[0] as i32, &self.profile[1..]) {
            (0, polynomial) => polynomial.iter().rev().fold(0.0, |sum, c| sum * x + c),
            (1, &[size, rate]) => size * (rate * x).exp(),
            (_, &[size, frequency, phase]) => size * (frequency * x + phase).cos(),
            _ => unreachable!(),
        }
    }

    fn approximation(&self, degree: usize, right: &ChebyshevSeries) -> Approximation {
        let kernel = Logarithm::unit();
        let system = StructuredSystem::new(&kernel, self.theta, degree).unwrap();
        let (solution, _) = system.solve(&right.moments(degree + 1), 1e-14).unwrap();
        let degree = degree.max(right.degree());
        let operator = ResidualOperator::new(&kernel, self.theta, degree).unwrap();
        operator.approximation(right, solution.correction(), Kind::Bound).unwrap()
    }

    /// The responses of degenerate solutions of this degree.
    pub fn responses(&self, degree: usize) -> Responses {
        let function = Function::resolve(&|x| self.profile(x)).unwrap();
        assert!(function.is_resolved());
        Responses::new(
            self.approximation(degree, &ChebyshevSeries::new(vec![1.0])),
            self.approximation(degree, &ChebyshevSeries::new(vec![0.0, 1.0])),
            self.approximation(degree, function.series()),
        )
        .unwrap()
    }
}

/// The answer by sinc collocation.
pub struct Reference<'o> {
    solutions: Vec<SincSolution<'o>>,
    pub coefficients: [f64; 2],
    pub projections: [f64; 2],
    /// Sizes of what is added up in coefficients, projections and the solution: their rounding errors go with them.
    pub sizes: ([f64; 2], [f64; 2], f64),
}

impl<'o> Reference<'o> {
    pub fn new(operator: &'o SincOperator, problem: &Problem) -> Self {
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
        };
        for i in 0..2 {
            let projection = match problem.given[i] {
                Given::Coefficient(c) => c * energy[i] - free[i],
                Given::Projection(value) => value,
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
        found.sizes.2 = c1.abs() * peak(0) + c2.abs() * peak(1) + peak(2);
        found
    }

    /// `p(x)`.
    pub fn value(&self, problem: &Problem, x: f64) -> f64 {
        let [one, linear, free] = &self.solutions[..] else { unreachable!() };
        self.coefficients[0] * one.evaluate(x, 1.0) + self.coefficients[1] * linear.evaluate(x, x)
            - free.evaluate(x, problem.profile(x))
    }
}

/// One quantity of one problem: error and bound, relative to its size.
#[derive(Debug, Clone, Copy)]
pub struct Observation {
    pub quantity: &'static str,
    pub theta: f64,
    pub error: f64,
    pub bound: f64,
}

/// Points where pressures are compared: the ends, the middle, within the layers at the ends, and at random.
pub fn points(random: &mut Random, degree: usize) -> Vec<f64> {
    let mut points = vec![-1.0, 0.0, 1.0];
    for _ in 0..10 {
        let angle = random.between(0.0, 6.0) / degree as f64;
        points.extend([angle.cos(), -angle.cos()]);
    }
    points.extend((0..20).map(|_| random.between(-1.0, 1.0)));
    points
}

/// Everything that is bounded for the combination, against the reference.
pub fn observe(
    problem: &Problem,
    combination: &Combination<'_>,
    reference: &Reference<'_>,
    points: &[f64],
) -> Vec<Observation> {
    let mut found = Vec::new();
    let mut add = |quantity, size: f64, error: f64, bound: f64| {
        let theta = problem.theta;
        found.push(Observation { quantity, theta, error: error / size, bound: bound / size });
    };
    let size = reference.sizes.2;
    let (mut plain, mut iterated) = (0.0f64, 0.0f64);
    let approximation = combination.approximation();
    for &x in points {
        let exact = reference.value(problem, x);
        let error = (approximation.evaluate(x) - exact).abs();
        add("pressure at a point", size, error, combination.error_at(x));
        plain = plain.max(error);
        let right = approximation.right_hand_side().evaluate(x);
        iterated = iterated.max((approximation.iterated().evaluate(x, right) - exact).abs());
    }
    add("pressure", size, plain, combination.error_supremum());
    add("iterated pressure", size, iterated, combination.iterated_error());
    for i in 0..2 {
        if !matches!(problem.given[i], Given::Coefficient(_)) {
            let enclosure = combination.coefficients()[i];
            let error = (enclosure.value - reference.coefficients[i]).abs();
            add("coefficient", reference.sizes.0[i], error, enclosure.radius);
            let used = combination.used_coefficients()[i];
            let error = (used - reference.coefficients[i]).abs();
            add("coefficient, plain", reference.sizes.0[i], error, enclosure.error_of(used));
        }
        if !matches!(problem.given[i], Given::Projection(_)) {
            let enclosure = combination.projections()[i];
            let error = (enclosure.value - reference.projections[i]).abs();
            add("projection", reference.sizes.1[i], error, enclosure.radius);
            let plain = approximation.moments()[i];
            let error = (plain - reference.projections[i]).abs();
            add("projection, plain", reference.sizes.1[i], error, enclosure.error_of(plain));
        }
    }
    found
}
