//! From the windows of the residual to the distance between the resampled pressure and the true one.

use crate::bound::Audit;
use crate::kernel::Kernel;
use crate::norms::{Reach, mass, row_norm};
use crate::problem::Prescribed;
use crate::residual::{Bounded, blur};
use crate::sample::negative_part;
use crate::shape::Correction;

/// The residual in the zones and beside them.
pub(crate) struct Windows<'a> {
    pub(crate) zones: &'a [Bounded],
    pub(crate) gaps: &'a [Bounded],
}

impl Windows<'_> {
    /// Windows beside the zones that may be in contact.
    pub(crate) fn open(&self, margin: f64) -> impl Iterator<Item = &Bounded> {
        self.gaps.iter().filter(move |window| margin.is_nan() || window.least <= margin)
    }
}

/// What is known of the distance between the true pressure and the resampled one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Distance {
    /// `||w~||`, of the density that is admissible to the last digit.
    pub(crate) residual: f64,
    /// `||p - q'||`, `q'` the density with what is changed on windows that were not resolved; and that change.
    pub(crate) mean_square: f64,
    pub(crate) changed: f64,
    /// The measure of these windows.
    pub(crate) changed_width: f64,
    /// What else the pressure at a place is off by, beside the free displacements.
    pub(crate) pressure: f64,
    /// `theta |K (p - q)|` at any place.
    pub(crate) potential: f64,
    /// The same without what free displacements do to it, by the complete maximum principle: no larger than the largest residual; infinite where the kernel has it not.
    pub(crate) principle: f64,
    /// `||w~||_1`.
    pub(crate) sum: f64,
    /// What free displacements take up, relative to them.
    pub(crate) taken: f64,
}

/// Sums over windows.
#[derive(Debug, Clone, Copy, Default)]
struct Norms {
    /// `||w~||` squared, and `||w~||_1` in the zones, without what changes the density.
    square: f64,
    sum: f64,
    /// `||w~||_1`, `||w~||` squared where the density is changed by it, and their measure; the potential that `w~` has on all windows that were not resolved.
    narrow_sum: f64,
    narrow_square: f64,
    narrow_width: f64,
    narrow_potential: f64,
    /// The largest `|w~|` at numbers of the machine; and anywhere, but where the density is changed by it.
    largest: f64,
    anywhere: f64,
}

impl Norms {
    /// Where the density is not changed by it, the residual counts as it is: there it would cost more, `theta ||K w~||` instead of `||w~||`.
    fn add_narrow(&mut self, size: f64, width: f64, (kernel, theta): (Kernel, f64)) {
        self.narrow_potential += size * narrow_potential(width, kernel);
        if theta * row_norm(kernel) * width.sqrt() >= 1.0 {
            self.square += size * size * width;
            self.sum += size * width;
            self.anywhere = self.anywhere.max(size);
            return;
        }
        self.narrow_width += width;
        self.narrow_sum += size * width;
        self.narrow_square += size * size * width;
    }
}

/// A bound of the potential of a density of size one on an interval of this width.
pub(crate) fn narrow_potential(width: f64, kernel: Kernel) -> f64 {
    let mu = kernel.singularity().exponent();
    if mu == 0.0 {
        // A row is ln(L/(2 pi d)) at short distances.
        let period = match kernel {
            Kernel::Row { period } => (0.25 * period).ln().max(0.0),
            _ => 0.0,
        };
        width * (3.0 + width.ln().abs() + kernel.constant().abs() + kernel.rest() + period)
    } else {
        4.0 * width.powf(1.0 - mu) / (1.0 - mu)
    }
}

/// What a last correction does.
struct Corrected {
    /// `||psi (a + b (x - m))||`, and its largest value.
    norm: f64,
    highest: f64,
    /// What it adds to `||w~||`.
    residual: f64,
    /// What free displacements take up of it, relative to them.
    taken: f64,
}

impl Audit<'_> {
    fn norms(&self, windows: &Windows<'_>) -> Norms {
        let mut norms = Norms::default();
        let about = (self.problem.kernel, self.problem.theta);
        for window in windows.zones.iter().chain(windows.gaps) {
            let width = window.right - window.left;
            norms.largest = norms.largest.max(window.at_numbers);
            if window.is_narrow {
                norms.add_narrow(window.largest, width, about);
            } else {
                norms.square += window.norm * window.norm;
                norms.sum += window.largest * width;
                norms.anywhere = norms.anywhere.max(window.largest);
            }
        }
        // Jumps of the base lie within some roundings of where windows have them.
        for cut in self.problem.cuts.iter().filter(|cut| self.density.panel_at(**cut).is_some()) {
            let blur = blur(cut.abs());
            let [low, high] = self.problem.profile.range([cut - blur, cut + blur]);
            norms.add_narrow(high - low, 2.0 * blur, about);
        }
        norms
    }

    /// The theorem, with what keeps the density from being admissible to the last digit.
    pub(crate) fn distance(&self, windows: &Windows<'_>, reach: &Reach) -> Distance {
        let (kernel, theta) = (self.problem.kernel, self.problem.theta);
        let norms = self.norms(windows);
        // What is negative is cut off.
        let [mut square, mut sum, mut depth, mut below] = [0.0f64; 4];
        if !self.problem.is_bilateral {
            for panel in &self.density.panels {
                let [a, b, c] = negative_part(panel);
                (square, sum, depth) = (square + a, sum + b, depth.max(c));
                below += c * narrow_potential(panel.right - panel.left, kernel);
            }
        }
        // The potential of that is no larger than that of the depth everywhere, nor than those of all panels together.
        let below = below.min(mass(kernel, reach.half) * depth);
        let negative = square.sqrt();
        // On absorbed windows the density is what its own potential makes it: a change by w~ there.
        let absorbed = theta
            * (norms.narrow_sum * row_norm(kernel))
                .min(norms.narrow_square.sqrt() * mass(kernel, 1.0));
        let corrected =
            self.corrected(windows, reach, (norms.square.sqrt(), norms.narrow_sum + sum));
        let residual = norms.square.sqrt()
            + absorbed
            + (1.0 + reach.strength()) * negative
            + corrected.residual;
        let beside =
            theta * (norms.narrow_potential + below + mass(kernel, reach.half) * corrected.highest);
        // What is cut off or added changes the residual, too; where the density is changed, elsewhere by the potential of that.
        let uniform = norms.anywhere + depth + corrected.highest + 2.0 * beside;
        Distance {
            residual,
            mean_square: residual + negative + corrected.norm,
            changed: norms.narrow_square.sqrt(),
            changed_width: norms.narrow_width,
            pressure: norms.largest + depth + corrected.highest,
            potential: reach.smoothing() * residual
                + if reach.doubles() { 2.0 * beside } else { beside },
            principle: if self.has_principle() { uniform } else { f64::INFINITY },
            sum: norms.sum + norms.narrow_sum + sum,
            taken: corrected.taken,
        }
    }

    /// Whether the kernel has the complete maximum principle: the logarithm and the row have it but for a constant, of which differences without force know nothing.
    fn has_principle(&self) -> bool {
        match self.problem.kernel {
            Kernel::Power { .. } => true,
            Kernel::Logarithm | Kernel::Row { .. } => self.problem.prescribed.force.is_some(),
            Kernel::ShiftedLogarithm { .. } | Kernel::Layered(_) => false,
        }
    }

    /// Force and moment are met by a last correction `psi (a + b (x - m))`.
    ///
    /// It changes `w` by its image under `1 + theta K`. In proportion to the pressure, with `psi = q`, that is `a (w + delta - alpha x - f)`, of which free displacements take up their part.
    fn corrected(&self, windows: &Windows<'_>, reach: &Reach, (w, moved): (f64, f64)) -> Corrected {
        let shape = &self.shape;
        let Prescribed { force, moment } = self.problem.prescribed;
        let defect = |prescribed: Option<f64>, found: f64, rounding: f64| {
            prescribed.map_or(0.0, |value| {
                (value - found).abs() + rounding + moved + self.problem.scaled * value.abs()
            })
        };
        let off = defect(force, shape.force, shape.rounding[0]);
        let turned = defect(moment, shape.moment, shape.rounding[1]);
        let a = (off / shape.mass).abs();
        let b = ((turned + off * shape.mean.abs()) / shape.square).abs();
        let image = (1.0 + reach.strength()) * shape.norm;
        let proportional = match shape.correction {
            Correction::Proportional => w + self.heights(windows, a) * (2.0 * reach.half).sqrt(),
            Correction::Line => f64::INFINITY,
        };
        let largest = match shape.correction {
            Correction::Proportional => self.density.largest(),
            Correction::Line => 1.0,
        };
        // Else it would pull.
        let is_admissible = self.problem.is_bilateral || a + b * shape.reach <= 0.5;
        let unless = if is_admissible { 0.0 } else { f64::INFINITY };
        Corrected {
            norm: a * shape.norm + b * shape.leaning,
            highest: largest * (a + b * shape.reach),
            residual: unless
                + a * image.min(proportional)
                + b * (1.0 + reach.strength()) * shape.leaning,
            taken: if proportional < image { a } else { 0.0 },
        }
    }

    /// The largest height of the base, and of what is given of the line `delta - alpha x`, where a change of `w` by `a (w - f)` can matter: in the zones, and beside them where `w < a f`.
    fn heights(&self, windows: &Windows<'_>, a: f64) -> f64 {
        let Prescribed { moment, .. } = self.problem.prescribed;
        let given = if moment.is_none() { self.tilt.abs() } else { 0.0 };
        let height = |interval: [f64; 2]| {
            let [low, high] = self.problem.profile.range(interval);
            low.abs().max(high.abs()) + given
        };
        let zones = runs(windows.zones).map(|run| height(hull(run)));
        let gaps = runs(windows.gaps).map(|run| {
            let height = height(hull(run));
            if run.iter().any(|window| window.least <= a * height) { height } else { 0.0 }
        });
        zones.chain(gaps).fold(0.0, f64::max)
    }
}

/// Windows that follow each other and are together no longer than the longest of them may be: where they crowd beside a bend, heights are those of all of them.
fn runs(windows: &[Bounded]) -> impl Iterator<Item = &[Bounded]> {
    let widest = windows.iter().fold(0.0f64, |most, window| most.max(window.right - window.left));
    let mut rest = windows;
    std::iter::from_fn(move || {
        let first = rest.first()?;
        let joined = (rest.windows(2)).take_while(|pair| {
            pair[0].right == pair[1].left && pair[1].right - first.left <= widest
        });
        let (run, others) = rest.split_at(1 + joined.count());
        rest = others;
        Some(run)
    })
}

/// The interval of windows that follow each other.
fn hull(run: &[Bounded]) -> [f64; 2] {
    [run[0].left, run[run.len() - 1].right]
}
