//! The constant that is added to an expression.

use super::Expression;
use super::function::{Binary, Unary};
use super::program::{Operation, operand_start};

impl Expression {
    /// The expression without the constants added to it, and their sum: of `x^2/2 + 1` the parts `x^2/2` and 1, also under a sign and within products with
    /// numbers. A large one would take the digits of what is added to it. What the sum loses in rounding stays in the expression.
    pub(crate) fn without_constant(&self) -> (Self, f64) {
        let mut operations = self.operations.clone();
        let (mut sum, mut lost) = (0.0f64, 0.0f64);
        let mut kept: Option<(usize, f64)> = None;
        // From the last operation to the first, the factors with which operands to come are added; none where they are not.
        let mut factors: Vec<Option<f64>> = vec![Some(1.0)];
        for index in (0..operations.len()).rev() {
            let Some(factor) = factors.pop() else { break };
            match (operations[index], factor) {
                (Operation::Constant(value), Some(factor)) => {
                    let term = factor * value;
                    let total = sum + term;
                    // What rounding takes of a product and of a sum is a number (T. J. Dekker, Numer. Math. 18 (1971) 224).
                    let share = total - sum;
                    lost +=
                        factor.mul_add(value, -term) + ((sum - (total - share)) + (term - share));
                    sum = total;
                    operations[index] = Operation::Constant(0.0);
                    if factor != 0.0 {
                        kept = Some((index, factor));
                    }
                }
                (Operation::Binary(Binary::Add), Some(_)) => factors.extend([factor; 2]),
                (Operation::Binary(Binary::Subtract), Some(by)) => {
                    factors.extend([factor, Some(-by)]);
                }
                (Operation::Unary(Unary::Negate), Some(by)) => factors.push(Some(-by)),
                (Operation::Binary(Binary::Multiply | Binary::Divide), Some(by)) => {
                    factors.extend(self.scaled(index, by));
                }
                (operation, _) => factors.extend(vec![None; operation.operands()]),
            }
        }
        if let Some((index, factor)) = kept.filter(|(_, factor)| (lost / factor).is_finite()) {
            operations[index] = Operation::Constant(lost / factor);
        }
        (Self { operations, ..self.clone() }, sum)
    }

    /// The factors of both operands of a product or quotient, the left one first: that beside a number is scaled by it.
    fn scaled(&self, index: usize, by: f64) -> [Option<f64>; 2] {
        let is_product = self.operations[index] == Operation::Binary(Binary::Multiply);
        let right = operand_start(&self.operations, index);
        match (self.operations[right - 1], self.operations[right]) {
            (_, Operation::Constant(value)) if right + 1 == index => {
                [Some(if is_product { by * value } else { by / value }), None]
            }
            (Operation::Constant(value), _) if is_product => [None, Some(by * value)],
            _ => [None, None],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of `1e6` and small constants the sum cannot keep all digits; the expression does.
    #[test]
    fn what_the_sum_loses_stays() {
        let parsed = Expression::parse("1e6 - 2*(0.1 + x) - 0.7/3", &["x"]).unwrap();
        let (rest, level) = parsed.without_constant();
        let exact = 1e6 - 0.2 - 0.7 / 3.0;
        assert!((level - exact).abs() <= 1.2e-10);
        // level + rest(x) = 1e6 - 0.2 - 0.2333.. - 2 x, compared without the 1e6.
        let taken = (1e6 - level) - 0.7 / 3.0 - 0.2;
        assert!((rest.evaluate(&[0.0]) - taken).abs() < 1e-16, "{}", rest.evaluate(&[0.0]));
        assert!((rest.evaluate(&[0.25]) + 0.5 - taken).abs() < 2e-16);
        // Nothing is left where nothing was lost.
        let (rest, level) = Expression::parse("x^2/2 + 1", &["x"]).unwrap().without_constant();
        assert_eq!((rest.evaluate(&[0.0]), level), (0.0, 1.0));
    }
}
