//! Expansions in `1/theta0` from three values, the last two of which give the value and the first two its error.

/// `theta0` of the values, or the values.
pub(super) type Three = [f64; 3];

/// A value with the estimate of its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fitted {
    pub(super) value: f64,
    pub(super) error: f64,
}

/// `q0 + (A ln t + B)/t` at `t = theta0`, by the last two values.
pub(super) fn beside_limit(limit: f64, values: Three, at: Three, theta0: f64) -> Fitted {
    let change = |i: usize| {
        let [one, two] = [i, i + 1].map(|i| (values[i] - limit) * at[i]);
        let slope = (two - one) / (at[i + 1] / at[i]).ln();
        (one + slope * (theta0 / at[i]).ln()) / theta0
    };
    let (fine, coarse) = (change(1), change(0));
    Fitted { value: limit + fine, error: (fine - coarse).abs() }
}

/// `q0 + (A ln t + B)/t` at `t = theta0` through three values.
pub(super) fn through(values: Three, at: Three, theta0: f64) -> f64 {
    let log = |i: usize| at[i].ln() / at[i];
    // Differences hold A and B alone.
    let row =
        |i: usize| [log(i + 1) - log(i), 1.0 / at[i + 1] - 1.0 / at[i], values[i + 1] - values[i]];
    let ([a, b, r], [c, d, q]) = (row(0), row(1));
    let determinant = a * d - b * c;
    let slope = (r * d - b * q) / determinant;
    let offset = (a * q - r * c) / determinant;
    values[2] + slope * (theta0.ln() / theta0 - log(2)) + offset * (1.0 / theta0 - 1.0 / at[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    const AT: Three = [1e4, 1e5, 1e6];

    #[test]
    fn the_form_is_reproduced() {
        let q = |t: f64| 0.7 + (0.3 * t.ln() - 2.0) / t;
        for theta0 in [1e6, 1e8, 1e12] {
            let values = AT.map(q);
            let fitted = beside_limit(0.7, values, AT, theta0);
            assert!((fitted.value - q(theta0)).abs() < 1e-14, "{theta0}: {fitted:?}");
            assert!(fitted.error < 1e-13, "{theta0}: {fitted:?}");
            assert!((through(values, AT, theta0) - q(theta0)).abs() < 1e-14, "{theta0}");
        }
    }

    #[test]
    fn the_error_covers_the_next_term() {
        let q = |t: f64| 0.7 + (0.3 * t.ln() - 2.0) / t + (t.ln() / t).powi(2);
        for theta0 in [2e6, 1e8] {
            let fitted = beside_limit(0.7, AT.map(q), AT, theta0);
            let error = (fitted.value - q(theta0)).abs();
            assert!(error <= fitted.error && fitted.error < 1e-7, "{error:e} {fitted:?}");
        }
    }
}
