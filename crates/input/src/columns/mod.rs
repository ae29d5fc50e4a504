//! Two columns of numbers from a text file, as measuring instruments write them.
//!
//! ```
//! use shtaerman_input::columns::{Columns, Row};
//! use shtaerman_input::quantity::Dimension;
//!
//! let dimensions = [Dimension::LENGTH; 2];
//! let columns = Columns { names: ["position", "height"], dimensions, units: [1e-3, 0.5] };
//! let rows = columns.read(b"x;f\n# a comment\n2;1,5\n", "trace.csv")?;
//! assert_eq!(rows, [Row { line: 3, values: [0.002, 0.75] }]);
//!
//! let error = columns.read(b"2;1,5\n3;high\n", "trace.csv").unwrap_err();
//! assert_eq!(error.to_string(), "trace.csv: line 2: the height is not a number: `high`");
//! # Ok::<(), shtaerman_input::document::FileError>(())
//! ```

mod encoding;
mod fields;
mod header;

use crate::document::FileError;
use crate::quantity::{self, Dimension};
use crate::{nearest, shortened};
use header::{header, split};

pub use encoding::decode;
pub use fields::Separator;
pub use header::HeaderUnit;

/// The most rows that are read: a file within its limit of bytes may have ten times as many, and each takes more memory than its text.
pub const MAXIMUM_ROWS: usize = 5_000_000;

/// Relative difference below which two values are of one unit: the rounding of its digits.
const SAME: f64 = 1e-12;

/// Longest field that a message quotes.
const LONGEST_FIELD: usize = 40;

/// A row and the number of its line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// The line in the file, from 1.
    pub line: usize,
    /// The numbers in SI units.
    pub values: [f64; 2],
}

/// What the columns are called and the SI values of their units.
#[derive(Debug, Clone, Copy)]
pub struct Columns {
    /// The names, for messages.
    pub names: [&'static str; 2],
    /// What they measure.
    pub dimensions: [Dimension; 2],
    /// The SI values of the units that the numbers are written in.
    pub units: [f64; 2],
}

/// Which of the columns of a file is meant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Column {
    /// Its number, from 1.
    Number(usize),
    /// Its name in the header, with or without the unit behind it, in any case of letters.
    Named(String),
}

/// How a file is written, where that cannot be told from it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Dialect {
    /// Lines at the beginning that say nothing of the columns.
    pub skip: usize,
    /// The columns; without them there must be two.
    pub columns: Option<[Column; 2]>,
    /// The encoding, as [`decode`] takes it.
    pub encoding: Option<String>,
    /// What chooses the columns, for messages, such as `x_column and f_column`; empty where nothing does.
    pub chosen_by: &'static str,
    /// What leaves out lines at the beginning, for messages, such as `skip = `; empty where nothing does.
    pub skipped_by: &'static str,
}

/// What a file was told to be.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// The rows.
    pub rows: Vec<Row>,
    /// Name of the encoding.
    pub encoding: &'static str,
    /// What stands between fields of the first row.
    pub separator: Separator,
    /// The fields of the header; none where there is none.
    pub header: Vec<String>,
    /// Indices of the two columns that were read.
    pub columns: [usize; 2],
}

impl Columns {
    /// Reads rows separated by commas, semicolons, tabs or blanks; lines that begin with `#` are comments, one header line is allowed. With
    /// semicolons and tabs a decimal comma is read as well.
    ///
    /// # Errors
    /// As [`Columns::sheet`].
    pub fn read(&self, content: &[u8], file_name: &str) -> Result<Vec<Row>, FileError> {
        Ok(self.sheet(content, file_name, &Dialect::default())?.rows)
    }

    /// Reads rows as the dialect says, and tells what the file was found to be.
    ///
    /// # Errors
    /// [`FileError`] with the file and line: no text, a header with other units, text in a number's place, a missing column, values that are not finite,
    /// more than [`MAXIMUM_ROWS`] rows.
    pub fn sheet(
        &self,
        content: &[u8],
        file_name: &str,
        dialect: &Dialect,
    ) -> Result<Sheet, FileError> {
        let fault = |message: String| FileError::new(message).in_file(Some(file_name));
        let (text, encoding) = decode(content, dialect.encoding.as_deref()).map_err(fault)?;
        let mut rows = Vec::new();
        let (mut separator, mut chosen) = (Separator::Comma, None);
        let (mut header_line, mut names) = (None, Vec::new());
        if let Some(header) = header(&text, dialect.skip) {
            let at_line = |message: String| fault(format!("line {}: {message}", header.line + 1));
            let columns = self.chosen(dialect, &header.names, &header.names).map_err(at_line)?;
            // Of more columns than two nothing is known before they are chosen.
            if dialect.columns.is_some() || header.names.len() == 2 {
                self.compare(&header.names, columns).map_err(at_line)?;
            }
            (header_line, names, chosen) = (Some(header.line), header.names, Some(columns));
        }
        for (index, line) in text.lines().enumerate().skip(dialect.skip) {
            let is_said = !line.trim().is_empty() && !line.trim_start().starts_with('#');
            if !is_said || header_line == Some(index) {
                continue;
            }
            let at_line = |message: String| fault(format!("line {}: {message}", index + 1));
            let of_line = Separator::of(line);
            let fields = of_line.fields(line);
            let columns = match chosen {
                Some(columns) => columns,
                None => self.chosen(dialect, &names, &fields).map_err(at_line)?,
            };
            if rows.is_empty() {
                (separator, chosen) = (of_line, Some(columns));
            }
            if rows.len() == MAXIMUM_ROWS {
                return Err(at_line(format!(
                    "has more than the {MAXIMUM_ROWS} rows that are read"
                )));
            }
            let is_first = rows.is_empty();
            let values = self.values(dialect, columns, &fields).map_err(|message| {
                // Text before the first row may be one more line of a header.
                let is_text = is_first && fields.iter().all(|field| field.parse::<f64>().is_err());
                if !is_text || dialect.skipped_by.is_empty() {
                    return at_line(message);
                }
                let (by, count) = (dialect.skipped_by, index);
                at_line(format!(
                    "{message}; {by}{count} makes this line the header, whose units count"
                ))
            })?;
            rows.push(Row { line: index + 1, values });
        }
        let columns = chosen.unwrap_or([0, 1]);
        Ok(Sheet { rows, encoding, separator, header: names, columns })
    }

    /// The names of all columns as the header has them, units included; none where there is no header.
    ///
    /// # Errors
    /// [`FileError`] for no text.
    pub fn header_names(
        content: &[u8],
        file_name: &str,
        dialect: &Dialect,
    ) -> Result<Vec<String>, FileError> {
        let fault = |message: String| FileError::new(message).in_file(Some(file_name));
        let (text, _) = decode(content, dialect.encoding.as_deref()).map_err(fault)?;
        Ok(header(&text, dialect.skip).map(|header| header.names).unwrap_or_default())
    }

    /// What the header says of the units of the two columns.
    ///
    /// # Errors
    /// [`FileError`] for no text, or a column that is not there.
    pub fn header_units(
        &self,
        content: &[u8],
        file_name: &str,
        dialect: &Dialect,
    ) -> Result<[HeaderUnit; 2], FileError> {
        let fault = |message: String| FileError::new(message).in_file(Some(file_name));
        let (text, _) = decode(content, dialect.encoding.as_deref()).map_err(fault)?;
        let Some(header) = header(&text, dialect.skip) else {
            return Ok([HeaderUnit::Silent, HeaderUnit::Silent]);
        };
        let columns = self.chosen(dialect, &header.names, &header.names).map_err(fault)?;
        let [one, two] = self.dimensions;
        let said = |index: usize, expected: Dimension| {
            let name = header.names.get(index).map_or("", String::as_str);
            split(name, Some(expected)).1
        };
        Ok([said(columns[0], one), said(columns[1], two)])
    }

    /// Indices of the columns that are meant.
    fn chosen(
        &self,
        dialect: &Dialect,
        header: &[String],
        fields: &[String],
    ) -> Result<[usize; 2], String> {
        let Some(columns) = &dialect.columns else { return Ok([0, 1]) };
        let index = |column: &Column| match column {
            Column::Number(number) if (1..=fields.len()).contains(number) => Ok(number - 1),
            Column::Number(number) => {
                Err(format!("has {} columns, and column {number} is asked for", fields.len()))
            }
            Column::Named(name) => named(header, name),
        };
        let chosen = [index(&columns[0])?, index(&columns[1])?];
        if chosen[0] == chosen[1] {
            let [first, second] = self.names;
            let number = chosen[0] + 1;
            return Err(format!("column {number} is asked for as {first} and as {second}"));
        }
        Ok(chosen)
    }

    /// Units that a header has are those in which the numbers are read.
    fn compare(&self, header: &[String], columns: [usize; 2]) -> Result<(), String> {
        let wanted = self.names.into_iter().zip(self.dimensions).zip(self.units);
        for (index, ((name, expected), unit)) in columns.into_iter().zip(wanted) {
            let Some(field) = header.get(index) else { continue };
            let HeaderUnit::Known { written, size, dimension, .. } = split(field, Some(expected)).1
            else {
                continue;
            };
            let written = shortened(&written, LONGEST_FIELD);
            if dimension != expected {
                return Err(format!(
                    "the header has the {name} in {written}, {dimension}, and it is {expected}: is another column meant?"
                ));
            }
            if (size - unit).abs() > SAME * unit.abs() {
                let read = in_words(unit, expected);
                return Err(format!(
                    "the header has the {name} in {written}, and it is read in {read}: state the unit of the column, or correct the header"
                ));
            }
        }
        Ok(())
    }

    fn values(
        &self,
        dialect: &Dialect,
        columns: [usize; 2],
        fields: &[String],
    ) -> Result<[f64; 2], String> {
        let [first, second] = self.names;
        let is_chosen = dialect.columns.is_some();
        let pair = fields.get(columns[0]).zip(fields.get(columns[1]));
        let Some((one, two)) = pair.filter(|_| is_chosen || fields.len() == 2) else {
            let count = fields.len();
            let advice = match dialect.chosen_by {
                "" => String::new(),
                keys => format!(": {keys} say which are meant"),
            };
            return Err(format!("needs two columns, {first} and {second}, got {count}{advice}"));
        };
        let value = |field: &String, index: usize| {
            let name = self.names[index];
            let value: f64 = field.parse().map_err(|_| {
                format!("the {name} is not a number: `{}`", shortened(field, LONGEST_FIELD))
            })?;
            if !value.is_finite() {
                return Err(format!("the {name} is {value}: it must be finite"));
            }
            let unit = self.units[index];
            let in_si = value * unit;
            if !in_si.is_finite() {
                return Err(format!(
                    "the {name} is {value:e}, in a unit that is {unit} in SI: together more than the largest number, {:.1e}",
                    f64::MAX
                ));
            }
            Ok(in_si)
        };
        Ok([value(one, 0)?, value(two, 1)?])
    }
}

/// The index of a column by its name.
fn named(header: &[String], name: &str) -> Result<usize, String> {
    let bare = |field: &str| {
        let field = split(field, None).0;
        let end = field.find(['[', '(']).filter(|at| *at > 0).unwrap_or(field.len());
        field[..end].trim().to_lowercase()
    };
    let wanted = name.trim().to_lowercase();
    let is_meant = |field: &String| field.trim().to_lowercase() == wanted || bare(field) == wanted;
    if let Some(index) = header.iter().position(is_meant) {
        return Ok(index);
    }
    let name = shortened(name, LONGEST_FIELD);
    if header.is_empty() {
        return Err(format!("has no header to find the column `{name}` in: give its number"));
    }
    let names: Vec<String> = header.iter().map(|field| bare(field)).collect();
    let meant = nearest(&wanted, names.iter().map(String::as_str));
    let meant = meant.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
    let shown: Vec<String> =
        header.iter().take(12).map(|field| shortened(field, LONGEST_FIELD).to_string()).collect();
    Err(format!("has no column `{name}`, but {}{meant}", shown.join(", ")))
}

/// The symbol of a unit of this SI value, of those that instruments write.
#[must_use]
pub fn unit_symbol(unit: f64, dimension: Dimension) -> Option<&'static str> {
    let is_meant = |symbol: &&&str| {
        let one = quantity::parse(&format!("1 {symbol}"));
        one.is_ok_and(|one| {
            one.dimension == dimension && (one.value - unit).abs() <= SAME * unit.abs()
        })
    };
    USUAL.iter().find(is_meant).copied()
}

/// Units of instruments, by which those of columns are told.
const USUAL: [&str; 12] =
    ["m", "mm", "um", "nm", "cm", "in", "mil", "Pa", "kPa", "MPa", "GPa", "psi"];

/// A unit of this SI value by its symbol, or by that value where it has none.
fn in_words(unit: f64, dimension: Dimension) -> String {
    let found = unit_symbol(unit, dimension);
    found.map_or_else(|| format!("a unit that is {unit} in SI"), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LENGTHS: [Dimension; 2] = [Dimension::LENGTH; 2];

    #[test]
    fn what_overflows_with_its_unit_is_told_with_its_line() {
        let columns =
            Columns { dimensions: LENGTHS, names: ["position", "height"], units: [1.0, 1e3] };
        let error = columns.read(b"x,f\n0,1\n1,-1e306\n", "a.csv").unwrap_err();
        let said = "a.csv: line 3: the height is -1e306, in a unit that is 1000 in SI: together more than the largest number, 1.8e308";
        assert_eq!(error.to_string(), said);
    }

    #[test]
    fn units_of_a_header_are_those_that_are_read() {
        let columns =
            Columns { dimensions: LENGTHS, names: ["position", "height"], units: [1e-3, 1e-6] };
        for header in
            ["x [mm],f (um)", "x,f", "x (measured), f [1]", "\"x [mm]\";\"f [µm]\"", "1 [m),2 ]"]
        {
            let text =
                format!("{header}\n{}", if header.contains(';') { "1;2\n" } else { "1,2\n" });
            assert_eq!(columns.read(text.as_bytes(), "a.csv").unwrap().len(), 1, "{header}");
        }
        let error = columns.read(b"# trace\nx [mm],f [mm]\n1,2\n", "a.csv").unwrap_err();
        let said = "a.csv: line 2: the header has the height in mm, and it is read in um: state the unit of the column, or correct the header";
        assert_eq!(error.to_string(), said);
    }

    #[test]
    fn rows_have_a_limit() {
        let columns =
            Columns { dimensions: LENGTHS, names: ["position", "height"], units: [1.0, 1.0] };
        let mut text = "1,2\n".repeat(MAXIMUM_ROWS);
        text.push_str("# a comment\n1,2\n");
        let error = columns.read(text.as_bytes(), "a.csv").unwrap_err();
        let said = "a.csv: line 5000002: has more than the 5000000 rows that are read";
        assert_eq!(error.to_string(), said);
    }

    #[test]
    fn columns_are_chosen_by_number_or_name() {
        let columns =
            Columns { dimensions: LENGTHS, names: ["position", "height"], units: [1e-3, 1e-6] };
        let text = "instrument X\nNo;Position [mm];Zeit;Höhe [µm]\n1;2,5;0;3\n2;3,5;1;4\n";
        let dialect = |x: Column, f: Column| Dialect {
            skip: 1,
            columns: Some([x, f]),
            chosen_by: "x_column and f_column",
            ..Dialect::default()
        };
        for (x, f) in [
            (Column::Number(2), Column::Number(4)),
            (Column::Named("position".to_owned()), Column::Named("Höhe [µm]".to_owned())),
        ] {
            let sheet = columns.sheet(text.as_bytes(), "a.csv", &dialect(x, f)).unwrap();
            assert_eq!(sheet.rows[1], Row { line: 4, values: [0.0035, 4e-6] });
            assert_eq!((sheet.separator, sheet.columns), (Separator::Semicolon, [1, 3]));
        }
        for (x, said) in [
            (
                Column::Named("postion".to_owned()),
                "a.csv: line 2: has no column `postion`, but No, Position [mm], Zeit, Höhe [µm]; did you mean `position`?",
            ),
            (Column::Number(9), "a.csv: line 2: has 4 columns, and column 9 is asked for"),
        ] {
            let error = columns.sheet(text.as_bytes(), "a.csv", &dialect(x, Column::Number(4)));
            assert_eq!(error.unwrap_err().to_string(), said);
        }
        let same = dialect(Column::Number(2), Column::Named("Position".to_owned()));
        let said = columns.sheet(text.as_bytes(), "a.csv", &same).unwrap_err().to_string();
        assert_eq!(said, "a.csv: line 2: column 2 is asked for as position and as height");
        let plain = Dialect { skip: 1, chosen_by: "x_column and f_column", ..Dialect::default() };
        let said = columns.sheet(text.as_bytes(), "a.csv", &plain).unwrap_err().to_string();
        assert!(said.ends_with("got 4: x_column and f_column say which are meant"), "{said}");
    }
}
