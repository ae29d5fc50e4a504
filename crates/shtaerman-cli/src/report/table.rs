//! Plain tables.

use std::fmt;
use std::io::{self, Write};

use comfy_table::{Cell, CellAlignment, ColumnConstraint, ContentArrangement, Width, presets};

use crate::terminal::WIDTH;

/// Rows of a long table that are set together: a row in the making takes more than a kilobyte.
const PIECE: usize = 10_000;

/// Fewer words than this behind a number are its unit.
const UNIT_WORDS: usize = 3;

/// Blanks around a cell.
const PADDING: u16 = 2;

/// A table with a line under its heads, at most [`WIDTH`] wide: what is wider is set on several lines, or in parts below each other. Numbers are set to the right.
#[derive(Debug)]
pub(crate) struct Table {
    inner: comfy_table::Table,
    columns: usize,
    /// Columns that every part of a table that is too wide begins with.
    keys: usize,
}

impl Table {
    /// A table with these column heads.
    #[must_use]
    pub(crate) fn new(heads: &[impl AsRef<str>]) -> Self {
        let mut inner = comfy_table::Table::new();
        inner.load_style(presets::NOTHING).set_content_arrangement(ContentArrangement::Disabled);
        if heads.iter().any(|head| !head.as_ref().is_empty()) {
            inner.set_header(heads.iter().map(AsRef::as_ref));
        }
        Self { inner, columns: heads.len(), keys: 1 }
    }

    /// The table, whose parts begin with so many columns where it is too wide for one.
    #[must_use]
    pub(crate) fn with_keys(mut self, keys: usize) -> Self {
        self.keys = keys;
        self
    }

    /// Adds a row.
    pub(crate) fn row(&mut self, cells: Vec<String>) {
        self.inner.add_row(cells);
    }

    /// The heads of its columns, where it has some.
    #[must_use]
    pub(crate) fn heads(&self) -> Option<Vec<String>> {
        self.inner.header().map(|row| row.cell_iter().map(Cell::content).collect())
    }

    /// What is in its cells, row by row, without its heads.
    #[must_use]
    pub(crate) fn cells(&self) -> Vec<Vec<String>> {
        let rows = self.inner.row_iter();
        rows.map(|row| row.cell_iter().map(Cell::content).collect()).collect()
    }

    /// Writes a table of any number of rows, which are made twice: for the widths of the columns, and to be written.
    ///
    /// # Errors
    /// Those of `out`.
    pub(crate) fn write_long<I: Iterator<Item = Vec<String>>>(
        out: &mut dyn Write,
        heads: &[&str],
        rows: impl Fn() -> I,
    ) -> io::Result<()> {
        let mut layout = Layout::of(&Self::new(heads));
        for_pieces(heads, rows(), |piece| {
            layout.include(&piece);
            Ok(())
        })?;
        layout.fit();
        for_pieces(heads, rows(), |piece| {
            let all: Vec<usize> = (0..piece.columns).collect();
            write!(out, "{}", piece.arranged(&layout, &all))
        })
    }

    /// These columns, in the widths of the layout.
    fn arranged(&self, layout: &Layout, shown: &[usize]) -> String {
        let mut table = self.inner.clone();
        for (index, width) in layout.widths.iter().enumerate() {
            if let Some(column) = table.column_mut(index) {
                if !shown.contains(&index) {
                    column.set_constraint(ColumnConstraint::Hidden);
                    continue;
                }
                column.set_constraint(ColumnConstraint::Absolute(Width::Fixed(width + PADDING)));
                if layout.has_rows && layout.is_numeric[index] {
                    column.set_cell_alignment(CellAlignment::Right);
                }
            }
        }
        table.lines().map(|line| format!("{}\n", line.trim_end())).collect()
    }
}

/// Hands on the rows in tables, the first with the heads.
fn for_pieces(
    heads: &[&str],
    rows: impl Iterator<Item = Vec<String>>,
    mut act: impl FnMut(Table) -> io::Result<()>,
) -> io::Result<()> {
    let headless = vec![""; heads.len()];
    let mut piece = Table::new(heads);
    for (index, row) in rows.enumerate() {
        if index > 0 && index % PIECE == 0 {
            act(std::mem::replace(&mut piece, Table::new(&headless)))?;
        }
        piece.row(row);
    }
    act(piece)
}

/// How columns are set.
#[derive(Debug)]
struct Layout {
    widths: Vec<u16>,
    /// The longest word of each column, and its longest number.
    least: Vec<u16>,
    is_numeric: Vec<bool>,
    has_rows: bool,
}

impl Layout {
    fn of(table: &Table) -> Self {
        let zeros = vec![0; table.columns];
        let (widths, least) = (zeros.clone(), zeros);
        let is_numeric = vec![true; table.columns];
        let mut layout = Self { widths, least, is_numeric, has_rows: false };
        layout.include(table);
        layout
    }

    fn include(&mut self, table: &Table) {
        for (width, found) in self.widths.iter_mut().zip(table.inner.column_max_content_widths()) {
            *width = found.max(*width);
        }
        let heads: Vec<&Cell> =
            table.inner.header().into_iter().flat_map(|row| row.cell_iter()).collect();
        for index in 0..self.widths.len() {
            let mut cells = table.inner.column_cells_iter(index).flatten();
            let longest = cells
                .by_ref()
                .chain(heads.get(index).copied())
                .map(Cell::content)
                .map(|content| longest_word(&content))
                .fold(0, usize::max);
            self.least[index] = self.least[index].max(longest as u16);
            let mut cells = table.inner.column_cells_iter(index).flatten();
            self.is_numeric[index] &= cells.all(|cell| {
                let content = cell.content();
                content.is_empty() || content.parse::<f64>().is_ok()
            });
        }
        self.has_rows |= !table.inner.is_empty();
    }

    fn total(&self, columns: &[usize]) -> usize {
        columns.iter().map(|index| usize::from(self.widths[*index] + PADDING)).sum()
    }

    /// Makes columns of several words less wide, those with most room first, until the whole is at most [`WIDTH`] wide, where that is possible.
    fn fit(&mut self) {
        let all: Vec<usize> = (0..self.widths.len()).collect();
        while self.total(&all) > WIDTH {
            let can_shrink = all.iter().filter(|index| self.widths[**index] > self.least[**index]);
            let slack = |index: &usize| self.widths[*index] - self.least[*index];
            let Some(loosest) = can_shrink.copied().max_by_key(slack) else { return };
            self.widths[loosest] -= 1;
        }
    }

    /// Columns that stand beside each other, each part with the keys.
    fn parts(&self, keys: usize) -> Vec<Vec<usize>> {
        let keys: Vec<usize> = (0..keys.min(self.widths.len())).collect();
        let mut parts = vec![keys.clone()];
        for index in keys.len()..self.widths.len() {
            if let Some(part) = parts.last_mut() {
                let with: Vec<usize> = part.iter().copied().chain([index]).collect();
                if self.total(&with) <= WIDTH || part.len() == keys.len() {
                    *part = with;
                    continue;
                }
            }
            parts.push(keys.iter().copied().chain([index]).collect());
        }
        parts
    }
}

/// Characters of the longest word; a number stays with its unit.
fn longest_word(text: &str) -> usize {
    let mut words = text.split_whitespace();
    let is_value = words.next().is_some_and(|word| word.parse::<f64>().is_ok());
    if is_value && words.count() < UNIT_WORDS {
        return text.chars().count();
    }
    text.split_whitespace().map(|word| word.chars().count()).max().unwrap_or(0)
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut layout = Layout::of(self);
        layout.fit();
        let parts: Vec<String> =
            layout.parts(self.keys).iter().map(|part| self.arranged(&layout, part)).collect();
        f.write_str(&parts.join("\n"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_tables_are_set_as_one() {
        let heads = ["n", "", "name", "with zeros"];
        for count in [0, 1, PIECE - 1, PIECE, PIECE + 1, 3 * PIECE] {
            let rows = || {
                (0..count).map(|n| {
                    let name = if n + 1 == count { "last" } else { "1" };
                    vec![n.to_string(), String::new(), name.to_owned(), "0".repeat(n % 12)]
                })
            };
            let mut whole = Table::new(&heads);
            rows().for_each(|row| whole.row(row));
            let mut pieces = Vec::new();
            Table::write_long(&mut pieces, &heads, rows).unwrap();
            assert_eq!(String::from_utf8(pieces).unwrap(), whole.to_string(), "{count}");
        }
    }

    #[test]
    fn wide_tables_keep_to_the_width() {
        let mut notes = Table::new(&["", "", ""]);
        let long = "the settlement is measured against the surface far away from the punch and its neighbours";
        notes.row(vec!["settlement".into(), "3 µm".into(), long.into()]);
        let text = notes.to_string();
        assert!(text.lines().all(|line| line.chars().count() <= WIDTH), "{text}");
        let words: Vec<&str> = text.split_whitespace().collect();
        assert_eq!(words.join(" "), format!("settlement 3 µm {long}"));

        let heads: Vec<String> = (0..12).map(|index| format!("head{index}")).collect();
        let mut many = Table::new(&heads).with_keys(2);
        many.row((0..12).map(|index| format!("{index}.2345678e-10")).collect());
        let text = many.to_string();
        assert!(text.lines().all(|line| line.chars().count() <= WIDTH), "{text}");
        assert!((0..12).all(|index| text.contains(&format!("{index}.2345678e-10"))), "{text}");
        assert_eq!(text.matches("head1 ").count(), 4, "{text}");
    }
}
