//! Sentences about the computation of a class.

use crate::collection::Collection;
use units::Language;

/// Number of groups, of hand-ins that are still to be computed, and of files that do not count.
pub fn count_text(collection: &Collection, language: Language) -> String {
    let (groups, waiting) = (collection.works().count(), collection.waiting());
    let more = collection.entries().len() - groups - waiting;
    let mut text = language.pick(format!("{groups} groups"), format!("{groups} grupos"));
    if waiting > 0 {
        text += &language.pick(format!(", {waiting} still to be computed"), format!(", {waiting} por calcular"));
    }
    let uncompared = collection.uncompared();
    if waiting == 0 && uncompared > 0 {
        text += &language.pick(
            format!(", looking for shared data: {uncompared} to go"),
            format!(", se buscan datos compartidos: faltan {uncompared}"),
        );
    }
    if more > 0 {
        let rest = language.pick("further files that do not count", "archivos más que no cuentan");
        text += &format!(", {more} {rest}");
    }
    text
}

/// Sentence about the computation while hand-ins are still to be computed: how many are done.
pub fn progress_text(collection: &Collection, language: Language) -> Option<String> {
    let (done, waiting) = (collection.works().count(), collection.waiting());
    let all = done + waiting;
    let text = || {
        language.pick(
            format!("Being computed: {done} of {all} hand-ins are done."),
            format!("Calculando: {done} de {all} entregas están listas."),
        )
    };
    (waiting > 0).then(text)
}
