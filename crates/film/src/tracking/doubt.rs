//! Frames that the user should check.

use super::loss::LossReason;
use super::track::{Point, Track};
use units::order::{median, sort_by_key};
use units::{Words, words};

/// Correlation below which a doubtful frame does not show what was clicked.
const SCORE: f64 = 0.6;
/// Ratio of a standard error to the median of its track from which it is large.
const LARGE: f64 = 4.0;

/// Distance of the centres of two bodies, relative to the larger radius, below which both tracks may follow one of them.
const SHARED: f64 = 0.5;
/// Reciprocal of the fraction of doubtful frames from which a track is unreliable.
const MANY: usize = 10;

/// Reason for the doubt about a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doubt {
    /// The body was not found from this frame on; the reason is `None` if it is found again later.
    Lost(Option<LossReason>),
    /// The picture hardly resembles what was clicked.
    Score,
    /// The standard error is much larger than the median.
    Error,
    /// The position does not agree with its neighbours.
    Deviation,
}

/// Doubtful frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DoubtfulFrame {
    /// Frame number.
    pub frame: usize,
    /// Index of the track.
    pub track: usize,
    /// Reason.
    pub doubt: Doubt,
}

impl Doubt {
    /// Name in JSON.
    pub fn code(self) -> &'static str {
        match self {
            Self::Lost(_) => "lost",
            Self::Score => "score",
            Self::Error => "error",
            Self::Deviation => "deviation",
        }
    }

    /// Short description.
    pub fn words(self) -> Words {
        match self {
            Self::Lost(None) => words("lost from here on, and found again later"),
            Self::Lost(Some(reason)) => words!("lost from here on: {reason}", reason = reason.words()),
            Self::Score => words("hardly resembles what was clicked"),
            Self::Error => words("large standard error"),
            Self::Deviation => words("does not follow from the frames around it"),
        }
    }
}

/// True if a track was lost, or more than a tenth of its points are doubtful.
pub fn is_plainly_in_doubt(tracks: &[Track]) -> bool {
    let many = |own: &Track| {
        let doubtful = own.points.iter().filter(|point| point.doubtful).count();
        own.lost.is_some() || MANY * doubtful > own.points.len()
    };
    tracks.iter().any(many)
}

/// Puts the frames in doubt in which two bodies are so near to one another that both tracks may follow one of them.
pub(super) fn doubt_shared(tracks: &mut [Track]) {
    for one in 0..tracks.len() {
        for other in 0..one {
            for (at, beside) in shared(&tracks[one], &tracks[other]) {
                tracks[one].points[at].doubtful = true;
                tracks[other].points[beside].doubtful = true;
            }
        }
    }
}

/// Indices of the points of two bodies in the same frame that are nearer to one another than a part of the larger radius.
fn shared(one: &Track, other: &Track) -> Vec<(usize, usize)> {
    let Some((outline, beside)) = one.outline.zip(other.outline) else { return Vec::new() };
    let limit = SHARED * outline.radius.max(beside.radius);
    let distance = |point: &Point, at: &Point| {
        let apart: [f64; 2] =
            std::array::from_fn(|k| point.position[k] + outline.offset[k] - at.position[k] - beside.offset[k]);
        libm::hypot(apart[0], apart[1])
    };
    let pairs = one.points.iter().enumerate().filter_map(|(index, point)| {
        let at = other.points.binary_search_by_key(&point.frame, |at| at.frame).ok()?;
        (distance(point, &other.points[at]) < limit).then_some((index, at))
    });
    pairs.collect()
}

/// First frame without a body that is lost before its path ends: it is not found again and has not left the picture.
pub fn lost_from(doubts: &[DoubtfulFrame]) -> Option<usize> {
    let is_early = |one: &&DoubtfulFrame| matches!(one.doubt, Doubt::Lost(Some(reason)) if reason != LossReason::Left);
    doubts.iter().find(is_early).map(|one| one.frame)
}

/// Doubtful frames of some tracks in an upright picture of `size` px, ordered by frame and track.
pub fn doubts(tracks: &[Track], size: [f64; 2]) -> Vec<DoubtfulFrame> {
    let mut found = Vec::new();
    for (track, own) in tracks.iter().enumerate() {
        let length = |sigma: [f64; 2]| libm::hypot(sigma[0], sigma[1]);
        let usual = median(own.points.iter().map(|point| length(point.sigma)).collect());
        let why = |point: &Point| {
            if point.doubtful && point.score < SCORE {
                Some(Doubt::Score)
            } else if length(point.sigma) > LARGE * usual {
                Some(Doubt::Error)
            } else {
                point.doubtful.then_some(Doubt::Deviation)
            }
        };
        let doubtful = own.points.iter().filter_map(|point| Some((point.frame, why(point)?)));
        let lost = own.lost.map(|frame| (frame, Doubt::Lost(own.loss(size).map(|loss| loss.reason))));
        found.extend(doubtful.chain(lost).map(|(frame, doubt)| DoubtfulFrame { frame, track, doubt }));
    }
    sort_by_key(&mut found, |one| (one.frame, one.track));
    found
}

#[cfg(test)]
mod tests {
    use super::super::track::Outline;
    use super::*;

    /// Track of a body of radius 10 px that moves by so many px a frame from a place to the right, clicked beside its centre.
    fn track(from: f64, step: f64, beside: f64) -> Track {
        let point = |frame: usize| Point {
            frame,
            time: frame as f64 / 30.0,
            position: [from + step * frame as f64 + beside, 80.0],
            sigma: [0.1; 2],
            score: 0.9,
            doubtful: false,
        };
        let outline = Some(Outline { offset: [-beside, 0.0], radius: 10.0 });
        Track { points: (0..21).map(point).collect(), outline, ..Track::default() }
    }

    #[test]
    fn two_tracks_at_one_place_are_both_in_doubt() {
        // The first two pass one another in frame 10, and the last one is elsewhere.
        let mut tracks = [track(100.0, 2.0, 3.0), track(140.0, -2.0, -4.0), track(300.0, 0.0, 0.0)];
        tracks[1].points.remove(9);
        doubt_shared(&mut tracks);
        let frames = |track: &Track| -> Vec<usize> {
            track.points.iter().filter(|point| point.doubtful).map(|point| point.frame).collect()
        };
        assert_eq!(tracks.each_ref().map(frames), [vec![10, 11], vec![10, 11], vec![]]);
        // A surface has no outline.
        let mut tracks = [track(100.0, 0.0, 0.0), Track { outline: None, ..track(100.0, 0.0, 0.0) }];
        doubt_shared(&mut tracks);
        assert!(tracks.iter().flat_map(|track| &track.points).all(|point| !point.doubtful));
    }
}
