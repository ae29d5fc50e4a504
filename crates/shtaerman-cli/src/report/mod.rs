//! Results as text: tables for people, JSON and CSV for programs.

mod answer;
mod deck;
mod equation;
mod export;
mod extras;
mod find;
mod heading;
mod number;
mod picture;
mod shaped;
mod sheet;
mod shown;
mod stress;
mod study_units;
mod sweep;
mod table;
mod told;
mod trace;
mod words;

pub(crate) use answer::{answer_csv, answer_notes, answer_rows, answer_table};
pub(crate) use equation::{equation_csv, equation_table};
pub(crate) use export::{ForceExport, Model, SurfaceExport};
pub(crate) use extras::{extras, surface_csv};
pub(crate) use find::{CrownReport, FoundReport};
pub(crate) use heading::heading;
pub(crate) use number::significant;
pub use picture::{ContactPicture, contact_picture, contact_plot};
pub(crate) use picture::{between, refined, said_load};
pub(crate) use shaped::ShapedReport;
pub(crate) use sheet::{Entry, Sheet};
pub(crate) use shown::Shown;
pub(crate) use stress::{
    StressReport, Stresses, YieldReport, infinite_at, no_yield, stress_csv, stress_npz,
    stress_table,
};
pub(crate) use study_units::{Scaled, StudyUnits};
pub(crate) use sweep::{
    SweepReport, columns, csv_columns, keep, response, rows_csv, rows_table, sweep_table, times,
};
pub(crate) use table::Table;
pub(crate) use told::{Part, Told};
pub(crate) use trace::{TraceReport, trace_csv};
pub(crate) use words::sentences;
