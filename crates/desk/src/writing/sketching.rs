//! Where the elements of the drawing stand in the picture that is shown.

use crate::Desk;
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
    source: String,
    /// Nothing if it has no drawing.
    sketch: Option<(Sketch, Readings)>,
}

impl Sketching {
    fn read(source: &str) -> Self {
        let sketch = Sketch::read(source).map(|sketch| {
            let readings = Readings::new(&sketch.model, &sketch.nodes);
            (sketch, readings)
        });
        Self { source: source.to_owned(), sketch }
    }
}

impl Desk {
    /// Where the drawing and its elements stand at the time shown. `None` while the text in the editor is not the one that runs, or has
    /// no drawing.
    pub fn drawing_places(&mut self) -> Option<DrawingPlaces> {
        if self.writing.has_begun() && !self.writing.runs() {
            return None;
        }
        let known = self.sketching.take().filter(|known| known.source == self.document.source);
        let sketching = self.sketching.insert(known.unwrap_or_else(|| Sketching::read(&self.document.source)));
        let (sketch, readings) = sketching.sketch.as_mut()?;
        let course = self.play.course();
        let values = readings.at(course.parameters(), course.initial(), course.time(), course.state());
        let elements = (0..sketch.drawing.items.len()).map(|number| sketch.locate(number, values)).collect();
        Some(DrawingPlaces { ground: sketch.ground(values), elements })
    }
}
