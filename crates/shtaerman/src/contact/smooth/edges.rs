//! The free ends of the zones, where the corner intensity vanishes.
//!
//! The pressure that an end gains when it moves is a solution without load, singular as `d^(-3/2)` with the intensity there as factor. Where the
//! intensities vanish there is none, so each depends on its own end only: `dG/d(end) = G'/(2 b)` outwards, `G'` the slope of
//! `G` over `(xi - c)/b` at the end, and Newton's method needs no more than that.

use std::f64::consts::PI;

use super::Detail;
use super::free_ends::{self, FreeEnds, STRIDE, step};
use super::problem::Base;
use super::system::Solved;
use super::zones::Zone;
use crate::Error;

/// Below this share of the scale a density is none, where slopes are known: at an end it is no better known.
const NONE: f64 = 8.0 * f64::EPSILON;
/// Angles at which the slope of the density is taken.
const BESIDE: f64 = 0.06;
/// The same times the number of modes: beside a close neighbour the density changes as fast as these do.
const BESIDE_OF_MODES: f64 = 10.0;

impl FreeEnds for Solved {
    fn modes(&self) -> usize {
        self.modes()
    }

    fn panels(&self) -> usize {
        self.panels()
    }

    fn carried(&self, zone: usize) -> f64 {
        self.parts[zone].force()
    }

    fn density_at(&self, zone: usize, side: usize) -> f64 {
        self.end_density(zone, side)
    }

    fn floor(&self, zone: usize) -> f64 {
        self.rounding(zone)
    }

    fn scale(&self) -> f64 {
        self.density_scale()
    }

    fn none(&self) -> f64 {
        if self.is_sampled() { NONE } else { 0.0 }
    }
}

/// Moves the free ends until the intensity vanishes there.
pub(super) fn settle(base: &Base<'_>, start: &[Zone], detail: Detail) -> Result<Solved, Error> {
    let solve = |zones: &[Zone]| Solved::new(base, zones, detail);
    let outward =
        |solved: &Solved, j, side| step(solved.end_density(j, side), slope(solved, j, side));
    let next =
        |solved: &Solved, zones: &[Zone]| moved(base, zones, |j, side| outward(solved, j, side));
    free_ends::settle(start, &base.work, solve, next)
}

/// Estimated error of the free ends of a zone, in `xi`.
pub(super) fn end_error(solved: &Solved, j: usize, density_error: f64) -> f64 {
    let zone = solved.parts[j].zone;
    (0..2).filter(|&side| zone.is_free[side]).fold(0.0, |most: f64, side| {
        let density = solved.end_density(j, side).abs() + density_error;
        most.max((density / slope(solved, j, side)).abs() * zone.length())
    })
}

/// `dG/dy` outwards at an end of a zone, `y = (xi - c)/b`.
fn slope(solved: &Solved, j: usize, side: usize) -> f64 {
    let part = &solved.parts[j];
    let at = |offset: f64| part.density(if side == 0 { PI - offset } else { offset });
    free_ends::slope(at, BESIDE.min(BESIDE_OF_MODES / part.count() as f64))
}

/// The zones after steps that neither empty a zone nor jump over a gap; `outward` is that of a zone and side in lengths of the zone.
pub(super) fn moved(
    base: &Base<'_>,
    zones: &[Zone],
    outward: impl Fn(usize, usize) -> f64,
) -> Vec<Zone> {
    let target = |j: usize, side: usize, gap: Option<[f64; 2]>| {
        let (at, length) = (zones[j].ends[side], zones[j].length());
        let gap = gap.map_or(f64::INFINITY, |[from, to]| to - from);
        // Beside a narrow gap densities change within it.
        let (back, room) = (STRIDE * length.min(gap), 0.5 * gap);
        let step = (outward(j, side) * length).clamp(-back, room.min(length));
        if side == 0 { at - step } else { at + step }
    };
    free_ends::moved(zones, |side, inside| base.wall(side, inside), target, |_| {})
}
