//! Texts broken as hands, editors and transfers break them.

use crate::Random;

/// What is put into a text: signs that mean something to a reader, and some that mean nothing.
const PIECES: &[&str] = &[
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "\"",
    "'",
    "\"\"\"",
    "=",
    ",",
    ";",
    ".",
    "..",
    "-",
    "+",
    "*",
    "**",
    "^",
    "/",
    "<",
    "<=",
    "#",
    "\n",
    "\r\n",
    "\r",
    "\t",
    " ",
    "\\",
    "\\u",
    "e",
    "e9999",
    "1e309",
    "-0",
    "nan",
    "inf",
    "NaN",
    "0x",
    "_",
    "µ",
    "°",
    "²",
    "·",
    "\u{0}",
    "\u{1b}[31m",
    "\u{feff}",
    "\u{202e}",
    "\u{301}",
    "é",
    "𝔵",
    "true",
    "1979-05-27",
    "9223372036854775808",
    "0.1e-400",
    "((((((((((((((((",
    "--",
    "--set",
    "=\"",
    "NaN",
    "Infinity",
    "1/0",
    "x",
    "xi",
    "mm",
    "Pa",
    "m/",
];

/// The text after one to four faults.
pub(crate) fn broken(random: &mut Random, text: &str) -> String {
    let mut signs: Vec<char> = text.chars().collect();
    for _ in 0..=random.below(4) {
        let at = random.below(signs.len() + 1);
        let length = random.below(signs.len() - at + 1).min(1 + random.below(20));
        match random.below(6) {
            0 | 1 => drop(signs.splice(at..at, random.of(PIECES).chars())),
            2 => drop(signs.drain(at..at + length)),
            3 => drop(signs.splice(at..at + length, random.of(PIECES).chars())),
            4 => {
                let copy = signs[at..at + length].to_vec();
                let to = random.below(signs.len() + 1);
                drop(signs.splice(to..to, copy));
            }
            _ => signs.truncate(if random.one_in(4) { at } else { signs.len() }),
        }
    }
    signs.into_iter().collect()
}

/// The bytes of a text; some of them changed, now and then, so that they need not be UTF-8.
pub(crate) fn bytes(random: &mut Random, text: &str) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    if random.one_in(8) && !bytes.is_empty() {
        for _ in 0..=random.below(3) {
            let at = random.below(bytes.len());
            bytes[at] = random.bits() as u8;
        }
    }
    bytes
}
