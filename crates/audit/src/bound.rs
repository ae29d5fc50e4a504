//! From the residual of an answer to the errors of its parts.

use std::cell::Cell;

use crate::allowance::{allowance, unit};
use crate::density::Density;
use crate::displacements::Line;
use crate::distance::{Distance, Windows};
use crate::effort::Effort;
use crate::grading::{Cuts, Limits, panels};
use crate::ground::Raised;
use crate::highest::highest;
use crate::layer;
use crate::modelled::Modelled;
use crate::norms::Reach;
use crate::panel::Panel;
use crate::problem::{Answer, Bound, Prescribed, Problem, Refusal};
use crate::processors::each;
use crate::profile::Profile;
use crate::residual::{Bounded, Residual};
use crate::sample::{compared, halves};
use crate::shape::{Shape, restored};

/// A pressure is resampled to this share of what is allowed.
const RESOLVED: f64 = 0.3;
/// Places of an interval where it is looked at how well heights are known.
const KNOWN: [f64; 2] = [0.317, 0.718];
/// Places of a zone where the size of the pressure is looked at.
const SAMPLES: u32 = 32;
/// Free displacements are found from panels that are not shorter than this share of the longest.
const WEIGHTY: f64 = 1e-2;
/// A pressure in a bent layer is resolved as if its peaks were at most so many times its mean. Under a parabola on a firm body `(1 - x^2)^(1/kappa)` is 3.7 times its mean for `kappa = 0.1`; beside
/// steps it is more by orders.
const PEAKED: f64 = 8.0;
/// A bound above this share of the pressure is looked into: a single window beside the zones with so much of the residual is told.
const NO_SMALL_SHARE: f64 = 1e-2;
const MOST_OF_IT: f64 = 0.3;
/// Panels that are looked at together, in half a millisecond or more: far longer than a thread is begun in.
const TOGETHER: usize = 256;
/// Places of that window where penetration is looked for, in shares of it.
const SHARES: [f64; 5] = [0.5, 0.25, 0.75, 0.0, 1.0];

/// Bounds the errors of an answer.
///
/// # Errors
/// [`Refusal`] where no bound was found: nothing is then known of the answer.
pub fn audit(problem: &Problem<'_>, answer: &Answer<'_>) -> Result<Bound, Refusal> {
    audit_on(problem, answer, |panels| panels)
}

/// The same on panels half as long: a second bound from other numbers, with which the first can be compared.
///
/// # Errors
/// Those of [`audit`].
pub fn audit_on_halved_panels(
    problem: &Problem<'_>,
    answer: &Answer<'_>,
) -> Result<Bound, Refusal> {
    audit_on(problem, answer, |panels| {
        panels.iter().flat_map(|panel| halves(answer.pressure, panel)).collect()
    })
}

/// The audit on panels that are made of those of the resampled pressure.
fn audit_on(
    problem: &Problem<'_>,
    answer: &Answer<'_>,
    changed: impl Fn(Vec<Panel>) -> Vec<Panel>,
) -> Result<Bound, Refusal> {
    let scale = scale(1.0, answer)?;
    let base = modelled(problem, scale);
    let posed = Problem { profile: &base, cuts: base.cuts(), ..*problem };
    let effort = Effort::new(problem.cuts);
    let panels = resample(&posed, (problem.cuts, &effort), (1.0, scale), answer)?;
    bound(&posed, answer, &changed(panels), &effort)
}

/// The base of a problem by polynomials, for a layer in which a pressure of this size gives as much.
pub(crate) fn modelled<'a>(problem: &Problem<'a>, scale: f64) -> Modelled<'a> {
    Modelled::new(problem.profile, problem.pieces, problem.cuts, scale * unit(problem.theta))
}

fn bound(
    problem: &Problem<'_>,
    answer: &Answer<'_>,
    sampled: &[Panel],
    effort: &Effort,
) -> Result<Bound, Refusal> {
    let (sampled, shape) = restored(problem, sampled)?;
    let density = Density::new(problem.kernel, sampled);
    let raised = (problem.ground)
        .map(|ground| Raised::new(problem.profile, ground, problem.theta, &density));
    let profile = raised.as_ref().map_or(problem.profile, |raised| raised as &dyn Profile);
    let (settlement, tilt) = (answer.settlement, answer.tilt);
    let mut audit = Audit { problem, profile, answer, density, shape, settlement, tilt };
    audit.settle();
    audit.bound(effort)
}

/// The size of the pressure of an answer in a layer `p^kappa`.
pub(crate) fn scale(kappa: f64, answer: &Answer<'_>) -> Result<f64, Refusal> {
    let places = answer.zones.iter().flat_map(|[left, right]| {
        (0..=SAMPLES).map(move |i| left + (right - left) * f64::from(i) / f64::from(SAMPLES))
    });
    let sizes: Vec<f64> = places.map(|x| (answer.pressure)(x).abs()).collect();
    let mut scale = sizes.iter().fold(0.0f64, |most, size| most.max(*size));
    if kappa < 1.0 {
        // Peaks of a bent layer say little of its potential, which has to be known to what the layer gives.
        scale = scale.min(PEAKED * sizes.iter().sum::<f64>() / sizes.len() as f64);
    }
    if sizes.iter().all(|size| *size == 0.0) && !sizes.is_empty() {
        return Err(Refusal::Vanishes);
    }
    let is_known = !scale.is_nan() && scale > 0.0 && scale.is_finite();
    is_known.then_some(scale).ok_or(Refusal::NoPressure)
}

/// Panels of the pressure on all zones, of this size, in a layer `p^kappa`; `joints` are places where they are cut, whether the base is smooth there or not.
pub(crate) fn resample(
    problem: &Problem<'_>,
    (joints, effort): (&[f64], &Effort),
    (kappa, scale): (f64, f64),
    answer: &Answer<'_>,
) -> Result<Vec<Panel>, Refusal> {
    let exact = |left: f64, right: f64| RESOLVED * scale * allowance(problem.theta, right - left);
    let known = |left: f64, right: f64| {
        layer::pressure_error(kappa, scale, known(problem.profile, left, right))
    };
    let exponent = problem.kernel.singularity().exponent();
    let limits = Limits { exact: &exact, known: &known, scale, exponent };
    let cuts = Cuts { all: joints, bent: problem.cuts };
    let found = panels(answer.pressure, answer.zones, &cuts, &limits, effort.panels)
        .ok_or(Refusal::TooManyPanels)?;
    let is_finite = found.iter().all(|panel| panel.largest.is_finite());
    if is_finite && !found.is_empty() { Ok(found) } else { Err(Refusal::NoPressure) }
}

/// To what heights in an interval are known, beside a place where the profile jumps: what is finer in the pressure is rounding of the profile's.
pub(crate) fn known(profile: &dyn Profile, left: f64, right: f64) -> f64 {
    let width = |share: f64| {
        let [below, above] = profile.height(left + share * (right - left));
        0.5 * (above - below)
    };
    let [one, two] = KNOWN.map(width);
    let least = one.min(two);
    if least.is_finite() { least } else { 0.0 }
}

pub(crate) struct Audit<'a> {
    pub(crate) problem: &'a Problem<'a>,
    /// The base, with what ground adds to it beside its kernel's singular part.
    pub(crate) profile: &'a dyn Profile,
    pub(crate) answer: &'a Answer<'a>,
    pub(crate) density: Density,
    pub(crate) shape: Shape,
    /// Numbers for settlement and tilt: those prescribed, or any.
    pub(crate) settlement: f64,
    pub(crate) tilt: f64,
}

/// What is known of the errors.
struct Errors {
    distance: Distance,
    line: Line,
    doubles: bool,
}

impl Errors {
    /// Of the pressure at a place, beside what its own potential leaves to it.
    fn place(&self) -> f64 {
        self.distance.pressure + self.line.largest()
    }

    /// `d - a x - theta K (p - q)` by the principle for potentials: the line counts by how much it changes, or by itself where it has one sign with the residual.
    fn principle(&self) -> f64 {
        (self.distance.principle + self.line.swing()).max(self.line.largest())
    }

    /// Of what the residual is off by outside the zones.
    fn margin(&self) -> f64 {
        let left = if self.doubles { self.place() } else { 0.0 };
        let by_norm = left + self.distance.potential + self.line.largest();
        by_norm.min(self.principle())
    }

    fn pressure(&self) -> f64 {
        let twice = if self.doubles { 2.0 } else { 1.0 };
        let by_norm = twice * self.place() + self.distance.potential;
        by_norm.min(self.distance.pressure + self.principle())
    }
}

impl Audit<'_> {
    pub(crate) fn residual(&self) -> Residual<'_> {
        Residual {
            density: &self.density,
            pressure: self.answer.pressure,
            profile: self.profile,
            cuts: self.problem.cuts,
            theta: self.problem.theta,
            settlement: self.settlement,
            tilt: self.tilt,
            scaled: self.problem.scaled,
            free: [
                self.problem.prescribed.force.is_some(),
                self.problem.prescribed.moment.is_some(),
            ],
            noise: Cell::new(0.0),
            before: Cell::new(f64::INFINITY),
            ends: Cell::new([(f64::NAN, false); 2]),
            looks: Cell::new(0),
        }
    }

    /// The free ones of settlement and tilt that leave the least residual at the middles of the panels.
    fn settle(&mut self) {
        let Prescribed { force, moment } = self.problem.prescribed;
        let widest = self.density.panels.iter().fold(0.0f64, |most, panel| most.max(panel.half()));
        let of_panel = |panel: &Panel| {
            let (x, weight) = (panel.middle(), panel.right - panel.left);
            (panel.half() >= WEIGHTY * widest).then(|| (x, weight, self.residual().at(x).0))
        };
        let of_part = |part: &[Panel]| part.iter().filter_map(of_panel).collect::<Vec<_>>();
        let places = each(&self.density.panels, TOGETHER, of_part).concat();
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
    pub(crate) fn gaps(&self) -> Vec<[f64; 2]> {
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

    fn bound(&self, effort: &Effort) -> Result<Bound, Refusal> {
        let [mut zones, mut gaps] = self.covered(effort.looks)?;
        let wide = zones.iter().chain(&gaps).filter(|window| !window.is_narrow);
        let others = wide.fold(0.0f64, |most, window| most.max(window.at_numbers));
        self.residual().look_closer(zones.iter_mut().chain(&mut gaps), others);
        let windows = Windows { zones: &zones, gaps: &gaps };
        // First with all of the base, then with what of it may be in contact.
        let whole = self.hull(&windows, f64::INFINITY);
        let found = self.errors(&windows, whole);
        let near = self.hull(&windows, found.margin());
        let found = if near[1] - near[0] < whole[1] - whole[0] {
            self.errors(&windows, near)
        } else {
            found
        };
        match self.penetration(&windows, &found) {
            Some(at) => Err(Refusal::Penetrates { at }),
            None => Ok(self.stated(&windows, &found)),
        }
    }

    /// Where the base penetrates, in the window where it may do so most, if that makes the bound what it is and no small one.
    fn penetration(&self, windows: &Windows<'_>, found: &Errors) -> Option<f64> {
        let is_small = found.pressure() <= NO_SMALL_SHARE * self.density.largest();
        let worst = windows.gaps.iter().max_by(|a, b| a.norm.total_cmp(&b.norm))?;
        let is_cause = worst.norm >= MOST_OF_IT * found.distance.residual;
        if is_small || !is_cause {
            return None;
        }
        // Where a formula leaves open on which side of a jump places lie, nothing is known to penetrate.
        let residual = self.residual();
        let penetrates = |x: &f64| {
            let (w, error) = residual.at(*x);
            w + error < 0.0
        };
        let length = worst.right - worst.left;
        let places = SHARES.map(|share| worst.left + share * length);
        places.into_iter().find(penetrates)
    }

    /// The interval of the zones and of the windows beside them where the residual is at most `margin`.
    fn hull(&self, windows: &Windows<'_>, margin: f64) -> [f64; 2] {
        let zones = self.answer.zones.iter().copied();
        let open = windows.open(margin).map(|window| [window.left, window.right]);
        zones
            .chain(open)
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[first, last], [left, right]| {
                [first.min(left), last.max(right)]
            })
    }

    /// All errors, where the difference from the truth lives in an interval.
    fn errors(&self, windows: &Windows<'_>, interval: [f64; 2]) -> Errors {
        let is_neutral = self.problem.prescribed.force.is_some();
        let reach = Reach::new(self.problem.kernel, self.problem.theta, interval, is_neutral);
        let distance = self.distance(windows, &reach);
        let line = self.displacements(&distance, &reach);
        Errors { distance, line, doubles: reach.doubles() }
    }

    fn stated(&self, windows: &Windows<'_>, found: &Errors) -> Bound {
        let Errors { distance, line, .. } = found;
        let (margin, pressure) = (found.margin(), found.pressure());
        let open: f64 = windows.open(margin).map(|window| window.right - window.left).sum();
        // What was changed on windows that were not resolved is in the sum.
        let moved = (self.shape.length + open).sqrt() * distance.mean_square + distance.sum;
        let Prescribed { force, moment } = self.problem.prescribed;
        let off = |given: bool, value: f64| if given { 0.0 } else { value };
        // Settlement and tilt also take up what a last correction and the scaling do to them.
        let taken = distance.taken + self.problem.scaled;
        let settlement =
            (self.settlement - self.answer.settlement).abs() + taken * self.settlement.abs();
        let tilt = (self.tilt - self.answer.tilt).abs() + taken * self.tilt.abs();
        // Beside ends and jumps the panels may miss the pressure by more.
        let [resampled, narrowly] = self.resampled(windows.zones);
        let at_numbers = highest(&self.density.panels, pressure).max(narrowly);
        let at_numbers = at_numbers + pressure + resampled;
        // Between numbers a narrow tip may be pressed by more.
        let all = windows.zones.iter().chain(windows.gaps);
        let anywhere = self.residual().presses(all, at_numbers - margin) + margin;
        Bound {
            mean_square: distance.mean_square + distance.changed,
            pressure: pressure + resampled,
            highest: Some(anywhere.max(at_numbers)),
            settlement: off(force.is_none(), line.at_origin() + settlement),
            tilt: off(moment.is_none(), line.slope + tilt),
            force: off(force.is_some(), moved + (self.answer.force - self.shape.force).abs()),
            moment: off(moment.is_some(), moved + (self.answer.moment - self.shape.moment).abs()),
            ends: self.ends(windows.gaps, pressure, margin),
            residual: distance.residual,
            panels: self.density.panels.len(),
            windows: windows.zones.len() + windows.gaps.len(),
        }
    }

    /// How far the answer's pressure is from the resampled one between the nodes; in windows of some units of the machine that counts at each of its numbers already, and there its
    /// largest pressure is found.
    fn resampled(&self, zones: &[Bounded]) -> [f64; 2] {
        let none = [0.0, f64::NEG_INFINITY];
        let larger = |[off, pressure]: [f64; 2], [other, another]: [f64; 2]| {
            [off.max(other), pressure.max(another)]
        };
        let of_panel = |panel: &Panel| {
            let seen = compared(panel, self.answer.pressure).map(|(x, pressure, off)| {
                if is_narrow(zones, x) { [0.0, pressure] } else { [off, f64::NEG_INFINITY] }
            });
            seen.into_iter().fold(none, larger)
        };
        let of_part = |part: &[Panel]| part.iter().map(of_panel).fold(none, larger);
        each(&self.density.panels, TOGETHER, of_part).into_iter().fold(none, larger)
    }
}

fn is_narrow(windows: &[Bounded], x: f64) -> bool {
    let window = windows.get(windows.partition_point(|window| window.right < x));
    window.is_some_and(|window| window.is_narrow && window.left <= x)
}
