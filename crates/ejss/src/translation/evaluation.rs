//! Values of expressions of JavaScript.

use super::facts::Role;
use super::run::{Known, Phase, Run};
use super::value::{Kind, Value};
use crate::refusal::Obstacle;
use crate::script::{Expression, Node, Operator};

/// Greatest size of a value that is written out where its name is read, in nodes.
const LARGEST_COPY: usize = 400;

/// Roots of paths that lead to the page, the view or the player.
const OUTSIDE: [&str; 14] = [
    "_view",
    "_model",
    "_tools",
    "document",
    "window",
    "navigator",
    "console",
    "screen",
    "alert",
    "localStorage",
    "location",
    "jQuery",
    "$",
    "event",
];

impl Run<'_> {
    /// Value of an expression.
    pub fn value(&mut self, expression: &Expression) -> Known {
        let line = expression.line;
        match &expression.node {
            Node::Number(text, value) => Ok(Value::literal(text, *value)),
            Node::Text(text) => Ok(Value::Text(text.clone())),
            Node::Truth(truth) => Ok(Value::Truth(*truth)),
            Node::Nothing => Ok(Value::Nothing),
            Node::Name(name) => self.name(name, line),
            Node::Unary(operator, inner) => self.unary(*operator, inner, line),
            Node::Binary(operator, left, right) => self.binary(*operator, left, right, line),
            Node::Conditional(condition, yes, no) => {
                let condition = self.truth(condition)?;
                if let Value::Truth(truth) = condition {
                    return self.value(if truth { yes } else { no });
                }
                let (yes, no) = (self.value(yes)?, self.value(no)?);
                match (self.kind(&yes), self.kind(&no)) {
                    (Some(one), Some(other)) if one == other => Ok(Value::choose(condition, yes, no)),
                    _ => Err(self.reason(line, Obstacle::Kinds)),
                }
            }
            Node::Assignment(target, ..) => {
                self.effect(expression);
                self.value(target)
            }
            Node::Call(callee, arguments) => self.call(callee, arguments, line),
            Node::Member(object, member) => self.member(object, member, line),
            Node::Index(object, _) => {
                let root = object.root().unwrap_or("array").to_owned();
                Err(self.reason(line, self.view_obstacle(object).unwrap_or(Obstacle::Array(root))))
            }
            Node::Array(_) => Err(self.reason(line, Obstacle::Array("[ ]".to_owned()))),
            Node::Function(function) => {
                Err(self.reason(line, Obstacle::Statement(format!("function {}", function.name).trim().to_owned())))
            }
            Node::Other(word, _) => Err(self.reason(line, Obstacle::Statement((*word).to_owned()))),
        }
    }

    /// The obstacle of a path that leads to the page or view.
    pub fn view_obstacle(&self, path: &Expression) -> Option<Obstacle> {
        let root = path.root()?;
        let is_outside = OUTSIDE.contains(&root) || root.starts_with('_') && self.facts.variable(root).is_none();
        (is_outside && self.local(root).is_none()).then(|| Obstacle::View(root.to_owned()))
    }

    fn name(&mut self, name: &str, line: usize) -> Known {
        if let Some(key) = self.local(name).cloned() {
            return self.written(&key, line);
        }
        if self.values.contains_key(name) {
            return self.written(name, line);
        }
        if self.facts.variable(name).is_some() {
            return self.before(name, line);
        }
        let obstacle = if OUTSIDE.contains(&name) || name.starts_with('_') {
            Obstacle::View(name.to_owned())
        } else {
            Obstacle::Name(name.to_owned())
        };
        Err(self.reason(line, obstacle))
    }

    /// Value of a name that has not been written in this pass.
    pub fn before(&mut self, key: &str, line: usize) -> Known {
        let Some(fact) = self.facts.variable(key) else { return Ok(Value::Nothing) };
        if fact.is_array {
            return Err(self.reason(line, Obstacle::Array(key.to_owned())));
        }
        let name = Value::Name(key.to_owned());
        match (self.phase, fact.role) {
            (Phase::Start, _) => Ok(Value::Nothing),
            (Phase::Fixed, Role::Computed) => {
                let reason = self.reason(line, Obstacle::Past(key.to_owned()));
                self.past.entry(key.to_owned()).or_insert(reason);
                Ok(Value::Past(key.to_owned()))
            }
            (Phase::Motion | Phase::Event, Role::Computed) => {
                self.older.insert(key.to_owned());
                Ok(name)
            }
            _ => Ok(name),
        }
    }

    /// Value of a name that has been written in this pass: the name itself once nothing later writes it.
    fn written(&mut self, key: &str, line: usize) -> Known {
        let value = self.values.get(key).cloned().unwrap_or(Ok(Value::Nothing))?;
        if value == Value::Nothing {
            return Ok(value);
        }
        if self.is_settled(key) {
            match (self.phase, self.facts.role(key)) {
                (Phase::Motion | Phase::Fixed, Some(_)) | (Phase::Start, Some(Role::Constant)) => {
                    return Ok(Value::Name(key.to_owned()));
                }
                // A local of a page becomes a definition; one of a function has no name outside.
                (Phase::Motion | Phase::Fixed, None) if self.depth == 0 && !value.is_plain() => {
                    return Ok(Value::Name(key.to_owned()));
                }
                (Phase::Start, Some(Role::State)) if !value.is_plain() => return Ok(Value::Start(key.to_owned())),
                _ => {}
            }
        }
        if value.size() > LARGEST_COPY { Err(self.reason(line, Obstacle::TooLong)) } else { Ok(value) }
    }

    /// Value of an expression as a number.
    pub fn numeric(&mut self, expression: &Expression) -> Known {
        let value = self.value(expression)?;
        self.as_number(value, expression)
    }

    fn as_number(&self, value: Value, expression: &Expression) -> Known {
        match (&value, self.kind(&value)) {
            (Value::Nothing, _) => {
                let name = expression.root().unwrap_or("undefined").to_owned();
                Err(self.reason(expression.line, Obstacle::NoValue(name)))
            }
            (_, Some(Kind::Number)) => Ok(value),
            (Value::Truth(truth), _) => Ok(Value::number(f64::from(*truth))),
            (_, Some(Kind::Truth)) => Ok(Value::choose(value, Value::number(1.0), Value::number(0.0))),
            _ => Err(self.reason(expression.line, Obstacle::Text)),
        }
    }

    /// Value of an expression as a condition.
    pub fn truth(&mut self, expression: &Expression) -> Known {
        let value = self.value(expression)?;
        match (&value, self.kind(&value)) {
            (Value::Nothing, _) => Ok(Value::Truth(false)),
            (_, Some(Kind::Truth)) => Ok(value),
            (Value::Number(_, number), _) => Ok(Value::Truth(*number != 0.0)),
            (_, Some(Kind::Number)) => Ok(Value::binary(Operator::Different, value, Value::number(0.0))),
            _ => Err(self.reason(expression.line, Obstacle::Text)),
        }
    }

    /// A value in the kind of the variable that takes it.
    pub fn coerced(&self, value: Value, kind: Kind, line: usize) -> Known {
        let own = self.kind(&value);
        match (kind, own) {
            _ if own == Some(kind) || value == Value::Nothing => Ok(value),
            (Kind::Truth, Some(Kind::Number)) => match is_truth(&value) {
                Some(truth) => Ok(Value::Truth(truth)),
                None => Ok(Value::binary(Operator::Different, value, Value::number(0.0))),
            },
            (Kind::Number, Some(Kind::Truth)) => Ok(match value {
                Value::Truth(truth) => Value::number(f64::from(truth)),
                value => Value::choose(value, Value::number(1.0), Value::number(0.0)),
            }),
            _ => Err(self.reason(line, Obstacle::Kinds)),
        }
    }

    fn unary(&mut self, operator: Operator, inner: &Expression, line: usize) -> Known {
        match operator {
            Operator::Minus => Ok(self.numeric(inner)?.negative()),
            Operator::Plus => self.numeric(inner),
            Operator::Not => Ok(self.truth(inner)?.not()),
            _ => Err(self.reason(line, Obstacle::Bits)),
        }
    }

    fn binary(&mut self, operator: Operator, left: &Expression, right: &Expression, line: usize) -> Known {
        match operator {
            Operator::And | Operator::Or => {
                let (left, right) = (self.truth(left)?, self.truth(right)?);
                Ok(if operator == Operator::And { left.and(right) } else { left.or(right) })
            }
            Operator::Equal | Operator::Different => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                let equal = self.equal(left, right, line)?;
                Ok(if operator == Operator::Equal { equal } else { equal.not() })
            }
            Operator::Bits => Err(self.reason(line, Obstacle::Bits)),
            Operator::Plus => {
                let (one, other) = (self.value(left)?, self.value(right)?);
                if [self.kind(&one), self.kind(&other)].contains(&Some(Kind::Text)) {
                    return Ok(joined(one, other));
                }
                let (one, other) = (self.as_number(one, left)?, self.as_number(other, right)?);
                Ok(Value::binary(Operator::Plus, one, other))
            }
            _ => {
                let (left, right) = (self.numeric(left)?, self.numeric(right)?);
                Ok(arithmetic(operator, left, right))
            }
        }
    }

    /// Value of `target operator= value`.
    pub fn combined(&mut self, operator: Operator, target: &Expression, value: &Expression) -> Known {
        self.binary(operator, target, value, target.line)
    }

    fn equal(&self, left: Value, right: Value, line: usize) -> Known {
        let kinds = (self.kind(&left), self.kind(&right));
        match (&left, &right) {
            (Value::Nothing, Value::Nothing) => Ok(Value::Truth(true)),
            // A variable that has a value by now.
            (Value::Nothing, other) | (other, Value::Nothing) => match (self.phase, other) {
                (Phase::Start, _) => Ok(Value::Truth(false)),
                (_, Value::Name(_) | Value::Past(_)) => Ok(Value::Truth(false)),
                _ => Err(self.reason(line, Obstacle::NoValue("undefined".to_owned()))),
            },
            (Value::Text(left), Value::Text(right)) => Ok(Value::Truth(left == right)),
            (Value::Truth(truth), _) if kinds.1 == Some(Kind::Truth) => Ok(if *truth { right } else { right.not() }),
            (_, Value::Truth(truth)) if kinds.0 == Some(Kind::Truth) => Ok(if *truth { left } else { left.not() }),
            _ if kinds.0 != kinds.1 || kinds.0.is_none() => Err(self.reason(line, Obstacle::Kinds)),
            _ if kinds.0 == Some(Kind::Truth) => {
                let neither = left.clone().not().and(right.clone().not());
                Ok(left.and(right).or(neither))
            }
            _ if matches!(left, Value::Join(_)) || matches!(right, Value::Join(_)) => {
                Err(self.reason(line, Obstacle::Text))
            }
            _ => Ok(Value::binary(Operator::Equal, left, right)),
        }
    }

    fn member(&mut self, object: &Expression, member: &str, line: usize) -> Known {
        let value = match (object.name(), member) {
            (Some("Math"), "PI") => Value::Call("pi", Vec::new()),
            (Some("Math"), "E") => Value::number(std::f64::consts::E),
            (Some("Math"), "LN2") => Value::number(std::f64::consts::LN_2),
            (Some("Math"), "LN10") => Value::number(std::f64::consts::LN_10),
            (Some("Math"), "SQRT2") => Value::Call("sqrt", vec![Value::number(2.0)]),
            (Some("Math"), "SQRT1_2") => Value::Call("sqrt", vec![Value::literal("0.5", 0.5)]),
            _ => {
                let root = object.root().unwrap_or("object").to_owned();
                let obstacle = self.view_obstacle(object).unwrap_or(if member == "length" {
                    Obstacle::Array(root)
                } else {
                    Obstacle::Name(format!("{root}.{member}"))
                });
                return Err(self.reason(line, obstacle));
            }
        };
        Ok(value)
    }

    /// Kind of a value; `None` for [`Value::Nothing`].
    pub fn kind(&self, value: &Value) -> Option<Kind> {
        match value {
            Value::Nothing => None,
            Value::Number(..)
            | Value::Negative(_)
            | Value::Call(..)
            | Value::Start(_)
            | Value::Own(..)
            | Value::Decimals(..) => Some(Kind::Number),
            Value::Text(_) | Value::Join(_) => Some(Kind::Text),
            Value::Truth(_) | Value::Not(_) => Some(Kind::Truth),
            Value::Binary(operator, ..) => Some(match operator {
                Operator::Plus | Operator::Minus | Operator::Times | Operator::Over | Operator::Power => Kind::Number,
                _ => Kind::Truth,
            }),
            Value::If(_, yes, _) => self.kind(yes),
            Value::Name(name) | Value::Past(name) => match self.facts.variable(name) {
                Some(fact) => Some(fact.kind),
                None => Some(self.kinds.get(name).copied().unwrap_or(Kind::Number)),
            },
        }
    }
}

/// Truth value of a number that stands for one.
pub(super) fn is_truth(value: &Value) -> Option<bool> {
    match value {
        Value::Number(_, number) if *number == 0.0 => Some(false),
        Value::Number(_, number) if *number == 1.0 => Some(true),
        _ => None,
    }
}

fn joined(left: Value, right: Value) -> Value {
    let mut parts = Vec::new();
    for value in [left, right] {
        match value {
            Value::Join(inner) => parts.extend(inner),
            value => parts.push(value),
        }
    }
    if let [Value::Text(left), Value::Text(right)] = parts.as_slice() {
        return Value::Text(format!("{left}{right}"));
    }
    Value::Join(parts)
}

/// Arithmetic of two numbers. The remainder of JavaScript has the sign of its first operand, that of `mod` the sign of the second.
fn arithmetic(operator: Operator, left: Value, right: Value) -> Value {
    if operator == Operator::Remainder {
        let amounts = vec![Value::Call("abs", vec![left.clone()]), Value::Call("abs", vec![right])];
        return Value::binary(Operator::Times, Value::Call("sign", vec![left]), Value::Call("mod", amounts));
    }
    Value::binary(operator, left, right)
}
