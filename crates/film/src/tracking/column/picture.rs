//! Space-time picture of a surface: the strips of all frames side by side.

use crate::tracking::column::SpaceTime;

/// Space-time picture of a surface, for display: time to the right, the tube downwards.
#[derive(Clone, Debug, PartialEq)]
pub struct SpaceTimePicture {
    /// Frame number of each column.
    pub frames: Vec<usize>,
    /// Number of columns already read; the others are black.
    pub read: usize,
    /// Number of rows, one per px along the tube.
    pub rows: usize,
    /// Grey values, row by row, one per frame.
    pub grey: Vec<u8>,
    /// Position of the first row in the film, px.
    pub origin: [f64; 2],
    /// Unit vector along the tube, from one row to the next.
    pub direction: [f64; 2],
    /// Edges of the bore, as distances from the axis in px.
    pub bore: [f64; 2],
}

impl SpaceTimePicture {
    /// Picture with the frames in this order. Positions in px of the stored picture.
    pub fn new(picture: &SpaceTime, frames: Vec<usize>) -> Self {
        let rows = picture.columns.iter().map(Vec::len).min().unwrap_or(0);
        let count = frames.len();
        let grey =
            |row: usize, at: usize| picture.columns.get(at).and_then(|column| column.get(row)).copied().unwrap_or(0);
        let value = |row: usize| (0..count).map(move |at| grey(row, at));
        Self {
            frames,
            read: picture.columns.len().min(count),
            rows,
            grey: (0..rows).flat_map(value).collect(),
            origin: picture.origin,
            direction: picture.direction,
            bore: picture.bore,
        }
    }

    /// Row of a point in px; the centre of a row is a whole number.
    pub fn row_of(&self, [x, y]: [f64; 2]) -> f64 {
        (x - self.origin[0]) * self.direction[0] + (y - self.origin[1]) * self.direction[1]
    }

    /// Position of a row in px.
    pub fn position(&self, row: f64) -> [f64; 2] {
        [self.origin[0] + row * self.direction[0], self.origin[1] + row * self.direction[1]]
    }

    /// Column of a frame; `None` if the frame was left out.
    pub fn column_of(&self, frame: usize) -> Option<usize> {
        self.frames.binary_search(&frame).ok()
    }
}
