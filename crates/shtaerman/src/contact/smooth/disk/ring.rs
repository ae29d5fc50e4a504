//! A ring of contact in the logarithm of its radius: `ln r = m + l cos phi`.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::contact::zones::Zone;

/// A ring `b <= r <= a`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Ring {
    pub(super) zone: Zone,
    /// `l = ln(a/b)/2`.
    pub(super) half: f64,
}

/// A place by its radius and its distances from both edges of the ring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spot {
    pub(super) radius: f64,
    pub(super) from_inner: f64,
    pub(super) from_outer: f64,
}

impl Ring {
    pub(super) fn new(zone: Zone) -> Self {
        Self { zone, half: 0.5 * distance(zone.left(), zone.length()) }
    }

    pub(super) fn inner(&self) -> f64 {
        self.zone.left()
    }

    pub(super) fn outer(&self) -> f64 {
        self.zone.right()
    }

    /// The place at `phi`, which counts from the outer edge.
    pub(super) fn spot(&self, angle: f64) -> Spot {
        let (sine, cosine) = (0.5 * angle).sin_cos();
        let from_inner = self.inner() * (2.0 * self.half * cosine * cosine).exp_m1();
        let from_outer = -self.outer() * (-2.0 * self.half * sine * sine).exp_m1();
        let radius =
            if angle < FRAC_PI_2 { self.outer() - from_outer } else { self.inner() + from_inner };
        Spot { radius, from_inner, from_outer }
    }

    /// `phi` by the distances from both edges.
    pub(super) fn angle(&self, from_inner: f64, from_outer: f64) -> f64 {
        let share = |from: f64| (from / (2.0 * self.half)).clamp(0.0, 1.0).sqrt().asin();
        if from_outer < from_inner {
            2.0 * share(-(-from_outer / self.outer()).ln_1p())
        } else {
            PI - 2.0 * share((from_inner / self.inner()).ln_1p())
        }
    }
}

/// `ln((r + d)/r)`.
pub(super) fn distance(radius: f64, beyond: f64) -> f64 {
    (beyond / radius).ln_1p()
}

/// `ln r` of one place less that of another on the same ring, by their angles.
pub(super) fn along(half: f64, one: f64, two: f64) -> f64 {
    -2.0 * half * (0.5 * (one + two)).sin() * (0.5 * (one - two)).sin()
}
