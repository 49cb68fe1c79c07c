//! What an opened document is: everything checked against the model and ready to be run and shown.

use crate::{Scene, Section};
use model::{Compiled, Diagnostic, Model, Span};
use std::collections::BTreeMap;
use units::Unit;

/// What came of opening a document.
#[derive(Clone, Debug)]
pub struct Opened {
    /// The document, unless its model has errors.
    pub document: Option<Document>,
    /// What was found, each with the number of its file: 0 is the source, 1 the first translation and so on. In the
    /// order of files and places.
    pub diagnostics: Vec<(usize, Diagnostic)>,
}

impl Opened {
    /// Whether any finding, in any file, is an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|(_, diagnostic)| diagnostic.severity == model::Severity::Error)
    }
}

/// A simulation document and its translations.
#[derive(Clone, Debug)]
pub struct Document {
    /// The Markdown text.
    pub source: String,
    /// The Markdown texts of the translations.
    pub translations: Vec<String>,
    /// The title in the document's own language.
    pub title: String,
    /// The document's own language, such as `en`.
    pub language: String,
    /// The document in each language; the first one is its own.
    pub editions: Vec<Edition>,
    /// The checked model, to whose graph the expressions of scene, plots, presets and questions have been added.
    pub model: Model,
    /// The method asked for, as written; whether it exists is for the engine to say.
    pub method: Option<String>,
    /// Where the method is named.
    pub method_span: Span,
    /// The step of the independent variable, SI.
    pub step: Option<f64>,
    /// Where a run without an end of its own stops, SI.
    pub until: Option<f64>,
    /// The relative tolerance of adaptive methods.
    pub tolerance: Option<f64>,
    /// The parameters that a fit varies unless it is told otherwise, by their places in [`Model::parameters`].
    pub vary: Vec<usize>,
    /// In the order of the text.
    pub plots: Vec<Plot>,
    /// In the order of the text; those of one group stand together.
    pub presets: Vec<Preset>,
    /// In the order of the text.
    pub questions: Vec<Question>,
}

impl Document {
    /// The languages in which the document exists, its own first.
    pub fn languages(&self) -> impl Iterator<Item = &str> {
        self.editions.iter().map(|edition| edition.language.as_str())
    }

    /// The edition in `language`; the document's own where there is none.
    pub fn edition(&self, language: &str) -> &Edition {
        self.editions.iter().find(|edition| edition.language == language).unwrap_or(&self.editions[0])
    }

    /// What a text of the document (a label, a title of a plot, a preset's or its group's name, a text value) is in
    /// `language`; itself where it has no translation.
    pub fn text<'a>(&'a self, language: &str, original: &'a str) -> &'a str {
        self.edition(language).texts.get(original).map_or(original, String::as_str)
    }

    /// The texts that [`Self::text`] may be asked for.
    pub(crate) fn translatable(&self) -> Vec<&str> {
        let model = &self.model;
        let labels = (model.parameters.iter().map(|parameter| &parameter.label))
            .chain(model.states.iter().map(|state| &state.label))
            .chain(model.quantities.iter().map(|quantity| &quantity.label));
        let curves = self.plots.iter().flat_map(|plot| plot.curves.iter().chain([&plot.x])).map(|curve| &curve.label);
        let groups = self.presets.iter().map(|preset| &preset.group);
        let optional = labels.chain(curves).chain(groups).flatten();
        let named = self.plots.iter().map(|plot| &plot.title).chain(self.presets.iter().map(|preset| &preset.name));
        optional.chain(named).chain(&model.texts).map(String::as_str).collect()
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
#[derive(Clone, Debug, Default)]
pub struct Edition {
    /// `en`, `es`, `pt-BR` ...
    pub language: String,
    /// The title.
    pub title: String,
    /// The prose.
    pub sections: Vec<Section>,
    /// The words of the questions; in a translation possibly fewer than there are questions.
    pub questions: Vec<QuestionText>,
    /// The scene with its texts translated.
    pub scene: Option<Scene>,
    /// Original to translation, of labels, titles, names and text values. Empty in the document's own edition.
    pub texts: BTreeMap<String, String>,
}

/// A figure: `"Phase portrait": y' against y`.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// The title, to be passed through [`Document::text`].
    pub title: String,
    /// What is drawn along the horizontal axis.
    pub x: Curve,
    /// What is drawn; those of equal dimension share an axis.
    pub curves: Vec<Curve>,
    /// Where it is described.
    pub span: Span,
}

/// One expression of a plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// As written: `y'`.
    pub expression: String,
    /// The author's label of the name, where the expression is one.
    pub label: Option<String>,
    /// Its value; always a number.
    pub value: Compiled,
}

/// A named set of parameter values.
#[derive(Clone, Debug, PartialEq)]
pub struct Preset {
    /// The name of its group, such as `Liquid`.
    pub group: Option<String>,
    /// Its name.
    pub name: String,
    /// What it sets.
    pub values: Vec<Assignment>,
    /// Where it is described.
    pub span: Span,
}

/// A parameter and the value it gets.
#[derive(Clone, Debug, PartialEq)]
pub struct Assignment {
    /// Which of [`Model::parameters`].
    pub parameter: usize,
    /// The value, SI, in terms of parameters only. Assignments are made in their order: each value is computed from the
    /// parameters as those before it have left them.
    pub value: Compiled,
}

/// A question whose answer the document computes.
#[derive(Clone, Debug, PartialEq)]
pub struct Question {
    /// Parameter values that the question supposes. Its answer is computed with these in place of the present ones,
    /// and the laboratory offers to set them.
    pub setup: Vec<Assignment>,
    /// Which of [`model::Model::quantities`] would give the answer away: their values are hidden until it is given.
    pub hides: Vec<usize>,
    /// The answer, in terms of parameters only; always a number.
    pub answer: Compiled,
    /// The unit in which the answer is asked for.
    pub unit: Unit,
    /// How far off an answer may be.
    pub tolerance: Tolerance,
    /// Where it stands.
    pub span: Span,
}

/// How far off an answer may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// A fraction of the right answer: 0.02 for `within 2 %`.
    Relative(f64),
    /// An SI number: `within 0.1 [s]`.
    Absolute(f64),
}

impl Tolerance {
    /// Whether `given` is near enough to `right` (both SI).
    pub fn accepts(self, given: f64, right: f64) -> bool {
        let allowed = match self {
            Self::Relative(fraction) => fraction * right.abs(),
            Self::Absolute(amount) => amount,
        };
        (given - right).abs() <= allowed
    }
}

/// The words of a question, as HTML.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct QuestionText {
    /// What is asked.
    pub prompt: String,
    /// Help towards it.
    pub hint: Option<String>,
    /// Why the answer is what it is; for after answering.
    pub explanation: Option<String>,
}
