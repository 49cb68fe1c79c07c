//! Opening of a film: its description without pixels.

use crate::failure::Failure;
use film::calibration::Rotation;
use film::containers::{Film, FilmError, MOST_SAMPLES, Notice, Opening};
use film::y4m;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use units::{Words, words};

/// Signature of a Y4M film.
const Y4M: &[u8] = b"YUV4MPEG2";
/// Number of bytes read at once.
const CHUNK: usize = 1 << 20;

/// Description of a film by its file.
#[derive(Debug)]
pub struct Opened {
    /// Path of the file.
    pub path: PathBuf,
    /// Size of the file in bytes.
    pub bytes: u64,
    /// Name of the coding.
    pub coding: String,
    /// Source of the pixels.
    pub pixels: Pixels,
    /// Width and height of the stored picture, square px.
    pub size: [usize; 2],
    /// Rotation to the upright picture.
    pub rotation: Rotation,
    /// True if left and right of the stored picture are exchanged.
    pub mirrored: bool,
    /// Presentation time of each frame, s.
    pub times: Vec<f64>,
    /// Frames per second, if the file states them independently of the times.
    pub stated_rate: Option<f64>,
    /// Frames per second at recording, if the file states them.
    pub capture_rate: Option<f64>,
    /// True if the file is cut off or damaged. `ffmpeg` may then decode more frames than are complete.
    pub cut: bool,
    /// Notes on the file for the user.
    pub notes: Vec<Words>,
}

/// Source of the pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pixels {
    /// Uncompressed grey values in the file.
    Plain,
    /// Decoding by `ffmpeg`.
    Coded,
}

impl Opened {
    /// Opens a film of any supported format.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        let failure = |error: std::io::Error| Failure::file("read", path, &error);
        let mut file = File::open(path).map_err(failure)?;
        let metadata = file.metadata().map_err(failure)?;
        if metadata.is_dir() {
            return Err(refused(path, words("it is a folder")));
        }
        let mut start = Vec::new();
        Read::by_ref(&mut file).take(Y4M.len() as u64).read_to_end(&mut start).map_err(failure)?;
        file.rewind().map_err(failure)?;
        let bytes = metadata.len();
        if start == Y4M { Self::plain(path, file, bytes) } else { Self::coded(path, file, bytes) }
    }

    fn coded(path: &Path, mut file: File, bytes: u64) -> Result<Self, Failure> {
        let failure = |error: std::io::Error| Failure::file("read", path, &error);
        let mut opening = Opening::new(bytes);
        let film = loop {
            match opening {
                Opening::Done(result) => break result.map_err(|error| refused(path, error.words()))?,
                Opening::Needs(request) => {
                    let range = request.range();
                    let mut part = Vec::new();
                    file.seek(SeekFrom::Start(range.start)).map_err(failure)?;
                    let wanted = range.end - range.start;
                    Read::by_ref(&mut file).take(wanted).read_to_end(&mut part).map_err(failure)?;
                    opening = request.supply(part);
                }
            }
        };
        Ok(Self::of(path, &film, bytes))
    }

    fn of(path: &Path, film: &Film, bytes: u64) -> Self {
        let upright = film.display_size();
        let stored = film.orientation.upright_size(upright);
        let rotation = match film.orientation.quarter_turns % 4 {
            0 => Rotation::None,
            1 => Rotation::Quarter,
            2 => Rotation::Half,
            _ => Rotation::ThreeQuarters,
        };
        let mut notes: Vec<Words> = film.notices.iter().map(Notice::words).collect();
        let ([width, height], coding) = (upright.map(f64::round), film.codec.label().to_owned());
        notes.insert(0, words!("{coding}, {width} x {height} pixels"));
        Self {
            path: path.to_owned(),
            bytes,
            coding,
            pixels: Pixels::Coded,
            size: stored.map(|side| side.round() as usize),
            rotation,
            mirrored: film.orientation.mirrored,
            times: film.times(),
            stated_rate: film.stated_rate,
            capture_rate: film.capture_rate,
            cut: film.notices.iter().any(|notice| matches!(notice, Notice::Truncated { .. } | Notice::Broken { .. })),
            notes,
        }
    }

    /// Opens a Y4M film. Its frames are counted by reading it once.
    fn plain(path: &Path, file: File, bytes: u64) -> Result<Self, Failure> {
        let mut frames = Frames::new(path.to_owned(), file);
        let mut count = 0_usize;
        while frames.next()?.is_some() {
            count += 1;
            if count > MOST_SAMPLES {
                return Err(refused(path, FilmError::TooLarge.words()));
            }
        }
        let Some(header) = frames.reader.header() else {
            return Err(refused(path, y4m::Fault::Signature.words()));
        };
        let Some(rate) = header.rate else {
            return Err(refused(
                path,
                words("its header states no frame rate; convert the film again with one, as `ffmpeg -r 30` does"),
            ));
        };
        if count == 0 {
            return Err(refused(path, FilmError::NoFrames.words()));
        }
        let (width, height) = (header.width, header.height);
        Ok(Self {
            path: path.to_owned(),
            bytes,
            coding: "Y4M".to_owned(),
            pixels: Pixels::Plain,
            size: [width, height],
            rotation: Rotation::None,
            mirrored: false,
            // The format has no times, only a rate.
            times: (0..count).map(|frame| frame as f64 / rate).collect(),
            stated_rate: None,
            capture_rate: None,
            cut: false,
            notes: vec![words!("Y4M, {width} x {height} pixels")],
        })
    }

    /// Width and height of the upright picture, px.
    pub fn upright_size(&self) -> [f64; 2] {
        let [width, height] = self.stored_size();
        match self.rotation {
            Rotation::None | Rotation::Half => [width, height],
            Rotation::Quarter | Rotation::ThreeQuarters => [height, width],
        }
    }

    /// Maps a point of the upright picture to the stored one, px.
    pub fn stored(&self, point: [f64; 2]) -> [f64; 2] {
        self.rotation.undo(point, self.stored_size())
    }

    /// Maps a point of the stored picture to the upright one, px.
    pub fn upright(&self, point: [f64; 2]) -> [f64; 2] {
        self.rotation.apply(point, self.stored_size())
    }

    fn stored_size(&self) -> [f64; 2] {
        self.size.map(|side| side as f64)
    }
}

/// Frames of a Y4M stream.
pub struct Frames<R> {
    path: PathBuf,
    source: R,
    reader: y4m::Reader,
    bytes: Vec<u8>,
    /// Number of bytes already used.
    used: usize,
}

impl<R: Read> Frames<R> {
    /// Reader before the first frame. `path` is used in messages.
    pub fn new(path: PathBuf, source: R) -> Self {
        Self { path, source, reader: y4m::Reader::default(), bytes: Vec::new(), used: 0 }
    }

    /// Next frame; `None` at the end.
    pub fn next(&mut self) -> Result<Option<film::Plane>, Failure> {
        loop {
            let mut rest = self.bytes.get(self.used..).unwrap_or_default();
            let frame = self.reader.frame(&mut rest).map_err(|fault| refused(&self.path, fault.words()))?;
            self.used = self.bytes.len() - rest.len();
            if frame.is_some() {
                return Ok(frame);
            }
            self.bytes.resize(CHUNK, 0);
            let read = self.source.read(&mut self.bytes).map_err(|error| Failure::file("read", &self.path, &error))?;
            self.bytes.truncate(read);
            self.used = 0;
            if read == 0 {
                return Ok(None);
            }
        }
    }
}

/// Failure of a film with the reason.
pub fn refused(path: &Path, why: Words) -> Failure {
    Failure::Request { message: named(path, why), hint: None }
}

/// Failure of a film with the reason and a hint.
pub fn refused_with(path: &Path, why: Words, hint: Words) -> Failure {
    Failure::in_words(named(path, why), hint)
}

fn named(path: &Path, why: Words) -> Words {
    let name = Words::same(path.display().to_string());
    words!("{name}: {why}")
}
