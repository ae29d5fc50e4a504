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
    let contact = problem.solve().unwrap();
    let Some(tangent) = contact.tangent_sensitivities() else {
        println!("{label}: none ({})", contact.reason());
        return;
    };
    let differences = contact.difference_sensitivities().unwrap();
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
        "{label}: {:.1e} in {} {} {} (stated {:.0e}, differences {:.0e}) {:?}",
        worst.0,
        worst.1,
        worst.2,
        worst.3,
        tangent.pressure_max.map_or(0.0, |d| d.error).max(tangent.contact_width.error),
        differences.pressure_max.map_or(0.0, |d| d.error).max(differences.contact_width.error),
        contact.method(),
    );
}

#[test]
fn survey() {
    let free = load(8e5, 0.0);
    let (force, settlement) = (Vertical::Force(8e5), Vertical::Settlement(6e-6));
    let power = Roughness::power(2e-10, 0.6).unwrap();
    let plane = Geometry::Plane;
    let go = |label: &str, geometry, roughness: Roughness, profile: &str, load, solver| {
        report(label, &problem(geometry, roughness, profile, load, solver));
    };
    let chi = Roughness::from(1.2e-14);
    let rough = Roughness::from(1.2e-12);
    let on = Solver::default();
    let off = Solver::bilateral();
    go("parabola", plane, chi, "x^2/(2*0.8)", free, on);
    go("full", plane, chi, "x^2/(2*80)", free, on);
    go("moment", plane, rough, "x^2/(2*0.8)", load(8e5, 300.0), on);
    go("tilted flat", plane, rough, "0", load(8e5, 2500.0), on);
    go("eccentric", plane, rough, "x^2/(2*0.8)", with(force, Rotational::Eccentricity(6e-4)), on);
    go("settled", plane, rough, "x^2/(2*0.8)", with(settlement, Rotational::Tilt(1e-4)), on);
    go(
        "settled moment",
        plane,
        rough,
        "x^2/(2*0.8)",
        with(settlement, Rotational::Moment(200.0)),
        on,
    );
    go(
        "settled ecc",
        plane,
        rough,
        "x^2/(2*0.8)",
        with(settlement, Rotational::Eccentricity(2e-4)),
        on,
    );
    go("power", plane, power, "x^2/(2*0.8)", free, on);
    go("power moment", plane, power, "x^2/(2*0.8)", load(8e5, 300.0), on);
    go("power full", plane, power, "x^2/(2*80)", free, on);
    go("power settled", plane, power, "x^2/(2*0.8)", with(settlement, Rotational::Tilt(1e-4)), on);
    go("wavy zones", plane, rough, "2e-6*cos(9*x/a) + x^2/20", load(2e5, 50.0), on);
    go("wedge", plane, rough, "abs(x)*2e-3", load(8e5, 100.0), on);
    go("pair", Geometry::Pair { inner_half_gap: 2e-3 }, rough, "x^2/(2*4)", load(8e5, 300.0), on);
    go("row", Geometry::Periodic { period: 14e-3 }, rough, "x^2/(2*0.8)", load(8e5, 300.0), on);
    go("wave gap", Geometry::Periodic { period: 10e-3 }, rough, "8e-6*(1-cos(pi*x/a))", free, on);
    go(
        "wave off",
        Geometry::Periodic { period: 10e-3 },
        rough,
        "8e-6*(1-cos(pi*(x/a-0.3)))",
        free,
        on,
    );
    go(
        "wave full",
        Geometry::Periodic { period: 10e-3 },
        rough,
        "1e-7*(1-cos(pi*(x/a-0.3)))",
        free,
        on,
    );
    go(
        "wave full power",
        Geometry::Periodic { period: 10e-3 },
        power,
        "1e-7*(1-cos(pi*(x/a-0.3)))",
        free,
        on,
    );
    go(
        "wave full settled",
        Geometry::Periodic { period: 10e-3 },
        rough,
        "1e-7*(1-cos(pi*(x/a-0.3)))",
        with(settlement, Rotational::Tilt(0.0)),
        off,
    );
    go(
        "wave full power settled",
        Geometry::Periodic { period: 10e-3 },
        power,
        "1e-7*(1-cos(pi*(x/a-0.3)))",
        with(settlement, Rotational::Tilt(0.0)),
        on,
    );
    let disk = Geometry::Circular;
    let small = load(4e3, 0.0);
    go("ball", disk, rough, "x^2/(2*0.8)", small, on);
    go("ball power", disk, power, "x^2/(2*0.8)", small, on);
    go("ring", disk, rough, "2e-6*cos(2*pi*x/a)+x^2/20", load(1e3, 0.0), on);
    go("flat disk moment", disk, rough, "x^2/(2*80)", load(4e4, 20.0), on);
    go(
        "flat disk ecc",
        disk,
        rough,
        "x^2/(2*80)",
        with(Vertical::Force(4e4), Rotational::Eccentricity(5e-4)),
        on,
    );
    go(
        "flat disk settled ecc",
        disk,
        rough,
        "x^2/(2*80)",
        with(settlement, Rotational::Eccentricity(5e-4)),
        on,
    );
    go(
        "flat disk tilt",
        disk,
        rough,
        "x^2/(2*80)",
        with(Vertical::Force(4e4), Rotational::Tilt(1e-4)),
        on,
    );
    go("bilateral", plane, rough, "x^2/(2*0.8)", load(8e5, 300.0), off);
    go("bilateral kink", plane, rough, "abs(x)*2e-3", load(8e5, 300.0), off);
    go("bilateral spectral", plane, rough, "x^2/(2*0.8)", load(8e5, 300.0), Solver::spectral(200));
    go("bilateral paper", plane, rough, "x^2/(2*0.8)", load(8e5, 300.0), Solver::spectral(12));
    go("bilateral oscillating", plane, rough, "1e-7*cos(400*x/a)", load(8e5, 300.0), off);
    go("bilateral power", plane, power, "x^2/(2*80)", load(8e5, 300.0), off);
    let smooth = Roughness::Smooth;
    go("smooth hertz", plane, smooth, "x^2/(2*0.8)", free, on);
    go("smooth moment", plane, smooth, "x^2/(2*0.8)+4*x^4", load(8e5, 300.0), on);
    go(
        "smooth settled",
        plane,
        smooth,
        "x^2/(2*0.8)",
        with(settlement, Rotational::Tilt(1e-4)),
        on,
    );
    go("smooth flat", plane, smooth, "0", load(8e5, 300.0), on);
    go("smooth tilted flat", plane, smooth, "0", load(8e5, 2500.0), on);
    go("smooth wedge", plane, smooth, "abs(x)*2e-3", free, on);
    go("smooth zones", plane, smooth, "2e-6*cos(9*x/a) + x^2/20", load(2e5, 50.0), on);
    go(
        "smooth pair",
        Geometry::Pair { inner_half_gap: 2e-3 },
        smooth,
        "x^2/(2*4)",
        load(8e5, 300.0),
        on,
    );
    go(
        "smooth row",
        Geometry::Periodic { period: 14e-3 },
        smooth,
        "x^2/(2*0.8)",
        load(8e5, 300.0),
        on,
    );
    go(
        "smooth wave",
        Geometry::Periodic { period: 10e-3 },
        smooth,
        "8e-6*(1-cos(pi*(x/a-0.3)))",
        free,
        on,
    );
    go(
        "smooth wave settled",
        Geometry::Periodic { period: 10e-3 },
        smooth,
        "8e-6*(1-cos(pi*(x/a-0.3)))",
        with(settlement, Rotational::Tilt(0.0)),
        on,
    );
    go(
        "smooth wave full",
        Geometry::Periodic { period: 10e-3 },
        smooth,
        "1e-7*(1-cos(pi*x/a))",
        free,
        on,
    );
    go("smooth ball", disk, smooth, "x^2/(2*0.8)", small, on);
    go("smooth cone", disk, smooth, "abs(x)*2e-3", small, on);
    go("smooth disk", disk, smooth, "0", load(4e4, 10.0), on);
    go(
        "smooth ball settled",
        disk,
        smooth,
        "x^2/(2*0.8)",
        with(settlement, Rotational::Tilt(0.0)),
        on,
    );
    let bodied = |roughness: f64| {
        let (one, two) = (Elastic::new(200e9, 0.3).unwrap(), Elastic::new(70e9, 0.33).unwrap());
        let frame = Frame::physical(one, roughness, 5e-3, Some(two)).unwrap();
        let profile = Profile::expression("x^2/(2*0.8)").unwrap();
        Problem::new(frame, profile, load(8e5, 100.0), Solver::default()).unwrap()
    };
    report("elastic punch", &bodied(1e-13));
    report("elastic punch smooth", &bodied(0.0));
    for (geometry, force) in [(plane, 1e5), (disk, 1e3)] {
        let grading = Grading::new(0.3, 2e11).unwrap();
        let frame = Frame::physical_graded(geometry, grading, 0.3, 1e-13, 5e-3).unwrap();
        let profile = Profile::expression("x^2/(2*0.8)").unwrap();
        let problem = Problem::new(frame, profile, load(force, 0.0), Solver::default()).unwrap();
        report("graded", &problem);
    }
    report("nearly smooth", &physical(200e9, 1e-21, 5e-3, "x^2/(2*0.8)", free));
    report("bare", &bare(3.0, "xi^2 - xi/2", load(2.0, 0.3), Solver::bilateral()));
    report("bare free", &bare(3.0, "8*xi^2 - xi/2", load(2.0, 0.3), on));
    report("layer", &bare(0.0, "50*xi^2", load(1.0, 0.0), on));
}
