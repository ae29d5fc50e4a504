//! What the pressure on panels answers to `ln theta0`, settlement and tilt, on zones that stay.
//!
//! `q + theta0 K (dp0/dv q) = b` for `b = -theta0 K p0`, 1 and `xi`, by the operator of the last zones, `q` what the layer gives more: of a linear one the pressure. A free edge moves by `-q/(dv/dxi)`. These `q` have `d ln d` at free edges, for which
//! the panels are not made: the error is told by two levels of panels.

use fredholm::multipole::PanelField;

use super::chart::Chart;
use super::level::{Level, System};
use crate::contact::accuracy::SAFETY;
use crate::contact::rates::{Linearised, Rates};
use crate::contact::rough::base::Base;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Error, Load, Rotational, Vertical};

/// Residuals relative to the right-hand side, on the panels before the last and on those; of integrals the square is left. At half or twice 29 of 32 answers change, within what they state (survey).
const RESIDUALS: [f64; 2] = [1e-9, 1e-12];
/// Jumps of the pressure at the ends of panels, over the largest, that are no rounding. Half and twice change none of 32 answers (survey).
const JUMP: f64 = 1e-7;
/// Share of a zone within which a jump at the end of a panel belongs to the free edge there. Half and twice change none of 10 answers (survey).
const BESIDE: f64 = 1e-3;

/// The three responses.
#[derive(Debug, Clone)]
pub(super) struct Responses {
    parts: [Response; 3],
    chart: Chart,
    parameter: f64,
}

/// The response to one right-hand side.
#[derive(Debug, Clone)]
struct Response {
    /// The right-hand side.
    given: Given,
    /// `q` at the nodes, and `K (dp0/dv q)`.
    values: Vec<f64>,
    field: PanelField,
    /// Force and moment of its pressure.
    carried: [f64; 2],
    /// By how much all zones together grow.
    width: f64,
    /// What the residual leaves of `q`, and of the width.
    noise: [f64; 2],
}

/// Right-hand sides.
#[derive(Debug, Clone)]
enum Given {
    /// `-theta0 K p0`, of this field.
    Body(PanelField),
    Level,
    Turn,
}

impl Given {
    fn at(&self, chart: &Chart, parameter: f64, xi: f64) -> f64 {
        match self {
            Self::Body(field) => -parameter * field.at(chart.local(xi)),
            Self::Level => 1.0,
            Self::Turn => xi,
        }
    }
}

impl Response {
    /// `q(xi)`, from the equation.
    fn at(&self, chart: &Chart, parameter: f64, xi: f64) -> f64 {
        self.given.at(chart, parameter, xi) - parameter * self.field.at(chart.local(xi))
    }
}

impl Responses {
    /// On the zones of a level, from what was known on the panels before.
    pub(super) fn new(
        base: &Base<'_>,
        level: &Level,
        system: &System,
        known: Option<&Self>,
    ) -> Result<Self, Error> {
        let panels = system.operator.panels();
        let chart = system.chart;
        let lever: Vec<f64> = panels.nodes().iter().map(|y| chart.place(*y)).collect();
        let residual = RESIDUALS[usize::from(known.is_some())];
        let start = |k: usize| -> Vec<f64> {
            let part = known.map(|known| &known.parts[k]);
            let value = |x: &f64| part.and_then(|p| p.field.panels().interpolate(&p.values, *x));
            panels.nodes().iter().map(|x| value(x).unwrap_or(0.0)).collect()
        };
        let ones = vec![1.0; panels.count()];
        let body: Vec<f64> = system.displacements.iter().map(|u| -u).collect();
        let (body_q, body_left) = solved(system, &body, &start(0), residual)?;
        let (level_q, level_left) = solved(system, &ones, &start(1), residual)?;
        let (turn_q, turn_left) = solved(system, &lever, &start(2), residual)?;
        let product = |one: &[f64], other: &[f64]| {
            let products: Vec<f64> = one.iter().zip(other).map(|(a, b)| a * b).collect();
            chart.half() * panels.integral(&products, |_| 1.0)
        };
        // The operator is symmetric: what is left of a residual counts by its square.
        let [level_p, turn_p] = [&level_q, &turn_q].map(|q| system.pressures(q));
        let carried = |p: &[f64], left: &[f64]| {
            let force = product(&ones, p) + product(&level_p, left);
            [force, product(&lever, p) + product(&turn_p, left)]
        };
        let parameter = system.parameter;
        let edges = edges(base, level, system);
        let inverse: f64 = edges.iter().map(|[_, rise]| rise.abs().recip()).sum();
        let response = |given: Given, right: &[f64], q: &[f64], left: &[f64]| {
            let noise = residual * right.iter().fold(0.0f64, |most, b| most.max(b.abs()));
            let p = system.pressures(q);
            let mut response = Response {
                given,
                values: q.to_vec(),
                field: system.operator.field(&p),
                carried: carried(&p, left),
                width: 0.0,
                noise: [noise, noise * inverse],
            };
            response.width =
                edges.iter().map(|[at, rise]| response.at(&chart, parameter, *at) / rise).sum();
            response
        };
        let mut of_body = response(Given::Body(level.field.clone()), &body, &body_q, &body_left);
        if base.layer.is_linear() && level.zones.iter().any(|zone| base.is_joined(zone)) {
            // On a whole circle potentials have no mean, and no more has what a linear layer gives to them.
            of_body.carried[0] = 0.0;
        }
        let parts = [
            of_body,
            response(Given::Level, &ones, &level_q, &level_left),
            response(Given::Turn, &lever, &turn_q, &turn_left),
        ];
        Ok(Self { parts, chart, parameter })
    }

    /// `d(P0, M0)/d(delta0, -alpha0)`.
    pub(super) fn stiffness(&self) -> Stiffness {
        let [_, level, turn] = &self.parts;
        Stiffness {
            force_settlement: level.carried[0],
            coupling: turn.carried[0],
            moment_tilt: turn.carried[1],
        }
    }

    /// How much less exact the stiffness on coarser panels is: for all entries the largest difference, as one may be nothing by chance.
    pub(super) fn stiffness_error(&self, coarse: &Self) -> Stiffness {
        let (one, other) = (self.stiffness().matrix(), coarse.stiffness().matrix());
        let entries = one.as_flattened().iter().zip(other.as_flattened());
        let error = SAFETY * entries.fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
        Stiffness { force_settlement: error, coupling: error, moment_tilt: error }
    }

    /// The rates by `ln theta0` and by what is prescribed, and what residuals leave of each.
    fn rates(&self, load: &Load, peak: (f64, f64)) -> [[Rates; 2]; 3] {
        let [body, _, _] = &self.parts;
        let [force, moment] = body.carried;
        let by_body = [
            if matches!(load.vertical, Vertical::Force(_)) { -force } else { 0.0 },
            match load.rotational {
                Rotational::Moment(_) => -moment,
                Rotational::Eccentricity(e) => e * force - moment,
                Rotational::Tilt(_) => 0.0,
            },
        ];
        let turns = !matches!(load.rotational, Rotational::Eccentricity(_));
        [
            self.combined(load, 1.0, by_body, peak),
            self.combined(load, 0.0, [1.0, 0.0], peak),
            if turns { self.combined(load, 0.0, [0.0, 1.0], peak) } else { [[0.0; 5]; 2] },
        ]
    }

    /// This share of the response to the body, with settlement and tilt such that these are the changes of what the load prescribes.
    fn combined(
        &self,
        load: &Load,
        share: f64,
        prescribed: [f64; 2],
        (peak, modulus): (f64, f64),
    ) -> [Rates; 2] {
        let [raise, turn] = self.stiffness().displaced(load, prescribed);
        let factors = [share, raise, turn];
        let parts = || self.parts.iter().zip(factors);
        let sum = |of: &dyn Fn(&Response) -> f64| -> f64 {
            parts().map(|(part, factor)| factor * of(part)).sum()
        };
        let noise = |k: usize| parts().map(|(part, factor)| factor.abs() * part.noise[k]).sum();
        let pressure = modulus * sum(&|part| part.at(&self.chart, self.parameter, peak));
        let force = sum(&|part| part.carried[0]);
        [
            [raise, force, -turn, pressure, sum(&|part| part.width)],
            [0.0, 0.0, 0.0, modulus * noise(0), noise(1)],
        ]
    }
}

/// The first-order change on the last panels, given the peak and `dp0/dv` there; its errors are the differences from those on the panels before.
pub(super) fn linearised(
    [coarse, fine]: &[Responses; 2],
    load: &Load,
    peak: (f64, f64),
) -> Linearised {
    let (coarse, fine) = (coarse.rates(load, peak), fine.rates(load, peak));
    let errors = std::array::from_fn(|input| {
        let ([rates, noise], [before, _]) = (fine[input], coarse[input]);
        let mut errors: Rates =
            std::array::from_fn(|k| SAFETY * (rates[k] - before[k]).abs() + noise[k]);
        // One of settlement and tilt may agree by chance.
        let displacement = errors[0].max(errors[2]);
        for k in [0, 2] {
            errors[k] = if errors[k] > 0.0 { displacement } else { 0.0 };
        }
        errors
    });
    Linearised { rates: fine.map(|[rates, _]| rates), errors }
}

/// The response to these values at the nodes, and what is left of them.
fn solved(
    system: &System,
    right: &[f64],
    start: &[f64],
    residual: f64,
) -> Result<(Vec<f64>, Vec<f64>), Error> {
    let panels = system.operator.panels();
    let squares: Vec<f64> = right.iter().map(|b| b * b).collect();
    let size = panels.integral(&squares, |_| 1.0).sqrt();
    let solution = system.equation().solve(right, &[], start, residual * size)?;
    let left = (right.iter().zip(&solution.values).zip(&solution.potential))
        .map(|((b, v), u)| b - v - system.parameter * u)
        .collect();
    Ok((solution.values, left))
}

/// The free edges with `dp0/dxi` inwards: `-alpha0 - f0' - theta0 (K p0)'`, and `(K p0)' = K p0' + sum [p0] K(xi - s)` over the places where the pressure jumps.
fn edges(base: &Base<'_>, level: &Level, system: &System) -> Vec<[f64; 2]> {
    let panels = system.operator.panels();
    let bent = system.operator.field(&panels.derivatives(&level.pressures));
    let jumps = jumps(level, system);
    let chart = &system.chart;
    let slope = |xi: f64| {
        let y = chart.local(xi);
        let jumped: f64 = jumps.iter().map(|[at, jump]| jump * chart.kernel.value(y - at)).sum();
        let bent = system.parameter / chart.half() * (bent.at(y) + jumped);
        -level.state.tilt - base.slope(xi) - bent
    };
    let ends = level.zones.iter().flat_map(Zone::free_ends);
    ends.map(|(side, at)| [at, if side == 0 { slope(at) } else { -slope(at) }]).collect()
}

/// Where the pressure jumps, in the coordinates of the panels, and by how much: corners and steps of the base.
fn jumps(level: &Level, system: &System) -> Vec<[f64; 2]> {
    let panels = system.operator.panels();
    let limits = panels.limits(&level.pressures);
    let none = JUMP * level.highest();
    let mut jumps: Vec<[f64; 2]> = Vec::new();
    let mut before = [f64::NEG_INFINITY, 0.0];
    for ([left, right], [first, last]) in panels.bounds().iter().zip(limits) {
        if *left == before[0] {
            jumps.push([*left, first - before[1]]);
        } else {
            jumps.extend([[before[0], -before[1]], [*left, first]]);
        }
        before = [*right, last];
    }
    jumps.push([before[0], -before[1]]);
    jumps.retain(|[at, jump]| jump.abs() > none && !is_free(&level.zones, level.chart.place(*at)));
    jumps
}

/// Whether this is a free edge, or was before the edges moved last.
fn is_free(zones: &[Zone], at: f64) -> bool {
    let near =
        |zone: &Zone| zone.free_ends().any(|(_, end)| (end - at).abs() <= BESIDE * zone.length());
    let after = zones.partition_point(|zone| zone.right() < at);
    zones[after.saturating_sub(1)..(after + 1).min(zones.len())].iter().any(near)
}
