//! Opens a document: from text to program.

use crate::blocks::questions;
use crate::blocks::questions::{QUESTIONS, RawQuestion};
use crate::blocks::settings;
use crate::blocks::{assignment, named, plots, presets, survey};
use crate::card;
use crate::checks::Checks;
use crate::document::{Document, Opened};
use crate::expressions::Expressions;
use crate::prose::Prose;
use crate::scene;
use crate::scene::SceneText;
use crate::text::block::BlockKind;
use crate::text::findings::limited;
use crate::text::outline::Outline;
use model::{Checked, Diagnostic, Span, Statement};
use program::{Edition, Program, Question, QuestionText};
use std::collections::BTreeMap;
use units::{Language, words};

/// Reads and checks a document and its translations. The document is `None` if its model has errors; other faulty parts are
/// left out.
pub fn open(source: &str, translations: &[&str]) -> Opened {
    Opening::begin(source).finish(translations)
}

/// A document whose model is read and checked, and whose other parts are not: two halves of about the same length, for a
/// caller that has other things to do in between.
pub struct Opening<'a> {
    file: File<'a>,
    /// `None` if the model has errors.
    checked: Option<Checked>,
}

impl<'a> Opening<'a> {
    /// Reads and checks the model.
    pub fn begin(source: &'a str) -> Self {
        let mut file = File::new(source);
        if let Some(base) = file.outline.front_matter().get("translates") {
            let hint = words!("open {}, and this file with it", base.text);
            file.diagnostics.push(
                Diagnostic::error(
                    "translation",
                    words("this is a translation, which has no model of its own"),
                    base.span,
                )
                .with_hint(hint),
            );
        }
        let checked = file.model();
        Self { file, checked }
    }

    /// Reads and checks the rest, and the translations. The result is that of [`open`].
    pub fn finish(self, translations: &[&str]) -> Opened {
        let Self { mut file, checked } = self;
        let mut read = checked.map(|checked| file.document(checked));
        let mut diagnostics = vec![file.diagnostics];
        for text in translations {
            let mut translation = File::new(text);
            if let Some(read) = &mut read {
                translation.translate(read);
            }
            diagnostics.push(translation.diagnostics);
        }
        let diagnostics = diagnostics.into_iter().enumerate();
        Opened {
            document: read.map(|read| read.document),
            diagnostics: diagnostics
                .flat_map(|(file, found)| limited(found).into_iter().map(move |d| (file, d)))
                .collect(),
        }
    }
}

/// A document, and the data that its translations need.
pub(crate) struct Read {
    pub(crate) document: Document,
    /// Statements of the model.
    pub(crate) statements: Vec<Statement>,
    /// For each question as written, its index in the document, or `None` if it is invalid.
    pub(crate) questions: Vec<Option<usize>>,
    /// For each item of the survey as written, its index in the document, or `None` if it is invalid.
    pub(crate) survey: Vec<Option<usize>>,
    /// Texts of the scene.
    pub(crate) scene_words: Vec<SceneText>,
}

/// A file and its diagnostics. Syntax errors of its model are added only when the model is checked, because the model of a
/// translation is ignored.
pub(crate) struct File<'a> {
    pub(crate) outline: Outline<'a>,
    pub(crate) diagnostics: Vec<Diagnostic>,
}

impl<'a> File<'a> {
    pub(crate) fn new(source: &'a str) -> Self {
        let mut outline = crate::read(source);
        let diagnostics = std::mem::take(&mut outline.layout);
        Self { outline, diagnostics }
    }

    pub(crate) fn model(&mut self) -> Option<Checked> {
        if self.outline.blocks_of(BlockKind::Model).next().is_none() {
            if !model::has_errors(&self.diagnostics) {
                let start = self.outline.front_matter().span.end;
                self.diagnostics.push(
                    Diagnostic::error("no-model", words("the document has no model"), Span::new(start, start))
                        .with_hint(words("write its equations in a block that begins with a line \"```model\"")),
                );
            }
            return None;
        }
        let (statements, found) = self.outline.take_model();
        let (checked, found) = model::check(statements, found);
        self.diagnostics.extend(found);
        checked
    }

    /// Everything except the model.
    pub(crate) fn document(&mut self, checked: Checked) -> Read {
        let Checked { mut model, statements, places, functions } = checked;
        let settings = settings::read(self.outline.front_matter(), &model, &mut self.diagnostics);
        card::check(self.outline.front_matter(), &mut self.diagnostics);
        let assignment = assignment::read(self.outline.front_matter(), &model, &places, &mut self.diagnostics);
        let mut expressions = Expressions::new(self.outline.source(), &mut model, &places, &functions);
        let vary = named::vary(&mut expressions, self.outline.front_matter());
        let main = named::main(&mut expressions, self.outline.front_matter());
        let mut plots = Vec::new();
        for block in self.outline.blocks_of(BlockKind::Plots) {
            plots::read(&mut expressions, &block.sentences, settings.until, &mut plots);
        }
        let mut presets = Vec::new();
        for block in self.outline.blocks_of(BlockKind::Presets) {
            presets::read(&mut expressions, &block.sentences, &mut presets);
        }
        let mut checks = Checks::default();
        for block in self.outline.blocks_of(BlockKind::Check) {
            checks.read(&mut expressions, &block.sentences);
        }
        let mut scenes = self.outline.blocks_of(BlockKind::Scene);
        let (scene, scene_words) = scenes
            .next()
            .and_then(|block| scene::build(&mut expressions, block.content.range(), Language::of(&settings.language)))
            .unzip();
        let mut further: Vec<Diagnostic> =
            scenes.map(|block| Diagnostic::error("fence", words("a document has one scene"), block.head())).collect();
        further.extend(self.outline.blocks_of(BlockKind::Translations).map(|block| {
            Diagnostic::error("fence", words("translations stand in a file of their own"), block.head()).with_hint(
                words("such as `utube.es.md`, whose front matter says `language: es` and `translates: utube.md`"),
            )
        }));
        let mut compiled: Vec<Question> = Vec::new();
        let mut earlier: Vec<Option<usize>> = Vec::new();
        let (prose, texts, questions) = self.prose(&mut further, |raw| {
            let question = questions::compile(&mut expressions, raw, &earlier);
            earlier.push(question.is_some().then_some(compiled.len()));
            compiled.extend(question);
            *earlier.last()?
        });
        let (sections, found) = prose.finish();
        further.extend(found);
        let survey = survey::read(&self.outline, &mut further);
        let (items, survey_texts, surveyed) = survey::kept(survey, &mut further);
        further.append(&mut expressions.diagnostics);
        self.diagnostics.extend(further);
        let edition = Edition {
            language: settings.language.clone(),
            title: settings.title.clone(),
            sections,
            equations: model::typeset(&statements, &str::to_owned),
            questions: texts,
            survey: survey_texts,
            scene,
            texts: BTreeMap::new(),
        };
        let program = Program {
            title: settings.title,
            language: settings.language,
            editions: vec![edition],
            model,
            method: settings.method,
            step: settings.step,
            until: settings.until,
            speed: settings.speed,
            tolerance: settings.tolerance,
            assignment,
            seat: None,
            vary,
            main,
            plots,
            presets,
            questions: compiled,
            survey: items,
            checks: checks.checks,
        };
        let source = self.outline.source().to_owned();
        let claims = checks.places;
        let document = Document { source, translations: Vec::new(), places, claims, functions, program };
        Read { document, statements, questions, survey: surveyed, scene_words: scene_words.unwrap_or_default() }
    }

    /// The prose with its questions. `place` returns the index of a question in the document, or `None`. Also returns the
    /// texts of the questions by that index, and the index of each question as written.
    pub(crate) fn prose(
        &self,
        diagnostics: &mut Vec<Diagnostic>,
        mut place: impl FnMut(&RawQuestion) -> Option<usize>,
    ) -> (Prose<'a>, Vec<QuestionText>, Vec<Option<usize>>) {
        let mut prose = Prose::new(self.outline.source());
        let mut texts: Vec<QuestionText> = Vec::new();
        let mut numbers = Vec::new();
        for block in self.outline.blocks() {
            match block.kind {
                BlockKind::Prose => prose.markdown(block.content.range()),
                BlockKind::Question => {
                    if numbers.len() == QUESTIONS {
                        let message = words!("a document cannot have more than {QUESTIONS} questions");
                        diagnostics.push(Diagnostic::error("too-large", message, block.head()));
                        break;
                    }
                    let raw = questions::split(self.outline.source(), block.content.range(), diagnostics);
                    let number = place(&raw);
                    numbers.push(number);
                    let text = questions::texts(self.outline.source(), &mut prose, &raw);
                    if let Some(number) = number {
                        texts.resize_with(texts.len().max(number + 1), QuestionText::default);
                        texts[number] = text;
                        prose.question(number);
                    }
                }
                _ => {}
            }
        }
        (prose, texts, numbers)
    }
}
