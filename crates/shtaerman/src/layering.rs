//! What lies below the surface if not one material: a layer of finite thickness on a rigid base, a coated half-plane, and what a user gives by its influence function.

use crate::error::{positive, require};
use crate::{Elastic, Error, Influence};

/// What a layer of finite thickness lies on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LayerBase {
    /// A rigid base without friction; Poisson's ratio enters `E*` alone.
    Frictionless,
    /// A rigid base that holds a layer of this Poisson's ratio.
    Bonded {
        /// `nu`, greater than -1 and at most 1/2.
        poisson_ratio: f64,
    },
}

/// What lies below the surface; lengths in the units of the problem.
///
/// Under the pressure `p cos(q x)`, and `p J_0(q r)` on a layer, the surface settles by `2 M(q h)/(q E*) p` with the thickness `h`, the modulus `E*` of the material on top and the
/// transfer function `M`, which tends to 1 as `exp(-2u)` does, but for powers of `u`.
#[derive(Debug, Clone, PartialEq)]
pub enum Layering {
    /// A layer on a rigid base: [`Layering::layer`].
    #[non_exhaustive]
    Layer {
        /// `h`.
        thickness: f64,
        /// What it lies on.
        base: LayerBase,
    },
    /// A coating bonded to a half-plane: [`Layering::coating`].
    #[non_exhaustive]
    Coating {
        /// `h`.
        thickness: f64,
        /// The material of the coating.
        coating: Elastic,
        /// The material below it.
        substrate: Elastic,
    },
    /// Anything else, by its influence function; it has its own length for the thickness.
    Own(Influence),
}

/// Least and largest thickness in half-widths. Thinner ones are springs to the rough layer, and of theta0 = 1 to 3e4 under a parabola 7 of 16 were not solved at 0.004, 1 of 12 at 0.01; to thicker
/// ones a half-plane is near enough.
const THICKNESS: [f64; 2] = [1e-2, 1e4];
/// The same of a layer under a circular punch, whose kernel takes a mean over the angle.
const DISK_THICKNESS: [f64; 2] = [0.05, 1e4];
/// Most that one of both materials of a coating may be stiffer.
const CONTRAST: f64 = 1e4;
/// Below this `u` differences of hyperbolic functions are summed by their series.
const SMALL: f64 = 1.0;

impl Layering {
    /// A layer of the thickness `h` on a rigid base.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the thickness is finite and positive and Poisson's ratio greater than -1 and at most 1/2.
    pub fn layer(thickness: f64, base: LayerBase) -> Result<Self, Error> {
        positive("thickness", thickness)?;
        if let LayerBase::Bonded { poisson_ratio } = base {
            Elastic::new(1.0, poisson_ratio)?;
        }
        Ok(Self::Layer { thickness, base })
    }

    /// A coating of the thickness `h`, bonded to a half-plane.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless the thickness is finite and positive, and where one material is more than 1e4 times stiffer than the other.
    pub fn coating(thickness: f64, coating: Elastic, substrate: Elastic) -> Result<Self, Error> {
        positive("thickness", thickness)?;
        let share = coating.plane_strain_modulus() / substrate.plane_strain_modulus();
        require(
            (1.0 / CONTRAST..=CONTRAST).contains(&share),
            "young_modulus",
            coating.young_modulus(),
            "between 1e-4 and 1e4 times that of the foundation (by E/(1 - nu^2)): softer coatings are a layer on a rigid base, stiffer ones a rigid punch",
        )?;
        Ok(Self::Coating { thickness, coating, substrate })
    }

    /// `h`; of an influence function without a length 1.
    #[must_use]
    pub fn thickness(&self) -> f64 {
        match self {
            Self::Layer { thickness, .. } | Self::Coating { thickness, .. } => *thickness,
            Self::Own(influence) => influence.length().unwrap_or(1.0),
        }
    }

    /// What the user has given it by, as errors name it.
    pub(crate) fn field(&self) -> &'static str {
        match self {
            Self::Layer { .. } | Self::Coating { .. } => "thickness",
            Self::Own(_) => "influence",
        }
    }

    /// `E*` that `theta0` counts by over that of the material at the surface, where points meet: the foundation's is what lies below a coating, and on top of all else.
    pub(crate) fn strength(&self) -> f64 {
        match self {
            Self::Layer { .. } | Self::Own(_) => 1.0,
            Self::Coating { .. } => 1.0 / self.far_share(),
        }
    }

    /// `K - ln(1/d)` where that is how the kernel is given; none where it has a transfer function.
    pub(crate) fn remainder(&self) -> Option<&Influence> {
        match self {
            Self::Own(influence) => Some(influence).filter(|known| known.length().is_none()),
            Self::Layer { .. } | Self::Coating { .. } => None,
        }
    }

    /// The same with lengths in half-widths.
    #[must_use]
    pub(crate) fn scaled(mut self, half_width: f64) -> Self {
        match &mut self {
            Self::Layer { thickness, .. } | Self::Coating { thickness, .. } => {
                *thickness /= half_width;
            }
            Self::Own(influence) => return Self::Own(influence.clone().scaled(half_width)),
        }
        self
    }

    /// The same on a foundation of another material: that of the layer, or that below the coating.
    ///
    /// # Errors
    /// Those of [`Layering::coating`].
    pub(crate) fn on(self, foundation: Elastic) -> Result<Self, Error> {
        match self {
            Self::Layer { thickness, base } => {
                let base = match base {
                    LayerBase::Frictionless => base,
                    LayerBase::Bonded { .. } => {
                        LayerBase::Bonded { poisson_ratio: foundation.poisson_ratio() }
                    }
                };
                Self::layer(thickness, base)
            }
            Self::Coating { thickness, coating, .. } => {
                Self::coating(thickness, coating, foundation)
            }
            Self::Own(_) => Ok(self),
        }
    }

    /// Refuses another material than that of the foundation: of a bonded layer Poisson's ratio, and what lies below a coating.
    ///
    /// # Errors
    /// [`Error::InvalidValue`].
    pub(crate) fn require_material(&self, foundation: &Elastic) -> Result<(), Error> {
        let must = |is_so: bool, field: &'static str, value: f64, requirement: &'static str| {
            require(is_so, field, value, requirement).map(|_| ())
        };
        match self {
            Self::Layer { base: LayerBase::Bonded { poisson_ratio }, .. } => must(
                *poisson_ratio == foundation.poisson_ratio(),
                "poisson_ratio",
                *poisson_ratio,
                "that of the foundation, whose material is the layer's",
            ),
            Self::Coating { substrate, .. } => must(
                substrate == foundation,
                "young_modulus",
                substrate.young_modulus(),
                "that of the foundation, as its Poisson's ratio: the foundation is what lies below the coating",
            ),
            Self::Layer { .. } | Self::Own(_) => Ok(()),
        }
    }

    /// `M(0)`: what the material far below gives, over what that on top would.
    #[must_use]
    pub fn far_share(&self) -> f64 {
        match self {
            Self::Layer { .. } => 0.0,
            Self::Coating { coating, substrate, .. } => {
                coating.plane_strain_modulus() / substrate.plane_strain_modulus()
            }
            Self::Own(influence) => influence.far_share(),
        }
    }

    /// `M(u)`, `u > 0`; an influence function given by its remainder has none.
    ///
    /// - Frictionless: `(cosh 2u - 1)/(sinh 2u + 2u)`; bonded, with `c = 3 - 4 nu`: `(2 c sinh 2u - 4u)/(2 c cosh 2u + 4u^2 + 1 + c^2)` (I. I. Vorovich, V. M. Aleksandrov,
    ///   V. A. Babeshko, *Non-classical mixed problems of the theory of elasticity*, Nauka, Moscow, 1974);
    /// - coating, with `c_1`, `c_2` of coating and substrate, `n = G_2/G_1`, `K = (1 - n)/(1 + n c_1)`, `L = (c_2 - n c_1)/(c_2 + n)`, `e = exp(-2u)`:
    ///   `(1 + 4 K u e - K L e^2)/(1 - (K + L + 4 K u^2) e + K L e^2)` (D. M. Burmister, J. Appl. Phys. 16 (1945) 89).
    #[must_use]
    pub fn transfer(&self, u: f64) -> f64 {
        match self {
            Self::Layer { base, .. } => base.transfer(u),
            Self::Coating { coating, substrate, .. } => coated(coating, substrate, u),
            Self::Own(influence) => influence.length().map_or(f64::NAN, |_| influence.at(u)),
        }
    }

    /// What the settlement is measured against.
    #[must_use]
    pub fn gauge(&self) -> &'static str {
        match self {
            Self::Layer { .. } => "the rigid base",
            Self::Own(_) => {
                "the zero of the influence function, whose ln(a/|x-s|) has a = half_width"
            }
            Self::Coating { .. } => {
                "ln(a/|x-s|) of the uncoated foundation, which the displacement is far away, a = half_width"
            }
        }
    }
}

/// Refuses a thickness, in half-widths, out of range.
///
/// # Errors
/// [`Error::InvalidValue`].
pub(crate) fn require_thickness(
    layering: &Layering,
    half_width: f64,
    is_circular: bool,
) -> Result<(), Error> {
    let ([least, most], requirement) = match layering {
        Layering::Coating { .. } => (
            THICKNESS,
            "between 0.01 and 1e4 half-widths: leave a thinner one out, and under a thicker one the foundation",
        ),
        Layering::Own(_) => (THICKNESS, "given with a length between 0.01 and 1e4 half-widths"),
        Layering::Layer { .. } if is_circular => (
            DISK_THICKNESS,
            "between 0.05 and 1e4 radii: a thinner layer is a bed of springs, (1 - nu^2) h/E more roughness without friction, (1 - 2 nu)(1 + nu)/(1 - nu) h/E bonded; for a thicker one leave thickness out",
        ),
        Layering::Layer { .. } => (
            THICKNESS,
            "between 0.01 and 1e4 half-widths: a thinner layer is a bed of springs, (1 - nu^2) h/E more roughness without friction, (1 - 2 nu)(1 + nu)/(1 - nu) h/E bonded; for a thicker one leave thickness out",
        ),
    };
    let thickness = layering.thickness();
    if layering.remainder().is_some() {
        return Ok(());
    }
    let is_solved = (least..=most).contains(&(thickness / half_width));
    require(is_solved, layering.field(), thickness, requirement).map(|_| ())
}

impl LayerBase {
    /// `M(u)`.
    fn transfer(self, u: f64) -> f64 {
        // sinh and cosh of 2u over exp(2u)
        let decay = (-4.0 * u).exp();
        let (sinh, cosh, unit) = (-0.5 * (-4.0 * u).exp_m1(), 0.5 + 0.5 * decay, (-2.0 * u).exp());
        match self {
            Self::Frictionless => {
                let half = -(-2.0 * u).exp_m1();
                0.5 * half * half / (sinh + 2.0 * u * unit)
            }
            Self::Bonded { poisson_ratio } => {
                let c = 3.0 - 4.0 * poisson_ratio;
                (2.0 * c * sinh - 4.0 * u * unit)
                    / (2.0 * c * cosh + (4.0 * u * u + 1.0 + c * c) * unit)
            }
        }
    }
}

/// `M(u)` of a coating. The denominator is written so that nothing cancels under a stiff one, where `K` and `L` are nearly 1:
/// `(1-K)(1-L) + (1-e) [L (1-K) + K (1-L) e] + 4 K e (sinh^2 u - u^2)`.
fn coated(coating: &Elastic, substrate: &Elastic, u: f64) -> f64 {
    let shear = |material: &Elastic| material.young_modulus() / (1.0 + material.poisson_ratio());
    let [c1, c2] = [coating, substrate].map(|material| 3.0 - 4.0 * material.poisson_ratio());
    let n = shear(substrate) / shear(coating);
    let (k, l) = ((1.0 - n) / (1.0 + n * c1), (c2 - n * c1) / (c2 + n));
    let [rest_k, rest_l] = [n * (1.0 + c1) / (1.0 + n * c1), n * (1.0 + c1) / (c2 + n)];
    let (e, fallen) = ((-2.0 * u).exp(), -(-2.0 * u).exp_m1());
    // 4 e (sinh^2 u - u^2), by u^4/3 + 2 u^6/45 + ... = sum 2^(2k-1) u^(2k)/(2k)! from k = 2
    let bent = if u < SMALL {
        let square = 4.0 * u * u;
        let mut term = 0.25 * square;
        let mut sum = 0.0;
        for k in 2..=12 {
            let order = 2.0 * f64::from(k);
            term *= square / (order * (order - 1.0));
            sum += term;
        }
        4.0 * e * sum
    } else {
        fallen * fallen - 4.0 * u * u * e
    };
    let numerator = 1.0 + 4.0 * k * u * e - k * l * e * e;
    numerator / (rest_k * rest_l + fallen * (l * rest_k + k * rest_l * e) + k * bent)
}
