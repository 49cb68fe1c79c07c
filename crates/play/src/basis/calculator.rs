//! Parser for expressions typed into a field: arithmetic with units in brackets and names of the model. The result is
//! graph nodes built as by the compiler of the language, so that equal expressions give bit-identical values.

use program::functions::{Function, Rule};
use program::{Binary, Graph, Kind, Model, Node, NodeId};
use units::alphabet::{greek_name, lowered, primes};
use units::{Dimension, Exponent, Unit};

/// Maximum nesting depth of parentheses.
const DEEPEST: usize = 40;

/// A parsed expression.
#[derive(Debug)]
pub(crate) struct Calculation {
    /// Graph node of the expression.
    pub node: NodeId,
    /// Dimension of the value.
    pub dimension: Dimension,
    /// Names used in the expression, including `pi`.
    pub names: Vec<String>,
}

/// Adds the expression to the graph of `model`. `None` for a syntax error or mismatching dimensions.
pub(crate) fn calculate(model: &mut Model, text: &str) -> Option<Calculation> {
    let mut reader = Reader { model, rest: text.trim_start(), names: Vec::new(), depth: 0 };
    let value = reader.sum()?;
    let dimension = value.dimension.unwrap_or(Dimension::NONE);
    // `in [kg/s]` states the dimension of the result.
    let stated = reader.rest.strip_prefix("in").map(|rest| rest.trim().strip_prefix('[')?.strip_suffix(']'));
    let ends = match stated {
        Some(unit) => Unit::parse(unit?).is_ok_and(|unit| value.dimension.is_none_or(|own| own == unit.dimension)),
        None => reader.rest.is_empty(),
    };
    ends.then_some(Calculation { node: value.node, dimension, names: reader.names })
}

/// Names used in an expression, including `pi`, even if its dimensions mismatch.
pub(crate) fn names(model: &Model, text: &str) -> Vec<String> {
    let mut model = model.clone();
    let mut reader = Reader { model: &mut model, rest: text.trim_start(), names: Vec::new(), depth: 0 };
    let _ = reader.sum();
    reader.names
}

#[derive(Clone, Copy)]
struct Value {
    node: NodeId,
    /// `None` for a literal 0, which is compatible with any dimension.
    dimension: Option<Dimension>,
}

impl Value {
    fn new(node: NodeId, dimension: Dimension) -> Self {
        Self { node, dimension: Some(dimension) }
    }

    fn is_pure(self) -> bool {
        self.dimension.is_none_or(|dimension| dimension.is_none())
    }

    /// Common dimension of two terms; outer `None` if they mismatch.
    fn common(self, other: Self) -> Option<Option<Dimension>> {
        match (self.dimension, other.dimension) {
            (Some(one), Some(other)) => (one == other).then_some(Some(one)),
            (one, other) => Some(one.or(other)),
        }
    }
}

struct Reader<'a> {
    model: &'a mut Model,
    rest: &'a str,
    names: Vec<String>,
    depth: usize,
}

impl Reader<'_> {
    fn graph(&mut self) -> &mut Graph {
        &mut self.model.graph
    }

    /// Consumes `sign` and the blanks after it, if it comes next.
    fn take(&mut self, sign: char) -> bool {
        let Some(rest) = self.rest.strip_prefix(sign) else { return false };
        self.rest = rest.trim_start();
        true
    }

    /// Parses a sum: `a + b - c`.
    fn sum(&mut self) -> Option<Value> {
        let mut left = self.product()?;
        loop {
            let function = if self.take('+') {
                Binary::Add
            } else if self.take('-') {
                Binary::Subtract
            } else {
                return Some(left);
            };
            let right = self.product()?;
            let dimension = left.common(right)?;
            left = Value { node: self.graph().binary(function, left.node, right.node), dimension };
        }
    }

    /// Parses a product: `a*b/c`.
    fn product(&mut self) -> Option<Value> {
        let mut left = self.signed()?;
        loop {
            let divides = if self.take('*') {
                false
            } else if self.take('/') {
                true
            } else {
                return Some(left);
            };
            let right = self.signed()?;
            let pure = |value: Value| value.dimension.unwrap_or(Dimension::NONE);
            left = if divides {
                Value::new(self.graph().divide(left.node, right.node), pure(left).per(pure(right))?)
            } else {
                Value::new(self.graph().multiply(left.node, right.node), pure(left).times(pure(right))?)
            };
        }
    }

    /// Parses a sign: `-a`; a power binds more tightly.
    fn signed(&mut self) -> Option<Value> {
        if self.take('+') {
            return self.nested(Self::signed);
        }
        if !self.take('-') {
            return self.power();
        }
        let value = self.nested(Self::signed)?;
        Some(Value { node: self.graph().negate(value.node), ..value })
    }

    /// Parses a power: `a^b^c`, right-associative.
    fn power(&mut self) -> Option<Value> {
        let base = self.operand()?;
        if !self.take('^') {
            return Some(base);
        }
        let exponent = self.nested(Self::signed)?;
        if !exponent.is_pure() {
            return None;
        }
        let dimension = if base.is_pure() {
            Dimension::NONE
        } else {
            let number = self.model.graph.as_constant(exponent.node)?;
            base.dimension?.power(Exponent::from_number(number)?)?
        };
        Some(Value::new(self.graph().power(base.node, exponent.node), dimension))
    }

    /// Calls `read` one level deeper; `None` beyond the maximum depth.
    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Option<T>) -> Option<T> {
        self.depth += 1;
        let value = if self.depth <= DEEPEST { read(self) } else { None };
        self.depth -= 1;
        value
    }

    fn operand(&mut self) -> Option<Value> {
        if self.take('(') {
            let value = self.nested(Self::sum)?;
            return self.take(')').then_some(value);
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') { self.number() } else { self.name() }
    }

    /// Parses a number, optionally with a unit: `3.5`, `2e-3 [m]`.
    fn number(&mut self) -> Option<Value> {
        let length = super::typed::number_length(self.rest);
        let (digits, rest) = self.rest.split_at(length);
        let number = units::number::decimal(digits)?;
        self.rest = rest.trim_start();
        let Some((unit, rest)) = self.rest.strip_prefix('[').and_then(|rest| rest.split_once(']')) else {
            let dimension = (number != 0.0).then_some(Dimension::NONE);
            return Some(Value { node: self.graph().constant(number), dimension });
        };
        let unit = Unit::parse(unit).ok()?;
        self.rest = rest.trim_start();
        Some(Value::new(self.graph().constant(unit.to_si(number)), unit.dimension))
    }

    /// Parses a name, an initial value or a call: `rho`, `ω₀`, `y'(0)`, `sqrt(2)`.
    fn name(&mut self) -> Option<Value> {
        let mut name = String::new();
        let mut order = 0;
        while let Some(character) = self.rest.chars().next() {
            if let Some(more) = primes(character).filter(|_| !name.is_empty()) {
                order += more;
            } else if order > 0 {
                break;
            } else if character.is_ascii_alphanumeric() || character == '_' {
                name.push(character);
            } else if let Some(greek) = greek_name(character) {
                name.push_str(greek);
            } else if let Some(digit) = lowered(character) {
                // `ω₀` is `omega_0`.
                if !name.contains('_') {
                    name.push('_');
                }
                name.push(digit);
            } else {
                break;
            }
            self.rest = &self.rest[character.len_utf8()..];
        }
        self.rest = self.rest.trim_start();
        if name.is_empty() {
            return None;
        }
        if name == "pi" && order == 0 {
            self.names.push(name);
            return Some(Value::new(self.graph().constant(std::f64::consts::PI), Dimension::NONE));
        }
        if !self.take('(') {
            self.names.push(name.clone());
            let meaning = self.model.lookup_shown(&name, order).filter(|value| value.kind == Kind::Number)?;
            return Some(Value::new(meaning.node, meaning.dimension()));
        }
        // Dry friction is not a function with a value.
        match Function::reserving(&name).filter(|_| order == 0) {
            Some(function) => self.call(function),
            None => self.initial(name, order),
        }
    }

    /// Initial value of a state, after `y'(`.
    fn initial(&mut self, name: String, order: u32) -> Option<Value> {
        if !(self.take('0') && self.take(')')) {
            return None;
        }
        let states = &self.model.states;
        let state = states.iter().position(|state| state.variable == name && state.order == order)?;
        let dimension = states[state].unit.dimension;
        self.names.push(name);
        Some(Value::new(self.graph().insert(Node::Initial(state as u32)), dimension))
    }

    /// Parses the arguments of a function after its opening parenthesis and builds the call.
    fn call(&mut self, function: &Function) -> Option<Value> {
        let mut arguments = vec![self.nested(Self::sum)?];
        while self.take(',') {
            arguments.push(self.nested(Self::sum)?);
        }
        if !self.take(')') || !function.takes(arguments.len()) {
            return None;
        }
        let mut common = *arguments.first()?;
        for argument in &arguments {
            common.dimension = common.common(*argument)?;
        }
        let dimension = match function.dimensions {
            Rule::Pure | Rule::Whole => common.is_pure().then_some(Dimension::NONE)?,
            Rule::Root(degree) => common.dimension.unwrap_or(Dimension::NONE).root(u32::try_from(degree).ok()?)?,
            Rule::Same => common.dimension.unwrap_or(Dimension::NONE),
            Rule::Ratio => Dimension::NONE,
            Rule::Rest => return None,
        };
        let nodes: Vec<NodeId> = arguments.iter().map(|argument| argument.node).collect();
        Some(Value::new(function.build(self.graph(), &nodes), dimension))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model() -> Model {
        let source = "```model\nparameter m = 2 [kg]\nparameter omega_0 = 3 [1/s]\nT = 2*pi/omega_0\ny' = -omega_0*y\ny(0) = 5 [m]\n```\n";
        document::open(source, &[]).document.unwrap().program.model
    }

    /// Value of an expression at the default parameters, and its dimension.
    fn value(text: &str) -> Option<(f64, String)> {
        let mut model = model();
        let calculation = calculate(&mut model, text)?;
        let parameters: Vec<f64> = model.parameters.iter().map(|parameter| parameter.value).collect();
        let mut readings = engine::Readings::new(&model, &[calculation.node]);
        Some((readings.at(&parameters, &[5.0], 0.0, &[5.0])[0], calculation.dimension.to_string()))
    }

    #[test]
    fn arithmetic_follows_the_rules_of_the_language() {
        for (text, expected, dimension) in [
            ("2 + 3*4", 14.0, "1"),
            ("-2^2", -4.0, "1"),
            ("2^3^2", 512.0, "1"),
            ("2^-1", 0.5, "1"),
            ("7 - 2 - 1", 4.0, "1"),
            ("8/4/2", 1.0, "1"),
            ("m*omega_0", 6.0, "kg s^-1"),
            ("m*ω₀ in [g/s]", 6.0, "kg s^-1"),
            ("sqrt(4 [m^2])", 2.0, "m"),
            ("y(0)/2 + 50 [cm]", 3.0, "m"),
            ("0 + 3 [m]", 3.0, "m"),
            ("max(1, 2, 3)", 3.0, "1"),
            ("cos(pi)", -1.0, "1"),
        ] {
            assert_eq!(value(text), Some((expected, dimension.to_owned())), "{text}");
        }
    }

    #[test]
    fn what_is_no_expression_is_none() {
        let deep = [&"(".repeat(5000), "1", &")".repeat(5000)].concat();
        let signs = "-".repeat(5000) + "1";
        for text in [
            "",
            "2*",
            "2 3",
            "m + omega_0",
            "sin(m)",
            "sqrt()",
            "T(",
            "y''(0)",
            "2^m",
            "m in [s]",
            "1 [wibble]",
            &deep,
            &signs,
        ] {
            assert!(value(text).is_none(), "{text:.40}");
        }
    }
}
