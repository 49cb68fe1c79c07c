//! Tables: columns with names and units, in declared units.

use crate::plan::Plan;
use crate::refusal::Refusal;
use crate::sweep::Taken;
use engine::History;
use engine::table::{Cell, Column};
use program::{Kind, Model, Outcomes};
use std::ops::Range;
use units::Unit;

/// A table. All columns have the same length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// Columns in their order.
    pub columns: Vec<TableColumn>,
}

/// A column of a [`Table`].
#[derive(Clone, Debug, PartialEq)]
pub struct TableColumn {
    /// Name, label and unit.
    pub head: Column,
    /// Values, one for each row.
    pub values: ColumnValues,
}

/// Values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnValues {
    /// Numbers in the unit of the column; NaN where there is no value.
    Numbers(Vec<f64>),
    /// Truth values of a condition.
    Truths(Vec<bool>),
    /// Texts of the document; `None` where there is no value.
    Texts(Vec<Option<Box<str>>>),
}

impl ColumnValues {
    fn new(kind: Kind) -> Self {
        match kind {
            Kind::Number => Self::Numbers(Vec::new()),
            Kind::Truth => Self::Truths(Vec::new()),
            Kind::Text => Self::Texts(Vec::new()),
        }
    }

    fn push(&mut self, cell: &Cell) {
        match (self, cell) {
            (Self::Numbers(values), Cell::Number(value)) => values.push(*value),
            (Self::Truths(values), Cell::Truth(value)) => values.push(*value),
            (Self::Texts(values), Cell::Text(text)) => values.push(Some(Box::from(&**text))),
            (Self::Numbers(values), _) => values.push(f64::NAN),
            (Self::Truths(values), _) => values.push(false),
            (Self::Texts(values), _) => values.push(None),
        }
    }
}

impl Table {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| match &column.values {
            ColumnValues::Numbers(values) => values.len(),
            ColumnValues::Truths(values) => values.len(),
            ColumnValues::Texts(values) => values.len(),
        })
    }

    /// A table without rows, with the columns of a table of a run.
    pub fn of_run(table: &engine::table::Table) -> Self {
        let columns = table.columns().iter().zip(table.kinds());
        let column =
            |(head, kind): (&Column, Kind)| TableColumn { head: head.clone(), values: ColumnValues::new(kind) };
        Self { columns: columns.map(column).collect() }
    }

    /// Adds rows of a run. `table` evaluates its columns, which are those of this table.
    pub fn take(&mut self, table: &mut engine::table::Table, history: &History, rows: Range<usize>) {
        for row in rows {
            for (column, cell) in self.columns.iter_mut().zip(table.row(history, row)) {
                column.values.push(cell);
            }
        }
    }

    /// Table of many runs: the number of each run from 1, the values of the axes, and what was kept; NaN where a run could not
    /// be computed.
    pub fn of_runs(model: &Model, plan: &Plan, outcomes: &Outcomes, taken: &Taken) -> Self {
        let [axes, kept] = sweep_columns(model, plan, outcomes);
        let number = Column { name: "run".to_owned(), label: None, unit: Unit::dimensionless() };
        let runs = taken.runs();
        let numbers = runs.clone().map(|run| (run + 1) as f64).collect();
        let mut columns = vec![TableColumn { head: number, values: ColumnValues::Numbers(numbers) }];
        let rows = (runs.end - runs.start) as usize;
        let mut varied: Vec<Vec<f64>> = axes.iter().map(|_| Vec::with_capacity(rows)).collect();
        let mut of_run = Vec::new();
        for run in runs {
            plan.set(run, &mut of_run);
            varied.iter_mut().zip(&of_run).for_each(|(values, value)| values.push(*value));
        }
        for ((head, axis), values) in axes.into_iter().zip(plan.axes()).zip(varied) {
            let values = values.into_iter();
            let values = match model.parameters.get(axis.parameter).filter(|parameter| !parameter.is_number()) {
                Some(parameter) => ColumnValues::Texts(
                    values.map(|value| parameter.word(value, &model.texts).map(Box::from)).collect(),
                ),
                None => ColumnValues::Numbers(values.map(|value| head.unit.from_si(value)).collect()),
            };
            columns.push(TableColumn { head, values });
        }
        for (place, head) in kept.into_iter().enumerate() {
            columns.push(TableColumn { head, values: ColumnValues::Numbers(taken.values(place).collect()) });
        }
        Self { columns }
    }
}

/// The named columns of a run, in the order asked for.
///
/// # Errors
/// A name that does not exist.
pub fn chosen_columns(model: &Model, names: &[&str]) -> Result<engine::table::Table, Refusal> {
    engine::table::Table::select(model, names).map_err(|unknown| {
        let message = format!("there is no column `{}`", unknown.name);
        let hint = match unknown.near {
            Some(near) => format!("did you mean `{near}`?"),
            None => "columns are names of the document: states, quantities and parameters".to_owned(),
        };
        Refusal::with_hint(message, hint)
    })
}

/// Columns of a table of many runs: of the axes, and of what is kept.
fn sweep_columns(model: &Model, plan: &Plan, outcomes: &Outcomes) -> [Vec<Column>; 2] {
    let axes = plan.axes().iter().filter_map(|axis| model.parameters.get(axis.parameter));
    let axes = axes.map(|parameter| (parameter.name.as_str(), &parameter.unit));
    let kept = outcomes.curves.iter().map(|curve| {
        let label = curve.label.as_deref().filter(|_| curve.named);
        (label.unwrap_or(&curve.expression), &curve.value.unit)
    });
    let column = |(name, unit): (&str, &Unit)| Column { name: name.to_owned(), label: None, unit: unit.clone() };
    [axes.map(column).collect(), kept.map(column).collect()]
}
