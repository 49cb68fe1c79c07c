//! Several theories of the same data, best first.

use super::fitted::{Fitted, Theory};
use super::json::fit_as_json;
use super::settings::FitSettings;
use super::task::task;
use crate::records::Measured;
use crate::refusal::Refusal;
use crate::values::Reader;
use analysis::fit::{Outcome, Outside, Ranked, ties, worth};
use serde_json::{Value, json};
use units::{Language, Words};

/// Fit of a theory, and its prediction from the beginning of the data.
#[derive(Debug)]
pub struct Contender {
    /// The fit.
    pub fitted: Fitted,
    /// Errors of the first observation: of the whole fit before and after the time from which on is predicted, and of the
    /// prediction after it. `None` without such a time.
    pub parts: Option<[Outside; 3]>,
}

impl Contender {
    /// Fits a theory to data. `predict_from`: time from which on the values are also predicted from those before. `note` gets
    /// remarks about the data, `progress` the number of trials after each; it ends the fit by false.
    ///
    /// # Errors
    /// As [`task`] and [`Fitted::complete`]; and no value after `predict_from`.
    pub fn complete(
        mut theory: Theory,
        data: &[Measured],
        (settings, predict_from): (&FitSettings, Option<&str>),
        note: &mut dyn FnMut(&Words),
        progress: &mut dyn FnMut(usize) -> bool,
    ) -> Result<Self, Refusal> {
        let mut asked = task(&mut theory.document, data, settings, note)?;
        let Some(text) = predict_from else {
            return Ok(Self { fitted: Fitted::complete(theory, asked, false, progress)?, parts: None });
        };
        let time = theory.document.program.model.independent.unit.clone();
        let moment = Reader { model: &mut theory.document.program.model }.value(
            "--predict-from",
            text,
            &time,
            &asked.task.parameters.clone(),
        )?;
        let mut fitted = Fitted::complete(theory.clone(), asked.clone(), false, progress)?;
        // Values exactly at the time are predicted.
        asked.task.until = Some(moment - 1e-9 * moment.abs().max(1e-9));
        let predicted = Fitted::complete(theory, asked, false, progress)?;
        let (whole, after) = (&fitted.task, |time| time >= moment);
        let before = error(&fitted, |time| whole.covers(time) && !after(time));
        let rest = |time| whole.covers(time) && after(time);
        let after = error(&fitted, rest);
        if after.n == 0 {
            return Err(Refusal::with_hint(
                format!("--predict-from {text}: no value is measured from there on"),
                "give a time before the end of the records",
            ));
        }
        let prediction = error(&predicted, rest);
        // The report shows the prediction in the place of the values outside a fitted part.
        for (own, predicted) in fitted.outcome.observations.iter_mut().zip(&predicted.outcome.observations) {
            own.outside = Some(predicted.error_where(|time, _| rest(time))).filter(|part| part.n > 0);
        }
        Ok(Contender { fitted, parts: Some([before, after, prediction]) })
    }
}

/// Root mean square of the first observation's residuals at times that satisfy `inside`, over all records.
fn error(fitted: &Fitted, inside: impl Fn(f64) -> bool) -> Outside {
    let first = fitted.outcome.observations.iter().filter(|one| one.observation == 0);
    Outside::together(first.map(|one| one.error_where(|time, _| inside(time))))
}

/// One sentence per place that several theories share.
pub fn tied(contenders: &[Contender], ranked: &[Ranked]) -> Vec<(usize, String)> {
    let outcomes: Vec<&Outcome> = contenders.iter().map(|one| &one.fitted.outcome).collect();
    let title = |index: usize| contenders[index].fitted.theory.document.program.title.clone();
    ties(ranked, &outcomes, Language::English, title)
}

/// Theories in the order of their places, each as one object.
pub fn ranking_as_json(contenders: &[Contender], ranked: &[Ranked], data: &[Measured]) -> Value {
    let best = ranked.first().map(|ranked| &contenders[ranked.index].fitted.outcome);
    let worth = best.map(worth);
    let tied = tied(contenders, ranked);
    let rows: Vec<Value> = ranked
        .iter()
        .map(|ranked| {
            let one = &contenders[ranked.index];
            let mut row = fit_as_json(&one.fitted, data);
            let unit = &one.fitted.outcome.rmse_unit;
            row["place"] = json!(ranked.place);
            row["tie"] = json!(tied.iter().find(|(place, _)| *place == ranked.place).map(|(_, sentence)| sentence));
            row["delta_aicc"] = json!(ranked.difference);
            row["weight"] = json!(ranked.weight);
            row["worth"] = json!(worth);
            if let Some([before, after, prediction]) = one.parts {
                row["rmse_before"] = json!(unit.from_si(before.rmse));
                row["rmse_after"] = json!(unit.from_si(after.rmse));
                row["rmse_predicted"] = json!(unit.from_si(prediction.rmse));
            }
            row
        })
        .collect();
    Value::Array(rows)
}
