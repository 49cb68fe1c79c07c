//! Recognition of the delimiter and the decimal sign of a text.

use super::cells::{Cells, Delimiter, declared};
use super::number::{self, Cell, Signs};
use super::{clock, head};
use std::collections::BTreeMap;
use units::{Language, say};

/// Number of lines examined at the beginning, and of lines spread over the rest.
const FIRST: usize = 200;
const SPREAD: usize = 100;

/// Notation of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    /// Delimiter between two cells.
    pub delimiter: Delimiter,
    /// `b'.'` or `b','`.
    pub decimal: u8,
    /// The other one of the two, if it groups the digits of large numbers: `1.295,5`.
    pub thousands: Option<u8>,
    /// Number of lines before the first row.
    pub header_lines: usize,
}

impl Format {
    /// Decimal and thousands signs.
    pub(super) fn signs(&self) -> Signs {
        Signs { decimal: self.decimal, thousands: self.thousands }
    }

    /// Signs of a column with the other decimal sign.
    pub(super) fn other_signs(&self) -> Signs {
        Signs::plain(if self.decimal == b',' { b'.' } else { b',' })
    }

    /// Description for users: `tabs, decimal comma, 2 header lines`.
    pub fn text(&self, language: Language) -> String {
        let mut text = match self.delimiter {
            Delimiter::Tab => language.say("tabs").to_owned(),
            Delimiter::Semicolon => language.say("semicolons").to_owned(),
            Delimiter::Comma => language.say("commas").to_owned(),
            Delimiter::CommaAndBlank => language.say("commas with a blank").to_owned(),
            Delimiter::Blanks | Delimiter::Blank => language.say("blanks").to_owned(),
            Delimiter::Other(byte) => char::from(byte).to_string(),
        };
        text.push_str(match self.decimal {
            b',' => language.say(", decimal comma"),
            _ => language.say(", decimal point"),
        });
        text.push_str(match self.thousands {
            None => "",
            Some(b',') => language.say(", thousands separated by commas"),
            _ => language.say(", thousands separated by points"),
        });
        let lines = self.header_lines;
        text.push_str(&match lines {
            0 => language.say(", no header").to_owned(),
            1 => language.say(", 1 header line").to_owned(),
            _ => say!(language, ", {lines} header lines"),
        });
        text
    }
}

/// Kind of a cell, for the recognition of the format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Number or time of day.
    Number,
    /// Empty cell or failed formula.
    Gap,
    Word,
}

/// Kind of a cell. Numbers followed by their unit count as numbers if `with_units`.
pub(super) fn kind(cell: &str, delimiter: Delimiter, signs: Signs, with_units: bool) -> Kind {
    // In a text split at blanks, a comma at the edge of a number is punctuation.
    let punctuation = matches!(delimiter, Delimiter::Blanks | Delimiter::Blank)
        && signs.decimal == b','
        && (cell.starts_with(',') || cell.ends_with(','));
    match number::cell(cell, signs) {
        Cell::Number(_) if !punctuation => Kind::Number,
        Cell::Gap => Kind::Gap,
        _ if clock::read(cell).is_some() => Kind::Number,
        _ if number::is_spreadsheet_error(cell) => Kind::Gap,
        _ if with_units && is_with_unit(cell, signs) => Kind::Number,
        _ => Kind::Word,
    }
}

fn is_with_unit(cell: &str, signs: Signs) -> bool {
    number::with_unit(cell, signs).is_some_and(|(_, unit)| head::is_unit(unit))
}

/// Numbers of cells in a line, by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Count {
    pub numbers: usize,
    pub words: usize,
    /// All cells, without trailing gaps.
    pub cells: usize,
    /// All cells, including trailing gaps.
    pub all: usize,
}

/// Counts the cells of a line by kind.
fn count(line: &str, delimiter: Delimiter, signs: Signs, with_units: bool) -> Count {
    let mut count = Count::default();
    for cell in Cells::of(line, delimiter) {
        count.all += 1;
        match kind(cell, delimiter, signs, with_units) {
            Kind::Number => count.numbers += 1,
            Kind::Gap => continue,
            Kind::Word => count.words += 1,
        }
        count.cells = count.all;
    }
    count
}

/// Candidate for delimiter and signs, with the counts of the sample lines under it.
struct Candidate {
    delimiter: Delimiter,
    signs: Signs,
    counts: Vec<Count>,
}

impl Candidate {
    fn new(lines: &[&str], (delimiter, decimal): (Delimiter, u8), thousands: bool, with_units: bool) -> Self {
        let other = if decimal == b'.' { b',' } else { b'.' };
        // With commas as delimiters, a decimal comma only occurs in quotation marks.
        let thousands = thousands.then_some(other);
        let signs = Signs { decimal, thousands };
        let counts = lines.iter().map(|line| count(line, delimiter, signs, with_units)).collect();
        Self { delimiter, signs, counts }
    }

    /// Lines that could be rows.
    fn tables(&self) -> impl Iterator<Item = &Count> {
        self.counts.iter().filter(|count| count.numbers >= 2)
    }

    /// Number of rows that hold only numbers.
    fn rows(&self) -> usize {
        self.tables().filter(|count| count.words == 0).count()
    }

    /// Excess of numbers over words, summed over all lines.
    fn cells(&self) -> usize {
        self.tables().map(|count| count.numbers.saturating_sub(count.words)).sum()
    }

    fn with_numbers(&self) -> usize {
        self.counts.iter().filter(|count| count.numbers > 0).count()
    }
}

/// Recognises delimiter and signs of a text.
pub(super) fn recognise(text: &str) -> (Delimiter, Signs) {
    let lines = sample(text);
    let candidates = candidates(&lines);
    let all = |thousands: bool, with_units: bool| -> Vec<Candidate> {
        candidates.iter().map(|pair| Candidate::new(&lines, *pair, thousands, with_units)).collect()
    };
    let mut found = all(false, false);
    let rows = |found: &[Candidate]| found.iter().map(Candidate::rows).max().unwrap_or(0);
    let clean = rows(&found);
    let with_numbers = found.iter().map(Candidate::with_numbers).max().unwrap_or(0);
    if clean < with_numbers && lines.iter().any(|line| has_groups(line)) {
        // For `1,310.40` beside `885.40`.
        let other = all(true, false);
        if rows(&other) > clean {
            found = other;
        }
    }
    let clean = rows(&found);
    if 2 * clean < with_numbers {
        // Points and commas in one number, or units after numbers, turn numbers into words.
        for (thousands, with_units) in [(true, false), (false, true), (true, true)] {
            let other = all(thousands, with_units);
            if 2 * rows(&other) >= with_numbers && rows(&other) > clean {
                found = other;
                break;
            }
        }
    }
    // Decided by the number of rows with only numbers; if most lines contain a word, by the number of cells.
    let by_cells = 2 * rows(&found) < with_numbers;
    let mut best: Option<&Candidate> = None;
    let mut best_score = (0, 0);
    for candidate in &found {
        let numbers = if by_cells { candidate.cells() } else { candidate.rows() };
        // With equal scores the earlier candidate wins.
        let score = (numbers, most_frequent(candidate.tables().map(|count| count.all)));
        if score > best_score {
            (best, best_score) = (Some(candidate), score);
        }
    }
    best.map_or((Delimiter::Blanks, Signs::plain(b'.')), |best| (best.delimiter, best.signs))
}

/// True if a line has a number with groups of digits and decimals, `1,310.40`, or with groups in quotation marks,
/// `"1,310"`.
fn has_groups(line: &str) -> bool {
    line.as_bytes().windows(7).any(|bytes| {
        let [before, sign, one, two, three, decimal, after] = bytes else { return false };
        let digits = [before, one, two, three].into_iter().all(u8::is_ascii_digit);
        let both = after.is_ascii_digit() && matches!((sign, decimal), (b',', b'.') | (b'.', b','));
        digits && (both || (*sign == b',' && *decimal == b'"'))
    }) || line.ends_with('"') && line.len() >= 6 && has_groups(&format!("{line} "))
}

/// Number of occurrences of the most frequent number.
fn most_frequent(numbers: impl Iterator<Item = usize>) -> usize {
    let mut occurrences = BTreeMap::new();
    for number in numbers {
        *occurrences.entry(number).or_insert(0) += 1;
    }
    occurrences.into_values().max().unwrap_or(0)
}

/// Candidates, the likelier first; only the declared delimiter if the first line declares one.
fn candidates(lines: &[&str]) -> Vec<(Delimiter, u8)> {
    let all = possible(lines);
    let Some(byte) = lines.first().and_then(|line| declared(line)) else { return all };
    let own: Vec<_> = all.into_iter().filter(|(delimiter, _)| delimiter.byte() == Some(byte)).collect();
    if own.is_empty() { vec![(Delimiter::Other(byte), b'.'), (Delimiter::Other(byte), b',')] } else { own }
}

fn possible(lines: &[&str]) -> Vec<(Delimiter, u8)> {
    use Delimiter::{Blank, Blanks, Comma, CommaAndBlank, Other, Semicolon, Tab};
    let mut candidates = vec![(Tab, b'.'), (Tab, b','), (Semicolon, b'.'), (Semicolon, b',')];
    // For `1,5, 2,5`: some commas are followed by a blank, others are not.
    let followed = lines.iter().any(|line| line.contains(", "));
    let alone = lines.iter().any(|line| line.replace(", ", "").contains(','));
    if followed && alone {
        candidates.push((CommaAndBlank, b','));
    }
    candidates.extend([(Comma, b'.'), (Blanks, b'.'), (Blanks, b','), (Blank, b'.'), (Blank, b','), (Comma, b',')]);
    // Dates and times of day before another delimiter hold no delimiters.
    let dated = |line: &&&str| {
        line.contains([';', ',', '\t', '|']) || line.split_whitespace().any(|word| clock::read(word).is_some())
    };
    let whole = 2 * lines.iter().filter(dated).count() > lines.len();
    for other in [b'|', b'&', b':', b'/', b'~'].into_iter().filter(|sign| !whole || !matches!(sign, b':' | b'/')) {
        candidates.extend([(Other(other), b'.'), (Other(other), b',')]);
    }
    candidates
}

/// First lines that are not blank, and some from all over the text, because a comma may be rare.
pub(super) fn sample(text: &str) -> Vec<&str> {
    let mut lines: Vec<&str> = Vec::new();
    let mut end = 0;
    for line in text.split_inclusive('\n').take(10 * FIRST) {
        end += line.len();
        if !line.trim().is_empty() {
            lines.push(shortened(line));
        }
        if lines.len() == FIRST {
            break;
        }
    }
    let rest = text.len() - end;
    for part in 0..SPREAD * usize::from(rest > 0) {
        let place = end + rest / SPREAD * part;
        let bytes = text.as_bytes().get(place..).unwrap_or_default();
        let Some(start) = bytes.iter().take(100_000).position(|byte| *byte == b'\n').map(|newline| place + newline + 1)
        else {
            continue;
        };
        if let Some(line) =
            text.get(start..).and_then(|rest| rest.lines().next()).filter(|line| !line.trim().is_empty())
        {
            lines.push(shortened(line));
        }
    }
    lines
}

/// Line shortened to a length that suffices for the recognition.
fn shortened(line: &str) -> &str {
    const LONG: usize = 4000;
    let line = line.trim_end_matches(['\n', '\r']);
    &line[..line.floor_char_boundary(LONG)]
}
