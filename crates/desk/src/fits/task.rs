//! Construction of a fit task: the fitted columns of each record and their values.

use crate::fits::ShownFits;
use crate::fits::fit::{Job, Part, StatedError};
use crate::fits::shared_units::ColumnUnit;
use crate::records::recognise::observed;
use crate::records::record::Record;
use crate::records::series::turn;
use crate::records::understood::{lacks_scale, no_scale};
use crate::words::fit_error;
use crate::{Refusal, words};
use analysis::fit::{FitError, Observation, Task, Varied};
use document::Document;
use units::Unit;

impl ShownFits<'_> {
    /// Participation of each record in a fit of `document`. `own`: true if it is the open document; otherwise the
    /// columns are recognised for it. `units`: those that hold for all theories.
    pub(super) fn parts(self, document: &Document, varied: &[Varied], own: bool, units: &[ColumnUnit]) -> Vec<Part> {
        let taking_part = self.taking_part();
        let part = |record: &Record| {
            let (uses, origin) = if own {
                let found = record.fitted_origin().filter(|origin| origin.found);
                (record.uses().to_vec(), found.map(|origin| origin.reading))
            } else {
                let mut own = record.clone();
                own.take_for(document);
                let mut uses = own.uses().to_vec();
                for (_, column, unit) in units.iter().filter(|(id, ..)| *id == record.id()) {
                    if let Some(used) =
                        uses.get_mut(*column).filter(|used| used.meaning.unit.dimension == unit.dimension)
                    {
                        used.meaning.unit = unit.clone();
                    }
                }
                (uses, None)
            };
            let fixed = match taking_part.len() {
                1 => Vec::new(),
                _ => self.fits.setup.fixed(&document.program.model, varied, record),
            };
            let excluded = record.excluded().iter().copied().collect();
            Part {
                record: record.id(),
                name: record.name().to_owned(),
                uses,
                origin,
                fixed,
                errors: Vec::new(),
                excluded,
            }
        };
        taking_part.iter().filter_map(|id| self.records.get(*id)).map(part).collect()
    }

    /// Builds the task of a job.
    ///
    /// # Errors
    /// A record no longer exists, a fitted column is in pixels, or a record has no fitted column.
    pub(super) fn task(self, job: &Job) -> Result<Task, Refusal> {
        let unknown = || Refusal::unknown(words::record(self.play.basis().language()));
        let (document, definition) = (&job.document, &job.definition);
        let model = &document.program.model;
        let mut records = Vec::with_capacity(definition.parts.len());
        for part in &definition.parts {
            let record = self.records.get(part.record).ok_or_else(unknown)?;
            if let Some(used) = part.uses.iter().find(|used| used.fitted && lacks_scale(model, used)) {
                let language = self.play.basis().language();
                let why = format!("{}, {}: {}.", record.name(), used.meaning.quantity, no_scale(language));
                return Err(Refusal::Fit { why });
            }
            let (observations, columns) = observations(record, part, model);
            if observations.is_empty() && definition.parts.len() > 1 {
                let why = format!(
                    "{}: {}",
                    record.name(),
                    fit_error(self.play.basis().language(), &FitError::NothingObserved)
                );
                return Err(Refusal::Fit { why });
            }
            let (fixed, origin) = (part.fixed.clone(), part.origin);
            records.push(analysis::fit::Record {
                name: part.name.clone(),
                observations,
                fixed,
                origin,
                scale_error: record.table().scale_error,
                excluded: excluded(record, part, &columns, model),
                assumed: assumed(record, part, &columns),
            });
        }
        let parameters = definition.parameters.iter().zip(&model.parameters);
        Ok(Task {
            parameters: parameters.map(|(value, own)| if own.is_shown() { *value } else { own.value }).collect(),
            method: document.program.method.unwrap_or_default(),
            records,
            varied: definition.varied.clone(),
            tied: Vec::new(),
            from: definition.window[0],
            until: definition.window[1],
            loss: definition.loss,
        })
    }
}

/// One list per fitted column: true for values of rows that are left out. Empty if there are none.
fn excluded(record: &Record, part: &Part, columns: &[usize], model: &program::Model) -> Vec<Vec<bool>> {
    if part.excluded.is_empty() {
        return Vec::new();
    }
    let independent = &model.independent.name;
    let marks = |column: &usize| record.marks_as(&part.uses, *column, independent, &part.excluded).unwrap_or_default();
    columns.iter().map(marks).collect()
}

/// Fitted columns whose units are assumed, by their places, with these units.
fn assumed(record: &Record, part: &Part, columns: &[usize]) -> Vec<(usize, Unit)> {
    let unit = |(place, column): (usize, &usize)| {
        let used = part.uses.get(*column).filter(|used| !used.meaning.unit.text.is_empty())?;
        record.assumes_unit(&part.uses, *column).then(|| (place, used.meaning.unit.clone()))
    };
    columns.iter().enumerate().filter_map(unit).collect()
}

/// Observations of the fitted columns whose quantity the model has, and these columns.
fn observations(record: &Record, part: &Part, model: &program::Model) -> (Vec<Observation>, Vec<usize>) {
    let uses = &part.uses;
    let independent = &model.independent.name;
    let mut followed: Vec<usize> = Vec::new();
    let mut observations = Vec::new();
    for (column, used) in uses.iter().enumerate().filter(|(_, used)| used.fitted) {
        let name = &used.meaning.quantity;
        let Some(observed) = observed(model, name).filter(|_| !name.is_empty() && name != independent) else {
            continue;
        };
        if observed.dimension() != used.meaning.unit.dimension {
            continue;
        }
        let Some((times, mut values)) = record.series_as(uses, column, &model.independent) else { continue };
        let derived_from =
            record.computed_from(column).and_then(|source| followed.iter().position(|&own| own == source));
        followed.push(column);
        let errors = part.errors.iter().find(|(own, _)| *own == column);
        let stated = matches!(errors, Some((_, StatedError::Value(_))));
        let errors = match errors {
            Some((_, StatedError::Value(error))) => Some(vec![*error; values.len()]),
            Some((_, StatedError::Column(beside))) => record.errors_in(*beside, uses, column, independent),
            None => record.errors_as(uses, column, independent),
        };
        let mut errors = errors.filter(|errors| errors.len() == values.len());
        turn(&mut values, &used.meaning.unit, &observed.unit);
        if let (Some(errors), false) = (&mut errors, stated) {
            turn(errors, &used.meaning.unit, &observed.unit);
        }
        observations.push(Observation { name: name.clone(), observed, times, values, errors, derived_from });
    }
    (observations, followed)
}
