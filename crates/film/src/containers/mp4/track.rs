//! Video track of a movie: headers and frame tables (ISO/IEC 14496-12, 8.3 and 8.4).

use super::super::FilmError;
use super::super::bytes::Bytes;
use super::super::film::Orientation;
use super::boxes::{find, follow, version_and_flags};
use super::edits::{Edit, edits};
use super::entry::{Entry, entry};
use super::table;

/// Properties of a track before its frames are read.
#[derive(Debug)]
pub(super) struct Track<'a> {
    pub(super) id: u32,
    /// Ticks per second.
    pub(super) timescale: u32,
    /// `None` for a skewed picture or an angle that is not a multiple of 90 degrees.
    pub(super) orientation: Option<Orientation>,
    pub(super) edits: Vec<Edit>,
    /// Content of `stbl`.
    pub(super) tables: &'a [u8],
    /// Number of frames in the tables.
    pub(super) count: usize,
    /// Coding of the frames, or the reason why it cannot be read.
    pub(super) entry: Result<Entry, FilmError>,
}

impl<'a> Track<'a> {
    /// Reads the content of `trak`; `None` if it is not a video track.
    pub(super) fn read(content: &'a [u8]) -> Option<Result<Self, FilmError>> {
        let media = find(content, b"mdia")?;
        let handler = find(media, b"hdlr")?.get(8..12)?;
        (handler == b"vide").then(|| Self::read_video(content, media))
    }

    fn read_video(content: &'a [u8], media: &'a [u8]) -> Result<Self, FilmError> {
        let damaged = |part| FilmError::Damaged { part };
        let (id, orientation) = find(content, b"tkhd").and_then(header).ok_or(damaged("tkhd"))?;
        let timescale = find(media, b"mdhd").and_then(times).map(|times| times.timescale).ok_or(damaged("mdhd"))?;
        let tables = follow(media, &[b"minf", b"stbl"]).ok_or(damaged("stbl"))?;
        let entry = find(tables, b"stsd").ok_or(damaged("stsd")).and_then(entry);
        let edits = follow(content, &[b"edts", b"elst"]).map(edits).transpose()?.unwrap_or_default();
        Ok(Self { id, timescale, orientation, edits, tables, count: table::count(tables), entry })
    }
}

/// Times in a header.
pub(super) struct Times {
    /// Seconds since 1904-01-01; 0 if unknown.
    pub(super) created: u64,
    pub(super) timescale: u32,
    /// Duration in ticks; 0 if unknown.
    pub(super) duration: u64,
}

/// Reads the content of `mvhd` or `mdhd`. `None` also for a time scale of 0.
pub(super) fn times(content: &[u8]) -> Option<Times> {
    let mut bytes = Bytes(content);
    let times = if version_and_flags(&mut bytes)?.0 == 1 {
        let created = bytes.u64()?;
        bytes.take(8)?;
        Times { created, timescale: bytes.u32()?, duration: bytes.u64().filter(|&duration| duration < u64::MAX)? }
    } else {
        let created = bytes.u32()?.into();
        bytes.take(4)?;
        let timescale = bytes.u32()?;
        Times {
            created,
            timescale,
            duration: bytes.u32().map(|ticks| if ticks == u32::MAX { 0 } else { ticks.into() })?,
        }
    };
    (times.timescale > 0).then_some(times)
}

/// Track number and orientation from the content of `tkhd`.
fn header(content: &[u8]) -> Option<(u32, Option<Orientation>)> {
    let mut bytes = Bytes(content);
    let version = version_and_flags(&mut bytes)?.0;
    bytes.take(if version == 1 { 16 } else { 8 })?;
    let id = bytes.u32()?;
    bytes.take(if version == 1 { 12 } else { 8 })?;
    bytes.take(16)?;
    let mut matrix = [0; 9];
    for element in &mut matrix {
        *element = bytes.i32()?;
    }
    Some((id, orientation(matrix)))
}

/// Orientation of the matrix `a b u, c d v, x y w`, which maps (x, y) to (a x + c y, b x + d y). `None` for other
/// angles than multiples of 90 degrees.
fn orientation([a, b, _, c, d, ..]: [i32; 9]) -> Option<Orientation> {
    let largest = [a, b, c, d].iter().map(|element| element.unsigned_abs()).max().unwrap_or(0);
    // 1/100 corresponds to an angle of half a degree.
    let sign = |element: i32| if element.unsigned_abs() <= largest / 100 { 0 } else { element.signum() };
    let (quarter_turns, mirrored) = match [a, b, c, d].map(sign) {
        [0, 0, 0, 0] | [1, 0, 0, 1] => (0, false),
        [0, 1, -1, 0] => (1, false),
        [-1, 0, 0, -1] => (2, false),
        [0, -1, 1, 0] => (3, false),
        [-1, 0, 0, 1] => (0, true),
        [0, -1, -1, 0] => (1, true),
        [1, 0, 0, -1] => (2, true),
        [0, 1, 1, 0] => (3, true),
        _ => return None,
    };
    Some(Orientation { quarter_turns, mirrored })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The matrix takes the corners of a picture to where `Orientation::upright` has them, apart from a shift.
    #[test]
    fn the_matrix_and_the_orientation_agree() {
        let one = 1 << 16;
        for [a, b, c, d] in [
            [one, 0, 0, one],
            [0, one, -one, 0],
            [-one, 0, 0, -one],
            [0, -one, one, 0],
            [-one, 0, 0, one],
            [0, -one, -one, 0],
            [one, 0, 0, -one],
            [0, one, one, 0],
        ] {
            let orientation = orientation([a, b, 0, c, d, 0, 0, 0, 1 << 30]).unwrap();
            let at = |point| orientation.upright(point, [640.0, 360.0]);
            let origin = at([0.0, 0.0]);
            let moved = |point| [at(point)[0] - origin[0], at(point)[1] - origin[1]];
            assert_eq!(moved([1.0, 0.0]), [f64::from(a / one), f64::from(b / one)]);
            assert_eq!(moved([0.0, 1.0]), [f64::from(c / one), f64::from(d / one)]);
            let size = orientation.upright_size([640.0, 360.0]);
            let inside = at([10.0, 20.0]);
            assert!((0..2).all(|axis| inside[axis] > 0.0 && inside[axis] < size[axis]), "{orientation:?}");
        }
        assert_eq!(orientation([one, one, 0, -one, one, 0, 0, 0, 1 << 30]), None);
    }
}
