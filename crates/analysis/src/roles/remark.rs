//! Remarks on unclear roles of columns.

use super::bodies::{is_in_time, is_number};
use super::decide::Decision;
use super::names::tag;
use crate::origin::{Reason, Role};
use crate::table::Table;
use units::{Language, say};

/// Remark for the user on the roles of columns. All names are labels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Remark {
    /// Several columns are clocks: each with the columns that belong to it.
    Clocks(Vec<(String, Vec<String>)>),
    /// A column numbers the rows, and another one is the independent variable.
    RowNumbers {
        /// Column of the row numbers.
        counter: String,
        /// Independent variable.
        variable: String,
    },
    /// A column in a unit of time, or named as a time, is taken as a measured quantity.
    Quantity {
        /// The column.
        column: String,
        /// Its independent variable.
        variable: String,
    },
    /// The document or the user has chosen the independent variables.
    Chosen {
        /// Chosen columns.
        columns: Vec<String>,
        /// True if the document chose them, false for the user.
        by_document: bool,
    },
    /// Several readings are possible: the independent variables of each.
    Readings(Vec<Vec<String>>),
}

impl Remark {
    /// Remark as a sentence in English or Spanish.
    pub fn text(&self, language: Language) -> String {
        match self {
            Self::Clocks(clocks) => {
                const SHOWN: usize = 8;
                let of = |(clock, columns): &(String, Vec<String>)| {
                    let (clock, columns) = (called(clock, language), listed(columns, language));
                    say!(language, "{clock} for {columns}")
                };
                let mut list = clocks.iter().take(SHOWN).map(of).collect::<Vec<_>>().join("; ");
                if clocks.len() > SHOWN {
                    list.push_str("; …");
                }
                say!(language, "there are {} independent variables, each with its own columns: {list}", clocks.len())
            }
            Self::RowNumbers { counter, variable } => {
                let (counter, variable) = (called(counter, language), called(variable, language));
                say!(language, "{counter} numbers the rows; the independent variable is {variable}")
            }
            Self::Quantity { column, variable } => {
                let (column, variable) = (called(column, language), called(variable, language));
                say!(
                    language,
                    "{column} is taken for a measured quantity against {variable}, not for the clock of other columns"
                )
            }
            Self::Chosen { columns, by_document: true } => {
                say!(language, "the independent variable is {}, as in the document", listed(columns, language))
            }
            Self::Chosen { columns, by_document: false } => {
                say!(language, "the independent variable is {}, as chosen", listed(columns, language))
            }
            Self::Readings(readings) => {
                let list: Vec<String> = readings.iter().map(|clocks| reading(clocks, language)).collect();
                say!(
                    language,
                    "the independent variable can be read in {} ways: {}",
                    list.len(),
                    list.join(language.say("; or "))
                )
            }
        }
    }
}

/// Label in a sentence: `column 2` for a number.
fn called(label: &str, language: Language) -> String {
    if label.bytes().all(|byte| byte.is_ascii_digit()) { say!(language, "column {label}") } else { label.to_owned() }
}

fn listed(labels: &[String], language: Language) -> String {
    labels.iter().map(|label| called(label, language)).collect::<Vec<_>>().join(", ")
}

/// Reading in words: `all columns against t`, or `t and t2, each for its own columns`.
pub(crate) fn reading(clocks: &[String], language: Language) -> String {
    match clocks {
        [clock] => {
            let clock = called(clock, language);
            say!(language, "all columns against {clock}")
        }
        _ => say!(language, "{}, each for its own columns", listed(clocks, language)),
    }
}

/// Remarks on a decision. Call it after the roles are assigned.
pub(super) fn remarks(table: &Table, decision: &Decision) -> Vec<Remark> {
    let labels = table.labels();
    let label = |index: usize| labels.get(index).cloned().unwrap_or_default();
    if !decision.readings.is_empty() {
        let named = |clocks: &Vec<usize>| clocks.iter().map(|clock| label(*clock)).collect();
        return vec![Remark::Readings(decision.readings.iter().map(named).collect())];
    }
    let mut remarks = Vec::new();
    let is_of = |index: usize, clock: usize| {
        index != clock
            && table.columns.get(index).is_some_and(|column| column.independent == clock && column.filled() > 0)
    };
    let all = || 0..table.columns.len();
    if decision.clocks.len() > 1 && table.columns.iter().all(|column| column.body.as_deref().is_none_or(is_number)) {
        let mut clocks: Vec<(String, Vec<String>)> =
            decision.clocks.iter().map(|clock| (label(*clock), Vec::new())).collect();
        for (index, column) in table.columns.iter().enumerate() {
            let place = decision.clocks.binary_search(&column.independent).ok();
            if let Some((_, columns)) = place.and_then(|place| clocks.get_mut(place))
                && is_of(index, column.independent)
            {
                columns.push(label(index));
            }
        }
        remarks.push(Remark::Clocks(clocks));
    }
    let [clock] = decision.clocks[..] else { return remarks };
    if decision.reason == Reason::Increases {
        let counters =
            all().filter(|index| table.columns.get(*index).is_some_and(|column| column.origin.role == Role::Counter));
        remarks.extend(counters.map(|counter| Remark::RowNumbers { counter: label(counter), variable: label(clock) }));
    }
    if !matches!(decision.reason, Reason::Name | Reason::Unit) {
        return remarks;
    }
    let is_time = |index: &usize| {
        table.columns.get(*index).is_some_and(|column| {
            let named = tag(&column.name).is_some() && column.unit.is_none();
            is_of(*index, clock) && (named || is_in_time(column))
        })
    };
    remarks
        .extend(all().filter(is_time).map(|index| Remark::Quantity { column: label(index), variable: label(clock) }));
    remarks
}
