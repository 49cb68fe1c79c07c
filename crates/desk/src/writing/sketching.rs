//! State of a drawing while it is edited by hand.

use document::drawing::{Ground, Located, Sketch};
use engine::Readings;

/// Positions of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawingPlaces {
    /// Surface on which new elements are drawn.
    pub ground: Ground,
    /// Positions of the elements in the order of [`document::drawing::Drawing::items`]; `None` if an element is not in
    /// the picture.
    pub elements: Vec<Option<Located>>,
}

/// The parsed drawing of a document.
#[derive(Debug)]
pub(crate) struct Sketching {
    /// The text that was parsed.
    pub source: String,
    /// The drawing and the readings of its values; `None` if the text has no drawing.
    pub sketch: Option<(Sketch, Readings)>,
}

impl Sketching {
    /// Parses the drawing of a text.
    pub fn read(source: &str) -> Self {
        let sketch = Sketch::read(source).map(|sketch| {
            let readings = Readings::new(&sketch.model, &sketch.nodes);
            (sketch, readings)
        });
        Self { source: source.to_owned(), sketch }
    }
}
