//! Default choice of whether the offset of the readings is varied.

use crate::fits::ShownFits;
use crate::fits::fit::Part;
use crate::records::recognise::observed;
use crate::records::record::Use;
use analysis::fit::{Target, Varied, lacks_constant};
use program::Model;

impl ShownFits<'_> {
    /// True if a fit of the open document varies the zero of the clock. By default it does not.
    pub(super) fn varies_clock(self) -> bool {
        self.fits.setup.zeros[0].unwrap_or(false)
    }

    /// Indices of the observations whose offsets a fit of the open document varies.
    pub(super) fn own_offsets(self) -> Vec<usize> {
        let varied = self.fits.setup.varied.iter().enumerate().filter(|(_, varied)| **varied);
        let varied: Vec<usize> = varied.map(|(index, _)| index).collect();
        let records = self.taking_part().into_iter().filter_map(|id| self.records.get(id));
        let records: Vec<(u32, &[Use])> = records.map(|record| (record.id(), record.uses())).collect();
        self.offsets(self.play.model(), &varied, &records)
    }

    /// Indices of the observations whose offsets a fit of another model to these records varies.
    pub(super) fn offsets_of(self, model: &Model, varied: &[Varied], parts: &[Part]) -> Vec<usize> {
        let parameter = |varied: &Varied| match varied.target {
            Target::Parameter(index) => Some(index),
            _ => None,
        };
        let varied: Vec<usize> = varied.iter().filter_map(parameter).collect();
        let records: Vec<(u32, &[Use])> = parts.iter().map(|part| (part.record, &part.uses[..])).collect();
        self.offsets(model, &varied, &records)
    }

    /// Observations with an offset: those to which the theory adds no constant of its own by a varied parameter, all if the
    /// user has chosen the offset, none if the user has fixed it, or if the values are too few. A column that was computed from
    /// another one has no offset of its own.
    fn offsets(self, model: &Model, varied: &[usize], records: &[(u32, &[Use])]) -> Vec<usize> {
        let chosen = self.fits.setup.zeros[1];
        let (mut found, mut values): (Vec<usize>, usize) = (Vec::new(), 0);
        for (id, uses) in records {
            let Some(record) = self.records.get(*id) else { continue };
            let fitted = uses.iter().enumerate().filter(|(_, used)| used.fitted);
            let observed = fitted.filter_map(|(column, used)| {
                let name = &used.meaning.quantity;
                let observed = observed(model, name).filter(|_| !name.is_empty() && *name != model.independent.name)?;
                (observed.dimension() == used.meaning.unit.dimension).then_some((column, observed))
            });
            for (place, (column, observed)) in observed.enumerate() {
                let is_fitted = |source: usize| uses.get(source).is_some_and(|used| used.fitted);
                if record.computed_from(column).is_some_and(is_fitted) {
                    continue;
                }
                values += record.table().columns.get(column).map_or(0, analysis::table::Column::filled);
                if !found.contains(&place) && (chosen == Some(true) || lacks_constant(model, &observed, varied)) {
                    found.push(place);
                }
            }
        }
        let numbers = (varied.len() + found.len()) * records.len();
        match chosen {
            Some(false) => Vec::new(),
            None if values <= numbers => Vec::new(),
            _ => found,
        }
    }
}
