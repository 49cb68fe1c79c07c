//! What the residuals say, what was predicted, and what the data cannot tell.

use crate::Report;
use crate::markup::{Page, cell, escaped, symbol};
use crate::words::Words;
use analysis::fit::{Estimate, ObservationFit, Outcome, Verdict};
use units::number::{Group, Style, fixed, near_one, plain, unit_text};

/// The numbers at the head of a report.
pub fn numbers(page: &mut Page, report: &Report<'_>) {
    let words = Words::of(report.language);
    let (outcome, style) = (report.outcome, words.style());
    let mut pair = |term: &str, value: String| {
        page.raw("<div>");
        page.pair(term, &value);
        page.raw("</div>\n");
    };
    pair(words.pick("Values", "Valores"), outcome.n.to_string());
    pair(words.pick("Degrees of freedom", "Grados de libertad"), outcome.dof.to_string());
    pair(words.pick("RMS residual", "Residuo RMS"), rmse(outcome, style));
    if let Some(reduced) = outcome.chi2_reduced {
        pair(words.pick("Reduced χ²", "χ² reducido"), plain(reduced, 3, style));
    }
    match &outcome.reweighted {
        None => pair("R²", near_one(outcome.r2, style)),
        Some(robust) => {
            let scale = with_unit(robust.scale, &outcome.rmse_unit, style);
            pair(words.pick("Median scale of residuals", "Escala mediana de los residuos"), scale);
        }
    }
    if let Some(aicc) = outcome.aicc {
        pair("AICc", fixed(aicc, 1, style));
    }
    pair("BIC", fixed(outcome.bic, 1, style));
}

/// The root mean square of the residuals with its unit.
pub fn rmse(outcome: &Outcome, style: Style) -> String {
    with_unit(outcome.rmse, &outcome.rmse_unit, style)
}

/// A difference of SI size with three digits and a unit that suits it.
pub fn with_unit(si: f64, shown: &units::Unit, style: Style) -> String {
    Group::of_residuals(shown, &[si], 3, style).quantity(si).replace(' ', "\u{a0}")
}

/// Whether the verdict is a warning.
pub fn warns(outcome: &Outcome) -> bool {
    !matches!(outcome.verdict(), Verdict::Exact | Verdict::Compatible | Verdict::Unknown)
        || !outcome.outliers.is_empty()
}

/// What cannot be determined, what was stopped, and whether the search came to its end.
pub fn warnings(page: &mut Page, report: &Report<'_>) {
    let words = Words::of(report.language);
    let outcome = report.outcome;
    let mut sentences: Vec<String> = Vec::new();
    if !outcome.converged {
        sentences.push(escaped(words.pick(
            "The search did not come to its end: these numbers are the best found so far, not a result.",
            "La búsqueda no llegó a su fin: estos números son los mejores encontrados, no un resultado.",
        )));
    }
    sentences.extend(outcome.undetermined.iter().map(|one| escaped(&one.text(words.spanish))));
    let quantity = |one: &Estimate, si: f64| {
        [&plain(one.unit.from_si(si), 5, words.style()), " ", &unit_text(&one.unit.text)].concat().trim_end().to_owned()
    };
    sentences.extend(outcome.rival_text(words.spanish, quantity).map(|text| escaped(&text)));
    let named = |one: &Estimate| match one.record.and_then(|record| report.task.records.get(record)) {
        Some(record) => [&symbol(&one.name), " (", &escaped(&record.name), ")"].concat(),
        None => symbol(&one.name),
    };
    let stopped: Vec<String> =
        outcome.parameters.iter().filter(|one| one.at_bound && one.determined).map(named).collect();
    let end = match stopped.len() {
        0 => "",
        1 => words.pick(
            " stopped at the end of its range. Such a number has no uncertainty, and those of the others suppose it to be right.",
            " se detuvo en el extremo de su intervalo. Un número así no tiene incertidumbre, y las de los demás lo dan por bueno.",
        ),
        _ => words.pick(
            " stopped at the ends of their ranges. Such numbers have no uncertainty, and those of the others suppose them to be right.",
            " se detuvieron en los extremos de sus intervalos. Números así no tienen incertidumbre, y las de los demás los dan por buenos.",
        ),
    };
    if !stopped.is_empty() {
        sentences.push([&words.join(&stopped), end].concat());
    }
    if sentences.is_empty() {
        return;
    }
    page.raw("<div class=\"callout\">");
    sentences.iter().for_each(|sentence| page.wrapped("p", sentence));
    page.raw("</div>\n");
}

/// What the errors mean, and by how much the textbook's are too small.
pub fn errors(page: &mut Page, report: &Report<'_>) {
    let words = Words::of(report.language);
    let outcome = report.outcome;
    let mut text = words
        .pick(
            "The digits in parentheses are the standard error (68 %) in units of the last digits. It allows for residuals that \
             are correlated in time: it is the larger of the error of Newey and West and that of an autoregressive process of \
             order one.",
            "Las cifras entre paréntesis son el error típico (68 %) en unidades de las últimas cifras. Tiene en cuenta que los \
             residuos están correlacionados en el tiempo: es el mayor entre el error de Newey y West y el de un proceso \
             autorregresivo de orden uno.",
        )
        .to_owned();
    let ratios =
        outcome.parameters.iter().filter_map(|one| Some(one.stderr_hac? / one.stderr?)).filter(|r| r.is_finite());
    let (least, greatest) = ratios.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), r| (low.min(r), high.max(r)));
    if greatest > 1.3 {
        let style = words.style();
        let range = if greatest - least < 0.15 {
            fixed(greatest, 1, style)
        } else {
            [&fixed(least, 1, style), words.pick(" to ", " a "), &fixed(greatest, 1, style)].concat()
        };
        text.extend([
            words.pick(" The textbook's formula, for independent residuals, gives errors that are too small by a factor of ", " La fórmula de los libros, para residuos independientes, da errores demasiado pequeños en un factor de "),
            &range,
            ".",
        ]);
    }
    page.element("p class=\"note\"", &text);
}

/// What the residuals say.
pub fn residuals(page: &mut Page, report: &Report<'_>) {
    let words = Words::of(report.language);
    let (outcome, style) = (report.outcome, words.style());
    page.heading(words.pick("What the residuals say", "Qué dicen los residuos"));
    page.element("p", &outcome.verdict_text(words.spanish));
    report.remarks().iter().for_each(|remark| page.element("p", remark));
    page.raw("<dl class=\"steps\">");
    if let Some(runs) = outcome.runs {
        let value = [
            &runs.runs.to_string(),
            words.pick(
                " runs of equal sign, where independent residuals would make ",
                " rachas de igual signo, donde residuos independientes harían ",
            ),
            &fixed(runs.expected, 0, style),
            " (",
            &fixed(runs.z, 1, style),
            words.pick(" standard deviations)", " desviaciones típicas)"),
        ];
        page.pair(words.pick("Signs", "Signos"), &value.concat());
    }
    let value = [
        &fixed(outcome.durbin_watson, 2, style),
        words.pick("; 2 for independent residuals", "; 2 si los residuos son independientes"),
    ];
    page.pair("Durbin-Watson", &value.concat());
    let value = [
        &fixed(outcome.autocorrelation, 2, style),
        words.pick(" between neighbouring residuals", " entre residuos vecinos"),
    ];
    page.pair(words.pick("Correlation", "Correlación"), &value.concat());
    page.raw("</dl>\n");
    if outcome.observations.len() > 1 {
        by_observation(page, report);
    }
}

/// How each observation was fitted, where there are several.
fn by_observation(page: &mut Page, report: &Report<'_>) {
    let words = Words::of(report.language);
    let style = words.style();
    page.table(
        "wide",
        &[
            words.pick("Record", "Registro"),
            words.pick("Observed", "Observado"),
            words.pick("#Values fitted", "#Valores ajustados"),
            words.pick("#Root mean square", "#Media cuadrática"),
            "#R²",
        ],
    );
    for fit in &report.outcome.observations {
        let used = fit.inside.iter().filter(|inside| **inside).count();
        let mut observed = symbol(&fit.name);
        if fit.derived {
            observed += words.pick(
                " <small>computed from another column</small>",
                " <small>calculado a partir de otra columna</small>",
            );
        }
        let cells = [
            escaped(record(report, fit)),
            observed,
            cell(&used.to_string()),
            cell(&with_unit(fit.rmse, &fit.unit, style)),
            cell(&near_one(fit.r2, style)),
        ];
        page.row(&cells.each_ref().map(String::as_str));
    }
    page.end_table();
}

/// The name of the record of an observation.
pub fn record<'a>(report: &Report<'a>, fit: &ObservationFit) -> &'a str {
    report.task.records.get(fit.record).map_or("", |record| &record.name)
}

/// How well the rest was predicted, where a part was fitted.
pub fn prediction(page: &mut Page, report: &Report<'_>) {
    let words = Words::of(report.language);
    let style = words.style();
    let outside: Vec<&ObservationFit> =
        report.outcome.observations.iter().filter(|fit| fit.outside.is_some()).collect();
    if outside.is_empty() {
        return;
    }
    page.heading(words.pick("Prediction", "Predicción"));
    let text = words.pick(
        "Values outside the fitted part had no say in the fit. How well they are met tells a theory from a flexible curve.",
        "Los valores fuera de la parte ajustada no intervinieron en el ajuste. Lo bien que se aciertan distingue una teoría de \
         una curva flexible.",
    );
    page.element("p", text);
    page.table(
        "wide",
        &[
            words.pick("Record", "Registro"),
            words.pick("Observed", "Observado"),
            words.pick("#Values predicted", "#Valores predichos"),
            words.pick("#Root mean square there", "#Media cuadrática allí"),
            words.pick("#in the fitted part", "#en la parte ajustada"),
            words.pick("#Ratio", "#Cociente"),
        ],
    );
    for fit in outside {
        let Some(outside) = fit.outside else { continue };
        let cells = [
            escaped(record(report, fit)),
            symbol(&fit.name),
            cell(&outside.n.to_string()),
            cell(&with_unit(outside.rmse, &fit.unit, style)),
            cell(&with_unit(fit.rmse, &fit.unit, style)),
            cell(&fixed(outside.rmse / fit.rmse, 2, style)),
        ];
        page.row(&cells.each_ref().map(String::as_str));
    }
    page.end_table();
}
