//! A number and how far the truth may be from it.

/// What an error statement rests on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Guaranteed in exact arithmetic: the right-hand side *is* its Chebyshev series.
    Bound,
    /// As good as the Chebyshev series of a right-hand side that was not resolved.
    Estimate,
}

/// The interval `[value - radius, value + radius]`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Enclosure {
    /// The middle: the best value known.
    pub value: f64,
    /// The largest possible error of the middle, not negative.
    pub radius: f64,
}

impl Enclosure {
    /// A number known exactly.
    #[must_use]
    pub fn exact(value: f64) -> Self {
        Self { value, radius: 0.0 }
    }

    /// The largest possible `|truth - value|` for some other value.
    ///
    /// ```
    /// let enclosure = fredholm::bounds::Enclosure { value: 2.0, radius: 0.25 };
    /// assert_eq!(enclosure.error_of(1.5), 0.75);
    /// ```
    #[must_use]
    pub fn error_of(&self, value: f64) -> f64 {
        (self.value - value).abs() + self.radius
    }

    /// The lower end.
    #[must_use]
    pub fn lower(&self) -> f64 {
        self.value - self.radius
    }

    /// The upper end.
    #[must_use]
    pub fn upper(&self) -> f64 {
        self.value + self.radius
    }

    /// The largest absolute value.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        self.value.abs() + self.radius
    }
}
