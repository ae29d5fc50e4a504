//! Love's equation, `phi(x) + sign int_{-1}^{1} K(x, s) phi(s) ds = 1`, `K = (1/pi) kappa/(kappa^2 + (x - s)^2)`.

use std::f64::consts::PI;

use fredholm::collocation::solve_adaptive;
use fredholm::kernel::{ComputedRelation, Kernel, Singularity, SpectralRelation, Split};
use fredholm::{DegenerateSystem, Error, Interval};

/// Love's kernel; `kappa` is the distance of the disks in radii.
pub struct Love {
    /// `kappa`.
    pub separation: f64,
}

impl Kernel for Love {
    fn interval(&self) -> Interval {
        Interval::unit()
    }

    fn singularity(&self) -> Singularity {
        Singularity::None
    }

    fn split(&self, _x: f64, _s: f64, distance: f64) -> Split {
        let kappa = self.separation;
        Split { factor: 0.0, rest: kappa / (PI * (kappa * kappa + distance * distance)) }
    }

    fn is_even(&self) -> bool {
        true
    }
}

/// What the applications need of a solution.
#[derive(Debug, Clone, Copy)]
pub struct Integrals {
    /// `int phi dx`.
    pub zeroth: f64,
    /// `int x^2 phi dx`.
    pub second: f64,
    /// `phi(0)` and `phi(1)`.
    pub values: [f64; 2],
    /// Estimate of the largest error of `phi` over its largest value, or the share of the kernel that was left out.
    pub error: f64,
    /// Nodes, or eigenfunctions.
    pub count: usize,
}

/// By sinc collocation.
pub fn by_collocation(separation: f64, sign: f64) -> Result<Integrals, Error> {
    let found = solve_adaptive(&Love { separation }, sign, |_| 1.0, 1e-12)?;
    let phi = &found.solution;
    Ok(Integrals {
        zeroth: phi.integral(|_| 1.0),
        second: phi.integral(|x| x * x),
        values: [phi.evaluate(0.0, 1.0), phi.evaluate(1.0, 1.0)],
        error: found.estimate.solution / phi.values().iter().fold(0.0, |a: f64, b| a.max(b.abs())),
        count: 2 * found.half_count + 1,
    })
}

/// By the degenerate kernel, with computed eigenpairs: all that are not rounding, or `most`.
pub fn by_degenerate_kernel(separation: f64, sign: f64, most: usize) -> Result<Integrals, Error> {
    let relation = ComputedRelation::up_to(Love { separation }, most)?;
    let count = relation.available();
    let one = relation.moments(&|_| 1.0, count)?.values;
    let square = relation.moments(&|x| x * x, count)?.values;
    let phi = DegenerateSystem::new(&relation, sign, count - 1)?.solve(&one);
    // phi = 1 - sum c_n phi_n
    let less = |moments: &[f64]| -> f64 {
        phi.correction().iter().zip(moments).map(|(c, moment)| c * moment).sum()
    };
    Ok(Integrals {
        zeroth: 2.0 - less(&one),
        second: 2.0 / 3.0 - less(&square),
        values: [phi.evaluate(0.0, 1.0), phi.evaluate(1.0, 1.0)],
        error: relation.eigenvalue(count - 1) / relation.eigenvalue(0),
        count,
    })
}

/// Chebyshev coefficients `c_0, c_2, c_4, ...` of `phi` for `kappa = 1` as published. The sign 1: seven figures of the example of L. Fox and E. T. Goodwin (Phil. Trans. R. Soc. A 245 (1953)
/// 501); the sign -1: P. Abbott, The Mathematica Journal 8 (4), a series that ends with `T_8`. Both as transcribed in R. W. Marejka's program `integral-eqn`.
pub const PUBLISHED: [(f64, &[f64]); 2] = [
    (
        1.0,
        &[
            0.707_592_5,
            0.049_385_1,
            -0.001_047_5,
            -0.000_232_7,
            0.000_020_0,
            0.000_001_0,
            -0.000_000_2,
        ],
    ),
    (
        -1.0,
        &[
            1.774_444_805,
            -0.140_043_074_5,
            0.004_962_498_177,
            0.000_374_672_334_1,
            -0.000_043_686_508_86,
        ],
    ),
];

/// The sum of such a series.
pub fn published_series(coefficients: &[f64], x: f64) -> f64 {
    let angle = 2.0 * x.acos();
    coefficients.iter().zip(0..).map(|(c, k)| c * (f64::from(k) * angle).cos()).sum()
}

/// The charge of each disk at the potentials `V` and `-V` (sign -1) or `V` and `V` (sign 1): `Q/(2 V epsilon_0 a) = 2 int phi dx`, 4 for a lone disk. With the sign -1 it is the
/// capacitance `C/(epsilon_0 a)`.
pub fn capacitance(love: &Integrals) -> f64 {
    2.0 * love.zeroth
}

/// The capacitance of close disks: Kirchhoff's two terms and the third (S. J. N. Shaw; W. C. Chew and J. A. Kong, Math. Proc. Camb. Phil. Soc. 89 (1981) 373).
pub fn close_disks(kappa: f64) -> f64 {
    let logarithm = (16.0 * PI / kappa).ln();
    PI / kappa + (logarithm - 1.0) + kappa / (4.0 * PI) * (logarithm * logarithm - 2.0)
}

/// The ground state of the Lieb-Liniger gas with the largest rapidity `1/kappa` of the coupling: `gamma = 2 pi kappa/int phi dx` and the energy
/// `e = (gamma/kappa)^3 int x^2 phi dx/(2 pi)`, with the sign -1.
pub fn gas(separation: f64, love: &Integrals) -> [f64; 2] {
    let gamma = 2.0 * PI * separation / love.zeroth;
    [gamma, (gamma / separation).powi(3) * love.second / (2.0 * PI)]
}

/// `e(gamma)`, by the method given: `gamma` grows with `kappa`, which is found by the secant rule in logarithms.
pub fn energy(gamma: f64, method: impl Fn(f64) -> Result<Integrals, Error>) -> Result<f64, Error> {
    let state = |kappa: f64| method(kappa).map(|love| gas(kappa, &love));
    // The limits of weak and of strong coupling.
    let mut kappa = 0.5 * gamma.sqrt() + gamma / PI;
    let mut previous = (kappa * 0.9, state(kappa * 0.9)?);
    for _ in 0..40 {
        let current = (kappa, state(kappa)?);
        let slope = (current.1[0] / previous.1[0]).ln() / (current.0 / previous.0).ln();
        let step = (gamma / current.1[0]).ln() / slope;
        if step.abs() < 1e-9 {
            // The last step by the slope of the energy: d(ln e)/d(ln kappa).
            let rate = (current.1[1] / previous.1[1]).ln() / (current.0 / previous.0).ln();
            return Ok(current.1[1] * (rate * step).exp());
        }
        previous = current;
        kappa *= step.exp();
    }
    Err(Error::NotConverged { iterations: 40, residual: kappa, tolerance: 1e-9 })
}

/// The expansion for weak coupling up to `gamma^{5/2}`: the last coefficient found by S. Prolhac (arXiv:1610.08912) to 21 figures and identified by G. Lang.
pub fn weak_coupling(gamma: f64) -> f64 {
    const ZETA_3: f64 = 1.202_056_903_159_594_3;
    let root = gamma.sqrt();
    let quarter = (3.0 * ZETA_3 / 8.0 - 0.5) / PI.powi(3);
    gamma * (1.0 - 4.0 * root / (3.0 * PI) + (1.0 / 6.0 - 1.0 / (PI * PI)) * gamma)
        + quarter * gamma * gamma * root
}

/// The expansion for strong coupling up to `gamma^{-3}`.
pub fn strong_coupling(gamma: f64) -> f64 {
    let cubic = 32.0 * (PI * PI / 15.0 - 1.0);
    PI * PI / 3.0 * (1.0 - (4.0 - (12.0 + cubic / gamma) / gamma) / gamma)
}
