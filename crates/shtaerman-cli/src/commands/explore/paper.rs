//! The paper's tables and figure for the page.

use serde::Deserialize;
use serde_json::{Value, json};
use shtaerman::paper;

use super::asked;
use crate::Failure;

/// Points of a curve.
const POINTS: usize = 301;

/// A curve of Fig. 2.
#[derive(Debug, Deserialize)]
pub(super) struct AskedCurve {
    lambda0: f64,
}

/// Every figure of Tables 1-3, as `reproduce --format json` writes them.
pub(super) fn tables() -> Result<Value, Failure> {
    let found = paper::reproduce()?;
    let mut figures = serde_json::to_value(&found.figures).map_err(asked::unwritable)?;
    for (figure, told) in found.figures.iter().zip(figures.as_array_mut().into_iter().flatten()) {
        told["symbol"] = json!(figure.quantity.symbol());
        told["why"] = json!(figure.reason.map(paper::Reason::text));
    }
    Ok(json!({ "agreeing": found.agreeing(), "total": found.figures.len(), "figures": figures }))
}

/// A curve of Fig. 2 for any `lambda0`: by the formula as printed, and as it is.
pub(super) fn curve(asked: &AskedCurve) -> Result<Value, Failure> {
    let curve = paper::figure2_curve(asked.lambda0, POINTS)?;
    Ok(json!({
        "lambda0": curve.lambda0,
        "theta0": paper::theta0(curve.lambda0),
        "xi": curve.xi,
        "as_printed": curve.as_printed,
        "exact": curve.exact,
    }))
}
