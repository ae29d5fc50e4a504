//! How long iterations go on, and the searches along a line.

/// Most steps of an iteration that ends by itself. The slowest gain a factor of two each, such as the ends of a row that is nearly closed: 120 halvings are twice the digits of a double (theory).
pub(super) const STEPS: usize = 120;
/// A step of Newton's method that makes things worse is halved so often: with fewer than a 4096th of it left it leads nowhere.
pub(super) const CUTS: usize = 12;
/// `(sqrt(5) - 1)/2`: it divides an interval so that one of two places inside serves again. Its multiples never fall in with a wave.
pub(super) const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A place and a value there.
pub(super) type Point = (f64, f64);

/// Where a function vanishes between two places at which its signs differ: false position in the Illinois form, every third step by halves. Values up to `none` are zero.
pub(super) fn crossing(f: &impl Fn(f64) -> f64, one: Point, other: Point, none: f64) -> f64 {
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
        let inside = secant > left && secant < right && step % 3 != 0;
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

/// The largest value between two places, by parabolas through the three best, and by golden sections where these lead nowhere (R. P. Brent, *Algorithms for minimization without derivatives*, 1973): to where
/// values do not tell places apart, the root of rounding.
pub(super) fn top(f: &impl Fn(f64) -> f64, mut left: f64, mut right: f64) -> Point {
    let least = f64::EPSILON.sqrt() * (right - left);
    let start = right - (1.0 - GOLDEN) * (right - left);
    let [mut best, mut second, mut third] = [(start, f(start)); 3];
    // The last step, and that before it.
    let (mut step, mut before) = (0.0f64, 0.0f64);
    for _ in 0..STEPS {
        let middle = 0.5 * (left + right);
        if (best.0 - middle).abs() + 0.5 * (right - left) <= 2.0 * least {
            break;
        }
        let to = vertex(best, second, third);
        let at = best.0 + to;
        (step, before) = if to.abs() < 0.5 * before.abs() && left < at && at < right {
            let is_beside = at - left < 2.0 * least || right - at < 2.0 * least;
            (if is_beside { least.copysign(middle - best.0) } else { to }, step)
        } else {
            let longer = if best.0 < middle { right } else { left } - best.0;
            ((1.0 - GOLDEN) * longer, longer)
        };
        let place = best.0 + if step.abs() < least { least.copysign(step) } else { step };
        let next = (place, f(place));
        // The lower of both places ends the interval.
        let (is_best, is_left) = (next.1 >= best.1, place < best.0);
        let end = if is_best { best.0 } else { place };
        *(if is_best == is_left { &mut right } else { &mut left }) = end;
        if is_best {
            (best, second, third) = (next, best, second);
        } else if next.1 >= second.1 || second.0 == best.0 {
            (second, third) = (next, second);
        } else if next.1 >= third.1 || third.0 == best.0 || third.0 == second.0 {
            third = next;
        }
    }
    best
}

/// Where the parabola through three places has its vertex, from the first of them; no number where they lie on a line.
fn vertex(one: Point, two: Point, three: Point) -> f64 {
    let (to_two, to_three) = (one.0 - two.0, one.0 - three.0);
    let (by_two, by_three) = (to_two * (one.1 - three.1), to_three * (one.1 - two.1));
    (to_two * by_two - to_three * by_three) / (2.0 * (by_three - by_two))
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
