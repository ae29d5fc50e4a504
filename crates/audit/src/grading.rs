//! Where the density is cut into panels.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::legendre::ORDER;
use crate::panel::{Panel, TAIL};
use crate::processors::each;
use crate::sample::{COARSE, FINEST, Sampled, graininess, sampled};
use crate::sampled::SMALLEST;

/// A panel at an end of a part is cut at one of these shares of it from the end: densities bend there as `d ln d`, with which short panels need to be less exact.
const CUTS: [f64; 6] = [1.0 / 64.0, 1.0 / 32.0, 1.0 / 16.0, 1.0 / 8.0, 0.25, FARTHEST];
const FARTHEST: f64 = 0.4;
/// The first of the last coefficients.
const LAST: i32 = (ORDER - TAIL) as i32;
/// Of `d ln d` beyond an end of a panel they are so many times `(rho - 1/rho) rho^-n` larger than where it begins at that end; only where to cut first goes by it.
const BESIDE: f64 = 32.0;
/// By what guesses of a tail may be off.
const GUESSED: f64 = 8.0;
/// Powers of the distance that tails towards an end may fall with.
const FALLS: [f64; 2] = [0.25, 4.0];
/// A tail no larger than this many times what is allowed, that does not fall, is rounding of the density.
const ROUNDING: f64 = 4.0;
/// What an end panel leaves out is so many times its tail.
const LEFT_OUT: f64 = 4.0;
/// Panels are at most this long: far parts of a row are integrated on their nodes.
const LONGEST: f64 = 0.5;
/// And this share of their zone: beside a free end the pressure is nowhere firmly positive on the whole panel.
const LONGEST_OF_ZONE: f64 = 0.25;
/// What is left of the tail after a cut, from which on it is noise, where it is below this share of the density: a kink leaves a half.
const STAGNANT: f64 = 0.75;
const NOISE: f64 = 1e-7;
/// The coefficients of noise do not fall either: its tail is at least this share of those before. Of `d^(1/2)` at an end it is less.
const FLAT: f64 = 0.6;
/// On a panel beside a corner the density is so many times steeper at the near end than at the far one.
const STEEPER: f64 = 4.0;
/// What a panel beside a corner misses at its end, in last coefficients: those of `d ln d` fall as `4/n^3`, so that the rest of them adds up to half their number. Powers fall more slowly still, yet
/// beside a jump shorter panels only leave more of them to single numbers: there a bound of `cargo test -p shtaerman-cli kinks_and_jumps` is 1.2e-9 without it, 3.4e-9 with it.
const MISSED_AT_END: f64 = 0.5 * ORDER as f64;

/// Parts of zones that are resampled together, in half a millisecond or more: far longer than a thread is begun in.
const TOGETHER: usize = 16;

/// What was seen of a part: the last coefficients, and its width.
#[derive(Debug, Clone, Copy)]
struct Seen {
    tail: f64,
    width: f64,
}

/// A part of a zone that is to be resolved.
struct Part {
    left: f64,
    right: f64,
    /// Whether it ends where the density may bend.
    is_end: [bool; 2],
    /// The tail of the last part around it that was looked at.
    before: f64,
    /// The last part looked at that is like it: one around it, with the same end if it has one.
    like: Option<Seen>,
    /// The power of the distance with which tails fall towards its end, once two were seen.
    fall: Option<f64>,
    /// What was sampled of it when a place to cut was looked for.
    known: Option<Sampled>,
}

impl Part {
    /// A part on which nothing was looked at.
    fn new([left, right]: [f64; 2], is_end: [bool; 2]) -> Self {
        let (before, like, fall, known) = (f64::INFINITY, None, None, None);
        Self { left, right, is_end, before, like, fall, known }
    }

    fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Whether it has one end where the density may bend.
    fn is_graded(&self) -> bool {
        self.is_end[0] != self.is_end[1]
    }

    /// The tail to expect; 0 where nothing is known of it.
    fn expected(&self) -> f64 {
        let Some(Seen { tail, width }) = self.like else { return 0.0 };
        let share = self.width() / width;
        match self.is_end {
            // Coefficients fall with the width to their degree at best.
            [false, false] => tail * share.powi(LAST),
            _ => self.fall.map_or(0.0, |fall| tail * share.powf(fall)),
        }
    }

    /// Takes note of its tail.
    fn see(&mut self, tail: f64) {
        let width = self.width();
        if let (true, Some(last)) = (self.is_graded(), self.like) {
            let fall = (last.tail / tail).ln() / (last.width / width).ln();
            self.fall = Some(if fall.is_nan() { FALLS[0] } else { fall.clamp(FALLS[0], FALLS[1]) });
        }
        self.before = tail;
        self.like = Some(Seen { tail, width });
    }

    /// Where to cut it at this share of its width from the end that bends; in the middle of others.
    fn place(&self, share: f64) -> f64 {
        match self.is_end {
            [true, false] => self.left + share * self.width(),
            [false, true] => self.right - share * self.width(),
            _ => self.left + 0.5 * self.width(),
        }
    }

    /// What is beyond a cut, seen from the end that bends.
    fn beyond(&self, at: f64) -> [f64; 2] {
        if self.is_end[0] { [at, self.right] } else { [self.left, at] }
    }

    /// The parts on both sides of a cut, the left one last; `beyond` is what was sampled of the farther one.
    fn halves(self, at: f64, beyond: Option<Sampled>) -> [Self; 2] {
        let [is_left, is_right] = self.is_end;
        // What is beyond a cut of a part that bends is another thing, and so are halves of what bends at both ends.
        let [first, last] = match self.is_end {
            [true, false] => [true, false],
            [false, true] => [false, true],
            [is_bent, _] => [!is_bent; 2],
        };
        let part = |left, right, is_end, is_like: bool| Self {
            left,
            right,
            is_end,
            before: self.before,
            like: self.like.filter(|_| is_like),
            fall: self.fall.filter(|_| is_like),
            known: None,
        };
        let mut first = part(self.left, at, [is_left, false], first);
        let mut last = part(at, self.right, [false, is_right], last);
        if is_left {
            last.known = beyond;
        } else {
            first.known = beyond;
        }
        [last, first]
    }
}

/// How much coefficients fall for each degree on a panel of which a singular place is so far, as a share of its distance from the other end.
fn falling(share: f64) -> f64 {
    let root = share.sqrt();
    (1.0 + root) / (1.0 - root)
}

/// How well a density is to be resolved.
pub(crate) struct Limits<'a> {
    /// What a polynomial may miss between two places.
    pub(crate) exact: &'a (dyn Fn(f64, f64) -> f64 + Sync),
    /// What the density is known to at best there: what is finer is rounding.
    pub(crate) known: &'a (dyn Fn(f64, f64) -> f64 + Sync),
    /// The size of the density.
    pub(crate) scale: f64,
    /// The exponent of a kernel that is a power, 0 of a logarithm.
    pub(crate) exponent: f64,
}

/// Places where panels are cut, and those of them where the density may bend.
pub(crate) struct Cuts<'a> {
    pub(crate) all: &'a [f64],
    pub(crate) bent: &'a [f64],
}

/// A density that is resampled.
struct Sampling<'a> {
    density: &'a dyn Fn(f64) -> f64,
    limits: &'a Limits<'a>,
    longest: f64,
    /// Nearer to the origin numbers are finer than anything the pressure is known to.
    origin: f64,
}

/// A part of a zone between places where panels are cut, and the width of the zone.
struct Stretch {
    ends: [f64; 2],
    is_end: [bool; 2],
    width: f64,
}

/// Panels of zones from left to right on which the density is a polynomial to a tolerance for their ends; none where they would be more than `most`.
pub(crate) fn panels(
    density: &(dyn Fn(f64) -> f64 + Sync),
    zones: &[[f64; 2]],
    cuts: &Cuts<'_>,
    limits: &Limits<'_>,
    most: usize,
) -> Option<Vec<Panel>> {
    let stretches: Vec<Stretch> = zones.iter().flat_map(|zone| cut(*zone, cuts)).collect();
    let count = AtomicUsize::new(0);
    let found = each(&stretches, TOGETHER, |part| {
        let mut found = Vec::new();
        let mut stretches = part.iter();
        let is_done = stretches.all(|stretch| {
            Sampling::new(density, limits, stretch.width).cover(stretch, most, &count, &mut found)
        });
        is_done.then_some(found)
    });
    let found: Option<Vec<Vec<Panel>>> = found.into_iter().collect();
    found.map(|parts| parts.concat())
}

/// The parts of a zone between the places where panels are cut.
fn cut(zone: [f64; 2], cuts: &Cuts<'_>) -> Vec<Stretch> {
    let is_bent = |at: f64| cuts.bent.binary_search_by(|cut| cut.total_cmp(&at)).is_ok();
    let inside =
        cuts.all.partition_point(|at| *at <= zone[0])..cuts.all.partition_point(|at| *at < zone[1]);
    let inside = cuts.all.get(inside).unwrap_or_default().iter();
    let mut ends = vec![(zone[0], true)];
    ends.extend(inside.map(|at| (*at, is_bent(*at))));
    ends.push((zone[1], true));
    let stretch = |[left, right]: [(f64, bool); 2]| Stretch {
        ends: [left.0, right.0],
        is_end: [left.1, right.1],
        width: zone[1] - zone[0],
    };
    ends.windows(2).map(|pair| stretch([pair[0], pair[1]])).collect()
}

/// What becomes of a part.
#[expect(clippy::large_enum_variant, reason = "it is taken apart at once")]
enum Judged {
    Done(Panel),
    Cut([Part; 2]),
}

impl<'a> Sampling<'a> {
    /// On a zone of this width.
    fn new(density: &'a dyn Fn(f64) -> f64, limits: &'a Limits<'a>, width: f64) -> Self {
        let longest = LONGEST.min(LONGEST_OF_ZONE * width);
        Self { density, limits, longest, origin: SMALLEST * width }
    }

    /// Adds the panels of a part of a zone; whether with those of others, which `count` counts, they are no more than `most`.
    fn cover(
        &self,
        stretch: &Stretch,
        most: usize,
        count: &AtomicUsize,
        found: &mut Vec<Panel>,
    ) -> bool {
        let mut stack = vec![Part::new(stretch.ends, stretch.is_end)];
        while let Some(part) = stack.pop() {
            match self.judged(part) {
                Judged::Done(panel) => {
                    found.push(panel);
                    count.fetch_add(1, Ordering::Relaxed);
                }
                Judged::Cut(halves) => stack.extend(halves),
            }
            // Panels only become more: whoever sees that these are too many, they are, and nobody else goes on.
            if count.load(Ordering::Relaxed) + stack.len() > most {
                count.fetch_add(most, Ordering::Relaxed);
                return false;
            }
        }
        true
    }

    fn is_resolved(&self, [left, right]: [f64; 2], tail: f64) -> bool {
        tail <= (self.limits.exact)(left, right) || tail <= (self.limits.known)(left, right)
    }

    fn judged(&self, mut part: Part) -> Judged {
        let width = part.width();
        let exact = (self.limits.exact)(part.left, part.right);
        let finest = FINEST * part.left.abs().max(part.right.abs()).max(self.origin);
        // What is too long is not looked at, nor what cannot be resolved yet.
        let is_worth =
            part.known.is_some() || part.expected() <= GUESSED * exact || width <= COARSE * finest;
        let mut tail = part.expected();
        if width <= self.longest && is_worth {
            let panel;
            (panel, tail) =
                (part.known.take()).unwrap_or_else(|| sampled(self.density, part.left, part.right));
            if self.is_done(&part, &panel, tail, finest) {
                return Judged::Done(panel);
            }
            part.see(tail);
        }
        let (at, beyond) = self.cut(&part, tail);
        Judged::Cut(part.halves(at, beyond))
    }

    fn is_done(&self, part: &Part, panel: &Panel, tail: f64, finest: f64) -> bool {
        let width = part.width();
        let exact = (self.limits.exact)(part.left, part.right);
        let is_stagnant = tail > STAGNANT * part.before && tail < NOISE * self.limits.scale;
        let is_noise =
            (is_stagnant || tail <= ROUNDING * exact) && tail > FLAT * panel.before_tail();
        let is_log = self.limits.exponent == 0.0;
        let grain = if is_log { STEEPER / MISSED_AT_END } else { STEEPER };
        // What bends at an end has coefficients beyond the last that add up.
        let left_out = if part.is_graded() { LEFT_OUT } else { 1.0 };
        self.is_resolved([part.left, part.right], left_out * tail)
            || is_noise
            || width <= finest
            || (width <= COARSE * finest && tail <= grain * graininess(self.density, panel))
    }

    /// Where to cut a part: as near to an end as what is beyond is resolved; then with that. `tail` is that of the part, 0 where it is not known.
    fn cut(&self, part: &Part, mut tail: f64) -> (f64, Option<Sampled>) {
        if !part.is_graded() {
            return (part.place(0.5), None);
        }
        for share in CUTS {
            let at = part.place(share);
            let [left, right] = part.beyond(at);
            // What bends at the end has coefficients that fall beyond a cut as its distance makes them; all that are left out add up.
            let rho = falling(share);
            let fallen = BESIDE * (rho - 1.0 / rho) * rho.powi(-LAST);
            let left_out = rho / (rho - 1.0);
            let exact = (self.limits.exact)(left, right);
            let is_likely = tail > 0.0 && tail * fallen * left_out <= exact;
            if right - left > self.longest || !(is_likely || share == FARTHEST) {
                continue;
            }
            let sampled = sampled(self.density, left, right);
            if share == FARTHEST || self.is_resolved([left, right], sampled.1 * left_out) {
                return (at, Some(sampled));
            }
            tail = tail.max(sampled.1 / fallen);
        }
        (part.place(FARTHEST), None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What never comes to rest towards the axis ends all the same, long before the smallest numbers of the machine.
    #[test]
    fn panels_at_the_origin_have_an_end() {
        let density = |r: f64| if r == 0.0 { 1.0 } else { 1.0 + 0.1 * r.ln().sin() };
        let limits = Limits { exact: &|_, _| 1e-14, known: &|_, _| 0.0, scale: 1.0, exponent: 0.5 };
        let cuts = Cuts { all: &[], bent: &[] };
        let found = panels(&density, &[[0.0, 1.0]], &cuts, &limits, 1 << 16).unwrap();
        assert_eq!(found[0].left, 0.0);
        assert!(found[0].right > 1e-20, "{:e}", found[0].right);
    }

    /// Where panels are too many nobody goes on, however many parts there are.
    #[test]
    fn what_is_refused_is_refused_soon() {
        let calls = AtomicUsize::new(0);
        let density = |x: f64| {
            calls.fetch_add(1, Ordering::Relaxed);
            1.0 + (1e9 * x).sin()
        };
        let limits = Limits { exact: &|_, _| 1e-14, known: &|_, _| 0.0, scale: 1.0, exponent: 0.0 };
        let places: Vec<f64> = (-999..1000).map(|k| f64::from(k) / 1000.0).collect();
        let cuts = Cuts { all: &places, bent: &[] };
        let most = 4000;
        assert!(panels(&density, &[[-1.0, 1.0]], &cuts, &limits, most).is_none());
        let calls = calls.load(Ordering::Relaxed);
        assert!(calls <= 8 * ORDER * most, "{calls}");
    }
}
