//! One set of quantities with units and one without: the same names, and scales between them.

use shtaerman::{Datum, Elastic, Error, Foundation, Load, Problem, Profile, Punch, SurfaceCurve};

fn problem() -> Problem {
    let steel = Foundation::new(Elastic::new(200e9, 0.3).unwrap()).with_roughness(1.2e-14).unwrap();
    let profile = Profile::expression("x^2/(2*0.8) + 1e-4*x").unwrap();
    let punch = Punch::new(5e-3).unwrap().with_profile(profile);
    Problem::new(steel, punch, Load::force(0.4e6).unwrap().with_moment(50.0).unwrap()).unwrap()
}

#[test]
fn quantities_differ_by_their_scales() {
    let contact = problem().solve().unwrap().audited().unwrap();
    let bare = contact.dimensionless();
    let scaling = *contact.problem().scaling().unwrap();
    let [one, other] = [&contact, &bare].map(|contact| contact.error().unwrap());
    let data = [Datum::Distance(8e-3), Datum::Distance(1.6)];
    let [near, near0] = [(&contact, data[0]), (&bare, data[1])]
        .map(|(contact, datum)| contact.relative_settlement(datum).unwrap().settlement);
    let (length, pressure) = (scaling.half_width(), scaling.pressure());
    let depth = scaling.displacement();
    for (what, with, without, unit) in [
        ("settlement", contact.settlement(), bare.settlement(), depth),
        ("tilt", contact.tilt(), bare.tilt(), scaling.angle()),
        ("force", contact.force(), bare.force(), scaling.force()),
        ("moment", contact.moment(), bare.moment(), scaling.moment()),
        ("mean", contact.mean_pressure(), bare.mean_pressure(), pressure),
        ("peak", contact.peak_pressure(), bare.peak_pressure(), pressure),
        ("peak at", contact.peak_pressure_at(), bare.peak_pressure_at(), length),
        ("middle", contact.pressure_middle(), bare.pressure_middle(), pressure),
        ("pressure", contact.pressure(1e-3).unwrap(), bare.pressure(0.2).unwrap(), pressure),
        (
            "pressures",
            contact.pressures(&[1e-3]).unwrap()[0],
            bare.pressures(&[0.2]).unwrap()[0],
            pressure,
        ),
        ("gap", contact.gap(-5e-3).unwrap(), bare.gap(-1.0).unwrap(), depth),
        ("depth", contact.base_depth(1e-3), bare.base_depth(0.2), depth),
        ("surface", contact.elastic_displacement(9e-3), bare.elastic_displacement(1.8), depth),
        ("width", contact.contact_width(), bare.contact_width(), length),
        ("zone", contact.zones()[0][0], bare.zones()[0][0], length),
        ("error of pressure", one.pressure, other.pressure, pressure),
        ("error of settlement", one.settlement, other.settlement, depth),
        ("error of zones", one.zones.unwrap(), other.zones.unwrap(), length),
        ("relative settlement", near, near0, depth),
    ] {
        assert!((with / (without * unit) - 1.0).abs() < 1e-12, "{what}: {with} {without}");
    }
    let curve = SurfaceCurve::new(&bare, 7).unwrap();
    assert_eq!((curve.x[0], curve.x[6]), (-3.0, 3.0));
    assert_eq!(contact.problem(), bare.problem());
    assert_eq!((one.force, one.moment), (0.0, 0.0));
}

#[test]
fn what_belongs_to_the_problem_stays_as_it_is_stated() {
    let contact = problem().solve().unwrap();
    let bare = contact.dimensionless();
    assert_eq!(contact.sensitivities().unwrap(), bare.sensitivities().unwrap());
    let beyond = |contact: &shtaerman::Contact, x| contact.pressure(x).unwrap_err();
    assert!(matches!(
        beyond(&contact, 6e-3),
        Error::BeyondPunch { variable: "x", right: 5e-3, .. }
    ));
    assert!(matches!(beyond(&bare, 1.1), Error::BeyondPunch { variable: "xi", right: 1.0, .. }));
    // What is prescribed comes back as given, and without dimensions as it was found.
    assert_eq!((contact.force(), contact.moment()), (0.4e6, 50.0));
    let found = bare.force() * contact.problem().scaling().unwrap().force();
    assert!((found / 0.4e6 - 1.0).abs() < 1e-14);
}
