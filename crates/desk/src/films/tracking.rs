//! The tracking of the open film as a job that the page drives: it asks for frames, takes them, and computes in portions.

use crate::films::plan::{by_hand, found, nothing_followed, pictures, plan, stored};
use crate::films::record::Kept;
use crate::films::state::Still;
use crate::films::subject::{Subject, inside};
use crate::{Announcement, Desk, Refusal};
use film::tracking::Following;
use film::tracking::column::Click;
use film::{Plane, capacity};

/// How far a tracking is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackingProgress {
    /// How many frames have been taken.
    pub taken: usize,
    /// Of how many.
    pub of: usize,
    /// Whether the frames are taken a second time, without repeated ones.
    pub again: bool,
    /// Whether all have been taken, and positions are being computed.
    pub computing: bool,
}

impl Desk {
    /// Takes what is followed in the open film. A record that the film has become stays until something else has been found; points
    /// that are clicked by hand are in it at once. A tracking that has begun is given up.
    ///
    /// # Errors
    /// Clicks outside the picture or the film, too many of them, and where no film is open.
    pub fn follow_in_film(&mut self, subject: Subject) -> Result<(), Refusal> {
        let Some((open, work)) = self.films.current_mut() else { return Err(self.no_film()) };
        if let Err(refusal) = subject.check(&open.clip) {
            return Err(self.film_refusal(&refusal.words()));
        }
        work.subject = subject.settled();
        // They belong to other clicks and radii.
        work.found.iter_mut().flat_map(|found| &mut found.tracks).for_each(|track| track.outline = None);
        (open.following, open.running) = (None, false);
        open.pictures.clear();
        if let Subject::Points { clicks, sigma } = &work.subject {
            work.found = Some(by_hand(clicks, *sigma, &open.clip, work.factor()));
            return self.film_changed(Kept { origin: true, offsets: true });
        }
        self.revision.films += 1;
        Ok(())
    }

    /// Sets the radius of a body in pixels; `None` lets it be found around the click. The record stays until the body has been tracked
    /// again; a tracking that has begun is given up.
    ///
    /// # Errors
    /// A radius that cannot be followed in this picture, and where no body of this number or no film is there.
    pub fn set_radius(&mut self, body: usize, radius: Option<f64>) -> Result<(), Refusal> {
        let Some((_, work)) = self.films.current() else { return Err(self.no_film()) };
        let mut subject = work.subject.clone();
        let own = match &mut subject {
            Subject::Bodies(bodies) => bodies.get_mut(body),
            _ => None,
        };
        let Some(own) = own else { return Err(self.film_refusal(&nothing_followed())) };
        own.radius = radius;
        self.follow_in_film(subject)
    }

    /// Takes marks that rest, against a camera that shakes, as they are in the first frame of the part. The next tracking uses them.
    ///
    /// # Errors
    /// Marks outside the picture, and where no film is open.
    pub fn set_resting_marks(&mut self, marks: Vec<[f64; 2]>) -> Result<(), Refusal> {
        let Some((open, work)) = self.films.current_mut() else { return Err(self.no_film()) };
        let checked = marks.iter().try_for_each(|mark| inside(*mark, open.clip.size()));
        let checked = checked.and_then(|()| film::tracking::Marks::new(marks.clone()).map(drop));
        if let Err(refusal) = checked {
            return Err(self.film_refusal(&refusal.words()));
        }
        work.marks = marks;
        (open.following, open.running) = (None, false);
        self.revision.films += 1;
        Ok(())
    }

    /// Begins to track what is followed, from the first frame of the part on.
    ///
    /// # Errors
    /// Where nothing is followed that has to be tracked, and where no film is open.
    pub fn begin_tracking(&mut self) -> Result<(), Refusal> {
        self.begin_following(false)
    }

    /// Takes up what was found in the open film at an earlier visit: nothing is tracked again, and only the strips of surfaces are read for
    /// the space-time picture and for corrections. Where nothing is known of what is followed, it is tracked.
    ///
    /// # Errors
    /// As [`Desk::begin_tracking`].
    pub fn take_up_tracking(&mut self) -> Result<(), Refusal> {
        let Some((_, work)) = self.films.current() else { return Err(self.no_film()) };
        let is_found = work.found.is_some() && !work.tracks().iter().all(|track| track.points.is_empty());
        match &work.subject {
            Subject::Surfaces(_) => self.begin_following(is_found),
            Subject::Bodies(_) if !is_found => self.begin_following(false),
            _ => Ok(()),
        }
    }

    fn begin_following(&mut self, reading: bool) -> Result<(), Refusal> {
        let Some((open, work)) = self.films.current_mut() else { return Err(self.no_film()) };
        if !work.subject.needs_tracking() {
            return Err(self.film_refusal(&nothing_followed()));
        }
        let plan = plan(&open.clip, work);
        match capacity::check(&plan, open.clip.plane_size()).and_then(|()| Following::new(plan)) {
            Ok(following) => {
                (open.following, open.running, open.reading, open.finished) = (Some(following), true, reading, reading);
                open.pictures.clear();
                self.revision.films += 1;
                Ok(())
            }
            Err(refusal) => Err(self.film_refusal(&refusal.words())),
        }
    }

    /// The frame that the tracking needs next; `None` where none is running or it has all frames.
    pub fn wanted_frame(&self) -> Option<usize> {
        let open = self.films.open.as_ref().filter(|open| open.running)?;
        open.following.as_ref()?.wanted()
    }

    /// Hands over a frame as it is stored, [`crate::Clip::plane_size`] large. A frame that is not wanted is ignored.
    ///
    /// # Errors
    /// Where the film cannot be followed; the tracking is given up then.
    pub fn give_frame(&mut self, frame: usize, plane: Plane) -> Result<(), Refusal> {
        if self.wanted_frame() != Some(frame) {
            return Ok(());
        }
        if let Some(open) = self.films.open.as_mut().filter(|open| open.following.as_ref().is_some_and(is_fresh)) {
            open.still = Some(Still { frame, plane: plane.clone() });
        }
        self.drive(|following| following.take(plane)).map(|_| ())
    }

    /// Goes on without the frame that is wanted: it could not be decoded.
    ///
    /// # Errors
    /// As [`Desk::give_frame`].
    pub fn leave_out_frame(&mut self, frame: usize) -> Result<(), Refusal> {
        if self.wanted_frame() != Some(frame) {
            return Ok(());
        }
        self.drive(Following::leave_out).map(|_| ())
    }

    /// Computes on by as many steps, each of less than a millisecond; ten are a good portion. True once the tracking is finished: the
    /// record is there then. Nothing happens while a frame is wanted.
    ///
    /// # Errors
    /// Where the film cannot be followed, and where there is no room for another record; what was found is kept then.
    pub fn advance_tracking(&mut self, steps: usize) -> Result<bool, Refusal> {
        if self.wanted_frame().is_none() && self.films.open.as_ref().is_some_and(|open| open.running && open.reading) {
            self.show_strips();
            if let Some(open) = &mut self.films.open {
                (open.running, open.reading) = (false, false);
            }
            return Ok(true);
        }
        if self.drive(|following| following.advance(steps))? != Some(true) {
            return Ok(false);
        }
        let Some((open, work)) = self.films.current_mut() else { return Ok(false) };
        open.running = false;
        let corrected = work.found.is_some() && std::mem::replace(&mut open.finished, true);
        if let Some(following) = &open.following {
            work.found = Some(found(following, &open.clip, work.factor()));
            open.pictures = pictures(following, &open.clip);
        }
        let kept = Kept { origin: corrected, offsets: corrected };
        self.film_changed(kept)?;
        self.announce(Announcement::FilmTracked);
        Ok(true)
    }

    /// Brings the space-time pictures up to the frames that have been taken. It takes some milliseconds: a few times a second will do.
    pub fn show_strips(&mut self) {
        let Some(open) = self.films.open.as_mut().filter(|open| open.running) else { return };
        if let Some(following) = &open.following {
            open.pictures = pictures(following, &open.clip);
            self.revision.films += 1;
        }
    }

    /// Whether a tracking is running.
    pub fn is_tracking(&self) -> bool {
        self.films.open.as_ref().is_some_and(|open| open.running)
    }

    /// How far the tracking is that is running.
    pub fn tracking_progress(&self) -> Option<TrackingProgress> {
        let open = self.films.open.as_ref().filter(|open| open.running)?;
        let following = open.following.as_ref()?;
        let (taken, of) = following.taken();
        let again = !following.repeated().is_empty();
        Some(TrackingProgress { taken, of, again, computing: following.wanted().is_none() })
    }

    /// Gives up the tracking that is running; what an earlier one has found stays.
    pub fn cancel_tracking(&mut self) {
        if let Some(open) = self.films.open.as_mut().filter(|open| open.running) {
            (open.following, open.running) = (None, false);
            open.pictures.clear();
            self.revision.films += 1;
        }
    }

    /// Fixes a surface in a frame to within some pixels of a click, such as the end of a drag on the space-time picture. Only the path
    /// and what follows from it are computed again, by [`Desk::advance_tracking`]; a film that has not been tracked since it was
    /// opened is tracked first.
    ///
    /// # Errors
    /// A click outside the picture, and where no surface of this number is followed.
    pub fn anchor_surface(&mut self, surface: usize, click: Click) -> Result<(), Refusal> {
        self.correct_surface(surface, click.frame, Some(click))
    }

    /// Removes the correction of a surface in a frame.
    ///
    /// # Errors
    /// Where no surface of this number is followed.
    pub fn release_surface(&mut self, surface: usize, frame: usize) -> Result<(), Refusal> {
        self.correct_surface(surface, frame, None)
    }

    /// Puts an anchor in place of that of a frame, or none.
    fn correct_surface(&mut self, surface: usize, frame: usize, anchor: Option<Click>) -> Result<(), Refusal> {
        let Some((open, work)) = self.films.current_mut() else { return Err(self.no_film()) };
        let mut subject = work.subject.clone();
        let own = match &mut subject {
            Subject::Surfaces(surfaces) => surfaces.get_mut(surface),
            _ => None,
        };
        let Some(own) = own else { return Err(self.film_refusal(&nothing_followed())) };
        own.anchors.retain(|other| other.frame != frame);
        own.anchors.extend(anchor);
        if let Err(refusal) = subject.check(&open.clip) {
            return Err(self.film_refusal(&refusal.words()));
        }
        work.subject = subject;
        let Some(following) = open.following.as_mut().filter(|_| !open.reading) else { return self.begin_tracking() };
        match anchor {
            Some(click) => following.anchor(surface, stored(&open.clip, &click)),
            None => following.release(surface, frame),
        }
        open.running = true;
        self.revision.films += 1;
        Ok(())
    }

    /// Lets the tracking go on, and gives it up where it fails.
    fn drive<T>(
        &mut self,
        go_on: impl FnOnce(&mut Following) -> Result<T, film::tracking::Refusal>,
    ) -> Result<Option<T>, Refusal> {
        let Some(open) = self.films.open.as_mut().filter(|open| open.running) else { return Ok(None) };
        let Some(following) = &mut open.following else { return Ok(None) };
        match go_on(following) {
            Ok(value) => Ok(Some(value)),
            Err(refusal) => {
                self.cancel_tracking();
                Err(self.film_refusal(&refusal.words()))
            }
        }
    }
}

/// Whether a tracking has taken no frame yet.
fn is_fresh(following: &Following) -> bool {
    following.taken().0 == 0
}
