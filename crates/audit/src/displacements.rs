//! What the free ones of settlement and tilt are off by.

use crate::bound::Audit;
use crate::distance::Distance;
use crate::norms::Reach;
use crate::panel::Panel;
use crate::problem::Prescribed;

/// Levels of the pressure, each a quarter of the one before, above which it is looked whether it is firmly positive.
const LEVELS: usize = 40;
/// Share of its zone, at most, on which the pressure is not firmly positive, for the sharper bound.
const MOSTLY: f64 = 0.05;

/// Bounds of a line `d - a x`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line {
    /// Of its value at the middle.
    pub(crate) level: f64,
    /// Of its slope.
    pub(crate) slope: f64,
    middle: f64,
}

impl Line {
    /// Of its values on `[-1, 1]`.
    pub(crate) fn largest(&self) -> f64 {
        self.level + self.slope * (1.0 + self.middle.abs())
    }

    /// Of how much its values on `[-1, 1]` differ.
    pub(crate) fn swing(&self) -> f64 {
        2.0 * self.slope
    }

    pub(crate) fn at_origin(&self) -> f64 {
        self.level + self.slope * self.middle.abs()
    }
}

/// Panels on which the pressure is firmly positive.
#[derive(Debug, Clone, Copy)]
struct Firm {
    length: f64,
    middle: f64,
    /// The second moment about the middle.
    square: f64,
    /// The measure on them where the true pressure may vanish.
    lost: f64,
}

impl Audit<'_> {
    /// Bounds of what the free ones of settlement and tilt are off by: `[|d - a m|, |a|]` about a place `m` of the zones, and `m`.
    ///
    /// Where both pressures are positive `d - a x = e + w + theta K e`: a line whose norm there is known. Where `p` vanishes, `e = -q`, so that this can only be where `q` is small,
    /// but for a set of the measure `(||e||/t)^2` on `q >= t`.
    pub(crate) fn displacements(&self, distance: &Distance, reach: &Reach) -> Line {
        let Prescribed { force, moment } = self.problem.prescribed;
        let mut line = Line { level: 0.0, slope: 0.0, middle: 0.0 };
        if force.is_none() && moment.is_none() {
            return line;
        }
        let norm = distance.mean_square + distance.residual * (1.0 + reach.moved());
        let Firm { length, middle, square, lost } = self.firm(distance, 0.5);
        // A line about the origin where only one of both is free.
        let about = if force.is_some() && moment.is_some() { middle } else { 0.0 };
        let square = square + length * (middle - about) * (middle - about);
        let width = (middle - about).abs() + self.shape.reach + (middle - self.shape.mean).abs();
        let share = match (force.is_some(), moment.is_some()) {
            (true, true) => 2.0 * lost * (1.0 / length + width * width / square),
            (true, false) => lost / length,
            _ => lost * width * width / square,
        };
        let norm = if share < 0.5 { norm / (1.0 - share).sqrt() } else { f64::INFINITY };
        line.middle = about;
        line.level = if force.is_some() { norm / length.sqrt() } else { 0.0 };
        line.slope = if moment.is_some() { norm / square.sqrt() } else { 0.0 };
        if moment.is_none() {
            // Forces grow with the right-hand side: a settlement alone moves by no more than that.
            line.level = line.level.min(distance.principle);
        }
        match self.tested(distance, reach) {
            Some(other) if other.largest() < line.largest() => other,
            _ => line,
        }
    }

    /// The same by integrals over one zone `T` of the half-length `h` about `c`: `d |T| = int e + int w + theta <K 1, e>` with `<1, e> = 0`.
    ///
    /// In the last term `1` may be less any multiple of a density whose potential is constant, and `theta <K u, e> <= sqrt(theta <K u, u>) sqrt(theta <K e, e>)`, where the energy of `e` is
    /// `theta <K e, e> <= ||w~||^2/4`. The slope in the same way with `x - c`, of `<x, e> = 0`. What is missing of the zone, by the measure `v`, adds to each.
    fn tested(&self, distance: &Distance, reach: &Reach) -> Option<Line> {
        let Prescribed { moment, .. } = self.problem.prescribed;
        let [level, slope] = reach.rest_energies()?;
        let (h, whole) = (reach.half, 2.0 * reach.half);
        let firm = self.firm(distance, 1.0 - MOSTLY);
        let missing = (whole - firm.length).max(0.0) + firm.lost;
        if missing > MOSTLY * whole {
            return None;
        }
        let (w, e) = (distance.residual, distance.mean_square);
        let rest = missing.sqrt() * (e + 0.5 * w * reach.strength().sqrt());
        let level = (w * (whole.sqrt() + 0.5 * level.sqrt()) + rest) / (whole - missing);
        if moment.is_none() {
            return Some(Line { level, slope: 0.0, middle: 0.0 });
        }
        let square = 2.0 / 3.0 * h.powi(3);
        let slope =
            (w * (square.sqrt() + 0.5 * slope.sqrt()) + h * rest) / (square - h * h * missing);
        // Each also has a part of the other on what is missing.
        let share = h * missing / (whole - missing);
        let other = h * missing / (square - h * h * missing);
        let both = 1.0 - share * other;
        Some(Line {
            level: (level + share * slope) / both,
            slope: (slope + other * level) / both,
            middle: reach.middle,
        })
    }

    /// Panels on which the pressure is firmly positive: of those that make up this share of the zones the ones with the least measure left out or lost.
    fn firm(&self, distance: &Distance, share: f64) -> Firm {
        let off = distance.mean_square;
        if self.problem.is_bilateral {
            let firm = self.firm_above(f64::NEG_INFINITY, 0.0);
            return Firm { lost: distance.changed_width, ..firm };
        }
        let whole = self.shape.length;
        let levels = (1..=LEVELS as i32).map(|n| self.density.largest() * 0.25f64.powi(n));
        // Where the density was changed nothing is known of it.
        let found = levels.map(|least| {
            let firm = self.firm_above(least, off);
            Firm { lost: firm.lost + distance.changed_width, ..firm }
        });
        let missing = |firm: &Firm| {
            let is_enough = firm.length >= share * whole;
            (!is_enough, whole - firm.length + firm.lost)
        };
        found
            .min_by(|a, b| {
                let (a, b) = (missing(a), missing(b));
                a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
            })
            .unwrap_or(Firm { length: 0.0, middle: 0.0, square: 0.0, lost: 0.0 })
    }

    fn firm_above(&self, least: f64, off: f64) -> Firm {
        let panels = || self.density.panels.iter().filter(|p| p.coefficients[0] - p.swing >= least);
        let sum = |u: &dyn Fn(&Panel) -> f64| -> f64 { panels().map(u).sum() };
        let length = sum(&|p| p.right - p.left);
        let middle = sum(&|p| (p.right - p.left) * p.middle()) / length;
        let square = sum(&|p| {
            let half = p.half();
            2.0 * half * ((p.middle() - middle).powi(2) + half * half / 3.0)
        });
        // The pressure that has force and moment to the last digit is at least half as large.
        let lost = (2.0 * off / least).powi(2);
        Firm { length, middle, square, lost }
    }
}
