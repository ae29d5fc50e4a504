//! Stress fields of solved contacts, and the load at first yield.

use shtaerman::{
    Criterion, Elastic, Error, Foundation, Load, Problem, Profile, Punch, Rotational, Solver,
    StressField, Vertical,
};

fn problem(theta0: f64, profile: &str, force: f64, eccentricity: f64, solver: Solver) -> Problem {
    let load = Load::new(Vertical::Force(force), Rotational::Eccentricity(eccentricity)).unwrap();
    let (foundation, punch) =
        (Foundation::dimensionless(theta0).unwrap(), Punch::new(1.0).unwrap());
    Problem::new(foundation, punch.with_profile(Profile::expression(profile).unwrap()), load)
        .unwrap()
        .with_solver(solver)
}

fn field_of(problem: &Problem, ratio: Option<f64>) -> StressField {
    StressField::new(&problem.solve().unwrap(), ratio).unwrap()
}

/// The field is that of the pressure of the answer, by an independent sum deep enough for one.
#[test]
fn the_field_is_that_of_the_pressure() {
    for (theta0, profile, eccentricity) in [
        (3.0, "xi^2", 0.1),
        (40.0, "2*abs(xi - 0.2)", 0.0),
        (1000.0, "100*xi^2", 0.05),
        (2.0, "0*xi", 0.5),
    ] {
        let problem = problem(theta0, profile, 0.7, eccentricity, Solver::default());
        let contact = problem.solve().unwrap();
        let field = StressField::new(&contact, Some(0.3)).unwrap();
        assert!((field.force() / contact.dimensionless().force() - 1.0).abs() < 1e-10);
        assert!(
            field.error() < 1e-9 * contact.dimensionless().force(),
            "{profile}: {:e}",
            field.error()
        );
        for (x, y) in [(0.1, 0.3), (-0.8, 0.5), (1.2, 0.4)] {
            let mut sums = [0.0; 2];
            for [left, right] in contact.dimensionless().zones() {
                // s = middle + half sin t levels what the pressure does at the edges.
                const COUNT: usize = 4000;
                let step = std::f64::consts::PI / COUNT as f64;
                for t in (0..COUNT).map(|i| step * (i as f64 + 0.5)) {
                    let half = 0.5 * (right - left);
                    let s = left.midpoint(right) - half * t.cos();
                    let (d, p) = (
                        x - s,
                        half * step * t.sin() * contact.dimensionless().pressure(s).unwrap(),
                    );
                    let size = d * d + y * y;
                    sums[0] -= 2.0 / std::f64::consts::PI * p * y * d * d / (size * size);
                    sums[1] -= 2.0 / std::f64::consts::PI * p * y * y * y / (size * size);
                }
            }
            let stress = field.stress(x, y).unwrap();
            let scale = contact.dimensionless().force();
            assert!(
                (stress.sigma_x - sums[0]).abs() < 1e-6 * scale,
                "{profile} {x}: {stress:?} {sums:?}"
            );
            assert!(
                (stress.sigma_y - sums[1]).abs() < 1e-6 * scale,
                "{profile} {x}: {stress:?} {sums:?}"
            );
        }
        for x in [-1.0, -0.7, -0.2, 0.0, 0.2, 0.6, 1.0] {
            let largest = 10.0 * field.error() + 1e-11;
            assert!(
                (field.pressure(x) - contact.dimensionless().pressure(x).unwrap()).abs() < largest,
                "{profile} {x}"
            );
        }
    }
}

/// Hardly rough, a crown is Hertz's, in SI units.
#[test]
fn a_hardly_rough_crown_is_hertz() {
    let steel = Elastic::new(210e9, 0.3).unwrap();
    let (radius, force) = (0.1, 2e5);
    let width =
        (4.0 * force * radius / (std::f64::consts::PI * steel.plane_strain_modulus())).sqrt();
    let largest = 2.0 * force / (std::f64::consts::PI * width);
    let (foundation, punch) = (
        Foundation::new(steel).with_roughness(1e-5 * width / steel.plane_strain_modulus()).unwrap(),
        Punch::new(1e-3).unwrap(),
    );
    let load = Load::new(Vertical::Force(force), Rotational::Moment(0.0)).unwrap();
    let profile = Profile::expression("x^2/(2*0.1)").unwrap();
    let problem = Problem::new(foundation, punch.with_profile(profile), load).unwrap();
    let field = field_of(&problem, None);
    assert_eq!(field.poisson_ratio(), 0.3);
    let peak = field.peak(Criterion::Tresca);
    assert!((0.5 * peak.value / largest - 0.300_283).abs() < 1e-5, "{peak:?}");
    assert!((peak.depth / width - 0.786_151).abs() < 1e-4);
    // Hertz: the load at yield grows as the square of the stress.
    let yields = problem.first_yield(Criterion::Tresca, 3.0 * peak.value, None).unwrap();
    assert!((yields.factor / 9.0 - 1.0).abs() < 1e-3, "{yields:?}");
}

/// A flat punch keeps its shape: stress is proportional to the load. A crowned one is not; solving again at the load found gives the yield stress.
#[test]
fn the_load_at_first_yield_has_the_yield_stress() {
    for solver in [Solver::bilateral(), Solver::default()] {
        for criterion in [Criterion::VonMises, Criterion::Tresca] {
            let flat = problem(5.0, "0*xi", 0.3, 0.1, solver);
            let peak = field_of(&flat, Some(0.3)).peak(criterion);
            let yields = flat.first_yield(criterion, 7.0, Some(0.3)).unwrap();
            assert!((yields.factor * peak.value / 7.0 - 1.0).abs() < 1e-10);
            assert!((yields.force / (0.3 * yields.factor) - 1.0).abs() < 1e-13);
            assert!((yields.moment / (0.1 * yields.force) - 1.0).abs() < 1e-9);

            let crowned = problem(5.0, "xi^2", 0.3, 0.1, solver);
            let yields = crowned.first_yield(criterion, 2.0, Some(0.3)).unwrap();
            let again = problem(5.0, "xi^2", yields.force, 0.1, solver);
            let peak = field_of(&again, Some(0.3)).peak(criterion);
            assert!((peak.value / 2.0 - 1.0).abs() < 1e-10, "{yields:?} {peak:?}");
        }
    }
}

/// A profile that is forced flat stresses the body without any force.
#[test]
fn there_may_be_no_load_at_yield() {
    let crowned = problem(5.0, "xi^2", 0.3, 0.0, Solver::bilateral());
    let refused = crowned.first_yield(Criterion::VonMises, 1e-3, Some(0.3));
    assert!(matches!(refused, Err(Error::NoYield { .. })), "{refused:?}");
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = crowned.first_yield(Criterion::VonMises, wrong, Some(0.3));
        assert!(matches!(refused, Err(Error::InvalidValue { field: "yield_stress", .. })));
    }
    assert_eq!(
        StressField::new(&crowned.solve().unwrap(), None).err(),
        Some(Error::NoPoissonRatio)
    );
}
