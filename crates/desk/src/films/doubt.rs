//! Frames that a person should look at.

use film::tracking::Track;
use units::{Words, words};

/// Below this correlation a frame does not show what was clicked.
const SCORE: f64 = 0.6;
/// A standard error is large above so many times the median of its track.
const LARGE: f64 = 4.0;

/// One of so many frames in doubt is many.
const MANY: usize = 10;

/// Why a frame is in doubt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Doubt {
    /// From this frame on the body was not found.
    Lost,
    /// The picture hardly resembles what was clicked.
    Score,
    /// The standard error is much larger than usual.
    Error,
    /// The position does not follow from those before and after it.
    Deviation,
}

/// A frame in doubt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DoubtfulFrame {
    /// The frame.
    pub frame: usize,
    /// Of what is followed, from 0.
    pub track: usize,
    /// Why.
    pub doubt: Doubt,
}

impl Doubt {
    /// It in a few words.
    pub fn words(self) -> Words {
        match self {
            Self::Lost => words("lost from here on", "perdido desde aquí"),
            Self::Score => words("hardly resembles what was clicked", "apenas se parece a lo elegido"),
            Self::Error => words("large standard error", "error estándar grande"),
            Self::Deviation => {
                words("does not follow from the frames around it", "no concuerda con los fotogramas vecinos")
            }
        }
    }
}

/// True if a track was lost, or a part of its frames is in doubt that no single look mends.
pub(crate) fn plainly(tracks: &[Track]) -> bool {
    let many = |own: &Track| {
        let doubtful = own.points.iter().filter(|point| point.doubtful).count();
        own.lost.is_some() || MANY * doubtful > own.points.len()
    };
    tracks.iter().any(many)
}

/// The frames in doubt of some tracks, in order.
pub(crate) fn doubts(tracks: &[Track]) -> Vec<DoubtfulFrame> {
    let mut found = Vec::new();
    for (track, own) in tracks.iter().enumerate() {
        let size = |sigma: [f64; 2]| libm::hypot(sigma[0], sigma[1]);
        let mut sizes: Vec<f64> = own.points.iter().map(|point| size(point.sigma)).collect();
        sizes.sort_by(f64::total_cmp);
        let usual = sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
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
    found.sort_by_key(|one| (one.frame, one.track));
    found
}
