//! What a profile does between all samples: enclosures of its values and of its Taylor coefficients on intervals of `xi`.
//!
//! Meant are exact values: those of the formula with its numbers and constant parts rounded, or of the cubics between measured points.

use super::base::{Profile, Shape, line};
use super::side_by_side::enclosures;
use crate::expression::{Enclosure, Interval, Scale, Series, Taylor};

/// Switches are known to a few roundings of the base, and count as lying at the end of an interval that they are so close to.
const SLACK: f64 = 8.0 * f64::EPSILON;
/// What Taylor coefficients take, in looks of an audit at panels, for each operation of a formula, and of a measured profile (survey: up to 0.6 us an operation to order 24, half as much in sums of waves, where a look takes 0.28).
const OF_AN_OPERATION: u64 = 2;
const OF_POINTS: u64 = 20;

impl Profile {
    /// Encloses `f(a xi)` for all `xi` of an interval, for a punch of half-width `a`; `None` where a value may be undefined or infinite.
    ///
    /// On a short interval the enclosure is about as wide as the values are apart. The value at an end that is a jump is left out.
    ///
    /// ```
    /// let profile = shtaerman::Profile::expression("xi - xi^2")?;
    /// let range = profile.enclose([0.5, 0.75], 1.0).unwrap();
    /// assert!(range.lower() <= 0.1875 && 0.25 <= range.upper());
    /// assert!(range.upper() - range.lower() < 0.0626);
    /// # Ok::<(), shtaerman::expression::ExpressionError>(())
    /// ```
    #[must_use]
    pub fn enclose(&self, interval: [f64; 2], half_width: f64) -> Option<Interval> {
        let interval = Interval::new(interval[0], interval[1])?;
        let whole = self.expansion(interval, 2, half_width);
        let range = whole.range();
        let bend = whole.coefficient(2);
        let middle = interval.lower().midpoint(interval.upper());
        if !bend.is_bounded() || !interval.contains(middle) {
            return range;
        }
        let tangent = self.expansion(Interval::point(middle)?, 1, half_width);
        let Some(value) = tangent.range() else { return range };
        let around = interval.plus(Interval::point(-middle)?).0;
        let change = Interval::quadratic(tangent.coefficient(1), bend, around);
        Some(range?.common(value.plus(change).0))
    }

    /// Encloses the exact and the computed `f(a xi)` at one place; `None` where it may be undefined or infinite.
    #[must_use]
    pub fn enclose_at(&self, xi: f64, half_width: f64) -> Option<Interval> {
        self.enclosures_at(&[xi], half_width)[0]
    }

    /// The same at many places, for less.
    pub(crate) fn enclosures_at(&self, places: &[f64], half_width: f64) -> Vec<Option<Interval>> {
        let exact: Vec<Option<Interval>> = match &self.shape {
            Shape::Expression(expression) => {
                let found = enclosures(expression, places, half_width);
                found.into_iter().map(|one| one.is_finite().then_some(one.interval)).collect()
            }
            Shape::Measured(spline) => {
                let factor = Interval::ends(half_width, half_width);
                let at = |place: Interval| {
                    spline.enclose_value(place.times(factor).0, SLACK * half_width)
                };
                places.iter().map(|xi| Interval::point(*xi).map(at)).collect()
            }
            Shape::Flat => places.iter().map(|xi| Interval::point(0.0 * xi)).collect(),
            Shape::Function(_) => vec![None; places.len()],
        };
        let computed = self.heights(places, half_width);
        let with = |(exact, computed): (Option<Interval>, f64)| {
            let both = exact?.hull(Interval::point(computed)?);
            both.is_bounded().then_some(both)
        };
        exact.into_iter().zip(computed).map(with).collect()
    }

    /// Encloses `f^(k)/k!`, derivatives with respect to `xi`, for `k` from 0 to `order` on an interval of `xi`; `None` where a value may be undefined or
    /// infinite.
    ///
    /// A coefficient `k` that is bounded says that the derivative of order `k - 1` is Lipschitz continuous inside the interval, and encloses
    /// that of order `k` wherever it exists, which is almost everywhere. It is unbounded where the profile is not known to be that smooth. What
    /// switches at an end to rounding is followed to the inside.
    ///
    /// ```
    /// let profile = shtaerman::Profile::expression("abs(x)^3")?;
    /// let [_, slope, bend, third] = profile.taylor([0.0, 0.5], 3, 2.0).unwrap()[..] else { panic!() };
    /// assert!(slope.contains(0.0) && slope.contains(6.0) && slope.upper() < 6.1);
    /// assert!(bend.contains(12.0) && third.contains(8.0));
    /// // Across the middle the third derivative jumps, so that there is no fourth one.
    /// let across = profile.taylor([-0.5, 0.5], 4, 2.0).unwrap();
    /// assert!(!across[4].is_bounded());
    /// # Ok::<(), shtaerman::expression::ExpressionError>(())
    /// ```
    #[must_use]
    pub fn taylor(
        &self,
        interval: [f64; 2],
        order: usize,
        half_width: f64,
    ) -> Option<Vec<Interval>> {
        let interval = Interval::new(interval[0], interval[1])?;
        let expansion = self.expansion(interval, order, half_width);
        expansion.range()?;
        Some((0..=order).map(|k| expansion.coefficient(k)).collect())
    }

    /// What such coefficients take of the time of an audit, in its looks at panels.
    pub(crate) fn looks(&self) -> u64 {
        self.operations().map_or(OF_POINTS, |count| OF_AN_OPERATION * count as u64)
    }

    /// The same coefficients in a scale in which they do not overflow.
    pub(crate) fn expansion(&self, interval: Interval, order: usize, half_width: f64) -> Taylor {
        let scale = Scale::of(interval);
        match &self.shape {
            Shape::Flat => {
                let zero = Enclosure { interval: Interval::ZERO, may_be_undefined: false };
                Taylor::new(Series::polynomial(vec![Interval::ZERO]), zero, scale)
            }
            Shape::Function(_) => {
                let unknown = Enclosure { interval: Interval::WHOLE, may_be_undefined: true };
                Taylor::new(Series::cut(vec![Interval::WHOLE]), unknown, scale)
            }
            Shape::Expression(expression) => {
                expression.taylor_along(&line(half_width), interval, order, SLACK)
            }
            Shape::Measured(spline) => {
                let factor = Interval::ends(half_width, half_width);
                let (mut terms, is_single) =
                    spline.enclose(interval.times(factor).0, SLACK * half_width);
                let unit = factor.times(Interval::ends(scale.value(), scale.value())).0;
                let mut power = unit;
                for term in &mut terms[1..] {
                    *term = term.times(power).0;
                    power = power.times(unit).0;
                }
                let range = Enclosure { interval: terms[0], may_be_undefined: false };
                let terms = terms.to_vec();
                let series = if is_single { Series::polynomial(terms) } else { Series::cut(terms) };
                Taylor::new(series, range, scale)
            }
        }
    }
}
