//! Remarks about a fit besides its numbers: scales of films, outliers, and records that are short for the correlation
//! of their errors.

use crate::outliers::{outliers, sigmas};
use crate::written::of_record;
use analysis::fit::{Estimate, FilmScale, Loss, Outcome, Task};
use units::number::{Group, fixed, plain};
use units::{Language, Unit};

/// Sentences that are no doubts. `independent`: name and unit of the independent variable.
pub fn remarks(outcome: &Outcome, task: &Task, independent: (&str, &Unit), language: Language) -> Vec<String> {
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
            language.say(" It is "),
            &sigmas(away, language.style()),
            language.say(
                " standard errors of the calibration away from 1: check the length that calibrates the film, and the theory.",
            ),
        ];
        let contradiction = if away.abs() > CONTRADICTS { contradiction.concat() } else { String::new() };
        [
            record.as_str(),
            language.say("Scale of the film "),
            &group.with_error(scale.value, error),
            language.say(" (prior 1 ± "),
            &plain(scale.prior, 2, language.style()),
            language.say("); the standard errors of lengths include it."),
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
    let mut text = [language.say("Fitted with "), robust.loss.name(language), ": "].concat();
    let [less, half, count] = [robust.less, robust.half, robust.count].map(|count| count.to_string());
    let of_all = [language.say(" of "), &count, language.say(" values")].concat();
    match robust.loss {
        // Tukey's loss reduces the weight of all values, so only weights below one half are counted.
        Loss::Squares | Loss::Tukey => {
            text.extend([language.say("the weight is below one half for "), &half, &of_all, "."])
        }
        Loss::Huber => text.extend([
            language.say("the weight is reduced for "),
            &less,
            &of_all,
            language.say(" (of normal residuals, for 18 %), and below one half for "),
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
            language.say(" Against least squares "),
            &name,
            language.say(" changes most, by "),
            &sigmas(most, style),
            language.say(" standard errors."),
        ]);
    }
    text.push_str(language.say(" The RMS residual is that of all values; R² and χ² do not apply."));
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
                .say(
                    "The record is too short to tell its errors from a random walk: the true standard errors can be larger than those stated.",
                )
                .to_owned(),
        );
    }
    let certain = outcome.parameters.iter().filter(|one| one.stderr_hac.is_some());
    let factor = certain.map(|one| one.coverage_factor()).fold(2.0, f64::max);
    let text = [
        language.say("The record is short for the correlation of its errors: its "),
        &outcome.judged.to_string(),
        language.say(" values are worth about "),
        &fixed(outcome.independent, 0, style),
        language
            .say(" independent ones. The standard errors are uncertain themselves: an interval of 95 % reaches up to "),
        &fixed(factor, 1, style),
        language.say(" of them to either side (Student's t)."),
    ];
    Some(text.concat())
}
