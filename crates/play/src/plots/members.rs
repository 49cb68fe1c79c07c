//! Values of family members at the moment shown, and the intervals that they have covered in the run so far.

use super::traces::PlotColumns;
use crate::time::course::Course;
use engine::Readings;
use figure::Interval;
use program::{Members, Model, NodeId, Plot};
use units::Unit;

/// Columns of values evaluated at one moment.
#[derive(Debug)]
pub(crate) struct Snapshot {
    readings: Readings,
    columns: Vec<Column>,
    /// Number of rows of the run processed so far.
    rows: usize,
    /// For each axis, the interval covered so far; each entry applies from its row on. Axes grow with the run and do
    /// not follow every moment, to avoid jitter.
    ends: Vec<(usize, Vec<Interval>)>,
}

/// One column of values.
#[derive(Debug)]
struct Column {
    unit: Unit,
    /// Index of the axis: 0 is the horizontal one, followed by the vertical ones.
    axis: usize,
    values: Vec<f64>,
}

/// Empty interval.
const NOTHING: Interval = Interval { low: f64::INFINITY, high: f64::NEG_INFINITY };

impl Snapshot {
    /// Snapshot of the curves of a plot: a column of abscissas and one of ordinates for each.
    pub fn of_curves(model: &Model, plot: &Plot, members: &[Members], columns: &PlotColumns) -> Self {
        let mut all = Vec::new();
        for (members, curve) in members.iter().zip(&columns.curves) {
            all.push((&members.x[..], plot.x.value.unit.clone(), 0));
            let unit = columns.axes.get(curve.axis).unwrap_or(&plot.x.value.unit);
            all.push((&members.y[..], unit.clone(), 1 + curve.axis));
        }
        Self::new(model, all)
    }

    /// Snapshot of a single column of values.
    pub fn of_values(model: &Model, nodes: &[NodeId], unit: &Unit) -> Self {
        Self::new(model, vec![(nodes, unit.clone(), 0)])
    }

    fn new(model: &Model, columns: Vec<(&[NodeId], Unit, usize)>) -> Self {
        let nodes: Vec<NodeId> = columns.iter().flat_map(|(nodes, ..)| nodes.iter().copied()).collect();
        let column =
            |(nodes, unit, axis): (&[NodeId], Unit, usize)| Column { unit, axis, values: vec![f64::NAN; nodes.len()] };
        let columns = columns.into_iter().map(column).collect();
        Self { readings: Readings::new(model, &nodes), columns, rows: 0, ends: Vec::new() }
    }

    /// Values of one column, in its unit.
    pub fn column(&self, number: usize) -> &[f64] {
        self.columns.get(number).map_or(&[][..], |column| &column.values)
    }

    /// Interval that an axis has covered in the run so far, in its unit; axis 0 is the horizontal one. `None` if it is
    /// empty.
    pub fn reached(&self, axis: usize) -> Option<Interval> {
        self.ends.last()?.1.get(axis).copied().filter(|ends| ends.low <= ends.high)
    }

    /// Discards the intervals covered by the run.
    pub fn forget(&mut self) {
        self.rows = 0;
    }

    /// Evaluates the moment shown, and extends the intervals by the new rows.
    pub fn follow(&mut self, course: &Course) {
        let rows = course.rows();
        if rows < 2 {
            // The start changes with the parameters.
            self.rows = 0;
        }
        self.rows = self.rows.min(rows);
        let kept = self.ends.partition_point(|(row, _)| *row < self.rows);
        self.ends.truncate(kept);
        if let Some(history) = course.history() {
            for row in self.rows..rows {
                let values = self.readings.at_row(history, row);
                Self::read(&mut self.columns, values);
                self.widen(row);
            }
        }
        self.rows = rows;
        let values = self.readings.at(course.parameters(), course.initial(), course.time(), course.state());
        Self::read(&mut self.columns, values);
    }

    fn read(columns: &mut [Column], mut values: &[f64]) {
        for column in columns {
            let (own, rest) = values.split_at(column.values.len().min(values.len()));
            for (cell, value) in column.values.iter_mut().zip(own) {
                *cell = column.unit.from_si(*value);
            }
            values = rest;
        }
    }

    /// Extends the intervals by the values evaluated at a row.
    fn widen(&mut self, row: usize) {
        let axes = self.columns.iter().map(|column| column.axis + 1).max().unwrap_or(0);
        let before = self.ends.last().map(|(_, ends)| &ends[..]);
        let outside = |column: &Column| {
            let ends = before.and_then(|ends| ends.get(column.axis)).copied().unwrap_or(NOTHING);
            column.values.iter().any(|value| value.is_finite() && !ends.contains(*value))
        };
        if !self.columns.iter().any(outside) {
            return;
        }
        let mut ends = before.map_or_else(|| vec![NOTHING; axes], <[Interval]>::to_vec);
        for column in &self.columns {
            let Some(ends) = ends.get_mut(column.axis) else { continue };
            for value in column.values.iter().copied().filter(|value| value.is_finite()) {
                *ends = Interval { low: ends.low.min(value), high: ends.high.max(value) };
            }
        }
        self.ends.push((row, ends));
    }
}
