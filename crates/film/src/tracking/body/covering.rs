//! A second body that is nowhere in the frame of the click: one of both covered the other there.

use crate::tracking::body::alike::sought;
use crate::tracking::body::{Body, Tracker};

/// Number of sightings of a second body after which it is sought in the frame of the click.
const SIGHTINGS: usize = 2;
/// A second body that is smeared by its motion is at least so much like the clicked one. An even background reaches half of this.
const NOWHERE: f32 = 0.15;

impl Body {
    /// True once if a second body has just been seen for the second time, and is nowhere in the frame of the click.
    pub(super) fn was_covered(&mut self) -> bool {
        let (Some(tracker), Some(template)) = (&mut self.tracker, self.templates.last()) else { return false };
        let Tracker { appearance, background, rival, clicked, .. } = tracker;
        if rival.as_ref().is_none_or(|rival| rival.hidden > 0 || rival.seen.len() != SIGHTINGS) {
            return false;
        }
        let Some((plane, position)) = clicked.take() else { return false };
        let (disc, compared) = (template.disc, background.compare(&plane));
        let range = sought(disc.outline, 0.0).start..libm::hypot(plane.width() as f64, plane.height() as f64);
        let own = (disc.middle(position), disc.outline);
        appearance.look.likest(&compared, own, (range, NOWHERE)).is_none()
    }
}
