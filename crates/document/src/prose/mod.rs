//! Markdown and mathematics to safe HTML and MathML.

mod blanks;
mod html;
mod math;
mod text;

pub use blanks::without_trailing_blanks;

use crate::text::source::trim;
use html::{Piece, render};
use model::Diagnostic;
use program::{Block, Section};
use std::collections::BTreeMap;
use std::ops::Range;
use text::anchor;

/// Collects the prose of a document.
pub struct Prose<'a> {
    source: &'a str,
    formulas: math::Formulas,
    sections: Vec<Section>,
    /// Ids in use, each with the number of sections with this title.
    ids: BTreeMap<String, usize>,
    /// Diagnostics found so far.
    pub diagnostics: Vec<Diagnostic>,
}

impl<'a> Prose<'a> {
    /// Empty prose of `source`.
    pub fn new(source: &'a str) -> Self {
        Self {
            source,
            formulas: math::Formulas::new(),
            sections: Vec::new(),
            ids: BTreeMap::new(),
            diagnostics: Vec::new(),
        }
    }

    /// Appends the Markdown in `range`.
    pub fn markdown(&mut self, range: Range<usize>) {
        for piece in self.render(range) {
            match piece {
                Piece::Html(html) => self.block(Block::Html(html)),
                Piece::Heading { level, title, html } => {
                    let id = self.new_id(&title);
                    self.sections.push(Section { id, title, heading: html, level, blocks: Vec::new() });
                }
            }
        }
    }

    /// Appends the place of a question.
    pub fn question(&mut self, index: usize) {
        self.block(Block::Question(index));
    }

    /// Adds the place of a question that stands in the section `theirs` with index `number` of another edition: to the
    /// section here with the same level and the same index or title, or else to a copy of that section at the end.
    pub fn question_of(&mut self, index: usize, number: usize, theirs: &Section) {
        let counterpart = |(place, ours): &(usize, &mut Section)| {
            ours.level == theirs.level && (*place == number || ours.title == theirs.title)
        };
        let question = Block::Question(index);
        if let Some((_, ours)) = self.sections.iter_mut().enumerate().rfind(counterpart) {
            ours.blocks.push(question);
        } else {
            let id = self.new_id(&theirs.title);
            self.sections.push(Section { id, blocks: vec![question], ..theirs.clone() });
        }
    }

    /// HTML of a text outside the sections. Headings in it become bold paragraphs.
    pub fn fragment(&mut self, range: Range<usize>) -> String {
        let range = trim(self.source, range);
        self.render(range)
            .into_iter()
            .map(|piece| match piece {
                Piece::Html(html) => html,
                Piece::Heading { html, .. } => format!("<p><strong>{html}</strong></p>\n"),
            })
            .collect()
    }

    /// HTML of a text that stands in a line, without the paragraph around it.
    pub fn inline(&mut self, range: Range<usize>) -> String {
        let html = self.fragment(range);
        let inner = html.trim_end().strip_prefix("<p>").and_then(|rest| rest.strip_suffix("</p>"));
        inner.filter(|inner| !inner.contains("<p>")).map_or_else(|| html.clone(), str::to_owned)
    }

    /// Returns the sections and the diagnostics.
    pub fn finish(self) -> (Vec<Section>, Vec<Diagnostic>) {
        (self.sections, self.diagnostics)
    }

    fn render(&mut self, range: Range<usize>) -> Vec<Piece> {
        render(self.source, range, &self.formulas, &mut self.diagnostics)
    }

    fn block(&mut self, block: Block) {
        if self.sections.is_empty() {
            let id = self.new_id("");
            self.sections.push(Section { id, ..Section::default() });
        }
        if let Some(section) = self.sections.last_mut() {
            section.blocks.push(block);
        }
    }

    fn new_id(&mut self, title: &str) -> String {
        let name = anchor(title);
        let mut count = self.ids.get(&name).copied().unwrap_or_default();
        let id = loop {
            count += 1;
            let id = if count == 1 { name.clone() } else { format!("{name}-{count}") };
            if !self.ids.contains_key(&id) {
                break id;
            }
        };
        self.ids.insert(id.clone(), 1);
        self.ids.insert(name, count);
        id
    }
}
