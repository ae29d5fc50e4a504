//! The pressure on given zones.
//!
//! On a zone `xi = c + b cos phi` the pressure is `p0 = G(phi)/(theta0 b sin phi)`, `G = sum gamma_k cos(k phi)`, and the spectral relation gives its
//! own displacement `pi gamma_0 ln(2/b) + sum (pi/k) gamma_k cos(k phi)`; beyond the zone, with `|xi - c|/b = (w + 1/w)/2`,
//! `pi gamma_0 ln(2/(b w)) + sum (pi/k) gamma_k (+-1/w)^k`. What comes from elsewhere is smooth on a zone, so a few modes are coupled
//! to those of the others; all higher ones answer to the profile alone, `gamma_k = -k f_k/pi`, and are kept as the conjugate `F` of its [slopes](super::slopes):
//!
//! `G(phi) = -F(phi)/pi + sum s_k cos(k phi)`.

use std::f64::consts::{FRAC_PI_2, LN_2, PI};
use std::sync::Arc;

pub(super) use fredholm::inversion::Place;
use fredholm::inversion::{Angular, Conjugate};

use super::balance::Centred;
use super::coupling::{Coupled, couple, modes};
use super::density::Density;
use super::detail::Detail;
use super::kernel::{Remainder, SmoothKernel};
use super::problem::Base;
use crate::contact::accuracy::OF_A_VALUE;
use crate::contact::balance::State;
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::Zone;
use crate::{Error, Load, Rotational, Vertical};

/// A zone with its pressure.
#[derive(Debug, Clone)]
pub(super) struct Part {
    pub(super) zone: Zone,
    pub(super) slopes: Arc<Conjugate>,
    /// `s_k`.
    smooth: Vec<f64>,
    /// `gamma_k` of the modes that are coupled.
    modes: Vec<f64>,
    /// Mean slope of the profile, about which the others are.
    lean: f64,
    /// `G` where the slopes are a short series.
    density: Option<Density>,
    /// Places and masses that stand for the coupled modes in the remainder of the kernel.
    sources: Vec<(f64, f64)>,
}

impl Part {
    pub(super) fn centre(&self) -> f64 {
        0.5 * (self.zone.left() + self.zone.right())
    }

    pub(super) fn half(&self) -> f64 {
        0.5 * self.zone.length()
    }

    /// Number of modes that are coupled.
    pub(super) fn count(&self) -> usize {
        self.modes.len()
    }

    /// The same part with its density as one series and the sources of its remainder.
    fn completed(mut self, kernel: SmoothKernel) -> Self {
        let series = self.slopes.series().filter(|_| self.slopes.is_odd());
        self.density =
            series.map(|series| Density::new(&self.smooth, series.cosines().iter().copied()));
        if kernel.period().is_some() {
            let count = self.modes.len();
            let source = |r: usize| {
                let angle = PI * (r as f64 + 0.5) / count as f64;
                let mass = PI / count as f64 * cosines(&self.modes, angle);
                (self.centre() + self.half() * angle.cos(), mass)
            };
            self.sources = (0..count).map(source).collect();
        }
        self
    }

    /// `G` at a place.
    fn density_at(&self, place: Place) -> f64 {
        match &self.density {
            Some(density) => density.at(place.cosine()),
            None => self.density(place.angle()),
        }
    }

    /// `G(phi)`.
    pub(super) fn density(&self, angle: f64) -> f64 {
        if let Some(density) = &self.density {
            return density.at(angle.cos());
        }
        cosines(&self.smooth, angle) - self.slopes.conjugate(angle) / PI
    }

    pub(super) fn place(&self, xi: f64) -> Place {
        Place {
            from_left: (xi - self.zone.left()).max(0.0),
            from_right: (self.zone.right() - xi).max(0.0),
        }
    }

    /// `theta0` times the force of the zone.
    pub(super) fn force(&self) -> f64 {
        PI * self.modes[0]
    }

    /// The displacement beyond the zone, by `int ln(1/|xi - eta|)`.
    fn beyond(&self, xi: f64) -> f64 {
        let right = xi > self.centre();
        let distance = if right { xi - self.zone.right() } else { self.zone.left() - xi };
        let e = distance.max(0.0) / self.half();
        let excess = e + (e * (2.0 + e)).sqrt();
        let side = if right { 1.0 } else { -1.0 };
        let ratio = side / (1.0 + excess);
        let mut power = 1.0;
        let mut sum = PI * self.smooth[0] * (LN_2 - self.half().ln() - excess.ln_1p());
        if let Some(density) = &self.density {
            return sum + density.beyond(ratio);
        }
        for (k, s) in self.smooth.iter().enumerate().skip(1) {
            power *= ratio;
            sum += PI / k as f64 * s * power;
        }
        sum - self.slopes.outside(excess, side)
    }

    /// The displacement by the remainder of the kernel.
    fn remainder(&self, remainder: Remainder, xi: f64) -> f64 {
        self.sources.iter().map(|(source, mass)| mass * remainder.at(xi - source)).sum()
    }
}

/// `sum c_k cos(k phi)`.
pub(super) fn cosines(coefficients: &[f64], angle: f64) -> f64 {
    let cosine = angle.cos();
    let (mut next, mut after) = (0.0, 0.0);
    for c in coefficients.iter().skip(1).rev() {
        (next, after) = (c + 2.0 * cosine * next - after, next);
    }
    coefficients[0] + cosine * next - after
}

/// The profile on a zone as function of the angle.
struct OnZone<'b, 'p> {
    base: &'b Base<'p>,
    zone: Zone,
    /// A slope that is taken away, as it is large where the punch rolls onto a flank.
    mean: f64,
}

impl OnZone<'_, '_> {
    fn mean_slope(&self) -> f64 {
        let at = |angle: f64| self.position(angle);
        let mean = match &self.base.problem.profile.slope {
            // By Gauss's two places: in the middle may be a kink or a cusp.
            Some(slope) => {
                let angle = 3f64.sqrt().recip().acos();
                0.5 * (slope(at(angle)) + slope(at(PI - angle)))
            }
            None => (self.base.height(at(0.0)) - self.base.height(at(PI))) / self.zone.length(),
        };
        if mean.is_finite() { mean } else { 0.0 }
    }

    fn position(&self, angle: f64) -> f64 {
        let (sine, cosine) = (0.5 * angle).sin_cos();
        let xi = if angle < FRAC_PI_2 {
            self.zone.right() - self.zone.length() * sine * sine
        } else {
            self.zone.left() + self.zone.length() * cosine * cosine
        };
        self.zone.inside(xi)
    }
}

impl Angular for OnZone<'_, '_> {
    fn height(&self, angle: f64) -> f64 {
        let level = self.mean * 0.5 * self.zone.length() * angle.cos();
        self.base.height(self.position(angle)) - level
    }

    fn rounding(&self, height: f64, slope: f64) -> f64 {
        let steepest = self.mean.abs() + 2.0 * slope / self.zone.length();
        let farthest = self.zone.left().abs().max(self.zone.right().abs());
        OF_A_VALUE * (height + steepest * farthest)
    }

    fn taken_slope(&self) -> f64 {
        self.mean.abs() * 0.5 * self.zone.length()
    }

    fn blur(&self) -> f64 {
        let farthest = self.zone.left().abs().max(self.zone.right().abs());
        f64::EPSILON * (1.0 + farthest / self.zone.length())
    }

    fn slope(&self, angle: f64) -> Option<f64> {
        let slope = self.base.problem.profile.slope.as_ref()?;
        Some((self.mean - slope(self.position(angle))) * 0.5 * self.zone.length() * angle.sin())
    }
}

/// The pressure on zones under the load; at free ends it need not vanish yet.
#[derive(Debug, Clone)]
pub(super) struct Solved {
    pub(super) parts: Vec<Part>,
    pub(super) kernel: SmoothKernel,
    pub(super) theta0: f64,
    pub(super) state: State,
    pub(super) stiffness: Stiffness,
}

impl Solved {
    /// Solves on zones from left to right.
    pub(super) fn new(base: &Base<'_>, zones: &[Zone], detail: Detail) -> Result<Self, Error> {
        if zones.is_empty()
            || zones.iter().any(|zone| zone.length().is_nan() || zone.length() <= 0.0)
        {
            return Err(Error::NoContact);
        }
        let resolved =
            zones.iter().map(|zone| resolved(base, *zone, detail.panels)).collect::<Vec<_>>();
        Self::on_slopes(base, zones, detail, resolved)
    }

    /// The same zones in another detail; slopes that do not depend on it are kept.
    pub(super) fn again(&self, base: &Base<'_>, detail: Detail) -> Result<Self, Error> {
        let zones: Vec<Zone> = self.parts.iter().map(|part| part.zone).collect();
        let of = |part: &Part| {
            if part.slopes.is_sampled() {
                (Arc::clone(&part.slopes), part.lean)
            } else {
                resolved(base, part.zone, detail.panels)
            }
        };
        let resolved = self.parts.iter().map(of).collect();
        Self::on_slopes(base, &zones, detail, resolved)
    }

    fn on_slopes(
        base: &Base<'_>,
        zones: &[Zone],
        detail: Detail,
        resolved: Vec<(Arc<Conjugate>, f64)>,
    ) -> Result<Self, Error> {
        let kernel = base.problem.kernel;
        let counts = modes(kernel, zones, detail.digits)?;
        let slopes: Vec<Vec<f64>> = (resolved.iter().zip(&counts))
            .map(|((slopes, _), count)| slopes.coefficients(count - 1))
            .collect();
        // About the line of one of them: what is common to all changes settlement and tilt only.
        let centre = |zone: &Zone| 0.5 * (zone.left() + zone.right());
        let lean = resolved[0].1;
        let reference = slopes[0][0];
        let middle = 0.5 * (zones[0].left() + zones[zones.len() - 1].right());
        let mut heights = slopes.clone();
        for ((heights, zone), (_, mean)) in heights.iter_mut().zip(zones).zip(&resolved) {
            heights[0] -= reference + lean * (centre(zone) - centre(&zones[0]));
            heights[1] += (mean - lean) * 0.5 * zone.length();
        }
        let Coupled { level, tilted, profile } = couple(kernel, zones, &counts, middle, &heights)?;
        let theta0 = base.problem.theta0;
        let carried = |modes: &[Vec<f64>]| carried(zones, middle, modes).map(|part| part / theta0);
        let [force, coupling] = carried(&level);
        let [_, turn] = carried(&tilted);
        let stiffness = Stiffness { force_settlement: force, coupling, moment_tilt: turn };
        let balance = Centred { centre: middle, stiffness, free: carried(&profile) };
        // The line of the reference, reference + lean (xi - c).
        let load = base.problem.load;
        let start = reference - lean * centre(&zones[0]);
        let [depth, tilt] = balance.depth_and_tilt(&beside_line(load, start, lean));
        let lifted = start + lean * middle;
        let state = balance.state_of(&load, [depth, tilt], [lifted, lean]);
        if !(depth.is_finite() && tilt.is_finite()) {
            let (parameter, smallest) = (theta0, 0.0);
            return Err(Error::Equation(fredholm::Error::Singular { parameter, smallest }));
        }
        let parts = (resolved.into_iter().enumerate())
            .map(|(j, (slopes_of, lean))| {
                let own = |k: usize| depth * level[j][k] - tilt * tilted[j][k];
                let bent = |k: usize| k as f64 * slopes[j][k] / PI;
                let modes = (0..counts[j]).map(|k| own(k) - profile[j][k]).collect();
                let smooth = (0..counts[j]).map(|k| own(k) - (profile[j][k] - bent(k))).collect();
                let (density, sources) = (None, Vec::new());
                let (zone, slopes) = (zones[j], slopes_of);
                Part { zone, slopes, smooth, modes, lean, density, sources }.completed(kernel)
            })
            .collect();
        let stiffness = balance.about_base();
        Ok(Self { parts, kernel, theta0, state, stiffness })
    }

    /// `p0` at a place of a zone; infinite at a singular end.
    pub(super) fn pressure(&self, part: usize, place: Place) -> f64 {
        self.singular(part, place, self.parts[part].density_at(place))
    }

    /// `p0` for a density.
    fn singular(&self, part: usize, place: Place, density: f64) -> f64 {
        let root = (place.from_left * place.from_right).sqrt();
        if root == 0.0 {
            let side = usize::from(place.from_right == 0.0);
            let is_free = self.parts[part].zone.is_free(side);
            return if is_free || density == 0.0 { 0.0 } else { density * f64::INFINITY };
        }
        density / (self.theta0 * root)
    }

    /// Whether all slopes are series of slopes that are known.
    pub(super) fn is_sampled(&self) -> bool {
        self.parts.iter().all(|part| part.slopes.is_sampled())
    }

    /// `p0` anywhere, 0 outside the zones.
    pub(super) fn pressure_at(&self, xi: f64) -> f64 {
        match self.parts.iter().position(|part| part.zone.contains(xi)) {
            Some(j) => self.pressure(j, self.parts[j].place(xi)),
            None if xi.is_nan() => xi,
            None => 0.0,
        }
    }

    /// The same at many places.
    pub(super) fn pressures(&self, places: impl ExactSizeIterator<Item = f64>) -> Vec<f64> {
        let count = places.len();
        let mut pressures = vec![0.0; count];
        let room = || Inside { places: Vec::with_capacity(count), ..Inside::default() };
        let mut inside: Vec<Inside> = self.parts.iter().map(|_| room()).collect();
        for (i, xi) in places.enumerate() {
            let zone = self.parts.iter().position(|part| part.zone.contains(xi));
            match zone {
                Some(j) if self.parts[j].density.is_some() => {
                    inside[j].places.push((i, self.parts[j].place(xi)));
                }
                Some(j) => pressures[i] = self.pressure(j, self.parts[j].place(xi)),
                None if xi.is_nan() => pressures[i] = xi,
                None => {}
            }
        }
        for (j, Inside { places, mut densities }) in inside.into_iter().enumerate() {
            densities.extend(places.iter().map(|(_, place)| place.cosine()));
            if let Some(density) = &self.parts[j].density {
                density.replace(&mut densities);
            }
            for ((i, place), density) in places.into_iter().zip(densities) {
                pressures[i] = self.singular(j, place, density);
            }
        }
        pressures
    }

    /// `G` at the left (0) or right (1) end of a zone.
    pub(super) fn end_density(&self, part: usize, side: usize) -> f64 {
        self.parts[part].density(if side == 0 { PI } else { 0.0 })
    }

    /// `lim sqrt(2 pi d) p0` at the left (0) or right (1) end of a zone, `d` in `xi`.
    pub(super) fn intensity(&self, part: usize, side: usize) -> f64 {
        (PI / self.parts[part].half()).sqrt() * self.end_density(part, side) / self.theta0
    }

    /// `theta0 int K p0` at a place outside the zones.
    pub(super) fn displacement_outside(&self, xi: f64) -> f64 {
        let xi = self.kernel.reduced(xi);
        let period = self.kernel.period().unwrap_or(0.0);
        let remainder = self.kernel.remainder();
        let of = |part: &Part| {
            let images: f64 =
                self.kernel.images().iter().map(|m| part.beyond(xi - m * period)).sum();
            images + remainder.map_or(0.0, |remainder| part.remainder(remainder, xi))
        };
        self.parts.iter().map(of).sum()
    }

    /// Sizes of `G` and its rounding: that of the smooth part and of the slopes.
    pub(super) fn density_scale(&self) -> f64 {
        let size = |part: &Part| part.smooth.iter().map(|s| s.abs()).fold(0.0, f64::max);
        self.parts.iter().map(size).fold(f64::MIN_POSITIVE, f64::max)
    }

    /// Rounding of `G` of a zone by the sizes of what is added up in it, with the error of the slopes by their last coefficients.
    pub(super) fn rounding(&self, part: usize) -> f64 {
        self.sum_rounding(part) + self.parts[part].slopes.error() / PI
    }

    /// The same at the ends of the zone.
    pub(super) fn end_rounding(&self, part: usize) -> f64 {
        self.sum_rounding(part) + self.parts[part].slopes.end_error() / PI
    }

    fn sum_rounding(&self, part: usize) -> f64 {
        let part = &self.parts[part];
        let sum: f64 = part.smooth.iter().map(|s| s.abs()).sum();
        // The ends are rounded in xi, not in lengths of their zone.
        let remote = 1.0 + part.zone.left().abs().max(part.zone.right().abs()) / part.half();
        // Each mode answers to a sum over nodes of sums over modes.
        OF_A_VALUE * (remote + 2.0 * part.smooth.len() as f64 + self.condition()) * sum
    }

    /// How much a rounding of the displacement counts in the pressure: near full contact of a row a pressure that is even moves next to nothing.
    pub(super) fn condition(&self) -> f64 {
        self.theta0 * self.stiffness.force_settlement.abs()
    }

    /// Rounding of settlement and tilt by that of the heights on the zones: errors of `f_0`, and of `f_1` over half a zone.
    pub(super) fn displacement_rounding(&self) -> [f64; 2] {
        self.parts.iter().fold([0.0f64; 2], |[level, turn], part| {
            let own = part.slopes.mode_error();
            let tilt = own / part.half();
            [level.max(own + tilt * part.centre().abs()), turn.max(tilt)]
        })
    }

    /// Number of panels of all zones.
    pub(super) fn panels(&self) -> usize {
        self.parts.iter().map(|part| part.slopes.panels()).sum()
    }

    /// Number of modes of all zones.
    pub(super) fn modes(&self) -> usize {
        self.parts.iter().map(|part| part.modes.len()).sum()
    }
}

/// Places in a zone with their numbers, and cosines that become densities.
#[derive(Default)]
struct Inside {
    places: Vec<(usize, Place)>,
    densities: Vec<f64>,
}

/// The load of a profile less the line `reference + lean xi`.
fn beside_line(load: Load, reference: f64, lean: f64) -> Load {
    let Load { vertical, rotational } = load;
    let vertical = match vertical {
        Vertical::Settlement(settlement) => Vertical::Settlement(settlement - reference),
        force @ Vertical::Force(_) => force,
    };
    let rotational = match rotational {
        Rotational::Tilt(tilt) => Rotational::Tilt(tilt + lean),
        other @ (Rotational::Moment(_) | Rotational::Eccentricity(_)) => other,
    };
    Load { vertical, rotational }
}

/// The slope of the profile on a zone about its mean, which is returned too.
fn resolved(base: &Base<'_>, zone: Zone, panels: usize) -> (Arc<Conjugate>, f64) {
    let profile = &base.problem.profile;
    let inside = |at: &&f64| zone.left() < **at && **at < zone.right();
    let angle =
        |at: &f64| Place { from_left: at - zone.left(), from_right: zone.right() - at }.angle();
    let angles = |places: &[f64]| -> Vec<f64> { places.iter().filter(inside).map(angle).collect() };
    let [bends, joints] = [&profile.breaks, &profile.joints].map(|places| angles(places));
    let mut on_zone = OnZone { base, zone, mean: 0.0 };
    on_zone.mean = on_zone.mean_slope();
    // Places rounded to doubles leave the slope of a short zone far off the middle no more digits.
    let nearest = zone.left().max(-zone.right()).max(0.0);
    let rounding = OF_A_VALUE * nearest / zone.length();
    let tolerance = profile.tolerance.max(rounding);
    let slopes = Conjugate::resolve(&on_zone, [&bends, &joints], [panels, 1], tolerance);
    (Arc::new(slopes), on_zone.mean)
}

/// `theta0` times force and moment about a middle.
fn carried(zones: &[Zone], middle: f64, modes: &[Vec<f64>]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for (zone, modes) in zones.iter().zip(modes) {
        let centre = 0.5 * (zone.left() + zone.right()) - middle;
        sums[0] += PI * modes[0];
        sums[1] += PI * centre * modes[0] + 0.25 * PI * zone.length() * modes[1];
    }
    sums
}
