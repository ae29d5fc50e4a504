//! The pressure on zones of a half-plane.

use std::f64::consts::PI;
use std::sync::Arc;

use fredholm::inversion::{Conjugate, Place};

use super::super::base::Base;
use super::super::equation::Detail;
use super::super::modes::Modes;
use super::super::pressure::{Density, Known, Pressure};
use super::coupling::{carried, counts, coupled};
use super::kernel::Kernel;
use super::part::Part;
use crate::Error;
use crate::contact::accuracy::ROUNDING;
use crate::contact::balance::{Balance, State};
use crate::contact::edges::EndState;
use crate::contact::stiffness::{Stiffness, require_solved};
use crate::contact::zones::Zone;
use crate::rounding::OF_A_VALUE;

/// Below so many roundings of the scale, and one for each that a rounding of the displacement counts, a density is none where slopes are known: at an end it is no better known.
const NONE: f64 = 8.0;

#[derive(Debug, Clone)]
pub(in super::super) struct Solved {
    pub(super) zones: Vec<Zone>,
    pub(super) parts: Vec<Part>,
    kernel: Kernel,
    pub(super) theta0: f64,
    /// From where a wave is seen.
    shift: f64,
    state: State,
    stiffness: Stiffness,
    /// The middle of the zones, and the modes of the densities that displace all of them by 1 and by `xi - middle`.
    middle: f64,
    flat: Arc<[Modes; 2]>,
}

impl Solved {
    pub(super) fn new(
        base: &Base,
        kernel: Kernel,
        zones: &[Zone],
        detail: Detail,
        resolved: Vec<(Arc<Conjugate>, f64)>,
    ) -> Result<Self, Error> {
        let counts = counts(kernel, zones, detail.digits)?;
        let heights: Modes = (resolved.iter().zip(&counts))
            .map(|((slope, _), count)| slope.coefficients(count - 1))
            .collect();
        // About the line of one of them: what is common to all changes settlement and tilt only.
        let (lean, reference) = (resolved[0].1, heights[0][0]);
        let middle = 0.5 * (zones[0].left() + zones[zones.len() - 1].right());
        let mut above = heights.clone();
        for ((above, zone), (_, mean)) in above.iter_mut().zip(zones).zip(&resolved) {
            above[0] -= reference + lean * (zone.middle() - zones[0].middle());
            above[1] += (mean - lean) * 0.5 * zone.length();
        }
        let [level, tilted, profile] = coupled(kernel, zones, &counts, middle, above)?;
        let theta0 = base.setting.theta0();
        let carried = |modes: &Modes| carried(zones, middle, modes).map(|part| part / theta0);
        let [force_settlement, coupling] = carried(&level);
        let [_, moment_tilt] = carried(&tilted);
        let stiffness = Stiffness { force_settlement, coupling, moment_tilt };
        let balance = Balance { centre: middle, stiffness, free: carried(&profile) };
        // The line of the reference, reference + lean (xi - c).
        let start = reference - lean * zones[0].middle();
        let [depth, tilt] = balance.depth_and_tilt(&base.load.lowered(start, lean));
        let state = balance.state_of(&base.load, [depth, tilt], [start + lean * middle, lean]);
        require_solved([depth, tilt], theta0)?;
        let parts = (resolved.into_iter().enumerate())
            .map(|(j, (slope, lean))| {
                let own = |k: usize| -(k as f64) * heights[j][k] / PI;
                let modes: Vec<f64> = (0..counts[j])
                    .map(|k| depth * level[j][k] - tilt * tilted[j][k] - profile[j][k])
                    .collect();
                Part::new(kernel, zones[j], (slope, lean), &modes, own)
            })
            .collect();
        let stiffness = balance.about_base();
        let (zones, flat) = (zones.to_vec(), Arc::new([level, tilted]));
        let shift = base.shift;
        Ok(Self { zones, parts, kernel, theta0, shift, state, stiffness, middle, flat })
    }

    /// The slopes that are equally spaced samples of known ones, with the mean slopes.
    pub(super) fn sampled_slopes(&self) -> impl Iterator<Item = Option<(Arc<Conjugate>, f64)>> {
        self.parts
            .iter()
            .map(|part| part.slope.is_sampled().then(|| (Arc::clone(&part.slope), part.lean)))
    }

    /// How much a rounding of the displacement counts in the pressure: near full contact of a row a pressure that is even moves next to nothing.
    fn condition(&self) -> f64 {
        self.theta0 * self.stiffness.force_settlement.abs()
    }

    /// Rounding of `G` of a zone, between its ends or at them.
    fn rounding(&self, zone: usize, of_slope: fn(&Conjugate) -> f64) -> f64 {
        let part = &self.parts[zone];
        part.rounding(self.condition(), of_slope(&part.slope))
    }
}

impl Pressure for Solved {
    fn zones(&self) -> Vec<Zone> {
        self.zones.clone()
    }

    fn state(&self) -> State {
        self.state
    }

    fn stiffness(&self) -> Stiffness {
        self.stiffness
    }

    fn force(&self, zone: usize) -> f64 {
        self.parts[zone].force()
    }

    fn at(&self, zone: usize, place: Place) -> f64 {
        let density = self.parts[zone].density_at(place);
        let root = (place.from_left * place.from_right).sqrt();
        if root == 0.0 {
            let side = usize::from(place.from_right == 0.0);
            let is_free = self.zones[zone].is_free(side);
            return if is_free || density == 0.0 { 0.0 } else { density * f64::INFINITY };
        }
        density / (self.theta0 * root)
    }

    fn regular(&self, zone: usize, place: Place) -> f64 {
        self.parts[zone].density_at(place) / (self.theta0 * self.parts[zone].half())
    }

    fn outside(&self, xi: f64) -> f64 {
        let remainder = self.kernel.remainder();
        let of = |part: &Part| {
            let images: f64 = self.kernel.shifts().map(|shift| part.beyond(xi - shift)).sum();
            images + remainder.map_or(0.0, |remainder| part.by_remainder(remainder, xi))
        };
        self.parts.iter().map(of).sum()
    }

    /// The pressure that an end gains when it moves is a solution without load, singular as `d^(-3/2)` with the intensity there as factor: where the intensities vanish there is none, so each depends on
    /// its own end only.
    fn end(&self, zone: usize, side: usize) -> EndState {
        let scale = self.parts.iter().map(Part::size).fold(f64::MIN_POSITIVE, f64::max);
        let rounding = f64::EPSILON * scale;
        let is_sampled = self.sampled_slopes().all(|slope| slope.is_some());
        let none = if is_sampled { (NONE + self.condition()) * rounding } else { 0.0 };
        let part = &self.parts[zone];
        let [fall, _] = part.fall(side, self.rounding(zone, Conjugate::end_error));
        let value = part.end_density(side);
        let rounding = self.rounding(zone, Conjugate::error) + rounding;
        EndState { value, rounding, scale, none, enough: none, step: value / fall }
    }

    fn density(&self, zone: usize, side: usize) -> Density {
        let part = &self.parts[zone];
        let [fall, fall_error] = part.fall(side, self.rounding(zone, Conjugate::end_error));
        Density { value: part.end_density(side), fall, fall_error }
    }

    fn intensity(&self, zone: usize, _side: usize) -> f64 {
        (PI / self.parts[zone].half()).sqrt() / self.theta0
    }

    fn known(&self, zone: usize, _largest: f64) -> Known {
        let part = &self.parts[zone];
        // Places are rounded, those of a wave also where they are moved, and logarithms of images, in all modes; the mean slope leaves its rounding.
        let places = self.zones[zone].rounding() + ROUNDING * self.shift.abs();
        let remote = places / (OF_A_VALUE * part.half()) + self.kernel.images(part.half());
        let taken = OF_A_VALUE * part.lean.abs() * part.half();
        let [own, of_end] = [part.slope.error(), part.slope.end_error()]
            .map(|slope| part.rounding(self.condition() + remote, slope + taken));
        Known { density: of_end, pressure: own / (self.theta0 * part.half()) }
    }

    /// Errors of `f_0`, with the rounding of the logarithms that are added up in it, and of `f_1` over half a zone.
    fn displacement_rounding(&self) -> [f64; 2] {
        let images = |part: &Part| part.force().abs() * self.kernel.images(part.half());
        let images = OF_A_VALUE * self.parts.iter().map(images).sum::<f64>();
        self.parts.iter().zip(&self.zones).fold([images, 0.0], |[level, turn], (part, zone)| {
            let own = part.slope.mode_error();
            let tilt = (own + images) / part.half();
            [level.max(images + own + tilt * zone.middle().abs()), turn.max(tilt)]
        })
    }

    fn change(&self, raise: f64, turn: f64) -> Self {
        let depth = raise + turn * self.middle;
        let ([level, tilted], flat) = (&*self.flat, Arc::new(Conjugate::flat()));
        let part = |(j, zone): (usize, &Zone)| {
            let modes: Vec<f64> =
                level[j].iter().zip(&tilted[j]).map(|(l, t)| depth * l + turn * t).collect();
            Part::new(self.kernel, *zone, (Arc::clone(&flat), 0.0), &modes, |_| 0.0)
        };
        let parts = self.zones.iter().enumerate().map(part).collect();
        Self { parts, ..self.clone() }
    }

    fn unknowns(&self) -> usize {
        self.parts.iter().map(Part::count).sum()
    }

    fn terms(&self) -> usize {
        self.unknowns() + self.parts.iter().map(|part| part.slope.terms()).sum::<usize>()
    }
}
