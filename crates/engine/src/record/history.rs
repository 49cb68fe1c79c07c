//! What a run has recorded: every step, in columns.

use crate::{AfterJump, Record};

/// The recorded rows of a run. A row is the independent variable, the states, the parameters in force and the segment; a
/// new segment begins where the state jumps, and there no line may be drawn and nothing interpolated.
#[derive(Clone, Debug, PartialEq)]
pub struct History {
    initial: Vec<f64>,
    times: Vec<f64>,
    columns: Vec<Vec<f64>>,
    segments: Vec<u32>,
    /// Parameter sets, each with the first row it holds for; ascending, and each another than the one before. The only
    /// record of what the parameters were: a set that waits for the next step has the number of the row to come.
    parameters: Vec<(usize, Vec<f64>)>,
    /// The rows right after jumps, each with what it does not tell by itself.
    after_jumps: Vec<(usize, AfterJump)>,
    /// For each state the rows at which its magnitude exceeded twice what it was before, with the magnitude.
    scales: Vec<Vec<(usize, f64)>>,
}

impl History {
    /// The history of a run that starts at 0 with the state `initial`.
    pub(crate) fn new(initial: Vec<f64>, parameters: Vec<f64>) -> Self {
        let columns = initial.iter().map(|&value| vec![value]).collect();
        let scales = initial.iter().map(|value| vec![(0, value.abs())]).collect();
        let parameters = vec![(0, parameters)];
        Self { initial, times: vec![0.0], columns, segments: vec![0], parameters, after_jumps: Vec::new(), scales }
    }

    /// How many rows there are; at least one.
    pub fn len(&self) -> usize {
        self.times.len()
    }

    /// Never: the start is a row.
    pub fn is_empty(&self) -> bool {
        self.times.is_empty()
    }

    /// The independent variable at a row, SI.
    pub fn time(&self, row: usize) -> f64 {
        self.times[row]
    }

    /// The independent variable at all rows; never decreasing, and equal only in two rows around a jump.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The values of state `state` at all rows, SI.
    pub fn column(&self, state: usize) -> &[f64] {
        &self.columns[state]
    }

    /// Copies the state at a row to `out`.
    pub fn state(&self, row: usize, out: &mut [f64]) {
        for (value, column) in out.iter_mut().zip(&self.columns) {
            *value = column[row];
        }
    }

    /// The number of states.
    pub fn states(&self) -> usize {
        self.columns.len()
    }

    /// Changes from one row to the next where the state jumps.
    pub fn segment(&self, row: usize) -> u32 {
        self.segments[row]
    }

    /// [`History::segment`] of all rows.
    pub fn segments(&self) -> &[u32] {
        &self.segments
    }

    /// The parameters in force at a row: those with which the step that led to it was made.
    pub fn parameters(&self, row: usize) -> &[f64] {
        let after = self.parameters.partition_point(|&(first, _)| first <= row);
        &self.parameters[after.saturating_sub(1)].1
    }

    /// The parameter sets, each with the first row it holds for: those at the start, and every change. The last one may
    /// hold for a row that is not recorded yet.
    pub fn parameter_sets(&self) -> &[(usize, Vec<f64>)] {
        &self.parameters
    }

    /// The parameters in force for the next step.
    pub(crate) fn next_parameters(&self) -> &[f64] {
        self.parameters.last().map_or(&[], |(_, set)| set)
    }

    /// The state at the start of the run, what `y(0)` is in an expression.
    pub fn initial(&self) -> &[f64] {
        &self.initial
    }

    /// The parameters that came into force exactly at a row.
    pub(crate) fn parameters_from(&self, row: usize) -> Option<&[f64]> {
        let place = self.parameters.binary_search_by_key(&row, |&(first, _)| first).ok()?;
        Some(&self.parameters[place].1)
    }

    /// What a row right after a jump does not tell by itself; for other rows there is nothing of the kind.
    pub(crate) fn after_jump(&self, row: usize) -> Option<&AfterJump> {
        let place = self.after_jumps.binary_search_by_key(&row, |&(after, _)| after).ok()?;
        Some(&self.after_jumps[place].1)
    }

    /// The greatest magnitude that a state had up to a row, to a factor of two. It does not depend on later rows.
    pub(crate) fn scale(&self, state: usize, row: usize) -> f64 {
        let scales = &self.scales[state];
        let after = scales.partition_point(|&(first, _)| first <= row);
        scales[after.saturating_sub(1)].1
    }

    /// The last row at or before `time`; the first row if there is none.
    pub fn row_at(&self, time: f64) -> usize {
        self.times.partition_point(|&at| at <= time).saturating_sub(1)
    }

    /// The memory that the rows take.
    pub fn bytes(&self) -> usize {
        let row = size_of::<f64>() * (1 + self.columns.len()) + size_of::<u32>();
        let sets: usize = self.parameters.iter().map(|(_, set)| size_of_val(set.as_slice()) + 32).sum();
        let jumps: usize = self.after_jumps.iter().map(|(_, after)| after.armed.len() + 40).sum();
        row * self.times.len() + sets + jumps
    }

    /// A hash of all bits of all rows (FNV-1a, 64 bits), to compare runs on different machines.
    pub fn fingerprint(&self) -> u64 {
        let mut hash = 0xcbf2_9ce4_8422_2325_u64;
        let mut take = |bits: u64| {
            for byte in bits.to_le_bytes() {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
            }
        };
        for row in 0..self.len() {
            take(self.times[row].to_bits());
            for column in &self.columns {
                take(column[row].to_bits());
            }
            take(u64::from(self.segments[row]));
        }
        hash
    }

    /// Parameters for the rows pushed from now on; other ones than those of the last row.
    pub(crate) fn push_parameters(&mut self, parameters: Vec<f64>) {
        let first = self.len();
        self.parameters.retain(|&(from, _)| from < first);
        self.parameters.push((first, parameters));
    }

    /// Drops the rows after `row`.
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

    /// Drops all rows but the last.
    pub(crate) fn forget(&mut self) {
        let dropped = self.len() - 1;
        let parameters = self.parameters(dropped).to_vec();
        // A set that waits for the next row still waits.
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
