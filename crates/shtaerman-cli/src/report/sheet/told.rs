//! What a command tells on the terminal, as HTML: its tables, and its lines sorted by what they are about.

use std::fmt::Write;

use super::super::{Part, Table};
use super::math::escaped;

/// The parts of what was told.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Told {
    /// The first line, without the name of the file.
    pub(super) heading: String,
    /// Tables and lines about the answer, as HTML.
    pub(super) answer: String,
    /// Lines about the method, the error and its audit: name and text.
    pub(super) sure: Vec<(String, String)>,
    /// Warnings.
    pub(super) warnings: Vec<String>,
}

/// How lines begin that are about how sure the answer is.
const SURE: [&str; 8] = [
    "method",
    "error",
    "audit",
    "complementarity",
    "cross-check",
    "no audit",
    "errors",
    "sense checks",
];

/// Sorts what a command told.
pub(super) fn sorted(told: &super::super::Told) -> Told {
    let mut sorted = Told::default();
    let mut is_first = true;
    for part in told.parts() {
        match part {
            Part::Table(found) => sorted.answer.push_str(&table(found)),
            Part::Lines(lines) => {
                for line in lines.lines() {
                    sorted.line(line, std::mem::take(&mut is_first));
                }
            }
        }
    }
    sorted
}

impl Told {
    fn line(&mut self, line: &str, is_first: bool) {
        if is_first {
            self.heading = line.split_once(": ").map_or(line, |(_, rest)| rest).to_owned();
        } else if let Some(warning) = line.strip_prefix("warning: ") {
            self.warnings.push(warning.to_owned());
        } else if !line.trim().is_empty() {
            let named = line.split_once(": ");
            match named.filter(|(name, _)| SURE.iter().any(|word| name.starts_with(word))) {
                Some((name, rest)) => self.sure.push((name.to_owned(), rest.to_owned())),
                None => {
                    let _ = write!(self.answer, "<p>{}</p>", escaped(line));
                }
            }
        }
    }
}

/// A table: the first cell of a row names it; without heads the second is its value and others are notes.
fn table(table: &Table) -> String {
    let mut text = String::from("<table class=\"told\">");
    let heads = table.heads();
    if let Some(heads) = &heads {
        text.push_str("<thead><tr>");
        for head in heads {
            let _ = write!(text, "<th scope=\"col\">{}</th>", escaped(head));
        }
        text.push_str("</tr></thead>");
    }
    text.push_str("<tbody>");
    for row in table.cells() {
        text.push_str("<tr>");
        for (index, cell) in row.iter().enumerate() {
            let cell = escaped(cell);
            let _ = match (index, &heads) {
                (0, _) => write!(text, "<th scope=\"row\">{cell}</th>"),
                (1, None) => write!(text, "<td><b>{cell}</b></td>"),
                (_, None) => write!(text, "<td class=\"note\">{cell}</td>"),
                (_, Some(_)) => write!(text, "<td>{cell}</td>"),
            };
        }
        text.push_str("</tr>");
    }
    text.push_str("</tbody></table>");
    text
}

#[cfg(test)]
mod tests {
    use super::super::super as report;
    use super::*;

    #[test]
    fn lines_are_sorted_by_what_they_are_about() {
        let mut told = report::Told::new("punch.toml: unilateral contact, theta0 = 1\n\n");
        let mut rows = Table::new(&["", "", ""]);
        rows.row(["settlement", "3 µm", "gauge: <a>"].map(str::to_owned).to_vec());
        told.table(rows);
        told.push_str("\nmethod: one zone\nerror (bound), at most: pressure 58 µPa\naudit (bound): the residual\n\nset: load.force = 1\nwarning: the base is <steep>\n");
        let sorted = sorted(&told);
        assert_eq!(sorted.heading, "unilateral contact, theta0 = 1");
        assert_eq!(
            sorted.answer,
            "<table class=\"told\"><tbody><tr><th scope=\"row\">settlement</th><td><b>3 µm</b></td><td class=\"note\">gauge: &lt;a&gt;</td></tr></tbody></table><p>set: load.force = 1</p>"
        );
        let names: Vec<&str> = sorted.sure.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["method", "error (bound), at most", "audit (bound)"]);
        assert_eq!(sorted.warnings, ["the base is <steep>"]);
    }

    #[test]
    fn tables_with_heads_keep_them() {
        let mut rows = Table::new(&["", "radius"]);
        rows.row(["least", "4.2 m"].map(str::to_owned).to_vec());
        let mut told = report::Told::new("x: crowns\n");
        told.table(rows);
        let shown = sorted(&told).answer;
        assert_eq!(
            shown,
            "<table class=\"told\"><thead><tr><th scope=\"col\"></th><th scope=\"col\">radius</th></tr></thead><tbody><tr><th scope=\"row\">least</th><td>4.2 m</td></tr></tbody></table>"
        );
    }
}
