//! Stress fields of solved contacts, and the load at first yield.

use std::f64::consts::PI;

use shtaerman::{
    Contact, Criterion, Elastic, Error, Foundation, Load, Problem, Profile, Punch, Rotational,
    Solver, StressField, Vertical, file,
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
                let step = PI / COUNT as f64;
                for t in (0..COUNT).map(|i| step * (i as f64 + 0.5)) {
                    let half = 0.5 * (right - left);
                    let s = left.midpoint(right) - half * t.cos();
                    let (d, p) = (
                        x - s,
                        half * step * t.sin() * contact.dimensionless().pressure(s).unwrap(),
                    );
                    let size = d * d + y * y;
                    sums[0] -= 2.0 / PI * p * y * d * d / (size * size);
                    sums[1] -= 2.0 / PI * p * y * y * y / (size * size);
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
    let width = (4.0 * force * radius / (PI * steel.plane_strain_modulus())).sqrt();
    let largest = 2.0 * force / (PI * width);
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

/// Hertz: on the axis the shear stress is `p0 (b - b^2/sqrt(1 + b^2))` at the depth `b a`, and `P = pi R p0^2/E*`.
#[test]
fn the_error_of_the_load_at_first_yield_holds() {
    let steel = Elastic::new(210e9, 0.3).unwrap();
    let shear = |b: f64| b - b * b / (1.0 + b * b).sqrt();
    // The largest, by golden sections.
    let (mut left, mut right) = (0.7, 0.9);
    while right - left > 1e-9 {
        let part = 0.381_966 * (right - left);
        let is_left = shear(left + part) > shear(right - part);
        (left, right) = if is_left { (left, right - part) } else { (left + part, right) };
    }
    for (radius, stress) in [(0.1, 350e6), (0.03, 1e8), (2.0, 777e6)] {
        let punch = Punch::new(0.05).unwrap();
        let profile = Profile::expression(&format!("x^2/(2*{radius})")).unwrap();
        let load = Load::new(Vertical::Force(1e4), Rotational::Moment(0.0)).unwrap();
        let problem = Problem::new(Foundation::new(steel), punch.with_profile(profile), load);
        let found = problem.unwrap().first_yield(Criterion::Tresca, stress, None).unwrap();
        let largest = stress / (2.0 * shear(left));
        let exact = PI * radius * largest.powi(2) / steel.plane_strain_modulus();
        let off = (found.force - exact).abs();
        assert!(off <= found.error && found.error < 1e-8 * exact, "{exact} {found:?}");
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

/// A smooth surface under a kink has an infinite pressure there, and stresses below it by the same independent sum.
#[test]
fn kinks_of_smooth_contacts_are_integrated() {
    let body = Elastic::new(1.0, 0.3).unwrap();
    let foundation = Foundation::new(body).with_roughness(0.0).unwrap();
    let load = Load::new(Vertical::Force(0.3), Rotational::Moment(0.01)).unwrap();
    let profile = Profile::expression("0.3*x^2 + 0.1*abs(x - 0.1)").unwrap();
    let punch = Punch::new(1.0).unwrap().with_profile(profile);
    let contact = Problem::new(foundation, punch, load).unwrap().solve().unwrap();
    let field = StressField::new(&contact, None).unwrap();
    assert_eq!(field.infinite_corners(), [0.1]);
    // Places so close to the kink that their distance is rounded are among those that it is estimated at.
    assert!(field.error() < 1e-5, "{:e}", field.error());
    let [left, right] = contact.zones()[0];
    // Gauss's two nodes on pieces that fall as the square of their number towards the ends and the kink.
    const PIECES: i32 = 4000;
    let mut nodes = Vec::new();
    for ([from, to], end) in
        [([left, 0.1], left), ([left, 0.1], 0.1), ([0.1, right], 0.1), ([0.1, right], right)]
    {
        let half = 0.5 * (to - from);
        let place = |i: f64| {
            (half * (i / f64::from(PIECES)).powi(2)).copysign(0.5 * (from + to) - end) + end
        };
        for i in 0..PIECES {
            let [a, b] = [place(f64::from(i)), place(f64::from(i + 1))];
            for side in [-1.0, 1.0] {
                let s = 0.5 * (a + b) + side * 0.5 * (b - a) / 3f64.sqrt();
                nodes.push((s, 0.5 * (b - a).abs() * contact.pressure(s).unwrap()));
            }
        }
    }
    let force: f64 = nodes.iter().map(|(_, p)| p).sum();
    assert!((force - 0.3).abs() < 1e-7, "{force}");
    for (x, y) in [(0.1, 0.05), (-0.3, 0.2), (0.12, 0.01)] {
        let by = |f: &dyn Fn(f64) -> f64| -> f64 {
            let terms = nodes.iter().map(|(s, p)| p * f(x - s));
            -2.0 / PI * terms.sum::<f64>()
        };
        let sigma_x = by(&|d| y * d * d / (d * d + y * y).powi(2));
        let sigma_y = by(&|d| y * y * y / (d * d + y * y).powi(2));
        let stress = field.stress(x, y).unwrap();
        let off = (stress.sigma_x - sigma_x).abs().max((stress.sigma_y - sigma_y).abs());
        assert!(off < 1e-6, "{x} {y}: {stress:?} {sigma_x} {sigma_y}");
    }
}

/// Where a wave is cut into periods changes nothing, and at its seam it may bend.
#[test]
fn a_wave_may_bend_at_its_seam() {
    let field = |profile: &str| {
        let load = Load::new(Vertical::Force(1.0), Rotational::Tilt(0.0)).unwrap();
        let punch =
            Punch::periodic(1.0, 2.0).unwrap().with_profile(Profile::expression(profile).unwrap());
        let problem = Problem::new(Foundation::dimensionless(3.0).unwrap(), punch, load).unwrap();
        field_of(&problem, Some(0.3))
    };
    let (at_seam, inside) = (field("-0.4*abs(xi)"), field("0.4*abs(xi) - 0.4"));
    let stated = at_seam.error() + inside.error();
    assert!(stated < 1e-9, "{stated:e}");
    for (x, y) in [(1.0, 1e-4), (0.99, 1e-3), (-0.97, 0.01), (0.3, 0.2)] {
        let one = at_seam.stress(x, y).unwrap();
        let two = inside.stress(if x > 0.0 { x - 1.0 } else { x + 1.0 }, y).unwrap();
        for (one, two) in
            [(one.sigma_x, two.sigma_x), (one.sigma_y, two.sigma_y), (one.tau_xy, two.tau_xy)]
        {
            assert!((one - two).abs() <= stated + 1e-12, "{x} {y}: {one} {two}, stated {stated:e}");
        }
    }
}

/// A smooth wave in full contact has the pressure `E* sum k_n u_n/2 cos(k_n x)` of its heights, and each term its stresses: also of a kink, under which the pressure is infinite.
#[test]
fn kinks_of_full_waves_are_integrated() {
    const TURN: f64 = std::f64::consts::TAU;
    let (modulus, height, mean, kink) = (1.0 / 0.91, 1e-3, 4e-3, 0.2);
    let body = Elastic::new(1.0, 0.3).unwrap();
    let foundation = Foundation::new(body).with_roughness(0.0).unwrap();
    let load = Load::new(Vertical::Force(mean), Rotational::Tilt(0.0)).unwrap();
    let profile = Profile::expression("1e-3*abs(sin(pi*(x - 0.2)))").unwrap();
    let punch = Punch::periodic(0.5, 1.0).unwrap().with_profile(profile);
    let field = field_of(&Problem::new(foundation, punch, load).unwrap(), None);
    assert!(field.error() < 1e-4 * mean, "{:e}", field.error());
    for (x, y) in [(0.2, 0.1), (0.1, 0.2), (0.21, 0.01), (-0.4, 0.05)] {
        // |sin(t/2)| = 2/pi - 4/pi sum cos(n t)/(4 n^2 - 1)
        let terms = (1..4000).map(|n| {
            let (n, turn) = (f64::from(n), TURN * f64::from(n));
            let pressure = 2.0 * modulus * turn * height / (0.5 * TURN * (4.0 * n * n - 1.0));
            let (sine, cosine) = (turn * (x - kink)).sin_cos();
            let fall = pressure * (-turn * y).exp();
            [fall * (1.0 + turn * y) * cosine, fall * turn * y * sine]
        });
        let [normal, shear] = terms.fold([mean, 0.0], |sum, term| [0, 1].map(|i| sum[i] + term[i]));
        let stress = field.stress(x, y).unwrap();
        let off = (stress.sigma_y + normal).abs().max((stress.tau_xy + shear).abs());
        assert!(off <= field.error() + 1e-15, "{x} {y}: {off:e} of {:e}", field.error());
    }
}

fn contact_of(text: &str) -> Contact {
    file::parse(text, "test").unwrap().solve().unwrap().audited().unwrap()
}

/// A smooth wave in full contact has `p = mean + E* k A/2 cos(kx)`: von Mises is largest below the middle of a crest, which is the seam of the base here. Under some of these loads the search came as near to
/// the seam as places are rounded, where both its sides have to see one place.
#[test]
fn a_closed_wave_has_its_largest_stress_below_the_crest() {
    let (modulus, ratio, period, height) = (21.386e6, 0.477, 0.306, 1.7e-4);
    let wave = 2.0 * PI / period;
    let amplitude = 0.5 * modulus / (1.0 - ratio * ratio) * wave * height;
    let loads = (0..60).map(|i| amplitude * (1.01 + 0.37 * f64::from(i)));
    for mean in loads.chain([371_071.242 / period, 426_177.0 / period]) {
        let contact = contact_of(&format!(
            "[foundation]\nyoung_modulus = {modulus}\npoisson_ratio = {ratio}\nroughness = 0\n[punch]\ngeometry = \"periodic\"\nperiod = {period}\n\
             profile = \"{height}*cos(2*pi*x/{period})\"\n[load]\nforce = {}\ntilt = 0\n",
            mean * period
        ));
        let peak = StressField::new(&contact, None).unwrap().peak(Criterion::VonMises);
        let below = |depth: f64| {
            let decay = amplitude * (-wave * depth).exp();
            let (sum, radius) = (2.0 * (mean + decay), wave * depth * decay);
            (3.0 * radius * radius + ((0.5 - ratio) * sum).powi(2)).sqrt()
        };
        let largest = (0..=20_000).map(|k| below(period * f64::from(k) / 20_000.0));
        let largest = largest.fold(0.0, f64::max);
        assert!((peak.value / largest - 1.0).abs() < 1e-7, "{mean}: {peak:?} {largest}");
    }
}

/// Under a nearly level pressure the stress is nearly level on the half-circle through the ends, a ridge that bends: what is found is no less than at 14,000 places along it.
#[test]
fn a_ridge_is_climbed_to_its_top() {
    for i in 0..40 {
        let (ratio, height) = (0.3 + 0.0047 * f64::from(i), 0.4e-7 + 0.21e-7 * f64::from(i % 7));
        let power = 2 + 2 * (i % 3);
        let contact = contact_of(&format!(
            "[foundation]\nyoung_modulus = 45.746e6\npoisson_ratio = {ratio}\nroughness = 5.16969e-11\n[punch]\nhalf_width = 338e-6\n\
             profile = \"{height}*(x/0.000338)^{power}\"\n[load]\nforce = 13.477\ntilt = 0\n"
        ));
        let field = StressField::new(&contact, None).unwrap();
        for criterion in [Criterion::VonMises, Criterion::Tresca] {
            let peak = field.peak(criterion);
            for (angle, radius) in (1..200).flat_map(|k| (0..70).map(move |r| (k, r))) {
                let (sine, cosine) = (PI * f64::from(angle) / 200.0).sin_cos();
                let radius = 338e-6 * (0.4 + 0.01 * f64::from(radius));
                let stress = field.stress(radius * cosine, radius * sine).unwrap();
                let value = criterion.of(&stress);
                let most = peak.value + field.error() + 1e-12 * peak.value;
                assert!(value <= most, "{ratio} {power}: {value} {peak:?}");
            }
        }
    }
}

/// Where the stress across the plane counts for one of two maxima of the shear stress, steps longer than the grid lead from the larger to the other one.
#[test]
fn of_two_maxima_the_larger_is_found() {
    let contact = contact_of(
        "[foundation]\nyoung_modulus = 226.59e6\npoisson_ratio = 0.241\nroughness = 1.36283e-13\n[punch]\nhalf_width = 1.79e-3\n\
         profile = \"4.371e-06*((x/0.00179)^2+-0.477662*(x/0.00179)^3+0.0175076*x/0.00179)\"\n[load]\nforce = 70.256\nmoment = 0\n",
    );
    let field = StressField::new(&contact, None).unwrap();
    let larger = field.stress(-4.465_216e-5, 1.390_054e-4).unwrap().tresca();
    let peak = field.peak(Criterion::Tresca);
    assert!(peak.value >= larger - field.error(), "{larger} {peak:?}");
}

/// The edge of a hollow smooth punch reaches its corner under this load: the stress is infinite from there on, and yield begins at the corner, not where it was largest before.
#[test]
fn yield_at_a_jump_begins_where_the_stress_is_beyond_it() {
    let text = "[foundation]\nyoung_modulus = 3220600\npoisson_ratio = 0.336\nroughness = 0\n[punch]\nhalf_width = 0.000684\n\
                profile = \"9.125e-07*((x/0.000684)^4-0.98226*(x/0.000684)^2)\"\n[load]\nforce = 1.99698\ntilt = 0\n";
    let problem = file::parse(text, "test").unwrap();
    let found = problem.first_yield(Criterion::VonMises, 4514.9, None).unwrap();
    assert!(found.place.is_corner && found.place.x.abs() == 0.000684, "{found:?}");
    // Where the edge is at the corner the pressure there vanishes: `P = E*/2 int x f'(x)/sqrt(a^2 - x^2) dx`.
    let modulus = 3_220_600.0 / (1.0 - 0.336f64.powi(2));
    let exact = 0.5 * modulus * 9.125e-7 * PI * (1.5 - 0.98226);
    let off = (found.force - exact).abs();
    assert!(off <= found.error && found.error < 1e-9 * exact, "{exact} {found:?}");
    let below = Load::new(Vertical::Force(0.999 * found.force), Rotational::Tilt(0.0)).unwrap();
    let contact = problem.with_load(below).unwrap().solve().unwrap();
    let before = StressField::new(&contact, None).unwrap().peak(Criterion::VonMises);
    assert!(before.value < 4514.9, "{before:?}");
}

/// A filled wave under a body without volume change feels no more load than fills it: no load brings more stress, and rounding of a pressure of 1e18 Pa is none.
#[test]
fn what_feels_no_load_does_not_yield() {
    let text = "[foundation]\nyoung_modulus = 1e7\npoisson_ratio = 0.5\nroughness = 1e-10\n[punch]\ngeometry = \"periodic\"\nperiod = 2e-3\n\
                profile = \"1e-6*cos(2*pi*x/0.002)\"\n[load]\nforce = 1e3\ntilt = 0\n";
    let problem = file::parse(text, "test").unwrap();
    for criterion in [Criterion::VonMises, Criterion::Tresca] {
        let refused = problem.first_yield(criterion, 1e5, None).unwrap_err();
        let Error::NoYield { nearest, .. } = refused else { panic!("{refused}") };
        assert!((3e3..6e3).contains(&nearest), "{nearest}");
    }
}
