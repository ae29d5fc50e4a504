//! What `solve` adds where it is asked for: settlements relative to a datum, sensitivities, the surface.

use shtaerman::quantity::{Dimension, engineering};
use shtaerman::{Answer, Datum, Derivatives, Sensitivities, SurfaceCurve};

use super::{Table, significant};
use crate::output::Content;

/// Significant digits of a derivative.
const DIGITS: usize = 8;

/// The tables of what was asked for, each after an empty line.
#[must_use]
pub(crate) fn extras(answer: &Answer) -> String {
    let physical = answer.physical.is_some();
    let (relative, sensitivities) = match (&answer.physical, &answer.dimensionless) {
        (Some(physical), _) => (&physical.relative_settlement, &physical.sensitivities),
        (None, Some(bare)) => (&bare.relative_settlement, &bare.sensitivities),
        (None, None) => return String::new(),
    };
    let mut text = String::new();
    let length = |value: f64| {
        if physical { engineering(value, Dimension::LENGTH) } else { significant(value, DIGITS) }
    };
    if !relative.is_empty() {
        let mut table = Table::new(&["settlement relative to", "", "which itself moves by"]);
        for relative in relative {
            let datum = match relative.datum {
                Datum::Distance(x) => format!("the surface at {}", length(x)),
                Datum::Depth(depth) => format!("the depth of {}", length(depth)),
            };
            table.row(vec![datum, length(relative.settlement), length(relative.displacement)]);
        }
        text.push('\n');
        text.push_str(&table.to_string());
    }
    if let Some(sensitivities) = sensitivities {
        text.push('\n');
        text.push_str(&sensitivity_table(sensitivities).to_string());
        text.push_str(&format!(
            "derivatives (estimate), in {}, the {} kept\n",
            if physical { "SI units" } else { "numbers without dimension" },
            sensitivities.held
        ));
    }
    text
}

fn sensitivity_table(sensitivities: &Sensitivities) -> Table {
    let heads =
        ["d of", "by roughness", "by Young's modulus", "by theta0", "by force", "by settlement"];
    let columns: [fn(&Derivatives) -> Option<f64>; 5] =
        [|d| d.roughness, |d| d.young_modulus, |d| d.theta0, |d| d.force, |d| d.settlement];
    let Sensitivities { settlement, force, tilt, peak_pressure, contact_width, .. } = sensitivities;
    let rows = [
        ("settlement", settlement.as_ref()),
        ("force", force.as_ref()),
        ("tilt", tilt.as_ref()),
        ("largest pressure", peak_pressure.as_ref()),
        ("contact width", Some(contact_width)),
    ];
    let used: Vec<usize> =
        (0..columns.len()).filter(|&k| columns[k](contact_width).is_some()).collect();
    let shown: Vec<&str> =
        [heads[0]].into_iter().chain(used.iter().map(|&k| heads[k + 1])).collect();
    let mut table = Table::new(&shown);
    for (name, row) in rows {
        let Some(row) = row else { continue };
        let cells = used
            .iter()
            .map(|&k| columns[k](row).map_or(String::new(), |value| significant(value, DIGITS)));
        table.row([name.to_owned()].into_iter().chain(cells).collect());
    }
    table
}

/// The surface as CSV: `x,pressure,displacement,gap`, in SI units or without dimensions as the problem is; no gap beside the punch.
pub(crate) fn surface_csv(surface: &SurfaceCurve) -> Content<'_> {
    let SurfaceCurve { x, pressure, displacement, gap } = surface;
    let rows = (0..x.len()).map(move |i| {
        let gap = gap[i].map_or(String::new(), |gap| gap.to_string());
        vec![x[i].to_string(), pressure[i].to_string(), displacement[i].to_string(), gap]
    });
    Content::csv(&["x", "pressure", "displacement", "gap"], rows)
}
