//! Waves whose crests lie closer than the nodes of an answer to a tolerance.

use super::loose_tolerances::solve;

const WAVES: &str = r#"[foundation]
young_modulus = 4.3013e9
poisson_ratio = 0.3
roughness = 1.87094e-9
[punch]
half_width = 1.8637
profile = "9.925e-5*(x/1.8637)^2 + AMPLITUDE*cos(NUMBER*x/1.8637 + 2.68313)"
[load]
force = 191837
eccentricity = 0.236038
"#;

fn waves(amplitude: &str, number: &str) -> String {
    WAVES.replace("AMPLITUDE", amplitude).replace("NUMBER", number)
}

/// Nodes hit each wave at another place, and none its crest.
#[test]
fn crests_between_nodes() {
    for (amplitude, number) in [("1e-7", "300"), ("3e-7", "122.095"), ("2e-7", "230")] {
        let text = waves(amplitude, number);
        let fine = solve(&text, None).unwrap();
        for tolerance in [1e-1, 1e-3, 1e-4] {
            let loose = solve(&text, Some(tolerance)).unwrap();
            let (peak, exact) = (loose.peak_pressure(), fine.peak_pressure());
            let stated = loose.error().unwrap().pressure + fine.error().unwrap().pressure;
            assert!((peak - exact).abs() <= stated, "{text} {tolerance}: {peak} {exact} {stated}");
        }
    }
}

/// A coarse answer takes one crest for the highest, where the pressure changes otherwise than at that which is.
#[test]
fn another_crest() {
    let text = waves("3.0932e-8", "122.095");
    let rates = |tolerance: Option<f64>| {
        solve(&text, tolerance).unwrap().sensitivities().unwrap().peak_pressure.unwrap()
    };
    let fine = rates(None);
    for tolerance in [1e-1, 1e-2, 1e-3] {
        let loose = rates(Some(tolerance));
        for (one, exact) in [(loose.force, fine.force), (loose.roughness, fine.roughness)] {
            let (one, exact, stated) = (one.unwrap(), exact.unwrap(), loose.error + fine.error);
            assert!((one / exact - 1.0).abs() <= stated, "{tolerance}: {one} {exact} {stated}");
        }
    }
}
