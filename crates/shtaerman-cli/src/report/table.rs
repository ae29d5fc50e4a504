//! Plain tables.

use std::fmt;

use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, presets};

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

    fn numeric(&self, column: usize) -> bool {
        let mut cells = self
            .inner
            .column_cells_iter(column)
            .flatten()
            .map(comfy_table::Cell::content)
            .peekable();
        cells.peek().is_some() && cells.all(|cell| cell.is_empty() || cell.parse::<f64>().is_ok())
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut table = self.inner.clone();
        for index in 0..self.columns {
            let numeric = self.numeric(index);
            if let Some(column) = table.column_mut(index) {
                column.set_constraint(ColumnConstraint::ContentWidth);
                if numeric {
                    column.set_cell_alignment(CellAlignment::Right);
                }
            }
        }
        for line in table.lines() {
            writeln!(f, "{}", line.trim_end())?;
        }
        Ok(())
    }
}
