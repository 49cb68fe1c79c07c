//! Units that count turns: cycles (`Hz`) or angles (`rad/s`, `rpm`). Where both meet, 1 Hz is 2 pi rad/s.
//!
//! A bare name or number counts what its stated unit counts. A definition without a stated unit counts what its terms count,
//! if pure numbers are their only other factors and none converts: `3*f` counts cycles if `f` does, `2*pi*f` is not settled.

use crate::dimensions::Types;
use crate::names::{Declarations, Meaning, for_each};
use crate::{BinaryOperator, Diagnostic, Expression, ExpressionKind, Span, StatedUnit, UnaryOperator};
use program::{Graph, NodeId};
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::f64::consts::{PI, TAU};
use std::sync::LazyLock;
use units::{Unit, words};

/// Numbers that convert between cycles and angles, also if they are written with three digits.
const CONVERTING: [f64; 4] = [PI, TAU, 1.0 / PI, 1.0 / TAU];

/// Relative accuracy to which a number is taken for one of [`CONVERTING`].
const NEAR: f64 = 2e-3;

/// Adds the conversion of the value `node` of a quantity stated in `own` to the graph, for a quantity stated in `quantity`.
/// Returns the node of the SI value, `node` itself unless one unit counts cycles and the other angles.
pub fn turned(graph: &mut Graph, node: NodeId, own: &Unit, quantity: &Unit) -> NodeId {
    let (up, down) = (own.turning(quantity), quantity.turning(own));
    if up == down {
        return node;
    }
    if let Some(value) = graph.as_constant(node) {
        return graph.constant(own.to_si_of(own.from_si(value), quantity));
    }
    // Division by 2 pi is exact more often than multiplication by its rounded reciprocal.
    let factor = graph.constant(up.max(down));
    if up < down { graph.divide(node, factor) } else { graph.multiply(node, factor) }
}

/// Unit in which a bare name or number is stated, also with a sign; `None` for any other expression. `unit_of`: unit of a
/// name by its text and derivative order.
pub(crate) fn own_unit<'e>(
    expression: &'e Expression,
    unit_of: &dyn Fn(&str, u32) -> Option<Cow<'e, Unit>>,
) -> Option<Cow<'e, Unit>> {
    match &expression.kind {
        ExpressionKind::Number { unit, .. } => unit.as_ref().map(Cow::Borrowed),
        ExpressionKind::Name { name, order } | ExpressionKind::InitialValue { name, order } => unit_of(name, *order),
        ExpressionKind::Unary(UnaryOperator::Negate, operand) => own_unit(operand, unit_of),
        _ => None,
    }
}

/// Way to count turns.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Count {
    Cycles,
    Angles,
}

/// The units of a model's quantities, as far as they count turns.
#[derive(Debug)]
pub(crate) struct TurnUnits<'a> {
    declarations: &'a Declarations<'a>,
    /// Units of the unknowns, by name and derivative order: stated, or of the number at the start if that counts turns.
    unknowns: HashMap<(&'a str, u32), &'a Unit>,
    definitions: Vec<Counted>,
}

/// A definition.
#[derive(Clone, Debug, Default)]
struct Counted {
    /// Unit in which it is stated, or which counts what its terms count.
    unit: Option<Unit>,
    /// True if a factor of this definition may convert between cycles and angles.
    converts: bool,
}

impl<'a> TurnUnits<'a> {
    /// Units of the definitions, whose evaluation order is `order`.
    pub fn new(declarations: &'a Declarations<'a>, order: &[usize], types: &Types) -> Self {
        let unknowns = declarations.initial_values.iter();
        let unknowns = unknowns.filter_map(|entry| {
            let of_number = || Some(rate_of(count_of(&*own_unit(entry.value, &|_, _| None)?)?));
            let unit = entry.unit.map(|stated| &stated.unit).or_else(of_number)?;
            Some(((entry.name.text.as_str(), entry.order), unit))
        });
        let definitions = vec![Counted::default(); declarations.definitions.len()];
        let mut units = Self { declarations, unknowns: unknowns.collect(), definitions };
        for &index in order {
            let definition = &declarations.definitions[index];
            let converts = units.converts(definition.value);
            let is_rate = types.definitions[index].dimension() == RATES.hertz.dimension;
            let counted = || match own_unit(definition.value, &|_, _| None) {
                Some(of_number) => count_of(&of_number).map(|_| of_number.into_owned()),
                None => units.count(definition.value, false).map(|count| rate_of(count).clone()),
            };
            let unit = definition.unit.map(|stated| stated.unit.clone());
            let unit = unit.or_else(|| is_rate.then(counted).flatten());
            let counts = unit.as_ref().is_some_and(Unit::counts_turns);
            units.definitions[index] = Counted { unit, converts: converts || counts };
        }
        units
    }

    /// Unit of a definition: the stated one, or that of its terms if they count turns.
    pub fn of_definition(&self, index: usize) -> Option<&Unit> {
        self.definitions[index].unit.as_ref()
    }

    /// Unit of an unknown or its derivative: the stated one, or that of its number at the start if that counts turns.
    pub fn of_unknown(&self, name: &str, order: u32) -> Option<&Unit> {
        self.unknowns.get(&(name, order)).copied()
    }

    /// Unit in which a bare name or number is stated.
    pub fn own<'s>(&'s self, expression: &'s Expression) -> Option<Cow<'s, Unit>> {
        own_unit(expression, &|name, order| self.of_name(name, order).map(Cow::Borrowed))
    }

    fn of_name(&self, name: &str, order: u32) -> Option<&Unit> {
        match self.declarations.scope.meaning(name)? {
            Meaning::Parameter(index) if order == 0 => {
                Some(&self.declarations.parameters[index].statement.unit.as_ref()?.unit)
            }
            Meaning::Definition(index) if order == 0 => self.of_definition(index),
            Meaning::Independent if order == 0 => Some(&self.declarations.independent.1),
            Meaning::Variable(_) => self.of_unknown(name, order),
            _ => None,
        }
    }

    /// Returns what the terms of an expression count; `None` if that is not settled. `strict`: every term must count.
    fn count(&self, expression: &Expression, strict: bool) -> Option<Count> {
        let mut found = None;
        // Without recursion over the terms, because a written out sum has thousands.
        let mut waiting = vec![expression];
        while let Some(next) = waiting.pop() {
            let count = match &next.kind {
                _ if let Some(unit) = self.own(next) => count_of(&unit),
                ExpressionKind::Unary(UnaryOperator::Negate, operand) => {
                    waiting.push(operand);
                    continue;
                }
                ExpressionKind::Binary(BinaryOperator::Add | BinaryOperator::Subtract, left, right)
                | ExpressionKind::If(_, left, right) => {
                    waiting.extend([&**left, &**right]);
                    continue;
                }
                ExpressionKind::Call { function, arguments }
                    if matches!(function.text.as_str(), "min" | "max" | "abs") =>
                {
                    waiting.extend(arguments);
                    continue;
                }
                ExpressionKind::Expansion(expansion) if expansion.unit.is_none() => {
                    waiting.push(&expansion.body);
                    continue;
                }
                ExpressionKind::Expansion(expansion) => {
                    expansion.unit.as_ref().and_then(|stated| count_of(&stated.unit))
                }
                ExpressionKind::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, ..) => {
                    self.counting_factor(next).map(|(_, count)| count)
                }
                _ => None,
            };
            if count.is_some_and(|count| found.is_some_and(|found| found != count)) || (strict && count.is_none()) {
                return None;
            }
            found = found.or(count);
        }
        found
    }

    /// The only factor of a product that counts turns; `None` if another one may convert them or counts turns, too.
    fn counting_factor<'e>(&self, product: &'e Expression) -> Option<(&'e Expression, Count)> {
        let mut found = None;
        for (factor, divides) in factors(product) {
            match self.count(factor, true) {
                Some(count) if !divides && found.is_none() => found = Some((factor, count)),
                None if !self.converts(factor) => {}
                _ => return None,
            }
        }
        found
    }

    /// True if a factor may convert between cycles and angles: it contains `pi`, a number near it, or what counts turns.
    fn converts(&self, factor: &Expression) -> bool {
        let mut found = false;
        for_each(factor, |part| {
            found |= match &part.kind {
                ExpressionKind::Number { value, unit: None } => {
                    CONVERTING.iter().any(|number| (value / number - 1.0).abs() < NEAR)
                }
                ExpressionKind::Name { name, order: 0 } | ExpressionKind::InitialValue { name, order: 0 }
                    if matches!(self.declarations.scope.meaning(name), Some(Meaning::Pi)) =>
                {
                    true
                }
                ExpressionKind::Name { name, .. } | ExpressionKind::InitialValue { name, .. }
                    if let Some(Meaning::Definition(index)) = self.declarations.scope.meaning(name) =>
                {
                    self.definitions[index].converts
                }
                _ => self.own(part).is_some_and(|unit| unit.counts_turns()),
            };
        });
        found
    }

    /// Warns of each quantity that counts cycles and is the only factor of a time, or of another quantity, in the argument of
    /// a sine or cosine: `sin(f*t)`.
    pub fn remark_on_sines(&self, diagnostics: &mut Vec<Diagnostic>) {
        let declarations = self.declarations;
        let equations = declarations.equations.iter().flat_map(|equation| [equation.left, equation.right]);
        let definitions = declarations.definitions.iter().map(|one| one.value);
        let initial = declarations.initial_values.iter().map(|one| one.value);
        let events = declarations.events.iter();
        let events = events.flat_map(|event| event.actions.iter().map(|action| &action.value).chain([event.condition]));
        let mut found: Vec<&Expression> = Vec::new();
        for expression in equations.chain(definitions).chain(initial).chain(events) {
            for_each(expression, |part| {
                if let ExpressionKind::Call { function, arguments } = &part.kind
                    && let ("sin" | "cos", [argument]) = (function.text.as_str(), arguments.as_slice())
                {
                    self.cycles_in(argument, &mut found);
                }
            });
        }
        let mut places = HashSet::new();
        for factor in found.into_iter().filter(|factor| places.insert(factor.span)) {
            diagnostics.push(self.remark(factor));
        }
    }

    /// Collects the factors of the terms of an angle that count cycles and are not converted to angles.
    fn cycles_in(&self, angle: &'a Expression, found: &mut Vec<&'a Expression>) {
        let mut waiting = vec![angle];
        let mut followed = HashSet::new();
        while let Some(next) = waiting.pop() {
            match &next.kind {
                ExpressionKind::Binary(BinaryOperator::Multiply | BinaryOperator::Divide, ..) => {
                    if let Some((factor, count)) = self.counting_factor(next) {
                        found.extend((count == Count::Cycles).then_some(factor));
                        continue;
                    }
                    // The terms of the only factor that may convert, as in `n*(f*t + phi)`.
                    let converting: Vec<_> = factors(next).into_iter().filter(|(one, _)| self.converts(one)).collect();
                    if let [(factor, false)] = converting.as_slice() {
                        waiting.push(factor);
                    }
                }
                ExpressionKind::Unary(_, operand) => waiting.push(operand),
                ExpressionKind::Binary(BinaryOperator::Add | BinaryOperator::Subtract, left, right)
                | ExpressionKind::If(_, left, right) => waiting.extend([&**left, &**right]),
                ExpressionKind::Expansion(expansion) => waiting.push(&expansion.body),
                ExpressionKind::Name { name, order: 0 } => {
                    if let Some(Meaning::Definition(index)) = self.declarations.scope.meaning(name)
                        && self.definitions[index].unit.is_none()
                        && followed.insert(index)
                    {
                        waiting.push(self.declarations.definitions[index].value);
                    }
                }
                _ => {}
            }
        }
    }

    fn remark(&self, factor: &Expression) -> Diagnostic {
        let name = crate::notation::quote(factor);
        let message = words!("`{name}` counts cycles, and a sine or cosine takes radians");
        let start = Span::new(factor.span.start, factor.span.start);
        let is_sum = matches!(factor.kind, ExpressionKind::Binary(..));
        let example = if is_sum { format!("2*pi*({name})") } else { format!("2*pi*{name}") };
        let mut diagnostic = Diagnostic::warning("cycles-in-sine", message, factor.span)
            .with_note(words("one cycle per second, 1 Hz, is an angular frequency of 2*pi radians per second"))
            .with_hint(words!("write `{example}`"));
        if !is_sum {
            diagnostic = diagnostic.with_fix(start, "2*pi*");
        }
        let stated = self.stated_at(factor).filter(|stated| stated.unit.text == "Hz");
        match stated {
            Some(stated) => diagnostic
                .with_label(stated.span, words("its unit"))
                .with_hint(words!("if `{name}` is an angular frequency, state it in [rad/s]"))
                .with_fix(stated.span, "[rad/s]"),
            None => diagnostic,
        }
    }

    /// Stated unit of a parameter or definition, with its place.
    fn stated_at(&self, factor: &Expression) -> Option<&'a StatedUnit> {
        let ExpressionKind::Name { name, order: 0 } = &factor.kind else { return None };
        match self.declarations.scope.meaning(name)? {
            Meaning::Parameter(index) => self.declarations.parameters[index].statement.unit.as_ref(),
            Meaning::Definition(index) => self.declarations.definitions[index].unit,
            _ => None,
        }
    }
}

/// Units of the dimension of a frequency.
struct Rates {
    hertz: Unit,
    radians: Unit,
}

static RATES: LazyLock<Rates> = LazyLock::new(|| {
    let [hertz, radians] = ["Hz", "rad/s"].map(|text| Unit::parse(text).unwrap_or_else(|_| Unit::dimensionless()));
    Rates { hertz, radians }
});

/// Returns what a unit of the dimension of a frequency counts.
fn count_of(unit: &Unit) -> Option<Count> {
    let Rates { hertz, radians } = &*RATES;
    let other = if unit.counts_cycles() { (radians, Count::Cycles) } else { (hertz, Count::Angles) };
    (unit.dimension == hertz.dimension && unit.turning(other.0) != 1.0).then_some(other.1)
}

/// Coherent unit of a frequency or an angular velocity.
fn rate_of(count: Count) -> &'static Unit {
    let Rates { hertz, radians } = &*RATES;
    if count == Count::Cycles { hertz } else { radians }
}

/// Factors of a product or quotient; true with those below a fraction bar.
fn factors(product: &Expression) -> Vec<(&Expression, bool)> {
    let mut found = Vec::new();
    let mut waiting = vec![(product, false)];
    while let Some((next, divides)) = waiting.pop() {
        match &next.kind {
            ExpressionKind::Binary(BinaryOperator::Multiply, left, right) => {
                waiting.extend([(&**right, divides), (&**left, divides)]);
            }
            ExpressionKind::Binary(BinaryOperator::Divide, left, right) => {
                waiting.extend([(&**right, !divides), (&**left, divides)]);
            }
            ExpressionKind::Unary(UnaryOperator::Negate, operand) => waiting.push((operand, divides)),
            _ => found.push((next, divides)),
        }
    }
    found
}
