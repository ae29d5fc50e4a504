//! The parts of a picture: panels with axes, and layers of curves, bands, areas and marks.

use super::axis::Axis;
use super::colour::{Colour, Palette};
use super::format::Size;

/// Something that can be drawn.
pub trait Plot {
    /// The panels, curves and labels to draw.
    fn figure(&self) -> Figure;

    /// The size on a screen that suits what is drawn; none for the default.
    fn usual_size(&self) -> Option<Size> {
        None
    }
}

/// A picture: a title, notes and panels.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Title; empty for none.
    pub title: String,
    /// Notes below the title, each from a new line.
    pub notes: Vec<String>,
    /// The panels.
    pub panels: Vec<Panel>,
    /// How the panels lie to each other.
    pub arrangement: Arrangement,
    /// Where curves are named.
    pub legend: LegendPlace,
}

impl Plot for Figure {
    fn figure(&self) -> Figure {
        self.clone()
    }
}

/// How the panels of a figure lie to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Arrangement {
    /// One above the other, with one horizontal range for all.
    Stacked,
    /// Side by side, with one vertical range for all.
    SideBySide,
}

/// Where curves are named.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LegendPlace {
    /// Above each panel.
    Panel,
    /// Once, above all panels; equal names are shown once.
    Figure,
}

/// A pair of axes and what is drawn between them.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Heading; empty for none.
    pub heading: String,
    /// Horizontal axis.
    pub horizontal: Axis,
    /// Vertical axis.
    pub vertical: Axis,
    /// What is drawn, from back to front.
    pub layers: Vec<Layer>,
    /// How many units of the horizontal axis one of the vertical axis is long, where both are lengths: heights are then drawn by a round factor larger than
    /// lengths, which the panel states.
    pub length_of_height: Option<f64>,
    /// A small panel in the upper right corner.
    pub inset: Option<Box<Panel>>,
}

impl Panel {
    /// A panel without heading.
    #[must_use]
    pub fn new(horizontal: Axis, vertical: Axis, layers: Vec<Layer>) -> Self {
        let heading = String::new();
        Self { heading, horizontal, vertical, layers, length_of_height: None, inset: None }
    }
}

/// One thing drawn in a panel.
#[derive(Debug, Clone, PartialEq)]
pub enum Layer {
    /// A curve.
    Line(Line),
    /// The strip between two curves.
    Band(Band),
    /// What lies between a curve and a base.
    Area(Area),
    /// A straight line across the panel.
    Mark(Mark),
    /// A value over the panel, as bands of colour.
    Contours(Contours),
    /// What the colours of the bands mean, at the right of the panel.
    ColourBar(ColourBar),
    /// A point.
    Cross(Cross),
    /// A place where a curve runs out of the frame to infinity.
    Pole(Pole),
}

/// A value over a rectangular grid, drawn as bands of colour between levels.
#[derive(Debug, Clone, PartialEq)]
pub struct Contours {
    /// Positions.
    pub x: Vec<f64>,
    /// Places on the vertical axis.
    pub y: Vec<f64>,
    /// Values, one row for each place on the vertical axis.
    pub values: Vec<f64>,
    /// Levels between the bands, increasing.
    pub levels: Vec<f64>,
    /// Colours.
    pub palette: Palette,
}

/// The colours of bands and the levels between them.
#[derive(Debug, Clone, PartialEq)]
pub struct ColourBar {
    /// Name and unit of the value.
    pub label: String,
    /// Levels between the bands, increasing.
    pub levels: Vec<f64>,
    /// Colours.
    pub palette: Palette,
    /// Whether there are values below the first and above the last band, which the outer colours stand for: the bar ends in an arrow there.
    pub goes_on: [bool; 2],
}

/// A place where a curve goes to infinity, shown by an arrow at a side of the frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Pole {
    /// Name in the legend; empty for none.
    pub name: String,
    /// Where on the horizontal axis.
    pub at: f64,
    /// Colour of the curve.
    pub colour: Colour,
    /// Whether it goes up, and not down.
    pub is_upward: bool,
}

/// A marked point.
#[derive(Debug, Clone, PartialEq)]
pub struct Cross {
    /// Name in the legend; empty for none.
    pub name: String,
    /// Where.
    pub at: (f64, f64),
}

/// Stroke of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Dash {
    /// Unbroken.
    #[default]
    Solid,
    /// Long strokes.
    Dashed,
    /// Short strokes.
    Dotted,
    /// Long and short strokes in turn.
    DashDotted,
}

/// A curve through points; a point that cannot be drawn breaks it.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Name in the legend; empty for none.
    pub name: String,
    /// The points in the order in which they are joined.
    pub points: Vec<(f64, f64)>,
    /// Colour.
    pub colour: Colour,
    /// Width of the stroke, in units of the picture's size.
    pub width: f64,
    /// Stroke.
    pub dash: Dash,
    /// Whether each point is shown by a dot.
    pub dots: bool,
    /// Whether the axes must hold the whole curve; otherwise it is cut at the frame.
    pub sets_range: bool,
}

impl Line {
    /// An unbroken curve without dots.
    #[must_use]
    pub fn new(name: impl Into<String>, points: Vec<(f64, f64)>, colour: Colour) -> Self {
        Self {
            name: name.into(),
            points,
            colour,
            width: 2.0,
            dash: Dash::Solid,
            dots: false,
            sets_range: true,
        }
    }
}

/// The strip between two curves over the same positions.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Name in the legend; empty for none.
    pub name: String,
    /// Position, lower and upper value.
    pub points: Vec<(f64, f64, f64)>,
    /// Colour.
    pub colour: Colour,
    /// Opacity, 0 to 1.
    pub opacity: f64,
}

/// Where an [`Area`] ends on the other side of its curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Base {
    /// At the upper side of the frame.
    Top,
    /// At the lower side of the frame.
    Bottom,
    /// At zero, and only where the curve is negative.
    NegativeToZero,
}

/// What lies between a curve and a base.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    /// Name in the legend; empty for none.
    pub name: String,
    /// Points of the curve.
    pub points: Vec<(f64, f64)>,
    /// The other side.
    pub base: Base,
    /// Colour.
    pub colour: Colour,
    /// Opacity, 0 to 1.
    pub opacity: f64,
}

/// A straight line across the panel.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// Name in the legend; empty for none.
    pub name: String,
    /// Where it crosses its axis.
    pub at: f64,
    /// Whether it stands upright, at a place on the horizontal axis.
    pub vertical: bool,
    /// Colour.
    pub colour: Colour,
    /// Stroke.
    pub dash: Dash,
}

impl Mark {
    /// A thin unbroken horizontal line without a name.
    #[must_use]
    pub fn horizontal(at: f64) -> Self {
        Self { name: String::new(), at, vertical: false, colour: Colour::GREY, dash: Dash::Solid }
    }

    /// A dashed upright line.
    #[must_use]
    pub fn vertical(name: impl Into<String>, at: f64) -> Self {
        Self { name: name.into(), at, vertical: true, colour: Colour::GREY, dash: Dash::Dashed }
    }
}
