//! What a study found, in few figures.

use crate::{Design, Indices, Input, Output, Row, Study};

/// Different reasons that are kept.
const REASONS: usize = 5;
/// Different texts of a varied key whose cases are kept.
const TEXTS: usize = 8;

/// The extremes of one output, its mean and its deviation; the last two over the cases in which it is finite.
#[derive(Debug, Clone, PartialEq)]
pub struct Extreme {
    /// The output.
    pub name: String,
    /// The least value, and its case.
    pub least: (f64, usize),
    /// The largest value, and its case.
    pub largest: (f64, usize),
    /// The mean over the cases that have an answer; NaN where it is finite in none.
    pub mean: f64,
    /// The standard deviation over these cases, with their number less one; NaN as the mean.
    pub standard_deviation: f64,
    /// In how many cases it is infinite, as the pressure at a corner without roughness.
    pub infinite: usize,
    /// The largest stated error.
    pub error: Option<f64>,
    /// The sum of the squares of the differences from the mean.
    squares: f64,
    /// The cases in which it is finite.
    finite: usize,
}

impl Extreme {
    fn new(output: &Output) -> Self {
        Self {
            name: output.name.clone(),
            least: (f64::INFINITY, 0),
            largest: (f64::NEG_INFINITY, 0),
            mean: f64::NAN,
            standard_deviation: f64::NAN,
            infinite: 0,
            error: None,
            squares: 0.0,
            finite: 0,
        }
    }

    fn add(&mut self, case: usize, value: f64, error: Option<f64>) {
        // The first is both, be it infinite.
        let is_first = self.finite + self.infinite == 0;
        if is_first || value < self.least.0 {
            self.least = (value, case);
        }
        if is_first || value > self.largest.0 {
            self.largest = (value, case);
        }
        if !value.is_finite() {
            self.infinite += 1;
            return;
        }
        if self.finite == 0 {
            self.mean = 0.0;
        }
        self.finite += 1;
        // B. P. Welford, Technometrics 4 (1962) 419.
        let difference = value - self.mean;
        self.mean += difference / self.finite as f64;
        self.squares += difference * (value - self.mean);
        self.standard_deviation =
            (self.squares / self.finite.saturating_sub(1).max(1) as f64).sqrt();
        self.error = self.error.into_iter().chain(error).reduce(f64::max);
    }
}

/// The cases in which a varied value is least or largest, or a text for the first time.
#[derive(Debug, Clone, PartialEq, Default)]
struct Varied {
    least: Option<(f64, usize)>,
    largest: Option<(f64, usize)>,
    texts: Vec<(String, usize)>,
}

impl Varied {
    fn add(&mut self, input: &Input, case: usize) {
        match input {
            Input::Text(text) => {
                let is_new = self.texts.iter().all(|(known, _)| known != text);
                if is_new && self.texts.len() < TEXTS {
                    self.texts.push((text.clone(), case));
                }
            }
            Input::Number(_) | Input::Whole(_) => {
                let Some(value) = input.number() else { return };
                if self.least.is_none_or(|(least, _)| value < least) {
                    self.least = Some((value, case));
                }
                if self.largest.is_none_or(|(largest, _)| value > largest) {
                    self.largest = Some((value, case));
                }
            }
        }
    }

    fn cases(&self) -> impl Iterator<Item = usize> {
        let ends = [self.least, self.largest].into_iter().flatten().map(|(_, case)| case);
        ends.chain(self.texts.iter().map(|(_, case)| *case))
    }
}

/// Extremes, means and refusals of the rows seen so far.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Cases with an answer.
    pub answered: usize,
    /// Cases without.
    pub refused: usize,
    /// The first few reasons, each with the first case that has it and the number of cases.
    pub reasons: Vec<(String, usize, usize)>,
    /// The codes of warnings, each with the first case that has it and the number of cases.
    pub warnings: Vec<(String, usize, usize)>,
    /// One for each output, in order.
    pub extremes: Vec<Extreme>,
    /// Sobol's indices, for the design that has them.
    pub indices: Option<Indices>,
    varied: Vec<Varied>,
}

impl Summary {
    /// Of no rows.
    #[must_use]
    pub fn new(study: &Study) -> Self {
        Self {
            answered: 0,
            refused: 0,
            reasons: Vec::new(),
            warnings: Vec::new(),
            extremes: study.outputs().iter().map(Extreme::new).collect(),
            indices: matches!(study.design(), Design::SobolIndices { .. })
                .then(|| Indices::new(study.variables().len(), study.outputs().len())),
            varied: vec![Varied::default(); study.variables().len()],
        }
    }

    /// Takes a row in; rows come in the order of their cases.
    pub fn add(&mut self, row: &Row) {
        if let Some(indices) = &mut self.indices {
            indices.add(row);
        }
        self.varied.iter_mut().zip(&row.inputs).for_each(|(varied, one)| varied.add(one, row.case));
        if !row.is_answered() {
            self.refuse(row);
            return;
        }
        self.answered += 1;
        for code in row.warnings.split_ascii_whitespace() {
            match self.warnings.iter_mut().find(|(known, ..)| known == code) {
                Some((.., count)) => *count += 1,
                None => self.warnings.push((code.to_owned(), row.case, 1)),
            }
        }
        let found = row.outputs.iter().zip(&row.errors);
        for (extreme, (&value, &error)) in self.extremes.iter_mut().zip(found) {
            extreme.add(row.case, value, error);
        }
    }

    /// The cases in which a slip of the input shows, without repetition: where a varied value or an output is least or largest, the first that was refused for each reason, and the first with each warning.
    pub(crate) fn telling_cases(&self) -> Vec<usize> {
        let ends = self.extremes.iter().flat_map(|extreme| [extreme.least, extreme.largest]);
        let ends = ends.filter(|_| self.answered > 0).map(|(_, case)| case);
        let varied = self.varied.iter().flat_map(Varied::cases);
        let refused = self.reasons.iter().map(|(_, first, _)| *first);
        let mut cases: Vec<usize> = Vec::new();
        let warned = self.warnings.iter().map(|(_, first, _)| *first);
        for case in warned.chain(refused).chain(varied).chain(ends) {
            if !cases.contains(&case) {
                cases.push(case);
            }
        }
        cases
    }

    fn refuse(&mut self, row: &Row) {
        self.refused += 1;
        match self.reasons.iter().position(|(reason, ..)| *reason == row.reason) {
            Some(known) => self.reasons[known].2 += 1,
            None if self.reasons.len() < REASONS => {
                self.reasons.push((row.reason.clone(), row.case, 1));
            }
            None => {}
        }
    }
}
