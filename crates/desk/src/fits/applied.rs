//! Applying fits: sets the fitted values on the sliders. A fit of several records uses the values of the chosen record.

use crate::records::record::Origin;
use crate::{Announcement, Desk};
use analysis::fit::Target;

impl Desk {
    /// Chooses a record. If it belongs to the applied fit of several records, its own fitted values are set on the
    /// sliders.
    pub fn choose_record(&mut self, id: u32) {
        self.fits.setup.chosen = Some(id);
        self.revision.fits += 1;
        let applied = self.fits.finished.iter().find(|fit| Some(fit.id) == self.fits.applied);
        let parts = applied.map_or(&[][..], |fit| &fit.definition.parts);
        if let Some(fit) = self.fits.applied
            && parts.len() > 1
            && parts.iter().any(|part| part.record == id)
        {
            self.apply_fit(fit);
        }
    }

    /// Sets the fitted values on the sliders and runs the simulation to the end of the record. With several records, it
    /// uses the chosen one, else the first, and shows only that one, because the curve belongs to it.
    pub fn apply_fit(&mut self, id: u32) {
        let Some(fit) = self.fits.finished.iter().find(|fit| fit.id == id && self.is_applicable(fit)) else { return };
        let chosen = self.chosen_record();
        let parts = &fit.definition.parts;
        let place = parts.iter().position(|part| Some(part.record) == chosen).unwrap_or(0);
        let (Some(parameters), Some(part)) = (fit.outcome.settings.get(place).cloned(), parts.get(place)) else {
            return;
        };
        let (several, looked_at, name) = (parts.len() > 1, part.record, part.name.clone());
        let found = |place: usize| {
            let own = move |record: Option<usize>| record.is_none_or(|record| record == place);
            fit.outcome.parameters.iter().filter(move |one| own(one.record))
        };
        let first = |place: usize| fit.outcome.observations.iter().find(|one| one.record == place);
        let ends = |place: usize| first(place).and_then(|one| one.times.last().copied()).unwrap_or_default();
        let zeros = parts.iter().enumerate().map(|(place, part)| {
            let reading = found(place).find(|one| one.target == Some(Target::Origin));
            let reading = reading.map(|one| Origin { reading: one.value, found: true });
            let observations = fit.task.records.get(place).map_or(&[][..], |record| &record.observations);
            let offsets = found(place).filter_map(|one| match one.target {
                Some(Target::Offset(number)) => Some((observations.get(number)?.name.clone(), one.value)),
                _ => None,
            });
            let begun =
                || fit.outcome.origins.get(place).map(|&reading| Origin { reading, found: part.origin.is_some() });
            (part.record, reading.or_else(begun), offsets.collect::<Vec<_>>())
        });
        let zeros: Vec<_> = zeros.collect();
        let last = ends(place);
        for (id, origin, offsets) in zeros {
            let Some(record) = self.record_mut(id) else { continue };
            record.origin = origin;
            for used in &mut record.uses {
                let offset = offsets.iter().find(|(name, _)| used.fitted && *name == used.meaning.quantity);
                used.offset = offset.map_or(0.0, |(_, offset)| *offset);
            }
            record.shown = if several { id == looked_at } else { record.shown };
        }
        self.records_changed();
        let independent = self.play.model().independent.name.clone();
        let autonomous = self.play.model().is_autonomous();
        let begins = self.record(looked_at).map_or(0.0, |record| record.origin(&independent, autonomous));
        self.fits.applied = Some(id);
        if several {
            self.fits.setup.chosen = Some(looked_at);
        }
        self.revision.fits += 1;
        self.play.run_through(parameters, last - begins);
        self.announce(Announcement::FitApplied(if several { name } else { String::new() }));
    }
}
