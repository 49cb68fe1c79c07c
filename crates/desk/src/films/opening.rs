//! Opening and closing films.

use crate::films::clip::Clip;
use crate::films::identity::FilmIdentity;
use crate::films::state::Open;
use crate::films::subject::Subject;
use crate::films::work::Work;
use crate::films::{Films, refused};
use crate::{Changes, Refusal};
use film::calibration::Calibration;
use play::Play;
use units::words;

/// Result of opening a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmOpening {
    /// The film is new.
    New,
    /// The film is known. The stored work on it is continued.
    TakenUp,
    /// The film is new, but another film has the same name. The work on that one is kept.
    SameName,
}

impl Films {
    /// Opens a film in place of the open one. Stored work on the film is continued.
    ///
    /// # Errors
    ///
    /// [`Refusal::Film`] if no two frames have different times.
    pub fn open(
        &mut self,
        play: &Play,
        identity: FilmIdentity,
        container: film::containers::Film,
    ) -> Result<(FilmOpening, Changes), Refusal> {
        let clip = Clip::new(container);
        if clip.rate().is_none() {
            return Err(refused(play, &words("The film has no two frames at different times: nothing moves in it.")));
        }
        let closed = self.close();
        let known = self.works.iter().position(|work| work.identity.is_same_film(&identity));
        let same_name = self.works.iter().any(|work| work.identity.name == identity.name);
        let opening = match known {
            Some(_) => FilmOpening::TakenUp,
            None if same_name => FilmOpening::SameName,
            None => FilmOpening::New,
        };
        let place = known.unwrap_or_else(|| {
            let [_, high] = clip.size();
            let calibration = Calibration { origin: [0.0, high], ..Calibration::default() };
            self.works.push(Work { identity, calibration, ..Work::default() });
            self.works.len() - 1
        });
        if let Some(work) = self.works.get_mut(place) {
            work.stated_factor = clip.stated_factor().unwrap_or(1.0);
            work.ends = clip.ends(work.part);
            // Stored text is not trusted: a subject that does not fit this film is discarded.
            if work.subject.check(&clip).is_err() {
                work.subject = Subject::Nothing;
            }
        }
        self.open = Some(Open {
            work: place,
            clip,
            following: None,
            running: false,
            reading: false,
            finished: false,
            truth: None,
            notes: Vec::new(),
            pictures: Vec::new(),
            still: None,
        });
        Ok((opening, closed | Changes::FILMS))
    }

    /// Closes the film. The work on it is kept, unless it is empty.
    pub fn close(&mut self) -> Changes {
        let Some(open) = self.open.take() else { return Changes::NONE };
        let empty = |work: &Work| work.found.is_none() && work.subject.is_nothing() && work.form == Default::default();
        if self.works.get(open.work).is_some_and(empty) {
            self.works.remove(open.work);
        }
        Changes::FILMS
    }
}
