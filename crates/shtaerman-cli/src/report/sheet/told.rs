//! What a command tells on the terminal, as HTML: its tables, and its lines sorted by what they are about.

use std::fmt::Write;

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
const SURE: [&str; 7] =
    ["method", "error", "audit", "complementarity", "cross-check", "no audit", "errors"];

/// Sorts what a command told.
pub(super) fn sorted(text: &str) -> Told {
    let mut told = Told::default();
    let mut lines = text.lines().peekable();
    if let Some(first) = lines.next_if(|line| !line.starts_with(' ')) {
        told.heading = first.split_once(": ").map_or(first, |(_, rest)| rest).to_owned();
    }
    while let Some(line) = lines.next() {
        if line.trim().is_empty() || line.starts_with("plot: ") || line.starts_with("report: ") {
            continue;
        }
        if line.starts_with(' ') {
            let mut rows = vec![cells(line)];
            while let Some(next) = lines.next_if(|next| next.starts_with(' ')) {
                rows.push(cells(next));
            }
            told.answer.push_str(&table(&rows));
            continue;
        }
        if let Some(warning) = line.strip_prefix("warning: ") {
            told.warnings.push(warning.to_owned());
            continue;
        }
        match line
            .split_once(": ")
            .filter(|(name, _)| SURE.iter().any(|word| name.starts_with(word)))
        {
            Some((name, rest)) => told.sure.push((name.to_owned(), rest.to_owned())),
            None => {
                let _ = write!(told.answer, "<p>{}</p>", escaped(line));
            }
        }
    }
    told
}

/// The cells of a row: two blanks or more are between them, and an empty one at the left is seen by more before it than others have.
fn cells(line: &str) -> Vec<String> {
    let mut cells: Vec<String> = line
        .trim()
        .split("  ")
        .map(str::trim)
        .filter(|cell| !cell.is_empty())
        .map(str::to_owned)
        .collect();
    if line.len() - line.trim_start().len() > 3
        && !cells[0].starts_with(|c: char| c.is_ascii_digit())
    {
        cells.insert(0, String::new());
    }
    cells
}

/// A table; a first row of which no cell is a number is its head where it has more than three cells.
fn table(rows: &[Vec<String>]) -> String {
    let most = rows.iter().map(Vec::len).max().unwrap_or(0);
    let has_head = most > 3 && rows.len() > 1;
    let mut text = String::from("<table class=\"told\">");
    let mut body = rows;
    if has_head && let Some((head, rest)) = rows.split_first() {
        body = rest;
        let missing = most - head.len().min(most);
        text.push_str("<thead><tr>");
        text.push_str(&"<th></th>".repeat(missing));
        for cell in head {
            let _ = write!(text, "<th scope=\"col\">{}</th>", escaped(cell));
        }
        text.push_str("</tr></thead>");
    }
    text.push_str("<tbody>");
    for row in body {
        text.push_str("<tr>");
        for (index, cell) in row.iter().enumerate() {
            let cell = escaped(cell);
            let _ = match index {
                0 => write!(text, "<th scope=\"row\">{cell}</th>"),
                1 if !has_head => write!(text, "<td><b>{cell}</b></td>"),
                _ if !has_head => write!(text, "<td class=\"note\">{cell}</td>"),
                _ => write!(text, "<td>{cell}</td>"),
            };
        }
        text.push_str(&"<td></td>".repeat(most - row.len()));
        text.push_str("</tr>");
    }
    text.push_str("</tbody></table>");
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOLVED: &str = "punch.toml: unilateral contact, theta0 = 1, sinc method with n = 67\n\n settlement           2.97858 µm  gauge: ln(a/|x-s|)\n pressure, left edge  125 MPa\n\nmethod: one zone\nerror (bound), at most: pressure 58 µPa\naudit (bound): the residual\n\nwarning: the base is <steep>\nplot: a.svg\n";

    #[test]
    fn lines_are_sorted_by_what_they_are_about() {
        let told = sorted(SOLVED);
        assert_eq!(told.heading, "unilateral contact, theta0 = 1, sinc method with n = 67");
        let row = "<tr><th scope=\"row\">settlement</th><td><b>2.97858 µm</b></td><td class=\"note\">gauge: ln(a/|x-s|)</td></tr>";
        assert!(told.answer.contains(row), "{}", told.answer);
        let names: Vec<&str> = told.sure.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["method", "error (bound), at most", "audit (bound)"]);
        assert_eq!(told.warnings, ["the base is <steep>"]);
        assert!(!told.answer.contains("a.svg"));
    }

    #[test]
    fn tables_with_heads_keep_them() {
        let text = "x: crowns\n\n              radius  peak pressure   at     contact width\n least        4.2 m   100 MPa         0 m    10 mm\n lowest peak  7.3 m   84.7 MPa        -5 mm  10 mm\n\n111 solves\n";
        let told = sorted(text);
        assert!(
            told.answer.contains("<thead><tr><th scope=\"col\"></th><th scope=\"col\">radius</th>"),
            "{}",
            told.answer
        );
        assert!(
            told.answer.contains("<tr><th scope=\"row\">least</th><td>4.2 m</td>"),
            "{}",
            told.answer
        );
        assert!(told.answer.contains("<p>111 solves</p>"));
    }
}
