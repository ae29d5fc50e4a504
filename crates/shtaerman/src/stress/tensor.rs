//! Stress at a point and what criteria of yield make of it.

use serde::Serialize;

/// Stress in plane strain at a point, tension positive, in the units of the problem; `y` is depth.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Stress {
    /// Along the surface.
    pub sigma_x: f64,
    /// Along the depth.
    pub sigma_y: f64,
    /// Out of the plane: `nu (sigma_x + sigma_y)`.
    pub sigma_z: f64,
    /// Shear stress; positive where the face of outward normal `+x` is pushed downwards.
    pub tau_xy: f64,
}

impl Stress {
    /// The principal stresses, the largest (most tensile) first.
    #[must_use]
    pub fn principal(&self) -> [f64; 3] {
        let mean = 0.5 * (self.sigma_x + self.sigma_y);
        let radius = self.in_plane_shear();
        let mut stresses = [mean + radius, mean - radius, self.sigma_z];
        stresses.sort_by(f64::total_cmp);
        stresses.reverse();
        stresses
    }

    /// Largest shear stress in the plane, the radius of Mohr's circle.
    #[must_use]
    pub fn in_plane_shear(&self) -> f64 {
        (0.5 * (self.sigma_x - self.sigma_y)).hypot(self.tau_xy)
    }

    /// Largest shear stress: half of [`Stress::tresca`].
    #[must_use]
    pub fn max_shear(&self) -> f64 {
        0.5 * self.tresca()
    }

    /// Equivalent stress of Tresca: the largest difference of principal stresses.
    #[must_use]
    pub fn tresca(&self) -> f64 {
        let [largest, _, least] = self.principal();
        largest - least
    }

    /// Equivalent stress of von Mises.
    #[must_use]
    pub fn von_mises(&self) -> f64 {
        let shear = self.in_plane_shear();
        let across = 0.5 * (self.sigma_x + self.sigma_y) - self.sigma_z;
        (3f64.sqrt() * shear).hypot(across)
    }

    /// All components times a factor.
    #[must_use]
    pub(super) fn scaled(self, by: f64) -> Self {
        Self {
            sigma_x: by * self.sigma_x,
            sigma_y: by * self.sigma_y,
            sigma_z: by * self.sigma_z,
            tau_xy: by * self.tau_xy,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn criteria_of_a_general_state_are_those_of_its_invariants() {
        let stress = Stress { sigma_x: 3.0, sigma_y: -5.0, sigma_z: -0.6, tau_xy: 2.5 };
        let Stress { sigma_x, sigma_y, sigma_z, tau_xy } = stress;
        let [one, two, three] = stress.principal();
        assert!((one + two + three - (sigma_x + sigma_y + sigma_z)).abs() < 1e-14);
        let determinant = sigma_z * (sigma_x * sigma_y - tau_xy * tau_xy);
        assert!((one * two * three - determinant).abs() < 1e-12);
        let squares =
            (sigma_x - sigma_y).powi(2) + (sigma_y - sigma_z).powi(2) + (sigma_z - sigma_x).powi(2);
        let expected = (0.5 * squares + 3.0 * tau_xy * tau_xy).sqrt();
        assert!((stress.von_mises() - expected).abs() < 1e-14);
        assert_eq!(stress.tresca(), one - three);
        assert_eq!(stress.max_shear(), 0.5 * (one - three));
    }
}
