//! A plane kernel with a transfer function.

use std::f64::consts::FRAC_PI_4;
use std::sync::Arc;

use super::local::Local;
use super::require_thickness;
use super::spectrum::Integral;
use super::table::Table;
use crate::special::logarithms;
use crate::traits::{Kernel, Pair, Singularity, Split};
use crate::{Error, Interval};

/// Least thickness in half-lengths of the interval: tables take about a second there.
const LEAST: f64 = 1e-3;

/// `K(x, s) = m ln(1/d) + int_0^inf ((M(u) - m)/u) cos(u d/h) du`, `d = |x - s|`, on `(-1, 1)`, with the length `h` (the thickness of a layer), a transfer function `M > 0` that tends to 1 as
/// `exp(-2u)` does, but for powers of `u`, and `m = M(0)`. Far away it is `m ln(1/d)`.
///
/// With `int_0^inf (tanh u/u) cos(ut) du = ln coth(pi t/4)` it is computed as
///
/// `K = m ln(1/d) + (1 - m) ln coth(pi d/(4 h)) + D(d/h)`, `D(t) = int_0^inf (M - m - (1 - m) tanh u)/u cos(ut) du`:
///
/// where the points meet it is `ln(1/d)` and a smooth function. It is positive if `M` is and `m = 0`; otherwise as the [logarithm](super::super::Logarithm) is, on intervals that are not too long.
#[derive(Debug, Clone, PartialEq)]
pub struct TransferPlane {
    thickness: f64,
    far_share: f64,
    bend: f64,
    table: Table,
    /// `m ln h`.
    far_constant: f64,
    /// What is smooth of the kernel up to `t = near_end`, if that is resolved.
    near_end: f64,
    near: Option<Local>,
}

/// Up to this `t = d/h` the kernel is `-ln t - m ln h` and one smooth function, beyond it `ln coth(pi t/4)` is the sum of six powers of `exp(-pi t/2)`: there the next, `q^13/13`, is below rounding.
const NEAR: f64 = 2.0;
/// From here on `ln coth(pi t/4)` is below rounding of 1.
const FAR: f64 = 25.0;

/// `ln coth(pi t/4)`, `t > NEAR`, as `2 artanh q` with `q = exp(-pi t/2)`.
fn fallen(t: f64) -> f64 {
    let q = (-2.0 * FRAC_PI_4 * t).exp();
    let square = q * q;
    let series = [1.0 / 11.0, 1.0 / 9.0, 1.0 / 7.0, 0.2, 1.0 / 3.0, 1.0];
    2.0 * q * series.into_iter().fold(0.0, |sum, term| sum * square + term)
}

/// `ln(t coth(pi t/4))`, which is smooth and even.
fn smooth(t: f64) -> f64 {
    // t coth(pi t/4) = t + 2t/(exp(pi t/2) - 1)
    let angle = 2.0 * FRAC_PI_4 * t;
    if angle == 0.0 { -FRAC_PI_4.ln() } else { (t + 2.0 * t / angle.exp_m1()).ln() }
}

impl TransferPlane {
    /// The kernel with `h`, `m` and `M`, of which features narrower than `1/1000` may be missed. Beyond the interval, too, where tables are made as distances are asked for.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a thickness below `1e-3` or a share that is negative or not finite, [`Error::NotFinite`] where `M` is not finite.
    pub fn new(
        thickness: f64,
        far_share: f64,
        transfer: impl Fn(f64) -> f64 + Send + Sync + 'static,
    ) -> Result<Self, Error> {
        require_thickness(thickness, LEAST, "finite and at least 1e-3 of the half-length")?;
        if !(far_share.is_finite() && far_share >= 0.0) {
            return Err(Error::InvalidParameter {
                name: "share far away",
                value: far_share,
                requirement: "finite and not negative",
            });
        }
        let g = move |u: f64| (transfer(u) - far_share - (1.0 - far_share) * u.tanh()) / u;
        // What is left of M beside its even part goes as u, whose integral falls as t^-2.
        let integral = Integral { g: Arc::new(g), wave: f64::cos, fall: 2 };
        let table = Table::new(integral, 2.0 / thickness)?;
        Ok(Self::with_table(thickness, far_share, thickness, table))
    }

    /// The kernel `ln(1/d) + D(d)` with a smooth function `D` of distances up to 2, its own even continuation beyond 0: `m = 1` and `h = 1`. Features of `D` narrower than `1/4000` may be missed.
    ///
    /// # Errors
    /// [`Error::NotFinite`] where `D` is not finite.
    pub fn with_remainder(
        remainder: impl Fn(f64) -> f64 + Send + Sync + 'static,
    ) -> Result<Self, Error> {
        let table = Table::of(Arc::new(remainder), 2.0)?;
        Ok(Self::with_table(1.0, 1.0, table.shortest(), table))
    }

    fn with_table(thickness: f64, far_share: f64, bend: f64, table: Table) -> Self {
        let value = |t: f64| (1.0 - far_share) * smooth(t) + table.at(t);
        // As far as distances on the interval reach.
        let near_end = NEAR.min(2.0 / thickness);
        let near = Local::new(|x| value(0.5 * near_end * (x + 1.0)), value(0.0).abs().max(1.0));
        let far_constant = if far_share == 0.0 { 0.0 } else { far_share * thickness.ln() };
        Self { thickness, far_share, bend, table, far_constant, near_end, near }
    }

    /// What values of the kernel may be off by beyond rounding, as quadrature and series show it themselves: much only where `M` or `D` is not smooth.
    #[must_use]
    pub fn unresolved(&self) -> f64 {
        self.table.unresolved()
    }

    /// The length within which the kernel bends: `h`, of a given `D` that of the shortest panel of its table.
    #[must_use]
    pub fn bend(&self) -> f64 {
        self.bend
    }

    /// `dD/dt` where the points meet, 0 of an even function.
    #[must_use]
    pub fn slope_at_zero(&self) -> f64 {
        self.table.slope(0.0)
    }

    /// `h`.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// `lim K + ln(d/h)` where the points meet: of a kernel without `m` a thick layer is a half-plane with the gauge `h` times its exponential.
    #[must_use]
    pub fn gauge_constant(&self) -> f64 {
        self.table.at(0.0)
            - (1.0 - self.far_share) * FRAC_PI_4.ln()
            - self.far_share * self.thickness.ln()
    }

    /// `(1 - m) ln coth(pi t/4)`.
    fn beyond_near(&self, t: f64) -> f64 {
        let logarithm = match t {
            // Next to nothing else it counts however small it is.
            t if t > FAR && self.far_share > 0.0 => 0.0,
            t if t > NEAR => fallen(t),
            // ln coth z = ln(1 + 2/(exp(2z) - 1)): no digit is lost where it is small, nor where it is large.
            t => (2.0 / (2.0 * FRAC_PI_4 * t).exp_m1()).ln_1p(),
        };
        (1.0 - self.far_share) * logarithm
    }

    /// The values at distances that are all near, in the place of `ln d`.
    fn add_near(&self, near: &Local, t: &[f64], values: &mut [f64]) {
        let constant = self.thickness.ln() - self.far_constant;
        values.iter_mut().for_each(|value| *value = constant - *value);
        let places: Vec<f64> = t.iter().map(|t| 2.0 / self.near_end * t - 1.0).collect();
        near.add(&places, values);
    }

    /// The values at distances of which none is near, in the place of `ln d`.
    fn add_far(&self, t: &[f64], values: &mut [f64]) {
        for (value, t) in values.iter_mut().zip(t) {
            let far = if self.far_share == 0.0 { 0.0 } else { -self.far_share * *value };
            *value = far + self.beyond_near(*t);
        }
        self.table.add(t, values);
    }

    /// `d dK/dd` at the distance `d`.
    #[must_use]
    pub fn reduced_slope(&self, distance: f64) -> f64 {
        let t = distance / self.thickness;
        if t == 0.0 {
            return -1.0;
        }
        // d/dt ln coth(pi t/4) = -(pi/2)/sinh(pi t/2)
        let angle = 2.0 * FRAC_PI_4 * t;
        let logarithm = -angle / angle.sinh();
        -self.far_share + (1.0 - self.far_share) * logarithm + t * self.table.slope(t)
    }
}

impl Kernel for TransferPlane {
    fn interval(&self) -> Interval {
        Interval::unit()
    }

    fn singularity(&self) -> Singularity {
        Singularity::Logarithm
    }

    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        let rest = if distance == 0.0 {
            self.gauge_constant() + self.thickness.ln()
        } else {
            self.pair(x, s, distance).value + distance.ln()
        };
        Split { factor: -1.0, rest }
    }

    fn pair(&self, _x: f64, _s: f64, distance: f64) -> Pair {
        let t = distance / self.thickness;
        if let Some(near) = self.near.as_ref().filter(|_| t <= self.near_end) {
            let value = near.at(2.0 / self.near_end * t - 1.0) - t.ln() - self.far_constant;
            return Pair { value, factor: -1.0 };
        }
        let far = if self.far_share == 0.0 { 0.0 } else { -self.far_share * distance.ln() };
        let value = far + self.beyond_near(t) + self.table.at(t);
        Pair { value, factor: -1.0 }
    }

    fn pairs(
        &self,
        _x: f64,
        _points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        factors: &mut [f64],
    ) {
        factors.fill(-1.0);
        values.copy_from_slice(distances);
        logarithms(values);
        let t: Vec<f64> = distances.iter().map(|distance| distance / self.thickness).collect();
        let mut from = 0;
        while let Some(first) = t.get(from) {
            let near = self.near.as_ref().filter(|_| *first <= self.near_end);
            let is_near = |t: &f64| self.near.is_some() && *t <= self.near_end;
            let run = t[from..].iter().take_while(|t| is_near(t) == near.is_some()).count();
            let run = from..from + run;
            let (t, values) = (&t[run.clone()], &mut values[run.clone()]);
            match near {
                Some(near) => self.add_near(near, t, values),
                None => self.add_far(t, values),
            }
            from = run.end;
        }
    }

    fn is_even(&self) -> bool {
        true
    }
}
