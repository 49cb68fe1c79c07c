//! Tracking of a film from the command line.

use super::arguments::{Body, Given, Place, Track as Arguments};
use super::clock::Clock;
use super::decoding::Decoding;
use super::opened::{Opened, refused, refused_with};
use crate::failure::Failure;
use film::timing::displayed;
use film::tracking::body;
use film::tracking::column::{Click, Settings, SpaceTimePicture};
use film::tracking::{Following, Known, Plan, Refusal, Surface, Track};
use film::{Plane, capacity};
use indicatif::ProgressBar;
use units::{Words, words};

/// Half the width of the strip around a tube, relative to the height of the upright picture.
pub const HALF_WIDTH: f64 = 1.0 / 16.0;

/// Result of tracking, in px of the stored picture.
#[derive(Debug)]
pub struct Followed {
    /// One track per surface or body.
    pub tracks: Vec<Track>,
    /// Notes for the user.
    pub notes: Vec<Words>,
    /// Number and picture of the first tracked frame.
    pub still: Option<(usize, Plane)>,
    /// Space-time picture of each surface.
    pub pictures: Vec<SpaceTimePicture>,
}

/// Tracks the clicked objects. Repeated frames, whose times are wrong, are left out in a second pass.
pub fn follow(film: &Opened, clock: &Clock, arguments: &Arguments, bar: &ProgressBar) -> Result<Followed, Failure> {
    let refusal = |refusal: Refusal| refused(&film.path, refusal.words());
    let plan = plan(film, clock, arguments)?;
    capacity::check(&plan, film.size).map_err(|refusal| too_long(film, clock, &refusal))?;
    let mut following = Following::new(plan).map_err(refusal)?;
    let mut still = None;
    while following.wanted().is_some() {
        // Surfaces need no colours.
        read(film, &mut following, &mut still, (bar, !arguments.body.is_empty()))?;
    }
    following.advance(usize::MAX).map_err(refusal)?;
    let (count, of) = (following.repeated().len(), clock.frames.len());
    let note = words!(
        "{count} of {of} frames repeat the picture before and are left out: their times are wrong; use the original one if you have it"
    );
    let notes = if count > 0 { vec![note] } else { Vec::new() };
    let frames: Vec<usize> = following.frames().iter().map(|frame| frame.0).collect();
    let picture = |surface| Some(SpaceTimePicture::new(&following.space_time(surface)?, frames.clone()));
    let pictures = (0..).map_while(picture).collect();
    Ok(Followed { tracks: following.tracks(), notes, still, pictures })
}

/// Failure for a film with too many frames for the memory, with the latest possible end as hint.
fn too_long(film: &Opened, clock: &Clock, refusal: &Refusal) -> Failure {
    let last = match refusal {
        Refusal::Long { frames } => clock.frames.get(frames.saturating_sub(1)),
        _ => None,
    };
    let Some(time) = last.and_then(|frame| film.times.get(*frame)) else {
        return refused(&film.path, refusal.words());
    };
    let count = clock.frames.len();
    let hint = words!(
        "the part has {count} frames; end it with --until {until}, and track the rest from there with --from",
        count = Words::same(count.to_string()),
        until = Words::same(displayed(*time).english())
    );
    refused_with(&film.path, refusal.words(), hint)
}

/// Reads the film once and passes the requested frames on. Keeps the first of them.
fn read(
    film: &Opened,
    following: &mut Following,
    still: &mut Option<(usize, Plane)>,
    (bar, coloured): (&ProgressBar, bool),
) -> Result<(), Failure> {
    let count = following.frames().last().map_or(0, |last| last.0 + 1);
    let whole = count == film.times.len() && !film.cut;
    let mut decoding = Decoding::begin(film, if whole { None } else { Some(count) }, coloured)?;
    bar.set_length(count as u64);
    for frame in 0..count {
        let Some(plane) = decoding.next()? else {
            if frame == 0 {
                let why = words!(
                    "none of its {count} frames could be decoded, which are coded in {coding}",
                    count = Words::same(count.to_string()),
                    coding = Words::same(film.coding.clone())
                );
                return Err(decoding.failure(film, why));
            }
            let why = words!(
                "the file lists {count} frames, and only {frame} could be decoded, so that their times are not certain; copy the film again, or end before the damage with --until"
            );
            return Err(decoding.failure(film, why));
        };
        bar.set_position(frame as u64 + 1);
        if following.wanted() == Some(frame) {
            still.get_or_insert_with(|| (frame, plane.clone().uncoloured()));
            following.take(plane).map_err(|refusal| refused(&film.path, refusal.words()))?;
        }
    }
    let mut further = 0_usize;
    while whole && decoding.next()?.is_some() {
        further += 1;
    }
    if further > 0 {
        let decoded = count + further;
        let why = words!(
            "the file lists {count} frames, and {decoded} were decoded; which times belong to them is not certain"
        );
        return Err(decoding.failure(film, why));
    }
    Ok(())
}

fn plan(film: &Opened, clock: &Clock, arguments: &Arguments) -> Result<Plan, Failure> {
    let [_, high] = film.upright_size();
    let known = |given: Option<Given>| given.map_or(Known::Estimated, |given| given.0);
    let clicks = |places: &[Place]| -> Result<Vec<Click>, Failure> {
        let click =
            |place: &Place| Ok(Click { frame: clock.frame_of(film, place)?, position: film.stored(place.position) });
        places.iter().map(click).collect()
    };
    let mut surfaces = Vec::new();
    for (at, surface) in arguments.surface.iter().enumerate() {
        let clicks = clicks(&surface.places)?;
        let (Some(first), Some((click, anchors))) = (surface.places.first(), clicks.split_first()) else { continue };
        let [x, _] = first.position;
        let tube = arguments.tube.get(at).copied().unwrap_or([[x, 0.5], [x, high - 0.5]]);
        let settings = Settings {
            tube: Some(tube.map(|point| film.stored(point))),
            half_width: Some(HALF_WIDTH * high),
            exposure: known(arguments.exposure),
            readout: known(arguments.readout),
            ..Settings::new(*click)
        };
        surfaces.push(Surface { settings, anchors: anchors.to_vec() });
    }
    let body = |body: &Body| {
        let keys = clicks(&body.places)?;
        Ok(body::Settings { keys, radius: body.radius, readout: known(arguments.readout) })
    };
    let time = |frame: &usize| (*frame, clock.times.get(*frame).copied().unwrap_or(f64::NAN));
    Ok(Plan {
        surfaces,
        bodies: arguments.body.iter().map(body).collect::<Result<_, Failure>>()?,
        marks: arguments.marks.iter().flat_map(|marks| &marks.0).map(|mark| film.stored(*mark)).collect(),
        frames: clock.frames.iter().map(time).collect(),
    })
}
