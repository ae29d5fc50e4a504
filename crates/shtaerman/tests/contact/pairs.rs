//! One of each pair: whichever is given, the contact is the same; the stiffness that links them.

use crate::contact::support::{
    assert_near, force_and_moment, integral, load, settlement_and_tilt, solve,
};
use shtaerman::{Contact, Rotational, Vertical};

const PROFILES: [&str; 3] = ["0", "10*xi^2 - 3*xi + 1", "cos(2*xi) + sin(3*xi)/2"];
const THETAS: [f64; 5] = [0.0, 1e-3, 0.5, 13.0, 200.0];

fn assert_same(one: &Contact, other: &Contact, what: &str) {
    let scale = 1.0
        + one.dimensionless().settlement().abs()
        + one.dimensionless().tilt().abs()
        + one.dimensionless().force().abs() * one.theta0();
    for (found, exact, name) in [
        (other.dimensionless().force(), one.dimensionless().force(), "force"),
        (other.dimensionless().moment(), one.dimensionless().moment(), "moment"),
        (other.dimensionless().settlement(), one.dimensionless().settlement(), "settlement"),
        (other.dimensionless().tilt(), one.dimensionless().tilt(), "tilt"),
        (
            other.dimensionless().pressure(-1.0).unwrap(),
            one.dimensionless().pressure(-1.0).unwrap(),
            "left edge",
        ),
        (
            other.dimensionless().pressure(0.3).unwrap(),
            one.dimensionless().pressure(0.3).unwrap(),
            "inside",
        ),
        (
            other.dimensionless().pressure(1.0).unwrap(),
            one.dimensionless().pressure(1.0).unwrap(),
            "right edge",
        ),
    ] {
        assert_near(found, exact, 1e-12 * scale, &format!("{what}, {name}"));
    }
}

#[test]
fn whichever_of_each_pair_is_given_the_contact_is_the_same() {
    for theta0 in THETAS {
        for profile in PROFILES {
            let first = solve(theta0, profile, force_and_moment(1.7, -0.31), 100);
            let verticals = [
                Vertical::Force(first.dimensionless().force()),
                Vertical::Settlement(first.dimensionless().settlement()),
            ];
            let rotationals = [
                Rotational::Moment(first.dimensionless().moment()),
                Rotational::Eccentricity(
                    first.dimensionless().moment() / first.dimensionless().force(),
                ),
                Rotational::Tilt(first.dimensionless().tilt()),
            ];
            for vertical in verticals {
                for rotational in rotationals {
                    let again = solve(theta0, profile, load(vertical, rotational), 100);
                    let what =
                        format!("theta0 = {theta0}, f0 = {profile}, {vertical:?}, {rotational:?}");
                    assert_same(&first, &again, &what);
                }
            }
        }
    }
}

#[test]
fn a_level_punch_needs_the_moment_of_its_profile() {
    // (5.1): M0 = -int xi p_f, p_f the answer to f0 alone, which is -p of a punch held at rest.
    for theta0 in THETAS {
        let profile = "xi^3 - xi/2 + xi^2";
        let level = solve(theta0, profile, load(Vertical::Force(0.7), Rotational::Tilt(0.0)), 100);
        let at_rest = solve(theta0, profile, settlement_and_tilt(0.0, 0.0), 100);
        let moment = integral(|xi| xi * at_rest.dimensionless().pressure(xi).unwrap());
        assert_near(level.dimensionless().moment(), moment, 1e-13, &format!("theta0 = {theta0}"));
        assert_eq!(level.dimensionless().tilt(), 0.0);
    }
    // Exactly solvable: on the layer M0 = -int xi^4 + int xi^2/2 = -2/5 + 1/3.
    let layer = solve(0.0, "xi^3 - xi/2", load(Vertical::Force(0.7), Rotational::Tilt(0.0)), 8);
    assert_near(layer.dimensionless().moment(), -2.0 / 5.0 + 1.0 / 3.0, 1e-15, "layer");
}

#[test]
fn a_positive_moment_gives_a_negative_tilt_and_presses_the_right_edge() {
    for theta0 in THETAS {
        let contact = solve(theta0, "xi^2", force_and_moment(1.0, 0.2), 64);
        assert!(
            contact.dimensionless().tilt() < 0.0
                && contact.dimensionless().pressure(1.0).unwrap()
                    > contact.dimensionless().pressure(-1.0).unwrap()
        );
        assert_near(
            contact.dimensionless().tilt() * contact.dimensionless().stiffness().moment_tilt,
            -0.2,
            1e-14,
            "M = -c22 alpha",
        );
    }
}

#[test]
fn the_stiffness_is_the_derivative_of_force_and_moment() {
    for theta0 in THETAS {
        for profile in PROFILES {
            let at = |settlement, tilt| {
                let contact = solve(theta0, profile, settlement_and_tilt(settlement, tilt), 80);
                [contact.dimensionless().force(), contact.dimensionless().moment()]
            };
            let (base, sunk, turned) = (at(0.4, 0.1), at(1.4, 0.1), at(0.4, -0.9));
            let contact = solve(theta0, profile, force_and_moment(1.0, 0.0), 80);
            let stiffness = contact.dimensionless().stiffness();
            let matrix = stiffness.matrix();
            for i in 0..2 {
                assert_near(sunk[i] - base[i], matrix[i][0], 1e-12, profile);
                assert_near(turned[i] - base[i], matrix[i][1], 1e-12, profile);
            }
            let [[c11, c12], [c21, c22]] = matrix;
            assert_eq!(c12, c21);
            assert!(c11 > 0.0 && c22 > 0.0 && c11 * c22 > c12 * c12, "{matrix:?}");
            // At most that of the layer alone.
            assert!(c11 <= 2.0 + 1e-15 && c22 <= 2.0 / 3.0 + 1e-15, "{matrix:?}");
        }
    }
}

#[test]
fn the_stiffness_is_the_energy_of_the_unit_pressures() {
    // c_ij = <u_i, A^-1 u_j> with pressures integrated independently; c12 = c21 is the theorem of Maxwell and Betti.
    for theta0 in [0.5, 13.0] {
        let sunk = solve(theta0, "0", settlement_and_tilt(1.0, 0.0), 100);
        let turned = solve(theta0, "0", settlement_and_tilt(0.0, -1.0), 100);
        let [[c11, c12], [c21, c22]] = sunk.dimensionless().stiffness().matrix();
        assert_near(integral(|xi| sunk.dimensionless().pressure(xi).unwrap()), c11, 1e-13, "c11");
        assert_near(integral(|xi| turned.dimensionless().pressure(xi).unwrap()), c12, 1e-13, "c12");
        assert_near(
            integral(|xi| xi * sunk.dimensionless().pressure(xi).unwrap()),
            c21,
            1e-13,
            "c21",
        );
        assert_near(
            integral(|xi| xi * turned.dimensionless().pressure(xi).unwrap()),
            c22,
            1e-13,
            "c22",
        );
    }
}

#[test]
fn stiffness_falls_as_the_layer_hardens() {
    let mut last = [2.0, 2.0 / 3.0];
    for theta0 in [0.1, 1.0, 10.0, 100.0] {
        let [[c11, _], [_, c22]] = solve(theta0, "0", force_and_moment(1.0, 0.0), 200)
            .dimensionless()
            .stiffness()
            .matrix();
        assert!(c11 < last[0] && c22 < last[1], "theta0 = {theta0}");
        // delta0 >= theta0 P0 ln 2 and alpha0 >= 2 theta0 M0: the layer adds to the compliance of the body.
        assert!(c11 * theta0 < 1.0 / std::f64::consts::LN_2 && c22 * theta0 < 0.5);
        last = [c11, c22];
    }
}
