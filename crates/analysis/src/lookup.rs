//! Lookup of columns by the text that a user types.

use crate::run_name;
use crate::table::{Column, Table};
use std::fmt;

/// Reason why a column is not found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LookupError {
    /// No column has this name.
    Unknown,
    /// Several columns match; their indices.
    Several(Vec<usize>),
}

impl fmt::Display for LookupError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Unknown => "no column is called so",
            Self::Several(_) => "several columns are called so",
        })
    }
}

impl std::error::Error for LookupError {}

impl Table {
    /// Index of the column that `which` means: by name (`y`), body and name (`mass_A.y`), whole heading (`time_ms`),
    /// number in the file, from 1 (`2`, `#2`, or `##2` beside a column that is named `#2`), body and number (`Run 2.#2`), or
    /// label ([`Table::label`]). Case and a unit after the name may differ if only one name matches. If several bodies have
    /// a column of this name, that of the first is returned.
    ///
    /// # Errors
    /// No column matches, or several do: columns of one name in one body, names that differ only in case, or a name that is
    /// also the number of another column.
    pub fn column(&self, which: &str) -> Result<usize, LookupError> {
        let which = which.trim();
        if which.is_empty() {
            return Err(LookupError::Unknown);
        }
        let same = |name: &str, wanted: &str| name == wanted;
        let alike = |name: &str, wanted: &str| name.to_lowercase() == wanted.to_lowercase();
        let headed = |index: &usize| self.columns.get(*index).is_some_and(|column| column.origin.heading == which);
        let numbered_in_body: Vec<usize> = (0..self.columns.len())
            .filter(|index| {
                let body = self.columns.get(*index).and_then(|column| column.body.as_deref());
                body.is_some_and(|body| is_in_body(which, body, &format!("#{}", self.number(*index)), &same))
            })
            .collect();
        if !numbered_in_body.is_empty() {
            return self.one(numbered_in_body);
        }
        let mut named = self.named(which, &same);
        if let Ok(number) = which.trim_start_matches('#').parse::<usize>() {
            let numbered = (0..self.columns.len()).find(|index| self.number(*index) == number);
            named.extend(numbered.filter(|index| !named.contains(index)));
            // A name and a number that match two columns are ambiguous, whatever their bodies.
            return if named.len() > 1 && numbered.is_some() {
                Err(LookupError::Several(named))
            } else {
                self.one(named)
            };
        }
        for found in [
            named,
            (0..self.columns.len()).filter(headed).collect(),
            self.named(which, &|name, wanted| bare(name) == Some(wanted)),
            self.named(which, &alike),
            self.named(which, &|name, wanted| bare(name).is_some_and(|name| alike(name, wanted))),
        ] {
            if !found.is_empty() {
                return self.one(found);
            }
        }
        // `t #3`, as messages call columns of one name.
        self.labels().iter().position(|label| label == which).ok_or(LookupError::Unknown)
    }

    /// Text that selects only this column: its label if it is one word, or `#` with its number (several `#` if a column is
    /// named so); for runs that follow one another in a file, whose columns have the same numbers, with the name of the
    /// run: `Run 2.#3`.
    pub fn typed(&self, index: usize) -> String {
        let label = self.label(index);
        let number = format!("#{}", self.number(index));
        let is_word = label.chars().all(|letter| letter.is_alphanumeric() || matches!(letter, '_' | '.'));
        let selects = |text: &str| self.column(text) == Ok(index);
        if is_word && selects(&label) {
            return label;
        }
        if selects(&number) {
            return number;
        }
        if let Some(body) = self.columns.get(index).and_then(|column| column.body.as_ref()) {
            return format!("{body}.{number}");
        }
        let signs = |column: &Column| column.name.bytes().take_while(|byte| *byte == b'#').count();
        "#".repeat(self.columns.iter().map(signs).max().unwrap_or(0)) + &number
    }

    /// Columns whose name, or body and name, is `which`.
    fn named(&self, which: &str, same: &dyn Fn(&str, &str) -> bool) -> Vec<usize> {
        let is_named = |index: &usize| {
            self.columns.get(*index).is_some_and(|column| {
                let number = column.name.is_empty().then(|| self.number(*index).to_string());
                let name = number.as_ref().unwrap_or(&column.name);
                (number.is_none() && same(name, which))
                    || column.body.as_deref().is_some_and(|body| is_in_body(which, body, name, same))
            })
        };
        (0..self.columns.len()).filter(is_named).collect()
    }

    /// First of these columns, if all others have the same name in other bodies.
    fn one(&self, found: Vec<usize>) -> Result<usize, LookupError> {
        let first = *found.first().ok_or(LookupError::Unknown)?;
        let of = |index: &usize| self.columns.get(*index).map(|column| (&column.name, &column.body));
        let other_body =
            |index: &usize| of(index).zip(of(&first)).is_some_and(|(own, first)| own.0 == first.0 && own.1 != first.1);
        if found.iter().skip(1).all(other_body) { Ok(first) } else { Err(LookupError::Several(found)) }
    }
}

/// Name without the text in brackets after it: `T` for `T (°C)`.
fn bare(name: &str) -> Option<&str> {
    let (bare, _) = name.split_once(['(', '[', '<', '{'])?;
    Some(bare.trim()).filter(|bare| !bare.is_empty())
}

/// True if `which` is `body.name`.
fn is_in_body(which: &str, body: &str, name: &str, same: &dyn Fn(&str, &str) -> bool) -> bool {
    // Accepts `Run #2.Angle` as well as `Run 2.Angle`.
    let is_body = |first: &str| same(first, body) || run_name::name(first).is_some_and(|run| same(&run, body));
    which.match_indices('.').any(|(dot, _)| is_body(&which[..dot]) && same(name, &which[dot + 1..]))
}
