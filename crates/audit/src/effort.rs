//! What an audit may take before it gives up.

/// Panels of a pressure, and as many more for each place where it may bend (survey: of 12,000 random problems the audits that came to an end took 341 at most, traces one or two a point).
const PANELS: [usize; 2] = [4_000, 12];
/// Looks at panels, likewise (survey: of 200 plausible problems 1.7 million at most, of traces up to 900 a point).
const LOOKS: [u64; 2] = [5_000_000, 2_000];
/// Looks that take as long as the bounds of the heights on a window (survey: 4 us beside 0.28, of a formula that could not be resolved; of 200 plausible problems 7,000 windows at most, 8 a point of traces).
pub(crate) const WINDOW: u64 = 15;
/// Looks that take as long as bounds of the heights between two neighbouring numbers (survey: 3.4 us, of the same formula).
const RANGE: u64 = 12;
/// Of the places where a pressure may bend so many count: what is kept has an end.
const MOST_CUTS: usize = 20_000;

/// Looks that take as long as such bounds, given those of derivatives there (survey: of two formulas with 1,000 and 3,600 operations 0.41 and 0.40 of these).
pub(crate) fn of_range(derivatives: u64) -> u64 {
    RANGE.max(derivatives / 2)
}

/// What it may take.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Effort {
    /// Most panels.
    pub(crate) panels: usize,
    /// How often what lies on a panel, or on several together, may be looked at from some places.
    pub(crate) looks: u64,
}

impl Effort {
    /// For a pressure that may bend at these places.
    pub(crate) fn new(cuts: &[f64]) -> Self {
        let count = cuts.len().min(MOST_CUTS);
        Self { panels: PANELS[0] + PANELS[1] * count, looks: LOOKS[0] + LOOKS[1] * count as u64 }
    }
}
