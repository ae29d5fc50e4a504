//! A wave in full contact to first order.

use std::f64::consts::PI;

use super::super::base::Base;
use super::super::elimination;
use super::super::field::Field;
use super::super::ring::{Ring, influence};
use super::super::solved::Solved;
use crate::Vertical;
use crate::contact::rates::{Linearised, Rates};

/// The first-order change with the largest pressure at `peak`; its errors are those of the solution.
pub(super) fn linearised(base: &Base<'_>, solved: &Solved, peak: f64) -> Option<Linearised> {
    let Field::Ring(ring) = &solved.solution else { return None };
    let by_force = matches!(base.load.vertical, Vertical::Force(_));
    let angle = PI * peak;
    let rates = if solved.layer.is_linear() {
        straight(ring, by_force, angle)
    } else {
        let slope = solved.layer.slope(solved.layer(base, peak));
        bent(solved, ring, by_force, angle)?.map(|rates| {
            let [settlement, force, tilt, layer, width] = rates;
            [settlement, force, tilt, slope * layer, width]
        })
    };
    Some(Linearised { rates, errors: [[0.0; 5]; 3] })
}

/// Of a linear layer, each wave by itself; the mean is that of the load.
fn straight(ring: &Ring, by_force: bool, angle: f64) -> [Rates; 3] {
    let waves = ring.series().iter().enumerate().skip(1).map(|(m, [even, odd])| {
        let body = ring.parameter() * PI / m as f64;
        let (sine, cosine) = (m as f64 * angle).sin_cos();
        -ring.parameter() / (1.0 + body) * (even * cosine + odd * sine)
    });
    let pressure = waves.sum();
    let unit = if by_force { [0.5, 0.0, 0.0, 0.5, 0.0] } else { [1.0, 2.0, 0.0, 1.0, 0.0] };
    [[0.0, 0.0, 0.0, pressure, 0.0], unit, [0.0; 5]]
}

/// Of a layer that bends, with the change of its displacement in place of that of the pressure.
fn bent(solved: &Solved, ring: &Ring, by_force: bool, angle: f64) -> Option<[Rates; 3]> {
    let weights: Vec<f64> = ring.values().iter().map(|v| solved.layer.slope(*v)).collect();
    let count = weights.len();
    let parameter = ring.parameter();
    let influence = influence(count);
    let solve = |right: &[f64]| {
        let rows = (0..count)
            .map(|i| {
                let of = |j: usize| parameter * influence[i.abs_diff(j)] * weights[j];
                let mut row: Vec<f64> = (0..count).map(of).collect();
                row[i] += 1.0;
                row.push(right[i]);
                row
            })
            .collect();
        elimination::solve(rows)
    };
    let pressed = |layer: &[f64]| -> Vec<f64> {
        layer.iter().zip(&weights).map(|(v, weight)| v * weight).collect()
    };
    let force = |layer: &[f64]| 2.0 * pressed(layer).iter().sum::<f64>() / count as f64;
    let given: Vec<f64> = ring.potential().iter().map(|u| -parameter * u).collect();
    let (level, elastic) = (solve(&vec![1.0; count])?, solve(&given)?);
    let (stiffness, free) = (force(&level), force(&elastic));
    let rates = |share: f64, raise: f64| -> Rates {
        let layer: Vec<f64> =
            level.iter().zip(&elastic).map(|(l, e)| raise * l + share * e).collect();
        let right = raise + share * ring.at(angle, 0.0);
        let there = Ring::new(parameter, &given, &pressed(&layer)).at(angle, right);
        [raise, raise * stiffness + share * free, 0.0, there, 0.0]
    };
    let raises = if by_force { [-free / stiffness, 1.0 / stiffness] } else { [0.0, 1.0] };
    Some([rates(1.0, raises[0]), rates(0.0, raises[1]), [0.0; 5]])
}
