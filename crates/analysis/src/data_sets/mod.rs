//! Data sets exported together, as by phyphox: each becomes a record of its own, all on the common clock.

mod device;
mod events;
mod remark;

pub use remark::Remark;

use crate::finding::Finding;
use crate::import::Import;
use crate::table::{Column, Table};
use device::Device;
use events::Events;

/// Sheets of phyphox workbooks that describe the phone and the clock; its archives have files instead.
pub(crate) const DEVICE: &str = "Metadata Device";
pub(crate) const EVENTS: &str = "Metadata Time";
/// Upper bound of the cells of a joined table: a fixed number, plus a multiple of the cells of the sets. Sets of very
/// different lengths would need much memory for gaps.
const ALWAYS_ALLOWED: usize = 1 << 20;
const MOST_EXPANSION: usize = 10;

/// Data sets read so far.
#[derive(Debug, Default)]
pub(crate) struct DataSets {
    sets: Vec<(String, Import, String)>,
    device: Device,
    events: Events,
    remarks: Vec<Remark>,
}

impl DataSets {
    /// Stores a sheet that describes the others. Returns false for any other sheet.
    pub fn describe(&mut self, name: &str, text: &str) -> bool {
        match name {
            DEVICE => self.device = Device::read(text),
            EVENTS => self.events = Events::read(text),
            _ => return false,
        }
        true
    }

    /// Adds a set with the text from which it was read.
    pub fn add(&mut self, name: String, import: Import, text: String) {
        self.sets.push((name, import, text));
    }

    /// Records that a sheet was not a table.
    pub fn pass_over(&mut self, name: &str) {
        self.remarks.push(Remark::NoTable(name.to_owned()));
    }

    /// True if no set has been read.
    pub fn is_empty(&self) -> bool {
        self.sets.is_empty()
    }

    /// One table of all sets, each of which is a body, with the text if there is only one unchanged set. `None` without
    /// sets.
    pub fn join(mut self) -> Option<(Import, String)> {
        let mut findings: Vec<Finding> = Vec::new();
        let columns = self.sets.iter().map(|(_, import, _)| import.table.columns.len()).sum::<usize>();
        let cells: usize =
            self.sets.iter().map(|(_, import, _)| import.table.columns.len() * import.table.rows()).sum();
        let longest = self.sets.iter().map(|(_, import, _)| import.table.rows()).max()?;
        if columns.saturating_mul(longest) > ALWAYS_ALLOWED + MOST_EXPANSION * cells {
            let names = self.sets.drain(1..).map(|(name, ..)| name);
            self.remarks.extend(names.map(Remark::TooMany));
        }
        let names: Vec<String> = self.sets.iter().map(|(name, ..)| name.clone()).collect();
        let several = names.len() > 1;
        let mut moved = false;
        for (name, import, _) in &mut self.sets {
            moved |= self.events.spread(&mut import.table);
            findings.extend(self.device.sensor(name, &import.table).map(Finding::DataSets));
        }
        if several {
            self.remarks.insert(0, Remark::Several(names));
        }
        self.remarks.extend(self.device.remark());
        self.remarks.extend(self.events.remark(moved));
        let remarks = self.remarks.into_iter().map(Finding::DataSets);
        findings.splice(0..0, remarks);
        let mut sets = self.sets.into_iter();
        let (first, mut joined, mut text) = sets.next()?;
        if several || moved {
            // A single text no longer corresponds to the table.
            text.clear();
            let readings =
                joined_readings(std::iter::once(&joined.table).chain(sets.as_slice().iter().map(|set| &set.1.table)));
            name_columns(&mut joined.table, &first, 0, longest);
            for (name, mut import, _) in sets {
                name_columns(&mut import.table, &name, joined.table.columns.len(), longest);
                joined.table.columns.append(&mut import.table.columns);
                joined.findings.append(&mut import.findings);
            }
            joined.table.sets = true;
            joined.table.readings = readings;
            for (index, column) in joined.table.columns.iter_mut().enumerate() {
                column.origin.number = index + 1;
            }
        }
        joined.findings.splice(0..0, findings);
        Some((joined, text))
    }
}

/// Readings of all sets together: a set with fewer readings contributes its last one to the rest.
fn joined_readings<'a>(tables: impl Iterator<Item = &'a Table>) -> Vec<Vec<usize>> {
    let mut of_sets: Vec<Vec<Vec<usize>>> = Vec::new();
    let mut before = 0;
    for table in tables {
        let mut readings = table.readings.clone();
        if readings.is_empty() {
            readings.push(table.clocks().collect());
        }
        readings.iter_mut().flatten().for_each(|clock| *clock += before);
        of_sets.push(readings);
        before += table.columns.len();
    }
    let most = of_sets.iter().map(Vec::len).max().unwrap_or(0);
    let one =
        |place: usize| of_sets.iter().filter_map(|own| own.get(place).or(own.last())).flatten().copied().collect();
    if most > 1 { (0..most).map(one).collect() } else { Vec::new() }
}

/// Assigns the columns of a set to a body, after `before` columns of other sets, and extends them to `rows`.
fn name_columns(table: &mut Table, set: &str, before: usize, rows: usize) {
    for Column { body, independent, values, .. } in &mut table.columns {
        *body = Some(match body.take() {
            Some(run) => format!("{set} {run}"),
            None => set.to_owned(),
        });
        *independent += before;
        values.resize(rows, f64::NAN);
    }
}
