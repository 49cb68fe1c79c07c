//! Calls of functions: those of `Math`, those of the simulation, and the formats of numbers.

use super::facts::Role;
use super::run::{Known, Phase, Run};
use super::value::{Kind, Value};
use crate::place::Reason;
use crate::refusal::Obstacle;
use crate::script::{Expression, Node, Operator};

/// Functions of `Math` that the language has by the same name or another one, with the number of their arguments.
const PLAIN: [(&str, &str, usize); 22] = [
    ("sqrt", "sqrt", 1),
    ("cbrt", "cbrt", 1),
    ("abs", "abs", 1),
    ("sign", "sign", 1),
    ("exp", "exp", 1),
    ("log", "ln", 1),
    ("log10", "log10", 1),
    ("sin", "sin", 1),
    ("cos", "cos", 1),
    ("tan", "tan", 1),
    ("asin", "asin", 1),
    ("acos", "acos", 1),
    ("atan", "atan", 1),
    ("atan2", "atan2", 2),
    ("sinh", "sinh", 1),
    ("cosh", "cosh", 1),
    ("tanh", "tanh", 1),
    ("asinh", "asinh", 1),
    ("acosh", "acosh", 1),
    ("atanh", "atanh", 1),
    ("floor", "floor", 1),
    ("ceil", "ceil", 1),
];

impl Run<'_> {
    /// Value of a call.
    pub fn call(&mut self, callee: &Expression, arguments: &[Expression], line: usize) -> Known {
        if let Node::Member(object, function) = &callee.node {
            return match (object.name(), function.as_str()) {
                (Some("Math"), "random") => Err(self.reason(line, Obstacle::Random)),
                (Some("Math"), function) => self.mathematical(function, arguments, line),
                (Some("_view"), "_format" | "format") => self.formatted(arguments, line),
                (Some("Number"), "parseFloat") => self.first(arguments, line),
                (_, "toFixed") => {
                    let inner = self.numeric(object)?;
                    let decimals = match arguments.first().map(|argument| &argument.node) {
                        Some(Node::Number(_, decimals)) => *decimals,
                        _ => 0.0,
                    };
                    Ok(Value::Join(vec![Value::Decimals(Box::new(inner), decimals.clamp(0.0, 12.0) as usize)]))
                }
                _ => {
                    let obstacle = self.view_obstacle(callee).unwrap_or_else(|| Obstacle::Call(callee.path()));
                    Err(self.reason(line, obstacle))
                }
            };
        }
        match callee.name() {
            Some("parseFloat" | "Number") => self.first(arguments, line),
            Some("parseInt") => {
                let value = self.first(arguments, line)?;
                Ok(truncated(value))
            }
            Some(name) if self.facts.function(name).is_some() => self.own(name, arguments, line),
            _ => {
                let obstacle = self.view_obstacle(callee).unwrap_or_else(|| Obstacle::Call(callee.path()));
                Err(self.reason(line, obstacle))
            }
        }
    }

    fn first(&mut self, arguments: &[Expression], line: usize) -> Known {
        match arguments.first() {
            Some(argument) => self.numeric(argument),
            None => Err(self.reason(line, Obstacle::Call("Number".to_owned()))),
        }
    }

    fn mathematical(&mut self, function: &str, arguments: &[Expression], line: usize) -> Known {
        let mut values = Vec::new();
        for argument in arguments {
            values.push(self.numeric(argument)?);
        }
        if let Some((_, own, count)) = PLAIN.into_iter().find(|(name, ..)| *name == function)
            && values.len() >= count
        {
            values.truncate(count);
            return Ok(Value::Call(own, values));
        }
        let mut taken = values.into_iter();
        Ok(match (function, taken.next(), taken.next()) {
            ("pow", Some(base), Some(power)) => Value::binary(Operator::Power, base, power),
            ("hypot", Some(x), Some(y)) if taken.len() == 0 => Value::Call("hypot", vec![x, y]),
            ("max" | "min", Some(value), None) => value,
            ("max" | "min", Some(one), Some(other)) => {
                let name = if function == "max" { "max" } else { "min" };
                Value::Call(name, [one, other].into_iter().chain(taken).collect())
            }
            // Halves are rounded up in JavaScript: -2.5 to -2.
            ("round", Some(value), _) => {
                Value::Call("floor", vec![Value::binary(Operator::Plus, value, Value::literal("0.5", 0.5))])
            }
            ("trunc", Some(value), _) => truncated(value),
            ("log2", Some(value), _) => {
                let of_two = Value::Call("ln", vec![Value::number(2.0)]);
                Value::binary(Operator::Over, Value::Call("ln", vec![value]), of_two)
            }
            ("log1p", Some(value), _) => {
                Value::Call("ln", vec![Value::binary(Operator::Plus, Value::number(1.0), value)])
            }
            ("expm1", Some(value), _) => {
                Value::binary(Operator::Minus, Value::Call("exp", vec![value]), Value::number(1.0))
            }
            _ => return Err(self.reason(line, Obstacle::Call(format!("Math.{function}")))),
        })
    }

    /// `_view._format(x, "0.00")`.
    fn formatted(&mut self, arguments: &[Expression], line: usize) -> Known {
        let Some(argument) = arguments.first() else { return Err(self.reason(line, Obstacle::Text)) };
        let value = self.numeric(argument)?;
        let decimals = match arguments.get(1).map(|format| &format.node) {
            Some(Node::Text(format)) => decimals_of(format).unwrap_or(2),
            _ => 2,
        };
        Ok(Value::Join(vec![Value::Decimals(Box::new(value), decimals)]))
    }

    /// Call of a function of the simulation: by its name where all that it reads has its name, else its body with the arguments.
    fn own(&mut self, name: &str, arguments: &[Expression], line: usize) -> Known {
        let writes =
            self.facts.function(name).is_some_and(|fact| !self.facts.written_by(&fact.function.body).is_empty());
        let read = self.facts.read_by(name);
        let is_named = |key: &String| match self.phase {
            Phase::Start => {
                self.facts.role(key) == Some(Role::Constant) && self.is_settled(key) && self.values.contains_key(key)
            }
            Phase::Motion | Phase::Fixed => self.is_settled(key),
            Phase::Event => !self.values.contains_key(key),
            Phase::Function => true,
        };
        let count = self.facts.function(name).map_or(0, |fact| fact.function.arguments.len());
        if writes || count == 0 || arguments.len() != count || !read.iter().all(is_named) {
            return self.inlined(name, arguments, line);
        }
        self.note_older(name);
        // The call stands for the body, which must have a value.
        let mut body = Run::new(self.facts, Phase::Function, self.place.clone());
        body.depth = self.depth;
        let value = function_value(&mut body, name)?;
        if body.kind(&value) != Some(Kind::Number) || value.size() < 4 {
            return self.inlined(name, arguments, line);
        }
        let mut values = Vec::new();
        for argument in arguments {
            values.push(self.numeric(argument)?);
        }
        for key in &read {
            // Notes which values are of the step before.
            if !self.values.contains_key(key) {
                self.before(key, line)?;
            }
        }
        Ok(Value::Own(name.to_owned(), values))
    }

    /// Notes that rates call a function which reads states or the time by their names.
    fn note_older(&mut self, name: &str) {
        let is_moving = |key: &String| matches!(self.facts.role(key), Some(Role::State | Role::Time));
        if matches!(self.phase, Phase::Motion | Phase::Event) && self.facts.read_by(name).iter().any(is_moving) {
            self.older_in.insert(name.to_owned());
        }
    }

    /// Executes the body of a function with these arguments; its value.
    pub fn inlined(&mut self, name: &str, arguments: &[Expression], line: usize) -> Known {
        self.note_older(name);
        let mut values: Vec<Known> = Vec::new();
        for argument in arguments {
            values.push(self.value(argument));
        }
        self.executed(name, &values, line)
    }

    /// Value of a function whose arguments have these values; [`Value::Nothing`] if it returns none.
    fn executed(&mut self, name: &str, values: &[Known], line: usize) -> Known {
        let Some(fact) = self.facts.function(name) else {
            return Err(self.reason(line, Obstacle::Call(name.to_owned())));
        };
        if self.is_too_deep() {
            return Err(self.reason(line, Obstacle::Recursion(name.to_owned())));
        }
        let place = std::mem::replace(&mut self.place, fact.place.clone());
        let returned = self.in_frame(|run| {
            for (index, argument) in fact.function.arguments.iter().enumerate() {
                let key = run.declare(argument);
                run.set(key, values.get(index).cloned().unwrap_or(Ok(Value::Nothing)));
            }
            run.list(&fact.function.body, 0)
        });
        self.place = place;
        returned.unwrap_or(Ok(Value::Nothing))
    }
}

/// Value of a function with its arguments by their names.
pub(super) fn function_value(run: &mut Run, name: &str) -> Known {
    let arguments = run.facts.function(name).map(|fact| fact.function.arguments.as_slice()).unwrap_or_default();
    let values: Vec<Known> = arguments.iter().map(|argument| Ok(Value::Name(argument_key(name, argument)))).collect();
    match run.executed(name, &values, 0)? {
        Value::Nothing => {
            let place = run.facts.function(name).map_or_else(|| run.place.clone(), |fact| fact.place.clone());
            Err(Reason { place, obstacle: Obstacle::Call(name.to_owned()) })
        }
        value => Ok(value),
    }
}

/// Key of an argument of a function.
pub(super) fn argument_key(function: &str, argument: &str) -> String {
    format!("{function}{}{argument}", super::names::ARGUMENT)
}

fn truncated(value: Value) -> Value {
    let amount = Value::Call("floor", vec![Value::Call("abs", vec![value.clone()])]);
    Value::binary(Operator::Times, Value::Call("sign", vec![value]), amount)
}

/// Number of decimals of a format such as `"0.00"`.
fn decimals_of(format: &str) -> Option<usize> {
    let numeral: String = format.chars().skip_while(|letter| !matches!(letter, '0' | '#')).collect();
    let (_, decimals) = numeral.split_once('.').unwrap_or((&numeral, ""));
    Some(decimals.chars().take_while(|letter| matches!(letter, '0' | '#')).count().min(12))
}
