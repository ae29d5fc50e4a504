//! The floating-point numbers as an ordered set.

/// Position of a number among all floating-point numbers (both zeros are neighbours).
fn position(value: f64) -> i64 {
    let bits = value.to_bits().cast_signed();
    bits ^ ((bits >> 63).cast_unsigned() >> 1).cast_signed()
}

fn at_position(position: i64) -> f64 {
    let bits = position ^ ((position >> 63).cast_unsigned() >> 1).cast_signed();
    f64::from_bits(bits.cast_unsigned())
}

/// A number strictly between two numbers, or nothing if there is none.
///
/// Zero if it lies between, else the mean; with `by_count` as many floating-point numbers to the
/// left as to the right, which reaches neighbours within 64 halvings even close to zero.
pub(super) fn between(left: f64, right: f64, by_count: bool) -> Option<f64> {
    let middle = if left < 0.0 && right > 0.0 {
        0.0
    } else if by_count {
        at_position(position(left).midpoint(position(right)))
    } else {
        left.midpoint(right)
    };
    (left < middle && middle < right).then_some(middle)
}
