//! The constant that is added to an expression.

use super::Expression;
use super::compiled::Compiled;
use super::folding::remainder_of_sum;
use super::function::{Binary, Unary};
use super::program::{Operation, operand_start};

/// A factor as a quotient, and what rounding may have made of it relative to it, also that of the decimal numbers in it.
#[derive(Debug, Clone, Copy)]
struct Factor {
    above: f64,
    below: f64,
    error: f64,
    decimal: f64,
}

impl Factor {
    const ONE: Self = Self { above: 1.0, below: 1.0, error: 0.0, decimal: 0.0 };

    fn negated(self) -> Self {
        Self { above: -self.above, ..self }
    }

    /// Times a number, or over it.
    fn scaled(self, (value, error): (f64, f64), is_product: bool) -> Self {
        let part = if is_product { self.above } else { self.below };
        let product = part * value;
        let rounding = if part.mul_add(value, -product) == 0.0 { 0.0 } else { f64::EPSILON };
        // Of a quotient to first order, and more than what is beyond.
        let of_value = if error == 0.0 { 0.0 } else { 2.0 * error / value.abs() };
        let error = (self.error + of_value + rounding) * ROOM;
        let decimal = self.decimal + decimal_rounding(value);
        if is_product {
            Self { above: product, error, decimal, ..self }
        } else {
            Self { below: product, error, decimal, ..self }
        }
    }
}

/// Sums of errors are rounded as well.
const ROOM: f64 = 1.0 + 8.0 * f64::EPSILON;

/// Trailing zeros in binary by which a number is known to be what was written: others have so many by chance once in a million.
const EXACT: u32 = 20;

/// What the rounding to double precision may be of a number that was written as a decimal one and perhaps multiplied by its unit, relative to it: none of those that are exact in binary.
#[must_use]
pub fn decimal_rounding(value: f64) -> f64 {
    if value == 0.0 || value.to_bits().trailing_zeros() >= EXACT { 0.0 } else { f64::EPSILON }
}

/// A sum of products with what its rounding leaves out: a known rest, and an error; and what the rounding of decimal numbers may have made of it.
#[derive(Debug, Default)]
struct Total {
    sum: f64,
    rest: f64,
    error: f64,
    decimal: f64,
}

impl Total {
    fn add(&mut self, factor: Factor, (value, error): (f64, f64)) {
        let product = factor.above * value;
        let quotient = product / factor.below;
        let of_product = factor.above.mul_add(value, -product);
        let of_quotient = -quotient.mul_add(factor.below, -product);
        let remainder =
            (of_product + of_quotient) / factor.below + remainder_of_sum(self.sum, quotient);
        self.sum += quotient;
        self.rest += remainder;
        let of_rest = 4.0 * f64::EPSILON * (self.rest.abs() + remainder.abs());
        let of_value = (factor.above / factor.below).abs() * error;
        self.error = (self.error + of_value + factor.error * quotient.abs() + of_rest) * ROOM;
        self.decimal += (factor.decimal + decimal_rounding(value)) * quotient.abs();
    }
}

impl Expression {
    /// The expression without the constants added to it, and their sum: of `x^2/2 + 1` the parts `x^2/2` and 1, also under a sign and within products with
    /// numbers. A large one would take the digits of what is added to it. What the sum lacks to rounding stays in the expression; with the sum comes what the [rounding](decimal_rounding) of its decimal numbers may be.
    pub fn without_constant(&self) -> (Self, [f64; 2]) {
        let mut operations = self.operations.clone();
        let mut total = Total::default();
        // From the last operation to the first, the factors with which operands to come are added; none where they are not.
        let mut factors: Vec<Option<Factor>> = vec![Some(Factor::ONE)];
        for index in (0..operations.len()).rev() {
            let Some(factor) = factors.pop() else { break };
            let operation = operations[index];
            match (operation, factor) {
                (Operation::Constant(_) | Operation::Rounded(..), Some(factor)) => {
                    total.add(factor, operation.number().unwrap_or_default());
                    operations[index] = Operation::Constant(0.0);
                }
                (Operation::Binary(Binary::Add), Some(_)) => factors.extend([factor; 2]),
                (Operation::Binary(Binary::Subtract), Some(by)) => {
                    factors.extend([factor, Some(by.negated())]);
                }
                (Operation::Unary(Unary::Negate), Some(by)) => factors.push(Some(by.negated())),
                (Operation::Binary(Binary::Multiply | Binary::Divide), Some(by)) => {
                    factors.extend(self.scaled(index, by));
                }
                (operation, _) => factors.extend(vec![None; operation.operands()]),
            }
        }
        let rest = Self { compiled: Compiled::new(&operations), operations, ..self.clone() };
        (rest.plus(total.rest, total.error), [total.sum, total.decimal])
    }

    /// The expression with a number added to it that is off by the error at most.
    pub fn plus(self, value: f64, error: f64) -> Self {
        if value == 0.0 && error == 0.0 {
            return self;
        }
        let mut operations = self.operations;
        operations.push(Operation::Rounded(value, error));
        operations.push(Operation::Binary(Binary::Add));
        Self { compiled: Compiled::new(&operations), operations, ..self }
    }

    /// The factors of both operands of a product or quotient, the left one first: that beside a number is scaled by it.
    fn scaled(&self, index: usize, by: Factor) -> [Option<Factor>; 2] {
        let is_product = self.operations[index] == Operation::Binary(Binary::Multiply);
        let right = operand_start(&self.operations, index);
        let (first, second) =
            (self.operations[right - 1].number(), self.operations[right].number());
        match (first, second) {
            (_, Some(number)) if right + 1 == index => [Some(by.scaled(number, is_product)), None],
            (Some(number), _) if is_product => [None, Some(by.scaled(number, true))],
            _ => [None, None],
        }
    }
}
