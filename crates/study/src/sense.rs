//! Whether the cases of a study are those of mechanics, or of a slip in the input.

use shtaerman::file::AnyFile;
use shtaerman::{Contact, Error, Warning};

use crate::{Study, Summary};

/// Most cases that are looked at: a dozen of varied values and outputs have two of their own each, and five reasons and a dozen kinds of warnings one.
const MOST: usize = 41;

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
    /// What an engineer would doubt about the cases in which a varied value or an output is least or largest, the first that was refused for each reason, and the first with each warning: at most 41, each solved again.
    /// `overrides` are those of [`Study::first`].
    ///
    /// Gives the number of cases that were looked at, and the doubts, one for each kind, in order of their cases. Equations have none.
    #[must_use]
    pub fn sense_checks(&self, summary: &Summary, overrides: &[String]) -> (usize, Vec<Doubt>) {
        let mut cases = summary.telling_cases();
        cases.truncate(MOST);
        cases.sort_unstable();
        let found = self.sense_checks_of(&cases, overrides);
        (cases.len(), found)
    }

    /// The same about cases of one's choice.
    #[must_use]
    pub fn sense_checks_of(&self, cases: &[usize], overrides: &[String]) -> Vec<Doubt> {
        let mut found: Vec<Doubt> = Vec::new();
        for &case in cases {
            // The case has its reason in the results.
            for warning in self.case_checks(case, overrides).unwrap_or_default() {
                match found.iter_mut().find(|doubt| doubt.warning.code == warning.code) {
                    Some(known) if known.case == case => {}
                    Some(known) => known.count += 1,
                    None => found.push(Doubt { warning, case, count: 1 }),
                }
            }
        }
        found
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
