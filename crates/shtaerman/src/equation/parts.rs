//! What is proved of a right-hand side between all samples.

use fredholm::Interval;

use super::Equation;
use crate::expression::Expression;
use crate::{Profile, Warning, WarningCode};

/// Degree of the polynomials that are to resolve a right-hand side on its parts.
const DEGREE: usize = 24;
/// How closely, relative to its range.
const TOLERANCE: f64 = 1e-12;

/// The parts of the interval on which the right-hand side is proved to be nearly a polynomial.
#[derive(Debug, Clone, Default)]
pub(super) struct Parts {
    /// Places between them.
    pub(super) cuts: Vec<f64>,
    /// Where nothing was proved.
    pub(super) unproved: Vec<[f64; 2]>,
}

impl Equation {
    /// The parts, found once; on a half-line those of the range on which the right-hand side must be finite.
    pub(super) fn parts(&self) -> &Parts {
        self.parts.get_or_init(|| Parts::of(self.right_hand_side(), self.range()))
    }
}

impl Parts {
    /// Those of a right-hand side on a range.
    pub(super) fn of(rhs: &Expression, range: Interval) -> Self {
        let (left, right) = (range.left(), range.right());
        let half_width = left.abs().max(right.abs());
        let piece = [left / half_width, right / half_width];
        let Ok(profile) = Profile::expression(rhs.text()) else {
            return Self { cuts: Vec::new(), unproved: vec![[left, right]] };
        };
        let found = profile.resolve(&[piece], half_width, DEGREE, TOLERANCE);
        let place = |xi: f64| (half_width * xi).clamp(left, right);
        let cuts = found.joints.iter().chain(&found.singular);
        let cuts = cuts.chain(found.unresolved.iter().flatten()).map(|xi| place(*xi));
        let cuts = crate::order::ascending(cuts);
        let unproved = found.unresolved.iter().map(|ends| ends.map(place)).collect();
        Self { cuts, unproved }
    }

    /// What a user should know where nothing was proved.
    pub(super) fn warning(&self) -> Option<Warning> {
        let [left, right] = self.unproved.first()?;
        Some(Warning {
            code: WarningCode::NotProved,
            message: format!(
                "between x = {left} and x = {right} nothing could be proved of the right-hand side: it was looked at in thousands of places, and what is narrower \
                 than their distances may be hidden there from every error that is stated"
            ),
        })
    }
}
