//! What is prescribed: one of each pair.

use serde::{Deserialize, Serialize};

use crate::Error;
use crate::error::{finite, require};
use crate::line_search::{positive, top};

/// Crests among samples of a base that are looked at closely: more than that are hardly alike.
const CRESTS: usize = 16;

/// The vertical half of the load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Vertical {
    /// Force `P` per unit length, positive into the body (N/m).
    Force(f64),
    /// Settlement `delta` in the gauge `ln(a/|x-s|)` (m).
    Settlement(f64),
}

impl Vertical {
    /// The force, where it is what is prescribed.
    pub(crate) fn force(self) -> Option<f64> {
        if let Self::Force(given) = self { Some(given) } else { None }
    }

    /// The settlement, where it is what is prescribed.
    pub(crate) fn settlement(self) -> Option<f64> {
        if let Self::Settlement(given) = self { Some(given) } else { None }
    }

    /// The same kind of load, with what these make of a force and of a settlement.
    pub(crate) fn mapped(
        self,
        force: impl FnOnce(f64) -> f64,
        settlement: impl FnOnce(f64) -> f64,
    ) -> Self {
        match self {
            Self::Force(given) => Self::Force(force(given)),
            Self::Settlement(given) => Self::Settlement(settlement(given)),
        }
    }
}

/// The rotational half of the load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Rotational {
    /// Moment `M = int x p dx` per unit length (N m/m).
    Moment(f64),
    /// Eccentricity `e` of the force, `M = P e` (m).
    Eccentricity(f64),
    /// Tilt `alpha` (rad); zero keeps the punch level, (5.1).
    Tilt(f64),
}

impl Rotational {
    /// The tilt, where it is what is prescribed.
    pub(crate) fn tilt(self) -> Option<f64> {
        if let Self::Tilt(given) = self { Some(given) } else { None }
    }

    /// What goes with every force where this goes with one: the tilt, or the eccentricity.
    pub(crate) fn standing(self, force: f64) -> Self {
        match self {
            Self::Moment(moment) if moment != 0.0 => Self::Eccentricity(moment / force),
            other => other,
        }
    }

    /// Name and value.
    pub(crate) fn named(self) -> (&'static str, f64) {
        match self {
            Self::Moment(value) => ("moment", value),
            Self::Eccentricity(value) => ("eccentricity", value),
            Self::Tilt(value) => ("tilt", value),
        }
    }
}

/// One of force and settlement, and one of moment, eccentricity and tilt.
///
/// Compression is positive, and a positive moment gives a negative tilt. Forces and moments are per unit length, under a circular punch those of the whole
/// punch; in a dimensionless problem all are numbers.
///
/// ```
/// use shtaerman::Load;
///
/// let central = Load::force(0.8e6)?;                           // N/m, without a moment
/// let eccentric = Load::force(0.8e6)?.with_moment(100.0)?;     // N m/m
/// let beside = Load::force(0.8e6)?.with_eccentricity(1e-4)?;   // m
/// let pressed = Load::settlement(2e-6)?.with_tilt(0.0)?;       // m, rad: the punch is kept level
/// assert!(Load::force(f64::NAN).is_err());
/// # Ok::<(), shtaerman::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Load {
    pub(crate) vertical: Vertical,
    pub(crate) rotational: Rotational,
}

impl Load {
    /// A force `P` without a moment: per unit length (N/m), under a circular punch that of the whole punch (N).
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless it is finite.
    pub fn force(force: f64) -> Result<Self, Error> {
        Self::new(Vertical::Force(force), Rotational::Moment(0.0))
    }

    /// A settlement `delta` (m) without a moment, in the gauge of the problem.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless it is finite.
    pub fn settlement(settlement: f64) -> Result<Self, Error> {
        Self::new(Vertical::Settlement(settlement), Rotational::Moment(0.0))
    }

    /// The same with a moment `M = int x p dx` (N m/m, under a circular punch N m).
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless it is finite.
    pub fn with_moment(self, moment: f64) -> Result<Self, Error> {
        Self::new(self.vertical, Rotational::Moment(moment))
    }

    /// The same with the force at an eccentricity `e` (m), `M = P e`.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless it is finite.
    pub fn with_eccentricity(self, eccentricity: f64) -> Result<Self, Error> {
        Self::new(self.vertical, Rotational::Eccentricity(eccentricity))
    }

    /// The same with a prescribed tilt `alpha` (rad) in place of a moment.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] unless it is finite.
    pub fn with_tilt(self, tilt: f64) -> Result<Self, Error> {
        Self::new(self.vertical, Rotational::Tilt(tilt))
    }

    /// Force or settlement.
    #[must_use]
    pub fn vertical(&self) -> Vertical {
        self.vertical
    }

    /// Moment, eccentricity or tilt.
    #[must_use]
    pub fn rotational(&self) -> Rotational {
        self.rotational
    }

    /// The load of two halves.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] with the field when a value is not finite.
    pub fn new(vertical: Vertical, rotational: Rotational) -> Result<Self, Error> {
        match vertical {
            Vertical::Force(value) => finite("force", value)?,
            Vertical::Settlement(value) => finite("settlement", value)?,
        };
        let (field, value) = rotational.named();
        finite(field, value)?;
        Ok(Self { vertical, rotational })
    }

    /// Force and moment; 0 where another quantity is prescribed.
    pub(crate) fn forces(&self) -> [f64; 2] {
        let moment = if let Rotational::Moment(moment) = self.rotational { moment } else { 0.0 };
        [self.vertical.force().unwrap_or(0.0), moment]
    }

    /// Settlement and tilt; 0 where another quantity is prescribed.
    pub(crate) fn displacements(&self) -> [f64; 2] {
        [self.vertical.settlement().unwrap_or(0.0), self.rotational.tilt().unwrap_or(0.0)]
    }

    /// Where the force acts, if the load says so.
    pub(crate) fn arm(&self) -> Option<f64> {
        match (self.vertical, self.rotational) {
            (Vertical::Force(force), Rotational::Moment(moment)) => Some(moment / force),
            (_, Rotational::Eccentricity(e)) => Some(e),
            _ => None,
        }
    }

    /// The longest interval of one of these about the line of the force, if there is one.
    pub(crate) fn about(&self, pieces: &[[f64; 2]]) -> Option<[f64; 2]> {
        let arm = self.arm()?;
        let reach = |[left, right]: &[f64; 2]| (arm - left).min(right - arm);
        let reach = pieces.iter().map(reach).find(|reach| *reach > 0.0)?;
        Some([arm - reach, arm + reach])
    }

    /// The load under which a profile less the line `height + slope xi` is met as the whole one is under this.
    pub(crate) fn lowered(self, height: f64, slope: f64) -> Self {
        let vertical = self.vertical.mapped(|force| force, |settlement| settlement - height);
        let rotational = match self.rotational {
            Rotational::Tilt(tilt) => Rotational::Tilt(tilt + slope),
            other => other,
        };
        Self { vertical, rotational }
    }

    /// Refuses what no pressure on a base of this half-width can balance: a force that lifts the punch off, and one that tips it over.
    pub(crate) fn check_balance(&self, half_width: f64) -> Result<(), Error> {
        if let Vertical::Force(force) = self.vertical {
            let requirement = "greater than zero in unilateral contact: a pull lifts the punch off";
            require(force > 0.0, "force", force, requirement)?;
            let limit = force * half_width;
            if let Rotational::Moment(value) = self.rotational
                && value.abs() >= limit
            {
                return Err(Error::TipsOver { field: "moment", value, limit, name: "P a" });
            }
        }
        match self.rotational {
            Rotational::Eccentricity(value) if value.abs() >= half_width => {
                let (field, name) = ("eccentricity", "a");
                Err(Error::TipsOver { field, value, limit: half_width, name })
            }
            _ => Ok(()),
        }
    }

    /// Whether prescribed displacements leave a base with these samples `(xi, f0)` clear of the body.
    pub(crate) fn keeps_clear<'s>(
        &self,
        mut samples: impl Iterator<Item = &'s (f64, f64)>,
    ) -> bool {
        let Vertical::Settlement(settlement) = self.vertical else { return false };
        match self.rotational {
            Rotational::Tilt(tilt) => samples.all(|(xi, height)| settlement - tilt * xi <= *height),
            Rotational::Moment(moment) if moment != 0.0 => false,
            Rotational::Moment(_) | Rotational::Eccentricity(_) => {
                // Without contact there is no moment: is there a tilt that keeps clear?
                let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
                for &(xi, height) in samples {
                    if xi > 0.0 {
                        least = least.max((settlement - height) / xi);
                    } else if xi < 0.0 {
                        most = most.min((height - settlement) / -xi);
                    } else if settlement > height {
                        return false;
                    }
                }
                least <= most
            }
        }
    }

    /// The same between the samples as well, which pass by contacts narrower than their distance; `height` is `f0` of the base, of these pieces.
    pub(crate) fn is_clear(
        &self,
        mut samples: Vec<(f64, f64)>,
        pieces: &[[f64; 2]],
        height: &dyn Fn(f64) -> f64,
    ) -> bool {
        let (Vertical::Settlement(settlement), Rotational::Tilt(tilt)) =
            (self.vertical, self.rotational)
        else {
            return self.keeps_clear(samples.iter());
        };
        crate::order::sort_by_number(&mut samples, |one| one.0);
        let depth = |xi: f64, height: f64| settlement - tilt * xi - height;
        let at = |k: usize| depth(samples[k].0, samples[k].1);
        let mut crests: Vec<usize> = (0..samples.len())
            .filter(|&k| {
                let beside = [k.saturating_sub(1), (k + 1).min(samples.len() - 1)];
                beside.into_iter().all(|other| at(other) <= at(k))
            })
            .collect();
        crests.sort_by(|one, two| at(*two).total_cmp(&at(*one)));
        crests.truncate(CRESTS);
        !crests.into_iter().any(|k| {
            let place = samples[k].0;
            let piece = pieces.iter().find(|[left, right]| *left <= place && place <= *right);
            let [from, to] = piece.copied().unwrap_or([place; 2]);
            let left = samples[k.saturating_sub(1)].0.max(from);
            let right = samples[(k + 1).min(samples.len() - 1)].0.min(to);
            at(k) > 0.0 || top(&|xi| depth(xi, height(xi)), left, right).1 > 0.0
        })
    }

    /// Where a base with these samples `(xi, f0)` from end to end of a piece would lie in the body as it is, if displacements are prescribed: Hertz's contact is `sqrt 2` times narrower.
    pub(crate) fn reached(
        &self,
        samples: &[(f64, f64)],
        height: &dyn Fn(f64) -> f64,
    ) -> Vec<[f64; 2]> {
        let (Vertical::Settlement(settlement), Rotational::Tilt(tilt)) =
            (self.vertical, self.rotational)
        else {
            return Vec::new();
        };
        let depth = |xi: f64, height: f64| settlement - tilt * xi - height;
        let mut points: Vec<(f64, f64)> =
            samples.iter().map(|(xi, height)| (*xi, depth(*xi, *height))).collect();
        let deepest =
            (0..points.len()).max_by(|one, two| points[*one].1.total_cmp(&points[*two].1));
        let at = |xi: f64| depth(xi, height(xi));
        if let Some(k) = deepest.filter(|k| points[*k].1 <= 0.0) {
            let (left, right) =
                (points[k.saturating_sub(1)].0, points[(k + 1).min(points.len() - 1)].0);
            points.push(top(&at, left, right));
            crate::order::sort_by_number(&mut points, |one| one.0);
        }
        positive(&|places: &[f64]| places.iter().map(|xi| at(*xi)).collect(), &points, 0.0)
    }
}
