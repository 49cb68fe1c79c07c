//! Opens a document: from text to program.

use crate::blocks::questions;
use crate::blocks::questions::{QUESTIONS, RawQuestion};
use crate::blocks::settings::{self, Settings};
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
    Opening::begin(source, translations).finish()
}

/// A document that is read part by part, for a caller that has other things to do in between.
pub struct Opening<'a> {
    file: File<'a>,
    progress: Progress,
    /// Texts of the translations that are not read yet, the next one last.
    translations: Vec<&'a str>,
    /// Diagnostics of the translations read so far.
    found: Vec<Vec<Diagnostic>>,
}

/// Progress of [`Opening`]; the content is `None` if the model has errors.
enum Progress {
    /// The structure is read.
    Outlined,
    /// The model is checked.
    Checked(Option<Box<Checked>>),
    /// All blocks but those of prose are read.
    Compiled(Option<Box<Blocks>>),
    /// The document is read.
    Read(Option<Box<Read>>),
}

impl<'a> Opening<'a> {
    /// Reads the structure of a document, the first part.
    pub fn begin(source: &'a str, translations: &[&'a str]) -> Self {
        let translations = translations.iter().rev().copied().collect();
        Self { file: File::new(source), progress: Progress::Outlined, translations, found: Vec::new() }
    }

    /// Reads and checks the next part: the model, plots and scene, prose and questions, then each translation. False if all are read.
    pub fn advance(&mut self) -> bool {
        self.progress = match std::mem::replace(&mut self.progress, Progress::Outlined) {
            Progress::Outlined => Progress::Checked(self.file.own_model().map(Box::new)),
            Progress::Checked(checked) => {
                Progress::Compiled(checked.map(|checked| Box::new(self.file.blocks(*checked))))
            }
            Progress::Compiled(blocks) => Progress::Read(blocks.map(|blocks| Box::new(self.file.read(*blocks)))),
            Progress::Read(mut read) => {
                if let Some(text) = self.translations.pop() {
                    let mut translation = File::new(text);
                    if let Some(read) = &mut read {
                        translation.translate(read);
                    }
                    self.found.push(translation.diagnostics);
                }
                Progress::Read(read)
            }
        };
        !matches!(self.progress, Progress::Read(_)) || !self.translations.is_empty()
    }

    /// Reads and checks what is left. The result is that of [`open`].
    pub fn finish(mut self) -> Opened {
        while self.advance() {}
        let read = if let Progress::Read(read) = self.progress { read } else { None };
        let diagnostics = std::iter::once(self.file.diagnostics).chain(self.found).enumerate();
        Opened {
            document: read.map(|read| read.document),
            diagnostics: diagnostics
                .flat_map(|(file, found)| limited(found).into_iter().map(move |d| (file, d)))
                .collect(),
        }
    }
}

/// Content of the blocks of a document, without its prose and questions.
struct Blocks {
    checked: Checked,
    settings: Settings,
    assignment: Option<String>,
    vary: Vec<usize>,
    main: Vec<usize>,
    plots: Vec<program::Plot>,
    presets: Vec<program::Preset>,
    checks: Checks,
    scene: Option<program::Scene>,
    scene_words: Option<Vec<SceneText>>,
    /// Diagnostics about blocks as such.
    misplaced: Vec<Diagnostic>,
    /// Diagnostics of expressions.
    found: Vec<Diagnostic>,
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

    /// The model of a document that is no translation.
    fn own_model(&mut self) -> Option<Checked> {
        if let Some(base) = self.outline.front_matter().get("translates") {
            let hint = words!("open {}, and this file with it", base.text);
            self.diagnostics.push(
                Diagnostic::error(
                    "translation",
                    words("this is a translation, which has no model of its own"),
                    base.span,
                )
                .with_hint(hint),
            );
        }
        self.model()
    }

    /// Everything except the model.
    pub(crate) fn document(&mut self, checked: Checked) -> Read {
        let blocks = self.blocks(checked);
        self.read(blocks)
    }

    /// Everything except model, prose and questions.
    fn blocks(&mut self, mut checked: Checked) -> Blocks {
        let Checked { model, places, functions, .. } = &mut checked;
        let settings = settings::read(self.outline.front_matter(), model, &mut self.diagnostics);
        card::check(self.outline.front_matter(), &mut self.diagnostics);
        let assignment = assignment::read(self.outline.front_matter(), model, places, &mut self.diagnostics);
        let mut expressions = Expressions::new(self.outline.source(), model, places, functions);
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
        let mut misplaced: Vec<Diagnostic> =
            scenes.map(|block| Diagnostic::error("fence", words("a document has one scene"), block.head())).collect();
        misplaced.extend(self.outline.blocks_of(BlockKind::Translations).map(|block| {
            Diagnostic::error("fence", words("translations stand in a file of their own"), block.head()).with_hint(
                words("such as `utube.es.md`, whose front matter says `language: es` and `translates: utube.md`"),
            )
        }));
        let found = expressions.diagnostics;
        Blocks {
            checked,
            settings,
            assignment,
            vary,
            main,
            plots,
            presets,
            checks,
            scene,
            scene_words,
            misplaced,
            found,
        }
    }

    /// The document from its blocks, with prose and questions.
    fn read(&mut self, blocks: Blocks) -> Read {
        let Blocks { checked, settings, assignment, vary, main, plots, presets, checks, scene, scene_words, .. } =
            blocks;
        let Checked { mut model, statements, places, functions } = checked;
        let mut further = blocks.misplaced;
        let mut expressions = Expressions::new(self.outline.source(), &mut model, &places, &functions);
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
        further.extend(blocks.found);
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
