//! From text to document.

use crate::document::{Document, Opened};
use crate::expressions::Expressions;
use crate::fences::{self, Fence, FenceKind, Part};
use crate::front_matter::{self, FrontMatter};
use crate::prose::Prose;
use crate::questions::{self, QUESTIONS, RawQuestion};
use crate::scene::SceneText;
use crate::settings;
use crate::translation::Texts;
use crate::{plots, presets, scene, vary};
use model::{Checked, Diagnostic, Span, Statement};
use program::{Edition, Program, Question, QuestionText, Section};
use std::collections::BTreeMap;
use std::ops::Range;
use units::words;

/// How long a document may be, in bytes.
const LENGTH: usize = 1 << 20;
/// How many findings are kept of each file.
const FINDINGS: usize = 100;

/// Reads a document and its translations and checks everything in them. There is no document if its model has errors;
/// any other faulty part is left out of it.
pub fn open(source: &str, translations: &[&str]) -> Opened {
    let mut file = File::read(source);
    if let Some(base) = file.matter.get("translates") {
        let hint = words!("open {}, and this file with it", "abre {}, y este archivo con él", base.text);
        file.diagnostics.push(
            Diagnostic::error(
                "translation",
                words(
                    "this is a translation, which has no model of its own",
                    "esto es una traducción, que no tiene modelo propio",
                ),
                base.span,
            )
            .with_hint(hint),
        );
    }
    let checked = file.model();
    let mut read = checked.map(|checked| file.document(checked));
    let mut diagnostics = vec![file.diagnostics];
    for text in translations {
        let mut translation = File::read(text);
        if let Some(read) = &mut read {
            translation.translate(read);
        }
        diagnostics.push(translation.diagnostics);
    }
    let diagnostics = diagnostics.into_iter().enumerate();
    Opened {
        document: read.map(|read| read.document),
        diagnostics: diagnostics.flat_map(|(file, found)| bounded(found).into_iter().map(move |d| (file, d))).collect(),
    }
}

/// The findings in the order of their places; if there are too many, errors go before warnings.
fn bounded(mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let more = found.len().saturating_sub(FINDINGS);
    if more > 0 {
        found.sort_by_key(|diagnostic| std::cmp::Reverse(diagnostic.severity));
        found.truncate(FINDINGS);
    }
    found.sort_by_key(|diagnostic| diagnostic.span().start);
    if let Some(last) = found.last().filter(|_| more > 0) {
        let message = words!("{more} more findings are not listed", "otros {more} hallazgos no se muestran");
        found.push(Diagnostic::warning("more-findings", message, last.span()));
    }
    found
}

/// A document, and what its translations need of it.
struct Read {
    document: Document,
    /// The statements of the model.
    statements: Vec<Statement>,
    /// Which question of the document each question as written is, if it is any.
    questions: Vec<Option<usize>>,
    /// What the texts of the scene say.
    scene_words: Vec<SceneText>,
}

/// A file taken apart.
struct File<'a> {
    source: &'a str,
    matter: FrontMatter,
    parts: Vec<Part>,
    diagnostics: Vec<Diagnostic>,
}

impl<'a> File<'a> {
    fn read(source: &'a str) -> Self {
        let mut diagnostics = Vec::new();
        if source.len() > LENGTH {
            let end = source.chars().next().map_or(0, char::len_utf8);
            let message = words!(
                "a document cannot be longer than {LENGTH} bytes; this one has {}",
                "un documento no puede tener más de {LENGTH} bytes; este tiene {}",
                source.len()
            );
            diagnostics.push(Diagnostic::error("too-large", message, Span::new(0, end)));
            return Self { source: "", matter: FrontMatter::default(), parts: Vec::new(), diagnostics };
        }
        let matter = front_matter::read(source, &mut diagnostics);
        let parts = fences::split(source, matter.end..source.len(), &mut diagnostics);
        Self { source, matter, parts, diagnostics }
    }

    fn fences(&self, kind: FenceKind) -> Vec<&Fence> {
        let fences = self.parts.iter().filter_map(|part| match part {
            Part::Fence(fence) => Some(fence),
            Part::Prose(_) => None,
        });
        fences.filter(|fence| fence.kind == kind).collect()
    }

    fn model(&mut self) -> Option<Checked> {
        let parts: Vec<Range<usize>> =
            self.fences(FenceKind::Model).into_iter().map(|fence| fence.content.clone()).collect();
        if parts.is_empty() {
            if !model::has_errors(&self.diagnostics) {
                let start = Span::new(self.matter.end, self.matter.end);
                self.diagnostics.push(
                    Diagnostic::error(
                        "no-model",
                        words("the document has no model", "el documento no tiene modelo"),
                        start,
                    )
                    .with_hint(words(
                        "write its equations in a block that begins with a line \"```model\"",
                        "escribe sus ecuaciones en un bloque que empiece con una línea «```model»",
                    )),
                );
            }
            return None;
        }
        let (checked, found) = model::compile(self.source, &parts);
        self.diagnostics.extend(found);
        checked
    }

    /// Everything else.
    fn document(&mut self, checked: Checked) -> Read {
        let Checked { mut model, statements, places } = checked;
        let settings = settings::read(&self.matter, &model, &mut self.diagnostics);
        let mut expressions = Expressions::new(self.source, &mut model, &places);
        let vary = self.matter.get("vary").map_or_else(Vec::new, |value| vary::read(&mut expressions, value));
        let mut plots = Vec::new();
        for fence in self.fences(FenceKind::Plots) {
            plots::read(&mut expressions, fence.content.clone(), &mut plots);
        }
        let mut presets = Vec::new();
        for fence in self.fences(FenceKind::Presets) {
            presets::read(&mut expressions, fence.content.clone(), &mut presets);
        }
        let scenes = self.fences(FenceKind::Scene);
        let (scene, scene_words) =
            scenes.first().and_then(|fence| scene::build(&mut expressions, fence.content.clone())).unzip();
        let mut further: Vec<Diagnostic> = (scenes.iter().skip(1))
            .map(|fence| {
                Diagnostic::error(
                    "fence",
                    words("a document has one scene", "un documento tiene una sola escena"),
                    fence.opening,
                )
            })
            .collect();
        further.extend(self.fences(FenceKind::Translations).into_iter().map(|fence| {
            Diagnostic::error(
                "fence",
                words("translations stand in a file of their own", "las traducciones van en un archivo propio"),
                fence.opening,
            )
            .with_hint(words(
                "such as `utube.es.md`, whose front matter says `language: es` and `translates: utube.md`",
                "por ejemplo `utube.es.md`, cuya cabecera dice `language: es` y `translates: utube.md`",
            ))
        }));
        let mut compiled: Vec<Question> = Vec::new();
        let (sections, texts, questions) = self.prose(&mut further, |raw| {
            let question = questions::compile(&mut expressions, raw)?;
            compiled.push(question);
            Some(compiled.len() - 1)
        });
        further.append(&mut expressions.diagnostics);
        self.diagnostics.extend(further);
        let edition = Edition {
            language: settings.language.clone(),
            title: settings.title.clone(),
            sections,
            equations: model::typeset(&statements, &str::to_owned),
            questions: texts,
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
            tolerance: settings.tolerance,
            vary,
            plots,
            presets,
            questions: compiled,
        };
        let source = self.source.to_owned();
        let document = Document { source, translations: Vec::new(), places, program };
        Read { document, statements, questions, scene_words: scene_words.unwrap_or_default() }
    }

    /// The prose with its questions. `place` says which question one as written is, if it is any. Also the words of the
    /// questions by that number, and the number of each question as written.
    fn prose(
        &self,
        diagnostics: &mut Vec<Diagnostic>,
        mut place: impl FnMut(&RawQuestion) -> Option<usize>,
    ) -> (Vec<Section>, Vec<QuestionText>, Vec<Option<usize>>) {
        let mut prose = Prose::new(self.source);
        let mut texts: Vec<QuestionText> = Vec::new();
        let mut numbers = Vec::new();
        for part in &self.parts {
            match part {
                Part::Prose(range) => prose.markdown(range.clone()),
                Part::Fence(fence) if fence.kind == FenceKind::Question => {
                    if numbers.len() == QUESTIONS {
                        let message = words!(
                            "a document cannot have more than {QUESTIONS} questions",
                            "un documento no puede tener más de {QUESTIONS} preguntas"
                        );
                        diagnostics.push(Diagnostic::error("too-large", message, fence.opening));
                        break;
                    }
                    let raw = questions::split(self.source, fence.content.clone(), diagnostics);
                    let number = place(&raw);
                    numbers.push(number);
                    let text = questions::texts(&mut prose, &raw);
                    if let Some(number) = number {
                        texts.resize_with(texts.len().max(number + 1), QuestionText::default);
                        texts[number] = text;
                        prose.question(number);
                    }
                }
                Part::Fence(_) => {}
            }
        }
        let (sections, found) = prose.finish();
        diagnostics.extend(found);
        (sections, texts, numbers)
    }

    /// Adds this file to a document as its edition in another language.
    fn translate(&mut self, read: &mut Read) {
        let Read { document, statements, questions: numbers, scene_words } = read;
        let program = &mut document.program;
        document.translations.push(self.source.to_owned());
        let Some(language) = self.matter.get("language").cloned() else {
            self.diagnostics.push(
                Diagnostic::error(
                    "translation",
                    words("the translation does not say its language", "la traducción no dice su idioma"),
                    Span::new(0, 0),
                )
                .with_hint(words(
                    "its front matter must have a line such as `language: es`",
                    "su cabecera debe tener una línea como `language: es`",
                )),
            );
            return;
        };
        if !settings::is_language(&language.text) {
            self.diagnostics.push(settings::no_language(&language));
            return;
        }
        if program.languages().any(|known| known == language.text) {
            let message =
                words!("the document exists in `{}` already", "el documento ya existe en `{}`", language.text);
            self.diagnostics.push(Diagnostic::error("translation", message, language.span));
            return;
        }
        let mut found = Vec::new();
        self.check_kinds(&mut found);
        let mut texts = Texts::default();
        for fence in self.fences(FenceKind::Translations) {
            texts.read(self.source, fence.content.clone());
        }
        let mut written = 0;
        let mut surplus = Vec::new();
        let mut warnings = Vec::new();
        let (sections, questions, _) = self.prose(&mut found, |raw| {
            questions::check_translation(raw, &mut warnings);
            written += 1;
            if written > numbers.len() {
                surplus.push(Span::new(raw.place.start, raw.place.end));
            }
            numbers.get(written - 1).copied().flatten()
        });
        found.extend(warnings);
        found.extend(surplus.into_iter().map(|span| {
            Diagnostic::error(
                "translation",
                words!("the original has {} questions only", "el original solo tiene {} preguntas", numbers.len()),
                span,
            )
        }));
        if written < numbers.len() {
            let message = match numbers.len() - written {
                1 => words("a question has no translation", "una pregunta no tiene traducción"),
                missing => {
                    words!("{missing} questions have no translation", "{missing} preguntas no tienen traducción")
                }
            };
            found.push(Diagnostic::warning("untranslated", message, language.span));
        }
        let original = program.editions.first().and_then(|original| original.scene.as_ref());
        let scene = original.map(|scene| scene::translated(scene, scene_words, &mut texts));
        let mut table = BTreeMap::new();
        for original in program.translatable() {
            if let Some((text, _)) = texts.translate(original, scene::has_word(original)) {
                table.insert(original.to_owned(), text);
            }
        }
        found.extend(texts.finish(language.span));
        let title = self.matter.get("title").map_or_else(|| program.title.clone(), |title| title.text.clone());
        let translated = |text: &str| table.get(text).map_or(text, String::as_str).to_owned();
        let equations = model::typeset(statements, &translated);
        let language = language.text;
        let edition = Edition { language, title, sections, equations, questions, scene, texts: table };
        program.editions.push(edition);
        self.diagnostics.extend(found);
    }

    /// What belongs to the original only.
    fn check_kinds(&self, found: &mut Vec<Diagnostic>) {
        for kind in [FenceKind::Model, FenceKind::Scene, FenceKind::Plots, FenceKind::Presets] {
            for fence in self.fences(kind) {
                let message =
                    words!("a translation has no `{}` of its own", "una traducción no tiene `{}` propio", kind.word());
                found.push(
                    Diagnostic::error("translation", message, fence.opening)
                        .with_hint(words("the original's is used", "se usa el del original")),
                );
            }
        }
        for key in ["method", "step", "until", "tolerance", "vary"] {
            if let Some(value) = self.matter.get(key) {
                let message =
                    words!("`{key}` in a translation means nothing", "`{key}` no significa nada en una traducción");
                found.push(
                    Diagnostic::warning("translation", message, value.span)
                        .with_hint(words("the original's is used", "se usa el del original")),
                );
            }
        }
    }
}
