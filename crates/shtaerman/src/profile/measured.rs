//! A measured profile from a CSV file.

use super::Profile;
use crate::document::FileError;

/// How the columns of a measured profile are to be read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CsvOptions {
    /// SI value of the unit of the first column, the position.
    pub position_unit: f64,
    /// SI value of the unit of the second column, the height.
    pub height_unit: f64,
    /// Whether heights are measured towards the body, and so change their sign.
    pub flip: bool,
    /// The positions that the profile must cover, in the units of the problem.
    pub cover: [f64; 2],
}

/// Reads a profile of two columns, position and height, separated by commas, semicolons, tabs or blanks; lines that begin with
/// `#` are comments, one header line is allowed. With semicolons a decimal comma is read as well.
///
/// # Errors
/// [`FileError`] with the file and line: text in a number's place, a missing column, values that are not finite, positions that do
/// not increase, fewer than two rows, a punch that is not covered.
pub fn read_csv(
    content: &[u8],
    file_name: &str,
    options: &CsvOptions,
) -> Result<Profile, FileError> {
    let fault = |message: String| FileError::new(message).in_file(Some(file_name));
    let content = content.strip_prefix(b"\xef\xbb\xbf").unwrap_or(content);
    let text = std::str::from_utf8(content).map_err(|error| {
        fault(format!("is not UTF-8 text: byte {} is none", error.valid_up_to()))
    })?;
    let mut rows = Rows { positions: Vec::new(), heights: Vec::new(), header_seen: false };
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        if !line.is_empty() && !line.starts_with('#') {
            rows.read(line, options)
                .map_err(|message| fault(format!("line {}: {message}", index + 1)))?;
        }
    }
    let Rows { positions, heights, .. } = rows;
    if positions.len() < 2 {
        let count = positions.len();
        return Err(fault(format!("a profile needs at least two rows of numbers, got {count}")));
    }
    covers(&positions, options).map_err(fault)?;
    Profile::measured(positions, heights).map_err(|error| fault(error.to_string()))
}

struct Rows {
    positions: Vec<f64>,
    heights: Vec<f64>,
    header_seen: bool,
}

impl Rows {
    fn read(&mut self, line: &str, options: &CsvOptions) -> Result<(), String> {
        let fields = fields(line);
        let numbers: Vec<Option<f64>> = fields.iter().map(|field| field.parse().ok()).collect();
        if self.positions.is_empty() && !self.header_seen && numbers.iter().all(Option::is_none) {
            self.header_seen = true;
            return Ok(());
        }
        if fields.len() != 2 {
            return Err(format!("needs two columns, position and height, got {}", fields.len()));
        }
        let mut values = [0.0; 2];
        for ((value, number), (field, column)) in
            values.iter_mut().zip(&numbers).zip(fields.iter().zip(["position", "height"]))
        {
            *value = number
                .ok_or_else(|| format!("the {column} is not a number: `{}`", shortened(field)))?;
            if !value.is_finite() {
                return Err(format!("the {column} is {value}: it must be finite"));
            }
        }
        let [position, height] =
            [values[0] * options.position_unit, values[1] * options.height_unit];
        if let Some(last) = self.positions.last().filter(|last| position <= **last) {
            return Err(format!(
                "positions must increase from row to row, got {position} after {last} (in metres)"
            ));
        }
        self.positions.push(position);
        self.heights.push(if options.flip { -height } else { height });
        Ok(())
    }
}

/// Relative slack at the edges of the punch, so that a trace that ends at the edge covers it whatever its unit rounds to.
const SLACK: f64 = 1e-9;

fn covers(positions: &[f64], options: &CsvOptions) -> Result<(), String> {
    let [left, right] = options.cover;
    let (first, last) = (positions[0], positions[positions.len() - 1]);
    let slack = SLACK * (right - left);
    if first > left + slack || last < right - slack {
        return Err(format!(
            "does not cover the punch: the rows reach from {first} to {last}, the punch from {left} to {right} (in the units of the problem)"
        ));
    }
    Ok(())
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

fn shortened(field: &str) -> String {
    if field.chars().count() > 40 {
        format!("{}...", field.chars().take(40).collect::<String>())
    } else {
        field.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(content: &str) -> Result<Profile, FileError> {
        let options = CsvOptions {
            position_unit: 1e-3,
            height_unit: 1e-6,
            flip: false,
            cover: [-1e-3, 1e-3],
        };
        read_csv(content.as_bytes(), "p.csv", &options)
    }

    #[test]
    fn reads_the_usual_dialects() {
        for content in [
            "x_mm,f_um\n-1,1\n0,0\n1,1\n",
            "# trace\n-1;1,0\n0;0,0\n1;1,0\n",
            "-1\t1\r\n0\t0\r\n1\t1\r\n",
            "\u{feff}\"-1\",\"1\"\n 0 , 0 \n1,1",
        ] {
            let profile = read(content).unwrap();
            // Through three points a parabola: f = x^2, at x = 0.5 mm 0.25 um.
            assert!((profile.height(0.5, 1e-3) - 0.25e-6).abs() < 1e-20, "{content}");
        }
    }

    #[test]
    fn refuses_with_line_and_reason() {
        for (content, said) in [
            ("-1,1\n", "at least two rows"),
            ("", "at least two rows"),
            ("-1,1\n0,zero\n1,1\n", "line 2: the height is not a number: `zero`"),
            ("-1,1\n1,1\n0,0\n", "line 3: positions must increase"),
            ("-1,1\n-1,1\n1,1\n", "line 2: positions must increase"),
            ("-0.5,1\n1,1\n", "does not cover the punch"),
            ("-1,1\n0,NaN\n1,1\n", "line 2: the height is NaN"),
            ("-1,1,3\n1,1,3\n", "line 1: needs two columns"),
            ("-1\n1\n", "line 1: needs two columns"),
            ("x,y\nx,y\n-1,1\n1,1\n", "line 2: the position is not a number"),
        ] {
            let message = read(content).unwrap_err().to_string();
            assert!(
                message.starts_with("p.csv: ") && message.contains(said),
                "{content:?}: {message}"
            );
        }
    }
}
