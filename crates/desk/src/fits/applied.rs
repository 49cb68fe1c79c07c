//! Applying fits: sets the fitted values on the sliders. A fit of several records uses the values of the chosen record.

use crate::fits::{Fits, ShownFits};
use crate::records::record::Origin;
use crate::{Announcement, Changes};
use analysis::fit::Target;

/// Values that a fit, when applied, sets in the records and in the simulation.
#[derive(Debug)]
pub(crate) struct Application {
    /// Id of the fit.
    fit: u32,
    /// The records of the fit.
    pub records: Vec<FittedRecord>,
    /// Id and name of the record whose values are set on the sliders.
    pub shown: (u32, String),
    /// True if the fit has several records.
    is_several: bool,
    /// Values of the parameters, SI.
    pub parameters: Vec<f64>,
    /// Last reading of the clock of the shown record, SI.
    pub last: f64,
}

/// Fitted zeros of a record.
#[derive(Debug)]
pub(crate) struct FittedRecord {
    pub id: u32,
    /// Beginning of the model.
    pub origin: Option<Origin>,
    /// Zeros of the scales, by name of the quantity, SI.
    pub offsets: Vec<(String, f64)>,
    /// True if the record is drawn, `None` to leave that as it is.
    pub shown: Option<bool>,
}

impl Fits {
    /// Chooses a record. If it belongs to the applied fit of several records, the id of that fit is returned: its values
    /// for this record are to be set on the sliders.
    pub(crate) fn choose(&mut self, record: u32) -> (Option<u32>, Changes) {
        self.setup.chosen = Some(record);
        let applied = self.finished.iter().find(|fit| Some(fit.id) == self.applied);
        let parts = applied.map_or(&[][..], |fit| &fit.definition.parts);
        let belongs = parts.len() > 1 && parts.iter().any(|part| part.record == record);
        (self.applied.filter(|_| belongs), Changes::FITS)
    }

    /// Takes the fit as the applied one.
    pub(crate) fn set_applied(
        &mut self,
        Application { fit, shown: (id, name), is_several, .. }: Application,
    ) -> Changes {
        self.applied = Some(fit);
        if is_several {
            self.setup.chosen = Some(id);
        }
        Changes::FITS.announcing(Announcement::FitApplied(if is_several { name } else { String::new() }))
    }
}

impl ShownFits<'_> {
    /// Values that a fit sets when it is applied; `None` if it does not exist or cannot be applied. With several records, it uses the
    /// chosen one, else the first, and shows only that one, because the curve belongs to it.
    pub(crate) fn application(self, id: u32) -> Option<Application> {
        let fit = self.fits.finished.iter().find(|fit| fit.id == id && self.is_applicable(fit))?;
        let chosen = self.chosen_record();
        let parts = &fit.definition.parts;
        let place = parts.iter().position(|part| Some(part.record) == chosen).unwrap_or(0);
        let (parameters, part) = (fit.outcome.settings.get(place).cloned()?, parts.get(place)?);
        let is_several = parts.len() > 1;
        let found = |place: usize| {
            let own = move |record: Option<usize>| record.is_none_or(|record| record == place);
            fit.outcome.parameters.iter().filter(move |one| own(one.record))
        };
        let first = |place: usize| fit.outcome.observations.iter().find(|one| one.record == place);
        let ends = |place: usize| first(place).and_then(|one| one.times.last().copied()).unwrap_or_default();
        let records = parts.iter().enumerate().map(|(place, own)| {
            let reading = found(place).find(|one| one.target == Some(Target::Origin));
            let reading = reading.map(|one| Origin { reading: one.value, found: true });
            let observations = fit.task.records.get(place).map_or(&[][..], |record| &record.observations);
            let offsets = found(place).filter_map(|one| match one.target {
                Some(Target::Offset(number)) => Some((observations.get(number)?.name.clone(), one.value)),
                _ => None,
            });
            let begun =
                || fit.outcome.origins.get(place).map(|&reading| Origin { reading, found: own.origin.is_some() });
            FittedRecord {
                id: own.record,
                origin: reading.or_else(begun),
                offsets: offsets.collect(),
                shown: is_several.then_some(own.record == part.record),
            }
        });
        let records = records.collect();
        let shown = (part.record, part.name.clone());
        Some(Application { fit: id, records, shown, is_several, parameters, last: ends(place) })
    }
}
