//! Pressures beside bends and ends of the base on graded ground, as methods state them, without an audit.
//!
//! The truths are of a program that shares no code with this one: collocation in the logarithm of the distance from each bend, places kept as a bend and an exact distance, panels of 20 to 26 nodes; two
//! resolutions agree to `5e-15`.

/// Ground, geometry, base, a place, and the pressure there under the force 1 N without tilt.
type Case = (f64, f64, &'static str, &'static str, f64, f64);

const PLANE: &str = "half_width = 1.0";
const PAIR: &str = "geometry = \"pair\"\nouter_half_width = 1.0\ninner_half_gap = 0.2";
const DISK: &str = "geometry = \"circular\"\nradius = 1.0";

/// What nodes miss of a kernel that is a power shows in some decades of the distance only.
const DECADES: [Case; 5] = [
    (0.4, 0.3, PAIR, "0.3*abs(x - 0.703)", 0.703_000_000_398_107_2, 0.735_752_825_410_854),
    (0.4, 0.3, PLANE, "0.3*abs(x - 0.703)", 0.703_000_000_251_188_6, 0.667_022_496_969_176_3),
    (0.4, 3.0, DISK, "0.1*max(0, abs(x) - 0.3)", 1.778e-8, 0.303_688_810_022_318),
    (0.4, 0.3, DISK, "0.1*max(0, abs(x) - 0.3)", 1e-9, 0.272_631_378_537_498_8),
    (0.3, 3.0, PAIR, "0", 0.999_999_9, 0.720_573_735_227_737),
];

/// Beside a tip heights change within a rounding of the place.
const TIPS: [Case; 2] = [
    (0.7, 0.3, PAIR, "0.3*abs(x - 0.703)^0.3", 0.703_000_000_000_000_1, 0.783_772_352_521_058),
    (0.85, 0.3, PAIR, "0.09*abs(x - 0.703)^0.5", 0.703, 0.621_811_764_414_130),
];

/// By how much pressures are off, each with what is stated.
fn off((exponent, roughness, geometry, profile, place, exact): Case) -> [f64; 2] {
    let text = format!(
        "[foundation]\npoisson_ratio = 0.3\ngrading_exponent = {exponent}\ngrading_modulus = 1.0\nroughness = {roughness}\n[punch]\n{geometry}\nprofile = \"{profile}\"\n[load]\nforce = 1.0\ntilt = 0.0\n[solver]\ncontact = \"bilateral\"\n"
    );
    let contact = shtaerman::file::parse(&text, "test").unwrap().solve().unwrap();
    let found = contact.pressure(place).unwrap();
    println!(
        "{profile} at {place}: {:e}, {:e} stated",
        found - exact,
        contact.error().unwrap().pressure
    );
    [(found - exact).abs(), contact.error().unwrap().pressure]
}

#[test]
fn pressures_of_every_decade_beside_bends_and_ends() {
    for case in DECADES {
        let [off, stated] = off(case);
        assert!(off <= stated && stated < 1e-12, "{case:?}: {off:e}, {stated:e}");
    }
}

#[test]
fn pressures_at_tips_off_the_middle() {
    for case in TIPS {
        let [off, stated] = off(case);
        // Up to three times what is stated there (`docs/src/limits.md`).
        let most = if case.0 > 0.8 { 2e-12 } else { 1e-12 };
        assert!(off <= 3.0 * stated && stated < most, "{case:?}: {off:e}, {stated:e}");
    }
}
