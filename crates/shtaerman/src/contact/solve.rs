//! From a problem to its contact: setting, route, solution, and what is to be said of that.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::Contact;
use super::balance::State;
use super::method::MethodName;
use super::promise::{Reached, require_explained};
use super::revolution::require_even;
use super::route::{Found, Reason, solution};
use super::setting::Setting;
use super::spectral::{SpectralContact, profile_series};
use crate::quantity::OutputUnits;
use crate::roughness::Law;
use crate::solver::AIM;
use crate::warning::Warning;
use crate::{Error, Problem, Scaling};

impl Problem {
    /// Refuses what [`Problem::solve`] refuses whatever the contact would be: a circular base that is no body of revolution, a tilt or a moment of a base that fills its period, or of a disk whose rough
    /// layer has a power law. Whether the punch touches anywhere, and whether a method finds its contact, only a solution tells.
    ///
    /// ```
    /// use shtaerman::file;
    ///
    /// let wave = |tilt: f64| {
    ///     let text = format!("[dimensionless]\ntheta0 = 2\ngeometry = \"periodic\"\nperiod = 2\nprofile = \"cos(pi*xi)\"\nforce = 1\ntilt = {tilt}\n");
    ///     file::parse(&text, "wave.toml")
    /// };
    /// assert!(wave(0.0)?.check().is_ok());
    /// assert!(wave(0.1)?.check().is_err());
    /// # Ok::<(), shtaerman::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for these, and [`Error::TipsOver`] and the like for a load that no pressure balances.
    pub fn check(&self) -> Result<(), Error> {
        if self.is_circular() {
            require_even(self)?;
            return self.require_one_harmonic();
        }
        if self.is_wave() {
            self.require_no_turn()?;
        }
        self.check_balance()
    }

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
    ///
    /// [`Error::TimeLimit`] where the solver has a [time limit](crate::Solver::with_time_limit) and it ends the search; [`Error::WorkLimit`] where it has none, and the search is a long one.
    pub fn solve(&self) -> Result<Contact, Error> {
        let contact = self.solve_or_best()?;
        if contact.is_unfinished() {
            // Also of a problem solved on the way to another's answer, whose solver has no limit of its own.
            return Err(self.out_of_time());
        }
        Ok(contact)
    }

    /// The same, but for a search that the [time limit](crate::Solver::with_time_limit) ends: the best it had come to then, which is [no answer](Contact::is_unfinished), if that is a contact.
    ///
    /// # Errors
    /// Those of [`Problem::solve`].
    pub fn solve_or_best(&self) -> Result<Contact, Error> {
        let found = match self.timed() {
            None => self.solve_at_level(),
            Some(timed) => timed.ended(Self::solve_at_level),
        };
        found.map_err(|error| error.with_roughness(self.small_roughness()))
    }

    /// What is found within the time of a problem that has one, which ends with it.
    fn ended(&self, found: impl FnOnce(&Self) -> Result<Contact, Error>) -> Result<Contact, Error> {
        let found = found(self);
        let is_past = self.deadline().is_past();
        self.deadline().lift();
        match found {
            // What the end of the time made of the search.
            Err(_) if is_past => Err(self.out_of_time()),
            Ok(contact) if contact.is_unfinished() && self.solver().time_limit().is_none() => {
                Err(self.out_of_time())
            }
            found => found,
        }
    }

    fn out_of_time(&self) -> Error {
        let of_work = Error::WorkLimit { roughness: self.small_roughness() };
        self.solver().time_limit().map_or(of_work, |limit| Error::TimeLimit { limit })
    }

    /// [Solves](Self::solve) the problem unless `stop` is set meanwhile, from another thread: the search then ends at its next step, and there is no answer.
    ///
    /// # Errors
    /// Those of [`Problem::solve`].
    pub fn solve_unless(&self, stop: &Arc<AtomicBool>) -> Option<Result<Contact, Error>> {
        let found = self.stopped_by(stop).ended(Self::solve);
        Some(found).filter(|found| found.is_ok() || !stop.load(Ordering::Relaxed))
    }

    /// The solution with heights counted from the level of the base, and put back there.
    fn solve_at_level(&self) -> Result<Contact, Error> {
        let Some((lowered, level)) = self.lowered() else { return self.solve_as_given() };
        let level0 = level / self.bodies().unit(Scaling::displacement);
        match lowered.solve_as_given() {
            Ok(contact) => Ok(contact.with_level(self, level0)),
            Err(error) => Err(error.with_level(level, level0)),
        }
    }

    /// The solution with heights as they are.
    pub(super) fn solve_as_given(&self) -> Result<Contact, Error> {
        match self.settlement_at_eccentricity() {
            None => self.solve_at_once(),
            Some((settlement, e)) if self.bodies().law() != Law::Smooth => {
                self.solve_at_eccentricity(settlement, e)
            }
            // Of zones without a layer few are looked for at once, sooner than through all forces; where there are none those tell whether the settlement is in reach.
            Some((settlement, e)) => match self.solve_at_once() {
                Err(error) if error.is_numerical() => {
                    let found = self.solve_at_eccentricity(settlement, e);
                    found.map_err(|other| if other.is_numerical() { error } else { other })
                }
                found => found,
            },
        }
    }

    fn solve_at_once(&self) -> Result<Contact, Error> {
        let setting = Setting::new(self);
        let found = solution(&setting)?;
        draw_up(setting, found)
    }

    /// The plain degenerate kernel of a given degree, without an estimate of its error, and its iterated pressure at the right edge, in the units of the problem.
    pub(crate) fn solve_iterated(&self, degree: usize) -> Result<(Contact, f64), Error> {
        let (problem, level) = self.lowered().unwrap_or_else(|| (self.clone(), 0.0));
        let setting = Setting::new(&problem);
        let series = profile_series(&setting)?;
        let contact = SpectralContact::new(&setting, &series, degree)?;
        let [_, edge] = contact.iterated_edges(&series);
        let found = Found::spectral(contact, Reason::DegreeGiven);
        let of_heights = setting.of_heights(found.solution.as_ref());
        let contact = Contact::new(setting, found, of_heights)?;
        let [displacement, pressure] = [Scaling::displacement, Scaling::pressure]
            .map(|unit: fn(&Scaling) -> f64| self.bodies().unit(unit));
        Ok((contact.with_level(self, level / displacement), edge * pressure))
    }
}

/// The answer that a solution amounts to, if it keeps an explicit tolerance, with its warnings.
fn draw_up(setting: Setting, found: Found) -> Result<Contact, Error> {
    if setting.problem().deadline().is_past() {
        return Contact::unfinished(setting, found);
    }
    let solution = found.solution.as_ref();
    let (method, profile_error) = (solution.method(), found.profile_error);
    let of_heights = setting.of_heights(solution);
    let reached = solution.relative_error().max(of_heights.map_or(0.0, |error| error.relative()));
    let State { settlement, tilt, .. } = solution.state();
    let solver = *setting.problem().solver();
    Reached { error: reached, method, displacements: [settlement, tilt] }.require_kept(&solver)?;
    require_explained(solution.complementarity(), reached)?;
    let is_unknown = setting.has_unknown_layer();
    let mut contact = Contact::new(setting, found, of_heights)?;
    let bodies = contact.problem().bodies().clone();
    for code in Contact::PLACED {
        contact.warn(contact.placed_warning(code, &OutputUnits::default()));
    }
    contact.warn(Warning::profile_not_proved(is_unknown));
    let is_free = solver.tolerance.is_none() && solver.degree.is_none();
    contact.warn((is_free && reached > AIM).then(|| Warning::tolerance_not_met(AIM, reached)));
    if method.name == MethodName::Spectral {
        contact.warn(profile_error.map(Warning::profile_not_resolved));
        contact.warn(Warning::low_degree(method.n, bodies.theta0()));
    }
    Ok(contact)
}
