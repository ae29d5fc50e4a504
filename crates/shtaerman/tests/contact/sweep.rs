//! Sweeps over `theta0` against single solves.

use shtaerman::{
    Foundation, Load, MethodChoice, Problem, Profile, Punch, Rotational, Solver, Swept, Vertical,
};

fn problem(profile: &str, load: Load) -> Problem {
    let punch = Punch::new(1.0).unwrap().with_profile(Profile::expression(profile).unwrap());
    let foundation = Foundation::dimensionless(1.0).unwrap();
    Problem::new(foundation, punch, load).unwrap().with_solver(Solver::bilateral())
}

#[test]
fn a_sweep_tells_what_single_solves_tell() {
    let force = Vertical::Force(0.7);
    let settlement = Vertical::Settlement(1.3);
    let theta0 = [0.0, 0.03, 1.0, 17.5, 400.0];
    for profile in ["0", "xi^2 - xi/3", "100 + exp(xi)", "cos(9*xi)"] {
        for (vertical, rotational) in [
            (force, Rotational::Moment(0.2)),
            (force, Rotational::Eccentricity(-0.4)),
            (force, Rotational::Tilt(0.3)),
            (settlement, Rotational::Moment(-0.1)),
            (settlement, Rotational::Eccentricity(0.05)),
            (settlement, Rotational::Tilt(0.0)),
        ] {
            let problem = problem(profile, Load::new(vertical, rotational).unwrap());
            let sweep = problem.theta0_sweep([0.0, 400.0]).unwrap().unwrap();
            assert!(sweep.relative_error() < 1e-10, "{profile}: {:e}", sweep.relative_error());
            let mut swept = [Swept::default(); 5];
            sweep.run(&theta0, &mut swept);
            for (theta0, found) in theta0.into_iter().zip(&swept) {
                let single = problem.with_theta0(theta0).unwrap().solve().unwrap();
                let error = single.error().unwrap();
                let [displacement, pressure, force] =
                    found.sizes().map(|size| size * sweep.relative_error());
                for (name, off, allowed) in [
                    (
                        "settlement",
                        found.settlement - single.settlement(),
                        displacement + error.settlement,
                    ),
                    ("tilt", found.tilt - single.tilt(), displacement + error.tilt),
                    (
                        "left",
                        found.pressure_left - single.pressure_left(),
                        pressure + error.pressure,
                    ),
                    (
                        "right",
                        found.pressure_right - single.pressure_right(),
                        pressure + error.pressure,
                    ),
                    ("force", found.force - single.force(), force + error.force),
                    ("moment", found.moment - single.moment(), force + error.moment),
                ] {
                    assert!(
                        off.abs() <= allowed,
                        "{profile} {vertical:?} {rotational:?} {theta0} {name}: {off:e} off, {allowed:e} stated"
                    );
                }
                let known = single.stiffness().matrix();
                for (found, known) in found.stiffness.iter().flatten().zip(known.iter().flatten()) {
                    assert!((found - known).abs() < 1e-10 * single.stiffness().force_settlement);
                }
            }
        }
    }
}

#[test]
fn what_is_no_sweep_is_left_to_single_solves() {
    let smooth = problem("xi^2", Load::force(1.0).unwrap());
    assert!(smooth.theta0_sweep([0.1, 10.0]).unwrap().is_some());
    let bilateral = Solver::bilateral();
    for other in [
        problem("abs(xi)", Load::force(1.0).unwrap()),
        // Far too fine for the nodes that are tried.
        problem("cos(3000*xi)", Load::force(1.0).unwrap()),
        smooth.with_solver(Solver::unilateral()),
        smooth.with_solver(bilateral.with_method(MethodChoice::Spectral).unwrap()),
        smooth.with_solver(bilateral.with_tolerance(1e-9).unwrap()),
        smooth
            .with_foundation(Foundation::dimensionless(1.0).unwrap().with_exponent(0.5).unwrap())
            .unwrap(),
    ] {
        assert!(other.theta0_sweep([0.1, 10.0]).unwrap().is_none());
    }
    assert!(smooth.theta0_sweep([-1.0, 10.0]).is_err());
    assert!(smooth.theta0_sweep([0.0, f64::NAN]).is_err());
    let sweep = smooth.theta0_sweep([0.1, 10.0]).unwrap().unwrap();
    let mut beyond = [Swept::default(); 2];
    sweep.run(&[11.0, f64::NAN], &mut beyond);
    assert!(beyond.iter().all(|swept| swept.settlement.is_nan() && swept.pressure_left.is_nan()));
}
