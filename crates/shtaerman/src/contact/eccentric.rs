//! A settlement prescribed together with an eccentricity: the force is found that leads to it.
//!
//! Under a force `P` at the eccentricity `e` there is one contact, with a settlement `delta(P)` and
//! `d delta/dP = (c22 - e c12)/(c11 c22 - c12^2)`, its tangent stiffness. The curve begins where the base touches first and ends in proportion to the force: upwards
//! while the line of the force is not far from the middle, downwards beyond, as the punch then turns about a point on the other side of it. Between it need not be
//! monotone, and not every settlement is met: of the forces that meet it the least is taken.

use crate::contact::Contact;
use crate::contact::search::COARSELY_ALLOWED;
use crate::contact::valleys::SAMPLES;
use crate::line_search::STEPS;
use crate::{ContactKind, Error, Load, Problem, Rotational, Scaling, Vertical};

/// The forces that are tried: each so many times the one before, from the depth over the compliance of the whole base from so many steps down to so many up. At half or twice 1 of 5 answers are lost and time grows by 161 % (survey).
const RATIO: f64 = 4.0;
const REACH: i32 = 18;

impl Problem {
    /// Settlement and eccentricity of a base that may lift off, where both are prescribed and the force is off the middle: no problem of least energy.
    pub(super) fn settlement_at_eccentricity(&self) -> Option<(f64, f64)> {
        if self.solver().contact == ContactKind::Bilateral {
            return None;
        }
        let Load { vertical, rotational } = self.dimensionless_load();
        let Vertical::Settlement(settlement) = vertical else { return None };
        let Rotational::Eccentricity(e) = rotational else { return None };
        (e != 0.0).then_some((settlement, e))
    }

    /// The contact under the least force at `e` with this settlement.
    ///
    /// # Errors
    /// [`Error::NoContact`] where the base is clear and no force leads there, [`Error::SettlementOutOfReach`] where none does though it is not;
    /// [`Error::NotComplementary`] where contacts on the way were not found.
    pub(super) fn solve_at_eccentricity(&self, settlement: f64, e: f64) -> Result<Contact, Error> {
        if self.bodies().is_circular() {
            return self.solve_disk_at_eccentricity(settlement);
        }
        let loose = self.solver().tolerance.unwrap_or(0.0).max(on_the_way());
        let way = self.with_solver(self.solver().with_tolerance(loose)?);
        let curve = Curve { problem: self, way: &way, settlement, e };
        match curve.search() {
            Search::Found(point) => point.contact.settled_at(self, settlement),
            Search::Turns(excess) => Err(curve.out_of_reach(excess)),
            Search::Lost if curve.is_clear() => Err(Error::NoContact),
            Search::Lost => {
                Err(Error::NotComplementary { tension: f64::NAN, penetration: f64::NAN })
            }
        }
    }

    /// The same for a circular punch in full contact, whose force depends on the settlement alone.
    fn solve_disk_at_eccentricity(&self, settlement: f64) -> Result<Contact, Error> {
        let given = *self.load();
        let level = Load { rotational: Rotational::Tilt(0.0), ..given };
        let force = self.under(level).solve_as_given()?.state().force;
        let force = force * self.bodies().unit(Scaling::force);
        let under = Load { vertical: Vertical::Force(force), ..given };
        self.under(under).solve_as_given()?.settled_at(self, settlement)
    }
}

/// To this tolerance contacts are found on the way, which shows their zones: under the smallest forces heights have no more digits.
fn on_the_way() -> f64 {
    COARSELY_ALLOWED.sqrt()
}

/// What a search along the curve comes to.
enum Search {
    Found(Box<Point>),
    /// The least distance from the settlement, with its sign.
    Turns(f64),
    /// Contacts on the way were not found.
    Lost,
}

/// A point of the curve.
struct Point {
    /// `ln P`.
    log: f64,
    /// `delta(P) - delta`.
    excess: f64,
    /// `d delta/d ln P`.
    slope: f64,
    contact: Contact,
}

impl Point {
    fn is_beyond(&self, other: &Self) -> bool {
        (self.excess > 0.0) != (other.excess > 0.0)
    }

    /// Whether the distance from the settlement falls with the force.
    fn falls(&self) -> bool {
        (self.excess > 0.0) != (self.slope > 0.0)
    }
}

/// `delta(P)` at an eccentricity.
struct Curve<'p> {
    problem: &'p Problem,
    /// The same with a tolerance that serves to find the way.
    way: &'p Problem,
    settlement: f64,
    e: f64,
}

impl Curve<'_> {
    /// The contact under a force, where it is found.
    fn at(&self, log: f64) -> Option<Point> {
        self.of(self.problem, log)
    }

    fn of(&self, problem: &Problem, log: f64) -> Option<Point> {
        if problem.deadline().is_spent() {
            return None;
        }
        let force = log.exp();
        let load =
            Load { vertical: Vertical::Force(force), rotational: Rotational::Eccentricity(self.e) };
        let unit = problem.bodies().unit(Scaling::force);
        let given = Load { vertical: Vertical::Force(force * unit), ..*problem.load() };
        let contact = problem.under(given).solve_as_given().ok()?;
        let [raise, _] = contact.solution().stiffness().displaced(&load, [1.0, 0.0]);
        let (slope, excess) = (force * raise, contact.state().settlement - self.settlement);
        (slope.is_finite() && excess.is_finite()).then_some(Point { log, excess, slope, contact })
    }

    /// From the smallest force up, until the settlement is crossed; else how near it came.
    fn search(&self) -> Search {
        let mut nearest = f64::INFINITY;
        let (mut is_lost, mut lost) = (false, 0);
        let mut before: Option<Point> = None;
        for power in -REACH..=REACH {
            // The smallest forces leave no digits of the heights.
            let log = self.unit().ln() + f64::from(power) * RATIO.ln();
            let Some(point) = self.of(self.way, log) else {
                is_lost |= before.take().is_some();
                lost += 1;
                // Where contacts were found and so many are lost after them the rest will be.
                if is_lost && lost == REACH / 2 {
                    break;
                }
                continue;
            };
            lost = 0;
            if point.excess.abs() < nearest.abs() {
                nearest = point.excess;
            }
            if let Some(before) = before {
                if point.is_beyond(&before) {
                    return self.between(before, point);
                }
                if before.falls() && !point.falls() {
                    match self.turning(before.log, &point) {
                        Search::Turns(excess) if excess.abs() < nearest.abs() => nearest = excess,
                        Search::Turns(_) => {}
                        Search::Lost => is_lost = true,
                        found @ Search::Found(_) => return found,
                    }
                }
            }
            before = Some(point);
        }
        if is_lost || nearest.is_infinite() { Search::Lost } else { Search::Turns(nearest) }
    }

    /// The depth over the compliance of the whole base.
    fn unit(&self) -> f64 {
        let problem = self.problem;
        let depth = |xi: f64| (self.settlement - problem.dimensionless_profile(xi)).abs();
        let deepest = self.places().map(depth).fold(f64::MIN_POSITIVE, f64::max);
        deepest / (1.0 + problem.bodies().theta0())
    }

    /// Places of the base.
    fn places(&self) -> impl Iterator<Item = f64> {
        let pieces = self.problem.bodies().pieces();
        pieces.into_iter().flat_map(|[left, right]| {
            (0..=SAMPLES).map(move |i| left + (right - left) * i as f64 / SAMPLES as f64)
        })
    }

    /// The crossing between two points, by Newton's steps that stay between.
    fn between(&self, one: Point, other: Point) -> Search {
        let is_above = one.excess > 0.0;
        // They are known to the tolerance of the way.
        let beside = 0.5 * (other.log - one.log);
        let mut ends = [one.log - beside, other.log + beside];
        let nearest = if other.excess.abs() < one.excess.abs() { other } else { one };
        let mut here = [nearest.log, nearest.excess, nearest.slope];
        let mut best: Option<Point> = None;
        for _ in 0..STEPS {
            let newton = here[0] - here[1] / here[2];
            let inside = newton > ends[0].min(ends[1]) && newton < ends[0].max(ends[1]);
            let log = if inside { newton } else { 0.5 * (ends[0] + ends[1]) };
            let Some(next) = self.at(log) else { break };
            ends[usize::from((next.excess > 0.0) != is_above)] = log;
            // What was found on the way is not exact enough to end with.
            let is_near = best.is_some() && (log - here[0]).abs() < f64::EPSILON.sqrt();
            here = [next.log, next.excess, next.slope];
            if best.as_ref().is_none_or(|best| next.excess.abs() <= best.excess.abs()) {
                best = Some(next);
            }
            // The next step has twice the digits.
            if is_near {
                break;
            }
        }
        best.map_or(Search::Lost, |best| Search::Found(Box::new(best)))
    }

    /// The settlement next to the one sought between a point from which it comes nearer and one behind which it goes away; or a crossing on the way.
    fn turning(&self, nearer: f64, away: &Point) -> Search {
        let found = self.turning_of(self.way, nearer, away);
        let known_to = on_the_way() * (self.settlement.abs() + away.excess.abs());
        match found {
            // So near that the way does not tell on which side.
            Search::Turns(excess) if excess.abs() <= known_to => {
                self.turning_of(self.problem, nearer, away)
            }
            found => found,
        }
    }

    /// The same for one of the two problems, by halving.
    fn turning_of(&self, problem: &Problem, mut nearer: f64, away: &Point) -> Search {
        let (mut beyond, mut nearest) = (away.log, away.excess);
        let tolerance = problem.solver().tolerance.unwrap_or(f64::EPSILON);
        for _ in 0..STEPS {
            let Some(middle) = self.of(problem, 0.5 * (nearer + beyond)) else {
                return Search::Lost;
            };
            if middle.is_beyond(away) {
                return match self.of(problem, nearer) {
                    Some(point) => self.between(point, middle),
                    None => Search::Lost,
                };
            }
            if middle.excess.abs() < nearest.abs() {
                nearest = middle.excess;
            }
            *(if middle.falls() { &mut nearer } else { &mut beyond }) = middle.log;
            // The settlement goes with the square of the distance from where it turns.
            if (nearer - beyond).abs() < tolerance.sqrt() {
                break;
            }
        }
        Search::Turns(nearest)
    }

    /// Whether the prescribed settlement leaves the base clear of the body.
    fn is_clear(&self) -> bool {
        let heights = self.places().map(|xi| (xi, self.problem.dimensionless_profile(xi)));
        self.problem.dimensionless_load().keeps_clear(heights.collect::<Vec<_>>().iter())
    }

    fn out_of_reach(&self, excess: f64) -> Error {
        let bodies = self.problem.bodies();
        if self.is_clear() {
            return Error::NoContact;
        }
        let unit = bodies.unit(Scaling::displacement);
        Error::SettlementOutOfReach {
            value: self.settlement * unit,
            eccentricity: self.e * bodies.half_width(),
            limit: (self.settlement + excess) * unit,
            bound: if excess > 0.0 { "less deep" } else { "deeper" },
        }
    }
}
