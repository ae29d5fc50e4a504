//! Integrals of waves: `D(t) = int_0^inf g(u) c(ut) du` by Gauss's rule on panels of `u`.

use std::fmt;
use std::sync::Arc;

use crate::Error;
use crate::basis::chebyshev::{ChebyshevSeries, points};
use crate::quadrature::{Rule, gauss_legendre};

/// Beyond this `u` a transfer function counts as 1: what it lacks falls as `exp(-2u)`, times a power of `u`, and `exp(-2u) u^2` is 1e-19 there.
pub const LAST_WAVENUMBER: f64 = 25.0;
/// Panels of `u` are so long at most, and towards 0 half as long as the one before so many times: stiff plates on soft ground change `g` at a small `u`.
const LONGEST: f64 = 0.5;
const HALVED: i32 = 14;
/// Nodes on a panel, and the angle `ut` that a panel may turn by: Gauss's rule is exact to rounding there.
const NODES: usize = 16;
const TURN: f64 = 6.0;
/// Places of a panel at which `g` is looked at between the nodes: what is narrower than their distance may be missed.
const SEEN: usize = 512;

/// A function of one variable, shared.
pub(super) type Shared = Arc<dyn Fn(f64) -> f64 + Send + Sync>;

/// `D(t)`, which falls as `t^-fall`; `g` falls as `exp(-2u)` times a power of `u`, so that `D` is analytic for `|Im t| < 2`.
#[derive(Clone)]
pub(super) struct Integral {
    pub(super) g: Shared,
    /// `c`: the cosine or Bessel's function `J_0`.
    pub(super) wave: fn(f64) -> f64,
    pub(super) fall: i32,
}

impl fmt::Debug for Integral {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Integral").field("fall", &self.fall).finish_non_exhaustive()
    }
}

/// Nodes and weights of `u` with the values of `g`, for `t` up to a largest one.
pub(super) struct Spectrum {
    nodes: Vec<[f64; 2]>,
    /// What the last Legendre coefficients of `g` on the panels add up to: next to nothing of a `g` that is as smooth as it should be.
    pub(super) unresolved: f64,
}

impl Spectrum {
    /// # Errors
    /// [`Error::NotFinite`] where `g` is not finite.
    pub(super) fn new(g: &dyn Fn(f64) -> f64, far: f64) -> Result<Self, Error> {
        let rule = gauss_legendre(NODES)?;
        let mut spectrum = Self { nodes: Vec::new(), unresolved: 0.0 };
        for panel in panels() {
            spectrum.add(&rule, g, panel, far);
        }
        if let Some([u, value]) = spectrum.nodes.iter().find(|[_, value]| !value.is_finite()) {
            return Err(Error::NotFinite { what: "transfer function", at: *u, value: *value });
        }
        Ok(spectrum)
    }

    /// `D(t)` for `t` up to the largest.
    pub(super) fn at(&self, wave: &dyn Fn(f64) -> f64, t: f64) -> f64 {
        self.nodes.iter().rev().map(|[u, value]| value * wave(u * t)).sum()
    }

    /// Adds the nodes of a panel, cut where it turns too far.
    fn add(&mut self, rule: &Rule, g: &dyn Fn(f64) -> f64, [left, right]: [f64; 2], far: f64) {
        let parts = ((right - left) * far / TURN).ceil().max(1.0);
        let half = 0.5 * (right - left) / parts;
        for k in 0..parts as usize {
            let middle = left + (2.0 * k as f64 + 1.0) * half;
            let mut last = 0.0;
            for (y, weight) in rule.nodes.iter().zip(&rule.weights) {
                let u = middle + half * y;
                let value = half * weight * g(u);
                last += (NODES as f64 - 0.5) * value * legendre(NODES - 1, *y);
                self.nodes.push([u, value]);
            }
            self.unresolved += last.abs();
        }
    }
}

/// `P_n(y)`.
fn legendre(n: usize, y: f64) -> f64 {
    let (mut before, mut value) = (0.0, 1.0);
    for k in 0..n {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k + 1.0) * y * value - k * before) / (k + 1.0));
    }
    value
}

/// The panels of `u`.
fn panels() -> Vec<[f64; 2]> {
    let ends = (0..=HALVED).rev().map(|halved| LONGEST * 0.5f64.powi(halved));
    let evenly = (2..=(LAST_WAVENUMBER / LONGEST).ceil() as u32).map(|k| f64::from(k) * LONGEST);
    let mut left = 0.0;
    ends.chain(evenly).map(|right| [std::mem::replace(&mut left, right), right]).collect()
}

/// What the nodes miss of `g`, as looked at between them: the differences from the polynomials through Chebyshev points of the panels, added up.
pub(super) fn unseen(g: &dyn Fn(f64) -> f64) -> f64 {
    panels()
        .into_iter()
        .map(|[left, right]| {
            let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
            let at = |y: f64| g(middle + half * y);
            let series =
                ChebyshevSeries::through(points(2 * NODES).iter().map(|y| at(*y)).collect());
            let places = (1..SEEN).map(|i| 2.0 * i as f64 / SEEN as f64 - 1.0);
            let missed = places.map(|y| (at(y) - series.evaluate(y)).abs());
            // A place stands for its share of the panel.
            missed.sum::<f64>() * 2.0 * half / SEEN as f64
        })
        .sum()
}
