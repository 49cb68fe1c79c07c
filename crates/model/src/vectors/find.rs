//! Finds the names that are vectors: those whose value or initial value is a vector. `a = b + c` is a vector if `b` or `c`
//! is one, so the search starts from vectors written by components and follows the definitions.

use super::known::{CROSS, Vectors, has_tuple};
use crate::components::split_component;
use crate::syntax::expressions;
use crate::{
    BinaryOperator, Expression, ExpressionKind, FunctionStatement, Statement, StatementKind, UnaryOperator, limits,
};
use std::collections::{BTreeMap, BTreeSet};

/// Reason why an expression is a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Origin<'a> {
    Name(&'a str),
    /// Number of components of a tuple.
    Tuple(usize),
}

/// Origins, each with true if it stands in a vector product, which is a number for two components.
type Origins<'a> = BTreeSet<(Origin<'a>, bool)>;

impl Vectors {
    /// Vectors of a model, from its statements before expansion.
    pub fn of(statements: &[Statement]) -> Self {
        let mut finder = Finder::default();
        let mut occur = false;
        for statement in statements {
            match &statement.kind {
                StatementKind::Function(function) => {
                    finder.functions.insert(&function.name.text, function);
                }
                StatementKind::Event { extras, .. } => {
                    finder.events.extend(extras.name.as_ref().map(|name| name.text.as_str()));
                }
                _ => {}
            }
            occur |= match &statement.kind {
                StatementKind::Members { .. } | StatementKind::Choice(_) => {
                    values(statement).into_iter().any(|(_, value)| has_tuple(value))
                }
                _ => expressions(statement).into_iter().any(has_tuple),
            };
        }
        let mut vectors = Self {
            dimensions: BTreeMap::new(),
            events: finder.events.iter().map(|&name| name.to_owned()).collect(),
            functions: finder.functions.keys().map(|&name| name.to_owned()).collect(),
            occur,
        };
        let mut found: Vec<(&str, usize)> = finder.by_components(statements);
        vectors.occur |= !found.is_empty();
        if !vectors.occur {
            return vectors;
        }
        let mut uses: BTreeMap<&str, Vec<(&str, bool)>> = BTreeMap::new();
        for (name, value) in statements.iter().flat_map(values) {
            let mut origins = Origins::new();
            finder.origins(value, false, 0, &mut origins);
            for (origin, crossed) in origins {
                match origin {
                    Origin::Tuple(dimension) if !crossed || dimension > 2 => found.push((name, dimension)),
                    Origin::Tuple(_) => {}
                    Origin::Name(other) => uses.entry(other).or_default().push((name, crossed)),
                }
            }
        }
        while let Some((name, dimension)) = found.pop() {
            if vectors.dimensions.contains_key(name) {
                continue;
            }
            vectors.dimensions.insert(name.to_owned(), dimension);
            let users = uses.get(name).into_iter().flatten();
            found.extend(users.filter(|(_, crossed)| !crossed || dimension > 2).map(|&(user, _)| (user, dimension)));
        }
        vectors
    }
}

#[derive(Default)]
struct Finder<'a> {
    functions: BTreeMap<&'a str, &'a FunctionStatement>,
    events: BTreeSet<&'a str>,
    /// Origins of the values of functions; names of their arguments are included.
    known: BTreeMap<&'a str, Origins<'a>>,
}

impl<'a> Finder<'a> {
    /// Vectors whose components have separate initial values, with the number of components.
    fn by_components(&self, statements: &'a [Statement]) -> Vec<(&'a str, usize)> {
        let mut greatest: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
        for statement in statements {
            if let StatementKind::InitialValue { name, .. } = &statement.kind
                && let Some((vector, axis)) = split_component(&name.text)
                && !self.events.contains(vector)
            {
                let (highest, seen) = greatest.entry(vector).or_insert((axis, 0));
                *highest = (*highest).max(axis);
                *seen |= 1 << axis;
            }
        }
        let whole = greatest.into_iter().filter(|(_, (highest, seen))| *highest > 0 && *seen + 1 == 2 << highest);
        whole.map(|(vector, (highest, _))| (vector, highest + 1)).collect()
    }

    /// Collects the origins of an expression. `calls` is the nesting depth of function calls.
    fn origins(&mut self, expression: &'a Expression, crossed: bool, calls: usize, origins: &mut Origins<'a>) {
        let mut waiting = vec![(expression, crossed)];
        while let Some((next, crossed)) = waiting.pop() {
            match &next.kind {
                ExpressionKind::Name { name, .. }
                | ExpressionKind::InitialValue { name, .. }
                | ExpressionKind::Member { name, .. } => {
                    if let Some(name) = self.of_name(name) {
                        origins.insert((Origin::Name(name), crossed));
                    }
                    // The parser reads `f(0)` as an initial value.
                    if matches!(next.kind, ExpressionKind::InitialValue { .. })
                        && self.functions.contains_key(name.as_str())
                    {
                        origins.extend(
                            self.of_function(name, calls).into_iter().map(|(origin, own)| (origin, own || crossed)),
                        );
                    }
                }
                ExpressionKind::Tuple { parts, .. } => {
                    origins.insert((Origin::Tuple(parts.len()), crossed));
                }
                ExpressionKind::Unary(UnaryOperator::Negate, operand) => waiting.push((operand, crossed)),
                ExpressionKind::Binary(operator, left, right) => match operator {
                    BinaryOperator::Add | BinaryOperator::Subtract | BinaryOperator::Multiply => {
                        waiting.extend([(&**left, crossed), (&**right, crossed)]);
                    }
                    BinaryOperator::Divide => waiting.push((left, crossed)),
                    _ => {}
                },
                ExpressionKind::If(_, chosen, other) => waiting.extend([(&**chosen, crossed), (&**other, crossed)]),
                ExpressionKind::Expansion(expansion) => waiting.push((&expansion.body, crossed)),
                ExpressionKind::Reduction { function, body, .. } if function.text == "sum" => {
                    waiting.push((body, crossed));
                }
                ExpressionKind::Call { function, arguments } => {
                    if let Some(own) = self.functions.get(function.text.as_str()).copied() {
                        // Each argument once; otherwise nested calls would be visited exponentially often.
                        let mut places: BTreeSet<(usize, bool)> = BTreeSet::new();
                        for (origin, inside) in self.of_function(&function.text, calls) {
                            let crossed = crossed || inside;
                            let place = |name: &str| own.parameters.iter().position(|parameter| parameter.text == name);
                            let place = match origin {
                                Origin::Name(name) => place(name),
                                Origin::Tuple(_) => None,
                            };
                            match place {
                                Some(place) => drop(places.insert((place, crossed))),
                                None => drop(origins.insert((origin, crossed))),
                            }
                        }
                        let argument = |(place, crossed): (usize, bool)| Some((arguments.get(place)?, crossed));
                        waiting.extend(places.into_iter().filter_map(argument));
                    } else {
                        let crossed = crossed || function.text == CROSS;
                        if [CROSS, "sum", "mean", "integral"].contains(&function.text.as_str()) {
                            waiting.extend(arguments.iter().map(|argument| (argument, crossed)));
                        }
                    }
                }
                ExpressionKind::Number { .. }
                | ExpressionKind::Text(_)
                | ExpressionKind::Component { .. }
                | ExpressionKind::Unary(UnaryOperator::Not, _)
                | ExpressionKind::Reduction { .. }
                | ExpressionKind::Error => {}
            }
        }
    }

    /// Vector behind a name: `r` for `landing.r`; `None` for the component `r.x`.
    fn of_name(&self, name: &'a str) -> Option<&'a str> {
        match name.split_once('.') {
            None => Some(name),
            Some((event, member)) if self.events.contains(event) => (!member.contains('.')).then_some(member),
            Some(_) => None,
        }
    }

    /// Origins of the value of a function.
    fn of_function(&mut self, name: &str, calls: usize) -> Origins<'a> {
        let Some((&name, &function)) = self.functions.get_key_value(name) else { return Origins::new() };
        if let Some(known) = self.known.get(name) {
            return known.clone();
        }
        // Deeper calls and recursion are reported elsewhere.
        if calls >= limits::NESTING {
            return Origins::new();
        }
        self.known.insert(name, Origins::new());
        let mut origins = Origins::new();
        self.origins(&function.body, false, calls + 1, &mut origins);
        self.known.insert(name, origins.clone());
        origins
    }
}

/// Names to which a statement gives values, with the values.
fn values(statement: &Statement) -> Vec<(&str, &Expression)> {
    match &statement.kind {
        StatementKind::Definition { name, value, .. }
        | StatementKind::InitialValue { name, value, .. }
        | StatementKind::Discrete { name, value, .. } => vec![(&name.text, value)],
        StatementKind::Members { left, value, .. } => match &left.kind {
            ExpressionKind::Member { name, .. } => vec![(name, value)],
            _ => Vec::new(),
        },
        StatementKind::Choice(choice) => {
            let all = choice.alternatives.iter().flat_map(|alternative| &alternative.values);
            all.map(|one| (one.name.text.as_str(), &one.value)).collect()
        }
        StatementKind::Event { extras, .. } => {
            extras.names.iter().map(|one| (one.name.text.as_str(), &one.value)).collect()
        }
        _ => Vec::new(),
    }
}
