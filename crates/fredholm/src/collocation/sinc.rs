//! Sinc collocation with the double-exponential map.
//!
//! `x = c + a tanh(pi/2 sinh t)` maps the line onto `(c - a, c + a)` and crowds the nodes `t_j = j h` towards the ends, so
//! that the `d ln d` behaviour of solutions there costs nothing. With `w_j = h x'(t_j)` the equation
//! `phi + lambda int K phi = f` becomes `phi_i + lambda sum_j M_ij phi_j = f_i`,
//!
//! `M_ij = w_j [K_ij + A_ij c_{|i-j|}]`, `M_ii = w_i [A_ii (ln w_i + c_0) + B_ii]`
//!
//! with the split `K = A ln|x - s| + B` and the corrections `c` of the exact sinc weights of the logarithm. (M. Sugihara and
//! T. Matsuo, J. Comput. Appl. Math. 164-165 (2004) 673, for the map; the weights follow from the Fourier integral of the sinc function.)
//! Scaled by the square roots of the weights the matrix is symmetric, and positive to rounding for a positive kernel.

use std::f64::consts::PI;

use super::map::{Node, RANGE, inverse};
use super::weights::logarithm_corrections;
use crate::kernel::{Kernel, Singularity, Split};
use crate::linear::Cholesky;
use crate::{Error, Interval};

/// What collocation of a kernel on a given number of nodes needs, whatever the parameter and the right-hand side.
#[derive(Debug, Clone)]
pub struct SincOperator {
    interval: Interval,
    step: f64,
    nodes: Vec<Node>,
    /// `sqrt(w_j)`.
    roots: Vec<f64>,
    /// `sqrt(w_i w_j) [..]`, row by row.
    matrix: Vec<f64>,
    /// `K` between each end and each node, times `w_j`: left, then right.
    ends: [Vec<f64>; 2],
}

/// A solution of collocation: values at the nodes and what evaluation elsewhere needs.
#[derive(Debug, Clone)]
pub struct SincSolution<'o> {
    operator: &'o SincOperator,
    parameter: f64,
    values: Vec<f64>,
    /// `(K phi)` at the ends.
    ends: [f64; 2],
    /// `K phi` at the nodes less the straight line through the ends.
    bubble: Vec<f64>,
}

impl SincOperator {
    /// The operator with `2 * half_count + 1` nodes.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for fewer than 9 nodes or more than 8001.
    pub fn new(kernel: &impl Kernel, half_count: usize) -> Result<Self, Error> {
        if !(4..=4000).contains(&half_count) {
            return Err(Error::InvalidParameter {
                name: "half_count",
                value: half_count as f64,
                requirement: "between 4 and 4000",
            });
        }
        let interval = kernel.interval();
        let count = 2 * half_count + 1;
        let step = RANGE / half_count as f64;
        let nodes: Vec<Node> =
            (0..count).map(|j| Node::at(interval, (j as f64 - half_count as f64) * step)).collect();
        let weights: Vec<f64> = nodes.iter().map(|node| step * node.derivative).collect();
        let roots: Vec<f64> = weights.iter().map(|weight| weight.sqrt()).collect();
        let corrections = corrections(kernel.singularity(), count);
        let mut matrix = vec![0.0; count * count];
        for i in 0..count {
            for j in 0..=i {
                let bracket = bracket(kernel, &nodes, i, j, weights[i], &corrections);
                matrix[i * count + j] = roots[i] * bracket * roots[j];
                matrix[j * count + i] = matrix[i * count + j];
            }
        }
        let ends = [interval.left(), interval.right()].map(|end| {
            nodes
                .iter()
                .zip(&weights)
                .map(|(node, weight)| {
                    let distance =
                        if end == interval.left() { node.from_left } else { node.from_right };
                    weight
                        * kernel
                            .split(end, node.position, distance)
                            .value(kernel.singularity(), distance)
                })
                .collect()
        });
        Ok(Self { interval, step, nodes, roots, matrix, ends })
    }

    /// Number of nodes.
    #[must_use]
    pub fn count(&self) -> usize {
        self.nodes.len()
    }

    /// The nodes, from left to right.
    pub fn positions(&self) -> impl Iterator<Item = f64> + '_ {
        self.nodes.iter().map(|node| node.position)
    }

    /// Solves `phi + parameter K phi = f` for several right-hand sides, each given by its values at
    /// [`positions`](Self::positions).
    ///
    /// # Errors
    /// [`Error::NotPositiveDefinite`] when the operator `1 + parameter K` is not positive.
    pub fn solve(
        &self,
        parameter: f64,
        right_hand_sides: &[Vec<f64>],
    ) -> Result<Vec<SincSolution<'_>>, Error> {
        let count = self.count();
        let cholesky = Cholesky::new(count, |i, j| {
            f64::from(u8::from(i == j)) + parameter * self.matrix[i * count + j]
        })?;
        Ok(right_hand_sides.iter().map(|f| self.finish(parameter, f, &cholesky)).collect())
    }

    fn finish(&self, parameter: f64, f: &[f64], cholesky: &Cholesky) -> SincSolution<'_> {
        let count = self.count();
        let mut scaled: Vec<f64> = f.iter().zip(&self.roots).map(|(f, root)| f * root).collect();
        cholesky.solve(&mut scaled);
        // Division by the tiny weights near the ends would lose digits: values come from phi = f - lambda K phi.
        let potential: Vec<f64> = (0..count)
            .map(|i| dot(&self.matrix[i * count..(i + 1) * count], &scaled) / self.roots[i])
            .collect();
        let values: Vec<f64> = f.iter().zip(&potential).map(|(f, u)| f - parameter * u).collect();
        let ends = [dot(&self.ends[0], &values), dot(&self.ends[1], &values)];
        let length = 2.0 * self.interval.half_length();
        let bubble = potential
            .iter()
            .zip(&self.nodes)
            .map(|(u, node)| u - (ends[0] * node.from_right + ends[1] * node.from_left) / length)
            .collect();
        SincSolution { operator: self, parameter, values, ends, bubble }
    }
}

impl SincSolution<'_> {
    /// `int_L u phi dx` for `u` given by its values at the nodes.
    #[must_use]
    pub fn integral(&self, u: impl Fn(f64) -> f64) -> f64 {
        let operator = self.operator;
        (operator.nodes.iter().zip(&self.values).zip(&operator.roots))
            .map(|((node, value), root)| u(node.position) * value * root * root)
            .sum()
    }

    /// `phi(x)` for `x` in the closed interval, given `f(x)`: the potential is interpolated by sinc functions, the ends have
    /// exact values.
    #[must_use]
    pub fn evaluate(&self, x: f64, right_hand_side: f64) -> f64 {
        let interval = self.operator.interval;
        let (from_left, from_right) = (x - interval.left(), interval.right() - x);
        if from_left <= 0.0 {
            return right_hand_side - self.parameter * self.ends[0];
        }
        if from_right <= 0.0 {
            return right_hand_side - self.parameter * self.ends[1];
        }
        let line =
            (self.ends[0] * from_right + self.ends[1] * from_left) / (from_left + from_right);
        right_hand_side - self.parameter * (line + self.interpolate(inverse(from_left, from_right)))
    }

    fn interpolate(&self, t: f64) -> f64 {
        let place = t / self.operator.step + (self.operator.count() / 2) as f64;
        let nearest = place.round();
        if nearest >= 0.0
            && (nearest as usize) < self.bubble.len()
            && (place - nearest).abs() < 1e-13
        {
            return self.bubble[nearest as usize];
        }
        let mut sum = 0.0;
        let mut sign = 1.0;
        for (j, value) in self.bubble.iter().enumerate() {
            sum += sign * value / (place - j as f64);
            sign = -sign;
        }
        // sin(pi place), reduced by hand: place itself may be large.
        let parity = if (nearest as i64) % 2 == 0 { 1.0 } else { -1.0 };
        sum * parity * (PI * (place - nearest)).sin() / PI
    }
}

fn corrections(singularity: Singularity, count: usize) -> Vec<f64> {
    match singularity {
        Singularity::Logarithm => logarithm_corrections(count),
        Singularity::None => vec![0.0; count],
    }
}

fn bracket(
    kernel: &impl Kernel,
    nodes: &[Node],
    i: usize,
    j: usize,
    weight: f64,
    corrections: &[f64],
) -> f64 {
    let singularity = kernel.singularity();
    if i == j {
        let Split { factor, rest } = kernel.split(nodes[i].position, nodes[i].position, 0.0);
        return match singularity {
            Singularity::Logarithm => factor * (weight.ln() + corrections[0]) + rest,
            Singularity::None => rest,
        };
    }
    let distance = nodes[i].distance(&nodes[j]);
    let split = kernel.split(nodes[i].position, nodes[j].position, distance);
    split.value(singularity, distance) + split.factor * corrections[i - j]
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
