//! Means of the singular parts of kernels over two cells.

/// Beyond this many widths of the larger cell the midpoints of two cells stand for them.
const FAR: f64 = 12.0;

/// The mean of `|x - s|^-mu` over `x` in one cell and `s` in another that is the same or lies left of it.
pub(in crate::contact) fn mean_power(left: [f64; 2], right: [f64; 2], exponent: f64) -> f64 {
    let (h, k) = (left[1] - left[0], right[1] - right[0]);
    let divisor = (1.0 - exponent) * (2.0 - exponent);
    if left == right {
        return 2.0 * h.powf(-exponent) / divisor;
    }
    let gap = (right[0] - left[1]).max(0.0);
    let distance = gap + 0.5 * (h + k);
    if distance > FAR * h.max(k) {
        return distance.powf(-exponent);
    }
    // Second difference of G(d) = d^(2-mu)/((1-mu)(2-mu)), G'' = d^-mu
    let g = |d: f64| d.powf(2.0 - exponent);
    (g(gap + h + k) - g(gap + h) - g(gap + k) + g(gap)) / (divisor * h * k)
}

/// The mean of `ln 1/|x - s|` over `x` in one cell and `s` in another that is the same or lies left of it.
pub(super) fn mean_logarithm(left: [f64; 2], right: [f64; 2]) -> f64 {
    let (h, k) = (left[1] - left[0], right[1] - right[0]);
    if left == right {
        return 1.5 - h.ln();
    }
    // From the gap between the cells, which is exact for neighbours.
    let gap = (right[0] - left[1]).max(0.0);
    let distance = gap + 0.5 * (h + k);
    if distance > FAR * h.max(k) {
        return -distance.ln();
    }
    // Second difference of G(d) = d^2/2 ln d - 3 d^2/4, G'' = ln d
    let g = |d: f64| if d > 0.0 { d * d * (0.5 * (d / distance).ln() - 0.75) } else { 0.0 };
    let sum = g(gap + h + k) - g(gap + h) - g(gap + k) + g(gap);
    -(sum / (h * k) + distance.ln())
}
