//! A base and what it tells of itself.

use std::sync::Arc;

use super::function::Function;
use super::resolved::Resolved;
use super::side_by_side::{BESIDE, side_by_side};
use super::spline::Spline;
use crate::Error;
use crate::error::require;
use crate::expression::{Defect, Expression, ExpressionError, Interval, Line};

/// Names an expression may use: `x` (metres; in a dimensionless problem the same as `xi`), `xi = x/a`, and the half-width `a`.
pub const VARIABLES: [&str; 3] = ["x", "xi", "a"];

/// Rounding of the ends of a period, relative to its half.
const END: f64 = 1e-12;

/// Further names for a body of revolution, with the variables that they are the magnitude of.
const RADIAL: [(&str, usize); 2] = [("r", 0), ("rho", 1)];

/// The base `f(x)` of a punch, positive away from the body: an expression, a closure or points. Copies share what they hold.
///
/// ```
/// use shtaerman::Profile;
///
/// let formula = Profile::expression("x^2 / (2*0.8)")?;
/// let closure = Profile::from_fn(|x| x * x / 1.6);
/// let points = Profile::from_points(vec![-5e-3, 0.0, 5e-3], vec![15.6e-6, 0.0, 15.6e-6])?;
/// assert_eq!(formula.height(0.5, 5e-3), closure.height(0.5, 5e-3));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Of an expression the program proves more than of the others: where it has kinks, that it is finite and even, and with the audit how far off an answer is. Prefer it.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    pub(super) shape: Shape,
    pub(super) resolved: Resolved,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    Flat,
    Expression(Arc<Expression>),
    Measured(Arc<Spline>),
    Function(Function),
}

impl Profile {
    pub(super) fn of(shape: Shape) -> Self {
        Self { shape, resolved: Resolved::default() }
    }

    /// `f = 0`.
    #[must_use]
    pub fn flat() -> Self {
        Self::of(Shape::Flat)
    }

    /// An expression in [`VARIABLES`], such as `x^2 / (2*0.8)`: see [`crate::expression`].
    ///
    /// # Errors
    /// [`ExpressionError`] with the place in the text.
    pub fn expression(text: &str) -> Result<Self, ExpressionError> {
        Ok(Self::of(Shape::Expression(Arc::new(Expression::parse(text, &VARIABLES)?))))
    }

    /// An expression for a body of revolution: besides [`VARIABLES`] there are `r = |x|`, the distance from the axis, and `rho = |xi|`.
    ///
    /// # Errors
    /// [`ExpressionError`] with the place in the text.
    pub fn radial(text: &str) -> Result<Self, ExpressionError> {
        let expression = Expression::parse_with_magnitudes(text, &VARIABLES, &RADIAL)?;
        Ok(Self::of(Shape::Expression(Arc::new(expression))))
    }

    /// A closure of `x`, in the units of the problem: metres, or half-widths; under a circular punch it is asked for `x` of either sign.
    ///
    /// It is sampled, so that features between samples stay hidden and no audit bounds the errors of an answer; where it has kinks or jumps,
    /// [`with_breaks`](Self::with_breaks) says so.
    #[must_use]
    pub fn from_fn(height: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        Self::of(Shape::Function(Function::new(height)))
    }

    /// The same closure with the places `x` where it has kinks or jumps; an expression or points, which tell them themselves, stay as they are.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a place that is not finite.
    pub fn with_breaks(self, breaks: Vec<f64>) -> Result<Self, Error> {
        for place in &breaks {
            require(place.is_finite(), "profile", *place, "given finite places of its breaks")?;
        }
        Ok(match self.shape {
            Shape::Function(function) => Self::of(Shape::Function(function.with_breaks(breaks))),
            shape => Self::of(shape),
        })
    }

    /// The cubic spline through points, such as a measured trace; lengths in the units of the problem.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless there are at least two points, all finite, with strictly increasing positions.
    pub fn from_points(positions: Vec<f64>, heights: Vec<f64>) -> Result<Self, Error> {
        let count = positions.len().min(heights.len());
        require(count >= 2, "profile", count as f64, "given by at least two points")?;
        require(
            positions.len() == heights.len(),
            "profile",
            heights.len() as f64,
            "one height for each position",
        )?;
        for value in positions.iter().chain(&heights) {
            require(value.is_finite(), "profile", *value, "finite at every point")?;
        }
        for pair in positions.windows(2) {
            require(
                pair[0] < pair[1],
                "profile",
                pair[1],
                "given at strictly increasing positions",
            )?;
        }
        Ok(Self::of(Shape::Measured(Arc::new(Spline::through(positions, heights)))))
    }

    /// The profile of a base of which `[-a, a]` is one period: a measured one from end to end whose last height is the first is a spline without a kink where it repeats.
    pub(crate) fn repeating(self, half_width: f64) -> Self {
        let is_whole = |spline: &Spline| {
            spline.range().iter().all(|end| (end.abs() / half_width - 1.0).abs() <= END)
        };
        match &self.shape {
            Shape::Measured(spline) if is_whole(spline) => {
                let closed = spline.closed().map(|spline| Shape::Measured(Arc::new(spline)));
                closed.map_or(self, Self::of)
            }
            _ => self,
        }
    }

    /// `f(a xi)` for a punch of half-width `a`; taken at `xi`, whose ends are exact.
    #[must_use]
    pub fn height(&self, xi: f64, half_width: f64) -> f64 {
        match &self.shape {
            Shape::Flat => 0.0,
            Shape::Expression(expression) => {
                expression.evaluate(&[half_width * xi, xi, half_width])
            }
            Shape::Measured(spline) => spline.evaluate(half_width * xi),
            Shape::Function(function) => function.evaluate(half_width * xi),
        }
    }

    /// The same at many places.
    pub(crate) fn heights(&self, places: &[f64], half_width: f64) -> Vec<f64> {
        let alone = |xi: f64| self.height(xi, half_width);
        let Shape::Expression(expression) = &self.shape else {
            return places.iter().copied().map(alone).collect();
        };
        let beside = |xi: &[f64; BESIDE]| {
            let x = xi.map(|xi| half_width * xi);
            expression.evaluate_beside(&[x, *xi, [half_width; BESIDE]])
        };
        side_by_side(places, beside, alone)
    }

    /// The number of operations of a formula.
    pub(crate) fn operations(&self) -> Option<usize> {
        match &self.shape {
            Shape::Expression(expression) => Some(expression.length()),
            _ => None,
        }
    }

    /// `df/dxi` of a punch of this half-width, at a kink to the right.
    #[must_use]
    pub(crate) fn slope(&self, xi: f64, half_width: f64) -> Option<f64> {
        match &self.shape {
            Shape::Flat => Some(0.0),
            Shape::Expression(expression) => {
                Some(expression.derivative_along(&line(half_width), xi).1)
            }
            Shape::Measured(spline) => Some(half_width * spline.slope(half_width * xi)),
            Shape::Function(function) => Some(function.slope(xi, half_width)),
        }
    }

    /// `f` and `df/dxi` at many places, those of [`height`](Self::height) and [`slope`](Self::slope).
    pub(crate) fn tangents(&self, places: &[f64], half_width: f64) -> Vec<[f64; 2]> {
        let alone =
            |xi: f64| [self.height(xi, half_width), self.slope(xi, half_width).unwrap_or(f64::NAN)];
        let Shape::Expression(expression) = &self.shape else {
            return places.iter().copied().map(alone).collect();
        };
        let line = line(half_width);
        let beside = |xi: &[f64; BESIDE]| {
            let [heights, slopes] = expression.derivatives_along(&line, xi);
            std::array::from_fn(|k| [heights[k], slopes[k]])
        };
        side_by_side(places, beside, alone)
    }

    /// `f(c + t) - f(c) - f'(c) t` in `xi`; of an expression without the loss of digits in that difference where `t` is small.
    #[must_use]
    pub(crate) fn rise(&self, c: f64, t: f64, half_width: f64) -> f64 {
        match &self.shape {
            Shape::Flat => 0.0,
            Shape::Expression(expression) => expression.rise_along(&line(half_width), c, t),
            Shape::Measured(spline) => {
                let slope = half_width * spline.slope(half_width * c);
                let at = |xi: f64| spline.evaluate(half_width * xi);
                at(c + t) - at(c) - slope * t
            }
            Shape::Function(function) => {
                let at = |xi: f64| function.evaluate(half_width * xi);
                at(c + t) - at(c) - function.slope(c, half_width) * t
            }
        }
    }

    /// A `xi` in `[-1, 1]` at which the profile is not finite, and how, if there is one: of a closure as samples show it, proven for an expression where
    /// interval arithmetic can, so that a pole between all samples is found. What rounding cannot tell from a pole counts as one.
    #[must_use]
    pub fn find_not_finite(&self, half_width: f64) -> Option<(f64, Defect)> {
        match &self.shape {
            Shape::Expression(expression) => {
                expression.find_not_finite(&line(half_width), Interval::new(-1.0, 1.0)?)
            }
            Shape::Function(function) => function.find_not_finite(half_width),
            Shape::Flat | Shape::Measured(_) => None,
        }
    }

    /// Places strictly inside `(-1, 1)`, as `xi`, where an expression switches (`abs`, `max`, `where`, ..) and so has a kink or a jump; of a closure those
    /// it was given; a measured profile, being twice differentiable, has none.
    #[must_use]
    pub fn breakpoints(&self, half_width: f64) -> Vec<f64> {
        if let Shape::Function(function) = &self.shape {
            return function.breaks(half_width);
        }
        let (Shape::Expression(expression), Some(base)) = (&self.shape, Interval::new(-1.0, 1.0))
        else {
            return Vec::new();
        };
        let mut places = expression.breakpoints(&line(half_width), base).places;
        places.retain(|xi| xi.abs() < 1.0);
        places
    }

    /// Places inside `(-1, 1)`, as `xi`, between which the profile is smooth: the points of a measured profile, the breakpoints of an expression.
    pub(crate) fn joints(&self, half_width: f64) -> Vec<f64> {
        let Shape::Measured(spline) = &self.shape else { return self.breakpoints(half_width) };
        let places = spline.abscissas().iter().map(|x| x / half_width);
        places.filter(|xi| xi.abs() < 1.0).collect()
    }

    /// Whether it is a closure, of which nothing is known between samples.
    #[must_use]
    pub fn is_closure(&self) -> bool {
        matches!(self.shape, Shape::Function(_))
    }

    /// Positions and heights of the points of a measured profile, in the units of the problem.
    #[must_use]
    pub fn points(&self) -> Option<(&[f64], &[f64])> {
        match &self.shape {
            Shape::Measured(spline) => Some((spline.abscissas(), spline.ordinates())),
            Shape::Flat | Shape::Expression(_) | Shape::Function(_) => None,
        }
    }

    /// Number of points of a measured profile.
    #[must_use]
    pub fn measured_points(&self) -> Option<usize> {
        match &self.shape {
            Shape::Measured(spline) => Some(spline.len()),
            Shape::Flat | Shape::Expression(_) | Shape::Function(_) => None,
        }
    }
}

/// [`VARIABLES`] as functions of `xi`.
pub(super) fn line(half_width: f64) -> Line {
    Line::new(&[(0.0, half_width), (0.0, 1.0), (half_width, 0.0)])
}
