//! The rows of a part, column by column, as files of arrays have them.

use crate::{Input, Part, PartFault, Row, Study};

/// The values of one column.
#[derive(Debug, Clone, PartialEq)]
pub enum Column {
    /// Whole numbers.
    Whole(Vec<i64>),
    /// Numbers; NaN where there is none.
    Number(Vec<f64>),
    /// Texts.
    Text(Vec<String>),
}

impl Column {
    /// How many values it has.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Whole(values) => values.len(),
            Self::Number(values) => values.len(),
            Self::Text(values) => values.len(),
        }
    }

    /// Whether it has none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn numbers(&self) -> Option<&[f64]> {
        if let Self::Number(values) = self { Some(values) } else { None }
    }

    fn texts(&self) -> Option<&[String]> {
        if let Self::Text(values) = self { Some(values) } else { None }
    }

    /// The same bits, so that NaN is NaN.
    fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Number(ours), Self::Number(theirs)) => {
                ours.iter().map(|x| x.to_bits()).eq(theirs.iter().map(|x| x.to_bits()))
            }
            _ => self == other,
        }
    }
}

impl Study {
    /// Rows as columns, in the order of [`columns`](Self::columns).
    #[must_use]
    pub fn arrays(&self, rows: &[Row]) -> Vec<Column> {
        let cases = rows.iter().map(|row| row.case as i64).collect();
        let mut arrays = vec![Column::Whole(cases)];
        let inputs: Vec<&[Input]> = rows.iter().map(|row| row.inputs.as_slice()).collect();
        arrays.extend(self.input_arrays(&inputs));
        for index in 0..self.outputs().len() {
            arrays.push(Column::Number(rows.iter().map(|row| row.outputs[index]).collect()));
            let errors = rows.iter().map(|row| row.errors[index].unwrap_or(f64::NAN));
            arrays.push(Column::Number(errors.collect()));
        }
        let texts: [fn(&Row) -> &String; 3] =
            [|row| &row.error_kind, |row| &row.warnings, |row| &row.reason];
        arrays.extend(texts.map(|text| Column::Text(rows.iter().map(text).cloned().collect())));
        arrays
    }

    /// A column for each variable: of numbers where all of its values are.
    fn input_arrays(&self, inputs: &[&[Input]]) -> Vec<Column> {
        let array = |(index, variable): (usize, &crate::Variable)| {
            let values = inputs.iter().map(|values| &values[index]);
            if variable.is_number() {
                Column::Number(values.map(|value| value.number().unwrap_or(f64::NAN)).collect())
            } else {
                Column::Text(values.map(ToString::to_string).collect())
            }
        };
        self.variables().iter().enumerate().map(array).collect()
    }

    /// The rows of a part from its columns.
    ///
    /// # Errors
    /// [`PartFault`] unless it is that part of this study, and whole.
    pub fn rows_of_arrays(&self, part: &Part, arrays: &[Column]) -> Result<Vec<Row>, PartFault> {
        let fault = |text: &str| PartFault(text.to_owned());
        if arrays.len() != self.columns().len() {
            return Err(fault("has other columns"));
        }
        if arrays.iter().any(|array| array.len() != part.cases.len()) {
            return Err(fault("has not all of its cases"));
        }
        let cases = part.cases.clone();
        let inputs: Vec<Vec<Input>> = cases.clone().map(|case| self.inputs(case)).collect();
        let views: Vec<&[Input]> = inputs.iter().map(Vec::as_slice).collect();
        let mut expected = vec![Column::Whole(cases.clone().map(|case| case as i64).collect())];
        expected.extend(self.input_arrays(&views));
        let is_ours = expected.iter().zip(arrays).all(|(ours, theirs)| ours.is_same(theirs));
        let told = &arrays[expected.len()..];
        let (figures, texts) = told.split_at(2 * self.outputs().len());
        let figures = figures.iter().map(Column::numbers).collect::<Option<Vec<_>>>();
        let texts = texts.iter().map(Column::texts).collect::<Option<Vec<_>>>();
        let (Some(figures), Some(&[error_kinds, warnings, reasons]), true) =
            (figures, texts.as_deref(), is_ours)
        else {
            return Err(fault("has columns of something else"));
        };
        let row = |(place, (case, inputs)): (usize, (usize, Vec<Input>))| Row {
            case,
            inputs,
            outputs: figures.iter().step_by(2).map(|values| values[place]).collect(),
            errors: figures
                .iter()
                .skip(1)
                .step_by(2)
                .map(|values| Some(values[place]).filter(|error| !error.is_nan()))
                .collect(),
            error_kind: error_kinds[place].clone(),
            warnings: warnings[place].clone(),
            reason: reasons[place].clone(),
        };
        Ok(cases.zip(inputs).enumerate().map(row).collect())
    }
}
