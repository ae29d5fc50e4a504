//! Runs a program over any kind of value: numbers, numbers with a derivative, enclosures.

use super::program::Operation;
use super::value::Value;

/// Height of the stack that most programs make do with: zeroing it costs next to nothing.
pub(super) const SMALL_STACK: usize = 16;

/// Runs the operations and returns the two topmost values (the second one only means something
/// when the operations leave two values). `height` is the stack they need.
pub(super) fn run<V: Value>(
    operations: &[Operation],
    height: usize,
    variable: impl Fn(usize) -> V,
) -> (V, V) {
    let zero = V::constant(0.0);
    if height < SMALL_STACK {
        run_on(operations, variable, &mut [zero; SMALL_STACK])
    } else {
        run_on(operations, variable, &mut vec![zero; height + 1])
    }
}

/// `stack[0]` lies below the values, so that there are always two topmost ones.
fn run_on<V: Value>(
    operations: &[Operation],
    variable: impl Fn(usize) -> V,
    stack: &mut [V],
) -> (V, V) {
    let mut top = 0;
    for operation in operations {
        apply(*operation, &variable, stack, &mut top);
    }
    (stack[top], stack[top.saturating_sub(1)])
}

#[inline(always)]
pub(super) fn apply<V: Value>(
    operation: Operation,
    variable: &impl Fn(usize) -> V,
    stack: &mut [V],
    top: &mut usize,
) {
    match operation {
        Operation::Constant(value) => {
            *top += 1;
            stack[*top] = V::constant(value);
        }
        Operation::Rounded(value, error) => {
            *top += 1;
            stack[*top] = V::rounded(value, error);
        }
        Operation::Variable(index) => {
            *top += 1;
            stack[*top] = variable(index);
        }
        Operation::Unary(function) => stack[*top] = V::unary(function, stack[*top]),
        Operation::Binary(function) => {
            *top -= 1;
            stack[*top] = V::binary(function, stack[*top], stack[*top + 1]);
        }
        Operation::Where => {
            *top -= 2;
            stack[*top] = V::choose(stack[*top], stack[*top + 1], stack[*top + 2]);
        }
    }
}
