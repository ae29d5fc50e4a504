//! Pictures of contacts and of convergence, as SVG or PNG.
//!
//! Plain numbers go in: every plot is a struct of vectors and labels that turns into a [`Figure`],
//! and [`render`] turns a figure into the bytes of a file. The same figure gives the same bytes. Text
//! is measured and (in a PNG) drawn with a font that is part of the program; none need be installed.
//! An SVG names that font first and close substitutes after it.
//!
//! Numbers that cannot be drawn (NaN, infinite, beyond `1e300`, not positive on a logarithmic axis)
//! leave a gap in their curve.

mod axis;
mod bar_labels;
mod canvas;
mod colour;
mod contact;
mod contours;
mod convergence;
mod cross;
mod curves;
mod draw;
mod draw_map;
mod error;
mod figure;
mod fitting;
mod format;
mod layout;
mod legend;
mod look;
mod map;
mod mapping;
mod margins;
mod ranges;
mod raster;
mod render;
mod response;
mod shape;
mod solution;
mod text;
mod theme;
mod ticks;
mod tornado;
mod trace;

pub use axis::{Axis, Scale};
pub use colour::{Colour, Palette};
pub use contact::ContactPlot;
pub use convergence::{ConvergencePlot, ConvergenceSeries};
pub use curves::{Curve, CurvePanel, CurveScaling, CurvesPlot};
pub use error::PlotError;
pub use figure::{
    Area, Arrangement, Band, Base, ColourBar, Contours, Cross, Dash, Figure, Layer, LegendPlace,
    Line, Mark, Panel, Plot, Pole,
};
pub use format::{Format, PNG_PIXELS_PER_UNIT, Size};
pub use look::Look;
pub(crate) use look::Titled;
pub use map::MapPlot;
pub(crate) use render::page;
pub use render::{render, render_as};
pub use response::{ResponseCurve, ResponseMap, ResponsePlot, ResponseSurface};
pub use solution::SolutionPlot;
pub use theme::Theme;
pub use tornado::{Bars, TornadoPlot};
pub use trace::TracePlot;
