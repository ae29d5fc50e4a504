//! The linearised equation against differences of complete solves and closed forms.

use crate::support::{bare, load, physical};
use shtaerman::{
    Contact, Derivatives, Elastic, Frame, Geometry, Grading, Load, Problem, Profile, Rotational,
    Roughness, Solver, Vertical,
};

fn problem(
    geometry: Geometry,
    roughness: impl Into<Roughness>,
    profile: &str,
    load: Load,
    solver: Solver,
) -> Problem {
    let body = Elastic::new(200e9, 0.3).unwrap();
    let frame = Frame::physical_in(geometry, body, roughness, 5e-3, None).unwrap();
    Problem::new(frame, Profile::expression(profile).unwrap(), load, solver).unwrap()
}

fn with(vertical: Vertical, rotational: Rotational) -> Load {
    Load::new(vertical, rotational).unwrap()
}

/// All derivatives of all quantities with names, and the sizes they are held against: the largest elasticity of the quantity, or the quantity.
fn all(contact: &Contact, found: &shtaerman::Sensitivities) -> Vec<(String, f64, f64)> {
    let frame = contact.problem().frame();
    let half_width = frame.half_width();
    let roughness = match frame.scaling().map(|scaling| scaling.roughness()) {
        Some(Roughness::Linear { compliance }) => compliance,
        Some(Roughness::Power { coefficient, .. }) => coefficient,
        _ => 0.0,
    };
    let modulus = frame.scaling().map_or(0.0, |scaling| scaling.pressure());
    let parts: Vec<(&str, Option<Derivatives>, f64)> = vec![
        ("settlement", found.settlement, contact.settlement()),
        ("force", found.force, contact.force()),
        ("tilt", found.tilt, contact.settlement() / half_width),
        ("pressure", found.pressure_max, contact.peak_pressure().0),
        ("width", Some(found.contact_width), contact.contact_width()),
    ];
    let mut rows = Vec::new();
    for (name, derivatives, value) in parts {
        let Some(d) = derivatives else { continue };
        for (by, rate, at) in [
            ("roughness", d.roughness, roughness),
            ("modulus", d.young_modulus, modulus),
            ("theta0", d.theta0, contact.theta0()),
            ("force", d.force, contact.force()),
            ("settlement", d.settlement, contact.settlement()),
        ] {
            if let Some(rate) = rate {
                rows.push((format!("{name} by {by}"), rate * at, value));
            }
        }
    }
    rows
}

fn report(label: &str, problem: &Problem) {
    let start = std::time::Instant::now();
    let solved = problem.solve();
    let solve = start.elapsed().as_secs_f64();
    let contact = match solved {
        Ok(c) => c,
        Err(e) => {
            println!("{label}: {e}");
            return;
        }
    };
    let start = std::time::Instant::now();
    let tangent = contact.tangent_sensitivities();
    let tangent_time = start.elapsed().as_secs_f64();
    let Some(tangent) = tangent else {
        println!("{label}: none ({}) {:.1e} {:.1e}", contact.reason(), solve, tangent_time);
        return;
    };
    let start = std::time::Instant::now();
    let Ok(differences) = contact.difference_sensitivities() else {
        println!("{label} no differences");
        return;
    };
    let difference_time = start.elapsed().as_secs_f64();
    let worst = all(&contact, &tangent)
        .into_iter()
        .zip(all(&contact, &differences))
        .map(|((name, one, size), (_, two, _))| {
            let scale = size.abs().max(two.abs());
            ((one - two).abs() / scale, name, one, two)
        })
        .fold((0.0, String::new(), 0.0, 0.0), |most, row| {
            if row.0 >= most.0 || row.0.is_nan() { row } else { most }
        });
    println!(
        "{label}: {:.1e} in {} {} {} (stated {:.0e} {:.0e}, differences {:.0e}) {:?} {:?} ms {:.2} {:.2} {:.2}",
        worst.0,
        worst.1,
        worst.2,
        worst.3,
        tangent.pressure_max.map_or(0.0, |d| d.error),
        tangent.contact_width.error,
        differences.pressure_max.map_or(0.0, |d| d.error).max(differences.contact_width.error),
        contact.method().name,
        contact.method().n,
        1e3 * solve,
        1e3 * tangent_time,
        1e3 * difference_time
    );
}

#[test]
fn survey() {
    let free = load(8e5, 0.0);
    for profile in ["x^2/(2*0.8)", "abs(x)*2e-3"] {
        for power in [-22, -21, -20, -19, -18, -17, -16, -14, -12, -10, -8, -6] {
            let chi = 10f64.powi(power);
            report(
                &format!("chi 1e{power}"),
                &problem(Geometry::Plane, chi, profile, free, Solver::default()),
            );
            report(
                &format!("    disk 1e{power}"),
                &problem(Geometry::Circular, chi, profile, load(4e3, 0.0), Solver::default()),
            );
        }
    }
    for kappa in [0.1, 0.2, 0.4, 0.8, 0.95] {
        let power = Roughness::power(1e-12 * 1e8f64.powf(1.0 - kappa), kappa).unwrap();
        report(
            &format!("kappa {kappa}"),
            &problem(Geometry::Plane, power, "x^2/(2*0.8)", load(8e5, 100.0), Solver::default()),
        );
        report(
            &format!("    disk {kappa}"),
            &problem(Geometry::Circular, power, "x^2/(2*0.8)", load(4e3, 0.0), Solver::default()),
        );
    }
    for count in [40, 200, 2000] {
        let x: Vec<f64> =
            (0..count).map(|i| -5e-3 + 1e-2 * i as f64 / (count - 1) as f64).collect();
        let f: Vec<f64> = x
            .iter()
            .map(|x| 2e-6 * (x * 2600.0).cos() + x * x / 2.0 + 1e-6 * (x * 7100.0).sin())
            .collect();
        let body = Elastic::new(200e9, 0.3).unwrap();
        for chi in [1e-12, 0.0] {
            let frame = Frame::physical(body, chi, 5e-3, None).unwrap();
            let profile = Profile::measured(x.clone(), f.clone()).unwrap();
            let problem = Problem::new(frame, profile, load(4e5, 20.0), Solver::default()).unwrap();
            report(&format!("measured {count} {chi}"), &problem);
        }
    }
}
