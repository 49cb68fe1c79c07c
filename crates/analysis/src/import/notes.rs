//! Notes on a table as a whole, for the user.

use super::clock::Form;
use super::settle::ClockColumn;
use crate::error_name::{self, Belongs};
use crate::finding::{Finding, Heading};
use crate::table::Table;
use std::collections::BTreeMap;

/// Upper bound of the reported findings about columns.
pub(super) const FINDINGS: usize = 20;

/// Notes on columns taken as the standard errors of others, and on columns that only have such a name. `sigma_y` beside `y`
/// is not reported.
pub(super) fn errors(table: &Table) -> Vec<Heading> {
    let mut said = Vec::new();
    let mut named: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (index, column) in table.columns.iter().enumerate() {
        named.entry(&column.name).or_default().push(index);
    }
    for (index, column) in table.columns.iter().enumerate() {
        let Some(belongs) = error_name::of(&column.name) else { continue };
        if said.len() >= FINDINGS {
            break;
        }
        let owners: Vec<usize> = match belongs {
            Belongs::To(name) | Belongs::Perhaps(name) => {
                named.get(name).into_iter().flatten().copied().filter(|own| *own != index).collect()
            }
            Belongs::ToPrevious => index.checked_sub(1).into_iter().collect(),
        };
        let owner = owners.iter().copied().find(|own| table.errors_of(*own) == Some(index));
        let called = owners.first().copied();
        let label = table.label(index);
        match (owner, called, belongs) {
            (Some(own), _, _) => {
                let unused = table.columns[own].independent == own;
                if unused || column.name != format!("sigma_{}", table.columns[own].name) {
                    said.push(Heading::Errors { column: label, of: table.label(own), unused });
                }
            }
            (None, Some(own), _) => said.push(Heading::NotErrors { column: label, of: Some(table.label(own)) }),
            (None, None, Belongs::To(_)) => said.push(Heading::NotErrors { column: label, of: None }),
            (None, None, _) => {}
        }
    }
    said
}

/// Note on a column of clock times.
pub(super) fn clock_finding(clock: &ClockColumn, column: String) -> Finding {
    Finding::Clock {
        column,
        days: clock.form == Form::Date,
        wrapped: clock.times.wrapped,
        minutes: clock.times.guessed,
        month_first: clock.times.month_first,
    }
}

/// Note on the runs of a logger, if there are several.
pub(super) fn runs_finding(table: &Table) -> Option<Finding> {
    let runs: Vec<String> = table.runs().into_iter().map(|(name, _)| name).collect();
    (runs.len() > 1).then_some(Finding::Runs(runs))
}
