//! Elements of a drawing.

use super::shapes::{holds_others, kind_of, shows_text};
use crate::BlockKind;
use crate::scene::{Part, RawChild, RawElement, parse};
use crate::text::outline::Outline;
use model::Span;
use std::ops::Range;

/// Elements of a scene that can be edited, in text order: later ones are drawn on top.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Drawing {
    /// Index of its block in [`Outline::blocks`].
    pub block: usize,
    /// Opening tag of the `svg` element.
    pub opening: Span,
    /// Byte after the closing tag of the `svg` element.
    pub end: usize,
    /// Elements; the content of a frame or group follows it.
    pub items: Vec<Item>,
}

/// An element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// Kind of element.
    pub kind: &'static Part,
    /// From the opening tag to the end of the closing tag.
    pub span: Span,
    /// Opening tag.
    pub opening: Span,
    /// Attributes of the opening tag.
    pub attributes: Vec<Written>,
    /// Index of the enclosing frame or group.
    pub parent: Option<usize>,
    /// True inside a frame, where lengths are those of the problem.
    pub framed: bool,
    /// Text of its `title`, or the text that it shows, as written.
    pub says: Option<Span>,
}

/// An attribute.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// Name of the attribute.
    pub name: String,
    /// Span with name and quotation marks.
    pub span: Span,
    /// Span inside the quotation marks.
    pub value: Span,
}

impl Item {
    /// An attribute by its name.
    pub fn attribute(&self, name: &str) -> Option<&Written> {
        self.attributes.iter().find(|attribute| attribute.name == name)
    }

    /// True for a frame, whose content uses the units of the problem.
    pub fn is_frame(&self) -> bool {
        self.kind.name == "frame"
    }

    /// Text of an attribute.
    pub fn value<'a>(&self, source: &'a str, name: &str) -> Option<&'a str> {
        source.get(self.attribute(name)?.value.range())
    }
}

impl Drawing {
    /// Indices of the elements with the same parent as this one, including itself, in text order.
    pub fn siblings(&self, item: usize) -> Vec<usize> {
        let parent = self.items.get(item).map(|item| item.parent);
        (0..self.items.len()).filter(|number| self.items.get(*number).map(|item| item.parent) == parent).collect()
    }

    /// Indices of an element and of the frames and groups around it, from the inside outwards.
    pub fn outwards(&self, item: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(item), |number| self.items.get(*number)?.parent)
    }

    /// The frame around an element, or the element itself if it is a frame.
    pub fn frame_of(&self, item: usize) -> Option<&Item> {
        self.outwards(item).filter_map(|number| self.items.get(number)).find(|item| item.is_frame())
    }

    /// Unit of the ranges of the enclosing frame, without brackets.
    pub fn unit_of<'a>(&self, source: &'a str, item: usize) -> Option<&'a str> {
        let range = self.frame_of(item)?.value(source, "x")?;
        let (_, unit) = range.rsplit_once('[')?;
        Some(unit.split_once(']')?.0.trim())
    }
}

/// Reads the scene of a document. `None` if there is none or it has no `svg` element.
pub fn read(outline: &Outline) -> Option<Drawing> {
    let source = outline.source();
    let mut blocks = outline.blocks().iter().enumerate();
    let (block, scene) = blocks.find(|(_, block)| block.kind == BlockKind::Scene)?;
    let content = scene.content.range();
    let start = content.start + source.get(content.clone())?.find("<svg")?;
    let children = parse(source, start..content.end, &mut Vec::new());
    let svg = children.iter().find_map(|child| match child {
        RawChild::Element(element) if source[element.name.clone()] == *"svg" => Some(element),
        _ => None,
    })?;
    let mut drawing = Drawing { block, opening: span(&svg.opening), end: svg.end, items: Vec::new() };
    drawing.take(source, &svg.children, (None, false));
    Some(drawing)
}

impl Drawing {
    fn take(&mut self, source: &str, children: &[RawChild], (parent, framed): (Option<usize>, bool)) {
        for child in children {
            let RawChild::Element(element) = child else { continue };
            let name = &source[element.name.clone()];
            let Some(kind) = kind_of(name) else { continue };
            self.items.push(Item {
                kind,
                span: Span::new(element.opening.start, element.end),
                opening: span(&element.opening),
                attributes: element.attributes.iter().map(|attribute| written(source, attribute)).collect(),
                parent,
                framed,
                says: says(source, element, kind),
            });
            if holds_others(kind) {
                let inside = (Some(self.items.len() - 1), framed || kind.name == "frame");
                self.take(source, &element.children, inside);
            }
        }
    }
}

fn written(source: &str, (name, value): &(Range<usize>, Range<usize>)) -> Written {
    // The quotation mark after the value is included.
    let span = Span::new(name.start, value.end + 1);
    Written { name: source[name.clone()].to_owned(), span, value: self::span(value) }
}

/// Text of a label, or of the title of any other element. `None` if it has several parts.
fn says(source: &str, element: &RawElement, kind: &Part) -> Option<Span> {
    let text_of = |element: &RawElement| match element.children.as_slice() {
        [RawChild::Text(text)] => Some(span(text)),
        _ => None,
    };
    if shows_text(kind) {
        return text_of(element);
    }
    element.children.iter().find_map(|child| match child {
        RawChild::Element(title) if source[title.name.clone()] == *"title" => text_of(title),
        _ => None,
    })
}

fn span(range: &Range<usize>) -> Span {
    Span::new(range.start, range.end)
}
