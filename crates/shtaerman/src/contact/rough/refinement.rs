//! The answer on growing resolutions, with its error.

use std::f64::consts::PI;

use super::base::Base;
use super::nodes::{Field, PLACES, between_nodes};
use super::solved::{BESIDE, Solved, Stated};
use crate::Error;
use crate::contact::accuracy::{Accuracy, ROUNDING, SAFETY, STAGNANT, Sizes};
use crate::contact::parts::Smoothness;
use crate::contact::resolutions::{Change, Trust, UNKNOWN};
use crate::contact::stiffness::Stiffness;
use crate::contact::zones::{EndKind, Zone};
use crate::line_search::Point;
use crate::solver::AIM;

/// The answer from one that is coarse: `next` gives the resolution that follows on another, and none where there are no more; whether the first of two differences is that from one far coarser.
///
/// # Errors
/// Those of the resolutions.
pub(super) fn refined<F: Field>(
    base: &Base,
    coarse: Solved<F>,
    is_far: bool,
    mut next: impl FnMut(&Solved<F>, usize) -> Result<Option<Solved<F>>, Error>,
) -> Result<Solved<F>, Error> {
    let tolerance = base.problem().solver().tolerance.unwrap_or(AIM);
    let mut levels = vec![coarse];
    let (mut before, mut best): (Option<Change>, usize) = (None, 0);
    while let Some(mut finer) = next(&levels[levels.len() - 1], levels.len())? {
        let change = difference(base, &finer, &levels[levels.len() - 1]);
        let is_over = base.problem().deadline().is_past();
        let mut ends = is_over;
        if let Some(before) = before {
            finer.stated = stated(base, &finer, is_far, [&before, &change]);
            // What is looked for only of an answer that may be the last.
            if is_over || finer.known_to() <= tolerance {
                finer.count_missed_waves(base);
            }
            ends |= finer.known_to() <= tolerance;
            ends |= F::RATIO.is_some() && is_settled(&finer, &before, &change);
            // A layer that bends and pulls is no answer, however well it is known.
            let known_to = SAFETY * finer.stated.accuracy.pressure;
            let bends = base.is_bilateral && !base.layer.is_linear();
            ends |= bends && finer.pulls_most(known_to).is_some();
        }
        let known = |solved: &Solved<F>| solved.stated.accuracy.pressure;
        if known(&finer) <= known(&levels[best]) {
            best = levels.len();
        }
        levels.push(finer);
        before = Some(change);
        if ends {
            break;
        }
    }
    levels.truncate(best + 1);
    let mut found = levels.remove(best);
    found.count_missed_waves(base);
    let told = if is_far { 1 } else { 2 };
    found.coarser = levels.split_off(best.saturating_sub(told));
    Ok(found)
}

/// Whether more nodes change no more than rounding; the integrals, too: where the body gives nothing, the pressure of a layer that bends is exact on any nodes, its force is not.
fn is_settled<F: Field>(solved: &Solved<F>, before: &Change, change: &Change) -> bool {
    let sizes = solved.state.sizes(solved.largest());
    let small = |change: f64, size: f64| change <= ROUNDING * size;
    let is_resolved = solved.layer.is_linear()
        || small(change.force.max(change.moment), sizes.force)
            && small(change.settlement.max(change.tilt), sizes.displacement);
    let stagnates =
        change.pressure > 0.5 * before.pressure && change.pressure <= STAGNANT * solved.largest();
    change.pressure <= 2.0 * pressure_rounding(solved) && is_resolved || stagnates
}

/// Rounding of the pressure.
fn pressure_rounding<F: Field>(solved: &Solved<F>) -> f64 {
    solved.layer.slope(solved.deepest()) * solved.rounding()
}

/// The differences between two resolutions, of the pressure at places between the nodes.
fn difference<F: Field>(base: &Base, fine: &Solved<F>, coarse: &Solved<F>) -> Change {
    let between = F::between();
    let is_covered = |xi: f64| coarse.nodes.zone(xi).is_some();
    // The profile is the same to both.
    let needs_height = |xi: f64| !is_covered(xi) || !fine.layer.is_linear();
    let mut places: Vec<Point> = fine.nodes.on_panels(&between).map(|xi| (xi, 0.0)).collect();
    let without =
        places.iter_mut().filter(|(xi, _)| needs_height(*xi)).map(|(xi, height)| (*xi, height));
    let (asked, heights): (Vec<f64>, Vec<&mut f64>) = without.unzip();
    for (height, known) in heights.into_iter().zip(base.surface.heights(&asked)) {
        *height = known;
    }
    let covered: Vec<Point> = places.iter().copied().filter(|(xi, _)| is_covered(*xi)).collect();
    let mut others = coarse.layers_at(&covered).into_iter();
    let differences = places.iter().zip(fine.layers_at(&places)).map(|((xi, _), layer)| {
        let other = if is_covered(*xi) { others.next().unwrap_or(f64::NAN) } else { 0.0 };
        (fine.layer.pressure(layer) - coarse.layer.pressure(other)).abs()
    });
    let pressure = differences.fold(0.0, f64::max);
    Change::between([fine, coarse].map(|solved| (&solved.state, &solved.nodes.zones[..])), pressure)
}

/// The error of the finest of three resolutions, and that of its edges.
fn stated<F: Field>(base: &Base, fine: &Solved<F>, is_far: bool, changes: [&Change; 2]) -> Stated {
    let (highest, rounding) = (fine.largest(), pressure_rounding(fine));
    let sizes = fine.state.sizes(highest);
    let pressures = changes.map(|change| change.pressure);
    let (trust, compared) = match F::RATIO {
        Some(ratio) => (Trust::new(base.smoothness, ratio, pressures, rounding, highest), sizes),
        // What is added up in the displacements.
        None => (Trust::plain(is_far), Sizes { displacement: fine.size(), ..sizes }),
    };
    let length = fine.nodes.zones.iter().map(Zone::length).sum();
    let (accuracy, edge) = trust.accuracy(base.load, changes, &compared, length);
    // Zones are good enough while the layer gives next to nothing at their free ends.
    let missed =
        fine.missed_at_corners(base) + fine.layer.slope(fine.deepest()) * fine.at_ends.layer;
    let pressure = accuracy.pressure.max(rounding) + missed;
    let accuracy = Accuracy { pressure, ..accuracy };
    let is_unknown = F::RATIO.is_none() && base.smoothness == Smoothness::Unknown;
    let accuracy = if is_unknown { accuracy.of_the_unknown(UNKNOWN, &sizes) } else { accuracy };
    let off = edge / SAFETY;
    let edge = edge.max(fine.rounding() / fine.gentlest(base)) + SAFETY * fine.at_ends.off;
    let stated = Stated { accuracy, edge, off };
    // Two resolutions may agree because neither was solved any further.
    let missed = fine.unsolved * fine.deepest() + fine.missed_at_tips(base);
    fine.raised(stated, missed, &fine.stiffness())
}

/// What polynomials through so many points miss of a power of the distance from an end, some, as a share of it at the other end.
pub(super) fn missed_of_power(points: usize, power: f64) -> f64 {
    (points as f64).powf(-2.0 * power)
}

impl<F: Field> Solved<F> {
    /// What is stated, relative to the sizes of all.
    pub(super) fn known_to(&self) -> f64 {
        self.stated.accuracy.relative(&self.state.sizes(self.largest()))
    }

    /// What is stated with what a kernel that is not known to all digits leaves in a displacement.
    pub(super) fn stated_with_kernel(&self, base: &Base, stiffness: &Stiffness) -> Stated {
        let missed = base.ground.kernel_error() * self.strength * self.state.force.abs();
        self.raised(self.stated, missed, stiffness)
    }

    /// What is stated with what is missed in a displacement, and that in the pressure and in the ends.
    fn raised(&self, stated: Stated, missed: f64, stiffness: &Stiffness) -> Stated {
        if missed == 0.0 {
            return stated;
        }
        let Stiffness { force_settlement, moment_tilt, .. } = *stiffness;
        let raised = stated.accuracy.with_profile_error(missed, [force_settlement, moment_tilt]);
        let pressure = stated.accuracy.pressure + 2.0 * missed * self.layer.slope(self.deepest());
        let longest = self.nodes.zones.iter().map(Zone::length).fold(0.0, f64::max);
        let edge = stated.edge + missed * longest / self.deepest();
        Stated { accuracy: Accuracy { pressure, ..raised }, edge, ..stated }
    }

    /// The least slope of the layer beside a free end; infinite where there is none.
    fn gentlest(&self, base: &Base) -> f64 {
        let ends = self.nodes.zones.iter().flat_map(|zone| {
            zone.free_ends().map(|(side, end)| {
                let step = BESIDE * zone.length();
                let at = if side == 0 { end + step } else { end - step };
                self.layer_at(at, base.height(at)).abs() / step
            })
        });
        ends.fold(f64::INFINITY, f64::min)
    }

    /// States, too, what nodes miss of the pressure between them: small fast waves of the profile look alike on several numbers of nodes, of which no difference then tells.
    ///
    /// The pressure by the equation has all waves of the profile, but the potential of what stands for it on the nodes. Where that misses `m`, `(1 + theta K) e = -theta K m` and a line that
    /// carries as much, so that `e` is no larger in the mean square than `m`, and forces are off by `m` on the zones.
    fn count_missed_waves(&mut self, base: &Base) {
        let Stated { accuracy, edge, off } = self.stated;
        if F::RATIO.is_none() || accuracy.pressure <= AIM * self.largest() {
            return;
        }
        let inside: Vec<f64> = between_nodes(PLACES).filter(|y| y.abs() < 1.0).collect();
        let places: Vec<f64> = self.nodes.on_panels(&inside).collect();
        let Some(told) = self.field.pressures(&places) else { return };
        let layers = self.layers_at(&base.points(places)).into_iter().zip(told);
        let missed = layers.map(|(layer, told)| (self.layer.pressure(layer) - told).powi(2));
        // The places lie alike in the angle; a ring is as long as its radius.
        let around = |xi: f64| if base.ground.is_disk() { xi } else { 1.0 };
        let weights = self.nodes.panels.iter().flat_map(|[left, right]| {
            let (middle, half) = (0.5 * (left + right), 0.5 * (right - left));
            inside.iter().map(move |y| half * (1.0 - y * y).sqrt() * around(middle + half * y))
        });
        let (square, whole, most) =
            missed.zip(weights).fold((0.0, 0.0, 0.0f64), |(square, whole, most), (own, w)| {
                (square + w * own, whole + w, most.max(own))
            });
        let (missed, most) = (f64::sqrt(square / whole), most.sqrt());
        let rounding = pressure_rounding(self) + self.missed_at_corners(base);
        let carried = missed * base.ground.area() * whole * PI / inside.len() as f64;
        let Stiffness { force_settlement, moment_tilt, .. } = self.stiffness();
        let by = [carried / force_settlement, carried / moment_tilt, carried, carried];
        // Where ends are known, and nothing gathers at them: no more is off than nodes miss, however far off fewer nodes are.
        let is_plain = !base.ground.is_disk() && base.ground.exponent() == 0.0;
        let is_whole = base.is_bilateral && is_plain && self.layer.is_linear();
        if is_whole && SAFETY * most < accuracy.pressure {
            let pressure = SAFETY * most + rounding;
            let known = Accuracy { pressure, ..accuracy.open(by, f64::min) };
            let sizes = self.state.sizes(self.largest());
            self.stated = Stated { accuracy: known.at_least(ROUNDING, &sizes), edge, off };
        } else if missed > rounding {
            let pressure = accuracy.pressure.max(2.0 * missed);
            let moved = missed / self.layer.slope(self.deepest()) / self.gentlest(base);
            let accuracy = Accuracy { pressure, ..accuracy.open(by, f64::max) };
            self.stated = Stated { accuracy, edge: edge.max(moved), off: off.max(moved) };
        }
    }

    /// What polynomials miss of the profile on the panels at its bends, in the displacement there: at sharp tips these are as short as places are rounded at all finenesses, so that no difference tells.
    fn missed_at_tips(&self, base: &Base) -> f64 {
        let Some((kernel, half)) = base.ground.panel_kernel().filter(|_| F::RATIO.is_none()) else {
            return 0.0;
        };
        let (panels, order) = (&self.nodes.panels, self.nodes.a_panel());
        let missed = |at: &f64| -> f64 {
            let Some(zone) = self.nodes.zone(*at) else { return 0.0 };
            let own = &panels[self.nodes.panels_of(zone)];
            let after = own.partition_point(|[left, right]| left.midpoint(*right) < *at);
            let slope = self.layer.slope(self.layer_at(*at, base.height(*at)));
            let steepness = self.strength * slope / base.ground.strength();
            let beside = [(after.checked_sub(1), -1.0), (Some(after), 1.0)].into_iter();
            let beside = beside.filter_map(|(panel, side)| Some((own.get(panel?)?, side)));
            let of_panel = |([left, right], side): (&[f64; 2], f64)| {
                let length = right - left;
                let beyond = at + side * length;
                let missed = base.shown([at.min(beyond), at.max(beyond)], order).missed;
                steepness * length * kernel.value(length / half) * missed
            };
            beside.map(of_panel).fold(0.0, f64::max)
        };
        base.breaks.iter().map(missed).fold(0.0, f64::max)
    }

    /// What polynomials miss on the panels at corners. There the pressure goes on as a power of the distance of its own size; at all finenesses they may be as short as numbers allow, so that no
    /// difference tells. The pressure changes by `V` on such a panel because the potential of a pressure `p` does by `V`: that of what is missed, `s V`, changes by `s V^2/p` at most.
    fn missed_at_corners(&self, base: &Base) -> f64 {
        if F::RATIO.is_some() {
            return 0.0;
        }
        let share = missed_of_power(self.nodes.a_panel(), 1.0 - self.ground.exponent());
        let missed = |zone: &Zone, side: usize| -> Option<f64> {
            let panels = &self.nodes.panels[self.nodes.panels_of(zone)];
            let panel = if side == 0 { panels.first()? } else { panels.last()? };
            let (end, inner) = (panel[side], panel[1 - side]);
            let of_zone = |xi: f64| base.height(zone.inside(xi));
            let height = |xi: f64| if self.layer.is_linear() { 0.0 } else { of_zone(xi) };
            let [outer, beside] = [end, inner].map(|xi| self.pressure_at(xi, height(xi)));
            let change = (outer - beside).abs();
            let pressure = self.pressure_at(inner, base.height(inner)).abs();
            Some(if change == 0.0 { 0.0 } else { share * change * change / pressure.max(change) })
        };
        let walls = self.nodes.zones.iter().flat_map(|zone| {
            let is_wall = |side: &usize| zone.kinds[*side] == EndKind::Wall;
            (0..2).filter(is_wall).filter_map(move |side| missed(zone, side))
        });
        walls.fold(0.0, f64::max)
    }
}
