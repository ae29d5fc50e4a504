//! What stands for a kernel gives all of its answers, those with a default too.

#![allow(clippy::unwrap_used, reason = "a test may fail by panicking")]

use fredholm::Interval;
use fredholm::kernel::{ComputedRelation, Kernel, Macdonald, Pair, Singularity, Split, Yukawa};

/// A kernel that leaves nothing to a default, and has an answer of its own to each question.
struct Peculiar;

impl Kernel for Peculiar {
    fn interval(&self) -> Interval {
        Interval::new(-1.0, 2.0).unwrap()
    }

    fn extent(&self) -> Interval {
        Interval::new(-0.5, 1.5).unwrap()
    }

    fn singularity(&self) -> Singularity {
        Singularity::Power { exponent: 0.25 }
    }

    fn split(&self, x: f64, s: f64, _distance: f64) -> Split {
        Split { factor: 0.0, rest: 2.0 + (x + s).cos() }
    }

    fn pair(&self, x: f64, s: f64, _distance: f64) -> Pair {
        Pair { value: 2.0 + (x + s).cos(), factor: 0.125 }
    }

    fn pairs(&self, _x: f64, points: &[f64], _: &[f64], values: &mut [f64], factors: &mut [f64]) {
        values.copy_from_slice(points);
        factors.fill(0.375);
    }

    fn values(&self, x: f64, _: &[f64], _: &[f64], values: &mut [f64], _room: &mut [f64]) {
        values.fill(0.625 + x);
    }

    fn is_even(&self) -> bool {
        // It is not: only whether the answer arrives is asked here.
        self.measure(0.5) > 100.0
    }

    fn measure(&self, s: f64) -> f64 {
        1.0 + 0.1 * s
    }

    fn mass_function(&self, x: f64) -> f64 {
        3.0 - x
    }

    fn end_exponent(&self) -> f64 {
        0.875
    }

    fn settled(&self) -> f64 {
        1e-9
    }

    fn decay_length(&self) -> f64 {
        0.0625
    }

    fn centre_exponent(&self) -> f64 {
        3.5
    }

    fn first_half_count(&self) -> f64 {
        37.0
    }

    fn value(&self, x: f64, s: f64) -> f64 {
        1000.0 + x - s
    }
}

/// The answers to every question, at two points.
fn answers(kernel: &dyn Kernel) -> Vec<f64> {
    let (x, s, distance) = (0.3, 0.7, 0.4);
    let (interval, extent) = (kernel.interval(), kernel.extent());
    let (split, pair) = (kernel.split(x, s, distance), kernel.pair(x, s, distance));
    let (mut values, mut factors) = ([0.0; 2], [0.0; 2]);
    kernel.pairs(x, &[s, -s], &[distance, x + s], &mut values, &mut factors);
    let mut answers = vec![
        interval.left(),
        interval.right(),
        extent.left(),
        extent.right(),
        kernel.singularity().exponent(),
        split.factor,
        split.rest,
        pair.value,
        pair.factor,
        f64::from(kernel.is_even()),
        kernel.measure(x),
        kernel.mass_function(x),
        kernel.end_exponent(),
        kernel.settled(),
        kernel.decay_length(),
        kernel.centre_exponent(),
        kernel.first_half_count(),
        kernel.value(x, s),
    ];
    answers.extend(values.into_iter().chain(factors));
    kernel.values(x, &[s, -s], &[distance, x + s], &mut values, &mut factors);
    answers.extend(values);
    answers
}

#[test]
fn a_reference_is_its_kernel() {
    let own = answers(&Peculiar);
    assert_eq!(answers(&&Peculiar), own);
    let unsized_kernel: &dyn Kernel = &Peculiar;
    assert_eq!(answers(&unsized_kernel), own);
}

#[test]
fn a_computed_relation_is_its_kernel() {
    let smooth = ComputedRelation::new(Smooth(Peculiar), 2).unwrap();
    assert_eq!(answers(&smooth), answers(smooth.kernel()));
    assert_eq!([smooth.settled(), smooth.first_half_count()], [1e-9, 37.0]);
    let reference = ComputedRelation::new(&smooth, 2).unwrap();
    assert_eq!(answers(&reference), answers(smooth.kernel()));
}

#[test]
fn relations_with_formulae_are_their_kernels() {
    let yukawa = Yukawa::new(1.0, 2.0, 1).unwrap().relation(4).unwrap();
    assert_eq!(answers(&yukawa), answers(yukawa.kernel()));
    let macdonald = Macdonald::new(1.0, 0.1, 9.0).unwrap().relation(4).unwrap();
    assert_eq!(answers(&macdonald), answers(macdonald.kernel()));
}

/// The same without its singularity, so that its eigenpairs can be computed.
struct Smooth(Peculiar);

impl Kernel for Smooth {
    fn interval(&self) -> Interval {
        self.0.interval()
    }

    fn extent(&self) -> Interval {
        self.0.extent()
    }

    fn singularity(&self) -> Singularity {
        Singularity::None
    }

    fn split(&self, x: f64, s: f64, distance: f64) -> Split {
        self.0.split(x, s, distance)
    }

    fn pair(&self, x: f64, s: f64, distance: f64) -> Pair {
        self.0.pair(x, s, distance)
    }

    fn measure(&self, s: f64) -> f64 {
        self.0.measure(s)
    }

    fn mass_function(&self, x: f64) -> f64 {
        self.0.mass_function(x)
    }

    fn end_exponent(&self) -> f64 {
        0.875
    }

    fn settled(&self) -> f64 {
        self.0.settled()
    }

    fn first_half_count(&self) -> f64 {
        self.0.first_half_count()
    }

    fn value(&self, x: f64, s: f64) -> f64 {
        self.0.value(x, s)
    }
}
