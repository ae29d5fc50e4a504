//! A kernel of rings with a transfer function.

use std::f64::consts::PI;
use std::sync::Arc;

use super::require_thickness;
use super::spectrum::Integral;
use super::table::Table;
use crate::kernel::weber_sonine::WeberSonine;
use crate::traits::{Kernel, Pair, Singularity, Split};
use crate::{Error, Interval};

/// Least thickness in radii: the mean over the angle takes a thousand places there.
const LEAST: f64 = 0.02;
/// The rule of `n` places about the axis is exact to `exp(-FALLEN)` where `n` times the distance of the integrand's singularities from the real angles is half of that.
const FALLEN: f64 = 38.0;
/// Rules of 2, 4, 8, ... places up to two to this power.
const RULES: u32 = 11;

/// `W(x, s) = int_0^inf M(u h) J_mu(u x) J_mu(u s) du` on `(0, 1)` with the measure `s ds`, `mu` 0 or 1: [`WeberSonine`] of the exponent 0 with the length `h` (the thickness of a layer)
/// and a transfer function `M > 0` that tends to 1 as `exp(-2u)` does, but for powers of `u`. Positive.
///
/// By Neumann's addition theorem it is that kernel and the mean over the angle of a function of the distance,
///
/// `W = W_1 + (1/(pi h)) int_0^pi S(R/h) cos(mu phi) dphi`, `R^2 = x^2 + s^2 - 2 x s cos phi`, `S(t) = int_0^inf (M(u) - 1) J_0(ut) du`.
#[derive(Debug, Clone)]
pub struct TransferDisk {
    whole: WeberSonine,
    thickness: f64,
    table: Table,
    /// `[4 sin^2(phi/2), cos(mu phi)]` of the rules.
    rules: Vec<Vec<[f64; 2]>>,
}

impl TransferDisk {
    /// The kernel of the harmonic `mu`, with `h` and `M`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a thickness below 0.02 and an order above 1, [`Error::NotFinite`] where `M` is not finite.
    pub fn new(
        order: usize,
        thickness: f64,
        transfer: impl Fn(f64) -> f64 + Send + Sync + 'static,
    ) -> Result<Self, Error> {
        require_thickness(thickness, LEAST, "finite and at least 0.02 of the radius")?;
        if order > 1 {
            return Err(Error::InvalidParameter {
                name: "order",
                value: order as f64,
                requirement: "0 or 1",
            });
        }
        let whole = WeberSonine::new(1.0, order as f64, 0.0)?;
        // (M(0) - 1)/t far away.
        let g = Arc::new(move |u| transfer(u) - 1.0);
        let table = Table::new(Integral { g, wave: libm::j0, fall: 1 }, 2.0 / thickness)?;
        let rules = (1..=RULES).map(|power| rule(1 << power, order)).collect();
        Ok(Self { whole, thickness, table, rules })
    }

    /// `h`.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// What the kernel has beside that of [`WeberSonine`]: a smooth function, even in `x` and `s` for `mu = 0`, odd for 1.
    #[must_use]
    pub fn remainder(&self, x: f64, s: f64) -> f64 {
        let product = x * s;
        let (difference, double) = ((x - s).powi(2), 2.0 * self.thickness);
        // cosh of the imaginary part of the angle at which R = 2 i h, where S is singular
        let above = if product > 0.0 {
            (difference + double * double) / (2.0 * product)
        } else {
            f64::INFINITY
        };
        let height = above + (above * (above + 2.0)).sqrt();
        let count = 0.5 * FALLEN / height.ln_1p();
        let index = (count.max(1.0).log2().ceil() as usize).saturating_sub(1);
        let rule = &self.rules[index.min(self.rules.len() - 1)];
        let sum: f64 = (rule.iter())
            .map(|[square, weight]| {
                let distance = (difference + product * square).sqrt();
                weight * self.table.at(distance / self.thickness)
            })
            .sum();
        sum / (rule.len() as f64 * self.thickness)
    }
}

/// `[4 sin^2(phi/2), cos(mu phi)]` at the middles of so many parts of `0 .. pi`.
fn rule(count: usize, order: usize) -> Vec<[f64; 2]> {
    (0..count)
        .map(|j| {
            let angle = PI * (j as f64 + 0.5) / count as f64;
            let square = 4.0 * (0.5 * angle).sin().powi(2);
            [square, if order == 0 { 1.0 } else { angle.cos() }]
        })
        .collect()
}

impl Kernel for TransferDisk {
    fn interval(&self) -> Interval {
        self.whole.interval()
    }

    fn singularity(&self) -> Singularity {
        self.whole.singularity()
    }

    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        let Split { factor, rest } = self.whole.split(x, s, distance);
        Split { factor, rest: rest + self.remainder(x, s) }
    }

    fn pair(&self, x: f64, s: f64, distance: f64) -> Pair {
        let Pair { value, factor } = self.whole.pair(x, s, distance);
        Pair { value: value + self.remainder(x, s), factor }
    }

    fn measure(&self, s: f64) -> f64 {
        self.whole.measure(s)
    }

    fn mass_function(&self, x: f64) -> f64 {
        self.whole.mass_function(x)
    }

    fn end_exponent(&self) -> f64 {
        self.whole.end_exponent()
    }

    fn settled(&self) -> f64 {
        self.whole.settled()
    }

    fn value(&self, x: f64, s: f64) -> f64 {
        self.whole.value(x, s) + self.remainder(x, s)
    }
}
