//! Columns of numbers.

use shtaerman_input::columns::Columns;
use shtaerman_input::quantity::Dimension;

use crate::broken::{broken, bytes};
use crate::check::Outcome;
use crate::{Random, check, written};

const COLUMNS: Columns = Columns {
    names: ["position", "height"],
    dimensions: [Dimension::LENGTH; 2],
    units: [1.0, 1.0],
};

/// Writes numbers in columns and reads them: unbroken ones to the last bit, broken ones finite or refused.
pub(super) fn case(random: &mut Random) -> Result<Outcome, String> {
    let separator = random.of(&[",", ";", "\t", " ", "  ", ", ", " ; "]);
    let line_end = random.of(&["\n", "\r\n"]);
    let mut text = random
        .of(&[
            "",
            "x, f\n",
            "x [m] f [m]\n",
            "x / m  f in m\n",
            "x_m;f, m\n",
            "# taken on Monday\n",
            "\u{feff}",
            "\n\n",
        ])
        .to_owned();
    let mut values = Vec::new();
    for _ in 0..random.below(30) {
        let row = [random.between(-1.0, 1.0) * random.power(-9.0, 9.0), random.power(-20.0, 5.0)];
        text += &format!("{:e}{separator}{:e}{line_end}", row[0], row[1]);
        values.push(row);
    }
    let is_broken = random.one_in(2);
    if is_broken {
        text = broken(random, &text);
        if random.one_in(4) {
            text += &format!("{},{}\n", written::number(random), written::number(random));
        }
    }
    let content = if is_broken { bytes(random, &text) } else { text.clone().into_bytes() };
    match COLUMNS.read(&content, "trace.csv") {
        Err(error) => {
            check::holds(is_broken, "sound columns are refused", &text)?;
            check::refusal(&error.to_string(), &text)
        }
        Ok(rows) => {
            let read: Vec<[f64; 2]> = rows.iter().map(|row| row.values).collect();
            check::holds(is_broken || read == values, "read otherwise than written", &text)?;
            let is_finite = read.iter().flatten().all(|value| value.is_finite());
            check::holds(is_finite, "not finite", &text)?;
            Ok(Outcome::Accepted)
        }
    }
}
