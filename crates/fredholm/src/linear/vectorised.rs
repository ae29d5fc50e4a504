//! Code for the widest vectors of the processor that it runs on.

/// Runs `work` as compiled for the widest vectors that the processor at hand has. Only what is inlined into it is compiled so: loops, and not what an iterator's or an array's `map` or `for_each` is given, which may be built as a function of its own for narrow vectors.
///
/// Multiplications and additions are rounded one by one on every width, so that results have the same bits.
#[inline(always)]
pub(crate) fn vectorised<R>(work: impl FnOnce() -> R) -> R {
    architecture().dispatch(work)
}

#[cfg(not(test))]
#[inline(always)]
fn architecture() -> pulp::Arch {
    pulp::Arch::new()
}

#[cfg(test)]
use tests::architecture;

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use pulp::Arch;

    use crate::collocation::SweepValue;
    use crate::kernel::{Logarithm, SpectralRelation, TransferPlane, Yukawa};
    use crate::linear::small_cholesky;
    use crate::{SincOperator, solve_adaptive};

    thread_local! {
        /// The width that a test asks for.
        static CHOSEN: Cell<Option<Arch>> = const { Cell::new(None) };
    }

    pub(super) fn architecture() -> Arch {
        CHOSEN.get().unwrap_or_default()
    }

    /// The widths of this processor; none is one lane at a time.
    fn widths() -> Vec<Arch> {
        let mut widths = vec![Arch::Scalar];
        #[cfg(target_arch = "x86_64")]
        {
            widths.extend(pulp::x86::V3::try_new().map(Arch::V3));
            widths.extend(pulp::x86::V4::try_new().map(Arch::V4));
        }
        if widths.len() == 1 {
            widths.push(Arch::new());
        }
        widths
    }

    /// Sweeps in a parameter, of a kernel with parity and of one that is shown whole, over more parameters than lanes.
    fn sweeps() -> Vec<f64> {
        let kernel = Logarithm::new(1.7).unwrap();
        let operator = SincOperator::with_breaks(&kernel, 30, &[0.3]).unwrap();
        let even = SincOperator::new(&kernel, 40).unwrap();
        let parameters: Vec<f64> = (0..43).map(|k| 0.37 * f64::from(k)).collect();
        let mut found = Vec::new();
        for operator in [operator, even] {
            let f = operator.sample(|x| (3.0 * x).cos()).unwrap();
            let spectrum = operator.spectrum().unwrap();
            let ends = [(3.0f64 * 1.7).cos(); 2];
            let sweep = spectrum.sweep(&f, ends, 100.0).unwrap();
            let mut values = vec![SweepValue::default(); parameters.len()];
            sweep.run(&parameters, &mut values);
            for value in values {
                found.extend([value.one_one, value.one_x, value.x_x, value.one_f, value.x_f]);
                found.extend(value.ends_one.into_iter().chain(value.ends_x).chain(value.ends_f));
            }
            let solution = spectrum.solve(2.0, &f).unwrap();
            found.extend([0.1, -1.2].map(|x| solution.evaluate(x, (3.0 * x).cos())));
        }
        found
    }

    /// Solutions with chosen counts, whose right-hand sides are compared with polynomials.
    fn chosen() -> Vec<f64> {
        let f = |x: f64| (x - 0.2).abs() + (9.0 * x).sin();
        let found = solve_adaptive(&Logarithm::unit(), 5.0, f, 1e-9).unwrap();
        [-0.9, 0.0, 0.7].map(|x| found.solution.evaluate(x, f(x))).to_vec()
    }

    /// Eigenvalues of a tridiagonal matrix and of a kernel.
    fn eigenvalues() -> Vec<f64> {
        let relation = Yukawa::new(1.0, 7.0, 1).unwrap().relation(60).unwrap();
        (0..60).map(|n| relation.eigenvalue(n)).collect()
    }

    /// A system of 37 equations, which is no multiple of any number of lanes.
    fn systems() -> Vec<f64> {
        const ORDER: usize = 37;
        let entry =
            |i: usize, j: usize| 1.0 / (1 + i.abs_diff(j)) as f64 + if i == j { 3.0 } else { 0.0 };
        let mut matrix: Vec<f64> =
            (0..ORDER * ORDER).map(|at| entry(at / ORDER, at % ORDER)).collect();
        let mut right: Vec<f64> = (0..ORDER).map(|i| (i as f64).sin()).collect();
        small_cholesky::factor(&mut matrix, ORDER).unwrap();
        small_cholesky::solve(&matrix, ORDER, &mut right);
        right
    }

    /// A layer, whose smooth part are polynomials on runs of nodes.
    fn layer() -> Vec<f64> {
        let kernel = TransferPlane::new(0.4, 0.0, |u| u.tanh() / (1.0 + (-u).exp())).unwrap();
        let f = |x: f64| (2.0 * x).cos();
        let found = solve_adaptive(&kernel, 3.0, f, 1e-9).unwrap();
        [-0.8, 0.1, 0.9].map(|x| found.solution.evaluate(x, f(x))).to_vec()
    }

    /// What is said above: the same bits, which is more than that answers agree within their errors. The library of dense algebra chooses its widths itself; they are the same in all runs here.
    #[test]
    fn every_width_gives_the_same_bits() {
        let all = || [sweeps(), chosen(), eigenvalues(), systems(), layer()].concat();
        let widest: Vec<u64> = all().into_iter().map(f64::to_bits).collect();
        for width in widths() {
            CHOSEN.set(Some(width));
            let found = all();
            CHOSEN.set(None);
            assert!(found.iter().all(|value| value.is_finite()), "{width:?}");
            let found: Vec<u64> = found.into_iter().map(f64::to_bits).collect();
            assert_eq!(found, widest, "{width:?}");
        }
    }
}
