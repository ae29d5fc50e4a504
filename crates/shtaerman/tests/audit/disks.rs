//! Audits of circular punches whose pressure leans by little beside what carries. With both signs of the pressure contacts are linear, so that moment and tilt follow from those of a flat punch that turns by 1e-3.

use shtaerman::{
    Contact, ContactKind, Foundation, Geometry, Load, Problem, Profile, Punch, Rotational, Solver,
    Vertical,
};

/// A bilateral contact of a disk of radius 1, audited.
fn audited(theta0: f64, profile: Profile, rotational: Rotational) -> Contact {
    let punch = Punch::in_geometry(Geometry::Circular, 1.0).unwrap().with_profile(profile);
    let load = Load::new(Vertical::Force(0.0147), rotational).unwrap();
    let foundation = Foundation::dimensionless(theta0).unwrap();
    let solver = Solver::default().with_contact(ContactKind::Bilateral);
    let problem = Problem::new(foundation, punch, load).unwrap().with_solver(solver);
    let contact = problem.solve().unwrap().audited().unwrap();
    assert!(contact.audited_by().is_some_and(Result::is_ok));
    contact
}

const DISK: &str = "geometry = \"circular\"\nradius = 1.0";
const PLANE: &str = "half_width = 1.0";

/// A punch kept in contact by a force of 1 with rough ground graded by this exponent, with that roughness.
fn held([exponent, roughness]: [f64; 2], punch: &str, profile: &str) -> Contact {
    let toml = format!(
        "[foundation]\npoisson_ratio = 0.3\ngrading_exponent = {exponent}\ngrading_modulus = 1.0\nroughness = {roughness}\n[punch]\n{punch}\nprofile = \"{profile}\"\n[load]\nforce = 1.0\ntilt = 0.0\n[solver]\ncontact = \"bilateral\"\n"
    );
    shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap()
}

/// Moment over tilt of a flat punch.
fn stiffness(theta0: f64) -> f64 {
    let turned = audited(theta0, Profile::flat(), Rotational::Tilt(1e-3));
    turned.moment() / 1e-3
}

fn panels(contact: &Contact) -> usize {
    contact.audited_by().unwrap().as_ref().unwrap().panels
}

/// What leans by 3e-16 is rounding of the rest: 16,513 panels followed it, for seven seconds.
#[test]
fn what_is_lost_in_rounding_is_not_followed() {
    let theta0 = 0.0485;
    let tilt = 3.040675521255873e-16;
    let contact = audited(theta0, Profile::flat(), Rotational::Tilt(tilt));
    assert!(panels(&contact) < 200, "{}", panels(&contact));
    let off = (contact.moment() - tilt * stiffness(theta0)).abs();
    let stated = contact.dimensionless().error().unwrap().moment;
    assert!(off <= stated && stated < 1e-14, "off by {off:e}, {stated:e} stated");
}

/// The moment was said not to be met, as the lean that was found differs from it by as much as it is.
#[test]
fn a_moment_next_to_nothing_is_met() {
    let theta0 = 3.0;
    let profile = Profile::expression("0.01*x^4").unwrap();
    let contact = audited(theta0, profile, Rotational::Moment(1e-18));
    let off = (contact.tilt() - 1e-18 / stiffness(theta0)).abs();
    let stated = contact.dimensionless().error().unwrap().tilt;
    assert!(off <= stated && stated < 1e-13, "off by {off:e}, {stated:e} stated");
}

/// A trace bends at every point, and an audit may look as much longer.
#[test]
fn traces_keep_their_audit() {
    let theta0 = 30.0;
    let places: Vec<f64> = (-700..=700).map(|i| f64::from(i) / 700.0).collect();
    let height = |x: &f64| 1e-4 * ((40.0 * x * x).cos() + (217.0 * x.abs()).sin());
    let profile = Profile::from_points(places.clone(), places.iter().map(height).collect());
    let contact = audited(theta0, profile.unwrap(), Rotational::Tilt(1e-4));
    assert!(panels(&contact) > 700, "{}", panels(&contact));
    let (moment, expected) = (contact.moment(), 1e-4 * stiffness(theta0));
    let stated = contact.dimensionless().error().unwrap().moment + 1e-12 * expected;
    assert!((moment - expected).abs() <= stated, "{moment} {expected} {stated:e}");
}

/// What turns alone has no part without angle to choose its resolution by: 2.6e-4 of the pressure was missed at the edge where the exponent is 0.9, and nothing stated.
#[test]
fn what_turns_alone_has_a_resolution_of_its_own() {
    for (exponent, roughness) in [(0.5, 0.03), (0.8, 0.02), (0.9, 0.009_297_812_848_692_306)] {
        let alone = |tolerance: f64| {
            let toml = format!(
                "[foundation]\npoisson_ratio = 0.3\ngrading_exponent = {exponent}\ngrading_modulus = 1.0\nroughness = {roughness}\n[punch]\ngeometry = \"circular\"\nradius = 1.0\nprofile = \"0\"\n[load]\nforce = 0.0\ntilt = 1e-3\n[solver]\ncontact = \"bilateral\"\ntolerance = {tolerance:e}\n"
            );
            shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap()
        };
        let (loose, tight) = (alone(1e-2), alone(1e-11));
        let [rough, fine] = [&loose, &tight].map(|contact| contact.error().unwrap().pressure);
        assert!(0.0 < fine && fine < 1e-11 * tight.peak_pressure(), "{exponent}: {fine:e}");
        for r in [1.0, 0.999, 0.7, 1e-3, -1.0] {
            let [one, other] = [&loose, &tight].map(|contact| contact.pressure(r).unwrap());
            let off = (one - other).abs();
            assert!(off <= rough + fine, "{exponent}, {r}: off by {off:e}, {rough:e} stated");
        }
        if exponent == 0.9 {
            // By product integration on panels down to 1e-102 of the radius, beside its edge: that many for a tilt of one.
            let truth = -0.035_645_607_775_796_17 * tight.dimensionless().tilt();
            let off = (tight.pressure(1.0).unwrap() - truth).abs();
            assert!(off <= fine + 1e-12 * truth.abs(), "off by {off:e}, {fine:e} stated");
        }
    }
}

#[test]
fn pressures_on_the_axis_of_strongly_graded_ground() {
    for exponent in [0.85, 0.89, 0.93, 0.95, 0.97, 0.98] {
        let contact = held([exponent, 0.1], DISK, "0");
        let stated = contact.error().unwrap().pressure;
        let axis = contact.pressure(0.0).unwrap();
        for r in [1e-40, 1e-34, 1e-21, 1e-16, 1e-13, 1e-6] {
            // It grows by 0.01 r^2.
            let off = (axis - contact.pressure(r).unwrap()).abs();
            assert!(off <= stated + 1e-14, "{exponent}, {r}: off by {off:e}, {stated:e} stated");
        }
        if exponent == 0.95 {
            // By product integration, to 1.1e-12.
            let off = (axis - 0.310_406_681_769_685).abs();
            assert!(off <= stated + 1.1e-12, "off by {off:e}, {stated:e} stated");
            assert!(stated < 1e-7, "{stated:e}");
        }
    }
}

/// Pressures at rims, at corners of a plane punch, on the axis and beside a tip, of ground on which the kernel is nearly as singular as `1/d`; truths by product integration on panels in the logarithm
/// of the distance, down to where nothing is left, with a kernel of its own (Weber and Schafheitlin's closed form).
#[test]
fn strongly_graded_ground_at_rims_on_the_axis_and_beside_tips() {
    let (disk, plane) = ("circular\"\nradius = 1.0", "plane\"\nhalf_width = 1.0");
    let free = "force = 0.001686666225691601\ntilt = 0.0\n[solver]\ncontact = \"unilateral\"";
    let held = "force = 1.0\ntilt = 0.0\n[solver]\ncontact = \"bilateral\"";
    let cases = [
        (disk, [0.98, 0.3, 0.5], "0", held, 1.0, 2.757_180_438_22, 1e-11),
        (disk, [0.98, 0.3, 20.0], "0", held, 1.0, 0.537_443_583_043, 1e-12),
        (plane, [0.96, 0.3, 0.5], "0", held, 1.0, 3.101_179_418_132, 1e-12),
        (plane, [0.97, 0.3, 5.0], "0", held, 1.0, 1.223_192_952_159, 1e-12),
        (
            disk,
            [0.98, 0.1, 42.357_376_257_092_184],
            "rho^4",
            free,
            0.0,
            0.001_922_448_966_74,
            1e-14,
        ),
        (disk, [0.9, 0.3, 0.01], "0.1*rho^0.5", held, 1e-15, 0.315_492_291_268_43, 2e-14),
        (disk, [0.9, 0.3, 0.01], "0.1*rho^0.5", held, 0.1, 0.309_521_629_701_347, 4e-15),
    ];
    for (punch, [exponent, nu, roughness], profile, load, place, truth, known) in cases {
        let toml = format!(
            "[foundation]\npoisson_ratio = {nu}\ngrading_exponent = {exponent}\ngrading_modulus = 1.0\nroughness = {roughness}\n[punch]\ngeometry = \"{punch}\nprofile = \"{profile}\"\n[load]\n{load}\n"
        );
        let contact = shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap();
        let stated = contact.error().unwrap().pressure;
        let off = (contact.pressure(place).unwrap() - truth).abs();
        assert!(off <= stated + known, "{exponent} {profile}: off by {off:e}, {stated:e} stated");
        assert!(stated < 3e-7 * truth, "{exponent} {profile}: {stated:e} stated");
    }
}

/// Beside a kink the pressure goes on as its slope: under `c |x|` by `c/chi` for each unit, until the body answers, as `x^(2-mu)`.
#[test]
fn pressures_beside_a_kink_of_strongly_graded_ground_go_on_as_its_slope() {
    for (exponent, roughness) in [(0.8, 0.1), (0.85, 0.5), (0.85, 2.0), (0.85, 10.0)] {
        let contact = held([exponent, roughness], PLANE, "0.1*abs(x)");
        let stated = contact.error().unwrap().pressure;
        let kink = contact.pressure(0.0).unwrap();
        for x in [1e-30f64, -1e-26, 1e-21, 1e-18, -1e-16] {
            let off = (contact.pressure(x).unwrap() - kink + 0.1 / roughness * x.abs()).abs();
            assert!(
                off <= stated,
                "{exponent} {roughness}, {x}: off by {off:e}, {stated:e} stated"
            );
        }
    }
}

/// Where one side of a kink is steeper than the other the pressure has a slope on both; differences from the pressure at the kink by product integration on panels in the logarithm of the distance, known to what is given last.
#[test]
fn the_flat_side_of_a_kink_has_the_slope_that_the_body_gives_it() {
    let cases = [
        ([0.8, 0.03, 1e-6], -3.162_277_660_168_379e-14, -3.659_92e-8, 5e-13),
        ([0.7, 0.03, 1e-4], -3.162_277_660_168_379e-13, -4.588_04e-9, 5e-14),
        ([0.9, 3.0, 1e-8], -1e-15, -3.951_04e-10, 5e-15),
        ([0.7, 0.03, 1e-2], -3.162_277_660_168_379e-13, -5.0132e-11, 5e-15),
        ([0.8, 0.3, 1e-8], -3.162_277_660_168_379e-14, -1.421_53e-7, 5e-12),
    ];
    for ([exponent, roughness, width], place, truth, known) in cases {
        let contact =
            held([exponent, roughness], PLANE, &format!("0.1*min(1, max(0, x)/{width:e})"));
        let stated = contact.error().unwrap().pressure;
        let rise = contact.pressure(place).unwrap() - contact.pressure(0.0).unwrap();
        let off = (rise - truth).abs();
        assert!(off <= stated + known, "{exponent} {width}: off by {off:e}, {stated:e} stated");
        // Beside a ramp of 1e-8 nodes are at their most, and the last difference is stated.
        let most = if exponent > 0.85 { 1e-10 } else { 1e-11 };
        assert!(stated < most, "{exponent} {width}: {stated:e} stated");
    }
}

/// The inner edge of a ring is no centre: a pad with a recess, beside the recess, by product integration as above; places there are known to a rounding of theirs.
#[test]
fn inner_edges_of_pads_on_graded_ground_are_edges() {
    for (exponent, beside, truth) in [
        (0.5, 1e-11, 0.747_324_021_417),
        (0.6, 1e-12, 0.864_741_000_134),
        (0.7, 1e-13, 1.039_234_927_7),
    ] {
        let toml = format!(
            "[foundation]\npoisson_ratio = 0.3\ngrading_exponent = {exponent}\ngrading_modulus = 1.0\nroughness = 0.3\n[punch]\ngeometry = \"circular\"\nradius = 1.0\nprofile = \"step(0.5 - rho)\"\n[load]\nforce = 1.0\ntilt = 0.0\n"
        );
        let contact = shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap();
        let stated = contact.error().unwrap().pressure;
        let off = (contact.pressure(0.5 + beside).unwrap() - truth).abs();
        assert!(off <= stated + 1e-12, "{exponent}: off by {off:e}, {stated:e} stated");
        assert!(stated < 1e-9, "{exponent}: {stated:e} stated");
    }
}

/// Under weak roughness the nodes about the axis tell least; the pressure is even and flat there.
#[test]
fn pressures_about_the_axis_of_graded_ground_under_rough_disks_are_as_good_as_stated() {
    for (exponent, roughness) in [(0.7, 1000.0), (0.75, 300.0), (0.85, 1e4), (0.85, 1e5)] {
        let contact = held([exponent, roughness], DISK, "0");
        let stated = contact.error().unwrap().pressure;
        let beyond = contact.pressure(1e-9).unwrap();
        for r in [1e-30, 1e-16, 1e-14, 3e-14, 1e-13, 3e-13, 1e-12, 1e-11] {
            let off = (contact.pressure(r).unwrap() - beyond).abs();
            assert!(
                off <= 2.0 * stated,
                "{exponent} {roughness}: off by {off:e}, {stated:e} stated"
            );
        }
    }
}

/// Under a bend or a step hardly off the axis the pressure changes on the way to it, and no place counts as the centre that is not much nearer; by product integration as above.
#[test]
fn a_bend_hardly_off_the_axis_of_graded_ground_is_seen_from_there() {
    for (profile, place, truth) in [
        ("0.1*min(1, max(0, rho - 1e-12)/1e-12)", 3.2e-13, 0.367_467_993_973_661),
        ("0.02*step(rho - 1e-8)", 3.2e-10, 0.287_467_898_113_064),
    ] {
        let contact = held([0.3, 1.0], DISK, profile);
        let off = (contact.pressure(place).unwrap() - truth).abs();
        // Some times what the method states, 1e-13; it was off by a hundred times as much where all up to half the bend counted as the centre.
        assert!(off < 1e-12, "{profile}: off by {off:e}");
    }
}
