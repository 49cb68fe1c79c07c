//! True positions in a filmed simulation, and their comparison with tracks.

use film::calibration::{Calibration, Lengths};
use film::tracking::{Point, Track};

/// True positions of the moving parts of the scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FilmTruth {
    /// Size of a pixel, m; `None` if the scene has no scale.
    pub pixel: Option<f64>,
    /// Length of the ruler drawn beside the scene, as text.
    pub ruler: Option<String>,
    /// Position in px of the middle of each moving part in each frame, at the middle of its exposure; NaN if it is not
    /// visible.
    pub parts: Vec<Vec<[f64; 2]>>,
}

/// Comparison of a track with the truth.
#[derive(Clone, Debug, PartialEq)]
pub struct TruthComparison {
    /// Root mean square of the differences minus their mean, px. The mean depends on which point was clicked.
    pub rms: f64,
    /// Root mean square in m; `None` without a scale of the scene.
    pub metres: Option<f64>,
    /// Relative error of lengths in the record; `None` without a scale.
    pub scale_error: Option<f64>,
    /// Measured minus true position in each frame, minus the mean, px: along a tube, else to the right and down.
    pub differences: Vec<(usize, [f64; 2])>,
    /// True position of the clicked point in each frame, px.
    pub path: Vec<(usize, [f64; 2])>,
}

/// Comparison of some tracks with the truth.
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

/// Points of a track with the position of a part in the same frame.
fn pairs<'a>(track: &'a Track, part: &'a [[f64; 2]]) -> impl Iterator<Item = (&'a Point, [f64; 2])> {
    let place = |point: &'a Point| Some((point, *part.get(point.frame)?));
    track.points.iter().filter_map(place).filter(|(_, at)| at.iter().all(|one| one.is_finite()))
}

/// Measured minus true position, minus the offset, px: along the tube of a surface, else to the right and down.
fn difference(track: &Track, point: &Point, at: [f64; 2], offset: [f64; 2]) -> [f64; 2] {
    let [x, y] = [0, 1].map(|k| point.position[k] - at[k] - offset[k]);
    track.direction.map_or([x, y], |[along, down]| [x * along + y * down, 0.0])
}

/// Part whose motion is nearest to that of a track.
struct Nearest<'a> {
    /// Root mean square of the differences minus their mean, px.
    rms: f64,
    part: &'a [[f64; 2]],
    /// Mean of measured minus true position, px.
    offset: [f64; 2],
}

/// Part with the smallest differences.
fn nearest<'a>(track: &Track, parts: &'a [Vec<[f64; 2]>]) -> Option<Nearest<'a>> {
    let fit = |part: &'a Vec<[f64; 2]>| {
        let count = pairs(track, part).count();
        // A part that is invisible in more than half of the frames is not the tracked one.
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
