//! Axes: what they are called and how they carry numbers to places.

/// How an axis carries numbers to places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scale {
    /// Equal differences are equally far apart.
    Linear,
    /// Equal ratios are equally far apart; positive numbers only.
    Logarithmic,
    /// `asinh(v / 2 threshold)`: linear well below the threshold and logarithmic well above it, on
    /// both sides of zero. A threshold that is not positive counts as 1.
    SymmetricLogarithmic {
        /// Where the linear part goes over into the logarithmic one, in units of the axis.
        threshold: f64,
    },
}

/// Numbers beyond this are not drawn, so that differences of two of them stay finite.
const LARGEST: f64 = 1e300;
/// Numbers below this count as zero, so that differences of two of them can be divided by.
const SMALLEST: f64 = 1e-300;
/// Numbers that differ by less than this part of their size are drawn as equal.
const RELATIVE_RESOLUTION: f64 = 1e-9;

impl Scale {
    /// Place of a number in the units in which the axis is even; `None` if it has none.
    pub(super) fn place(self, value: f64) -> Option<f64> {
        if value.is_nan() || value.abs() > LARGEST {
            return None;
        }
        match self {
            Self::Linear if value.abs() < SMALLEST => Some(0.0),
            Self::Linear => Some(value),
            Self::Logarithmic => (value >= SMALLEST).then(|| value.log10()),
            Self::SymmetricLogarithmic { threshold } => {
                let place = (value / (2.0 * usable(threshold))).asinh() / std::f64::consts::LN_10;
                place.is_finite().then_some(place)
            }
        }
    }

    /// Smallest range that holds the places, widened by the part `padding` of itself at both ends.
    pub(super) fn range(self, places: impl Iterator<Item = f64>, padding: f64) -> Range {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for place in places {
            low = low.min(place);
            high = high.max(place);
        }
        if low > high {
            return Range { low: 0.0, high: 1.0 };
        }
        let size = low.abs().max(high.abs());
        let flat = high - low <= RELATIVE_RESOLUTION * size || high == low;
        let margin = match self {
            Self::Linear if flat && size == 0.0 => 1.0,
            Self::Linear if flat => 0.1 * size,
            Self::Logarithmic | Self::SymmetricLogarithmic { .. } if high - low < 1e-6 => 0.5,
            _ => padding * (high - low),
        };
        Range { low: low - margin, high: high + margin }
    }
}

/// A threshold that can be divided by.
pub(super) fn usable(threshold: f64) -> f64 {
    if threshold > SMALLEST && threshold < LARGEST { threshold } else { 1.0 }
}

/// An axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// Name and unit, such as `x [mm]`; empty for none.
    pub label: String,
    /// How numbers are carried to places.
    pub scale: Scale,
    /// Whether numbers grow to the left or downward.
    pub reversed: bool,
    /// Numbers that must lie within the axis, whatever the curves do.
    pub include: Vec<f64>,
    /// Names of the places 0, 1, 2 and so on, in place of numbers.
    pub names: Vec<String>,
    /// Ends of the axis, whatever the curves do.
    pub limits: Option<[f64; 2]>,
}

impl Axis {
    /// A linear axis.
    #[must_use]
    pub fn linear(label: impl Into<String>) -> Self {
        Self::with_scale(label, Scale::Linear)
    }

    /// A logarithmic axis.
    #[must_use]
    pub fn logarithmic(label: impl Into<String>) -> Self {
        Self::with_scale(label, Scale::Logarithmic)
    }

    /// An axis with a scale.
    #[must_use]
    pub fn with_scale(label: impl Into<String>, scale: Scale) -> Self {
        Self {
            label: label.into(),
            scale,
            reversed: false,
            include: Vec::new(),
            names: Vec::new(),
            limits: None,
        }
    }

    /// A linear axis whose places 0, 1, 2 and so on have names.
    #[must_use]
    pub fn of_names(names: Vec<String>) -> Self {
        let last = names.len() as f64 - 0.5;
        Self { names, ..Self::linear("").including(-0.5).including(last) }
    }

    /// The axis turned round.
    #[must_use]
    pub fn reversed(mut self) -> Self {
        self.reversed = true;
        self
    }

    /// The axis between two numbers; what lies beyond is cut at the frame.
    #[must_use]
    pub fn between(mut self, limits: Option<[f64; 2]>) -> Self {
        self.limits = limits;
        self
    }

    /// The range of the limits, where they make one.
    pub(super) fn limited(&self) -> Option<Range> {
        let [low, high] = self.limits?.map(|limit| self.scale.place(limit));
        let (low, high) = (low?, high?);
        (low < high).then_some(Range { low, high })
    }

    /// The axis, made to hold a number.
    #[must_use]
    pub fn including(mut self, value: f64) -> Self {
        self.include.push(value);
        self
    }
}

/// Ends of an axis, in the units in which it is even; `low < high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Range {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Range {
    /// Where a place lies between the ends, 0 to 1.
    pub(super) fn part(self, place: f64) -> f64 {
        (place - self.low) / (self.high - self.low)
    }

    pub(super) fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_drawable_numbers_have_a_place() {
        for scale in
            [Scale::Linear, Scale::Logarithmic, Scale::SymmetricLogarithmic { threshold: f64::NAN }]
        {
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX] {
                assert_eq!(scale.place(value), None);
            }
            assert!(scale.place(1e-20).is_some_and(f64::is_finite));
        }
        assert_eq!(Scale::Logarithmic.place(-1.0), None);
        assert_eq!(Scale::Logarithmic.place(0.0), None);
    }

    #[test]
    fn the_symmetric_logarithm_is_odd_and_even_in_decades_far_out() {
        let scale = Scale::SymmetricLogarithmic { threshold: 1e-3 };
        let place = |value| scale.place(value).unwrap();
        assert_eq!(place(-5.0), -place(5.0));
        // asinh(v/2c)/ln 10 = log10(v/c) + O((c/v)^2)
        assert!((place(100.0) - 5.0).abs() < 1e-9);
        assert!((place(1e-6) - 0.5e-3 / std::f64::consts::LN_10).abs() < 1e-9);
    }

    #[test]
    fn a_range_is_never_empty() {
        for scale in [Scale::Linear, Scale::Logarithmic] {
            for values in [vec![], vec![0.0], vec![1e20, 1e20], vec![-7.0], vec![1e-300, 2e-300]] {
                let places: Vec<_> = values.iter().filter_map(|&v| scale.place(v)).collect();
                let range = scale.range(places.iter().copied(), 0.0);
                assert!(range.low < range.high, "{scale:?} {values:?}");
                assert!(places.iter().all(|&p| (0.0..=1.0).contains(&range.part(p))));
            }
        }
    }
}
