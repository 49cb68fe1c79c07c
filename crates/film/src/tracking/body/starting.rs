//! Start of a track: template of a click, and verification of its disc by the first motion.

use crate::plane::Plane;
use crate::tracking::body::background::Background;
use crate::tracking::body::departure::{Departure, departure};
use crate::tracking::body::disc::Disc;
use crate::tracking::body::look::Look;
use crate::tracking::body::moving::Moving;
use crate::tracking::body::part::{Axis, Part};
use crate::tracking::body::rival::Rivals;
use crate::tracking::body::template::{Found, Template};
use crate::tracking::body::{Body, MARGIN, RADIUS, Start, Tracker, greatest, radii};
use crate::tracking::refusal::Refusal;

/// Minimum coherence of a disc that moves with its body, for the outline in one picture and for a disc found by motion.
const COHERENT: [f64; 2] = [0.12, 0.3];
/// Ratio of the explained changes from which a smaller outline is that of a spot.
const SPOT: f64 = 3.0;
/// Maximum number of frames after the click for a disc found by motion. Later, uniform bodies fit many motions.
const LATEST: usize = 2;
/// Minimum displacement for a disc found by motion, relative to its radius.
const CLEARLY: f64 = 0.25;

impl Body {
    /// Disc with the given radius, if any, in a picture of `high` rows.
    pub(super) fn given(&self, high: f64) -> Option<Disc> {
        let given = self.settings.radius.filter(|radius| radius.is_finite());
        let [least, greatest] = radii(high);
        given.map(|radius| Disc::of([0.0; 2], radius.clamp(least, greatest)))
    }

    /// Makes the template of the body at a position, px.
    pub(super) fn start(
        &mut self,
        plane: &Plane,
        position: [f64; 2],
        disc: Disc,
        background: Option<Background>,
    ) -> Result<Found, Refusal> {
        let middle = disc.middle(position);
        let background = background.unwrap_or_else(|| Background::new(plane, (middle, disc.radius)));
        let compared = background.compare(plane);
        let look = Look::new(&compared, middle, disc.outline);
        let axis = plane.colour().and_then(|_| {
            let [body, around] = look.shades(&compared, middle);
            Axis::between(body, around)
        });
        let part = Part::around(plane, position, disc.reach() + MARGIN, axis.as_ref()).ok_or(Refusal::Plain)?;
        let template = Template::new(&part, position, disc);
        if template.plain() {
            return Err(Refusal::Plain);
        }
        let found = template.align(&part, position, 0.5);
        let start = Some(Start { plane: plane.clone(), click: position, age: 0 });
        let now = template.clone();
        let moving = Moving::new(plane, position, self.seen.len());
        self.tracker = Some(Tracker {
            look,
            now,
            axis,
            background,
            hidden: 0,
            since: 0,
            begin: 0,
            around: 1.0,
            start,
            moving,
            rivals: Rivals::default(),
        });
        self.templates.push(template);
        self.moved.push(false);
        Ok(Found { position, ..found })
    }

    /// Position of the body after its first motion, px. The disc is replaced by that of the motion, if this explains
    /// more.
    pub(super) fn depart(&mut self, plane: &Plane) -> Option<[f64; 2]> {
        let high = plane.height() as f64;
        let (given, disc) = (self.settings.radius.is_some(), self.templates.last()?.disc);
        let tracker = self.tracker.as_mut()?;
        let begin = tracker.begin;
        let mut start = tracker.start.take()?;
        start.age += 1;
        if !start.age.is_power_of_two() {
            tracker.start = Some(start);
            return None;
        }
        let click = start.click;
        let background = Background::new(&start.plane, (disc.middle(click), disc.radius));
        let (first, now) = (background.compare(&start.plane), background.compare(plane));
        let greatest = (RADIUS * high).clamp(3.0, greatest(high));
        let known = departure(&first, &now, click, greatest, Some(disc));
        let known = known.filter(|known| known.coherence > COHERENT[0]);
        if let Some(moved) = self.moved.last_mut() {
            *moved |= known.is_some();
        }
        let sharp = known.is_some_and(|known| known.coherence > COHERENT[1] && disc.outline > greatest / 2.0);
        if given || sharp || start.age > LATEST {
            tracker.start = known.is_none().then_some(start);
            return None;
        }
        let better = |one: &Departure| {
            known.is_none_or(|known| {
                let times = if one.coherence > 2.0 * known.coherence { 1.0 } else { SPOT };
                one.explained > times * known.explained
            })
        };
        let plain = |one: &Departure| {
            let way = libm::hypot(one.way[0], one.way[1]);
            one.coherence > COHERENT[1] && way > CLEARLY * one.disc.outline && better(one)
        };
        let Some(found) = departure(&first, &now, click, greatest, None).filter(plain) else {
            tracker.start = known.is_none().then_some(start);
            return None;
        };
        let place = [0, 1].map(|k| click[k] + found.way[k]);
        let alone = start.age == 1 && self.seen.len() == begin + 1;
        if alone {
            self.templates.pop();
            self.moved.pop();
        }
        let seen = self.start(&start.plane, click, found.disc, None).ok()?;
        if let Some(moved) = self.moved.last_mut() {
            *moved = true;
        }
        let tracker = self.tracker.as_mut()?;
        (tracker.begin, tracker.start) = (begin, None);
        let reach = found.disc.reach() + MARGIN;
        if let Some(last) = self.seen.last_mut().filter(|_| alone) {
            last.part = Part::around(&start.plane, click, reach, tracker.axis.as_ref()).unwrap_or(last.part.clone());
            (last.first, last.now) = (seen, seen);
        }
        Some(place)
    }
}
