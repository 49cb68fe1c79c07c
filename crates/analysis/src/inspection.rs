//! Inspection of a table: sampling, and columns computed from others.

use crate::cycles;
use crate::finding::Finding;
use crate::repeats::repeats;
use crate::sampling::{self, Examination, Sampling};
use crate::stencil::{self, Recognised};
use crate::table::Table;
use units::{Dimension, Unit};

/// Result of the inspection of a table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inspection {
    /// Notes for the user.
    pub findings: Vec<Finding>,
    /// Columns that were computed from others.
    pub derived: Vec<Derived>,
}

/// Column computed from another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derived {
    /// Index of the column.
    pub column: usize,
    /// Index of the column from which it was computed.
    pub of: usize,
    /// Recognised formula.
    pub recognised: Recognised,
    /// Factor by which it is too small at the frequency of the record; `None` without an oscillation.
    pub attenuation: Option<f64>,
}

/// Examines the sampling of every independent variable, and finds columns that are finite differences of others.
pub fn inspect(table: &Table) -> Inspection {
    let mut inspector = Inspector::new(table);
    while !inspector.advance(table) {}
    inspector.finish()
}

/// Inspection in slices.
#[derive(Clone, Debug)]
pub struct Inspector {
    observed: Vec<usize>,
    /// Remaining independent variables, the next one last.
    left: Vec<usize>,
    /// Times under examination, SI, with its state.
    present: Option<(Vec<f64>, Examination)>,
    inspection: Inspection,
}

impl Inspector {
    /// Begins the inspection of a table.
    pub fn new(table: &Table) -> Self {
        // Upper bound of the examined independent variables: a table with more is not from a film.
        const BODIES: usize = 100;
        let mut left: Vec<usize> = table.independent().take(BODIES).collect();
        left.reverse();
        let observed = table.observed_columns().collect();
        Self { observed, left, present: None, inspection: Inspection::default() }
    }

    /// Continues with the table given at the start. Returns true at the end.
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

    /// Columns that are compared with each other.
    fn columns_of(&self, table: &Table, independent: usize) -> Vec<usize> {
        // Upper bound of the compared columns: a table with more is not from a film.
        const COLUMNS: usize = 12;
        let of_it = |column: &usize| table.columns[*column].independent == independent;
        self.observed.iter().copied().filter(of_it).take(COLUMNS).collect()
    }

    /// Finds columns that were computed from others, and rows that repeat values.
    fn compare(&mut self, table: &Table, independent: usize, mut times: Vec<f64>, mut sampling: sampling::Sampling) {
        // Number of rows that suffices to recognise a formula or a pattern of repeats.
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
                // Of equals the first: the position comes before the velocity.
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
        let is_derived = |column: &usize| inspection.derived.iter().any(|derived| derived.column == *column);
        let measured: Vec<usize> = columns.iter().copied().filter(|column| !is_derived(column)).collect();
        let found = measured.iter().map(|column| (repeats(values(*column)), table.label(*column)));
        let mut found: Vec<(Vec<usize>, String)> = found.filter(|(rows, _)| !rows.is_empty()).collect();
        // One note for the columns that repeat the same rows.
        while let Some((rows, _)) = found.first().cloned() {
            let (same, others): (Vec<_>, Vec<_>) = found.into_iter().partition(|(other, _)| *other == rows);
            let columns = same.into_iter().map(|(_, label)| label).collect();
            inspection.findings.push(Finding::Repeated { columns, count: rows.len(), of: times.len() });
            found = others;
        }
    }

    /// Result of the inspection.
    pub fn finish(self) -> Inspection {
        self.inspection
    }
}

/// Findings on the times themselves: times that are missing or all equal, and times without a unit, each name once.
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

/// Text of the SI unit of an independent variable. Without a unit, whole numbers are counts and other numbers are seconds.
fn unit_of(unit: Option<&Unit>, times: &[f64]) -> &'static str {
    let counts = || times.iter().all(|time| time.is_nan() || time.fract() == 0.0);
    match unit {
        Some(unit) if unit.dimension == Dimension::TIME => "s",
        None if !counts() => "s",
        _ => "",
    }
}

impl Sampling {
    /// Notes for the user on the sampling; `unit` is written after a time, `s`.
    pub fn findings(&self, times: &[f64], unit: &'static str) -> Vec<Finding> {
        let mut findings = Vec::new();
        let time = |rows: &[usize]| rows.first().and_then(|row| times.get(*row)).copied().unwrap_or(f64::NAN);
        if !self.backwards.is_empty() {
            // In unsorted rows, distances show neither gaps nor the step of the clock.
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
