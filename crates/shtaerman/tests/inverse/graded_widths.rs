//! The width of contact on graded ground, by collocation: where its edges are free and the layer is thin, the slopes there change far below the rounding of places. Against differences of whole solves; the first cases are those of a
//! hostile review, of which the worst was off by 92 times what it stated.

use shtaerman::{Contact, Derivatives, MethodName, Vertical};

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
        let [[stated, error], [truth, off]] = elasticities(&contact);
        let away = (stated - truth).abs();
        assert!(away <= error + off, "{ground:?} {punch}: {stated} {truth} {error:e}");
        // Of use, too: what is known without a tolerance is known to four digits.
        assert!(!solver.is_empty() || error < 2e-4, "{ground:?} {punch}: {error:e}");
    }
}
