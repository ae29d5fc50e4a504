//! Contacts that searches missed, or refused, or reached by far too many steps.

use shtaerman::{Contact, Error, Geometry, Load, Rotational, Solver, Vertical, file};

use crate::geometries::support::{assert_near, attempt, pressed, solve};

const DISK: Geometry = Geometry::Circular;

#[track_caller]
fn of_file(text: &str) -> Contact {
    file::parse(text, "made.toml").unwrap().solve().unwrap()
}

/// A small contact of a row at a settlement: without a moment it has the tilt that its mirror image has.
#[test]
fn a_row_at_a_settlement_needs_no_moment() {
    for period in [2.1, 3.0, 4.0] {
        let body = (Geometry::Periodic { period }, 1.0, 1.0);
        for settlement in [0.001, 0.03, 0.1] {
            let at =
                |rotational| solve(body, "xi^2", (Vertical::Settlement(settlement), rotational));
            let level = at(Rotational::Tilt(0.0));
            for rotational in [Rotational::Moment(0.0), Rotational::Eccentricity(0.0)] {
                let free = at(rotational);
                let allowed = level.error().unwrap().force + free.error().unwrap().force;
                assert_near(free.force(), level.force(), allowed + 1e-14 * level.force());
                assert!(free.tilt().abs() < 1e-12 * settlement);
            }
        }
        // And another base that which its own force has.
        let (vertical, moment) = (Vertical::Settlement(0.05), Rotational::Moment(0.0));
        let settled = solve(body, "(xi - 0.2)^2", (vertical, moment));
        let forced = solve(body, "(xi - 0.2)^2", pressed(settled.force()));
        assert_near(forced.settlement(), 0.05, 1e-11);
    }
}

/// The force of a disk in full contact depends on its settlement alone, wherever it acts; beyond the limit of full contact that is said.
#[test]
fn a_disk_settles_under_an_eccentric_force() {
    let body = (DISK, 100.0, 1.0);
    let at = |vertical, e| {
        attempt(body, "0.1*x^2", (vertical, Rotational::Eccentricity(e)), Solver::default())
    };
    let force = solve(body, "0.1*x^2", (Vertical::Settlement(1.0), Rotational::Tilt(0.0))).force();
    for e in [0.1, 0.2, 0.28] {
        let settled = at(Vertical::Settlement(1.0), e).unwrap();
        let forced = at(Vertical::Force(force), e).unwrap();
        assert_near(settled.force(), force, 1e-12 * force);
        assert_near(settled.moment(), e * force, 1e-12 * force);
        assert_near(forced.settlement(), 1.0, 1e-11);
        assert_near(settled.tilt(), forced.tilt(), 1e-11);
    }
    let lifted = at(Vertical::Settlement(1.0), 0.3);
    assert!(matches!(lifted, Err(Error::LiftsOff { .. })), "{lifted:?}");
}

/// Rough disks with many waves: settlement, largest pressure and radius by complementarity on 1200 rings of an independent program, to its digits; and what the audit, which knows
/// nothing of the way, makes of them.
#[test]
fn rough_disks_with_waves_are_found_at_every_force() {
    let profile = "30*(x^2 - 0.015385*cos(13*pi*x))";
    let contact = solve((DISK, 30.0, 1.0), profile, pressed(1.3));
    assert_near(contact.settlement(), 50.515_56, 1e-3);
    assert_near(contact.peak_pressure(), 0.9312, 1e-3);
    assert_near(contact.zones()[0][1], 0.942, 1e-3);
    for (waves, share) in [(11, 0.15), (15, 0.25), (19, 0.1), (23, 0.3), (29, 0.2)] {
        let profile = format!("30*(x^2 - {}*cos({waves}*pi*x))", share / f64::from(waves));
        for force in [0.9, 1.1, 1.4] {
            let contact = solve((DISK, 30.0, 1.0), &profile, pressed(force)).audited().unwrap();
            assert!(contact.relative_error() < 1e-6, "{waves} {force}");
        }
    }
}

/// A ring opens where the gap beside the disk closes, be that between the places looked at: the settlement rises with the force through that, and by no more than its stiffness says.
#[test]
fn rings_open_where_gaps_close() {
    for (profile, opening) in [
        ("R^2 - 0.3*cos(12*R)", 3.054_573_094),
        ("0.3*R^2 - 0.3*cos(20*R)", 0.063_646_985),
        ("R - 0.4*max(0, R - 0.074) + 0.3*R^2 - 0.1*cos(20*R)", 2.092_552_036),
    ] {
        // Of steps of ten thousandths of the force, and smaller about the place where it was found to open.
        let text = |force: f64| {
            let own = profile.replace('R', "(r/0.01)");
            format!(
                "[foundation]\nyoung_modulus = 1e9\npoisson_ratio = 0\nroughness = 0\n[punch]\ngeometry = \"circular\"\nradius = 0.01\n\
                 profile = \"1e-5*({own})\"\n[load]\nforce = {force:e}\nmoment = 0\n"
            )
        };
        let shares = [-3e-4, -1e-4, -1e-6, -1e-8, -1e-9, 1e-9, 1e-8, 1e-6, 1e-4, 3e-4];
        let found = shares.map(|share| of_file(&text(opening * (1.0 + share))));
        assert!(found[0].zones().len() < found[9].zones().len());
        for pair in found.windows(2) {
            let [before, after] = [&pair[0], &pair[1]];
            let stated = before.error().unwrap().settlement + after.error().unwrap().settlement;
            let risen = after.settlement() - before.settlement();
            let softest = before.stiffness().force_settlement.recip();
            let most = softest * (after.force() - before.force());
            assert!(
                risen >= -stated && risen <= 1.01 * most + stated,
                "{profile}: {risen:e} of {most:e} with {stated:e}"
            );
        }
    }
}

/// The rounding of a base that is flat but for its edges is that of its steepest place: else integrals are refined to nothing, on ten times as many nodes.
#[test]
fn a_flat_base_with_rounded_edges_takes_few_nodes() {
    for exponent in [0.005, 0.05, 0.2] {
        let contact = of_file(&format!(
            "[foundation]\npoisson_ratio = -0.07\ngrading_exponent = {exponent}\ngrading_modulus = 8.6e11\nroughness = 0\n[punch]\nhalf_width = 4.469e-2\n\
             profile = \"9.876e-4*max(0, abs(xi) - 0.688)^2\"\n[load]\nforce = 1.79e6\nmoment = 0\n"
        ));
        assert!(contact.method().n < 600, "{exponent}: {}", contact.method().n);
    }
}

/// The tilt of an eccentric disk is a difference of pressures, and has their rounding beside the axis.
#[test]
fn an_eccentric_disk_is_audited_beside_its_axis() {
    let load = (Vertical::Force(7e-2), Rotational::Eccentricity(0.1));
    let contact = solve((DISK, 1e-3, 1.0), "2.4e-3*abs(x)^1.9", load).audited().unwrap();
    assert!(contact.relative_error() < 1e-12);
}

/// A settlement at an eccentricity is that of the force which leads to it, on a layer, where the smallest forces leave no digits of the heights.
#[test]
fn a_settlement_at_an_eccentricity_is_reached_through_small_forces() {
    let problem = file::parse(
        "[foundation]\npoisson_ratio = 0.3\nyoung_modulus = 4.7e9\nroughness = 4.2e-9\nthickness = 0.5\nbase = \"frictionless\"\n[punch]\nhalf_width = 0.48\n\
         profile = \"3e-4*abs(xi - 0.08)\"\n[load]\nsettlement = 3.8e-3\neccentricity = -0.08\n",
        "made.toml",
    )
    .unwrap();
    let settled = problem.solve().unwrap();
    let load =
        Load::new(Vertical::Force(settled.force()), Rotational::Eccentricity(-0.08)).unwrap();
    let forced = problem.with_load(load).unwrap().solve().unwrap();
    assert_near(forced.settlement(), 3.8e-3, 1e-14);
    assert_near(forced.tilt(), settled.tilt(), 1e-14);
}

/// Where no force leads to a settlement at an eccentricity that is said of a smooth base, too, whose zones are looked for at once.
#[test]
fn a_smooth_base_at_an_eccentricity_says_what_is_out_of_reach() {
    let of = |load: &str| {
        let text = format!(
            "[foundation]\nyoung_modulus = 1e9\npoisson_ratio = 0.3\nroughness = 0\n[punch]\nhalf_width = 0.01\nprofile = \"1e-5*(0.7*abs(xi - 0.2))\"\n[load]\n{load}\n"
        );
        file::parse(&text, "made.toml").unwrap().solve()
    };
    for (eccentricity, settlements) in
        [(0.006, &[2e-6, 2e-5][..]), (-0.005, &[2e-6, 2e-5]), (0.0085, &[2e-5])]
    {
        // The settlements of all forces, from first touch on.
        let settled = |force: f64| {
            of(&format!("force = {force:e}\neccentricity = {eccentricity:e}")).unwrap().settlement()
        };
        let forces = (0..17).map(|k| 10.0 * 2f64.powi(k));
        let all: Vec<f64> = forces.map(settled).collect();
        let deepest = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        for &settlement in settlements {
            match of(&format!("settlement = {settlement:e}\neccentricity = {eccentricity:e}")) {
                Ok(contact) => {
                    assert_near(settled(contact.force()), settlement, 1e-11 * settlement);
                }
                Err(error) => {
                    assert!(matches!(error, Error::SettlementOutOfReach { .. }), "{error:?}");
                    assert!(settlement > deepest, "{settlement} {deepest}");
                }
            }
        }
    }
}

/// A settlement that leaves the level base clear, and a moment that turns it into contact: on a layer that bends as on a linear one.
#[test]
fn a_moment_turns_a_base_that_is_clear_into_contact() {
    let law = |exponent: f64| {
        let text = format!(
            "[foundation]\nyoung_modulus = 1e9\npoisson_ratio = 0\nroughness = {{ displacement = 1e-6, pressure = 1e6, exponent = {exponent} }}\n[punch]\nhalf_width = 0.01\nprofile = \"0.1*x^2\"\n[load]\n"
        );
        move |load: String| of_file(&format!("{text}{load}\nmoment = 5\n"))
    };
    for exponent in [0.4, 0.9] {
        let under = law(exponent);
        let forced = under("force = 1000".into());
        assert!(forced.settlement() < 0.0, "clear without the moment");
        let settled = under(format!("settlement = {:?}", forced.settlement()));
        assert_near(settled.force(), 1000.0, 1e-6);
        assert_near(settled.tilt(), forced.tilt(), 1e-10 * forced.tilt().abs());
    }
}

/// The audit of a disk tells next to nothing beside corners as sharp as these; the answer stands without it.
#[test]
fn a_disk_on_strongly_graded_ground_stands_without_an_audit() {
    let of_exponent = |exponent: f64| {
        let text = format!(
            "[foundation]\ngrading_exponent = {exponent}\ngrading_modulus = 1e9\npoisson_ratio = 0\nroughness = 6.3662e-12\n[punch]\ngeometry = \"circular\"\nradius = 1\nprofile = \"0\"\n[load]\nforce = 1e7\nmoment = 0\n"
        );
        of_file(&text)
    };
    let sharp = of_exponent(0.8).audited().unwrap();
    let reason = sharp.audited_by().unwrap().as_ref().unwrap_err().to_string();
    assert!(reason.contains("no hundredth"), "{reason}");
    // A series of Zernike's polynomials: 16.7984 mm.
    assert_near(sharp.settlement(), 16.7984e-3, 5e-8);
    assert!(of_exponent(0.4).audited().unwrap().audited_by().unwrap().is_ok());
}

/// Nor of a layer that bends. The pressure at the right corner over `P/a` is that of another program, whose panels close in on it to `1e-26` of the half-width: 124.3298.
#[test]
fn a_layer_that_bends_on_strongly_graded_ground_stands_without_an_audit() {
    let text = "[foundation]\ngrading_exponent = 0.682\ngrading_modulus = 1.78e8\npoisson_ratio = 0.214\nroughness = { coefficient = 2.0909e-10, exponent = 0.357 }\n[punch]\nhalf_width = 0.001364\nprofile = \"0\"\n[load]\nforce = 0.604\neccentricity = 0.000379192\n";
    let contact = of_file(text).audited().unwrap();
    let reason = contact.audited_by().unwrap().as_ref().unwrap_err().to_string();
    assert!(reason.contains("no hundredth"), "{reason}");
    assert_near(contact.pressure_right() * 0.001364 / 0.604, 124.3298, 2e-4);
}

/// A search without a limit of time ends by its work, at the same step on every machine; a limit of its own takes the place of that.
#[test]
fn a_long_search_ends_by_its_work() {
    let text = "[foundation]\nyoung_modulus = 1e9\npoisson_ratio = 0\nroughness = 0\n[punch]\ngeometry = \"periodic\"\nperiod = 2.23\nhalf_width = 1\nprofile = \"1e-3*abs(x)\"\n[load]\nsettlement = 3e-3\neccentricity = -0.6\n";
    let long = file::parse(text, "made.toml").unwrap();
    assert!(matches!(long.solve().unwrap_err(), Error::WorkLimit { .. }));
    let limit = std::time::Duration::from_millis(50);
    let limited = long.with_solver(Solver::default().with_time_limit(limit).unwrap());
    assert_eq!(limited.solve().unwrap_err(), Error::TimeLimit { limit });
}

/// A pressure that leaves the range of double precision, and that no error refuses where a degree is asked for. Found by random input.
#[test]
fn a_pressure_beyond_all_numbers_is_refused() {
    let text = "[foundation]\npoisson_ratio = -0.12\ngrading_exponent = 0.070\ngrading_modulus = 2.6195168798832382e11\nroughness = 0\n[punch]\ngeometry = \"circular\"\nradius = 3.3103547868948926e-6\nprofile = \"5.1578649551276344e-9*(((asin(rho))-(2)) * (asinh((rho) * (rho))))\"\n[load]\nforce = 2.5766342896218552e-2\ntilt = -1.473351448591908e-4\n[solver]\ncontact = \"bilateral\"\n";
    // With a degree no accuracy is asked for.
    let problem = file::parse(text, "made.toml").unwrap();
    let error = problem.with_solver(Solver::spectral(149).unwrap()).solve().unwrap_err();
    assert!(matches!(error, Error::Overflow { .. }), "{error}");
}

/// A load near the end of the range: intensities beyond it are no numbers of an answer. Found by random input.
#[test]
fn a_corner_intensity_beyond_all_numbers_is_refused() {
    let text = |moment: f64| {
        format!(
            "[foundation]\nyoung_modulus = 1e7\npoisson_ratio = 0\nroughness = 0\n[punch]\ngeometry = \"circular\"\nradius = 1e-5\nprofile = \"1e-6*rho^2\"\n[load]\nforce = 1e-4\nmoment = {moment:e}\n[solver]\ncontact = \"bilateral\"\n"
        )
    };
    let error = file::parse(&text(1e300), "made.toml").unwrap().solve().unwrap_err();
    assert!(matches!(error, Error::Overflow { .. }), "{error}");
    assert!(of_file(&text(1e280)).corner_intensity().unwrap()[0][1].is_finite());
}

/// A contact that ends hardly beyond a bend, where slopes have few digits; by the inverse of Abel's equation with `w^2 = x^2 - k^2` (mpmath, 30 digits):
/// `G = 2 h x (w - k acos(k/x))`, settlement `G(c)`, force `2 E* (c G(c) - int_k^c G dx)`, pressure in the middle `(E*/pi) int_k^c G' dx/x`.
#[test]
fn a_contact_that_ends_hardly_beyond_a_bend_is_as_good_as_stated() {
    for (beyond, force, settlement, middle) in [
        (1e-4, 2.960_988_742_382_85e-3, 1.739_588_712_789_535e-12, 6.506_336_629_830_443e-4),
        (1e-8, 2.960_588_692_586_657e-9, 1.739_476_305_354_255e-18, 6.506_374_863_371_195e-10),
    ] {
        let text = format!(
            "[foundation]\nyoung_modulus = 1e9\npoisson_ratio = 0\nroughness = 0\n[punch]\ngeometry = \"circular\"\nradius = 1\nprofile = \"1e-6*max(0, rho - 0.851)^2\"\n[load]\nforce = {force:e}\nmoment = 0\n"
        );
        let contact = of_file(&text);
        let stated = contact.error().unwrap();
        assert_near(contact.settlement(), settlement, stated.settlement);
        assert_near(contact.pressure_middle(), middle, stated.pressure);
        assert!(stated.pressure < 1e-6 * middle, "{beyond}: {:e}", stated.pressure);
        assert_near(contact.zones()[0][1], 0.851 + beyond, 1e-14);
    }
}

/// Kinks of a flat top off the middle lie between two numbers, where its height is the rounding of a place: that is no step. The contact is its own mirror image about the flat top.
#[test]
fn a_flat_top_off_the_middle_has_no_steps() {
    for (middle, half) in [(0.1, 0.1), (0.05, 0.05), (0.22, 0.08), (0.31, 0.08), (0.06, 0.01)] {
        for ground in ["young_modulus = 1e9", "grading_exponent = 0.3\ngrading_modulus = 1e9"] {
            let text = format!(
                "[foundation]\n{ground}\npoisson_ratio = 0\nroughness = 0\n[punch]\nhalf_width = 1\nprofile = \"1e-4*max(0, abs(xi - {middle}) - {half})\"\n[load]\nforce = 27605.2\neccentricity = {middle}\n"
            );
            let contact = of_file(&text);
            let stated = contact.error().unwrap();
            assert_eq!(contact.zones().len(), 1, "{middle} {half}");
            let [left, right] = contact.zones()[0];
            assert_near(0.5 * (left + right), middle, stated.zones.unwrap());
            assert_near(contact.tilt(), 0.0, stated.tilt);
        }
    }
}

/// A flat-topped paraboloid (mpmath, 30 digits): panels of Abel's transform begin with the bend, however small the flat is.
#[test]
fn a_small_flat_is_seen_in_the_pressure() {
    for (flat, force, at, exact) in [
        (1e-6, 8_532.693_331_000_205, 5e-7, 40_420.487_536_966_96),
        (1e-5, 8_532.693_331_000_205, 5e-6, 40_410.750_653_678_26),
    ] {
        let text = format!(
            "[foundation]\nyoung_modulus = 1e9\npoisson_ratio = 0\nroughness = 0\n[punch]\ngeometry = \"circular\"\nradius = 1\nprofile = \"1e-4*max(0, rho - {flat})^2\"\n[load]\nforce = {force}\nmoment = 0\n"
        );
        let contact = of_file(&text);
        let stated = contact.error().unwrap().pressure;
        assert!(stated < 1e-11 * exact, "{stated:e}");
        assert_near(contact.pressure(at).unwrap(), exact, stated + 1e-14 * exact);
    }
}

/// An end that is hardly known moves the force and the moment by its square (reciprocity with flat punches, mpmath, 30 digits).
#[test]
fn an_end_hardly_beyond_a_bend_is_felt_in_the_moment() {
    let text = "[foundation]\ngrading_exponent = 0.05\ngrading_modulus = 1e9\npoisson_ratio = 0\nroughness = 0\n[punch]\nhalf_width = 1\nprofile = \"0.5812*0.0001*max(0, xi - 0.0129)^1.2\"\n[load]\nsettlement = 3.42815997320634e-07\ntilt = -5.7814497992693174e-08\n";
    let contact = of_file(text);
    let stated = contact.error().unwrap();
    assert_near(contact.moment(), -3.080_271_896_727_752_3, stated.moment);
    // A few hundred times what it is off by, and no more.
    assert!(stated.moment < 1e-2, "{:e}", stated.moment);
}
