//! Norms of the kernels on the part of the base where an answer and the truth can differ.

use std::f64::consts::{LN_2, PI, TAU};

use crate::kernel::Kernel;

/// Modes up to which the part of a kernel is sought of which the energy is bounded.
const MODES: u32 = 4096;
/// Places, each twice the one before, where powers are split.
const SPLITS: i32 = 128;

/// A bound of `max_x int |K(x, s)| ds` over an interval of this half-length, at most 1, and so of the norm of `K` in `L2` and between bounded functions.
///
/// The logarithm: `F(h-x) + F(h+x)` with `F(t) = int_0^t |ln u| du` is largest in the middle. The power: `2 h^(1-mu)/(1-mu)` in the middle. The row: `int_0^(L/2)` twice of `|ln(2 sin)|`,
/// `L/pi int_0^pi |ln(2 sin(u/2))| du <= 0.6461 L`, with what lies farther than half a period counted twice.
#[must_use]
pub(crate) fn mass(kernel: Kernel, half: f64) -> f64 {
    match kernel {
        Kernel::Logarithm | Kernel::ShiftedLogarithm { .. } | Kernel::Layered(_) => {
            2.0 * half * (1.0 - half.ln() + kernel.constant().abs() + kernel.rest())
        }
        Kernel::Row { period } => 0.66 * period,
        Kernel::Power { exponent } => 2.0 * half.powf(1.0 - exponent) / (1.0 - exponent),
    }
}

/// A bound of `max_x ||K(x, .)||` in `L2` of an interval of half-length 1; infinite for powers from 1/2 on.
///
/// The logarithm: `int_0^1 ln^2 u du = 2` to either side, in all 4, largest in the middle; a constant besides its own. The power: `2/(1 - 2 mu)`. The row: `L sum 1/(2 k^2) = L pi^2/12`.
#[must_use]
pub(crate) fn row_norm(kernel: Kernel) -> f64 {
    match kernel {
        Kernel::Logarithm | Kernel::ShiftedLogarithm { .. } | Kernel::Layered(_) => {
            2.0 + 2f64.sqrt() * (kernel.constant().abs() + kernel.rest())
        }
        Kernel::Row { period } => (period * PI.powi(2) / 12.0).sqrt(),
        Kernel::Power { exponent } if exponent < 0.5 => (2.0 / (1.0 - 2.0 * exponent)).sqrt(),
        Kernel::Power { .. } => f64::INFINITY,
    }
}

/// Where `e = p - q` lives, and what the kernel does to it there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reach {
    kernel: Kernel,
    theta: f64,
    pub(crate) middle: f64,
    pub(crate) half: f64,
    /// Whether `<1, e> = 0`: then constants may be taken from the kernel.
    is_neutral: bool,
}

impl Reach {
    pub(crate) fn new(
        kernel: Kernel,
        theta: f64,
        [left, right]: [f64; 2],
        is_neutral: bool,
    ) -> Self {
        // Half a unit more than rounding may take away.
        let half =
            (0.5 * (right - left) * (1.0 + 4.0 * f64::EPSILON)).clamp(f64::MIN_POSITIVE, 1.0);
        Self { kernel, theta, middle: 0.5 * (left + right), half, is_neutral }
    }

    /// A bound of `||theta K e||/||e||`; also between bounded functions.
    pub(crate) fn strength(&self) -> f64 {
        self.theta * mass(self.kernel, self.half)
    }

    /// Of the kernel that is left where constants count for nothing, `ln(h/|x - s|)`.
    fn neutral_mass(&self) -> f64 {
        match self.kernel {
            Kernel::Logarithm | Kernel::ShiftedLogarithm { .. } if self.is_neutral => {
                2.0 * self.half
            }
            kernel => mass(kernel, self.half),
        }
    }

    /// `theta` of the interval scaled to half-length 1; a row keeps its scale.
    fn scaled_theta(&self) -> f64 {
        match self.kernel {
            Kernel::Logarithm | Kernel::ShiftedLogarithm { .. } | Kernel::Layered(_) => {
                self.theta * self.half
            }
            Kernel::Row { .. } => self.theta,
            Kernel::Power { exponent } => self.theta * self.half.powf(1.0 - exponent),
        }
    }

    /// `max_x ||theta K(x, .)||` of the scaled interval.
    fn row_norm(&self) -> f64 {
        let own = match self.kernel {
            Kernel::ShiftedLogarithm { .. } => row_norm(Kernel::Logarithm),
            Kernel::Layered(layered) => row_norm(Kernel::Logarithm) + 2f64.sqrt() * layered.rest,
            kernel => row_norm(kernel),
        };
        self.scaled_theta() * (own + 2f64.sqrt() * self.constant().abs())
    }

    /// The constant `ln(1/h)` of the logarithm that counts, with its own.
    fn constant(&self) -> f64 {
        match self.kernel {
            Kernel::Logarithm | Kernel::ShiftedLogarithm { .. } | Kernel::Layered(_)
                if !self.is_neutral =>
            {
                self.kernel.constant() - self.half.ln()
            }
            _ => 0.0,
        }
    }

    /// A number `C` with `theta |K e|(x) <= C ||w||` wherever `<(1 + theta K) e, e> <= ||w|| ||e||`.
    ///
    /// The kernel is split at its mode `N`: of the part below the energy of `e` is bounded, of the part above the norm. With `alpha^2 = theta sum of the modes below` and `beta = theta` times the norm
    /// of what is above, `C = (beta + sqrt(alpha^2 + beta^2))/2`; at least one of the modes is split off. On an interval of half-length `h` norms are `sqrt(h)` of those on the scaled one.
    pub(crate) fn smoothing(&self) -> f64 {
        let theta = self.scaled_theta();
        if let Kernel::Power { exponent } = self.kernel {
            return power_smoothing(exponent, theta).0 / self.half.sqrt();
        }
        if let Kernel::Layered(layered) = self.kernel {
            let splits = layered.splits.iter().flatten().map(|[below, above]| {
                let beta = self.theta * above;
                0.5 * (beta + (self.theta * below + beta * beta).sqrt())
            });
            return splits.fold(self.row_norm() / self.scale(), f64::min);
        }
        let mut best = self.row_norm();
        let mut harmonic = 0.0;
        for n in (1..=MODES).map(f64::from) {
            harmonic += 1.0 / n;
            if !(n as u32).is_power_of_two() {
                continue;
            }
            let (energy, above) = match self.kernel {
                // sum cos(2 pi k d/L)/k
                Kernel::Row { period } => (harmonic, (0.5 * period / n).sqrt()),
                // Modes (2/m) T_m, ln 2 the first; the unweighted norm of the rest is at most the weighted one.
                _ => (self.constant() + LN_2 + 2.0 * harmonic, (TAU / n).sqrt()),
            };
            let beta = theta * above;
            best = best.min(0.5 * (beta + (theta * energy + beta * beta).sqrt()));
        }
        best / self.scale()
    }

    fn scale(&self) -> f64 {
        match self.kernel {
            Kernel::Row { .. } => 1.0,
            Kernel::Logarithm
            | Kernel::ShiftedLogarithm { .. }
            | Kernel::Layered(_)
            | Kernel::Power { .. } => self.half.sqrt(),
        }
    }

    /// Whether [`Reach::smoothing`] leaves a part of the kernel, with the integral `1/(2 theta)`, to the largest error: then that counts twice.
    pub(crate) fn doubles(&self) -> bool {
        match self.kernel {
            Kernel::Power { exponent } => power_smoothing(exponent, self.scaled_theta()).1,
            Kernel::Logarithm
            | Kernel::ShiftedLogarithm { .. }
            | Kernel::Layered(_)
            | Kernel::Row { .. } => false,
        }
    }

    /// Bounds of `theta <K u, u>`, the least over multiples `c` of the density `psi` with `K psi` a constant (and so without effect on `e`), with `u = 1 - c psi`, and of the same with `x` for 1 and
    /// `K psi = x`; where `e` has neither force nor moment. None where these densities have no closed form.
    ///
    /// On `[-1, 1]` they are `(1-x^2)^((mu-1)/2)` and `x` times it, with the eigenvalues `pi/cos(pi mu/2)` and `mu` times that (`mu = 0`: `pi ln 2` and `pi`).
    pub(crate) fn rest_energies(&self) -> Option<[f64; 2]> {
        if !self.is_neutral {
            return None;
        }
        let h = self.half;
        match self.kernel {
            // 6 - 4 ln 2 - 4 ln 2 and 1 - 8/9
            Kernel::Logarithm | Kernel::ShiftedLogarithm { .. } => {
                Some([self.theta * h * h * (6.0 - 8.0 * LN_2), self.theta * h.powi(4) / 9.0])
            }
            Kernel::Row { .. } | Kernel::Layered(_) => None,
            Kernel::Power { exponent: mu } => {
                let first = PI / (0.5 * PI * mu).cos();
                let whole =
                    PI.sqrt() * libm::tgamma(0.5 * (1.0 + mu)) / libm::tgamma(1.0 + 0.5 * mu);
                let power = |n: f64| 2f64.powf(n - mu);
                let ones = 2.0 * power(2.0) / ((1.0 - mu) * (2.0 - mu));
                let places = 2.0 / (1.0 - mu)
                    * (power(4.0) / (4.0 - mu) - 2.0 * power(3.0) / (3.0 - mu)
                        + power(2.0) / (2.0 - mu))
                    - power(4.0) / ((3.0 - mu) * (4.0 - mu));
                let level = ones - 4.0 * first / whole;
                let slope = places - mu * first * (4.0 / 9.0) * (2.0 + mu) / whole;
                // Differences of numbers of the size of the first.
                let rounding = 64.0 * f64::EPSILON * ones;
                let scale = self.theta * h.powf(2.0 - mu);
                Some([scale * (level + rounding), scale * h * h * (slope + rounding)])
            }
        }
    }

    /// The largest `sqrt(theta <K e, e>)/||w||` times `||theta K e||/sqrt(theta <K e, e>)`.
    ///
    /// Of a layer the kernel itself has to be positive, no constant taken; else only its norm is known.
    pub(crate) fn moved(&self) -> f64 {
        match self.kernel {
            Kernel::Layered(layered) if layered.is_positive => {
                return 0.5 * self.strength().sqrt();
            }
            Kernel::Layered(_) => return self.strength(),
            _ => {}
        }
        0.5 * (self.theta * self.neutral_mass()).sqrt()
    }
}

/// What a power gives for [`Reach::smoothing`] with `theta`, on an interval of half-length 1, and whether it leaves a part to the largest error.
///
/// `|x|^-mu = c int t^(mu/2-1) exp(-t x^2) dt`, `c = 1/Gamma(mu/2)`, split at `t = T`. Both parts are positive. Of the smooth one `alpha^2 = theta K(0) = 2 theta c T^(mu/2)/mu`; of the sharp one the norm
/// is at most `c (pi/2)^(1/4) T^(mu/2-1/4)/(1/4 - mu/2)` for `mu < 1/2`, and the integral `c sqrt(pi) T^((mu-1)/2) 2/(1-mu)` for all: with that at `1/(2 theta)` it is left to the largest error, which then
/// counts twice.
fn power_smoothing(mu: f64, theta: f64) -> (f64, bool) {
    let c = 1.0 / libm::tgamma(0.5 * mu);
    let alpha = |power: f64| (2.0 * theta * c * power.powf(0.5 * mu) / mu).sqrt();
    let left = (4.0 * theta * c * PI.sqrt() / (1.0 - mu)).powf(2.0 / (1.0 - mu));
    let mut best = (2.0 * 0.5 * alpha(left), true);
    if mu < 0.5 {
        let plain = theta * (2.0 / (1.0 - 2.0 * mu)).sqrt();
        // Twice what it is, if the other is counted twice: below that it serves better.
        best = if plain < best.0 + 1.0 { (plain, false) } else { best };
        for step in 0..SPLITS {
            let split = 2f64.powi(step);
            let beta =
                theta * c * (0.5 * PI).powf(0.25) * split.powf(0.5 * mu - 0.25) / (0.25 - 0.5 * mu);
            let sum = 0.5 * (beta + (alpha(split).powi(2) + beta * beta).sqrt());
            if sum < best.0 {
                best = (sum, false);
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::density::Density;
    use crate::legendre::{ORDER, RULE};
    use crate::panel::Panel;

    /// A density with these values on equal panels.
    fn steps(kernel: Kernel, [left, right]: [f64; 2], values: &[f64]) -> Density {
        let width = (right - left) / values.len() as f64;
        let panels = (values.iter().zip(0..))
            .map(|(value, i)| {
                let mut coefficients = [0.0; ORDER];
                coefficients[0] = *value;
                let at = left + width * f64::from(i);
                Panel::new(at, at + width, coefficients)
            })
            .collect();
        Density::new(kernel, panels)
    }

    /// `||e||`, `<K e, e>` and the largest `|K e|` at Gauss nodes.
    fn measured(density: &Density) -> [f64; 3] {
        let (mut square, mut energy, mut largest) = (0.0, 0.0, 0.0f64);
        for panel in &density.panels {
            let e = panel.coefficients[0];
            square += e * e * 2.0 * panel.half();
            for (x, weight) in panel.nodes() {
                let potential = density.potential(x).0;
                energy += weight * e * potential;
                largest = largest.max(potential.abs());
            }
        }
        [square.sqrt(), energy, largest]
    }

    /// Densities from smooth to rough, without force.
    fn drawn(count: usize, seed: u64) -> Vec<Vec<f64>> {
        let mut state = seed;
        let mut random = move || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        (0..12)
            .map(|kind| {
                let mut values: Vec<f64> = (0..count)
                    .map(|i| {
                        let t = i as f64 / count as f64;
                        match kind % 4 {
                            0 => random(),
                            1 => (f64::from(kind) * 3.0 * t + random()).cos(),
                            // A spike, which is what the bound of the potential is sharpest for.
                            2 => {
                                if i == count / 2 {
                                    1.0
                                } else {
                                    1e-3 * random()
                                }
                            }
                            _ => {
                                if i == 0 {
                                    1.0
                                } else {
                                    -random() * t
                                }
                            }
                        }
                    })
                    .collect();
                let mean = values.iter().sum::<f64>() / count as f64;
                values.iter_mut().for_each(|value| *value -= mean);
                values
            })
            .collect()
    }

    #[test]
    fn potentials_of_densities_without_force_stay_below_their_bounds() {
        let kernels = [
            Kernel::Logarithm,
            Kernel::Row { period: 2.5 },
            Kernel::Power { exponent: 0.3 },
            Kernel::Power { exponent: 0.7 },
        ];
        let mut closest = 0.0f64;
        for kernel in kernels {
            for interval in [[-1.0, 1.0], [0.1, 0.2]] {
                for theta in [0.3, 10.0, 1000.0] {
                    let reach = Reach::new(kernel, theta, interval, true);
                    for values in drawn(60, 7) {
                        let density = steps(kernel, interval, &values);
                        let [norm, energy, largest] = measured(&density);
                        // The least ||w|| for which <(1 + theta K) e, e> <= ||w|| ||e||.
                        let w = norm + theta * energy / norm;
                        let mut allowed = reach.smoothing() * w;
                        if reach.doubles() {
                            let most = values.iter().fold(0.0f64, |most, e| most.max(e.abs()));
                            allowed = 0.5 * (allowed + most);
                        }
                        closest = closest.max(theta * largest / allowed);
                        assert!(
                            theta * largest <= allowed,
                            "{kernel:?} {interval:?} theta {theta}: {} {allowed}",
                            theta * largest
                        );
                        assert!(energy >= -1e-9, "{kernel:?} {interval:?}: energy {energy}");
                    }
                }
            }
        }
        println!("closest: {closest}");
        assert!(closest > 0.1, "idle: {closest}");
    }

    /// `theta <K u, u>` with `u = 1 - c psi` against the same with `psi` on Gauss nodes after `x = sin t`, which takes its ends away.
    #[test]
    fn rest_energies() {
        let theta = 3.0;
        for (kernel, mu) in [
            (Kernel::Logarithm, 0.0),
            (Kernel::Power { exponent: 0.3 }, 0.3),
            (Kernel::Power { exponent: 0.7 }, 0.7),
        ] {
            let reach = Reach::new(kernel, theta, [-0.25, 0.25], true);
            let h: f64 = 0.25;
            let found = reach.rest_energies().unwrap();
            // <K u, u> = <K 1, 1> - <1, 1>^2 V with V the potential of the psi of mass one; for x with K psi = x: <K x, x> - <x, x>^2/<x, psi>.
            let own = |power: usize| {
                let mut coefficients = [0.0; ORDER];
                coefficients[power] = if power == 0 { 1.0 } else { h };
                let density = Density::new(kernel, vec![Panel::new(-h, h, coefficients)]);
                // Graded towards the ends, where the potential is not smooth.
                let mut sum = 0.0;
                for level in 0..40 {
                    let (far, near) = (h * 0.5f64.powi(level), h * 0.5f64.powi(level + 1));
                    for (t, weight) in RULE.nodes.iter().zip(&RULE.weights) {
                        let d = 0.5 * (far + near) + 0.5 * (far - near) * t;
                        let x = h - d;
                        sum += 2.0
                            * 0.5
                            * (far - near)
                            * weight
                            * x.powi(power as i32)
                            * density.potential(x).0;
                    }
                }
                sum
            };
            // Integrals of the weight (1 - y^2)^((mu - 1)/2) and of y^2 times it, by y = sin t.
            let weighted = |power: i32| {
                let n = 200_000;
                let step = PI / f64::from(n);
                (0..n)
                    .map(|i| -0.5 * PI + step * (f64::from(i) + 0.5))
                    .map(|t: f64| step * t.sin().powi(power) * t.cos().powf(mu))
                    .sum::<f64>()
            };
            // K psi on the scaled interval.
            let (first, second) = if mu == 0.0 {
                (PI * LN_2, PI)
            } else {
                let value = PI / (0.5 * PI * mu).cos();
                (value, mu * value)
            };
            let scale = if mu == 0.0 { 1.0 } else { h.powf(-mu) };
            let constant = first / weighted(0) * scale - if mu == 0.0 { h.ln() } else { 0.0 };
            let level = own(0) - 4.0 * h * h * constant;
            let square = 2.0 / 3.0 * h.powi(3);
            // psi = y w(y) on the scaled interval gives K psi = second scale h y = second scale x, and <x, psi> = h^2 int y^2 w.
            let slope = own(1) - square * square * second * scale / (h * h * weighted(2));
            for (found, truth) in found.iter().zip([level, slope]) {
                assert!(
                    (found / theta - truth).abs() < 2e-4 * truth,
                    "{mu}: {found} {}",
                    theta * truth
                );
            }
        }
    }
}
