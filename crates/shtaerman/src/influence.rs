//! Ground of one's own, by its influence function.

use std::fmt;
use std::sync::Arc;

use fredholm::kernel::LAST_WAVENUMBER;

use crate::Error;
use crate::error::{positive, require};

/// A function of one variable, shared.
type Shared = Arc<dyn Fn(f64) -> f64 + Send + Sync>;

/// Where `M` counts as 1 it has to be so to this.
const SETTLED: f64 = 1e-12;
/// Places at which `M` has to be positive.
const SAMPLES: u32 = 8192;

/// Ground that is the same all along its surface, by what a line load does to that: plane contact of a rough surface on it is solved as on a half-plane.
///
/// Under the pressure `p` the surface settles by `(2/(pi E*)) int K(|x - s|) p(s) ds` with `E*` of the material of the [`Foundation`](crate::Foundation). The influence function `K` is
/// `ln(a/d)` and a smooth function, `a` the half-width of the punch. It is given by that [remainder](Self::by_remainder) or by a [transfer function](Self::by_transfer), and does not
/// change with `E*`: [`with_young_modulus`](crate::Problem::with_young_modulus) and sensitivities scale the whole ground.
///
/// ```
/// use shtaerman::{Elastic, Foundation, Influence, Load, Problem, Profile, Punch};
///
/// // A half-plane whose long waves springs hold back as well: u/M(u) = u + exp(-2u), u = q h, for a wave of the length 2 pi/q.
/// let hung = Influence::by_transfer(4e-3, 0.0, |u| u / (u + (-2.0 * u).exp()))?;
/// let steel = Foundation::new(Elastic::new(200e9, 0.3)?).with_roughness(1.2e-14)?;
/// let crowned = Punch::new(5e-3)?.with_profile(Profile::expression("x^2/(2*0.8)")?);
/// let load = Load::force(0.4e6)?;
/// let free = Problem::new(steel.clone(), crowned.clone(), load)?.solve()?;
/// let held = Problem::new(steel.with_influence(hung), crowned, load)?.solve()?;
/// assert!(held.contact_width() < free.contact_width());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Influence {
    form: Form,
    function: Shared,
}

/// How the influence function is given.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    /// `M(u)`, `u = q h`: `h` and `M(0)`.
    Transfer { length: f64, far_share: f64 },
    /// `K(d) - ln(a/d)`: the unit of `d`.
    Remainder { unit: f64 },
}

impl Influence {
    /// By the transfer function: under the pressure `p cos(q x)` the surface settles by `2 M(q h)/(q E*) p`, with a length `h` (m; of a dimensionless problem in half-widths), and
    /// `K(d) = m ln(a/d) + int_0^inf ((M(u) - m)/u) cos(u d/h) du`, `m = M(0)`.
    ///
    /// `M(u)`, asked for `u > 0`, is smooth and positive and tends to 1 as `exp(-2u)` does, but for powers of `u`, since short waves feel the material at the surface only: a greater
    /// length `h` makes it do so sooner. Layers and coatings are made so, see [`Layering::transfer`](crate::Layering::transfer). The settlement is measured against what is far away if `m = 0`, otherwise in the gauge `m ln(a/d)`. Features of `M` narrower than `1/1000` may be missed.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a length that is not finite and positive, a share that is negative or not finite, and a function that is not positive or not 1 at `u = 25`.
    pub fn by_transfer(
        length: f64,
        far_share: f64,
        transfer: impl Fn(f64) -> f64 + Send + Sync + 'static,
    ) -> Result<Self, Error> {
        positive("length", length)?;
        let is_share = far_share.is_finite() && far_share >= 0.0;
        require(is_share, "far_share", far_share, "finite and not negative")?;
        for i in 1..=SAMPLES {
            let u = LAST_WAVENUMBER * (f64::from(i) / f64::from(SAMPLES)).powi(2);
            let value = transfer(u);
            let is_positive = value.is_finite() && value > 0.0;
            require(is_positive, "transfer", value, "finite and positive for all u > 0")?;
        }
        let last = transfer(LAST_WAVENUMBER);
        require(
            (last - 1.0).abs() <= SETTLED,
            "transfer",
            last,
            "1 at u = 25, to 1e-12: short waves feel the material at the surface only; a greater length moves them there",
        )?;
        Ok(Self { form: Form::Transfer { length, far_share }, function: Arc::new(transfer) })
    }

    /// By its remainder: `K(d) = ln(a/d) + r(d)`, `d` in metres (of a dimensionless problem in half-widths); 0 is a half-plane.
    ///
    /// `r(d)`, asked for `0 <= d <= 2a` and for what is farther where the surface beside the punch is, is smooth, as a function of both signs of `d` too: it begins with `d^2`, not with `d`. A constant in it moves the point that the settlement is measured against.
    /// It is looked at in 8,192 places: features narrower than `a/4000` may be missed, and those that are wider than that and too narrow to be resolved are refused by [`Problem::solve`](crate::Problem::solve).
    #[must_use]
    pub fn by_remainder(remainder: impl Fn(f64) -> f64 + Send + Sync + 'static) -> Self {
        Self { form: Form::Remainder { unit: 1.0 }, function: Arc::new(remainder) }
    }

    /// The length of a transfer function; none of a remainder.
    pub(crate) fn length(&self) -> Option<f64> {
        match self.form {
            Form::Transfer { length, .. } => Some(length),
            Form::Remainder { .. } => None,
        }
    }

    /// `M(0)`; of a remainder 1.
    pub(crate) fn far_share(&self) -> f64 {
        match self.form {
            Form::Transfer { far_share, .. } => far_share,
            Form::Remainder { .. } => 1.0,
        }
    }

    /// `M(u)`, or the remainder at the distance `u` in its unit.
    pub(crate) fn at(&self, u: f64) -> f64 {
        match self.form {
            Form::Transfer { .. } => (self.function)(u),
            Form::Remainder { unit } => (self.function)(u / unit),
        }
    }

    /// The same with lengths in half-widths.
    pub(crate) fn scaled(mut self, half_width: f64) -> Self {
        match &mut self.form {
            Form::Transfer { length: unit, .. } | Form::Remainder { unit } => *unit /= half_width,
        }
        self
    }
}

/// The same form and the same function, not an equal one.
impl PartialEq for Influence {
    fn eq(&self, other: &Self) -> bool {
        self.form == other.form && Arc::ptr_eq(&self.function, &other.function)
    }
}

impl fmt::Debug for Influence {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("Influence").field("form", &self.form).finish_non_exhaustive()
    }
}
