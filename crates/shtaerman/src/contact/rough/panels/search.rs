//! The zones on panels.
//!
//! The zones that come next are where `g = delta0 - alpha0 xi - f0 - theta0 K p0` is positive: as the pressure vanishes at a free edge, an edge that is off by `e` changes the rest by
//! `e^2` only, and this is Newton's method for all edges at once, in which zones part and join. Cells give the zones to begin with.

use std::sync::Arc;

use super::mesh::{Fineness, LONGEST, STRAIGHT};
use super::nodes::{Effort, OnPanels, PanelNodes};
use super::positive::positive;
use crate::Error;
use crate::contact::accuracy::OF_A_VALUE;
use crate::contact::check::Check;
use crate::contact::promise::ROUGHEST;
use crate::contact::rough::answer::RoughContact;
use crate::contact::rough::base::{Base, SAMPLES_A_PART, SAMPLES_A_POINT};
use crate::contact::rough::check::check;
use crate::contact::rough::coarse::Coarse;
use crate::contact::rough::newton::{self, Found};
use crate::contact::rough::nodes::Field;
use crate::contact::rough::refinement::refined;
use crate::contact::rough::solved::Solved;
use crate::contact::search::{ALLOWED, COARSELY_ALLOWED};
use crate::contact::solution::Solution;
use crate::contact::zones::Zone;

/// Most rounds on the way to the zones: an edge that is off by many lengths of the layer comes nearer by a half each, from a cell to the thinnest layers twenty times, and then by squares. Half and twice change none of 32 answers (survey).
const ROUNDS: usize = 28;
/// Panels on which the zones are found, those whose answer is compared, and those of the answer: with the relative residuals. Heights are resolved to a tenth of what zones are [found](GOOD) to: with
/// 1e-8 rows take 1.3 times as long, with 1e-4 no less time.
const LADDER: [Effort; 3] = [
    Effort {
        fineness: Fineness { order: 4, ends: 4.0, longest: LONGEST, straight: 1e-5 },
        residual: 1e-6,
    },
    Effort {
        fineness: Fineness { order: 10, ends: 2.0, longest: LONGEST, straight: STRAIGHT },
        residual: 1e-11,
    },
    Effort {
        fineness: Fineness { order: 13, ends: 1.0, longest: LONGEST, straight: STRAIGHT },
        residual: 1e-14,
    },
];
/// Pressure at free edges over the largest, at which the zones are good enough: its square is what the pressure elsewhere is off. At half or twice stated errors grow up to 2.6 times (survey).
const GOOD: [f64; 3] = [1e-4, 1e-6, 1e-7];
/// Most zones.
const MOST_ZONES: usize = 2000;
/// Most corrections of zones between whose samples the check finds tension or penetration.
const CORRECTIONS: usize = 4;

type OnZones = Solved<OnPanels>;

/// The answer on panels; none where they do not serve: where the zones are not found or too many.
pub(in crate::contact::rough) fn solve(
    base: &Base,
) -> Result<Option<RoughContact<OnPanels>>, Error> {
    if !base.has_panels() {
        return Ok(None);
    }
    if base.layer.is_linear() {
        return solve_from(base, base.coarse()?.zones(base), None);
    }
    // A layer that bends has no pressure where it would pull: where cells find nothing the whole base serves.
    let coarse = base.coarse().ok().filter(|found| !found.is_empty());
    let zones = coarse.as_ref().map_or_else(|| base.whole(), |found| found.zones(base));
    solve_from(base, zones, coarse.as_deref())
}

/// The answer on the whole base; none where panels do not serve.
pub(in crate::contact::rough) fn solve_whole(
    base: &Base,
) -> Result<Option<RoughContact<OnPanels>>, Error> {
    if base.has_panels() { solve_from(base, base.whole(), None) } else { Ok(None) }
}

/// The answer from zones that are nearly right.
fn solve_from(
    base: &Base,
    zones: Vec<Zone>,
    coarse: Option<&Coarse>,
) -> Result<Option<RoughContact<OnPanels>>, Error> {
    let mut search = Search::new(base);
    let Some(mut found) = search.settled(zones, 0, None, coarse)? else { return Ok(None) };
    for _ in 0..CORRECTIONS {
        let left = search.checked(&found, COARSELY_ALLOWED);
        if left.is_clean() || base.problem().deadline().is_past() {
            break;
        }
        search.add_places(&left);
        let zones = found.nodes.zones.clone();
        let Some(next) = search.settled(zones, 0, Some(&found), None)? else { return Ok(None) };
        found = next;
    }
    let next = |solved: &OnZones, level: usize| match LADDER.get(level) {
        Some(_) => search.settled(solved.nodes.zones.clone(), level, Some(solved), None),
        None => Ok(None),
    };
    let solved = refined(base, found, next)?;
    let left = search.checked(&solved, ALLOWED);
    let contact = RoughContact::new(base, solved, &left)?;
    let serves = contact.relative_error() <= ROUGHEST || base.problem().deadline().is_past();
    Ok(serves.then_some(contact))
}

/// Places of a piece of the base from end to end, with the heights there.
type Places = Vec<(f64, f64)>;

/// A base with places that show every bend of its profile.
struct Search<'b> {
    base: &'b Base,
    /// Where the profile bends.
    joints: Vec<f64>,
    pieces: Vec<Places>,
}

impl<'b> Search<'b> {
    fn new(base: &'b Base) -> Self {
        let joints = joints(base);
        let pieces = base.pieces.iter().map(|piece| places(base, &joints, *piece)).collect();
        Self { base, joints, pieces }
    }

    /// Nothing is left where the whole base is kept in contact.
    fn checked(&self, solved: &OnZones, allowed: f64) -> Check {
        if self.base.is_bilateral { Check::none() } else { check(self.base, solved, allowed) }
    }

    /// Looks at places where something was left, too.
    fn add_places(&mut self, left: &Check) {
        let pulling = left.pulling.iter().map(|[from, to]| 0.5 * (from + to));
        let places = pulling.chain(left.penetrating.iter().map(|[_, deepest, _]| *deepest));
        for xi in places {
            let holds = |piece: &&mut Places| {
                piece.first().is_some_and(|(first, _)| *first < xi)
                    && piece.last().is_some_and(|(last, _)| xi < *last)
            };
            if let Some(piece) = self.pieces.iter_mut().find(holds) {
                let after = piece.partition_point(|(at, _)| *at < xi);
                piece.insert(after, (xi, self.base.height(xi)));
            }
        }
    }

    /// The solution on zones that agree with their own pressure, with responses but on the coarsest panels.
    fn settled(
        &self,
        mut zones: Vec<Zone>,
        level: usize,
        near: Option<&OnZones>,
        coarse: Option<&Coarse>,
    ) -> Result<Option<OnZones>, Error> {
        let (base, effort) = (self.base, LADDER[level]);
        let mut latest: Option<OnZones> = None;
        for _ in 0..ROUNDS {
            if zones.is_empty() || zones.len() > MOST_ZONES {
                return Ok(None);
            }
            let Some(nodes) = PanelNodes::new(base, &self.joints, &zones, effort)? else {
                return Ok(None);
            };
            let Found { step, inverse } = newton::solve(&nodes, latest.as_ref().or(near), coarse)?;
            let mut solved = Solved::new(&nodes, step);
            let mut is_good = base.is_bilateral;
            if !is_good {
                let next = self.next_zones(&solved);
                let is_same = next.len() == zones.len();
                zones = next;
                let at_ends = solved.at_ends(|xi| base.height(xi));
                is_good = is_same && at_ends <= GOOD[level] * solved.deepest();
            }
            let is_over = !zones.is_empty() && base.problem().deadline().is_past();
            if is_good || is_over {
                // The pressure outside of the panels goes on as the negative gap: these edges are its own.
                if !base.is_bilateral {
                    Arc::make_mut(&mut solved.nodes).zones = zones;
                }
                if level == 0 {
                    return Ok(Some(solved));
                }
                return solved.answering(&nodes, &inverse, near).map(Some);
            }
            latest = Some(solved);
        }
        Ok(None)
    }

    /// Where the layer and the gap tell that the zones are; what is rounding is zero.
    fn next_zones(&self, solved: &OnZones) -> Vec<Zone> {
        let base = self.base;
        let none = OF_A_VALUE
            * (solved.deepest() + solved.state.settlement.abs() + solved.state.tilt.abs());
        let given = |xi: f64| solved.layer_at(xi, base.height(xi));
        let value = |(xi, height): (f64, f64)| {
            // At an end the polynomials are least exact, and beside it the same function goes on.
            let at_end = solved.nodes.end_at(xi).is_some();
            let inside = if at_end { None } else { solved.field.interpolated(&solved.given, xi) };
            (xi, inside.unwrap_or_else(|| solved.layer_at(xi, height)))
        };
        let on_piece = |piece: &Places| {
            let [first, last] = [piece[0].0, piece[piece.len() - 1].0];
            let inside = |zone: &&Zone| zone.left() >= first && zone.right() <= last;
            let own = solved.nodes.zones.iter().filter(inside);
            let own = own.flat_map(|zone| [zone.left(), zone.middle(), zone.right()]);
            let mut points: Vec<(f64, f64)> = piece.iter().map(|place| value(*place)).collect();
            points.extend(own.map(|xi| value((xi, base.height(xi)))));
            points.sort_by(|one, two| one.0.total_cmp(&two.0));
            points.dedup_by(|one, two| one.0 == two.0);
            let (at, values): (Vec<f64>, Vec<f64>) = points.into_iter().unzip();
            positive(&given, &at, &values, none)
        };
        self.pieces.iter().flat_map(on_piece).map(|ends| base.zone(ends)).collect()
    }
}

/// Where the profile bends.
fn joints(base: &Base) -> Vec<f64> {
    if !base.is_measured() {
        return base.breaks.clone();
    }
    let problem = base.problem();
    let mut joints = problem.profile().joints(problem.frame().half_width());
    if base.ground.is_closed() {
        // A wave is seen from elsewhere than it was measured, and bends at its seam as well.
        joints.push(1.0);
        let images = |at: &f64| [at - 2.0, *at, at + 2.0];
        joints = joints.iter().flat_map(images).collect();
    }
    joints.sort_by(f64::total_cmp);
    joints
}

/// The samples of a piece of the base, more between joints that have few.
fn places(base: &Base, joints: &[f64], [from, to]: [f64; 2]) -> Places {
    let fewest = if base.is_measured() { SAMPLES_A_POINT } else { SAMPLES_A_PART };
    let inside = joints.iter().copied().filter(|at| *at > from && *at < to);
    let cuts: Vec<f64> = [from].into_iter().chain(inside).chain([to]).collect();
    let mut places = Places::new();
    for pair in cuts.windows(2) {
        let [first, last] =
            [pair[0], pair[1]].map(|end| base.samples.partition_point(|(at, _)| *at <= end));
        let known = &base.samples[first..last];
        places.push((pair[0], base.sampled_height(pair[0])));
        if known.len() > fewest {
            places.extend(known.iter().filter(|(at, _)| *at < pair[1]));
            continue;
        }
        let at = |i: usize| pair[0] + (pair[1] - pair[0]) * i as f64 / fewest as f64;
        places.extend((1..fewest).map(|i| (at(i), base.height(at(i)))));
    }
    places.push((to, base.sampled_height(to)));
    places
}
