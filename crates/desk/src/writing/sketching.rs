//! What is known of the drawing of a document while it is changed by hand.

use document::drawing::{Ground, Located, Sketch};
use engine::Readings;

/// Where a drawing stands.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawingPlaces {
    /// On what new elements are drawn.
    pub ground: Ground,
    /// The elements in the order of [`document::drawing::Drawing::items`]; `None` for one that is not in the picture.
    pub elements: Vec<Option<Located>>,
}

/// What was read of the drawing of a document.
#[derive(Debug)]
pub(crate) struct Sketching {
    /// The text that was read.
    pub source: String,
    /// Nothing if it has no drawing.
    pub sketch: Option<(Sketch, Readings)>,
}

impl Sketching {
    /// Reads the drawing of a text.
    pub fn read(source: &str) -> Self {
        let sketch = Sketch::read(source).map(|sketch| {
            let readings = Readings::new(&sketch.model, &sketch.nodes);
            (sketch, readings)
        });
        Self { source: source.to_owned(), sketch }
    }
}
