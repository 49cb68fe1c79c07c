//! Pictures of a film: a frame with the marks of the calibration, and space-time pictures, both with the tracked and
//! the fitted curves.

use super::{FilmPicture, FilmView};
use film::tracking::Track;
use film::tracking::column::SpaceTimePicture;

/// Width of a drawing, in pixels.
const WIDTH: f64 = 720.0;
/// Maximum height of a space-time picture.
const HIGHEST: f64 = 320.0;
/// Maximum height of a frame.
const HIGHEST_FRAME: f64 = 480.0;
/// Maximum number of pixels of a picture. With half a byte each, all pictures of a film together take less than 200 kB.
const MOST_PIXELS: f64 = 80_000.0;

/// A curve: frame number and point in pixels.
type Curve = [(usize, [f64; 2])];

/// A frame and the curves over it, in pixels of the upright picture.
pub struct Frame<'a> {
    /// Index of the frame from 0.
    pub number: usize,
    /// Width and height of the picture.
    pub size: [f64; 2],
    /// Grey value at a point, from 0 to 255.
    pub grey: &'a dyn Fn([f64; 2]) -> f64,
    /// Tracks.
    pub tracks: &'a [Track],
    /// Fitted curves: frame number and point.
    pub fitted: &'a [Vec<(usize, [f64; 2])>],
    /// Marks of the calibration: a line between two or more points, or a single point.
    pub marks: &'a [Vec<[f64; 2]>],
}

impl FilmPicture {
    /// Picture of a frame with the marks of the calibration and the curves.
    pub fn frame(frame: &Frame<'_>) -> Self {
        let [width, height] = frame.size;
        let scale = (WIDTH / width).min(HIGHEST_FRAME / height);
        let shrink = (width * height / MOST_PIXELS).sqrt().max(1.0);
        let pixels = [width, height].map(|side| ((side / shrink) as usize).max(1));
        let drawn = |point: &[f64; 2]| point.map(|part| part * scale);
        let path = |track: &Track| track.points.iter().map(|point| drawn(&point.position)).collect();
        let curve = |curve: &Vec<(usize, [f64; 2])>| curve.iter().map(|(_, point)| drawn(point)).collect();
        Self {
            view: FilmView::Frame(frame.number),
            pixels,
            grey: averaged(pixels, frame.size, frame.grey),
            size: [width * scale, height * scale],
            tracked: frame.tracks.iter().map(path).collect(),
            fitted: frame.fitted.iter().filter(|curve| !curve.is_empty()).map(curve).collect(),
            marks: frame.marks.iter().map(|line| line.iter().map(drawn).collect()).collect(),
        }
    }

    /// Space-time picture with the track and the fitted curve, which may be empty. Points of both are in pixels of the
    /// upright picture.
    pub fn space_time(picture: &SpaceTimePicture, track: &Track, fitted: &Curve) -> Self {
        let size = [picture.frames.len().max(1) as f64, picture.rows.max(1) as f64];
        let drawing = [WIDTH, (WIDTH * size[1] / size[0]).clamp(160.0, HIGHEST)];
        let shrink = (size[0] * size[1] / MOST_PIXELS).sqrt().max(1.0);
        let pixels = size.map(|side| ((side / shrink) as usize).max(1));
        let columns = picture.frames.len();
        let value = |[x, y]: [f64; 2]| {
            let row = (y as usize).min(picture.rows.saturating_sub(1));
            let at = row * columns + (x as usize).min(columns.saturating_sub(1));
            f64::from(picture.grey.get(at).copied().unwrap_or(0))
        };
        let drawn = |(frame, point): (usize, [f64; 2])| {
            let column = picture.column_of(frame)? as f64;
            let row = picture.row_of(point);
            Some([(column + 0.5) / size[0] * drawing[0], (row + 0.5) / size[1] * drawing[1]])
        };
        let fitted: Vec<[f64; 2]> = fitted.iter().copied().filter_map(drawn).collect();
        Self {
            view: FilmView::SpaceTime,
            pixels,
            grey: averaged(pixels, size, &value),
            size: drawing,
            tracked: vec![track.points.iter().filter_map(|point| drawn((point.frame, point.position))).collect()],
            fitted: if fitted.is_empty() { Vec::new() } else { vec![fitted] },
            marks: Vec::new(),
        }
    }
}

/// Reduced picture of `pixels` columns and rows. Each pixel is the mean of nine points of the original, whose width and
/// height are given second.
fn averaged([columns, rows]: [usize; 2], [width, height]: [f64; 2], value: &dyn Fn([f64; 2]) -> f64) -> Vec<u8> {
    let [across, down] = [width / columns as f64, height / rows as f64];
    let mut grey = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        for column in 0..columns {
            let points = (0..9).map(|k| {
                let [u, v] = [k % 3, k / 3].map(|part| (f64::from(part) + 0.5) / 3.0);
                value([(column as f64 + u) * across, (row as f64 + v) * down])
            });
            grey.push((points.sum::<f64>() / 9.0).round() as u8);
        }
    }
    grey
}
