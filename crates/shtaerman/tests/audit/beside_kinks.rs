//! Pressures beside kinks on homogeneous ground, as methods state them without an audit, in every decade of the distance.
//!
//! Errors of collocation are largest within 1e-3 to 1e-8 of a kink, and fall as `exp(-c sqrt(n))`: two differences of it that fell as if there were no kink stated up to 20 times less. The truths are
//! answers to a tolerance of 1e-13.

use shtaerman::Contact;
use shtaerman_random::Random;

const SEED: u64 = 20_261_129;
const CASES: u64 = 60;
/// Rounding of a pressure beside the largest.
const ROUNDING: f64 = 2e-14;

/// A crown with a kink under half of what presses it flat, or more: alone, in a row or as one of two; with the place of its kink.
fn problem(random: &mut Random) -> (String, f64) {
    let geometry = match random.index(3) {
        0 => "half_width = 1.0".to_owned(),
        1 => format!(
            "geometry = \"periodic\"\nhalf_width = 1.0\nperiod = {}",
            random.between(2.1, 6.0)
        ),
        _ => format!(
            "geometry = \"pair\"\nouter_half_width = 1.0\ninner_half_gap = {}",
            random.between(0.1, 0.4)
        ),
    };
    let (kink, height) = (random.between(0.5, 0.8), random.between(-1.0, 1.0));
    let bend = match random.index(3) {
        0 => format!("abs(x - {kink})"),
        1 => format!("max(0, x - {kink})"),
        _ => format!("abs(x - {kink})^3"),
    };
    let (roughness, force) = (random.power(-4.0, -0.5), random.between(0.5, 3.0));
    let text = format!(
        "[foundation]\npoisson_ratio = 0.3\nyoung_modulus = 1.0\nroughness = {roughness}\n[punch]\n{geometry}\nprofile = \"0.3*x^2 + {height}*0.3*{bend}\"\n[load]\nforce = {}\neccentricity = {}\n",
        0.3 * force,
        random.between(-0.1, 0.1)
    );
    (text, kink)
}

fn solve(text: &str, tolerance: f64) -> Option<Contact> {
    let text = format!("{text}[solver]\ntolerance = {tolerance:e}\n");
    shtaerman::file::parse(&text, "test").unwrap().solve().ok()
}

/// What the pressure is off by beside a kink, what may be, and the largest there; none where the problem has no such answers.
fn off(text: &str, kink: f64, truth: f64) -> Option<[f64; 3]> {
    // Fewer digits than any first three resolutions give.
    let (found, exact) = (solve(text, 1e-6)?, solve(text, truth)?);
    let [stated, better] = [&found, &exact].map(|contact| contact.error().unwrap().pressure);
    let (mut largest, mut off) = (0.0f64, 0.0f64);
    for decade in 1..12 {
        let distance = 10f64.powi(-decade);
        for place in [kink - distance, kink + distance, kink - 3.0 * distance] {
            let [one, other] = [&found, &exact].map(|contact| contact.pressure(place).unwrap());
            largest = largest.max(other.abs());
            off = off.max((one - other).abs());
        }
    }
    Some([off, stated + better + ROUNDING * largest, largest])
}

#[test]
fn pressures_beside_kinks_are_as_stated() {
    let mut compared = 0;
    for case in 0..CASES {
        let (text, kink) = problem(&mut Random::of_case(SEED, case));
        let Some([off, allowed, largest]) = off(&text, kink, 1e-13) else { continue };
        compared += usize::from(largest > 0.0);
        assert!(off <= allowed, "case {case}: off by {off:e}, {allowed:e} allowed\n{text}");
    }
    assert!(compared >= 25, "{compared}");
}

#[test]
fn pressures_beside_a_kink_in_a_row() {
    let text = "[foundation]\npoisson_ratio = 0.3911\nyoung_modulus = 1e9\nroughness = 6.524e-10\n[punch]\ngeometry = \"periodic\"\nperiod = 3.973\nhalf_width = 1\nprofile = \"0.001664*x^2 - 0.001059*max(0, x + 0.1761)\"\n[load]\nforce = 165100\neccentricity = -0.04155\n";
    let [off, allowed, largest] = off(text, -0.1761, 1e-14).unwrap();
    assert!(off <= allowed && allowed < 1e-9 * largest, "{off:e}, {allowed:e} of {largest:e}");
}
