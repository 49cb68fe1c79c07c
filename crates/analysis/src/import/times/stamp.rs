//! Time stamps that a serial monitor writes before each line: `12:00:00.050 -> 50,2.81`.

use super::clock;
use crate::import::cells::Delimiter;
use crate::origin::UnitOrigin;
use crate::table::Column;
use units::Unit;

/// Text between the stamp and the line.
const ARROW: &str = "->";

/// Stamp of a line, and the line without it.
fn divided(line: &str) -> Option<(&str, &str)> {
    let (stamp, rest) = line.split_once(ARROW)?;
    let stamp = stamp.trim();
    clock::read(stamp)?;
    Some((stamp, rest.strip_prefix(' ').unwrap_or(rest)))
}

/// Number of lines from which the delimiter after the stamps is recognised.
const SAMPLE: usize = 300;

/// First lines without their stamps, if most of them have one.
pub(in crate::import) fn without(text: &str) -> Option<String> {
    let first: Vec<&str> = text.lines().take(SAMPLE).filter(|line| !line.trim().is_empty()).take(20).collect();
    let stamped = first.iter().filter(|line| divided(line).is_some()).count();
    if 2 * stamped <= first.len() {
        return None;
    }
    let mut bare = String::new();
    for line in text.lines().take(SAMPLE) {
        bare.push_str(divided(line).map_or(line, |(_, rest)| rest));
        bare.push('\n');
    }
    Some(bare)
}

/// Text rewritten with the stamps in a first column.
#[derive(Debug)]
pub(in crate::import) struct Stamped {
    pub delimiter: Delimiter,
    pub columns: String,
}

impl Stamped {
    pub fn new(delimiter: Delimiter) -> Self {
        // Single numbers after the stamps have no delimiter, and blanks allow no empty cells.
        let delimiter = match delimiter {
            Delimiter::Blanks | Delimiter::Blank | Delimiter::CommaAndBlank => Delimiter::Tab,
            other => other,
        };
        Self { delimiter, columns: String::new() }
    }

    /// Reads the lines in about `budget` bytes of the text. Returns the number of bytes read.
    pub fn read(&mut self, text: &str, budget: usize) -> usize {
        let sign = char::from(self.delimiter.byte().unwrap_or(b'\t'));
        let mut at = 0;
        for line in text.split_inclusive('\n') {
            if at >= budget {
                break;
            }
            at += line.len();
            let (stamp, rest) = divided(line).unwrap_or(("", line));
            self.columns.push_str(stamp);
            self.columns.push(sign);
            self.columns.push_str(rest.trim());
            self.columns.push('\n');
        }
        at
    }
}

/// Leaves out the stamps if the second column holds the same times, in s, ms or µs: these are the times of measurement, the
/// stamps those of arrival. Returns the unit of these times.
pub(in crate::import) fn prefer_own_times(columns: &mut Vec<Column>) -> Option<Unit> {
    let stamps = columns.first().filter(|column| column.origin.unit == UnitOrigin::Clock)?.values.clone();
    let own = columns.get_mut(1)?;
    let rows = || stamps.iter().zip(&own.values).filter(|(stamp, own)| stamp.is_finite() && own.is_finite());
    let ((first_stamp, first), (last_stamp, last)) = (rows().next()?, rows().next_back()?);
    let ascending = rows().zip(rows().skip(1)).all(|((_, before), (_, after))| after > before);
    let rate = (last - first) / (last_stamp - first_stamp);
    let unit = ["s", "ms", "µs"].iter().filter_map(|unit| Unit::parse(unit).ok()).find(|unit| {
        // Stamps are rounded, and late by up to some hundredths of a second.
        let late = 0.02 + 0.5 / (last_stamp - first_stamp);
        (rate * unit.factor - 1.0).abs() < late
    })?;
    if !ascending || own.unit.as_ref().is_some_and(|own| *own != unit) {
        return None;
    }
    if own.unit.is_none() {
        own.unit = Some(unit.clone());
        own.origin.unit = UnitOrigin::Compared;
    }
    columns.remove(0);
    Some(unit)
}
