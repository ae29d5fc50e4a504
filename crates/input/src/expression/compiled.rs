//! A program as it is run: numbers stand beside the operation that takes them, and a part that occurs again is computed once.

use std::collections::HashMap;

use super::evaluate::{SMALL_STACK, apply};
use super::function::Binary;
use super::program::{Operation, stack_height};
use super::value::Value;

/// Most parts whose values are kept, as the `x/a` of a sum of waves.
const KEPT: usize = 8;

/// Its values have the same bits as by the operations one by one.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Compiled {
    steps: Vec<Step>,
    pub(super) height: usize,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Step {
    Plain(Operation),
    /// The function of the topmost value and a number, which may be off by the error beside it.
    By(Binary, [f64; 2]),
    /// The function of the number and the topmost value.
    Of(Binary, [f64; 2]),
    /// Keeps the topmost value.
    Keep(usize),
    /// Puts a kept value on the stack.
    Kept(usize),
}

impl Compiled {
    pub(super) fn new(operations: &[Operation]) -> Self {
        let parts = parts(operations);
        let kept = kept(&parts);
        let mut copies = vec![None; operations.len()];
        for end in outermost(&parts, |first| kept.contains_key(&first)) {
            copies[parts[end].start] = Some((end, kept[&parts[end].first]));
        }
        let beside = beside(operations, &parts);
        let mut steps = Vec::with_capacity(operations.len());
        let mut index = 0;
        while index < operations.len() {
            if let Some((end, place)) = copies[index] {
                steps.push(Step::Kept(place));
                index = end + 1;
                continue;
            }
            match beside[index] {
                Beside::Number => {}
                Beside::With(step) => steps.push(step),
                Beside::None => steps.push(Step::Plain(operations[index])),
            }
            if let Some(place) = kept.get(&index) {
                steps.push(Step::Keep(*place));
            }
            index += 1;
        }
        Self { steps, height: stack_height(operations) }
    }

    /// The value.
    #[inline(always)]
    pub(super) fn run<V: Value>(&self, variable: impl Fn(usize) -> V) -> V {
        let zero = V::constant(0.0);
        if self.height < SMALL_STACK {
            self.run_on(variable, &mut [zero; SMALL_STACK])
        } else {
            // An array would have its pages touched by all programs.
            self.run_on(variable, &mut vec![zero; self.height + 1])
        }
    }

    #[inline(always)]
    fn run_on<V: Value>(&self, variable: impl Fn(usize) -> V, stack: &mut [V]) -> V {
        let mut kept = [V::constant(0.0); KEPT];
        let mut top = 0;
        for step in &self.steps {
            match *step {
                Step::Plain(operation) => apply(operation, &variable, stack, &mut top),
                Step::By(function, by) => stack[top] = V::binary(function, stack[top], number(by)),
                Step::Of(function, of) => stack[top] = V::binary(function, number(of), stack[top]),
                Step::Keep(place) => kept[place] = stack[top],
                Step::Kept(place) => {
                    top += 1;
                    stack[top] = kept[place];
                }
            }
        }
        stack[top]
    }
}

#[inline(always)]
fn number<V: Value>([value, error]: [f64; 2]) -> V {
    if error == 0.0 { V::constant(value) } else { V::rounded(value, error) }
}

/// What ends with an operation.
#[derive(Debug, Clone, Copy)]
struct Part {
    /// The operation with which it begins.
    start: usize,
    /// That with which the first of all equal parts ends.
    first: usize,
}

/// For each operation the part that ends with it.
fn parts(operations: &[Operation]) -> Vec<Part> {
    let mut known: HashMap<[u64; 4], usize> = HashMap::new();
    let mut parts: Vec<Part> = Vec::with_capacity(operations.len());
    // The last operations of the operands on the stack.
    let mut stack: Vec<usize> = Vec::new();
    for (index, operation) in operations.iter().enumerate() {
        let operands = stack.split_off(stack.len().saturating_sub(operation.operands()));
        let operand = |k: usize| operands.get(k).map_or(0, |end| parts[*end].first as u64);
        let key = match *operation {
            Operation::Constant(value) => [0, value.to_bits(), 0, 0],
            Operation::Rounded(value, error) => [1, value.to_bits(), error.to_bits(), 0],
            Operation::Variable(index) => [2, index as u64, 0, 0],
            Operation::Unary(function) => [3 + 8 * function as u64, operand(0), 0, 0],
            Operation::Binary(function) => [4 + 8 * function as u64, operand(0), operand(1), 0],
            Operation::Where => [5, operand(0), operand(1), operand(2)],
        };
        let start = operands.first().map_or(index, |end| parts[*end].start);
        parts.push(Part { start, first: *known.entry(key).or_insert(index) });
        stack.push(index);
    }
    parts
}

/// The last operations of parts that have been there before and are wanted, each not within another of them, from the last to the first.
fn outermost(parts: &[Part], is_wanted: impl Fn(usize) -> bool) -> Vec<usize> {
    let mut found = Vec::new();
    let mut next = parts.len();
    while let Some(end) = next.checked_sub(1) {
        let Part { start, first } = parts[end];
        let is_copy = first < end && start < end && is_wanted(first);
        next = if is_copy { start } else { end };
        if is_copy {
            found.push(end);
        }
    }
    found
}

/// The parts that are worth keeping, by their last operations, with the places where they are kept.
fn kept(parts: &[Part]) -> HashMap<usize, usize> {
    let mut saved: HashMap<usize, usize> = HashMap::new();
    for end in outermost(parts, |_| true) {
        *saved.entry(parts[end].first).or_default() += end - parts[end].start;
    }
    let mut saved: Vec<(usize, usize)> = saved.into_iter().collect();
    saved.sort_by_key(|(first, saved)| (std::cmp::Reverse(*saved), *first));
    saved.truncate(KEPT);
    saved.into_iter().enumerate().map(|(place, (first, _))| (first, place)).collect()
}

/// What an operation has to do with numbers.
#[derive(Debug, Clone, Copy)]
enum Beside {
    None,
    /// It is one, and stands beside the operation that takes it.
    Number,
    /// It takes one.
    With(Step),
}

fn beside(operations: &[Operation], parts: &[Part]) -> Vec<Beside> {
    let mut beside = vec![Beside::None; operations.len()];
    for (index, operation) in operations.iter().enumerate() {
        let &Operation::Binary(function) = operation else { continue };
        let Some(right) = index.checked_sub(1) else { continue };
        let Some(left) = parts[right].start.checked_sub(1) else { continue };
        if let Some((value, error)) = operations[right].number() {
            beside[index] = Beside::With(Step::By(function, [value, error]));
            beside[right] = Beside::Number;
        } else if let Some((value, error)) = operations[left].number() {
            beside[index] = Beside::With(Step::Of(function, [value, error]));
            beside[left] = Beside::Number;
        }
    }
    beside
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::{Expression, Line};

    #[test]
    fn values_are_those_of_the_operations_one_by_one() {
        let texts = [
            "2*cos(3*(x/0.7) + 0.2) - cos(5*(x/0.7) + 1)/7 + 3*(x/0.7)^2",
            "1/0 - x + 1/0*x",
            "x*(1 + x)*(2 + x*(1 + x)) - where(x > 0.2, x*(1 + x), -x*(1 + x))",
            "min(abs(x), 0.3, 1 - abs(x)) + max(abs(x), 0.3)^1.5 - 2^x",
            "-x",
            "0.25",
            "x - x",
            "hypot(x + 1, x + 1)*(x + 1)",
        ];
        for text in texts {
            let expression = Expression::parse(text, &["x"]).unwrap();
            let height = stack_height(&expression.operations);
            for i in -9..=9 {
                let x = 0.13 * f64::from(i);
                let alone = super::super::evaluate::run(&expression.operations, height, |_| x).0;
                assert_eq!(alone.to_bits(), expression.evaluate(&[x]).to_bits(), "{text}");
                let [_, beside] = expression.evaluate_beside(&[[0.5, x]]);
                assert_eq!(alone.to_bits(), beside.to_bits(), "{text}");
            }
        }
    }

    #[test]
    fn what_occurs_again_is_computed_once() {
        let count = |text: &str| {
            let steps = Expression::parse(text, &["x"]).unwrap().compiled.steps;
            steps.iter().filter(|step| matches!(step, Step::By(Binary::Divide, _))).count()
        };
        assert_eq!(count("cos(x/3) + sin(2*(x/3)) - (x/3)^2"), 1);
        // More parts than are kept are computed as often as they occur.
        let many: String = (1..20).map(|k| format!("+ cos(x/{k}) - sin(x/{k})")).collect();
        assert_eq!(count(&many), 2 * 19 - 8);
        assert_eq!(
            Expression::parse("x", &["x"]).unwrap().evaluate_at(&Line::identity(), 2.0),
            2.0
        );
    }
}
