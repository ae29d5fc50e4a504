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

/// A step in the middle, where numbers are as fine as one likes: the even part of the pressure is that of a flat punch, and right beside the step it is off by half the height.
#[test]
fn a_step_in_the_middle() {
    let solved = |profile: &str, theta0: f64| {
        let toml = format!(
            "[dimensionless]\ntheta0 = {theta0}\nprofile = \"{profile}\"\nforce = 1\ntilt = 0\n[solver]\ncontact = \"bilateral\"\n"
        );
        shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap().audited().unwrap()
    };
    for theta0 in [0.06, 60.0] {
        let flat = solved("0", theta0);
        for (at, profile) in [
            (0.0, "0.03*step(xi)".to_owned()),
            (0.0, "0.015*sign(xi)".to_owned()),
            (9e-5, "0.03*step(xi - 9e-5)".to_owned()),
            (0.0, "0.03*floor(1 + 0.9*xi)".to_owned()),
        ] {
            let stepped = solved(&profile, theta0);
            let [own, of_flat] = [&stepped, &flat].map(|contact| {
                let stated = contact.dimensionless().error().unwrap();
                assert_eq!(stated.kind, ErrorKind::Bound);
                assert!(stated.pressure < 1e-10, "{profile} {theta0}: {stated:?}");
                stated.pressure
            });
            let pressure = |contact: &shtaerman::Contact, xi: f64| {
                contact.dimensionless().pressure(xi).unwrap()
            };
            for d in [1e-300, 1e-19, 1e-17, 1e-10, 1e-3, 0.4] {
                // Nearer to its jump the floor is that of 1 on either side.
                if at + d == at || profile.contains("floor") && d < 1e-15 {
                    continue;
                }
                let [left, right] = [at - d, at + d].map(|xi| pressure(&stepped, xi));
                let level = pressure(&flat, d);
                let off = 0.5 * (left + right) - level;
                assert!(at > 0.0 || off.abs() <= own + of_flat, "{profile} {theta0} {d}: {off:e}");
                // The potential of the jump itself changes by `2 h d (1 - ln d)` at most.
                if d < 1e-9 {
                    let off = left - right - 0.03;
                    let potential = 0.06 * theta0 * d * (1.0 - d.ln());
                    assert!(off.abs() < potential + 2.0 * own, "{profile} {d}: {off:e}");
                }
            }
        }
    }
}

/// Where the base may lift off a zone ends beside the step, and the pressure of the smallest numbers was that of no zone.
#[test]
fn a_step_in_the_middle_of_a_base_that_lifts_off() {
    for profile in ["0.03*step(xi) + 0.1*xi^2", "-0.1*floor(1.4*xi) + 0.1*xi^2"] {
        let toml = format!(
            "[dimensionless]\ntheta0 = 0.3\nprofile = \"{profile}\"\nforce = 0.1\nmoment = 0.002\n"
        );
        let solved = shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap();
        let contact = solved.audited().unwrap().dimensionless();
        let stated = contact.error().unwrap();
        assert_eq!(stated.kind, ErrorKind::Bound, "{profile}");
        assert!(stated.pressure < 1e-11, "{profile}: {stated:?}");
        let [beside, smallest] = [-1e-200, -5e-324].map(|xi| contact.pressure(xi).unwrap());
        let at = contact.pressure(0.0).unwrap();
        assert!(smallest == at || smallest == beside, "{profile}: {smallest} {at} {beside}");
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

const STEP: [f64; 3] = [1.2295e5, 1.0081e5, 0.4865];
const EXPONENT: f64 = 0.3;
const THETA0: f64 = 6697.6;
const LOAD: [f64; 2] = [1.293e5, -27760.0];

/// What the independent solver of `shtaerman-reference` found, which takes minutes: renewed by `RENEW_REFERENCES=1 cargo test -p shtaerman --test all a_step_in_a_bent_layer`.
#[derive(serde::Serialize, serde::Deserialize)]
struct Found {
    origin: String,
    force: [f64; 2],
    moment: [f64; 2],
    /// `xi`, the pressure there, and what is stated of its error.
    pressures: Vec<[f64; 3]>,
}

fn found_by_reference() -> Found {
    use shtaerman_reference::{Break, Kernel, Layer, Problem, Rotational, Vertical};

    let [bend, height, at] = STEP;
    let base = |x: f64| bend * x * x - if x >= at { height } else { 0.0 };
    let posed = Problem {
        kernel: Kernel::Logarithm,
        theta: THETA0,
        layer: Layer::Power { exponent: EXPONENT },
        pieces: &[[-1.0, 1.0]],
        is_bilateral: false,
        vertical: Vertical::Settlement(LOAD[0]),
        rotational: Rotational::Tilt(LOAD[1]),
        base: &base,
        breaks: &[Break { at, is_sharp: true }],
    };
    let found = posed.solve(None).unwrap();
    let even = (0..=96).map(|i| f64::from(i) / 48.0 - 1.0);
    let beside = (1..7).flat_map(|k| [at - 0.1f64.powi(k), at + 0.1f64.powi(k)]);
    let pressures = even.chain(beside).map(|xi| {
        let [pressure, error] = found.pressure(xi);
        [xi, pressure, error]
    });
    Found {
        origin: "shtaerman-reference: product integration on graded panels".into(),
        force: [found.force, found.errors.force],
        moment: [found.moment, found.errors.moment],
        pressures: pressures.collect(),
    }
}

/// A step under a layer that bends: its peak is thousands of times the pressure elsewhere, on which the audit has to see what the potential needs. The reference shares no code.
#[test]
fn a_step_in_a_bent_layer() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/step_in_a_bent_layer.json");
    if std::env::var_os("RENEW_REFERENCES").is_some() {
        let text = serde_json::to_string(&found_by_reference()).unwrap();
        std::fs::write(file, text.replace("],[", "],\n[") + "\n").unwrap();
    }
    let [bend, height, at] = STEP;
    let toml = format!(
        "[dimensionless]\ntheta0 = {THETA0}\nexponent = {EXPONENT}\nprofile = \"{bend}*xi^2-{height}*step(xi-{at})\"\nsettlement = {}\ntilt = {}\n",
        LOAD[0], LOAD[1]
    );
    let problem = shtaerman::file::parse(&toml, "test").unwrap();
    let contact = problem.solve().unwrap().audited().unwrap();
    let answer = contact.dimensionless();
    let (stated, largest) = (answer.error().unwrap(), answer.peak_pressure());
    let reference: Found = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    assert!(reference.pressures.len() > 100);
    for [xi, pressure, error] in &reference.pressures {
        let off = (answer.pressure(*xi).unwrap() - pressure).abs();
        assert!(off <= stated.pressure + error, "{xi}: {off:e} {stated:?} {error:e}");
        assert!(*error < 1e-6 * largest, "{xi}: {error:e}");
    }
    for (found, stated, [known, error]) in [
        (answer.force(), stated.force, reference.force),
        (answer.moment(), stated.moment, reference.moment),
    ] {
        let off = (found - known).abs();
        assert!(off <= stated + error, "{off:e} {stated:e} {error:e}");
    }
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

/// At the crest of `floor(4 abs(cos(..)))` rounding leaves open whether the base is higher there, which it is at a point at most: the audit knows nothing, and says of no base that it penetrates.
#[test]
fn a_jump_that_is_left_open_does_not_penetrate() {
    let solved = |base: &str| {
        let toml = format!(
            "[dimensionless]\ntheta0 = 40\nprofile = \"20*({base} - 0.001*xi^2)\"\nforce = 0.5\nmoment = 0\n"
        );
        shtaerman::file::parse(&toml, "test").unwrap().solve().unwrap()
    };
    let known = solved("min(3, floor(4*abs(cos(10/3*xi))))").audited().unwrap();
    let open = solved("floor(4*abs(cos(10/3*xi)))");
    let off = (open.settlement() - known.settlement()).abs();
    assert!(off <= known.dimensionless().error().unwrap().settlement + 1e-12, "{off:e}");
    let refused = open.audited().unwrap_err();
    assert!(matches!(refused, shtaerman::Error::NotBounded { .. }), "{refused}");
}
