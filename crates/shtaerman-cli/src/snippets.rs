//! How what was done is done again: in a shell, and in Python.

use std::fmt::Write;

use shtaerman::document::{Document, Table, Value, ValueKind};

/// A word as a POSIX shell reads it.
#[must_use]
pub(crate) fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=:,+@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.to_owned();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}

/// The same problem in Python.
#[must_use]
pub(crate) fn python(document: &Document) -> String {
    let mut text = String::from("import shtaerman as st\n\ncontact = st.solve({\n");
    table(&mut text, document.root(), 1);
    text.push_str("})\nprint(contact.settlement, contact.peak_pressure)\nprint(contact.error)\n");
    text
}

fn table(text: &mut String, table: &Table, depth: usize) {
    let mut entries: Vec<(&str, &Value)> =
        table.keys().filter_map(|key| Some((key, table.get(key)?))).collect();
    entries.sort_by_key(|(_, value)| value.origin().span().start);
    let indent = "    ".repeat(depth);
    for (key, value) in entries {
        let _ = write!(text, "{indent}{}: ", string(key));
        item(text, value, depth);
        text.push_str(",\n");
    }
}

fn item(text: &mut String, value: &Value, depth: usize) {
    let _ = match value.kind() {
        ValueKind::String(words) | ValueKind::Datetime(words) => write!(text, "{}", string(words)),
        ValueKind::Integer(number) => write!(text, "{number}"),
        ValueKind::Float(number) => write!(text, "{number:?}"),
        ValueKind::Boolean(truth) => write!(text, "{}", if *truth { "True" } else { "False" }),
        ValueKind::Array(items) => {
            text.push('[');
            for (index, value) in items.iter().enumerate() {
                text.push_str(if index > 0 { ", " } else { "" });
                item(text, value, depth);
            }
            write!(text, "]")
        }
        ValueKind::Table(inner) => {
            text.push_str("{\n");
            table(text, inner, depth + 1);
            write!(text, "{}}}", "    ".repeat(depth))
        }
        _ => Ok(()),
    };
}

/// A string literal, which JSON's are in Python.
fn string(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_quoted_where_a_shell_needs_it() {
        for (word, shown) in [
            ("solve", "solve"),
            ("--set", "--set"),
            ("load.force=1", "load.force=1"),
            ("1 MN/m", "'1 MN/m'"),
            ("it's", "'it'\\''s'"),
            ("$HOME", "'$HOME'"),
            ("", "''"),
        ] {
            assert_eq!(quoted(word), shown);
        }
    }

    #[test]
    fn a_problem_is_a_dictionary() {
        let text = "[punch]\nhalf_width = \"5 mm\"\nprofile = { csv = \"a\\\"b.csv\", flip = true }\n[load]\nforce = 1e6\nmoment = 0\n";
        let python = python(&Document::parse(text, "x.toml").unwrap());
        let expected = "contact = st.solve({\n    \"punch\": {\n        \"half_width\": \"5 mm\",\n        \"profile\": {\n            \"csv\": \"a\\\"b.csv\",\n            \"flip\": True,\n        },\n    },\n    \"load\": {\n        \"force\": 1000000.0,\n        \"moment\": 0,\n    },\n})\n";
        assert!(python.contains(expected), "{python}");
    }
}
