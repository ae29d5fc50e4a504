//! Complex numbers, as far as the potential needs them.

use std::ops::{Add, Mul, Sub};

/// `re + i im`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Complex {
    pub(super) re: f64,
    pub(super) im: f64,
}

impl Complex {
    pub(super) const ZERO: Self = Self { re: 0.0, im: 0.0 };

    pub(super) const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    pub(super) fn scaled(self, by: f64) -> Self {
        Self { re: by * self.re, im: by * self.im }
    }

    pub(super) fn size(self) -> f64 {
        self.re.hypot(self.im)
    }

    /// `1/z`; by Smith's division, so that no square leaves the range.
    pub(super) fn inverse(self) -> Self {
        if self.re.abs() >= self.im.abs() {
            let ratio = self.im / self.re;
            let size = self.re + self.im * ratio;
            Self { re: 1.0 / size, im: -ratio / size }
        } else {
            let ratio = self.re / self.im;
            let size = self.re * ratio + self.im;
            Self { re: ratio / size, im: -1.0 / size }
        }
    }
}

impl Add for Complex {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Complex {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
    }
}

impl Mul for Complex {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}
