//! Films in the report of a fit.

use crate::films::Films;
use crate::films::clip::Clip;
use crate::films::lengths::LengthsForm;
use crate::films::overlay::position;
use crate::films::record::table;
use crate::films::state::{Open, Still};
use crate::films::view::work_notes;
use crate::films::work::Work;
use crate::fits::fit::Fitted;
use film::tracking::Track;
use play::Play;
use report::{Film, FilmFile, FilmPicture, Frame};
use units::Words;

impl Films {
    /// Films from which the records of a fit come. Pictures are included only of the open film, if it was tracked since
    /// it was opened: films are not stored.
    pub(crate) fn of_fit(&self, play: &Play, fit: &Fitted) -> Vec<Film> {
        let parts = fit.definition.parts.iter().enumerate();
        parts.filter_map(|(place, part)| self.film_of(play, fit, place, part.record)).collect()
    }

    /// Description of the film of a record, without pictures.
    pub(crate) fn described(&self, play: &Play, record: u32) -> Option<Film> {
        let work = self.of_record(record)?;
        let clip = self.open_of(work).map(|open| &open.clip);
        let language = play.basis().language();
        let sentence = |words: &Words| units::sentence(&words.text(language));
        let times = clip.map(Clip::notes).unwrap_or_default();
        Some(Film {
            name: work.identity.name.clone(),
            facts: file(clip, work).facts(language),
            notes: times.iter().chain(&work_notes(work)).map(sentence).collect(),
            pictures: Vec::new(),
        })
    }

    /// Open film, if `work` belongs to it.
    fn open_of(&self, work: &Work) -> Option<&Open> {
        self.current().filter(|(_, own)| own.identity.is_same_film(&work.identity)).map(|(open, _)| open)
    }

    fn film_of(&self, play: &Play, fit: &Fitted, place: usize, record: u32) -> Option<Film> {
        let work = self.of_record(record)?;
        let mut film = self.described(play, record)?;
        let Some(open) = self.open_of(work) else { return Some(film) };
        let tracks = work.tracks();
        let fitted: Vec<Vec<(usize, [f64; 2])>> =
            (0..tracks.len()).map(|track| fitted(fit, place, work, &tracks, track).unwrap_or_default()).collect();
        let frame = |still: &Still| {
            FilmPicture::frame(&Frame {
                number: still.frame,
                size: open.clip.size(),
                grey: &|point| {
                    let [x, y] = open.clip.stored(point);
                    still.plane.linear(x, y)
                },
                tracks: &tracks,
                fitted: &fitted,
                marks: &marks(work),
            })
        };
        film.pictures.extend(open.still.as_ref().map(frame));
        let strips = open.pictures.iter().zip(&tracks).zip(&fitted);
        film.pictures.extend(strips.map(|((picture, track), fitted)| FilmPicture::space_time(picture, track, fitted)));
        Some(film)
    }
}

/// Description of the file and the calibration.
fn file(clip: Option<&Clip>, work: &Work) -> FilmFile {
    FilmFile {
        size: clip.map(Clip::size),
        times: clip.map(|clip| clip.times().to_vec()).unwrap_or_default(),
        rate: clip.and_then(Clip::rate),
        bytes: work.identity.size,
        calibrated_by: match &work.form.lengths {
            LengthsForm::Pixels => None,
            LengthsForm::Ruler { length, .. } => Some(length.clone()),
            LengthsForm::Rectangle { size: [width, height], .. } => Some(format!("{width} × {height}")),
        },
    }
}

/// Positions of the fitted curve in the frames of a track, px of the upright picture.
fn fitted(fit: &Fitted, place: usize, work: &Work, tracks: &[Track], track: usize) -> Option<Vec<(usize, [f64; 2])>> {
    let table = table(work)?;
    let part = fit.definition.parts.get(place)?;
    // Order of the columns: the time, then values and errors of each track.
    let before: usize = table.quantities.iter().take(track).map(|own| 2 * own.len()).sum();
    let of_column = |k: usize| {
        let used = part.uses.get(1 + before + k).filter(|used| used.fitted)?;
        let same = |one: &&analysis::fit::ObservationFit| one.record == place && one.name == used.meaning.quantity;
        Some((fit.outcome.observations.iter().find(same)?, &used.meaning.unit))
    };
    let coordinates = [of_column(0), of_column(1)];
    let times = &coordinates.iter().flatten().next()?.0.times;
    let curve = times.iter().enumerate().filter_map(|(row, time)| {
        let at = table.times.iter().position(|own| own == time)?;
        let frame = *table.frames.get(at)?;
        let value = |k: usize| {
            let (one, unit) = coordinates[k].as_ref()?;
            one.fitted.get(row).map(|value| unit.from_si(*value)).filter(|value| value.is_finite())
        };
        Some((frame, position(work, tracks.get(track)?, frame, [value(0), value(1)])?))
    });
    Some(curve.collect())
}

/// Marks of the calibration: ruler or rectangle, and origin, px.
fn marks(work: &Work) -> Vec<Vec<[f64; 2]>> {
    let mut marks = match &work.form.lengths {
        LengthsForm::Pixels => Vec::new(),
        LengthsForm::Ruler { marks, .. } => vec![marks.to_vec()],
        LengthsForm::Rectangle { corners, .. } => vec![corners.iter().chain(&corners[..1]).copied().collect()],
    };
    marks.extend(work.form.origin.iter().map(|origin| vec![*origin]));
    marks
}
