//! Frames that the user should check.

use super::loss::LossReason;
use super::track::{Point, Track};
use units::order::{median, sort_by_key};
use units::{Words, words};

/// Correlation below which a doubtful frame does not show what was clicked.
const SCORE: f64 = 0.6;
/// Ratio of a standard error to the median of its track from which it is large.
const LARGE: f64 = 4.0;

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
