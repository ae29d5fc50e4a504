//! Panels, and the potentials of densities on them by quadrature that is graded towards the singularity of the kernel.

use crate::kernel::Kernel;
use crate::rule::Rule;

/// Places of a panel at which two resolutions are compared: between its nodes and towards its ends, where they differ most.
pub(crate) const BESIDE: [f64; 6] = [-0.997, -0.93, -0.4, 0.41, 0.94, 0.998];

/// What the variable `u` of a panel is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Chart {
    /// `s = u`.
    Line,
    /// `s = c - h cos u`, `0 <= u <= pi`: the density with respect to `u` is smooth at ends where that with respect to `s` is one over a square root.
    Angle { centre: f64, half: f64 },
}

impl Chart {
    pub(crate) fn position(self, u: f64) -> f64 {
        match self {
            Self::Line => u,
            Self::Angle { centre, half } => centre - half * u.cos(),
        }
    }

    /// `u` of a position.
    pub(crate) fn variable(self, x: f64) -> f64 {
        match self {
            Self::Line => x,
            Self::Angle { centre, half } => ((centre - x) / half).clamp(-1.0, 1.0).acos(),
        }
    }

    /// `s(u + e) - s(u)` with the digits of `e`.
    fn step(self, u: f64, e: f64) -> f64 {
        match self {
            Self::Line => e,
            Self::Angle { half, .. } => 2.0 * half * (u + 0.5 * e).sin() * (0.5 * e).sin(),
        }
    }

    /// `ds/du`.
    pub(crate) fn rate(self, u: f64) -> f64 {
        match self {
            Self::Line => 1.0,
            Self::Angle { half, .. } => half * u.sin(),
        }
    }
}

/// A place `u = anchor + offset` of a chart; beside its anchor it has all digits of the offset.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub(crate) chart: Chart,
    pub(crate) anchor: f64,
    pub(crate) offset: f64,
}

impl Place {
    pub(crate) fn on_line(x: f64) -> Self {
        Self { chart: Chart::Line, anchor: x, offset: 0.0 }
    }

    pub(crate) fn u(&self) -> f64 {
        self.anchor + self.offset
    }

    pub(crate) fn x(&self) -> f64 {
        self.chart.position(self.u())
    }
}

/// An interval of a chart, from `anchor + from` to `anchor + to`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Panel {
    pub(crate) chart: Chart,
    pub(crate) anchor: f64,
    pub(crate) from: f64,
    pub(crate) to: f64,
}

impl Panel {
    pub(crate) fn half(&self) -> f64 {
        0.5 * (self.to - self.from)
    }

    /// The place at `t` in `[-1, 1]`.
    pub(crate) fn at(&self, t: f64) -> Place {
        let offset = 0.5 * (self.from + self.to) + self.half() * t;
        Place { chart: self.chart, anchor: self.anchor, offset }
    }
}

/// A panel seen from a target.
struct View<'a> {
    kernel: &'a Kernel<'a>,
    constants: [f64; 3],
    panel: &'a Panel,
    target: Place,
    x: f64,
    /// Whether target and panel share a chart: distances then keep their digits.
    is_near: bool,
    /// Ends of the panel in `e = u - u(target)`, or in `u - u(start)` where the charts differ.
    ends: [f64; 2],
    /// Subintervals are no shorter than that.
    least: f64,
    rule: &'a Rule,
}

impl View<'_> {
    /// `s - x`.
    fn distance(&self, e: f64) -> f64 {
        if self.is_near {
            return self.target.chart.step(self.target.u(), e);
        }
        self.panel.chart.position(self.panel.anchor + self.panel.from + e) - self.x
    }

    /// Hands over nodes `t` of the panel with their weights times the kernel, one subinterval of `e` from `start` to `end` after the other.
    fn visit(&self, [start, end]: [f64; 2], take: &mut dyn FnMut(&Part)) {
        if self.is_near && start < 0.0 && 0.0 < end {
            self.visit([start, 0.0], take);
            self.visit([0.0, end], take);
            return;
        }
        let [near, far] = [self.distance(start), self.distance(end)];
        let [first, second] = self.kernel.images(self.x);
        let singular = [0.0, first, second];
        let gap = singular.into_iter().fold(f64::INFINITY, |least, place| {
            least.min((near - place).max(place - far).max(0.0))
        });
        let distance_of = |d: f64| {
            singular.into_iter().fold(f64::INFINITY, |least, place| least.min((d - place).abs()))
        };
        let is_first_nearer = distance_of(near) < distance_of(far);
        // What is left beside a singularity is then as long as it may be.
        let share = 1.0 / (1.0 + LONGEST);
        let cut = if is_first_nearer {
            start + share * (end - start)
        } else {
            end - share * (end - start)
        };
        // Beside an image of the target, which is no origin of e, subintervals end with the numbers of the machine.
        let is_divisible = end - start > self.least && start < cut && cut < end;
        if far - near > LONGEST * gap && is_divisible {
            // Small parts first: sums lose fewer digits.
            let mut parts = [[start, cut], [cut, end]];
            if !is_first_nearer {
                parts.reverse();
            }
            parts.into_iter().for_each(|part| self.visit(part, take));
            return;
        }
        let half = 0.5 * (end - start);
        let whole = self.ends[1] - self.ends[0];
        let mut part = Part {
            places: [0.0; QUADRATURE],
            weights: [0.0; QUADRATURE],
            is_whole: [start, end] == self.ends,
        };
        for (i, (node, weight)) in self.rule.nodes.iter().zip(&self.rule.weights).enumerate() {
            let e = 0.5 * (start + end) + half * node;
            part.places[i] = ((e - self.ends[0]) - (self.ends[1] - e)) / whole;
            let value = self.kernel.value_with(&self.constants, self.x, self.distance(e));
            part.weights[i] = half * weight * value;
        }
        take(&part);
    }
}

/// Nodes of the quadrature on a subinterval.
pub(crate) const QUADRATURE: usize = 24;
/// Subintervals are no longer than so many times their distance from what is not smooth in the kernel.
///
/// At 2 that lies on the ellipse `rho = 2 + sqrt(3)` about the subinterval, so that 24 nodes integrate the kernel times a polynomial of degree 20 to `rho^(20 - 48) = 1e-16`.
const LONGEST: f64 = 2.0;

/// A subinterval of a panel: its nodes as places `t` in `[-1, 1]` of the panel, and their weights times the kernel.
pub(crate) struct Part {
    pub(crate) places: [f64; QUADRATURE],
    pub(crate) weights: [f64; QUADRATURE],
    /// Whether it is the whole panel.
    pub(crate) is_whole: bool,
}

/// Hands over places `t` of a panel and weights with which a density there adds to the potential at a target, one subinterval after the other, to be summed one by one. `rule` is the quadrature, with more nodes than the density has.
pub(crate) fn visit(
    kernel: &Kernel<'_>,
    panel: &Panel,
    target: Place,
    rule: &Rule,
    take: &mut dyn FnMut(&Part),
) {
    let is_near = panel.chart == target.chart;
    let start = (panel.anchor - target.anchor) + (panel.from - target.offset);
    let end = (panel.anchor - target.anchor) + (panel.to - target.offset);
    let ends = if is_near { [start, end] } else { [0.0, panel.to - panel.from] };
    // What is left out of int d^-mu is least^(1-mu).
    let least = 1e-18f64.powf(1.0 / (1.0 - kernel.exponent())).max(1e-280);
    let least = least * (panel.to - panel.from);
    let constants = kernel.constants();
    let view = View { kernel, constants, panel, target, x: target.x(), is_near, ends, least, rule };
    view.visit(ends, take);
}

/// The potential `int K(x, s) p(s) dm(s)` at any `x` of a density on panels given by their ends, on each of which it is as smooth as a polynomial of degree 20.
///
/// Plain Gauss-Legendre quadrature with 24 nodes on subintervals that are no longer than twice their distance from `x` (and from its images in a row or a disk), so that an integrable
/// singularity is integrated to rounding with nothing but values of the kernel.
#[must_use]
pub fn potential(
    kernel: &Kernel<'_>,
    panels: &[[f64; 2]],
    density: &dyn Fn(f64) -> f64,
    x: f64,
) -> f64 {
    let rule = Rule::new(QUADRATURE);
    let of_panel = |[left, right]: &[f64; 2]| {
        let panel = Panel { chart: Chart::Line, anchor: *left, from: 0.0, to: right - left };
        let mut sum = 0.0;
        visit(kernel, &panel, Place::on_line(x), &rule, &mut |part| {
            let at = |t: f64| density(left + panel.half() * (1.0 + t));
            sum += part
                .places
                .iter()
                .zip(&part.weights)
                .map(|(t, weight)| weight * at(*t))
                .sum::<f64>();
        });
        sum
    };
    panels.iter().map(of_panel).sum()
}
