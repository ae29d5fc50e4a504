//! What the rough layer gives under pressure, without dimensions: `v = p0` or `v = p0^kappa`.

use std::f64::consts::PI;

use super::base::Base;
use crate::error::require;
use crate::line_search::STEPS;
use crate::{Error, Problem, Rotational, Vertical};

/// Share of the layer under about the mean pressure below which there is next to no pressure (survey).
pub(super) const FAINT: f64 = 0.1;

/// The law `v = p0^kappa`; where `v < 0` a layer that bends has no pressure, one that is linear pulls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Layer {
    /// `kappa`.
    exponent: f64,
}

impl Layer {
    pub(super) fn new(problem: &Problem) -> Result<Self, Error> {
        let exponent = problem.bodies().law().exponent().unwrap_or(0.0);
        require(
            exponent > 0.0,
            "roughness",
            exponent,
            "greater than zero: a smooth surface has an equation of the first kind",
        )?;
        Ok(Self { exponent })
    }

    pub(super) fn is_linear(&self) -> bool {
        self.exponent == 1.0
    }

    /// `kappa`.
    pub(super) fn exponent(&self) -> f64 {
        self.exponent
    }

    /// `p0(v)`.
    pub(super) fn pressure(&self, v: f64) -> f64 {
        if self.is_linear() { v } else { v.max(0.0).powf(1.0 / self.exponent) }
    }

    /// `dp0/dv`.
    pub(super) fn slope(&self, v: f64) -> f64 {
        if self.is_linear() {
            return 1.0;
        }
        let power = 1.0 / self.exponent;
        power * v.max(0.0).powf(power - 1.0)
    }

    /// What a step of Newton's method makes of `v`, `uniform` under about the mean pressure: where it raises `v` it is one of the pressure, of which the elastic displacement is linear; else a
    /// steep law makes far too much of it.
    pub(super) fn raised(&self, v: f64, step: f64, uniform: f64) -> f64 {
        let from = v.max(FAINT * uniform);
        let rise = v + step - from;
        if rise <= 0.0 {
            return v + step;
        }
        self.displacement(self.pressure(from) + self.slope(from) * rise)
    }

    /// `v(p0)` for `p0 >= 0`.
    pub(super) fn displacement(&self, pressure: f64) -> f64 {
        if self.is_linear() { pressure } else { pressure.powf(self.exponent) }
    }
}

impl Base {
    /// The area of intervals that carries the force.
    pub(super) fn area(&self, intervals: impl Iterator<Item = [f64; 2]>) -> f64 {
        let is_disk = self.ground.is_disk();
        let part = |[left, right]: [f64; 2]| {
            if is_disk { PI * (right - left) * (right + left) } else { right - left }
        };
        intervals.map(part).sum()
    }

    /// `k theta0 dp0/dv`, about: how strong the body is against the layer.
    pub(super) fn steepness(&self) -> f64 {
        if self.layer.is_linear() {
            return self.strength();
        }
        self.strength() * self.layer.slope(self.depth())
    }

    /// What the layer gives under about the mean pressure.
    pub(super) fn depth(&self) -> f64 {
        self.layer.displacement(reference_pressure(self, self.pieces.iter().copied()))
    }
}

/// The pressure on intervals about which a layer that bends is made linear: the mean one, or what the settlement makes of a layer on the body.
pub(super) fn reference_pressure(
    base: &Base,
    intervals: impl Iterator<Item = [f64; 2]> + Clone,
) -> f64 {
    let pressure = match base.load.vertical {
        Vertical::Force(force) => force.abs() / base.area(intervals),
        Vertical::Settlement(settlement) => {
            let deepest = (base.samples.iter())
                .map(|(xi, height)| settlement - base.tilt() * xi - height)
                .fold(0.0, f64::max);
            let length: f64 = intervals.clone().map(|[left, right]| right - left).sum();
            let depth = |p: f64| base.layer.displacement(p) + base.theta() * length * p;
            let (mut low, mut high) =
                (f64::MIN_POSITIVE, deepest.powf(1.0 / base.layer.exponent()));
            for _ in 0..STEPS {
                let middle = (low * high).sqrt();
                if depth(middle) < deepest { low = middle } else { high = middle }
            }
            // A base that turns may touch where the level one is clear.
            let moment = match base.load.rotational {
                Rotational::Moment(moment) => moment.abs(),
                Rotational::Eccentricity(_) | Rotational::Tilt(_) => 0.0,
            };
            low.max(moment / base.area(intervals))
        }
    };
    pressure.max(f64::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_those_of_the_law() {
        for exponent in [0.2, 0.5, 0.9, 1.0] {
            let layer = Layer { exponent };
            for p in [1e-3, 0.4, 2.0] {
                let v = layer.displacement(p);
                assert!((layer.pressure(v) / p - 1.0).abs() < 1e-14);
                let step = 1e-5 * v;
                let slope = (layer.pressure(v + step) - layer.pressure(v - step)) / (2.0 * step);
                assert!((slope / layer.slope(v) - 1.0).abs() < 1e-8, "{exponent} {p}");
            }
        }
        assert_eq!(Layer { exponent: 0.5 }.pressure(-1.0), 0.0);
        assert_eq!(Layer { exponent: 1.0 }.pressure(-1.0), -1.0);
    }
}
