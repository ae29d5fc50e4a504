//! Default settings against solutions in 40-digit arithmetic, from very rough to almost smooth, and against one of several zones by another rule.

use shtaerman::{Foundation, Load, Problem, Profile, Punch, Rotational, Solver, Vertical};

/// `lambda f | int phi | int x phi | phi(-1) | phi(0.3) | phi(1)`, made by a separate program; its heading tells how.
const REFERENCES: &str = include_str!("../../../fredholm/tests/data/collocation_logarithm.txt");

fn response(theta0: &str, right_hand_side: &str) -> [f64; 5] {
    let mut rows = REFERENCES.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
    let row =
        rows.find(|row| row.len() == 7 && row[0] == theta0 && row[1] == right_hand_side).unwrap();
    [2, 3, 4, 5, 6].map(|column| row[column].parse().unwrap())
}

#[test]
fn twelve_digits_at_every_roughness() {
    let (force, moment) = (1.7, -0.31);
    for theta0 in ["1e-3", "1", "60", "1e4", "1e5"] {
        for (name, formula) in [("x2", "xi^2"), ("exp", "exp(xi)")] {
            let [level, tilted, free] = ["1", "x", name].map(|side| response(theta0, side));
            let settlement = (force + free[0]) / level[0];
            let tilt = -(moment + free[1]) / tilted[1];
            let load = Load::new(Vertical::Force(force), Rotational::Moment(moment)).unwrap();
            let (foundation, punch) = (
                Foundation::dimensionless(theta0.parse().unwrap()).unwrap(),
                Punch::new(1.0).unwrap(),
            );
            let profile = Profile::expression(formula).unwrap();
            let contact = Problem::new(foundation, punch.with_profile(profile), load)
                .unwrap()
                .with_solver(Solver::bilateral())
                .solve()
                .unwrap();

            let case = format!("theta0 = {theta0}, {formula}");
            assert!(
                (contact.dimensionless().settlement() / settlement - 1.0).abs() < 1e-12,
                "{case}: settlement"
            );
            assert!((contact.dimensionless().tilt() / tilt - 1.0).abs() < 1e-12, "{case}: tilt");
            let exact = [2, 3, 4].map(|i| settlement * level[i] - tilt * tilted[i] - free[i]);
            let largest = exact.into_iter().fold(0.0f64, |most, p| most.max(p.abs()));
            let tolerance = if theta0 == "1e5" { 1e-11 } else { 1e-12 };
            let stated = contact.dimensionless().error().unwrap().pressure;
            for (xi, exact) in [-1.0, 0.3, 1.0].into_iter().zip(exact) {
                let error = (contact.dimensionless().pressure(xi).unwrap() - exact).abs();
                assert!(
                    error <= tolerance * largest && error <= stated,
                    "{case}, xi = {xi}: {error:e}"
                );
            }
        }
    }
}

#[test]
fn zones_by_a_rule_of_their_own() {
    // By Kress' rule with 240 nodes a zone and edges of its own, in another language.
    let profile = Profile::expression("3*(0.4*xi^2 + 0.1*cos(23*xi+0.4))").unwrap();
    let punch = Punch::new(1.0).unwrap().with_profile(profile);
    let load = Load::new(Vertical::Force(1.0), Rotational::Moment(0.1)).unwrap();
    let foundation = Foundation::dimensionless(0.5).unwrap();
    let contact = Problem::new(foundation, punch, load).unwrap().solve().unwrap();
    let found = contact.dimensionless();
    let (zones, error) = (found.zones(), found.error().unwrap());
    let edges = error.zones.unwrap();
    for (value, exact, stated) in [
        (found.settlement(), 1.316_596_649_734_666_2, error.settlement),
        (found.tilt(), -0.269_029_783_377_773_3, error.tilt),
        (zones[0][1], -0.903_283_016_182_785, edges),
        (zones[1][0], -0.796_427_759_465_558_3, edges),
        (found.pressure(-0.97).unwrap(), 0.179_993_382_878_006, error.pressure),
        (found.pressure(-0.93).unwrap(), 0.122_054_414_169_489_6, error.pressure),
    ] {
        assert!(stated < 2e-12, "{stated:e}");
        let off = (value - exact).abs();
        assert!(off <= stated + 4e-15, "{value} {exact}: {off:e}, {stated:e} stated");
    }
}
