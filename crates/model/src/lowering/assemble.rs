//! Assembles the model from the checked and lowered parts.

use super::collect::Variation;
use super::expression::{Chain, Lowered, Lowering, TooManyNodes};
use super::friction::{add_friction, frictions};
use super::solve::{solve, too_many_nodes};
use super::turns::{TurnUnits, turned};
use crate::dimensions::{Type, Types};
use crate::matching::blocks;
use crate::names::{Declarations, EventEntry, Meaning, TableEntry, Unknown, crossing, list};
use crate::notation::primed;
use crate::{
    Diagnostic, Expression, ExpressionKind, ParameterForm, ParameterStatement, Places, Span, StatedUnit, TableStatement,
};
use program::{
    Assigned, Binary, Button, Choices, Compiled, Event, Graph, Grid, Independent, Kind, Model, Node, NodeId, Parameter,
    Quantity, Role, State, Table,
};
use units::order::sort_by_key;
use units::{Dimension, Exponent, Unit, words};

/// Builds the model and the places of its parts. `order` is the evaluation order of the definitions, `turn_units` their
/// units that count turns.
pub(crate) fn assemble(
    declarations: &Declarations,
    order: &[usize],
    unknowns: &[Unknown],
    (types, turn_units): (&Types, &TurnUnits),
) -> Result<(Model, Places), Vec<Diagnostic>> {
    let mut graph = Graph::default();
    let mut texts = Vec::new();
    let parameters = parameters(declarations, &mut texts);
    // Every named input has a node, so that names can always be looked up.
    graph.insert(Node::Independent);
    for index in 0..declarations.parameters.len() {
        graph.insert(Node::Parameter(index as u32));
    }
    for number in 0..unknowns.iter().map(|unknown| unknown.highest).sum() {
        graph.insert(Node::State(number));
    }
    let rates = solve(declarations, order, unknowns, (&mut graph, &mut texts))?;
    let chain = |(unknown, rate): (&Unknown, NodeId)| Chain {
        first_state: unknown.first_state,
        highest: unknown.highest,
        rate,
    };
    let chains: Vec<Chain> = unknowns.iter().zip(rates).map(chain).collect();
    let mut known = Lowered::of(vec![None; declarations.definitions.len()]);
    let mut lowering = Lowering {
        graph: &mut graph,
        texts: &mut texts,
        scope: &declarations.scope,
        chains: &chains,
        known: &mut known,
    };
    for &index in order {
        let definition = &declarations.definitions[index];
        let value = lower_stated(&mut lowering, definition.value, definition.unit, turn_units)?;
        lowering.known.definitions[index] = Some(value);
    }
    let (states, state_places) = states(&mut lowering, unknowns, types, turn_units)?;
    let (mut events, mut event_places, mut buttons) = (Vec::new(), Vec::new(), Vec::new());
    for event in &declarations.events {
        buttons.extend(event.button.map(|title| Button {
            title: title.text.clone(),
            name: event.name.map(|name| name.text.clone()),
            event: events.len() as u32,
        }));
        let lowered = lower_event(&mut lowering, declarations, event)?;
        event_places.extend(lowered.iter().map(|_| event.span));
        events.extend(lowered);
    }
    for expression in declarations.equations.iter().flat_map(|equation| [equation.left, equation.right]) {
        // The equation itself was lowered when it was solved; this records the places of its dry friction.
        for call in frictions(expression) {
            lower(&mut lowering, call)?;
        }
    }
    let tables = tables(declarations, lowering.graph);
    let Lowered { definitions: values, frictions: calls, .. } = known;
    let mut model = Model {
        independent: Independent {
            name: declarations.independent.0.clone(),
            unit: declarations.independent.1.clone(),
            counts: declarations.counts,
        },
        parameters,
        states,
        quantities: Vec::new(),
        tables,
        events,
        buttons,
        graph,
        texts,
        sizes: Vec::new(),
        sensitive: None,
    };
    let mut places = Places {
        parameters: declarations.parameters.iter().map(|entry| entry.span).collect(),
        states: state_places,
        events: event_places,
    };
    close_initial_values(&mut model, &places.states)?;
    let mut variation = Variation::default();
    for (index, ((definition, found), node)) in
        declarations.definitions.iter().zip(&types.definitions).zip(values.into_iter().flatten()).enumerate()
    {
        let stated = turn_units.of_definition(index).cloned();
        let unit = stated.unwrap_or_else(|| Unit::si(found.dimension()));
        let value = Compiled { node, kind: found.kind(), unit };
        let label = definition.label.map(str::to_owned);
        let varies = variation.of(&model.graph, node);
        let name = definition.name.text.clone();
        model.quantities.push(Quantity { name, label, value, varies, hidden: false, remembered: false });
    }
    // A quantity that is only another name for something is shown in the unit of that.
    for &index in order {
        let definition = &declarations.definitions[index];
        if let ExpressionKind::Name { name, order } | ExpressionKind::InitialValue { name, order } =
            &definition.value.kind
            && definition.unit.is_none()
            && let Some(named) = model.lookup(name, *order)
        {
            model.quantities[index].value.unit = named.unit;
        }
    }
    add_friction(&mut model, &mut places, &calls, declarations)?;
    Ok((model, places))
}

impl Type {
    /// Kind of value; an unknown type counts as a number.
    pub fn kind(&self) -> Kind {
        match self {
            Self::Number(_) | Self::Unknown => Kind::Number,
            Self::Truth => Kind::Truth,
            Self::Text => Kind::Text,
        }
    }

    /// Dimension of the value, after all dimensions have been settled.
    pub fn dimension(&self) -> Dimension {
        match self {
            Self::Number(form) => form.known,
            Self::Truth | Self::Text | Self::Unknown => Dimension::NONE,
        }
    }
}

fn lower(lowering: &mut Lowering, expression: &Expression) -> Result<NodeId, Vec<Diagnostic>> {
    lowering.expression(expression).map_err(|TooManyNodes| vec![too_many_nodes(expression.span)])
}

/// Lowers a value. A bare name or number is converted if its unit and the stated one count turns differently.
fn lower_stated(
    lowering: &mut Lowering,
    value: &Expression,
    stated: Option<&StatedUnit>,
    turn_units: &TurnUnits,
) -> Result<NodeId, Vec<Diagnostic>> {
    let node = lower(lowering, value)?;
    match (turn_units.own(value), stated) {
        (Some(own), Some(stated)) => Ok(turned(lowering.graph, node, &own, &stated.unit)),
        _ => Ok(node),
    }
}

/// The parameters. Adds the texts of choices to `texts`, where they come first.
fn parameters(declarations: &Declarations, texts: &mut Vec<String>) -> Vec<Parameter> {
    let parameter = |entry: &crate::names::ParameterEntry| {
        let statement = entry.statement;
        let unit = statement.unit.as_ref().map_or_else(Unit::dimensionless, |stated| stated.unit.clone());
        let choices = match &statement.form {
            ParameterForm::Number => Choices::Numbers,
            ParameterForm::Switch => Choices::Switch,
            ParameterForm::Seed => Choices::Seed,
            ParameterForm::Choice(own) => Choices::Texts(own.iter().map(|text| text_index(texts, text)).collect()),
        };
        let value = match &choices {
            Choices::Texts(own) => own.first().copied().map_or(0.0, f64::from),
            Choices::Numbers | Choices::Switch | Choices::Seed => unit.to_si(statement.value),
        };
        Parameter {
            name: statement.name.text.clone(),
            label: entry.label.map(str::to_owned),
            group: entry.group.map(str::to_owned),
            value,
            choices,
            range: statement.range.as_ref().map(|bounds| (unit.to_si(bounds.low), unit.to_si(bounds.high))),
            step: statement.step.map(|step| unit.to_si(step)),
            restarts: statement.form == ParameterForm::Seed,
            hidden: entry.hidden,
            assigned: assigned(statement, value),
            unit,
        }
    };
    declarations.parameters.iter().map(parameter).collect()
}

/// Values for the seats of a class. `stated`: value without a seat, SI units.
fn assigned(statement: &ParameterStatement, stated: f64) -> Option<Assigned> {
    let own = statement.assigned.as_ref()?;
    Some(Assigned { grid: Grid::new(own.bounds.low, own.bounds.high, own.step?).ok()?, stated })
}

/// The functions defined by tables, including those that no expression of the model calls.
fn tables(declarations: &Declarations, graph: &mut Graph) -> Vec<Table> {
    let unit =
        |stated: &Option<StatedUnit>| stated.as_ref().map_or_else(Unit::dimensionless, |stated| stated.unit.clone());
    let table = |entry: &TableEntry| {
        let TableStatement { name, argument, argument_unit, unit: own, .. } = entry.statement;
        let function = declarations.scope.table(&name.text)?;
        Some(Table {
            name: name.text.clone(),
            label: entry.label.map(str::to_owned),
            argument: argument.text.clone(),
            argument_unit: unit(argument_unit),
            unit: unit(own),
            interpolation: graph.insert_interpolation(&function.interpolation),
            drawn: function.drawn.clone(),
        })
    };
    declarations.tables.iter().filter_map(table).collect()
}

/// Index of a text in `texts`; appends the text if it is new.
fn text_index(texts: &mut Vec<String>, text: &str) -> u32 {
    let known = texts.iter().position(|known| known == text);
    let index = known.unwrap_or_else(|| {
        texts.push(text.to_owned());
        texts.len() - 1
    });
    index as u32
}

/// The states in the order of their numbers, and the places of their initial values. Initial values may still depend on
/// each other.
fn states(
    lowering: &mut Lowering,
    unknowns: &[Unknown],
    types: &Types,
    turn_units: &TurnUnits,
) -> Result<(Vec<State>, Vec<Span>), Vec<Diagnostic>> {
    let (mut states, mut places) = (Vec::new(), Vec::new());
    let mut in_order: Vec<usize> = (0..unknowns.len()).collect();
    sort_by_key(&mut in_order, |&index| unknowns[index].first_state);
    for index in in_order {
        let (unknown, chain) = (&unknowns[index], lowering.chains[index]);
        for (order, entry) in (0_u32..).zip(unknown.initial.iter().flatten()) {
            let dimension =
                types.unknowns[index].known.per(power(types.independent.known, order)).unwrap_or(Dimension::NONE);
            let unit = turn_units.of_unknown(unknown.name, order).cloned();
            let unit = unit.unwrap_or_else(|| Unit::si(dimension));
            states.push(State {
                variable: unknown.name.to_owned(),
                order,
                label: entry.label.map(str::to_owned),
                unit,
                initial: lower_stated(lowering, entry.value, entry.unit, turn_units)?,
                role: if crate::moments::is_hidden(unknown.name) { Role::Remembered } else { Role::Own },
                derivative: chain.node(lowering.graph, order + 1).unwrap_or(chain.rate),
            });
            places.push(entry.value.span);
        }
    }
    Ok((states, places))
}

/// A power of a dimension. It cannot overflow, because it was computed before.
fn power(dimension: Dimension, order: u32) -> Dimension {
    Exponent::new(i64::from(order), 1).and_then(|order| dimension.power(order)).unwrap_or(Dimension::NONE)
}

/// Lowers an event. A crossing becomes two events, one per direction. If the two sides are equal at the start, both
/// conditions are already true.
fn lower_event(
    lowering: &mut Lowering,
    declarations: &Declarations,
    event: &EventEntry,
) -> Result<Vec<Event>, Vec<Diagnostic>> {
    let conditions = match crossing(declarations, event) {
        Some((left, right)) => {
            let (left, right) = (lower(lowering, left)?, lower(lowering, right)?);
            let mut reaches = |a, b| lowering.graph.binary(Binary::LessOrEqual, a, b);
            vec![reaches(left, right), reaches(right, left)]
        }
        None => vec![lower(lowering, event.condition)?],
    };
    let mut actions = Vec::new();
    for action in event.actions {
        if let Some(Meaning::Variable(index)) = lowering.scope.meaning(&action.name.text) {
            let number = lowering.chains[index].first_state as u32 + action.order;
            actions.push((number, lower(lowering, &action.value)?));
        }
    }
    let of = |condition| Event {
        title: event.title.map(str::to_owned),
        is_labelled: event.is_labelled,
        stops: event.stops,
        ..Event::new(condition, actions.clone())
    };
    Ok(conditions.into_iter().map(of).collect())
}

/// Makes initial values depend on parameters alone, and marks these parameters.
fn close_initial_values(model: &mut Model, places: &[Span]) -> Result<(), Vec<Diagnostic>> {
    let dependences: Vec<_> = model.states.iter().map(|state| model.depends(state.initial)).collect();
    let mut diagnostics = Vec::new();
    for ((state, dependence), place) in model.states.iter().zip(&dependences).zip(places) {
        if !dependence.varies() {
            continue;
        }
        let (what, hint) = match dependence.states.first().map(|&number| model.states[number as usize].name()) {
            Some(name) => (name.clone(), words!("for its initial value write `{name}(0)`")),
            None => (model.independent.name.clone(), words("leave it out: the run starts at 0")),
        };
        let message = words!("the initial value of `{}` depends on `{what}`, which changes", state.name());
        diagnostics.push(Diagnostic::error("initial-value-varies", message, *place).with_hint(hint));
    }
    let needs: Vec<Vec<usize>> = dependences
        .iter()
        .map(|dependence| dependence.initial.iter().map(|&number| number as usize).collect())
        .collect();
    let mut values: Vec<NodeId> = model.states.iter().map(|state| state.initial).collect();
    for block in blocks(&needs) {
        let is_circle = block.len() > 1 || block.iter().any(|&number| needs[number].contains(&number));
        if is_circle {
            diagnostics.push(initial_circle(model, &block, places));
        }
        for number in block.into_iter().filter(|_| !is_circle) {
            let closed = model.graph.substitute(&[values[number]], |_, input| match input {
                Node::Initial(other) => values.get(other as usize).copied(),
                _ => None,
            });
            values[number] = closed.first().copied().unwrap_or(values[number]);
            model.states[number].initial = values[number];
        }
    }
    for state in 0..model.states.len() {
        for number in model.depends(model.states[state].initial).parameters {
            model.parameters[number as usize].restarts = true;
        }
    }
    if diagnostics.is_empty() { Ok(()) } else { Err(diagnostics) }
}

fn initial_circle(model: &Model, members: &[usize], places: &[Span]) -> Diagnostic {
    let written = |&number: &usize| {
        let state = &model.states[number];
        format!("`{}(0)`", primed(&state.variable, state.order))
    };
    let names: Vec<String> = members.iter().map(written).collect();
    let message = if names.len() == 1 {
        words!("the initial value {names} is given by itself", names = list(&names))
    } else {
        words!("the initial values {names} go in a circle", names = list(&names))
    };
    let mut diagnostic = Diagnostic::error("cycle", message, places[members[0]]);
    for &other in &members[1..] {
        diagnostic = diagnostic.with_label(places[other], words("and this"));
    }
    diagnostic
}
