//! Files that came with a document.

use std::collections::BTreeMap;
use std::sync::Arc;

/// Files by their names, which come with a document that was not read from a disk.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Attached(Arc<BTreeMap<String, Vec<u8>>>);

impl Attached {
    /// These files.
    #[must_use]
    pub fn new(files: impl IntoIterator<Item = (String, Vec<u8>)>) -> Self {
        Self(Arc::new(files.into_iter().collect()))
    }

    pub(super) fn get(&self, name: &str) -> Option<&[u8]> {
        self.0.get(name).map(Vec::as_slice)
    }
}
