//! Parts of the description of an instrument's files.

use crate::import::cells::Delimiter;

/// Files of one instrument or program: how they are recognised, and which parts hold what. Keys and texts are in lower
/// case.
#[derive(Debug)]
pub(super) struct Description {
    /// Name for the user.
    pub name: &'static str,
    /// Beginnings of the first line that is not blank, one of which must match; delimiters are written as commas.
    pub first: &'static [&'static str],
    /// Texts that must all occur in the first lines.
    pub also: &'static [&'static str],
    /// Possible delimiters, the likelier first.
    pub delimiters: &'static [Delimiter],
    /// Place of the settings.
    pub settings: Settings,
    /// Place of the names of the columns.
    pub names: Cells,
    /// Place of the units of the columns; where there are none, a unit in brackets after the name is read.
    pub units: Cells,
    /// Place of the times.
    pub clock: Clock,
    /// Keys of the time step.
    pub step: &'static [&'static str],
    /// Keys of the time of the first row.
    pub start: &'static [&'static str],
    /// Keys of the unit of the times; seconds without one.
    pub time_unit: &'static [&'static str],
    /// Factor of the numbers.
    pub gain: Gain,
    /// Meaning of a further header between the rows.
    pub sections: Sections,
}

/// Place of the settings of the instrument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Settings {
    /// In lines above the rows: a key, then values.
    Above,
    /// In two lines above the rows: keys over values.
    Columns,
    /// In the first cells of the rows: a key, a value, a gap, then time and value; all repeated for each further channel.
    Beside,
}

/// Place of names or units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cells {
    /// Nowhere.
    Nowhere,
    /// In the header line of this index, from 0, without blank lines.
    Line(usize),
    /// In the header line of this index from the last, 0, backwards.
    FromEnd(usize),
    /// In the line of one of these keys.
    Key(&'static [&'static str]),
}

/// Place of the times.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Clock {
    /// In the first column.
    First,
    /// The first column counts the rows; the times follow from the step.
    Index,
    /// In the first column if there is one more column than channels, else they follow from the step.
    Perhaps,
    /// In the columns of this name; if these are empty, they follow from the step.
    Named(&'static str),
    /// In the column before each channel if the setting has this value, else they follow from the step.
    Pairs {
        /// Key of the setting.
        key: &'static str,
        /// Its value.
        value: &'static str,
    },
    /// The columns are read as those of any table.
    Any,
}

/// Factor of the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Gain {
    /// The numbers are the values.
    One,
    /// A header line `1.0e+03 *` multiplies all numbers.
    Power,
    /// Whole numbers are points of the screen: the setting is the height of a division.
    Divisions {
        /// Key of the height of a division.
        key: &'static str,
        /// Number of points of a division.
        points: u32,
    },
}

/// Meaning of a further header between the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sections {
    /// There is none; words between the rows are passed over.
    One,
    /// It begins another run.
    Runs,
    /// It begins further columns of the same rows.
    Channels,
}

/// Description with nothing but settings above rows that begin with the time.
pub(super) const PLAIN: Description = Description {
    name: "",
    first: &[],
    also: &[],
    delimiters: &[Delimiter::Tab, Delimiter::Semicolon, Delimiter::Comma],
    settings: Settings::Above,
    names: Cells::Nowhere,
    units: Cells::Nowhere,
    clock: Clock::First,
    step: &[],
    start: &[],
    time_unit: &[],
    gain: Gain::One,
    sections: Sections::One,
};
