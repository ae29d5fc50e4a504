//! What interpolation on a window misses of potentials.

use crate::kernel::Singularity;

/// `int |sigma|` over a disk's diameter from any of its points; the logarithm relative to the disk's radius, since interpolation gives back the constant that this leaves.
pub(crate) fn local_mass(singularity: Singularity, disk: f64) -> f64 {
    match singularity {
        Singularity::Logarithm => 2.0 * disk,
        Singularity::Power(mu) => 4.0 * disk.powf(1.0 - mu) / (1.0 - mu),
    }
}

/// A bound of the potential of a density of size one on the diameter, continued into the disk: along straight paths from either end, the logarithm relative to the disk's radius.
pub(crate) fn local_potential(singularity: Singularity, disk: f64) -> f64 {
    match singularity {
        Singularity::Logarithm => 13.2 * disk,
        Singularity::Power(mu) => 2.0 * (2.0 * disk).powf(1.0 - mu) / (1.0 - mu),
    }
}

/// A part of the density outside the disk of a window.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Part {
    /// The least distance from the middle of the window.
    distance: f64,
    mass: f64,
    /// What the mass within a tenth of the distance, say, cannot exceed: its largest density, on as many sides as it may lie.
    dense: f64,
    /// `1/rho`, and its part in a term of a power: they are the same for all numbers of nodes.
    inverse: f64,
    scale: f64,
}

impl Part {
    /// A part at a distance; what of it is inside the disk is seen to otherwise.
    pub(crate) fn new(
        singularity: Singularity,
        (distance, disk, r): (f64, f64, f64),
        mass: f64,
        largest: f64,
    ) -> Self {
        let sides = if distance < disk { 2.0 } else { 1.0 };
        let distance = distance.max(disk);
        let d = distance / r;
        let inverse = 1.0 / (d + (d * d - 1.0).max(0.0).sqrt());
        let scale = match singularity {
            Singularity::Logarithm => 1.0,
            Singularity::Power(mu) => (0.5 * r / inverse).powf(-mu),
        };
        Self { distance, mass, dense: sides * largest, inverse, scale }
    }
}

/// What interpolation of the potential of parts of the density misses.
///
/// `ln|x - t| = const - 2 sum rho^-k T_k(x)/k` and `|x - t|^-mu = (r rho/2)^-mu sum C_k^mu(x) rho^-k`, with `rho = D + sqrt(D^2 - 1)`, `D = |t - c|/r`: nodes alias each term to at most
/// its own size. These fall at least as `D^-n`, so that of a part that begins at the distance `d` the mass counts at most as `d/(n - 1)` times its density. The images of a row that are more
/// than one period away add less than a tenth. The sum ends where it exceeds `most`.
pub(crate) fn outside(parts: &[Part], singularity: Singularity, count: usize, most: f64) -> f64 {
    let n = count as f64;
    let mut sum = 0.0;
    for part in parts {
        let inverse = part.inverse;
        let fallen = inverse.powi(count as i32);
        let mass = part.mass.min(part.dense * part.distance / (n - 1.0));
        sum += mass
            * match singularity {
                Singularity::Logarithm => 4.0 * fallen / (n * (1.0 - inverse)),
                Singularity::Power(_) => {
                    let rest = (n + 1.0) / (1.0 - inverse) + inverse / (1.0 - inverse).powi(2);
                    2.0 * part.scale * fallen * rest
                }
            };
        if sum > most {
            break;
        }
    }
    1.1 * sum
}
