//! Remarks about a fit besides its numbers: scales of films, outliers, and records that are short for the correlation
//! of their errors.

use crate::doubt;
use crate::outliers::{outliers, sigmas};
use crate::written::of_record;
use analysis::fit::{Estimate, FilmScale, Loss, Outcome, Task};
use units::number::{Group, fixed, plain};
use units::{Language, Unit};

/// Sentences in English or Spanish, with doubts about the results first. `independent`: name and unit of the
/// independent variable.
pub fn remarks(outcome: &Outcome, task: &Task, independent: (&str, &Unit), language: Language) -> Vec<String> {
    let doubts = doubt::doubts(outcome, task, independent, language);
    doubts.into_iter().chain(beside(outcome, task, independent, language)).collect()
}

/// Remarks as in [`remarks`], without the doubts.
pub fn beside(outcome: &Outcome, task: &Task, independent: (&str, &Unit), language: Language) -> Vec<String> {
    let outliers = outliers(outcome, task, independent, language).filter(|_| !outcome.misled);
    let sentences = [loss(outcome, language), outliers, short(outcome, language)];
    scales(outcome, task, language).into_iter().chain(sentences.into_iter().flatten()).collect()
}

/// Deviation of a film's scale from 1, in standard errors of its calibration, beyond which they contradict each other.
const CONTRADICTS: f64 = 3.0;

/// Sentences about the scales of films: `Scale of the film 1.0003 ± 0.0012 (prior 1 ± 0.0015)`, and whether it
/// contradicts the prior.
fn scales(outcome: &Outcome, task: &Task, language: Language) -> Vec<String> {
    let sentence = |scale: &FilmScale| {
        let error = scale.stderr.unwrap_or(scale.prior);
        let group = Group::of_errors(&Unit::dimensionless(), &[(scale.value, error)], language.style());
        let record = of_record(Some(scale.record), task);
        let away = (scale.value - 1.0) / scale.prior;
        let contradiction = [
            language.pick::<&str>(" It is ", " Está a "),
            &sigmas(away, language.style()),
            language.pick(
                " standard errors of the calibration away from 1: check the length that calibrates the film, and the theory.",
                " errores estándar de la calibración de 1: revisa la longitud que calibra el vídeo, y la teoría.",
            ),
        ];
        let contradiction = if away.abs() > CONTRADICTS { contradiction.concat() } else { String::new() };
        [
            record.as_str(),
            language.pick::<&str>("Scale of the film ", "Escala del vídeo: "),
            &group.with_error(scale.value, error),
            language.pick::<&str>(" (prior 1 ± ", " (a priori 1 ± "),
            &plain(scale.prior, 2, language.style()),
            language.pick::<&str>(
                "); the standard errors of lengths include it.",
                "); los errores estándar de las longitudes lo incluyen.",
            ),
            &contradiction,
        ]
        .concat()
    };
    outcome.scales.iter().map(sentence).collect()
}

/// Sentence about the effect of a robust loss: the number of values with reduced weight, and the largest change of an
/// estimate.
fn loss(outcome: &Outcome, language: Language) -> Option<String> {
    let robust = outcome.reweighted.as_ref()?;
    let style = language.style();
    let mut text = [language.pick("Fitted with ", "Ajustado con "), robust.loss.name(language), ": "].concat();
    let [less, half, count] = [robust.less, robust.half, robust.count].map(|count| count.to_string());
    let of_all = [language.pick::<&str>(" of ", " de "), &count, language.pick(" values", " valores")].concat();
    match robust.loss {
        // Tukey's loss reduces the weight of all values, so only weights below one half are counted.
        Loss::Squares | Loss::Tukey => text.extend([
            language.pick::<&str>("the weight is below one half for ", "el peso es menor que la mitad para "),
            &half,
            &of_all,
            ".",
        ]),
        Loss::Huber => text.extend([
            language.pick::<&str>("the weight is reduced for ", "el peso es menor para "),
            &less,
            &of_all,
            language.pick(
                " (of normal residuals, for 18 %), and below one half for ",
                " (con residuos normales, para el 18 %) y menor que la mitad para ",
            ),
            &half,
            ".",
        ]),
    }
    let change = |(one, least): (&Estimate, &f64)| {
        let error = one.stderr_hac.filter(|error| *error > 0.0)?;
        Some((one.name.clone(), (one.value - least) / error))
    };
    let changes = outcome.parameters.iter().zip(&robust.least_squares).filter_map(change);
    if let Some((name, most)) = changes.max_by(|one, other| one.1.abs().total_cmp(&other.1.abs())) {
        text.extend([
            language.pick(" Against least squares ", " Frente a los mínimos cuadrados, "),
            &name,
            language.pick(" changes most, by ", " es lo que más cambia, en "),
            &sigmas(most, style),
            language.pick(" standard errors.", " errores estándar."),
        ]);
    }
    text.push_str(language.pick(
        " The RMS residual is that of all values; R² and χ² do not apply.",
        " El residuo RMS es el de todos los valores; R² y χ² no proceden.",
    ));
    Some(text)
}

/// Warning that the standard errors are uncertain; `None` if the record is long enough.
fn short(outcome: &Outcome, language: Language) -> Option<String> {
    if !outcome.is_short() {
        return None;
    }
    let style = language.style();
    if outcome.wanders {
        return Some(
            language
                .pick(
                    "The errors cannot be told from a random walk in so short a record: take the standard errors for lower limits.",
                    "En un registro tan corto los errores no se distinguen de un paseo aleatorio: toma los errores estándar por \
                     límites inferiores.",
                )
                .to_owned(),
        );
    }
    let certain = outcome.parameters.iter().filter(|one| one.stderr_hac.is_some());
    let factor = certain.map(|one| one.coverage_factor()).fold(2.0, f64::max);
    let text = [
        language.pick(
            "The record is short for the correlation of its errors: its ",
            "El registro es corto para la correlación de sus errores: sus ",
        ),
        &outcome.judged.to_string(),
        language.pick(" values are worth about ", " valores equivalen a unos "),
        &fixed(outcome.independent, 0, style),
        language.pick(
            " independent ones. The standard errors are uncertain themselves: an interval of 95 % reaches up to ",
            " independientes. Los propios errores estándar son inciertos: un intervalo del 95 % llega hasta ",
        ),
        &fixed(factor, 1, style),
        language.pick(" of them to either side (Student's t).", " de ellos a cada lado (t de Student)."),
    ];
    Some(text.concat())
}
