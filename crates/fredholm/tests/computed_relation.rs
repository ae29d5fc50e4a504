//! Computed eigenpairs against known spectra.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;

use fredholm::kernel::{
    ComputedRelation, Kernel, Logarithm, Parity, Power, Singularity, SpectralRelation, Split,
};
use fredholm::quadrature::double_exponential;
use fredholm::{DegenerateSystem, Error, Interval, SincOperator};

/// A smooth kernel from a function.
struct Smooth<F> {
    interval: Interval,
    even: bool,
    value: F,
}

impl<F: Fn(f64, f64) -> f64> Smooth<F> {
    fn new(value: F) -> Self {
        Self { interval: Interval::unit(), even: false, value }
    }
}

impl<F: Fn(f64, f64) -> f64 + Send + Sync> Kernel for Smooth<F> {
    fn interval(&self) -> Interval {
        self.interval
    }
    fn singularity(&self) -> Singularity {
        Singularity::None
    }
    fn split(&self, x: f64, s: f64, _distance: f64) -> Split {
        Split { factor: 0.0, rest: (self.value)(x, s) }
    }
    fn is_even(&self) -> bool {
        self.even
    }
}

/// The first Legendre polynomials, orthonormal.
fn legendre(x: f64) -> [f64; 4] {
    [
        0.5f64.sqrt(),
        1.5f64.sqrt() * x,
        2.5f64.sqrt() * 0.5 * (3.0 * x * x - 1.0),
        3.5f64.sqrt() * 0.5 * x * (5.0 * x * x - 3.0),
    ]
}

#[test]
fn finite_rank_and_both_signs() {
    // By falling magnitude: P_1, P_2, P_3, P_0.
    let factors = [0.25, -3.0, 2.0, -1.0];
    let value = |x: f64, s: f64| -> f64 {
        let (p, q) = (legendre(x), legendre(s));
        (0..4).map(|n| factors[n] * p[n] * q[n]).sum()
    };
    for even in [false, true] {
        let relation = ComputedRelation::up_to(Smooth { even, ..Smooth::new(value) }, 50).unwrap();
        assert_eq!(relation.available(), 4);
        assert!(relation.defect() < 1e-14);
        // P_1, P_2, P_3 alternate from odd, P_0 comes last: no alternation from even.
        assert_eq!(relation.parity(), Parity::None);
        for (n, degree) in [1, 2, 3, 0].into_iter().enumerate() {
            assert!((relation.eigenvalue(n) - factors[degree]).abs() < 1e-14);
            for x in [-1.0, -0.4, 0.123, 1.0] {
                let mut phi = [0.0; 4];
                relation.eigenfunctions(x, &mut phi);
                assert!((phi[n] - legendre(x)[degree]).abs() < 1e-13, "{n} {x}: {phi:?}");
            }
        }
        // phi + lambda K phi = f term by term, beyond the singular parameter 1/3.
        let lambda = 0.7;
        let f = |x: f64| legendre(x).iter().sum::<f64>();
        let system = DegenerateSystem::new(&relation, lambda, 3).unwrap();
        let phi = system.solve(&relation.moments(&f, 4).unwrap().values);
        for x in [-1.0, 0.3, 0.9] {
            let exact: f64 =
                legendre(x).iter().zip(factors).map(|(p, nu)| p / (1.0 + lambda * nu)).sum();
            assert!((phi.evaluate(x, f(x)) - exact).abs() < 1e-13);
        }
        assert!(matches!(
            DegenerateSystem::new(&relation, 1.0 / 3.0, 3),
            Err(Error::Singular { .. })
        ));
    }
}

#[test]
fn prolate_spheroidal_functions() {
    // D. Slepian and H. O. Pollak, Bell System Technical Journal 40 (1961) 43, Table I, with more digits by mpmath from the tridiagonal problem.
    let table: [(f64, &[f64]); 2] = [
        (
            1.0,
            &[
                0.572_581_780_637_895_1,
                0.062_791_274_149_803_33,
                1.237_479_328_465_996_7e-3,
                9.200_977_049_568_926e-6,
                3.717_928_558_065_550_2e-8,
                9.491_436_733_967_157e-11,
                1.671_571_583_352_259e-13,
            ],
        ),
        (
            4.0,
            &[
                0.995_885_490_429_667_3,
                0.912_107_424_065_024_6,
                0.519_054_837_454_311_4,
                0.110_210_987_014_802_31,
                8.827_876_397_692_435e-3,
                3.812_917_217_242_188e-4,
                1.095_087_126_962_383e-5,
                2.278_638_895_456_513_6e-7,
                3.606_549_342_515_116e-9,
            ],
        ),
    ];
    for (c, eigenvalues) in table {
        let sinc = move |x: f64, s: f64| {
            let d = x - s;
            if d == 0.0 { c / PI } else { (c * d).sin() / (PI * d) }
        };
        for even in [false, true] {
            let kernel = Smooth { even, ..Smooth::new(sinc) };
            let relation = ComputedRelation::new(kernel, eigenvalues.len()).unwrap();
            for (n, exact) in eigenvalues.iter().enumerate() {
                assert!((relation.eigenvalue(n) - exact).abs() < 3e-15, "{c} {n}");
            }
            let parity = if even { Parity::Alternating } else { Parity::None };
            assert_eq!(relation.parity(), parity);
        }
    }
}

#[test]
fn the_logarithm_against_the_spectral_relation_of_the_paper() {
    // One operator: its eigenvalues in plain L2 are those of the paper's infinite matrix sqrt(D) R sqrt(D).
    let kernel = Logarithm::unit();
    let relation = ComputedRelation::new(kernel, 60).unwrap();
    assert!(relation.defect() < 1e-12);
    let degree = 600;
    // The trace of the square, sum nu^2 = int int ln^2|x-s| dx ds, and that of the matrix.
    let square: f64 = (0..60).map(|n| relation.eigenvalue(n).powi(2)).sum();
    let exact = {
        // 2 int_0^2 (2 - d) ln^2 d dd
        let l = 2f64.ln();
        2.0 * (2.0 * (2.0 * l * l - 4.0 * l + 4.0) - (2.0 * l * l - 2.0 * l + 1.0))
    };
    // nu_n falls as 2/n: beyond 60 there remain about 4/60.
    let tail = exact - square;
    assert!((0.03..0.08).contains(&tail), "{square} {exact}");
    // Rayleigh's quotient <phi_n, K phi_n> = sum D_m (int T_m phi_n dx)^2 by the paper's expansion.
    for n in [0, 1, 2, 5, 17] {
        let mut moments = vec![0.0; degree + 1];
        let (mut phi, mut polynomials) = (vec![0.0; n + 1], vec![0.0; degree + 1]);
        for node in double_exponential(1000) {
            relation.eigenfunctions(node.position, &mut phi);
            kernel.eigenfunctions(node.position, &mut polynomials);
            moments.iter_mut().zip(&polynomials).for_each(|(f, t)| *f += node.weight * phi[n] * t);
        }
        let quotient: f64 =
            moments.iter().enumerate().map(|(m, f)| kernel.expansion_factor(m) * f * f).sum();
        assert!((quotient - relation.eigenvalue(n)).abs() < 1e-5, "{n}: {quotient}");
    }
    let spectrum = SincOperator::new(&kernel, 300).unwrap();
    let mut expected = spectrum.spectrum().unwrap().eigenvalues();
    expected.reverse();
    for (n, exact) in expected.iter().take(60).enumerate() {
        assert!((relation.eigenvalue(n) - exact).abs() < 1e-12, "{n}");
    }
}

#[test]
fn singular_kernels_converge_to_collocation() {
    let power = Power::new(Interval::new(0.5, 2.0).unwrap(), 0.3).unwrap();
    let f = |x: f64| x.sin();
    let operator = SincOperator::new(&power, 120).unwrap();
    let exact = &operator.solve(0.8, &[operator.sample(f).unwrap()]).unwrap()[0];
    let errors = [15, 30, 60].map(|count| {
        let relation = ComputedRelation::new(power, count).unwrap();
        let system = DegenerateSystem::new(&relation, 0.8, count - 1).unwrap();
        let moments = relation.moments(&f, count).unwrap();
        assert!(moments.resolved);
        let phi = system.solve(&moments.values);
        (phi.evaluate(1.1, f(1.1)) - exact.evaluate(1.1, f(1.1))).abs()
    });
    assert!(errors[2] < 1e-3 && errors[2] < 0.6 * errors[0], "{errors:?}");
}

#[test]
fn a_measure_and_an_interval_off_the_middle() {
    /// `x s` on `(0, 1)` with `dm = s ds`: one eigenvalue, `int s^2 s ds = 1/4`, and `phi = 2x`.
    struct Disk;
    impl Kernel for Disk {
        fn interval(&self) -> Interval {
            Interval::new(0.0, 1.0).unwrap()
        }
        fn singularity(&self) -> Singularity {
            Singularity::None
        }
        fn split(&self, x: f64, s: f64, _distance: f64) -> Split {
            Split { factor: 0.0, rest: x * s }
        }
        fn measure(&self, s: f64) -> f64 {
            s
        }
    }
    let relation = ComputedRelation::new(Disk, 1).unwrap();
    assert!((relation.eigenvalue(0) - 0.25).abs() < 1e-15);
    let mut phi = [0.0];
    relation.eigenfunctions(0.3, &mut phi);
    assert!((phi[0] - 0.6).abs() < 1e-14);
    // int 1 phi_0 dm
    assert!((relation.mass(0) - 2.0 / 3.0).abs() < 1e-14);
}

#[test]
fn what_was_not_computed_is_not_given() {
    let relation = ComputedRelation::new(Smooth::new(|x, s| (x * s).exp()), 5).unwrap();
    assert!(relation.eigenvalue(5).is_nan() && relation.norm(5).is_nan());
    assert!(relation.mass(5).is_nan() && relation.sum(&[1.0; 6], 0.0).is_nan());
    let mut phi = [0.0; 6];
    relation.eigenfunctions(0.2, &mut phi);
    assert!(phi[4].is_finite() && phi[5].is_nan());
    assert!(matches!(relation.gram(6), Err(Error::TooFew { needed: 6, available: 5 })));
    assert!(matches!(relation.moments(&|_| 1.0, 6), Err(Error::TooFew { .. })));
    assert!(matches!(DegenerateSystem::new(&relation, 1.0, 5), Err(Error::TooFew { .. })));
    let kink = relation.moments(&|x: f64| (x - 0.123).abs(), 5).unwrap();
    assert!(!kink.resolved && kink.error < 1e-2);
    assert!(matches!(relation.moments(&|x: f64| 1.0 / (x - x), 5), Err(Error::NotFinite { .. })));
}

#[test]
fn refusals_say_why() {
    let smooth = || Smooth::new(|x: f64, s: f64| (x * s).exp());
    assert!(matches!(ComputedRelation::new(smooth(), 0), Err(Error::InvalidParameter { .. })));
    assert!(matches!(ComputedRelation::new(smooth(), 1001), Err(Error::InvalidParameter { .. })));
    assert!(matches!(
        ComputedRelation::new(smooth(), usize::MAX),
        Err(Error::InvalidParameter { .. })
    ));
    for tolerance in [0.0, 1e-16, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            ComputedRelation::with_tolerance(smooth(), 3, tolerance),
            Err(Error::InvalidParameter { name: "tolerance", .. })
        ));
    }
    // The twelfth eigenvalue of exp(xs) is 9e-15 of the first (mpmath).
    let found = ComputedRelation::new(smooth(), 40);
    assert!(matches!(found, Err(Error::TooFew { needed: 40, available: 11 })), "{:?}", found.err());
    assert!(matches!(
        ComputedRelation::up_to(Smooth::new(|_, _| 0.0), 3),
        Err(Error::TooFew { available: 0, .. })
    ));
    assert!(matches!(
        ComputedRelation::new(Smooth::new(|x, s| 1.0 / (x + s)), 3),
        Err(Error::NotFinite { .. })
    ));
    // A jump along a line is no smooth kernel.
    let value = |x: f64, s: f64| if x * s > 0.1 { 1.0 } else { 0.0 };
    let jump = Smooth { even: true, ..Smooth::new(value) };
    assert!(matches!(
        ComputedRelation::with_tolerance(jump, 2, 1e-10),
        Err(Error::NotConverged { .. })
    ));
    let line = Smooth { interval: Interval::half_line(0.0).unwrap(), ..smooth() };
    assert!(matches!(ComputedRelation::new(line, 3), Err(Error::InvalidParameter { .. })));
}
