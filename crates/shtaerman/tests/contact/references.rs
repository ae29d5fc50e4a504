//! Default settings against solutions in 40-digit arithmetic, from very rough to almost smooth.

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
