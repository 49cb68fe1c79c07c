//! State of a drawing while it is edited by hand.

use document::drawing::{Ground, Located, Sketch};
use engine::Readings;
use play::Play;

/// Positions of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawingPlaces {
    /// Surface on which new elements are drawn.
    pub ground: Ground,
    /// Positions of the elements in the order of [`document::drawing::Drawing::items`]; `None` if an element is not in
    /// the picture.
    pub elements: Vec<Option<Located>>,
}

/// The drawing of the document, parsed once it is edited by hand.
#[derive(Debug, Default)]
pub(crate) struct Sketching {
    parsed: Option<Parsed>,
}

/// The parsed drawing of a text.
#[derive(Debug)]
struct Parsed {
    /// The text that was parsed.
    source: String,
    /// The drawing and the readings of its values; `None` if the text has no drawing.
    sketch: Option<(Sketch, Readings)>,
}

impl Sketching {
    /// Positions of the drawing of a text and its elements in the shown picture of its simulation. `None` if the text has
    /// no drawing.
    pub fn places(&mut self, source: &str, play: &Play) -> Option<DrawingPlaces> {
        let known = self.parsed.take().filter(|known| known.source == source);
        let parsed = self.parsed.insert(known.unwrap_or_else(|| Parsed::read(source)));
        let (sketch, readings) = parsed.sketch.as_mut()?;
        let course = play.course();
        let values = readings.at(course.parameters(), course.initial(), course.time(), course.state());
        let elements = (0..sketch.drawing.items.len()).map(|number| sketch.locate(number, values)).collect();
        Some(DrawingPlaces { ground: sketch.ground(values), elements })
    }
}

impl Parsed {
    /// Parses the drawing of a text.
    fn read(source: &str) -> Self {
        let sketch = Sketch::read(source).map(|sketch| {
            let readings = Readings::new(&sketch.model, &sketch.nodes);
            (sketch, readings)
        });
        Self { source: source.to_owned(), sketch }
    }
}
