//! Frames that the user should check.

use film::tracking::Track;
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
    /// The body was not found from this frame on.
    Lost,
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
    /// Short description.
    pub fn words(self) -> Words {
        match self {
            Self::Lost => words("lost from here on"),
            Self::Score => words("hardly resembles what was clicked"),
            Self::Error => words("large standard error"),
            Self::Deviation => words("does not follow from the frames around it"),
        }
    }
}

/// True if a track was lost, or more than a tenth of its points are doubtful.
pub(crate) fn plainly(tracks: &[Track]) -> bool {
    let many = |own: &Track| {
        let doubtful = own.points.iter().filter(|point| point.doubtful).count();
        own.lost.is_some() || MANY * doubtful > own.points.len()
    };
    tracks.iter().any(many)
}

/// Doubtful frames of some tracks, ordered by frame and track.
pub(crate) fn doubts(tracks: &[Track]) -> Vec<DoubtfulFrame> {
    let mut found = Vec::new();
    for (track, own) in tracks.iter().enumerate() {
        let size = |sigma: [f64; 2]| libm::hypot(sigma[0], sigma[1]);
        let usual = median(own.points.iter().map(|point| size(point.sigma)).collect());
        let why = |point: &film::tracking::Point| {
            if point.doubtful && point.score < SCORE {
                Some(Doubt::Score)
            } else if size(point.sigma) > LARGE * usual {
                Some(Doubt::Error)
            } else {
                point.doubtful.then_some(Doubt::Deviation)
            }
        };
        let doubtful = own.points.iter().filter_map(|point| Some((point.frame, why(point)?)));
        let lost = own.lost.map(|frame| (frame, Doubt::Lost));
        found.extend(doubtful.chain(lost).map(|(frame, doubt)| DoubtfulFrame { frame, track, doubt }));
    }
    sort_by_key(&mut found, |one| (one.frame, one.track));
    found
}
