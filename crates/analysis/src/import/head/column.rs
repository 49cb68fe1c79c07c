//! The head of a column: name, unit, body, and how its numbers are read.

use super::label::Label;
use super::meant::Meant;
use super::power::Sense;
use crate::conversion::{Conversion, UnitReading};
use crate::import::clock;
use crate::origin::UnitOrigin;
use units::Unit;

/// What is known of a column before its numbers.
#[derive(Clone, Debug, Default)]
pub(in crate::import) struct Head {
    pub name: String,
    /// The cell as it is written.
    pub heading: String,
    pub unit: Option<Unit>,
    pub origin: UnitOrigin,
    pub body: Option<String>,
    /// What the name says of its clock times.
    pub clock: Option<clock::Form>,
    /// How the numbers become values in the unit, where that is not plain; and the text of the unit.
    pub reading: Option<(UnitReading, String)>,
    /// The power of ten in the heading.
    pub(super) tens: Option<(i32, Sense)>,
}

impl Head {
    /// Whether its numbers are in this unit.
    pub fn is_in(&self, meant: &Meant) -> bool {
        let same = |unit: &Unit| unit.dimension == meant.unit.dimension && unit.factor == meant.unit.factor;
        let reading = self.reading.as_ref().map(|(reading, _)| *reading);
        self.unit.as_ref().is_some_and(same) && reading == meant.reading && self.tens.is_none()
    }

    /// Takes a unit, and nothing else that the header says of it.
    pub fn take(&mut self, meant: Meant, text: String, origin: UnitOrigin) {
        self.reading = meant.reading.map(|reading| (reading, text));
        (self.unit, self.origin, self.tens) = (Some(meant.unit), origin, None);
    }

    /// What its numbers are converted by: nothing where they are the values.
    pub fn conversion(&self) -> Option<Conversion> {
        let tens = self.tens.filter(|(_, sense)| *sense != Sense::Open).map_or(0, |(tens, _)| tens);
        let reading = self.reading.as_ref().map(|(reading, _)| *reading);
        (tens != 0 || reading.is_some()).then_some(Conversion { tens, reading })
    }
}

/// What a label says of a column, and the cell in which it stands.
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
