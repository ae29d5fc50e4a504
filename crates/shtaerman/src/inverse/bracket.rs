//! A bracket of a sign change, and how it is narrowed.

use crate::Error;

/// Most evaluations on the way to a zero.
const MOST: usize = 120;

/// Two places, the value below zero at one of them and zero or above at the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bracket {
    /// Places.
    pub(super) at: [f64; 2],
    /// Values there.
    pub(super) values: [f64; 2],
}

impl Bracket {
    /// The bracket, if the two values differ in sign.
    pub(super) fn new(at: [f64; 2], values: [f64; 2]) -> Option<Self> {
        ((values[0] >= 0.0) != (values[1] >= 0.0)).then_some(Self { at, values })
    }

    fn width(&self) -> f64 {
        (self.at[1] - self.at[0]).abs()
    }

    /// The bracket narrowed until a value other than zero is within `small`, or until its places are next to each other.
    ///
    /// Regula falsi in the Illinois form; it bisects where a value is infinite, where three steps did not shorten the bracket to an eighth,
    /// and on a plateau at the wanted value (the full base in contact), whose edge is what is looked for.
    pub(super) fn narrowed(
        mut self,
        small: f64,
        f: &mut dyn FnMut(f64) -> Result<f64, Error>,
    ) -> Result<Self, Error> {
        // A zero counts as just above: the place next to it tells it from a plateau.
        let weight = |value: f64| if value == 0.0 { small } else { value };
        let mut weights = self.values.map(weight);
        let mut last = None;
        let mut zeros = 0;
        let mut widths = [f64::INFINITY; 3];
        for step in 0..MOST {
            let close = |value: f64| value != 0.0 && value.abs() <= small;
            let resolution = 2.0 * f64::EPSILON * self.at[0].abs().max(self.at[1].abs());
            if self.values.into_iter().any(close) || self.width() <= resolution {
                break;
            }
            let slow = self.width() > widths[step % 3] / 8.0;
            widths[step % 3] = self.width();
            let [left, right] = self.at;
            let secant = left - weights[0] * (right - left) / (weights[1] - weights[0]);
            let inside = secant > left.min(right) && secant < left.max(right);
            let bisects = slow || zeros > 1 || !inside;
            let place = if bisects { left.midpoint(right) } else { secant };
            let value = f(place)?;
            let side = usize::from((value >= 0.0) == (self.values[1] >= 0.0));
            (self.at[side], self.values[side], weights[side]) = (place, value, weight(value));
            zeros = if value == 0.0 { zeros + 1 } else { 0 };
            // An end that stays twice gets half its weight, so that the bracket shrinks from both sides.
            if last == Some(side) && !bisects {
                weights[1 - side] *= 0.5;
            }
            if bisects {
                weights = self.values.map(weight);
            }
            last = Some(side);
        }
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn zero(f: impl Fn(f64) -> f64, at: [f64; 2]) -> (f64, usize) {
        let mut count = 0;
        let bracket = Bracket::new(at, at.map(&f)).unwrap();
        let narrowed = bracket
            .narrowed(1e-14, &mut |x| {
                count += 1;
                Ok(f(x))
            })
            .unwrap();
        let best = usize::from(narrowed.values[1].abs() < narrowed.values[0].abs());
        (narrowed.at[best], count)
    }

    #[test]
    fn finds_zeros_of_all_kinds() {
        for (f, at, exact, most) in [
            ((|x| x * x - 2.0) as fn(f64) -> f64, [0.0, 2.0], 2f64.sqrt(), 12),
            (|x| x.exp() - 5.0, [-20.0, 3.0], 5f64.ln(), 40),
            (|x| (x - 0.3).powi(9), [-1.0, 1.7], 0.3, 120),
            (|x| 1.0 / (x - 0.25) + 4.0, [-9.0, 0.2], 0.0, 40),
            (|x: f64| if x < 0.75 { -1.0 } else { 0.0 }, [0.0, 1.0], 0.75, 60),
            (|x: f64| if x < 0.5 { -1.0 } else { f64::INFINITY }, [0.0, 3.0], 0.5, 60),
        ] {
            let (found, count) = zero(f, at);
            assert!((found - exact).abs() < 0.03 && count <= most, "{found} {exact} {count}");
            assert!(f(found).abs() <= 1e-14 || (found - exact).abs() < 1e-15, "{found} {exact}");
        }
    }

    #[test]
    fn no_bracket_without_a_change_of_sign() {
        assert_eq!(Bracket::new([0.0, 1.0], [1.0, 0.0]), None);
        assert!(Bracket::new([0.0, 1.0], [-1.0, 0.0]).is_some());
    }
}
