//! Plain tables.

use std::fmt;
use std::io::{self, Write};

use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, Width, presets};

/// Rows of a long table that are set together: a row in the making takes more than a kilobyte.
const PIECE: usize = 10_000;

/// Blanks around a cell.
const PADDING: u16 = 2;

/// A table with a line under its heads; numbers are set to the right.
#[derive(Debug)]
pub(crate) struct Table {
    inner: comfy_table::Table,
    columns: usize,
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
        Self { inner, columns: heads.len() }
    }

    /// Adds a row.
    pub(crate) fn row(&mut self, cells: Vec<String>) {
        self.inner.add_row(cells);
    }

    /// What is in its cells, row by row, without its heads.
    #[must_use]
    pub(crate) fn cells(&self) -> Vec<Vec<String>> {
        let rows = self.inner.row_iter();
        rows.map(|row| row.cell_iter().map(comfy_table::Cell::content).collect()).collect()
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
        for_pieces(heads, rows(), |piece| write!(out, "{}", piece.arranged(&layout)))
    }

    fn arranged(&self, layout: &Layout) -> String {
        let mut table = self.inner.clone();
        for (index, width) in layout.widths.iter().enumerate() {
            if let Some(column) = table.column_mut(index) {
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
    is_numeric: Vec<bool>,
    has_rows: bool,
}

impl Layout {
    fn of(table: &Table) -> Self {
        let (widths, is_numeric) = (vec![0; table.columns], vec![true; table.columns]);
        let mut layout = Self { widths, is_numeric, has_rows: false };
        layout.include(table);
        layout
    }

    fn include(&mut self, table: &Table) {
        for (width, found) in self.widths.iter_mut().zip(table.inner.column_max_content_widths()) {
            *width = found.max(*width);
        }
        for (index, is_numeric) in self.is_numeric.iter_mut().enumerate() {
            let mut cells = table.inner.column_cells_iter(index).flatten();
            *is_numeric &= cells.all(|cell| {
                let content = cell.content();
                content.is_empty() || content.parse::<f64>().is_ok()
            });
        }
        self.has_rows |= !table.inner.is_empty();
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.arranged(&Layout::of(self)))
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
}
