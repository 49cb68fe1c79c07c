//! `--exclude`: rows that are left out of a fit but kept in the record.

use crate::records::{Measured, find};
use crate::refusal::Refusal;
use analysis::table::Table;
use std::ops::RangeInclusive;

/// Rows named by a text of `--exclude`.
enum Excluded<'a> {
    /// Rows by their numbers, from 1, in the record of this number, from 1; `None` without one.
    Rows(Option<usize>, RangeInclusive<usize>),
    /// Rows in which a column has a value between these ends, in the unit of the column.
    Between(&'a str, f64, f64),
    /// Rows in which a column is not 0.
    Flagged(&'a str),
}

/// One list per record, one entry per row of its table: true for rows that are left out.
///
/// # Errors
/// A text that cannot be read, a column or row that does not exist, or rows by their numbers in several records.
pub fn excluded_rows(data: &[Measured], texts: &[String]) -> Result<Vec<Vec<bool>>, Refusal> {
    let mut found: Vec<Vec<bool>> = data.iter().map(|one| vec![false; one.table.rows()]).collect();
    for text in texts {
        let excluded = read(text)?;
        if let Excluded::Rows(None, _) = excluded
            && data.len() > 1
        {
            return Err(Refusal::with_hint(
                format!("--exclude {text}: there are {} records", data.len()),
                format!("say in which one the rows are, by its place: --exclude 1:{text}"),
            ));
        }
        for (place, (measured, rows)) in data.iter().zip(&mut found).enumerate() {
            match &excluded {
                Excluded::Rows(record, _) if record.is_some_and(|record| record != place + 1) => {}
                Excluded::Rows(_, range) => {
                    let within = rows.get_mut(range.start() - 1..*range.end());
                    let count = measured.table.rows();
                    let message = || format!("--exclude {text}: {} has {count} rows, numbered from 1", measured.name);
                    within.ok_or_else(|| Refusal::request(message()))?.fill(true);
                }
                Excluded::Between(name, low, high) => {
                    let values = column(measured, name, text)?;
                    rows.iter_mut().zip(values).for_each(|(row, value)| *row |= (*low..=*high).contains(value));
                }
                Excluded::Flagged(name) => {
                    let values = column(measured, name, text)?;
                    rows.iter_mut().zip(values).for_each(|(row, value)| *row |= value.is_finite() && *value != 0.0);
                }
            }
        }
        if let Excluded::Rows(Some(record), _) = excluded
            && record > data.len()
        {
            return Err(Refusal::request(format!("--exclude {text}: there are {} records", data.len())));
        }
    }
    Ok(found)
}

/// Values of a column, in its unit.
fn column<'a>(measured: &'a Measured, name: &str, text: &str) -> Result<&'a [f64], Refusal> {
    let table: &Table = &measured.table;
    let index = find(&measured.name, table, name, &|name| {
        let rest = text.split_once('=').map_or(String::new(), |(_, range)| format!("={range}"));
        format!("--exclude {name}{rest}")
    })?;
    Ok(&table.columns[index].values)
}

fn read(text: &str) -> Result<Excluded<'_>, Refusal> {
    let wrong = || {
        Refusal::with_hint(
            format!("--exclude {text} names no rows"),
            "write rows, --exclude 17 or 20..30 (of the second record: 2:20..30), a range of a column, t=1.5..2, or a column that is \
             not 0 in them",
        )
    };
    if let Some((name, range)) = text.split_once('=') {
        let (low, high) = range.split_once("..").ok_or_else(wrong)?;
        let end = |end: &str, open: f64| match end.trim() {
            "" => Ok(open),
            end => end.parse().ok().filter(|end: &f64| end.is_finite()).ok_or_else(wrong),
        };
        let (low, high) = (end(low, f64::NEG_INFINITY)?, end(high, f64::INFINITY)?);
        return if low <= high { Ok(Excluded::Between(name.trim(), low, high)) } else { Err(wrong()) };
    }
    let (record, rows) = match text.split_once(':') {
        Some((record, rows)) => (Some(record), rows),
        None => (None, text),
    };
    let (first, last) = rows.split_once("..").unwrap_or((rows, rows));
    let number = |text: &str| text.trim().parse::<usize>().ok().filter(|number| *number > 0);
    match (record.map(number), number(first), number(last)) {
        (None | Some(Some(_)), Some(first), Some(last)) if first <= last => {
            Ok(Excluded::Rows(record.and_then(number), first..=last))
        }
        // A column is called by its number as `#3`.
        (None, None, None) if !text.trim().is_empty() && text.trim().parse::<usize>().is_err() => {
            Ok(Excluded::Flagged(text.trim()))
        }
        _ => Err(wrong()),
    }
}
