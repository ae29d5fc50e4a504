//! The Macdonald kernel as a function of the distance, tabulated.

use std::f64::consts::PI;

use crate::Error;
use crate::kernel::{Pair, Singularity, Split};
use crate::special::{LARGEST_MACDONALD, SmallArgument, macdonald_scaled, polynomial, sigma};

/// Coefficients of `e^z z^-mu K_mu(z)` on half an octave: its singularity at 0 is 5 half-widths off or more, so that they fall by 9.9 each.
const FAR: usize = 17;
/// Coefficients of the factor on a piece of length 1.
const NEAR: usize = 16;
/// Sharpness of the cutoff: what the factor loses at the origin is `erfc` of it, 2e-13, divided by 2.
const SHARPNESS: f64 = 5.2;
/// Where the cutoff has fallen to one half, in decay lengths. Nodes must be closer than `15/(1.74 5.2 2)`, about 0.8 decay lengths, in the middle of
/// the interval for 12 digits. The factor rises to 1e6, of which only the share `1/j^2` at `j` nodes from the diagonal counts. Measured at
/// `kappa a = 40` with 497 nodes: an error of 6e-10 with 14 and 5.5, 9e-12 with 15 and 5.2, 5e-13 with 18 and 5.5, which however never falls below 5e-13.
const CUTOFF: f64 = 15.0;
/// Up to this length of the interval, in decay lengths, the factor needs no cutoff.
const SHORT: f64 = 12.0;
/// End of the factor with a cutoff over its place.
const ENDS: f64 = 2.8;
/// End of the factor with a cutoff: there it is 1e-17.
const END: f64 = 42.0;

/// `K(d) = d^-mu K_mu(kappa d)` and the factor `A(d)` of `sigma(d) = (d^-2mu - 1)/(2 mu)`, for `0 <= d` up to a largest distance.
///
/// In `z = kappa d`: below 1 by the power series, from there on `e^-z` times a polynomial on every half octave. The factor `A`, which grows as `I_-mu(z) z^mu`, is
/// multiplied by `erfc(5.2 (z/15 - 1))/2` where the interval is longer than 12 decay lengths, and given by a polynomial on every unit of `z`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MacdonaldProfile {
    order: f64,
    decay: f64,
    /// `kappa^mu`.
    value_scale: f64,
    /// `kappa^-mu`.
    factor_scale: f64,
    series: SmallArgument,
    far: Vec<[f64; FAR]>,
    factors: Vec<[f64; NEAR]>,
}

impl MacdonaldProfile {
    /// For `kappa d` up to `largest`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] unless `|order| < 1/2`, `decay` is finite and positive and `largest` is positive.
    pub(crate) fn new(order: f64, decay: f64, largest: f64) -> Result<Self, Error> {
        let invalid =
            |name, value, requirement| Error::InvalidParameter { name, value, requirement };
        if order.is_nan() || order.abs() >= 0.5 {
            let requirement = "between -1/2 and 1/2, both excluded: the symbol of the kernel falls with the frequency and the weight can \
                               be integrated only there";
            return Err(invalid("order", order, requirement));
        }
        if !(decay > 0.0 && decay.is_finite()) {
            let requirement = "finite and positive: the kernel decays as exp(-decay |x - s|)";
            return Err(invalid("decay", decay, requirement));
        }
        if largest.is_nan() || largest <= 0.0 {
            return Err(invalid("largest distance times decay", largest, "positive"));
        }
        let series = SmallArgument::new(order);
        let short = largest <= SHORT;
        // Rounding may carry the largest distance across a boundary of pieces.
        let largest = largest * (1.0 + 1e-9);
        let end = largest.min(LARGEST_MACDONALD);
        let far = (0..)
            .map(half_octave)
            .take_while(|ends| ends[0] <= end)
            .map(|ends| fit(ends, |z| macdonald_scaled(order, z)))
            .collect();
        let factor = |z: f64| series.factor_anywhere(z) * if short { 1.0 } else { cutoff(z) };
        let pieces = largest.min(END).floor() as u32 + 1;
        let factors =
            (0..pieces).map(|k| fit([f64::from(k), f64::from(k) + 1.0], factor)).collect();
        let (value_scale, factor_scale) = (decay.powf(order), decay.powf(-order));
        Ok(Self { order, decay, value_scale, factor_scale, series, far, factors })
    }

    /// The same with the factor multiplied by `erfc(sharpness (z/place - 1))/2` instead, for nodes that are closer.
    pub(crate) fn with_cutoff(self, place: f64, sharpness: f64) -> Self {
        let cutoff = |z: f64| 0.5 * libm::erfc(sharpness * (z / place - 1.0));
        let factor = |z: f64| self.series.factor_anywhere(z) * cutoff(z);
        let pieces = (ENDS * place).ceil() as u32;
        let factors =
            (0..pieces).map(|k| fit([f64::from(k), f64::from(k) + 1.0], factor)).collect();
        Self { factors, ..self }
    }

    pub(crate) fn order(&self) -> f64 {
        self.order
    }

    pub(crate) fn decay(&self) -> f64 {
        self.decay
    }

    pub(crate) fn singularity(&self) -> Singularity {
        Singularity::Power { exponent: 2.0 * self.order }
    }

    /// `K(d)` and `A(d)`.
    #[inline]
    pub(crate) fn pair(&self, distance: f64) -> Pair {
        let z = self.decay * distance;
        Pair { value: self.value_scale * self.value(z), factor: self.factor(z) }
    }

    /// `A(d)` and `B(d) = K(d) - A(d) sigma(d)`, with their limits at `d = 0`.
    pub(crate) fn split(&self, distance: f64) -> Split {
        if distance == 0.0 {
            return Split {
                factor: self.factor_scale * self.series.factor[0],
                rest: self.series.rest_at_origin(self.decay),
            };
        }
        let Pair { value, factor } = self.pair(distance);
        Split { factor, rest: value - factor * sigma(2.0 * self.order, distance) }
    }

    /// `z^-mu K_mu(z)`.
    #[inline]
    fn value(&self, z: f64) -> f64 {
        if z < 1.0 {
            return self.series.value(z);
        }
        let (index, local) = place(z);
        match self.far.get(index) {
            Some(piece) => (-z).exp() * polynomial(piece, local),
            None if z.is_nan() => f64::NAN,
            None => 0.0,
        }
    }

    #[inline]
    fn factor(&self, z: f64) -> f64 {
        let index = z as usize;
        let local = 2.0 * (z - index as f64) - 1.0;
        self.factors.get(index).map_or(0.0, |piece| self.factor_scale * polynomial(piece, local))
    }
}

fn cutoff(z: f64) -> f64 {
    0.5 * libm::erfc(SHARPNESS * (z / CUTOFF - 1.0))
}

/// `[1, 3/2], [3/2, 2], [2, 3], [3, 4], [4, 6], ...`.
fn half_octave(index: i32) -> [f64; 2] {
    let low = 2f64.powi(index / 2);
    if index % 2 == 0 { [low, 1.5 * low] } else { [1.5 * low, 2.0 * low] }
}

/// Index of the half octave of `z >= 1` and the place in it, from -1 to 1: both from the bits of `z`.
#[inline]
fn place(z: f64) -> (usize, f64) {
    const FRACTION: u32 = 52;
    let bits = z.to_bits();
    let index = (bits >> (FRACTION - 1)) as usize - (1023 << 1);
    let mantissa = f64::from_bits((bits & ((1 << FRACTION) - 1)) | (1023 << FRACTION));
    let middle = if index.is_multiple_of(2) { 1.25 } else { 1.75 };
    (index, 4.0 * (mantissa - middle))
}

/// The polynomial through the values of `f` at the Chebyshev points of an interval, by its powers of the variable carried to `[-1, 1]`.
fn fit<const N: usize>(ends: [f64; 2], f: impl Fn(f64) -> f64) -> [f64; N] {
    let angle = |j: usize| PI * (j as f64 + 0.5) / N as f64;
    let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
    let values: [f64; N] = std::array::from_fn(|j| f(middle + half * angle(j).cos()));
    // Powers of T_0, T_1, ... as the three-term recurrence makes them.
    let (mut before, mut current) = ([0.0; N], [0.0; N]);
    current[0] = 1.0;
    let mut powers = [0.0; N];
    for k in 0..N {
        let sum: f64 =
            values.iter().enumerate().map(|(j, v)| v * (k as f64 * angle(j)).cos()).sum();
        let coefficient = sum * if k == 0 { 1.0 } else { 2.0 } / N as f64;
        powers.iter_mut().zip(&current).for_each(|(power, t)| *power += coefficient * t);
        let double = if k == 0 { 1.0 } else { 2.0 };
        let next = std::array::from_fn(|i| {
            let raised = if i > 0 { double * current[i - 1] } else { 0.0 };
            raised - before[i]
        });
        before = current;
        current = next;
    }
    powers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::special::macdonald;

    #[test]
    fn the_table_is_the_function() {
        for (order, decay, largest) in [
            (0.0, 1.0, 2.0),
            (0.3, 40.0, 80.0),
            (-0.45, 0.01, 0.02),
            (1e-9, 1.0, 1e3),
            (0.49, 3.0, 8.0),
        ] {
            let profile = MacdonaldProfile::new(order, decay, largest).unwrap();
            for i in 0..=4000 {
                // Both ends and, at every tenth, a distance next to a boundary of pieces.
                let z = match i % 10 {
                    0 => (f64::from(i / 10) * 0.25).min(largest).next_down(),
                    _ => largest * (f64::from(i) / 4000.0).powi(3),
                };
                let distance = z.max(1e-300) / decay;
                let exact = macdonald(order, decay * distance) * decay.powf(order);
                let found = profile.pair(distance).value;
                assert!(
                    (found - exact).abs() <= 6e-15 * exact,
                    "mu = {order}, z = {z}: {found} {exact}"
                );
            }
        }
    }

    #[test]
    fn the_factor_is_the_series_and_fades_where_the_interval_is_long() {
        for (order, decay) in [(0.0, 1.0), (0.4, 7.0), (-0.2, 0.3)] {
            let series = SmallArgument::new(order);
            let short = MacdonaldProfile::new(order, decay, SHORT).unwrap();
            let long = MacdonaldProfile::new(order, decay, 100.0).unwrap();
            for z in [1e-9, 0.3, 1.0, 2.7, 5.0, 9.99, 12.0] {
                let exact = series.factor_anywhere(z) * decay.powf(-order);
                let found = short.pair(z / decay).factor;
                assert!((found / exact - 1.0).abs() < 1e-14, "mu = {order}, z = {z}");
                let faded = long.pair(z / decay).factor;
                assert!((faded / (exact * cutoff(z)) - 1.0).abs() < 1e-13, "mu = {order}, z = {z}");
            }
            // What collocation adds to a value, but for a share that falls as the square of the number of nodes between.
            let top = (10..500)
                .map(|i| 0.1 * f64::from(i))
                .map(|z| long.pair(z / decay).factor * decay.powf(order) * z.powf(-2.0 * order));
            assert!(top.fold(0.0, f64::max) < 2e6);
            assert!(long.pair((END - 0.1) / decay).factor < 1e-15);
            assert_eq!(long.pair((END + 1.1) / decay).factor, 0.0);
        }
    }

    #[test]
    fn the_split_goes_over_into_its_limits() {
        for order in [-0.45, -1e-9, 0.0, 1e-12, 1e-7, 0.2, 0.49] {
            for decay in [1e-6, 0.7, 50.0] {
                let profile = MacdonaldProfile::new(order, decay, 2.0 * decay).unwrap();
                let limit = profile.split(0.0);
                let near = profile.split(1e-6 / decay);
                // A and B are even functions of kappa d; what the cutoff takes from A is in B.
                let lost = if 2.0 * decay > SHORT { 1e-13 } else { 1e-15 }
                    * sigma(2.0 * order, 1e-6 / decay).abs()
                    * limit.factor;
                let size = limit.factor.abs() + limit.rest.abs();
                assert!((near.factor - limit.factor).abs() < 1e-11 * limit.factor);
                assert!(
                    (near.rest - limit.rest).abs() < 1e-10 * size + 4.0 * lost,
                    "mu = {order}, kappa = {decay}: {limit:?} {near:?}"
                );
            }
        }
    }

    #[test]
    fn refuses_what_it_cannot_do() {
        for (order, decay, largest) in
            [(0.5, 1.0, 1.0), (f64::NAN, 1.0, 1.0), (0.0, 0.0, 1.0), (0.0, 1.0, f64::NAN)]
        {
            assert!(MacdonaldProfile::new(order, decay, largest).is_err());
        }
    }
}
