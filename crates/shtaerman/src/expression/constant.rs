//! The constant that is added to an expression.

use super::Expression;
use super::function::{Binary, Unary};
use super::program::{Operation, operand_start};

impl Expression {
    /// The expression without the constants added to it, and their sum: of `x^2/2 + 1` the parts `x^2/2` and 1, also under a sign and within products with
    /// numbers. A large one would take the digits of what is added to it.
    pub(crate) fn without_constant(&self) -> (Self, f64) {
        let mut operations = self.operations.clone();
        let mut sum = 0.0;
        // From the last operation to the first, the factors with which operands to come are added; none where they are not.
        let mut factors: Vec<Option<f64>> = vec![Some(1.0)];
        for index in (0..operations.len()).rev() {
            let Some(factor) = factors.pop() else { break };
            match (operations[index], factor) {
                (Operation::Constant(value), Some(factor)) => {
                    sum += factor * value;
                    operations[index] = Operation::Constant(0.0);
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
