//! Origin of the unit of a column, as shown to the user.

use crate::records::recognise::observed;
use crate::records::record::{Record, Use};
use analysis::origin::UnitOrigin;
use play::Play;
use program::Model;
use units::Language;

/// Unit of a column as shown to the user.
#[derive(Debug, Default)]
pub(crate) struct Understood {
    /// Origin of the unit in words; empty if there is nothing to say.
    pub origin: String,
    /// True if the file states no unit and that of the quantity is assumed.
    pub assumed: bool,
    /// True if the user must state the unit: the file states an unknown one, or the film has no scale.
    pub asked: bool,
}

/// Unit of a column as shown to the user.
pub(super) fn understood(play: &Play, record: &Record, index: usize) -> Understood {
    let (Some(column), Some(used)) = (record.table.columns.get(index), record.uses.get(index)) else {
        return Understood::default();
    };
    let lacks_scale = lacks_scale(play.model(), used);
    let asked = record.asks_for_unit(&record.uses, index) || lacks_scale;
    let plain = used.meaning.unit.text.is_empty() && !asked;
    // The unit of a derivative follows from its source.
    if used.meaning.quantity.is_empty() || plain || record.how_made(index).is_some() {
        return Understood::default();
    }
    if used.stated {
        return Understood { origin: UnitOrigin::Person.text(play.basis().language()), ..Understood::default() };
    }
    let assumed = column.unit.is_none() && !asked;
    let language = play.basis().language();
    let origin = match assumed {
        _ if lacks_scale => no_scale(language).to_owned(),
        true => language.say("assumed: the file states none").to_owned(),
        false => column.origin.unit.text(language),
    };
    Understood { origin, assumed, asked }
}

/// True if a column holds positions in pixels and its quantity is a length: the film has no scale.
pub(crate) fn lacks_scale(model: &Model, used: &Use) -> bool {
    let expected = observed(model, &used.meaning.quantity).filter(|_| !used.meaning.quantity.is_empty());
    expected.is_some_and(|expected| used.meaning.unit.dimension.lacks_scale_for(expected.dimension()))
}

/// Remedy for a film without a scale.
pub(crate) fn no_scale(language: Language) -> &'static str {
    language.say("in pixels: give the film a scale: two clicks on the ruler")
}

impl Record {
    /// True if the user must state the unit of a column, because that of the file is unknown.
    pub(crate) fn asks_for_unit(&self, uses: &[Use], column: usize) -> bool {
        let stated = uses.get(column).is_some_and(|used| used.stated);
        let unknown = |column: &analysis::table::Column| {
            column.unit.is_none() && matches!(column.origin.unit, UnitOrigin::Unknown(_))
        };
        !stated && self.table.columns.get(column).is_some_and(unknown)
    }
}
