//! A run in few rows: a table with rows at equal distances, statistics of its columns, and the moments at which states jump.

use engine::History;
use engine::table::{Cell, Column, Table};
use program::{Model, Role};
use serde_json::{Map, Value, json};
use std::ops::Range;

/// Largest number of events that are listed.
const EVENTS: usize = 100;
/// Change of a state that is none, as a part of its greatest amount.
const ROUNDING: f64 = 1e-9;

/// Summary of a run. Its size does not depend on the length of the run.
#[derive(Debug)]
pub struct Summary {
    table: Table,
    /// Largest number of rows that are kept, at least 2.
    most: usize,
    /// Kept rows; each is `every` rows behind the one before.
    rows: Vec<Vec<Value>>,
    every: usize,
    /// Number of rows so far, and the last one.
    count: usize,
    last: Vec<Value>,
    statistics: Vec<Statistics>,
    /// States of the model that are shown: index, name, and number.
    states: Vec<(usize, String)>,
    events: Vec<Value>,
    event_count: usize,
    /// Time and state of the row before.
    before: (f64, Vec<f64>),
    /// Greatest amount of each state so far.
    scales: Vec<f64>,
}

/// Statistics of the numbers of a column.
#[derive(Clone, Debug, Default)]
struct Statistics {
    count: usize,
    sum: f64,
    first: f64,
    last: f64,
    /// Value and time.
    least: (f64, f64),
    greatest: (f64, f64),
}

impl Summary {
    /// An empty summary of at most `most` rows of a table.
    pub fn new(table: Table, model: &Model, most: usize) -> Self {
        let shown = |role: Role| !matches!(role, Role::Remembered | Role::Friction);
        let states = model.states.iter().enumerate().filter(|(_, state)| shown(state.role));
        let name = |(index, state): (usize, &program::State)| {
            (index, state.variable.clone() + &"'".repeat(state.order as usize))
        };
        Self {
            statistics: vec![Statistics::default(); table.columns().len()],
            states: states.map(name).collect(),
            table,
            most: most.max(2),
            rows: Vec::new(),
            every: 1,
            count: 0,
            last: Vec::new(),
            events: Vec::new(),
            event_count: 0,
            before: (f64::NAN, Vec::new()),
            scales: vec![0.0; model.states.len()],
        }
    }

    /// Takes rows of a run.
    pub fn take(&mut self, model: &Model, history: &History, rows: Range<usize>) {
        for row in rows {
            let time = model.independent.unit.from_si(history.time(row));
            let cells = self.table.row(history, row);
            for (statistics, cell) in self.statistics.iter_mut().zip(cells) {
                if let Cell::Number(number) = cell {
                    statistics.take(*number, time);
                }
            }
            self.last = cells.iter().map(value).collect();
            if self.count.is_multiple_of(self.every) {
                self.rows.push(self.last.clone());
            }
            self.count += 1;
            if self.rows.len() > 2 * self.most {
                let mut number = 0;
                self.rows.retain(|_| {
                    number += 1;
                    number % 2 == 1
                });
                self.every *= 2;
            }
            self.look(model, history, row, time);
        }
    }

    /// Notes the states that differ from those of the row before at the same time: an event has changed them.
    fn look(&mut self, model: &Model, history: &History, row: usize, time: f64) {
        let mut state = vec![0.0; history.states()];
        history.state(row, &mut state);
        for (scale, value) in self.scales.iter_mut().zip(&state) {
            *scale = scale.max(value.abs());
        }
        let (before, old) = &self.before;
        if *before == time {
            let mut changes = Map::new();
            for (index, name) in &self.states {
                // An event at a row leaves rows that differ by rounding, too.
                if (old[*index] - state[*index]).abs() <= ROUNDING * self.scales[*index] {
                    continue;
                }
                let unit = &model.states[*index].unit;
                let [old, new] = [old, &state].map(|state| unit.from_si(state[*index]));
                changes.insert(name.clone(), json!([old, new]));
            }
            if !changes.is_empty() {
                self.event_count += 1;
                if self.events.len() < EVENTS {
                    self.events.push(json!({ "at": time, "changes": changes }));
                }
            }
        }
        self.before = (time, state);
    }

    /// The summary as data.
    pub fn data(mut self) -> Value {
        let distance = self.rows.len().div_ceil(self.most).max(1);
        let last_is_kept = self.count.saturating_sub(1).is_multiple_of(self.every * distance);
        let mut rows: Vec<Vec<Value>> = self.rows.into_iter().step_by(distance).collect();
        if !last_is_kept && !self.last.is_empty() {
            rows.push(std::mem::take(&mut self.last));
        }
        let columns: Vec<Value> = self.table.columns().iter().zip(&self.statistics).map(column).collect();
        let mut data =
            json!({ "columns": columns, "rows": rows, "rows_of_the_run": self.count, "events": self.events });
        if self.event_count > self.events.len() {
            data["events_in_all"] = self.event_count.into();
        }
        data
    }
}

impl Statistics {
    fn take(&mut self, number: f64, time: f64) {
        if !number.is_finite() {
            return;
        }
        if self.count == 0 {
            (self.first, self.least, self.greatest) = (number, (number, time), (number, time));
        }
        self.count += 1;
        self.sum += number;
        self.last = number;
        if number < self.least.0 {
            self.least = (number, time);
        }
        if number > self.greatest.0 {
            self.greatest = (number, time);
        }
    }
}

/// A column with its statistics; a mean is one of rows.
fn column((column, statistics): (&Column, &Statistics)) -> Value {
    let mut data = json!({ "name": column.name, "unit": column.unit.text });
    if let Some(label) = &column.label {
        data["label"] = label.as_str().into();
    }
    let Statistics { count, sum, first, last, least, greatest } = statistics;
    if *count > 0 {
        data["first"] = (*first).into();
        data["last"] = (*last).into();
        data["least"] = json!({ "value": least.0, "at": least.1 });
        data["greatest"] = json!({ "value": greatest.0, "at": greatest.1 });
        data["mean_of_rows"] = (sum / *count as f64).into();
    }
    data
}

fn value(cell: &Cell) -> Value {
    match cell {
        Cell::Number(number) => (*number).into(),
        Cell::Truth(truth) => (*truth).into(),
        Cell::Text(text) => text.as_ref().into(),
    }
}
