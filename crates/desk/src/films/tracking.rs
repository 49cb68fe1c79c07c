//! Tracking of the open film as a job that the page drives: it requests frames, takes them, and computes in steps.

use crate::films::plan::{by_hand, found, nothing_followed, pictures, plan, stored};
use crate::films::record::Kept;
use crate::films::state::Still;
use crate::films::subject::{Subject, inside};
use crate::films::{Films, ShownFilms, no_film, refused};
use crate::{Changes, Refusal};
use film::tracking::Following;
use film::tracking::column::Click;
use film::{Plane, capacity};
use play::Play;

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

impl Films {
    /// Sets the subject of tracking. The record of the film is kept until there is another result; points clicked by
    /// hand enter it at once. A running tracking is cancelled.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for clicks outside the picture or the film, too many clicks, or without an open film.
    pub fn follow(&mut self, play: &Play, subject: Subject) -> Result<Option<Kept>, Refusal> {
        let Some((open, work)) = self.current_mut() else { return Err(no_film(play)) };
        if let Err(refusal) = subject.check(&open.clip) {
            return Err(refused(play, &refusal.words()));
        }
        work.subject = subject.settled();
        // The outlines belong to the previous clicks and radii.
        work.found.iter_mut().flat_map(|found| &mut found.tracks).for_each(|track| track.outline = None);
        (open.following, open.running) = (None, false);
        open.pictures.clear();
        if let Subject::Points { clicks, sigma } = &work.subject {
            work.found = Some(by_hand(clicks, *sigma, &open.clip, work.factor()));
            return Ok(Some(Kept { origin: true, offsets: true }));
        }
        Ok(None)
    }

    /// Sets the radius of a body in px; `None` selects the radius found around the click. The record is kept until the
    /// body has been tracked again. A running tracking is cancelled.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for a radius outside the bounds, an unknown body, or without an open film.
    pub fn set_radius(&mut self, play: &Play, body: usize, radius: Option<f64>) -> Result<Option<Kept>, Refusal> {
        let Some((_, work)) = self.current() else { return Err(no_film(play)) };
        let mut subject = work.subject.clone();
        let own = match &mut subject {
            Subject::Bodies(bodies) => bodies.get_mut(body),
            _ => None,
        };
        let Some(own) = own else { return Err(refused(play, &nothing_followed())) };
        own.radius = radius;
        self.follow(play, subject)
    }

    /// Sets fixed marks against a shaking camera, in px of the first frame of the used part, for the next tracking.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for marks outside the picture, too many marks, or without an open film.
    pub fn set_fixed_marks(&mut self, play: &Play, marks: Vec<[f64; 2]>) -> Result<Changes, Refusal> {
        let Some((open, work)) = self.current_mut() else { return Err(no_film(play)) };
        let checked = marks.iter().try_for_each(|mark| inside(*mark, open.clip.size()));
        let checked = checked.and_then(|()| film::tracking::Marks::new(marks.clone()).map(drop));
        if let Err(refusal) = checked {
            return Err(refused(play, &refusal.words()));
        }
        work.marks = marks;
        (open.following, open.running) = (None, false);
        Ok(Changes::FILMS)
    }

    /// Starts the tracking from the first frame of the used part.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] if no subject needs tracking, or without an open film.
    pub fn begin_tracking(&mut self, play: &Play) -> Result<Changes, Refusal> {
        self.begin_following(play, false)
    }

    /// Continues from the results of an earlier visit. Only the strips of surfaces are read, for the space-time picture
    /// and for corrections. Without results, the film is tracked.
    ///
    /// # Errors
    ///
    /// As [`Films::begin_tracking`].
    pub fn take_up_tracking(&mut self, play: &Play) -> Result<Changes, Refusal> {
        let Some((_, work)) = self.current() else { return Err(no_film(play)) };
        let is_found = work.found.is_some() && !work.tracks().iter().all(|track| track.points.is_empty());
        match &work.subject {
            Subject::Surfaces(_) => self.begin_following(play, is_found),
            Subject::Bodies(_) if !is_found => self.begin_following(play, false),
            _ => Ok(Changes::NONE),
        }
    }

    fn begin_following(&mut self, play: &Play, reading: bool) -> Result<Changes, Refusal> {
        let Some((open, work)) = self.current_mut() else { return Err(no_film(play)) };
        if !work.subject.needs_tracking() {
            return Err(refused(play, &nothing_followed()));
        }
        let plan = plan(&open.clip, work);
        match capacity::check(&plan, open.clip.plane_size()).and_then(|()| Following::new(plan)) {
            Ok(following) => {
                (open.following, open.running, open.reading, open.finished) = (Some(following), true, reading, reading);
                open.pictures.clear();
                Ok(Changes::FILMS)
            }
            Err(refusal) => Err(refused(play, &refusal.words())),
        }
    }

    fn wanted_frame(&self) -> Option<usize> {
        let open = self.open.as_ref().filter(|open| open.running)?;
        open.following.as_ref()?.wanted()
    }

    /// Takes a stored frame of size [`crate::Clip::plane_size`]. A frame that was not requested is ignored.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] if the film cannot be tracked. The tracking is cancelled then.
    pub fn give_frame(&mut self, play: &Play, frame: usize, plane: Plane) -> (Result<(), Refusal>, Changes) {
        if self.wanted_frame() != Some(frame) {
            return (Ok(()), Changes::NONE);
        }
        if let Some(open) = self.open.as_mut().filter(|open| open.following.as_ref().is_some_and(is_fresh)) {
            open.still = Some(Still { frame, plane: plane.clone() });
        }
        without_value(self.drive(play, |following| following.take(plane)))
    }

    /// Skips the requested frame, which cannot be decoded.
    ///
    /// # Errors
    ///
    /// As [`Films::give_frame`].
    pub fn leave_out_frame(&mut self, play: &Play, frame: usize) -> (Result<(), Refusal>, Changes) {
        if self.wanted_frame() != Some(frame) {
            return (Ok(()), Changes::NONE);
        }
        without_value(self.drive(play, Following::leave_out))
    }

    /// Continues the computation by `steps` steps of less than 1 ms each. Does nothing while a frame is requested.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] if the film cannot be tracked.
    pub(crate) fn advance_tracking(&mut self, play: &Play, steps: usize) -> (Result<Tracked, Refusal>, Changes) {
        if self.wanted_frame().is_none() && self.open.as_ref().is_some_and(|open| open.running && open.reading) {
            let changes = self.show_strips();
            if let Some(open) = &mut self.open {
                (open.running, open.reading) = (false, false);
            }
            return (Ok(Tracked::Known), changes);
        }
        let (is_finished, changes) = self.drive(play, |following| following.advance(steps));
        match is_finished {
            Ok(Some(true)) => {}
            Ok(_) => return (Ok(Tracked::NotYet), changes),
            Err(refusal) => return (Err(refusal), changes),
        }
        let Some((open, work)) = self.current_mut() else { return (Ok(Tracked::NotYet), changes) };
        open.running = false;
        let corrected = work.found.is_some() && std::mem::replace(&mut open.finished, true);
        if let Some(following) = &open.following {
            work.found = Some(found(following, &open.clip, work.factor()));
            open.pictures = pictures(following, &open.clip);
        }
        (Ok(Tracked::Found(Kept { origin: corrected, offsets: corrected })), Changes::FILMS)
    }

    /// Updates the space-time pictures with the frames taken so far. It takes several milliseconds, so that a few calls
    /// per second suffice.
    pub fn show_strips(&mut self) -> Changes {
        let Some(open) = self.open.as_mut().filter(|open| open.running) else { return Changes::NONE };
        let Some(following) = &open.following else { return Changes::NONE };
        open.pictures = pictures(following, &open.clip);
        Changes::FILMS
    }

    /// Cancels the running tracking. Earlier results are kept.
    pub fn cancel_tracking(&mut self) -> Changes {
        let Some(open) = self.open.as_mut().filter(|open| open.running) else { return Changes::NONE };
        (open.following, open.running) = (None, false);
        open.pictures.clear();
        Changes::FILMS
    }

    /// Fixes a surface in a frame to within several px of a click, for instance after a drag on the space-time picture.
    /// [`crate::Desk::advance_tracking`] then repeats only the search of the path and its refinement. A film that was not
    /// tracked since it was opened is tracked first.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for a click outside the picture, or an unknown surface.
    pub fn anchor_surface(&mut self, play: &Play, surface: usize, click: Click) -> Result<Changes, Refusal> {
        self.correct_surface(play, surface, click.frame, Some(click))
    }

    /// Removes the correction of a surface in a frame.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for an unknown surface.
    pub fn release_surface(&mut self, play: &Play, surface: usize, frame: usize) -> Result<Changes, Refusal> {
        self.correct_surface(play, surface, frame, None)
    }

    /// Sets or removes the anchor of a frame.
    fn correct_surface(
        &mut self,
        play: &Play,
        surface: usize,
        frame: usize,
        anchor: Option<Click>,
    ) -> Result<Changes, Refusal> {
        let Some((open, work)) = self.current_mut() else { return Err(no_film(play)) };
        let mut subject = work.subject.clone();
        let own = match &mut subject {
            Subject::Surfaces(surfaces) => surfaces.get_mut(surface),
            _ => None,
        };
        let Some(own) = own else { return Err(refused(play, &nothing_followed())) };
        own.anchors.retain(|other| other.frame != frame);
        own.anchors.extend(anchor);
        if let Err(refusal) = subject.check(&open.clip) {
            return Err(refused(play, &refusal.words()));
        }
        work.subject = subject;
        let Some(following) = open.following.as_mut().filter(|_| !open.reading) else {
            return self.begin_tracking(play);
        };
        match anchor {
            Some(click) => following.anchor(surface, stored(&open.clip, &click)),
            None => following.release(surface, frame),
        }
        open.running = true;
        Ok(Changes::FILMS)
    }

    /// Lets the tracking continue, and cancels it if it fails.
    fn drive<T>(
        &mut self,
        play: &Play,
        go_on: impl FnOnce(&mut Following) -> Result<T, film::tracking::Refusal>,
    ) -> (Result<Option<T>, Refusal>, Changes) {
        let Some(open) = self.open.as_mut().filter(|open| open.running) else { return (Ok(None), Changes::NONE) };
        let Some(following) = &mut open.following else { return (Ok(None), Changes::NONE) };
        match go_on(following) {
            Ok(value) => (Ok(Some(value)), Changes::NONE),
            Err(refusal) => {
                let cancelled = self.cancel_tracking();
                (Err(refused(play, &refusal.words())), cancelled)
            }
        }
    }
}

impl ShownFilms<'_> {
    /// Number of the frame that the tracking needs next; `None` if no tracking runs or it has all frames.
    pub fn wanted_frame(self) -> Option<usize> {
        self.films.wanted_frame()
    }

    /// True while a tracking runs.
    pub fn is_tracking(self) -> bool {
        self.films.open.as_ref().is_some_and(|open| open.running)
    }

    /// Progress of the running tracking.
    pub fn tracking_progress(self) -> Option<TrackingProgress> {
        let open = self.films.open.as_ref().filter(|open| open.running)?;
        let following = open.following.as_ref()?;
        let (taken, of) = following.taken();
        let again = !following.repeated().is_empty();
        Some(TrackingProgress { taken, of, again, computing: following.wanted().is_none() })
    }
}

/// Result of a step of the tracking.
#[derive(Debug)]
pub(crate) enum Tracked {
    /// The tracking goes on.
    NotYet,
    /// The strips have been read; the results of an earlier visit are kept.
    Known,
    /// New results; these results of a fit remain valid for the record.
    Found(Kept),
}

/// Result without its value.
fn without_value<T>((result, changes): (Result<T, Refusal>, Changes)) -> (Result<(), Refusal>, Changes) {
    (result.map(drop), changes)
}

/// True if a tracking has not taken any frame.
fn is_fresh(following: &Following) -> bool {
    following.taken().0 == 0
}
