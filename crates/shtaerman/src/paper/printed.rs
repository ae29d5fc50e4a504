//! The printed figures, data in `data/paper_tables.json`.

use std::sync::LazyLock;

use serde::Deserialize;

use super::Base;

/// Tables 1-3 as printed.
#[derive(Debug, Deserialize)]
pub(super) struct Tables {
    pub(super) table1: Table,
    pub(super) table2: Table,
    pub(super) table3: Table3,
}

/// Table 1 or 2: `lambda0, delta0, alpha0, p0(-1), p0(1)`.
#[derive(Debug, Deserialize)]
pub(super) struct Table {
    pub(super) profile_over_lambda0: String,
    pub(super) n: usize,
    pub(super) rows: Vec<Vec<String>>,
    pub(super) misprint: Option<Misprint>,
}

/// Table 3: `lambda0, delta0, |M0|` of the left half and `delta0, |M0|` of the right half.
#[derive(Debug, Deserialize)]
pub(super) struct Table3 {
    pub(super) left: Half,
    pub(super) right: Half,
    pub(super) rows: Vec<Vec<String>>,
}

/// One half of Table 3.
#[derive(Debug, Deserialize)]
pub(super) struct Half {
    pub(super) profile_over_lambda0: String,
    pub(super) n: usize,
}

/// The one figure that is a misprint.
#[derive(Debug, Deserialize)]
pub(super) struct Misprint {
    pub(super) lambda0: String,
    pub(super) column: String,
}

/// The tables.
#[allow(clippy::expect_used, reason = "the data is part of the program; the tests read it")]
pub(super) fn tables() -> &'static Tables {
    static TABLES: LazyLock<Tables> = LazyLock::new(|| {
        serde_json::from_str(include_str!("../../data/paper_tables.json"))
            .expect("the printed tables are valid")
    });
    &TABLES
}

/// A printed number; NaN if it were none.
pub(super) fn number(printed: &str) -> f64 {
    printed.parse().unwrap_or(f64::NAN)
}

/// The base that a table's `profile_over_lambda0` names: a sum of `1`, `xi`, `xi^2`.
pub(super) fn base(text: &str) -> Base {
    let has = |term: &str| if text.split(" + ").any(|part| part == term) { 1.0 } else { 0.0 };
    Base { constant: has("1"), linear: has("xi"), square: has("xi^2") }
}
