//! An elastic layer on a rigid base, indented by a rough punch: `phi + lambda int_{-1}^{1} K(x, s) phi(s) ds = 1`.
//!
//! The pressure `p` on `|x| < a` moves the face of a layer of thickness `h` by `v = (2/(pi E*)) int k((x - s)/h) p(s) ds`, `E* = E/(1 - nu^2)`, with
//!
//! `k(t) = int_0^inf (L(u)/u) cos(ut) du`
//!
//! and with a base that (I. I. Vorovich, V. M. Aleksandrov and V. A. Babeshko, Non-classical mixed problems of the theory of elasticity, Nauka, Moscow, 1974)
//!
//! slides: `L = (cosh 2u - 1)/(sinh 2u + 2u)`; holds the layer: `L = (2 c sinh 2u - 4u)/(2 c cosh 2u + 4u^2 + 1 + c^2)`, `c = 3 - 4 nu`.
//!
//! Under antiplane shear `L = tanh u` (with `G` for `E*/2`), and `k = ln coth(pi |t|/4)`. So `k(t) = ln coth(pi |t|/4) + Q(t)`, where
//! `Q(t) = int_0^inf ((L - tanh u)/u) cos(ut) du` is smooth and even and falls as fast as the logarithm: its integrand is even, analytic near the real line and falls as
//! `exp(-2u)`, so the trapezoidal rule gives all its digits. `Q` is tabulated once, as a Chebyshev series in `t^2`.

use std::f64::consts::{FRAC_PI_4, PI};

use fredholm::basis::Function;
use fredholm::equation::collocate;
use fredholm::kernel::{Kernel, Logarithm, Pair, Singularity, Split};
use fredholm::{Error, Interval};

/// `lambda = 2a/(pi E* chi)` of the tables.
pub const LAMBDA: f64 = 2.0;
/// Tolerance of the collocation.
pub const TOLERANCE: f64 = 1e-12;

/// What lies below the layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Base {
    /// A rigid base without friction.
    Sliding,
    /// A rigid base that holds a layer of this Poisson's ratio.
    Bonded {
        /// `nu`, from 0 to 1/2.
        poisson: f64,
    },
    /// A rigid base that holds a layer under antiplane shear.
    Antiplane,
}

impl Base {
    /// `L(u)`, `u > 0`.
    pub fn transform(self, u: f64) -> f64 {
        // sinh and cosh of 2u over exp(2u)
        let decay = (-4.0 * u).exp();
        let (sinh, cosh, unit) = (-0.5 * (-4.0 * u).exp_m1(), 0.5 + 0.5 * decay, (-2.0 * u).exp());
        match self {
            Self::Sliding => {
                let half = -(-2.0 * u).exp_m1();
                0.5 * half * half / (sinh + 2.0 * u * unit)
            }
            Self::Bonded { poisson } => {
                let c = 3.0 - 4.0 * poisson;
                (2.0 * c * sinh - 4.0 * u * unit)
                    / (2.0 * c * cosh + (4.0 * u * u + 1.0 + c * c) * unit)
            }
            Self::Antiplane => u.tanh(),
        }
    }

    /// `L'(0)`: a thin layer is a bed of springs that give way by `pi L'(0) h (2/(pi E*))` per unit pressure.
    pub fn slope(self) -> f64 {
        match self {
            Self::Sliding => 0.5,
            Self::Bonded { poisson } => 0.5 * (1.0 - 2.0 * poisson) / (1.0 - poisson).powi(2),
            Self::Antiplane => 1.0,
        }
    }
}

/// `(L - tanh u)/u` is rounding beyond this `u`.
const LAST: f64 = 25.0;
/// `Q` is rounding beyond this `t`: the pole of `L` nearest to the real line, `u = 0.739 i` for an incompressible layer, makes it fall as `exp(-0.739 t)`.
const FAR: f64 = 50.0;

/// `Q(t)` by the trapezoidal rule for `|t| <= far`: its error is `Q` at `2 pi/step - far`.
fn smooth_part(base: Base, far: f64) -> impl Fn(f64) -> f64 {
    let step = 2.0 * PI / (far + FAR);
    let count = (LAST / step).ceil() as usize;
    let integrand = move |u: f64| (base.transform(u) - u.tanh()) / u;
    let values: Vec<f64> = (1..=count).map(|j| integrand(j as f64 * step)).collect();
    move |t| {
        let terms = values.iter().zip(1..).map(|(q, j)| q * (f64::from(j) * step * t).cos());
        step * (0.5 * (base.slope() - 1.0) + terms.sum::<f64>())
    }
}

/// The kernel `k((x - s)/h)` on `(-1, 1)`, lengths in half-widths `a` of the punch.
pub struct Layer {
    /// `h/a`.
    thickness: f64,
    /// Largest `t` of the table.
    far: f64,
    table: Function,
}

impl Layer {
    /// A layer of thickness `h/a`; `L` must tend to 1 as `exp(-2u)` does, but for powers of `u`.
    pub fn new(base: Base, thickness: f64) -> Result<Self, Error> {
        if !(thickness > 0.0 && thickness.is_finite()) {
            return Err(Error::InvalidParameter {
                name: "thickness",
                value: thickness,
                requirement: "finite and positive",
            });
        }
        let far = (2.0 / thickness).min(FAR);
        let smooth = smooth_part(base, far);
        let table = Function::resolve(&|y| smooth(far * (0.5 + 0.5 * y).sqrt()))?;
        Ok(Self { thickness, far, table })
    }

    /// `Q(t)`.
    fn smooth(&self, t: f64) -> f64 {
        let share = t / self.far;
        if share > 1.0 && self.far == FAR {
            return 0.0;
        }
        self.table.series().evaluate((2.0 * share * share - 1.0).min(1.0))
    }

    /// `h/a`.
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// `a_0 = lim k(t) + ln t`: a thick layer is a half-plane with the gauge `h exp(a_0)`.
    pub fn gauge_constant(&self) -> f64 {
        self.smooth(0.0) - FRAC_PI_4.ln()
    }
}

impl Kernel for Layer {
    fn interval(&self) -> Interval {
        Interval::unit()
    }

    fn singularity(&self) -> Singularity {
        Singularity::Logarithm
    }

    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        let rest = if distance == 0.0 {
            self.thickness.ln() + self.gauge_constant()
        } else {
            self.pair(x, s, distance).value + distance.ln()
        };
        Split { factor: -1.0, rest }
    }

    fn pair(&self, _x: f64, _s: f64, distance: f64) -> Pair {
        let t = distance / self.thickness;
        // ln coth z = ln(1 + 2/(exp(2z) - 1)): no digit is lost where it is small, nor where it is large.
        let logarithm = (2.0 / (2.0 * FRAC_PI_4 * t).exp_m1()).ln_1p();
        Pair { value: logarithm + self.smooth(t), factor: -1.0 }
    }

    fn is_even(&self) -> bool {
        true
    }
}

/// `int phi dx` on the half-plane that a thick layer becomes: the logarithm with the gauge `h exp(a_0)`.
pub fn on_half_plane(layer: &Layer, lambda: f64) -> Result<Option<f64>, Error> {
    let gauge = layer.thickness() * layer.gauge_constant().exp();
    let kernel = Logarithm::with_gauge(1.0, gauge)?;
    Ok(collocate(&kernel, lambda, &|_| 1.0, &[], TOLERANCE)?.integral)
}

/// `int phi dx` on the bed of springs that a thin layer becomes.
pub fn on_springs(base: Base, thickness: f64, lambda: f64) -> f64 {
    2.0 / (1.0 + lambda * thickness * PI * base.slope())
}
