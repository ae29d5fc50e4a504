//! The potential of one panel at places on it and beside it, all places at once.
//!
//! With `I_k(z) = int P_k(t) sigma(|z - t|) dt` on `[-1, 1]`, `sigma = ln` or the power `-mu`,
//!
//! `(2k+1) z I_k = (k+2-mu) I_(k+1) + (k-1+mu) I_(k-1)` for `k >= 2` (`mu = 0` for the logarithm),
//!
//! from `(z - t) P_k` and one integration by parts. The recurrence runs forward where all its solutions are of one size, and backward (J. C. P. Miller) where `I_k` is the one that falls.

use crate::allowance::UNIT;
use crate::chebyshev::MOST;
use crate::kernel::Singularity;
use crate::legendre::ORDER;
use crate::panel::Panel;
use crate::potentials::Potentials;

/// Up to this place beyond an end of the panel the recurrence runs forward: rounding grows there by 2 for each degree, and coefficients fall faster.
const FORWARD: f64 = 1.25;
/// Backward it starts so far up that what is neglected has fallen by `exp(-FALLEN)`: by `2 ln rho` a degree, `rho = |z| + sqrt(z^2 - 1)`, which is 2 for the nearest places.
const FALLEN: f64 = 38.0;
const LAST: usize = ORDER + 28;

/// Places that advance together, a divisor of [`MOST`].
const TOGETHER: usize = 8;

/// Roundings of the potential of a Legendre polynomial of degree `k >= 1` in units of the machine, `FIRST + STEP k` on the panel and `BESIDE` beyond: steps of the recurrence add five each,
/// which its solutions carry on without growth on `[-1, 1]`. Checked against 30 digits in the tests.
const FIRST: f64 = 10.0;
const STEP: f64 = 8.0;
const BESIDE: f64 = 40.0;

/// The sum of the coefficients' sizes, each with the roundings of its potential on the panel.
pub(crate) fn rounded(coefficients: &[f64; ORDER], growth: f64) -> f64 {
    let mut power = 1.0;
    let mut sum = 0.0;
    for (k, c) in coefficients.iter().enumerate().skip(1) {
        power *= growth;
        sum += c.abs() * (FIRST + STEP * k as f64) * power;
    }
    sum
}

/// Factors of the recurrence, which depend on the kernel alone.
#[derive(Debug, Clone)]
pub(crate) struct Recurrence {
    singularity: Singularity,
    /// `I_(k+1) = a z I_k - b I_(k-1)`
    forward: [[f64; 2]; ORDER],
    /// `I_(k-1) = a z I_k - b I_(k+1)`
    backward: [[f64; 2]; LAST + 1],
}

/// Places that are treated alike.
struct Batch {
    count: usize,
    index: [usize; MOST],
    z: [f64; MOST],
    /// `I_0` of the power.
    zeroth: [f64; MOST],
    first: [f64; MOST],
    /// The part of the constant, for the logarithm with its scale, and its roundings.
    plain: [f64; MOST],
    rounding: [f64; MOST],
    /// The largest and the least `|z|`.
    farthest: f64,
    nearest: f64,
}

impl Batch {
    /// None yet: what is left of others is overwritten.
    fn clear(&mut self) {
        self.count = 0;
        self.farthest = 0.0;
        self.nearest = f64::INFINITY;
    }
}

impl Default for Batch {
    fn default() -> Self {
        Self {
            count: 0,
            index: [0; MOST],
            z: [0.0; MOST],
            zeroth: [0.0; MOST],
            first: [0.0; MOST],
            plain: [0.0; MOST],
            rounding: [0.0; MOST],
            farthest: 0.0,
            nearest: f64::INFINITY,
        }
    }
}

/// Working memory of many panels.
#[derive(Default)]
pub(crate) struct Batches {
    on: Batch,
    beside: Batch,
}

impl Recurrence {
    pub(crate) fn new(singularity: Singularity) -> Self {
        let mu = singularity.exponent();
        let mut forward = [[0.0; 2]; ORDER];
        for (k, entry) in forward.iter_mut().enumerate().skip(1) {
            let n = k as f64;
            *entry = [(2.0 * n + 1.0) / (n + 2.0 - mu), (n - 1.0 + mu) / (n + 2.0 - mu)];
        }
        let mut backward = [[0.0; 2]; LAST + 1];
        for (k, entry) in backward.iter_mut().enumerate().skip(2) {
            let n = k as f64;
            *entry = [(2.0 * n + 1.0) / (n - 1.0 + mu), (n + 2.0 - mu) / (n - 1.0 + mu)];
        }
        Self { singularity, forward, backward }
    }

    /// Adds `sign int sigma(|x - t|) q(t) dt` of a panel at at most [`MOST`] places, each with its index and with what it is to the right of the left end and to the left of the right one.
    pub(crate) fn add(
        &self,
        panel: &Panel,
        places: impl Iterator<Item = (usize, [f64; 2])>,
        sign: f64,
        Batches { on, beside }: &mut Batches,
        into: &mut Potentials,
    ) {
        on.clear();
        beside.clear();
        for (index, [from_left, to_right]) in places {
            let z = 0.5 * (from_left - to_right) / panel.half();
            let batch = if z.abs() <= FORWARD { &mut *on } else { &mut *beside };
            self.begin(panel, (from_left, to_right, z), index, batch);
        }
        let c = &panel.coefficients;
        let mut sums = [0.0; MOST];
        if on.count > 0 {
            self.forward(c, on, &mut sums);
            let size = if on.farthest <= 1.0 {
                panel.rounded
            } else {
                rounded(c, on.farthest + (on.farthest * on.farthest - 1.0).sqrt())
            };
            self.finish(panel, size, sign, (on, &sums), into);
        }
        if beside.count > 0 {
            self.backward(c, beside, &mut sums);
            self.finish(panel, BESIDE * panel.swing, sign, (beside, &sums), into);
        }
    }

    /// What logarithms and powers are needed for: `I_0` and `I_1`.
    fn begin(
        &self,
        panel: &Panel,
        (from_left, to_right, z): (f64, f64, f64),
        index: usize,
        batch: &mut Batch,
    ) {
        let i = batch.count;
        batch.count += 1;
        batch.index[i] = index;
        batch.z[i] = z;
        batch.farthest = batch.farthest.max(z.abs());
        batch.nearest = batch.nearest.min(z.abs());
        let half = panel.half();
        let (left, right) = (from_left / half, to_right / half);
        match self.singularity {
            Singularity::Logarithm => {
                let [a, b] = [ln(from_left), ln(to_right)];
                let sum = from_left * a + to_right * b - 2.0 * half;
                batch.plain[i] = panel.coefficients[0] * sum;
                // Differences, logarithms of two units, products and sums.
                let size = from_left.abs() * (4.0 * a.abs() + 2.0)
                    + to_right.abs() * (4.0 * b.abs() + 2.0)
                    + 3.0 * sum.abs();
                batch.rounding[i] = panel.coefficients[0].abs() * size;
                // (z^2 - 1) Q_0 - z
                let quotient =
                    if left == 0.0 || right == 0.0 { 0.0 } else { 0.5 * ln(left / right) };
                batch.first[i] = -right * left * quotient - z;
            }
            Singularity::Power(mu) => {
                let signed = |d: f64| d.abs().powf(1.0 - mu).copysign(d);
                let [a, b] = [signed(left), signed(right)];
                let zeroth = (a + b) / (1.0 - mu);
                batch.zeroth[i] = zeroth;
                batch.first[i] = z * zeroth - (a * left - b * right) / (2.0 - mu);
                batch.plain[i] = panel.coefficients[0] * zeroth;
                batch.rounding[i] =
                    panel.coefficients[0].abs() * 8.0 * (a.abs() + b.abs()) / (1.0 - mu);
            }
        }
    }

    /// `sum c_k I_k` over `k >= 1`, forward.
    fn forward(&self, c: &[f64; ORDER], batch: &Batch, sums: &mut [f64; MOST]) {
        let is_log = matches!(self.singularity, Singularity::Logarithm);
        for from in (0..batch.count).step_by(TOGETHER) {
            let [z, mut before, mut here] =
                [&batch.z, &batch.zeroth, &batch.first].map(|all| some(all, from));
            let mut own = here.map(|first| c[1] * first);
            let mut k = 1;
            if is_log {
                // The recurrence begins at k = 2, from I_2 = z I_1 + 2/3.
                for i in 0..TOGETHER {
                    before[i] = here[i];
                    here[i] = z[i] * here[i] + 2.0 / 3.0;
                    own[i] += c[2] * here[i];
                }
                k = 2;
            }
            for k in k..ORDER - 1 {
                let [a, b] = self.forward[k];
                let next = c[k + 1];
                for i in 0..TOGETHER {
                    let value = a * z[i] * here[i] - b * before[i];
                    before[i] = here[i];
                    here[i] = value;
                    own[i] += next * value;
                }
            }
            sums[from..from + TOGETHER].copy_from_slice(&own);
        }
    }

    /// The same backward, from zero at a high degree to `I_1`, which gives the size.
    fn backward(&self, c: &[f64; ORDER], batch: &Batch, sums: &mut [f64; MOST]) {
        let rho = batch.nearest + (batch.nearest * batch.nearest - 1.0).sqrt();
        let beyond = (0.5 * FALLEN / rho.ln()).ceil() as usize;
        let start = LAST.min(ORDER + beyond);
        for from in (0..batch.count).step_by(TOGETHER) {
            let [z, first] = [&batch.z, &batch.first].map(|all| some(all, from));
            let (mut above, mut here, mut own) =
                ([0.0; TOGETHER], [1.0; TOGETHER], [0.0; TOGETHER]);
            for k in (2..=start).rev() {
                let [a, b] = self.backward[k];
                let factor = if k < ORDER { c[k] } else { 0.0 };
                for i in 0..TOGETHER {
                    own[i] += factor * here[i];
                    let value = a * z[i] * here[i] - b * above[i];
                    above[i] = here[i];
                    here[i] = value;
                }
            }
            for i in 0..TOGETHER {
                sums[from + i] = first[i] * (c[1] + own[i] / here[i]);
            }
        }
    }

    fn finish(
        &self,
        panel: &Panel,
        size: f64,
        sign: f64,
        (batch, sums): (&Batch, &[f64; MOST]),
        into: &mut Potentials,
    ) {
        let half = panel.half();
        let (scale, plain, loss) = match self.singularity {
            Singularity::Logarithm => (half, 1.0, 1.0),
            Singularity::Power(mu) => {
                let scale = half.powf(1.0 - mu);
                (scale, scale, 2.0 / (1.0 - mu))
            }
        };
        let parts = batch.plain.iter().zip(&batch.rounding);
        for ((index, sum), (own, rounding)) in
            batch.index[..batch.count].iter().zip(sums).zip(parts)
        {
            let value = scale * sum + plain * own;
            let rounding = scale * size * loss + plain * rounding + 2.0 * value.abs();
            into.add(*index, sign * value, UNIT * rounding);
        }
    }
}

/// The entries of a batch that advance together; behind the last of the batch there are others.
fn some(all: &[f64; MOST], from: usize) -> [f64; TOGETHER] {
    std::array::from_fn(|i| all[from + i])
}

/// `ln|d|`; 0 for 0, where it is multiplied by 0.
fn ln(d: f64) -> f64 {
    if d == 0.0 { 0.0 } else { d.abs().ln() }
}
