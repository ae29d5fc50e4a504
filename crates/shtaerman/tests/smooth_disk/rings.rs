//! Annuli, and disks with rings about them.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::smooth_disk::support::{
    A, MODULUS, attempt, close, honest, pressed, problem, solve, solve_bilateral, sunk,
};
use shtaerman::{Contact, Profile, Solver};

/// Distance from a corner, as share of the zone, below which the pressure is its singularity.
const SINGULAR: f64 = 1e-7;

/// `int_l^r f(s, s - l, r - s) ds` with singular ends, by the double-exponential rule.
fn integral(left: f64, right: f64, f: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let step = 1.0 / 32.0;
    (-128..=128)
        .map(|i| {
            let t = step * f64::from(i);
            let s = FRAC_PI_2 * t.sinh();
            let share = |s: f64| s.exp() / (2.0 * s.cosh());
            let [from, to] = [share(s), share(-s)].map(|share| share * (right - left));
            let at = if from < to { left + from } else { right - to };
            let weight = 0.5 * FRAC_PI_2 * t.cosh() / s.cosh().powi(2) * (right - left) * step;
            if weight < 1e-300 { 0.0 } else { weight * f(at, from, to) }
        })
        .sum()
}

/// `K(2 sqrt(r s)/(r + s))/(r + s)` by the arithmetic-geometric mean.
fn kernel(r: f64, s: f64, between: f64) -> f64 {
    let (mut one, mut two) = (r + s, between);
    for _ in 0..40 {
        (one, two) = (0.5 * (one + two), (one * two).sqrt());
    }
    FRAC_PI_2 / one
}

/// A zone on one side of the axis, that of a disk from it, with its corner intensities.
struct Side {
    ends: [f64; 2],
    intensity: [f64; 2],
}

fn sides(contact: &Contact) -> Vec<Side> {
    let edges = contact.zones().into_iter().zip(contact.corner_intensity().unwrap());
    edges
        .filter(|(zone, _)| zone[1] > 0.0)
        .map(|(zone, intensity)| Side {
            ends: zone.map(|x| x.max(0.0)),
            intensity: [if zone[0] > 0.0 { intensity[0] } else { 0.0 }, intensity[1]],
        })
        .collect()
}

impl Side {
    /// The pressure at a place by its distances from the ends.
    fn pressure(&self, contact: &Contact, s: f64, from: f64, to: f64) -> f64 {
        let near = SINGULAR * (self.ends[1] - self.ends[0]);
        let [inner, outer] = self.intensity;
        if inner != 0.0 && from < near {
            return inner / (2.0 * PI * from).sqrt();
        }
        if outer != 0.0 && to < near {
            return outer / (2.0 * PI * to).sqrt();
        }
        contact.pressure(s).unwrap()
    }

    /// `int p(s) f(s, |r - s|) ds`, cut at `r` and at kinks.
    fn integral(&self, contact: &Contact, r: f64, f: impl Fn(f64, f64) -> f64) -> f64 {
        let [left, right] = self.ends;
        let kinks = contact.problem().profile().breakpoints(A).into_iter().map(|xi| xi * A);
        let mut cuts: Vec<f64> =
            kinks.chain([r]).filter(|at| left < *at && *at < right).chain([left, right]).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let part = |from: f64, to: f64| {
            integral(from, to, |s, beyond, before| {
                let between = match r {
                    _ if r == from => beyond,
                    _ if r == to => before,
                    _ if r < from => from - r + beyond,
                    _ => r - to + before,
                };
                let from_left = if from == left { beyond } else { s - left };
                let from_right = if to == right { before } else { right - s };
                let pressure = self.pressure(contact, s, from_left, from_right);
                // At a kink, less than rounding apart.
                if pressure.is_finite() { pressure * f(s, between) } else { 0.0 }
            })
        };
        cuts.windows(2).map(|pair| part(pair[0], pair[1])).sum()
    }
}

/// The displacement that the pressure makes: `u(r) = (4/(pi E*)) int p s K ds/(r + s)`.
fn displacement(contact: &Contact, r: f64) -> f64 {
    let of = |side: Side| side.integral(contact, r, |s, between| s * kernel(r, s, between));
    4.0 / (PI * MODULUS) * sides(contact).into_iter().map(of).sum::<f64>()
}

/// `2 pi int p r dr`.
fn force(contact: &Contact) -> f64 {
    sides(contact).into_iter().map(|s| 2.0 * PI * s.integral(contact, 2.0 * A, |r, _| r)).sum()
}

/// Displacement, force and signs are those of a contact, by quadratures of its pressure.
#[track_caller]
fn is_contact(profile: &str, contact: &Contact, load: f64, tolerance: f64) {
    let height = |x: f64| contact.problem().profile().height(x / A, A);
    let size =
        contact.elastic_displacement(contact.zones()[0][0]).abs() + contact.settlement().abs();
    let mut worst = [0.0f64; 3];
    for side in sides(contact) {
        let [left, right] = side.ends;
        for share in [0.02, 0.3, 0.77, 0.98] {
            let r = left + share * (right - left);
            let error = displacement(contact, r) - (contact.settlement() - height(r));
            worst[0] = worst[0].max((error / size).abs());
            assert!(contact.pressure(r).unwrap() > 0.0, "{profile}: {r}");
        }
    }
    let beside: Vec<f64> =
        sides(contact).windows(2).map(|w| 0.5 * (w[0].ends[1] + w[1].ends[0])).collect();
    for r in beside.into_iter().chain([1e-4 * A, 0.9999 * A, 1.01 * A, 30.0 * A]) {
        let found = displacement(contact, r);
        worst[1] = worst[1].max((found / contact.elastic_displacement(r) - 1.0).abs());
        if r < A {
            let gap = contact.gap(r).unwrap();
            assert!(gap >= 0.0, "{profile}: {r} {gap:e}");
        }
    }
    worst[2] = (force(contact) / load - 1.0).abs();
    assert!(worst.iter().all(|error| *error < tolerance), "{profile}: {worst:?}");
}

/// Bases with forces, and the numbers of their zones along a diameter.
const BASES: [(&str, f64, usize); 9] = [
    ("-x^2", 3e4, 2),
    ("0.1*(abs(x) - 0.003)^2", 10.0, 2),
    ("1e-6*(1 - cos(5000*x))", 200.0, 9),
    ("1e-6*cos(5000*x)", 100.0, 8),
    ("1e-6*cos(2000*x) + 0.2*x^2", 100.0, 2),
    ("1e-6*(1 - cos(2500*x)) + 1e2*x^4", 500.0, 5),
    ("where(abs(x) < 0.002, 1e-4, 0)", 1e3, 2),
    ("where(abs(x) < 0.003, 0, 1e-7)", 1e4, 3),
    ("where(abs(x) < 0.002, 5e-7, where(abs(x) < 0.003, 1e-4, 0))", 1e4, 3),
];

#[test]
fn pressures_make_the_surface_follow_the_base() {
    for (profile, load, count) in BASES {
        let contact = solve(profile, pressed(load));
        assert_eq!(
            contact.dimensionless().zones().len(),
            count,
            "{profile}: {:?}",
            contact.dimensionless().zones()
        );
        is_contact(profile, &contact, load, 1e-10);
        assert!(contact.relative_error() < 1e-11, "{profile}: {:e}", contact.relative_error());
        let left = contact.complementarity().unwrap();
        assert!(left.tension < 1e-12 && left.penetration < 1e-12, "{profile}: {left:?}");
    }
}

#[test]
fn kinks() {
    for (profile, load) in
        [("1e-3*abs(abs(x) - 0.003)", 50.0), ("-1e-3*abs(x)", 1e3), ("1e-4*abs(sin(2000*x))", 1e3)]
    {
        is_contact(profile, &solve(profile, pressed(load)), load, 1e-10);
    }
    // Kinks in a ring with a hole so small that they are close in its logarithm take more modes than there are: the error is stated.
    let blunt = "2e-4*max(abs(abs(x) - 0.003) - 0.0004, 0)";
    let contact = solve(blunt, pressed(2e3));
    assert!(contact.relative_error() > 1e-8 && contact.relative_error() < 1e-6);
    is_contact(blunt, &contact, 2e3, contact.relative_error());
    let contact = solve(blunt, pressed(2e4));
    assert!(contact.relative_error() > 1e-5 && contact.relative_error() < 2e-3);
    is_contact(blunt, &contact, 2e4, contact.relative_error());
}

#[test]
fn cones_that_open_at_the_axis() {
    // Few modes leave a penetration beside the inner edge that all of them do not.
    for (profile, load) in [
        ("1.6e-5*max(x^2/2.5e-5, 0.71 - 0.03*abs(x)/5e-3)", 4e3),
        ("5e-6*(abs(abs(x)/5e-3 - 0.45) + 0.6*x^2/2.5e-5)", 3e3),
    ] {
        let contact = solve(profile, pressed(load));
        assert_eq!(
            contact.dimensionless().zones().len(),
            2,
            "{profile}: {:?}",
            contact.dimensionless().zones()
        );
        let stated = contact.relative_error();
        assert!(stated < 1e-3, "{profile}: {stated:e}");
        is_contact(profile, &contact, load, stated.max(1e-10));
    }
}

#[test]
fn a_narrow_crest_parts_a_disk() {
    let profile = "1.9e-6*x^2/2.5e-5 - 1.8e-7*exp(-((abs(x)/5e-3 - 0.911)/0.0031)^2)";
    let contact = solve(profile, pressed(2.1e4));
    assert_eq!(contact.dimensionless().zones().len(), 5, "{:?}", contact.dimensionless().zones());
    is_contact(profile, &contact, 2.1e4, 1e-8);
}

#[test]
fn flat_annuli() {
    // int_0^a (1 - D g)^2 dx/a, D g = d/dx int_0^x r g dr/sqrt(x^2 - r^2), is least over displacements g in the hole for F/(2 E* a delta), and
    // int_0^a (2 x - (1/x) d/dx int_0^x r^2 g dr/sqrt(x^2 - r^2))^2 dx/a^3 for the turning stiffness over E* a^3: by the method of Ritz, to the digits shown.
    let delta = 1e-6;
    for (hole, exact) in
        [(0.1, 0.999_864_355_578_002), (0.5, 0.981_017_896_922_566), (0.9, 0.821_029_779_368_5)]
    {
        let profile = format!("where(abs(x) < {}, 1e-3, 0)", hole * A);
        let contact = solve(&profile, sunk(delta));
        let found = contact.force() / (2.0 * MODULUS * A * delta);
        close(found, exact, 1e-12, &format!("force with a hole of {hole}"));
        let stated =
            contact.dimensionless().error().unwrap().force / contact.dimensionless().force();
        honest(stated + 5e-13, found / exact - 1.0, 1.0, 1e-12, "force");
        assert_eq!(contact.corner_intensity().unwrap().len(), 2);
        if hole == 0.5 {
            let turning = contact.stiffness().moment_tilt / (MODULUS * A.powi(3));
            close(turning, 1.328_056_600_923_444, 1e-13, "turning");
            honest(stated, found / exact - 1.0, 1.0, 1e-13, "force");
        }
        let [[_, right], [left, _]] = contact.zones()[..] else { panic!() };
        assert!(right == -left && (left - hole * A).abs() < 1e-17);
    }
    // A disk with a ring about it, of one height.
    let contact = solve("where((abs(x) > 0.0015)*(abs(x) < 0.003), 1e-3, 0)", sunk(delta));
    close(
        contact.force() / (2.0 * MODULUS * A * delta),
        0.986_721_454_277_686,
        1e-13,
        "disk and ring",
    );
}

#[test]
fn a_small_hole_is_none() {
    // F = 2 E* a delta (1 - 4 b^3/(3 pi^2 a^3)), a classic of the annular disk
    for hole in [1e-2, 1e-3] {
        let profile = format!("where(abs(x) < {:e}, 1e-3, 0)", hole * A);
        let contact = solve(&profile, sunk(1e-6));
        let lost = 1.0 - contact.force() / (2.0 * MODULUS * A * 1e-6);
        let first = 4.0 * hole.powi(3) / (3.0 * PI * PI);
        assert!((lost - first).abs() < first * hole + 1e-14, "{lost:e} {first:e}");
        // The corner is that of the whole disk: K = F/(2 sqrt(pi a^3)).
        let intensity = contact.corner_intensity().unwrap()[1][1];
        let whole = contact.force() / (2.0 * (PI * A.powi(3)).sqrt());
        close(intensity, whole, hole.powi(3) + 1e-13, "corner");
    }
}

#[test]
fn a_narrow_ring_is_a_line_of_hertz() {
    // Per length F/(2 pi r0), b^2 = 4 P R/(pi E*), delta = (2 P/(pi E*)) (ln(16 r0/b) + 1/2)
    let r0 = 3e-3;
    for load in [1e-6, 1e-4, 1e-2] {
        let contact = solve("0.1*(abs(x) - 0.003)^2", pressed(load));
        let line = load / (2.0 * PI * r0);
        let half = (4.0 * line * 5.0 / (PI * MODULUS)).sqrt();
        let [_, [inner, outer]] = contact.zones()[..] else { panic!() };
        let tolerance = 5.0 * (half / r0).powi(2) + 2e-9;
        close(outer - inner, 2.0 * half, tolerance, "width");
        close(contact.peak_pressure(), 2.0 * line / (PI * half), tolerance, "peak");
        let delta = 2.0 * line / (PI * MODULUS) * ((16.0 * r0 / half).ln() + 0.5);
        close(contact.settlement(), delta, tolerance, "settlement");
        let edge = contact.dimensionless().error().and_then(|error| error.zones).unwrap() * A;
        honest(edge, 0.0, half, 1e-7, "edge");
    }
}

#[test]
fn thin_layers_tend_to_it() {
    for (profile, load, _) in [BASES[1], BASES[5]] {
        let smooth = solve(profile, pressed(load));
        let mut before = [f64::INFINITY; 5];
        for theta0 in [1e2, 1e3] {
            let chi = 2.0 * A / (PI * MODULUS * theta0);
            let base = Profile::expression(profile).unwrap();
            let rough = problem(base, chi, pressed(load), Solver::default()).solve().unwrap();
            assert_eq!(rough.zones().len(), smooth.zones().len());
            let of = |contact: &Contact| {
                let [.., [inner, outer]] = contact.zones()[..] else { panic!() };
                let stiffness = contact.stiffness();
                let [force, moment] = [stiffness.force_settlement, stiffness.moment_tilt];
                [contact.settlement(), inner, outer, force, moment]
            };
            let pairs = of(&rough).into_iter().zip(of(&smooth));
            let errors: Vec<f64> = pairs.map(|(one, two)| (one / two - 1.0).abs()).collect();
            for (error, before) in errors.iter().zip(&mut before) {
                assert!(*error <= 0.25 * *before && *error < 0.05, "{profile}: {errors:?}");
                *before = *error;
            }
        }
    }
}

#[test]
fn stiffness_is_the_slope_of_the_force() {
    for (profile, load, _) in BASES {
        let contact = solve(profile, pressed(load));
        let step = 1e-5 * load / contact.stiffness().force_settlement;
        let force = |by: f64| solve(profile, sunk(contact.settlement() + by)).force();
        close(force(0.0), load, 1e-12, "force");
        let slope = (force(step) - force(-step)) / (2.0 * step);
        close(contact.stiffness().force_settlement, slope, 1e-8, "stiffness");
    }
}

#[test]
fn measured_waves() {
    let places: Vec<f64> = (0..=800).map(|i| A * (f64::from(i) / 400.0 - 1.0)).collect();
    let heights = places.iter().map(|x| 1e-6 * (5000.0 * x).cos()).collect();
    let base = Profile::from_points(places, heights).unwrap();
    let contact = problem(base, 0.0, pressed(100.0), Solver::default()).solve().unwrap();
    let exact = solve("1e-6*cos(5000*x)", pressed(100.0));
    for (one, two) in contact.zones().into_iter().flatten().zip(exact.zones().into_iter().flatten())
    {
        close(one, two, 1e-6, "edge");
    }
    close(contact.settlement(), exact.settlement(), 1e-6, "settlement");
}

#[test]
fn bases_from_seeds() {
    let mut state = 20_261_121u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    for trial in 0..60 {
        let waves = 1 + (random() * 6.0) as usize;
        let terms: Vec<String> = (0..waves)
            .map(|_| {
                let height = 1e-6 * (random() - 0.5);
                format!("{height:e}*cos({:e}*x)", 200.0 + 6000.0 * random())
            })
            .collect();
        let profile = format!("{} + {:e}*x^2", terms.join(" + "), 0.2 * (random() - 0.3));
        let load = 10f64.powf(-2.0 + 7.0 * random());
        let contact = attempt(&profile, pressed(load));
        let contact = contact.unwrap_or_else(|error| panic!("{trial}: {profile}, {load}: {error}"));
        let left = contact.complementarity().unwrap();
        assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{trial}: {left:?}");
        // Places near a corner of a narrow ring are rounded, and so are its ends: one that is 4.7e-7 of the radius wide states 1.9e-9, eight roundings of an end over that.
        let narrowest =
            contact.dimensionless().zones().iter().fold(2.0f64, |least, [l, r]| least.min(r - l));
        let most = 1e-11f64.max(1e-15 / narrowest);
        assert!(contact.relative_error() < most, "{trial}: {:e}", contact.relative_error());
        let error = force(&contact) / load - 1.0;
        assert!(narrowest < 1e-3 || error.abs() < 1e-9, "{trial}: {error:e}");
    }
}

#[test]
fn extreme_numbers_have_answers_or_errors() {
    let profiles =
        ["-x^2", "-1e300*x^2", "-1e-300*x^2", "-sqrt(abs(x))", "where(abs(x) < 1e-12, 1, 0)"];
    answers_or_errors(&profiles, &[1e-300, 1.0, 1e290]);
}

#[test]
fn sharp_features_have_answers_or_errors() {
    let single = ["where(abs(x) < 0.0049999, 1, 0)", "sqrt(0.005^2 - 0.999*x^2)"];
    answers_or_errors(&single, &[1e-300, 1.0, 1e290]);
    // Rings far narrower than the base are looked for at length.
    let rings = ["1e-6*cos(5000*x)", "1e-8*cos(1.5e4*x)", "(abs(x) - 0.003)^2"];
    answers_or_errors(&rings, &[1e-6, 1.0, 1e290]);
}

fn answers_or_errors(profiles: &[&str], forces: &[f64]) {
    for profile in profiles {
        for &force in forces {
            match attempt(profile, pressed(force)) {
                Ok(contact) => {
                    assert!(contact.settlement().is_finite());
                    for x in [0.0, 1e-200, 1e-20, 1e-5, 0.0025, 0.004_999_999] {
                        let pressure = contact.pressure(x).unwrap();
                        assert!(
                            pressure >= -1e-9 * contact.peak_pressure(),
                            "{profile} {force} {x}"
                        );
                        assert!(!contact.elastic_displacement(x).is_nan(), "{profile} {force} {x}");
                    }
                }
                Err(error) => assert!(!error.to_string().is_empty()),
            }
        }
    }
}

/// Between the forces at which the pressure on the axis vanishes and a little less the disk has a hole far smaller than the places where an answer is looked at are apart.
#[test]
fn a_hole_at_the_axis_is_found() {
    let wave = "1.98e-7*cos(3*pi*x/0.005)";
    let on_axis = |force: f64| solve_bilateral(wave, pressed(force)).pressure(0.0).unwrap();
    // Linear in the force.
    let [one, two] = [8e3, 12e3].map(|force| (force, on_axis(force)));
    let vanishing = one.0 - one.1 * (two.0 - one.0) / (two.1 - one.1);
    for share in [1e-5, 5e-5, 1e-3] {
        let pierced = solve(wave, pressed((1.0 - share) * vanishing));
        let hole = pierced.zones()[1][0];
        assert!(pierced.zones().len() == 2 && hole > 0.0 && hole < 1e-4, "{share}: {hole}");
        assert_eq!(pierced.pressure(0.0).unwrap(), 0.0);
        assert_eq!(solve(wave, pressed((1.0 + share) * vanishing)).zones().len(), 1);
    }
}
