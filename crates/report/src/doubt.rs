//! A doubt about the numbers of a fit themselves: a best value at an end of the range in which it was searched.

use analysis::fit::{Estimate, Outcome, Task};
use units::Language;
use units::number::{plain, with_unit};

/// A sentence for each number that the end of its range has stopped.
pub fn at_ends(outcome: &Outcome, task: &Task, language: Language) -> Vec<String> {
    outcome.stopped().map(|one| at_end(one, task, language)).collect()
}

fn at_end(one: &Estimate, task: &Task, language: Language) -> String {
    let record = one.record.and_then(|record| task.records.get(record)).filter(|_| task.records.len() > 1);
    let record = record.map_or_else(String::new, |record| [&record.name, ": "].concat());
    let value = with_unit(&plain(one.unit.from_si(one.value), 5, language.style()), &one.unit);
    [
        &record,
        &one.name,
        " = ",
        &value,
        language.pick::<&str>(
            " is in doubt: it stands at an end of the range in which it was searched, and a better value may lie beyond. It has no \
             standard error, and those of the other parameters take it for exact. Widen its range, or check the theory and the units.",
            " es dudoso: está en un extremo del intervalo en que se buscó, y puede haber un valor mejor más allá. No tiene error estándar, \
             y los de los demás parámetros lo toman por exacto. Amplíe su intervalo o revise la teoría y las unidades.",
        ),
    ]
    .concat()
}
