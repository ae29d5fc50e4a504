//! Windows that cover zones and what lies beside them, on all processors.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::bound::Audit;
use crate::effort::WINDOW;
use crate::heights::Known;
use crate::problem::Refusal;
use crate::processors::each;
use crate::residual::{Bounded, Residual, SMALLEST};

/// Windows are at least this wide, relative to their distance from the origin: some units of the machine.
const FINEST: f64 = 16.0 * f64::EPSILON;
/// An interval beside a bend is cut at this share of its length: the longer part has a disk of 1.29 times its half-length about it, as much as the bend is farther than the disk.
const BESIDE_A_BEND: f64 = 0.25;
/// Stretches that are covered together: of a measured profile they take some 3 ms, far longer than a thread is begun in. Whatever the processors, they are the same.
const TOGETHER: usize = 32;
/// The places told by a part of the work: after each of so many shares of all that may be done.
const MARKS: u64 = 256;

/// An interval of a zone, or beside zones, between places where the base may bend.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    left: f64,
    right: f64,
    /// The zone, or the interval between zones.
    whole: [f64; 2],
    is_zone: bool,
}

/// What is known of the residual on windows that cover some stretches.
#[derive(Debug, Default)]
struct Covered {
    /// Bounds of `|w|` in zones, and lower bounds of `w` beside zones, each from left to right.
    zones: Vec<Bounded>,
    gaps: Vec<Bounded>,
    /// How often panels were looked at, or so.
    looks: u64,
    /// Where, after each mark.
    marks: Vec<f64>,
    /// Whether that is all.
    is_whole: bool,
}

impl Audit<'_> {
    /// Bounds of `|w|` on windows that cover all zones, and lower bounds of `w` on such as cover what of the base lies beside them, with at most so many looks at panels.
    pub(crate) fn covered(&self, most: u64) -> Result<[Vec<Bounded>; 2], Refusal> {
        self.covering(most).map(|covered| [covered.zones, covered.gaps])
    }

    fn covering(&self, most: u64) -> Result<Covered, Refusal> {
        let mut stretches = Vec::new();
        let zones = self.answer.zones.iter().map(|zone| (*zone, true));
        for (whole, is_zone) in zones.chain(self.gaps().into_iter().map(|gap| (gap, false))) {
            let ends = cut(whole, self.problem.cuts);
            let parts = ends.windows(2);
            let stretch = |[left, right]: [f64; 2]| Stretch { left, right, whole, is_zone };
            stretches.extend(parts.map(|pair| stretch([pair[0], pair[1]])));
        }
        let spent = AtomicU64::new(0);
        let of_part = |part: &[Stretch]| self.residual().cover(part, most, &spent);
        let found = each(&stretches, TOGETHER, of_part);
        let mut all = Covered::default();
        for (part, mut covered) in stretches.chunks(TOGETHER).zip(found) {
            // Then it is refused. The place is that which work in order would have come to.
            if !covered.is_whole {
                covered = self.residual().cover(part, most, &AtomicU64::new(all.looks));
            }
            if all.looks + covered.looks > most {
                return Err(Refusal::TooManyWindows { at: covered.after(most - all.looks, most) });
            }
            all.zones.extend(covered.zones);
            all.gaps.extend(covered.gaps);
            all.looks += covered.looks;
        }
        Ok(all)
    }
}

impl Covered {
    /// The place after so many looks, of `most` altogether.
    fn after(&self, looks: u64, most: u64) -> f64 {
        let last = self.marks.len().saturating_sub(1);
        let index = usize::try_from(looks / mark(most)).map_or(last, |index| index.min(last));
        self.marks.get(index).copied().unwrap_or(f64::NAN)
    }
}

/// Looks from one mark to the next.
fn mark(most: u64) -> u64 {
    most / MARKS + 1
}

impl Residual<'_> {
    /// Windows that cover some stretches; not all where more looks than these are spent with those of others.
    fn cover(&self, stretches: &[Stretch], most: u64, spent: &AtomicU64) -> Covered {
        let mut covered = Covered::default();
        if spent.load(Ordering::Relaxed) > most {
            return covered;
        }
        for stretch in stretches {
            let mut known = Known::default();
            let mut stack = vec![Open::new(stretch)];
            while let Some(open) = stack.pop() {
                let Open { left, right, is_end } = open;
                let middle = open.cut();
                let whole = stretch.whole[1] - stretch.whole[0];
                let size = left.abs().max(right.abs()).max(SMALLEST * whole);
                let found = if stretch.is_zone { &mut covered.zones } else { &mut covered.gaps };
                if right - left <= FINEST * size || middle <= left || middle >= right {
                    self.narrow_parts([left, right], found);
                } else if let Some(window) = self.window([left, right], stretch, &mut known) {
                    found.push(window);
                } else {
                    stack.push(Open { left: middle, right, is_end: [false, is_end[1]] });
                    stack.push(Open { left, right: middle, is_end: [is_end[0], false] });
                }
                self.count(WINDOW + known.take_looks());
                let more = self.looks.get() - covered.looks;
                covered.looks += more;
                while covered.looks >= mark(most) * covered.marks.len() as u64 {
                    covered.marks.push(middle);
                }
                if spent.fetch_add(more, Ordering::Relaxed) + more > most {
                    return covered;
                }
            }
        }
        covered.is_whole = true;
        covered
    }

    fn window(&self, at: [f64; 2], stretch: &Stretch, known: &mut Known) -> Option<Bounded> {
        if stretch.is_zone {
            self.window_in_zone(at, stretch.whole, known)
        } else {
            self.window_in_gap(at, known)
        }
    }
}

/// The ends of an interval, and the places between where the base may bend: windows shrink to these from either side.
fn cut([left, right]: [f64; 2], cuts: &[f64]) -> Vec<f64> {
    let inside = cuts.partition_point(|cut| *cut <= left)..cuts.partition_point(|cut| *cut < right);
    let inside = cuts.get(inside).unwrap_or_default().iter().copied();
    std::iter::once(left).chain(inside).chain([right]).collect()
}

/// An interval that is still to be covered.
struct Open {
    left: f64,
    right: f64,
    /// Whether the residual may bend at that end.
    is_end: [bool; 2],
}

impl Open {
    fn new(stretch: &Stretch) -> Self {
        Self { left: stretch.left, right: stretch.right, is_end: [true; 2] }
    }

    /// Where it is cut: a window may be three times as long as it is away from a bend.
    fn cut(&self) -> f64 {
        let share = match self.is_end {
            [true, false] => BESIDE_A_BEND,
            [false, true] => 1.0 - BESIDE_A_BEND,
            _ => 0.5,
        };
        self.left + share * (self.right - self.left)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bound::resample;
    use crate::closed::Base;
    use crate::density::Density;
    use crate::effort::Effort;
    use crate::shape::restored;
    use crate::{Answer, Kernel, Prescribed, Problem};

    /// Does something with the audit of a pressure `sqrt(1 - x^2)` that may bend at hundreds of places.
    fn with_audit(work: impl FnOnce(&Audit<'_>)) {
        let base = Base { c: 1.0, bend: 1.0, kappa: 1.0 };
        let cuts: Vec<f64> = (-300..300).map(|k| (f64::from(k) + 0.37) / 301.0).collect();
        let problem = Problem {
            kernel: Kernel::Logarithm,
            ground: None,
            theta: 1.0,
            scaled: 0.0,
            pieces: &[[-1.0, 1.0]],
            is_bilateral: true,
            prescribed: Prescribed { force: None, moment: None },
            profile: &base,
            cuts: &cuts,
        };
        let half = std::f64::consts::FRAC_PI_2;
        let answer = Answer {
            zones: &[[-1.0, 1.0]],
            pressure: &|x: f64| ((1.0 - x) * (1.0 + x)).max(0.0).sqrt(),
            settlement: half * (0.5 + std::f64::consts::LN_2),
            tilt: 0.0,
            force: half,
            moment: 0.0,
        };
        let panels = resample(&problem, (&cuts, &Effort::new(&cuts)), (1.0, 1.0), &answer).unwrap();
        let (panels, shape) = restored(&problem, &panels).unwrap();
        let density = Density::new(problem.kernel, panels);
        let (settlement, tilt) = (answer.settlement, answer.tilt);
        work(&Audit {
            problem: &problem,
            profile: &base,
            answer: &answer,
            density,
            shape,
            settlement,
            tilt,
        });
    }

    #[test]
    fn windows_leave_nothing_out() {
        with_audit(|audit| {
            let [zones, gaps] = audit.covered(1 << 40).unwrap();
            assert!(gaps.is_empty());
            let mut from = -1.0;
            for window in zones {
                assert_eq!(window.left, from);
                from = window.right;
            }
            assert_eq!(from, 1.0);
        });
    }

    #[test]
    fn the_place_where_it_ends_early_is_the_same_each_time() {
        with_audit(|audit| {
            let looks = audit.covering(1 << 40).unwrap().looks;
            let mut before = -1.0;
            for share in [0.1, 0.4, 0.7, 0.95] {
                let refused = |_| audit.covered((share * looks as f64) as u64).unwrap_err();
                let all: Vec<Refusal> = (0..20).map(refused).collect();
                let Refusal::TooManyWindows { at } = all[0] else { panic!("{:?}", all[0]) };
                assert!(before < at && at <= 1.0, "{share}: {at}");
                assert!(all.iter().all(|one| *one == all[0]), "{all:?}");
                before = at;
            }
        });
    }
}
