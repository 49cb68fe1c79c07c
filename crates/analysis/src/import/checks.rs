//! Refusals of a table whose reading would be wrong.

use super::cells::Delimiter;
use super::format::Format;
use super::head::Head;
use super::refusal::{ImportError, Refusal};
use super::rows::Rows;
use crate::roles;

/// Refuses a column named as a time that holds only words: otherwise the next column would be taken for the time.
pub(super) fn refuse_unread_times(heads: &[Head], rows: &Rows) -> Result<(), ImportError> {
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

/// Refuses two names over four numbers with commas everywhere: some commas may be decimal signs.
pub(super) fn refuse_double_commas(heads: &[Head], rows: &Rows, format: &Format) -> Result<(), ImportError> {
    let names = heads.iter().take_while(|head| !head.name.is_empty()).count();
    let whole = |values: &Vec<f64>| values.iter().all(|value| value.is_nan() || value.fract() == 0.0);
    if format.delimiter == Delimiter::Comma
        && names >= 2
        && rows.columns.len() == 2 * names
        && heads.iter().skip(names).all(|head| head.name.is_empty())
        && rows.columns.iter().all(whole)
    {
        return Err(ImportError::new(
            Some(format.header_lines + 1),
            Refusal::Commas { names, cells: rows.columns.len() },
        ));
    }
    Ok(())
}
