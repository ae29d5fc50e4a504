//! What can be known of a right-hand side from its formula.

use fredholm::Interval;

use crate::Error;
use crate::expression::{self, Expression, Line};

/// Places at which the size of a right-hand side and its rounding are looked at.
const PLACES: u32 = 65;

/// Places all over the range, from end to end.
fn places(range: Interval) -> impl Iterator<Item = f64> {
    let share = |i: u32| f64::from(i) / f64::from(PLACES - 1);
    (0..PLACES).map(move |i| range.left() + share(i) * (range.right() - range.left()))
}

/// Its largest value at places all over the range.
pub(super) fn size(rhs: &Expression, range: Interval) -> f64 {
    places(range).map(|x| rhs.evaluate(&[x]).abs()).fold(0.0, f64::max)
}

/// What rounding may make of a right-hand side: the largest width of an enclosure of all that its formula may come out as, at places all over the range.
pub(super) fn rounding(rhs: &Expression, range: Interval) -> f64 {
    let width = |x: f64| {
        let values = expression::Interval::point(x).map(|x| rhs.enclose(&[x]));
        values.filter(|values| values.is_finite()).map(|values| values.interval.length())
    };
    places(range).filter_map(width).fold(0.0, f64::max)
}

/// Places strictly inside the range where it has a kink or a jump.
pub(super) fn breakpoints(rhs: &Expression, range: Interval) -> Vec<f64> {
    let Some(ends) = expression::Interval::new(range.left(), range.right()) else {
        return Vec::new();
    };
    let mut places = rhs.breakpoints(&Line::identity(), ends).places;
    places.retain(|x| range.left() < *x && *x < range.right());
    places
}

/// Refuses one that is not finite on the closed range.
pub(super) fn require_finite(rhs: &Expression, range: Interval) -> Result<(), Error> {
    let Some(ends) = expression::Interval::new(range.left(), range.right()) else {
        return Ok(());
    };
    match rhs.find_not_finite(&Line::identity(), ends) {
        Some((at, defect)) => Err(Error::RightHandSide { at, defect }),
        None => Ok(()),
    }
}
