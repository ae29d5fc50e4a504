//! Zones so small, and so far from the middle, that heights of the base differ in their last digits only.

use shtaerman::{
    Contact, Elastic, Error, Foundation, Load, Problem, Profile, Punch, Rotational, Vertical, file,
};

const RADIUS: f64 = 0.5;
const ARM: f64 = 0.125e-3;
const HALF_WIDTH: f64 = 5e-3;

fn parabola(force: f64, arm: f64) -> Contact {
    let body = Elastic::new(200e9, 0.3).unwrap();
    let (foundation, punch) =
        (Foundation::new(body).with_roughness(1e-15).unwrap(), Punch::new(HALF_WIDTH).unwrap());
    let load = Load::new(Vertical::Force(force), Rotational::Eccentricity(arm)).unwrap();
    let profile = Profile::expression(&format!("x^2/(2*{RADIUS})")).unwrap();
    Problem::new(foundation, punch.with_profile(profile), load).unwrap().solve().unwrap()
}

#[test]
fn a_parabola_moves_with_the_line_of_a_small_force() {
    // (c + t)^2 = c^2 + 2 c t + t^2: the contact about c is that about 0 on a base that has turned.
    for exponent in [-2, -5, -7] {
        let force = 10f64.powi(exponent);
        let (centric, eccentric) = (parabola(force, 0.0), parabola(force, ARM));
        let [[left, right], [low, high]] =
            [centric.dimensionless().zones()[0], eccentric.dimensionless().zones()[0]];
        let arm = ARM / HALF_WIDTH;
        // Edges are stated as places on the base: to a share of it.
        assert!((low - arm - left).abs() < 1e-15 + 1e-10 * right, "{force}: {low} {left}");
        assert!((high - arm - right).abs() < 1e-15 + 1e-10 * right, "{force}: {high} {right}");
        let peaks = [&centric, &eccentric].map(Contact::peak_pressure);
        assert!((peaks[1] / peaks[0] - 1.0).abs() < 1e-8, "{force}: {peaks:?}");
        let turned = -ARM / RADIUS;
        assert!((eccentric.tilt() / turned - 1.0).abs() < 1e-11, "{force}: {}", eccentric.tilt());
        let lowered = centric.settlement() - ARM * ARM / (2.0 * RADIUS);
        // Heights are counted from a tangent where more than eleven digits would be lost.
        assert!((eccentric.settlement() - lowered).abs() < 1e-12 * lowered.abs(), "{force}");
        let left = eccentric.complementarity().unwrap();
        assert!(left.tension.max(left.penetration) < 1e-9, "{force}: {left:?}");
    }
}

#[test]
fn the_width_of_a_small_zone_far_from_the_middle_grows_as_its_differences_say() {
    for exponent in [-2, -5] {
        let force = 10f64.powi(exponent);
        let rates = parabola(force, ARM).tangent_sensitivities().unwrap().contact_width;
        let step = 1e-3 * force;
        let width = |force: f64| parabola(force, ARM).contact_width();
        let rate = (width(force + step) - width(force - step)) / (2.0 * step);
        let found = rates.force.unwrap();
        assert!((found / rate - 1.0).abs() < 1e-5, "{force}: {found:e} {rate:e}");
    }
}

/// A tiny zone about a kink: some of its panels are a few roundings of a place long, and cutting makes them no shorter. Found by random problems, where it had no end.
#[test]
fn panels_as_short_as_places_are_rounded_come_to_an_end() {
    let text = "[dimensionless]\ntheta0 = 3.9867691219696694e-1\ngeometry = \"pair\"\ninner_half_gap = 0.2\nprofile = \"3.771134996260252e1*(abs(xi - 0.323))\"\n\
                force = 2.7775500955536497e-14\ntilt = 0\n[solver]\ntolerance = 6.975573809573374e-11\n";
    let refused = file::parse(text, "test").unwrap().solve().unwrap_err();
    assert!(matches!(refused, Error::ToleranceNotMet { .. }), "{refused}");
}
