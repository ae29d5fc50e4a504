//! The density whose error is bounded, a polynomial on each panel, and its potential.

use crate::allowance::UNIT;
use crate::chebyshev::MOST;
use crate::far::{Cluster, FAR};
use crate::kernel::Kernel;
use crate::legendre;
use crate::near::{Distances, Recurrence};
use crate::panel::Panel;
use crate::places::Places;
use crate::potentials::Sums;
use crate::row::Regular;
use crate::vectorised::vectorised;

/// Places whose potentials are found together, few and many.
const NARROW: usize = 8;
const WIDE: usize = 16;
/// Clusters that wait to be looked at: one more for each of their generations, which halve their panels.
const DEPTH: usize = 64;

/// Polynomials on panels from left to right, zero elsewhere.
#[derive(Debug, Clone)]
pub(crate) struct Density {
    pub(crate) kernel: Kernel,
    pub(crate) panels: Vec<Panel>,
    clusters: Vec<Cluster>,
    recurrence: Recurrence,
    /// What the recurrence needs of the lengths of the panels.
    scales: Vec<f64>,
    /// Of a row.
    regular: Regular,
}

impl Density {
    pub(crate) fn new(kernel: Kernel, panels: Vec<Panel>) -> Self {
        let regular = match kernel {
            Kernel::Row { period } => Regular::new(&panels, period),
            Kernel::Logarithm
            | Kernel::ShiftedLogarithm { .. }
            | Kernel::Layered(_)
            | Kernel::Power { .. } => Regular::default(),
        };
        let recurrence = Recurrence::new(kernel.singularity());
        let scales = panels.iter().map(|panel| recurrence.scale(panel.half())).collect();
        let clusters = Vec::with_capacity(2 * panels.len());
        let mut density = Self { kernel, panels, clusters, recurrence, scales, regular };
        if !density.panels.is_empty() {
            density.gather([0, density.panels.len()]);
        }
        density
    }

    /// The cluster of these panels, after those of its parts; its index.
    fn gather(&mut self, [first, last]: [usize; 2]) -> usize {
        let children = (last - first > 1).then(|| {
            let middle = usize::midpoint(first, last);
            [self.gather([first, middle]), self.gather([middle, last])]
        });
        let parts = children.map(|both| (both, both.map(|child| &self.clusters[child])));
        let cluster = Cluster::new(&self.panels, [first, last], parts, self.kernel.singularity());
        self.clusters.push(cluster);
        self.clusters.len() - 1
    }

    /// The largest size.
    pub(crate) fn largest(&self) -> f64 {
        self.clusters.last().map_or(0.0, |root| root.largest)
    }

    /// The panel of a place, if there is one; of two the left.
    pub(crate) fn panel_at(&self, x: f64) -> Option<usize> {
        let index = self.panels.partition_point(|panel| panel.right < x);
        self.panels.get(index).is_some_and(|panel| panel.left <= x).then_some(index)
    }

    /// `q(x)`.
    pub(crate) fn evaluate(&self, x: f64) -> f64 {
        self.panel_at(x).map_or(0.0, |index| self.panels[index].evaluate(x))
    }

    /// `q(x)` and a bound of its rounding.
    pub(crate) fn value(&self, x: f64) -> (f64, f64) {
        self.panel_at(x).map_or((0.0, 0.0), |index| {
            let panel = &self.panels[index];
            (panel.evaluate(x), UNIT * panel.evaluated)
        })
    }

    /// The same at places from left to right.
    pub(crate) fn values(&self, places: &Places<'_>) -> Vec<(f64, f64)> {
        let Places { from, offsets } = *places;
        let mut found = Vec::with_capacity(offsets.len());
        let mut own = [0.0; MOST];
        let mut values = [0.0; MOST];
        while let Some(first) = offsets.get(found.len()) {
            let index = self.panels.partition_point(|panel| panel.right - from < *first);
            let beside = |panel: &&Panel| panel.left - from <= *first;
            let Some(panel) = self.panels.get(index).filter(beside) else {
                found.push((0.0, 0.0));
                continue;
            };
            let end = panel.right - from;
            let rest = offsets[found.len()..].iter().take(MOST).take_while(|x| **x <= end);
            let mut count = 0;
            for (own, offset) in own.iter_mut().zip(rest) {
                *own = panel.own_from(from, *offset);
                count += 1;
            }
            legendre::evaluate_all(&panel.coefficients, &own[..count], &mut values[..count]);
            found.extend(values[..count].iter().map(|q| (*q, UNIT * panel.evaluated)));
        }
        found
    }

    /// `int K(x, t) q(t) dt` and a bound of its rounding.
    pub(crate) fn potential(&self, x: f64) -> (f64, f64) {
        let mut found = [(0.0, 0.0)];
        self.potentials(&Places::numbers(&[x]), &mut found);
        found[0]
    }

    /// The same at places that lie together, into as many entries, which costs less than one by one; how often a panel, or several together, were looked at for them.
    pub(crate) fn potentials(&self, places: &Places<'_>, found: &mut [(f64, f64)]) -> u64 {
        let from = places.from;
        let mut looks = 0;
        for (offsets, found) in places.offsets.chunks(WIDE).zip(found.chunks_mut(WIDE)) {
            looks += if offsets.len() <= NARROW {
                self.potentials_of::<NARROW>(from, offsets, found)
            } else {
                self.potentials_of::<WIDE>(from, offsets, found)
            };
        }
        looks
    }

    /// Of at most `N` places.
    fn potentials_of<const N: usize>(
        &self,
        from: f64,
        offsets: &[f64],
        found: &mut [(f64, f64)],
    ) -> u64 {
        let Some(last) = offsets.last() else { return 0 };
        let mut all = [*last; N];
        all[..offsets.len()].copy_from_slice(offsets);
        let (sums, looks) = vectorised(
            #[inline(always)]
            || {
                let (sums, looks) = self.summed(from, &all);
                (sums.finished(), looks)
            },
        );
        found.copy_from_slice(&sums[..offsets.len()]);
        looks
    }

    #[inline(always)]
    fn summed<const N: usize>(&self, from: f64, offsets: &[f64; N]) -> (Sums<N>, u64) {
        let (mut sums, mut looks) = (Sums::NONE, 0);
        let Some(root) = self.clusters.last() else { return (sums, looks) };
        match self.kernel {
            Kernel::Logarithm => looks += self.add_singular(from, offsets, -1.0, &mut sums),
            Kernel::ShiftedLogarithm { .. } | Kernel::Layered(_) => {
                looks += self.add_singular(from, offsets, -1.0, &mut sums);
                // Interpolation reproduces a constant, so that windows need not know of it. The integral is compensated; the constant is a rounded logarithm.
                let constant = self.kernel.constant();
                let rounding = 8.0 * constant.abs() * root.mass;
                sums.add(1.0, &[constant * root.integral(); N], &[rounding; N]);
            }
            Kernel::Power { .. } => looks += self.add_singular(from, offsets, 1.0, &mut sums),
            Kernel::Row { period } => {
                for image in [0.0, -period, period] {
                    looks += self.add_singular(from + image, offsets, -1.0, &mut sums);
                }
                let mut places = *offsets;
                for x in &mut places {
                    *x += from;
                }
                let (values, rounding) = self.regular.at(&places);
                sums.add(1.0, &values, &[rounding; N]);
            }
        }
        (sums, looks)
    }

    /// Adds `sign int sigma(|x - t|) q(t) dt`; the number of looks.
    #[inline(always)]
    fn add_singular<const N: usize>(
        &self,
        from: f64,
        offsets: &[f64; N],
        sign: f64,
        sums: &mut Sums<N>,
    ) -> u64 {
        let singularity = self.kernel.singularity();
        let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
        for x in offsets {
            first = first.min(*x);
            last = last.max(*x);
        }
        let Some(root) = self.clusters.last() else { return 0 };
        let total = root.mass;
        let mut stack = [0; DEPTH];
        stack[0] = self.clusters.len() - 1;
        let (mut count, mut looks) = (1, 0);
        while count > 0 {
            count -= 1;
            looks += 1;
            let cluster = &self.clusters[stack[count]];
            let from_centre = from - cluster.centre;
            let distance = (from_centre + first).max(-(from_centre + last));
            let [values, roundings] = if distance >= FAR * cluster.radius {
                cluster.potentials(singularity, from_centre, offsets, distance, total)
            } else if let Some(children) = cluster.children {
                stack[count..count + 2].copy_from_slice(&children);
                count += 2;
                continue;
            } else {
                self.beside(cluster, from, offsets)
            };
            sums.add(sign, &values, &roundings);
        }
        looks
    }

    /// Potentials of a single panel, of which some places of those that are longer together than it may be far.
    #[inline(always)]
    fn beside<const N: usize>(
        &self,
        cluster: &Cluster,
        from: f64,
        offsets: &[f64; N],
    ) -> [[f64; N]; 2] {
        let least = FAR * cluster.radius;
        let from_centre = from - cluster.centre;
        let is_far = |offset: f64| (from_centre + offset).abs() >= least;
        let (mut near, mut far) = (*offsets, *offsets);
        let (mut nearest, mut is_any_far) = (f64::INFINITY, false);
        for i in 0..N {
            if is_far(offsets[i]) {
                is_any_far = true;
                nearest = nearest.min((from_centre + offsets[i]).abs());
                near[i] = -from_centre;
            } else {
                far[i] = 2.0 * least - from_centre;
            }
        }
        let index = cluster.first;
        let panel = &self.panels[index];
        let mut seen = Distances { from_left: near, to_right: near };
        let (from_left, to_right) = (from - panel.left, panel.right - from);
        for i in 0..N {
            seen.from_left[i] += from_left;
            seen.to_right[i] = to_right - seen.to_right[i];
        }
        let mut found = self.recurrence.potentials(panel, self.scales[index], &seen);
        if is_any_far {
            let nearest = nearest.min(2.0 * least);
            let singularity = self.kernel.singularity();
            let total = self.largest_mass();
            let other = cluster.potentials(singularity, from_centre, &far, nearest, total);
            for i in 0..N {
                if is_far(offsets[i]) {
                    found[0][i] = other[0][i];
                    found[1][i] = other[1][i];
                }
            }
        }
        found
    }

    fn largest_mass(&self) -> f64 {
        self.clusters.last().map_or(0.0, |root| root.mass)
    }

    /// Calls `visit(distance, mass, largest, length)` for parts of the density, with the least distance of `x` from each; parts nearer than their own length are single panels.
    pub(crate) fn parts(&self, x: f64, visit: &mut impl FnMut(f64, f64, f64, f64)) {
        if self.panels.is_empty() {
            return;
        }
        let images: &[f64] = match self.kernel {
            Kernel::Row { period } => &[0.0, -period, period],
            Kernel::Logarithm
            | Kernel::ShiftedLogarithm { .. }
            | Kernel::Layered(_)
            | Kernel::Power { .. } => &[0.0],
        };
        for image in images {
            self.visit(self.clusters.len() - 1, x + image, visit);
        }
    }

    fn visit(&self, index: usize, x: f64, visit: &mut impl FnMut(f64, f64, f64, f64)) {
        let cluster = &self.clusters[index];
        let distance = ((x - cluster.centre).abs() - cluster.radius).max(0.0);
        if distance >= cluster.radius {
            visit(distance, cluster.mass, cluster.largest, 2.0 * cluster.radius);
            return;
        }
        if let Some(children) = cluster.children {
            children.into_iter().for_each(|child| self.visit(child, x, visit));
            return;
        }
        for panel in &self.panels[cluster.first..cluster.last] {
            let distance = ((x - panel.middle()).abs() - panel.half()).max(0.0);
            visit(distance, panel.mass(), panel.largest, 2.0 * panel.half());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::legendre::ORDER;
    use crate::sum::two_sum;

    /// The panels of `tests/data/make.py`.
    fn panels() -> Vec<Panel> {
        let mut ends = vec![-1.0];
        ends.extend((1..=20).rev().map(|k| -1.0 + 0.25f64.powi(k)));
        ends.extend([0.0, 0.5]);
        ends.extend((1..=20).map(|k| 1.0 - 0.25f64.powi(k)));
        ends.push(1.0);
        (ends.windows(2).enumerate())
            .map(|(j, pair)| {
                let mut coefficients = [0.0; ORDER];
                for (k, c) in coefficients.iter_mut().enumerate() {
                    let sign = if (k * (k + 1) / 2) % 2 == 1 { -1.0 } else { 1.0 };
                    *c = sign * (1.0 + j as f64 / 64.0) * 0.125f64.powi(k as i32);
                }
                Panel::new(pair[0], pair[1], coefficients)
            })
            .collect()
    }

    /// The distance of a number from one of 25 digits, which is read in two parts.
    pub(crate) fn off(found: f64, digits: &str) -> f64 {
        let nearest: f64 = digits.parse().unwrap();
        // What the nearest number leaves is at most half of its last place.
        let (difference, lost) = two_sum(found, -nearest);
        (difference + lost).abs() + UNIT * nearest.abs()
    }

    #[test]
    fn potentials_are_as_exact_as_they_say() {
        let mut worst = 0.0f64;
        for line in include_str!("../tests/data/potentials.csv").lines() {
            let row: Vec<&str> = line.split(',').collect();
            let [mu, x]: [f64; 2] = [row[0].parse().unwrap(), row[1].parse().unwrap()];
            let (kernel, sign) = if mu == 0.0 {
                (Kernel::Logarithm, -1.0)
            } else {
                (Kernel::Power { exponent: mu }, 1.0)
            };
            let density = Density::new(kernel, panels());
            let (potential, rounding) = density.potential(x);
            let error = off(sign * potential, row[2]);
            worst = worst.max(error / rounding);
            assert!(error <= rounding, "mu {mu}, x {x}: off by {error:e}, said {rounding:e}");
            // Of some forty roundings at most: the bound is no idle one.
            assert!(rounding <= 100.0 * UNIT * (4.0 / (1.0 - mu)), "mu {mu}, x {x}: {rounding:e}");
            let (value, rounding) = density.value(x);
            let error = off(value, row[3]);
            assert!(
                error <= rounding + UNIT * value.abs(),
                "{x}: off by {error:e}, said {rounding:e}"
            );
        }
        println!("largest share of the bound: {worst}");
    }

    #[test]
    fn places_between_numbers_of_the_machine_are_no_less_exact() {
        let mut steep = 0;
        for line in include_str!("../tests/data/between.csv").lines() {
            let row: Vec<&str> = line.split(',').collect();
            let [mu, from, offset]: [f64; 3] = std::array::from_fn(|i| row[i].parse().unwrap());
            let (kernel, sign) = if mu == 0.0 {
                (Kernel::Logarithm, -1.0)
            } else {
                (Kernel::Power { exponent: mu }, 1.0)
            };
            let density = Density::new(kernel, panels());
            let places = Places { from, offsets: &[offset] };
            let mut found = [(0.0, 0.0)];
            density.potentials(&places, &mut found);
            let [(potential, rounding)] = found;
            let error = off(sign * potential, row[3]);
            assert!(error <= rounding, "{line}: off by {error:e}, said {rounding:e}");
            let (value, rounding) = density.values(&places)[0];
            let error = off(value, row[4]);
            assert!(
                error <= rounding + UNIT * value.abs(),
                "{line}: off by {error:e}, said {rounding:e}"
            );
            steep += usize::from(off(density.value(from + offset).0, row[4]) > 100.0 * rounding);
        }
        assert!(steep > 10, "at numbers of the machine the density is hardly another: {steep}");
    }

    /// What is assumed of the machine's functions: errors of at most one unit in the last place.
    #[test]
    fn logarithms_and_powers_are_as_exact_as_assumed() {
        for line in include_str!("../tests/data/functions.csv").lines() {
            let row: Vec<&str> = line.split(',').collect();
            let x: f64 = row[0].parse().unwrap();
            for (found, digits) in [(x.ln(), row[1]), (x.powf(0.3), row[2]), (x.powf(1.7), row[3])]
            {
                let nearest: f64 = digits.parse().unwrap();
                assert!(
                    (found - nearest).abs() <= 2.0 * UNIT * nearest.abs(),
                    "{x}: {found} {digits}"
                );
            }
        }
    }
}
