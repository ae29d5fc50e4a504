//! The pressure near the smooth limit beside a truth of another kind.
//!
//! `p + theta int ln(1/|y - t|) p dt = D - c y^2` on `(-1, 1)` with the force 1, solved by the double-exponential rule with 341 nodes on `|t| <= 4` in arithmetic of 45
//! digits, where nothing is lost to rounding: flat under a settlement `D` (`c = 0`), and with the `c` at which the pressure vanishes at both ends. Other numbers of
//! nodes (181, 261) give the same to 15 digits in the middle and 10 at the ends.

use shtaerman::{Contact, Foundation, Load, Problem, Profile, Punch, Rotational, Vertical};

/// What is stated must not be more than this share of the largest pressure.
const STATED: f64 = 1e-6;

/// Places `y` with the pressure there.
type Pressures = [(f64, f64); 6];

struct Truth {
    theta: f64,
    /// `D` of the flat base, `c` of the parabola.
    constant: f64,
    pressures: Pressures,
}

const FLAT: Truth = Truth {
    theta: 2.5e6,
    constant: 1732869.9305263357,
    pressures: [
        (0.0, 0.3183101123728304),
        (0.6910283997375125, 0.440368196527405),
        (0.980284091855832, 1.6109566432378628),
        (0.9992227632725746, 8.077047142355648),
        (0.999961204327938, 36.26310747540173),
        (0.999996231606522, 118.64873442837641),
    ],
};

const PARABOLA: Truth = Truth {
    theta: 2.5e6,
    constant: 2500003.552970447,
    pressures: [
        (0.0, 0.6366201731431468),
        (0.6910283997375125, 0.4601663458845451),
        (0.980284091855832, 0.1257899990108768),
        (0.9992227632725746, 0.0250873956396135),
        (0.999961204327938, 0.00558222132368),
        (0.999996231606522, 0.0016879304707909),
    ],
};

fn solve(theta0: f64, profile: &str) -> Contact {
    let load = Load::new(Vertical::Force(1.0), Rotational::Moment(0.0)).unwrap();
    let (foundation, punch) =
        (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    let profile = Profile::expression(profile).unwrap();
    Problem::new(foundation, punch.with_profile(profile), load).unwrap().solve().unwrap()
}

/// Compares pressures on the zone `-half .. half`.
fn compare(contact: &Contact, truth: &Truth, half: f64) {
    let largest = contact.dimensionless().peak_pressure();
    let stated = contact.dimensionless().error().unwrap().pressure;
    assert!(stated < STATED * largest, "{stated:e} of {largest}");
    for (y, pressure) in truth.pressures {
        let error = (contact.dimensionless().pressure(half * y).unwrap() - pressure / half).abs();
        assert!(error <= stated, "{} {y}: {error:e} {stated:e}", truth.theta);
    }
}

#[test]
fn flat_punch() {
    let contact = solve(FLAT.theta, "0");
    compare(&contact, &FLAT, 1.0);
    let error = (contact.dimensionless().settlement() / FLAT.constant - 1.0).abs();
    assert!(error < 2e-14, "{error:e}");
}

#[test]
fn parabola_in_half_of_the_base() {
    // On a zone of half the width theta0 counts half, and lengths and pressures change by 2.
    let half = 0.5f64;
    let profile = format!("{:e}*xi^2", PARABOLA.constant / half.powi(3));
    let contact = solve(PARABOLA.theta / half, &profile);
    compare(&contact, &PARABOLA, half);
    let [left, right] = contact.dimensionless().zones()[0];
    let stated = contact.dimensionless().error().and_then(|error| error.zones).unwrap();
    assert!(stated < 1e-7, "{stated:e}");
    assert!((right - half).abs() <= stated && (left + half).abs() <= stated, "{left} {right}");
}
