//! Head of a column: name, unit, body, and conversion of its numbers.

use super::label::Label;
use super::meant::Meant;
use super::power::Sense;
use crate::conversion::{Conversion, UnitReading};
use crate::import::clock;
use crate::origin::UnitOrigin;
use units::Unit;

/// Head of a column, from the header and the cells.
#[derive(Clone, Debug, Default)]
pub(in crate::import) struct Head {
    pub name: String,
    /// Text of the header cell.
    pub heading: String,
    pub unit: Option<Unit>,
    pub origin: UnitOrigin,
    pub body: Option<String>,
    /// Meaning of its clock times, from the name.
    pub clock: Option<clock::Form>,
    /// Conversion of the numbers to values in the unit, with the text of the unit; `None` if there is none.
    pub reading: Option<(UnitReading, String)>,
    /// Power of ten in the heading.
    pub(super) tens: Option<(i32, Sense)>,
}

impl Head {
    /// Head with a name alone.
    pub fn named(name: &str) -> Self {
        Self { name: name.trim().to_owned(), heading: name.to_owned(), ..Self::default() }
    }

    /// True if its numbers are in this unit.
    pub fn is_in(&self, meant: &Meant) -> bool {
        let same = |unit: &Unit| unit.dimension == meant.unit.dimension && unit.factor == meant.unit.factor;
        let reading = self.reading.as_ref().map(|(reading, _)| *reading);
        self.unit.as_ref().is_some_and(same) && reading == meant.reading && self.tens.is_none()
    }

    /// True if the unit was only taken from the end of the name: `Temp ms`, not `Temp (ms)` or `Temp / ms`.
    pub(super) fn is_guessed(&self) -> bool {
        self.origin == UnitOrigin::Suffix
            || (self.origin == UnitOrigin::Heading && !self.heading.contains(['[', '(', '<', '{', '/', ':']))
    }

    /// Sets the unit and discards the reading and the power of ten of the header.
    pub fn take(&mut self, meant: Meant, text: String, origin: UnitOrigin) {
        self.reading = meant.reading.map(|reading| (reading, text));
        (self.unit, self.origin, self.tens) = (Some(meant.unit), origin, None);
    }

    /// Conversion of its numbers; `None` if they are the values.
    pub fn conversion(&self) -> Option<Conversion> {
        let tens = self.tens.filter(|(_, sense)| *sense != Sense::Open).map_or(0, |(tens, _)| tens);
        let reading = self.reading.as_ref().map(|(reading, _)| *reading);
        (tens != 0 || reading.is_some()).then_some(Conversion { tens, reading })
    }
}

/// Head from a label and the cell that contains it.
pub(super) fn head(label: Label, cell: &str) -> Head {
    let unit = || {
        let inside = cell.find(['[', '(', '<', '{']).map(|open| &cell[open + 1..]);
        let text = inside.and_then(|inside| inside.split([']', ')', '>', '}']).next()).unwrap_or(cell);
        text.trim().to_owned()
    };
    Head {
        name: label.name,
        heading: cell.to_owned(),
        unit: label.unit,
        origin: label.origin,
        body: label.run,
        clock: label.clock,
        reading: label.reading.map(|reading| (reading, unit())),
        tens: label.tens,
    }
}
