//! The answer of nearly smooth contact.

use super::companion::{Companions, Rough};
use super::errors;
use super::fit::beside_limit;
use super::pressure::{Marks, Pressure};
use crate::contact::accuracy::Accuracy;
use crate::contact::balance::State;
use crate::contact::linearised::Linearised;
use crate::contact::solution::Solution;
use crate::contact::solved::{Method, Stiffness};
use crate::contact::unilateral::Complementarity;
use crate::{ContactKind, Problem};

/// Places of a stretch: equally far from one another, and ever closer to its ends, down to a share of the width of the layers.
const EQUAL: usize = 24;
const CLOSER: f64 = 0.6;
const CLOSEST: f64 = 0.01;
/// Nodes of the solution as a multiple of the usual number.
const FINE: f64 = 1.15;

/// Zones, pressure, settlement, tilt, force and moment without dimensions: edges and layers by expansion about the smooth contact, the rest by the system solved on
/// these zones.
#[derive(Debug, Clone)]
pub(super) struct NearlySmooth {
    pub(super) pressure: Pressure,
    zones: Vec<[f64; 2]>,
    is_level: bool,
    accuracy: Accuracy,
    edge_error: f64,
    complementarity: Option<Complementarity>,
    largest: f64,
}

impl NearlySmooth {
    /// None where the zones are not in order.
    pub(super) fn new(problem: &Problem, companions: Companions) -> Option<Self> {
        let theta0 = problem.frame().theta0();
        let (marks, edge_error) = expanded_marks(&companions, theta0);
        if !marks.iter().flatten().collect::<Vec<_>>().is_sorted() {
            return None;
        }
        let zones: Vec<[f64; 2]> = marks.iter().map(|m| [m[0], m[m.len() - 1]]).collect();
        let contact = problem.solved_on(&companions.zones(&zones), FINE)?;
        let direct = Rough { problem: problem.clone(), contact };
        let others = [0, 1, 2].map(|i| marks_of(&companions, i));
        let complementarity = (problem.solver().contact == ContactKind::Unilateral).then(|| {
            let penetration = companions.smooth.complementarity().penetration;
            Complementarity { tension: 0.0, penetration }
        });
        let accuracy = Accuracy::unstated();
        let pressure = Pressure { companions, direct, theta0, marks, others };
        let is_level = problem.is_symmetric();
        let mut contact =
            Self { pressure, zones, is_level, accuracy, edge_error, complementarity, largest: 0.0 };
        let places = contact.places();
        let values: Vec<f64> =
            places.iter().map(|(zone, xi)| contact.in_zone(*zone, *xi)).collect();
        contact.largest = values.iter().fold(0.0, |most, p| most.max(p.abs()));
        contact.accuracy = errors::stated(&contact, problem, &places, &values)?;
        if let Some(left) = &mut contact.complementarity {
            left.tension = values.iter().fold(0.0f64, |most, p| most.max(-p)) / contact.largest;
        }
        let finite = values.iter().all(|p| p.is_finite());
        (finite && contact.accuracy.is_finite()).then_some(contact)
    }

    /// `p0` in a zone.
    fn in_zone(&self, zone: usize, xi: f64) -> f64 {
        let (ends, is_free) = (self.zones[zone], self.pressure.companions.is_free[zone]);
        let at_free_end = (0..2).any(|side| is_free[side] && xi == ends[side]);
        if at_free_end { 0.0 } else { self.pressure.at(zone, xi) }
    }

    /// The largest pressure.
    pub(super) fn largest(&self) -> f64 {
        self.largest
    }

    fn zone_of(&self, xi: f64) -> Option<usize> {
        self.zones.iter().position(|[left, right]| *left <= xi && xi <= *right)
    }

    /// Places of all zones that show extremes, from left to right.
    fn places(&self) -> Vec<(usize, f64)> {
        let closest = CLOSEST / self.pressure.theta0;
        let mut places = Vec::new();
        for marks in &self.pressure.marks {
            for pair in marks.windows(2) {
                let [left, right] = [pair[0], pair[1]];
                let length = right - left;
                places.extend([left, right]);
                places.extend((1..EQUAL).map(|i| left + length * i as f64 / EQUAL as f64));
                let mut distance = 0.5 * length;
                while distance > closest {
                    places.extend([left + distance, right - distance]);
                    distance *= CLOSER;
                }
            }
        }
        places.sort_by(f64::total_cmp);
        places.dedup();
        places.into_iter().filter_map(|xi| self.zone_of(xi).map(|zone| (zone, xi))).collect()
    }
}

/// Ends and kinks at this `theta0`, with the error of the ends.
fn expanded_marks(companions: &Companions, theta0: f64) -> (Marks, f64) {
    let mut marks = companions.marks.clone();
    let mut error = companions.smooth.edge_error0();
    let Some(rough) = &companions.rough else { return (marks, error) };
    for (j, marks) in marks.iter_mut().enumerate() {
        let last = marks.len() - 1;
        for (side, mark) in [(0, 0), (1, last)] {
            let values = [0, 1, 2].map(|i| rough[i].contact.zones()[j][side]);
            let fitted = beside_limit(marks[mark], values, companions.at, theta0);
            marks[mark] = fitted.value;
            if companions.is_free[j][side] {
                error = error.max(
                    fitted.error
                        + end_rounding(&rough[2], values[2], side, companions.at[2])
                            * companions.at[2]
                            / theta0,
                );
            }
        }
    }
    (marks, error)
}

/// Rounding of a free edge: that of the pressure over its slope in the layer.
fn end_rounding(rough: &Rough, edge: f64, side: usize, theta0: f64) -> f64 {
    let inward = if side == 0 { 1.0 / theta0 } else { -1.0 / theta0 };
    rough.contact.rounding() / (rough.pressure(edge + inward) * theta0)
}

/// Ends and kinks of a rough companion.
fn marks_of(companions: &Companions, i: usize) -> Marks {
    let Some(rough) = &companions.rough else { return Marks::new() };
    let of = |(marks, ends): (&Vec<f64>, [f64; 2])| {
        let mut marks = marks.clone();
        let last = marks.len() - 1;
        (marks[0], marks[last]) = (ends[0], ends[1]);
        marks
    };
    companions.marks.iter().zip(rough[i].contact.zones()).map(of).collect()
}

impl Solution for NearlySmooth {
    fn state(&self) -> State {
        let state = self.pressure.direct.contact.state();
        if self.is_level { State { tilt: 0.0, moment: 0.0, ..state } } else { state }
    }

    fn stiffness(&self) -> Stiffness {
        self.pressure.direct.contact.stiffness()
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        self.zones.clone()
    }

    fn pressure(&self, _: &Problem, xi: f64) -> f64 {
        match self.zone_of(xi) {
            Some(zone) => self.in_zone(zone, xi),
            None if xi.is_nan() => xi,
            None => 0.0,
        }
    }

    fn displacement(&self, xi: f64) -> f64 {
        self.pressure.direct.contact.displacement(xi)
    }

    fn sample(&self, problem: &Problem) -> (Vec<f64>, Vec<f64>) {
        let mut places: Vec<f64> = self.places().into_iter().map(|(_, xi)| xi).collect();
        places.extend([-1.0, 1.0]);
        let gaps = self.zones.windows(2).map(|pair| 0.5 * (pair[0][1] + pair[1][0]));
        places.extend(gaps);
        places.sort_by(f64::total_cmp);
        places.dedup();
        let pressures = places.iter().map(|&xi| self.pressure(problem, xi)).collect();
        (places, pressures)
    }

    /// The pressure is interpolated between solved nodes, and of `n` of them the kernel has no eigenvalue below about `1/n`.
    fn growth(&self) -> f64 {
        2.0 * (self.method().n as f64 / self.pressure.theta0).min(1.0)
    }

    fn method(&self) -> Method {
        Method { name: "expansion", n: self.pressure.direct.contact.node_count() }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        self.pressure
            .companions
            .is_free
            .iter()
            .flatten()
            .any(|is_free| *is_free)
            .then_some(self.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.complementarity
    }

    fn linearised(&self, problem: &Problem, peak: f64) -> Option<Linearised> {
        self.first_order(problem, peak)
    }

    fn size(&self) -> f64 {
        self.largest
    }
}
