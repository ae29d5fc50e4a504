//! The largest pressure, wherever the crest lies.

/// A smooth wave with its crest beside the seam of the period has the largest pressure of the same wave moved away from it.
#[test]
fn a_crest_beside_the_seam_is_as_high_as_elsewhere() {
    let solved = |shift: f64| {
        let base = format!(
            "0.1209*cos(pi*(x-{shift}))+0.1637*cos(2*pi*(x-{shift})+2.8758)+0.0249*cos(11*pi*(x-{shift})+0.0914)"
        );
        let toml = format!(
            "[foundation]\nyoung_modulus = 1.0\npoisson_ratio = 0.0\nroughness = 0.0\n[punch]\ngeometry = \"periodic\"\nperiod = 2.0\nprofile = \"{base}\"\n[load]\nforce = 1.85108\nmoment = 0\n"
        );
        shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap()
    };
    let (beside, elsewhere) = (solved(0.0), solved(0.37));
    let [one, other] = [&beside, &elsewhere].map(shtaerman::Contact::peak_pressure);
    let [at, moved] = [&beside, &elsewhere].map(shtaerman::Contact::peak_pressure_at);
    let stated = beside.dimensionless().error().unwrap().pressure
        + elsewhere.dimensionless().error().unwrap().pressure;
    assert!((one - other).abs() <= stated, "{one} {other} {stated:e}");
    let apart = (moved - 0.37 - at).rem_euclid(2.0);
    assert!(apart.min(2.0 - apart) < 1e-5, "{at} {moved}");
    assert!((at.abs() - 1.0).abs() < 2e-3, "{at}");
}

/// Graded ground, `mu = 0.7092`: beside a corner the pressure falls by `d^0.29` within a layer far below the shortest panel. Pressures at both corners by product integration on panels down to `1e-70` of
/// the base, with the distances from its ends kept apart, to 2e-6.
#[test]
fn corners_of_rough_graded_ground_are_within_what_is_stated() {
    let toml = "[foundation]\npoisson_ratio = 0.0\nroughness = 0.0018\ngrading_exponent = 0.7092\ngrading_modulus = 1.0\n[punch]\n\
                profile = \"0.2742*cos(2.9202*pi*x+3.4274)+0.0053*cos(9*pi*x+1.2803)\"\nhalf_width = 1.0\n[load]\nforce = 4.598\nmoment = 0.0\n";
    let contact = shtaerman::file::parse(toml, "test").unwrap().solve().unwrap();
    let stated = contact.dimensionless().error().unwrap().pressure * contact.pressure_right()
        / contact.dimensionless().pressure(1.0).unwrap();
    println!("{} {} {stated}", contact.pressure_left(), contact.pressure_right());
    for (found, exact) in [
        (contact.pressure_left(), 98.361_40),
        (contact.pressure_right(), 98.945_66),
        (contact.peak_pressure(), 98.945_66),
    ] {
        assert!((found - exact).abs() <= stated + 4e-6, "{found} {exact} {stated}");
    }
    assert!(stated < 1.0, "{stated}");
}

/// Beside a corner of graded ground the pressure falls by a power of the distance, so that the largest one is missed where the corner itself is not looked at: a rounding beside it is
/// `1e-16^(1 - mu)` lower.
#[test]
fn the_largest_pressure_is_no_less_than_at_any_corner() {
    let seeds = (0..24_u32).map(|i| {
        let share = |factor: f64| (f64::from(i + 1) * factor).fract();
        (0.05 + 0.6 * share(0.754_877), 0.05 + 0.8 * share(0.569_840), share(0.618_034) - 0.5)
    });
    for (mu, gap, tilt) in seeds {
        let toml = format!(
            "[foundation]\npoisson_ratio = 0.2\nroughness = 0.02\ngrading_exponent = {mu}\ngrading_modulus = 1.0\n[punch]\ngeometry = \"pair\"\n\
             outer_half_width = 1.0\ninner_half_gap = {gap}\nprofile = \"abs(x)\"\n[load]\nforce = 3.0\ntilt = {}\n",
            0.01 * tilt
        );
        let contact = shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap();
        let highest = contact.dimensionless().peak_pressure();
        for corner in [-1.0, -gap, gap, 1.0] {
            let there = contact.dimensionless().pressure(corner).unwrap();
            assert!(there <= highest, "mu = {mu}, gap = {gap}: {there} at {corner}, {highest}");
        }
    }
}
