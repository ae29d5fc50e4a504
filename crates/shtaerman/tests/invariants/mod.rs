//! What leaves an answer alone, or changes it in a way that is known, on random contacts of every geometry and ground: the differences stay within what both answers state.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "tests may fail by panicking"
)]

mod draw;

use draw::{Drawn, Geometry, Ground, Turn, Units};
use shtaerman::Contact;

/// Roundings of the numbers of a file and of the formulas in it, in units of what is compared.
const ROUNDING: f64 = 256.0 * f64::EPSILON;

/// Each of the problems of a seed that has an answer, with it; most must have one.
fn each(
    seed: u64,
    count: u64,
    accept: impl Fn(&Drawn) -> bool,
    check: impl Fn(&Drawn, &Contact) -> bool,
) {
    let (mut asked, mut held) = (0, 0);
    for index in 0..count {
        let drawn = Drawn::new(seed, index);
        if !accept(&drawn) {
            continue;
        }
        asked += 1;
        match drawn.solve() {
            Ok(contact) => held += i32::from(check(&drawn, &contact)),
            Err(error) => println!("{index}: {error}"),
        }
    }
    println!("{held} of {asked}");
    assert!(asked > 0 && 10 * held >= 9 * asked, "{held} of {asked}");
}

/// Whether two values agree within an error, where one is stated; what is compared is of this size.
fn assert_alike(name: &str, drawn: &Drawn, [one, other]: [f64; 2], stated: f64, size: f64) {
    let allowed = stated + ROUNDING * size.max(one.abs());
    let error = (one - other).abs();
    assert!(
        error <= allowed,
        "{name}: {one:e} {other:e}, {error:e} > {allowed:e}\n{drawn:#?}\n{}",
        drawn.file(Units::ONE)
    );
}

/// What both answers state together of settlement, tilt and pressure.
fn stated(one: &Contact, other: &Contact) -> [f64; 3] {
    let errors = [one, other].map(|contact| contact.error().expect("errors are stated"));
    let sum = |part: fn(&shtaerman::contact::Errors) -> f64| errors.iter().map(part).sum();
    [sum(|e| e.settlement), sum(|e| e.tilt), sum(|e| e.pressure)]
}

/// The sizes of displacements and of angles: what the layer gives and how high the base is count as well as the settlement.
fn size(contact: &Contact) -> f64 {
    contact.settlement().abs() + contact.tilt().abs() + contact.peak_pressure().min(1.0) + 0.1
}

/// The same contact with settlement and tilt changed by so much.
fn assert_same(drawn: &Drawn, one: &Contact, other: &Contact, [settlement, tilt]: [f64; 2]) {
    let [of_settlement, of_tilt, of_pressure] = stated(one, other);
    let size = size(one) + settlement.abs() + tilt.abs();
    assert_alike(
        "settlement",
        drawn,
        [one.settlement() + settlement, other.settlement()],
        of_settlement,
        size,
    );
    assert_alike("tilt", drawn, [one.tilt() + tilt, other.tilt()], of_tilt, size);
    let peaks = [one, other].map(Contact::peak_pressure);
    if peaks[0].is_finite() {
        assert_alike("peak", drawn, peaks, of_pressure, size);
    }
}

fn has_free_tilt(drawn: &Drawn) -> bool {
    matches!(drawn.turn, Turn::Moment(_)) && !drawn.is_even()
}

#[test]
fn pressures_carry_the_load() {
    each(
        20_261_123,
        80,
        |_| true,
        |drawn, contact| {
            let (mut force, mut moment) = (0.0, 0.0);
            const NODES: usize = 4000;
            for [left, right] in contact.zones() {
                let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
                // x = middle - half cos(t): pressures go to their ends as a root, or as one over it.
                for i in 0..NODES {
                    let t = std::f64::consts::PI * (i as f64 + 0.5) / NODES as f64;
                    let x = middle - half * t.cos();
                    let inside = x.clamp(left, right);
                    // A zone of a wave may reach over its seam.
                    let on_base =
                        if inside.abs() > 1.0 { inside - 2.0 * inside.signum() } else { inside };
                    let pressure = contact.pressure(on_base).unwrap();
                    let ring = if drawn.is_even() { std::f64::consts::PI * x.abs() } else { 1.0 };
                    let part =
                        pressure * ring * half * t.sin() * std::f64::consts::PI / NODES as f64;
                    force += part;
                    moment += x * part;
                }
            }
            // By the rule of the midpoint, under kinks of a smooth base beside a logarithm.
            let size = contact.force();
            assert!((force - size).abs() < 2e-3 * size, "{force} {size}\n{drawn:#?}");
            if !drawn.is_even() && drawn.geometry != Geometry::Wave {
                assert!(
                    (moment - contact.moment()).abs() < 2e-3 * size,
                    "{moment} {}\n{drawn:#?}",
                    contact.moment()
                );
            }
            true
        },
    );
}

#[test]
fn a_mirrored_base_settles_the_same_and_tilts_the_other_way() {
    each(
        31,
        80,
        |drawn| !drawn.is_even(),
        |drawn, contact| {
            let turn = match drawn.turn {
                Turn::Moment(moment) => Turn::Moment(-moment),
                Turn::Tilt(tilt) => Turn::Tilt(-tilt),
            };
            let mirrored =
                Drawn { profile: drawn.profile.replace('u', "(-u)"), turn, ..drawn.clone() };
            let Ok(other) = mirrored.solve() else { return false };
            assert_same(drawn, contact, &other, [0.0, -2.0 * contact.tilt()]);
            true
        },
    );
}

#[test]
fn a_higher_base_settles_by_as_much_and_a_slope_of_it_is_a_tilt() {
    each(
        47,
        80,
        |_| true,
        |drawn, contact| {
            let (constant, slope) =
                (0.031_25, if has_free_tilt(drawn) { 0.007_812_5 } else { 0.0 });
            let profile = format!("{} + {constant} + {slope}*u", drawn.profile);
            let Ok(other) = (Drawn { profile, ..drawn.clone() }).solve() else { return false };
            assert_same(drawn, contact, &other, [constant, -slope]);
            true
        },
    );
}

#[test]
fn units_do_not_matter() {
    let units = Units { length: 25.4e-3, pressure: 6894.757 };
    each(
        53,
        60,
        |_| true,
        |drawn, contact| {
            let Ok(other) = drawn.solve_in(units) else { return false };
            let [of_settlement, of_tilt, of_pressure] = stated(contact, contact);
            let size = size(contact);
            let settlements = [contact.settlement(), other.settlement() / units.length];
            assert_alike("settlement", drawn, settlements, 2.0 * of_settlement, size);
            assert_alike("tilt", drawn, [contact.tilt(), other.tilt()], 2.0 * of_tilt, size);
            let peaks = [contact.peak_pressure(), other.peak_pressure() / units.pressure];
            if peaks[0].is_finite() {
                assert_alike("peak", drawn, peaks, 2.0 * of_pressure, size);
            }
            true
        },
    );
}

#[test]
fn more_force_settles_more_as_the_stiffness_says() {
    each(
        61,
        80,
        |_| true,
        |drawn, contact| {
            let heavier = Drawn { force: drawn.force * 1.01, ..drawn.clone() };
            let Ok(other) = heavier.solve() else { return false };
            // A uniform pressure moves nothing on a smooth wave in full contact.
            if drawn.geometry == Geometry::Wave
                && drawn.roughness == 0.0
                && contact.contact_width() == 2.0
            {
                return true;
            }
            assert!(other.settlement() > contact.settlement(), "{drawn:#?}");
            let stiffness = contact.stiffness();
            let [[k, c], [_, t]] = stiffness.matrix();
            assert!(k > 0.0, "{stiffness:?}\n{drawn:#?}");
            // A wave is infinitely stiff against tilt.
            assert_eq!(t.is_infinite(), drawn.geometry == Geometry::Wave, "{drawn:#?}");
            let is_turned = t > 0.0 && t.is_finite();
            assert!(!is_turned || k * t > c * c, "{stiffness:?}\n{drawn:#?}");
            // With the moment kept the tilt gives way, too.
            let k = if has_free_tilt(drawn) && is_turned { k - c * c / t } else { k };
            let rise = other.settlement() - contact.settlement();
            let secant = (other.force() - contact.force()) / rise;
            assert!((secant / k - 1.0).abs() < 0.05, "{secant} {k}\n{drawn:#?}");
            true
        },
    );
}

fn is_linear(drawn: &Drawn) -> bool {
    drawn.roughness > 0.0 && drawn.exponent == 1.0
}

#[test]
fn bilateral_contacts_add_up() {
    each(71, 60, is_linear, |drawn, _| {
        let with = |profile: &str, share: f64| {
            let turn = match drawn.turn {
                Turn::Moment(moment) => Turn::Moment(share * moment),
                Turn::Tilt(tilt) => Turn::Tilt(share * tilt),
            };
            let profile = profile.to_owned();
            Drawn { profile, turn, force: share * drawn.force, is_bilateral: true, ..drawn.clone() }
        };
        let added = if drawn.geometry == Geometry::Wave { "0.01*cos(pi*u)" } else { "0.01*u^2" };
        let parts = [
            with(&drawn.profile, 0.75),
            with(added, 0.25),
            with(&format!("{} + {added}", drawn.profile), 1.0),
        ];
        let [Ok(one), Ok(two), Ok(both)] = parts.map(|part| part.solve()) else { return false };
        let errors = [&one, &two, &both].map(|contact| contact.error().unwrap());
        let size = size(&both) + size(&one) + size(&two);
        let sum: f64 = errors.iter().map(|e| e.settlement).sum();
        assert_alike(
            "settlement",
            drawn,
            [one.settlement() + two.settlement(), both.settlement()],
            sum,
            size,
        );
        let sum: f64 = errors.iter().map(|e| e.pressure).sum();
        for x in [-0.97, -0.83, 0.85, 1.0] {
            let [p, q, r] = [&one, &two, &both].map(|contact| contact.pressure(x).unwrap());
            assert_alike("pressure", drawn, [p + q, r], sum, size);
        }
        true
    });
}

#[test]
fn what_does_not_pull_is_the_same_bilateral_or_not() {
    each(83, 80, is_linear, |drawn, contact| {
        let bilateral = Drawn { is_bilateral: true, ..drawn.clone() };
        let Ok(other) = bilateral.solve() else { return false };
        if !other.tension().is_empty() {
            return true;
        }
        assert_same(drawn, contact, &other, [0.0, 0.0]);
        true
    });
}

#[test]
fn waves_may_be_seen_from_anywhere() {
    each(
        97,
        300,
        |drawn| drawn.geometry == Geometry::Wave,
        |drawn, contact| {
            for shift in [0.3, 1.1, -0.77] {
                let profile = drawn.profile.replace('u', &format!("(u + {shift})"));
                let Ok(other) = (Drawn { profile, ..drawn.clone() }).solve() else { return false };
                assert_same(drawn, contact, &other, [0.0, 0.0]);
            }
            true
        },
    );
}

#[test]
fn every_geometry_and_ground_is_drawn() {
    let drawn: Vec<Drawn> = (0..300).map(|index| Drawn::new(31, index)).collect();
    let has = |accept: &dyn Fn(&Drawn) -> bool| drawn.iter().any(accept);
    assert!(has(
        &|d| matches!(d.geometry, Geometry::Pair(_)) && matches!(d.ground, Ground::Graded(_))
    ));
    assert!(has(&|d| matches!(d.geometry, Geometry::Row(_)) && d.roughness == 0.0));
    assert!(has(&|d| matches!(d.ground, Ground::Layer(_, true)) && d.is_even()));
    assert!(has(&|d| matches!(d.ground, Ground::Layer(_, false)) && !d.is_even()));
    assert!(has(&|d| matches!(d.ground, Ground::Coating(..)) && d.exponent == 1.0));
    assert!(has(&|d| d.exponent < 1.0));
    assert!(has(&|d| d.geometry == Geometry::Wave && d.roughness > 0.0));
}
