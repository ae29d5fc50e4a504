//! The compiled form: operations in postfix order.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::folding;
use super::function::{Binary, Unary};

/// Most operations so far of a program in which a wave is folded back: its operand is written twice.
const LONGEST_FOLDED: usize = 256;

/// One step of a program; operands are on a stack.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Operation {
    Constant(f64),
    /// A number computed from others, and what rounding may have made of it at most.
    Rounded(f64, f64),
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
            Operation::Constant(_) | Operation::Rounded(..) | Operation::Variable(_) => 0,
            Operation::Unary(_) => 1,
            Operation::Binary(_) => 2,
            Operation::Where => 3,
        }
    }

    /// The number that it is, and what rounding may have made of it.
    pub(super) fn number(self) -> Option<(f64, f64)> {
        match self {
            Operation::Constant(value) => Some((value, 0.0)),
            Operation::Rounded(value, error) => Some((value, error)),
            _ => None,
        }
    }
}

/// An inverse of a wave applied to that wave: a zigzag or a saw.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Fold {
    /// `asin(sin(u))`.
    Sine,
    /// `acos(cos(u))`.
    Cosine,
    /// `atan(tan(u))`.
    Tangent,
}

impl Fold {
    fn of(outer: Unary, inner: Unary) -> Option<Self> {
        match (outer, inner) {
            (Unary::Asin, Unary::Sin) => Some(Self::Sine),
            (Unary::Acos, Unary::Cos) => Some(Self::Cosine),
            (Unary::Atan, Unary::Tan) => Some(Self::Tangent),
            _ => None,
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
            [.., last] if last.number().is_some() => {
                let known = last.number().and_then(|u| folding::unary(function, u));
                self.fold(Operation::Unary(function), known);
            }
            [operand @ .., Operation::Unary(inner)] => match Fold::of(function, *inner) {
                Some(fold) if operand.len() <= LONGEST_FOLDED => self.fold_back(fold),
                _ => self.operations.push(Operation::Unary(function)),
            },
            _ => self.operations.push(Operation::Unary(function)),
        }
    }

    /// The operand of the last operation folded back: the formula as it is written loses half of its digits where it bends, and its slope all of them.
    fn fold_back(&mut self, fold: Fold) {
        self.operations.pop();
        let end = self.operations.len();
        let operand = self.operations[operand_start(&self.operations, end)..].to_vec();
        let (shift, period) = match fold {
            Fold::Sine => (FRAC_PI_2, TAU),
            Fold::Cosine => (PI, TAU),
            Fold::Tangent => (FRAC_PI_2, PI),
        };
        if fold == Fold::Cosine {
            self.unary(Unary::Abs);
        }
        // u - period floor((u + shift)/period)
        self.operations.extend(operand);
        if fold == Fold::Cosine {
            self.unary(Unary::Abs);
        }
        self.constant(shift);
        self.binary(Binary::Add);
        self.constant(period);
        self.binary(Binary::Divide);
        self.unary(Unary::Floor);
        self.constant(period);
        self.binary(Binary::Multiply);
        self.binary(Binary::Subtract);
        match fold {
            Fold::Tangent => {}
            Fold::Cosine => self.unary(Unary::Abs),
            Fold::Sine => {
                // pi/2 - |u - pi/2|
                self.constant(FRAC_PI_2);
                self.binary(Binary::Subtract);
                self.unary(Unary::Abs);
                self.unary(Unary::Negate);
                self.constant(FRAC_PI_2);
                self.binary(Binary::Add);
            }
        }
    }

    pub(super) fn binary(&mut self, function: Binary) {
        match self.operations.as_slice() {
            [.., u, v] if u.number().is_some() && v.number().is_some() => {
                let operands = u.number().zip(v.number());
                let known = operands.and_then(|(u, v)| folding::binary(function, u, v));
                self.fold(Operation::Binary(function), known);
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
            // The exponent is the number of the machine next to what is written: between 1e-39 and 1e39 that changes a power by less than the accuracy assumed of it.
            [kept @ .., Operation::Rounded(exponent, _)] if function == Binary::Power => {
                let (end, exponent) = (kept.len(), *exponent);
                self.operations[end] = Operation::Constant(exponent);
                self.operations.push(Operation::Binary(function));
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
    fn fold(&mut self, operation: Operation, known: Option<(f64, f64)>) {
        let Some((value, error)) = known else {
            self.operations.push(operation);
            return;
        };
        let kept = self.operations.len() - operation.operands();
        self.operations.truncate(kept);
        self.operations.push(if error == 0.0 {
            Operation::Constant(value)
        } else {
            Operation::Rounded(value, error)
        });
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
