//! The structured solve against dense entries, the dense system, references and its own promises.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use std::f64::consts::PI;

use fredholm::kernel::{
    EndExponents, Expansion, Gram, Kernel, Logarithm, Moments, Parity, Singularity,
    SpectralRelation, Split,
};
use fredholm::{DegenerateSystem, Error, Interval, StructuredOperator, StructuredSystem};

/// What [`Concealed`] says of its Gram matrix.
#[derive(Debug)]
enum Form {
    /// The truth.
    Plain,
    /// The truth without its structure.
    Dense,
    /// Another positive one, whose symbol `1 + cos s - cos(3 s) / 5` turns negative when distant entries are moved to the diagonal.
    Banded,
}

/// Kernel 1 with its symmetry concealed, and perhaps its structure.
#[derive(Debug)]
struct Concealed {
    kernel: Logarithm,
    form: Form,
}

impl Concealed {
    fn new(form: Form) -> Self {
        Self { kernel: Logarithm::unit(), form }
    }
}

impl Kernel for Concealed {
    fn interval(&self) -> Interval {
        self.kernel.interval()
    }
    fn singularity(&self) -> Singularity {
        self.kernel.singularity()
    }
    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        self.kernel.split(x, s, distance)
    }
}

impl SpectralRelation for Concealed {
    fn weight_exponents(&self) -> EndExponents {
        self.kernel.weight_exponents()
    }
    fn weight_rest(&self, n: usize, x: f64) -> f64 {
        self.kernel.weight_rest(n, x)
    }
    fn expand(&self, f: &dyn Fn(f64) -> f64) -> Result<Expansion, Error> {
        self.kernel.expand(f)
    }
    fn eigenvalue(&self, n: usize) -> f64 {
        self.kernel.eigenvalue(n)
    }
    fn norm(&self, n: usize) -> f64 {
        self.kernel.norm(n)
    }
    fn parity(&self) -> Parity {
        Parity::None
    }
    fn eigenfunctions(&self, x: f64, values: &mut [f64]) {
        self.kernel.eigenfunctions(x, values);
    }
    fn sum(&self, coefficients: &[f64], x: f64) -> f64 {
        self.kernel.sum(coefficients, x)
    }
    fn gram(&self, count: usize) -> Result<Gram, Error> {
        let gram = self.kernel.gram(count)?;
        Ok(match self.form {
            Form::Plain => gram,
            Form::Dense => Gram::Dense {
                order: count,
                entries: (0..count * count).map(|i| gram.entry(i / count, i % count)).collect(),
            },
            Form::Banded => {
                let mut toeplitz = vec![1.0, 0.5, 0.0, -0.1];
                toeplitz.resize(count.max(4), 0.0);
                Gram::ToeplitzHankel { toeplitz, hankel: vec![0.0; 2 * count] }
            }
        })
    }
    fn moments(&self, f: &dyn Fn(f64) -> f64, count: usize) -> Result<Moments, Error> {
        self.kernel.moments(f, count)
    }
}

fn skew(x: f64) -> f64 {
    (0.8 * x).exp() + x
}

#[test]
fn products_agree_with_the_gram_entries() {
    let kernel = Logarithm::new(0.7).unwrap();
    for degree in [0usize, 1, 2, 3, 7, 16, 17, 64, 101, 510, 1024] {
        let gram = kernel.gram(degree + 1).unwrap();
        let x: Vec<f64> = (0..=degree).map(|m| (0.9 * m as f64 + 0.1).sin()).collect();
        let found = StructuredOperator::new(&kernel, degree).unwrap().product(&x);
        assert_eq!(found.len(), degree + 1);
        for (k, found) in found.into_iter().enumerate() {
            let exact: f64 = x.iter().enumerate().map(|(m, x)| gram.entry(k, m) * x).sum();
            assert!((found - exact).abs() < 3e-15, "degree {degree}, k = {k}: {found} {exact}");
        }
    }
}

#[test]
fn solutions_agree_with_the_dense_system() {
    let kernel = Logarithm::unit();
    for degree in [0, 1, 64, 401, 1000] {
        let operator = StructuredOperator::new(&kernel, degree).unwrap();
        let moments = kernel.moments(&skew, degree + 1).unwrap().values;
        for parameter in [0.0, 1e-3, 0.6, 60.0, 1e4] {
            let dense = DegenerateSystem::new(&kernel, parameter, degree).unwrap().solve(&moments);
            let system = operator.system(parameter).unwrap();
            let (found, convergence) = system.solve(&moments, 1e-14).unwrap();
            assert!(convergence.residual <= 1e-14 || convergence.limited_by_rounding);
            let largest = moments.iter().fold(0.0f64, |largest, f| largest.max(f.abs()));
            for (found, dense) in found.projections().iter().zip(dense.projections()) {
                let error = (found - dense).abs();
                assert!(error < 1e-13 * largest, "{degree} {parameter}: {found} {dense}");
            }
            for x in [-1.0, -0.3, 0.0, 0.99, 1.0] {
                let error = (found.evaluate(x, skew(x)) - dense.evaluate(x, skew(x))).abs();
                assert!(error < 1e-14 * (10.0 + parameter), "{degree} {parameter} {x}: {error:e}");
            }
        }
    }
}

#[test]
fn a_large_truncation_reaches_the_references_with_the_order_of_the_theory() {
    // Sinc collocation, 141 nodes; the orders are 4, 2 and 3. At degree 1638400 the same system gives 49.21561249739,
    // -8.9952483203 and 0.52383733683.
    let reference = [49.2156124973957, -8.99524832047766, 0.523837336836152];
    let lambda0 = 100.0;
    let kernel = Logarithm::unit();
    let errors = |degree: usize| {
        let system = StructuredSystem::new(&kernel, 15.0 / (8.0 * PI) * lambda0, degree).unwrap();
        let solve = |f: &dyn Fn(f64) -> f64| {
            let moments = kernel.moments(f, degree + 1).unwrap();
            system.solve(&moments.values, StructuredSystem::<Logarithm>::TOLERANCE).unwrap().0
        };
        let (one, square) = (solve(&|_| 1.0), solve(&|x| x * x));
        let delta = (0.001 + lambda0 * square.projections()[0]) / one.projections()[0];
        let pressure = |x: f64| delta * one.evaluate(x, 1.0) - lambda0 * square.evaluate(x, x * x);
        let found = [delta, pressure(1.0), pressure(0.0)];
        [0, 1, 2].map(|i| (found[i] - reference[i]).abs())
    };
    let [coarse, middle, fine] = [1 << 10, 1 << 12, 1 << 17].map(errors);
    for (i, order) in [4.0, 2.0, 3.0].into_iter().enumerate() {
        let observed = (coarse[i] / middle[i]).log2() / 2.0;
        assert!((observed - order).abs() < 0.2, "quantity {i}: order {observed}");
        let expected = middle[i] * 0.5f64.powf(5.0 * order);
        assert!(fine[i] < 2.0 * expected + 2e-12, "quantity {i}: {} for {expected}", fine[i]);
    }
}

#[test]
fn iterations_do_not_grow_with_the_degree() {
    let kernel = Logarithm::unit();
    let iterations = |degree: usize, parameter: f64| {
        let system = StructuredSystem::new(&kernel, parameter, degree).unwrap();
        let moments = kernel.moments(&|x| x * x, degree + 1).unwrap().values;
        system.solve(&moments, 1e-12).unwrap().1.iterations
    };
    for (parameter, most) in [(0.6, 5), (60.0, 8), (6000.0, 16)] {
        for degree in [1 << 13, 1 << 16] {
            let found = iterations(degree, parameter);
            assert!((1..=most).contains(&found), "{degree} {parameter}: {found}");
        }
    }
}

#[test]
fn other_kernels_are_solved_too_without_parity_and_with_the_plain_preconditioner() {
    let degree = 1500;
    for (form, parameter) in [(Form::Plain, 30.0), (Form::Banded, 1e3), (Form::Banded, 1e6)] {
        let kernel = Concealed::new(form);
        let moments = kernel.moments(&skew, degree + 1).unwrap().values;
        let structured = StructuredSystem::new(&kernel, parameter, degree).unwrap();
        let dense = DegenerateSystem::new(&kernel, parameter, degree).unwrap().solve(&moments);
        let (found, _) = structured.solve(&moments, 1e-14).unwrap();
        for (found, dense) in found.projections().iter().zip(dense.projections()) {
            assert!((found - dense).abs() < 1e-12, "{kernel:?}: {found} {dense}");
        }
    }
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let kernel = Logarithm::unit();
    let solve = || {
        let system = StructuredSystem::new(&kernel, 60.0, 3000).unwrap();
        let moments = kernel.moments(&skew, 3001).unwrap().values;
        let (solution, _) = system.solve(&moments, 1e-13).unwrap();
        solution.projections().iter().map(|x| x.to_bits()).collect::<Vec<_>>()
    };
    assert_eq!(solve(), solve());
}

#[test]
fn the_size_of_the_right_hand_side_does_not_matter() {
    let kernel = Logarithm::unit();
    let system = StructuredSystem::new(&kernel, 5.0, 100).unwrap();
    let moments = kernel.moments(&skew, 101).unwrap().values;
    let (plain, _) = system.solve(&moments, 1e-14).unwrap();
    for exponent in [-1000, 1000] {
        let scale = 2f64.powi(exponent);
        let scaled: Vec<f64> = moments.iter().map(|f| f * scale).collect();
        let (found, _) = system.solve(&scaled, 1e-14).unwrap();
        for (found, plain) in found.projections().iter().zip(plain.projections()) {
            assert!((found / scale - plain).abs() < 1e-14);
        }
    }
    let (zero, convergence) = system.solve(&[], 1e-14).unwrap();
    assert!(zero.projections().iter().all(|&x| x == 0.0) && convergence.iterations == 0);
}

#[test]
fn rounding_is_told_from_failure() {
    // The attainable residual grows with the parameter; it is reported, not hidden, and the answer is as good as the
    // dense one.
    let kernel = Logarithm::unit();
    let (degree, parameter) = (2000, 1e7);
    let system = StructuredSystem::new(&kernel, parameter, degree).unwrap();
    let moments = kernel.moments(&|_| 1.0, degree + 1).unwrap().values;
    // No residual of rounded numbers is as small as that, whatever vectors they are added up in.
    let (found, convergence) = system.solve(&moments, 1e-19).unwrap();
    assert!(convergence.limited_by_rounding && convergence.residual < 1e-9, "{convergence:?}");
    let dense = DegenerateSystem::new(&kernel, parameter, degree).unwrap().solve(&moments);
    let (found, dense) = (found.projections()[0], dense.projections()[0]);
    assert!((found / dense - 1.0).abs() < 1e-12, "{found} {dense}");
}

#[test]
fn bad_input_is_refused() {
    let kernel = Logarithm::unit();
    for parameter in [f64::NAN, f64::INFINITY, -1.0] {
        let error = StructuredSystem::new(&kernel, parameter, 8).unwrap_err();
        assert!(matches!(error, Error::InvalidParameter { name: "parameter", .. }), "{error}");
    }
    for degree in [1 << 50, usize::MAX] {
        let error = StructuredSystem::new(&kernel, 1.0, degree).unwrap_err();
        assert!(matches!(error, Error::TooLarge { .. }), "{error}");
    }
    let long = Logarithm::new(2.5).unwrap();
    let error = StructuredSystem::new(&long, 1.0, 8).unwrap_err();
    assert!(matches!(error, Error::NotPositive { index: 0, .. }), "{error}");
    let dense = Concealed::new(Form::Dense);
    assert_eq!(StructuredSystem::new(&dense, 1.0, 8).unwrap_err(), Error::Unstructured);

    let system = StructuredSystem::new(&kernel, 1.0, 8).unwrap();
    for tolerance in [f64::NAN, 0.0, -1.0, 1.0] {
        let error = system.solve(&[1.0], tolerance).unwrap_err();
        assert!(matches!(error, Error::InvalidParameter { name: "tolerance", .. }), "{error}");
    }
    for moment in [f64::NAN, f64::INFINITY] {
        let error = system.solve(&[1.0, moment], 1e-12).unwrap_err();
        assert!(matches!(error, Error::InvalidParameter { name: "moment", .. }), "{error}");
    }
    // Beyond the range of doubles: an error with its numbers, no endless loop.
    let extreme = StructuredSystem::new(&kernel, 1e308, 5000).unwrap();
    assert!(extreme.solve(&[1.0], 1e-12).is_err());
}
