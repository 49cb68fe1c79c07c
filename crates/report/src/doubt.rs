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
    let text = language.pick(
        "The fitted curve oscillates faster than the sampling can show: it turns more than once between two values. A slower \
         oscillation can pass through the same values (aliasing). Give the frequency a start value or a range below half the \
         sampling rate, and fit again.",
        "La curva ajustada oscila más rápido de lo que el muestreo puede mostrar: cambia de sentido más de una vez entre dos valores. \
         Una oscilación más lenta puede pasar por los mismos valores (aliasing). Da a la frecuencia un valor inicial o un intervalo por \
         debajo de la mitad de la frecuencia de muestreo y ajusta de nuevo.",
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
        language.pick::<&str>(
            " is in doubt: it stands at an end of the range in which it was searched, and a better value may lie beyond. It has no \
             standard error, and those of the other parameters take it for exact. Widen its range, or check the theory and the units.",
            " es dudoso: está en un extremo del intervalo en que se buscó, y puede haber un valor mejor más allá. No tiene error estándar, \
             y los de los demás parámetros lo toman por exacto. Amplía su intervalo o revisa la teoría y las unidades.",
        ),
    ]
    .concat()
}
