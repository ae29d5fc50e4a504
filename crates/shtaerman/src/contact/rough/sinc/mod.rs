//! Sinc collocation on panels between the bends of the base: few zones, on any ground.

mod equation;
mod nodes;

use fredholm::collocation::first_half_count;

use super::base::Base;
use super::linearised::{Changes, Known, compared};
use super::nodes::{Discrete, FEWEST, RATIO};
use crate::contact::rates::Linearised;
use crate::contact::setting::Setting;
use crate::{ContactKind, Error};
use nodes::{Resolution, SincNodes};

pub(super) use equation::{Collocation, Effort};

impl Setting {
    /// The first-order change of a solution by the degenerate kernel, given its displacement `theta0 K p0` and the degree that its profile needs.
    pub(in crate::contact) fn linearised_whole_base(
        &self,
        displacement: &dyn Fn(f64) -> f64,
        profile_degree: usize,
        peak: f64,
    ) -> Option<Linearised> {
        let base = Base::new(self, ContactKind::Bilateral).ok()?.cut(&self.collocated_parts());
        let room = Effort::LITTLE.room(base.breaks.len() + 1);
        let smooth = first_half_count(base.steepness()).max(FEWEST as f64);
        // Two nodes of a whole base that was not collocated for each Chebyshev degree of its profile: at half or twice 3 of 10 answers change, within what they state (survey).
        let wanted = (smooth + 2.0 * profile_degree as f64).min(room);
        let changes = |power: i32| -> Result<Changes, Error> {
            let resolution = Resolution::new(&base.ground, wanted * RATIO.powi(power), 0.0)?;
            let on = SincNodes::new(&base, &resolution, &base.whole())?;
            let nodes = on.nodes();
            let body: Vec<f64> = nodes.places.iter().map(|xi| -displacement(*xi)).collect();
            let parts = on.responses(&on.inverse(None)?, &body, None)?;
            // Of a linear layer the pressure itself counts for nothing.
            Known { frame: nodes.frame, parts: &parts, displacement, peak: (peak, 1.0) }
                .changes(None)
        };
        let levels: Result<Vec<Changes>, Error> = [-2, -1, 0].into_iter().map(changes).collect();
        compared(&levels.ok()?, Some(RATIO))
    }
}
