//! Expressions outside the model: parsed, completed with the local names of the scene, and compiled against the model.

use crate::extent::Extent;
use crate::settable;
use model::{Compiler, Diagnostic, Expression, ExpressionKind, Functions, Places, Span, StatedUnit, StatementKind};
use program::{Assignment, Choices, Compiled, Graph, Kind, Model, Node};
use std::collections::BTreeMap;
use std::ops::Range;
use units::{QuantityName, Unit, Words, words};

/// Limits of the number of nodes and of the nesting depth of an expression after local names are replaced. Recursive
/// functions rely on the nesting depth that the parser allows.
const NODES: usize = 5_000;
const DEPTH: usize = 64;

/// A compiled expression and its place.
pub struct Placed {
    /// The compiled value.
    pub value: Compiled,
    /// Place in the document.
    pub span: Span,
}

/// Compiler of the expressions of one document.
pub struct Expressions<'a> {
    /// Text of the document.
    pub source: &'a str,
    /// Compiler that adds nodes to the graph of the model.
    pub compiler: Compiler<'a>,
    /// Places of the parts of the model.
    pub places: &'a Places,
    /// Diagnostics found so far.
    pub diagnostics: Vec<Diagnostic>,
    /// Local names and their expressions.
    local: BTreeMap<String, Expression>,
    /// Copy of the document in which text that does not belong to a point is temporarily blanked.
    pub covered: Option<String>,
}

impl<'a> Expressions<'a> {
    /// For the expressions of `source`.
    pub fn new(source: &'a str, model: &'a mut Model, places: &'a Places, functions: &Functions) -> Self {
        let compiler = Compiler::new(model).with(functions);
        let local = BTreeMap::new();
        Self { source, places, compiler, diagnostics: Vec::new(), local, covered: None }
    }

    /// The model.
    pub fn model(&self) -> &Model {
        self.compiler.model()
    }

    /// Graph of the model, for operations on compiled values.
    pub fn graph(&mut self) -> &mut Graph {
        self.compiler.graph()
    }

    /// Compiles the expression in the byte range `range`. `None` after an error.
    pub fn compile(&mut self, range: Range<usize>) -> Option<Placed> {
        self.read(range).map(|(placed, _)| placed)
    }

    /// Compiles the expression in `range` as a bare number: in the stated unit, or else in SI units.
    pub fn bare(&mut self, range: Range<usize>) -> Option<Placed> {
        let (mut placed, stated) = self.read(range)?;
        if stated {
            placed.value = self.compiler.in_its_unit(&placed.value);
        }
        Some(placed)
    }

    /// Compiles the expression in `range`. The flag is true if its unit is stated.
    fn read(&mut self, range: Range<usize>) -> Option<(Placed, bool)> {
        let (expression, unit) = self.parse(range)?;
        Some((self.place(expression, unit.as_ref())?, unit.is_some()))
    }

    /// Parses the expression in `range` and its stated unit. `None` after an error.
    pub fn parse(&mut self, range: Range<usize>) -> Option<(Expression, Option<StatedUnit>)> {
        let (expression, unit, found) = model::parse_expression(self.source, range);
        let failed = model::has_errors(&found);
        self.diagnostics.extend(found);
        (!failed).then_some((expression, unit))
    }

    /// The name in `range`, with its primes; a member of a family with its numbers. `None` if the text is not a name.
    pub fn name(&self, range: Range<usize>) -> Option<String> {
        let (mut expression, _, _) = model::parse_expression(self.source, range);
        self.replace(&mut expression, &mut 0);
        self.compiler.name_of(&expression)
    }

    /// Compiles the expression in `range`, which must be a number.
    pub fn number(&mut self, range: Range<usize>) -> Option<Placed> {
        let compiled = self.compile(range)?;
        self.expect_number(compiled)
    }

    /// Compiles the number in `range`, which must be constant during a run.
    pub fn constant(&mut self, range: Range<usize>, what: &Words) -> Option<Placed> {
        let compiled = self.number(range)?;
        self.expect_constant(compiled, what)
    }

    /// Parses and compiles assignments: `rho = 13534 [kg/m^3], b = 2*m*omega_0`.
    pub fn assignments(&mut self, range: Range<usize>) -> Vec<Assignment> {
        let (assignments, diagnostics) = model::parse_assignments(self.source, range);
        self.diagnostics.extend(diagnostics);
        let mut result: Vec<Assignment> = Vec::new();
        for assignment in assignments {
            let name = &assignment.name;
            let Some(parameter) = self.parameter(name) else {
                continue;
            };
            if result.iter().any(|earlier| earlier.parameter == parameter) {
                self.error("duplicate-name", words!("`{}` is set twice", name.text), name.span);
                continue;
            }
            if !self.model().parameters[parameter].is_number() {
                if let Some(value) = self.chosen(parameter, &assignment.value) {
                    result.push(Assignment { parameter, value });
                }
                continue;
            }
            let value = match assignment.unit {
                Some(_) => assignment.value,
                None => self.in_declared_unit(parameter, assignment.value),
            };
            let Some(value) = self.place(value, assignment.unit.as_ref()) else {
                continue;
            };
            let Some(value) = self.expect_number(value) else {
                continue;
            };
            let Some(value) = self.expect_constant(value, &words("the value of a parameter")) else {
                continue;
            };
            let unit = self.model().parameters[parameter].unit.clone();
            let value = Placed { value: self.turned(value.value, &unit), ..value };
            if self.fits(parameter, &value) {
                result.push(Assignment { parameter, value: value.value });
            }
        }
        result
    }

    /// The value for a parameter; a bare number gets the parameter's unit.
    fn in_declared_unit(&mut self, parameter: usize, value: Expression) -> Expression {
        let own = &self.compiler.model().parameters[parameter];
        model::in_declared_unit(&own.name, value, &own.unit, &mut self.diagnostics)
    }

    /// Value of a switch, `on` or `off`, or of a choice, one of its texts.
    fn chosen(&mut self, parameter: usize, value: &Expression) -> Option<Compiled> {
        let model = self.model();
        let own = &model.parameters[parameter];
        let word = match (&value.kind, &own.choices) {
            (ExpressionKind::Error, _) => return None,
            (ExpressionKind::Name { name, order: 0 }, Choices::Switch) => Some(name.as_str()),
            (ExpressionKind::Text(text), Choices::Texts(_)) => Some(text.as_str()),
            _ => None,
        };
        if let Some(number) = word.and_then(|word| own.chosen(word, &model.texts)) {
            let kind = own.kind();
            return Some(self.compiler.constant(number, kind));
        }
        let quoted =
            |word: &&str| if own.choices == Choices::Switch { format!("`{word}`") } else { format!("\"{word}\"") };
        let known: Vec<String> = own.words(&model.texts).iter().map(quoted).collect();
        let message = words!("`{}` cannot have this value", own.name);
        let hint = words!("it can be: {}", known.join(", "));
        let declared = self.places.parameters.get(parameter).copied().unwrap_or_default();
        let diagnostic = Diagnostic::error("not-a-choice", message, value.span)
            .with_label(declared, words("it is declared here"))
            .with_hint(hint);
        self.diagnostics.push(diagnostic);
        None
    }

    /// True if the value has the dimension of the parameter and lies in its range, as far as it is known before the run.
    fn fits(&mut self, parameter: usize, Placed { value, span }: &Placed) -> bool {
        let declared = self.places.parameters.get(parameter).copied().unwrap_or_default();
        let parameter = &self.model().parameters[parameter];
        if value.dimension() != parameter.unit.dimension {
            let message = words!("`{}` cannot have this value", parameter.name);
            let found = (*span, value.dimension());
            let expected = (declared, parameter.unit.dimension);
            self.diagnostics.push(dimension_error(message, found, expected));
            return false;
        }
        let (Node::Constant(bits), Some((low, high))) = (self.model().graph.node(value.node), parameter.range) else {
            return true;
        };
        if (low..=high).contains(&f64::from_bits(bits)) {
            return true;
        }
        let unit = &parameter.unit;
        let range = format!("{}..{} {unit}", unit.from_si(low), unit.from_si(high));
        let message = words!("`{}` cannot have this value", parameter.name);
        self.diagnostics.push(
            Diagnostic::error("out-of-range", message, *span)
                .saying(words!("outside {}", range.trim_end()))
                .with_label(declared, words("the range is declared here")),
        );
        false
    }

    /// The value for a quantity stated in `unit`: if one unit counts cycles and the other angles, it is converted and gets
    /// that unit.
    pub fn turned(&mut self, value: Compiled, unit: &Unit) -> Compiled {
        if value.unit.turning(unit) == 1.0 {
            return value;
        }
        let node = model::turned(self.graph(), value.node, &value.unit, unit);
        Compiled { node, unit: unit.clone(), ..value }
    }

    /// Index of the parameter with this name. Reports other names.
    pub fn parameter(&mut self, name: &model::Name) -> Option<usize> {
        let found = self.model().parameters.iter().position(|parameter| parameter.name == name.text);
        if found.is_none() {
            let message = words!("`{}` is not a parameter of the model", name.text);
            let names = self.model().parameters.iter().map(|parameter| parameter.name.as_str());
            let diagnostic = Diagnostic::error("unknown-name", message, name.span);
            let diagnostic = match units::nearest(&name.text, names) {
                _ if self.model().lookup(&name.text, 0).is_some() => {
                    settable::advise(diagnostic, self.source, self.model(), self.places, name)
                }
                Some(near) => diagnostic.meaning(near),
                None => diagnostic,
            };
            self.diagnostics.push(diagnostic);
        }
        found.filter(|&index| self.is_shown(index, name.span))
    }

    /// Parses definitions `name = expression`, which later expressions may use.
    pub fn define(&mut self, range: Range<usize>) {
        let (statements, diagnostics) = model::parse(self.source, &[range]);
        self.diagnostics.extend(diagnostics);
        for statement in statements {
            let StatementKind::Definition { name, mut value, unit } = statement.kind else {
                self.error(
                    "scene-definition",
                    words("before the drawing only definitions can stand: `name = expression`"),
                    statement.span,
                );
                continue;
            };
            if self.model().lookup(&name.text, 0).is_some() {
                self.error("duplicate-name", words!("`{}` is already a name of the model", name.text), name.span);
            } else if self.local.contains_key(&name.text) {
                self.error("duplicate-name", words!("`{}` is defined twice", name.text), name.span);
            } else {
                let whole = value.clone();
                if self.place(whole, unit.as_ref()).is_none() {
                    // Reported once, here; expressions that use the name are skipped.
                    value.kind = ExpressionKind::Error;
                } else {
                    self.replace(&mut value, &mut 0);
                }
                self.local.insert(name.text, value);
            }
        }
    }

    /// Binds a name to an expression, or removes it with `None`.
    pub fn bind(&mut self, name: String, meaning: Option<Expression>) {
        match meaning {
            Some(meaning) => drop(self.local.insert(name, meaning)),
            None => drop(self.local.remove(&name)),
        }
    }

    /// True if a name is already defined.
    pub fn is_taken(&self, name: &str) -> bool {
        self.model().lookup(name, 0).is_some() || self.local.contains_key(name)
    }

    /// Removes the names defined by [`Self::define`].
    pub fn forget(&mut self) {
        self.local.clear();
    }

    /// Completes and compiles a parsed expression.
    pub fn place(&mut self, expression: Expression, unit: Option<&StatedUnit>) -> Option<Placed> {
        let expression = self.completed(expression)?;
        match self.compiler.compile(&expression, unit) {
            Ok(value) => Some(Placed { value, span: expression.span }),
            Err(diagnostics) => {
                self.diagnostics.extend(diagnostics);
                None
            }
        }
    }

    /// Compiles the components of a vector; a number is its own single component.
    pub fn components(&mut self, expression: Expression) -> Option<Vec<Placed>> {
        let expression = self.completed(expression)?;
        let components = self.compiler.compile_components(&expression);
        let components = components.map_err(|diagnostics| self.diagnostics.extend(diagnostics)).ok()?;
        Some(components.into_iter().map(|value| Placed { value, span: expression.span }).collect())
    }

    /// Replaces the local names in an expression. `None` if part of it could not be parsed, or if it is too large.
    pub fn completed(&mut self, mut expression: Expression) -> Option<Expression> {
        let mut nodes = 0;
        if !self.local.is_empty() {
            self.replace(&mut expression, &mut nodes);
        }
        let extent = Extent::of(&expression);
        if nodes.max(extent.nodes) > NODES || extent.depth > DEPTH {
            self.error(
                "too-large",
                words("with the scene's own names written out this expression is too large"),
                expression.span,
            );
            return None;
        }
        (!extent.has_gap).then_some(expression)
    }

    /// Replaces local names by their expressions and counts nodes; stops at the limit.
    fn replace(&self, expression: &mut Expression, nodes: &mut usize) {
        *nodes += 1;
        if *nodes > NODES {
            return;
        }
        if let ExpressionKind::Name { name, order: 0 } = &expression.kind
            && let Some(meaning) = self.local.get(name)
        {
            // Its own names were replaced when it was defined.
            expression.kind = meaning.kind.clone();
            *nodes += Extent::of(expression).nodes;
            return;
        }
        for operand in expression.operands_mut() {
            self.replace(operand, nodes);
        }
    }

    /// Requires a number.
    pub fn expect_number(&mut self, compiled: Placed) -> Option<Placed> {
        let what = match compiled.value.kind {
            Kind::Number => return Some(compiled),
            Kind::Truth => words("this is true or false, and a number is needed"),
            Kind::Text => words("this is a text, and a number is needed"),
        };
        self.error("not-a-number", what, compiled.span);
        None
    }

    fn expect_constant(&mut self, compiled: Placed, what: &Words) -> Option<Placed> {
        let dependence = self.model().depends(compiled.value.node);
        let culprit = match dependence.states.first() {
            Some(state) => format!("`{}`", self.model().states[*state as usize].name()),
            None if dependence.independent => format!("`{}`", self.model().independent.name),
            None => return Some(compiled),
        };
        self.diagnostics.push(
            Diagnostic::error("varies", words!("{what} cannot change during the run"), compiled.span)
                .saying(words!("depends on {culprit}"))
                .with_hint(words("use parameters, quantities made of them, and values at the start such as `y(0)`")),
        );
        None
    }

    /// Adds an error.
    pub fn error(&mut self, code: &'static str, message: Words, span: Span) {
        self.diagnostics.push(Diagnostic::error(code, message, span));
    }
}

/// Error that shows the dimension found and the one expected.
pub fn dimension_error(
    message: Words,
    found: (Span, units::Dimension),
    expected: (Span, units::Dimension),
) -> Diagnostic {
    let describe = |dimension: units::Dimension| {
        if dimension.is_none() {
            return QuantityName::PURE_NUMBER.with_article();
        }
        Words::each(move |language| {
            let nouns = dimension.quantity_names().iter().map(|name| name.noun().text(language).into_owned());
            let nouns = nouns.collect::<Vec<_>>().join(", ");
            if nouns.is_empty() { dimension.to_string() } else { format!("{dimension} ({nouns})") }
        })
    };
    Diagnostic::error("dimension-mismatch", message, found.0)
        .saying(describe(found.1))
        .with_label(expected.0, describe(expected.1))
        .of_dimensions(found.1, expected.1)
}

/// [`dimension_error`] at one place, with a note about the dimension expected.
pub fn wrong_dimension(message: Words, span: Span, found: units::Dimension, expected: units::Dimension) -> Diagnostic {
    let mut diagnostic = dimension_error(message, (span, found), (span, expected));
    // Both labels would be at the same place.
    let expected = diagnostic.labels.pop().map(|label| label.text).unwrap_or_default();
    diagnostic.with_note(words!("it must be {expected}"))
}
