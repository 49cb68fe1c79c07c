//! Sections: a point of the run at each multiple of a period, as Poincaré's section of a driven motion has it.

use super::traces::PlotColumns;
use crate::time::course::Course;
use engine::Readings;
use program::{Every, Model, NodeId, Plot};
use units::Unit;

/// No section has more points: a person sees no more, and a period of nothing has no end.
const MOST: usize = 50_000;

/// The points of one plot.
#[derive(Debug)]
pub(crate) struct Section {
    every: Every,
    /// The period, then abscissa and ordinate of each curve.
    readings: Readings,
    /// The units of what is read after the period.
    units: Vec<Unit>,
    /// So many rows of the run have been gone through.
    rows: usize,
    /// Before which row each point lies.
    places: Vec<usize>,
    /// Abscissas and ordinates of each curve.
    columns: Vec<Vec<f64>>,
    state: Vec<f64>,
}

impl Section {
    /// Of a plot with these columns.
    pub fn new(model: &Model, plot: &Plot, every: &Every, columns: &PlotColumns) -> Self {
        let mut nodes: Vec<NodeId> = vec![every.period];
        let mut units = Vec::new();
        for (number, (curve, place)) in plot.curves.iter().zip(&columns.curves).enumerate() {
            nodes.extend([plot.x_of(number).value.node, curve.value.node]);
            let axis = columns.axes.get(place.axis).unwrap_or(&curve.value.unit);
            units.extend([plot.x.value.unit.clone(), axis.clone()]);
        }
        Self {
            every: every.clone(),
            readings: Readings::new(model, &nodes),
            columns: vec![Vec::new(); units.len()],
            units,
            rows: 0,
            places: Vec::new(),
            state: vec![0.0; model.states.len()],
        }
    }

    /// Abscissas and ordinates of a curve.
    pub fn curve(&self, number: usize) -> (&[f64], &[f64]) {
        let column = |place: usize| self.columns.get(place).map_or(&[][..], Vec::as_slice);
        (column(2 * number), column(2 * number + 1))
    }

    /// Forgets the points that lie in rows from `rows` on.
    pub fn truncate(&mut self, rows: usize) {
        self.rows = self.rows.min(rows);
        let kept = self.places.partition_point(|place| *place < rows);
        self.places.truncate(kept);
        self.columns.iter_mut().for_each(|column| column.truncate(kept));
    }

    /// Brings the points up to the front of the run.
    pub fn follow(&mut self, course: &mut Course) {
        let rows = course.rows();
        self.truncate(rows);
        for row in self.rows.max(1)..rows {
            let Some(history) = course.history() else { return };
            let (start, end) = (history.time(row - 1), history.time(row));
            let parameters = history.parameters(row).to_vec();
            let initial = history.initial().to_vec();
            let period = self.readings.at(&parameters, &initial, 0.0, &initial).first().copied().unwrap_or(f64::NAN);
            if !(period > 0.0 && period.is_finite()) || self.places.len() >= MOST {
                continue;
            }
            // Multiples, not sums: the moments do not drift away from the drive.
            let first = self.every.from.unwrap_or(period);
            let mut number = ((start - first) / period).floor().max(0.0);
            while self.places.len() < MOST {
                let time = first + number * period;
                if time > end {
                    break;
                }
                let at_start = row == 1 && time == start;
                if time > start || at_start {
                    course.interpolate(time, &mut self.state);
                    let values = self.readings.at(&parameters, &initial, time, &self.state);
                    for ((column, value), unit) in self.columns.iter_mut().zip(values.iter().skip(1)).zip(&self.units) {
                        column.push(unit.from_si(*value));
                    }
                    self.places.push(row);
                }
                number += 1.0;
            }
        }
        self.rows = rows;
    }
}
