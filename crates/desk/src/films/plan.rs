//! Conversion of clicks to a tracking plan, and of its result to the upright picture.

use crate::films::clip::Clip;
use crate::films::subject::{FilmedBody, FilmedSurface, Subject};
use crate::films::work::{Found, Work};
use film::tracking::column::{self, Click, SpaceTimePicture};
use film::tracking::{Following, Known, Outline, Plan, Point, Surface, Track, body};
use units::order::sort_by;
use units::{Words, words};

/// Half the width of the strip around a tube, relative to the height of the upright picture.
const HALF_WIDTH: f64 = 1.0 / 16.0;

/// Tracking plan in px of the stored picture.
pub(crate) fn plan(clip: &Clip, work: &Work) -> Plan {
    let [_, high] = clip.size();
    let surface = |own: &FilmedSurface| {
        let [x, _] = own.click.position;
        // The first row of the space-time picture is the upper end of the tube.
        let mut tube = own.tube.unwrap_or([[x, 0.5], [x, high - 0.5]]);
        sort_by(&mut tube, |one, other| one[1].total_cmp(&other[1]));
        let settings = column::Settings {
            tube: Some(tube.map(|point| clip.stored(point))),
            half_width: Some(HALF_WIDTH * high),
            ..column::Settings::new(stored(clip, &own.click))
        };
        Surface { settings, anchors: own.anchors.iter().map(|anchor| stored(clip, anchor)).collect() }
    };
    let body = |own: &FilmedBody| body::Settings {
        keys: own.keys.iter().map(|key| stored(clip, key)).collect(),
        radius: own.radius,
        readout: Known::Estimated,
    };
    let (surfaces, bodies) = match &work.subject {
        Subject::Surfaces(surfaces) => (surfaces.iter().map(surface).collect(), Vec::new()),
        Subject::Bodies(bodies) => (Vec::new(), bodies.iter().map(body).collect()),
        Subject::Nothing | Subject::Points { .. } => (Vec::new(), Vec::new()),
    };
    let marks = work.marks.iter().map(|mark| clip.stored(*mark)).collect();
    Plan { surfaces, bodies, marks, frames: frames(clip, work) }
}

/// Frames of the used part with their recording times, s. Of frames with equal times, the first is kept.
fn frames(clip: &Clip, work: &Work) -> Vec<(usize, f64)> {
    let [first, last] = work.ends;
    let times = clip.times().iter().enumerate().skip(first).take((last + 1).saturating_sub(first));
    let times = times.filter(|(frame, _)| clip.doubled().binary_search(frame).is_err());
    times.map(|(frame, time)| (frame, time / work.factor())).collect()
}

pub(crate) fn stored(clip: &Clip, click: &Click) -> Click {
    Click { frame: click.frame, position: clip.stored(click.position) }
}

/// Result of tracking in px of the upright picture. Positions are rounded to 1e-5 px, far below any error, to save
/// space.
pub(crate) fn found(following: &Following, clip: &Clip, factor: f64) -> Found {
    let fine = |value: f64| (value * 1e5).round() / 1e5;
    let point = |point: &Point| Point {
        position: clip.upright(point.position).map(fine),
        sigma: clip.upright_sigma(point.sigma).map(fine),
        score: (point.score * 1e3).round() / 1e3,
        ..*point
    };
    let track = |track: Track| Track {
        points: track.points.iter().map(point).collect(),
        direction: track.direction.map(|direction| clip.upright_direction(direction)),
        outline: track.outline.map(|outline| Outline { offset: clip.upright_direction(outline.offset), ..outline }),
        ..track
    };
    Found {
        tracks: following.tracks().into_iter().map(track).collect(),
        frames: following.frames().to_vec(),
        factor,
        repeated: following.repeated().to_vec(),
    }
}

pub(crate) fn pictures(following: &Following, clip: &Clip) -> Vec<SpaceTimePicture> {
    let frames: Vec<usize> = following.frames().iter().map(|frame| frame.0).collect();
    let picture = |surface| {
        let picture = SpaceTimePicture::new(&following.space_time(surface)?, frames.clone());
        let (origin, direction) = (clip.upright(picture.origin), clip.upright_direction(picture.direction));
        Some(SpaceTimePicture { origin, direction, ..picture })
    };
    (0..).map_while(picture).collect()
}

/// Track of points clicked by hand. `sigma`: standard error of each coordinate, px.
pub(crate) fn by_hand(clicks: &[Click], sigma: f64, clip: &Clip, factor: f64) -> Found {
    let frames: Vec<(usize, f64)> =
        clicks.iter().filter_map(|click| Some((click.frame, clip.times().get(click.frame)? / factor))).collect();
    let point = |(click, (frame, time)): (&Click, &(usize, f64))| Point {
        frame: *frame,
        time: *time,
        position: click.position,
        sigma: [sigma; 2],
        score: 1.0,
        doubtful: false,
    };
    let points = clicks.iter().zip(&frames).map(point).collect();
    Found { tracks: vec![Track { points, ..Track::default() }], frames, factor, repeated: Vec::new() }
}

pub(crate) fn nothing_followed() -> Words {
    words("Nothing is followed yet. Click the surface of a liquid or a body.")
}
