//! The first-order change of a whole base that was not collocated.

use fredholm::collocation::first_half_count;

use super::equation::Effort;
use super::field::RATIO;
use super::nodes::{FEWEST, Resolution, SincNodes};
use crate::contact::rates::Linearised;
use crate::contact::rough::base::Base;
use crate::contact::rough::linearised::{Changes, Known, compared};
use crate::contact::rough::nodes::Discrete;
use crate::contact::setting::Setting;
use crate::{ContactKind, Error};

/// Nodes of such a base for each Chebyshev degree of its profile. At half or twice 3 of 10 answers change, within what they state (survey).
const NODES_PER_DEGREE: f64 = 2.0;

impl Setting {
    /// The first-order change of a solution by the degenerate kernel, given its displacement `theta0 K p0` and the degree that its profile needs.
    pub(in crate::contact) fn linearised_whole_base(
        &self,
        displacement: &dyn Fn(f64) -> f64,
        profile_degree: usize,
        peak: f64,
    ) -> Option<Linearised> {
        let base = Base::new(self, ContactKind::Bilateral).ok()?;
        let base = base.cut(&self.collocated_parts());
        let room = 0.5 * Effort::LITTLE.nodes as f64 / (base.breaks.len() + 1) as f64;
        let smooth = first_half_count(base.steepness()).max(FEWEST as f64);
        let wanted = (smooth + NODES_PER_DEGREE * profile_degree as f64).min(room);
        let changes = |power: i32| -> Result<Changes, Error> {
            let resolution = Resolution::new(&base.ground, wanted * RATIO.powi(power))?;
            let nodes = SincNodes::new(&base, &resolution, &base.whole())?;
            let inverse = nodes.inverse(None)?;
            let body: Vec<f64> = nodes.nodes().places.iter().map(|xi| -displacement(*xi)).collect();
            let parts = nodes.responses(&inverse, &body, None)?;
            // Of a linear layer the pressure itself counts for nothing.
            let (frame, peak) = (nodes.nodes().frame, (peak, 1.0));
            Known { frame, parts: &parts, displacement, peak }.changes(None)
        };
        let levels: Vec<Changes> = [-2, -1, 0].into_iter().map_while(|k| changes(k).ok()).collect();
        if levels.len() < 3 { None } else { compared(&levels, Some(RATIO)) }
    }
}
