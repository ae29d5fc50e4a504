//! Nodes of a panel and the sums over them.

use std::f64::consts::PI;

use fredholm::special::pole_sums;

use super::complex::Complex;

/// Nodes that sums take side by side.
const LANES: usize = 4;
/// Strengths that fall slower from node to node are no series yet.
const MOST_QUOTIENT: f64 = 0.99;

/// Nodes measured from one end of their panel, so that their distances keep all digits there.
#[derive(Debug, Clone, Default)]
pub(super) struct Nodes {
    /// `s - end`.
    offsets: Vec<f64>,
    /// `h s' p`.
    strengths: Vec<f64>,
    /// `cos(k offset)` and `sin(k offset)` of a periodic pressure.
    turned: Option<[Vec<f64>; 2]>,
}

/// `sum c/a`, `sum c/a^2`, `sum c/a^3` with `a = z - s`; periodic: `k cot(ka)`, `k^2/sin^2(ka)`, their product.
pub(super) type Sums = [Complex; 3];

impl Nodes {
    pub(super) fn push(&mut self, offset: f64, strength: f64) {
        self.offsets.push(offset);
        self.strengths.push(strength);
    }

    /// All but the outermost one, which is [closed](Self::close), each with its strength.
    pub(super) fn inner(&self) -> impl Iterator<Item = (f64, f64)> {
        let all = self.offsets.iter().copied().zip(self.strengths.iter().copied());
        let last = self.strengths.iter().rposition(|strength| *strength != 0.0);
        all.take(last.unwrap_or(0))
    }

    pub(super) fn strengths(&self) -> &[f64] {
        &self.strengths
    }

    /// Adds to the outermost node what lies beyond it, a geometric series: what is left out is then of second order in its distance from the end.
    pub(super) fn close(&mut self) {
        if let [.., before, last] = self.strengths.as_mut_slice() {
            let quotient = *last / *before;
            if quotient > 0.0 && quotient < MOST_QUOTIENT {
                *last /= 1.0 - quotient;
            }
        }
    }

    /// Fills the last lanes with nodes of no strength, and prepares a period `L`, `k = pi/L`.
    pub(super) fn finish(&mut self, period: Option<f64>) {
        while !self.offsets.len().is_multiple_of(LANES) {
            let last = self.offsets[self.offsets.len() - 1];
            self.push(last, 0.0);
        }
        self.turned = period.map(|period| {
            let wave = PI / period;
            [f64::cos, f64::sin].map(|f| self.offsets.iter().map(|s| f(wave * s)).collect())
        });
    }

    /// The sums for `z - end = x + i y`, of a periodic pressure from the nearest repetition of the end: a sine keeps its digits at 0 and not at `pi`. The third only where `CUBES`.
    pub(super) fn sums<const CUBES: bool>(&self, x: f64, y: f64, period: Option<f64>) -> Sums {
        match (&self.turned, period) {
            (Some([cosines, sines]), Some(period)) => {
                self.periodic_sums::<CUBES>(cosines, sines, [x, y], PI / period)
            }
            _ => self.plain_sums::<CUBES>(x, y),
        }
    }

    fn plain_sums<const CUBES: bool>(&self, x: f64, y: f64) -> Sums {
        let total = pole_sums::<CUBES>(&self.offsets, &self.strengths, [x, y]);
        [0, 2, 4].map(|i| Complex::new(total[i], total[i + 1]))
    }

    fn periodic_sums<const CUBES: bool>(
        &self,
        cosines: &[f64],
        sines: &[f64],
        [x, y]: [f64; 2],
        wave: f64,
    ) -> Sums {
        // sin and cos of k(x + iy) over e^(ky)/2, whose quotient alone is needed: no overflow at any depth.
        let decay = (-2.0 * wave * y).exp();
        // 1 - e^(-2ky) keeps its digits close to the surface.
        let (sum, difference) = (1.0 + decay, -(-2.0 * wave * y).exp_m1());
        let (sine, cosine) = (wave * x).sin_cos();
        let sine_z = Complex::new(sine * sum, cosine * difference);
        let cosine_z = Complex::new(cosine * sum, -sine * difference);
        let mut sums = [Complex::ZERO; 3];
        for ((&strength, &cosine), &sine) in self.strengths.iter().zip(cosines).zip(sines) {
            let below = sine_z.scaled(cosine) - cosine_z.scaled(sine);
            let above = cosine_z.scaled(cosine) + sine_z.scaled(sine);
            let inverse = below.inverse();
            let cotangent = (above * inverse).scaled(wave);
            let square = (inverse * inverse).scaled(4.0 * decay * wave * wave);
            sums[0] = sums[0] + cotangent.scaled(strength);
            sums[1] = sums[1] + square.scaled(strength);
            if CUBES {
                sums[2] = sums[2] + (cotangent * square).scaled(strength);
            }
        }
        sums
    }
}

/// Both sums of each power, those of even and odd nodes, added and subtracted.
pub(super) fn combined(even: &Sums, odd: &Sums) -> (Sums, Sums) {
    ([0, 1, 2].map(|i| even[i] + odd[i]), [0, 1, 2].map(|i| even[i] - odd[i]))
}
