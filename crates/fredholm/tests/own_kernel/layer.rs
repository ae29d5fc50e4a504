//! The elastic layer against its own boundary value problem, quadrature elsewhere, published constants, limits and a closed form.

use std::f64::consts::PI;

use fredholm::conformance;
use fredholm::equation::{collocate, degenerate};
use fredholm::kernel::{ComputedRelation, Kernel};

use crate::own_kernel::layer_example::kernel::{Base, LAMBDA, Layer, on_half_plane, on_springs};

const BONDED: Base = Base::Bonded { poisson: 0.3 };

fn integral(layer: &Layer, lambda: f64) -> f64 {
    let found = collocate(layer, lambda, &|_| 1.0, &[], 1e-12).unwrap();
    assert!(found.error.integral < 1e-10);
    found.integral.unwrap()
}

/// Solves four equations.
fn eliminate(mut rows: [[f64; 5]; 4]) -> [f64; 4] {
    for k in 0..4 {
        let pivot = (k..4).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs())).unwrap();
        rows.swap(k, pivot);
        for i in (0..4).filter(|i| *i != k) {
            let factor = rows[i][k] / rows[k][k];
            let source = rows[k];
            rows[i].iter_mut().zip(source).for_each(|(entry, s)| *entry -= factor * s);
        }
    }
    std::array::from_fn(|k| rows[k][4] / rows[k][k])
}

/// `L(u)` from Airy's function `f(y) cos ux` of the layer `0 <= y <= 1` under the load `cos ux`, with `f` a combination of `cosh uy, y cosh uy, sinh uy, y sinh uy`.
fn transform_of_the_layer(u: f64, poisson: f64, bonded: bool) -> f64 {
    // Derivatives of the four functions at y: f, f', f'', f'''.
    let functions = |y: f64| -> [[f64; 4]; 4] {
        let (c, s) = ((u * y).cosh(), (u * y).sinh());
        let (u2, u3) = (u * u, u * u * u);
        [
            [c, y * c, s, y * s],
            [u * s, c + u * y * s, u * c, s + u * y * c],
            [u2 * c, 2.0 * u * s + u2 * y * c, u2 * s, 2.0 * u * c + u2 * y * s],
            [u3 * s, 3.0 * u2 * c + u3 * y * s, u3 * c, 3.0 * u2 * s + u3 * y * c],
        ]
    };
    let combine = |f: [[f64; 4]; 4], weights: [f64; 4]| -> [f64; 4] {
        std::array::from_fn(|k| (0..4).map(|d| weights[d] * f[d][k]).sum())
    };
    // E* u^2 v = f''' - (2 - nu)/(1 - nu) u^2 f' (times cos ux), E* u u_x = f'' + nu/(1 - nu) u^2 f (times sin ux).
    let normal = [0.0, -(2.0 - poisson) / (1.0 - poisson) * u * u, 0.0, 1.0];
    let tangential = [poisson / (1.0 - poisson) * u * u, 0.0, 1.0, 0.0];
    let shear = [0.0, 1.0, 0.0, 0.0];
    let (bottom, top) = (functions(0.0), functions(1.0));
    let row = |values: [f64; 4], right: f64| {
        let [a, b, c, d] = values;
        [a, b, c, d, right]
    };
    let coefficients = eliminate([
        // sigma_y = -u^2 f cos ux = -cos ux
        row(combine(top, [1.0, 0.0, 0.0, 0.0]), 1.0 / (u * u)),
        row(combine(top, shear), 0.0),
        row(combine(bottom, normal), 0.0),
        row(combine(bottom, if bonded { tangential } else { shear }), 0.0),
    ]);
    let lift: f64 = combine(top, normal).iter().zip(coefficients).map(|(v, c)| v * c).sum();
    // The face sinks by (2/E*) (L/u) cos ux.
    -lift / (2.0 * u)
}

#[test]
fn transforms_solve_the_boundary_value_problem() {
    for u in [0.05, 0.3, 1.0, 2.5, 6.0] {
        for poisson in [0.0, 0.3, 0.49] {
            let sliding = transform_of_the_layer(u, poisson, false);
            let found = Base::Sliding.transform(u);
            assert!((found / sliding - 1.0).abs() < 1e-9, "{u} {poisson}: {found} {sliding}");
            let bonded = transform_of_the_layer(u, poisson, true);
            let found = Base::Bonded { poisson }.transform(u);
            assert!((found / bonded - 1.0).abs() < 1e-9, "{u} {poisson}: {found} {bonded}");
        }
    }
    for base in [Base::Sliding, BONDED, Base::Bonded { poisson: 0.5 }, Base::Antiplane] {
        assert!((base.transform(1e-5) / 1e-5 - base.slope()).abs() < 1e-5, "{base:?}");
        assert!((base.transform(30.0) - 1.0).abs() < 1e-15, "{base:?}");
    }
}

#[test]
fn values_agree_with_quadrature_elsewhere() {
    // k(t) at t = 0.1, 1, 5, 15: mpmath, 25 digits, ln coth(pi t/4) + int (L - tanh u) cos(ut)/u du.
    let references = [
        (
            Base::Sliding,
            [
                1.956_106_614_485_433_8,
                0.062_067_047_910_512_68,
                3.691_359_232_381_331_e-5,
                -7.868_893_360_044_1e-15,
            ],
        ),
        (
            BONDED,
            [
                1.783_090_556_978_161_5,
                0.005_238_013_366_791_671,
                -4.181_032_432_772_894_e-4,
                -4.567_891_864_764_7e-8,
            ],
        ),
        (
            Base::Bonded { poisson: 0.0 },
            [
                1.935_858_577_475_76,
                0.068_368_747_621_799_72,
                -2.365_218_752_013_443_4e-4,
                -1.622_589_990_45e-9,
            ],
        ),
        (
            Base::Bonded { poisson: 0.5 },
            [
                1.336_345_454_829_807,
                -0.242_053_256_591_671_11,
                -0.010_300_222_745_990_343,
                -6.350_323_368_779_1e-6,
            ],
        ),
    ];
    for (base, values) in references {
        for thickness in [0.08, 0.1, 1.0 / 7.5] {
            let layer = Layer::new(base, thickness).unwrap();
            for (t, exact) in [0.1, 1.0, 5.0, 15.0].into_iter().zip(values) {
                let found = layer.pair(0.0, 0.0, t * thickness).value;
                assert!((found - exact).abs() < 2e-14, "{base:?} {t}: {found} {exact}");
            }
        }
    }
}

#[test]
fn published_constants_of_thick_layers() {
    // Vorovich, Aleksandrov and Babeshko give a_0 = -0.352 for the sliding layer and -0.527 for the bonded one with nu = 0.3; the digits after are mpmath's.
    for (base, constant) in [
        (Base::Sliding, -0.351_675_392_618_201_88),
        (BONDED, -0.526_629_786_342_717_1),
        (Base::Bonded { poisson: 0.5 }, -0.976_436_637_176_802),
        (Base::Antiplane, (4.0 / PI).ln()),
    ] {
        for thickness in [50.0, 1.0, 0.02] {
            let found = Layer::new(base, thickness).unwrap().gauge_constant();
            assert!((found - constant).abs() < 1e-11, "{base:?} {thickness}: {found} {constant}");
        }
    }
}

#[test]
fn a_thick_layer_is_a_half_plane() {
    for base in [Base::Sliding, BONDED, Base::Antiplane] {
        let error = |thickness: f64| {
            let layer = Layer::new(base, thickness).unwrap();
            integral(&layer, LAMBDA) - on_half_plane(&layer, LAMBDA).unwrap().unwrap()
        };
        let (near, far) = (error(20.0), error(200.0));
        // k(t) + ln t - a_0 is of the order t^2, and both integrals fall as 1/ln h.
        assert!(
            near.abs() < 2e-4 && (150.0..400.0).contains(&(near / far)),
            "{base:?}: {near} {far}"
        );
    }
}

#[test]
fn a_thin_layer_is_a_bed_of_springs() {
    for base in [Base::Sliding, BONDED, Base::Antiplane] {
        let error = |thickness: f64| {
            let layer = Layer::new(base, thickness).unwrap();
            integral(&layer, LAMBDA / thickness) - on_springs(base, 1.0, LAMBDA)
        };
        // Two ends, each of the length h, where the layer is stiffer.
        let (near, far) = (error(0.05), error(0.1));
        assert!(near > 0.0 && (far / near - 2.0).abs() < 0.02, "{base:?}: {near} {far}");
    }
}

/// `pi/(2 K(k))`, the arithmetic-geometric mean of 1 and `k' = sqrt(1 - k^2)`.
fn mean(mut other: f64) -> f64 {
    let mut mean = 1.0;
    for _ in 0..20 {
        (mean, other) = (0.5 * (mean + other), (mean * other).sqrt());
    }
    mean
}

#[test]
fn a_smooth_punch_on_an_antiplane_layer() {
    // The conformal map gives int K phi ds = 1, int phi dx = (2/pi) K(k)/K(k'), k = tanh(pi a/(2 h)): the limit of great lambda.
    for thickness in [0.5, 1.0, 4.0] {
        let k = (PI / (2.0 * thickness)).tanh();
        let exact = 2.0 / PI * mean(k) / mean((1.0 - k * k).sqrt());
        let layer = Layer::new(Base::Antiplane, thickness).unwrap();
        let error = |lambda: f64| lambda * integral(&layer, lambda) / exact - 1.0;
        let (rough, smooth) = (error(1e3), error(1e5));
        // The roughness counts as ln(lambda)/lambda.
        assert!(smooth < 0.0 && smooth > -3e-4, "{thickness}: {smooth}");
        assert!((40.0..100.0).contains(&(rough / smooth)), "{thickness}: {rough} {smooth}");
    }
}

#[test]
fn both_methods_agree_within_their_errors() {
    for base in [Base::Sliding, BONDED] {
        for thickness in [0.3, 2.0] {
            let layer = Layer::new(base, thickness).unwrap();
            let relation = ComputedRelation::new(&layer, 60).unwrap();
            let one = collocate(&layer, LAMBDA, &f64::exp, &[], 1e-12).unwrap();
            let other = degenerate(&relation, LAMBDA, &f64::exp, 59).unwrap();
            let gap = (one.integral.unwrap() - other.integral.unwrap()).abs();
            assert!(gap < one.error.integral + other.error.integral && gap < 1e-4);
            for x in [-1.0, -0.3, 0.9] {
                let gap = (one.evaluate(x) - other.evaluate(x)).abs();
                assert!(gap < one.error.solution + other.error.solution, "{base:?} {x}: {gap:e}");
            }
        }
    }
}

#[test]
fn passes_the_suite() {
    for (base, thickness) in [(Base::Sliding, 1.0), (BONDED, 0.2)] {
        let relation = ComputedRelation::new(Layer::new(base, thickness).unwrap(), 40).unwrap();
        let report = conformance::run(relation.kernel(), &relation, 40).unwrap();
        // 40 terms of a logarithmic kernel are no bilinear sum: all else must pass.
        for check in report.checks.iter().filter(|check| check.name != "bilinear sum") {
            assert!(check.passes(), "{base:?} {thickness}: {check:?}");
        }
    }
}
