//! The logarithm on an interval longer than 4, by the rank-one step: bounds hold, and are refused where the step is singular.

use fredholm::basis::ChebyshevSeries;
use fredholm::bounds::{Given, Kind, ResidualOperator, Responses};
use fredholm::kernel::Logarithm;
use fredholm::{DegenerateSolver, SincOperator};

const DEGREE: usize = 200;

fn responses(theta: f64, right: &ChebyshevSeries) -> Responses {
    let kernel = Logarithm::unit();
    let solver = DegenerateSolver::new(&kernel, theta, DEGREE).unwrap();
    let operator = ResidualOperator::new(&kernel, theta, DEGREE).unwrap();
    let approximate = |series: &ChebyshevSeries| {
        let solution = solver.solve(&series.moments(DEGREE + 1)).unwrap();
        operator.approximation(series, solution.correction(), Kind::Bound).unwrap()
    };
    let one = ChebyshevSeries::new(vec![1.0]);
    let linear = ChebyshevSeries::new(vec![0.0, 1.0]);
    Responses::new(approximate(&one), approximate(&linear), approximate(right)).unwrap()
}

#[test]
fn bounds_hold_on_long_intervals() {
    // g = 1 + x/a + (x/a)^2 on (-a, a), f = -g.
    let right = ChebyshevSeries::new(vec![-1.5, -1.0, -0.5]);
    for (a, lambda) in [(2.5, 0.02), (2.5, 0.4), (3.0, 4.0), (20.0, 0.5), (1000.0, 0.01)] {
        let theta = lambda * a;
        let responses = responses(theta, &right);
        let found =
            responses.combine([Given::Proportion(theta * f64::ln(a)), Given::Coefficient(0.0)]);
        let operator = SincOperator::new(&Logarithm::new(a).unwrap(), 90).unwrap();
        let g = |x: f64| 1.0 + x / a + (x / a).powi(2);
        let exact = &operator.solve(lambda, &[operator.sample(g).unwrap()]).unwrap()[0];
        let integral = exact.integral(|_| 1.0) / a;
        let enclosure = found.projections()[0];
        let rounding = 1e-11 * integral.abs();
        assert!(
            (enclosure.value - integral).abs() <= enclosure.radius + rounding,
            "a = {a}: {enclosure:?} {integral}"
        );
        assert!(enclosure.radius < 1e-6 * integral.abs(), "a = {a}: {enclosure:?}");
        let largest = exact.values().iter().fold(0.0f64, |most, value| most.max(value.abs()));
        for xi in [-1.0, -0.7, 0.0, 0.4, 1.0] {
            let error =
                (found.approximation().evaluate(xi) - exact.evaluate(a * xi, g(a * xi))).abs();
            assert!(
                error <= found.error_supremum() + 1e-11 * largest,
                "a = {a}, xi = {xi}: {error}"
            );
        }
    }
}

#[test]
fn no_bound_is_given_where_the_step_is_singular() {
    let responses = responses(1.0, &ChebyshevSeries::new(vec![-1.0]));
    let energy = responses.energies()[0].value;
    let found = responses.combine([Given::Proportion(1.0 / energy), Given::Coefficient(0.0)]);
    assert!(found.projections()[0].radius.is_infinite());
}
