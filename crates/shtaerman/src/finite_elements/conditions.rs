//! What a table asks of a problem, and what it is told by a contact.

use crate::error::require;
use crate::{Contact, ContactKind, Datum, Error, Load, Problem, Rotational, Vertical};

/// Shares that straight lines may be asked to keep: below the first, rounding would be a part of what is measured.
pub const SHARES: [f64; 2] = [1e-8, 0.5];

/// Refuses a share that no table is made for.
pub(super) fn check_share(share: f64) -> Result<(), Error> {
    let requirement = "from 1e-8 to 0.5";
    let is_sound = (SHARES[0]..=SHARES[1]).contains(&share);
    require(is_sound, "share", share, requirement).map(|_| ())
}

/// Refuses problems whose contact no table describes.
///
/// # Errors
/// [`Error::NoTable`] for a dimensionless and for a bilateral problem.
pub fn check_problem(problem: &Problem) -> Result<(), Error> {
    let reason = if problem.is_dimensionless() {
        "a dimensionless problem has no units that a finite-element model could share: its lengths are in half-widths and its displacements in chi E; state it in [foundation], [punch] and [load]"
    } else if problem.solver().contact() == ContactKind::Bilateral {
        "a bilateral contact may pull, and the contact of a finite-element model lets go: set solver.contact = \"unilateral\"; the stiffness of a bilateral contact is the one that `solve` tells, the same under any load"
    } else {
        return Ok(());
    };
    Err(Error::NoTable { reason })
}

/// The settlement, against a datum if there is one (m).
pub(super) fn settlement(contact: &Contact, datum: Option<Datum>) -> Result<f64, Error> {
    match datum {
        Some(datum) => Ok(contact.relative_settlement(datum)?.settlement),
        None => Ok(contact.settlement()),
    }
}

/// What goes with every force of a load: its tilt, or its eccentricity.
pub(super) fn standing(contact: &Contact) -> Rotational {
    contact.problem().load().rotational.standing(contact.force())
}

/// What stays when the force of a contact changes by itself: its tilt, or its moment.
pub(super) fn held(contact: &Contact) -> Rotational {
    match contact.problem().load().rotational() {
        Rotational::Eccentricity(eccentricity) => {
            Rotational::Moment(eccentricity * contact.force())
        }
        other => other,
    }
}

/// The problem under a force with its tilt, its eccentricity or its moment.
pub(super) fn under(
    problem: &Problem,
    force: f64,
    rotational: Rotational,
) -> Result<Contact, Error> {
    problem.with_load(Load::new(Vertical::Force(force), rotational)?)?.solve()
}
