//! Intervals of real numbers and their arithmetic, rounded outward.

/// A closed interval of real numbers; an end can be infinite, none is NaN.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    lower: f64,
    upper: f64,
}

impl Interval {
    /// All numbers.
    pub const WHOLE: Interval = Interval { lower: f64::NEG_INFINITY, upper: f64::INFINITY };

    /// The number zero.
    pub const ZERO: Interval = Interval { lower: 0.0, upper: 0.0 };
    /// The number one.
    pub const ONE: Interval = Interval { lower: 1.0, upper: 1.0 };

    /// From `lower` to `upper`; `None` if an end is NaN or the ends are in the wrong order.
    pub fn new(lower: f64, upper: f64) -> Option<Self> {
        (lower <= upper).then_some(Interval { lower, upper })
    }

    /// One number; `None` if it is NaN.
    pub fn point(value: f64) -> Option<Self> {
        Self::new(value, value)
    }

    /// The lower end.
    pub fn lower(self) -> f64 {
        self.lower
    }

    /// The upper end.
    pub fn upper(self) -> f64 {
        self.upper
    }

    /// Whether the number lies in the interval, ends included.
    pub fn contains(self, value: f64) -> bool {
        self.lower <= value && value <= self.upper
    }

    /// Whether both ends are finite.
    pub fn is_bounded(self) -> bool {
        self.lower.is_finite() && self.upper.is_finite()
    }

    /// Ends that are known to be in order; anything else makes the whole line.
    pub fn ends(lower: f64, upper: f64) -> Self {
        Self::new(lower, upper).unwrap_or(Self::WHOLE)
    }

    /// The smallest interval that holds both.
    pub fn hull(self, other: Self) -> Self {
        Self::ends(self.lower.min(other.lower), self.upper.max(other.upper))
    }

    /// The part between two limits; `None` if there is none.
    pub fn within(self, lower: f64, upper: f64) -> Option<Self> {
        Self::new(self.lower.max(lower), self.upper.min(upper))
    }

    /// Infinite ends replaced by the largest finite numbers.
    pub(super) fn with_finite_ends(self) -> Self {
        let finite = |end: f64| end.clamp(f64::MIN, f64::MAX);
        Self::ends(finite(self.lower), finite(self.upper))
    }

    /// Whether it holds one number only.
    pub fn is_point(self) -> bool {
        self.lower == self.upper
    }

    /// Whether it holds zero only.
    pub fn is_zero(self) -> bool {
        self.lower == 0.0 && self.upper == 0.0
    }

    /// Largest magnitude.
    pub fn size(self) -> f64 {
        self.lower.abs().max(self.upper.abs())
    }

    /// No less than the distance of the ends.
    pub fn length(self) -> f64 {
        if self.is_point() { 0.0 } else { add_up(self.upper, -self.lower) }
    }

    /// What two intervals have in common; the first where rounding leaves nothing.
    pub fn common(self, other: Self) -> Self {
        self.within(other.lower, other.upper).unwrap_or(self)
    }

    /// `2^exponent` times the interval.
    pub fn shifted(self, exponent: i32) -> Self {
        let upper = shift_up(self.upper, exponent);
        Self::ends(-shift_up(-self.lower, exponent), upper)
    }

    /// All values of `slope s + curvature s^2` for `s` in an interval around zero.
    pub fn quadratic(slope: Self, curvature: Self, s: Self) -> Self {
        let upper = quadratic_up(slope, curvature.upper, s);
        Self::ends(-quadratic_up(slope.negated(), -curvature.lower, s), upper)
    }

    fn has_one_sign(self) -> bool {
        self.lower >= 0.0 || self.upper <= 0.0
    }

    fn has_infinity(self) -> bool {
        !self.is_bounded()
    }

    /// The numbers of opposite sign.
    pub fn negated(self) -> Self {
        Self::ends(-self.upper, -self.lower)
    }

    /// Numbers of either sign that are this large.
    pub fn magnitude(self) -> Self {
        let far = self.lower.abs().max(self.upper.abs());
        let near = if self.contains(0.0) { 0.0 } else { self.lower.abs().min(self.upper.abs()) };
        Self::ends(near, far)
    }

    /// Sum, and whether it may be undefined (`inf - inf`).
    pub fn plus(self, other: Self) -> (Self, bool) {
        let undefined = (self.upper == f64::INFINITY && other.lower == f64::NEG_INFINITY)
            || (self.lower == f64::NEG_INFINITY && other.upper == f64::INFINITY);
        let lower = -add_up(-self.lower, -other.lower);
        (Self::ends(lower, add_up(self.upper, other.upper)), undefined)
    }

    /// Product, and whether it may be undefined (`0 * inf`).
    pub fn times(self, other: Self) -> (Self, bool) {
        let undefined = (self.contains(0.0) && other.has_infinity())
            || (other.contains(0.0) && self.has_infinity());
        (products(self, other), undefined)
    }

    /// All squares.
    pub fn square(self) -> Self {
        let size = self.magnitude();
        let lower = -multiply_up(-size.lower, size.lower);
        Self::ends(lower, multiply_up(size.upper, size.upper))
    }

    /// Quotient, and whether it may be undefined (`0 / 0`, `inf / inf`).
    ///
    /// A quotient by zero is infinite with the sign of the numerator, as the evaluation has it.
    pub fn over(self, other: Self) -> (Self, bool) {
        let by_zero = other.contains(0.0);
        let undefined =
            (by_zero && self.contains(0.0)) || (self.has_infinity() && other.has_infinity());
        if !by_zero {
            return (quotients(self, other), undefined);
        }
        let quotient = if other.lower == 0.0 && other.upper > 0.0 && self.lower >= 0.0 {
            Self::ends(-divide_up(-self.lower, other.upper), f64::INFINITY)
        } else if other.lower == 0.0 && other.upper > 0.0 && self.upper <= 0.0 {
            Self::ends(f64::NEG_INFINITY, divide_up(self.upper, other.upper))
        } else {
            Self::WHOLE
        };
        (quotient, undefined)
    }

    /// Square root of the part that is not negative, and whether there is another part.
    pub(super) fn square_root(self) -> (Self, bool) {
        let Some(defined) = self.within(0.0, f64::INFINITY) else {
            return (Self::WHOLE, true);
        };
        (Self::ends(root_down(defined.lower), root_up(defined.upper)), self.lower < 0.0)
    }
}

/// Hull of an operation on the ends; `up` rounds upward and is odd in its first argument.
/// NaN corners (`inf / inf`) are limits that the other corners cover.
fn corners(u: Interval, v: Interval, up: fn(f64, f64) -> f64) -> Interval {
    let (mut lower, mut upper) = (f64::INFINITY, f64::NEG_INFINITY);
    for a in [u.lower, u.upper] {
        for b in [v.lower, v.upper] {
            upper = upper.max(up(a, b));
            lower = lower.min(-up(-a, b));
        }
    }
    Interval::ends(lower, upper)
}

/// All products: of a factor that has one sign and is bounded the ends are known.
fn products(u: Interval, v: Interval) -> Interval {
    let is_known = u.is_bounded() && v.is_bounded() && (u.has_one_sign() || v.has_one_sign());
    let [lower, upper] = product_by_sign([u.lower, u.upper], [v.lower, v.upper]);
    if is_known && lower.is_finite() && upper.is_finite() {
        Interval::ends(lower, upper)
    } else {
        corners(u, v, multiply_up)
    }
}

/// All quotients by numbers of one sign.
fn quotients(u: Interval, v: Interval) -> Interval {
    let [lower, upper] = quotient_by_sign([u.lower, u.upper], [v.lower, v.upper]);
    if u.is_bounded() && v.is_bounded() && lower.is_finite() && upper.is_finite() {
        Interval::ends(lower, upper)
    } else {
        corners(u, v, divide_up)
    }
}

/// Ends of the products of two finite intervals, of which at least one has no numbers on one side of zero, where they are finite.
#[inline(always)]
pub(super) fn product_by_sign(u: [f64; 2], v: [f64; 2]) -> [f64; 2] {
    let (u, v) = if u[0] >= 0.0 {
        (u, v)
    } else if v[0] >= 0.0 {
        (v, u)
    } else if u[1] <= 0.0 {
        (opposite(u), opposite(v))
    } else {
        (opposite(v), opposite(u))
    };
    let least = if v[0] >= 0.0 { u[0] } else { u[1] };
    let largest = if v[1] >= 0.0 { u[1] } else { u[0] };
    [-multiplied_up(-least, v[0]), multiplied_up(largest, v[1])]
}

/// Ends of the quotients of finite intervals, the second without zero, where they are finite.
#[inline(always)]
pub(super) fn quotient_by_sign(u: [f64; 2], v: [f64; 2]) -> [f64; 2] {
    let (u, v) = if v[1] < 0.0 { (opposite(u), opposite(v)) } else { (u, v) };
    let least = if u[0] >= 0.0 { v[1] } else { v[0] };
    let largest = if u[1] >= 0.0 { v[0] } else { v[1] };
    [-divided_up(-u[0], least), divided_up(u[1], largest)]
}

#[inline(always)]
fn opposite([lower, upper]: [f64; 2]) -> [f64; 2] {
    [-upper, -lower]
}

/// `2^exponent u`, in steps that neither overflow nor underflow before the result does.
fn shift_up(u: f64, exponent: i32) -> f64 {
    const STEP: i32 = 512;
    let (mut value, mut left) = (u, exponent);
    while left != 0 && value != 0.0 && value.is_finite() {
        let step = left.clamp(-STEP, STEP);
        value *= f64::from(step).exp2();
        left -= step;
    }
    let is_exact = u == 0.0 || u.is_infinite() || value.abs() >= f64::MIN_POSITIVE;
    let value = if is_exact { overflow_up(value, u.is_infinite()) } else { value.next_up() };
    keep_sign(value, u < 0.0)
}

/// Upper bound of `b s + c s^2` for `b` in `slope`, `s` in an interval around zero: at an end of it or at a vertex inside.
fn quadratic_up(slope: Interval, c: f64, s: Interval) -> f64 {
    let mut most = 0.0_f64;
    for b in [slope.lower, slope.upper] {
        let vertex = (-0.5 * b / c).clamp(s.lower, s.upper);
        for place in [s.lower, s.upper, vertex] {
            most = most.max(place * (b + c * place));
        }
    }
    let size = s.size();
    // Twice the rounding of the two products and the sum; a vertex that is a little off loses far less.
    let lost = 4.0 * f64::EPSILON * size * (slope.size() + c.abs() * size);
    let bound = (most + lost).next_up();
    if bound.is_nan() { f64::INFINITY } else { bound }
}

/// A bound from above, given the rounded result and the sign of what rounding left out.
#[inline(always)]
fn round_up(rounded: f64, left_out: f64) -> f64 {
    if left_out <= 0.0 || rounded.is_nan() { rounded } else { rounded.next_up() }
}

/// `-inf` as a rounded finite result is an overflow: the true result is a finite number.
fn overflow_up(rounded: f64, is_exact: bool) -> f64 {
    if rounded == f64::NEG_INFINITY && !is_exact { f64::MIN } else { rounded }
}

fn add_up(u: f64, v: f64) -> f64 {
    let sum = u + v;
    if sum.is_nan() {
        return f64::INFINITY;
    }
    if sum.is_infinite() {
        return overflow_up(sum, u.is_infinite() || v.is_infinite());
    }
    summed_up(u, v)
}

/// A sum of finite numbers that is finite.
#[inline(always)]
pub(super) fn summed_up(u: f64, v: f64) -> f64 {
    let sum = u + v;
    // The exact rounding error of the sum; a NaN from overflow on the way counts as positive.
    let seen = sum - u;
    let left_out = (u - (sum - seen)) + (v - seen);
    round_up(sum, left_out)
}

/// Products below this have rounding errors that cannot be represented.
const TINY: f64 = 1e-290;

fn multiply_up(u: f64, v: f64) -> f64 {
    if u == 0.0 || v == 0.0 {
        return 0.0;
    }
    let product = u * v;
    if product.is_infinite() {
        return overflow_up(product, u.is_infinite() || v.is_infinite());
    }
    multiplied_up(u, v)
}

/// A product of finite numbers that is finite.
#[inline(always)]
fn multiplied_up(u: f64, v: f64) -> f64 {
    let product = u * v;
    let is_negative = (u < 0.0) != (v < 0.0);
    let left_out = if product.abs() < TINY { 1.0 } else { u.mul_add(v, -product) };
    let rounded = keep_sign(round_up(product, left_out), is_negative);
    if (u == 0.0) | (v == 0.0) { 0.0 } else { rounded }
}

fn divide_up(u: f64, v: f64) -> f64 {
    if u == 0.0 {
        return 0.0;
    }
    let quotient = u / v;
    if quotient.is_infinite() {
        return overflow_up(quotient, u.is_infinite());
    }
    if v.is_infinite() {
        return quotient;
    }
    divided_up(u, v)
}

/// A quotient of finite numbers that is finite.
#[inline(always)]
fn divided_up(u: f64, v: f64) -> f64 {
    let quotient = u / v;
    let is_negative = (u < 0.0) != (v < 0.0);
    let remainder = quotient.mul_add(-v, u);
    let is_sure = (quotient.abs() > TINY) & (u.abs() > TINY) & (remainder.abs() <= f64::MAX);
    let left_out = if is_sure { remainder * v.signum() } else { 1.0 };
    let rounded = keep_sign(round_up(quotient, left_out), is_negative);
    if u == 0.0 { 0.0 } else { rounded }
}

/// Rounding upward does not carry a negative number beyond zero.
#[inline(always)]
fn keep_sign(value: f64, is_negative: bool) -> f64 {
    if is_negative && value > 0.0 { 0.0 } else { value }
}

fn root_up(u: f64) -> f64 {
    let root = u.sqrt();
    if u == 0.0 || u.is_infinite() {
        return root;
    }
    let left_out = if u < TINY { 1.0 } else { root.mul_add(-root, u) };
    round_up(root, left_out)
}

fn root_down(u: f64) -> f64 {
    let root = u.sqrt();
    if u == 0.0 || u.is_infinite() {
        return root;
    }
    if u > TINY && root.mul_add(-root, u) >= 0.0 { root } else { root.next_down().max(0.0) }
}
