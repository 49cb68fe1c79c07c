//! A program: a checked model and everything that is shown of it.

use crate::{Check, Method, Model, Plot, Preset, Question, QuestionText, Scene, Section, Speed};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A simulation, ready to be run and shown.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Program {
    /// The title in the document's own language.
    pub title: String,
    /// The document's own language, such as `en`.
    pub language: String,
    /// The texts in each language; the first one is the document's own.
    pub editions: Vec<Edition>,
    /// The checked model, to whose graph the expressions of scene, plots, presets and questions have been added.
    pub model: Model,
    /// The method asked for.
    pub method: Option<Method>,
    /// The step of the independent variable, SI.
    pub step: Option<f64>,
    /// Where a run without an end of its own stops, SI.
    pub until: Option<f64>,
    /// How fast it is watched, where the document says so: see [`Self::pace`].
    pub speed: Option<Speed>,
    /// The relative tolerance of adaptive methods.
    pub tolerance: Option<f64>,
    /// The parameters that a fit varies unless another choice is made, by their places in [`Model::parameters`].
    pub vary: Vec<usize>,
    /// In the order of the text.
    pub plots: Vec<Plot>,
    /// In the order of the text; those of one group stand together.
    pub presets: Vec<Preset>,
    /// In the order of the text.
    pub questions: Vec<Question>,
    /// In the order of the text.
    pub checks: Vec<Check>,
}

impl Program {
    /// Where a run ends if the document does not say: at so many of whatever the independent variable is measured in.
    pub const UNTIL: f64 = 100.0;

    /// Where a run of its own ends, SI.
    pub fn end(&self) -> f64 {
        self.until.unwrap_or_else(|| self.model.independent.unit.to_si(Self::UNTIL))
    }

    /// The languages in which the document exists, its own first.
    pub fn languages(&self) -> impl Iterator<Item = &str> {
        self.editions.iter().map(|edition| edition.language.as_str())
    }

    /// How fast it is watched.
    pub fn pace(&self) -> Speed {
        let independent = &self.model.independent;
        // Of what counts one in a second would be slow.
        let until = self.until.or_else(|| independent.counts.then(|| self.end()));
        self.speed.clone().unwrap_or_else(|| Speed::chosen(until, &independent.unit))
    }

    /// The edition in `language`; the document's own where there is none.
    pub fn edition(&self, language: &str) -> &Edition {
        self.editions.iter().find(|edition| edition.language == language).unwrap_or(&self.editions[0])
    }

    /// What a text of the document (a label, a title of a plot or a button, the name of a preset or of a group, a claim's name, a text value) is in
    /// `language`; itself where it has no translation.
    pub fn text<'a>(&'a self, language: &str, original: &'a str) -> &'a str {
        self.edition(language).texts.get(original).map_or(original, String::as_str)
    }

    /// The texts that [`Self::text`] may be asked for.
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

    /// The scene with its texts in `language`.
    pub fn scene(&self, language: &str) -> Option<&Scene> {
        self.edition(language).scene.as_ref()
    }

    /// The prose in `language`.
    pub fn sections(&self, language: &str) -> &[Section] {
        &self.edition(language).sections
    }

    /// The words of question `index` in `language`.
    pub fn question_text(&self, language: &str, index: usize) -> &QuestionText {
        let edition = self.edition(language);
        edition.questions.get(index).unwrap_or(&self.editions[0].questions[index])
    }
}

/// Everything of a document that differs between languages.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Edition {
    /// `en`, `es`, `pt-BR` ...
    pub language: String,
    /// The title.
    pub title: String,
    /// The prose.
    pub sections: Vec<Section>,
    /// The equations of the model, each a `<math>` element, in the order of the text.
    pub equations: Vec<String>,
    /// The words of the questions; those that a translation lacks are in the document's own language.
    pub questions: Vec<QuestionText>,
    /// The scene with its texts translated.
    pub scene: Option<Scene>,
    /// Original to translation, of labels, titles, names and text values. Empty in the document's own edition.
    pub texts: BTreeMap<String, String>,
}
