//! Places and numbers of points asked for on the command line.

use shtaerman::quantity::Dimension;

use crate::Failure;

/// Most places one `--at` may name, and most points of a curve.
const MOST_PLACES: usize = 1_000_000;

/// Refuses numbers of points that make no curve.
pub(super) fn check_points(points: usize) -> Result<(), Failure> {
    check_count("--points", points)
}

/// The same for another option.
pub(super) fn check_count(option: &str, points: usize) -> Result<(), Failure> {
    if (2..=MOST_PLACES).contains(&points) {
        return Ok(());
    }
    Err(Failure::Usage(format!("{option} {points}: must be from 2 to {MOST_PLACES}")))
}

/// The places of `--at`, each accepted by `place` or refused with its words.
pub(super) fn parse(
    text: &str,
    dimension: Dimension,
    place: &dyn Fn(f64) -> Result<f64, String>,
) -> Result<Vec<f64>, Failure> {
    let parts: Vec<&str> = text.split(',').collect();
    if parts.len() > MOST_PLACES {
        return Err(Failure::Usage(format!(
            "--at names {} places: at most {MOST_PLACES}",
            parts.len()
        )));
    }
    let parsed = |part: &str| {
        let part = part.trim();
        let value = quantity("--at", part, dimension)?;
        place(value).map_err(|words| refused("--at", part, words))
    };
    parts.into_iter().map(parsed).collect()
}

/// Two places `X1..X2` from left to right; a unit behind the second alone goes for both.
pub(super) fn range(option: &str, text: &str, dimension: Dimension) -> Result<[f64; 2], Failure> {
    let Some((from, to)) = text.split_once("..") else {
        return Err(Failure::Usage(format!(
            "{option} {text}: must be two places, such as \"-4 mm..4 mm\""
        )));
    };
    let (from, to) = (from.trim(), to.trim());
    let unit = to.trim_start_matches(|c: char| c.is_ascii_digit() || ".eE+-".contains(c));
    let with_unit = format!("{from} {unit}");
    let from = if from.parse::<f64>().is_ok() { with_unit.trim() } else { from };
    let range = [quantity(option, from, dimension)?, quantity(option, to, dimension)?];
    if range[0] < range[1] && (range[1] - range[0]).is_finite() {
        return Ok(range);
    }
    Err(Failure::Usage(format!("{option} {text}: must go from left to right")))
}

/// The value of an option that is a quantity.
pub(super) fn quantity(option: &str, text: &str, dimension: Dimension) -> Result<f64, Failure> {
    shtaerman::quantity::parse(text)
        .and_then(|quantity| quantity.of(dimension, text))
        .map_err(|error| refused(option, text, error))
}

fn refused(option: &str, text: &str, words: impl std::fmt::Display) -> Failure {
    Failure::Usage(format!("{option} `{text}`: {words}"))
}
