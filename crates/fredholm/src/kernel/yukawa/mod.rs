//! Kernel 7: the Yukawa potential on a disk, one angular harmonic of it.

mod angular;
mod diagonal;
mod eigenvalues;
mod elliptic;
mod relation;
mod waves;

pub use relation::YukawaRelation;

use angular::Harmonic;
use diagonal::Diagonal;
use elliptic::{Circle, Points};

use super::{Kernel, Pair, Singularity, Split};
use crate::{Error, Interval};

/// Radii whose squares and inverses have room in double precision.
const RADII: std::ops::RangeInclusive<f64> = 1e-100..=1e100;
/// Most decay lengths in the radius.
const LARGEST_DECAY: f64 = 1e5;
/// Highest harmonic.
const HIGHEST_HARMONIC: u32 = 200;
/// Points nearer to the centre than this, over the radius, have the split of this one: deeper the terms overflow.
const INNERMOST: f64 = 1e-150;
/// Beyond this the kernel underflows.
const FADED: f64 = 760.0;

/// `K(x, s) = 2 int_0^pi exp(-chi R)/R cos(m u) du`, `R^2 = x^2 + s^2 - 2 x s cos u`, on `(0, a)` with the measure `s ds`: the harmonic `m` of the
/// potential `exp(-chi R)/R` of a disk of radius `a`. Positive.
///
/// `chi >= 0`, the screening, is an inverse length; `chi = 0` gives `2 pi` times the kernel of Weber and Sonine with `gamma = 0`. Homogeneous of degree -1 in the unit of length.
///
/// Singularity: `-(2/x) ln|x - s|`. `K(0, s) = 2 pi exp(-chi s)/s` for `m = 0`, else 0.
///
/// A value takes 0.1 to 0.5 us: the trapezoidal rule in the elliptic variable in which `du/R` is constant (geometric convergence, the faster the farther apart the points are), or, far from the
/// diagonal of a high harmonic, a sum over spherical waves with positive terms.
///
/// ```
/// use fredholm::collocation::solve_adaptive;
/// use fredholm::kernel::Yukawa;
///
/// let kernel = Yukawa::new(1.0, 10.0, 0)?;
/// let found = solve_adaptive(&kernel, 1.0, |_| 1.0, 1e-11)?;
/// // Two product-integration methods, 13 digits.
/// assert!((found.solution.evaluate(1.0, 1.0) - 0.788_958_303_411_381).abs() < 1e-11);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Yukawa {
    interval: Interval,
    screening: f64,
    harmonic: Harmonic,
    diagonal: Diagonal,
}

impl Yukawa {
    /// The kernel on a disk of radius `radius` with the screening `chi` and the harmonic `m`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `1e-100 <= radius <= 1e100`, `screening >= 0`, `screening * radius <= 1e5`, and `harmonic <= 200`.
    pub fn new(radius: f64, screening: f64, harmonic: u32) -> Result<Self, Error> {
        let refuse =
            |name, value, requirement| Err(Error::InvalidParameter { name, value, requirement });
        if !RADII.contains(&radius) {
            return refuse(
                "radius",
                radius,
                "between 1e-100 and 1e100, so that its square is a number",
            );
        }
        if !(screening >= 0.0 && screening.is_finite()) {
            return refuse(
                "screening",
                screening,
                "finite and not negative: the potential must decay",
            );
        }
        if screening * radius > LARGEST_DECAY {
            let requirement = "at most 1e5: beyond, the kernel is 2 pi/(chi s) times the delta function to five digits";
            return refuse("screening * radius", screening * radius, requirement);
        }
        if harmonic > HIGHEST_HARMONIC {
            return refuse("harmonic", f64::from(harmonic), "at most 200");
        }
        let harmonic = Harmonic::new(harmonic);
        let diagonal = Diagonal::new(&harmonic, screening * radius);
        let interval = Interval::new(0.0, radius)?;
        Ok(Self { interval, screening, harmonic, diagonal })
    }

    /// `a`.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.interval.right()
    }

    /// `chi`.
    #[must_use]
    pub fn screening(&self) -> f64 {
        self.screening
    }

    /// `m`.
    #[must_use]
    pub fn harmonic(&self) -> u32 {
        self.harmonic.order()
    }

    /// The kernel at two different points; the circle is made where it is needed first.
    fn apart(&self, points: Points, circle: Option<&Circle>) -> f64 {
        if self.screening * points.distance > FADED {
            0.0
        } else if self.harmonic.serves(points) {
            match circle {
                Some(circle) => self.harmonic.integral(self.screening, points, circle),
                None => self.harmonic.integral(self.screening, points, &Circle::new(points)),
            }
        } else {
            waves::sum(self.harmonic.order(), self.screening, points)
        }
    }

    /// Keeps quotients by a point from overflowing: so near to the centre nothing has any mass.
    fn kept_away(&self, x: f64) -> f64 {
        x.max(INNERMOST * self.radius())
    }
}

impl Kernel for Yukawa {
    fn interval(&self) -> Interval {
        self.interval
    }

    fn singularity(&self) -> Singularity {
        Singularity::Logarithm
    }

    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        if distance > 0.0 {
            let Pair { value, factor } = self.pair(x, s, distance);
            return Split { factor, rest: value - factor * distance.ln() };
        }
        let x = self.kept_away(x);
        Split { factor: -2.0 / x, rest: self.diagonal.rest(self.screening, x) }
    }

    fn pair(&self, x: f64, s: f64, distance: f64) -> Pair {
        if distance.is_nan() || distance <= 0.0 {
            return Pair { value: f64::INFINITY, factor: -2.0 / self.kept_away(x) };
        }
        let points = Points::new(x, s, distance);
        let cutoff = self.harmonic.cutoff(self.screening, points);
        if cutoff == 0.0 {
            return Pair { value: self.apart(points, None), factor: 0.0 };
        }
        let circle = Circle::new(points);
        let factor = cutoff * self.harmonic.factor(self.screening, points, &circle);
        Pair { value: self.apart(points, Some(&circle)), factor }
    }

    fn measure(&self, s: f64) -> f64 {
        s
    }

    fn decay_length(&self) -> f64 {
        self.screening.recip()
    }

    /// *Measured* for the harmonics 0 and 2 and 12 digits: 60, 80, 135 nodes for 10, 40, 100 decay lengths in the radius.
    fn first_half_count(&self) -> f64 {
        40.0 + self.screening * self.radius()
    }

    fn mass_function(&self, x: f64) -> f64 {
        x.powi(self.harmonic() as i32)
    }

    fn value(&self, x: f64, s: f64) -> f64 {
        if x == s {
            return f64::INFINITY;
        }
        self.apart(Points::new(x, s, (x - s).abs()), None)
    }
}
