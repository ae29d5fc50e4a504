//! The pressures on zones of given ends, as far as it takes no panels.
//!
//! On `xi = c + s`, `|s| <= b`, with the slopes `h_e`, `h_o` of the even and the odd part of the profile about `c`, the depth `D = delta0 - alpha0 c - f0(c)`,
//! `S(t) = int_0^t sin^mu`, `B = S(pi/2)`, `Lambda = pi theta0/(Gamma(mu) cos(pi mu/2))` and `e = 4^beta pi/(Lambda Gamma(1-beta)^2)`,
//!
//! - `G_e(x) = x int_0^{pi/2} h_e(x cos t) (cos t sin^mu t + mu sin t S(t)) dt`, `G_o(x) = int_0^{pi/2} h_o(x cos t) sin^mu t dt`;
//! - `p0 = (e/pi) [d_e(b) (b^2 - s^2)^-beta + int_|s|^b G_e' (x^2 - s^2)^-beta dx + s (the same of d_o, G_o)]`, `d_e = mu B D - G_e`, `d_o = -alpha0 B - G_o`;
//! - `P0 = (2e/pi) B b^mu (mu B D - mu b int h_e sin t S dt)`,
//!   `M0 = c P0 + (2e/pi) B b^(2+mu) (-alpha0 B/(2+mu) - int h_o sin^(2+mu) t dt/(1+mu))`.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use libm::tgamma;

use super::resolved::Resolved;
use crate::Error;
use crate::contact::balance::State;
use crate::contact::smooth::Curve;
use crate::contact::smooth::disk::shape::{Part, Shape};
use crate::contact::smooth::ground;
use crate::contact::smooth::problem::Base;
use crate::contact::smooth::zones::Zone;
use crate::contact::solved::Stiffness;

/// More breakpoints than these do not get panels of their own.
const MOST_BREAKS: usize = 64;
/// Share of a place by which it is rounded.
const SAME: f64 = 16.0 * f64::EPSILON;
/// Places on either side of the middle that show the size of slopes.
const SAMPLES: usize = 8;

/// The kernel with its `theta0`.
#[derive(Debug, Clone)]
pub(super) struct Ground {
    pub(super) powers: ground::Ground,
    /// `e`.
    pub(super) modulus: f64,
}

impl Ground {
    pub(super) fn new(exponent: f64, theta0: f64) -> Result<Self, Error> {
        let powers = ground::Ground::new(exponent)?;
        let response = theta0 * PI / (tgamma(exponent) * (FRAC_PI_2 * exponent).cos());
        let modulus = powers.modulus(response);
        Ok(Self { powers, modulus })
    }

    /// `B`.
    pub(super) fn total(&self) -> f64 {
        self.powers.sines().total()
    }
}

/// The even and the odd part of the profile about the middle of a zone.
pub(super) struct Halves {
    slopes: [Curve; 2],
    breaks: Vec<f64>,
    tolerance: f64,
    /// Rounding of the slopes.
    noise: f64,
    /// Size of the slope of the profile.
    pub(super) steepest: f64,
}

impl Halves {
    pub(super) fn new(base: &Base<'_>, zone: &Zone) -> Self {
        let [left, right] = zone.ends;
        let centre = 0.5 * (left + right);
        let profile = &base.problem.profile;
        let slope: Curve = match &profile.slope {
            Some(slope) => Arc::clone(slope),
            None => Arc::new(|_| f64::NAN),
        };
        let clamped = move |xi: f64| slope(xi.max(left.next_up()).min(right.next_down()));
        let mut cuts = vec![left];
        cuts.extend(profile.breaks.iter().filter(|at| left < **at && **at < right));
        cuts.push(right);
        let known = cuts.len() <= MOST_BREAKS + 2;
        let at: Curve = match known.then(|| Resolved::new(&clamped, &cuts)).flatten() {
            Some(resolved) => Arc::new(move |s: f64| resolved.at(centre + s)),
            None => Arc::new(move |s: f64| clamped(centre + s)),
        };
        let other = Arc::clone(&at);
        let even: Curve = Arc::new(move |r| 0.5 * (at(r) - at(-r)));
        let odd: Curve = Arc::new(move |r| 0.5 * (other(r) + other(-r)));
        let inside = |at: &f64| left < *at && *at < right;
        let mut breaks: Vec<f64> = profile.breaks.iter().copied().filter(inside).collect();
        breaks.iter_mut().for_each(|at| *at = (*at - centre).abs());
        // Where a kink is, is rounded: what lies closer to the middle is there.
        let rounding = SAME * left.abs().max(right.abs());
        breaks.retain(|r| *r > rounding);
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        if breaks.len() > MOST_BREAKS {
            breaks.clear();
        }
        let half = 0.5 * zone.length();
        let largest = |curve: &Curve| {
            let places = (0..SAMPLES).map(|i| half * (i as f64 + 0.5) / SAMPLES as f64);
            places.fold(0.0f64, |most, r| most.max(curve(r).abs()))
        };
        let sizes = [largest(&even), largest(&odd)];
        let steepest = sizes[0] + sizes[1];
        // The slope is rounded, and so is the place it is taken at.
        let remote = left.abs().max(right.abs()) / half;
        let noise = 2.0 * f64::EPSILON * (1.0 + remote) * steepest;
        Self { slopes: [even, odd], breaks, tolerance: profile.tolerance, noise, steepest }
    }

    /// Where the halves bend.
    pub(super) fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    pub(super) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    fn shape(&self, ground: &Ground, part: Part) -> Shape<'_> {
        let index = usize::from(part == Part::Odd);
        let (slope, noise) = (&self.slopes[index], self.noise);
        let (breaks, tolerance) = (self.breaks.clone(), self.tolerance);
        Shape { slope, breaks, tolerance, noise, ground: ground.powers.clone(), part }
    }

    pub(super) fn even(&self, ground: &Ground) -> Shape<'_> {
        self.shape(ground, Part::Even)
    }

    pub(super) fn odd(&self, ground: &Ground) -> Shape<'_> {
        self.shape(ground, Part::Odd)
    }
}

/// A zone with its loads.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strip {
    pub(super) zone: Zone,
    /// Of all zones together, and its stiffness.
    pub(super) state: State,
    pub(super) stiffness: Stiffness,
    /// Of this zone alone, about its middle.
    pub(super) own: Stiffness,
    pub(super) force: f64,
    /// The even and the odd density without the profile's: of one zone `mu B D` and `-alpha0 B`.
    pub(super) levels: [f64; 2],
    /// `G_e(b)`, `G_o(b)`.
    pub(super) transforms: [f64; 2],
    /// What others add at the ends, and its size.
    pub(super) ripple: [f64; 2],
    pub(super) ripple_size: f64,
    /// Size of the slope of the profile.
    pub(super) steepest: f64,
}

impl Strip {
    pub(super) fn half(&self) -> f64 {
        0.5 * self.zone.length()
    }

    pub(super) fn centre(&self) -> f64 {
        0.5 * (self.zone.left() + self.zone.right())
    }

    /// `D` of one zone.
    pub(super) fn depth(&self, ground: &Ground) -> f64 {
        self.levels[0] / (ground.powers.exponent() * ground.total())
    }

    /// `d_e(b) -+ b d_o(b)` at the left (0) or right (1) end.
    pub(super) fn end_density(&self, side: usize) -> f64 {
        let [even, odd] = [0, 1].map(|part| self.levels[part] - self.transforms[part]);
        let arm = if side == 0 { -self.half() } else { self.half() };
        even + arm * odd + self.ripple[side]
    }

    /// Size of what is added up in that.
    pub(super) fn density_scale(&self) -> f64 {
        let [even, odd] = [0, 1].map(|part| self.levels[part].abs() + self.transforms[part].abs());
        even + self.half() * (odd + self.steepest) + self.ripple_size
    }
}
