//! Sharp tips on panels, most of them of a hostile review in which all resolutions ended at the same panel, agreed, and stated up to 26 times too little. The numbers are those of collocation (`method.name`
//! is `sinc`), which has nodes of its own.

use shtaerman::Contact;

use super::loose_tolerances::{agree, solve};

/// The largest pressure to a tolerance, and what is known of it relative to it.
#[track_caller]
fn peak_is(text: &str, tolerance: Option<f64>, [exact, known]: [f64; 2], least: f64) {
    let contact = solve(text, tolerance).unwrap();
    let (peak, stated) = (contact.peak_pressure(), contact.error().unwrap().pressure);
    assert!((peak - exact).abs() <= stated + known, "{peak} {exact} {stated}");
    assert!(stated <= least * exact, "{peak} {stated}");
}

/// The profile itself goes on from a tip as a power of the distance, and the layer is a hundredth of its height.
#[test]
fn a_tip_under_a_layer_that_bends() {
    peak_is(SHARP, None, [603_932.702_524_252, 6e-7], 1e-10);
    agree(SHARP, 1e-2);
    agree(SHARP, 1e-8);
}

/// Beside a tip heights are rounded far less than at it.
#[test]
fn tips_away_from_the_middle() {
    for tolerance in [None, Some(1e-8), Some(1e-7), Some(1e-4)] {
        let least = tolerance.unwrap_or(1e-9);
        peak_is(ON_A_PAIR, tolerance, [1_999_801_374.119_84, 3.3e-3], least);
        peak_is(TWO_TIPS, tolerance, [2_834_675.711_721_21, 1e-6], least);
        peak_is(ON_GRADED_GROUND, tolerance, [75_196.100_197_996, 2.5e-6], least);
    }
}

/// The power 0.05 of the shortest length that numbers allow is a sixth of that of the base: what it hides is stated, and other panels agree within that.
#[test]
fn a_tip_sharper_than_numbers_show() {
    let known = |text: &str| {
        let contact = solve(text, None).unwrap();
        (contact.peak_pressure(), contact.error().unwrap().pressure)
    };
    let (peak, stated) = known(SHARPEST);
    let (other, own) = known(&SHARPEST.replace("^0.5", "^0.5 + 1e-40*abs(x-0.1)"));
    assert!((other - peak).abs() <= stated + own, "{peak} {other} {stated}");
    assert!(stated < 1e-3 * peak, "{peak} {stated}");
}

/// A wave with a gap is solved from the middle of that, and its mirror image from elsewhere: beyond the period places are rounded twice as much, and the tip was 5e-6 less deep.
#[test]
fn a_tip_beyond_the_period() {
    let [contact, image] =
        [WAVE, &WAVE.replace("(x)", "(0-x)")].map(|text| solve(text, None).unwrap());
    let [own, other] = [&contact, &image].map(|contact| contact.error().unwrap().pressure);
    let (one, two) = (contact.peak_pressure(), image.peak_pressure());
    assert!((one - two).abs() <= own + other, "{one} {two} {own} {other}");
    assert!(own + other < 1e-7 * one, "{one} {own} {other}");
}

/// Where a formula has its tip between two numbers the pressure under it is larger than at any: what an audit states of the largest pressure counts that, on all grounds and layers.
#[test]
fn a_tip_between_two_numbers() {
    let graded = PLANE.replace("young_modulus", "grading_exponent = 0.3\ngrading_modulus");
    let bent = PLANE.replace("1e-12", "{ coefficient = 6e-8, exponent = 0.4 }");
    for (text, variable, tip) in [
        (PLANE, "x", "abs(PLACE)"),
        (&graded, "x", "abs(PLACE)"),
        (&bent, "x", "abs(PLACE)"),
        (DISK, "r", "abs(PLACE)"),
        (ROW, "x", "abs(sin(pi*(PLACE)/2))"),
    ] {
        for power in [0.2, 0.3, 0.5, 0.7] {
            let under = |place: &str| {
                let tip = tip.replace("PLACE", &format!("{variable} - {place}"));
                let text = text.replace("TIP", &format!("{tip}^{power}"));
                solve(&text, None).unwrap().with_audit()
            };
            // The sum of both lies between 0.3 and the next number.
            let [at, between] = ["0.30000000000000004", "0.1 - 0.2"].map(under);
            let [exact, peak] = [&at, &between].map(Contact::peak_pressure);
            let [known, stated] =
                [&at, &between].map(|contact| contact.error().unwrap().peak_pressure.unwrap());
            let off = (exact - peak).abs();
            assert!(off <= known + stated, "{text} {power}: {off:e} {known:e} {stated:e}");
            let at_numbers = [&at, &between].map(|contact| contact.error().unwrap().pressure);
            let most = 2.0 * (off + known + at_numbers[1]);
            assert!(stated <= most, "idle: {text} {power}: {off:e} {stated:e}");
            // Were it not counted, the sharpest would be off by more than what holds at numbers.
            assert!(power > 0.2 || off > 2.0 * (at_numbers[0] + at_numbers[1]), "{text} {power}");
        }
    }
}

/// A tip at the foot of a step, where contact ends: at the number of both the height is the tip's, and the solution begins at the next. Hardly moved, the tip lies between numbers that all have its side.
#[test]
fn the_foot_of_a_jump() {
    for (power, share) in [(0.3, 0.5), (0.4, 1.0), (0.2, 0.05)] {
        let at = |foot: &str| {
            let profile = format!("1e-3*where(x < {foot}, {share}, abs(x - {foot})^{power})");
            let text = PLANE.replace("1e-3*TIP", &profile);
            solve(&text, None).unwrap().with_audit()
        };
        let [foot, moved] = ["0.25", "(0.25 - 2^-40)"].map(at);
        let [peak, exact] = [&foot, &moved].map(Contact::peak_pressure);
        let [stated, known] =
            [&foot, &moved].map(|contact| contact.error().unwrap().peak_pressure.unwrap());
        // The pressure changes by less than its size for each unit of the place.
        let known = known + 2f64.powi(-39) * exact;
        assert!((peak - exact).abs() <= stated + known, "{power}: {peak} {exact} {stated} {known}");
        assert!(stated <= 2.0 * ((exact - peak).abs() + known), "{power}: {stated} {known}");
    }
}

/// A base that touches between two numbers only, 17 times as hard as where the zone is: what that carries is nothing.
#[test]
fn a_gap_that_touches_between_numbers() {
    let contact = solve(HIDDEN, None).unwrap().with_audit();
    let bound = contact.peak_pressure() + contact.error().unwrap().peak_pressure.unwrap();
    // Where the base has no height the layer gives all of the settlement, but for what the force of the zone adds: 0.854 N/m over the modulus.
    let exact = contact.settlement() / 1e-6;
    assert!(contact.peak_pressure() < 0.1 * exact && bound >= 0.999 * exact, "{bound} {exact}");
    assert!(bound < 1.001 * exact, "{bound} {exact}");
}

const HIDDEN: &str = r#"[foundation]
young_modulus = 1e9
poisson_ratio = 0.3
roughness = 1e-6
[punch]
half_width = 1
profile = "min(1e-3*abs(x - 0.1 - 0.2)^0.05, 0.00011892058818577952 + 1e-3*(x+0.5)^2)"
[load]
settlement = 0.00012635312494739073
tilt = 0
"#;

/// Beside a jump, and where contact ends at one, nothing of its height counts.
#[test]
fn no_jump_is_a_tip() {
    for jump in ["step(x - 0.1 - 0.2)", "step(0.1 + 0.2 - x)", "step(x - 0.25)", "(x > 0.7)"] {
        for share in [1e-4, 1.0] {
            let profile = format!("5e-4*x^2 + {share}*1e-3*{jump}");
            let text = PLANE.replace("1e-3*TIP + 5e-4*x^2", &profile);
            let contact = solve(&text, None).unwrap().with_audit();
            let stated = contact.error().unwrap();
            let peak = stated.peak_pressure.unwrap();
            assert!(peak <= 2.0 * stated.pressure, "{profile}: {peak:e} {:e}", stated.pressure);
        }
    }
}

const PLANE: &str = r#"[foundation]
young_modulus = 1e9
poisson_ratio = 0.3
roughness = 1e-12
[punch]
half_width = 1.0
profile = "1e-3*TIP + 5e-4*x^2"
[load]
force = 2e5
moment = 0
"#;

const DISK: &str = r#"[foundation]
young_modulus = 1e9
poisson_ratio = 0.3
roughness = 1e-11
[punch]
geometry = "circular"
radius = 1.0
profile = "1e-3*TIP + 5e-4*r^2"
[load]
force = 2e5
moment = 0
"#;

const ROW: &str = r#"[foundation]
young_modulus = 1e9
poisson_ratio = 0.3
roughness = 1e-12
[punch]
geometry = "periodic"
period = 2.0
profile = "1e-3*TIP + 1e-4*cos(pi*x)"
[load]
force = 2e5
tilt = 0
"#;

const WAVE: &str = r#"[foundation]
young_modulus = 8152244861.63938
poisson_ratio = 0.3
roughness = 5.409211595531595e-16
[punch]
geometry = "periodic"
period = 2.0
profile = "5.530827634357385e-05*cos(pi*(x) + 4.129) + 0.00014769601688795526*abs(sin(pi*((x)-0.7469916718292268)/2.0))^0.9688154043891274 + 1.9768052441395283e-05*abs(sin(pi*((x)-0.4013997690709933)/2.0))^0.5"
[load]
force = 436319.3042387378
tilt = 0
"#;

const SHARP: &str = r#"[foundation]
young_modulus = 2149724286.317935
poisson_ratio = 0.3
roughness = { coefficient = 7.0534231914577675e-12, exponent = 0.5529366087045061 }
[punch]
geometry = "pair"
outer_half_width = 0.5
inner_half_gap = 0.06678457611184033
profile = "8.102998189403375e-06*(((abs(x)-0.28339228805592015)/0.5)^2 + 0.7180998294280827*abs((abs(x)-0.28339228805592015)/0.5)^0.7)"
[load]
settlement = 1.8488751726990473e-06
moment = 0.0
"#;

const ON_A_PAIR: &str = r#"[foundation]
young_modulus = 48114651436.64269
poisson_ratio = 0.3
roughness = 1.0197712865029675e-14
[punch]
geometry = "pair"
outer_half_width = 0.7
inner_half_gap = 0.21
profile = "0.0005760855086324983*(x/0.7)^2 + 6.674357861908549e-05*abs((x-(0.6993222730910581))/0.7)^0.15 + 6.318818696900035e-08*abs((x-(-0.6982727574804368))/0.7)^0.05"
[load]
force = 47239068.02807377
tilt = 0.0
"#;

const TWO_TIPS: &str = r#"[foundation]
young_modulus = 893948957.299443
poisson_ratio = 0.3
roughness = 7.453384654825528e-14
[punch]
half_width = 0.3
profile = "1.3234789730240862e-05*(x/0.3)^2 + 4.1196070520354065e-07*abs((x-(0.29995290489615684))/0.3)^0.3 + -3.611052998261493e-08*abs((x-(-0.2995647024655995))/0.3)^0.1"
[load]
force = 42337.06336881449
tilt = 0.0
"#;

const ON_GRADED_GROUND: &str = r#"[foundation]
grading_exponent = 0.34679126144825373
grading_modulus = 403908888.2980746
poisson_ratio = 0.3
roughness = 6.020741823261408e-11
[punch]
geometry = "pair"
outer_half_width = 0.3
inner_half_gap = 0.10424049797613927
profile = "1.2114104599727862e-05*((0-x)/0.3)^2 + 9.763480447411001e-07*abs(((0-x)-0.298935904594796)/0.3)^0.2 + -7.45611487221731e-08*abs(((0-x)-0.2999996473154719)/0.3)^0.1 + -5.069252246965243e-06*abs(((0-x)+0.19188675804417982)/0.3)^0.3"
[load]
force = 6485.987282395669
tilt = -0.0
"#;

const SHARPEST: &str = r#"[foundation]
young_modulus = 172799865.75320807
poisson_ratio = 0.3
roughness = { coefficient = 2.595979115415586e-11, exponent = 0.4 }
[punch]
half_width = 1.902270273943314
profile = "0.0005427008623519918*(x/1.902270273943314)^2 + 3.6861294148684514e-05*abs((x-0.0)/1.902270273943314)^0.05 + 0.00013675976180776406*abs((x-1.1889189212145712)/1.902270273943314)^0.5"
[load]
force = 10405.76030673831
tilt = 0.0
"#;
