//! Section of a file: a header and the rows below it.

use super::description::{Cells as Place, Clock, Description, Gain};
use super::header::{Header, Quantity, is_setting};
use super::remark::Remark;
use crate::import::head::{Head, of_cell, with_unit};
use crate::roles;

/// Header and rows.
#[derive(Debug, Default)]
pub(super) struct Section {
    pub header: Header,
    /// Numbers of each column of the file; NaN without one.
    pub columns: Vec<Vec<f64>>,
    /// Number of words in each column.
    pub words: Vec<usize>,
    /// Number of rows.
    pub rows: usize,
}

/// Column of the table to be made.
#[derive(Clone, Debug)]
pub(super) struct MadeColumn {
    pub head: Head,
    pub values: Vec<f64>,
    /// Number of words among its cells.
    pub words: usize,
    /// True if it holds the times of the columns after it.
    pub clock: bool,
}

/// Part of a column in the rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Part {
    Time,
    Index,
    Value,
}

impl Section {
    /// Adds a row of `width` columns at most; returns false if it has more cells.
    pub fn push(&mut self, cells: impl Iterator<Item = Option<f64>>, width: usize) -> bool {
        let mut count = 0;
        let mut fits = true;
        for (index, cell) in cells.enumerate() {
            if index >= width {
                fits &= cell.is_none_or(f64::is_nan);
                continue;
            }
            if self.columns.len() <= index {
                self.columns.push(vec![f64::NAN; self.rows]);
                self.words.push(0);
            }
            if let (Some(column), Some(words)) = (self.columns.get_mut(index), self.words.get_mut(index)) {
                column.push(cell.unwrap_or(f64::NAN));
                *words += usize::from(cell.is_none());
            }
            count = index + 1;
        }
        for column in self.columns.iter_mut().skip(count) {
            column.push(f64::NAN);
        }
        self.rows += 1;
        fits
    }

    /// Columns of the table, with the times in front of their channels; what is to be said is added to `notes`.
    pub fn make(self, description: &Description, notes: &mut Notes) -> Vec<MadeColumn> {
        let aligned = self.is_aligned(description);
        let names = self.names(description, aligned);
        let parts = self.parts(description, &names);
        let units = self.header.above(description.units, aligned);
        let time_unit = self.header.texts(description.time_unit, description.settings).into_iter().next();
        let steps = self.header.quantities(description.step, description.settings);
        let starts = self.header.quantities(description.start, description.settings);
        // Settings without their key stand one place further left than their columns if these are aligned.
        let of = |settings: &[Option<Quantity>], column: usize| {
            let place = column.checked_sub(usize::from(aligned));
            let own = place.and_then(|place| settings.get(place).cloned().flatten());
            own.or_else(|| settings.iter().flatten().next().cloned())
        };
        let gain = self.gain(description, aligned, notes);
        let single = only(&units).filter(|_| matches!(description.units, Place::Key(_)));
        let index = parts.iter().position(|part| *part == Part::Index);
        let rows = self.rows;
        let mut made: Vec<MadeColumn> = Vec::new();
        let mut clock: Option<(Option<Quantity>, Option<Quantity>)> = None;
        let mut in_file = false;
        let counts: Vec<f64> = match index.and_then(|index| self.columns.get(index)) {
            Some(counts) if counts.iter().all(|count| count.is_finite()) => counts.clone(),
            _ => (0..rows).map(|row| row as f64).collect(),
        };
        for (column, mut values) in self.columns.into_iter().enumerate() {
            let (name, part) =
                (names.get(column).map_or("", String::as_str), parts.get(column).copied().unwrap_or(Part::Value));
            let words = self.words.get(column).copied().unwrap_or(0);
            let filled = values.iter().any(|value| value.is_finite());
            match part {
                Part::Index => continue,
                Part::Time if filled => {
                    in_file = true;
                    let unit = units.get(column).filter(|unit| !unit.is_empty()).or(time_unit.as_ref());
                    made.push(MadeColumn {
                        head: time_head(name, unit.map(String::as_str)),
                        values,
                        words,
                        clock: true,
                    });
                    continue;
                }
                Part::Time => continue,
                Part::Value if !filled && (words > 0 || name.is_empty() || name.eq_ignore_ascii_case("comment")) => {
                    notes.word_columns.extend((words > 0).then(|| name.to_owned()));
                    continue;
                }
                Part::Value => {}
            }
            let own = (of(&steps, column), of(&starts, column));
            if description.clock != Clock::Any && !in_file && clock.as_ref() != Some(&own) {
                made.push(computed_times(&own, &counts, time_unit.as_deref(), index.is_some(), notes));
                clock = Some(own);
            } else if in_file && filled && clock.get_or_insert_with(|| own.clone()).0 != own.0 {
                notes.say(Remark::OneClock);
            }
            if let Some(factor) =
                gain.iter().find(|(own, _)| *own == column || *own == usize::MAX).map(|(_, factor)| factor)
            {
                values.iter_mut().for_each(|value| *value = factor.of(*value));
            }
            let unit = units.get(column).filter(|unit| !unit.trim().is_empty()).or(single.as_ref());
            let head = unit.map_or_else(|| channel_head(name), |unit| with_unit(name, unit));
            made.push(MadeColumn { head, values, words, clock: false });
        }
        made
    }

    /// True if the key of a setting stands above the first column: it holds times, counts or nothing.
    fn is_aligned(&self, description: &Description) -> bool {
        match description.clock {
            Clock::First | Clock::Index | Clock::Named(_) => true,
            Clock::Any => false,
            Clock::Pairs { key, value } => self.has(description, key, value),
            Clock::Perhaps => {
                let channels = self.header.above(description.names, false);
                let named = channels.iter().filter(|name| !name.is_empty() && !is_setting(name, description)).count();
                let of_time = channels.first().is_some_and(|name| roles::is_time(name));
                let by_key = matches!(description.names, Place::Key(_));
                let empty = self.columns.first().is_some_and(|values| values.iter().all(|value| value.is_nan()));
                empty || of_time || (by_key && self.width() == named.max(1) + 1)
            }
        }
    }

    /// Number of columns up to the last with a number.
    fn width(&self) -> usize {
        let filled = |values: &Vec<f64>| values.iter().any(|value| value.is_finite());
        self.columns.iter().rposition(filled).map_or(0, |last| last + 1)
    }

    fn has(&self, description: &Description, key: &'static str, value: &str) -> bool {
        let texts = self.header.texts(&[key], description.settings);
        texts.first().is_some_and(|text| text.eq_ignore_ascii_case(value))
    }

    /// Names of the columns; empty for settings among them.
    fn names(&self, description: &Description, aligned: bool) -> Vec<String> {
        let names = self.header.above(description.names, aligned);
        names.into_iter().map(|name| if is_setting(&name, description) { String::new() } else { name }).collect()
    }

    fn parts(&self, description: &Description, names: &[String]) -> Vec<Part> {
        let aligned = self.is_aligned(description);
        let part = |column: usize| match description.clock {
            Clock::First if column == 0 => Part::Time,
            Clock::Index if column == 0 => Part::Index,
            Clock::Perhaps if column == 0 && aligned => Part::Time,
            Clock::Named("") | Clock::Pairs { .. } if aligned && column.is_multiple_of(2) => Part::Time,
            Clock::Named(own)
                if !own.is_empty() && names.get(column).is_some_and(|name| name.eq_ignore_ascii_case(own)) =>
            {
                Part::Time
            }
            _ => Part::Value,
        };
        (0..self.columns.len()).map(part).collect()
    }

    /// Factors by column; `usize::MAX` stands for all columns.
    fn gain(&self, description: &Description, aligned: bool, notes: &mut Notes) -> Vec<(usize, Factor)> {
        match description.gain {
            Gain::One => Vec::new(),
            Gain::Power => {
                // The power of a matrix also holds for its columns in further sections.
                if self.header.begins_matrix() {
                    notes.power = None;
                }
                if let Some((exponent, text)) = self.header.power() {
                    notes.power = Some(exponent);
                    notes.say(Remark::Power { text });
                }
                notes.power.map(|exponent| (usize::MAX, Factor::Power(exponent))).into_iter().collect()
            }
            Gain::Divisions { key, points } => {
                let heights = self.header.quantities(&[key], description.settings);
                let whole = |values: &Vec<f64>| values.iter().all(|value| value.is_nan() || value.fract() == 0.0);
                let counts = |column: &usize| self.columns.get(*column).is_some_and(whole);
                if aligned {
                    return Vec::new();
                }
                let columns = (0..self.columns.len()).filter(counts);
                let mut factors = Vec::new();
                for column in columns {
                    let height =
                        heights.get(column).cloned().flatten().or_else(|| heights.iter().flatten().next().cloned());
                    let Some(height) = height.map(|height| height.value) else { continue };
                    notes.say(Remark::Divisions { height, points });
                    factors.push((column, Factor::Divisions { height, points: f64::from(points) }));
                }
                factors
            }
        }
    }
}

/// Factor of the numbers of a column.
#[derive(Clone, Copy, Debug)]
enum Factor {
    Power(i32),
    Divisions { height: f64, points: f64 },
}

impl Factor {
    fn of(self, value: f64) -> f64 {
        match self {
            // Through the decimal notation, so that 0.0031328 becomes 3.1328 and not a neighbour of it.
            Self::Power(exponent) => format!("{value}e{exponent}").parse().unwrap_or(f64::NAN),
            Self::Divisions { height, points } => value * height / points,
        }
    }
}

/// Remarks on all sections, and what one section passes on to the next.
#[derive(Debug, Default)]
pub(super) struct Notes {
    pub remarks: Vec<Remark>,
    /// Names of columns of words, which were left out.
    pub word_columns: Vec<String>,
    /// Exponent of the power of ten of the present matrix.
    power: Option<i32>,
}

impl Notes {
    /// Adds a remark unless it was made before.
    pub fn say(&mut self, remark: Remark) {
        if !self.remarks.contains(&remark) && self.remarks.len() < 10 {
            self.remarks.push(remark);
        }
    }
}

/// Only filled cell of a line.
fn only(cells: &[String]) -> Option<String> {
    let mut filled = cells.iter().filter(|cell| !cell.trim().is_empty());
    filled.next().filter(|_| filled.next().is_none()).cloned()
}

/// Head of a column of times: `t` in seconds if the file states nothing else.
fn time_head(name: &str, unit: Option<&str>) -> Head {
    let mut own = of_cell(name);
    let bare = own.name.is_empty() || matches!(own.name.to_lowercase().as_str(), "x_value" | "x");
    if bare {
        "t".clone_into(&mut own.name);
    }
    match unit {
        Some(unit) => with_unit(&own.name, unit),
        None if own.unit.is_some() => own,
        None => with_unit(&own.name, "s"),
    }
}

/// Head of a channel whose unit only its name can state: `CH1(mV)`, `CH1V`.
fn channel_head(name: &str) -> Head {
    let channel = name.strip_prefix("CH").and_then(|rest| rest.strip_suffix(['V', 'A']));
    match channel.filter(|number| number.bytes().all(|byte| byte.is_ascii_digit()) && !number.is_empty()) {
        Some(number) => with_unit(&format!("CH{number}"), &name[name.len() - 1..]),
        // The console of MakeCode: times of arrival in seconds.
        None if name.to_lowercase().starts_with("time (source") => with_unit("time", "s"),
        None if name.contains(['(', '[', '/']) => of_cell(behind_quotes(name)),
        None => Head::named(name),
    }
}

/// Symbol behind a name in quotation marks, with its unit: `s_A1 / m` for `"Weg" s_A1 / m`.
fn behind_quotes(cell: &str) -> &str {
    let rest = cell.trim().strip_prefix('"').and_then(|rest| rest.split_once('"')).map_or("", |(_, rest)| rest.trim());
    if rest.starts_with(char::is_alphabetic) { rest } else { cell }
}

/// Times from the step and the first time; an index without a unit if there is no step.
fn computed_times(
    (step, start): &(Option<Quantity>, Option<Quantity>),
    counts: &[f64],
    unit: Option<&str>,
    index: bool,
    notes: &mut Notes,
) -> MadeColumn {
    let first = counts.first().copied().unwrap_or(0.0);
    let made = |head: Head, values: Vec<f64>| MadeColumn { head, values, words: 0, clock: true };
    let Some(step) = step.as_ref().filter(|step| step.value != 0.0) else {
        notes.say(Remark::NoIncrement);
        return made(with_unit("index", "1"), counts.to_vec());
    };
    let head = match &step.unit {
        Some(unit) => with_unit("t", &unit.text),
        None => with_unit("t", unit.unwrap_or("s")),
    };
    let text = head.unit.as_ref().map_or_else(String::new, |unit| unit.text.clone());
    let start = start.as_ref().map_or(0.0, |start| match (&start.unit, &head.unit) {
        (Some(own), Some(unit)) => unit.from_si(own.to_si(start.value)),
        _ => start.value,
    });
    notes.say(Remark::Increment { step: step.value, start, unit: text, index });
    let values = counts.iter().map(|count| start + (count - first) * step.value).collect();
    made(head, values)
}
