//! The potential of one panel at places on it and beside it, all places at once.
//!
//! With `I_k(z) = int P_k(t) sigma(|z - t|) dt` on `[-1, 1]`, `sigma = ln` or the power `-mu`,
//!
//! `(2k+1) z I_k = (k+2-mu) I_(k+1) + (k-1+mu) I_(k-1)` for `k >= 2` (`mu = 0` for the logarithm),
//!
//! from `(z - t) P_k` and one integration by parts. The recurrence runs forward where all its solutions are of one size, and backward (J. C. P. Miller) where `I_k` is the one that falls.

use crate::elementary::{exp, ln};
use crate::kernel::Singularity;
use crate::legendre::ORDER;
use crate::panel::Panel;

/// Up to this place beyond an end of the panel the recurrence runs forward: rounding grows there by 2 for each degree, and coefficients fall faster.
const FORWARD: f64 = 1.25;
/// Backward it starts so far up that what is neglected has fallen by `exp(-FALLEN)`: by `2 ln rho` a degree, `rho = |z| + sqrt(z^2 - 1)`, which is 2 for the nearest places.
const FALLEN: f64 = 38.0;
const LAST: usize = ORDER + 28;

/// Roundings of the potential of a Legendre polynomial of degree `k >= 1` in units of the machine, `FIRST + STEP k` on the panel and `BESIDE` beyond: steps of the recurrence add five each,
/// which its solutions carry on without growth on `[-1, 1]`. Checked against 30 digits in the tests.
const FIRST: f64 = 10.0;
const STEP: f64 = 8.0;
const BESIDE: f64 = 40.0;

/// Of the constant in units of the machine for each of its two logarithms, and beside them: differences 1, logarithms 2, products and sums 1 each; of powers the same.
const CONSTANT: [f64; 2] = [4.0, 3.0];
const POWER: f64 = 14.0;

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

/// How far places are to the right of the left end of a panel, and to the left of its right one.
pub(crate) struct Distances<const N: usize> {
    pub(crate) from_left: [f64; N],
    pub(crate) to_right: [f64; N],
}

/// Places as a panel has them, and the potential there of what is constant on it.
struct Begun<const N: usize> {
    z: [f64; N],
    /// `I_0` of the power, and `I_1`.
    zeroth: [f64; N],
    first: [f64; N],
    /// The part of the constant, and its roundings.
    plain: [f64; N],
    rounding: [f64; N],
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

    /// `ln h` or `h^(1-mu)` of a half-length.
    pub(crate) fn scale(&self, half: f64) -> f64 {
        match self.singularity {
            Singularity::Logarithm => half.ln(),
            Singularity::Power(mu) => half.powf(1.0 - mu),
        }
    }

    /// `int sigma(|x - t|) q(t) dt` of a panel, and its roundings in units of the machine, at places that are at most a few of its lengths away; `scale` is [`Recurrence::scale`].
    #[inline(always)]
    pub(crate) fn potentials<const N: usize>(
        &self,
        panel: &Panel,
        scale: f64,
        places: &Distances<N>,
    ) -> [[f64; N]; 2] {
        let begun = self.begun(panel, scale, places);
        let (mut farthest_on, mut nearest_beside, mut is_any_beside) =
            (0.0f64, f64::INFINITY, false);
        let mut is_any_on = false;
        let (mut on, mut beside) = (begun.z, begun.z);
        for i in 0..N {
            let size = begun.z[i].abs();
            if size <= FORWARD {
                is_any_on = true;
                farthest_on = farthest_on.max(size);
                beside[i] = 2.0;
            } else {
                is_any_beside = true;
                nearest_beside = nearest_beside.min(size);
                on[i] = 0.0;
            }
        }
        let c = &panel.coefficients;
        let (mut sums, mut size) = ([0.0; N], [BESIDE * panel.swing; N]);
        if is_any_beside {
            sums = self.backward(c, &beside, &begun.first, nearest_beside);
        }
        if is_any_on {
            let own = self.forward(c, &on, &begun);
            let rounded = if farthest_on <= 1.0 {
                panel.rounded
            } else {
                rounded(c, farthest_on + (farthest_on * farthest_on - 1.0).sqrt())
            };
            for i in 0..N {
                if begun.z[i].abs() <= FORWARD {
                    sums[i] = own[i];
                    size[i] = rounded;
                }
            }
        }
        self.finished(panel, scale, &begun, [&sums, &size])
    }

    /// What logarithms and powers are needed for: `I_0` and `I_1`.
    #[inline(always)]
    fn begun<const N: usize>(&self, panel: &Panel, scale: f64, places: &Distances<N>) -> Begun<N> {
        let half = panel.half();
        let [mut left, mut right, mut z] = [[0.0; N]; 3];
        for i in 0..N {
            let (from_left, to_right) = (places.from_left[i], places.to_right[i]);
            z[i] = 0.5 * (from_left - to_right) / half;
            left[i] = from_left / half;
            right[i] = to_right / half;
        }
        let logarithms = [ln(&left), ln(&right)];
        let mut begun =
            Begun { z, zeroth: [0.0; N], first: [0.0; N], plain: [0.0; N], rounding: [0.0; N] };
        let constant = panel.coefficients[0];
        match self.singularity {
            Singularity::Logarithm => {
                for i in 0..N {
                    // Of 0, which is multiplied by it, some finite number.
                    let [a, b] = [logarithms[0][i], logarithms[1][i]];
                    let sum = left[i] * a + right[i] * b + (2.0 * scale - 2.0);
                    begun.plain[i] = half * (constant * sum);
                    let [each, rest] = CONSTANT;
                    let size = left[i].abs() * (each * a.abs() + rest)
                        + right[i].abs() * (each * b.abs() + rest)
                        + 6.0 * scale.abs()
                        + 3.0 * sum.abs();
                    begun.rounding[i] = half * (constant.abs() * size);
                    // (z^2 - 1) Q_0 - z
                    begun.first[i] = -right[i] * left[i] * (0.5 * (a - b)) - z[i];
                }
            }
            Singularity::Power(mu) => {
                let [mut one, mut two] = logarithms;
                for i in 0..N {
                    one[i] *= 1.0 - mu;
                    two[i] *= 1.0 - mu;
                }
                let powers = [exp(&one), exp(&two)];
                for i in 0..N {
                    let signed =
                        |d: f64, power: f64| if d == 0.0 { 0.0 } else { power.copysign(d) };
                    let [a, b] = [signed(left[i], powers[0][i]), signed(right[i], powers[1][i])];
                    let zeroth = (a + b) / (1.0 - mu);
                    begun.zeroth[i] = zeroth;
                    begun.first[i] = z[i] * zeroth - (a * left[i] - b * right[i]) / (2.0 - mu);
                    begun.plain[i] = scale * (constant * zeroth);
                    begun.rounding[i] =
                        scale * (constant.abs() * POWER * (a.abs() + b.abs()) / (1.0 - mu));
                }
            }
        }
        begun
    }

    /// `sum c_k I_k` over `k >= 1`, forward.
    #[inline(always)]
    fn forward<const N: usize>(
        &self,
        c: &[f64; ORDER],
        z: &[f64; N],
        begun: &Begun<N>,
    ) -> [f64; N] {
        // The recurrence of the logarithm begins at k = 2, from I_2 = z I_1 + 2/3; that of powers at k = 1.
        let (is_log, [a, b]) =
            (matches!(self.singularity, Singularity::Logarithm), self.forward[1]);
        let (mut before, mut here, mut own) = (begun.first, [0.0; N], [0.0; N]);
        for i in 0..N {
            let (z, zeroth, first) = (z[i], begun.zeroth[i], begun.first[i]);
            here[i] = if is_log { z * first + 2.0 / 3.0 } else { a * z * first - b * zeroth };
            own[i] = c[1] * first + c[2] * here[i];
        }
        for k in 2..ORDER - 1 {
            let [a, b] = self.forward[k];
            let next = c[k + 1];
            for i in 0..N {
                let value = a * z[i] * here[i] - b * before[i];
                before[i] = here[i];
                here[i] = value;
                own[i] += next * value;
            }
        }
        own
    }

    /// The same backward, from zero at a high degree to `I_1`, which gives the size.
    #[inline(always)]
    fn backward<const N: usize>(
        &self,
        c: &[f64; ORDER],
        z: &[f64; N],
        first: &[f64; N],
        nearest: f64,
    ) -> [f64; N] {
        let rho = nearest + (nearest * nearest - 1.0).sqrt();
        let beyond = (0.5 * FALLEN / rho.ln()).ceil() as usize;
        let start = LAST.min(ORDER + beyond);
        let (mut above, mut here, mut own) = ([0.0; N], [1.0; N], [0.0; N]);
        for k in (ORDER..=start).rev() {
            let [a, b] = self.backward[k];
            for i in 0..N {
                let value = a * z[i] * here[i] - b * above[i];
                above[i] = here[i];
                here[i] = value;
            }
        }
        for k in (2..ORDER).rev() {
            let [a, b] = self.backward[k];
            for i in 0..N {
                own[i] += c[k] * here[i];
                let value = a * z[i] * here[i] - b * above[i];
                above[i] = here[i];
                here[i] = value;
            }
        }
        for i in 0..N {
            own[i] = first[i] * (c[1] + own[i] / here[i]);
        }
        own
    }

    #[inline(always)]
    fn finished<const N: usize>(
        &self,
        panel: &Panel,
        scale: f64,
        begun: &Begun<N>,
        [sums, sizes]: [&[f64; N]; 2],
    ) -> [[f64; N]; 2] {
        let (scale, loss) = match self.singularity {
            Singularity::Logarithm => (panel.half(), 1.0),
            Singularity::Power(mu) => (scale, 2.0 / (1.0 - mu)),
        };
        let [mut values, mut roundings] = [[0.0; N]; 2];
        for i in 0..N {
            let value = scale * sums[i] + begun.plain[i];
            values[i] = value;
            roundings[i] = scale * sizes[i] * loss + begun.rounding[i] + 2.0 * value.abs();
        }
        [values, roundings]
    }
}
