//! Fits in the sliders: of several records, those numbers that belong to the one that is looked at.

use crate::record::Origin;
use crate::{Announcement, Session};
use engine::Setup;

impl Session {
    /// Looks at a record. If it was fitted together with others, and what was found stands in the sliders, its own numbers
    /// take their place.
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

    /// Writes what a fit has found into the sliders and runs through the record. Of several records it is the one that is
    /// looked at, else the first; only that one is drawn, because the curve is its.
    pub fn apply_fit(&mut self, id: u32) {
        let Some(fit) = self.fits.finished.iter().find(|fit| fit.id == id && self.is_applicable(fit)) else { return };
        let chosen = self.chosen_record();
        let parts = &fit.definition.parts;
        let place = parts.iter().position(|part| Some(part.record) == chosen).unwrap_or(0);
        let (Some(parameters), Some(part)) = (fit.outcome.settings.get(place).cloned(), parts.get(place)) else {
            return;
        };
        let (several, looked_at, name) = (parts.len() > 1, part.record, part.name.clone());
        let found = |place: usize, ending: &str| {
            let own = |record: Option<usize>| record.is_none_or(|record| record == place);
            let zeros = fit.outcome.parameters.iter().filter(|one| one.parameter.is_none() && own(one.record));
            zeros.filter(|one| one.name.ends_with(ending)).map(|one| one.value).next()
        };
        let first = |place: usize| fit.outcome.observations.iter().find(|one| one.record == place);
        let ends = |place: usize| first(place).and_then(|one| one.times.last().copied()).unwrap_or_default();
        let zeros = parts.iter().enumerate().map(|(place, part)| {
            let followed = first(place).map(|one| one.name.clone());
            let reading = found(place, "_origin").map(|reading| Origin { reading, found: true });
            let begun =
                || fit.outcome.origins.get(place).map(|&reading| Origin { reading, found: part.origin.is_some() });
            (part.record, followed, reading.or_else(begun), found(place, "_offset"))
        });
        let zeros: Vec<_> = zeros.collect();
        let last = ends(place);
        for (id, followed, origin, offset) in zeros {
            let Some(record) = self.record_mut(id) else { continue };
            record.origin = origin;
            for used in &mut record.uses {
                let is = used.fitted && Some(&used.meaning.quantity) == followed.as_ref();
                used.offset = offset.filter(|_| is).unwrap_or(0.0);
            }
            record.shown = if several { id == looked_at } else { record.shown };
        }
        self.records_changed();
        let independent = self.model().independent.name.clone();
        let autonomous = self.model().is_autonomous();
        let begins = self.record(looked_at).map_or(0.0, |record| record.origin(&independent, autonomous));
        self.fits.applied = Some(id);
        if several {
            self.fits.setup.chosen = Some(looked_at);
        }
        self.revision.fits += 1;
        self.playing = false;
        let setup = Setup { parameters, start: None, ..self.course.begun().clone() };
        self.restart(setup);
        self.clear_ghost();
        self.run_through(last - begins);
        self.announce(Announcement::FitApplied(if several { name } else { String::new() }));
    }
}
