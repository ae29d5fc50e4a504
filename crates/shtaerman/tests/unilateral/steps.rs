//! Bases with steps, at which the contact may end under pressure.

use shtaerman::{Load, Rotational, Vertical};

use crate::unilateral::support::{bilateral, load, solve};

fn assert_near(found: f64, exact: f64, tolerance: f64) {
    assert!((found - exact).abs() <= tolerance, "{found} instead of {exact}");
}

#[test]
fn a_stepped_base_at_a_settlement_and_an_eccentricity() {
    // As long as the steps stay clear it is a flat punch of 0.9 of the width: in y = xi/0.9 theta0 is 0.9 times as large, and the logarithm adds 0.9 theta0 ln(0.9) P.
    let base = "where(abs(xi)<0.9,0,1e-4)";
    let width: f64 = 0.9;
    for theta0 in [0.1, 20.0, 300.0] {
        for e in [0.05, -0.25] {
            let (vertical, rotational) = (Vertical::Settlement(1e-5), Rotational::Eccentricity(e));
            let contact = solve(theta0, base, load(vertical, rotational));
            for (end, wall) in contact.dimensionless().zones()[0].into_iter().zip([-width, width]) {
                assert_near(end, wall, 1e-12);
            }
            let force = contact.dimensionless().force() / width;
            let own = load(Vertical::Force(force), Rotational::Moment(force * e / width));
            let flat = bilateral(width * theta0, "0", own);
            let settlement =
                flat.dimensionless().settlement() - width * theta0 * width.ln() * force;
            assert_near(settlement, 1e-5, 1e-12 * 1e-5 * (1.0 + theta0));
            assert_near(
                flat.dimensionless().tilt() / width,
                contact.dimensionless().tilt(),
                1e-11 * 1e-5 * (1.0 + theta0),
            );
            for y in [-0.8, -0.1, 0.5, 0.95] {
                let (found, known) = (
                    contact.dimensionless().pressure(width * y).unwrap(),
                    flat.dimensionless().pressure(y).unwrap(),
                );
                assert_near(found, known, 1e-10 * flat.dimensionless().peak_pressure());
            }
        }
    }
}

#[test]
fn a_pressure_that_rises_towards_a_step_ends_there() {
    // Tilted so that the base goes ever deeper up to the step: by the guaranteed bound, which knows nothing of the search, and by the mirror image.
    let steep =
        |sign: f64| Load::settlement(0.022_730_16).unwrap().with_tilt(-0.309_765 * sign).unwrap();
    for theta0 in [0.01, 1.0, 13_249.0] {
        let contact = solve(theta0, "0.11039*step(xi+0.02938)+1.2324*xi^2", steep(1.0));
        let [[left, right]] = contact.dimensionless().zones()[..] else {
            panic!("{:?}", contact.dimensionless().zones())
        };
        assert_eq!(right, -0.029_38);
        assert!(left < -0.038 && left > -0.0594, "{left}");
        assert!(
            contact.dimensionless().pressure(right).unwrap()
                > contact.dimensionless().pressure(0.5 * (left + right)).unwrap()
        );
        let mirrored = solve(theta0, "0.11039*step(0.02938-xi)+1.2324*xi^2", steep(-1.0));
        assert_near(mirrored.dimensionless().zones()[0][1], -left, 1e-11);
        assert_near(mirrored.dimensionless().force() / contact.dimensionless().force(), 1.0, 1e-7);
        let audited = contact.audited().unwrap();
        assert!(audited.relative_error() < 1e-5, "{theta0}: {:e}", audited.relative_error());
    }
}

fn disk(extra: &str, profile: &str, load: &str) -> shtaerman::Contact {
    let toml = format!(
        "[dimensionless]\n{extra}\ngeometry = \"circular\"\nprofile = \"{profile}\"\n{load}\nmoment = 0\n"
    );
    shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap()
}

/// Shoulders that are steep at their foot: the contact ends a little beyond it, and not at it. Ends and settlements by product integration with Newton's method for the edge, written by another.
#[test]
fn a_contact_reaches_over_a_steep_shoulder() {
    for (theta0, foot, height, power, force, edge, settlement) in [
        (87.87, 0.297, 0.4234, 0.5, 1e-3, 0.309_688_721_722, 0.236_831_291_678),
        (87.87, 0.297, 0.4234, 0.7, 1e-3, 0.408_075_137_728, 0.217_189_295_721_769),
    ] {
        let profile = format!("{height}*max(0, abs(xi) - {foot})^{power}");
        let contact = disk(&format!("theta0 = {theta0}"), &profile, &format!("force = {force}"));
        let contact = contact.dimensionless();
        assert_near(contact.zones()[0][1], edge, 2e-12);
        assert_near(contact.settlement(), settlement, 2e-12);
    }
}

/// The contact ends within some 1e-7 of the foot of the shoulder, where an end that comes back must not rest: the base is as steep there as it likes. The settlement rises with the force by the
/// compliance that each contact states, by Simpson's rule, and the audit, which knows nothing of the search, finds errors below 1e-5.
#[test]
fn a_contact_ends_at_the_foot_of_a_steep_shoulder() {
    for (power, from, by, within) in [(0.5, 3e-9, 1e-9, 1e-7), (0.7, 1e-9, 4e-10, 3e-6)] {
        let profile = format!("5e-4*max(0, abs(xi) - 0.3)^{power}");
        let of = |share: f64| {
            disk("theta0 = 276", &profile, &format!("force = {:e}", from + share * by))
        };
        let contacts = [0.0, 0.5, 1.0].map(of);
        for contact in &contacts {
            let [[_, end]] = contact.dimensionless().zones()[..] else { panic!("one zone") };
            assert!(end > 0.3 && end - 0.3 < within, "{end}");
            let audited = contact.clone().audited().unwrap().relative_error();
            assert!(audited < 1e-5, "{audited:e}");
        }
        let contacts = contacts.map(|contact| contact.dimensionless());
        let [a, b, c] = [0, 1, 2].map(|k: usize| 1.0 / contacts[k].stiffness().force_settlement);
        let risen = contacts[2].settlement() - contacts[0].settlement();
        assert_near(risen / (by * (a + 4.0 * b + c) / 6.0), 1.0, 1e-6);
    }
}

/// A bent layer under waves, where the first step from a uniform pressure is no guide. With the settlement given there is none to be guessed: the force has to come back.
#[test]
fn a_bent_layer_under_waves_on_a_disk() {
    for force in [0.0018, 0.00182, 0.002, 0.0022] {
        let of = |load: &str| disk("theta0 = 257.5\nexponent = 0.5", "0.7544*cos(19.4*xi)", load);
        let pressed = of(&format!("force = {force}"));
        let settlement = pressed.dimensionless().settlement();
        let back = of(&format!("settlement = {settlement:e}")).dimensionless().force();
        assert_near(back / force, 1.0, 1e-10);
    }
}

/// Holes about the axis that are about to close at a tip, a cone or the inner side of a torus. The settlement rises with the force by the compliance that each contact states, by Simpson's rule.
#[test]
fn holes_that_are_about_to_close() {
    for (theta0, profile, from, by, hole) in [
        (20.0, "-abs(xi)^0.5", 1.04, 0.02, 1e-4),
        (20.0, "-abs(xi)", 0.3974, 5e-5, 2e-5),
        (5.0, "(abs(xi) - 0.4)^2", 0.2838, 1e-5, 5e-6),
    ] {
        let of =
            |force: f64| disk(&format!("theta0 = {theta0}"), profile, &format!("force = {force}"));
        let contacts = [0.0, 0.5, 1.0].map(|share| of(from + share * by).dimensionless());
        let [first, _, last] = &contacts;
        for contact in &contacts {
            let inner = contact
                .zones()
                .iter()
                .map(|zone| zone[0])
                .fold(1.0, |least, end| if end > 0.0 { end.min(least) } else { least });
            assert!(inner > hole && inner < 4.0 * hole, "{profile}: {:?}", contact.zones());
        }
        let [a, b, c] = [0, 1, 2].map(|k: usize| 1.0 / contacts[k].stiffness().force_settlement);
        let risen = last.settlement() - first.settlement();
        assert_near(risen / (by * (a + 4.0 * b + c) / 6.0), 1.0, 1e-7);
    }
}

/// A shoulder far from the contact: where its power is below 1 the root of what is 0 there had a slope that was no number.
#[test]
fn a_shoulder_that_is_not_reached_changes_nothing() {
    let of = |profile: &str| {
        let toml = format!(
            "[foundation]\nyoung_modulus = \"1 GPa\"\npoisson_ratio = 0.3\nroughness = 0\n[punch]\nhalf_width = 1\nprofile = \"{profile}\"\n[load]\nforce = \"1 MN/m\"\nmoment = 0\n"
        );
        shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap().dimensionless()
    };
    let plain = of("0.1*x^2");
    for shoulder in
        ["max(0, abs(x) - 0.7)^0.5", "sqrt(max(abs(x) - 0.7, 0))", "max(0, abs(x) - 0.7)^0.9"]
    {
        let contact = of(&format!("0.1*x^2 + 0.05*{shoulder}"));
        assert_near(contact.zones()[0][1] / plain.zones()[0][1], 1.0, 1e-13);
        assert_near(contact.settlement() / plain.settlement(), 1.0, 1e-13);
    }
}

/// The outer end of a ring on a smooth surface stays at the step that the base has there.
#[test]
fn a_ring_ends_at_a_step() {
    let toml = "[foundation]\nyoung_modulus = \"1 Pa\"\npoisson_ratio = 0.3\nroughness = 0\n[punch]\ngeometry = \"circular\"\nradius = 1\nprofile = \"0.02942*r^2+0.002278*abs(r-0.5385)+0.00191*(r > 0.4254)-0.01179*r^0.5\"\n[load]\nforce = 0.008\nmoment = 0\n";
    let contact = shtaerman::file::parse(toml, "test").unwrap().solve().unwrap();
    let zones = contact.dimensionless().zones();
    let [inner, outer] = zones[zones.len() - 1];
    assert!((inner - 0.098_214_149).abs() < 1e-8, "{zones:?}");
    assert_eq!(outer, 0.4254);
}
