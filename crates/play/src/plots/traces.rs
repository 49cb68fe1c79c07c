//! Columns of numbers for the plots: every plotted expression at every row, in the unit of its axis. Rows are appended
//! as the run grows and never recomputed.

use crate::time::course::Course;
use engine::{History, Readings};
use program::Plot;
use program::{Model, NodeId};
use serde::{Deserialize, Serialize};
use units::Unit;

/// Layout of the columns, and the column indices of each plot.
#[derive(Clone, Debug)]
pub(crate) struct Columns {
    readings: Readings,
    nodes: Vec<NodeId>,
    units: Vec<Unit>,
    plots: Vec<PlotColumns>,
}

/// Column indices of one plot.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PlotColumns {
    /// Column of the abscissa of the first curve.
    pub x: usize,
    /// Index of its first curve among the curves of all plots.
    pub first: usize,
    /// Column indices of its curves.
    pub curves: Vec<CurveColumns>,
    /// Unit of each axis: that of its first curve.
    pub axes: Vec<Unit>,
}

impl PlotColumns {
    /// Unit of each curve.
    pub fn units(&self) -> Vec<Unit> {
        self.curves.iter().filter_map(|curve| self.axes.get(curve.axis).cloned()).collect()
    }
}

/// Column indices of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CurveColumns {
    /// Column of the abscissas.
    pub x: usize,
    /// Column of the ordinates.
    pub y: usize,
    /// Index of its vertical axis.
    pub axis: usize,
}

impl Columns {
    /// Columns required by the plots; equal columns are shared.
    pub fn new(model: &Model, plots: &[Plot]) -> Self {
        let mut columns =
            Self { readings: Readings::new(model, &[]), nodes: Vec::new(), units: Vec::new(), plots: Vec::new() };
        for plot in plots {
            let x = columns.add(plot.x.value.node, &plot.x.value.unit);
            let mut axes: Vec<Unit> = Vec::new();
            let mut curves = Vec::new();
            for (number, curve) in plot.curves.iter().enumerate() {
                let unit = &curve.value.unit;
                let axis = axes.iter().position(|axis| axis.dimension == unit.dimension).unwrap_or_else(|| {
                    axes.push(unit.clone());
                    axes.len() - 1
                });
                // All curves share the horizontal axis and thus the unit of the first one.
                let x = columns.add(plot.x_of(number).value.node, &plot.x.value.unit);
                curves.push(CurveColumns { x, y: columns.add(curve.value.node, &axes[axis]), axis });
            }
            let first = columns.plots.iter().map(|plot| plot.curves.len()).sum();
            columns.plots.push(PlotColumns { x, first, curves, axes });
        }
        columns.readings = Readings::new(model, &columns.nodes);
        columns
    }

    fn add(&mut self, node: NodeId, unit: &Unit) -> usize {
        let known = self.nodes.iter().zip(&self.units).position(|(one, of)| *one == node && of == unit);
        known.unwrap_or_else(|| {
            self.nodes.push(node);
            self.units.push(unit.clone());
            self.nodes.len() - 1
        })
    }

    /// Column indices of plot `index`.
    pub fn plot(&self, index: usize) -> Option<&PlotColumns> {
        self.plots.get(index)
    }

    /// Expression of each column.
    pub fn nodes(&self) -> &[NodeId] {
        &self.nodes
    }

    /// True if both layouts have the same columns, units and indices.
    pub fn is_arranged_like(&self, other: &Self) -> bool {
        self.units == other.units && self.plots == other.plots
    }

    /// Memory per row in [`Traces`], in bytes.
    pub fn bytes_per_row(&self) -> usize {
        self.nodes.len() * size_of::<f64>()
    }

    /// Values of all columns at the moment shown by `course`, in the units of the columns.
    pub fn present(&mut self, course: &Course, out: &mut Vec<f64>) {
        let values = self.readings.at(course.parameters(), course.initial(), course.time(), course.state());
        out.clear();
        out.extend(values.iter().zip(&self.units).map(|(&value, unit)| unit.from_si(value)));
    }

    /// For each column, true if its value at a row would change with other parameters.
    fn jumping(&mut self, history: &History, row: usize, parameters: &[f64], columns: &[Vec<f64>]) -> Vec<bool> {
        let mut state = vec![0.0; history.states()];
        history.state(row, &mut state);
        let values = self.readings.at(parameters, history.initial(), history.time(row), &state);
        let columns = columns.iter().zip(values).zip(&self.units);
        columns.map(|((column, &value), unit)| column[row].to_bits() != unit.from_si(value).to_bits()).collect()
    }

    fn row(&mut self, history: &History, row: usize, columns: &mut [Vec<f64>]) {
        let values = self.readings.at_row(history, row);
        for ((column, &value), unit) in columns.iter_mut().zip(values).zip(&self.units) {
            column.push(unit.from_si(value));
        }
    }
}

/// The columns of one run.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Traces {
    columns: Vec<Vec<f64>>,
    /// For each curve of all plots, the rows before which its line is interrupted.
    breaks: Vec<Vec<usize>>,
    /// Number of recorded rows. The columns may have one more value, the tip.
    rows: usize,
}

impl Traces {
    /// Appends the rows up to the front of `course`. If the front is shown, the columns end with its values
    /// (`present`).
    pub fn follow(&mut self, course: &Course, columns: &mut Columns, present: &[f64]) {
        let Some(history) = course.history() else {
            *self = Self::default();
            return;
        };
        let rows = course.rows();
        if course.is_scrubbed() && rows == self.rows {
            return;
        }
        self.columns.resize(columns.nodes.len(), Vec::new());
        self.breaks.resize(columns.plots.iter().map(|plot| plot.curves.len()).sum(), Vec::new());
        self.truncate(rows);
        for row in self.rows..rows {
            if row > 0 && history.segment(row) != history.segment(row - 1) {
                self.breaks.iter_mut().for_each(|breaks| breaks.push(row));
            } else if row > 0 {
                self.interrupt(history, row, history.parameters(row), columns);
            }
            columns.row(history, row, &mut self.columns);
        }
        self.rows = rows;
        if !course.is_scrubbed() {
            if rows > 0 {
                self.interrupt(history, rows, course.parameters(), columns);
            }
            for (column, &value) in self.columns.iter_mut().zip(present) {
                column.push(value);
            }
        }
    }

    /// Interrupts, before `row`, the curves that jump due to a change of parameters there, such as an energy with the
    /// density.
    fn interrupt(&mut self, history: &History, row: usize, parameters: &[f64], columns: &mut Columns) {
        if history.parameters(row - 1) == parameters {
            return;
        }
        let jumping = columns.jumping(history, row - 1, parameters, &self.columns);
        let curves = columns.plots.iter().flat_map(|plot| &plot.curves);
        for (curve, breaks) in curves.zip(&mut self.breaks) {
            if jumping[curve.x] || jumping[curve.y] {
                breaks.push(row);
            }
        }
    }

    /// Keeps the first `rows` rows.
    pub fn truncate(&mut self, rows: usize) {
        self.rows = self.rows.min(rows);
        for column in &mut self.columns {
            column.truncate(self.rows);
        }
        for breaks in &mut self.breaks {
            breaks.retain(|&row| row < self.rows);
        }
    }

    /// Values of one column, in its unit; empty for an unknown index.
    pub fn column(&self, index: usize) -> &[f64] {
        self.columns.get(index).map_or(&[], Vec::as_slice)
    }

    /// Rows before which the line of a curve is interrupted; `curve` counts the curves of all plots.
    pub fn breaks(&self, curve: usize) -> &[usize] {
        self.breaks.get(curve).map_or(&[], Vec::as_slice)
    }

    /// Number of recorded rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Copy of the rows from index `first` on, evenly thinned to at most `most` rows.
    pub fn thinned(&self, first: usize, most: usize) -> Self {
        let length = self.columns.first().map_or(0, Vec::len);
        let stride = length.saturating_sub(first).div_ceil(most.max(1)).max(1);
        let rows: Vec<usize> = (first..length).step_by(stride).collect();
        let columns = self.columns.iter().map(|column| rows.iter().map(|&row| column[row]).collect()).collect();
        let thinned = |breaks: &Vec<usize>| {
            let places = breaks.iter().map(|&row| rows.partition_point(|&kept| kept < row));
            let mut places: Vec<usize> = places.filter(|&row| row > 0 && row < rows.len()).collect();
            places.dedup();
            places
        };
        let breaks = self.breaks.iter().map(thinned).collect();
        Self { columns, breaks, rows: rows.len() }
    }
}
