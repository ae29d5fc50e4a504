//! The zones on panels.
//!
//! The zones that come next are where `g = delta0 - alpha0 xi - f0 - theta0 K p0` is positive: as the pressure vanishes at a free edge, an edge that is off by `e` changes the rest by
//! `e^2` only, and this is Newton's method for all edges at once, in which zones part and join. Cells give the zones to begin with.
//!
//! The [search](crate::contact::search) by edges takes twice as long on these many zones, up to twelve times (40 problems, `benches/plausible/run.py`).

use std::sync::Arc;

use fredholm::multipole::PanelOperator;

use super::mesh::STRAIGHT;
use super::nodes::{Effort, OnPanels, PanelInverse, PanelNodes, cut};
use crate::Error;
use crate::contact::check::{BETWEEN, Check};
use crate::contact::rough::base::{Base, SAMPLES_A_POINT};
use crate::contact::rough::check::check;
use crate::contact::rough::newton::{self, Found};
use crate::contact::rough::nodes::Field;
use crate::contact::rough::refinement::refined;
use crate::contact::rough::solved::Solved;
use crate::contact::search::{ALLOWED, COARSELY_ALLOWED, CORRECTIONS, unknown};
use crate::contact::zones::Zone;
use crate::deadline::work;
use crate::line_search::{Point, positive, top};
use crate::rounding::OF_A_VALUE;

/// Most rounds on the way to the zones: an edge that is off by many lengths of the layer comes nearer by a half each, from a cell to the thinnest layers twenty times, and then by squares. Half and twice change none of 32 answers (survey).
const ROUNDS: usize = 28;
/// Panels on which the zones are found, those whose answer is compared, and those of the answer. Heights are resolved to a tenth of what zones are found to: with 1e-8 rows take 1.3 times as long,
/// with 1e-4 no less time. Responses begin with those on the panels before; with 1e-7 and 1e-10 on the last two rates without free edges lose their digits. At half or twice the ends that are good enough stated errors grow up to 2.6 times (survey).
const LADDER: [Effort; 5] = [
    Effort::new(4, 4.0, 1e-5, [1e-6, 1e-4, 1e-4]),
    Effort::new(6, 3.0, 1e-8, [1e-8, 1e-6, 1e-5]),
    Effort::new(8, 2.0, 1e-10, [1e-10, 1e-8, 1e-6]),
    Effort::new(10, 2.0, STRAIGHT, [1e-11, 1e-9, 1e-6]),
    Effort::new(13, 1.0, STRAIGHT, [1e-14, 1e-12, 1e-7]),
];
/// What is taken of it: all where a tolerance is given that the third may meet, whose error the second shows, or where there are too many nodes for these.
const STEEP: [usize; 3] = [0, 3, 4];
const ALL: [usize; LADDER.len()] = [0, 1, 2, 3, 4];

type OnZones = Solved<OnPanels>;
/// A solution nearby.
type Near<'n> = Option<&'n OnZones>;

/// A solution with what its responses take.
struct Agreeing<'b> {
    solved: OnZones,
    nodes: PanelNodes<'b>,
    inverse: PanelInverse,
}

/// Places of a piece of the base from end to end, with the heights there.
type Places = Vec<Point>;

/// A base with places that show every bend of its profile.
pub(in crate::contact::rough) struct ManyPanels<'b> {
    base: &'b Base,
    /// Where the profile bends.
    joints: Vec<f64>,
    pieces: Vec<Places>,
}

impl<'b> ManyPanels<'b> {
    pub(in crate::contact::rough) fn new(base: &'b Base) -> Self {
        let joints = joints(base);
        let pieces = base.pieces.iter().map(|piece| places(base, &joints, *piece)).collect();
        Self { base, joints, pieces }
    }

    /// The answer on the whole base.
    pub(in crate::contact::rough) fn whole(&mut self) -> Result<OnZones, Error> {
        Ok(self.solve(self.base.whole())?.0)
    }

    /// The answer where the base may lift off, and what is left of tension and penetration.
    pub(in crate::contact::rough) fn lifting(&mut self) -> Result<(OnZones, Check), Error> {
        let base = self.base;
        let intervals = match base.coarse() {
            Err(error) if base.layer.is_linear() => return Err(error),
            found => found.unwrap_or_default(),
        };
        // A layer that bends has no pressure where it would pull: where cells find nothing the whole base serves.
        let is_unknown = intervals.is_empty() && !base.layer.is_linear();
        let zones = intervals.iter().map(|ends| base.zone(*ends)).collect();
        self.solve(if is_unknown { base.whole() } else { zones })
    }

    /// The answer from zones that are nearly right. A gap that is about to close is so narrow, and what would pull there so little, that coarse panels do not tell: then the answer shows where to look.
    fn solve(&mut self, zones: Vec<Zone>) -> Result<(OnZones, Check), Error> {
        let (mut best, mut left) = self.answered(zones, None)?;
        for _ in 0..CORRECTIONS {
            if left.is_clean() || self.base.problem().deadline().is_past() {
                break;
            }
            self.add_places(&best, &left);
            let zones = self.next_zones(&best);
            match self.answered(zones, Some(&best)) {
                // What more places do not lower is rounding.
                Ok((solved, rest)) if rest.violation() <= 0.5 * left.violation() => {
                    (best, left) = (solved, rest);
                }
                _ => break,
            }
        }
        Ok((best, left))
    }

    /// The answer from zones that are nearly right, and what is left of tension and penetration.
    fn answered(&mut self, zones: Vec<Zone>, near: Near<'_>) -> Result<(OnZones, Check), Error> {
        let mut found = self.agreeing(zones, 0, near)?;
        for _ in 0..CORRECTIONS {
            let left = self.left(&found.solved, COARSELY_ALLOWED);
            if left.is_clean() || self.base.problem().deadline().is_past() {
                break;
            }
            self.add_places(&found.solved, &left);
            found = self.agreeing(self.next_zones(&found.solved), 0, Some(&found.solved))?;
        }
        let coarse = found.solved.answering(&found.nodes, &found.inverse, near)?;
        let fits = |solved: &OnZones, rung: usize| {
            cut(self.base, &self.joints, &solved.nodes.zones, LADDER[rung].fineness).is_ok()
        };
        let tolerance = self.base.problem().solver().tolerance;
        let may_be_steep = STEEP.iter().all(|rung| fits(&coarse, *rung));
        let is_fine = tolerance.is_none_or(|wanted| wanted <= LADDER[1].fineness.straight);
        let is_steep = may_be_steep && is_fine;
        let climbed = |coarse: OnZones, is_steep: bool| {
            let rungs = if is_steep { &STEEP[..] } else { &ALL };
            let next = |solved: &OnZones, level: usize| match rungs.get(level) {
                // Three tell an error.
                Some(rung) if level < STEEP.len() || fits(solved, *rung) => {
                    self.settled(solved.nodes.zones.clone(), *rung, Some(solved)).map(Some)
                }
                _ => Ok(None),
            };
            refined(self.base, coarse, is_steep, next)
        };
        let first = tolerance.and(may_be_steep.then(|| coarse.clone()));
        let mut solved = climbed(coarse, is_steep)?;
        // What one way up does not tell the other may.
        if let Some(coarse) = first
            && solved.known_to() > tolerance.unwrap_or(f64::INFINITY)
            && !self.base.problem().deadline().is_past()
            && let Ok(other) = climbed(coarse, !is_steep)
            && other.known_to() < solved.known_to()
        {
            solved = other;
        }
        let left = self.left(&solved, ALLOWED);
        Ok((solved, left))
    }

    /// Nothing is left where the whole base is kept in contact, or where there will be no answer.
    fn left(&self, solved: &OnZones, allowed: f64) -> Check {
        let is_moot = self.base.is_bilateral || self.base.problem().deadline().is_spent();
        if is_moot { Check::none() } else { check(self.base, solved, allowed) }
    }

    /// Looks at places where something was left, too.
    fn add_places(&mut self, solved: &OnZones, left: &Check) {
        // What pulls between two samples may do so far from their middle.
        let base = self.base;
        let tension = |xi: f64| -solved.layer_at(xi, base.height(xi));
        let pulling = left.pulling.iter().map(|[from, to]| top(&tension, *from, *to).0);
        for xi in pulling.chain(left.penetrating.iter().map(|[_, deepest, _]| *deepest)) {
            for piece in &mut self.pieces {
                let after = piece.partition_point(|(at, _)| *at < xi);
                if 0 < after && after < piece.len() {
                    piece.insert(after, (xi, self.base.height(xi)));
                }
            }
        }
    }

    /// The solution on zones that agree with their own pressure, with responses.
    fn settled(&self, zones: Vec<Zone>, rung: usize, near: Near<'_>) -> Result<OnZones, Error> {
        let found = self.agreeing(zones, rung, near)?;
        found.solved.answering(&found.nodes, &found.inverse, near)
    }

    /// The solution on zones that agree with their own pressure, and what its responses take.
    fn agreeing(
        &self,
        mut zones: Vec<Zone>,
        rung: usize,
        near: Near<'_>,
    ) -> Result<Agreeing<'b>, Error> {
        let (base, effort) = (self.base, LADDER[rung]);
        let (mut latest, mut known): (Option<OnZones>, Option<PanelOperator>) = (None, None);
        for _ in 0..ROUNDS {
            // Where no work is left there will be no answer.
            if zones.is_empty() || base.problem().deadline().is_spent() {
                break;
            }
            let nodes = PanelNodes::new(base, &self.joints, &zones, effort, known.as_ref())?;
            let Found { step, inverse } = newton::solve(&nodes, latest.as_ref().or(near))?;
            let mut solved = Solved::new(&nodes, step);
            if !base.is_bilateral {
                let next = self.next_zones(&solved);
                let is_same = next.len() == zones.len();
                zones = next;
                let is_over = !zones.is_empty() && base.problem().deadline().is_past();
                let at_ends = solved.layer_at_ends(|xi| base.height(xi));
                let is_good = is_same && at_ends <= effort.good * solved.deepest();
                if !is_over && !is_good {
                    (latest, known) = (Some(solved), Some(nodes.operator));
                    continue;
                }
                // The pressure outside of the panels goes on as the negative gap: these edges are its own.
                Arc::make_mut(&mut solved.nodes).zones = zones;
            }
            if base.problem().deadline().is_spent() {
                break;
            }
            return Ok(Agreeing { solved, nodes, inverse });
        }
        Err(unknown())
    }

    /// Where the layer and the gap tell that the zones are; what is rounding is zero.
    fn next_zones(&self, solved: &OnZones) -> Vec<Zone> {
        let base = self.base;
        let size = solved.deepest() + solved.state.settlement.abs() + solved.state.tilt.abs();
        let layers = |points: &[Point]| {
            base.problem().deadline().spend(work::NODE * points.len() as f64);
            solved.layers_at(points)
        };
        let given = |at: &[f64]| layers(&base.points(at.to_vec()));
        // At an end the polynomials are least exact, and beside it the same function goes on.
        let is_inside = |xi: &f64| solved.nodes.end_at(*xi).is_none();
        // Of zones and of the gaps between them the ends and the middles.
        let ends: Vec<f64> = solved.nodes.zones.iter().flat_map(|zone| zone.ends).collect();
        let middles = ends.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
        let marks: Vec<f64> = ends.iter().copied().chain(middles).collect();
        let on_piece = |piece: &Places| {
            let [first, last] = [piece[0].0, piece[piece.len() - 1].0];
            let own = marks.iter().copied().filter(|xi| (first..=last).contains(xi));
            let mut points = piece.clone();
            points.extend(base.points(own.collect()));
            crate::order::sort_by_number(&mut points, |one| one.0);
            points.dedup_by(|one, two| one.0 == two.0);
            let at: Vec<f64> = points.iter().map(|(xi, _)| *xi).collect();
            let known = solved.field.interpolated(&solved.given, &at).into_iter().zip(&at);
            let known: Vec<_> = known.map(|(known, xi)| known.filter(|_| is_inside(xi))).collect();
            let open = points.iter().zip(&known).filter(|(_, known)| known.is_none());
            let mut found = layers(&open.map(|(at, _)| *at).collect::<Places>()).into_iter();
            for (point, known) in points.iter_mut().zip(known) {
                point.1 = known.or_else(|| found.next()).unwrap_or(point.1);
            }
            positive(&given, &points, OF_A_VALUE * size)
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
    let mut joints = problem.profile().joints(problem.bodies().half_width());
    if base.ground.is_closed() {
        // A wave is seen from elsewhere than it was measured, and bends at its seam as well.
        joints.push(1.0);
        joints = joints.iter().flat_map(|at| [at - 2.0, *at, at + 2.0]).collect();
    }
    joints.sort_by(f64::total_cmp);
    joints
}

/// The samples of a piece of the base, more between joints that have few.
fn places(base: &Base, joints: &[f64], [from, to]: [f64; 2]) -> Places {
    let fewest = if base.is_measured() { SAMPLES_A_POINT } else { BETWEEN };
    let inside = joints.iter().copied().filter(|at| *at > from && *at < to);
    let cuts: Vec<f64> = [from].into_iter().chain(inside).chain([to]).collect();
    let mut places = Places::new();
    for pair in cuts.windows(2) {
        let after = |end: f64| base.samples.partition_point(|(at, _)| *at <= end);
        let known = &base.samples[after(pair[0])..after(pair[1])];
        places.push((pair[0], base.sampled_height(pair[0])));
        if known.len() > fewest {
            places.extend(known.iter().filter(|(at, _)| *at < pair[1]));
        } else {
            let at = |i: usize| pair[0] + (pair[1] - pair[0]) * i as f64 / fewest as f64;
            places.extend(base.points((1..fewest).map(at).collect()));
        }
    }
    places.push((to, base.sampled_height(to)));
    places
}
