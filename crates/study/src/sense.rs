//! Whether the cases of a study are those of mechanics, or of a slip in the input.

use shtaerman::file::AnyFile;
use shtaerman::{Contact, Error, Warning};

use crate::{Study, Summary};

/// Most cases that are looked at: those of the extremes of so many outputs that each has two of its own.
const MOST: usize = 24;

/// What an engineer would doubt about cases of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Doubt {
    /// The warning of the first of these cases.
    pub warning: Warning,
    /// The first of them.
    pub case: usize,
    /// How many of those that were looked at have a warning of this kind.
    pub count: usize,
}

impl Study {
    /// What an engineer would doubt about the cases in which an output is least or largest, the first 24 of them, each solved again; and about the first case, where none has an answer. Slips of
    /// the input show in extremes: too steep, too soft, too much force. `overrides` are those of [`Study::first`].
    ///
    /// Gives the number of cases that were looked at, and the doubts, one for each kind, in order of their cases. Equations have none.
    #[must_use]
    pub fn sense_checks(&self, summary: &Summary, overrides: &[String]) -> (usize, Vec<Doubt>) {
        let mut cases: Vec<usize> = Vec::new();
        for extreme in summary.extremes.iter().filter(|_| summary.answered > 0) {
            // An output that is no number anywhere has no extremes.
            let ends = [extreme.least, extreme.largest];
            let known = ends.into_iter().filter(|(value, _)| value.is_finite());
            for (_, case) in known {
                if cases.len() < MOST && !cases.contains(&case) {
                    cases.push(case);
                }
            }
        }
        if cases.is_empty() {
            cases.push(0);
        }
        cases.sort_unstable();
        let mut found: Vec<Doubt> = Vec::new();
        for &case in &cases {
            // The case has its reason in the results.
            for warning in self.case_checks(case, overrides).unwrap_or_default() {
                match found.iter_mut().find(|doubt| doubt.warning.code == warning.code) {
                    Some(known) if known.case == case => {}
                    Some(known) => known.count += 1,
                    None => found.push(Doubt { warning, case, count: 1 }),
                }
            }
        }
        (cases.len(), found)
    }

    /// The sense checks of a case; those of its input alone, where it has no answer.
    fn case_checks(&self, case: usize, overrides: &[String]) -> Result<Vec<Warning>, Error> {
        let AnyFile::Problem(file) = self.case_file(case, overrides)? else {
            return Ok(Vec::new());
        };
        let contact: Result<Contact, Error> = match self.find {
            Some(find) => find.run(file.problem()).map(|found| found.contact),
            None => file.problem().solve(),
        };
        Ok(contact.map_or_else(|_| file.input_checks(), |contact| file.sense_checks(&contact)))
    }
}
