//! Smooth plane contact to first order, by its stiffness and the flat pressures on its zones.
//!
//! On a zone with half-length `b` a change of the load adds `G'(phi)` to the density `G(phi)`, that of a flat base. At a free end, where `G = G_2 phi^2/2`, the end
//! moves outwards by `2 b G'(0)/G_2`, so that `p0` stays finite.

use std::f64::consts::PI;

use super::coupling::{Coupled, couple};
use super::system::{Part, Solved, cosines};
use super::{SmoothContact, told};
use crate::Vertical;
use crate::contact::rates::{Linearised, Rates};
use crate::contact::solution::Solution;
use crate::contact::zones::Zone;

/// Angle at which the bend of the density is taken first; by twice and four times that, too. At half or twice 23 of 32 answers change, within what they state (survey).
const BESIDE: f64 = 0.01;

impl SmoothContact {
    /// The first-order change, the largest pressure being at `peak`.
    pub(super) fn first_order(&self, peak: f64) -> Option<Linearised> {
        let load = &self.problem().load;
        let (force, largest) = (self.state().force, self.pressure(peak));
        let Some(solved) = self.solved() else {
            // Full contact of a wave takes more force evenly.
            let unit = [0.0, 1.0, 0.0, 0.5, 0.0];
            let rates =
                told::rates(load, [force, largest], |[unit_force, _]| unit.map(|u| u * unit_force));
            let by_force = matches!(load.vertical, Vertical::Force(_));
            return by_force.then_some(Linearised { rates, errors: [[0.0; 5]; 3] });
        };
        let flat = Flat::new(solved)?;
        let place = self.local(solved, peak);
        let of = |prescribed: [f64; 2], order: usize| -> Rates {
            let [raise, turn] = solved.stiffness.displaced(load, prescribed);
            let force =
                solved.stiffness.force_settlement * raise + solved.stiffness.coupling * turn;
            let pressure =
                if largest.is_finite() { flat.pressure(place, raise, turn) } else { 0.0 };
            [raise, force, -turn, pressure, flat.widening(raise, turn, order)]
        };
        let rates =
            |order: usize| told::rates(load, [force, largest], |prescribed| of(prescribed, order));
        let (rates, coarse) = (rates(2), rates(1));
        let errors = std::array::from_fn(|input| {
            std::array::from_fn(|k| {
                let noise = if k == 4 { flat.noise() * rates[input][k].abs() } else { 0.0 };
                (rates[input][k] - coarse[input][k]).abs() + noise
            })
        });
        Some(Linearised { rates, errors })
    }
}

/// The densities of flat bases on the zones of a solution.
struct Flat<'s> {
    solved: &'s Solved,
    coupled: Coupled,
    middle: f64,
}

impl<'s> Flat<'s> {
    fn new(solved: &'s Solved) -> Option<Self> {
        let zones: Vec<Zone> = solved.parts.iter().map(|part| part.zone).collect();
        let counts: Vec<usize> = solved.parts.iter().map(Part::count).collect();
        let heights: Vec<Vec<f64>> = counts.iter().map(|count| vec![0.0; *count]).collect();
        let middle = 0.5 * (zones.first()?.left() + zones.last()?.right());
        let coupled = couple(solved.kernel, &zones, &counts, middle, &heights).ok()?;
        Some(Self { solved, coupled, middle })
    }

    /// `G'` of a zone for a settlement and a turn.
    fn density(&self, zone: usize, angle: f64, raise: f64, turn: f64) -> f64 {
        let Coupled { level, tilted, .. } = &self.coupled;
        let raise = raise + turn * self.middle;
        raise * cosines(&level[zone], angle) + turn * cosines(&tilted[zone], angle)
    }

    fn pressure(&self, xi: f64, raise: f64, turn: f64) -> f64 {
        let parts = &self.solved.parts;
        let Some(zone) = parts.iter().position(|part| part.zone.contains(xi)) else { return 0.0 };
        let place = parts[zone].place(xi);
        let root = (place.from_left * place.from_right).sqrt();
        self.density(zone, place.angle(), raise, turn) / (self.solved.theta0 * root)
    }

    /// How much wider the zones become; `order` extrapolations of the bend at their ends.
    fn widening(&self, raise: f64, turn: f64, order: usize) -> f64 {
        let mut sum = 0.0;
        for (j, part) in self.solved.parts.iter().enumerate() {
            for side in (0..2).filter(|side| part.zone.is_free(*side)) {
                let angle = if side == 0 { PI } else { 0.0 };
                let change = self.density(j, angle, raise, turn);
                sum += part.zone.length() * change / self.bend(j, angle, order);
            }
        }
        sum
    }

    /// Largest rounding of a bend at a free end relative to it.
    fn noise(&self) -> f64 {
        let of = |(j, part): (usize, &Part)| {
            let free = (0..2).filter(|side| part.zone.is_free(*side));
            let bends = free.map(|side| self.bend(j, if side == 0 { PI } else { 0.0 }, 2).abs());
            let rounding = 4.0 * self.solved.end_rounding(j) / (BESIDE * BESIDE);
            bends.fold(0.0, |most: f64, bend| most.max(rounding / bend))
        };
        self.solved.parts.iter().enumerate().map(of).fold(0.0, f64::max)
    }

    /// `d^2 G/dphi^2` at an end of a zone.
    fn bend(&self, zone: usize, end: f64, order: usize) -> f64 {
        let part = &self.solved.parts[zone];
        let at = |offset: f64| {
            2.0 * (part.density((end - offset).abs()) - part.density(end)) / (offset * offset)
        };
        let [one, two, four] = [1.0, 2.0, 4.0].map(|k| at(k * BESIDE));
        let (fine, coarse) = ((4.0 * one - two) / 3.0, (4.0 * two - four) / 3.0);
        if order > 1 { (16.0 * fine - coarse) / 15.0 } else { fine }
    }
}
