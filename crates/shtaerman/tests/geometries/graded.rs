//! Foundations whose modulus grows with depth, against single-kernel solutions, closed forms and limits.

use std::f64::consts::PI;

use fredholm::Interval;
use fredholm::collocation::solve_adaptive;
use fredholm::kernel::{Power, WeberSonine};
use fredholm::quadrature::double_exponential;
use shtaerman::{
    Contact, Elastic, Foundation, Geometry, Grading, Load, Problem, Profile, Punch, Rotational,
    Roughness, Solver, Vertical,
};

const NU: f64 = 0.3;

/// `a = 1`, `E0 = 1`, so that pressures are those without dimensions; `chi` for this `theta0`.
fn stated(mu: f64, geometry: Geometry, theta0: f64) -> (Foundation, Punch) {
    let grading = Grading::new(mu, 1.0).unwrap();
    let chi = grading.response(NU, 1.0, geometry == Geometry::Circular) / theta0;
    let (foundation, punch) = (
        Foundation::graded(grading, NU).unwrap().with_roughness(chi).unwrap(),
        Punch::in_geometry(geometry, 1.0).unwrap(),
    );
    let load = Load::force(1.0).unwrap();
    let problem = Problem::new(foundation.clone(), punch.clone(), load).unwrap();
    assert!((problem.theta0() / theta0 - 1.0).abs() < 1e-14);
    (foundation, punch)
}

/// The scale of displacements.
fn depth((foundation, punch): &(Foundation, Punch)) -> f64 {
    let problem =
        Problem::new(foundation.clone(), punch.clone(), Load::force(1.0).unwrap()).unwrap();
    problem.scaling().unwrap().displacement()
}

fn solved(
    (foundation, punch): (Foundation, Punch),
    profile: &str,
    vertical: Vertical,
    rotational: Rotational,
    solver: Solver,
) -> Contact {
    let profile = Profile::expression(profile).unwrap();
    let load = Load::new(vertical, rotational).unwrap();
    Problem::new(foundation, punch.with_profile(profile), load)
        .unwrap()
        .with_solver(solver)
        .solve()
        .unwrap()
}

fn flat(stated: (Foundation, Punch), vertical: Vertical, solver: Solver) -> Contact {
    solved(stated, "0", vertical, Rotational::Tilt(0.0), solver)
}

#[test]
fn flat_punches_are_solutions_of_the_kernel() {
    for mu in [0.05, 0.3, 0.6] {
        for theta0 in [0.1, 3.0, 50.0] {
            let plane = stated(mu, Geometry::Plane, theta0);
            let settlement = depth(&plane);
            let power = Power::new(Interval::unit(), mu).unwrap();
            let other = solve_adaptive(&power, theta0, |_| 1.0, 1e-12).unwrap().solution;
            let disk = stated(mu, Geometry::Circular, theta0);
            let sunk = depth(&disk);
            let kernel = WeberSonine::new(1.0, 0.0, 0.5 * mu).unwrap();
            let rings = solve_adaptive(&kernel, PI * theta0, |_| 1.0, 1e-12).unwrap().solution;
            for solver in [Solver::default(), Solver::bilateral()] {
                let line = flat(plane.clone(), Vertical::Settlement(settlement), solver);
                let round = flat(disk.clone(), Vertical::Settlement(sunk), solver);
                for xi in [0.0, 0.31, 0.9, 1.0] {
                    let [one, two] =
                        [line.dimensionless().pressure(xi).unwrap(), other.evaluate(xi, 1.0)];
                    assert!((one / two - 1.0).abs() < 1e-10, "{mu} {theta0} {xi}: {one} {two}");
                    let [one, two] =
                        [round.dimensionless().pressure(xi).unwrap(), rings.evaluate(xi, 1.0)];
                    assert!((one / two - 1.0).abs() < 1e-10, "{mu} {theta0} {xi}: {one} {two}");
                }
                assert!(
                    (line.dimensionless().force() / other.integral(|_| 1.0) - 1.0).abs() < 1e-11
                );
                assert!(
                    (round.dimensionless().force() / (2.0 * PI * rings.integral(|_| 1.0)) - 1.0)
                        .abs()
                        < 1e-11
                );
            }
        }
    }
}

/// `Gamma(1+k/2)/(sqrt(pi) Gamma((1+k)/2))`.
fn smooth_factor(k: f64) -> f64 {
    libm::tgamma(1.0 + 0.5 * k) / (PI.sqrt() * libm::tgamma(0.5 + 0.5 * k))
}

#[test]
fn a_nearly_smooth_flat_punch_has_the_pressure_of_the_smooth_one() {
    // p = P Gamma(1+k/2)/(sqrt(pi) Gamma((1+k)/2) a^k) (a^2 - x^2)^((k-1)/2)
    let k = 0.3;
    let mut before = f64::INFINITY;
    for theta0 in [30.0, 300.0, 3000.0] {
        let contact =
            flat(stated(k, Geometry::Plane, theta0), Vertical::Force(1.0), Solver::default());
        let worst = [0.0, 0.4, 0.7f64]
            .map(|x| {
                contact.pressure(x).unwrap()
                    / (smooth_factor(k) * (1.0 - x * x).powf(0.5 * (k - 1.0)))
                    - 1.0
            })
            .into_iter()
            .fold(0.0f64, |most, error| most.max(error.abs()));
        assert!(worst < 0.2 * before, "{theta0}: {worst}");
        before = worst;
        // The smooth one settles by theta_g P pi smooth_factor/cos(pi k/2): the kernel's first eigenvalue; the layer adds about chi p.
        let grading = contact.problem().foundation().grading().unwrap();
        let smooth = grading.line_response(NU) * PI * smooth_factor(k) / (0.5 * PI * k).cos();
        let excess = contact.settlement() / smooth - 1.0;
        assert!(excess > 0.0 && excess < 2.0 / theta0, "{theta0}: {excess}");
    }
    assert!(before < 1e-3, "{before}");
}

#[test]
fn a_soft_layer_is_a_bed_of_springs() {
    for geometry in [Geometry::Plane, Geometry::Circular] {
        let area = if geometry == Geometry::Circular { PI } else { 2.0 };
        let contact = flat(stated(0.4, geometry, 1e-7), Vertical::Force(1.0), Solver::default());
        assert!((contact.pressure(0.5).unwrap() * area - 1.0).abs() < 1e-6);
    }
}

#[test]
fn little_grading_is_none() {
    // Pressures under a force do not know the datum of the settlement.
    let chi = 0.4;
    for geometry in [Geometry::Plane, Geometry::Circular, Geometry::Pair { inner_half_gap: 0.3 }] {
        let under = |stated: (Foundation, Punch)| {
            solved(
                stated,
                "x^2/8",
                Vertical::Force(0.2),
                Rotational::Moment(0.0),
                Solver::default(),
            )
        };
        let material = Elastic::new(1.0, NU).unwrap();
        let plain = under((
            Foundation::new(material).with_roughness(chi).unwrap(),
            Punch::in_geometry(geometry, 1.0).unwrap(),
        ));
        let mut last = f64::INFINITY;
        for mu in [1e-2, 1e-3, 1e-4] {
            let grading = Grading::new(mu, 1.0).unwrap();
            let graded = under((
                Foundation::graded(grading, NU).unwrap().with_roughness(chi).unwrap(),
                Punch::in_geometry(geometry, 1.0).unwrap(),
            ));
            let error = (graded.dimensionless().pressure(0.4).unwrap()
                / plain.dimensionless().pressure(0.4).unwrap()
                - 1.0)
                .abs();
            assert!(error < 3.0 * mu && error < 0.2 * last, "{geometry:?} {mu}: {error}");
            last = error;
        }
    }
}

/// `int |xi - eta|^-mu p0 deta` over the zones, cut at `xi` and in the middle, where profiles may have a kink.
fn potential(contact: &Contact, xi: f64, mu: f64) -> f64 {
    // d^-mu dd = du/(1-mu) with the distance d and u = d^(1-mu): no singularity is left.
    let power = 1.0 - mu;
    let piece = |[left, right]: [f64; 2]| -> f64 {
        let sign = if left >= xi { 1.0 } else { -1.0 };
        let [near, far] =
            if left >= xi { [left - xi, right - xi] } else { [xi - right, xi - left] };
        let (first, last) = (near.powf(power), far.powf(power));
        let half = 0.5 * (last - first);
        double_exponential(150)
            .map(|node| {
                let distance = (first + half * node.from_left).powf(1.0 / power);
                let at = (xi + sign * distance).clamp(left, right);
                node.weight * half / power * contact.dimensionless().pressure(at).unwrap()
            })
            .sum()
    };
    (contact.dimensionless().zones().iter())
        .flat_map(|&[left, right]| {
            let mut cuts = vec![left, xi.clamp(left, right), 0f64.clamp(left, right), right];
            cuts.sort_by(f64::total_cmp);
            cuts.dedup();
            cuts.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>()
        })
        .map(piece)
        .sum()
}

#[test]
fn free_edges_are_found_on_graded_ground() {
    for (mu, theta0, profile, moment) in [
        (0.3, 5.0, "x^2/2", 0.0),
        (0.6, 20.0, "x^2/2", 0.002),
        (0.2, 2.0, "abs(x)/3", 0.0),
        (0.3, 4.0, "0.1*cos(9*x)", 0.0),
    ] {
        let stated = stated(mu, Geometry::Plane, theta0);
        let chi = depth(&stated);
        let contact = solved(
            stated,
            profile,
            Vertical::Force(0.02),
            Rotational::Moment(moment),
            Solver::default(),
        );
        let left = contact.complementarity().unwrap();
        assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{left:?}");
        let largest = contact.dimensionless().peak_pressure();
        for [left, right] in contact.dimensionless().zones() {
            assert!(right - left < 1.9, "{:?}", contact.dimensionless().zones());
            // Only the ends of the base hold pressure.
            for edge in [left, right].into_iter().filter(|edge| edge.abs() < 1.0) {
                assert!(contact.dimensionless().pressure(edge).unwrap().abs() < 1e-9 * largest);
            }
            for share in [0.03, 0.3, 0.5, 0.81] {
                let xi = left + share * (right - left);
                let height = contact.problem().dimensionless_profile(xi);
                let layer = contact.dimensionless().settlement()
                    - contact.dimensionless().tilt() * xi
                    - height
                    - theta0 * potential(&contact, xi, mu);
                let error = (layer - contact.dimensionless().pressure(xi).unwrap()).abs();
                assert!(
                    error < 1e-8 * largest.max(contact.dimensionless().settlement().abs()),
                    "{mu} {profile} {xi}: {error:e} of {largest}"
                );
            }
        }
        assert!((contact.force() - 0.02).abs() < 1e-12 && chi > 0.0);
    }
}

#[test]
fn crowned_disks_on_graded_ground_balance_their_force() {
    for (mu, exponent) in [(0.3, 1.0), (0.5, 0.6)] {
        let grading = Grading::new(mu, 1.0).unwrap();
        let roughness = Roughness::power(0.05, exponent).unwrap();
        for profile in ["x^2/2", "(x^2 - 0.25)^2"] {
            let stated = (
                Foundation::graded(grading, NU).unwrap().with_roughness(roughness).unwrap(),
                Punch::circular(1.0).unwrap(),
            );
            let contact = solved(
                stated,
                profile,
                Vertical::Force(0.01),
                Rotational::Moment(0.0),
                Solver::default(),
            );
            let left = contact.complementarity().unwrap();
            assert!(left.tension < 1e-9 && left.penetration < 1e-9, "{profile} {left:?}");
            // Rings of pressure from the axis outwards.
            let force: f64 = (contact.dimensionless().zones().iter())
                .filter(|edges| edges[1] > 0.0)
                .map(|&[left, right]| {
                    let (left, half) = (left.max(0.0), 0.5 * (right - left.max(0.0)));
                    double_exponential(80)
                        .map(|node| {
                            let r = left + half * node.from_left;
                            node.weight
                                * half
                                * 2.0
                                * PI
                                * r
                                * contact.dimensionless().pressure(r).unwrap()
                        })
                        .sum::<f64>()
                })
                .sum();
            assert!((force / 0.01 - 1.0).abs() < 1e-8, "{profile}: {force}");
        }
    }
}

#[test]
fn a_tilted_disk_on_graded_ground() {
    let (mu, theta0) = (0.3, 4.0);
    let stated = stated(mu, Geometry::Circular, theta0);
    let kernel = WeberSonine::new(1.0, 1.0, 0.5 * mu).unwrap();
    let unit = solve_adaptive(&kernel, PI * theta0, |r| r, 1e-12).unwrap().solution;
    let moment = 0.01;
    let contact =
        solved(stated, "0", Vertical::Force(1.0), Rotational::Moment(moment), Solver::default());
    // M0 = -alpha0 pi int p1 r^2 dr
    let tilt = -moment / (PI * unit.integral(|r| r));
    assert!((contact.dimensionless().tilt() / tilt - 1.0).abs() < 1e-10);
    let skew = 0.5
        * (contact.dimensionless().pressure(0.6).unwrap()
            - contact.dimensionless().pressure(-0.6).unwrap());
    assert!((skew / (-tilt * unit.evaluate(0.6, 0.6)) - 1.0).abs() < 1e-9);
}
