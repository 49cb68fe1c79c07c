//! The rows of a run as a table in display units. Page and command line write the same characters.

mod write;

use crate::{History, Readings};
use program::{Kind, Model, NodeId, Quantity, State};
use std::rc::Rc;
use units::Unit;

/// A selection of columns of a run, evaluated row by row.
#[derive(Clone, Debug)]
pub struct Table {
    columns: Vec<Column>,
    sources: Vec<Source>,
    readings: Readings,
    texts: Vec<Rc<str>>,
    cells: Vec<Cell>,
}

/// A column of a [`Table`].
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name with primes, such as `y'`.
    pub name: String,
    /// Label given by the author, if any.
    pub label: Option<String>,
    /// Display unit; empty text for a pure number.
    pub unit: Unit,
}

impl Column {
    /// Name and unit, `y' [m/s]`; only the name if the unit is empty.
    pub fn heading(&self) -> String {
        if self.unit.text.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit.text) }
    }
}

/// A cell of a [`Table`], in the unit of its column.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A number, perhaps not finite.
    Number(f64),
    /// Truth value of a condition.
    Truth(bool),
    /// A text of the document.
    Text(Rc<str>),
}

/// A column that does not exist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownColumn {
    /// The name asked for.
    pub name: String,
    /// The most similar known name, if one is similar.
    pub near: Option<String>,
}

/// Source of the values of a column.
#[derive(Clone, Copy, Debug)]
enum Source {
    Independent,
    State(usize),
    Parameter(usize),
    /// Root of this index, of this kind.
    Reading(usize, Kind),
}

impl Table {
    /// Default columns: the independent variable, the states and the quantities that vary.
    pub fn new(model: &Model) -> Self {
        let mut chosen = vec![independent(model)];
        let remembered = |index: &usize| model.states[*index].role == program::Role::Remembered;
        chosen.extend((0..model.states.len()).filter(|index| !remembered(index)).map(|index| state(model, index)));
        let shown = |quantity: &program::Quantity| quantity.varies && !quantity.remembered;
        let varying = model.quantities.iter().enumerate().filter(|(_, quantity)| shown(quantity));
        chosen.extend(varying.map(|(index, _)| quantity(model, index)));
        Self::of(model, chosen)
    }

    /// The named columns in the order asked for; parameters, constant quantities and highest derivatives are allowed too.
    ///
    /// # Errors
    /// A name that does not exist.
    pub fn select(model: &Model, names: &[&str]) -> Result<Self, UnknownColumn> {
        let chosen: Result<Vec<_>, _> = names.iter().map(|name| find(model, name)).collect();
        Ok(Self::of(model, chosen?))
    }

    fn of(model: &Model, chosen: Vec<(Column, Origin)>) -> Self {
        let mut roots = Vec::new();
        let mut columns = Vec::new();
        let mut sources = Vec::new();
        for (column, origin) in chosen {
            columns.push(column);
            sources.push(match origin {
                Origin::Known(source) => source,
                Origin::Node(node, kind) => {
                    roots.push(node);
                    Source::Reading(roots.len() - 1, kind)
                }
            });
        }
        let readings = Readings::new(model, &roots);
        let texts = model.texts.iter().map(|text| Rc::from(text.as_str())).collect();
        Self { columns, sources, readings, texts, cells: Vec::new() }
    }

    /// The columns, in order.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Kind of the values of each column.
    pub fn kinds(&self) -> impl Iterator<Item = Kind> {
        self.sources.iter().map(|source| match source {
            Source::Reading(_, kind) => *kind,
            _ => Kind::Number,
        })
    }

    /// The cells of a recorded row, one per column.
    pub fn row(&mut self, history: &History, row: usize) -> &[Cell] {
        let read = self.readings.at_row(history, row);
        self.cells.clear();
        for (column, source) in self.columns.iter().zip(&self.sources) {
            let number = |si: f64| Cell::Number(column.unit.from_si(si));
            self.cells.push(match *source {
                Source::Independent => number(history.time(row)),
                Source::State(index) => number(history.column(index)[row]),
                Source::Parameter(index) => number(history.parameters(row)[index]),
                Source::Reading(root, Kind::Number) => number(read[root]),
                Source::Reading(root, Kind::Truth) => Cell::Truth(read[root] != 0.0),
                Source::Reading(root, Kind::Text) => match self.texts.get(read[root] as usize) {
                    Some(text) => Cell::Text(text.clone()),
                    None => Cell::Number(f64::NAN),
                },
            });
        }
        &self.cells
    }
}

/// Source of the values of a column, before the roots are collected.
enum Origin {
    Known(Source),
    Node(NodeId, Kind),
}

fn independent(model: &Model) -> (Column, Origin) {
    let unit = model.independent.unit.clone();
    (Column { name: model.independent.name.clone(), label: None, unit }, Origin::Known(Source::Independent))
}

fn state(model: &Model, index: usize) -> (Column, Origin) {
    let state = &model.states[index];
    let column = Column { name: state.name(), label: state.label.clone(), unit: state.unit.clone() };
    (column, Origin::Known(Source::State(index)))
}

fn parameter(model: &Model, index: usize) -> (Column, Origin) {
    let parameter = &model.parameters[index];
    let column = Column { name: parameter.name.clone(), label: parameter.label.clone(), unit: parameter.unit.clone() };
    let node = model.graph.find(program::Node::Parameter(index as u32));
    let origin = match (parameter.kind(), node) {
        (Kind::Number, _) | (_, None) => Origin::Known(Source::Parameter(index)),
        (kind, Some(node)) => Origin::Node(node, kind),
    };
    (column, origin)
}

fn quantity(model: &Model, index: usize) -> (Column, Origin) {
    let quantity = &model.quantities[index];
    let value = &quantity.value;
    let column = Column { name: quantity.name.clone(), label: quantity.label.clone(), unit: value.unit.clone() };
    (column, Origin::Node(value.node, value.kind))
}

fn find(model: &Model, name: &str) -> Result<(Column, Origin), UnknownColumn> {
    if name == model.independent.name {
        return Ok(independent(model));
    }
    if let Some(index) = model.states.iter().position(|state| state.name() == name) {
        return Ok(state(model, index));
    }
    let is_meant = |one: &Quantity| one.name == name && !model.is_secret(one.value.node);
    if let Some(index) = model.quantities.iter().position(is_meant) {
        return Ok(quantity(model, index));
    }
    if let Some((index, _)) = model.shown_parameters().find(|(_, parameter)| parameter.name == name) {
        return Ok(parameter(model, index));
    }
    let bare = name.trim_end_matches('\'');
    let order = (name.len() - bare.len()) as u32;
    if let Some(value) = model.lookup_shown(bare, order) {
        let column = Column { name: name.to_owned(), label: None, unit: value.unit };
        return Ok((column, Origin::Node(value.node, value.kind)));
    }
    let states: Vec<String> = model.states.iter().map(State::name).collect();
    let seen = model.quantities.iter().filter(|quantity| !model.is_secret(quantity.value.node));
    let known = std::iter::once(model.independent.name.as_str())
        .chain(states.iter().map(String::as_str))
        .chain(seen.map(|quantity| quantity.name.as_str()))
        .chain(model.shown_parameters().map(|(_, parameter)| parameter.name.as_str()));
    let near = units::nearest(name, known).map(str::to_owned);
    Err(UnknownColumn { name: name.to_owned(), near })
}
