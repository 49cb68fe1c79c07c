//! Settings of the run in the front matter.

use super::amount::Setting;
use super::front_matter::{FrontMatter, Value};
use model::Diagnostic;
use program::{Method, Model, Speed, UnknownMethod};
use units::alphabet::without_accent;
use units::{Unit, words};

/// Names of languages without accents, and their codes.
const NAMES: [(&str, &str); 14] = [
    ("english", "en"),
    ("ingles", "en"),
    ("spanish", "es"),
    ("espanol", "es"),
    ("castellano", "es"),
    ("portuguese", "pt"),
    ("portugues", "pt"),
    ("german", "de"),
    ("deutsch", "de"),
    ("aleman", "de"),
    ("french", "fr"),
    ("francais", "fr"),
    ("italian", "it"),
    ("italiano", "it"),
];

/// The checked front matter. Values are in SI units.
pub struct Settings {
    /// Title; `Untitled` by default.
    pub title: String,
    /// Language tag; `en` by default.
    pub language: String,
    /// Numerical method.
    pub method: Option<Method>,
    /// Step of the independent variable.
    pub step: Option<f64>,
    /// Value of the independent variable at the end of the run.
    pub until: Option<f64>,
    /// Playback speed.
    pub speed: Option<Speed>,
    /// Relative tolerance of adaptive methods.
    pub tolerance: Option<f64>,
}

/// Checks the front matter against the model.
pub fn read(matter: &FrontMatter, model: &Model, diagnostics: &mut Vec<Diagnostic>) -> Settings {
    let independent = &model.independent.unit;
    if model.independent.counts {
        refuse_steps(matter, &model.independent.name, diagnostics);
    }
    let language = matter.get("language").filter(|language| {
        let good = is_language(&language.text);
        if !good {
            diagnostics.push(no_language(language));
        }
        good
    });
    Settings {
        title: matter.get("title").map_or_else(|| "Untitled".to_owned(), |title| title.text.clone()),
        language: language.map_or_else(|| "en".to_owned(), |language| language.text.clone()),
        method: matter.get("method").and_then(|value| method(value, diagnostics)),
        step: matter.get("step").and_then(|value| quantity("step", value, independent, diagnostics)).map(|(si, _)| si),
        until: matter
            .get("until")
            .and_then(|value| quantity("until", value, independent, diagnostics))
            .map(|(si, _)| si),
        speed: matter
            .get("speed")
            .and_then(|value| quantity("speed", value, independent, diagnostics))
            .map(|(per_second, unit)| Speed { per_second, unit }),
        tolerance: matter.get("tolerance").and_then(|value| tolerance(value, diagnostics)),
    }
}

/// Reports integration settings in a model with a discrete independent variable, which is not integrated.
fn refuse_steps(matter: &FrontMatter, independent: &str, diagnostics: &mut Vec<Diagnostic>) {
    for key in ["method", "step", "tolerance"] {
        let Some(value) = matter.get(key) else { continue };
        let message = words!("`{key}` has no meaning here: `{independent}` counts by 1");
        let diagnostic = Diagnostic::error("setting", message, value.span);
        diagnostics.push(diagnostic.with_hint(words!("leave the line `{key}` out")));
    }
}

/// Error for an invalid language tag.
pub fn no_language(language: &Value) -> Diagnostic {
    let wrong = Diagnostic::error("language", words!("`{}` is not a language", language.text), language.span)
        .with_hint(words("write its code, such as `en`, `es` or `pt-BR`"));
    let plain: String = language.text.chars().map(without_accent).collect::<String>().to_lowercase();
    match NAMES.iter().find(|(name, _)| *name == plain) {
        Some((_, code)) => wrong.with_fix(language.span, *code),
        None => wrong,
    }
}

/// True if a text can be a language tag (BCP 47, roughly). The name of a language is none.
pub fn is_language(text: &str) -> bool {
    let is_name = NAMES.iter().any(|(name, _)| text.eq_ignore_ascii_case(name));
    !is_name
        && text.len() <= 20
        && text.split('-').all(|part| (1..=8).contains(&part.len()) && part.chars().all(|c| c.is_ascii_alphanumeric()))
        && text.starts_with(|c: char| c.is_ascii_alphabetic())
}

fn method(value: &Value, diagnostics: &mut Vec<Diagnostic>) -> Option<Method> {
    let method = value.text.parse::<Method>();
    let unknown = |unknown: UnknownMethod| {
        let wrong = Diagnostic::error("unknown-method", unknown.words(), value.span);
        match unknown.meant() {
            Some(meant) => wrong.meaning(meant.name()),
            None => wrong,
        }
    };
    method.map_err(|other| diagnostics.push(unknown(other))).ok()
}

fn tolerance(value: &Value, diagnostics: &mut Vec<Diagnostic>) -> Option<f64> {
    let (tolerance, _) = quantity("tolerance", value, &Unit::dimensionless(), diagnostics)?;
    if tolerance <= 0.1 {
        return Some(tolerance);
    }
    diagnostics.push(
        Diagnostic::error("setting", words("the tolerance is too large"), value.span)
            .with_hint(words("it is relative; `1e-8` is usual and 0.1 the greatest"))
            .with_fix(value.span, "1e-8"),
    );
    None
}

/// Parses a positive number, bare (then in `unit`) or with a unit of the same dimension. Returns its SI value and the unit.
fn quantity(key: &str, value: &Value, unit: &Unit, diagnostics: &mut Vec<Diagnostic>) -> Option<(f64, Unit)> {
    Setting { key, unit }.read(value).map_err(|wrong| diagnostics.push(*wrong)).ok()
}
