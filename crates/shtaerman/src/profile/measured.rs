//! A measured profile from a CSV file.

use super::base::Profile;
use super::trace::{Trace, TraceOptions};
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
    let CsvOptions { position_unit, height_unit, flip, cover } = *options;
    let options = TraceOptions {
        // A number without dimension has no other unit.
        units: Some([position_unit, height_unit]).filter(|units| *units != [1.0, 1.0]),
        is_flipped: flip,
        ..TraceOptions::default()
    };
    let trace = Trace::read(content, file_name, &options)?.arranged(&options);
    Profile::from_trace(trace.covering(cover, file_name)?, file_name)
}

impl Profile {
    /// The cubic spline through a trace; `name` is for messages.
    ///
    /// # Errors
    /// [`FileError`] for values that are not finite, as sums of huge ones may be.
    pub fn from_trace(trace: Trace, name: &str) -> Result<Self, FileError> {
        let (positions, heights) = trace.into_points();
        Self::from_points(positions, heights)
            .map_err(|error| FileError::new(error.to_string()).in_file(Some(name)))
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
