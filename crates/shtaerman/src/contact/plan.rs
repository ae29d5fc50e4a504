//! Which method solves a problem, and how far it goes.

use std::sync::Arc;

use fredholm::basis::Function;

use super::balance::State;
use super::parts::{Parts, Smoothness};
use super::promise::{Reached, require_explained};
use super::solution::{FullBase, Solution};
use super::warning::Warning;
use super::{Contact, Draft, collocated, spectral};
use crate::roughness::Law;
use crate::{ContactKind, Error, Geometry, MethodChoice, Problem};

/// Relative error that is aimed at where no tolerance is given.
pub const AIM: f64 = 1e-12;
/// Profiles of a higher Chebyshev degree than this oscillate faster than collocation should follow.
const LARGEST_COLLOCATED_DEGREE: usize = 256;
/// Profiles up to this degree are tried by collocation, too, where the degenerate kernel falls short.
const LARGEST_TRIED_DEGREE: usize = 2048;
/// The relative error to reach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Target {
    pub(super) tolerance: f64,
    /// Whether the user asked for it: then falling short is an error.
    pub(super) is_explicit: bool,
}

/// The route taken, with its reason.
struct Route {
    draft: Draft,
    reason: String,
    /// Chebyshev degree that shows the features of the profile.
    profile_degree: usize,
    /// Error of the series that stood for the profile, where it was not resolved.
    profile_error: Option<f64>,
}

impl Route {
    fn spectral(draft: Draft, function: &Function, reason: &str) -> Self {
        Self {
            draft,
            reason: reason.to_owned(),
            profile_degree: function.series().degree(),
            profile_error: (!function.is_resolved()).then(|| function.error()),
        }
    }

    fn collocated(draft: Draft, reason: String) -> Self {
        let profile_degree = draft.method.n;
        Self { draft, reason, profile_degree, profile_error: None }
    }
}

/// The direct solution of a problem with a rough layer.
pub(super) fn solve_rough(problem: &Problem) -> Result<Contact, Error> {
    match problem.solver().contact {
        ContactKind::Unilateral => problem.draw_up(problem.solve_unilateral()?),
        ContactKind::Bilateral if problem.is_plain() => match problem.solve_full_on_panels()? {
            Some(solution) => problem.draw_up(solution),
            None => problem.solve_full_base(),
        },
        ContactKind::Bilateral => problem.draw_up(problem.solve_full_contact()?),
    }
}

const SPECTRAL_REASON: &str = "asked for; n doubled until the bound was met or the last n reached, edge pressures by the iterated solution";

impl Problem {
    /// Solves the problem: zones of contact and pressure of a unilateral one, or the pressure on the full base by the method of the
    /// [`Solver`](crate::Solver), or by the one that suits it.
    ///
    /// # Errors
    /// [`Error::ProfileNotFinite`] where the profile is not finite; [`Error::Equation`] when a system does not fit into memory;
    /// [`Error::Overflow`] when the answer is not finite; [`Error::ToleranceNotMet`] when an explicit tolerance is out of reach.
    ///
    /// Of unilateral contact: [`Error::InvalidValue`] for a force that is not positive, [`Error::TipsOver`] for a moment or an eccentricity that no
    /// pressure on the base can balance, [`Error::NoContact`] for displacements that leave the base clear of the body;
    /// [`Error::NotComplementary`] when no zones were found.
    pub fn solve(&self) -> Result<Contact, Error> {
        let Some((lowered, level)) = self.lowered() else { return self.solve_as_given() };
        let level0 = self.frame().scaling().map_or(level, |scaling| level / scaling.displacement());
        match lowered.solve_as_given() {
            Ok(contact) => Ok(contact.with_level(self, level0)),
            Err(error) => Err(error.with_level(level, level0)),
        }
    }

    /// The solution with heights as they are.
    pub(super) fn solve_as_given(&self) -> Result<Contact, Error> {
        if let Some((settlement, e)) = self.settlement_at_eccentricity()
            && self.frame().law() != Law::Smooth
        {
            return self.solve_at_eccentricity(settlement, e);
        }
        if self.is_smooth_plane() {
            return self.draw_up(Arc::new(self.solve_smooth()?));
        }
        if self.is_smooth_disk() {
            return self.draw_up(self.solve_smooth_disk()?);
        }
        let grading = self.frame().grading().filter(|_| self.frame().law() == Law::Smooth);
        if let Some(grading) = grading {
            return self.draw_up(Arc::new(self.solve_smooth_graded(grading.exponent())?));
        }
        solve_rough(self)
    }

    /// Whether the surface is smooth and the kernel a plane logarithm.
    fn is_smooth_plane(&self) -> bool {
        let frame = self.frame();
        let is_plane = frame.geometry() != Geometry::Circular && frame.is_homogeneous();
        is_plane && frame.law() == Law::Smooth
    }

    /// Whether the surface is smooth and the punch circular.
    fn is_smooth_disk(&self) -> bool {
        self.frame().is_circular() && self.frame().law() == Law::Smooth
    }

    /// Whether this is one punch on a homogeneous half-plane with a linear layer, for which the spectral relation serves.
    fn is_plain(&self) -> bool {
        let frame = self.frame();
        let is_homogeneous = frame.is_homogeneous();
        frame.geometry() == Geometry::Plane && frame.law() == Law::Linear && is_homogeneous
    }

    /// The answer that zones amount to, if it keeps an explicit tolerance.
    fn draw_up(&self, solution: Arc<dyn Solution>) -> Result<Contact, Error> {
        let of_heights = self.of_heights(solution.as_ref()).map_or(0.0, |error| error.relative());
        let reached = solution.relative_error().max(of_heights);
        let State { settlement, tilt, .. } = solution.state();
        let method = solution.method();
        let displacements = [settlement, tilt];
        Reached { error: reached, method, displacements }.require_kept(self.solver())?;
        require_explained(solution.complementarity(), reached)?;
        let name = method.name;
        let zones = match solution.zones().len() {
            1 => "one zone".to_owned(),
            count => format!("{count} zones"),
        };
        let reason = match name {
            "panels" => format!(
                "{zones} with exact edges on panels between the bends of the base, for which collocation is not made, or where it did not find the zones"
            ),
            "first_kind" => {
                format!("{zones} on a smooth surface: the spectral relation of the first kind")
            }
            _ => format!("{zones} with exact edges: collocation converges exponentially"),
        };
        let mut contact = Contact::new(self, solution, reason)?;
        contact.warn(Warning::negative_pressure(self.frame(), contact.tension_at()));
        contact.warn(Warning::singular_edge(self.frame(), &contact.singular_corners()));
        contact.warn(Warning::singular_kink(self.frame(), contact.kinks()));
        contact.warn(Warning::profile_not_proved(self.has_unknown_layer()));
        if self.solver().tolerance.is_none() && reached > AIM {
            contact.warn(Some(Warning::tolerance_not_met(AIM, reached)));
        }
        Ok(contact)
    }

    fn solve_full_base(&self) -> Result<Contact, Error> {
        let solver = self.solver();
        let target = Target {
            tolerance: solver.tolerance.unwrap_or(AIM),
            is_explicit: solver.tolerance.is_some(),
        };
        let Route { draft, reason, profile_degree, profile_error } =
            match (solver.method, solver.degree) {
                (MethodChoice::Spectral | MethodChoice::Auto, Some(degree)) => {
                    let function = self.resolved_profile()?;
                    let draft = spectral::solve_with_bounds(self, &function, degree)?;
                    Route::spectral(
                        draft,
                        &function,
                        "a given n fixes the truncation of the degenerate kernel",
                    )
                }
                (MethodChoice::Spectral, None) => {
                    let function = self.resolved_profile()?;
                    let draft = spectral::solve_adaptively(self, &function, target)?;
                    Route::spectral(draft, &function, SPECTRAL_REASON)
                }
                (MethodChoice::Sinc, _) => {
                    let draft = collocated::solve(self, &self.collocated_parts(), target)?;
                    Route::collocated(draft, "asked for".to_owned())
                }
                (MethodChoice::Auto, None) => self.choose(target)?,
            };
        let is_unknown = self.has_unknown_layer();
        let draft = if is_unknown { draft.of_the_unknown(self) } else { draft };
        let solution = FullBase { draft, profile_degree };
        let draft = &solution.draft;
        let of_heights = self.of_heights(&solution).map_or(0.0, |error| error.relative());
        let reached = draft.relative_error(self).max(of_heights);
        let displacements = [draft.state.settlement, draft.state.tilt];
        Reached { error: reached, method: draft.method, displacements }.require_kept(solver)?;
        let fixed = solver.degree.is_some();
        let fell_short = (reached > target.tolerance).then_some(reached);
        let mut contact = Contact::new(self, Arc::new(solution), reason)?;
        contact.warn(Warning::negative_pressure(self.frame(), contact.tension_at()));
        contact.warn(Warning::profile_not_proved(is_unknown));
        if let Some(reached) = fell_short.filter(|_| !fixed) {
            contact.warn(Some(Warning::tolerance_not_met(target.tolerance, reached)));
        }
        if contact.method().name == "spectral" {
            contact.warn(profile_error.map(Warning::profile_not_resolved));
            contact.warn(Warning::low_degree(contact.method().n, self.frame().theta0()));
        }
        Ok(contact)
    }

    /// The plain degenerate kernel of a given degree, without an estimate of its error, and its iterated pressure at the right edge, in the units of the problem.
    pub(crate) fn solve_iterated(&self, degree: usize) -> Result<(Contact, f64), Error> {
        let (problem, level) = self.lowered().unwrap_or_else(|| (self.clone(), 0.0));
        let function = problem.resolved_profile()?;
        let draft = spectral::solve(&problem, &function, degree)?;
        let [_, edge] = spectral::iterated_edges(&problem, &function, &draft);
        let profile_degree = function.series().degree();
        let solution = Arc::new(FullBase { draft, profile_degree });
        let contact = Contact::new(&problem, solution, "a given degree".to_owned())?;
        let displacement = self.frame().scaling().map_or(1.0, crate::Scaling::displacement);
        let contact = contact.with_level(self, level / displacement);
        let scale = self.frame().scaling().map_or(1.0, crate::Scaling::pressure);
        Ok((contact, edge * scale))
    }

    fn choose(&self, target: Target) -> Result<Route, Error> {
        let parts = self.parts();
        let breaks = &parts.joints;
        let mut candidates = Vec::new();
        // Resolving a profile with a kink takes long and leads nowhere: panels are tried first.
        if !breaks.is_empty() && !parts.are_many() {
            let draft = collocated::solve(self, &parts, target)?;
            let reason = format!(
                "the profile has {} breakpoint(s): collocation on the panels between them",
                breaks.len()
            );
            if draft.meets(self, target.tolerance) {
                return Ok(Route::collocated(draft, reason));
            }
            candidates.push(Route::collocated(draft, reason));
        }
        let function = self.resolved_profile()?;
        let degree = function.series().degree();
        if function.is_resolved() && degree <= LARGEST_COLLOCATED_DEGREE {
            let draft = collocated::solve(self, &parts.uncut(), target)?;
            let reason = "the profile is smooth: collocation converges exponentially".to_owned();
            return Ok(Route::collocated(draft, reason));
        }
        let draft = spectral::solve_adaptively(self, &function, target)?;
        let met = draft.meets(self, target.tolerance);
        let needed =
            if function.is_resolved() { degree.to_string() } else { "beyond 131072".to_owned() };
        let reason = format!(
            "the profile needs Chebyshev degree {needed}: the structured spectral solve; edge pressures by the iterated solution"
        );
        candidates.push(Route::spectral(draft, &function, &reason));
        if !met && function.is_resolved() && degree <= LARGEST_TRIED_DEGREE {
            let draft = collocated::solve(self, &parts.uncut(), target)?;
            let reason = "the profile oscillates: collocation on many nodes came closer than the degenerate kernel";
            candidates.push(Route::collocated(draft, reason.to_owned()));
        }
        let error = |route: &Route| route.draft.relative_error(self);
        candidates
            .into_iter()
            .min_by(|one, two| error(one).total_cmp(&error(two)))
            .map_or_else(|| unreachable!("the spectral route is always a candidate"), Ok)
    }

    /// The parts of the base as collocation takes them: uncut where there are more than can have panels.
    pub(super) fn collocated_parts(&self) -> Parts {
        let parts = self.parts();
        if parts.are_many() { parts.uncut() } else { parts }
    }

    /// Whether the surface is rough and nothing is proved of the profile between samples.
    fn has_unknown_layer(&self) -> bool {
        self.frame().law() != Law::Smooth && self.parts().smoothness == Smoothness::Unknown
    }

    /// The whole base on panels, where nobody asked for another method and it was measured, or falls into more parts than are collocated.
    fn solve_full_on_panels(&self) -> Result<Option<Arc<dyn Solution>>, Error> {
        let solver = self.solver();
        let is_free = solver.method == MethodChoice::Auto && solver.degree.is_none();
        let is_measured = self.profile().measured_points().is_some();
        if !is_free || !(is_measured || self.parts().are_many()) {
            return Ok(None);
        }
        self.solve_full_contact_on_panels()
    }
}
