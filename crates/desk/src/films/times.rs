//! Time base of a film: factor of slow motion, and the used part.

use crate::Refusal;
use crate::films::clip::Clip;
use crate::films::record::Kept;
use crate::films::{Films, no_film, refused};
use film::timing::LARGEST_FACTOR;
use play::Play;
use units::number::typed::shortened;
use units::{Dimension, Unit, words};

impl Films {
    /// Sets the factor of slow motion, the duration of playback relative to that of the recording, from text: `8`, or a
    /// quotient of rates `240/30`. An empty text selects the factor stated by the file. Updates the times of the
    /// record.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for a text that is not a factor within the bounds, or without an open film.
    pub fn set_factor(&mut self, play: &Play, typed: &str) -> Result<Option<Kept>, Refusal> {
        let factor = match typed.trim() {
            "" => None,
            typed => Some(factor(play, typed)?),
        };
        let Some((open, work)) = self.current_mut() else { return Err(no_film(play)) };
        work.factor = factor;
        // Times of later frames would not match those already taken.
        if open.running {
            (open.following, open.running) = (None, false);
        }
        Ok(Some(Kept { origin: false, offsets: true }))
    }

    /// Sets an end of the used part from text: a time of playback, with its unit or in s, or arithmetic such as `1/2`. An
    /// empty text selects the end of the film. `end`: 0 for the begin, 1 for the end.
    ///
    /// # Errors
    ///
    /// The text is not a time, or as for [`Films::set_part`]. The part is unchanged then.
    pub fn set_end(&mut self, play: &Play, end: usize, typed: &str) -> Result<Option<Kept>, Refusal> {
        let Some((_, work)) = self.current() else { return Err(no_film(play)) };
        let mut part = work.part;
        let time = play.basis().read_field(play.course(), typed, "", &Unit::si(Dimension::TIME))?;
        if let Some(place) = part.get_mut(end) {
            *place = time;
        }
        self.set_part(play, part)
    }

    /// Sets the used part of the film in s of playback; `None` is an end of the film. Rows outside are removed from the
    /// record. Rows that were never tracked need another tracking.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] for a part with fewer than two frames, or without an open film.
    pub fn set_part(&mut self, play: &Play, part: [Option<f64>; 2]) -> Result<Option<Kept>, Refusal> {
        let Some((open, work)) = self.current_mut() else { return Err(no_film(play)) };
        let part = part.map(|end| end.filter(|end| end.is_finite()));
        let ends = open.clip.ends(part);
        if ends[0] >= ends[1] {
            return Err(refused(play, &words("Fewer than two frames lie in this part. Choose a longer one.")));
        }
        (work.part, work.ends) = (part, ends);
        if open.running {
            (open.following, open.running) = (None, false);
        }
        Ok(Some(Kept { origin: false, offsets: true }))
    }
}

/// Factor of slow motion from text.
fn factor(play: &Play, typed: &str) -> Result<f64, Refusal> {
    let plain = Unit::dimensionless();
    let read = play.basis().read_field(play.course(), typed, "", &plain).ok().flatten();
    read.filter(|factor| (1.0 / LARGEST_FACTOR..=LARGEST_FACTOR).contains(factor)).ok_or_else(|| {
        let typed = shortened(typed);
        refused(play, &words!(
            "{typed} is not possible. Enter how many times slower the film plays than things happened, such as 8 or 240/30."
        ))
    })
}

impl Clip {
    /// First and last frame of a part in s of playback.
    pub(crate) fn ends(&self, [from, until]: [Option<f64>; 2]) -> [usize; 2] {
        let first = from.map_or(0, |from| self.times().partition_point(|time| *time < from));
        let end = until.map_or(self.times().len(), |until| self.times().partition_point(|time| *time <= until));
        [first, end.saturating_sub(1)]
    }
}
