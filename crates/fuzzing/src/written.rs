//! Numbers, quantities and formulas as people write them.

use shtaerman_input::expression::function_names;

use crate::Random;

/// Numbers at which something changes.
const SPECIAL: &[&str] = &[
    "0",
    "-0.0",
    "1",
    "-1",
    "0.5",
    "2",
    "3",
    "1e-300",
    "1e300",
    "5e-324",
    "1e308",
    "1.7976931348623157e308",
    "pi",
    "e",
    "tau",
    "1e-16",
    "0.1",
    "-2.5",
    "10",
    "1e5",
    ".5",
    "5.",
    "1E-3",
    "100000000000000000000",
];

/// A number as text.
pub(crate) fn number(random: &mut Random) -> String {
    match random.below(6) {
        0 | 1 => random.of(SPECIAL).to_owned(),
        2 => format!("{:.3}", random.between(-3.0, 3.0)),
        3 => format!("{}", random.below(20)),
        4 => format!("{:e}", random.power(-20.0, 20.0)),
        _ => format!("{:e}", f64::from_bits(random.bits())),
    }
}

/// A formula in variables of these names, with about `size` operations at most.
pub(crate) fn formula(random: &mut Random, variables: &[&str], size: usize) -> String {
    if size == 0 || random.one_in(8) {
        return if random.one_in(2) { random.of(variables).to_owned() } else { number(random) };
    }
    let rest = size / 2;
    let part = |random: &mut Random| formula(random, variables, rest);
    match random.below(12) {
        0 => format!("({})", formula(random, variables, size - 1)),
        1 => format!("-{}", formula(random, variables, size - 1)),
        2..=7 => {
            let sign = random.of(&["+", "-", "*", "/", "^", "**", "<", ">=", " + ", " * "]);
            format!("({}){sign}({})", part(random), part(random))
        }
        _ => {
            let names: Vec<&str> = function_names().collect();
            let name = random.of(&names);
            let count = match name {
                "hypot" | "atan2" | "pow" => 2,
                "clamp" | "where" => 3,
                "min" | "max" => 2 + random.below(3),
                _ => 1,
            };
            let parts: Vec<String> = (0..count).map(|_| part(random)).collect();
            format!("{name}({})", parts.join(", "))
        }
    }
}

/// Units with and without prefixes.
const UNITS: &[&str] = &[
    "m", "mm", "um", "µm", "nm", "km", "in", "ft", "yd", "mil", "thou", "uin", "N", "kN", "MN",
    "dyn", "kgf", "lbf", "ozf", "kip", "Pa", "kPa", "MPa", "GPa", "hPa", "bar", "mbar", "atm",
    "psi", "ksi", "Msi", "psf", "g", "kg", "t", "s", "ms", "J", "kJ", "rad", "mrad", "urad", "deg",
    "°", "cm", "dm", "pm", "TPa",
];

/// A quantity as text: a number with a product of units.
pub(crate) fn quantity(random: &mut Random) -> String {
    let mut text = number(random);
    text += random.of(&["", " ", "  ", " "]);
    for index in 0..random.below(4) {
        if index > 0 {
            text += random.of(&[" ", "*", "·", "/", "/(", " / "]);
        }
        text += random.of(UNITS);
        text += random.of(&["", "", "", "^2", "**2", "²", "^-1", "^9", "^-9", "^(2)", ")"]);
    }
    text
}
