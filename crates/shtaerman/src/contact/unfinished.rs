//! What a search had come to when its time was over.

use super::solved::Contact;

/// The best that a search had come to when its [time limit](crate::Solver::with_time_limit) was reached: no answer, as its zones and its pressure are not final. Nothing is stated of its errors
/// but by an [audit](Contact::with_audit).
#[derive(Debug, Clone)]
pub struct Unfinished(Contact);

impl Unfinished {
    pub(crate) fn new(contact: Contact) -> Self {
        Self(contact)
    }

    /// The contact as far as it is known.
    #[must_use]
    pub fn contact(&self) -> &Contact {
        &self.0
    }

    pub(crate) fn map(self, change: impl FnOnce(Contact) -> Contact) -> Self {
        Self(change(self.0))
    }
}

/// The same are those of one run.
impl PartialEq for Unfinished {
    fn eq(&self, other: &Self) -> bool {
        self.0.is_same(&other.0)
    }
}
