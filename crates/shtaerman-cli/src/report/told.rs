//! What a command tells people: lines and tables, for a terminal or for a page.

use std::fmt;

use super::Table;

/// A part of what is told.
#[derive(Debug)]
pub(crate) enum Part {
    /// Lines, each with its end.
    Lines(String),
    /// A table.
    Table(Box<Table>),
}

/// Lines and tables in their order.
#[derive(Debug, Default)]
pub(crate) struct Told {
    parts: Vec<Part>,
}

impl Told {
    /// Begins with these lines.
    pub(crate) fn new(lines: impl Into<String>) -> Self {
        Self { parts: vec![Part::Lines(lines.into())] }
    }

    /// Adds lines.
    pub(crate) fn push_str(&mut self, lines: &str) {
        match self.parts.last_mut() {
            Some(Part::Lines(last)) => last.push_str(lines),
            _ => self.parts.push(Part::Lines(lines.to_owned())),
        }
    }

    /// Adds a line feed.
    pub(crate) fn push(&mut self, letter: char) {
        self.push_str(letter.encode_utf8(&mut [0; 4]));
    }

    /// Adds a table.
    pub(crate) fn table(&mut self, table: Table) {
        self.parts.push(Part::Table(Box::new(table)));
    }

    /// Adds all of another.
    pub(crate) fn append(&mut self, other: Self) {
        for part in other.parts {
            match part {
                Part::Lines(lines) => self.push_str(&lines),
                Part::Table(table) => self.table(*table),
            }
        }
    }

    /// Its parts.
    pub(crate) fn parts(&self) -> &[Part] {
        &self.parts
    }
}

impl fmt::Write for Told {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.push_str(text);
        Ok(())
    }
}

impl fmt::Display for Told {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.parts.iter().try_for_each(|part| match part {
            Part::Lines(lines) => formatter.write_str(lines),
            Part::Table(table) => write!(formatter, "{table}"),
        })
    }
}
