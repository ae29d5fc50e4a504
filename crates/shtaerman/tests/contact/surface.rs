//! The surface of the body under and beside the punch.

use crate::contact::support::{assert_near, force_and_moment, integrate, order, solve};
use shtaerman::{Contact, Elastic, Foundation, Problem, Punch, Solver};

#[test]
fn the_body_follows_the_base_less_the_layer() {
    let contact = solve(4.0, "xi^2 - xi/3", force_and_moment(1.7, -0.31), 100);
    for xi in [-1.0, -0.4, 0.0, 0.9, 1.0] {
        let base = contact.dimensionless().settlement()
            - contact.dimensionless().tilt() * xi
            - (xi * xi - xi / 3.0);
        assert_near(contact.base_depth(xi), base, 1e-14, "base");
        assert_near(
            contact.elastic_displacement(xi),
            base - contact.dimensionless().pressure(xi).unwrap(),
            1e-13,
            "body",
        );
    }
}

/// `theta0 int ln(1/|xi - eta|) p0(eta) deta` for `xi` beyond an edge, from the near edge inwards.
fn displacement_of_pressure(contact: &Contact, xi: f64) -> f64 {
    let (gap, sign) = (xi.abs() - 1.0, xi.signum());
    let pressure =
        |d: f64| contact.dimensionless().pressure((sign * (1.0 - d)).clamp(-1.0, 1.0)).unwrap();
    contact.theta0() * integrate(2.0, |d| -(gap + d).ln() * pressure(d))
}

#[test]
fn the_surface_beside_the_punch_is_that_of_the_pressure() {
    let contact = solve(4.0, "xi^2 - xi/3", force_and_moment(1.7, -0.31), 100);
    for xi in [-30.0, -2.0, -1.1, 1.2, 5.0] {
        let exact = displacement_of_pressure(&contact, xi);
        assert_near(contact.elastic_displacement(xi), exact, 1e-11, &format!("xi = {xi}"));
    }
}

#[test]
fn near_the_edges_the_surface_is_that_of_the_pressure_to_the_order_of_the_method() {
    let errors = [16, 32, 64, 128].map(|degree| {
        let contact = solve(4.0, "xi^2 - xi/3", force_and_moment(1.7, -0.31), degree);
        [-1.0 - 1e-9, 1.0 + 1e-9]
            .map(|xi| {
                (contact.elastic_displacement(xi) - displacement_of_pressure(&contact, xi)).abs()
            })
            .into_iter()
            .fold(0.0, f64::max)
    });
    for pair in errors.windows(2) {
        assert!((order(pair[0], pair[1]) - 2.0).abs() < 0.3, "{errors:?}");
    }
}

#[test]
fn the_surface_is_continuous_at_the_edges() {
    // A truncated series leaves the edge as the square root of the distance.
    let contact = solve(4.0, "xi^2 - xi/3", force_and_moment(1.7, -0.31), 100);
    for edge in [-1.0, 1.0] {
        let outside = contact.elastic_displacement(edge * (1.0 + 1e-14));
        assert_near(outside, contact.elastic_displacement(edge), 1e-5, &format!("edge {edge}"));
    }
}

#[test]
fn the_far_surface_falls_as_a_logarithm() {
    let (theta0, force, moment) = (4.0, 1.7, -0.31);
    let contact = solve(theta0, "xi^2 - xi/3", force_and_moment(force, moment), 100);
    for xi in [1e3, -1e3, 1e6, -1e6] {
        // ln(1/|x - s|) = -ln|x| + s/x + O(s^2/x^2)
        let far = theta0 * (-force * f64::abs(xi).ln() + moment / xi);
        assert_near(
            contact.elastic_displacement(xi),
            far,
            10.0 / (xi * xi) + 1e-10,
            &format!("xi = {xi}"),
        );
    }
}

#[test]
fn the_surface_has_units() {
    // theta = 2 (1 - nu^2)/(pi E), u ~ -theta P ln(|x|/a)
    let (modulus, ratio, half_width, force) = (200e9, 0.3, 5e-3, 0.8e6);
    let steel = Elastic::new(modulus, ratio).unwrap();
    let (foundation, punch) =
        (Foundation::new(steel).with_roughness(1.2e-14).unwrap(), Punch::new(half_width).unwrap());
    let problem = Problem::new(foundation, punch, force_and_moment(force, 0.0))
        .unwrap()
        .with_solver(Solver::bilateral());
    let contact = problem.solve().unwrap();
    let theta = 2.0 * (1.0 - ratio * ratio) / (std::f64::consts::PI * modulus);
    let far = -theta * force * 1e4f64.ln();
    assert_near(contact.elastic_displacement(1e4 * half_width) / far, 1.0, 1e-8, "far");
    let x = 0.7 * half_width;
    let layer = 1.2e-14 * contact.pressure(x).unwrap();
    assert_near(
        (contact.base_depth(x) - contact.elastic_displacement(x)) / layer,
        1.0,
        1e-10,
        "what the layer gives way",
    );
}
