//! The base, the rough layer and the body, as lines.

use shtaerman::{Contact, Geometry, Law, Punch};

/// How far beside the punch the surface is drawn, in half-widths.
const MARGIN: f64 = 0.6;
/// Places beside the punch on either side.
const BESIDE: i32 = 60;
/// The most periods that are drawn on either side of the middle of a window.
const MOST_AROUND: f64 = 60.0;
/// The free thickness of the layer beside the largest compression, and the least beside the range of depths, so that it can be seen.
const FREE: f64 = 1.25;
const LEAST: f64 = 0.05;

/// Lines of what is pressed together, broken where there is none; in the units of the problem.
pub(super) struct Surfaces {
    /// Depth of the base.
    pub(super) base: Vec<(f64, f64)>,
    /// Upper and lower side of the rough layer.
    pub(super) layer: Vec<(f64, f64, f64)>,
    /// Surface of the elastic body, below the layer.
    pub(super) body: Vec<(f64, f64)>,
    /// Edges of the punch; a wave has none.
    pub(super) edges: Vec<f64>,
    /// Thickness that the layer is drawn with where it is free; none for a smooth surface.
    pub(super) thickness: Option<f64>,
    /// What is repeated by how much.
    shifts: Vec<f64>,
    reach: [f64; 2],
    pieces: Vec<[f64; 2]>,
}

/// What is found at a place.
#[derive(Clone, Copy)]
struct At {
    x: f64,
    /// The base, where there is one.
    base: f64,
    /// The elastic surface without the layer.
    surface: f64,
    touches: bool,
}

impl Surfaces {
    /// At these places under the base and at some beside it, within the window.
    pub(super) fn new(contact: &Contact, places: &[f64], window: Option<[f64; 2]>) -> Self {
        let punch = contact.problem().punch();
        let half_width = punch.half_width();
        let pieces: Vec<[f64; 2]> =
            punch.pieces().iter().map(|piece| piece.map(|xi| xi * half_width)).collect();
        let usual = match punch.geometry() {
            Geometry::Periodic { period } => period,
            _ => (1.0 + MARGIN) * half_width,
        };
        let reach = match window {
            Some([left, right]) => [left.min(-usual), right.max(usual)],
            None => [-usual, usual],
        };
        let shifts = shifts(punch, window);
        let is_wave = punch.geometry().is_wave(half_width);
        let mut lines = Self {
            base: Vec::new(),
            layer: Vec::new(),
            body: Vec::new(),
            edges: Vec::new(),
            thickness: None,
            shifts,
            reach,
            pieces,
        };
        if !is_wave {
            let edges = lines.pieces.iter().flatten().copied();
            let edges: Vec<f64> = edges.collect();
            lines.edges = lines.shifted(&edges);
        }
        let found = lines.found(contact, places, window);
        let shown = found.iter().filter(|at| lines.is_shown(window, at.x));
        let shown = shown.copied().collect::<Vec<_>>();
        lines.thickness = thickness(contact, &shown);
        lines.draw(&found);
        lines
    }

    /// Values over the base, repeated and broken between pieces.
    pub(super) fn repeated(&self, places: &[f64], values: &[f64]) -> Vec<(f64, f64)> {
        let mut points = Vec::new();
        for shift in &self.shifts {
            for [left, right] in &self.pieces {
                let pairs = places.iter().zip(values).filter(|(x, _)| (left..=right).contains(x));
                points.extend(
                    pairs.map(|(x, value)| (x + shift, *value)).filter(|(x, _)| self.is_within(*x)),
                );
                points.push((right + shift, f64::NAN));
            }
        }
        points
    }

    /// The ends of the zones of contact, where they are not the full base, repeated.
    pub(super) fn ends(&self, contact: &Contact) -> Vec<f64> {
        if contact.dimensionless().zones() == contact.problem().punch().pieces() {
            return Vec::new();
        }
        let is_edge = |x: &f64| self.pieces.iter().flatten().any(|edge| edge == x);
        let ends: Vec<f64> =
            contact.zones().into_iter().flatten().filter(|x| !is_edge(x)).collect();
        self.shifted(&ends)
    }

    /// Whether a window shows a part of the base, and less than that is wide.
    pub(super) fn is_part(&self, [left, right]: [f64; 2]) -> bool {
        let first = self.pieces.first().map_or(0.0, |piece| piece[0]);
        let last = self.pieces.last().map_or(0.0, |piece| piece[1]);
        right - left < last - first && left < last && first < right
    }

    /// The ends of what is drawn.
    pub(super) fn reach(&self) -> [f64; 2] {
        self.reach
    }

    /// All depths that are shown.
    pub(super) fn depths(&self, window: Option<[f64; 2]>) -> Vec<f64> {
        let points = self.base.iter().chain(&self.body).filter(|point| is_in(window, point.0));
        points.map(|point| point.1).filter(|depth| depth.is_finite()).collect()
    }

    /// Whether a place, or one of its repetitions, is in a window.
    fn is_shown(&self, window: Option<[f64; 2]>, x: f64) -> bool {
        self.shifts.iter().any(|shift| is_in(window, x + shift))
    }

    fn is_within(&self, x: f64) -> bool {
        let [left, right] = self.reach;
        let slack = 1e-12 * (right - left);
        (left - slack..=right + slack).contains(&x)
    }

    fn shifted(&self, places: &[f64]) -> Vec<f64> {
        let shifted = self.shifts.iter().flat_map(|shift| places.iter().map(move |x| x + shift));
        shifted.filter(|x| self.is_within(*x)).collect()
    }

    /// Base and surface from left to right within one period.
    fn found(&self, contact: &Contact, places: &[f64], window: Option<[f64; 2]>) -> Vec<At> {
        let half_width = contact.problem().punch().half_width();
        let zones = contact.zones();
        let beside: Vec<f64> = match contact.problem().punch().geometry() {
            Geometry::Periodic { period } => {
                let gap = 0.5 * period - half_width;
                let parts = (1..=BESIDE / 2).map(|i| f64::from(2 * i) / f64::from(BESIDE));
                if gap > 0.0 {
                    parts.map(|part| half_width + gap * part).collect()
                } else {
                    Vec::new()
                }
            }
            _ => Vec::new(),
        };
        let is_repeated = self.shifts.len() > 1;
        let [to_left, to_right] = [-self.reach[0] - half_width, self.reach[1] - half_width];
        let parts = (1..=BESIDE).map(|i| (f64::from(i) / f64::from(BESIDE)).powi(2));
        let free = parts.filter(|_| !is_repeated);
        let free =
            free.flat_map(|part| [-half_width - to_left * part, half_width + to_right * part]);
        // Outside of a window a rough line is enough.
        let is_shown = |index: usize, x: f64| self.is_shown(window, x) || index.is_multiple_of(4);
        let under = places.iter().enumerate().filter(|(index, x)| is_shown(*index, **x));
        let mut all: Vec<f64> = under.map(|(_, x)| *x).collect();
        all.extend(beside.iter().flat_map(|x| [*x, -x]).chain(free));
        all.sort_by(f64::total_cmp);
        all.dedup();
        let on_base =
            |x: f64| self.pieces.iter().any(|[left, right]| (*left..=*right).contains(&x));
        all.into_iter()
            .map(|x| At {
                x,
                base: if on_base(x) { contact.base_depth(x) } else { f64::NAN },
                surface: contact.elastic_displacement(x),
                touches: on_base(x)
                    && zones.iter().any(|[left, right]| (*left..=*right).contains(&x)),
            })
            .collect()
    }

    fn draw(&mut self, found: &[At]) {
        let thickness = self.thickness.unwrap_or(0.0);
        for shift in self.shifts.clone() {
            for (index, at) in found.iter().enumerate() {
                let x = at.x + shift;
                if !self.is_within(x) {
                    continue;
                }
                let is_new_piece = index > 0
                    && self
                        .pieces
                        .iter()
                        .any(|[left, _]| found[index - 1].x < *left && *left <= at.x);
                if is_new_piece {
                    self.base.push((x, f64::NAN));
                }
                self.base.push((x, at.base));
                let lower = at.surface + thickness;
                if self.thickness.is_some() {
                    let upper = if at.touches { at.base.min(lower) } else { at.surface };
                    self.layer.push((x, upper, lower));
                }
                self.body.push((x, lower));
            }
            // What is repeated is broken nowhere but where the base is.
            if self.shifts.len() > 1 && !self.edges.is_empty() {
                self.base.push((f64::NAN, f64::NAN));
            }
        }
    }
}

fn is_in(window: Option<[f64; 2]>, x: f64) -> bool {
    window.is_none_or(|[left, right]| (left..=right).contains(&x))
}

/// By how much a periodic base is repeated: to fill a window, and, where that is not far away, a period on either side of the middle.
pub(super) fn shifts(punch: &Punch, window: Option<[f64; 2]>) -> Vec<f64> {
    let Geometry::Periodic { period } = punch.geometry() else { return vec![0.0] };
    let [mut first, mut last] = [-1.0f64, 1.0];
    if let Some([left, right]) = window {
        let middle = (left.midpoint(right) / period).round();
        let around = (0.5 * (right - left) / period).ceil().min(MOST_AROUND) + 1.0;
        [first, last] = [first.min(middle - around), last.max(middle + around)];
        if last - first > 2.0 * MOST_AROUND {
            [first, last] = [middle - around, middle + around];
        }
    }
    let count = (last - first).min(4.0 * MOST_AROUND) as i32;
    let shifts = (0..=count).map(|index| period * (first + f64::from(index)));
    shifts.filter(|shift| shift.is_finite()).collect()
}

/// The thickness that the free layer is drawn with.
fn thickness(contact: &Contact, found: &[At]) -> Option<f64> {
    if contact.problem().foundation().law() == Law::Smooth {
        return None;
    }
    let touching = found.iter().filter(|at| at.touches);
    let compression = touching.map(|at| at.base - at.surface).filter(|gap| gap.is_finite());
    let compression = compression.fold(0.0f64, f64::max);
    let depths =
        found.iter().flat_map(|at| [at.base, at.surface]).filter(|depth| depth.is_finite());
    let [low, high] = depths.fold([0.0f64, 0.0f64], |[low, high], u| [low.min(u), high.max(u)]);
    Some((FREE * compression).max(LEAST * (high - low)))
}
