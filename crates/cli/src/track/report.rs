//! Report of a tracked film (`--report`).

use super::arguments::Track as Arguments;
use super::clock::Clock;
use super::following::Followed;
use super::opened::Opened;
use crate::command;
use film::tracking::{Point, Track};
use report::{Film, FilmFile, FilmPicture, Frame, TrackReport, film_html};
use units::{Language, Words, sentence};

/// HTML page of the report.
pub fn page(
    film: &Opened,
    arguments: &Arguments,
    clock: &Clock,
    followed: &Followed,
    notes: &[Words],
    language: Language,
) -> String {
    let file = FilmFile {
        size: Some(film.upright_size()),
        times: film.times.clone(),
        rate: clock.rate,
        bytes: film.bytes,
        calibrated_by: arguments.scale.as_ref().map(|ruler| ruler.typed.clone()),
    };
    let strips = followed.pictures.iter().zip(&followed.tracks);
    let report = Film {
        name: film.path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        facts: file.facts(language),
        notes: notes.iter().map(|note| sentence(&note.text(language))).collect(),
        pictures: frame(film, arguments, followed)
            .into_iter()
            .chain(strips.map(|(picture, track)| FilmPicture::space_time(picture, track, &[])))
            .collect(),
    };
    let command = command::typed();
    film_html(&TrackReport { film: &report, language, command: &command, version: program::VERSION_AND_BITS, date: "" })
}

/// Picture of the first tracked frame with ruler, origin and paths.
fn frame(film: &Opened, arguments: &Arguments, followed: &Followed) -> Option<FilmPicture> {
    let (number, plane) = followed.still.as_ref()?;
    let upright = |track: &Track| Track {
        points: track.points.iter().map(|point| Point { position: film.upright(point.position), ..*point }).collect(),
        ..Track::default()
    };
    let ruler = arguments.scale.iter().map(|ruler| ruler.marks.to_vec());
    Some(FilmPicture::frame(&Frame {
        number: *number,
        size: film.upright_size(),
        grey: &|point| {
            let [x, y] = film.stored(point);
            plane.linear(x, y)
        },
        tracks: &followed.tracks.iter().map(upright).collect::<Vec<_>>(),
        fitted: &[],
        marks: &ruler.chain(arguments.origin.iter().map(|origin| vec![*origin])).collect::<Vec<_>>(),
    }))
}
