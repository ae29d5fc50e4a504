//! How far an answer is from the truth under a circular punch: an **estimate**, as potentials are computed at samples.

mod field;
mod kernel;
mod potential;
mod series;
#[cfg(test)]
mod shells;
#[cfg(test)]
mod tests;
mod tree;

use crate::allowance::unit;
use crate::bound::{known, scale};
use crate::effort::Effort;
use crate::grading::{Cuts, Limits, panels};
use crate::highest::highest;
use crate::layer;
use crate::modelled::Modelled;
use crate::open::free_ends;
use crate::panel::Panel;
use crate::problem::{Answer, Bound, Prescribed, Refusal};
use crate::profile::Profile;
use crate::sampled::{Seen, cover, largest, presses_about};
use field::{Part, Resampled};
use kernel::Harmonic;
use potential::Radial;

/// Unit of rounding.
const UNIT: f64 = 0.5 * f64::EPSILON;
/// A pressure is resampled to this many roundings of what it is computed from.
const RESOLVED: f64 = 4.0;
/// Roundings of a pressure in units of what is added up in it: those of the settlement, the tilt, the height and the displacement (theory).
const SUMMED: f64 = 4.0;

/// A contact under a circular punch of radius 1 without dimensions: `p^kappa + theta K p = delta - alpha x - f` where `p > 0`, with the kernel `(G/2) |x - y|^-(1+mu)` on the disk.
pub struct DiskProblem<'a> {
    /// `mu` of graded ground, 0 of a homogeneous one; less than 1.
    pub exponent: f64,
    /// `theta >= 0`.
    pub theta: f64,
    /// `kappa` of the layer, `0 < kappa <= 1`; 1 where moment or tilt are not zero.
    pub layer: f64,
    /// What the numbers given may be off by, relative to their sizes.
    pub scaled: f64,
    /// Whether the pressure may pull, and the whole base is in contact.
    pub is_bilateral: bool,
    /// The load, `M = pi int p_1 r^2 dr`.
    pub prescribed: Prescribed,
    /// The base by the distance from the axis.
    pub profile: &'a dyn Profile,
    /// Distances from the axis where the pressure bends.
    pub cuts: &'a [f64],
}

/// Estimates the errors of an answer, whose pressure is that along the diameter which tilts, its zones symmetric.
///
/// The kernel has the *complete maximum principle*: where `K g <= K h + c` on the support of `g >= 0`, `h, c >= 0`, it holds everywhere. So for two contacts whose right-hand sides differ
/// by `kappa` at most, `theta |K (p - q)| <= kappa`: where `p > q` both layers say so, hence everywhere; and forces grow with the settlement. With the largest residual `W` of the answer,
/// in the layer's law, `|d delta| <= W`, and `p^kappa - q^kappa = l - w~ - theta K (p - q)` with the line `l = d delta - x d alpha` is at most `|w~|` and the greater of `W + 2 |d alpha|` and `|l|`
/// at any place. In the mean square `||p - q|| <= ||w~||` as in the plane.
///
/// # Errors
/// [`Refusal`] where the residual was not resolved, or the answer is far from its load.
pub fn audit_disk(problem: &DiskProblem<'_>, answer: &Answer<'_>) -> Result<Bound, Refusal> {
    let scale = scale(problem.layer, answer)?;
    let residual = unit(problem.theta) * scale.powf(problem.layer);
    let base = Modelled::new(problem.profile, &[[0.0, 1.0]], problem.cuts, residual);
    let posed = DiskProblem { profile: &base, cuts: base.cuts(), ..*problem };
    let audit = Audit::new(&posed, problem.cuts, answer)?;
    audit.bound()
}

struct Audit<'a> {
    problem: &'a DiskProblem<'a>,
    answer: &'a Answer<'a>,
    /// Zones by the distance from the axis.
    zones: Vec<[f64; 2]>,
    /// Without angle, and with `cos(phi)` where the punch tilts.
    level: Part<'a>,
    lean: Option<Part<'a>>,
    /// What `q` was taken times and more to have its force and moment.
    panels: usize,
    effort: Effort,
}

/// What was seen of a part.
#[derive(Debug, Clone, Copy, Default)]
struct Norms {
    /// The largest `|w~|`, and that which counts for potentials.
    anywhere: f64,
    largest: f64,
    /// `int w~^2 r dr`.
    square: f64,
}

fn norms(seen: &[Seen], softest: f64, potential: impl Fn(f64) -> f64) -> Norms {
    Norms {
        anywhere: seen.iter().fold(0.0, |most, window| most.max(window.largest)),
        largest: largest(seen, softest, potential),
        square: seen.iter().map(|window| window.right * window.square).sum(),
    }
}

impl<'a> Audit<'a> {
    fn new(
        problem: &'a DiskProblem<'a>,
        joints: &[f64],
        answer: &'a Answer<'a>,
    ) -> Result<Self, Refusal> {
        let zones: Vec<[f64; 2]> = (answer.zones.iter())
            .filter(|[_, right]| *right > 0.0)
            .map(|[left, right]| [left.max(0.0), *right])
            .collect();
        let is_tilted = answer.tilt != 0.0 || answer.moment != 0.0;
        let pressure = answer.pressure;
        let level = move |r: f64| {
            if is_tilted { 0.5 * (pressure(r) + pressure(-r)) } else { pressure(r) }
        };
        let whole = scale(1.0, answer)?;
        let level = Self::resampled((problem, joints), (&zones, whole), 0, Box::new(level))?;
        let lean = if is_tilted {
            let lean = move |r: f64| 0.5 * (pressure(r) - pressure(-r));
            Some(Self::resampled((problem, joints), (&zones, whole), 1, Box::new(lean))?)
        } else {
            None
        };
        let panels = level.density.panels().len()
            + lean.as_ref().map_or(0, |lean| lean.density.panels().len());
        let level = Part::new(problem, level, [answer.settlement, 0.0], Some(problem.profile), 0.0);
        let rounding = SUMMED * UNIT * (answer.settlement.abs() + whole);
        let lean = lean.map(|lean| Part::new(problem, lean, [0.0, answer.tilt], None, rounding));
        let mut audit =
            Self { problem, answer, zones, level, lean, panels, effort: Effort::new(joints) };
        audit.settle();
        Ok(audit)
    }

    /// A harmonic of a pressure of the size `whole` on panels, with force or moment as prescribed.
    fn resampled(
        (problem, joints): (&DiskProblem<'_>, &[f64]),
        (zones, whole): (&[[f64; 2]], f64),
        order: u32,
        density: Box<dyn Fn(f64) -> f64 + Sync + 'a>,
    ) -> Result<Resampled<'a>, Refusal> {
        let Prescribed { force, moment } = problem.prescribed;
        let kernel = Harmonic::new(order, problem.exponent);
        let resampled = |density: &(dyn Fn(f64) -> f64 + Sync)| {
            Self::panels((problem, joints), (zones, whole), density)
        };
        let found = Radial::new(kernel.clone(), problem.exponent, resampled(&*density)?);
        let (given, own) = if order == 0 {
            (force, std::f64::consts::TAU * found.integral(|_| 1.0))
        } else {
            (moment, std::f64::consts::PI * found.integral(|r| r))
        };
        let Some(given) = given else {
            return Ok(Resampled::new(found, density, 0.0, own));
        };
        let change = given - own;
        // With both signs a multiple may be of nothing; what is added may pull.
        let is_added = problem.is_bilateral || order == 1;
        let largest = found.panels().iter().fold(0.0f64, |most, panel| most.max(panel.largest));
        let length = zones.iter().map(|[left, right]| right * right - left * left).sum::<f64>();
        let added = if !is_added {
            change / own
        } else if order == 0 {
            change / (std::f64::consts::PI * length)
        } else {
            4.0 * change / std::f64::consts::PI
        };
        // A moment may be as small as rounding of the pressure makes it.
        let most = if is_added { (0.5 * largest).max(SUMMED * UNIT * whole) } else { 0.5 };
        if added.is_nan() || added.abs() > most {
            return Err(Refusal::LoadNotMet);
        }
        let adjusted = move |r: f64| {
            let q = density(r);
            match (is_added, order) {
                (false, _) => q + added * q,
                (true, 0) => q + added,
                (true, _) => q + added * r,
            }
        };
        let panels = resampled(&adjusted)?;
        let found = Radial::new(kernel, problem.exponent, panels);
        let changed = added.abs() * if is_added { 1.0 } else { largest };
        Ok(Resampled::new(found, Box::new(adjusted), changed, given))
    }

    fn panels(
        (problem, joints): (&DiskProblem<'_>, &[f64]),
        (zones, whole): (&[[f64; 2]], f64),
        density: &(dyn Fn(f64) -> f64 + Sync),
    ) -> Result<Vec<Panel>, Refusal> {
        let own = (zones.iter())
            .flat_map(|[left, right]| {
                (0..32).map(move |i| left + (right - left) * (f64::from(i) + 0.5) / 32.0)
            })
            .map(|r| density(r).abs())
            .fold(0.0, f64::max);
        // A harmonic is no better known than the pressure that it was taken from.
        let scale = own.max(whole);
        if !scale.is_finite() || zones.is_empty() {
            return Err(Refusal::NoPressure);
        }
        if scale == 0.0 {
            return Err(Refusal::Vanishes);
        }
        let exact = RESOLVED * UNIT * (4.0 + problem.theta.sqrt()) * scale;
        let exact = |_: f64, _: f64| exact;
        let known = |left: f64, right: f64| {
            layer::pressure_error(problem.layer, scale, known(problem.profile, left, right))
        };
        let limits = Limits { exact: &exact, known: &known, scale, exponent: problem.exponent };
        let cuts = Cuts { all: joints, bent: problem.cuts };
        let found = panels(density, zones, &cuts, &limits, Effort::new(joints).panels)
            .ok_or(Refusal::TooManyPanels)?;
        if found.iter().all(|panel| panel.largest.is_finite()) {
            Ok(found)
        } else {
            Err(Refusal::NoPressure)
        }
    }

    /// The free ones of settlement and tilt that leave the least residual at the middles of the panels.
    fn settle(&mut self) {
        let Prescribed { force, moment } = self.problem.prescribed;
        if force.is_some() {
            let [sum, weight] = self.level.mean(&|_| 1.0);
            let shift = sum / weight;
            self.level.settlement += if shift.is_finite() { shift } else { 0.0 };
        }
        if let Some(lean) = self.lean.as_mut().filter(|_| moment.is_some()) {
            let [sum, weight] = lean.mean(&|r| r);
            let shift = sum / weight;
            lean.tilt -= if shift.is_finite() { shift } else { 0.0 };
        }
    }

    /// The distances from the axis that lie beside the zones.
    fn gaps(&self) -> Vec<[f64; 2]> {
        let mut from = 0.0;
        let mut gaps = Vec::new();
        for [left, right] in &self.zones {
            if *left > from {
                gaps.push([from, *left]);
            }
            from = *right;
        }
        if from < 1.0 {
            gaps.push([from, 1.0]);
        }
        gaps
    }

    fn bound(&self) -> Result<Bound, Refusal> {
        let (mut zones, mut gaps, mut leans) = (Vec::new(), Vec::new(), Vec::new());
        for panel in self.level.density.panels() {
            let whole = [panel.left, panel.right];
            cover(&self.level, whole, true, self.effort.looks, &mut zones)?;
        }
        for gap in self.gaps() {
            cover(&self.level, gap, false, self.effort.looks, &mut gaps)?;
        }
        if let Some(lean) = &self.lean {
            let most = self.effort.looks.saturating_sub(self.level.density.looks());
            for panel in lean.density.panels() {
                let whole = [panel.left, panel.right];
                cover(lean, whole, true, most, &mut leans)?;
            }
        }
        let windows = zones.len() + gaps.len() + leans.len();
        let problem = self.problem;
        let softest = layer::softest(problem.layer, self.highest());
        let potential = |width: f64| problem.theta * field::ring(width, problem.exponent);
        let seen = [&zones[..], &gaps[..]].concat();
        let level = norms(&seen, softest, potential);
        Ok(self.stated([level, norms(&leans, softest, potential)], &seen, &gaps, windows))
    }

    /// The largest pressure.
    fn highest(&self) -> f64 {
        self.level.density.panels().iter().fold(0.0, |most, panel| most.max(panel.largest))
    }

    /// What the pressure in a window may be off by where potential and displacements may be by this.
    fn pressure_error(&self, window: &Seen, off: f64) -> f64 {
        let pressure = |r: f64| (self.answer.pressure)(r).abs();
        let highest = pressure(window.left).max(pressure(window.right));
        layer::pressure_error(self.problem.layer, highest, window.largest + off)
    }

    fn stated(
        &self,
        [level, lean]: [Norms; 2],
        seen: &[Seen],
        gaps: &[Seen],
        windows: usize,
    ) -> Bound {
        use std::f64::consts::{PI, TAU};
        let (problem, answer) = (self.problem, self.answer);
        let Prescribed { force, moment } = problem.prescribed;
        let residual = (TAU * level.square + PI * lean.square).sqrt();
        let largest = level.largest + lean.largest;
        // Of the first harmonic alone: the line a x has the norm |a| sqrt(pi/4), and theta ||K e|| <= ||w|| sqrt(theta ||K||)/2.
        let strength = problem.theta * self.level.mass;
        let turned = (PI * lean.square).sqrt() * (2.0 + 0.5 * strength.sqrt());
        let tilted = if moment.is_some() { turned / (0.25 * PI).sqrt() } else { 0.0 };
        let settled = if force.is_some() { self.settled(level, residual) } else { 0.0 };
        let shift = settled + tilted;
        // In the layer's law, and of the pressure.
        let margin = (largest + 2.0 * tilted).max(shift);
        let off = seen.iter().map(|window| self.pressure_error(window, lean.anywhere + margin));
        let off = off.fold(0.0, f64::max);
        let resampled = self.level.changed() + self.lean.as_ref().map_or(0.0, Part::changed);
        let area: f64 = PI
            * ((self.zones.iter()).map(|[left, right]| right * right - left * left).sum::<f64>()
                + (gaps.iter().filter(|gap| gap.least <= margin))
                    .map(|gap| gap.right * gap.right - gap.left * gap.left)
                    .sum::<f64>());
        let mean_square = residual * layer::softest(problem.layer, self.highest() + off);
        let rounding = 64.0 * UNIT * TAU * self.level.density.integral(|_| 1.0).abs();
        let moved = (area.sqrt() * mean_square).min(area * off) + rounding;
        let [own_force, own_moment] =
            [self.level.total, self.lean.as_ref().map_or(0.0, |lean| lean.total)];
        let moment_off = if self.lean.is_some() {
            (0.25 * PI).sqrt() * (PI * lean.square).sqrt() + rounding
        } else {
            0.0
        };
        let unless = |given: bool, value: f64| if given { 0.0 } else { value };
        let settlement_off = (self.level.settlement - answer.settlement).abs();
        let tilt_off = self.lean.as_ref().map_or(0.0, |lean| (lean.tilt - answer.tilt).abs());
        Bound {
            mean_square,
            pressure: off + resampled,
            highest: self.lean.is_none().then(|| {
                let at_numbers = highest(self.level.density.panels(), off) + off + resampled;
                // Between numbers a narrow tip may be pressed by more.
                let high = (problem.cuts, self.highest());
                let about = |r: f64| self.level.density.evaluate(r);
                let about = presses_about(&self.level, high, about);
                let most = seen.iter().fold(about, |most, window| most.max(window.presses));
                at_numbers.max(layer::pressure(problem.layer, most + margin))
            }),
            settlement: unless(force.is_none(), settled + settlement_off),
            tilt: unless(moment.is_none(), tilted + tilt_off),
            force: unless(force.is_some(), moved + (answer.force - own_force).abs()),
            moment: unless(
                moment.is_some() || self.lean.is_none(),
                moment_off + (answer.moment - own_moment).abs(),
            ),
            ends: self.ends(gaps, [off + resampled, margin]),
            residual,
            panels: self.panels,
            windows,
        }
    }

    fn ends(&self, gaps: &[Seen], limits: [f64; 2]) -> Option<f64> {
        let ends = self.zones.iter().flat_map(|[left, right]| [[*left, *right], [*right, *left]]);
        let free: Vec<[f64; 2]> = ends.filter(|[end, _]| *end > 0.0 && *end < 1.0).collect();
        free_ends(&free, gaps, &|r| self.level.density.evaluate(r), limits)
    }

    /// What the settlement is off by: as much as the largest residual, or by the norm of a constant where the pressure is firm.
    fn settled(&self, level: Norms, residual: f64) -> f64 {
        let strength = self.problem.theta * self.level.mass;
        let missing = (self.problem.prescribed.force.unwrap_or(0.0) - self.level.total).abs()
            + 64.0 * UNIT * self.level.total.abs();
        let area: f64 = std::f64::consts::PI
            * self.zones.iter().map(|[left, right]| right * right - left * left).sum::<f64>();
        let of_load = missing * (1.0 + strength) / area;
        if self.problem.layer < 1.0 {
            return level.largest + of_load;
        }
        let norm = residual * (2.0 + 0.5 * strength.sqrt());
        let by_norm = self.level.firm(norm, self.problem.is_bilateral);
        level.largest.min(by_norm) + of_load
    }
}
