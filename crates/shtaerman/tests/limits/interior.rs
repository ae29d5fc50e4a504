//! The pressure near the smooth limit beside a truth of another kind.
//!
//! `p + theta int ln(1/|y - t|) p dt = D - c y^2` on `(-1, 1)` with the force 1, solved by the double-exponential rule with 341 nodes on `|t| <= 4` in arithmetic of 45
//! digits, where nothing is lost to rounding: flat under a settlement `D` (`c = 0`), and with the `c` at which the pressure vanishes at both ends. Other numbers of
//! nodes (181, 261) give the same to 15 digits in the middle and 10 at the ends.

use shtaerman::{Contact, Foundation, Load, Problem, Profile, Punch, Rotational, Vertical};

/// What the pressure between the layers may be wrong by, of its mean, and what is added to that over the distance from the ends; in the layers the stated error holds.
const BETWEEN: f64 = 2e-14;
const OVER_DISTANCE: f64 = 4e-15;
const LAYER: f64 = 1e3;
/// What is stated must not be more than this share of the largest pressure.
const STATED: f64 = 2e-9;

/// Places `y` with the pressure there.
type Pressures = [(f64, f64); 6];

struct Truth {
    theta: f64,
    /// `D` of the flat base, `c` of the parabola.
    constant: f64,
    pressures: Pressures,
}

const FLAT: [Truth; 2] = [
    Truth {
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
    },
    Truth {
        theta: 1.0e8,
        constant: 69314720.40888196,
        pressures: [
            (0.0, 0.3183098930282333),
            (0.6910283997375125, 0.4403676548537023),
            (0.980284091855832, 1.6109355780453916),
            (0.9999774771924616, 47.43755897691668),
            (0.9999990090264119, 226.8787852768554),
            (0.9999998954359289, 711.0504514343663),
        ],
    },
];

const PARABOLA: [Truth; 2] = [
    Truth {
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
    },
    Truth {
        theta: 1.0e8,
        constant: 100000004.3004902,
        pressures: [
            (0.0, 0.6366197847664052),
            (0.6910283997375125, 0.4601663473232812),
            (0.980284091855832, 0.125791725158596),
            (0.9999774771924616, 0.0042715784440415),
            (0.9999990090264119, 0.0008922518305136),
            (0.9999998954359289, 0.0002820065250596),
        ],
    },
];

fn solve(theta0: f64, profile: &str) -> Contact {
    let load = Load::new(Vertical::Force(1.0), Rotational::Moment(0.0)).unwrap();
    let (foundation, punch) =
        (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    let profile = Profile::expression(profile).unwrap();
    Problem::new(foundation, punch.with_profile(profile), load).unwrap().solve().unwrap()
}

/// Compares pressures on the zone `-half .. half`.
fn compare(contact: &Contact, truth: &Truth, half: f64) {
    assert_eq!(contact.method().name, "expansion");
    let largest = contact.dimensionless().peak_pressure();
    let stated = contact.dimensionless().error().unwrap().pressure;
    assert!(stated < STATED * largest, "{stated:e} of {largest}");
    for (y, pressure) in truth.pressures {
        let error = (contact.dimensionless().pressure(half * y).unwrap() - pressure / half).abs();
        assert!(error <= stated, "{} {y}: {error:e} {stated:e}", truth.theta);
        if (1.0 - y) * truth.theta > LAYER {
            let allowed = (BETWEEN + OVER_DISTANCE / (1.0 - y)) / half;
            assert!(error < allowed, "{} {y}: {error:e} {allowed:e}", truth.theta);
        }
    }
}

#[test]
fn flat_punch() {
    for truth in &FLAT {
        let contact = solve(truth.theta, "0");
        compare(&contact, truth, 1.0);
        let error = (contact.dimensionless().settlement() / truth.constant - 1.0).abs();
        assert!(error < 2e-14, "{error:e}");
    }
}

#[test]
fn parabola_in_half_of_the_base() {
    for truth in &PARABOLA {
        // On a zone of half the width theta0 counts half, and lengths and pressures change by 2.
        let half = 0.5f64;
        let profile = format!("{:e}*xi^2", truth.constant / half.powi(3));
        let contact = solve(truth.theta / half, &profile);
        compare(&contact, truth, half);
        let [left, right] = contact.dimensionless().zones()[0];
        let stated = contact.dimensionless().error().and_then(|error| error.zones).unwrap();
        assert!(stated < 1e-10, "{stated:e}");
        assert!((right - half).abs() <= stated && (left + half).abs() <= stated, "{left} {right}");
    }
}
