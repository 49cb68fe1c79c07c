//! Elements of a drawing.

use super::shapes::{holds_others, kind_of, shows_text};
use crate::BlockKind;
use crate::scene::{Part, RawChild, RawElement, parse};
use crate::text::outline::Outline;
use model::Span;
use std::ops::Range;

/// The elements of a scene that can be gripped, in the order of the text: what comes later is drawn on top.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Drawing {
    /// Which of [`Outline::blocks`] holds it.
    pub block: usize,
    /// The opening tag of the `svg` element.
    pub opening: Span,
    /// Where the `svg` element ends, with its closing tag.
    pub end: usize,
    /// Its elements, those inside a frame or group behind it.
    pub items: Vec<Item>,
}

/// An element.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// What it is.
    pub kind: Part,
    /// From its opening tag to the end of its closing one.
    pub span: Span,
    /// Its opening tag.
    pub opening: Span,
    /// What is written in its opening tag.
    pub attributes: Vec<Written>,
    /// The number of the frame or group around it.
    pub parent: Option<usize>,
    /// Whether it is inside a frame, so that its lengths are those of the problem.
    pub framed: bool,
    /// What its `title` says, or the text that it shows, as it is written.
    pub says: Option<Span>,
}

/// An attribute.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// Its name.
    pub name: String,
    /// With its name and quotation marks.
    pub span: Span,
    /// Inside the quotation marks.
    pub value: Span,
}

impl Item {
    /// An attribute by its name.
    pub fn attribute(&self, name: &str) -> Option<&Written> {
        self.attributes.iter().find(|attribute| attribute.name == name)
    }

    /// Whether it is a frame, which gives what stands in it the units of the problem.
    pub fn is_frame(&self) -> bool {
        self.kind.name == "frame"
    }

    /// What an attribute says.
    pub fn value<'a>(&self, source: &'a str, name: &str) -> Option<&'a str> {
        source.get(self.attribute(name)?.value.range())
    }
}

impl Drawing {
    /// The numbers of the elements that have the same parent as this one, itself among them, in the order of the text.
    pub fn siblings(&self, item: usize) -> Vec<usize> {
        let parent = self.items.get(item).map(|item| item.parent);
        (0..self.items.len()).filter(|number| self.items.get(*number).map(|item| item.parent) == parent).collect()
    }

    /// The numbers of an element and of the frames and groups around it, outwards.
    pub fn outwards(&self, item: usize) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(item), |number| self.items.get(*number)?.parent)
    }

    /// The frame around an element, or itself if it is one.
    pub fn frame_of(&self, item: usize) -> Option<&Item> {
        self.outwards(item).filter_map(|number| self.items.get(number)).find(|item| item.is_frame())
    }

    /// The unit in which the ranges of a frame are written, without brackets.
    pub fn unit_of<'a>(&self, source: &'a str, item: usize) -> Option<&'a str> {
        let range = self.frame_of(item)?.value(source, "x")?;
        let (_, unit) = range.rsplit_once('[')?;
        Some(unit.split_once(']')?.0.trim())
    }
}

/// Reads the scene of a document. `None` where there is none, or no `svg` element in it.
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
    // Behind the value its quotation mark stands.
    let span = Span::new(name.start, value.end + 1);
    Written { name: source[name.clone()].to_owned(), span, value: self::span(value) }
}

/// The text of a label, or of the title of anything else. `None` where it has several parts.
fn says(source: &str, element: &RawElement, kind: Part) -> Option<Span> {
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
