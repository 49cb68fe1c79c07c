//! What a scene is built with: the values, texts and references so far, and where the building is.

use super::space::Space;
use super::space::marks::Marks;
use super::translate::SceneText;
use crate::expressions::Expressions;
use model::{Diagnostic, Span};
use program::{Compiled, Graph, NodeId, Trail};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use units::{Language, Words, words};

/// How many elements and pieces of values the parts, copies and computed lines of a scene may consist of.
const DRAWN: usize = 60_000;

/// Builds one scene.
pub struct Builder<'b, 'a> {
    /// Where the values are compiled.
    pub expressions: &'b mut Expressions<'a>,
    /// The values so far.
    pub values: Vec<Compiled>,
    /// Where points have been.
    pub trails: Vec<Trail>,
    /// How long a unit of the drawing is, by the first frame of lengths: the index of a value.
    pub length: Option<usize>,
    /// Which of the values have a node.
    pub numbers: BTreeMap<NodeId, Vec<usize>>,
    /// What the texts so far say.
    pub words: Vec<SceneText>,
    /// The ids that elements have.
    pub ids: BTreeSet<String>,
    /// The ids that attributes refer to.
    pub references: Vec<(String, Range<usize>)>,
    /// The language of the document.
    pub language: Language,
    /// How much parts, copies and computed lines have been drawn with, in elements and pieces of values.
    pub drawn: usize,
    /// How many copies there are of repeated elements.
    pub copied: usize,
    /// How many repeated elements are around the one that is being built.
    pub repeating: usize,
    /// Left, top, width and height of the drawing.
    pub view_box: Option<[f64; 4]>,
    /// What lengths mean here.
    pub space: Space,
    /// Where the element stands that is being built.
    pub place: Span,
    /// Where everything comes to stand, where that is asked for.
    pub marks: Option<Marks>,
}

/// Where the values of the attributes for dragging stand.
#[derive(Default)]
pub struct Dragging {
    /// `drag`: the name of a state or a parameter.
    pub state: Option<Range<usize>>,
    /// `drag-up`: what one unit upwards adds to it.
    pub up: Option<Range<usize>>,
    /// `drag-right`: what one unit to the right adds to it.
    pub right: Option<Range<usize>>,
}

impl Dragging {
    /// Takes the value of one of its attributes.
    pub fn take(&mut self, attribute: &str, value: Range<usize>) {
        match attribute {
            "drag-up" => self.up = Some(value),
            "drag-right" => self.right = Some(value),
            _ => self.state = Some(value),
        }
    }
}

impl Builder<'_, '_> {
    /// The source at a place.
    pub fn source(&self, range: &Range<usize>) -> &str {
        &self.expressions.source[range.clone()]
    }

    /// Reports what is left out.
    pub fn refuse(&mut self, message: Words, range: Range<usize>, hint: Option<Words>) {
        let mut diagnostic = Diagnostic::error("scene-refused", message, Span::new(range.start, range.end));
        diagnostic.hints.extend(hint);
        self.expressions.diagnostics.push(diagnostic);
    }

    /// Reports what is left out.
    pub fn refuse_at(&mut self, message: Words, span: Span, hint: Option<Words>) {
        self.refuse(message, span.start..span.end, hint);
    }

    /// Reports a word that is left out, with the one that was probably meant.
    pub fn refuse_word(&mut self, message: Words, range: Range<usize>, meant: Option<&str>) {
        let mut diagnostic = Diagnostic::error("scene-refused", message, Span::new(range.start, range.end));
        if let Some(meant) = meant {
            diagnostic = diagnostic.meaning(meant);
        }
        self.expressions.diagnostics.push(diagnostic);
    }

    /// Whether so many more elements and pieces of values may be drawn. That they may not is said once.
    pub fn fits(&mut self, more: usize, place: Range<usize>) -> bool {
        let before = self.drawn;
        self.drawn += more;
        if self.drawn > DRAWN && before <= DRAWN {
            let message = words("there are too many parts in this scene", "hay demasiadas partes en esta escena");
            self.refuse(message, place, None);
        }
        self.drawn <= DRAWN
    }

    /// The graph.
    pub fn graph(&mut self) -> &mut Graph {
        self.expressions.graph()
    }
}
