//! Identifiers of the quantities of facts. They do not depend on any language: `stderr:value:gamma`.
//!
//! An identifier is a kind, and after a colon the name of what it is about, which may begin with a kind itself.

use handed::fact::{Fact, Part};
use units::{Language, Words, words};

/// Text for people: `standard error of gamma`.
pub fn quantity_text(quantity: &str, language: Language) -> String {
    let (kind, rest) = quantity.split_once(':').unwrap_or((quantity, ""));
    if kind == "value" {
        return rest.to_owned();
    }
    let Some(kind) = kind_words(kind) else { return quantity.to_owned() };
    let kind = kind.text(language);
    let rest = rest.trim_start();
    if rest.is_empty() { kind.into_owned() } else { format!("{kind} {}", quantity_text(rest, language)) }
}

/// Words for a kind; `None` for the value itself, and if there is no such kind.
fn kind_words(kind: &str) -> Option<Words> {
    Some(match kind {
        "document" => words("text of the document"),
        "seat" => words("seat"),
        "assignment" => words("assignment"),
        "parameter" => words("parameter"),
        "text" => words("text"),
        "shown" => words("attempts before the right answer was shown"),
        "attempt" => words("attempt"),
        "allowed" => words("attempts allowed"),
        "made" => words("attempts made"),
        "conditions" => words("values at attempt"),
        "given" => words("grade given to attempt"),
        "grade" => words("grade of attempt"),
        "end-grade" => words("grade with the values at the end, attempt"),
        "head" => words("head of the page"),
        "style" => words("style sheet"),
        "own-section" => words("section with the data"),
        "foreign" => words("element that Meniscus does not write"),
        "content" => words("content"),
        "rows" => words("rows"),
        "mean" => words("mean of"),
        "meaning" => words("meaning of"),
        "zero" => words("zero of"),
        "origin" => words("beginning of the motion"),
        "known" => words("known"),
        "table" => words("table"),
        "points" => words("points"),
        "length-error" => words("relative error of the lengths"),
        "record" => words("record of the film"),
        "theory" => words("theory"),
        "derived" => words("derived"),
        "fixed" => words("fixed"),
        "unit" => words("unit of"),
        "stderr" => words("standard error of"),
        "stderr-independent" => words("standard error for independent residuals of"),
        "low" => words("lower end of the interval of"),
        "high" => words("upper end of the interval of"),
        "correlation" => words("correlation of"),
        "residual" => words("residual of"),
        "predicted" => words("predicted values of"),
        "prediction-error" => words("error of the prediction of"),
        "scale" => words("scale of the film"),
        "scale-stderr" => words("standard error of the scale"),
        "begin" => words("begin of the model"),
        "n" => words("number of values"),
        "dof" => words("degrees of freedom"),
        "rmse" => words("RMSE"),
        "chi2" => words("sum of squares"),
        "chi2-reduced" => words("reduced chi-square"),
        "r2" => words("R²"),
        "aicc" => words("AICc"),
        "bic" => words("BIC"),
        "durbin-watson" => words("Durbin-Watson"),
        "autocorrelation" => words("autocorrelation"),
        "independent" => words("independent values"),
        "outliers" => words("outliers"),
        _ => return None,
    })
}

/// Sentences of version 1 of the hand-in, and their identifiers.
const WHOLE: [(Part, &str, &str); 18] = [
    (Part::Answer, "right answer", "shown"),
    (Part::Answer, "grade given", "given"),
    (Part::Answer, "grade", "end-grade"),
    (Part::Film, "relative error of the lengths", "length-error"),
    (Part::Fit, "values", "n"),
    (Part::Fit, "degrees of freedom", "dof"),
    (Part::Fit, "RMSE", "rmse"),
    (Part::Fit, "sum of squares", "chi2"),
    (Part::Fit, "reduced chi-square", "chi2-reduced"),
    (Part::Fit, "R2", "r2"),
    (Part::Fit, "AICc", "aicc"),
    (Part::Fit, "BIC", "bic"),
    (Part::Fit, "Durbin-Watson", "durbin-watson"),
    (Part::Fit, "independent values", "independent"),
    (Part::Fit, "theory", "theory"),
    (Part::Fit, "autocorrelation", "autocorrelation"),
    (Part::Fit, "outliers", "outliers"),
    (Part::Run, "document", "document"),
];
/// Beginnings of such sentences.
const BEGINNINGS: [(Part, &str, &str); 20] = [
    (Part::Run, "parameter ", "parameter:"),
    (Part::Answer, "attempt ", "attempt:"),
    (Part::Answer, "grade given to attempt ", "given:"),
    (Part::Answer, "grade of attempt ", "end-grade:"),
    (Part::Record, "mean of ", "mean:"),
    (Part::Record, "meaning of ", "meaning:"),
    (Part::Record, "zero of ", "zero:"),
    (Part::Record, "known ", "known:"),
    (Part::Film, "mean of ", "mean:"),
    (Part::Fit, "correlation of ", "correlation:"),
    (Part::Fit, "residual of ", "residual:"),
    (Part::Fit, "predicted values of ", "predicted:"),
    (Part::Fit, "error of the prediction of ", "prediction-error:"),
    (Part::Fit, "scale of the film", "scale:"),
    (Part::Fit, "standard error of the scale", "scale-stderr:"),
    (Part::Fit, "begin of the model", "begin:"),
    (Part::Fit, "unit of ", "unit:"),
    (Part::Fit, "standard error of ", "stderr:"),
    (Part::Fit, "lower end of the interval of ", "low:"),
    (Part::Fit, "upper end of the interval of ", "high:"),
];
/// End of the sentence of a second standard error.
const INDEPENDENT: &str = ", independent residuals";

/// A fact of version 1 of the hand-in, whose quantities were English sentences, with its identifier.
pub fn fact_of_version_1(fact: &Fact) -> Fact {
    let item = match fact.part {
        Part::Answer => fact.item.strip_prefix("question ").unwrap_or(&fact.item).to_owned(),
        _ => fact.item.clone(),
    };
    Fact { item, quantity: identifier(fact.part, &fact.quantity), ..fact.clone() }
}

/// Identifier of a sentence of version 1.
fn identifier(part: Part, sentence: &str) -> String {
    if let Some((.., id)) = WHOLE.iter().find(|(own, whole, _)| *own == part && *whole == sentence) {
        return (*id).to_owned();
    }
    let found = BEGINNINGS.iter().find_map(|(own, beginning, id)| {
        (*own == part).then_some(())?;
        Some((*id, sentence.strip_prefix(beginning)?))
    });
    match (part, found) {
        (Part::Fit, Some(("stderr:", rest))) => match rest.strip_suffix(INDEPENDENT) {
            Some(rest) => format!("stderr-independent:{}", estimate(rest)),
            None => format!("stderr:{}", estimate(rest)),
        },
        (Part::Fit, Some((id @ ("unit:" | "low:" | "high:"), rest))) => format!("{id}{}", estimate(rest)),
        (_, Some((id, rest))) => format!("{id}{rest}"),
        (Part::Fit, None) => estimate(sentence),
        (Part::Run, None) => format!("value:{sentence}"),
        (_, None) => sentence.to_owned(),
    }
}

/// Identifier of an estimated or fixed number.
fn estimate(name: &str) -> String {
    let kinds = [("derived ", "derived:"), ("fixed ", "fixed:")];
    let found = kinds.iter().find_map(|(prefix, id)| Some(format!("{id}{}", name.strip_prefix(prefix)?)));
    found.unwrap_or_else(|| format!("value:{name}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_of_version_1_have_identifiers() {
        for (part, sentence, id, text) in [
            (Part::Fit, "gamma", "value:gamma", "gamma"),
            (Part::Fit, "derived T (a.csv)", "derived:T (a.csv)", "derived T (a.csv)"),
            (Part::Fit, "unit of fixed L", "unit:fixed:L", "unit of fixed L"),
            (Part::Fit, "standard error of derived T", "stderr:derived:T", "standard error of derived T"),
            (
                Part::Fit,
                "standard error of g, independent residuals",
                "stderr-independent:value:g",
                "standard error for independent residuals of g",
            ),
            (Part::Fit, "standard error of the scale (a)", "scale-stderr: (a)", "standard error of the scale (a)"),
            (Part::Fit, "R2", "r2", "R²"),
            (Part::Run, "y'", "value:y'", "y'"),
            (Part::Run, "parameter L", "parameter:L", "parameter L"),
            (Part::Answer, "grade of attempt 2", "end-grade:2", "grade with the values at the end, attempt 2"),
            (Part::Record, "mean of t [s]", "mean:t [s]", "mean of t [s]"),
            (Part::Report, "text", "text", "text"),
        ] {
            assert_eq!(identifier(part, sentence), id);
            assert_eq!(quantity_text(id, Language::English), text);
        }
        assert_eq!(quantity_text("later:x", Language::English), "later:x");
    }
}
