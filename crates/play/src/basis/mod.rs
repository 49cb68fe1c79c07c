//! The program in the language of the visitor: its texts, and numbers as the visitor writes and reads them.

pub(crate) mod assigning;
pub(crate) mod calculator;
pub(crate) mod input;
mod labels;
pub(crate) mod typed;

use crate::number::Style;
use engine::Setup;
use program::{Model, Program, Scene, Seat};
use units::Language;

/// The program in the language of the visitor.
#[derive(Debug)]
pub struct Basis {
    program: Program,
    /// Language tag of the document's texts; any tag.
    tag: String,
    /// Language of all other texts.
    language: Language,
    style: Style,
    /// Settings of the document.
    defaults: Setup,
    /// For each node of the model, true if its value is a count.
    whole: Vec<bool>,
}

impl Basis {
    /// The program in its own language.
    pub(crate) fn new(program: Program) -> Self {
        let tag = program.language.clone();
        Self {
            language: Language::of(&tag),
            style: Style::of(&tag),
            defaults: Setup::of(&program),
            whole: program.model.whole_numbers(),
            tag,
            program,
        }
    }

    /// The program.
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// Model of the program.
    pub fn model(&self) -> &Model {
        &self.program.model
    }

    /// Language tag of the program's texts, as chosen.
    pub fn tag(&self) -> &str {
        &self.tag
    }

    /// Language of all other texts.
    pub fn language(&self) -> Language {
        self.language
    }

    /// Number format of the chosen language.
    pub fn style(&self) -> Style {
        self.style
    }

    /// Settings of the document.
    pub fn defaults(&self) -> &Setup {
        &self.defaults
    }

    /// Scene of the chosen language.
    pub fn scene(&self) -> Option<&Scene> {
        self.program.scene(&self.tag)
    }

    /// Translation of a document text into the chosen language.
    pub fn text<'a>(&'a self, original: &'a str) -> &'a str {
        self.program.text(&self.tag, original)
    }

    /// For each node of the model, true if its value is a count.
    pub(crate) fn whole(&self) -> &[bool] {
        &self.whole
    }

    /// Gives the assigned parameters the values of a seat, as defaults.
    pub(crate) fn set_seat(&mut self, seat: Option<Seat>) {
        if self.program.set_seat(seat) {
            self.defaults = Setup::of(&self.program);
        }
    }

    /// Sets the language; any tag.
    pub(crate) fn set_language(&mut self, tag: &str) {
        tag.clone_into(&mut self.tag);
        self.language = Language::of(tag);
        self.style = Style::of(tag);
    }

    /// Replaces the drawn curves of the model. Returns false if they are unchanged.
    pub(crate) fn set_drawings(&mut self, drawings: &[Vec<f64>]) -> bool {
        let Some(model) = self.program.model.with_drawings(drawings) else { return false };
        self.program.model = model;
        true
    }
}
