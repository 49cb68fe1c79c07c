//! Recorded rows of a run, in columns.

use crate::{AfterJump, Record};
use units::fnv;

/// The recorded rows of a run. A row has the independent variable, the states, the parameters in force and the segment. A
/// new segment begins at each jump of the state; no line and no interpolation may cross it.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    initial: Vec<f64>,
    times: Vec<f64>,
    columns: Vec<Vec<f64>>,
    segments: Vec<u32>,
    /// Parameter sets, each with the first row for which it holds; ascending, each different from the one before. A set for
    /// the next step has the index of the row to come.
    parameters: Vec<(usize, Vec<f64>)>,
    /// Additional data of the rows right after jumps, by row index.
    after_jumps: Vec<(usize, AfterJump)>,
    /// Running maximum of the magnitude of each state: the rows at which it more than doubled, with the magnitude.
    scales: Vec<Vec<(usize, f64)>>,
}

impl History {
    /// History of a run that starts at 0 with the state `initial` and these parameters, SI units.
    pub(crate) fn new(initial: Vec<f64>, parameters: Vec<f64>) -> Self {
        let columns = initial.iter().map(|&value| vec![value]).collect();
        let scales = initial.iter().map(|value| vec![(0, value.abs())]).collect();
        let parameters = vec![(0, parameters)];
        Self { initial, times: vec![0.0], columns, segments: vec![0], parameters, after_jumps: Vec::new(), scales }
    }

    /// Number of rows, at least one.
    pub fn len(&self) -> usize {
        self.times.len()
    }

    /// Always false: the start is a row.
    pub fn is_empty(&self) -> bool {
        self.times.is_empty()
    }

    /// The independent variable at a row, SI units.
    pub fn time(&self, row: usize) -> f64 {
        self.times[row]
    }

    /// The independent variable at all rows, SI units; never decreasing, and equal only in rows around a jump.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The values of state `state` at all rows, SI units.
    pub fn column(&self, state: usize) -> &[f64] {
        &self.columns[state]
    }

    /// Copies the state at a row to `out`: one value per state, SI units.
    pub fn state(&self, row: usize, out: &mut [f64]) {
        for (value, column) in out.iter_mut().zip(&self.columns) {
            *value = column[row];
        }
    }

    /// The number of states.
    pub fn states(&self) -> usize {
        self.columns.len()
    }

    /// Segment of a row; the number increases where the state jumps.
    pub fn segment(&self, row: usize) -> u32 {
        self.segments[row]
    }

    /// The segments of all rows.
    pub fn segments(&self) -> &[u32] {
        &self.segments
    }

    /// The parameters of the step that led to a row: one value per parameter, SI units.
    pub fn parameters(&self, row: usize) -> &[f64] {
        let after = self.parameters.partition_point(|&(first, _)| first <= row);
        &self.parameters[after.saturating_sub(1)].1
    }

    /// All parameter sets, each with the first row for which it holds: the set at the start, then every change. The last
    /// set may be for a row not recorded yet.
    pub fn parameter_sets(&self) -> &[(usize, Vec<f64>)] {
        &self.parameters
    }

    /// The parameters for the next step: one value per parameter, SI units.
    pub(crate) fn next_parameters(&self) -> &[f64] {
        self.parameters.last().map_or(&[], |(_, set)| set)
    }

    /// The state at the start of the run, `y(0)` in expressions: one value per state, SI units.
    pub fn initial(&self) -> &[f64] {
        &self.initial
    }

    /// The parameters that changed at exactly this row, if any.
    pub(crate) fn parameters_from(&self, row: usize) -> Option<&[f64]> {
        let place = self.parameters.binary_search_by_key(&row, |&(first, _)| first).ok()?;
        Some(&self.parameters[place].1)
    }

    /// Additional data of a row right after a jump; `None` for other rows.
    pub(crate) fn after_jump(&self, row: usize) -> Option<&AfterJump> {
        let place = self.after_jumps.binary_search_by_key(&row, |&(after, _)| after).ok()?;
        Some(&self.after_jumps[place].1)
    }

    /// Greatest magnitude of a state up to a row, within a factor of two; SI units. It does not depend on later rows.
    pub(crate) fn scale(&self, state: usize, row: usize) -> f64 {
        let scales = &self.scales[state];
        let after = scales.partition_point(|&(first, _)| first <= row);
        scales[after.saturating_sub(1)].1
    }

    /// Index of the last row at or before `time`; 0 if there is none.
    pub fn row_at(&self, time: f64) -> usize {
        self.times.partition_point(|&at| at <= time).saturating_sub(1)
    }

    /// Memory of the rows, in bytes.
    pub fn bytes(&self) -> usize {
        let row = size_of::<f64>() * (1 + self.columns.len()) + size_of::<u32>();
        let sets: usize = self.parameters.iter().map(|(_, set)| size_of_val(set.as_slice()) + 32).sum();
        let jumps: usize = self.after_jumps.iter().map(|(_, after)| after.armed.len() + 40).sum();
        row * self.times.len() + sets + jumps
    }

    /// Hash of all bits of all rows (FNV-1a, 64 bits), to compare runs on different machines.
    pub fn fingerprint(&self) -> u64 {
        let mut hash = fnv::START;
        let mut take = |bits: u64| hash = fnv::hashed(hash, bits.to_le_bytes());
        for row in 0..self.len() {
            take(self.times[row].to_bits());
            for column in &self.columns {
                take(column[row].to_bits());
            }
            take(u64::from(self.segments[row]));
        }
        hash
    }

    /// Sets the parameters for the rows pushed from now on; they must differ from those of the last row.
    pub(crate) fn push_parameters(&mut self, parameters: Vec<f64>) {
        let first = self.len();
        self.parameters.retain(|&(from, _)| from < first);
        self.parameters.push((first, parameters));
    }

    /// Drops the rows after `row`, and the parameter sets for them.
    pub(crate) fn truncate(&mut self, row: usize) {
        let rows = row + 1;
        self.times.truncate(rows);
        self.segments.truncate(rows);
        for column in &mut self.columns {
            column.truncate(rows);
        }
        self.parameters.retain(|&(first, _)| first <= row);
        self.after_jumps.retain(|&(after, _)| after <= row);
        self.scales.iter_mut().for_each(|scales| scales.retain(|&(first, _)| first <= row));
    }

    /// Drops all rows but the last one, which becomes row 0.
    pub(crate) fn forget(&mut self) {
        let dropped = self.len() - 1;
        let parameters = self.parameters(dropped).to_vec();
        // A set for the next row is kept.
        self.parameters.retain(|&(first, _)| first > dropped);
        for (first, _) in &mut self.parameters {
            *first -= dropped;
        }
        self.parameters.insert(0, (0, parameters));
        self.after_jumps.retain(|&(after, _)| after == dropped);
        self.after_jumps.iter_mut().for_each(|(after, _)| *after = 0);
        for scales in &mut self.scales {
            *scales = scales.last().map(|&(_, scale)| (0, scale)).into_iter().collect();
        }
        self.times.drain(..dropped);
        self.segments.drain(..dropped);
        for column in &mut self.columns {
            column.drain(..dropped);
        }
    }
}

impl Record for History {
    fn row(&mut self, time: f64, state: &[f64], jumped: bool) {
        let segment = self.segments.last().copied().unwrap_or_default() + u32::from(jumped);
        let row = self.times.len();
        self.times.push(time);
        for ((column, scales), &value) in self.columns.iter_mut().zip(&mut self.scales).zip(state) {
            column.push(value);
            if scales.last().is_none_or(|&(_, scale)| value.abs() > 2.0 * scale) {
                scales.push((row, value.abs()));
            }
        }
        self.segments.push(segment);
    }

    fn after_jump(&mut self, after: AfterJump) {
        self.after_jumps.push((self.times.len() - 1, after));
    }
}
