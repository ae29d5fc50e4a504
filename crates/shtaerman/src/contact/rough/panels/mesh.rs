//! Panels of the zones: cut where the profile bends, and ever shorter towards the ends of the zones and towards those bends.
//!
//! Lengths are those for the logarithm: on graded ground `ln d` is a power `d^-mu`, and the panels have the lengths that make as much of it.

use fredholm::basis::Shown;

use crate::contact::accuracy::ROUNDING;
use crate::contact::rough::base::Base;
use crate::contact::rough::refinement::missed_of_power;
use crate::contact::zones::{EndKind, Zone};
use crate::intervals::SLIVER;

/// Length of a panel over its distance from a free end of its zone, and from a corner or a bend: with 0.6 at free ends as well 195 zones take a quarter more time, with 0.7 everywhere answers on graded
/// ground state five times the error. At half or twice stated errors grow up to 97 times and time grows by 108 % (survey).
const FREE_GROWTH: f64 = 0.8;
const GROWTH: f64 = 0.6;
/// Nearer to such a place than a length of the layer, and beside measured points anywhere, the pressure leaves its limit by a power of the distance, and polynomials may miss as much more of that: the share
/// of this power that panels make use of. With 1 the stated error of a measured base doubles; with 0.5 it takes a quarter more time.
const EASED: f64 = 0.75;
/// The longest that they get by this, over their distance: there few are left to be saved. Twice changes a measured base by rounding.
const STEEPEST: f64 = 4.0;
/// Longest panels of the base, from the first to be tried. At half or twice stated errors grow up to 5 times (survey).
pub(super) const LONGEST: f64 = 1.0 / 32.0;
/// The panel at a measured point, where the third derivative jumps and the pressure goes on as `d^4 ln d`, in lengths `1/theta0` of the layer. At half or twice stated errors grow up to 18 times and time grows by 38 % (survey).
const POINT: f64 = 0.1;
/// The panel at a free end, where it goes on as `d^2 ln d`: the square of its length over that of the zone, in lengths of the layer. In zones longer than
/// the longest panels the slope of the pressure at the end has nothing to do with their length. At half or twice 7 of 16 answers change, within what they state (survey).
const FREE: f64 = 1e-6;
/// The panel at a kink, where it goes on as `d^2 ln d`, in lengths of the layer (survey).
const KINK: f64 = 1e-4;
/// The same where a layer bends and the pressure begins as `d^(1/kappa)`: the share of its zone with what it adds to the potential. At half or twice 2 of 16 answers change, within what they state (survey).
const BENT: f64 = 1e-11;
/// A place between a half and 1 is rounded by so much at most (rounding).
const OF_A_PLACE: f64 = 0.25 * f64::EPSILON;
/// Rounds that find the length of a panel at a corner: each leaves less than half of what was amiss (theory).
const SETTLING: usize = 10;
/// Most halvings of a panel on which the profile is no polynomial, and the deviation relative to its size that is rounding. At half or twice stated errors grow up to 3 times (survey).
const HALVINGS: u32 = 12;
pub(super) const STRAIGHT: f64 = 1e-14;

/// How fine the panels are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fineness {
    /// Nodes of a panel.
    pub(super) order: usize,
    /// Factor of the lengths of the panels at the ends of zones and at kinks.
    pub(super) ends: f64,
    /// Longest panels of the base.
    pub(super) longest: f64,
    /// Deviation of the profile from a polynomial on each panel, relative to its size, that is none.
    pub(super) straight: f64,
}

/// A place towards which panels get shorter.
#[derive(Debug, Clone, Copy)]
struct Anchor {
    at: f64,
    /// Whether the panels lie on its right.
    is_left: bool,
    /// The panel at the place.
    shortest: f64,
    /// Length of a panel over its distance from the place, from the distance `reach` on.
    growth: f64,
    reach: f64,
    /// The power of the distance with which the convergence on nearer panels may fall.
    eased: f64,
}

impl Anchor {
    /// The end of a zone, or a bend of the profile in it.
    fn new(
        base: &Base,
        zone: &Zone,
        (at, is_left): (f64, bool),
        (layer, corner, fineness): (f64, f64, Fineness),
    ) -> Self {
        let exponent = base.ground.exponent();
        // For a pressure that goes on as `d^power ln d`.
        let share = |share: f64, power: f64| share.powf(power / (power - exponent));
        let side = zone.ends.iter().position(|end| *end == at);
        let is_free = side.is_some_and(|side| zone.is_free(side));
        let is_axis = side.is_some_and(|side| zone.kinds[side] == EndKind::Axis);
        let is_end = side.is_some() && !is_axis;
        let is_point = !is_end && base.is_measured();
        let is_corner = if is_end { !base.is_joined(zone) } else { base.walls.contains(at) };
        let least = if is_free {
            let root = share(FREE.sqrt(), 2.0) * (zone.length().min(LONGEST) * layer).sqrt();
            let kappa = base.layer.exponent();
            let bent = zone.length() * BENT.powf(kappa / (1.0 + kappa));
            fineness.ends * if base.layer.is_linear() { root } else { root.min(bent) }
        } else if is_axis && !is_point && !base.breaks.contains(&at) {
            fineness.longest
        } else if is_point {
            POINT * layer
        } else if is_corner {
            fineness.ends * corner
        } else {
            // The seam of a wave that touches all over is no corner, either.
            at_bend(base, zone, (at, is_left), fineness.ends * share(KINK, 2.0) * layer, fineness)
        };
        let growth = if is_free { FREE_GROWTH } else { GROWTH };
        // At a measured point the power is 4: with that a stated error grew 2.9 times.
        let power = if is_corner && !is_free { 1.0 } else { 2.0 };
        let eased = EASED * (power - exponent) / fineness.order as f64;
        // The pressure at a free end rises over the length of its zone, and from a measured point that of a smooth contact, too, goes on as `d^2 ln d`. Farther away than the longest panels ask for none
        // is longer for its distance, and what is missed there is no measure.
        let rise = if is_free { layer.min((zone.length() * layer).sqrt()) } else { layer };
        let reach = (if is_point { f64::INFINITY } else { rise }).min(fineness.longest / growth);
        Self { at, is_left, shortest: least.max(ROUNDING), growth, reach, eased }
    }

    /// The axis: beside it the kernel of rings is no polynomial but on panels that are short for their distance from it; the one that begins there has a rule of its own.
    const AXIS: Self =
        Self { at: 0.0, is_left: true, shortest: 0.0, growth: GROWTH, reach: 0.0, eased: 0.0 };

    /// The longest panel between these places.
    fn allowed(&self, places: [f64; 2]) -> f64 {
        if self.shortest == 0.0 && places[0] == self.at {
            return f64::INFINITY;
        }
        let far = self.far(places);
        (far - self.begin(far)).max(self.shortest)
    }

    /// Where the panel that reaches to the far one of these places may begin.
    fn cut(&self, places: [f64; 2]) -> f64 {
        let begin = self.begin(self.far(places));
        if self.is_left { self.at + begin } else { self.at - begin }
    }

    fn far(&self, [left, right]: [f64; 2]) -> f64 {
        if self.is_left { right - self.at } else { self.at - left }
    }

    /// The distance at which a panel may begin that ends at another.
    fn begin(&self, far: f64) -> f64 {
        if far >= self.reach {
            return far / (1.0 + self.growth);
        }
        let eased = (far / self.reach).powf(self.eased);
        let left = (eased * convergence(self.growth)).max(convergence(STEEPEST));
        far / (1.0 + 2.0 / (0.5 * (left + 1.0 / left) - 1.0))
    }
}

/// What a node more divides the error by on panels so much longer than their distance from a singularity: the sum of the half-axes of Bernstein's ellipse through that.
fn convergence(growth: f64) -> f64 {
    let middle = 1.0 + 2.0 / growth;
    middle + (middle * middle - 1.0).sqrt()
}

/// The panel at a corner or a step, where the pressure goes on as `d ln d`, and on graded ground as `d^nu`. Over its length `d` the pressure changes by the share `V = theta d K(d)/nu`. Longer, and what
/// polynomials miss of that, `s V^2`, is more than what the rounding of places makes of it, `nu V eps/d`; shorter, and it is less.
fn at_corner(base: &Base, theta: f64, order: usize) -> f64 {
    let Some((kernel, half)) = base.ground.panel_kernel() else { return LONGEST };
    let power = 1.0 - base.ground.exponent();
    let missed = missed_of_power(order, power);
    (0..SETTLING).fold(LONGEST, |length, _| {
        let steepness = theta * kernel.value(length / half);
        (power * (OF_A_PLACE / (missed * steepness)).sqrt()).min(LONGEST)
    })
}

/// The panel at a bend, no longer than at a kink: at a sharp tip the profile itself goes on as a power of the distance. What polynomials miss of it changes the potential by its product with the
/// share `V` of [`at_corner`], which may not show in the layer. At the tip itself heights are rounded by a power of the rounding of places, and far less beside it.
fn at_bend(base: &Base, zone: &Zone, end: (f64, bool), longest: f64, fineness: Fineness) -> f64 {
    let ((at, is_left), mut length) = (end, longest);
    let Some((kernel, half)) = base.ground.panel_kernel() else { return length };
    let steepness = base.steepness() / base.ground.strength();
    let allowed = fineness.straight * base.depth();
    while length > ROUNDING {
        let beyond = zone.inside(if is_left { at + length } else { at - length });
        let missed = base.shown([at.min(beyond), at.max(beyond)], fineness.order).missed;
        let share = steepness * length * kernel.value(length / half);
        if share * missed <= allowed || missed <= base.surface.rounding(beyond) {
            break;
        }
        length *= 0.5;
    }
    length
}

/// The panels of all zones from left to right; none where they are too many.
pub(super) fn panels(
    base: &Base,
    joints: &[f64],
    zones: &[Zone],
    fineness: Fineness,
    most: usize,
) -> Option<Vec<[f64; 2]>> {
    let mut panels = Vec::new();
    // The length of the layer, of one that bends under about the mean pressure.
    let theta = base.steepness() / base.ground.strength();
    let layer = theta.max(1.0).powf(-1.0 / (1.0 - base.ground.exponent()));
    let corner = at_corner(base, theta, fineness.order);
    for zone in zones {
        let inside = joints.partition_point(|at| *at <= zone.left())
            ..joints.partition_point(|at| *at < zone.right());
        let anchor = |place| Anchor::new(base, zone, place, (layer, corner, fineness));
        let ends = [anchor((zone.left(), true)), anchor((zone.right(), false))];
        let mut left = zone.left();
        for right in joints[inside].iter().copied().chain([zone.right()]) {
            // Beside a joint by rounding there is no panel.
            if right - left > ROUNDING || right == zone.right() {
                let bends = [(left, true), (right, false)].into_iter();
                let bends = bends.filter(|(at, _)| !zone.ends.contains(at)).map(anchor);
                let axis = base.ground.is_disk().then_some(Anchor::AXIS);
                let anchors: Vec<Anchor> = ends.into_iter().chain(bends).chain(axis).collect();
                let mut pieces = vec![[left, right]];
                if !base.is_measured() {
                    pieces = resolved(base, [left, right], fineness);
                }
                for piece in pieces {
                    graded(&anchors, piece, fineness.longest, &mut panels);
                }
                left = right;
            }
            if panels.len() * fineness.order > most {
                return None;
            }
        }
    }
    Some(panels)
}

/// Cuts a piece so that its parts grow with their distances from all of these places.
fn graded(anchors: &[Anchor], piece: [f64; 2], longest: f64, panels: &mut Vec<[f64; 2]>) {
    let mut left_to_do = vec![piece];
    while let Some([left, right]) = left_to_do.pop() {
        let length = right - left;
        let tightest = (anchors.iter().map(|anchor| (anchor.allowed([left, right]), anchor)))
            .min_by(|(one, _), (other, _)| one.total_cmp(other));
        let cut = match tightest {
            // Lengths that are just right are so but for rounding.
            Some((allowed, anchor)) if length > (1.0 + SLIVER) * allowed => {
                anchor.cut([left, right])
            }
            _ if length > longest => 0.5 * (left + right),
            _ => right,
        };
        if cut > left && cut < right {
            left_to_do.extend([[cut, right], [left, cut]]);
        } else {
            panels.push([left, right]);
        }
    }
}

/// Halves of a piece until the profile is a polynomial on each.
fn resolved(base: &Base, piece: [f64; 2], fineness: Fineness) -> Vec<[f64; 2]> {
    let mut pieces = Vec::new();
    let mut left_to_do = vec![(piece, 0)];
    while let Some(([left, right], halvings)) = left_to_do.pop() {
        let middle = 0.5 * (left + right);
        let is_long = right - left > fineness.longest;
        if halvings < HALVINGS && (is_long || !is_polynomial(base, [left, right], fineness)) {
            left_to_do.extend([([middle, right], halvings + 1), ([left, middle], halvings + 1)]);
        } else {
            pieces.push([left, right]);
        }
    }
    pieces
}

/// Whether the polynomial of a panel shows the profile but for what rounding makes of heights.
fn is_polynomial(base: &Base, [left, right]: [f64; 2], fineness: Fineness) -> bool {
    let Shown { largest, missed } = base.shown([left, right], fineness.order);
    let allowed = fineness.straight * largest * fineness.order as f64;
    missed <= allowed || missed <= base.surface.rounding(0.5 * (left + right))
}
