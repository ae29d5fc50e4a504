//! How long iterations go on, and the searches along a line.

use crate::golden::GOLDEN;

/// Most steps of an iteration that ends by itself. The slowest gain a factor of two each, such as the ends of a row that is nearly closed: 120 halvings are twice the digits of a double (theory).
pub(crate) const STEPS: usize = 120;
/// A step of Newton's method that makes things worse is halved so often: with fewer than a 4096th of it left it leads nowhere.
pub(crate) const CUTS: usize = 12;

/// A place and a value there.
pub(crate) type Point = (f64, f64);

/// Where a function vanishes between two places at which its signs differ. Values up to `none` are zero.
pub(crate) fn crossing(f: &impl Fn(f64) -> f64, one: Point, other: Point, none: f64) -> f64 {
    let mut bracket = Bracket::new(one, other, none);
    while let Some(place) = bracket.wanted() {
        bracket.take((place, f(place)));
    }
    bracket.best()
}

/// The same between many pairs of places, which advance together.
pub(crate) fn crossings(
    f: &impl Fn(&[f64]) -> Vec<f64>,
    pairs: impl Iterator<Item = [Point; 2]>,
    none: f64,
) -> Vec<f64> {
    let mut brackets: Vec<Bracket> =
        pairs.map(|[one, other]| Bracket::new(one, other, none)).collect();
    loop {
        let wanted: Vec<f64> = brackets.iter().filter_map(Bracket::wanted).collect();
        if wanted.is_empty() {
            return brackets.iter().map(Bracket::best).collect();
        }
        let open = brackets.iter_mut().filter(|bracket| bracket.wanted().is_some());
        for ((bracket, place), value) in open.zip(&wanted).zip(f(&wanted)) {
            bracket.take((*place, value));
        }
    }
}

/// Two places between which a function vanishes, and the one before: T. R. Chandrupatla, *A new hybrid quadratic/bisection algorithm*, Adv. Eng. Software 28 (1997) 145. The parabola through all three,
/// `x` as a function of `f`, where it is monotonous between them, else halves.
#[derive(Debug, Clone, Copy)]
struct Bracket {
    /// The last place, the one on the other side of the zero, and that before.
    points: [Point; 3],
    /// How far from the first to the second the next place lies; none at the end.
    share: Option<f64>,
    none: f64,
    steps: usize,
}

impl Bracket {
    fn new(one: Point, other: Point, none: f64) -> Self {
        // The same whichever of them comes first.
        let (left, right) = if one.0 <= other.0 { (one, other) } else { (other, one) };
        let share = left.1 / (left.1 - right.1);
        Self { points: [left, right, right], share: None, none, steps: 0 }.going_on(share)
    }

    fn wanted(&self) -> Option<f64> {
        let [(one, _), (other, _), _] = self.points;
        self.share.map(|share| one + share * (other - one))
    }

    /// Where the value is smallest.
    fn best(&self) -> f64 {
        let [one, other, _] = self.points;
        if one.1.abs() <= other.1.abs() { one.0 } else { other.0 }
    }

    fn take(&mut self, (place, value): Point) {
        let [one, other, _] = self.points;
        let is_same_side = (value > 0.0) == (one.1 > 0.0);
        self.points =
            if is_same_side { [(place, value), other, one] } else { [(place, value), one, other] };
        self.steps += 1;
        let [(x1, f1), (x2, f2), (x3, f3)] = self.points;
        let (x, f) = ((x1 - x2) / (x3 - x2), (f1 - f2) / (f3 - f2));
        let is_monotonous = f * f < x && (1.0 - f) * (1.0 - f) < 1.0 - x;
        let share = if is_monotonous {
            f1 / (f2 - f1) * f3 / (f2 - f3)
                + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2)
        } else {
            0.5
        };
        *self = self.going_on(share);
    }

    /// At this share of the way, but apart from both ends; none where they are neighbours, or a value is zero.
    fn going_on(self, share: f64) -> Self {
        let [(one, at_one), (other, at_other), _] = self.points;
        let apart = f64::EPSILON * self.best().abs().max(f64::MIN_POSITIVE);
        let least = apart / (one - other).abs();
        let is_zero = at_one.abs().min(at_other.abs()) <= self.none;
        let is_over = is_zero || least >= 0.5 || self.steps == STEPS;
        let share = if share.is_nan() { 0.5 } else { share };
        Self { share: (!is_over).then(|| share.clamp(least, 1.0 - least)), ..self }
    }
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

/// Where a function with these values at places from end to end of a piece of the base is positive; values up to `none` are zero.
pub(crate) fn positive(
    f: &impl Fn(&[f64]) -> Vec<f64>,
    points: &[Point],
    none: f64,
) -> Vec<[f64; 2]> {
    let Some((first, last)) = points.first().zip(points.last()) else { return Vec::new() };
    let pairs = points.windows(2).map(|pair| [pair[0], pair[1]]);
    let pairs = pairs.filter(|[one, other]| (one.1 > 0.0) != (other.1 > 0.0));
    let edges = crossings(f, pairs, none);
    // Edges in turn open and close a zone.
    let begins = (first.1 > 0.0).then_some(first.0);
    let ends = (last.1 > 0.0).then_some(last.0);
    let edges: Vec<f64> = begins.into_iter().chain(edges).chain(ends).collect();
    let zones = edges.as_chunks::<2>().0.iter().copied();
    zones.filter(|[left, right]| left < right).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_roots_are_those_that_each_is() {
        let f = |x: f64| (1e3 * x).sin() + 0.1 * x.powi(3);
        let point = |i: i32| (f64::from(i) * 1e-3, f(f64::from(i) * 1e-3));
        let pairs = || (0..2000).map(|i| [point(i), point(i + 1)]);
        let crossed = || pairs().filter(|[one, other]| (one.1 > 0.0) != (other.1 > 0.0));
        let places = std::cell::Cell::new(0);
        let all = |at: &[f64]| {
            places.set(places.get() + at.len());
            at.iter().map(|x| f(*x)).collect()
        };
        let found = crossings(&all, crossed(), 1e-15);
        assert!(found.len() > 600, "{}", found.len());
        for (root, [one, other]) in found.iter().zip(crossed()) {
            assert_eq!(*root, crossing(&f, one, other, 1e-15));
            assert!(one.0 <= *root && *root <= other.0 && f(*root).abs() < 1e-12, "{root}");
        }
        // Halving by itself takes over forty.
        assert!(places.get() < 10 * found.len(), "{} for {}", places.get(), found.len());
        // No number has no sign: it ends all the same.
        let none = crossing(&|_| f64::NAN, (0.0, 1.0), (1.0, -1.0), 0.0);
        assert!((0.0..=1.0).contains(&none));
    }

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
