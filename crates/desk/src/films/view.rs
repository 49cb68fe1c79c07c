//! Content of the open film for display.

use crate::films::ShownFilms;
use crate::films::clip::Clip;
use crate::films::identity::FilmIdentity;
use crate::films::lengths::CalibrationForm;
use crate::films::recipe::FilmRecipe;
use crate::films::record::table;
use crate::films::state::Open;
use crate::films::subject::Subject;
use crate::films::truth::FilmTruth;
use crate::films::work::Work;
use crate::number;
use film::calibration::{Calibration, Lengths};
use film::timing::displayed;
use film::tracking::column::SpaceTimePicture;
use film::tracking::{DoubtfulFrame, Outline, Track, doubts, is_plainly_in_doubt, of_several};
use units::{Words, words};

/// Open film, and the work on it.
#[derive(Clone, Copy, Debug)]
pub struct OpenFilm<'a> {
    open: &'a Open,
    work: &'a Work,
}

/// Outline of a tracked body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyOutline {
    /// Radius, px of the upright picture.
    pub radius: f64,
    /// Radius at the first click along the rows of the picture, m; `None` without a scale.
    pub metres: Option<f64>,
    /// Vector from the click to the centre, px.
    pub offset: [f64; 2],
    /// True if the radius was set, false if it was found.
    pub is_set: bool,
}

impl<'a> ShownFilms<'a> {
    /// Open film, if any.
    pub fn current(self) -> Option<OpenFilm<'a>> {
        self.films.current().map(|(open, work)| OpenFilm { open, work })
    }

    /// Notes on file, times, camera and scale of the open film, as sentences in the chosen language.
    pub fn notes(self) -> Vec<String> {
        let Some(film) = self.current() else { return Vec::new() };
        let sentence = |words: Words| units::sentence(&words.text(self.play.basis().language()));
        film.notes().into_iter().map(sentence).collect()
    }

    /// Sentences on the bodies that are lost before the end of the used part; empty without one.
    pub fn losses(self) -> String {
        let Some(film) = self.current() else { return String::new() };
        let (tracks, size) = (film.tracks(), film.clip().size());
        let sentences = (1..).zip(&tracks).filter_map(|(number, track)| {
            let loss = track.loss(size)?;
            let time = film.clip().times().get(loss.frame).copied().unwrap_or(f64::NAN);
            let what = loss.words(displayed(time));
            let what = of_several(number, tracks.len(), what);
            Some(units::sentence(&what.text(self.play.basis().language())))
        });
        sentences.collect::<Vec<_>>().join(" ")
    }

    /// Measured position in a frame of the open film, such as `y_2 = 0.0413 ± 0.0002 m`, with two numbers for a body.
    /// `None` if the track has no point there.
    pub fn position(self, track: usize, frame: usize) -> Option<String> {
        let table = table(self.films.current()?.1)?;
        let row = table.frames.binary_search(&frame).ok()?;
        let text = |one: &film::table::Quantity| {
            let (value, sigma) = (*one.values.get(row)?, *one.sigmas.get(row)?);
            let number = number::with_error(value, Some(sigma), self.play.basis().style());
            value.is_finite().then(|| format!("{} = {number} {}", one.name, table.unit))
        };
        let texts: Vec<String> = table.quantities.get(track)?.iter().map(text).collect::<Option<_>>()?;
        Some(texts.join(", "))
    }
}

impl<'a> OpenFilm<'a> {
    /// Identity of the film.
    pub fn identity(self) -> &'a FilmIdentity {
        &self.work.identity
    }

    /// Description of the file: size, frame times, container.
    pub fn clip(self) -> &'a Clip {
        &self.open.clip
    }

    /// Factor of slow motion: duration of playback relative to that of the recording.
    pub fn factor(self) -> f64 {
        self.work.factor()
    }

    /// Factor set by the user; `None` if that of the file applies.
    pub fn typed_factor(self) -> Option<f64> {
        self.work.factor
    }

    /// Recording time of a frame, s.
    pub fn taken(self, frame: usize) -> Option<f64> {
        self.open.clip.times().get(frame).map(|time| time / self.work.factor())
    }

    /// Used part in s of playback; `None` for an end of the film.
    pub fn part(self) -> [Option<f64>; 2] {
        self.work.part
    }

    /// First and last frame of the used part.
    pub fn ends(self) -> [usize; 2] {
        self.work.ends
    }

    /// Subject of tracking.
    pub fn subject(self) -> &'a Subject {
        &self.work.subject
    }

    /// Outline of a body with the radius that was set or else found; `None` before that.
    pub fn body_outline(self, body: usize) -> Option<BodyOutline> {
        let Subject::Bodies(bodies) = &self.work.subject else { return None };
        let own = bodies.get(body)?;
        let found = || self.work.found.as_ref()?.tracks.get(body)?.outline;
        let set = own.radius.map(|radius| Outline { offset: [0.0; 2], radius });
        let Outline { offset, radius } = set.or_else(found)?;
        let [x, y] = own.keys.first()?.position;
        let calibration = &self.work.calibration;
        let [left, right] = [x - radius, x + radius].map(|x| calibration.apply([x + offset[0], y + offset[1]]));
        let length = 0.5 * libm::hypot(right[0] - left[0], right[1] - left[1]);
        let metres = (calibration.lengths != Lengths::Pixels && length.is_finite()).then_some(length);
        Some(BodyOutline { radius, metres, offset, is_set: own.radius.is_some() })
    }

    /// Fixed marks, px of the upright picture.
    pub fn fixed_marks(self) -> &'a [[f64; 2]] {
        &self.work.marks
    }

    /// Calibration form of the user.
    pub fn calibration_form(self) -> &'a CalibrationForm {
        &self.work.form
    }

    /// Map from px of the upright picture to lengths.
    pub fn calibration(self) -> &'a Calibration {
        &self.work.calibration
    }

    /// Tracks in px of the upright picture, with times in s; empty before tracking.
    pub fn tracks(self) -> Vec<Track> {
        self.work.tracks()
    }

    /// Number of the record of the film. The record may have been removed.
    pub fn record(self) -> Option<u32> {
        self.work.record
    }

    /// Recipe of the film, if it is that of a simulation.
    pub fn recipe(self) -> Option<&'a FilmRecipe> {
        self.work.recipe.as_ref()
    }

    /// True positions in a filmed simulation.
    pub fn truth(self) -> Option<&'a FilmTruth> {
        self.open.truth.as_ref()
    }

    /// Frames that the user should check, in order.
    pub fn doubtful(self) -> Vec<DoubtfulFrame> {
        doubts(&self.work.tracks(), self.open.clip.size())
    }

    /// True if a track was lost or has many doubtful frames: the user should check before the record is used.
    pub fn is_plainly_in_doubt(&self) -> bool {
        is_plainly_in_doubt(&self.work.tracks())
    }

    /// Space-time picture of a surface, once the film has been tracked since it was opened.
    pub fn space_time(self, surface: usize) -> Option<&'a SpaceTimePicture> {
        self.open.pictures.get(surface)
    }

    fn notes(self) -> Vec<Words> {
        let mut notes = self.open.notes.clone();
        notes.extend(self.open.clip.notes());
        notes.extend(match (self.work.factor, self.open.clip.slow_motion()) {
            (None, found) => found.map(|found| found.words()),
            (Some(factor), _) => {
                Some(words!("times are divided by {factor}, as stated by hand", factor = significant(factor, 4)))
            }
        });
        notes.extend(work_notes(self.work));
        notes
    }
}

/// Notes on camera and calibration of a film.
pub(super) fn work_notes(work: &Work) -> Vec<Words> {
    let mut notes = Vec::new();
    notes.extend(work.recipe.as_ref().map(|recipe| {
        let camera = recipe.settings;
        words!(
            "virtual camera: exposure {ms} ms, noise of {noise} of 255 grey values, seed {seed}, no compression",
            ms = milliseconds(camera.exposure),
            noise = significant(camera.noise, 3),
            seed = Words::each(move |_| camera.seed.to_string())
        )
    }));
    let found = work.found.as_ref();
    if let Some(found) = found.filter(|found| !found.repeated.is_empty()) {
        let (count, of) = (found.repeated.len(), found.repeated.len() + found.frames.len());
        notes.push(words!("{count} of {of} frames repeat the picture before and are left out: their times are wrong"));
    }
    if let Subject::Points { sigma, .. } = &work.subject {
        notes.push(words!(
            "points clicked by hand: a standard error of {sigma} px in each coordinate is assumed",
            sigma = significant(*sigma, 3)
        ));
    }
    // One camera sees both arms: equal notes are shown once.
    for note in work.tracks().iter().flat_map(Track::camera) {
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    notes.extend(work.calibration.notes());
    notes
}

fn milliseconds(seconds: f64) -> Words {
    Words::each(move |language| number::fixed(1e3 * seconds, 1, language.style()))
}

fn significant(value: f64, digits: usize) -> Words {
    Words::each(move |language| number::plain(value, digits, language.style()))
}
