//! The smooth part of a kernel, `D(t)`, as Chebyshev series on panels of `t`.

use std::sync::OnceLock;

use super::local::Local;
use super::spectrum::{Integral, Shared, Spectrum, unseen};
use crate::Error;
use crate::basis::chebyshev::{ChebyshevSeries, points};

/// The first panel of an integral; each after it is as long as all before it.
const FIRST: f64 = 2.0;
/// Degree of the series on a panel, the last coefficients of which show whether it is resolved, and to what of the largest value of all.
const DEGREE: usize = 40;
const TAIL: usize = 3;
const RESOLVED: f64 = 2e-16;
/// How often a panel may be halved.
const HALVINGS: usize = 6;
/// Places at which a given `D` is looked at between the nodes, and how far beside its series it may be there, relative to the largest value: what is narrower than their distance may be missed.
const SEEN: usize = 8192;
const BESIDE: f64 = 1e-12;
/// Tables to a larger `t` would take seconds; the leading term stands for all of an integral there.
const FARTHEST: f64 = 4096.0;

/// `D(t)`: as series up to a distance, and beyond it as it is asked for.
#[derive(Debug, Clone)]
pub(super) struct Table {
    panels: Vec<Panel>,
    /// What values may be off by, as quadrature and series show it themselves.
    unresolved: f64,
    beyond: Beyond,
}

/// `D(t)` beyond the panels.
#[derive(Clone)]
enum Beyond {
    /// The function itself.
    Itself(Shared),
    /// Further panels, made when they are asked for; none where the integral has all but fallen.
    Doubled { of: Integral, next: OnceLock<Option<Box<Table>>> },
}

impl std::fmt::Debug for Beyond {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Itself(_) => formatter.write_str("Itself"),
            Self::Doubled { of, .. } => formatter.debug_tuple("Doubled").field(of).finish(),
        }
    }
}

/// By the panels made at once.
impl PartialEq for Table {
    fn eq(&self, other: &Self) -> bool {
        self.panels == other.panels
    }
}

#[derive(Debug, Clone, PartialEq)]
struct Panel {
    left: f64,
    right: f64,
    series: ChebyshevSeries,
    /// The same in parts that are faster, where these resolve it.
    local: Option<Local>,
    /// The derivative by the place on the panel, from -1 to 1.
    derivative: ChebyshevSeries,
}

impl Table {
    /// An integral, up to the distance `far` at once.
    ///
    /// # Errors
    /// [`Error::NotFinite`] where `g` is not finite.
    pub(super) fn new(integral: Integral, far: f64) -> Result<Self, Error> {
        let mut builder =
            Builder { unresolved: unseen(&*integral.g), ..Builder::new(f64::INFINITY) };
        let (mut left, mut right) = (0.0, FIRST.min(far));
        while left < far {
            let spectrum = Spectrum::new(&*integral.g, right)?;
            builder.unresolved = builder.unresolved.max(spectrum.unresolved);
            let value = |t: f64| spectrum.at(&integral.wave, t);
            if left == 0.0 {
                builder.scale = value(0.0).abs();
            }
            builder.add(&value, [left, right], HALVINGS);
            (left, right) = (right, (2.0 * right).min(far));
        }
        Ok(builder.table(Beyond::Doubled { of: integral, next: OnceLock::new() }))
    }

    /// A function `D` itself, as series for `0 <= t <= far`.
    ///
    /// # Errors
    /// [`Error::NotFinite`] where it is not finite.
    pub(super) fn of(value: Shared, far: f64) -> Result<Self, Error> {
        let mut builder = Builder { scale: 1.0, ..Builder::new(far / SEEN as f64) };
        let mut places = (0..=SEEN).map(|i| far * i as f64 / SEEN as f64);
        if let Some(at) = places.find(|at| !value(*at).is_finite()) {
            return Err(Error::NotFinite { what: "remainder of the kernel", at, value: value(at) });
        }
        builder.add(&*value, [0.0, far], HALVINGS);
        Ok(builder.table(Beyond::Itself(value)))
    }

    /// The panels of an integral as far again as those before; none beyond the farthest.
    fn doubled(of: &Integral, far: f64) -> Option<Box<Self>> {
        // It was finite for smaller distances, at the same places and others.
        let spectrum = (2.0 * far <= FARTHEST).then(|| Spectrum::new(&*of.g, 2.0 * far).ok())??;
        let value = |t: f64| spectrum.at(&of.wave, t);
        let mut builder = Builder { scale: value(0.0).abs(), ..Builder::new(f64::INFINITY) };
        builder.add(&value, [far, 2.0 * far], HALVINGS);
        let beyond = Beyond::Doubled { of: of.clone(), next: OnceLock::new() };
        Some(Box::new(builder.table(beyond)))
    }

    /// What values may be off by, as quadrature and series show it themselves.
    pub(super) fn unresolved(&self) -> f64 {
        self.unresolved
    }

    /// The length of the shortest panel.
    pub(super) fn shortest(&self) -> f64 {
        self.panels.iter().fold(f64::INFINITY, |least, panel| least.min(panel.right - panel.left))
    }

    /// `D(t)`.
    pub(super) fn at(&self, t: f64) -> f64 {
        let Some(panel) = self.panel(t) else { return 0.0 };
        if t <= panel.right {
            let place = panel.place(t);
            return match &panel.local {
                Some(local) => local.at(place),
                None => panel.series.evaluate(place),
            };
        }
        match &self.beyond {
            Beyond::Itself(value) => value(t),
            Beyond::Doubled { of, next } => {
                match next.get_or_init(|| Self::doubled(of, panel.right)) {
                    Some(table) => table.at(t),
                    None => panel.series.evaluate(1.0) * (panel.right / t).powi(of.fall),
                }
            }
        }
    }

    /// Adds `D(t)` at many distances to sums, by runs of neighbours on one panel.
    pub(super) fn add(&self, distances: &[f64], sums: &mut [f64]) {
        let mut places = vec![0.0; distances.len()];
        let mut from = 0;
        while let Some(first) = distances.get(from) {
            let on = self.panel(*first).filter(|panel| *first <= panel.right);
            let Some((panel, local)) =
                on.and_then(|panel| panel.local.as_ref().map(|local| (panel, local)))
            else {
                sums[from] += self.at(*first);
                from += 1;
                continue;
            };
            let inside = |t: &f64| *t <= panel.right && (*t > panel.left || t == first);
            let run = from..from + distances[from..].iter().take_while(|t| inside(t)).count();
            let places = &mut places[run.clone()];
            for (place, t) in places.iter_mut().zip(&distances[run.clone()]) {
                *place = panel.place(*t);
            }
            local.add(places, &mut sums[run.clone()]);
            from = run.end;
        }
    }

    /// `D'(t)`; not a number beyond the panels of a given function.
    pub(super) fn slope(&self, t: f64) -> f64 {
        let Some(panel) = self.panel(t) else { return 0.0 };
        if t <= panel.right {
            return 2.0 / (panel.right - panel.left) * panel.derivative.evaluate(panel.place(t));
        }
        match &self.beyond {
            Beyond::Itself(_) => f64::NAN,
            Beyond::Doubled { of, next } => {
                match next.get_or_init(|| Self::doubled(of, panel.right)) {
                    Some(table) => table.slope(t),
                    None => -f64::from(of.fall) * self.at(t) / t,
                }
            }
        }
    }

    fn panel(&self, t: f64) -> Option<&Panel> {
        let index = self.panels.partition_point(|panel| panel.right < t);
        self.panels.get(index).or(self.panels.last())
    }
}

/// Makes panels.
struct Builder {
    panels: Vec<Panel>,
    unresolved: f64,
    /// The largest value met.
    scale: f64,
    /// The distance of the places at which the function is looked at between the nodes.
    step: f64,
}

impl Builder {
    fn new(step: f64) -> Self {
        Self { panels: Vec::new(), unresolved: 0.0, scale: 0.0, step }
    }

    fn table(self, beyond: Beyond) -> Table {
        Table { panels: self.panels, unresolved: self.unresolved, beyond }
    }

    fn add(&mut self, value: &dyn Fn(f64) -> f64, [left, right]: [f64; 2], halvings: usize) {
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let at = |y: f64| value(middle + half * y);
        let values: Vec<f64> = points(DEGREE).iter().map(|y| at(*y)).collect();
        self.scale = values.iter().fold(self.scale, |most, value| most.max(value.abs()));
        let series = ChebyshevSeries::through(values);
        let tail = series.coefficients().iter().rev().take(TAIL).map(|c| c.abs());
        let tail = tail.fold(0.0, f64::max);
        let is_short = tail <= RESOLVED * DEGREE as f64 * self.scale;
        let count = (2.0 * half / self.step) as usize;
        let places = (1..count).map(|i| 2.0 * i as f64 / count as f64 - 1.0);
        let beside = places.map(|y| (at(y) - series.evaluate(y)).abs()).fold(0.0, f64::max);
        let is_seen = beside <= BESIDE * self.scale;
        if is_short && is_seen || halvings == 0 {
            let missed = if is_short { 0.0 } else { tail };
            self.unresolved =
                self.unresolved.max(if is_seen { missed } else { missed.max(beside) });
            let derivative = derivative(series.coefficients());
            let local = Local::new(|y| series.evaluate(y), self.scale);
            self.panels.push(Panel { left, right, series, local, derivative });
        } else {
            self.add(value, [left, middle], halvings - 1);
            self.add(value, [middle, right], halvings - 1);
        }
    }
}

impl Panel {
    /// The place on the panel, from -1 to 1.
    fn place(&self, t: f64) -> f64 {
        let Self { left, right, .. } = self;
        (((t - left) - (right - t)) / (right - left)).clamp(-1.0, 1.0)
    }
}

/// The derivative of a Chebyshev series: `c'_(k-1) = c'_(k+1) + 2 k c_k`, and half of that for `k = 1`.
fn derivative(coefficients: &[f64]) -> ChebyshevSeries {
    let mut found = vec![0.0; coefficients.len() + 1];
    for k in (1..coefficients.len()).rev() {
        found[k - 1] = found[k + 1] + 2.0 * k as f64 * coefficients[k];
    }
    found[0] *= 0.5;
    ChebyshevSeries::new(found)
}
