//! The product with a Toeplitz plus Hankel matrix.

use fredholm_transforms::{Complex, PackedTransform, Planner, fast_length};

/// `y_p = sum_q (t_|p-q| + h_{p+q}) x_q`, `p, q < count`, by one real Fourier transform each way:
///
/// with `x` padded by zeros to a length `L >= 2 count - 2`, `y^_k = t^_k x^_k + h^_k conj(x^_k)`, where `t^` is the (real)
/// transform of the even sequence `t` and `h^` that of `h`: the conjugate turns the convolution into a correlation. Every index `p - q` and
/// `p + q` falls on its own place of the cycle; only for `L = 2 count - 2` does the last corner wrap, and is mended.
///
/// For `t = h` this is the product by cosine transforms, at the same length without their reordering and rotations.
///
/// Cost: two complex transforms of length `L / 2`; memory `3 L / 2` numbers beside the plan.
#[derive(Debug, Clone)]
pub(crate) struct Product {
    count: usize,
    transform: PackedTransform,
    symbol: Vec<SymbolPair>,
    corner: f64,
}

/// `t^` and `h^` at `k` and `L/2 - k`, divided by `L/2`.
#[derive(Debug, Clone, Copy, Default)]
struct SymbolPair {
    toeplitz: [f64; 2],
    hankel: [Complex; 2],
}

/// Room for one product.
#[derive(Debug)]
pub(crate) struct Workspace {
    packed: Vec<Complex>,
    scratch: Vec<Complex>,
}

impl Product {
    /// The product for `t_0 ..= t_{count-1}` and `h_0 ..= h_{2 count - 2}`, `count >= 1`.
    pub(crate) fn new(
        planner: &mut Planner,
        count: usize,
        toeplitz: impl Fn(usize) -> f64,
        hankel: impl Fn(usize) -> f64,
    ) -> Self {
        let half = fast_length(count.saturating_sub(1));
        let length = 2 * half;
        let transform = PackedTransform::new(planner, half);
        let mut workspace = Workspace::new(&transform);
        let mut symbol = vec![SymbolPair::default(); half / 2 + 1];
        let scale = 1.0 / half as f64;
        let cyclic = |j: usize| {
            let distance = j.min(length - j);
            if distance < count { toeplitz(distance) } else { 0.0 }
        };
        workspace.transform(&transform, cyclic);
        transform.visit(&workspace.packed, |k, low, high| {
            symbol[k].toeplitz = [scale * low.re, scale * high.re];
        });
        let last = 2 * count - 2;
        workspace.transform(&transform, |j| if j <= last { hankel(j) } else { 0.0 });
        transform.visit(&workspace.packed, |k, low, high| {
            symbol[k].hankel = [scale * low, scale * high];
        });
        let corner = if last == length { hankel(last) - hankel(0) } else { 0.0 };
        Self { count, transform, symbol, corner }
    }

    /// Order of the matrix.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    pub(crate) fn workspace(&self) -> Workspace {
        Workspace::new(&self.transform)
    }

    /// An upper bound of the norm of the matrix: the largest value of its symbol.
    pub(super) fn norm_bound(&self) -> f64 {
        let largest = self.symbol.iter().fold(0.0f64, |largest, pair| {
            let size = |i: usize| pair.toeplitz[i].abs() + pair.hankel[i].norm();
            largest.max(size(0)).max(size(1))
        });
        largest * self.transform.half() as f64
    }

    /// Hands every product `y_p` of `x_q = input(q)` to `output(p, y_p)`, in order; allocates nothing.
    pub(crate) fn apply(
        &self,
        workspace: &mut Workspace,
        input: impl Fn(usize) -> f64,
        mut output: impl FnMut(usize, f64),
    ) {
        let Workspace { packed, scratch } = workspace;
        let pairs = self.count / 2;
        for (j, value) in packed[..pairs].iter_mut().enumerate() {
            *value = Complex::new(input(2 * j), input(2 * j + 1));
        }
        packed[pairs..].fill(Complex::default());
        if self.count % 2 == 1 {
            packed[pairs].re = input(self.count - 1);
        }
        self.transform.forward(packed, scratch);
        self.transform.filter(packed, |k, low, high| {
            let pair = &self.symbol[k];
            (
                pair.toeplitz[0] * low + pair.hankel[0] * low.conj(),
                pair.toeplitz[1] * high + pair.hankel[1] * high.conj(),
            )
        });
        self.transform.backward(packed, scratch);
        let last = self.count - 1;
        let mended = self.corner * input(last);
        if last.is_multiple_of(2) {
            packed[last / 2].re += mended;
        } else {
            packed[last / 2].im -= mended;
        }
        for (j, value) in packed[..pairs].iter().enumerate() {
            output(2 * j, value.re);
            output(2 * j + 1, -value.im);
        }
        if last.is_multiple_of(2) {
            output(last, packed[pairs].re);
        }
    }
}

impl Workspace {
    fn new(transform: &PackedTransform) -> Self {
        Self { packed: vec![Complex::default(); transform.half()], scratch: transform.scratch() }
    }

    /// The packed transform of the sequence `value(j)`, `j < L`.
    fn transform(&mut self, transform: &PackedTransform, value: impl Fn(usize) -> f64) {
        for (j, pair) in self.packed.iter_mut().enumerate() {
            *pair = Complex::new(value(2 * j), value(2 * j + 1));
        }
        transform.forward(&mut self.packed, &mut self.scratch);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_entries_whatever_the_order_and_the_sequences() {
        let toeplitz = |j: usize| 1.0 / (1.0 + j as f64);
        let hankel = |j: usize| (0.7 * j as f64).cos() / (2.0 + j as f64);
        for count in [1usize, 2, 3, 4, 5, 8, 9, 10, 17, 33, 51, 64, 65, 200, 257, 1000] {
            let product = Product::new(&mut Planner::new(), count, toeplitz, hankel);
            let x: Vec<f64> = (0..count).map(|q| (1.1 * q as f64 + 0.2).sin()).collect();
            let mut positions = 0;
            let mut workspace = product.workspace();
            product.apply(
                &mut workspace,
                |q| x[q],
                |p, found| {
                    let exact: f64 =
                        (0..count).map(|q| (toeplitz(p.abs_diff(q)) + hankel(p + q)) * x[q]).sum();
                    assert_eq!(p, positions);
                    positions += 1;
                    assert!((found - exact).abs() < 2e-14, "{count} {p}: {found} {exact}");
                },
            );
            assert_eq!(positions, count);
            // The norm is at least that of the largest entry.
            assert!(product.norm_bound() >= toeplitz(0) + hankel(0) - 1e-14);
        }
    }
}
