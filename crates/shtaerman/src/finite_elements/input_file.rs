//! Pressure-overclosure tables of input files of Abaqus and `CalculiX`.

use super::Units;
use crate::asperities::{Table, TableOrder, read_table};
use crate::document::FileError;

/// The keyword of the table, and the parameter that says that there is one.
const KEYWORD: &str = "*SURFACEBEHAVIOR";
const PARAMETER: &str = "PRESSURE-OVERCLOSURE=TABULAR";

/// Whether this is an input file of a finite-element program: a line begins with an asterisk.
#[must_use]
pub fn is_input_file(content: &[u8]) -> bool {
    content.split(|byte| *byte == b'\n').any(|line| line.trim_ascii_start().starts_with(b"*"))
}

/// Reads the table below the first `*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR`, pressure and overclosure. Units are SI values of those of overclosure and pressure; none
/// are needed of a file whose [comment](Units::comment) tells them, as exported ones do.
///
/// ```
/// use shtaerman::finite_elements::read_input_file;
///
/// let text = b"** Units: N, mm, MPa\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n0., 0.\n100., 1.2e-3\n*STEP\n";
/// let fit = read_input_file(text, "rough.inp", None)?.fit_linear()?;
/// assert!((fit.roughness.displacement(1.0) / 1.2e-14 - 1.0).abs() < 1e-12);
/// # Ok::<(), shtaerman::Error>(())
/// ```
///
/// # Errors
/// [`FileError`] with the file, and the line where one is at fault: no such table, no units, and those of [`read_table`].
pub fn read_input_file(
    content: &[u8],
    file_name: &str,
    units: Option<[f64; 2]>,
) -> Result<Table, FileError> {
    let fault = |message: &str| FileError::new(message.to_owned()).in_file(Some(file_name));
    let text = String::from_utf8_lossy(content);
    let stated = Units::ALL.into_iter().find(|units| {
        let comment = units.comment();
        text.lines().any(|line| line.trim_end() == comment)
    });
    let stated = stated.map(|units| [units.length(), units.pressure()]);
    let units = units.or(stated).ok_or_else(|| {
        fault("does not tell its units, which a finite-element program does not know: they are needed, those of the overclosure and of the pressure")
    })?;
    // All other lines are comments, so that faults are told with their lines.
    let (mut rows, mut state) = (String::new(), State::Before);
    for line in text.lines() {
        let line = line.trim();
        let is_keyword = line.starts_with('*') && !line.starts_with("**");
        state = match state {
            State::Before if is_keyword && is_table(line) => State::Inside,
            State::Inside if is_keyword => State::Behind,
            same => same,
        };
        let is_row = matches!(state, State::Inside) && !line.starts_with('*');
        rows.push_str(if is_row { line } else { "#" });
        rows.push('\n');
    }
    if matches!(state, State::Before) {
        return Err(fault("has no *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR"));
    }
    read_table(rows.as_bytes(), file_name, units.map(Some), Some(TableOrder::PressureApproach))
}

/// Where a line is.
#[derive(Clone, Copy)]
enum State {
    Before,
    Inside,
    Behind,
}

/// Whether a keyword begins a table: blanks and case mean nothing.
fn is_table(line: &str) -> bool {
    let bare: String = line.chars().filter(|sign| !sign.is_whitespace()).collect();
    let bare = bare.to_ascii_uppercase();
    let mut parts = bare.split(',');
    parts.next() == Some(KEYWORD) && parts.any(|part| part == PARAMETER)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Roughness;

    #[test]
    fn reads_the_first_table_of_a_model() {
        let model = b"*HEADING\r\n1, 2, 3\r\n*Surface Interaction, name=A\r\n*surface behavior , pressure-overclosure = tabular\r\n0., 0.\r\n** 3., 3.\r\n 4., 2.\r\n9., 3.\r\n*Friction\r\n0.1\r\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\r\n0, 0\r\n5, 1\r\n";
        assert!(is_input_file(model) && !is_input_file(b"p,v\n1,2\n"));
        let table = read_input_file(model, "a.inp", Some([1e-6, 1.0])).unwrap();
        assert_eq!(table.count(), 3);
        let Roughness::Power { coefficient, exponent } = table.fit_power().unwrap().roughness
        else {
            panic!("a power")
        };
        assert!((1e6 * coefficient - 1.0).abs() < 1e-12 && (exponent - 0.5).abs() < 1e-12);
    }

    #[test]
    fn refuses_with_file_and_line() {
        let keyword = "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR";
        for (text, units, said) in [
            (format!("{keyword}\n0,0\n1,1\n"), None, "a.inp: does not tell its units"),
            ("*STEP\n0,0\n".to_owned(), Some([1.0; 2]), "a.inp: has no *SURFACE BEHAVIOR"),
            (
                "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n5.\n".to_owned(),
                Some([1.0; 2]),
                "has no *SURFACE BEHAVIOR",
            ),
            (format!("*A\n{keyword}\n0,0\n1,x\n"), Some([1.0; 2]), "a.inp: line 4: the approach"),
            (format!("{keyword}\n0,0\n1,2,3\n"), Some([1.0; 2]), "line 3: needs two columns"),
            (format!("{keyword}\n*STEP\n"), Some([1.0; 2]), "pressure"),
        ] {
            let error = read_input_file(text.as_bytes(), "a.inp", units).unwrap_err().to_string();
            assert!(error.contains(said), "{text:?}: {error}");
        }
    }
}
