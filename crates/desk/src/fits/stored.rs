//! Conversion between fits and stored items: the definition and the values found. A fit is reconstructed from them in a
//! few trials, so its outcome is not stored.

use saved::format::{self, Content};
use saved::{Item, Number};

use crate::Changes;
use crate::fits::fit::{Definition, Fitted, Found, Part, StatedError, Waiting, texts};
use crate::fits::{FitData, Fits, ShownFits};
use crate::records::{Records, line, take_uses, write_uses};
use analysis::fit::{Loss, Rival, Target, Varied};
use play::name_of;

/// Maximum length of all stored fits together, in bytes. The records need room too.
const LONGEST: usize = 1 << 20;

impl ShownFits<'_> {
    /// The fits to store, each with a name that is the same at every visit and on every page. Fits of records that are
    /// not stored are left out, and those that exceed the maximum length.
    pub fn saved(self) -> Vec<(String, Item)> {
        let mut saved = SavedFits { records: self.records.names(), fits: Vec::new(), length: 0 };
        saved.add_finished(self.fits.finished.iter());
        for job in self.being_remade() {
            if let Some(found) = &job.found {
                saved.add(&job.definition, texts(&job.document), found);
            }
        }
        for Waiting { definition, texts, found } in &self.fits.waiting {
            saved.add(definition, texts.clone(), found);
        }
        saved.fits
    }

    /// Finished fits in the form of [`ShownFits::saved`].
    pub(crate) fn to_save<'a>(self, fits: impl Iterator<Item = &'a Fitted>) -> Vec<(String, Item)> {
        let mut saved = SavedFits { records: self.records.names(), fits: Vec::new(), length: 0 };
        saved.add_finished(fits);
        saved.fits
    }

    /// True if fits are waiting to be reconstructed.
    pub fn has_waiting(self) -> bool {
        !self.fits.waiting.is_empty()
    }
}

impl Fits {
    /// Restores a fit, to be reconstructed by [`crate::Desk::advance_fit`], and returns its name in the storage. `None` if
    /// one of its records is missing.
    pub(crate) fn restore(&mut self, data: FitData<'_>, saved: &format::Fit) -> (Option<String>, Changes) {
        let names = data.records.names();
        let Some(waiting) = waiting(data.records, saved, &names) else { return (None, Changes::NONE) };
        let Some(task) = task(&waiting.definition, &names) else { return (None, Changes::NONE) };
        let name = name(&waiting.texts, &task);
        // The records of the last fit are likely to be fitted together again.
        self.setup.others = waiting.definition.parts.iter().map(|part| part.record).collect();
        self.setup.chosen = waiting.definition.parts.last().map(|part| part.record);
        self.waiting.push_back(waiting);
        (Some(name), Changes::NONE)
    }
}

/// The stored fit with its records; `None` if one of them is missing.
fn waiting(records: &Records, saved: &format::Fit, names: &[(u32, String)]) -> Option<Waiting> {
    let task = &saved.task;
    let definition = Definition {
        file: task.file.clone(),
        parts: task.records.iter().map(|part| read_part(records, part, names)).collect::<Option<_>>()?,
        varied: task.varied.iter().map(read_varied).collect(),
        parameters: read_numbers(&task.parameters),
        window: task.window.map(|end| end.map(|Number(end)| end)),
        loss: task.loss.as_deref().map_or(Some(Loss::Squares), Loss::from_code)?,
    };
    let rival = saved.found.rival.as_ref();
    let found = Found {
        values: read_numbers(&saved.found.values),
        starts: saved.found.starts,
        rival: rival.map(|rival| Rival { growth: rival.growth.0, values: read_numbers(&rival.values) }),
    };
    Some(Waiting { definition, texts: saved.documents.clone(), found })
}

/// Part of a fit if its record is there. The record is found by its name in the storage.
fn read_part(records: &Records, saved: &format::Part, names: &[(u32, String)]) -> Option<Part> {
    let (id, _) = names.iter().find(|(_, name)| *name == saved.record)?;
    let record = records.get(*id).filter(|record| line(record.name()) == saved.name)?;
    let mut uses = record.uses().to_vec();
    take_uses(&mut uses, &saved.columns).then_some(())?;
    let fixed = saved.fixed.iter().map(|&(index, Number(value))| (index, value)).collect();
    let origin = saved.origin.map(|Number(origin)| origin);
    let errors = saved.errors.iter().filter_map(read_error).collect();
    let excluded = saved.excluded.clone();
    Some(Part { record: record.id(), name: record.name().to_owned(), uses, origin, fixed, errors, excluded })
}

/// Collector of the fits to store.
struct SavedFits {
    /// Ids and storage names of the records that are stored.
    records: Vec<(u32, String)>,
    /// Storage names and items.
    fits: Vec<(String, Item)>,
    length: usize,
}

impl SavedFits {
    fn add_finished<'a>(&mut self, fits: impl Iterator<Item = &'a Fitted>) {
        for fit in fits {
            self.add(&fit.definition, texts(&fit.document), &Found::of(&fit.outcome));
        }
    }

    /// Adds a fit, unless it exceeds the maximum length, is stored already, or one of its records is not stored.
    fn add(&mut self, definition: &Definition, documents: Vec<String>, found: &Found) {
        let Some(task) = task(definition, &self.records) else { return };
        let name = name(&documents, &task);
        let rival = found.rival.as_ref();
        let rival = rival
            .map(|Rival { growth, values }| format::Rival { growth: Number(*growth), values: write_numbers(values) });
        let found = format::Found { values: write_numbers(&found.values), starts: found.starts, rival };
        let item = Item(Content::Fit(format::Fit { documents, task, found }));
        let length = item.write(0).len();
        if self.length + length <= LONGEST && self.fits.iter().all(|(other, _)| *other != name) {
            self.length += length;
            self.fits.push((name, item));
        }
    }
}

/// Storage name of a fit. It does not depend on the result, whose last digits may differ after a reconstruction.
fn name(documents: &[String], task: &format::Task) -> String {
    // Texts and numbers can always be serialised.
    let asked = serde_json::to_string(task).unwrap_or_default();
    name_of(&documents.iter().chain([&asked]).map(String::as_str).collect::<Vec<_>>())
}

/// The definition in the storage format. `records`: ids and names of the stored records. `None` if a record of the fit
/// is not stored.
fn task(definition: &Definition, records: &[(u32, String)]) -> Option<format::Task> {
    let part = |part: &Part| {
        let (_, record) = records.iter().find(|(id, _)| *id == part.record)?;
        Some(format::Part {
            record: record.clone(),
            name: line(&part.name),
            origin: part.origin.map(Number),
            fixed: part.fixed.iter().map(|&(index, value)| (index, Number(value))).collect(),
            columns: write_uses(part.uses.iter().enumerate()),
            errors: part.errors.iter().map(write_error).collect(),
            excluded: part.excluded.clone(),
        })
    };
    Some(format::Task {
        file: definition.file.clone(),
        window: definition.window.map(|end| end.map(Number)),
        parameters: write_numbers(&definition.parameters),
        varied: definition.varied.iter().map(write_varied).collect(),
        loss: (definition.loss != Loss::Squares).then(|| definition.loss.code().to_owned()),
        records: definition.parts.iter().map(part).collect::<Option<_>>()?,
    })
}

/// A varied number in the form in which fits are stored.
pub fn write_varied(varied: &Varied) -> format::Varied {
    let target = match varied.target {
        Target::Parameter(index) => format::Target::Parameter(index),
        Target::Origin => format::Target::Origin,
        Target::Offset(place) => format::Target::Offset(place),
    };
    let bounds = varied.bounds.map(|(low, high)| [Number(low), Number(high)]);
    format::Varied { target, shared: varied.shared, bounds }
}

fn read_varied(saved: &format::Varied) -> Varied {
    let target = match saved.target {
        format::Target::Parameter(index) => Target::Parameter(index),
        format::Target::Origin => Target::Origin,
        format::Target::Offset(place) => Target::Offset(place),
    };
    let bounds = saved.bounds.map(|[Number(low), Number(high)]| (low, high)).filter(|(low, high)| low < high);
    Varied { target, shared: saved.shared, bounds, ..Varied::parameter(0) }
}

fn write_error((column, stated): &(usize, StatedError)) -> format::StatedError {
    let (value, beside) = match stated {
        StatedError::Value(error) => (Some(Number(*error)), None),
        StatedError::Column(beside) => (None, Some(*beside)),
    };
    format::StatedError { column: *column, value, beside }
}

fn read_error(saved: &format::StatedError) -> Option<(usize, StatedError)> {
    let value = saved.value.map(|Number(error)| StatedError::Value(error));
    Some((saved.column, value.or(saved.beside.map(StatedError::Column))?))
}

fn write_numbers(numbers: &[f64]) -> Vec<Number> {
    numbers.iter().copied().map(Number).collect()
}

fn read_numbers(saved: &[Number]) -> Vec<f64> {
    saved.iter().map(|Number(number)| *number).collect()
}
