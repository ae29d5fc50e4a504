//! The conditions of unilateral contact, and what follows from them.

use crate::unilateral::support::{bilateral, force_and_moment, integral, load, over_zones, solve};
use shtaerman::{Contact, Rotational, Vertical};

/// The equation, the signs and the balance, by a quadrature of its own.
fn holds(contact: &Contact, kink: f64, tolerance: f64) {
    let theta0 = contact.theta0();
    let zones = contact.dimensionless().zones();
    let potential = |xi: f64| -> f64 {
        let kernel = |eta: f64| {
            let distance = (xi - eta).abs();
            if distance == 0.0 {
                0.0
            } else {
                -distance.ln() * contact.dimensionless().pressure(eta).unwrap()
            }
        };
        zones
            .iter()
            .map(|&[left, right]| {
                let mut cuts = vec![left];
                cuts.extend([xi.min(kink), xi.max(kink)]);
                cuts.retain(|cut| *cut >= left && *cut < right);
                cuts.push(right);
                cuts.windows(2).map(|pair| integral(pair[0], pair[1], kernel)).sum::<f64>()
            })
            .sum()
    };
    let scale = 1.0 + theta0 * contact.dimensionless().force();
    for i in 0..=60 {
        let xi = f64::from(i) / 30.0 - 1.0;
        let depth = contact.dimensionless().settlement()
            - contact.dimensionless().tilt() * xi
            - contact.problem().dimensionless_profile(xi);
        let pressure = contact.dimensionless().pressure(xi).unwrap();
        let gap = pressure + theta0 * potential(xi) - depth;
        assert!(pressure > -tolerance * scale, "{xi}: {pressure}");
        assert!(
            (gap - contact.dimensionless().gap(xi).unwrap()).abs() < tolerance * scale,
            "{xi}: {gap}"
        );
        assert!(gap > -tolerance * scale && (gap * pressure).abs() < tolerance * scale * scale);
    }
    let force = over_zones(contact, kink, |xi| contact.dimensionless().pressure(xi).unwrap());
    let moment = over_zones(contact, kink, |xi| xi * contact.dimensionless().pressure(xi).unwrap());
    assert!(
        (force - contact.dimensionless().force()).abs() < 1e-11 * scale,
        "{force} {}",
        contact.dimensionless().force()
    );
    assert!((moment - contact.dimensionless().moment()).abs() < 1e-11 * scale);
    let left = contact.complementarity().unwrap();
    assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{left:?}");
}

#[test]
fn one_zone() {
    for theta0 in [1e-3, 1.0, 30.0, 1e3] {
        for (profile, moment) in
            [("6*xi^2", 0.1), ("0", 0.7), ("exp(3*xi)", 0.0), ("2*abs(xi - 0.2)", -0.1)]
        {
            holds(&solve(theta0, profile, force_and_moment(1.0, moment)), 0.2, 1e-10);
        }
    }
}

#[test]
fn several_zones() {
    for theta0 in [1e-3, 1.0, 30.0] {
        for (waves, count) in [(6.2, 2), (12.0, 4)] {
            let profile = format!("{}*(1 - cos({waves}*xi + 0.3))", 5.0 * (1.0 + theta0));
            let contact = solve(theta0, &profile, force_and_moment(1.0, 0.05));
            assert!(
                contact.dimensionless().zones().len() >= count,
                "{theta0} {:?}",
                contact.dimensionless().zones()
            );
            holds(&contact, 0.0, 1e-10);
        }
    }
}

#[test]
fn a_step_of_the_base_is_an_edge_under_pressure() {
    let contact = solve(1.0, "where(xi > 0.25, 9, 0)", force_and_moment(1.0, -0.3));
    assert_eq!(contact.dimensionless().zones()[0][1], 0.25);
    assert!(contact.dimensionless().pressure(0.25).unwrap() > 0.1);
    holds(&contact, 0.0, 1e-10);
}

#[test]
fn reflection_reflects() {
    let right = solve(7.0, "9*xi^2 - 2*xi + sin(9*xi)", force_and_moment(1.0, 0.2));
    let left = solve(7.0, "9*xi^2 + 2*xi - sin(9*xi)", force_and_moment(1.0, -0.2));
    assert_eq!(right.dimensionless().zones().len(), left.dimensionless().zones().len());
    for (one, other) in
        right.dimensionless().zones().iter().zip(left.dimensionless().zones().iter().rev())
    {
        assert!((one[0] + other[1]).abs() < 1e-12 && (one[1] + other[0]).abs() < 1e-12);
    }
    assert!((right.dimensionless().settlement() - left.dimensionless().settlement()).abs() < 1e-11);
    assert!((right.dimensionless().tilt() + left.dimensionless().tilt()).abs() < 1e-11);
}

#[test]
fn a_bilateral_contact_without_tension_is_unilateral() {
    for (theta0, profile, moment) in [(0.5, "0.2*xi^2", 0.1), (20.0, "0", 0.3), (1e3, "xi^2", -0.1)]
    {
        let load = force_and_moment(1.0, moment);
        let unilateral = solve(theta0, profile, load);
        let bilateral = bilateral(theta0, profile, load);
        assert!(bilateral.complementarity().is_none() && unilateral.complementarity().is_some());
        assert!(bilateral.tension().is_empty());
        assert_eq!(unilateral.dimensionless().zones(), [[-1.0, 1.0]]);
        let size = 1e-12 * (1.0 + theta0);
        assert!(
            (bilateral.dimensionless().settlement() - unilateral.dimensionless().settlement())
                .abs()
                < size
        );
        assert!(
            (bilateral.dimensionless().tilt() - unilateral.dimensionless().tilt()).abs() < size
        );
        for i in -20..=20 {
            let xi = f64::from(i) * 0.05;
            assert!(
                (bilateral.dimensionless().pressure(xi).unwrap()
                    - unilateral.dimensionless().pressure(xi).unwrap())
                .abs()
                    < size
            );
        }
        let (one, other) =
            (bilateral.dimensionless().stiffness(), unilateral.dimensionless().stiffness());
        assert!((one.force_settlement - other.force_settlement).abs() < 1e-12);
        assert!((one.moment_tilt - other.moment_tilt).abs() < 1e-12);
    }
}

#[test]
fn the_stiffness_is_the_derivative() {
    let profile = "8*xi^2 + xi^3";
    let at = |delta: f64, alpha: f64| {
        solve(5.0, profile, load(Vertical::Settlement(delta), Rotational::Tilt(alpha)))
    };
    let stiffness = at(2.0, 0.5).dimensionless().stiffness();
    let h = 1e-4;
    let force = (at(2.0 + h, 0.5).dimensionless().force()
        - at(2.0 - h, 0.5).dimensionless().force())
        / (2.0 * h);
    let coupling = (at(2.0 + h, 0.5).dimensionless().moment()
        - at(2.0 - h, 0.5).dimensionless().moment())
        / (2.0 * h);
    let turn = (at(2.0, 0.5 - h).dimensionless().moment()
        - at(2.0, 0.5 + h).dimensionless().moment())
        / (2.0 * h);
    assert!((stiffness.force_settlement - force).abs() < 1e-7, "{stiffness:?} {force}");
    assert!((stiffness.coupling - coupling).abs() < 1e-7, "{stiffness:?} {coupling}");
    assert!((stiffness.moment_tilt - turn).abs() < 1e-7, "{stiffness:?} {turn}");
}
