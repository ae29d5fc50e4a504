//! Slips that are likely in what is known of a rough surface.

use shtaerman::Warning;
use shtaerman::quantity::{self, Dimension};

use crate::Failure;
use crate::arguments::{RoughnessSource, SenseArguments};

/// Heights and radii of asperities above this (m) are none of machined faces, and those in micrometres that were read as metres.
const COARSE: f64 = 1e-3;

/// What becomes of doubts.
pub(super) fn sense(source: &RoughnessSource) -> SenseArguments {
    match source {
        RoughnessSource::GreenwoodWilliamson(source) => source.sense,
        RoughnessSource::Bearing(source) => source.sense,
        RoughnessSource::Table(_) => SenseArguments::default(),
    }
}

/// What an engineer would doubt of the options alone; nothing where one is no quantity, whose fault is told by itself.
pub(super) fn of(source: &RoughnessSource) -> Vec<String> {
    let (lengths, moduli) = match source {
        RoughnessSource::GreenwoodWilliamson(source) => (
            [("--deviation", Some(&source.deviation)), ("--radius", Some(&source.radius))],
            [("--modulus", Some(&source.modulus)), ("--hardness", source.hardness.as_ref())],
        ),
        RoughnessSource::Bearing(source) => (
            [("--height", source.height.as_ref()), ("--radius", source.radius.as_ref())],
            [("--modulus", source.modulus.as_ref()), ("--hardness", source.hardness.as_ref())],
        ),
        RoughnessSource::Table(_) => return Vec::new(),
    };
    let others = match source {
        RoughnessSource::GreenwoodWilliamson(source) => {
            [Some(&source.density), source.pressure.as_ref()]
        }
        RoughnessSource::Bearing(source) => [source.pressure.as_ref(), None],
        RoughnessSource::Table(_) => [None, None],
    };
    let named = lengths.into_iter().chain(moduli).filter_map(|(_, text)| text);
    if named.chain(others.into_iter().flatten()).any(|text| quantity::parse(text).is_err()) {
        return Vec::new();
    }
    let coarse = lengths.into_iter().filter_map(|(option, text)| coarse(option, text?));
    coarse.chain(moduli.into_iter().filter_map(|(option, text)| soft(option, text?))).collect()
}

/// Refuses doubts where that is wanted.
pub(super) fn refuse(sense: &SenseArguments, doubts: &[String]) -> Result<(), Failure> {
    if !sense.strict || doubts.is_empty() {
        return Ok(());
    }
    Err(Failure::Usage(format!("--strict: {}", doubts.join("; "))))
}

/// A modulus or a hardness without a unit that no solid has.
fn soft(option: &str, text: &str) -> Option<String> {
    Some(Warning::soft_modulus(option, text.trim().parse().ok()?)?.message)
}

/// A length of asperities that is none of a machined face.
fn coarse(option: &str, text: &str) -> Option<String> {
    let text = text.trim();
    let read = quantity::parse(text).ok()?;
    let length = read.of(Dimension::LENGTH, text).ok().filter(|length| *length > COARSE)?;
    if read.unit_written() {
        return Some(format!(
            "{option} {text}: no machined face is as coarse: are micrometres meant?"
        ));
    }
    Some(format!(
        "{option} = {length} has no unit and is taken in metres, coarser than any machined face: is \"{length} um\" meant?"
    ))
}
