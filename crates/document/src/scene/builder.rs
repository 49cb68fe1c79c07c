//! State of the construction of a scene: values, texts and references so far, and the current element.

use super::space::Space;
use super::space::marks::Marks;
use super::translate::SceneText;
use crate::expressions::Expressions;
use model::{Diagnostic, Span};
use program::{Compiled, Graph, NodeId, Trail};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use units::{Language, Words, words};

/// Maximum number of elements and pieces of values in parts, copies and computed lines of a scene.
const DRAWN: usize = 60_000;

/// Builds one scene.
pub struct Builder<'b, 'a> {
    /// Compiler of the values.
    pub expressions: &'b mut Expressions<'a>,
    /// Values so far.
    pub values: Vec<Compiled>,
    /// Trails of points.
    pub trails: Vec<Trail>,
    /// Index of the value that holds the length represented by one unit of the drawing, from the first frame of lengths.
    pub length: Option<usize>,
    /// Indices of the values of each node.
    pub numbers: BTreeMap<NodeId, Vec<usize>>,
    /// Texts so far, for translations.
    pub words: Vec<SceneText>,
    /// Ids of elements.
    pub ids: BTreeSet<String>,
    /// Ids to which attributes refer, with the places of the references.
    pub references: Vec<(String, Range<usize>)>,
    /// Language of the document.
    pub language: Language,
    /// Number of elements and pieces of values drawn so far in parts, copies and computed lines.
    pub drawn: usize,
    /// Number of copies of repeated elements so far.
    pub copied: usize,
    /// Number of repeated elements around the current one.
    pub repeating: usize,
    /// Left, top, width and height of the drawing, in units of the drawing.
    pub view_box: Option<[f64; 4]>,
    /// Current coordinate system.
    pub space: Space,
    /// Place of the current element.
    pub place: Span,
    /// Places of the elements in the picture; `None` if not requested.
    pub marks: Option<Marks>,
}

/// Places of the values of the attributes for dragging.
#[derive(Default)]
pub struct Dragging {
    /// `drag`: name of a state or a parameter.
    pub state: Option<Range<usize>>,
    /// `drag-up`: its change per unit upwards.
    pub up: Option<Range<usize>>,
    /// `drag-right`: its change per unit to the right.
    pub right: Option<Range<usize>>,
}

impl Dragging {
    /// Records the value of one of the attributes.
    pub fn take(&mut self, attribute: &str, value: Range<usize>) {
        match attribute {
            "drag-up" => self.up = Some(value),
            "drag-right" => self.right = Some(value),
            _ => self.state = Some(value),
        }
    }
}

impl Builder<'_, '_> {
    /// The source text of a byte range.
    pub fn source(&self, range: &Range<usize>) -> &str {
        &self.expressions.source[range.clone()]
    }

    /// Reports something that is left out.
    pub fn refuse(&mut self, message: Words, range: Range<usize>, hint: Option<Words>) {
        let mut diagnostic = Diagnostic::error("scene-refused", message, Span::new(range.start, range.end));
        diagnostic.hints.extend(hint);
        self.expressions.diagnostics.push(diagnostic);
    }

    /// Reports something that is left out.
    pub fn refuse_at(&mut self, message: Words, span: Span, hint: Option<Words>) {
        self.refuse(message, span.start..span.end, hint);
    }

    /// Reports a word that is left out, with the word that was probably meant.
    pub fn refuse_word(&mut self, message: Words, range: Range<usize>, meant: Option<&str>) {
        let mut diagnostic = Diagnostic::error("scene-refused", message, Span::new(range.start, range.end));
        if let Some(meant) = meant {
            diagnostic = diagnostic.meaning(meant);
        }
        self.expressions.diagnostics.push(diagnostic);
    }

    /// Counts `more` elements and pieces of values. Returns false above the limit, which is reported once.
    pub fn fits(&mut self, more: usize, place: Range<usize>) -> bool {
        let before = self.drawn;
        self.drawn += more;
        if self.drawn > DRAWN && before <= DRAWN {
            let message = words("there are too many parts in this scene");
            self.refuse(message, place, None);
        }
        self.drawn <= DRAWN
    }

    /// Graph of the model.
    pub fn graph(&mut self) -> &mut Graph {
        self.expressions.graph()
    }
}
