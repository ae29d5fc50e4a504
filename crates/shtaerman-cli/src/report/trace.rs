//! A trace before and after, for people, as data and as a picture.

use std::fmt::Write;

use serde_json::{Value, json};
use shtaerman::profile::Trace;
use shtaerman::quantity::{Measure, OutputUnits};

use super::{Table, heading};
use crate::output::Content;
use crate::plot::TracePlot;

/// Name of this JSON layout and its version.
const SCHEMA: &str = "shtaerman-trace/1";

/// What was read of a trace and what was made of it.
pub(crate) struct TraceReport<'t> {
    pub(crate) name: &'t str,
    /// The name of the file without folder and suffix; empty for none.
    pub(crate) stem: String,
    /// As it is written.
    pub(crate) before: &'t Trace,
    /// In its place and levelled, with all its waves.
    pub(crate) levelled: &'t Trace,
    /// As a problem would use it.
    pub(crate) after: &'t Trace,
    /// Ends of the base.
    pub(crate) over: [f64; 2],
    /// The line of a problem file that does the same.
    pub(crate) line: String,
    pub(crate) units: &'t OutputUnits,
}

impl TraceReport<'_> {
    pub(crate) fn table(&self) -> String {
        let length = |value: f64| self.units.shown(value, Measure::Length);
        let height = |value: f64| self.units.shown(value, Measure::Displacement);
        let mut text = format!(
            "{}: {} rows, {}, separated by {}{}\n\n",
            self.name,
            self.before.positions().len(),
            self.before.encoding(),
            self.before.separator(),
            self.header()
        );
        let mut table = Table::new(&["", "as read", "as used"]);
        let traces = [self.before, self.after];
        let mut row = |name: &str, values: [String; 2]| {
            let [before, after] = values;
            table.row(vec![name.to_owned(), before, after]);
        };
        row("points", traces.map(|trace| trace.positions().len().to_string()));
        row("positions, from", traces.map(|trace| length(trace.range()[0])));
        row("to", traces.map(|trace| length(trace.range()[1])));
        row("distance of points, least", traces.map(|trace| length(trace.spacing()[0])));
        row("largest", traces.map(|trace| length(trace.spacing()[1])));
        let [lowest, highest]: [fn(f64, f64) -> f64; 2] = [f64::min, f64::max];
        for (name, pick) in [("heights, lowest", lowest), ("highest", highest)] {
            let found = |trace: &Trace| trace.heights().iter().copied().reduce(pick);
            row(name, traces.map(|trace| found(trace).map_or(String::new(), height)));
        }
        let before = self.before.deviations(self.before.range()).map(height);
        let after = self.after.deviations(self.over).map(height);
        let [[mean_before, square_before], [mean_after, square_after]] = [before, after];
        row("from the mean line, mean", [mean_before, mean_after]);
        row("root mean square", [square_before, square_after]);
        text.push_str(&table.to_string());
        if self.after.positions() != self.levelled.positions() {
            let [mean, square] = self.levelled.less(self.after).deviations(self.over).map(height);
            let _ = writeln!(text, "\nleft out by the filter: Ra {mean}, Rq {square}");
        }
        let _ = writeln!(text, "\nset: {}", self.line);
        text
    }

    /// What the columns are called.
    fn header(&self) -> String {
        let header = self.before.header();
        let [x, f] = self.before.columns();
        let name = |number: usize| match header.get(number - 1) {
            Some(name) => format!("{number} (`{}`)", shtaerman::legible(name)),
            None => number.to_string(),
        };
        format!("; positions in column {}, heights in column {}", name(x), name(f))
    }

    pub(crate) fn data(&self) -> Value {
        let of = |trace: &Trace, over: [f64; 2]| {
            let [mean, square] = trace.deviations(over);
            json!({
                "x": trace.positions(),
                "f": trace.heights(),
                "mean_deviation": mean,
                "root_mean_square_deviation": square,
            })
        };
        json!({
            "schema": SCHEMA,
            "encoding": self.before.encoding(),
            "separator": self.before.separator(),
            "header": self.before.header(),
            "columns": self.before.columns(),
            "over": self.over,
            "line": self.line,
            "before": of(self.before, self.before.range()),
            "after": of(self.after, self.over),
        })
    }

    pub(crate) fn plot(&self) -> TracePlot {
        let reach = |trace: &Trace| trace.range().iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let largest =
            |trace: &Trace| trace.heights().iter().fold(0.0f64, |most, f| most.max(f.abs()));
        let both = [self.before, self.after];
        let x = self.units.axis(both.map(reach)[0].max(reach(self.after)), Measure::Length);
        let f = both.map(|trace| self.units.axis(largest(trace), Measure::Displacement));
        let points = |trace: &Trace, factor: f64| -> Vec<(f64, f64)> {
            let pairs = trace.positions().iter().zip(trace.heights());
            pairs.map(|(position, height)| (position * x.factor, height * factor)).collect()
        };
        let [before, after] = f;
        TracePlot {
            title: match heading(&self.stem) {
                Some(name) => format!("{name}: as read and as used"),
                None => "As read and as used".to_owned(),
            },
            before: points(self.before, before.factor),
            levelled: points(self.levelled, after.factor),
            after: points(self.after, after.factor),
            ends: self.over.map(|end| end * x.factor),
            position_label: format!("x [{}]", x.label),
            height_labels: [before.label, after.label].map(|label| format!("height f [{label}]")),
        }
    }
}

/// The trace as CSV, as `profile = { csv = ".." }` reads it: in metres, or in the units chosen, which the header says.
pub(crate) fn trace_csv<'a>(trace: &'a Trace, units: &OutputUnits) -> Content<'a> {
    let column = |name: &str, measure: Measure| {
        if !units.are_chosen() {
            return (name.to_owned(), 1.0);
        }
        let unit = units.column(measure);
        (format!("{name} [{}]", unit.label), unit.factor)
    };
    let (x, length) = column("x", Measure::Length);
    let (f, height) = column("f", Measure::Displacement);
    let rows = trace.positions().iter().zip(trace.heights());
    let rows = rows.map(move |(x, f)| vec![(x * length).to_string(), (f * height).to_string()]);
    Content::csv(&[x, f], rows)
}
