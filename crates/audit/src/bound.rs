//! From the residual of an answer to the errors of its parts.

use crate::Profile;
use crate::density::{Density, Panel};
use crate::kernel::Kernel;
use crate::residual::{Bounded, Residual, blur};
use crate::sample::{negative_part, panels};
use crate::shape::{Shape, restored};

/// Most panels and windows: beyond them an answer is not audited.
pub(crate) const MOST_PANELS: usize = 60_000;
pub(crate) const MOST_WINDOWS: usize = 200_000;
/// A pressure is resampled to this many roundings of what it is computed from.
const RESOLVED: f64 = 4.0;
/// Unit of rounding.
const UNIT: f64 = 0.5 * f64::EPSILON;
/// Roundings of an integral of the pressure in units of the integral of its size: compensated sums of products of three computed factors.
const SUMMED: f64 = 48.0;
/// Places of a panel where the answer is compared with its resampled pressure, between the nodes of both.
const COMPARED: [f64; 2] = [0.271_828, 0.914_159];

/// What the load prescribes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prescribed {
    /// The force `P`; else the settlement is as the answer has it.
    pub force: Option<f64>,
    /// The moment `M`; else the tilt is as the answer has it.
    pub moment: Option<f64>,
}

/// A contact problem without dimensions.
pub struct Problem<'a> {
    /// The kernel.
    pub kernel: Kernel,
    /// `theta >= 0`.
    pub theta: f64,
    /// What the numbers given for `theta`, the profile and the load may be off by, relative to their sizes: they were scaled.
    pub scaled: f64,
    /// The intervals of the base, from left to right, within `[-1, 1]`.
    pub pieces: &'a [[f64; 2]],
    /// Whether the pressure may pull, and the whole base is in contact.
    pub is_bilateral: bool,
    /// The load.
    pub prescribed: Prescribed,
    /// The base.
    pub profile: &'a dyn Profile,
    /// Places where the pressure bends: panels are cut there. None needs to be known.
    pub cuts: &'a [f64],
}

/// An answer.
pub struct Answer<'a> {
    /// The zones of contact, from left to right.
    pub zones: &'a [[f64; 2]],
    /// The pressure at places of the zones.
    pub pressure: &'a dyn Fn(f64) -> f64,
    /// `delta`.
    pub settlement: f64,
    /// `alpha`.
    pub tilt: f64,
    /// `P`.
    pub force: f64,
    /// `M`.
    pub moment: f64,
}

/// Guaranteed bounds of the errors of an answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Of the pressure in the mean square, `||p - q||` in `L2` of the base.
    pub mean_square: f64,
    /// Of the pressure at any number of the machine on the base.
    pub pressure: f64,
    /// Of the settlement; 0 where it is prescribed.
    pub settlement: f64,
    /// Of the tilt; 0 where it is prescribed.
    pub tilt: f64,
    /// Of the force; 0 where it is prescribed.
    pub force: f64,
    /// Of the moment; 0 where it is prescribed.
    pub moment: f64,
    /// Of the free ends of the zones; none where the contact may have other zones, or no end is free.
    pub ends: Option<f64>,
    /// The norm of the residual.
    pub residual: f64,
    /// Panels of the resampled pressure.
    pub panels: usize,
    /// Windows on which the residual was bounded.
    pub windows: usize,
}

/// Why there is no bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Refusal {
    /// The pressure has no zone, or is not finite.
    NoPressure,
    /// The pressure needs more panels than are kept.
    TooManyPanels,
    /// The residual needs more windows than are kept; it was last looked at here.
    TooManyWindows {
        /// The place.
        at: f64,
    },
    /// The answer is far from the force or moment that is prescribed.
    LoadNotMet,
}

/// Bounds the errors of an answer.
///
/// # Errors
/// [`Refusal`] where no bound was found: nothing is then known of the answer.
pub fn audit(problem: &Problem<'_>, answer: &Answer<'_>) -> Result<Bound, Refusal> {
    let sampled = resample(problem, answer)?;
    let (sampled, shape) = restored(problem, &sampled)?;
    let density = Density::new(problem.kernel, sampled);
    let mut audit =
        Audit { problem, answer, density, shape, settlement: answer.settlement, tilt: answer.tilt };
    audit.settle();
    audit.bound()
}

/// Panels of the pressure on all zones.
pub(crate) fn resample(problem: &Problem<'_>, answer: &Answer<'_>) -> Result<Vec<Panel>, Refusal> {
    let mut scale = 0.0f64;
    for [left, right] in answer.zones {
        for i in 0..32 {
            let x = left + (right - left) * (f64::from(i) + 0.5) / 32.0;
            scale = scale.max((answer.pressure)(x).abs());
        }
    }
    if scale.is_nan() || scale <= 0.0 || scale.is_infinite() {
        return Err(Refusal::NoPressure);
    }
    let tolerance = RESOLVED * UNIT * (4.0 + problem.theta) * scale;
    let mut found = Vec::new();
    for zone in answer.zones {
        let is_done = panels(
            answer.pressure,
            *zone,
            problem.cuts,
            (tolerance, scale),
            MOST_PANELS,
            &mut found,
        );
        if !is_done {
            return Err(Refusal::TooManyPanels);
        }
    }
    let is_finite = found.iter().all(|panel| panel.largest.is_finite());
    if is_finite && !found.is_empty() { Ok(found) } else { Err(Refusal::NoPressure) }
}

/// Sums over windows.
#[derive(Debug, Clone, Copy, Default)]
struct Norms {
    /// `||w~||` squared, and `||w~||_1` in the zones, without what could not be resolved.
    square: f64,
    sum: f64,
    /// `||w~||_1`, `||w~||` squared of that, and the potential it can have.
    narrow_sum: f64,
    narrow_square: f64,
    narrow_potential: f64,
    /// The largest `|w~|` at numbers of the machine.
    largest: f64,
}

/// A bound of the potential of a density of size one on an interval of this width.
fn narrow_potential(width: f64, kernel: Kernel) -> f64 {
    let mu = kernel.singularity().exponent();
    if mu == 0.0 {
        width * (3.0 + width.ln().abs() + kernel.constant().abs())
    } else {
        4.0 * width.powf(1.0 - mu) / (1.0 - mu)
    }
}

pub(crate) struct Audit<'a> {
    pub(crate) problem: &'a Problem<'a>,
    pub(crate) answer: &'a Answer<'a>,
    pub(crate) density: Density,
    shape: Shape,
    /// Numbers for settlement and tilt: those prescribed, or any.
    settlement: f64,
    tilt: f64,
}

/// What is known of the distance between the true pressure and the resampled one.
#[derive(Debug, Clone, Copy)]
struct Distance {
    /// `||w~||`, of the density that is admissible to the last digit.
    residual: f64,
    /// `||p - q||`.
    mean_square: f64,
    /// What else the pressure at a place is off by, beside the free displacements.
    pressure: f64,
    /// `theta |K (p - q)|` at any place.
    potential: f64,
    /// `||w~||_1`.
    sum: f64,
}

/// Bounds of a line `d - a x`.
#[derive(Debug, Clone, Copy)]
struct Line {
    /// Of its value at the middle.
    level: f64,
    /// Of its slope.
    slope: f64,
    middle: f64,
}

impl Line {
    /// Of its values on `[-1, 1]`.
    fn largest(&self) -> f64 {
        self.level + self.slope * (1.0 + self.middle.abs())
    }

    fn at_origin(&self) -> f64 {
        self.level + self.slope * self.middle.abs()
    }
}

impl Audit<'_> {
    fn residual(&self) -> Residual<'_> {
        Residual {
            density: &self.density,
            profile: self.problem.profile,
            theta: self.problem.theta,
            settlement: self.settlement,
            tilt: self.tilt,
            scaled: self.problem.scaled,
        }
    }

    /// The free ones of settlement and tilt that leave the least residual at the middles of the panels.
    fn settle(&mut self) {
        let Prescribed { force, moment } = self.problem.prescribed;
        let residual = self.residual();
        let places: Vec<(f64, f64, f64)> = (self.density.panels.iter())
            .map(|panel| (panel.middle(), panel.right - panel.left))
            .map(|(x, weight)| (x, weight, residual.at(x).0))
            .collect();
        let sum = |u: &dyn Fn(f64, f64) -> f64| -> f64 {
            places.iter().map(|(x, weight, w)| weight * u(*x, *w)).sum()
        };
        let length = sum(&|_, _| 1.0);
        let middle = if force.is_some() { sum(&|x, _| x) / length } else { 0.0 };
        // w falls by d - a x.
        let d = if force.is_some() { sum(&|_, w| w) / length } else { 0.0 };
        let square = sum(&|x, _| (x - middle) * (x - middle));
        let a = if moment.is_some() && square > 0.0 {
            -sum(&|x, w| (w - d) * (x - middle)) / square
        } else {
            0.0
        };
        if d.is_finite() && a.is_finite() {
            self.settlement += d + a * middle;
            self.tilt += a;
        }
    }

    /// The intervals of the base outside the zones.
    fn gaps(&self) -> Vec<[f64; 2]> {
        let mut gaps = Vec::new();
        for [left, right] in self.problem.pieces {
            let mut from = *left;
            for zone in self.answer.zones {
                if zone[1] < *left || zone[0] > *right {
                    continue;
                }
                if zone[0] > from {
                    gaps.push([from, zone[0]]);
                }
                from = from.max(zone[1]);
            }
            if from < *right {
                gaps.push([from, *right]);
            }
        }
        gaps
    }

    fn bound(&self) -> Result<Bound, Refusal> {
        let residual = self.residual();
        let (mut zones, mut gaps) = (Vec::new(), Vec::new());
        let refused =
            |error: crate::residual::TooManyWindows| Refusal::TooManyWindows { at: error.at };
        for zone in self.answer.zones {
            residual.in_zone(*zone, MOST_WINDOWS, &mut zones).map_err(refused)?;
        }
        for gap in self.gaps() {
            residual.beside_zones(gap, MOST_WINDOWS, &mut gaps).map_err(refused)?;
        }
        let distance = self.distance(&zones, &gaps);
        let line = self.displacements(&distance);
        let free = line.largest();
        let kernel = self.problem.kernel;
        let twice = if kernel.doubles(self.problem.theta) { 2.0 } else { 1.0 };
        let pressure = twice * (distance.pressure + free) + distance.potential;
        let contact = self.contact_length(&gaps, distance.potential + free).sqrt();
        let moved = contact * distance.mean_square + distance.sum;
        let Prescribed { force, moment } = self.problem.prescribed;
        let off = |given: bool, value: f64| if given { 0.0 } else { value };
        Ok(Bound {
            mean_square: distance.mean_square,
            pressure: pressure + self.resampled(),
            settlement: off(
                force.is_none(),
                line.at_origin() + (self.settlement - self.answer.settlement).abs(),
            ),
            tilt: off(moment.is_none(), line.slope + (self.tilt - self.answer.tilt).abs()),
            force: off(force.is_some(), moved + (self.answer.force - self.shape.force).abs()),
            moment: off(moment.is_some(), moved + (self.answer.moment - self.shape.moment).abs()),
            ends: self.ends(&gaps, pressure, distance.potential + free),
            residual: distance.residual,
            panels: self.density.panels.len(),
            windows: zones.len() + gaps.len(),
        })
    }

    /// How far the answer's pressure is from the resampled one between the nodes.
    fn resampled(&self) -> f64 {
        let places = self.density.panels.iter().flat_map(|panel| {
            COMPARED.map(|t| (panel, panel.left + t * (panel.right - panel.left)))
        });
        places
            .map(|(panel, x)| (panel.evaluate(x) - (self.answer.pressure)(x)).abs())
            .fold(0.0, f64::max)
    }

    fn norms(&self, windows: impl Iterator<Item = Bounded>) -> Norms {
        let mut norms = Norms::default();
        for window in windows {
            let width = window.right - window.left;
            norms.largest = norms.largest.max(window.at_numbers);
            if window.is_narrow {
                norms.narrow_sum += window.largest * width;
                norms.narrow_square += window.largest * window.largest * width;
                norms.narrow_potential +=
                    window.largest * narrow_potential(width, self.problem.kernel);
            } else {
                norms.square += window.norm * window.norm;
                norms.sum += window.largest * width;
            }
        }
        norms
    }

    /// Jumps of the base lie within some roundings of where windows have them.
    fn add_jumps(&self, norms: &mut Norms) {
        for cut in self.problem.cuts.iter().filter(|cut| self.density.panel_at(**cut).is_some()) {
            let blur = blur(cut.abs());
            let [low, high] = self.problem.profile.range([cut - blur, cut + blur]);
            let (jump, width) = (high - low, 2.0 * blur);
            norms.narrow_sum += jump * width;
            norms.narrow_square += jump * jump * width;
            norms.narrow_potential += jump * narrow_potential(width, self.problem.kernel);
        }
    }

    /// The theorem, with what keeps the density from being admissible to the last digit.
    fn distance(&self, zones: &[Bounded], gaps: &[Bounded]) -> Distance {
        let (kernel, theta) = (self.problem.kernel, self.problem.theta);
        let mut norms = self.norms(zones.iter().chain(gaps).copied());
        self.add_jumps(&mut norms);
        // What is negative is cut off.
        let [mut square, mut sum, mut depth] = [0.0f64; 3];
        if !self.problem.is_bilateral {
            for panel in &self.density.panels {
                let [a, b, c] = negative_part(panel);
                (square, sum, depth) = (square + a, sum + b, depth.max(c));
            }
        }
        let negative = square.sqrt();
        // On windows that could not be resolved the density is what its own potential makes it: a change by w~ there.
        let absorbed = theta
            * (norms.narrow_sum * kernel.row_norm())
                .min(norms.narrow_square.sqrt() * kernel.mass());
        // Force and moment are met by a last correction.
        let shape = &self.shape;
        let rounding = SUMMED * UNIT * shape.total + norms.narrow_sum + sum;
        let defect = |prescribed: Option<f64>, found: f64| {
            prescribed.map_or(0.0, |value| {
                (value - found).abs() + rounding + self.problem.scaled * value.abs()
            })
        };
        let Prescribed { force, moment } = self.problem.prescribed;
        let [off, turned] = [defect(force, shape.force), defect(moment, shape.moment)];
        let level = off / shape.mass;
        let lean = (turned + off * shape.mean.abs()) / shape.square;
        let corrected = level * shape.norm + lean * shape.leaning;
        let largest = if self.problem.is_bilateral { 1.0 } else { self.density.largest() };
        let highest = largest * (level + lean * shape.reach);
        let strength = 1.0 + theta * kernel.mass();
        let residual = norms.square.sqrt() + absorbed + strength * (negative + corrected);
        let beside = theta * (norms.narrow_potential + kernel.mass() * (depth + highest));
        Distance {
            residual,
            mean_square: residual + negative + corrected,
            pressure: norms.largest + depth + highest,
            potential: kernel.smoothing(theta) * residual + beside,
            sum: norms.sum + norms.narrow_sum + sum,
        }
    }

    /// Length of the zones and of what may be in contact beside them.
    fn contact_length(&self, gaps: &[Bounded], margin: f64) -> f64 {
        let open = gaps.iter().filter(|window| window.least <= margin);
        self.shape.length + open.map(|window| window.right - window.left).sum::<f64>()
    }

    /// Bounds of what the free ones of settlement and tilt are off by: `[|d - a m|, |a|]` about a place `m` of the zones, and `m`.
    ///
    /// Where both pressures are positive `d - a x = e + w + theta K e`: a line whose norm there is known. Where `p` vanishes, `e = -q`, so that this can only be where `q` is small,
    /// but for a set of the measure `(||e||/t)^2` on `q >= t`.
    fn displacements(&self, distance: &Distance) -> Line {
        let Prescribed { force, moment } = self.problem.prescribed;
        let mut line = Line { level: 0.0, slope: 0.0, middle: 0.0 };
        if force.is_none() && moment.is_none() {
            return line;
        }
        let (theta, mass) = (self.problem.theta, self.problem.kernel.mass());
        let norm = distance.mean_square + distance.residual * (1.0 + 0.5 * (theta * mass).sqrt());
        let [length, middle, square, lost] = self.firm_part(distance.mean_square);
        // A line about the origin where only one of both is free.
        let about = if force.is_some() && moment.is_some() { middle } else { 0.0 };
        let square = square + length * (middle - about) * (middle - about);
        let reach = (middle - about).abs() + self.shape.reach + (middle - self.shape.mean).abs();
        let share = match (force.is_some(), moment.is_some()) {
            (true, true) => 2.0 * lost * (1.0 / length + reach * reach / square),
            (true, false) => lost / length,
            _ => lost * reach * reach / square,
        };
        let norm = if share < 0.5 { norm / (1.0 - share).sqrt() } else { f64::INFINITY };
        line.middle = about;
        line.level = if force.is_some() { norm / length.sqrt() } else { 0.0 };
        line.slope = if moment.is_some() { norm / square.sqrt() } else { 0.0 };
        line
    }

    /// Length, middle and second moment about it of panels where the pressure is firmly positive, and the measure on them where the true one may vanish.
    fn firm_part(&self, off: f64) -> [f64; 4] {
        let whole: f64 = self.shape.length;
        let mut least =
            if self.problem.is_bilateral { -f64::INFINITY } else { self.density.largest() };
        loop {
            least *= 0.25;
            let panels =
                || self.density.panels.iter().filter(|p| p.coefficients[0] - p.swing >= least);
            let sum = |u: &dyn Fn(&Panel) -> f64| -> f64 { panels().map(u).sum() };
            let length = sum(&|p| p.right - p.left);
            let is_last = least < f64::MIN_POSITIVE;
            if length < 0.5 * whole && !is_last {
                continue;
            }
            let middle = sum(&|p| (p.right - p.left) * p.middle()) / length;
            let square = sum(&|p| {
                let half = p.half();
                2.0 * half * ((p.middle() - middle).powi(2) + half * half / 3.0)
            });
            // The pressure that has force and moment to the last digit is at least half as large.
            let lost = if self.problem.is_bilateral { 0.0 } else { (2.0 * off / least).powi(2) };
            return [length, middle, square, lost];
        }
    }
}
