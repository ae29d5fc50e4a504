//! The law of the rough layer as a table whose points are joined by straight lines.

use super::conditions::check_share;
use crate::error::require;
use crate::{Error, Roughness};

/// Pressure against overclosure: points on the law, from zero on, which a finite-element program joins by straight lines.
///
/// A power law `v = B p^kappa` is concave, and a straight line between two of its points lies below it. Where the points have the overclosures `v_i = v(i/m)`, each
/// line is off by the same share when
///
/// `v(s) = v_r s^2` for `s <= 1`, `v_r exp(2 (s - 1))` beyond, `m = sqrt((1 - kappa)/(2 kappa share))`:
///
/// the distance of a chord of the length `h` from a curve is `h^2 |v''|/8`, which with `p = (v/B)^(1/kappa)` is `(1 - kappa)/(8 kappa) (dv)^2/v`; it is `share v_r` for the
/// squares, and `share v` for the exponential, with the same slope where they meet. The exponent is in the number of points only. `v_r` is the overclosure under the
/// reference pressure: below it the deviation is a share of `v_r`, as no straight line from zero is within a share of a power, and above it a share of the law itself.
/// That is the first term of the distance. The distance itself is known, too, and points are added until it is within the share.
///
/// ```
/// use shtaerman::Roughness;
/// use shtaerman::finite_elements::Overclosure;
///
/// let law = Roughness::power(1e-9, 0.4)?;
/// let table = Overclosure::new(law, [80e6, 2e9], 1e-3)?;      // reference and largest pressure (Pa)
/// let [pressure, overclosure] = table.points()[table.points().len() - 1];
/// assert_eq!([pressure, overclosure], [2e9, law.displacement(2e9)]);
///
/// // A linear law needs two points.
/// let linear = Overclosure::new(Roughness::from(1.2e-14), [80e6, 2e9], 1e-3)?;
/// assert_eq!(linear.points(), [[0.0, 0.0], [2e9, 1.2e-14 * 2e9]]);
/// # Ok::<(), shtaerman::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Overclosure {
    points: Vec<[f64; 2]>,
    deviation: f64,
}

impl Overclosure {
    /// The table from zero to a largest pressure, for the reference and the largest pressure (Pa) and the share of the law that straight lines may be off by.
    ///
    /// # Errors
    /// [`Error::InvalidValue`] for a smooth surface, a law out of range, pressures that are not positive and growing, a share outside of [`SHARES`](super::SHARES), and a share so small
    /// against the exponent that the first pressure is below the range of double precision.
    pub fn new(
        roughness: Roughness,
        [reference, largest]: [f64; 2],
        share: f64,
    ) -> Result<Self, Error> {
        check_share(share)?;
        roughness.check()?;
        let requirement = "finite and greater than zero";
        require(reference.is_finite() && reference > 0.0, "pressure", reference, requirement)?;
        let requirement = "finite and at least the reference pressure";
        require(largest.is_finite() && largest >= reference, "pressure", largest, requirement)?;
        match roughness {
            Roughness::Smooth => Err(Error::InvalidValue {
                field: "roughness",
                value: 0.0,
                requirement: "greater than zero: a smooth surface has no pressure-overclosure law; the curves of force and moment are known of it, too",
            }),
            Roughness::Linear { compliance } => {
                let points = vec![[0.0, 0.0], [largest, compliance * largest]];
                Ok(Self { points, deviation: 0.0 })
            }
            Roughness::Power { exponent, .. } => {
                let pressures = [reference, largest];
                let ends = pressures.map(|pressure| roughness.displacement(pressure));
                Self::graded(Power { exponent, pressures, ends }, share)
            }
        }
    }

    fn graded(power: Power, share: f64) -> Result<Self, Error> {
        let (exponent, last) = (power.exponent, power.last());
        let density = ((1.0 - exponent) / (2.0 * exponent * share)).sqrt();
        // One point besides zero would be a linear law to whoever reads the table.
        let mut count = (density * last).ceil().max(2.0) as usize;
        loop {
            let points = power.points(count);
            let requirement = "larger for so small an exponent: the first pressures of the table would be below the smallest number";
            require(points[1][0] >= f64::MIN_POSITIVE, "share", share, requirement)?;
            let deviation = power.deviation(&points);
            if deviation <= share {
                return Ok(Self { points, deviation });
            }
            // The deviation falls with the square of the count; what is missing is a term of higher order.
            count = (count + 1).max((count as f64 * (deviation / share).sqrt()).floor() as usize);
        }
    }

    /// Pressure (Pa) and overclosure (m), both from zero and growing.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The largest deviation of the straight lines from the law, as a share of the overclosure of the law, below the reference pressure of that under it; at most the share that was asked for.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        self.deviation
    }
}

/// A power law between zero and a largest pressure.
#[derive(Clone, Copy)]
struct Power {
    exponent: f64,
    /// The reference and the largest pressure (Pa).
    pressures: [f64; 2],
    /// The overclosures under them (m).
    ends: [f64; 2],
}

impl Power {
    /// `s` of the largest pressure.
    fn last(&self) -> f64 {
        1.0 + 0.5 * (self.ends[1] / self.ends[0]).ln()
    }

    /// So many intervals from zero to the largest pressure.
    fn points(&self, count: usize) -> Vec<[f64; 2]> {
        let last = self.last();
        let point = |index: usize| {
            if index == count {
                return [self.pressures[1], self.ends[1]];
            }
            let s = last * index as f64 / count as f64;
            // Under the reference overclosure.
            let grown = if s <= 1.0 { s * s } else { (2.0 * (s - 1.0)).exp() };
            [self.pressures[0] * grown.powf(1.0 / self.exponent), self.ends[0] * grown]
        };
        (0..=count).map(point).collect()
    }

    /// The largest share that a straight line is off by.
    fn deviation(&self, points: &[[f64; 2]]) -> f64 {
        let share = |pair: &[[f64; 2]]| {
            let [[from, below], [to, above]] = [pair[0], pair[1]];
            let distance = above * chord_distance(self.exponent, from / to, below / above);
            // The smallest overclosure of the interval: no share is larger than this one.
            distance / below.max(self.ends[0])
        };
        points.windows(2).map(share).fold(0.0, f64::max)
    }
}

/// How far `t^kappa` is above its chord from `(from, below)` to `(1, 1)` at most: where it has the slope of the chord.
fn chord_distance(exponent: f64, from: f64, below: f64) -> f64 {
    let slope = (1.0 - below) / (1.0 - from);
    let at = (slope / exponent).powf(1.0 / (exponent - 1.0));
    at.powf(exponent) - (1.0 + slope * (at - 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The overclosure of the table under a pressure, as a finite-element program has it.
    fn interpolated(points: &[[f64; 2]], pressure: f64) -> f64 {
        let above = points.partition_point(|point| point[0] < pressure).clamp(1, points.len() - 1);
        let [[p0, v0], [p1, v1]] = [points[above - 1], points[above]];
        v0 + (v1 - v0) * (pressure - p0) / (p1 - p0)
    }

    /// Sampled between all points, the lines are as far from the law as is stated, and not closer by much: no point too many.
    #[test]
    fn lines_are_within_the_share_of_the_law_and_not_by_much() {
        for exponent in [0.05, 0.15, 0.4, 0.6, 0.9, 0.99] {
            for share in [1e-1, 1e-2, 1e-3, 1e-5] {
                for span in [1.0, 3.0, 40.0, 1e4] {
                    let law = Roughness::power(3e-9, exponent).unwrap();
                    let reference = 7e7;
                    let Ok(table) = Overclosure::new(law, [reference, span * reference], share)
                    else {
                        assert!(exponent < 0.1, "{exponent} {share}");
                        continue;
                    };
                    let mut worst = 0.0f64;
                    for pair in table.points().windows(2) {
                        assert!(pair[1][0] > pair[0][0] && pair[1][1] > pair[0][1]);
                        for step in 0..=400 {
                            // Denser at the lower end, where the law is steepest.
                            let t = (f64::from(step) / 400.0).powi(3);
                            let pressure = pair[0][0] + t * (pair[1][0] - pair[0][0]);
                            let exact = law.displacement(pressure);
                            let off = (interpolated(table.points(), pressure) - exact).abs();
                            worst = worst.max(off / exact.max(law.displacement(reference)));
                        }
                    }
                    let context = format!("{exponent} {share} {span}: {worst}");
                    assert!(worst <= table.deviation() + 1e-14, "{context}");
                    assert!(table.deviation() <= share, "{context}");
                    // Few intervals are rounded up to whole ones, and fewer than two would be a linear law.
                    let wanted = match table.points().len() {
                        ..=3 => 0.0,
                        4..=20 => 0.02,
                        _ => 0.7,
                    };
                    assert!(worst > wanted * share, "{context}, {} points", table.points().len());
                }
            }
        }
    }

    #[test]
    fn the_first_overclosures_are_the_squares() {
        let law = Roughness::power(1e-9, 0.4).unwrap();
        let table = Overclosure::new(law, [80e6, 80e6], 1e-3).unwrap();
        let points = table.points();
        let m = points.len() - 1;
        // sqrt(0.6/(0.8e-3)) = 27.4
        assert_eq!(m, 28);
        for (i, [_, v]) in points.iter().enumerate() {
            let square = law.displacement(80e6) * (i as f64 / m as f64).powi(2);
            assert!((v - square).abs() <= 1e-15 * square);
        }
    }

    /// Two points besides zero give the exponent back.
    #[test]
    fn a_power_law_stays_one_in_the_coarsest_table() {
        for exponent in [0.9, 0.99, 0.999, 0.999_999] {
            let law = Roughness::power(1e-12, exponent).unwrap();
            let table = Overclosure::new(law, [80e6, 2e9], 0.1).unwrap();
            let [.., [p0, v0], [p1, v1]] = table.points() else { panic!("{exponent}") };
            assert!(*p0 > 0.0, "{exponent}: {:?}", table.points());
            let found = (v1 / v0).ln() / (p1 / p0).ln();
            assert!((found - exponent).abs() < 1e-14, "{exponent}: {found}");
        }
    }

    #[test]
    fn refuses_what_makes_no_table() {
        let law = Roughness::power(1e-9, 0.4).unwrap();
        for (law, pressures, share) in [
            (Roughness::Smooth, [1.0, 2.0], 1e-3),
            (Roughness::Linear { compliance: -1.0 }, [1.0, 2.0], 1e-3),
            (law, [0.0, 2.0], 1e-3),
            (law, [3.0, 2.0], 1e-3),
            (law, [1.0, f64::INFINITY], 1e-3),
            (law, [1.0, f64::NAN], 1e-3),
            (law, [1.0, 2.0], 0.0),
            (law, [1.0, 2.0], 0.6),
            (law, [1.0, 2.0], f64::NAN),
            (Roughness::power(1e-9, 0.01).unwrap(), [1.0, 2.0], 1e-5),
        ] {
            assert!(
                Overclosure::new(law, pressures, share).is_err(),
                "{law:?} {pressures:?} {share}"
            );
        }
    }
}
