//! The rows of cases.

use std::ops::Range;

use shtaerman::{Contact, Error};

use crate::output::SweptCase;
use crate::way::{SweptCases, Way};
use crate::{Input, Output, Row, Study};

/// Cases of a sweep that a thread takes together.
const SWEPT_TOGETHER: usize = 4096;

impl Study {
    /// Solves cases, one after the other; each row depends on its case alone.
    #[must_use]
    pub fn solve(&self, cases: Range<usize>) -> Vec<Row> {
        match &self.way().swept {
            Some(swept) => self.swept(swept, cases),
            None => cases.map(|case| self.single(case, self.is_audited)).collect(),
        }
    }

    /// How many cases are best solved together: many where each takes less than a microsecond.
    #[must_use]
    pub fn block(&self) -> usize {
        if self.way().swept.is_some() { SWEPT_TOGETHER } else { 1 }
    }

    /// Solves a case and audits the answer.
    #[must_use]
    pub fn solve_audited(&self, case: usize) -> Row {
        self.single(case, true)
    }

    fn single(&self, case: usize, is_audited: bool) -> Row {
        let inputs = self.inputs(case);
        let contact = self.contact(&inputs, is_audited);
        row(self, case, inputs, contact)
    }

    fn contact(&self, inputs: &[Input], is_audited: bool) -> Result<Contact, Error> {
        if let Some(varied) = &self.way().varied {
            let contact = varied.problem(inputs)?.solve()?;
            return if is_audited { contact.audited() } else { Ok(contact) };
        }
        let file = self.file(inputs)?;
        let contact = file.solve()?;
        if is_audited { contact.audited().map_err(|error| file.locate(error)) } else { Ok(contact) }
    }

    /// How the cases are computed, found when the first of them is asked for.
    fn way(&self) -> &Way {
        self.way.get_or_init(|| match self.file(&self.inputs(0)) {
            Ok(file) => {
                let may_sweep =
                    !self.is_audited && self.outputs.iter().all(|output| output.swept.is_some());
                Way::of(&self.problem, &self.variables, file.problem(), may_sweep)
            }
            Err(_) => Way::default(),
        })
    }

    /// The rows of swept cases.
    fn swept(&self, swept: &SweptCases, cases: Range<usize>) -> Vec<Row> {
        let inputs: Vec<Vec<Input>> = cases.clone().map(|case| self.inputs(case)).collect();
        let found = swept.cases(&inputs);
        let row = |((case, inputs), swept): ((usize, Vec<Input>), SweptCase)| {
            let told = |output: &Output| output.swept.map_or(f64::NAN, |value| value(&swept));
            let outputs: Vec<f64> = self.outputs.iter().map(told).collect();
            // What a sweep cannot tell is no case, or one of its own.
            if outputs.iter().any(|value| !value.is_finite()) {
                return self.single(case, false);
            }
            let error =
                |output: &Output| Some(output.swept_error.map(|error| error(&swept))).flatten();
            Row {
                case,
                inputs,
                errors: self.outputs.iter().map(error).collect(),
                outputs,
                error_kind: "estimate".to_owned(),
                reason: String::new(),
            }
        };
        cases.zip(inputs).zip(found).map(row).collect()
    }
}

/// What is kept of a contact, or why there is none.
fn row(study: &Study, case: usize, inputs: Vec<Input>, contact: Result<Contact, Error>) -> Row {
    match contact {
        Ok(contact) => Row {
            case,
            inputs,
            outputs: study.outputs.iter().map(|output| output.value(&contact)).collect(),
            errors: study.outputs.iter().map(|output| output.error(&contact)).collect(),
            error_kind: contact
                .error()
                .map_or_else(String::new, |error| error.kind.name().to_owned()),
            reason: String::new(),
        },
        Err(error) => Row {
            case,
            inputs,
            outputs: vec![f64::NAN; study.outputs.len()],
            errors: vec![None; study.outputs.len()],
            error_kind: String::new(),
            reason: error.to_string(),
        },
    }
}
