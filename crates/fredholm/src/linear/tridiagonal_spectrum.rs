//! The lowest eigenvalues of symmetric tridiagonal matrices and their eigenvectors.

use std::ops::Range;

use super::vectorised::vectorised;

/// Eigenvalues sought at once: their divisions do not wait for each other, with three of the widest vectors.
const LANES: usize = 24;
/// Eigenvectors found at once.
pub(crate) const VECTORS: usize = 8;
/// Newton's method has ended where a step is longer than this share of the one before: it converges quadratically, and from afar takes steps that fall.
const SLOWEST: f64 = 0.9;
/// The distance from its limit at which the interval is then ended, over the last step or rounding, and by what that grows where the eigenvalue is not inside.
const WIDER: f64 = 4.0;

/// A symmetric tridiagonal matrix with the diagonal `a_i` and `b_i` beside it.
#[derive(Debug, Clone)]
pub(crate) struct SymmetricTridiagonal {
    diagonal: Vec<f64>,
    /// `b_i = T_{i,i+1}`; one less than the diagonal has entries.
    beside: Vec<f64>,
}

impl SymmetricTridiagonal {
    pub(crate) fn new(diagonal: Vec<f64>, beside: Vec<f64>) -> Self {
        Self { diagonal, beside }
    }

    pub(crate) fn order(&self) -> usize {
        self.diagonal.len()
    }

    /// The matrix of the first rows and columns.
    pub(crate) fn truncated(mut self, order: usize) -> Self {
        self.diagonal.truncate(order);
        self.beside.truncate(order.saturating_sub(1));
        self
    }

    /// The eigenvalues with the indices of a range, ascending, by the number of negative pivots (W. Barth, R. S. Martin, J. H. Wilkinson, Numer. Math. 9 (1967) 386): the
    /// error is a few units in the last place of the entries that matter for the eigenvalue, small ones of a graded matrix included.
    ///
    /// By bisection until an interval holds one eigenvalue, by Newton's method from there as long as it stays inside, and by bisection of what is left around its limit: the result is that of
    /// bisection alone, in half the steps.
    pub(crate) fn eigenvalues(&self, indices: Range<usize>) -> Vec<f64> {
        let [low, high] = self.bounds();
        let mut known = vec![(low, 0), (high, self.order())];
        let end = indices.end.min(self.order());
        let mut values = vec![high; end.saturating_sub(indices.start)];
        let mut waiting = indices.start..end;
        let mut searches: Vec<Search> = Vec::with_capacity(LANES);
        loop {
            searches.retain(|search| {
                if search.next().is_none() {
                    values[search.index - indices.start] = search.high;
                }
                search.next().is_some()
            });
            let free = LANES - searches.len();
            searches.extend(waiting.by_ref().take(free).map(|index| Search::new(index, &known)));
            let Some(first) = searches.first() else { return values };
            let mut shifts = [first.high; LANES];
            for (shift, search) in shifts.iter_mut().zip(&searches) {
                *shift = search.next().unwrap_or(search.high);
            }
            let found = vectorised(
                #[inline(always)]
                || self.probe(shifts),
            );
            for (search, probe) in searches.iter_mut().zip(found) {
                search.learn(probe);
                known.push((probe.shift, probe.below));
            }
            // What lies above the next, and the highest below it, serve them.
            let is_below = |(_, below): &(f64, usize)| *below <= waiting.start;
            let highest = known.iter().filter(|one| is_below(one)).map(|(shift, _)| *shift);
            let highest = highest.fold(f64::NEG_INFINITY, f64::max);
            known.retain(|one| !is_below(one) || one.0 == highest);
        }
    }

    /// An interval with all eigenvalues inside (Gershgorin).
    fn bounds(&self) -> [f64; 2] {
        let coupling = |i: usize| self.beside.get(i).copied().unwrap_or(0.0).abs();
        let mut bounds = [f64::INFINITY, f64::NEG_INFINITY];
        for (i, entry) in self.diagonal.iter().enumerate() {
            let radius = coupling(i) + if i > 0 { coupling(i - 1) } else { 0.0 };
            bounds = [bounds[0].min(entry - radius), bounds[1].max(entry + radius)];
        }
        let room = 4.0 * f64::EPSILON;
        [bounds[0] - room * bounds[0].abs(), bounds[1] + room * bounds[1].abs()]
    }

    /// How many eigenvalues lie below each shift, and Newton's step from there to a zero of the determinant.
    #[inline(always)]
    fn probe(&self, shifts: [f64; LANES]) -> [Probe; LANES] {
        let mut inverses = [1.0f64; LANES];
        let mut slopes = [0.0f64; LANES];
        let mut logarithmic = [0.0f64; LANES];
        let mut counts = [0.0f64; LANES];
        let mut coupling = 0.0;
        for (i, entry) in self.diagonal.iter().enumerate() {
            for lane in 0..LANES {
                let shifted = coupling * inverses[lane];
                let pivot = (entry - shifts[lane]) - shifted;
                let pivot = if pivot.abs() < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { pivot };
                // The derivative of the logarithm of the determinant by the shift is the sum of those of the pivots.
                slopes[lane] = shifted * slopes[lane] - 1.0;
                inverses[lane] = 1.0 / pivot;
                slopes[lane] *= inverses[lane];
                logarithmic[lane] += slopes[lane];
                counts[lane] += if pivot < 0.0 { 1.0 } else { 0.0 };
            }
            let beside = self.beside.get(i).copied().unwrap_or(0.0);
            coupling = beside * beside;
        }
        std::array::from_fn(|lane| Probe {
            shift: shifts[lane],
            below: counts[lane] as usize,
            step: -1.0 / logarithmic[lane],
        })
    }

    /// The eigenvectors of unit length of the matrix of the first `order` rows and columns that belong to eigenvalues apart from the others, at most [`VECTORS`] of them, each in a list of its own: from both
    /// ends to the row where elimination downwards and upwards meet with the smallest rest (K. V. Fernando, SIAM J. Matrix Anal. Appl. 18 (1997) 1013), so that small components are as accurate as
    /// large ones. What a list has beyond the order stays.
    pub(crate) fn eigenvectors<'v>(
        &self,
        values: &[f64],
        order: usize,
        vectors: impl Iterator<Item = &'v mut [f64]>,
    ) {
        let Some(&last) = values.last() else { return };
        let order = order.min(self.order());
        let mut lanes = [last; VECTORS];
        lanes.iter_mut().zip(values).for_each(|(lane, value)| *lane = *value);
        let pivots = vectorised(
            #[inline(always)]
            || self.pivots(lanes, order),
        );
        for (lane, vector) in vectors.take(values.len()).enumerate() {
            let vector = &mut vector[..order];
            let meeting = pivots.meeting[lane] as usize;
            vector[meeting] = 1.0;
            let mut square = 1.0;
            let mut next = 1.0;
            for i in (0..meeting).rev() {
                next *= -self.beside[i] * pivots.down[i][lane];
                vector[i] = next;
                square += next * next;
            }
            next = 1.0;
            let beyond = vector.iter_mut().zip(&pivots.up).skip(meeting + 1);
            for ((entry, up), beside) in beyond.zip(&self.beside[meeting..]) {
                next *= -beside * up[lane];
                *entry = next;
                square += next * next;
            }
            let scale = 1.0 / f64::sqrt(square);
            vector.iter_mut().for_each(|entry| *entry *= scale);
        }
    }

    /// Inverse pivots of some shifted matrices at once.
    #[inline(always)]
    fn pivots(&self, shifts: [f64; VECTORS], order: usize) -> Pivots {
        let mut down = Vec::with_capacity(order);
        let mut coupled = [0.0; VECTORS];
        for (i, entry) in self.diagonal[..order].iter().enumerate() {
            let beside = self.beside.get(i).copied().unwrap_or(0.0);
            let coupling = beside * beside;
            let mut inverses = [0.0; VECTORS];
            for lane in 0..VECTORS {
                let pivot = (entry - shifts[lane]) - coupled[lane];
                let pivot = if pivot.abs() < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { pivot };
                inverses[lane] = 1.0 / pivot;
                coupled[lane] = coupling * inverses[lane];
            }
            down.push(inverses);
        }
        let mut up = vec![[0.0; VECTORS]; order];
        let (mut least, mut meeting) = ([f64::INFINITY; VECTORS], [0.0; VECTORS]);
        coupled = [0.0; VECTORS];
        for i in (0..order).rev() {
            let entry = self.diagonal[i];
            let beside = if i > 0 { self.beside[i - 1] } else { 0.0 };
            let coupling = beside * beside;
            let before = if i > 0 { down[i - 1] } else { [0.0; VECTORS] };
            for lane in 0..VECTORS {
                let pivot = (entry - shifts[lane]) - coupled[lane];
                let pivot = if pivot.abs() < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { pivot };
                // Both pivots less the entry.
                let rest = (pivot - coupling * before[lane]).abs();
                let is_less = rest < least[lane];
                least[lane] = if is_less { rest } else { least[lane] };
                meeting[lane] = if is_less { i as f64 } else { meeting[lane] };
                up[i][lane] = 1.0 / pivot;
                coupled[lane] = coupling * up[i][lane];
            }
        }
        Pivots { down, up, meeting }
    }
}

/// Inverse pivots of elimination downwards and upwards, and the rows where the two meet best, for some matrices.
struct Pivots {
    down: Vec<[f64; VECTORS]>,
    up: Vec<[f64; VECTORS]>,
    meeting: [f64; VECTORS],
}

/// What is known at a shift.
#[derive(Debug, Clone, Copy)]
struct Probe {
    shift: f64,
    /// How many eigenvalues lie below.
    below: usize,
    /// Newton's step from there.
    step: f64,
}

/// The search for one eigenvalue, which lies below `high` and not below `low`.
struct Search {
    index: usize,
    low: f64,
    high: f64,
    /// Whether no other lies below `high`, and none below `low`.
    is_alone: [bool; 2],
    stage: Stage,
}

/// What is done next.
#[derive(Debug, Clone, Copy)]
enum Stage {
    /// The interval is halved, for the first time or after Newton's method has ended.
    Halve { is_first: bool },
    /// Newton's method at this place, to which a step of this length leads.
    Newton { place: f64, step: f64 },
    /// A place so far beside the limit of Newton's method, on either side of it.
    Enclose { place: f64, distance: f64 },
}

impl Search {
    fn new(index: usize, known: &[(f64, usize)]) -> Self {
        let (mut low, mut high) = ((f64::NEG_INFINITY, 0), (f64::INFINITY, usize::MAX));
        for &(shift, below) in known {
            if below > index && shift < high.0 {
                high = (shift, below);
            } else if below <= index && shift > low.0 {
                low = (shift, below);
            }
        }
        let is_alone = [low.1 == index, high.1 == index + 1];
        let stage = Stage::Halve { is_first: true };
        Self { index, low: low.0, high: high.0, is_alone, stage }
    }

    /// The shift to try next; none where no number is left between the ends.
    fn next(&self) -> Option<f64> {
        let middle = 0.5 * self.low + 0.5 * self.high;
        let is_inside = |x: f64| self.low < x && x < self.high;
        let shift = match self.stage {
            Stage::Halve { .. } => middle,
            Stage::Newton { place, .. } => place,
            // On the side of the end that is farther off.
            Stage::Enclose { place, distance } if place - self.low > self.high - place => {
                place - distance
            }
            Stage::Enclose { place, distance } => place + distance,
        };
        is_inside(middle).then_some(if is_inside(shift) { shift } else { middle })
    }

    fn learn(&mut self, probe: Probe) {
        let Probe { shift, below, step } = probe;
        if below > self.index {
            self.is_alone[1] = below == self.index + 1;
            self.high = shift;
        } else {
            self.is_alone[0] = below == self.index;
            self.low = shift;
        }
        let rounding = f64::EPSILON * shift.abs();
        let place = shift + step;
        let is_inside = self.low < place && place < self.high;
        self.stage = match self.stage {
            Stage::Halve { is_first: true } if self.is_alone == [true; 2] && is_inside => {
                Stage::Newton { place, step }
            }
            Stage::Newton { step: before, .. } if is_inside => {
                // Beyond its limit it goes on by rounding.
                if step.abs() > SLOWEST * before.abs() || step.abs() <= rounding {
                    Stage::Enclose { place, distance: WIDER * step.abs().max(rounding) }
                } else {
                    Stage::Newton { place, step }
                }
            }
            Stage::Enclose { place, distance }
                if (place - self.low).max(self.high - place) > WIDER * distance =>
            {
                Stage::Enclose { place, distance: WIDER * distance }
            }
            Stage::Halve { is_first } => Stage::Halve { is_first },
            Stage::Newton { .. } | Stage::Enclose { .. } => Stage::Halve { is_first: false },
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn eigenvector(matrix: &SymmetricTridiagonal, value: f64) -> Vec<f64> {
        let mut vector = vec![f64::NAN; matrix.order()];
        matrix.eigenvectors(&[value], matrix.order(), std::iter::once(&mut vector[..]));
        vector
    }

    #[test]
    fn second_differences() {
        // Eigenvalues 4 sin^2(pi (k+1)/(2 (n+1))), eigenvectors sin(pi (k+1)(i+1)/(n+1)).
        for order in [1usize, 2, 5, 40] {
            let matrix = SymmetricTridiagonal::new(vec![2.0; order], vec![-1.0; order - 1]);
            let values = matrix.eigenvalues(0..order + 3);
            assert_eq!(values.len(), order);
            for (k, value) in values.iter().enumerate() {
                let angle = std::f64::consts::PI * (k as f64 + 1.0) / (order as f64 + 1.0);
                let exact = 4.0 * (0.5 * angle).sin().powi(2);
                assert!((value - exact).abs() < 4e-15, "{order} {k}: {value} {exact}");
                let vector = eigenvector(&matrix, *value);
                let scale = vector[0] / angle.sin();
                for (i, entry) in vector.iter().enumerate() {
                    assert!((entry - scale * ((i as f64 + 1.0) * angle).sin()).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn small_eigenvalues_of_graded_matrices_keep_their_digits() {
        // det = 1e-16 (1 - 1e-20) and the trace 1 + 1e-16.
        let matrix = SymmetricTridiagonal::new(vec![1e-16, 1.0], vec![1e-18]);
        let values = matrix.eigenvalues(0..2);
        assert!((values[0] / 1e-16 - 1.0).abs() < 1e-15 && (values[1] - 1.0).abs() < 1e-15);
        let vector = eigenvector(&matrix, values[0]);
        assert!((vector[1] / vector[0] / -1e-18 - 1.0).abs() < 1e-14);
        // Nothing beside the diagonal.
        let matrix = SymmetricTridiagonal::new(vec![0.0, 3.0, 7.0], vec![0.0; 2]);
        for (value, exact) in matrix.eigenvalues(0..3).iter().zip([0.0, 3.0, 7.0]) {
            assert!((value - exact).abs() <= 2e-16 * exact + 1e-300, "{value} {exact}");
        }
        assert_eq!(eigenvector(&matrix, 3.0), [0.0, 1.0, 0.0]);
    }
}
