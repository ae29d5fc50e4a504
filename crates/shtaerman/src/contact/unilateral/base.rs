//! The base of the punch as unilateral contact sees it: where it bends and where an edge of the contact can rest.

use crate::{Error, Load, Problem, Rotational, Vertical};

/// Samples that show the ups and downs of a profile, at least and at most.
const SAMPLES: usize = 512;
const MOST_SAMPLES: usize = 8192;
/// Offset at which both sides of a breakpoint are compared, and the share of the profile's range that makes a jump.
const BESIDE: f64 = 1e-9;
const JUMP: f64 = 1e-6;

/// A dimensionless problem with what is worth knowing about its profile.
pub(super) struct Base<'p> {
    pub(super) problem: &'p Problem,
    pub(super) load: Load,
    pub(super) theta: f64,
    /// Breakpoints of the profile.
    pub(super) breaks: Vec<f64>,
    /// Where a left or a right edge of the contact can rest under pressure: the edges of the punch, and steps of the profile.
    walls: [Vec<f64>; 2],
    /// Samples `(xi, f0)` from edge to edge.
    pub(super) samples: Vec<(f64, f64)>,
}

impl<'p> Base<'p> {
    pub(super) fn new(problem: &'p Problem) -> Result<Self, Error> {
        let wanted = 4 * problem.profile().measured_points().unwrap_or(0);
        let count = wanted.clamp(SAMPLES, MOST_SAMPLES);
        let samples: Vec<(f64, f64)> = (0..=count)
            .map(|i| {
                let xi = 2.0 * i as f64 / count as f64 - 1.0;
                problem.finite_profile(xi).map(|height| (xi, height))
            })
            .collect::<Result<_, _>>()?;
        let breaks = problem.breaks();
        let mut base = Self {
            problem,
            load: problem.dimensionless_load(),
            theta: problem.frame().theta0(),
            breaks,
            walls: [vec![-1.0], vec![1.0]],
            samples,
        };
        base.find_steps();
        base.require_load()?;
        Ok(base)
    }

    /// `f0(xi)`.
    pub(super) fn height(&self, xi: f64) -> f64 {
        self.problem.dimensionless_profile(xi)
    }

    /// Simpson's mean of the profile over a cell, from inside it.
    pub(super) fn mean_height(&self, centre: f64, half: f64) -> f64 {
        let inside = half * (1.0 - 1e-6);
        let at = |side: f64| self.height(centre + side * inside);
        (at(-1.0) + 4.0 * at(0.0) + at(1.0)) / 6.0
    }

    /// The next wall for a left (0) or right (1) edge outwards of a place inside the contact.
    pub(super) fn wall(&self, side: usize, inside: f64) -> f64 {
        let walls = self.walls[side].iter().copied();
        if side == 0 {
            walls.filter(|wall| *wall <= inside).fold(-1.0, f64::max)
        } else {
            walls.filter(|wall| *wall >= inside).fold(1.0, f64::min)
        }
    }

    /// Number of cells that show every valley of the profile.
    pub(super) fn cells(&self) -> usize {
        const FEWEST: usize = 48;
        const MOST: usize = 1024;
        const A_VALLEY: usize = 12;
        let valleys = self.samples.windows(3).filter(|w| w[1].1 <= w[0].1 && w[1].1 < w[2].1);
        (A_VALLEY * (valleys.count() + 1)).clamp(FEWEST, MOST)
    }

    /// Difference of the largest and the smallest height.
    fn range(&self) -> f64 {
        let heights = || self.samples.iter().map(|sample| sample.1);
        heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min)
    }

    fn find_steps(&mut self) {
        let threshold = JUMP * self.range();
        for &place in &self.breaks {
            let rise = self.height(place + BESIDE) - self.height(place - BESIDE);
            if rise > threshold {
                self.walls[1].push(place);
            } else if rise < -threshold {
                self.walls[0].push(place);
            }
        }
    }

    /// Refuses what no contact can balance.
    fn require_load(&self) -> Result<(), Error> {
        let half_width = self.problem.frame().half_width();
        let given = self.problem.load();
        if let (Vertical::Force(force), Vertical::Force(value)) =
            (self.load.vertical, given.vertical)
        {
            let requirement = "greater than zero in unilateral contact: a pull lifts the punch off";
            crate::error::require(force > 0.0, "force", value, requirement)?;
            if let (Rotational::Moment(moment), Rotational::Moment(value)) =
                (self.load.rotational, given.rotational)
                && moment.abs() >= force
            {
                let limit = half_width * self.problem_force();
                return Err(Error::TipsOver { field: "moment", value, limit, name: "P a" });
            }
        }
        match (self.load.rotational, given.rotational) {
            (Rotational::Eccentricity(e), Rotational::Eccentricity(value)) if e.abs() >= 1.0 => {
                Err(Error::TipsOver { field: "eccentricity", value, limit: half_width, name: "a" })
            }
            // A force may act there under a tilt that does not keep clear.
            (Rotational::Eccentricity(e), _) if e != 0.0 => Ok(()),
            _ if self.touches_nowhere() => Err(Error::NoContact),
            _ => Ok(()),
        }
    }

    fn problem_force(&self) -> f64 {
        match self.problem.load().vertical {
            Vertical::Force(force) => force,
            Vertical::Settlement(_) => 0.0,
        }
    }

    /// Whether the prescribed displacements leave the base clear of the body.
    pub(super) fn touches_nowhere(&self) -> bool {
        let Vertical::Settlement(settlement) = self.load.vertical else { return false };
        match self.load.rotational {
            Rotational::Tilt(tilt) => {
                self.samples.iter().all(|(xi, height)| settlement - tilt * xi <= *height)
            }
            Rotational::Moment(moment) if moment != 0.0 => false,
            Rotational::Moment(_) | Rotational::Eccentricity(_) => {
                // Without contact there is no moment: is there a tilt that keeps clear?
                let (mut least, mut most) = (f64::NEG_INFINITY, f64::INFINITY);
                for &(xi, height) in &self.samples {
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
}
