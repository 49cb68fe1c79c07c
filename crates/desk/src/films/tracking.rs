//! Tracking of the open film as a job that the page drives: it requests frames, takes them, and computes in steps.

use crate::films::plan::{by_hand, found, nothing_followed, pictures, plan, stored};
use crate::films::record::Kept;
use crate::films::state::Still;
use crate::films::subject::{Subject, inside};
use crate::{Announcement, Desk, Refusal};
use film::tracking::Following;
use film::tracking::column::Click;
use film::{Plane, capacity};

/// Progress of a tracking.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackingProgress {
    /// Number of frames taken.
    pub taken: usize,
    /// Total number of frames.
    pub of: usize,
    /// True if the frames are read a second time, without repeated ones.
    pub again: bool,
    /// True if all frames have been taken and positions are computed.
    pub computing: bool,
}

impl Desk {
    /// Sets the subject of tracking. The record of the film is kept until there is another result; points clicked by
    /// hand enter it at once. A running tracking is cancelled.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for clicks outside the picture or the film, too many clicks, or without an open film.
    pub fn follow_in_film(&mut self, subject: Subject) -> Result<(), Refusal> {
        let Some((open, work)) = self.films.current_mut() else { return Err(self.no_film()) };
        if let Err(refusal) = subject.check(&open.clip) {
            return Err(self.film_refusal(&refusal.words()));
        }
        work.subject = subject.settled();
        // The outlines belong to the previous clicks and radii.
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

    /// Sets the radius of a body in px; `None` selects the radius found around the click. The record is kept until the
    /// body has been tracked again. A running tracking is cancelled.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for a radius outside the bounds, an unknown body, or without an open film.
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

    /// Sets fixed marks against a shaking camera, in px of the first frame of the used part, for the next tracking.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for marks outside the picture, too many marks, or without an open film.
    pub fn set_fixed_marks(&mut self, marks: Vec<[f64; 2]>) -> Result<(), Refusal> {
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

    /// Starts the tracking from the first frame of the used part.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] if no subject needs tracking, or without an open film.
    pub fn begin_tracking(&mut self) -> Result<(), Refusal> {
        self.begin_following(false)
    }

    /// Continues from the results of an earlier visit. Only the strips of surfaces are read, for the space-time picture
    /// and for corrections. Without results, the film is tracked.
    ///
    /// # Errors
    ///
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

    /// Number of the frame that the tracking needs next; `None` if no tracking runs or it has all frames.
    pub fn wanted_frame(&self) -> Option<usize> {
        let open = self.films.open.as_ref().filter(|open| open.running)?;
        open.following.as_ref()?.wanted()
    }

    /// Takes a stored frame of size [`crate::Clip::plane_size`]. A frame that was not requested is ignored.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] if the film cannot be tracked. The tracking is cancelled then.
    pub fn give_frame(&mut self, frame: usize, plane: Plane) -> Result<(), Refusal> {
        if self.wanted_frame() != Some(frame) {
            return Ok(());
        }
        if let Some(open) = self.films.open.as_mut().filter(|open| open.following.as_ref().is_some_and(is_fresh)) {
            open.still = Some(Still { frame, plane: plane.clone() });
        }
        self.drive(|following| following.take(plane)).map(|_| ())
    }

    /// Skips the requested frame, which cannot be decoded.
    ///
    /// # Errors
    ///
    /// As [`Desk::give_frame`].
    pub fn leave_out_frame(&mut self, frame: usize) -> Result<(), Refusal> {
        if self.wanted_frame() != Some(frame) {
            return Ok(());
        }
        self.drive(Following::leave_out).map(|_| ())
    }

    /// Continues the computation by `steps` steps of less than 1 ms each; ten are a good number. Returns true once the
    /// tracking is finished and the record made. Does nothing while a frame is requested.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] if the film cannot be tracked, and a refusal if there is no room for another record; the
    /// tracks are kept then.
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

    /// Updates the space-time pictures with the frames taken so far. It takes several milliseconds, so that a few calls
    /// per second suffice.
    pub fn show_strips(&mut self) {
        let Some(open) = self.films.open.as_mut().filter(|open| open.running) else { return };
        if let Some(following) = &open.following {
            open.pictures = pictures(following, &open.clip);
            self.revision.films += 1;
        }
    }

    /// True while a tracking runs.
    pub fn is_tracking(&self) -> bool {
        self.films.open.as_ref().is_some_and(|open| open.running)
    }

    /// Progress of the running tracking.
    pub fn tracking_progress(&self) -> Option<TrackingProgress> {
        let open = self.films.open.as_ref().filter(|open| open.running)?;
        let following = open.following.as_ref()?;
        let (taken, of) = following.taken();
        let again = !following.repeated().is_empty();
        Some(TrackingProgress { taken, of, again, computing: following.wanted().is_none() })
    }

    /// Cancels the running tracking. Earlier results are kept.
    pub fn cancel_tracking(&mut self) {
        if let Some(open) = self.films.open.as_mut().filter(|open| open.running) {
            (open.following, open.running) = (None, false);
            open.pictures.clear();
            self.revision.films += 1;
        }
    }

    /// Fixes a surface in a frame to within several px of a click, for instance after a drag on the space-time picture.
    /// [`Desk::advance_tracking`] then repeats only the search of the path and its refinement. A film that was not
    /// tracked since it was opened is tracked first.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for a click outside the picture, or an unknown surface.
    pub fn anchor_surface(&mut self, surface: usize, click: Click) -> Result<(), Refusal> {
        self.correct_surface(surface, click.frame, Some(click))
    }

    /// Removes the correction of a surface in a frame.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for an unknown surface.
    pub fn release_surface(&mut self, surface: usize, frame: usize) -> Result<(), Refusal> {
        self.correct_surface(surface, frame, None)
    }

    /// Sets or removes the anchor of a frame.
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

    /// Lets the tracking continue, and cancels it if it fails.
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

/// True if a tracking has not taken any frame.
fn is_fresh(following: &Following) -> bool {
    following.taken().0 == 0
}
