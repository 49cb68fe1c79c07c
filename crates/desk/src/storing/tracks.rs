//! Conversion between tracks of a film and stored numbers.

use saved::Number;
use saved::format::{FoundInFilm, TrackInFilm};

use super::place::{factor, place, point};
use crate::films::work::Found;
use film::tracking::{CameraShift, Exposure, Outline, Point, Readout, Track};

pub(super) fn saved(found: &Found) -> FoundInFilm {
    FoundInFilm {
        factor: Some(Number(found.factor)),
        frames: found.frames.iter().map(|&(frame, time)| (frame, Number(time))).collect(),
        repeated: found.repeated.clone(),
        tracks: found.tracks.iter().map(saved_track).collect(),
    }
}

fn saved_track(track: &Track) -> TrackInFilm {
    let saved = |point: &Point| {
        let ([x, y], [p, q]) = (point.position, point.sigma);
        (point.frame, [point.time, x, y, p, q, point.score].map(Number), point.doubtful)
    };
    TrackInFilm {
        direction: track.direction.map(place),
        exposure: track.exposure.map(|exposure| match exposure {
            Exposure::Seconds(seconds) => (Number(seconds), false),
            Exposure::Under(seconds) => (Number(seconds), true),
        }),
        readout: track.readout.map(|readout| place([readout.seconds, readout.sigma])),
        lost: track.lost,
        outline: track.outline.map(|Outline { offset: [x, y], radius }| [x, y, radius].map(Number)),
        shift: track.shift.map(|shift| Number(shift.pixels)),
        points: track.points.iter().map(saved).collect(),
    }
}

/// The tracks; `None` if frames are out of order, or a number is not finite.
pub(super) fn restored(saved: &FoundInFilm) -> Option<Found> {
    let frames: Vec<(usize, f64)> = saved.frames.iter().map(|&(frame, Number(time))| (frame, time)).collect();
    let in_order = frames.is_sorted_by(|one, other| one.0 < other.0) && frames.iter().all(|one| one.1.is_finite());
    let tracks: Vec<Track> = saved.tracks.iter().map(restored_track).collect::<Option<_>>()?;
    let factor = saved.factor.and_then(factor)?;
    in_order.then(|| Found { tracks, frames, factor, repeated: saved.repeated.clone() })
}

fn restored_track(saved: &TrackInFilm) -> Option<Track> {
    let points: Vec<Point> = saved
        .points
        .iter()
        .map(|(frame, numbers, doubtful)| {
            let [time, x, y, p, q, score] = numbers.map(|Number(number)| number);
            Point { frame: *frame, time, position: [x, y], sigma: [p, q], score, doubtful: *doubtful }
        })
        .collect();
    let finite = saved.points.iter().all(|one| one.1.iter().all(|Number(number)| number.is_finite()));
    let in_order = points.is_sorted_by(|one, other| one.frame < other.frame);
    (finite && in_order).then(|| Track {
        points,
        exposure: saved.exposure.map(|(Number(seconds), under)| match under {
            true => Exposure::Under(seconds),
            false => Exposure::Seconds(seconds),
        }),
        readout: saved.readout.map(point).map(|[seconds, sigma]| Readout { seconds, sigma }),
        direction: saved.direction.map(point),
        lost: saved.lost,
        outline: saved.outline.map(|numbers| numbers.map(|Number(number)| number)).and_then(outline),
        shift: saved.shift.map(|Number(pixels)| CameraShift { pixels }),
    })
}

/// The outline; `None` if it is none of a body.
fn outline([x, y, radius]: [f64; 3]) -> Option<Outline> {
    (x.is_finite() && y.is_finite() && radius.is_finite() && radius > 0.0).then_some(Outline { offset: [x, y], radius })
}
