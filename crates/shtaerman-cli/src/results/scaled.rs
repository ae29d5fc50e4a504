//! Parts as CSV in the units that a study file chooses.

use shtaerman_study::{Part, PartFault, Row, Study};

use crate::output::Content;
use crate::report::{Scaled, StudyUnits, csv_columns, rows_csv, times};

/// Doubles beside a quotient among which the value is that was written.
const NEIGHBOURS: usize = 3;

/// The columns of the CSV parts of a study.
#[derive(Debug)]
pub(super) struct PartColumns {
    units: StudyUnits,
    columns: Vec<Scaled>,
}

impl PartColumns {
    /// In the units of `[output]` of the study, as its first case has them. Where that has none, or is none, they are SI.
    pub(super) fn new(study: &Study) -> Self {
        let units = StudyUnits::new(study, &[]).unwrap_or_default();
        let columns = csv_columns(study, &units);
        Self { units, columns }
    }

    /// A part.
    pub(super) fn content<'r>(&self, study: &'r Study, rows: &'r [Row]) -> Content<'r> {
        rows_csv(study, &self.units, rows)
    }

    /// The rows of a part from its lines, that of the heads first, in SI units.
    pub(super) fn rows(
        &self,
        study: &Study,
        part: &Part,
        mut lines: Vec<Vec<String>>,
    ) -> Result<Vec<Row>, PartFault> {
        if let Some(heads) = lines.first_mut()
            && heads.iter().eq(self.columns.iter().map(|column| &column.name))
        {
            *heads = study.columns();
            for (case, fields) in part.cases.clone().zip(&mut lines[1..]) {
                self.to_si(study, case, fields);
            }
        }
        study.rows(part, &lines)
    }

    /// The fields of a case in SI units: of what varied those of the study, if they are written, and of the rest the values that were written.
    fn to_si(&self, study: &Study, case: usize, fields: &mut [String]) {
        let inputs = study.inputs(case);
        let known = inputs.iter().map(ToString::to_string);
        for ((field, column), known) in fields.iter_mut().zip(&self.columns).skip(1).zip(known) {
            if *field == times(known.clone(), column.factor) {
                *field = known;
            }
        }
        let found = fields.iter_mut().zip(&self.columns).skip(1 + inputs.len());
        for (field, column) in found.filter(|(_, column)| column.factor != 1.0) {
            if let Some(value) = written(field, column.factor) {
                *field = format!("{value:?}");
            }
        }
    }
}

/// A value that is this text when it is multiplied by a factor, or the nearest quotient where none is.
fn written(text: &str, factor: f64) -> Option<f64> {
    let quotient = text.parse::<f64>().ok()? / factor;
    let above = std::iter::successors(Some(quotient), |value| Some(value.next_up()));
    let below = std::iter::successors(Some(quotient), |value| Some(value.next_down()));
    let near = above.zip(below).take(NEIGHBOURS).flat_map(|(above, below)| [above, below]);
    let is_written = |value: &f64| (value * factor).to_string() == text;
    Some(near.into_iter().find(is_written).unwrap_or(quotient))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_written_is_found_again() {
        let mut value = 0.123_456_789_f64;
        for factor in [1e-6, 1e3, 39.370_078_740_157_48, 1.450_377_377_302_092e-4, 57.29, 1e-15] {
            for _ in 0..2000 {
                value = (value * 997.0).fract();
                let text = times(format!("{value:?}"), factor);
                let found = written(&text, factor).unwrap();
                assert_eq!(times(format!("{found:?}"), factor), text);
                assert!((found - value).abs() <= 4.0 * f64::EPSILON * value, "{value} {found}");
            }
        }
        assert_eq!(written("no number", 2.0), None);
        assert!(written("NaN", 2.0).unwrap().is_nan());
        assert_eq!(written("inf", 2.0), Some(f64::INFINITY));
    }
}
