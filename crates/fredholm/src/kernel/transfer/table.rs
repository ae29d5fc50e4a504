//! The smooth part of a kernel: `D(t) = int_0^inf g(u) c(ut) du` with `c` the cosine or Bessel's function `J_0`, as Chebyshev series on panels of `t`.
//!
//! `g` falls as `exp(-2u)` times a power of `u`, so that `D` is analytic for `|Im t| < 2`.

use super::LAST_WAVENUMBER;
use crate::Error;
use crate::basis::chebyshev::{ChebyshevSeries, points};
use crate::quadrature::{Rule, gauss_legendre};

/// Panels of `u` are so long at most, and towards 0 half as long as the one before so many times: stiff plates on soft ground change `g` at a small `u`.
const LONGEST: f64 = 0.5;
const HALVED: i32 = 14;
/// Nodes on a panel, and the angle `ut` that a panel may turn by: Gauss's rule is exact to rounding there.
const NODES: usize = 16;
const TURN: f64 = 6.0;
/// The first panel of `t`; each after it is as long as all before it.
const FIRST: f64 = 2.0;
/// Degree of the series on a panel, the last coefficients of which show whether it is resolved, and to what of the largest value of all.
const DEGREE: usize = 40;
const TAIL: usize = 3;
const RESOLVED: f64 = 2e-16;
/// How often a panel of `t` may be halved.
const HALVINGS: usize = 6;

/// Nodes and weights of `u` with the values of `g`, for `t` up to a largest one.
struct Spectrum {
    nodes: Vec<[f64; 2]>,
    /// What the last Legendre coefficients of `g` on the panels add up to: next to nothing of a `g` that is as smooth as it should be.
    unresolved: f64,
}

impl Spectrum {
    fn new(g: &dyn Fn(f64) -> f64, far: f64) -> Result<Self, Error> {
        let rule = gauss_legendre(NODES)?;
        let mut spectrum = Self { nodes: Vec::new(), unresolved: 0.0 };
        let mut left = 0.0;
        for halved in (0..=HALVED).rev() {
            let right = LONGEST * 0.5f64.powi(halved);
            spectrum.add(&rule, g, [left, right], far);
            left = right;
        }
        let rest = ((LAST_WAVENUMBER - left) / LONGEST).ceil();
        for k in 0..rest as usize {
            let from = left + k as f64 * LONGEST;
            spectrum.add(&rule, g, [from, from + LONGEST], far);
        }
        if let Some([u, value]) = spectrum.nodes.iter().find(|[_, value]| !value.is_finite()) {
            return Err(Error::NotFinite { what: "transfer function", at: *u, value: *value });
        }
        Ok(spectrum)
    }

    fn at(&self, wave: &dyn Fn(f64) -> f64, t: f64) -> f64 {
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

/// `D(t)` for `0 <= t <= far`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Table {
    panels: Vec<Panel>,
    /// What values may be off by, as quadrature and series show it themselves.
    unresolved: f64,
}

#[derive(Debug, Clone, PartialEq)]
struct Panel {
    left: f64,
    right: f64,
    series: ChebyshevSeries,
    /// The derivative by the place on the panel, from -1 to 1.
    derivative: ChebyshevSeries,
}

impl Table {
    /// # Errors
    /// [`Error::NotFinite`] where `g` is not finite.
    pub(super) fn new(
        g: &dyn Fn(f64) -> f64,
        wave: &dyn Fn(f64) -> f64,
        far: f64,
    ) -> Result<Self, Error> {
        let mut table = Self { panels: Vec::new(), unresolved: 0.0 };
        let (mut left, mut right) = (0.0, FIRST.min(far));
        let mut scale = 0.0;
        while left < far {
            let spectrum = Spectrum::new(g, right)?;
            table.unresolved = table.unresolved.max(spectrum.unresolved);
            if left == 0.0 {
                scale = spectrum.at(wave, 0.0).abs();
            }
            table.add(&|t| spectrum.at(wave, t), [left, right], HALVINGS, &mut scale);
            (left, right) = (right, (2.0 * right).min(far));
        }
        Ok(table)
    }

    /// A function `D` itself, for `0 <= t <= far`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] where it is not finite.
    pub(super) fn of(value: &dyn Fn(f64) -> f64, far: f64) -> Result<Self, Error> {
        let mut table = Self { panels: Vec::new(), unresolved: 0.0 };
        let mut scale = 1.0;
        table.add(value, [0.0, far], HALVINGS, &mut scale);
        let broken = table.panels.iter().find(|panel| !panel.series.evaluate(0.0).is_finite());
        match broken {
            Some(Panel { left, right, .. }) => {
                let at = 0.5 * (left + right);
                Err(Error::NotFinite { what: "remainder of the kernel", at, value: value(at) })
            }
            None => Ok(table),
        }
    }

    /// What values may be off by, as quadrature and series show it themselves.
    pub(super) fn unresolved(&self) -> f64 {
        self.unresolved
    }

    /// The length of the shortest panel.
    pub(super) fn shortest(&self) -> f64 {
        self.panels.iter().fold(f64::INFINITY, |least, panel| least.min(panel.right - panel.left))
    }

    fn add(
        &mut self,
        value: &dyn Fn(f64) -> f64,
        [left, right]: [f64; 2],
        halvings: usize,
        scale: &mut f64,
    ) {
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let values: Vec<f64> = points(DEGREE).iter().map(|y| value(middle + half * y)).collect();
        *scale = values.iter().fold(*scale, |most, value| most.max(value.abs()));
        let series = ChebyshevSeries::through(values);
        let tail = series.coefficients().iter().rev().take(TAIL).map(|c| c.abs());
        let tail = tail.fold(0.0, f64::max);
        let is_resolved = tail <= RESOLVED * DEGREE as f64 * *scale;
        if is_resolved || halvings == 0 {
            self.unresolved = self.unresolved.max(if is_resolved { 0.0 } else { tail });
            let derivative = derivative(series.coefficients());
            self.panels.push(Panel { left, right, series, derivative });
        } else {
            self.add(value, [left, middle], halvings - 1, scale);
            self.add(value, [middle, right], halvings - 1, scale);
        }
    }

    /// `D(t)`; beyond the last panel its value at the end.
    pub(super) fn at(&self, t: f64) -> f64 {
        self.panel(t).map_or(0.0, |panel| panel.series.evaluate(panel.place(t)))
    }

    /// `D'(t)`.
    pub(super) fn slope(&self, t: f64) -> f64 {
        self.panel(t).map_or(0.0, |panel| {
            2.0 / (panel.right - panel.left) * panel.derivative.evaluate(panel.place(t))
        })
    }

    fn panel(&self, t: f64) -> Option<&Panel> {
        let index = self.panels.partition_point(|panel| panel.right < t);
        self.panels.get(index).or(self.panels.last())
    }
}

impl Panel {
    /// The place on the panel, from -1 to 1.
    fn place(&self, t: f64) -> f64 {
        let Self { left, right, .. } = self;
        (((t - left) - (right - t)) / (right - left)).clamp(-1.0, 1.0)
    }
}

/// The derivative of a Chebyshev series: `c'_(k-1) = c'_(k+1) + 2 k c_k`, and half of that for `k = 1`.
fn derivative(coefficients: &[f64]) -> ChebyshevSeries {
    let mut found = vec![0.0; coefficients.len() + 1];
    for k in (1..coefficients.len()).rev() {
        found[k - 1] = found[k + 1] + 2.0 * k as f64 * coefficients[k];
    }
    found[0] *= 0.5;
    ChebyshevSeries::new(found)
}
