//! From pixels to tracks.

use super::arguments::Track as Arguments;
use super::clock::Clock;
use super::decoding::Decoding;
use super::opened::{Opened, refused};
use crate::failure::Failure;
use film::Plane;
use film::timing::repeats;
use film::tracking::body::{self, Body};
use film::tracking::column::{Click, Column, Settings};
use film::tracking::{Known, Marks, Refusal, Similarity, Track};
use indicatif::ProgressBar;
use units::{Words, words};

/// Half the width of the strip around a tube, as a part of the height of the upright picture.
const HALF_WIDTH: f64 = 1.0 / 16.0;
/// Pixels of two pictures that are compared at most.
const COMPARED: usize = 20_000;

/// What was found in a film, in pixels of the stored picture.
#[derive(Debug)]
pub struct Followed {
    /// A track for each click.
    pub tracks: Vec<Track>,
    /// What a person should know.
    pub notes: Vec<Words>,
}

/// What is followed.
enum Target {
    Column(Box<Column>),
    Body(Box<Body>),
}

/// Tracks what was clicked. Frames that repeat the picture before are left out in a second pass: their times are wrong.
pub fn follow(film: &Opened, clock: &Clock, arguments: &Arguments, bar: &ProgressBar) -> Result<Followed, Failure> {
    let first = Pass::run(film, clock, arguments, &clock.frames, bar)?;
    let repeated = repeats(&first.differences);
    if repeated.is_empty() {
        return Ok(Followed { tracks: first.tracks()?, notes: Vec::new() });
    }
    // Its strips take memory that the second pass needs.
    drop(first);
    let kept = clock.frames.iter().enumerate().filter(|(at, _)| repeated.binary_search(at).is_err());
    let kept: Vec<usize> = kept.map(|(_, frame)| *frame).collect();
    let (count, of) = (repeated.len(), clock.frames.len());
    let note = words!(
        "{count} of {of} frames repeat the picture before and are left out: the film was converted to another rate; use the original one if you have it",
        "{count} de {of} fotogramas repiten la imagen anterior y se excluyen: el vídeo se convirtió a otra frecuencia; usa el original si lo tienes"
    );
    Ok(Followed { tracks: Pass::run(film, clock, arguments, &kept, bar)?.tracks()?, notes: vec![note] })
}

/// One reading of the film.
struct Pass<'a> {
    film: &'a Opened,
    targets: Vec<Target>,
    marks: Marks,
    /// The mean absolute difference of each two successive pictures.
    differences: Vec<f64>,
}

impl<'a> Pass<'a> {
    fn run(
        film: &'a Opened,
        clock: &Clock,
        arguments: &Arguments,
        frames: &[usize],
        bar: &ProgressBar,
    ) -> Result<Self, Failure> {
        let refusal = |refusal: Refusal| refused(&film.path, refusal.words());
        let first = frames.first().copied().unwrap_or(0);
        let count = frames.last().map_or(0, |last| last + 1);
        let marks = arguments.marks.iter().flat_map(|marks| &marks.0).map(|mark| film.stored(*mark)).collect();
        let mut pass = Self {
            film,
            targets: targets(film, arguments, first),
            marks: Marks::new(marks).map_err(refusal)?,
            differences: Vec::new(),
        };
        let whole = count == film.times.len();
        let mut decoding = Decoding::begin(film, if whole { None } else { Some(count) })?;
        let mut last: Option<Plane> = None;
        let mut wanted = frames.iter().peekable();
        bar.set_length(count as u64);
        for frame in 0..count {
            let Some(plane) = decoding.next()? else {
                let why = words!(
                    "the file lists {count} frames, and only {frame} could be decoded, so that their times are not certain; copy the film again, or end before the damage with --until",
                    "el archivo enumera {count} fotogramas y solo se pudieron decodificar {frame}, de modo que sus tiempos no son seguros; copia de nuevo el vídeo o termina antes del daño con --until"
                );
                return Err(decoding.failure(film, why));
            };
            bar.set_position(frame as u64 + 1);
            if wanted.next_if_eq(&&frame).is_none() {
                continue;
            }
            let time = clock.times.get(frame).copied().unwrap_or(f64::NAN);
            pass.take(frame, time, &plane).map_err(refusal)?;
            pass.differences.extend(last.as_ref().map(|last| difference(last, &plane)));
            last = Some(plane);
        }
        let mut further = 0_usize;
        while whole && decoding.next()?.is_some() {
            further += 1;
        }
        if further > 0 {
            let decoded = count + further;
            let why = words!(
                "the file lists {count} frames, and {decoded} were decoded; which times belong to them is not certain",
                "el archivo enumera {count} fotogramas y se decodificaron {decoded}; no es seguro qué tiempos les corresponden"
            );
            return Err(decoding.failure(film, why));
        }
        Ok(pass)
    }

    fn take(&mut self, frame: usize, time: f64, plane: &Plane) -> Result<(), Refusal> {
        let camera: Similarity = self.marks.take(frame, plane)?;
        for target in &mut self.targets {
            match target {
                Target::Column(column) => column.take(frame, time, plane, camera)?,
                Target::Body(body) => drop(body.take(frame, time, plane, camera)?),
            }
        }
        Ok(())
    }

    fn tracks(self) -> Result<Vec<Track>, Failure> {
        let film = self.film;
        let track = |target: Target| match target {
            Target::Column(mut column) => column.finish().map_err(|refusal| refused(&film.path, refusal.words())),
            Target::Body(mut body) => Ok(body.finish()),
        };
        self.targets.into_iter().map(track).collect()
    }
}

fn targets(film: &Opened, arguments: &Arguments, frame: usize) -> Vec<Target> {
    let click = |point: [f64; 2]| Click { frame, position: film.stored(point) };
    let [_, high] = film.upright_size();
    let known = |given: Option<super::arguments::Given>| given.map_or(Known::Estimated, |given| given.0);
    let column = |(at, surface): (usize, &[f64; 2])| {
        let upright = [[surface[0], 0.5], [surface[0], high - 0.5]];
        let tube = arguments.tube.get(at).copied().unwrap_or(upright).map(|point| film.stored(point));
        Target::Column(Box::new(Column::new(Settings {
            tube: Some(tube),
            half_width: Some(HALF_WIDTH * high),
            exposure: known(arguments.exposure),
            readout: known(arguments.readout),
            ..Settings::new(click(*surface))
        })))
    };
    let body = |body: &super::arguments::Body| {
        let keys = vec![click(body.position)];
        Target::Body(Box::new(Body::new(body::Settings {
            keys,
            radius: body.radius,
            readout: known(arguments.readout),
        })))
    };
    arguments.surface.iter().enumerate().map(column).chain(arguments.body.iter().map(body)).collect()
}

/// The mean absolute difference of two pictures, by some of their pixels.
fn difference(one: &Plane, other: &Plane) -> f64 {
    let step = (one.grey().len() / COMPARED).max(1);
    let pairs = one.grey().iter().zip(other.grey()).step_by(step);
    let (sum, count) = pairs.fold((0_u64, 0_u64), |(sum, count), (a, b)| (sum + u64::from(a.abs_diff(*b)), count + 1));
    sum as f64 / count.max(1) as f64
}
