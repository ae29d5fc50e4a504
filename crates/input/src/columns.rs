//! Two columns of numbers from a text file, as measuring instruments write them.
//!
//! ```
//! use shtaerman_input::columns::{Columns, Row};
//!
//! let columns = Columns { names: ["position", "height"], units: [1e-3, 0.5] };
//! let rows = columns.read(b"x;f\n# a comment\n2;1,5\n", "trace.csv")?;
//! assert_eq!(rows, [Row { line: 3, values: [0.002, 0.75] }]);
//!
//! let error = columns.read(b"2;1,5\n3;high\n", "trace.csv").unwrap_err();
//! assert_eq!(error.to_string(), "trace.csv: line 2: the height is not a number: `high`");
//! # Ok::<(), shtaerman_input::document::FileError>(())
//! ```

use crate::document::FileError;
use crate::{quantity, shortened};

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
    /// The SI values of the units that the numbers are written in.
    pub units: [f64; 2],
}

impl Columns {
    /// Reads rows separated by commas, semicolons, tabs or blanks; lines that begin with `#` are comments, one header line is allowed. With
    /// semicolons a decimal comma is read as well.
    ///
    /// # Errors
    /// [`FileError`] with the file and line: no UTF-8, a header with other units in brackets, text in a number's place, a missing column, values that are not finite, more than [`MAXIMUM_ROWS`] rows.
    pub fn read(&self, content: &[u8], file_name: &str) -> Result<Vec<Row>, FileError> {
        let fault = |message: String| FileError::new(message).in_file(Some(file_name));
        let content = content.strip_prefix(b"\xef\xbb\xbf").unwrap_or(content);
        let text = std::str::from_utf8(content).map_err(|error| {
            fault(format!("is not UTF-8 text: byte {} is none", error.valid_up_to()))
        })?;
        let (mut rows, mut header_seen) = (Vec::new(), false);
        for (index, line) in text.lines().enumerate() {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let fields = fields(line);
            let is_header = rows.is_empty()
                && !header_seen
                && fields.iter().all(|field| field.parse::<f64>().is_err());
            if is_header {
                header_seen = true;
                self.compare(&fields)
                    .map_err(|message| fault(format!("line {}: {message}", index + 1)))?;
                continue;
            }
            if rows.len() == MAXIMUM_ROWS {
                let line = index + 1;
                return Err(fault(format!(
                    "line {line}: has more than the {MAXIMUM_ROWS} rows that are read"
                )));
            }
            let values = self
                .values(&fields)
                .map_err(|message| fault(format!("line {}: {message}", index + 1)))?;
            rows.push(Row { line: index + 1, values });
        }
        Ok(rows)
    }

    /// Units that a header has in brackets are those in which the numbers are read.
    fn compare(&self, header: &[String]) -> Result<(), String> {
        for ((field, name), unit) in header.iter().zip(self.names).zip(self.units) {
            let Some((symbol, said)) = bracketed(field) else { continue };
            if (said - unit).abs() > SAME * unit.abs() {
                let symbol = shortened(symbol, LONGEST_FIELD);
                return Err(format!(
                    "the header has the {name} in {symbol}, which is {said} in SI, and it is read in a unit that is {unit}: state the unit of the column, or correct the header"
                ));
            }
        }
        Ok(())
    }

    fn values(&self, fields: &[String]) -> Result<[f64; 2], String> {
        let [first, second] = self.names;
        let [one, two] = fields else {
            return Err(format!("needs two columns, {first} and {second}, got {}", fields.len()));
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

/// The unit in the last brackets of a field of a header, such as `height [um]` or `height (um)`, with its SI value; none where they have no unit.
fn bracketed(field: &str) -> Option<(&str, f64)> {
    let field = field.trim_end();
    let open = match field.as_bytes().last()? {
        b']' => '[',
        b')' => '(',
        _ => return None,
    };
    let symbol = field.get(field.rfind(open)? + 1..field.len() - 1)?.trim();
    let unit = quantity::parse(&format!("1 {symbol}")).ok()?;
    unit.unit_written().then_some((symbol, unit.value))
}

fn fields(line: &str) -> Vec<String> {
    let separated =
        |separator: char| line.split(separator).map(|field| unquoted(field).to_owned()).collect();
    if line.contains(';') {
        let fields: Vec<String> = separated(';');
        return fields.into_iter().map(|field| field.replace(',', ".")).collect();
    }
    if line.contains(',') {
        return separated(',');
    }
    line.split_whitespace().map(|field| unquoted(field).to_owned()).collect()
}

fn unquoted(field: &str) -> &str {
    let field = field.trim();
    field.strip_prefix('"').and_then(|field| field.strip_suffix('"')).unwrap_or(field)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_overflows_with_its_unit_is_told_with_its_line() {
        let columns = Columns { names: ["position", "height"], units: [1.0, 1e3] };
        let error = columns.read(b"x,f\n0,1\n1,-1e306\n", "a.csv").unwrap_err();
        let said = "a.csv: line 3: the height is -1e306, in a unit that is 1000 in SI: together more than the largest number, 1.8e308";
        assert_eq!(error.to_string(), said);
    }

    #[test]
    fn units_of_a_header_are_those_that_are_read() {
        let columns = Columns { names: ["position", "height"], units: [1e-3, 1e-6] };
        for header in
            ["x [mm],f (um)", "x,f", "x (measured), f [1]", "\"x [mm]\";\"f [µm]\"", "1 [m),2 ]"]
        {
            let text =
                format!("{header}\n{}", if header.contains(';') { "1;2\n" } else { "1,2\n" });
            assert_eq!(columns.read(text.as_bytes(), "a.csv").unwrap().len(), 1, "{header}");
        }
        let error = columns.read(b"# trace\nx [mm],f [mm]\n1,2\n", "a.csv").unwrap_err();
        let said = "a.csv: line 2: the header has the height in mm, which is 0.001 in SI, and it is read in a unit that is 0.000001: state the unit of the column, or correct the header";
        assert_eq!(error.to_string(), said);
    }

    #[test]
    fn rows_have_a_limit() {
        let columns = Columns { names: ["position", "height"], units: [1.0, 1.0] };
        let mut text = "1,2\n".repeat(MAXIMUM_ROWS);
        assert_eq!(columns.read(text.as_bytes(), "a.csv").unwrap().len(), MAXIMUM_ROWS);
        text.push_str("# a comment\n1,2\n");
        let error = columns.read(text.as_bytes(), "a.csv").unwrap_err();
        let said = "a.csv: line 5000002: has more than the 5000000 rows that are read";
        assert_eq!(error.to_string(), said);
    }
}
