//! What a page shows of the open film.

use crate::films::clip::Clip;
use crate::films::doubt::{DoubtfulFrame, doubts, plainly};
use crate::films::identity::FilmIdentity;
use crate::films::lengths::CalibrationForm;
use crate::films::recipe::FilmRecipe;
use crate::films::record::table;
use crate::films::state::Open;
use crate::films::subject::Subject;
use crate::films::truth::FilmTruth;
use crate::films::work::Work;
use crate::{Desk, number};
use film::calibration::{Calibration, Lengths};
use film::tracking::column::SpaceTimePicture;
use film::tracking::{Outline, Track};
use units::{Words, words};

/// The film that is open, and the work on it.
#[derive(Clone, Copy, Debug)]
pub struct OpenFilm<'a> {
    open: &'a Open,
    work: &'a Work,
}

/// The circle by which a body is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyOutline {
    /// The radius in pixels of the upright picture.
    pub radius: f64,
    /// The radius in metres at the first click, along the picture's rows; `None` while lengths are in pixels.
    pub metres: Option<f64>,
    /// Pixels to the right and downwards from the click to the centre.
    pub offset: [f64; 2],
    /// True for a radius that was set, false for one that was found.
    pub is_set: bool,
}

impl Desk {
    /// The film that is open.
    pub fn film(&self) -> Option<OpenFilm<'_>> {
        self.films.current().map(|(open, work)| OpenFilm { open, work })
    }

    /// What a person should know of the open film: file, times, camera, scale, in sentences of the chosen language.
    pub fn film_notes(&self) -> Vec<String> {
        let Some(film) = self.film() else { return Vec::new() };
        let sentence = |words: Words| units::sentence(words.text(self.play.language()));
        film.notes().into_iter().map(sentence).collect()
    }

    /// What the record says of a frame of the open film, as `y_2 = 0.0413 ± 0.0002 m`; a body has two such numbers. `None` where
    /// the track of this number has no point there.
    pub fn film_position(&self, track: usize, frame: usize) -> Option<String> {
        let table = table(self.films.current()?.1)?;
        let row = table.frames.binary_search(&frame).ok()?;
        let text = |one: &film::table::Quantity| {
            let (value, sigma) = (*one.values.get(row)?, *one.sigmas.get(row)?);
            let number = number::with_error(value, Some(sigma), self.play.style());
            value.is_finite().then(|| format!("{} = {number} {}", one.name, table.unit))
        };
        let texts: Vec<String> = table.quantities.get(track)?.iter().map(text).collect::<Option<_>>()?;
        Some(texts.join(", "))
    }
}

impl<'a> OpenFilm<'a> {
    /// What it is known by.
    pub fn identity(self) -> &'a FilmIdentity {
        &self.work.identity
    }

    /// What its file says: size, times of the frames, container.
    pub fn clip(self) -> &'a Clip {
        &self.open.clip
    }

    /// How many times slower it plays than things happened.
    pub fn factor(self) -> f64 {
        self.work.factor()
    }

    /// The same as a person has typed it; `None` if it is what the file says.
    pub fn typed_factor(self) -> Option<f64> {
        self.work.factor
    }

    /// When a frame was taken, in seconds.
    pub fn taken(self, frame: usize) -> Option<f64> {
        self.open.clip.times().get(frame).map(|time| time / self.work.factor())
    }

    /// The part that is used, in seconds of the file.
    pub fn part(self) -> [Option<f64>; 2] {
        self.work.part
    }

    /// The first and the last frame of the part.
    pub fn ends(self) -> [usize; 2] {
        self.work.ends
    }

    /// What is followed.
    pub fn subject(self) -> &'a Subject {
        &self.work.subject
    }

    /// The outline of a body: by the radius that was set, or else as it was found. `None` before it was found.
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

    /// Marks that rest.
    pub fn resting_marks(self) -> &'a [[f64; 2]] {
        &self.work.marks
    }

    /// What a person has said of lengths.
    pub fn calibration_form(self) -> &'a CalibrationForm {
        &self.work.form
    }

    /// The map from pixels of the upright picture to lengths.
    pub fn calibration(self) -> &'a Calibration {
        &self.work.calibration
    }

    /// The tracks in pixels of the upright picture, with times in seconds; empty before something has been found.
    pub fn tracks(self) -> Vec<Track> {
        self.work.tracks()
    }

    /// The id of the record that it has become; it may have been removed.
    pub fn record(self) -> Option<u32> {
        self.work.record
    }

    /// How it was taken, if it is that of a simulation.
    pub fn recipe(self) -> Option<&'a FilmRecipe> {
        self.work.recipe.as_ref()
    }

    /// What is known of a filmed simulation.
    pub fn truth(self) -> Option<&'a FilmTruth> {
        self.open.truth.as_ref()
    }

    /// The frames that a person should look at, in order.
    pub fn doubtful(self) -> Vec<DoubtfulFrame> {
        doubts(&self.work.tracks())
    }

    /// True if something was lost, or many frames are in doubt: a person has to look before the record is used.
    pub fn is_plainly_in_doubt(&self) -> bool {
        plainly(&self.work.tracks())
    }

    /// The space-time picture of a surface, once the film has been tracked since it was opened.
    pub fn space_time(self, surface: usize) -> Option<&'a SpaceTimePicture> {
        self.open.pictures.get(surface)
    }

    fn notes(self) -> Vec<Words> {
        let mut notes = self.open.notes.clone();
        notes.extend(self.open.clip.notes());
        notes.extend(match (self.work.factor, self.open.clip.slow_motion()) {
            (None, found) => found.map(|found| found.words()),
            (Some(factor), _) => Some(words!(
                "times are divided by {factor}, as stated by hand",
                "los tiempos se dividen por {factor}, como se indicó a mano",
                factor = significant(factor, 4)
            )),
        });
        notes.extend(work_notes(self.work));
        notes
    }
}

/// What the work on a film says of camera and lengths.
pub(super) fn work_notes(work: &Work) -> Vec<Words> {
    let mut notes = Vec::new();
    notes.extend(work.recipe.as_ref().map(|recipe| {
        let camera = recipe.settings;
        words!(
            "virtual camera: exposure {ms} ms, noise of {noise} of 255 grey values, seed {seed}, no compression",
            "cámara virtual: exposición de {ms} ms, ruido de {noise} de 255 valores de gris, semilla {seed}, sin compresión",
            ms = milliseconds(camera.exposure),
            noise = significant(camera.noise, 3),
            seed = Words::each(|_| camera.seed.to_string())
        )
    }));
    let found = work.found.as_ref();
    if let Some(found) = found.filter(|found| !found.repeated.is_empty()) {
        let (count, of) = (found.repeated.len(), found.repeated.len() + found.frames.len());
        notes.push(words!(
            "{count} of {of} frames repeat the picture before and are left out: their times are wrong",
            "{count} de {of} fotogramas repiten la imagen anterior y se excluyen: sus tiempos son erróneos"
        ));
    }
    if let Subject::Points { sigma, .. } = &work.subject {
        notes.push(words!(
            "points clicked by hand: a standard error of {sigma} px in each coordinate is assumed",
            "puntos marcados a mano: se supone un error estándar de {sigma} px en cada coordenada",
            sigma = significant(*sigma, 3)
        ));
    }
    // Both arms are seen by one camera: what they agree on is said once.
    for note in work.tracks().iter().flat_map(Track::camera) {
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    notes.extend(work.calibration.notes());
    notes
}

fn milliseconds(seconds: f64) -> Words {
    Words::each(|language| number::fixed(1e3 * seconds, 1, language.style()))
}

fn significant(value: f64, digits: usize) -> Words {
    Words::each(|language| number::plain(value, digits, language.style()))
}
