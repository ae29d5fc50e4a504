//! Heights nearer to a place than the numbers of the machine are apart.
//!
//! Nodes of collocation crowd towards the places where a base bends, down to far below a rounding of these places. Beside a tip `|x - c|^q` with `q < 1` the height of the next number is not theirs: it
//! goes on as the power of the distance that the next numbers show, and farther away a rounding of the place is taken out.

/// Numbers from an end at which the power is looked for.
const NUMBERS: [f64; 3] = [1.0, 4.0, 16.0];
/// The least power: what rises less from number to number is rounding of a step.
const LEAST: f64 = 0.02;
/// Changes of no more than this, relative to the heights, are rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Beyond so many numbers from the end a rounding of the place changes no height by more than one of its own.
const FAR: f64 = 1e12;

/// A place of an interval by its distance from the nearer end.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Beside {
    interval: [f64; 2],
    end: f64,
    /// Negative from the right end.
    distance: f64,
}

impl Beside {
    /// By the distances from both ends.
    pub(crate) fn new(interval: [f64; 2], [from_left, from_right]: [f64; 2]) -> Self {
        let [left, right] = interval;
        let is_left = from_left < from_right;
        let (end, distance) = if is_left { (left, from_left) } else { (right, -from_right) };
        Self { interval, end, distance }
    }

    /// The nearest number within the interval.
    pub(crate) fn number(&self) -> f64 {
        let first = self.interval[0].next_up();
        (self.end + self.distance).clamp(first, self.interval[1].next_down().max(first))
    }

    /// From the end to the next number.
    fn step(&self) -> f64 {
        let next = if self.distance < 0.0 { self.end.next_down() } else { self.end.next_up() };
        next - self.end
    }
}

/// How heights go on from an end.
struct Tip {
    at_end: f64,
    power: f64,
}

impl Tip {
    /// By `a + b d^q` through three numbers, as the height at the end may be that of the other side of a step; none where they do not change.
    fn new(height: &impl Fn(f64) -> f64, end: f64, step: f64) -> Option<Self> {
        let [one, four, sixteen] = NUMBERS.map(|number| height(end + number * step));
        let rounding = ROUNDING * one.abs().max(sixteen.abs());
        let power = ((sixteen - four) / (four - one)).ln() / NUMBERS[1].ln();
        if !(power >= LEAST && (four - one).abs() > rounding) {
            return None;
        }
        let extrapolated = one - (four - one) / (NUMBERS[1].powf(power) - 1.0);
        let given = height(end);
        let is_given = (given - extrapolated).abs() <= rounding / power;
        Some(Self { at_end: if is_given { given } else { extrapolated }, power })
    }
}

/// Gives heights at the [numbers](Beside::number) of places the values that they have at the places.
pub(crate) fn corrected(heights: &mut [f64], places: &[Beside], height: impl Fn(f64) -> f64) {
    let mut last: Option<(f64, f64, Option<Tip>)> = None;
    for (value, place) in heights.iter_mut().zip(places) {
        let (end, step) = (place.end, place.step());
        if place.distance / step >= FAR {
            continue;
        }
        if last.as_ref().is_none_or(|(at, own, _)| (*at, *own) != (end, step)) {
            last = Some((end, step, Tip::new(&height, end, step)));
        }
        if let Some((.., Some(tip))) = &last {
            let share = place.distance / (place.number() - end);
            *value = tip.at_end + (*value - tip.at_end) * share.powf(tip.power);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_between_numbers_are_those_of_a_tip() {
        let ulp = f64::EPSILON * 0.5;
        for end in [0.703, -0.44, 0.99, -0.99] {
            for power in [0.05, 0.2, 0.5, 0.8] {
                let height = |xi: f64| 0.3 + (xi - end).abs().powf(power);
                for is_right in [true, false] {
                    let distances =
                        [1e-3, 0.1, 0.4, 3.0, 77.4, 5e5, 3.3e9].map(|share| share * ulp);
                    let place = |d: f64| match is_right {
                        true => Beside::new([end, end + 0.5], [d, 0.5 - d]),
                        false => Beside::new([end - 0.5, end], [0.5 - d, d]),
                    };
                    let places = distances.map(place);
                    let mut heights = places.map(|place| height(place.number()));
                    corrected(&mut heights, &places, height);
                    for (d, found) in distances.iter().zip(heights) {
                        let exact = 0.3 + d.powf(power);
                        assert!(
                            (found - exact).abs() <= 8.0 * ulp / (power * power),
                            "{end} {power} {d:e}: {found}"
                        );
                    }
                }
            }
        }
        // The other side of a step is not theirs.
        let places = [Beside::new([0.25, 1.0], [1e-20, 0.75])];
        for step in [0.0, 1e-9, 1.0] {
            let height = |xi: f64| {
                let above = if xi > 0.25 { step } else { 0.0 };
                above + 0.1 * (xi - 0.25).abs().powf(0.2)
            };
            let mut heights = [height(0.25f64.next_up())];
            corrected(&mut heights, &places, height);
            let exact = step + 0.1 * 1e-20f64.powf(0.2);
            assert!((heights[0] - exact).abs() < 1e-14 * (1.0 + step), "{step}: {heights:?}");
        }
        let mut heights = [1.0];
        corrected(&mut heights, &places, |xi| if xi > 0.25 { 1.0 + 1e-3 * xi } else { 0.0 });
        assert_eq!(heights, [1.0]);
    }
}
