//! The map of the line to the half-line that crowds nodes at 0 only.

/// `x = ln(1 + e^w)/stretch`, `w = t - e^-t`: doubly exponential towards 0 (`ln x` falls as `-e^-t`), and linear far out, `x = t/stretch`. Lengths in
/// units of the decay length.
///
/// (H. Takahasi and M. Mori, Publ. RIMS 9 (1974) 721, for maps of this kind.)
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Map {
    stretch: f64,
}

/// The image of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Image {
    /// `x`, to full relative precision.
    pub(super) position: f64,
    /// `dx/dt`.
    pub(super) derivative: f64,
}

impl Map {
    pub(super) fn new(stretch: f64) -> Self {
        Self { stretch }
    }

    pub(super) fn at(self, t: f64) -> Image {
        let decline = (-t).exp();
        let w = t - decline;
        let position = if w > 0.0 { w + (-w).exp().ln_1p() } else { w.exp().ln_1p() };
        let derivative = (1.0 + decline) / (1.0 + (-w).exp());
        Image { position: position / self.stretch, derivative: derivative / self.stretch }
    }

    /// `t` of a point `x > 0`.
    pub(super) fn inverse(self, x: f64) -> f64 {
        let y = self.stretch * x;
        let w = if y > 1.0 { y + (-(-y).exp()).ln_1p() } else { y.exp_m1().ln() };
        // t - e^-t is concave and still negative at the start: Newton's steps climb to the root from the left.
        let mut t = if w < -1.0 { -(-w).ln() } else { w };
        for _ in 0..STEPS {
            let decline = (-t).exp();
            let step = (w - t + decline) / (1.0 + decline);
            t += step;
            if step.abs() <= f64::EPSILON * t.abs().max(0.1) {
                break;
            }
        }
        t
    }
}

/// Newton's method needs six.
const STEPS: usize = 20;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverts_itself() {
        for stretch in [0.01, 0.4, 1.0] {
            let map = Map::new(stretch);
            for i in -630..=4000 {
                let t = 0.01 * f64::from(i);
                let found = map.inverse(map.at(t).position);
                assert!((found - t).abs() < 4e-15 * (1.0 + t.abs()), "t = {t}: {found}");
            }
        }
    }

    #[test]
    fn derivative_agrees_with_differences() {
        let (map, step) = (Map::new(0.3), 1e-5);
        for t in [-1.3, -0.2, 0.0, 0.7, 1.9, 30.0] {
            let slope = (map.at(t + step).position - map.at(t - step).position) / (2.0 * step);
            let derivative = map.at(t).derivative;
            assert!((slope - derivative).abs() < 1e-8 * (1.0 + derivative));
        }
    }
}
