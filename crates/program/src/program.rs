//! A program: a checked model and everything that is shown with it.

use crate::{
    Check, Method, Model, Plot, Preset, Question, QuestionText, Scene, Seat, Section, Speed, SurveyItem, SurveyText,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A simulation, ready to be run and shown.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Program {
    /// Title in the language of the document.
    pub title: String,
    /// Language of the document, such as `en`.
    pub language: String,
    /// Texts in each language; the first edition is that of the document.
    pub editions: Vec<Edition>,
    /// The checked model; its graph also has the expressions of scene, plots, presets and questions.
    pub model: Model,
    /// Method stated by the document.
    pub method: Option<Method>,
    /// Step of the independent variable stated by the document, SI units.
    pub step: Option<f64>,
    /// End of a run stated by the document, SI units.
    pub until: Option<f64>,
    /// Display speed stated by the document; see [`Self::pace`].
    pub speed: Option<Speed>,
    /// Relative tolerance of adaptive methods stated by the document.
    pub tolerance: Option<f64>,
    /// Name of the assignment, on which the values of the seats depend.
    pub assignment: Option<String>,
    /// Seat whose values the assigned parameters have; `None`: they have the stated ones.
    pub seat: Option<Seat>,
    /// Parameters that a fit varies by default, as indices in [`Model::parameters`].
    pub vary: Vec<usize>,
    /// Parameters that the page shows first, at most [`Program::MOST_MAIN`], as indices in [`Model::parameters`]; empty if the
    /// document does not name them.
    pub main: Vec<usize>,
    /// The plots, in the order of the text.
    pub plots: Vec<Plot>,
    /// The presets, in the order of the text; those of one group are adjacent.
    pub presets: Vec<Preset>,
    /// The questions, in the order of the text.
    pub questions: Vec<Question>,
    /// Items of the survey, in the order of the text.
    pub survey: Vec<SurveyItem>,
    /// The checks, in the order of the text.
    pub checks: Vec<Check>,
}

impl Program {
    /// Default end of a run, in the unit of the independent variable.
    pub const UNTIL: f64 = 100.0;

    /// Maximum number of parameters that the page shows first.
    pub const MOST_MAIN: usize = 5;

    /// Indices of the parameters that the page shows first: those that the document names, otherwise the first ones.
    pub fn main_parameters(&self) -> Vec<usize> {
        if self.main.is_empty() {
            self.model.shown_parameters().map(|(index, _)| index).take(Self::MOST_MAIN).collect()
        } else {
            self.main.clone()
        }
    }

    /// End of a run, SI units.
    pub fn end(&self) -> f64 {
        self.until.unwrap_or_else(|| self.model.independent.unit.to_si(Self::UNTIL))
    }

    /// Languages of the document, its own first.
    pub fn languages(&self) -> impl Iterator<Item = &str> {
        self.editions.iter().map(|edition| edition.language.as_str())
    }

    /// Display speed.
    pub fn pace(&self) -> Speed {
        let independent = &self.model.independent;
        // One count per second would be slow.
        let until = self.until.or_else(|| independent.counts.then(|| self.end()));
        self.speed.clone().unwrap_or_else(|| Speed::chosen(until, &independent.unit))
    }

    /// The edition in `language`, or else in a variety of it (`pt-BR` for `pt`), or that of the document if there is none.
    pub fn edition(&self, language: &str) -> &Edition {
        let own = self.editions.iter().find(|edition| edition.language == language);
        let variety = || self.editions.iter().find(|edition| is_same_language(&edition.language, language));
        own.or_else(variety).unwrap_or(&self.editions[0])
    }

    /// True if the document is written in `language` or in a variety of it.
    pub fn is_in(&self, language: &str) -> bool {
        self.languages().any(|own| is_same_language(own, language))
    }

    /// Translation of a text of the document into `language`; the original if there is none. Texts are labels, titles of
    /// plots and buttons, names of presets, groups and claims, and text values.
    pub fn text<'a>(&'a self, language: &str, original: &'a str) -> &'a str {
        self.edition(language).texts.get(original).map_or(original, String::as_str)
    }

    /// All texts that [`Self::text`] can translate.
    pub fn translatable(&self) -> Vec<&str> {
        let model = &self.model;
        let labels = (model.parameters.iter().flat_map(|parameter| [&parameter.group, &parameter.label]))
            .chain(model.states.iter().map(|state| &state.label))
            .chain(model.quantities.iter().map(|quantity| &quantity.label))
            .chain(model.tables.iter().map(|table| &table.label))
            .chain(model.events.iter().filter(|event| event.is_labelled).map(|event| &event.title))
            .chain(model.sizes.iter().map(|size| &size.label));
        let curves = self.plots.iter().flat_map(Plot::expressions).map(|curve| &curve.label);
        let groups = self.presets.iter().map(|preset| &preset.group);
        let optional = labels.chain(curves).chain(groups).flatten();
        let named = self.plots.iter().map(|plot| &plot.title).chain(self.presets.iter().map(|preset| &preset.name));
        let claims = self.checks.iter().flat_map(|check| &check.claims).map(|claim| &claim.name);
        optional.chain(named).chain(claims).chain(&model.texts).map(String::as_str).collect()
    }

    /// The scene with its texts in `language`, if there is a scene.
    pub fn scene(&self, language: &str) -> Option<&Scene> {
        self.edition(language).scene.as_ref()
    }

    /// The prose in `language`.
    pub fn sections(&self, language: &str) -> &[Section] {
        &self.edition(language).sections
    }

    /// The text of question `index` in `language`.
    pub fn question_text(&self, language: &str, index: usize) -> &QuestionText {
        let edition = self.edition(language);
        edition.questions.get(index).unwrap_or(&self.editions[0].questions[index])
    }

    /// The texts of item `index` of the survey in `language`.
    pub fn survey_text(&self, language: &str, index: usize) -> &SurveyText {
        let edition = self.edition(language);
        edition.survey.get(index).unwrap_or(&self.editions[0].survey[index])
    }
}

/// True if two tags are varieties of one language: `pt` and `pt-BR`.
fn is_same_language(one: &str, other: &str) -> bool {
    let primary = |tag: &str| tag.find('-').unwrap_or(tag.len());
    one[..primary(one)].eq_ignore_ascii_case(&other[..primary(other)])
}

/// The parts of a document that differ between languages.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Edition {
    /// Language tag: `en`, `es`, `pt-BR` ...
    pub language: String,
    /// Title in this language.
    pub title: String,
    /// Prose in this language.
    pub sections: Vec<Section>,
    /// Equations of the model, each as a `<math>` element, in the order of the text.
    pub equations: Vec<String>,
    /// Texts of the questions; those without translation are in the language of the document.
    pub questions: Vec<QuestionText>,
    /// Texts of the survey; those without translation are in the language of the document.
    pub survey: Vec<SurveyText>,
    /// The scene with its texts translated.
    pub scene: Option<Scene>,
    /// Translations of labels, titles, names and text values, by the original. Empty in the edition of the document itself.
    pub texts: BTreeMap<String, String>,
}
