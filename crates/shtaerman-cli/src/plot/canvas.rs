//! Lines, fills and text on the scene that the encoders read.

use kuva::render::color::Color;
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor};

use super::colour::Colour;
use super::figure::Dash;
use super::format::Size;
use super::shape;
use super::theme::{Sizes, Theme};

/// First family is the font of the PNG; the others are close in width.
const FONTS: &str = "DejaVu Sans, Verdana, Liberation Sans, Arial, sans-serif";
/// Places farther out than this are drawn at this distance, where the encoders still count exactly.
const FARTHEST: f64 = 1e6;

/// A point of the picture, from its upper left corner.
pub(super) type Point = (f64, f64);

/// A rectangle of the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Frame {
    pub(super) fn width(self) -> f64 {
        self.right - self.left
    }

    pub(super) fn height(self) -> f64 {
        self.bottom - self.top
    }

    pub(super) fn centre(self) -> Point {
        (0.5 * (self.left + self.right), 0.5 * (self.top + self.bottom))
    }
}

/// Which part of a text lies at its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// Size, colour and placing of a text.
#[derive(Debug, Clone, Copy)]
pub(super) struct Style {
    pub(super) size: u32,
    pub(super) colour: Colour,
    pub(super) anchor: Anchor,
    /// Read from below to above.
    pub(super) upright: bool,
}

/// A picture being drawn.
pub(super) struct Canvas {
    scene: Scene,
    theme: Theme,
    sizes: Sizes,
}

impl Canvas {
    pub(super) fn new(size: Size, theme: Theme, sizes: Sizes) -> Self {
        let mut scene = Scene::new(f64::from(size.width), f64::from(size.height));
        scene.font_family = Some(FONTS.to_owned());
        let Colour(red, green, blue) = theme.colour(Colour::PAPER);
        scene.background_color = Some(format!("#{red:02x}{green:02x}{blue:02x}"));
        Self { scene, theme, sizes }
    }

    pub(super) fn theme(&self) -> Theme {
        self.theme
    }

    pub(super) fn sizes(&self) -> Sizes {
        self.sizes
    }

    fn ink(&self, colour: Colour) -> Color {
        let Colour(red, green, blue) = self.theme.colour(colour);
        Color::Rgb(red, green, blue)
    }

    pub(super) fn finish(self) -> Scene {
        self.scene
    }

    pub(super) fn line(&mut self, from: Point, to: Point, colour: Colour, width: f64) {
        let (stroke, stroke_width) = (self.ink(colour), width * self.sizes().stroke);
        self.scene.add(Primitive::Line {
            x1: near(from.0),
            y1: near(from.1),
            x2: near(to.0),
            y2: near(to.1),
            stroke,
            stroke_width,
            stroke_dasharray: None,
        });
    }

    /// A polyline. Dashes are cut here: one encoder starts them anew at every point.
    pub(super) fn path(&mut self, points: &[Point], colour: Colour, width: f64, dash: Dash) {
        let points = shape::thinned(points);
        let scaled = |pattern: [f64; 4]| pattern.map(|length| self.sizes.scale * length);
        let pieces = match dash {
            Dash::Solid => vec![points],
            Dash::Dashed => shape::dashes(&points, &scaled([7.0, 4.0, 7.0, 4.0])),
            Dash::Dotted => shape::dashes(&points, &scaled([1.5, 3.5, 1.5, 3.5])),
            Dash::DashDotted => shape::dashes(&points, &scaled([8.0, 3.5, 1.5, 3.5])),
        };
        let (stroke, width) = (self.ink(colour), width * self.sizes().stroke);
        if dash == Dash::Solid {
            for piece in pieces {
                self.scene.add(Primitive::PolyLine {
                    points: piece.iter().map(|&(x, y)| (near(x), near(y))).collect(),
                    stroke: stroke.clone(),
                    stroke_width: width,
                    stroke_dasharray: None,
                });
            }
        } else {
            let d = pieces.iter().map(|piece| commands(piece, "")).collect();
            self.add_path(d, None, stroke, width, 1.0);
        }
    }

    /// A filled polygon.
    pub(super) fn fill(&mut self, points: &[Point], colour: Colour, opacity: f64) {
        let fill = Some(self.ink(colour));
        self.add_path(commands(points, "Z"), fill, Color::None, 0.0, opacity);
    }

    fn add_path(
        &mut self,
        d: String,
        fill: Option<Color>,
        stroke: Color,
        width: f64,
        opacity: f64,
    ) {
        self.scene.add(Primitive::Path(Box::new(PathData {
            d,
            fill,
            stroke,
            stroke_width: width,
            opacity: (opacity < 1.0).then_some(opacity),
            stroke_dasharray: None,
        })));
    }

    pub(super) fn dot(&mut self, at: Point, radius: f64, colour: Colour) {
        let fill = self.ink(colour);
        self.scene.add(Primitive::Circle {
            cx: near(at.0),
            cy: near(at.1),
            r: self.sizes.scale * radius,
            fill,
            fill_opacity: None,
            stroke: None,
            stroke_width: None,
        });
    }

    /// A line of text whose letters are centred on the height of its point.
    pub(super) fn text(&mut self, at: Point, text: &str, style: Style) {
        if text.is_empty() {
            return;
        }
        let drop = 0.36 * f64::from(style.size);
        let colour = self.ink(style.colour);
        let (x, y) = if style.upright { (at.0 + drop, at.1) } else { (at.0, at.1 + drop) };
        self.scene.add(Primitive::Text {
            x,
            y,
            // A dollar sign would open a formula.
            content: text.replace('$', "\\$"),
            size: style.size,
            anchor: match style.anchor {
                Anchor::Start => TextAnchor::Start,
                Anchor::Middle => TextAnchor::Middle,
                Anchor::End => TextAnchor::End,
            },
            rotate: style.upright.then_some(-90.0),
            bold: false,
            color: Some(colour),
        });
    }

    /// Hides what is drawn outside of the frame until [`Canvas::unclip`].
    pub(super) fn clip(&mut self, frame: Frame) {
        let (x, y, width, height) = (frame.left, frame.top, frame.width(), frame.height());
        // Named by its place: where a page has several pictures, equal names clip alike.
        let id = format!("clip-{x:.2}-{y:.2}-{width:.2}-{height:.2}").replace('.', "_");
        let path = format!(
            r#"<clipPath id="{id}"><rect x="{x:.2}" y="{y:.2}" width="{width:.2}" height="{height:.2}"/></clipPath>"#
        );
        if !self.scene.defs.contains(&path) {
            self.scene.defs.push(path);
        }
        self.scene.add(Primitive::ClipStart { x, y, width, height, id });
    }

    pub(super) fn unclip(&mut self) {
        self.scene.add(Primitive::ClipEnd);
    }
}

fn near(place: f64) -> f64 {
    place.clamp(-FARTHEST, FARTHEST)
}

fn commands(points: &[Point], end: &str) -> String {
    let mut d = String::new();
    for (index, &(x, y)) in points.iter().enumerate() {
        let letter = if index == 0 { 'M' } else { 'L' };
        d.push_str(&format!("{letter}{:.2} {:.2}", near(x), near(y)));
    }
    if !d.is_empty() {
        d.push_str(end);
    }
    d
}
