//! The load on given zones, in local coordinates `xi = c + b y`.
//!
//! The equation is `v + theta K p = D - beta y - f0` with `D = delta0 - alpha0 c + theta0 P0 g`, `beta = b alpha0` and the gauge `g` of the ground: `ln b` for one punch or a pair on a
//! half-plane. Moments are counted about `c` where that is possible: about the middle of the base, small zones far from it would lose twice the digits.

use super::base::Base;
use crate::Error;
use crate::contact::balance::State;
use crate::contact::ground::Hull;
use crate::contact::stiffness::{Stiffness, cramer, require_solved};
use crate::{Load, Rotational, Vertical};

/// Local coordinates and the load in them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub(super) hull: Hull,
    /// `theta0 g`.
    gauge: f64,
    /// Whether there are moments: rings have none, and a wave that goes on has none that could turn it.
    pub(super) turns: bool,
    load: Load,
}

/// A pressure, or a change of it, with the local displacements that go with it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Direction {
    /// `D` and `beta`.
    pub(super) local: [f64; 2],
    /// Force, and moment about the centre.
    pub(super) carried: [f64; 2],
}

impl Direction {
    /// Those of `D` and `beta`, given what they carry.
    pub(super) fn of_local([level, tilted]: [[f64; 2]; 2]) -> [Self; 2] {
        let of = |local, carried| Self { local, carried };
        [of([1.0, 0.0], level), of([0.0, 1.0], tilted)]
    }

    /// The sum of directions, each times its factor.
    pub(super) fn sum(parts: &[(f64, Self)]) -> Self {
        let added = |of: fn(&Self) -> [f64; 2]| {
            [0, 1].map(|k| parts.iter().map(|(factor, part)| factor * of(part)[k]).sum())
        };
        Self { local: added(|part| part.local), carried: added(|part| part.carried) }
    }
}

impl Frame {
    /// On these local coordinates, whose kernel differs from that of the ground by the gauge.
    pub(super) fn new(base: &Base, hull: Hull, gauge: f64) -> Self {
        let turns = !base.ground.is_disk() && !base.ground.is_closed();
        Self { hull, gauge: base.theta() * gauge, turns, load: base.load }
    }

    /// `y`.
    pub(super) fn local(&self, xi: f64) -> f64 {
        (xi - self.hull.centre) / self.hull.half
    }

    /// The same under another load.
    pub(super) fn under(self, load: Load) -> Self {
        let rotational = if self.turns { load.rotational } else { Rotational::Tilt(0.0) };
        Self { load: Load { rotational, ..load }, ..self }
    }

    pub(super) fn is_by_force(&self) -> bool {
        matches!(self.load.vertical, Vertical::Force(_))
    }

    pub(super) fn is_by_moment(&self) -> bool {
        !matches!(self.load.rotational, Rotational::Tilt(_))
    }

    /// Whether the rotational load is a quantity of its own.
    pub(super) fn rotates(&self) -> bool {
        self.turns && !matches!(self.load.rotational, Rotational::Eccentricity(_))
    }

    /// The prescribed force, or none.
    pub(super) fn force(&self) -> Option<f64> {
        self.load.vertical.force()
    }

    /// Where moments are counted from, as `xi`.
    fn arm(&self) -> f64 {
        if self.turns { self.hull.centre } else { 0.0 }
    }

    /// The lever that the second condition adds to that about the centre, where it is one of moments.
    pub(super) fn lever(&self) -> f64 {
        match (self.load.rotational, self.load.vertical) {
            (Rotational::Tilt(_), _) | (_, Vertical::Force(_)) => 0.0,
            (Rotational::Moment(_), _) => self.arm(),
            (Rotational::Eccentricity(e), _) => self.arm() - e,
        }
    }

    /// `D` and `beta` as far as they are prescribed.
    pub(super) fn start(&self) -> [f64; 2] {
        let [settlement, tilt] = self.load.displacements();
        [settlement, self.hull.half * tilt]
    }

    /// Settlement, tilt, force and moment of a direction.
    pub(super) fn changes(&self, direction: &Direction) -> State {
        let Hull { centre, half } = self.hull;
        let Direction { local: [constant, slope], carried: [force, turn] } = *direction;
        State {
            settlement: constant + centre / half * slope - self.gauge * force,
            tilt: slope / half,
            force,
            moment: turn + self.arm() * force,
        }
    }

    /// What a direction adds to the two prescribed quantities, a moment about the centre where the force is prescribed.
    fn conditions(&self, direction: &Direction) -> [f64; 2] {
        let State { settlement, tilt, .. } = self.changes(direction);
        let [force, turn] = direction.carried;
        [
            if self.is_by_force() { force } else { settlement },
            if self.is_by_moment() { turn + self.lever() * force } else { tilt },
        ]
    }

    /// The conditions for values of the prescribed quantities; an eccentricity, which is no quantity to be met, counts as nothing.
    pub(super) fn conditions_for(&self, [vertical, rotational]: [f64; 2]) -> [f64; 2] {
        let rotational = match (self.load.rotational, self.load.vertical) {
            (Rotational::Moment(_), Vertical::Force(_)) => rotational - self.arm() * vertical,
            (Rotational::Eccentricity(e), Vertical::Force(_)) => (e - self.arm()) * vertical,
            _ => rotational,
        };
        [vertical, rotational]
    }

    /// What a direction lacks of the load.
    pub(super) fn lack(&self, direction: &Direction) -> [f64; 2] {
        let (Vertical::Force(vertical) | Vertical::Settlement(vertical)) = self.load.vertical;
        let rotational = match self.load.rotational {
            Rotational::Moment(value) | Rotational::Tilt(value) => value,
            Rotational::Eccentricity(_) => 0.0,
        };
        let wanted = self.conditions_for([vertical, rotational]);
        let reached = self.conditions(direction);
        [wanted[0] - reached[0], wanted[1] - reached[1]]
    }

    /// How much of the directions of `D` and `beta` brings the conditions to what is wanted, beside a share of what is given.
    ///
    /// # Errors
    /// [`Error::Equation`] where no pressure on the zones does.
    pub(super) fn met(
        &self,
        frame: &[Direction; 2],
        (share, given): (f64, &Direction),
        wanted: [f64; 2],
    ) -> Result<[f64; 2], Error> {
        let [[a, c], [b, d]] = frame.each_ref().map(|direction| self.conditions(direction));
        let known = self.conditions(given);
        let lack = [0, 1].map(|k| wanted[k] - share * known[k]);
        let found = cramer([[a, b], [c, d]], lack);
        require_solved(found, a * d - b * c).map(|()| found)
    }

    /// The state of a solution; what is prescribed comes back as given. `moment` is that of a whole period, where nothing turns.
    pub(super) fn state(&self, direction: &Direction, moment: Option<f64>) -> State {
        let Direction { local: [constant, slope], carried: [force, turn] } = *direction;
        let moment = moment.unwrap_or(turn + self.arm() * force);
        let tilt = slope / self.hull.half;
        let state = State { settlement: 0.0, tilt, force, moment }.given(&self.load);
        let settlement = constant + state.tilt * self.hull.centre - self.gauge * state.force;
        State { settlement, ..state }.given(&self.load)
    }

    /// `D` and `beta` of a state.
    pub(super) fn local_of(&self, state: &State) -> [f64; 2] {
        let Hull { centre, half } = self.hull;
        let State { settlement, tilt, force, .. } = *state;
        [settlement - tilt * centre + self.gauge * force, half * tilt]
    }

    /// What the gauge takes from the displacement under a force.
    pub(super) fn gauge_of(&self, force: f64) -> f64 {
        self.gauge * force
    }

    /// `d(P0, M0)/d(delta0, -alpha0)` by the directions of `D` and `beta`; free edges that move add nothing of first order.
    pub(super) fn stiffness(&self, [level, tilted]: &[Direction; 2]) -> Stiffness {
        let Hull { centre, half } = self.hull;
        let [force, turn] = level.carried;
        let divisor = 1.0 - self.gauge * force;
        let coupling = (turn + self.arm() * force) / divisor;
        let raised = centre + self.gauge * coupling;
        Stiffness {
            force_settlement: force / divisor,
            coupling,
            // The slope is that of -beta.
            moment_tilt: centre * coupling + raised * turn - tilted.carried[1] * half,
        }
    }
}
