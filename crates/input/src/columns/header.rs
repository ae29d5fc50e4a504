//! The header of columns: their names, and the units beside them.

use super::LONGEST_FIELD;
use super::fields::Separator;
use crate::quantity::{self, Dimension, spelled_out};
use crate::shortened;

/// What stands in brackets and is no unit, for sure.
const REMARKS: [&str; 24] = [
    "1",
    "-",
    "–",
    "—",
    "x",
    "y",
    "z",
    "f",
    "i",
    "n",
    "measured",
    "raw",
    "filtered",
    "unfiltered",
    "levelled",
    "leveled",
    "corrected",
    "smoothed",
    "fitted",
    "left",
    "right",
    "gemessen",
    "roh",
    "gefiltert",
];
/// The longest word in round brackets that may be a unit.
const LONGEST_UNIT: usize = 16;
/// Units that end names which mean something else: `x_in` beside `x_out`, `x_m` for a mean.
const AMBIGUOUS: [&str; 2] = ["in", "m"];

/// What a header says of the unit of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum HeaderUnit {
    /// Nothing.
    Silent,
    /// A unit.
    Known {
        /// As it is written, such as `inch`.
        written: String,
        /// As quantities have it, such as `in`.
        symbol: String,
        /// Its SI value.
        size: f64,
        /// What it measures.
        dimension: Dimension,
    },
    /// Something that stands where units do, and is none that is known.
    Unknown {
        /// As it is written.
        written: String,
    },
}

/// A header.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Header {
    /// Index of its line.
    pub(super) line: usize,
    /// The names of the columns.
    pub(super) names: Vec<String>,
}

/// The header of a text after so many lines; a comment above the rows is one, or adds its units to a header without any, if it names as many columns as they have, each with its unit.
pub(super) fn header(text: &str, skip: usize) -> Option<Header> {
    let mut lines = text.lines().enumerate().skip(skip).filter(|(_, line)| !line.trim().is_empty());
    // The next line that is no comment, and the comment right above it.
    let mut next = || {
        let mut comment = None;
        loop {
            let (index, line) = lines.next()?;
            match line.trim_start().strip_prefix('#') {
                Some(said) => comment = Some((index, said.trim_start_matches('#'))),
                None => return Some((index, line, comment)),
            }
        }
    };
    let (line, first, above) = next()?;
    let (row, between) = next().map_or((None, None), |(_, row, comment)| (Some(row), comment));
    let named = names(first, row);
    let (row, comments) =
        if named.is_some() { (row, [between, above]) } else { (Some(first), [above, None]) };
    let said = row.and_then(|row| comments.into_iter().flatten().find_map(|said| units(said, row)));
    match (named, said) {
        (None, said) => said,
        (Some(names), None) => Some(Header { line, names }),
        (Some(names), Some(said)) => {
            let is_silent = |name: &String| split(name, None).1 == HeaderUnit::Silent;
            let are_silent = names.iter().all(is_silent) && names.len() == said.names.len();
            let added = |(name, said): (String, &String)| match unit(said) {
                Some(written) => format!("{name} [{written}]"),
                None => name,
            };
            let names = match are_silent {
                true => names.into_iter().zip(&said.names).map(added).collect(),
                false => names,
            };
            Some(Header { line, names })
        }
    }
}

/// A comment above a row, if it names as many columns with the unit of each, or units alone.
fn units((line, said): (usize, &str), row: &str) -> Option<Header> {
    let names = names(said, Some(row))?;
    let has_unit = |name: &String| unit(name).is_some();
    let is_header = names.len() == Separator::of(row).fields(row).len()
        && names.iter().any(has_unit)
        && names.iter().all(|name| has_unit(name) || name.contains(['[', '(']));
    let names = names.into_iter().map(|name| match unit(&name) {
        Some(written) if written == name => format!("[{written}]"),
        _ => name,
    });
    is_header.then(|| Header { line, names: names.collect() })
}

/// The unit of a name, or that it is, as it is written.
fn unit(name: &str) -> Option<String> {
    match known(name.trim()).unwrap_or_else(|| split(name, None).1) {
        HeaderUnit::Known { written, .. } => Some(written),
        _ => None,
    }
}

/// The names in a line above a row; none where there is a number among them. Of the ways to read it the first counts that finds as many as the row has fields.
fn names(line: &str, row: Option<&str>) -> Option<Vec<String>> {
    let own = Separator::of(line);
    let count = row.map(|row| Separator::of(row).fields(row).len());
    let of_row = row.map(Separator::of).filter(|of_row| of_row.is_in(line));
    let is_plain = matches!(own, Separator::Semicolon | Separator::Tab);
    let mut names = own.parts(line);
    for separator in of_row.filter(|_| !is_plain).into_iter().chain([own]) {
        let parts = separator.parts(line);
        let readings = match separator {
            Separator::Blanks => vec![joined(&parts, " "), Separator::apart(line)],
            Separator::Comma => vec![joined(&parts, ", ")],
            Separator::Semicolon | Separator::Tab => Vec::new(),
        };
        let mut readings = std::iter::once(parts).chain(readings);
        let fits = |names: &Vec<String>| Some(names.len()) == count;
        let found = match count {
            None => readings.nth(usize::from(separator == Separator::Blanks)),
            Some(_) => readings.find(fits),
        };
        if let Some(found) = found {
            names = found;
            break;
        }
    }
    let is_number = |name: &String| name.replace(',', ".").parse::<f64>().is_ok();
    if names.iter().any(is_number) {
        return None;
    }
    // A comma behind a word that a blank separates is no part of it.
    Some(names.into_iter().map(|name| name.trim_end_matches(',').to_owned()).collect())
}

/// The words of names: what is in brackets, behind a solidus or an `in`, or a unit alone belongs to the name before it.
fn joined(words: &[String], between: &str) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let mut is_open = false;
    for word in words {
        let goes_on = names.last().is_some_and(|last| {
            let is_unit = || known(word).is_some_and(|unit| of(unit, None).is_some());
            let has_none = || split(last, None).1 == HeaderUnit::Silent;
            is_open
                || word.starts_with(['[', '(', '{', '/'])
                || last.ends_with([',', '/'])
                || word == "in"
                || last.ends_with(" in")
                || (is_unit() && has_none())
        });
        match names.last_mut().filter(|_| goes_on) {
            Some(last) => {
                last.push_str(between);
                last.push_str(word);
            }
            None => names.push(word.clone()),
        }
        let count =
            |brackets: [char; 3]| names.last().map_or(0, |last| last.matches(brackets).count());
        is_open = count(['[', '(', '{']) > count([']', ')', '}']);
    }
    names
}

/// The name of a column without its unit, and that unit; forms that could be part of a name are units if they measure what is expected.
pub(super) fn split(field: &str, expected: Option<Dimension>) -> (&str, HeaderUnit) {
    let field = field.trim();
    let found = in_brackets(field)
        .or_else(|| behind_solidus(field, expected))
        .or_else(|| behind_word(field, expected));
    let (end, unit) = found.unwrap_or((field.len(), HeaderUnit::Silent));
    (field[..end].trim_end_matches([' ', ',', '/']), unit)
}

/// `x [mm]`, `x (mm)`, `x {mm}`, `x / [mm]`: the first unit in brackets, or else the last that may be one.
fn in_brackets(field: &str) -> Option<(usize, HeaderUnit)> {
    let first = field.find(['[', '(', '{'])?;
    let mut unknown = None;
    let mut from = first;
    while let Some(open) = field[from..].find(['[', '(', '{']).map(|at| at + from) {
        let close = match field.as_bytes()[open] {
            b'[' => ']',
            b'(' => ')',
            _ => '}',
        };
        let Some(end) = field[open..].find(close).map(|at| at + open) else { break };
        let said = field[open + 1..end].trim();
        if let Some(unit) = known(said) {
            return Some((first, unit));
        }
        let is_remark =
            is_remark(said) || (close != ']' && (said.contains(' ') || said.len() > LONGEST_UNIT));
        if !is_remark {
            unknown = Some(unknown_unit(said));
        }
        from = end + 1;
    }
    unknown.map(|unit| (first, unit))
}

/// `x / mm`, as DIN 1313 and the SI brochure have it, and `x/mm`.
fn behind_solidus(field: &str, expected: Option<Dimension>) -> Option<(usize, HeaderUnit)> {
    if let Some((name, said)) = field.split_once(" / ") {
        let said = said.trim();
        let unknown = || (!is_remark(said)).then(|| unknown_unit(said));
        return known(said).or_else(unknown).map(|unit| (name.len(), unit));
    }
    let (name, said) = field.split_once('/')?;
    let unit = of(known(said.trim())?, expected)?;
    (!name.trim().is_empty()).then_some((name.len(), unit))
}

/// `x in mm`, `x, mm`, `x mm`, `x_mm`, `x.mm`, and `mm` alone.
fn behind_word(field: &str, expected: Option<Dimension>) -> Option<(usize, HeaderUnit)> {
    if let Some((name, said)) = field.rsplit_once(" in ") {
        let said = said.trim();
        let unknown = || {
            let is_word = !said.contains(char::is_whitespace) && !name.trim().contains(' ');
            (is_word && !is_remark(said)).then(|| unknown_unit(said))
        };
        return known(said)
            .and_then(|unit| of(unit, expected))
            .or_else(unknown)
            .map(|unit| (name.len(), unit));
    }
    let at = field.rfind([' ', ',', '_', '.']);
    let said = field[at.map_or(0, |at| at + 1)..].trim();
    let unit = of(known(said)?, expected)?;
    let end = at.unwrap_or(field.len());
    let is_behind_blank = at.is_some_and(|at| field[at..].starts_with([' ', ',']));
    if said == "in" && at.is_some() {
        return Some((end, unknown_unit(said)));
    }
    (is_behind_blank || !AMBIGUOUS.contains(&said)).then_some((end, unit))
}

/// A unit that measures what is expected.
fn of(unit: HeaderUnit, expected: Option<Dimension>) -> Option<HeaderUnit> {
    let HeaderUnit::Known { dimension, .. } = unit else { return None };
    let is_meant = match expected {
        Some(expected) => dimension == expected,
        None => [Dimension::LENGTH, Dimension::PRESSURE].contains(&dimension),
    };
    is_meant.then_some(unit)
}

/// What is no unit, as it is said.
fn unknown_unit(said: &str) -> HeaderUnit {
    HeaderUnit::Unknown { written: shortened(said, LONGEST_FIELD) }
}

fn is_remark(said: &str) -> bool {
    said.is_empty() || REMARKS.contains(&said.to_lowercase().as_str())
}

/// The unit that a text is: a symbol, a word for one, or a symbol of length in capitals.
fn known(said: &str) -> Option<HeaderUnit> {
    let of_symbol = |symbol: &str| {
        let unit = quantity::parse(&format!("1 {symbol}")).ok()?;
        unit.unit_written().then_some(unit)
    };
    let found = |symbol: &str, unit: quantity::Quantity| HeaderUnit::Known {
        written: said.to_owned(),
        symbol: symbol.to_owned(),
        size: unit.value,
        dimension: unit.dimension,
    };
    if let Some(unit) = of_symbol(said) {
        return Some(found(said, unit));
    }
    if let Some(symbol) = spelled_out(said) {
        return of_symbol(symbol).map(|unit| found(symbol, unit));
    }
    // Of one letter nobody can tell what is meant.
    let lower = said.to_lowercase();
    let unit = of_symbol(&lower).filter(|unit| unit.dimension == Dimension::LENGTH)?;
    (lower.chars().count() > 1).then(|| found(&lower, unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTH: Option<Dimension> = Some(Dimension::LENGTH);

    #[test]
    fn units_are_found_however_instruments_write_them() {
        for (field, name, symbol, size) in [
            ("x [mm]", "x", "mm", 1e-3),
            ("Höhe (µm)", "Höhe", "µm", 1e-6),
            ("x [inch]", "x", "in", 0.0254),
            ("x (inches)", "x", "in", 0.0254),
            ("Pos. (Zoll)", "Pos.", "in", 0.0254),
            ("f [micron]", "f", "µm", 1e-6),
            ("f [Microns]", "f", "µm", 1e-6),
            ("f [micrometer]", "f", "µm", 1e-6),
            ("f [Mikrometer]", "f", "µm", 1e-6),
            ("f [µ]", "f", "µm", 1e-6),
            ("f [nm]", "f", "nm", 1e-9),
            ("f (mil)", "f", "mil", 2.54e-5),
            ("X [MM]", "X", "mm", 1e-3),
            ("Z [UM]", "Z", "um", 1e-6),
            ("x / mm", "x", "mm", 1e-3),
            ("x/mm", "x", "mm", 1e-3),
            ("x / (mm)", "x", "mm", 1e-3),
            ("x_mm", "x", "mm", 1e-3),
            ("height.um", "height", "um", 1e-6),
            ("x in mm", "x", "mm", 1e-3),
            ("x, mm", "x", "mm", 1e-3),
            ("Position mm", "Position", "mm", 1e-3),
            ("mm", "mm", "mm", 1e-3),
            ("x [mm] (raw)", "x", "mm", 1e-3),
            ("x [m]", "x", "m", 1.0),
            ("x m", "x", "m", 1.0),
        ] {
            let (bare, unit) = split(field, LENGTH);
            let HeaderUnit::Known { symbol: found, size: is, .. } = unit else {
                panic!("{field}: {unit:?}");
            };
            assert_eq!((bare, found.as_str()), (name, symbol), "{field}");
            assert!((is - size).abs() <= 1e-12 * size, "{field}: {is}");
        }
    }

    #[test]
    fn what_is_no_unit_is_told_apart_from_what_is_none_that_is_known() {
        for field in [
            "x",
            "x (measured)",
            "f [1]",
            "xi [-]",
            "x (along the groove)",
            "f [",
            "x)",
            "[]",
            "x_m",
            "and/or",
            "x_bar",
            "t_s",
            "Position, left",
            "Height",
            "",
        ] {
            assert_eq!(split(field, LENGTH).1, HeaderUnit::Silent, "{field}");
        }
        for (field, said) in [
            ("f [a.u.]", "a.u."),
            ("x [foo]", "foo"),
            ("x (Linien)", "Linien"),
            ("x / foo", "foo"),
            ("x in foo", "foo"),
            ("x_in", "in"),
            ("x [px] (raw)", "px"),
        ] {
            let unknown = HeaderUnit::Unknown { written: said.to_owned() };
            assert_eq!(split(field, LENGTH).1, unknown, "{field}");
        }
    }

    #[test]
    fn names_are_put_together_where_blanks_separate() {
        for (line, row, expected) in [
            ("x [mm] f [um]", "1 2", vec!["x [mm]", "f [um]"]),
            ("x [ mm ]  f [ um ]", "1 2", vec!["x [ mm ]", "f [ um ]"]),
            ("x / mm   f / um", "1 2", vec!["x / mm", "f / um"]),
            ("x in mm f in um", "1 2", vec!["x in mm", "f in um"]),
            ("x mm f um", "1 2", vec!["x mm", "f um"]),
            ("x, mm  f, um", "1 2", vec!["x, mm", "f, um"]),
            ("x, f", "1 2", vec!["x", "f"]),
            ("Position along   Height of it", "1   2", vec!["Position along", "Height of it"]),
            ("\"x [mm]\" \"f [um]\"", "1 2", vec!["x [mm]", "f [um]"]),
            ("x [mm] f [um]", "1\t2", vec!["x [mm]", "f [um]"]),
            ("a b c d", "1 2 3 4", vec!["a", "b", "c", "d"]),
            ("\"x, mm\",\"f, um\"", "1,2", vec!["x, mm", "f, um"]),
            ("x, mm, f, um", "1,2", vec!["x, mm", "f, um"]),
            ("x [mm];f [um]", "1 2", vec!["x [mm]", "f [um]"]),
            ("x, mm;f, um", "1,5;2", vec!["x, mm", "f, um"]),
            ("x [\"],f [\"]", "1,2", vec!["x [\"]", "f [\"]"]),
        ] {
            assert_eq!(names(line, Some(row)).unwrap(), expected, "{line}");
        }
        assert_eq!(names("1 2", Some("3 4")), None);
        assert_eq!(names("1,5;2", Some("3;4")), None);
    }

    #[test]
    fn a_comment_with_units_above_the_rows_is_a_header() {
        let found = header("# made on Monday\n# x [mm] f [um]\n1 2\n", 0).unwrap();
        assert_eq!((found.line, found.names), (1, vec!["x [mm]".to_owned(), "f [um]".to_owned()]));
        // Units above or below names that have none belong to these.
        for (text, line) in [
            ("x,z\n# x [mm], z [um]\n1,2\n", 0),
            ("x,z\n# mm, um\n1,2\n", 0),
            ("# x [mm], z [um]\nx,z\n1,2\n", 1),
        ] {
            let found = header(text, 0).unwrap();
            assert_eq!(
                (found.line, found.names),
                (line, vec!["x [mm]".to_owned(), "z [um]".to_owned()]),
                "{text}"
            );
        }
        assert_eq!(header("# mm, um\n1,2\n", 0).unwrap().names, ["[mm]", "[um]"]);
        assert_eq!(header("x [m],z [m]\n# mm, um\n1,2\n", 0).unwrap().names, ["x [m]", "z [m]"]);
        for text in ["# x f\n1 2\n", "# of 3 [mm]\n1 2\n", "1 2\n", "# x [mm]\n", ""] {
            assert_eq!(header(text, 0), None, "{text}");
        }
    }
}
