//! The double-exponential map of the line to an interval.

use std::f64::consts::FRAC_PI_2;

use crate::Interval;

/// End of the range of `t` of the plain quadrature rule: there a point is 2e-17 of the interval from its end.
pub(crate) const RANGE: f64 = 3.2;

/// A point of the interval with its distances to both ends, which near an end hold more digits than the point does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Node {
    /// `x = centre + half_length tanh(pi/2 sinh t)`, unless another argument is given.
    pub(crate) position: f64,
    /// `x - left`.
    pub(crate) from_left: f64,
    /// `right - x`.
    pub(crate) from_right: f64,
    /// `dx/dt`.
    pub(crate) derivative: f64,
}

impl Node {
    /// The image of `t`.
    pub(crate) fn at(interval: Interval, t: f64) -> Self {
        Self::with_argument(interval, FRAC_PI_2 * t.sinh(), FRAC_PI_2 * t.cosh())
    }

    /// `c + a tanh(u)` with `u` and `du/dt`.
    pub(crate) fn with_argument(interval: Interval, argument: f64, slope: f64) -> Self {
        let half = interval.half_length();
        // 1 -+ tanh u = 2 / (1 + e^{+-2u})
        let from_right = half * 2.0 / (1.0 + (2.0 * argument).exp());
        let from_left = half * 2.0 / (1.0 + (-2.0 * argument).exp());
        let derivative = slope * from_left * from_right / half;
        let position = if argument > 0.0 {
            interval.right() - from_right
        } else {
            interval.left() + from_left
        };
        Self { position, from_left, from_right, derivative }
    }

    /// The image of a node of `[-1, 1]` under the reflection about 0.
    pub(crate) fn mirrored(&self) -> Self {
        Self {
            position: -self.position,
            from_left: self.from_right,
            from_right: self.from_left,
            derivative: self.derivative,
        }
    }

    /// The node of `[-1, 1]` carried to the interval `[left, right]`, kept strictly inside it.
    pub(crate) fn carried(&self, left: f64, right: f64) -> Self {
        let half = 0.5 * right - 0.5 * left;
        let (from_left, from_right) = (half * self.from_left, half * self.from_right);
        let position = if self.position > 0.0 { right - from_right } else { left + from_left };
        Self {
            position: position.max(left.next_up()).min(right.next_down()),
            from_left,
            from_right,
            derivative: half * self.derivative,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivative_agrees_with_differences() {
        let interval = Interval::symmetric(1.0).unwrap();
        let step = 1e-5;
        for t in [-1.3, -0.2, 0.0, 0.7, 1.9] {
            let slope = (Node::at(interval, t + step).position
                - Node::at(interval, t - step).position)
                / (2.0 * step);
            let node = Node::at(interval, t);
            assert!((slope - node.derivative).abs() < 1e-9 * (1.0 + node.derivative));
        }
    }
}
