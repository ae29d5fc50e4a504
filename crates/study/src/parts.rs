//! The results of a study, in parts that are each computed and written whole.

use std::ops::Range;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};
use shtaerman::Error;
use shtaerman::document::{FileError, load_bytes};

use crate::{Row, Study};

/// Version of the layout of a folder of results.
const SCHEMA: &str = "shtaerman-study/1";

/// Some of the cases of a study, which one file has.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// Its number, from 0.
    pub number: usize,
    /// Its cases.
    pub cases: Range<usize>,
}

impl Part {
    /// The name of its file, which ends as the name of the format.
    #[must_use]
    pub fn file_name(&self, format: &str) -> String {
        format!("part-{:08}.{format}", self.number)
    }
}

/// What the files in a folder of results belong to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Manifest {
    /// The layout.
    pub schema: String,
    /// The version of the program: another one may round differently.
    pub version: String,
    /// The format of the parts, such as `csv`.
    pub format: String,
    /// The study file.
    pub study: String,
    /// SHA-256 of the study with its overrides and of its measured profiles.
    pub digest: String,
    /// Number of cases.
    pub cases: usize,
    /// Cases of a part.
    pub part_size: usize,
    /// The varied keys.
    pub variables: Vec<String>,
    /// The outputs.
    pub outputs: Vec<String>,
}

impl Manifest {
    /// Whether results of the one are results of the other, under whatever name.
    #[must_use]
    pub fn belongs_with(&self, other: &Self) -> bool {
        *self == Self { study: self.study.clone(), ..other.clone() }
    }
}

/// Why a part that is there does not count.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PartFault(pub String);

impl Study {
    /// The parts, in order.
    pub fn parts(&self) -> impl ExactSizeIterator<Item = Part> + use<> {
        let (cases, size) = (self.cases, self.part_size);
        (0..cases.div_ceil(size)).map(move |number| Part {
            number,
            cases: number * size..((number + 1) * size).min(cases),
        })
    }

    /// What a folder of results of this study says of itself.
    ///
    /// # Errors
    /// [`Error::File`] where a measured profile can be read no more.
    pub fn manifest(&self, name: &str, format: &str) -> Result<Manifest, Error> {
        let mut digest = Sha256::new();
        digest.update(self.text.as_bytes());
        for path in self.measured_profiles()? {
            let name = path.display().to_string();
            let bytes = load_bytes(&path)
                .map_err(|message| FileError::new(message).in_file(Some(&name)))?;
            digest.update([0]);
            digest.update(&bytes);
        }
        Ok(Manifest {
            schema: SCHEMA.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            format: format.to_owned(),
            study: name.to_owned(),
            digest: digest.finalize().iter().map(|byte| format!("{byte:02x}")).collect(),
            cases: self.cases,
            part_size: self.part_size,
            variables: self.variables.iter().map(|variable| variable.key.clone()).collect(),
            outputs: self.outputs.iter().map(|output| output.name.clone()).collect(),
        })
    }

    /// The heads of the columns: the case, the varied keys, each output and its error, the kind of the errors, the codes of warnings, the reason where there is no answer.
    #[must_use]
    pub fn columns(&self) -> Vec<String> {
        let mut columns = vec!["case".to_owned()];
        columns.extend(self.variables.iter().map(|variable| variable.key.clone()));
        for output in &self.outputs {
            columns.extend([output.name.clone(), format!("{}_error", output.name)]);
        }
        columns.extend(["error_kind", "warnings", "reason"].map(str::to_owned));
        columns
    }

    /// A row as text, one for each column.
    #[must_use]
    pub fn fields(&self, row: &Row) -> Vec<String> {
        let mut fields = vec![row.case.to_string()];
        fields.extend(row.inputs.iter().map(ToString::to_string));
        for (output, error) in row.outputs.iter().zip(&row.errors) {
            fields.push(format!("{output:?}"));
            fields.push(error.map_or_else(String::new, |error| format!("{error:?}")));
        }
        fields.extend([&row.error_kind, &row.warnings, &row.reason].map(Clone::clone));
        fields
    }

    /// The rows of a part from its fields, one list for each line with that of the heads first.
    ///
    /// # Errors
    /// [`PartFault`] unless it is that part of this study, and whole.
    pub fn rows(&self, part: &Part, lines: &[Vec<String>]) -> Result<Vec<Row>, PartFault> {
        let fault = |text: &str| PartFault(text.to_owned());
        let (heads, lines) = lines.split_first().ok_or_else(|| fault("is empty"))?;
        if *heads != self.columns() {
            return Err(fault("has other columns"));
        }
        if lines.len() != part.cases.len() {
            return Err(fault("has not all of its cases"));
        }
        part.cases
            .clone()
            .zip(lines)
            .map(|(case, fields)| {
                self.parsed(case, fields).ok_or_else(|| fault("has lines of something else"))
            })
            .collect()
    }

    fn parsed(&self, case: usize, fields: &[String]) -> Option<Row> {
        let inputs = self.inputs(case);
        let (number, fields) = fields.split_first()?;
        let (written, fields) = fields.split_at_checked(inputs.len())?;
        let same = inputs.iter().zip(written).all(|(input, text)| input.to_string() == *text);
        let (figures, told) = fields.split_at_checked(2 * self.outputs.len())?;
        let [error_kind, warnings, reason] = told else { return None };
        if number.parse() != Ok(case) || !same {
            return None;
        }
        let mut row = Row {
            case,
            inputs,
            outputs: Vec::new(),
            errors: Vec::new(),
            error_kind: error_kind.clone(),
            warnings: warnings.clone(),
            reason: reason.clone(),
        };
        for pair in figures.chunks_exact(2) {
            row.outputs.push(pair[0].parse().ok()?);
            row.errors.push(if pair[1].is_empty() { None } else { Some(pair[1].parse().ok()?) });
        }
        Some(row)
    }
}
