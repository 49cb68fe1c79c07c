//! Checks of a drawing after an edit.

use crate::drawing::{Drawing, Item, read};
use crate::edit::{Edit, EditError, Obstacle, layout};
use crate::text::outline::Outline;

/// An element without its places: name, number of enclosing frames and groups, attributes.
pub(super) type Shape = (&'static str, usize, Vec<(String, String)>);

/// The drawing of a document, or [`EditError::NoDrawing`].
pub(super) fn drawing(outline: &Outline) -> Result<Drawing, EditError> {
    read(outline).ok_or(EditError::NoDrawing)
}

/// The element with this index, or [`EditError::UnknownElement`].
pub(super) fn item(drawing: &Drawing, number: usize) -> Result<&Item, EditError> {
    drawing.items.get(number).ok_or(EditError::UnknownElement(number))
}

/// Elements of a drawing without their places.
pub(super) fn shapes(source: &str, drawing: &Drawing) -> Vec<Shape> {
    drawing.items.iter().enumerate().map(|(number, item)| shape(source, (drawing, number), item)).collect()
}

fn shape(source: &str, (drawing, number): (&Drawing, usize), item: &Item) -> Shape {
    let text = |attribute: &crate::drawing::Written| {
        (attribute.name.clone(), source.get(attribute.value.range()).unwrap_or_default().to_owned())
    };
    let around = drawing.outwards(number).skip(1).count();
    (item.kind.name, around, item.attributes.iter().map(text).collect())
}

/// Requires that edits change only the scene and turn the drawing into `expected`.
pub(super) fn expect(
    outline: &Outline,
    drawing: &Drawing,
    edits: &[Edit],
    expected: &[Shape],
) -> Result<(), EditError> {
    let is_expected = |after: &Outline| read(after).is_some_and(|drawing| shapes(after.source(), &drawing) == expected);
    let refusal = EditError::NotOneElement(Obstacle::Other);
    layout::expect(outline, edits, |block, _| block == drawing.block, is_expected, refusal)
}
