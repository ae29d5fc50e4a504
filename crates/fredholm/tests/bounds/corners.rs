//! Perturbed approximations, labels, special cases and refusals.

use fredholm::basis::ChebyshevSeries;
use fredholm::bounds::{Approximation, Given, Kind, ResidualOperator, Responses};
use fredholm::kernel::Logarithm;
use fredholm::{DegenerateSystem, Error, StructuredOperator};

fn power(m: usize) -> ChebyshevSeries {
    let mut coefficients = vec![0.0; m + 1];
    coefficients[m] = 1.0;
    ChebyshevSeries::new(coefficients)
}

/// Approximations for `1`, `x`, `T_4`, the coefficients of each changed by `disturb`.
fn responses(theta: f64, degree: usize, disturb: &dyn Fn(&mut Vec<f64>)) -> Responses {
    let kernel = Logarithm::unit();
    let system = DegenerateSystem::new(&kernel, theta, degree).unwrap();
    let operator = ResidualOperator::new(&kernel, theta, degree).unwrap();
    let [constant, linear, free] = [0, 1, 4].map(|m| -> Approximation {
        let mut correction = system.solve(&power(m).moments(degree + 1)).correction().to_vec();
        disturb(&mut correction);
        operator.approximation(&power(m), &correction, Kind::Bound).unwrap()
    });
    Responses::new(constant, linear, free).unwrap()
}

#[test]
fn a_disturbed_approximation_has_a_bound_that_covers_the_disturbance() {
    let theta = 30.0;
    let given = [Given::Coefficient(1.0), Given::Coefficient(0.5)];
    let fine = responses(theta, 800, &|_| {});
    let fine = fine.combine(given);
    for mode in [0usize, 3, 40, 79] {
        for size in [1e-6, 1e-3, 1.0] {
            let coarse = responses(theta, 80, &|correction| correction[mode] += size);
            let coarse = coarse.combine(given);
            // Coefficients 1, 0.5 and -1: the combination moves by half of the disturbance.
            let approximation = coarse.approximation();
            let mut worst = 0.0f64;
            for i in 0..=2000 {
                let x = (std::f64::consts::PI * f64::from(i) / 2000.0).cos();
                let error = (approximation.evaluate(x) - fine.approximation().evaluate(x)).abs();
                assert!(error <= coarse.error_at(x) + fine.error_at(x));
                worst = worst.max(error);
            }
            assert!(worst > 0.4 * size);
            assert!(coarse.error_supremum() + fine.error_supremum() >= worst);
            assert!(coarse.error_norm() >= 0.1 * size / (1.0 + mode as f64).sqrt());
            for (rough, sharp) in coarse.projections().into_iter().zip(fine.projections()) {
                assert!((rough.value - sharp.value).abs() <= rough.radius + sharp.radius);
            }
        }
    }
}

#[test]
fn far_off_approximations_have_wide_or_infinite_bounds_and_no_nan() {
    let coarse = responses(5.0, 64, &|correction| correction.iter_mut().for_each(|c| *c = 1.0));
    let combination = coarse.combine([Given::Projection(1.0), Given::Quotient(0.2)]);
    for enclosure in combination.coefficients().into_iter().chain(combination.projections()) {
        assert!(enclosure.radius >= 0.0);
    }
    assert!(combination.error_supremum() > 1.0);
}

#[test]
fn without_a_kernel_everything_is_exact() {
    let found = responses(0.0, 64, &|_| {});
    let found = found.combine([Given::Projection(3.0), Given::Projection(1.0)]);
    assert!(found.error_supremum() < 1e-13 && found.error_norm() < 1e-13);
    // int c_1 - T_4 = 2 c_1 + 2/15, int x (c_2 x - T_4) = 2 c_2 / 3
    let [first, second] = found.coefficients();
    assert!(first.error_of(1.5 - 1.0 / 15.0) < 1e-13 && second.error_of(1.5) < 1e-13);
}

#[test]
fn given_projections_let_the_norm_of_the_error_be_projected() {
    // n far below theta: the coefficients are off, the projections are not.
    let theta = 500.0;
    let fine = responses(theta, 2000, &|_| {});
    let coarse = responses(theta, 48, &|_| {});
    let given = [Given::Projection(0.3), Given::Projection(0.1)];
    let (fine, coarse) = (fine.combine(given), coarse.combine(given));
    let mut difference = fine.approximation().density().coefficients().to_vec();
    for (d, c) in difference.iter_mut().zip(coarse.approximation().density().coefficients()) {
        *d -= c;
    }
    let moments = ChebyshevSeries::new(difference.clone()).moments(difference.len());
    let norm = difference.iter().zip(moments).map(|(d, m)| d * m).sum::<f64>().sqrt();
    assert!(norm <= coarse.error_norm() + fine.error_norm());
    assert!(coarse.error_norm() <= coarse.approximation().error_norm());
}

#[test]
fn an_unresolved_right_hand_side_makes_an_estimate() {
    let kernel = Logarithm::unit();
    let operator = ResidualOperator::new(&kernel, 1.0, 8).unwrap();
    let make = |m: usize, kind| operator.approximation(&power(m), &[0.0], kind).unwrap();
    let free = make(2, Kind::Estimate);
    let responses = Responses::new(make(0, Kind::Bound), make(1, Kind::Bound), free).unwrap();
    let given = [Given::Coefficient(1.0), Given::Coefficient(0.0)];
    assert_eq!(responses.combine(given).kind(), Kind::Estimate);
    assert_eq!(responses.bases()[0].kind(), Kind::Bound);
}

#[test]
fn refusals_say_what_is_wrong() {
    let (kernel, long) = (Logarithm::unit(), Logarithm::new(0.5).unwrap());
    for parameter in [f64::NAN, f64::INFINITY, -1.0] {
        assert!(ResidualOperator::new(&kernel, parameter, 8).is_err());
    }
    assert!(ResidualOperator::new(&long, 1.0, 8).is_err());
    assert!(matches!(ResidualOperator::new(&kernel, 1.0, usize::MAX), Err(Error::TooLarge { .. })));
    let short = StructuredOperator::new(&kernel, 20).unwrap();
    assert!(ResidualOperator::with_products(short, 1.0).is_err());

    let operator = ResidualOperator::new(&kernel, 1.0, 20).unwrap();
    let approximate = |g: &ChebyshevSeries, s: &[f64]| operator.approximation(g, s, Kind::Bound);
    assert!(approximate(&power(30), &[]).is_err());
    assert!(approximate(&power(0), &[0.0; 30]).is_err());
    assert!(approximate(&power(0), &[f64::NAN]).is_err());
    assert!(approximate(&ChebyshevSeries::default(), &[]).is_ok());

    let [one, x] = [0, 1].map(|m| approximate(&power(m), &[]).unwrap());
    assert!(Responses::new(x.clone(), x.clone(), one.clone()).is_err());
    assert!(Responses::new(one.clone(), one.clone(), one.clone()).is_err());
    let other = ResidualOperator::new(&kernel, 2.0, 20).unwrap();
    let other = other.approximation(&power(3), &[], Kind::Bound).unwrap();
    assert!(Responses::new(one.clone(), x.clone(), other).is_err());
    assert!(Responses::new(one.clone(), x, one).is_ok());
}
