//! Contact of a base with ends.

use super::answer::SmoothContact;
use super::check::check;
use super::detail::FINE;
use super::problem::Base;
use super::system::Solved;
use crate::Error;
use crate::contact::edges::settle;
use crate::contact::search::{ALLOWED, complementary};
use crate::contact::zones::Zone;

/// The answer on the zones of a base, for which a zone to try first may be known.
pub(super) fn solve_zones(base: &Base<'_>, first: Option<Zone>) -> Result<SmoothContact, Error> {
    if base.problem.is_unilateral {
        return match first.and_then(|zone| tried(base, zone)) {
            Some(contact) => contact,
            None => {
                let (solved, left) = complementary(base)?;
                SmoothContact::new(base, solved, &left)
            }
        };
    }
    let solved = Solved::new(base, &base.whole(), FINE)?;
    let left = check(base, &solved, ALLOWED);
    SmoothContact::new(base, solved, &left)
}

/// The answer if this zone leads there: the pressure without tension and penetration is but one.
fn tried(base: &Base<'_>, zone: Zone) -> Option<Result<SmoothContact, Error>> {
    let solved = settle(base, &[zone], &FINE).ok()?;
    let left = check(base, &solved, ALLOWED);
    left.is_clean().then(|| SmoothContact::new(base, solved, &left))
}
