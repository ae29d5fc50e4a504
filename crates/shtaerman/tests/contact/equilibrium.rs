//! Pressure against (2.4) and (2.3), by a quadrature of its own.

use crate::contact::support::{assert_near, force_and_moment, integral, order, potential, solve};
use shtaerman::Contact;

#[test]
fn the_pressure_balances_force_and_moment() {
    // The projections of the degenerate solution are exact for any n, so this holds to rounding even for n = 1.
    for theta0 in [0.0, 0.3, 13.0, 150.0] {
        for degree in [1, 2, 7, 64, 150] {
            for profile in ["0", "xi^4 - xi/2", "exp(xi) - 3*xi^2", "1/(1 + 4*xi^2)"] {
                let contact = solve(theta0, profile, force_and_moment(1.7, -0.31), degree);
                let what = format!("theta0 = {theta0}, n = {degree}, f0 = {profile}");
                assert_near(
                    integral(|xi| contact.dimensionless().pressure(xi).unwrap()),
                    1.7,
                    1e-12,
                    &what,
                );
                assert_near(
                    integral(|xi| xi * contact.dimensionless().pressure(xi).unwrap()),
                    -0.31,
                    1e-12,
                    &what,
                );
            }
        }
    }
}

/// `|p + theta0 int ln(1/|xi - eta|) p - (delta0 - alpha0 xi - f0)|`.
fn residual(contact: &Contact, xi: f64) -> f64 {
    let right = contact.dimensionless().settlement()
        - contact.dimensionless().tilt() * xi
        - contact.problem().dimensionless_profile(xi);
    (contact.dimensionless().pressure(xi).unwrap() + contact.theta0() * potential(contact, xi)
        - right)
        .abs()
}

#[test]
fn the_residual_of_the_equation_falls_as_the_theory_says() {
    // The kernel's terms beyond n act on a pressure whose coefficients there fall as m^-3/m: order 2 at the edges, 3 inside.
    let profile = "xi^4 - xi/2 + 2*xi^2";
    let residuals = [16, 32, 64, 128].map(|degree| {
        let contact = solve(4.0, profile, force_and_moment(1.7, -0.31), degree);
        let edges = residual(&contact, -1.0).max(residual(&contact, 1.0));
        let inside = (0..40)
            .map(|i| residual(&contact, -0.8 + 1.6 * (f64::from(i) + 0.37) / 40.0))
            .fold(0.0, f64::max);
        [edges, inside]
    });
    for pair in residuals.windows(2) {
        assert!((order(pair[0][0], pair[1][0]) - 2.0).abs() < 0.3, "edges: {residuals:?}");
        assert!((order(pair[0][1], pair[1][1]) - 3.0).abs() < 0.6, "inside: {residuals:?}");
    }
    assert!(residuals[3][0] < 1e-3 && residuals[3][1] < 2e-5, "{residuals:?}");
}

#[test]
fn the_work_of_the_layer_is_the_derivative_of_the_compliance() {
    // With s = 1/theta0 and f = 0: P0 d(s delta0)/ds - M0 d(s alpha0)/ds = int p0^2, from (s + K) p0 = s (delta0 - alpha0 xi).
    let (force, moment) = (1.0, 0.4);
    let at = |s: f64| solve(1.0 / s, "0", force_and_moment(force, moment), 400);
    for s in [2.0, 0.2, 0.02] {
        let work = |s: f64| {
            let contact = at(s);
            s * (force * contact.dimensionless().settlement()
                - moment * contact.dimensionless().tilt())
        };
        let step = 1e-2 * s;
        // Fourth-order central difference.
        let derivative = (8.0 * (work(s + step) - work(s - step))
            - (work(s + 2.0 * step) - work(s - 2.0 * step)))
            / (12.0 * step);
        let contact = at(s);
        let exact = integral(|xi| contact.dimensionless().pressure(xi).unwrap().powi(2));
        assert_near(derivative / exact, 1.0, 1e-6, &format!("1/theta0 = {s}"));
    }
}

#[test]
fn two_loadings_are_reciprocal() {
    // <delta_1 - alpha_1 xi - f_1, p_2> = <delta_2 - alpha_2 xi - f_2, p_1>, because the kernel is symmetric.
    for theta0 in [0.0, 2.0, 50.0] {
        let one = solve(theta0, "xi^4 - xi/2", force_and_moment(1.7, -0.31), 120);
        let two = solve(theta0, "sin(5*xi) + abs(xi)^3", force_and_moment(-0.4, 0.9), 120);
        let work = |base: &Contact, pressing: &Contact| {
            base.dimensionless().settlement() * pressing.dimensionless().force()
                - base.dimensionless().tilt() * pressing.dimensionless().moment()
                - integral(|xi| {
                    base.problem().dimensionless_profile(xi)
                        * pressing.dimensionless().pressure(xi).unwrap()
                })
        };
        let (first, second) = (work(&one, &two), work(&two, &one));
        let scale = theta0.max(1.0);
        assert_near(first, second, 2e-12 * scale, &format!("theta0 = {theta0}"));
    }
}

#[test]
fn sinc_collocation_gives_the_same_pressure() {
    use fredholm::{SincOperator, kernel::Logarithm};
    let operator = SincOperator::new(&Logarithm::unit(), 60).unwrap();
    let base = |xi: f64| (1.5 * xi).exp() - xi.powi(3);
    for theta0 in [0.5, 8.0] {
        let sample = |f: &dyn Fn(f64) -> f64| operator.positions().map(f).collect();
        let sides = [sample(&|_| 1.0), sample(&|xi| xi), sample(&base)];
        let responses = operator.solve(theta0, &sides).unwrap();
        let [one, xi, f] = &responses[..] else { unreachable!() };
        let settlement = (1.7 + f.integral(|_| 1.0)) / one.integral(|_| 1.0);
        let tilt = (0.31 - f.integral(|x| x)) / xi.integral(|x| x);
        let contact = solve(theta0, "exp(1.5*xi) - xi^3", force_and_moment(1.7, -0.31), 400);
        // n^-4, n^-3 and n^-2, with a factor that grows with theta0.
        assert_near(contact.dimensionless().settlement(), settlement, 1e-8, "settlement");
        assert_near(contact.dimensionless().tilt(), tilt, 1e-8, "tilt");
        for (place, tolerance) in
            [(-1.0, 1e-3), (-0.4, 1e-6), (0.0, 1e-6), (0.77, 1e-6), (1.0, 1e-3)]
        {
            let exact = settlement * one.evaluate(place, 1.0)
                - tilt * xi.evaluate(place, place)
                - f.evaluate(place, base(place));
            assert_near(
                contact.dimensionless().pressure(place).unwrap(),
                exact,
                tolerance,
                &format!("theta0 = {theta0}, xi = {place}"),
            );
        }
    }
}
