//! The base of the punch.

mod cubic;
mod enclosure;
mod evenness;
mod level;
mod measured;
mod resolution;
mod spline;

#[cfg(test)]
mod tests;

pub use measured::{CsvOptions, read_csv};
pub use resolution::Resolution;

use crate::Error;
use crate::error::require;
use crate::expression::{Defect, Expression, ExpressionError, Interval, Line};
use spline::Spline;

/// Names an expression may use: `x` (metres; in a dimensionless problem the same as `xi`), `xi = x/a`, and the half-width `a`.
pub const VARIABLES: [&str; 3] = ["x", "xi", "a"];

/// Rounding of the ends of a period, relative to its half.
const END: f64 = 1e-12;

/// Further names for a body of revolution, with the variables that they are the magnitude of.
const RADIAL: [(&str, usize); 2] = [("r", 0), ("rho", 1)];

/// The base `f(x)` of a punch, positive away from the body: an expression or a measured curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    shape: Shape,
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Flat,
    Expression(Expression),
    Measured(Spline),
}

impl Profile {
    /// `f = 0`.
    #[must_use]
    pub fn flat() -> Self {
        Self { shape: Shape::Flat }
    }

    /// An expression in [`VARIABLES`], such as `x^2 / (2*0.8)`: see [`crate::expression`].
    ///
    /// # Errors
    /// [`ExpressionError`] with the place in the text.
    pub fn expression(text: &str) -> Result<Self, ExpressionError> {
        Ok(Self { shape: Shape::Expression(Expression::parse(text, &VARIABLES)?) })
    }

    /// An expression for a body of revolution: besides [`VARIABLES`] there are `r = |x|`, the distance from the axis, and `rho = |xi|`.
    ///
    /// # Errors
    /// [`ExpressionError`] with the place in the text.
    pub fn radial(text: &str) -> Result<Self, ExpressionError> {
        let expression = Expression::parse_with_magnitudes(text, &VARIABLES, &RADIAL)?;
        Ok(Self { shape: Shape::Expression(expression) })
    }

    /// The cubic spline through measured points; lengths in the units of the problem.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless there are at least two points, all finite, with strictly increasing positions.
    pub fn measured(positions: Vec<f64>, heights: Vec<f64>) -> Result<Self, Error> {
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
        Ok(Self { shape: Shape::Measured(Spline::through(positions, heights)) })
    }

    /// The profile of a base of which `[-a, a]` is one period: a measured one from end to end whose last height is the first is a spline without a kink where it repeats.
    pub(crate) fn repeating(self, half_width: f64) -> Self {
        let is_whole = |spline: &Spline| {
            spline.range().iter().all(|end| (end.abs() / half_width - 1.0).abs() <= END)
        };
        match &self.shape {
            Shape::Measured(spline) if is_whole(spline) => {
                let closed = spline.closed().map(|spline| Self { shape: Shape::Measured(spline) });
                closed.unwrap_or(self)
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
        }
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
        }
    }

    /// A `xi` in `[-1, 1]` at which the profile is not finite, and how, if there is one: proven for an expression where interval
    /// arithmetic can, so that a pole between all samples is found. What rounding cannot tell from a pole counts as one.
    #[must_use]
    pub fn find_not_finite(&self, half_width: f64) -> Option<(f64, Defect)> {
        let Shape::Expression(expression) = &self.shape else { return None };
        let base = Interval::new(-1.0, 1.0)?;
        expression.find_not_finite(&line(half_width), base)
    }

    /// Places strictly inside `(-1, 1)`, as `xi`, where an expression switches (`abs`, `max`, `where`, ..) and so has a kink or a jump; a
    /// measured profile, being twice differentiable, has none.
    #[must_use]
    pub fn breakpoints(&self, half_width: f64) -> Vec<f64> {
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

    /// First and last position of a measured profile.
    #[must_use]
    pub fn measured_range(&self) -> Option<[f64; 2]> {
        match &self.shape {
            Shape::Measured(spline) => Some(spline.range()),
            Shape::Flat | Shape::Expression(_) => None,
        }
    }

    /// Number of points of a measured profile.
    #[must_use]
    pub fn measured_points(&self) -> Option<usize> {
        match &self.shape {
            Shape::Measured(spline) => Some(spline.len()),
            Shape::Flat | Shape::Expression(_) => None,
        }
    }
}

/// [`VARIABLES`] as functions of `xi`.
fn line(half_width: f64) -> Line {
    Line::new(&[(0.0, half_width), (0.0, 1.0), (half_width, 0.0)])
}
