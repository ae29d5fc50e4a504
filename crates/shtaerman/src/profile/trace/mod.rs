//! Traces of a base as an instrument writes them, and what is done to them before they are a profile.

mod filter;
mod level;

use shtaerman_input::columns::{Columns, Dialect, HeaderUnit, Row, Separator, Sheet, unit_symbol};

use crate::document::FileError;
use crate::quantity::{Dimension, engineering};

/// Where a trace lies under the punch.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Place {
    /// As its positions say.
    #[default]
    AsWritten,
    /// By so much to the right (m).
    Shifted(f64),
    /// With its middle under the middle of the punch.
    Centred,
}

/// How a trace is written, and what is to be done to it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TraceOptions {
    /// SI values of the units of positions and heights; none where they have no dimension.
    pub units: Option<[f64; 2]>,
    /// How the file is written.
    pub dialect: Dialect,
    /// Whether positions grow to the left: their sign is changed.
    pub is_reversed: bool,
    /// Whether heights were measured towards the body: their sign is changed.
    pub is_flipped: bool,
    /// Where it lies, after a change of sign.
    pub place: Place,
    /// Whether the mean line over the base is taken off.
    pub is_levelled: bool,
    /// Cutoff of a Gaussian filter (m), after the mean line; none for none.
    pub cutoff: Option<f64>,
    /// Whether the trace is a period of a wave from end to end: the filter then goes on round its ends.
    pub is_periodic: bool,
}

/// A trace: heights over increasing positions (m).
///
/// ```
/// use shtaerman::profile::{Place, Trace, TraceOptions};
///
/// let options = TraceOptions { units: Some([1e-3, 1e-6]), place: Place::Centred, ..TraceOptions::default() };
/// let trace = Trace::read(b"x [mm],f [um]\n0,1\n5,0\n10,1\n", "trace.csv", &options)?;
/// let base = trace.arranged(&options).covering([-5e-3, 5e-3], "trace.csv")?;
/// assert_eq!(base.positions(), [-5e-3, 0.0, 5e-3]);
/// # Ok::<(), shtaerman::document::FileError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Trace {
    positions: Vec<f64>,
    heights: Vec<f64>,
    encoding: &'static str,
    separator: Separator,
    header: Vec<String>,
    columns: [usize; 2],
    /// SI value of the unit of the positions; none where they have no dimension.
    unit: Option<f64>,
}

/// Relative slack at the edges of the punch, so that a trace that ends at the edge covers it whatever its unit rounds to.
const SLACK: f64 = 1e-9;

fn columns(units: [f64; 2]) -> Columns {
    Columns { names: ["position", "height"], dimensions: [Dimension::LENGTH; 2], units }
}

/// A length in a unit of its own (SI value), in metres with a prefix where that has no symbol or is the metre, or as a number without dimension.
fn shown(length: f64, unit: Option<f64>) -> String {
    let Some(unit) = unit else { return engineering(length, Dimension::NONE) };
    match unit_symbol(unit, Dimension::LENGTH).filter(|_| unit != 1.0) {
        Some(symbol) => format!("{} {symbol}", engineering(length / unit, Dimension::NONE)),
        None => engineering(length, Dimension::LENGTH),
    }
}

impl Trace {
    /// Reads a trace as it is written, in SI units; rows from right to left are turned round.
    ///
    /// # Errors
    /// [`FileError`] with the file and line: those of [`Columns::sheet`], positions that turn back, fewer than two rows.
    pub fn read(content: &[u8], name: &str, options: &TraceOptions) -> Result<Self, FileError> {
        let fault = |message: String| FileError::new(message).in_file(Some(name));
        let units = options.units.unwrap_or([1.0, 1.0]);
        let columns = columns(units);
        let Sheet { mut rows, encoding, separator, header, columns } =
            columns.sheet(content, name, &options.dialect)?;
        if rows.len() < 2 {
            let got = match rows.len() {
                0 if content.iter().all(u8::is_ascii_whitespace) => "the file is empty",
                0 if !header.is_empty() => "got 0: there is nothing behind the header",
                0 => "got 0",
                _ => "got 1",
            };
            return Err(fault(format!("a profile needs at least two rows of numbers, {got}")));
        }
        let is_falling = rows[1].values[0] < rows[0].values[0];
        for pair in rows.windows(2) {
            let [last, position] = [pair[0].values[0], pair[1].values[0]];
            let goes_on = if is_falling { position < last } else { position > last };
            if !goes_on {
                let line = pair[1].line;
                let way = if is_falling { "decrease" } else { "increase" };
                return Err(fault(format!(
                    "line {line}: positions must increase from row to row, or decrease all along: these {way}, and {} comes after {}",
                    shown(position, options.units.map(|units| units[0])),
                    shown(last, options.units.map(|units| units[0]))
                )));
            }
        }
        if is_falling {
            rows.reverse();
        }
        let (positions, heights) =
            rows.into_iter().map(|Row { values: [x, f], .. }| (x, f)).unzip();
        let unit = options.units.map(|units| units[0]);
        Ok(Self { positions, heights, encoding, separator, header, columns, unit })
    }

    /// What the header says of the units of positions and heights.
    ///
    /// # Errors
    /// As [`Columns::header_units`].
    pub fn header_units(
        content: &[u8],
        name: &str,
        dialect: &Dialect,
    ) -> Result<[HeaderUnit; 2], FileError> {
        columns([1.0, 1.0]).header_units(content, name, dialect)
    }

    /// The trace reversed, flipped and shifted as the options say: `x = shift +- x`, `f = +- f`.
    #[must_use]
    pub fn arranged(mut self, options: &TraceOptions) -> Self {
        if options.is_reversed {
            self.positions.iter_mut().for_each(|x| *x = -*x);
            self.positions.reverse();
            self.heights.reverse();
        }
        if options.is_flipped {
            self.heights.iter_mut().for_each(|f| *f = -*f);
        }
        let [first, last] = self.range();
        let shift = match options.place {
            Place::AsWritten => 0.0,
            Place::Shifted(by) => by,
            Place::Centred => -first.midpoint(last),
        };
        if shift != 0.0 {
            self.positions.iter_mut().for_each(|x| *x += shift);
        }
        self
    }

    /// The trace, if it covers an interval.
    ///
    /// # Errors
    /// [`FileError`] with both ranges; one that is long enough and lies elsewhere says so.
    pub fn covering(self, [left, right]: [f64; 2], name: &str) -> Result<Self, FileError> {
        let [first, last] = self.range();
        let slack = SLACK * (right - left);
        if first <= left + slack && last >= right - slack {
            return Ok(self);
        }
        let elsewhere = if self.is_elsewhere([left, right]) {
            "; it is long enough, and lies elsewhere"
        } else {
            ""
        };
        let [reach, asked] =
            [[first, last], [left, right]].map(|ends| ends.map(|end| self.shown(end)));
        // Numbers of 32 bits, for one, are off by less than is shown.
        let short = if reach == asked {
            let most = (first - left).max(right - last);
            format!(
                "; they end {} too early, as numbers of few digits do: write one row more, or a half-width so much shorter",
                self.shown(most)
            )
        } else {
            String::new()
        };
        let message = format!(
            "does not cover the punch: the rows reach from {} to {}, the punch from {} to {}{elsewhere}{short}",
            reach[0], reach[1], asked[0], asked[1]
        );
        Err(FileError::new(message).in_file(Some(name)))
    }

    /// A length in the unit of the positions.
    fn shown(&self, length: f64) -> String {
        shown(length, self.unit)
    }

    /// How many rows lie over an interval.
    #[must_use]
    pub fn rows_over(&self, [left, right]: [f64; 2]) -> usize {
        let slack = SLACK * (right - left);
        let inside = left - slack..=right + slack;
        self.positions.iter().filter(|x| inside.contains(*x)).count()
    }

    /// Whether the trace is as long as an interval that it does not cover.
    #[must_use]
    pub fn is_elsewhere(&self, [left, right]: [f64; 2]) -> bool {
        let [first, last] = self.range();
        let slack = SLACK * (right - left);
        let covers = first <= left + slack && last >= right - slack;
        !covers && last - first >= (right - left) - slack
    }

    /// The trace without the mean line of an interval, if the options say so.
    #[must_use]
    pub fn levelled(mut self, over: [f64; 2], options: &TraceOptions) -> Self {
        if options.is_levelled {
            let line = level::mean_line(&self.positions, &self.heights, over);
            for (x, f) in self.positions.iter().zip(&mut self.heights) {
                *f -= line.at(*x);
            }
        }
        self
    }

    /// The trace without short waves, if the options say so.
    ///
    /// # Errors
    /// [`FileError`] for a cutoff that the trace does not resolve, or that is longer than it.
    pub fn filtered(self, options: &TraceOptions, name: &str) -> Result<Self, FileError> {
        let Some(cutoff) = options.cutoff else { return Ok(self) };
        let filtered = filter::gaussian(
            &self.positions,
            &self.heights,
            cutoff,
            options.is_periodic,
            &|length| self.shown(length),
        );
        let (positions, heights) =
            filtered.map_err(|message| FileError::new(message).in_file(Some(name)))?;
        Ok(Self { positions, heights, ..self })
    }

    /// The points.
    pub(crate) fn into_points(self) -> (Vec<f64>, Vec<f64>) {
        (self.positions, self.heights)
    }

    /// Positions (m), increasing.
    #[must_use]
    pub fn positions(&self) -> &[f64] {
        &self.positions
    }

    /// Heights (m).
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// First and last position (m).
    #[must_use]
    pub fn range(&self) -> [f64; 2] {
        [self.positions[0], self.positions[self.positions.len() - 1]]
    }

    /// Least and largest distance of neighbours (m).
    #[must_use]
    pub fn spacing(&self) -> [f64; 2] {
        let distances = self.positions.windows(2).map(|pair| pair[1] - pair[0]);
        distances.fold([f64::INFINITY, 0.0], |[least, most], d| [least.min(d), most.max(d)])
    }

    /// The height at a position between the points, on the straight line between neighbours; beyond the ends that of the end.
    #[must_use]
    pub fn height(&self, x: f64) -> f64 {
        level::between(&self.positions, &self.heights, x)
    }

    /// Arithmetic mean and root mean square of the heights from their mean line over an interval (m), `Ra` and `Rq` where what was filtered out is looked at.
    #[must_use]
    pub fn deviations(&self, over: [f64; 2]) -> [f64; 2] {
        level::deviations(&self.positions, &self.heights, over)
    }

    /// This trace less another one, at the points of this one within the other.
    #[must_use]
    pub fn less(&self, other: &Self) -> Self {
        let [first, last] = other.range();
        let kept = self.positions.iter().zip(&self.heights);
        let kept = kept.filter(|(x, _)| (first..=last).contains(*x));
        let (positions, heights) = kept.map(|(x, f)| (*x, f - other.height(*x))).unzip();
        Self { positions, heights, ..self.clone() }
    }

    /// Name of the encoding of the file.
    #[must_use]
    pub fn encoding(&self) -> &'static str {
        self.encoding
    }

    /// What stands between the fields of the file.
    #[must_use]
    pub fn separator(&self) -> &'static str {
        self.separator.name()
    }

    /// The fields of its header; none where there is none.
    #[must_use]
    pub fn header(&self) -> &[String] {
        &self.header
    }

    /// Numbers of the columns read, from 1.
    #[must_use]
    pub fn columns(&self) -> [usize; 2] {
        self.columns.map(|index| index + 1)
    }
}
