//! Search for a body by its appearance, and the update of the appearance.

use crate::tracking::body::background::{Around, Compared};
use crate::tracking::body::disc::Disc;
use crate::tracking::body::look::Look;
use crate::tracking::body::outline::Outline;
use crate::tracking::body::part::{Axis, MARGIN, Part};
use crate::tracking::body::template::{Found, Template};

/// Minimum agreement of a body, relative to the best possible one.
pub(super) const AGREES: f32 = 0.45;
/// Increase of the fraction of the ring without background from which something touches the body.
const TOUCH: f32 = 0.2;
/// Minimum correlation of a template that was found.
const SCORE: f64 = 0.6;
/// Minimum correlation at which the first template is used. It does not drift.
const CLEAR: f64 = 0.85;
/// Minimum agreement for an update of the appearance.
const WHOLE: f32 = 0.75;
/// Best possible agreement below which body and background are too similar, so that the template alone decides.
const DISTINCT: f32 = 0.2;
/// Best possible agreement from which an agreement shows a second body rather than the background.
const CERTAIN: f32 = 0.5;
/// Minimum agreement of an outline that shows the position whatever the look, and its minimum increase from a position by the look.
const OUTLINED: (f32, f32) = (0.6, 0.02);
/// Variance of a position by the pixels that differ from the background, px².
const UNALIGNED: [f64; 2] = [1.0; 2];
/// Maximum distance in radii of the outline from the position by the look, and variance of its position, px².
const OUTLINE: (f64, f64) = (0.5, 0.25);
/// Fraction of the deviation by which the template is updated in each frame.
const PACE: f64 = 0.2;

/// Appearance of a body.
pub(super) struct Appearance {
    pub look: Look,
    /// Template that is updated.
    pub now: Template,
    pub axis: Option<Axis>,
    /// Outline of a body that was found by its motion.
    pub outline: Option<Outline>,
    /// Usual fraction of the ring around the body that does not show the background: smear, a rod.
    pub around: f32,
}

/// Result of the search in a frame.
pub(super) struct Sighting {
    pub found: Found,
    /// Agreement relative to the best possible one.
    pub agreement: f64,
    /// True if the body was away from its predicted position, or hidden before.
    pub aside: bool,
    /// True if the position is that of the updated template, which may drift.
    pub updated: bool,
    /// True if the position is that of the outline, whatever the look.
    pub outlined: bool,
    /// True if nothing else touches the body.
    pub free: bool,
    /// Fraction of the body that another one covers.
    pub covered: f32,
    /// True if body and background differ so much here that an agreement shows a body.
    pub is_distinct: bool,
    /// Vector to the other body, px, if that may cover a part of this one.
    pub beside: Option<[f64; 2]>,
    /// Fraction of the ring that does not show the background.
    pub outside: f32,
    pub part: Option<Part>,
}

impl Sighting {
    /// Body at a click.
    pub(super) fn clicked(found: Found, aside: bool) -> Sighting {
        Sighting {
            found,
            agreement: 1.0,
            aside,
            updated: false,
            outlined: false,
            free: true,
            covered: 0.0,
            is_distinct: true,
            beside: None,
            outside: 0.0,
            part: None,
        }
    }
}

impl Appearance {
    /// Finds the body within `reach` px of a point, with an agreement of at least `part_of_best` times the best
    /// possible one. Pixels that belong to another body of the same look, whose position (px) is `other`, do not count.
    pub(super) fn seek(
        &self,
        (compared, first): (&Compared<'_>, &Template),
        (around, reach): ([f64; 2], f64),
        part_of_best: f32,
        other: Option<[f64; 2]>,
    ) -> Option<Sighting> {
        let disc = first.disc;
        let taken: Option<Around> = other.map(|other| (disc.middle(other), disc.outline));
        let beside = |place: [f64; 2]| {
            let beside = other.map(|other| [0, 1].map(|k| other[k] - place[k]));
            beside.filter(|[x, y]| libm::hypot(*x, *y) < disc.radius + disc.blurred())
        };
        let (middle, mut agreement) = self.look.search(compared, disc.middle(around), reach, taken);
        let place = [middle[0] - disc.shift[0], middle[1] - disc.shift[1]];
        let part = Part::around(compared.plane, place, disc.reach() + MARGIN, self.axis.as_ref())?;
        let mut found = first.align(&part, place, 2.0, beside(place));
        let mut updated = false;
        if found.score < CLEAR {
            let now = self.now.align(&part, place, 2.0, beside(place));
            if now.score > found.score {
                (found, updated) = (now, true);
            }
        }
        let own = self.look.at(compared, disc.middle(found.position), taken);
        if found.score < SCORE || own.score < agreement.score - 0.1 {
            // Position by the pixels that differ from the background, accurate to about 1 px.
            found = Found { position: place, variance: UNALIGNED, settled: true, light: [1.0, 0.0], ..found };
        } else {
            agreement = own;
        }
        let mut relative = agreement.relative();
        let outlined = self.outlined(compared, &found, first.disc).filter(|_| other.is_none());
        if let Some((middle, value)) = outlined {
            let position = [0, 1].map(|k| middle[k] - disc.shift[k]);
            found = Found { position, variance: [OUTLINE.1; 2], settled: true, light: [1.0, 0.0], ..found };
            agreement = self.look.at(compared, middle, taken);
            relative = agreement.relative().max(value);
            updated = false;
        }
        let seen = outlined.is_some() || agreement.best > DISTINCT * (1.0 - agreement.covered) || found.score >= SCORE;
        if !seen || relative < part_of_best {
            return None;
        }
        Some(Sighting {
            agreement: f64::from(relative),
            aside: false,
            updated,
            outlined: outlined.is_some(),
            free: agreement.outside < self.around + TOUCH,
            covered: agreement.covered,
            is_distinct: agreement.best > CERTAIN * (1.0 - agreement.covered),
            beside: beside(found.position),
            outside: agreement.outside,
            found,
            part: Some(part),
        })
    }

    /// Middle of the outline near a position at which the look is not clear, and its agreement; `None` unless it is better there.
    fn outlined(&self, compared: &Compared<'_>, found: &Found, disc: Disc) -> Option<([f64; 2], f32)> {
        let outline = self.outline.as_ref().filter(|_| found.score < CLEAR)?;
        let middle = disc.middle(found.position);
        let here = outline.at(compared, middle.map(|at| at.floor() as i64))?;
        let best = outline.near(compared, middle, OUTLINE.0 * disc.outline + 1.0)?;
        let least = if found.score < SCORE || found.variance == UNALIGNED { here } else { here + OUTLINED.1 };
        (best.1 > OUTLINED.0 && best.1 >= least).then_some(best)
    }

    /// Updates the appearance with what was found in a frame, where no other body is near.
    pub(super) fn adapt(&mut self, compared: &Compared<'_>, one: &Sighting) {
        if !one.free {
            return;
        }
        self.around = if self.around < 1.0 { self.around + 0.2 * (one.outside - self.around) } else { one.outside };
        if let Some(part) =
            one.part.as_ref().filter(|_| one.outlined || one.found.score >= SCORE && one.agreement > f64::from(WHOLE))
        {
            self.now.follow(part, &one.found, PACE);
            self.look.follow(compared, self.now.disc.middle(one.found.position));
        }
    }

    /// Follows the size of a body that was found by its motion. Returns the new template once the size differs from that of the old one.
    pub(super) fn resize(&mut self, compared: &Compared<'_>, one: &Sighting) -> Option<Template> {
        let middle = self.now.disc.middle(one.found.position);
        let outline = self.outline.as_mut()?;
        outline.follow(compared, middle);
        let shape = outline.resized()?;
        let disc = Disc::around_shape(self.now.disc.shift, &shape);
        let part = Part::around(compared.plane, one.found.position, disc.reach() + MARGIN, self.axis.as_ref())?;
        self.now = Template::new(&part, one.found.position, disc, &shape);
        self.look = Look::new(compared, middle, &shape);
        *outline = Outline::new(shape, compared, middle);
        Some(self.now.clone())
    }

    /// Another body of the same look, which matches the template, at a distance (px) in the range from the body at a position, with an agreement of
    /// at least `least` times the best possible one.
    pub(super) fn rival(
        &self,
        (compared, first): (&Compared<'_>, &Template),
        position: [f64; 2],
        (range, least): (std::ops::Range<f64>, f32),
    ) -> Option<Sighting> {
        let disc = first.disc;
        let place = self.look.rival(compared, (disc.middle(position), disc.outline), (range, least))?;
        let place = [place[0] - disc.shift[0], place[1] - disc.shift[1]];
        self.seek((compared, first), (place, 2.0), 0.0, Some(position)).filter(|one| one.found.score >= SCORE)
    }
}
