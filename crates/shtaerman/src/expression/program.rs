//! The compiled form: operations in postfix order.

use super::function::{Binary, Unary};

/// One step of a program; operands are on a stack.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Operation {
    Constant(f64),
    Variable(usize),
    Unary(Unary),
    Binary(Binary),
    /// Condition, value where it holds, value elsewhere.
    Where,
}

impl Operation {
    /// How many operands it takes from the stack (and leaves one value).
    pub(super) fn operands(self) -> usize {
        match self {
            Operation::Constant(_) | Operation::Variable(_) => 0,
            Operation::Unary(_) => 1,
            Operation::Binary(_) => 2,
            Operation::Where => 3,
        }
    }
}

/// Collects operations, folding what has no variables.
#[derive(Debug, Default)]
pub(super) struct Builder {
    operations: Vec<Operation>,
}

impl Builder {
    pub(super) fn len(&self) -> usize {
        self.operations.len()
    }

    pub(super) fn finish(self) -> Vec<Operation> {
        self.operations
    }

    pub(super) fn constant(&mut self, value: f64) {
        self.operations.push(Operation::Constant(value));
    }

    pub(super) fn variable(&mut self, index: usize) {
        self.operations.push(Operation::Variable(index));
    }

    pub(super) fn unary(&mut self, function: Unary) {
        match self.operations.as_slice() {
            [.., Operation::Constant(u)] => {
                let value = function.value(*u);
                self.fold(Operation::Unary(function), value);
            }
            _ => self.operations.push(Operation::Unary(function)),
        }
    }

    pub(super) fn binary(&mut self, function: Binary) {
        match self.operations.as_slice() {
            [.., Operation::Constant(u), Operation::Constant(v)] => {
                let value = function.value(*u, *v);
                self.fold(Operation::Binary(function), value);
            }
            // The square is exact to rounding and its enclosure knows that it is not negative.
            [.., Operation::Constant(2.0)] if function == Binary::Power => {
                self.operations.pop();
                // A magnitude squared has no kink.
                if self.operations.last() == Some(&Operation::Unary(Unary::Abs)) {
                    self.operations.pop();
                }
                self.operations.push(Operation::Unary(Unary::Square));
            }
            _ => self.operations.push(Operation::Binary(function)),
        }
    }

    /// The product of the operand compiled from `left` on and the one from `right` on; equal
    /// operands make a square.
    pub(super) fn multiply(&mut self, left: usize, right: usize) {
        let is_square = self.operations.get(left..right) == self.operations.get(right..);
        if is_square {
            self.operations.truncate(right);
            self.unary(Unary::Square);
        } else {
            self.binary(Binary::Multiply);
        }
    }

    pub(super) fn choose(&mut self) {
        self.operations.push(Operation::Where);
    }

    /// Replaces constant operands by the value, unless it is not finite: such a value is reported
    /// with its place when the expression is checked.
    fn fold(&mut self, operation: Operation, value: f64) {
        if value.is_finite() {
            let kept = self.operations.len() - operation.operands();
            self.operations.truncate(kept);
            self.operations.push(Operation::Constant(value));
        } else {
            self.operations.push(operation);
        }
    }
}

/// Height of the stack that a program needs.
pub(super) fn stack_height(operations: &[Operation]) -> usize {
    let (mut height, mut highest) = (0_usize, 0);
    for operation in operations {
        height = (height + 1).saturating_sub(operation.operands());
        highest = highest.max(height);
    }
    highest
}

/// Where the operations of the operand that ends just before `end` begin.
pub(super) fn operand_start(operations: &[Operation], end: usize) -> usize {
    let mut missing = 1;
    let mut start = end;
    while missing > 0 && start > 0 {
        start -= 1;
        missing = missing + operations[start].operands() - 1;
    }
    start
}
