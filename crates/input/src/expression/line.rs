//! Variables tied to one parameter.

use super::interval::Interval;
use super::intervals::Intervals;

/// The variables of an expression as affine functions `offset + slope * t` of one parameter `t`,
/// in the order in which the expression was given their names.
///
/// For the base of a punch of half-width `a` with the variables `x`, `xi`, `a`, tied by
/// `x = a xi`, and the parameter `xi`:
///
/// ```
/// use shtaerman_input::expression::Line;
///
/// let half_width = 0.02; // m
/// let line = Line::new(&[(0.0, half_width), (0.0, 1.0), (half_width, 0.0)]);
/// assert_eq!(line.at(-0.5), [-0.01, -0.5, 0.02]);
/// ```
///
/// Take the parameter whose ends are exact (`xi` from -1 to 1 rather than `x`): `x / a` can round
/// to a number just above 1, where `sqrt(1 - xi^2)` is undefined.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    terms: Vec<(f64, f64)>,
}

impl Line {
    /// The line with these pairs of offset and slope, one for each variable.
    pub fn new(terms: &[(f64, f64)]) -> Self {
        Line { terms: terms.to_vec() }
    }

    /// The only variable is the parameter itself.
    pub fn identity() -> Self {
        Line { terms: vec![(0.0, 1.0)] }
    }

    /// Values of the variables at the parameter `t`.
    pub fn at(&self, t: f64) -> Vec<f64> {
        (0..self.terms.len()).map(|index| self.variable(index, t)).collect()
    }

    /// One variable at `t`; NaN for a variable the line does not have.
    pub(super) fn variable(&self, index: usize, t: f64) -> f64 {
        match self.terms.get(index) {
            Some(&(offset, 0.0)) => offset,
            Some(&(offset, slope)) => offset + slope * t,
            None => f64::NAN,
        }
    }

    pub(super) fn slope(&self, index: usize) -> f64 {
        self.terms.get(index).map_or(f64::NAN, |&(_, slope)| slope)
    }

    /// Enclosure of one variable; `None` where it is not a number.
    pub(super) fn enclose(&self, index: usize, parameter: Interval) -> Option<Interval> {
        let &(offset, slope) = self.terms.get(index)?;
        let offset = Interval::point(offset)?;
        if slope == 0.0 {
            return Some(offset);
        }
        let (product, _) = Interval::point(slope)?.times(parameter);
        Some(offset.plus(product).0)
    }

    /// The same on several intervals side by side.
    #[inline(always)]
    pub(super) fn enclose_beside<const COUNT: usize>(
        &self,
        index: usize,
        parameters: Intervals<COUNT>,
    ) -> Option<Intervals<COUNT>> {
        let &(offset, slope) = self.terms.get(index)?;
        let offset = Intervals::same(Interval::point(offset)?);
        if slope == 0.0 {
            return Some(offset);
        }
        let (product, _) = Intervals::same(Interval::point(slope)?).times(parameters);
        Some(offset.plus(product).0)
    }
}
