//! What a kernel is.

use super::singularity::{Pair, Singularity, Split};
use crate::Interval;

/// A symmetric kernel `K(x, s) = K(s, x)` on an interval `L`, smooth but for its singularity at `x = s`. Its operator is
/// `K phi = int_L K(x, s) phi(s) dm(s)` with a measure `dm = m(s) ds`, `ds` unless said otherwise.
///
/// A kernel of one's own, `exp(-(x - s)^2) - ln|x - s|` on `(-1, 1)`, solved by collocation:
///
/// ```
/// use fredholm::kernel::{Kernel, Singularity, Split};
/// use fredholm::{Interval, SincOperator};
///
/// struct Layered;
///
/// impl Kernel for Layered {
///     fn interval(&self) -> Interval {
///         Interval::unit()
///     }
///     fn singularity(&self) -> Singularity {
///         Singularity::Logarithm
///     }
///     fn split(&self, _x: f64, _s: f64, distance: f64) -> Split {
///         Split { factor: -1.0, rest: (-distance * distance).exp() }
///     }
///     fn is_even(&self) -> bool {
///         true
///     }
/// }
///
/// let operator = SincOperator::new(&Layered, 40)?;
/// let solution = &operator.solve(0.5, &[operator.sample(f64::exp)?])?[0];
/// let exact = 0.456_015_642_588_867_46; // mpmath, 40 digits
/// assert!((solution.evaluate(0.3, 0.3f64.exp()) - exact).abs() < 1e-13);
/// # Ok::<(), fredholm::Error>(())
/// ```
pub trait Kernel: Send + Sync {
    /// The interval `L`.
    fn interval(&self) -> Interval;

    /// The finite part of the interval on which solutions are compared and shown: the whole of a finite interval.
    fn extent(&self) -> Interval {
        self.interval()
    }

    /// What the kernel does as `x -> s`.
    fn singularity(&self) -> Singularity;

    /// The split `K(x, s) = A(x, s) sigma(|x - s|) + B(x, s)` with the function `sigma` of [`Kernel::singularity`]
    /// and smooth `A`, `B`.
    ///
    /// `distance` is `|x - s|`, handed in because near the ends of the interval the caller knows it to more digits
    /// than the difference of `x` and `s` holds. It is zero for `x = s`, where both functions have their limits.
    fn split(&self, x: f64, s: f64, distance: f64) -> Split;

    /// `K(x, s)` and `A(x, s)` for two different points.
    ///
    /// From the split unless said otherwise. Where both parts of the split are large and their sum is small (a kernel that decays, far from the
    /// diagonal), give the value by a way of its own, and let `A` fade away smoothly where it would grow: only its values near the diagonal matter.
    fn pair(&self, x: f64, s: f64, distance: f64) -> Pair {
        let split = self.split(x, s, distance);
        Pair { value: split.value(self.singularity(), distance), factor: split.factor }
    }

    /// [`pair`](Self::pair) for one point `x` and many points `s`, none of which is `x`, with their distances from it: the values `K(x, s)` and the factors `A(x, s)`. All lists have one
    /// length.
    ///
    /// One by one unless said otherwise: worth a way of its own where that takes many numbers at once.
    fn pairs(
        &self,
        x: f64,
        points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        factors: &mut [f64],
    ) {
        let results = values.iter_mut().zip(factors);
        for ((s, distance), (value, factor)) in points.iter().zip(distances).zip(results) {
            let pair = self.pair(x, *s, *distance);
            (*value, *factor) = (pair.value, pair.factor);
        }
    }

    /// The values alone, for points far enough apart that no factor is wanted; the last list, of the same length, is room to work in.
    ///
    /// Those of [`pairs`](Self::pairs) unless said otherwise: worth a way of its own where factors take time.
    fn values(
        &self,
        x: f64,
        points: &[f64],
        distances: &[f64],
        values: &mut [f64],
        room: &mut [f64],
    ) {
        self.pairs(x, points, distances, values, room);
    }

    /// Whether the kernel and its measure keep their values under the reflection about the middle `c` of the interval,
    /// `K(2c - x, 2c - s) = K(x, s)`: collocation then splits into an even and an odd problem of half the size.
    ///
    /// False unless said otherwise, which is always right and only slower.
    fn is_even(&self) -> bool {
        false
    }

    /// The density `m(s)` of the measure, positive inside the interval; 1 unless said otherwise. On a disk it is `s`. It may be 0 so near an end that nothing there
    /// matters: collocation leaves such nodes out.
    fn measure(&self, _s: f64) -> f64 {
        1.0
    }

    /// The function `u` with which a solution is integrated, `int_L u phi dm`: 1 unless said otherwise, and on a disk the power of the harmonic.
    fn mass_function(&self, _x: f64) -> f64 {
        1.0
    }

    /// The power `d^beta`, `beta > 0`, of the distance to an end with which solutions leave their end values, for right-hand sides that are smooth; the
    /// smaller one of both ends. Collocation reaches so far into the corners that what lies beyond does not matter.
    ///
    /// Unless said otherwise `1 - q`, with the exponent of the singularity, and at most 1.
    fn end_exponent(&self) -> f64 {
        (1.0 - self.singularity().exponent()).min(1.0)
    }

    /// The distance from the left end within which potentials `K phi` have their end value to rounding; 0 leaves it open. Collocation takes that value there: at the
    /// centre of a disk, where the rim asks for a deeper corner, the grid has nodes too far from each other to resolve the kernel.
    fn settled(&self) -> f64 {
        0.0
    }

    /// The length over which the kernel decays, or has any other feature, away from its singularity, where that is shorter than the interval; infinite unless said otherwise. Collocation spreads
    /// nodes accordingly.
    fn decay_length(&self) -> f64 {
        f64::INFINITY
    }

    /// The power `mu` of `x` as which the kernel and solutions vanish at the centre of a disk, 0 unless said otherwise: the kernel falls from its diagonal as `(s/x)^mu` for `s < x`, the faster the
    /// higher the power. Collocation crowds nodes the less at the ends.
    fn centre_exponent(&self) -> f64 {
        0.0
    }

    /// Nodes on either side of the middle with which adaptive collocation should begin, where the kernel has features finer than the interval; 0 leaves it to the parameter.
    fn first_half_count(&self) -> f64 {
        0.0
    }

    /// `K(x, s)`; infinite at `x = s` for a singular kernel.
    fn value(&self, x: f64, s: f64) -> f64 {
        if x == s {
            return self.split(x, s, 0.0).value(self.singularity(), 0.0);
        }
        self.pair(x, s, (x - s).abs()).value
    }
}

/// Every method of [`Kernel`] handed on to another kernel: what has a default is forgotten too easily when it is written out.
macro_rules! forward_kernel {
    ($this:ident => $kernel:expr) => {
        fn interval(&$this) -> $crate::Interval {
            $kernel.interval()
        }

        fn extent(&$this) -> $crate::Interval {
            $kernel.extent()
        }

        fn singularity(&$this) -> $crate::kernel::Singularity {
            $kernel.singularity()
        }

        fn split(&$this, x: f64, s: f64, distance: f64) -> $crate::kernel::Split {
            $kernel.split(x, s, distance)
        }

        fn pair(&$this, x: f64, s: f64, distance: f64) -> $crate::kernel::Pair {
            $kernel.pair(x, s, distance)
        }

        fn pairs(
            &$this,
            x: f64,
            points: &[f64],
            distances: &[f64],
            values: &mut [f64],
            factors: &mut [f64],
        ) {
            $kernel.pairs(x, points, distances, values, factors);
        }

        fn values(
            &$this,
            x: f64,
            points: &[f64],
            distances: &[f64],
            values: &mut [f64],
            room: &mut [f64],
        ) {
            $kernel.values(x, points, distances, values, room);
        }

        fn is_even(&$this) -> bool {
            $kernel.is_even()
        }

        fn measure(&$this, s: f64) -> f64 {
            $kernel.measure(s)
        }

        fn mass_function(&$this, x: f64) -> f64 {
            $kernel.mass_function(x)
        }

        fn end_exponent(&$this) -> f64 {
            $kernel.end_exponent()
        }

        fn settled(&$this) -> f64 {
            $kernel.settled()
        }

        fn decay_length(&$this) -> f64 {
            $kernel.decay_length()
        }

        fn centre_exponent(&$this) -> f64 {
            $kernel.centre_exponent()
        }

        fn first_half_count(&$this) -> f64 {
            $kernel.first_half_count()
        }

        fn value(&$this, x: f64, s: f64) -> f64 {
            $kernel.value(x, s)
        }
    };
}

pub(crate) use forward_kernel;

/// A kernel behind a reference is that kernel.
impl<K: Kernel + ?Sized> Kernel for &K {
    forward_kernel!(self => (**self));
}
