//! What lies between the numbers of the machine: the tip of a base may, as that of `|x - 0.1 - 0.2|^q` does, and then the pressure under it is larger than at any number.

use std::ops::Range;

use crate::allowance::UNIT;
use crate::density::Density;
use crate::kernel::{Kernel, Singularity};
use crate::narrow::{ROUNDED, VICINITY, density_variation, nearby};
use crate::panel::Panel;
use crate::profile::Profile;
use crate::residual::{Bounded, Residual, blur};

/// So many numbers of an interval are looked at, at most.
pub(crate) const MOST_NUMBERS: usize = 40;

/// No two places of a base are farther apart.
const FARTHEST: f64 = 2.0;
/// Within this distance of a jump a formula may leave open on which side of it a number lies: its parts are rounded, and none is much larger than the base.
pub(crate) const OPEN: f64 = 256.0 * f64::EPSILON;
/// So many times that far from a jump heights are off by their rounding.
pub(crate) const CLEAR: f64 = 2.0;

/// What is asked of a contact between the numbers of a window.
pub(crate) trait Pressed {
    /// What the layer is pressed by at a number, none outside of zones.
    fn pressed(&self, x: f64) -> Option<f64>;

    /// How far what is pressed, beside the base, may rise from one number to another.
    fn rise(&self, from: f64, to: f64) -> f64;

    /// How far it may rise between neighbours of these numbers above both.
    fn bulge(&self, numbers: &[f64]) -> f64;
}

/// What the layer is pressed by at most between the numbers of a window that could not be resolved, if that is more than `known`.
///
/// `v(x) + f(x)` between two numbers is not above that at one of them by more than it rises from this to the other, nor above both by more than it bulges.
pub(crate) fn pressed_between(
    profile: &dyn Profile,
    [left, right]: [f64; 2],
    contact: &impl Pressed,
    known: f64,
) -> f64 {
    // A tip at an end is followed to the inside: by its rounding it may lie beyond.
    let blur = blur(left.abs().max(right.abs()));
    let [left, right] = [left - blur, right + blur];
    let [low, _] = profile.range([left, right]);
    let above = |x: f64| {
        let own = contact.pressed(x)?;
        let [_, high] = profile.height(x);
        Some((x, own + if low < high { high - low } else { 0.0 }))
    };
    let most = |told: &[(f64, f64)]| {
        let bulge = contact.bulge(&told.iter().map(|(x, _)| *x).collect::<Vec<f64>>());
        let gaps = told.windows(2).map(|pair| {
            let [(x, one), (y, other)] = [pair[0], pair[1]];
            let either = one.max(other);
            if either + bulge <= known {
                return either;
            }
            either.min(one + contact.rise(x, y)).min(other + contact.rise(y, x))
        });
        gaps.fold(f64::NEG_INFINITY, f64::max) + bulge
    };
    let numbers = numbers([left, right], 0.5 * (left + right));
    let told: Vec<(f64, f64)> = numbers.into_iter().filter_map(above).collect();
    let (Some(first), Some(last)) = (told.first(), told.last()) else { return known };
    let reached = most(&told);
    if reached <= known {
        return known;
    }
    // Beside a jump a formula may leave open which side the numbers of a window are on, but not those farther away.
    let clear = [
        above(left - CLEAR * OPEN).unwrap_or(*first),
        above(right + CLEAR * OPEN).unwrap_or(*last),
    ];
    reached.min(most(&clear)).max(known)
}

impl Residual<'_> {
    /// An upper bound of the pressure between the numbers of narrow windows in zones where it may be above `known`, if at numbers the answer's own is exact.
    pub(crate) fn between_numbers(&self, zones: &[Bounded], known: f64) -> f64 {
        let narrow = zones.iter().filter(|window| window.is_narrow);
        narrow.fold(known, |most, window| {
            let Bounded { left, right, largest, .. } = *window;
            // What is between numbers counts in the largest residual.
            if (self.pressure)(0.5 * (left + right)) + largest <= most {
                return most;
            }
            pressed_between(self.profile, [left, right], self, most)
        })
    }
}

impl Pressed for Residual<'_> {
    fn pressed(&self, x: f64) -> Option<f64> {
        self.density.panel_at(x).map(|_| (self.pressure)(x))
    }

    fn rise(&self, from: f64, to: f64) -> f64 {
        let [(one, rounding), (other, more)] = [from, to].map(|x| self.density.potential(x));
        self.tilt.abs() * (to - from).abs()
            + self.theta * ((one - other).max(0.0) + rounding + more)
    }

    fn bulge(&self, numbers: &[f64]) -> f64 {
        let width = numbers.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        if width == 0.0 {
            return 0.0;
        }
        let window = [numbers[0], numbers[numbers.len() - 1]];
        let dip = match Steady::new(self.density, window) {
            Some(steady) => steady.dip(width),
            None => self.potential_variation(window),
        };
        let bulge = self.tilt.abs() * width + self.theta * dip;
        bulge + ROUNDED * UNIT * (self.density.largest() + bulge)
    }
}

/// A density beside a window as a constant on the zone of that, which is not negative, and what it differs from it.
struct Steady<'a> {
    density: &'a Density,
    window: [f64; 2],
    constant: f64,
    /// By how much the density is less where it is negative.
    negative: f64,
    /// The panels of the zone, and the zone.
    panels: Range<usize>,
    zone: [f64; 2],
}

impl<'a> Steady<'a> {
    /// None where the window is not in one zone.
    fn new(density: &'a Density, window: [f64; 2]) -> Option<Self> {
        let panels = &density.panels;
        let [own, other] = [density.panel_at(window[0])?, density.panel_at(window[1])?];
        let is_cut = |pair: &[Panel]| pair[0].right < pair[1].left;
        let first = panels[..=own].windows(2).rposition(is_cut).map_or(0, |index| index + 1);
        let last = panels[own..].windows(2).position(is_cut);
        let last = last.map_or(panels.len(), |at| own + at + 1);
        let value = density.evaluate(0.5 * (window[0] + window[1]));
        let [constant, negative] = [value.max(0.0), (-value).max(0.0)];
        let zone = [panels[first].left, panels[last - 1].right];
        let is_within = (first..last).contains(&other);
        is_within.then_some(Self { density, window, constant, negative, panels: first..last, zone })
    }

    /// How far the potential between two places of the window that are so far apart may lie below the smaller one of their potentials.
    ///
    /// Of the constant it is nowhere below: its potential is concave in the zone. What the density differs from that changes its potential by at most
    /// `int |q - constant| |sigma(|x - t|) - sigma(|y - t|)| dt`, which is bounded in the vicinity and on shells beyond, each twice as far away as the one before.
    fn dip(&self, width: f64) -> f64 {
        let singularity = self.density.kernel.singularity();
        let mut distance = VICINITY * width;
        let widths = VICINITY + (self.window[1] - self.window[0]) / width;
        let mut dip = self.differs(distance) * nearby(singularity, width, widths);
        while distance < FARTHEST {
            let slopes = match singularity {
                Singularity::Logarithm => std::f64::consts::LN_2,
                Singularity::Power(mu) => distance.powf(-mu) * (1.0 - 0.5f64.powf(mu)),
            };
            distance *= 2.0;
            dip += self.differs(distance) * 2.0 * width * slopes;
        }
        dip
    }

    /// By how much the density differs from the constant within a distance of the window, also where it repeats.
    fn differs(&self, distance: f64) -> f64 {
        let [left, right] = [self.window[0] - distance, self.window[1] + distance];
        let within = [left.max(self.zone[0]), right.min(self.zone[1])];
        let own = self.negative + density_variation(self.density, within);
        let images: &[f64] = match self.density.kernel {
            Kernel::Row { period } => &[0.0, -period, period],
            Kernel::Logarithm
            | Kernel::ShiftedLogarithm { .. }
            | Kernel::Layered(_)
            | Kernel::Power { .. } => &[0.0],
        };
        let mut most = own;
        for (index, panel) in self.density.panels.iter().enumerate() {
            let is_own = self.panels.contains(&index);
            let touches = |image: f64| panel.left + image < right && panel.right + image > left;
            if images.iter().any(|image| (!is_own || *image != 0.0) && touches(*image)) {
                let mean = if is_own { self.constant } else { 0.0 };
                most = most.max((panel.coefficients[0] - mean).abs() + panel.swing);
            }
        }
        most
    }
}

/// The numbers of an interval from left to right; if they are too many some, with a place between them and its neighbours.
fn numbers([left, right]: [f64; 2], place: f64) -> Vec<f64> {
    let all = std::iter::successors(Some(left), |x| Some(x.next_up()));
    let all: Vec<f64> = all.take_while(|x| *x <= right).take(MOST_NUMBERS + 1).collect();
    if all.len() <= MOST_NUMBERS { all } else { spread([left, right], place) }
}

/// Numbers of a window from left to right, as many apart from each other, with a place between them and its neighbours.
pub(crate) fn spread([left, right]: [f64; 2], place: f64) -> Vec<f64> {
    let beside = [place.next_down(), place, place.next_up()];
    let parts = (MOST_NUMBERS - 1 - beside.len()) as i64;
    let (first, last) = (order(left), order(right));
    let step = last / parts - first / parts;
    let inner = (1..parts).map(|k| number(first + k * step));
    let inner = inner.chain(beside).filter(|x| left < *x && *x < right);
    let mut numbers: Vec<f64> = inner.chain([left, right]).collect();
    numbers.sort_by(f64::total_cmp);
    numbers
}

/// The numbers of the machine in their order, zero being 0.
pub(crate) fn order(x: f64) -> i64 {
    let magnitude = x.abs().to_bits() as i64;
    if x < 0.0 { -magnitude } else { magnitude }
}

pub(crate) fn number(order: i64) -> f64 {
    f64::from_bits(order.unsigned_abs()).copysign(order as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::legendre::{ORDER, RULE};

    /// Panels of `value` on zones, the finer the nearer to their ends.
    fn panels(zones: &[[f64; 2]], value: impl Fn(f64) -> f64) -> Vec<Panel> {
        let halvings = |[left, right]: [f64; 2]| {
            let middle = 0.5 * (left + right);
            let shares: Vec<f64> =
                std::iter::once(0.0).chain((0..40).rev().map(|k| 0.5f64.powi(k))).collect();
            let rising: Vec<f64> =
                shares.iter().map(|share| left + share * (middle - left)).collect();
            let falling =
                shares.into_iter().rev().skip(1).map(move |share| right - share * (right - middle));
            rising.into_iter().chain(falling).collect::<Vec<f64>>()
        };
        let ends = zones.iter().map(|zone| halvings(*zone));
        let pairs = ends
            .flat_map(|ends| ends.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>());
        let panel = |[left, right]: [f64; 2]| {
            let at = |t: &f64| value(0.5 * (left + right) + 0.5 * (right - left) * t);
            let values: Vec<f64> = RULE.nodes.iter().map(at).collect();
            Panel::new(left, right, RULE.expand(&<[f64; ORDER]>::try_from(values).unwrap()))
        };
        pairs.map(panel).collect()
    }

    /// Potentials between two places are compared with those at both.
    #[test]
    fn potentials_dip_no_deeper() {
        let kernels = [
            Kernel::Logarithm,
            Kernel::Row { period: 2.0 },
            Kernel::Power { exponent: 0.3 },
            Kernel::Power { exponent: 0.7 },
        ];
        let densities: [fn(f64) -> f64; 4] =
            [|_| 1.0, |x| 1.3 + (3.0 * x).sin(), |x| 0.4 - x, |x| 1.0 - (x - 0.25).abs().powf(0.4)];
        let mut most = 0.0f64;
        for kernel in kernels {
            for (index, value) in densities.into_iter().enumerate() {
                for zones in [&[[-1.0, 1.0]][..], &[[-1.0, -0.2], [-0.1, 0.25], [0.25, 0.9]]] {
                    let density = Density::new(kernel, panels(zones, value));
                    let potential = |x: f64| density.potential(x).0;
                    for [from, to] in
                        [[-1.0, -0.9], [0.25, 0.3], [0.2, 0.25], [0.85, 0.9], [0.4, 0.41]]
                    {
                        for width in [1e-3, 1e-6, 1e-9] {
                            let steady = |x: f64| Steady::new(&density, [x, x + width]).unwrap();
                            for share in [0.0, 0.5, 1.0] {
                                let x = from + share * (to - from - width);
                                let dip = steady(x).dip(width);
                                let least = potential(x).min(potential(x + width));
                                let deepest = (1..20)
                                    .map(|k| least - potential(x + width * f64::from(k) / 20.0))
                                    .fold(f64::NEG_INFINITY, f64::max);
                                most = most.max((deepest - 1e-14) / dip);
                                assert!(
                                    deepest <= dip + 1e-14,
                                    "{kernel:?} {index} {x} {width}: {deepest:e} {dip:e}"
                                );
                                if index == 0 && zones.len() == 1 && kernel != kernels[1] {
                                    assert!(dip <= 1e-13 * width, "{kernel:?} {x}: {dip:e}");
                                }
                            }
                        }
                    }
                }
            }
        }
        assert!(most > 1e-3, "the bound is idle: {most:e}");
    }
}
