//! State of the construction of a scene: values, texts and references so far, and the current element. Each part of it has
//! private fields of its own.

use super::ids::Ids;
use super::quantity::{Addition, Quantity};
use super::space::Space;
use super::space::marks::Marks;
use super::translate::SceneText;
use super::value_list::ValueList;
use crate::expressions::{Expressions, Placed};
use model::{Diagnostic, Span};
use program::{Element, Graph, NodeId, Scene, Trail};
use std::ops::Range;
use units::{Language, Words, words};

/// Builds one scene.
pub struct Builder<'b, 'a> {
    /// Compiler of the values.
    pub expressions: &'b mut Expressions<'a>,
    /// Ids of elements, and references to them.
    pub ids: Ids,
    /// Number of elements and copies.
    pub quantity: Quantity,
    /// Places of the elements in the picture; `None` if not requested.
    pub marks: Option<Marks>,
    values: ValueList,
    trails: Vec<Trail>,
    /// Index of the value that holds the length represented by one unit of the drawing, from the first frame of lengths.
    length: Option<usize>,
    /// Texts so far, for translations.
    texts: Vec<SceneText>,
    language: Language,
    /// Left, top, width and height of the drawing, in units of the drawing.
    view_box: Option<[f64; 4]>,
    /// Current coordinate system.
    space: Space,
    /// Place of the current element.
    place: Span,
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
    /// `drag-zero`: the vertical coordinate at which it is 0.
    pub zero: Option<Range<usize>>,
}

impl Dragging {
    /// Records the value of one of the attributes.
    pub fn take(&mut self, attribute: &str, value: Range<usize>) {
        match attribute {
            "drag-up" => self.up = Some(value),
            "drag-right" => self.right = Some(value),
            "drag-zero" => self.zero = Some(value),
            _ => self.state = Some(value),
        }
    }
}

impl<'b, 'a> Builder<'b, 'a> {
    /// Begins an empty scene in the coordinates of the drawing. `opening`: its place.
    pub fn new(expressions: &'b mut Expressions<'a>, language: Language, opening: Span, marks: Option<Marks>) -> Self {
        let space = Space::drawing(expressions.graph());
        Self {
            expressions,
            ids: Ids::default(),
            quantity: Quantity::default(),
            marks,
            values: ValueList::default(),
            trails: Vec::new(),
            length: None,
            texts: Vec::new(),
            language,
            view_box: None,
            space,
            place: opening,
        }
    }

    /// The finished scene with its texts and the places of its elements.
    pub fn finish(self, root: Element) -> (Scene, Vec<SceneText>, Option<Marks>) {
        let scene = Scene { root, values: self.values.into_list(), trails: self.trails, length: self.length };
        (scene, self.texts, self.marks)
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
        let addition = self.quantity.draw(more);
        if addition == Addition::Passes {
            self.refuse(words("there are too many parts in this scene"), place, None);
        }
        addition == Addition::Fits
    }

    /// Index of a value among those of the scene. `None` if there are too many, which is reported.
    pub fn value(&mut self, Placed { value, span }: Placed) -> Option<usize> {
        let index = self.values.add(value);
        if index.is_none() {
            self.expressions.error("too-large", ValueList::too_many(), span);
        }
        index
    }

    /// Node of a value of the scene, by its index.
    pub fn value_node(&self, index: usize) -> Option<NodeId> {
        self.values.node(index)
    }

    /// Records the length of one unit of the drawing, unless an earlier frame has one.
    pub fn set_length(&mut self, length: impl FnOnce(&mut Graph) -> Placed) {
        if self.length.is_none() {
            let length = length(self.expressions.graph());
            self.length = self.value(length);
        }
    }

    /// Adds a trail, and returns its index.
    pub fn add_trail(&mut self, trail: Trail) -> usize {
        self.trails.push(trail);
        self.trails.len() - 1
    }

    /// Number of trails so far.
    pub fn trail_count(&self) -> usize {
        self.trails.len()
    }

    /// Records a text for translations; each text of the scene has an entry, in their order.
    pub fn record_text(&mut self, text: SceneText) {
        self.texts.push(text);
    }

    /// Language of the document.
    pub fn language(&self) -> Language {
        self.language
    }

    /// Sets the view box of the drawing, if it is known: left, top, width and height, in units of the drawing.
    pub fn set_view_box(&mut self, view_box: Option<[f64; 4]>) {
        self.view_box = view_box;
    }

    /// Left, top, width and height of the drawing, in units of the drawing.
    pub fn view_box(&self) -> Option<[f64; 4]> {
        self.view_box
    }

    /// Current coordinate system.
    pub fn space(&self) -> &Space {
        &self.space
    }

    /// Enters a coordinate system, and returns the one before.
    pub fn enter_space(&mut self, space: Space) -> Space {
        std::mem::replace(&mut self.space, space)
    }

    /// Place of the current element.
    pub fn element_place(&self) -> Span {
        self.place
    }

    /// Begins an element.
    pub fn begin_element(&mut self, place: Span) {
        self.place = place;
    }

    /// Graph of the model.
    pub fn graph(&mut self) -> &mut Graph {
        self.expressions.graph()
    }
}
