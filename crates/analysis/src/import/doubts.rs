//! Refusals of tables that were read, but hold something that may mean something else.

use super::cells::Delimiter;
use super::format::Format;
use super::head::Head;
use super::refusal::{ImportError, Refusal};
use super::rows::Rows;
use super::settle::ClockColumn;
use crate::roles;

/// Least number of unread cells of a column, or of unread lines, for a refusal.
const SEVERAL: usize = 3;

/// Refuses a column named as a time that holds only words: otherwise the next column would be taken for the time.
pub(super) fn times(heads: &[Head], rows: &Rows) -> Result<(), ImportError> {
    let mut unread = None;
    let columns = heads.iter().zip(&rows.columns).enumerate();
    for (index, (head, values)) in columns.filter(|(_, (head, _))| roles::is_time(&head.name)) {
        if values.iter().any(|value| value.is_finite()) {
            return Ok(());
        }
        unread = unread.or_else(|| rows.first_word(index).map(|(line, text)| (line, head.name.clone(), text)));
    }
    match unread {
        Some((line, column, text)) => Err(ImportError::new(Some(line), Refusal::Times { column, text })),
        None => Ok(()),
    }
}

/// Refuses dates in which day and month cannot be told apart.
pub(super) fn dates(clocks: &[ClockColumn], heads: &[Head], line: usize) -> Result<(), ImportError> {
    let Some(clock) = clocks.iter().find(|clock| clock.times.open) else { return Ok(()) };
    let name = heads.get(clock.column).map_or("", |head| head.name.as_str());
    Err(ImportError::new(Some(line), Refusal::Dates { column: called(name, clock.column) }))
}

/// Refuses more numbers than names between commas, if some commas may be decimal signs or separators of thousands.
pub(super) fn commas(heads: &[Head], rows: &Rows, format: &Format, clocks: usize) -> Result<(), ImportError> {
    let names = heads.iter().take_while(|head| !head.name.is_empty()).count();
    let whole = |values: &Vec<f64>| values.iter().all(|value| value.is_nan() || value.fract() == 0.0);
    let unnamed = heads.iter().skip(names).all(|head| head.name.is_empty());
    if format.delimiter != Delimiter::Comma || names < 2 || rows.columns.len() <= names || !unnamed {
        return Ok(());
    }
    let columns = rows.columns.len();
    // Decimal commas split at least one column, and each column at most once.
    let split = columns - clocks <= 2 * (names - clocks.min(names)) && rows.columns.iter().all(whole);
    let doubled = columns == 2 * names && split;
    let beside_clock = clocks > 0 && split;
    // Commas between thousands make some rows longer than the names: `1,600.00` beside `808.83`.
    let last = rows.columns.last().map_or(0, |values| values.iter().filter(|value| value.is_finite()).count());
    let ragged = last < rows.length && 10 * last > rows.length && rows.columns.iter().any(|values| !whole(values));
    // Times with a decimal point beside decimal commas: `0.5,1,250`.
    let [time, others @ ..] = rows.columns.as_slice() else { return Ok(()) };
    let beside_time = !whole(time) && others.iter().all(whole) && others.len() <= 2 * (names - 1);
    if doubled || beside_clock || beside_time || ragged {
        return Err(ImportError::new(
            Some(format.header_lines + 1),
            Refusal::Commas { names, cells: rows.columns.len() },
        ));
    }
    Ok(())
}

/// Refuses columns of numbers in which more than a tenth of the cells hold digits and no number.
pub(super) fn unread(rows: &Rows, heads: &[Head]) -> Result<(), ImportError> {
    if 10 * rows.unread_lines > rows.length && rows.unread_lines >= SEVERAL {
        let line = rows.word_lines.map(|(line, _)| line);
        return Err(ImportError::new(line, Refusal::UnreadLines { count: rows.unread_lines, rows: rows.length }));
    }
    for (index, (values, others)) in rows.columns.iter().zip(&rows.others).enumerate() {
        let numbers = values.iter().filter(|value| value.is_finite()).count();
        let Some((line, text)) = others.first_digits.clone() else { continue };
        let cells = numbers + others.words;
        if numbers < SEVERAL || others.digits < SEVERAL || 10 * others.digits <= cells {
            continue;
        }
        let name = heads.get(index).map_or("", |head| head.name.as_str());
        let column = called(name, index);
        return Err(ImportError::new(Some(line), Refusal::Unread { column, text, count: others.digits, cells }));
    }
    Ok(())
}

/// Name of a column, or its number in the file.
pub(super) fn called(name: &str, index: usize) -> String {
    if name.is_empty() { (index + 1).to_string() } else { name.to_owned() }
}
