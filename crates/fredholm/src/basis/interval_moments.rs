//! Moments of a function on an interval with polynomials of any kind, by a rule that is exact for the products.

use super::{ChebyshevSeries, Function, chebyshev};
use crate::kernel::{Moments, SpectralRelation};
use crate::{Error, memory};

/// Most nodes of a rule.
const MOST_NODES: f64 = 1e8;

/// `f_k = int_L f phi_k ds`, `k < count`, for eigenfunctions that are polynomials of degree at most `degree_step k + 1` in `x`: `f` is
/// resolved on the interval as it is, and the rule of Clenshaw and Curtis is exact for the products.
///
/// For functions whose expansion in the eigenfunctions themselves converges slowly, since these are even or odd about a point to which `f` is
/// neither. Cost: `count` times the number of nodes, `degree_step count` and the degree of `f` together.
///
/// # Errors
/// [`Error::NotFinite`] when `f` is not finite at a node, [`Error::TooLarge`] beyond memory.
pub(crate) fn interval_moments(
    relation: &dyn SpectralRelation,
    f: &dyn Fn(f64) -> f64,
    count: usize,
    degree_step: usize,
) -> Result<Moments, Error> {
    let (centre, half) = (relation.interval().centre(), relation.interval().half_length());
    let function = Function::resolve(&|t| f(centre + half * t))?;
    let least = degree_step as f64 * count as f64 + function.series().degree() as f64 + 2.0;
    if least > MOST_NODES {
        let needed = (24.0 * least) as u64;
        return Err(Error::TooLarge { degree: count, needed, available: memory::available() });
    }
    let degree = (least as usize).next_power_of_two();
    let mut values = vec![0.0; count];
    let mut functions = vec![0.0; count];
    let weights = rule(degree);
    let samples = function.series().values(degree);
    for ((t, weight), sample) in chebyshev::points(degree).into_iter().zip(weights).zip(samples) {
        relation.eigenfunctions(centre + half * t, &mut functions);
        let factor = half * weight * sample;
        values.iter_mut().zip(&functions).for_each(|(value, phi)| *value += factor * phi);
    }
    Ok(Moments { values, error: function.error(), resolved: function.is_resolved() })
}

/// Weights of Clenshaw and Curtis at `cos(pi j/degree)`, `degree` even: the interpolating polynomial integrated.
fn rule(degree: usize) -> Vec<f64> {
    let ends = |k: usize| if k == 0 || k == degree { 0.5 } else { 1.0 };
    let integral = |k: usize| {
        if k.is_multiple_of(2) {
            let k = k as f64;
            -2.0 / ((k - 1.0) * (k + 1.0))
        } else {
            0.0
        }
    };
    let series = ChebyshevSeries::new((0..=degree).map(|k| ends(k) * integral(k)).collect());
    let scale = 2.0 / degree as f64;
    (series.values(degree).into_iter().enumerate()).map(|(j, w)| scale * ends(j) * w).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_integrates_polynomials() {
        let degree = 16;
        for power in 0..=degree {
            let points = chebyshev::points(degree);
            let found: f64 =
                points.iter().zip(rule(degree)).map(|(x, w)| w * x.powi(power as i32)).sum();
            let exact = if power % 2 == 0 { 2.0 / (power as f64 + 1.0) } else { 0.0 };
            assert!((found - exact).abs() < 1e-15, "{power}: {found} {exact}");
        }
    }
}
