//! The rows of cases.

use std::ops::Range;

use shtaerman::equation::Equation;
use shtaerman::file::{AnyFile, ProblemFile};
use shtaerman::{Contact, Error, Problem};

use crate::answered::Answered;
use crate::quantity::{Quantity, SweptCase};
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
        let answered = self.answered(&inputs, is_audited);
        row(self, case, inputs, answered)
    }

    fn answered(&self, inputs: &[Input], is_audited: bool) -> Result<Answered, Error> {
        if let Some(varied) = &self.way().varied
            && let Some(file) = varied.file()
        {
            return self.contact(&varied.problem(inputs)?, file, is_audited);
        }
        match self.file(inputs)? {
            AnyFile::Problem(file) => {
                self.contact(file.problem(), &file, is_audited).map_err(|error| file.locate(error))
            }
            AnyFile::Equation(file) => {
                self.equation(file.equation(), is_audited).map_err(|error| file.locate(error))
            }
        }
    }

    /// Of a problem, with the doubts about its file.
    fn contact(
        &self,
        problem: &Problem,
        file: &ProblemFile,
        is_audited: bool,
    ) -> Result<Answered, Error> {
        let audited = |contact: Contact| if is_audited { contact.audited() } else { Ok(contact) };
        let (contact, found) = match self.find {
            Some(find) => {
                let found = find.run(problem)?;
                (found.contact, Some(found.value))
            }
            None => (problem.solve()?, None),
        };
        let contact = audited(contact)?;
        let warnings = [contact.warnings(), &file.sense_checks(&contact)].concat();
        Ok(Answered::contact(&self.outputs, &contact, found)?.with_warnings(&warnings))
    }

    fn equation(&self, equation: &Equation, is_audited: bool) -> Result<Answered, Error> {
        let reach = self.outputs.iter().filter_map(Output::place).fold(0.0, f64::max);
        let solved = equation.solve_to(reach)?;
        let solved = if is_audited { solved.audited()? } else { solved };
        Answered::equation(&self.outputs, &solved)
    }

    /// How the cases are computed, found when the first of them is asked for.
    fn way(&self) -> &Way {
        self.way.get_or_init(|| match self.file(&self.inputs(0)) {
            Ok(AnyFile::Problem(file)) => {
                let is_told = |output: &Output| output.quantity().is_some_and(Quantity::is_swept);
                let may_sweep =
                    !self.is_audited && self.find.is_none() && self.outputs.iter().all(is_told);
                Way::of(&self.problem, &self.variables, *file, may_sweep)
            }
            Ok(AnyFile::Equation(_)) | Err(_) => Way::default(),
        })
    }

    /// The rows of swept cases.
    fn swept(&self, swept: &SweptCases, cases: Range<usize>) -> Vec<Row> {
        let inputs: Vec<Vec<Input>> = cases.clone().map(|case| self.inputs(case)).collect();
        let found = swept.cases(&inputs);
        let row = |((case, inputs), swept): ((usize, Vec<Input>), SweptCase)| {
            let told = |output: &Output| {
                output.quantity().and_then(|quantity| quantity.swept(&swept)).unwrap_or(f64::NAN)
            };
            let outputs: Vec<f64> = self.outputs.iter().map(told).collect();
            // What a sweep cannot tell is no case, or one of its own.
            if outputs.iter().any(|value| !value.is_finite()) {
                return self.single(case, false);
            }
            let error = |output: &Output| output.quantity()?.swept_error(&swept);
            Row {
                case,
                inputs,
                errors: self.outputs.iter().map(error).collect(),
                outputs,
                error_kind: "estimate".to_owned(),
                warnings: String::new(),
                reason: String::new(),
            }
        };
        cases.zip(inputs).zip(found).map(row).collect()
    }
}

/// What is kept of an answer, or why there is none.
fn row(study: &Study, case: usize, inputs: Vec<Input>, answered: Result<Answered, Error>) -> Row {
    match answered {
        Ok(Answered { outputs, errors, error_kind, warnings }) => {
            Row { case, inputs, outputs, errors, error_kind, warnings, reason: String::new() }
        }
        Err(error) => Row {
            case,
            inputs,
            outputs: vec![f64::NAN; study.outputs.len()],
            errors: vec![None; study.outputs.len()],
            error_kind: String::new(),
            warnings: String::new(),
            reason: error.to_string(),
        },
    }
}
