//! Construction of a fit task: the fitted columns of each record and their values.

use crate::fits::ShownFits;
use crate::fits::fit::{Job, Part, StatedError};
use crate::records::recognise::observed;
use crate::records::record::Record;
use crate::records::series::turn;
use crate::records::understood::{lacks_scale, no_scale};
use crate::words::fit_error;
use crate::{Refusal, words};
use analysis::fit::{FitError, Observation, Task, Varied};
use document::Document;

impl ShownFits<'_> {
    /// Participation of each record in a fit of `document`. `own`: true if it is the open document; otherwise the
    /// columns are recognised for it.
    pub(super) fn parts(self, document: &Document, varied: &[Varied], own: bool) -> Vec<Part> {
        let taking_part = self.taking_part();
        let part = |record: &Record| {
            let (uses, origin) = if own {
                let found = record.fitted_origin().filter(|origin| origin.found);
                (record.uses().to_vec(), found.map(|origin| origin.reading))
            } else {
                let mut record = record.clone();
                record.take_for(document);
                (record.uses().to_vec(), None)
            };
            let fixed = match taking_part.len() {
                1 => Vec::new(),
                _ => self.fits.setup.fixed(&document.program.model, varied, record),
            };
            Part { record: record.id(), name: record.name().to_owned(), uses, origin, fixed, errors: Vec::new() }
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
            let observations = observations(record, part, model);
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
            });
        }
        let parameters = definition.parameters.iter().zip(&model.parameters);
        Ok(Task {
            parameters: parameters.map(|(value, own)| if own.is_shown() { *value } else { own.value }).collect(),
            method: document.program.method.unwrap_or_default(),
            records,
            varied: definition.varied.clone(),
            from: definition.window[0],
            until: definition.window[1],
            loss: definition.loss,
        })
    }
}

/// Observations of the fitted columns whose quantity the model has.
fn observations(record: &Record, part: &Part, model: &program::Model) -> Vec<Observation> {
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
    observations
}
