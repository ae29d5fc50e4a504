//! The smooth part of a kernel: `D(t) = int_0^inf g(u) c(ut) du` with `c` the cosine or Bessel's function `J_0`, as Chebyshev series on panels of `t`.
//!
//! `g` falls as `exp(-2u)` times a power of `u`, so that `D` is analytic for `|Im t| < 2`.

use crate::Error;
use crate::basis::chebyshev::{ChebyshevSeries, points};
use crate::quadrature::{Rule, gauss_legendre};

/// `g` is rounding beyond this `u`: `exp(-2u) u^2` is 1e-19 there.
const LAST: f64 = 25.0;
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
struct Spectrum(Vec<[f64; 2]>);

impl Spectrum {
    fn new(g: &dyn Fn(f64) -> f64, far: f64) -> Result<Self, Error> {
        let rule = gauss_legendre(NODES)?;
        let mut nodes = Vec::new();
        let mut left = 0.0;
        for halved in (0..=HALVED).rev() {
            let right = LONGEST * 0.5f64.powi(halved);
            add(&rule, g, [left, right], far, &mut nodes);
            left = right;
        }
        let rest = ((LAST - left) / LONGEST).ceil();
        for k in 0..rest as usize {
            let from = left + k as f64 * LONGEST;
            add(&rule, g, [from, from + LONGEST], far, &mut nodes);
        }
        if let Some([u, value]) = nodes.iter().find(|[_, value]| !value.is_finite()) {
            return Err(Error::NotFinite { what: "transfer function", at: *u, value: *value });
        }
        Ok(Self(nodes))
    }

    fn at(&self, wave: &dyn Fn(f64) -> f64, t: f64) -> f64 {
        self.0.iter().rev().map(|[u, value]| value * wave(u * t)).sum()
    }
}

/// The nodes of a panel, cut where it turns too far.
fn add(
    rule: &Rule,
    g: &dyn Fn(f64) -> f64,
    [left, right]: [f64; 2],
    far: f64,
    nodes: &mut Vec<[f64; 2]>,
) {
    let parts = ((right - left) * far / TURN).ceil().max(1.0);
    let half = 0.5 * (right - left) / parts;
    for k in 0..parts as usize {
        let middle = left + (2.0 * k as f64 + 1.0) * half;
        let places = rule.nodes.iter().zip(&rule.weights);
        nodes.extend(places.map(|(y, weight)| {
            let u = middle + half * y;
            [u, half * weight * g(u)]
        }));
    }
}

/// `D(t)` for `0 <= t <= far`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Table {
    panels: Vec<Panel>,
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
        let mut table = Self { panels: Vec::new() };
        let (mut left, mut right) = (0.0, FIRST.min(far));
        let mut scale = 0.0;
        while left < far {
            let spectrum = Spectrum::new(g, right)?;
            if left == 0.0 {
                scale = spectrum.at(wave, 0.0).abs();
            }
            table.add(&|t| spectrum.at(wave, t), [left, right], HALVINGS, &mut scale);
            (left, right) = (right, (2.0 * right).min(far));
        }
        Ok(table)
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
        let is_resolved = tail.fold(0.0, f64::max) <= RESOLVED * DEGREE as f64 * *scale;
        if is_resolved || halvings == 0 {
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
