//! Text for people: lines that fit a terminal, and its colours.

use anstyle::{AnsiColor, Style};

/// Characters of a line.
pub(crate) const WIDTH: usize = 80;
/// What lines begin with that go on from the line before.
const INDENT: &str = "    ";
/// What is to be copied is never broken.
const COPIED: &str = "set: ";

/// The text with its long lines broken between words; rows of tables, which begin with a blank and keep to the width themselves, and what is to be copied stay.
#[must_use]
pub(crate) fn folded(text: &str) -> String {
    let mut page = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let is_kept = line.starts_with(' ') || line.starts_with(COPIED);
        if is_kept || line.trim_end().chars().count() <= WIDTH {
            page.push_str(line);
        } else {
            fold(line.trim_end(), &mut page);
            page.push('\n');
        }
    }
    page
}

fn fold(line: &str, page: &mut String) {
    let mut taken = 0;
    for word in line.split(' ') {
        let length = word.chars().count();
        if taken > 0 && taken + 1 + length > WIDTH {
            page.push('\n');
            page.push_str(INDENT);
            taken = INDENT.len();
        } else if taken > 0 {
            page.push(' ');
            taken += 1;
        }
        page.push_str(word);
        taken += length;
    }
}

/// The text as a terminal shows it in colours: its first line and words before a colon stand out, warnings are yellow, notes beside values are dim.
#[must_use]
pub(crate) fn painted(text: &str) -> String {
    let bold = Style::new().bold();
    let yellow = AnsiColor::Yellow.on_default().bold();
    let mut page = String::with_capacity(2 * text.len());
    for (index, line) in text.split_inclusive('\n').enumerate() {
        let (words, end) = match line.strip_suffix('\n') {
            Some(words) => (words, "\n"),
            None => (line, ""),
        };
        let shown = if words.is_empty() {
            String::new()
        } else if index == 0 {
            styled(bold, words)
        } else if words.starts_with(' ') {
            row(words)
        } else {
            let style = if words.starts_with("warning: ") { yellow } else { bold };
            match words.split_once(": ") {
                Some((name, rest)) if name.chars().count() < WIDTH / 2 => {
                    format!("{}: {rest}", styled(style, name))
                }
                _ => words.to_owned(),
            }
        };
        page.push_str(&shown);
        page.push_str(end);
    }
    page
}

/// A row of a table of names, values and notes: what stands behind the value is dim.
fn row(words: &str) -> String {
    let indent = words.len() - words.trim_start().len();
    let Some((value, note)) = third(&words[indent..]) else { return words.to_owned() };
    let at = indent + value + note;
    format!("{}{}", &words[..at], styled(Style::new().dimmed(), &words[at..]))
}

/// Where the third part of a row begins, parts being two or more blanks apart: lengths of the first two with the blanks behind them; none for numbers.
fn third(words: &str) -> Option<(usize, usize)> {
    let part = |text: &str| {
        let end = text.find("  ")?;
        Some(end + text[end..].len() - text[end..].trim_start().len())
    };
    let first = part(words)?;
    let second = part(&words[first..])?;
    let note = words[first + second..].split_whitespace().next()?;
    note.parse::<f64>().is_err().then_some((first, second))
}

/// A message with its first word in its colour.
#[must_use]
pub(crate) fn painted_message(text: &str) -> String {
    for (kind, colour) in [("error", AnsiColor::Red), ("warning", AnsiColor::Yellow)] {
        if let Some(rest) = text.strip_prefix(kind).filter(|rest| rest.starts_with(':')) {
            return format!("{}{rest}", styled(colour.on_default().bold(), kind));
        }
    }
    text.to_owned()
}

fn styled(style: Style, words: &str) -> String {
    format!("{style}{words}{style:#}")
}

/// Whether what is printed there may have colours: on a terminal, unless `NO_COLOR` is set; anywhere with `CLICOLOR_FORCE`.
pub(crate) fn has_colours(stream: &impl anstream::stream::RawStream) -> bool {
    anstream::AutoStream::choice(stream) != anstream::ColorChoice::Never
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_between_words() {
        let long = format!("method: {}\n", "word ".repeat(40).trim_end());
        let page = folded(&long);
        assert!(
            page.lines().count() == 3 && page.lines().all(|line| line.chars().count() <= WIDTH)
        );
        let words: Vec<&str> = page.split_whitespace().collect();
        assert_eq!(words.join(" "), long.trim_end());
        let copied = format!("set: {}\n", "x ".repeat(60));
        assert_eq!(folded(&copied), copied);
        assert_eq!(folded("a\n\nb"), "a\n\nb");
    }

    #[test]
    fn colours_leave_the_words_as_they_are() {
        let text =
            "file: contact\n\n settlement  3 µm  gauge\n 1  2  3\nmethod: one\nwarning: two\n";
        let page = painted(text);
        assert!(page.contains("\u{1b}[2mgauge"), "{page:?}");
        assert!(page.contains("\u{1b}[33mwarning") || page.contains("33m"), "{page:?}");
        let mut plain = String::new();
        let mut is_code = false;
        for letter in page.chars() {
            match (is_code, letter) {
                (false, '\u{1b}') => is_code = true,
                (true, 'm') => is_code = false,
                (false, letter) => plain.push(letter),
                (true, _) => {}
            }
        }
        assert_eq!(plain, text);
    }
}
