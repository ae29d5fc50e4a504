//! A half-plane under one punch, a pair, a row or a wave.
//!
//! On a zone `xi = c + b cos phi` the pressure is `p0 = G(phi)/(theta0 b sin phi)`, `G = sum gamma_k cos(k phi)`, and the spectral relation gives its own displacement
//! `pi gamma_0 ln(2/b) + sum (pi/k) gamma_k cos(k phi)`; beyond the zone, with `|xi - c|/b = (w + 1/w)/2`, `pi gamma_0 ln(2/(b w)) + sum (pi/k) gamma_k (+-1/w)^k`. A few modes are
//! [coupled](super::modes) to those of the other zones; all higher ones answer to the profile alone, `gamma_k = -k f_k/pi`, and are kept as the [conjugate](Conjugate) `F` of its slope:
//!
//! `G(phi) = -F(phi)/pi + sum s_k cos(k phi)`.

mod coupling;
mod full;
mod kernel;
mod on_zone;
mod part;
mod solved;
mod wave;

use std::sync::Arc;

use fredholm::inversion::Conjugate;

use super::base::Base;
use super::equation::{COMPARED, Detail, FirstKind};
use crate::contact::zones::Zone;
use crate::rounding::OF_A_VALUE;
use crate::{Error, Geometry};
use kernel::Kernel;
use on_zone::OnZone;
use solved::Solved;

pub(super) use wave::solve as wave;

/// Number of modes for each zone, where there is no period.
///
/// # Errors
/// [`Error::ZonesTooClose`].
pub(super) fn counts(zones: &[Zone], digits: f64) -> Result<Vec<usize>, Error> {
    coupling::counts(Kernel { period: None }, zones, digits)
}

/// The equation on a half-plane.
pub(super) struct Plane {
    base: Arc<Base>,
    kernel: Kernel,
}

impl Plane {
    pub(super) fn new(base: Arc<Base>) -> Self {
        let bodies = base.setting.problem().bodies();
        let period = match bodies.geometry().scaled(bodies.half_width()) {
            Geometry::Periodic { period } => Some(period),
            _ => None,
        };
        Self { base, kernel: Kernel { period } }
    }

    /// The slope of the profile on a zone about its mean, which is returned too.
    fn resolved(&self, zone: Zone, detail: Detail) -> (Arc<Conjugate>, f64) {
        let base = &self.base;
        let angles = |places: &[f64]| -> Vec<f64> {
            let inside = places.iter().filter(|at| zone.left() < **at && **at < zone.right());
            inside.map(|at| super::pressure::place(&zone, *at).angle()).collect()
        };
        let [bends, joints] = [&base.breaks, &base.joints].map(|places| angles(places));
        let on_zone = OnZone::new(base, zone);
        // Places rounded to doubles leave the slope of a short zone far off the middle no more digits.
        let nearest = zone.left().max(-zone.right()).max(0.0);
        let tolerance = base.tolerance.max(OF_A_VALUE * nearest / zone.length());
        let slope = Conjugate::resolve(&on_zone, [&bends, &joints], [detail.panels, 1], tolerance);
        (Arc::new(slope), on_zone.mean())
    }
}

impl FirstKind for Plane {
    type Solved = Solved;

    fn base(&self) -> &Arc<Base> {
        &self.base
    }

    fn on_zones(&self, zones: &[Zone], detail: Detail) -> Result<Solved, Error> {
        let resolved = zones.iter().map(|zone| self.resolved(*zone, detail)).collect();
        Solved::new(&self.base, self.kernel, zones, detail, resolved)
    }

    /// Slopes that do not depend on the detail are kept.
    fn compared(&self, solved: &Solved) -> Option<Solved> {
        let kept = solved.sampled_slopes();
        let resolved = solved.zones.iter().zip(kept);
        let resolved =
            resolved.map(|(zone, kept)| kept.unwrap_or_else(|| self.resolved(*zone, COMPARED)));
        Solved::new(&self.base, self.kernel, &solved.zones, COMPARED, resolved.collect()).ok()
    }
}
