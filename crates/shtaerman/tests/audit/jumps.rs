//! Jumps whose places a formula leaves open by its roundings: whatever side a number lies on, the answer is as exact as elsewhere.

use std::f64::consts::PI;

use shtaerman::ErrorKind;

/// A wave in full contact under terraces of `cos(pi (xi - c))`: at rest the mean of the heights and of the pressure, `delta = P/2 + mean f`, as the kernel of a wave has no mean. Terraces
/// begin where the cosine is `v`, at `acos(v)/pi` from `c`.
#[test]
fn terraces_of_a_wave() {
    let cases = [
        (44.64, 0.96407, [-0.14546, 0.66531], [0.4, 0.0, 0.35178], 7.80584, 0.298494),
        (1.83683, 0.75371, [-0.66475, 0.26567], [0.4, 0.0, 0.53089], 0.542337, 2.65878),
    ];
    for (theta0, centre, [first, second], [low, middle, high], size, force) in cases {
        let toml = format!(
            "[dimensionless]\ntheta0 = {theta0}\ngeometry = \"periodic\"\nperiod = 2\nprofile = \"{size}*(where(cos(pi*(xi-({centre})))<{first}, {low}, where(cos(pi*(xi-({centre})))<{second}, \
             {middle}, {high})))\"\nforce = {force}\nmoment = 0\n[solver]\ncontact = \"bilateral\"\n"
        );
        let contact =
            shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap().audited().unwrap();
        let stated = contact.dimensionless().error().unwrap();
        let [below, above] = [first, second].map(|v: f64| v.acos() / PI);
        let mean = size * (low * (1.0 - below) + middle * (below - above) + high * above);
        let off = (contact.dimensionless().settlement() - (0.5 * force + mean)).abs();
        let largest = contact.dimensionless().peak_pressure();
        println!("{off:e} {stated:?} {largest}");
        assert_eq!(stated.kind, ErrorKind::Bound);
        // The closed form is rounded, too.
        assert!(off <= stated.settlement + 4.0 * f64::EPSILON * mean.abs(), "{off:e} {stated:?}");
        assert!(stated.pressure < 1e-9 * largest, "{stated:?}");
        assert!(
            contact
                .dimensionless()
                .error()
                .and_then(|error| error.peak_pressure)
                .is_none_or(|error| error < 1e-9 * largest)
        );
    }
}

/// A stepped disk under a settlement. The operator is symmetric, so its force is `delta P_1 - h int p_1 dA` over the step, with force and pressure of a flat disk that is pressed in by 1.
#[test]
fn stepped_disks() {
    let (from, height) = (0.86741, 0.20932);
    let solved = |theta0: f64, profile: &str| {
        let toml = format!(
            "[dimensionless]\ntheta0 = {theta0}\ngeometry = \"circular\"\nprofile = \"{profile}\"\nsettlement = 1\ntilt = 0\n[solver]\ncontact = \"bilateral\"\n"
        );
        shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap().audited().unwrap()
    };
    for theta0 in [4.0, 400.0, 4000.0] {
        let flat = solved(theta0, "0");
        let stepped = solved(theta0, &format!("-{height}*step(abs(xi) - {from})"));
        let rule = |count: u32| -> f64 {
            let step = 1.0 / f64::from(count);
            let nodes = (0..count).map(|k| (f64::from(k) + 0.5) * step);
            let values = nodes.map(|s| {
                // `10 s^3 - 15 s^4 + 6 s^5` is flat at both ends: what bends at the rim does so no more.
                let t = s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
                let r = 1.0 - (1.0 - from) * t;
                let rate = 30.0 * (s * (1.0 - s)).powi(2);
                2.0 * PI * r * flat.dimensionless().pressure(r).unwrap() * (1.0 - from) * rate
            });
            step * values.sum::<f64>()
        };
        let on_step = rule(8000);
        let exact = flat.dimensionless().force() + height * on_step;
        let known = (on_step - rule(4000)).abs() + 1e-14 * exact;
        let stated = stepped.dimensionless().error().unwrap();
        let off = (stepped.dimensionless().force() - exact).abs();
        let largest = stepped.dimensionless().peak_pressure();
        println!("{theta0}: {off:e} known to {known:e} {stated:?} {largest}");
        assert!(
            off <= stated.force + flat.dimensionless().error().unwrap().force + known,
            "{off:e}"
        );
        // A jump costs no more than what it raises the pressure by.
        assert!(stated.pressure < 1e-13 * theta0 * largest, "{stated:?}");
    }
}

/// A step under a layer that bends: its peak is thousands of times the pressure elsewhere, on which the audit has to see what the potential needs. The reference shares no code.
#[test]
fn a_step_in_a_bent_layer() {
    let toml = "[dimensionless]\ntheta0 = 6697.6\nexponent = 0.3\nprofile = \"1.2295e+05*xi^2-1.0081e+05*step(xi-0.4865)\"\nsettlement = 1.293e+05\ntilt = -27760\n";
    let problem = shtaerman::file::parse(toml, "test").unwrap();
    let contact = problem.solve().unwrap().audited().unwrap();
    let stated = contact.dimensionless().error().unwrap();
    let largest = contact.dimensionless().peak_pressure();
    let check = problem.cross_check(&contact).unwrap();
    println!("{largest} {stated:?} {check:?}");
    assert!(check.agrees && check.limits.is_none(), "{check:?}");
    let off = check.pressure - check.reference_error.pressure;
    assert!(off <= stated.pressure, "{off:e} {stated:?}");
    assert!(check.reference_error.pressure < 1e-6 * largest, "{check:?}");
    assert!(stated.pressure < 1e-3 * largest, "{stated:?}");
}

/// What is its own mirror image has neither tilt nor moment, and no error of them stands between the answer and its aim; nor does the gauge of the plane, for which the settlement is nearly 0 here.
#[test]
fn mirror_images_reach_their_aim() {
    for (theta0, force) in [(10.0, 3.0), (1000.0, 0.3), (1000.0, 3.0)] {
        let toml = format!(
            "[dimensionless]\ntheta0 = {theta0}\nprofile = \"xi^2\"\nforce = {force}\nmoment = 0\n"
        );
        let contact =
            shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap().audited().unwrap();
        let stated = contact.dimensionless().error().unwrap();
        assert_eq!((stated.moment, stated.tilt, contact.dimensionless().moment()), (0.0, 0.0, 0.0));
        let reached = contact.relative_error();
        assert!(reached <= 1e-12 * (theta0 / 10.0), "{theta0} {force}: {reached:e} {stated:?}");
    }
}
