//! Integrals and end values of solutions for very many parameters.

use super::SincSpectrum;
use super::assembly::Block;
use super::modes::ModeSums;
use crate::Error;
use crate::linear::{Eigensystem, vectorised};

/// Parameters taken at once: two of the widest vectors there are.
const LANES: usize = 16;
/// Eigenvalues above minus this share of the largest count as not negative.
const ROUNDING: f64 = 1e-13;

/// What a sweep gives at one parameter, for the solutions `phi_1`, `phi_x`, `phi_f` of `phi + lambda K phi = 1, x, f`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SweepValue {
    /// `int phi_1 dx`.
    pub one_one: f64,
    /// `int phi_x dx = int x phi_1 dx`.
    pub one_x: f64,
    /// `int x phi_x dx`.
    pub x_x: f64,
    /// `int phi_f dx`.
    pub one_f: f64,
    /// `int x phi_f dx`.
    pub x_f: f64,
    /// `phi_1` at the left and the right end.
    pub ends_one: [f64; 2],
    /// `phi_x` at the ends.
    pub ends_x: [f64; 2],
    /// `phi_f` at the ends.
    pub ends_f: [f64; 2],
}

/// The solution of `phi + lambda K phi = constant + slope x + f` with both integrals prescribed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prescribed {
    /// The constant of the right-hand side.
    pub constant: f64,
    /// The factor of `x` in the right-hand side.
    pub slope: f64,
    /// `phi` at the left and the right end.
    pub ends: [f64; 2],
}

impl SweepValue {
    /// The constant and the slope of the right-hand side `constant + slope x + factor f` that make
    /// `int phi dx = integral` and `int x phi dx = first_moment`, and the end values of `phi`.
    ///
    /// For a punch with the profile `g`, take `f = g` and `factor = -1` in its units: `integral` is the force,
    /// `first_moment` the moment, `constant` the settlement and `-slope` the tilt.
    #[must_use]
    pub fn prescribe(&self, integral: f64, first_moment: f64, factor: f64) -> Prescribed {
        let (p, m) = (integral - factor * self.one_f, first_moment - factor * self.x_f);
        let determinant = self.one_one * self.x_x - self.one_x * self.one_x;
        let constant = (p * self.x_x - m * self.one_x) / determinant;
        let slope = (m * self.one_one - p * self.one_x) / determinant;
        let ends = [0, 1].map(|end| {
            constant * self.ends_one[end] + slope * self.ends_x[end] + factor * self.ends_f[end]
        });
        Prescribed { constant, slope, ends }
    }
}

/// Everything that is needed to sum [`SweepValue`] over the modes, for parameters from 0 to a largest one.
///
/// With the eigenvalues `nu_k` each quantity is `sum_k c_k / (1 + lambda nu_k)`: one reciprocal a mode serves them all.
/// *Measured*, log kernel, 101 nodes: 11 million parameters a second on one core, relative error 1.1e-12 up to 1e4.
///
/// The settlement of a punch with the profile `100 x^2` under the force 0.001 and no moment, and its end pressures:
///
/// ```
/// use fredholm::SincOperator;
/// use fredholm::kernel::Logarithm;
///
/// let operator = SincOperator::new(&Logarithm::unit(), 60)?;
/// let profile = operator.sample(|x| x * x)?;
/// let sweep = operator.spectrum()?.sweep(&profile, [1.0, 1.0], 1e3)?;
/// let theta = 1500.0 / (8.0 * std::f64::consts::PI);
/// let found = sweep.at(theta).prescribe(0.001, 0.0, -100.0);
/// assert!((found.constant - 49.215_612_497_395_7).abs() < 1e-11);
/// assert!(found.slope.abs() < 1e-11);
/// assert!((found.ends[1] + 8.995_248_320_477_66).abs() < 1e-10);
/// # Ok::<(), fredholm::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Sweep {
    largest_parameter: f64,
    /// Values of `f` at the ends: even part and odd part, each at the right end, if there is parity.
    ends: [f64; 2],
    interval_ends: [f64; 2],
    modes: Modes,
}

#[derive(Debug, Clone)]
enum Modes {
    /// Even and odd: `<u,u>, <u,f>, <e,u>, <e,f>` with `u = 1` or `x` and the right end `e`.
    Parity { even: ModeSums<4>, odd: ModeSums<4>, centre: f64 },
    /// `11, 1x, xx, 1f, xf`, then the left and the right end with `1, x, f`.
    Whole(ModeSums<11>),
}

impl Sweep {
    pub(super) fn new(
        spectrum: &SincSpectrum<'_>,
        f: &[f64],
        ends: [f64; 2],
        largest_parameter: f64,
    ) -> Result<Self, Error> {
        let operator = spectrum.operator();
        operator.require_values(f)?;
        require_range(largest_parameter)?;
        for system in spectrum.blocks() {
            require_positive(system)?;
        }
        for (value, at) in
            ends.into_iter().zip([operator.interval().left(), operator.interval().right()])
        {
            if !value.is_finite() {
                return Err(Error::NotFinite { what: "right-hand side", at, value });
            }
        }
        let interval = operator.interval();
        let centre = interval.centre();
        let modes = match (operator.blocks(), spectrum.blocks()) {
            ([even, odd], [even_system, odd_system]) => {
                // About the middle, so that x is odd; the mean is put back at the end.
                let ones = vec![1.0; f.len()];
                let x: Vec<f64> = operator.positions().map(|x| x - centre).collect();
                Modes::Parity {
                    even: parity_modes(even, even_system, &ones, f, largest_parameter),
                    odd: parity_modes(odd, odd_system, &x, f, largest_parameter),
                    centre,
                }
            }
            _ => Modes::Whole(whole_modes(spectrum, f, largest_parameter)),
        };
        let interval_ends = [interval.left(), interval.right()];
        Ok(Self { largest_parameter, ends, interval_ends, modes })
    }

    /// Number of modes that are summed for each parameter.
    #[must_use]
    pub fn mode_count(&self) -> usize {
        match &self.modes {
            Modes::Parity { even, odd, .. } => even.count() + odd.count(),
            Modes::Whole(modes) => modes.count(),
        }
    }

    /// The values at one parameter; NaN outside the range of the sweep.
    #[must_use]
    pub fn at(&self, parameter: f64) -> SweepValue {
        let [value, ..] = self.lanes(&[parameter; LANES]);
        value
    }

    /// The values at many parameters, as many as the shorter of the two lists has.
    pub fn run(&self, parameters: &[f64], values: &mut [SweepValue]) {
        // Inlined, or else it is compiled for no vectors.
        vectorised(
            #[inline(always)]
            || {
                let (chunks, places) = (parameters.chunks(LANES), values.chunks_mut(LANES));
                for (chunk, places) in chunks.zip(places) {
                    let mut lanes = [0.0; LANES];
                    lanes[..chunk.len()].copy_from_slice(chunk);
                    let count = chunk.len().min(places.len());
                    places[..count].copy_from_slice(&self.lanes(&lanes)[..count]);
                }
            },
        );
    }

    /// [`run`](Self::run) on several threads, with the same result to the last bit.
    pub fn run_on_threads(&self, parameters: &[f64], values: &mut [SweepValue], threads: usize) {
        let count = parameters.len().min(values.len());
        let share = count.div_ceil(threads.max(1)).next_multiple_of(LANES);
        if threads <= 1 || share >= count {
            return self.run(parameters, values);
        }
        std::thread::scope(|scope| {
            for (parameters, values) in parameters.chunks(share).zip(values.chunks_mut(share)) {
                scope.spawn(move || self.run(parameters, values));
            }
        });
    }

    #[inline(always)]
    fn lanes(&self, parameters: &[f64; LANES]) -> [SweepValue; LANES] {
        let mut values = match &self.modes {
            Modes::Parity { even, odd, centre } => {
                self.by_parity(parameters, &even.at(parameters), &odd.at(parameters), *centre)
            }
            Modes::Whole(modes) => self.whole(parameters, &modes.at(parameters)),
        };
        for (value, parameter) in values.iter_mut().zip(parameters) {
            if !(0.0..=self.largest_parameter).contains(parameter) {
                *value = SweepValue::undefined();
            }
        }
        values
    }

    #[inline(always)]
    fn by_parity(
        &self,
        parameters: &[f64; LANES],
        even: &[[f64; LANES]; 4],
        odd: &[[f64; LANES]; 4],
        centre: f64,
    ) -> [SweepValue; LANES] {
        let half_length = self.interval_ends[1] - centre;
        let f_even = 0.5 * (self.ends[1] + self.ends[0]);
        let f_odd = 0.5 * (self.ends[1] - self.ends[0]);
        std::array::from_fn(|l| {
            let parameter = parameters[l];
            let one = 1.0 - parameter * even[2][l];
            let x = half_length - parameter * odd[2][l];
            let (fe, fo) = (f_even - parameter * even[3][l], f_odd - parameter * odd[3][l]);
            SweepValue {
                one_one: even[0][l],
                one_x: centre * even[0][l],
                x_x: odd[0][l] + centre * centre * even[0][l],
                one_f: even[1][l],
                x_f: odd[1][l] + centre * even[1][l],
                ends_one: [one, one],
                ends_x: [centre * one - x, centre * one + x],
                ends_f: [fe - fo, fe + fo],
            }
        })
    }

    #[inline(always)]
    fn whole(&self, parameters: &[f64; LANES], sums: &[[f64; LANES]; 11]) -> [SweepValue; LANES] {
        std::array::from_fn(|l| {
            let end = |right_hand_side: [f64; 2], k: usize| {
                [
                    right_hand_side[0] - parameters[l] * sums[k][l],
                    right_hand_side[1] - parameters[l] * sums[k + 3][l],
                ]
            };
            SweepValue {
                one_one: sums[0][l],
                one_x: sums[1][l],
                x_x: sums[2][l],
                one_f: sums[3][l],
                x_f: sums[4][l],
                ends_one: end([1.0, 1.0], 5),
                ends_x: end(self.interval_ends, 6),
                ends_f: end(self.ends, 7),
            }
        })
    }
}

impl SweepValue {
    fn undefined() -> Self {
        let (nan, ends) = (f64::NAN, [f64::NAN; 2]);
        Self {
            one_one: nan,
            one_x: nan,
            x_x: nan,
            one_f: nan,
            x_f: nan,
            ends_one: ends,
            ends_x: ends,
            ends_f: ends,
        }
    }
}

fn require_range(largest_parameter: f64) -> Result<(), Error> {
    if largest_parameter.is_finite() && largest_parameter >= 0.0 {
        Ok(())
    } else {
        Err(Error::InvalidParameter {
            name: "largest_parameter",
            value: largest_parameter,
            requirement: "finite and not negative",
        })
    }
}

fn require_positive(system: &Eigensystem) -> Result<(), Error> {
    let largest = system.values.iter().fold(0.0, |largest: f64, nu| largest.max(nu.abs()));
    match system.values.iter().position(|nu| *nu < -ROUNDING * largest) {
        Some(pivot) => Err(Error::NotPositiveDefinite { order: system.values.len(), pivot }),
        None => Ok(()),
    }
}

fn parity_modes(
    block: &Block,
    system: &Eigensystem,
    u: &[f64],
    f: &[f64],
    largest_parameter: f64,
) -> ModeSums<4> {
    let modes = |values: &[f64]| system.coefficients(&block.scaled(values));
    let (u, f, e) = (modes(u), modes(f), system.coefficients(block.end_rows()[1]));
    let count = block.multiplicity();
    let products = (0..system.values.len()).map(|k| {
        (system.values[k], [count * u[k] * u[k], count * u[k] * f[k], e[k] * u[k], e[k] * f[k]])
    });
    ModeSums::new(products, largest_parameter)
}

fn whole_modes(spectrum: &SincSpectrum<'_>, f: &[f64], largest_parameter: f64) -> ModeSums<11> {
    let operator = spectrum.operator();
    let (block, system) = (&operator.blocks()[0], &spectrum.blocks()[0]);
    let modes = |values: &[f64]| system.coefficients(&block.scaled(values));
    let x: Vec<f64> = operator.positions().collect();
    let sides = [modes(&vec![1.0; f.len()]), modes(&x), modes(f)];
    let ends = block.end_rows().map(|row| system.coefficients(row));
    let products = (0..system.values.len()).map(|k| {
        let [one, x, f] = [0, 1, 2].map(|side| sides[side][k]);
        let [left, right] = [ends[0][k], ends[1][k]];
        let products = [
            one * one,
            one * x,
            x * x,
            one * f,
            x * f,
            left * one,
            left * x,
            left * f,
            right * one,
            right * x,
            right * f,
        ];
        (system.values[k], products)
    });
    ModeSums::new(products, largest_parameter)
}
