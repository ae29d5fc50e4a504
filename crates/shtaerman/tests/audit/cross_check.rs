//! The reference agrees with answers of every geometry and kind of contact, and disagrees with disturbed ones.

use shtaerman::{CrossCheck, Foundation, Load, Problem, Profile, Punch, Rotational, Vertical};

fn problem(toml: &str) -> Problem {
    shtaerman::file::parse(toml, "test").unwrap()
}

fn checked(toml: &str) -> CrossCheck {
    let problem = problem(toml);
    let contact = problem.solve().unwrap().audited().unwrap();
    problem.cross_check(&contact).unwrap()
}

/// Physical files with all units one.
fn ground(foundation: &str, punch: &str, load: &str) -> String {
    format!("[foundation]\npoisson_ratio = 0.3\n{foundation}\n[punch]\n{punch}\n[load]\n{load}\n")
}

#[test]
fn every_geometry_agrees() {
    let plain = |keys: &str| format!("[dimensionless]\n{keys}\n");
    let files = [
        plain("theta0 = 2\nprofile = \"xi^2\"\nforce = 0.2\nmoment = 0.02"),
        plain(
            "theta0 = 2\nprofile = \"abs(xi)\"\nforce = 1\neccentricity = 0.2\n[solver]\ncontact = \"bilateral\"",
        ),
        plain(
            "theta0 = 3\nprofile = \"xi^2\"\nsettlement = 2\ntilt = 0.1\ngeometry = \"pair\"\ninner_half_gap = 0.4",
        ),
        plain(
            "theta0 = 3\nprofile = \"cos(3*xi)\"\nforce = 0.5\nmoment = 0.1\ngeometry = \"periodic\"\nperiod = 3",
        ),
        plain(
            "theta0 = 3\nprofile = \"cos(pi*xi)\"\nforce = 0.5\nmoment = 0\ngeometry = \"periodic\"\nperiod = 2",
        ),
        plain("theta0 = 3\nprofile = \"rho^2\"\nforce = 0.5\nmoment = 0\ngeometry = \"circular\""),
        plain(
            "theta0 = 3\nprofile = \"0.1*rho^2\"\nforce = 3\nmoment = 0.3\ngeometry = \"circular\"",
        ),
        plain("theta0 = 3\nprofile = \"xi^2\"\nforce = 0.5\nmoment = 0.1\nexponent = 0.5"),
        ground(
            "grading_exponent = 0.3\ngrading_modulus = 1\nroughness = 0.5",
            "half_width = 1\nprofile = \"x^2\"",
            "force = 0.3\nmoment = 0.03",
        ),
        ground(
            "young_modulus = 1\nroughness = 0",
            "half_width = 1\nprofile = \"x^2\"",
            "force = 0.3\nmoment = 0.05",
        ),
        ground(
            "young_modulus = 1\nroughness = 0",
            "half_width = 1\ngeometry = \"periodic\"\nperiod = 3\nprofile = \"x^2\"",
            "force = 0.3\nmoment = 0.05",
        ),
        ground(
            "young_modulus = 1\nroughness = 0",
            "radius = 1\ngeometry = \"circular\"\nprofile = \"x^2\"",
            "force = 0.3\nmoment = 0",
        ),
    ];
    for toml in files {
        let check = checked(&toml);
        assert!(check.agrees, "{toml}\n{check:?}");
        // Where its panels meet, a power kernel weighs units of the machine by their power 1 - mu.
        let most = if toml.contains("grading_exponent") { 1e-9 } else { 1e-10 };
        assert!(check.reference_error.pressure < most, "{toml}\n{check:?}");
        assert_eq!(check.method, "product_integration");
    }
}

#[test]
fn disturbed_answers_are_found_out() {
    for (keys, by) in [
        ("theta0 = 2\nforce = 0.2\nmoment = 0.02\n", 1e-9),
        ("theta0 = 3\nforce = 0.5\nmoment = 0\ngeometry = \"circular\"\n", 1e-9),
        ("theta0 = 3\nforce = 0.5\nmoment = 0.1\nexponent = 0.5\n", 1e-9),
    ] {
        let file =
            |profile: &str| problem(&format!("[dimensionless]\n{keys}profile = \"{profile}\"\n"));
        let disturbed = file(&format!("xi^2 + {by}*cos(4*xi)"));
        let contact = disturbed.solve().unwrap().audited().unwrap();
        let check = file("xi^2").cross_check(&contact).unwrap();
        assert!(!check.agrees && check.pressure > 0.1 * by, "{keys} {check:?}");
    }
}

#[test]
fn what_is_too_large_is_refused_with_the_reason() {
    let many = problem(
        "[dimensionless]\ntheta0 = 2\nprofile = \"0.001*cos(900*xi)\"\nforce = 1\nmoment = 0\n[solver]\ncontact = \"bilateral\"\n",
    );
    let error = many.cross_check(&many.solve().unwrap()).unwrap_err();
    assert!(error.is_numerical(), "{error}");
    assert!(error.to_string().contains("unknowns, and at most"), "{error}");
}

#[test]
fn a_trace_under_a_power_law_agrees() {
    // Three digits by collocation through its points; on panels all that the reference has.
    let heights =
        [0.51, 0.268, 0.09, 0.104, -0.022, 0.035, 0.017, 0.038, 0.122, 0.174, 0.345, 0.501];
    let places: Vec<f64> = (0..12).map(|i| -1.0 + 2.0 * f64::from(i) / 11.0).collect();
    for (theta0, exponent, force) in [(2.0, 0.7, 0.05), (0.2, 0.4, 0.3), (30.0, 0.9, 0.02)] {
        let (foundation, punch) = (
            Foundation::dimensionless(theta0).unwrap().with_exponent(exponent).unwrap(),
            Punch::new(1.0).unwrap(),
        );
        let profile = Profile::from_points(places.clone(), heights.to_vec()).unwrap();
        let load = Load::new(Vertical::Force(force), Rotational::Moment(0.05 * force)).unwrap();
        let problem = Problem::new(foundation, punch.with_profile(profile), load).unwrap();
        let contact = problem.solve().unwrap().audited().unwrap();
        assert_eq!(contact.method().name, shtaerman::MethodName::Panels);
        let check = problem.cross_check(&contact).unwrap();
        println!("{theta0} {exponent}: {:e} {check:?}", contact.relative_error());
        // What the reference is off by at one place may vanish by chance: its largest error counts.
        let known = check.reference_error;
        assert!(known.pressure < 1e-9, "{theta0} {exponent} {check:?}");
        assert!(check.pressure <= known.pressure + 1e-11, "{theta0} {exponent} {check:?}");
        assert!(check.settlement <= known.settlement + 1e-12, "{theta0} {exponent} {check:?}");
        assert!(check.tilt <= known.tilt + 1e-12, "{theta0} {exponent} {check:?}");
        assert!(contact.relative_error() < 1e-9, "{:e}", contact.relative_error());
    }
}

#[test]
fn waves_under_thin_layers_agree() {
    // Edges begin many lengths of the layer away from where they end.
    let waves = "xi^2 + 0.04*sin(9*xi+1) + 0.01*cos(21*xi-0.4) + 0.004*sin(44*xi)";
    for (theta0, load) in
        [(3e3, "force = 2\nmoment = 0.1"), (2.2e4, "settlement = 6000\ntilt = 900")]
    {
        let scale = 0.4 * theta0;
        let profile = format!("profile = \"{scale}*({waves})\"");
        let file = format!("[dimensionless]\ntheta0 = {theta0}\n{profile}\n{load}\n");
        let check = checked(&file);
        assert!(check.agrees, "{theta0}: {check:?}");
    }
}

/// From 0.96 on the reference was off by up to 5e-5 and stated 1e-8: right answers differed from it. At 0.95 it agrees, after some seconds.
#[test]
fn strongly_graded_ground_is_refused_from_where_the_reference_is_not_resolved() {
    let check = |exponent: f64| {
        let toml = format!(
            "[foundation]\npoisson_ratio = 0.3\ngrading_exponent = {exponent}\ngrading_modulus = 1.0\nroughness = 0.5\n[punch]\nhalf_width = 1.0\nprofile = \"0\"\n[load]\nforce = 1.0\ntilt = 0.0\n[solver]\ncontact = \"bilateral\"\n"
        );
        let problem = shtaerman::file::parse(&toml, "test").unwrap();
        problem.cross_check(&problem.solve().unwrap())
    };
    let refused = check(0.97).unwrap_err().to_string();
    assert!(refused.contains("graded by 0.97") && refused.contains("0.95 at most"), "{refused}");
}
