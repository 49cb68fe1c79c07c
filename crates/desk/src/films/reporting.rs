//! A film as a report shows it: what it is like, a frame with the marks of the calibration, and the space-time pictures with what was
//! tracked and fitted.

use crate::films::clip::Clip;
use crate::films::lengths::LengthsForm;
use crate::films::overlay::position;
use crate::films::record::table;
use crate::films::space_time::SpaceTimePicture;
use crate::films::state::{Open, Still};
use crate::films::view::work_notes;
use crate::films::work::Work;
use crate::fits::fit::Fitted;
use crate::{Desk, number};
use film::tracking::Track;
use report::{Film, FilmPicture, FilmView};
use units::{Words, words};

/// The width of a drawing.
const WIDTH: f64 = 720.0;
/// The greatest height of a space-time picture.
const HIGHEST: f64 = 320.0;
/// And that of a frame.
const HIGHEST_FRAME: f64 = 480.0;
/// Pixels of a picture, at most: half a byte each, so that all pictures of a film together weigh less than 200 kB.
const MOST_PIXELS: f64 = 80_000.0;

impl Desk {
    /// The films from which the records of a fit come. Pictures are there of the film that is open, once it was tracked since it was
    /// opened: no film is stored.
    pub(crate) fn films_of(&self, fit: &Fitted) -> Vec<Film> {
        let parts = fit.definition.parts.iter().enumerate();
        parts.filter_map(|(place, part)| self.film_of(fit, place, part.record)).collect()
    }

    /// The film from which a record comes, without pictures.
    pub(crate) fn film_described(&self, record: u32) -> Option<Film> {
        let work = self.films.of_record(record)?;
        let clip = self.open_of(work).map(|open| &open.clip);
        let say = |words: &Words| words.text(self.play.language()).to_owned();
        let sentence = |words: &Words| play::words::sentence(&say(words));
        let facts = facts(clip, work, &|value, digits| self.number(value, digits));
        let times = clip.map(Clip::notes).unwrap_or_default();
        Some(Film {
            name: work.identity.name.clone(),
            facts: facts.iter().map(|(term, value)| (say(term), value.clone())).collect(),
            notes: times.iter().chain(&work_notes(work)).map(sentence).collect(),
            pictures: Vec::new(),
        })
    }

    /// The film of some work, if it is the one that is open.
    fn open_of(&self, work: &Work) -> Option<&Open> {
        self.films.current().filter(|(_, own)| own.identity.is_same_film(&work.identity)).map(|(open, _)| open)
    }

    fn film_of(&self, fit: &Fitted, place: usize, record: u32) -> Option<Film> {
        let work = self.films.of_record(record)?;
        let mut film = self.film_described(record)?;
        let Some(open) = self.open_of(work) else { return Some(film) };
        let tracks = work.tracks();
        let fitted: Vec<Vec<(usize, [f64; 2])>> =
            (0..tracks.len()).map(|track| fitted(fit, place, work, &tracks, track).unwrap_or_default()).collect();
        film.pictures.extend(open.still.as_ref().map(|still| frame(still, open, work, &tracks, &fitted)));
        let strips = open.pictures.iter().zip(&tracks).zip(&fitted);
        film.pictures.extend(strips.map(|((picture, track), fitted)| space_time(picture, track, fitted)));
        Some(film)
    }

    fn number(&self, value: f64, digits: usize) -> String {
        number::plain(value, digits, self.play.style())
    }
}

/// Size, length, frames.
fn facts(clip: Option<&Clip>, work: &Work, plain: &dyn Fn(f64, usize) -> String) -> Vec<(Words, String)> {
    let mut facts = Vec::new();
    if let Some(clip) = clip {
        let [width, height] = clip.size();
        facts.push((words("Picture", "Imagen"), format!("{width} × {height} px")));
        if let (Some(first), Some(last), Some(rate)) = (clip.times().first(), clip.times().last(), clip.rate()) {
            let frames = clip.times().len();
            let length = plain(last - first, 4);
            facts.push((words("Frames", "Fotogramas"), format!("{frames}, {} /s, {length} s", plain(rate, 5))));
        }
    }
    facts.push((words("File", "Archivo"), format!("{} MB", plain(work.identity.size as f64 / 1e6, 3))));
    let length = match &work.form.lengths {
        LengthsForm::Pixels => None,
        LengthsForm::Ruler { length, .. } => Some(length.clone()),
        LengthsForm::Rectangle { size: [width, height], .. } => Some(format!("{width} × {height}")),
    };
    facts.extend(length.map(|length| (words("Calibrated by", "Calibrado con"), length)));
    facts
}

/// Where the fitted curve is in the frames of a track, in pixels of the upright picture.
fn fitted(fit: &Fitted, place: usize, work: &Work, tracks: &[Track], track: usize) -> Option<Vec<(usize, [f64; 2])>> {
    let table = table(work)?;
    let part = fit.definition.parts.get(place)?;
    // The columns stand in the order of the table: the time, then values and errors of each track.
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

/// The frame that was clicked, with the marks of the calibration and the paths.
fn frame(still: &Still, open: &Open, work: &Work, tracks: &[Track], fitted: &[Vec<(usize, [f64; 2])>]) -> FilmPicture {
    let [width, height] = open.clip.size();
    let scale = (WIDTH / width).min(HIGHEST_FRAME / height);
    let shrink = (width * height / MOST_PIXELS).sqrt().max(1.0);
    let pixels = [width, height].map(|side| ((side / shrink) as usize).max(1));
    let value = |x: f64, y: f64| {
        let [x, y] = open.clip.stored([x, y]);
        still.plane.linear(x, y)
    };
    let drawn = |point: &[f64; 2]| point.map(|part| part * scale);
    let mut marks: Vec<Vec<[f64; 2]>> = match &work.form.lengths {
        LengthsForm::Pixels => Vec::new(),
        LengthsForm::Ruler { marks, .. } => vec![marks.iter().map(drawn).collect()],
        LengthsForm::Rectangle { corners, .. } => {
            vec![corners.iter().chain(&corners[..1]).map(drawn).collect()]
        }
    };
    marks.extend(work.form.origin.iter().map(|origin| vec![drawn(origin)]));
    let path = |track: &Track| track.points.iter().map(|point| drawn(&point.position)).collect();
    FilmPicture {
        view: FilmView::Frame(still.frame),
        pixels,
        grey: averaged(pixels, [width, height], &value),
        size: [width * scale, height * scale],
        tracked: tracks.iter().map(path).collect(),
        fitted: fitted.iter().map(|curve| curve.iter().map(|(_, point)| drawn(point)).collect()).collect(),
        marks,
    }
}

/// A space-time picture with the path and the fitted curve.
fn space_time(picture: &SpaceTimePicture, track: &Track, fitted: &[(usize, [f64; 2])]) -> FilmPicture {
    let size = [picture.frames.len().max(1) as f64, picture.rows.max(1) as f64];
    let drawing = [WIDTH, (WIDTH * size[1] / size[0]).clamp(160.0, HIGHEST)];
    let shrink = (size[0] * size[1] / MOST_PIXELS).sqrt().max(1.0);
    let pixels = size.map(|side| ((side / shrink) as usize).max(1));
    let columns = picture.frames.len();
    let value = |x: f64, y: f64| {
        let at =
            (y as usize).min(picture.rows.saturating_sub(1)) * columns + (x as usize).min(columns.saturating_sub(1));
        f64::from(picture.grey.get(at).copied().unwrap_or(0))
    };
    let drawn = |(frame, point): (usize, [f64; 2])| {
        let column = picture.column_of(frame)? as f64;
        let row = picture.row_of(point);
        Some([(column + 0.5) / size[0] * drawing[0], (row + 0.5) / size[1] * drawing[1]])
    };
    FilmPicture {
        view: FilmView::SpaceTime,
        pixels,
        grey: averaged(pixels, size, &value),
        size: drawing,
        tracked: vec![track.points.iter().filter_map(|point| drawn((point.frame, point.position))).collect()],
        fitted: vec![fitted.iter().copied().filter_map(drawn).collect()],
        marks: Vec::new(),
    }
}

/// A smaller picture of `pixels`: each is the mean of nine points of the picture of this size.
fn averaged([columns, rows]: [usize; 2], [width, height]: [f64; 2], value: &dyn Fn(f64, f64) -> f64) -> Vec<u8> {
    let [across, down] = [width / columns as f64, height / rows as f64];
    let mut grey = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        for column in 0..columns {
            let points = (0..9).map(|k| {
                let [u, v] = [k % 3, k / 3].map(|part| (f64::from(part) + 0.5) / 3.0);
                value((column as f64 + u) * across, (row as f64 + v) * down)
            });
            grey.push((points.sum::<f64>() / 9.0).round() as u8);
        }
    }
    grey
}
