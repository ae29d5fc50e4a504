//! The width of contact on graded ground: where its edges are free and the layer is thin, the slopes there change far below the rounding of places. Against differences of whole solves; the first cases are those of
//! hostile reviews, of which the worst were off by 92 times what they stated by collocation, and by 236 times on panels.

use shtaerman::{
    Contact, Derivatives, Foundation, Grading, Load, MethodName, Problem, Profile, Punch, Vertical,
};

/// The width by the force without dimensions: stated with its error, and by differences with what these are off by.
fn elasticities(contact: &Contact) -> [[f64; 2]; 2] {
    let problem = contact.problem();
    let width = |share: f64| -> f64 {
        let force = Vertical::Force(share * contact.force());
        let changed = problem.with_vertical(force).unwrap();
        changed.solve().unwrap().zones().iter().map(|[left, right]| right - left).sum()
    };
    let whole = width(1.0);
    let difference = |h: f64| (width(1.0 + h) - width(1.0 - h)) / (2.0 * h * whole);
    let [coarse, fine] = [difference(2e-3), difference(1e-3)];
    let Derivatives { force, error, .. } = contact.sensitivities().unwrap().contact_width;
    let stated = force.unwrap() * contact.force() / whole;
    [[stated, error], [(4.0 * fine - coarse) / 3.0, 1e-3 * (fine - coarse).abs() + 1e-9]]
}

fn solved([exponent, modulus, roughness]: [f64; 3], punch: &str, rest: &str) -> Contact {
    let text = format!(
        "[foundation]\ngrading_exponent = {exponent}\ngrading_modulus = {modulus}\npoisson_ratio = 0.3\nroughness = {roughness}\n[punch]\n{punch}\n[load]\nmoment = 0\n{rest}"
    );
    shtaerman::file::parse(&text, "test").unwrap().solve().unwrap()
}

#[track_caller]
fn holds(contact: &Contact, useful: f64) {
    let [[stated, error], [truth, off]] = elasticities(contact);
    let away = (stated - truth).abs();
    assert!(away <= error + off, "{stated} {truth} {error:e}");
    assert!(error < useful, "{error:e}");
}

#[test]
fn widths_on_strongly_graded_ground() {
    let plane = |half_width: f64, profile: &str| {
        format!("half_width = {half_width}\nprofile = \"{profile}\"")
    };
    let parabola = plane(0.3, "3e-5*xi^2");
    let quartic = plane(0.01, "4.825e-07*xi^4");
    let waved = plane(0.3, "3e-5*xi^2 + 3e-9*cos(30*xi + 1)");
    let disk = "geometry = \"circular\"\nradius = 0.3\nprofile = \"3e-5*xi^4\"";
    let coarse = "[solver]\ntolerance = 0.01\n";
    let cases = [
        ([0.85, 1e10, 5e-11], &parabola[..], "force = 11000", ""),
        ([0.85, 1e10, 5e-11], &parabola, "force = 11000", coarse),
        ([0.85, 1e10, 5e-13], &parabola, "force = 11000", ""),
        ([0.91, 1.12e10, 4.36e-13], &quartic, "force = 4.3", ""),
        ([0.7, 1e10, 5e-12], &waved, "force = 11000", coarse),
        ([0.4, 1e10, 1e-13], &parabola, "force = 11000", ""),
        ([0.1, 1e10, 1e-12], &parabola, "force = 11000", ""),
        ([0.82, 1e10, 1e-12], disk, "force = 900", ""),
    ];
    for (ground, punch, force, solver) in cases {
        let contact = solved(ground, punch, &format!("{force}\n{solver}"));
        assert_eq!(contact.method().name, MethodName::Sinc);
        // Of use, too: what is known without a tolerance is known to four digits.
        holds(&contact, if solver.is_empty() { 2e-4 } else { f64::INFINITY });
    }
}

#[test]
fn the_same_on_panels() {
    for ([exponent, modulus, roughness], points, useful) in [
        ([0.3, 3.9811e+09, 4.2766e-13], 30, 1e-4),
        ([0.62, 1.7378e+10, 1.4383e-14], 6, 1e-2),
        ([0.8, 3.9811e+10, 1.7087e-14], 6, 1e-2),
        ([0.8, 3.9811e+10, 1.7087e-14], 20, 5e-2),
        ([0.72, 2.7542e+10, 9.8571e-16], 6, f64::INFINITY),
    ] {
        let positions: Vec<f64> =
            (0..=points).map(|k| 0.01 * (2.0 * f64::from(k) / f64::from(points) - 1.0)).collect();
        let heights = positions.iter().map(|x| 1e-3 * x * x).collect();
        let profile = Profile::from_points(positions, heights).unwrap();
        let punch = Punch::new(0.01).unwrap().with_profile(profile);
        let ground = Foundation::graded(Grading::new(exponent, modulus).unwrap(), 0.3).unwrap();
        let ground = ground.with_roughness(roughness).unwrap();
        let problem = Problem::new(ground, punch, Load::force(20.0).unwrap()).unwrap();
        let contact = problem.solve().unwrap();
        assert_eq!(contact.method().name, MethodName::Panels);
        holds(&contact, useful);
    }
}

/// Without a tolerance collocation knows this to 2e-5, with one it stated 1e-3 of a width that is off by 0.37: sums over nodes beside the edge are anything where the pressure is off.
#[test]
fn the_same_with_a_tolerance() {
    let punch = "half_width = 0.0365\nprofile = \"1.05e-07*((xi - 0.020429)^2 + 1.427e-05*cos(27.2160*xi + 1.7106))\"";
    let ground = [0.6882, 3.1e11, 2.74e-13];
    for solver in ["", "[solver]\ntolerance = 0.01\n"] {
        let text = format!("force = 1640\n{solver}");
        let contact = solved(ground, punch, &text);
        assert_eq!(contact.method().name, MethodName::Sinc);
        holds(&contact, if solver.is_empty() { 1e-3 } else { 1.0 });
    }
}
