//! Search for the first row, at the end of the header.

use super::cells::Cells;
use super::format::{Format, Kind, kind, sample};
use super::refusal::{ImportError, Refusal};
use super::{cells::Delimiter, rows};

/// Greatest length of a header in bytes. If it contains no full row, the first line that could be a row begins the table.
const LONGEST_HEADER: usize = 1 << 20;

/// Position of the first row.
#[derive(Clone, Copy, Debug)]
pub(super) struct First {
    /// Number of lines before it.
    pub line: usize,
    /// Number of bytes before it.
    pub offset: usize,
}

/// Finds the first row: a header has words in the columns where the rows have numbers. A word among the numbers of a row, a
/// remark beside them or a failed formula does not make it a header.
pub(super) fn row(text: &str, format: &Format) -> Result<First, ImportError> {
    let numeric = numeric_columns(text, format);
    let mut offset = 0;
    let mut named = false;
    // Rows with gaps or words directly before the first full row belong to the table too.
    let mut odd = None;
    let mut first_odd = None;
    for (line, content) in text.split_inclusive('\n').enumerate() {
        let kinds = kinds(content.trim_end_matches(['\n', '\r']), format);
        let here = First { line, offset };
        match judge(&kinds, &numeric, named, format.delimiter) {
            Judgement::Row => return Ok(odd.unwrap_or(here)),
            Judgement::Odd => {
                odd.get_or_insert(here);
                first_odd.get_or_insert(here);
            }
            Judgement::Header => odd = None,
        }
        named |= kinds.iter().filter(|kind| **kind == Kind::Word).count() >= 2;
        offset += content.len();
        if offset > LONGEST_HEADER {
            break;
        }
    }
    // No row is full.
    first_odd.filter(|_| numeric.iter().filter(|numeric| **numeric).count() >= 2).ok_or_else(|| none(text, format))
}

/// Judgement of a line before the first full row.
enum Judgement {
    Row,
    /// Row with gaps or words, if a full one follows.
    Odd,
    Header,
}

fn judge(kinds: &[Kind], numeric: &[bool], named: bool, delimiter: Delimiter) -> Judgement {
    let cells = || kinds.iter().zip(numeric).filter(|(_, numeric)| **numeric).map(|(kind, _)| *kind);
    let count = |wanted: Kind| cells().filter(|kind| *kind == wanted).count();
    let (numbers, words) = (count(Kind::Number), count(Kind::Word));
    if numbers >= 2 && words == 0 {
        return Judgement::Row;
    }
    let begins_with_word = cells().next() == Some(Kind::Word);
    let blanks = matches!(delimiter, Delimiter::Blanks | Delimiter::Blank);
    // Without names above it, `trial;1;2;3` is a header that names columns by numbers. A title split at blanks has cells
    // too: `12 May 2024`.
    let title = !named && (begins_with_word || (blanks && words > 0));
    if numbers >= 1 && numbers >= words && kinds.len() >= 2 && !title { Judgement::Odd } else { Judgement::Header }
}

fn kinds(line: &str, format: &Format) -> Vec<Kind> {
    Cells::of(line, format.delimiter).map(|cell| kind(cell, format.delimiter, format.signs(), true)).collect()
}

/// One per column: true if it holds numbers in most of the lines that could be rows.
fn numeric_columns(text: &str, format: &Format) -> Vec<bool> {
    let mut counts: Vec<(usize, usize)> = Vec::new();
    for line in sample(text) {
        let kinds = kinds(line, format);
        if kinds.iter().filter(|kind| **kind == Kind::Number).count() < 2 {
            continue;
        }
        if counts.len() < kinds.len() {
            counts.resize(kinds.len(), (0, 0));
        }
        for (count, kind) in counts.iter_mut().zip(kinds) {
            count.0 += usize::from(kind == Kind::Number);
            count.1 += usize::from(kind == Kind::Word);
        }
    }
    // A column filled in only a line or two belongs to a header: `Start,Increment` over `-0.006,0.002`.
    let most = counts.iter().map(|(numbers, _)| *numbers).max().unwrap_or(0);
    counts.into_iter().map(|(numbers, words)| numbers > 0 && numbers >= words && 20 * numbers >= most).collect()
}

/// Error for a text without rows.
fn none(text: &str, format: &Format) -> ImportError {
    let lonely = text.lines().take(10_000).position(|line| kinds(line, format) == [Kind::Number]);
    if let Some(line) = lonely {
        return ImportError::new(Some(line + 1), Refusal::OneColumn);
    }
    let delimiters = [format.delimiter, Delimiter::Tab, Delimiter::Semicolon, Delimiter::Comma];
    if let Some(error) = delimiters.into_iter().find_map(|delimiter| beside(text, &Format { delimiter, ..*format })) {
        return error;
    }
    let (line, text) = text.lines().enumerate().find(|(_, text)| !text.trim().is_empty()).unwrap_or((0, ""));
    ImportError::new(Some(line + 1), Refusal::NoNumbers { text: rows::excerpt(text.trim()) })
}

/// Error for the first cell beside a number that is not a number itself, if most lines below the first have both.
fn beside(text: &str, format: &Format) -> Option<ImportError> {
    let (mut lines, mut found, mut first) = (0, 0, None);
    for (line, content) in text.lines().enumerate().skip(1).take(200).filter(|(_, content)| !content.trim().is_empty())
    {
        lines += 1;
        let kinds = kinds(content, format);
        let place = |wanted: Kind| kinds.iter().position(|kind| *kind == wanted);
        let (Some(_), Some(column)) = (place(Kind::Number), place(Kind::Word)) else { continue };
        found += 1;
        first.get_or_insert_with(|| {
            let cell = Cells::of(content, format.delimiter).nth(column).unwrap_or_default();
            ImportError::new(Some(line + 1), Refusal::Cell { column: column + 1, text: rows::excerpt(cell) })
        });
    }
    first.filter(|_| 2 * found > lines)
}
