//! Translations: the texts of a document in another language.

use super::translation::Texts;
use crate::blocks::{questions, settings, survey};
use crate::card;
use crate::open::{File, Read};
use crate::scene;
use crate::text::block::BlockKind;
use model::{Diagnostic, Span};
use program::{Block, Edition, Section};
use std::collections::BTreeMap;
use units::{Language, words};

impl File<'_> {
    /// Adds this file to a document as its edition in another language.
    pub(crate) fn translate(&mut self, read: &mut Read) {
        let Read { document, statements, questions: numbers, survey: surveyed, scene_words } = read;
        let program = &mut document.program;
        document.translations.push(self.outline.source().to_owned());
        let Some(language) = self.outline.front_matter().get("language").cloned() else {
            self.diagnostics.push(
                Diagnostic::error("translation", words("the translation does not say its language"), Span::new(0, 0))
                    .with_hint(words("its front matter must have a line such as `language: es`")),
            );
            return;
        };
        if !settings::is_language(&language.text) {
            self.diagnostics.push(settings::no_language(&language));
            return;
        }
        if program.languages().any(|known| known == language.text) {
            let message = words!("the document exists in `{}` already", language.text);
            self.diagnostics.push(Diagnostic::error("translation", message, language.span));
            return;
        }
        let mut found = Vec::new();
        self.check_kinds(&mut found);
        card::check(self.outline.front_matter(), &mut found);
        card::check_translated(&document.source, self.outline.front_matter(), language.span, &mut found);
        let mut texts = Texts::default();
        for block in self.outline.blocks_of(BlockKind::Translations) {
            texts.read(self.outline.source(), &block.sentences);
        }
        let mut written = 0;
        let mut surplus = Vec::new();
        let mut warnings = Vec::new();
        let (mut prose, mut questions, _) = self.prose(&mut found, |raw| {
            questions::check_translation(self.outline.source(), raw, &mut warnings);
            written += 1;
            if written > numbers.len() {
                surplus.push(Span::new(raw.place.start, raw.place.end));
            }
            numbers.get(written - 1).copied().flatten()
        });
        found.extend(warnings);
        found.extend(surplus.into_iter().map(|span| {
            Diagnostic::error("translation", words!("the original has {} questions only", numbers.len()), span)
        }));
        if let Some(original) = program.editions.first() {
            for question in numbers.iter().skip(written).filter_map(|number| *number) {
                let asks = |section: &Section| section.blocks.contains(&Block::Question(question));
                if let Some(number) = original.sections.iter().position(asks) {
                    prose.question_of(question, number, &original.sections[number]);
                }
            }
            found.extend(questions::untranslated(&mut questions, &original.questions, language.span));
        }
        let (sections, faults) = prose.finish();
        found.extend(faults);
        let written = survey::read(&self.outline, &mut found);
        let originals = program.editions.first().map_or(&[][..], |original| &original.survey);
        let survey = survey::translated(written, surveyed, (&program.survey, originals), language.span, &mut found);
        let original = program.editions.first().and_then(|original| original.scene.as_ref());
        let scene =
            original.map(|scene| scene::translated(scene, scene_words, &mut texts, Language::of(&language.text)));
        let mut table = BTreeMap::new();
        for original in program.translatable() {
            if let Some((text, _)) = texts.translate(original, scene::has_word(original)) {
                table.insert(original.to_owned(), text);
            }
        }
        found.extend(texts.finish(language.span));
        let title =
            self.outline.front_matter().get("title").map_or_else(|| program.title.clone(), |title| title.text.clone());
        let translated = |text: &str| table.get(text).map_or(text, String::as_str).to_owned();
        let equations = model::typeset(statements, &translated);
        let language = language.text;
        let edition = Edition { language, title, sections, equations, questions, survey, scene, texts: table };
        program.editions.push(edition);
        self.diagnostics.extend(found);
    }

    /// Warns of blocks that belong in the original only.
    fn check_kinds(&self, found: &mut Vec<Diagnostic>) {
        for kind in [
            BlockKind::Model,
            BlockKind::Table,
            BlockKind::Scene,
            BlockKind::Plots,
            BlockKind::Presets,
            BlockKind::Check,
        ] {
            for block in self.outline.blocks_of(kind) {
                let message = words!("a translation has no `{}` of its own", kind.word());
                found.push(
                    Diagnostic::error("translation", message, block.head()).with_hint(words("the original's is used")),
                );
            }
        }
        for key in ["method", "step", "until", "speed", "tolerance", "vary", "main", "assignment"] {
            if let Some(value) = self.outline.front_matter().get(key) {
                let message = words!("`{key}` in a translation means nothing");
                found.push(
                    Diagnostic::warning("translation", message, value.span).with_hint(words("the original's is used")),
                );
            }
        }
    }
}
