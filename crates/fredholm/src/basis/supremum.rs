//! An upper bound of a polynomial on the whole interval.

use std::f64::consts::FRAC_PI_2;

use super::ChebyshevSeries;

/// The sum of the absolute coefficients is taken as it is where it exceeds the larger end value by no more than this.
const ATTAINED: f64 = 1.02;
/// Points of the grid per degree of the polynomial.
const DENSITY: usize = 4;

impl ChebyshevSeries {
    /// The largest `|f(x)|` of a grid of at least eight points per degree: at most 2 % below that of all `x`, by the same theorem of Riesz as the bound below.
    #[must_use]
    pub(crate) fn largest_value(&self) -> f64 {
        let grid = (2 * DENSITY * self.degree().max(1)).next_power_of_two();
        (self.values(grid).iter()).fold(0.0f64, |most, value| most.max(value.abs()))
    }

    /// An upper bound of `max |f(x)|` over `[-1, 1]`, at most 1.083 times that maximum.
    ///
    /// It is the smaller of `sum |c_m|` and `max_j |f(x_j)| / cos(pi degree / (2 L))` over the `L + 1` points of a Chebyshev
    /// grid, `L >= 4 degree`: around its maximum a trigonometric polynomial of degree `n` stays above the cosine of
    /// `n` times the distance (M. Riesz, Jahresber. DMV 23 (1914) 354).
    ///
    /// Cost: one cosine transform of length `4 degree` to `8 degree`, or nothing where the first bound is attained at an end.
    #[must_use]
    pub fn supremum_bound(&self) -> f64 {
        let c = self.coefficients();
        let sum: f64 = c.iter().map(|c| c.abs()).sum();
        let even: f64 = c.iter().step_by(2).sum();
        let odd: f64 = c.iter().skip(1).step_by(2).sum();
        // The larger of |f(1)| and |f(-1)|.
        let attained = even.abs() + odd.abs();
        let degree = c.iter().rposition(|&c| c != 0.0).unwrap_or(0);
        if degree == 0 || sum <= ATTAINED * attained || !sum.is_finite() {
            return sum;
        }
        let grid = (DENSITY * degree).next_power_of_two();
        let largest = (self.values(grid).iter()).fold(0.0f64, |most, value| most.max(value.abs()));
        sum.min(largest / (FRAC_PI_2 * degree as f64 / grid as f64).cos())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_polynomials_and_not_much_more() {
        for (degree, phase) in [(1usize, 0.3), (5, 0.1), (17, 2.0), (64, 0.7), (200, 1.4)] {
            let coefficients: Vec<f64> =
                (0..=degree).map(|j| (1.9 * j as f64 + phase).sin()).collect();
            let series = ChebyshevSeries::new(coefficients);
            let largest = (series.values(64 * degree).iter())
                .fold(0.0f64, |most, value| most.max(value.abs()));
            let bound = series.supremum_bound();
            assert!(bound >= largest && bound <= 1.09 * largest, "{degree}: {bound} {largest}");
        }
    }

    #[test]
    fn the_grid_alone_would_not_be_a_bound() {
        // A polynomial whose maximum lies between the grid points: shifted phases reach it.
        let mut worst = 0.0f64;
        for i in 0..200 {
            let phase = 0.03 * f64::from(i);
            let series = ChebyshevSeries::new(vec![0.0, phase.cos(), 0.0, phase.sin()]);
            let grid = series.values(16).iter().fold(0.0f64, |most, value| most.max(value.abs()));
            let fine = series.values(4096).iter().fold(0.0f64, |most, value| most.max(value.abs()));
            worst = worst.max(fine / grid);
            assert!(series.supremum_bound() >= fine * (1.0 - 1e-15));
        }
        assert!(worst > 1.01);
    }

    #[test]
    fn constants_and_nothing() {
        assert_eq!(ChebyshevSeries::new(vec![-2.0]).supremum_bound(), 2.0);
        assert_eq!(ChebyshevSeries::default().supremum_bound(), 0.0);
    }
}
