//! Positions of the elements of the drawing in the shown picture.

use super::sketching::{DrawingPlaces, Sketching};
use crate::Desk;

impl Desk {
    /// Positions of the drawing and its elements at the shown time. `None` if the text in the editor is not the running
    /// one, or has no drawing.
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
