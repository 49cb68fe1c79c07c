//! Values that the translation computes with: expressions of the document's language, over the names of the simulation.

use crate::script::Operator;
use units::number::shortest;

/// Expression. Names are keys of [`super::names::Names`], which gives them their spelling in the document.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    /// Number as it is written, and its value.
    Number(String, f64),
    Text(String),
    Truth(bool),
    /// `undefined`.
    Nothing,
    Name(String),
    /// Variable that fixed relations read before they write it: its value of the step before. In no value of the document.
    Past(String),
    /// A state at the start of the run.
    Start(String),
    Negative(Box<Self>),
    Not(Box<Self>),
    Binary(Operator, Box<Self>, Box<Self>),
    If(Box<Self>, Box<Self>, Box<Self>),
    /// Function of the language.
    Call(&'static str, Vec<Self>),
    /// Function of the simulation, by its key.
    Own(String, Vec<Self>),
    /// Text put together of texts and numbers.
    Join(Vec<Self>),
    /// Number with this number of decimals, inside a text.
    Decimals(Box<Self>, usize),
}

/// Kind of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Number,
    Truth,
    Text,
}

impl Value {
    pub fn number(value: f64) -> Self {
        if value < 0.0 { Self::Negative(Box::new(Self::number(-value))) } else { Self::Number(shortest(value), value) }
    }

    /// Number as JavaScript writes it, `.5` and `5.` included.
    pub fn literal(text: &str, value: f64) -> Self {
        let text = text.to_ascii_lowercase().replace("e+", "e");
        let (mantissa, exponent) =
            text.split_once('e').map_or((text.as_str(), None), |(mantissa, power)| (mantissa, Some(power)));
        let mantissa = mantissa.trim_end_matches('.');
        let zero = if mantissa.starts_with('.') || mantissa.is_empty() { "0" } else { "" };
        let exponent = exponent.map(|power| format!("e{power}")).unwrap_or_default();
        Self::Number(format!("{zero}{mantissa}{exponent}"), value)
    }

    pub fn binary(operator: Operator, left: Self, right: Self) -> Self {
        Self::Binary(operator, Box::new(left), Box::new(right))
    }

    pub fn negative(self) -> Self {
        match self {
            Self::Negative(inner) => *inner,
            other => Self::Negative(Box::new(other)),
        }
    }

    pub fn not(self) -> Self {
        match self {
            Self::Truth(truth) => Self::Truth(!truth),
            Self::Not(inner) => *inner,
            Self::Binary(operator, left, right) if opposite(operator).is_some() => {
                Self::Binary(opposite(operator).unwrap_or(operator), left, right)
            }
            other => Self::Not(Box::new(other)),
        }
    }

    pub fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Truth(true), other) | (other, Self::Truth(true)) => other,
            (Self::Truth(false), _) | (_, Self::Truth(false)) => Self::Truth(false),
            (left, right) if left == right => left,
            (left, right) => Self::binary(Operator::And, left, right),
        }
    }

    pub fn or(self, other: Self) -> Self {
        match (self, other) {
            (Self::Truth(false), other) | (other, Self::Truth(false)) => other,
            (Self::Truth(true), _) | (_, Self::Truth(true)) => Self::Truth(true),
            (left, right) if left == right => left,
            (left, right) => Self::binary(Operator::Or, left, right),
        }
    }

    /// `if condition then yes else no`; truth values become `and` and `or`, because the language has no constants for them.
    pub fn choose(condition: Self, yes: Self, no: Self) -> Self {
        match (condition, yes, no) {
            (Self::Truth(true), yes, _) => yes,
            (Self::Truth(false), _, no) => no,
            (_, yes, no) if yes == no => yes,
            (condition, Self::Truth(true), no) => condition.or(no),
            (condition, Self::Truth(false), no) => condition.not().and(no),
            (condition, yes, Self::Truth(true)) => condition.not().or(yes),
            (condition, yes, Self::Truth(false)) => condition.and(yes),
            (Self::Not(condition), yes, no) => Self::If(condition, Box::new(no), Box::new(yes)),
            (condition, yes, no) => Self::If(Box::new(condition), Box::new(yes), Box::new(no)),
        }
    }

    /// True for what is shorter than a name for it: a number, a text, a name.
    pub fn is_plain(&self) -> bool {
        match self {
            Self::Number(..) | Self::Text(_) | Self::Truth(_) | Self::Nothing => true,
            Self::Name(_) | Self::Past(_) | Self::Start(_) => true,
            Self::Negative(inner) => matches!(**inner, Self::Number(..)),
            _ => false,
        }
    }

    /// Values directly inside.
    pub fn parts(&self) -> Vec<&Self> {
        match self {
            Self::Number(..) | Self::Text(_) | Self::Truth(_) | Self::Nothing => Vec::new(),
            Self::Name(_) | Self::Past(_) | Self::Start(_) => Vec::new(),
            Self::Negative(inner) | Self::Not(inner) | Self::Decimals(inner, _) => vec![inner],
            Self::Binary(_, left, right) => vec![left, right],
            Self::If(condition, yes, no) => vec![condition, yes, no],
            Self::Call(_, parts) | Self::Own(_, parts) | Self::Join(parts) => parts.iter().collect(),
        }
    }

    /// Number of nodes.
    pub fn size(&self) -> usize {
        1 + self.parts().into_iter().map(Self::size).sum::<usize>()
    }

    /// Calls `visit` with this value and all inside it.
    pub fn walk(&self, visit: &mut dyn FnMut(&Self)) {
        visit(self);
        for part in self.parts() {
            part.walk(visit);
        }
    }

    /// Copy in which `replace` gives other values for some.
    pub fn map(&self, replace: &mut dyn FnMut(&Self) -> Option<Self>) -> Self {
        if let Some(other) = replace(self) {
            return other;
        }
        let mut inner = |value: &Self| Box::new(value.map(replace));
        match self {
            Self::Number(..) | Self::Text(_) | Self::Truth(_) | Self::Nothing => self.clone(),
            Self::Name(_) | Self::Past(_) | Self::Start(_) => self.clone(),
            Self::Negative(value) => Self::Negative(inner(value)),
            Self::Not(value) => Self::Not(inner(value)),
            Self::Decimals(value, count) => Self::Decimals(inner(value), *count),
            Self::Binary(operator, left, right) => Self::Binary(*operator, inner(left), inner(right)),
            Self::If(condition, yes, no) => Self::If(inner(condition), inner(yes), inner(no)),
            Self::Call(name, parts) => Self::Call(name, parts.iter().map(|part| part.map(replace)).collect()),
            Self::Own(name, parts) => Self::Own(name.clone(), parts.iter().map(|part| part.map(replace)).collect()),
            Self::Join(parts) => Self::Join(parts.iter().map(|part| part.map(replace)).collect()),
        }
    }

    /// Copy that reads the variables of the step before as they are now.
    pub fn of_one_moment(&self) -> Self {
        self.map(&mut |part| match part {
            Self::Past(name) => Some(Self::Name(name.clone())),
            _ => None,
        })
    }

    /// Copy without branches that are never taken or are equal.
    pub fn simplified(&self) -> Self {
        self.map(&mut |part| match part {
            Self::If(condition, yes, no) => {
                Some(Self::choose(condition.simplified(), yes.simplified(), no.simplified()))
            }
            Self::Binary(Operator::And, left, right) => Some(left.simplified().and(right.simplified())),
            Self::Binary(Operator::Or, left, right) => Some(left.simplified().or(right.simplified())),
            Self::Not(inner) => Some(inner.simplified().not()),
            _ => None,
        })
    }

    /// The number of a constant expression of numbers; names by `value_of`. `None` for what needs an elementary function.
    pub fn constant(&self, value_of: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
        let of = |value: &Self| value.constant(value_of);
        let value = match self {
            Self::Number(_, value) => *value,
            Self::Name(name) => value_of(name)?,
            Self::Negative(inner) => -of(inner)?,
            Self::Binary(operator, left, right) => {
                let (left, right) = (of(left)?, of(right)?);
                match operator {
                    Operator::Plus => left + right,
                    Operator::Minus => left - right,
                    Operator::Times => left * right,
                    Operator::Over => left / right,
                    _ => return None,
                }
            }
            Self::Call("pi", _) => std::f64::consts::PI,
            Self::Call("sqrt", parts) => of(parts.first()?)?.sqrt(),
            Self::Call("abs", parts) => of(parts.first()?)?.abs(),
            _ => return None,
        };
        value.is_finite().then_some(value)
    }
}

/// Comparison that is true where this one is false, for numbers that are no NaN.
fn opposite(operator: Operator) -> Option<Operator> {
    Some(match operator {
        Operator::Less => Operator::GreaterOrEqual,
        Operator::LessOrEqual => Operator::Greater,
        Operator::Greater => Operator::LessOrEqual,
        Operator::GreaterOrEqual => Operator::Less,
        Operator::Equal => Operator::Different,
        Operator::Different => Operator::Equal,
        _ => return None,
    })
}
