//! Equations as bilateral contacts on `[-1, 1]`, whose errors are bounded between all places by `shtaerman-audit`.
//!
//! `phi + lambda int K phi ds = f` on `(-a, a)` is the equation of a base `-f` in full contact without settlement and tilt, with `x = a xi`:
//!
//! | kernel | on `[-1, 1]` | `theta` |
//! |---|---|---|
//! | `ln 1/|x - s|` | `ln 1/|xi - eta| - ln a`, positive for `a <= 2` | `lambda a` |
//! | `|x - s|^-mu` | `|xi - eta|^-mu` | `lambda a^(1-mu)` |
//! | `ln 1/(2 sin(|x - s|/2))` | `ln 1/(2 sin(pi|xi - eta|/L))`, `L = 2 pi/alpha` | `lambda alpha` |
//! | `ln 1/|x^2 - s^2|`, `b < x < a` | the first on both halves, for the even continuation of `phi` and `f` | `lambda a` |

use shtaerman_audit::{Answer, Kernel, Prescribed, Problem};

use super::{Equation, Kind, SolvedEquation};
use crate::Profile;
use crate::expression::Interval;

/// What scaling to `[-1, 1]` may do to `theta`, relative to its size: some roundings, one of them of a power.
const SCALED: f64 = 4.0 * f64::EPSILON;

/// An equation scaled to `[-1, 1]`.
struct Posed {
    kernel: Kernel,
    theta: f64,
    half_width: f64,
    /// Whether it was continued to the left of the origin as an even one; its left end then.
    inner: Option<f64>,
}

/// The base `-f`.
struct Base {
    profile: Profile,
    half_width: f64,
    is_even: bool,
}

impl Base {
    /// Where an interval lies in the part that is given.
    fn given(&self, [left, right]: [f64; 2]) -> [f64; 2] {
        if !self.is_even || left >= 0.0 {
            [left, right]
        } else if right <= 0.0 {
            [-right, -left]
        } else {
            [0.0, right.max(-left)]
        }
    }
}

/// The negative of an enclosure; nothing known without one.
fn negative(range: Option<Interval>) -> [f64; 2] {
    range.map_or([f64::NEG_INFINITY, f64::INFINITY], |range| [-range.upper(), -range.lower()])
}

impl shtaerman_audit::Profile for Base {
    fn height(&self, xi: f64) -> [f64; 2] {
        let xi = if self.is_even { xi.abs() } else { xi };
        negative(self.profile.enclose_at(xi, self.half_width))
    }

    fn range(&self, interval: [f64; 2]) -> [f64; 2] {
        negative(self.profile.enclose(self.given(interval), self.half_width))
    }

    fn taylor_bounds(&self, interval: [f64; 2], order: usize) -> Vec<f64> {
        let found = self.profile.taylor(self.given(interval), order, self.half_width);
        found.unwrap_or_default().iter().map(|range| range.size()).collect()
    }

    fn looks(&self, _: [f64; 2]) -> u64 {
        self.profile.looks()
    }
}

impl Equation {
    /// The equation on `[-1, 1]`, where its kernel has bounds there; that it is positive is known already.
    fn posed(&self) -> Option<Posed> {
        let Kind::Second { lambda } = self.kind() else { return None };
        let named = self.kernel();
        let family = named.family();
        let value = |name: &str| named.parameter(name).unwrap_or(f64::NAN);
        let logarithm = |a: f64| Kernel::ShiftedLogarithm { constant: -a.ln() };
        let (kernel, theta, half_width, inner) = match family.name {
            "log" => (logarithm(value("a")), lambda * value("a"), value("a"), None),
            // On a longer interval the constant would have to be judged with the gap.
            "log-square" if value("a") <= 2.0 => {
                (logarithm(value("a")), lambda * value("a"), value("a"), Some(value("b")))
            }
            "log-sine" => {
                let alpha = value("alpha");
                let period = std::f64::consts::TAU / alpha;
                (Kernel::Row { period: period.max(2.0) }, lambda * alpha, alpha, None)
            }
            "power" => {
                let (a, mu) = (value("a"), value("mu"));
                (Kernel::Power { exponent: mu }, lambda * a.powf(1.0 - mu), a, None)
            }
            _ => return None,
        };
        theta.is_finite().then_some(Posed { kernel, theta, half_width, inner })
    }
}

impl Equation {
    /// `theta` on `[-1, 1]`; 0 where the equation has no bounds.
    pub(super) fn strength(&self) -> f64 {
        self.posed().map_or(0.0, |posed| posed.theta)
    }
}

impl Posed {
    /// `max_x ||K(x, .)||` of the row, `L sum 1/(2 k^2)`.
    fn row_norm(&self) -> f64 {
        let Kernel::Row { period } = self.kernel else { return 0.0 };
        (period * std::f64::consts::PI.powi(2) / 12.0).sqrt()
    }

    /// What rounding of the period may change of the potential of a density of size one: its logarithm has a pole one period away.
    fn of_period(&self) -> f64 {
        let Kernel::Row { period } = self.kernel else { return 0.0 };
        let distance = (period - 2.0).max(f64::EPSILON);
        8.0 * f64::EPSILON * period * (2.0 + (period / distance).ln())
    }
}

/// Bounds of the errors of a solution.
pub(super) struct Bounds {
    /// Of `phi` at any place of the closed interval.
    pub(super) solution: f64,
    /// Of its integral, infinite where it states none.
    pub(super) integral: f64,
    /// Of `phi` in the mean square.
    pub(super) mean_square: f64,
    /// Panels of the resampled solution.
    pub(super) panels: usize,
}

impl SolvedEquation<'_> {
    /// Bounds by the residual, enclosed between all places; none where the kernel has none or no bound was found.
    pub(super) fn bounds(&self) -> Option<Bounds> {
        let equation = self.equation();
        let posed = equation.posed()?;
        let a = posed.half_width;
        let profile = Profile::expression(equation.right_hand_side().text()).ok()?;
        let base = Base { profile, half_width: a, is_even: posed.inner.is_some() };
        let pieces = match posed.inner {
            Some(inner) => vec![[-1.0, -inner / a], [inner / a, 1.0]],
            None => vec![[-1.0, 1.0]],
        };
        let mut cuts: Vec<f64> = equation.breakpoints();
        cuts.extend(&equation.parts().cuts);
        cuts.iter_mut().for_each(|cut| *cut /= a);
        if base.is_even {
            let mirrored: Vec<f64> = cuts.iter().map(|cut| -cut).collect();
            cuts.extend(mirrored);
        }
        let cuts = crate::order::ascending(cuts);
        let problem = Problem {
            kernel: posed.kernel,
            theta: posed.theta,
            scaled: SCALED,
            ground: None,
            pieces: &pieces,
            is_bilateral: true,
            prescribed: Prescribed { force: None, moment: None },
            profile: &base,
            cuts: &cuts,
        };
        let shares = if base.is_even { 2.0 } else { 1.0 };
        let integral = self.integral().map(|integral| shares * integral / a);
        let [left, right] = equation.shown();
        let place = |xi: f64| a * if base.is_even { xi.abs() } else { xi };
        let pressure = |xi: f64| self.solution().evaluate(place(xi).clamp(left, right));
        let answer = Answer {
            zones: &pieces,
            pressure: &pressure,
            settlement: 0.0,
            tilt: 0.0,
            force: integral.unwrap_or(0.0),
            moment: 0.0,
        };
        let bound = shtaerman_audit::audit(&problem, &answer).ok()?;
        // The kernel of the row is that of a period which is off by rounding.
        let moved = posed.theta * posed.of_period() * (self.solution().largest + bound.pressure);
        let strength = 1.0 + posed.theta * posed.row_norm();
        let mean_square = bound.mean_square + std::f64::consts::SQRT_2 * moved;
        let found = Bounds {
            solution: bound.pressure + if moved > 0.0 { 2.0 * strength * moved } else { 0.0 },
            integral: integral.map_or(f64::INFINITY, |_| a / shares * (bound.force + 2.0 * moved)),
            mean_square: (a / shares).sqrt() * mean_square,
            panels: bound.panels,
        };
        found.solution.is_finite().then_some(found)
    }
}
