//! The keys that readers asked for, and what an unknown key was perhaps meant to be.

use std::collections::{BTreeMap, BTreeSet};

use super::value::dotted;
use crate::nearest;

/// Keys by the dotted path of their table; the table at the top has the empty path.
#[derive(Debug, Default)]
pub(super) struct Vocabulary {
    known: BTreeMap<String, BTreeSet<String>>,
    /// Tables that a reader was made for. Only in these can a key be unknown.
    read: BTreeSet<String>,
}

impl Vocabulary {
    pub(super) fn ask(&mut self, table: &str, key: &str) {
        if !self.knows(table, key) {
            self.known.entry(table.to_owned()).or_default().insert(key.to_owned());
        }
    }

    pub(super) fn begin(&mut self, table: &str) {
        self.read.insert(table.to_owned());
    }

    pub(super) fn is_read(&self, table: &str) -> bool {
        self.read.contains(table)
    }

    /// Whether any key of the table is known.
    pub(super) fn is_described(&self, table: &str) -> bool {
        self.known.contains_key(table)
    }

    pub(super) fn knows(&self, table: &str, key: &str) -> bool {
        self.known.get(table).is_some_and(|keys| keys.contains(key))
    }

    fn keys(&self, table: &str) -> impl Iterator<Item = &str> {
        self.known.get(table).into_iter().flatten().map(String::as_str)
    }

    /// The message and the help for a key of `table` that nobody asked for.
    pub(super) fn unknown(&self, table: &str, key: &str) -> (String, Option<String>) {
        let elsewhere = self.known.iter().find(|(_, keys)| keys.contains(key));
        if let Some((home, _)) = elsewhere {
            return (format!("belongs in {}, not in {}", titled(home), titled(table)), None);
        }
        if let Some(name) = nearest(key, self.keys(table)) {
            return (format!("is not a known key, did you mean {name}?"), None);
        }
        let mut others = self.known.iter().filter(|(home, _)| home.as_str() != table);
        let near = others.find_map(|(home, keys)| {
            nearest(key, keys.iter().map(String::as_str)).map(|name| dotted(home, name))
        });
        if let Some(name) = near {
            return (format!("is not a known key, did you mean {name}?"), None);
        }
        let known: Vec<&str> = self.keys(table).collect();
        let help = if known.is_empty() {
            format!("{} takes no keys here", titled(table))
        } else {
            format!("known keys of {}: {}", titled(table), known.join(", "))
        };
        ("is not a known key".to_owned(), Some(help))
    }
}

/// A table as it is headed in a file.
pub(super) fn titled(table: &str) -> String {
    if table.is_empty() { "the top of the file".to_owned() } else { format!("[{table}]") }
}
