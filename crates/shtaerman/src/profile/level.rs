//! Heights counted from the level of the base, and what rounding leaves of them.

use std::sync::Arc;

use super::base::{Profile, Shape};
use super::side_by_side::enclosures;
use crate::expression::{Interval, decimal_rounding};

/// Places at which heights are compared with their range.
const PLACES: usize = 33;
/// What a level must take off the largest height to be worth it.
const SHARE: f64 = 0.5;
/// Rounding of a measured height, of which some are added up.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// So many places nearest to an end may lie on the other side of a switch that is known to rounding; what rounding grows to there is at most inverse to the distance (survey).
const SWITCHED: usize = 4;

impl Profile {
    /// The base counted from a level, and the height of that level with the rounding of its decimal numbers, where a constant is larger than all heights above it: it would take their digits. None
    /// where there is nothing to gain.
    pub(crate) fn lowered(&self, half_width: f64) -> Option<(Self, [f64; 2])> {
        let [lowest, highest] = self.extremes(half_width);
        let nearest = if lowest > 0.0 { lowest } else { highest };
        if lowest * highest <= 0.0 || nearest.abs() <= highest - lowest {
            return None;
        }
        let (shape, level) = match &self.shape {
            Shape::Flat | Shape::Function(_) => return None,
            Shape::Expression(expression) => {
                let (rest, level) = expression.without_constant();
                (Shape::Expression(Arc::new(rest)), level)
            }
            Shape::Measured(spline) => {
                let level = [nearest, decimal_rounding(nearest) * nearest.abs()];
                (Shape::Measured(Arc::new(spline.lowered(nearest))), level)
            }
        };
        let rest = Self::of(shape);
        let size = |[lowest, highest]: [f64; 2]| lowest.abs().max(highest.abs());
        let is_less = size(rest.extremes(half_width)) <= SHARE * size([lowest, highest]);
        (level[0].is_finite() && is_less).then_some((rest, level))
    }

    /// The base by a small height higher; a measured one as it is, whose heights are not known so well.
    pub(crate) fn raised(self, by: f64) -> Self {
        match self.shape {
            Shape::Expression(expression) => {
                let raised = Arc::unwrap_or_clone(expression).plus(by, 0.0);
                Self::of(Shape::Expression(Arc::new(raised)))
            }
            Shape::Flat | Shape::Measured(_) | Shape::Function(_) => self,
        }
    }

    /// The lowest and the highest height at a few places, of a measured profile at its points.
    fn extremes(&self, half_width: f64) -> [f64; 2] {
        let places = (0..PLACES).map(|i| (2 * i) as f64 / (PLACES - 1) as f64 - 1.0);
        let points = match &self.shape {
            Shape::Measured(spline) => spline.ordinates(),
            Shape::Flat | Shape::Expression(_) | Shape::Function(_) => &[],
        };
        let heights = places.map(|xi| self.height(xi, half_width)).chain(points.iter().copied());
        heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[lowest, highest], height| {
            [lowest.min(height), highest.max(height)]
        })
    }

    /// What rounding may make of the heights at places: the widths of enclosures of all that the formula may come out as there.
    pub(crate) fn roundings(&self, places: &[f64], half_width: f64) -> Vec<f64> {
        let width = |range: Interval| range.upper() - range.lower();
        let of = |share: f64, height: &dyn Fn(f64) -> f64| {
            places.iter().map(|xi| share * height(half_width * xi).abs()).collect()
        };
        match &self.shape {
            Shape::Flat => vec![0.0; places.len()],
            Shape::Measured(spline) => of(ROUNDING, &|x| spline.evaluate(x)),
            Shape::Function(function) => of(ROUNDING, &|x| function.evaluate(x)),
            Shape::Expression(expression) => {
                let found = enclosures(expression, places, half_width);
                found.into_iter().map(|known| width(known.interval)).collect()
            }
        }
    }

    /// The same at one place.
    pub(crate) fn rounding(&self, xi: f64, half_width: f64) -> f64 {
        self.roundings(&[xi], half_width)[0]
    }

    /// The largest of these beside an end, where formulae such as `sqrt(1 - xi^2)` lose most: the nearest place is one rounding of the end away, each further one twice as far, as far as `reach`, which is negative to the left.
    pub(crate) fn rounding_beside(&self, end: f64, reach: f64, half_width: f64) -> f64 {
        let nearest = f64::EPSILON * end.abs().max(2.0 * reach.abs());
        let distances = (0..f64::MANTISSA_DIGITS as i32).map(|k| nearest * 2f64.powi(k));
        let places: Vec<f64> = distances
            .take_while(|distance| *distance <= reach.abs())
            .map(|distance| (end + distance.copysign(reach)).clamp(-1.0, 1.0))
            .collect();
        let mut roundings = self.roundings(&places, half_width);
        roundings.iter_mut().filter(|here| !here.is_finite()).for_each(|here| *here = 0.0);
        let sure = roundings.get(SWITCHED).copied().unwrap_or(0.0);
        for (k, here) in roundings.iter_mut().enumerate().take(SWITCHED) {
            *here = here.min(2f64.powi((SWITCHED - k) as i32) * sure);
        }
        roundings.into_iter().fold(0.0, f64::max)
    }
}
