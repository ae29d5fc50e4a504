//! The residual of an answer, bounded between the places where it is computed.
//!
//! `w = q + theta K q - (delta - alpha x - f)`. On a window `[c - r, c + r]` it is the sum of a function that is analytic in the disk of radius `R > r` about `c`, the profile, and a
//! remainder: in that disk the density is replaced by one polynomial, off by at most `eta`, so the potential of what is left is at most `eta int |K|`. Interpolation at Chebyshev
//! nodes then bounds the analytic part from its values, with the remainders of the book's chapter on the audit.

use std::cell::Cell;

use crate::allowance::UNIT;
use crate::density::Density;
use crate::places::Places;
use crate::profile::Profile;

/// Beside the origin, where numbers are as fine as one likes, they are at least that of this share of the whole.
pub(crate) const SMALLEST: f64 = 1e-3;

/// Places of jumps are as exact as this, relative to them: a quotient or product of two numbers, or the root of what a formula compares.
const BLURRED: f64 = 4.0 * f64::EPSILON;

/// How far a jump of the base may lie from where its formula jumps: some roundings of its place.
pub(crate) fn blur(x: f64) -> f64 {
    BLURRED * x.max(SMALLEST)
}

/// What is known of the residual on a window.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounded {
    pub(crate) left: f64,
    pub(crate) right: f64,
    /// A bound of `|w|` in a zone, of `max(-w, 0)` beside zones.
    pub(crate) largest: f64,
    /// A bound of the norm of the same in `L2` of the window.
    pub(crate) norm: f64,
    /// The largest of these at numbers of the machine in the window, where it is as narrow as these allow: elsewhere the same.
    pub(crate) at_numbers: f64,
    /// A lower bound of `w`.
    pub(crate) least: f64,
    /// Whether the window could not be resolved: its measure is a few units of the machine.
    pub(crate) is_narrow: bool,
}

/// An answer of which the residual is formed.
pub(crate) struct Residual<'a> {
    pub(crate) density: &'a Density,
    /// The answer's own pressure.
    pub(crate) pressure: &'a (dyn Fn(f64) -> f64 + Sync),
    pub(crate) profile: &'a dyn Profile,
    /// Places where the base may jump.
    pub(crate) cuts: &'a [f64],
    pub(crate) theta: f64,
    pub(crate) settlement: f64,
    pub(crate) tilt: f64,
    /// What `theta`, the profile and what is given of settlement and tilt may be off by, relative to their sizes.
    pub(crate) scaled: f64,
    /// Whether settlement and tilt are free: then they take up what scaling does to them.
    pub(crate) free: [bool; 2],
    /// What rounding was of the last window: remainders of the next need not be smaller.
    pub(crate) noise: Cell<f64>,
    /// The largest residual of the last window in a zone.
    pub(crate) before: Cell<f64>,
    /// The ends of the last window, and whether it is open on which side of a jump they lie.
    pub(crate) ends: Cell<[(f64, bool); 2]>,
    /// How often panels were looked at, and what else counts as such looks.
    pub(crate) looks: Cell<u64>,
}

impl Residual<'_> {
    /// `w(x)` and a bound of its rounding.
    pub(crate) fn at(&self, x: f64) -> (f64, f64) {
        let mut potential = [(0.0, 0.0)];
        self.potentials(&Places::numbers(&[x]), &mut potential);
        self.formed(x, self.profile.height(x), self.density.value(x), potential[0])
    }

    /// `int K(x, t) q(t) dt` at places that lie together, each with a bound of its rounding.
    pub(crate) fn potentials(&self, places: &Places<'_>, found: &mut [(f64, f64)]) {
        self.count(self.density.potentials(places, found));
    }

    /// Counts what takes as long as so many looks.
    pub(crate) fn count(&self, looks: u64) {
        self.looks.set(self.looks.get() + looks);
    }

    /// The same from bounds of `f(x)`, and from `q(x)` and its potential, each with a bound of its rounding.
    pub(crate) fn formed(
        &self,
        x: f64,
        [low, high]: [f64; 2],
        (q, evaluated): (f64, f64),
        (potential, rounding): (f64, f64),
    ) -> (f64, f64) {
        let height = 0.5 * (low + high);
        let [turned, potential] = [self.tilt * x, self.theta * potential];
        let line = self.settlement - turned;
        let above = line - height;
        let off = q - above;
        let value = off + potential;
        // One rounding of each of these, and one of the place, which need be no number of the machine.
        let sizes = [turned, turned, line, height, above, off, potential, value];
        let size: f64 = sizes.iter().map(|term| term.abs()).sum();
        let error = self.theta * rounding + evaluated + 0.5 * (high - low) + UNIT * size;
        (value, error + self.scaled * self.given(x, height, q, value))
    }

    /// What a relative change of `theta` and of what is given does to `w`, beside a line: `theta K q = w - q + delta - alpha x - f`.
    fn given(&self, x: f64, height: f64, q: f64, w: f64) -> f64 {
        let taken = |is_free: bool, term: f64| if is_free { 0.0 } else { term.abs() };
        let line = taken(self.free[0], self.settlement) + taken(self.free[1], self.tilt * x);
        w.abs() + q.abs() + 2.0 * (height.abs() + line)
    }
}
