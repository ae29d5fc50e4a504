//! What a user wrote, as a message may show it.

/// Longest run of characters without a blank that is shown, and what is left of a longer one on both sides.
const LONGEST_WORD: usize = 400;
const KEPT: [usize; 2] = [200, 60];

/// Longest text that is shown.
const LONGEST_TEXT: usize = 4000;

/// A text on one line of a message: what a terminal would obey is written out (`\u{1b}`), and long words and texts are shortened.
///
/// ```
/// use shtaerman_input::legible;
/// assert_eq!(legible("key \u{1b}[31m\n"), "key \\u{1b}[31m\\n");
/// assert_eq!(legible("5 mm"), "5 mm");
/// ```
#[must_use]
pub fn legible(text: &str) -> String {
    let mut shown = String::with_capacity(text.len().min(LONGEST_TEXT));
    for (count, word) in text.split_inclusive(' ').enumerate() {
        if shown.len() + word.len().min(LONGEST_WORD) > LONGEST_TEXT && count > 0 {
            shown.push('…');
            break;
        }
        let length = word.chars().count();
        if length > LONGEST_WORD {
            shown.extend(word.chars().take(KEPT[0]).flat_map(written));
            shown.push('…');
            shown.extend(word.chars().skip(length - KEPT[1]).flat_map(written));
        } else {
            shown.extend(word.chars().flat_map(written));
        }
    }
    shown
}

/// The beginning of a text of more than `most` characters, and all of a shorter one, as [`legible`] shows it.
#[must_use]
pub fn shortened(text: &str, most: usize) -> String {
    let mut shown: String = text.chars().take(most).flat_map(written).collect();
    if text.chars().nth(most).is_some() {
        shown.push('…');
    }
    shown
}

/// A character, or its name where a terminal would obey or hide it.
fn written(sign: char) -> impl Iterator<Item = char> {
    let is_hidden = sign.is_control()
        // Marks of no width, of the direction of writing, and line separators.
        || matches!(sign, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}');
    let escaped = is_hidden.then(|| sign.escape_default());
    let plain = (!is_hidden).then_some(sign);
    escaped.into_iter().flatten().chain(plain)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_a_terminal_obeys_is_left() {
        let hostile: String = ('\0'..='\u{a0}').chain("\u{202e}\u{200b}\u{feff}".chars()).collect();
        let shown = legible(&hostile);
        assert!(!shown.chars().any(char::is_control), "{shown:?}");
        assert!(shown.contains("\\u{1b}") && shown.contains("\\n") && shown.contains("\\u{9b}"));
        assert!(shown.contains("\\u{202e}\\u{200b}\\u{feff}"));
        assert_eq!(legible(&shown), shown);
        assert_eq!(legible("2 µm  und \"ß\" \\ '"), "2 µm  und \"ß\" \\ '");
    }

    #[test]
    fn long_texts_are_shortened() {
        let name = "ä".repeat(50_000);
        let shown = legible(&format!("{name}: cannot be read"));
        assert!(shown.chars().count() < 300 && shown.ends_with("ä: cannot be read"), "{shown}");
        let text = legible(&"a b ".repeat(50_000));
        assert!(text.len() < 4100 && text.ends_with('…'), "{text}");
        assert!(legible(&"\u{1b}".repeat(100_000)).len() < 2000);
        let path = "/folder".repeat(50);
        assert_eq!(legible(&path), path);
        assert_eq!(shortened("abc", 3), "abc");
        assert_eq!(shortened("ab\ncd", 3), "ab\\n…");
    }
}
