//! The truth of a filmed simulation, and how far a track is from it.

use film::calibration::{Calibration, Lengths};
use film::tracking::{Point, Track};

/// What the virtual camera knows: where the moving parts of the scene were.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FilmTruth {
    /// Metres in a pixel; `None` where the scene has no scale.
    pub pixel: Option<f64>,
    /// The length of the ruler that stands beside the scene, for people.
    pub ruler: Option<String>,
    /// The middle of each moving part in each frame, at the middle of its exposure: pixels of the picture. Not a number where it
    /// is not seen.
    pub parts: Vec<Vec<[f64; 2]>>,
}

/// How far a track is from the truth.
#[derive(Clone, Debug, PartialEq)]
pub struct TruthComparison {
    /// The root mean square of the differences in pixels, without their mean: a click decides which point of a part is followed.
    pub rms: f64,
    /// The same in metres.
    pub metres: Option<f64>,
    /// How much larger lengths of the record are than the true ones, as a part of them; `None` without a scale.
    pub scale_error: Option<f64>,
    /// Found minus true in each frame, without the mean: along a tube, else to the right and down; pixels.
    pub differences: Vec<(usize, [f64; 2])>,
    /// Where the point that was clicked truly was in each frame, in pixels.
    pub path: Vec<(usize, [f64; 2])>,
}

/// How far some tracks are from the truth, calibrated like this.
pub(crate) fn compared(tracks: &[Track], truth: &FilmTruth, calibration: &Calibration) -> Vec<TruthComparison> {
    let scale_error = match (&calibration.lengths, truth.pixel) {
        (Lengths::Scale(scale), Some(pixel)) => {
            let parallax = calibration.parallax.map_or(1.0, |parallax| parallax.factor());
            Some(scale.pixel * parallax / pixel - 1.0)
        }
        _ => None,
    };
    let compare = |track: &Track| {
        let Nearest { rms, part, offset } = nearest(track, &truth.parts)?;
        let differences = pairs(track, part).map(|(point, at)| (point.frame, difference(track, point, at, offset)));
        let path = pairs(track, part).map(|(point, at)| (point.frame, [at[0] + offset[0], at[1] + offset[1]]));
        let metres = truth.pixel.map(|pixel| rms * pixel);
        Some(TruthComparison { rms, metres, scale_error, differences: differences.collect(), path: path.collect() })
    };
    tracks.iter().filter_map(compare).collect()
}

/// The points of a track with the place of a part in the same frame.
fn pairs<'a>(track: &'a Track, part: &'a [[f64; 2]]) -> impl Iterator<Item = (&'a Point, [f64; 2])> {
    let place = |point: &'a Point| Some((point, *part.get(point.frame)?));
    track.points.iter().filter_map(place).filter(|(_, at)| at.iter().all(|one| one.is_finite()))
}

/// Found minus true, less the offset: along the tube of a surface, else to the right and down.
fn difference(track: &Track, point: &Point, at: [f64; 2], offset: [f64; 2]) -> [f64; 2] {
    let [x, y] = [0, 1].map(|k| point.position[k] - at[k] - offset[k]);
    track.direction.map_or([x, y], |[along, down]| [x * along + y * down, 0.0])
}

/// The part that moves most like a track.
struct Nearest<'a> {
    /// The root mean square of the differences, without their mean.
    rms: f64,
    part: &'a [[f64; 2]],
    /// The mean of found minus true.
    offset: [f64; 2],
}

/// The part with the least differences.
fn nearest<'a>(track: &Track, parts: &'a [Vec<[f64; 2]>]) -> Option<Nearest<'a>> {
    let fit = |part: &'a Vec<[f64; 2]>| {
        let count = pairs(track, part).count();
        // A part that is not seen for some time is another one.
        if count < 2 || 2 * count < track.points.len() {
            return None;
        }
        let mean =
            [0, 1].map(|k| pairs(track, part).map(|(point, at)| point.position[k] - at[k]).sum::<f64>() / count as f64);
        let squares = pairs(track, part).map(|(point, at)| difference(track, point, at, mean));
        let sum: f64 = squares.map(|[x, y]| x * x + y * y).sum();
        Some(Nearest { rms: (sum / count as f64).sqrt(), part, offset: mean })
    };
    parts.iter().filter_map(fit).min_by(|one, other| one.rms.total_cmp(&other.rms))
}
