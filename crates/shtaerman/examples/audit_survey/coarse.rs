//! Answers that are off on purpose: how sharp their bounds are. Answers by default are too near the truth to tell.

use std::f64::consts::PI;
use std::path::Path;

use shtaerman::{Contact, ErrorKind};

use super::draw::Case;

/// Degrees of the degenerate kernel.
const DEGREES: [usize; 4] = [6, 20, 60, 180];
/// Places at which pressures are compared, dense towards both ends.
const PLACES: u32 = 401;
/// An answer is the truth for another whose error is so many times its own.
const SHARPER: f64 = 10.0;

/// Stated over true errors where these are above `1e-11` of their size: of pressures, and of settlement, tilt, force and moment, whose errors fall as the square of the pressure's. Then what is
/// larger than stated.
pub(crate) fn ratios(
    case: &Case,
    folder: &Path,
    exact: &Contact,
) -> ([Vec<f64>; 2], Option<String>) {
    let (mut found, mut violation) = ([vec![], vec![]], None);
    let Some(sharp) =
        exact.dimensionless().error().filter(|_| case.toml.contains("contact = \"bilateral\""))
    else {
        return (found, violation);
    };
    for n in DEGREES {
        let text = case.toml.as_bytes();
        let problem =
            shtaerman::file::from_bytes(text, "survey", folder, &[format!("solver.n={n}")]);
        let Some(coarse) = problem.ok().and_then(|p| p.solve().ok()?.audited().ok()) else {
            continue;
        };
        let Some(stated) =
            coarse.dimensionless().error().filter(|stated| stated.kind == ErrorKind::Bound)
        else {
            continue;
        };
        let pressure = |i: u32| {
            let xi = -(PI * f64::from(i) / f64::from(PLACES - 1)).cos();
            let at = |contact: &Contact| contact.dimensionless().pressure(xi).unwrap_or(f64::NAN);
            (at(&coarse) - at(exact)).abs()
        };
        let displacement =
            exact.dimensionless().settlement().abs().max(exact.dimensionless().tilt().abs());
        let force = exact.dimensionless().force().abs().max(exact.dimensionless().moment().abs());
        let parts = [
            (
                stated.pressure,
                (0..PLACES).map(pressure).fold(0.0, f64::max),
                sharp.pressure,
                exact.dimensionless().peak_pressure().abs(),
            ),
            (
                stated.settlement,
                (coarse.dimensionless().settlement() - exact.dimensionless().settlement()).abs(),
                sharp.settlement,
                displacement,
            ),
            (
                stated.tilt,
                (coarse.dimensionless().tilt() - exact.dimensionless().tilt()).abs(),
                sharp.tilt,
                displacement,
            ),
            (
                stated.force,
                (coarse.dimensionless().force() - exact.dimensionless().force()).abs(),
                sharp.force,
                force,
            ),
            (
                stated.moment,
                (coarse.dimensionless().moment() - exact.dimensionless().moment()).abs(),
                sharp.moment,
                force,
            ),
        ];
        for (i, (stated, off, own, size)) in parts.into_iter().enumerate() {
            if off > stated + own {
                violation = Some(format!("solver.n = {n}: off by {off:e}, stated {stated:e}"));
            }
            if off > 1e-11 * size && off > SHARPER * own {
                found[i.min(1)].push(stated / off);
            }
        }
    }
    (found, violation)
}
