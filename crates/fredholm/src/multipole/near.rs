//! Products of the kernel with the polynomials of panels at nodes near to them, row by row.

use std::ops::Range;

use super::boxes::Part;
use super::kernel::PanelKernel;
use super::on_panel::OnPanel;
use super::panels::Panels;

/// A node lies where it would on its panel, or beside one of the same length, if that changes the potential of the panel by no more than so many units of the machine, and if it is off by no more of half a panel
/// than what its polynomials lose anyway. All panels then see it at one place: the potentials of two that meet are smooth only together.
const PLACED: f64 = 4.0 * f64::EPSILON;
const FAINT: f64 = 1e-9;

/// The entries of nodes for nodes near to them. Panels of one length side by side have the same ones: those are known from the start.
pub(super) struct NearEntries<'p> {
    kernel: &'p PanelKernel,
    panels: &'p Panels,
    /// The weights of a panel for the nodes of those that are `-most` to `most` of its lengths away, its own ones in the middle.
    tables: Vec<Vec<f64>>,
    /// The factor of the moments on each panel, and what is added to the kernel there.
    scales: Vec<[f64; 2]>,
}

/// A panel near to a node.
#[derive(Clone, Copy)]
enum Near {
    /// So far away that its nodes integrate the kernel.
    Plain,
    /// On the panel, or a multiple of its length beside it.
    Known { table: usize, row: usize },
    /// At this place of the panel, or beside it.
    At(OnPanel),
    /// At this multiple of the radius of a panel that begins at the axis, and so far beyond it.
    FromAxis([f64; 2]),
}

impl<'p> NearEntries<'p> {
    pub(super) fn new(kernel: &'p PanelKernel, panels: &'p Panels) -> Self {
        let most = (0.5 * (panels.rule.far + 1.0)).ceil() as i32;
        let tables = (-most..=most).map(|m| panels.rule.beside(kernel, m)).collect();
        let halves = (0..panels.bounds().len()).map(|panel| panels.middle(panel).1);
        let scales = halves.map(|half| kernel.scale(half)).collect();
        Self { kernel, panels, tables, scales }
    }

    /// The rows of nodes for those in `near`, one after the other; for what boxes have as well, what they lack.
    pub(super) fn fill(&self, nodes: Range<usize>, near: &[Part], rows: &mut [f64]) {
        let length: usize = near.iter().map(|part| part.nodes.len()).sum();
        let places = self.panels.nodes();
        let mut found = Vec::new();
        // All distances first: their logarithms are taken side by side.
        for (node, row) in nodes.clone().zip(rows.chunks_exact_mut(length.max(1))) {
            let x = places[node];
            let mut row = row;
            for Part { nodes: part, is_far } in near {
                let (own, rest) = row.split_at_mut(part.len());
                for panel in self.panels_of(part) {
                    let near = self.near(panel, node);
                    let is_plain = matches!(near, Near::Plain);
                    let inside = self.inside(panel, part);
                    let entries = &mut own[inside.start - part.start..inside.end - part.start];
                    if is_plain != *is_far {
                        let others = entries.iter_mut().zip(&places[inside]);
                        others.for_each(|(entry, s)| [*entry, _] = self.kernel.apart(x, *s));
                    } else {
                        // Any that has a logarithm.
                        entries.fill(1.0);
                    }
                    found.push(near);
                }
                row = rest;
            }
        }
        self.kernel.values(rows);
        let mut found = found.into_iter();
        for (node, row) in nodes.zip(rows.chunks_exact_mut(length.max(1))) {
            let mut row = row;
            for Part { nodes: part, is_far } in near {
                let (own, rest) = row.split_at_mut(part.len());
                for (panel, near) in self.panels_of(part).zip(&mut found) {
                    let inside = self.inside(panel, part);
                    let entries = &mut own[inside.start - part.start..inside.end - part.start];
                    match (near, is_far) {
                        (Near::Plain, true) => entries.fill(0.0),
                        (_, true) => {
                            let mut plain = entries.to_vec();
                            self.finish((panel, node), Near::Plain, &inside, &mut plain);
                            self.finish((panel, node), near, &inside, entries);
                            entries.iter_mut().zip(plain).for_each(|(entry, has)| *entry -= has);
                        }
                        _ => self.finish((panel, node), near, &inside, entries),
                    }
                }
                row = rest;
            }
        }
    }

    /// From values of the kernel to entries.
    fn finish(
        &self,
        (panel, node): (usize, usize),
        near: Near,
        inside: &Range<usize>,
        entries: &mut [f64],
    ) {
        let order = self.panels.order();
        let weights = &self.panels.weights()[inside.clone()];
        let x = self.panels.nodes()[node];
        let places = &self.panels.nodes()[inside.clone()];
        let mut found = [0.0; super::rule::MOST];
        let exact = match near {
            Near::Plain => {
                entries.iter_mut().zip(weights).for_each(|(entry, weight)| *entry *= weight);
                if self.kernel.rings().is_some() {
                    let others = entries.iter_mut().zip(places);
                    others.for_each(|(entry, s)| *entry *= self.kernel.apart(x, *s)[1]);
                }
                return;
            }
            Near::FromAxis(x) => {
                if let Some(rings) = self.kernel.rings() {
                    self.panels.rule.weights_from_axis(rings, x, &mut found[..order]);
                }
                let [_, radius] = self.panels.bounds()[panel];
                let exact = &found[inside.start - panel * order..inside.end - panel * order];
                let scale = radius.powf(1.0 - self.kernel.exponent());
                entries.iter_mut().zip(exact).for_each(|(entry, exact)| *entry = scale * exact);
                return;
            }
            Near::Known { table, row } => &self.tables[table][row * order..(row + 1) * order],
            Near::At(place) => {
                self.panels.rule.weights_at(self.kernel, place, &mut found[..order]);
                &found[..order]
            }
        };
        let [factor, level] = self.scales[panel];
        let exact = &exact[inside.start - panel * order..inside.end - panel * order];
        for (((entry, exact), weight), place) in
            entries.iter_mut().zip(exact).zip(weights).zip(places)
        {
            *entry = self.kernel.entry((x, *place), factor * exact, level, *weight);
        }
    }

    fn panels_of(&self, nodes: &Range<usize>) -> Range<usize> {
        let order = self.panels.order();
        nodes.start / order..nodes.end.div_ceil(order)
    }

    /// The nodes of a panel that are among these.
    fn inside(&self, panel: usize, nodes: &Range<usize>) -> Range<usize> {
        let order = self.panels.order();
        (panel * order).max(nodes.start)..((panel + 1) * order).min(nodes.end)
    }

    /// Where a node lies, seen from a panel.
    fn near(&self, panel: usize, node: usize) -> Near {
        let (rule, order) = (&self.panels.rule, self.panels.order());
        let (row, middle) = (node % order, self.tables.len() / 2);
        let x = self.panels.nodes()[node];
        let place = self.panels.local(self.kernel, panel, x);
        let z = place.z;
        if z.abs() >= rule.far {
            return Near::Plain;
        }
        if let Some(radius) = self.panels.radius_from_axis(panel) {
            return Near::FromAxis([x, x - radius].map(|distance| distance / radius));
        }
        let lengths = (0.5 * (z - rule.nodes[row])).round();
        let off = (z - rule.nodes[row] - 2.0 * lengths).abs();
        let table = middle as f64 + lengths;
        // The potential of a panel goes with this power of its length.
        let is_placed = || off * self.scales[panel][0] <= PLACED && off <= FAINT;
        let is_known =
            (0.0..self.tables.len() as f64).contains(&table) && (off <= PLACED || is_placed());
        if is_known { Near::Known { table: table as usize, row } } else { Near::At(place) }
    }
}
