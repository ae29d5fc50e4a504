//! What is said to be resolved by polynomials is.

use proptest::prelude::*;

use crate::contact::trees::tree;
use shtaerman::{MethodChoice, Profile, Solver, file};

const DEGREE: usize = 32;
const TOLERANCE: f64 = 1e-8;
/// `x = a xi`.
const HALF_WIDTH: f64 = 2.0;
const SAMPLES: usize = 40;

/// A part of the base with the profile's values at Chebyshev points of it.
struct Interpolant {
    middle: f64,
    half: f64,
    nodes: Vec<(f64, f64, f64)>,
}

impl Interpolant {
    fn of(profile: &Profile, [left, right]: [f64; 2]) -> Self {
        let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
        let node = |i: usize| {
            let angle = std::f64::consts::PI * (i as f64 + 0.5) / DEGREE as f64;
            let weight = if i.is_multiple_of(2) { angle.sin() } else { -angle.sin() };
            let value = profile.height(middle + half * angle.cos(), HALF_WIDTH);
            (angle.cos(), weight, value)
        };
        Self { middle, half, nodes: (0..DEGREE).map(node).collect() }
    }

    /// By the barycentric formula.
    fn at(&self, t: f64) -> f64 {
        let (mut above, mut below) = (0.0, 0.0);
        for (node, weight, value) in &self.nodes {
            above += weight / (t - node) * value;
            below += weight / (t - node);
        }
        above / below
    }
}

/// Places between nodes, none of which is one, also close to the ends.
fn places() -> impl Iterator<Item = f64> {
    (0..SAMPLES).map(|i| -((i as f64 + 0.37) / SAMPLES as f64 * std::f64::consts::PI).cos())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, max_global_rejects: 65_536, ..ProptestConfig::default() })]

    #[test]
    fn proved_parts_of_random_profiles_are_resolved(tree in tree()) {
        let text = tree.text();
        let profile = Profile::expression(&text).unwrap();
        prop_assume!(profile.find_not_finite(HALF_WIDTH).is_none());
        let found = profile.resolve(&[[-1.0, 1.0]], HALF_WIDTH, DEGREE, TOLERANCE);
        prop_assert!(found.joints.is_sorted() && found.joints.iter().all(|xi| xi.abs() < 1.0));
        let cuts = [&[-1.0], &found.joints[..], &[1.0]].concat();
        let is_rough = |part: &[f64]| {
            let is_singular = found.singular.iter().any(|place| (part[0] - 1e-11..=part[1] + 1e-11).contains(place));
            is_singular || found.unresolved.iter().any(|[from, to]| *from < part[1] && part[0] < *to)
        };
        let parts: Vec<[f64; 2]> = cuts.windows(2).filter(|part| !is_rough(part)).map(|part| [part[0], part[1]]).collect();
        // The range of heights is that of the whole base, resolved or not.
        let heights = || places().map(|xi| profile.height(xi, HALF_WIDTH));
        let mut least = heights().fold(f64::INFINITY, f64::min);
        let mut most = heights().fold(f64::NEG_INFINITY, f64::max);
        let mut rounding = 0.0_f64;
        let mut worst = (0.0_f64, 0.0);
        for &part in &parts {
            let interpolant = Interpolant::of(&profile, part);
            for t in places() {
                let xi = interpolant.middle + interpolant.half * t;
                let value = profile.height(xi, HALF_WIDTH);
                (least, most) = (least.min(value), most.max(value));
                let width = profile.enclose_at(xi, HALF_WIDTH).map_or(f64::INFINITY, |range| range.upper() - range.lower());
                rounding = rounding.max(width);
                let seen = (interpolant.at(t) - value).abs();
                if seen > worst.0 {
                    worst = (seen, xi);
                }
            }
        }
        // The formula of the interpolant overflows before the profile does.
        if least.abs().max(most.abs()) > 1e250 {
            return Ok(());
        }
        rounding += 1e-14 * least.abs().max(most.abs());
        // The best polynomial is as close as the tolerance, an interpolant a few times as far.
        let allowed = 5.0 * TOLERANCE * (most - least).max(0.0) + 10.0 * rounding;
        prop_assert!(worst.0 <= allowed, "{text}: off by {:e} at {:e}, allowed {allowed:e}, {found:?}", worst.0, worst.1);
    }
}

/// Under fast waves few numbers of nodes resolve the pressure at all, and their differences tell of the coarser ones: what the nodes miss between them tells of the last. The degenerate kernel has its
/// bound, and the audit asks nothing of the way.
#[test]
fn the_last_number_of_nodes_states_its_own_error() {
    for (wave, shift) in [(137.0, 0.3), (260.5, 1.0), (350.0, 0.0), (437.5, 0.0), (500.0, 0.0)] {
        let text = format!(
            "[dimensionless]\ntheta0 = 60\nprofile = \"cos({wave}*xi + {shift})\"\nforce = 1\nmoment = 0\n"
        );
        let problem = file::parse(&text, "test").unwrap();
        let by = |solver: Solver| problem.with_solver(solver).solve().unwrap();
        let contact = by(Solver::bilateral());
        let kernel = by(Solver::bilateral().with_method(MethodChoice::Spectral).unwrap());
        let [stated, bound] = [&contact, &kernel].map(|contact| contact.error().unwrap());
        let largest = contact.peak_pressure();
        assert!(stated.pressure < 1e-11 * largest, "{wave}: {stated:?}");
        assert!(
            (contact.settlement() - kernel.settlement()).abs()
                <= stated.settlement + bound.settlement
        );
        assert!((contact.tilt() - kernel.tilt()).abs() <= stated.tilt + bound.tilt);
        for i in -20..=20 {
            let xi = 0.0499 * f64::from(i);
            let [one, other] = [&contact, &kernel].map(|contact| contact.pressure(xi).unwrap());
            assert!((one - other).abs() <= stated.pressure + bound.pressure, "{wave} at {xi}");
        }
        let audited = contact.audited().unwrap().error().unwrap().pressure;
        assert!(audited < 1e-10 * largest, "{wave}: {audited:e}");
    }
}
