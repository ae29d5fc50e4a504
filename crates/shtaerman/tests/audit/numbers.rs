//! Numbers that a formula computes from numbers: what rounding takes from them is in the errors that are stated.

use shtaerman::equation::{EquationFile, SolvedEquation};
use shtaerman::{Contact, file};

/// An audited answer with the settlement and force that it states of.
fn solved(head: &str, profile: &str, load: &str) -> Contact {
    let toml = format!("[dimensionless]\n{head}\nprofile = \"{profile}\"\n{load}\ntilt = 0\n");
    file::parse(&toml, "test").unwrap().solve().unwrap().audited().unwrap()
}

/// A layer without body carries `P = int (settlement - f)`: 2 (1.9 - 1/3) where the number of the machine next to 0.1 is 5.6e-18 larger.
#[test]
fn of_a_layer_without_body() {
    for head in ["theta0 = 0", "theta0 = 0\nexponent = 0.5", "theta0 = 0\ngeometry = \"circular\""]
    {
        let contact = solved(head, "1000000.0+0.1+xi^2", "settlement = 1000002");
        // int (1.9 - x^2) over the base, int (1.9 - x^2)^2, and over the disk 2 pi int (1.9 - r^2) r dr
        let truth = if head.contains("exponent") {
            2.0 * (1.9 * 1.9 - 2.0 * 1.9 / 3.0 + 0.2)
        } else if head.contains("circular") {
            2.0 * std::f64::consts::PI * (1.9 / 2.0 - 0.25)
        } else {
            2.0 * (1.9 - 1.0 / 3.0)
        };
        let stated = contact.dimensionless().error().unwrap();
        let off = (contact.dimensionless().force() - truth).abs();
        println!("{head}: {off:e} {stated:?}");
        assert!(off <= stated.force + 4.0 * f64::EPSILON * truth, "{head}: {off:e} {stated:?}");
        assert!(stated.force < 1e-8, "{stated:?}");
    }
}

/// The same base from another level, whose settlement and heights are numbers of the machine.
#[test]
fn of_large_heights() {
    let plain = solved("theta0 = 1", "0.1 + xi^2", "settlement = 2");
    for (profile, settlement) in [
        ("1e6+0.1+xi^2", 1_000_002.0),
        ("1e6+xi^2+0.1", 1_000_002.0),
        ("1e6-0.1+(0.2+xi^2)", 1_000_002.0),
        ("(1e8+0.1-1e8) + xi^2", 2.0),
    ] {
        let contact = solved("theta0 = 1", profile, &format!("settlement = {settlement}"));
        let [one, two] = [&contact, &plain].map(|c| c.dimensionless().error().unwrap());
        let off = (contact.dimensionless().force() - plain.dimensionless().force()).abs();
        println!("{profile}: {off:e} {one:?}");
        assert!(off <= one.force + two.force, "{profile}: {off:e} {one:?}");
        for xi in [-1.0, 0.3, 1.0] {
            let off = (contact.dimensionless().pressure(xi).unwrap()
                - plain.dimensionless().pressure(xi).unwrap())
            .abs();
            assert!(off <= one.pressure + two.pressure, "{profile} {xi}: {off:e} {one:?}");
        }
        assert!(one.pressure < 1e-6, "{one:?}");
    }
}

#[test]
fn of_right_hand_sides() {
    let read = |rhs: &str| {
        let toml = format!(
            "[equation]\nkind = \"second\"\nlambda = 1\nrhs = \"{rhs}\"\n[kernel]\nname = \"log\"\na = 1\n"
        );
        EquationFile::from_bytes(toml.as_bytes(), "test", &[]).unwrap()
    };
    let files = [read("(1e8+0.1-1e8)*x^2"), read("0.1*x^2")];
    let [rounded, plain] = files.each_ref().map(|file| file.equation().solve().unwrap());
    let value = |of: &SolvedEquation, x: f64| of.evaluate(x).unwrap().unwrap();
    for x in [-1.0, 0.2, 1.0] {
        let off = (value(&rounded, x) - value(&plain, x)).abs();
        let stated = rounded.error().solution + plain.error().solution;
        assert!(off <= stated, "{x}: {off:e} {stated:e}");
        assert!(off > 1e-12, "the number is known: the test has no case");
    }
}
