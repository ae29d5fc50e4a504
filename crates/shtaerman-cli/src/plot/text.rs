//! Measuring, cutting and wrapping text.

/// Advance widths of the printable ASCII characters in `DejaVu` Sans, in 1/2048 of the font size.
///
/// The PNG is drawn with this font, and an SVG names it first; common substitutes are narrower.
#[rustfmt::skip]
const ASCII_ADVANCES: [u16; 95] = [
    651, 821, 942, 1716, 1303, 1946, 1597, 563, 799, 799, 1024, 1716, 651, 739, 651, 690,
    1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 690, 690, 1716, 1716, 1716, 1087,
    2048, 1401, 1405, 1430, 1577, 1294, 1178, 1587, 1540, 604, 604, 1343, 1141, 1767, 1532, 1612,
    1235, 1612, 1423, 1300, 1251, 1499, 1401, 2025, 1403, 1251, 1403, 799, 690, 799, 1716, 1024,
    1024, 1255, 1300, 1126, 1300, 1260, 721, 1300, 1298, 569, 569, 1186, 569, 1995, 1298, 1253,
    1300, 1300, 842, 1067, 803, 1298, 1212, 1675, 1212, 1212, 1075, 1303, 690, 1303, 1716,
];

fn advance(character: char) -> u16 {
    let code = character as u32;
    match character {
        ' '..='~' => ASCII_ADVANCES[(code - 32) as usize],
        '¹' | '²' | '³' | '⁰'..='⁹' | '₀'..='₉' => 821,
        '⁻' => 1081,
        '·' => 651,
        '×' | '±' | 'Φ' | 'φ' | 'Ψ' | 'ψ' | 'Ω' | 'ω' => 1716,
        _ if code < 0x400 => 1350,
        _ => 2048,
    }
}

/// Width of a line of text.
pub(super) fn width(text: &str, size: u32) -> f64 {
    let units: f64 = text.chars().map(|character| f64::from(advance(character))).sum();
    units * f64::from(size) / 2048.0
}

/// The text on one line, without characters that XML forbids, its numbers as they are printed: minus signs and powers of ten.
pub(super) fn clean(text: &str) -> String {
    let words = legal(text);
    let printed: Vec<String> = words.split(' ').map(printed).collect();
    printed.join(" ")
}

/// A word with its numbers as they are printed.
fn printed(word: &str) -> String {
    let opening = word.len() - word.trim_start_matches(['(', '[', '±', '=']).len();
    let (before, rest) = word.split_at(opening);
    let closing = rest.trim_end_matches([',', ';', ':', ')', ']', '.']).len();
    let (number, after) = rest.split_at(closing);
    // Words such as `inf` are numbers to a parser.
    if number.parse::<f64>().is_err() || !number.ends_with(|c: char| c.is_ascii_digit()) {
        return word.to_owned();
    }
    let number = match number.split_once(['e', 'E']) {
        Some((digits, exponent)) => {
            format!("{digits}·10{}", superscript(exponent.parse().unwrap_or(0)))
        }
        None => number.to_owned(),
    };
    format!("{before}{}{after}", number.replace('-', "−"))
}

fn legal(text: &str) -> String {
    let allowed = |c: &char| !matches!(c, '\u{fffe}' | '\u{ffff}');
    let spaced = text.chars().filter(allowed).map(|c| if c.is_control() { ' ' } else { c });
    let spaced: String = spaced.collect();
    spaced.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The text, cut at its end with an ellipsis where it is wider than `room`.
pub(super) fn fit(text: &str, size: u32, room: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let mut left = room - width("…", size);
    let mut cut = String::new();
    for character in text.chars() {
        left -= f64::from(advance(character)) * f64::from(size) / 2048.0;
        if left < 0.0 {
            break;
        }
        cut.push(character);
    }
    format!("{}…", cut.trim_end())
}

/// A label such as `pressure [MPa]`, cut before its unit where it is wider than `room`.
pub(super) fn fit_label(label: &str, size: u32, room: f64) -> String {
    let Some((name, unit)) = label.rsplit_once(" [") else { return fit(label, size, room) };
    let unit = format!("[{unit}");
    let left = room - width(&format!(" {unit}"), size);
    if width(label, size) <= room {
        return label.to_owned();
    }
    // Whole words, or letters where not even one has room.
    let mut words: Vec<&str> = name.split(' ').collect();
    while words.len() > 1 {
        words.pop();
        let cut = format!("{} …", words.join(" "));
        if width(&cut, size) <= left {
            return format!("{cut} {unit}");
        }
    }
    match fit(name, size, left) {
        cut if cut == "…" || left <= 0.0 => fit(&unit, size, room),
        cut => format!("{cut} {unit}"),
    }
}

/// The text broken between words into at most `lines` lines no wider than `room`; what is equal stays together.
pub(super) fn wrap(text: &str, size: u32, room: f64, lines: usize) -> Vec<String> {
    let mut wrapped: Vec<String> = Vec::new();
    let mut line = String::new();
    let mut words = together(text).into_iter();
    while let Some(word) = words.next() {
        let longer = if line.is_empty() { word.clone() } else { format!("{line} {word}") };
        if line.is_empty() || width(&longer, size) <= room {
            line = longer;
        } else if wrapped.len() + 1 < lines {
            wrapped.push(fit(&line, size, room));
            line = word;
        } else {
            line = format!("{longer} …");
            words.by_ref().for_each(drop);
        }
    }
    if !line.is_empty() && lines > 0 {
        wrapped.push(fit(&line, size, room));
    }
    wrapped
}

/// The words of a text, of which `λ = 0.5` is one, and `5 MPa`.
fn together(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    for word in text.split_whitespace() {
        let stays = |last: &str| word == "=" || last.ends_with(" =") || is_number(last);
        match words.last_mut().filter(|last| stays(last)) {
            Some(last) => {
                last.push(' ');
                last.push_str(word);
            }
            None => words.push(word.to_owned()),
        }
    }
    words
}

/// The same of clauses between semicolons, of which the last are left out where they have no room: none is cut in its middle, unless it is the only one.
pub(super) fn wrap_clauses(text: &str, size: u32, room: f64, lines: usize) -> Vec<String> {
    let mut kept = text;
    loop {
        let wrapped = wrap(kept, size, room, lines);
        match kept.rsplit_once("; ") {
            Some((before, _)) if is_cut(&wrapped) => kept = before,
            _ => return wrapped,
        }
    }
}

/// Whether wrapped text lost its end, or a word that is longer than a line its own.
pub(super) fn is_cut(wrapped: &[String]) -> bool {
    wrapped.iter().any(|line| line.ends_with('…'))
}

/// An integer in raised digits.
pub(super) fn superscript(exponent: i32) -> String {
    let raise = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        digit => char::from_u32(digit as u32 - '0' as u32 + 0x2070).unwrap_or(digit),
    };
    exponent.to_string().chars().map(raise).collect()
}

/// A round number, such as 1200, 0.25 or 5·10⁶.
pub(super) fn round_number(value: f64) -> String {
    if (1e-3..1e5).contains(&value) || value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let text = format!("{value:e}");
    let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    format!("{digits}·10{}", superscript(exponent.parse().unwrap_or(0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapped_lines_fit_and_say_that_they_were_cut() {
        let text = "a punch with a flat base pressed into a rough body ".repeat(10);
        let lines = wrap(&text, 12, 200.0, 3);
        assert_eq!(lines.len(), 3);
        assert!(lines.iter().all(|line| width(line, 12) <= 200.0));
        assert!(lines[2].ends_with('…'));
        assert_eq!(wrap("short", 12, 200.0, 3), ["short"]);
        assert!(wrap("", 12, 200.0, 3).is_empty());
    }

    #[test]
    fn what_is_equal_stays_together_and_clauses_are_whole() {
        let text = "kernel of the first kind, λ = 0.5; error of φ at most 1e-9";
        let lines = wrap(text, 12, 175.0, 4);
        assert_eq!(lines[..2], ["kernel of the first kind,", "λ = 0.5; error of φ at most"]);
        assert_eq!(wrap_clauses(text, 12, 175.0, 2), ["kernel of the first kind,", "λ = 0.5"]);
        assert_eq!(wrap_clauses(text, 12, 2000.0, 2), [text]);
        assert!(is_cut(&wrap_clauses("a clause that is long", 12, 60.0, 1)));
    }

    #[test]
    fn a_label_keeps_its_unit() {
        let label = "von Mises stress [MPa]";
        assert_eq!(fit_label(label, 12, 500.0), label);
        let cut = fit_label(label, 12, 100.0);
        assert_eq!(cut, "von … [MPa]");
        assert!(width(&cut, 12) <= 100.0);
        assert_eq!(fit_label("pressure [MPa]", 12, 70.0), "pr… [MPa]");
        assert_eq!(fit_label(label, 12, 45.0), "[MPa]");
    }

    #[test]
    fn cleaning_keeps_text_legal_in_xml() {
        assert_eq!(clean(" a\u{0}b\n\tc\u{ffff} "), "a b c");
    }

    #[test]
    fn numbers_are_printed() {
        let said = "at x = -5 mm (1.5e-16), f-2, -x, 2e5; E-3 case-1e5 1e";
        assert_eq!(clean(said), "at x = −5 mm (1.5·10⁻¹⁶), f-2, -x, 2·10⁵; E-3 case-1e5 1e");
    }

    #[test]
    fn exponents_are_raised() {
        assert_eq!(superscript(-12), "⁻¹²");
        assert_eq!(superscript(304), "³⁰⁴");
        assert_eq!([1200.0, 0.25, 5e6].map(round_number), ["1200", "0.25", "5·10⁶"]);
    }
}
