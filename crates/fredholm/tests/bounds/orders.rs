//! How fast plain and iterated solutions and corrected functionals converge.

use fredholm::basis::ChebyshevSeries;
use fredholm::bounds::{
    Approximation, End, EndInfluence, IteratedSolution, Kind, ResidualOperator,
};
use fredholm::kernel::{Logarithm, end_moments};
use fredholm::quadrature::double_exponential;
use fredholm::{DegenerateSystem, SincOperator, SincSolution, StructuredSystem};

/// `g = 1 + x - x^3/4`
fn right() -> ChebyshevSeries {
    ChebyshevSeries::new(vec![1.0, 1.0 - 0.1875, 0.0, -0.0625])
}

fn reference(operator: &SincOperator, theta: f64) -> SincSolution {
    let g = operator.positions().map(|x| right().evaluate(x)).collect();
    operator.solve(theta, &[g]).unwrap().remove(0)
}

fn approximation(theta: f64, degree: usize, g: &ChebyshevSeries) -> Approximation {
    let kernel = Logarithm::unit();
    let system = DegenerateSystem::new(&kernel, theta, degree).unwrap();
    let solution = system.solve(&g.moments(degree + 1));
    let operator = ResidualOperator::new(&kernel, theta, degree).unwrap();
    operator.approximation(g, solution.correction(), Kind::Bound).unwrap()
}

#[test]
fn iterated_ends_converge_with_the_fourth_order() {
    let operator = SincOperator::new(&Logarithm::unit(), 100).unwrap();
    for theta in [1.0, 10.0, 60.0] {
        let exact = reference(&operator, theta);
        for end in [-1.0, 1.0] {
            let g = right().evaluate(end);
            let errors = [256usize, 512].map(|degree| {
                let found = approximation(theta, degree, &right());
                let truth = exact.evaluate(end, g);
                [found.evaluate(end) - truth, found.iterated().evaluate(end, g) - truth]
            });
            let order = |i: usize| (errors[0][i] / errors[1][i]).abs().log2();
            // n^-4 ln n falls by 16 ln 256 / ln 512 = 14.2 = 2^3.83
            assert!((order(0) - 2.0).abs() < 0.15, "plain, {theta}: {}", order(0));
            assert!((order(1) - 3.85).abs() < 0.3, "iterated, {theta}: {}", order(1));
            assert!(errors[1][1].abs() < 0.02 * errors[1][0].abs());
        }
    }
}

#[test]
fn iteration_is_worse_inside_below_twice_theta() {
    // Which is why the choice is left to bounds that see it.
    let operator = SincOperator::new(&Logarithm::unit(), 100).unwrap();
    let (theta, x) = (100.0, 0.3);
    let truth = reference(&operator, theta).evaluate(x, right().evaluate(x));
    let error = |degree: usize| {
        let found = approximation(theta, degree, &right());
        let iterated = found.iterated().evaluate(x, right().evaluate(x));
        [found.evaluate(x) - truth, iterated - truth].map(f64::abs)
    };
    let (below, above) = (error(40), error(1000));
    assert!(below[1] > 2.0 * below[0], "{below:?}");
    assert!(above[1] < 0.5 * above[0], "{above:?}");
}

#[test]
fn the_iterated_solution_is_one_step_of_the_equation() {
    // q + r, whether from the modes or in closed form.
    let found = approximation(7.0, 50, &right());
    let again = IteratedSolution::new(7.0, &right(), &[]);
    let free = LogarithmicByMoments(right());
    for x in [-1.0, -0.2, 0.6, 1.0] {
        let g = right().evaluate(x);
        let iterated = found.iterated().evaluate(x, g);
        assert!((iterated - found.evaluate(x) - found.residual(x)).abs() < 1e-14);
        assert!((again.evaluate(x, g) - (g - 7.0 * free.value(x))).abs() < 1e-7);
    }
}

/// The potential by its expansion (1.5).
struct LogarithmicByMoments(ChebyshevSeries);

impl LogarithmicByMoments {
    fn value(&self, x: f64) -> f64 {
        let mut terms = self.0.moments(1 << 15);
        for (m, term) in terms.iter_mut().enumerate() {
            *term *= if m == 0 { 2f64.ln() } else { 2.0 / m as f64 };
        }
        ChebyshevSeries::new(terms).evaluate(x)
    }
}

#[test]
fn corrected_functionals_converge_with_the_sixth_order() {
    let operator = SincOperator::new(&Logarithm::unit(), 100).unwrap();
    let one = ChebyshevSeries::new(vec![1.0]);
    for (theta, degrees) in [(5.0, [32usize, 64]), (60.0, [128, 256])] {
        let truth = reference(&operator, theta).integral(|_| 1.0);
        let errors = degrees.map(|degree| {
            let (u, v) =
                (approximation(theta, degree, &one), approximation(theta, degree, &right()));
            let found = u.functional(&v);
            let reversed = v.functional(&u);
            assert!((found.value - reversed.value).abs() < 1e-14);
            let error = (found.value - truth).abs();
            assert!(error <= found.radius + 1e-13, "{error:e} {:e}", found.radius);
            [error, (v.moments()[0] - truth).abs()]
        });
        let order = |i: usize| (errors[0][i] / errors[1][i]).log2();
        assert!(order(0) > 5.0, "corrected: {} {errors:?}", order(0));
        assert!((order(1) - 4.0).abs() < 0.5, "plain: {}", order(1));
    }
}

#[test]
fn the_norm_of_the_error_is_bounded_sharply() {
    let operator = SincOperator::new(&Logarithm::unit(), 100).unwrap();
    for (theta, degree) in [(0.01, 64usize), (1.0, 64), (20.0, 80), (300.0, 100)] {
        let exact = reference(&operator, theta);
        let found = approximation(theta, degree, &right());
        let square: f64 = double_exponential(1500)
            .map(|node| {
                let x = node.position;
                let error = found.evaluate(x) - exact.evaluate(x, right().evaluate(x));
                node.weight * error * error
            })
            .sum();
        let (norm, bound) = (square.sqrt(), found.error_norm());
        println!("theta {theta}, n {degree}: {norm:e} {bound:e}");
        assert!(norm <= bound && bound <= 6.0 * norm, "{theta}: {norm:e} {bound:e}");
    }
}

fn with_influence(theta: f64, degree: usize) -> (Approximation, EndInfluence) {
    let (kernel, g) = (Logarithm::unit(), right());
    let system = StructuredSystem::new(&kernel, theta, degree).unwrap();
    let operator = ResidualOperator::new(&kernel, theta, degree).unwrap();
    let (solution, _) = system.solve(&g.moments(degree + 1), 1e-14).unwrap();
    let (influence, _) = system.solve(&end_moments(degree + 1), 1e-14).unwrap();
    let found = operator.approximation(&g, solution.correction(), Kind::Bound).unwrap();
    (found, operator.end_influence(influence.correction()).unwrap())
}

#[test]
fn corrected_ends_converge_faster_than_the_fifth_order() {
    let operator = SincOperator::new(&Logarithm::unit(), 100).unwrap();
    for (theta, degrees) in [(1.0, [32usize, 64]), (10.0, [64, 128]), (60.0, [256, 512])] {
        let exact = reference(&operator, theta);
        for end in [End::Left, End::Right] {
            let truth = exact.evaluate(end.position(), right().evaluate(end.position()));
            let [coarse, fine] = degrees.map(|degree| {
                let (found, influence) = with_influence(theta, degree);
                let value = influence.value(&found, end);
                let error = (value.value - truth).abs();
                assert!(error <= value.radius + 2e-12, "{theta} {degree}: {error:e} {value:?}");
                [error, value.radius]
            });
            let order = (coarse[1] / fine[1]).log2();
            assert!(order > 5.0, "{theta}: {order} {coarse:?} {fine:?}");
            assert!(coarse[1] < 60.0 * coarse[0], "{theta}: {coarse:?}");
        }
    }
}

#[test]
fn corrected_ends_of_two_degrees_agree_at_a_large_parameter() {
    // Where the reference has no more than 1e-10.
    let theta = 8000.0;
    let [coarse, fine] = [24_000usize, 40_000].map(|degree| with_influence(theta, degree));
    for end in [End::Left, End::Right] {
        let (coarse, fine) = (coarse.1.value(&coarse.0, end), fine.1.value(&fine.0, end));
        let difference = (coarse.value - fine.value).abs();
        println!(
            "{end:?}: {difference:e} of {}, radii {:e} {:e}",
            fine.value, coarse.radius, fine.radius
        );
        assert!(difference <= coarse.radius + fine.radius + 1e-11 * fine.value.abs());
    }
}
