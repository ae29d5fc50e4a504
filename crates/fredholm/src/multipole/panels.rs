//! Panels with Gauss nodes.

use std::ops::Range;

use super::kernel::PanelKernel;
use super::on_panel::OnPanel;
use super::rule::{MOST, PanelRule};
use super::threads::{each, parts_of};
use crate::Error;
use crate::linear::vectorised;

/// Multiplications for each node of a panel that a value between them takes, about: a quotient is worth several.
const INTERPOLATION: usize = 8;

/// A place that is this share of a panel from its end lies at it: where a contact ends is known to less than how the pressure goes there.
const AT_END: f64 = 1.0 / 16.0;

/// The rounding of a place and of where a panel sees it.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Disjoint panels of `[-1, 1]` from left to right, each with the same number of Gauss nodes, for functions that are a polynomial on each.
#[derive(Debug, Clone)]
pub struct Panels {
    pub(super) rule: PanelRule,
    pub(super) bounds: Vec<[f64; 2]>,
    nodes: Vec<f64>,
    weights: Vec<f64>,
    /// Whether places are distances from an axis, and integrals over `s ds`.
    pub(super) are_rings: bool,
}

impl Panels {
    /// The panels `[left, right]` with `order` nodes each.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless there are panels, in order, disjoint and in `[-1, 1]`, and `2 <= order <= 32`.
    pub fn new(bounds: Vec<[f64; 2]>, order: usize) -> Result<Self, Error> {
        let invalid =
            |name, value, requirement| Error::InvalidParameter { name, value, requirement };
        if !(2..=MOST).contains(&order) {
            return Err(invalid("number of nodes of a panel", order as f64, "between 2 and 32"));
        }
        let mut end = -1.0;
        for [left, right] in &bounds {
            if !(*left >= end && right > left && *right <= 1.0) {
                let requirement = "right of the one before, in [-1, 1]";
                return Err(invalid("end of a panel", *right, requirement));
            }
            end = *right;
        }
        if bounds.is_empty() {
            return Err(invalid("number of panels", 0.0, "at least 1"));
        }
        let rule = PanelRule::new(order)?;
        let mut nodes = Vec::with_capacity(order * bounds.len());
        let mut weights = Vec::with_capacity(order * bounds.len());
        for [left, right] in &bounds {
            let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
            nodes.extend(rule.nodes.iter().map(|y| middle + half * y));
            weights.extend(rule.weights.iter().map(|w| half * w));
        }
        Ok(Self { rule, bounds, nodes, weights, are_rings: false })
    }

    /// The same as rings about an axis, of radii in `[0, 1]`, with integrals over `s ds`.
    ///
    /// # Errors
    /// Those of [`Panels::new`]; [`Error::InvalidParameter`] for panels that begin below 0.
    pub fn about_axis(bounds: Vec<[f64; 2]>, order: usize) -> Result<Self, Error> {
        let mut panels = Self::new(bounds, order)?;
        let [first, _] = panels.bounds[0];
        if first < 0.0 {
            let (name, requirement) = ("begin of the first ring", "at least 0");
            return Err(Error::InvalidParameter { name, value: first, requirement });
        }
        panels.weights.iter_mut().zip(&panels.nodes).for_each(|(weight, s)| *weight *= s);
        panels.are_rings = true;
        Ok(panels)
    }

    /// The radius of a panel that begins at the axis.
    pub(super) fn radius_from_axis(&self, panel: usize) -> Option<f64> {
        let [left, right] = self.bounds[panel];
        (self.are_rings && left == 0.0).then_some(right)
    }

    /// Number of nodes of each panel.
    #[must_use]
    pub fn order(&self) -> usize {
        self.rule.order()
    }

    /// The ends of the panels.
    #[must_use]
    pub fn bounds(&self) -> &[[f64; 2]] {
        &self.bounds
    }

    /// All nodes from left to right.
    #[must_use]
    pub fn nodes(&self) -> &[f64] {
        &self.nodes
    }

    /// Weights of the nodes: `sum w_j phi(x_j)` is the integral over all panels, of rings over `s ds`.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Number of nodes.
    #[must_use]
    pub fn count(&self) -> usize {
        self.nodes.len()
    }

    /// Values at the nodes times their weights.
    pub(super) fn charges(&self, values: &[f64]) -> Vec<f64> {
        self.weights.iter().zip(values).map(|(w, value)| w * value).collect()
    }

    /// Whether they cover `[-1, 1]` without a gap.
    pub(super) fn are_whole(&self) -> bool {
        let joined = self.bounds.windows(2).all(|pair| pair[0][1] == pair[1][0]);
        joined && self.bounds[0][0] == -1.0 && self.bounds[self.bounds.len() - 1][1] == 1.0
    }

    /// The panels with some of these nodes.
    pub(super) fn touched(&self, nodes: &Range<usize>) -> &[[f64; 2]] {
        let panels = nodes.start / self.order()..nodes.end.div_ceil(self.order());
        self.bounds.get(panels).unwrap_or_default()
    }

    /// Middle and half the length of a panel.
    pub(super) fn middle(&self, panel: usize) -> (f64, f64) {
        let [left, right] = self.bounds[panel];
        (0.5 * (left + right), 0.5 * (right - left))
    }

    /// The distance from the middle of a panel up to which its nodes alone do not integrate the kernel, or a little more.
    pub(super) fn reach(&self, panel: usize) -> f64 {
        let (_, half) = self.middle(panel);
        self.rule.far * half + ROUNDING
    }

    /// Where a place lies on a panel or beside it.
    pub(super) fn local(&self, kernel: &PanelKernel, panel: usize, x: f64) -> OnPanel {
        let [left, right] = self.bounds[panel];
        let (_, half) = self.middle(panel);
        OnPanel::new(kernel.shortest(x - left) / half, -kernel.shortest(x - right) / half)
    }

    /// The panel that ends at a place, where one does and no other begins, with the side of that end.
    pub(super) fn ending_at(&self, x: f64) -> Option<(usize, usize)> {
        let after = self.bounds.partition_point(|[left, right]| left + right < 2.0 * x);
        let off = |(panel, side): (usize, usize)| {
            let ends = self.bounds.get(panel)?;
            Some((ends[side] - x).abs() / (ends[1] - ends[0]))
        };
        let sides = [after.checked_sub(1).map(|panel| (panel, 1)), Some((after, 0))];
        let mut ending =
            sides.into_iter().flatten().filter(|at| off(*at).is_some_and(|off| off <= AT_END));
        ending.next().filter(|_| ending.next().is_none())
    }

    /// The panel that holds a place.
    #[must_use]
    pub fn find(&self, x: f64) -> Option<usize> {
        let panel = self.bounds.partition_point(|[_, right]| *right < x);
        self.bounds.get(panel).filter(|[left, _]| *left <= x).map(|_| panel)
    }

    /// The function of these values at the nodes at any place of the panels; none beside them.
    #[must_use]
    pub fn interpolate(&self, values: &[f64], x: f64) -> Option<f64> {
        self.interpolate_on(self.find(x)?, values, x)
    }

    /// The same at many places, which are soonest found in order.
    #[must_use]
    pub fn interpolate_all(&self, values: &[f64], places: &[f64]) -> Vec<Option<f64>> {
        let mut found = vec![None; places.len()];
        let work = INTERPOLATION * self.order() * places.len();
        let share = places.len().div_ceil(parts_of(work)).max(1);
        let parts = places.chunks(share).zip(found.chunks_mut(share));
        each(parts.collect(), |(places, found)| {
            vectorised(
                #[inline(always)]
                || {
                    let mut panel = 0;
                    for (x, found) in places.iter().zip(found) {
                        panel = self.first_not_left_of(*x, panel);
                        *found = self.interpolate_on(panel, values, *x);
                    }
                },
            );
        });
        found
    }

    /// The first panel that ends at a place or right of it, often that one or the next.
    #[inline(always)]
    fn first_not_left_of(&self, x: f64, near: usize) -> usize {
        let ends = |panel: usize| self.bounds.get(panel).is_none_or(|[_, right]| *right >= x);
        let begins = |panel: usize| panel == 0 || !ends(panel - 1);
        let is_first = |panel: &usize| begins(*panel) && ends(*panel);
        let known = [near, near + 1].into_iter().find(is_first);
        known.unwrap_or_else(|| self.bounds.partition_point(|[_, right]| *right < x))
    }

    #[inline(always)]
    fn interpolate_on(&self, panel: usize, values: &[f64], x: f64) -> Option<f64> {
        self.bounds.get(panel).filter(|[left, right]| *left <= x && x <= *right)?;
        let y = self.local(&PanelKernel::Logarithm, panel, x).z;
        let values = values.get(panel * self.order()..(panel + 1) * self.order())?;
        Some(self.rule.interpolate(values, y))
    }

    /// The derivatives at the nodes of the function of these values there, on each panel by itself. Missing values are zero, others ignored.
    #[must_use]
    pub fn derivatives(&self, values: &[f64]) -> Vec<f64> {
        let mut values = values.to_vec();
        values.resize(self.count(), 0.0);
        let mut derivatives = vec![0.0; self.count()];
        let parts =
            derivatives.chunks_exact_mut(self.order()).zip(values.chunks_exact(self.order()));
        for (panel, (slopes, values)) in parts.enumerate() {
            self.rule.derivatives(values, slopes);
            let (_, half) = self.middle(panel);
            slopes.iter_mut().for_each(|slope| *slope /= half);
        }
        derivatives
    }

    /// The limits of the function of these values at both ends of each panel.
    #[must_use]
    pub fn limits(&self, values: &[f64]) -> Vec<[f64; 2]> {
        let parts = values.chunks_exact(self.order()).take(self.bounds.len());
        parts.map(|values| [-1.0, 1.0].map(|y| self.rule.interpolate(values, y))).collect()
    }

    /// `sum w_j f(x_j) phi_j`.
    #[must_use]
    pub fn integral(&self, values: &[f64], f: impl Fn(f64) -> f64) -> f64 {
        let terms = self.nodes.iter().zip(&self.weights).zip(values);
        terms.map(|((x, w), value)| w * f(*x) * value).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_and_limits_of_polynomials_are_exact() {
        let panels = Panels::new(vec![[-0.9, -0.3], [-0.3, 0.1], [0.4, 0.41]], 6).unwrap();
        let f = |x: f64| x.powi(5) - 3.0 * x * x + 0.2;
        let slope = |x: f64| 5.0 * x.powi(4) - 6.0 * x;
        let values: Vec<f64> = panels.nodes().iter().map(|x| f(*x)).collect();
        for (x, found) in panels.nodes().iter().zip(panels.derivatives(&values)) {
            assert!((found - slope(*x)).abs() < 1e-11, "{x}: {found}");
        }
        for (bounds, limits) in panels.bounds().iter().zip(panels.limits(&values)) {
            for (x, found) in bounds.iter().zip(limits) {
                assert!((found - f(*x)).abs() < 1e-14, "{x}: {found}");
            }
        }
        assert_eq!(panels.derivatives(&[]), vec![0.0; panels.count()]);
        assert!(panels.limits(&[]).is_empty());
    }

    #[test]
    fn many_places_give_what_each_gives_in_any_order() {
        let panels = Panels::new(vec![[-0.9, -0.3], [-0.3, 0.1], [0.4, 0.41]], 6).unwrap();
        let values: Vec<f64> = panels.nodes().iter().map(|x| x.sin()).collect();
        let mut places: Vec<f64> = (-1000..=1000).map(|k| f64::from(k) / 1000.0).collect();
        places.extend(panels.nodes());
        places.extend([f64::NAN, 2.0, -0.3, 0.41, f64::INFINITY, -0.9, -5.0]);
        // So many that they are done in parts, and now and then one far from the one before.
        let places: Vec<f64> = (0..20_000).map(|k| places[k * k % places.len()]).collect();
        for (x, found) in places.iter().zip(panels.interpolate_all(&values, &places)) {
            assert_eq!(found, panels.interpolate(&values, *x), "{x}");
            assert_eq!(found.is_some(), panels.find(*x).is_some(), "{x}");
            assert!(found.is_none_or(|found| (found - x.sin()).abs() < 1e-7), "{x}: {found:?}");
        }
        assert!(panels.interpolate_all(&values[..3], &[0.0, -0.5]).iter().all(Option::is_none));
    }
}
