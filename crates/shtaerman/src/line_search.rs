//! How long iterations go on, and the searches along a line.

use crate::golden::GOLDEN;

/// Most steps of an iteration that ends by itself. The slowest gain a factor of two each, such as the ends of a row that is nearly closed: 120 halvings are twice the digits of a double (theory).
pub(crate) const STEPS: usize = 120;
/// A step of Newton's method that makes things worse is halved so often: with fewer than a 4096th of it left it leads nowhere.
pub(crate) const CUTS: usize = 12;

/// A place and a value there.
pub(crate) type Point = (f64, f64);

/// Where a function vanishes between two places at which its signs differ: false position in the Illinois form, every third step by halves. Values up to `none` are zero.
pub(crate) fn crossing(f: &impl Fn(f64) -> f64, one: Point, other: Point, none: f64) -> f64 {
    let ((mut left, mut at_left), (mut right, mut at_right)) =
        if one.0 <= other.0 { (one, other) } else { (other, one) };
    for (place, value) in [(left, at_left), (right, at_right)] {
        if value == 0.0 {
            return place;
        }
    }
    let positive_left = at_left > 0.0;
    let (mut last, mut was_left) = (left, None);
    for step in 1..=STEPS {
        let secant = left + (right - left) * at_left / (at_left - at_right);
        let middle = 0.5 * (left + right);
        let inside = secant > left && secant < right && !step.is_multiple_of(3);
        let place = if inside { secant } else { middle };
        let value = f(place);
        if value.abs() <= none || middle <= left || middle >= right || place == last {
            return place;
        }
        let is_left = (value > 0.0) == positive_left;
        let again = was_left == Some(is_left);
        if is_left {
            (left, at_left) = (place, value);
            at_right *= if again { 0.5 } else { 1.0 };
        } else {
            (right, at_right) = (place, value);
            at_left *= if again { 0.5 } else { 1.0 };
        }
        (last, was_left) = (place, Some(is_left));
    }
    0.5 * (left + right)
}

/// The largest value between two places, by golden sections: to where values do not tell places apart, the root of rounding.
pub(crate) fn top(f: &impl Fn(f64) -> f64, mut left: f64, mut right: f64) -> Point {
    let steps = (f64::EPSILON.sqrt().ln() / GOLDEN.ln()).ceil() as usize;
    let mut inner = [right - GOLDEN * (right - left), left + GOLDEN * (right - left)];
    let mut values = inner.map(f);
    for _ in 0..steps {
        if values[0] >= values[1] {
            right = inner[1];
            inner = [right - GOLDEN * (right - left), inner[0]];
            values = [f(inner[0]), values[0]];
        } else {
            left = inner[0];
            inner = [inner[1], left + GOLDEN * (right - left)];
            values = [values[1], f(inner[1])];
        }
    }
    let best = usize::from(values[1] > values[0]);
    (inner[best], values[best])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_and_tops_are_found_to_rounding() {
        let cosine = |x: f64| x.cos();
        let root = crossing(&cosine, (0.0, 1.0), (3.0, 3f64.cos()), 0.0);
        assert!((root - std::f64::consts::FRAC_PI_2).abs() < 1e-15, "{root}");
        let steep = |x: f64| x.powi(9) - 1e-9;
        assert_eq!(crossing(&|x: f64| x * x - 0.25, (0.5, 0.0), (0.0, -0.25), 0.0), 0.5);
        let back = crossing(&cosine, (3.0, 3f64.cos()), (0.0, 1.0), 0.0);
        assert_eq!(back, root);
        assert!((crossing(&steep, (0.0, -1e-9), (1.0, 1.0), 0.0) - 0.1).abs() < 1e-16);
        let (place, value) = top(&|x: f64| 1.0 - (x - 0.3).powi(2), -1.0, 2.0);
        assert!((place - 0.3).abs() < 1e-7 && value == 1.0, "{place} {value}");
        // Between neighbours that are one rounding apart there is an end, too.
        assert_eq!(top(&|x: f64| x, 1.0f64.next_down(), 1.0).1, 1.0);
    }
}
