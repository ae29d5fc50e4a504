//! The formats of parts.

use shtaerman_study::{Column, Part, PartFault, Row, Study};

use super::parquet;
use super::scaled::PartColumns;
use crate::Failure;
use crate::arguments::PartFormat;
use crate::output::Content;
use crate::output::npz::{self, Array, Values};

impl PartFormat {
    /// Its name, with which the files end.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Npz => "npz",
            Self::Parquet => "parquet",
        }
    }

    /// Whether this program writes it.
    ///
    /// # Errors
    /// [`Failure::Usage`] for Parquet where it was built without.
    pub(crate) fn check(self) -> Result<(), Failure> {
        if self == Self::Parquet && !cfg!(feature = "parquet") {
            let message = "--format parquet: this program was built without it; build it with `cargo build --release --features parquet`, use st.sweep of the Python package, or take npz";
            return Err(Failure::Usage(message.to_owned()));
        }
        Ok(())
    }

    /// What the file of a part with these rows has.
    pub(super) fn content<'r>(
        self,
        study: &'r Study,
        columns: &PartColumns,
        rows: &'r [Row],
    ) -> Result<Content<'r>, Failure> {
        Ok(match self {
            Self::Csv => columns.content(study, rows),
            Self::Npz => npz::npz(arrays(study, rows)),
            Self::Parquet => return self.check().and_then(|()| parquet::content(study, rows)),
        })
    }

    /// Whether another program writes the format as well, in other bytes that are as good.
    pub(super) fn is_of_another(self, bytes: &[u8]) -> bool {
        self == Self::Parquet && parquet::is_of_pyarrow(bytes)
    }

    /// The rows of a part from the bytes of its file.
    pub(super) fn rows(
        self,
        study: &Study,
        columns: &PartColumns,
        part: &Part,
        bytes: &[u8],
    ) -> Result<Vec<Row>, PartFault> {
        let cut = || PartFault("is cut short".to_owned());
        match self {
            Self::Csv => {
                let lines = lines(bytes).ok_or_else(cut)?;
                columns.rows(study, part, lines)
            }
            Self::Npz => {
                let names = study.columns();
                let columns: Option<Vec<Column>> =
                    npz::Archive::new(bytes).and_then(|mut archive| {
                        names.iter().map(|name| archive.column(name)).collect()
                    });
                study.rows_of_arrays(part, &columns.ok_or_else(cut)?)
            }
            Self::Parquet => {
                let columns = parquet::columns(study, bytes);
                study.rows_of_arrays(part, &columns.ok_or_else(cut)?)
            }
        }
    }
}

/// The lines of a whole CSV file, that of the heads first.
fn lines(bytes: &[u8]) -> Option<Vec<Vec<String>>> {
    if !bytes.ends_with(b"\n") {
        return None;
    }
    let mut reader = csv::ReaderBuilder::new().has_headers(false).flexible(true).from_reader(bytes);
    let lines = reader.records().map(|record| {
        record.ok().map(|fields| fields.iter().map(str::to_owned).collect::<Vec<String>>())
    });
    lines.collect()
}

fn arrays<'r>(study: &Study, rows: &[Row]) -> Vec<Array<'r>> {
    let names = study.columns();
    let values = study.arrays(rows).into_iter().map(|column| match column {
        Column::Whole(values) => Values::Whole(values),
        Column::Number(values) => Values::Numbers(Box::new(values.into_iter())),
        Column::Text(values) => Values::Texts(values),
    });
    let array = |(name, values)| Array::new(name, &[rows.len()], values);
    names.into_iter().zip(values).map(array).collect()
}
