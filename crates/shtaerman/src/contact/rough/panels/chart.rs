//! The coordinates of panels.
//!
//! One punch, a pair and graded ground are taken as they are; a row lies on a circle, `xi = centre + L/2 y`, on which the kernel is `ln 1/(2 sin(pi |y - t|/2))`.

use fredholm::multipole::PanelKernel;

use crate::contact::rough::base::Base;

/// `xi = centre + half y` with `|y| <= 1`, and the kernel by `y`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chart {
    pub(super) kernel: PanelKernel,
    centre: f64,
    half: f64,
    /// Whether the base is the whole circle.
    is_closed: bool,
}

impl Chart {
    /// None where the ground has no fast products.
    pub(super) fn new(base: &Base<'_>) -> Option<Self> {
        let (kernel, half) = base.ground.panel_kernel()?;
        Some(Self { kernel, centre: base.origin, half, is_closed: base.ground.is_closed() })
    }

    /// Whether the base is a wave without gaps.
    pub(super) fn is_closed(&self) -> bool {
        self.is_closed
    }

    /// `y`.
    pub(super) fn local(&self, xi: f64) -> f64 {
        (xi - self.centre) / self.half
    }

    /// `xi`.
    pub(super) fn place(&self, y: f64) -> f64 {
        self.centre + self.half * y
    }

    /// `dxi/dy`, which is the factor of `theta0` too.
    pub(super) fn half(&self) -> f64 {
        self.half
    }

    /// The lever of a pressure: of a wave that is seen from elsewhere that of its image on the base.
    pub(super) fn lever(&self, y: f64) -> f64 {
        let xi = self.place(y);
        if self.is_closed { xi - 2.0 * (0.5 * xi).round() } else { xi }
    }

    /// Where a place of the base lies among the zones of a wave without gaps.
    pub(super) fn located(&self, xi: f64) -> f64 {
        if self.is_closed { xi + 2.0 * (0.5 * (self.centre - xi)).round() } else { xi }
    }

    /// Where a place among the zones lies on the base.
    pub(super) fn on_base(&self, xi: f64) -> f64 {
        if self.is_closed && xi.abs() > 1.0 { xi - 2.0 * (0.5 * xi).round() } else { xi }
    }

    /// The zones of a wave without gaps as those whose middles lie on the base.
    pub(super) fn zones_on_base(&self, zones: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
        if self.is_closed { super::super::answer::on_the_base(zones) } else { zones.collect() }
    }
}
