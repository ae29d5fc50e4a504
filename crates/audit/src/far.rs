//! Panels that lie together, seen from afar by their moments.

use crate::allowance::UNIT;
use crate::elementary::{exp, ln};
use crate::kernel::Singularity;
use crate::legendre::{MOMENTS, RULE};
use crate::panel::Panel;
use crate::sum::{Sum, two_product, two_sum};
use crate::vectorised::vectorised;

/// Clusters farther from a place than this many of their radii are seen by their moments.
pub(crate) const FAR: f64 = 3.0;
/// Terms are left out where they have fallen by `exp(-SMALL)`, for the logarithm relative to the mass of all panels instead of this cluster's.
const SMALL: f64 = 40.0;
/// Moments that are summed over the panels with compensation: the others are shifted from cluster to cluster, and count for 3^-4 at most.
const DIRECT: usize = 4;

/// Panels that lie together.
#[derive(Debug, Clone)]
pub(crate) struct Cluster {
    pub(crate) first: usize,
    pub(crate) last: usize,
    pub(crate) centre: f64,
    pub(crate) radius: f64,
    /// `int q ((t - c)/r)^k`, and what the first loses.
    moments: [f64; MOMENTS],
    lost: f64,
    /// The moments with the factors of the expansion of the kernel.
    weighted: [f64; MOMENTS],
    pub(crate) mass: f64,
    pub(crate) largest: f64,
    pub(crate) children: Option<[usize; 2]>,
}

impl Cluster {
    /// The cluster of some panels, from its parts where it has some.
    pub(crate) fn new(
        all: &[Panel],
        [first, last]: [usize; 2],
        parts: Option<([usize; 2], [&Self; 2])>,
        singularity: Singularity,
    ) -> Self {
        let panels = &all[first..last];
        let (left, right) = (all[first].left, all[last - 1].right);
        let centre = 0.5 * (left + right);
        let radius = (right - centre).max(centre - left);
        let mut moments = [0.0; MOMENTS];
        match parts {
            Some((_, children)) => {
                for child in children {
                    let offset = (child.centre - centre) / radius;
                    shift(&child.moments, child.radius / radius, offset, &mut moments);
                }
            }
            None => {
                for panel in panels {
                    let own = RULE.moments(&panel.coefficients).map(|moment| moment * panel.half());
                    shift(&own, panel.half() / radius, offset(panel, centre, radius), &mut moments);
                }
            }
        }
        let [direct, lost] = low_moments(panels, centre, radius);
        moments[..DIRECT].copy_from_slice(&direct);
        Self {
            first,
            last,
            centre,
            radius,
            weighted: weighted(&moments, singularity),
            moments,
            lost: lost[0],
            mass: panels.iter().map(Panel::mass).sum(),
            largest: panels.iter().fold(0.0, |most, panel| most.max(panel.largest)),
            children: parts.map(|(children, _)| children),
        }
    }

    /// `int q`.
    pub(crate) fn integral(&self) -> f64 {
        self.moments[0] + self.lost
    }

    /// Its potential, and roundings in units of the machine, at places that are `from_centre + offset` from its centre, at least `distance >= FAR r`, `total` the mass of all panels.
    ///
    /// `ln|x - t| = ln|d| - sum (y/d)^k/k` and `|x - t|^-mu = |d|^-mu sum (mu)_k/k! (y/d)^k`, `d = x - c`, `y = t - c`.
    ///
    /// Roundings in units of the machine: of the mass and its logarithm `3 ln|d| + 1`; of the first moments 5 each, of the others as many as there were shifts (at most
    /// sixteen), three for a degree, all with `3^-k/k`: together less than 5; of Horner's scheme 5 times its value. A power is off by as many as its logarithm, and 4.
    #[inline(always)]
    pub(crate) fn potentials<const N: usize>(
        &self,
        singularity: Singularity,
        from_centre: f64,
        offsets: &[f64; N],
        distance: f64,
        total: f64,
    ) -> [[f64; N]; 2] {
        let least = distance / self.radius;
        let fallen = match singularity {
            Singularity::Logarithm => SMALL + (self.mass / total).ln(),
            Singularity::Power(_) => SMALL,
        };
        let terms = ((fallen / least.ln()).ceil() as usize).clamp(2, MOMENTS - 1);
        // The sum of q^-k over k > n is q^-n/(q - 1), q >= 3.
        let left_out = 0.5 * self.mass * least.powi(-(terms as i32)) / UNIT;
        let [mut inverses, mut distances, mut sums] = [[0.0; N]; 3];
        for i in 0..N {
            distances[i] = from_centre + offsets[i];
            inverses[i] = self.radius / distances[i];
        }
        for moment in self.weighted[1..=terms].iter().rev() {
            for i in 0..N {
                sums[i] = inverses[i] * (moment + sums[i]);
            }
        }
        let logarithms = ln(&distances);
        let [mut values, mut roundings] = [[0.0; N]; 2];
        match singularity {
            Singularity::Logarithm => {
                for i in 0..N {
                    let scale = logarithms[i];
                    values[i] = self.moments[0] * scale + (self.lost * scale - sums[i]);
                    roundings[i] =
                        self.mass * (3.0 * scale.abs() + 6.0) + 5.0 * sums[i].abs() + left_out;
                }
            }
            Singularity::Power(mu) => {
                let mut powers = logarithms;
                for power in &mut powers {
                    *power *= -mu;
                }
                let scales = exp(&powers);
                for i in 0..N {
                    let whole = self.moments[0] + (self.lost + sums[i]);
                    let off = 8.0 + 3.0 * mu * logarithms[i].abs();
                    values[i] = scales[i] * whole;
                    roundings[i] = scales[i] * (off * whole.abs() + 9.0 * self.mass + left_out);
                }
            }
        }
        [values, roundings]
    }
}

/// The middle of a panel as a cluster has it, by differences that keep their digits.
fn offset(panel: &Panel, centre: f64, radius: f64) -> f64 {
    0.5 * ((panel.left - centre) + (panel.right - centre)) / radius
}

/// The lowest moments from the panels themselves, with what their sums lose.
fn low_moments(panels: &[Panel], centre: f64, radius: f64) -> [[f64; DIRECT]; 2] {
    let mut sums: [Sum; DIRECT] = Default::default();
    for panel in panels {
        let (half, c) = (panel.half(), &panel.coefficients);
        // int q = c_0 (right - left), without rounding
        let (width, lost) = two_sum(panel.right, -panel.left);
        let (mass, error) = two_product(c[0], width);
        sums[0].add(mass);
        sums[0].add(error + c[0] * lost);
        let o = offset(panel, centre, radius);
        let r = half / radius;
        let first = half * (2.0 / 3.0 * c[1]);
        let second = half * (2.0 / 3.0 * c[0] + 4.0 / 15.0 * c[2]);
        let third = half * (2.0 / 5.0 * c[1] + 4.0 / 35.0 * c[3]);
        sums[1].add(mass * o + first * r);
        sums[2].add(mass * o * o + 2.0 * first * o * r + second * r * r);
        sums[3].add(
            mass * o * o * o
                + 3.0 * first * o * o * r
                + 3.0 * second * o * r * r
                + third * r * r * r,
        );
    }
    [sums.each_ref().map(|sum| sum.parts().0), sums.each_ref().map(|sum| sum.parts().1)]
}

/// Adds the moments of a part, `int q ((t - c')/r')^k` from `int q ((t - c)/r)^k`, with `ratio = r/r'` and `offset = (c - c')/r'`.
fn shift(moments: &[f64; MOMENTS], ratio: f64, offset: f64, into: &mut [f64; MOMENTS]) {
    vectorised(
        #[inline(always)]
        || {
            // Horner's scheme on the binomials: (offset + ratio t)^k, one power after the other.
            let mut row = *moments;
            into[0] += row[0];
            for (k, into) in into.iter_mut().enumerate().skip(1) {
                // row[j] = int q (offset + ratio t)^k t^j, of which those up to MOMENTS - 1 - k count.
                let last = MOMENTS - k;
                for j in 0..last {
                    row[j] = offset * row[j] + ratio * row[j + 1];
                }
                *into += row[0];
            }
        },
    );
}

/// The moments with the factors of the expansion of the kernel: `1/k` of the logarithm, `(mu)_k/k!` of the power.
fn weighted(moments: &[f64; MOMENTS], singularity: Singularity) -> [f64; MOMENTS] {
    let mut factor = 1.0;
    let mut weighted = *moments;
    for (k, entry) in weighted.iter_mut().enumerate().skip(1) {
        let n = k as f64;
        match singularity {
            Singularity::Logarithm => factor = 1.0 / n,
            Singularity::Power(mu) => factor *= (mu + n - 1.0) / n,
        }
        *entry *= factor;
    }
    weighted
}
