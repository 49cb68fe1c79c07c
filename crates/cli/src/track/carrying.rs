//! The data that the report of a film carries: the clicks, the tracked points and the table made from them, as a laboratory
//! stores them.

use super::arguments::{Place, Track as Arguments};
use super::clock::Clock;
use super::following::Followed;
use super::opened::Opened;
use crate::handing::write::{now, packed};
use class::verify::{DataFile, FILM_START, Recomputation, film_hash, project_of_files};
use document::page::Source;
use film::calibration::{Calibration, Lengths, Rotation};
use film::tracking::{Exposure, Point, Track};
use saved::Number;
use saved::carried::{carry, carry_nothing};
use saved::format::{self, Followed as Clicked, FoundInFilm, TrackInFilm};
use saved::hand_in::{HandIn, Sender};
use saved::project::Project;
use std::fs::File;
use std::io::Read;
use units::{Language, Words, words};

/// Document with which the table is opened. A hand-in has one, and a film has no model.
const DOCUMENT: &str = "---\ntitle: Film\nlanguage: en\n---\n\n```model\ny' = 0 [m/s]\ny(0) = 0 [m]\n```\n";

/// A tracked film with its settings.
#[derive(Clone, Copy)]
pub struct Tracked<'a> {
    pub film: &'a Opened,
    pub arguments: &'a Arguments,
    pub clock: &'a Clock,
    pub followed: &'a Followed,
    pub calibration: &'a Calibration,
    /// The table as text.
    pub table: &'a str,
}

/// A report with the data of its film. Without them it states the reason.
pub fn carrying(page: &str, tracked: Tracked<'_>, language: Language) -> String {
    match hand_in(tracked) {
        Ok(hand_in) => carry(page, &packed(&hand_in.of_page(page, language)), language),
        Err(why) => {
            let why = words!("This page does not carry the tracked points, and cannot be verified: {why}.");
            carry_nothing(page, &why.text(language), language)
        }
    }
}

fn hand_in(tracked: Tracked<'_>) -> Result<HandIn, Words> {
    let work = work(tracked)?;
    let done = Recomputation::complete(&work)?;
    if let Some(why) = done.left_out().next() {
        return Err(why.clone());
    }
    Ok(HandIn::new(now(), Sender::default(), work, done.facts()))
}

fn work(tracked: Tracked<'_>) -> Result<Project, Words> {
    let start = start_of(tracked.film).map_err(|error| {
        let (film, why) = (tracked.film.path.display().to_string(), error.to_string());
        words!("{film} could not be read again: {why}")
    })?;
    let film = item(tracked, &start).ok_or_else(|| words("a click lies at a frame that is not tracked"))?;
    let documents = vec![Source { name: "film.md".to_owned(), text: DOCUMENT.to_owned() }];
    let stem = film.name.rsplit_once('.').map_or(&*film.name, |(stem, _)| stem);
    let table = DataFile { name: format!("{stem}.csv"), bytes: tracked.table.into(), against: Vec::new() };
    project_of_files(documents, String::new(), vec![table], vec![film], Vec::new())
}

/// First bytes of the file, of which its hash is made.
fn start_of(film: &Opened) -> std::io::Result<Vec<u8>> {
    let mut start = Vec::new();
    File::open(&film.path)?.take(FILM_START).read_to_end(&mut start)?;
    Ok(start)
}

fn place([x, y]: [f64; 2]) -> format::Place {
    [Number(x), Number(y)]
}

/// The work on the film, in pixels of the upright picture; `None` if a click or a tracked frame has no time. `start`: first
/// bytes of the file.
fn item(tracked: Tracked<'_>, start: &[u8]) -> Option<format::Film> {
    let Tracked { film, arguments, clock, followed, calibration, .. } = tracked;
    let name: String = film.path.file_name()?.to_string_lossy().chars().take(200).collect();
    let click = |click: &Place| Some((clock.frame_of(film, click).ok()?, place(click.position)));
    let surfaces = arguments.surface.iter().enumerate().map(|(index, surface)| {
        let mut clicks = surface.places.iter().map(click).collect::<Option<Vec<_>>>()?;
        let anchors = clicks.split_off(1.min(clicks.len()));
        let tube = arguments.tube.get(index).map(|ends| ends.map(place));
        Some(Clicked { clicks, tube, anchors, ..Clicked::default() })
    });
    let bodies = arguments.body.iter().map(|body| {
        let clicks = body.places.iter().map(click).collect::<Option<_>>()?;
        Some(Clicked { clicks, radius: body.radius.map(Number), ..Clicked::default() })
    });
    let ruler = arguments.scale.as_ref();
    let scale = match &calibration.lengths {
        Lengths::Scale(scale) => Some([scale.pixel, scale.relative_sigma].map(Number)),
        _ => None,
    };
    let kind = if arguments.surface.is_empty() { "bodies" } else { "surfaces" };
    Some(format::Film {
        name,
        size: film.bytes,
        hash: film_hash(start),
        factor: arguments.rate.map(Number),
        stated_factor: Some(Number(clock.factor)),
        kind: kind.to_owned(),
        followed: surfaces.chain(bodies).collect::<Option<_>>()?,
        marks: arguments.marks.iter().flat_map(|marks| &marks.0).map(|mark| place(*mark)).collect(),
        points: ruler.map_or_else(Vec::new, |ruler| ruler.marks.map(place).to_vec()),
        lengths: ruler.map_or_else(Vec::new, |ruler| vec![ruler.typed.clone()]),
        intervals: 1,
        scale,
        origin: arguments.origin.map(place),
        zero: Some(place(film.upright(calibration.origin))),
        ends: [clock.frames.first().copied()?, clock.frames.last().copied()?],
        found: Some(FoundInFilm {
            factor: Some(Number(clock.factor)),
            frames: clock
                .frames
                .iter()
                .map(|&frame| Some((frame, Number(*clock.times.get(frame)?))))
                .collect::<Option<_>>()?,
            repeated: Vec::new(),
            tracks: followed.tracks.iter().map(|one| track(film, one)).collect(),
        }),
        ..format::Film::default()
    })
}

fn track(film: &Opened, track: &Track) -> TrackInFilm {
    let turned = matches!(film.rotation, Rotation::Quarter | Rotation::ThreeQuarters);
    let direction = |[x, y]: [f64; 2]| {
        let ([a, b], [c, d]) = (film.upright([x, y]), film.upright([0.0; 2]));
        [a - c, b - d]
    };
    let point = |point: &Point| {
        let ([x, y], [p, q]) = (film.upright(point.position), point.sigma);
        let [p, q] = if turned { [q, p] } else { [p, q] };
        (point.frame, [point.time, x, y, p, q, point.score].map(Number), point.doubtful)
    };
    TrackInFilm {
        direction: track.direction.map(direction).map(place),
        exposure: track.exposure.map(|exposure| match exposure {
            Exposure::Seconds(seconds) => (Number(seconds), false),
            Exposure::Under(seconds) => (Number(seconds), true),
        }),
        readout: track.readout.map(|readout| place([readout.seconds, readout.sigma])),
        lost: track.lost,
        outline: track.outline.map(|outline| {
            let [x, y] = direction(outline.offset);
            [x, y, outline.radius].map(Number)
        }),
        shift: track.shift.map(|shift| Number(shift.pixels)),
        points: track.points.iter().map(point).collect(),
    }
}
