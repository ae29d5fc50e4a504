//! The interval `L` of an integral equation.

use crate::Error;

/// An interval `[left, right]`, finite unless made by [`Interval::half_line`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    left: f64,
    right: f64,
}

impl Interval {
    /// `[left, right]`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless both ends are finite and `left < right`.
    pub fn new(left: f64, right: f64) -> Result<Self, Error> {
        if !left.is_finite() {
            return Err(Error::InvalidParameter {
                name: "left end",
                value: left,
                requirement: "finite",
            });
        }
        if !right.is_finite() || right <= left {
            return Err(Error::InvalidParameter {
                name: "right end",
                value: right,
                requirement: "finite and right of the left end",
            });
        }
        Ok(Self { left, right })
    }

    /// `[-half_length, half_length]`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `half_length` is finite and positive.
    pub fn symmetric(half_length: f64) -> Result<Self, Error> {
        if half_length.is_finite() && half_length > 0.0 {
            Ok(Self { left: -half_length, right: half_length })
        } else {
            Err(Error::InvalidParameter {
                name: "half_length",
                value: half_length,
                requirement: "finite and positive",
            })
        }
    }

    /// `[-1, 1]`.
    #[must_use]
    pub fn unit() -> Self {
        Self { left: -1.0, right: 1.0 }
    }

    /// `[left, infinity)`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `left` is finite.
    pub fn half_line(left: f64) -> Result<Self, Error> {
        if left.is_finite() {
            return Ok(Self { left, right: f64::INFINITY });
        }
        Err(Error::InvalidParameter { name: "left end", value: left, requirement: "finite" })
    }

    /// Whether both ends are finite.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.right.is_finite()
    }

    /// Left end.
    #[must_use]
    pub fn left(&self) -> f64 {
        self.left
    }

    /// Right end.
    #[must_use]
    pub fn right(&self) -> f64 {
        self.right
    }

    /// Half of the length.
    #[must_use]
    pub fn half_length(&self) -> f64 {
        0.5 * self.right - 0.5 * self.left
    }

    /// Middle.
    #[must_use]
    pub fn centre(&self) -> f64 {
        0.5 * self.left + 0.5 * self.right
    }

    /// Whether `x` lies in the closed interval; false for NaN.
    #[must_use]
    pub fn contains(&self, x: f64) -> bool {
        (self.left..=self.right).contains(&x)
    }
}
