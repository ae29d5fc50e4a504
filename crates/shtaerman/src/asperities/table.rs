//! Tables of pressure against approach, and traces of height.

use std::path::Path;

use super::fit::{self, Fit};
use crate::Error;
use crate::document::FileError;
use crate::document::load_bytes;
use crate::error::require;
use crate::quantity::Dimension;
use shtaerman_input::columns::{Columns, Dialect, HeaderUnit, Row};

/// An approach (m) beyond this is none of asperities.
const LONGEST: f64 = 1.0;

/// Pressures against approaches, measured or from a pressure-overclosure law of a finite-element program.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// Pressure (Pa) and approach (m).
    data: Vec<[f64; 2]>,
}

impl Table {
    /// Pairs of approach (m), counted from first touch, and pressure (Pa).
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a value that is negative or not finite, for fewer than two different pressures, and for an approach that is no greater under the largest of them than under the least.
    pub fn new(pairs: impl IntoIterator<Item = [f64; 2]>) -> Result<Self, Error> {
        let mut data = Vec::new();
        for [approach, pressure] in pairs {
            let sound = |value: f64| value.is_finite() && value >= 0.0;
            require(sound(pressure), "pressure", pressure, "finite and not negative")?;
            require(
                sound(approach),
                "approach",
                approach,
                "finite and not negative: it is counted from first touch",
            )?;
            data.push([pressure, approach]);
        }
        // First touch is a row as any other: it makes one more enough for a linear law.
        let pressures = || data.iter().map(|pair| pair[0]);
        let [least, most] =
            [pressures().fold(f64::INFINITY, f64::min), pressures().fold(0.0, f64::max)];
        require(most > least, "pressure", most, "different in at least two rows")?;
        let approach_at = |pressure: f64| {
            let rows = data.iter().filter(|pair| pair[0] == pressure);
            rows.fold(0.0, |most, pair| f64::max(most, pair[1]))
        };
        let grows = approach_at(most) > approach_at(least);
        let requirement = "greater under the largest pressure than under the least";
        require(grows, "approach", approach_at(most), requirement)?;
        Ok(Self { data })
    }

    /// Number of rows.
    #[must_use]
    pub fn count(&self) -> usize {
        self.data.len()
    }

    /// `v = chi p` through the origin, by least squares of the approach.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] where the approach does not grow with the pressure.
    pub fn fit_linear(&self) -> Result<Fit, Error> {
        fit::proportional(&self.data)
    }

    /// `v = B p^kappa`, by least squares of the logarithms; rows in which either is zero say nothing.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless two rows are left and the exponent lies in `0 < kappa <= 1`.
    pub fn fit_power(&self) -> Result<Fit, Error> {
        let loaded: Vec<[f64; 2]> =
            self.data.iter().copied().filter(|[p, v]| *p > 0.0 && *v > 0.0).collect();
        let differ = loaded.iter().any(|pair| pair[0] != loaded[0][0]);
        require(
            differ,
            "rows under load",
            loaded.len() as f64,
            "at least two, under different pressures, for a power law: `--law linear` takes one",
        )?;
        fit::power(&loaded)
    }
}

/// What stands in the columns of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableOrder {
    /// Approach, then pressure.
    ApproachPressure,
    /// Pressure, then approach (overclosure), as finite-element programs have it.
    PressureApproach,
}

impl TableOrder {
    /// What a header says, if it says anything.
    fn named(names: &[String]) -> Option<Self> {
        let [one, two] = names else { return None };
        match [one, two].map(|name| is_pressure(name)) {
            [Some(true), Some(false) | None] | [None, Some(false)] => Some(Self::PressureApproach),
            [Some(false), Some(true) | None] | [None, Some(true)] => Some(Self::ApproachPressure),
            _ => None,
        }
    }
}

/// Whether the name of a column is that of a pressure, or of an approach; none where it is neither.
fn is_pressure(name: &str) -> Option<bool> {
    let name = name.trim().to_lowercase();
    let word: String = name.chars().take_while(|letter| letter.is_alphabetic()).collect();
    let is_approach = ["approach", "closure", "indentation", "deflection", "displacement"];
    if name.contains("pressure") || word == "p" {
        Some(true)
    } else if is_approach.iter().any(|known| name.contains(known)) || word == "v" {
        Some(false)
    } else {
        None
    }
}

/// Reads a table of two columns, approach and pressure, in the order given or in that of their header; without either the approach comes first. Units are SI values of the units of approach and pressure; where none is given it is that of the header, else SI.
///
/// # Errors
/// [`FileError`] with the file, and the line where one is at fault; for a header that says another order, and for columns that look like the other way round.
pub fn read_table(
    content: &[u8],
    file_name: &str,
    [approach_unit, pressure_unit]: [Option<f64>; 2],
    order: Option<TableOrder>,
) -> Result<Table, FileError> {
    let fault = |message: String| FileError::new(message).in_file(Some(file_name));
    let names = Columns::header_names(content, file_name, &Dialect::default())?;
    let named = TableOrder::named(&names);
    if let (Some(order), Some(named)) = (order, named)
        && order != named
    {
        let message = format!(
            "the header `{}` is in another order than the one given: leave that out",
            names.join(", ")
        );
        return Err(fault(message));
    }
    let pressure_first =
        order.or(named).unwrap_or(TableOrder::ApproachPressure) == TableOrder::PressureApproach;
    let approach = ("approach", Dimension::LENGTH, approach_unit);
    let pressure = ("pressure", Dimension::PRESSURE, pressure_unit);
    let [one, two] = if pressure_first { [pressure, approach] } else { [approach, pressure] };
    let columns = Columns { names: [one.0, two.0], dimensions: [one.1, two.1], units: [1.0; 2] };
    let [of_one, of_two] = columns.header_units(content, file_name, &Dialect::default())?;
    let unit = |(_, expected, given): (_, Dimension, Option<f64>), written: HeaderUnit| {
        given.unwrap_or(match written {
            HeaderUnit::Known { size, dimension, .. } if dimension == expected => size,
            _ => 1.0,
        })
    };
    let columns = Columns { units: [unit(one, of_one), unit(two, of_two)], ..columns };
    let rows = columns.read(content, file_name)?;
    let ordered = |values: [f64; 2]| if pressure_first { [values[1], values[0]] } else { values };
    for row in &rows {
        // One sound row besides: what is refused is this one.
        let [approach, pressure] = ordered(row.values);
        if approach < 0.0 || pressure < 0.0 {
            let message = format!(
                "line {}: approach {approach} m, pressure {pressure} Pa: neither may be negative; the approach is counted from first touch, so leave out rows of an open gap",
                row.line
            );
            return Err(fault(message));
        }
        if approach > LONGEST {
            let message = format!(
                "line {}: an approach of {approach} m is none of a rough surface: does the pressure come first (--columns pressure-approach), or is a unit missing?",
                row.line
            );
            return Err(fault(message));
        }
    }
    Table::new(rows.iter().map(|row| ordered(row.values))).map_err(|error| fault(error.to_string()))
}

/// Reads the table in a file, as [`read_table`] does.
///
/// # Errors
/// Those of [`read_table`], and [`FileError`] for a file that cannot be read.
pub fn open_table(
    path: &Path,
    units: [Option<f64>; 2],
    order: Option<TableOrder>,
) -> Result<Table, FileError> {
    let (bytes, name) = load(path)?;
    read_table(&bytes, &name, units, order)
}

/// Reads the trace in a file, as [`read_trace`] does.
///
/// # Errors
/// Those of [`read_trace`], and [`FileError`] for a file that cannot be read.
pub fn open_trace(path: &Path, units: [f64; 2]) -> Result<Vec<[f64; 2]>, FileError> {
    let (bytes, name) = load(path)?;
    read_trace(&bytes, &name, units)
}

fn load(path: &Path) -> Result<(Vec<u8>, String), FileError> {
    let name = path.display().to_string();
    let bytes = load_bytes(path).map_err(|message| FileError::new(message).in_file(Some(&name)))?;
    Ok((bytes, name))
}

/// Reads a trace of two columns, position and height, as pairs in metres. Units are SI values.
///
/// # Errors
/// [`FileError`] with the file and line; positions must increase.
pub fn read_trace(
    content: &[u8],
    file_name: &str,
    units: [f64; 2],
) -> Result<Vec<[f64; 2]>, FileError> {
    let columns =
        Columns { names: ["position", "height"], dimensions: [Dimension::LENGTH; 2], units };
    let rows = columns.read(content, file_name)?;
    let disorder = rows.windows(2).find(|pair| pair[1].values[0] <= pair[0].values[0]);
    if let Some([_, Row { line, values: [position, _] }]) = disorder {
        let message =
            format!("line {line}: positions must increase from row to row, {position} m does not");
        return Err(FileError::new(message).in_file(Some(file_name)));
    }
    Ok(rows.into_iter().map(|row| row.values).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Roughness;

    #[test]
    fn reads_both_orders_with_units() {
        let units = [Some(1e-6), Some(1e6)];
        let one = read_table(b"v_um;p_MPa\n0;0\n0,5;10\n1;20\n", "t.csv", units, None).unwrap();
        let swapped = Some(TableOrder::PressureApproach);
        let two = read_table(b"0,0\n10,0.5\n20,1\n", "t.csv", units, swapped).unwrap();
        assert_eq!(one, two);
        // A header tells its order, with or without units.
        for header in ["pressure,approach", "p_MPa,v_um", "contact pressure;overclosure", "p,x"] {
            let text = format!("{header}\n0;0\n10;0.5\n20;1\n");
            let three = read_table(text.as_bytes(), "t.csv", units, None).unwrap();
            assert_eq!(one, three, "{header}");
            let denied =
                read_table(text.as_bytes(), "t.csv", units, Some(TableOrder::ApproachPressure));
            assert!(denied.unwrap_err().to_string().contains("another order"), "{header}");
        }
        assert_eq!(one.count(), 3);
        // And its units.
        let text = b"pressure [MPa],approach [um]\n0,0\n10,0.5\n20,1\n";
        assert_eq!(one, read_table(text, "t.csv", [None; 2], None).unwrap());
        for fit in [one.fit_linear().unwrap(), two.fit_power().unwrap()] {
            let Roughness::Linear { compliance } = fit.roughness else { panic!("{fit:?}") };
            assert!((compliance / 0.5e-13 - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn refuses_with_line_and_reason() {
        for (text, said) in [
            ("", "at least two rows"),
            ("1,1\n", "at least two rows"),
            ("0.1,5\n0.2,5\n", "at least two rows"),
            ("0,0\n1,-5\n2,5\n", "line 2: approach 1 m, pressure -5 Pa"),
            ("1e6,1e-7\n5e6,3e-7\n", "line 1: an approach of 1000000 m is none"),
            ("2e-6,1e6\n3e-7,1e8\n", "approach = 0.0000003: must be greater under the largest"),
            ("-1,0\n1,5\n2,5\n", "line 1: approach -1 m"),
            ("0,0\n1,x\n", "line 2: the pressure is not a number: `x`"),
            ("1,inf\n", "line 1: the pressure is inf"),
            ("1,2,3\n", "needs two columns, approach and pressure, got 3"),
        ] {
            let message =
                read_table(text.as_bytes(), "t.csv", [None; 2], None).unwrap_err().to_string();
            assert!(
                message.starts_with("t.csv: ") && message.contains(said),
                "{text:?}: {message}"
            );
        }
        // No approach at all under pressure.
        assert!(Table::new([[0.0, 1e6], [0.0, 2e6]]).is_err());
        assert!(
            read_trace(b"0,1\n0,2\n", "z.csv", [1.0; 2])
                .unwrap_err()
                .to_string()
                .contains("line 2: positions must increase")
        );
    }
}
