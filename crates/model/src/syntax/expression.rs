//! Expressions: numbers, names, operations and calls.

use super::name::{Name, StatedUnit};
use crate::Span;
use units::Unit;

/// An expression and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Expression {
    /// Kind of expression.
    pub kind: ExpressionKind,
    /// Place in the source.
    pub span: Span,
}

/// The kinds of expression.
#[derive(Clone, Debug, PartialEq)]
pub enum ExpressionKind {
    /// `9.8 [m/s^2]`; the value in the unit given.
    Number {
        /// The number as written.
        value: f64,
        /// The unit after it.
        unit: Option<Unit>,
    },
    /// `"underdamped"`
    Text(String),
    /// `y''` or `m`; also `pi` and the independent variable.
    Name {
        /// The ASCII name.
        name: String,
        /// Derivative order: the number of primes.
        order: u32,
    },
    /// `y'(0)` on the right: the value at the start of the run.
    InitialValue {
        /// The ASCII name.
        name: String,
        /// Derivative order: the number of primes.
        order: u32,
    },
    /// `x[i+1]''`, `u[i, j]`: a member of a family; `x[i](0)`: its initial value.
    Member {
        /// The ASCII name of the family.
        name: String,
        /// Indices of the member.
        indices: Vec<Expression>,
        /// Derivative order: the number of primes.
        order: u32,
        /// True for the initial value.
        at_start: bool,
    },
    /// `sum(m*x[i]'^2/2 for i in 1..N)`
    Reduction {
        /// Function that combines the values: `sum`, `min` or `max`.
        function: Name,
        /// Value for each index.
        body: Box<Expression>,
        /// Indices with their ranges.
        over: Vec<Over>,
    },
    /// `(1, 0) [au]`: a vector given by its components.
    Tuple {
        /// The components, 2 or 3.
        parts: Vec<Expression>,
        /// The unit after it, which is the unit of every component.
        unit: Option<Unit>,
    },
    /// `r[i].x`, `(a - b).y`: a component of a vector expression. A component of a named vector is a name, `r.x`.
    Component {
        /// The vector.
        of: Box<Expression>,
        /// Index of the component, from 0.
        axis: usize,
    },
    /// `-x`, `not x`
    Unary(UnaryOperator, Box<Expression>),
    /// `a + b`
    Binary(BinaryOperator, Box<Expression>, Box<Expression>),
    /// `sin(x)`; the function need not exist.
    Call {
        /// The name before the parenthesis.
        function: Name,
        /// Arguments.
        arguments: Vec<Expression>,
    },
    /// `if c then a else b`
    If(Box<Expression>, Box<Expression>, Box<Expression>),
    /// An expanded call of a user-defined function. The parser creates none.
    Expansion(Box<Expansion>),
    /// An unreadable expression. A diagnostic was reported, and no further ones follow from it.
    Error,
}

/// `i in 1..N`: an index and its integer values, both ends included.
#[derive(Clone, Debug, PartialEq)]
pub struct Over {
    /// The index.
    pub index: Name,
    /// Least value.
    pub low: Expression,
    /// Greatest value; there are no values if it is less than the least one.
    pub high: Expression,
}

/// An expanded call of a user-defined function. The outer expression has the span of the call. The spans in its body are
/// those of the function statement, except in the arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Expansion {
    /// Name of the function.
    pub function: String,
    /// Text of the call, for messages.
    pub written: String,
    /// Body of the function, with the arguments substituted.
    pub body: Expression,
    /// Stated unit of the function.
    pub unit: Option<StatedUnit>,
}

/// Prefix operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum UnaryOperator {
    /// `-`
    Negate,
    /// `not`
    Not,
}

/// Infix operators.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "each says itself")]
pub enum BinaryOperator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Less,
    LessOrEqual,
    Greater,
    GreaterOrEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

impl BinaryOperator {
    /// True if the result is a truth value.
    pub(crate) fn is_logical(self) -> bool {
        use BinaryOperator::{And, Equal, Greater, GreaterOrEqual, Less, LessOrEqual, NotEqual, Or};
        matches!(self, Less | LessOrEqual | Greater | GreaterOrEqual | Equal | NotEqual | And | Or)
    }
}

impl Expression {
    /// A number without a unit.
    pub(crate) fn number(value: f64, span: Span) -> Self {
        Self { kind: ExpressionKind::Number { value, unit: None }, span }
    }

    /// A name without primes.
    pub(crate) fn named(name: &str, span: Span) -> Self {
        Self::derivative(name, 0, span)
    }

    /// A name with `order` primes.
    pub(crate) fn derivative(name: &str, order: u32, span: Span) -> Self {
        Self { kind: ExpressionKind::Name { name: name.to_owned(), order }, span }
    }

    /// An operation such as `left + right`.
    pub(crate) fn binary(operator: BinaryOperator, left: Self, right: Self, span: Span) -> Self {
        Self { kind: ExpressionKind::Binary(operator, Box::new(left), Box::new(right)), span }
    }

    /// An operation such as `-operand`.
    pub(crate) fn unary(operator: UnaryOperator, operand: Self, span: Span) -> Self {
        Self { kind: ExpressionKind::Unary(operator, Box::new(operand)), span }
    }

    /// `function(arguments)`
    pub(crate) fn call(function: &str, arguments: Vec<Self>, span: Span) -> Self {
        let function = Name { text: function.to_owned(), span };
        Self { kind: ExpressionKind::Call { function, arguments }, span }
    }

    /// `if condition then chosen else other`
    pub(crate) fn conditional(condition: Self, chosen: Self, other: Self, span: Span) -> Self {
        let [condition, chosen, other] = [condition, chosen, other].map(Box::new);
        Self { kind: ExpressionKind::If(condition, chosen, other), span }
    }

    /// An undefined value that fits every dimension.
    pub(crate) fn nothing(span: Span) -> Self {
        Self { kind: ExpressionKind::Error, span }
    }

    /// Calls `visit` with the direct operands, in text order.
    pub fn for_each_operand<'a>(&'a self, mut visit: impl FnMut(&'a Self)) {
        match &self.kind {
            ExpressionKind::Number { .. }
            | ExpressionKind::Text(_)
            | ExpressionKind::Name { .. }
            | ExpressionKind::InitialValue { .. }
            | ExpressionKind::Error => {}
            ExpressionKind::Member { indices: list, .. }
            | ExpressionKind::Tuple { parts: list, .. }
            | ExpressionKind::Call { arguments: list, .. } => list.iter().for_each(visit),
            ExpressionKind::Reduction { body, over, .. } => {
                visit(body);
                over.iter().flat_map(|over| [&over.low, &over.high]).for_each(visit);
            }
            ExpressionKind::Component { of: operand, .. } | ExpressionKind::Unary(_, operand) => visit(operand),
            ExpressionKind::Binary(_, left, right) => {
                visit(left);
                visit(right);
            }
            ExpressionKind::Expansion(expansion) => visit(&expansion.body),
            ExpressionKind::If(condition, chosen, other) => {
                visit(condition);
                visit(chosen);
                visit(other);
            }
        }
    }

    /// The direct operands, in text order.
    pub fn operands(&self) -> Vec<&Self> {
        let mut operands = Vec::new();
        self.for_each_operand(|operand| operands.push(operand));
        operands
    }

    /// A copy with `map` of each direct operand in its place, in text order; `None` as soon as `map` gives none.
    pub(crate) fn with_operands(&self, map: &mut dyn FnMut(&Self) -> Option<Self>) -> Option<Self> {
        let mut all = |list: &[Self]| list.iter().map(&mut *map).collect::<Option<Vec<Self>>>();
        let kind = match &self.kind {
            ExpressionKind::Number { .. }
            | ExpressionKind::Text(_)
            | ExpressionKind::Name { .. }
            | ExpressionKind::InitialValue { .. }
            | ExpressionKind::Error => self.kind.clone(),
            ExpressionKind::Member { name, indices, order, at_start } => ExpressionKind::Member {
                name: name.clone(),
                indices: all(indices)?,
                order: *order,
                at_start: *at_start,
            },
            ExpressionKind::Reduction { function, body, over } => {
                let body = Box::new(map(body)?);
                let mut ranges = Vec::with_capacity(over.len());
                for Over { index, low, high } in over {
                    ranges.push(Over { index: index.clone(), low: map(low)?, high: map(high)? });
                }
                ExpressionKind::Reduction { function: function.clone(), body, over: ranges }
            }
            ExpressionKind::Tuple { parts, unit } => ExpressionKind::Tuple { parts: all(parts)?, unit: unit.clone() },
            ExpressionKind::Component { of, axis } => ExpressionKind::Component { of: Box::new(map(of)?), axis: *axis },
            ExpressionKind::Unary(operator, operand) => ExpressionKind::Unary(*operator, Box::new(map(operand)?)),
            ExpressionKind::Binary(operator, left, right) => {
                ExpressionKind::Binary(*operator, Box::new(map(left)?), Box::new(map(right)?))
            }
            ExpressionKind::Call { function, arguments } => {
                ExpressionKind::Call { function: function.clone(), arguments: all(arguments)? }
            }
            ExpressionKind::If(condition, chosen, other) => {
                ExpressionKind::If(Box::new(map(condition)?), Box::new(map(chosen)?), Box::new(map(other)?))
            }
            ExpressionKind::Expansion(expansion) => {
                let Expansion { function, written, body, unit } = &**expansion;
                let (function, written, unit) = (function.clone(), written.clone(), unit.clone());
                ExpressionKind::Expansion(Box::new(Expansion { function, written, body: map(body)?, unit }))
            }
        };
        Some(Self { kind, span: self.span })
    }

    /// The direct operands, mutable.
    pub fn operands_mut(&mut self) -> Vec<&mut Self> {
        match &mut self.kind {
            ExpressionKind::Number { .. }
            | ExpressionKind::Text(_)
            | ExpressionKind::Name { .. }
            | ExpressionKind::InitialValue { .. }
            | ExpressionKind::Error => Vec::new(),
            ExpressionKind::Member { indices, .. } => indices.iter_mut().collect(),
            ExpressionKind::Reduction { body, over, .. } => {
                let bounds = over.iter_mut().flat_map(|over| [&mut over.low, &mut over.high]);
                std::iter::once(&mut **body).chain(bounds).collect()
            }
            ExpressionKind::Tuple { parts, .. } => parts.iter_mut().collect(),
            ExpressionKind::Component { of, .. } => vec![of],
            ExpressionKind::Unary(_, operand) => vec![operand],
            ExpressionKind::Binary(_, left, right) => vec![left, right],
            ExpressionKind::Call { arguments, .. } => arguments.iter_mut().collect(),
            ExpressionKind::Expansion(expansion) => vec![&mut expansion.body],
            ExpressionKind::If(condition, chosen, other) => vec![condition, chosen, other],
        }
    }
}
