//! The answer of nearly smooth contact.

use super::companion::Companions;
use super::fit::{Fitted, beside_limit};
use super::pressure::{Marks, Pressure};
use crate::contact::Contact;
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::smooth::SmoothContact;
use crate::contact::solution::Solution;
use crate::contact::solved::{Method, Stiffness};
use crate::contact::unilateral::Complementarity;
use crate::{ContactKind, Load, Problem, Rotational, Vertical};

/// Places of a stretch: equally far from one another, and ever closer to its ends, down to a share of the width of the layers.
const EQUAL: usize = 24;
const CLOSER: f64 = 0.6;
const CLOSEST: f64 = 0.01;
/// Rounding of settlement, tilt, force, moment and pressure relative to their size.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Zones, pressure, settlement, tilt, force and moment without dimensions, by expansion about the smooth contact.
#[derive(Debug, Clone)]
pub(super) struct NearlySmooth {
    pressure: Pressure,
    state: State,
    stiffness: Stiffness,
    zones: Vec<[f64; 2]>,
    is_free: Vec<[bool; 2]>,
    accuracy: Accuracy,
    edge_error: f64,
    complementarity: Option<Complementarity>,
    largest: f64,
}

impl NearlySmooth {
    /// None where the zones are not in order.
    pub(super) fn new(problem: &Problem, companions: Companions) -> Option<Self> {
        let theta0 = problem.frame().theta0();
        let fitted = |of: &dyn Fn(&Contact, f64) -> f64, limit: f64| {
            let values = [0, 1, 2, 3].map(|i| of(&companions.rough[i], companions.at[i]));
            beside_limit(limit, values, companions.at, theta0)
        };
        let (state, mut accuracy) = state(problem, &companions.smooth, &fitted);
        let stiffness = stiffness(&companions.smooth, theta0, &fitted);
        let is_free: Vec<[bool; 2]> =
            companions.smooth.zones().iter().map(|zone| zone.is_free).collect();
        let mut marks = companions.marks.clone();
        let mut edge_error = companions.smooth.edge_error0();
        for (j, marks) in marks.iter_mut().enumerate() {
            let last = marks.len() - 1;
            for (side, mark) in [(0, 0), (1, last)] {
                let Fitted { value, error } =
                    fitted(&|contact, _| contact.edges0()[j][side], marks[mark]);
                marks[mark] = value;
                edge_error = edge_error.max(error);
            }
        }
        let in_order = marks.iter().flatten().collect::<Vec<_>>().is_sorted();
        let zones: Vec<[f64; 2]> = marks.iter().map(|m| [m[0], m[m.len() - 1]]).collect();
        let others = [0, 1, 2, 3].map(|i| marks_of(&companions, i));
        let penetration = companions.smooth.complementarity().penetration;
        let pressure = Pressure { companions, theta0, marks, others };
        let mut contact = Self {
            pressure,
            state,
            stiffness,
            zones,
            is_free,
            accuracy,
            edge_error,
            complementarity: None,
            largest: 0.0,
        };
        let values: Vec<Fitted> =
            contact.places().into_iter().map(|(zone, xi)| contact.in_zone(zone, xi)).collect();
        let most = |of: fn(&Fitted) -> f64| values.iter().map(of).fold(0.0, f64::max);
        contact.largest = most(|fitted| fitted.value.abs());
        accuracy.pressure = most(|fitted| fitted.error)
            + contact.pressure.companions.smooth.accuracy().pressure
            + ROUNDING * contact.largest;
        contact.accuracy = accuracy;
        let tension = most(|fitted| -fitted.value) / contact.largest;
        if problem.solver().contact == ContactKind::Unilateral {
            contact.complementarity = Some(Complementarity { tension, penetration });
        }
        let finite = values.iter().all(|fitted| fitted.value.is_finite());
        (in_order && finite && contact.accuracy.is_finite()).then_some(contact)
    }

    /// `p0` in a zone, with its error.
    fn in_zone(&self, zone: usize, xi: f64) -> Fitted {
        let ends = self.zones[zone];
        let at_free_end = (0..2).any(|side| self.is_free[zone][side] && xi == ends[side]);
        if at_free_end { Fitted { value: 0.0, error: 0.0 } } else { self.pressure.at(zone, xi) }
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

/// Ends and kinks of a rough companion.
fn marks_of(companions: &Companions, i: usize) -> Marks {
    let edges = companions.rough[i].edges0();
    let of = |(marks, ends): (&Vec<f64>, [f64; 2])| {
        let mut marks = marks.clone();
        let last = marks.len() - 1;
        (marks[0], marks[last]) = (ends[0], ends[1]);
        marks
    };
    companions.marks.iter().zip(edges).map(of).collect()
}

type Fit<'f> = dyn Fn(&dyn Fn(&Contact, f64) -> f64, f64) -> Fitted + 'f;

/// What the load prescribes, and the rest; displacements are compared in units of the smooth problem.
fn state(problem: &Problem, smooth: &SmoothContact, fitted: &Fit<'_>) -> (State, Accuracy) {
    let theta0 = problem.frame().theta0();
    let Load { vertical, rotational } = problem.dimensionless_load();
    let settlement = fitted(&|contact, at| contact.settlement0() / at, smooth.settlement0());
    let tilt = fitted(&|contact, at| contact.tilt0() / at, smooth.tilt0());
    let force = fitted(&|contact, _| contact.force0(), smooth.force0());
    let moment = fitted(&|contact, _| contact.moment0(), smooth.moment0());
    let known = smooth.accuracy();
    let (state_force, force_error) = match vertical {
        Vertical::Force(prescribed) => (prescribed, 0.0),
        Vertical::Settlement(_) => (force.value, force.error + known.force),
    };
    let (state_settlement, settlement_error) = match vertical {
        Vertical::Settlement(prescribed) => (prescribed, 0.0),
        Vertical::Force(_) => {
            (settlement.value * theta0, (settlement.error + known.settlement) * theta0)
        }
    };
    let (state_tilt, tilt_error) = match rotational {
        Rotational::Tilt(prescribed) => (prescribed, 0.0),
        Rotational::Moment(_) | Rotational::Eccentricity(_) => {
            (tilt.value * theta0, (tilt.error + known.tilt) * theta0)
        }
    };
    let (state_moment, moment_error) = match rotational {
        Rotational::Moment(prescribed) => (prescribed, 0.0),
        Rotational::Eccentricity(e) => (e * state_force, e.abs() * force_error),
        Rotational::Tilt(_) => (moment.value, moment.error + known.moment),
    };
    let symmetric = problem.is_symmetric();
    let state = State {
        settlement: state_settlement,
        tilt: if symmetric { 0.0 } else { state_tilt },
        force: state_force,
        moment: if symmetric { 0.0 } else { state_moment },
    };
    let accuracy = Accuracy {
        kind: ErrorKind::Estimate,
        pressure: 0.0,
        settlement: settlement_error,
        tilt: tilt_error,
        force: force_error,
        moment: moment_error,
    };
    (state, accuracy)
}

fn stiffness(smooth: &SmoothContact, theta0: f64, fitted: &Fit<'_>) -> Stiffness {
    let limit = smooth.stiffness0();
    let of = |part: fn(&Stiffness) -> f64| {
        fitted(&|contact, at| part(&contact.stiffness0()) * at, part(&limit)).value / theta0
    };
    Stiffness {
        force_settlement: of(|stiffness| stiffness.force_settlement),
        coupling: of(|stiffness| stiffness.coupling),
        moment_tilt: of(|stiffness| stiffness.moment_tilt),
    }
}

impl Solution for NearlySmooth {
    fn state(&self) -> State {
        self.state
    }

    fn stiffness(&self) -> Stiffness {
        self.stiffness
    }

    fn zones(&self) -> Vec<[f64; 2]> {
        self.zones.clone()
    }

    fn pressure(&self, _: &Problem, xi: f64) -> f64 {
        match self.zone_of(xi) {
            Some(zone) => self.in_zone(zone, xi).value,
            None if xi.is_nan() => xi,
            None => 0.0,
        }
    }

    fn displacement(&self, xi: f64) -> f64 {
        let Companions { smooth, rough, at, .. } = &self.pressure.companions;
        let values = [0, 1, 2, 3].map(|i| rough[i].elastic_displacement0(xi) / at[i]);
        let limit = smooth.elastic_displacement0(xi);
        let theta0 = self.pressure.theta0;
        theta0 * beside_limit(limit, values, *at, theta0).value
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

    fn method(&self) -> Method {
        Method { name: "expansion", n: self.pressure.companions.rough[3].method().n }
    }

    fn accuracy(&self) -> Option<&Accuracy> {
        Some(&self.accuracy)
    }

    fn edge_error(&self) -> Option<f64> {
        self.is_free.iter().flatten().any(|is_free| *is_free).then_some(self.edge_error)
    }

    fn complementarity(&self) -> Option<Complementarity> {
        self.complementarity
    }

    fn size(&self) -> f64 {
        self.largest
    }
}
