//! Picture on the canvas: the running scene.

use super::hand::Hand;
use super::seen::Seen;
use std::cell::RefCell;
use std::rc::Rc;
use view::scene::picture::Picture;
use view::views::document;
use web_sys::{Element, SvgElement};

/// Picture of the canvas, rebuilt for each program.
#[derive(Clone, Default)]
pub struct Canvas(Rc<RefCell<Option<Picture>>>);

impl Canvas {
    /// The `svg` of the picture.
    pub fn root(&self) -> Option<SvgElement> {
        self.0.borrow().as_ref().map(|picture| picture.root().clone())
    }

    /// Builds the picture of the present program in an element.
    pub fn build(&self, hand: Hand, place: &Element) {
        place.set_inner_html("");
        let Ok(inner) = document().create_element("div") else { return };
        let _ = place.append_child(&inner);
        let language = hand.app.language.get_untracked();
        let picture = hand.app.read(|play| {
            let scene = play.program().scene(language.tag())?;
            Picture::build(scene, &inner)
        });
        *self.0.borrow_mut() = picture;
    }

    /// Updates the picture to the present state.
    pub fn draw(&self, hand: Hand) {
        let Ok(mut picture) = self.0.try_borrow_mut() else { return };
        if let Some(picture) = picture.as_mut() {
            hand.app.read(|play| picture.draw(play));
        }
    }

    /// Updates the picture to the present state and measures the geometry of its elements.
    pub fn measure(&self, hand: Hand) {
        self.draw(hand);
        let Ok(picture) = self.0.try_borrow() else { return };
        let seen = picture.as_ref().and_then(|picture| {
            let places = hand.app.read_desk(|desk| desk.drawing_places())?;
            Seen::measure(picture.root(), places)
        });
        if hand.seen.with_untracked(|known| *known != seen) {
            hand.seen.set(seen);
        }
    }
}
