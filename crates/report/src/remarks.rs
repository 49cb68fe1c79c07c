//! What has to be known beside the numbers of a fit: the scales of films, values that are off, and a record too short for its
//! correlation.

use crate::doubt;
use analysis::fit::{Estimate, FilmScale, Loss, Outcome, Outlier, Task};
use units::number::{Group, fixed, plain, with_unit};
use units::{Language, Unit};

/// No more outliers than this are named one by one, those farthest off.
const NAMED: usize = 5;

/// Sentences in English or Spanish, doubts about the numbers first; `independent` is the name and the unit of the independent variable.
pub fn remarks(outcome: &Outcome, task: &Task, independent: (&str, &Unit), language: Language) -> Vec<String> {
    let doubts = doubt::doubts(outcome, task, language);
    doubts.into_iter().chain(beside(outcome, task, independent, language)).collect()
}

/// The same without doubts about the numbers.
pub fn beside(outcome: &Outcome, task: &Task, independent: (&str, &Unit), language: Language) -> Vec<String> {
    let sentences = [loss(outcome, language), outliers(outcome, task, independent, language), short(outcome, language)];
    scales(outcome, task, language).into_iter().chain(sentences.into_iter().flatten()).collect()
}

/// `Scale of the film 1.0003 ± 0.0012 (prior ± 0.0015)`
fn scales(outcome: &Outcome, task: &Task, language: Language) -> Vec<String> {
    let sentence = |scale: &FilmScale| {
        let error = scale.stderr.unwrap_or(scale.prior);
        let group = Group::of_errors(&Unit::dimensionless(), &[(scale.value, error)], language.style());
        let record = task.records.get(scale.record).filter(|_| task.records.len() > 1);
        let record = record.map_or_else(String::new, |record| [&record.name, ": "].concat());
        [
            record.as_str(),
            language.pick::<&str>("Scale of the film ", "Escala del vídeo: "),
            &group.with_error(scale.value, error),
            language.pick::<&str>(" (prior ± ", " (a priori ± "),
            &plain(scale.prior, 2, language.style()),
            language.pick::<&str>(
                "); the standard errors of lengths include it.",
                "); los errores estándar de las longitudes lo incluyen.",
            ),
        ]
        .concat()
    };
    outcome.scales.iter().map(sentence).collect()
}

/// What a robust loss has changed: how many values count less, and the greatest change of a number.
fn loss(outcome: &Outcome, language: Language) -> Option<String> {
    let robust = outcome.reweighted.as_ref()?;
    let style = language.style();
    let of_normal = match robust.loss {
        Loss::Squares | Loss::Tukey => "",
        Loss::Huber => language.pick(" (of normal residuals, 18 % would)", " (con residuos normales sería el 18 %)"),
    };
    let mut text = [
        language.pick("Fitted with ", "Ajustado con "),
        robust.loss.name(language),
        ": ",
        &robust.less.to_string(),
        language.pick(" of ", " de "),
        &robust.count.to_string(),
        language.pick(" values count less", " valores cuentan menos"),
        of_normal,
        ", ",
        &robust.half.to_string(),
        language.pick(" less than half.", " menos de la mitad."),
    ]
    .concat();
    let change = |(one, least): (&Estimate, &f64)| {
        let error = one.stderr_hac.filter(|error| *error > 0.0)?;
        Some((one.name.clone(), (one.value - least) / error))
    };
    let changes = outcome.parameters.iter().zip(&robust.least_squares).filter_map(change);
    if let Some((name, most)) = changes.max_by(|one, other| one.1.abs().total_cmp(&other.1.abs())) {
        let sign = if most < 0.0 { "−" } else { "+" };
        text.extend([
            language.pick(" Against least squares ", " Frente a los mínimos cuadrados, "),
            &name,
            language.pick(" changes most, by ", " es lo que más cambia, en "),
            sign,
            &fixed(most.abs(), 1, style),
            language.pick(" standard errors.", " errores estándar."),
        ]);
    }
    text.push_str(language.pick(
        " The RMS residual is that of all values; R² and χ² do not apply.",
        " El residuo RMS es el de todos los valores; R² y χ² no proceden.",
    ));
    Some(text)
}

/// `y = 3.2 cm at t = 1.4 s (+21 standard deviations from the others)`
fn outliers(outcome: &Outcome, task: &Task, independent: (&str, &Unit), language: Language) -> Option<String> {
    let mut farthest: Vec<&Outlier> = outcome.outliers.iter().collect();
    farthest.sort_by(|one, other| other.sigmas.abs().total_cmp(&one.sigmas.abs()));
    let style = language.style();
    let quantity = |name: &str, si: f64, shown: &Unit| {
        let number = plain(shown.from_si(si), 5, style);
        [name, " = ", &with_unit(&number, shown)].concat()
    };
    let named = |one: &&Outlier| {
        let fit = outcome.outlying(one)?;
        let value = quantity(&fit.name, *fit.measured.get(one.row)?, &fit.unit);
        let time = quantity(independent.0, *fit.times.get(one.row)?, independent.1);
        let record = task.records.get(one.record).filter(|_| task.records.len() > 1);
        let record = record.map_or_else(String::new, |record| [&record.name, ": "].concat());
        let sign = if one.sigmas > 0.0 { "+" } else { "−" };
        let sigmas = fixed(one.sigmas.abs(), if one.sigmas.abs() < 10.0 { 1 } else { 0 }, style);
        Some([&record, &value, language.pick::<&str>(" at ", " en "), &time, " (", sign, &sigmas, " σ)"].concat())
    };
    let mut list: Vec<String> = farthest.iter().take(NAMED).filter_map(named).collect();
    if list.is_empty() {
        return None;
    }
    let more = farthest.len().saturating_sub(NAMED);
    if more > 0 {
        list.push([&more.to_string(), language.pick::<&str>(" more", " más")].concat());
    }
    let squares = outcome.reweighted.is_none();
    let (head, advice) = if farthest.len() == 1 {
        (
            language.pick("One value is an outlier: ", "Un valor es atípico: "),
            language.pick(
                "; σ is the scatter of the others. Check it, or fit with a robust loss.",
                "; σ es la dispersión de los demás. Revíselo o ajuste con una pérdida robusta.",
            ),
        )
    } else {
        (
            language.pick(" values are outliers: ", " valores son atípicos: "),
            language.pick(
                "; σ is the scatter of the others. Check them, or fit with a robust loss.",
                "; σ es la dispersión de los demás. Revíselos o ajuste con una pérdida robusta.",
            ),
        )
    };
    let count = if farthest.len() == 1 { String::new() } else { farthest.len().to_string() };
    let advice = if squares {
        advice
    } else {
        language.pick("; σ is the scatter of the others.", "; σ es la dispersión de los demás.")
    };
    Some([&count, head, &language.join(&list), advice].concat())
}

/// That standard errors are uncertain themselves.
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
                    "En un registro tan corto los errores no se distinguen de un paseo aleatorio: tome los errores estándar por \
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
