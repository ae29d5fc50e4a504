//! A wave in full contact over its whole period: no ends, so Fourier series instead of panels.
//!
//! With the angle `y = pi xi` the kernel is `ln 1/(2 sin(|y - t|/2)) = sum_m cos(m (y - t))/m`: it turns `cos m t` into `(pi/m) cos m y`, and a constant into 0.
//! Nodes are equally spaced, the rule is the trapezoidal one.

use std::f64::consts::{PI, TAU};

use super::base::Base;
use super::between::between_nodes;
use super::elimination;
use super::extent::{extent, reference_pressure};
use super::field::Field;
use super::layer::Layer;
use super::solved::{Panel, Solved, Stated};
use crate::contact::accuracy::{Accuracy, ErrorKind};
use crate::contact::balance::State;
use crate::contact::ground::Hull;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Error, Vertical};

/// Fewest nodes, and most for a linear layer and for one that bends.
const FEWEST: usize = 32;
const MOST: usize = 4096;
const MOST_BENDING: usize = 512;
/// Nodes in the shortest part of the profile.
const NODES_A_PART: f64 = 4.0;
/// Change from one number of nodes to the next, relative to the size of what is added up, that is rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;
/// Tension relative to the largest pressure that is no error of a few nodes.
const PULLING: f64 = 0.02;
/// Points at which two numbers of nodes are compared.
const COMPARED: usize = 200;
/// Newton steps for a layer that bends, and how often one is halved.
const STEPS: usize = 100;
const CUTS: i32 = 30;
/// A step below this share of what the layer gives under the load is rounding.
const SETTLED: f64 = 8.0 * f64::EPSILON;

/// A pressure on the whole circle.
#[derive(Debug, Clone)]
pub(super) struct Ring {
    parameter: f64,
    values: Vec<f64>,
    potential: Vec<f64>,
    masses: Vec<f64>,
    /// Coefficients of `cos m y` and `sin m y` in `K p`.
    series: Vec<[f64; 2]>,
    noise: f64,
}

impl Ring {
    /// From the right-hand side and the pressures at the nodes.
    pub(super) fn new(parameter: f64, right: &[f64], pressures: &[f64]) -> Self {
        let size = pressures.iter().fold(0.0f64, |most, p| most.max(p.abs()));
        // Rounding of the pressures comes through the kernel.
        let noise = 4.0 * f64::EPSILON * parameter * size;
        Self { noise, ..Self::of_waves(parameter, right, pressures, coefficients(pressures)) }
    }

    /// The same with the series of the pressures, which may hold small waves to more digits than their values do.
    fn of_waves(
        parameter: f64,
        right: &[f64],
        pressures: &[f64],
        mut series: Vec<[f64; 2]>,
    ) -> Self {
        let count = pressures.len();
        series[0] = [0.0; 2];
        for (m, pair) in series.iter_mut().enumerate().skip(1) {
            *pair = pair.map(|part| part * PI / m as f64);
        }
        let potential: Vec<f64> = summed(&series, count);
        let values = right.iter().zip(&potential).map(|(g, u)| g - parameter * u).collect();
        let masses = pressures.iter().map(|p| p * TAU / count as f64).collect();
        Self { parameter, values, potential, masses, series, noise: 0.0 }
    }

    /// Coefficients of `cos m y` and `sin m y` in `K p`.
    pub(super) fn series(&self) -> &[[f64; 2]] {
        &self.series
    }

    pub(super) fn parameter(&self) -> f64 {
        self.parameter
    }

    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }

    pub(super) fn potential(&self) -> &[f64] {
        &self.potential
    }

    pub(super) fn masses(&self) -> &[f64] {
        &self.masses
    }

    pub(super) fn integral(&self, u: impl Fn(f64) -> f64) -> f64 {
        let angles = angles(self.masses.len());
        angles.zip(&self.masses).map(|(y, mass)| u(y) * mass).sum()
    }

    /// `int xi p0 dxi` over the period: of `b sin m y` it is `-2 (-1)^m b/(m pi)`.
    fn moment(&self) -> f64 {
        let signed = self.series.iter().enumerate().skip(1).map(
            |(m, [_, b])| {
                if m % 2 == 0 { -b } else { *b }
            },
        );
        2.0 / (PI * PI) * signed.sum::<f64>()
    }

    pub(super) fn at(&self, angle: f64, right_hand_side: f64) -> f64 {
        // Clenshaw's recurrence for both series.
        let twice = 2.0 * angle.cos();
        let (mut one, mut two) = ([0.0; 2], [0.0; 2]);
        for pair in self.series.iter().skip(1).rev() {
            for part in 0..2 {
                let next = pair[part] + twice * one[part] - two[part];
                (two[part], one[part]) = (one[part], next);
            }
        }
        let cosines = 0.5 * twice * one[0] - two[0];
        right_hand_side - self.parameter * (self.series[0][0] + cosines + angle.sin() * one[1])
    }

    pub(super) fn rounding(&self) -> f64 {
        let largest = |values: &[f64]| values.iter().fold(0.0f64, |most, v| most.max(v.abs()));
        let terms = largest(&self.values) + self.parameter * largest(&self.potential);
        24.0 * f64::EPSILON * terms + self.noise
    }
}

/// Full contact over the period, on growing numbers of nodes, and its estimated errors.
pub(super) fn solve(base: &Base<'_>) -> Result<Solved, Error> {
    let most = if base.layer.is_linear() { MOST } else { MOST_BENDING };
    let mut count = fewest(base, most)?;
    let mut known = level(base, count)?;
    loop {
        count *= 2;
        let next = level(base, count)?;
        let points = between_nodes(COMPARED).map(|xi| (xi, base.height(xi)));
        let change = points
            .map(|(xi, f)| (next.pressure_at(xi, f) - known.pressure_at(xi, f)).abs())
            .fold(0.0, f64::max);
        let settlement = (next.state.settlement - known.state.settlement).abs();
        let force = (next.state.force - known.state.force).abs();
        let size =
            next.layer.slope(next.deepest()) * (next.deepest() + next.state.settlement.abs());
        let rounding = (ROUNDING * size).max(2.0 * next.pressure_rounding());
        if change <= rounding || 2 * count > most || lifts(base, &next) {
            let by_force = matches!(base.load.vertical, Vertical::Force(_));
            let accuracy = Accuracy {
                kind: ErrorKind::Estimate,
                pressure: change.max(next.pressure_rounding()),
                // A single number may agree by chance where the pressure does not.
                settlement: if by_force {
                    settlement.max(change).max(next.rounding())
                } else {
                    0.0
                },
                tilt: 0.0,
                force: if by_force { 0.0 } else { force.max(2.0 * next.pressure_rounding()) },
                // The largest moment of a pressure that is off by so much everywhere.
                moment: change.max(next.pressure_rounding()),
            };
            return Ok(Solved { stated: Stated { accuracy, edge: 0.0 }, ..next });
        }
        known = next;
    }
}

/// Nodes to begin with, that show the shortest part of the profile.
fn fewest(base: &Base<'_>, most: usize) -> Result<usize, Error> {
    let cuts: Vec<f64> =
        [-1.0].into_iter().chain(base.breaks.iter().copied()).chain([1.0]).collect();
    let width = cuts.windows(2).fold(2.0f64, |least, pair| least.min(pair[1] - pair[0]));
    let wanted = 2.0 * NODES_A_PART / width;
    // Between measured points nothing is narrow.
    if base.problem.profile().measured_points().is_some() {
        return Ok(FEWEST);
    }
    if wanted > most as f64 {
        return Err(Error::TooNarrow { width, least: 2.0 * NODES_A_PART / most as f64 });
    }
    Ok((wanted as usize).next_power_of_two().clamp(FEWEST, most / 4))
}

/// Whether full contact would pull so much that it need not be known better.
pub(super) fn lifts(base: &Base<'_>, solved: &Solved) -> bool {
    let least = solved.solution.values().iter().fold(f64::INFINITY, |least, v| least.min(*v));
    !base.is_bilateral && least < -PULLING * solved.deepest()
}

/// Where the layer pulls most.
pub(super) fn least(solved: &Solved) -> f64 {
    let values = solved.solution.values().iter().zip(&solved.positions);
    values.min_by(|one, two| one.0.total_cmp(two.0)).map_or(0.0, |(_, at)| *at)
}

/// Full contact with so many nodes.
fn level(base: &Base<'_>, count: usize) -> Result<Solved, Error> {
    let heights: Vec<f64> =
        angles(count).map(|y| base.finite_height(y / PI)).collect::<Result<_, _>>()?;
    // theta int K p dxi = (theta/pi) int K p dy
    let equations = Equations { parameter: base.theta / PI, heights, layer: base.layer };
    let (settlement, ring, slopes) = equations.solve(base)?;
    let force = ring.masses.iter().sum::<f64>() / PI;
    let force = if let Vertical::Force(given) = base.load.vertical { given } else { force };
    let stiffness = equations.stiffness(&slopes)?;
    let zone = Zone::new([-1.0, 1.0], [false; 2]);
    Ok(Solved {
        stated: Stated::none(),
        zones: vec![zone],
        panels: vec![Panel { left: -1.0, right: 1.0, zone: 0 }],
        medium: base.medium.clone(),
        layer: base.layer,
        hull: Hull { centre: 0.0, half: 1.0 / PI },
        positions: angles(count).map(|y| y / PI).collect(),
        local: [settlement, 0.0],
        state: State { settlement, tilt: 0.0, force, moment: ring.moment() },
        solution: Field::Ring(ring),
        stiffness: Stiffness { force_settlement: stiffness, coupling: 0.0, moment_tilt: 0.0 },
    })
}

struct Equations {
    parameter: f64,
    heights: Vec<f64>,
    layer: Layer,
}

impl Equations {
    /// Settlement, pressure and `dp0/dv` at the nodes.
    fn solve(&self, base: &Base<'_>) -> Result<(f64, Ring, Vec<f64>), Error> {
        if self.layer.is_linear() {
            return Ok(self.linear(base.load.vertical));
        }
        self.bending(base)
    }

    fn ring(&self, settlement: f64, pressures: &[f64]) -> Ring {
        let right: Vec<f64> = self.heights.iter().map(|height| settlement - height).collect();
        Ring::new(self.parameter, &right, pressures)
    }

    /// Each wave by itself.
    fn linear(&self, vertical: Vertical) -> (f64, Ring, Vec<f64>) {
        let count = self.heights.len();
        let mut series = coefficients(&self.heights);
        let mean = series[0][0];
        for (m, pair) in series.iter_mut().enumerate().skip(1) {
            *pair = pair.map(|part| -part / (1.0 + self.parameter * PI / m as f64));
        }
        let pressure = match vertical {
            Vertical::Force(force) => 0.5 * force,
            Vertical::Settlement(settlement) => settlement - mean,
        };
        series[0] = [pressure, 0.0];
        let settlement = match vertical {
            Vertical::Force(_) => pressure + mean,
            Vertical::Settlement(settlement) => settlement,
        };
        let right: Vec<f64> = self.heights.iter().map(|height| settlement - height).collect();
        let pressures = summed(&series, count);
        let ring = Ring::of_waves(self.parameter, &right, &pressures, series);
        (settlement, ring, vec![1.0; count])
    }

    /// Newton's method for `v` and the settlement, cut until the residual falls.
    fn bending(&self, base: &Base<'_>) -> Result<(f64, Ring, Vec<f64>), Error> {
        let count = self.heights.len();
        let pressure = reference_pressure(base, &extent(base));
        let mean = self.heights.iter().sum::<f64>() / count as f64;
        let mut settlement = match base.load.vertical {
            Vertical::Force(_) => self.layer.displacement(pressure) + mean,
            Vertical::Settlement(settlement) => settlement,
        };
        let mut v = vec![self.layer.displacement(pressure); count];
        let scale = self.layer.displacement(pressure);
        let mut trial = self.trial(base, &v, settlement);
        for _ in 0..STEPS {
            let slopes: Vec<f64> = v.iter().map(|v| self.layer.slope(*v)).collect();
            let (step, raise) = self.step(base, &slopes, &trial)?;
            let largest = step.iter().fold(0.0f64, |most, dv| most.max(dv.abs()));
            let mut share = 1.0;
            for cut in 0..=CUTS {
                share = 0.5f64.powi(cut);
                let next: Vec<f64> = v.iter().zip(&step).map(|(v, dv)| v + share * dv).collect();
                let tried = self.trial(base, &next, settlement + share * raise);
                if tried.merit(scale, pressure) <= trial.merit(scale, pressure) || cut == CUTS {
                    (v, settlement, trial) = (next, settlement + share * raise, tried);
                    break;
                }
            }
            if share * largest <= SETTLED * (scale + settlement.abs()) {
                let pressures: Vec<f64> = v.iter().map(|v| self.layer.pressure(*v)).collect();
                return Ok((settlement, self.ring(settlement, &pressures), slopes));
            }
        }
        let residual = trial.merit(scale, pressure);
        let (iterations, tolerance) = (STEPS, SETTLED);
        Err(fredholm::Error::NotConverged { iterations, residual, tolerance }.into())
    }

    fn trial(&self, base: &Base<'_>, v: &[f64], settlement: f64) -> Trial {
        let pressures: Vec<f64> = v.iter().map(|v| self.layer.pressure(*v)).collect();
        let ring = self.ring(settlement, &pressures);
        let residual = v.iter().zip(&ring.values).map(|(v, target)| v - target).collect();
        let mean = pressures.iter().sum::<f64>() / pressures.len() as f64;
        let lack = match base.load.vertical {
            Vertical::Force(force) => 0.5 * force - mean,
            Vertical::Settlement(_) => 0.0,
        };
        Trial { residual, lack }
    }

    /// `(1 + theta K w) dv = -r + d delta` with the mean of `w dv` prescribed by the force.
    fn step(
        &self,
        base: &Base<'_>,
        slopes: &[f64],
        trial: &Trial,
    ) -> Result<(Vec<f64>, f64), Error> {
        let count = slopes.len();
        let by_force = matches!(base.load.vertical, Vertical::Force(_));
        let influence = influence(count);
        let mut rows: Vec<Vec<f64>> = (0..count)
            .map(|i| {
                let mut row: Vec<f64> = (0..count)
                    .map(|j| self.parameter * influence[i.abs_diff(j)] * slopes[j])
                    .collect();
                row[i] += 1.0;
                row.extend([-1.0, -trial.residual[i]]);
                row
            })
            .collect();
        let mut last: Vec<f64> =
            slopes.iter().map(|w| if by_force { w / count as f64 } else { 0.0 }).collect();
        last.extend([if by_force { 0.0 } else { 1.0 }, trial.lack]);
        rows.push(last);
        let parameter = self.parameter;
        let mut found = elimination::solve(rows)
            .ok_or(Error::Equation(fredholm::Error::Singular { parameter, smallest: 0.0 }))?;
        let raise = found.pop().unwrap_or(0.0);
        Ok((found, raise))
    }

    /// `dP0/d delta0`.
    fn stiffness(&self, slopes: &[f64]) -> Result<f64, Error> {
        if self.layer.is_linear() {
            return Ok(2.0);
        }
        let count = slopes.len();
        let influence = influence(count);
        let rows = (0..count)
            .map(|i| {
                let mut row: Vec<f64> = (0..count)
                    .map(|j| self.parameter * influence[i.abs_diff(j)] * slopes[j])
                    .collect();
                row[i] += 1.0;
                row.push(1.0);
                row
            })
            .collect();
        let parameter = self.parameter;
        let dv = elimination::solve(rows)
            .ok_or(Error::Equation(fredholm::Error::Singular { parameter, smallest: 0.0 }))?;
        Ok(2.0 * dv.iter().zip(slopes).map(|(dv, w)| dv * w).sum::<f64>() / count as f64)
    }
}

struct Trial {
    residual: Vec<f64>,
    lack: f64,
}

impl Trial {
    fn merit(&self, scale: f64, pressure: f64) -> f64 {
        let mean = self.residual.iter().map(|r| r * r).sum::<f64>() / self.residual.len() as f64;
        mean / (scale * scale) + (self.lack / pressure).powi(2)
    }
}

/// `-pi .. pi` without its right end.
fn angles(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |j| TAU * j as f64 / count as f64 - PI)
}

/// `cos` and `sin` of the multiples of a part of the circle.
fn turns(count: usize) -> Vec<[f64; 2]> {
    (0..count)
        .map(|k| {
            let (sine, cosine) = (TAU * k as f64 / count as f64).sin_cos();
            [cosine, sine]
        })
        .collect()
}

/// Coefficients of `cos m y` and `sin m y`, `0 <= m <= N/2`, in the series through the values.
fn coefficients(values: &[f64]) -> Vec<[f64; 2]> {
    let count = values.len();
    let turns = turns(count);
    (0..=count / 2)
        .map(|m| {
            // Angles begin at -pi.
            let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
            let halved = if m == 0 || 2 * m == count { 1.0 } else { 2.0 };
            let scale = sign * halved / count as f64;
            let mut sums = [0.0; 2];
            for (j, value) in values.iter().enumerate() {
                let [cosine, sine] = turns[j * m % count];
                sums[0] += value * cosine;
                sums[1] += value * sine;
            }
            sums.map(|sum| scale * sum)
        })
        .collect()
}

/// The values of a series at the nodes.
fn summed(series: &[[f64; 2]], count: usize) -> Vec<f64> {
    let turns = turns(count);
    (0..count)
        .map(|j| {
            (series.iter().enumerate())
                .map(|(m, [a, b])| {
                    let sign = if m % 2 == 0 { 1.0 } else { -1.0 };
                    let [cosine, sine] = turns[j * m % count];
                    sign * (a * cosine + b * sine)
                })
                .sum()
        })
        .collect()
}

/// `K` for a unit value at a node, by the distance in nodes.
pub(super) fn influence(count: usize) -> Vec<f64> {
    let turns = turns(count);
    (0..count)
        .map(|k| {
            (1..=count / 2)
                .map(|m| {
                    let halved = if 2 * m == count { 1.0 } else { 2.0 };
                    halved * PI / (m as f64 * count as f64) * turns[k * m % count][0]
                })
                .sum()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_give_the_values_back() {
        let values: Vec<f64> =
            angles(16).map(|y| (y.cos() + 0.3 * (3.0 * y).sin()).exp()).collect();
        for (one, two) in values.iter().zip(summed(&coefficients(&values), 16)) {
            assert!((one - two).abs() < 1e-14, "{one} {two}");
        }
    }

    #[test]
    fn the_kernel_divides_waves_by_their_number() {
        let pressures: Vec<f64> =
            angles(24).map(|y| 1.0 + (2.0 * y).cos() - (5.0 * y).sin()).collect();
        let ring = Ring::new(1.0, &[0.0; 24], &pressures);
        let exact = |y: f64| PI / 2.0 * (2.0 * y).cos() - PI / 5.0 * (5.0 * y).sin();
        for y in [-3.0, 0.1, 1.7] {
            assert!((-ring.at(y, 0.0) - exact(y)).abs() < 1e-14);
        }
        let influence = influence(24);
        for (i, u) in ring.potential().iter().enumerate() {
            let sum: f64 = (0..24).map(|j| influence[i.abs_diff(j)] * pressures[j]).sum();
            assert!((sum - u).abs() < 1e-13);
        }
    }
}
