//! Conversion between records and stored items.

use saved::format::{self, Content};
use saved::{Item, Number};

use crate::records::recognise::Meaning;
use crate::records::record::{LONGEST_SAVED, Origin, Record, Use};
use crate::records::{Records, ShownRecords};
use crate::{Changes, OpenDocument};
use analysis::derivative::Differentiation;
use play::name_of;
use units::Unit;

impl ShownRecords<'_> {
    /// The records to store, each with a name that is the same at every visit and on every page. Records that are too
    /// long are left out.
    pub fn saved(self) -> Vec<(String, Item)> {
        let document = self.open.name();
        let item = |record| Item(Content::Record(saved(record, &document)));
        let names = self.records.names().into_iter();
        names.filter_map(|(id, name)| Some((name, item(self.records.get(id)?)))).collect()
    }
}

impl Records {
    /// Ids and storage names of the records that are stored. Names are hashes of the content, with a number added for
    /// equal records.
    pub(crate) fn names(&self) -> Vec<(u32, String)> {
        let mut names: Vec<(u32, String)> = Vec::new();
        for record in self.list.iter().filter(|record| self.is_lasting(record.id)) {
            let truth: Vec<String> =
                record.truth.iter().flatten().map(|(name, value)| format!("{name}={value:e}")).collect();
            let truth = truth.join(";");
            let own = line(&record.name);
            let mut again = 0;
            let mut name = name_of(&[&own, &truth, &record.text]);
            while names.iter().any(|(_, other)| *other == name) {
                again += 1;
                name = name_of(&[&own, &truth, &record.text, &again.to_string()]);
            }
            names.push((record.id, name));
        }
        names
    }

    /// True if a record is stored for the next visit, given the length of the records before it.
    pub(super) fn is_lasting(&self, id: u32) -> bool {
        let mut sum = 0;
        for record in &self.list {
            let fits = !record.text.is_empty() && sum + record.text.len() <= LONGEST_SAVED;
            if record.id == id {
                return fits;
            }
            sum += if fits { record.text.len() } else { 0 };
        }
        false
    }

    /// Restores a record and returns its name in the storage; `None` if it cannot be read or is too long to be stored.
    pub(crate) fn restore(&mut self, open: OpenDocument<'_>, saved: &format::Record) -> (Option<String>, Changes) {
        let truth = saved.truth.as_deref().map(read_values);
        let inserted = self.insert(open, &saved.name, saved.text.as_bytes(), truth);
        let Ok((id, mut changes)) = inserted else { return (None, Changes::NONE) };
        if !saved.against.is_empty() {
            changes = changes | self.set_variable(open, id, &saved.against);
        }
        if let Some(record) = self.get_mut(id) {
            record.shown = !saved.hidden;
            let derivatives = saved.derivatives.iter();
            record.restore_made(
                derivatives.filter_map(|one| Some((one.column, Differentiation::from_code(&one.method)?))),
                open.document,
            );
            let rows = record.table.rows();
            record.excluded = saved.excluded.iter().copied().filter(|row| *row < rows).collect();
            record.known = read_values(&saved.known).into_iter().collect();
            take_uses(&mut record.uses, &saved.columns);
        }
        if let Some(found) = saved.found.as_ref().filter(|found| found.document == open.name())
            && let Some(record) = self.get_mut(id)
        {
            let reading = found.origin.map(|Number(reading)| reading).filter(|reading| reading.is_finite());
            record.origin = reading.map(|reading| Origin { reading, found: found.origin_fitted });
            for &(column, Number(offset)) in &found.offsets {
                if let Some(used) = record.uses.get_mut(column) {
                    used.offset = offset;
                }
            }
        }
        (self.names().into_iter().find(|(own, _)| *own == id).map(|(_, name)| name), changes)
    }
}

/// The stored form of a record. `document`: hash of the document's text.
fn saved(record: &Record, document: &str) -> format::Record {
    let offsets = record.uses.iter().enumerate().filter(|(_, used)| used.offset != 0.0);
    let offsets: Vec<(usize, Number)> = offsets.map(|(column, used)| (column, Number(used.offset))).collect();
    let found = (record.origin.is_some() || !offsets.is_empty()).then(|| format::FoundOfRecord {
        document: document.to_owned(),
        origin: record.origin.map(|origin| Number(origin.reading)),
        origin_fitted: record.origin.is_some_and(|origin| origin.found),
        offsets,
    });
    let derivative = |(column, how): (usize, Differentiation)| format::Derivative { column, method: how.code() };
    format::Record {
        name: line(&record.name),
        text: record.text.clone(),
        hidden: !record.shown,
        truth: record.truth.as_ref().map(|truth| write_values(truth.iter().map(|(name, value)| (name, *value)))),
        excluded: record.excluded.iter().copied().collect(),
        known: write_values(record.known.iter().map(|(name, value)| (name, *value))),
        against: record.against.clone(),
        columns: write_uses(record.uses.iter().enumerate().filter(|(_, used)| used.chosen)),
        derivatives: record.differentiated().map(derivative).collect(),
        found,
    }
}

/// Name with line breaks replaced by spaces.
pub(crate) fn line(name: &str) -> String {
    name.replace(['\n', '\r'], " ")
}

fn write_values<'a>(values: impl Iterator<Item = (&'a String, f64)>) -> Vec<(String, Number)> {
    values.map(|(name, value)| (name.clone(), Number(value))).collect()
}

fn read_values(saved: &[(String, Number)]) -> Vec<(String, f64)> {
    saved.iter().map(|(name, Number(value))| (name.clone(), *value)).collect()
}

/// Stored form of the uses of columns.
pub(crate) fn write_uses<'a>(uses: impl Iterator<Item = (usize, &'a Use)>) -> Vec<format::Column> {
    let column = |(column, used): (usize, &Use)| format::Column {
        column,
        quantity: used.meaning.quantity.clone(),
        unit: used.meaning.unit.text.clone(),
        stated: used.stated,
        fitted: used.fitted,
    };
    uses.map(column).collect()
}

/// Applies stored uses to columns. Columns with an unknown unit are skipped. Returns true if all columns exist.
pub(crate) fn take_uses(uses: &mut [Use], saved: &[format::Column]) -> bool {
    let mut all = true;
    for format::Column { column, quantity, unit, stated, fitted } in saved {
        let Ok(unit) = Unit::parse(unit) else { continue };
        let meaning = Meaning { quantity: quantity.clone(), unit };
        match uses.get_mut(*column) {
            Some(used) => *used = Use { meaning, fitted: *fitted, offset: 0.0, chosen: true, stated: *stated },
            None => all = false,
        }
    }
    all
}
