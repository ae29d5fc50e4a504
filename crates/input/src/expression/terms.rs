//! Formulas as terms of a table in which what is equal has the same number.
//!
//! A term is a number and a sign, so that `sin(-u)` is minus the term of `sin(u)` and `cos(-u)` the term of `cos(u)`. Sums, products and minima are kept as sorted lists of all
//! their members, so that neither order nor brackets matter; opposite members of a sum cancel. Nothing is rounded: what has the same term has the same value.

use std::collections::HashMap;
use std::rc::Rc;

use super::function::{Binary, Unary};

/// Members of all lists together at most: beyond nothing is proved.
const MOST_MEMBERS: usize = 1 << 16;

/// A node of the table or its negative.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Term {
    node: usize,
    is_negated: bool,
}

/// What is known of the sign of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sign {
    Zero,
    Positive,
    NotNegative,
    Negative,
    NotPositive,
    Unknown,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Group {
    Sum,
    Product,
    /// A maximum is minus the minimum of the negatives.
    Minimum,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash)]
enum Node {
    /// The bits of a number that is not negative.
    Constant(u64),
    Variable(usize),
    Many(Group, Rc<[Term]>),
    Reciprocal(Term),
    One(Unary, Term),
    Two(Binary, Term, Term),
    Where([Term; 3]),
}

/// The table.
#[derive(Debug)]
pub(super) struct Terms {
    known: HashMap<Node, usize>,
    nodes: Vec<(Node, Sign)>,
    members: usize,
}

const ZERO: Term = Term { node: 0, is_negated: false };

impl Term {
    pub(super) fn negated(self) -> Self {
        // There is one zero.
        Self { is_negated: self != ZERO && !self.is_negated, ..self }
    }

    fn negated_if(self, condition: bool) -> Self {
        if condition { self.negated() } else { self }
    }

    fn magnitude(self) -> Self {
        Self { is_negated: false, ..self }
    }
}

impl Sign {
    fn negated(self) -> Self {
        match self {
            Self::Positive => Self::Negative,
            Self::NotNegative => Self::NotPositive,
            Self::Negative => Self::Positive,
            Self::NotPositive => Self::NotNegative,
            Self::Zero | Self::Unknown => self,
        }
    }

    fn is_at_least_zero(self) -> bool {
        matches!(self, Self::Zero | Self::Positive | Self::NotNegative)
    }

    fn is_at_most_zero(self) -> bool {
        self.negated().is_at_least_zero()
    }

    fn positive_if(condition: bool) -> Self {
        if condition { Self::Positive } else { Self::NotNegative }
    }
}

impl Terms {
    pub(super) fn new() -> Self {
        let mut terms = Self { known: HashMap::new(), nodes: Vec::new(), members: 0 };
        terms.constant(0.0);
        terms
    }

    /// Whether there was more to keep than there is room for: then terms mean nothing.
    pub(super) fn is_full(&self) -> bool {
        self.members > MOST_MEMBERS
    }

    pub(super) fn constant(&mut self, value: f64) -> Term {
        let sign = if value == 0.0 { Sign::Zero } else { Sign::Positive };
        let term = self.keep(Node::Constant(value.abs().to_bits()), sign);
        term.negated_if(value < 0.0)
    }

    /// A variable that is positive.
    pub(super) fn positive_variable(&mut self, index: usize) -> Term {
        self.keep(Node::Variable(index), Sign::Positive)
    }

    pub(super) fn unary(&mut self, function: Unary, u: Term) -> Term {
        let sign = self.sign(u);
        let at_least_zero = sign.is_at_least_zero();
        match function {
            Unary::Negate => u.negated(),
            Unary::Square => self.product(u, u),
            Unary::Abs if at_least_zero => u,
            Unary::Abs if sign.is_at_most_zero() => u.negated(),
            Unary::Abs => self.keep(Node::One(function, u.magnitude()), Sign::NotNegative),
            Unary::Sign if sign == Sign::Positive => self.constant(1.0),
            Unary::Sign if sign == Sign::Negative => self.constant(-1.0),
            Unary::Step if at_least_zero => self.constant(1.0),
            Unary::Step if sign == Sign::Negative => ZERO,
            Unary::Cos => self.keep(Node::One(function, u.magnitude()), Sign::Unknown),
            Unary::Cosh => self.keep(Node::One(function, u.magnitude()), Sign::Positive),
            Unary::Sin | Unary::Tan => self.odd(function, u, Sign::Unknown),
            Unary::Cbrt
            | Unary::Asin
            | Unary::Atan
            | Unary::Sinh
            | Unary::Tanh
            | Unary::Asinh
            | Unary::Atanh
            | Unary::Sign => self.odd(function, u, self.sign(u.magnitude())),
            Unary::Expm1 | Unary::Log1p => self.keep(Node::One(function, u), sign),
            Unary::Sqrt => {
                self.keep(Node::One(function, u), Sign::positive_if(sign == Sign::Positive))
            }
            // What is positive may round to zero.
            Unary::Exp | Unary::Acos | Unary::Acosh | Unary::Step => {
                self.keep(Node::One(function, u), Sign::NotNegative)
            }
            Unary::Ln | Unary::Log10 | Unary::Log2 | Unary::Floor | Unary::Ceil => {
                self.keep(Node::One(function, u), Sign::Unknown)
            }
        }
    }

    pub(super) fn binary(&mut self, function: Binary, u: Term, v: Term) -> Term {
        match function {
            Binary::Add => self.sum(u, v),
            Binary::Subtract => self.sum(u, v.negated()),
            Binary::Multiply => self.product(u, v),
            Binary::Divide => {
                let is_least = self.sign(v.magnitude()).is_at_least_zero();
                let sign = if is_least { Sign::NotNegative } else { Sign::Unknown };
                let reciprocal = self.keep(Node::Reciprocal(v.magnitude()), sign);
                self.product(u, reciprocal.negated_if(v.is_negated))
            }
            Binary::Power => self.power(u, v),
            Binary::Minimum => self.minimum(u, v),
            Binary::Maximum => self.minimum(u.negated(), v.negated()).negated(),
            Binary::Hypot => {
                let (a, b) = (u.magnitude().min(v.magnitude()), u.magnitude().max(v.magnitude()));
                self.keep(Node::Two(function, a, b), Sign::NotNegative)
            }
            Binary::Atan2 => self.keep(Node::Two(function, u, v), Sign::Unknown),
            Binary::Less => self.is_below_zero(false, u, v),
            Binary::LessEqual => self.is_below_zero(true, u, v),
            Binary::Greater => self.is_below_zero(false, v, u),
            Binary::GreaterEqual => self.is_below_zero(true, v, u),
        }
    }

    pub(super) fn choose(&mut self, condition: Term, holds: Term, fails: Term) -> Term {
        match self.sign(condition) {
            Sign::Zero => return fails,
            Sign::Positive | Sign::Negative => return holds,
            _ if holds == fails => return holds,
            _ => {}
        }
        let flips = holds.is_negated;
        let branches = [holds.negated_if(flips), fails.negated_if(flips)];
        let is_least = branches.iter().all(|branch| self.sign(*branch).is_at_least_zero());
        let sign = if is_least { Sign::NotNegative } else { Sign::Unknown };
        let node = Node::Where([condition.magnitude(), branches[0], branches[1]]);
        self.keep(node, sign).negated_if(flips)
    }

    fn odd(&mut self, function: Unary, u: Term, sign: Sign) -> Term {
        self.keep(Node::One(function, u.magnitude()), sign).negated_if(u.is_negated)
    }

    fn sum(&mut self, u: Term, v: Term) -> Term {
        let mut members = self.members(Group::Sum, u);
        members.extend(self.members(Group::Sum, v));
        members.sort_unstable();
        let mut left: Vec<Term> = Vec::with_capacity(members.len());
        for member in members.into_iter().filter(|member| *member != ZERO) {
            if left.last() == Some(&member.negated()) {
                left.pop();
            } else {
                left.push(member);
            }
        }
        let Some(first) = left.first().copied() else { return ZERO };
        let flips = first.is_negated;
        left.iter_mut().for_each(|member| *member = member.negated_if(flips));
        let signs = || left.iter().map(|member| self.sign(*member));
        let sign = if signs().all(Sign::is_at_least_zero) {
            Sign::positive_if(signs().any(|sign| sign == Sign::Positive))
        } else {
            Sign::Unknown
        };
        self.group(Group::Sum, left, sign).negated_if(flips)
    }

    fn product(&mut self, u: Term, v: Term) -> Term {
        if u == ZERO || v == ZERO {
            return ZERO;
        }
        let flips = u.is_negated != v.is_negated;
        let mut members = self.members(Group::Product, u.magnitude());
        members.extend(self.members(Group::Product, v.magnitude()));
        members.sort_unstable();
        let sign = self.sign_of_product(&members);
        self.group(Group::Product, members, sign).negated_if(flips)
    }

    fn sign_of_product(&self, members: &[Term]) -> Sign {
        let mut runs = members.chunk_by(|one, other| one == other);
        let is_least =
            |run: &[Term]| run.len().is_multiple_of(2) || self.sign(run[0]).is_at_least_zero();
        if runs.all(is_least) { Sign::NotNegative } else { Sign::Unknown }
    }

    fn minimum(&mut self, u: Term, v: Term) -> Term {
        let mut members = self.members(Group::Minimum, u);
        members.extend(self.members(Group::Minimum, v));
        members.sort_unstable();
        members.dedup();
        let signs = || members.iter().map(|member| self.sign(*member));
        let sign = if signs().any(|sign| sign == Sign::Negative) {
            Sign::Negative
        } else if signs().any(Sign::is_at_most_zero) {
            Sign::NotPositive
        } else if signs().all(Sign::is_at_least_zero) {
            Sign::positive_if(signs().all(|sign| sign == Sign::Positive))
        } else {
            Sign::Unknown
        };
        self.group(Group::Minimum, members, sign)
    }

    fn power(&mut self, base: Term, exponent: Term) -> Term {
        let sign = self.sign(base);
        let whole = self.value(exponent).filter(|value| value.fract() == 0.0);
        let Some(whole) = whole else {
            let known = if sign.is_at_least_zero() { Sign::NotNegative } else { Sign::Unknown };
            return self.keep(Node::Two(Binary::Power, base, exponent), known);
        };
        let node = Node::Two(Binary::Power, base.magnitude(), exponent);
        if whole % 2.0 == 0.0 {
            return self.keep(node, Sign::NotNegative);
        }
        let is_least = self.sign(base.magnitude()).is_at_least_zero();
        let known = if is_least { Sign::NotNegative } else { Sign::Unknown };
        self.keep(node, known).negated_if(base.is_negated)
    }

    /// 1 where `u - v` is negative, or also where it is zero, else 0.
    fn is_below_zero(&mut self, or_zero: bool, u: Term, v: Term) -> Term {
        let difference = self.sum(u, v.negated());
        let sign = self.sign(difference);
        let (holds, fails) = if or_zero {
            (sign.is_at_most_zero(), sign == Sign::Positive)
        } else {
            (sign == Sign::Negative, sign.is_at_least_zero())
        };
        if holds {
            return self.constant(1.0);
        }
        if fails {
            return ZERO;
        }
        let function = if or_zero { Binary::LessEqual } else { Binary::Less };
        self.keep(Node::Two(function, difference, ZERO), Sign::NotNegative)
    }

    /// The terms that a term is made of.
    fn members(&self, group: Group, term: Term) -> Vec<Term> {
        match &self.nodes[term.node].0 {
            Node::Many(own, members) if *own == group && !term.is_negated => members.to_vec(),
            Node::Many(Group::Sum, members) if group == Group::Sum => {
                members.iter().map(|member| member.negated()).collect()
            }
            _ => vec![term],
        }
    }

    fn group(&mut self, group: Group, members: Vec<Term>, sign: Sign) -> Term {
        if let [only] = members[..] {
            return only;
        }
        self.members += members.len();
        if self.is_full() {
            return ZERO;
        }
        self.keep(Node::Many(group, members.into()), sign)
    }

    fn keep(&mut self, node: Node, sign: Sign) -> Term {
        let next = self.nodes.len();
        let node = *self.known.entry(node.clone()).or_insert_with(|| {
            self.nodes.push((node, sign));
            next
        });
        Term { node, is_negated: false }
    }

    fn sign(&self, term: Term) -> Sign {
        let sign = self.nodes[term.node].1;
        if term.is_negated { sign.negated() } else { sign }
    }

    fn value(&self, term: Term) -> Option<f64> {
        let Node::Constant(bits) = self.nodes[term.node].0 else { return None };
        let value = f64::from_bits(bits);
        Some(if term.is_negated { -value } else { value })
    }
}
