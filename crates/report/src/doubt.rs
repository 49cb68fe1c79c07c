//! Doubts about the results of a fit: dominating outliers, a best value at the bound of its search range, and a fitted
//! curve that oscillates faster than the sampling can show.

use crate::outliers::outliers;
use crate::written::{of_record, quantity};
use analysis::fit::{Estimate, Outcome, Task};
use units::{Language, Unit};

/// Sentences about outliers that dominate the fit, about each estimate at a bound of its range, and about each
/// undersampled record. `independent`: name and unit of the independent variable.
pub fn doubts(outcome: &Outcome, task: &Task, independent: (&str, &Unit), language: Language) -> Vec<String> {
    let misled = outliers(outcome, task, independent, language).filter(|_| outcome.misled);
    let at_ends = outcome.stopped().map(|one| at_end(one, task, language));
    let undersampled = outcome.undersampled.iter().map(|&record| undersampled(record, task, language));
    misled.into_iter().chain(at_ends).chain(undersampled).collect()
}

fn undersampled(record: usize, task: &Task, language: Language) -> String {
    let text = language.say(
        "The fitted curve oscillates faster than the sampling can show: it turns more than once between two values. A slower \
         oscillation can pass through the same values (aliasing). Give the frequency a start value or a range below half the \
         sampling rate, and fit again.",
    );
    [&of_record(Some(record), task), text].concat()
}

fn at_end(one: &Estimate, task: &Task, language: Language) -> String {
    let record = of_record(one.record, task);
    let value = quantity(one.value, &one.unit, language.style());
    [
        &record,
        &one.name,
        " = ",
        &value,
        language.say(" is in doubt: it stands at an end of the range in which it was searched, and a better value may lie beyond. It has no \
             standard error, and those of the other parameters take it for exact. Widen its range, or check the theory and the units."),
    ]
    .concat()
}
