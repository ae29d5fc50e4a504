//! Forward-mode derivatives side by side.

use super::derivative::Dual;
use super::function::{Binary, Unary};
use super::value::Value;
use super::waves::both;

/// Values with their derivatives, each as [`Dual`] has it by itself: the operations of most formulae on whole vectors, others one by one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Duals<const COUNT: usize> {
    values: [f64; COUNT],
    slopes: [f64; COUNT],
    /// All bits where the value depends on the variable, none where it does not.
    varies: [u64; COUNT],
}

impl<const COUNT: usize> Duals<COUNT> {
    #[inline(always)]
    pub(super) fn variable(values: [f64; COUNT], slope: f64) -> Self {
        Self { values, slopes: [slope; COUNT], varies: [mask(slope != 0.0); COUNT] }
    }

    /// Values and slopes; an undefined value has an undefined slope.
    #[inline(always)]
    pub(super) fn parts(self) -> [[f64; COUNT]; 2] {
        let slopes =
            std::array::from_fn(
                |k| {
                    if self.values[k].is_nan() { f64::NAN } else { self.slopes[k] }
                },
            );
        [self.values, slopes]
    }

    #[inline(always)]
    fn derived(values: [f64; COUNT], slopes: [f64; COUNT], varies: [u64; COUNT]) -> Self {
        Self { values, slopes: std::array::from_fn(|k| kept(slopes[k], varies[k])), varies }
    }

    /// `factor * u'`, which is zero where `u` does not vary even if the factor is not finite.
    #[inline(always)]
    fn partial(&self, factors: [f64; COUNT]) -> [f64; COUNT] {
        std::array::from_fn(|k| kept(factors[k] * self.slopes[k], self.varies[k]))
    }

    fn one(&self, k: usize) -> Dual {
        Dual::new(self.values[k], self.slopes[k], self.varies[k] != 0)
    }

    fn of(ones: [Dual; COUNT]) -> Self {
        let known = ones.map(Dual::known);
        Self {
            values: known.map(|(value, _, _)| value),
            slopes: known.map(|(_, slope, _)| slope),
            varies: known.map(|(_, _, varies)| mask(varies)),
        }
    }
}

impl<const COUNT: usize> Value for Duals<COUNT> {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        Self { values: [value; COUNT], slopes: [0.0; COUNT], varies: [0; COUNT] }
    }

    #[inline(always)]
    fn unary(function: Unary, u: Self) -> Self {
        match function {
            Unary::Sin => {
                let [sines, cosines] = both(u.values);
                let slopes = std::array::from_fn(|k| cosines[k] * u.slopes[k]);
                Self::derived(sines, slopes, u.varies)
            }
            Unary::Cos => {
                let [sines, cosines] = both(u.values);
                let slopes = std::array::from_fn(|k| -sines[k] * u.slopes[k]);
                Self::derived(cosines, slopes, u.varies)
            }
            _ => one_by_one(function, &u),
        }
    }

    #[inline(always)]
    fn binary(function: Binary, u: Self, v: Self) -> Self {
        let varies = std::array::from_fn(|k| u.varies[k] | v.varies[k]);
        match function {
            Binary::Add => {
                let values = std::array::from_fn(|k| u.values[k] + v.values[k]);
                let slopes = std::array::from_fn(|k| u.slopes[k] + v.slopes[k]);
                Self::derived(values, slopes, varies)
            }
            Binary::Subtract => {
                let values = std::array::from_fn(|k| u.values[k] - v.values[k]);
                let slopes = std::array::from_fn(|k| u.slopes[k] - v.slopes[k]);
                Self::derived(values, slopes, varies)
            }
            Binary::Multiply => {
                let values = std::array::from_fn(|k| u.values[k] * v.values[k]);
                let (left, right) = (u.partial(v.values), v.partial(u.values));
                let slopes = std::array::from_fn(|k| left[k] + right[k]);
                Self::derived(values, slopes, varies)
            }
            Binary::Divide => {
                let divisors: [f64; COUNT] = std::array::from_fn(|k| v.values[k] + 0.0);
                let values: [f64; COUNT] = std::array::from_fn(|k| u.values[k] / divisors[k]);
                let by_u = u.partial(divisors.map(|divisor| 1.0 / divisor));
                let by_v = v.partial(std::array::from_fn(|k| values[k] / divisors[k]));
                let slopes = std::array::from_fn(|k| by_u[k] - by_v[k]);
                Self::derived(values, slopes, varies)
            }
            _ => pair_by_pair(function, &u, &v),
        }
    }

    fn choose(condition: Self, holds: Self, fails: Self) -> Self {
        Self::of(std::array::from_fn(|k| {
            Dual::choose(condition.one(k), holds.one(k), fails.one(k))
        }))
    }
}

fn one_by_one<const COUNT: usize>(function: Unary, u: &Duals<COUNT>) -> Duals<COUNT> {
    Duals::of(std::array::from_fn(|k| Dual::unary(function, u.one(k))))
}

fn pair_by_pair<const COUNT: usize>(
    function: Binary,
    u: &Duals<COUNT>,
    v: &Duals<COUNT>,
) -> Duals<COUNT> {
    Duals::of(std::array::from_fn(|k| Dual::binary(function, u.one(k), v.one(k))))
}

#[inline(always)]
fn mask(is_set: bool) -> u64 {
    u64::from(is_set).wrapping_neg()
}

/// The number where the bits are set, zero where they are not.
#[inline(always)]
fn kept(number: f64, mask: u64) -> f64 {
    f64::from_bits(number.to_bits() & mask)
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::{Expression, Line};

    /// Formulae of all functions, with kinks, branches, parts that do not vary and places without a value.
    pub(in super::super) const FORMULAE: [&str; 14] = [
        "1e-3*cos(2*pi*x/a + 0.3) - 2*sin(17*x)^2 + x^3/(1 + x^2)",
        "abs(x) + max(x, 0.1) - min(x^2, 0.04) + hypot(x, 0.2)",
        "where(x > 0.1, sin(x), a*x^2) + where(x < 0, a, x)",
        "sqrt(x) + sqrt(x^2) + 0*sqrt(a - a)",
        "exp(x)*ln(2 + x) - log10(3 + x)*log2(3 + x) + log1p(x) + expm1(x)",
        "asin(x/2) + acos(x/2) + atan(x) + atan2(x, 1) + tan(x)",
        "sinh(x) + cosh(x) - tanh(x) + asinh(x) + acosh(2 + x) + atanh(x/2)",
        "cbrt(x) + sign(x) + floor(3*x) + ceil(2*x) + step(x)",
        "x^a + a^x + 2^(x^2) - (-x)",
        "sin(1e9*x) + cos(2000*x)",
        "asin(sin(3*x))*1e-3",
        "a",
        "x/0 + 1/x",
        "sin(a)*sqrt(a - a)*x + ln(a - a)",
    ];

    #[test]
    fn derivatives_side_by_side_are_those_of_each() {
        let line = Line::new(&[(0.0, 0.5), (0.5, 0.0)]);
        let places = [-1.0, -0.37, -1e-12, 0.0, 1e-300, 0.2, 0.2f64.next_up(), 0.999];
        for formula in FORMULAE {
            let expression = Expression::parse(formula, &["x", "a"]).unwrap();
            let [values, slopes] = expression.derivatives_along(&line, &places);
            for (k, t) in places.into_iter().enumerate() {
                let (value, slope) = expression.derivative_along(&line, t);
                let [found, alone] =
                    [[values[k], slopes[k]], [value, slope]].map(|pair| pair.map(f64::to_bits));
                let is_nan = values[k].is_nan() && value.is_nan();
                let is_same = found == alone || slopes[k].is_nan() && slope.is_nan();
                assert!(is_same && (is_nan || found[0] == alone[0]), "{formula} at {t}");
            }
        }
    }
}
