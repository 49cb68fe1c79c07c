//! Everything that a table hides, looked for at once.

use crate::cycles;
use crate::finding::Finding;
use crate::sampling::{self, Examination, Sampling};
use crate::stencil::{self, Recognised};
use crate::table::Table;
use units::{Dimension, Unit};

/// What was found out about a table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inspection {
    /// What a person should know.
    pub findings: Vec<Finding>,
    /// Columns that were computed from others.
    pub derived: Vec<Derived>,
}

/// A column that was computed from another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derived {
    /// The column.
    pub column: usize,
    /// What it was computed from.
    pub of: usize,
    /// How that was recognised.
    pub recognised: Recognised,
    /// The factor by which it is too small at the frequency of the record, if there is an oscillation.
    pub attenuation: Option<f64>,
}

/// Looks at the sampling of every independent variable, and for columns that are finite differences of others.
pub fn inspect(table: &Table) -> Inspection {
    let mut inspector = Inspector::new(table);
    while !inspector.advance(table) {}
    inspector.finish()
}

/// The same in slices.
#[derive(Clone, Debug)]
pub struct Inspector {
    observed: Vec<usize>,
    /// The independent variables that are left, the next one last.
    left: Vec<usize>,
    /// The times that are looked at, SI, and how far that has come.
    present: Option<(Vec<f64>, Examination)>,
    inspection: Inspection,
}

impl Inspector {
    /// Begins to look at a table.
    pub fn new(table: &Table) -> Self {
        // A table of more bodies is no film.
        const BODIES: usize = 100;
        let mut left: Vec<usize> = table.independent().take(BODIES).collect();
        left.reverse();
        let observed = table.observed_columns().collect();
        Self { observed, left, present: None, inspection: Inspection::default() }
    }

    /// Goes on with the table that it began with. Whether it has come to the end.
    pub fn advance(&mut self, table: &Table) -> bool {
        let Some(independent) = self.left.last().copied() else { return true };
        let column = &table.columns[independent];
        let Some((times, examination)) = &mut self.present else {
            if self.columns_of(table, independent).is_empty() {
                self.left.pop();
            } else {
                self.present = Some((column.si(None), Examination::default()));
            }
            return self.left.is_empty();
        };
        if !examination.advance(times) {
            return false;
        }
        if let Some((times, examination)) = self.present.take() {
            let found = examination.sampling.findings(&times, unit_of(column.unit.as_ref(), &times));
            self.inspection.findings.extend(found);
            self.compare(table, independent, times, examination.sampling);
        }
        self.left.pop();
        self.left.is_empty()
    }

    /// The columns that are compared with each other.
    fn columns_of(&self, table: &Table, independent: usize) -> Vec<usize> {
        // A table of more columns is no film.
        const COLUMNS: usize = 12;
        let of_it = |column: &usize| table.columns[*column].independent == independent;
        self.observed.iter().copied().filter(of_it).take(COLUMNS).collect()
    }

    /// Looks for columns that were computed from others.
    fn compare(&mut self, table: &Table, independent: usize, mut times: Vec<f64>, mut sampling: sampling::Sampling) {
        // So many rows tell how a column was computed.
        const ROWS: usize = 5000;
        let columns = self.columns_of(table, independent);
        let inspection = &mut self.inspection;
        if times.len() > ROWS {
            times.truncate(ROWS);
            sampling = sampling::examine(&times);
        }
        let values = |column: usize| table.columns[column].values.get(..times.len()).unwrap_or_default();
        for &candidate in &columns {
            let recognise = |of: usize| stencil::recognise_on(&sampling, values(of), values(candidate));
            let best = columns
                .iter()
                .filter(|of| **of != candidate)
                .filter_map(|of| Some((*of, recognise(*of)?)))
                // The first of equals: the position comes before the velocity.
                .rev()
                .max_by(|one, other| one.1.share.total_cmp(&other.1.share));
            let Some((of, recognised)) = best else { continue };
            let estimate = cycles::estimate(&times, values(of));
            let attenuation = estimate.map(|e| recognised.stencil.attenuation(e.angular_frequency * sampling.interval));
            inspection.derived.push(Derived { column: candidate, of, recognised, attenuation });
            inspection.findings.push(Finding::Derived {
                column: table.label(candidate),
                of: table.label(of),
                stencil: recognised.stencil,
                attenuation,
            });
        }
    }

    /// What was found.
    pub fn finish(self) -> Inspection {
        self.inspection
    }
}

/// What is doubtful about the times themselves: those of no use, and those for which no unit is stated, each name once.
pub fn doubtful_times(table: &Table) -> Vec<Finding> {
    let mut names: Vec<&str> = Vec::new();
    let mut findings = Vec::new();
    for index in table.independent() {
        let column = &table.columns[index];
        let mut measured =
            table.observed_columns().filter(|other| table.columns[*other].independent == index).peekable();
        if measured.peek().is_none() || names.contains(&column.name.as_str()) {
            continue;
        }
        let label = if column.name.is_empty() { table.label(index) } else { column.name.clone() };
        if !measured.any(|other| table.has_times(other)) {
            findings.push(Finding::NoTimes(label));
        } else if column.unit.is_none() && column.origin.unit.unknown().is_none() {
            findings.push(Finding::AssumedSeconds(label));
        } else {
            continue;
        }
        names.push(&column.name);
    }
    findings
}

/// What stands behind a reading of the independent variable in SI. Without a unit it is in seconds, unless it counts.
fn unit_of(unit: Option<&Unit>, times: &[f64]) -> &'static str {
    let counts = || times.iter().all(|time| time.is_nan() || time.fract() == 0.0);
    match unit {
        Some(unit) if unit.dimension == Dimension::TIME => "s",
        None if !counts() => "s",
        _ => "",
    }
}

impl Sampling {
    /// What a person should know about it; `unit` stands behind a time, `s`.
    pub fn findings(&self, times: &[f64], unit: &'static str) -> Vec<Finding> {
        let mut findings = Vec::new();
        let time = |rows: &[usize]| rows.first().and_then(|row| times.get(*row)).copied().unwrap_or(f64::NAN);
        if !self.backwards.is_empty() {
            // Distances of rows that are not in the order of time say nothing of gaps or of the clock.
            return vec![Finding::Backwards { time: time(&self.backwards), unit, count: self.backwards.len() }];
        }
        if !self.missing.is_empty() {
            findings.push(Finding::Missing { gaps: self.missing.clone(), unit });
        }
        if !self.doubled.is_empty() {
            findings.push(Finding::Doubled { time: time(&self.doubled), unit, count: self.doubled.len() });
        }
        match (self.rounded_to, self.rate) {
            (Some(to), _) => findings.push(Finding::RoundedTimes { to, unit }),
            (None, Some(rate)) if unit == "s" => findings.push(Finding::RoundedStep { interval: self.interval, rate }),
            (None, _) if self.jitter > 1e-3 => findings.push(Finding::Uneven(self.jitter)),
            (None, _) => {}
        }
        findings
    }
}
