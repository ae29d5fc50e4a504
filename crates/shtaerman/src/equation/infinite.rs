//! Where a solution of the first kind is infinite inside its interval, however small what makes it so.
//!
//! A kernel like `|x - s|^-gamma` (`gamma = 0`: a logarithm) smooths by `1 - gamma`: its inverse takes `|x - c|^p` to `|x - c|^(p - 1 + gamma)`, infinite at `c` for `p <= 1 - gamma`. What
//! a sum of eigenfunctions shows of it drowns in rounding where it is small; the formula of the right-hand side shows it whatever its size, since what changes there changes within roundings of `c`.

use super::{Equation, right_hand_side};
use crate::Error;
use crate::expression::{Expression, Line};

/// How near a breakpoint both sides are looked at, in units of the largest place: breakpoints are four roundings apart at least, and known to one.
const NEAR: f64 = 16.0 * f64::EPSILON;
/// How much farther for the second look.
const FARTHER: f64 = 16.0;
/// By how much a change that does not fall may rise from rounding.
const ROUNDING: f64 = 0.01;
/// A change of slope below this share of the slopes is rounding.
const LEAST_SLOPE: f64 = 1e-14;
/// A change of value is this many times what rounding makes of it at least.
const LEAST_VALUE: f64 = 4.0;

impl Equation {
    /// Refuses a right-hand side of the first kind under which the solution is infinite at one of its breakpoints.
    ///
    /// # Errors
    /// [`Error::InfiniteSolution`] with the place.
    pub(super) fn require_finite_solution(&self, breaks: &[f64]) -> Result<(), Error> {
        let (rhs, range) = (self.right_hand_side(), self.range());
        let look = Look {
            rhs,
            near: NEAR * range.left().abs().max(range.right().abs()),
            least_slope: LEAST_SLOPE * right_hand_side::size(rhs, range) / range.half_length(),
            least_value: LEAST_VALUE * right_hand_side::rounding(rhs, range),
            strength: self.kernel().kernel().singularity().exponent(),
        };
        let found = |&at: &f64| look.change(at).map(|what| Error::InfiniteSolution { at, what });
        breaks.iter().find_map(found).map_or(Ok(()), Err)
    }
}

/// How both sides of a breakpoint are looked at.
struct Look<'a> {
    rhs: &'a Expression,
    near: f64,
    least_slope: f64,
    least_value: f64,
    strength: f64,
}

impl Look<'_> {
    /// What makes the solution infinite at a breakpoint.
    fn change(&self, at: f64) -> Option<&'static str> {
        let stays = |near: f64, far: f64, growth: f64| far * growth <= (1.0 + ROUNDING) * near;
        let values = [1.0, FARTHER].map(|times| self.jump(at, times * self.near));
        if values[0] > self.least_value && stays(values[0], values[1], 1.0) {
            return Some("a jump");
        }
        let [(near, size), (far, _)] = [1.0, FARTHER].map(|times| self.turn(at, times * self.near));
        let least = self.least_slope.max(LEAST_SLOPE * size);
        let is_kink = near > least && stays(near, far, FARTHER.powf(self.strength));
        is_kink.then_some("a kink")
    }

    /// How the values on both sides differ.
    fn jump(&self, at: f64, distance: f64) -> f64 {
        let [left, right] = [at - distance, at + distance].map(|x| self.rhs.evaluate(&[x]));
        (right - left).abs()
    }

    /// How the slopes on both sides differ from each other and from those twice as far, and how large they are.
    fn turn(&self, at: f64, distance: f64) -> (f64, f64) {
        let slope = |x: f64| self.rhs.derivative_along(&Line::identity(), x).1;
        let [far_left, left, right, far_right] =
            [-2.0, -1.0, 1.0, 2.0].map(|times| slope(at + times * distance));
        // Where the formula has no slope, as of `max(0, x)^0.5` at its flat side, the other side tells.
        let changes = [right - left, right - far_right, left - far_left];
        let change = changes.into_iter().filter(|by| !by.is_nan()).map(f64::abs).sum();
        (change, left.abs().max(right.abs()))
    }
}
