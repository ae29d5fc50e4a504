//! From tokens to a program: operator precedence by binding powers (Pratt).

use std::cmp::Reverse;
use std::ops::Range;

use super::error::{ErrorReason, ExpressionError};
use super::function::{Binary, CONSTANTS, FUNCTIONS, Function, Unary};
use super::limits::{DEPTH_LIMIT, STACK_LIMIT, TEXT_LIMIT};
use super::program::{Builder, Operation, stack_height};
use super::token::{Lexer, Token, shorten};

type Parsed<T> = Result<T, ExpressionError>;

/// Binding power of a sign before a value: looser than a power, tighter than a product.
const SIGN_POWER: u8 = 7;

impl Binary {
    /// Binding powers of an operator to the left and to the right.
    fn binding(self) -> (u8, u8) {
        match self {
            Binary::Add | Binary::Subtract => (3, 4),
            Binary::Multiply | Binary::Divide => (5, 6),
            Binary::Power => (9, 8),
            // Of the others comparisons alone are operators.
            _ => (1, 2),
        }
    }
}

/// Compiles a text whose variables have these names, and whose magnitudes of variables have those.
pub(super) fn parse(
    text: &str,
    variables: &[&str],
    magnitudes: &[(&str, usize)],
) -> Parsed<Vec<Operation>> {
    if text.len() > TEXT_LIMIT {
        let reason = ErrorReason::TooLong { bytes: text.len(), limit: TEXT_LIMIT };
        return Err(ExpressionError { reason, span: 0..text.len() });
    }
    if text.trim().is_empty() {
        return Err(ExpressionError { reason: ErrorReason::Empty, span: 0..text.len() });
    }
    let mut parser = Parser::new(text, variables, magnitudes)?;
    parser.expression(0)?;
    parser.expect_end()?;
    let operations = parser.builder.finish();
    if stack_height(&operations) > STACK_LIMIT {
        let reason = ErrorReason::TooDeep { limit: DEPTH_LIMIT };
        return Err(ExpressionError { reason, span: 0..text.len() });
    }
    Ok(operations)
}

struct Parser<'a> {
    text: &'a str,
    variables: &'a [&'a str],
    magnitudes: &'a [(&'a str, usize)],
    lexer: Lexer<'a>,
    token: Token,
    span: Range<usize>,
    previous: Range<usize>,
    builder: Builder,
    depth: usize,
}

impl<'a> Parser<'a> {
    fn new(
        text: &'a str,
        variables: &'a [&'a str],
        magnitudes: &'a [(&'a str, usize)],
    ) -> Parsed<Self> {
        let mut lexer = Lexer::new(text);
        let (token, span) = lexer.next()?;
        let builder = Builder::default();
        let previous = 0..0;
        Ok(Parser { text, variables, magnitudes, lexer, token, span, previous, builder, depth: 0 })
    }

    /// Consumes the current token and returns its bytes.
    fn advance(&mut self) -> Parsed<Range<usize>> {
        let (token, span) = self.lexer.next()?;
        self.token = token;
        self.previous = std::mem::replace(&mut self.span, span);
        Ok(self.previous.clone())
    }

    fn fail<T>(&self, reason: ErrorReason) -> Parsed<T> {
        Err(ExpressionError { reason, span: self.span.clone() })
    }

    fn deeper(&mut self) -> Parsed<()> {
        self.depth += 1;
        if self.depth > DEPTH_LIMIT {
            return self.fail(ErrorReason::TooDeep { limit: DEPTH_LIMIT });
        }
        Ok(())
    }

    /// An expression whose operators bind at least as tightly as `minimum`.
    fn expression(&mut self, minimum: u8) -> Parsed<()> {
        let left = self.builder.len();
        self.operand()?;
        let mut has_comparison = false;
        while let Some(operator) = self.operator()? {
            let (binds_left, binds_right) = operator.binding();
            if binds_left < minimum {
                break;
            }
            let is_comparison = binds_left == 1;
            if is_comparison && has_comparison {
                return self.fail(ErrorReason::ChainedComparison);
            }
            has_comparison |= is_comparison;
            let depth = self.depth;
            if operator == Binary::Power {
                self.deeper()?;
            }
            self.advance()?;
            let right = self.builder.len();
            self.expression(binds_right)?;
            self.depth = depth;
            match operator {
                Binary::Multiply => self.builder.multiply(left, right),
                _ => self.builder.binary(operator),
            }
        }
        Ok(())
    }

    /// The operator at hand, or nothing at the end of an expression.
    fn operator(&self) -> Parsed<Option<Binary>> {
        match self.token {
            Token::Operator(operator) => Ok(Some(operator)),
            Token::Close | Token::Comma | Token::End => Ok(None),
            Token::Number(_) | Token::Name | Token::Open => self.missing_operator(),
        }
    }

    fn missing_operator<T>(&self) -> Parsed<T> {
        let left = shorten(&self.text[self.previous.clone()]);
        let right = match self.token {
            Token::Open => "(...)".to_owned(),
            _ => shorten(&self.text[self.span.clone()]),
        };
        let left = if left == ")" { "(...)".to_owned() } else { left };
        let reason = ErrorReason::MissingOperator { left, right };
        Err(ExpressionError { reason, span: self.previous.start..self.span.end })
    }

    fn operand(&mut self) -> Parsed<()> {
        match self.token {
            Token::Number(value) => {
                self.advance()?;
                self.builder.constant(value);
                Ok(())
            }
            Token::Name => self.name(),
            Token::Operator(sign @ (Binary::Subtract | Binary::Add)) => self.signed(sign),
            Token::Open => self.bracket(),
            Token::Operator(_) | Token::Close | Token::Comma | Token::End => self.missing_operand(),
        }
    }

    fn missing_operand<T>(&self) -> Parsed<T> {
        let after = !self.previous.is_empty();
        let span = if after { self.previous.clone() } else { self.span.clone() };
        let neighbour = self.text[span.clone()].to_owned();
        Err(ExpressionError { reason: ErrorReason::MissingOperand { neighbour, after }, span })
    }

    fn signed(&mut self, sign: Binary) -> Parsed<()> {
        self.deeper()?;
        self.advance()?;
        self.expression(SIGN_POWER)?;
        self.depth -= 1;
        if sign == Binary::Subtract {
            self.builder.unary(Unary::Negate);
        }
        Ok(())
    }

    fn bracket(&mut self) -> Parsed<()> {
        self.deeper()?;
        let opening = self.advance()?;
        self.expression(0)?;
        match self.token {
            Token::Close => self.advance()?,
            Token::Comma => return self.fail(ErrorReason::StrayComma),
            _ => return unclosed(opening),
        };
        self.depth -= 1;
        Ok(())
    }

    fn name(&mut self) -> Parsed<()> {
        let span = self.advance()?;
        let name = &self.text[span.clone()];
        let variable = self.variables.iter().position(|known| *known == name);
        let magnitude = self.magnitudes.iter().find(|(known, _)| *known == name);
        let constant = CONSTANTS.iter().find(|(known, _)| *known == name);
        let is_value = variable.is_some() || magnitude.is_some() || constant.is_some();
        let function = Function::named(name);
        if self.token == Token::Open {
            return match function {
                Some(function) => self.call(function, span),
                None if is_value => self.missing_operator(),
                None => Err(unknown_function(name, span)),
            };
        }
        match (variable, magnitude, constant) {
            (Some(index), ..) => self.builder.variable(index),
            (None, Some((_, index)), _) => {
                self.builder.variable(*index);
                self.builder.unary(Unary::Abs);
            }
            (None, None, Some((_, value))) => self.builder.constant(*value),
            (None, None, None) => {
                let reason = match function {
                    Some(_) => ErrorReason::FunctionWithoutArguments { name: name.to_owned() },
                    None => self.unknown_name(name),
                };
                return Err(ExpressionError { reason, span });
            }
        }
        Ok(())
    }

    fn unknown_name(&self, name: &str) -> ErrorReason {
        let constants = CONSTANTS.iter().map(|(known, _)| *known);
        let magnitudes = self.magnitudes.iter().map(|(known, _)| *known);
        let variables = self.variables.iter().copied().chain(magnitudes);
        let known: Vec<&str> = variables.chain(constants).collect();
        let suggestion = nearest(name, &known);
        let known = known.into_iter().map(str::to_owned).collect();
        ErrorReason::UnknownName { name: shorten(name), suggestion, known }
    }

    fn call(&mut self, function: Function, name: Range<usize>) -> Parsed<()> {
        self.deeper()?;
        let opening = self.advance()?;
        let mut found = 0;
        while self.token != Token::Close || found > 0 {
            self.expression(0)?;
            found += 1;
            self.argument_read(function, found);
            match self.token {
                Token::Comma => self.advance()?,
                Token::Close => break,
                _ => return unclosed(opening),
            };
        }
        let closing = self.advance()?;
        self.depth -= 1;
        if function.arity().allows(found) {
            return Ok(());
        }
        let written = self.text[name.clone()].to_owned();
        let reason = ErrorReason::ArgumentCount { name: written, arity: function.arity(), found };
        Err(ExpressionError { reason, span: name.start..closing.end })
    }

    /// Compiles what can be done once this many arguments are on the stack.
    fn argument_read(&mut self, function: Function, found: usize) {
        match (function, found) {
            (Function::One(unary), 1) => self.builder.unary(unary),
            (Function::Two(binary), 2) => self.builder.binary(binary),
            (Function::Many(binary), 2..) => self.builder.binary(binary),
            (Function::Clamp, 2) => self.builder.binary(Binary::Maximum),
            (Function::Clamp, 3) => self.builder.binary(Binary::Minimum),
            (Function::Where, 3) => self.builder.choose(),
            _ => {}
        }
    }

    fn expect_end(&self) -> Parsed<()> {
        match self.token {
            Token::Close => self.fail(ErrorReason::UnopenedBracket),
            Token::Comma => self.fail(ErrorReason::StrayComma),
            _ => Ok(()),
        }
    }
}

fn unclosed<T>(opening: Range<usize>) -> Parsed<T> {
    Err(ExpressionError { reason: ErrorReason::UnclosedBracket, span: opening })
}

fn unknown_function(name: &str, span: Range<usize>) -> ExpressionError {
    let known: Vec<&str> = FUNCTIONS.iter().map(|(known, _)| *known).collect();
    let suggestion = nearest(name, &known);
    let reason = ErrorReason::UnknownFunction { name: shorten(name), suggestion };
    ExpressionError { reason, span }
}

/// The known name nearest to what was written, if it is near.
fn nearest(name: &str, known: &[&str]) -> Option<String> {
    const LONGEST: usize = 32;
    let alias = [("π", "pi"), ("ξ", "xi"), ("sgn", "sign"), ("τ", "tau"), ("if", "where")];
    let alias = alias.iter().find(|(written, _)| *written == name).map(|(_, meant)| *meant);
    if let Some(meant) = alias.filter(|meant| known.contains(meant)) {
        return Some(meant.to_owned());
    }
    if name.len() > LONGEST {
        return None;
    }
    let lower = name.to_lowercase();
    let distance = |candidate: &str| strsim::osa_distance(&lower, &candidate.to_lowercase());
    let allowed = lower.chars().count().div_ceil(3).min(2);
    let is_near = |(distance, candidate): &(usize, &str)| {
        *distance <= allowed && *distance < candidate.chars().count()
    };
    // Of equally near ones that which begins alike: `sinn` is `sin` sooner than `sign`.
    let alike = |known: &str| known.bytes().zip(lower.bytes()).take_while(|(u, v)| u == v).count();
    let near = known.iter().map(|known| (distance(known), *known)).filter(is_near);
    let nearest =
        near.min_by_key(|(distance, known)| (*distance, Reverse(alike(known)), *known))?;
    Some(nearest.1.to_owned())
}
